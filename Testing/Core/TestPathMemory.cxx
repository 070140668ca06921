// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What finders of paths take for the next path.
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
  dgg::ExactPathFinder finder(mesh);
  const auto find = [&](Id from, Id to) {
    const dgg::SurfacePoint target = dgg::SurfacePoint::AtVertex(to);
    return finder.Find(dgg::SurfacePoint::AtVertex(from), { target }, nullptr, paths).IsOk();
  };
  ASSERT_TRUE(find(0, 1)); // far apart
  for (const Id v : { 20000, 30000 })
  {
    const MemoryProbe probe;
    ASSERT_TRUE(find(v, mesh.Destination(*mesh.FanBegin(v))));
    EXPECT_LT(probe.GetHeapPeak(), static_cast<std::size_t>(mesh.GetNumberOfVertices()));
  }
}
}
