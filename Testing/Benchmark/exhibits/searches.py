# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Published rules beside ours: pruning, queues, fans, pseudo-vertices; by BenchmarkPublished."""

from benchmark_results import (
    collect,
    digits,
    errors,
    largest,
    load,
    mean,
    median,
    nested,
    number,
    percent,
)
from plot_tools import STYLES

from . import surfaces
from .drawing import plot_curves
from .exhibit import BETTER, NOT_COMPARABLE, REPRODUCED, WORSE, Exhibit, Verdict, judged
from .run import shared
from .tables import DEGREE, ERRORS, column, errors_text, hundredths, listing, tenths, vertices_text

ACCURACIES = ("0.01", "0.001")
QUEUES = {"FIFO": "FIFO", "SLF": "SLF", "LLL": "LLL", "Both": "SLF and LLL"}


def published(run, name, part, accuracies=ACCURACIES, sources=3, options=()):
    """{case: {figure: [values]}} of one part; cases are what comes after its name."""
    path = run.program(
        "BenchmarkPublished",
        f"--parts={part}",
        f"--accuracies={','.join(accuracies)}",
        f"--sources={sources}",
        "--rules=OneRelay,Guaranteed",
        *options,
        run.file(name),
    )
    found = {}
    for entry in load(path)[1]:
        words = entry["name"].split("/")
        cut = next((i for i, word in enumerate(words) if word.isdigit()), len(words))
        key = "/".join(word for word in words[3:cut] if word != "manual_time" and ":" not in word)
        collect(entry, nested(found, key))
    return found


def errors_of(figures):
    return dict(
        zip(("mean", "p999", "max"), errors(figures)),
        missed=int(largest(figures, "unreached") or 0),
    )


@shared
def pruned(run):
    """What candidates, and the two ways to prune them, make of one mesh."""
    name = run.pick("bumpy-4", "bumpy-5")
    accuracies = run.pick(ACCURACIES, (*ACCURACIES, "0.0001"))
    found = published(run, name, "Pruning", accuracies)
    rows = []
    for accuracy in accuracies:
        for rule in ("None", "Progress", "Published"):
            build = found[f"{rule}/{accuracy}/Build"]
            query = found[f"{rule}/{accuracy}/Query"]
            rows.append(
                {
                    "accuracy": accuracy,
                    "rule": rule,
                    "vertices": median(build, "vertices"),
                    "candidates": median(build, "candidates_per_vertex"),
                    "degree": median(build, "degree_mean"),
                    "share": median(build, "pruning_seconds")
                    / (median(build, "pruning_seconds") + median(build, "finding_seconds")),
                    "error": errors_of(query),
                }
            )
    return rows


class Pruning(Exhibit):
    """Candidates of the indirect construction, and what is left of them: pruned by progress, which is
    ours, and by the published condition."""

    name = "T3.1"
    title = "pruning"
    published = (
        "degree and mean error before and after pruning at ε = 1e-3 and 1e-4; after it the degree is "
        "62 to 84 at 1e-3."
    )

    def measure(self, run):
        return pruned(run)

    def table(self, figures):
        titles = {"None": "before", "Progress": "by progress", "Published": "as published"}
        columns = (
            column("ε", str, "accuracy"),
            column("pruning", titles.get, "rule"),
            DEGREE,
            ERRORS,
            ("largest / ε", lambda row: digits(row["error"]["max"] / float(row["accuracy"]))),
            (
                "share of the time",
                lambda row: "–" if row["rule"] == "None" else f"{100.0 * row['share']:.0f} %",
            ),
        )
        return listing(columns, figures, f"{vertices_text(figures[0]['vertices'])}.")

    def verdict(self, figures):
        row = next(r for r in figures if (r["rule"], r["accuracy"]) == ("Published", "0.001"))
        ours = next(r for r in figures if (r["rule"], r["accuracy"]) == ("Progress", "0.001"))
        worst = max(
            r["error"]["max"] / float(r["accuracy"]) for r in figures if r["rule"] == "Published"
        )
        kept = max(
            r["error"]["max"] / float(r["accuracy"]) for r in figures if r["rule"] == "Progress"
        )
        fits = 62 / 1.25 <= row["degree"] <= 84 * 1.25
        return Verdict(
            REPRODUCED if fits else NOT_COMPARABLE,
            f"By the published condition the degree is {row['degree']:.0f} at ε = 1e-3, and the largest "
            f"error {digits(worst)} ε; by progress it is {ours['degree']:.0f}, and {digits(kept)} ε. The "
            "procedure as listed removes all edges; ours has its condition only.",
        )


