// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowCells.h"

#include "dggBorderCurves.h"
#include "dggFaceCells.h"
#include "dggFaceEnvelope.h"
#include "dggPathEdges.h"
#include "dggProgressPart.h"
#include "dggRidges.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <map>

namespace dgg
{
namespace
{
/// Progress after the borders are traced, and after the mesh is cut.
constexpr double BordersDone = 0.7;
constexpr double CutDone = 0.9;
constexpr Id ProgressInterval = 1024; // faces between two reports

using Coordinates = std::array<double, 3>;

/// Makes the diagram of a mesh that is cut along the borders.
class CellMaker
{
public:
  CellMaker(const DistanceField& field, const SubMesh& surface, VoronoiDiagram& diagram)
    : Field(field)
    , Surface(surface)
    , Diagram(diagram)
    , Envelope(field)
    , Borders(surface, surface.Paths)
  {
  }

  Status Run(const ProgressCallback& progress);

private:
  void SetUpPoints();
  void Cut(Id face, const std::vector<Id>& pieces);
  void FindPlaces(Id face, const std::vector<Id>& pieces);
  std::vector<Id> CollectCell(Id piece);
  Id FindSite(const std::vector<Id>& cell) const;
  void AddCell(Id face, Id site, const std::vector<Id>& cell);
  std::vector<Id> FindOutline(const std::vector<Id>& cell) const;

  FaceCell MakeCell(Id site, const std::vector<Id>& points) const
  {
    FaceCell cell{ site, {} };
    for (const Id point : points)
    {
      cell.Points.push_back({ point, this->Places.at(point) });
    }
    return cell;
  }
  FaceCell MakePiece(Id site, Id piece) const
  {
    const Id* const corners = this->Surface.Triangles.data() + 3 * piece;
    return this->MakeCell(site, { corners, corners + 3 });
  }

  const DistanceField& Field;
  const SubMesh& Surface;
  VoronoiDiagram& Diagram;
  FaceEnvelope Envelope;
  const PathEdges Borders;
  std::vector<Id> CellOf;           // per face of the surface, a face of its cell
  std::map<Id, Coordinates> Places; // vertices of the pieces of a face
};

Status CellMaker::Run(const ProgressCallback& progress)
{
  this->SetUpPoints();
  this->CellOf.assign(this->Surface.GetNumberOfFaces(), NoId);
  std::vector<std::vector<Id>> pieces(this->Field.Mesh->GetNumberOfFaces());
  for (Id piece = 0; piece < this->Surface.GetNumberOfFaces(); ++piece)
  {
    pieces[this->Surface.Faces[piece]].push_back(piece);
  }
  this->Diagram.PolygonOffsets.push_back(0);
  const Id count = this->Field.Mesh->GetNumberOfFaces();
  for (Id face = 0; face < count; ++face)
  {
    if (face % ProgressInterval == 0)
    {
      DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(face) / count));
    }
    if (!pieces[face].empty())
    {
      this->Cut(face, pieces[face]);
    }
  }
  AddBorderCurves(nullptr, this->Diagram);
  return ReportTo(progress, 1.0);
}

void CellMaker::SetUpPoints()
{
  const Id count = this->Field.Mesh->GetNumberOfVertices();
  this->Diagram.NearestSites.assign(this->Field.NearestSource, this->Field.NearestSource + count);
  this->Diagram.Distances.assign(this->Field.Distances, this->Field.Distances + count);
  this->Diagram.BorderPoints.assign(
    this->Surface.Points.begin() + count, this->Surface.Points.end());
  this->Diagram.BorderDistances.assign(this->Diagram.BorderPoints.size(), Infinity);
}

/// Adds the cells of one face.
void CellMaker::Cut(Id face, const std::vector<Id>& pieces)
{
  const bool isReached = this->Field.IsReached(face);
  if (isReached)
  {
    this->Envelope.Enter(face);
  }
  this->FindPlaces(face, pieces);
  for (const Id piece : pieces)
  {
    if (this->CellOf[piece] == NoId)
    {
      const std::vector<Id> cell = this->CollectCell(piece);
      this->AddCell(face, isReached ? this->FindSite(cell) : NoId, cell);
    }
  }
}

