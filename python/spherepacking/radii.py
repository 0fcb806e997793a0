"""Radii of spheres: found by the name of an array, or given by the user."""

from __future__ import annotations

import re
from collections.abc import Mapping
from numbers import Integral, Real
from typing import TYPE_CHECKING

import numpy as np

from .checks import per_sphere, some_of, storable
from .packing import no_such_array
from .size_names import diameters_in

if TYPE_CHECKING:
    import pyvista as pv
    from numpy.typing import ArrayLike

    # A name, one number, one number per sphere, or one per type.
    RadiusLike = str | float | ArrayLike | Mapping[int, float] | Mapping[str, float]

# What programs call arrays of radii or diameters, in lower case; a name of an earlier row wins.
_NAMES = (
    ("radius", "radii"),
    ("diameter", "diameters"),
    ("r", "rad", "d", "diam"),
)
# Beside one of these, r may be the distance of cylindrical or spherical coordinates.
_ANGLES = ("theta", "phi", "azimuth")
# Arrays that say of what type a sphere is, in lower case; the first that fits is taken, then any
# other of text.
_TYPES = ("type_name", "element", "type", "species", "kind", "material", "matid", "name")

_WHOLE = re.compile(r"[+-]?[0-9]+")


def radius_name_in(names: list[str]) -> str | None:
    """Find the array that holds radii or diameters by its name.

    Parameters
    ----------
    names : list[str]
        Names of the arrays there are.

    Returns
    -------
    str or None
        ``radius`` if that is one of them, else the one that is called radii, diameter, r, d or the
        like, the whole word before the short one; None without any.

    Raises
    ------
    ValueError
        If there are several of equal rank, or one called r beside the angle of other coordinates.

    Examples
    --------
    >>> from spherepacking.radii import radius_name_in
    >>> radius_name_in(["d", "Diameter", "id"])
    'Diameter'
    """
    if "radius" in names:
        return "radius"
    lower = [name.lower() for name in names]
    # Beside g and b, r is red.
    colors = {"r", "g", "b"} <= set(lower)
    for row in _NAMES:
        found = [
            name
            for name, small in zip(names, lower, strict=True)
            if small in row and not (small == "r" and colors)
        ]
        if len(found) > 1:
            raise ValueError(
                f"radius: found the arrays {' and '.join(found)}, any of which may hold the radii, "
                f"expected one of them, or radius='{found[0]}'"
            )
        if found and found[0].lower() == "r":
            angle = next((name for name in names if name.lower() in _ANGLES), None)
            if angle is not None:
                raise ValueError(
                    f"radius: found the array {found[0]} beside {angle}, which may be a distance "
                    f"rather than the radii, expected radius='{found[0]}' if it holds them"
                )
        if found:
            return found[0]
    return None


def radii_from(name: str, values: np.ndarray) -> np.ndarray:
    """Radii from the values of an array of that name.

    Parameters
    ----------
    name : str
        Name of the array. Values of one that is called diameter, d or the like are halved.
    values : numpy.ndarray
        One value per sphere, or equal components.

    Returns
    -------
    numpy.ndarray
        Radii (n,), a view of `values` where these are the radii.

    Raises
    ------
    TypeError
        If the values are not real numbers.
    ValueError
        If they have several components that differ, the name may or may not mean diameters, or
        half of a negative one is zero.
    """
    diameters = diameters_in(name)
    if diameters == "unsure":
        raise ValueError(
            f"radius: found the array {name!r}, which may hold diameters or another number, "
            f"expected radius=packing[{name!r}] / 2 or radius=packing[{name!r}]"
        )
    values = np.asarray(values)
    if values.dtype.kind not in "iuf":
        raise TypeError(f"radius: found {values.dtype} values in {name!r}, expected real numbers")
    if values.ndim > 1:
        values = values.reshape(len(values), -1)
        if not (values == values[:, :1]).all():
            raise ValueError(
                f"radius: found {values.shape[1]} components that differ in {name!r}, expected one "
                "number per sphere, or equal ones"
            )
        values = values[:, 0]
    if diameters != "yes":
        return values
    radii = 0.5 * values
    # Half of the least number below zero is 0, which would be taken.
    lost = (values < 0) & (radii == 0)
    if lost.any():
        raise ValueError(
            f"radius: found {values[lost][0]} in {name!r}, expected a number that is not negative"
        )
    return radii


