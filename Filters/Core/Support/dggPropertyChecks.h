// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Checks of properties and inputs that several tasks have in common. Internal.
#ifndef dggPropertyChecks_h
#define dggPropertyChecks_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggStatus.h"     // for Status

#include <string>  // for names
#include <utility> // for properties
#include <vector>  // for properties

namespace dgg
{
/// Fails if a property is negative or NaN. Infinity is allowed.
DGG_CORE_EXPORT Status CheckLengths(const std::vector<std::pair<std::string, double>>& properties);

/// Fails if the name of an array is empty or used twice. Pairs consist of a property and its value.
DGG_CORE_EXPORT Status CheckNames(const std::vector<std::pair<std::string, std::string>>& names);

/// Fails if an input of points has no polygon or triangle strip. `remedy` is the suggested action.
DGG_CORE_EXPORT Status CheckCells(
  Offset numberOfPoints, Offset numberOfCells, const std::string& remedy);
}

#endif
