"""Errors and progress of VTK algorithms, the way Python has them."""

from __future__ import annotations

import time
from contextlib import contextmanager, nullcontext
from typing import TYPE_CHECKING, Protocol

from .interrupts import Interruptible, InterruptsHeld, is_held

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from types import TracebackType
    from typing import Any, Self

    import pyvista as pv
    from rich.progress import Progress, TaskID

    from .backend import vtkRenderWindow


class Algorithm(Interruptible, Protocol):
    """What the algorithms of this package have in common: a vtkAlgorithm that keeps its error."""

    def GetExecutive(self) -> Any:
        """Return the object that updates the pipeline."""

    def GetErrorMessage(self) -> str | None:
        """Return the sentence that says what went wrong; empty or None if nothing did."""

    def GetProgress(self) -> float:
        """Return how much is done, from 0 to 1."""

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
    observed as well. Ctrl-C in the block stops the algorithm, and the end of the block raises.

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
        self._interrupts = InterruptsHeld(algorithm)

    def __enter__(self) -> Self:
        self._interrupts.__enter__()
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
        self._interrupts.__exit__(kind, error, traceback)

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
    bar = progress_bar(algorithm, label) if progress else nullcontext()
    with errors_raised(algorithm), bar:
        algorithm.Update()


@contextmanager
def stopped_by(algorithm: Algorithm, stop: Callable[[], bool] | None) -> Iterator[None]:
    """Ask an algorithm that runs in the block to stop, once a function says so.

    Parameters
    ----------
    algorithm : vtkAlgorithm
        Algorithm that is updated in the block.
    stop : callable, optional
        Asked whenever there is progress, in the thread that runs the algorithm. What it raises
        stops the algorithm as well, and is raised at the end of the block.
    """
    failures: list[Exception] = []

    def ask(caller: Algorithm, _event: str) -> None:
        try:
            # At the begin, while things are prepared, there would be nothing to show.
            stopped = bool(failures) or (caller.GetProgress() > 0.0 and stop is not None and stop())
        except Exception as error:
            failures.append(error)
            stopped = True
        if stopped:
            caller.SetAbortExecute(1)

    if stop is None:
        yield
        return
    tag = algorithm.AddObserver("ProgressEvent", ask)
    try:
        yield
    finally:
        algorithm.RemoveObserver(tag)
    if failures:
        raise failures[0]


class _Bar:
    """Observer of ProgressEvent that draws on stderr once the work has taken `delay` seconds."""

    def __init__(self, label: str, delay: float) -> None:
        self.label = label
        self.show_after = time.monotonic() + delay
        # A bar that was not asked for leaves nothing behind.
        self.transient = delay > 0.0
        self.progress: Progress | None = None
        self.task: TaskID | None = None

    def __call__(self, algorithm: Algorithm, _event: str) -> None:
        if is_held():
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

    def stop(self) -> None:
        if self.progress is not None:
            self.progress.stop()


@contextmanager
def progress_bar(algorithm: Algorithm, label: str, delay: float = 0.0) -> Iterator[None]:
    """Show the progress of an algorithm that runs in the block on stderr.

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
        If Ctrl-C was pressed meanwhile; the algorithm has been asked to stop.
    """
    bar = _Bar(label, delay)
    with InterruptsHeld(algorithm):
        tag = algorithm.AddObserver("ProgressEvent", bar)
        try:
            yield
        finally:
            bar.stop()
            algorithm.RemoveObserver(tag)
