// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudPairs.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Sine of the steepest angle between a chord and the tangent planes at both of its ends.
const double SteepestChord = std::sin(Pi / 3.0);
/// Sides that normals point to are opposite when the cosine between them is below that.
const double OppositeNormals = std::cos(100.0 / 180.0 * Pi);
/// Chords that sheets back to back are looked for at, by the radius of a ball.
constexpr double SheetsReach = 4.0;
/// A turn is too large for long chords: longer than that many spacings.
constexpr double ShortChord = 3.0;
}

double CloudPairs::Length(Id p, Id q, double chord) const
{
  if (!this->UsesArcs)
  {
    return chord;
  }
  if (p > q)
  {
    std::swap(p, q); // the same bits both ways round
  }
  const ChordAngles angles =
    MeasureChord(this->Points[q] - this->Points[p], chord, this->Normals[p], this->Normals[q]);
  return chord * ArcFactor(angles, static_cast<double>(this->Noise[p]) + this->Noise[q]);
}

bool CloudPairs::IsDirect(Id p, Id q, double chord) const
{
  const Point3 e = this->Points[q] - this->Points[p];
  const double a = std::abs(Dot(this->Normals[p], e));
  const double b = std::abs(Dot(this->Normals[q], e));
  if (a > SteepestChord * chord && b > SteepestChord * chord)
  {
    return false;
  }
  if (this->HasOrientedNormals && Dot(this->Normals[p], this->Normals[q]) < OppositeNormals &&
    chord < SheetsReach * std::max(this->Radii[p], this->Radii[q]))
  {
    return false;
  }
  if (this->UsesArcs && chord > ShortChord * std::max(this->Spacings[p], this->Spacings[q]) &&
    MeasureChord(e, chord, this->Normals[p], this->Normals[q]).IsTurnTooLarge())
  {
    return false;
  }
  return this->Band.ContainsSegment(
    this->Band.ToGrid(this->Points[p]), this->Band.ToGrid(this->Points[q]));
}
}
