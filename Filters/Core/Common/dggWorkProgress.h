// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The progress of work that comes in pieces of any size. Internal.
#ifndef dggWorkProgress_h
#define dggWorkProgress_h

#include "dggTypes.h" // for ProgressCallback

#include <algorithm> // for std::min
#include <utility>   // for std::move

namespace dgg
{
/// Tells the progress each time that another 32 768 units of work are done, such as faces: a few
/// milliseconds.
class WorkProgress
{
public:
  WorkProgress(ProgressCallback progress, double whole)
    : Progress(std::move(progress))
    , Whole(whole)
  {
  }

  /// Some more is done. Returns whether to go on; once it is false, it remains so.
  bool Add(double work)
  {
    this->Done += work;
    if (this->Progress && this->Goes && this->Done >= this->Next)
    {
      this->Next = this->Done + Interval;
      this->Goes = this->Progress(std::min(1.0, this->Done / this->Whole));
    }
    return this->Goes;
  }

private:
  static constexpr double Interval = 32768.0;

  ProgressCallback Progress; // may be empty
  double Whole;
  double Done = 0.0;
  double Next = Interval;
  bool Goes = true;
};
}

#endif
