#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build the benchmark programs, run one beside the peers, and make tables of it. Missing Debian
# packages are installed first.
#
# Usage: Testing/Benchmark/run.sh [exact] [--out DIR] [MESH...] [OPTIONS OF BenchmarkExact]
#        Testing/Benchmark/run.sh first [--out DIR] [--data DIR] [--readme] MESH...
#        Testing/Benchmark/run.sh graph [--out DIR] [--readme] [MESH...] [OPTIONS OF BenchmarkGraph]
#        Testing/Benchmark/run.sh local [--out DIR] [--readme] [NUMBER-OF-POINTS...]
#        Testing/Benchmark/run.sh path [--out DIR] [--data DIR] [MESH...] [OPTIONS OF BenchmarkPath]
#        Testing/Benchmark/run.sh isolines [--out DIR] [--data DIR] [MESH...]
#                                 [OPTIONS OF BenchmarkIsolines]
#        Testing/Benchmark/run.sh cloud [--out DIR] [--data DIR] [--full] [--readme] [MESH...]
#                                 [OPTIONS OF BenchmarkCloud]
#        Testing/Benchmark/run.sh spectral [--out DIR] [--data DIR] [--libigl DIR] [--readme]
#                                 [MESH...] [OPTIONS OF BenchmarkSpectral]
#        Testing/Benchmark/run.sh thesis [--out DIR] [--data DIR] [--full] [--keep] [--readme]
#                                 [--exhibits LIST]
#        Testing/Benchmark/run.sh passrate [--out DIR] FOLDER [--accuracies 0.1,0.01,0.001]
#        Testing/Benchmark/run.sh compare [--out DIR] MESH [OPTIONS OF vtkdgg compare]
#   exact     the exact solver: writes exact.json and exact.md
#   first     how soon each distance filter answers on a new mesh, and again: writes first.json and
#             first.md
#   graph     graphs of all rules and accuracies, and queries of them: writes graph.json, graph.md
#             and error_against_degree.png (needs matplotlib)
#   local     queries about a few points on meshes of growing size, beside SciPy and gdist: writes
#             local.json and local.md
#   path      what a graph gives: paths, samples, Voronoi cells, a matrix, loops: writes path.json
#             and path.md
#   isolines  isolines and approximate distances: writes isolines.json and isolines.md
#   cloud     graphs of point clouds: their errors with all schemes, fast marching beside, clouds
#             that are not easy, parameters varied, and what 200K points take; the vertices of
#             meshes are measured as clouds: writes cloud.json, cloud.md and cloud_error.png (needs
#             matplotlib)
#   spectral  Green's functions and what is made of them: times and memory beside other libraries,
#             errors on spheres: writes spectral.json, spectral.md and greens_convergence.png (needs
#             matplotlib)
#   thesis    the tables and figures of the thesis, published figures beside ours: writes a folder
#             thesis with JSON and pictures, and thesis.md there (needs matplotlib)
#   passrate  whether graphs of all meshes of a folder keep their promise: writes passrate.json,
#             passrate.md and passrate.png
#   compare   the errors of all methods on one mesh, as maps and histograms: writes a folder compare
#             with methods.png
#   --out     folder of the results (default: out/benchmark in the source tree)
#   --data    folder with bunny, armadillo, fertility, kitten and gargoyle (.ply), for isolines igea
#             as well, to be measured; for first with bunny, armadillo, gargoyle, fandisk,
#             blade_aniso, igea and terrain_andes; for clouds with igea, terrain_andes (a
#             grid) and awkward/bunny_raw_5holes; for spectral with bunny and igea; for thesis with
#             any of fertility, kitten, gargoyle, bunny, armadillo and blade_aniso
#   --full    of clouds: a sphere of 655K points as well, which takes about ten minutes more; of
#             the thesis: larger models, which takes hours; exhibits that are finished are kept
#   --keep    of the thesis: keep finished exhibits of earlier runs without --full as well
#   --exhibits  of the thesis: only these, T3.4,F3.9,...
#   --libigl  folder with the headers of libigl, as a further peer of spectral
#   --readme  put the tables into Testing/Benchmark/README.md and the plot into Examples/Images as
#             well: first and local (no plot), graph, cloud, spectral; for spectral, draw
#             Examples/Images/greens_function.png too; for thesis, write Testing/Benchmark/Thesis.md
#             and its pictures to Testing/Benchmark/Images
# For example:
#   Testing/Benchmark/run.sh
#   Testing/Benchmark/run.sh scan.ply --growth=none --benchmark_filter=/T/
#   Testing/Benchmark/run.sh graph --readme
#   Testing/Benchmark/run.sh path scan.ply --pairs=100 --matrix=0
#   Testing/Benchmark/run.sh isolines scan.ply --sizes=1000,10000 --sources=0
#   Testing/Benchmark/run.sh cloud scan.ply --clouds= --curves=0 --guards=0 --speed=0
#   Testing/Benchmark/run.sh spectral scan.ply --sizes= --levels=
#   Testing/Benchmark/run.sh thesis --exhibits T3.2,F3.9
#   Testing/Benchmark/run.sh graph scan.ply --rules=Guaranteed,SVG --accuracies=0.02 --many=0

