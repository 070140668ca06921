// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Both engines against CGAL's exact geodesics, an independent implementation: always on generated
/// meshes, and on real-world meshes if available. Sources are vertices and points inside faces.

#include "GeneratedMesh.h"
#include "MeshFile.h"
#include "PeerCGAL.h"
#include "TestMeshes.h"

#include "dggExactGeodesics.h"
#include "dggSurfaceMesh.h"
#include "dggSurfacePoint.h"

#include <gtest/gtest.h>

#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace
{
constexpr double Tolerance = 1e-10;

struct Source
{
  dgg::Id Vertex = dgg::NoId; ///< vertex id; NoId for a point inside a face
  dgg::Id Face = dgg::NoId;
  std::array<double, 3> Barycentric{ { 0.2, 0.3, 0.5 } };
};

Source AtVertex(std::size_t vertex)
{
  Source source;
  source.Vertex = static_cast<dgg::Id>(vertex);
  return source;
}

Source InFace(std::size_t face, const std::array<double, 3>& barycentric)
{
  Source source;
  source.Face = static_cast<dgg::Id>(face);
  source.Barycentric = barycentric;
  return source;
}

std::vector<double> OurDistances(
  const dgg::SurfaceMesh& surface, const Source& source, dgg::ExactEngine engine)
{
  dgg::GeodesicSource geodesicSource;
  geodesicSource.Point = source.Vertex != dgg::NoId
    ? dgg::SurfacePoint::AtVertex(source.Vertex)
    : dgg::SurfacePoint::InFace(surface, source.Face, source.Barycentric);
  dgg::ExactOptions options;
  options.Engine = engine;
  dgg::ExactResult result;
  const dgg::Status status = dgg::ExactGeodesics(surface).Run({ geodesicSource }, options, result);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return result.Distances;
}

std::vector<double> TheirDistances(PeerCGAL& peer, const Source& source)
{
  if (source.Vertex != dgg::NoId)
  {
    peer.SetSourceVertex(source.Vertex);
  }
  else
  {
    peer.SetSourceInFace(source.Face, source.Barycentric);
  }
  return peer.ComputeDistances();
}

/// Expects that distances differ by at most Tolerance, relative to the distance, at every vertex.
void ExpectEqual(const std::vector<double>& ours, const std::vector<double>& theirs)
{
  ASSERT_EQ(ours.size(), theirs.size());
  std::size_t longer = 0;
  std::size_t shorter = 0;
  std::size_t unequallyReached = 0;
  std::size_t reached = 0;
  double worst = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    if (std::isfinite(ours[i]) != std::isfinite(theirs[i]))
    {
      ++unequallyReached;
    }
    else if (std::isfinite(ours[i]) && ours[i] != theirs[i])
    {
      const double relative = (ours[i] - theirs[i]) / std::max(ours[i], theirs[i]);
      longer += relative > Tolerance ? 1 : 0;
      shorter += relative < -Tolerance ? 1 : 0;
      worst = std::max(worst, std::abs(relative));
    }
    reached += std::isfinite(ours[i]) ? 1 : 0;
  }
  EXPECT_EQ(unequallyReached, 0u);
  EXPECT_EQ(longer, 0u) << "vertices farther than CGAL says; worst " << worst;
  EXPECT_EQ(shorter, 0u) << "vertices closer than CGAL says; worst " << worst;
  EXPECT_GT(reached, ours.size() / 2);
}

void Compare(const MeshArrays& mesh, const std::vector<Source>& sources)
{
  ASSERT_GT(mesh.GetNumberOfFaces(), 0u);
  dgg::SurfaceMesh surface;
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(mesh.Points.data(),
    static_cast<dgg::Offset>(mesh.GetNumberOfVertices()), mesh.Triangles.data(),
    static_cast<dgg::Offset>(mesh.GetNumberOfFaces()), surface);
  ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  PeerCGAL peer(mesh);
  ASSERT_EQ(peer.GetRefusal(), "");
  for (const Source& source : sources)
  {
    SCOPED_TRACE(source.Vertex != dgg::NoId ? "source vertex " + std::to_string(source.Vertex)
                                            : "source face " + std::to_string(source.Face));
    const std::vector<double> theirs = TheirDistances(peer, source);
    {
      SCOPED_TRACE("engine T");
      ExpectEqual(OurDistances(surface, source, dgg::ExactEngine::Triangle), theirs);
    }
    {
      SCOPED_TRACE("engine R");
      ExpectEqual(OurDistances(surface, source, dgg::ExactEngine::Reference), theirs);
    }
  }
}

