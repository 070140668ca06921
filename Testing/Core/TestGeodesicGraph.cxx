// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Signature and checksum of the flat arrays of a graph.
#include "SearchChecks.h"
#include "TestMeshes.h"

#include "dggGeodesicGraph.h"

#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::Buffer;
using dgg::GeodesicGraph;
using dgg::GraphView;

template <typename T>
Buffer<T> Copy(const Buffer<T>& original)
{
  Buffer<T> copy(original.Size());
  for (std::size_t i = 0; i < original.Size(); ++i)
  {
    copy[i] = original[i];
  }
  return copy;
}

GeodesicGraph Copy(const GeodesicGraph& original)
{
  GeodesicGraph copy;
  copy.Info = original.Info;
  copy.Offsets = Copy(original.Offsets);
  copy.Targets = Copy(original.Targets);
  copy.Lengths = Copy(original.Lengths);
  copy.WideLengths = Copy(original.WideLengths);
  copy.Angles = Copy(original.Angles);
  copy.ArrivalAngles = Copy(original.ArrivalAngles);
  return copy;
}

class GraphArrays : public testing::Test
{
protected:
  static GeodesicGraph Sound(double accuracy = 0.05)
  {
    return BuildGraph(Build(Terrain(6, 0.4, 3)), accuracy);
  }
};
}

TEST_F(GraphArrays, ChecksumCoversEveryArray)
{
  const GeodesicGraph sound = Sound();
  std::set<std::uint64_t> checksums{ dgg::ComputeChecksum(sound.View()) };
  EXPECT_EQ(dgg::ComputeChecksum(Copy(sound).View()), *checksums.begin());
  const std::vector<std::function<void(GeodesicGraph&)>> changes{
    [](GeodesicGraph& g) { ++g.Offsets[3]; },
    [](GeodesicGraph& g) { ++g.Targets[10]; },
    [](GeodesicGraph& g) { g.Lengths[10] = std::nextafter(g.Lengths[10], 0.0f); },
    [](GeodesicGraph& g) { g.Angles[10] = std::nextafter(g.Angles[10], 0.0f); },
    [](GeodesicGraph& g) { g.ArrivalAngles[10] = std::nextafter(g.ArrivalAngles[10], 0.0f); },
    [](GeodesicGraph& g) { std::swap(g.Targets[10], g.Targets[11]); },
    [](GeodesicGraph& g) { std::swap(g.Angles, g.ArrivalAngles); },
    [](GeodesicGraph& g) { ++g.Targets[g.Targets.Size() - 1]; },
  };
  for (const auto& change : changes)
  {
    GeodesicGraph graph = Copy(sound);
    change(graph);
    checksums.insert(dgg::ComputeChecksum(graph.View()));
  }
  EXPECT_EQ(checksums.size(), changes.size() + 1);
  EXPECT_EQ(dgg::ComputeChecksum(GraphView()), dgg::ComputeChecksum(GeodesicGraph().View()));
}

TEST_F(GraphArrays, SignatureDistinguishesSurfaces)
{
  const TestMesh mesh = Plane(3, 3);
  std::set<dgg::Signature> signatures;
  const auto insert = [&](const TestMesh& m) {
    return signatures
      .insert(dgg::ComputeSignature(
        m.Points.data(), m.GetNumberOfVertices(), m.Triangles.data(), m.GetNumberOfFaces()))
      .second;
  };
  EXPECT_TRUE(insert(mesh));
  EXPECT_FALSE(insert(Plane(3, 3)));
  const auto expectNew = [&](const std::function<void(TestMesh&)>& change) {
    TestMesh changed = mesh;
    change(changed);
    EXPECT_TRUE(insert(changed));
  };
  // Every coordinate counts, down to the last bit and the sign of zero.
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    expectNew([=](TestMesh& m) { m.Points[i] = std::nextafter(m.Points[i], 100.0); });
  }
  expectNew([](TestMesh& m) { m.Points[2] = -0.0; });
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    expectNew([=](TestMesh& m) { m.Triangles[i] = (m.Triangles[i] + 1) % 16; });
  }
  expectNew([](TestMesh& m) { std::swap(m.Triangles[1], m.Triangles[2]); });
  // Where points end and triangles begin, and zeros at an end.
  expectNew([](TestMesh& m) { m.AddPoint(0.0, 0.0, 0.0); });
  expectNew([](TestMesh& m) { m.Triangles.resize(m.Triangles.size() - 3); });
}

}
