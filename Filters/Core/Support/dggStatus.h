// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Outcomes of kernel calls, and the composition of their messages.
#ifndef dggStatus_h
#define dggStatus_h

#include "dggCoreExport.h" // for the export macro
#include "dggTypes.h"      // for Offset

#include <functional>  // for names in messages
#include <string>      // for messages
#include <type_traits> // for JoinText
#include <utility>     // for std::move

namespace dgg
{
/// Outcome of a kernel call. The kernel never throws on bad input and never prints: it returns a
/// description of the error, and the caller decides how to show it.
///
/// Problem and action are sentences without a final period. They name properties of filters, and
/// inputs besides the surface, in braces, as in "{Accuracy}" and "{Curves}"; "{InArrays}" is where
/// a stored graph was found. See Render().
class DGG_CORE_EXPORT Status
{
public:
  enum class Code
  {
    Ok,
    InvalidInput, ///< the message names the offending element and the remedy
    NotConnected, ///< no path on the surface joins two points
    DamagedGraph, ///< the arrays of a graph contradict each other
    OutOfMemory,  ///< a memory limit or the memory of the machine is exceeded
    Aborted       ///< aborted by the progress callback
  };

  static Status Success() { return {}; }
  static Status Abort() { return Status(Code::Aborted, "Aborted"); }

  Status() = default;
  Status(Code kind, std::string problem)
    : Kind(kind)
    , Problem(std::move(problem))
  {
  }

  bool IsOk() const { return this->Kind == Code::Ok; }
  bool IsAborted() const { return this->Kind == Code::Aborted; }
  Code GetCode() const { return this->Kind; }
  /// Returns the property or the array at fault; empty if there is none.
  const std::string& GetParameter() const { return this->Parameter; }
  /// Returns the id or the index of the offending element; -1 if there is none.
  Offset GetIndex() const { return this->Index; }
  const std::string& GetProblem() const { return this->Problem; }
  const std::string& GetAction() const { return this->Action; }
  /// Returns problem and action as sentences with final periods; empty if the status is Ok.
  std::string GetMessage() const;

  /// Returns the status with the property or the array at fault and the offending element.
  Status At(std::string parameter, Offset index = -1) const;
  /// Returns the status with a remedy composed of texts and numbers.
  template <typename... Parts>
  Status Fix(const Parts&... parts) const;
  /// Returns the status with a problem that begins with `subject`, the subject of the error.
  /// Success and aborts are returned unchanged.
  Status Of(const std::string& subject) const;

private:
  Code Kind = Code::Ok;
  std::string Parameter;
  Offset Index = -1;
  std::string Problem;
  std::string Action;
};

/// Evaluates an expression that returns a Status, and returns from this function unless it is Ok.
#define DGG_RETURN_IF_ERROR(...)                                \
  if (dgg::Status dggStatus = (__VA_ARGS__); !dggStatus.IsOk()) \
  {                                                             \
    return dggStatus;                                           \
  }

/// Appends a number with six significant digits.
DGG_CORE_EXPORT void AppendNumber(std::string& text, double number);

/// Concatenates texts and numbers.
template <typename... Parts>
std::string JoinText(const Parts&... parts)
{
  std::string text;
  const auto append = [&text](const auto& part) {
    using Part = std::decay_t<decltype(part)>;
    if constexpr (std::is_floating_point_v<Part>)
    {
      AppendNumber(text, part);
    }
    else if constexpr (std::is_integral_v<Part> && !std::is_same_v<Part, char>)
    {
      text += std::to_string(part);
    }
    else
    {
      text += part;
    }
  };
  (append(parts), ...);
  return text;
}

/// Returns an error whose problem is composed of texts and numbers.
template <typename... Parts>
Status InvalidInput(const Parts&... parts)
{
  return Status(Status::Code::InvalidInput, JoinText(parts...));
}

/// Returns the error of a property with a wrong value.
template <typename Value>
Status InvalidValue(const std::string& property, const Value& value)
{
  return InvalidInput("{", property, "} is ", value).At(property);
}

template <typename... Parts>
Status Status::Fix(const Parts&... parts) const
{
  Status status = *this;
  status.Action = JoinText(parts...);
  return status;
}

/// Returns a message with the properties in braces replaced by the names that `nameOf` returns.
/// Without `nameOf`, only the braces are removed. Braces around anything but letters, as in the
/// name of an array, stay.
DGG_CORE_EXPORT std::string Render(const std::string& message,
  const std::function<std::string(const std::string&)>& nameOf = nullptr);
}

#endif
