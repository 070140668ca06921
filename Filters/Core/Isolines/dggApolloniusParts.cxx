// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggApolloniusParts.h"

#include "dggApolloniusDiagram.h"
#include "dggCornerModel.h"
#include "dggFaceEnvelope.h"
#include "dggFaceTriangulation.h"
#include "dggSourceFinding.h"
#include "dggSurfacePoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Edges or faces per task.
constexpr Offset BlockSize = 64;
/// Progress after the fit and after the edges.
constexpr double FitDone = 0.1;
constexpr double EdgesDone = 0.2;
/// Tolerance of the error of a model at the other end, as a fraction of the edge length. A model
/// with a larger error belongs to another path.
constexpr double BranchTolerance = 1e-9;
/// Minimum distance between nodes, relative to the edge length.
constexpr double NodeDistance = 1e-9;
/// Tolerance between a diagram node on a side and a node of the edge, relative to the edge length.
constexpr double RimTolerance = 1e-6;
/// Minimum distance of interior nodes from the sides, in barycentric coordinates.
constexpr double InnerDistance = 1e-7;

/// A point of an edge at which the published method samples the distance.
struct RimNode
{
  double X = 0.0;      ///< abscissa
  double Value = 0.0;  ///< distance
  bool IsSite = false; ///< true for ends and Steiner points; false for ties of neighboring sites
};

/// The distance along one edge as a cubic that interpolates the values and slopes at the ends of
/// the edge. The slopes follow from the directions of the virtual sources, with or without windows.
/// An end without a virtual source takes the slope of the chord.
///
/// If the shortest paths to the two ends take different routes, a cubic would smooth the ridge
/// between them. In this case the distance is the minimum of the distances from the virtual sources
/// of the two ends.
///
/// The result depends only on the edge, not on the face from which it is computed.
class HermiteEdge
{
public:
  HermiteEdge(const DistanceField& field, int steinerPoints)
    : Field(field)
    , NumberOfSteinerPoints(steinerPoints)
  {
  }

  /// Selects the edge of a half-edge, whose ends must be reached.
  void Enter(Id h);

  /// Returns the half-edge that represents the edge. Abscissae run from its origin to its
  /// destination.
  Id GetHalfEdge() const { return this->HalfEdge; }
  double GetLength() const { return this->Length; }

  /// Returns the distance at an abscissa. At the ends, the result is the distance of the vertex.
  double At(double x) const;

  /// Returns the ends, the evenly spaced Steiner points and the ties of neighboring sites, without
  /// sites that are nearest at no point; in order of strictly increasing abscissae.
  const std::vector<RimNode>& GetNodes() const { return this->Nodes; }

private:
  void SetUpEnds();
  void PlaceNodes();

  const DistanceField& Field;
  int NumberOfSteinerPoints;
  Id HalfEdge = NoId;
  double Length = 0.0;
  std::array<double, 2> Ends{ { 0.0, 0.0 } };
  std::array<double, 2> Rises{ { 0.0, 0.0 } }; // slope times length, towards the destination
  std::array<CornerModel, 2> Models;
  std::array<double, 2> PolarAngles{ { 0.0, 0.0 } }; // polar angles of the edge at its ends
  bool IsSplit = false;
  std::vector<RimNode> Nodes;
  std::vector<RimNode> Kept; // sites that are nearest somewhere on the edge
};

void HermiteEdge::Enter(Id h)
{
  const Id representative = FindEdge(*this->Field.Mesh, h);
  if (representative == this->HalfEdge)
  {
    return;
  }
  this->HalfEdge = representative;
  this->SetUpEnds();
  this->PlaceNodes();
}

