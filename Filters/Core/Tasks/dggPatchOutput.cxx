// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPatchOutput.h"

#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggSurfaceOutput.h"

#include <cstddef>
#include <limits>

namespace dgg
{
namespace
{
std::vector<Id> ReadCell(const CellArrays& cells, Offset cell)
{
  std::vector<Id> landmarks;
  for (Offset i = cells.Offsets[cell]; i < cells.Offsets[cell + 1]; ++i)
  {
    const Offset id = cells.Ids[i];
    landmarks.push_back(
      id >= 0 && id <= std::numeric_limits<Id>::max() ? static_cast<Id>(id) : NoId);
  }
  return landmarks;
}
}

//------------------------------------------------------------------------------
Status ReadPatchLayout(const CellArrays& polygons, const CellArrays& lines, PatchLayout& layout)
{
  DGG_RETURN_IF_ERROR(polygons.CheckOffsets("the layout"));
  DGG_RETURN_IF_ERROR(lines.CheckOffsets("the layout"));
  for (Offset c = 0; c < polygons.NumberOfCells; ++c)
  {
    layout.Patches.push_back(ReadCell(polygons, c));
  }
  for (Offset c = 0; c < lines.NumberOfCells; ++c)
  {
    const std::vector<Id> line = ReadCell(lines, c);
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      layout.Edges.push_back({ { line[i], line[i + 1] } });
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
void WritePatchBoundaries(
  const TaskContext& context, const PatchBoundaries& boundaries, int side, Output& output)
{
  const std::vector<SurfacePath>& paths = boundaries.Curves[side];
  std::vector<OutputCurve> curves;
  for (const SurfacePath& path : paths)
  {
    curves.push_back({ &path });
  }
  const double* const arcLengths = WriteCurves(context, curves, output);
  double* const fractions = output.PointData.Add<double>("ArcFraction", output.Points.Size() / 3);
  Offset* const edges = output.CellData.Add<Offset>("LayoutEdge", paths.size(), 2);
  double* const lengths = output.CellData.Add<double>("Length", paths.size());
  for (std::size_t c = 0; c < paths.size(); ++c)
  {
    edges[2 * c] = boundaries.Edges[c][0];
    edges[2 * c + 1] = boundaries.Edges[c][1];
    lengths[c] = paths[c].Length;
    const Offset last = output.Lines.Points[output.Lines.Offsets[c + 1] - 1];
    for (Offset i = output.Lines.Offsets[c]; i < output.Lines.Offsets[c + 1]; ++i)
    {
      const Offset point = output.Lines.Points[i];
      fractions[point] = point == last ? 1.0 : arcLengths[point] / arcLengths[last];
    }
  }
}
}
