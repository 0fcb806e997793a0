"""See sphere packings: exact ray-cast spheres for VTK and PyVista.

A packing is a :class:`pyvista.PolyData` whose points are the centres of the spheres and whose
point array ``radius`` holds their radii. With this package installed, ``pyvista.read`` reads
packing files, every ``PolyData`` has an accessor ``packing`` and every plotter a component
``packing``; importing it is only needed for what is listed here.
"""

from __future__ import annotations

import importlib

__all__ = [
    "PackingFileError",
    "Sun",
    "apollonian",
    "compare_images",
    "pack",
    "read",
    "read_image",
    "write",
    "write_image",
    "write_render",
]

# Nothing is imported before it is used: the command line answers at once, and importing this
# package does not decide which VTK PyVista runs on.
_HOMES = {
    "PackingFileError": ".files.errors",
    "Sun": ".trace.sky",
    "apollonian": ".make.apollonian",
    "compare_images": ".files.image",
    "pack": ".make.pack",
    "read": ".files.readers",
    "read_image": ".files.image",
    "write": ".files.writers",
    "write_image": ".files.image",
    "write_render": ".files.exr",
}


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version

        return version("spherepacking")
    if name in _HOMES:
        return getattr(importlib.import_module(_HOMES[name], __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *_HOMES, "__version__"])
