// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Submeshes behave like their parent mesh; corridors around paths.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggPathCorridor.h"
#include "dggSurfaceRefinement.h"

namespace dggtest
{
namespace
{
using dgg::PathCorridor;
using dgg::SurfaceMesh;
using dgg::SurfacePath;
using dgg::SurfacePoint;

/// Returns meshes with degenerate faces, which multiply windows.
std::vector<NamedMesh> DegenerateMeshes()
{
  std::vector<NamedMesh> meshes{ { "Zipped", ZippedPlane(12) }, { "Collinear", CollinearPlane(12) },
    { "Collapsed", CollapsedSphere(3, 60, 9) }, { "CollapsedMore", CollapsedSphere(3, 300, 5) } };
  // Exclude the mesh whose points all coincide. On some of these meshes windows that are regarded
  // as regular propagate forever.
  std::vector<TestMesh> flattened = FlattenedMeshes();
  flattened.pop_back();
  for (TestMesh& mesh : flattened)
  {
    meshes.push_back({ "Flattened" + std::to_string(meshes.size()), std::move(mesh) });
  }
  return meshes;
}

/// Returns some faces of a mesh as a separate mesh.
SurfaceMesh PartOf(const SurfaceMesh& mesh, const std::vector<Id>& faces)
{
  std::vector<Id> triangles;
  std::vector<double> lengths;
  for (const Id f : faces)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      triangles.push_back(mesh.Origin(h));
      lengths.push_back(mesh.Length(h));
    }
  }
  SurfaceMesh part;
  EXPECT_TRUE(Ok(SurfaceMesh::FromLengths(mesh.GetNumberOfVertices(), triangles.data(),
    static_cast<dgg::Offset>(faces.size()), lengths.data(), part, { &mesh, faces.data() })));
  return part;
}

/// Returns a descending path along mesh edges, longer than the shortest path.
SurfacePath EdgePath(const SurfaceMesh& mesh, Id from, Id to)
{
  const std::vector<double> toGo = DistancesFrom(mesh, dgg::ExactEngine::Triangle, to);
  SurfacePath path;
  path.Points.push_back(SurfacePoint::AtVertex(from));
  for (Id v = from; v != to;)
  {
    Id next = dgg::NoId;
    Id face = dgg::NoId;
    double best = toGo[v];
    for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
    {
      for (const Id end : { mesh.Destination(*g), mesh.Apex(*g) })
      {
        if (toGo[end] < best)
        {
          best = toGo[end];
          next = end;
          face = SurfaceMesh::Face(*g);
        }
      }
    }
    if (next == dgg::NoId)
    {
      return SurfacePath(); // no closer neighbor among coincident points
    }
    path.Points.push_back(SurfacePoint::AtVertex(next));
    path.Faces.push_back(face);
    path.Length += dgg::MeasurePiece(mesh, path, path.Faces.size() - 1);
    v = next;
  }
  return path;
}
}

