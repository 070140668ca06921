// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceMatrix.h"

#include "vtkDGGGraphProvider.h"
#include "vtkDGGMatrixSearch.h"
#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGSourceCollector.h"

#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

vtkStandardNewMacro(vtkGeodesicDistanceMatrix);

namespace
{
std::vector<vtkIdType> ToVector(vtkIdList* ids)
{
  return ids ? std::vector<vtkIdType>(ids->begin(), ids->end()) : std::vector<vtkIdType>();
}

bool IsEmpty(const vtkDGGSourceSet& set)
{
  return set.Ids.empty() && !set.Points;
}

std::vector<dgg::SurfacePoint> ToPoints(const std::vector<dgg::GeodesicSource>& sources)
{
  std::vector<dgg::SurfacePoint> points;
  for (const dgg::GeodesicSource& source : sources)
  {
    points.push_back(source.Point);
  }
  return points;
}

/// Columns named by their numbers. Returns where their values are to be put.
std::vector<double*> AddColumns(vtkTable* table, std::size_t rows, std::size_t columns)
{
  std::vector<double*> values;
  for (std::size_t j = 0; j < columns; ++j)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(std::to_string(j).c_str());
    column->SetNumberOfValues(static_cast<vtkIdType>(rows));
    values.push_back(column->GetPointer(0));
    table->AddColumn(column);
  }
  return values;
}
}

//------------------------------------------------------------------------------
struct vtkGeodesicDistanceMatrix::vtkInternals
{
  vtkDGGSourceCollector Collector;
  vtkDGGGraphProvider Provider;
  vtkNew<vtkDoubleArray> Matrix; // on demand
  vtkMTimeType MatrixTime = 0;   // of the table that it was made from
};

