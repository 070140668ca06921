// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths between random points on every mesh of the folder DGG_EXTRA_DATA.

#include "ExtraMeshes.h"
#include "MeshFile.h"
#include "PathTestTools.h"

#include <iostream>
#include <random>

using namespace dggtest;

namespace
{
constexpr int NumberOfStarts = 5;
constexpr int EndsPerStart = 4;
constexpr double Accuracy = 0.02;

class ExtraPaths : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    this->Surface = ReadPolyData(GetParam());
    ASSERT_GT(this->Surface->GetNumberOfPolys(), 0) << "cannot read " << GetParam();
  }

  /// Returns a point in a random triangle, or its first corner when `atVertex`.
  std::array<double, 3> MakePlace(bool atVertex)
  {
    std::uniform_int_distribution<vtkIdType> cells(0, this->Surface->GetNumberOfCells() - 1);
    std::uniform_real_distribution<double> weights(0.0, 1.0);
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    while (size < 3)
    {
      this->Surface->GetCellPoints(cells(this->Random), size, ids);
    }
    double u = atVertex ? 0.0 : weights(this->Random);
    double v = atVertex ? 0.0 : weights(this->Random);
    u = u + v > 1.0 ? 1.0 - u : u;
    v = std::min(v, 1.0 - u);
    std::array<double, 3> p{ { 0.0, 0.0, 0.0 } };
    for (int k = 0; k < 3; ++k)
    {
      double q[3];
      this->Surface->GetPoint(ids[k], q);
      const double weight = k == 0 ? 1.0 - u - v : (k == 1 ? u : v);
      for (int c = 0; c < 3; ++c)
      {
        p[c] += weight * q[c];
      }
    }
    return p;
  }

  /// Returns the ends of pairs. Several paths share a start; every second end is a vertex.
  Points MakeEnds()
  {
    Points ends;
    for (int i = 0; i < NumberOfStarts; ++i)
    {
      const auto start = this->MakePlace(i == 0);
      for (int k = 0; k < EndsPerStart; ++k)
      {
        ends.push_back(start);
        ends.push_back(this->MakePlace(k % 2 == 0));
      }
    }
    return ends;
  }

  static std::vector<PathLine> Run(vtkDGGPath* filter)
  {
    const Listener listener(filter); // these meshes have defects that cause warnings
    filter->Update();
    EXPECT_EQ(listener.Errors, std::vector<std::string>());
    return GetPaths(filter);
  }

  /// Returns a bound on the length that mollification adds to a path; 0 without degenerate faces.
  static double GetSlack(vtkDGGPath* filter)
  {
    return 10.0 * GetReported(filter, "NumberOfDegenerateFaces") *
      GetReported(filter, "Mollification");
  }

  vtkSmartPointer<vtkPolyData> Surface;
  std::mt19937 Random{ 4711 };
};

TEST_P(ExtraPaths, KeepTheirPromise)
{
  auto pairs = MakePairs(this->MakeEnds());
  vtkNew<vtkDGGPath> filter;
  filter->SetInputData(this->Surface);
  filter->SetPairData(pairs);
  filter->SetAccuracy(Accuracy);
  filter->SetMethodToExact();
  const auto exact = this->Run(filter);
  const auto status = GetPathStatus(filter);
  filter->SetMethodToGraph();
  const auto paths = this->Run(filter);
  EXPECT_EQ(GetPathStatus(filter), status);
  EXPECT_EQ(filter->GetNumberOfFallbacks(), 0);
  ASSERT_EQ(paths.size(), exact.size());
  ASSERT_FALSE(paths.empty());
  const double slack = GetSlack(filter);
  std::size_t shortest = 0;
  double worst = 0.0;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    SCOPED_TRACE(paths[i].Pair);
    const double d = exact[i].Length;
    ASSERT_EQ(exact[i].Pair, paths[i].Pair);
    ExpectOnSurface(exact[i], this->Surface, slack);
    ExpectOnSurface(paths[i], this->Surface, slack);
    EXPECT_EQ(paths[i].Positions.front(), exact[i].Positions.front());
    EXPECT_EQ(paths[i].Positions.back(), exact[i].Positions.back());
    EXPECT_GE(paths[i].Length, d * (1.0 - 1e-9) - slack);
    EXPECT_LE(paths[i].Length, paths[i].GraphLength * (1.0 + 1e-9));
    EXPECT_LE(paths[i].GraphLength, (1.0 + Accuracy) * (d + slack) * (1.0 + 1e-6));
    shortest += paths[i].Length <= d * (1.0 + 1e-6) ? 1 : 0;
    worst = d > 0.0 ? std::max(worst, paths[i].Length / d - 1.0) : worst;
  }
  std::cout << shortest << " of " << paths.size() << " paths are shortest, the others up to "
            << 100.0 * worst << " % longer\n";
}

INSTANTIATE_TEST_SUITE_P(Real, ExtraPaths, testing::ValuesIn(FindExtraMeshes()), NameExtraMesh);
}
