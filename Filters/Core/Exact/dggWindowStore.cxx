// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowStore.h"

#include <algorithm>

namespace dgg
{
void WindowStore::Start(bool isOn)
{
  this->Lists.clear();
  if (isOn)
  {
    this->Lists.resize(this->Mesh.GetNumberOfHalfEdges());
  }
}

void WindowStore::Add(Id h, const WindowList& windows)
{
  WindowList& list = this->Lists[h];
  if (list.empty())
  {
    list = windows;
    return;
  }
  MergeEnvelopes(list, windows, this->Mesh.Length(h), this->Merged);
  list.assign(this->Merged.begin(), this->Merged.end());
}

void WindowStore::Add(Id h, const Window& window)
{
  WindowList& list = this->Lists[h];
  InsertIntoEnvelope(list, window, this->Mesh.Length(h), this->Scratch);
}

void WindowStore::Finish(const std::vector<double>& labels, double shift, EdgeWindows& windows)
{
  const Id halfEdges = this->Mesh.GetNumberOfHalfEdges();
  for (Id h = 0; h < halfEdges; ++h)
  {
    this->RemoveStale(this->Lists[h], labels);
    this->TrimByLabels(h, labels);
  }
  windows.Offsets.assign(1, 0);
  windows.Offsets.reserve(halfEdges + 1);
  windows.Windows.clear();
  std::size_t count = 0;
  for (const WindowList& list : this->Lists)
  {
    count += list.size();
  }
  windows.Windows.reserve(count);
  for (Id h = 0; h < halfEdges; ++h)
  {
    for (const Window& w : this->Lists[h])
    {
      windows.Windows.push_back({ w.Begin, w.End, w.Image, w.Sigma + shift, w.Root });
    }
    windows.Offsets.push_back(static_cast<Offset>(windows.Windows.size()));
    WindowList().swap(this->Lists[h]);
  }
  this->Lists.clear();
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
