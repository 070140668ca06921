// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bands between isolines as vtkPolyData. Internal.
#ifndef vtkDGGBandOutput_h
#define vtkDGGBandOutput_h

#include "dggBands.h" // for Bands

#include <string> // for the name of the distances

class vtkDGGNewGeometry;
class vtkPolyData;

/// Make an output of triangles, without those in no band: with the cell data Band, BandMinimum,
/// BandMaximum (the range of distances; of the first and the last band, that of the points) and
/// FaceId, and the point data `distanceName` and vtkOriginalPointIds. Triangles are oriented as the
/// cells of the input.
void vtkDGGWriteBands(const dgg::Bands& bands, const std::string& distanceName,
  const vtkDGGNewGeometry& geometry, vtkPolyData* output);

#endif
// VTK-HeaderTest-Exclude: vtkDGGBandOutput.h
