// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFieldReader.h"

#include "dggBlockLoop.h"
#include "dggCounted.h"
#include "dggFaceEnvelope.h"
#include "dggInputArray.h"
#include "dggMeshQuality.h"
#include "dggPreparedSurface.h"
#include "dggSourceFinding.h"
#include "dggStatus.h"
#include "dggSurfacePoint.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dgg
{
namespace
{
/// Largest mean difference, relative to the mean edge length, between distances and the sums of
/// offset and length of virtual sources. Virtual sources beyond this limit belong to other
/// distances. Estimates of graphs may differ by the accuracy of the graph.
constexpr double LargestDifference = 0.1;
/// Distances change along an edge by at most its length; approximate distances may exceed the
/// length along a few edges.
constexpr double SteepestSlope = 1.1;
constexpr double LargestShareOfSteepEdges = 0.1;

/// Number of points that a thread probes as a block.
constexpr std::size_t BlockSize = 1024;

/// Returns the reason why values cannot be distances in the units of the points; empty if they may
/// be.
std::string FindFault(const SurfaceMesh& mesh, const std::vector<double>& values)
{
  Id known = 0;
  Id steep = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const double change = std::abs(values[mesh.Destination(h)] - values[mesh.Origin(h)]);
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) && std::isfinite(change))
    {
      ++known;
      steep += change > SteepestSlope * mesh.Length(h) ? 1 : 0;
    }
  }
  if (known == 0)
  {
    return "The field is not known at any two neighboring points. Pass finite values";
  }
  const double share = static_cast<double>(steep) / known;
  if (share <= LargestShareOfSteepEdges)
  {
    return "";
  }
  return JoinText("The field changes by more than the length of the edge along ",
    std::lround(100.0 * share), " % of the edges. Pass distances in the units of the points");
}

/// Returns the distance at a surface point; NaN if unreached. On an edge this is the smallest
/// distance of its reached faces, as for isolines: a shortest path may come through any of them.
double Probe(const DistanceField& field, const SurfacePoint& place, FaceEnvelope& envelope)
{
  double distance = Infinity;
  if (place.On == SurfacePoint::Support::Vertex)
  {
    distance = field.Distances[place.Vertex];
  }
  else
  {
    ForEachFaceAround(*field.Mesh, place, [&](Id f, const std::array<double, 3>& barycentric) {
      if (field.IsReached(f))
      {
        envelope.Enter(f);
        distance = std::min(distance, envelope.At(envelope.PlaceOf(barycentric)));
      }
    });
  }
  return distance < Infinity ? distance : std::numeric_limits<double>::quiet_NaN();
}
}

//------------------------------------------------------------------------------
FieldReader::FieldReader(const PreparedSurface& surface)
  : Surface(surface)
{
}

//------------------------------------------------------------------------------
Status FieldReader::SetDistances(
  const InputArray& distances, double unreachedValue, const InputArray& marks)
{
  const bool areMarked = std::isnan(unreachedValue) && marks.Fits(distances.NumberOfTuples, 1);
  const double unreached =
    distances.AreFloats ? static_cast<double>(static_cast<float>(unreachedValue)) : unreachedValue;
  this->Distances.assign(distances.Values.size(), Infinity);
  for (std::size_t i = 0; i < this->Distances.size(); ++i)
  {
    const double distance = distances.Values[i];
    if (distance == unreached || (areMarked && marks.Values[i] != 0.0))
    {
      continue;
    }
    if (distance == -Infinity)
    {
      return InvalidInput("The distance of point ", i, " is minus infinity")
        .At("DistanceArrayName", static_cast<Offset>(i))
        .Fix("Use NaN, infinity or the {UnreachedValue} for unreached points");
    }
    // The first of several points at a vertex has the id of the vertex.
    if (!std::isnan(distance) &&
      this->Surface.GetVertex(static_cast<Offset>(i)) == static_cast<Id>(i))
    {
      this->Distances[i] = distance;
    }
  }
  this->Field = { &this->Surface.GetMesh(), this->Distances.data(), &this->Windows,
    &this->Sources };
  return Status::Success();
}

