# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors inside the faces of machine parts: probes, isolines, ridges and Voronoi borders of graph
distances, and distances from virtual sources.

Usage: measure_parts.py OUT.json OUT.md [--name=value ...] [PART or MESH ...]

  PART            name or pattern of generated parts (gear-*); default: all of them
  MESH            file
  --accuracies=   of the graphs; 0 for virtual sources only. Default: 0.1,0.01,0.001 for parts, and
                  0 for files
  --points=10000  random points of the surface
  --levels=20     isolines, evenly over the range of the exact distances
  --sites=10      sites of Voronoi cells, and sources of virtual sources, one at a time; alternately
                  vertices and points inside faces
  --fields=2      number of sites that are sources of isolines, ridges and probes, one at a time
  --before=FILE   OUT.json of an earlier run, for a histogram before and after

Reference are exact distances with windows at the same surface points. The excess of a distance is
the part of its error that exceeds the bound ε. A point of a Voronoi border has an excess if no
distances within the bound are equal for its two sites and at most those of all other sites.
"""

import fnmatch
import json

import modes
import numpy as np
import vtkdgg
from exhibits import parts, surfaces
from tables import column, count_text, digits, listing, named, percent, titled

kernel = vtkdgg._kernel  # pylint: disable=protected-access
DISTANCE = "GeodesicDistance"
CHORD = 1e-4  # tolerance of lines in mean edges
ROUNDING = 1e-6  # of distances, relative to the largest one
BINS = (ROUNDING, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1)  # of the excess, relative to the largest distance
QUALITIES = ("Fast", "High")
ACCURACIES = (0.1, 0.01, 0.001)
LEAST_DISTANCE = 1e-3  # of vertices whose relative error counts, in mean edges


class Part:
    """A mesh, with exact distances at any of its points."""

    def __init__(self, points, triangles, count):
        self.points, self.triangles = points, np.ascontiguousarray(triangles, dtype=np.int64)
        self.prepared = kernel.Surface(self.points, self.triangles)
        self.edge = surfaces.mean_edge(self.points, self.triangles)
        self._random = np.random.default_rng(surfaces.SEED)
        sites = self.random_points(count)
        for i, corner in enumerate(sites[1].argmax(axis=1)[::2]):
            sites[1][2 * i] = np.eye(3)[corner]
        self.sites = sites

    def random_points(self, count):
        """Returns faces and barycentric coordinates of points that are evenly distributed."""
        sides = self.points[self.triangles] - self.points[self.triangles[:, :1]]
        areas = np.linalg.norm(np.cross(sides[:, 1], sides[:, 2]), axis=1)
        faces = self._random.choice(len(areas), count, p=areas / areas.sum())
        return faces, self._random.dirichlet((1.0, 1.0, 1.0), count)

    def positions(self, faces, weights):
        """Returns the coordinates of surface points."""
        return np.einsum("ki,kij->kj", weights, self.points[self.triangles[faces]])

    def given(self, faces, weights):
        """Returns surface points as functions of the kernel take them."""
        return {"points": self.positions(faces, weights), "cells": faces, "barycentric": weights}

    def weights_of(self, faces, positions):
        """Returns barycentric coordinates of positions in faces."""
        a, b, c = self.points[self.triangles[faces]].transpose(1, 0, 2)
        normal = np.cross(b - a, c - a)
        square = (normal * normal).sum(axis=1)
        at = positions - a
        v = (np.cross(at, c - a) * normal).sum(axis=1) / square
        w = (np.cross(b - a, at) * normal).sum(axis=1) / square
        weights = np.clip(np.column_stack([1.0 - v - w, v, w]), 0.0, 1.0)
        return weights / weights.sum(axis=1)[:, None]

    def source(self, k):
        """Returns one of the sites."""
        return self.given(*(values[k : k + 1] for values in self.sites))

    def exact(self, k, faces=None, weights=None):
        """Returns exact distances from a site at all vertices, and at surface points."""
        if faces is None:
            return kernel.exact_distance(self.prepared, self.source(k)).point_data[DISTANCE], None
        field = kernel.exact_distance(self.prepared, self.source(k), generate_windows=True)
        return field.point_data[DISTANCE], self.probe(field, faces, weights)

    def probe(self, field, faces, weights):
        """Returns the distances of a field at surface points."""
        data = field.point_data
        return kernel.probe(
            self.prepared,
            data[DISTANCE],
            self.given(faces, weights),
            virtual_sources=data.get("GeodesicVirtualSource"),
            field_data=field.field_data,
        ).point_data[DISTANCE]


# --- Samples: faces, barycentric coordinates, and what the graph claims there --------------------


def along(begin, end, count):
    """Returns points that divide segments: their ends and points between them."""
    t = np.arange(count + 1)[:, None, None] / count
    return ((1.0 - t) * begin + t * end).reshape(-1, 3)


def line_points(part, lines, divisions=2):
    """Returns points along polylines within faces: faces, weights, and the line of each."""
    offsets, ids = lines.cells["lines"]
    number = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    is_inside = number[1:] == number[:-1]
    begin, end = ids[:-1][is_inside], ids[1:][is_inside]
    faces = lines.point_data["FaceId"][begin]
    places = along(lines.points[begin], lines.points[end], divisions)
    faces = np.tile(faces, divisions + 1)
    number = np.tile(number[:-1][is_inside], divisions + 1)
    return faces, part.weights_of(faces, places), number


def border_points(part, cells, divisions=4):
    """Returns points along the borders of cells: faces, weights, and the two sites of each."""
    offsets, corners = cells.cells["polygons"]
    polygon = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    following = np.arange(1, len(corners) + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    sides = np.sort(np.column_stack([corners, corners[following]]), axis=1)
    order = np.lexsort(sides.T)
    sides, polygon = sides[order], polygon[order]
    sites = cells.cell_data["SiteId"][polygon]
    is_border = (sides[1:] == sides[:-1]).all(axis=1) & (sites[1:] != sites[:-1])
    ends = cells.points[sides[:-1][is_border]]
    faces = cells.cell_data["FaceId"][polygon[:-1][is_border]]
    pairs = np.column_stack([sites[:-1], sites[1:]])[is_border]
    faces, pairs = np.tile(faces, divisions + 1), np.tile(pairs, (divisions + 1, 1))
    places = along(ends[:, 0], ends[:, 1], divisions)
    return faces, part.weights_of(faces, places), pairs


def field_samples(part, graph, k, levels, random):
    """Returns what a graph claims about the distance from site k: {construct: (faces, weights,
    distances)}."""
    field = graph.distance(part.source(k), generate_virtual_source=True)
    data = field.point_data
    lines, ridges, _ = kernel.isolines(
        part.prepared,
        data[DISTANCE],
        virtual_sources=data["GeodesicVirtualSource"],
        field_data=field.field_data,
        values=levels,
        chord_tolerance=CHORD,
        generate_ridges=True,
    )
    found = {"probes": (*random, part.probe(field, *random))}
    if len(lines.points):
        faces, weights, number = line_points(part, lines)
        found["isolines"] = faces, weights, lines.cell_data["IsoValue"][number]
    if len(ridges.points):
        faces, weights, _ = line_points(part, ridges)
        found["ridges"] = faces, weights, part.probe(field, faces, weights)
    return found


# --- Comparison with exact distances -------------------------------------------------------------


class Samples:
    """Surface points of all constructs, with exact distances from some sites."""

    def __init__(self):
        self._keys, self._faces, self._weights = [], [], []

    def add(self, key, faces, weights):
        """Adds the points of a construct."""
        self._keys.append((key, len(faces)))
        self._faces.append(faces)
        self._weights.append(weights)

    def exact(self, part, k):
        """Returns exact distances from a site by key, and the largest one at a vertex."""
        if not self._keys:
            return {}, 0.0
        at_vertices, values = part.exact(k, *map(np.concatenate, (self._faces, self._weights)))
        ends = np.cumsum([count for _, count in self._keys])[:-1]
        pieces = np.split(values, ends)
        return {key: piece for (key, _), piece in zip(self._keys, pieces)}, np.nanmax(at_vertices)


def compared(part, largest, faces, weights, claimed, exact, excess):
    """Returns the figures of the samples of one construct."""
    worst = int(np.nanargmax(excess))
    relative = excess / largest
    return {
        "samples": len(excess),
        "violations": int((relative > ROUNDING).sum()),
        "excess": max(0.0, float(relative[worst])),
        "edges": max(0.0, float(excess[worst] / part.edge)),
        "histogram": np.histogram(relative, (-np.inf, *BINS, np.inf))[0].tolist(),
        "worst": {
            "face": int(faces[worst]),
            "barycentric": weights[worst].tolist(),
            "claimed": float(claimed[worst]),
            "exact": float(exact[worst]),
        },
    }


def merged(one, two):
    """Returns the figures of two sets of samples together."""
    if one is None:
        return two
    larger = max(one, two, key=lambda figures: figures["excess"])
    return {
        **larger,
        **{key: one[key] + two[key] for key in ("samples", "violations")},
        "histogram": np.add(one["histogram"], two["histogram"]).tolist(),
    }


def measure_fields(part, graphs, options, found):
    """Adds the figures of probes, isolines and ridges."""
    random = part.random_points(options.points)
    for k in range(options.fields):
        largest = np.nanmax(part.exact(k)[0])
        levels = largest * np.arange(1, options.levels + 1) / (options.levels + 1)
        samples, claims = Samples(), {}
        for accuracy, graph in graphs.items():
            for construct, claim in field_samples(part, graph, k, levels, random).items():
                claims[accuracy, construct] = claim
                samples.add((accuracy, construct), *claim[:2])
        exact, largest = samples.exact(part, k)
        for (accuracy, construct), (faces, weights, claimed) in claims.items():
            true = exact[accuracy, construct]
            slack = CHORD * part.edge if construct == "isolines" else 0.0
            excess = np.abs(claimed - true) - accuracy * true - slack
            figures = compared(part, largest, faces, weights, claimed, true, excess)
            figures["worst"]["site"] = k
            of_graph = found[f"{accuracy:g}"]
            of_graph[construct] = merged(of_graph.get(construct), figures)


def measure_borders(part, graphs, options, found):
    """Adds the figures of the borders of Voronoi cells."""
    samples, borders = Samples(), {}
    for accuracy, graph in graphs.items():
        _, _, cells, _ = kernel.voronoi(graph, part.given(*part.sites))
        borders[accuracy] = border_points(part, cells)
        samples.add(accuracy, *borders[accuracy][:2])
    rows, largest = zip(*(samples.exact(part, k) for k in range(options.sites)))
    for accuracy, (faces, weights, pairs) in borders.items():
        if len(faces) == 0:
            continue
        exact = np.stack([row[accuracy] for row in rows])
        ends = np.take_along_axis(exact, pairs.T, axis=0)
        farther, nearest = ends.max(axis=0), exact.min(axis=0)
        # With equal distances of the two sites, and nothing nearer, this would not be positive.
        excess = (1.0 - accuracy) * farther - (1.0 + accuracy) * nearest
        figures = compared(part, max(largest), faces, weights, farther, nearest, excess)
        figures["worst"]["sites"] = pairs[int(np.nanargmax(excess))].tolist()
        found[f"{accuracy:g}"]["borders"] = figures


def measure_virtual(part, options):
    """Returns errors of distances from virtual sources at vertices."""
    found = {quality: [] for quality in QUALITIES}
    straight = []
    for k in range(options.sites):
        exact, _ = part.exact(k)
        chords = np.linalg.norm(part.points - part.source(k)["points"], axis=1)
        is_used = np.isfinite(exact) & (exact > LEAST_DISTANCE * part.edge)
        for quality in QUALITIES:
            field = kernel.virtual_source_distance(part.prepared, part.source(k), quality=quality)
            values = field.point_data[DISTANCE]
            found[quality].append(values[is_used] / exact[is_used] - 1.0)
            straight.append(((chords - values)[is_used] / exact[is_used]).max())
    errors = {quality: np.concatenate(values) for quality, values in found.items()}
    return {
        **{
            quality: {
                "least": float(np.nanmin(values)),
                "largest": float(np.nanmax(values)),
                "mean": float(np.nanmean(np.abs(values))),
                "missed": int(np.isnan(values).sum()),
            }
            for quality, values in errors.items()
        },
        "below chord": max(0.0, float(max(straight))),
        "warned": bool(field.quality_warning),
    }


def aspect_ratios(points, triangles):
    """Returns the longest side of each triangle divided by its height."""
    corners = points[triangles]
    sides = np.roll(corners, -1, axis=1) - corners
    longest = np.linalg.norm(sides, axis=2).max(axis=1)
    return longest**2 / np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)


def measure_part(points, triangles, accuracies, options):
    """Returns all figures of one mesh."""
    part = Part(points, triangles, options.sites)
    aspects = aspect_ratios(points, triangles)
    found = {
        "vertices": len(points),
        "faces": len(triangles),
        "aspect": {"median": float(np.median(aspects)), "max": float(aspects.max())},
        "edge": part.edge,
        "virtual": measure_virtual(part, options),
        "graphs": {f"{accuracy:g}": {} for accuracy in accuracies},
    }
    if accuracies:
        graphs = {a: kernel.Graph(part.prepared, accuracy=a) for a in accuracies}
        measure_fields(part, graphs, options, found["graphs"])
        measure_borders(part, graphs, options, found["graphs"])
    return found


def measure(options):
    """Returns the figures of all meshes, by name."""
    found = {}
    for given in options.meshes or ("*",):
        for name in fnmatch.filter(parts.PARTS, given) or [given]:
            title, points, triangles = modes.open_arrays(name)
            print(title, flush=True)
            default = ACCURACIES if name in parts.PARTS else ()
            accuracies = [a for a in map(float, options.accuracies or default) if a > 0.0]
            found[title] = measure_part(points, triangles, accuracies, options)
    before = None
    if options.before:
        with open(options.before, encoding="utf-8") as file:
            earlier = json.load(file)["parts"]
        before = {name: earlier[name] for name in found if name in earlier}
    return {"parts": found, "before": before}


# --- Tables --------------------------------------------------------------------------------------


def constructs_of(found):
    """Yields mesh, accuracy, construct and figures."""
    for name, part in found.items():
        for accuracy, constructs in part["graphs"].items():
            for construct, figures in constructs.items():
                yield name, accuracy, construct, figures


def summary_table(results):
    rows = {}
    for _, accuracy, construct, figures in constructs_of(results["parts"]):
        rows.setdefault((construct, accuracy), []).append(figures)
    columns = (
        column("construct", str, "construct"),
        column("ε", str, "accuracy"),
        column("parts", str, "parts"),
        column("parts with violations", str, "violating"),
        column("samples", count_text, "samples"),
        column("violations", count_text, "violations"),
        column("largest excess, % of the largest distance", percent, "excess"),
        column("in mean edges", digits, "edges"),
    )
    return listing(
        columns,
        [
            {
                "construct": construct,
                "accuracy": accuracy,
                "parts": len(figures),
                "violating": sum(f["violations"] > 0 for f in figures),
                **{key: sum(f[key] for f in figures) for key in ("samples", "violations")},
                **{key: max(f[key] for f in figures) for key in ("excess", "edges")},
            }
            for (construct, accuracy), figures in sorted(rows.items())
        ],
    )


def histogram_table(results):
    """Returns numbers of samples, and of parts by their worst sample, by the size of the excess."""
    rows = {}
    for when in ("before", "parts"):
        for _, accuracy, construct, figures in constructs_of(results[when] or {}):
            key = construct, accuracy, "after" if when == "parts" and results["before"] else when
            row = rows.setdefault(key, {"samples": 0, "parts": 0})
            counts = np.array(figures["histogram"])
            row["samples"] = row["samples"] + counts
            row["parts"] = row["parts"] + (np.arange(len(counts)) == np.flatnonzero(counts)[-1])
    limits = [f"{100.0 * limit:g} %" for limit in BINS]
    titles = ["none", *(f"> {limit}" for limit in limits)]
    columns = [column("construct", str, "construct"), column("ε", str, "accuracy")]
    if results["before"]:
        columns.append(column("", str, "when"))

    def cell(row, i):
        return f"{count_text(row['samples'][i])} ({row['parts'][i]})"

    columns += [(title, lambda row, i=i: cell(row, i)) for i, title in enumerate(titles)]
    return listing(
        columns,
        [
            {"construct": construct, "accuracy": accuracy, "when": when, **row}
            for (construct, accuracy, when), row in sorted(
                rows.items(), key=lambda item: (*item[0][:2], item[0][2] != "before")
            )
        ],
    )


def violation_table(results):
    columns = (
        column("part", str, "name"),
        column("ε", str, "accuracy"),
        column("construct", str, "construct"),
        ("violations", lambda row: f"{row['violations']} of {row['samples']}"),
        column("excess, %", percent, "excess"),
        column("mean edges", digits, "edges"),
        column("face", str, "worst", "face"),
        column("claimed", digits, "worst", "claimed"),
        column("exact", digits, "worst", "exact"),
    )
    return listing(
        columns,
        [
            {"name": name, "accuracy": accuracy, "construct": construct, **figures}
            for name, accuracy, construct, figures in constructs_of(results["parts"])
            if figures["violations"]
        ],
    )


def virtual_table(results):
    def extremes(quality):
        return lambda row: " / ".join(
            percent(row["virtual"][quality][key]) for key in ("least", "largest", "mean")
        )

    columns = (
        column("mesh", str, "name"),
        column("vertices", count_text, "vertices"),
        column("aspect ratio: median", digits, "aspect", "median"),
        column("max", digits, "aspect", "max"),
        *((f"{quality}: least / largest / mean, %", extremes(quality)) for quality in QUALITIES),
        ("mean: High / Fast", lambda row: digits(mean_ratio(row))),
        column("below the straight line, %", percent, "virtual", "below chord"),
        ("warning", lambda row: "yes" if row["virtual"]["warned"] else "no"),
    )
    return listing(columns, named(results["parts"]))


def mean_ratio(row):
    """Returns the mean error of High divided by that of Fast."""
    fast, high = (max(row["virtual"][quality]["mean"], 1e-12) for quality in QUALITIES)
    return high / fast


def virtual_summary(results):
    rows = list(results["parts"].values())

    def count(condition):
        return sum(map(condition, rows))

    def worst(row):
        return min(row["virtual"][quality]["least"] for quality in QUALITIES)

    facts = {
        "meshes": len(rows),
        "more than 20 % too short": count(lambda row: worst(row) < -0.2),
        "of them without a warning": count(
            lambda row: worst(row) < -0.2 and not row["virtual"]["warned"]
        ),
        "shorter than the straight line": count(
            lambda row: row["virtual"]["below chord"] > ROUNDING
        ),
        "mean error of High above 1.05 times that of Fast": count(
            lambda row: mean_ratio(row) > 1.05
        ),
        "above 1.2 times": count(lambda row: mean_ratio(row) > 1.2),
    }
    columns = (column("virtual sources", str, "fact"), column("meshes", str, "count"))
    return listing(columns, [{"fact": fact, "count": n} for fact, n in facts.items()])


def tables(results):
    """Returns all tables."""
    makers = {
        "Excess over the bound": summary_table,
        "Samples by excess over the bound, relative to the largest distance (parts by their worst "
        "sample)": histogram_table,
        "Violations, with the worst sample": violation_table,
        "Virtual sources, errors at vertices": virtual_summary,
        "Virtual sources": virtual_table,
    }
    return titled({title: make(results) for title, make in makers.items()})


def parse(arguments=None):
    """Returns the options of a command line."""
    return modes.parse(
        __doc__,
        arguments,
        accuracies=(),
        points=10000,
        levels=20,
        sites=10,
        fields=2,
        before="",
    )


if __name__ == "__main__":
    modes.run(measure, tables, parse())
