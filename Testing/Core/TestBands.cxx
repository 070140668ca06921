// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces cut along isolines: every face lies between two levels.
#include "FieldChecks.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggBandMarching.h"
#include "dggBands.h"
#include "dggFaceEnvelope.h"
#include "dggIsolines.h"
#include "dggUnfolding.h"

#include <set>

using namespace dgg;
using namespace dggtest;

namespace
{
/// Isolines and the bands between them.
struct BandCase
{
  BandCase(const DistanceField& field, const std::vector<double>& levels, double tolerance = 0.0)
    : Field(field)
  {
    IsolineOptions options;
    options.ChordTolerance = tolerance;
    EXPECT_TRUE(Ok(TraceIsolines(field, levels, options, {}, {}, this->Lines)));
    EXPECT_TRUE(Ok(MakeBands(field, levels, this->Lines, {}, this->Found)));
    EXPECT_EQ(static_cast<Id>(this->Found.BandOf.size()), this->Found.Surface.GetNumberOfFaces());
    EXPECT_EQ(
      static_cast<Id>(this->Found.Distances.size()), this->Found.Surface.GetNumberOfVertices());
  }

  double AreaOf(Id f) const
  {
    const double* lengths = this->Found.Surface.Lengths.data() + 3 * static_cast<std::size_t>(f);
    return TriangleArea(lengths[0], lengths[1], lengths[2]);
  }
  double AreaOfBand(Id band) const
  {
    double sum = 0.0;
    for (Id f = 0; f < this->Found.Surface.GetNumberOfFaces(); ++f)
    {
      sum += this->Found.BandOf[f] == band ? this->AreaOf(f) : 0.0;
    }
    return sum;
  }
  double AreaOfAllBands() const
  {
    double sum = 0.0;
    for (Id band = 0; band <= static_cast<Id>(this->Found.Levels.size()); ++band)
    {
      sum += this->AreaOfBand(band);
    }
    return sum;
  }
  double AreaOfReachedFaces() const
  {
    const SurfaceMesh& mesh = *this->Field.Mesh;
    double sum = 0.0;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      sum += this->Field.IsReached(f)
        ? TriangleArea(mesh.Length(3 * f), mesh.Length(3 * f + 1), mesh.Length(3 * f + 2))
        : 0.0;
    }
    return sum;
  }
  /// Returns the distance by which a value lies outside the band of a face; 0 inside.
  double MissOf(Id f, double distance) const
  {
    const std::vector<double>& levels = this->Found.Levels;
    const Id band = this->Found.BandOf[f];
    const double below = band > 0 ? levels[band - 1] - distance : 0.0;
    const double above = band < static_cast<Id>(levels.size()) ? distance - levels[band] : 0.0;
    return std::max({ 0.0, below, above });
  }

  DistanceField Field;
  Isolines Lines;
  Bands Found;
};

/// Returns levels over the range of a field, unsorted, one of them equal to the value of a vertex.
std::vector<double> LevelsOf(const DistanceField& field, int count)
{
  double least = Infinity;
  double greatest = -Infinity;
  const Id vertices = field.Mesh->GetNumberOfVertices();
  for (Id v = 0; v < vertices; ++v)
  {
    least = std::min(least, field.Distances[v]);
    greatest = field.Distances[v] < Infinity ? std::max(greatest, field.Distances[v]) : greatest;
  }
  std::vector<double> levels;
  for (int i = count; i > 0; --i)
  {
    levels.push_back(least + (greatest - least) * i / (count + 1));
  }
  const double middle = field.Distances[vertices / 2];
  levels.push_back(middle < Infinity ? middle : levels[0]);
  return levels;
}

/// Checks the invariants of bands: they cover the reached faces once, and no corner lies beyond a
/// level.
void ExpectSound(const BandCase& test, const std::string& what)
{
  const SubMesh& surface = test.Found.Surface;
  const double area = test.AreaOfReachedFaces();
  EXPECT_NEAR(test.AreaOfAllBands(), area, 1e-10 * area) << what;
  const double close = 1e-8 * test.Field.Mesh->GetMaximumEdgeLength();
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    EXPECT_EQ(test.Found.BandOf[f] != NoId, test.Field.IsReached(surface.Faces[f])) << what;
    for (Id h = 3 * f; h < 3 * f + 3 && test.Found.BandOf[f] != NoId; ++h)
    {
      EXPECT_LE(test.MissOf(f, test.Found.Distances[surface.Triangles[h]]), close) << what;
    }
  }
  SurfaceMesh cut;
  const Status status = surface.Build(*test.Field.Mesh, cut);
  EXPECT_TRUE(status.IsOk()) << what << ": " << status.GetMessage();
}

