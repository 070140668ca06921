// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Keyword arguments of a call, whose defaults are those of the kernel's options.
#ifndef Arguments_h
#define Arguments_h

#include "dggTypes.h" // for Offset

#include <pybind11/pybind11.h>

#include <cstdint>          // for types of numbers
#include <initializer_list> // for choices
#include <set>              // for names
#include <string>           // for names
#include <utility>          // for choices
#include <vector>           // for values

namespace dggPython
{
namespace py = pybind11;

/// Keyword arguments. Each Read() leaves the value unchanged if the argument is missing, or None.
class Arguments
{
public:
  explicit Arguments(const py::kwargs& given)
    : Given(given)
  {
  }

  /// Returns an argument; a null object if it is missing or None.
  py::object Take(const char* name);

  ///@{
  /// Throw a ValueError for an object that is not such a value.
  void Read(const char* name, bool& value);
  void Read(const char* name, std::int32_t& value);
  void Read(const char* name, dgg::Offset& value);
  void Read(const char* name, double& value);
  void Read(const char* name, std::string& value);
  void Read(const char* name, std::vector<double>& values);
  ///@}
  /// Reads a number that must be at least 0.
  void ReadLength(const char* name, double& value);
  /// Reads the name of one of some choices.
  template <typename Value>
  void ReadChoice(
    const char* name, std::initializer_list<std::pair<const char*, Value>> choices, Value& value)
  {
    std::string text;
    this->Read(name, text);
    std::string names;
    for (const auto& [choice, meaning] : choices)
    {
      if (text == choice)
      {
        value = meaning;
        return;
      }
      names += std::string(names.empty() ? "\"" : ", \"") + choice + "\"";
    }
    if (this->Take(name))
    {
      throw py::value_error(
        std::string(name) + ": expected one of " + names + ", got \"" + text + "\"");
    }
  }

  /// Throws a TypeError if there is an argument that has not been read.
  void Finish() const;

private:
  py::kwargs Given;
  std::set<std::string> Known;
};
}

#endif
