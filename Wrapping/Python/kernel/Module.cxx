// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Module.h"

#include "Errors.h"
#include "ThreadPool.h"

namespace
{
constexpr const char* Documentation =
  R"(Geodesic distances and their uses on arrays of NumPy, without VTK.

A `Surface` is prepared once. Functions take it as their first argument, and results own their
memory. The arguments of functions are the properties of the filters of vtkDGG, in words that are
joined by underscores, with the same defaults. None stands for the default. Lengths are in the unit
of the points, and angles in radians unless another unit is stated.

Surface points
    Integers are ids of points. Floats of shape (3,) or (n, 3) are coordinates, which are moved to
    the closest point of the surface. A dict may have ids ("ids"), coordinates ("points"), or cell
    ids ("cells") with barycentric coordinates ("barycentric", shape (n, 3)); "original_ids" name
    the points of the surface at coordinates. Ids come before all others.
projection_tolerance : float
    Largest distance of coordinates from the surface, as a fraction of the diagonal of its bounding
    box.

All functions also have these arguments:

memory_limit : int
    Largest number of bytes that the call may take. Default, and 0: 70 % of the memory that is free.
number_of_threads : int
    Default: see `set_number_of_threads`. The results are the same for any number.
progress : callable
    Called with the finished fraction, about a hundred times per second, on the calling thread. An
    exception stops the call and is passed on, like the KeyboardInterrupt of Ctrl-C.

Other Python threads run during calls. Results are types.SimpleNamespace objects with these
attributes:

points : shape (n, 3)
    Without rows if the points are those of the surface.
cells : dict of tuples (offsets, ids)
    "verts", "lines" and "polygons", which are numbered in this order.
point_data, cell_data, field_data : dict of arrays
    Arrays with the names that the filters use.
active : dict
    Names of the active arrays of "points" and "cells", or None.
origins : dict or None
    "points" and "weights", shape (n, 3): points of the surface from which values at the points are
    interpolated; if the second id is -1, those of the first are copied. "cells": cells of the
    surface.
warnings : list of str)";
}

PYBIND11_MODULE(_kernel, module)
{
  module.doc() = Documentation;
  dggPython::AddErrors(module);
  dggPython::AddSurface(module);
  dggPython::AddDistances(module);
  dggPython::AddGraph(module);
  dggPython::AddCurves(module);
  dggPython::AddRegions(module);
  dggPython::AddFields(module);
  dggPython::AddSpectral(module);
  dggPython::AddEarthMovers(module);
  dggPython::AddVectorGraphics(module);
  dggPython::AddPatchLayout(module);
  dggPython::AddFormats(module);
#ifdef DGG_HAS_CLOUDS
  dggPython::AddCloudGraph(module);
#endif
  module.def("set_number_of_threads", &dggPython::SetDefaultNumberOfThreads, pybind11::arg("count"),
    "Sets the number of threads of calls that do not choose one. Default: the number of processors "
    "that the process may use.");
  module.def("get_number_of_threads", &dggPython::GetDefaultNumberOfThreads,
    "Returns the number of threads of calls that do not choose one.");
  const pybind11::module_ os = pybind11::module_::import("os");
  if (pybind11::hasattr(os, "register_at_fork"))
  {
    os.attr("register_at_fork")(
      pybind11::arg("after_in_child") = pybind11::cpp_function(&dggPython::ReplaceThreadPool));
  }
}
