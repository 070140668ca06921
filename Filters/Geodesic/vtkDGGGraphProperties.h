// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What all filters that search a discrete geodesic graph declare.
#ifndef vtkDGGGraphProperties_h
#define vtkDGGGraphProperties_h

#include "vtkSetGet.h" // For vtkBooleanMacro
#include "vtkType.h"   // For types

class vtkDGGGraphUser;

/// Accuracy, AcceptCoarserGraph, MemoryLimit, and numbers of the graph of the last update; the
/// filters document them. Their member `std::unique_ptr<vtkDGGGraphUser> GraphUser` has them, and
/// vtkDGGGraphUserMacro() defines them.
#define vtkDGGGraphPropertiesMacro()                \
  virtual void SetAccuracy(double accuracy);        \
  double GetAccuracy() const;                       \
  virtual void SetAcceptCoarserGraph(bool accept);  \
  bool GetAcceptCoarserGraph() const;               \
  vtkBooleanMacro(AcceptCoarserGraph, bool);        \
  virtual void SetMemoryLimit(vtkTypeUInt64 limit); \
  vtkTypeUInt64 GetMemoryLimit() const;             \
  bool GetUsedInputGraph() const;                   \
  double GetGraphAccuracy() const;                  \
  vtkIdType GetNumberOfGraphEdges() const;          \
  vtkTypeUInt64 GetMemorySize() const;              \
  bool GetGraphIsGuaranteed() const;                \
  vtkMTimeType GetGraphBuildTime() const

#endif
