// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether triangles are too thin for the Poisson equation. Internal.
#ifndef dggThinTriangles_h
#define dggThinTriangles_h

#include "dggTypes.h" // for Status

#include <cstdint> // for flags
#include <string>  // for messages
#include <vector>  // for what components lose

namespace dgg
{
class PoissonSystem;

/// What thin triangles take from the solution of a problem with random sources, per component as a
/// part of it: the larger of these two.
///  - The energy in triangles that were made softer (PoissonSystem::LargestCotangent), as far as
///    they were. A few thin ones have next to none, as the values at their ends are the same; where
///    a surface is thin altogether they have all of it.
///  - How much the solution changes when diagonal entries of the matrix change in their last bit.
///    The sum of conductances around a vertex forgets those that are 1e16 times less than others.
std::vector<double> MeasureThinTriangles(const PoissonSystem& system);

/// Reports which components lose more than 1 %. Fails when the mean of what they lose, over the
/// area, is more than that. For a system that is factorized.
Status CheckThinTriangles(const PoissonSystem& system, std::vector<std::uint8_t>& isThin);

/// What a part of a surface that is thin, beside others that are not, is refused for.
/// @{
/// Fails when the component is thin. `where` is what messages begin with.
Status CheckThinPlace(const PoissonSystem& system, Id component, const std::string& where);
/// Fails when a thousandth of the integrated sources, which messages call by `noun`, is in thin
/// components. Densities that are everywhere put less than that into debris. Slivers that curves
/// with given values cut off are not meant: these values hold the solution.
Status CheckThinSources(
  const PoissonSystem& system, const std::vector<double>& sources, const std::string& noun);
/// @}
}

#endif
