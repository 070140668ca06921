# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Signals that arrive while VTK works, such as Ctrl-C."""

import signal
import threading


# Those from which programs raise exceptions; to ask for all takes long beside a query.
_NAMES = "INT TERM HUP QUIT BREAK ALRM VTALRM PROF XCPU PIPE USR1 USR2".split()
_NUMBERS = [getattr(signal, f"SIG{name}") for name in _NAMES if hasattr(signal, f"SIG{name}")]


class Interruption:
    """Defers the exceptions of signal handlers until the update ends.

    Python runs these handlers in the main thread as soon as it executes any bytecode, and that is
    in an observer here. What an observer raises is lost, and a KeyboardInterrupt ends the program
    there. So handlers are called as ever, but `raised` has their exception, for the observer to
    stop the work and for the caller to raise.
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
        except BaseException as exception:  # whatever it is, it is raised by the caller
            self.raised = self.raised or exception

    def _restore(self):
        for number, handler in self._handlers.items():
            if signal.getsignal(number) == self._handle:  # else the handler has chosen another one
                signal.signal(number, handler)
