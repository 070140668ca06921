#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkGraph.

Usage: summarize_graph.py RESULT.json [TABLE.md]

Times are medians over the sources of a mesh. The mean error and the 99.9th percentile are means
over the sources, the maximum is the largest of all. Ratios are times better than a peer.
"""

import re

from benchmark_results import (
    DASH,
    collect,
    count_text,
    environment,
    errors_text,
    largest,
    load,
    mean,
    median,
    ratio_text,
    run_as_script,
    table,
    text,
    time_text,
)

GRAPH = re.compile(
    r"^Graph/(?P<mesh>[^/]+)/(?P<rule>[^/]+)/(?P<parameter>[^/]+)/(?P<case>[A-Za-z]+)(?:/|$)"
)
PEER = re.compile(r"^Peer/(?P<mesh>[^/]+)/(?P<peer>[A-Za-z]+)(?:/(?P<case>[A-Za-z]+))?(?:/|$)")
TITLES = {
    "Exact": "the exact solver",
    "HeatDirect": "heat method (CGAL)",
    "HeatDelaunay": "heat method, intrinsic Delaunay (CGAL)",
    "VTK": "vtkDijkstraGraphGeodesicPath",
}


class Run:
    """graphs[mesh][rule, parameter][case] and peers[mesh][peer][case]: {figure: [values]}."""

    def __init__(self, path):
        self.context, results = load(path)
        self.graphs = {}
        self.peers = {}
        for entry in results:
            figures = self.figures(entry["name"])
            if figures is not None:
                collect(entry, figures)

    def figures(self, name):
        """Where the figures of a result of this name go; None when it is not one of ours."""
        match = GRAPH.match(name)
        if match:
            graphs = self.graphs.setdefault(match["mesh"], {})
            cases = graphs.setdefault((match["rule"], match["parameter"]), {})
            return cases.setdefault(match["case"], {})
        match = PEER.match(name)
        if match:
            cases = self.peers.setdefault(match["mesh"], {}).setdefault(match["peer"], {})
            return cases.setdefault(match["case"], {})
        return None

    def graph(self, mesh, rule, parameter):
        return self.graphs.get(mesh, {}).get((rule, parameter), {})

    def peer(self, mesh, peer):
        return self.peers.get(mesh, {}).get(peer, {})


def seconds(cases, case):
    return median(cases.get(case), "seconds")


def speed_up_text(cases, case):
    """What threads gain, wall against wall: a busy machine disturbs both."""
    parallel = cases.get("Parallel" + case)
    gain = ratio_text(median(cases.get(case), "wall_seconds"), median(parallel, "wall_seconds"))
    threads = median(parallel, "threads")
    return DASH if threads is None else f"{gain} on {threads:.0f}"


def title_of(rule, parameter):
    return f"{rule}, {'K' if rule == 'SVG' else 'ε'} = {parameter}"


def size_table(graphs):
    rows = []
    for (rule, parameter), cases in graphs.items():
        build = cases.get("Build")
        built = seconds(cases, "Build")
        vertices = median(build, "vertices")
        rows.append(
            [
                title_of(rule, parameter),
                text(median(build, "degree_mean"), "{:.1f}")
                + text(median(build, "degree_deviation"), " ± {:.1f}"),
                text(median(build, "windows_per_vertex"), "{:.0f}"),
                text(median(build, "bytes_per_edge"), "{:.1f}"),
                time_text(built),
                text(None if built is None else 1e6 * built / vertices, "{:.1f} µs"),
                errors_text(cases.get("Certified")),
                errors_text(cases.get("Corrected")),
                time_text(seconds(cases, "Corrected")),
                text(mean(cases.get("Corrected"), "pops_per_vertex"), "{:.2f}"),
            ]
        )
    header = [
        "graph",
        "degree",
        "windows per vertex",
        "bytes per edge",
        "build",
        "per vertex",
        "error: mean / 99.9 % / max",
        "corrected",
        "query",
        "queue entries per vertex",
    ]
    return table(header, rows)


def thorough(graphs):
    """The graphs of which everything was measured."""
    return {key: cases for key, cases in graphs.items() if "Estimate" in cases}


def build_table(graphs):
    rows = []
    for (rule, parameter), cases in thorough(graphs).items():
        estimate = cases["Estimate"]
        parallel = cases.get("ParallelBuild")
        same = median(parallel, "same_bits")
        rows.append(
            [
                title_of(rule, parameter),
                speed_up_text(cases, "Build"),
                DASH if same is None else ("yes" if same == 1.0 else "NO"),
                text(median(cases.get("Memory"), "peak_bytes_per_edge"), "{:.1f}"),
                text(median(cases.get("Memory"), "resident_bytes_per_edge"), "{:.1f}"),
                time_text(median(estimate, "seconds")),
                text(median(estimate, "edges_ratio"), "{:.2f}"),
                text(median(estimate, "peak_ratio"), "{:.2f}"),
            ]
        )
    header = [
        "graph",
        "build on threads",
        "same bits",
        "peak bytes per edge",
        "the system's peak",
        "estimate",
        "edges: estimated / built",
        "memory: estimated / peak",
    ]
    return table(header, rows)


def query_table(graphs):
    rows = []
    for (rule, parameter), cases in thorough(graphs).items():
        many = cases.get("Many")
        per_source = (
            seconds(cases, "Many") / median(many, "sources") if median(many, "sources") else None
        )
        certified = seconds(cases, "Certified")
        rows.append(
            [
                title_of(rule, parameter),
                time_text(seconds(cases, "Cache")),
                text(median(cases.get("Cache"), "cache_bytes_per_edge"), "{:.1f}"),
                time_text(seconds(cases, "FirstQuery")),
                time_text(seconds(cases, "Corrected")),
                time_text(certified),
                time_text(seconds(cases, "LabelCorrecting")),
                time_text(seconds(cases, "Dijkstra")),
                ratio_text(seconds(cases, "Dijkstra"), certified),
                time_text(per_source),
                ratio_text(certified, per_source),
                speed_up_text(cases, "Many"),
            ]
        )
    header = [
        "graph",
        "cache",
        "its bytes per edge",
        "cache + first query",
        "corrected",
        "certified",
        "label correcting",
        "Dijkstra",
        "Dijkstra / certified",
        "in blocks, per source",
        "certified / blocks",
        "blocks on threads",
    ]
    return table(header, rows)


def peer_table(run):
    rows = []
    for mesh, peers in run.peers.items():
        for peer, title in TITLES.items():
            query = peers.get(peer, {}).get("Query")
            if query:
                rows.append(
                    [
                        mesh,
                        count_text(median(query, "vertices")),
                        title,
                        time_text(seconds(peers[peer], "Precompute")),
                        time_text(median(query, "seconds")),
                        errors_text(query),
                    ]
                )
    header = ["mesh", "vertices", "peer", "precomputation", "query", "error: mean / 99.9 % / max"]
    return table(header, rows)


def total(cases, first, second):
    parts = (seconds(cases, first), seconds(cases, second))
    return None if None in parts else sum(parts)


def ratio_rows(run, mesh):
    """Each peer against the graph that is to replace it."""
    coarse = run.graph(mesh, "Guaranteed", "0.1")
    fine = run.graph(mesh, "Guaranteed", "0.01")
    rows = []
    for peer, title in TITLES.items():
        cases = run.peer(mesh, peer)
        query = cases.get("Query")
        pairs = [("query, ε = 0.01", median(query, "seconds"), seconds(fine, "Corrected"), fine)]
        if "Precompute" in cases:
            pairs.append(
                (
                    "up to the first answer, ε = 0.1",
                    total(cases, "Precompute", "Query"),
                    total(coarse, "Build", "FirstQuery"),
                    coarse,
                )
            )
        for what, theirs, ours, graph in pairs:
            if theirs is not None and ours is not None:
                rows.append(
                    [
                        mesh,
                        title,
                        what,
                        time_text(theirs),
                        time_text(ours),
                        ratio_text(theirs, ours),
                        ratio_text(
                            mean(query, "error_mean"), mean(graph.get("Corrected"), "error_mean")
                        ),
                        ratio_text(
                            largest(query, "error_max"),
                            largest(graph.get("Corrected"), "error_max"),
                        ),
                    ]
                )
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
        parts.append("**Graph with corrected distances against peers** (times better)\n")
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
        f"CPU seconds on one thread, but for parallel ones (on the wall); the set-up of each one's "
        f"mesh is left out ({about}).\n"
    ]
    for mesh, graphs in run.graphs.items():
        parts.append(f"**{mesh}{vertices_of(graphs)}: size, accuracy, time**\n")
        parts.append(size_table(graphs))
    parts += thorough_parts(run)
    parts += peer_parts(run)
    return "\n".join(parts)


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