void HermiteEdge::SetUpEnds()
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const Id h = this->HalfEdge;
  const std::array<Id, 2> vertices{ { mesh.Origin(h), mesh.Destination(h) } };
  // Half-edges at both ends: h itself, and for the destination the previous side of the same face.
  const Id next = SurfaceMesh::Next(h);
  this->PolarAngles = { { mesh.PolarAngle(h), mesh.PolarAngle(next) + mesh.CornerAngle(next) } };
  this->Length = mesh.Length(h);
  this->Ends = { { this->Field.Distances[vertices[0]], this->Field.Distances[vertices[1]] } };
  const double chord = this->Ends[1] - this->Ends[0];
  this->Rises = { { chord, chord } };
  this->Models = {};
  const VirtualSources* sources = this->Field.Sources;
  const bool hasSources = sources && !sources->empty();
  std::array<double, 2> missing{ { 0.0, 0.0 } };
  for (int k = 0; k < 2 && hasSources; ++k)
  {
    CornerModel& model = this->Models[k];
    model = CornerModel(mesh, vertices[k], (*sources)[vertices[k]], this->Ends[k]);
    model.IsKnown = model.IsKnown && std::isfinite(model.Length) && std::isfinite(model.Angle);
    if (!model.IsKnown)
    {
      continue;
    }
    const double angle = model.AngleFrom(this->PolarAngles[k]);
    const double slope =
      model.Length <= 0.0 || std::abs(angle) >= Pi ? 1.0 : -std::cos(angle); // away from the end
    this->Rises[k] = (k == 0 ? slope : -slope) * this->Length;
    missing[k] = model.At(this->Length, this->PolarAngles[k]) - this->Ends[1 - k];
  }
  const double tolerance = BranchTolerance * this->Length;
  this->IsSplit = missing[0] > tolerance && missing[1] > tolerance;
}

double HermiteEdge::At(double x) const
{
  if (x <= 0.0 || x >= this->Length)
  {
    return this->Ends[x > 0.0 ? 1 : 0];
  }
  const double t = x / this->Length;
  const double s = 1.0 - t;
  const double value = this->IsSplit
    ? std::min(this->Models[0].At(x, this->PolarAngles[0]),
        this->Models[1].At(this->Length - x, this->PolarAngles[1]))
    : s * s * ((1.0 + 2.0 * t) * this->Ends[0] + t * this->Rises[0]) +
      t * t * ((1.0 + 2.0 * s) * this->Ends[1] - s * this->Rises[1]);
  // On overflow, fall back to linear interpolation.
  return std::isfinite(value) ? value : s * this->Ends[0] + t * this->Ends[1];
}

void HermiteEdge::PlaceNodes()
{
  this->Nodes.clear();
  const int count = this->NumberOfSteinerPoints + 1;
  for (int i = 0; i <= count; ++i)
  {
    const double x = i == count ? this->Length : this->Length * i / count;
    this->Nodes.push_back({ x, this->At(x), true });
  }
  // Keep sites that are nearest to some point of the edge; other sites are dominated by a site
  // before or behind.
  this->Kept.clear();
  for (const RimNode& node : this->Nodes)
  {
    if (!this->Kept.empty() &&
      node.Value >= this->Kept.back().Value + (node.X - this->Kept.back().X))
    {
      continue;
    }
    while (
      !this->Kept.empty() && this->Kept.back().Value >= node.Value + (node.X - this->Kept.back().X))
    {
      this->Kept.pop_back();
    }
    this->Kept.push_back(node);
  }
  const std::size_t numberOfSites = this->Nodes.size();
  for (std::size_t i = 0; i + 1 < this->Kept.size(); ++i)
  {
    const RimNode& a = this->Kept[i];
    const RimNode& b = this->Kept[i + 1];
    const double x = 0.5 * (a.X + b.X + (b.Value - a.Value));
    const double apart = NodeDistance * this->Length;
    const bool isNew = std::none_of(this->Nodes.begin(), this->Nodes.begin() + numberOfSites,
      [&](const RimNode& node) { return std::abs(node.X - x) <= apart; });
    if (isNew)
    {
      this->Nodes.push_back({ x, this->At(x), false });
    }
  }
  std::sort(this->Nodes.begin(), this->Nodes.end(),
    [](const RimNode& a, const RimNode& b) { return a.X < b.X; });
}

