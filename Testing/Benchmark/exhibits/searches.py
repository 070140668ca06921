# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Published rules compared with ours, by BenchmarkPublished: pruning, queues, fans,
pseudo-vertices."""

from plots import STYLES, Panel, plot
from tables import (
    DEGREE,
    ERRORS,
    column,
    digits,
    errors_text,
    hundredths,
    listing,
    load,
    number,
    percent,
    range_text,
    rows_of,
    tenths,
    vertices_text,
    whole_percent,
)

from . import surfaces
from .exhibit import NOT_COMPARABLE, REPRODUCED, Exhibit, Verdict, judged
from .run import shared

ACCURACIES = ("0.01", "0.001")
FANS = {"All": "all", "Narrow": "fans as published", "Wide": "wide fans"}
QUEUES = {"FIFO": "FIFO", "SLF": "SLF", "LLL": "LLL", "Both": "SLF and LLL"}


def published(run, name, part, accuracies=ACCURACIES, sources=3, options=()):
    """Returns the figures of one part of BenchmarkPublished by case, which follows the part in the
    names of results."""
    path = run.program(
        "BenchmarkPublished",
        f"--parts={part}",
        f"--accuracies={','.join(accuracies)}",
        f"--sources={sources}",
        "--rules=OneRelay,Guaranteed",
        *options,
        run.file(name),
    )
    pattern = rf"Published/[^/]+/{part}/(?P<case>.+?)(?:/\d+)?/(?:min_time|manual_time)"
    return rows_of(load(path)[1], pattern)[0]


def relative_maximum(row):
    """Returns the largest error divided by the accuracy."""
    return row["error"]["max"] / float(row["accuracy"])


@shared
def pruned(run):
    """Returns the graphs of all candidates, and of candidates pruned by both rules."""
    name = run.pick("bumpy-4", "bumpy-5")
    accuracies = run.pick(ACCURACIES, (*ACCURACIES, "0.0001"))
    found = published(run, name, "Pruning", accuracies)
    rows = []
    for accuracy in accuracies:
        for rule in ("None", "Progress", "Published"):
            build = found[f"{rule}/{accuracy}/Build"]
            seconds = build["pruning_seconds"]
            rows.append(
                {
                    "accuracy": accuracy,
                    "rule": rule,
                    "vertices": build["vertices"],
                    "degree": build["degree_mean"],
                    "share": seconds / (seconds + build["finding_seconds"]),
                    "error": found[f"{rule}/{accuracy}/Query"]["error"],
                }
            )
    return rows


class Pruning(Exhibit):
    """Candidate edges of the indirect construction, and the edges that remain after pruning by progress
    (our rule) and by the published condition."""

    name = "T3.1"
    title = "pruning"
    published = (
        "degree and mean error before and after pruning at ε = 1e-3 and 1e-4; after pruning the degree "
        "is 62 to 84 at 1e-3."
    )
    titles_of_rules = {"None": "before", "Progress": "by progress", "Published": "as published"}
    columns = (
        column("ε", str, "accuracy"),
        column("pruning", titles_of_rules.get, "rule"),
        DEGREE,
        ERRORS,
        ("largest / ε", lambda row: digits(relative_maximum(row))),
        ("time share of pruning", lambda r: "–" if r["rule"] == "None" else whole_percent(r["share"])),
    )

    def measure(self, run):
        return pruned(run)

    def note(self, figures):
        return f"{vertices_text(figures[0]['vertices'])}."

    def verdict(self, figures):
        row = next(r for r in figures if (r["rule"], r["accuracy"]) == ("Published", "0.001"))
        fits = 62 / 1.25 <= row["degree"] <= 84 * 1.25
        return Verdict(
            REPRODUCED if fits else NOT_COMPARABLE,
            f"The published condition gives degree {row['degree']:.0f} at ε = 1e-3. Only this condition is "
            "used here, because the procedure as printed removes all edges.",
        )


@shared
def queues(run):
    """Returns searches by all queues, in graphs of two rules, along all edges or along fans."""
    found = published(run, run.pick("bumpy-5", "bumpy-6"), "Queue")
    return [
        {
            "rule": rule,
            "accuracy": accuracy,
            "queue": queue,
            "fans": fans,
            "vertices": figures["vertices"],
            "pops": figures["pops_per_vertex"],
            "relaxed": figures["relaxations_per_vertex"],
            "seconds": figures["seconds"],
            "error": figures["error"],
        }
        for rule in ("OneRelay", "Guaranteed")
        for accuracy in ACCURACIES
        for fans in FANS
        for queue in QUEUES
        for figures in [found[f"{rule}/{queue}/{fans}/{accuracy}"]]
    ]


class Queues(Exhibit):
    """Queue entries per vertex until no label changes, for four queues: first in, first out (FIFO), small
    labels first (SLF), large labels last (LLL), and both. Searches relax all edges, or only the edges of
    fans. Fans are as narrow as published, or as wide as two successive edges of a path may deviate. The
    second table has the times of OneRelay with all edges, relative to the first of them."""

    name = "T3.2"
    title = "queues of label correcting"
    also = {"F3.6": "time of a search by queue"}
    published = "1.23 to 1.79 queue entries per vertex with SLF and LLL; curves of times."
    rule = "OneRelay"

    def measure(self, run):
        return queues(run)

    def table(self, figures):
        columns = (
            ("graph", "{0[rule]}, ε = {0[accuracy]}".format),
            column("edges", FANS.get, "fans"),
            *(column(title, hundredths, "pops of", queue) for queue, title in QUEUES.items()),
            column("relaxed edges per vertex", number, "relaxed"),
            column("unreached", str, "error", "missed"),
            column("mean error, %", percent, "error", "mean"),
            column("largest, %", percent, "error", "max"),
        )
        rows = self.by_queue(figures, "seconds")
        rows = [row for row in rows if row["rule"] == self.rule and row["fans"] == "All"]
        unit = rows[0]["seconds of"]["FIFO"]
        times = [
            column(title, lambda seconds: hundredths(seconds / unit), "seconds of", queue)
            for queue, title in QUEUES.items()
        ]
        note = f"{vertices_text(figures[0]['vertices'])}; three sources."
        return (
            listing(columns, self.by_queue(figures, "pops"), note)
            + "\n"
            + listing([column("time, ε", str, "accuracy"), *times], rows)
        )

    def by_queue(self, figures, key):
        """Returns the rows of the last queue, each with a figure of all queues."""
        groups = {}
        for row in figures:
            groups.setdefault((row["rule"], row["accuracy"], row["fans"]), {})[row["queue"]] = row
        return [
            {**group["Both"], f"{key} of": {queue: row[key] for queue, row in group.items()}}
            for group in groups.values()
        ]

    def verdict(self, figures):
        rows = [row for row in figures if row["queue"] == "Both" and row["rule"] == self.rule]
        pops = [row["pops"] for row in rows if row["fans"] == "All"]
        missed = [row["error"]["missed"] / row["vertices"] for row in rows if row["fans"] == "Narrow"]
        return Verdict(
            judged(sum(pops) / len(pops), 1.23, 1.79),
            f"With SLF, LLL and all edges there are {min(pops):.2f} to {max(pops):.2f} queue entries per "
            "vertex. Fans as published, arcsin sqrt(ε), leave up to "
            f"{whole_percent(max(missed))} of the vertices without a label. Wide fans leave few, and these are "
            "reached by the certification of this module, see [differences](Differences.md). The search of "
            "this module uses buckets of distance ([graphs](README.md#graphs)).",
        )

    def words(self, figures):
        return {**super().words(figures), "F3.6": NOT_COMPARABLE}


class PseudoVertices(Exhibit):
    """The published pseudo-vertices on increasingly stretched meshes: their number and their effect on
    graphs that are pruned as published, compared with our rule, which uses none."""

    name = "F3.13"
    title = "pseudo-vertices on anisotropic meshes"
    published = "6 to 23 times as many pseudo-vertices as vertices on anisotropic models."
    accuracy = "0.01"
    kinds = {
        "Plain": "without pseudo-vertices",
        "Pseudo": "with pseudo-vertices",
        "Guaranteed": "Guaranteed",
    }
    columns = (
        column("mesh", str, "model"),
        column("anisotropy", tenths, "tau"),
        column("pseudo-vertices per vertex", digits, "Pseudo", "added"),
        *[column(f"edges: {title}", number, kind, "edges") for kind, title in kinds.items()],
        *[column(f"error: {title}", errors_text, kind, "error") for kind, title in kinds.items()],
    )

    def measure(self, run):
        names = ["bumpy-3", "bumpy-3-stretched-2", "bumpy-3-stretched-8"]
        rows = []
        for name in [*names, *run.pick([], ["bumpy-4-stretched-16"])]:
            found = published(run, name, "Pseudo", (self.accuracy,))
            row = {"model": name, "tau": surfaces.anisotropy(*surfaces.arrays_of(run.mesh(name)))}
            for kind in self.kinds:
                build = found[f"{kind}/{self.accuracy}/Build"]
                row[kind] = {
                    "edges": build["edges"] / build["vertices"],
                    "added": build["added_per_vertex"],
                    "error": found[f"{kind}/{self.accuracy}/Query"]["error"],
                }
            rows.append(row)
        return rows

    def note(self, figures):
        return f"ε = {self.accuracy}; edges per vertex of the mesh; errors: mean / 99.9 % / max."

    def pictures(self, figures):
        styles = dict(zip(self.kinds, STYLES))
        curves = [
            (sorted((row["tau"], row[kind]["edges"]) for row in figures), style, "-")
            for kind, style in styles.items()
        ]
        panel = Panel("edges per vertex of the mesh", "anisotropy", "", curves)
        legend = [(self.kinds[kind], style) for kind, style in styles.items()]
        return {self.name: lambda path: plot(path, [[panel]], legend)}

    def verdict(self, figures):
        added = [row["Pseudo"]["added"] for row in figures[1:]]
        last = figures[-1]
        return Verdict(
            judged(max(added), 6.0, 23.0),
            f"Stretched meshes get {range_text(added)} pseudo-vertices per vertex. The most stretched mesh "
            f"then has {digits(last['Pseudo']['edges'] / last['Guaranteed']['edges'])} times as many edges as "
            "with the progress rule, which keeps its bound without pseudo-vertices.",
        )


EXHIBITS = (Pruning(), Queues(), PseudoVertices())
