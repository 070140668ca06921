# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compiled and Python filters: the same pipelines give the same outputs, errors and times."""

import unittest

import numpy as np
import support
import vtkdgg
from support import HAS_CLOUDS
from test_kernel import torus
from vtkdgg import pipeline, python_filters
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    VTK_BIT,
    VTK_ID_TYPE,
    vtkBitArray,
    vtkDataArray,
    vtkPoints,
    vtkStringArray,
)
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataSetAttributes,
    vtkMultiBlockDataSet,
    vtkPolyData,
)

HAS_COMPILED = vtkdgg.vtkDGGDistance is not python_filters.vtkDGGDistance
needs_compiled = unittest.skipUnless(HAS_COMPILED, "there are no compiled classes")
ATTRIBUTES = range(vtkDataSetAttributes.NUM_ATTRIBUTES)


def add(data, name, values, active=None, data_type=None):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True, array_type=data_type)
    array.SetName(name)
    data.AddArray(array)
    if active:
        getattr(data, f"SetActive{active}")(name)


def add_strings(data, name, count):
    for kind, set_value in (
        (vtkStringArray, lambda a, i: a.SetValue(i, f"{name} {i}")),
        (vtkBitArray, lambda a, i: a.SetValue(i, i % 3 == 0)),
    ):
        array = kind()
        array.SetName(f"{name} {kind.__name__}")
        array.SetNumberOfValues(count)
        for i in range(count):
            set_value(array, i)
        data.AddArray(array)


def decorate(mesh, seed):
    """Adds arrays of all kinds."""
    random = np.random.default_rng(seed)
    for kind, count in (("Point", mesh.GetNumberOfPoints()), ("Cell", mesh.GetNumberOfCells())):
        data = getattr(mesh, f"Get{kind}Data")()
        add(data, "Float", random.normal(size=count).astype("f4"))
        add(data, "Infinite", np.where(np.arange(count) % 7, 1.5, np.inf).astype("f4"))
        add(data, "Pair", random.normal(size=(count, 2)))
        for dtype in ("i1", "u1", "i2", "u4", "i8", "u8"):
            limits = np.iinfo(dtype)
            add(data, dtype, random.integers(limits.min, limits.max, count, dtype=dtype))
        add(data, "Ids", np.arange(count), data_type=VTK_ID_TYPE)
        add(data, "Pedigree", np.arange(count), "PedigreeIds", VTK_ID_TYPE)
        add(data, "Normals", random.normal(size=(count, 3)).astype("f4"), "Normals")
        add(data, "Short", np.arange(count - 1))
        add_strings(data, kind, count)
        data.SetActiveScalars("Float")
    add(mesh.GetFieldData(), "Note", np.arange(3))
    return mesh


def polydata(points, lines=(), polygons=()):
    """Returns points, lines and polygons as a vtkPolyData."""
    result = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    result.SetPoints(coordinates)
    for name, rows in (("Lines", lines), ("Polys", polygons)):
        cells = vtkCellArray()
        for row in rows:
            cells.InsertNextCell(len(row), row)
        getattr(result, f"Set{name}")(cells)
    return result


POINTS, TRIANGLES = torus()
MESH = decorate(polydata(POINTS.astype("f4"), [[0, 5, 9]], TRIANGLES), 1)
CLOUD = decorate(polydata(support.sphere_points(800)), 2)
PLACES = decorate(polydata(POINTS[[7, 60, 130, 200]] * 1.001), 3)
add(PLACES.GetPointData(), "InitialDistance", [0.0, 0.1, 0.2, 0.0])
add(PLACES.GetPointData(), "Mass", [1, 2, 3, 4])
PAIRS = decorate(polydata(POINTS[[3, 40, 90, 250]], [[0, 1], [2, 3]]), 4)
CORNERS = polydata(POINTS[[0, 60, 150, 220]], [[0, 1], [1, 2], [2, 3]])
CURVES = polydata(POINTS[[2, 14, 26, 98, 110]], [[0, 1, 2], [3, 4]])
add(CURVES.GetCellData(), "LeftColor", [[1.0, 0.5, 0.2], [0.1, 0.9, 0.3]])
add(CURVES.GetCellData(), "RightColor", np.eye(3)[:2])
GRAPH = ("vtkDiscreteGeodesicGraph", MESH, ("SetAccuracy", 0.02))
CLOUD_GRAPH = ("vtkPointCloudDGG", CLOUD, ("GenerateVerticesOn",))
EXACT = ("vtkExactGeodesicDistance", MESH, ("SetSourceIds", [5, 100]), ("GenerateWindowsOn",),
         ("GenerateVirtualSourceOn",))  # fmt: skip