/// Returns the index of the crossing of a level between two neighboring nodes of an edge.
Id FindCrossing(const LevelCrossings& crossings, Id h, Id level, Id interval)
{
  const auto begin = crossings.Crossings.begin();
  const auto place = std::lower_bound(begin + crossings.Offsets[h],
    begin + crossings.Offsets[h + 1], level, [&](const LevelCrossing& c, Id r) {
      return c.Level != r ? c.Level < r : c.Interval < interval;
    });
  return static_cast<Id>(place - begin);
}

/// A face subdivided into triangles on which the distance is linear: their corners are the nodes of
/// the three edges (HermiteEdge) and the nodes of the Apollonius diagram of the sites. Edges of
/// the diagram, straightened, are edges of triangles where possible.
///
/// The distance at a node of the diagram is that of the field inside the face (dggFaceEnvelope.h).
/// The distance of the diagram is an overestimate, because the path to the point need not start at
/// a site. An object can be reused for other faces, which saves allocations.
class ApolloniusFace
{
public:
  /// Prepares subdivisions for a field. A field with neither virtual sources nor windows is linear
  /// inside faces.
  ApolloniusFace(const DistanceField& field, int steinerPoints);

  /// Selects a face, which must be reached (DistanceField::IsReached()).
  void Enter(Id f);

  /// Returns the bounds of the distance in the face, as tight as values on its boundary allow.
  double GetSmallest() const { return this->Smallest; }
  double GetLargest() const { return this->Largest; }

  /// Appends the curves on which the distance is `level`, with the lower side on their left.
  void FindCurves(
    double level, Id number, const LevelCrossings& crossings, std::vector<FaceCurve>& curves);

private:
  /// A segment of the boundary of the face, counter-clockwise.
  struct RimPiece
  {
    int Begin;
    int End;
    Id HalfEdge;
    Id Interval;
  };

  /// A directed edge of a triangle.
  struct TriangleEdge
  {
    int Begin;
    int End;
    int Triangle;
    bool operator<(const TriangleEdge& other) const
    {
      return this->Begin != other.Begin ? this->Begin < other.Begin : this->End < other.End;
    }
  };

  void AddRim();
  void Build();
  void AddDiagram(FaceTriangulation& triangulation);
  int FindRimNode(int side, double x) const;
  int TriangleOf(int begin, int end) const;
  bool IsBelow(int node, double level) const { return this->Values[node] < level; }
  std::array<double, 3> PlaceBetween(int a, int b, double level) const;
  std::pair<int, int> Follow(int begin, int end, double level, FaceCurve& curve);

  const DistanceField& Field;
  int NumberOfSteinerPoints;
  HermiteEdge Edge;
  FaceEnvelope Envelope;
  ApolloniusDiagram Diagram;
  Id Face = NoId;
  bool IsBuilt = false;
  double Smallest = 0.0;
  double Largest = 0.0;
  std::vector<std::array<double, 3>> Places;
  std::vector<double> Values;
  std::vector<WeightedSite> Sites;
  std::array<std::vector<std::pair<double, int>>, 3> Sides; // abscissa and node, sorted
  std::vector<RimPiece> Rim;
  std::vector<std::array<int, 3>> Triangles;
  std::vector<TriangleEdge> TriangleEdges; // sorted
  std::vector<bool> IsDone;                // per triangle, true if the isoline has visited it
};

ApolloniusFace::ApolloniusFace(const DistanceField& field, int steinerPoints)
  : Field(field)
  , NumberOfSteinerPoints(steinerPoints)
  , Edge(field, steinerPoints)
  , Envelope(field)
{
}

