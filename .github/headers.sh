#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Install the libraries that wheels are built with, on Linux into /usr/local, on macOS by Homebrew and
# on Windows by vcpkg.

set -euo pipefail

# install NAME TAG ADDRESS [CMAKE ARGUMENTS]
install() {
  git clone -q --depth 1 --branch "$2" "$3" "/tmp/$1"
  cmake -S "/tmp/$1" -B "/tmp/$1/build" -DBUILD_TESTING=OFF "${@:4}"
  cmake --install "/tmp/$1/build"
}

case "$(uname -s)" in
  Linux)
    dnf install -y zlib-devel
    install eigen 3.4.0 https://gitlab.com/libeigen/eigen.git
    install spectra v1.0.1 https://github.com/yixuan/spectra.git
    install nanoflann v1.6.3 https://github.com/jlblancoc/nanoflann.git \
      -DNANOFLANN_BUILD_EXAMPLES=OFF -DNANOFLANN_BUILD_TESTS=OFF
    ;;
  Darwin)
    brew install eigen nanoflann spectra
    ;;
  *)
    vcpkg install --triplet x64-windows-static-md eigen3 nanoflann spectra zlib
    ;;
esac
