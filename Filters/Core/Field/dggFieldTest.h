// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether numbers at vertices can be a distance at all.
#ifndef dggFieldTest_h
#define dggFieldTest_h

#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggTypes.h"       // for Offset, Status

#include <cstdint> // for FieldVerdict
#include <string>  // for the sentence

namespace dgg
{
enum class FieldVerdict : std::uint8_t
{
  Distance, ///< about the way from its minima nearly everywhere
  Scaled,   ///< a distance in other units than those of the mesh
  NotADistance,
  NothingKnown ///< no two neighbours are reached
};

struct FieldReport
{
  FieldVerdict Verdict = FieldVerdict::NothingKnown;
  Offset NumberOfEdges = 0;    ///< edges of faces with both ends reached, once per face
  Offset NumberOfVertices = 0; ///< vertices that are reached and have a neighbour that is
  /// Largest difference along an edge, over its length: 1 at most for a distance.
  double WorstSlope = 0.0;
  /// Part of the edges along which the field changes by clearly more than their length.
  double ShareOfSteepEdges = 0.0;
  /// How steeply the field, linear in faces, falls from vertices: the middle slope, and the part of
  /// vertices where it is within 10 % of 1. All distances fall at slope 1 but at sources.
  double MedianSlope = 0.0;
  double ShareOfUnitSlopes = 0.0;
  /// Part of the vertices that are clearly nearer than their way from the minima of the field.
  double ShareOfShortcuts = 0.0;
  /// Part of the vertices that are as far away as all their neighbours, and no minima.
  double ShareOfFlatVertices = 0.0;
  /// What to tell the user; empty when it is a distance.
  std::string Sentence;

  bool IsDistance() const { return this->Verdict == FieldVerdict::Distance; }
};

/// Tell a distance from other fields. A distance is the length of the shortest way from its minima,
/// which start at its values there. So the values are compared with such ways, exact ones on meshes
/// of up to 2000 faces, else those of fast marching: what differs by more than 10 %, and by more
/// than sources in faces beside the minima explain, may be nearer on 20 % of the vertices, and, but
/// where half of all slopes are about 1, farther on 20 %. At most 10 % of the edges may be too
/// steep and 5 % of the vertices even with all neighbours. The field may also come in from the
/// boundary and from what is not known. These limits are measured: exact distances pass, those of
/// graphs, fast marching and heat too, from any sources, from within faces and with any initial
/// distances; coarse meshes tell little, so that more passes there. `values` are per vertex;
/// Infinity or NaN where nothing is known, which is left out. Fails when stopped, and where the
/// solvers fail.
Status TestField(const SurfaceMesh& mesh, const double* values, const ProgressCallback& progress,
  FieldReport& report);
}

#endif
