// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceMatrix.h"

#include "DGGGraphUser.h"
#include "DGGMakeArray.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggMatrixSearch.h"
#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <string>
#include <utility>

vtkStandardNewMacro(vtkGeodesicDistanceMatrix);
vtkDGGDefineInputMacro(vtkGeodesicDistanceMatrix, Row, 1);
vtkDGGDefineInputMacro(vtkGeodesicDistanceMatrix, Column, 2);

namespace
{
/// Tables store columns separately and search them by name, which is slow for many columns.
constexpr std::size_t MaximumNumberOfTableColumns = 10000;

/// Takes over the memory of a matrix.
vtkSmartPointer<vtkDoubleArray> MakeMatrix(
  dgg::Buffer<double> values = dgg::Buffer<double>(), std::size_t columns = 1)
{
  return DGGAdoptArray<vtkDoubleArray>(values, "GeodesicDistance", static_cast<int>(columns));
}

using Columns = std::vector<vtkSmartPointer<vtkDoubleArray>>;

Columns MakeColumns(std::size_t rows, std::size_t columns)
{
  Columns arrays;
  for (std::size_t j = 0; j < columns; ++j)
  {
    auto values = dgg::MakeUnreached(rows); // throws bad_alloc, where VTK may abort
    arrays.push_back(DGGAdoptArray<vtkDoubleArray>(values, nullptr));
  }
  return arrays;
}

/// Copies a matrix to the columns of a table, which are named by their indices.
void FillTable(
  vtkDoubleArray* matrix, const Columns& columns, const dgg::ParallelFor& parallel, vtkTable* table)
{
  std::vector<double*> values;
  for (const auto& column : columns)
  {
    values.push_back(column->GetPointer(0));
  }
  dgg::CopyColumns(
    matrix->GetPointer(0), static_cast<std::size_t>(matrix->GetNumberOfTuples()), values, parallel);
  table->GetRowData()->AllocateArrays(static_cast<int>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
  {
    // Named afterwards, since a named array is compared with all existing columns.
    table->AddColumn(columns[j]);
    columns[j]->SetName(std::to_string(j).c_str());
  }
}
}

//------------------------------------------------------------------------------
class vtkGeodesicDistanceMatrix::vtkInternals
  : public DGGGraphInternalsOf<vtkGeodesicDistanceMatrix>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Matrix = MakeMatrix(); }
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or fewer points at a time";
  }

  vtkSmartPointer<vtkDoubleArray> Matrix = MakeMatrix(); // never null

private:
  DGGSourceSet GetRows(vtkInformationVector** inputVector) const;
  DGGSourceSet GetColumns(vtkInformationVector** inputVector) const;
  bool WantsTable(std::size_t columns) const;
  dgg::Status FillCompressedRows(
    const DGGContext& context, const std::vector<dgg::GeodesicSource>& rows, vtkTable* output);
};

vtkDGGInternalsMacro(vtkGeodesicDistanceMatrix);
vtkDGGGraphUserMacro(vtkGeodesicDistanceMatrix);

