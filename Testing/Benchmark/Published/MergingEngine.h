// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Propagation of windows that are merged within a tolerance, to compare with.
#ifndef MergingEngine_h
#define MergingEngine_h

#include "dggTriangleEngine.h" // for TriangleEngine

#include <cstddef> // for std::size_t
#include <vector>  // for errors

/// Approximate distances with an error parameter (Surazhsky, Surazhsky, Kirsanov, Gortler and
/// Hoppe, "Fast exact and approximate geodesics on meshes", 2005): windows side by side on an edge
/// become one, whose distances are the same at both ends, which sees all that both have seen, and
/// which is off by little in between.
///
/// The published test is on its own for each merger; so it would let errors become four times the
/// tolerance. Here they add up along the way, in bounds for each half-edge and vertex, and a merger
/// may not bring them above `tolerance` times the distance: so that is the largest relative error
/// of the result, below and above.
class MergingEngine : public dgg::TriangleEngine
{
public:
  MergingEngine(const dgg::SurfaceMesh& mesh, double tolerance)
    : TriangleEngine(mesh)
    , Tolerance(tolerance)
  {
  }

  /// Windows that others have taken in.
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
  std::vector<double> EdgeErrors;   // per half-edge, of the windows that have come to it
  std::vector<double> VertexErrors; // per vertex, of its label
  std::size_t NumberOfMerged = 0;
};

#endif
