# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause

# dggPeerCholmod: CHOLMOD's sparse factorization, if installed (Debian: libsuitesparse-dev); a part
# of it is under the GPL. dggPeerLibigl: libigl's cotangent matrix and solver, if
# DGG_PEER_LIBIGL_DIR is set.
include("${CMAKE_CURRENT_LIST_DIR}/PeerLibrary.cmake")

set(DGG_PEER_LIBIGL_DIR "" CACHE PATH
  "Folder with the headers of libigl (igl/cotmatrix.h) to compare with in benchmarks")
find_library(DGG_CHOLMOD_LIBRARY cholmod)
find_path(DGG_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
mark_as_advanced(DGG_CHOLMOD_LIBRARY DGG_CHOLMOD_INCLUDE_DIR)

if (DGG_CHOLMOD_LIBRARY AND DGG_CHOLMOD_INCLUDE_DIR AND NOT TARGET dggPeerCholmod)
  file(STRINGS "${DGG_CHOLMOD_INCLUDE_DIR}/cholmod_core.h" dgg_cholmod_lines
    REGEX "define CHOLMOD_(MAIN|SUB|SUBSUB)_VERSION +[0-9]+")
  string(REGEX MATCHALL "[0-9]+" DGG_CHOLMOD_VERSION "${dgg_cholmod_lines}")
  string(REPLACE ";" "." DGG_CHOLMOD_VERSION "${DGG_CHOLMOD_VERSION}")
  dgg_add_peer(dggPeerCholmod "${DGG_CHOLMOD_LIBRARY}" PeerCholmod.cxx PeerPoisson.h)
  target_compile_definitions(dggPeerCholmod PUBLIC DGG_WITH_CHOLMOD
    "DGG_BENCHMARK_CHOLMOD=\"${DGG_CHOLMOD_VERSION}\"")
  target_include_directories(dggPeerCholmod SYSTEM PRIVATE "${DGG_CHOLMOD_INCLUDE_DIR}")
  target_link_libraries(dggPeerCholmod PRIVATE Eigen3::Eigen)
endif ()

if (DGG_PEER_LIBIGL_DIR AND NOT TARGET dggPeerLibigl)
  if (NOT EXISTS "${DGG_PEER_LIBIGL_DIR}/igl/cotmatrix.h")
    message(FATAL_ERROR "DGG_PEER_LIBIGL_DIR (${DGG_PEER_LIBIGL_DIR}) has no igl/cotmatrix.h: name "
      "the folder `include` of libigl's sources, or leave it empty.")
  endif ()
  dgg_add_peer(dggPeerLibigl Eigen3::Eigen PeerLibigl.cxx PeerPoisson.h)
  target_compile_definitions(dggPeerLibigl PUBLIC DGG_WITH_LIBIGL)
  target_include_directories(dggPeerLibigl SYSTEM PRIVATE "${DGG_PEER_LIBIGL_DIR}")
endif ()
