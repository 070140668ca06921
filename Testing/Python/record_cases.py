# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cases of record.py: all filters with all their methods and modes on surfaces and clouds.

A case takes a Scene and returns an algorithm that is ready to be updated, or a dict of results."""

import os
import pickle
import warnings

import numpy as np
import support
import sweep_meshes
import vtkdgg
from support import add_array, make
from sweep_trial import Surface
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm
from vtkmodules.vtkIOCore import vtkWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

ACCURACY = 0.05  # accuracy of the graph in files
SMALL, MIDDLE, LARGE = 2500, 7000, 15_000  # most points of slow cases
CONSTRUCTIONS = ["Guaranteed", "OneRelay", "Indirect", "SaddleVertexGraph"]
SCHEMES = ["A", "B", "C"]
FILES = """
    eight awkward/z_bar_clamp awkward/psu_cover ellipsoid awkward/camel_cut_seams
    awkward/bathtub_shapenet awkward/teapot_seams awkward/einsy_base fertility
    awkward/capsule_degenerate fandisk blade_aniso awkward/pig_pinched kitten aneurysm
    clouds/kitten clouds/milk_carton clouds/bunny_points clouds/rops_scan clouds/lidar_samp11
""".split()
SEEDS = range(20, 34)  # generated meshes, one of each family


class Scene:
    """A surface or a cloud, points on it, and folders for files and for graphs."""

    def __init__(self, name, data, folder, graphs):
        self.name, self.data, self.folder, self.graphs = name, data, folder, graphs
        self.points = np.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=float)
        self.size = np.linalg.norm(np.ptp(self.points, axis=0))
        self.is_cloud = data.GetNumberOfPolys() == 0
        if self.is_cloud:
            rng = np.random.default_rng(sum(name.encode()))
            ids = rng.choice(len(self.points), 6, replace=False)
            self.inner, self.sources = ids[:4].tolist(), sorted(ids[:2].tolist())
            self.places = self.points[ids[4:]]
            return
        self.triangles = support.triangles_of(data)
        surface = Surface(sweep_meshes.Mesh(name, self.points, self.triangles))
        self.inner, self.sources = surface.inner.tolist(), surface.sources.tolist()
        wide = surface.areas > 1e-3 * surface.sides.max(axis=1) ** 2
        ours = surface.component[surface.triangles[:, 0]] == surface.component[self.inner[0]]
        faces = surface.rng.permutation(np.flatnonzero(surface.once & wide & ours))[:5]
        weights = surface.rng.dirichlet([3, 3, 3], len(faces))
        self.places = np.einsum("ij,ijk->ik", weights, self.points[surface.triangles[faces]])

    def copy(self):
        """Returns a shallow copy of the input, to which arrays can be added."""
        data = vtkPolyData()
        data.ShallowCopy(self.data)
        return data

    def path_of(self, kind):
        """Returns the path of the graph of a construction or scheme."""
        return os.path.join(self.graphs, f"{self.name.replace('/', '-')}-{kind}.vtp")

    def graph(self, kind=None):
        """Returns the surface or cloud with its graph, from the file."""
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(self.path_of(kind or ("C" if self.is_cloud else "Guaranteed")))
        return vtkdgg.check(reader)

    def write_graph(self, kind):
        """Writes the file of graph() unless it exists."""
        if not os.path.exists(self.path_of(kind)):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                builder = cloud_graph(kind)(self) if self.is_cloud else mesh_graph(kind)(self)
                output = vtkdgg.check(builder)
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(output)
            writer.SetFileName(self.path_of(kind))
            vtkdgg.check(writer)

    def dots(self, count=3, **arrays):
        """Returns some positions as input, with arrays."""
        dots = support.polydata(self.places[:count])
        for name, values in arrays.items():
            add_array(dots.GetPointData(), name, values)
        return dots


def own_methods(algorithm):
    """Returns the names of the methods that VTK's own algorithms do not have."""
    return sorted(set(dir(algorithm)) - set(dir(vtkPolyDataAlgorithm)) - set(dir(vtkWriter)))


# --- Surfaces ------------------------------------------------------------------------------------

CASES = {}  # name: (function, most points)


def case(name, most=10**9):
    """Decorator of a case, for scenes with at most `most` points."""

    def add(function):
        CASES[name] = (function, most)
        return function

    return add


def add_cases(kind, data, variants, most=10**9, **common):
    """Adds cases of one filter. `data` is a function of the scene that returns the input; values
    may be functions of the scene."""
    for name, properties in variants.items():

        def build(scene, given=dict(common, **properties)):
            values = {k: v(scene) if callable(v) else v for k, v in given.items()}
            return make(kind, data(scene), **values)

        case(name, most)(build)


