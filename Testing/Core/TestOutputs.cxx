// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Outputs of tasks: points, cells and arrays. The values themselves are tested with the algorithms.
#include "TaskTestTools.h"

#include "dggDistanceOutput.h"
#include "dggFieldReader.h"
#include "dggGraphBuildTask.h"
#include "dggInputArray.h"
#include "dggOutput.h"
#include "dggPathSearch.h"
#include "dggSurfaceOutput.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::Offset;
using dgg::Output;
using dgg::SurfacePath;
using dgg::SurfacePoint;

/// Returns the values of an array; empty, with a failure, if there is no such array.
template <typename ValueType>
std::vector<ValueType> GetValues(const dgg::OutputArrays& arrays, const std::string& name)
{
  for (const dgg::OutputArray& array : arrays)
  {
    if (array.Name == name)
    {
      const auto& values = std::get<dgg::Buffer<ValueType>>(array.Values);
      return { values.begin(), values.end() };
    }
  }
  ADD_FAILURE() << "no array " << name;
  return {};
}

bool HasArray(const dgg::OutputArrays& arrays, const std::string& name)
{
  return std::any_of(arrays.begin(), arrays.end(),
    [&](const dgg::OutputArray& array) { return array.Name == name; });
}

template <typename ValueType>
std::vector<ValueType> ToVector(const dgg::Buffer<ValueType>& values)
{
  return { values.begin(), values.end() };
}

dgg::InputArray MakeInput(const std::vector<double>& values, int components = 1)
{
  dgg::InputArray array;
  array.Name = "A";
  array.NumberOfComponents = components;
  array.NumberOfTuples = static_cast<Offset>(values.size()) / components;
  array.AreNumbers = true;
  array.Values = values;
  return array;
}

/// Returns a unit square of two triangles, 0 1 2 and 0 2 3.
TestMesh Square()
{
  TestMesh mesh;
  mesh.Points = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
  mesh.Triangles = { 0, 1, 2, 0, 2, 3 };
  return mesh;
}
}

TEST(Outputs, CurvesOpenClosedAndOfOnePoint)
{
  const TestMesh mesh = Square();
  const MeshArrays arrays(mesh);
  const auto surface = Prepare(mesh);
  const dgg::SurfaceMesh& faces = surface->GetMesh();
  SurfacePath open;
  open.Append(faces, SurfacePoint::AtVertex(1), dgg::NoId);
  open.Append(faces, SurfacePoint::OnEdge(faces, 2, 0.5), 0); // the center
  open.Append(faces, SurfacePoint::AtVertex(3), 1);
  SurfacePath closed;
  for (const Id v : { 0, 1, 2, 0 })
  {
    closed.Append(faces, SurfacePoint::AtVertex(v), 0);
  }
  SurfacePath point;
  point.Append(faces, SurfacePoint::AtVertex(2), dgg::NoId);

  Output output;
  dgg::WriteCurves(
    MakeContext(*surface, arrays), { { &open }, { &closed, true }, { &point } }, output);
  EXPECT_EQ(ToVector(output.Lines.Offsets), (std::vector<Offset>{ 0, 3, 7, 9 }));
  EXPECT_EQ(ToVector(output.Lines.Points), (std::vector<Offset>{ 0, 1, 2, 3, 4, 5, 3, 6, 6 }));
  EXPECT_EQ(GetValues<Offset>(output.PointData, "vtkOriginalPointIds"),
    (std::vector<Offset>{ 1, -1, 3, 0, 1, 2, 2 }));
  EXPECT_EQ(GetValues<Offset>(output.PointData, "FaceId"),
    (std::vector<Offset>{ 0, 1, 1, 0, 0, 0, dgg::FindFaceOf(faces, point.Points[0]) }));
  const double half = std::sqrt(0.5);
  const std::vector<double> lengths = GetValues<double>(output.PointData, "ArcLength");
  const std::vector<double> expected{ 0, half, 2.0 * half, 0, 1, 2, 0 };
  const std::vector<double> coordinates = GetValues<double>(output.PointData, "Barycentric");
  ASSERT_EQ(lengths.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(lengths[i], expected[i], 1e-12);
    const Offset cell = GetValues<Offset>(output.PointData, "FaceId")[i];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum += coordinates[3 * i + k] * mesh.Points[3 * mesh.Triangles[3 * cell + k] + axis];
      }
      EXPECT_NEAR(output.Points[3 * i + axis], sum, 1e-12) << "point " << i;
    }
  }
}

TEST(Outputs, NoBarycentricCoordinatesInPolygons)
{
  const TestMesh mesh = Square();
  const std::vector<Offset> offsets{ 0, 4 };
  const std::vector<Offset> ids{ 0, 1, 2, 3 };
  dgg::SurfaceArrays arrays;
  arrays.Polygons = { 1, offsets.data(), ids.data(), 4 };
  const auto surface = Prepare(mesh);
  const MeshArrays triangles(mesh);
  dgg::TaskContext context = MakeContext(*surface, triangles);
  context.GetCells = [&]() -> const dgg::SurfaceArrays& { return arrays; };
  Output output;
  dgg::WriteSurfacePoints(context, { SurfacePoint::AtVertex(2) }, output);
  EXPECT_FALSE(HasArray(output.PointData, "Barycentric"));
  EXPECT_TRUE(HasArray(output.PointData, "FaceId"));
  EXPECT_EQ(ToVector(output.Verts.Offsets), (std::vector<Offset>{ 0, 1 }));
}

