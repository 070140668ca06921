// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distances of a mesh from one of its vertices, with what is known inside of faces.
#ifndef MeasuredField_h
#define MeasuredField_h

#include "BenchmarkMesh.h"     // for BenchmarkMesh
#include "dggDistanceField.h"  // for DistanceField
#include "dggEdgeWindows.h"    // for EdgeWindows
#include "dggVirtualSources.h" // for VirtualSources

#include <string> // for the error
#include <vector> // for the distances

/// Where distances come from.
enum class FieldInput
{
  Exact,
  Graph,
  Heat,
  Marching
};

class MeasuredField
{
public:
  /// `accuracy` is that of the graph, where one is needed.
  MeasuredField(BenchmarkMesh& mesh, FieldInput input, double accuracy);

  /// Why there are no distances; empty when there are.
  const std::string& GetError() const { return this->Error; }
  const std::vector<double>& GetDistances() const { return this->Distances; }
  /// Linear within faces.
  dgg::DistanceField Linear() const;
  dgg::DistanceField WithSources() const;
  /// Of exact distances only.
  dgg::DistanceField WithWindows() const;

private:
  dgg::Status RunExact(dgg::Id source);
  dgg::Status RunGraph(BenchmarkMesh& mesh, dgg::Id source, double accuracy);
  dgg::Status RunHeat(dgg::Id source);
  dgg::Status RunMarching(dgg::Id source);

  const dgg::SurfaceMesh& Surface;
  std::string Error;
  std::vector<double> Distances;
  dgg::VirtualSources Sources;
  dgg::EdgeWindows Windows;
};

/// The vertex that all fields of a mesh start from.
dgg::Id SourceOfFields(const BenchmarkMesh& mesh);

/// A field of the mesh of this name. Those of the last mesh are kept.
const MeasuredField& GetMeasuredField(
  BenchmarkMesh& mesh, const std::string& name, FieldInput input, double accuracy);

#endif
