// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Rows of distance matrices that several processes find together. Run under mpiexec; a single
/// process is valid, too.
#include "PieceGraphFixture.h"

#include "vtkGeodesicDistanceMatrix.h"

#include "vtkTable.h"

#ifdef __linux__
#include <csignal>
#include <filesystem>
#include <sstream>
#include <sys/resource.h>
#include <unistd.h>
#endif

using namespace dggtest;

namespace
{
using Matrix = vtkSmartPointer<vtkGeodesicDistanceMatrix>;
using Numbers = std::vector<double>;

/// Distances, and the compressed rows if they are in use. Unreached distances are -1.
std::vector<Numbers> GetNumbers(vtkGeodesicDistanceMatrix* filter)
{
  std::vector<Numbers> numbers;
  vtkTable* table = filter->GetOutput();
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(filter->GetMatrix()),
         vtkDataArray::SafeDownCast(table->GetColumnByName("Column")),
         vtkDataArray::SafeDownCast(table->GetColumnByName("GeodesicDistance")),
         table->GetFieldData()->GetArray("RowOffsets") })
  {
    numbers.emplace_back();
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      numbers.back().push_back(array->GetVariantValue(i).ToDouble());
    }
  }
  return numbers;
}

/// Returns about `count` ids of points, from `first` on.
std::vector<vtkIdType> ChooseIds(vtkPolyData* surface, int count, vtkIdType first = 0)
{
  std::vector<vtkIdType> ids;
  for (vtkIdType id = first; id < surface->GetNumberOfPoints();
       id += surface->GetNumberOfPoints() / count)
  {
    ids.push_back(id);
  }
  return ids;
}

class RowsOnProcesses : public PieceGraph
{
protected:
  template <typename Prepare>
  void ExpectRowsOfOne(vtkPolyData* surface, const Prepare& prepare)
  {
    const auto search = [&](vtkGeodesicDistanceMatrix* filter) {
      filter->SetAccuracy(0.05);
      filter->SetUnreachedValue(-1.0);
      filter->GenerateTableOff();
      prepare(filter);
    };
    const Matrix alone = this->Alone<vtkGeodesicDistanceMatrix>(surface, search);
    const std::vector<Numbers> expected = GetNumbers(alone);
    ASSERT_GT(expected[0].size() + expected[1].size(), 0u);
    for (const Labels& labels :
      { LabelStrips(surface, this->Count), LabelScattered(surface, this->Count) })
    {
      const auto part = TakePart(surface, labels, this->Here, PartIds::Global);
      const Matrix together = this->Together<vtkGeodesicDistanceMatrix>(part, search);
      if (this->IsFirst())
      {
        EXPECT_EQ(GetNumbers(together), expected);
      }
      else
      {
        EXPECT_EQ(together->GetMatrix()->GetNumberOfTuples(), 0);
      }
    }
  }
};
}

//------------------------------------------------------------------------------
/// Rows of points, and of positions on the surface, are those of one process. Components have no
/// distance from each other.
TEST_F(RowsOnProcesses, DistancesOfOneProcess)
{
  const auto surface = Beside(MakeTerrain(24), MakeTerrain(12), 3.0);
  const auto rows = ChooseIds(surface, 60);
  const auto columns = ChooseIds(surface, 37, 2);
  const auto some = MakeSources();
  for (const double radius : { VTK_DOUBLE_MAX, 0.3 })
  {
    this->ExpectRowsOfOne(surface, [&](auto* matrix) {
      matrix->SetRowIds(rows);
      matrix->SetMaximumDistance(radius);
    });
    this->ExpectRowsOfOne(surface, [&](auto* matrix) {
      matrix->SetRowIds(rows);
      matrix->SetRowData(some);
      matrix->SetColumnIds(columns);
      matrix->SetColumnData(MakeSourcePoints({ { { 0.5, 0.3, GetTerrainHeight(0.5, 0.3) } } }));
      matrix->SetMaximumDistance(radius);
    });
  }
  this->ExpectRowsOfOne(surface, [&](auto* matrix) {
    matrix->SetRowIds({ 3 }); // fewer rows than processes
    matrix->SetColumnIds(columns);
  });
}