WANTED = (("GenerateNearestSourceOn",), ("GenerateVirtualSourceOn",), ("SetUnreachedValue", -1.0),
          ("SetMaximumDistance", 3.0), ("AddSourceId", 9), ("AddSourceId", 200, 0.25))  # fmt: skip
AT_PLACES = (("SetSourceData", PLACES), ("AddSourceId", 3), ("PassSourceArraysOn",))
DISTANCES = (
    "vtkExactGeodesicDistance", "vtkVirtualSourceGeodesicDistance", "vtkHeatGeodesicDistance",
    "vtkDGGFastMarchingDistance", "vtkDGGDistance",
)  # fmt: skip
SPECTRAL = (("SetSourceIds", [0, 100]), ("SetSourceData", PLACES), ("SetEvaluationData", PLACES))
FILTERS = [
    (getattr(vtkdgg, name), python_filters.get(name))
    for name, entry in python_filters.TABLE.items()
    if "inputs" in entry and hasattr(vtkdgg, name)
]
# Time stamps, and numbers of bytes that depend on the buffers of a search or on a prediction.
OF_MACHINE = {
    "EstimatedMemory", "EstimatedPeakMemory", "GraphBuildTime", "MemorySize", "MeshBuildTime",
}  # fmt: skip
NOT_SERVED = {"GetController", "SetController", "SetOutput"}
# Name of the filter, input or pipeline, calls before the update.
CASES = (
    *((name, MESH, *settings) for name in DISTANCES for settings in (WANTED, AT_PLACES)),
    ("vtkDGGDistance", GRAPH, ("SetSourceIds", [1, 2]), ("GenerateUpperBoundOn",),
     ("SetSearchToDijkstra",), ("CorrectionOff",)),
    ("vtkDGGDistance", CLOUD_GRAPH, ("AddSourceId", 3), ("GenerateNearestSourceOn",)),
    ("vtkExactGeodesicDistance", EXACT, ("SetSourceIds", [7]), ("SetEngineToReference",)),
    ("vtkDGGFastMarchingDistance", CLOUD, ("AddSourceId", 3)),
    ("vtkHeatGeodesicDistance", MESH, ("AddSourceId", 3), ("SetBoundaryToDirichlet",),
     ("SetTimeStepFactor", 2.0), ("MergeCoincidentPointsOn",)),
    ("vtkDiscreteGeodesicGraph", GRAPH, ("GenerateGraphLinesOn",), ("SetAccuracy", 0.02)),
    ("vtkDiscreteGeodesicGraph", MESH, ("GenerateGraphLinesOn",),
     ("SetConstructionToSaddleVertexGraph",), ("SetNumberOfNeighbors", 12)),
    ("vtkPointCloudDGG", CLOUD, ("SetSchemeToA",)),
    ("vtkPointCloudDGG", CLOUD, ("UseInputNormalsOff",), ("SetAccuracy", 0.0)),
    ("vtkDGGPath", MESH, ("AddPair", 0, 100), ("SetPairData", PAIRS)),
    ("vtkDGGPath", GRAPH, ("AddPair", 0, 100), ("StraightenOff",), ("SetOutputPointsPrecision", 0)),
    ("vtkDGGPath", MESH, ("AddPair", 4, 250), ("SetMethodToExact",),
     ("SetOutputPointsPrecision", 2)),
    ("vtkDGGPath", CLOUD_GRAPH, ("AddPair", 4, 250)),
    ("vtkDGGLoop", MESH, ("SetModeToAroundHandles",), ("SetTapeWidth", 0.1)),
    ("vtkDGGLoop", GRAPH, ("SetPointData", PLACES), ("AddPointId", 7), ("SetModeToRope",)),
    ("vtkGeodesicVoronoi", MESH, ("SetSiteIds", [0, 50, 150]), ("SetSiteData", PLACES),
     ("PassSiteArraysOn",)),
    ("vtkGeodesicVoronoi", GRAPH, ("SetSiteIds", [0, 50, 150]), ("CentroidalOn",)),
    ("vtkGeodesicVoronoi", MESH, ("SetSiteIds", [0, 50, 150]), ("PreviewOn",)),
    ("vtkGeodesicVoronoi", CLOUD_GRAPH, ("SetSiteIds", [0, 50, 150])),
    ("vtkGeodesicSampler", MESH, ("SetNumberOfSamples", 12), ("InFacesOn",)),
    ("vtkGeodesicSampler", GRAPH, ("SetStartData", PLACES), ("SetNumberOfSamples", 9)),
    ("vtkGeodesicDistanceMatrix", MESH, ("SetRowIds", [0, 9]), ("SetColumnData", PLACES)),
    ("vtkGeodesicDistanceMatrix", GRAPH, ("SetRowIds", [0, 9, 4]), ("CompressedRowsOn",),
     ("SetMaximumDistance", 2.0), ("CorrectionOn",)),
    ("vtkGeodesicPatchBoundaries", MESH, ("SetSecondSurfaceData", MESH),
     ("SetFirstLandmarkData", CORNERS), ("SetSecondLandmarkIds", [1, 61, 151, 221])),
    ("vtkApolloniusIsolines", EXACT, ("SetValue", 0, 1.5), ("SetValue", 1, 2.5),
     ("GenerateRidgesOn",), ("GenerateBandsOn",)),
    ("vtkApolloniusIsolines", (DISTANCES[1], MESH, *WANTED[1:]), ("GenerateValues", 4, 0.5, 2.5),
     ("SetMethodToApollonius",), ("GenerateBandsOn",)),
    ("vtkApolloniusIsolines", MESH, ("SetInputArrayToProcess", 0, 0, 0, 0, "Float"),
     ("SetMethodToLinear",), ("SetValue", 0, 0.25)),
    ("vtkGeodesicProbe", EXACT, ("SetProbeData", PLACES)),
    *((name, MESH, *SPECTRAL) for name in ("vtkDiscreteGreensFunction", "vtkBiharmonicDistance")),
    ("vtkDiscreteGreensFunction", MESH, ("SetSourceIds", [0]), ("SetOrderToBiLaplace",),
     ("IntrinsicDelaunayOn",), ("SetMethodToVertex",)),
    ("vtkBiharmonicDistance", MESH, ("SetSourceIds", [0]), ("SetMethodToExact",)),
    ("vtkHarmonicBSpline", MESH, *SPECTRAL, ("SetSiteValuesArrayName", "Float"),
     ("SetRightHandSideArrayName", "Float")),
    ("vtkHarmonicBSpline", MESH, ("SetNumberOfSites", 7), ("SetOrderToBiharmonic",),
     ("GenerateBasisOff",), ("SetSiteValuesArrayName", "Float")),
    ("vtkSurfaceEarthMoversDistance", MESH, ("SetFromData", PLACES), ("SetToArrayName", "u1"),
     ("SetMassArrayName", "Mass"), ("SetMaximumNumberOfIterations", 20)),
    ("vtkPoissonVectorGraphics", MESH, ("SetCurveData", CURVES), ("GenerateFragmentsOn",),
     ("SetBackgroundColor", 0.1, 0.2, 0.3), ("SetRefinementRegionToNearCurves",)),
    ("vtkPoissonVectorGraphics", MESH, ("SetCurveData", CURVES), ("SetRefinementLevel", 0)),
)  # fmt: skip
# Name of the filter, wrong calls, correct calls that follow.
REFUSALS = (
    ("vtkDGGDistance", (("SetSourceIds", [9999]),), (("SetSourceIds", [1]),)),
    ("vtkDGGDistance", (("SetAccuracy", 2.0),), (("SetAccuracy", 0.1), ("AddSourceId", 1))),
    ("vtkExactGeodesicDistance", (), (("AddSourceId", 1),)),
    ("vtkExactGeodesicDistance", (("AddSourceId", 1), ("SetMaximumDistance", -1.0)),
     (("SetMaximumDistance", 1.0),)),
    ("vtkHeatGeodesicDistance", (("AddSourceId", 1), ("SetDistanceArrayName", "")),
     (("SetDistanceArrayName", "Distance"),)),
    ("vtkDiscreteGeodesicGraph", (("SetAccuracy", 0.9),), (("SetAccuracy", 0.2),)),
    ("vtkDiscreteGeodesicGraph", (("SetMemoryLimit", 9),), (("SetMemoryLimit", 0),)),
    ("vtkDGGPath", (), (("AddPair", 0, 9),)),
    ("vtkGeodesicVoronoi", (), (("AddSiteId", 9),)),
    ("vtkApolloniusIsolines", (), (("SetDistanceArrayName", "Float"),)),
    ("vtkGeodesicDistanceMatrix", (("SetRowIds", [-1]),), (("SetRowIds", [1]),)),
    ("vtkHarmonicBSpline", (("SetRightHandSideArrayName", "Missing"),),
     (("SetRightHandSideArrayName", "Float"),)),
    ("vtkSurfaceEarthMoversDistance", (), (("SetFromArrayName", "u1"), ("SetToArrayName", "u4"))),
    ("vtkPoissonVectorGraphics", (("SetResultArrayName", "RGB"), ("SetCurveData", CURVES)),
     (("SetResultArrayName", "C"),)),
)  # fmt: skip


