#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkSpectral.

Usage: summarize_spectral.py RESULT.json [TABLE.md]

Times are medians over the sources of a mesh.
"""

from benchmark_results import (
    DASH,
    Results,
    bytes_text,
    environment,
    figure,
    first_median,
    first_of,
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

class Run(Results):
    """meshes[mesh][case] and peers[mesh][peer][case]."""

    patterns = {
        "meshes": r"Spectral/([^/]+)/(Greens/[A-Za-z]+|[A-Za-z]+)(?:/[0-9]+)?(?:/[a-z]|$)",
        "peers": r"Peer/([^/]+)/([A-Za-z]+)/([A-Za-z]+)(?:/|$)",
    }



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


def summarize(path):
    run = Run(path)
    parts = [f"CPU seconds on one thread ({environment(run.context)}).\n"]
    titles = {
        "Factorizations and columns": factor_table,
        "Green's functions of arbitrary points": point_table,
        "Eigenpairs, earth mover's distance of two vertices": long_table,
        "Peers": peer_table,
    }
    return "\n".join(parts + titled(run, titles))


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
