// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Messages between processes that compute together. Internal.
#ifndef DGGDistributor_h
#define DGGDistributor_h

#include "dggProcessGroup.h" // for messages

#include "vtkDGGFiltersGeodesicModule.h" // for the export macro

#include <memory> // for the distributor
#include <vector> // for messages

class vtkMultiProcessController;

/// Transfers messages between processes. DGG::FiltersParallel registers a distributor for MPI when
/// it is loaded; without one, pieces are gathered.
class VTKDGGFILTERSGEODESIC_EXPORT DGGDistributor
{
public:
  virtual ~DGGDistributor() = default;

  /// Returns true if the processes of a controller can exchange messages.
  virtual bool Supports(vtkMultiProcessController* controller) const = 0;
  /// See dgg::ProcessGroup::Transfer.
  virtual void Transfer(vtkMultiProcessController* controller, std::vector<dgg::Message>& sent,
    std::vector<dgg::Message>& received) const = 0;
  /// See dgg::ProcessGroup::ShareMemory.
  virtual bool ShareMemory(vtkMultiProcessController* controller,
    std::vector<dgg::SharedBlock>& blocks, dgg::SharedCopies& copies) const noexcept = 0;

  static void Register(std::unique_ptr<const DGGDistributor> distributor);
  /// Returns the distributor; null if none is registered.
  static const DGGDistributor* Get();
};

#endif
