# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# The target DGG::FLANN: what the kernel of point clouds is linked to. For the build, and for those
# who link to the installed kernel, on another machine perhaps: no path of this one is installed.
# Sets DGG_FLANN_FOUND. Where it is not found, the names alone are left to the linker.
find_library(DGG_FLANN_LIBRARY flann_cpp)
# FLANN's headers, not its library, call it.
find_library(DGG_LZ4_LIBRARY lz4)
mark_as_advanced(DGG_FLANN_LIBRARY DGG_LZ4_LIBRARY)
set(DGG_FLANN_FOUND FALSE)
if (DGG_FLANN_LIBRARY AND DGG_LZ4_LIBRARY)
  set(DGG_FLANN_FOUND TRUE)
endif ()
if (NOT TARGET DGG::FLANN)
  add_library(DGG::FLANN INTERFACE IMPORTED GLOBAL)
  if (DGG_FLANN_FOUND)
    target_link_libraries(DGG::FLANN INTERFACE "${DGG_FLANN_LIBRARY}" "${DGG_LZ4_LIBRARY}")
  else ()
    target_link_libraries(DGG::FLANN INTERFACE flann_cpp lz4)
  endif ()
endif ()