def made(filters, case, keep):
    """Returns the filter of a case; those upstream are added to `keep`."""
    name, data, *calls = case
    algorithm = getattr(filters, name)()
    keep.append(algorithm)
    if isinstance(data, tuple):
        algorithm.SetInputConnection(made(filters, data, keep).GetOutputPort())
    else:
        algorithm.SetInputData(data)
    for method, *values in calls:
        getattr(algorithm, method)(*values)
    return algorithm


def reports_of(algorithm):
    """Updates a filter and returns its errors and its warnings, without places and addresses."""
    found = {"ErrorEvent": [], "WarningEvent": []}

    def observe(caller, event, text):
        found[event].append(pipeline._clean(text))

    observe.CallDataType = "string0"
    tags = [algorithm.AddObserver(event, observe) for event in found]
    algorithm.Update()
    for tag in tags:
        algorithm.RemoveObserver(tag)
    return tuple(found.values())


def contents(array):
    """Returns type, shape, name and values of an array."""
    if array is None:
        return None
    described = [array.GetClassName(), array.GetName(), array.GetNumberOfComponents()]
    described += [array.GetNumberOfTuples()]
    if isinstance(array, vtkDataArray) and array.GetDataType() != VTK_BIT:
        values = vtk_to_numpy(array)
        if values.dtype.kind == "f":  # the payload of NaN may differ
            values = np.where(np.isnan(values), np.nan, values)
        return [*described, values.tobytes()]
    return [*described, [array.GetValue(i) for i in range(array.GetNumberOfValues())]]


