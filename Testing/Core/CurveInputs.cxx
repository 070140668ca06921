// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurveInputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace dggtest
{
using dgg::NoId;
using dgg::RefinedSurface;
using dgg::SurfaceCurve;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;

SurfacePoint PointIn(const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  std::array<double, 3> b = barycentric;
  if (mesh.IsFlipped(face))
  {
    std::swap(b[1], b[2]);
  }
  return SurfacePoint::InFace(mesh, face, b);
}

SurfacePoint Between(
  const SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b, Id face, double t)
{
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  EXPECT_TRUE(dgg::FindInFace(mesh, a, face, p));
  EXPECT_TRUE(dgg::FindInFace(mesh, b, face, q));
  for (int k = 0; k < 3; ++k)
  {
    p[k] = (1.0 - t) * p[k] + t * q[k];
  }
  return PointIn(mesh, face, p);
}

std::vector<SurfacePoint> RandomCurvePoints(const SurfaceMesh& mesh, Id count, Random& random)
{
  std::vector<SurfacePoint> points;
  auto randomFace = [&]() {
    Id face = 0;
    do
    {
      face = random.Index(mesh.GetNumberOfFaces());
    } while (mesh.IsDropped(face));
    return face;
  };
  auto inFace = [&](Id face) {
    const double a = -std::log(1.0 - random.Uniform());
    const double b = -std::log(1.0 - random.Uniform());
    const double c = -std::log(1.0 - random.Uniform()) + 1e-9;
    const double sum = a + b + c;
    return PointIn(mesh, face, { { a / sum, b / sum, c / sum } });
  };
  points.push_back(inFace(randomFace()));
  while (static_cast<Id>(points.size()) < count)
  {
    const SurfacePoint last = points.back();
    const Id face = dgg::FindFaceOf(mesh, last);
    std::array<double, 3> b{};
    EXPECT_TRUE(dgg::FindInFace(mesh, last, face, b));
    const Id k = random.Index(3);
    switch (random.Index(10))
    {
      case 0:
        points.push_back(last);
        break;
      case 1: // a point that it has been at
        points.push_back(points[random.Index(static_cast<Id>(points.size()))]);
        break;
      case 2: // a corner of the face
        points.push_back(SurfacePoint::AtVertex(mesh.Origin(3 * face + k)));
        break;
      case 3: // a side of it
        points.push_back(SurfacePoint::OnEdge(mesh, 3 * face + k, random.Uniform()));
        break;
      case 4: // a tiny step
      {
        const double step = std::pow(10.0, -random.Uniform(1.0, 13.0)) * random.Uniform();
        for (int c = 0; c < 3; ++c)
        {
          b[c] = (1.0 - step) * b[c] + (c == k ? step : 0.0);
        }
        points.push_back(PointIn(mesh, face, b));
        break;
      }
      case 5: // on the straight line between two that are in one face
      {
        const SurfacePoint& other = points[random.Index(static_cast<Id>(points.size()))];
        const Id common = dgg::FindCommonFace(mesh, last, other);
        if (common != NoId)
        {
          points.push_back(Between(mesh, last, other, common, random.Uniform()));
        }
        break;
      }
      case 6: {
        const Id twin = mesh.Twin(3 * face + k);
        points.push_back(inFace(twin == NoId ? face : SurfaceMesh::Face(twin)));
        break;
      }
      case 7:
        points.push_back(SurfacePoint::AtVertex(mesh.Origin(3 * randomFace())));
        break;
      case 8:
        points.push_back(
          SurfacePoint::OnEdge(mesh, 3 * randomFace() + k, random.Uniform(1e-10, 1.0)));
        break;
      default:
        points.push_back(inFace(randomFace()));
    }
  }
  return points;
}

SurfaceCurve Curve(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, bool isClosed)
{
  SurfaceCurve curve;
  const dgg::Status status = dgg::JoinPoints(mesh, points, isClosed, nullptr, curve);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return curve;
}

RefinedSurface Embed(const SurfaceMesh& mesh, const std::vector<SurfaceCurve>& curves)
{
  RefinedSurface surface;
  const dgg::Status status = dgg::EmbedCurves(mesh, curves, nullptr, surface);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return surface;
}

dgg::CurveCut CutOpen(const RefinedSurface& surface)
{
  dgg::CurveCut cut;
  const dgg::Status status = dgg::CutAlongCurves(surface, cut);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return cut;
}
}
