// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contract of all distance filters: defaults, arrays, passed data, limits.
#include "FilterTestTools.h"

#include "DGGDistanceInternals.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkObjectFactory.h"

#include <new>
#include <stdexcept>

using namespace dggtest;

TEST(GeodesicDistanceContract, SourceIds)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->AddSourceId(7);
  filter->AddSourceId(3);
  ASSERT_EQ(filter->GetNumberOfSourceIds(), 2);
  EXPECT_EQ(filter->GetSourceId(0), 7);
  EXPECT_EQ(filter->GetSourceId(1), 3);
  EXPECT_EQ(filter->GetSourceId(2), -1);
  EXPECT_EQ(filter->GetSourceId(-1), -1);

  vtkNew<vtkIdList> list;
  list->InsertNextId(11);
  filter->SetSourceIds(list);
  list->SetId(0, 12); // the ids were copied
  ASSERT_EQ(filter->GetNumberOfSourceIds(), 1);
  EXPECT_EQ(filter->GetSourceId(0), 11);

  const std::vector<vtkIdType> ids = { 1, 2, 2 };
  filter->SetSourceIds(ids);
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 3);
  const vtkMTimeType changed = filter->GetMTime();
  filter->SetSourceIds(ids);
  EXPECT_EQ(filter->GetMTime(), changed);
  filter->SetSourceIds({ 0 }); // not a null list
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 1);
  filter->SetSourceIds(nullptr);
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 0);

  filter->AddSourceId(1);
  filter->SetSourceData(MakeSourcePoints({ { { 0.0, 0.0, 0.0 } } }));
  filter->RemoveAllSourceIds();
  EXPECT_GT(filter->GetMTime(), changed);
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 0);
  EXPECT_EQ(filter->GetNumberOfInputConnections(1), 1);
  filter->RemoveAllSources();
  EXPECT_EQ(filter->GetNumberOfInputConnections(1), 0);
}

TEST(GeodesicDistanceContract, MeshReport)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(MakeGrid(4, 3));
  filter->AddSourceId(0);
  ExpectSuccess(filter);
  EXPECT_EQ(GetReported(filter, "NumberOfTriangles"), 24);
  EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 1);
  EXPECT_EQ(GetReported(filter, "NumberOfBoundaryLoops"), 1);
  EXPECT_EQ(GetReported(filter, "NumberOfBoundaryEdges"), 14);
  EXPECT_EQ(GetReported(filter, "Genus"), 0);
  EXPECT_EQ(GetReported(filter, "Orientable"), 1);
  // Half a unit square: longest edge sqrt 2, perimeter 2 + sqrt 2, area 1/2.
  const double tau = std::sqrt(2.0) * (2.0 + std::sqrt(2.0)) / (2.0 * std::sqrt(3.0));
  EXPECT_NEAR(filter->GetMeanAnisotropy(), tau, 1e-12);
  EXPECT_NEAR(GetReported(filter, "MedianAnisotropy"), tau, 1e-12);
  EXPECT_EQ(GetReported(filter, "Mollification"), 0.0);
  const std::string report = filter->GetMeshReport();
  for (const char* line : { "points: 20\n", "triangles: 24\n", "components: 1\n",
         "boundary loops: 1\n", "boundary edges: 14\n", "genus: 0\n", "orientable: yes\n",
         "non-manifold edges: 0\n", "degenerate faces: 0\n", "isolated points: 0\n" })
  {
    EXPECT_NE(report.find(line), std::string::npos) << line << " is missing in:\n" << report;
  }
}

//------------------------------------------------------------------------------
// Behavior of the base class with a faulty subclass.
namespace
{
class MisbehavingDistance : public vtkGeodesicDistanceAlgorithm
{
public:
  static MisbehavingDistance* New();
  vtkTypeMacro(MisbehavingDistance, vtkGeodesicDistanceAlgorithm);

  enum class Fault
  {
    None,
    Memory,
    Exception,
    Other,
    Status
  };
  Fault Do = Fault::None;

protected:
  MisbehavingDistance() { this->Internals.reset(new vtkInternals(this)); }

private:
  class vtkInternals : public DGGInternalsOf<MisbehavingDistance, DGGDistanceInternals>
  {
  public:
    using DGGInternalsOf::DGGInternalsOf;

    dgg::Status ComputeDistances(const DGGContext& context, dgg::DistanceTask& task) override
    {
      switch (this->Self->Do)
      {
        case Fault::Memory:
          throw std::bad_alloc();
        case Fault::Exception:
          throw std::runtime_error("the engine stalled");
        case Fault::Other:
          throw 5;
        case Fault::Status:
          return dgg::InvalidInput("the status says no");
        case Fault::None:
          break;
      }
      task.Distances.assign(context.Surface.GetMesh().GetNumberOfVertices(), 2.5);
      return dgg::Status::Success();
    }
  };
};
vtkStandardNewMacro(MisbehavingDistance);
}

TEST(GeodesicDistanceContract, NothingIsThrownAcrossVTK)
{
  using Fault = MisbehavingDistance::Fault;
  vtkNew<MisbehavingDistance> filter;
  filter->SetInputData(MakeGrid(2, 2));
  filter->AddSourceId(0);
  const std::vector<std::pair<Fault, const char*>> cases = { { Fault::Memory, "memory" },
    { Fault::Exception, "the engine stalled" }, { Fault::Other, "unexpected" },
    { Fault::Status, "the status says no" } };
  for (const auto& faultAndText : cases)
  {
    filter->Do = faultAndText.first;
    filter->Modified();
    ExpectError(filter, { faultAndText.second });
    filter->Do = Fault::None;
    filter->Modified();
    ExpectSuccess(filter);
    EXPECT_EQ(GetDistances(filter), std::vector<double>(9, 2.5));
  }
}