TEST(MeshParts, KnowWhatIsDegenerate)
{
  std::vector<NamedMesh> meshes = DegenerateMeshes();
  meshes.push_back({ "large soup", RandomSoup(80, 640, 1) });
  for (std::uint64_t seed = 1; seed <= 30; ++seed)
  {
    meshes.push_back({ "soup " + std::to_string(seed), RandomSoup(20, 40, seed) });
  }
  int solved = 0;
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    std::vector<Id> faces;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      if (!mesh.IsDropped(f))
      {
        faces.push_back(f);
      }
    }
    for (const bool isHalf : { false, true })
    {
      if (isHalf)
      {
        faces.resize(faces.size() / 2);
      }
      const SurfaceMesh part = PartOf(mesh, faces);
      bool isTurned = false;
      Id degenerate = 0;
      Id mollified = 0;
      for (std::size_t i = 0; i < faces.size(); ++i)
      {
        const auto f = static_cast<Id>(i);
        isTurned = isTurned || part.IsFlipped(f);
        EXPECT_EQ(part.IsDegenerate(f), mesh.IsDegenerate(faces[i])) << f;
        EXPECT_EQ(part.IsMollified(f), mesh.IsMollified(faces[i])) << f;
        degenerate += mesh.IsDegenerate(faces[i]) ? 1 : 0;
        mollified += mesh.IsMollified(faces[i]) ? 1 : 0;
        for (Id k = 0; k < 3 && !part.IsFlipped(f); ++k)
        {
          EXPECT_EQ(part.Length(3 * f + k), mesh.Length(3 * faces[i] + k)); // lengths are identical
          EXPECT_TRUE(!part.IsMollified(f) ||
            part.Kind(part.Origin(3 * f + k)) == dgg::VertexKind::Irregular);
        }
      }
      EXPECT_EQ(part.GetNumberOfDegenerateFaces(), degenerate);
      EXPECT_EQ(part.GetNumberOfMollifiedFaces(), mollified);
      EXPECT_EQ(part.GetMollification(), mollified > 0 ? mesh.GetMollification() : 0.0);
      if (isHalf || isTurned) // reversed submeshes of a nonorientable mesh
      {
        continue;
      }
      ++solved;
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        EXPECT_EQ(part.Kind(v), mesh.Kind(v)) << v;
      }
      const std::vector<dgg::GeodesicSource> source{ VertexSource(mesh.Origin(3 * faces[0])) };
      const dgg::ExactResult expected = Solve(mesh, dgg::ExactEngine::Triangle, source);
      const dgg::ExactResult found = Solve(part, dgg::ExactEngine::Triangle, source);
      EXPECT_EQ(found.Distances, expected.Distances);
      EXPECT_EQ(found.NumberOfWindows, expected.NumberOfWindows);
    }
  }
  EXPECT_GT(solved, 20);
}

/// Degenerate faces remain degenerate when they are split along paths.
TEST(MeshParts, RefinedFacesKnowWhatIsDegenerate)
{
  for (const NamedMesh& named : DegenerateMeshes())
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<Id> ends = SomeVertices(mesh, 4, 9);
    dgg::SubMesh refined;
    ASSERT_TRUE(
      dgg::RefineAlongPaths(mesh, { PathBetween(mesh, ends[1], ends[2]) }, {}, refined).IsOk());
    SurfaceMesh fine;
    ASSERT_TRUE(refined.Build(mesh, fine).IsOk());
    EXPECT_GE(fine.GetNumberOfDegenerateFaces(), mesh.GetNumberOfDegenerateFaces());
    for (Id f = 0; f < fine.GetNumberOfFaces(); ++f)
    {
      EXPECT_TRUE(fine.IsDegenerate(f) || !mesh.IsDegenerate(refined.Faces[f])) << f;
      EXPECT_TRUE(fine.IsMollified(f) || !mesh.IsMollified(refined.Faces[f])) << f;
    }
    EXPECT_GE(fine.GetMollification(), mesh.GetMollification());
  }
}

/// Among degenerate faces the solver also terminates in a corridor, and finds paths as short as on
/// the whole mesh.
TEST(PathCorridor, AmongFacesWithoutArea)
{
  for (const NamedMesh& named : DegenerateMeshes())
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    PathCorridor corridor(mesh);
    int paths = 0;
    const std::vector<Id> ends = SomeVertices(mesh, 12, 5);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const SurfacePath shortest = PathBetween(mesh, ends[i], ends[i + 1]);
      SurfacePath path = EdgePath(mesh, ends[i], ends[i + 1]);
      if (path.Faces.size() < 2)
      {
        continue;
      }
      ++paths;
      const double before = path.Length;
      const bool isShorter = corridor.Shorten(0.5, path);
      EXPECT_EQ(isShorter, path.Length < before);
      EXPECT_TRUE(dgg::CheckPath(mesh, path).IsOk());
      EXPECT_FALSE(corridor.IsStopped());
      EXPECT_NEAR(path.Length, shortest.Length, 1e-9 * shortest.Length);
    }
    EXPECT_GE(paths, 3); // few neighbors at coincident points are closer
  }
}
}
