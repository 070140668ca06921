# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Graphs of point clouds: errors of all schemes and of fast marching; difficult clouds; parameters; cost.

Usage: measure_clouds.py OUT.json OUT.md [--name=value ...] [MESH ...]

  --clouds=square:40000,cylinder:40000,sphere:10000,sphere:40000,torus:57000
                     random points: shape and number
  --large=           the same, of which only scheme C is measured
  --schemes=A,B,C
  --accuracy=0.001   of the graphs
  --fine_accuracy=0.0001  scheme C with arcs is measured with this accuracy as well
  --sources=5        of queries and marches
  --curves=5000      points of a sphere and a torus on which alpha and the radius of balls vary; 0: none
  --guards=20000     points of difficult clouds; 0: none
  --speed=200000     points of clouds whose graphs are timed; 0: none
  --speed_mesh=FILE  a mesh that is decimated to this number of points
  --terrain=FILE     a terrain on a grid, of which 257 by 257 vertices are measured
  --threads=2        of graphs; queries and marches use one

The vertices of each MESH are a cloud as well. True distances are exact distances along its faces,
without faces that have an edge longer than three median edges. Published values are the mean errors of
Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University, 2019, chapter 5, at a
resolution of 512 voxels, for models of the same kind and size.
"""

import time

import modes
import numpy as np
import vtkdgg
from exhibits import surfaces
from exhibits.fields import summary
from tables import (
    DASH,
    DEGREE,
    ERRORS,
    bytes_text,
    column,
    count_text,
    errors_text,
    figure,
    folded,
    gain_text,
    in_form,
    listing,
    percent,
    range_text,
    ratio,
    significant,
    time_text,
    titled,
)
from vtkdgg.commands.sizes import edge_lengths, floor_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools

CYLINDER_HEIGHT = 3.0
HOLES = 12
HOLE_RADIUS = 0.3
LONGEST_EDGE = 3.0  # in median edges; longer edges belong to faces over gaps between points
TERRAIN_LINES = 257
SHEETS_OFFSET = 3  # radius of the balls in voxels; the distance of the layers is three radii
TORUS = "torus-640"  # points are drawn from its vertices
TORUS_SMALL_RADIUS = 0.4
# Published values for models of the same kind: beginning of the name of a cloud, number of points,
# and the least and largest mean error of graphs.
PUBLISHED = (
    ("sphere", 655000, (7e-5, 7e-5)),
    ("torus", 57000, (1.2e-3, 1.7e-3)),
    ("terrain", 66000, (3.1e-3, 3.8e-3)),
    ("bunny", 30000, (1.7e-3, 2.3e-3)),
)
PUBLISHED_MARCHING = (1.8e-2, 3.7e-2)
SAME_SIZE = 1.25  # ratio of numbers of points of models of the same size
MOST_UNREACHED = 0.01  # fraction of points above which there is no mean error
ALPHAS = {
    "A": (0.5, 0.7, 1.0, 1.4, 2.0, 3.0),
    "B": (1.0, 2.0, 3.0, 5.0, 7.0, 9.0, 12.0, 16.0, 21.0),
    "C": (2.5, 3.5, 5.0, 6.5, 8.5, 10.5, 13.0, 16.0),
}
OFFSETS = (1.5, 2.0, 3.0, 4.0, 6.0, 8.0)


class Cloud:
    """Points, and the distances along the surface that they sample. `distances` maps a point id to
    the distances of all points, at most `floor` of which consist of rounding errors. `parts` is the
    part of the surface per point."""

    def __init__(self, points, distances, floor=1e-6, parts=None):
        self.points = points
        self.data = vtkdgg.Mesh(points).as_polydata()
        self.floor = floor
        self.parts = parts
        self._distances = distances
        self._known = {}

    def sources(self, count):
        """Returns ids spread evenly over the list of points."""
        size = len(self.points)
        return [size * (2 * k + 1) // (2 * count) for k in range(count)]

    def exact(self, source):
        if source not in self._known:
            self._known[source] = self._distances(source)
        return self._known[source]

    def errors(self, graph, count):
        """Returns the errors of what answers `distance(source, unreached)`, and the median time."""
        times, fields = [], []
        sources = self.sources(count)
        graph.distance(sources[0])  # prepares the search
        for source in sources:
            seconds, field = modes.timed(lambda s=source: graph.distance(s, unreached=np.inf))
            times.append(seconds)
            fields.append(field)
        exact = [self.exact(source) for source in sources]
        beyond = max(int((np.isfinite(f) & ~np.isfinite(e)).sum()) for f, e in zip(fields, exact))
        errors = summary(fields, exact, self.floor)
        return {"error": {**errors, "beyond": beyond}, "query": float(np.median(times))}


def square(count):
    return sheets(count, 0.0)


def sheets(count, gap):
    """Two unit squares, one above the other."""
    points = np.random.default_rng(surfaces.SEED).random((count, 3))
    parts = np.arange(count) * 2 >= count
    points[:, 2] = np.where(parts, gap, 0.0)

    def distances(source):
        away = np.linalg.norm(points - points[source], axis=1)
        return np.where(points[:, 2] == points[source, 2], away, np.inf)

    return Cloud(points, distances, parts=parts)


def cylinder(count):
    """A cylinder of radius 1."""
    angles, heights = np.random.default_rng(surfaces.SEED).random((2, count))
    angles, heights = 2.0 * np.pi * angles, CYLINDER_HEIGHT * heights

    def distances(source):
        turn = np.abs(angles - angles[source])
        return np.hypot(np.minimum(turn, 2.0 * np.pi - turn), heights - heights[source])

    return Cloud(np.stack([np.cos(angles), np.sin(angles), heights], axis=1), distances)


def sphere(count, noise=0.0, density=1.0, seed=surfaces.SEED):
    """A sphere of radius 1, denser at its top by a factor. Noise moves each coordinate by a normal
    random number; distances are those between the nearest points of the sphere."""
    random = np.random.default_rng(seed)
    places = np.empty((0, 3))
    while len(places) < count:
        drawn = random.standard_normal((count, 3))
        drawn /= np.linalg.norm(drawn, axis=1)[:, None]
        kept = density * random.random(count) <= 1.0 + (density - 1.0) * 0.5 * (drawn[:, 2] + 1.0)
        places = np.concatenate([places, drawn[kept]])
    points = places[:count] + noise * random.standard_normal((count, 3))
    places = points / np.linalg.norm(points, axis=1)[:, None]

    def distances(source):
        found = np.arccos(np.clip(places @ places[source], -1.0, 1.0))
        found[source] = 0.0
        return found

    return Cloud(points, distances)


def vertices(mesh):
    """The vertices of a mesh, with exact distances along its faces."""
    points, _ = surfaces.arrays_of(mesh)
    return Cloud(points, lambda source: vtkdgg.distance(mesh, source), floor_of(mesh))


class Drawn:
    """Random vertices of a fine mesh, evenly in area. The first ones are always the same, so that
    exact distances from them are computed once."""

    fixed = 16

    def __init__(self, mesh):
        self.points, triangles = surfaces.arrays_of(mesh)
        corners = self.points[triangles]
        areas = np.linalg.norm(
            np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
        )
        self.weights = np.bincount(triangles.ravel(), np.repeat(areas, 3), len(self.points))
        self.whole = vertices(mesh)
        self.first = self.draw(np.random.default_rng(surfaces.SEED), self.fixed, self.weights)

    @staticmethod
    def draw(random, count, weights):
        return random.choice(len(weights), count, replace=False, p=weights / weights.sum())

    def cloud(self, count, seed=surfaces.SEED + 1):
        """Returns a cloud of this number of vertices."""
        rest = self.weights.copy()
        rest[self.first] = 0.0
        others = self.draw(np.random.default_rng(seed), count - self.fixed, rest)
        chosen = np.concatenate([self.first, others])
        made = Cloud(self.points[chosen], lambda s: self.whole.exact(chosen[s])[chosen])
        made.sources = lambda number: list(range(number))
        return made


_drawn = {}


def torus(count, seed=surfaces.SEED + 1):
    """A torus of radii 1 and 0.4."""
    if TORUS not in _drawn:
        _drawn[TORUS] = Drawn(surfaces.make(TORUS))
    return _drawn[TORUS].cloud(count, seed)


def with_holes(count):
    """A sphere with waves and holes."""
    points, triangles = surfaces.arrays_of(surfaces.make("bumpy-7"))
    away = np.linalg.norm(points[:, None] - points[None, :HOLES], axis=2).min(axis=1)
    kept = (away[triangles] >= HOLE_RADIUS).all(axis=1)
    return Drawn(surfaces.from_arrays(points, triangles[kept])).cloud(count)


SHAPES = {"square": square, "cylinder": cylinder, "sphere": sphere, "torus": torus}


def scan(name):
    """Returns the title and the cloud of the vertices of a mesh, without faces over gaps."""
    title, mesh = modes.open_mesh(name)
    points, triangles = surfaces.arrays_of(mesh)
    lengths = edge_lengths(mesh).reshape(-1, 3)
    kept = triangles[lengths.max(axis=1) <= LONGEST_EDGE * np.median(lengths)]
    return title, vertices(surfaces.from_arrays(points, kept))


def terrain(name):
    """Returns the title and the cloud of the corner of a terrain on a grid."""
    title, mesh = modes.open_mesh(name)
    points, triangles = surfaces.arrays_of(mesh)
    inside = np.ones(len(points), bool)
    for axis in (0, 1):
        inside &= points[:, axis] <= np.unique(points[:, axis])[:TERRAIN_LINES][-1]
    ids = np.cumsum(inside) - 1
    corner = ids[triangles[inside[triangles].all(axis=1)]]
    return f"{title}-66K", vertices(surfaces.from_arrays(points[inside], corner))


class Through:
    """A distance filter with the queries of a graph."""

    def __init__(self, make, data):
        self.filter = make()
        self.filter.SetInputData(data)

    def distance(self, source, unreached=np.nan):
        self.filter.SetSourceIds([source])
        self.filter.SetUnreachedValue(unreached)
        found = vtkdgg.check(self.filter).GetPointData().GetArray("GeodesicDistance")
        return vtk_to_numpy(found).copy()


def marching(data):
    """Fast marching in a band of voxels."""
    return Through(vtkdgg.vtkDGGFastMarchingDistance, data)


def builder_of(data, **options):
    """Returns the filter of a graph, with these properties."""
    graph = vtkdgg.vtkPointCloudDGG()
    graph.SetInputData(data)
    graph.SetScheme(getattr(graph, options.pop("Scheme", "C")))
    for name, value in options.items():
        getattr(graph, "Set" + name)(value)
    return graph


def built(data, **options):
    """Returns a graph, and the seconds on the wall of its construction."""
    graph = builder_of(data, **options)
    seconds, output = modes.timed(lambda: vtkdgg.check(graph), time.perf_counter)
    return vtkdgg.CloudGraph.from_polydata(output), seconds


def measure_graph(cloud, sources, threads=1, **options):
    """Returns all figures of one graph."""
    builder = builder_of(cloud.data, **options)
    vtkSMPTools.Initialize(threads)
    peak = modes.ResidentPeak()
    start = time.process_time()
    wall, output = modes.timed(lambda: vtkdgg.check(builder), time.perf_counter)
    cpu, measured_peak = time.process_time() - start, peak.growth()
    vtkSMPTools.Initialize(1)
    graph = vtkdgg.CloudGraph.from_polydata(output)
    found = {
        "points": len(cloud.points),
        "wall": wall,
        "cpu": cpu,
        "threads": threads,
        "peak": measured_peak,
        "degree": builder.GetMeanDegree(),
        "bytes": builder.GetMemorySize(),
        "spacing": builder.GetSpacing(),
        "reach": builder.GetReach(),
        "noise": builder.GetNoise(),
        "components": builder.GetNumberOfComponents(),
        **cloud.errors(graph, sources),
    }
    if cloud.parts is not None:
        origins = np.repeat(cloud.parts, np.diff(graph.offsets))
        found["false edges"] = int((origins != cloud.parts[graph.targets]).sum())
    return found


def measure_schemes(cloud, options, schemes):
    """Returns the figures of all graphs of a cloud and of fast marching, by method."""
    found = {}
    for scheme in schemes:
        for weights in ("chords", "arcs"):
            found[f"{scheme}, {weights}"] = measure_graph(
                cloud,
                options.sources,
                options.threads,
                Scheme=scheme,
                ArcLengthWeights=weights == "arcs",
                Accuracy=options.accuracy,
            )
    if options.fine_accuracy > 0.0:
        found["C, arcs, finer"] = measure_graph(
            cloud, options.sources, options.threads, Accuracy=options.fine_accuracy
        )
    march = cloud.errors(marching(cloud.data), options.sources)
    found["fast marching"] = {"points": len(cloud.points), **march}
    return found


def shaped(text):
    """Returns the title and the cloud of SHAPE:NUMBER."""
    shape, _, number = text.partition(":")
    if shape not in SHAPES or not number.isdigit() or int(number) < 10:
        raise SystemExit(
            f"error: {text!r} is no cloud. Expected one of {', '.join(SHAPES)}, a colon and a number "
            "of points, at least 10."
        )
    return f"{shape}-{count_text(int(number))}", SHAPES[shape](int(number))


def measure_guards(options):
    """Returns the figures of difficult clouds: {title: {scheme: figures}}."""
    count = options.guards
    voxels = round(2.0 * (0.5 * count) ** 0.5)
    clouds = {
        # Fractions of the bounding box, which has sides of length 2.
        "noise, 0.5 % of the box": (sphere(count, noise=0.01), {}),
        "noise, 1 % of the box": (sphere(count, noise=0.02), {}),
        "density 10 : 1": (sphere(count, density=10.0), {}),
        "holes": (with_holes(count), {}),
        "two layers, 3 h apart": (
            sheets(count, 3.0 * SHEETS_OFFSET / voxels),
            {"OffsetInVoxels": SHEETS_OFFSET, "Resolution": voxels},
        ),
    }
    return {
        title: {
            scheme: measure_graph(
                cloud,
                options.sources,
                options.threads,
                Scheme=scheme,
                Accuracy=options.accuracy,
                **properties,
            )
            for scheme in options.schemes
        }
        for title, (cloud, properties) in clouds.items()
    }


def measure_curve(cloud, scheme, property_name, values, **options):
    """Returns (value of the property, mean error in percent) where nearly all points are reached."""
    curve = []
    for value in values:
        graph, _ = built(cloud.data, Scheme=scheme, **options, **{property_name: value})
        error = cloud.errors(graph, 3)["error"]
        # Zero does not exist on a logarithmic axis.
        if error["mean"] > 0.0 and error["missed"] <= MOST_UNREACHED * len(cloud.points):
            curve.append((value, 100.0 * error["mean"]))
    return curve


def measure_curves(count, schemes=tuple(ALPHAS)):
    """Returns errors over alpha and the radius of balls: {cloud: {method: {parameter: curve}}}."""
    resolution = round(128.0 * (1e-4 * count) ** 0.5)
    found = {}
    for title, cloud in (("sphere", sphere(count)), ("torus", torus(count))):
        graphs = found[f"{title}, {count_text(count)} points"] = {}
        for scheme in schemes:
            for weights in ("chords", "arcs"):
                arcs = {"ArcLengthWeights": weights == "arcs"}
                graphs[f"{scheme}, {weights}"] = {
                    "Alpha": measure_curve(cloud, scheme, "Alpha", ALPHAS[scheme], **arcs),
                    "Offset": measure_curve(
                        cloud, scheme, "OffsetInVoxels", OFFSETS, Resolution=resolution, **arcs
                    ),
                }
    return found


def measure_speed(options):
    """Returns the cost of large clouds, and of meshes with the same points."""
    count = options.speed
    meshes = {f"torus-{count_text(count)}": surfaces.make(f"torus-{round((2.0 * count) ** 0.5)}")}
    if options.speed_mesh:
        title, mesh = modes.open_mesh(options.speed_mesh)
        meshes[f"{title}-{count_text(count)}"] = modes.decimated(mesh, count)
    clouds = {f"sphere-{count_text(count)}": sphere(count)}
    clouds.update({title: vertices(mesh) for title, mesh in meshes.items()})
    rows = []
    for title, cloud in clouds.items():
        builder = builder_of(cloud.data, Accuracy=options.accuracy)
        builder.EstimateMemory()
        row = {"cloud": title, "predicted": builder.GetEstimatedPeakMemory()}
        row.update(measure_graph(cloud, 3, options.threads, Accuracy=options.accuracy))
        if title in meshes:
            seconds, graph = modes.timed(lambda mesh=meshes[title]: vtkdgg.Graph(mesh))
            row["mesh"] = {"build": seconds, **cloud.errors(graph, 3)}
        rows.append(row)
    return rows


def measure(options):
    """Returns the figures of all clouds."""
    clouds = [lambda text=text: shaped(text) for text in options.clouds]
    clouds += [lambda name=name: scan(name) for name in options.meshes]
    if options.terrain:
        clouds.append(lambda: terrain(options.terrain))
    found = {"clouds": {}, "guards": {}, "curves": {}, "speed": []}
    for make in clouds:
        title, cloud = make()
        found["clouds"][title] = measure_schemes(cloud, options, options.schemes)
    for text in options.large:
        title, cloud = shaped(text)
        found["clouds"][title] = measure_schemes(cloud, options, "C")
    if options.guards:
        found["guards"] = measure_guards(options)
    if options.curves:
        found["curves"] = measure_curves(options.curves, options.schemes)
    if options.speed:
        found["speed"] = measure_speed(options)
    return found


def published_of(cloud, method, points):
    """Returns the least and the largest published mean error, None without a model of this kind and
    size."""
    for name, size, errors in PUBLISHED:
        if cloud.startswith(name) and 1 / SAME_SIZE < points / size < SAME_SIZE:
            return PUBLISHED_MARCHING if method == "fast marching" else errors
    return None


def published_text(values):
    return DASH if values is None else range_text(values, percent)


def better_text(known, error):
    """Returns the published error divided by ours."""
    return gain_text(known[0] / error["mean"]) if known else DASH


def unreached_text(error):
    """Returns the number of unreached points, and of points reached without a path on the surface."""
    wrong = f", {error['beyond']} wrongly reached" if error["beyond"] else ""
    return f"{error['missed']}{wrong}"


def rows_of_clouds(results):
    """Returns a row per cloud: its title, size, published errors, and the figures by method."""
    rows = []
    for cloud, graphs in results["clouds"].items():
        points = graphs["fast marching"]["points"]
        rows.append({"cloud": cloud, "points": points, **graphs})
        rows[-1]["published"] = published_of(cloud, "C", points)
    return rows


def mean_table(results):
    def mean(row, method, is_compared=False):
        error = figure(row, method, "error")
        # A mean over a part of the points does not characterize the method.
        if error is None or error["missed"] > MOST_UNREACHED * row["points"]:
            return DASH
        known = row["published"] if is_compared else None
        return percent(error["mean"]) + (f" ({better_text(known, error)})" if known else "")

    def both(scheme):
        return lambda row: " / ".join(mean(row, f"{scheme}, {w}") for w in ("chords", "arcs"))

    columns = (
        column("cloud", str, "cloud"),
        column("points", count_text, "points"),
        column("published", published_text, "published"),
        ("A: chords / arcs", both("A")),
        ("B: chords / arcs", both("B")),
        ("C: chords", lambda row: mean(row, "C, chords")),
        ("C: arcs (default)", lambda row: mean(row, "C, arcs", True)),
        ("C: arcs, finer", lambda row: mean(row, "C, arcs, finer", True)),
        ("fast marching", lambda row: mean(row, "fast marching")),
    )
    return listing(columns, rows_of_clouds(results))


def error_table(results):
    rows = [
        {
            "cloud": row["cloud"],
            "method": method,
            "known": published_of(row["cloud"], method, row["points"]),
            **row[method],
        }
        for row in rows_of_clouds(results)
        for method in ("C, arcs", "fast marching")
        if method in row
    ]
    columns = (
        column("cloud", str, "cloud"),
        column("points", count_text, "points"),
        column("method", str, "method"),
        DEGREE,
        ratio("reach, spacings", ("reach",), ("spacing",), significant),
        ERRORS,
        column("unreached", unreached_text, "error"),
        column("published mean, %", published_text, "known"),
        ("published / ours", lambda row: better_text(row["known"], row["error"])),
        column("query", time_text, "query"),
    )
    return listing(columns, rows)


def guard_table(results):
    """Returns a table with a row per difficult cloud, and the graphs of all schemes side by side."""
    rows = [{"cloud": cloud, **graphs} for cloud, graphs in results["guards"].items()]
    schemes = [scheme for scheme in "ABC" if all(scheme in row for row in rows)]

    def errors(scheme):
        # Balls of a given radius show only that layers remain disconnected.
        return lambda row: DASH if "layers" in row["cloud"] else errors_text(row[scheme]["error"])

    def counts(title, form, *keys):
        return (
            f"{title}: {' / '.join(schemes)}",
            lambda row: " / ".join(form(figure(row[scheme], *keys)) for scheme in schemes),
        )

    columns = (
        column("cloud", str, "cloud"),
        column("noise found", "{:.2g}", schemes[-1] if schemes else "C", "noise"),
        *((f"{scheme}, arcs: mean / 99.9 % / max", errors(scheme)) for scheme in schemes),
        counts("unreached", unreached_text, "error"),
        counts("edges between layers", in_form(str), "false edges"),
        counts("components", str, "components"),
    )
    return listing(columns, rows)


def speed_table(results):
    columns = (
        column("cloud", str, "cloud"),
        column("points", count_text, "points"),
        column("graph (wall)", time_text, "wall"),
        column("CPU", time_text, "cpu"),
        column("threads", str, "threads"),
        DEGREE,
        column("graph size", bytes_text, "bytes"),
        column("peak: predicted", bytes_text, "predicted"),
        column("measured", bytes_text, "peak"),
        column("query", time_text, "query"),
        ERRORS,
        column("graph of the mesh (CPU)", time_text, "mesh", "build"),
        column("query on the mesh", time_text, "mesh", "query"),
        column("error on the mesh: mean / 99.9 % / max", errors_text, "mesh", "error"),
    )
    return listing(columns, results["speed"])


def tables(results):
    """Returns all tables."""
    return (
        "Graphs are built on several threads and their times are wall-clock times; all other times "
        "are CPU seconds on one thread. Predicted peaks count the bytes requested from the "
        "allocator; measured peaks are the growth of the process, which includes memory that the "
        "allocator retains.\n\n"
    ) + titled(
        {
            "Mean errors, % (in parentheses: published / ours)": mean_table(results),
            "Difficult clouds": guard_table(results),
            "Cost on large clouds, and on meshes with the same points": speed_table(results),
            "": folded("Errors of the default in detail", error_table(results)),
        }
    )


def parse(arguments=None):
    """Returns the options of a command line."""
    return modes.parse(
        __doc__,
        arguments,
        clouds=("square:40000", "cylinder:40000", "sphere:10000", "sphere:40000", "torus:57000"),
        large=(),
        schemes=("A", "B", "C"),
        accuracy=0.001,
        fine_accuracy=0.0001,
        sources=5,
        curves=5000,
        guards=20000,
        speed=200000,
        speed_mesh="",
        terrain="",
        threads=2,
    )


if __name__ == "__main__":
    modes.run(measure, tables, parse())