struct GeneratedCase
{
  const char* Name;
  std::function<MeshArrays()> Make;
};

void PrintTo(const GeneratedCase& generated, std::ostream* stream)
{
  *stream << generated.Name;
}

MeshArrays ToArrays(const dggtest::TestMesh& mesh)
{
  return { mesh.Points, mesh.Triangles };
}

MeshArrays HillsWithHole()
{
  const auto keep = [](dgg::Id i, dgg::Id j) { return i < 11 || i >= 22 || j < 11 || j >= 22; };
  return ToArrays(dggtest::WithNoise(dggtest::Plate(32, 32, keep, 0.2), 0.2, 7));
}

MeshArrays Box(dgg::Id nx, dgg::Id ny, dgg::Id nz, double jitter)
{
  return ToArrays(dggtest::Box(nx, ny, nz, 0.25, 0.25, 0.25, jitter));
}

class AgainstCGAL : public testing::TestWithParam<GeneratedCase>
{
};

TEST_P(AgainstCGAL, SameDistances)
{
  const MeshArrays mesh = GetParam().Make();
  const std::size_t vertices = mesh.GetNumberOfVertices();
  const std::size_t faces = mesh.GetNumberOfFaces();
  Compare(mesh,
    { AtVertex(0), AtVertex(vertices / 3), AtVertex(vertices - 1),
      InFace(faces / 4, { 0.2, 0.3, 0.5 }), InFace(faces / 2, { 0.85, 0.1, 0.05 }),
      InFace(faces - 1, { 0.001, 0.499, 0.5 }) });
}

INSTANTIATE_TEST_SUITE_P(Generated, AgainstCGAL,
  testing::Values(GeneratedCase{ "BumpySphere", [] { return BumpySphere(4); } },
    GeneratedCase{ "RoughSphere", [] { return BumpySphere(3, 0.5); } },
    GeneratedCase{ "Torus", [] { return Torus(40, 24); } },
    GeneratedCase{ "FlatTorusTriangles", [] { return Torus(6, 60); } },
    GeneratedCase{ "HillsWithHole", HillsWithHole },
    GeneratedCase{ "JitteredCube", [] { return Box(8, 8, 8, 0.2); } },
    GeneratedCase{ "GridCube", [] { return Box(8, 8, 8, 0.0); } },
    GeneratedCase{ "GridBox", [] { return Box(4, 8, 12, 0.0); } },
    GeneratedCase{ "JitteredBox", [] { return Box(4, 8, 12, 0.2); } }),
  [](const testing::TestParamInfo<GeneratedCase>& info) { return info.param.Name; });

void CompareFile(const std::string& file)
{
  const MeshArrays mesh = ToArrays(ReadPolyData(file));
  Compare(mesh,
    { AtVertex(mesh.GetNumberOfVertices() / 3),
      InFace(mesh.GetNumberOfFaces() / 2, { 0.2, 0.3, 0.5 }) });
}

#ifdef DGG_EXTRA_DATA
class AgainstCGALOnScans : public testing::TestWithParam<const char*>
{
};

TEST_P(AgainstCGALOnScans, SameDistances)
{
  CompareFile(std::string(DGG_EXTRA_DATA) + "/" + GetParam() + ".ply");
}

// Manifold, oriented, and small enough for CGAL.
INSTANTIATE_TEST_SUITE_P(Real, AgainstCGALOnScans,
  testing::Values(
    "eight", "ellipsoid", "fertility", "fandisk", "kitten", "rocker_arm", "aneurysm", "armadillo"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });
#endif

#ifdef DGG_GLMARK2_BUNNY
TEST(AgainstCGALOnBunny, SameDistances)
{
  CompareFile(DGG_GLMARK2_BUNNY);
}
#endif
}