def mesh_of(scene):
    return scene.data


def inner(count):
    return lambda scene: scene.inner[:count]


def mesh_graph(kind):
    properties = {"Accuracy": ACCURACY, "Construction": CONSTRUCTIONS.index(kind)}
    return lambda scene: make("vtkDiscreteGeodesicGraph", scene.data, **properties)


def with_initial(scene):
    return scene.dots(InitialDistance=np.linspace(0.0, 0.01, 3) * scene.size)


EVERYTHING = {"GenerateNearestSource": True, "GenerateVirtualSource": True}
ANYWHERE = {"SourceData": with_initial, "MaximumDistance": lambda s: 0.3 * s.size}
add_cases(
    "vtkExactGeodesicDistance",
    mesh_of,
    {
        "exact": {"SourceIds": inner(1), "GenerateWindows": True},
        "exact-sources": {"SourceIds": lambda s: s.sources, **EVERYTHING},
        "exact-points": {**ANYWHERE, **EVERYTHING, "UnreachedValue": -1.0},
    },
)
add_cases(
    "vtkExactGeodesicDistance",
    mesh_of,
    {"exact-reference": {"Engine": 0}, "exact-merged": {"MergeCoincidentPoints": True}},
    SMALL,
    SourceIds=inner(1),
)
add_cases(
    "vtkHeatGeodesicDistance",
    mesh_of,
    {
        "heat": {"SourceIds": inner(2)},
        "heat-dirichlet": {"SourceIds": inner(2), "Boundary": 1},
        "heat-average": {"SourceIds": inner(2), "Boundary": 2, "TimeStepFactor": 4.0},
        "heat-not-delaunay": {**ANYWHERE, "IntrinsicDelaunay": False},
    },
    10_000,
)
add_cases(
    "vtkDGGFastMarchingDistance",
    mesh_of,
    {
        "marching": {"SourceIds": inner(2), "GenerateNearestSource": True},
        "marching-planar": {**ANYWHERE, "FrontShape": 1},
    },
)
add_cases(
    "vtkVirtualSourceGeodesicDistance",
    mesh_of,
    {
        "propagation": {"SourceIds": inner(2), "GenerateNearestSource": True, "Quality": 1},
        "propagation-high": {**ANYWHERE, "Quality": 2},
    },
)
for construction in CONSTRUCTIONS:
    limit = {"Guaranteed": 10**9, "Indirect": 1500}.get(construction, MIDDLE)
    case(f"graph-{construction}", limit)(mesh_graph(construction))
add_cases(
    "vtkDiscreteGeodesicGraph",
    mesh_of,
    {
        "graph-lines": {"Accuracy": 0.1, "GenerateGraphLines": True},
        "graph-accurate": {"Accuracy": 5e-6},
    },
    400,
)
add_cases(
    "vtkDGGDistance",
    Scene.graph,
    {
        "distance": {"SourceIds": inner(1), **EVERYTHING, "GenerateUpperBound": True},
        "distance-raw": {"SourceIds": lambda s: s.sources, "Correction": False},
        "distance-points": {**ANYWHERE, **EVERYTHING},
        "distance-corrected-labels": {"SourceIds": inner(2), "Search": 1},
        "distance-dijkstra": {"SourceIds": inner(2), "Search": 2, "Correction": False},
    },
)
add_cases("vtkDGGDistance", mesh_of, {"distance-alone": {"SourceIds": inner(1)}}, SMALL)
for construction in CONSTRUCTIONS[1:]:
    add_cases(
        "vtkDGGDistance",
        lambda scene, kind=construction: scene.graph(kind),
        {f"distance-{construction}": {"SourceIds": inner(1)}},
        1500 if construction == "Indirect" else MIDDLE,
    )
add_cases(
    "vtkGeodesicDistanceMatrix",
    Scene.graph,
    {
        "matrix": {"RowIds": lambda s: s.sources},
        "matrix-points": {"RowIds": inner(4), "RowData": Scene.dots, "ColumnData": Scene.dots},
    },
)


def path(data, **properties):
    def build(scene):
        pairs = scene.inner + scene.sources
        algorithm = make("vtkDGGPath", data(scene), **properties)
        for start, end in zip(pairs, pairs[1:]):
            algorithm.AddPair(start, end)
        algorithm.SetPairData(support.polyline(scene.places[:3]))
        return algorithm

    return build


