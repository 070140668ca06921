# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distance fields: all methods side by side, maps of errors, levels of detail."""

import functools
import os
import shutil
import time

import numpy as np
import vtkdgg
from tables import (
    column,
    count_text,
    errors_text,
    listing,
    named,
    percent,
    range_text,
    ratio_text,
    short,
    tenths,
    vertices_text,
)
from vtkdgg.commands import compare_methods, places
from vtkdgg.commands.measured import Errors
from vtkdgg.commands.methods import methods
from vtkdgg.commands.sizes import floor_of

from . import surfaces
from .exhibit import NOT_COMPARABLE, Exhibit, Verdict, judged, most_frequent

SOURCES = 5
STEPS = 10  # steps of the variational heat method
PART = 0.55  # size of a picture on the screen, relative


def sources_of(mesh, count=SOURCES):
    """Returns vertices spread evenly over the list of vertices that have faces."""
    used = np.unique(surfaces.arrays_of(mesh)[1])
    return [int(used[len(used) * (2 * k + 1) // (2 * count)]) for k in range(count)]


def exact_fields(run, name, count=SOURCES):
    """Returns exact distances from the sources of a mesh of the run."""

    def make():
        mesh = run.mesh(name)
        return [vtkdgg.distance(mesh, source) for source in sources_of(mesh, count)]

    return run.once(("exact", name, count), make)


def summary(approximate, exact, floor=0.0):
    """Returns mean, 99.9th percentile and maximum of absolute relative errors over all sources, and
    the number of unreached vertices that have an exact distance."""
    found = [Errors(a, e, floor) for a, e in zip(approximate, exact)]
    sizes = [
        np.abs(errors.signed[np.isfinite(a) & (e > floor)])
        for errors, a, e in zip(found, approximate, exact)
    ]
    sizes = np.concatenate(sizes)
    missed = sum(int((np.isfinite(e) & ~np.isfinite(a)).sum()) for a, e in zip(approximate, exact))
    return {
        "mean": float(sizes.mean()),
        "p999": float(np.percentile(sizes, 99.9)),
        "max": float(sizes.max()),
        "missed": missed,
    }


def summary_of(run, name, make):
    """Returns the errors of a function of a source on a mesh of the run."""
    mesh = run.mesh(name)
    found = [make(source) for source in sources_of(mesh)]
    return summary(found, exact_fields(run, name), floor_of(mesh))


def timed(function):
    """Returns the result of a function, and its CPU time."""
    start = time.process_time()
    result = function()
    return result, time.process_time() - start


def graph_figures(run, name, **options):
    """Returns degree, CPU times and errors of a graph of a mesh of the run."""
    mesh = run.mesh(name)
    graph, built = timed(lambda: vtkdgg.Graph(mesh, **options))
    graph.distance(sources_of(mesh)[0], correction=False)  # prepares the search
    times = []

    def query(source):
        distances, seconds = timed(lambda: graph.distance(source, correction=False))
        times.append(seconds)
        return distances

    return {
        "degree": graph.degree,
        "build": built,
        "error": summary_of(run, name, query),
        "query": float(np.median(times)),
        "corrected": summary_of(run, name, graph.distance),
    }


def variational_heat(run, name, source, exact):
    """Returns the errors of the variational heat method by title; BenchmarkPublished computes the
    distances."""
    folder = os.path.join(run.folder, f"heat-{name}")
    os.makedirs(folder, exist_ok=True)
    options = (f"--steps={STEPS}", f"--vertex={source}", f"--fields={folder}")
    run.program("BenchmarkPublished", "--parts=Heat", *options, run.file(name))
    titles = {"Direct": "variational heat", "Delaunay": "variational heat, Delaunay"}
    return {
        title: Errors(
            np.fromfile(os.path.join(folder, f"{triangles}-{STEPS}.raw")),
            exact,
            floor_of(run.mesh(name)),
        )
        for triangles, title in titles.items()
    }


class Maps(Exhibit):
    """Errors of all methods from one source, the point farthest from the center of the surface.
    `run.sh compare MESH` draws this picture for any mesh, without the variational heat method."""

    name = "F1.1"
    title = "distances by several methods"
    also = {
        "F3.14": "maps and histograms of errors",
        "F5.2": "anisotropic triangles, direct construction",
    }
    published = (
        "pictures of distances and maps of errors of several methods (F1.1), of DGG and its rivals with "
        "histograms (F3.14), and of the direct construction, heat and its variational form (F5.2)."
    )
    accuracy = 0.01
    blade = "blade_aniso"  # model that appears as a strip in a picture

    def models(self, run):
        """Returns the names of meshes and, for meshes with a picture, of exhibits."""
        first = (run.scans() or ["bumpy-5"])[-1] if run.full else "bumpy-5"
        found = {
            first: "F1.1",
            "bunny" if run.has("bunny") else "torus-100": "F3.14",
            "bumpy-5-stretched-8": "F5.2",
        }
        return {**found, **({self.blade: None} if run.has(self.blade) else {})}

    def measure(self, run):
        return [self.errors(run, *model) for model in self.models(run).items()]

    def errors(self, run, name, exhibit):
        """Returns the errors of all methods on one mesh, and draws the picture of an exhibit."""
        mesh = run.mesh(name)
        source = places.far_point(mesh)
        exact, measured = compare_methods.measure(mesh, source, self.accuracy)
        measured.update(variational_heat(run, name, source, exact))
        picture = f"{run.folder}/{exhibit}.png"  # copied on request
        if exhibit:
            compare_methods.save(picture, mesh, mesh.GetPoint(source), measured, PART)
        return {
            "model": name,
            "exhibit": exhibit,
            "picture": picture,
            "vertices": mesh.GetNumberOfPoints(),
            "methods": {
                title: {"mean": e.mean, "p999": e.percentile, "max": e.largest}
                for title, e in measured.items()
            },
        }

    def note(self, figures):
        return f"ε = {self.accuracy}; {STEPS} steps of the variational heat method."

    def table(self, figures):
        columns = [column("error: mean / 99.9 % / max", str, "name")]
        for found in figures:
            title = f"{found['model']}, {vertices_text(found['vertices'])}"
            columns.append(column(title, errors_text, found["model"]))
        rows = {
            title: {found["model"]: found["methods"][title] for found in figures}
            for title in figures[0]["methods"]
        }
        return listing(columns, named(rows), self.note(figures))

    def pictures(self, figures):
        return {
            found["exhibit"]: functools.partial(shutil.copyfile, found["picture"])
            for found in figures
            if found["exhibit"]
        }

    def verdict(self, figures):
        methods_of = [found["methods"] for found in figures]
        gain = ratio_text(methods_of[0]["heat"]["mean"], methods_of[0]["graph, corrected"]["mean"])
        largest = max(found["graph"]["max"] for found in methods_of)
        return Verdict(
            NOT_COMPARABLE,
            f"On {figures[0]['model']} the mean error of heat is {gain} that of the corrected graph. The "
            f"error of the graph is at most {percent(largest)} %, below ε. Other methods have no bound, and "
            "their means hide large errors.",
        )


class LevelsOfDetail(Exhibit):
    """Mean errors of all methods on one surface at several resolutions, relative to exact distances on
    the same mesh."""

    name = "F3.16"
    title = "levels of detail"
    published = "errors on one model at several levels of detail, as maps."
    accuracy = 0.01

    def measure(self, run):
        levels = {}
        for level in run.pick((3, 4, 5), (3, 4, 5, 6)):
            name = f"bumpy-{level}"
            mesh = run.mesh(name)
            levels[mesh.GetNumberOfPoints()] = {
                title: summary_of(run, name, distances)
                for title, distances in methods(mesh, self.accuracy).items()
            }
        return levels

    def table(self, figures):
        columns = [column(title, percent, title, "mean") for title in next(iter(figures.values()))]
        columns.insert(0, column("vertices", lambda size: count_text(int(size)), "name"))
        return listing(columns, named(figures), "Values in percent; ε = 0.01.")

    def verdict(self, figures):
        means = [found["graph, published rule"]["mean"] for found in figures.values()]
        return Verdict(
            NOT_COMPARABLE,
            f"The mean error of the published rule is {range_text(means, percent)} % on all levels.",
        )


class Accuracy(Exhibit):
    """Errors at two accuracies, on well-shaped and on stretched triangles."""

    name = "F3.8"
    title = "accuracy on well-shaped and stretched triangles"
    published = (
        "mean error 0.21 % at ε = 0.1 %; 2.03 % on badly shaped triangles at ε = 1 %. Table 3.4 has "
        "0.32 % at ε = 1 % on a bunny."
    )
    # Accuracy, shape of triangles, published mean error.
    cases = ((0.001, "", 0.0021), (0.01, "", 0.0032), (0.01, "-stretched-8", 0.0203))
    columns = (
        column("ε", short, "accuracy"),
        column("anisotropy", tenths, "tau"),
        column("published mean, %", percent, "published"),
        column("OneRelay", errors_text, "OneRelay"),
        column("Indirect", errors_text, "Indirect"),
        column("Guaranteed", errors_text, "Guaranteed"),
        column("Guaranteed, corrected", errors_text, "corrected"),
    )

    def measure(self, run):
        base = run.pick("bumpy-4", "bumpy-5")
        rows = []
        for accuracy, stretch, published in self.cases:
            name = base + stretch
            tau = surfaces.anisotropy(*surfaces.arrays_of(run.mesh(name)))
            row = {"accuracy": accuracy, "published": published, "tau": tau}
            for rule in ("OneRelay", "Indirect", "Guaranteed"):
                found = graph_figures(run, name, accuracy=accuracy, construction=rule)
                row.update({rule: found["error"], "corrected": found["corrected"]})
            rows.append(row)
        return rows

    def verdict(self, figures):
        return Verdict(
            most_frequent([judged(row["Guaranteed"]["mean"], row["published"]) for row in figures]),
            "With our rule, which bounds the largest error, the mean error is a small fraction of ε, also on "
            "stretched triangles. The first published value, 0.21 % at ε = 0.1 %, contradicts the others. It "
            "may refer to ε = 1 %, where OneRelay, the published direct rule, has this error.",
        )


EXHIBITS = (Maps(), LevelsOfDetail(), Accuracy())
