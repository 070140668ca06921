// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Index types, constants and the error and progress vocabulary of the kernel.
#ifndef dggTypes_h
#define dggTypes_h

#include <cstdint>    // for fixed-width indices
#include <functional> // for ProgressCallback
#include <limits>     // for Infinity
#include <string>     // for Status
#include <utility>    // for std::move

namespace dgg
{
/// Index of a vertex, a face or a half-edge. Half-edge 3f+k starts at corner k of face f.
using Id = std::int32_t;
/// Offset into flat arrays that may hold more than 2^31 entries.
using Offset = std::int64_t;

/// "No such element" for every kind of Id.
constexpr Id NoId = -1;
constexpr double Pi = 3.14159265358979323846;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Outcome of a kernel call. The kernel never throws on bad input and never prints: it returns a
/// description of the error, and the caller decides how to show it.
class Status
{
public:
  enum class Code
  {
    Ok,
    InvalidInput, ///< the message names the offending element and the remedy
    Aborted       ///< aborted by the progress callback
  };

  static Status Success() { return {}; }
  static Status Invalid(std::string message)
  {
    return Status(Code::InvalidInput, std::move(message));
  }
  static Status Abort() { return Status(Code::Aborted, "aborted"); }

  Status() = default;
  bool IsOk() const { return this->Kind == Code::Ok; }
  bool IsAborted() const { return this->Kind == Code::Aborted; }
  Code GetCode() const { return this->Kind; }
  const std::string& GetMessage() const { return this->Message; }
  /// Returns the status with a message that begins with `subject`, the subject of the error.
  Status Of(const std::string& subject) const
  {
    return this->Kind == Code::InvalidInput ? Invalid(subject + ": " + this->Message) : *this;
  }

private:
  Status(Code kind, std::string message)
    : Kind(kind)
    , Message(std::move(message))
  {
  }

  Code Kind = Code::Ok;
  std::string Message;
};

/// Evaluates an expression that returns a Status, and returns from this function unless it is Ok.
#define DGG_RETURN_IF_ERROR(...)                                \
  if (dgg::Status dggStatus = (__VA_ARGS__); !dggStatus.IsOk()) \
  {                                                             \
    return dggStatus;                                           \
  }

/// Called periodically by long loops, from any of their threads, with the finished fraction in [0,
/// 1]; returns false to stop.
using ProgressCallback = std::function<bool(double)>;
}

#endif
