# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Run a program; check the exit code and what it prints:
#   cmake -DEXIT_CODE=0 -DEXPECTED=<regex> -P RunAndMatch.cmake -- PROGRAM ARGUMENTS
set(command)
set(found OFF)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach (i RANGE ${last})
  if (found)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif (CMAKE_ARGV${i} STREQUAL "--")
    set(found ON)
  endif ()
endforeach ()
execute_process(
  COMMAND ${command}
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE output)
message(STATUS "${output}")
if (NOT result STREQUAL EXIT_CODE)
  message(FATAL_ERROR "exit code ${result}, expected ${EXIT_CODE}")
endif ()
if (NOT output MATCHES "${EXPECTED}")
  message(FATAL_ERROR "the output does not match ${EXPECTED}")
endif ()
