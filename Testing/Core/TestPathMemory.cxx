// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What finders of paths keep, and what they take for the next path.
#include "../Benchmark/MemoryProbe.h"
#include "CurvedMeshes.h"
#include "TestMeshes.h"

#include "dggExactPath.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace dggtest
{
TEST(PathMemory, TheNextPathTakesNothingForEachVertex)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(6));
  std::vector<dgg::SurfacePath> paths;
  const MemoryProbe all;
  dgg::ExactPathFinder finder(mesh);
  const auto find = [&](Id from, Id to) {
    const dgg::SurfacePoint target = dgg::SurfacePoint::AtVertex(to);
    return finder.Find(dgg::SurfacePoint::AtVertex(from), { target }, nullptr, paths).IsOk();
  };
  ASSERT_TRUE(find(0, 1));                                    // far apart
  const auto kept = static_cast<double>(all.GetHeapGrowth()); // 0 where it cannot be measured
  const auto counted = static_cast<double>(finder.GetMemorySize());
  EXPECT_LE(kept, 1.05 * counted); // but for the path, and some lists at work
  EXPECT_GE(kept, kept > 0.0 ? 0.8 * counted : 0.0);
  for (const Id v : { 20000, 30000 })
  {
    const MemoryProbe probe;
    ASSERT_TRUE(find(v, mesh.Destination(*mesh.FanBegin(v))));
    EXPECT_LT(probe.GetHeapPeak(), static_cast<std::size_t>(mesh.GetNumberOfVertices()));
  }
}
}