case("path")(path(Scene.graph))
case("path-rough")(path(Scene.graph, Straighten=False))
case("path-detour")(path(Scene.graph, Detour=0.02))
case("path-exact")(path(mesh_of, Method=1))
case("path-alone", SMALL)(path(mesh_of, Accuracy=0.1))
add_cases(
    "vtkDGGLoop",
    Scene.graph,
    {
        "loop-taut": {"PointIds": inner(2), "PointData": Scene.dots, "Taut": True},
        "loop-rope": {"PointIds": inner(4), "Mode": 2},
        "loop-rope-taut": {"PointIds": inner(4), "Mode": 2, "Taut": True},
    },
    MIDDLE,
)
TAPE = {"TapeWidth": lambda s: 0.01 * s.size}
add_cases("vtkDGGLoop", Scene.graph, {"loop": {"PointIds": inner(2), **TAPE}}, 1500)
add_cases("vtkDGGLoop", Scene.graph, {"loop-handles": {"Mode": 1, **TAPE}}, 330)


def isolines(distance, **properties):
    """Returns a case of isolines of the result of another case."""

    def build(scene):
        field = CASES[distance][0](scene)
        algorithm = make("vtkApolloniusIsolines", field, **properties)
        for i, level in enumerate(np.linspace(0.03, 0.6, 6)):
            algorithm.SetValue(i, level * scene.size)
        return algorithm

    return build


OUTPUTS = {"GenerateRidges": True, "GenerateBands": True}
case("isolines")(isolines("exact", **OUTPUTS))
case("isolines-sources", MIDDLE)(isolines("exact-sources", **OUTPUTS))
case("isolines-graph", MIDDLE)(isolines("distance", **OUTPUTS))
case("isolines-fit", MIDDLE)(isolines("marching", GenerateBands=True))
case("isolines-linear", MIDDLE)(isolines("exact", Method=2))
case("isolines-apollonius", MIDDLE)(isolines("exact", Method=1, SteinerPoints=2))
for field in ("exact", "distance", "marching"):
    add_cases(
        "vtkGeodesicProbe",
        CASES[field][0],
        {f"probe-{field}": {"ProbeData": lambda s: s.dots(5)}},
    )
add_cases(
    "vtkGeodesicVoronoi",
    Scene.graph,
    {
        "voronoi": {"SiteIds": lambda s: s.sources},
        "voronoi-points": {"SiteData": lambda s: s.dots(5), "RefineBoundaries": True},
        "voronoi-centroidal": {"SiteIds": inner(4), "Centroidal": True, "NumberOfIterations": 3},
        "voronoi-labels": {"SiteIds": inner(3), "GenerateCells": False, "UnreachedValue": -1.0},
    },
    10_000,
)
add_cases(
    "vtkGeodesicSampler",
    Scene.graph,
    {
        "sampler": {"NumberOfSamples": 20},
        "sampler-faces": {"NumberOfSamples": 10, "InFaces": True, "FirstSample": 3},
        "sampler-radius": {"NumberOfSamples": 40, "CoveringRadius": lambda s: 0.2 * s.size},
        "sampler-start": {"NumberOfSamples": 10, "StartData": Scene.dots},
    },
)


@case("patches", 10_000)
def patches(scene):
    other = support.polydata(scene.points[:, [1, 2, 0]], scene.triangles)
    layout = support.polyline(scene.points[scene.inner[:3]])
    return make(
        "vtkGeodesicPatchBoundaries",
        scene.data,
        SecondSurfaceData=other,
        FirstLandmarkIds=scene.inner[:3],
        SecondLandmarkIds=scene.inner[:3],
        LayoutData=layout,
    )


add_cases(
    "vtkDiscreteGreensFunction",
    mesh_of,
    {
        "greens": {"EvaluationData": Scene.dots},
        "greens-localized": {"Method": 1, "SignConvention": 1},
        "greens-interpolated": {"Method": 2, "Weighting": 1},
        "greens-vertex": {"Method": 3, "IntrinsicDelaunay": False},
    },
    10_000,
    SourceIds=inner(2),
)
add_cases(
    "vtkDiscreteGreensFunction",
    mesh_of,
    {
        "greens-points": {"SourceData": Scene.dots, "PoleValue": 1},
        "greens-dirichlet": {"SourceIds": inner(1), "Boundary": 1},
        "greens-regular": {"SourceIds": inner(1), "InterpolateRegularPart": True},
    },
    SMALL,
)
add_cases(
    "vtkBiharmonicDistance",
    mesh_of,
    {
        "biharmonic": {},
        "commute": {"Kind": 1, "EvaluationData": Scene.dots},
        "diffusion": {"Kind": 2},
    },
    MIDDLE,
    SourceIds=inner(2),
    NumberOfEigenvalues=20,
)
add_cases(
    "vtkBiharmonicDistance",
    mesh_of,
    {"biharmonic-exact": {}, "commute-exact": {"Kind": 1}},
    SMALL,
    SourceIds=inner(2),
    Method=1,
)


