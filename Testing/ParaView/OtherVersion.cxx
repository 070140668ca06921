// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// To be preloaded: ParaView seems to have another VTK than the plugin.
#include "vtkVersion.h"

const char* vtkVersion::GetVTKVersionFull()
{
  return "9.9.9";
}
