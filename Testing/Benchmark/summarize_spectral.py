#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkSpectral.

Usage: summarize_spectral.py RESULT.json [TABLE.md]

Times are medians over the sources of a mesh. The order of an error is the slope of its logarithm
over that of the mean edge, a line fitted to all spheres (least squares).
"""

import math
import re

from benchmark_results import (
    DASH,
    bytes_text,
    collect,
    environment,
    first_median,
    folded,
    largest,
    load,
    median,
    number,
    peak_text,
    percent,
    quotient_text,
    ratio_text,
    run_as_script,
    size_text,
    table,
    text,
    time_text,
    titled,
)

MESH = re.compile(
    r"^Spectral/(?P<mesh>[^/]+)/(?P<case>Greens/[A-Za-z]+|[A-Za-z]+)(?:/[0-9]+)?(?:/[a-z]|$)"
)
PEER = re.compile(r"^Peer/(?P<mesh>[^/]+)/(?P<peer>[A-Za-z]+)/(?P<case>[A-Za-z]+)(?:/|$)")
SPHERE = re.compile(r"^Convergence/(?P<level>[0-9]+)/(?P<way>[A-Za-z]+)(?:/|$)")
SPLINES = re.compile(r"^Splines/(?P<sites>[0-9]+)(?:/|$)")
WAYS = {
    "SingularitySubtraction": "singularity subtraction",
    "RegularPart": "regular parts interpolated",
    "Localized": "localized",
    "Interpolated": "interpolated",
    "Vertex": "vertex",
}
PEERS = {
    "Cholmod": "CHOLMOD",
    "Libigl": "libigl",
    "LibiglBiharmonic": "libigl, bi-Laplacian",
    "Heat": "heat method (CGAL), two matrices",
}
ERRORS = {
    "error_local": "within 0.2",
    "error_global": "everywhere",
    "error_largest": "largest",
}


class Run:
    """meshes[mesh][case], peers[mesh][peer][case], spheres[way][level] and splines[sites]:
    {figure: [values]}."""

    def __init__(self, path):
        self.context, results = load(path)
        self.meshes = {}
        self.peers = {}
        self.spheres = {}
        self.splines = {}
        for entry in results:
            figures = self.figures(entry["name"])
            if figures is not None:
                collect(entry, figures)

    def figures(self, name):
        """Where the figures of a result of this name go; None when it is not one of ours."""
        match = MESH.match(name)
        if match:
            return self.meshes.setdefault(match["mesh"], {}).setdefault(match["case"], {})
        match = PEER.match(name)
        if match:
            cases = self.peers.setdefault(match["mesh"], {}).setdefault(match["peer"], {})
            return cases.setdefault(match["case"], {})
        match = SPHERE.match(name)
        if match:
            levels = self.spheres.setdefault(match["way"], {})
            return levels.setdefault(int(match["level"]), {})
        match = SPLINES.match(name)
        if match:
            return self.splines.setdefault(int(match["sites"]), {})
        return None

    def curve(self, way, error):
        """Vertices, mean edge and error on all spheres, coarse ones first."""
        levels = self.spheres.get(way, {})
        points = [
            tuple(median(levels[level], key) for key in ("vertices", "mean_edge", error))
            for level in sorted(levels)
        ]
        return [point for point in points if None not in point]


def order(points):
    """Slope of the logarithms of errors over those of mean edges; None for less than two."""
    if len(points) < 2:
        return None
    x = [math.log(edge) for _, edge, _ in points]
    y = [math.log(error) for _, _, error in points]
    x_mean, y_mean = sum(x) / len(x), sum(y) / len(y)
    products = sum((a - x_mean) * (b - y_mean) for a, b in zip(x, y))
    return products / sum((a - x_mean) ** 2 for a in x)


def seconds(cases, case):
    return median(cases.get(case), "seconds")


def factor_table(run):
    rows = []
    for mesh, cases in run.meshes.items():
        factor, block = cases.get("Factor"), cases.get("Block")
        entries, vertices = median(factor, "factor_entries"), median(factor, "vertices")
        together, columns = seconds(cases, "Block"), median(block, "columns")
        predicted, measured = (median(factor, key) for key in ("predicted_bytes", "peak_bytes"))
        rows.append(
            [
                mesh,
                size_text(first_median(cases.values(), "vertices")),
                time_text(seconds(cases, "Factor")),
                time_text(median(factor, "analysis_seconds")),
                quotient_text(entries, vertices),
                peak_text(predicted, measured),
                time_text(seconds(cases, "Column")),
                time_text(None if together is None else together / columns),
                time_text(seconds(cases, "Biharmonic")),
            ]
        )
    header = [
        "mesh",
        "vertices",
        "factorization",
        "of that, analysis",
        "entries per vertex",
        "peak: predicted / measured",
        "one more column",
        "in blocks of eight, each",
        "biharmonic column",
    ]
    return table(header, rows)


def point_table(run):
    rows = []
    for mesh, cases in run.meshes.items():
        for way, title in WAYS.items():
            figures = cases.get("Greens/" + way)
            if figures:
                radius = median(figures, "radius_in_edges")
                rows.append(
                    [
                        mesh,
                        title,
                        time_text(median(figures, "seconds")),
                        time_text(median(figures, "first_seconds")),
                        number(radius) if radius else DASH,
                        number(sum(figures.get("other_method", []))),
                    ]
                )
    header = [
        "mesh",
        "Green's function",
        "a point anywhere",
        "with the columns it needs",
        "radius, mean edges",
        "by another method",
    ]
    return table(header, rows)


def long_table(run):
    rows = []
    for mesh, cases in run.meshes.items():
        pairs, movers = cases.get("Eigenpairs"), cases.get("EarthMovers")
        if pairs or movers:
            complete = median(pairs, "complete")
            rows.append(
                [
                    mesh,
                    number(median(pairs, "pairs")),
                    time_text(median(pairs, "seconds")),
                    DASH if complete is None else ("yes" if complete == 1.0 else "no"),
                    time_text(median(movers, "seconds")),
                    number(median(movers, "iterations")),
                    percent(median(movers, "gap")),
                    text(median(movers, "per_geodesic"), "{:.4f}"),
                ]
            )
    header = [
        "mesh",
        "eigenpairs",
        "time",
        "known to be complete",
        "earth mover's distance",
        "iterations",
        "gap of its bounds, %",
        "distance / geodesic one",
    ]
    return table(header, rows)


def peer_table(run):
    rows = []
    for mesh, peers in run.peers.items():
        ours = run.meshes.get(mesh, {})
        memory = median(ours.get("Factor"), "peak_bytes")
        for peer, title in PEERS.items():
            cases = peers.get(peer, {})
            factor, column = cases.get("Factor"), cases.get("Column")
            if not factor or not column:
                continue
            is_biharmonic = peer == "LibiglBiharmonic"
            mine = seconds(ours, "Biharmonic" if is_biharmonic else "Column")
            taken = median(factor, "peak_bytes")
            difference = largest(column, "difference")
            rows.append(
                [
                    mesh,
                    title,
                    time_text(median(factor, "seconds")),
                    ratio_text(median(factor, "seconds"), seconds(ours, "Factor")),
                    time_text(median(column, "seconds")),
                    ratio_text(median(column, "seconds"), mine),
                    bytes_text(taken),
                    ratio_text(taken, memory),
                    text(difference, "{:.1e}"),
                ]
            )
    header = [
        "mesh",
        "peer",
        "factorization",
        "/ ours",
        "column",
        "/ ours",
        "memory",
        "/ ours",
        "largest difference to ours",
    ]
    return table(header, rows)


def convergence_table(run):
    ways = [way for way in WAYS if way in run.spheres]
    rows = []
    for error, title in ERRORS.items():
        curves = {way: run.curve(way, error) for way in ways}
        sizes = sorted({vertices for points in curves.values() for vertices, _, _ in points})
        for size in sizes:
            row = [title, f"{size:.0f}"]
            for way in ways:
                found = [value for vertices, _, value in curves[way] if vertices == size]
                row.append(f"{found[0]:.1e}" if found else DASH)
            rows.append(row)
        if sizes:
            rows.append([title, "order"] + [text(order(curves[way]), "{:.2f}") for way in ways])
    return table(["error", "vertices"] + [WAYS[way] for way in ways], rows)


def spline_table(run):
    rows = []
    for sites, figures in sorted(run.splines.items()):
        error, time = median(figures, "error"), median(figures, "seconds")
        rows.append([size_text(median(figures, "vertices")), number(sites), percent(error), time_text(time)])
    header = ["vertices of a sphere", "sites of B-splines", "error of a solution, %", "time"]
    return table(header, rows)


def fallback_text(run):
    """Something to say about poles on spheres where another method was used."""
    count = sum(
        sum(figures.get("other_method", []))
        for levels in run.spheres.values()
        for figures in levels.values()
    )
    return f"\nAt {count:.0f} poles another method was used.\n" if count else ""


def summarize(path):
    run = Run(path)
    parts = [f"CPU seconds on one thread ({environment(run.context)}).\n"]
    titles = {
        "Factorizations and columns": factor_table,
        "Green's functions of points anywhere": point_table,
        "Eigenpairs, earth mover's distance of two vertices": long_table,
        "Harmonic B-splines": spline_table,
        "Peers": peer_table,
    }
    parts += titled(run, titles)
    made = convergence_table(run)
    if made:
        made += fallback_text(run)
    parts += folded("Errors on spheres of radius 1", made)
    return "\n".join(parts)


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
