// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether triangles are too thin for the Poisson equation. Internal.
#ifndef dggThinTriangles_h
#define dggThinTriangles_h

#include "dggTypes.h" // for Status

namespace dgg
{
class PoissonSystem;

/// What thin triangles take from the solution of a problem with random sources, as a part of it and
/// the mean over the area: the larger of these two.
///  - The energy in triangles that were made softer, PoissonSystem::LargestCotangent, as far as
///  they
///    were. A few thin ones have next to none, as the values at their ends are the same; where a
///    surface is thin altogether they have all of it.
///  - How much the solution changes when diagonal entries of the matrix change in their last bit.
///    The sum of conductances around a vertex forgets those that are 1e16 times less than others.
double MeasureThinTriangles(const PoissonSystem& system);

/// Fails when that is more than 1 %. For a system that is factorized.
Status CheckThinTriangles(const PoissonSystem& system);
}

#endif
