#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Geodesic distances on a mesh within an error bound. Installs missing Debian packages, and builds
# vtkDGG and a graph of the mesh. Queries the graph, measures the error against the exact solver, and
# prints a table of sizes, times and errors. Writes distance.vtp, distance.png (distances with
# isolines) and error.png (map of the errors).
# A file with points and without polygons is a point cloud, for which there is no error bound and no
# exact solver: builds a graph, and computes distances and the path to the farthest point.
# Writes distance.vtp, path.vtp and distance.png.
#
# Usage: Examples/demo.sh [FILE] [--accuracy E] [--source ID | --source X,Y,Z [--tolerance T]]
#                         [--merge] [--cloud] [--out DIR]
#   FILE        .ply .obj .stl .vtp .vtk .off .pcd .xyz
#               (default: the bunny of Debian's glmark2-data)
#   --accuracy  largest relative error of a distance on a mesh, 1e-6 to 0.5 (default: 0.01)
#   --source    source of the distances: a point id, or coordinates on the surface
#               (default: the point farthest from the center)
#   --tolerance largest distance of X,Y,Z from the surface, fraction of the diagonal (default: 0.01)
#   --merge     treat points of a mesh with equal coordinates as one (texture seams)
#   --cloud     use the points only, even if the file has polygons
#   --out       folder of the results (default: ./out)

set -euo pipefail

for argument in "$@"; do
  if [ "$argument" = -h ] || [ "$argument" = --help ]; then
    sed -n '/^# Geodesic distances/,/^$/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
    exit 0
  fi
done

source "$(dirname "${BASH_SOURCE[0]}")/../Testing/setup.sh"

dgg_install "${DGG_PACKAGES[@]}" glmark2-data

build="$DGG_ROOT/build/demo"
dgg_build "$build" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF
dgg_with_display "$build/bin/vtkdgg" compare "$@"
