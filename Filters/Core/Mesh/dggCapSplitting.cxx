// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCapSplitting.h"

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

  /// Finds all caps of the input and its mean edge length, reading each length once.
  void FindCaps()
  {
    std::vector<double> slacks;
    slacks.reserve(this->Parents.size());
    double sum = 0.0;
    double longest = 0.0;
    for (Id f = 0; f < this->GetNumberOfTriangles(); ++f)
    {
      const Triangle t = this->Get(f);
      const double a = this->Length(t[0], t[1]);
      const double b = this->Length(t[1], t[2]);
      const double c = this->Length(t[2], t[0]);
      sum += a + b + c;
      const double largest = std::max({ a, b, c });
      const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
      slacks.push_back(std::min({ a, b, c }) - (largest - middle));
      longest = std::max(longest, largest);
    }
    this->MeanEdge = sum / static_cast<double>(std::max<std::size_t>(1, this->Triangles.size()));
    // Upper bound of the tolerances of all triangles.
    const double tolerance = DegeneracySlack * std::max(this->MeanEdge, longest);
    for (Id f = 0; f < this->GetNumberOfTriangles(); ++f)
    {
      if (slacks[f] < tolerance)
      {
        this->NoteCap(f);
      }
    }
  }

  /// Returns the corner on the opposite edge; -1 if there is none.
  int FindApex(Id f) const
  {
    const Triangle t = this->Get(f);
    std::array<double, 3> opposite{};
    for (int k = 0; k < 3; ++k)
    {
      opposite[k] = this->Length(t[(k + 1) % 3], t[(k + 2) % 3]);
    }
    const int apex =
      static_cast<int>(std::max_element(opposite.begin(), opposite.end()) - opposite.begin());
    const double longest = opposite[apex];
    const auto others = std::minmax(opposite[(apex + 1) % 3], opposite[(apex + 2) % 3]);
    const double tolerance = DegeneracySlack * std::max(this->MeanEdge, longest);
    const bool isCap = others.first - (longest - others.second) < tolerance &&
      others.first > ShortestEdge * tolerance;
    return isCap ? apex : -1;
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

  /// A triangle accumulates the displacements of all splits of its input triangle.
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