set -euo pipefail

if [ "${1:-}" = -h ] || [ "${1:-}" = --help ]; then
  sed -n '/^# Build the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi

source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"

here="$DGG_ROOT/Testing/Benchmark"
mode=exact
case "${1:-}" in
  cloud | compare | exact | first | graph | isolines | local | passrate | path | spectral | thesis)
    mode="$1"
    shift
    ;;
esac
out="$DGG_ROOT/out/benchmark"
readme=
libigl=
arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    --out)
      [ $# -ge 2 ] || dgg_fail "--out needs a folder"
      out="$2"
      shift 2
      ;;
    --data)
      names=(bunny armadillo fertility kitten gargoyle)
      [ $# -ge 2 ] || dgg_fail "--data needs a folder"
      case "$mode" in
        cloud)
          names=(awkward/bunny_raw_5holes igea)
          arguments+=("--terrain=$2/terrain_andes.ply" "--speed_mesh=$2/terrain_andes.ply")
          ;;
        first) names=(bunny armadillo gargoyle fandisk blade_aniso igea terrain_andes) ;;
        isolines) names+=(igea) ;;
        path) ;;
        spectral) names=(bunny igea) ;;
        thesis)
          names=()
          arguments+=(--data "$2")
          ;;
        *) dgg_fail "--data is for the modes cloud, first, isolines, path, spectral and thesis" ;;
      esac
      for name in ${names[@]+"${names[@]}"}; do
        arguments+=("$2/$name.ply")
      done
      shift 2
      ;;
    --full)
      case "$mode" in
        cloud) arguments+=("--large=sphere:655362") ;;
        thesis) arguments+=(--full) ;;
        *) dgg_fail "--full is for the modes cloud and thesis" ;;
      esac
      shift
      ;;
    --libigl)
      [ $# -ge 2 ] || dgg_fail "--libigl needs a folder"
      [ "$mode" = spectral ] || dgg_fail "--libigl is for the mode spectral"
      libigl="$(cd "$2" && pwd)"
      shift 2
      ;;
    --readme)
      case "$mode" in
        cloud | first | graph | local | spectral | thesis) readme=yes ;;
        *) dgg_fail "--readme is for the modes cloud, first, graph, local, spectral and thesis" ;;
      esac
      shift
      ;;
    *)
      arguments+=("$1")
      shift
      ;;
  esac
done

# measure PROGRAM RESULT: run a program with the remaining arguments.
measure() {
  "$build/bin/$1" --benchmark_out="$2" --benchmark_out_format=json \
    ${arguments[@]+"${arguments[@]}"}
  echo
}

measure_exact() {
  measure BenchmarkExact "$out/exact.json"
  "$python" "$here/summarize.py" "$out/exact.json" "$out/exact.md"
  echo "Written: $out/exact.json and $out/exact.md"
}

# measure_in_python SCRIPT: the mode by a script with the remaining arguments.
measure_in_python() {
  "$build/bin/vtkdgg-python" "$here/$1" "$out/$mode.json" "$out/$mode.md" \
    ${arguments[@]+"${arguments[@]}"}
  echo "Written: $out/$mode.json and $out/$mode.md"
  if [ -n "$readme" ]; then
    "$python" "$here/insert_table.py" "$here/README.md" "$mode" "$out/$mode.md"
    echo "Written: Testing/Benchmark/README.md"
  fi
}

measure_first() {
  measure_in_python first_answer.py
}

measure_local() {
  measure_in_python local_queries.py
}

measure_graph() {
  local plot="$out/error_against_degree.png"
  measure BenchmarkGraph "$out/graph.json"
  "$python" "$here/summarize_graph.py" "$out/graph.json" "$out/graph.md"
  "$python" "$here/plot_graph.py" "$out/graph.json" "$plot"
  echo "Written: $out/graph.json, $out/graph.md and $plot"
  if [ -n "$readme" ]; then
    cp "$plot" "$DGG_ROOT/Examples/Images/error_against_degree.png"
    "$python" "$here/insert_table.py" "$here/README.md" graph "$out/graph.md"
    echo "Written: Testing/Benchmark/README.md and Examples/Images/error_against_degree.png"
  fi
}

