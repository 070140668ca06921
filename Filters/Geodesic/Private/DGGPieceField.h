// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances on the piece of this process. Internal.
#ifndef DGGPieceField_h
#define DGGPieceField_h

#include "DGGContext.h" // for the context

#include "dggFieldReader.h"  // for the distances
#include "dggPieceSurface.h" // for the surface

#include "vtkNew.h"      // for the input
#include "vtkPolyData.h" // for the input

#include <memory>   // for the surface
#include <optional> // for the distances
#include <string>   // for names

struct DGGPieceUpdate;
class vtkDataArray;
class vtkInformation;

/// Distances on a surface that several processes have in pieces, for filters that compute in each
/// face. Each process has the distances of its piece, and of the cells around its piece.
class DGGPieceField
{
public:
  struct Options
  {
    std::string Distances; ///< property, see DGGFindDistances()
    std::string VirtualSources;
    ///@{
    /// Must be the same on all processes. A linear field uses neither virtual sources nor windows.
    bool IsLinear;
    double UnreachedValue;
    ///@}
  };

  /// Finds distances and virtual sources. `isDone` becomes false on all processes if the pieces
  /// must be gathered: for the reasons of PieceSurface::Prepare(), on long triangles, if there are
  /// windows, or if arrays are missing or are not those of vtkDGGDistance. `filter` is the
  /// information object of the filter.
  dgg::Status Update(const DGGContext& context, const DGGPieceUpdate& update,
    vtkInformation* filter, const Options& options, bool& isDone);

  ///@{
  /// Results of Update(), valid until the next one.
  const dgg::PieceSurface& GetSurface() const { return *this->Surface; }
  const dgg::FieldReader& GetReader() const { return *this->Reader; }
  /// Returns the field, with the layers of faces around the piece.
  dgg::DistanceField GetField() const;
  DGGContext MakeContext(const DGGContext& context) const;
  const std::string& GetName() const { return this->Name; }
  ///@}

private:
  dgg::Status Prepare(const DGGPieceUpdate& update, bool& isDone);
  void MakeInput(vtkPolyData* piece);
  dgg::Status AddArray(const DGGPieceUpdate& update, vtkDataArray* array, const std::string& name,
    int components, bool isRequired, bool& isDone);
  bool AreConsistent() const;

  dgg::Signature Piece{};                     // of the last update
  bool IsKnown = false;                       // there was an update
  std::unique_ptr<dgg::PieceSurface> Surface; // null if pieces are gathered
  vtkNew<vtkPolyData> Input;                  // points and arrays of Surface
  std::optional<dgg::FieldReader> Reader;
  std::string Name; // of the distances
};

#endif
