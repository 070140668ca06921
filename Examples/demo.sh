#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Geodesic distances on a mesh within a promised error: builds what is needed, then a graph of the
# mesh; queries the graph, measures the error against the exact solver, and prints a table of sizes,
# times and errors. Writes distance.vtp, distance.png (distances with isolines) and error.png (where
# the errors are). Missing Debian packages are installed first.
# A file that holds points and no polygons is a point cloud: then there is no promise and no exact
# solver; a graph of the cloud is built, and distances and the path to the farthest point are found.
# Writes distance.vtp, path.vtp and distance.png.
#
# Usage: Examples/demo.sh [FILE] [--accuracy E] [--source ID | --source X,Y,Z [--tolerance T]]
#                         [--merge] [--cloud] [--out DIR]
#   FILE        .ply .obj .stl .vtp .vtk .off .pcd .xyz
#               (default: the bunny of Debian's glmark2-data)
#   --accuracy  largest relative error of a distance on a mesh, 1e-6 to 0.5 (default: 0.01)
#   --source    where distances start: a point id, or coordinates on the surface
#               (default: the point farthest from the centre)
#   --tolerance how far X,Y,Z may be from the surface, as a fraction of the diagonal (default: 0.01)
#   --merge     treat points of a mesh with equal coordinates as one (texture seams)
#   --cloud     look at points only, also where the file has polygons
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
