"""The VTK classes of this package, on the VTK that PyVista runs on.

The only place that imports VTK. Two VTKs in one process do not share objects, so the VTK that the
extension was linked with at build time and the VTK behind PyVista have to be the same one. Import
from here inside functions, so that a mismatch surfaces as an ImportError where it is used, rather
than as PyVista's warning about a plugin that failed to load.
"""

from __future__ import annotations

import importlib
import os
from typing import TYPE_CHECKING

import pyvista as pv

from .build_config import VTK_ROOT, VTK_VERSION

_NAMES = {
    "cvista": f"cvista (VTK {VTK_VERSION})",
    "vtkmodules": f"stock VTK {VTK_VERSION}",
}


def _pyvista_root() -> str:
    """Top-level package of the VTK that PyVista runs on."""
    # The root class: cvista's Python overrides of others call themselves vtkmodules' too.
    root = next(c for c in pv.PolyData.__mro__ if c.__name__ == "vtkObjectBase")
    return root.__module__.partition(".")[0]


def _check(built: str, running: str) -> None:
    """Raise an ImportError that says what to do unless both roots are the same."""
    if built == running:
        return
    variable = "vtk" if built == "vtkmodules" else built
    install = "vtk" if built == "vtkmodules" else "'pyvista[cvista]>=0.49'"
    raise ImportError(
        f"spherepacking was built with {_NAMES.get(built, built)}, but PyVista runs on {running}. "
        f"Set the environment variable PYVISTA_VTK_BACKEND={variable} before PyVista is imported "
        f"(pip install {install} where that VTK is missing), or build spherepacking with the "
        f"VTK of {running}."
    )


def _load(name: str) -> ModuleType:
    """Import one of the wrapped modules that the build put into the package."""
    try:
        return importlib.import_module(f"..{name}", __package__)
    except ImportError as error:
        raise ImportError(
            f"{name} of spherepacking does not load: {error}. It was built with "
            f"{_NAMES.get(VTK_ROOT, VTK_ROOT)}; install that version or build spherepacking again."
        ) from error


_check(VTK_ROOT, _pyvista_root())

if TYPE_CHECKING:
    from types import ModuleType

    # Stock VTK's stubs, since cvista brings none; its classes are the same. Some are here for
    # signatures alone.
    from vtkmodules.vtkCommonCore import (
        reference,
        vtkAbstractArray,
        vtkDataArray,
        vtkSMPTools,
        vtkUnsignedCharArray,
    )
    from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkDomainsChemistry import vtkPeriodicTable
    from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
    from vtkmodules.vtkIOCore import vtkLZ4DataCompressor
    from vtkmodules.vtkRenderingCore import (
        vtkCamera,
        vtkGlyph3DMapper,
        vtkPolyDataMapper,
        vtkRenderPass,
        vtkRenderWindow,
    )
    from vtkmodules.vtkRenderingOpenGL2 import (
        vtkOpaquePass,
        vtkOpenGLSphereMapper,
        vtkRenderPassCollection,
        vtkRenderStepsPass,
        vtkSequencePass,
    )

    from ..vtkSpherePackingCore import (
        vtkMetaballField,
        vtkSpherePacker,
        vtkSpherePackingBoxAlgorithm,
        vtkSpherePackingBVH,
        vtkSpherePackingContacts,
        vtkSpherePackingGrid,
        vtkSpherePackingInput,
        vtkSpherePackingPathTracer,
        vtkSpherePackingReader,
        vtkSpherePackingTracer,
        vtkSpherePackingWriter,
    )
    from ..vtkSpherePackingRendering import (
        vtkOpenGLSpherePackingMapper,
        vtkSpherePackingPicturePass,
        vtkSpherePackingTiles,
        vtkSpherePackingWindowCheck,
    )
else:
    # The rendering backend registers its object factory overrides when it is imported, and the
    # extension's libraries find VTK's through it.
    _opengl = importlib.import_module(f"{VTK_ROOT}.vtkRenderingOpenGL2")
    vtkOpaquePass = _opengl.vtkOpaquePass
    # Stock VTK has it, cvista does not.
    vtkOpenGLSphereMapper = getattr(_opengl, "vtkOpenGLSphereMapper", None)
    vtkRenderPassCollection = _opengl.vtkRenderPassCollection
    vtkRenderStepsPass = _opengl.vtkRenderStepsPass
    vtkSequencePass = _opengl.vtkSequencePass

    # Upstream: PyVista 0.49 pickles datasets, on cvista by what registers itself when this module
    # is imported, which PyVista does later.
    importlib.import_module(f"{VTK_ROOT}.vtkIOLegacy")

    # How a number comes back from a C++ reference.
    _common_core = importlib.import_module(f"{VTK_ROOT}.vtkCommonCore")
    reference = _common_core.reference
    vtkSMPTools = _common_core.vtkSMPTools
    vtkUnsignedCharArray = _common_core.vtkUnsignedCharArray
    _data_model = importlib.import_module(f"{VTK_ROOT}.vtkCommonDataModel")
    vtkDataObject = _data_model.vtkDataObject
    vtkPolyData = _data_model.vtkPolyData
    vtkStreamingDemandDrivenPipeline = importlib.import_module(
        f"{VTK_ROOT}.vtkCommonExecutionModel"
    ).vtkStreamingDemandDrivenPipeline
    vtkPeriodicTable = importlib.import_module(f"{VTK_ROOT}.vtkDomainsChemistry").vtkPeriodicTable
    vtkFlyingEdges3D = importlib.import_module(f"{VTK_ROOT}.vtkFiltersCore").vtkFlyingEdges3D
    vtkLZ4DataCompressor = importlib.import_module(f"{VTK_ROOT}.vtkIOCore").vtkLZ4DataCompressor
    _rendering_core = importlib.import_module(f"{VTK_ROOT}.vtkRenderingCore")
    vtkCamera = _rendering_core.vtkCamera
    vtkGlyph3DMapper = _rendering_core.vtkGlyph3DMapper

    _core = _load("vtkSpherePackingCore")
    vtkMetaballField = _core.vtkMetaballField
    vtkSpherePacker = _core.vtkSpherePacker
    vtkSpherePackingBVH = _core.vtkSpherePackingBVH
    vtkSpherePackingContacts = _core.vtkSpherePackingContacts
    vtkSpherePackingGrid = _core.vtkSpherePackingGrid
    vtkSpherePackingInput = _core.vtkSpherePackingInput
    vtkSpherePackingPathTracer = _core.vtkSpherePackingPathTracer
    vtkSpherePackingReader = _core.vtkSpherePackingReader
    vtkSpherePackingTracer = _core.vtkSpherePackingTracer
    vtkSpherePackingWriter = _core.vtkSpherePackingWriter
    _rendering = _load("vtkSpherePackingRendering")
    vtkOpenGLSpherePackingMapper = _rendering.vtkOpenGLSpherePackingMapper
    vtkSpherePackingPicturePass = _rendering.vtkSpherePackingPicturePass
    vtkSpherePackingTiles = _rendering.vtkSpherePackingTiles
    vtkSpherePackingWindowCheck = _rendering.vtkSpherePackingWindowCheck

if hasattr(os, "register_at_fork"):
    # A forked child has none of the threads of VTK's pool, and would wait for them for ever.
    os.register_at_fork(after_in_child=lambda: vtkSMPTools.SetBackend("Sequential"))
