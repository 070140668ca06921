// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What filters share. Internal.
#ifndef DGGSharedTable_h
#define DGGSharedTable_h

#include <iterator> // for std::next
#include <map>      // for the table
#include <memory>   // for sharing
#include <mutex>    // for threads

/// What is in use, by a key that identifies it. The table owns nothing: a value is released with
/// the last filter that has it.
template <typename Key, typename Value>
class DGGSharedTable
{
public:
  using Pointer = std::shared_ptr<const Value>;

  /// Null when there is none.
  Pointer Find(const Key& key)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Values.find(key);
    return found == this->Values.end() ? nullptr : found->second.lock();
  }

  /// What is in use by this key: the value, unless another thread has added one before.
  Pointer Add(const Key& key, const Pointer& value)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (auto entry = this->Values.begin(); entry != this->Values.end();)
    {
      entry = entry->second.expired() ? this->Values.erase(entry) : std::next(entry);
    }
    std::weak_ptr<const Value>& place = this->Values[key];
    Pointer inUse = place.lock();
    if (!inUse)
    {
      place = value;
      inUse = value;
    }
    return inUse;
  }

private:
  std::mutex Mutex;
  std::map<Key, std::weak_ptr<const Value>> Values;
};

#endif