def with_heights(scene):
    data = scene.copy()
    for name, axis in (("One", 0), ("Two", 1)):
        values = scene.points[:, axis] - scene.points[:, axis].min()
        add_array(data.GetPointData(), name, values)
    return data


SOLUTION = {"RightHandSideArrayName": "One", "EvaluationData": Scene.dots}
add_cases(
    "vtkHarmonicBSpline",
    with_heights,
    {
        "spline": {"NumberOfSites": 10},
        "spline-solution": {"NumberOfSites": 20, **SOLUTION},
        "spline-smooth": {
            "SourceIds": inner(4),
            **SOLUTION,
            "RightHandSideMeaning": 1,
            "SmoothEvaluation": True,
        },
    },
    10_000,
)
add_cases(
    "vtkSurfaceEarthMoversDistance",
    with_heights,
    {
        "movers": {"FromArrayName": "One", "ToArrayName": "Two"},
        "movers-mass": {"FromArrayName": "One", "ToArrayName": "Two", "ArrayMeaning": 1},
        "movers-points": {
            "FromData": lambda s: s.dots(2, mass=[1.0, 3.0]),
            "ToData": lambda s: support.polydata(s.places[2:4]),
        },
    },
    SMALL,
    MaximumNumberOfIterations=200,
)


def graphics(closed, cells, **properties):
    """Returns a case of a drawing of one curve with arrays on its line."""

    def build(scene):
        ids = scene.inner[:3] + scene.inner[:1] * closed
        curve = support.polydata(scene.points[ids], Lines=[[0, 1, 2] + [0] * closed])
        for name, values in cells.items():
            add_array(curve.GetCellData(), name, np.array([values]))
        return make("vtkPoissonVectorGraphics", scene.data, CurveData=curve, **properties)

    return build


COLORS = {"LeftColor": [1.0, 0.0, 0.2], "RightColor": [0.0, 0.5, 1.0]}
case("graphics", MIDDLE)(graphics(False, COLORS))
case("graphics-near", SMALL)(graphics(False, COLORS, RefinementLevel=1, RefinementRegion=1))
case("graphics-fragments", SMALL)(
    graphics(False, COLORS, GenerateFragments=True, FragmentDivision=2)
)
for number in (1, 2, 3):  # Poisson curves, regions, sources
    line = {"CurveType": number, "Strength": 0.5}
    case(f"graphics-type-{number}", SMALL)(graphics(number == 2, line))


@case("python", SMALL)
def functions(scene):
    """Returns results of the functions of the package and of the class Graph."""
    points, triangles, (a, b) = scene.points, scene.triangles, scene.inner[:2]
    graph = vtkdgg.Graph.from_polydata(scene.graph())
    again = pickle.loads(pickle.dumps(graph))
    ways = [vtkdgg.path(points, triangles, a, b), again.path(a, b), graph.path(b, scene.places[0])]
    found = {
        "distance": vtkdgg.distance(points, triangles, scene.places),
        "distance-graph": vtkdgg.distance(points, triangles, a, accuracy=0.1),
        "Graph.distance": graph.distance(a),
        "Graph.matrix": graph.matrix(scene.inner, scene.places),
        "again": again.distance([a, b], correction=False),
        "lengths": graph.lengths,
    }
    for i, way in enumerate(ways):
        found.update({f"path {i} {name}": np.asarray(getattr(way, name)) for name in PATH})
    return found


PATH = ["points", "faces", "point_ids", "length"]


@case("off", SMALL)
def off(scene):
    """Returns the OFF reader with a file of the mesh."""
    name = os.path.join(scene.folder, "mesh.off")
    with open(name, "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(scene.points)} {len(scene.triangles)} 0\n")
        np.savetxt(file, scene.points, "%.17g")
        np.savetxt(file, np.insert(scene.triangles, 0, 3, axis=1), "%d")
    reader = vtkdgg.vtkDGGOFFReader()
    reader.SetFileName(name)
    return reader


# --- Clouds --------------------------------------------------------------------------------------

CLOUD_CASES = {}


def cloud_graph(scheme, **properties):
    return lambda s: make("vtkPointCloudDGG", s.data, Scheme=SCHEMES.index(scheme), **properties)


