// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distribution of mass on a surface as specified by the user. Internal.
#ifndef DGGDistribution_h
#define DGGDistribution_h

#include "DGGSources.h" // for sets of points

#include <string> // for names
#include <vector> // for masses

namespace dgg
{
class PreparedSurface;
}
class vtkPolyData;

/// Reads a point array with one finite number per point; masses must not be negative. `where` is
/// the name of the data in messages, `property` the property with the name of the array.
dgg::Status DGGReadNumbers(vtkPolyData* data, const std::string& name, const std::string& where,
  const std::string& property, bool areMasses, std::vector<double>& values);

/// Inputs of a distribution; empty names and null mean none.
struct DGGMassOrigin
{
  std::string Name;      ///< "from" or "to"
  std::string Array;     ///< array of the surface
  std::string Property;  ///< property with the name of Array
  vtkPolyData* Points;   ///< may be null
  int Port;              ///< input port of Points
  std::string MassArray; ///< array of Points
};

/// Distribution by one number per point of the surface, by masses at other points, or both.
class DGGDistribution
{
public:
  /// Copies the numbers and locates the points on the surface. Fails if nothing is given, if an
  /// array is missing or has a wrong size, or if a number is negative or not finite.
  dgg::Status Read(const DGGContext& context, const DGGMassOrigin& origin, double tolerance);

  /// Computes masses per vertex. `areas`, per vertex, is null if the numbers are masses.
  dgg::Status Integrate(const dgg::PreparedSurface& mesh, const std::vector<double>* areas,
    std::vector<double>& masses) const;

private:
  std::vector<double> Values; // per point of the surface; may be empty
  std::vector<double> Masses; // per further point
  std::vector<dgg::SurfacePoint> Places;
};

#endif
