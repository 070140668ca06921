// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsFragments.h"

#include <array>
#include <cstddef>

namespace dgg
{
namespace
{
/// Returns the centroids of the parts of a triangle divided by lines parallel to its sides, in
/// barycentric coordinates: first of upright parts, then of inverted parts.
std::vector<std::array<double, 3>> FindCentroids(int division)
{
  std::vector<std::array<double, 3>> centroids;
  for (const int third : { 1, 2 })
  {
    const int sum = division - third;
    for (int i = 0; i <= sum; ++i)
    {
      for (int j = 0; i + j <= sum; ++j)
      {
        const double scale = 1.0 / (3.0 * division);
        centroids.push_back({ { scale * (3 * i + third), scale * (3 * j + third),
          scale * (3 * (sum - i - j) + third) } });
      }
    }
  }
  return centroids;
}
}

GraphicsFragments MakeFragments(const SurfaceMesh& mesh, const SubMesh& surface,
  const std::vector<Id>& faces, const std::vector<double>& values, int channels, int division)
{
  GraphicsFragments fragments;
  const std::vector<std::array<double, 3>> centroids = FindCentroids(division);
  const std::size_t count = faces.size() * centroids.size();
  const auto width = static_cast<std::size_t>(channels);
  fragments.Places.reserve(count);
  fragments.Faces.reserve(count);
  fragments.Values.reserve(count * width);
  for (const Id face : faces)
  {
    for (const std::array<double, 3>& centroid : centroids)
    {
      fragments.Places.push_back(surface.ToParent(mesh, face, centroid));
      fragments.Faces.push_back(surface.Faces[face]);
      for (std::size_t c = 0; c < width; ++c)
      {
        double value = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const auto corner = static_cast<std::size_t>(surface.Triangles[3 * face + k]);
          value += centroid[k] * values[width * corner + c];
        }
        fragments.Values.push_back(value);
      }
    }
  }
  return fragments;
}
}
