// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages between processes that compute a result together. Internal.
#ifndef dggProcessGroup_h
#define dggProcessGroup_h

#include "dggMemoryLimit.h" // for CheckMemory
#include "dggStatus.h"      // for Status

#include <algorithm>   // for std::find
#include <cstddef>     // for std::size_t
#include <cstring>     // for std::memcpy
#include <functional>  // for the transfer
#include <memory>      // for std::unique_ptr
#include <type_traits> // for std::is_trivially_copyable
#include <utility>     // for std::move
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

/// Appends an array to a message unless it is empty.
template <typename T>
void AppendIfAny(Message& message, const std::vector<T>& values)
{
  if (!values.empty())
  {
    Append(message, values);
  }
}

/// A value of the element with an index in a list that two processes share.
template <typename T>
struct SharedValue
{
  Id Index;
  T Content;
};

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

/// Bytes of an array, see ProcessGroup::ShareMemory.
struct SharedBlock
{
  const void* Data = nullptr;
  std::size_t Size = 0;
};

/// Releases the memory of SharedCopies.
struct CopyRelease
{
  std::size_t Size = 0; ///< bytes
  void (*Release)(void* data, std::size_t size) = nullptr;

  void operator()(void* data) const { this->Release(data, this->Size); }
};

/// Owner of the copies of ProcessGroup::ShareMemory on one process; null on the first process.
using SharedCopies = std::unique_ptr<void, CopyRelease>;

/// Processes that compute a result together. All of them must call the same functions in the same
/// order, because the functions return when all processes have called them.
///
/// If a process fails or throws elsewhere, it must call Agree() with the error. The error then ends
/// the current or next function of the other processes, and the group communicates no more.
class ProcessGroup
{
public:
  int Here = 0;
  int Count = 1;
  /// Bytes that this process may use; see Exchange().
  double MemoryLimit = Infinity;
  /// Sends sent[p] to each process p and fills received[p], which has the size of the message from
  /// process p. Must not allocate memory in proportion to the messages.
  std::function<void(std::vector<Message>& sent, std::vector<Message>& received)> Transfer;
  /// Returns success if all processes succeeded, otherwise the error of the first one that failed.
  std::function<Status(const Status&)> FindFailure;
  /// Copies arrays of the first process to each machine with other processes. On these processes,
  /// `blocks` receives the addresses of the copies; sizes are equal on all processes. `copies`
  /// becomes the owner. Returns false on all processes if one of them cannot share memory. Must not
  /// throw.
  std::function<bool(std::vector<SharedBlock>& blocks, SharedCopies& copies)> ShareMemory;

  /// Returns success if all processes pass success, otherwise the same error on all processes.
  Status Agree(const Status& status)
  {
    if (this->Failure.IsOk())
    {
      this->Failure = this->FindFailure(status);
    }
    return this->Failure;
  }

  /// Sends messages[p] to each process p; messages[p] becomes the message from process p. Fails if
  /// the messages and `inUse`, the bytes in use already, exceed the limit of a process. `isEmpty`
  /// becomes true if all messages of all processes are empty.
  Status Exchange(std::vector<Message>& messages, double inUse, bool* isEmpty = nullptr)
  {
    struct Sizes
    {
      std::size_t OfMessage;
      std::size_t OfProcess; // all messages of the sender
    };
    std::size_t bytes = 0;
    for (const Message& message : messages)
    {
      bytes += message.size();
    }
    std::vector<Sizes> sizes;
    for (const Message& message : messages)
    {
      sizes.push_back({ message.size(), bytes });
    }
    DGG_RETURN_IF_ERROR(this->Swap(sizes));
    bool isAnySent = false;
    for (const Sizes& size : sizes)
    {
      bytes += size.OfMessage;
      isAnySent = isAnySent || size.OfProcess > 0;
    }
    if (isEmpty)
    {
      *isEmpty = !isAnySent;
    }
    const Status status = CheckMemory("The exchange of messages",
      inUse + static_cast<double>(bytes), this->MemoryLimit, "Use more processes");
    std::vector<Message> received(sizes.size());
    for (std::size_t process = 0; process < sizes.size() && status.IsOk(); ++process)
    {
      received[process].resize(sizes[process].OfMessage);
    }
    DGG_RETURN_IF_ERROR(this->Agree(status));
    this->Transfer(messages, received);
    messages.swap(received);
    return Status::Success();
  }

