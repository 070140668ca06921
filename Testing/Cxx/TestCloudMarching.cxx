// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGFastMarchingDistance on point clouds.
#include "CloudTestTools.h"

#include "vtkDGGFastMarchingDistance.h"

#include <cstddef>

namespace dggtest
{
namespace
{
class CloudMarching : public ::testing::Test
{
protected:
  void Use(const Points& points)
  {
    this->Cloud = points;
    this->Filter->SetInputData(MakeCloud(points));
  }

  std::vector<double> March()
  {
    ExpectSuccess(this->Filter);
    return GetDistances(this->Filter);
  }

  /// Returns the mean and largest relative error of points farther than `least`.
  template <typename Truth>
  std::array<double, 2> ErrorsBeyond(double least, Truth&& truth)
  {
    const std::vector<double> values = this->March();
    std::array<double, 2> errors{ { 0.0, 0.0 } };
    int count = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double exact = truth(this->Cloud[i]);
      if (exact > least)
      {
        const double error = std::abs(values[i] / exact - 1.0);
        errors = { { errors[0] + error, std::max(errors[1], error) } };
        ++count;
      }
    }
    errors[0] /= count;
    return errors;
  }

  vtkNew<vtkDGGFastMarchingDistance> Filter;
  Points Cloud;
};
}

TEST_F(CloudMarching, CloseToClosedForms)
{
  this->Use(MakeFlatPoints(60, 0.25));
  const std::array<double, 3> corner = this->Cloud[0];
  this->Filter->SetSourceIds({ 0 });
  const auto flat = this->ErrorsBeyond(0.2, [&](const auto& p) { return Distance(p, corner); });
  EXPECT_LT(flat[0], 0.03);
  EXPECT_LT(flat[1], 0.06);
  EXPECT_EQ(GetDistances(this->Filter)[0], 0.0);
  EXPECT_NEAR(this->Filter->GetUsedBandRadius(), 3.0, 0.1);
  EXPECT_GT(this->Filter->GetUsedResolution(), 100);
  EXPECT_LT(this->Filter->GetUsedResolution(), 140);

  this->Use(MakeSpherePoints(5000));
  const std::array<double, 3> pole = this->Cloud[0];
  const auto round =
    this->ErrorsBeyond(0.2, [&](const auto& p) { return SphereDistance(p, pole); });
  EXPECT_LT(round[0], 0.03);
  EXPECT_LT(round[1], 0.06);
}

TEST_F(CloudMarching, SourcesBesideTheCloud)
{
  this->Use(MakeFlatPoints(40));
  const std::array<double, 3> close{ { 0.505, 0.495, 0.01 } };
  this->Filter->SetSourceData(MakeSourcePoints({ close }));
  std::vector<double> values = this->March();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double straight = Distance(this->Cloud[i], close);
    EXPECT_NEAR(values[i], straight, 0.01 + 0.06 * straight) << i;
  }
  // A source off the band: its distance from the closest point is added.
  const std::array<double, 3> high{ { 0.0, 0.0, 0.5 } };
  this->Filter->SetSourceData(MakeSourcePoints({ high }));
  ExpectError(this->Filter, { "source 0, at (", "away from the cloud", "ProjectionTolerance" });
  this->Filter->SetProjectionTolerance(0.5);
  values = this->March();
  EXPECT_EQ(values[0], 0.5);
  EXPECT_NEAR(values.back(), 0.5 + std::sqrt(2.0), 0.1);
}

TEST_F(CloudMarching, PartsCopiesAndPointsThatAreOff)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Points part = MakeFlatPoints(20, 0.2);
  const Points other = Move(part, { { 3.0, 0.0, 0.0 } });
  const Points odd = { part[5], { { nan, 0.0, 0.0 } }, { { 1e6, 0.0, 0.0 } },
    { { 1e6, 0.0, 0.0 } } };
  this->Use(Join(Join(part, other), odd));
  this->Filter->SetSourceIds({ 0 });
  this->Filter->GenerateNearestSourceOn();
  std::vector<double> values = this->March();
  const std::vector<int> nearest = GetNearestSources(this->Filter);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_EQ(std::isfinite(values[i]), i < 400 || i == 800) << i;
    EXPECT_EQ(nearest[i], i < 400 || i == 800 ? 0 : -1) << i;
  }
  EXPECT_EQ(values[5], values[800]);
  // Outliers have no neighbors and do not change the distances of other points.
  this->Filter->SetSourceIds({ 0, 802 });
  const std::vector<double> both = this->March();
  EXPECT_EQ(both[802], 0.0);
  EXPECT_EQ(both[803], 0.0);
  EXPECT_TRUE(std::equal(values.begin(), values.begin() + 400, both.begin()));
  this->Filter->SetSourceIds({ 801 });
  ExpectWarning(this->Filter, { "not finite" });
  values = GetDistances(this->Filter);
  EXPECT_EQ(values[801], 0.0);
  EXPECT_TRUE(std::isnan(values[0]));
}

TEST_F(CloudMarching, ScaleDoesNotMatter)
{
  const Points points = MakeSpherePoints(2000);
  this->Use(points);
  this->Filter->SetSourceIds({ 3 });
  const std::vector<double> first = this->March();
  Points large = points;
  for (auto& p : large)
  {
    p = { { 0x1p100 * p[0], 0x1p100 * p[1], 0x1p100 * p[2] } };
  }
  this->Use(large);
  const std::vector<double> scaled = this->March();
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    EXPECT_EQ(scaled[i], 0x1p100 * first[i]) << i;
  }
}

TEST_F(CloudMarching, FewPoints)
{
  this->Filter->SetSourceIds({ 0 });
  this->Use({ { { 4.0, 5.0, 6.0 } } });
  EXPECT_EQ(this->March(), std::vector<double>{ 0.0 });
  this->Use({ { { 4.0, 5.0, 6.0 } }, { { 4.0, 5.0, 6.0 } } });
  EXPECT_EQ(this->March(), (std::vector<double>{ 0.0, 0.0 }));
  this->Use({ { { 4.0, 5.0, 6.0 } }, { { 4.0, 5.0, 7.0 } } });
  const std::vector<double> two = this->March();
  EXPECT_EQ(two[0], 0.0);
  EXPECT_NEAR(two[1], 1.0, 0.1);
  const Points part = MakeFlatPoints(20);
  this->Use(Join(part, Move(part, { { 1e10, 0.0, 0.0 } })));
  ExpectError(this->Filter, { "too far apart", "process each part separately" });
}

TEST_F(CloudMarching, FromCloudToMeshAndBack)
{
  this->Use(MakeFlatPoints(20, 0.2));
  this->Filter->SetSourceIds({ 0 });
  const std::vector<double> onCloud = this->March();
  vtkNew<vtkDGGFastMarchingDistance> other;
  const auto mesh = MakeTerrain(20);
  other->SetInputData(mesh);
  other->SetSourceIds({ 0 });
  ExpectSuccess(other);
  this->Filter->SetInputData(mesh);
  EXPECT_EQ(this->March(), GetDistances(other));
  EXPECT_EQ(this->Filter->GetUsedResolution(), 0);
  this->Use(this->Cloud);
  EXPECT_EQ(this->March(), onCloud);
  // A graph on the input has no effect.
  this->Filter->SetInputData(MakeCloudWithGraph(this->Cloud));
  EXPECT_EQ(this->March(), onCloud);
}

}
