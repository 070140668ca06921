// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGXYZReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkDGGXYZReader);

vtkDGGXYZReader::vtkDGGXYZReader()
  : vtkDGGMeshReader(static_cast<int>(dgg::FileFormat::XYZ))
{
}

int vtkDGGXYZReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, static_cast<int>(dgg::FileFormat::XYZ));
}
