#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Install the Debian packages into a clean Debian 12, use them (Python, shell, C++, or
# ParaView), and remove them completely. To be run by root where debootstrap is installed. Downloads
# a gigabyte the first time.
#
# Usage: Testing/packages.sh [--paraview] PACKAGES FOLDER [MESH]
#   --paraview  test the package of the plugin, in a system without the other packages
#   PACKAGES    folder of the .deb files, build/package/packages or build/paraview/packages
#   FOLDER      where to make the systems; downloads stay there
#   MESH        a .ply file (default: a small one)

set -euo pipefail

if [ $# -eq 0 ] || [ "$1" = -h ] || [ "$1" = --help ]; then
  sed -n '/^# Install the/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

system=system
# Packages that the system has before the installation.
present=(build-essential cmake bash-completion man-db xauth xvfb)
if [ "$1" = --paraview ]; then
  shift
  system=paraview
  present=(python3-paraview)
fi
packages="$(cd "${1:?PACKAGES is missing}" && pwd)"
mkdir -p "${2:?FOLDER is missing}"
folder="$(cd "$2" && pwd)"
mesh="$(realpath "${3:-$DGG_ROOT/Testing/Data/bumpy.ply}")"

# shown COMMAND: run it in the system, and print the command and its time.
shown() {
  printf '\n%s\n' "$1" | sed '2,$s/^/$ /'
  local start
  start="$(date +%s%N)"
  dgg_in_root "$1"
  echo "# $((($(date +%s%N) - start) / 1000000)) ms"
}
# list: print files and folders, except those that package managers and the kernel write.
list() {
  dgg_in_root "find / -xdev \\( -path /proc -o -path /var/cache -o -path /var/log -o -path /var/lib/apt \
    -o -path /var/lib/dpkg -o -path /srv -o -path /tmp \\) -prune -o -print" | sort
}

dgg_make_root 12 "$folder" "$system"
home="$dgg_root/srv"
mkdir "$home/packages"
cp "$packages"/*.deb "$home/packages"
cp "$mesh" "$home/mesh.ply"

echo "Installing what the packages need ..."
names="$(for file in "$packages"/*.deb; do dpkg-deb -f "$file" Package; done | paste -sd '|')"
needs="$(for file in "$packages"/*.deb; do dpkg-deb -f "$file" Depends; done | sed 's/, */\n/g' |
  grep -Ev "^($names)( |$)" | sort -u | paste -sd ',')"
{ dgg_in_root "apt-get update && apt-get install -y ${present[*]} && apt-get satisfy -y '$needs'"; } \
  >"$folder/$system.log" 2>&1 || { tail -n 20 "$folder/$system.log" >&2; exit 1; }
list >"$folder/$system.before"

shown 'apt-get install -y -qq ./packages/*.deb 2>&1 | grep -v "^(Reading"'
if [ "$system" = paraview ]; then
  cat >"$home/distance.py" <<'END'
from glob import glob

from paraview.simple import *

LoadPlugin(glob("/usr/lib/*/paraview-*/plugins/Geodesics/Geodesics.so")[0], ns=globals())
distance = GeodesicDistance(Input=OpenDataFile("mesh.ply"), Accuracy=0.01)
distance.Source.Center = [1.0, 0.0, 0.0]
distance.UpdatePipeline()
print(distance.PointData["GeodesicDistance"].GetRange())
END
  shown 'pvpython --force-offscreen-rendering distance.py'
else
  shown 'python3 -c "
import vtkdgg
from vtkmodules.vtkIOPLY import vtkPLYReader
reader = vtkPLYReader()
reader.SetFileName(\"mesh.ply\")
print(vtkdgg.distance(vtkdgg.check(reader), 0).max())"'
  shown 'vtkdgg distance mesh.ply --source 0 --accuracy 0.01 --out bounded.vtp'
  shown 'vtkdgg render mesh.ply --source 0 --out distance.png'
  shown 'man vtkdgg | head -n 30'
  shown 'source /usr/share/bash-completion/bash_completion && _completion_loader vtkdgg;
COMP_WORDS=(vtkdgg dist) COMP_CWORD=1 && _vtkdgg && echo "${COMPREPLY[@]}"'
  cp -r "$DGG_ROOT/Examples/Cxx" "$home/Examples"
  shown 'cmake -S Examples -B build >/dev/null && cmake --build build --target TenLines &&
build/TenLines && ls -l distance.vtp'
fi
shown "apt-get purge -y -qq ${names//|/ } | grep -v '^(Reading'"
list >"$folder/$system.after"
diff "$folder/$system.before" "$folder/$system.after" || {
  echo "error: the packages leave something, or took something away" >&2
  exit 1
}
echo "Nothing is left of the packages."
