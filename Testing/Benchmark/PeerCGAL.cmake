# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# dggPeerCGAL: CGAL's exact geodesics, for tests and benchmarks. A library of its own, because CGAL
# adds compiler flags, and because its licence (GPL) must stay away from what is installed.
if (CGAL_FOUND AND NOT TARGET dggPeerCGAL)
  add_library(dggPeerCGAL STATIC EXCLUDE_FROM_ALL
    "${CMAKE_CURRENT_LIST_DIR}/PeerCGAL.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/PeerCGAL.h")
  target_include_directories(dggPeerCGAL PUBLIC "${CMAKE_CURRENT_LIST_DIR}")
  target_compile_options(dggPeerCGAL PRIVATE ${dgg_warning_flags})
  target_link_libraries(dggPeerCGAL PUBLIC dggCore PRIVATE CGAL::CGAL)
endif ()
