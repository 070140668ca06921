#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables (Markdown) from the JSON of BenchmarkExact.

Usage: summarize.py RESULT.json [TABLE.md]

Every figure is the median over the sources of a mesh, measured in one run. Ratios are against our
engine T. The exponents of growth are least-squares lines through log(figure) over log(vertices).
"""

from benchmark_results import (
    DASH,
    Results,
    count_text,
    figure,
    first_of,
    median,
    run_as_script,
    seconds_text,
    slope,
    tabulate,
)

TITLES = {"CGAL": "CGAL exact", "VTK": "vtkDijkstraGraphGeodesicPath"}


class Run(Results):
    """exact[mesh][case] and growth[mesh][case]."""

    patterns = {
        "exact": r"Exact/([^/]+)/(SetUp|T|VTK|CGAL)(?:/|$)",
        "growth": r"Growth/([^/]+)/(T)(?:/|$)",
    }


def peer_text(cases, peer):
    ours, theirs = (median(cases.get(case), "seconds") for case in ("T", peer))
    return DASH if theirs is None else f"{theirs / ours:.3g}x ({seconds_text(theirs)})"


def windows_text(cases):
    seconds, windows = (median(cases["T"], key) for key in ("seconds", "windows"))
    return f"{count_text(windows)} x {1e9 * seconds / windows:.0f} ns"


def time_table(meshes, peers):
    columns = [
        ("mesh", first_of),
        ("vertices", figure("T", "vertices", count_text)),
        ("engine T", figure("T")),
        ("windows", lambda _, cases: windows_text(cases)),
    ]
    columns += [
        (TITLES[peer], lambda _, cases, peer=peer: peer_text(cases, peer)) for peer in peers
    ]
    return tabulate(columns, [item for item in meshes.items() if "T" in item[1]])


def memory_table(meshes, peers):
    columns = [
        ("mesh", first_of),
        ("our mesh", figure("SetUp", "mesh_bytes_per_vertex")),
        ("engine T", figure("T", "heap_bytes_per_vertex")),
    ]
    columns += [(TITLES[peer], figure(peer, "heap_bytes_per_vertex")) for peer in peers]
    return tabulate(columns, meshes.items())


def error_table(meshes, peers):
    def error(key):
        return lambda _, peer, cases: f"{median(cases[peer], key):.2g}"

    columns = [
        ("mesh", first_of),
        ("against engine T", lambda _, peer, cases: TITLES[peer]),
        ("mean", error("error_mean")),
        ("99.9 %", error("error_p999")),
        ("max", error("error_max")),
    ]
    rows = [
        (mesh, peer, cases)
        for mesh, cases in meshes.items()
        for peer in peers
        if median(cases.get(peer), "error_max") is not None
    ]
    return tabulate(columns, rows)


def growth_table(meshes):
    def ratio(key, other, factor=1.0):
        def make(_, cases):
            return f"{factor * median(cases['T'], key) / median(cases['T'], other):.0f}"

        return make

    columns = [
        ("mesh", first_of),
        ("vertices", figure("T", "vertices")),
        ("engine T", figure("T")),
        ("windows per vertex", ratio("windows", "vertices")),
        ("ns per window", ratio("seconds", "windows", 1e9)),
        ("peak B/vertex", figure("T", "heap_bytes_per_vertex")),
    ]
    rows = [item for item in meshes.items() if item[1].get("T")]
    text = tabulate(columns, rows)
    if len(rows) > 1:
        time, windows = (
            slope([(median(cases["T"], "vertices"), median(cases["T"], key)) for _, cases in rows])
            for key in ("seconds", "windows")
        )
        text += (
            f"\nLeast squares over {len(rows)} sizes: time grows as n^{time:.2f}, "
            f"windows as n^{windows:.2f}.\n"
        )
    return text


def summarize(path):
    run = Run(path)
    exact, context = run.exact, run.context
    measured = {case for cases in exact.values() for case in cases}
    parts = []
    about = ", ".join(
        f"{key} {context[key]}"
        for key in ("compiler", "vtk_version", "cgal_version")
        if key in context
    )
    parts.append(f"CPU seconds on one thread, median over the sources of a mesh ({about}).\n")
    if exact:
        timed = [peer for peer in ("CGAL", "VTK") if peer in measured]
        weighed = [peer for peer in ("CGAL",) if peer in measured]
        parts.append("**Exact distance from one vertex to all** (peers: times engine T)\n")
        parts.append(time_table(exact, timed))
        parts.append("**Peak memory, bytes per vertex above the loaded mesh**\n")
        parts.append(memory_table(exact, weighed))
        parts.append("**Relative error**\n")
        parts.append(error_table(exact, timed))
    if run.growth:
        parts.append("**Growth**\n")
        parts.append(growth_table(run.growth))
    return "\n".join(parts)


if __name__ == "__main__":
    run_as_script(summarize, __doc__)
