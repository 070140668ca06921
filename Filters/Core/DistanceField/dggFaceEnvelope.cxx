// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceEnvelope.h"

#include "dggSurfacePoint.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Tolerance of visibility through a window: a point this close to the border of a window is
/// visible through the window. Relative (dggWindow.h).
constexpr double WindowSlack = 1e-9;

/// Relative deficit below which a model is exact.
constexpr double Rounding = 1e-13;

/// Indices of the first candidate of models, after the paths through three corners, and of the
/// first lower bound.
constexpr Id FirstImageCandidate = 3;
constexpr Id LeastCandidate = 9;

double LargestOf(const std::array<double, 3>& values)
{
  return std::max({ std::abs(values[0]), std::abs(values[1]), std::abs(values[2]) });
}

/// Returns the field of one source at point p.
FieldSample FromSource(const Point2& image, double offset, const Point2& p)
{
  FieldSample sample;
  const Point2 way{ p.X - image.X, p.Y - image.Y };
  const double length = Norm(way.X, way.Y);
  sample.Distance = offset + length;
  if (length > 0.0)
  {
    sample.Gradient = { way.X / length, way.Y / length };
  }
  sample.Image = image;
  sample.Offset = offset;
  sample.HasImage = true;
  return sample;
}

/// Returns a distance raised by the deficits at the corners, in proportion to barycentric
/// coordinates.
double Raised(
  double distance, const std::array<double, 3>& missing, const std::array<double, 3>& barycentric)
{
  for (int j = 0; j < 3; ++j)
  {
    distance += missing[j] * barycentric[j];
  }
  return distance;
}
}

void FaceEnvelope::Enter(Id f)
{
  if (f == this->Face)
  {
    return;
  }
  this->Face = f;
  const SurfaceMesh& mesh = *this->Field.Mesh;
  this->Corners = CornersInFrame(mesh, 3 * f);
  for (int k = 0; k < 3; ++k)
  {
    const Point2& from = this->Corners[k];
    const Point2& to = this->Corners[(k + 1) % 3];
    const double length = mesh.Length(3 * f + k);
    this->Axes[k] = { (to.X - from.X) / length, (to.Y - from.Y) / length };
    this->Distances[k] = this->Field.Distances[mesh.Origin(3 * f + k)];
    // The barycentric coordinate of the corner opposite to the edge increases across the edge.
    const double height = mesh.ApexY(3 * f + k);
    this->Rises[(k + 2) % 3] = { -this->Axes[k].Y / height, this->Axes[k].X / height };
  }
  this->Windows.clear();
  this->Sources.clear();
  this->HasModels = false;
  if (this->Field.HasWindows())
  {
    this->CollectWindows();
    this->CollectSources();
  }
  else if (this->Field.HasSources())
  {
    this->SetUpModels();
  }
}

Point2 FaceEnvelope::PlaceOf(const std::array<double, 3>& barycentric) const
{
  Point2 p;
  for (int k = 0; k < 3; ++k)
  {
    p.X += barycentric[k] * this->Corners[k].X;
    p.Y += barycentric[k] * this->Corners[k].Y;
  }
  return p;
}

std::array<double, 3> FaceEnvelope::BarycentricOf(const Point2& p) const
{
  std::array<double, 3> b{};
  for (int k = 0; k < 3; ++k)
  {
    const Point2& opposite = this->Corners[(k + 1) % 3]; // the barycentric coordinate is 0 there
    b[k] = Dot({ p.X - opposite.X, p.Y - opposite.Y }, this->Rises[k]);
  }
  return b;
}

Point2 FaceEnvelope::InFrameOf(int k, const Point2& p) const
{
  const Point2 way{ p.X - this->Corners[k].X, p.Y - this->Corners[k].Y };
  return { Dot(this->Axes[k], way), Cross(this->Axes[k], way) };
}

/// Returns the source of a vertex, or of ~k for source k; NoId if sources are not known.
Id FaceEnvelope::SourceOf(Id root) const
{
  const Id* const sources = this->Field.NearestSource;
  return !sources ? NoId : root < 0 ? ~root : sources[root];
}

void FaceEnvelope::CollectWindows()
{
  const EdgeWindows& windows = *this->Field.Windows;
  for (int k = 0; k < 3; ++k)
  {
    this->FirstWindows[k] = this->Windows.size();
    const Id h = 3 * this->Face + k;
    for (const EdgeWindow* w = windows.Begin(h); w != windows.End(h); ++w)
    {
      const double slack = WindowSlack * std::min(this->Field.Mesh->Length(h), -w->Image.Y);
      this->Windows.push_back({ w->Begin - slack, w->End + slack, w->Image,
        FromFrame(this->Corners[k], this->Axes[k], w->Image), w->Offset, this->SourceOf(w->Root) });
    }
  }
  this->FirstWindows[3] = this->Windows.size();
}

