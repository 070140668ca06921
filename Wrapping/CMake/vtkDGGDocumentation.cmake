# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Target doc: reference of all public headers and the pages, written to the folder html of the build
# tree. Warnings go to doc.log.

set(doc_inputs)
foreach (folder IN ITEMS Filters/Geodesic Filters/PointCloud Filters/Spectral Readers)
  list(APPEND doc_inputs "${folder}/README.md")
  if (folder STREQUAL "Filters/PointCloud" AND NOT DGG_WITH_PCL)
    continue ()
  endif ()
  # As the module lists them.
  get_directory_property(classes DIRECTORY "${folder}" DEFINITION classes)
  get_directory_property(headers DIRECTORY "${folder}" DEFINITION nowrap_headers)
  list(TRANSFORM classes APPEND ".h")
  foreach (header IN LISTS classes headers)
    list(APPEND doc_inputs "${folder}/${header}")
  endforeach ()
endforeach ()
list(APPEND doc_inputs
  README.md
  CHANGELOG.md
  Examples/README.md
  Examples/Solved.md
  Examples/Tutorial.md
  ${dgg_pages})
list(REMOVE_DUPLICATES doc_inputs)

set(DOXYGEN_USE_MDFILE_AS_MAINPAGE "${CMAKE_CURRENT_SOURCE_DIR}/README.md")
set(DOXYGEN_IMAGE_PATH Examples/Images Testing/Baseline Testing/Benchmark/Images)
# GitHub and Doxygen derive different anchors from headings.
set(DOXYGEN_FILTER_PATTERNS
  "*.md=sed -E -f ${CMAKE_CURRENT_SOURCE_DIR}/Wrapping/CMake/vtkDGGAnchors.sed")
# One comment documents all members between ///@{ and ///@}.
set(DOXYGEN_DISTRIBUTE_GROUP_DOC YES)
# Methods that VTK documents.
set(DOXYGEN_EXCLUDE_SYMBOLS
  FillInputPortInformation FillOutputPortInformation New PrintSelf ProcessRequest RequestData WriteData
  vtkDGG::Detail)
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_EXPAND_AS_DEFINED vtkDGGGraphPropertiesMacro)
set(DOXYGEN_PREDEFINED
  "vtkAbstractTypeMacro(thisClass,superclass)="
  "vtkTypeMacro(thisClass,superclass)="
  "vtkBooleanMacro(name,type)=virtual void name##On(), name##Off()"
  "vtkGetMacro(name,type)=virtual type Get##name()"
  "vtkGetFilePathMacro(name)=virtual char* Get##name()"
  "vtkSetMacro(name,type)=virtual void Set##name(type)"
  "vtkSetClampMacro(name,type,min,max)=virtual void Set##name(type)"
  "vtkSetFilePathMacro(name)=virtual void Set##name(const char*)"
  "VTK_EXPECTS(x)="
  "VTK_SIZEHINT(x)="
  "VTKDGGFILTERSGEODESIC_EXPORT="
  "VTKDGGFILTERSPOINTCLOUD_EXPORT="
  "VTKDGGFILTERSSPECTRAL_EXPORT="
  "VTKDGGREADERS_EXPORT=")
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_WARN_LOGFILE "${CMAKE_CURRENT_BINARY_DIR}/doc.log")
doxygen_add_docs(doc ${doc_inputs})
