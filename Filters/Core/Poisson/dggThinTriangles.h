// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Detects triangles that are too thin for the Poisson equation. Internal.
#ifndef dggThinTriangles_h
#define dggThinTriangles_h

#include "dggStatus.h" // for Status

#include <cstdint> // for flags
#include <string>  // for messages
#include <vector>  // for the losses of components

namespace dgg
{
class PoissonSystem;

/// Returns, per component, the relative error that thin triangles cause in the solution of a
/// problem with random sources: the maximum of the following two errors.
/// - The fraction of energy in softened triangles (PoissonSystem::LargestCotangent), weighted by
///   the degree of softening. A few thin triangles have almost no energy, as the values at their
///   ends agree; if a surface is thin everywhere, thin triangles have all of the energy.
/// - The change of the solution if diagonal entries of the matrix change in their last bit. The sum
///   of conductances around a vertex loses conductances that are 1e16 times smaller than others.
std::vector<double> MeasureThinTriangles(const PoissonSystem& system);

/// Flags the components with an error of more than 1 %. Fails if the area-weighted mean of the
/// errors exceeds 1 %. The system must be factorized.
Status CheckThinTriangles(const PoissonSystem& system, std::vector<std::uint8_t>& isThin);

/// Errors for requests in a thin component of a surface that is usable elsewhere.
/// @{
/// Fails if the component is thin. `where` is the beginning of the message.
Status CheckThinPlace(const PoissonSystem& system, Id component, const std::string& where);
/// Fails if a thousandth of the integrated sources (called `noun` in messages) is in thin
/// components. Densities that cover the entire surface put less than that into small debris
/// components. Slivers that curves with given values cut off are exempt, since these values
/// determine the solution.
Status CheckThinSources(
  const PoissonSystem& system, const std::vector<double>& sources, const std::string& noun);
/// @}
}

#endif
