// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGPieceField.h"

#include "DGGFieldInput.h"
#include "DGGFilterInternals.h"
#include "DGGSurfaceArrays.h"

#include "dggDistanceOutput.h"
#include "dggInputArray.h"
#include "dggPieceGraph.h"
#include "dggProcessGroup.h"
#include "dggStoredWindows.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace
{
/// Largest difference, in mean edges, between distances and the sums of offset and length of
/// virtual sources that vtkDGGDistance has found: a bound of rounding errors.
constexpr double LargestRounding = 1e-6;

/// Returns true if there are windows of the distances with a name, valid or not.
bool HasWindows(vtkFieldData* data, const std::string& name)
{
  bool has = false;
  for (int role = 0; role < dgg::StoredWindows::NumberOfRoles; ++role)
  {
    has = has || data->HasArray(dgg::StoredWindows::GetName(name, role).c_str());
  }
  return has;
}
}

//------------------------------------------------------------------------------
dgg::Status DGGPieceField::Update(const DGGContext& context, const DGGPieceUpdate& update,
  vtkInformation* filter, const Options& options, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  vtkPolyData* piece = context.Input;
  vtkPointData* data = piece->GetPointData();
  vtkDataArray* distances = nullptr;
  this->Reader.reset();
  DGG_RETURN_IF_ERROR(this->Prepare(update, isDone));
  if (isDone)
  {
    isDone = DGGFindDistances(filter, options.Distances, piece, distances).IsOk() ||
      piece->GetNumberOfPoints() == 0;
    this->Name =
      distances ? DGGGetDistanceName(distances) : DGGGetDistanceName(filter, options.Distances);
    isDone = isDone && (options.IsLinear || !HasWindows(piece->GetFieldData(), this->Name));
    DGG_RETURN_IF_ERROR(group.Require(isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  const std::string marks = dgg::GetUnreachedName(this->Name);
  this->MakeInput(piece);
  DGG_RETURN_IF_ERROR(this->AddArray(update, distances, this->Name, 1, true, isDone));
  if (std::isnan(options.UnreachedValue))
  {
    DGG_RETURN_IF_ERROR(
      this->AddArray(update, data->GetArray(marks.c_str()), marks, 1, false, isDone));
  }
  if (!options.IsLinear)
  {
    vtkDataArray* sources = data->GetArray(options.VirtualSources.c_str());
    DGG_RETURN_IF_ERROR(this->AddArray(update, sources, options.VirtualSources, 3, true, isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  this->Reader.emplace(this->Surface->Get());
  vtkPointData* added = this->Input->GetPointData();
  const dgg::Status status = DGGReadField(this->MakeContext(context),
    added->GetArray(this->Name.c_str()), options.UnreachedValue,
    options.IsLinear ? nullptr : options.VirtualSources.c_str(), {}, *this->Reader);
  isDone = status.IsOk() && (options.IsLinear || this->AreConsistent());
  return group.Require(isDone);
}

//------------------------------------------------------------------------------
dgg::DistanceField DGGPieceField::GetField() const
{
  dgg::DistanceField field = this->Reader->GetField();
  field.Layers = this->Surface->GetLayers().data();
  return field;
}

//------------------------------------------------------------------------------
DGGContext DGGPieceField::MakeContext(const DGGContext& context) const
{
  return { this->Surface->MakeContext(context), this->Input };
}

//------------------------------------------------------------------------------
/// Prepares the surface unless all pieces are those of the last update.
dgg::Status DGGPieceField::Prepare(const DGGPieceUpdate& update, bool& isDone)
{
  const dgg::Signature signature = dgg::ComputeSignature(update.Piece);
  bool isKept = this->IsKnown && signature == this->Piece;
  DGG_RETURN_IF_ERROR(update.Group.Require(isKept));
  if (!isKept)
  {
    this->IsKnown = false; // unless this update succeeds
    this->Surface = std::make_unique<dgg::PieceSurface>();
    DGG_RETURN_IF_ERROR(this->Surface->Prepare(update.Group, update.Piece, isDone));
    if (!isDone || this->Surface->HasLongTriangles())
    {
      this->Surface.reset();
    }
    this->Piece = signature;
    this->IsKnown = true;
  }
  isDone = this->Surface != nullptr;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Makes the input with the points of the surface.
void DGGPieceField::MakeInput(vtkPolyData* piece)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(piece->GetPoints() ? piece->GetPoints()->GetDataType() : VTK_DOUBLE);
  points->SetNumberOfPoints(this->Surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, this->Surface->GetPosition(i));
  }
  this->Input->Initialize();
  this->Input->SetPoints(points);
}

//------------------------------------------------------------------------------
/// Adds a point array of the piece to the input, with the values of the points of other pieces.
/// `isDone` becomes false on all processes if the array is required and missing on one with points,
/// or if only some of these have it.
dgg::Status DGGPieceField::AddArray(const DGGPieceUpdate& update, vtkDataArray* array,
  const std::string& name, int components, bool isRequired, bool& isDone)
{
  const bool isEmpty = update.Piece.NumberOfPoints == 0;
  bool isAnywhere = isEmpty || array;
  bool isNowhere = !array;
  DGG_RETURN_IF_ERROR(update.Group.Require(isAnywhere));
  DGG_RETURN_IF_ERROR(update.Group.Require(isNowhere));
  isDone = isDone && (isAnywhere || (isNowhere && !isRequired));
  dgg::InputArray read = DGGReadArray(array, name);
  bool fits = !array || read.Fits(update.Piece.NumberOfPoints, components);
  DGG_RETURN_IF_ERROR(update.Group.Require(fits));
  isDone = isDone && fits;
  if (!isDone || !isAnywhere)
  {
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->Surface->Extend(update.Group, components, read.Values));
  const auto extended = vtkSmartPointer<vtkDataArray>::Take(
    array ? array->NewInstance() : vtkDataArray::CreateDataArray(VTK_DOUBLE));
  extended->SetName(name.c_str());
  extended->SetNumberOfComponents(components);
  extended->SetNumberOfTuples(this->Surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < extended->GetNumberOfTuples(); ++i)
  {
    extended->SetTuple(i, read.Values.data() + components * i);
  }
  this->Input->GetPointData()->AddArray(extended);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Returns true if the virtual sources give the distances up to rounding, so that they do on the
/// entire surface.
bool DGGPieceField::AreConsistent() const
{
  const dgg::DistanceField& field = this->Reader->GetField();
  const vtkIdType n = this->Surface->GetNumberOfPoints();
  bool are = n == 0 || field.HasSources();
  for (vtkIdType i = 0; i < n && are; ++i)
  {
    const dgg::VirtualSource& source = (*field.Sources)[i];
    are = !(field.Distances[i] < dgg::Infinity) ||
      std::abs(source.Offset + source.Length - field.Distances[i]) <=
        LargestRounding * this->Surface->GetMeanEdgeLength();
  }
  return are;
}
