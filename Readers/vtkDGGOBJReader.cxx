// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOBJReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGOBJReader);

vtkDGGOBJReader::vtkDGGOBJReader()
  : vtkDGGMeshReader(dgg::FileFormat::OBJ)
{
}

int vtkDGGOBJReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, dgg::FileFormat::OBJ);
}