def parts(data):
    """Yields names and contents of all parts of a data object."""
    if data.IsA("vtkPolyData"):
        yield "Points", data.GetPoints() and contents(data.GetPoints().GetData())
        for kind in ("Verts", "Lines", "Polys", "Strips"):
            cells = getattr(data, f"Get{kind}")()
            if cells.GetNumberOfCells():
                yield kind, contents(cells.GetOffsetsArray())[3:]
                yield kind, contents(cells.GetConnectivityArray())[3:]
        attributes = [("PointData", data.GetPointData()), ("CellData", data.GetCellData())]
    else:
        attributes = [("RowData", data.GetRowData())]
    for kind, of_data in (*attributes, ("FieldData", data.GetFieldData())):
        arrays = [of_data.GetAbstractArray(i) for i in range(of_data.GetNumberOfArrays())]
        yield kind, [a.GetName() for a in arrays]
        for array in arrays:
            yield f"{kind} {array.GetName()}", contents(array)
        if kind != "FieldData":
            active = [of_data.GetAbstractAttribute(i) for i in ATTRIBUTES]
            yield f"active {kind}", [None if a is None else a.GetName() for a in active]


def state(algorithm, name):
    """Returns the value of a property and, if it has choices, their name."""
    if not name.endswith("Ids"):
        return [getattr(algorithm, f"Get{name}")()]
    count = getattr(algorithm, f"GetNumberOf{name}")()
    is_listed = name not in ("RowIds", "ColumnIds")
    return [count] + [getattr(algorithm, f"Get{name[:-1]}")(i) for i in range(count) if is_listed]


