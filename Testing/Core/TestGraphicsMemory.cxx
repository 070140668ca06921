// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics take no more memory than is asked for, at any time.
#include "../Benchmark/MemoryProbe.h"
#include "CurvedMeshes.h"
#include "GraphicsTestTools.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dggtest
{
TEST(GraphicsMemory, IsAskedForBeforeItIsTaken)
{
  // What has been asked for is never exceeded: while the surface is refined and cut, while the
  // equation is prepared, and while colours are found. Many regions that have nearly everything on
  // their left, too.
  const TestMesh sphere = Icosphere(4);
  for (const bool hasPoisson : { false, true })
  {
    for (const int regions : { 0, 100 })
    {
      Drawing drawing(sphere);
      const std::vector<double> two = { 0.0, 1.0 };
      drawing
        .Add(hasPoisson ? Poisson : Diffusion,
          { SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(40) }, two, two)
        .Width = 0.5;
      for (int k = 0; k < regions; ++k)
      {
        const std::array<Id, 3> corners = drawing.Mesh.GetTriangle(50 + 31 * k);
        drawing.Add(Region,
          { SurfacePoint::AtVertex(corners[0]), SurfacePoint::AtVertex(corners[2]),
            SurfacePoint::AtVertex(corners[1]) },
          { 0.1, 0.0, 0.0 }, {}, true);
      }
      drawing.Regions = { { { 1, 2, 3 }, { 0.5 } } };
      drawing.Options.IntrinsicDelaunay = hasPoisson;
      double asked = 4.0 * dgg::VectorGraphics::BytesPerFace * drawing.Mesh.GetNumberOfFaces();
      const MemoryProbe probe;
      const auto expectEnough = [&](const char* when) {
        EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), asked)
          << when << " " << hasPoisson << " " << regions;
      };
      int count = 0;
      drawing.Options.CheckMemory = [&](double bytes, double) {
        expectEnough("meanwhile");
        asked = std::max(asked, bytes);
        ++count;
        return dgg::Status::Success();
      };
      ASSERT_TRUE(drawing.Prepare(1).IsOk());
      expectEnough("prepared");
      EXPECT_EQ(count, 1 + regions);
      drawing.Surface = RefinedSurface(); // it is not needed any more
      ASSERT_TRUE(drawing.Solve().IsOk());
      expectEnough("solved");
      EXPECT_EQ(count, 2 + regions);
      EXPECT_LE(asked, 2.0 * static_cast<double>(probe.GetHeapPeak())); // nor far too much
    }
  }
}
}
