// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces cut along isolines: every face lies between two levels.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FieldChecks.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggBands.h"
#include "dggFaceProfile.h"
#include "dggIsolines.h"
#include "dggUnfolding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
    Status status = TraceIsolines(field, levels, options, {}, {}, this->Lines);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
    status = MakeBands(field, levels, this->Lines, {}, this->Found);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
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
  /// How far a distance is from the band of a face.
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

/// Levels over the whole range of a field, given out of order, one of them that of a vertex.
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

/// What holds of bands always: they cover what is reached, once, and no corner is beyond a level.
void ExpectSound(const BandCase& test, const std::string& what)
{
  const RefinedSurface& surface = test.Found.Surface;
  double sum = 0.0;
  for (Id band = 0; band <= static_cast<Id>(test.Found.Levels.size()); ++band)
  {
    sum += test.AreaOfBand(band);
  }
  const double area = test.AreaOfReachedFaces();
  EXPECT_NEAR(sum, area, 1e-10 * area) << what;
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

/// The distances in the middle of faces and edges are those of the band, up to the tolerance;
/// returns the largest difference.
double LargestMiss(const BandCase& test)
{
  const RefinedSurface& surface = test.Found.Surface;
  FaceProfile profile(test.Field);
  double largest = 0.0;
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    if (test.Found.BandOf[f] == NoId)
    {
      continue;
    }
    profile.Enter(surface.Faces[f]);
    std::array<Point2, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      std::array<double, 3> b{};
      EXPECT_TRUE(FindInFace(
        *test.Field.Mesh, surface.Points[surface.Triangles[3 * f + k]], surface.Faces[f], b));
      corners[k] = profile.PlaceOf(b);
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
      largest = std::max(largest, test.MissOf(f, profile.At(p)));
    }
  }
  return largest;
}
}

TEST(Bands, RingsInThePlaneHaveTheirAreas)
{
  // From the centre of a square.
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
      // Polygons within the circles: smaller by 2/3 of the sagitta along the rim.
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
  const RefinedSurface& surface = test.Found.Surface;
  ASSERT_EQ(surface.Paths.size(), test.Lines.Lines.size());
  for (std::size_t p = 0; p < surface.Paths.size(); ++p)
  {
    for (const Id v : surface.Paths[p])
    {
      EXPECT_EQ(test.Found.Distances[v], levels[test.Lines.Levels[p]]);
    }
  }
  for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
  {
    EXPECT_LT(test.Found.Distances[v], Infinity);
  }
}

TEST(Bands, FacesLieBetweenTheLevels)
{
  int close = 0;
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
        // Pieces that are not as close as they should be are known, but for another source that is
        // nearer for less than a step along an arc.
        const double factor = test.Lines.Fallbacks == 0 ? 4e-3 : 5e-2;
        EXPECT_LT(LargestMiss(test), factor * mesh.GetMeanEdgeLength()) << named.Name;
        close += test.Lines.Fallbacks == 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(close, 20);
}

TEST(Bands, DefectsAreSurvived)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const ExactField field(mesh, { VertexSource(0) });
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      const BandCase test(*f, LevelsOf(*f, 8));
      double sum = 0.0;
      for (Id band = 0; band <= static_cast<Id>(test.Found.Levels.size()); ++band)
      {
        sum += test.AreaOfBand(band);
      }
      const double area = test.AreaOfReachedFaces();
      EXPECT_NEAR(sum, area, 1e-9 * area) << named.Name;
    }
  }
}

TEST(Bands, WhatIsNotReachedIsLeftOut)
{
  const SurfaceMesh mesh = Build(SeveralComponents());
  const ExactField field(mesh, { VertexSource(0) });
  const BandCase test(field.Exact, { 0.5, 1.0, 2.0 });
  ExpectSound(test, "components");
  EXPECT_GT(std::count(test.Found.BandOf.begin(), test.Found.BandOf.end(), NoId), 50);
}

TEST(Bands, NoLevelsIsOneBand)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  const ExactField field(mesh, { VertexSource(0) });
  for (const std::vector<double>& levels : { std::vector<double>{}, std::vector<double>{ 99.0 } })
  {
    const BandCase test(field.Exact, levels);
    EXPECT_EQ(test.Found.Surface.GetNumberOfFaces(), mesh.GetNumberOfFaces());
    EXPECT_EQ(
      std::count(test.Found.BandOf.begin(), test.Found.BandOf.end(), 0), mesh.GetNumberOfFaces());
  }
}

