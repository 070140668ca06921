// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPLYReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGPLYReader);

vtkDGGPLYReader::vtkDGGPLYReader()
  : vtkDGGMeshReader(static_cast<int>(dgg::FileFormat::PLY))
{
}

int vtkDGGPLYReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, static_cast<int>(dgg::FileFormat::PLY));
}
