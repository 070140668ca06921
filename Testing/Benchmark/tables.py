# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of measurements in Markdown: formats of numbers, columns, and rows of Google Benchmark.

A row is a dictionary of figures, possibly nested. A column is a pair of its title and a function of
a row, which `column()` makes from a format and the keys of a figure. `tables.py PAGE NAME FILE` inserts a file into
a page.
"""

import json
import math
import re
import statistics
import sys

DASH = "–"
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
# Statistics over repetitions and sources. Figures without an entry have their median.
STATISTICS = {
    "error_mean": statistics.fmean,
    "error_p999": statistics.fmean,
    "error_max": max,
    "unreached": max,
    "difference": max,
    "other_method": sum,
    "pops_per_vertex": statistics.fmean,
    "relaxations_per_vertex": statistics.fmean,
    "windows_per_vertex": statistics.fmean,
}


def load(path):
    """Returns context and results of a run of Google Benchmark, without failed ones."""
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    # Aggregates (of --benchmark_repetitions) repeat the data of single runs.
    results = [
        entry
        for entry in content["benchmarks"]
        if entry.get("run_type") != "aggregate" and not entry.get("error_occurred")
    ]
    return content["context"], results


def figures_of(entries):
    """Returns the figures of the results of one case: {name: statistic}, and "error" as exhibits have
    it."""
    values = {}
    for entry in entries:
        for key, value in entry.items():
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                values.setdefault(key, []).append(value)
        seconds = entry["real_time"] * UNITS[entry["time_unit"]]
        values.setdefault("seconds", []).append(seconds)
    found = {key: STATISTICS.get(key, statistics.median)(v) for key, v in values.items()}
    if "error_mean" in found and "error_p999" in found:
        found["error"] = {key: found[f"error_{key}"] for key in ("mean", "p999", "max")}
        found["error"]["missed"] = int(found.get("unreached", 0))
    return found


def rows_of(results, pattern):
    """Returns rows of the results whose names match a pattern. A row has the named groups of the
    pattern and, for each value of the group `case`, the figures of this case."""
    found = {}
    for entry in results:
        match = re.match(pattern, entry["name"])
        if match:
            keys = match.groupdict()
            case = keys.pop("case")
            cases = found.setdefault(tuple(keys.items()), {})
            cases.setdefault(case, []).append(entry)
    return [
        {**dict(keys), **{case: figures_of(entries) for case, entries in cases.items()}}
        for keys, cases in found.items()
    ]


def figure(row, *keys):
    """Returns a figure below keys of a row; None if there is none."""
    for key in keys:
        if row is None or isinstance(row, dict) and key not in row:
            return None
        row = row[key]
    return row


def in_form(form):
    """Returns a format, with a dash for None, from a format string or a function."""
    write = form.format if isinstance(form, str) else form
    return lambda value: DASH if value is None else write(value)


def digits(value):
    """Returns two significant digits, without an exponent if possible."""
    return f"{value:.0f}" if 99.5 <= value < 1e6 else f"{value:.2g}"


@in_form
def count_text(value):
    for limit, suffix in ((1e9, "G"), (1e6, "M"), (1e3, "K")):
        if value >= limit:
            return f"{value / limit:.3g}{suffix}"
    return f"{value:.0f}"


significant = in_form(digits)
number = in_form("{:.0f}")
tenths = in_form("{:.1f}")
hundredths = in_form("{:.2f}")
short = in_form("{:g}")
percent = in_form(lambda value: digits(100.0 * value))
whole_percent = in_form(lambda value: f"{100.0 * value:.0f} %")
bytes_text = in_form(lambda value: count_text(value) + "B")
time_text = in_form(lambda value: f"{value:.3g} s" if value >= 1.0 else f"{1e3 * value:.3g} ms")
gain_text = in_form(lambda value: f"{digits(value)}x")


def quotient(numerator, denominator):
    """Returns None if one of the numbers is missing or the denominator is 0."""
    return None if numerator is None or not denominator else numerator / denominator


def ratio_text(numerator, denominator):
    return gain_text(quotient(numerator, denominator))


def range_text(values, form=digits):
    """Returns the smallest and the largest of some values; one text if they look the same."""
    return " to ".join(dict.fromkeys((form(min(values)), form(max(values)))))


def errors_text(errors):
    """Returns mean, 99.9th percentile and maximum in percent, and the number of unreached points."""
    parts = " / ".join(percent(errors[key]) for key in ("mean", "p999", "max"))
    return parts + " %" + (f", {errors['missed']} unreached" if errors.get("missed") else "")


def vertices_text(count):
    return f"{count_text(count)} vertices"


def joined(form, *keys):
    """Returns a format of several figures of a dictionary."""
    return lambda figures: " / ".join(form(figures[key]) for key in keys)


def column(title, form, *keys):
    """Returns a column of the figures below these keys of a row, with a dash for missing ones."""
    form = in_form(form)
    return title, lambda row: form(figure(row, *keys))


def ratio(title, numerator, denominator, form=gain_text):
    """Returns a column of the quotient of two figures of a row, given by tuples of keys."""
    return title, lambda row: in_form(form)(
        quotient(figure(row, *numerator), figure(row, *denominator))
    )


def table(header, rows):
    """Returns an empty text without rows."""
    if not rows:
        return ""
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def listing(columns, rows, note=""):
    """Returns the table of columns and rows, below a note."""
    header = [title for title, _ in columns]
    made = table(header, [[cell(row) for _, cell in columns] for row in rows])
    return f"{note}\n\n{made}" if note and made else made


def named(rows):
    """Returns the rows of a dictionary, with their key as "name"."""
    return [{"name": name, **row} for name, row in rows.items()]


def titled(tables):
    """Returns the nonempty tables of {title: table} below their titles; an empty title is omitted."""
    return "\n".join(
        f"**{title}**\n\n{made}" if title else made for title, made in tables.items() if made
    )


def folded(summary, made):
    """Returns text that a reader can unfold, and that insert() omits; nothing for an empty text."""
    return f"<details><summary>{summary}</summary>\n\n{made}\n</details>\n" if made else ""


def slope(points):
    """Returns the slope of the least-squares line through (log x, log y); None for less than two
    points."""
    if len(points) < 2:
        return None
    xs, ys = ([math.log(value) for value in values] for values in zip(*points))
    return statistics.linear_regression(xs, ys).slope


class MarkerError(Exception):
    """Expected one pair of markers."""


def insert(text, name, content):
    """Returns a page with new content between the lines `<!-- begin NAME ... -->` and `<!-- end NAME
    -->`. Folded parts of the content are omitted."""
    marked = re.compile(
        rf"(^<!-- begin {re.escape(name)}\b[^\n]*-->\n).*?(^<!-- end {re.escape(name)} -->$)",
        re.M | re.S,
    )
    content = re.sub(r"<details>.*?</details>\n*", "", content, flags=re.S).strip()
    result, count = marked.subn(lambda match: f"{match[1]}{content}\n{match[2]}", text)
    if count != 1:
        raise MarkerError(f"Expected one pair of markers of {name}, found {count}.")
    return result


ERRORS = column("error: mean / 99.9 % / max", errors_text, "error")
DEGREE = column("degree", number, "degree")


def main(page, name, file):
    """Inserts a file between the markers of this name in a page."""
    texts = []
    for path in (page, file):
        with open(path, encoding="utf-8") as opened:
            texts.append(opened.read())
    try:
        text = insert(texts[0], name, texts[1])
    except MarkerError as error:
        sys.exit(f"error: {page}: {error}")
    with open(page, "w", encoding="utf-8") as opened:
        opened.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
