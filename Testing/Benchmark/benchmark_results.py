# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Library of all tables of benchmark results: reads JSON and writes figures in Markdown."""

import json
import math
import re
import statistics
import sys

DASH = "–"
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def load(path):
    """Context and results of a run, without failed ones."""
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    # Aggregates (of --benchmark_repetitions) repeat the data of single runs.
    results = [
        entry
        for entry in content["benchmarks"]
        if entry.get("run_type") != "aggregate" and not entry.get("error_occurred")
    ]
    return content["context"], results


def collect(entry, figures):
    """Append the numbers of a result to {figure: [values]}; the time in "seconds"."""
    for key, value in entry.items():
        if isinstance(value, (int, float)) and not isinstance(value, bool):
            figures.setdefault(key, []).append(value)
    figures.setdefault("seconds", []).append(entry["real_time"] * UNITS[entry["time_unit"]])


class Results:
    """Figures of a run, nested by the parts of the names of its results. For each pattern, an attribute
    of the same name holds {part: {part: ... {figure: [values]}}}. A result counts for the first pattern
    that matches its name."""

    patterns = {}

    def __init__(self, path):
        self.context, entries = load(path)
        for group in self.patterns:
            setattr(self, group, {})
        for entry in entries:
            for group, pattern in self.patterns.items():
                match = re.match(pattern, entry["name"])
                if match:
                    collect(entry, nested(getattr(self, group), *self.key(group, match)))
                    break

    def key(self, group, match):
        """Returns the parts of a name, outermost first."""
        return match.groups()


def median(figures, key):
    """Median over the sources; None when the figure was not measured."""
    values = (figures or {}).get(key)
    return statistics.median(values) if values else None


def first_median(parts, key):
    """That of the first of several measurements that has it."""
    found = (median(figures, key) for figures in parts)
    return next((value for value in found if value is not None), None)


def mean(figures, key):
    """Mean over the sources."""
    values = (figures or {}).get(key)
    return statistics.fmean(values) if values else None


def largest(figures, key):
    """Largest of all sources."""
    values = (figures or {}).get(key)
    return max(values) if values else None


def errors(figures):
    """Mean, 99.9th percentile and maximum; None where not measured."""
    return (
        mean(figures, "error_mean"),
        mean(figures, "error_p999"),
        largest(figures, "error_max"),
    )


def errors_text(figures):
    """Returns the three errors in percent."""
    parts = errors(figures)
    if None in parts:
        return DASH
    return " / ".join(digits(100.0 * part) for part in parts) + " %"


def seconds_text(value):
    return f"{value:.3g} s" if value >= 1.0 else f"{1000.0 * value:.3g} ms"


def count_text(value):
    for limit, suffix in ((1e6, "M"), (1e3, "K")):
        if value >= limit:
            return f"{value / limit:.3g}{suffix}"
    return f"{value:.0f}"


def size_text(value):
    return DASH if value is None else count_text(value)


def text(value, form):
    return DASH if value is None else form.format(value)


def number(value):
    return text(value, "{:.0f}")


def percent(value):
    return DASH if value is None else digits(100.0 * value)


def bytes_text(value):
    return DASH if value is None else count_text(value) + "B"


def time_text(value):
    return DASH if value is None else seconds_text(value)


def digits(value):
    """Two digits, without an exponent where it can be done."""
    return f"{value:.0f}" if 100.0 <= value < 1e6 else f"{value:.2g}"


def ratio_text(numerator, denominator):
    if numerator is None or not denominator:
        return DASH
    return f"{digits(numerator / denominator)}x"


def gain_text(gain):
    return ratio_text(gain, 1.0)


def quotient_text(numerator, denominator):
    return DASH if numerator is None or not denominator else digits(numerator / denominator)


def peak_text(predicted, measured):
    return f"{bytes_text(predicted)} / {bytes_text(measured)}"


def environment(context):
    """What a run was compiled with."""
    return ", ".join(
        f"{key.split('_')[0]} {context[key].strip()}"
        for key in ("compiler", "vtk_version", "cgal_version", "cholmod_version")
        if key in context
    )


def table(header, rows):
    """Empty without rows."""
    if not rows:
        return ""
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def tabulate(columns, rows):
    """A table of columns (title, function of a row); each row is a tuple of arguments."""
    header = [title for title, _ in columns]
    return table(header, [[cell(*row) for _, cell in columns] for row in rows])


def figure(case, key="seconds", form=None):
    """A column's function of (..., cases): what was measured of a case, in words."""
    form = form or (time_text if key == "seconds" else number)
    return lambda *row: form(median(row[-1].get(case), key))


def errors_of(case):
    """Returns a column's function of (..., cases): the errors of a case."""
    return lambda *row: errors_text(row[-1].get(case))


def first_of(name, *_):
    """Returns the name that a row starts with."""
    return name


def in_form(form):
    """A number in a format, with a dash for None."""
    return lambda value: text(value, form)


def nested(root, *keys):
    """The innermost of dictionaries in each other, made where there is none."""
    for key in keys:
        root = root.setdefault(key, {})
    return root


def slope(points):
    """Of the least-squares line through (log x, log y); None for less than two points."""
    if len(points) < 2:
        return None
    xs, ys = ([math.log(value) for value in values] for values in zip(*points))
    x_mean, y_mean = statistics.fmean(xs), statistics.fmean(ys)
    products = sum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys))
    return products / sum((x - x_mean) ** 2 for x in xs)


def titled(run, makers):
    """The tables that there is something for, each below its title; {title: function of the run}."""
    parts = []
    for title, make in makers.items():
        made = make(run)
        if made:
            parts += [f"**{title}**\n", made]
    return parts


def folded(summary, made):
    """What is seen only when one asks for it; nothing of nothing."""
    return [f"<details><summary>{summary}</summary>\n", made + "\n</details>\n"] if made else []


def run_as_script(summarize, usage):
    """RESULT.json [TABLE.md] on the command line: print the summary, and write it."""
    if len(sys.argv) not in (2, 3):
        sys.exit(usage)
    text = summarize(sys.argv[1])
    if len(sys.argv) == 3:
        with open(sys.argv[2], "w", encoding="utf-8") as file:
            file.write(text)
    print(text)
