# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run the snippets of Examples/Tutorial.md, from top to bottom, and write its pictures.

Usage: tutorial.py FOLDER
"""

import os
import re
import sys


def main(folder):
    """Run them in the folder of the pictures."""
    page = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Tutorial.md")
    with open(page, encoding="utf-8") as file:
        blocks = re.findall(r"^```python\n(.*?)^```$", file.read(), re.M | re.S)
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    names = {}
    for block in blocks:
        exec(compile(block, "Tutorial.md", "exec"), names)  # noqa: S102


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
