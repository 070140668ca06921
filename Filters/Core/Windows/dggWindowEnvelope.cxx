// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowEnvelope.h"

#include "dggRootFinding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Pieces narrower than this, by their own scale and that of an adjacent neighbor, are merged into
/// that neighbor; relative, see Window::Tolerance(). Its paths then leave their strip by at most
/// that much, which changes lengths by the square. Without merging, rounding would create separate
/// windows for slivers where shadows of several collinear pseudo-sources meet.
constexpr double PieceTolerance = 1e-9;

/// Relative tolerance of ties between windows (some ulps).
constexpr double TieTolerance = 4e-15;

/// Relative precision of ties found by bisection, and maximum number of steps: the number from the
/// largest to the smallest double.
constexpr double TiePrecision = 1e-15;
constexpr int MaximumBisections = 2100;

/// Returns the abscissa where the path through the origin (at distance `u` beyond the
/// pseudo-source) and along the axis is as long as the straight line from the image: |x - I| = u +
/// x.
double EqualWayOverOrigin(double imageX, double imageY, double u)
{
  return (imageX * imageX + imageY * imageY - u * u) / (2.0 * (imageX + u));
}

/// Appends the part [begin, end] of a window to an envelope that ends at or before it.
void Append(WindowList& out, const Window& w, double begin, double atBegin, double end,
  double atEnd, double length)
{
  if (!out.empty() && out.back().End == begin)
  {
    Window& back = out.back();
    if (back.HasSameOrigin(w))
    {
      back.End = end;
      back.DistanceAtEnd = atEnd;
      return;
    }
    if (end - begin <
      std::min(w.Tolerance(PieceTolerance, length), back.Tolerance(PieceTolerance, length)))
    {
      back.End = end;
      back.DistanceAtEnd = back.DistanceAt(end);
      return;
    }
  }
  if (end - begin < w.Tolerance(IntervalTolerance, length))
  {
    return;
  }
  out.push_back(w);
  Window& back = out.back();
  back.Begin = begin;
  back.End = end;
  back.DistanceAtBegin = atBegin;
  back.DistanceAtEnd = atEnd;
}

/// Finds the only extremum of the difference of two windows, if within (begin, end): the point
/// where the line through their images meets the axis. The difference is monotone on both sides.
bool ExtremumOfDifference(
  const Window& a, const Window& b, double begin, double end, double& extremum)
{
  const double rise = b.Image.Y - a.Image.Y;
  if (rise == 0.0)
  {
    return false;
  }
  extremum = a.Image.X - (b.Image.X - a.Image.X) * a.Image.Y / rise;
  return extremum > begin && extremum < end;
}

bool IsRounding(double one, double other)
{
  return std::abs(one - other) <= TieTolerance * one;
}

/// Returns true if two windows tie at x, up to rounding, and their order changes there. They may
/// also tie at an end of the interval, where the order does not change.
bool IsTie(const Window& a, const Window& b, double begin, double end, double x)
{
  if (!IsRounding(a.DistanceAt(x), b.DistanceAt(x)))
  {
    return false;
  }
  const double margin = 1e-3 * (end - begin);
  if (x > begin + margin && x < end - margin)
  {
    return true;
  }
  // Close to an end, the entire remaining interval must belong to the window that is shorter at the
  // other end.
  const double middle = 0.5 * (begin + end);
  const double other = x < middle ? end : begin;
  const double near = x < middle ? begin + 2.0 * margin : end - 2.0 * margin;
  return (a.DistanceAt(other) < b.DistanceAt(other)) == (a.DistanceAt(near) < b.DistanceAt(near));
}

double BisectForTie(const Window& a, const Window& b, double begin, double end)
{
  auto difference = [&](double x) { return a.DistanceAt(x) - b.DistanceAt(x); };
  // If the windows also tie at one end, up to rounding, the other end decides.
  const double atBegin = difference(begin);
  const double atEnd = difference(end);
  const bool beginIsNegative = std::abs(atBegin) > std::abs(atEnd) ? atBegin < 0.0 : atEnd > 0.0;
  return Bisect(begin, end, TiePrecision, MaximumBisections,
    [&](double x) { return (difference(x) < 0.0) == beginIsNegative; });
}

/// Reads an envelope window by window; the front window may be trimmed from the left.
class Reader
{
public:
  Reader(const Window* begin, const Window* end)
    : Next(begin)
    , Stop(end)
  {
    this->Advance();
  }
  bool IsDone() const { return this->Done; }
  void Advance()
  {
    this->Done = this->Next == this->Stop;
    if (!this->Done)
    {
      this->Front = *this->Next++;
    }
  }
  void CutAt(double x, double atX)
  {
    this->Front.Begin = x;
    this->Front.DistanceAtBegin = atX;
    if (x >= this->Front.End)
    {
      this->Advance();
    }
  }
  Window Front;

private:
  const Window* Next;
  const Window* Stop;
  bool Done = false;
};

