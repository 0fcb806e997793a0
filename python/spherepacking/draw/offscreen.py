"""How to draw where there is no display."""

from __future__ import annotations

import ctypes
import os
import sys

_VARIABLE = "VTK_DEFAULT_OPENGL_WINDOW"


def _osmesa_loads() -> bool:
    for name in ("libOSMesa.so.8", "libOSMesa.so", "libOSMesa.so.6"):
        try:
            ctypes.CDLL(name)
        except OSError:
            continue
        return True
    return False


def choose_window() -> None:
    """Choose the kind of VTK's windows on a Linux machine without a display.

    OSMesa where its library loads, which draws on any machine, else EGL. Has to run before the
    first window of the process is made. The environment variable ``VTK_DEFAULT_OPENGL_WINDOW`` is
    respected when it is set, and set otherwise.
    """
    display = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if not sys.platform.startswith("linux") or display or os.environ.get(_VARIABLE):
        return
    kind = "vtkOSOpenGLRenderWindow" if _osmesa_loads() else "vtkEGLRenderWindow"
    os.environ[_VARIABLE] = kind
