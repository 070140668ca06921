// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Converts between dgg::MeshData and vtkPolyData. Internal.
#ifndef DGGMeshConversion_h
#define DGGMeshConversion_h

#include "dggFormats.h" // for the data of a file

class vtkAlgorithm;
class vtkPolyData;

namespace vtkDGG
{
/// Reads or writes a file by `work`, which receives a callback that reports progress and returns
/// false once the user has aborted. Reports an error as "Cannot <verb> <fileName>: ..." and returns
/// its vtkErrorCode; NoError after an abort as well.
unsigned long RunOnFile(vtkAlgorithm* algorithm, const char* verb, const char* fileName,
  const std::function<dgg::FileStatus(const dgg::FileProgress&)>& work);

/// Copies points, cells and arrays of numbers; triangle strips become triangles, and then there are
/// no cell arrays.
dgg::MeshData FromPolyData(vtkPolyData* input);

/// Copies points and those point arrays of numbers that have a value for each point.
dgg::MeshData FromPointsOf(vtkPolyData* input);

/// Moves the data of a file into an empty vtkPolyData.
void ToPolyData(dgg::MeshData&& mesh, vtkPolyData* output);
}

#endif
