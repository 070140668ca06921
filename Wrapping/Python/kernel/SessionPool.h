// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Objects that successive calls reuse, and simultaneous calls do not share.
#ifndef SessionPool_h
#define SessionPool_h

#include <cstddef> // for std::size_t
#include <memory>  // for the sessions
#include <mutex>   // for the lock
#include <utility> // for std::move
#include <vector>  // for the sessions

namespace dggPython
{
/// Base of pools of any kind.
class AnySessionPool
{
public:
  virtual ~AnySessionPool() = default;
  /// Returns the number of sessions that no call uses.
  virtual std::size_t GetSize() = 0;
  /// Destroys the sessions that no call uses.
  virtual void Clear() = 0;
};

/// Sessions that no call uses at present. There are as many sessions as there were simultaneous
/// calls.
template <typename Session>
class SessionPool : public AnySessionPool
{
public:
  std::size_t GetSize() override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return this->Unused.size();
  }

  void Clear() override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Unused.clear();
  }

  /// Returns the sum of a function over the sessions that no call uses.
  template <typename Function>
  std::size_t Sum(const Function& getSize)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::size_t sum = 0;
    for (const std::unique_ptr<Session>& session : this->Unused)
    {
      sum += getSize(*session);
    }
    return sum;
  }

  /// A session in use, which returns to the pool at the end.
  class Loan
  {
  public:
    explicit Loan(SessionPool& pool)
      : Pool(pool)
      , Taken(pool.Take())
    {
    }
    ~Loan() { this->Pool.Return(std::move(this->Taken)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    Session& operator*() const { return *this->Taken; }
    Session* operator->() const { return this->Taken.get(); }

  private:
    SessionPool& Pool;
    std::unique_ptr<Session> Taken;
  };

private:
  std::unique_ptr<Session> Take()
  {
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Unused.empty())
      {
        std::unique_ptr<Session> session = std::move(this->Unused.back());
        this->Unused.pop_back();
        return session;
      }
    }
    return std::make_unique<Session>();
  }

  void Return(std::unique_ptr<Session> session)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Unused.push_back(std::move(session));
  }

  std::mutex Mutex;
  std::vector<std::unique_ptr<Session>> Unused;
};
}

#endif
