"""Errors and progress of VTK algorithms, as Python has them."""

from __future__ import annotations

import signal
import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

from .files.errors import PackingFileError

if TYPE_CHECKING:
    from collections.abc import Iterator


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
        """Take an error, as VTK's observer."""
        self.messages.append(text.strip())

    def raise_if_any(self, message: str | None) -> None:
        """Raise PackingFileError with `message`, else with what has come since the last call."""
        collected = "\n".join(self.messages)
        self.messages.clear()
        if message or collected:
            raise PackingFileError(message or collected)


class _Bar:
    """Observer of ProgressEvent that draws on stderr once the work has taken `delay` seconds."""

    def __init__(self, label: str, delay: float) -> None:
        self.label = label
        self.show_after = time.monotonic() + delay
        # A bar that was not asked for leaves nothing behind.
        self.transient = delay > 0.0
        self.progress = None
        self.task = None
        self.interrupted = False

    def __call__(self, algorithm: object, _event: str) -> None:
        if self.interrupted:
            algorithm.SetAbortExecute(1)
            return  # VTK says that all is done when it stops
        if self.progress is None:
            if time.monotonic() < self.show_after:
                return
            from rich.console import Console
            from rich.progress import Progress

            self.progress = Progress(console=Console(stderr=True), transient=self.transient)
            self.task = self.progress.add_task(self.label, total=1.0)
            self.progress.start()
        self.progress.update(self.task, completed=algorithm.GetProgress())

    def interrupt(self, _signal: int, _frame: object) -> None:
        # Python code cannot be left by an exception while VTK calls it: ask VTK to stop first.
        self.interrupted = True

    def stop(self) -> None:
        if self.progress is not None:
            self.progress.stop()


@contextmanager
def progress_bar(algorithm: object, label: str, delay: float = 0.0) -> Iterator[None]:
    """Show the progress of `algorithm` on stderr while the block runs.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        Algorithm that is updated in the block.
    label : str
        Text in front of the bar.
    delay : float, default: 0.0
        Seconds before the bar appears, so that short work shows none.

    Raises
    ------
    KeyboardInterrupt
        If Ctrl-C was pressed meanwhile; the algorithm has been told to abort.
    """
    bar = _Bar(label, delay)
    tag = algorithm.AddObserver("ProgressEvent", bar)
    main = threading.current_thread() is threading.main_thread()
    previous = signal.signal(signal.SIGINT, bar.interrupt) if main else None
    try:
        yield
    finally:
        bar.stop()
        algorithm.RemoveObserver(tag)
        if main:
            signal.signal(signal.SIGINT, previous)
    if bar.interrupted:
        raise KeyboardInterrupt
