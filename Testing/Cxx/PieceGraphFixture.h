// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graphs of surfaces that several processes have in pieces.
#ifndef PieceGraphFixture_h
#define PieceGraphFixture_h

#include "SeveralProcessesFixture.h"

#include "vtkFieldData.h"

#include <algorithm>
#include <set>

namespace dggtest
{
/// Values of an array in field data; empty if there is no such array.
inline std::vector<double> GetValues(vtkPolyData* data, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

/// Returns messages without the addresses of filters.
inline std::vector<std::string> StripAddresses(std::vector<std::string> messages)
{
  for (std::string& message : messages)
  {
    message.erase(0, message.find("): "));
  }
  return messages;
}

/// A rule that assigns cells to pieces.
struct Division
{
  const char* Name;
  Labels (*Label)(vtkPolyData* surface, int parts);
};

/// Assigns cells to connected pieces, and the components without a seed to the first one.
inline Labels LabelConnected(vtkPolyData* surface, int parts)
{
  Labels labels = LabelRandomly(surface, parts, 5);
  std::replace(labels.begin(), labels.end(), -1, 0);
  return labels;
}

/// Assigns cells to strips; the first of more than two pieces is empty.
inline Labels LabelStripsButOne(vtkPolyData* surface, int parts)
{
  const int empty = parts > 2 ? 1 : 0;
  Labels labels = LabelStrips(surface, parts - empty);
  std::for_each(labels.begin(), labels.end(), [empty](int& label) { label += empty; });
  return labels;
}

inline const Division divisions[] = { { "Strips", LabelStrips }, { "Bisection", LabelBisection },
  { "Connected", LabelConnected }, { "Scattered", LabelScattered },
  { "OneIsEmpty", LabelStripsButOne } };

/// Returns the centers of some cells, and points between two of their corners.
inline vtkSmartPointer<vtkPolyData> MakePointsOfCells(vtkPolyData* surface)
{
  Points points;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 3; cell < surface->GetNumberOfCells();
       cell += surface->GetNumberOfCells() / 7 + 1)
  {
    surface->GetCellPoints(cell, corners);
    std::array<double, 3> center{};
    std::array<double, 3> middle{};
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const double x = surface->GetPoint(corners->GetId(k))[axis];
        center[axis] += x / static_cast<double>(corners->GetNumberOfIds());
        middle[axis] += k < 2 ? 0.5 * x : 0.0;
      }
    }
    points.push_back(center);
    points.push_back(middle);
  }
  return MakeSourcePoints(points);
}

/// Returns a point of cells with different labels.
inline vtkIdType FindSharedPoint(vtkPolyData* surface, const Labels& labels)
{
  std::vector<int> labelOfPoints(surface->GetNumberOfPoints(), -1);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      int& label = labelOfPoints[corners->GetId(k)];
      if (label >= 0 && label != labels[cell])
      {
        return corners->GetId(k);
      }
      label = labels[cell];
    }
  }
  ADD_FAILURE() << "the pieces do not touch";
  return 0;
}

class PieceGraph : public SeveralProcesses
{
protected:
  void SetUp() override
  {
    if (this->Count == 1)
    {
      GTEST_SKIP() << "the test needs several processes";
    }
  }

  vtkIdType Sum(vtkIdType here) const
  {
    vtkIdType sum = 0;
    this->Controller->AllReduce(&here, &sum, 1, vtkCommunicator::SUM_OP);
    return sum;
  }

  /// Expects that the elements of all processes are the expected ones.
  template <typename Element>
  void ExpectAll(const std::multiset<Element>& here, const std::multiset<Element>& expected) const
  {
    EXPECT_TRUE(std::includes(expected.begin(), expected.end(), here.begin(), here.end()));
    EXPECT_EQ(
      this->Sum(static_cast<vtkIdType>(here.size())), static_cast<vtkIdType>(expected.size()));
  }

