// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCapSplitting.h"

#include "dggPoint3.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

namespace dgg
{
namespace
{
/// Maximum number of triangles per input triangle; beyond this, remaining caps are kept.
constexpr std::size_t MostParts = 4;
/// A triangle with an edge this short, relative to the slack of degeneracy, is not a cap: the
/// position of its apex along the longest edge is determined by rounding.
constexpr double ShortestEdge = 10.0;

class CapSplitter
{
public:
  CapSplitter(const double* points, std::vector<Id>& triangles, std::vector<Id>& parents)
    : Points(points)
    , Triangles(triangles)
    , Parents(parents)
  {
  }

  CapSplitting Run()
  {
    const Id input = this->GetNumberOfTriangles();
    this->Parents.resize(input);
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
    this->FindCaps();
    if (this->Caps.empty())
    {
      return this->Result;
    }
    for (Id f = 0; f < input; ++f)
    {
      this->Link(f);
    }
    this->Moved.resize(input, 0.0);
    const std::size_t most = MostParts * static_cast<std::size_t>(input);
    // NOLINTNEXTLINE(modernize-loop-convert): the list grows during the loop
    for (std::size_t i = 0; i < this->Caps.size() && this->Parents.size() < most; ++i)
    {
      this->Remove(this->Caps[i]);
    }
    this->Compact();
    return this->Result;
  }

private:
  using Triangle = std::array<Id, 3>;

  Id GetNumberOfTriangles() const { return static_cast<Id>(this->Triangles.size() / 3); }
  Triangle Get(Id f) const
  {
    return { { this->Triangles[3 * f], this->Triangles[3 * f + 1], this->Triangles[3 * f + 2] } };
  }
  void Set(Id f, const Triangle& t) { std::copy(t.begin(), t.end(), &this->Triangles[3 * f]); }
  bool Has(Id f, Id point) const
  {
    const Triangle t = this->Get(f);
    return std::find(t.begin(), t.end(), point) != t.end();
  }
  bool IsGone(Id f) const { return this->Parents[f] == NoId; }

  double Length(Id a, Id b) const
  {
    const double* p = this->Points + 3 * static_cast<std::size_t>(a);
    const double* q = this->Points + 3 * static_cast<std::size_t>(b);
    return Norm(Norm(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
  }

  /// Returns the height of a point above the line through two others.
  double Height(Id p, Id a, Id b) const
  {
    std::array<double, 3> u{};
    std::array<double, 3> v{};
    for (int k = 0; k < 3; ++k)
    {
      u[k] = this->Points[3 * static_cast<std::size_t>(p) + k] -
        this->Points[3 * static_cast<std::size_t>(a) + k];
      v[k] = this->Points[3 * static_cast<std::size_t>(b) + k] -
        this->Points[3 * static_cast<std::size_t>(a) + k];
    }
    return Norm(Norm(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2]),
             u[0] * v[1] - u[1] * v[0]) /
      this->Length(a, b);
  }

  /// Returns the lengths of the edges opposite to the corners of a triangle.
  std::array<double, 3> GetOpposite(Id f) const
  {
    const Triangle t = this->Get(f);
    return { { this->Length(t[1], t[2]), this->Length(t[2], t[0]), this->Length(t[0], t[1]) } };
  }

  /// Returns the two shorter edges minus the longest, given in ascending order.
  static double GetSlack(const std::array<double, 3>& sorted)
  {
    return sorted[0] - (sorted[2] - sorted[1]);
  }

  /// Returns the squared lengths of the edges of a triangle.
  std::array<double, 3> GetSquares(Id f) const
  {
    const Triangle t = this->Get(f);
    const Point3 p = PointAt(this->Points, t[0]);
    const Point3 q = PointAt(this->Points, t[1]);
    const Point3 r = PointAt(this->Points, t[2]);
    return { { Dot(q - p, q - p), Dot(r - q, r - q), Dot(p - r, p - r) } };
  }

  /// Returns true if an angle of a triangle with the given squared lengths exceeds 120 degrees.
  /// Otherwise its slack is at least a quarter of its shortest edge, too much for a cap.
  static bool IsVeryObtuse(const std::array<double, 3>& squares)
  {
    const double a = squares[0];
    const double b = squares[1];
    const double c = squares[2];
    const double largest = std::max({ a, b, c });
    const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
    const double smallest = std::min({ a, b, c });
    const double excess = largest - middle - smallest;
    return !(excess <= 0.0 || excess * excess < smallest * middle);
  }

  /// Finds all caps of the input. The mean edge length is only needed if a slack is small.
  void FindCaps()
  {
    std::vector<Id> obtuse;
    double longest = 0.0;
    for (Id f = 0; f < this->GetNumberOfTriangles(); ++f)
    {
      const std::array<double, 3> squares = this->GetSquares(f);
      longest = std::max({ longest, squares[0], squares[1], squares[2] });
      if (IsVeryObtuse(squares))
      {
        obtuse.push_back(f);
      }
    }
    // Upper bound of the tolerances of all triangles.
    const double tolerance = 2.0 * DegeneracySlack * std::sqrt(longest);
    const auto isNoCap = [&](Id f) {
      std::array<double, 3> lengths = this->GetOpposite(f);
      std::sort(lengths.begin(), lengths.end());
      return GetSlack(lengths) >= tolerance;
    };
    obtuse.erase(std::remove_if(obtuse.begin(), obtuse.end(), isNoCap), obtuse.end());
    if (obtuse.empty())
    {
      return;
    }
    double sum = 0.0;
    for (Id f = 0; f < this->GetNumberOfTriangles(); ++f)
    {
      const std::array<double, 3> lengths = this->GetOpposite(f);
      sum += lengths[2] + lengths[0] + lengths[1];
    }
    this->MeanEdge = sum / static_cast<double>(this->Triangles.size());
    std::for_each(obtuse.begin(), obtuse.end(), [this](Id f) { this->NoteCap(f); });
  }

  /// Returns the corner on the opposite edge; -1 if there is none.
  int FindApex(Id f) const
  {
    const std::array<double, 3> opposite = this->GetOpposite(f);
    std::array<double, 3> sorted = opposite;
    std::sort(sorted.begin(), sorted.end());
    const double tolerance = DegeneracySlack * std::max(this->MeanEdge, sorted[2]);
    const bool isCap = GetSlack(sorted) < tolerance && sorted[0] > ShortestEdge * tolerance;
    const auto apex = std::max_element(opposite.begin(), opposite.end()) - opposite.begin();
    return isCap ? static_cast<int>(apex) : -1;
  }

  void NoteCap(Id f)
  {
    if (this->FindApex(f) >= 0)
    {
      this->Caps.push_back(f);
    }
  }

  /// Returns the triangles on the edge between two points.
  std::vector<Id>& On(Id a, Id b)
  {
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    return this->Edges[(low << 32) | static_cast<std::uint64_t>(std::max(a, b))];
  }

  void Link(Id f)
  {
    const Triangle t = this->Get(f);
    for (int k = 0; k < 3; ++k)
    {
      this->On(t[k], t[(k + 1) % 3]).push_back(f);
    }
  }

  void Unlink(Id f)
  {
    const Triangle t = this->Get(f);
    for (int k = 0; k < 3; ++k)
    {
      std::vector<Id>& faces = this->On(t[k], t[(k + 1) % 3]);
      faces.erase(std::remove(faces.begin(), faces.end(), f), faces.end());
    }
  }

  void Discard(Id f)
  {
    this->Unlink(f);
    this->Parents[f] = NoId;
  }

  void Remove(Id cap)
  {
    const int corner = this->IsGone(cap) ? -1 : this->FindApex(cap);
    if (corner < 0)
    {
      return; // removed with another cap, or no longer a cap
    }
    const Triangle t = this->Get(cap);
    const Id apex = t[corner];
    const Id a = t[(corner + 1) % 3];
    const Id b = t[(corner + 2) % 3];
    const std::vector<Id> faces = this->On(a, b);
    const auto copies = static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [&](Id f) { return this->Has(f, apex); }));
    if (faces.size() == copies &&
      (this->On(a, apex).size() == copies || this->On(apex, b).size() == copies))
    {
      return; // only this triangle connects its apex to one of the ends
    }
    ++this->Result.NumberOfCaps;
    const double height = this->Height(apex, a, b);
    this->Move(cap, height);
    this->Discard(cap);
    for (const Id f : faces)
    {
      if (f != cap)
      {
        this->Move(f, height);
        this->Split(f, a, b, apex);
      }
    }
  }