def with_normals(scene):
    """Returns a graph of the cloud with directions from its center as normals, which are exact for
    a sphere."""
    data = scene.copy()
    rays = scene.points - scene.points.mean(axis=0)
    add_array(data.GetPointData(), "Normals", rays / np.linalg.norm(rays, axis=1)[:, None])
    data.GetPointData().SetActiveNormals("Normals")
    return make("vtkPointCloudDGG", data, OrientedNormals=True)


def pcd_writer(mode):
    def build(scene):
        name = os.path.join(scene.folder, "cloud.pcd")
        return make("vtkPCDWriter", scene.data, FileName=name, DataMode=mode)

    return build


def pcd(mode):
    """Returns a case of the reader of the file of a writer."""

    def build(scene):
        writer = pcd_writer(mode)(scene)
        writer.Write()
        reader = vtkdgg.vtkPCDReader()
        reader.SetFileName(writer.GetFileName())
        return reader

    return build


if "vtkPointCloudDGG" in vtkdgg.build_info.CLASSES:
    for scheme in SCHEMES:
        CLOUD_CASES[f"cloud-{scheme}"] = (cloud_graph(scheme), 10**9 if scheme == "C" else 6000)
    CLOUD_CASES["cloud-normals"] = (cloud_graph("C", EstimateNormals=True), LARGE)
    CLOUD_CASES["cloud-given-normals"] = (with_normals, 1000)
    CLOUD_CASES["cloud-chords"] = (cloud_graph("C", ArcLengthWeights=False, Alpha=3.0), 6000)
    CLOUD_CASES["cloud-coarse"] = (cloud_graph("C", Accuracy=0.05, Resolution=40), 6000)
    for name in CASES:
        if name.split("-")[0] in ("distance", "matrix", "path", "voronoi", "sampler"):
            if not name.endswith(("-exact", "-alone", *CONSTRUCTIONS)):
                CLOUD_CASES[name] = CASES[name]
CLOUD_CASES["marching"] = CASES["marching"]
CLOUD_CASES["marching-in-band"] = (
    lambda s: make(
        "vtkDGGFastMarchingDistance", s.data, SourceIds=s.inner[:1], BandRadius=2.5, Resolution=60
    ),
    10**9,
)
for mode in range(3):
    CLOUD_CASES[f"pcd-{mode}"] = (pcd(mode), LARGE)
    CLOUD_CASES[f"pcd-writer-{mode}"] = (pcd_writer(mode), LARGE)


def cases_of(scene):
    """Returns the functions of the cases for a scene, by name."""
    number = len(scene.points)
    cases = CLOUD_CASES if scene.is_cloud else CASES
    return {name: function for name, (function, most) in cases.items() if number <= most}


def graphs_of(scene):
    """Returns the kinds of graphs that the cases of a scene read from files."""
    if scene.is_cloud:
        return ["C"] if "cloud-C" in CLOUD_CASES else []
    wanted = cases_of(scene)
    return ["Guaranteed"] + [kind for kind in CONSTRUCTIONS[1:] if f"distance-{kind}" in wanted]


def bumpy_cloud():
    """Returns points of a sphere with waves."""
    i = np.arange(800)
    z = 1.0 - (2.0 * i + 1.0) / 800
    angle = np.pi * (3.0 - np.sqrt(5.0)) * i
    flat = np.sqrt(1.0 - z * z)[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    points = np.column_stack([flat, z]) * (1.0 + 0.1 * np.sin(5.0 * z))[:, None]
    return support.polydata(points)


def thinned(cloud):
    """Returns every third point."""
    points = vtk_to_numpy(cloud.GetPoints().GetData())
    return support.polydata(points[::3])


def scenes(data_folder, folder, graphs, only=""):
    """Yields all scenes."""
    for name in FILES if data_folder else []:
        if only in name:
            reader = vtkPLYReader()
            reader.SetFileName(os.path.join(data_folder, f"{name}.ply"))
            data = vtkdgg.check(reader)
            if data.GetNumberOfPolys() == 0 and data.GetNumberOfPoints() > LARGE:
                data = thinned(data)
            yield Scene(name, data, folder, graphs)
    generated = {
        "terrain": terrain(),
        "prism": support.polydata(*support.prism(7, 8)),
        "bumpy-cloud": bumpy_cloud(),
        "bumpy": support.polydata(*support.bumpy()),
    }
    if not data_folder:
        for mesh in map(sweep_meshes.generate, SEEDS):
            generated[mesh.name] = support.polydata(mesh.points, mesh.triangles)
    for name, data in generated.items():
        if only in name:
            yield Scene(name, data, folder, graphs)


def terrain():
    points, triangles = support.grid(8, 7)
    points[:, 2] = np.sin(points[:, 0]) * np.cos(2.0 * points[:, 1])
    return support.polydata(points, triangles)
