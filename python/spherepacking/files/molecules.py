"""Atoms of PDB and mmCIF files as spheres of their van der Waals radii, by gemmi."""

from __future__ import annotations

import gzip
import math
import re
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
import pyvista as pv

from .errors import PackingFileError
from .flat_atoms import DEUTERIUM, element_number, flat_atoms
from .pdb_lines import check_not_cut, check_pdb_lines

if TYPE_CHECKING:
    import os
    from types import ModuleType

    import gemmi

    from ..radii import RadiusLike
    from .flat_atoms import FlatAtoms

EXTENSIONS = (".pdb", ".ent", ".cif", ".mmcif")
"""Extensions of the files, in lower case; ``.gz`` may follow."""

# Columns of atoms in mmCIF.
_OPTIONAL = ("id", "label_alt_id", "label_asym_id")
# The last element with a van der Waals radius in gemmi, lawrencium.
_LAST_KNOWN = 103
# What gemmi calls elements that it does not know.
_UNKNOWN = "X"


def _gemmi() -> ModuleType:
    """Import gemmi, or raise an ImportError that says how to get it."""
    try:
        import gemmi
    except ImportError as error:
        raise ImportError(
            f"molecules: gemmi cannot be loaded ({error}), expected the extra 'formats': "
            "pip install 'spherepacking[formats]'"
        ) from error
    return gemmi


