// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLaplaceSystem.h"

#include "dggCotanLaplacian.h"
#include "dggProgressPart.h"

namespace dgg
{
namespace
{
/// Parts of the progress.
constexpr double FlipsDone = 0.4;
constexpr double MatrixDone = 0.5;
constexpr double OrderDone = 0.9;
}

Status LaplaceSystem::Build(
  bool isDelaunay, double largestCotangent, const ProgressCallback& progress)
{
  if (!Goes(progress, 0.0))
  {
    return Status::Abort();
  }
  this->Triangulation = IntrinsicTriangulation(this->Mesh);
  DelaunayReport report;
  const Status status = isDelaunay
    ? MakeDelaunay(this->Triangulation, -1, ProgressPart(progress, 0.0, FlipsDone), report)
    : Status::Success();
  if (!status.IsOk() || !Goes(progress, FlipsDone))
  {
    return status.IsOk() ? Status::Abort() : status;
  }
  CotanLaplacian laplacian = MakeCotanLaplacian(this->Triangulation, largestCotangent);
  this->Stiffness.swap(laplacian.Stiffness);
  this->Areas.assign(laplacian.Mass.data(), laplacian.Mass.data() + laplacian.Mass.size());
  this->Components = this->Mesh.ComputeComponents(this->NumberOfComponents);
  this->OnBoundary.assign(this->Components.size(), 0);
  for (Id h = 0; h < this->Triangulation.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Triangulation.Twin(h) == NoId)
    {
      this->OnBoundary[this->Triangulation.Origin(h)] = 1;
      this->OnBoundary[this->Triangulation.Destination(h)] = 1;
    }
  }
  if (!Goes(progress, MatrixDone))
  {
    return Status::Abort();
  }
  this->Order = EliminationOrder(this->Stiffness);
  this->Pinned = this->Order.FindLast(this->Components, this->NumberOfComponents);
  return Goes(progress, OrderDone) ? Status::Success() : Status::Abort();
}
}
