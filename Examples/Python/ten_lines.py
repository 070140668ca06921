# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
import vtkdgg

mesh = vtkdgg.read("mesh.ply")
distance = vtkdgg.vtkExactGeodesicDistance()
distance.SetInputData(mesh.as_polydata())
distance.SetSourceIds([0, 10])
output = vtkdgg.check(distance)  # raises vtkdgg.VTKError when something is wrong
array = output.GetPointData().GetArray("GeodesicDistance")
print("farthest point:", array.GetRange()[1], "model units away")
