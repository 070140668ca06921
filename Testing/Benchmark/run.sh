#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build the benchmark program, run it beside the peers, and make a table of it. Missing Debian
# packages are installed first.
#
# Usage: Testing/Benchmark/run.sh [--out DIR] [MESH...] [OPTIONS OF BenchmarkExact]
#   --out DIR  where exact.json and exact.md go (default: out/benchmark in the source tree)
# For example:
#   Testing/Benchmark/run.sh
#   Testing/Benchmark/run.sh scan.ply --growth=none --benchmark_filter=/T/

set -euo pipefail

if [ "${1:-}" = -h ] || [ "${1:-}" = --help ]; then
  sed -n '/^# Build the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi

source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"

out="$DGG_ROOT/out/benchmark"
arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    --out)
      [ $# -ge 2 ] || dgg_fail "--out needs a folder"
      out="$2"
      shift 2
      ;;
    *)
      arguments+=("$1")
      shift
      ;;
  esac
done

dgg_install "${DGG_PACKAGES[@]}" libbenchmark-dev libcgal-dev glmark2-data

build="$DGG_ROOT/build/benchmark"
dgg_build "$build" \
  -DCMAKE_BUILD_TYPE=Release \
  -DBUILD_TESTING=OFF \
  -DDGG_WITH_PYTHON=OFF \
  -DDGG_BUILD_BENCHMARKS=ON

mkdir -p "$out"
"$build/bin/BenchmarkExact" \
  --benchmark_out="$out/exact.json" --benchmark_out_format=json \
  ${arguments[@]+"${arguments[@]}"}
echo
python3 "$(dirname "${BASH_SOURCE[0]}")/summarize.py" "$out/exact.json" "$out/exact.md"
echo "Written: $out/exact.json and $out/exact.md"
