# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences from the thesis that none of its exhibits shows."""

import statistics

import numpy as np
import vtkdgg
from Published import bidirectional, green_sums
from Published.delaunay_mesh import DelaunayMesh
from tables import (
    column,
    count_text,
    digits,
    errors_text,
    listing,
    named,
    number,
    percent,
    range_text,
    ratio,
    table,
    vertices_text,
)
from vtkdgg.commands.sizes import floor_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from . import surfaces
from .exhibit import BETTER, NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .fields import exact_fields, sources_of, summary, timed

ACCURACY = 0.01
SIDES = 1e-3  # distance from a curve within which flat triangles decide the side of a fragment


class BothEnds(Exhibit):
    """Searches between random pairs of vertices in a graph: the share of vertices settled until the path
    is found, and of paths that are not the shortest."""

    name = "D1.1"
    title = "paths: A* instead of a search from both ends"
    published = "a search from both ends that stops where the two searches first meet."
    pairs = 60
    columns = (
        column("search", str, "name"),
        column("vertices settled, %", lambda x: f"{100.0 * x:.1f}", "settled"),
        column("not the shortest path, %", lambda x: number(100.0 * x), "wrong"),
        ("longer by at most, %", lambda row: percent(row["excess"] if row["wrong"] else None)),
    )

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        graph = vtkdgg.Graph(mesh, accuracy=ACCURACY)
        read = bidirectional.arrays(graph)
        points, _ = surfaces.arrays_of(mesh)
        random = np.random.default_rng(surfaces.SEED)
        found = {"one end": [], "both ends": [], "both ends, as published": [], "A*": []}
        for _ in range(self.pairs):
            start, end = random.choice(len(points), 2, replace=False).tolist()
            straight = np.linalg.norm(points - points[end], axis=1) * (1.0 - 1e-6)
            found["one end"].append(bidirectional.one_sided(read, start, end))
            found["both ends"].append(bidirectional.two_sided(read, start, end, False))
            found["both ends, as published"].append(bidirectional.two_sided(read, start, end, True))
            found["A*"].append(bidirectional.one_sided(read, start, end, straight))
        shortest = np.array([length for length, _ in found["one end"]])
        return {
            "vertices": len(points),
            "searches": {
                title: {
                    "settled": statistics.fmean(count for _, count in pairs) / len(points),
                    "wrong": float((longer(pairs, shortest) > 1e-9).mean()),
                    "excess": float(longer(pairs, shortest).max()),
                }
                for title, pairs in found.items()
            },
        }

    def table(self, figures):
        note = f"{vertices_text(figures['vertices'])}, {self.pairs} pairs, ε = {ACCURACY}."
        return listing(self.columns, named(figures["searches"]), note)

    def verdict(self, figures):
        star, both = figures["searches"]["A*"], figures["searches"]["both ends"]
        return Verdict(
            BETTER if star["settled"] < both["settled"] and not star["wrong"] else WORSE,
            "A correct search from both ends settles "
            f"{digits(both['settled'] / star['settled'])} times as many vertices as A*.",
        )


def longer(pairs, shortest):
    """Returns the relative excess of lengths."""
    return np.array([length for length, _ in pairs]) / shortest - 1.0


class Links(Exhibit):
    """Sources at the centers of random faces, which are linked to the unchanged graph. Times are in units
    of a query from a vertex."""

    name = "D1.2"
    title = "points anywhere: links instead of insertion"
    published = "the point is inserted into the mesh, and the graph is changed around it."
    sources = 10

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        points, triangles = surfaces.arrays_of(mesh)
        graph, built = timed(lambda: vtkdgg.Graph(mesh, accuracy=ACCURACY))
        faces = np.random.default_rng(surfaces.SEED).choice(len(triangles), self.sources)
        places = points[triangles[faces]].mean(axis=1)
        exact = [vtkdgg.distance(mesh, place) for place in places]
        graph.distance(0)
        graph.distance(places[:1])  # prepares the search
        times = {"vertex": [], "face": []}
        found = []
        for k, place in enumerate(places):
            for kind, source in (("vertex", k), ("face", place[None])):
                distances, seconds = timed(lambda s=source: graph.distance(s, correction=False))
                times[kind].append(seconds)
            found.append(distances)
        unit = statistics.median(times["vertex"])
        return {
            "vertices": len(points),
            "query": statistics.median(times["face"]) / unit,
            "build": built / unit,
            "error": summary(found, exact, floor_of(mesh)),
        }

    def table(self, figures):
        rows = [
            ["query from a point in a face", f"{figures['query']:.2f}"],
            ["construction of the graph", f"{figures['build']:.0f}"],
            ["error: mean / 99.9 % / max", errors_text(figures["error"])],
        ]
        note = f"{vertices_text(figures['vertices'])}, {self.sources} sources, ε = {ACCURACY}."
        return note + "\n\n" + table(["quantity", "queries from a vertex"], rows)

    def verdict(self, figures):
        is_kept = figures["error"]["max"] <= ACCURACY
        return Verdict(
            NOT_COMPARABLE if is_kept else WORSE,
            "Mesh and graph are not changed, so several threads can query them simultaneously.",
        )


