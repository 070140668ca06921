// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGNewGeometry.h"

#include "vtkDGGGraphArrays.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGPointCoordinates.h"
#include "vtkDGGWindowArrays.h"

#include "dggSurfacePath.h"

#include "vtkAlgorithm.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
/// Type of points for one of vtkAlgorithm::DesiredOutputPrecision.
int ChooseDataType(int precision, vtkPoints* input)
{
  switch (precision)
  {
    case vtkAlgorithm::SINGLE_PRECISION:
      return VTK_FLOAT;
    case vtkAlgorithm::DOUBLE_PRECISION:
      return VTK_DOUBLE;
    default:
      // Not that of the input for points that are integers: new ones are not.
      return input && input->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
  }
}

/// Whether floats can tell the positions: they are neither infinite then, nor all but zero.
dgg::Status CheckRange(const std::vector<double>& positions)
{
  double largest = 0.0;
  for (const double x : positions)
  {
    largest = std::max(largest, std::abs(x));
  }
  if (largest == 0.0 ||
    (largest >= std::numeric_limits<float>::min() && largest <= std::numeric_limits<float>::max()))
  {
    return dgg::Status::Success();
  }
  std::ostringstream message;
  message << "OutputPointsPrecision is single, but coordinates of up to " << largest
          << " are out of the range of floats: call SetOutputPointsPrecision() with "
             "DOUBLE_PRECISION";
  return dgg::Status::Invalid(message.str());
}
}

//------------------------------------------------------------------------------
vtkDGGNewGeometry::vtkDGGNewGeometry()
  : DataType(VTK_DOUBLE)
{
}

//------------------------------------------------------------------------------
vtkDGGNewGeometry::~vtkDGGNewGeometry() = default;

//------------------------------------------------------------------------------
dgg::Status vtkDGGNewGeometry::Take(
  vtkPolyData* surface, const vtkDGGMeshAdapter& mesh, int precision)
{
  vtkPoints* points = surface->GetPoints();
  this->Fields->Initialize();
  this->Fields->PassData(surface->GetFieldData());
  // The graph and the windows are those of other points.
  vtkDGGGraphArrays::RemoveFrom(this->Fields);
  vtkDGGWindowArrays::RemoveAllFrom(this->Fields);
  this->DataType = ChooseDataType(precision, points);
  this->Mesh = &mesh;
  const std::size_t size = 3 * static_cast<std::size_t>(surface->GetNumberOfPoints());
  if (this->MeshTime != mesh.GetBuildTime() || this->Positions.size() != size)
  {
    const vtkDGGPointCoordinates coordinates(points);
    this->Positions.assign(coordinates.GetData(), coordinates.GetData() + size);
    this->MeshTime = mesh.GetBuildTime();
  }
  return precision == vtkAlgorithm::SINGLE_PRECISION ? CheckRange(this->Positions)
                                                     : dgg::Status::Success();
}

//------------------------------------------------------------------------------
const dgg::SurfaceMesh& vtkDGGNewGeometry::GetMesh() const
{
  return this->Mesh->GetMesh();
}

//------------------------------------------------------------------------------
void vtkDGGNewGeometry::Begin(vtkPolyData* output) const
{
  output->Initialize();
  output->GetFieldData()->PassData(this->Fields);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkDGGNewGeometry::MakePoints(std::size_t size) const
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(this->DataType);
  points->SetNumberOfPoints(static_cast<vtkIdType>(size));
  return points;
}

//------------------------------------------------------------------------------
void vtkDGGNewGeometry::SetPoint(
  vtkPoints* points, vtkIdType i, const dgg::SurfacePoint& place) const
{
  points->SetPoint(i, dgg::PositionOf(this->GetMesh(), place, this->GetPositions()).data());
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGNewGeometry::GetPointId(const dgg::SurfacePoint& place)
{
  return dgg::IsVertex(place) ? place.Vertex : -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGNewGeometry::GetCell(dgg::Id face) const
{
  return face == dgg::NoId ? -1 : this->Mesh->GetCell(face);
}