def values_of(kind, python):
    """Returns the names of results that both classes of a filter have."""
    entries = (python_filters.TABLE.get(base.__name__, {}) for base in kind.__mro__)
    return {name for entry in entries for name in entry.get("values", ())} - set(python.unavailable)


@needs_compiled
class Pipelines(unittest.TestCase):
    def compare(self, compiled, python):
        """Compares all outputs and values of two filters."""
        for port in range(compiled.GetNumberOfOutputPorts()):
            pair = zip(*(parts(a.GetOutputDataObject(port)) for a in (compiled, python)))
            for (name, expected), (other, found) in pair:
                self.assertEqual((port, name), (port, other))
                self.assertTrue(found == expected, f"port {port}, {name}: {str(found)[:150]} "
                                f"instead of {str(expected)[:150]}")  # fmt: skip
        self.assertEqual(python.GetMeshReport(), compiled.GetMeshReport())
        table, expected = python.GetMeshReportTable(), compiled.GetMeshReportTable()
        self.assertEqual(dict(parts(table)), dict(parts(expected)))
        for name in values_of(type(compiled), type(python)) - OF_MACHINE:
            found, expected = (
                getattr(algorithm, f"Get{name}")() for algorithm in (python, compiled)
            )
            np.testing.assert_equal(found, expected, err_msg=name)

    def test_outputs(self):
        for case in CASES:
            if not HAS_CLOUDS and "Cloud" in str(case):
                continue
            kept = [], []
            with self.subTest(case=(case[0], *case[2:])):
                compiled, python = (
                    made(f, case, k) for f, k in zip((vtkdgg, python_filters), kept)
                )
                (errors, expected), found = reports_of(compiled), reports_of(python)
                self.assertEqual(errors, [])
                self.assertEqual(found, (errors, expected))
                self.compare(compiled, python)
                before = python.GetOutputDataObject(0).GetMTime()
                python.Update()
                self.assertEqual(python.GetOutputDataObject(0).GetMTime(), before)

    def test_errors(self):
        for name, wrong, correct in REFUSALS:
            with self.subTest(name=name, wrong=wrong):
                pair = [made(f, (name, MESH, *wrong), []) for f in (vtkdgg, python_filters)]
                expected, found = map(reports_of, pair)
                self.assertEqual(len(expected[0]), 1)
                first = [texts[0][0].split(". ")[0] for texts in (found, expected)]
                self.assertEqual(*first)  # the action may name other properties
                for algorithm in pair:
                    self.assertNotEqual(algorithm.GetErrorCode(), 0)
                    for port in range(algorithm.GetNumberOfOutputPorts()):
                        output = algorithm.GetOutputDataObject(port)
                        self.assertEqual(output.GetNumberOfElements(0), 0)
                    for method, *values in correct:
                        getattr(algorithm, method)(*values)
                    self.assertEqual(reports_of(algorithm)[0], [])
                    self.assertEqual(algorithm.GetErrorCode(), 0)
                self.compare(*pair)


def calls_of(kind, name):
    """Yields names and arguments of calls that change a property."""
    described = kind.properties[name]
    choices = described.get("choices", ())
    if described["type"] == "bool":
        yield from ((f"{name}On",), (f"{name}Off",), (f"Set{name}", True), (f"Set{name}", True))
    elif described["type"] == "ids":
        yield from ((f"Set{name}", [3, 1]), (f"Set{name}", np.array([3, 1])), (f"Set{name}", None))
    elif described["type"] == "string":
        yield from ((f"Set{name}", value) for value in ("a", "a", "", None, "b"))
    elif described["type"] == "vector":
        yield from ((f"Set{name}", 1.0, 2.0, 3.0), (f"Set{name}", (1.0, 2.0, 3.0)))
    else:
        convert = float if described["type"] == "double" else int
        for value in (*described.get("range", ()), described["default"], 3, 3, -7, 10**6):
            if value == value:
                yield f"Set{name}", convert(value)
    yield from ((f"Set{name}To{choice}",) for choice in choices)


