// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Distances.h"

#include "dggStoredWindows.h"

#include <algorithm>
#include <utility>

namespace dggPython
{
namespace
{
/// Adds the arrays of windows to field data.
void AddWindows(const dgg::DistanceTask& task, const dgg::PreparedSurface& surface,
  const dgg::DistanceNames& names, dgg::Output& output)
{
  const auto& distances = std::get<dgg::Buffer<double>>(std::find_if(
    output.PointData.begin(), output.PointData.end(), [&](const dgg::OutputArray& array) {
      return array.Name == names.Distance;
    })->Values);
  dgg::StoredWindows windows(task.Windows, distances.Data(), distances.Size(), surface);
  const auto add = [&](int role, int components, auto& values) {
    output.FieldData.push_back(
      { dgg::StoredWindows::GetName(names.Distance, role), components, std::move(values) });
  };
  constexpr int components = dgg::StoredWindows::NumberOfComponents;
  add(dgg::StoredWindows::OffsetsRole, 1, windows.Offsets);
  add(dgg::StoredWindows::WindowsRole, components, windows.Windows);
  add(dgg::StoredWindows::SourcesRole, components, windows.Sources);
  add(dgg::StoredWindows::InfoRole, 1, windows.Info);
}
}

//------------------------------------------------------------------------------
dgg::Status RequireSurface(const dgg::PreparedSurface& surface, const char* what)
{
  return surface.IsCloud() ? dgg::InvalidInput(what, " need a surface, but the input is a cloud")
                               .At("Surface")
                               .Fix("Pass a surface with polygons")
                           : dgg::Status::Success();
}

//------------------------------------------------------------------------------
Distances::Distances(const py::handle& sources, Arguments& arguments)
  : Sources(sources, "source", "Sources")
{
  this->Sources.ReadInitialDistances(arguments);
  this->Sources.ReadTolerance(arguments);
  arguments.ReadLength("maximum_distance", this->MaximumDistance);
  arguments.Read("unreached_value", this->UnreachedValue);
  arguments.Read("generate_nearest_source", this->WantNearestSource);
  arguments.Read("generate_virtual_source", this->WantVirtualSource);
  arguments.Read("distance_array_name", this->Names.Distance);
  arguments.Read("source_array_name", this->Names.Source);
  arguments.Read("virtual_source_array_name", this->Names.VirtualSource);
}

//------------------------------------------------------------------------------
void Distances::RequestUpperBound(const std::string& name)
{
  this->Arrays.push_back({ name, "UpperBoundArrayName", std::vector<std::vector<double>>(1) });
}

//------------------------------------------------------------------------------
py::object Distances::Run(Call& call, const Surface& surface, const char* what, const Step& step)
{
  dgg::Output output;
  call.Run([&] { return this->Compute(call.MakeContext(surface), what, step, output); });
  return ToPython(output);
}

//------------------------------------------------------------------------------
dgg::Status Distances::Compute(
  const dgg::TaskContext& context, const char* what, const Step& step, dgg::Output& output) const
{
  const dgg::PreparedSurface& surface = context.Surface;
  if (what)
  {
    DGG_RETURN_IF_ERROR(RequireSurface(surface, what));
  }
  if (this->WantVirtualSource)
  {
    DGG_RETURN_IF_ERROR(RequireSurface(surface, "Virtual sources"));
  }
  std::vector<dgg::GeodesicSource> sources;
  DGG_RETURN_IF_ERROR(this->Sources.Locate(context, sources, &output.Warnings));
  dgg::DistanceTask task{ {}, sources };
  task.MaximumDistance = this->MaximumDistance;
  task.Arrays = this->Arrays;
  task.WantNearestSource = this->WantNearestSource;
  task.WantVirtualSource = this->WantVirtualSource;
  task.MayBeSparse = surface.GetNumberOfMergedPoints() == 0;
  DGG_RETURN_IF_ERROR(step(context, task));
  if (!task.QualityWarning.empty())
  {
    output.Warnings.push_back(task.QualityWarning);
  }

  const std::vector<bool> isReached = dgg::FindReached(surface, task);
  const dgg::DistanceNames names{ this->Names.Distance,
    this->WantNearestSource ? this->Names.Source : "",
    this->WantVirtualSource ? this->Names.VirtualSource : "" };
  dgg::WriteDistances(surface, task, isReached, names, this->UnreachedValue, output.PointData);
  output.PointScalars = names.Distance;
  if (!task.Windows.IsEmpty())
  {
    AddWindows(task, surface, names, output);
  }
  const std::string gaps =
    dgg::AreMostReached(isReached) ? std::string() : surface.DescribeGaps(isReached);
  if (!gaps.empty())
  {
    output.Warnings.push_back(gaps);
  }
  return dgg::Status::Success();
}
}
