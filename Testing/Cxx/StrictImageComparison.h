// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pictures of a render window compared with a baseline, strictly.
#ifndef StrictImageComparison_h
#define StrictImageComparison_h

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <string>

namespace dggtest
{
/// What two renderings of the same scene may differ by: a few pixels on the rims of lines, where
/// another version of the software renderer rounds otherwise. In whole pixels from black to white.
/// On one machine the difference is 0; a shift by one pixel costs hundreds.
constexpr double ImageErrorBudget = 12.0;

vtkSmartPointer<vtkImageData> Capture(vtkRenderWindow* window);

/// Sum of all differences, in whole pixels from black to white; infinity when sizes differ. No
/// shifts, no averaging, no threshold: VTK's own default forgives all of these.
double CompareImages(vtkImageData* image, vtkImageData* baseline);

/// The picture moved by whole pixels; the rim is repeated.
vtkSmartPointer<vtkImageData> Shifted(vtkImageData* image, int x, int y);
/// The picture mirrored, left to right or top to bottom.
vtkSmartPointer<vtkImageData> Mirrored(vtkImageData* image, bool leftToRight);

/// Compares the picture with Testing/Baseline/<name>.png or, where versions of VTK differ, with an
/// alternative <name>_1.png, <name>_2.png, ... Also expects that the picture shifted by one pixel,
/// and mirrored, fails. The picture is written to the output folder of the tests.
void ExpectBaseline(vtkRenderWindow* window, const std::string& name);
}

#endif
