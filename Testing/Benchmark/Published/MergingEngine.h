// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Propagation of windows that are merged within a tolerance, for comparison.
#ifndef MergingEngine_h
#define MergingEngine_h

#include "dggTriangleEngine.h" // for TriangleEngine

#include <cstddef> // for std::size_t
#include <vector>  // for errors

/// Approximate distances with an error parameter (Surazhsky, Surazhsky, Kirsanov, Gortler and
/// Hoppe, "Fast exact and approximate geodesics on meshes", 2005). Adjacent windows on an edge are
/// merged to one that has the same distances at both ends, sees at least the region that they saw,
/// and differs from them slightly in between.
///
/// The published test considers each merger separately, so that errors could grow to four times the
/// tolerance. Here errors accumulate along paths in bounds per half-edge and per vertex, and a
/// merger may not raise them above `tolerance` times the distance. Thus `tolerance` is the largest
/// relative error of the result in both directions.
class MergingEngine : public dgg::TriangleEngine
{
public:
  MergingEngine(const dgg::SurfaceMesh& mesh, double tolerance)
    : TriangleEngine(mesh)
    , Tolerance(tolerance)
  {
  }

  /// Returns the number of windows that were merged into others.
  std::size_t GetNumberOfMerged() const { return this->NumberOfMerged; }

protected:
  void Receive(dgg::Id h, const dgg::Window& window) override;
  void LabelDropped(dgg::Id v) override;
  void Simplify(dgg::Id h, dgg::WindowList& list) override;
  void Reset() override;

private:
  bool Merge(
    const dgg::Window& first, const dgg::Window& second, double length, dgg::Window& merged) const;

  const double Tolerance;
  std::vector<double> EdgeErrors;   // per half-edge: bound of the windows that arrived
  std::vector<double> VertexErrors; // per vertex: bound of its label
  std::size_t NumberOfMerged = 0;
};

#endif
