// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of vector graphics: drawings on surfaces.
#ifndef GraphicsTestTools_h
#define GraphicsTestTools_h

#include "CurveChecks.h"
#include "PathChecks.h"

#include "dggGraphicsRefinement.h"
#include "dggVectorGraphics.h"

namespace dggtest
{
using dgg::GraphicsCurve;
using dgg::GraphicsCurveType;
using dgg::GraphicsRegion;
using dgg::SubMesh;
using dgg::SurfaceCurve;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;

using Position = std::array<double, 3>;

inline void RefineAll(const SurfaceMesh& mesh, int levels, SubMesh& surface)
{
  dgg::GraphicsRefinement refinement;
  refinement.Levels = levels;
  EXPECT_TRUE(Ok(dgg::RefineForGraphics(mesh, refinement, surface)));
}

/// A drawing on a mesh with points.
class Drawing
{
public:
  explicit Drawing(const TestMesh& input)
    : Input(input)
    , Mesh(Build(input))
  {
    this->Options.NumberOfChannels = 1;
  }

  /// Returns the surface point at a position in the plane z = 0.
  SurfacePoint Find(double x, double y) const
  {
    return PointInPlane(this->Input, this->Mesh, x, y);
  }

  /// Returns points of a circle or an ellipse around the origin of the plane z = 0,
  /// counter-clockwise.
  std::vector<SurfacePoint> FindEllipse(double width, double height, int count, double phase = 0.0)
  {
    std::vector<SurfacePoint> points;
    for (int k = 0; k < count; ++k)
    {
      const double angle = 2.0 * dgg::Pi * (k + phase) / count;
      points.push_back(this->Find(width * std::cos(angle), height * std::sin(angle)));
    }
    return points;
  }

  /// Adds a curve; `left` and `right` have one value per given point.
  GraphicsCurve& Add(GraphicsCurveType type, const std::vector<SurfacePoint>& points,
    const std::vector<double>& left, const std::vector<double>& right, bool isClosed = false)
  {
    this->Lines.push_back(dggtest::Curve(this->Mesh, points, isClosed));
    GraphicsCurve curve;
    curve.Type = type;
    curve.IsClosed = isClosed;
    curve.Left = left;
    curve.Right = right;
    this->Curves.push_back(curve);
    return this->Curves.back();
  }

  /// Adds a straight curve in the plane z = 0 with one color on each side.
  GraphicsCurve& AddLine(GraphicsCurveType type, const std::array<double, 2>& from,
    const std::array<double, 2>& to, double left, double right)
  {
    return this->Add(type, { this->Find(from[0], from[1]), this->Find(to[0], to[1]) },
      { left, left }, { right, right });
  }

  dgg::Status Prepare(int levels = 0)
  {
    this->Surface = Embed(this->Mesh, this->Lines);
    RefineAll(this->Mesh, levels, this->Surface);
    std::vector<dgg::CurveChain> chains;
    for (std::size_t k = 0; k < this->Lines.size(); ++k)
    {
      chains.push_back(dgg::FollowCurve(this->Surface, this->Lines, k));
    }
    return this->Graphics.Prepare(this->Mesh, this->Surface, chains, this->Curves, this->Options);
  }
  dgg::Status Solve()
  {
    return this->Graphics.Run(this->Curves, this->Regions, this->Options, this->Result);
  }
  void Run(int levels = 0)
  {
    ASSERT_TRUE(Ok(this->Prepare(levels)));
    ASSERT_TRUE(Ok(this->Solve()));
  }

  std::size_t GetNumberOfValues() const { return this->Graphics.GetSurface().Points.size(); }
  double Value(std::size_t v, int channel = 0) const
  {
    return this->Result.Values[v * this->Options.NumberOfChannels + channel];
  }
  Position Place(Id v) const
  {
    return dgg::PositionOf(
      this->Mesh, this->Graphics.GetSurface().Points[v], this->Input.Points.data());
  }
  /// Calls `visit(vertex, position, midpoint of one of its faces)`. The midpoint shows on which
  /// side of a curve a copy is.
  void ForEachCorner(const std::function<void(Id, const Position&, const Position&)>& visit) const
  {
    const std::vector<Id>& triangles = this->Graphics.GetSurface().Triangles;
    for (std::size_t f = 0; f < triangles.size() / 3; ++f)
    {
      Position places[3];
      Position middle{ { 0.0, 0.0, 0.0 } };
      for (int k = 0; k < 3; ++k)
      {
        places[k] = this->Place(triangles[3 * f + k]);
        for (int axis = 0; axis < 3; ++axis)
        {
          middle[axis] += places[k][axis] / 3.0;
        }
      }
      for (int k = 0; k < 3; ++k)
      {
        visit(triangles[3 * f + k], places[k], middle);
      }
    }
  }

  TestMesh Input;
  SurfaceMesh Mesh;
  std::vector<SurfaceCurve> Lines;
  std::vector<GraphicsCurve> Curves;
  std::vector<GraphicsRegion> Regions;
  dgg::GraphicsOptions Options;
  SubMesh Surface;
  dgg::VectorGraphics Graphics;
  dgg::GraphicsResult Result;
};

inline constexpr auto Diffusion = GraphicsCurveType::Diffusion;
inline constexpr auto Poisson = GraphicsCurveType::Poisson;
inline constexpr auto Region = GraphicsCurveType::Region;
inline constexpr auto Source = GraphicsCurveType::Source;
}

#endif
