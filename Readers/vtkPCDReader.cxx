// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDReader.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPCDReader);

vtkPCDReader::vtkPCDReader()
  : vtkDGGMeshReader(static_cast<int>(dgg::FileFormat::PCD))
{
}

int vtkPCDReader::CanReadFile(const char* fileName)
{
  return vtkDGGMeshReader::CanReadFile(fileName, static_cast<int>(dgg::FileFormat::PCD));
}
