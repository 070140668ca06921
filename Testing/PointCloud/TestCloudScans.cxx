// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds of real-world scans, with default options. Compiled only if DGG_EXTRA_DATA is defined.
#include "CloudShapes.h"

#ifdef DGG_EXTRA_DATA

#include <fstream>
#include <sstream>

namespace
{
using namespace cloudtest;
using dgg::CloudGraph;
using dgg::CloudGraphStatistics;

/// Returns the points of a binary PLY file of three floats each.
Cloud ReadPoints(const std::string& name)
{
  std::ifstream file(std::string(DGG_EXTRA_DATA) + "/clouds/" + name, std::ios::binary);
  Cloud cloud;
  std::size_t count = 0;
  std::string line;
  while (std::getline(file, line) && line != "end_header")
  {
    std::istringstream words(line);
    std::string first;
    std::string second;
    words >> first >> second;
    if (first == "element" && second == "vertex")
    {
      words >> count;
    }
  }
  std::vector<float> values(3 * count);
  file.read(reinterpret_cast<char*>(values.data()),
    static_cast<std::streamsize>(values.size() * sizeof(float)));
  cloud.Points.assign(values.begin(), values.end());
  EXPECT_TRUE(file.good()) << name;
  return cloud;
}

struct Scan
{
  const char* Name;
  double Main; ///< smallest fraction of points in the main component
};
}

class CloudScans : public testing::TestWithParam<Scan>
{
};

TEST_P(CloudScans, DefaultsWork)
{
  const Cloud cloud = ReadPoints(GetParam().Name);
  ASSERT_GT(cloud.GetSize(), 1000);
  CloudGraphStatistics statistics;
  const CloudGraph graph = BuildGraph(
    cloud, [](dgg::CloudGraphOptions& options) { options.Parallel = WithThreads(2); }, &statistics);
  ASSERT_FALSE(graph.ComponentSizes.empty());
  EXPECT_GE(graph.ComponentSizes[0], GetParam().Main * cloud.GetSize());
  const auto edges = static_cast<double>(graph.Graph.Targets.Size());
  EXPECT_LT(edges, 200.0 * cloud.GetSize());
  EXPECT_LT(statistics.BandMemory, 100U << 20);
  // No edge bridges a gap: along an edge there is a point every few spacings.
  const dgg::GraphView view = graph.Graph.View();
  int far = 0;
  for (Id v = 0; v < view.NumberOfVertices; v += 7)
  {
    for (dgg::Offset e = view.Offsets[v]; e < view.Offsets[v + 1]; ++e)
    {
      const Id t = view.Targets[e];
      const Point3 middle = 0.5 * (cloud.At(v) + cloud.At(t));
      const double ball = std::max(graph.Radii[v], graph.Radii[t]);
      // Distance of the midpoint from the nearest end or neighbor of the first end.
      double nearest = 0.5 * dgg::Norm(cloud.At(v) - cloud.At(t));
      for (dgg::Offset k = view.Offsets[v]; k < view.Offsets[v + 1]; ++k)
      {
        nearest = std::min(nearest, dgg::Norm(cloud.At(view.Targets[k]) - middle));
      }
      far += nearest > 2.5 * ball ? 1 : 0;
    }
  }
  EXPECT_EQ(far, 0);
}

INSTANTIATE_TEST_SUITE_P(All, CloudScans,
  testing::Values(Scan{ "bunny_points.ply", 0.999 }, Scan{ "kitten.ply", 1.0 },
    Scan{ "lidar_samp11.ply", 0.97 }, Scan{ "milk_carton.ply", 0.97 },
    Scan{ "rops_scan.ply", 0.75 }),
  [](const testing::TestParamInfo<Scan>& info) {
    const std::string name = info.param.Name;
    return name.substr(0, name.find('.'));
  });

#endif
