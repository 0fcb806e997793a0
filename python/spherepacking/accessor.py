"""The accessor ``packing`` of every dataset: its points as spheres."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv
from pyvista.core._typing_core import BoundsTuple

from .datasets import DatasetPacking, centres_of
from .granular.accessor import GranularOfPacking
from .look.look import Look
from .metaballs.accessor import MetaballsOfPacking
from .packing import check_radii
from .trace.boxes import BoxesOfPacking
from .trace.path_trace import PathOptions, PathTracer
from .trace.ray_cast import RayCaster
from .vtk_tools import window_of

if TYPE_CHECKING:
    import os
    from collections.abc import Callable, Sequence
    from typing import Any

    from numpy.typing import ArrayLike
    from pyvista.plotting._typing import ColorLike

    from .radii import RadiusLike
    from .trace.ray_cast import Pick
    from .trace.sky import Sun


@pv.register_dataset_accessor("packing", pv.PartitionedDataSet)
@pv.register_dataset_accessor("packing", pv.MultiBlock)
@pv.register_dataset_accessor("packing", pv.DataSet)
class PackingAccessor(BoxesOfPacking, GranularOfPacking, MetaballsOfPacking):
    """Points as centres of spheres, the point array ``radius`` as their radii.

    Without one of that name, an array called radii, Radius, diameter, r, d or the like holds the
    radii or diameters, the whole word before the short one. All methods that need radii have an
    argument `radius`, which gives them: the name of a point array, one number, one per sphere, or
    one per type, such as ``{"C": 1.7, "H": 1.1}``. The blocks of a MultiBlock are joined.

    Parameters
    ----------
    dataset : pyvista.DataSet or pyvista.MultiBlock
        Its points are the centres (n, 3).

    Examples
    --------
    >>> import spherepacking
    >>> packing = spherepacking.apollonian(1)
    >>> packing.packing.n_spheres
    9
    """

    def __init__(self, dataset: pv.DataSet | pv.MultiBlock) -> None:
        self._dataset = dataset
        self._spheres = DatasetPacking(dataset)
        self._ray_caster = RayCaster()
        self._path_tracer = PathTracer()

    @property
    def n_spheres(self) -> int:
        """Number of spheres."""
        return len(self.centers)

    @property
    def centers(self) -> np.ndarray:
        """Centres (n, 3), a view of the points; of a MultiBlock a copy."""
        composite = not isinstance(self._dataset, pv.DataSet)
        return (centres_of(self._dataset) if composite else self._dataset).points

    @property
    def radii(self) -> np.ndarray:
        """Radii (n,) in the unit of the points, a view of the array ``radius``.

        Raises
        ------
        KeyError
            If there is no such point array.
        TypeError, ValueError
            If its values are not radii.
        """
        if not self.n_spheres:
            return np.empty(0)
        packing = self.with_radius()
        check_radii(packing)
        return packing.point_data["radius"]

    @property
    def bounds(self) -> BoundsTuple:
        """Box around all spheres, x min, x max, y min, …; ``PolyData.bounds`` is around centres.

        Without spheres it is that of an empty PolyData.
        """
        packing = self.with_radius()
        if not packing.n_points:
            return packing.bounds
        from .backend import vtkSpherePackingInput

        check_radii(packing)
        box = [0.0] * 6
        array = packing.GetPointData().GetArray("radius")
        vtkSpherePackingInput.ComputeBounds(packing, array, box)
        return BoundsTuple(*box)

    @property
    def volume(self) -> float:
        """Sum of the volumes of the spheres, overlaps counted as often as they occur.

        Infinite if it is more than a float holds.
        """
        with np.errstate(over="ignore"):
            return float(4.0 / 3.0 * np.pi * np.sum(np.asarray(self.radii, dtype=float) ** 3))

    def modified(self) -> None:
        """Say that numbers of the packing have been written to in a way that tells nobody.

        What shows a packing for longer than a call keeps what it has made of it: :meth:`ray_cast`
        and :meth:`pick` their structure, actors of a plotter and live pictures what they draw. They
        show the packing as it was when its points or an array were last assigned, or written to by
        ``packing["radius"][3] = 1`` or ``packing["radius"] *= 2``. NumPy tells nobody of other
        writes: ``array *= 2``, ``array.sort()``, ``out=array``. After those call this method; until
        then they show the whole packing as it was, and never a mixture. (Where all of an array has
        changed, :meth:`ray_cast` and :meth:`pick` mostly find out; :meth:`path_trace` always does.)
        Everything else, such as boxes, contacts and metaballs, takes the numbers that are there
        when it is called.

        Examples
        --------
        >>> import numpy as np
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> radii = np.asarray(packing["radius"])
        >>> radii.flat[0] = 0.1
        >>> packing.packing.modified()
        """
        self._spheres.modified()

    def with_radius(self, radius: RadiusLike | None = None) -> pv.PolyData:
        """Return the spheres as a PolyData with a point array ``radius``.

        Parameters
        ----------
        radius : str, float, array_like or mapping, optional
            Name of the point array with the radii; one radius for all; one per sphere (n,); or one
            per type, by numbers of the array ``type`` or by texts of ``type_name``, ``element`` or
            another.

        Returns
        -------
        pyvista.PolyData
            The dataset itself if it is a PolyData that has them, else another one that shares its
            arrays.

        Raises
        ------
        KeyError
            If there is no such array, or a type without a radius.
        TypeError, ValueError
            If these are not radii.

        Examples
        --------
        >>> import pyvista as pv
        >>> grid = pv.ImageData(dimensions=(2, 2, 2))
        >>> grid.packing.with_radius(0.5).packing.bounds[:2]
        (-0.5, 1.5)
        """
        return self._spheres.with_radius(radius)

    def save(self, path: str | os.PathLike[str], *, radius: RadiusLike | None = None) -> None:
        """Write the packing, see :func:`spherepacking.write`."""
        from .files.writers import write

        write(self._dataset, path, radius=radius)

    def ray_cast(
        self,
        camera: pv.Camera | Sequence[Sequence[float]],
        window_size: Sequence[int],
        *,
        structure: str = "bvh",
        cuts: int | None = None,
        samples: int = 1,
        tile: Sequence[int] | int | None = None,
        scalars: str | ArrayLike | None = None,
        rgb: bool | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        log_scale: bool = False,
        color: ColorLike | None = None,
        random_colors: bool = False,
        radius: RadiusLike | None = None,
        progress: bool = False,
    ) -> pv.ImageData:
        """Make a picture by casting rays, without a window.

        Every pixel holds the exact intersection of its ray, computed in double precision (Haines,
        Günther and Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray
        Tracing Gems, 2019). The structure changes the speed alone, not a single bit of the picture,
        unless the camera is more than 1e9 times as far away as the packing is large. The accessor
        reuses it for further pictures until points or radii are assigned or written to; see
        :meth:`modified` for writes that nobody is told of.

        Parameters
        ----------
        camera : pyvista.Camera or sequence
            A camera, or its position, focal point and view-up (3, 3). Its clipping planes do not
            count.
        window_size : sequence of int
            Width and height of the picture in pixels.
        structure : {"bvh", "grid", "none"}, default: "bvh"
            How rays find spheres: through a bounding volume hierarchy, a uniform grid, or by
            testing all.
        cuts : int, optional
            How often the grid cuts each axis; by default it has twice as many cells as spheres.
        samples : int, default: 1
            n for n x n rays per pixel, from 1 to 16, whose colours are averaged.
        tile : int or sequence of int, default: 64
            Width and height in pixels of the tiles in which the picture is made.
        scalars : str or array_like, optional
            What to colour by: the name of a point array, or an array (n,), (n, 3) or (n, 4). If
            neither `scalars` nor `color` is given, the active point scalars are used.
        rgb : bool, optional
            Take the scalars as colours; by default if their name is ``rgb`` or ``rgba`` or ends
            with ``_rgb`` or ``_rgba``.
        cmap : str, list or pyvista.LookupTable, optional
            Colour map of the scalars.
        clim : sequence of float, optional
            Range of the scalars that the colour map spans.
        log_scale : bool, default: False
            Map scalars logarithmically.
        color : ColorLike, optional
            One colour for all spheres.
        random_colors : bool, default: False
            One random colour per sphere, whatever `scalars` and `color` are.
        radius : str, float, array_like or mapping, optional
            As in :meth:`with_radius`.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.ImageData
            One point per pixel, from the lower left corner. Point arrays:

            - ``color`` (n, 4), uint8: RGBA, alpha 0 where nothing is hit
            - ``depth`` (float32): along the direction of view, in the unit of the packing; infinite
              where nothing is hit
            - ``normal`` (n, 3), float32: out of the sphere
            - ``sphere_id`` (int64): -1 where nothing is hit

            Field arrays:

            - ``tile_extents``, ``compute_seconds``, ``partial_seconds``: of each tile
            - ``complete_seconds``: of the whole picture
            - ``build_seconds``, ``memory_bytes``: of the structure

        Raises
        ------
        KeyError
            If there is no such point array of radii, or none of the name `scalars`.
        TypeError
            If an argument has the wrong type.
        ValueError
            If an argument is out of its range, the camera has no direction of view, or a radius is
            negative or not finite.
        KeyboardInterrupt
            If Ctrl-C was pressed; no tile is begun after that.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> view = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
        >>> image = packing.packing.ray_cast(view, (200, 100), samples=2)
        >>> image["color"].shape
        (20000, 4)
        """
        return self._ray_caster.cast(
            self.with_radius(radius),
            camera,
            window_size,
            Look(scalars, rgb, cmap, clim, log_scale, color, random_colors),
            structure=structure,
            cuts=cuts,
            samples=samples,
            tile=tile,
            progress=progress,
        )

    def path_trace(
        self,
        camera: pv.Camera | Sequence[Sequence[float]],
        window_size: Sequence[int],
        *,
        samples: int = 16,
        max_bounces: int = 4,
        albedo: float = 0.8,
        sky: float | ArrayLike | str | os.PathLike[str] = 1.0,
        sun: Sun | Sequence[float] | None = None,
        seed: int = 0,
        structure: str = "bvh",
        cuts: int | None = None,
        tile: Sequence[int] | int | None = None,
        time_budget: float | None = None,
        preview: bool = False,
        noise_target: float | None = None,
        min_samples: int = 16,
        exposure: float = 0.0,
        filmic: bool = False,
        sky_visible: bool = True,
        scalars: str | ArrayLike | None = None,
        rgb: bool | None = None,
        cmap: str | list[ColorLike] | pv.LookupTable | None = None,
        clim: Sequence[float] | float | None = None,
        log_scale: bool = False,
        color: ColorLike | None = None,
        random_colors: bool = False,
        denoise: bool = False,
        radius: RadiusLike | None = None,
        progress: bool = False,
    ) -> pv.ImageData:
        """Make a picture in the light of a sky and a sun, by following paths of light.

        Spheres are opaque and matt (Lambert's law). Paths are drawn in proportion to what they
        bring (J. T. Kajiya, "The Rendering Equation", 1986), with Owen-scrambled Sobol points (B.
        Burley, "Practical Hash-based Owen Scrambling", 2020). The picture depends on the seed
        alone, not on tiles, threads or structure. The accessor keeps it: called again with more
        samples, it traces only those that are missing, also after Ctrl-C or a time budget.

        Parameters
        ----------
        camera : pyvista.Camera or sequence
            A camera, or its position, focal point and view-up (3, 3). Its clipping planes do not
            count.
        window_size : sequence of int
            Width and height of the picture in pixels.
        samples : int, default: 16
            Paths per pixel, 1 or more.
        max_bounces : int, default: 4
            How many spheres a path may visit, 0 or more; 1 for direct light alone, which under a
            sky is ambient occlusion.
        albedo : float, default: 0.8
            Part of the light that a white sphere reflects, from 0 to 1. Colours are multiplied by
            it.
        sky : float, array_like, str or os.PathLike, default: 1.0
            Radiance of the sky, linear: one number, or red, green and blue; two of either for the
            bottom (-z) and the top (+z); or an equirectangular image (height, width, 3), or the
            file of one, whose upper side is +z and whose middle is +x. Integers in images are sRGB.
            The image is what is bilinear between the middles of its pixels, around the poles what
            the nearest row is. A file of up to 2**29 pixels is read, if half of the memory holds
            64 bytes for each.
        sun : Sun or sequence of float, optional
            A :class:`spherepacking.Sun`, or the direction (3,) towards one of radiance 1.
        seed : int, default: 0
            Seed of the random numbers, from 0 to 2**32 - 1.
        structure : {"bvh", "grid", "none"}, default: "bvh"
            How rays find spheres, as in :meth:`ray_cast`.
        cuts : int, optional
            How often the grid cuts each axis.
        tile : int or sequence of int, default: 64
            Width and height in pixels of the tiles in which the picture is made.
        time_budget : float, optional
            Seconds after which no tile is begun any more; every pixel gets a sample at least.
        preview : bool, default: False
            With `time_budget`, begin with one pixel in four, whose light ``color`` shows at the
            other three as well for as long as they have none.
        noise_target : float, optional
            Relative error at which a part of the picture, 32 x 32 pixels, gets no more samples.
        min_samples : int, default: 16
            Samples per pixel before that error is estimated, 2 or more.
        exposure : float, default: 0.0
            In ``color``, light counts 2**exposure times.
        filmic : bool, default: False
            A filmic curve for ``color`` (K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2015)
            instead of cutting light off at white.
        sky_visible : bool, default: True
            Show the sky in ``color``; otherwise its opacity is the coverage.
        scalars, rgb, cmap, clim, log_scale, color, random_colors
            What the spheres are coloured by, as in :meth:`ray_cast`; by default they are white.
        denoise : bool, default: False
            Estimate the picture without noise by Open Image Denoise (extra ``denoise``), as the
            array ``denoised`` (float32, 3, linear), and take ``color`` from it, unless there are
            pixels without a sample.
        radius : str, float, array_like or mapping, optional
            As in :meth:`with_radius`.
        progress : bool, default: False
            Show a progress bar. Ctrl-C stops the work with or without.

        Returns
        -------
        pyvista.ImageData
            One point per pixel, from the lower left corner. Point arrays:

            - ``color`` (n, 4), uint8: RGBA, sRGB
            - ``radiance`` (n, 3), float32: linear, the sky included
            - ``albedo``, ``normal`` (n, 3), float32: means over the samples, 0 for the sky
            - ``depth`` (float32), ``sphere_id`` (int64): of the pixel's middle, as in
              :meth:`ray_cast`
            - ``coverage`` (float32): fraction of the samples that hit a sphere
            - ``samples`` (uint32)
            - ``variance`` (float32): of the radiance's brightness, rather too large than too small
            - ``denoised`` (n, 3), float32: with `denoise`

            Field arrays:

            - ``tile_extents``, ``compute_seconds``, ``complete_seconds``, ``build_seconds``,
              ``memory_bytes``: as in :meth:`ray_cast`
            - ``traced_samples``: number of samples that were added, over all pixels
            - ``camera`` (3, 3): position, focal point and view-up
            - ``view_angle`` or ``parallel_scale``, the other one is NaN
            - ``seed``, ``max_bounces``, ``reflectance``

        Raises
        ------
        ImportError
            If `denoise` is True and Open Image Denoise is not installed.
        FileNotFoundError, OSError
            If the image of the sky cannot be read.
        KeyError
            If there is no such point array of radii, or none of the name `scalars`.
        TypeError
            If an argument has the wrong type.
        ValueError
            If an argument is out of its range, the camera has no direction of view, or a radius is
            negative or not finite.
        KeyboardInterrupt
            If Ctrl-C was pressed; the next call goes on with what has been traced.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> view = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
        >>> image = packing.packing.path_trace(view, (200, 100), samples=4)
        >>> image["radiance"].shape
        (20000, 3)
        """
        options = PathOptions(
            samples=samples,
            max_bounces=max_bounces,
            albedo=albedo,
            sky=sky,
            sun=sun,
            seed=seed,
            structure=structure,
            cuts=cuts,
            tile=tile,
            time_budget=time_budget,
            preview=preview,
            noise_target=noise_target,
            min_samples=min_samples,
            exposure=exposure,
            filmic=filmic,
            sky_visible=sky_visible,
            denoise=denoise,
            progress=progress,
        )
        look = Look(scalars, rgb, cmap, clim, log_scale, color, random_colors)
        return self._path_tracer.trace(self.with_radius(radius), camera, window_size, look, options)

    def pick(
        self,
        camera: pv.Camera | Sequence[Sequence[float]],
        window_size: Sequence[int],
        x: float,
        y: float,
        *,
        radius: RadiusLike | None = None,
    ) -> Pick | None:
        """Find the sphere that is seen at a point of the picture.

        Parameters
        ----------
        camera : pyvista.Camera or sequence
            A camera, or its position, focal point and view-up (3, 3).
        window_size : sequence of int
            Width and height of the picture in pixels.
        x, y : float
            The point, in pixels from the lower left corner; (0.5, 0.5) is the middle of the first
            pixel.
        radius : str, float, array_like or mapping, optional
            As in :meth:`with_radius`.

        Returns
        -------
        Pick or None
            ``sphere_id``, ``point`` (3,) and ``normal`` (3,); None where nothing is seen.

        Raises
        ------
        KeyError
            If there is no such point array of radii.
        TypeError, ValueError
            If an argument is invalid, or the point lies outside the picture.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> view = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
        >>> found = packing.packing.pick(view, (200, 200), 100, 100)
        >>> found.normal.shape
        (3,)
        """
        return self._ray_caster.pick(self.with_radius(radius), camera, window_size, x, y)

    def plot(self, **kwargs: Any) -> Any:
        """Show the packing in a window, or offscreen in a picture.

        Parameters
        ----------
        **kwargs : dict, optional
            Arguments of :class:`pyvista.Plotter`, of its ``show`` and of ``plotter.packing.add``,
            distinguished by their names; `background` sets the colour behind the spheres.

        Returns
        -------
        Any
            What :meth:`pyvista.Plotter.show` returns.

        Raises
        ------
        RuntimeError
            If the window cannot be drawn into.
        ValueError
            If the window is larger than 4096 pixels along a side, which ``screenshot`` of
            ``plotter.packing`` is for.

        Examples
        --------
        >>> import spherepacking
        >>> packing = spherepacking.apollonian(3)
        >>> packing.packing.plot(cmap="magma", screenshot="packing.png")  # doctest: +SKIP
        """
        from .draw.offscreen import choose_window
        from .draw.picture import check_one_piece, drawing_checked
        from .plotter import PackingComponent

        choose_window()
        background = kwargs.pop("background", None)
        # `lighting` and others are known to two of them: the spheres come first, as in plot() of
        # PyVista's meshes.
        look = _take(kwargs, PackingComponent.add)
        plotter = pv.Plotter(**_take(kwargs, pv.Plotter.__init__))
        try:
            if background is not None:
                plotter.set_background(background)
            plotter.packing.add(self._dataset, **look)
            check_one_piece(plotter, kwargs.get("window_size"))
            with drawing_checked(window_of(plotter)):
                return plotter.show(**kwargs)
        except BaseException:
            plotter.close()
            raise


def _take(kwargs: dict[str, Any], function: Callable[..., Any]) -> dict[str, Any]:
    """Move those of `kwargs` that `function` takes into a dict of their own."""
    names = inspect.signature(function).parameters.keys() & kwargs.keys()
    return {name: kwargs.pop(name) for name in names}
