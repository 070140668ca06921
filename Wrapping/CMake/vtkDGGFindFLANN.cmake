# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# Target DGG::FLANN, to which the kernel of point clouds links. Used by the build and by programs
# that link to the installed kernel, possibly on another machine: no paths are installed.
# Sets DGG_FLANN_FOUND. If FLANN is not found, the linker searches its libraries by name.
find_library(DGG_FLANN_LIBRARY flann_cpp)
# Only FLANN's headers call LZ4.
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
