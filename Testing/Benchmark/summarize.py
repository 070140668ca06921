#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) of the results of a benchmark program.

Usage: summarize.py RESULT.json [TABLE.md]

Times are medians over the sources of a mesh. The mean error and the 99.9th percentile are means over
the sources, the maximum is the largest of all. The excess of a path is its length relative to that
of the shortest path, minus 1. Exponents of growth are slopes of log(figure) over log(vertices).
"""

import sys

from tables import (
    DASH,
    bytes_text,
    column,
    count_text,
    digits,
    errors_text,
    figure,
    folded,
    gain_text,
    hundredths,
    joined,
    listing,
    load,
    number,
    percent,
    ratio,
    ratio_text,
    rows_of,
    significant,
    slope,
    tenths,
    time_text,
    titled,
)

PATTERNS = {
    "exact": r"Exact/(?P<mesh>[^/]+)/(?P<case>SetUp|T|VTK|CGAL)(?:/|$)",
    "growth": r"Growth/(?P<mesh>[^/]+)/(?P<case>T)(?:/|$)",
    "graph": r"Graph/(?P<mesh>[^/]+)/(?P<rule>[^/]+)/(?P<parameter>[^/]+)/(?P<case>[A-Za-z]+)(?:/|$)",
    "peer": r"Peer/(?P<mesh>[^/]+)/(?P<peer>[A-Za-z]+)/(?P<case>[A-Za-z]+)(?:/|$)",
    "path": r"Path/(?P<mesh>[^/]+)/(?P<case>[A-Za-z]+)(?:/|$)",
    "cells": r"Cells/(?P<mesh>[^/]+)/(?P<case>[A-Za-z]+)(?:/|$)",
    "matrix": r"Matrix/(?P<mesh>[^/]+)/(?P<case>Update)(?:/|$)",
    "spectral": r"Spectral/(?P<mesh>[^/]+)/(?P<case>Greens/[A-Za-z]+|[A-Za-z]+)(?:/|$)",
}
PEERS = {
    "Exact": "exact solver of vtkDGG",
    "Heat": "heat method",
    "Marching": "fast marching",
    "HeatDirect": "heat method (CGAL)",
    "HeatDelaunay": "heat method, intrinsic Delaunay (CGAL)",
    "CGAL": "CGAL exact",
    "VTK": "vtkDijkstraGraphGeodesicPath",
}
SOLVERS = {
    "Cholmod": "CHOLMOD",
    "Libigl": "libigl",
    "LibiglBiharmonic": "libigl, bi-Laplacian",
    "Heat": "heat method (CGAL), two matrices",
}
WAYS = {
    "SingularitySubtraction": "singularity subtraction",
    "RegularPart": "regular parts interpolated",
    "Localized": "localized",
    "Interpolated": "interpolated",
    "Vertex": "vertex",
}
PATHS = {"Straight": "straightened", "Default": "default"}
MESH = column("mesh", str, "mesh")


def time(title, case, key="seconds"):
    return column(title, time_text, case, key)


def vertices(case):
    return column("vertices", count_text, case, "vertices")


def with_case(rows, *cases):
    """Returns the rows in which one of these cases was measured."""
    return [row for row in rows if any(case in row for case in cases)]


def true_text(value):
    return "yes" if value == 1.0 else "NO"


def exact_tables(run):
    rows = with_case(run["exact"], "T")
    peers = [peer for peer in ("CGAL", "VTK") if with_case(rows, peer)]

    def peer_text(row, peer):
        seconds = figure(row, peer, "seconds")
        if seconds is None:
            return DASH
        return f"{seconds / row['T']['seconds']:.3g}x ({time_text(seconds)})"

    windows = column("windows", count_text, "T", "windows")
    times = [MESH, vertices("T"), time("engine T", "T"), windows]
    times += [(PEERS[peer], lambda row, peer=peer: peer_text(row, peer)) for peer in peers]
    others = [MESH, column("memory: our mesh", number, "SetUp", "mesh_bytes_per_vertex")]
    for case, title in {"T": "engine T", "CGAL": PEERS["CGAL"]}.items():
        others.append(column(title, number, case, "heap_bytes_per_vertex"))
    others += [
        column(f"error of {PEERS[peer]}: mean / max", joined(digits, "mean", "max"), peer, "error")
        for peer in peers
    ]
    return {
        "Exact distance from one vertex to all (peers: times engine T)": listing(times, rows),
        "Peak memory, bytes per vertex above the loaded mesh; relative errors": listing(others, rows),
        "Growth": growth_table(run["growth"]),
    }


def growth_table(rows):
    columns = (
        MESH,
        column("vertices", number, "T", "vertices"),
        time("engine T", "T"),
        ratio("windows per vertex", ("T", "windows"), ("T", "vertices"), number),
        ratio("time per window", ("T", "seconds"), ("T", "windows"), lambda x: f"{1e9 * x:.0f} ns"),
        column("peak B/vertex", number, "T", "heap_bytes_per_vertex"),
    )
    powers = [
        slope([(row["T"]["vertices"], row["T"][key]) for row in rows])
        for key in ("seconds", "windows")
    ]
    note = "" if None in powers else "Time grows as n^{:.2f}, windows as n^{:.2f}.".format(*powers)
    return listing(columns, rows, note)


def title_of(row):
    return f"{row['rule']}, {'K' if row['rule'] == 'SVG' else 'ε'} = {row['parameter']}"


def speed_up(title, case):
    """Returns the column of what threads gain: wall-clock times, which other load affects equally."""

    def cell(row):
        times = (figure(row, name, "wall_seconds") for name in (case, "Parallel" + case))
        threads = figure(row, "Parallel" + case, "threads")
        return DASH if threads is None else f"{ratio_text(*times)} on {threads:.0f}"

    return title, cell


SIZES = (
    ("graph", title_of),
    column("degree", "{0[degree_mean]:.1f} ± {0[degree_deviation]:.1f}", "Build"),
    column("windows per vertex", number, "Build", "windows_per_vertex"),
    column("bytes per edge", tenths, "Build", "bytes_per_edge"),
    time("build", "Build"),
    ratio("per vertex", ("Build", "seconds"), ("Build", "vertices"), lambda x: f"{1e6 * x:.1f} µs"),
    column("error: mean / 99.9 % / max", errors_text, "Certified", "error"),
    column("corrected", errors_text, "Corrected", "error"),
    time("query", "Corrected"),
    column("queue entries per vertex", hundredths, "Corrected", "pops_per_vertex"),
)
BUILDS = (
    ("graph", title_of),
    speed_up("build on threads", "Build"),
    column("same bits", true_text, "ParallelBuild", "same_bits"),
    column("peak bytes per edge", tenths, "Memory", "peak_bytes_per_edge"),
    column("the system's peak", tenths, "Memory", "resident_bytes_per_edge"),
    time("estimate", "Estimate"),
    column("edges: estimated / built", hundredths, "Estimate", "edges_ratio"),
    column("memory: estimated / peak", hundredths, "Estimate", "peak_ratio"),
)
QUERIES = (
    ("graph", title_of),
    time("cache", "Cache"),
    column("cache bytes per edge", tenths, "Cache", "cache_bytes_per_edge"),
    time("cache + first query", "FirstQuery"),
    time("corrected", "Corrected"),
    time("certified", "Certified"),
    time("label correcting", "LabelCorrecting"),
    time("Dijkstra", "Dijkstra"),
    ratio("in blocks, per source", ("Many", "seconds"), ("Many", "sources"), time_text),
    speed_up("blocks on threads", "Many"),
)


def is_shown(row):
    """Returns true if the page has this graph: all of the default rule, one of each other rule."""
    return row["rule"] == "Guaranteed" or row["parameter"] in ("0.01", "30")


def graph_tables(run):
    shown, hidden = {}, {}
    for mesh in dict.fromkeys(row["mesh"] for row in run["graph"]):
        rows = [row for row in run["graph"] if row["mesh"] == mesh]
        size = next((count_text(row["Build"]["vertices"]) for row in with_case(rows, "Build")), DASH)
        title = f"{mesh} ({size} vertices): size, accuracy, time"
        shown[title] = listing(SIZES, list(filter(is_shown, rows)))
        hidden[f"{mesh}: other graphs"] = listing(SIZES, [r for r in rows if not is_shown(r)])
        thorough = with_case(rows, "Estimate")
        hidden[f"{mesh}: building"] = listing(BUILDS, thorough)
        hidden[f"{mesh}: queries"] = listing(QUERIES, thorough)
    return {**shown, "Peers": peer_table(run), "": folded("More graphs", titled(hidden))}


def peer_table(run):
    graphs = {(row["mesh"], title_of(row)): row for row in run["graph"]}
    rows = []
    for row in with_case(run["peer"], "Query"):
        coarse, fine = (
            graphs.get((row["mesh"], f"Guaranteed, ε = {accuracy}")) for accuracy in ("0.1", "0.01")
        )
        query = figure(fine, "Corrected")
        first = None
        if "Precompute" in row and figure(coarse, "FirstQuery"):
            theirs = row["Precompute"]["seconds"] + row["Query"]["seconds"]
            first = theirs / (coarse["Build"]["seconds"] + coarse["FirstQuery"]["seconds"])
        rows.append({**row, "first": first, "ours": query})
    columns = (
        MESH,
        vertices("Query"),
        column("peer", PEERS.get, "peer"),
        time("precomputation", "Precompute"),
        time("query", "Query"),
        column("error: mean / 99.9 % / max", errors_text, "Query", "error"),
        ratio("query / graph", ("Query", "seconds"), ("ours", "seconds")),
        ratio("mean error", ("Query", "error", "mean"), ("ours", "error", "mean")),
        ratio("largest error", ("Query", "error", "max"), ("ours", "error", "max")),
        column("first answer / graph, ε = 0.1", gain_text, "first"),
    )
    order = list(PEERS)
    meshes = list(dict.fromkeys(row["mesh"] for row in rows))
    rows.sort(key=lambda row: (meshes.index(row["mesh"]), order.index(row["peer"])))
    note = (
        "The columns from query / graph to largest error are ratios to the graph with ε = 0.01 and "
        "corrected distances."
    )
    return listing(columns, rows, note)


def small(value):
    """Returns 0 for rounding errors, which may be negative."""
    return "0" if abs(value) < 1e-12 else f"{value:.1e}"


def share_text(value):
    """Returns a percentage that is 100 only if nothing is missing."""
    if value in (0.0, 1.0):
        return f"{100.0 * value:.0f}"
    return f"{min(100.0 * value, 99.99):.2f}".rstrip("0").rstrip(".")


def outside_text(figures):
    count = figures["outside"]
    values = joined(small, "outside_median", "outside_max")(figures)
    return f"{count:.0f}: {values}" if count else number(count)


def path_tables(run):
    milliseconds = joined(digits, "ms_median", "ms_p90", "ms_p99")
    kinds = [
        {"mesh": row["mesh"], "path": title, "plain": row[kind], "marked": row.get("Marked" + kind)}
        for row in run["path"]
        for kind, title in PATHS.items()
        if kind in row
    ]
    paths = (
        MESH,
        vertices("plain"),
        column("path", str, "path"),
        column("ms: median / 90 % / 99 %", milliseconds, "plain"),
        column("with landmarks", milliseconds, "marked"),
        column(
            "% within 1e-6 / 1e-5 / 1e-4",
            joined(share_text, "within_1e6", "within_1e5", "within_1e4"),
            "plain",
        ),
        column(
            "excess: median / mean / 99 % / max",
            joined(small, "excess_median", "excess_mean", "excess_p99", "excess_max"),
            "plain",
        ),
        column("beyond 1e-6: median / max", outside_text, "plain"),
    )
    landmarks = (
        MESH,
        time("landmarks (wall)", "Landmarks"),
        column("threads", number, "Landmarks", "threads"),
        column("memory after landmarks", bytes_text, "Landmarks", "landmark_bytes"),
    )
    excess = joined(lambda value: digits(100.0 * value), "excess_mean", "excess_max")
    peers = (
        MESH,
        column("pairs of vertices", number, "VertexVTK", "pairs"),
        column(PEERS["VTK"], "{:.3g} ms", "VertexVTK", "ms_mean"),
        column("default path", "{:.3g} ms", "VertexDefault", "ms_mean"),
        ratio("time", ("VertexVTK", "ms_mean"), ("VertexDefault", "ms_mean")),
        column("excess of VTK's: mean / max", lambda figures: f"{excess(figures)} %", "VertexVTK"),
        column(
            "of the default: mean / max", joined(small, "excess_mean", "excess_max"), "VertexDefault"
        ),
    )
    queries = {
        "search from all samples, in queries": "nearest_per_query",
        "labels of Voronoi cells, in queries": "labels_per_query",
        "in corrected queries": "labels_per_corrected",
        "whole diagram, in queries": "diagram_per_query",
        "with refined borders": "refined_per_query",
    }
    cells = (
        MESH,
        vertices("FarthestPoints"),
        column("samples", number, "FarthestPoints", "samples"),
        time("farthest points", "FarthestPoints"),
        column("in 10 queries", "{:.2f}x", "FarthestPoints", "per_ten_queries"),
        time("one query", "Voronoi", "query_seconds"),
        *(column(title, "{:.2f}x", "Voronoi", key) for title, key in queries.items()),
    )
    matrix = (
        MESH,
        column("matrix", "{0:.0f} x {0:.0f}", "Update", "size"),
        column("threads", number, "Update", "threads"),
        time("update (wall)", "Update"),
        column(
            "error of a row: mean / max",
            lambda f: f"{percent(f['error_mean'])} / {percent(f['error_max'])} %",
            "Update",
        ),
    )
    return {
        "Paths between random points": listing(paths, kinds),
        "Landmarks": listing(landmarks, with_case(run["path"], "Landmarks")),
        "Paths along edges": listing(peers, with_case(run["path"], "VertexVTK")),
        "Farthest points and their cells": listing(cells, run["cells"]),
        "Matrices": listing(matrix, run["matrix"]),
    }


def spectral_tables(run):
    rows = run["spectral"]
    factors = (
        MESH,
        ("vertices", lambda row: count_text(next(iter(list(row.values())[1:]))["vertices"])),
        time("factorization", "Factor"),
        time("of which analysis", "Factor", "analysis_seconds"),
        ratio("entries per vertex", ("Factor", "factor_entries"), ("Factor", "vertices"), significant),
        column("peak: predicted", bytes_text, "Factor", "predicted_bytes"),
        column("measured", bytes_text, "Factor", "peak_bytes"),
        time("one more column", "Column"),
        ratio("per column, in blocks of eight", ("Block", "seconds"), ("Block", "columns"), time_text),
        time("biharmonic column", "Biharmonic"),
    )
    def radius(way):
        return column("radius, mean edges", number, f"Greens/{way}", "radius_in_edges")

    points = (
        MESH,
        time("singularity subtraction", "Greens/SingularitySubtraction"),
        radius("SingularitySubtraction"),
        time("regular parts interpolated", "Greens/RegularPart"),
        time("including corner columns", "Greens/RegularPart", "first_seconds"),
        radius("RegularPart"),
        *(time(WAYS[way], f"Greens/{way}") for way in ("Localized", "Interpolated", "Vertex")),
    )
    movers = (
        MESH,
        column("eigenpairs", number, "Eigenpairs", "pairs"),
        time("time", "Eigenpairs"),
        column("verified complete", true_text, "Eigenpairs", "complete"),
        time("earth mover's distance", "EarthMovers"),
        column("iterations", number, "EarthMovers", "iterations"),
        column("gap between bounds, %", percent, "EarthMovers", "gap"),
        column("distance / geodesic distance", "{:.4f}", "EarthMovers", "per_geodesic"),
    )
    return {
        "Factorizations and columns": listing(factors, rows),
        "Green's functions of arbitrary points": listing(
            points, with_case(rows, *(f"Greens/{way}" for way in WAYS))
        ),
        "Eigenpairs, earth mover's distance of two vertices": listing(
            movers, with_case(rows, "Eigenpairs", "EarthMovers")
        ),
        "Peers": solver_table(run),
    }


def solver_table(run):
    ours = {row["mesh"]: row for row in run["spectral"]}
    rows = []
    for row in run["peer"]:
        if {"Factor", "Column"} <= row.keys():
            mine = ours.get(row["mesh"], {})
            case = "Biharmonic" if row["peer"] == "LibiglBiharmonic" else "Column"
            rows.append({**row, "our factor": mine.get("Factor"), "our column": mine.get(case)})
    columns = (
        MESH,
        column("peer", SOLVERS.get, "peer"),
        time("factorization", "Factor"),
        ratio("/ ours", ("Factor", "seconds"), ("our factor", "seconds")),
        time("column", "Column"),
        ratio("/ ours", ("Column", "seconds"), ("our column", "seconds")),
        column("memory", bytes_text, "Factor", "peak_bytes"),
        ratio("/ ours", ("Factor", "peak_bytes"), ("our factor", "peak_bytes")),
        column("largest difference to ours", "{:.1e}", "Column", "difference"),
    )
    return listing(columns, rows)


def summarize(path):
    """Returns the tables of a result."""
    context, results = load(path)
    run = {name: rows_of(results, pattern) for name, pattern in PATTERNS.items()}
    versions = ", ".join(
        f"{key.split('_')[0]} {context[key].strip()}"
        for key in ("compiler", "vtk_version", "cgal_version", "cholmod_version")
        if key in context
    )
    note = (
        "CPU seconds on one thread, without the time in which libraries set up their meshes; parallel "
        f"cases in wall-clock seconds ({versions}).\n\n"
    )
    parts = (exact_tables, graph_tables, path_tables, spectral_tables)
    return note + "\n".join(filter(None, (titled(make(run)) for make in parts)))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    text = summarize(sys.argv[1])
    if len(sys.argv) == 3:
        with open(sys.argv[2], "w", encoding="utf-8") as file:
            file.write(text)
    print(text)


if __name__ == "__main__":
    main()
