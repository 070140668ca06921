# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Effects of noise and shape on graphs; paths on terrain, samples, many meshes."""

import math
import os

import numpy as np
import passrate
import vtkdgg
from plots import STYLES, Panel, plot, plot_rates
from tables import (
    column,
    digits,
    errors_text,
    hundredths,
    listing,
    named,
    percent,
    range_text,
    ratio,
    tenths,
    vertices_text,
    whole_percent,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

from . import surfaces
from .exhibit import BETTER, NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .fields import graph_figures, timed

FLAT = 1e-9 * 2.0 * math.pi
ACCURACY = 0.01
TWO_RULES = ("OneRelay", "Guaranteed")


class Noise(Exhibit):
    """Vertices are moved along their normals, on average by up to 0.4 mean edge lengths."""

    name = "F3.11"
    title = "noise"
    published = "graphs of models with increasing noise; figures are not available."
    levels = ("0.05", "0.1", "0.2", "0.4")
    columns = (
        column("noise, mean edges", str, "name"),
        column("saddles", whole_percent, "saddles"),
        column("degree: OneRelay", tenths, "OneRelay", "degree"),
        column("Guaranteed", tenths, "Guaranteed", "degree"),
        column("error, mean / 99.9 % / max: OneRelay", errors_text, "OneRelay", "error"),
        column("Guaranteed", errors_text, "Guaranteed", "error"),
        column("Guaranteed, corrected", errors_text, "Guaranteed", "corrected"),
    )

    def measure(self, run):
        base = run.pick("bumpy-4", "bumpy-5")
        found = {}
        for level in ("0", *self.levels):
            name = base if level == "0" else f"{base}-noise-{level}"
            total, _ = surfaces.total_angles(*surfaces.arrays_of(run.mesh(name)))
            found[level] = {"saddles": float((total > 2.0 * math.pi + FLAT).mean())}
            for rule in TWO_RULES:
                found[level][rule] = graph_figures(run, name, accuracy=ACCURACY, construction=rule)
        return found

    def note(self, figures):
        return f"ε = {ACCURACY}."

    def pictures(self, figures):
        rules = dict(zip(TWO_RULES[::-1], STYLES))

        def panel(title, value):
            curves = [
                ([(float(level), value(figures[level][rule])) for level in self.levels], style, "-")
                for rule, style in rules.items()
            ]
            return Panel(title, "noise, mean edges", "", curves)

        panels = [
            panel("edges per vertex", lambda found: found["degree"]),
            panel("mean error (%)", lambda found: 100.0 * found["error"]["mean"]),
        ]
        return {self.name: lambda path: plot(path, [panels], rules.items(), size=(10.0, 4.4))}

    def verdict(self, figures):
        degrees = [row["OneRelay"]["degree"] for row in figures.values()]
        return Verdict(
            NOT_COMPARABLE,
            f"The degree of OneRelay changes by {whole_percent(max(degrees) / min(degrees) - 1.0)}. The "
            "correction assumes a flat surface between two vertices.",
        )


class DegreeHistogram(Exhibit):
    """Edges per vertex, at saddle vertices and at other vertices."""

    name = "F3.12"
    title = "distribution of degrees"
    published = "histograms of the degree, of saddle vertices and of others."
    bins = 30
    columns = (
        column("rule", str, "name"),
        column("degree of saddle vertices", "{0[mean]:.1f} ± {0[deviation]:.1f}", "saddle"),
        column("of others", "{0[mean]:.1f} ± {0[deviation]:.1f}", "other"),
    )

    def measure(self, run):
        name = (run.scans() or ["bumpy-5"])[-1] if run.full else run.pick("bumpy-5", "bumpy-6")
        mesh = run.mesh(name)
        points, triangles = surfaces.arrays_of(mesh)
        total, is_rim = surfaces.total_angles(points, triangles)
        is_saddle = (total > 2.0 * math.pi + FLAT) & ~is_rim
        found = {"model": name, "vertices": len(points), "saddles": float(is_saddle.mean())}
        for rule in TWO_RULES:
            graph = vtkdgg.Graph(mesh, accuracy=ACCURACY, construction=rule)
            degrees = np.diff(graph.offsets)
            step = math.ceil((np.ptp(degrees) + 1) / self.bins)
            edges = np.arange(degrees.min(), degrees.max() + step + 1, step) - 0.5
            found[rule] = {"edges": edges.tolist()}
            for key, chosen in (("saddle", is_saddle), ("other", ~is_saddle)):
                found[rule][key] = {
                    "mean": float(degrees[chosen].mean()),
                    "deviation": float(degrees[chosen].std()),
                    "counts": np.histogram(degrees[chosen], edges)[0].tolist(),
                }
        return found

    def note(self, figures):
        return (
            f"{figures['model']}, {vertices_text(figures['vertices'])}, "
            f"{whole_percent(figures['saddles'])} of them saddles; ε = {ACCURACY}."
        )

    def table(self, figures):
        rules = {rule: figures[rule] for rule in TWO_RULES}
        return listing(self.columns, named(rules), self.note(figures))

    def pictures(self, figures):
        kinds = dict(zip(("saddle", "other"), STYLES))

        def panel(rule):
            def draw_bars(axes):
                edges = np.array(figures[rule]["edges"])
                width = 0.45 * np.diff(edges)
                for i, (kind, (color, _)) in enumerate(kinds.items()):
                    counts = figures[rule][kind]["counts"]
                    axes.bar(edges[:-1] + (i + 0.5) * width, counts, width, color=color)

            return Panel(rule, "edges of a vertex", "vertices", (), draw_bars, (), False)

        panels = [panel(rule) for rule in TWO_RULES]
        return {self.name: lambda path: plot(path, [panels], kinds.items(), size=(10.0, 4.2))}


class TerrainPath(Exhibit):
    """Lengths of shortest paths on a generated terrain: in the graph, and along edges of the mesh,
    relative to exact ones."""

    name = "F3.18"
    title = "paths on a terrain"
    published = "shortest paths on a terrain of 66K vertices, as pictures."
    side = 257
    pairs = 12
    titles_of_paths = {
        "graph": "path in the graph",
        "straightened": "the same, straightened (default)",
        "edges": "vtkDijkstraGraphGeodesicPath, along edges of the mesh",
    }
    columns = (
        column("path", titles_of_paths.get, "name"),
        column("excess length, mean, %", percent, "mean"),
        column("largest, %", percent, "max"),
    )

    def measure(self, run):
        mesh = run.mesh(f"terrain-{run.pick(129, self.side)}")
        graph = vtkdgg.Graph(mesh, accuracy=ACCURACY)
        random = np.random.default_rng(surfaces.SEED)
        ends = random.choice(mesh.GetNumberOfPoints(), (self.pairs, 2), replace=False)
        lengths = {"exact": [], "graph": [], "straightened": [], "edges": []}
        seconds = {"graph": 0.0, "exact": 0.0}
        for start, end in ends.tolist():
            searches = {
                "graph": lambda: graph.path(start, end, straighten=False).length,
                "exact": lambda: vtkdgg.distance(mesh, start)[end],
            }
            for key, search in searches.items():
                length, took = timed(search)
                lengths[key].append(length)
                seconds[key] += took
            lengths["straightened"].append(graph.path(start, end).length)
            lengths["edges"].append(edge_length(mesh, start, end))
        exact = np.array(lengths["exact"])
        return {
            "vertices": mesh.GetNumberOfPoints(),
            "longer": {
                key: {
                    "mean": float((np.array(found) / exact - 1.0).mean()),
                    "max": float((np.array(found) / exact - 1.0).max()),
                }
                for key, found in lengths.items()
                if key != "exact"
            },
            "times_faster": seconds["exact"] / seconds["graph"],
        }

    def table(self, figures):
        note = f"{vertices_text(figures['vertices'])}, {self.pairs} random pairs, ε = {ACCURACY}."
        return listing(self.columns, named(figures["longer"]), note)

    def verdict(self, figures):
        part = digits(figures["times_faster"])
        return Verdict(NOT_COMPARABLE, f"A query takes 1/{part} of the time of an exact propagation.")


def edge_length(mesh, start, end):
    """Returns the length of the shortest path along edges of the mesh."""
    along = vtkDijkstraGraphGeodesicPath()
    along.SetInputData(mesh)
    along.SetStartVertex(start)
    along.SetEndVertex(end)
    along.StopWhenEndReachedOn()
    line = vtkdgg.check(along)
    ids = vtk_to_numpy(line.GetLines().GetConnectivityArray())
    points = vtk_to_numpy(line.GetPoints().GetData()).astype(float)[ids]
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


class Samples(Exhibit):
    """Farthest points by several distances: geodesic, spectral and Euclidean. The covering radius is the
    largest geodesic distance from the samples, the smallest distance is that between two samples. Their
    ratio is best at 1."""

    name = "F4.4"
    title = "sampling by several distances"
    published = "samples by three distances, as pictures."
    count = 60
    columns = (
        column("distance", str, "name"),
        column("covering radius", digits, "covering"),
        column("smallest distance", digits, "separation"),
        ratio("ratio", ("covering",), ("separation",), hundredths),
    )

    def measure(self, run):
        name = "torus-60"
        mesh = run.mesh(name)
        graph = vtkdgg.Graph(mesh, accuracy=0.01)
        n = mesh.GetNumberOfPoints()
        points, _ = surfaces.arrays_of(mesh)
        columns = {
            "geodesic": lambda s: graph.distance(s),
            "biharmonic": lambda s: self.smooth(run, name, "Biharmonic")[s],
            "commute time": lambda s: self.smooth(run, name, "CommuteTime")[s],
            "Euclidean": lambda s: np.linalg.norm(points - points[s], axis=1),
        }
        found = {}
        for title, make in columns.items():
            samples = farthest(make, self.count)
            fields = np.array([graph.distance(s) for s in samples])
            apart = fields[:, samples] + np.where(np.eye(len(samples)) > 0, np.inf, 0.0)
            found[title] = {
                "covering": float(fields.min(axis=0).max()),
                "separation": float(apart.min()),
            }
        return {"vertices": n, "found": found}

    def smooth(self, run, name, kind):
        """Returns spectral distances between all pairs of vertices."""
        mesh = run.mesh(name)
        ids = list(range(mesh.GetNumberOfPoints()))
        return run.once((name, kind), lambda: vtkdgg.biharmonic(mesh, ids, kind=kind).T)

    def table(self, figures):
        note = f"{self.count} samples of {vertices_text(figures['vertices'])}."
        return listing(self.columns, named(figures["found"]), note)


def farthest(distances, count):
    """Returns samples, each of which is farthest from all earlier ones."""
    samples = [0]
    nearest = distances(0)
    while len(samples) < count:
        samples.append(int(np.argmax(nearest)))
        nearest = np.minimum(nearest, distances(samples[-1]))
    return samples


class PassRate(Exhibit):
    """Relative errors of graphs of all meshes in a folder, by accuracy. `run.sh passrate FOLDER`
    measures any folder and writes a table of all graphs."""

    name = "F5.3"
    title = "accuracy over many meshes"
    published = (
        "mean errors of 0.3 to 0.6 ε on many meshes; meshes with anisotropy above 3 stand out."
    )

    def measure(self, run):
        folder = run.data
        if folder is not None:
            run.uses("all meshes of the folder")
        else:
            folder = os.path.join(run.folder, "meshes")
            os.makedirs(folder, exist_ok=True)
            for name in (
                "bumpy-3",
                "torus-40",
                "terrain-40",
                "bumpy-3-stretched-4",
                "bumpy-3-noise-0.3",
            ):
                path = os.path.join(folder, f"{name}.ply")
                if not os.path.isfile(path):
                    os.rename(run.file(name), path)
        most = run.pick(30000, 200000)
        return passrate.measure(folder, (0.1, 0.01), most_points=most, say=lambda _: None)

    def table(self, figures):
        groups = {}
        for row in figures["rows"]:
            groups.setdefault(row["accuracy"], []).append(row)
        rows = [
            {
                "accuracy": accuracy,
                "meshes": len(rows),
                "kept": sum(map(passrate.passes, rows)),
                **{key: [row[key] / accuracy for row in rows] for key in ("mean", "max")},
            }
            for accuracy, rows in groups.items()
        ]
        columns = (
            column("ε", "{:g}", "accuracy"),
            column("meshes", str, "meshes"),
            column("within the bound", str, "kept"),
            column("mean error / ε", range_text, "mean"),
            column("largest error / ε", range_text, "max"),
        )
        return listing(columns, rows)

    def pictures(self, figures):
        return {self.name: lambda path: plot_rates(figures, path)}

    def verdict(self, figures):
        means = [row["mean"] / row["accuracy"] for row in figures["rows"]]
        kept = all(map(passrate.passes, figures["rows"])) and max(means) < 0.3
        anisotropies = [row["tau"] for row in figures["rows"]]
        return Verdict(
            BETTER if kept else WORSE,
            f"The anisotropy of the triangles is {range_text(anisotropies, '{:.3g}'.format)}. "
            f"{len(figures['refused'])} files were refused.",
        )


EXHIBITS = (Noise(), DegreeHistogram(), TerrainPath(), Samples(), PassRate())