  /// Expects that the update of all processes ends if the last process aborts at one of these
  /// values of its progress or has a memory limit that is too low. `expectOutput` checks the output
  /// of the next update.
  template <typename Filter, typename Expect>
  void ExpectRecovery(Filter* filter, const std::vector<double>& stops, const Expect& expectOutput)
  {
    const bool isLast = this->Here == this->Count - 1;
    const Listener listener(filter);
    ProgressWatch watch(filter);
    for (const double stopAt : stops)
    {
      watch.StopAt = isLast ? stopAt : 2.0;
      filter->Modified();
      this->Update(filter);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << stopAt;
      watch.StopAt = 2.0;
      this->Update(filter);
      expectOutput();
    }
    EXPECT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    filter->SetMemoryLimit(isLast ? 1 : 0);
    filter->Modified();
    this->Update(filter);
    EXPECT_EQ(listener.Errors.size(), 1u);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    filter->SetMemoryLimit(0);
    filter->Modified();
    this->Update(filter);
    expectOutput();
    EXPECT_EQ(listener.Errors.size(), 1u);
  }

  /// Expects that the rows of a piece are rows of a graph, bit by bit, and that each row is in one
  /// piece.
  void ExpectRows(vtkPolyData* piece, vtkPolyData* whole) const
  {
    const auto offsets = GetValues(piece, "DGG.Offsets");
    const auto targets = GetValues(piece, "DGG.Targets");
    const auto ghosts = GetValues(piece, "DGG.GhostIds");
    const auto owners = GetValues(piece, "DGG.Owners");
    const auto all = GetValues(whole, "DGG.Offsets");
    const auto allTargets = GetValues(whole, "DGG.Targets");
    const vtkIdType n = piece->GetNumberOfPoints();
    ASSERT_EQ(offsets.size(), n + ghosts.size() + 1);
    ASSERT_EQ(owners.size(), n + ghosts.size());
    vtkIdType edges = 0;
    vtkDataArray* ids = piece->GetPointData()->GetArray("Whole");
    const auto getId = [&](double target) {
      const auto v = static_cast<vtkIdType>(target);
      return v < n ? ids->GetComponent(v, 0) : ghosts[v - n];
    };
    for (vtkIdType i = 0; i < n; ++i)
    {
      const auto id = static_cast<std::size_t>(getId(static_cast<double>(i)));
      const auto begin = static_cast<std::size_t>(offsets[i]);
      const auto size = static_cast<std::size_t>(offsets[i + 1]) - begin;
      if (owners[i] >= 0.0)
      {
        continue; // the point belongs to another process
      }
      edges += static_cast<vtkIdType>(size);
      const auto to = static_cast<std::size_t>(all[id]);
      ASSERT_EQ(size, static_cast<std::size_t>(all[id + 1]) - to) << "point " << id;
      for (std::size_t e = 0; e < size; ++e)
      {
        ASSERT_EQ(getId(targets[begin + e]), allTargets[to + e]) << "point " << id;
      }
      for (const char* name : { "DGG.Lengths", "DGG.Angles", "DGG.ArrivalAngles" })
      {
        const auto values = GetValues(piece, name);
        const auto expected = GetValues(whole, name);
        ASSERT_TRUE(
          std::equal(values.begin() + begin, values.begin() + begin + size, expected.begin() + to))
          << name << " of point " << id;
      }
    }
    EXPECT_EQ(this->Sum(edges), static_cast<vtkIdType>(allTargets.size()));
  }
};

/// Tests with the pieces of a division.
class DividedSurface
  : public PieceGraph
  , public testing::WithParamInterface<Division>
{
protected:
  /// Returns the piece of this process, with ghosts if the number of processes is even.
  vtkSmartPointer<vtkPolyData> TakePiece(vtkPolyData* surface) const
  {
    return TakePart(surface, this->GetParam().Label(surface, this->Count), this->Here,
      PartIds::Global, this->Count % 2 == 0);
  }
};
}

#endif
