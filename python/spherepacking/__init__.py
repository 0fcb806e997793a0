"""See sphere packings: exact ray-cast spheres for VTK and PyVista.

A packing is a :class:`pyvista.PolyData`: its points are the centres of the spheres, its point array
``radius`` holds their radii. PyVista finds this package by itself, it need not be imported for:

- ``pyvista.read(path)`` and ``packing.save(path)``: files of packings
- ``packing.packing``: the accessor, with ``ray_cast``, ``path_trace``, ``pick``, ``metaballs``,
  ``metaball_field``, ``bvh_boxes``, ``grid_boxes``, ``contacts``, ``wrap``, ``replicate``,
  ``ghosts``, ``bounds``, ``plot``; see PackingAccessor
- ``plotter.packing``: the component, with ``add``, ``add_contacts``, ``add_metaballs``,
  ``path_trace``, ``screenshot``; see PackingComponent

Functions, all in ``spherepacking``:

- reading and writing: ``read``, ``steps`` for the steps of a run, ``write``
- packing: ``pack`` fills a closed surface, ``apollonian`` makes the Apollonian packing
- pictures: ``read_image``, ``write_image``, ``write_render``, ``compare_images``

``spherepacking --help`` describes the command line.
"""

from __future__ import annotations

import importlib
import sys

TYPE_CHECKING = False  # as in typing, which is not imported for that alone
if TYPE_CHECKING:
    from .accessor import PackingAccessor
    from .draw.mapper import SpherePackingMapper
    from .files.errors import PackingFileError
    from .files.exr import write_render
    from .files.image import ImageDifference, compare_images, read_image, write_image
    from .files.readers import SpherePackingReader
    from .files.steps import PackingSteps, read, steps
    from .files.writers import write
    from .make.apollonian import apollonian
    from .make.pack import pack
    from .metaballs.actor import Metaballs
    from .plotter import PackingComponent
    from .trace.live import LivePicture
    from .trace.ray_cast import Pick
    from .trace.sky import Sun

    __version__: str

__all__ = [
    "ImageDifference",
    "LivePicture",
    "Metaballs",
    "PackingAccessor",
    "PackingComponent",
    "PackingFileError",
    "PackingSteps",
    "Pick",
    "SpherePackingMapper",
    "SpherePackingReader",
    "Sun",
    "apollonian",
    "compare_images",
    "pack",
    "read",
    "read_image",
    "steps",
    "write",
    "write_image",
    "write_render",
]

# Nothing is imported before it is used: the command line answers at once, and importing this
# package does not decide which VTK PyVista runs on.
_HOMES = {
    "ImageDifference": ".files.image",
    "LivePicture": ".trace.live",
    "Metaballs": ".metaballs.actor",
    "PackingAccessor": ".accessor",
    "PackingComponent": ".plotter",
    "PackingFileError": ".files.errors",
    "PackingSteps": ".files.steps",
    "Pick": ".trace.ray_cast",
    "SpherePackingMapper": ".draw.mapper",
    "SpherePackingReader": ".files.readers",
    "Sun": ".trace.sky",
    "apollonian": ".make.apollonian",
    "compare_images": ".files.image",
    "pack": ".make.pack",
    "read": ".files.steps",
    "read_image": ".files.image",
    "steps": ".files.steps",
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
    return sorted({*__all__, "__version__", *(name for name in globals() if name[:2] == "__")})


def _has_been_imported(name: str) -> bool:
    module = sys.modules.get(name)
    return module is not None and not getattr(module.__spec__, "_initializing", False)


# Upstream: PyVista 0.49 imports an accessor at its first use, and raises KeyError or AttributeError
# where several threads use it first. Nobody waits for that where PyVista is there already.
if _has_been_imported("pyvista"):
    for _home in (".accessor", ".plotter"):
        importlib.import_module(_home, __name__)
