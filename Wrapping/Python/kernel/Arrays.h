// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// NumPy arrays as inputs and outputs of the kernel.
#ifndef Arrays_h
#define Arrays_h

#include "dggBuffer.h"          // for Buffer
#include "dggInputArray.h"      // for InputArray
#include "dggPreparedSurface.h" // for CellArrays
#include "dggStoredArray.h"     // for StoredArray

#include <pybind11/numpy.h>

#include <cstdlib> // for std::free
#include <memory>  // for owners
#include <string>  // for messages
#include <utility> // for std::move
#include <vector>  // for copies

namespace dggPython
{
namespace py = pybind11;

/// A contiguous array, which may be read-only.
template <typename Value>
using Array = py::array_t<Value, py::array::c_style | py::array::forcecast>;

///@{
/// Return an object as a contiguous array of numbers or of integers: the array itself if its type
/// and its layout allow, otherwise a converted copy. `name` is the argument in messages.
Array<double> ToNumbers(const py::handle& object, const char* name);
Array<dgg::Offset> ToIntegers(const py::handle& object, const char* name);
///@}

/// Returns an object as an array of shape (n, `columns`), or (n,) if there is one column. An empty
/// array may have any shape.
Array<double> ToTable(const py::handle& object, py::ssize_t columns, const char* name);

/// Returns a copy of an array of shape (n,) or (n, k) for the kernel; an array without a name if
/// the object is None.
dgg::InputArray ToInputArray(const py::handle& object, const std::string& name);

/// Returns the number of bytes of a value. array::itemsize() of pybind11 before 2.12 reads a wrong
/// field with NumPy 2.
py::ssize_t GetItemSize(const py::array& array);

/// Returns the array of a stored graph or of stored windows, whose rows have `components` values.
dgg::StoredArray ToStoredArray(const py::handle& object, py::ssize_t components = 1);

/// Cells for the kernel, from an integer array of shape (m, k), a pair (offsets, ids), or None.
class Cells
{
public:
  Cells() = default;
  Cells(const py::handle& object, const char* name);
  /// Constructs the triangles of a mesh, with the corners of the input.
  explicit Cells(const dgg::SurfaceMesh& mesh);

  dgg::CellArrays Get() const;

private:
  void SetOffsets(dgg::Offset count, dgg::Offset size);

  std::vector<dgg::Offset> Offsets;
  std::vector<dgg::Offset> Ids;
};

/// Returns an array that owns the memory of `values`, with rows of `components` values.
template <typename Value>
py::array ToArray(dgg::Buffer<Value> values, std::size_t components = 1)
{
  std::vector<py::ssize_t> shape{ static_cast<py::ssize_t>(values.Size() / components) };
  if (components != 1)
  {
    shape.push_back(static_cast<py::ssize_t>(components));
  }
  if (values.IsEmpty())
  {
    return py::array_t<Value>(shape);
  }
  Value* const first = values.Data();
  const py::capsule owner(first, [](void* memory) { std::free(memory); });
  values.Release();
  return py::array_t<Value>(shape, first, owner);
}

/// Returns an array that shares the memory of `values`.
template <typename Value>
py::array ToArray(std::vector<Value> values, std::size_t components = 1)
{
  auto kept = std::make_unique<std::vector<Value>>(std::move(values));
  std::vector<py::ssize_t> shape{ static_cast<py::ssize_t>(kept->size() / components) };
  if (components != 1)
  {
    shape.push_back(static_cast<py::ssize_t>(components));
  }
  const Value* const first = kept->data();
  const py::capsule owner(
    kept.get(), [](void* vector) { delete static_cast<std::vector<Value>*>(vector); });
  kept.release();
  return py::array_t<Value>(shape, first, owner);
}

/// Returns the same array, which can no longer be changed.
py::array MakeReadOnly(py::array array);
}

#endif