/// Expects the distances at the midpoints of faces and edges to lie in their band, up to the
/// tolerance. Returns the largest difference.
double LargestMiss(const BandCase& test)
{
  const SubMesh& surface = test.Found.Surface;
  FaceEnvelope envelope(test.Field);
  double largest = 0.0;
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    if (test.Found.BandOf[f] == NoId)
    {
      continue;
    }
    envelope.Enter(surface.Faces[f]);
    std::array<Point2, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      std::array<double, 3> b{};
      EXPECT_TRUE(FindInFace(
        *test.Field.Mesh, surface.Points[surface.Triangles[3 * f + k]], surface.Faces[f], b));
      corners[k] = envelope.PlaceOf(b);
    }
    for (const std::array<double, 3>& b :
      { std::array<double, 3>{ { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } },
        std::array<double, 3>{ { 0.5, 0.5, 0.0 } }, std::array<double, 3>{ { 0.0, 0.5, 0.5 } },
        std::array<double, 3>{ { 0.5, 0.0, 0.5 } } })
    {
      Point2 p;
      for (int k = 0; k < 3; ++k)
      {
        p.X += b[k] * corners[k].X;
        p.Y += b[k] * corners[k].Y;
      }
      largest = std::max(largest, test.MissOf(f, envelope.At(p)));
    }
  }
  return largest;
}
}

TEST(Bands, RingsInThePlaneHaveTheirAreas)
{
  // The source is the center of a square.
  const SurfaceMesh mesh = Build(Plane(10, 10, 0.0));
  const ExactField field(mesh, { VertexSource(60) });
  const double tolerance = 1e-4;
  for (const DistanceField* f : { &field.Exact, &field.Local })
  {
    const std::vector<double> levels{ 1.0, 4.9, 2.5, 2.5, 0.3 };
    const BandCase test(*f, levels, tolerance);
    ExpectSound(test, "plane");
    ASSERT_EQ(test.Found.Levels, (std::vector<double>{ 0.3, 1.0, 2.5, 4.9 }));
    double inner = 0.0;
    for (Id band = 0; band < 4; ++band)
    {
      // The bands are polygons inscribed in the circles: their width shrinks by 2/3 of the sagitta
      // along the rim.
      const double outer = test.Found.Levels[band];
      const double area = Pi * (outer * outer - inner * inner);
      EXPECT_NEAR(test.AreaOfBand(band), area, tolerance * 2.0 * Pi * (inner + outer));
      EXPECT_NE(test.AreaOfBand(band), area);
      inner = outer;
    }
    EXPECT_NEAR(test.AreaOfBand(4), 100.0 - Pi * 4.9 * 4.9, tolerance * 2.0 * Pi * 4.9);
    EXPECT_LT(LargestMiss(test), 1.01 * tolerance);
  }
}

TEST(Bands, VerticesOnLinesAreExactlyAtTheLevel)
{
  const SurfaceMesh mesh = Build(Terrain(14, 0.6, 3));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels = LevelsOf(field.Exact, 9);
  const BandCase test(field.Exact, levels);
  const SubMesh& surface = test.Found.Surface;
  std::set<double> found;
  for (const std::vector<Id>& path : surface.Paths) // parts of lines
  {
    for (const Id v : path)
    {
      EXPECT_EQ(test.Found.Distances[v], test.Found.Distances[path[0]]);
      found.insert(test.Found.Distances[v]);
    }
  }
  EXPECT_EQ(found, std::set<double>(levels.begin(), levels.end()));
  for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
  {
    EXPECT_LT(test.Found.Distances[v], Infinity);
  }
}

TEST(Bands, FacesLieBetweenTheLevels)
{
  int close = 0;
  for (const NamedMesh& named : DefectMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const ExactField field(mesh, { VertexSource(0) });
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      const BandCase test(*f, LevelsOf(*f, 8));
      const double area = test.AreaOfReachedFaces();
      EXPECT_NEAR(test.AreaOfAllBands(), area, 1e-9 * area) << named.Name;
    }
  }
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const ExactField field(mesh, { VertexSource(0) });
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      const BandCase test(*f, LevelsOf(*f, 8));
      ExpectSound(test, named.Name);
      if (f != &field.Local)
      {
        // Pieces that miss the tolerance are counted as fallbacks, unless another source is nearer
        // for less than a step along an arc.
        const double factor = test.Lines.Fallbacks == 0 ? 4e-3 : 5e-2;
        EXPECT_LT(LargestMiss(test), factor * mesh.GetMeanEdgeLength()) << named.Name;
        close += test.Lines.Fallbacks == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(close, 20);
}

