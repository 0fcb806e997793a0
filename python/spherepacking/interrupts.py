"""Ctrl-C while C++ is at work: held back until that has returned, then raised.

Upstream: VTK's vtkPythonCommand ends the process ("Caught a Ctrl-C within python, exiting program")
when KeyboardInterrupt leaves an observer: https://github.com/marcomusy/vedo/issues/1101. Python
runs the handler of a signal before the next bytecode, and while VTK works that is an observer's. So
whatever calls VTK with observers does so in the block of :class:`InterruptsHeld`, where the handler
raises nothing but asks the work to stop; the end of the block raises.

What VTK calls outside such a block, in a rendering, is announced by :func:`held_in`, and
:func:`deliver_after` lets the interruption come where the rendering was called.
"""

from __future__ import annotations

import ctypes
import signal
import sys
import threading
from functools import wraps
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import CodeType, FrameType, TracebackType
    from typing import Any, Self


class Interruptible(Protocol):
    """A vtkAlgorithm."""

    def AddObserver(self, event: str, observer: Callable[..., None], /) -> int:
        """Call `observer` at an event, and return a tag."""

    def RemoveObserver(self, tag: int, /) -> None:
        """Remove the observer of that tag."""

    def SetAbortExecute(self, stop: int, /) -> None:
        """Ask it to stop."""


