// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes from files, through VTK's readers, and to and from vtkPolyData.
#ifndef MeshFile_h
#define MeshFile_h

#include "MeshArrays.h" // for MeshArrays

#include <vtkSmartPointer.h> // for the poly data

#include <string> // for file names

class vtkPolyData;

/// Read a .ply, .obj, .stl, .vtp or .vtk file; polygons become triangles. The result has no points
/// when the file cannot be read.
vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path);

/// The triangles of a poly data that holds nothing else.
MeshArrays ToArrays(vtkPolyData* mesh);

vtkSmartPointer<vtkPolyData> ToPolyData(const MeshArrays& mesh);

/// File name without folder and extension.
std::string StemOf(const std::string& path);

#endif
