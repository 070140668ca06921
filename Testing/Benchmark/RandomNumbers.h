// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random numbers that are the same with every standard library (the standard's distributions
/// differ).
#ifndef RandomNumbers_h
#define RandomNumbers_h

#include <random> // for the engine

class RandomNumbers
{
public:
  explicit RandomNumbers(unsigned int seed)
    : Engine(seed)
  {
  }

  /// Returns a number with uniform distribution in [0, 1).
  double operator()() { return static_cast<double>(this->Engine()) / 4294967296.0; }

private:
  std::mt19937 Engine;
};

#endif
