// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Context of an update of a filter. Not for use outside of vtkDGG.
 */
#ifndef DGGContext_h
#define DGGContext_h

#include "dggTaskContext.h" // For the base

class vtkPolyData;

struct DGGContext : public dgg::TaskContext
{
  vtkPolyData* Input; ///< input port 0
};

#endif
