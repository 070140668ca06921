# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress bars of updates."""

from __future__ import annotations

import sys
import time

from .checks import check_flag

__all__ = ["show_progress"]

# Seconds before the first line, and between two lines.
_PATIENCE = 1.0
_PAUSE = 0.1

_is_on = True


def show_progress(on: bool = True) -> None:
    """Turn progress bars of the functions of this package on or off.

    A bar appears after one second, on terminals and in notebooks only. It is one of tqdm if that is
    installed, otherwise a line of text. Bars are on when the package is imported.

    Parameters
    ----------
    on : bool, optional
        True shows bars. Default: True.
    """
    global _is_on
    check_flag(on, "on")
    _is_on = bool(on)


class Bar:
    """The progress of one call."""

    def __init__(self):
        self._next = time.monotonic() + _PATIENCE if _is_on else float("inf")
        self._line = None

    def show(self, name, fraction):
        """Shows the progress, unless it is too early."""
        now = time.monotonic()
        if now >= self._next:
            self._next = now + _PAUSE
            self._line = self._line or _line()
            if self._line:
                self._line.show(name, fraction)

    def close(self):
        """Removes the bar."""
        if self._line:
            self._line.close()


class Silence:
    """No progress bar."""

    def show(self, name, fraction):
        """Does nothing."""

    def close(self):
        """Does nothing."""


class Part:
    """An interval of the progress of one call, for one of its filters."""

    def __init__(self, bar, start, end):
        self._bar, self._start, self._end = bar, start, end

    def show(self, name, fraction):
        """Shows the progress in the bar of the call."""
        self._bar.show(name, self._start + fraction * (self._end - self._start))

    def close(self):
        """Does nothing: the call removes its bar."""


def _line():
    """Returns a line for the progress; None without a terminal and outside notebooks."""
    is_terminal = sys.stderr is not None and sys.stderr.isatty()
    if not is_terminal and "ipykernel" not in sys.modules:
        return None
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _Plain() if is_terminal else None
    return _Tqdm(tqdm)


class _Plain:
    def show(self, name, fraction):
        """Replaces the line."""
        sys.stderr.write(f"\r{name}: {100.0 * fraction:3.0f} %")
        sys.stderr.flush()

    def close(self):
        """Clears the line."""
        sys.stderr.write("\r\x1b[K")
        sys.stderr.flush()


class _Tqdm:
    def __init__(self, tqdm):
        self._bar = tqdm(
            total=100, leave=False, bar_format="{desc}: {percentage:3.0f}%|{bar}| {elapsed}"
        )

    def show(self, name, fraction):
        """Moves the bar."""
        self._bar.desc = name
        self._bar.n = 100.0 * fraction
        self._bar.refresh()

    def close(self):
        """Removes the bar."""
        self._bar.close()
