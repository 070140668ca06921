// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPCDText.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <type_traits>

namespace
{
/// std::from_chars does not say whether a float was too large or too small: by its power of ten.
bool IsTooSmall(const char* first, const char* last)
{
  const std::string text(first, last);
  const std::size_t end = std::min(text.find_first_of("eE"), text.size());
  const std::size_t point = std::min(text.find('.'), end);
  const std::size_t digit = std::min(text.find_first_of("123456789"), end);
  double power = static_cast<double>(point) - static_cast<double>(digit);
  if (end < text.size())
  {
    power += std::strtod(text.c_str() + end + 1, nullptr); // digits and a sign, however many
  }
  return power < 0.0;
}

template <typename Number>
bool Parse(const char* first, const char* last, char* out, std::string& trouble)
{
  // A leading plus is not for std::from_chars.
  if (last - first > 1 && first[0] == '+' && first[1] != '-')
  {
    ++first;
  }
  Number number = 0;
  const auto parsed = std::from_chars(first, last, number);
  if (parsed.ptr != last || parsed.ec == std::errc::invalid_argument)
  {
    trouble = std::is_integral<Number>::value ? "is not an integer" : "is not a number";
    return false;
  }
  if (parsed.ec == std::errc::result_out_of_range)
  {
    if (std::is_integral<Number>::value || !IsTooSmall(first, last))
    {
      trouble = "is out of the range of the field";
      return false;
    }
    number = 0;
  }
  std::memcpy(out, &number, sizeof(number));
  return true;
}

template <typename Number>
void Append(const char* in, std::string& text)
{
  Number number;
  std::memcpy(&number, in, sizeof(number));
  // The sign of NaN says nothing, and not all programs know "-nan".
  if (number != number)
  {
    text += "nan";
    return;
  }
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), number);
  text.append(buffer, end.ptr);
}
}

bool vtkDGGParsePCDNumber(
  const char* first, const char* last, char kind, int size, char* out, std::string& trouble)
{
  switch (kind == 'F' ? 10 * size : kind == 'I' ? size : -size)
  {
    case 40:
      return Parse<float>(first, last, out, trouble);
    case 80:
      return Parse<double>(first, last, out, trouble);
    case 1:
      return Parse<std::int8_t>(first, last, out, trouble);
    case 2:
      return Parse<std::int16_t>(first, last, out, trouble);
    case 4:
      return Parse<std::int32_t>(first, last, out, trouble);
    case 8:
      return Parse<std::int64_t>(first, last, out, trouble);
    case -1:
      return Parse<std::uint8_t>(first, last, out, trouble);
    case -2:
      return Parse<std::uint16_t>(first, last, out, trouble);
    case -4:
      return Parse<std::uint32_t>(first, last, out, trouble);
    case -8:
      return Parse<std::uint64_t>(first, last, out, trouble);
    default:
      trouble = "has no known type";
      return false;
  }
}

void vtkDGGAppendPCDNumber(const char* in, char kind, int size, std::string& text)
{
  switch (kind == 'F' ? 10 * size : kind == 'I' ? size : -size)
  {
    case 40:
      return Append<float>(in, text);
    case 80:
      return Append<double>(in, text);
    case 1:
      return Append<std::int8_t>(in, text);
    case 2:
      return Append<std::int16_t>(in, text);
    case 4:
      return Append<std::int32_t>(in, text);
    case 8:
      return Append<std::int64_t>(in, text);
    case -1:
      return Append<std::uint8_t>(in, text);
    case -2:
      return Append<std::uint16_t>(in, text);
    case -4:
      return Append<std::uint32_t>(in, text);
    case -8:
      return Append<std::uint64_t>(in, text);
    default:
      break;
  }
}
