// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryProbe.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>

#ifdef __linux__
#include <malloc.h>
#endif

namespace
{
std::atomic<std::size_t> Held{ 0 };
std::atomic<std::size_t> Peak{ 0 };

std::size_t SizeOf(void* block)
{
#ifdef __linux__
  return malloc_usable_size(block);
#else
  (void)block;
  return 0;
#endif
}

/// An entry of /proc/self/status in bytes; 0 when there is none.
std::size_t ReadStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word)
  {
    if (word == key + ":")
    {
      std::size_t kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  }
  return 0;
}

void ResetResidentPeak()
{
  std::ofstream("/proc/self/clear_refs") << "5";
}
}

void* operator new(std::size_t size)
{
  void* block = std::malloc(size > 0 ? size : 1);
  if (!block)
  {
    throw std::bad_alloc();
  }
  // Not exact when threads race for the peak; the benchmarks run on one.
  const std::size_t held = Held += SizeOf(block);
  if (held > Peak)
  {
    Peak = held;
  }
  return block;
}

void operator delete(void* block) noexcept
{
  if (block)
  {
    Held -= SizeOf(block);
    std::free(block);
  }
}

void* operator new[](std::size_t size)
{
  return operator new(size);
}

void operator delete[](void* block) noexcept
{
  operator delete(block);
}

void operator delete(void* block, std::size_t) noexcept
{
  operator delete(block);
}

void operator delete[](void* block, std::size_t) noexcept
{
  operator delete(block);
}

MemoryProbe::MemoryProbe()
{
#ifdef __linux__
  // Free blocks kept by the allocator would hide growth of the resident set.
  malloc_trim(0);
#endif
  ResetResidentPeak();
  this->ResidentBefore = ReadStatus("VmRSS");
  this->HeapBefore = Held;
  Peak = Held.load();
}

std::size_t MemoryProbe::GetHeapPeak() const
{
  return Peak - this->HeapBefore;
}

std::size_t MemoryProbe::GetResidentPeak() const
{
  const std::size_t peak = ReadStatus("VmHWM");
  return peak > this->ResidentBefore ? peak - this->ResidentBefore : 0;
}
