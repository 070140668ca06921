// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Properties that several filters have. Internal.
#ifndef vtkDGGProperties_h
#define vtkDGGProperties_h

#include "dggTypes.h" // for Status

#include "vtkIndent.h" // for printing
#include "vtkType.h"   // for vtkIdType

#include <initializer_list> // for ids
#include <ostream>          // for printing
#include <string>           // for names
#include <vector>           // for ids

class vtkIdList;

/// Set a property that may be NaN, which differs from itself. Returns whether it has changed.
bool vtkDGGChangeNumber(double& property, double value);

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

/// The ids of a list, none for null.
std::vector<vtkIdType> vtkDGGGetIds(vtkIdList* list);
/// The i-th id; -1 when there is none.
vtkIdType vtkDGGGetId(const std::vector<vtkIdType>& ids, vtkIdType i);
/// A line with the name and the ids.
void vtkDGGPrintIds(
  std::ostream& os, vtkIndent indent, const char* name, const std::vector<vtkIdType>& ids);

/// Fails when the property of that name is negative or NaN. Infinity is a length.
dgg::Status vtkDGGCheckLength(const std::string& property, double value);

/// Defines the methods that a filter declares for a list of ids: `Member` is the vector, and they
/// are called as in AddSiteId() and SetSiteIds() for `Name` Site. The assertion is there for the
/// semicolon.
#define vtkDGGDefineIdsMacro(Class, Name, Member)                  \
  void Class::Add##Name##Id(vtkIdType id)                          \
  {                                                                \
    this->Member.push_back(id);                                    \
    this->Modified();                                              \
  }                                                                \
  void Class::Set##Name##Ids(vtkIdList* ids)                       \
  {                                                                \
    this->Set##Name##Ids(vtkDGGGetIds(ids));                       \
  }                                                                \
  void Class::Set##Name##Ids(std::initializer_list<vtkIdType> ids) \
  {                                                                \
    this->Set##Name##Ids(std::vector<vtkIdType>(ids));             \
  }                                                                \
  void Class::Set##Name##Ids(const std::vector<vtkIdType>& ids)    \
  {                                                                \
    if (this->Member != ids)                                       \
    {                                                              \
      this->Member = ids;                                          \
      this->Modified();                                            \
    }                                                              \
  }                                                                \
  void Class::RemoveAll##Name##Ids()                               \
  {                                                                \
    this->Set##Name##Ids(std::vector<vtkIdType>());                \
  }                                                                \
  vtkIdType Class::GetNumberOf##Name##Ids() const                  \
  {                                                                \
    return static_cast<vtkIdType>(this->Member.size());            \
  }                                                                \
  vtkIdType Class::Get##Name##Id(vtkIdType i) const                \
  {                                                                \
    return vtkDGGGetId(this->Member, i);                           \
  }                                                                \
  static_assert(true, #Name)

/// Defines the methods that a filter declares for a polydata input port: SetSiteConnection() and
/// SetSiteData() for `Name` Site.
#define vtkDGGDefineInputMacro(Class, Name, port)               \
  void Class::Set##Name##Connection(vtkAlgorithmOutput* output) \
  {                                                             \
    this->SetInputConnection(port, output);                     \
  }                                                             \
  void Class::Set##Name##Data(vtkPolyData* data)                \
  {                                                             \
    this->SetInputData(port, data);                             \
  }                                                             \
  static_assert(true, #Name)

#endif
// VTK-HeaderTest-Exclude: vtkDGGProperties.h