class GreenSums(Exhibit):
    """Two curves on parallels of a sphere define colors on both sides. Between the curves the exact colors
    are linear in artanh z. Errors at random fragments are in percent of the range, within two mean edges
    of a curve and farther away. Times are per fragment, relative to the direct solution."""

    name = "D1.3"
    title = "vector graphics: a direct solution instead of sums of Green's functions"
    published = (
        "Algorithm 4: each fragment computes its Green's function (Eq. 4.21), and sums it over cells."
    )
    # Per curve: z, the color on its left (north), and the color on its right.
    curves = ((-0.3, 0.2, 0.0), (0.5, 1.0, 0.8))
    count = 400

    def measure(self, run):
        rows = []
        for level in run.pick((3, 4), (3, 4, 5)):
            mesh = run.mesh(f"sphere-{level}")
            points, triangles = surfaces.arrays_of(mesh)
            fragments, direct = timed(lambda mesh=mesh: self.painted(mesh))
            direct /= fragments.GetNumberOfPoints()
            places = vtk_to_numpy(fragments.GetPoints().GetData()).astype(float)
            z = places[:, 2] / np.linalg.norm(places, axis=1)
            away = np.min([np.abs(z - height) for height, *_ in self.curves], axis=0)
            usable = np.flatnonzero(away > SIDES)
            chosen = np.random.default_rng(surfaces.SEED).choice(usable, self.count, replace=False)
            is_near = away[chosen] < 2.0 * surfaces.mean_edge(points, triangles)
            truth = self.truth(z[chosen])
            arrays = (mesh, points, triangles, places[chosen])
            found, sums = timed(lambda arrays=arrays: self.summed(*arrays))
            sums /= self.count
            colors = vtk_to_numpy(fragments.GetPointData().GetArray("Colors"))[chosen]
            rows.append({"vertices": len(points), "time": sums / direct})
            for kind, values in (("direct", colors.ravel()), ("sums", found)):
                errors = np.abs(values - truth)
                rows[-1][kind] = {
                    "near": float(errors[is_near].mean()),
                    "far": float(errors[~is_near].mean()),
                }
        return rows

    def painted(self, mesh):
        """Returns the fragments of vtkPoissonVectorGraphics."""
        points, lines = vtkPoints(), vtkCellArray()
        for height, *_ in self.curves:
            first = points.GetNumberOfPoints()
            for angle in np.linspace(0.0, 2.0 * np.pi, self.count, endpoint=False):
                radius = (1.0 - height**2) ** 0.5
                points.InsertNextPoint(radius * np.cos(angle), radius * np.sin(angle), height)
            lines.InsertNextCell(self.count + 1, [*range(first, first + self.count), first])
        parallels = vtkPolyData()
        parallels.SetPoints(points)
        parallels.SetLines(lines)
        _, left, right = zip(*self.curves)
        for name, colors in (("LeftColor", left), ("RightColor", right)):
            array = numpy_to_vtk(np.array(colors), deep=True)
            array.SetName(name)
            parallels.GetCellData().AddArray(array)
        graphics = vtkdgg.vtkPoissonVectorGraphics()
        graphics.SetInputData(mesh)
        graphics.SetCurveData(parallels)
        graphics.GenerateFragmentsOn()
        vtkdgg.check(graphics)
        return graphics.GetFragments()

    def summed(self, mesh, points, triangles, places):
        """Returns colors by the published algorithm."""
        z = points[:, 2]
        vertices = np.unique(
            np.concatenate([green_sums.beside(triangles, z > height) for height, *_ in self.curves])
        )
        strengths = green_sums.sources(mesh, vertices, self.truth(z[vertices], is_flat=True))
        return green_sums.colors_of(mesh, vertices, *strengths, places, "Localized")

    def truth(self, z, is_flat=False):
        """Returns colors by height; flat ones are those of the nearest curve."""
        (low, above_low, below_low), (high, above_high, below_high) = self.curves
        part = (np.arctanh(z) - np.arctanh(low)) / (np.arctanh(high) - np.arctanh(low))
        part = np.round(part) if is_flat else part
        between = above_low + part * (below_high - above_low)
        return np.where(z > high, above_high, np.where(z > low, between, below_low))

    columns = (
        column("vertices", count_text, "vertices"),
        column("direct solution, within two edges", percent, "direct", "near"),
        column("direct solution, farther", percent, "direct", "far"),
        column("sums as published, within two edges", percent, "sums", "near"),
        column("sums as published, farther", percent, "sums", "far"),
        column("time of sums", digits, "time"),
    )

    def verdict(self, figures):
        last = figures[-1]
        return Verdict(
            BETTER if all(last["direct"][k] < last["sums"][k] for k in ("near", "far")) else WORSE,
            "In sums, a vertex next to a curve has the color of its side of the curve, as if the curve passed "
            "through the vertex. Each fragment needs a separate solution.",
        )


