# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the Python filters of the Laplacian, see filter_tasks."""

import math

from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import _kernel as kernel
from .filter_tasks import TASKS, new_outputs, remover, task
from .vtk_data import ids_of, named_arrays, values_of
from .vtk_input import numbers
from .vtk_output import with_result

__all__ = ["TASKS"]


@task
class vtkSpectralAlgorithm:
    """A function of each source. Subclasses have `solver`, a function of the kernel."""

    unavailable = ("MemorySize", "NumberOfColumns", "NumberOfFactorizations", "NumberOfSpectra")

    RemoveAllSources = remover("SourceIds")

    def run(self, polydata):
        sources = self.points(1, "SourceIds")
        arguments = self.solver_arguments(polydata)
        if self.input(2) is not None and self.input(2).GetNumberOfPoints():
            arguments["evaluation"] = self.points(2)
        results = type(self).solver(self.surface, sources, **arguments)
        self.warn_about(results)
        self.keep(results[0])
        points = self.input(2)
        if points is None:
            points = vtkPolyData()
            points.GetFieldData().PassData(polydata.GetFieldData())
        return [with_result(r, i) for r, i in zip(results, (polydata, points))]

    def solver_arguments(self, polydata):
        return self.arguments()

    def keep(self, result):
        """Stores values of a result."""


@task
class vtkDiscreteGreensFunction:
    solver = kernel.greens_function

    def GetUsedMethod(self, source: int) -> int:
        """Returns the method of a source of the last update; -1 if there is none."""
        return self._used(source, "method", -1)

    def GetUsedRadius(self, source: int) -> float:
        """Returns the radius of the logarithm of a source; 0 if there is none."""
        return self._used(source, "radius", 0.0)

    def IsNearRidge(self, source: int) -> bool:
        """Returns true if shortest paths from different sides meet close to a source."""
        return self._used(source, "is_near_ridge", False)

    def _used(self, source, key, default):
        used = self._found.get("Used", ())
        return used[source][key] if 0 <= source < len(used) else default

    def keep(self, result):
        choices = self.properties["Method"]["choices"]
        self.set_results(Used=[{**item, "method": choices[item["method"]]} for item in result.used])


@task
class vtkBiharmonicDistance:
    solver = kernel.biharmonic_distance


@task
class vtkHarmonicBSpline:
    solver = kernel.harmonic_spline

    def GetUsedSite(self, i: int) -> int:
        """Returns a site of the last update as a point id; -1 if there is none."""
        sites = self._found.get("Sites", ())
        return int(sites[i]) if 0 <= i < len(sites) else -1

    def solver_arguments(self, polydata):
        arguments = self.arguments("RightHandSideArrayName", "SiteValuesArrayName")
        data = polydata.GetPointData()
        name = self.get("SiteValuesArrayName")
        points = self.input(1).GetPointData() if self.input(1) is not None else None
        arguments["right_hand_side"] = numbers(
            data, self.get("RightHandSideArrayName"), "the surface"
        )
        arguments["point_values"] = numbers(points, name, "port 1", is_required=False)
        arguments["surface_values"] = numbers(
            data, name, "the surface", is_required=arguments["point_values"] is None
        )
        return arguments

    def keep(self, result):
        self.set_results(Sites=result.used_sites, NumberOfUsedSites=len(result.used_sites))


@task
class vtkSurfaceEarthMoversDistance:
    unavailable = ("MemorySize", "NumberOfFactorizations")

    def initial_results(self):
        nan = math.nan
        return {"Distance": nan, "LowerBound": nan, "Gap": nan, "NumberOfIterations": 0}

    def run(self, polydata):
        arguments = self.arguments("FromArrayName", "ToArrayName", "MassArrayName")
        for port, role in enumerate(("From", "To"), 1):
            key = role.lower()
            name = self.get(f"{role}ArrayName")
            arguments[f"{key}_values"] = numbers(polydata.GetPointData(), name, "the surface")
            points = self.input(port)
            if points is not None and points.GetNumberOfPoints():
                arguments[f"{key}_points"] = self.points(port)
                masses = numbers(points.GetPointData(), self.get("MassArrayName"), f"port {port}")
                arguments[f"{key}_masses"] = masses
        result = kernel.earth_movers_distance(self.surface, **arguments)
        self.warn_about([result])
        self.set_results(
            Distance=result.distance, LowerBound=result.lower_bound, Gap=result.gap,
            NumberOfIterations=result.number_of_iterations,
        )  # fmt: skip
        output = with_result(result, polydata)
        for name in result.cell_data:
            output.GetCellData().SetActiveVectors(name)
        return [output]


@task
class vtkPoissonVectorGraphics:
    unavailable = ("MemorySize", "NumberOfFactorizations")

    def run(self, polydata):
        lines = self.input(1)
        curves = None
        if lines is not None:
            first, count = lines.GetNumberOfVerts(), lines.GetNumberOfLines()
            curves = {
                "points": values_of(lines.GetPoints().GetData()) if lines.GetPoints() else [],
                "lines": ids_of(lines.GetLines()) if count else ([0], []),
                "point_data": named_arrays(lines.GetPointData()),
                "cell_data": {
                    k: v[first : first + count]
                    for k, v in named_arrays(lines.GetCellData()).items()
                },
            }
        results = kernel.vector_graphics(
            self.surface, curves, named_arrays(polydata.GetCellData()), **self.arguments()
        )
        self.warn_about(results)
        outputs = new_outputs(self, results, [polydata] * 2)
        return [outputs[0], outputs[1] if self.get("GenerateFragments") else None]