void FaceEnvelope::CollectSources()
{
  const std::vector<FaceSource>& sources = this->Field.Windows->Sources;
  auto source = std::lower_bound(sources.begin(), sources.end(), this->Face,
    [](const FaceSource& s, Id face) { return s.Face < face; });
  for (; source != sources.end() && source->Face == this->Face; ++source)
  {
    const Point2 place = this->PlaceOf(source->Barycentric);
    this->Sources.push_back(FromSource(place, source->Offset, place));
    this->Sources.back().Source = this->SourceOf(source->Root);
  }
}

void FaceEnvelope::SetUpModels()
{
  const SurfaceMesh& mesh = *this->Field.Mesh;
  const VirtualSources& sources = *this->Field.Sources;
  for (int k = 0; k < 3; ++k)
  {
    const Id v = mesh.Origin(3 * this->Face + k);
    this->Models[k] = CornerModel(mesh, v, sources[v], this->Distances[k]);
    this->HasModels = this->HasModels || this->Models[k].IsKnown;
  }
  this->Negligible =
    Rounding * (LargestOf(this->Distances) + Norm(this->Corners[2].X, this->Corners[2].Y));
  for (int k = 0; k < 3; ++k)
  {
    this->Missing[k] = { { 0.0, 0.0, 0.0 } };
    for (int j = 0; j < 3; ++j)
    {
      // Paths through corners have deficits in fields that are not distances.
      const double missing =
        this->Distances[j] - this->Distances[k] - Distance(this->Corners[j], this->Corners[k]);
      this->MissingOver[k][j] = missing > this->Negligible ? missing : 0.0;
    }
    this->Seen[k].Count = 0;
    this->IsRaised[k] = false;
    if (!this->Models[k].IsKnown)
    {
      continue;
    }
    // Measured on CAD models and scans: excluding models with large deficits, or replacing them by
    // linear faces, increases errors.
    this->FindSources(k);
    for (const int j : { (k + 1) % 3, (k + 2) % 3 })
    {
      int nearest = -1;
      const double length = this->DistanceToSource(k, this->Corners[j], nearest);
      const double missing = this->Distances[j] -
        (nearest < 0 ? this->Distances[k] + Distance(this->Corners[j], this->Corners[k])
                     : this->Models[k].Offset + length);
      this->Missing[k][j] = missing > this->Negligible ? missing : 0.0;
      this->IsRaised[k] = this->IsRaised[k] || this->Missing[k][j] > 0.0;
    }
  }
  double raise = 0.0;
  double excess = 0.0; // largest excess of differences between corners over their distance
  for (int k = 0; k < 3; ++k)
  {
    raise = std::max(raise, LargestOf(this->Missing[k]));
    excess = std::max(excess, LargestOf(this->MissingOver[k]));
  }
  this->HasLowerBounds = raise > this->Negligible;
  for (int k = 0; k < 3; ++k)
  {
    this->LowerBounds[k] = this->Distances[k] - excess;
  }
}

/// Finds the images of the source of corner k that are less than pi away from some direction into
/// the face. Angles are measured on the side of the corner with the smaller angle
/// (CornerModel::AngleFrom()).
void FaceEnvelope::FindSources(int k)
{
  const CornerModel& model = this->Models[k];
  const Id h = 3 * this->Face + k;
  const double corner = this->Field.Mesh->CornerAngle(h);
  const double reach = model.IsOpen ? Pi : std::min(Pi, 0.5 * model.Total);
  double angle = model.Angle - this->Field.Mesh->PolarAngle(h);
  if (!model.IsOpen)
  {
    angle -=
      model.Total * std::floor((angle + reach) / model.Total); // the first one from -reach on
  }
  SeenSources& seen = this->Seen[k];
  const int most = !model.IsOpen ? 2 : angle >= -reach ? 1 : 0;
  while (seen.Count < most && angle <= corner + reach)
  {
    const Point2 image{ model.Length * std::cos(angle), model.Length * std::sin(angle) };
    const double side = angle > Pi ? -1.0 : angle < corner - Pi ? 1.0 : 0.0;
    seen.Sources[seen.Count++] = { FromFrame(this->Corners[k], this->Axes[k], image), side };
    angle += model.Total;
  }
}

