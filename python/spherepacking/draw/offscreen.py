"""Which window VTK opens where there is no display; ``python -m`` prints it.

Imports nothing of VTK: the choice counts from the first window of the process on.
"""

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


def offscreen_window() -> str:
    """Class of VTK's window that needs no display.

    OSMesa where its library loads, which draws on any machine, else EGL; whatever the environment
    variable ``VTK_DEFAULT_OPENGL_WINDOW`` names wins.
    """
    return os.environ.get(_VARIABLE) or (
        "vtkOSOpenGLRenderWindow" if _osmesa_loads() else "vtkEGLRenderWindow"
    )


def choose_window(*, with_display: bool = False) -> None:
    """Choose the kind of VTK's windows on Linux, by the variable ``VTK_DEFAULT_OPENGL_WINDOW``.

    Has to run before the first window of the process is made.

    Parameters
    ----------
    with_display : bool, default: False
        Choose one that needs no display even if there is one.
    """
    display = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if sys.platform.startswith("linux") and (with_display or not display):
        os.environ[_VARIABLE] = offscreen_window()


if __name__ == "__main__":
    print(offscreen_window())
