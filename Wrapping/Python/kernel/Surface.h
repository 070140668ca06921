// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A prepared surface or cloud as a Python object.
#ifndef Surface_h
#define Surface_h

#include "Arrays.h"      // for the cells
#include "SessionPool.h" // for data kept between calls

#include "dggPreparedSurface.h" // for PreparedSurface

#include <pybind11/pybind11.h>

#include <cstddef>   // for std::size_t
#include <memory>    // for pools
#include <mutex>     // for pools
#include <typeindex> // for kinds of pools
#include <unordered_map>

namespace dggPython
{
namespace py = pybind11;

/// A prepared surface with its cells, and factorizations and the like that calls reuse.
class Surface : public std::enable_shared_from_this<Surface>
{
public:
  Surface(const py::handle& points, const py::handle& cells, const py::kwargs& options);

  const dgg::PreparedSurface& Get() const { return *this->Prepared; }
  /// Returns the cells, without the points.
  const dgg::SurfaceArrays& GetCells() const;
  dgg::Offset GetNumberOfPoints() const { return this->Input.NumberOfPoints; }

  /// Returns the pool of the sessions of one kind. May be called by any thread.
  template <typename Session>
  SessionPool<Session>& GetPool() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::unique_ptr<AnySessionPool>& pool = this->Pools[typeid(Session)];
    if (!pool)
    {
      pool = std::make_unique<SessionPool<Session>>();
    }
    return static_cast<SessionPool<Session>&>(*pool);
  }
  /// Returns the number of sessions of all kinds that no call uses.
  std::size_t GetNumberOfSessions() const;
  /// Releases these sessions.
  void Release();

private:
  /// Cells of the input. A surface of triangles restores its polygons from the mesh on demand.
  mutable Cells Polygons;
  Cells Strips;
  mutable dgg::SurfaceArrays Input;
  mutable std::once_flag PolygonsOnce;
  dgg::PreparedSurface::Pointer Prepared;
  mutable std::mutex Mutex;
  mutable std::unordered_map<std::type_index, std::unique_ptr<AnySessionPool>> Pools;
};
}

#endif
