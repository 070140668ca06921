// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What vtkDiscreteGreensFunction does with wrong input and limits.
#include "SpectralTestTools.h"

#include "vtkDiscreteGreensFunction.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>

using namespace dggtest;

namespace
{
constexpr const char* Name = "GreensFunction";
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

class DiscreteGreensFunctionContract : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Surface);
    this->Filter->AddSourceId(45);
  }
  /// A correct call works afterwards, as if nothing had happened.
  void ExpectUnharmed()
  {
    this->Filter->RemoveAllSources();
    this->Filter->AddSourceId(45);
    this->Filter->SetEvaluationData(nullptr);
    this->Filter->SetBoundaryToNeumann();
    this->Filter->SetInputData(this->Surface);
    ExpectSuccess(this->Filter);
    const std::vector<double> values = GetValues(this->Filter->GetOutput(), Name);
    EXPECT_EQ(values.size(), static_cast<std::size_t>(this->Surface->GetNumberOfPoints()));
    this->Expected = this->Expected.empty() ? values : this->Expected;
    EXPECT_EQ(values, this->Expected);
  }

  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(20);
  vtkNew<vtkDiscreteGreensFunction> Filter;
  std::vector<double> Expected;
};
}

TEST_F(DiscreteGreensFunctionContract, WrongSources)
{
  this->ExpectUnharmed();
  this->Filter->RemoveAllSources();
  ExpectError(this->Filter, { "no source", "AddSourceId()" });
  this->ExpectUnharmed();
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(400) })
  {
    this->Filter->AddSourceId(id);
    ExpectError(this->Filter, { "source id " + std::to_string(id), "out of range" });
    this->ExpectUnharmed();
  }
  this->Filter->SetSourceData(MakeSourcePoints({ { 0.5, 0.5, 0.0 }, { 0.5, NaN, 0.0 } }));
  ExpectError(this->Filter, { "source point 1", "not finite" });
  this->ExpectUnharmed();
  this->Filter->SetSourceData(MakeSourcePoints({ { 0.5, 0.5, 30.0 } }));
  ExpectError(this->Filter, { "source point 0", "ProjectionTolerance" });
  this->ExpectUnharmed();
  vtkNew<vtkPolyData> alone;
  alone->DeepCopy(this->Surface);
  const vtkIdType id = alone->GetPoints()->InsertNextPoint(0.5, 0.5, 0.1);
  this->Filter->SetInputData(alone);
  this->Filter->AddSourceId(id);
  ExpectError(this->Filter, { "source 1", "no face" });
  this->ExpectUnharmed();
}

TEST_F(DiscreteGreensFunctionContract, WrongEvaluationPoints)
{
  this->Filter->SetEvaluationData(MakeSourcePoints({ { NaN, 0.5, 0.0 } }));
  ExpectError(this->Filter, { "evaluation point 0", "not finite" });
  this->ExpectUnharmed();
  this->Filter->SetEvaluationData(
    MakeSourcePoints({ PointInCell(this->Surface, 7, { 0.2, 0.3, 0.5 }), { 9.0, 0.5, 0.0 } }));
  ExpectError(this->Filter, { "evaluation point 1 of input port 2", "ProjectionTolerance" });
  this->ExpectUnharmed();
  // None at all is no error.
  this->Filter->SetEvaluationData(MakeSourcePoints({}));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetEvaluation()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Filter->GetEvaluation()->GetPointData()->HasArray(Name));
}

TEST_F(DiscreteGreensFunctionContract, WrongBoundary)
{
  this->Filter->SetBoundaryToDirichlet();
  this->Filter->SetSourceIds({ 45, 3 });
  ExpectError(this->Filter, { "source 1", "boundary", "Neumann" });
  this->ExpectUnharmed();
  this->Filter->SetBoundaryToDirichlet();
  double onRim[3];
  double next[3];
  this->Surface->GetPoint(3, onRim);
  this->Surface->GetPoint(4, next);
  this->Filter->SetSourceData(MakeSourcePoints(
    { { 0.5 * (onRim[0] + next[0]), 0.5 * (onRim[1] + next[1]), 0.5 * (onRim[2] + next[2]) } }));
  ExpectError(this->Filter, { "source 1", "boundary" });
  this->ExpectUnharmed();
  this->Filter->SetBoundaryToDirichlet();
  this->Filter->SetInputData(MakeSphere(2));
  ExpectError(this->Filter, { "source 0", "without a boundary", "Neumann" });
  this->ExpectUnharmed();
}