//------------------------------------------------------------------------------
void FieldReader::SetSources(const InputArray& sources)
{
  const auto size = static_cast<Offset>(this->Distances.size());
  if (this->Field.HasWindows())
  {
    return;
  }
  if (!sources.Fits(size, 3))
  {
    if (sources.AreNumbers)
    {
      this->Warn(JoinText("The point array '", sources.Name, "' has ",
        Counted(sources.NumberOfComponents, "component"), " and ",
        Counted(sources.NumberOfTuples, "tuple"), ", but virtual sources need 3 components and ",
        Counted(size, "tuple"), ". The array is ignored"));
    }
    return;
  }
  for (Offset v = 0; v < size; ++v)
  {
    this->Sources.push_back({ sources.Get(v, 0), sources.Get(v, 1), sources.Get(v, 2) });
  }
  if (!this->HasSourcesOfDistances())
  {
    this->Sources.clear();
    this->Warn("The virtual sources in the point array '" + sources.Name +
      "' give other distances than the array of distances on this surface: they belong to other "
      "sources or another mesh, or are invalid. They are ignored");
  }
}

//------------------------------------------------------------------------------
Status FieldReader::Complete(const TaskContext& context, const ProgressCallback& progress)
{
  const SurfaceMesh& mesh = this->Surface.GetMesh();
  if (this->Field.HasWindows() || this->Field.HasSources())
  {
    return Status::Success();
  }
  const std::string fault = FindFault(mesh, this->Distances);
  if (!fault.empty())
  {
    this->Warn(fault + ". The field is interpolated linearly in each triangle");
    return Status::Success();
  }
  this->IsFitted = true;
  return FitVirtualSources(mesh, this->Distances.data(), context.Parallel, this->Sources, progress);
}

//------------------------------------------------------------------------------
std::array<double, 2> FieldReader::FindRange() const
{
  std::array<double, 2> range{ { Infinity, -Infinity } };
  for (const double distance : this->Distances)
  {
    range[0] = std::min(range[0], distance);
    range[1] = distance < Infinity ? std::max(range[1], distance) : range[1];
  }
  return range;
}

//------------------------------------------------------------------------------
std::string FieldReader::DescribeQuality() const
{
  return this->Field.HasSources() ? DescribeLongTriangles(this->Surface, LongTrianglesHideSources)
                                  : std::string();
}

//------------------------------------------------------------------------------
/// Returns true if the virtual sources give the distances.
bool FieldReader::HasSourcesOfDistances() const
{
  double difference = 0.0;
  double reached = 0.0;
  for (std::size_t v = 0; v < this->Distances.size(); ++v)
  {
    if (!(this->Distances[v] < Infinity))
    {
      continue;
    }
    const VirtualSource& source = this->Sources[v];
    if (!std::isfinite(source.Angle) || !(source.Length >= 0.0))
    {
      return false;
    }
    difference += std::abs(source.Offset + source.Length - this->Distances[v]);
    reached += 1.0;
  }
  // False if the difference is NaN.
  return difference <= LargestDifference * reached * this->Surface.GetMesh().GetMeanEdgeLength();
}

//------------------------------------------------------------------------------
Status ProbeField(const TaskContext& context, const DistanceField& field,
  const std::vector<SurfacePoint>& points, const ProgressCallback& progress, double* values)
{
  return ForEach((points.size() + BlockSize - 1) / BlockSize, 1, context.Parallel, progress,
    [&](std::size_t block, const ProgressCallback&) {
      FaceEnvelope envelope(field);
      const std::size_t end = std::min(points.size(), (block + 1) * BlockSize);
      for (std::size_t i = block * BlockSize; i < end; ++i)
      {
        values[i] = Probe(field, points[i], envelope);
      }
      return Status::Success();
    });
}
}
