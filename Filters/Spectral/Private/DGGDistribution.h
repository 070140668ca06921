// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A distribution of mass on a surface as a user gives it. Internal.
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

/// Read a point array of one number per point, each of them finite, masses not negative. `where` is
/// what messages call the data, `setter` what names the array.
dgg::Status DGGReadNumbers(vtkPolyData* data, const std::string& name, const std::string& where,
  const std::string& setter, bool areMasses, std::vector<double>& values);

/// Where a distribution comes from; empty names and null mean none.
struct DGGMassOrigin
{
  std::string Name;      ///< "from" or "to"
  std::string Array;     ///< of the surface
  std::string Setter;    ///< of that array's name
  vtkPolyData* Points;   ///< may be null
  int Port;              ///< of these
  std::string MassArray; ///< of these
};

/// One number per point of the surface, masses at other points, or both.
class DGGDistribution
{
public:
  /// Copies the numbers and locates the points on the surface. Fails if nothing is given, an array
  /// is missing or has another size, or a number is negative or not finite.
  dgg::Status Read(const DGGContext& context, const DGGMassOrigin& origin, double tolerance);

  /// Masses per vertex. `areas`, per vertex, is null when the numbers are masses themselves.
  dgg::Status Integrate(const dgg::PreparedSurface& mesh, const std::vector<double>* areas,
    std::vector<double>& masses) const;

private:
  std::vector<double> Values; // per point of the surface; may be empty
  std::vector<double> Masses; // per other point
  std::vector<dgg::SurfacePoint> Places;
};

#endif
