// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Searches of filters in the graph of a piece. Internal.
#ifndef DGGPieceSearches_h
#define DGGPieceSearches_h

#include "DGGContext.h"     // for the context
#include "DGGGraphArrays.h" // for the key of the graph
#include "DGGSources.h"     // for sources

#include "dggPieceLinks.h"          // for positions
#include "dggPieceSearch.h"         // for the search
#include "dggPieceSurface.h"        // for the surface
#include "dggPieceVirtualSources.h" // for virtual sources
#include "dggProgressPart.h"        // for the remaining progress

#include "vtkSmartPointer.h" // for joined points

#include <memory> // for the searches

class DGGGraphUser;
struct DGGPieceUpdate;

/// Searches in the graph of a piece, which are kept for the next update.
class DGGPieceSearches
{
public:
  struct Needs
  {
    bool Links = false; ///< sources have positions
    bool VirtualSources = false;
    bool Surface = false;
  };

  /// Updates the graph of the piece and prepares searches unless the last update has done so. The
  /// needs must be the same on all processes. `isDone` becomes false on all processes if the pieces
  /// must be gathered, among others if global ids do not number the points.
  dgg::Status Prepare(const DGGContext& context, const DGGPieceUpdate& update, Needs needs,
    DGGGraphUser& user, vtkObject* filter, bool& isDone);
  /// Returns the context of a task after Prepare(), with the remaining progress.
  DGGContext MakeContext(DGGContext context) const
  {
    context.Progress = dgg::ProgressPart(context.Progress, this->Done, 1.0);
    return context;
  }
  /// Keeps the searches. Must be called at the end of an update, and only if it succeeds.
  void Keep(DGGGraphUser& user, vtkObject* filter);

  ///@{
  /// Results of Prepare(). Links, virtual sources and the surface may be null unless they are
  /// needed.
  dgg::PieceSearch& GetSearch() const { return *this->Search; }
  dgg::PieceLinks* GetLinks() const { return this->Links.get(); }
  const dgg::PieceVirtualSources* GetVirtualSources() const { return this->VirtualSources.get(); }
  dgg::PieceSurface* GetSurface() const { return this->Surface.get(); }
  /// Returns the accuracy of links, which is the same on all processes.
  double GetAccuracy() const { return this->Accuracy; }
  ///@}

private:
  std::unique_ptr<dgg::PieceSearch> Search;
  std::unique_ptr<dgg::PieceLinks> Links;
  std::unique_ptr<dgg::PieceVirtualSources> VirtualSources;
  std::unique_ptr<dgg::PieceSurface> Surface;
  DGGGraphArrays::Key Key; // of the graph
  double Accuracy = 0.0;
  double Done = 0.0; // progress after Prepare()
  bool IsKept = false;
};

/// Collects a set together with the other processes: its ids on the first process, and the points
/// that all processes have at its port. `points` are joined on the first process, and null
/// elsewhere. `areUsable` becomes false on all processes if arrays identify points by ids of the
/// joined surface.
dgg::Status DGGCollectFromAll(const DGGPieceUpdate& update, DGGSourceSet set,
  dgg::SourceCollection& sources, vtkSmartPointer<vtkPolyData>& points, bool& areUsable);

#endif
