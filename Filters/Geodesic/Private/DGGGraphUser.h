// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graph and properties of filters that search a graph. Internal.
#ifndef DGGGraphUser_h
#define DGGGraphUser_h

#include "DGGContext.h"         // for the update
#include "DGGFilterInternals.h" // for the base
#include "DGGGraphArrays.h"     // for the graph on the input
#include "DGGPieceGraph.h"      // for the graph of a piece

#include "dggGraphSession.h" // for the base

#include "vtkIndent.h"    // for PrintSelf()
#include "vtkPolyData.h"  // for the input
#include "vtkTimeStamp.h" // for the build time

#include <cstddef> // for std::size_t
#include <ostream> // for PrintSelf()

class vtkObject;

/// Properties and graph of a filter that searches a graph. The graph is taken from the input;
/// without one, the filter builds a graph and keeps it until the mesh or the accuracy changes. The
/// graph of a cloud must be on the input. Such filters have different superclasses, therefore this
/// class is a member of DGGGraphInternalsOf. The filter declares and documents the properties;
/// vtkDGGGraphUserMacro() defines them.
class DGGGraphUser : public dgg::GraphSession
{
public:
  ///@{
  /// Setters return true if a property has changed.
  bool SetAccuracy(double accuracy);
  bool SetAcceptCoarserGraph(bool accept);
  double GetAccuracy() const { return this->Accuracy; }
  bool GetAcceptCoarserGraph() const { return this->AcceptCoarserGraph; }
  ///@}

  void PrintSelf(std::ostream& os, vtkIndent indent) const;
  /// Fails if a property is out of range.
  dgg::Status Check() const;

  /// Updates the graph; after a failure there is none. `filter` warns once about each graph on the
  /// input that cannot be used, or is coarser than the accuracy that was set.
  dgg::Status Update(const DGGContext& context, vtkObject* filter);

  /// Updates the graph of a piece in the same manner, together with the other processes. `isDone`
  /// becomes false on all processes if the pieces must be gathered. The graph is in use after
  /// UsePiece(); after RefusePiece(), these pieces are gathered.
  dgg::Status UpdatePiece(const DGGContext& context, dgg::ProcessGroup& group,
    const dgg::SurfacePiece& piece, vtkObject* filter, bool& isDone);
  const DGGGraphArrays& GetPiece() const { return this->Piece.Get(); }
  void UsePiece(vtkObject* filter);
  void RefusePiece() { this->Piece.Refuse(); }
  /// Ends the use of a piece, so that getters do not describe it. Called before each update.
  void LeavePiece() { this->UsesPiece = false; }

  ///@{
  /// Values of getters: the properties of the graph, true if it is on the input, true if its
  /// accuracy is guaranteed, and the time of the last build of a graph.
  const dgg::GraphSummary& GetSummary() const
  {
    return this->UsesPiece ? this->Piece.GetSummary() : GraphSession::GetSummary();
  }
  std::size_t GetMemorySize() const
  {
    return this->UsesPiece ? this->Piece.GetSummary().MemorySize : GraphSession::GetMemorySize();
  }
  bool IsFromInput() const
  {
    return this->UsesPiece ? this->Piece.IsOnInput() : this->UsedInput != 0;
  }
  bool IsGuaranteed() const
  {
    return (this->UsesPiece || this->HasGraph()) && this->GetSummary().Info.IsGuaranteed();
  }
  vtkMTimeType GetBuildTime() const
  {
    return this->UsesPiece ? this->Piece.GetBuildTime() : this->BuildTime.GetMTime();
  }
  ///@}

private:
  void UseInput(const DGGContext& context, vtkObject* filter);
  dgg::Status UseOwn(const DGGContext& context, dgg::GraphOptions options);
  void SearchIn(const DGGGraphArrays& arrays, const dgg::PreparedSurface& surface);
  void WarnAboutAccuracy(vtkObject* filter);
  void ForgetGraph();

  double Accuracy = 0.01;
  bool IsAccuracyExplicit = false; // set by the user
  bool AcceptCoarserGraph = false;

  DGGGraphArrays InputGraph;
  vtkMTimeType UsedInput = 0;  // time when the graph on the input was found; 0 if unused
  double OwnAccuracy = 0.0;    // accuracy of the graph built here; 0 if unused
  double WarnedAccuracy = 0.0; // accuracy in the last warning
  vtkTimeStamp BuildTime;
  DGGPieceGraph Piece;
  bool UsesPiece = false;
  bool IsOnFirst = true;      // process of the last UpdatePiece()
  vtkMTimeType PieceTime = 0; // time when the graph of a piece in use was found; 0 if unused
};

/// Private implementation of filters of one class that search a graph. An input with the graph of a
/// cloud is treated as a cloud.
template <typename Filter, typename Base = DGGFilterInternals>
class DGGGraphInternalsOf : public DGGInternalsOf<Filter, Base>
{
public:
  using DGGInternalsOf<Filter, Base>::DGGInternalsOf;

  dgg::Status CheckProperties() const override
  {
    DGG_RETURN_IF_ERROR(this->GraphUser.Check());
    return Base::CheckProperties();
  }
  void ForgetResults() override
  {
    this->GraphUser.LeavePiece();
    Base::ForgetResults();
  }
  bool IsCloud(vtkPolyData* input) const override
  {
    return DGGGraphArrays::AreOfCloud(input->GetFieldData());
  }

  DGGGraphUser GraphUser;
};

/// Defines the setter and the getter of a property.
#define vtkDGGGraphUserSetMacro(Class, Property, Type)       \
  void Class::Set##Property(Type value)                      \
  {                                                          \
    if (this->GetInternals().GraphUser.Set##Property(value)) \
    {                                                        \
      this->Modified();                                      \
    }                                                        \
  }                                                          \
  Type Class::Get##Property() const                          \
  {                                                          \
    return this->GetInternals().GraphUser.Get##Property();   \
  }

/// Defines the properties of a filter that searches a graph. The filter has to declare all of them.
#define vtkDGGGraphUserMacro(Class)                                                              \
  vtkDGGGraphUserSetMacro(Class, Accuracy, double);                                              \
  vtkDGGGraphUserSetMacro(Class, AcceptCoarserGraph, bool);                                      \
  vtkDGGResultMacro(Class, bool, UsedInputGraph, GraphUser.IsFromInput());                       \
  vtkDGGResultMacro(Class, double, GraphAccuracy, GraphUser.GetSummary().Info.Accuracy);         \
  vtkDGGResultMacro(Class, bool, GraphIsGuaranteed, GraphUser.IsGuaranteed());                   \
  vtkDGGResultMacro(Class, vtkIdType, NumberOfGraphEdges, GraphUser.GetSummary().NumberOfEdges); \
  vtkDGGResultMacro(Class, vtkTypeUInt64, MemorySize, GraphUser.GetMemorySize());                \
  vtkDGGResultMacro(Class, vtkMTimeType, GraphBuildTime, GraphUser.GetBuildTime())

#endif
