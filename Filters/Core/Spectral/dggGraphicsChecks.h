// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether the numbers of a drawing make sense. Internal.
#ifndef dggGraphicsChecks_h
#define dggGraphicsChecks_h

#include "dggVectorGraphics.h" // for curves and regions

#include <cstddef> // for std::size_t
#include <string>  // for names

namespace dgg
{
/// How messages name a curve of that number.
std::string NameOf(const GraphicsCurve& curve, std::size_t number);

Status CheckGraphicsOptions(const GraphicsOptions& options);

/// A curve of that number, with as many values on a side as are told.
Status CheckGraphicsCurve(const GraphicsCurve& curve, std::size_t number, std::size_t count);

/// A region of that number, on a mesh with so many faces.
Status CheckGraphicsRegion(
  const GraphicsRegion& region, std::size_t number, std::size_t channels, Id numberOfFaces);
}

#endif
