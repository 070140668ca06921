// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGParallel.h"

#include "vtkSMPTools.h"

#include <exception>
#include <mutex>

//------------------------------------------------------------------------------
dgg::ParallelFor vtkDGGMakeParallelFor()
{
  return [](dgg::Offset size, dgg::Offset grain,
           const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    std::mutex mutex;
    std::exception_ptr thrown;
    auto guarded = [&](vtkIdType begin, vtkIdType end) {
      try
      {
        body(begin, end);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        thrown = thrown ? thrown : std::current_exception();
      }
    };
    vtkSMPTools::For(0, size, grain, guarded);
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}
