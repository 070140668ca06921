// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Errors and warnings of the kernel in terms of Python.
#ifndef Errors_h
#define Errors_h

#include "dggStatus.h" // for Status

#include <pybind11/pybind11.h>

#include <exception> // for the base
#include <string>    // for messages
#include <vector>    // for warnings

namespace dggPython
{
namespace py = pybind11;

/// Carries the status of a failure to Python, where it becomes an `Error`.
class StatusError : public std::exception
{
public:
  explicit StatusError(const dgg::Status& reason)
    : Reason(reason)
  {
  }
  const char* what() const noexcept override { return this->Reason.GetProblem().c_str(); }
  const dgg::Status& GetReason() const { return this->Reason; }

private:
  dgg::Status Reason;
};

/// Throws a StatusError unless the status is Ok.
void ThrowUnlessOk(const dgg::Status& status);

/// Returns the argument of a property: "maximum_distance" for "MaximumDistance".
std::string GetArgumentName(const std::string& property);
/// Returns the property of an argument: the inverse of GetArgumentName().
std::string GetPropertyName(const std::string& argument);
/// Returns a message with arguments, in backticks, in place of properties in braces.
std::string RenderMessage(const std::string& message);
/// Returns warnings as sentences with final periods.
py::list RenderWarnings(const std::vector<std::string>& warnings);

/// Adds the exception `Error` to the module.
void AddErrors(py::module_& module);
}

#endif
