# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Base class of the exhibits of the thesis, and the comparison of our figures with published ones."""

from dataclasses import dataclass

from tables import listing, named

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
    """One of the words above, and the reason."""

    word: str
    reason: str = ""


def judged(ours, low, high=None, slack=SLACK):
    """Returns the word for a figure of which less is better, compared with a published one or a
    range."""
    high = low if high is None else high
    if ours * slack < low:
        return BETTER
    return WORSE if ours > high * slack else REPRODUCED


def most_frequent(words):
    return max(words, key=words.count)


class Exhibit:
    """A table or figure of the thesis, or several with the same figures.

    `measure` returns figures that can be written as JSON. All other functions use these figures, so
    that a page can be written again without measurements.
    """

    name = ""
    title = ""
    also = {}  # {name: title} of further exhibits that show the same figures
    published = ""  # published figures, or a description of the picture
    columns = ()  # of the table

    @property
    def titles(self):
        """{name: title} of all exhibits."""
        return {self.name: self.title, **self.also}

    def measure(self, run):
        raise NotImplementedError

    def note(self, figures):  # pylint: disable=unused-argument
        """Returns the text above the table."""
        return ""

    def table(self, figures):
        """Returns Markdown."""
        rows = named(figures) if isinstance(figures, dict) else figures
        return listing(self.columns, rows, self.note(figures))

    def pictures(self, figures):  # pylint: disable=unused-argument
        """Returns {name of an exhibit: function that writes its picture to a path}."""
        return {}

    def verdict(self, figures):  # pylint: disable=unused-argument
        """Returns the comparison with published figures."""
        return Verdict(NOT_COMPARABLE)

    def words(self, figures):
        """Returns the words for all exhibits: {name: word}."""
        return dict.fromkeys(self.titles, self.verdict(figures).word)