class MoleculeFile:
    """A PDB or mmCIF file, whose models are steps.

    Small molecules in CIF, with fractions of the unit cell, are read, too: the atoms of the file,
    without their images by symmetry.

    Parameters
    ----------
    path : str or os.PathLike
        File to read; its name ends with one of `EXTENSIONS`, perhaps followed by ``.gz``.
    data : bytes, optional
        Content of the file, if it is at hand; neither opened nor decompressed then.

    Attributes
    ----------
    times : list[float]
        Numbers of the models, in the order of the file.

    Raises
    ------
    ImportError
        If gemmi is not installed.
    PackingFileError
        If the file holds no atoms that can be read. The message names file and line, what was
        found and what was expected.

    Examples
    --------
    >>> from spherepacking.files.molecules import MoleculeFile
    >>> file = MoleculeFile("1crn.pdb")  # doctest: +SKIP
    >>> packing = file.read(0)  # doctest: +SKIP
    """

    _structure: gemmi.Structure | None
    _small: gemmi.SmallStructure | None

    def __init__(self, path: str | os.PathLike[str], *, data: bytes | None = None) -> None:
        gemmi = _gemmi()
        self._path = Path(path)
        suffixes = [suffix.lower() for suffix in self._path.suffixes]
        if data is None:
            data = _content(self._path, compressed=suffixes[-1:] == [".gz"])
        self._structure = self._small = None
        if next((s for s in reversed(suffixes) if s in EXTENSIONS), "") in (".pdb", ".ent"):
            check_pdb_lines(self._path, data)
            with _Refused(self._path, "a PDB file"):
                self._structure = gemmi.read_structure_string(
                    data, merge_chain_parts=False, format=gemmi.CoorFormat.Pdb
                )
        else:
            self._read_cif(data)
        self.times = [1.0] if self._structure is None else self._model_numbers(self._structure)

    def _read_cif(self, data: bytes) -> None:
        """Read the first block that holds atoms."""
        gemmi = _gemmi()
        check_not_cut(self._path, data, (b"#",))
        with _Refused(self._path, "an mmCIF file"):
            for block in gemmi.cif.read_string(data):
                self._complete(block)
                structure = gemmi.make_structure_from_block(block)
                if structure:
                    self._structure = structure
                    return
                small = gemmi.make_small_structure_from_block(block)
                if len(small.sites):
                    self._check_cell(block)
                    self._small = small
                    return
        raise PackingFileError(
            f"{self._path}: holds no atoms, expected the category _atom_site with coordinates"
        )

    def _complete(self, block: gemmi.cif.Block) -> None:
        """Add what a category of atoms may leave out but gemmi does not read it without.

        Upstream: gemmi 0.7.5 finds no atom without one of these, though mmCIF asks for none but
        ``id`` and ``type_symbol``.
        """
        loop = block.find_loop("_atom_site.Cartn_x").get_loop()
        if loop is None:
            return
        there = set(loop.tags)
        absent = [name for name in _OPTIONAL if f"_atom_site.{name}" not in there]
        if "_atom_site.type_symbol" not in there:
            raise PackingFileError(
                f"{self._path}: found no _atom_site.type_symbol, expected the element of each atom"
            )
        for name in ("atom_id", "comp_id", "seq_id"):
            if not there & {f"_atom_site.label_{name}", f"_atom_site.auth_{name}"}:
                absent.append(f"label_{name}")
        if absent:
            loop.add_columns([f"_atom_site.{name}" for name in absent], ".")
        if "id" in absent:
            serials = block.find_loop("_atom_site.id")
            for i in range(len(serials)):
                serials[i] = str(i + 1)

    def _check_cell(self, block: gemmi.cif.Block) -> None:
        """Raise an error unless the block has the cell that coordinates are fractions of."""
        for name in (
            "length_a",
            "length_b",
            "length_c",
            "angle_alpha",
            "angle_beta",
            "angle_gamma",
        ):
            found = block.find_value(f"_cell_{name}")
            if not _is_number(found):
                raise PackingFileError(
                    f"{self._path}: found {'no' if found is None else repr(found) + ' as'} "
                    f"_cell_{name}, expected the whole cell that the coordinates are fractions of"
                )

    def _model_numbers(self, structure: gemmi.Structure) -> list[float]:
        """Numbers of the models; raises an error if all are empty."""
        if not sum(model.count_atom_sites() for model in structure):
            raise PackingFileError(f"{self._path}: holds no atoms, expected records ATOM or HETATM")
        return [float(model.num) for model in structure]

    def read(self, index: int = 0) -> pv.PolyData:
        """Read one model.

        Of alternative locations of an atom, that one is taken which has the largest occupancy; the
        first of equal ones.

        Parameters
        ----------
        index : int, default: 0
            Index of the model in `times`.

        Returns
        -------
        pyvista.PolyData
            Centres of the atoms in Å, as points (n, 3), and the point arrays

            * ``radius``: van der Waals radii in Å, those of gemmi's table of elements, where they
              are largely those of Bondi (1964), deuterium as hydrogen; NaN for an unknown element,
              X, and from rutherfordium (104) on
            * ``element``, ``name``, ``residue``, ``chain``: text
            * ``atomic_number``, ``residue_id``: whole numbers
            * ``insertion_code``: text, if any residue has one
            * ``occupancy``, ``b_factor``: as in the file
            * ``rgb``: colours of the elements as uint8 (n, 3), those of the Blue Obelisk Data
              Repository (2006), which follow Jmol

            Field arrays ``cell_vectors``, ``cell_origin`` and ``cell_periodic`` hold the unit
            cell, if there is one.

        Raises
        ------
        IndexError
            If there is no such model.
        PackingFileError
            If a coordinate is no finite number.
        """
        if not 0 <= index < len(self.times):
            raise IndexError(f"index: found {index}, expected 0 to {len(self.times) - 1}")
        if self._small is not None:
            packing, cell = self._small_packing(self._small), self._small.cell
        else:
            assert self._structure is not None
            packing, cell = self._packing(self._structure, index), self._structure.cell
        packing.set_active_scalars("radius")
        if cell.is_crystal():
            packing.field_data["cell_vectors"] = np.array(cell.orth.mat.tolist()).T
            packing.field_data["cell_origin"] = np.zeros(3)
            packing.field_data["cell_periodic"] = np.ones(3, np.uint8)
        return packing

    def _packing(self, structure: gemmi.Structure, index: int) -> pv.PolyData:
        flat = flat_atoms(structure[index])
        keep = _chosen(flat)
        points = flat.pos[keep]
        names = _text(flat.atom_names[keep])
        residue_ids = flat.resnums[keep]
        if len(bad := np.flatnonzero(~np.isfinite(points).all(axis=1))):
            atom = f"atom {names[bad[0]]} of residue {residue_ids[bad[0]]}"
            self._refuse_coordinates(atom, points[bad[0]])
        packing = _spheres(points, flat.elements[keep])
        packing.point_data["name"] = names
        packing.point_data["residue"] = _text(flat.residue_names[keep])
        packing.point_data["chain"] = _text(flat.chain_ids[keep])
        packing.point_data["residue_id"] = residue_ids
        codes = np.array([chr(code).strip() for code in flat.icodes[keep]])
        if (codes != "").any():
            packing.point_data["insertion_code"] = codes
        packing.point_data["occupancy"] = flat.occ[keep].astype(float)
        packing.point_data["b_factor"] = flat.b_iso[keep].astype(float)
        return packing

    def _small_packing(self, small: gemmi.SmallStructure) -> pv.PolyData:
        sites = list(small.sites)
        points = np.array([small.cell.orthogonalize(site.fract).tolist() for site in sites])
        if len(bad := np.flatnonzero(~np.isfinite(points).all(axis=1))):
            site = sites[bad[0]]
            self._refuse_coordinates(f"atom {site.label}", site.fract.tolist())
        packing = _spheres(points, np.array([element_number(site.element) for site in sites]))
        packing.point_data["name"] = np.array([site.label for site in sites])
        packing.point_data["occupancy"] = np.array([site.occ for site in sites], float)
        return packing

    def _refuse_coordinates(self, atom: str, found: object) -> NoReturn:
        raise PackingFileError(
            f"{self._path}: found {np.asarray(found)} as coordinates of {atom}, expected finite "
            "numbers"
        )


