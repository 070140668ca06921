# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences from the thesis that none of its exhibits shows."""

import statistics
import time

import numpy as np
import vtkdgg
from benchmark_results import count_text, digits, number, percent, table
from Published import bidirectional, green_sums
from Published.delaunay_mesh import DelaunayMesh
from vtkdgg.commands.methods import field, heat
from vtkdgg.commands.sizes import floor_of
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from . import surfaces
from .exhibit import BETTER, NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .fields import exact_fields, sources_of, summary
from .tables import column, errors_text, listing, named, vertices_text

ACCURACY = 0.01
SIDES = 1e-3  # within this distance from a curve, flat triangles decide the side of a fragment


class BothEnds(Exhibit):
    """Random pairs of vertices in a graph: vertices settled until the shortest path is known, and how
    often the path that the published search ends with is longer."""

    name = "D1.1"
    title = "paths: A* instead of a search from both ends"
    published = "a search from both ends that stops where they meet first."
    pairs = 60

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
        columns = (
            column("search", str, "name"),
            ("vertices settled, %", lambda row: f"{100.0 * row['settled']:.1f}"),
            ("not the shortest path, %", lambda row: number(100.0 * row["wrong"])),
            ("longer by at most, %", lambda row: percent(row["excess"] if row["wrong"] else None)),
        )
        note = f"{vertices_text(figures['vertices'])}, {self.pairs} pairs, ε = {ACCURACY}."
        return listing(columns, named(figures["searches"]), note)

    def verdict(self, figures):
        found = figures["searches"]
        star, both = found["A*"], found["both ends"]
        published = found["both ends, as published"]
        return Verdict(
            BETTER if star["settled"] < both["settled"] and not star["wrong"] else WORSE,
            f"As published {100.0 * published['wrong']:.0f} % of the paths are not the shortest ones. A* "
            f"settles {digits(both['settled'] / star['settled'])} times fewer vertices than a search from "
            "both ends that is right.",
        )


def longer(pairs, shortest):
    """By which part lengths are longer."""
    return np.array([length for length, _ in pairs]) / shortest - 1.0


class Links(Exhibit):
    """Sources in the middle of random faces: the graph is linked to them and does not change. Times
    are those of a query from a vertex."""

    name = "D1.2"
    title = "points anywhere: links instead of insertion"
    published = "the point is inserted into the triangulation, and the graph is changed around it."
    sources = 10

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        points, triangles = surfaces.arrays_of(mesh)
        start = time.process_time()
        graph = vtkdgg.Graph(mesh, accuracy=ACCURACY)
        built = time.process_time() - start
        faces = np.random.default_rng(surfaces.SEED).choice(len(triangles), self.sources)
        places = points[triangles[faces]].mean(axis=1)
        exact = [field(vtkdgg.vtkExactGeodesicDistance, mesh, place) for place in places.tolist()]
        graph.distance(0)
        graph.distance(places[:1])  # prepares the search
        times = {"vertex": [], "face": []}
        found = []
        for k, place in enumerate(places):
            for kind, source in (("vertex", k), ("face", place[None])):
                start = time.process_time()
                distances = graph.distance(source, correction=False)
                times[kind].append(time.process_time() - start)
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
            ["building the graph anew", f"{figures['build']:.0f}"],
            ["error: mean / 99.9 % / max", errors_text(figures["error"])],
        ]
        return (
            f"{vertices_text(figures['vertices'])}, {self.sources} sources, ε = {ACCURACY}.\n\n"
            + table(["what", "queries from a vertex"], rows)
        )

    def verdict(self, figures):
        kept = figures["error"]["max"] <= ACCURACY
        return Verdict(
            NOT_COMPARABLE if kept else WORSE,
            f"No figures were published. A query from a point in a face takes {figures['query']:.2f} times one from a vertex, and "
            f"the largest error, {percent(figures['error']['max'])} %, is below ε. Nothing is changed, so "
            "that several threads can ask at once.",
        )


