// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOBJReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGOBJReader);

vtkDGGOBJReader::vtkDGGOBJReader()
  : vtkDGGMeshReader(static_cast<int>(dgg::FileFormat::OBJ))
{
}

int vtkDGGOBJReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, static_cast<int>(dgg::FileFormat::OBJ));
}
