#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build the plugin for ParaView, 5.11 or later, and say how to start ParaView with it.
#
# Usage: Wrapping/ParaView/paraview.sh [--test] [--build FOLDER] [CMAKE ARGUMENTS]
#   --test           also run the tests of the plugin
#   --build FOLDER   where to build; build/paraview by default
#   CMAKE ARGUMENTS  such as -DCMAKE_PREFIX_PATH=FOLDER, where ParaView is if not in a usual place
#
# A ParaView that is installed with its development files is used. Without one, on Debian, its
# packages are unpacked below FOLDER, and nothing that is installed changes.

set -euo pipefail

source "$(dirname "${BASH_SOURCE[0]}")/../../Testing/setup.sh"

# What builds a plugin, and what Debian's ParaView needs for it but does not depend on.
builds=(build-essential cmake ninja-build libeigen3-dev libspectra-dev)
paraview=(paraview paraview-dev python3-paraview libqt5svg5-dev qtxmlpatterns5-dev-tools)

build="$DGG_ROOT/build/paraview"
test=OFF
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help)
      sed -n '/^# Build the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --test) test=ON ;;
    --build)
      build="${2:?--build needs a folder}"
      shift
      ;;
    *) break ;;
  esac
  shift
done
mkdir -p "$build"
build="$(cd "$build" && pwd)"
root="$build/debian"

# Whether CMake finds a ParaView that plugins can be built for; where its programs are goes to
# $build/found.
is_usable() {
  mkdir -p "$build/probe"
  cat >"$build/probe/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.20)
project(Probe LANGUAGES C CXX)
find_package(ParaView 5.11 REQUIRED)
get_target_property(pvpython ParaView::pvpython LOCATION)
get_filename_component(folder "${pvpython}" DIRECTORY)
file(WRITE "${CMAKE_BINARY_DIR}/../found" "${folder}")
END
  rm -f "$build/found"
  cmake -S "$build/probe" -B "$build/probe" "$@" >"$build/probe.log" 2>&1 && [ -s "$build/found" ]
}

# Unpack ParaView, and what it needs and the system does not have, into $root.
unpack() {
  command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null ||
    dgg_fail "this is not a Debian-like system. Install ParaView with its development files and" \
      "name their folder: -DCMAKE_PREFIX_PATH=FOLDER"
  echo "Downloading ${paraview[*]} and what they need ..."
  local archives="$build/archives"
  mkdir -p "$archives/partial"
  # To install them in the ordinary way would remove python3-vtk9. As nothing is installed, no lock
  # is needed, nor root.
  apt-get install -y --download-only --no-install-recommends -o Debug::NoLocking=true \
    -o Dir::Cache::archives="$archives" -o APT::Sandbox::User= "${paraview[@]}" \
    >"$build/download.log" 2>&1 || {
    tail -n 5 "$build/download.log" >&2
    dgg_fail "could not download ParaView (apt-get update may help)"
  }
  echo "Unpacking $(find "$archives" -name '*.deb' | wc -l) packages into $root ..."
  rm -rf "$root.part"
  find "$archives" -name '*.deb' -exec dpkg-deb -x {} "$root.part" \;
  mv "$root.part" "$root"
  rm -rf "$archives"
}

dgg_install "${builds[@]}"
if [ ! -d "$root" ] && is_usable "$@"; then
  echo "Using the ParaView in $(cat "$build/found")"
  libraries=
  python=
else
  # The rest, from point clouds to Qt, comes with what the libraries are built with.
  dgg_install "${DGG_PACKAGES[@]}"
  [ -d "$root" ] || unpack
  echo "Using the ParaView in $root/usr/bin"
  echo "$root/usr/bin" >"$build/found"
  libraries="$(dirname "$(find "$root/usr/lib" -name 'libpqCore-pv*.so' | head -n 1)")"
  python="$root/usr/lib/python3/dist-packages"
  set -- -DCMAKE_PREFIX_PATH="$root/usr" -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
  [ -d "$libraries/cmake/Qt5Svg" ] && set -- -DQt5Svg_DIR="$libraries/cmake/Qt5Svg" "$@"
  patterns="$root/usr/lib/qt5/bin/xmlpatterns"
  [ -x "$patterns" ] && set -- -Dqt_xmlpatterns_executable="$patterns" "$@"
fi

# All that runs ParaView runs by this.
cat >"$build/run" <<END
#!/bin/sh
# Run a command with ParaView and its plugin Geodesics: paraview, pvpython SCRIPT, pvbatch SCRIPT.
export PATH="$(cat "$build/found"):\$PATH"
export LD_LIBRARY_PATH="$libraries\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}"
export PYTHONPATH="$python\${PYTHONPATH:+:\$PYTHONPATH}"
export PV_PLUGIN_PATH="$build/lib/paraview/plugins/Geodesics"
exec "\$@"
END
chmod +x "$build/run"

export LD_LIBRARY_PATH="$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" # for what the build runs
dgg_build "$build" \
  -DCMAKE_BUILD_TYPE=Release \
  -DDGG_PARAVIEW_PLUGIN=ON \
  -DBUILD_TESTING="$test" \
  "$@"
echo "Built $build/lib/paraview/plugins/Geodesics/Geodesics.so"
if [ "$test" = ON ]; then
  dgg_install xvfb xauth
  dgg_with_display "$build/run" ctest --test-dir "$build" --output-on-failure -j "$(nproc)"
fi
echo "Start ParaView by: $build/run paraview"
