# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Doxygen has nothing to warn of:
#   cmake -DBUILD=<build tree> -P CheckDocumentation.cmake
file(REMOVE "${BUILD}/doc.log")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" --target doc
  OUTPUT_QUIET
  RESULT_VARIABLE result)
file(READ "${BUILD}/doc.log" warnings)
if (NOT result EQUAL 0 OR NOT warnings STREQUAL "")
  message(FATAL_ERROR "exit code ${result}\n${warnings}")
endif ()
if (NOT EXISTS "${BUILD}/html/classvtkDGGDistance.html")
  message(FATAL_ERROR "there is no page of vtkDGGDistance")
endif ()
