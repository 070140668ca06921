# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK errors as Python exceptions."""

from __future__ import annotations

import re
import sys
import warnings
from typing import Any, List

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonMisc import vtkErrorCode

from .interruption import Interruption
from .progress import Bar

__all__ = ["VTKError", "check"]

# What VTK puts before a message, and the addresses of objects in it.
_PLACE = re.compile(r"\A(?:ERROR|Warning): In .*, line \d+\n")
_ADDRESS = re.compile(r" ?\(0x[0-9a-fA-F]+\)")
# The name of the class that reports.
_SPEAKER = re.compile(r"\A\w+: ")
# Words in messages of filters, and their replacements in functions.
_IN_ARGUMENTS = {
    " of input port 1, at": ", at",
    "Use vtkExactGeodesicDistance or vtkDGGDistance": 'Use method="exact" or "graph"',
    "vtkPointCloudDGG makes,": "vtkPointCloudDGG makes (vtkdgg.CloudGraph),",
    "build it so by vtkDiscreteGeodesicGraph, remove it, or turn AcceptCoarserGraph on": "build it "
    'so by vtkdgg.Graph(mesh, accuracy=...), or choose method="exact"',
    "turn MergeCoincidentPoints on, with a MergeTolerance": "set merge_coincident_points=True, and "
    "a merge_tolerance",
    "turn MergeCoincidentPoints on": "set merge_coincident_points=True",
    "Accuracy 0": "accuracy 0",
    "larger Accuracy": "larger accuracy",
    "FirstSample": "first",
    "MaximumDistance": "maximum_distance",
    "MemoryLimit": "memory_limit",
    "MergeTolerance": "merge_tolerance",
    "NumberOfNeighbors": "number_of_neighbors",
    "NumberOfSamples": "number_of_samples",
    "ProjectionTolerance": "projection_tolerance",
}
# The end of a path that a function was given: its filter has starts and ends on a port, by turns.
_END = re.compile(r"path end point (\d+) of input port 1")
# How an executive reports that an algorithm failed: it names the request, not the reason.
_NO_REASON = re.compile(r"returned failure for request|No update piece number has been set")


class VTKError(RuntimeError):
    """An error that a VTK algorithm reported.

    Attributes
    ----------
    messages : list of str
        What was reported, one entry per error, in order.
    code : int
        ``GetErrorCode()`` of the algorithm that failed first, 0 when none was set.
    """

    def __init__(self, messages: List[str], code: int = 0) -> None:
        super().__init__("\n".join(messages))
        self.messages = list(messages)
        self.code = code


def check(algorithm: vtkAlgorithm) -> Any:
    """Update an algorithm and raise when it, or anything upstream of it, reports an error.

    A writer is asked to write. The messages are in the exception, without the file, line and address
    that VTK puts before them, and are not printed. When nothing failed, VTK's warnings become
    Python warnings.

    An update that an observer stops by AbortExecute is no error, here as in VTK: the output is
    empty then, until the algorithm that was stopped runs again or is modified; its
    ``GetAbortExecute()`` says why. Ctrl-C stops it as well and is a
    KeyboardInterrupt as ever, after which the algorithm can be used again. Other threads of Python
    go on meanwhile.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        A reader, filter or writer of any module.

    Returns
    -------
    vtkDataObject or None
        The output at port 0, or None when the algorithm has no output.

    Raises
    ------
    VTKError
        When an error was reported. It is raised again by later calls until the cause is gone.
    TypeError
        When `algorithm` is not a vtkAlgorithm.

    Examples
    --------
    >>> mesh = vtkdgg.check(reader)
    """
    return _checked(algorithm)


def run(algorithm, issued=None, refused=None, bar=Bar):
    """Updates an algorithm like check(), for functions of the package: with a progress bar, and
    messages in terms of arguments.

    Warnings in the set `issued` are not repeated, even if they come from another class; others are
    added to the set. A warning becomes an error, and stops the update, if the function `refused`
    returns true at that time. `bar` makes the progress bar.
    """
    return _checked(algorithm, issued, refused, bar, in_arguments)


def in_arguments(text):
    """What a filter says, for those who have called a function."""

    def end_of(match):
        pair, is_end = divmod(int(match[1]), 2)
        return ("end" if is_end else "start") + (f" {pair}" if pair else "")

    text = _END.sub(end_of, text)
    for words, ours in _IN_ARGUMENTS.items():
        text = text.replace(words, ours)
    return text


def _checked(algorithm, issued=None, refused=None, bar=None, words=str):
    if not isinstance(algorithm, vtkAlgorithm):
        raise TypeError(f"check(): expected a vtkAlgorithm, got {type(algorithm).__name__}")
    pipeline = _upstream(algorithm)
    reports = _update(algorithm, pipeline, refused, bar)
    if not reports.errors and _failed(pipeline):
        # It failed in an earlier update, whose messages are gone. Run it again to have them.
        for node in _failed(pipeline):
            node.Modified()
        reports = _update(algorithm, pipeline, refused, bar)
    failed = [node for node in _failed(pipeline) if not _recovered(node, reports)]
    if reports.errors or failed:
        # What failed must run again in the next update, even when nothing else changes.
        for node in reports.nodes + failed:
            node.Modified()
        messages = [words(text) for text in _messages(reports, failed)]
        raise VTKError(messages, failed[0].GetErrorCode() if failed else 0)
    for text in reports.warnings:
        said = _SPEAKER.sub("", text)
        if issued is None or said not in issued:
            warnings.warn(words(text), RuntimeWarning, stacklevel=depth_of_package())
        if issued is not None:
            issued.add(said)
    if algorithm.GetNumberOfOutputPorts() == 0:
        return None
    return algorithm.GetOutputDataObject(0)