measure_path() {
  measure BenchmarkPath "$out/path.json"
  "$python" "$here/summarize_path.py" "$out/path.json" "$out/path.md"
  echo "Written: $out/path.json and $out/path.md"
}

measure_isolines() {
  measure BenchmarkIsolines "$out/isolines.json"
  "$python" "$here/summarize_isolines.py" "$out/isolines.json" "$out/isolines.md"
  echo "Written: $out/isolines.json and $out/isolines.md"
}

measure_cloud() {
  local plot="$out/cloud_error.png"
  measure BenchmarkCloud "$out/cloud.json"
  "$python" "$here/summarize_cloud.py" "$out/cloud.json" "$out/cloud.md"
  echo "Written: $out/cloud.json and $out/cloud.md"
  if [ -n "$readme" ]; then
    "$python" "$here/insert_table.py" "$here/README.md" cloud "$out/cloud.md"
    echo "Written: Testing/Benchmark/README.md"
  fi
  # There is nothing to plot without curves.
  if "$python" "$here/plot_cloud.py" "$out/cloud.json" "$plot"; then
    echo "Written: $plot"
    if [ -n "$readme" ]; then
      cp "$plot" "$DGG_ROOT/Examples/Images/cloud_error.png"
      echo "Written: Examples/Images/cloud_error.png"
    fi
  fi
}

measure_spectral() {
  local plot="$out/greens_convergence.png"
  # BLAS below CHOLMOD: one thread, as all others have.
  OPENBLAS_NUM_THREADS=1 measure BenchmarkSpectral "$out/spectral.json"
  "$python" "$here/summarize_spectral.py" "$out/spectral.json" "$out/spectral.md"
  echo "Written: $out/spectral.json and $out/spectral.md"
  if [ -n "$readme" ]; then
    "$python" "$here/insert_table.py" "$here/README.md" spectral "$out/spectral.md"
    dgg_with_display "$build/bin/vtkdgg-python" "$DGG_ROOT/Examples/Python/greens_function.py" \
      "$DGG_ROOT/Examples/Images/greens_function.png"
    echo "Written: Testing/Benchmark/README.md and Examples/Images/greens_function.png"
  fi
  # There is nothing to plot without spheres.
  if "$python" "$here/plot_spectral.py" "$out/spectral.json" "$plot"; then
    echo "Written: $plot"
    if [ -n "$readme" ]; then
      cp "$plot" "$DGG_ROOT/Examples/Images/greens_convergence.png"
      echo "Written: Examples/Images/greens_convergence.png"
    fi
  fi
}

measure_thesis() {
  local page=()
  if [ -n "$readme" ]; then
    page=(--page "$here/Thesis.md" --pictures "$here/Images" --images Images)
  fi
  dgg_with_display "$build/bin/vtkdgg-python" "$here/thesis.py" --out "$out/thesis" \
    --programs "$build/bin" ${page[@]+"${page[@]}"} ${arguments[@]+"${arguments[@]}"}
}

measure_passrate() {
  "$build/bin/vtkdgg-python" "$here/passrate.py" "$out" ${arguments[@]+"${arguments[@]}"}
}

measure_compare() {
  dgg_with_display "$build/bin/vtkdgg" compare --methods --out "$out/compare" \
    ${arguments[@]+"${arguments[@]}"}
}

packages=("${DGG_PACKAGES[@]}" libbenchmark-dev libcgal-dev libeigen3-dev glmark2-data)
case "$mode" in
  cloud | graph | passrate | thesis) packages+=(python3-matplotlib) ;;
  local) packages+=(python3-scipy) ;;
  spectral) packages+=(python3-matplotlib libsuitesparse-dev) ;;
esac
with_python=OFF
[ "$mode" = spectral ] && [ -n "$readme" ] && with_python=ON
case "$mode" in
  compare | first | local | passrate | thesis) with_python=ON ;;
esac
dgg_install "${packages[@]}"

build="$DGG_ROOT/build/benchmark"
dgg_build "$build" \
  -DCMAKE_BUILD_TYPE=Release \
  -DBUILD_TESTING=OFF \
  -DDGG_WITH_PYTHON="$with_python" \
  -DDGG_PEER_LIBIGL_DIR="$libigl" \
  -DDGG_BUILD_BENCHMARKS=ON

# The Python that apt's packages are for, if there is one.
python="$(command -v /usr/bin/python3 || command -v python3)"
mkdir -p "$out"
"measure_$mode"