/// Returns the straight distance to the source of corner k, and the nearest image; `nearest` is
/// unchanged if the source lies behind the corner.
double FaceEnvelope::DistanceToSource(int k, const Point2& p, int& nearest) const
{
  const Point2& corner = this->Corners[k];
  double least = Infinity;
  for (int i = 0; i < this->Seen[k].Count; ++i)
  {
    const SeenSource& source = this->Seen[k].Sources[i];
    if (source.Side * Cross(Difference(source.Image, corner), Difference(p, corner)) < 0.0)
    {
      continue;
    }
    const double distance = Distance(source.Image, p);
    if (distance < least)
    {
      least = distance;
      nearest = i;
    }
  }
  return least;
}

bool FaceEnvelope::MayHaveSeveralSources() const
{
  const std::array<Id, 3> corners = this->Field.Mesh->GetTriangle(this->Face);
  const Id first = this->SourceOf(corners[0]);
  const auto isOther = [&](const auto& seen) { return seen.Source != first; };
  return first != this->SourceOf(corners[1]) || first != this->SourceOf(corners[2]) ||
    std::any_of(this->Windows.begin(), this->Windows.end(), isOther) ||
    std::any_of(this->Sources.begin(), this->Sources.end(), isOther);
}

double FaceEnvelope::GetLargestRaise() const
{
  double raise = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    raise = std::max({ raise, LargestOf(this->Missing[k]), LargestOf(this->MissingOver[k]) });
  }
  return raise;
}

bool FaceEnvelope::MayHavePeak() const
{
  std::vector<Point2> images;
  for (const SeenWindow& window : this->Windows)
  {
    images.push_back(window.Place);
  }
  for (const FieldSample& source : this->Sources)
  {
    images.push_back(source.Image);
  }
  for (int k = 0; k < 3; ++k)
  {
    for (int i = 0; this->HasModels && i < this->Seen[k].Count; ++i)
    {
      images.push_back(this->Seen[k].Sources[i].Image);
    }
    if (this->Distances[k] <= std::min(this->Distances[(k + 1) % 3], this->Distances[(k + 2) % 3]))
    {
      images.push_back(this->Corners[k]);
    }
  }
  // A maximum lies in the convex hull of the images around it, hence not beyond a side of the face
  // if all images do.
  std::array<double, 3> largest{ { 0.0, 0.0, 0.0 } };
  for (const Point2& image : images)
  {
    const std::array<double, 3> b = this->BarycentricOf(image);
    for (int k = 0; k < 3; ++k)
    {
      largest[k] = std::max(largest[k], b[k]);
    }
  }
  return std::min({ largest[0], largest[1], largest[2] }) > 0.0;
}

FieldSample FaceEnvelope::SampleAt(const Point2& p) const
{
  if (this->Field.HasWindows())
  {
    return this->FromWindows(p);
  }
  if (!this->HasModels)
  {
    return this->Linear(p);
  }
  const std::array<double, 3> b = this->BarycentricOf(p);
  return this->SampleOf(this->FindNearest(p, b).Candidate, p, b);
}

/// Returns the field of the path through a corner.
FieldSample FaceEnvelope::FromCorner(int k, const Point2& p) const
{
  FieldSample sample = FromSource(this->Corners[k], this->Distances[k], p);
  sample.Candidate = k;
  sample.Source = this->SourceOf(this->Field.Mesh->Origin(3 * this->Face + k));
  return sample;
}

FieldSample FaceEnvelope::FromWindows(const Point2& p) const
{
  FieldSample best;
  for (int k = 0; k < 3; ++k)
  {
    const FieldSample sample = this->FromCorner(k, p);
    if (sample.Distance < best.Distance)
    {
      best = sample;
    }
  }
  for (std::size_t s = 0; s < this->Sources.size(); ++s)
  {
    const FieldSample& source = this->Sources[s];
    if (source.Offset + Distance(source.Image, p) < best.Distance)
    {
      best = FromSource(source.Image, source.Offset, p);
      best.Candidate = static_cast<Id>(3 + s);
      best.Source = source.Source;
    }
  }
  const SeenWindow* found = nullptr;
  for (int k = 0; k < 3; ++k)
  {
    const Point2 here = this->InFrameOf(k, p);
    for (std::size_t w = this->FirstWindows[k]; w < this->FirstWindows[k + 1]; ++w)
    {
      const SeenWindow& window = this->Windows[w];
      const double x = Crossing(window.Image, here);
      if (!(x >= window.Begin && x <= window.End))
      {
        continue;
      }
      const double distance = window.Offset + Distance(window.Image, here);
      if (distance < best.Distance)
      {
        best.Distance = distance;
        found = &window;
      }
    }
  }
  if (found)
  {
    best = FromSource(found->Place, found->Offset, p);
    best.Candidate = static_cast<Id>(3 + this->Sources.size() + (found - this->Windows.data()));
    best.Source = found->Source;
  }
  return best;
}

