#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build with tests and run them. Missing Debian packages are installed first.
#
# Usage: Testing/test.sh [--all] [CTEST ARGUMENTS]
#   --all                  also run long tests, comparisons with other libraries, the examples, the
#                          installation, the benchmarks and, if ParaView is available, its plugin
#   DGG_EXTRA_DATA=FOLDER  with --all, also test the real meshes in that folder

set -euo pipefail

if [ "${1:-}" = -h ] || [ "${1:-}" = --help ]; then
  sed -n '/^# Build with/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi

source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

packages=("${DGG_PACKAGES[@]}" libgtest-dev python3-scipy)
all=OFF
extra_data=
if [ "${1:-}" = --all ]; then
  shift
  all=ON
  extra_data="${DGG_EXTRA_DATA:-}"
  # Boost's graphs, CGAL and CHOLMOD are independent implementations to check against; Doxygen checks
  # comments; CPack runs the program file.
  packages+=(libbenchmark-dev libboost-graph-parallel-dev libboost-mpi-dev libcgal-dev
    libsuitesparse-dev doxygen file glmark2-data python3-venv)
fi
dgg_install "${packages[@]}"
if [ -n "$extra_data" ]; then
  extra_data="$(cd "$extra_data" && pwd)" || dgg_fail "DGG_EXTRA_DATA is not a folder"
fi

build="$DGG_ROOT/build/test"
dgg_build "$build" \
  -DCMAKE_BUILD_TYPE=Release \
  -DBUILD_TESTING=ON \
  -DDGG_TEST_ALL="$all" \
  -DDGG_BUILD_BENCHMARKS="$all" \
  -DDGG_EXTRA_DATA="$extra_data"
dgg_with_display ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"

if [ "$all" = ON ]; then
  # With the kernel that is built already: the plugin does not build it again for another VTK.
  status=0
  "$DGG_ROOT/Wrapping/ParaView/paraview.sh" --test -DDGG_KERNEL_FROM="$build" || status=$?
  [ "$status" -ne 3 ] || echo "Skipped: the plugin for ParaView"
  [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || exit "$status"
fi
