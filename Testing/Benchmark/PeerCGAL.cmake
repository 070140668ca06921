# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# dggPeerCGAL: CGAL's exact geodesics, for tests and benchmarks; dggPeerHeat: its heat method, if
# Eigen's solvers are available. CGAL adds compiler flags, and its license is the GPL.
include("${CMAKE_CURRENT_LIST_DIR}/PeerLibrary.cmake")

if (CGAL_FOUND AND NOT TARGET dggPeerCGAL)
  dgg_add_peer(dggPeerCGAL CGAL::CGAL PeerCGAL.cxx PeerCGAL.h PeerCGALSurface.h)
endif ()

if (CGAL_FOUND AND NOT TARGET dggPeerHeat)
  find_package(Eigen3 QUIET NO_MODULE)
  if (TARGET Eigen3::Eigen)
    dgg_add_peer(dggPeerHeat CGAL::CGAL PeerHeat.cxx PeerHeat.h PeerCGALSurface.h)
    target_compile_definitions(dggPeerHeat PRIVATE CGAL_EIGEN3_ENABLED)
    target_link_libraries(dggPeerHeat PRIVATE Eigen3::Eigen)
    # CGAL 5.5 swaps an uninitialized flag, which the sanitizer of undefined behavior reports.
    target_compile_options(dggPeerHeat PRIVATE -fno-sanitize=bool)
  endif ()
endif ()
