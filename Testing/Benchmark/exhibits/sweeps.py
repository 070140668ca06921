# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What shape, noise and sampling do to graphs; paths over land; many meshes at once."""

import math
import os
import time

import numpy as np
import passrate
import vtkdgg
from benchmark_results import digits, percent, ratio_text
from plot_tools import STYLES, add_legend, draw_curve, few_minor, load_matplotlib, style_axes
from vtkdgg.commands.sizes import floor_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

from . import surfaces
from .exhibit import BETTER, NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .fields import exact_fields, sources_of, summary
from .tables import column, errors_text, hundredths, listing, named, tenths, vertices_text

FLAT = 1e-9 * 2.0 * math.pi


class Noise(Exhibit):
    """Vertices are moved along the normals, by more and more of a mean edge."""

    name = "F3.11"
    title = "noise"
    published = "graphs of models with more and more noise; its figures are not at hand."
    levels = ("0.05", "0.1", "0.2", "0.4")
    accuracy = 0.01

    def measure(self, run):
        base = run.pick("bumpy-4", "bumpy-5")
        found = {}
        for level in ("0", *self.levels):
            name = base if level == "0" else f"{base}-noise-{level}"
            mesh = run.mesh(name)
            points, triangles = surfaces.arrays_of(mesh)
            total, _ = surfaces.total_angles(points, triangles)
            exact = exact_fields(run, name)
            found[level] = {"saddles": float((total > 2.0 * math.pi + FLAT).mean())}
            for rule in ("Guaranteed", "OneRelay"):
                graph = vtkdgg.Graph(mesh, accuracy=self.accuracy, construction=rule)
                sources = sources_of(mesh)
                raw = [graph.distance(s, correction=False) for s in sources]
                corrected = [graph.distance(s) for s in sources]
                found[level][rule] = {
                    "degree": graph.degree,
                    "error": summary(raw, exact, floor_of(mesh)),
                    "corrected": summary(corrected, exact, floor_of(mesh)),
                }
        return found

    def table(self, figures):
        columns = (
            column("noise, mean edges", str, "name"),
            ("saddles", lambda row: f"{100.0 * row['saddles']:.0f} %"),
            column("degree: OneRelay", tenths, "OneRelay", "degree"),
            column("Guaranteed", tenths, "Guaranteed", "degree"),
            column("error, mean / 99.9 % / max: OneRelay", errors_text, "OneRelay", "error"),
            column("Guaranteed", errors_text, "Guaranteed", "error"),
            column("Guaranteed, corrected", errors_text, "Guaranteed", "corrected"),
        )
        return listing(columns, named(figures), f"ε = {self.accuracy}.")

    def draw(self, figures, path):
        subplots, handle = load_matplotlib()
        figure, row = subplots(1, 2, figsize=(10, 4.4))
        rules = dict(zip(("Guaranteed", "OneRelay"), STYLES))
        for rule, style in rules.items():
            noisy = [(float(level), figures[level][rule]) for level in self.levels]
            draw_curve(row[0], [(x, f["degree"]) for x, f in noisy], style)
            draw_curve(row[1], [(x, 100.0 * f["error"]["mean"]) for x, f in noisy], style)
        for axes, title in zip(row, ("edges per vertex", "mean error (%)")):
            style_axes(axes, title, "noise, mean edges", minor=few_minor, y_minor=few_minor)
        add_legend(figure, handle, rules.items(), columns=2)
        figure.tight_layout(rect=(0.0, 0.1, 1.0, 1.0))
        figure.savefig(path, dpi=80)
        return True

    def verdict(self, figures):
        degrees = [row["OneRelay"]["degree"] for row in figures.values()]
        change = max(degrees) / min(degrees) - 1.0
        largest = max(row["Guaranteed"]["error"]["max"] for row in figures.values())
        corrected = [row["Guaranteed"]["corrected"]["mean"] for row in figures.values()]
        return Verdict(
            NOT_COMPARABLE,
            f"The degree changes by {100.0 * change:.0f} % up to noise of 0.4 edges; the largest error "
            f"of our rule is {percent(largest)} % at ε = 1 %. The mean error of corrected distances, "
            f"which take the surface between two vertices to be flat, is {percent(min(corrected))} to "
            f"{percent(max(corrected))} %.",
        )


