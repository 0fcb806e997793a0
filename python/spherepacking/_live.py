"""A path-traced picture in a plotter, which becomes better while nothing moves."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING

import pyvista as pv

from . import _arguments as arguments
from ._raycast import state_of
from .accessor import PackingAccessor

if TYPE_CHECKING:
    from ._backend import vtkRenderStepsPass

_TICK = 50  # milliseconds between two looks at whether the camera rests


class LivePicture:
    """Spheres of a plotter that are seen in the light of a sky, as ``plotter.packing.path_trace``.

    While the camera moves the mapper draws them; when it rests their picture is traced, in steps,
    and shown instead, among all that else is in the scene. Offscreen every rendering shows the
    finished picture.

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
        from ._backend import vtkSpherePackingPicturePass

        self.actor = actor
        self._plotter = weakref.ref(plotter)
        self._renderer = plotter.renderer
        self._packing = packing
        self._spheres = PackingAccessor(packing)
        self._samples, self._step, self._words = samples, step, words
        self._picture = vtkSpherePackingPicturePass()
        self._steps = _steps_with(self._picture)
        self._renderer.SetPass(self._steps)
        self._view: tuple[object, ...] | None = None
        """Where the picture was seen from."""
        self._last: tuple[object, ...] | None = None
        """Where the camera was at the last tick."""
        self.samples = 0
        """Samples that each pixel of the picture has at least."""
        self._tags = [(self._renderer, self._renderer.AddObserver("StartEvent", self._before))]
        self._timer = None

    @property
    def shown(self) -> bool:
        """Whether there is a picture of the present view, be it a preview."""
        return self._view is not None and self._view == self._present()

    @property
    def finished(self) -> bool:
        """Whether the picture of the present view has all its samples."""
        return self.samples >= self._samples and self.shown

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
        """
        view = self._present()
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
        self._view = view
        self.samples = int(image["samples"].min())
        return self.samples

    def close(self) -> None:
        """Leave the spheres to the mapper."""
        for source, tag in self._tags:
            source.RemoveObserver(tag)
        self._tags.clear()
        plotter = self._plotter()
        if self._timer is not None and plotter is not None and plotter.iren is not None:
            plotter.iren.destroy_timer(self._timer)
        self._timer = None
        if self._renderer is not None:
            if self._renderer.GetPass() is self._steps:
                self._renderer.SetPass(None)
            window = self._renderer.GetRenderWindow()
            if window is not None:
                self._picture.ReleaseGraphicsResources(window)
        self.actor.mapper.SetDrawn(True)
        self._renderer = self._spheres = self._packing = None

    def _present(self) -> tuple[object, ...]:
        """What a picture depends on."""
        camera = self._renderer.camera
        return (
            camera.position,
            camera.focal_point,
            camera.up,
            camera.view_angle,
            camera.parallel_projection,
            camera.parallel_scale,
            tuple(self._renderer.GetSize()),
            state_of(self._packing),
        )

    def _before(self, *_: object) -> None:
        """Decide before each rendering who shows the spheres."""
        plotter = self._plotter()
        if plotter is None:
            return
        if plotter.off_screen and not self.finished:
            self.refine()
        elif not plotter.off_screen:
            self._start_timer(plotter)
        shown = self.shown and self._renderer.GetPass() is self._steps
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
        present = self._present()
        rests, self._last = present == self._last, present
        plotter = self._plotter()
        if rests and plotter is not None and not self.finished:
            self.refine(self._step)
            plotter.render()


def _steps_with(picture: object) -> vtkRenderStepsPass:
    """VTK's own steps of rendering, with a picture after the opaque props."""
    from ._backend import (
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