#ifdef __linux__
//------------------------------------------------------------------------------
/// Shared memory has no file after an update. If it cannot be allocated, here because files must
/// not have more than one byte, rows are those of one process, too.
TEST_F(RowsOnProcesses, SharedMemory)
{
  std::stringstream name;
  name << "dgg-" << std::hex << getpid() << '-';
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  for (const rlim_t bytes : { limit.rlim_cur, rlim_t{ 1 } })
  {
    const rlimit changed{ bytes, limit.rlim_max };
    setrlimit(RLIMIT_FSIZE, &changed);
    this->ExpectRowsOfOne(
      this->Surface, [&](auto* matrix) { matrix->SetRowIds(ChooseIds(this->Surface, 40)); });
    setrlimit(RLIMIT_FSIZE, &limit);
    for (const auto& file : std::filesystem::directory_iterator("/dev/shm"))
    {
      EXPECT_NE(file.path().filename().string().rfind(name.str(), 0), 0u) << file.path();
    }
  }
  std::signal(SIGXFSZ, before);
}
#endif

//------------------------------------------------------------------------------
/// Compressed rows, corrected or not, are those of one process, also where points are merged.
TEST_F(RowsOnProcesses, CompressedRowsOfOneProcess)
{
  for (const bool isMerged : { false, true })
  {
    const auto surface = isMerged ? MakeSeam(20) : MakeTerrain(20);
    for (const bool isCorrected : { false, true })
    {
      this->ExpectRowsOfOne(surface, [&](auto* matrix) {
        matrix->SetRowIds(ChooseIds(surface, 50));
        matrix->SetRowData(MakeSources());
        matrix->SetMaximumDistance(0.25);
        matrix->SetMergeCoincidentPoints(isMerged);
        matrix->SetCorrection(isCorrected);
        matrix->CompressedRowsOn();
      });
    }
  }
}

//------------------------------------------------------------------------------
/// All processes search: each of them reports progress, can abort, and fails if it lacks memory.
/// Then none has results, and the next update has those of one process.
TEST_F(RowsOnProcesses, ResultsAfterAbortsAndErrors)
{
  const auto search = [&](auto* filter) {
    filter->SetAccuracy(0.002);
    filter->SetRowIds(ChooseIds(this->Surface, 200));
  };
  const Matrix alone = this->Alone<vtkGeodesicDistanceMatrix>(this->Surface, search);
  vtkNew<vtkGeodesicDistanceMatrix> matrix;
  matrix->SetInputData(this->TakeStrip(this->Surface, PartIds::Global));
  search(matrix.Get());
  const Listener listener(matrix);
  ProgressWatch watch(matrix);
  const auto update = [&] {
    watch.Progress.clear();
    matrix->Modified();
    this->Update(matrix);
  };
  const auto expectRows = [&] {
    update();
    watch.ExpectGrowth(2);
    if (this->IsFirst())
    {
      EXPECT_EQ(GetNumbers(matrix), GetNumbers(alone));
    }
  };
  expectRows();
  const auto expectNothing = [&] {
    EXPECT_EQ(matrix->GetMatrix()->GetNumberOfTuples(), 0);
    EXPECT_EQ(matrix->GetOutput()->GetNumberOfColumns(), 0);
  };
  for (const int process : { 0, this->Count - 1 })
  {
    watch.StopAt = this->Here == process ? 0.5 : 2.0;
    update();
    expectNothing();
    EXPECT_TRUE(listener.Errors.empty());
    watch.StopAt = 2.0;
    expectRows();
  }
  matrix->SetMemoryLimit(this->Here == this->Count - 1 ? 1000000 : 0);
  update();
  expectNothing();
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(
    listener.Errors[0].find("A process that finds rows of the matrix needs"), std::string::npos)
    << listener.Errors[0];
  matrix->SetMemoryLimit(0);
  expectRows();
  matrix->SetRowIds({ 3, 5000 });
  update();
  expectNothing();
  EXPECT_EQ(listener.Errors.size(), 2u);
}