@needs_compiled
class Properties(unittest.TestCase):
    def test_changes(self):
        """Each call has the same value and the same effect on the time of modification."""
        for kind, python in FILTERS:
            for name in python.properties:
                pair = kind(), python()
                for method, *values in calls_of(python, name):
                    with self.subTest(kind=kind.__name__, call=(method, *values)):
                        changes = []
                        for algorithm in pair:
                            before = algorithm.GetMTime()
                            getattr(algorithm, method)(*values)
                            changes.append(algorithm.GetMTime() > before)
                        self.assertEqual(*changes)
                        self.assertEqual(*(state(algorithm, name) for algorithm in pair))

    @unittest.skipUnless(HAS_COMPILED, "built without VTK")
    def test_functions(self):
        """All functions of the compiled classes exist, except those that are not served."""
        for kind, python in FILTERS:
            missing = [n for n in dir(kind) if n[0] != "_" and not hasattr(python, n)]
            missing = {name for name in missing if not name.endswith("Type")}
            others = {f"Get{name}" for name in python.unavailable if hasattr(kind, f"Get{name}")}
            if kind.__name__ == "vtkPointCloudDGG":
                others.add("EstimateMemory")
            self.assertEqual(missing, NOT_SERVED | others)

    def test_values(self):
        """Results before an update are the same."""
        for kind, python in FILTERS:
            for name in values_of(kind, python):
                found = [getattr(algorithm(), f"Get{name}")() for algorithm in (python, kind)]
                with self.subTest(kind=kind.__name__, name=name):
                    np.testing.assert_equal(*found)

    def test_wrong_types(self):
        python = python_filters.vtkDGGDistance()
        for method, value in (
            ("SetAccuracy", "fine"), ("SetSearch", 1.5), ("SetSourceIds", [1.5]),
            ("SetSourceIds", "12"), ("SetDistanceArrayName", 7),
        ):  # fmt: skip
            with self.subTest(method=method, value=value), self.assertRaises(TypeError):
                getattr(python, method)(value)
        with self.assertRaises(TypeError):
            python_filters.vtkGeodesicAlgorithm()
        with self.assertRaises(AttributeError):
            python_filters.vtkMissing  # noqa: B018


