// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Virtual sources as faces see them. Internal.
#ifndef dggPropagationLabel_h
#define dggPropagationLabel_h

#include "dggPropagationFaces.h" // for the corners

#include <cmath> // for std::sqrt

/// Labels are small structures that are handed on while they change: they have to stay in registers
/// all the way, or what is written piece by piece and read as a whole stalls (twice the time).
#if defined(__GNUC__)
#define DGG_INLINE inline __attribute__((always_inline))
#else
#define DGG_INLINE inline
#endif

namespace dgg
{
/// A virtual source as a face sees it.
struct PropagationLabel
{
  float X; ///< in the frame of Entry, below its axis
  float Y;
  float Offset; ///< distance at the virtual source
  Id Entry;     ///< the half-edge through which it was unfolded
  Id Root;      ///< which source it comes from
};

/// An order of labels with the same key, so that of several that arrive at once the same one is
/// kept, whoever comes first.
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

/// The end of the axis, if the straight line from the source of a label to a point above the axis
/// passes beyond that end, becomes the source.
inline void BendAround(PropagationLabel& label, float length, float x, float y)
{
  if (label.Y * (x - label.X) - label.X * (y - label.Y) > 0.0F)
  {
    label.Offset += PlaneLength(label.X, label.Y);
    label.X = 0.0F;
    label.Y = 0.0F;
  }
  else if ((length - label.X) * (y - label.Y) + label.Y * (x - label.X) < 0.0F)
  {
    label.Offset += PlaneLength(length - label.X, label.Y);
    label.X = length;
    label.Y = 0.0F;
  }
}

/// The way from a virtual source to a corner of the face that it has entered: straight, or bent
/// around an end of the entry.
struct Way
{
  PropagationLabel Label; ///< after the bend
  float X;                ///< the corner, in the frame of the entry
  float Y;
  float Length; ///< from the label

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

/// Whether the source is the vertex that the entry starts at. Then its other end need not be behind
/// any edge that is crossed.
inline bool IsAtOrigin(const PropagationLabel& label)
{
  return label.X == 0.0F && label.Y == 0.0F;
}
}

#endif