def radius_of_atoms(
    packing: pv.PolyData, path: Path, radius: RadiusLike | None
) -> RadiusLike | None:
    """Complete the argument `radius` where elements have no van der Waals radius.

    Parameters
    ----------
    packing : pyvista.PolyData
        What `MoleculeFile.read` returns.
    path : pathlib.Path
        File, for errors.
    radius : str, float, array_like or mapping, optional
        Radii as the user gives them.

    Returns
    -------
    str, float, array_like, mapping or None
        `radius`; or, if that gives radii for elements without one alone, those of all atoms.

    Raises
    ------
    PackingFileError
        If an element has no radius, neither by itself nor by `radius`.
    """
    radii = np.array(packing.point_data["radius"])
    elements = packing.point_data["element"]
    unknown = sorted(set(elements[np.isnan(radii)].tolist()))
    given: Mapping[Any, float] = radius if isinstance(radius, Mapping) else {}
    if not unknown or (radius is not None and not (given and set(given) <= set(unknown))):
        return radius
    if missing := [element for element in unknown if element not in given]:
        raise PackingFileError(
            f"{path}: found atoms of {', '.join(missing)}, which has no van der Waals radius"
            f"{_meaning_of_x(packing) if _UNKNOWN in missing else ''}, expected one, such as "
            f"radius={{{missing[0]!r}: 1.5}}"
        )
    for element, value in given.items():
        radii[elements == element] = value
    return radii


def _meaning_of_x(packing: pv.PolyData) -> str:
    """Which atom is the first of no known element, since X need not stand in the file."""
    first = int(np.flatnonzero(packing.point_data["element"] == _UNKNOWN)[0])
    atom = f"the atom {packing.point_data['name'][first]!s}"
    if "residue" in packing.point_data:
        residue = packing.point_data["residue"][first], packing.point_data["residue_id"][first]
        atom += f" of residue {residue[0]!s} {residue[1]}"
    return f" (X stands for elements that are not known, as of {atom})"


