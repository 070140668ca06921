// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The meshes (*.ply and awkward/*.ply) and point clouds of the folder DGG_EXTRA_DATA, for tests
/// with a parameter.
#ifndef ExtraMeshes_h
#define ExtraMeshes_h

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Their paths, sorted.
std::vector<std::string> FindExtraMeshes();
/// The same of the point clouds (clouds/*.ply).
std::vector<std::string> FindExtraClouds();

/// The name of the file as the name of a test.
std::string NameExtraMesh(const testing::TestParamInfo<std::string>& info);

#endif
