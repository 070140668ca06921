// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSegmentTree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace dgg
{
namespace
{
/// Segments that are looked at one by one.
constexpr std::size_t LeafSize = 8;
}

GridBox GridBox::Around(const GridSegment& segment)
{
  GridBox box = Around(segment.From, 0);
  box.Add(Around(segment.To, 0));
  return box;
}

GridBox GridBox::Around(const GridPoint& point, std::int64_t distance)
{
  GridBox box;
  box.Low = { { point.X, point.Y, point.X + point.Y, point.X - point.Y } };
  box.High = box.Low;
  for (int k = 0; k < 4; ++k)
  {
    box.Low[k] -= 2 * distance;
    box.High[k] += 2 * distance;
  }
  return box;
}

bool GridBox::Meets(const GridBox& other) const
{
  for (int k = 0; k < 4; ++k)
  {
    if (this->High[k] < other.Low[k] || other.High[k] < this->Low[k])
    {
      return false;
    }
  }
  return true;
}

void GridBox::Add(const GridBox& other)
{
  for (int k = 0; k < 4; ++k)
  {
    this->Low[k] = std::min(this->Low[k], other.Low[k]);
    this->High[k] = std::max(this->High[k], other.High[k]);
  }
}

void SegmentTree::Build(const std::vector<GridSegment>& segments)
{
  this->Boxes.clear();
  for (const GridSegment& segment : segments)
  {
    this->Boxes.push_back(GridBox::Around(segment));
  }
  this->Order.resize(segments.size());
  std::iota(this->Order.begin(), this->Order.end(), 0);
  this->Nodes.clear();
  if (segments.empty())
  {
    return;
  }
  this->Nodes.push_back({ {}, 0, segments.size(), 0 });
  for (std::size_t n = 0; n < this->Nodes.size(); ++n)
  {
    Node node = this->Nodes[n];
    const auto begin = this->Order.begin() + static_cast<std::ptrdiff_t>(node.Begin);
    const auto end = this->Order.begin() + static_cast<std::ptrdiff_t>(node.End);
    node.Box = this->Boxes[*begin];
    std::for_each(begin, end, [&](std::size_t s) { node.Box.Add(this->Boxes[s]); });
    if (node.End - node.Begin > LeafSize)
    {
      // Halves by the middles of the boxes, across the direction in which the box is widest.
      int widest = 0;
      for (int k = 1; k < 4; ++k)
      {
        const bool isWider =
          node.Box.High[k] - node.Box.Low[k] > node.Box.High[widest] - node.Box.Low[widest];
        widest = isWider ? k : widest;
      }
      auto key = [&](std::size_t s) {
        const GridBox& box = this->Boxes[s];
        return std::make_pair(box.Low[widest] + box.High[widest], s);
      };
      const std::size_t middle = node.Begin + (node.End - node.Begin) / 2;
      std::nth_element(begin, this->Order.begin() + static_cast<std::ptrdiff_t>(middle), end,
        [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
      node.Children = this->Nodes.size();
      this->Nodes.push_back({ {}, node.Begin, middle, 0 });
      this->Nodes.push_back({ {}, middle, node.End, 0 });
    }
    this->Nodes[n] = node;
  }
}

void SegmentTree::Find(const GridBox& box, std::vector<std::size_t>& found)
{
  found.clear();
  this->Stack.assign(this->Nodes.empty() ? 0 : 1, 0);
  while (!this->Stack.empty())
  {
    const Node& node = this->Nodes[this->Stack.back()];
    this->Stack.pop_back();
    if (!node.Box.Meets(box))
    {
      continue;
    }
    if (node.Children > 0)
    {
      this->Stack.push_back(node.Children);
      this->Stack.push_back(node.Children + 1);
      continue;
    }
    for (std::size_t i = node.Begin; i < node.End; ++i)
    {
      if (this->Boxes[this->Order[i]].Meets(box))
      {
        found.push_back(this->Order[i]);
      }
    }
  }
  std::sort(found.begin(), found.end());
}
}
