// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Properties that many filters have: macros that declare and define them, as in vtkSetGet.h. Not
 * for use outside of vtkDGG.
 */
#ifndef vtkDGGPropertyMacros_h
#define vtkDGGPropertyMacros_h

#include "vtkIdList.h" // For ids
#include "vtkSetGet.h" // For vtkBooleanMacro

#include <initializer_list> // For ids
#include <string>           // For names
#include <vector>           // For ids

/// Sets and gets a std::string; null sets the empty string.
#define vtkDGGStringMacro(name)                  \
  void Set##name(const char* value)              \
  {                                              \
    const std::string text = value ? value : ""; \
    if (this->name != text)                      \
    {                                            \
      this->name = text;                         \
      this->Modified();                          \
    }                                            \
  }                                              \
  const char* Get##name() const                  \
  {                                              \
    return this->name.c_str();                   \
  }

/// Sets a number that may be NaN, which is not equal to itself.
#define vtkDGGSetNumberMacro(name)                                           \
  virtual void Set##name(double value)                                       \
  {                                                                          \
    if (this->name != value && (this->name == this->name || value == value)) \
    {                                                                        \
      this->name = value;                                                    \
      this->Modified();                                                      \
    }                                                                        \
  }

#ifndef __VTK_WRAP__
// Without this overload {0} would be a null list.
#define vtkDGGSetIdsFromBracesMacro(name)                   \
  void Set##name##Ids(std::initializer_list<vtkIdType> ids) \
  {                                                         \
    this->Set##name##Ids(std::vector<vtkIdType>(ids));      \
  }
#else
#define vtkDGGSetIdsFromBracesMacro(name)
#endif

/// Sets and counts the point ids in the std::vector NameIds; a null list is an empty list.
#define vtkDGGSetIdsMacro(name)                                                           \
  void Set##name##Ids(vtkIdList* ids)                                                     \
  {                                                                                       \
    this->Set##name##Ids(                                                                 \
      ids ? std::vector<vtkIdType>(ids->begin(), ids->end()) : std::vector<vtkIdType>()); \
  }                                                                                       \
  void Set##name##Ids(const std::vector<vtkIdType>& ids)                                  \
  {                                                                                       \
    if (this->name##Ids != ids)                                                           \
    {                                                                                     \
      this->name##Ids = ids;                                                              \
      this->Modified();                                                                   \
    }                                                                                     \
  }                                                                                       \
  vtkDGGSetIdsFromBracesMacro(name);                                                      \
  vtkIdType GetNumberOf##name##Ids() const                                                \
  {                                                                                       \
    return static_cast<vtkIdType>(this->name##Ids.size());                                \
  }

/// vtkDGGSetIdsMacro() and access by index: -1 if there is no i-th id.
#define vtkDGGIdsMacro(name)                                                                     \
  vtkDGGSetIdsMacro(name);                                                                       \
  void Add##name##Id(vtkIdType id)                                                               \
  {                                                                                              \
    this->name##Ids.push_back(id);                                                               \
    this->Modified();                                                                            \
  }                                                                                              \
  void RemoveAll##name##Ids()                                                                    \
  {                                                                                              \
    this->Set##name##Ids(std::vector<vtkIdType>());                                              \
  }                                                                                              \
  vtkIdType Get##name##Id(vtkIdType i) const VTK_EXPECTS(0 <= i && i < GetNumberOf##name##Ids()) \
  {                                                                                              \
    return i >= 0 && i < this->GetNumberOf##name##Ids() ? this->name##Ids[i] : -1;               \
  }

/// Defines the getter of the name of a property whose values are 0, 1, ...
#define vtkDGGAsStringMacro(Class, Property, ...)       \
  const char* Class::Get##Property##AsString() const    \
  {                                                     \
    static const char* const names[] = { __VA_ARGS__ }; \
    return names[this->Property];                       \
  }

/// Declares Accuracy, AcceptCoarserGraph and values of the graph of the last update, which the
/// filters document. vtkDGGGraphUserMacro() defines the functions.
#define vtkDGGGraphPropertiesMacro()               \
  virtual void SetAccuracy(double accuracy);       \
  double GetAccuracy() const;                      \
  virtual void SetAcceptCoarserGraph(bool accept); \
  bool GetAcceptCoarserGraph() const;              \
  vtkBooleanMacro(AcceptCoarserGraph, bool);       \
  bool GetUsedInputGraph() const;                  \
  double GetGraphAccuracy() const;                 \
  vtkIdType GetNumberOfGraphEdges() const;         \
  vtkTypeUInt64 GetMemorySize() const;             \
  bool GetGraphIsGuaranteed() const;               \
  vtkMTimeType GetGraphBuildTime() const

#endif
