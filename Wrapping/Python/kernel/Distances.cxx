// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Distances.h"

#include "Errors.h"

namespace dggPython
{
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
  this->Request.Names = { DistanceName, SourceName, VirtualSourceName };
  this->Sources.ReadInitialDistances(arguments);
  this->Sources.ReadTolerance(arguments);
  arguments.Read("maximum_distance", this->Request.MaximumDistance);
  arguments.Read("unreached_value", this->Request.UnreachedValue);
  arguments.Read("generate_nearest_source", this->Request.WantNearestSource);
  arguments.Read("generate_virtual_source", this->Request.WantVirtualSource);
  arguments.Read("distance_array_name", this->Request.Names.Distance);
  arguments.Read("source_array_name", this->Request.Names.Source);
  arguments.Read("virtual_source_array_name", this->Request.Names.VirtualSource);
}

//------------------------------------------------------------------------------
void Distances::RequestUpperBound(const std::string& name)
{
  this->Request.Arrays.push_back(
    { name, "UpperBoundArrayName", std::vector<std::vector<double>>(1) });
}

//------------------------------------------------------------------------------
py::object Distances::Run(Call& call, const Surface& surface, const char* what, const Step& step)
{
  ThrowUnlessOk(this->Request.Check());
  dgg::DistanceOutput output;
  call.Run([&] {
    const dgg::TaskContext context = call.MakeContext(surface);
    if (what)
    {
      DGG_RETURN_IF_ERROR(RequireSurface(context.Surface, what));
    }
    DGG_RETURN_IF_ERROR(dgg::FindDistances(
      context, this->Sources.GetCollection(), this->Sources.GetTolerance(), this->Request,
      [&](dgg::DistanceTask& task) { return step(context, task); }, output));
    output.Warn(output.QualityWarning);
    output.Warn(dgg::AreMostReached(output.IsReached)
        ? std::string()
        : context.Surface.DescribeGaps(output.IsReached));
    return dgg::Status::Success();
  });
  const bool isDoubtful = !output.QualityWarning.empty();
  py::object result = ToPython(output);
  result.attr("quality_warning") = isDoubtful;
  return result;
}
}
