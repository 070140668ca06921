#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Build the plugin for ParaView 5.11 or later, and print how to start ParaView with it.
#
# Usage: Wrapping/ParaView/paraview.sh [--test] [--package] [--build FOLDER] [CMAKE ARGUMENTS]
#   --test           also run the tests of the plugin
#   --package        also make a Debian package in FOLDER/packages
#   --build FOLDER   folder of the build (default: build/paraview)
#   CMAKE ARGUMENTS  such as -DCMAKE_PREFIX_PATH=FOLDER for a ParaView in another folder
#
# The script uses an installed ParaView with its development files. Without one, on Debian,
# ParaView's packages are unpacked below FOLDER, and nothing is removed; compilers and
# libraries that the build needs are installed. The exit status is 3 if there is no ParaView and
# its packages cannot be downloaded.

set -euo pipefail

source "$(dirname "${BASH_SOURCE[0]}")/../../Testing/setup.sh"

# Packages that build a plugin, including missing dependencies of Debian's ParaView.
builds=(build-essential cmake ninja-build libeigen3-dev libnanoflann-dev libspectra-dev)
paraview=(paraview paraview-dev python3-paraview)

build="$DGG_ROOT/build/paraview"
test=OFF
package=OFF
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help)
      sed -n '/^# Build the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --test) test=ON ;;
    --package) package=ON ;;
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

# Succeeds if CMake finds a ParaView with development files; writes the folder of its programs to
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

# Ends the script if there is no ParaView.
without() {
  echo "error: $*" >&2
  exit 3
}

# Unpack ParaView and its missing dependencies into $root.
unpack() {
  command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null ||
    without "this is not a Debian-like system. Install ParaView with its development files and" \
      "name its folder: -DCMAKE_PREFIX_PATH=FOLDER"
  echo "Downloading ParaView ..."
  local archives="$build/archives"
  mkdir -p "$archives/partial"
  # Installing these packages would remove python3-vtk9. Since nothing is installed, neither a lock
  # nor root is needed.
  apt-get install -y --download-only --no-install-recommends -o Debug::NoLocking=true \
    -o Dir::Cache::archives="$archives" -o APT::Sandbox::User= "${paraview[@]}" \
    >"$build/download.log" 2>&1 || {
    tail -n 5 "$build/download.log" >&2
    without "could not download ParaView (apt-get update may help)"
  }
  echo "Unpacking $(find "$archives" -name '*.deb' | wc -l) packages into $root ..."
  rm -rf "$root.part"
  find "$archives" -name '*.deb' -print0 | xargs -0 -I '{}' dpkg-deb -x '{}' "$root.part" ||
    dgg_fail "could not unpack ParaView in $root.part"
  rm -rf "$root.part"/usr/lib/python3.* # pvpython would look there for all modules of Python
  # CMake files of Debian 13 name ParaView's modules without the suffix of Python's version.
  find "$root.part/usr/lib/python3/dist-packages/"{paraview,vtkmodules} -name '*.cpython-*.so' \
    -exec sh -c 'ln -s "${0##*/}" "${0%%.cpython-*}.so"' '{}' ';'
  mv "$root.part" "$root"
  rm -rf "$archives"
}

[ "$package" = OFF ] || builds+=(file) # which CPack asks
[ "$test" = OFF ] || builds+=(pybind11-dev python3-dev) # the Python plugin
dgg_install "${builds[@]}"
if [[ "$(apt-cache depends paraview 2>/dev/null)" = *libqt6* ]]; then # Debian 13
  paraview+=(qt6-5compat-dev qt6-base-dev qt6-svg-dev qt6-svg-plugins qt6-tools-dev)
else
  paraview+=(libqt5svg5-dev qtxmlpatterns5-dev-tools)
fi
if [ ! -d "$root" ] && is_usable "$@"; then
  echo "Using the ParaView in $(cat "$build/found")"
  libraries=
elif [ ! -d "$root" ] && dgg_is_installed python3-paraview &&
  ! dpkg-query -W "${paraview[@]}" >/dev/null 2>&1; then
  dgg_fail "ParaView is installed, but not all that builds plugins for it. Please install" \
    "${paraview[*]}; the output of CMake is in $build/probe.log"
else
  if dgg_is_installed python3-paraview; then
    paraview=(--reinstall paraview paraview-dev python3-paraview) # a copy, to be repaired
  else
    # Other packages, from PCL to Qt, are those that the libraries need.
    dgg_install "${DGG_PACKAGES[@]}"
  fi
  [ -d "$root" ] || unpack
  echo "Using the ParaView in $root/usr/bin"
  echo "$root/usr/bin" >"$build/found"
  libraries="$(dirname "$(find "$root/usr/lib" -name 'libpqCore-pv*.so' | head -n 1)")"
  set -- -DCMAKE_PREFIX_PATH="$root/usr" -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
  [ -d "$libraries/cmake/Qt5Svg" ] && set -- -DQt5Svg_DIR="$libraries/cmake/Qt5Svg" "$@"
  patterns="$root/usr/lib/qt5/bin/xmlpatterns"
  [ -x "$patterns" ] && set -- -Dqt_xmlpatterns_executable="$patterns" "$@"
fi

# Use the folders of Debian.
[ "$package" = OFF ] || set -- -DCMAKE_INSTALL_PREFIX=/usr "$@"
[ -z "$libraries" ] || export LD_LIBRARY_PATH="$libraries" # for what the build runs
dgg_build "$build" \
  -DCMAKE_BUILD_TYPE=Release \
  -DDGG_PARAVIEW_PLUGIN=ON \
  -DDGG_KERNEL_FROM= \
  -DBUILD_TESTING="$test" \
  -DDGG_WITH_PYTHON_KERNEL="$test" \
  "$@"
plugin="$(cat "$build/plugin")"
echo "Built $plugin"

# Script that starts all programs of ParaView.
prepend() { printf 'export %s="%s${%s:+:$%s}"\n' "$1" "$2" "$1" "$1"; }
{
  echo "#!/bin/sh"
  echo "# Run a command with ParaView and the plugin: paraview, pvpython SCRIPT, pvbatch SCRIPT."
  prepend PATH "$(cat "$build/found")"
  prepend PV_PLUGIN_PATH "$(dirname "$plugin")"
  if [ -n "$libraries" ]; then
    prepend LD_LIBRARY_PATH "$libraries:$libraries/libproxy" # which the GUI needs on Debian 13
    prepend PYTHONPATH "$root/usr/lib/python3/dist-packages"
    prepend QT_PLUGIN_PATH "$(echo "$libraries"/qt?/plugins)"
  fi
  echo 'exec "$@"'
} >"$build/run"
chmod +x "$build/run"

if [ "$package" = ON ]; then
  (cd "$build" && cpack -G DEB) >"$build/package.log" 2>&1 || {
    tail -n 20 "$build/package.log" >&2
    dgg_fail "no package could be made"
  }
  echo "Packed $(ls "$build"/packages/*.deb)"
fi
if [ "$test" = ON ]; then
  dgg_install xvfb xauth
  dgg_with_display "$build/run" ctest --test-dir "$build" --output-on-failure -j "$(nproc)"
fi
echo "Start ParaView by: $build/run paraview"
