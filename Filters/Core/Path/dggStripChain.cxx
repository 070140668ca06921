// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStripChain.h"

namespace dgg
{
void StripChain::Append(const Strip& strip)
{
  if (!this->Strips.empty() && (this->IsJoining || !IsVertex(strip.Start)))
  {
    Strip& last = this->Strips.back();
    const Id from = last.LastFace();
    if (from == strip.FirstFace ||
      (IsVertex(strip.Start) &&
        AppendTurn(this->Mesh, strip.Start.Vertex, from, strip.FirstFace, last.Crossings)))
    {
      for (const EdgeCrossing& crossing : strip.Crossings)
      {
        AppendCrossing(last.Crossings, crossing);
      }
      last.End = strip.End;
      return;
    }
  }
  this->Strips.push_back(strip);
}

void StripChain::Append(const SurfacePath& path)
{
  for (std::size_t i = 0; i < path.Faces.size(); ++i)
  {
    this->AppendPiece(path.Points[i], path.Points[i + 1], path.Faces[i]);
  }
}

void StripChain::AppendPiece(const SurfacePoint& from, const SurfacePoint& to, Id face)
{
  Strip piece;
  piece.Start = from;
  piece.End = to;
  piece.FirstFace = face;
  if (!this->Strips.empty() && !IsVertex(from))
  {
    Strip& last = this->Strips.back();
    const Id exit = HalfEdgeUnder(this->Mesh, from, last.LastFace());
    const Id entry = HalfEdgeUnder(this->Mesh, from, face);
    if (exit != NoId && entry != NoId && exit != entry)
    {
      AppendCrossing(last.Crossings, { exit, entry });
    }
  }
  this->Append(piece);
}
}