/// Merges two envelopes in a sweep from left to right, piece by piece.
class Sweep
{
public:
  Sweep(const Reader& first, const Reader& second, double length, WindowList& out)
    : A(first)
    , B(second)
    , Length(length)
    , Out(out)
  {
  }

  void Run()
  {
    while (!this->A.IsDone() && !this->B.IsDone())
    {
      if (this->A.Front.End <= this->B.Front.Begin)
      {
        this->Take(this->A);
      }
      else if (this->B.Front.End <= this->A.Front.Begin)
      {
        this->Take(this->B);
      }
      else if (this->A.Front.Begin < this->B.Front.Begin)
      {
        this->TakeUpTo(this->A, this->B.Front.Begin);
      }
      else if (this->B.Front.Begin < this->A.Front.Begin)
      {
        this->TakeUpTo(this->B, this->A.Front.Begin);
      }
      else
      {
        this->ResolveOverlap();
      }
    }
    for (; !this->A.IsDone(); this->A.Advance())
    {
      this->Write(this->A.Front);
    }
    for (; !this->B.IsDone(); this->B.Advance())
    {
      this->Write(this->B.Front);
    }
  }

private:
  void Write(const Window& w)
  {
    Append(this->Out, w, w.Begin, w.DistanceAtBegin, w.End, w.DistanceAtEnd, this->Length);
  }

  void Take(Reader& reader)
  {
    this->Write(reader.Front);
    reader.Advance();
  }

  void TakeUpTo(Reader& reader, double x)
  {
    const double atX = reader.Front.DistanceAt(x);
    Append(this->Out, reader.Front, reader.Front.Begin, reader.Front.DistanceAtBegin, x, atX,
      this->Length);
    reader.CutAt(x, atX);
  }

  /// Handles fronts that begin at the same point: writes the shorter one, or both in sequence, up
  /// to the first end. If only rounding decides, within the rounding error, the window with the
  /// nearer image is used: the same width is a wider angle there, which would be missed otherwise.
  void ResolveOverlap()
  {
    const Window& a = this->A.Front;
    const Window& b = this->B.Front;
    const double begin = a.Begin;
    const double end = std::min(a.End, b.End);
    const double aEnd = a.End == end ? a.DistanceAtEnd : a.DistanceAt(end);
    const double bEnd = b.End == end ? b.DistanceAtEnd : b.DistanceAt(end);
    const bool tie = end - begin < 4.0 * PositionRounding * this->Length &&
      IsRounding(a.DistanceAtBegin, b.DistanceAtBegin) && IsRounding(aEnd, bEnd);
    const bool aIsNearer = a.Image.Y >= b.Image.Y;
    const bool aWinsAtBegin = tie ? aIsNearer : a.DistanceAtBegin <= b.DistanceAtBegin;
    const bool aWinsAtEnd = tie ? aIsNearer : aEnd <= bEnd;
    if (aWinsAtBegin != aWinsAtEnd)
    {
      this->WriteBoth(
        aWinsAtBegin ? a : b, aWinsAtBegin ? b : a, begin, end, aWinsAtEnd ? aEnd : bEnd);
    }
    else
    {
      const Window& winner = aWinsAtBegin ? a : b;
      const Window& loser = aWinsAtBegin ? b : a;
      const double winnerEnd = aWinsAtBegin ? aEnd : bEnd;
      // The loser may still be shorter in between if its image is nearer.
      double middle = 0.0;
      if (loser.Image.Y > winner.Image.Y &&
        ExtremumOfDifference(winner, loser, begin, end, middle) &&
        loser.DistanceAt(middle) < winner.DistanceAt(middle) * (1.0 - LengthTolerance))
      {
        const double atMiddle = loser.DistanceAt(middle);
        this->WriteBoth(winner, loser, begin, middle, atMiddle);
        this->WriteBoth(loser, winner, middle, end, winnerEnd);
      }
      else
      {
        Append(this->Out, winner, begin, winner.DistanceAtBegin, end, winnerEnd, this->Length);
      }
    }
    this->A.CutAt(end, aEnd);
    this->B.CutAt(end, bEnd);
  }

  /// Writes both windows; `first` is shorter at begin, `second` at end.
  void WriteBoth(
    const Window& first, const Window& second, double begin, double end, double secondAtEnd)
  {
    const double tie = TiePoint(first, second, begin, end);
    const double atTie = first.DistanceAt(tie);
    const double atBegin = begin == first.Begin ? first.DistanceAtBegin : first.DistanceAt(begin);
    Append(this->Out, first, begin, atBegin, tie, atTie, this->Length);
    Append(this->Out, second, tie, atTie, end, secondAtEnd, this->Length);
  }

  Reader A;
  Reader B;
  double Length;
  WindowList& Out;
};
}

