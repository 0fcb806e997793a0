"""Errors and progress of VTK algorithms, the way Python has them."""

from __future__ import annotations

import signal
import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import FrameType, TracebackType
    from typing import Any, Self

    import pyvista as pv
    from rich.progress import Progress, TaskID

    from .backend import vtkRenderWindow


class Algorithm(Protocol):
    """What the algorithms of this package have in common: a vtkAlgorithm that keeps its error."""

    def AddObserver(self, event: str, observer: Callable[..., None], /) -> int:
        """Call `observer` at an event, and return a tag."""

    def RemoveObserver(self, tag: int, /) -> None:
        """Remove the observer of that tag."""

    def GetExecutive(self) -> Any:
        """Return the object that updates the pipeline."""

    def GetErrorMessage(self) -> str | None:
        """Return the sentence that says what went wrong; empty or None if nothing did."""

    def GetProgress(self) -> float:
        """Return how much is done, from 0 to 1."""

    def SetAbortExecute(self, stop: int, /) -> None:
        """Ask it to stop."""

    def Update(self) -> None:
        """Run it, unless its output is up to date."""


def window_of(plotter: pv.BasePlotter) -> vtkRenderWindow:
    """The window of a plotter, or a RuntimeError once it has been closed."""
    if plotter.render_window is None:
        raise RuntimeError("this plotter has been closed, make a new one")
    return plotter.render_window


class ErrorLog:
    """Collects what an algorithm reports through ``vtkErrorMacro`` while a block runs.

    VTK hands an error to the observers of the object that reports it, and prints it only when there
    are none. The pipeline's executive adds an error of its own to each failed update, so it is
    observed as well.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        Object to observe.

    Attributes
    ----------
    messages : list of str
        What has been reported.
    """

    # Tells VTK's Python layer to pass the text on.
    CallDataType = "string0"

    def __init__(self, algorithm: Algorithm) -> None:
        self.messages: list[str] = []
        self._sources = (algorithm, algorithm.GetExecutive())
        self._tags: list[int] = []

    def __enter__(self) -> Self:
        self._tags = [source.AddObserver("ErrorEvent", self) for source in self._sources]
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        for source, tag in zip(self._sources, self._tags, strict=True):
            source.RemoveObserver(tag)

    def __call__(self, _caller: object, _event: str, text: str) -> None:
        """Collect an error; VTK calls this."""
        self.messages.append(text.strip())


@contextmanager
def errors_raised(algorithm: Algorithm, error: type[Exception] = ValueError) -> Iterator[None]:
    """Raise what an algorithm reports in the block, instead of printing it.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        Algorithm of this package that works in the block.
    error : type, default: ValueError
        Kind of exception. Its message is the algorithm's own sentence, or else VTK's text.
    """
    with ErrorLog(algorithm) as log:
        yield
    message = algorithm.GetErrorMessage() or "\n".join(log.messages)
    if message:
        raise error(message)


def update(algorithm: Algorithm, label: str, *, progress: bool) -> None:
    """Run an algorithm of this package.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        Algorithm to update.
    label : str
        Text in front of the progress bar.
    progress : bool
        Show a progress bar.

    Raises
    ------
    ValueError
        If the algorithm reports an error.
    KeyboardInterrupt
        If Ctrl-C was pressed.
    """
    with errors_raised(algorithm), progress_bar(algorithm, label, 0.0 if progress else None):
        algorithm.Update()


class _Bar:
    """Observer of ProgressEvent that draws on stderr once the work has taken `delay` seconds."""

    def __init__(self, label: str, delay: float | None) -> None:
        self.label = label
        self.show_after = float("inf") if delay is None else time.monotonic() + delay
        # A bar that was not asked for leaves nothing behind.
        self.transient = delay is None or delay > 0.0
        self.progress: Progress | None = None
        self.task: TaskID | None = None
        self.interrupted = False

    def __call__(self, algorithm: Algorithm, _event: str) -> None:
        if self.interrupted:
            algorithm.SetAbortExecute(1)
            return  # VTK reports a progress of 1 when it stops
        if self.progress is None or self.task is None:
            if time.monotonic() < self.show_after:
                return
            from rich.console import Console
            from rich.markup import escape
            from rich.progress import Progress

            self.progress = Progress(console=Console(stderr=True), transient=self.transient)
            self.task = self.progress.add_task(escape(self.label), total=1.0)
            self.progress.start()
        self.progress.update(self.task, completed=algorithm.GetProgress())

    def interrupt(self, _signal: int, _frame: FrameType | None) -> None:
        # Upstream: VTK's vtkPythonCommand ends the process ("Caught a Ctrl-C within python, exiting
        # program") when KeyboardInterrupt leaves an observer:
        # https://github.com/marcomusy/vedo/issues/1101. So the algorithm is asked to stop, and the
        # exception comes after that.
        self.interrupted = True

    def stop(self) -> None:
        if self.progress is not None:
            self.progress.stop()


@contextmanager
def progress_bar(algorithm: Algorithm, label: str, delay: float | None = 0.0) -> Iterator[None]:
    """Let Ctrl-C stop an algorithm that runs in the block, and show its progress on stderr.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        Algorithm that is updated in the block.
    label : str
        Text in front of the bar.
    delay : float, optional
        Seconds before the bar appears, so that short work shows none; None for no bar.

    Raises
    ------
    KeyboardInterrupt
        If Ctrl-C was pressed meanwhile; the algorithm has been asked to stop.
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
