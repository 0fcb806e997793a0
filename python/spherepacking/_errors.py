"""Errors of VTK objects as Python exceptions."""

from __future__ import annotations


class PackingFileError(ValueError):
    """A file is no sphere packing; the message names file and line, what was found and expected."""


class ErrorLog:
    """Collects what VTK objects report through ``vtkErrorMacro``.

    VTK hands an error to the observers of the object that reports it, and prints it only when
    there are none. The pipeline's executive adds an error of its own to each failed update, so
    it is observed as well.

    Parameters
    ----------
    *algorithms : vtkAlgorithm
        Objects to listen to for as long as they live.
    """

    # Tells VTK's Python layer to pass the text on.
    CallDataType = "string0"

    def __init__(self, *algorithms: object) -> None:
        self.messages: list[str] = []
        for algorithm in algorithms:
            algorithm.AddObserver("ErrorEvent", self)
            algorithm.GetExecutive().AddObserver("ErrorEvent", self)

    def listen_alone(self, algorithm: object) -> None:
        """Stop all others from hearing the errors of one of the objects."""
        algorithm.RemoveObservers("ErrorEvent")
        algorithm.AddObserver("ErrorEvent", self)

    def __call__(self, _caller: object, _event: str, text: str) -> None:
        self.messages.append(text.strip())

    def raise_if_any(self, message: str | None) -> None:
        """Raise PackingFileError with `message`, else with what has come since the last call."""
        collected = "\n".join(self.messages)
        self.messages.clear()
        if message or collected:
            raise PackingFileError(message or collected)