class DegreeHistogram(Exhibit):
    """Edges per vertex, of saddle vertices and of others."""

    name = "F3.12"
    title = "distribution of degrees"
    published = "histograms of the degree, of saddle vertices and of others."
    accuracy = 0.01
    bins = 30

    def measure(self, run):
        name = (run.scans() or ["bumpy-5"])[-1] if run.full else run.pick("bumpy-5", "bumpy-6")
        mesh = run.mesh(name)
        points, triangles = surfaces.arrays_of(mesh)
        total, is_rim = surfaces.total_angles(points, triangles)
        is_saddle = (total > 2.0 * math.pi + FLAT) & ~is_rim
        found = {"model": name, "vertices": len(points), "saddles": float(is_saddle.mean())}
        for rule in ("OneRelay", "Guaranteed"):
            graph = vtkdgg.Graph(mesh, accuracy=self.accuracy, construction=rule)
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

    def table(self, figures):
        form = "{0[mean]:.1f} ± {0[deviation]:.1f}".format
        columns = (
            column("rule", str, "name"),
            column("degree of saddle vertices", form, "saddle"),
            column("of others", form, "other"),
        )
        note = (
            f"{figures['model']}, {vertices_text(figures['vertices'])}, "
            f"{100.0 * figures['saddles']:.0f} % of them saddles; ε = {self.accuracy}."
        )
        rules = {rule: figures[rule] for rule in ("OneRelay", "Guaranteed")}
        return listing(columns, named(rules), note)

    def draw(self, figures, path):
        subplots, handle = load_matplotlib()
        figure, row = subplots(1, 2, figsize=(10, 4.2))
        kinds = dict(zip(("saddle", "other"), STYLES))
        for axes, rule in zip(row, ("OneRelay", "Guaranteed")):
            edges = np.array(figures[rule]["edges"])
            width = 0.45 * np.diff(edges)
            for i, (kind, (colour, _)) in enumerate(kinds.items()):
                axes.bar(
                    edges[:-1] + (i + 0.5) * width,
                    figures[rule][kind]["counts"],
                    width,
                    color=colour,
                )
            axes.set_title(rule, fontsize=12)
            axes.set_xlabel("edges of a vertex", fontsize=11)
            axes.set_ylabel("vertices", fontsize=11)
        add_legend(figure, handle, kinds.items(), columns=2)
        figure.tight_layout(rect=(0.0, 0.1, 1.0, 1.0))
        figure.savefig(path, dpi=80)
        return True

    def verdict(self, figures):
        rule = figures["OneRelay"]
        ratio = rule["saddle"]["mean"] / rule["other"]["mean"]
        spread = rule["other"]["deviation"] / rule["other"]["mean"]
        return Verdict(
            NOT_COMPARABLE,
            "Histograms of other models were published. The standard deviation is "
            f"{100.0 * spread:.0f} % of the mean, and saddle vertices have "
            f"{ratio:.2f} times the degree of others.",
        )


class TerrainPath(Exhibit):
    """Shortest paths over a generated terrain: in the graph, and along the sides of triangles,
    beside exact ones."""

    name = "F3.18"
    title = "paths on a terrain"
    published = "shortest paths on a terrain of 66K vertices, as pictures."
    side = 257
    pairs = 12
    accuracy = 0.01

    def measure(self, run):
        mesh = run.mesh(f"terrain-{run.pick(129, self.side)}")
        graph = vtkdgg.Graph(mesh, accuracy=self.accuracy)
        random = np.random.default_rng(surfaces.SEED)
        ends = random.choice(mesh.GetNumberOfPoints(), (self.pairs, 2), replace=False)
        lengths = {"exact": [], "graph": [], "straightened": [], "edges": []}
        seconds = {"graph": 0.0, "exact": 0.0}
        for start, end in ends.tolist():
            clock = time.process_time()
            raw = graph.path(start, end, straighten=False)
            seconds["graph"] += time.process_time() - clock
            lengths["graph"].append(raw.length)
            lengths["straightened"].append(graph.path(start, end).length)
            clock = time.process_time()
            lengths["exact"].append(vtkdgg.distance(mesh, start)[end])
            seconds["exact"] += time.process_time() - clock
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
        titles = {
            "graph": "path in the graph",
            "straightened": "the same, straightened (default)",
            "edges": "vtkDijkstraGraphGeodesicPath, along sides of triangles",
        }
        columns = (
            column("path", titles.get, "name"),
            column("longer than exact, mean, %", percent, "mean"),
            column("largest, %", percent, "max"),
        )
        note = (
            f"{vertices_text(figures['vertices'])}, {self.pairs} random pairs, ε = {self.accuracy}."
        )
        return listing(columns, named(figures["longer"]), note)

    def verdict(self, figures):
        graph = figures["longer"]["graph"]
        return Verdict(
            NOT_COMPARABLE,
            f"Pictures were published. Paths are at most {percent(graph['max'])} % too long, straightened "
            f"{percent(figures['longer']['straightened']['max'])} %; a query takes "
            f"1/{digits(figures['times_faster'])} of an exact propagation.",
        )