def given_radii(packing: pv.PolyData, radius: RadiusLike) -> np.ndarray:
    """Radii as the argument `radius` gives them.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3).
    radius : str, float, array_like or mapping
        Name of a point array, halved where that says diameters, in the words of
        :func:`spherepacking.size_names.diameters_in`; one radius for all spheres; n
        radii; or one per type, by numbers or texts of the point array ``type``, ``type_name``,
        ``element``, ``species``, ``kind``, ``material`` or ``name``, in any case, or by texts of
        another.

    Returns
    -------
    numpy.ndarray
        Radii (n,).

    Raises
    ------
    KeyError
        If there is no such array, or a type without a radius.
    TypeError
        If they are not real numbers.
    ValueError
        If there is not one per sphere, or one below zero would become zero.
    """
    if isinstance(radius, str):
        if packing.n_points and radius not in packing.point_data:
            raise no_such_array("radius", radius, packing)
        if not packing.n_points:
            return np.empty(0)
        return radii_from(radius, packing.point_data[radius])
    if isinstance(radius, Mapping):
        return _by_type(packing, radius)
    values = np.asarray(radius)
    if values.dtype.kind not in "iuf":
        raise TypeError(
            f"radius: found {values.dtype} values, expected real numbers or the name of a point "
            "array"
        )
    values = storable("radius", values)
    if values.ndim == 0:
        values = np.full(packing.n_points, float(values))
    return per_sphere("radius", values, packing.n_points)


def _is_whole(key: object) -> bool:
    """Whether a key is a whole number, of whatever type."""
    if isinstance(key, bool) or not isinstance(key, Real):
        return False
    return isinstance(key, Integral) or float(key).is_integer()


def _by_type(packing: pv.PolyData, radius: Mapping[int, float] | Mapping[str, float]) -> np.ndarray:
    """Radii (n,) from one per type."""
    if not packing.n_points:
        return np.empty(0)
    numbers = [key for key in radius if _is_whole(key)]
    texts = [key for key in radius if isinstance(key, str)]
    if not radius or (len(numbers) < len(radius) and len(texts) < len(radius)):
        raise TypeError(
            f"radius: found the keys {some_of(map(repr, radius)) or '(none)'}, expected "
            "whole numbers or texts that are types"
        )
    candidates = _type_arrays(packing, texts)
    if not candidates:
        raise KeyError(
            f"radius: found the types {some_of(radius)} and no point array of types, "
            f"such as type or element, its point arrays are: "
            f"{some_of(packing.point_data, 30) or 'none'}"
        )
    first: list[str] = []
    for name in candidates:
        types, which = np.unique(np.asarray(packing.point_data[name]), return_inverse=True)
        keyed = str if types.dtype.kind in "US" else int
        table = {keyed(key): _radius_of(value) for key, value in radius.items()}
        missing = [str(kind) for kind in types.tolist() if kind not in table]
        if not missing:
            return np.array([table[kind] for kind in types.tolist()])[which.reshape(-1)]
        first = first or missing
    raise KeyError(
        f"radius: found no radius for {some_of(first)} of the array {candidates[0]!r}, "
        f"expected one for each type beside those of {some_of(radius)}"
    )


def _radius_of(value: float) -> float:
    """`value` in double precision, or a ValueError if it is below zero and would become zero."""
    radius = float(value)
    if value < 0 and radius == 0:
        raise ValueError(f"radius: found {value}, expected a number that is not negative")
    return radius


def _type_arrays(packing: pv.PolyData, texts: list[str]) -> list[str]:
    """Arrays that may hold the types, the likeliest first; `texts` are those that are asked for."""
    arrays = {name: np.asarray(packing.point_data[name]) for name in packing.point_data}
    plain = {name: array.dtype.kind for name, array in arrays.items() if array.ndim == 1}
    ranks = {name: i for i, name in enumerate(_TYPES)}
    known = [name for name in plain if name.lower() in ranks]

    def rank(name: str) -> tuple[int, bool]:
        # Of names that differ in case alone, the one in lower case comes first.
        return ranks.get(name.lower(), len(ranks)), not name.islower()

    # Of equal names of types, texts are looked for in texts first, and numbers in `type`.
    in_text = sorted((name for name, kind in plain.items() if kind in "US"), key=rank)
    in_numbers = sorted(
        (name for name in known if plain[name] in "iuf"),
        key=lambda name: (name.lower() != "type", *rank(name)),
    )
    if not texts:
        return in_numbers + [name for name in in_text if name in known]
    return in_text + (in_numbers if all(map(_WHOLE.fullmatch, texts)) else [])
