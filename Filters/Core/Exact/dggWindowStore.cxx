// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowStore.h"

#include <algorithm>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace dgg
{
namespace
{
/// Lists between two calls of GiveBackMemory().
constexpr std::size_t ListsAtOnce = 65536;

/// Millions of small lists are freed to the heap of the process, which would keep their memory, so
/// that no large array could have it.
void GiveBackMemory()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}
}

void WindowStore::Start(bool isOn)
{
  std::vector<WindowList>(isOn ? this->Mesh.GetNumberOfHalfEdges() : 0).swap(this->Lists);
  this->Bytes = 0;
  if (!isOn)
  {
    WindowList().swap(this->Scratch);
    WindowList().swap(this->Merged);
  }
}

void WindowStore::Add(Id h, const WindowList& windows)
{
  WindowList& list = this->Lists[h];
  this->Bytes -= SizeOf(list);
  if (list.empty())
  {
    list = windows;
  }
  else
  {
    MergeEnvelopes(list, windows, this->Mesh.Length(h), this->Merged);
    list.assign(this->Merged.begin(), this->Merged.end());
  }
  this->Bytes += SizeOf(list);
}

void WindowStore::Add(Id h, const Window& window)
{
  WindowList& list = this->Lists[h];
  this->Bytes -= SizeOf(list);
  InsertIntoEnvelope(list, window, this->Mesh.Length(h), this->Scratch);
  this->Bytes += SizeOf(list);
}

void WindowStore::Trim(const std::vector<double>& labels)
{
  const Id halfEdges = this->Mesh.GetNumberOfHalfEdges();
  for (Id h = 0; h < halfEdges; ++h)
  {
    this->RemoveStale(this->Lists[h], labels);
    this->TrimByLabels(h, labels);
  }
}

void WindowStore::MoveTo(EdgeWindows& windows, double shift)
{
  windows.Offsets.assign(1, 0);
  windows.Offsets.reserve(this->Lists.size() + 1);
  windows.Windows.clear();
  windows.Windows.reserve(this->CountWindows());
  for (std::size_t h = 0; h < this->Lists.size(); ++h)
  {
    for (const Window& w : this->Lists[h])
    {
      windows.Windows.push_back({ w.Begin, w.End, w.Image, w.Sigma + shift, w.Root });
    }
    windows.Offsets.push_back(static_cast<Offset>(windows.Windows.size()));
    WindowList().swap(this->Lists[h]);
    if ((h + 1) % ListsAtOnce == 0)
    {
      GiveBackMemory();
    }
  }
  this->Start(false);
  GiveBackMemory();
}

std::size_t WindowStore::GetMemorySize() const
{
  return this->Lists.capacity() * sizeof(WindowList) + this->Bytes + SizeOf(this->Scratch) +
    SizeOf(this->Merged);
}

std::size_t WindowStore::GetMemoryToMove() const
{
  return this->GetMemorySize() + (this->Lists.size() + 1) * sizeof(Offset) +
    this->CountWindows() * sizeof(EdgeWindow);
}

std::size_t WindowStore::CountWindows() const
{
  std::size_t count = 0;
  for (const WindowList& list : this->Lists)
  {
    count += list.size();
  }
  return count;
}

/// A root that was reached on a shorter way later: its windows were sent out again.
void WindowStore::RemoveStale(WindowList& list, const std::vector<double>& labels) const
{
  const auto stale = std::remove_if(list.begin(), list.end(), [&](const Window& w) {
    return w.Root >= 0 && w.Sigma > labels[w.Root] * (1.0 + LengthTolerance);
  });
  list.erase(stale, list.end());
}

void WindowStore::TrimByLabels(Id h, const std::vector<double>& labels)
{
  const double length = this->Mesh.Length(h);
  const double atOrigin = labels[this->Mesh.Origin(h)];
  const double atEnd = labels[this->Mesh.Destination(h)];
  WindowList& list = this->Lists[h];
  const auto useless = std::remove_if(
    list.begin(), list.end(), [&](Window& w) { return !TrimByEnds(w, length, atOrigin, atEnd); });
  list.erase(useless, list.end());
}
}
