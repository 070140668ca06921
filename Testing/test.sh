#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build with tests and run them. Missing Debian packages are installed first.
#
# Usage: Testing/test.sh [--all] [CTEST ARGUMENTS]
#   --all                  also what takes long, independent implementations, the examples, the
#                          installation and the benchmarks
#   DGG_EXTRA_DATA=FOLDER  with --all, also the real meshes of that folder

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
  # CGAL and CHOLMOD are independent implementations to check against; Doxygen checks comments.
  packages+=(libbenchmark-dev libcgal-dev libsuitesparse-dev doxygen glmark2-data)
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
