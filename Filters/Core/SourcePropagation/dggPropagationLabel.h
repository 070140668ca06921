// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources in the frames of faces. Internal.
#ifndef dggPropagationLabel_h
#define dggPropagationLabel_h

#include "dggPropagationFaces.h" // for the corners

#include <algorithm> // for std::min and std::max
#include <cmath>     // for std::sqrt
#include <limits>    // for UnreachedKey

/// Labels are small structures that are modified while they are passed between functions. They must
/// stay in registers, since writing single members and reading the entire structure stalls on store
/// forwarding (twice the running time).
#if defined(__GNUC__)
#define DGG_INLINE inline __attribute__((always_inline))
#else
#define DGG_INLINE inline
#endif

namespace dgg
{
/// Relative difference below which distances are equal. Otherwise labels could circulate forever,
/// with a tiny gain by rounding each time.
constexpr float PropagationRounding = 5e-7F;
inline constexpr float UnreachedKey = std::numeric_limits<float>::max();

/// A virtual source in the frame of the half-edge through which it entered a face.
struct PropagationLabel
{
  float X; ///< position in the frame of Entry, below its axis
  float Y;
  float Offset; ///< distance at the virtual source
  Id Entry;     ///< the half-edge through which it was unfolded
  Id Root;      ///< index of the source
};

/// Returns true if a label precedes another one with an equal key. The order is total, so that
/// among simultaneous arrivals the same label is kept regardless of the order of threads.
inline bool ComesBefore(const PropagationLabel& a, const PropagationLabel& b)
{
  if (a.Entry != b.Entry)
  {
    return a.Entry < b.Entry;
  }
  if (a.Root != b.Root)
  {
    return a.Root < b.Root;
  }
  return a.Offset != b.Offset ? a.Offset < b.Offset : a.X != b.X ? a.X < b.X : a.Y < b.Y;
}

inline float PlaneLength(float x, float y)
{
  return std::sqrt(x * x + y * y);
}

/// Tolerance by which a line may pass beyond an end of the axis, relative to the length of the
/// axis: paths straight through a vertex must not bend because of rounding.
constexpr float BendSlack = 1e-4F;

/// If the straight line from the source of a label to a point above the axis passes beyond an end
/// of the axis, that end becomes the source.
inline void BendAround(PropagationLabel& label, float length, float x, float y)
{
  const float slack = BendSlack * length * (y - label.Y + std::abs(x - label.X));
  if (label.Y * (x - label.X) - label.X * (y - label.Y) > slack)
  {
    label.Offset += PlaneLength(label.X, label.Y);
    label.X = 0.0F;
    label.Y = 0.0F;
  }
  else if ((length - label.X) * (y - label.Y) + label.Y * (x - label.X) < -slack)
  {
    label.Offset += PlaneLength(length - label.X, label.Y);
    label.X = length;
    label.Y = 0.0F;
  }
}

/// The path from a virtual source to a corner of the face that it has entered: straight, or bent
/// around an end of the entry.
struct Way
{
  PropagationLabel Label; ///< label after the bend
  float X;                ///< position of the corner, in the frame of the entry
  float Y;
  float Length; ///< distance from the label to the corner

