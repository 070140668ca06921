// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A table of shared objects. Internal.
#ifndef dggSharedTable_h
#define dggSharedTable_h

#include <iterator> // for std::next
#include <map>      // for the table
#include <memory>   // for sharing
#include <mutex>    // for threads

namespace dgg
{
/// Objects in use, identified by a key. The table owns nothing: an object is released with its last
/// user.
template <typename Key, typename Value>
class SharedTable
{
public:
  using Pointer = std::shared_ptr<const Value>;

  /// Returns the object in use by this key, or null.
  Pointer Find(const Key& key)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Values.find(key);
    return found == this->Values.end() ? nullptr : found->second.lock();
  }

  /// Returns the object in use by this key: `value` unless another thread has added one before.
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
}

#endif
