#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build the benchmark programs, run one of them and its peers, and write tables of the results.
# Missing Debian packages are installed first.
#
# Usage: Testing/Benchmark/run.sh [exact] [--out DIR] [MESH...] [OPTIONS OF BenchmarkExact]
#        Testing/Benchmark/run.sh first [--out DIR] [--data DIR] [--readme] MESH...
#        Testing/Benchmark/run.sh graph [--out DIR] [--readme] [MESH...] [OPTIONS OF BenchmarkGraph]
#        Testing/Benchmark/run.sh local [--out DIR] [--readme] [NUMBER-OF-POINTS...]
#        Testing/Benchmark/run.sh path [--out DIR] [--data DIR] [MESH...] [OPTIONS OF BenchmarkPath]
#        Testing/Benchmark/run.sh isolines [--out DIR] [--data DIR] [MESH...]
#                                 [OPTIONS OF measure_isolines.py]
#        Testing/Benchmark/run.sh parts [--out DIR] [PART or MESH...] [OPTIONS OF measure_parts.py]
#        Testing/Benchmark/run.sh peers [--out DIR] [--data DIR] [--readme] [MESH...]
#                                 [OPTIONS OF measure_peers.py]
#        Testing/Benchmark/run.sh cloud [--out DIR] [--data DIR] [--full] [--readme] [MESH...]
#                                 [OPTIONS OF measure_clouds.py]
#        Testing/Benchmark/run.sh spectral [--out DIR] [--data DIR] [--libigl DIR] [--readme]
#                                 [MESH...] [OPTIONS OF BenchmarkSpectral]
#        Testing/Benchmark/run.sh spheres [--out DIR] [--readme] [OPTIONS OF measure_spheres.py]
#        Testing/Benchmark/run.sh thesis [--out DIR] [--data DIR] [--full] [--keep] [--readme]
#                                 [--exhibits LIST]
#        Testing/Benchmark/run.sh passrate [--out DIR] FOLDER [OPTIONS OF passrate.py]
#        Testing/Benchmark/run.sh compare [--out DIR] MESH [OPTIONS OF vtkdgg compare]
#   exact     the exact solver: writes exact.json and exact.md
#   first     time of each distance filter to the first answer on a new mesh, and to further ones:
#             writes first.json and first.md
#   graph     graphs of all rules and accuracies, and their queries: writes graph.json, graph.md
#             and error_against_degree.png (needs matplotlib)
#   local     local queries on meshes of growing size, compared with SciPy and gdist: writes
#             local.json and local.md
#   path      paths, samples, Voronoi cells and a matrix by graphs: writes path.json
#             and path.md
#   isolines  isolines by all methods and vtkContourFilter: writes isolines.json and isolines.md
#   parts     errors inside the faces of generated machine parts: probes, isolines, ridges and Voronoi
#             borders by graphs, and virtual sources; on meshes only virtual sources: writes
#             parts.json and parts.md
#   peers     Python packages that compute geodesics, ours among them, in a virtual environment in
#             the folder of the results: writes peers.json and peers.md
#   cloud     graphs of point clouds: errors with all schemes and of fast marching, difficult
#             clouds, varied parameters, and the cost at 200K points; the vertices of meshes are
#             measured as clouds: writes cloud.json, cloud.md and cloud_error.png (needs
#             matplotlib)
#   spectral  Green's functions and quantities based on them: times and memory, compared with other
#             libraries: writes spectral.json and spectral.md
#   spheres   errors of Green's functions and B-splines on spheres: writes spheres.json, spheres.md
#             and greens_convergence.png (needs matplotlib)
#   thesis    the tables and figures of the thesis, published values and ours: writes a folder
#             thesis with JSON, pictures and thesis.md (needs matplotlib)
#   passrate  errors of graphs of all meshes in a folder, relative to ε: writes passrate.json,
#             passrate.md and passrate.png
#   compare   the errors of all methods on one mesh, as maps and histograms: writes a folder compare
#             with methods.png
#   --out     folder of the results (default: out/benchmark in the source tree)
#   --data    folder of meshes (.ply) to measure: bunny, armadillo, fertility, kitten and gargoyle,
#             for isolines also igea; for first with bunny, armadillo, gargoyle, fandisk,
#             blade_aniso, igea and terrain_andes; for peers with fandisk, fertility, bunny and
#             igea, in addition to spheres with bumps; for clouds with igea, terrain_andes (a
#             grid) and awkward/bunny_raw_5holes; for spectral with bunny and igea; for thesis with
#             any of fertility, kitten, gargoyle, bunny, armadillo and blade_aniso
#   --full    for cloud: also a sphere of 655K points, which takes about ten minutes more; for
#             thesis: larger models, which takes hours; finished exhibits are kept
#   --keep    for thesis: keep finished exhibits of earlier runs, also without --full
#   --exhibits  for thesis: only these, T3.4,F3.9,...
#   --libigl  folder with the headers of libigl, as a further peer of spectral
#   --readme  also write the tables to Testing/Benchmark/README.md and the plot to Examples/Images:
#             for first, local, peers, spectral (no plot), graph, cloud, spheres; for spectral, also
#             draw Examples/Images/greens_function.png; for thesis, write
#             Testing/Benchmark/Thesis.md and its pictures to Testing/Benchmark/Images
# For example:
#   Testing/Benchmark/run.sh
#   Testing/Benchmark/run.sh scan.ply --growth=none --benchmark_filter=/T/
#   Testing/Benchmark/run.sh graph --readme
#   Testing/Benchmark/run.sh peers scan.ply --generated= --limit=60 --methods=exact,graph
#   Testing/Benchmark/run.sh path scan.ply --pairs=100 --matrix=0
#   Testing/Benchmark/run.sh isolines scan.ply --sizes=1000,10000
#   Testing/Benchmark/run.sh parts 'gear-*' plate-2 scan.ply --accuracies=0.01
#   Testing/Benchmark/run.sh cloud scan.ply --clouds= --curves=0 --guards=0 --speed=0
#   Testing/Benchmark/run.sh spectral scan.ply --sizes=
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
  cloud | compare | exact | first | graph | isolines | local | parts | passrate | path | peers | spectral | spheres | thesis)
    mode="$1"
    shift
    ;;
