// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What all exact engines share: labels, sources, emission of windows by vertices, targets.
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
/// The state of one run and the steps that do not depend on the order of propagation. An engine
/// derives from it, says what happens to a new window and a lower label, and runs its own loop.
class WindowPropagation
{
public:
  explicit WindowPropagation(const SurfaceMesh& mesh);
  virtual ~WindowPropagation() = default;
  WindowPropagation(const WindowPropagation&) = delete;
  WindowPropagation& operator=(const WindowPropagation&) = delete;

  /// When it `isAgain`, `result` is always the same one, which nobody else changes: only what the
  /// last run has reached is reset.
  Status Run(const std::vector<GeodesicSource>& sources, const ExactOptions& options,
    ExactResult& result, bool isAgain);

protected:
  /// A window is about to enter the face of half-edge h, in its frame.
  virtual void Receive(Id h, const Window& window) = 0;
  /// The label of v has become smaller.
  virtual void LabelDropped(Id v) = 0;
  /// Propagate until nothing is left within the radius; false when aborted or out of memory.
  virtual bool Propagate() = 0;
  virtual void Reset() = 0;
  /// The same after a run that was finished, given the vertices that it has reached.
  virtual void ResetReached(const std::vector<Id>& vertices) = 0;
  /// Give back the memory of a finished propagation.
  virtual void Release() = 0;

  double Label(Id v) const { return this->Result->Distances[v]; }
  Id SourceOf(Id root) const { return root >= 0 ? this->Result->NearestSource[root] : ~root; }
  bool IsSource(Id v) const { return this->Result->Predecessors[v].Root == v; }

  /// Lower the label of v if `distance` is smaller. Every label is the length of a real path.
  bool Lower(Id v, double distance, const Predecessor& predecessor, Id source);
  /// Offer to the neighbours of v the way along their mesh edge: the safety net for windows too
  /// narrow to be kept (and a real path).
  void RelaxNeighbours(Id v);

  /// Windows of the pseudo-source v into all its faces.
  void EmitEverywhere(Id v);
  /// Windows of the pseudo-source v into the directions that a shortest path may take: those that
  /// make an angle of at least pi with the incoming one on both sides.
  void EmitIntoShadow(Id v);

  /// Passes a window that leaves through half-edge `exit` to all faces behind the edge. The frame
  /// of the window is that of a half-edge that runs against `exit`.
  void Cross(Id exit, Window window)
  {
    window.HasScattered |= this->Scatters(exit);
    ForEachFaceBehind(this->Mesh, exit, false, [&](Id e, bool isMirrored) {
      this->Receive(e, isMirrored ? Mirrored(window, this->Mesh.Length(e)) : window);
    });
  }

  /// Whether windows that leave through the half-edge have scattered, and what enters has to be
  /// remembered (WindowMemory): its face has no area, or its edge more than two faces.
  bool Scatters(Id h) const
  {
    return this->Mesh.IsDegenerate(SurfaceMesh::Face(h)) || this->Mesh.IsNonManifold(h);
  }

  /// The part of a window that leaves its face through the left edge, up to the apex if that
  /// `isCut`; and through the right edge, from the apex on.
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

  /// A window whose root has been reached on a shorter way is of no use any more.
  bool IsStale(const Window& window) const
  {
    return window.Root >= 0 && window.Sigma > this->Label(window.Root) * (1.0 + LengthTolerance);
  }

  bool HasTargets(Id f) const { return !this->Targets.empty() && this->TargetFlags[f] != 0; }
  /// Let a window that enters the face of h reach the targets inside it.
  void OfferTargets(Id h, const Window& window);
  /// Windows and labels beyond this are of no interest. Shrinks as targets are reached.
  double GetRadius() const { return this->Radius; }
  void UpdateRadius();
  /// Take note of the bytes that the engine holds, the windows that are kept apart. False when they
  /// are too many together, or the windows propagated are.
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

  void ResetResult(bool isPart);
  void Start(const std::vector<GeodesicSource>& sources);
  void StartInFace(Id f, const std::array<double, 3>& barycentric, double offset, Id source);
  void RegisterTargets();
  void FinishTargets();
  bool FinishWindows(const std::vector<GeodesicSource>& sources, double shift);
  template <typename Function>
  void ForEachReached(Function&& visit) const;
  bool NoteAllMemory(std::size_t bytes);
  void ForgetBeyondRadius();
  /// Window of pseudo-source v onto the edge opposite to it in the face of its outgoing half-edge
  /// g, between the directions `from` and `to`, angles measured from g.
  void EmitInto(Id g, double sigma, double from, double to);
  bool FindIncomingAngle(Id v, double& angle) const;
  void ReachTarget(std::size_t index, double distance, const Predecessor& predecessor, Id source);

  double Radius = Infinity;
  std::size_t MostWindows;
  bool IsOutOfMemory = false;
  bool HasExceededLimit = false;
  bool NotesReached = false;   // in Reached
  bool KnowsReached = false;   // those of the last run, which was finished, are in Reached
  std::vector<Id> Reached;     // vertices that have got a label
  std::vector<Target> Targets; // sorted by face; those at vertices are not in it
  std::vector<std::uint8_t> TargetFlags; // per face
};
}

#endif
