# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Updates of VTK algorithms, whose errors become Python exceptions."""

from __future__ import annotations

import re
import warnings
from typing import Any

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonMisc import vtkErrorCode

from .errors import VTKError, depth_of_package
from .interruption import Interruption

__all__ = ["check"]

# Prefix of a message by VTK, and addresses of objects in a message.
_PLACE = re.compile(r"\A(?:ERROR|Warning): In .*, line \d+\n")
_ADDRESS = re.compile(r" ?\(0x[0-9a-fA-F]+\)")
# Messages by which an executive reports a failure without its reason.
_NO_REASON = re.compile(r"returned failure for request|No update piece number has been set")


def check(algorithm: vtkAlgorithm) -> Any:
    """Update an algorithm and raise when it, or anything upstream of it, reports an error.

    Writers write their file. The messages are in the exception, without VTK's file, line and
    address, and are not printed. After an update without errors, VTK's warnings become Python
    warnings.

    An update that an observer stops by AbortExecute is no error, as in VTK. The output is then
    empty until the stopped algorithm is modified or runs again; its ``GetAbortExecute()`` returns
    true. With VTK before 9.3, a filter whose sources come from the stopped algorithm reports that
    it has none. Ctrl-C stops an update with a KeyboardInterrupt, after which the algorithm can be used
    again. Other Python threads run during the update.

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
        When an error was reported. Later calls raise it again until its cause is removed.
    TypeError
        When `algorithm` is not a vtkAlgorithm.

    Examples
    --------
    >>> mesh = vtkdgg.check(reader)
    """
    if not isinstance(algorithm, vtkAlgorithm):
        raise TypeError(f"check(): expected a vtkAlgorithm, got {type(algorithm).__name__}")
    pipeline = _upstream(algorithm)
    reports = _update(algorithm, pipeline)
    if not reports.errors and _failed(pipeline):
        # An earlier update failed, and its messages are lost. Another update repeats them.
        for node in _failed(pipeline):
            node.Modified()
        reports = _update(algorithm, pipeline)
    failed = [node for node in _failed(pipeline) if not _recovered(node, reports)]
    if reports.errors or failed:
        # Failed algorithms must run again in the next update, even without a change.
        for node in reports.nodes + failed:
            node.Modified()
        raise VTKError(_messages(reports, failed), failed[0].GetErrorCode() if failed else 0)
    for text in reports.warnings:
        warnings.warn(text, RuntimeWarning, stacklevel=depth_of_package())
    if algorithm.GetNumberOfOutputPorts() == 0:
        return None
    return algorithm.GetOutputDataObject(0)


class _Reports:
    """Messages of the algorithms of a pipeline during one update."""

    def __init__(self):
        self.errors = []
        self.warnings = []
        self.nodes = []  # algorithms that reported an error


def _upstream(algorithm):
    """Returns the algorithm and all algorithms upstream, sources first."""
    # Without recursion: a nested recursive function is a reference cycle, which would keep the
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


def _update(algorithm, pipeline):
    reports = _Reports()
    interruption = Interruption()

    def watch(target, node):
        def on_error(caller, event, text):
            reports.errors.append(_clean(text))
            reports.nodes.append(node)

        def on_warning(caller, event, text):
            reports.warnings.append(_clean(text))

        on_error.CallDataType = "string0"
        on_warning.CallDataType = "string0"
        return [
            (target, target.AddObserver("ErrorEvent", on_error)),
            (target, target.AddObserver("WarningEvent", on_warning)),
        ]

    stopped = []

    def on_progress(caller, event):
        # Other Python threads and signal handlers run here: wrappers of VTK hold the interpreter
        # lock, which Python code releases when other threads wait for it.
        if interruption.raised:
            caller.SetAbortExecute(1)
            stopped.append(caller)

    watched = []
    for node in pipeline:
        if node.IsA("vtkTrivialProducer"):
            continue  # provides data without a pipeline
        watched += watch(node, node)
        watched.append((node, node.AddObserver("ProgressEvent", on_progress)))
        # Executives report wrong connections.
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
    if interruption.raised:
        for node in stopped:
            # Modifies the node, so that it runs again. VTK 9.3 and later do not clear the flag.
            node.SetAbortExecute(0)
        raise interruption.raised
    return reports


def _failed(pipeline):
    return [node for node in pipeline if node.GetErrorCode() != vtkErrorCode.NoError]


def _recovered(node, reports):
    """Returns true for a reader that has kept the error code of a failure before its success."""
    if node in reports.nodes or reports.errors or reports.warnings:
        return False
    output = node.GetOutputDataObject(0) if node.GetNumberOfOutputPorts() > 0 else None
    kinds = range(vtkDataObject.NUMBER_OF_ATTRIBUTE_TYPES)
    return output is not None and any(output.GetNumberOfElements(kind) > 0 for kind in kinds)


def _messages(reports, failed):
    """Returns the reasons of a failure; never empty."""
    reasons = [text for text in reports.errors if not _NO_REASON.search(text)]
    # Some readers of VTK fail with a warning only.
    if reasons or reports.warnings:
        return reasons or reports.warnings
    texts = []
    for node in failed:
        text = vtkErrorCode.GetStringFromErrorCode(node.GetErrorCode())
        texts.append(f"{node.GetClassName()}: error code {node.GetErrorCode()} ({text})")
    return texts or [f"{node.GetClassName()}: failed without a message" for node in reports.nodes]


def _clean(text):
    return _ADDRESS.sub("", _PLACE.sub("", text or "")).strip()