namespace
{
using dgg::BandMarching;
using dgg::BandSource;
using dgg::Point3;
using dgg::VoxelBand;

struct Cloud
{
  std::vector<Point3> Points;
  std::vector<double> Radii;
};

/// Adds a square of n x n points with sides of length 1, in a slanted plane at a height.
void AddSquare(Cloud& cloud, int n, double height, double radius)
{
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double x = static_cast<double>(i) / (n - 1);
      const double y = static_cast<double>(j) / (n - 1);
      cloud.Points.push_back({ x, 0.8 * y - 0.6 * height, 0.6 * y + 0.8 * height });
      cloud.Radii.push_back(radius);
    }
  }
}

/// Returns the distances of all points.
std::vector<double> MarchIn(
  const Cloud& cloud, double voxelSize, const std::vector<BandSource>& sources)
{
  VoxelBand band;
  EXPECT_TRUE(Ok(band.Build(cloud.Points, cloud.Radii, voxelSize, 0, {})));
  BandMarchingResult result;
  EXPECT_TRUE(Ok(BandMarching(band).Run(sources, cloud.Points, {}, result)));
  return result.Distances;
}

/// Returns the mean relative error of distances from the first point. Straight distances serve as
/// truth if no other truth is known.
double MeanError(const Cloud& cloud, double voxelSize)
{
  const std::vector<double> distances = MarchIn(cloud, voxelSize, { { cloud.Points[0], 0.0 } });
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 1; i < cloud.Points.size(); ++i)
  {
    const double truth = dgg::Norm(cloud.Points[i] - cloud.Points[0]);
    if (truth > 0.2)
    {
      sum += std::abs(distances[i] - truth) / truth;
      ++count;
    }
  }
  return sum / count;
}
}

TEST(BandMarching, PlaneConvergesToFirstOrder)
{
  Cloud cloud;
  AddSquare(cloud, 60, 0.0, 0.03);
  const double coarse = MeanError(cloud, 0.02);
  const double fine = MeanError(cloud, 0.01);
  EXPECT_LT(coarse, 0.08);
  EXPECT_LT(fine, 0.7 * coarse);
}

TEST(BandMarching, SheetsThatDoNotTouchStayApart)
{
  Cloud cloud;
  AddSquare(cloud, 40, 0.0, 0.04);
  AddSquare(cloud, 40, 0.12, 0.04);
  const std::vector<double> distances = MarchIn(cloud, 0.01, { { cloud.Points[7], 0.0 } });
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    EXPECT_EQ(distances[i] < dgg::Infinity, i < 1600U) << i;
  }
}

TEST(BandMarching, OffsetsAndTheNearestSource)
{
  Cloud cloud;
  AddSquare(cloud, 40, 0.0, 0.05);
  const Point3 a = cloud.Points[0];
  const Point3 b = cloud.Points.back();
  const std::vector<double> both = MarchIn(cloud, 0.02, { { a, 0.25 }, { b, 0.0 } });
  const std::vector<double> first = MarchIn(cloud, 0.02, { { a, 0.25 } });
  const std::vector<double> second = MarchIn(cloud, 0.02, { { b, 0.0 } });
  for (std::size_t i = 0; i < both.size(); ++i)
  {
    EXPECT_NEAR(both[i], std::min(first[i], second[i]), 0.03) << i;
  }
  EXPECT_EQ(first[0], 0.25);
}

// A strip that turns back below itself, almost as close as two layers may be.
TEST(BandMarching, SheetsSideBySideAreNotMixed)
{
  constexpr double Size = 0.02;
  constexpr double Radius = 0.9 * Size;
  for (const double gap : { 2.85 * Size, 2.95 * Size, 3.05 * Size })
  {
    Cloud cloud;
    std::vector<double> truths;
    const double turn = 1.0 + 0.5 * Pi * gap;
    for (double along = 0.0; along < 1.0 + turn; along += 0.25 * Size)
    {
      for (double across = 0.0; across < 5.0 * Size; across += 0.25 * Size)
      {
        Point3 p{ along, across, 0.0 };
        if (along >= turn)
        {
          p = { 1.0 - (along - turn), across, gap };
        }
        else if (along > 1.0)
        {
          const double angle = (along - 1.0) / (0.5 * gap);
          p = { 1.0 + 0.5 * gap * std::sin(angle), across, 0.5 * gap * (1.0 - std::cos(angle)) };
        }
        cloud.Points.push_back(p);
        cloud.Radii.push_back(Radius);
        truths.push_back(along);
      }
    }
    for (const double height : { 0.0, 0.3, 0.6, 0.9 })
    {
      const Point3 source = cloud.Points[0] + Point3{ 0.0, 0.0, height * Size };
      const std::vector<double> distances = MarchIn(cloud, Size, { { source, 0.0 } });
      for (std::size_t i = 0; i < distances.size(); ++i)
      {
        ASSERT_NEAR(distances[i], truths[i], 8.0 * Size) << gap / Size << " " << height << " " << i;
      }
    }
  }
}
