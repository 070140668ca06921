// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances between two sets of points.
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicDistanceMatrix.h"

#include "vtkTable.h"

using namespace dggtest;

namespace
{
using Rows = std::vector<std::vector<double>>;

Rows GetRows(vtkGeodesicDistanceMatrix* filter)
{
  vtkDoubleArray* matrix = filter->GetMatrix();
  vtkTable* table = filter->GetOutput();
  EXPECT_EQ(table->GetNumberOfRows(), matrix->GetNumberOfTuples());
  Rows rows;
  for (vtkIdType i = 0; i < matrix->GetNumberOfTuples(); ++i)
  {
    rows.emplace_back();
    for (int j = 0; j < matrix->GetNumberOfComponents(); ++j)
    {
      const double value = matrix->GetComponent(i, j);
      rows.back().push_back(value);
      const double inTable = table->GetValue(i, j).ToDouble();
      EXPECT_TRUE(inTable == value || (std::isnan(inTable) && std::isnan(value)));
    }
  }
  return rows;
}

using SparseRows = std::vector<std::vector<std::pair<int, double>>>;

SparseRows GetSparseRows(vtkGeodesicDistanceMatrix* filter)
{
  vtkTable* table = filter->GetOutput();
  vtkDataArray* offsets = table->GetFieldData()->GetArray("RowOffsets");
  SparseRows rows(offsets->GetNumberOfTuples() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const auto end = static_cast<vtkIdType>(offsets->GetComponent(i + 1, 0));
    for (auto k = static_cast<vtkIdType>(offsets->GetComponent(i, 0)); k < end; ++k)
    {
      rows[i].emplace_back(table->GetValueByName(k, "Column").ToInt(),
        table->GetValueByName(k, "GeodesicDistance").ToDouble());
    }
  }
  return rows;
}

Rows Transpose(const Rows& rows)
{
  Rows columns(rows[0].size());
  for (const auto& row : rows)
  {
    for (std::size_t j = 0; j < row.size(); ++j)
    {
      columns[j].push_back(row[j]);
    }
  }
  return columns;
}

class GeodesicDistanceMatrix : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->SetAccuracy(0.05);
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(20);
  vtkNew<vtkGeodesicDistanceMatrix> Filter;
};
}

TEST_F(GeodesicDistanceMatrix, EndsAtTheMaximumDistance)
{
  this->Filter->SetRowIds({ 0, 17, 210 });
  this->Filter->SetColumnIds({ 0, 100, 399 });
  ExpectSuccess(this->Filter);
  const Rows all = GetRows(this->Filter);
  const double radius = all[0][1] + 1e-9; // up to rounding
  this->Filter->SetMaximumDistance(radius);
  ExpectSuccess(this->Filter);
  const Rows near = GetRows(this->Filter);
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      EXPECT_EQ(std::isnan(near[i][j]), all[i][j] > radius) << i << " " << j;
      EXPECT_TRUE(std::isnan(near[i][j]) || std::abs(near[i][j] - all[i][j]) < 1e-9);
    }
  }
}

TEST_F(GeodesicDistanceMatrix, IdsComeBeforePlaces)
{
  this->Filter->SetInputData(MakeGrid(8, 8));
  const Points places = { { { 8, 8, 0 } }, { { 0, 0, 0 } }, { { 2.3, 1.1, 0.0 } },
    { { 2.4, 1.15, 0.0 } }, { { 4.5, 3.0, 0.0 } }, { { 7.99, 0.02, 0.0 } } };
  const auto others = MakeSourcePoints(Points(places.begin() + 2, places.end()));
  this->Filter->SetRowIds({ 80, 0 });
  this->Filter->SetRowData(others);
  for (const double accuracy : { 0.3, 0.01 })
  {
    this->Filter->SetAccuracy(accuracy);
    this->Filter->SetColumnIds(nullptr);
    this->Filter->SetColumnData(nullptr);
    ExpectSuccess(this->Filter);
    const Rows matrix = GetRows(this->Filter);
    ASSERT_EQ(matrix.size(), places.size());
    EXPECT_EQ(matrix, Transpose(matrix));
    this->Filter->SetColumnIds({ 80, 0 });
    this->Filter->SetColumnData(others);
    ExpectSuccess(this->Filter);
    const Rows both = GetRows(this->Filter);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      for (std::size_t j = 0; j < places.size(); ++j)
      {
        const double exact = std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
        EXPECT_GE(matrix[i][j], exact - 1e-9) << i << " " << j;
        EXPECT_LE(matrix[i][j], exact * (1.0 + accuracy) * (1.0 + 1e-6) + 1e-9) << i << " " << j;
        EXPECT_NEAR(both[i][j], matrix[i][j], 1e-9);
      }
    }
  }
}