//------------------------------------------------------------------------------
vtkGeodesicDistanceMatrix::vtkGeodesicDistanceMatrix()
  : ProjectionTolerance(0.01)
  , Accuracy(0.01)
  , IsAccuracyExplicit(false)
  , MemoryLimit(0)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceMatrix::~vtkGeodesicDistanceMatrix() = default;

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRowIds: " << this->RowIds.size() << "\n";
  os << indent << "NumberOfColumnIds: " << this->ColumnIds.size() << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "UsedInputGraph: " << (this->GetUsedInputGraph() ? "yes" : "no") << "\n";
  os << indent << "GraphAccuracy: " << this->GetGraphAccuracy() << "\n";
  os << indent << "NumberOfGraphEdges: " << this->GetNumberOfGraphEdges() << "\n";
  os << indent << "GraphBuildTime: " << this->GetGraphBuildTime() << "\n";
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetRowIds(vtkIdList* ids)
{
  this->SetRowIds(ToVector(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetRowIds(std::initializer_list<vtkIdType> ids)
{
  this->SetRowIds(std::vector<vtkIdType>(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetRowIds(const std::vector<vtkIdType>& ids)
{
  if (this->RowIds != ids)
  {
    this->RowIds = ids;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetColumnIds(vtkIdList* ids)
{
  this->SetColumnIds(ToVector(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetColumnIds(std::initializer_list<vtkIdType> ids)
{
  this->SetColumnIds(std::vector<vtkIdType>(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetColumnIds(const std::vector<vtkIdType>& ids)
{
  if (this->ColumnIds != ids)
  {
    this->ColumnIds = ids;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceMatrix::GetNumberOfRowIds() const
{
  return static_cast<vtkIdType>(this->RowIds.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceMatrix::GetNumberOfColumnIds() const
{
  return static_cast<vtkIdType>(this->ColumnIds.size());
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetRowConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetRowData(vtkPolyData* points)
{
  this->SetInputData(1, points);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetColumnConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetColumnData(vtkPolyData* points)
{
  this->SetInputData(2, points);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetAccuracy(double accuracy)
{
  if (this->Accuracy != accuracy || !this->IsAccuracyExplicit)
  {
    this->Accuracy = accuracy;
    this->IsAccuracyExplicit = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::SetUnreachedValue(double value)
{
  const bool bothNaN = std::isnan(value) && std::isnan(this->UnreachedValue);
  if (this->UnreachedValue != value && !bothNaN)
  {
    this->UnreachedValue = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkGeodesicDistanceMatrix::GetOutput()
{
  return this->GetOutput(0);
}

//------------------------------------------------------------------------------
vtkTable* vtkGeodesicDistanceMatrix::GetOutput(int port)
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(port));
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkGeodesicDistanceMatrix::GetMatrix()
{
  vtkDoubleArray* matrix = this->Internals->Matrix;
  vtkTable* table = this->GetOutput();
  const vtkMTimeType time = table ? table->GetMTime() : 0;
  if (this->Internals->MatrixTime == time)
  {
    return matrix;
  }
  this->Internals->MatrixTime = time;
  const vtkIdType rows = table ? table->GetNumberOfRows() : 0;
  const vtkIdType columns = table ? table->GetNumberOfColumns() : 0;
  matrix->Initialize();
  matrix->SetName("GeodesicDistance");
  matrix->SetNumberOfComponents(static_cast<int>(std::max<vtkIdType>(columns, 1)));
  matrix->SetNumberOfTuples(rows);
  for (vtkIdType j = 0; j < columns; ++j)
  {
    auto* column = vtkDoubleArray::SafeDownCast(table->GetColumn(j));
    for (vtkIdType i = 0; i < rows; ++i)
    {
      matrix->SetTypedComponent(i, static_cast<int>(j), column->GetValue(i));
    }
  }
  return matrix;
}

//------------------------------------------------------------------------------
bool vtkGeodesicDistanceMatrix::GetUsedInputGraph() const
{
  return this->Internals->Provider.IsFromInput();
}

//------------------------------------------------------------------------------
double vtkGeodesicDistanceMatrix::GetGraphAccuracy() const
{
  const vtkDGGGraphProvider& provider = this->Internals->Provider;
  return provider.HasGraph() ? provider.GetGraph().Info.Accuracy : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceMatrix::GetNumberOfGraphEdges() const
{
  const vtkDGGGraphProvider& provider = this->Internals->Provider;
  return provider.HasGraph() ? provider.GetGraph().GetNumberOfEdges() : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGeodesicDistanceMatrix::GetGraphBuildTime() const
{
  return this->Internals->Provider.GetBuildTime();
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceMatrix::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::CheckProperties() const
{
  if (!(this->ProjectionTolerance >= 0.0))
  {
    std::ostringstream message;
    message << "ProjectionTolerance is " << this->ProjectionTolerance
            << ": it must not be negative or NaN";
    return dgg::Status::Invalid(message.str());
  }
  dgg::GraphOptions options;
  options.Accuracy = this->Accuracy;
  return dgg::GraphBuilder::Check(options);
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkGeodesicDistanceMatrix::GetRows(vtkInformationVector** inputVector) const
{
  return { this->RowIds, vtkPolyData::GetData(inputVector[1]), 1, "row", "call SetRowIds()", "" };
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkGeodesicDistanceMatrix::GetColumns(vtkInformationVector** inputVector) const
{
  return { this->ColumnIds, vtkPolyData::GetData(inputVector[2]), 2, "column",
    "call SetColumnIds()", "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  const vtkIdType n = surface->GetNumberOfPoints();
  const dgg::Status status = vtkDGGSourceCollector::Check(this->GetRows(inputVector), n);
  const vtkDGGSourceSet columns = this->GetColumns(inputVector);
  return status.IsOk() && !IsEmpty(columns) ? vtkDGGSourceCollector::Check(columns, n) : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::CheckMemory(std::size_t rows, std::size_t columns) const
{
  const double bytes = static_cast<double>(rows) * static_cast<double>(columns) * sizeof(double);
  const auto limit = static_cast<double>(vtkDGGGetMemoryLimit(this->MemoryLimit));
  if (bytes <= limit)
  {
    return dgg::Status::Success();
  }
  std::ostringstream message;
  message << "a table of " << rows << " rows and " << columns << " columns takes "
          << vtkDGGFormatBytes(bytes) << ", more than the limit of " << vtkDGGFormatBytes(limit)
          << ": ask for fewer points at a time, or set a higher MemoryLimit";
  return dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceMatrix::GetMemoryRemedy() const
{
  return "use a smaller mesh, a larger Accuracy or fewer points at a time";
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInternals& internals = *this->Internals;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  const vtkDGGSourceSet columnSet = this->GetColumns(inputVector);
  const bool symmetric = IsEmpty(columnSet);
  std::vector<dgg::GeodesicSource> sources;
  std::vector<dgg::GeodesicSource> others;
  dgg::Status status = internals.Collector.Collect(
    this->GetRows(inputVector), this->ProjectionTolerance, mesh, surface->GetPoints(), sources);
  if (status.IsOk() && !symmetric)
  {
    status = internals.Collector.Collect(
      columnSet, this->ProjectionTolerance, mesh, surface->GetPoints(), others);
  }
  const std::vector<dgg::SurfacePoint> rows = ToPoints(sources);
  const std::vector<dgg::SurfacePoint> columns = symmetric ? rows : ToPoints(others);
  if (status.IsOk())
  {
    status = this->CheckMemory(rows.size(), columns.size());
  }
  if (status.IsOk() && !this->Advance(0.0))
  {
    status = dgg::Status::Abort();
  }
  if (status.IsOk())
  {
    status = internals.Provider.Update({ surface, mesh, this->Accuracy, this->IsAccuracyExplicit,
      this->MemoryLimit, [this](double fraction) { return this->Advance(fraction); }, this });
  }
  if (!status.IsOk())
  {
    return status;
  }

  vtkTable* output = vtkTable::GetData(outputVector);
  output->Initialize();
  // Search from the smaller set.
  const bool sourcesAreRows = rows.size() <= columns.size();
  const vtkDGGMatrixEntries entries{ AddColumns(output, rows.size(), columns.size()),
    sourcesAreRows };
  status = vtkDGGMatrixSearch(internals.Provider, mesh, sourcesAreRows ? rows : columns,
    sourcesAreRows ? columns : rows, entries)
             .Run(symmetric, internals.Provider.GetRemainingProgress());
  for (double* column : entries.Columns)
  {
    std::replace(column, column + rows.size(), dgg::Infinity, this->UnreachedValue);
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::MakeEmptyOutput(
  vtkPolyData* vtkNotUsed(surface), vtkInformationVector* outputVector)
{
  vtkTable::GetData(outputVector)->Initialize();
}
