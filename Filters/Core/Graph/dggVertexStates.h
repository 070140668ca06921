// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is known of the vertices around one source. Internal.
#ifndef dggVertexStates_h
#define dggVertexStates_h

#include "dggTypes.h" // for Id

#include <cstddef> // for std::size_t
#include <vector>  // for the states

namespace dgg
{
/// Kept from source to source; only what a source has touched is reset.
class VertexStates
{
public:
  struct State
  {
    double Label = Infinity; ///< length of a path from the source
    double Cost = Infinity;  ///< as a relay
    Id Edge = NoId;          ///< index into the edges found
    bool IsTouched = false;
  };

  explicit VertexStates(Id numberOfVertices)
    : States(numberOfVertices)
  {
  }

  const State& operator[](Id v) const { return this->States[v]; }
  State& Touch(Id v)
  {
    State& state = this->States[v];
    if (!state.IsTouched)
    {
      state.IsTouched = true;
      this->Touched.push_back(v);
    }
    return state;
  }

  void Reset()
  {
    for (const Id v : this->Touched)
    {
      this->States[v] = State();
    }
    this->Touched.clear();
  }

  std::size_t GetMemorySize() const
  {
    return this->States.size() * sizeof(State) + this->Touched.capacity() * sizeof(Id);
  }

private:
  std::vector<State> States;
  std::vector<Id> Touched;
};
}

#endif
