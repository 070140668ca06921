// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Says, before any class is used, that this plugin is for another VTK. Internal.
#ifndef VersionGuard_h
#define VersionGuard_h

#include "vtkObject.h"        // for vtkGenericWarningMacro
#include "vtkVersion.h"       // for the version that is loaded
#include "vtkVersionMacros.h" // for the one of the build

#include <cstring> // for std::strncmp

inline void dggCheckVersion()
{
  // The other functions of vtkVersion are inline: they report the version of the build.
  if (std::strncmp(vtkVersion::GetVTKVersionFull(), VTK_VERSION, std::strlen(VTK_VERSION)) != 0)
  {
    vtkGenericWarningMacro(
      "The plugin Geodesics was built for VTK " VTK_VERSION ", but this ParaView has VTK "
      << vtkVersion::GetVTKVersionFull()
      << ": its filters may crash. Build the plugin for this ParaView, "
         "see Wrapping/ParaView/paraview.sh.");
  }
}

#endif
