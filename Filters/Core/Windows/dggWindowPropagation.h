// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Common base of the exact engines: labels, sources, emission of windows by vertices, targets.
/// Internal.
#ifndef dggWindowPropagation_h
#define dggWindowPropagation_h

#include "dggEdges.h"          // for ForEachFaceBehind
#include "dggExactGeodesics.h" // for sources, options, results
#include "dggWindow.h"         // for Window
#include "dggWindowStore.h"    // for the windows to be kept

#include <array>   // for barycentric coordinates
#include <cstddef> // for std::size_t
#include <vector>  // for std::vector

namespace dgg
{
/// The state of one run and the steps that do not depend on the order of propagation. A derived
/// engine handles new windows and lowered labels, and runs its own main loop.
class WindowPropagation
{
public:
  explicit WindowPropagation(const SurfaceMesh& mesh);
  virtual ~WindowPropagation() = default;
  WindowPropagation(const WindowPropagation&) = delete;
  WindowPropagation& operator=(const WindowPropagation&) = delete;

  /// If `isAgain`, `result` must be the result of the previous run, unmodified: only entries that
  /// the previous run reached are reset.
  Status Run(const std::vector<GeodesicSource>& sources, const ExactOptions& options,
    ExactResult& result, bool isAgain);

protected:
  /// Called for a window that enters the face of half-edge h, in the frame of h.
  virtual void Receive(Id h, const Window& window) = 0;
  /// Called after the label of v has been lowered.
  virtual void LabelDropped(Id v) = 0;
  /// Propagates until no window within the radius remains. Returns false if aborted or out of
  /// memory.
  virtual bool Propagate() = 0;
  virtual void Reset() = 0;
  /// Resets after a completed run, given the vertices that the run reached.
  virtual void ResetReached(const std::vector<Id>& vertices) = 0;
  /// Releases the memory of a finished propagation.
  virtual void Release() = 0;

  double Label(Id v) const { return this->Result->Distances[v]; }
  Id SourceOf(Id root) const { return root >= 0 ? this->Result->NearestSource[root] : ~root; }
  bool IsSource(Id v) const { return this->Result->Predecessors[v].Root == v; }

  /// Lowers the label of v if `distance` is smaller; returns true if so. Every label is the length
  /// of an actual path.
  bool Lower(Id v, double distance, const Predecessor& predecessor, Id source);
  /// Relaxes the mesh edges around v, which covers windows that are too narrow to be stored.
  void RelaxNeighbors(Id v);

  /// Emits windows of the pseudo-source v into all its faces.
  void EmitEverywhere(Id v);
  /// Emits windows of the pseudo-source v into the directions that a shortest path may take: those
  /// at an angle of at least pi from the incoming direction on both sides.
  void EmitIntoShadow(Id v);

  /// Passes a window that leaves through half-edge `exit` to all faces behind the edge. The window
  /// is in the frame of a half-edge that runs opposite to `exit`.
  void Cross(Id exit, Window window)
  {
    window.HasScattered |= this->Scatters(exit);
    ForEachFaceBehind(this->Mesh, exit, false, [&](Id e, bool isMirrored) {
      this->Receive(e, isMirrored ? Mirrored(window, this->Mesh.Length(e)) : window);
    });
  }

  /// Returns true if windows scatter when they leave through the half-edge, so that the windows
  /// behind it must be remembered (WindowMemory): its face is degenerate, or its edge is
  /// non-manifold.
  bool Scatters(Id h) const
  {
    return this->Mesh.IsDegenerate(SurfaceMesh::Face(h)) || this->Mesh.IsNonManifold(h);
  }

  /// Computes the part of a window that leaves its face through the left edge (up to the apex if
  /// `isCut`) or through the right edge (from the apex if `isCut`).
  /// @{
  static void MakeLeftChild(
    const FaceUnfolding& face, const Window& window, bool isCut, Window& child)
  {
    child = window;
    child.Image = face.ImageInLeft(window.Image);
    const double depth = -child.Image.Y;
    child.SetInterval(face.OnLeft(window.Image, depth, window.Begin),
      isCut ? face.GetLeft() : face.OnLeft(window.Image, depth, window.End));
  }
  static void MakeRightChild(
    const FaceUnfolding& face, const Window& window, bool isCut, Window& child)
  {
    child = window;
    child.Image = face.ImageInRight(window.Image);
    const double depth = -child.Image.Y;
    child.SetInterval(isCut ? 0.0 : face.OnRight(window.Image, depth, window.Begin),
      face.OnRight(window.Image, depth, window.End));
  }
  /// @}

  static Window Mirrored(const Window& window, double length);

  /// Returns true if the root of the window has meanwhile been reached by a shorter path, so that
  /// the window is useless.
  bool IsStale(const Window& window) const
  {
    return window.Root >= 0 && window.Sigma > this->Label(window.Root) * (1.0 + LengthTolerance);
  }

  bool HasTargets(Id f) const { return !this->Targets.empty() && this->TargetFlags[f] != 0; }
  /// Updates the targets in the face of h that a window reaches.
  void OfferTargets(Id h, const Window& window);
  /// Returns the distance beyond which windows and labels are ignored. It shrinks as targets are
  /// reached.
  double GetRadius() const { return this->Radius; }
  void UpdateRadius();
  /// Updates the peak memory, given the bytes that the engine holds without stored windows. Returns
  /// false if the memory limit or the maximum number of propagated windows is exceeded.
  bool NoteMemory(std::size_t bytes)
  {
    return this->NoteAllMemory(
      bytes + this->Reached.capacity() * sizeof(Id) + this->Store.GetMemorySize());
  }

  const SurfaceMesh& Mesh;
  WindowStore Store;
  const ExactOptions* Options = nullptr;
  ExactResult* Result = nullptr;

private:
  struct Target
  {
    Id Face;
    std::size_t Index;
    std::array<double, 3> Barycentric;
  };

  void ResetResult(bool isLocal);
  void Start(const std::vector<GeodesicSource>& sources);
  void StartInFace(Id f, const std::array<double, 3>& barycentric, double offset, Id source);
  void RegisterTargets();
  void FinishTargets();
  bool FinishWindows(const std::vector<GeodesicSource>& sources, double shift);
  template <typename Function>
  void ForEachReached(Function&& visit) const;
  bool NoteAllMemory(std::size_t bytes);
  void ForgetBeyondRadius();
  /// Emits the window of pseudo-source v onto the edge opposite to it in the face of its outgoing
  /// half-edge g, between the directions `from` and `to`, angles measured from g.
  void EmitInto(Id g, double sigma, double from, double to);
  bool FindIncomingAngle(Id v, double& angle) const;
  void ReachTarget(std::size_t index, double distance, const Predecessor& predecessor, Id source);

  double Radius = Infinity;
  std::size_t MostWindows;
  bool IsOutOfMemory = false;
  bool HasExceededLimit = false;
  bool NotesReached = false;             // true if Reached is filled in this run
  bool KnowsReached = false;             // true if Reached belongs to the last, completed run
  std::vector<Id> Reached;               // vertices with a label
  std::vector<Target> Targets;           // sorted by face; without targets at vertices
  std::vector<std::uint8_t> TargetFlags; // per face
};
}

#endif
