// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Every edge is the length of a real way on the surface, in the directions that it says.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace dggtest
{
namespace
{
using dgg::GraphConstruction;
using dgg::Offset;
using dgg::Point2;
using dgg::SurfaceMesh;

/// Straight ahead over a surface: faces are laid out one after the other in a plane in which the
/// way runs from the origin along the x axis.
class StraightWay
{
public:
  /// From a vertex in the direction of a polar angle, for a length.
  StraightWay(const SurfaceMesh& mesh, Id vertex, double angle, double length)
    : Mesh(mesh)
    , End(length, 0.0)
  {
    for (const Id* g = mesh.FanBegin(vertex); g != mesh.FanEnd(vertex); ++g)
    {
      const double turn = mesh.PolarAngle(*g) - angle;
      // A little more than the corner: the angle of a graph is a float.
      if (turn <= 1e-6 && turn + mesh.CornerAngle(*g) >= -1e-6)
      {
        const Id last = SurfaceMesh::Previous(*g);
        this->Face = SurfaceMesh::Face(*g);
        this->Place(*g, { 0.0, 0.0 });
        this->Place(SurfaceMesh::Next(*g), At(mesh.Length(*g), turn));
        this->Place(last, At(mesh.Length(last), turn + mesh.CornerAngle(*g)));
        this->Go(SurfaceMesh::Next(*g));
        return;
      }
    }
  }

  /// The corner next to the end, as the half-edge that leaves it; NoId when the way left the
  /// surface.
  Id GetCorner() const { return this->Corner; }
  /// How far the end is from that corner.
  double GetMiss() const { return this->Miss; }
  /// Polar angle at that corner, pointing back.
  double GetArrival() const
  {
    const Point2& c = this->Corners[this->Corner % 3];
    const Point2& next = this->Corners[SurfaceMesh::Next(this->Corner) % 3];
    const Point2& last = this->Corners[SurfaceMesh::Previous(this->Corner) % 3];
    const Point2 side{ next.X - c.X, next.Y - c.Y };
    const double turn = std::atan2(dgg::Cross(side, { -1.0, 0.0 }), -side.X);
    const bool isMirrored = dgg::Cross(side, { last.X - c.X, last.Y - c.Y }) < 0.0;
    return this->Mesh.PolarAngle(this->Corner) + (isMirrored ? -turn : turn);
  }

private:
  struct EndPoint : Point2
  {
    EndPoint(double x, double y)
      : Point2{ x, y }
    {
    }
  };

  static Point2 At(double radius, double angle)
  {
    return { radius * std::cos(angle), radius * std::sin(angle) };
  }
  void Place(Id corner, const Point2& position) { this->Corners[corner % 3] = position; }

  /// Leave the face in hand through half-edge `exit` unless the end comes before.
  void Go(Id exit)
  {
    for (int faces = 0; faces < 100000; ++faces)
    {
      const Point2 a = this->Corners[exit % 3];
      const Point2 b = this->Corners[SurfaceMesh::Next(exit) % 3];
      if (this->IsAtCorner() || a.X + (b.X - a.X) * a.Y / (a.Y - b.Y) >= this->End.X)
      {
        return;
      }
      const Id entry = this->Mesh.Twin(exit);
      if (entry == dgg::NoId || this->Mesh.Twin(entry) != exit)
      {
        this->Corner = dgg::NoId;
        return;
      }
      const bool isAlike = this->Mesh.Origin(entry) == this->Mesh.Destination(exit);
      const Point2 origin = isAlike ? b : a;
      const Point2 end = isAlike ? a : b;
      // The new face is on the other side of the edge than the old one.
      const Point2 old = this->Corners[SurfaceMesh::Previous(exit) % 3];
      const double length = this->Mesh.Length(entry);
      const Point2 axis{ (end.X - origin.X) / length, (end.Y - origin.Y) / length };
      const Point2 apex = dgg::LayOut(length, this->Mesh.Length(SurfaceMesh::Previous(entry)),
        this->Mesh.Length(SurfaceMesh::Next(entry)));
      const bool isOldLeft = dgg::Cross(axis, { old.X - origin.X, old.Y - origin.Y }) > 0.0;
      const Id last = SurfaceMesh::Previous(entry);
      this->Face = SurfaceMesh::Face(entry);
      this->Place(entry, origin);
      this->Place(SurfaceMesh::Next(entry), end);
      this->Place(last, dgg::FromFrame(origin, axis, { apex.X, isOldLeft ? -apex.Y : apex.Y }));
      // Out between the apex and the end of the entry on the other side of the way.
      const bool isApexLeft = this->Corners[last % 3].Y > 0.0;
      exit = isApexLeft == (origin.Y > 0.0) ? SurfaceMesh::Next(entry) : last;
    }
    this->Corner = dgg::NoId;
  }

  bool IsAtCorner()
  {
    this->Miss = dgg::Infinity;
    for (Id h = 3 * this->Face; h < 3 * this->Face + 3; ++h)
    {
      const double miss = dgg::Distance(this->Corners[h % 3], this->End);
      if (miss < this->Miss)
      {
        this->Miss = miss;
        this->Corner = h;
      }
    }
    return this->Miss < 1e-4 * this->Mesh.Length(this->Corner);
  }

  const SurfaceMesh& Mesh;
  EndPoint End;
  Id Face = dgg::NoId;
  Point2 Corners[3];
  Id Corner = dgg::NoId;
  double Miss = dgg::Infinity;
};

/// Difference of two polar angles around a vertex.
double AngleBetween(const SurfaceMesh& mesh, Id v, double a, double b)
{
  const double difference = std::abs(a - b);
  return mesh.Kind(v) == dgg::VertexKind::Boundary
    ? difference
    : std::min(difference, std::abs(difference - mesh.TotalAngle(v)));
}

/// Expect the way of every edge to end at its target, from the direction of arrival. Nothing is
/// asked of edges that pass another vertex so closely that the rounding of an angle to a float
/// takes them round its other side: they lead elsewhere, but may only be few.
void ExpectEdgesLeadToTargets(const SurfaceMesh& mesh, const dgg::GraphView& graph)
{
  Offset followed = 0;
  Offset astray = 0;
  Offset turned = 0;
  for (Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    if (mesh.Kind(v) == dgg::VertexKind::Irregular)
    {
      continue; // its angles have no order
    }
    for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      ++followed;
      const StraightWay way(mesh, v, graph.Angles[e], graph.Length(e));
      if (way.GetCorner() == dgg::NoId || mesh.Origin(way.GetCorner()) != graph.Targets[e] ||
        way.GetMiss() > 1e-5 * graph.Length(e))
      {
        ++astray;
        continue;
      }
      const Id target = graph.Targets[e];
      if (mesh.Kind(target) != dgg::VertexKind::Irregular &&
        AngleBetween(mesh, target, way.GetArrival(), graph.ArrivalAngles[e]) > 2e-5 &&
        ++turned == 1)
      {
        ADD_FAILURE() << "edge from " << v << " to " << target << " arrives from "
                      << way.GetArrival() << " instead of " << graph.ArrivalAngles[e];
      }
    }
  }
  EXPECT_GT(followed, 100);
  EXPECT_LE(astray, graph.GetNumberOfEdges() / 1000);
  EXPECT_EQ(turned, 0);
}

}

