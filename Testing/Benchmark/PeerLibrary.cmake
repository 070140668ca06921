# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# dgg_add_peer(NAME LIBRARY SOURCES...): adds another library's implementation of a task of the
# kernel, for tests and benchmarks. It is a separate static library, so that compiler flags and
# licenses of LIBRARY do not affect installed files.
function (dgg_add_peer name library)
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/")
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${ARGN}
    "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/MeshArrays.h")
  target_include_directories(${name} PUBLIC "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  target_compile_options(${name} PRIVATE ${dgg_warning_flags})
  target_link_libraries(${name} PUBLIC dggCore PRIVATE ${library})
endfunction ()
