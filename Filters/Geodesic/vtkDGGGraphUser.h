// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What all filters that search a graph have in common. Internal.
#ifndef vtkDGGGraphUser_h
#define vtkDGGGraphUser_h

#include "vtkDGGGraphProvider.h" // for the graph

#include "vtkIndent.h" // for PrintSelf()

#include <ostream> // for PrintSelf()

/// The properties of a filter that searches a graph, and the graph. Such filters have different
/// superclasses, so this is a member: `std::unique_ptr<vtkDGGGraphUser> GraphUser`. The filter
/// declares the properties and documents them; vtkDGGGraphUserMacro() defines them.
class vtkDGGGraphUser
{
public:
  vtkDGGGraphUser() = default;
  vtkDGGGraphUser(const vtkDGGGraphUser&) = delete;
  vtkDGGGraphUser& operator=(const vtkDGGGraphUser&) = delete;

  ///@{
  /// Setters return whether something has changed.
  bool SetAccuracy(double accuracy);
  bool SetMemoryLimit(vtkTypeUInt64 limit);
  bool SetAcceptCoarserGraph(bool accept);
  double GetAccuracy() const { return this->Accuracy; }
  vtkTypeUInt64 GetMemoryLimit() const { return this->MemoryLimit; }
  bool GetAcceptCoarserGraph() const { return this->AcceptCoarserGraph; }
  ///@}

  void PrintSelf(std::ostream& os, vtkIndent indent) const;
  /// What is wrong with the properties.
  dgg::Status Check() const;
  /// Bring the graph up to date.
  dgg::Status Update(vtkPolyData* input, const vtkDGGPreparedMesh& mesh,
    const dgg::ProgressCallback& progress, vtkObject* filter);

  /// Whether such filters take an input for a cloud: when it says that it has the graph of one.
  static bool IsCloud(vtkPolyData* input);

  vtkDGGGraphProvider& GetProvider() { return this->Provider; }
  const vtkDGGGraphProvider& GetProvider() const { return this->Provider; }

private:
  double Accuracy = 0.01;
  bool IsAccuracyExplicit = false; // whether the user has asked for it
  bool AcceptCoarserGraph = false;
  vtkTypeUInt64 MemoryLimit = 0;
  vtkDGGGraphProvider Provider;
};

/// A setter of a filter that hands the value on.
#define vtkDGGGraphUserSetMacro(Class, Property, Type) \
  void Class::Set##Property(Type value)                \
  {                                                    \
    if (this->GraphUser->Set##Property(value))         \
    {                                                  \
      this->Modified();                                \
    }                                                  \
  }                                                    \
  Type Class::Get##Property() const                    \
  {                                                    \
    return this->GraphUser->Get##Property();           \
  }

/// A number of the graph in use.
#define vtkDGGGraphUserNumberMacro(Class, Type, Name, expression)      \
  Type Class::Name() const                                             \
  {                                                                    \
    const vtkDGGGraphProvider& graph = this->GraphUser->GetProvider(); \
    return static_cast<Type>(expression);                              \
  }

/// All that a filter with a graph has to have. One that does not declare a part of it does not
/// compile, so that no two of them drift apart.
#define vtkDGGGraphUserMacro(Class)                                                              \
  vtkDGGGraphUserSetMacro(Class, Accuracy, double);                                              \
  vtkDGGGraphUserSetMacro(Class, MemoryLimit, vtkTypeUInt64);                                    \
  vtkDGGGraphUserSetMacro(Class, AcceptCoarserGraph, bool);                                      \
  vtkDGGGraphUserNumberMacro(Class, bool, GetUsedInputGraph, graph.IsFromInput());               \
  vtkDGGGraphUserNumberMacro(Class, double, GetGraphAccuracy, graph.GetSummary().Info.Accuracy); \
  vtkDGGGraphUserNumberMacro(Class, bool, GetGraphIsGuaranteed,                                  \
    graph.HasGraph() && graph.GetSummary().Info.IsGuaranteed());                                 \
  vtkDGGGraphUserNumberMacro(                                                                    \
    Class, vtkIdType, GetNumberOfGraphEdges, graph.GetSummary().NumberOfEdges);                  \
  vtkDGGGraphUserNumberMacro(Class, vtkTypeUInt64, GetMemorySize, graph.GetMemorySize());        \
  vtkDGGGraphUserNumberMacro(Class, vtkMTimeType, GetGraphBuildTime, graph.GetBuildTime())

#endif
// VTK-HeaderTest-Exclude: vtkDGGGraphUser.h