class _Handler:
    """The handler of SIGINT while interruptions may have to be held.

    It calls the handler that was there before, so that what Ctrl-C means remains the user's: one
    that raises interrupts, with its own exception; after one that returns the work goes on.
    """

    def __init__(self) -> None:
        self.depth = 0  # blocks that hold interruptions
        self.pictures = 0  # for whose renderings the handler stays
        self.at_work: list[Interruptible] = []
        self.raised: BaseException | None = None
        self.observers: set[CodeType] = set()
        self._previous: Callable[[int, FrameType | None], Any] = signal.default_int_handler
        self._calling = False

    def __call__(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal; Python calls this in the main thread."""
        if self.depth == 0 and not self.in_observer(frame):
            held, self.raised = self.raised, None
            if held is not None:
                raise held
            self._call_previous(number, frame)
            return
        try:
            self._call_previous(number, frame)
        except BaseException as error:  # SystemExit would end the process as well
            self.raised = error
            for algorithm in self.at_work:
                algorithm.SetAbortExecute(1)

    def _call_previous(self, number: int, frame: FrameType | None) -> None:
        if self._calling:
            # A handler that was put over this one calls it.
            signal.default_int_handler(number, frame)
        self._calling = True
        try:
            self._previous(number, frame)
        finally:
            self._calling = False

    def in_observer(self, frame: FrameType | None) -> bool:
        """Whether VTK has called what `frame` belongs to."""
        while frame is not None:
            if frame.f_code in self.observers:
                return True
            frame = frame.f_back
        return False

    def install(self) -> None:
        """Become the handler of SIGINT, unless the system handles it or it is ignored."""
        if threading.current_thread() is not threading.main_thread():
            return
        current = signal.getsignal(signal.SIGINT)
        if current is not self and callable(current):
            self._previous = current
            signal.signal(signal.SIGINT, self)

    def remove(self) -> None:
        """Leave SIGINT to the handler before, unless somebody else has taken it."""
        # A picture may be closed by the garbage collector of any thread.
        main = threading.current_thread() is threading.main_thread()
        if main and self.pictures == 0 and isinstance(signal.getsignal(signal.SIGINT), _Handler):
            signal.signal(signal.SIGINT, self._previous)


_handler = _Handler()


class InterruptsHeld:
    """Block in which Ctrl-C raises nothing, but stops algorithms; its end raises.

    In other threads than the main one, which get no signals, it does nothing.

    Parameters
    ----------
    *algorithms : vtkAlgorithm
        What is at work in the block. Its ProgressEvent is observed, which lets Python see to
        signals while C++ works.

    Raises
    ------
    KeyboardInterrupt
        At the end of the block, if Ctrl-C was pressed; another exception if the handler of SIGINT
        raises another.
    """

    def __init__(self, *algorithms: Interruptible) -> None:
        self._algorithms = algorithms
        self._tags: list[int] = []
        self._main = False

    def __enter__(self) -> Self:
        self._main = threading.current_thread() is threading.main_thread()
        if self._main:
            # Nothing is called between, so that no signal is handled between.
            _handler.depth += 1
            try:
                self._begin()
            except BaseException:
                _handler.depth -= 1
                raise
        return self

    def _begin(self) -> None:
        _handler.install()
        _handler.at_work.extend(self._algorithms)
        self._tags = [a.AddObserver("ProgressEvent", _listen) for a in self._algorithms]

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if not self._main:
            return
        for algorithm, tag in zip(self._algorithms, self._tags, strict=True):
            algorithm.RemoveObserver(tag)
            _handler.at_work.remove(algorithm)
            if _handler.raised is not None:
                # That it was to stop holds for this time alone; VTK does not always forget it.
                algorithm.SetAbortExecute(0)
        if _handler.depth > 1 or _handler.in_observer(sys._getframe()):
            # What is around has to come to its end as well, and raises it again.
            _handler.depth -= 1
            if _handler.raised is not None:
                raise _handler.raised
            return
        try:
            _handler.remove()
        finally:
            # From the removal on the handler before raises at any call, so that there is none here.
            _handler.depth -= 1
            held, _handler.raised = _handler.raised, None
            if held is not None:
                raise held


def interrupts_held[**Given, Result](function: Callable[Given, Result]) -> Callable[Given, Result]:
    """Decorate a function whose time goes into C++: Ctrl-C is raised when it returns.

    So no lock, no object of PyVista's and no destructor meets it halfway.
    """

    @wraps(function)
    def held(*args: Given.args, **kwargs: Given.kwargs) -> Result:
        with InterruptsHeld():
            return function(*args, **kwargs)

    return held


def _listen(algorithm: Interruptible, _event: str) -> None:
    """Let Python handle signals; VTK calls this."""
    if _handler.raised is not None:
        # Again, since VTK forgets it at the begin of its work.
        algorithm.SetAbortExecute(1)


# --- renderings -----------------------------------------------------------------------------------


def held_in[Observer: Callable[..., None]](observer: Observer) -> Observer:
    """Decorate a function that VTK calls in renderings: Ctrl-C raises nothing in it."""
    _handler.observers.add(observer.__code__)
    return observer


def is_held(error: BaseException | None = None) -> bool:
    """Whether an interruption, or that of `error`, will be raised later."""
    return _handler.raised is not None and error in (None, _handler.raised)


class InterruptsOfPicture:
    """Holds interruptions in the renderings of a picture, until it is closed."""

    def __init__(self) -> None:
        self._open = True
        _handler.pictures += 1
        _handler.install()

    def renew(self) -> None:
        """Take SIGINT again, if somebody has put another handler in place, as notebooks do."""
        _handler.install()

    def close(self) -> None:
        """Leave SIGINT as it was, when the last picture is closed."""
        if self._open:
            self._open = False
            _handler.pictures -= 1
            _handler.remove()


class _Signal:
    """Argument of raise(3): SIGINT if an interruption is held, else none."""

    _YES, _NO = ctypes.c_int(signal.SIGINT), ctypes.c_int(0)

    @classmethod
    def from_param(cls, _caller: object) -> ctypes.c_int:
        """Choose the argument; ctypes calls this.

        After its first bytecode nothing is called, so that no signal is handled unseen.
        """
        return cls._NO if _handler.raised is None else cls._YES


_handler.observers.add(_Signal.from_param.__func__.__code__)  # type: ignore[attr-defined]


def deliver_after() -> Callable[..., None]:
    """Make an observer, to come after one with :func:`held_in`, that sends SIGINT once more.

    It is a function of C: no bytecode follows in the observer, and Python handles the signal where
    VTK was called.
    """
    observer = ctypes.CDLL(None)["raise"]
    # What ctypes asks for is `from_param` alone.
    observer.argtypes = (_Signal, ctypes.py_object)  # type: ignore[assignment]
    observer.restype = None
    return observer