TEST(Outputs, MarksOfUnreachedPoints)
{
  const std::vector<double> distances{ 0.0, dgg::Infinity, 2.0 };
  for (const double value : { -1.0, dgg::Infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    dgg::OutputArrays arrays;
    dgg::AddDistances("D", distances, value, arrays);
    const double found = GetValues<double>(arrays, "D")[1];
    EXPECT_TRUE(found == value || (std::isnan(found) && std::isnan(value)));
    ASSERT_EQ(HasArray(arrays, "D.Unreached"), value == -1.0);
    if (value == -1.0)
    {
      EXPECT_EQ(
        GetValues<std::uint8_t>(arrays, "D.Unreached"), (std::vector<std::uint8_t>{ 0, 1, 0 }));
    }
  }
}

TEST(Outputs, SparseDistancesEqualOthers)
{
  const auto surface = Prepare(Square());
  dgg::DistanceResults all;
  all.Distances = { 0.0, 1.0, 5.0, dgg::Infinity };
  all.MaximumDistance = 2.0;
  all.NearestSource = { 0, 1, 1, dgg::NoId };
  dgg::DistanceResults few = all;
  few.IsSparse = true;
  few.Vertices = { 2, 1, 0 };
  few.Distances = { 5.0, 1.0, 0.0 };
  few.NearestSource = { 1, 1, 0 };
  for (const dgg::DistanceResults* results : { &all, &few })
  {
    dgg::DistanceRequest request;
    request.UnreachedValue = -1.0;
    request.WantNearestSource = true;
    request.Names = { "D", "S", "" };
    Output output;
    dgg::WriteDistances(*surface, *results, dgg::FindReached(*surface, *results), request, output);
    const dgg::OutputArrays& arrays = output.PointData;
    EXPECT_EQ(GetValues<double>(arrays, "D"), (std::vector<double>{ 0.0, 1.0, -1.0, -1.0 }));
    EXPECT_EQ(GetValues<std::int32_t>(arrays, "S"), (std::vector<std::int32_t>{ 0, 1, -1, -1 }));
    EXPECT_EQ(
      GetValues<std::uint8_t>(arrays, "D.Unreached"), (std::vector<std::uint8_t>{ 0, 0, 1, 1 }));
  }
}

TEST(Outputs, UnconnectedPairsAreCounted)
{
  const GraphWorld world = CornerWorld();
  std::vector<dgg::FoundPath> paths(3);
  paths[1].Path.Points = { SurfacePoint::AtVertex(0), SurfacePoint::AtVertex(2) };
  paths[1].Path.Length = std::sqrt(2.0);
  Output output;
  EXPECT_EQ(dgg::WritePaths(world.MakeContext(), paths, output), (std::vector<Offset>{ 1 }));
  EXPECT_EQ(GetValues<std::int32_t>(output.FieldData, "PathStatus"),
    (std::vector<std::int32_t>{ 1, 0, 1 }));
  EXPECT_EQ(GetValues<Offset>(output.CellData, "PairId"), (std::vector<Offset>{ 1 }));
  ASSERT_EQ(output.Warnings.size(), 1u);
  EXPECT_NE(output.Warnings[0].find("2 of 3 pairs"), std::string::npos);
}

TEST(Outputs, GraphLinesAreEachEdgeOnce)
{
  const GraphWorld world = CornerWorld();
  Output output;
  ASSERT_TRUE(Ok(dgg::WriteGraphLines(world.MakeContext(), world.Graph.View(), nullptr, output)));
  EXPECT_EQ(ToVector(output.Lines.Points), (std::vector<Offset>{ 0, 1, 1, 2 }));
  EXPECT_EQ(GetValues<double>(output.CellData, "Length"), (std::vector<double>{ 1.0, 1.0 }));
}

TEST(FieldReader, UsesOnlySourcesOfTheDistances)
{
  const TestMesh mesh = Square();
  const MeshArrays arrays(mesh);
  const auto surface = Prepare(mesh);
  const dgg::TaskContext context = MakeContext(*surface, arrays);
  const std::vector<double> distances{ 0.0, 1.0, std::sqrt(2.0), 1.0 };
  std::vector<double> sources;
  for (const double distance : distances)
  {
    sources.insert(sources.end(), { 0.0, distance, 0.0 });
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double factor : { 1.0, 2.0 })
  {
    dgg::FieldReader reader(*surface);
    std::vector<double> values = distances;
    for (double& value : values)
    {
      value *= factor;
    }
    ASSERT_TRUE(Ok(reader.SetDistances(MakeInput(values), nan, {})));
    reader.SetSources(MakeInput(sources, 3));
    ASSERT_TRUE(Ok(reader.Complete(context, nullptr)));
    EXPECT_EQ(reader.GetField().HasSources(), factor == 1.0);
    EXPECT_FALSE(reader.HasFittedSources());
    EXPECT_EQ(reader.GetWarnings().empty(), factor == 1.0);
  }
  dgg::FieldReader reader(*surface);
  const auto infinite = MakeInput({ 0.0, -dgg::Infinity, 1.0, 1.0 });
  EXPECT_FALSE(reader.SetDistances(infinite, nan, {}).IsOk());
  ASSERT_TRUE(Ok(reader.SetDistances(infinite, -dgg::Infinity, {})));
  EXPECT_EQ(reader.FindRange(), (std::array<double, 2>{ { 0.0, 1.0 } }));
  ASSERT_TRUE(Ok(reader.SetDistances(infinite, nan, MakeInput({ 0.0, 1.0, 1.0, 1.0 }))));
  EXPECT_EQ(reader.FindRange(), (std::array<double, 2>{ { 0.0, 0.0 } }));
}
}
