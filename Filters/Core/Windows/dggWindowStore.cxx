// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowStore.h"

#include <algorithm>
#include <iterator>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace dgg
{
namespace
{
/// Number of lists between two calls of GiveBackMemory().
constexpr std::size_t ListsAtOnce = 65536;

/// Returns freed memory to the operating system. Millions of small lists would otherwise remain in
/// the heap of the process, unavailable to large arrays.
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
  this->Held = 0;
  if (!isOn)
  {
    WindowList().swap(this->Scratch);
    WindowList().swap(this->Merged);
  }
}

void WindowStore::Add(Id h, const WindowList& windows)
{
  WindowList& list = this->Lists[h];
  this->Held -= list.capacity();
  if (list.empty())
  {
    list = windows;
  }
  else
  {
    MergeEnvelopes(list, windows, this->Mesh.Length(h), this->Merged);
    list.assign(this->Merged.begin(), this->Merged.end());
  }
  this->Held += list.capacity();
}

void WindowStore::Add(Id h, const Window& window)
{
  WindowList& list = this->Lists[h];
  this->Held -= list.capacity();
  InsertIntoEnvelope(list, window, this->Mesh.Length(h), this->Scratch);
  this->Held += list.capacity();
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
  return this->Lists.size() * sizeof(WindowList) + this->Held * sizeof(Window);
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

/// Removes windows whose root was later reached by a shorter path, and whose windows were emitted
/// again.
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

void WindowMemory::KeepNews(Id h, double length, WindowList& list)
{
  WindowList& known = this->Known[h];
  MergeEnvelopes(known, list, length, this->Merged);
  list.clear();
  std::copy_if(this->Merged.begin(), this->Merged.end(), std::back_inserter(list),
    [](const Window& w) { return !w.IsKnown; });
  WindowList passed = list;
  for (Window& w : passed)
  {
    // Slightly shortened, so that an equal window that arrives later loses.
    const double bias = LengthTolerance * std::max(w.DistanceAtBegin, w.DistanceAtEnd);
    w.Sigma -= bias;
    w.DistanceAtBegin -= bias;
    w.DistanceAtEnd -= bias;
    w.IsKnown = true;
  }
  MergeEnvelopes(known, passed, length, this->Merged);
  known.swap(this->Merged);
}

std::size_t WindowMemory::GetMemorySize() const
{
  std::size_t bytes = 0;
  for (const auto& known : this->Known)
  {
    bytes += sizeof(known) + known.second.capacity() * sizeof(Window);
  }
  return bytes;
}
}
