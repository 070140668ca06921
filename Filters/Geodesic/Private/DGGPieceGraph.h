// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graph of the piece of this process. Internal.
#ifndef DGGPieceGraph_h
#define DGGPieceGraph_h

#include "DGGGraphArrays.h" // for the arrays

#include "dggGraphBuilder.h" // for the options

#include "vtkTimeStamp.h" // for the build time

#include <string> // for warnings
#include <vector> // for warnings

struct DGGContext;
namespace dgg
{
class ProcessGroup;
struct SurfacePiece;
}

/// Graph of a surface that several processes have in pieces. Each process has the part of its
/// piece, which is on its input or was built together with the other processes.
class DGGPieceGraph
{
public:
  /// Finds or builds the graph; all processes use either the graphs of their inputs or those built
  /// here. The options of the first process count; if `acceptsAny`, the graphs of the inputs need
  /// not be built with them. `isDone` becomes false on all processes if the pieces must be
  /// gathered. `warnings` receives the reason why a graph on the input is not used, and, on the
  /// first process, the defects of the surface.
  dgg::Status Update(const DGGContext& context, dgg::ProcessGroup& group,
    const dgg::SurfacePiece& piece, dgg::GraphOptions options, bool acceptsAny, bool& isDone,
    std::vector<std::string>& warnings);

  /// Lets Update() gather these pieces from now on. Must be called by all processes.
  void Refuse();

  ///@{
  /// Results of Update().
  bool IsOnInput() const { return this->IsFound; }
  const DGGGraphArrays& Get() const { return this->IsFound ? this->OnInput : this->Built; }
  std::string GetDamage() const { return this->OnInput.GetDamage(); }
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }
  const dgg::GraphEstimate& GetEstimate() const { return this->Estimate; }
  /// Returns the properties of the graph; the number of edges is that of the points that belong to
  /// this process.
  const dgg::GraphSummary& GetSummary() const { return this->Summary; }
  ///@}

private:
  void Summarize(const dgg::SurfacePiece& piece);

  DGGGraphArrays OnInput;
  DGGGraphArrays Built;
  bool IsFound = false;        // OnInput is used
  dgg::Signature BuiltPiece{}; // piece of which Built has rows
  ///@{
  // Signatures of all pieces: of the last update, and of those that are gathered.
  dgg::Signature Pieces{};
  dgg::Signature Refused{};
  ///@}
  vtkMTimeType WarnedTime = 0; // of OnInput when a warning called it out of date
  dgg::GraphEstimate Estimate;
  dgg::GraphSummary Summary;
  vtkTimeStamp BuildTime;
};

#endif