class _Reports:
    """What the algorithms of a pipeline said during one update."""

    def __init__(self):
        self.errors = []
        self.warnings = []
        self.nodes = []  # those that reported an error


def _upstream(algorithm):
    """The algorithm and all that it depends on, sources first."""
    # Without recursion: a function inside that calls itself is a cycle, which would keep the
    # algorithms and their data until the garbage collector runs.
    found = []
    waiting = [(algorithm, False)]
    while waiting:
        node, inputs_are_found = waiting.pop()
        if node in found:
            continue
        if inputs_are_found:
            found.append(node)
            continue
        waiting.append((node, True))
        inputs = [
            node.GetInputAlgorithm(port, connection)
            for port in range(node.GetNumberOfInputPorts())
            for connection in range(node.GetNumberOfInputConnections(port))
        ]
        waiting.extend((source, False) for source in reversed(inputs))
    return found


def _update(algorithm, pipeline, refused, bar):
    reports = _Reports()
    bar = bar and bar()
    interruption = Interruption()

    def watch(target, node):
        def on_error(caller, event, text):
            reports.errors.append(_clean(text))
            reports.nodes.append(node)

        def on_warning(caller, event, text):
            if refused and refused():
                on_error(caller, event, text)
                algorithm.SetAbortExecute(1)
            else:
                reports.warnings.append(_clean(text))

        on_error.CallDataType = "string0"
        on_warning.CallDataType = "string0"
        return [
            (target, target.AddObserver("ErrorEvent", on_error)),
            (target, target.AddObserver("WarningEvent", on_warning)),
        ]

    stopped = []

    def on_progress(caller, event):
        # Here other threads of Python get their turn and handlers of signals run: the wrappers of
        # VTK hold the interpreter lock, but Python code gives it away when others wait for it.
        if interruption.raised:
            caller.SetAbortExecute(1)
            stopped.append(caller)
        elif bar:
            bar.show(caller.GetClassName(), caller.GetProgress())

    watched = []
    for node in pipeline:
        if node.IsA("vtkTrivialProducer"):
            continue  # data that somebody has set
        watched += watch(node, node)
        watched.append((node, node.AddObserver("ProgressEvent", on_progress)))
        # Executives report what is wrong with the connections.
        watched += watch(node.GetExecutive(), node)
    # Image writers write in Write() only.
    execute = getattr(algorithm, "Write", algorithm.Update)
    # VTK reports nothing, not even to observers, while its display of warnings is off.
    display = vtkObject.GetGlobalWarningDisplay()
    vtkObject.GlobalWarningDisplayOn()
    try:
        with interruption:
            execute()
    finally:
        vtkObject.SetGlobalWarningDisplay(display)
        for target, tag in watched:
            target.RemoveObserver(tag)
        if bar:
            bar.close()
    if interruption.raised:
        for node in stopped:
            # Modifies the node, so that it runs again. VTK 9.3 and later do not clear the flag.
            node.SetAbortExecute(0)
        raise interruption.raised
    return reports


def _failed(pipeline):
    return [node for node in pipeline if node.GetErrorCode() != vtkErrorCode.NoError]


def _recovered(node, reports):
    """Some readers of VTK keep the error code of an earlier failure when they succeed later."""
    if node in reports.nodes or reports.errors or reports.warnings:
        return False
    output = node.GetOutputDataObject(0) if node.GetNumberOfOutputPorts() > 0 else None
    return output is not None and _has_elements(output)


def _has_elements(output):
    kinds = range(vtkDataObject.NUMBER_OF_ATTRIBUTE_TYPES)
    return any(output.GetNumberOfElements(kind) > 0 for kind in kinds)


def depth_of_package():
    """The stack level, for a warning of the caller, of the first function outside the package."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and f"{frame.f_globals.get('__package__')}.".startswith(f"{__package__}."):
        frame, level = frame.f_back, level + 1
    return level


def _messages(reports, failed):
    """The reasons of a failure; never empty."""
    reasons = [text for text in reports.errors if not _NO_REASON.search(text)]
    # Some readers of VTK fail with a mere warning.
    if reasons or reports.warnings:
        return reasons or reports.warnings
    texts = []
    for node in failed:
        text = vtkErrorCode.GetStringFromErrorCode(node.GetErrorCode())
        texts.append(f"{node.GetClassName()}: error code {node.GetErrorCode()} ({text})")
    return texts or [f"{node.GetClassName()}: failed without a message" for node in reports.nodes]


def _clean(text):
    return _ADDRESS.sub("", _PLACE.sub("", text or "")).strip()
