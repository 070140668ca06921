// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages between processes that compute a result together. Internal.
#ifndef dggProcessGroup_h
#define dggProcessGroup_h

#include "dggStatus.h" // for Status

#include <algorithm>   // for std::find
#include <array>       // for single values
#include <cstddef>     // for std::size_t
#include <cstring>     // for std::memcpy
#include <functional>  // for the exchange
#include <new>         // for std::bad_alloc
#include <type_traits> // for std::is_trivially_copyable
#include <vector>      // for messages

namespace dgg
{
using Message = std::vector<char>;

/// Appends an array to a message.
template <typename T>
void Append(Message& message, const std::vector<T>& values)
{
  static_assert(std::is_trivially_copyable_v<T>);
  const std::size_t size = values.size();
  const std::size_t bytes = size * sizeof(T);
  const std::size_t end = message.size();
  message.resize(end + sizeof(size) + bytes);
  std::memcpy(message.data() + end, &size, sizeof(size));
  if (bytes > 0)
  {
    std::memcpy(message.data() + end + sizeof(size), values.data(), bytes);
  }
}

/// Reads the arrays of a message in the order in which they were appended.
class MessageReader
{
public:
  explicit MessageReader(const Message& message)
    : Next(message.data())
    , End(message.data() + message.size())
  {
  }

  /// Returns an empty array after the last one.
  template <typename T>
  std::vector<T> Take()
  {
    std::vector<T> values;
    if (this->Next != this->End)
    {
      std::size_t size = 0;
      std::memcpy(&size, this->Next, sizeof(size));
      values.resize(size);
      this->Next += sizeof(size);
      if (size > 0)
      {
        std::memcpy(values.data(), this->Next, size * sizeof(T));
      }
      this->Next += size * sizeof(T);
    }
    return values;
  }

private:
  const char* Next;
  const char* End;
};

/// Processes that compute a result together. All of them must call the same functions in the same
/// order.
struct ProcessGroup
{
  int Here = 0;
  int Count = 1;
  /// Sends messages[p] to each process p; messages[p] becomes the message from process p.
  std::function<void(std::vector<Message>&)> Exchange;
  /// Returns success if all processes succeeded, otherwise the error of the first one that failed.
  std::function<Status(const Status&)> Agree;

  /// Runs a step without messages on all processes. Fails on all of them if it fails on one.
  template <typename Step>
  Status Run(const Step& step) const
  {
    Status status;
    try
    {
      status = step();
    }
    catch (const std::bad_alloc&)
    {
      status = Status(Status::Code::OutOfMemory, "Memory is exhausted")
                 .Fix("Use more processes or a smaller surface");
    }
    return this->Agree(status);
  }

  /// Returns the lists of all processes, in their order.
  template <typename T>
  std::vector<std::vector<T>> ShareList(const std::vector<T>& list) const
  {
    std::vector<Message> messages(static_cast<std::size_t>(this->Count));
    for (Message& message : messages)
    {
      Append(message, list);
    }
    this->Exchange(messages);
    std::vector<std::vector<T>> lists;
    for (const Message& message : messages)
    {
      lists.push_back(MessageReader(message).Take<T>());
    }
    return lists;
  }

  /// Returns the values of all processes, in their order.
  template <typename T>
  std::vector<T> Share(const T& value) const
  {
    std::vector<T> values;
    for (const auto& list : this->ShareList(std::vector<std::array<T, 1>>{ { value } }))
    {
      values.push_back(list.front()[0]);
    }
    return values;
  }

  /// Returns the values of the first process.
  template <typename T>
  std::vector<T> TakeFromFirst(const std::vector<T>& values) const
  {
    return this->ShareList(this->Here == 0 ? values : std::vector<T>()).front();
  }

  /// Returns true if the condition holds on all processes.
  bool Holds(bool condition) const
  {
    const std::vector<char> all = this->Share(static_cast<char>(condition ? 1 : 0));
    return std::find(all.begin(), all.end(), 0) == all.end();
  }
};
}

#endif