TEST_F(GeodesicDistanceMatrix, PairsThatAreNotConnected)
{
  auto surface = MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 5, 0, 0 } },
                               { { 6, 0, 0 } }, { { 5, 1, 0 } }, { { 7, 7, 7 } } },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  this->Filter->SetInputData(surface);
  this->Filter->SetRowIds({ 1, 3, 6 });
  ExpectWarning(this->Filter, { "row id 6 is a point that no polygon uses" });
  Rows matrix = GetRows(this->Filter);
  EXPECT_TRUE(std::isnan(matrix[0][1]));
  EXPECT_TRUE(std::isnan(matrix[2][0]));
  EXPECT_EQ(matrix[2][2], 0.0);
  this->Filter->SetUnreachedValue(-1.0);
  ExpectWarning(this->Filter, { "row id 6 is a point" });
  matrix = GetRows(this->Filter);
  EXPECT_EQ(matrix[1][0], -1.0);
  EXPECT_EQ(matrix[1][2], -1.0);
  this->Filter->SetRowIds({ 1 });
  this->Filter->SetColumnIds({ 6, 0, 6 });
  ExpectWarning(this->Filter, { "column id 6 and 1 more are points that no polygon uses" });
}

TEST_F(GeodesicDistanceMatrix, TheMatrixIsWhatWasComputed)
{
  this->Filter->SetRowIds({ 0, 399, 7 });
  this->Filter->SetColumnIds({ 5, 6 });
  ExpectSuccess(this->Filter);
  const vtkSmartPointer<vtkDoubleArray> matrix = this->Filter->GetMatrix();
  EXPECT_EQ(this->Filter->GetMatrix(), matrix); // no copy is made
  EXPECT_STREQ(matrix->GetName(), "GeodesicDistance");
  const Rows expected = GetRows(this->Filter);
  // The matrix is independent of changes to the table.
  vtkTable* table = this->Filter->GetOutput();
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(3);
  table->AddColumn(words);
  table->RemoveColumn(0);
  table->Modified();
  EXPECT_EQ(this->Filter->GetMatrix(), matrix);
  EXPECT_EQ(matrix->GetNumberOfComponents(), 2);
  table->Initialize();
  EXPECT_EQ(this->Filter->GetMatrix()->GetNumberOfTuples(), 3);
  // The next update creates another matrix and leaves the previous one unchanged.
  this->Filter->SetRowIds({ 0 });
  ExpectSuccess(this->Filter);
  EXPECT_NE(this->Filter->GetMatrix(), matrix);
  EXPECT_EQ(this->Filter->GetMatrix()->GetNumberOfTuples(), 1);
  EXPECT_EQ(matrix->GetComponent(1, 1), expected[1][1]);
}

TEST_F(GeodesicDistanceMatrix, TheMatrixCanBeReleased)
{
  this->Filter->SetRowIds({ 0, 399, 7 });
  ExpectSuccess(this->Filter);
  const Rows expected = GetRows(this->Filter);
  this->Filter->ReleaseMatrix();
  EXPECT_EQ(this->Filter->GetMatrix()->GetNumberOfTuples(), 0);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfRows(), 0);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(GetRows(this->Filter), expected);
}

