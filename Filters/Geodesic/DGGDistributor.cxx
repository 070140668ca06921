// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGDistributor.h"

#include <utility>

namespace
{
std::unique_ptr<const DGGDistributor>& GetRegistered()
{
  static std::unique_ptr<const DGGDistributor> registered;
  return registered;
}
}

//------------------------------------------------------------------------------
void DGGDistributor::Register(std::unique_ptr<const DGGDistributor> distributor)
{
  GetRegistered() = std::move(distributor);
}

//------------------------------------------------------------------------------
const DGGDistributor* DGGDistributor::Get()
{
  return GetRegistered().get();
}