void ApolloniusFace::Enter(Id f)
{
  this->Face = f;
  this->Envelope.Enter(f);
  this->Places = { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } };
  this->Values.clear();
  for (int k = 0; k < 3; ++k)
  {
    this->Values.push_back(this->Envelope.GetCornerDistance(k));
  }
  this->AddRim();
  this->IsBuilt = false;
  const auto range = std::minmax_element(this->Values.begin(), this->Values.end());
  // Upper bound of the distance from any point to the boundary, and from a boundary point to a
  // node.
  double around = 0.0;
  double longest = 0.0;
  const SurfaceMesh& mesh = *this->Field.Mesh;
  for (Id h = 3 * f; h < 3 * f + 3; ++h)
  {
    around += mesh.Length(h);
    longest = std::max(longest, mesh.Length(h));
  }
  const double inradius = mesh.Length(3 * f) * mesh.ApexY(3 * f) / around;
  const double reach = inradius + longest / (this->NumberOfSteinerPoints + 1);
  this->Smallest = *range.first - reach;
  this->Largest = *range.second + reach;
}

/// Builds the triangles. They are only needed if a level crosses the face.
void ApolloniusFace::Build()
{
  this->IsBuilt = true;
  FaceTriangulation triangulation(this->Envelope.GetCorners());
  for (std::size_t n = 3; n < this->Places.size(); ++n)
  {
    triangulation.AddPoint(GridPoint::FromBarycentric(this->Places[n]));
  }
  this->Diagram.Build(this->Envelope.GetCorners(), this->Sites);
  this->AddDiagram(triangulation);
  triangulation.MakeDelaunay();
  this->Triangles = triangulation.GetTriangles();
  this->TriangleEdges.clear();
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->TriangleEdges.push_back(
        { this->Triangles[t][k], this->Triangles[t][(k + 1) % 3], static_cast<int>(t) });
    }
  }
  std::sort(this->TriangleEdges.begin(), this->TriangleEdges.end());
  std::sort(this->Rim.begin(), this->Rim.end(), [](const RimPiece& a, const RimPiece& b) {
    return a.Begin < b.Begin; // each node starts one segment
  });
}

/// Adds the nodes of the three edges, in order around the face.
void ApolloniusFace::AddRim()
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  this->Rim.clear();
  this->Sites.clear();
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * this->Face + k;
    this->Edge.Enter(h);
    const std::vector<RimNode>& nodes = this->Edge.GetNodes();
    const double length = this->Edge.GetLength();
    const bool isSame = mesh.Origin(this->Edge.GetHalfEdge()) == mesh.Origin(h);
    std::vector<std::pair<double, int>>& side = this->Sides[k];
    side.clear();
    this->Sites.push_back({ k, 0.0, this->Values[k] });
    int last = k;
    side.emplace_back(0.0, k);
    for (std::size_t i = 1; i < nodes.size(); ++i)
    {
      const std::size_t index = isSame ? i : nodes.size() - 1 - i;
      const RimNode& node = nodes[index];
      const double x = isSame ? node.X : length - node.X;
      int number = (k + 1) % 3;
      if (i + 1 < nodes.size())
      {
        number = static_cast<int>(this->Values.size());
        this->Places.push_back(CoordinatesOnEdge(k, x / length));
        this->Values.push_back(node.Value);
        if (node.IsSite)
        {
          this->Sites.push_back({ k, x, node.Value });
        }
      }
      side.emplace_back(x, number);
      this->Rim.push_back(
        { last, number, this->Edge.GetHalfEdge(), static_cast<Id>(isSame ? i - 1 : index) });
      last = number;
    }
  }
}

int ApolloniusFace::FindRimNode(int side, double x) const
{
  const double length = this->Field.Mesh->Length(3 * this->Face + side);
  int best = -1;
  double bestDistance = RimTolerance * length;
  for (const std::pair<double, int>& node : this->Sides[side])
  {
    if (std::abs(node.first - x) <= bestDistance)
    {
      best = node.second;
      bestDistance = std::abs(node.first - x);
    }
  }
  return best;
}

