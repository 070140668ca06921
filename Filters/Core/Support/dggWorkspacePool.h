// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A pool of reusable workspaces. Internal.
#ifndef dggWorkspacePool_h
#define dggWorkspacePool_h

#include <cstddef> // for std::size_t
#include <memory>  // for the workspaces
#include <mutex>   // for the list
#include <utility> // for std::move
#include <vector>  // for the list

namespace dgg
{
/// Stores idle workspaces, up to the largest number in use simultaneously. Thread-safe.
template <typename Workspace>
class WorkspacePool
{
public:
  /// A borrowed workspace, returned to the pool by the destructor.
  class Loan
  {
  public:
    Loan(WorkspacePool& pool, std::unique_ptr<Workspace> workspace)
      : Pool(pool)
      , Value(std::move(workspace))
    {
    }
    ~Loan() { this->Pool.Return(std::move(this->Value)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    Workspace& operator*() const { return *this->Value; }
    Workspace* operator->() const { return this->Value.get(); }

  private:
    WorkspacePool& Pool;
    std::unique_ptr<Workspace> Value;
  };

  /// Borrows a workspace; a new one is created from `arguments` if none is idle.
  template <typename... Arguments>
  Loan Borrow(const Arguments&... arguments)
  {
    std::unique_ptr<Workspace> workspace;
    {
      const std::lock_guard<std::mutex> lock(this->Mutex);
      if (!this->Idle.empty())
      {
        workspace = std::move(this->Idle.back());
        this->Idle.pop_back();
      }
      else
      {
        // Reserves space for all workspaces, so that Return() cannot fail.
        this->Idle.reserve(++this->NumberOfWorkspaces);
      }
    }
    return Loan(
      *this, workspace ? std::move(workspace) : std::make_unique<Workspace>(arguments...));
  }

  /// Returns the size in bytes of the idle workspaces.
  std::size_t GetMemorySize() const
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::size_t size = 0;
    for (const std::unique_ptr<Workspace>& workspace : this->Idle)
    {
      size += workspace->GetMemorySize();
    }
    return size;
  }

private:
  void Return(std::unique_ptr<Workspace> workspace) noexcept
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Idle.push_back(std::move(workspace));
  }

  mutable std::mutex Mutex;
  std::vector<std::unique_ptr<Workspace>> Idle;
  std::size_t NumberOfWorkspaces = 0; ///< idle or not
};
}

#endif
