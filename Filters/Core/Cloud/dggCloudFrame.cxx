// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudFrame.h"

#include <sstream>

namespace dgg
{
Status CloudFrame::CheckRange() const
{
  const double half = this->GetHalfExtent();
  if (half == 0.0 || (half >= 1e-150 && half <= 1e150))
  {
    return Status::Success();
  }
  std::ostringstream text;
  text << "the points are spread over " << half
       << " units to each side, out of the range of the arithmetic: scale them";
  return Status::Invalid(text.str());
}
}
