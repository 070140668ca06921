// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Properties that several filters have in common. Internal.
#ifndef DGGProperties_h
#define DGGProperties_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro

#include "vtkIndent.h" // for printing
#include "vtkType.h"   // for vtkIdType

#include <ostream> // for printing
#include <string>  // for messages
#include <vector>  // for ids

/// Defines both functions that set the data of an input port. The assertion requires a semicolon
/// after the macro.
#define vtkDGGDefineInputMacro(Class, Name, Port)                   \
  void Class::Set##Name##Connection(vtkAlgorithmOutput* connection) \
  {                                                                 \
    this->SetInputConnection(Port, connection);                     \
  }                                                                 \
  void Class::Set##Name##Data(vtkPolyData* data)                    \
  {                                                                 \
    this->SetInputData(Port, data);                                 \
  }                                                                 \
  static_assert(true, #Name)

/// Returns a message of the kernel in terms of filters: see dgg::Render().
VTKDGGFILTERSCOMMON_EXPORT std::string DGGRender(const std::string& message);

/// Returns the i-th id; -1 if there is none.
VTKDGGFILTERSCOMMON_EXPORT vtkIdType DGGGetId(const std::vector<vtkIdType>& ids, vtkIdType i);
/// Prints a line with the name and the ids.
VTKDGGFILTERSCOMMON_EXPORT void DGGPrintIds(
  std::ostream& os, vtkIndent indent, const char* name, const std::vector<vtkIdType>& ids);

#endif
