#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Run the two commands of README.md, of the last commit, in a clean Debian. To be run by root where
# debootstrap is installed. Downloads a gigabyte the first time.
#
# Usage: Testing/debian.sh RELEASE [FOLDER]
#   RELEASE  12, 13 or testing
#   FOLDER   where to make the systems; downloads stay there (default: build/debian)

set -euo pipefail

if [ $# -eq 0 ] || [ "$1" = -h ] || [ "$1" = --help ]; then
  sed -n '/^# Run the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

folder="${2:-$DGG_ROOT/build/debian}"
mkdir -p "$folder"
dgg_make_root "$1" "$(cd "$folder" && pwd)" "debian-$1"
git clone -q --depth 1 "file://$DGG_ROOT" "$dgg_root/srv/vtkDGG"
for command in Examples/demo.sh Testing/test.sh; do
  echo "Debian $1: $command"
  dgg_in_root "vtkDGG/$command"
done
