// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Properties that several filters have. Internal.
#ifndef vtkDGGProperties_h
#define vtkDGGProperties_h

#include "dggTypes.h" // for Status

#include <string> // for the name

/// Set a property that may be NaN, which differs from itself. Returns whether it has changed.
bool vtkDGGChangeNumber(double& property, double value);

/// Fails when the property of that name is negative or NaN. Infinity is a length.
dgg::Status vtkDGGCheckLength(const std::string& property, double value);

#endif
// VTK-HeaderTest-Exclude: vtkDGGProperties.h
