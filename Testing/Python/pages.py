# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation: their code, their headings, their links."""

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
    "Wrapping/Python/README.md",
    "Wrapping/Python/Shell.md",
    "Wrapping/README.md",
)


def text_of(page):
    """The text of a page."""
    with open(os.path.join(support.ROOT, page), encoding="utf-8") as file:
        return file.read()


def blocks(page, language):
    """The blocks of code of one language, those within lists included."""
    found = re.findall(rf"^( *)```{language}\n(.*?)^\1```$", text_of(page), re.M | re.S)
    return [textwrap.dedent(block) for _, block in found]


def anchors(page):
    """What links to headings of the page may name, as GitHub makes it of them."""
    text = re.sub(r"^ *```.*?^ *```$", "", text_of(page), flags=re.M | re.S)
    result = set()
    for heading in re.findall(r"^#+ (.*)$", text, re.M):
        anchor = re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
        result.add(anchor)
    return result


def links(page):
    """Targets of links and pictures."""
    text = re.sub(r"^ *```.*?^ *```$", "", text_of(page), flags=re.M | re.S)
    return re.findall(r"\]\(([^)\s]+)\)", text)