class GreenSums(Exhibit):
    """Two curves around a sphere, on parallels, with colours on both sides; between them colours are
    linear in artanh z. Errors are in percent of the range, within two edges of a curve and farther
    away, at random fragments. Times are those of one fragment; the direct solution's is 1."""

    name = "D1.3"
    title = "vector graphics: a direct solution instead of sums of Green's functions"
    published = (
        "Algorithm 4: each fragment takes its Green's function (Eq. 4.21), and sums it over cells."
    )
    # z, and the colors on the left, which is north, and on the right.
    curves = ((-0.3, 0.2, 0.0), (0.5, 1.0, 0.8))
    count = 400

    def measure(self, run):
        rows = []
        for level in run.pick((3, 4), (3, 4, 5)):
            mesh = run.mesh(f"sphere-{level}")
            points, triangles = surfaces.arrays_of(mesh)
            start = time.process_time()
            fragments = self.painted(mesh)
            direct = (time.process_time() - start) / fragments.GetNumberOfPoints()
            places = vtk_to_numpy(fragments.GetPoints().GetData()).astype(float)
            z = places[:, 2] / np.linalg.norm(places, axis=1)
            away = np.min([np.abs(z - height) for height, *_ in self.curves], axis=0)
            usable = np.flatnonzero(away > SIDES)
            chosen = np.random.default_rng(surfaces.SEED).choice(usable, self.count, replace=False)
            is_near = away[chosen] < 2.0 * surfaces.mean_edge(points, triangles)
            truth = self.truth(z[chosen])
            start = time.process_time()
            found = self.summed(mesh, points, triangles, places[chosen])
            sums = (time.process_time() - start) / self.count
            colours = vtk_to_numpy(fragments.GetPointData().GetArray("Colors"))[chosen]
            rows.append({"vertices": len(points), "time": sums / direct})
            for kind, values in (("direct", colours.ravel()), ("sums", found)):
                errors = np.abs(values - truth)
                rows[-1][kind] = {
                    "near": float(errors[is_near].mean()),
                    "far": float(errors[~is_near].mean()),
                }
        return rows

    def painted(self, mesh):
        """Fragments of vtkPoissonVectorGraphics."""
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
        for name, colours in (("LeftColor", left), ("RightColor", right)):
            array = numpy_to_vtk(np.array(colours), deep=True)
            array.SetName(name)
            parallels.GetCellData().AddArray(array)
        graphics = vtkdgg.vtkPoissonVectorGraphics()
        graphics.SetInputData(mesh)
        graphics.SetCurveData(parallels)
        graphics.GenerateFragmentsOn()
        vtkdgg.check(graphics)
        return graphics.GetFragments()

    def summed(self, mesh, points, triangles, places):
        """Colours as published."""
        z = points[:, 2]
        vertices = np.unique(
            np.concatenate([green_sums.beside(triangles, z > height) for height, *_ in self.curves])
        )
        strengths = green_sums.sources(mesh, vertices, self.truth(z[vertices], is_flat=True))
        return green_sums.colours_of(mesh, vertices, *strengths, places, "Localized")

    def truth(self, z, is_flat=False):
        """Colours by height; flat ones are those of the nearest curve."""
        (low, above_low, below_low), (high, above_high, below_high) = self.curves
        part = (np.arctanh(z) - np.arctanh(low)) / (np.arctanh(high) - np.arctanh(low))
        part = np.round(part) if is_flat else part
        between = above_low + part * (below_high - above_low)
        return np.where(z > high, above_high, np.where(z > low, between, below_low))

    def table(self, figures):
        titles = {"direct": "direct solution", "sums": "sums as published"}
        columns = [
            column(
                f"{titles[kind]}, {'within two edges' if where == 'near' else 'farther'}",
                percent,
                kind,
                where,
            )
            for kind in titles
            for where in ("near", "far")
        ]
        first = column("vertices", count_text, "vertices")
        return listing([first, *columns, column("time of sums", digits, "time")], figures)

    def verdict(self, figures):
        last = figures[-1]
        return Verdict(
            BETTER if all(last["direct"][k] < last["sums"][k] for k in ("near", "far")) else WORSE,
            f"At {count_text(last['vertices'])} vertices sums are off by {percent(last['sums']['near'])} % of "
            f"the range next to curves and {percent(last['sums']['far'])} % elsewhere, the direct solution by "
            f"{percent(last['direct']['near'])} and {percent(last['direct']['far'])} %: vertices next to a curve "
            "have the colour of its side, as if the curve went through them. Each fragment needs a solution of its "
            f"own, which takes {digits(last['time'])} times as long.",
        )


class Flips(Exhibit):
    """The heat method with intrinsic flips, and on a mesh with the vertices that make its triangles those
    of Delaunay. Errors are those at the vertices of the mesh itself, beside exact distances; times, of
    all that one source takes, are those with added vertices by those with flips."""

    name = "D1.4"
    title = "heat: intrinsic flips instead of added vertices"
    published = "heat on Delaunay meshes, which have more vertices; their number is not at hand."

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
        with_flips = vtkdgg.vtkHeatGeodesicDistance  # flips edges by default
        for kind, surface, make in (("flips", mesh, with_flips), ("added", split, heat)):
            start = time.process_time()
            found = [
                field(make, surface, source)[: len(points)] for source in sources_of(mesh)
            ]
            seconds = time.process_time() - start
            row[kind] = {"seconds": seconds, "error": summary(found, exact, floor_of(mesh))}
        return row

    def table(self, figures):
        columns = (
            column("mesh", str, "model"),
            column("vertices", count_text, "vertices"),
            column("vertices of the Delaunay mesh, times as many", digits, "split"),
            ("time", lambda row: digits(row["added"]["seconds"] / row["flips"]["seconds"])),
            column("error with flips: mean / 99.9 % / max", errors_text, "flips", "error"),
            column("with added vertices", errors_text, "added", "error"),
        )
        return listing(columns, figures)

    def verdict(self, figures):
        added = [row["split"] for row in figures]
        ratios = [row["flips"]["error"]["mean"] / row["added"]["error"]["mean"] for row in figures]
        return Verdict(
            NOT_COMPARABLE,
            f"A Delaunay mesh has {digits(min(added))} to {digits(max(added))} times as many vertices. Mean errors "
            f"with flips are {digits(min(ratios))} to {digits(max(ratios))} times those with it, which samples "
            "the surface more densely.",
        )


EXHIBITS = (BothEnds(), Links(), GreenSums(), Flips())