def edge_length(mesh, start, end):
    """Of the shortest path along sides of triangles."""
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
    """Farthest points by several distances: along the surface, of its spectrum, and straight through
    space. How far
    the surface is from the nearest one along it, by how far the samples are apart; 1 would be best.
    """

    name = "F4.4"
    title = "sampling by several distances"
    published = "samples by three distances beside each other, as pictures."
    count = 60

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
            samples = farthest(make, n, self.count)
            fields = np.array([graph.distance(s) for s in samples])
            apart = fields[:, samples] + np.where(np.eye(len(samples)) > 0, np.inf, 0.0)
            found[title] = {
                "covering": float(fields.min(axis=0).max()),
                "separation": float(apart.min()),
            }
        return {"vertices": n, "found": found}

    def smooth(self, run, name, kind):
        """Distances of the spectrum between all pairs of vertices."""
        mesh = run.mesh(name)
        ids = list(range(mesh.GetNumberOfPoints()))
        return run.once((name, kind), lambda: vtkdgg.biharmonic(mesh, ids, kind=kind).T)

    def table(self, figures):
        columns = (
            column("distance", str, "name"),
            column("covering radius", digits, "covering"),
            column("least distance", digits, "separation"),
            ("ratio", lambda row: hundredths(row["covering"] / row["separation"])),
        )
        note = f"{self.count} samples of {vertices_text(figures['vertices'])}."
        return listing(columns, named(figures["found"]), note)

    def verdict(self, figures):
        ratios = {t: r["covering"] / r["separation"] for t, r in figures["found"].items()}
        return Verdict(
            NOT_COMPARABLE,
            "Pictures were published. Geodesic distance spreads samples "
            f"{ratio_text(ratios['biharmonic'], ratios['geodesic'])} as evenly as biharmonic distance. Euclidean distance does as well, where "
            "sheets are not close to each other.",
        )


def farthest(column, n, count):
    """Samples each of which is farthest from those before, by columns of a distance."""
    samples = [0]
    nearest = column(0)
    while len(samples) < count:
        samples.append(int(np.argmax(nearest)))
        nearest = np.minimum(nearest, column(samples[-1]))
    return samples


class PassRate(Exhibit):
    """All meshes of a folder, at several accuracies: `run.sh passrate FOLDER` measures those of any
    other one."""

    name = "F5.3"
    title = "accuracy over many meshes"
    published = (
        "mean error over ε, 0.3 to 0.6, of many meshes; those with anisotropy above 3 stand out."
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
        return passrate.tables(figures)

    def draw(self, figures, path):
        return passrate.plot(figures, path)

    def verdict(self, figures):
        rows = [row for row in figures["rows"] if "mean" in row]
        means = [row["mean"] / row["accuracy"] for row in rows]
        largest = max(row["max"] / row["accuracy"] for row in rows)
        return Verdict(
            BETTER if largest <= 1.0 + 1e-6 and max(means) < 0.3 else WORSE,
            f"Mean errors are {digits(min(means))} to {digits(max(means))} ε, largest ones at most "
            f"{digits(largest)} ε, at any anisotropy. Refused were {len(figures['refused'])} files.",
        )


EXHIBITS = (Noise(), DegreeHistogram(), TerrainPath(), Samples(), PassRate())
