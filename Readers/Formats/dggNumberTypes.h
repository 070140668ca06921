// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Number types chosen at run time. Internal to the parsers and writers.
#ifndef dggNumberTypes_h
#define dggNumberTypes_h

#include "dggMeshData.h" // for arrays

#include <cstddef>     // for std::size_t
#include <cstdint>     // for types
#include <limits>      // for kinds
#include <type_traits> // for std::decay_t

namespace dgg
{
struct NumberType
{
  char Kind = 'F';      ///< F (float), I (integer) or U (unsigned integer)
  std::size_t Size = 4; ///< bytes: 4 or 8 for F, otherwise 1, 2, 4 or 8

  bool operator==(const NumberType& other) const
  {
    return this->Kind == other.Kind && this->Size == other.Size;
  }
};

template <typename T>
constexpr NumberType TypeOf()
{
  using Limits = std::numeric_limits<T>;
  return { !Limits::is_integer ? 'F' : Limits::is_signed ? 'I' : 'U', sizeof(T) };
}

/// Calls `worker` with a zero-initialized number of the type. Returns false if there is no such
/// type.
template <typename Worker>
bool DispatchNumber(const NumberType& type, const Worker& worker)
{
  const auto attempt = [&](auto zero) {
    const bool isType = type == TypeOf<decltype(zero)>();
    if (isType)
    {
      worker(zero);
    }
    return isType;
  };
  return attempt(float()) || attempt(double()) || attempt(std::uint8_t()) ||
    attempt(std::int32_t()) || attempt(std::int8_t()) || attempt(std::int16_t()) ||
    attempt(std::uint16_t()) || attempt(std::uint32_t()) || attempt(std::int64_t()) ||
    attempt(std::uint64_t());
}

/// Returns `count` zeros of the type.
inline ArrayValues MakeValues(const NumberType& type, std::size_t count)
{
  ArrayValues values;
  DispatchNumber(type, [&](auto zero) { values = std::vector<decltype(zero)>(count, zero); });
  return values;
}

/// Returns the type of the values.
inline NumberType GetType(const ArrayValues& values)
{
  return std::visit(
    [](const auto& v) { return TypeOf<typename std::decay_t<decltype(v)>::value_type>(); }, values);
}
}

#endif
