"""The elements of a VTK file in XML, up to the data that are appended behind them."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING
from xml.parsers import expat

if TYPE_CHECKING:
    import mmap

_CHUNK = 1 << 20
# What remains of a start tag: ">" may stand in a value.
_REST_OF_TAG = re.compile(rb"(?:[^>\"']|\"[^\"]*\"|'[^']*')*>")
_INTEGER = re.compile(r"\s*[+-]?[0-9]{1,30}\s*")
_NAME_OF_APPENDED = b"<AppendedData"


@dataclass
class Element:
    """An element, without its text.

    Attributes
    ----------
    name : str
        Name of its tag.
    attributes : dict[str, str]
        What the tag says.
    parent : Element or None
        Element that it lies in.
    content : int
        Byte at which its text begins.
    children : list[Element]
        Elements that lie in it.
    """

    name: str
    attributes: dict[str, str]
    parent: Element | None
    content: int
    children: list[Element] = field(default_factory=list)

    def integer(self, attribute: str, default: int | None = None) -> int | None:
        """Return an attribute as an integer, or `default` if it is absent.

        Raises
        ------
        ValueError
            If it is no integer.
        """
        text = self.attributes.get(attribute)
        if text is None:
            return default
        if _INTEGER.fullmatch(text) is None:
            raise ValueError(f"found {attribute}={text[:40]!r}, expected an integer")
        return int(text)


def elements_of(data: mmap.mmap) -> list[Element]:
    """Elements of a file in XML in their order, up to and with the one of appended data.

    Parameters
    ----------
    data : mmap.mmap
        The file.

    Returns
    -------
    list[Element]
        Not empty.

    Raises
    ------
    ValueError
        If it is no XML up to there.
    """
    found: list[Element] = []
    open_ones: list[Element] = []
    parser = expat.ParserCreate()

    def start(name: str, attributes: dict[str, str]) -> None:
        rest = _REST_OF_TAG.match(data, parser.CurrentByteIndex)
        content = rest.end() if rest else len(data)
        if "Array" in name and data.find(b">", parser.CurrentByteIndex) + 1 != content:
            # VTK looks for values behind it.
            raise ValueError(
                f"found > within the tag of an array in line {parser.CurrentLineNumber}"
                ", expected &gt;"
            )
        parent = open_ones[-1] if open_ones else None
        element = Element(name, attributes, parent, content)
        if parent is not None:
            parent.children.append(element)
        found.append(element)
        open_ones.append(element)

    def end(_: str) -> None:
        open_ones.pop()

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    at = data.find(_NAME_OF_APPENDED)
    tag = None if at < 0 else _REST_OF_TAG.match(data, at)
    last = len(data) if tag is None else tag.end()
    try:
        for i in range(0, last, _CHUNK):
            parser.Parse(data[i : min(last, i + _CHUNK)], False)
        if tag is None:
            parser.Parse(b"", True)
    except expat.ExpatError as error:
        text = expat.ErrorString(error.code)
        raise ValueError(f"found no XML in line {error.lineno} ({text}), expected it") from None
    if not found:
        raise ValueError("found no element of XML, expected one")
    return found
