// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bands: the regions of a surface between isolines.
#ifndef dggBands_h
#define dggBands_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggIsolines.h"      // for Isolines
#include "dggSubMesh.h"       // for SubMesh

#include <array>  // for the range
#include <vector> // for the bands

namespace dgg
{
struct FieldPieces;

/// A mesh cut along isolines, each face of which lies between two levels.
struct Bands
{
  SubMesh Surface;
  /// Levels in increasing order, each once. Band i lies between levels i - 1 and i; the first band
  /// is below all levels, the last band above.
  std::vector<double> Levels;
  std::vector<Id> BandOf;        ///< per face of the surface; NoId if unreached or not traced
  std::vector<double> Distances; ///< per vertex; on isolines exactly the level
  std::array<double, 2> Range{ { Infinity, -Infinity } }; ///< distances of faces in bands
};

/// Cuts a mesh along isolines, which must be the isolines of TraceIsolines() for these levels.
/// Points at a level count as farther than the level. Faces with unreached corners belong to no
/// band. If levels are equal, the mesh is cut only by the lines of the first one.
///
/// Bands change only across isolines, provided that the isolines are complete. Faces whose corners
/// are undecided take the band of their neighbors. After a failure, `bands` must not be used.
///
/// If several processes have pieces of the surface, all of them must call the function, with the
/// lines in their pieces and in the first layer of cells around their pieces.
DGG_CORE_EXPORT Status MakeBands(const DistanceField& field, const std::vector<double>& levels,
  const Isolines& lines, const ProgressCallback& progress, Bands& bands,
  FieldPieces* pieces = nullptr);
}

#endif
