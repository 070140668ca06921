// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Outputs of vtkApolloniusIsolines. Internal.
#ifndef DGGIsolineOutputs_h
#define DGGIsolineOutputs_h

#include "dggBands.h"    // for Bands
#include "dggIsolines.h" // for Isolines
#include "dggRidges.h"   // for Ridges

#include <string> // for the name
#include <vector> // for the values

class DGGNewGeometry;
class vtkPolyData;

/// Writes isolines, ridges and bands of a distance array.
class DGGIsolineOutputs
{
public:
  DGGIsolineOutputs(const DGGNewGeometry& geometry, const std::string& distances)
    : Geometry(geometry)
    , DistanceName(distances)
  {
  }

  /// `values` are the distances of the levels.
  void WriteLines(
    const dgg::Isolines& lines, const std::vector<double>& values, vtkPolyData* output) const;
  void WriteRidges(const dgg::Ridges& ridges, vtkPolyData* output) const;
  void WriteBands(const dgg::Bands& bands, vtkPolyData* output) const;

private:
  void WritePolylines(const std::vector<dgg::SurfacePath>& lines, const std::vector<bool>& isClosed,
    const char* name, const std::vector<double>& numbers, vtkPolyData* output) const;

  const DGGNewGeometry& Geometry;
  std::string DistanceName;
};

#endif
