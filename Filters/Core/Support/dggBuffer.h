// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A flat uninitialized array that can be handed over to another owner.
#ifndef dggBuffer_h
#define dggBuffer_h

#include <cstddef>     // for std::size_t
#include <cstdlib>     // for std::malloc
#include <new>         // for std::bad_alloc
#include <type_traits> // for std::is_trivially_copyable
#include <utility>     // for std::exchange

namespace dgg
{
/// Memory for `size` values from std::malloc. Unlike a std::vector it is not initialized, and
/// Release() hands it over without a copy, to be freed by std::free.
template <typename T>
class Buffer
{
  static_assert(std::is_trivially_copyable<T>::value, "only for plain values");

public:
  Buffer() = default;
  /// Throws std::bad_alloc.
  explicit Buffer(std::size_t size)
    : Values(size == 0 ? nullptr : static_cast<T*>(std::malloc(size * sizeof(T))))
    , Count(size)
  {
    if (size != 0 && !this->Values)
    {
      throw std::bad_alloc();
    }
  }
  ~Buffer() { std::free(this->Values); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  Buffer(Buffer&& other) noexcept
    : Values(std::exchange(other.Values, nullptr))
    , Count(std::exchange(other.Count, 0))
  {
  }
  Buffer& operator=(Buffer&& other) noexcept
  {
    std::swap(this->Values, other.Values);
    std::swap(this->Count, other.Count);
    return *this;
  }

  std::size_t Size() const { return this->Count; }
  bool IsEmpty() const { return this->Count == 0; }
  T* Data() { return this->Values; }
  const T* Data() const { return this->Values; }
  T& operator[](std::size_t i) { return this->Values[i]; }
  const T& operator[](std::size_t i) const { return this->Values[i]; }
  T* begin() { return this->Values; }
  T* end() { return this->Values + this->Count; }
  const T* begin() const { return this->Values; }
  const T* end() const { return this->Values + this->Count; }

  /// Changes the size, preserving the values that fit. Large blocks are moved without a copy if the
  /// system supports it. Throws std::bad_alloc; then nothing has changed.
  void Resize(std::size_t size)
  {
    if (size == 0)
    {
      this->Clear();
      return;
    }
    void* values = std::realloc(this->Values, size * sizeof(T));
    if (!values)
    {
      throw std::bad_alloc();
    }
    this->Values = static_cast<T*>(values);
    this->Count = size;
  }

  /// Releases ownership of the memory, which must be freed by std::free. The buffer is empty
  /// afterwards.
  T* Release()
  {
    this->Count = 0;
    return std::exchange(this->Values, nullptr);
  }
  void Clear() { Buffer().Swap(*this); }
  void Swap(Buffer& other)
  {
    std::swap(this->Values, other.Values);
    std::swap(this->Count, other.Count);
  }

private:
  T* Values = nullptr;
  std::size_t Count = 0;
};
}

#endif