esac

# Settings of each mode: program, or script that measures; picture of its plot; scans of --data;
# further packages.
program=
script=
picture=
scans=()
packages=("${DGG_PACKAGES[@]}" libbenchmark-dev libcgal-dev libeigen3-dev glmark2-data)
case "$mode" in
  cloud)
    script=measure_clouds.py picture=cloud_error.png
    scans=(awkward/bunny_raw_5holes igea)
    ;;
  exact) program=BenchmarkExact ;;
  first)
    script=measure_first.py
    scans=(bunny armadillo gargoyle fandisk blade_aniso igea terrain_andes)
    ;;
  graph) program=BenchmarkGraph picture=error_against_degree.png ;;
  isolines)
    script=measure_isolines.py
    scans=(bunny armadillo fertility kitten gargoyle igea)
    ;;
  local)
    script=measure_local.py
    packages+=(python3-scipy)
    ;;
  parts) script=measure_parts.py ;;
  passrate) script=passrate.py picture=passrate.png ;;
  path)
    program=BenchmarkPath
    scans=(bunny armadillo fertility kitten gargoyle)
    ;;
  peers)
    script=measure_peers.py
    scans=(fandisk fertility bunny igea)
    packages=(build-essential libeigen3-dev libnanoflann-dev libspectra-dev python3-dev python3-venv
      zlib1g-dev)
    ;;
  spectral)
    program=BenchmarkSpectral
    scans=(bunny igea)
    packages+=(libsuitesparse-dev)
    ;;
  spheres) script=measure_spheres.py picture=greens_convergence.png ;;
  thesis) packages+=(python3-matplotlib) ;;
esac
[ -z "$picture" ] || packages+=(python3-matplotlib)

# only_for OPTION MODES: ends the script in other modes.
only_for() {
  case " $2 " in
    *" $mode "*) ;;
    *) dgg_fail "$1 does not apply to the mode $mode. Choose one of: $2." ;;
  esac
}