def heat(mesh, source, has_flips):
    """Returns distances by the heat method, with all preparation."""
    prepared = vtkdgg._kernel.Surface(*surfaces.arrays_of(mesh))
    found = vtkdgg._kernel.heat_distance(prepared, [source], intrinsic_delaunay=has_flips)
    return found.point_data["GeodesicDistance"]


class Flips(Exhibit):
    """The heat method with intrinsic flips, and on a mesh that is Delaunay by added vertices. Errors are
    those at the original vertices. The time is that with added vertices relative to that with flips, for
    one source with all preparation."""

    name = "D1.4"
    title = "heat: intrinsic flips instead of added vertices"
    published = "heat on Delaunay meshes with added vertices, whose number is not available."

    def measure(self, run):
        names = ["bumpy-3", "bumpy-3-stretched-2", "bumpy-3-stretched-8"]
        return [
            self.measure_mesh(run, name)
            for name in (*names, *filter(run.has, ("fertility", "blade_aniso")))
        ]

    def measure_mesh(self, run, name):
        mesh = run.mesh(name)
        points, triangles = surfaces.arrays_of(mesh)
        split = surfaces.from_arrays(*DelaunayMesh(points, triangles).arrays())
        row = {"model": name, "vertices": len(points)}
        row["split"] = split.GetNumberOfPoints() / len(points)
        exact = exact_fields(run, name)
        for kind, surface in (("flips", mesh), ("added", split)):
            found, seconds = timed(
                lambda surface=surface, has_flips=kind == "flips": [
                    heat(surface, source, has_flips)[: len(points)] for source in sources_of(mesh)
                ]
            )
            row[kind] = {"seconds": seconds, "error": summary(found, exact, floor_of(mesh))}
        return row

    columns = (
        column("mesh", str, "model"),
        column("vertices", count_text, "vertices"),
        column("vertices of the Delaunay mesh, relative", digits, "split"),
        ratio("time", ("added", "seconds"), ("flips", "seconds"), digits),
        column("error with flips: mean / 99.9 % / max", errors_text, "flips", "error"),
        column("with added vertices", errors_text, "added", "error"),
    )

    def verdict(self, figures):
        ratios = [row["flips"]["error"]["mean"] / row["added"]["error"]["mean"] for row in figures]
        return Verdict(
            NOT_COMPARABLE,
            f"Mean errors with flips are {range_text(ratios)} times those with added vertices, which sample "
            "the surface more densely.",
        )


EXHIBITS = (BothEnds(), Links(), GreenSums(), Flips())
