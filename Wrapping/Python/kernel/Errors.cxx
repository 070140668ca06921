// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include <cctype>

namespace dggPython
{
namespace
{
/// The class `Error`, which the module keeps alive.
PyObject* ErrorType = nullptr;

constexpr const char* ErrorDocumentation =
  R"(An error that the kernel reports.

Attributes
----------
message : str
    Problem and action as sentences, in terms of arguments.
problem, action : str
    What is wrong, and what to do; without final periods.
parameter : str or None
    Argument or array at fault.
index : int or None
    Id or index of the offending element.
code : str
    "InvalidInput", "NotConnected", "DamagedGraph" or "OutOfMemory".)";

const char* GetCodeName(dgg::Status::Code code)
{
  switch (code)
  {
    case dgg::Status::Code::InvalidInput:
      return "InvalidInput";
    case dgg::Status::Code::NotConnected:
      return "NotConnected";
    case dgg::Status::Code::DamagedGraph:
      return "DamagedGraph";
    case dgg::Status::Code::OutOfMemory:
      return "OutOfMemory";
    case dgg::Status::Code::Aborted:
      return "Aborted";
    case dgg::Status::Code::Ok:
      break;
  }
  return "Ok";
}

/// Sets the Python error.
void SetError(const dgg::Status& status)
{
  const std::string message = RenderMessage(status.GetMessage());
  py::object error = py::reinterpret_borrow<py::object>(ErrorType)(message);
  error.attr("message") = message;
  error.attr("problem") = RenderMessage(status.GetProblem());
  error.attr("action") = RenderMessage(status.GetAction());
  error.attr("parameter") = status.GetParameter().empty()
    ? py::object(py::none())
    : py::object(py::str(GetArgumentName(status.GetParameter())));
  error.attr("index") =
    status.GetIndex() < 0 ? py::object(py::none()) : py::object(py::int_(status.GetIndex()));
  error.attr("code") = GetCodeName(status.GetCode());
  PyErr_SetObject(ErrorType, error.ptr());
}
}

//------------------------------------------------------------------------------
void ThrowUnlessOk(const dgg::Status& status)
{
  if (!status.IsOk())
  {
    throw StatusError(status);
  }
}

//------------------------------------------------------------------------------
std::string GetArgumentName(const std::string& property)
{
  std::string name;
  for (const unsigned char c : property)
  {
    const bool isCapital = std::isupper(c) != 0;
    name += isCapital && !name.empty() ? "_" : "";
    name += static_cast<char>(std::tolower(c));
  }
  return name;
}

//------------------------------------------------------------------------------
std::string GetPropertyName(const std::string& argument)
{
  std::string name;
  bool isStart = true;
  for (const unsigned char c : argument)
  {
    name += c == '_' ? "" : std::string(1, static_cast<char>(isStart ? std::toupper(c) : c));
    isStart = c == '_';
  }
  return name;
}

//------------------------------------------------------------------------------
std::string RenderMessage(const std::string& message)
{
  return dgg::Render(message, [](const std::string& property) {
    return property == "InArrays" ? "in `arrays`" : "`" + GetArgumentName(property) + "`";
  });
}

//------------------------------------------------------------------------------
py::list RenderWarnings(const std::vector<std::string>& warnings)
{
  py::list texts;
  for (const std::string& warning : warnings)
  {
    texts.append(RenderMessage(warning) + ".");
  }
  return texts;
}

//------------------------------------------------------------------------------
void AddErrors(py::module_& module)
{
  const std::string name = py::cast<std::string>(module.attr("__name__")) + ".Error";
  ErrorType =
    PyErr_NewExceptionWithDoc(name.c_str(), ErrorDocumentation, PyExc_RuntimeError, nullptr);
  if (!ErrorType)
  {
    throw py::error_already_set();
  }
  module.add_object("Error", py::reinterpret_borrow<py::object>(ErrorType));
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try
    {
      std::rethrow_exception(thrown);
    }
    catch (const StatusError& error)
    {
      SetError(error.GetReason());
    }
  });
}
}
