// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryProbe.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string>

#ifdef __GLIBC__ // defined by <cstdlib>
#include <malloc.h>
#endif

namespace
{
std::atomic<std::size_t> Held{ 0 };
std::atomic<std::size_t> Peak{ 0 };

/// Returns an entry of /proc/self/status in bytes; 0 if there is none.
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

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) // ASan has its own
// glibc allows programs to replace these functions, and provides its own ones under other names.
// All allocations then pass through the functions below: operator new, Eigen, VTK's arrays.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace
{
/// Counts a block. The peak is inexact if several threads allocate; the benchmarks run on one.
void* Took(void* block)
{
  const std::size_t held = Held += block ? malloc_usable_size(block) : 0;
  if (held > Peak)
  {
    Peak = held;
  }
  return block;
}

void Gives(void* block)
{
  Held -= block ? malloc_usable_size(block) : 0;
}
}

// Libraries can call only visible functions; libstdc++ 14 allocates aligned blocks by
// posix_memalign().
#pragma GCC visibility push(default)
extern "C" {
void* malloc(std::size_t size) noexcept
{
  return Took(__libc_malloc(size));
}

void* calloc(std::size_t count, std::size_t size) noexcept
{
  return Took(__libc_calloc(count, size));
}

void* realloc(void* block, std::size_t size) noexcept
{
  const std::size_t before = block ? malloc_usable_size(block) : 0;
  void* moved = __libc_realloc(block, size);
  // On failure the block remains; with size 0 it has been released.
  Held -= moved || size == 0 ? before : 0;
  return Took(moved);
}

void free(void* block) noexcept
{
  Gives(block);
  __libc_free(block);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept
{
  return Took(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept
{
  return Took(__libc_memalign(alignment, size));
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept
{
  *block = Took(__libc_memalign(alignment, size));
  return *block ? 0 : ENOMEM;
}
}
#pragma GCC visibility pop
#endif

MemoryProbe::MemoryProbe()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) // ASan has its own
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

std::size_t MemoryProbe::GetHeapGrowth() const
{
  const std::size_t held = Held;
  return held > this->HeapBefore ? held - this->HeapBefore : 0;
}

std::size_t MemoryProbe::GetResidentPeak() const
{
  const std::size_t peak = ReadStatus("VmHWM");
  return peak > this->ResidentBefore ? peak - this->ResidentBefore : 0;
}
