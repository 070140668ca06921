#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkGraph.

Usage: summarize_graph.py RESULT.json [TABLE.md]

Times are medians over the sources of a mesh. The mean error and the 99.9th percentile are means
over the sources, the maximum is the largest of all. Ratios are those of a peer to the graph.
"""

from benchmark_results import (
    DASH,
    Results,
    count_text,
    environment,
    errors_of,
    figure,
    first_of,
    in_form,
    largest,
    mean,
    median,
    ratio_text,
    run_as_script,
    table,
    tabulate,
    text,
    time_text,
)

TITLES = {
    "Exact": "the exact solver",
    "Heat": "heat method",
    "Marching": "fast marching",
    "HeatDirect": "heat method (CGAL)",
    "HeatDelaunay": "heat method, intrinsic Delaunay (CGAL)",
    "VTK": "vtkDijkstraGraphGeodesicPath",
}


class Run(Results):
    """graphs[mesh][rule, parameter][case] and peers[mesh][peer][case]."""

    patterns = {
        "graphs": r"Graph/([^/]+)/([^/]+)/([^/]+)/([A-Za-z]+)(?:/|$)",
        "peers": r"Peer/([^/]+)/([A-Za-z]+)(?:/([A-Za-z]+))?(?:/|$)",
    }

    def key(self, group, match):
        mesh, *name, case = match.groups()
        return (mesh, tuple(name) if group == "graphs" else name[0], case)


def seconds(cases, case):
    return median(cases.get(case), "seconds")


def speed_up(case):
    """What threads gain, wall against wall: a busy machine disturbs both."""

    def make(_, cases):
        parallel = cases.get("Parallel" + case)
        gain = ratio_text(median(cases.get(case), "wall_seconds"), median(parallel, "wall_seconds"))
        threads = median(parallel, "threads")
        return DASH if threads is None else f"{gain} on {threads:.0f}"

    return make


def title_of(graph, _):
    rule, parameter = graph
    return f"{rule}, {'K' if rule == 'SVG' else 'ε'} = {parameter}"


def size_table(graphs):
    def degree(_, cases):
        build = cases.get("Build")
        deviation = text(median(build, "degree_deviation"), " ± {:.1f}")
        return text(median(build, "degree_mean"), "{:.1f}") + deviation

    def per_vertex(_, cases):
        built = seconds(cases, "Build")
        vertices = median(cases.get("Build"), "vertices")
        return text(None if built is None else 1e6 * built / vertices, "{:.1f} µs")

    def pops(_, cases):
        return text(mean(cases.get("Corrected"), "pops_per_vertex"), "{:.2f}")

    columns = [
        ("graph", title_of),
        ("degree", degree),
        ("windows per vertex", figure("Build", "windows_per_vertex")),
        ("bytes per edge", figure("Build", "bytes_per_edge", in_form("{:.1f}"))),
        ("build", figure("Build")),
        ("per vertex", per_vertex),
        ("error: mean / 99.9 % / max", errors_of("Certified")),
        ("corrected", errors_of("Corrected")),
        ("query", figure("Corrected")),
        ("queue entries per vertex", pops),
    ]
    return tabulate(columns, graphs.items())


def thorough(graphs):
    """The graphs of which everything was measured."""
    return {key: cases for key, cases in graphs.items() if "Estimate" in cases}


def build_table(graphs):
    def same(value):
        return DASH if value is None else ("yes" if value == 1.0 else "NO")

    columns = [
        ("graph", title_of),
        ("build on threads", speed_up("Build")),
        ("same bits", figure("ParallelBuild", "same_bits", same)),
        ("peak bytes per edge", figure("Memory", "peak_bytes_per_edge", in_form("{:.1f}"))),
        ("the system's peak", figure("Memory", "resident_bytes_per_edge", in_form("{:.1f}"))),
        ("estimate", figure("Estimate")),
        ("edges: estimated / built", figure("Estimate", "edges_ratio", in_form("{:.2f}"))),
        ("memory: estimated / peak", figure("Estimate", "peak_ratio", in_form("{:.2f}"))),
    ]
    return tabulate(columns, thorough(graphs).items())


def query_table(graphs):
    def per_source(cases):
        sources = median(cases.get("Many"), "sources")
        return seconds(cases, "Many") / sources if sources else None

    def ratio(_, cases):
        return ratio_text(seconds(cases, "Dijkstra"), seconds(cases, "Certified"))

    columns = [
        ("graph", title_of),
        ("cache", figure("Cache")),
        ("its bytes per edge", figure("Cache", "cache_bytes_per_edge", in_form("{:.1f}"))),
        ("cache + first query", figure("FirstQuery")),
        ("corrected", figure("Corrected")),
        ("certified", figure("Certified")),
        ("label correcting", figure("LabelCorrecting")),
        ("Dijkstra", figure("Dijkstra")),
        ("Dijkstra / certified", ratio),
        ("in blocks, per source", lambda _, cases: time_text(per_source(cases))),
        (
            "certified / blocks",
            lambda _, cases: ratio_text(seconds(cases, "Certified"), per_source(cases)),
        ),
        ("blocks on threads", speed_up("Many")),
    ]
    return tabulate(columns, thorough(graphs).items())


def peer_table(run):
    columns = [
        ("mesh", first_of),
        ("vertices", figure("Query", "vertices", count_text)),
        ("peer", lambda _, peer, cases: TITLES[peer]),
        ("precomputation", figure("Precompute")),
        ("its peak bytes per vertex", figure("Precompute", "heap_bytes_per_vertex")),
        ("query", figure("Query")),
        ("error: mean / 99.9 % / max", errors_of("Query")),
    ]
    rows = [
        (mesh, peer, peers[peer])
        for mesh, peers in run.peers.items()
        for peer in TITLES
        if "Query" in peers.get(peer, {})
    ]
    return tabulate(columns, rows)


def total(cases, first, second):
    parts = (seconds(cases, first), seconds(cases, second))
    return None if None in parts else sum(parts)


def ratio_rows(run, mesh):
    """Each peer against the graph that is to replace it."""
    coarse, fine = (run.graphs[mesh].get(("Guaranteed", e), {}) for e in ("0.1", "0.01"))
    rows = []
    for peer, title in TITLES.items():
        cases = run.peers.get(mesh, {}).get(peer, {})
        query = cases.get("Query")
        pairs = [("query, ε = 0.01", seconds(cases, "Query"), seconds(fine, "Corrected"), fine)]
        if "Precompute" in cases:
            theirs, ours = total(cases, "Precompute", "Query"), total(coarse, "Build", "FirstQuery")
            pairs.append(("up to the first answer, ε = 0.1", theirs, ours, coarse))
        for what, theirs, ours, graph in pairs:
            if theirs is not None and ours is not None:
                corrected = graph.get("Corrected")
                row = [mesh, title, what, time_text(theirs), time_text(ours)]
                row.append(ratio_text(theirs, ours))
                row.append(ratio_text(mean(query, "error_mean"), mean(corrected, "error_mean")))
                row.append(ratio_text(largest(query, "error_max"), largest(corrected, "error_max")))
                rows.append(row)
    return rows


def ratio_table(rows):
    header = ["mesh", "peer", "what", "peer", "graph", "time", "mean error", "largest error"]
    return table(header, rows)


def thorough_parts(run):
    """Tables of the graphs of which everything was measured, folded."""
    parts = ["<details><summary>Building and querying in detail</summary>\n"]
    for mesh, graphs in run.graphs.items():
        if thorough(graphs):
            parts.append(f"**{mesh}: building**\n")
            parts.append(build_table(graphs))
            parts.append(f"**{mesh}: queries**\n")
            parts.append(query_table(graphs))
    return parts + ["</details>\n"] if len(parts) > 1 else []


def peer_parts(run):
    if not run.peers:
        return []
    parts = ["**Peers**\n", peer_table(run)]
    rows = [row for mesh in run.graphs for row in ratio_rows(run, mesh)]
    if rows:
        parts.append("**Graph with corrected distances against peers** (ratios: peer / graph)\n")
        parts.append(ratio_table(rows))
    return parts


def vertices_of(graphs):
    found = [median(cases.get("Build"), "vertices") for cases in graphs.values()]
    found = [vertices for vertices in found if vertices is not None]
    return f" ({count_text(found[0])} vertices)" if found else ""


def summarize(path):
    run = Run(path)
    about = environment(run.context)
    parts = [
        f"CPU seconds on one thread, except for parallel cases, which are in wall-clock seconds; "
        f"without the time in which each library sets up its mesh ({about}).\n"
    ]
    for mesh, graphs in run.graphs.items():
        parts.append(f"**{mesh}{vertices_of(graphs)}: size, accuracy, time**\n")
        parts.append(size_table(graphs))
    parts += thorough_parts(run)
    parts += peer_parts(run)
    return "\n".join(parts)


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
