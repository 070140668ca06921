// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadedLoop.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

dgg::ParallelFor ThreadedLoop(int threads)
{
  return [threads](dgg::Offset size, dgg::Offset grain,
           const std::function<void(dgg::Offset, dgg::Offset)>& body) {
    const dgg::Offset step = std::max<dgg::Offset>(1, grain);
    std::atomic<dgg::Offset> next{ 0 };
    const auto work = [&] {
      for (dgg::Offset begin = next.fetch_add(step); begin < size; begin = next.fetch_add(step))
      {
        body(begin, std::min(begin + step, size));
      }
    };
    std::vector<std::thread> helpers;
    for (int i = 1; i < threads; ++i)
    {
      helpers.emplace_back(work);
    }
    work();
    for (std::thread& helper : helpers)
    {
      helper.join();
    }
  };
}