class Queues(Exhibit):
    """Vertices taken from the queue, per vertex of the mesh, until no label changes: first in, first
    out; small labels first (SLF); large labels last (LLL); both. Edges in all directions are relaxed,
    or those of fans: as narrow as published, or as wide as two edges of a path may deviate."""

    name = "T3.2"
    title = "queues of label correcting"
    published = "1.23 to 1.79 queue entries per vertex with SLF and LLL."
    fans = {"All": "all", "Narrow": "fans as published", "Wide": "wide fans"}
    rule = "OneRelay"

    def measure(self, run):
        name = run.pick("bumpy-5", "bumpy-6")
        found = published(run, name, "Queue")
        return [
            {
                "rule": rule,
                "accuracy": accuracy,
                "queue": queue,
                "fans": fans,
                "vertices": median(figures, "vertices"),
                "degree": median(figures, "degree_mean"),
                "pops": mean(figures, "pops_per_vertex"),
                "relaxed": mean(figures, "relaxations_per_vertex"),
                "rotations": mean(figures, "rotations_per_vertex"),
                "seconds": median(figures, "seconds"),
                "error": errors_of(figures),
            }
            for rule in ("OneRelay", "Guaranteed")
            for accuracy in ACCURACIES
            for fans in self.fans
            for queue in QUEUES
            for figures in [found[f"{rule}/{queue}/{fans}/{accuracy}"]]
        ]

    def table(self, figures):
        columns = (
            ("graph", "{0[rule]}, ε = {0[accuracy]}".format),
            column("edges", self.fans.get, "fans"),
            *(column(title, hundredths, "pops of", queue) for queue, title in QUEUES.items()),
            column("relaxed edges per vertex", number, "relaxed"),
            column("unreached", str, "error", "missed"),
            column("mean error, %", percent, "error", "mean"),
            column("largest, %", percent, "error", "max"),
        )
        note = f"{vertices_text(figures[0]['vertices'])}; three sources."
        return listing(columns, self.by_queue(figures, "pops"), note)

    def by_queue(self, figures, key):
        """The rows of the last queue, each with a figure of all queues."""
        groups = {}
        for row in figures:
            groups.setdefault((row["rule"], row["accuracy"], row["fans"]), {})[row["queue"]] = row
        return [
            {**group["Both"], f"{key} of": {queue: row[key] for queue, row in group.items()}}
            for group in groups.values()
        ]

    def both(self, figures):
        return [
            row["pops"]
            for row in figures
            if row["queue"] == "Both" and row["rule"] == self.rule and row["fans"] == "All"
        ]

    def verdict(self, figures):
        pops = self.both(figures)
        word = judged(sum(pops) / len(pops), 1.23, 1.79)
        narrow = [row for row in figures if row["fans"] == "Narrow" and row["rule"] == self.rule]
        missed = max(row["error"]["missed"] / row["vertices"] for row in narrow)
        return Verdict(
            word,
            f"{min(pops):.2f} to {max(pops):.2f} with both strategies, when all edges are relaxed. "
            f"Fans as narrow as published, arcsin sqrt(ε), leave up to {100.0 * missed:.0f} % of the "
            "vertices without a label; wide ones leave few, which certification mends in ours: see "
            "[differences](Differences.md).",
        )