@needs_compiled
class Updates(unittest.TestCase):
    def test_kept(self):
        """Surface and graph are built again only after a change of points or polygons."""
        for filters in (vtkdgg, python_filters):
            with self.subTest(filters=filters.__name__):
                mesh = polydata(POINTS, polygons=TRIANGLES)
                path = made(filters, ("vtkDGGPath", mesh, ("AddPair", 0, 9)), [])

                def times(path=path):
                    self.assertEqual(reports_of(path)[0], [])
                    return path.GetMeshBuildTime(), path.GetGraphBuildTime()

                first = times()
                path.AddPair(1, 100)
                self.assertEqual(times(), first)
                for copy in ("ShallowCopy", "DeepCopy"):
                    other = vtkPolyData()
                    getattr(other, copy)(mesh)
                    path.SetInputData(other)
                    self.assertEqual(times(), first)
                path.SetAccuracy(0.1)
                second = times()
                self.assertEqual(second[0], first[0])
                self.assertGreater(second[1], first[1])
                vtk_to_numpy(other.GetPoints().GetData())[:] *= 2
                other.Modified()
                for after, before in zip(times(), second):
                    self.assertGreater(after, before)

    def test_kept_graph(self):
        """A filter downstream recognizes the graph after an update that did not build it again."""
        for filters in (vtkdgg, python_filters):
            graph = made(filters, GRAPH, [])
            graph.Update()
            arrays = [graph.GetOutput().GetFieldData().GetAbstractArray("DGG.Targets")]
            built = graph.GetGraphBuildTime()
            graph.GenerateGraphLinesOn()
            graph.Update()
            arrays.append(graph.GetOutput().GetFieldData().GetAbstractArray("DGG.Targets"))
            self.assertIs(*arrays)
            self.assertEqual(graph.GetGraphBuildTime(), built)
            graph.ReleaseGraph()
            graph.Modified()
            graph.Update()
            self.assertGreater(graph.GetGraphBuildTime(), built)

    def test_estimate(self):
        found = []
        for filters in (vtkdgg, python_filters):
            graph = made(filters, GRAPH, [])
            found.append((graph.EstimateMemory(), graph.GetEstimatedPeakMemory()))
            graph.SetAccuracy(0.9)
            tag = graph.AddObserver("ErrorEvent", lambda *_: None)
            self.assertEqual(graph.EstimateMemory(), 0)
            graph.RemoveObserver(tag)
            self.assertNotEqual(graph.GetErrorCode(), 0)
        self.assertEqual(*found)
        self.assertGreater(found[0][1], found[0][0])

    def test_input_graph(self):
        """The graph on the input is used, and warnings are those of compiled filters."""
        for accuracy, count in ((0.1, 0), (0.001, 1)):
            warnings = []
            for filters in (vtkdgg, python_filters):
                calls = ("SetAccuracy", accuracy), ("AddSourceId", 7)
                distance = made(filters, ("vtkDGGDistance", GRAPH, *calls), [])
                found = []
                distance.AddObserver("WarningEvent", lambda *_, found=found: found.append(1))
                distance.Update()
                distance.AddSourceId(9)
                distance.Update()
                self.assertTrue(distance.GetUsedInputGraph())
                self.assertEqual(distance.GetGraphAccuracy(), 0.02)
                warnings.append(len(found))
            self.assertEqual(warnings, [count, count])

    def test_names_in_errors(self):
        """Errors about arguments of the kernel name the properties."""
        for method, value, pattern in (
            ("SetAccuracy", 0.9, "Accuracy is 0.9"),
            ("SetMemoryLimit", -1, "MemoryLimit: expected a number of bytes"),
        ):
            distance = made(python_filters, ("vtkDGGDistance", MESH, (method, value)), [])
            self.assertRegex(reports_of(distance)[0][0], f" {pattern}")

    def test_memory_of_a_matrix(self):
        """The matrix and its copy count."""
        size = 8 * len(POINTS) ** 2
        ids = list(range(len(POINTS)))
        for factor, count in ((1.5, 1), (2.5, 0)):
            calls = ("SetMemoryLimit", int(factor * size)), ("SetRowIds", ids)
            matrix = made(python_filters, ("vtkGeodesicDistanceMatrix", GRAPH, *calls), [])
            self.assertEqual(len(reports_of(matrix)[0]), count)

    def test_abort(self):
        for filters in (vtkdgg, python_filters):
            with self.subTest(filters=filters.__name__):
                distance = made(filters, ("vtkDGGDistance", MESH, ("AddSourceId", 7)), [])
                progress = []
                stops = [True]

                def observe(caller, _, progress=progress, stops=stops):
                    progress.append(caller.GetProgress())
                    caller.SetAbortExecute(int(stops[0]))

                distance.AddObserver("ProgressEvent", observe)
                self.assertEqual(reports_of(distance)[0], [])
                self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
                stops[0] = False
                progress.clear()
                distance.Modified()
                self.assertEqual(reports_of(distance)[0], [])
                self.assertEqual(distance.GetOutput().GetNumberOfPoints(), len(POINTS))
                self.assertEqual(progress, sorted(progress))
                self.assertEqual(progress[-1], 1.0)

    def test_other_inputs(self):
        """Blocks, pieces, and no input are errors; an empty input gives an empty output."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, MESH)
        distance = python_filters.vtkExactGeodesicDistance()
        distance.AddSourceId(0)
        for data, pattern in ((blocks, "vtkAppendPolyData"), (None, "Connect input port 0"),
                              (CLOUD, "no polygons")):  # fmt: skip
            distance.SetInputData(data)
            self.assertRegex(reports_of(distance)[0][0], pattern)
            self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
        distance.SetInputData(vtkPolyData())
        self.assertEqual(reports_of(distance)[0], [])
        distance.SetInputData(MESH)
        silence = distance.AddObserver("ErrorEvent", lambda *_: None)
        distance.UpdatePiece(0, 2, 0)
        self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
        distance.RemoveObserver(silence)
        distance.UpdatePiece(0, 1, 0)
        self.assertEqual(distance.GetOutput().GetNumberOfPoints(), len(POINTS))

    def test_check(self):
        distance = made(python_filters, ("vtkDGGDistance", MESH, ("SetSourceIds", [288])), [])
        pattern = "^vtkDGGDistance: Source id 288 is out of range"
        with self.assertRaisesRegex(vtkdgg.VTKError, pattern):
            vtkdgg.check(distance)
        distance.SetSourceIds([1])
        self.assertEqual(vtkdgg.check(distance).GetNumberOfPoints(), len(POINTS))


if __name__ == "__main__":
    unittest.main()
