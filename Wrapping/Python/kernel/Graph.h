// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A discrete geodesic graph as a Python object.
#ifndef Graph_h
#define Graph_h

#include "SessionPool.h" // for data kept between calls
#include "Surface.h"     // for the surface

#include "dggGraphSession.h" // for the sessions

#include <pybind11/pybind11.h>

#include <cstddef> // for std::size_t
#include <memory>  // for the surface
#include <string>  // for warnings
#include <vector>  // for radii and warnings

namespace dggPython
{
namespace py = pybind11;

class Call;

/// A graph of a surface or a cloud: its arrays, and the sessions of the calls that search it. Any
/// number of threads may search simultaneously.
class Graph
{
public:
  /// A session in use, which is ready to search.
  class Session : public SessionPool<dgg::GraphSession>::Loan
  {
  public:
    explicit Session(const Graph& graph)
      : SessionPool<dgg::GraphSession>::Loan(graph.Sessions)
    {
      (*this)->Start(graph.Owner->Get());
      if (!(*this)->HasGraph())
      {
        (*this)->Use(graph.Prepared);
      }
    }
  };

  /// Takes the arrays of a graph that the call has just built.
  static std::shared_ptr<Graph> Adopt(Call& call, const std::shared_ptr<Surface>& surface,
    dgg::GeodesicGraph& graph, const std::vector<double>& radii = {}, double voxelSize = 0.0);
  /// Reads stored arrays. Writable arrays are copied, because callers could change them.
  static std::shared_ptr<Graph> Read(
    Call& call, const std::shared_ptr<Surface>& surface, const py::dict& arrays);
  /// Reads the argument `stored`, or builds a graph if there is none that can be used.
  static std::shared_ptr<Graph> ReadOrBuild(
    const std::shared_ptr<Surface>& surface, const py::kwargs& keywords);

  const Surface& GetSurface() const { return *this->Owner; }
  const py::dict& GetArrays() const { return this->Arrays; }
  ///@{
  /// Return findings of ReadOrBuild(): true if the graph was read, warnings, and the defect of
  /// damaged arrays.
  bool IsStored() const { return this->Stored; }
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  const std::string& GetDamage() const { return this->Damage; }
  ///@}
  const dgg::GraphSummary& GetSummary() const { return this->Prepared->GetSummary(); }
  /// Destroys the sessions that no call uses.
  void Release() { this->Sessions.Clear(); }
  /// Returns the number of bytes of these sessions, without the graph.
  std::size_t GetSearchMemorySize() const
  {
    return this->Sessions.Sum([this](const dgg::GraphSession& session) {
      return session.GetMemorySize() - this->GetSummary().MemorySize;
    });
  }

private:
  /// Takes a graph with its arrays.
  static std::shared_ptr<Graph> Adopt(Call& call, const std::shared_ptr<Surface>& surface,
    const dgg::StoredGraph& graph, const py::dict& arrays);

  std::shared_ptr<Surface> Owner;
  py::dict Arrays;
  bool Stored = false;
  std::vector<std::string> Warnings;
  std::string Damage;
  dgg::PreparedGraph::Pointer Prepared;
  mutable SessionPool<dgg::GraphSession> Sessions;
};

/// A surface, and the graph of it if there is one, as the first argument of a function.
struct SurfaceOrGraph
{
  SurfaceOrGraph(const py::handle& object);

  const Surface& GetSurface() const { return *this->Owner; }
  /// Returns the graph; throws an error without one, which `what` needs.
  const Graph& GetGraph(const char* what) const;

private:
  std::shared_ptr<const Surface> Owner;
  std::shared_ptr<const Graph> OptionalGraph;
};
}

#endif
