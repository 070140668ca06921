#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build with tests and run all of them. Missing Debian packages are installed first.
#
# Usage: Testing/test.sh [CTEST ARGUMENTS]
#   DGG_EXTRA_DATA=FOLDER  also test on the real meshes of that folder

set -euo pipefail

if [ "${1:-}" = -h ] || [ "${1:-}" = --help ]; then
  sed -n '/^# Build with/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi

source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# CGAL, CHOLMOD and SciPy are independent implementations to check against; Doxygen checks comments.
dgg_install "${DGG_PACKAGES[@]}" libgtest-dev libbenchmark-dev libcgal-dev libsuitesparse-dev \
  doxygen python3-scipy glmark2-data

extra_data="${DGG_EXTRA_DATA:-}"
if [ -n "$extra_data" ]; then
  extra_data="$(cd "$extra_data" && pwd)" || dgg_fail "DGG_EXTRA_DATA is not a folder"
fi

build="$DGG_ROOT/build/test"
dgg_build "$build" \
  -DCMAKE_BUILD_TYPE=Release \
  -DBUILD_TESTING=ON \
  -DDGG_BUILD_BENCHMARKS=ON \
  -DDGG_EXTRA_DATA="$extra_data"
dgg_with_display ctest --test-dir "$build" --output-on-failure -j "$(nproc)" "$@"
