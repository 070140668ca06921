# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the Python filters: the function of the kernel that each filter calls, and functions of
filters that are not properties. Annotated functions are in the type stub of the filters."""

from __future__ import annotations

import math
import operator
from types import SimpleNamespace
from typing import TYPE_CHECKING, Iterable, Optional, Sequence, Tuple, Union

import numpy as np
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataSetAttributes, vtkPolyData, vtkTable
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonMisc import vtkContourValues

from . import _kernel as kernel
from .python_filters import TimeStamps, integers_of, property_of
from .results import GRAPH_ARRAYS
from .vtk_data import cells_of, ids_of, shallow_copy, values_of
from .vtk_input import graph_arrays, numbers, surface_points, windows_of
from .vtk_output import (
    add_result,
    pass_arrays,
    polydata_of_result,
    remove_graph,
    remove_windows,
    vtk_array,
    vtk_array_like,
)

if TYPE_CHECKING:
    from vtkmodules.vtkCommonCore import vtkIdList

DISTANCE = "GeodesicDistance"
MAXIMUM_COLUMNS = 10000  # of a table
TASKS = {}


def remover(*ids, ports=(1,)):
    """Returns a function of a filter that removes all ids and disconnects input ports."""

    def remove(self):
        for name in ids:
            getattr(self, f"RemoveAll{name}")()
        for port in ports:
            self.SetInputConnection(port, None)

    remove.__doc__ = "Removes all ids and disconnects the input ports of such points."
    return remove


def task(kind):
    """Registers the task of the filter with the name of the class."""
    TASKS[kind.__name__] = kind
    return kind


def new_outputs(self, results, inputs):
    """Returns results as new vtkPolyData, with the arrays of their inputs."""
    precision = self.get("OutputPointsPrecision")
    return [polydata_of_result(r, i, precision) for r, i in zip(results, inputs)]


def _remove_distances(polydata, name):
    """Removes the marks and windows of a distance array."""
    polydata.GetPointData().RemoveArray(f"{name}.Unreached")
    remove_windows(polydata, name)


@task
class vtkGeodesicDistanceAlgorithm:
    """Distances from sources. Subclasses have `solver`, a function of the kernel."""

    def AddSourceId(self, i: int, initial_distance: float = 0.0) -> None:
        """Adds a source with an initial distance."""
        offsets = [*self._offsets(), float(initial_distance)]
        self.change("SourceIds", [*self.get("SourceIds"), operator.index(i)])
        self._initial = offsets

    def SetSourceIds(
        self,
        ids: Union[vtkIdList, Iterable[int], None],
        initial_distances: Optional[Iterable[float]] = None,
    ) -> None:
        """Sets sources, each with an initial distance."""
        ids = integers_of(ids)
        offsets = (
            [0.0] * len(ids) if initial_distances is None else [*map(float, initial_distances)]
        )
        if len(ids) != len(offsets):
            self._show("Error", f"There are {len(offsets)} initial distances for {len(ids)} source "
                       "ids. Pass one per id; the sources are unchanged")  # fmt: skip
            return
        if offsets != self._offsets() and ids == self.get("SourceIds"):
            self.Modified()
        self.change("SourceIds", ids)
        self._initial = offsets

    def RemoveAllSourceIds(self) -> None:
        """Removes all ids."""
        self.SetSourceIds(None)

    RemoveAllSources = remover("SourceIds")

    def GetSourceInitialDistance(self, i: int) -> float:
        """Returns the initial distance of a source id; 0 if there is none."""
        return self._offsets()[i] if 0 <= i < len(self._offsets()) else 0.0

    def run(self, polydata):
        target = self.target(polydata)
        name = self.get("DistanceArrayName")
        nearest = self.get("SourceArrayName")
        arguments = self.arguments("InitialDistanceArrayName", "PassSourceArrays")
        passes = self.get("PassSourceArrays")
        if passes:
            arguments["generate_nearest_source"] = True
        result = type(self).solver(
            target, self.points(1, "SourceIds"), initial_distances=self._all_offsets(), **arguments
        )
        self.warn_about([result])
        self.set_results(QualityWarning=result.quality_warning)
        output = shallow_copy(polydata)
        data = output.GetPointData()
        if passes:
            sources = result.point_data[nearest]
            if not self.get("GenerateNearestSource"):
                del result.point_data[nearest]
            pass_arrays(self.input(1), len(self.get("SourceIds")), sources, data)
        if data.HasArray(name):
            data.RemoveArray(nearest)
            data.RemoveArray(self.get("VirtualSourceArrayName"))
        _remove_distances(output, name)
        if "UpperBoundArrayName" in self.properties and self.get("GenerateUpperBound"):
            _remove_distances(output, self.get("UpperBoundArrayName"))
        add_result(result, output)
        return [output]

    def target(self, polydata):
        return self.surface

    def _offsets(self):
        return getattr(self, "_initial", [])

    def _all_offsets(self):
        """Returns the initial distances of all sources; None for zeros."""
        offsets = self._offsets()
        points = self.input(1)
        count = points.GetNumberOfPoints() if points is not None else 0
        name = self.get("InitialDistanceArrayName")
        found = points.GetPointData().GetAbstractArray(name) if count and name else None
        if found is None:
            return [*offsets, *[0.0] * count] if any(offsets) else None
        values = values_of(found)
        if values is None or values.shape != (count,):
            raise ValueError(
                f"The point array '{name}' of input port 1 is not numeric with 1 component and one "
                "tuple per point. Correct the array, or change InitialDistanceArrayName"
            )
        return [*offsets, *values.tolist()]


@task
class vtkExactGeodesicDistance:
    solver = kernel.exact_distance


@task
class vtkVirtualSourceGeodesicDistance:
    solver = kernel.virtual_source_distance


@task
class vtkHeatGeodesicDistance:
    solver = kernel.heat_distance
    unavailable = ("MemorySize", "NumberOfFactorizations")


@task
class vtkDGGFastMarchingDistance:
    solver = kernel.fast_marching_distance
    unavailable = ("UsedBandRadius", "UsedResolution")

    def is_cloud(self, polydata):
        return polydata.GetNumberOfPolys() + polydata.GetNumberOfStrips() == 0


@task
class vtkDGGDistance:
    solver = kernel.Graph.distance

    def target(self, polydata):
        return self.graph(polydata)

    def arguments(self, *others):
        return super().arguments("Accuracy", *others)


@task
class vtkDGGPath:
    def AddPair(self, start: int, end: int) -> None:
        """Adds a pair of point ids."""
        self._pairs = [*self._ids(), operator.index(start), operator.index(end)]
        self.Modified()

    def RemoveAllPairs(self) -> None:
        """Removes all pairs of ids."""
        if self._ids():
            self._pairs = []
            self.Modified()

    def GetNumberOfPairs(self) -> int:
        """Returns the number of pairs of ids."""
        return len(self._ids()) // 2

    def GetPairStart(self, i: int) -> int:
        """Returns the start of a pair; -1 if there is none."""
        return self._ids()[2 * i] if 0 <= i < self.GetNumberOfPairs() else -1

    def GetPairEnd(self, i: int) -> int:
        """Returns the end of a pair; -1 if there is none."""
        return self._ids()[2 * i + 1] if 0 <= i < self.GetNumberOfPairs() else -1

    def _ids(self):
        return getattr(self, "_pairs", [])

    def initial_results(self):
        return {"NumberOfFallbacks": 0}

    def run(self, polydata):
        lines = self.input(1)
        ends = np.zeros(0, dtype=int)
        if lines is not None and lines.GetNumberOfPoints():
            ends = kernel.path_ends(ids_of(lines.GetLines()), lines.GetNumberOfPoints())
        pairs = surface_points(lines if len(ends) else None, 1, self._ids(), ends)
        if not self._ids() and not len(ends):
            raise ValueError(
                "There is no pair of points. Add pairs, or connect a line for each pair to input "
                "port 1"
            )
        is_exact = self.get("Method") == self.Exact
        target = self.surface if is_exact else self.graph(polydata)
        result = kernel.paths(target, pairs, **self.arguments("Accuracy"))
        self.warn_about([result])
        self.set_results(NumberOfFallbacks=result.number_of_fallbacks)
        outputs = new_outputs(self, [result], [polydata])
        if lines is not None:
            written = result.cell_data["PairId"]
            first = self.GetNumberOfPairs()
            for i in range(lines.GetCellData().GetNumberOfArrays()):
                array = lines.GetCellData().GetAbstractArray(i)
                data = outputs[0].GetCellData()
                if not array.GetName() or not data.HasArray(array.GetName()):
                    at = lines.GetNumberOfVerts()
                    data.AddArray(vtk_array_like(array, written, first, at, 0.0))
        return outputs


@task
class vtkDGGLoop:
    RemoveAllPoints = remover("PointIds")

    def is_cloud(self, polydata):
        return False

    def run(self, polydata):
        around = self.get("Mode") == self.AroundHandles
        target = self.surface if around else self.graph(polydata)
        points = None if around else self.points(1, "PointIds")
        results = kernel.loops(target, points, **self.arguments("Accuracy"))
        self.warn_about(results)
        return new_outputs(self, results, [polydata] * 2)


@task
class vtkGeodesicVoronoi:
    RemoveAllSites = remover("SiteIds")

    def run(self, polydata):
        target = self.surface if self.get("Preview") else self.graph(polydata)
        sites = self.points(1, "SiteIds")
        results = kernel.voronoi(target, sites, **self.arguments("Accuracy", "PassSiteArrays"))
        self.warn_about(results)
        surface = shallow_copy(polydata)
        _remove_distances(surface, self.get("DistanceArrayName"))
        add_result(results[0], surface)
        outputs = [surface, *new_outputs(self, results[1:], [polydata] * 3)]
        if self.get("PassSiteArrays"):
            first = len(self.get("SiteIds"))
            for nearest, data in (
                (results[0].point_data[self.get("SourceArrayName")], surface.GetPointData()),
                (results[2].cell_data["SiteId"], outputs[2].GetCellData()),
                (results[3].point_data["SiteId"], outputs[3].GetPointData()),
            ):
                pass_arrays(self.input(1), first, nearest, data)
        return outputs


@task
class vtkGeodesicSampler:
    def run(self, polydata):
        start = None if self.input(1) is None else self.points(1)
        graph = self.graph(polydata)
        result = kernel.samples(graph, start=start, **self.arguments("Accuracy"))
        self.warn_about([result])
        return new_outputs(self, [result], [polydata])


@task
class vtkGeodesicDistanceMatrix:
    def GetMatrix(self) -> vtkDoubleArray:
        """Returns the result of the last update; without tuples if there is none."""
        matrix = self._found.get("Matrix")
        return vtkDoubleArray() if matrix is None else matrix

    def ReleaseMatrix(self) -> None:
        """Releases matrix and table; the next update computes them again."""
        self.set_results(Matrix=None)
        self.GetOutputDataObject(0).ReleaseData()

    def initial_results(self):
        return {"Matrix": None}

    def run(self, polydata):
        rows = self.points(1, "RowIds")
        is_symmetric = not self.get("ColumnIds") and self.input(2) is None
        others = ["Accuracy", "CompressedRows"]
        if self.get("CompressedRows"):
            if not is_symmetric:
                raise ValueError(
                    "CompressedRows is on, but columns are chosen. Remove the columns, or turn off "
                    "CompressedRows"
                )
            arguments = self.arguments("UnreachedValue", "GenerateTable", *others)
            return [self._compressed(self.graph(polydata).neighborhood(rows, **arguments))]
        columns = None if is_symmetric else self.points(2, "ColumnIds")
        arguments = self.arguments("Correction", *others)
        matrix = self.graph(polydata).matrix(rows, columns, with_copy=True, **arguments)
        found = vtk_array(matrix, DISTANCE)
        self.set_results(Matrix=found)
        matrix = None  # released before the table is made
        return [self._table(values_of(found)) if self.get("GenerateTable") else vtkTable()]

    def _compressed(self, found):
        table = vtkTable()
        offsets, columns, distances = found
        table.AddColumn(vtk_array(columns, "Column"))
        table.AddColumn(vtk_array(distances, DISTANCE))
        table.GetFieldData().AddArray(vtk_array(offsets, "RowOffsets", is_stored=True))
        return table

    def _table(self, matrix):
        count = matrix.size // len(matrix)
        if count > MAXIMUM_COLUMNS:
            self.warn(
                f"The table would have {count} columns, more than {MAXIMUM_COLUMNS}, so the output "
                "is empty. Use GetMatrix(), and turn off GenerateTable"
            )
            return vtkTable()
        table = vtkTable()
        for i, values in enumerate(matrix.reshape(-1, count).T):
            # Named afterwards, since a named array is compared with all existing columns.
            column = vtk_array(values)
            table.AddColumn(column)
            column.SetName(str(i))
        return table


@task
class vtkGeodesicPatchBoundaries:
    RemoveAllLandmarks = remover("FirstLandmarkIds", "SecondLandmarkIds", ports=(2, 3))

    def run(self, polydata):
        second = self.input(1)
        if second is None:
            raise ValueError("There is no second surface. Connect a surface to input port 1")
        layout = self.input(4) if self.input(4) is not None else self.input(2)
        if layout is None:
            raise ValueError(
                "There is no layout. Connect polygons or lines that refer to landmarks to input "
                "port 4, or landmarks with cells to input port 2"
            )
        landmarks = [self.points(2, "FirstLandmarkIds"), self.points(3, "SecondLandmarkIds")]
        results = kernel.patch_boundaries(
            self.surface, self.prepare(1, second, "The second surface"), *landmarks,
            patches=ids_of(layout.GetPolys()), edges=ids_of(layout.GetLines()),
            **self.arguments(),
        )  # fmt: skip
        self.warn_about(results)
        return new_outputs(self, results, [polydata, second])


class _DistanceArrayFilter:
    """A filter of an array of distances."""

    def field(self, polydata):
        """Returns the distances and arguments that all functions of distances have."""
        array = self._distances(polydata)
        name = array.GetName() or ""
        values = values_of(array)
        if values is None or values.shape != (polydata.GetNumberOfPoints(),):
            raise ValueError(
                f"The point array '{name}' of the surface is not numeric with 1 component and one "
                "tuple per point. Use another array"
            )
        data = polydata.GetPointData()
        found = {"distance_array_name": name or DISTANCE}
        if name and math.isnan(self.get("UnreachedValue")):
            found["unreached"] = values_of(data.GetAbstractArray(f"{name}.Unreached"))
        if name:
            found["field_data"] = windows_of(polydata, name)
        found["virtual_sources"] = numbers(
            data, self.get("VirtualSourceArrayName"), "the surface", is_required=False
        )
        return values, found

    def _distances(self, polydata):
        """Returns the array of SetInputArrayToProcess(), or else of DistanceArrayName."""
        arrays = self.GetInformation().Get(vtkAlgorithm.INPUT_ARRAYS_TO_PROCESS())
        request = None if arrays is None else arrays.GetInformationObject(0)
        name = self.get("DistanceArrayName")
        if request is not None and request.Has(vtkDataObject.FIELD_ASSOCIATION()):
            points = (
                vtkDataObject.FIELD_ASSOCIATION_POINTS,
                vtkDataObject.FIELD_ASSOCIATION_POINTS_THEN_CELLS,
            )
            kind = vtkDataObject.FIELD_ATTRIBUTE_TYPE()
            if (
                request.Get(vtkDataObject.FIELD_ASSOCIATION()) not in points
                or request.Get(vtkAlgorithm.INPUT_PORT())
                or (request.Has(kind) and request.Get(kind) != vtkDataSetAttributes.SCALARS)
            ):
                raise ValueError(
                    "The array to process is not a point array of the surface, or not scalars. "
                    "Call SetInputArrayToProcess() with port 0 and FIELD_ASSOCIATION_POINTS, and a "
                    "name or SCALARS"
                )
            name = request.Get(vtkDataObject.FIELD_NAME())
        data = polydata.GetPointData()
        array = data.GetAbstractArray(name) if name else data.GetScalars()
        if array is None:
            arrays = (data.GetArrayName(i) for i in range(data.GetNumberOfArrays()))
            names = ", ".join(f"'{array}'" for array in arrays)
            lack = f"is no point array '{name}'" if name else "are no active point scalars"
            raise ValueError(
                f"There {lack} with distances. The point arrays are {names}. Set DistanceArrayName "
                "to one of them, or connect a distance filter"
            )
        return array


@task
class vtkApolloniusIsolines(_DistanceArrayFilter):
    def initial_results(self):
        return {"NumberOfFallbacks": 0, "UsedVirtualSources": False, "UsedWindows": False}

    def SetValue(self, i: int, value: float) -> None:
        """Sets a value of the isolines."""
        values = self.contours()
        values += [0.0] * (i + 1 - len(values))
        values[max(i, 0)] = float(value)
        self._set_contours(values)

    def GetValue(self, i: int) -> float:
        """Returns a value of the isolines."""
        values = self.contours()
        return values[min(max(i, 0), len(values) - 1)]

    def GetValues(self) -> Tuple[float, ...]:
        """Returns the values of the isolines."""
        return tuple(self.contours())

    def SetNumberOfContours(self, number: int) -> None:
        """Sets the number of values. New values are 0."""
        values = self.contours()[: max(number, 0)]
        self._set_contours(values + [0.0] * (number - len(values)))

    def GetNumberOfContours(self) -> int:
        """Returns the number of values."""
        return len(self.contours())

    def GenerateValues(self, number: int, *limits: Union[float, Sequence[float]]) -> None:
        """Makes evenly spaced values, including both ends of the range."""
        values = vtkContourValues()
        values.GenerateValues(number, *limits)
        self._set_contours([values.GetValue(i) for i in range(number)])

    def contours(self):
        return list(getattr(self, "_contours", [0.0]))

    def _set_contours(self, values):
        if values != self.contours():
            self._contours = values
            self.Modified()

    def run(self, polydata):
        distances, field = self.field(polydata)
        if self.get("Method") == self.Linear:
            field = {k: v for k, v in field.items() if k not in ("field_data", "virtual_sources")}
        arguments = {**self.arguments("NumberOfContours"), **field, "values": self.contours()}
        results = kernel.isolines(self.surface, distances, **arguments)
        self.warn_about(results)
        lines = results[0]
        self.set_results(
            NumberOfFallbacks=lines.number_of_fallbacks, UsedWindows=lines.used_windows,
            UsedVirtualSources=lines.used_virtual_sources,
        )  # fmt: skip
        return new_outputs(self, results, [polydata] * 3)


@task
class vtkGeodesicProbe(_DistanceArrayFilter):
    def run(self, polydata):
        probes = self.input(1)
        distances, field = self.field(polydata)
        arguments = {**self.arguments(), **field}
        result = kernel.probe(self.surface, distances, self.points(1), **arguments)
        self.warn_about([result])
        output = shallow_copy(probes)
        _remove_distances(output, field["distance_array_name"])
        add_result(result, output)
        return [output]


class _GraphBuilder:
    """A filter that builds a graph and predicts its size."""

    def initial_results(self):
        return {"NumberOfGraphEdges": 0, "MeanDegree": 0.0, "MemorySize": 0, "InputGraphDamage": ""}

    def ReleaseGraph(self) -> None:
        """Releases the graph that is kept between updates."""
        self._graph = None

    def describe(self, graph, number_of_points):
        edges = graph.number_of_edges
        self.set_results(
            NumberOfGraphEdges=edges, MeanDegree=edges / number_of_points,
            MemorySize=graph.memory_size, GraphBuildTime=self._build_time.GetMTime(),
        )  # fmt: skip

    def with_graph(self, polydata):
        """Returns a shallow copy with the arrays of the graph that is kept, which filters
        downstream recognize."""
        kept = self._graph
        output = shallow_copy(polydata)
        if kept.graph.is_stored:
            return output
        if not hasattr(kept, "arrays"):
            found = kept.graph.arrays
            kept.arrays = [vtk_array(found[name], name) for name in GRAPH_ARRAYS if name in found]
        remove_graph(output)
        for array in kept.arrays:
            output.GetFieldData().AddArray(array)
        return output


@task
class vtkDiscreteGeodesicGraph(_GraphBuilder):
    def EstimateMemory(self) -> int:
        """Predicts the memory of the graph. Returns the number of bytes, 0 after an error."""
        if self.GetNumberOfInputConnections(0):
            self.GetInputAlgorithm().Update(self.GetInputConnection(0, 0).GetIndex())
        self._inputs = [self.GetInput()]
        code, results = self._error_code, self._found
        found = self.attempt(self._predict)
        self._found = dict(results, EstimatedMemory=0, EstimatedPeakMemory=0)
        self._inputs = []
        if found:
            self._error_code = code
            self.set_results(EstimatedMemory=int(found.memory), EstimatedPeakMemory=int(found.peak))
        return self._found["EstimatedMemory"]

    def _predict(self):
        polydata = self.input(0)
        if polydata is None:
            raise ValueError("There is no input. Connect input port 0")
        if polydata.GetNumberOfPoints() == 0:
            self.warn("The input is empty: it has neither points nor cells")
            return None
        surface = self.prepare(0, polydata)
        return kernel.Graph.estimate(surface, **self.arguments("GenerateGraphLines"))

    def arguments(self, *others):
        return {**super().arguments(*others), "accuracy": self.get("Accuracy")}

    def run(self, polydata):
        arguments = self.arguments("GenerateGraphLines")
        names = ("accuracy", "construction", "number_of_neighbors")
        options = {name: arguments[name] for name in names}
        graph = self.find_or_build(graph_arrays(polydata), must_match=True, **options).graph
        self.set_results(InputGraphDamage=graph.damage)
        lines = vtkPolyData()
        if self.get("GenerateGraphLines"):
            found = graph.lines(progress=self.advance, memory_limit=self.get("MemoryLimit"))
            lines.SetPoints(polydata.GetPoints())
            lines.SetLines(cells_of(*found.cells["lines"]))
            add_result(found, lines)
        self.describe(graph, polydata.GetNumberOfPoints())
        return [self.with_graph(polydata), lines]


@task
class vtkPointCloudDGG(_GraphBuilder):
    def is_cloud(self, polydata):
        return True

    def GetNumberOfComponents(self) -> int:
        """Returns the number of components of the last update."""
        return len(self._sizes())

    def GetComponentSize(self, i: int) -> int:
        """Returns the number of points of a component."""
        return int(self._sizes()[i]) if 0 <= i < len(self._sizes()) else 0

    def _sizes(self):
        return self._found.get("ComponentSizes", ())

    def run(self, polydata):
        if not hasattr(kernel, "cloud_graph"):
            raise ValueError("vtkDGG was built without point clouds. Build it with DGG_WITH_PCL")
        if not self.get("ComponentArrayName"):
            raise ValueError("ComponentArrayName is empty. Use a name")
        if self.get("EstimateNormals"):
            raise ValueError("EstimateNormals is on, but not available in Python. Turn it off")
        normals = polydata.GetPointData().GetNormals() if self.get("UseInputNormals") else None
        others = ("UseInputNormals", "EstimateNormals", "GenerateVertices", "NumberOfNeighbors")
        arguments = self.arguments("ComponentArrayName", *others)
        key = (
            {k: v for k, v in arguments.items() if k not in ("progress", "memory_limit")},
            TimeStamps([] if normals is None else [normals]),
        )
        kept = self._graph
        if not (kept and kept.key == key and kept.surface is self.surface):
            self._graph = None  # released before another is built
            found = kernel.cloud_graph(self.surface, normals=values_of(normals), **arguments)
            self._build_time.Modified()
            self._graph = SimpleNamespace(
                key=key, graph=found.graph, surface=self.surface, found=found
            )
            self.warn_about([found])
        found = self._graph.found
        self.describe(found.graph, polydata.GetNumberOfPoints())
        statistics = found.statistics
        used = ("offset_in_voxels", "resolution", "alpha")
        names = {"number_of_coincident_points", "number_of_outliers", "number_of_unused_points"}
        names |= {"spacing", "noise", "noise_by_radius", "off_surface_share", "scatter", "reach"}
        values = {property_of(name): statistics[name] for name in names | {"voxel_size"}}
        values.update({f"Used{property_of(name)}": statistics[name] for name in used})
        values["UsedOffset"] = statistics["offset_in_voxels"] * statistics["voxel_size"]
        self.set_results(ComponentSizes=found.component_sizes, **values)
        output = self.with_graph(polydata)
        components = vtk_array(found.components, self.get("ComponentArrayName"))
        output.GetPointData().AddArray(components)
        if self.get("GenerateVertices") and output.GetNumberOfCells() == 0:
            count = polydata.GetNumberOfPoints()
            output.SetVerts(cells_of(np.array([0, count]), np.arange(count)))
            output.GetCellData().Initialize()
        return [output]
