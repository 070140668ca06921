#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Run the two commands of README.md, of the last commit, in a clean Debian. To be run by root where
# debootstrap is installed. Downloads a gigabyte the first time.
#
# Usage: Testing/debian.sh RELEASE [--paraview] [FOLDER]
#   RELEASE     12, 13 or testing
#   --paraview  instead, build both plugins for ParaView there and run their tests
#   FOLDER      where to make the systems; downloads stay there (default: build/debian)

set -euo pipefail

if [ $# -eq 0 ] || [ "$1" = -h ] || [ "$1" = --help ]; then
  sed -n '/^# Run the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

release="$1"
commands=(Examples/demo.sh Testing/test.sh)
if [ "${2:-}" = --paraview ]; then
  shift
  commands=("Wrapping/ParaView/paraview.sh --test")
fi
folder="${2:-$DGG_ROOT/build/debian}"
mkdir -p "$folder"
dgg_make_root "$release" "$(cd "$folder" && pwd)" "debian-$release"
git clone -q --depth 1 "file://$DGG_ROOT" "$dgg_root/srv/vtkDGG"
for command in "${commands[@]}"; do
  echo "Debian $release: $command"
  dgg_in_root "vtkDGG/$command"
done
