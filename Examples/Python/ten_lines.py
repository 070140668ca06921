# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
import vtkdgg
from vtkmodules.vtkIOPLY import vtkPLYReader

reader = vtkPLYReader()
reader.SetFileName("mesh.ply")
distance = vtkdgg.vtkExactGeodesicDistance()
distance.SetInputConnection(reader.GetOutputPort())
distance.SetSourceIds([0, 10])
mesh = vtkdgg.check(distance)  # raises vtkdgg.VTKError when something is wrong
array = mesh.GetPointData().GetArray("GeodesicDistance")
print("farthest point:", array.GetRange()[1], "model units away")