TEST(GraphBuilderEdges, MeshEdgesAreThere)
{
  for (const NamedMesh& named : AllMeshes())
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    for (const double accuracy : { 0.5, 1e-3 })
    {
      const dgg::GeodesicGraph graph = BuildGraph(mesh, accuracy);
      for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
      {
        if (!mesh.IsDropped(SurfaceMesh::Face(h)))
        {
          const Offset e = FindEdge(graph.View(), mesh.Origin(h), mesh.Destination(h));
          ASSERT_GE(e, 0) << h;
          ASSERT_LE(graph.View().Length(e), mesh.Length(h) * (1.0 + 2e-7)) << h;
        }
      }
    }
  }
}

TEST(GraphBuilderEdges, AnglesOnPlane)
{
  const TestMesh input = Plate(
    14, 12, [](Id i, Id j) { return !(i >= 4 && i < 7 && j >= 4 && j < 7); }, 0.25, 3);
  const SurfaceMesh mesh = Build(input);
  const auto polar = [&](Id v, Id to) {
    const double angle = DirectionOf(input, v, to) - FanAngle(input, mesh, v);
    return angle - 2.0 * dgg::Pi * std::floor(angle / (2.0 * dgg::Pi));
  };
  const auto difference = [](double a, double b) {
    return std::abs(std::remainder(a - b, 2.0 * dgg::Pi));
  };
  for (const GraphConstruction construction : AllConstructions())
  {
    const dgg::GeodesicGraph graph = BuildGraph(mesh, 0.01, construction);
    std::size_t inside = 0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      for (Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
      {
        const Id to = graph.Targets[e];
        ASSERT_LE(difference(graph.Angles[e], polar(v, to)), 1e-6) << v << " to " << to;
        ASSERT_LE(difference(graph.ArrivalAngles[e], polar(to, v)), 1e-6) << v << " to " << to;
        inside += mesh.Kind(v) != dgg::VertexKind::Boundary ? 1 : 0;
      }
    }
    EXPECT_GT(inside, 1000u);
  }
}

