// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How much memory the control groups of Linux leave. Internal.
#ifndef vtkDGGControlGroup_h
#define vtkDGGControlGroup_h

#include "vtkType.h" // for vtkTypeUInt64

#include <string> // for paths

/// Bytes that the control groups of this process leave it: the least that the group itself or any
/// group around it has free. The largest number when nothing limits it. `membership` is the file
/// that names the groups of the process (/proc/self/cgroup), `mount` where the groups are mounted
/// (/sys/fs/cgroup).
vtkTypeUInt64 vtkDGGGetFreeInControlGroup(const std::string& membership, const std::string& mount);

#endif
// VTK-HeaderTest-Exclude: vtkDGGControlGroup.h