TEST_F(DiscreteGreensFunctionContract, WrongProperties)
{
  for (const double radius : { -1.0, NaN, std::numeric_limits<double>::infinity() })
  {
    this->Filter->SetRadius(radius);
    ExpectError(this->Filter, { "Radius", "SetRadius()" });
  }
  this->Filter->SetRadius(0.0);
  this->ExpectUnharmed();
  this->Filter->SetProjectionTolerance(NaN);
  ExpectError(this->Filter, { "ProjectionTolerance" });
  this->Filter->SetProjectionTolerance(0.01);
  this->Filter->SetResultArrayName(nullptr);
  ExpectError(this->Filter, { "ResultArrayName" });
  this->Filter->SetResultArrayName(Name);
  this->ExpectUnharmed();
  this->Filter->SetMethod(99);
  EXPECT_EQ(this->Filter->GetMethod(), vtkDiscreteGreensFunction::Vertex);
  std::ostringstream os;
  this->Filter->Print(os);
  EXPECT_NE(os.str().find("Method: Vertex"), std::string::npos);
  EXPECT_NE(os.str().find("Boundary: Neumann"), std::string::npos);
  this->Filter->SetMethodToSingularitySubtraction();
  this->ExpectUnharmed();
}

TEST_F(DiscreteGreensFunctionContract, WrongSurfaces)
{
  this->Filter->SetInputData(nullptr);
  ExpectError(this->Filter, { "no input" });
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(this->Surface->GetPoints());
  this->Filter->SetInputData(cloud);
  ExpectError(this->Filter, { "polygons" });
  vtkNew<vtkPolyData> none;
  this->Filter->SetInputData(none);
  ExpectWarning(this->Filter, { "empty" });
  for (int port = 0; port < 2; ++port)
  {
    EXPECT_EQ(this->Filter->GetOutput(port)->GetNumberOfPoints(), 0);
    EXPECT_TRUE(this->Filter->GetOutput(port)->GetPointData()->HasArray(Name));
  }
  this->ExpectUnharmed();
}

TEST_F(DiscreteGreensFunctionContract, MemoryLimit)
{
  this->Filter->SetMemoryLimit(1000);
  ExpectError(this->Filter, { "factorization", "MemoryLimit" });
  this->Filter->SetMemoryLimit(0);
  this->ExpectUnharmed();
  // Results count: those of many sources do not fit where those of one do.
  const vtkTypeUInt64 enough = 3000000;
  this->Filter->SetMemoryLimit(enough);
  ExpectSuccess(this->Filter);
  for (int k = 0; k < 2000; ++k)
  {
    this->Filter->AddSourceId(k % 400);
  }
  ExpectError(this->Filter, { "MemoryLimit", "fewer sources" });
  this->ExpectUnharmed();
}

TEST_F(DiscreteGreensFunctionContract, ProgressGrowsAndStops)
{
  this->Filter->SetInputData(MakeTerrain(60));
  for (vtkIdType id = 100; id < 130; ++id)
  {
    this->Filter->AddSourceId(id);
  }
  for (const bool interpolate : { false, true })
  {
    this->Filter->SetInterpolateRegularPart(interpolate);
    this->Filter->SetInputData(MakeTerrain(60)); // to be factorized again
    ExpectProgressAndStops(this->Filter, { 0.05, 0.2, 0.3 },
      [this] { return GetValues(this->Filter->GetOutput(), Name, 30); });
  }
}

TEST_F(DiscreteGreensFunctionContract, SaysWhereAMethodCannotBeUsed)
{
  this->Filter->SetInputData(MakeSphere(0));
  this->Filter->SetSourceIds({ 3, 4 });
  ExpectWarning(this->Filter, { "2 of the 2 sources", "too coarse" });
  EXPECT_EQ(this->Filter->GetUsedMethod(0), vtkDiscreteGreensFunction::Interpolated);
  EXPECT_EQ(this->Filter->GetUsedRadius(0), 0.0);
  // Ridges are no reason for another method, nor to say so at each of many sources.
  this->Filter->SetInputData(MakeTerrain(16));
  std::vector<vtkIdType> ids(50);
  std::iota(ids.begin(), ids.end(), 45);
  this->Filter->SetSourceIds(ids);
  ExpectSuccess(this->Filter);
  int near = 0;
  for (int source = 0; source < 51; ++source)
  {
    near += this->Filter->IsNearRidge(source) ? 1 : 0;
  }
  EXPECT_GT(near, 0);
  EXPECT_LT(near, 50);
  this->ExpectUnharmed();
}

TEST_F(DiscreteGreensFunctionContract, TheInputIsNotTouched)
{
  vtkNew<vtkDoubleArray> old;
  old->SetName(Name);
  old->SetNumberOfTuples(400);
  old->Fill(3.0);
  this->Surface->GetPointData()->SetScalars(old);
  vtkNew<vtkDoubleArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(400);
  other->Fill(4.0);
  this->Surface->GetPointData()->AddArray(other);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Surface->GetPointData()->GetScalars(), old);
  vtkPointData* data = this->Filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray("Other"), other);
  EXPECT_NE(data->GetArray(Name), old);
  EXPECT_EQ(data->GetNumberOfArrays(), 2);
  EXPECT_EQ(this->Filter->GetOutput()->GetPoints(), this->Surface->GetPoints());
  this->Filter->SetResultArrayName("G");
  ExpectSuccess(this->Filter);
  data = this->Filter->GetOutput()->GetPointData();
  EXPECT_EQ(data->GetArray(Name), old);
  EXPECT_STREQ(data->GetScalars()->GetName(), "G");
}
