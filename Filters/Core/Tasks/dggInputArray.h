// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Named arrays of inputs. Internal.
#ifndef dggInputArray_h
#define dggInputArray_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for values

namespace dgg
{
class PreparedSurface;

/// Result of the search for an array of points or cells by its name.
struct DGG_CORE_EXPORT InputArray
{
  std::string Name;
  std::string Type; ///< type of the values, for messages; empty if there is no such array
  int NumberOfComponents = 0;
  Offset NumberOfTuples = 0;
  bool AreNumbers = false;
  bool AreFloats = false;     ///< stored in single precision
  bool AreBytes = false;      ///< unsigned bytes: colors from 0 to 255
  std::vector<double> Values; ///< tuple by tuple; empty unless numbers

  bool Exists() const { return !this->Type.empty(); }
  double Get(Offset tuple, int component = 0) const
  {
    return this->Values[static_cast<std::size_t>(tuple * this->NumberOfComponents + component)];
  }

  /// Returns true if this is an array of numbers with a tuple per point and this number of
  /// components (0 for any).
  bool Fits(Offset numberOfPoints, int components) const
  {
    return this->AreNumbers && (components == 0 || this->NumberOfComponents == components) &&
      this->NumberOfTuples == numberOfPoints;
  }
  /// Fails unless Fits(). `where` is the name of the points' data in messages.
  Status CheckPoints(const std::string& where, Offset numberOfPoints, int components) const;
  /// Like CheckPoints(), but fails if there is no such array. `property` contains its name.
  Status RequirePoints(const std::string& where, const std::string& property, Offset numberOfPoints,
    int components) const;
  /// Like RequirePoints(), for one finite number per point; masses must not be negative.
  Status RequireNumbers(const std::string& where, const std::string& property,
    Offset numberOfPoints, bool areMasses) const;
  /// Returns the integral of the array per vertex. `areas`, per vertex, is null if the numbers of
  /// points are integrals rather than densities.
  std::vector<double> Integrate(
    const PreparedSurface& surface, const std::vector<double>* areas) const;
};
}

#endif