bool TrimByEnds(Window& w, double length, double atOrigin, double atEnd)
{
  constexpr double shorter = 1.0 - LengthTolerance;
  if (atOrigin + w.Begin < w.DistanceAtBegin * shorter)
  {
    // |x - I| - x decreases with x, so that the useless part is on the left.
    if (atOrigin + w.End <= w.DistanceAtEnd * shorter)
    {
      return false;
    }
    const double x = EqualWayOverOrigin(w.Image.X, w.Image.Y, atOrigin - w.Sigma);
    if (x > w.Begin && x < w.End)
    {
      w.Begin = x;
      w.DistanceAtBegin = atOrigin + x;
    }
  }
  if (atEnd + (length - w.End) < w.DistanceAtEnd * shorter)
  {
    if (atEnd + (length - w.Begin) <= w.DistanceAtBegin * shorter)
    {
      return false;
    }
    const double x = length - EqualWayOverOrigin(length - w.Image.X, w.Image.Y, atEnd - w.Sigma);
    if (x > w.Begin && x < w.End)
    {
      w.End = x;
      w.DistanceAtEnd = atEnd + (length - x);
    }
  }
  return !w.IsTooNarrow(length);
}

double TiePoint(const Window& first, const Window& second, double begin, double end)
{
  // Squaring sigma1 + |x - I1| = sigma2 + |x - I2| twice gives a quadratic equation (Surazhsky et
  // al., "Fast exact and approximate geodesics on meshes", 2005, appendix A). Abscissae are
  // relative to `begin`.
  const double x1 = first.Image.X - begin;
  const double x2 = second.Image.X - begin;
  const double alpha = x2 - x1;
  const double beta = second.Sigma - first.Sigma;
  const double gamma = (x1 - x2) * (x1 + x2) +
    (first.Image.Y - second.Image.Y) * (first.Image.Y + second.Image.Y) - beta * beta;
  const double width = end - begin;
  if (beta == 0.0)
  {
    const double x = -gamma / (2.0 * alpha); // the bisector
    if (x >= 0.0 && x <= width)
    {
      return begin + x;
    }
  }
  else
  {
    const double square2 = x2 * x2 + second.Image.Y * second.Image.Y;
    const double a = (alpha - beta) * (alpha + beta);
    const double b = 0.5 * alpha * gamma + beta * beta * x2;
    const double c = 0.25 * gamma * gamma - beta * beta * square2;
    // At the start of the shadow of a pseudo-source, both roots coincide up to rounding.
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    const double q = -(b + std::copysign(root, b));
    for (double x : { q / a, c / q })
    {
      const double margin = PieceTolerance * width;
      if (x > -margin && x < width + margin && (2.0 * alpha * x + gamma > 0.0) == (beta > 0.0))
      {
        x = std::min(width, std::max(0.0, x));
        if (IsTie(first, second, begin, end, begin + x))
        {
          return begin + x;
        }
      }
    }
  }
  return BisectForTie(first, second, begin, end);
}

void MergeEnvelopes(
  const WindowList& first, const WindowList& second, double length, WindowList& out)
{
  out.clear();
  Sweep({ first.data(), first.data() + first.size() },
    { second.data(), second.data() + second.size() }, length, out)
    .Run();
}

WindowList MakeEnvelope(const Window* begin, const Window* end, double length)
{
  if (end - begin < 2)
  {
    return WindowList(begin, end);
  }
  const Window* middle = begin + (end - begin) / 2;
  WindowList merged;
  MergeEnvelopes(
    MakeEnvelope(begin, middle, length), MakeEnvelope(middle, end, length), length, merged);
  return merged;
}

bool InsertIntoEnvelope(
  WindowList& list, const Window& w, double length, WindowList& scratch, std::ptrdiff_t mostBeyond)
{
  if (list.empty() || list.back().End <= w.Begin)
  {
    Append(list, w, w.Begin, w.DistanceAtBegin, w.End, w.DistanceAtEnd, length);
    return true;
  }
  // The common case: children of neighboring windows overlap, and each is shorter on its own side.
  Window& back = list.back();
  if (back.Begin < w.Begin && back.End < w.End && back.DistanceAt(w.Begin) < w.DistanceAtBegin &&
    w.DistanceAt(back.End) < back.DistanceAtEnd)
  {
    const double tie = TiePoint(back, w, w.Begin, back.End);
    const double atTie = w.DistanceAt(tie);
    back.End = tie;
    back.DistanceAtEnd = atTie;
    Append(list, w, tie, atTie, w.End, w.DistanceAtEnd, length);
    return true;
  }
  auto tail = list.end();
  while (tail != list.begin() && (tail - 1)->End > w.Begin)
  {
    --tail;
    if (list.end() - tail > mostBeyond)
    {
      return false;
    }
  }
  scratch.assign(tail, list.end());
  list.erase(tail, list.end());
  Sweep({ scratch.data(), scratch.data() + scratch.size() }, { &w, &w + 1 }, length, list).Run();
  return true;
}
}
