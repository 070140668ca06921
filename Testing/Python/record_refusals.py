# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Wrong properties, ids, inputs, arrays and files, which filters refuse or accept. Each is a
working case of record_cases.py with one change."""

import os
import struct

import numpy as np
import record_cases
import support
import vtkdgg
from record_cases import own_methods
from support import add_array, make
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

# By scene: one of each filter, and of each method with inputs of its own.
GOOD = {
    "terrain": [
        "exact-points",
        "heat",
        "marching",
        "graph-Guaranteed",
        "graph-SaddleVertexGraph",
        "distance",
        "matrix-points",
        "path",
        "path-exact",
        "isolines",
        "isolines-graph",
        "probe-exact",
        "probe-distance",
        "voronoi",
        "sampler",
        "patches",
        "greens",
        "biharmonic",
        "spline-solution",
        "movers",
        "movers-points",
        "graphics",
        "graphics-type-1",
        "off",
    ],
    "prism": ["loop-taut", "loop-rope-taut"],  # without rims, which take long
    "bumpy-cloud": [
        "cloud-C",
        "distance",
        "matrix-points",
        "path",
        "voronoi",
        "sampler",
        "pcd-0",
        "pcd-writer-1",
    ],
}
NUMBERS = [0.0, -1.0, np.nan, np.inf, 1e-9, 0.3]
WORDS = ["", None, "missing"]
IDS = [[], [-1], [10**6], [0, 0], [0, 1, 2]]


def moved(place, value):
    """Returns a function for a terrain with a moved point."""

    def build():
        data = record_cases.terrain()
        data.GetPoints().SetPoint(place, value, 0.0, 0.0)
        return data

    return build


def scaled(factor):
    def build():
        points, triangles = support.grid(3, 3)
        return support.polydata(factor * points, triangles)

    return build


def of(points, *cells):
    """Returns a function for polygons with any numbers of corners."""
    return lambda: support.polydata(points, Polys=cells)


def contradicting():
    """Returns cells whose offsets exceed the number of ids."""
    data = support.polydata(*support.grid(1, 1))
    offsets, ids = (
        numpy_to_vtk(np.array(values, dtype=np.int64), deep=True)
        for values in ([0, 3, 90], [0, 1, 3, 0, 3, 2])
    )
    data.GetPolys().SetData(offsets, ids)
    return data


def apart():
    """Returns two components, and a point without triangles."""
    points, triangles = support.grid(3, 3)
    everywhere = np.vstack([points, points + [9.0, 0.0, 0.0], [[0.5, 0.5, 0.0]]])
    return support.polydata(everywhere, np.vstack([triangles, triangles + len(points)]))


def doubled():
    """Returns a surface with every triangle twice."""
    points, triangles = support.grid(5, 4)
    return support.polydata(points, np.vstack([triangles, triangles[:, ::-1]]))


def lines():
    """Returns points with lines and verts."""
    data = support.polyline(support.grid(2, 2)[0])
    data.SetVerts(data.GetLines())
    return data


CORNERS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0.5, 0, 0], [0, 0, 1]]
DATA = {
    "nothing": lambda: None,
    "empty": vtkPolyData,
    "image": vtkImageData,
    "points": lambda: support.polydata(CORNERS),
    "lines": lines,
    "NaN": moved(5, np.nan),
    "infinite": moved(5, np.inf),
    "far away": moved(5, 1e6),
    "id": of(CORNERS, [0, 1, 2], [0, 1, 7]),
    "negative id": of(CORNERS, [0, 1, -5]),
    "contradicting": contradicting,
    "no triangle": of(CORNERS, [0, 0, 0], [0, 1], [2], [0, 1, 0, 1]),
    "one place": of(np.ones((3, 3)), [0, 1, 2]),
    "quads": of(CORNERS, [0, 1, 3, 2]),
    "cap": of(CORNERS, [0, 4, 1], [0, 1, 2], [1, 3, 2]),
    "three on an edge": of(CORNERS, [0, 1, 2], [0, 1, 3], [0, 1, 5]),
    "one triangle": of(CORNERS, [0, 1, 2]),
    "doubled": doubled,
    "apart": apart,
    "huge": scaled(1e100),
    "tiny": scaled(1e-100),
}


def properties_of(algorithm):
    """Yields names and values of the properties of our classes."""
    for name in own_methods(algorithm):
        if name.startswith("Set") and hasattr(algorithm, f"Get{name[3:]}"):
            try:
                yield name[3:], getattr(algorithm, f"Get{name[3:]}")()
            except TypeError:  # it is not one value
                pass


def set_property(name, value):
    return lambda algorithm: getattr(algorithm, f"Set{name}")(value)


def wrong_properties(algorithm):
    """Yields changes of properties: all choices, and values out of range."""
    for name, value in properties_of(algorithm):
        if isinstance(value, bool):
            values = [not value]
        elif isinstance(value, int):
            most = getattr(algorithm, f"Get{name}MaxValue", lambda: 10**9)()
            values = range(most + 1) if most < 5 else [-1, 0, 1, 3]
            values = [1000, 100_000] if name == "MemoryLimit" else values
        elif isinstance(value, float):
            values = NUMBERS
        elif isinstance(value, tuple):
            values = [(np.nan,) * len(value), (0.5,) * len(value)]
        elif isinstance(value, str) or value is None and name.endswith("Name"):
            values = WORDS
        else:
            continue
        for wrong in values:
            yield f"{name} {wrong}", set_property(name, wrong)
    for name in dir(algorithm):
        if name.startswith("Set") and name.endswith("Ids"):
            for ids in IDS:
                yield f"{name[3:]} {ids}", set_property(name[3:], ids)
    if hasattr(algorithm, "AddPair"):
        for pair in ((0, 10**6), (-1, 0), (0, 0)):
            yield f"Pair {pair}", lambda algorithm, pair=pair: algorithm.AddPair(*pair)


def put(port, data):
    def change(algorithm):
        algorithm.SetInputDataObject(port, data())

    return change


def wrong_inputs(algorithm):
    for port in range(algorithm.GetNumberOfInputPorts()):
        for name, data in DATA.items():
            yield f"port {port} {name}", put(port, data)
    if algorithm.GetNumberOfInputPorts() and hasattr(algorithm, "UpdatePiece"):
        yield "piece", lambda algorithm: algorithm.UpdatePiece(0, 2, 0)


def tamper(where, name, how):
    """Returns a change of an array of a copy of the input."""

    def change(algorithm):
        source = algorithm.GetInputAlgorithm(0, 0)
        source.Update()
        data = support.copy_of(source.GetOutputDataObject(0))
        arrays = getattr(data, f"Get{where}")()
        array = arrays.GetArray(name)
        values = np.array(vtk_to_numpy(array))
        arrays.RemoveArray(name)
        if how == "text":
            words = vtkStringArray()
            words.SetName(name)
            words.SetNumberOfValues(array.GetNumberOfTuples())
            arrays.AddArray(words)
        elif how != "removed":
            add_array(arrays, name, CHANGES[how](values))
        algorithm.SetInputData(data)

    return change


def with_value(place, number):
    """Returns a change of one value, converted to the type of the array."""

    def change(values):
        flat = values.reshape(-1)
        if flat.size:
            kind = flat.dtype
            wrong = number if kind.kind == "f" else np.nan_to_num(number, posinf=10**9)
            flat[int(place * (flat.size - 1))] = np.array(wrong).astype(kind)
        return values

    return change


def next_to(values):
    """Replaces the middle value by the next representable one."""
    flat = values.reshape(-1)
    if flat.size:
        i = flat.size // 2
        flat[i] = np.nextafter(flat[i], np.inf) if flat.dtype.kind == "f" else flat[i] + 1
    return values


CHANGES = {
    "removed": None,
    "text": None,
    "empty": lambda values: values[:0],
    "shorter": lambda values: values[: len(values) // 2],
    "longer": lambda values: np.concatenate([values, values]),
    "another type": lambda values: values.astype(np.int32 if values.dtype.kind == "f" else float),
    "wide": lambda values: np.column_stack([values, values]),
    "first -1": with_value(0.0, -1),
    "middle 1e9": with_value(0.5, 1e9),
    "last 0": with_value(1.0, 0),
    "NaN": with_value(0.3, np.nan),
    "next": next_to,
}


def tampered(algorithm):
    """Yields all changes of all arrays of the input."""
    if not algorithm.GetNumberOfInputPorts():
        return
    source = algorithm.GetInputAlgorithm(0, 0)
    source.Update()
    data = source.GetOutputDataObject(0)
    for where in ("PointData", "FieldData"):
        arrays = getattr(data, f"Get{where}")()
        for i in range(arrays.GetNumberOfArrays()):
            for how in CHANGES:
                name = arrays.GetArrayName(i)
                yield f"{where} {name} {how}", tamper(where, name, how)


def refusals_of(scene):
    """Yields name, function and changes of the cases of a scene."""
    cases = record_cases.cases_of(scene)

    def changes(algorithm):
        return *wrong_properties(algorithm), *wrong_inputs(algorithm), *tampered(algorithm)

    for name in GOOD.get(scene.name, []):
        if name in cases:
            yield name, cases[name], changes


# --- Files ---------------------------------------------------------------------------------------

OFF = b"STCNOFF\n3 2 3\n0 0 0 0 0 1 255 0 0 0 0\n1 0 0 0 0 1 255 0 0 0 0\n"
OFF += b"0 1 0 0 0 1 255 0 0 0 0\n3 0 1 2 10 20 30\n2 0 1\n"
BINARY_OFF = b"OFF BINARY\n" + struct.pack(">3i9f5i", 3, 1, 0, *range(9), 3, 0, 1, 2, 0)
PCD = b"# .PCD\nVERSION 0.7\nFIELDS x y z i\nSIZE 4 4 4 2\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 2\n"
PCD += b"HEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n0 1 2 3\n4 5 6 7\n"
BINARY_PCD = PCD[: PCD.index(b"ascii")] + b"binary\n" + struct.pack("<3fH3fH", *range(8))
PACKED_PCD = PCD[: PCD.index(b"ascii")] + b"binary_compressed\n"
PACKED_PCD += struct.pack("<2I", 29, 28) + b"\x1b" + bytes(28)
SWAPS = [
    (b"OFF", b"4OFF"),
    (b"3 2 3", b"3 x 3"),
    (b"3 2 3", b"-1 2 3"),
    (b"3 2 3", b"1000000000 2 3"),
    (b"3 0 1 2", b"3 0 1 9"),
    (b"1 0 0 0", b"1 nan 0 0"),
    (b"x y z i", b"x y i i"),
    (b"x y z i", b"a b c i"),
    (b"4 4 4 2", b"4 4 4"),
    (b"4 4 4 2", b"4 4 2 2"),
    (b"F F F U", b"F F F D"),
    (b"F F F U", b"F F D U"),
    (b"1 1 1 1", b"1 1 2 1"),
    (b"1 1 1 1", b"1 1 1 2000000000"),
    (b"WIDTH 2", b"WIDTH 3"),
    (b"WIDTH 2\n", b""),
    (b"HEIGHT 1", b"HEIGHT 9223372036854775807"),
    (b"POINTS 2", b"POINTS 100000000"),
    (b"0 0 0 1 0 0 0", b"0 0 nan 1 0 0 0"),
    (b"DATA ", b"DATA text"),
    (b"VERSION", b"UNITS"),
    (b"4 5 6 7", b"4 5 6 -7"),
    (b"4 5 6 7", b"4 5 6 1e9"),
    (b"4 5 6 7", b"4 5 6"),
    (b"4 5 6 7\n", b"4 5 6 7\n8 9 10 11\n"),
]


def damaged(content):
    """Yields damaged contents: truncated, with replaced words, with random bytes."""
    yield "whole", content
    for length in range(0, len(content), 3):
        yield f"cut at {length}", content[:length]
    for before, after in SWAPS:
        if before in content:
            yield f"{after} for {before}", content.replace(before, after, 1)
    rng = np.random.default_rng(7)
    for i in range(100):
        bytes_ = np.frombuffer(content, dtype=np.uint8).copy()
        bytes_[rng.integers(0, len(bytes_), 3)] = rng.integers(0, 256, 3)
        yield f"random {i}", bytes_.tobytes()


FORMATS = {
    "OFF": ("vtkDGGOFFReader", OFF),
    "binary OFF": ("vtkDGGOFFReader", BINARY_OFF),
    "PCD": ("vtkPCDReader", PCD),
    "binary PCD": ("vtkPCDReader", BINARY_PCD),
    "packed PCD": ("vtkPCDReader", PACKED_PCD),
}


def readers_of(kind, folder):
    """Yields names and readers of damaged files."""
    name, content = FORMATS[kind]
    for what, damage in damaged(content):
        path = os.path.join(folder, "damaged")
        with open(path, "wb") as file:
            file.write(damage)
        reader = getattr(vtkdgg, name)()
        reader.SetFileName(path)
        yield what, reader


# --- Functions of the package --------------------------------------------------------------------


def calls():
    """Yields names and functions of calls with wrong arguments."""
    points, triangles = support.grid(2, 2)
    bad = points.copy()
    bad[4, 1] = np.nan
    for name, wrong in {
        "flat": points[:, :2],
        "ravel": points.ravel(),
        "ragged": [[0, 0, 0], [1, 0]],
        "text": [["a", "b", "c"]],
        "complex": points.astype(complex),
        "NaN": bad,
        "masked": np.ma.masked_equal(points, 2.0),
        "one": [[0, 0, 0]],
        "none": [],
    }.items():
        yield f"points {name}", lambda wrong=wrong: vtkdgg.distance(wrong, triangles, 0)
    for wrong in ([[0, 1, 2, 3]], [[0.0, 1.0, 2.0]], [[True, False, True]], [[0, 1, 9]]):
        yield f"triangles {wrong}", lambda wrong=wrong: vtkdgg.distance(points, wrong, 0)
    yield "triangles none", lambda: vtkdgg.distance(points, [], 0)
    sources = [9, [0, -1], [], 1.0, [0.5, 0.5, 0.0], [True], "first", None, [[0.0, 1.0]], 2**70]
    sources += [[[np.nan, 0.0, 0.0]], [[0.0, 0.0, 1.0]]]
    options = {
        "maximum_distance": [-1.0, np.nan, "far"],
        "unreached": ["x", None, 10**400],
        "projection_tolerance": [-0.1, np.nan, "x"],
        "accuracy": ["high", 0.0, -0.1, 0.6, np.nan],
    }
    graph = vtkdgg.Graph(points, triangles, accuracy=0.1)
    for wrong in sources:
        yield f"sources {wrong}", lambda wrong=wrong: vtkdgg.distance(points, triangles, wrong)
        yield f"Graph sources {wrong}", lambda wrong=wrong: graph.distance(wrong)
        yield f"Graph rows {wrong}", lambda wrong=wrong: graph.matrix(wrong)
        yield f"Graph end {wrong}", lambda wrong=wrong: graph.path(0, wrong)
        yield f"end {wrong}", lambda wrong=wrong: vtkdgg.path(points, triangles, 0, wrong)
    for name, values in options.items():
        for wrong in values:

            def call(given={name: wrong}):
                return vtkdgg.distance(points, triangles, 0, **given)

            yield f"{name} {str(wrong)[:20]}", call
    for detour in (-0.1, 0.2, np.nan, "far"):
        yield f"detour {detour}", lambda detour=detour: graph.path(0, 8, detour=detour)
    cloud = support.polydata(points)
    for name, data in (("mesh", support.polydata(points, triangles)), ("cloud", cloud)):
        yield f"from {name}", lambda data=data: vtkdgg.Graph.from_polydata(data)
    for kind in (None, 3, "reader", cloud):
        yield f"check {type(kind).__name__}", lambda kind=kind: vtkdgg.check(kind)
    if "vtkPointCloudDGG" in vtkdgg.build_info.CLASSES:
        with_graph = vtkdgg.check(make("vtkPointCloudDGG", record_cases.bumpy_cloud()))
        yield "from cloud graph", lambda: vtkdgg.Graph.from_polydata(with_graph)
