// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGGraphicsKeeper.h"

#include "vtkDGGMemory.h"

#include "dggProgressPart.h"

#include <cmath>

namespace
{
/// Parts of the preparation: when curves are joined and the surface is refined.
constexpr double JoinedAt = 0.15;
constexpr double EmbeddedAt = 0.22;
constexpr double RefinedAt = 0.3;

dgg::Status NameCurve(const dgg::Status& status, const dgg::GraphicsCurve& curve)
{
  return status.IsOk() || status.IsAborted()
    ? status
    : dgg::Status::Invalid(curve.Name + ": " + status.GetMessage());
}

/// Whether there is memory for the faces of the surface, refined once they are, before any is
/// taken. Curves make some more.
dgg::Status CheckMesh(
  const dgg::SurfaceMesh& mesh, const vtkDGGDrawing& drawing, const std::string& remedy)
{
  double faces = 0.0;
  for (dgg::Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    faces += mesh.IsDropped(f) ? 0.0 : 1.0;
  }
  faces *= drawing.RefinedPart == dgg::RefinedPart::Everything
    ? std::pow(4.0, drawing.RefinementLevel)
    : 1.0;
  return vtkDGGCheckMemory(
    "the refined mesh", faces * dgg::VectorGraphics::BytesPerFace, drawing.MemoryLimit, remedy);
}
}

//------------------------------------------------------------------------------
bool vtkDGGGraphicsKeeper::IsUpToDate(const vtkDGGDrawing& drawing) const
{
  return this->IsKept && this->Kept.IsSame(drawing);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsKeeper::Prepare(const dgg::SurfaceMesh& mesh,
  const vtkDGGDrawing& drawing, const dgg::GraphicsOptions& options, const std::string& remedy,
  const std::function<bool(double)>& progress)
{
  this->IsKept = false;
  this->Graphics.Clear();
  this->RefinedFaces = std::vector<dgg::Id>();
  this->Kept = vtkDGGDrawing();
  const std::size_t count = drawing.Curves.size();
  dgg::Status status = CheckMesh(mesh, drawing, remedy);
  std::vector<dgg::SurfaceCurve> joined(count);
  for (std::size_t k = 0; k < count && status.IsOk(); ++k)
  {
    const double part = JoinedAt / static_cast<double>(count);
    const double begin = static_cast<double>(k) * part;
    status = NameCurve(dgg::JoinPoints(mesh, drawing.Places[k], drawing.Curves[k].IsClosed,
                         dgg::ProgressPart(progress, begin, begin + part), joined[k]),
      drawing.Curves[k]);
  }
  dgg::RefinedSurface refined;
  if (status.IsOk())
  {
    status =
      dgg::EmbedCurves(mesh, joined, dgg::ProgressPart(progress, JoinedAt, EmbeddedAt), refined);
  }
  if (!status.IsOk())
  {
    return status;
  }
  dgg::GraphicsRefinement refinement;
  refinement.Levels = drawing.RefinementLevel;
  refinement.Part = drawing.RefinedPart;
  refinement.Faces = drawing.RefinedFaces;
  refinement.MostFaces = static_cast<dgg::Offset>(
    std::min(static_cast<double>(vtkDGGGetMemoryLimit(drawing.MemoryLimit)) /
        dgg::VectorGraphics::BytesPerFace,
      static_cast<double>(refinement.MostFaces)));
  refinement.Progress = dgg::ProgressPart(progress, EmbeddedAt, RefinedAt);
  std::vector<dgg::Id> refinedFaces;
  status = dgg::RefineForGraphics(mesh, refinement, refined, &refinedFaces);
  if (!status.IsOk())
  {
    return status.IsAborted() ? status
                              : dgg::Status::Invalid(status.GetMessage() +
                                  ", for memory to suffice: raise MemoryLimit, or " + remedy);
  }
  std::vector<dgg::CurveChain> chains;
  for (std::size_t k = 0; k < count; ++k)
  {
    chains.push_back(dgg::FollowCurve(refined, joined, k));
  }
  dgg::GraphicsOptions own = options;
  own.Progress = dgg::ProgressPart(progress, RefinedAt, 1.0);
  status = this->Graphics.Prepare(mesh, refined, chains, drawing.Curves, own);
  if (status.IsOk())
  {
    ++this->NumberOfFactorizations;
    this->RefinedFaces = std::move(refinedFaces);
    this->Kept = drawing;
    for (dgg::GraphicsCurve& curve : this->Kept.Curves) // colours do not matter
    {
      curve.Left = std::vector<double>();
      curve.Right = std::vector<double>();
    }
  }
  else
  {
    this->Graphics.Clear();
  }
  this->IsKept = status.IsOk();
  return status;
}
