// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPCDWriter.h"

#include "dggFormats.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPCDWriter);

int vtkPCDWriter::FindFormat() const
{
  constexpr dgg::FileFormat formats[] = { dgg::FileFormat::PCDText, dgg::FileFormat::PCD,
    dgg::FileFormat::PCDCompressed };
  return static_cast<int>(formats[this->DataMode]);
}

void vtkPCDWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "ASCII", "Binary", "BinaryCompressed" };
  os << indent << "DataMode: " << modes[this->DataMode] << "\n";
}
