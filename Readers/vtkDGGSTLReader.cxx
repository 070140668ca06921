// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGSTLReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGSTLReader);

vtkDGGSTLReader::vtkDGGSTLReader()
  : vtkDGGMeshReader(static_cast<int>(dgg::FileFormat::STL))
{
}

int vtkDGGSTLReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, static_cast<int>(dgg::FileFormat::STL));
}
