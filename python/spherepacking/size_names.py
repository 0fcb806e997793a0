"""Whether the name of an array says that it holds diameters.

The words are those that tables know, in io/NameMeaning.cxx, and what people write besides.
"""

from __future__ import annotations

import re
from typing import Literal

# Whole words, in lower case.
_DIAMETERS = {
    *("diameter", "diameters", "diam", "dia", "durchmesser", "diametro", "diámetro", "diametre"),
    *("diamètre", "diametres", "diamètres", "диаметр", "直径", "średnica", "çap", "지름"),
    *("ø", "2r"),
}
# Words may be written together, as in eqdiameter and Kugeldurchmesser.
_LAST_PARTS = ("diameter", "diameters", "durchmesser")
_RADII = {
    *("radius", "radii", "radien", "halbmesser", "rayon", "raggio", "radio", "радиус", "半径"),
    *("promień", "raio", "straal", "yarıçap", "반지름"),
}
# With one of these, d is an equivalent diameter.
_EQUIVALENT = {"eq", "equiv", "equivalent"}
# What is made of a diameter with these is another number, mostly.
_OTHERS = {
    *("half", "halved", "semi", "inverse", "inv", "reciprocal", "log", "ln", "ratio", "per", "sq"),
    *("square", "squared", "cubed", "std", "stdev", "sigma", "var", "variance", "error", "err"),
    *("change", "rate", "gradient", "count", "index", "id"),
}
_BRACKETS = re.compile(r"[\[(].*?[\])]")
_CAMEL = re.compile(r"(?<=[a-zà-ÿ])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
_WORDS = re.compile(r"[^\W_]+")
# D50 and d32 are statistics of diameters, diam2 may be one of two or a square.
_STATISTIC = re.compile(r"(?:d|dia|diam|diameter|durchmesser)\d+")


def diameters_in(name: str) -> Literal["yes", "no", "unsure"]:
    """Whether an array of that name holds diameters.

    Parameters
    ----------
    name : str
        Name of an array that somebody takes the radii from. Units may follow it.

    Returns
    -------
    {"yes", "no", "unsure"}
        "unsure" if the name speaks of diameters but may mean another number, as ``half_diameter``
        and ``D50`` do.

    Examples
    --------
    >>> from spherepacking.size_names import diameters_in
    >>> [diameters_in(name) for name in ("pore.diameter", "EqDiameter", "depth", "D50")]
    ['yes', 'yes', 'no', 'unsure']
    """
    plain = _BRACKETS.sub(" ", name)
    words = [word.lower() for word in _WORDS.findall(_CAMEL.sub(" ", plain))]
    said = any(word in _DIAMETERS or word.endswith(_LAST_PARTS) for word in words) or "⌀" in name
    letter = "d" in words
    if words == ["d"] or (letter and set(words) - {"d"} and set(words) - {"d"} <= _EQUIVALENT):
        return "yes"
    if not said:
        numbered = any(map(_STATISTIC.fullmatch, words))
        return "unsure" if letter or numbered else "no"
    other = (
        set(words) & (_RADII | _OTHERS)
        or any(word.startswith(("semi", "half")) for word in words)
        or any(sign in plain for sign in "/^*")
    )
    return "unsure" if other else "yes"
