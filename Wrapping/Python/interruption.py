# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Signals that arrive during an update of VTK, such as Ctrl-C."""

import signal
import threading

# Signals whose handlers raise exceptions. Examining all signals would take longer than a query.
_NAMES = "INT TERM HUP QUIT BREAK ALRM VTALRM PROF XCPU PIPE USR1 USR2".split()
_NUMBERS = [getattr(signal, f"SIG{name}") for name in _NAMES if hasattr(signal, f"SIG{name}")]


class Interruption:
    """Defers the exceptions of signal handlers until the update ends.

    Python runs handlers in the main thread at the next bytecode, which an observer executes here.
    VTK ignores exceptions of observers, and a KeyboardInterrupt there ends the program. Therefore
    `raised` stores the exception of a handler: the observer stops the update, and the caller raises
    the exception.
    """

    def __init__(self):
        self.raised = None
        self._handlers = {}

    def __enter__(self):
        if threading.current_thread() is threading.main_thread():
            try:
                for number in _NUMBERS:
                    handler = signal.getsignal(number)
                    if callable(handler):
                        self._handlers[number] = handler
                        signal.signal(number, self._handle)
            except BaseException:
                self._restore()
                raise
        return self

    def __exit__(self, *_):
        self._restore()

    def _handle(self, number, frame):
        try:
            self._handlers[number](number, frame)
        except BaseException as exception:  # the caller raises it
            self.raised = self.raised or exception

    def _restore(self):
        for number, handler in self._handlers.items():
            if signal.getsignal(number) == self._handle:  # otherwise a handler has set another
                signal.signal(number, handler)
