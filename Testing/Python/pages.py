# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the documentation: their code, headings and links."""

import os
import re
import textwrap

import support

# From the root. Every page of the source tree is one.
PAGES = (
    "CHANGELOG.md",
    "README.md",
    "Examples/README.md",
    "Examples/Solved.md",
    "Examples/Tutorial.md",
    "Filters/Geodesic/Curves.md",
    "Filters/Geodesic/Distances.md",
    "Filters/Geodesic/Input.md",
    "Filters/Geodesic/Processes.md",
    "Filters/Geodesic/README.md",
    "Filters/Glossary.md",
    "Filters/Parallel/README.md",
    "Filters/Parallel/Rows.md",
    "Filters/Parallel/Scale.md",
    "Filters/PointCloud/README.md",
    "Filters/Spectral/README.md",
    "Readers/README.md",
    "Testing/Benchmark/Differences.md",
    "Testing/Benchmark/README.md",
    "Testing/Benchmark/Thesis.md",
    "Testing/README.md",
    "Wrapping/ParaView/README.md",
    "Wrapping/Python/Demo.md",
    "Wrapping/Python/Files.md",
    "Wrapping/Python/Packages.md",
    "Wrapping/Python/PyVista.md",
    "Wrapping/Python/README.md",
    "Wrapping/Python/Shell.md",
    "Wrapping/README.md",
)


def text_of(page):
    """Returns the text of a page."""
    with open(os.path.join(support.ROOT, page), encoding="utf-8") as file:
        return file.read()


def blocks(page, language):
    """Returns the blocks of code of one language, including blocks within lists."""
    found = re.findall(rf"^( *)```{language}\n(.*?)^\1```$", text_of(page), re.M | re.S)
    return [textwrap.dedent(block) for _, block in found]


def anchors(page):
    """Returns the anchors of the headings of a page, as GitHub makes them."""
    text = re.sub(r"^ *```.*?^ *```$", "", text_of(page), flags=re.M | re.S)
    headings = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", h.strip().lower()).replace(" ", "-") for h in headings}


def links(page):
    """Returns the targets of links and pictures."""
    text = re.sub(r"^ *```.*?^ *```$", "", text_of(page), flags=re.M | re.S)
    return re.findall(r"\]\(([^)\s]+)\)", text)