/// Returns the smaller of the raised model of a corner and the raised path through the corner
/// (dggDistanceField.h).
FaceEnvelope::Wave FaceEnvelope::FromModel(
  int k, const Point2& p, const std::array<double, 3>& barycentric) const
{
  Wave wave;
  int nearest = -1;
  const double length = this->DistanceToSource(k, p, nearest);
  if (nearest >= 0)
  {
    wave.Distance = this->Models[k].Offset + length;
    wave.Candidate = FirstImageCandidate + 2 * k + nearest;
    if (!this->IsRaised[k])
    {
      return wave; // already the path through the corner
    }
    wave.Distance = Raised(wave.Distance, this->Missing[k], barycentric);
  }
  // Behind the corner, the path through the corner is the only path from the source. Its deficit
  // must not end abruptly at the border of this region.
  const double over =
    Raised(this->Distances[k] + Distance(p, this->Corners[k]), this->MissingOver[k], barycentric);
  if (over < wave.Distance)
  {
    wave.Distance = over;
    wave.Candidate = k;
  }
  return wave;
}

/// Returns the field of one candidate of the models; undefined for NoId.
FieldSample FaceEnvelope::SampleOf(
  Id candidate, const Point2& p, const std::array<double, 3>& b) const
{
  if (candidate == NoId)
  {
    return FieldSample();
  }
  if (candidate >= LeastCandidate)
  {
    return this->FromLowerBound(candidate - LeastCandidate, p);
  }
  const bool isOverCorner = candidate < FirstImageCandidate;
  const int k = isOverCorner ? candidate : (candidate - FirstImageCandidate) / 2;
  FieldSample sample = isOverCorner
    ? FromSource(this->Corners[k], this->Distances[k], p)
    : FromSource(this->Seen[k].Sources[(candidate - FirstImageCandidate) % 2].Image,
        this->Models[k].Offset, p);
  const std::array<double, 3>& missing = isOverCorner ? this->MissingOver[k] : this->Missing[k];
  sample.Distance = Raised(sample.Distance, missing, b);
  for (int j = 0; j < 3; ++j)
  {
    sample.Gradient.X += missing[j] * this->Rises[j].X;
    sample.Gradient.Y += missing[j] * this->Rises[j].Y;
    sample.HasImage = sample.HasImage && missing[j] <= this->Negligible;
  }
  sample.Candidate = candidate;
  return sample;
}

FaceEnvelope::Wave FaceEnvelope::FindNearest(
  const Point2& p, const std::array<double, 3>& barycentric) const
{
  Wave best;
  for (int k = 0; k < 3; ++k)
  {
    const Wave wave = this->FromModel(k, p, barycentric);
    if (wave.Distance < best.Distance)
    {
      best = wave;
    }
  }
  double bound = best.Distance + this->Negligible; // not at corners, where the value is given
  for (int k = 0; k < 3 && this->HasLowerBounds; ++k)
  {
    const double atCorner = this->LowerBounds[k] - Distance(p, this->Corners[k]);
    if (atCorner > bound)
    {
      bound = best.Distance = atCorner;
      best.Candidate = LeastCandidate + k;
    }
  }
  return best;
}

double FaceEnvelope::At(const Point2& p) const
{
  return this->HasModels ? this->FindNearest(p, this->BarycentricOf(p)).Distance
                         : this->SampleAt(p).Distance;
}

FieldSample FaceEnvelope::FromLowerBound(int k, const Point2& p) const
{
  const Point2 way = Difference(this->Corners[k], p);
  const double length = Norm(way.X, way.Y);
  FieldSample sample;
  sample.Distance = this->LowerBounds[k] - length;
  sample.Gradient = { way.X / length, way.Y / length };
  sample.Candidate = LeastCandidate + k;
  return sample;
}

FieldSample FaceEnvelope::SampleOfCandidate(const FieldSample& sample, const Point2& p) const
{
  return sample.HasImage ? FromSource(sample.Image, sample.Offset, p)
                         : this->SampleOf(sample.Candidate, p, this->BarycentricOf(p));
}

FieldSample FaceEnvelope::Linear(const Point2& p) const
{
  const std::array<double, 3> b = this->BarycentricOf(p);
  FieldSample sample;
  sample.Distance = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sample.Distance += b[k] * this->Distances[k];
    sample.Gradient.X += this->Distances[k] * this->Rises[k].X;
    sample.Gradient.Y += this->Distances[k] * this->Rises[k].Y;
  }
  sample.Candidate = 0;
  return sample;
}
}
