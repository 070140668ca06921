// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGXYZReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGXYZReader);

vtkDGGXYZReader::vtkDGGXYZReader()
  : vtkDGGMeshReader(dgg::FileFormat::XYZ)
{
}

int vtkDGGXYZReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, dgg::FileFormat::XYZ);
}