//------------------------------------------------------------------------------
vtkGeodesicDistanceMatrix::vtkGeodesicDistanceMatrix()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfRowIds: " << this->RowIds.size() << "\n";
  os << indent << "NumberOfColumnIds: " << this->ColumnIds.size() << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "GenerateTable: " << (this->GenerateTable ? "On" : "Off") << "\n";
  os << indent << "CompressedRows: " << (this->CompressedRows ? "On" : "Off") << "\n";
  os << indent << "Correction: " << (this->Correction ? "On" : "Off") << "\n";
  os << indent << "Matrix: " << this->GetInternals().Matrix->GetNumberOfTuples() << " x "
     << this->GetInternals().Matrix->GetNumberOfComponents() << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
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
  return this->GetInternals().Matrix;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceMatrix::ReleaseMatrix()
{
  this->GetInternals().Matrix = MakeMatrix();
  if (vtkDataObject* output = this->GetOutputDataObject(0))
  {
    output->ReleaseData(); // the pipeline must consider the output out of date
  }
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceMatrix::FillOutputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(
    dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance },
      { "MaximumDistance", this->Self->MaximumDistance } }));
  return DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicDistanceMatrix::vtkInternals::GetRows(
  vtkInformationVector** inputVector) const
{
  return { this->Self->RowIds, vtkPolyData::GetData(inputVector[1]), 1, "row", "RowIds", "" };
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicDistanceMatrix::vtkInternals::GetColumns(
  vtkInformationVector** inputVector) const
{
  return { this->Self->ColumnIds, vtkPolyData::GetData(inputVector[2]), 2, "column", "ColumnIds",
    "" };
}

//------------------------------------------------------------------------------
bool vtkGeodesicDistanceMatrix::vtkInternals::WantsTable(std::size_t columns) const
{
  if (this->Self->GenerateTable && columns > MaximumNumberOfTableColumns)
  {
    this->Warn(dgg::JoinText("The table would have ", columns, " columns, more than ",
      MaximumNumberOfTableColumns,
      ", so the output is empty. Use GetMatrix(), and turn off {GenerateTable}"));
    return false;
  }
  return this->Self->GenerateTable;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const DGGSourceSet columnSet = this->GetColumns(inputVector);
  const bool symmetric = columnSet.Ids.empty() && !columnSet.Points;
  if (this->Self->CompressedRows && !symmetric)
  {
    return dgg::InvalidInput("{CompressedRows} is on, but columns are chosen")
      .At("CompressedRows")
      .Fix("Remove the columns, or turn off {CompressedRows}");
  }
  std::vector<dgg::GeodesicSource> sources;
  DGG_RETURN_IF_ERROR(DGGLocate(
    context, this->GetRows(inputVector), this->Self->ProjectionTolerance, sources, this->Self));
  if (this->Self->CompressedRows)
  {
    return this->FillCompressedRows(context, sources, vtkTable::GetData(outputVector));
  }

  const std::vector<dgg::SurfacePoint> rows = dgg::GetPoints(sources);
  std::vector<dgg::SurfacePoint> columns;
  if (!symmetric)
  {
    DGG_RETURN_IF_ERROR(
      DGGLocate(context, columnSet, this->Self->ProjectionTolerance, columns, this->Self));
  }
  const std::size_t numberOfColumns = symmetric ? rows.size() : columns.size();
  const bool withTable = this->WantsTable(numberOfColumns);
  // Allocated before the graph, because the graph may use all memory that remains free.
  dgg::Buffer<double> values;
  DGG_RETURN_IF_ERROR(
    dgg::AllocateMatrix(context.Memory, rows.size(), numberOfColumns, withTable, false, values));
  const Columns table = MakeColumns(withTable ? rows.size() : 0, withTable ? numberOfColumns : 0);

  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  DGG_RETURN_IF_ERROR(
    dgg::FindMatrix(context, this->GraphUser, rows, symmetric ? nullptr : &columns,
      this->Self->MaximumDistance, this->Self->UnreachedValue, values.Data()));
  const auto matrix = MakeMatrix(std::move(values), numberOfColumns);
  vtkTable* output = vtkTable::GetData(outputVector);
  output->Initialize();
  FillTable(matrix, table, context.Parallel, output);
  this->Matrix = matrix;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceMatrix::vtkInternals::FillCompressedRows(
  const DGGContext& context, const std::vector<dgg::GeodesicSource>& rows, vtkTable* output)
{
  const double radius =
    this->Self->MaximumDistance < VTK_DOUBLE_MAX ? this->Self->MaximumDistance : dgg::Infinity;
  dgg::DistanceRows found;
  DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  DGG_RETURN_IF_ERROR(
    dgg::FindDistanceRows(context, this->GraphUser, rows, radius, this->Self->Correction, found));
  output->Initialize();
  output->AddColumn(DGGAdoptArray<vtkIntArray>(found.Columns, "Column"));
  output->AddColumn(DGGAdoptArray<vtkDoubleArray>(found.Distances, "GeodesicDistance"));
  output->GetFieldData()->AddArray(DGGAdoptArray<vtkTypeInt64Array>(found.Offsets, "RowOffsets"));
  return dgg::Status::Success();
}
