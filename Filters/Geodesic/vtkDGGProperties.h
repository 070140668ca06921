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

/// Set a name; null is the empty one. Returns whether it has changed.
bool vtkDGGChangeName(std::string& property, const char* value);
/// Defines the setter and the getter of a property that is a name, of which `Member` is the string.
/// The assertion is there for the semicolon.
#define vtkDGGDefineNameMacro(Class, Property, Member) \
  void Class::Set##Property(const char* name)          \
  {                                                    \
    if (vtkDGGChangeName(this->Member, name))          \
    {                                                  \
      this->Modified();                                \
    }                                                  \
  }                                                    \
  const char* Class::Get##Property() const             \
  {                                                    \
    return this->Member.c_str();                       \
  }                                                    \
  static_assert(true, #Property)

/// Defines both ways to set the data of an input port.
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