TEST(Bands, TellProgressWhileTheyAreCut)
{
  const SurfaceMesh mesh = Build(Icosphere(5)); // 20480 faces
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels{ 0.5, 1.0 };
  const BandCase test(field.Exact, levels);
  std::vector<double> told;
  double limit = 2.0;
  const ProgressCallback watch = [&](double done) {
    told.push_back(done);
    return done < limit;
  };
  Bands bands;
  ASSERT_TRUE(MakeBands(field.Exact, levels, test.Lines, watch, bands).IsOk());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(
    std::count_if(told.begin(), told.end(), [](double d) { return d > 0.0 && d < 0.5; }), 9);
  EXPECT_EQ(told.back(), 1.0);
  limit = 0.3;
  told.clear();
  EXPECT_TRUE(MakeBands(field.Exact, levels, test.Lines, watch, bands).IsAborted());
  EXPECT_LT(told.back(), 0.4);
  EXPECT_EQ(bands.Surface.GetNumberOfFaces(), 0);
  EXPECT_TRUE(bands.BandOf.empty());
}

TEST(Bands, ManyLevelsInOneFace)
{
  const SurfaceMesh mesh = Build(Plane(1, 1, 0.0)); // two faces
  const ExactField field(mesh, { { SurfacePoint::InFace(mesh, 0, { { 0.3, 0.3, 0.4 } }), 0.0 } });
  for (const DistanceField* f : { &field.Exact, &field.Linear })
  {
    const std::vector<double> levels = LevelsOf(*f, 1000);
    const BandCase test(*f, levels, 1e-4); // chords of neighbours must not cross
    ExpectSound(test, "many levels");
    EXPECT_GT(test.Found.Surface.GetNumberOfFaces(), 1999);
    // No band is lost.
    for (Id band = 0; band < static_cast<Id>(test.Found.Levels.size()); ++band)
    {
      EXPECT_GT(test.AreaOfBand(band), 0.0) << band;
    }
    std::vector<double> told;
    double limit = 2.0;
    const ProgressCallback watch = [&](double done) {
      told.push_back(done);
      return done < limit;
    };
    Bands bands;
    ASSERT_TRUE(MakeBands(*f, levels, test.Lines, watch, bands).IsOk());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GT(
      std::count_if(told.begin(), told.end(), [](double d) { return d > 0.0 && d < 0.5; }), 3);
    limit = 0.2;
    told.clear();
    EXPECT_TRUE(MakeBands(*f, levels, test.Lines, watch, bands).IsAborted());
    EXPECT_LT(told.back(), 0.35);
    EXPECT_TRUE(bands.BandOf.empty());
  }
}

TEST(Bands, RepeatedLevelsChangeNothing)
{
  const SurfaceMesh mesh = Build(Plane(6, 6, 0.3));
  const ExactField field(mesh, { VertexSource(0) });
  const BandCase once(field.Exact, { 3.0, 0.0, 1.5 });
  const BandCase often(field.Exact, { 3.0, 0.0, -0.0, 1.5, 3.0, 1.5, 3.0 });
  EXPECT_GT(often.Lines.Lines.size(), once.Lines.Lines.size());
  EXPECT_EQ(often.Found.Levels, once.Found.Levels);
  EXPECT_EQ(often.Found.BandOf, once.Found.BandOf);
  EXPECT_EQ(often.Found.Distances, once.Found.Distances);
  EXPECT_EQ(often.Found.Surface.Triangles, once.Found.Surface.Triangles);
  EXPECT_EQ(often.Found.Surface.Paths, once.Found.Surface.Paths) << "each is cut along once";
}

TEST(Bands, CanBeStoppedAndRefuseBadArguments)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels{ 0.5, 1.0 };
  const BandCase test(field.Exact, levels);
  for (int steps = 0; steps < 4; ++steps)
  {
    int left = steps;
    const ProgressCallback stop = [&](double) { return left-- > 0; };
    Bands bands;
    EXPECT_TRUE(MakeBands(field.Exact, levels, test.Lines, stop, bands).IsAborted());
    EXPECT_TRUE(bands.BandOf.empty());
  }
  Bands bands;
  EXPECT_FALSE(MakeBands({}, levels, test.Lines, {}, bands).IsOk());
  EXPECT_FALSE(MakeBands(field.Exact, { 0.5 }, test.Lines, {}, bands).IsOk());
  EXPECT_FALSE(MakeBands(field.Exact, { 0.5, Infinity }, test.Lines, {}, bands).IsOk());
}
