// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include "dggStatus.h"

#include <algorithm>

namespace dggPython
{
namespace
{
std::string Describe(const py::array& array)
{
  std::string shape;
  for (py::ssize_t i = 0; i < array.ndim(); ++i)
  {
    shape += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return "shape (" + shape + (array.ndim() == 1 ? ",)" : ")");
}

[[noreturn]] void Refuse(const char* name, const std::string& expected, const std::string& got)
{
  throw py::value_error(std::string(name) + ": expected " + expected + ", got " + got);
}

/// Returns any object as an array, whose type is one of `kinds` (numpy.dtype.kind) unless empty.
py::array ToArrayOf(
  const py::handle& object, const char* kinds, const char* expected, const char* name)
{
  py::array array = py::array::ensure(object);
  if (!array)
  {
    PyErr_Clear();
    Refuse(name, expected, py::cast<std::string>(py::str(py::type::handle_of(object))));
  }
  if (array.size() > 0 && std::string(kinds).find(array.dtype().kind()) == std::string::npos)
  {
    Refuse(name, expected, "the type " + py::cast<std::string>(py::str(array.dtype())));
  }
  return array;
}

template <typename Value>
Array<Value> Convert(
  const py::handle& object, const char* kinds, const char* expected, const char* name)
{
  const py::array array = ToArrayOf(object, kinds, expected, name);
  Array<Value> converted = Array<Value>::ensure(array);
  if (!converted)
  {
    throw py::error_already_set();
  }
  return converted;
}
}

//------------------------------------------------------------------------------
Array<double> ToNumbers(const py::handle& object, const char* name)
{
  return Convert<double>(object, "biuf", "an array of numbers", name);
}

//------------------------------------------------------------------------------
Array<dgg::Offset> ToIntegers(const py::handle& object, const char* name)
{
  return Convert<dgg::Offset>(object, "iu", "an array of integers", name);
}

//------------------------------------------------------------------------------
Array<double> ToTable(const py::handle& object, py::ssize_t columns, const char* name)
{
  Array<double> array = ToNumbers(object, name);
  const bool fits =
    columns == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (!fits && array.size() > 0)
  {
    Refuse(name, columns == 1 ? "the shape (n,)" : "the shape (n, " + std::to_string(columns) + ")",
      Describe(array));
  }
  return array;
}

//------------------------------------------------------------------------------
dgg::InputArray ToInputArray(const py::handle& object, const std::string& name)
{
  dgg::InputArray result;
  if (!object || object.is_none())
  {
    return result;
  }
  result.Name = name;
  const py::array array = ToArrayOf(object, "biufcSUOVmM", "an array", name.c_str());
  if (array.ndim() != 1 && array.ndim() != 2)
  {
    Refuse(name.c_str(), "the shape (n,) or (n, k)", Describe(array));
  }
  const char kind = array.dtype().kind();
  result.Type = py::cast<std::string>(py::str(array.dtype()));
  result.NumberOfTuples = array.shape(0);
  result.NumberOfComponents = array.ndim() == 1 ? 1 : static_cast<int>(array.shape(1));
  result.AreNumbers = std::string("biuf").find(kind) != std::string::npos;
  result.AreFloats = kind == 'f' && GetItemSize(array) == sizeof(float);
  result.AreBytes = kind == 'u' && GetItemSize(array) == 1;
  if (result.AreNumbers)
  {
    const Array<double> numbers = ToNumbers(array, name.c_str());
    result.Values.assign(numbers.data(), numbers.data() + numbers.size());
  }
  return result;
}

//------------------------------------------------------------------------------
py::ssize_t GetItemSize(const py::array& array)
{
  return py::cast<py::ssize_t>(array.attr("itemsize"));
}

//------------------------------------------------------------------------------
dgg::StoredArray ToStoredArray(const py::handle& object, py::ssize_t components)
{
  using dgg::StoredArray;
  StoredArray stored;
  if (!object || object.is_none())
  {
    return stored;
  }
  const auto array = py::cast<py::array>(object);
  const char kind = array.dtype().kind();
  const bool isWide = GetItemSize(array) == 8;
  const bool isFlat = (array.flags() & py::array::c_style) != 0 &&
    (components == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == components);
  const bool isKnown = isFlat && (isWide || GetItemSize(array) == 4);
  stored.Data = array.data();
  stored.Size = array.size();
  stored.Description = py::cast<std::string>(py::str(array.dtype())) + " with " + Describe(array);
  stored.Type = isKnown && kind == 'i' ? (isWide ? StoredArray::Int64 : StoredArray::Int32)
    : isKnown && kind == 'f'           ? (isWide ? StoredArray::Double : StoredArray::Float)
                                       : StoredArray::Other;
  return stored;
}

//------------------------------------------------------------------------------
Cells::Cells(const py::handle& object, const char* name)
{
  if (!object || object.is_none())
  {
    return;
  }
  if (py::isinstance<py::tuple>(object) && py::len(object) == 2)
  {
    const auto pair = py::reinterpret_borrow<py::tuple>(object);
    const Array<dgg::Offset> offsets = ToIntegers(pair[0], name);
    const Array<dgg::Offset> ids = ToIntegers(pair[1], name);
    this->Offsets.assign(offsets.data(), offsets.data() + offsets.size());
    this->Ids.assign(ids.data(), ids.data() + ids.size());
    const bool areValid = this->Offsets.empty()
      ? this->Ids.empty()
      : this->Offsets.front() == 0 && this->Offsets.back() == ids.size() &&
        std::is_sorted(this->Offsets.begin(), this->Offsets.end());
    if (!areValid)
    {
      Refuse(
        name, "offsets that ascend from 0 to the number of ids", "offsets that do not divide them");
    }
    return;
  }
  const Array<dgg::Offset> ids = ToIntegers(object, name);
  if (ids.ndim() != 2 && ids.size() > 0)
  {
    Refuse(name, "the shape (m, k) or a pair of offsets and point ids", Describe(ids));
  }
  this->Ids.assign(ids.data(), ids.data() + ids.size());
  if (ids.size() > 0)
  {
    this->SetOffsets(ids.shape(0), ids.shape(1));
  }
}

//------------------------------------------------------------------------------
Cells::Cells(const dgg::SurfaceMesh& mesh)
  : Ids(static_cast<std::size_t>(mesh.GetNumberOfHalfEdges()))
{
  this->SetOffsets(mesh.GetNumberOfFaces(), 3);
  for (dgg::Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const auto corners = mesh.GetTriangle(f);
    dgg::Offset* const ids = this->Ids.data() + 3 * static_cast<std::size_t>(f);
    std::copy(corners.begin(), corners.end(), ids);
    if (mesh.IsFlipped(f))
    {
      std::swap(ids[1], ids[2]);
    }
  }
}

//------------------------------------------------------------------------------
void Cells::SetOffsets(dgg::Offset count, dgg::Offset size)
{
  this->Offsets.resize(static_cast<std::size_t>(count) + 1);
  for (std::size_t i = 0; i < this->Offsets.size(); ++i)
  {
    this->Offsets[i] = static_cast<dgg::Offset>(i) * size;
  }
}

//------------------------------------------------------------------------------
dgg::CellArrays Cells::Get() const
{
  dgg::CellArrays cells;
  if (this->Offsets.size() > 1)
  {
    cells.NumberOfCells = static_cast<dgg::Offset>(this->Offsets.size()) - 1;
    cells.Offsets = this->Offsets.data();
    cells.Ids = this->Ids.data();
    cells.NumberOfIds = static_cast<dgg::Offset>(this->Ids.size());
  }
  return cells;
}

//------------------------------------------------------------------------------
py::array MakeReadOnly(py::array array)
{
  array.attr("flags").attr("writeable") = false;
  return array;
}
}