class QueueTimes(Queues):
    """The time of a search over ε, all edges relaxed, by that of the first: the same figures as
    Table 3.2."""

    name = "F3.6"
    title = "time of a search by queue"
    published = "curves of the time of a search by queue; their figures are not at hand."

    def rows(self, figures):
        return [r for r in figures if r["rule"] == self.rule and r["fans"] == "All"]

    def table(self, figures):
        rows = self.by_queue(self.rows(figures), "seconds")
        unit = rows[0]["seconds of"]["FIFO"]
        columns = [
            column(title, lambda seconds: hundredths(seconds / unit), "seconds of", queue)
            for queue, title in QUEUES.items()
        ]
        return listing([column("ε", str, "accuracy"), *columns], rows)

    def verdict(self, figures):
        rows = self.rows(figures)
        pops = {q: [r["pops"] for r in rows if r["queue"] == q] for q in QUEUES}
        return Verdict(
            NOT_COMPARABLE,
            f"SLF and LLL take {min(pops['Both']):.2f} to {max(pops['Both']):.2f} entries per vertex, "
            f"FIFO {min(pops['FIFO']):.2f} to {max(pops['FIFO']):.2f}, when all edges are relaxed. The "
            "module's own search is in buckets of distance, with one entry per vertex at most "
            "accuracies ([graphs](README.md#graphs)).",
        )


class PseudoVertices(Exhibit):
    """Pseudo-vertices on meshes that are stretched more and more, as published: how many are added,
    what they do to the graph of candidates pruned as published ("plain"), and what our rule gives
    without."""

    name = "F3.13"
    title = "pseudo-vertices on anisotropic meshes"
    published = "6 to 23 times as many pseudo-vertices as vertices on anisotropic models."
    accuracy = "0.01"
    kinds = {"Plain": "plain", "Pseudo": "with pseudo-vertices", "Guaranteed": "Guaranteed"}

    def models(self, run):
        names = [f"bumpy-3-stretched-{factor}" for factor in (2, 8)]
        return ["bumpy-3", *names, *run.pick([], ["bumpy-4-stretched-16"])]

    def measure(self, run):
        rows = []
        for name in self.models(run):
            found = published(run, name, "Pseudo", (self.accuracy,))
            row = {"model": name, "tau": surfaces.anisotropy(*surfaces.arrays_of(run.mesh(name)))}
            for kind in self.kinds:
                build = found[f"{kind}/{self.accuracy}/Build"]
                row[kind] = {
                    "edges": median(build, "edges") / median(build, "vertices"),
                    "added": median(build, "added_per_vertex"),
                    "error": errors_of(found[f"{kind}/{self.accuracy}/Query"]),
                }
            rows.append(row)
        return rows

    def table(self, figures):
        columns = (
            column("mesh", str, "model"),
            column("anisotropy", tenths, "tau"),
            column("pseudo-vertices per vertex", digits, "Pseudo", "added"),
            *self.columns("edges", number, "edges"),
            *self.columns("error", errors_text, "error"),
        )
        note = f"ε = {self.accuracy}; edges per vertex of the mesh; errors: mean / 99.9 % / max."
        return listing(columns, figures, note)

    def columns(self, title, form, key):
        """Those of a figure of each kind."""
        for kind, name in self.kinds.items():
            yield column(f"{title}: {name}", form, kind, key)

    def draw(self, figures, path):
        styles = dict(zip(self.kinds, STYLES))
        curves = [
            (sorted((row["tau"], row[kind]["edges"]) for row in figures), style, "-")
            for kind, style in styles.items()
        ]
        legend = [(self.kinds[kind], style) for kind, style in styles.items()]
        return plot_curves(path, "edges per vertex of the mesh", "anisotropy", curves, legend)

    def verdict(self, figures):
        added = [row["Pseudo"]["added"] for row in figures[1:]]
        last = figures[-1]
        word = judged(max(added), 6.0, 23.0)
        return Verdict(
            REPRODUCED if word == REPRODUCED else (BETTER if word == BETTER else WORSE),
            f"{digits(min(added))} to {digits(max(added))} pseudo-vertices per vertex where triangles are "
            f"stretched. They make {digits(last['Pseudo']['edges'] / last['Guaranteed']['edges'])} times as "
            "many edges as the progress rule needs, which keeps its promise on these meshes without.",
        )


EXHIBITS = (Pruning(), Queues(), QueueTimes(), PseudoVertices())
