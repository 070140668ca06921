#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkSpectral.

Usage: summarize_spectral.py RESULT.json [TABLE.md]

Times are medians over the sources of a mesh. The order of an error is the slope of its logarithm
over that of the mean edge, a line fitted to all spheres (least squares).
"""

from benchmark_results import (
    DASH,
    Results,
    bytes_text,
    environment,
    figure,
    first_median,
    first_of,
    folded,
    in_form,
    largest,
    median,
    number,
    peak_text,
    percent,
    quotient_text,
    ratio_text,
    run_as_script,
    size_text,
    slope,
    table,
    tabulate,
    text,
    time_text,
    titled,
)

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


class Run(Results):
    """meshes[mesh][case], peers[mesh][peer][case], spheres[way][level] and splines[sites]."""

    patterns = {
        "meshes": r"Spectral/([^/]+)/(Greens/[A-Za-z]+|[A-Za-z]+)(?:/[0-9]+)?(?:/[a-z]|$)",
        "peers": r"Peer/([^/]+)/([A-Za-z]+)/([A-Za-z]+)(?:/|$)",
        "spheres": r"Convergence/([0-9]+)/([A-Za-z]+)(?:/|$)",
        "splines": r"Splines/([0-9]+)(?:/|$)",
    }

    def key(self, group, match):
        parts = [int(part) if part.isdigit() else part for part in match.groups()]
        return parts[::-1] if group == "spheres" else parts

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
    return slope([(edge, error) for _, edge, error in points])


def factor_table(run):
    def vertices(_, cases):
        return size_text(first_median(cases.values(), "vertices"))

    def of_factor(form, *keys):
        return lambda _, cases: form(*(median(cases.get("Factor"), key) for key in keys))

    def in_blocks(_, cases):
        together, columns = (median(cases.get("Block"), key) for key in ("seconds", "columns"))
        return time_text(None if together is None else together / columns)

    columns = [
        ("mesh", first_of),
        ("vertices", vertices),
        ("factorization", figure("Factor")),
        ("of that, analysis", figure("Factor", "analysis_seconds", time_text)),
        ("entries per vertex", of_factor(quotient_text, "factor_entries", "vertices")),
        ("peak: predicted / measured", of_factor(peak_text, "predicted_bytes", "peak_bytes")),
        ("one more column", figure("Column")),
        ("in blocks of eight, each", in_blocks),
        ("biharmonic column", figure("Biharmonic")),
    ]
    return tabulate(columns, run.meshes.items())


def point_table(run):
    def of_way(key, form):
        return lambda _, way, figures: form(median(figures, key))

    columns = [
        ("mesh", first_of),
        ("Green's function", lambda _, way, figures: WAYS[way]),
        ("a point anywhere", of_way("seconds", time_text)),
        ("with the columns it needs", of_way("first_seconds", time_text)),
        ("radius, mean edges", of_way("radius_in_edges", lambda x: number(x) if x else DASH)),
        ("by another method", lambda *row: number(sum(row[-1].get("other_method", [])))),
    ]
    rows = [
        (mesh, way, cases["Greens/" + way])
        for mesh, cases in run.meshes.items()
        for way in WAYS
        if cases.get("Greens/" + way)
    ]
    return tabulate(columns, rows)


def long_table(run):
    def complete(value):
        return DASH if value is None else ("yes" if value == 1.0 else "no")

    columns = [
        ("mesh", first_of),
        ("eigenpairs", figure("Eigenpairs", "pairs")),
        ("time", figure("Eigenpairs")),
        ("known to be complete", figure("Eigenpairs", "complete", complete)),
        ("earth mover's distance", figure("EarthMovers")),
        ("iterations", figure("EarthMovers", "iterations")),
        ("gap of its bounds, %", figure("EarthMovers", "gap", percent)),
        ("distance / geodesic one", figure("EarthMovers", "per_geodesic", in_form("{:.4f}"))),
    ]
    rows = run.meshes.items()
    return tabulate(columns, [row for row in rows if {"Eigenpairs", "EarthMovers"} & row[1].keys()])


def peer_table(run):
    def to_ours(case, key, our_case):
        def make(mesh, peer, cases):
            mine = "Biharmonic" if our_case == "Column" and peer == "LibiglBiharmonic" else our_case
            ours = run.meshes.get(mesh, {}).get(mine)
            return ratio_text(median(cases[case], key), median(ours, key))

        return make

    def difference(_, peer, cases):
        return text(largest(cases["Column"], "difference"), "{:.1e}")

    columns = [
        ("mesh", first_of),
        ("peer", lambda _, peer, cases: PEERS[peer]),
        ("factorization", figure("Factor")),
        ("/ ours", to_ours("Factor", "seconds", "Factor")),
        ("column", figure("Column")),
        ("/ ours", to_ours("Column", "seconds", "Column")),
        ("memory", figure("Factor", "peak_bytes", bytes_text)),
        ("/ ours", to_ours("Factor", "peak_bytes", "Factor")),
        ("largest difference to ours", difference),
    ]
    rows = [
        (mesh, peer, peers[peer])
        for mesh, peers in run.peers.items()
        for peer in PEERS
        if {"Factor", "Column"} <= peers.get(peer, {}).keys()
    ]
    return tabulate(columns, rows)


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
    def of_sites(key, form):
        return lambda _, figures: form(median(figures, key))

    columns = [
        ("vertices of a sphere", of_sites("vertices", size_text)),
        ("sites of B-splines", lambda sites, _: number(sites)),
        ("error of a solution, %", of_sites("error", percent)),
        ("time", of_sites("seconds", time_text)),
    ]
    return tabulate(columns, sorted(run.splines.items()))


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