/// Adds the interior nodes of the diagram, and its edges. If an edge ends on the boundary at a tie
/// of two sites of different sides, the end has no node, because the adjacent face would not have
/// this node; such an edge is omitted.
void ApolloniusFace::AddDiagram(FaceTriangulation& triangulation)
{
  std::vector<int> numbers;
  for (const ApolloniusNode& node : this->Diagram.GetNodes())
  {
    int number = -1;
    if (node.Side >= 0)
    {
      number = this->FindRimNode(node.Side, node.X);
    }
    else
    {
      const std::array<double, 3> b = this->Envelope.BarycentricOf(node.Place);
      const double value = this->Envelope.At(node.Place); // not finite on overflow
      if (std::min(b[0], std::min(b[1], b[2])) > InnerDistance && std::isfinite(value))
      {
        number = static_cast<int>(this->Values.size());
        triangulation.AddPoint(GridPoint::FromBarycentric(b));
        this->Places.push_back(b);
        this->Values.push_back(value);
      }
    }
    numbers.push_back(number);
  }
  for (const std::pair<int, int>& edge : this->Diagram.GetEdges())
  {
    const int a = numbers[edge.first];
    const int b = numbers[edge.second];
    if (a >= 0 && b >= 0 && a != b)
    {
      triangulation.AddSegment(a, b); // may fail: arcs replaced by segments may cross
    }
  }
}

/// Returns the triangle on the left of a directed edge; -1 if no triangle is on the left.
int ApolloniusFace::TriangleOf(int begin, int end) const
{
  const TriangleEdge wanted{ begin, end, 0 };
  const auto found =
    std::lower_bound(this->TriangleEdges.begin(), this->TriangleEdges.end(), wanted);
  return found != this->TriangleEdges.end() && !(wanted < *found) ? found->Triangle : -1;
}

/// Returns the point between two nodes at which the distance attains a level.
std::array<double, 3> ApolloniusFace::PlaceBetween(int a, int b, double level) const
{
  const double below = 0.5 * this->Values[a]; // halved, because differences may overflow
  const double t = (0.5 * level - below) / (0.5 * this->Values[b] - below);
  std::array<double, 3> place{};
  for (int k = 0; k < 3; ++k)
  {
    place[k] = (1.0 - t) * this->Places[a][k] + t * this->Places[b][k];
  }
  return place;
}

/// Follows an isoline from a directed edge, which crosses the level upward, through triangles to
/// the boundary or back to its start. Adds the points on crossed edges. Returns the exit edge,
/// directed as in its triangle.
std::pair<int, int> ApolloniusFace::Follow(int begin, int end, double level, FaceCurve& curve)
{
  std::pair<int, int> exit{ end, begin };
  for (int t = this->TriangleOf(begin, end); t >= 0 && !this->IsDone[t];)
  {
    this->IsDone[t] = true;
    const std::array<int, 3>& corners = this->Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      if (!this->IsBelow(corners[k], level) && this->IsBelow(corners[(k + 1) % 3], level))
      {
        exit = { corners[k], corners[(k + 1) % 3] };
      }
    }
    t = this->TriangleOf(exit.second, exit.first);
    if (t >= 0)
    {
      curve.Points.push_back(this->PlaceBetween(exit.second, exit.first, level));
    }
  }
  return exit;
}

