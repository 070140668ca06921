// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Strict comparison of images of a render window with a baseline.
#ifndef StrictImageComparison_h
#define StrictImageComparison_h

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <string>

namespace dggtest
{
/// Largest difference of two renderings of the same scene, in whole pixels from black to white: a
/// few pixels on the rims of lines, where another version of the software renderer rounds
/// differently. On one machine the difference is 0; a shift by one pixel costs hundreds.
constexpr double ImageErrorBudget = 12.0;

vtkSmartPointer<vtkImageData> Capture(vtkRenderWindow* window);

/// Returns the sum of all differences, in whole pixels from black to white; infinity if sizes
/// differ. The comparison applies no shifts, averages or thresholds, all of which VTK's default
/// tolerates.
double CompareImages(vtkImageData* image, vtkImageData* baseline);

/// Returns the image shifted by whole pixels; pixels at the rim are repeated.
vtkSmartPointer<vtkImageData> Shifted(vtkImageData* image, int x, int y);
/// Returns the image mirrored, left to right or top to bottom.
vtkSmartPointer<vtkImageData> Mirrored(vtkImageData* image, bool leftToRight);

/// Compares the image with Testing/Baseline/<name>.png or, if versions of VTK differ, with an
/// alternative <name>_1.png, <name>_2.png, ... Also expects that the image shifted by one pixel, or
/// mirrored, fails. The image is written to the output folder of the tests.
void ExpectBaseline(vtkRenderWindow* window, const std::string& name);
}

#endif
