# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What an exhibit of the thesis is, and how ours is judged beside the published one."""

from dataclasses import dataclass

REPRODUCED = "reproduced"
BETTER = "better"
WORSE = "worse"
NOT_COMPARABLE = "not comparable"
NOT_REGENERATED = "not regenerated"
FAILED = "failed"
# Largest ratio of a measured and a published figure that count as equal.
SLACK = 1.25


@dataclass(frozen=True)
class Verdict:
    """One of the words above, and why."""

    word: str
    reason: str


def judged(ours, low, high=None, slack=SLACK):
    """The word for a figure of which less is better, beside a published one or a range."""
    high = low if high is None else high
    if ours * slack < low:
        return BETTER
    return WORSE if ours > high * slack else REPRODUCED


class Exhibit:
    """A table or figure of the thesis. Subclasses say what is measured and what becomes of it.

    `measure` returns what can be written as JSON; the others work on that, so that a page can be
    made anew without measuring.
    """

    name = ""
    title = ""
    published = ""  # published figures, or a description of the picture

    def measure(self, run):
        """The figures of this exhibit."""
        raise NotImplementedError

    def table(self, figures):
        """As Markdown."""
        raise NotImplementedError

    def draw(self, figures, path):  # pylint: disable=unused-argument
        """Write a picture, and say that there is one."""
        return False

    def verdict(self, figures):
        """Beside what was published."""
        raise NotImplementedError
