# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Published rules beside ours: pruning, queues, fans, pseudo-vertices; by BenchmarkPublished."""

from benchmark_results import (
    collect,
    count_text,
    digits,
    errors,
    largest,
    load,
    mean,
    median,
    nested,
    percent,
    table,
)
from plot_tools import STYLES

from . import surfaces
from .drawing import plot_curves
from .exhibit import BETTER, NOT_COMPARABLE, REPRODUCED, WORSE, Exhibit, Verdict, judged
from .fields import errors_text

ACCURACIES = ("0.01", "0.001")
QUEUES = ("FIFO", "SLF", "LLL", "Both")


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


def pruned(run):
    """What candidates, and the two ways to prune them, make of one mesh."""
    return run.shared("pruned", lambda: measured_pruning(run))


def measured_pruning(run):
    """That, measured now."""
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
        rows = [
            [
                row["accuracy"],
                titles[row["rule"]],
                f"{row['degree']:.0f}",
                errors_text(row["error"]),
                digits(row["error"]["max"] / float(row["accuracy"])),
                "–" if row["rule"] == "None" else f"{100.0 * row['share']:.0f} %",
            ]
            for row in figures
        ]
        header = ["ε", "pruning", "degree", "error: mean / 99.9 % / max", "largest / ε"]
        return f"{count_text(figures[0]['vertices'])} vertices.\n\n" + table(
            [*header, "share of the time"], rows
        )

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
        rows = [
            [
                f"{row['rule']}, ε = {row['accuracy']}",
                self.fans[row["fans"]],
                *(f"{r['pops']:.2f}" for r in self.group(figures, row)),
                f"{row['relaxed']:.0f}",
                str(row["error"]["missed"]),
                percent(row["error"]["mean"]),
                percent(row["error"]["max"]),
            ]
            for row in figures
            if row["queue"] == "Both"
        ]
        header = ["graph", "edges", "FIFO", "SLF", "LLL", "SLF and LLL", "relaxed edges per vertex"]
        return f"{count_text(figures[0]['vertices'])} vertices; three sources.\n\n" + table(
            [*header, "unreached", "mean error, %", "largest, %"], rows
        )

    def group(self, figures, row):
        """The rows of all queues with the same graph and fans."""
        same = ("rule", "accuracy", "fans")
        return [
            r
            for q in QUEUES
            for r in figures
            if r["queue"] == q and all(r[k] == row[k] for k in same)
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
        rows = self.rows(figures)
        unit = next(r["seconds"] for r in rows if r["queue"] == "FIFO")
        lines = [
            [
                a,
                *(
                    f"{r['seconds'] / unit:.2f}"
                    for q in QUEUES
                    for r in rows
                    if (r["queue"], r["accuracy"]) == (q, a)
                ),
            ]
            for a in ACCURACIES
        ]
        return table(["ε", "FIFO", "SLF", "LLL", "SLF and LLL"], lines)

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

    def models(self, run):
        names = [f"bumpy-3-stretched-{factor}" for factor in (2, 8)]
        return ["bumpy-3", *names, *run.pick([], ["bumpy-4-stretched-16"])]

    def measure(self, run):
        rows = []
        for name in self.models(run):
            found = published(run, name, "Pseudo", (self.accuracy,))
            row = {"model": name, "tau": surfaces.anisotropy(*surfaces.arrays_of(run.mesh(name)))}
            for kind in ("Plain", "Pseudo", "Guaranteed"):
                build = found[f"{kind}/{self.accuracy}/Build"]
                row[kind] = {
                    "edges": median(build, "edges") / median(build, "vertices"),
                    "added": median(build, "added_per_vertex"),
                    "error": errors_of(found[f"{kind}/{self.accuracy}/Query"]),
                }
            rows.append(row)
        return rows

    def table(self, figures):
        rows = [
            [
                row["model"],
                f"{row['tau']:.1f}",
                digits(row["Pseudo"]["added"]),
                *(f"{row[kind]['edges']:.0f}" for kind in ("Plain", "Pseudo", "Guaranteed")),
                *(errors_text(row[kind]["error"]) for kind in ("Plain", "Pseudo", "Guaranteed")),
            ]
            for row in figures
        ]
        kinds = ("plain", "with pseudo-vertices", "Guaranteed")
        header = ["mesh", "anisotropy", "pseudo-vertices per vertex"]
        header += [f"edges per vertex of the mesh: {kinds[0]}", *kinds[1:]]
        return f"ε = {self.accuracy}.\n\n" + table(
            [*header, f"error, mean / 99.9 % / max: {kinds[0]}", *kinds[1:]], rows
        )

    def draw(self, figures, path):
        titles = {"Plain": "plain", "Pseudo": "with pseudo-vertices", "Guaranteed": "Guaranteed"}
        styles = dict(zip(titles, STYLES))
        curves = [
            (sorted((row["tau"], row[kind]["edges"]) for row in figures), style, "-")
            for kind, style in styles.items()
        ]
        legend = [(titles[kind], style) for kind, style in styles.items()]
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