void ApolloniusFace::FindCurves(
  double level, Id number, const LevelCrossings& crossings, std::vector<FaceCurve>& curves)
{
  if (!this->IsBuilt)
  {
    this->Build();
  }
  this->IsDone.assign(this->Triangles.size(), false);
  auto crossingOf = [&](int begin) {
    const auto piece = std::lower_bound(this->Rim.begin(), this->Rim.end(), begin,
      [](const RimPiece& p, int node) { return p.Begin < node; });
    return FindCrossing(crossings, piece->HalfEdge, number, piece->Interval);
  };
  FaceCurve curve;
  curve.Face = this->Face;
  curve.Level = number;
  for (const RimPiece& piece : this->Rim)
  {
    if (this->IsBelow(piece.Begin, level) && !this->IsBelow(piece.End, level))
    {
      curve.Points.clear();
      curve.First = crossingOf(piece.Begin);
      curve.Last = crossingOf(this->Follow(piece.Begin, piece.End, level, curve).first);
      curves.push_back(curve);
    }
  }
  curve.First = curve.Last = NoId;
  // The remaining isolines are closed within the face.
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int k = 0; k < 3 && !this->IsDone[t]; ++k)
    {
      const int begin = this->Triangles[t][k];
      const int end = this->Triangles[t][(k + 1) % 3];
      if (this->IsBelow(begin, level) && !this->IsBelow(end, level))
      {
        curve.Points.clear();
        this->Follow(begin, end, level, curve);
        curves.push_back(curve);
      }
    }
  }
}

/// Returns the first level that is not below a value.
Id FirstFrom(const std::vector<double>& levels, double value)
{
  return static_cast<Id>(std::lower_bound(levels.begin(), levels.end(), value) - levels.begin());
}

void CrossEdge(
  const HermiteEdge& edge, const std::vector<double>& levels, std::vector<LevelCrossing>& found)
{
  const std::vector<RimNode>& nodes = edge.GetNodes();
  const auto range = std::minmax_element(nodes.begin(), nodes.end(),
    [](const RimNode& a, const RimNode& b) { return a.Value < b.Value; });
  const auto count = static_cast<Id>(levels.size());
  for (Id r = FirstFrom(levels, range.first->Value); r < count && levels[r] <= range.second->Value;
       ++r)
  {
    const double level = levels[r];
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const RimNode& a = nodes[i];
      const RimNode& b = nodes[i + 1];
      if ((a.Value < level) != (b.Value < level))
      {
        const double t = (level - a.Value) / (b.Value - a.Value);
        const double x = std::min(b.X, std::max(a.X, (1.0 - t) * a.X + t * b.X));
        found.push_back({ edge.GetHalfEdge(), r, static_cast<Id>(i), x });
      }
    }
  }
}

void CrossFace(ApolloniusFace& face, const std::vector<double>& levels,
  const LevelCrossings& crossings, std::vector<FaceCurve>& curves)
{
  const auto count = static_cast<Id>(levels.size());
  for (Id r = FirstFrom(levels, face.GetSmallest()); r < count && levels[r] <= face.GetLargest();
       ++r)
  {
    face.FindCurves(levels[r], r, crossings, curves);
  }
}
}

Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  LevelCrossings& crossings, std::vector<FaceCurve>& curves)
{
  DistanceField used = field;
  VirtualSources fitted;
  double begin = 0.0;
  if (!field.Sources || field.Sources->empty())
  {
    DGG_RETURN_IF_ERROR(FitVirtualSources(
      *field.Mesh, field.Distances, parallel, fitted, ProgressPart(progress, 0.0, FitDone)));
    used.Sources = &fitted;
    begin = FitDone;
  }
  DGG_RETURN_IF_ERROR(CollectCrossings(
    *field.Mesh, BlockSize, parallel, progress, begin, EdgesDone,
    [&] { return HermiteEdge(used, steinerPoints); },
    [&](HermiteEdge& edge, Id h, std::vector<LevelCrossing>& found) {
      if (IsEdgeTraced(used, h))
      {
        edge.Enter(h);
        CrossEdge(edge, levels, found);
      }
    },
    crossings));
  return CollectPieces(
    field.Mesh->GetNumberOfFaces(), BlockSize, parallel, progress, EdgesDone, 1.0,
    [&] { return ApolloniusFace(used, steinerPoints); },
    [&](ApolloniusFace& face, Id f, std::vector<FaceCurve>& found) {
      if (used.IsReached(f))
      {
        face.Enter(f);
        CrossFace(face, levels, crossings, found);
      }
    },
    curves);
}
}
