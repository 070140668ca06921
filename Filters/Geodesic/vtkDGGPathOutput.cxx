// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPathOutput.h"

#include "vtkDGGMeshAdapter.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{
/// Values of PathStatus.
constexpr int HasPath = 0;
constexpr int NotConnected = 1;

template <typename ArrayType>
vtkSmartPointer<ArrayType> MakeArray(const char* name, vtkIdType size)
{
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName(name);
  array->SetNumberOfValues(size);
  return array;
}

/// Fills the points of the output, path by path.
class PointWriter
{
public:
  PointWriter(const vtkDGGMeshAdapter& mesh, const double* positions, vtkIdType size)
    : Mesh(mesh)
    , Positions(positions)
    , Faces(MakeArray<vtkIdTypeArray>("FaceId", size))
    , PointIds(MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", size))
    , ArcLengths(MakeArray<vtkDoubleArray>("ArcLength", size))
  {
    this->Points->SetDataTypeToDouble();
    this->Points->SetNumberOfPoints(size);
    this->Lines->AllocateEstimate(1, size);
  }

  void Add(const dgg::SurfacePath& path)
  {
    double arcLength = 0.0;
    this->Lines->InsertNextCell(static_cast<int>(path.Points.size()));
    for (std::size_t i = 0; i < path.Points.size(); ++i)
    {
      arcLength += i > 0 ? dgg::MeasurePiece(this->Mesh.GetMesh(), path, i - 1) : 0.0;
      const dgg::SurfacePoint& point = path.Points[i];
      this->Points->SetPoint(
        this->Next, dgg::PositionOf(this->Mesh.GetMesh(), point, this->Positions).data());
      this->Faces->SetValue(this->Next, this->FindCell(path, i));
      const bool isVertex = point.On == dgg::SurfacePoint::Support::Vertex;
      this->PointIds->SetValue(this->Next, isVertex ? point.Vertex : -1);
      this->ArcLengths->SetValue(this->Next, arcLength);
      this->Lines->InsertCellPoint(this->Next);
      ++this->Next;
    }
  }

  void AddTo(vtkPolyData* output) const
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetPointData()->AddArray(this->Faces);
    output->GetPointData()->AddArray(this->PointIds);
    output->GetPointData()->AddArray(this->ArcLengths);
  }

private:
  /// The cell of the input that piece i lies in; the last piece for the last point.
  vtkIdType FindCell(const dgg::SurfacePath& path, std::size_t i) const
  {
    const dgg::Id face = path.Faces.empty() ? dgg::FindFaceOf(this->Mesh.GetMesh(), path.Points[i])
                                            : path.Faces[std::min(i, path.Faces.size() - 1)];
    return face == dgg::NoId ? -1 : this->Mesh.GetCell(face);
  }

  const vtkDGGMeshAdapter& Mesh;
  const double* Positions;
  vtkIdType Next = 0;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkSmartPointer<vtkIdTypeArray> Faces;
  vtkSmartPointer<vtkIdTypeArray> PointIds;
  vtkSmartPointer<vtkDoubleArray> ArcLengths;
};

/// An array with a tuple of `from` for each polyline, or null values.
vtkSmartPointer<vtkAbstractArray> PassArray(
  vtkAbstractArray* from, const std::vector<vtkIdType>& tuples)
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(from->NewInstance());
  array->SetNumberOfComponents(from->GetNumberOfComponents());
  array->CopyComponentNames(from);
  array->SetName(from->GetName());
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    numbers->Fill(0.0);
  }
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    if (tuples[i] >= 0 && tuples[i] < from->GetNumberOfTuples())
    {
      array->SetTuple(static_cast<vtkIdType>(i), tuples[i], from);
    }
  }
  return array;
}

void AddCellData(const vtkDGGPathSet& set, const std::vector<vtkIdType>& pairs, vtkCellData* output)
{
  const auto count = static_cast<vtkIdType>(pairs.size());
  // Pairs by id come before those of lines, and have no tuple.
  const auto firstLine = static_cast<vtkIdType>(set.Paths.size() - set.CellsOfLast.size());
  std::vector<vtkIdType> tuples;
  auto ids = MakeArray<vtkIdTypeArray>("PairId", count);
  auto lengths = MakeArray<vtkDoubleArray>("Length", count);
  auto graphLengths = MakeArray<vtkDoubleArray>("GraphLength", count);
  auto straightened = MakeArray<vtkIntArray>("Straightened", count);
  for (vtkIdType line = 0; line < count; ++line)
  {
    const vtkIdType pair = pairs[line];
    const dgg::FoundPath& path = set.Paths[pair];
    tuples.push_back(pair < firstLine ? -1 : set.CellsOfLast[pair - firstLine]);
    ids->SetValue(line, pair);
    lengths->SetValue(line, path.Path.Length);
    graphLengths->SetValue(line, path.GraphLength);
    straightened->SetValue(line, path.IsStraightened ? 1 : 0);
  }
  for (int a = 0; set.CellData && a < set.CellData->GetNumberOfArrays(); ++a)
  {
    output->AddArray(PassArray(set.CellData->GetAbstractArray(a), tuples));
  }
  output->AddArray(lengths);
  output->AddArray(graphLengths);
  output->AddArray(straightened);
  output->AddArray(ids);
}
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkDGGFindUnconnected(const std::vector<dgg::FoundPath>& paths)
{
  std::vector<vtkIdType> unconnected;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (paths[i].Path.IsEmpty())
    {
      unconnected.push_back(static_cast<vtkIdType>(i));
    }
  }
  return unconnected;
}

//------------------------------------------------------------------------------
void vtkDGGWritePaths(const vtkDGGPathSet& set, const vtkDGGMeshAdapter& mesh,
  const double* positions, vtkPolyData* output)
{
  std::vector<vtkIdType> pairs;
  vtkIdType size = 0;
  auto status = MakeArray<vtkIntArray>("PathStatus", static_cast<vtkIdType>(set.Paths.size()));
  for (std::size_t i = 0; i < set.Paths.size(); ++i)
  {
    const dgg::SurfacePath& path = set.Paths[i].Path;
    status->SetValue(static_cast<vtkIdType>(i), path.IsEmpty() ? NotConnected : HasPath);
    if (!path.IsEmpty())
    {
      pairs.push_back(static_cast<vtkIdType>(i));
      size += static_cast<vtkIdType>(path.Points.size());
    }
  }
  PointWriter writer(mesh, positions, size);
  for (const vtkIdType pair : pairs)
  {
    writer.Add(set.Paths[pair].Path);
  }
  writer.AddTo(output);
  AddCellData(set, pairs, output->GetCellData());
  output->GetFieldData()->AddArray(status);
}