  /// Adds a displacement to a triangle, which accumulates all splits of its input triangle.
  void Move(Id f, double height)
  {
    this->Moved[f] += height;
    this->Result.LargestHeight = std::max(this->Result.LargestHeight, this->Moved[f]);
  }

  /// Splits a triangle on the edge from a to b at a point of the edge.
  void Split(Id f, Id a, Id b, Id point)
  {
    Triangle first = this->Get(f);
    if (this->Has(f, point))
    {
      this->Discard(f); // a duplicate of the cap
      return;
    }
    this->Unlink(f);
    Triangle second = first;
    std::replace(first.begin(), first.end(), b, point);
    std::replace(second.begin(), second.end(), a, point);
    this->Set(f, first);
    const Id g = this->GetNumberOfTriangles();
    this->Triangles.insert(this->Triangles.end(), second.begin(), second.end());
    this->Parents.push_back(this->Parents[f]);
    this->Moved.push_back(this->Moved[f]);
    for (const Id part : { f, g })
    {
      this->Link(part);
      this->NoteCap(part);
    }
  }

  void Compact()
  {
    Id kept = 0;
    for (Id f = 0; f < this->GetNumberOfTriangles(); ++f)
    {
      if (!this->IsGone(f))
      {
        this->Set(kept, this->Get(f));
        this->Parents[kept++] = this->Parents[f];
      }
    }
    this->Triangles.resize(3 * static_cast<std::size_t>(kept));
    this->Parents.resize(kept);
  }

  const double* Points;
  std::vector<Id>& Triangles;
  std::vector<Id>& Parents;  // NoId for removed triangles
  std::vector<double> Moved; // per triangle, accumulated displacement
  double MeanEdge = 0.0;
  std::vector<Id> Caps; // queue, in order of discovery
  std::unordered_map<std::uint64_t, std::vector<Id>> Edges;
  CapSplitting Result;
};
}

CapSplitting SplitCaps(const double* points, std::vector<Id>& triangles, std::vector<Id>& parents)
{
  return CapSplitter(points, triangles, parents).Run();
}
}