TEST_F(GeodesicDistanceMatrix, TheTableIsOptional)
{
  EXPECT_TRUE(this->Filter->GetGenerateTable());
  const std::vector<vtkIdType> many(10001, 3);
  this->Filter->SetRowIds({ 5 });
  this->Filter->SetColumnIds(many);
  ExpectWarning(this->Filter, { "10001 columns", "GetMatrix()", "turn off GenerateTable" });
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfColumns(), 0);
  EXPECT_EQ(this->Filter->GetMatrix()->GetNumberOfComponents(), 10001);
  EXPECT_GT(this->Filter->GetMatrix()->GetComponent(0, 10000), 0.0);
  this->Filter->GenerateTableOff();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetMatrix()->GetNumberOfComponents(), 10001);
  this->Filter->GenerateTableOn();
  this->Filter->SetColumnIds(std::vector<vtkIdType>(10000, 3));
  ExpectSuccess(this->Filter);
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfColumns(), 10000);
  EXPECT_STREQ(this->Filter->GetOutput()->GetColumnName(9999), "9999");
}

TEST_F(GeodesicDistanceMatrix, CompressedRowsAreThePairsWithinTheDistance)
{
  double p[3];
  this->Terrain->GetPoint(40, p);
  // Point 400 coincides with point 40.
  this->Terrain->GetPoints()->InsertNextPoint(p);
  const vtkIdType n = this->Terrain->GetNumberOfPoints();
  this->Filter->MergeCoincidentPointsOn();
  const std::vector<vtkIdType> ids = { 40, 399, 17 };
  this->Filter->SetRowIds(ids);
  const auto point = MakeSourcePoints({ { { p[0] + 0.1, p[1] + 0.15, p[2] } } });
  this->Filter->SetRowData(point);
  this->Filter->SetProjectionTolerance(1.0);
  std::vector<vtkIdType> all(n);
  std::iota(all.begin(), all.end(), 0);
  this->Filter->SetColumnIds(all);
  ExpectSuccess(this->Filter);
  const Rows dense = GetRows(this->Filter);
  const double radius = dense[0][45];

  this->Filter->CompressedRowsOn();
  this->Filter->SetMaximumDistance(radius);
  ExpectError(this->Filter, { "CompressedRows is on, but columns are chosen" });
  this->Filter->SetColumnIds(nullptr);
  for (const bool correct : { false, true })
  {
    this->Filter->SetCorrection(correct);
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetMatrix()->GetNumberOfTuples(), 0);
    const SparseRows rows = GetSparseRows(this->Filter);
    ASSERT_EQ(rows.size(), dense.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      std::vector<double> field = dense[i];
      if (correct)
      {
        vtkNew<vtkDGGDistance> distance;
        distance->SetInputData(this->Terrain);
        distance->SetAccuracy(0.05);
        distance->MergeCoincidentPointsOn();
        distance->SetProjectionTolerance(1.0);
        i < 3 ? distance->AddSourceId(ids[i]) : distance->SetSourceData(point);
        ExpectSuccess(distance);
        field = GetDistances(distance);
      }
      EXPECT_TRUE(std::is_sorted(rows[i].begin(), rows[i].end()));
      std::vector<double> found(n, std::nan(""));
      for (const auto& entry : rows[i])
      {
        found[entry.first] = entry.second;
      }
      for (vtkIdType v = 0; v < n; ++v)
      {
        const bool isAtRim = std::abs(field[v] - radius) < 1e-9;
        EXPECT_TRUE(isAtRim || std::isnan(found[v]) == (field[v] > radius)) << i << " " << v;
        EXPECT_TRUE(std::isnan(found[v]) || std::abs(found[v] - field[v]) < 1e-9);
      }
    }
  }
  this->Filter->SetMaximumDistance(VTK_DOUBLE_MAX);
  this->Filter->SetMemoryLimit(20000);
  ExpectError(this->Filter, { "The matrix so far", "fewer rows", "MemoryLimit" });
}

TEST_F(GeodesicDistanceMatrix, MemoryLimitCountsTheTable)
{
  this->Filter->SetRowIds({ 0 });
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(10000); // the graph exists
  this->Filter->SetRowIds(std::vector<vtkIdType>(40, 7));
  ExpectError(this->Filter,
    { "40 rows and 40 columns with its table", "25 KiB", "9.766 KiB", "turn off GenerateTable",
      "MemoryLimit" });
  this->Filter->GenerateTableOff();
  ExpectError(this->Filter, { "40 rows and 40 columns", "12.5 KiB", "9.766 KiB", "MemoryLimit" });
  this->Filter->SetMemoryLimit(13000);
  ExpectSuccess(this->Filter);
}
