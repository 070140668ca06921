# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost and errors of Python packages that compute geodesics, vtkDGG beside them.

Usage: measure_peers.py OUT.json OUT.md [--name=value ...] [MESH ...]

  --generated=bumpy-5,...,bumpy-8   generated surfaces: spheres with bumps, 10K to 655K vertices
  --limit=200   CPU seconds after which a measurement is ended; no measurement starts if the time per
                vertex on a smaller mesh predicts more
  --cores=1     number of processor cores for each package
  --methods=    parts of the names of methods to measure (default: all that are installed)

Each method carries out each task in a process of its own. Times are medians of as many calls as fit
into ten seconds. Errors are relative to the exact distances of vtkDGG.
"""

import importlib.metadata
import os
import tempfile

import modes
import numpy as np
from exhibits import surfaces
from measure_alone import measure_alone
from peers import METHODS
from tables import (
    bytes_text,
    column,
    count_text,
    figure,
    folded,
    listing,
    percent,
    time_text,
    titled,
)
from vtkdgg.compat.pygeodesic.geodesic import PyGeodesicAlgorithmExact

GENERATED = ("bumpy-5", "bumpy-6", "bumpy-7", "bumpy-8")
SOURCES = 100
ROWS = 5  # sources whose exact distances are computed one by one
TASKS = {
    "one": "Distances from one vertex to all",
    "many": f"Distances from the nearest of {SOURCES} vertices to all",
    "matrix": f"Matrix of {SOURCES} x {SOURCES} distances",
    "path": "Paths between two vertices",
}


def case_of(points, triangles):
    """Returns the arrays of a mesh, sources, and exact distances from them."""
    used = np.unique(triangles)
    draw = np.random.default_rng(surfaces.SEED)
    sources = draw.choice(used, min(SOURCES, len(used)), replace=False)
    exact = PyGeodesicAlgorithmExact(points, triangles)
    return {
        "points": points,
        "triangles": triangles,
        "sources": sources,
        "rows": np.stack([exact.geodesicDistances([s])[0] for s in sources[:ROWS]]),
        "nearest": exact.geodesicDistances(sources)[0],
    }


def version_of(package):
    """Returns the version of a package; None if it is not installed."""
    try:
        return importlib.metadata.version(package)
    except importlib.metadata.PackageNotFoundError:
        return None


def chosen_methods(parts):
    """Returns the installed methods whose name contains one of the parts."""
    return {
        name: method
        for name, method in METHODS.items()
        if any(part in name for part in parts or ("",)) and version_of(method.package)
    }


def measure_mesh(path, vertices, methods, limit, paces):
    """Returns the figures of the methods for each task. `paces` contains seconds per vertex on
    smaller meshes, a lower bound for larger ones, and is updated."""
    found = {}
    for name, method in methods.items():
        for task in method.tasks:
            if paces.get((name, task), 0.0) * vertices > limit:
                figures = {"failed": f"not measured, since a smaller mesh predicts > {limit} s"}
            else:
                figures = measure_alone(name, task, path, limit)
                if "failed" not in figures:
                    paces[name, task] = (figures["prepare"] + figures["query"]) / vertices
                elif figures["failed"].startswith(">"):
                    paces[name, task] = limit / vertices
            outcome = figures.get("failed") or time_text(figures["query"])
            print(f"  {name}, {task}: {outcome}", flush=True)
            found.setdefault(name, {})[task] = figures
    return found


def measure(options):
    """Yields the versions of the packages and the figures of all meshes so far, after each mesh.
    Small meshes come first."""
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: options.cores])
    methods = chosen_methods(options.methods)
    versions = {method.package: version_of(method.package) for method in methods.values()}
    meshes, paces = {}, {}
    arrays = map(modes.open_arrays, (*options.generated, *options.meshes))
    for title, points, triangles in sorted(arrays, key=lambda mesh: len(mesh[1])):
        print(f"{title}: {len(points)} vertices", flush=True)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "case.npz")
            np.savez(path, **case_of(points, triangles))
            methods_found = measure_mesh(path, len(points), methods, options.limit, paces)
        meshes[title] = {"vertices": len(points), "methods": methods_found}
        yield {"versions": versions, "cores": options.cores, "meshes": meshes}


class Notes:
    """Numbered reasons for missing figures."""

    def __init__(self):
        self.reasons = {}

    def mark(self, reason):
        """Returns the text of a cell."""
        if reason.startswith(">"):
            return reason
        words = ("crashed", "not measured")
        short = next((word for word in words if reason.startswith(word)), "refused")
        number = self.reasons.setdefault(reason, len(self.reasons) + 1)
        return f"{short} ({number})"

    def text(self):
        """Returns one line per reason."""
        return "".join(f"({number}) {reason}.\n\n" for reason, number in self.reasons.items())


def errors_text(figures):
    """Returns the mean and the largest error in percent, and the number of missing values."""
    errors = figures.get("error")
    if errors is None:
        return None
    missed = f", {errors['missed']} unreached" if errors["missed"] else ""
    return f"{percent(errors['mean'])} / {percent(errors['max'])}{missed}"


def tables(results):
    """Returns the tables of all tasks: a row per method, a column per mesh."""
    notes, rows, meshes = Notes(), {}, results["meshes"]
    for title, mesh in meshes.items():
        for name, tasks in mesh["methods"].items():
            rows.setdefault(name, {"name": name})[title] = tasks

    def times_text(figures):
        if "failed" in figures:
            return notes.mark(figures["failed"])
        return f"{time_text(figures['prepare'])} / {time_text(figures['query'])}"

    def by_mesh(task, form):
        columns = [column("method", str, "name")]
        for title, mesh in meshes.items():
            header = f"{title} ({count_text(mesh['vertices'])})"
            columns.append(column(header, lambda figures: form(figures) or "–", title, task))
        measured = [row for row in rows.values() if any(figure(row, m, task) for m in meshes)]
        return listing(columns, measured)

    made, memory = {}, {}
    for task, title in TASKS.items():
        made[f"{title}: preparation / query"] = by_mesh(task, times_text)
        made[f"{title}: mean / largest error, %"] = by_mesh(task, errors_text)
        memory[title] = by_mesh(task, lambda found: bytes_text(found.get("memory")))
    most = {f"{TASKS['one']}: peak memory above the mesh": memory.pop(TASKS["one"])}
    versions = ", ".join(f"{name} {version}" for name, version in results["versions"].items())
    cores = f"{results['cores']} core" + ("s" if results["cores"] > 1 else "")
    note = f"CPU seconds, {cores} ({versions}).\n\n"
    rest = folded("Peak memory of the other tasks", titled(memory))
    return note + titled({**made, **most}) + "\n" + notes.text() + rest


def parse(arguments=None):
    """Returns the options of a command line."""
    return modes.parse(__doc__, arguments, generated=GENERATED, limit=200, cores=1, methods=())


if __name__ == "__main__":
    given = parse()
    for results_so_far in measure(given):
        modes.write(given, results_so_far, tables(results_so_far))