/// Finds the positions of points in a face, and the distances of border points. On an edge, the
/// smallest of all faces is the distance.
void CellMaker::FindPlaces(Id face, const std::vector<Id>& pieces)
{
  this->Places.clear();
  for (const Id piece : pieces)
  {
    for (Id h = 3 * piece; h < 3 * piece + 3; ++h)
    {
      const Id vertex = this->Surface.Origin(h);
      const auto [place, isNew] = this->Places.emplace(vertex, Coordinates());
      if (!isNew)
      {
        continue;
      }
      FindInFace(*this->Field.Mesh, this->Surface.Points[vertex], face, place->second);
      const Id border = vertex - this->Field.Mesh->GetNumberOfVertices();
      if (border >= 0 && this->Field.IsReached(face))
      {
        double& distance = this->Diagram.BorderDistances[border];
        distance = std::min(distance, this->Envelope.At(this->Envelope.PlaceOf(place->second)));
      }
    }
  }
}

/// Returns the pieces of a face that no border separates from the given one.
std::vector<Id> CellMaker::CollectCell(Id piece)
{
  std::vector<Id> cell{ piece };
  this->CellOf[piece] = piece;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    for (Id h = 3 * cell[i]; h < 3 * cell[i] + 3; ++h)
    {
      const Id twin = this->Surface.Twin(h);
      const Id next = twin == NoId ? NoId : SurfaceMesh::Face(twin);
      const bool isSame = next != NoId && this->CellOf[next] == NoId &&
        this->Surface.Faces[next] == this->Surface.Faces[piece] && !this->Borders.IsOnPath(h);
      if (isSame)
      {
        this->CellOf[next] = piece;
        cell.push_back(next);
      }
    }
  }
  return cell;
}

/// Returns the nearest site of the center of the largest piece.
Id CellMaker::FindSite(const std::vector<Id>& cell) const
{
  const Id largest = *std::max_element(cell.begin(), cell.end(), [&](Id a, Id b) {
    return this->MakePiece(NoId, a).GetFraction() < this->MakePiece(NoId, b).GetFraction();
  });
  Coordinates center{};
  for (const CellPoint& corner : this->MakePiece(NoId, largest).Points)
  {
    for (int k = 0; k < 3; ++k)
    {
      center[k] += corner.Place[k] / 3.0;
    }
  }
  return this->Envelope.SampleAt(this->Envelope.PlaceOf(center)).Source;
}

/// Adds a cell as one polygon or, if it surrounds another one, as triangles.
void CellMaker::AddCell(Id face, Id site, const std::vector<Id>& cell)
{
  const std::vector<Id> outline = this->FindOutline(cell);
  if (!outline.empty())
  {
    this->MakeCell(site, outline).AddTo(*this->Field.Mesh, face, this->Diagram);
    return;
  }
  for (const Id piece : cell)
  {
    this->MakePiece(site, piece).AddTo(*this->Field.Mesh, face, this->Diagram);
  }
}

/// Returns the vertices around a cell; empty if its boundary is not a simple polygon.
std::vector<Id> CellMaker::FindOutline(const std::vector<Id>& cell) const
{
  std::map<Id, Id> next; // along the boundary
  for (const Id piece : cell)
  {
    for (Id h = 3 * piece; h < 3 * piece + 3; ++h)
    {
      const Id twin = this->Surface.Twin(h);
      const bool isInside =
        twin != NoId && this->CellOf[SurfaceMesh::Face(twin)] == this->CellOf[piece];
      if (!isInside && !next.emplace(this->Surface.Origin(h), this->Surface.Destination(h)).second)
      {
        return {};
      }
    }
  }
  std::vector<Id> outline{ next.begin()->first };
  for (Id v = next.begin()->second; v != outline.front(); v = next.at(v))
  {
    outline.push_back(v);
  }
  return outline.size() == next.size() ? outline : std::vector<Id>();
}

}

Status ComputeWindowCells(const DistanceField& field, double tolerance, const ParallelFor& parallel,
  const ProgressCallback& progress, VoronoiDiagram& diagram)
{
  diagram = VoronoiDiagram();
  RidgeOptions options;
  options.ChordTolerance = tolerance;
  options.BetweenSources = true;
  Ridges borders;
  DGG_RETURN_IF_ERROR(
    FindRidges(field, options, parallel, ProgressPart(progress, 0.0, BordersDone), borders));
  RefinementOptions refinement;
  refinement.InsertCrossings = true; // borders may cross by rounding
  refinement.Progress = ProgressPart(progress, BordersDone, CutDone);
  SubMesh surface;
  DGG_RETURN_IF_ERROR(RefineAlongPaths(*field.Mesh, borders.Lines, refinement, surface));
  return CellMaker(field, surface, diagram).Run(ProgressPart(progress, CutDone, 1.0));
}
}