  float GetDistance() const { return this->Label.Offset + this->Length; }
};

DGG_INLINE Way WayTo(int corner, const PropagationLabel& label, const PropagationFace& face)
{
  const int k = label.Entry % 3;
  Way way{ label, 0.0F, 0.0F, 0.0F };
  if (corner == PreviousOf(k))
  {
    const float left = face.Lengths[corner];
    way.X = left * face.Cosines[k];
    way.Y = left * face.Sines[k];
    BendAround(way.Label, face.Lengths[k], way.X, way.Y);
  }
  else if (corner == NextOf(k))
  {
    way.X = face.Lengths[k];
  }
  way.Length = PlaneLength(way.X - way.Label.X, way.Y - way.Label.Y);
  return way;
}

/// Transforms a label into the frame of the twin of one of the two half-edges through which it
/// leaves.
DGG_INLINE void UnfoldTo(int side, PropagationLabel& label, const PropagationFace& face)
{
  // Same formulas as in FaceUnfolding.
  const int k = label.Entry % 3;
  const float length = face.Lengths[side];
  const bool isLeft = side == PreviousOf(k);
  const float x = isLeft ? label.X : face.Lengths[k] - label.X;
  const float cosine = face.Cosines[isLeft ? k : side];
  const float sine = face.Sines[isLeft ? k : side];
  const float along = cosine * x + sine * label.Y;
  label.Y = cosine * label.Y - sine * x;
  label.X = isLeft ? along : length - along;
  if (label.Y > 0.0F)
  {
    // The source is on the far side, for example behind a hole: the path bends around the nearer
    // end.
    const float end = 2.0F * label.X < length ? 0.0F : length;
    label.Offset += PlaneLength(label.X - end, label.Y);
    label.X = end;
    label.Y = 0.0F;
  }
}

/// Tolerance by which a source may reach the end of an edge earlier than any path found so far,
/// relative to the edge length, or to a multiple of the height of the face if the face is thinner.
/// Paths that are found later are shorter by less than the tolerance; shadows cause larger
/// differences. Without a tolerance, errors on scans double; without the limit for thin faces,
/// which a path may cross one after the other, distances on CAD models are up to 55 % too short.
constexpr float ShadowTolerance = 0.05F;
constexpr float ThinFaceAspect = 5.0F; ///< edge length of a thin face, in heights

/// Moves a source so that it does not reach an end of the axis earlier than the distance known so
/// far. `height` is that of the face behind the axis.
DGG_INLINE void StayOutOfShadows(
  PropagationLabel& label, float length, float height, float knownA, float knownB)
{
  const float tolerance = ShadowTolerance * std::min(length, ThinFaceAspect * height);
  float a = PlaneLength(label.X, label.Y);
  float b = PlaneLength(length - label.X, label.Y);
  const bool isHiddenA = knownA < UnreachedKey && knownA - label.Offset > a + tolerance;
  const bool isHiddenB = knownB < UnreachedKey && knownB - label.Offset > b + tolerance;
  if (!isHiddenA && !isHiddenB)
  {
    return;
  }
  a = isHiddenA ? knownA - label.Offset : a;
  b = isHiddenB ? knownB - label.Offset : b;
  if (std::abs(a - b) <= length)
  {
    label.X = 0.5F * (length + (a - b) * (a + b) / length);
    label.Y = -std::sqrt(std::max(0.0F, a * a - label.X * label.X));
  }
  else
  {
    label.Offset += std::min(a, b);
    label.X = a < b ? 0.0F : length;
    label.Y = 0.0F;
  }
}

/// Returns true if the source is the origin of the entry. Then the other end of the entry need not
/// be behind any crossed edge.
inline bool IsAtOrigin(const PropagationLabel& label)
{
  return label.X == 0.0F && label.Y == 0.0F;
}

/// A path to a vertex by a label that no face or edge stores.
struct PropagationShortcut
{
  Id Vertex;
  float Distance;
  /// Label that has entered a face at the vertex. If the path follows an edge from the origin of
  /// its entry, its root is NoId, which means the root of that vertex.
  PropagationLabel Label;
};

/// Returns the path from one corner of a face to another along their edge.
inline PropagationShortcut WayAlongEdge(
  Id f, const PropagationFace& face, int from, int to, float start)
{
  const float length = face.Lengths[to == NextOf(from) ? from : to];
  return { face.Corners[to], start + length, { 0.0F, 0.0F, start, 3 * f + from, NoId } };
}

/// A virtual source as seen from a vertex.
struct VirtualPlace
{
  double Length = 0.0; ///< straight distance
  Id HalfEdge = NoId;  ///< half-edge at the vertex from which Angle is measured; NoId at the source
  double Angle = 0.0;
};
}

#endif