class _Refused:
    """Turns the errors of gemmi into one that names the file and, where it says so, the line."""

    def __init__(self, path: Path, expected: str) -> None:
        self._path, self._expected = path, expected

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if not isinstance(error, (RuntimeError, ValueError)) or isinstance(error, PackingFileError):
            return
        text = " ".join(str(error).split())
        line = re.search(r"(?:in line |^[^:]*:)(\d+)(?::\d+\(\d+\))?: *", text)
        where = f", line {line[1]}" if line else ""
        what = text[line.end() :] if line else text
        raise PackingFileError(
            f"{self._path}{where}: found no text of that format ({what}), expected {self._expected}"
        ) from None


def _is_number(text: str | None) -> bool:
    """Whether a value of CIF is a finite number; its uncertainty may follow in brackets."""
    return math.isfinite(_gemmi().cif.as_number(text)) if text is not None else False


def _content(path: Path, *, compressed: bool) -> bytes:
    """Bytes of a file, or a PackingFileError if it is compressed and damaged."""
    data = path.read_bytes()
    if not compressed:
        return data
    try:
        return gzip.decompress(data)
    except (EOFError, OSError, zlib.error) as error:
        raise PackingFileError(
            f"{path}: found no whole gzip file ({error}), expected one"
        ) from None


def _text(letters: np.ndarray) -> np.ndarray:
    """Text of rows of bytes, which zeros fill up."""
    return np.char.decode(
        np.ascontiguousarray(letters).view(f"S{letters.shape[1]}")[:, 0], "latin-1"
    )


def _spheres(points: np.ndarray, atomic_numbers: np.ndarray) -> pv.PolyData:
    """Atoms with what follows from their elements."""
    gemmi = _gemmi()
    from ..backend import vtkPeriodicTable

    table = vtkPeriodicTable()
    ordinals, element = np.unique(atomic_numbers, return_inverse=True)
    numbers = np.where(ordinals == DEUTERIUM, 1, ordinals)
    known = [gemmi.Element(int(number)) for number in numbers]
    radii = [round(e.vdw_r, 4) if 0 < e.atomic_number <= _LAST_KNOWN else np.nan for e in known]
    names = [
        "D" if ordinal == DEUTERIUM else e.name for ordinal, e in zip(ordinals, known, strict=True)
    ]
    colors = [table.GetDefaultRGBTuple(int(number)) for number in numbers]
    packing = pv.PolyData(np.asarray(points, float))
    packing.point_data["radius"] = np.array(radii)[element]
    packing.point_data["element"] = np.array(names)[element]
    packing.point_data["atomic_number"] = numbers.astype(np.int32)[element]
    rgb = np.array([[color[i] for i in range(3)] for color in colors])
    packing.point_data["rgb"] = np.rint(255 * rgb).astype(np.uint8)[element]
    return packing


def _chosen(flat: FlatAtoms) -> np.ndarray:
    """Whether each atom is not an alternative location that another one is preferred to.

    A residue's locations are weighed by the sum of their atoms' occupancies, so that its atoms are
    of one location where they can be. Where residues of several names share a place, that of the
    best location is taken.
    """
    keep = np.ones(len(flat.altlocs), bool)
    residues: dict[tuple[bytes, int, int], list[int]] = {}
    chains = flat.chain_ids
    for i in np.flatnonzero(flat.altlocs).tolist():
        residue = (chains[i].tobytes(), int(flat.resnums[i]), int(flat.icodes[i]))
        residues.setdefault(residue, []).append(i)
    for atoms in residues.values():
        weights: dict[int, float] = {}
        for i in atoms:
            location = int(flat.altlocs[i])
            weights[location] = weights.get(location, 0.0) + float(flat.occ[i])
        # max() gives the first of equal ones.
        best = max(weights, key=weights.__getitem__)
        name = next(flat.residue_names[i].tobytes() for i in atoms if flat.altlocs[i] == best)
        taken: dict[bytes, int] = {}
        for i in sorted(atoms, key=lambda i: -weights[int(flat.altlocs[i])]):
            same_residue = flat.residue_names[i].tobytes() == name
            if not same_residue or taken.setdefault(flat.atom_names[i].tobytes(), i) != i:
                keep[i] = False
    return keep
