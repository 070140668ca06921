// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Virtual sources beyond the vertices of rims: distances inside of long faces.
#include "FieldChecks.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggFaceProfile.h"
#include "dggGraphSearch.h"
#include "dggSourceFinding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace dgg;
using namespace dggtest;

namespace
{
constexpr Id HalfRim = 12;

/// A plate with two round holes of radius 3, 30 apart, no points but those of the rims, so that the
/// faces between the holes are long and thin.
TestMesh PlateWithTwoHoles()
{
  const double radius = 3.0;
  const double margin = 1.0;
  const double width = 30.0 + 4.0 * radius + 2.0 * margin;
  const double height = 2.0 * (radius + margin);
  TestMesh mesh;
  const Id corners[] = { mesh.AddPoint(0.0, 0.0, 0.0), mesh.AddPoint(width, 0.0, 0.0),
    mesh.AddPoint(width, height, 0.0), mesh.AddPoint(0.0, height, 0.0) };
  // From the lowest point of a rim, counter-clockwise on the left, clockwise on the right: the
  // first halves face each other.
  Id left[2 * HalfRim + 1];
  Id right[2 * HalfRim + 1];
  for (Id k = 0; k < 2 * HalfRim; ++k)
  {
    const double angle = Pi * k / HalfRim;
    const double x = radius * std::sin(angle);
    const double y = 0.5 * height - radius * std::cos(angle);
    left[k] = mesh.AddPoint(margin + radius + x, y, 0.0);
    right[k] = mesh.AddPoint(width - margin - radius - x, y, 0.0);
  }
  left[2 * HalfRim] = left[0];
  right[2 * HalfRim] = right[0];
  for (Id k = 0; k < HalfRim; ++k)
  {
    mesh.AddQuad(left[k], right[k], right[k + 1], left[k + 1]);
  }
  mesh.AddQuad(corners[0], corners[1], right[0], left[0]);
  mesh.AddQuad(corners[2], corners[3], left[HalfRim], right[HalfRim]);
  const Id side = HalfRim + HalfRim / 2;
  for (Id k = HalfRim; k < 2 * HalfRim; ++k)
  {
    const bool isUpper = k < side;
    mesh.AddTriangle(corners[isUpper ? 3 : 0], left[k + 1], left[k]);
    mesh.AddTriangle(corners[isUpper ? 2 : 1], right[k], right[k + 1]);
  }
  mesh.AddTriangle(corners[3], corners[0], left[side]);
  mesh.AddTriangle(corners[1], corners[2], right[side]);
  return mesh;
}

/// Errors inside of faces, as parts of the largest distance.
struct FieldErrors
{
  double Sum = 0.0;
  double Largest = 0.0;

  void Add(const DistanceField& field, const DistanceField& truth)
  {
    const SurfaceMesh& mesh = *truth.Mesh;
    const double farthest =
      *std::max_element(truth.Distances, truth.Distances + mesh.GetNumberOfVertices());
    FaceProfile found(field);
    FaceProfile exact(truth);
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      found.Enter(f);
      exact.Enter(f);
      for (int i = 0; i < 5; ++i)
      {
        for (int j = 0; i + j < 5; ++j)
        {
          const Point2 p =
            exact.PlaceOf({ { (5 - i - j) / 6.0, (i + 0.5) / 6.0, (j + 0.5) / 6.0 } });
          const double error = std::abs(found.At(p) - exact.At(p)) / farthest;
          this->Sum += error;
          this->Largest = std::max(this->Largest, error);
        }
      }
    }
  }
};
}

/// With each vertex of a rim as the virtual source of the next one the largest errors are 13 and
/// 24 % of the largest distance.
TEST(Relays, OfRimsDoNotHideTheSource)
{
  const SurfaceMesh mesh = Build(PlateWithTwoHoles());
  const GeodesicGraph graph = BuildGraph(mesh, 0.01);
  const GraphSearch search(graph.View(), &mesh);
  FieldErrors linear;
  FieldErrors ofExact;
  FieldErrors ofGraph;
  for (Id source = 0; source < mesh.GetNumberOfVertices(); ++source)
  {
    const ExactField field(mesh, { VertexSource(source) });
    GraphSeed seed;
    seed.Vertex = source;
    SearchOptions options;
    options.Correct = true;
    SearchResult result;
    ASSERT_TRUE(search.Run({ seed }, options, result).IsOk());
    VirtualSources merged;
    FindVirtualSources(mesh, result, merged);
    linear.Add(field.Linear, field.Exact);
    ofExact.Add(field.Local, field.Exact);
    ofGraph.Add({ &mesh, result.Corrected.data(), nullptr, &merged }, field.Exact);
  }
  for (const FieldErrors* errors : { &ofExact, &ofGraph })
  {
    SCOPED_TRACE(errors == &ofExact ? "exact" : "graph");
    EXPECT_LT(errors->Sum, 0.25 * linear.Sum);
    EXPECT_LT(errors->Largest, 0.1);
  }
}

/// What is reached straight on over vertices of the graph has no relay, and keeps what it had.
TEST(Relays, AreNoneOnAConvexPlate)
{
  const SurfaceMesh mesh = Build(Plane(8, 8, 0.2));
  const GeodesicGraph graph = BuildGraph(mesh, 0.05);
  const GraphSearch search(graph.View(), &mesh);
  GraphSeed seed;
  seed.Vertex = 40;
  SearchOptions options;
  options.Correct = true;
  SearchResult result;
  ASSERT_TRUE(search.Run({ seed }, options, result).IsOk());
  VirtualSources found;
  FindVirtualSources(mesh, result, found);
  EXPECT_EQ(found.Offsets, result.Virtual.Offsets);
  EXPECT_EQ(found.Lengths, result.Virtual.Lengths);
  EXPECT_EQ(found.Angles, result.Virtual.Angles);
}
