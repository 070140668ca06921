// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves and regions of a drawing from the arrays of inputs. Internal.
#ifndef dggGraphicsInput_h
#define dggGraphicsInput_h

#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggInputArray.h"      // for colors
#include "dggPreparedSurface.h" // for CellArrays
#include "dggVectorGraphics.h"  // for curves and regions

#include <vector> // for curves

namespace dgg
{
/// Arrays of the same name of points and of cells; that of the points is used if there are both.
struct GraphicsArray
{
  InputArray OfPoints;
  InputArray OfCells;
};

/// Inputs of a drawing. Lines and their arrays may be missing.
struct GraphicsInput
{
  ///@{
  /// Lines of the input {Curves}.
  CellArrays Lines;
  Offset FirstLine = 0;     ///< cell id of the first line
  Offset NumberOfCells = 0; ///< cells of any type
  Offset NumberOfPoints = 0;
  const double* Points = nullptr; ///< x y z each
  InputArray CurveType;           ///< cell array
  GraphicsArray LeftColor;
  GraphicsArray RightColor;
  GraphicsArray Strength;
  GraphicsArray RightStrength;
  GraphicsArray Width;
  double DefaultWidth = 0.0; ///< 0 for a fraction of the diagonal of the surface
  ///@}

  ///@{
  /// Cell arrays of the surface. An array without a name is not used.
  Offset NumberOfSurfaceCells = 0; ///< cells of any type
  InputArray Region;
  InputArray RegionStrength;
  InputArray Refinement;
  ///@}
  bool WantRefinement = false; ///< require Refinement
};

/// Lines with their parameters, regions with their strengths, and faces to refine.
struct GraphicsDrawing
{
  int NumberOfChannels = 3;
  std::vector<GraphicsCurve> Curves;
  std::vector<Offset> Points;     ///< ids of the points of all curves in succession
  std::vector<std::size_t> Sizes; ///< numbers of points of the curves
  std::vector<GraphicsRegion> Regions;
  std::vector<Id> RefinedFaces; ///< faces of cells that are selected for refinement
};

/// Reads a drawing. The first point of a closed curve is not repeated at the end. Fails if there is
/// nothing to draw, if an array is missing or has the wrong number of components, or if a number is
/// not finite.
DGG_CORE_EXPORT Status ReadGraphics(
  const GraphicsInput& input, const PreparedSurface& surface, GraphicsDrawing& drawing);
}

#endif
