// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Result of a task: points, cells, named arrays and warnings.
#ifndef dggOutput_h
#define dggOutput_h

#include "dggBuffer.h" // for the arrays
#include "dggTypes.h"  // for Offset

#include <algorithm> // for std::copy
#include <array>     // for origins
#include <cstddef>   // for std::size_t
#include <cstdint>   // for types of values
#include <optional>  // for origins
#include <string>    // for names
#include <utility>   // for std::move
#include <variant>   // for types of values
#include <vector>    // for lists of arrays

namespace dgg
{
/// Array of tuples with a name.
struct OutputArray
{
  using ValueBuffer =
    std::variant<Buffer<double>, Buffer<std::int32_t>, Buffer<Offset>, Buffer<std::uint8_t>>;

  std::string Name;
  int NumberOfComponents;
  ValueBuffer Values; ///< tuple by tuple
};

/// Arrays of points, of cells or of an entire output.
class OutputArrays : public std::vector<OutputArray>
{
public:
  /// Adds an array and returns its uninitialized values, which stay valid when arrays are added.
  template <typename ValueType>
  ValueType* Add(const std::string& name, std::size_t tuples, int components = 1)
  {
    Buffer<ValueType> values(tuples * static_cast<std::size_t>(components));
    ValueType* const first = values.Data();
    this->push_back({ name, components, std::move(values) });
    return first;
  }
  /// Adds an array with the given values.
  template <typename ValueType, typename Number>
  void AddValues(const std::string& name, const std::vector<Number>& values, int components = 1)
  {
    const std::size_t tuples = values.size() / static_cast<std::size_t>(components);
    std::copy(values.begin(), values.end(), this->Add<ValueType>(name, tuples, components));
  }
};

/// Cells as flat arrays: the point ids of cell i are `Points[Offsets[i]]` to
/// `Points[Offsets[i + 1] - 1]`. Both arrays are empty if there are no cells.
struct OutputCells
{
  Buffer<Offset> Offsets;
  Buffer<Offset> Points;

  std::size_t GetNumberOfCells() const { return this->Offsets.IsEmpty() ? 0 : Offsets.Size() - 1; }
};

/// Points of the input from which arrays are interpolated at a point of an output. The weights are
/// not used if there is one point, whose tuples are copied; then the other ids are NoId.
struct PointOrigin
{
  std::array<Id, 3> Points;
  std::array<double, 3> Weights;
};

/// Cells are numbered verts first, then lines, then polygons.
struct Output
{
  Buffer<double> Points; ///< x y z each
  OutputCells Verts;
  OutputCells Lines;
  OutputCells Polygons;
  OutputArrays PointData;
  OutputArrays CellData;
  OutputArrays FieldData;
  ///@{
  /// Origins of all points and of all cells (cells of the input), if arrays of the input are
  /// passed. Arrays of the output with the same names replace them.
  std::optional<Buffer<PointOrigin>> PointOrigins;
  std::optional<Buffer<Offset>> CellOrigins;
  ///@}
  ///@{
  /// Names of the active scalars; empty for none.
  std::string PointScalars;
  std::string CellScalars;
  ///@}
  std::vector<std::string> Warnings; ///< without the final period

  /// Adds a warning unless it is empty.
  void Warn(const std::string& warning)
  {
    if (!warning.empty())
    {
      this->Warnings.push_back(warning);
    }
  }
};
}

#endif
