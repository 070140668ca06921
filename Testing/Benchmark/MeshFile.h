// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes from files by VTK's readers, and conversions from and to vtkPolyData.
#ifndef MeshFile_h
#define MeshFile_h

#include "MeshArrays.h" // for MeshArrays

#include <vtkSmartPointer.h> // for the poly data

#include <string> // for file names

class vtkPolyData;

/// Reads a .ply, .obj, .stl, .vtp or .vtk file; polygons become triangles. The result has no points
/// if the file cannot be read.
vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path);

/// Returns the triangles of a vtkPolyData without other cells.
MeshArrays ToArrays(vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ToPolyData(const MeshArrays& mesh);

/// Returns the file name without folder and extension.
std::string StemOf(const std::string& path);

#endif
