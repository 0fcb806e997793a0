"""A path-traced picture in a plotter, which becomes better while nothing moves."""

from __future__ import annotations

import _thread
import threading
import time
import weakref
from typing import TYPE_CHECKING

import pyvista as pv

from .. import checks as arguments
from ..accessor import PackingAccessor

if TYPE_CHECKING:
    from ..backend import vtkRenderStepsPass

_TICK = 10  # milliseconds between two looks at whether the camera rests
_REST = 0.03  # seconds after which it does


class LivePicture:
    """Spheres of a plotter that are seen in the light of a sky, as ``plotter.packing.path_trace``.

    While the camera moves the mapper draws them; when it rests their picture is traced, in steps,
    and shown instead, among all that else is in the scene. Offscreen every rendering shows the
    finished picture. An actor that has been moved or made transparent is left to the mapper.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        The plotter.
    actor : pyvista.Actor
        The spheres, drawn by the mapper.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    samples : int
        Samples a pixel, at the end.
    step : float
        Seconds between two pictures while it becomes better.
    words : dict
        Other arguments of ``packing.packing.path_trace``.
    """

    def __init__(
        self,
        plotter: pv.BasePlotter,
        actor: pv.Actor,
        packing: pv.PolyData,
        samples: int,
        step: float,
        words: dict[str, object],
    ) -> None:
        from ..backend import vtkSpherePackingPicturePass

        self.actor = actor
        self.samples = 0
        """Samples that each pixel of the picture has at least."""
        self.error: Exception | None = None
        """What stopped the tracing in the last rendering, which shows the mapper's spheres."""
        self._plotter = weakref.ref(plotter)
        self._renderer = plotter.renderer
        self._packing = packing
        self._spheres = PackingAccessor(packing)
        self._samples, self._step, self._words = samples, step, words
        self._picture = vtkSpherePackingPicturePass()
        self._steps = _steps_with(self._picture)
        self._renderer.SetPass(self._steps)
        # What the picture that is shown was made of, and what the last rendering was of.
        self._view: tuple[object, ...] | None = None
        self._last: tuple[object, ...] | None = None
        self._moved = 0.0
        self._complete = False
        self._tags = [(self._renderer, self._renderer.AddObserver("StartEvent", self._before))]
        self._timer = None

    @property
    def shown(self) -> bool:
        """Whether there is a picture of the present view, be it a preview."""
        return self._view is not None and self._view == self._present()

    @property
    def finished(self) -> bool:
        """Whether the picture of the present view has all samples that it will get."""
        return self._complete and self.shown

    def refine(self, seconds: float | None = None) -> int:
        """Trace more of the picture of the present view; the next rendering shows it.

        Parameters
        ----------
        seconds : float, optional
            How long that may take; by default until it is finished.

        Returns
        -------
        int
            Samples that each pixel has now at least; 0 if some show their neighbours' light.

        Raises
        ------
        RuntimeError
            If it has been closed.
        """
        if self._renderer is None:
            raise RuntimeError("this picture has been closed, make a new one")
        image = self._spheres.path_trace(
            self._renderer.camera,
            self._renderer.GetSize(),
            samples=self._samples,
            time_budget=seconds,
            preview=seconds is not None,
            sky_visible=False,
            **self._words,
        )
        # These two alone, since the tracer goes on with copies of all that is still held.
        picture = pv.ImageData(dimensions=image.dimensions)
        for name in ("color", "depth"):
            picture.GetPointData().AddArray(image.GetPointData().GetArray(name))
        self._picture.SetPicture(picture)
        # Not before: VTK may have learned of changes only now.
        self._view = self._present()
        self.samples = int(image["samples"].min())
        # With a noise target parts of the picture get fewer.
        nothing_left = seconds is None or image.field_data["traced_samples"][0] == 0.0
        self._complete = self.samples >= self._samples or nothing_left
        return self.samples

    def close(self) -> None:
        """Leave the spheres to the mapper."""
        if self._renderer is None:
            return
        for source, tag in self._tags:
            source.RemoveObserver(tag)
        self._tags.clear()
        plotter = self._plotter()
        if self._timer is not None and plotter is not None and plotter.iren is not None:
            plotter.iren.destroy_timer(self._timer)
        self._timer = None
        if self._renderer.GetPass() is self._steps:
            self._renderer.SetPass(None)
        window = self._renderer.GetRenderWindow()
        if window is not None:
            self._picture.ReleaseGraphicsResources(window)
        self.actor.mapper.SetDrawn(True)
        self._view = self._renderer = self._spheres = self._packing = None

    @property
    def abandoned(self) -> bool:
        """Whether the actor is no longer in the scene."""
        return self._renderer is None or not self._renderer.HasViewProp(self.actor)

    def _present(self) -> tuple[object, ...] | None:
        """What a picture depends on."""
        if self._renderer is None:
            return None
        camera, (width, height) = self._renderer.camera, self._renderer.GetSize()
        projection = camera.GetProjectionTransformMatrix(width / max(height, 1), -1.0, 1.0)
        placing = camera.GetModelViewTransformMatrix()
        # The third row of the projection is the depth between the clipping planes.
        lines = [(projection, i) for i in (0, 1, 3)] + [(placing, i) for i in range(3)]
        numbers = tuple(matrix.GetElement(i, j) for matrix, i in lines for j in range(4))
        points = self._packing.GetPoints()
        changes = (
            points.GetMTime(),
            points.GetData().GetMTime(),
            self._packing.GetPointData().GetMTime(),
        )
        return (width, height, numbers, changes)

    def _usable(self) -> bool:
        """Whether a picture can stand for the actor, and is asked for."""
        if self._renderer.GetPass() is None:
            # Another pass has come and gone.
            self._renderer.SetPass(self._steps)
        return (
            self._renderer.GetPass() is self._steps
            and not self.abandoned
            and bool(self.actor.GetVisibility())
            and self.actor.GetMatrix().IsIdentity()
            and self.actor.prop.opacity == 1.0
        )

    def _before(self, *_: object) -> None:
        """Decide before each rendering who shows the spheres."""
        plotter = self._plotter()
        if plotter is None or self._renderer is None:
            return
        present = self._present()
        if present != self._last:
            self._last, self._moved = present, time.perf_counter()
        usable = self._usable()
        if not plotter.off_screen:
            self._start_timer(plotter)
        elif usable and not self.finished:
            self._refine_in_vtk(None)
        shown = usable and self.shown
        self.actor.mapper.SetDrawn(not shown)
        if not shown:
            self._picture.SetPicture(None)
            self._view = None
            self.samples = 0

    def _start_timer(self, plotter: pv.BasePlotter) -> None:
        if self._timer is not None or plotter.iren is None or not plotter.iren.initialized:
            return
        interactor = plotter.iren.interactor
        self._tags.append((interactor, interactor.AddObserver("TimerEvent", self._tick)))
        self._timer = plotter.iren.create_timer(_TICK, repeating=True)

    def _tick(self, *_: object) -> None:
        plotter = self._plotter()
        if plotter is None or self._renderer is None or self.error is not None:
            return
        rests = self._present() == self._last and time.perf_counter() - self._moved >= _REST
        if rests and self._usable() and not self.finished:
            self._refine_in_vtk(self._step)
            plotter.render()

    def _refine_in_vtk(self, seconds: float | None) -> None:
        """Refine while VTK calls, which ends the process at an exception of Ctrl-C."""
        self.error = None
        try:
            self.refine(seconds)
        except KeyboardInterrupt:
            # Again when VTK has returned.
            threading.Timer(0.3, _thread.interrupt_main).start()
        except (KeyError, OSError, TypeError, ValueError) as error:
            self.error = error


def _steps_with(picture: object) -> vtkRenderStepsPass:
    """VTK's own steps of rendering, with a picture after the opaque props."""
    from ..backend import (
        vtkOpaquePass,
        vtkRenderPassCollection,
        vtkRenderStepsPass,
        vtkSequencePass,
    )

    passes = vtkRenderPassCollection()
    passes.AddItem(vtkOpaquePass())
    passes.AddItem(picture)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    steps = vtkRenderStepsPass()
    steps.SetOpaquePass(sequence)
    return steps


def check_live(plotter: pv.BasePlotter, samples: int, step: float) -> tuple[int, float]:
    """Check what concerns the plotter, before it changes."""
    if plotter.renderer.GetPass() is not None:
        raise ValueError(
            "the plotter's render pass: found one, expected none: a path-traced picture goes "
            "neither with another one nor with SSAO, SSAA, depth of field and the like"
        )
    return (
        arguments.count_of("samples", samples),
        arguments.number_of("step", step, 0.001, 60.0),
    )
