// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface refined and cut for vector graphics, and its factorization, kept between updates.
/// Internal.
#ifndef vtkDGGGraphicsKeeper_h
#define vtkDGGGraphicsKeeper_h

#include "dggGraphicsRefinement.h" // for parts
#include "dggSurfacePoint.h"       // for places
#include "dggVectorGraphics.h"     // for curves

#include "vtkType.h" // for time stamps

#include <algorithm>  // for comparisons
#include <functional> // for progress
#include <string>     // for the remedy
#include <vector>     // for curves

/// What a factorization depends on.
struct vtkDGGDrawing
{
  vtkMTimeType MeshTime = 0;
  std::vector<std::vector<dgg::SurfacePoint>> Places; // per curve
  std::vector<dgg::GraphicsCurve> Curves;             // types and whether they are closed
  int RefinementLevel = 0;
  dgg::RefinedPart RefinedPart = dgg::RefinedPart::Everything;
  std::vector<dgg::Id> RefinedFaces;
  bool IntrinsicDelaunay = false;
  vtkTypeUInt64 MemoryLimit = 0; // does not matter

  bool IsSame(const vtkDGGDrawing& other) const
  {
    bool isSame = this->MeshTime == other.MeshTime && this->Places.size() == other.Places.size() &&
      this->RefinementLevel == other.RefinementLevel && this->RefinedPart == other.RefinedPart &&
      this->RefinedFaces == other.RefinedFaces &&
      this->IntrinsicDelaunay == other.IntrinsicDelaunay;
    for (std::size_t k = 0; k < this->Places.size() && isSame; ++k)
    {
      isSame = this->Curves[k].Type == other.Curves[k].Type &&
        this->Curves[k].IsClosed == other.Curves[k].IsClosed &&
        std::equal(this->Places[k].begin(), this->Places[k].end(), other.Places[k].begin(),
          other.Places[k].end(), dgg::IsSamePoint);
    }
    return isSame;
  }
};

/// Prepares dgg::VectorGraphics for a drawing, unless it is prepared for it already.
class vtkDGGGraphicsKeeper
{
public:
  /// Whether it is prepared for this one.
  bool IsUpToDate(const vtkDGGDrawing& drawing) const;

  /// Draw the curves, refine and cut the surface, factorize the matrix. Memory is asked for before
  /// it is taken; `remedy` is what to do besides raising MemoryLimit. Nothing is kept when it
  /// fails.
  dgg::Status Prepare(const dgg::SurfaceMesh& mesh, const vtkDGGDrawing& drawing,
    const dgg::GraphicsOptions& options, const std::string& remedy,
    const std::function<bool(double)>& progress);

  dgg::VectorGraphics& GetGraphics() { return this->Graphics; }
  const dgg::VectorGraphics& GetGraphics() const { return this->Graphics; }
  /// Faces of its surface that are parts of those that were chosen for refinement.
  const std::vector<dgg::Id>& GetRefinedFaces() const { return this->RefinedFaces; }
  /// Done so far.
  int GetNumberOfFactorizations() const { return this->NumberOfFactorizations; }
  /// About how many bytes are held.
  vtkTypeUInt64 GetMemorySize() const
  {
    return static_cast<vtkTypeUInt64>(this->Graphics.GetEstimatedMemory());
  }

private:
  dgg::VectorGraphics Graphics;
  vtkDGGDrawing Kept; // what Graphics was prepared for
  std::vector<dgg::Id> RefinedFaces;
  bool IsKept = false;
  int NumberOfFactorizations = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGGraphicsKeeper.h
