// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Arrays.h"
#include "Call.h"
#include "Distances.h"
#include "Module.h"
#include "Outputs.h"
#include "SurfacePoints.h"

#include "dggOutput.h"
#include "dggPatchOutput.h"

namespace dggPython
{
namespace
{
constexpr const char* PatchDocumentation =
  R"(Curves between landmarks that divide two surfaces alike.

Parameters
----------
first, second : Surface
first_landmarks, second_landmarks : surface points
    Landmarks of the two surfaces that correspond.
patches : array_like of int, shape (m, k), or tuple (offsets, ids), optional
    Indices of the landmarks around each patch.
edges : array_like of int, shape (m, 2), or tuple (offsets, ids), optional
    Indices of landmarks that are joined by curves, in addition to the sides of patches.
projection_tolerance, memory_limit, number_of_threads, progress
    See the module.

Returns
-------
tuple of two SimpleNamespace
    Lines on each surface with the cell data "LayoutEdge" and "Length" and the point data
    "ArcFraction".

Raises
------
Error
    For an invalid landmark, and a layout that is invalid or cannot be drawn.

References
----------
E. Praun, W. Sweldens, P. Schroeder, "Consistent mesh parameterizations", SIGGRAPH 2001.)";

/// Draws a layout on two surfaces.
dgg::Status TracePatches(const dgg::TaskContext (&contexts)[2], const SurfacePoints (&given)[2],
  const dgg::CellArrays& patches, const dgg::CellArrays& edges, dgg::Output* outputs)
{
  dgg::PatchLayout layout;
  DGG_RETURN_IF_ERROR(dgg::ReadPatchLayout(patches, edges, layout));
  std::vector<dgg::SurfacePoint> landmarks[2];
  for (int side = 0; side < 2; ++side)
  {
    DGG_RETURN_IF_ERROR(RequireSurface(contexts[side].Surface, "Patch layouts"));
    DGG_RETURN_IF_ERROR(given[side].Locate(contexts[side], landmarks[side]));
  }
  dgg::PatchBoundaries boundaries;
  DGG_RETURN_IF_ERROR(dgg::TracePatchBoundaries({ contexts[0].Surface.GetMesh(), landmarks[0] },
    { contexts[1].Surface.GetMesh(), landmarks[1] }, layout, contexts[0].Progress, boundaries));
  for (int side = 0; side < 2; ++side)
  {
    dgg::WritePatchBoundaries(contexts[side], boundaries, side, outputs[side]);
  }
  return dgg::Status::Success();
}

py::object FindPatchBoundaries(const Surface& first, const Surface& second,
  const py::object& firstLandmarks, const py::object& secondLandmarks, const py::object& patches,
  const py::object& edges, const py::kwargs& keywords)
{
  Arguments arguments(keywords);
  Call call(arguments);
  SurfacePoints landmarks[] = { { firstLandmarks, "first landmark", "FirstLandmarks" },
    { secondLandmarks, "second landmark", "SecondLandmarks" } };
  landmarks[0].GetCollection().Surface = "first surface";
  landmarks[1].GetCollection().Surface = "second surface";
  landmarks[0].ReadTolerance(arguments);
  landmarks[1].ReadTolerance(arguments);
  const Cells polygons(patches, "patches");
  const Cells lines(edges, "edges");
  dgg::Output outputs[2];
  call.Run([&] {
    return TracePatches({ call.MakeContext(first), call.MakeContext(second) }, landmarks,
      polygons.Get(), lines.Get(), outputs);
  });
  return py::make_tuple(ToPython(outputs[0]), ToPython(outputs[1]));
}
}

//------------------------------------------------------------------------------
void AddPatchLayout(py::module_& module)
{
  module.def("patch_boundaries", &FindPatchBoundaries, py::arg("first"), py::arg("second"),
    py::arg("first_landmarks"), py::arg("second_landmarks"), py::arg("patches") = py::none(),
    py::arg("edges") = py::none(), PatchDocumentation);
}
}
