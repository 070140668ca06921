// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGOFFReader);

vtkDGGOFFReader::vtkDGGOFFReader()
  : vtkDGGMeshReader(static_cast<int>(dgg::FileFormat::OFF))
{
}

int vtkDGGOFFReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, static_cast<int>(dgg::FileFormat::OFF));
}
