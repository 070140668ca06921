// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of vtkDGGLoop start from.
#ifndef LoopFixture_h
#define LoopFixture_h

#include "LoopTestTools.h"

#include <gtest/gtest.h>

namespace dggtest
{
/// A prism, a torus, and a filter that looks for loops on the first.
class LoopFixture : public ::testing::Test
{
protected:
  static constexpr int Sides = 7;
  static constexpr int Rows = 8;
  static constexpr int Nu = 30;
  static constexpr int Nv = 14;

  void SetUp() override
  {
    this->Filter->SetInputData(this->Prism);
    this->Filter->SetAccuracy(0.02);
  }

  vtkSmartPointer<vtkPolyData> Prism = MakePrism(Sides, Rows);
  vtkSmartPointer<vtkPolyData> Torus = MakeTorus(Nu, Nv);
  vtkNew<vtkDGGLoop> Filter;
};
}

#endif