TEST(GraphBuilderEdges, LeadToTargets)
{
  std::vector<ConePoint> unused;
  for (const NamedMesh& named : { NamedMesh{ "Plane", WithNoise(Plane(16, 14, 0.25, 1), 0.05, 1) },
         NamedMesh{ "Convex", Cone(4.0, 12, 10, unused, 0.2, 2) },
         NamedMesh{ "Saddle", Cone(9.0, 18, 10, unused, 0.2, 3) },
         NamedMesh{ "Terrain", Terrain(18, 2.0, 4) }, NamedMesh{ "Sphere", NoisySphere(3, 0.3, 5) },
         NamedMesh{ "Ellipsoid", WithNoise(Ellipsoid(2, 10.0), 0.02, 6) },
         NamedMesh{ "Cube", WithNoise(Cube(6, 0.25, 7), 0.01, 7) },
         NamedMesh{ "Torus", WithNoise(Torus(20, 12), 0.03, 8) },
         NamedMesh{ "Components", SeveralComponents() } })
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    for (const double accuracy : { 0.1, 0.01, 1e-4 })
    {
      ExpectEdgesLeadToTargets(mesh, BuildGraph(mesh, accuracy).View());
    }
    ExpectEdgesLeadToTargets(
      mesh, BuildGraph(mesh, 0.01, GraphConstruction::SaddleVertexGraph).View());
  }
}

TEST(GraphBuilderEdges, LeadToTargetsOnMirroredFaces)
{
  // On a Moebius strip and on a Klein bottle light crosses edges behind which all is mirrored;
  // angles are those of each vertex's own fan all the same. Vertices are moved off the lattice, as
  // ways along it pass through vertices.
  for (NamedMesh named :
    { NamedMesh{ "Moebius", MoebiusStrip(11, 6) }, NamedMesh{ "KleinBottle", KleinBottle(9, 7) } })
  {
    SCOPED_TRACE(named.Name);
    Random random(9);
    std::vector<double>& lengths = named.Mesh.Lengths;
    std::map<std::pair<Id, Id>, double> factors;
    for (std::size_t k = 0; k < lengths.size(); ++k)
    {
      const Id a = named.Mesh.Triangles[k];
      const Id b = named.Mesh.Triangles[k % 3 == 2 ? k - 2 : k + 1];
      const auto factor = factors.emplace(std::minmax(a, b), random.Uniform(0.9, 1.1)).first;
      lengths[k] *= factor->second;
    }
    const SurfaceMesh mesh = Build(named.Mesh);
    for (const double accuracy : { 0.1, 0.001 })
    {
      ExpectEdgesLeadToTargets(mesh, BuildGraph(mesh, accuracy).View());
    }
  }
}
}
