// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Properties that several filters have. Internal.
#ifndef vtkDGGProperties_h
#define vtkDGGProperties_h

#include "dggTypes.h" // for Status

#include "vtkIndent.h" // for printing
#include "vtkType.h"   // for vtkIdType

#include <ostream> // for printing
#include <string>  // for names
#include <vector>  // for ids

/// Defines both ways to set the data of an input port. The assertion is there for the semicolon.
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

/// The i-th id; -1 when there is none.
vtkIdType vtkDGGGetId(const std::vector<vtkIdType>& ids, vtkIdType i);
/// A line with the name and the ids.
void vtkDGGPrintIds(
  std::ostream& os, vtkIndent indent, const char* name, const std::vector<vtkIdType>& ids);

/// Fails when the property of that name is negative or NaN. Infinity is a length.
dgg::Status vtkDGGCheckLength(const std::string& property, double value);

#endif
// VTK-HeaderTest-Exclude: vtkDGGProperties.h