  /// Sends lists[p] to each process p; lists[p] becomes the list from process p. `inUse` are the
  /// bytes in use already, without the lists.
  template <typename T>
  Status ExchangeLists(std::vector<std::vector<T>>& lists, double inUse = 0.0)
  {
    std::vector<Message> messages(lists.size());
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      inUse += static_cast<double>(lists[process].size() * sizeof(T));
      Append(messages[process], lists[process]);
    }
    DGG_RETURN_IF_ERROR(this->Exchange(messages, inUse));
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      lists[process] = MessageReader(messages[process]).Take<T>();
    }
    return Status::Success();
  }

  /// Gets the values of all processes, in their order.
  template <typename T>
  Status Share(const T& value, std::vector<T>& all)
  {
    all.assign(static_cast<std::size_t>(this->Count), value);
    return this->Swap(all);
  }

  /// Replaces a value by the sum of those of all processes, in their order.
  template <typename T>
  Status Sum(T& value)
  {
    std::vector<T> all;
    DGG_RETURN_IF_ERROR(this->Share(value, all));
    value = all.front();
    std::for_each(all.begin() + 1, all.end(), [&](const T& other) { value.Add(other); });
    return Status::Success();
  }

  /// Replaces a value by that of the first process.
  template <typename T>
  Status TakeFromFirst(T& value)
  {
    std::vector<T> all;
    DGG_RETURN_IF_ERROR(this->Share(value, all));
    value = all.front();
    return Status::Success();
  }

  /// Gets the lists of all processes, in their order.
  template <typename T>
  Status ShareList(const std::vector<T>& list, std::vector<std::vector<T>>& all)
  {
    std::vector<Message> messages(static_cast<std::size_t>(this->Count));
    for (Message& message : messages)
    {
      Append(message, list);
    }
    DGG_RETURN_IF_ERROR(this->Exchange(messages, 0.0));
    all.clear();
    for (const Message& message : messages)
    {
      all.push_back(MessageReader(message).Take<T>());
    }
    return Status::Success();
  }

  /// Replaces a list by those of all processes, one after the other. `begin` becomes the index of
  /// the first element of this process.
  template <typename T>
  Status JoinLists(std::vector<T>& list, std::size_t* begin = nullptr)
  {
    std::vector<std::vector<T>> lists;
    DGG_RETURN_IF_ERROR(this->ShareList(list, lists));
    list.clear();
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      if (begin && process == static_cast<std::size_t>(this->Here))
      {
        *begin = list.size();
      }
      list.insert(list.end(), lists[process].begin(), lists[process].end());
    }
    return Status::Success();
  }

  /// Replaces a list by that of the first process.
  template <typename T>
  Status TakeListFromFirst(std::vector<T>& list)
  {
    std::vector<std::vector<T>> all;
    DGG_RETURN_IF_ERROR(this->ShareList(this->Here == 0 ? list : std::vector<T>(), all));
    list = std::move(all.front());
    return Status::Success();
  }

  /// Gathers tuples of a vector or a Buffer on the first process, where tuple i of this process
  /// gets the index order[i]. The orders of all processes are a permutation of 0, 1 and so on.
  /// Elsewhere `values` becomes empty.
  template <typename Values>
  Status Gather(const std::vector<std::size_t>& order, int components, Values& values)
  {
    using Value = std::decay_t<decltype(*values.begin())>;
    std::vector<Message> messages(static_cast<std::size_t>(this->Count));
    Append(messages[0], order);
    Append(messages[0], std::vector<Value>(values.begin(), values.end()));
    DGG_RETURN_IF_ERROR(this->Exchange(messages, 0.0));
    std::vector<std::vector<std::size_t>> orders;
    std::vector<std::vector<Value>> lists;
    std::size_t size = 0;
    for (const Message& message : messages)
    {
      MessageReader reader(message);
      orders.push_back(reader.Take<std::size_t>());
      lists.push_back(reader.Take<Value>());
      size += lists.back().size();
    }
    values = Values(size);
    for (std::size_t process = 0; process < lists.size(); ++process)
    {
      const Value* from = lists[process].data();
      for (const std::size_t index : orders[process])
      {
        std::copy_n(from, components, &*values.begin() + index * components);
        from += components;
      }
    }
    return Status::Success();
  }

  /// Makes a condition false unless it is true on all processes.
  Status Require(bool& condition)
  {
    std::vector<char> all;
    DGG_RETURN_IF_ERROR(this->Share(static_cast<char>(condition ? 1 : 0), all));
    condition = std::find(all.begin(), all.end(), 0) == all.end();
    return Status::Success();
  }

private:
  /// Sends values[p] to each process p; values[p] becomes the value from process p.
  template <typename T>
  Status Swap(std::vector<T>& values)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<Message> sent(values.size(), Message(sizeof(T)));
    std::vector<Message> received = sent;
    for (std::size_t process = 0; process < values.size(); ++process)
    {
      std::memcpy(sent[process].data(), &values[process], sizeof(T));
    }
    DGG_RETURN_IF_ERROR(this->Agree(Status::Success()));
    this->Transfer(sent, received);
    for (std::size_t process = 0; process < values.size(); ++process)
    {
      std::memcpy(&values[process], received[process].data(), sizeof(T));
    }
    return Status::Success();
  }

  Status Failure; // of the first process that failed
};
}

#endif
