"""A path-traced picture in a plotter, which becomes better while nothing moves."""

from __future__ import annotations

import _thread
import threading
import time
import weakref
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import pyvista as pv

from .. import checks
from ..packing import modified_times

if TYPE_CHECKING:
    from ..backend import vtkRenderPass, vtkRenderStepsPass
    from ..look.look import Look
    from .path_trace import PathOptions, PathTracer

_TICK = 10  # milliseconds between two looks at whether the camera rests
_CERTAIN_TEXTURE = 4096  # pixels along a side that every OpenGL has
_REST = 0.03  # seconds after which it does


class View(NamedTuple):
    """What a picture shows, compared by ``==``: its size, the camera, the spheres and their look.

    Changes that VTK is not notified of are not in it: the tracer finds them, when it is asked for
    the picture again.
    """

    width: int
    height: int
    camera: tuple[float, ...]
    packing: tuple[object, ...] | None
    look: tuple[object, ...] | None


class LivePicture:
    """Spheres of a plotter that are seen in the light of a sky, as ``plotter.packing.path_trace``.

    While the camera moves the mapper draws them; when it rests their picture is traced, in steps,
    and shown instead, among all that else is in the scene. Offscreen every rendering shows the
    finished picture of what there is then, whatever has changed; in a window changes of the
    packing, its scalars or a lookup table make it begin anew, if VTK was notified of them. An actor
    that has been moved or made transparent is left to the mapper.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        The plotter.
    actor : pyvista.Actor
        The spheres, drawn by the mapper.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    tracer : PathTracer
        Traces the picture; it may have an acceleration structure of the packing already.
    look : Look
        What the spheres are coloured by.
    options : PathOptions
        Light and quality of the finished picture.
    step : float
        Seconds between two pictures while it becomes better.
    """

    def __init__(
        self,
        plotter: pv.BasePlotter,
        actor: pv.Actor,
        packing: pv.PolyData,
        tracer: PathTracer,
        look: Look,
        options: PathOptions,
        step: float,
    ) -> None:
        from ..backend import vtkSpherePackingPicturePass

        self.actor = actor
        self.samples = 0
        """Samples that each pixel of the picture has at least."""
        self.error: Exception | None = None
        """What stopped the tracing in the last rendering, which shows the mapper's spheres."""
        self._plotter = weakref.ref(plotter)
        self._renderer: pv.Renderer | None = plotter.renderer
        self._packing: pv.PolyData | None = packing
        self._tracer: PathTracer | None = tracer
        self._look, self._options, self._step = look, options, step
        self._picture = vtkSpherePackingPicturePass()
        self._steps = steps_with(self._picture)
        plotter.renderer.SetPass(self._steps)
        self._shown_view: View | None = None
        self._rendered_view: View | None = None
        self._moved = 0.0  # when the view last differed from that of the rendering before
        self._complete = False
        self._tags = [(plotter.renderer, plotter.renderer.AddObserver("StartEvent", self._before))]
        self._timer: int | None = None

    @property
    def shown(self) -> bool:
        """Whether there is a picture of the present view, be it a preview."""
        return self._shown_view is not None and self._shown_view == self._present_view()

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
        ValueError
            If OpenGL has no texture of the picture's size, or something else is wrong.
        """
        if self._renderer is None or self._tracer is None or self._packing is None:
            raise RuntimeError("this picture has been closed, make a new one")
        _check_texture(self._renderer)
        image = self._tracer.trace(
            self._packing,
            self._renderer.camera,
            self._renderer.GetSize(),
            self._look,
            replace(self._options, time_budget=seconds, preview=seconds is not None),
        )
        # These two alone, since the tracer goes on with copies of all arrays that anyone still has.
        picture = pv.ImageData(dimensions=image.dimensions)
        for name in ("color", "depth"):
            picture.GetPointData().AddArray(image.GetPointData().GetArray(name))
        self._picture.SetPicture(picture)
        # After tracing, which may have found changes that VTK did not know of.
        self._shown_view = self._present_view()
        self.samples = int(image["samples"].min())
        # With a noise target parts of the picture get fewer.
        nothing_left = seconds is None or image.field_data["traced_samples"][0] == 0.0
        self._complete = self.samples >= self._options.samples or nothing_left
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
        self._shown_view = self._renderer = self._tracer = self._packing = None

    @property
    def abandoned(self) -> bool:
        """Whether the actor is no longer in the scene."""
        return self._renderer is None or not self._renderer.HasViewProp(self.actor)

    def _present_view(self) -> View | None:
        """What a picture of now would show."""
        if self._renderer is None or self._packing is None:
            return None
        camera, (width, height) = self._renderer.camera, self._renderer.GetSize()
        projection = camera.GetProjectionTransformMatrix(width / max(height, 1), -1.0, 1.0)
        model_view = camera.GetModelViewTransformMatrix()
        # The third row of the projection is the depth between the clipping planes.
        rows = [(projection, i) for i in (0, 1, 3)] + [(model_view, i) for i in range(3)]
        numbers = tuple(matrix.GetElement(i, j) for matrix, i in rows for j in range(4))
        times = modified_times(self._packing)
        state = None if times is None else (times.geometry, times.arrays)
        return View(width, height, numbers, state, self._look.key(self._packing))

    def _usable(self) -> bool:
        """Whether a picture can stand for the actor, and is asked for."""
        if self._renderer is None:
            return False
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
        present = self._present_view()
        if present != self._rendered_view:
            self._rendered_view, self._moved = present, time.perf_counter()
        usable = self._usable()
        if not plotter.off_screen:
            self._start_timer(plotter)
        elif usable:
            # Of a finished picture the tracer finds that nothing is left to do.
            self._refine_in_vtk(None)
        shown = usable and self.shown
        self.actor.mapper.SetDrawn(not shown)
        if not shown:
            self._picture.SetPicture(None)
            self._shown_view = None
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
        same = self._present_view() == self._rendered_view
        rests = same and time.perf_counter() - self._moved >= _REST
        if rests and self._usable() and not self.finished:
            self._refine_in_vtk(self._step)
            plotter.render()

    def _refine_in_vtk(self, seconds: float | None) -> None:
        """Refine inside a call of VTK, and let no exception leave it."""
        self.error = None
        try:
            self.refine(seconds)
        except KeyboardInterrupt:
            # Upstream: VTK's vtkPythonCommand ends the process when KeyboardInterrupt leaves an
            # observer: https://github.com/marcomusy/vedo/issues/1101. So it comes once more, when
            # VTK has returned.
            threading.Timer(0.3, _thread.interrupt_main).start()
        except (KeyError, OSError, TypeError, ValueError) as error:
            self.error = error


def _check_texture(renderer: pv.Renderer) -> None:
    """Raise a ValueError if a picture of the whole renderer cannot be made a texture."""
    from ..backend import vtkSpherePackingWindowCheck

    width, height = renderer.GetSize()
    # What OpenGL has is asked for only where that is in doubt.
    if max(width, height) <= _CERTAIN_TEXTURE:
        return
    largest = vtkSpherePackingWindowCheck.GetLargestSide(renderer.GetRenderWindow())
    if max(width, height) > largest:
        raise ValueError(
            f"window_size: found {width} x {height}, expected at most {largest} pixels along a "
            "side: OpenGL has no larger textures; packing.path_trace makes pictures without it"
        )


def steps_with(picture: vtkRenderPass) -> vtkRenderStepsPass:
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


def check_no_pass(plotter: pv.BasePlotter) -> None:
    """Raise a ValueError if the plotter has a render pass of its own."""
    if plotter.renderer.GetPass() is not None:
        raise ValueError(
            "the plotter's render pass: found one, expected none: a path-traced picture goes "
            "neither with another one nor with SSAO, SSAA, depth of field and the like"
        )


def check_step(step: float) -> float:
    """Seconds of a step, or a ValueError."""
    return checks.number_of("step", step, *checks.STEP_LIMITS)
