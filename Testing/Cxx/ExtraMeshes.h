// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes (*.ply and awkward/*.ply) and point clouds of the folder DGG_EXTRA_DATA, as parameters of
/// tests.
#ifndef ExtraMeshes_h
#define ExtraMeshes_h

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Returns the paths of the meshes, sorted.
std::vector<std::string> FindExtraMeshes();
/// Returns the paths of the point clouds (clouds/*.ply), sorted.
std::vector<std::string> FindExtraClouds();

/// Returns the file name as the name of a test.
std::string NameExtraMesh(const testing::TestParamInfo<std::string>& info);

#endif
