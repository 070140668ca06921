#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Put a file between the two marker comments of a Markdown file.

Usage: insert_table.py MARKDOWN NAME FILE

The markers are lines of their own: `<!-- begin NAME ... -->` and `<!-- end NAME -->`.
"""

import re
import sys


class MarkerError(Exception):
    """There are no such markers, or more than one pair."""


def insert(text, name, content):
    """The text with what is between the markers of this name replaced."""
    marked = re.compile(
        rf"(^<!-- begin {re.escape(name)}\b[^\n]*-->\n).*?(^<!-- end {re.escape(name)} -->$)",
        re.M | re.S,
    )
    result, count = marked.subn(lambda match: match[1] + content.strip() + "\n" + match[2], text)
    if count != 1:
        raise MarkerError(f"{count} pairs of markers `begin {name}`, `end {name}`; 1 is needed")
    return result


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    markdown, name, path = sys.argv[1:]
    with open(markdown, encoding="utf-8") as file:
        text = file.read()
    with open(path, encoding="utf-8") as file:
        content = file.read()
    try:
        text = insert(text, name, content)
    except MarkerError as error:
        sys.exit(f"error: {markdown}: {error}")
    with open(markdown, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
