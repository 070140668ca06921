# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# dggPeerCGAL: CGAL's exact geodesics, for tests and benchmarks; dggPeerHeat: its heat method, where
# Eigen's solvers are there too. Libraries of their own, because CGAL adds compiler flags, and
# because its licence (GPL) must stay away from what is installed.
function (dgg_add_peer name)
  add_library(${name} STATIC EXCLUDE_FROM_ALL
    ${ARGN}
    "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/MeshArrays.h"
    "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/PeerCGALSurface.h")
  target_include_directories(${name} PUBLIC "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  target_compile_options(${name} PRIVATE ${dgg_warning_flags})
  target_link_libraries(${name} PUBLIC dggCore PRIVATE CGAL::CGAL)
endfunction ()

if (CGAL_FOUND AND NOT TARGET dggPeerCGAL)
  dgg_add_peer(dggPeerCGAL
    "${CMAKE_CURRENT_LIST_DIR}/PeerCGAL.cxx"
    "${CMAKE_CURRENT_LIST_DIR}/PeerCGAL.h")
endif ()

if (CGAL_FOUND AND NOT TARGET dggPeerHeat)
  find_package(Eigen3 3.3 QUIET NO_MODULE)
  if (TARGET Eigen3::Eigen)
    dgg_add_peer(dggPeerHeat
      "${CMAKE_CURRENT_LIST_DIR}/PeerHeat.cxx"
      "${CMAKE_CURRENT_LIST_DIR}/PeerHeat.h")
    target_compile_definitions(dggPeerHeat PRIVATE CGAL_EIGEN3_ENABLED)
    target_link_libraries(dggPeerHeat PRIVATE Eigen3::Eigen)
  endif ()
endif ()