out="$DGG_ROOT/out/benchmark"
readme=
libigl=
arguments=()
while [ $# -gt 0 ]; do
  case "$1" in
    --data | --libigl | --out) [ $# -ge 2 ] || dgg_fail "$1 needs a folder" ;;
  esac
  case "$1" in
    --out)
      out="$2"
      shift
      ;;
    --data)
      only_for --data "cloud first isolines path peers spectral thesis"
      case "$mode" in
        cloud) arguments+=("--terrain=$2/terrain_andes.ply" "--speed_mesh=$2/terrain_andes.ply") ;;
        thesis) arguments+=(--data "$2") ;;
      esac
      for name in ${scans[@]+"${scans[@]}"}; do
        arguments+=("$2/$name.ply")
      done
      shift
      ;;
    --full)
      only_for --full "cloud thesis"
      case "$mode" in
        cloud) arguments+=("--large=sphere:655362") ;;
        thesis) arguments+=(--full) ;;
      esac
      ;;
    --libigl)
      only_for --libigl spectral
      libigl="$(cd "$2" && pwd)"
      shift
      ;;
    --readme)
      only_for --readme "cloud first graph local peers spectral spheres thesis"
      readme=yes
      ;;
    *) arguments+=("$1") ;;
  esac
  shift
done

# draw PICTURE COMMAND...: draws a picture, with --readme for the page as well. The command fails if
# there are no curves.
draw() {
  local name="$1"
  shift
  if "$@" "$out/$name"; then
    echo "Written: $out/$name"
    if [ -n "$readme" ]; then
      cp "$out/$name" "$DGG_ROOT/Examples/Images/$name"
      echo "Written: Examples/Images/$name"
    fi
  fi
}

# measure: runs the program or script of the mode, and writes its tables and its plot.
measure() {
  if [ -n "$program" ]; then
    # One thread for the BLAS of CHOLMOD, as for all other peers.
    OPENBLAS_NUM_THREADS=1 "$build/bin/$program" --benchmark_out="$out/$mode.json" \
      --benchmark_out_format=json ${arguments[@]+"${arguments[@]}"}
    "$python" "$here/summarize.py" "$out/$mode.json" "$out/$mode.md"
  else
    [ "$mode" = peers ] || python="$build/bin/vtkdgg-python"
    "$python" "$here/$script" "$out/$mode.json" "$out/$mode.md" ${arguments[@]+"${arguments[@]}"}
  fi
  echo "Written: $out/$mode.json and $out/$mode.md"
  if [ -n "$readme" ]; then
    "$python" "$here/tables.py" "$here/README.md" "$mode" "$out/$mode.md"
    echo "Written: Testing/Benchmark/README.md"
  fi
  [ -z "$picture" ] || draw "$picture" "$python" "$here/plots.py" "$mode" "$out/$mode.json"
  if [ "$mode$readme" = spectralyes ]; then
    draw greens_function.png dgg_with_display "$build/bin/vtkdgg-python" \
      "$DGG_ROOT/Examples/Python/greens_function.py"
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

# install_peers: installs this package and its peers in a virtual environment with its own Python.
install_peers() {
  local environment="$out/environment"
  [ -x "$environment/bin/python" ] || "$python" -m venv "$environment"
  python="$environment/bin/python"
  echo "Installing packages in $environment ..."
  "$python" -m pip install --quiet --disable-pip-version-check "$DGG_ROOT" adobe-lagrange libigl \
    meshlib potpourri3d pygeodesic pymeshlab scipy tvb-gdist
}

with_python=ON
[ -z "$program" ] || [ "$mode$readme" = spectralyes ] || with_python=OFF
dgg_install "${packages[@]}"

# Python for which apt installs packages, if it exists.
python="$(command -v /usr/bin/python3 || command -v python3)"
mkdir -p "$out"
out="$(cd "$out" && pwd)"
build="$DGG_ROOT/build/benchmark"
if [ "$mode" = peers ]; then
  install_peers
else
  dgg_build "$build" \
    -DCMAKE_BUILD_TYPE=Release \
    -DBUILD_TESTING=OFF \
    -DDGG_WITH_PYTHON="$with_python" \
    -DDGG_PEER_LIBIGL_DIR="$libigl" \
    -DDGG_BUILD_BENCHMARKS=ON
fi

case "$mode" in
  compare)
    dgg_with_display "$build/bin/vtkdgg" compare --methods --out "$out/compare" \
      ${arguments[@]+"${arguments[@]}"}
    ;;
  thesis) measure_thesis ;;
  *) measure ;;
esac
