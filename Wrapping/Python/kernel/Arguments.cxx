// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Arrays.h"
#include "Errors.h"

#include "dggPropertyChecks.h"

#include <limits>

namespace dggPython
{
namespace
{
[[noreturn]] void Refuse(const char* name, const char* expected, const py::object& got)
{
  PyErr_Clear();
  throw py::value_error(
    std::string(name) + ": expected " + expected + ", got " + py::cast<std::string>(py::repr(got)));
}
}

//------------------------------------------------------------------------------
py::object Arguments::Take(const char* name)
{
  this->Known.insert(name);
  py::object given =
    this->Given.contains(name) ? py::object(this->Given[name]) : py::object(py::none());
  return given.is_none() ? py::object() : given;
}

//------------------------------------------------------------------------------
void Arguments::Read(const char* name, bool& value)
{
  if (const py::object given = this->Take(name))
  {
    // NumPy has a type of its own, numpy.bool_ or numpy.bool.
    const bool isFlag = PyBool_Check(given.ptr()) ||
      std::string(Py_TYPE(given.ptr())->tp_name).rfind("numpy.bool", 0) == 0;
    if (!isFlag)
    {
      Refuse(name, "a bool", given);
    }
    value = PyObject_IsTrue(given.ptr()) == 1;
  }
}

//------------------------------------------------------------------------------
void Arguments::Read(const char* name, dgg::Offset& value)
{
  if (const py::object given = this->Take(name))
  {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    const dgg::Offset integer = number ? PyLong_AsLongLong(number.ptr()) : -1;
    if (PyErr_Occurred())
    {
      Refuse(name, "an integer", given);
    }
    value = integer;
  }
}

//------------------------------------------------------------------------------
void Arguments::Read(const char* name, std::int32_t& value)
{
  dgg::Offset wide = value;
  this->Read(name, wide);
  if (wide < std::numeric_limits<std::int32_t>::min() ||
    wide > std::numeric_limits<std::int32_t>::max())
  {
    Refuse(name, "an integer of 32 bits", this->Take(name));
  }
  value = static_cast<std::int32_t>(wide);
}

//------------------------------------------------------------------------------
void Arguments::Read(const char* name, double& value)
{
  if (const py::object given = this->Take(name))
  {
    const double number = PyFloat_AsDouble(given.ptr());
    if (PyErr_Occurred())
    {
      Refuse(name, "a number", given);
    }
    value = number;
  }
}

//------------------------------------------------------------------------------
void Arguments::Read(const char* name, std::string& value)
{
  if (const py::object given = this->Take(name))
  {
    if (!py::isinstance<py::str>(given))
    {
      Refuse(name, "a str", given);
    }
    value = py::cast<std::string>(given);
  }
}

//------------------------------------------------------------------------------
void Arguments::Read(const char* name, std::vector<double>& values)
{
  if (const py::object given = this->Take(name))
  {
    const Array<double> array = ToNumbers(given, name);
    values.assign(array.data(), array.data() + array.size());
  }
}

//------------------------------------------------------------------------------
void Arguments::ReadLength(const char* name, double& value)
{
  this->Read(name, value);
  ThrowUnlessOk(dgg::CheckLengths({ { GetPropertyName(name), value } }));
}

//------------------------------------------------------------------------------
void Arguments::Finish() const
{
  for (const auto& item : this->Given)
  {
    const auto name = py::cast<std::string>(item.first);
    if (this->Known.count(name) == 0)
    {
      throw py::type_error("There is no argument `" + name + "`");
    }
  }
}
}
