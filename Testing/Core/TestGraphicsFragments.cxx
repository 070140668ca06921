// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Fragments of coloured surfaces: where they are, their colours, in which faces.
#include "FlatMeshes.h"
#include "GraphicsTestTools.h"

#include "dggGraphicsFragments.h"

#include <algorithm>

namespace dggtest
{
TEST(VectorGraphics, FragmentsAreTheMiddlesOfEqualParts)
{
  // A function that is linear on each side of a curve: fragments have its values at their places,
  // which spread evenly, and on their own side.
  for (const int division : { 1, 2, 3, 5 })
  {
    Drawing drawing(Plane(5, 4, 0.3));
    drawing.Options.NumberOfChannels = 2;
    drawing.Add(Diffusion, { drawing.Find(0.0, 0.0), drawing.Find(0.0, 4.0) }, { 0, 9, 0, 9 },
      { 1, 3, 1, 3 });
    drawing.Add(Diffusion, { drawing.Find(2.6, 0.0), drawing.Find(2.6, 4.0) }, { 2, 0, 2, 0 },
      { 7, 8, 7, 8 });
    drawing.Run(1);
    const dgg::CutSurface& surface = drawing.Graphics.GetSurface();
    std::vector<Id> faces;
    for (Id f = 0; f < surface.GetNumberOfFaces(); f += 2)
    {
      faces.push_back(f);
    }
    const dgg::GraphicsFragments fragments =
      dgg::MakeFragments(drawing.Mesh, surface, faces, drawing.Result.Values, 2, division);
    const auto each = static_cast<std::size_t>(division * division);
    ASSERT_EQ(fragments.Places.size(), each * faces.size());
    ASSERT_EQ(fragments.Faces.size(), each * faces.size());
    ASSERT_EQ(fragments.Values.size(), 2 * each * faces.size());
    for (std::size_t i = 0; i < fragments.Places.size(); ++i)
    {
      const Position p =
        dgg::PositionOf(drawing.Mesh, fragments.Places[i], drawing.Input.Points.data());
      EXPECT_EQ(fragments.Faces[i], fragments.Places[i].Face);
      EXPECT_EQ(fragments.Faces[i], surface.Faces[faces[i / each]]);
      const double t = p[0] / 2.6;
      EXPECT_NEAR(fragments.Values[2 * i], t < 1.0 ? 1.0 + t : 7.0, 1e-9);
      EXPECT_NEAR(fragments.Values[2 * i + 1], t < 1.0 ? 3.0 - 3.0 * t : 8.0, 1e-9);
    }
    // Their first and second moments in a triangle: those of the parts about their own middles are
    // all that is missing, 1/division^2 of those of the triangle.
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      Position corners[3];
      double middle = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        corners[k] = drawing.Place(surface.Triangles[3 * faces[f] + k]);
        middle += corners[k][0] / 3.0;
      }
      double first = 0.0;
      double second = 0.0;
      double whole = 0.0;
      for (std::size_t i = each * f; i < each * (f + 1); ++i)
      {
        const double x =
          dgg::PositionOf(drawing.Mesh, fragments.Places[i], drawing.Input.Points.data())[0];
        first += (x - middle) / each;
        second += (x - middle) * (x - middle) / each;
      }
      for (const Position& corner : corners)
      {
        whole += (corner[0] - middle) * (corner[0] - middle) / 12.0;
      }
      EXPECT_NEAR(first, 0.0, 1e-12);
      EXPECT_NEAR(second, whole * (1.0 - 1.0 / each), 1e-12);
    }
  }
}

TEST(VectorGraphics, RefinementTellsThePartsOfWhatWasChosen)
{
  Drawing drawing(Plane(9, 8, 0.2));
  drawing.Add(Diffusion, { drawing.Find(2.2, 3.1), drawing.Find(5.4, 3.7) }, { 0, 0 }, { 0, 0 });
  const RefinedSurface coarse = Embed(drawing.Mesh, drawing.Lines);
  std::vector<char> isPassed(coarse.Points.size(), 0);
  for (const Id v : coarse.Paths[0])
  {
    isPassed[v] = 1;
  }
  std::size_t touched = 0;
  for (Id f = 0; f < coarse.GetNumberOfFaces(); ++f)
  {
    const Id* corners = coarse.Triangles.data() + 3 * f;
    touched += isPassed[corners[0]] || isPassed[corners[1]] || isPassed[corners[2]] ? 1 : 0;
  }
  const Id chosen = 2 * 9 * 6 + 3; // far from the curve, which leaves it whole
  for (const int levels : { 0, 1, 2 })
  {
    const std::size_t parts = std::size_t(1) << (2 * levels);
    dgg::GraphicsRefinement refinement;
    refinement.Levels = levels;
    std::vector<Id> found = { 77 };
    RefinedSurface surface = coarse;
    ASSERT_TRUE(dgg::RefineForGraphics(drawing.Mesh, refinement, surface, &found).IsOk());
    EXPECT_EQ(found.size(), surface.Faces.size()); // everything
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));

    surface = coarse;
    refinement.Part = dgg::RefinedPart::Faces;
    refinement.Faces = { chosen };
    ASSERT_TRUE(dgg::RefineForGraphics(drawing.Mesh, refinement, surface, &found).IsOk());
    EXPECT_EQ(found.size(), parts);
    for (const Id f : found)
    {
      EXPECT_EQ(surface.Faces[f], chosen);
    }

    surface = coarse;
    refinement.Part = dgg::RefinedPart::AroundCurves;
    ASSERT_TRUE(dgg::RefineForGraphics(drawing.Mesh, refinement, surface, &found).IsOk());
    EXPECT_EQ(found.size(), parts * touched);
    EXPECT_LT(found.size(), surface.Faces.size());
  }
}
}
