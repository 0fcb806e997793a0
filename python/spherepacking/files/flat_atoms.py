"""The atoms of a molecule as arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    import gemmi

DEUTERIUM = 119
"""gemmi's number of deuterium in its arrays, which keep it apart from hydrogen."""


class FlatAtoms(NamedTuple):
    """What gemmi.FlatStructure holds of each atom, in the same form.

    Attributes
    ----------
    pos, elements, occ, b_iso, resnums, icodes, altlocs : numpy.ndarray
        Places (n, 3), numbers of elements, occupancies, temperature factors, numbers of residues,
        codes of insertion and of locations.
    atom_names, residue_names, chain_ids : numpy.ndarray
        Bytes of texts (n, width), which zeros fill up.
    """

    pos: np.ndarray
    elements: np.ndarray
    occ: np.ndarray
    b_iso: np.ndarray
    resnums: np.ndarray
    icodes: np.ndarray
    altlocs: np.ndarray
    atom_names: np.ndarray
    residue_names: np.ndarray
    chain_ids: np.ndarray


def element_number(element: gemmi.Element) -> int:
    """Atomic number, or DEUTERIUM."""
    return DEUTERIUM if element.name == "D" else element.atomic_number


def flat_atoms(model: gemmi.Model) -> FlatAtoms:
    """Atoms of a model.

    Parameters
    ----------
    model : gemmi.Model
        Holds one atom or more, whose names may have any length.

    Returns
    -------
    FlatAtoms
        Its atoms in order.
    """
    import gemmi

    single = gemmi.Structure()
    single.add_model(model)
    try:
        flat = gemmi.FlatStructure(single)
    except RuntimeError:  # names of 8 letters or more
        return _one_by_one(model)
    return FlatAtoms(*(np.asarray(getattr(flat, name)) for name in FlatAtoms._fields))


def _one_by_one(model: gemmi.Model) -> FlatAtoms:
    rows = list(model.all())
    atoms = [row.atom for row in rows]
    residues = [row.residue for row in rows]
    return FlatAtoms(
        pos=np.array([atom.pos.tolist() for atom in atoms]),
        elements=np.array([element_number(atom.element) for atom in atoms]),
        occ=np.array([atom.occ for atom in atoms]),
        b_iso=np.array([atom.b_iso for atom in atoms]),
        resnums=np.array([residue.seqid.num for residue in residues]),
        icodes=np.array([ord(residue.seqid.icode) for residue in residues]),
        altlocs=np.array([ord(atom.altloc) for atom in atoms]),
        atom_names=_letters([atom.name for atom in atoms]),
        residue_names=_letters([residue.name for residue in residues]),
        chain_ids=_letters([row.chain.name for row in rows]),
    )


def _letters(texts: list[str]) -> np.ndarray:
    """Bytes of texts."""
    array = np.array([text.encode() for text in texts])
    return array.view(np.uint8).reshape(len(texts), -1)
