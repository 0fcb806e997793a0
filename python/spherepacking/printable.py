"""Texts from files and from the command line, as they may be shown in a terminal."""

from __future__ import annotations

import re

# The same as in PrintableText.cxx: controls, what turns the order of the letters around it or
# breaks lines, what has no shape; and surrogates, which stand for bytes that are no text (PEP 383).
_HIDDEN = re.compile(
    "[\x00-\x1f\x7f-\x9f\xad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb"
    "\ud800-\udfff\U000e0000-\U000e007f]"
)


def printable(text: str | bytes, longest: int | None = None) -> str:
    r"""Write what has no shape of its own, and may change how others look, as ``\xNN``.

    Such are the controls that begin the escape sequences of terminals, those that turn the order
    of the letters around them (Unicode's bidirectional controls, as in N. Boucher and R. Anderson:
    Trojan Source: invisible vulnerabilities, 2021), and bytes that are no text. Line ends and tabs
    become blanks. PrintableText.cxx does the same in C++.

    Parameters
    ----------
    text : str or bytes
        Text, or UTF-8.
    longest : int, optional
        Of a longer text the middle is left out, so that about so many characters remain.

    Returns
    -------
    str
        The text in printable characters.

    Examples
    --------
    >>> from spherepacking.printable import printable
    >>> print(printable("a\x1b[31mb\tc"))
    a\x1b[31mb c
    >>> printable("x" * 1000, 12)
    'xxxxxx … (988 more characters) … xxxxxx'
    """
    if isinstance(text, bytes):
        text = text.decode("utf-8", "surrogateescape")
    if longest is not None and len(text) > longest:
        half = longest // 2
        begin, end = printable(text[:half]), printable(text[len(text) - half :])
        return f"{begin} … ({len(text) - 2 * half} more characters) … {end}"
    return _HIDDEN.sub(_shown, text)


def quoted(text: str | bytes, longest: int = 40) -> str:
    """Put a printable text into single quotes; of a long one the beginning is enough.

    Parameters
    ----------
    text : str or bytes
        Text, or UTF-8.
    longest : int, default: 40
        How many characters are shown.

    Returns
    -------
    str
        The text, with three points where it goes on.

    Examples
    --------
    >>> from spherepacking.printable import quoted
    >>> quoted("f 1 2 x")
    "'f 1 2 x'"
    """
    if isinstance(text, bytes):
        text = text[: 4 * (longest + 1)].decode("utf-8", "surrogateescape")
    return f"'{printable(text[:longest])}{'...' if len(text) > longest else ''}'"


def _shown(match: re.Match[str]) -> str:
    character = match[0]
    if character in "\t\n\r":
        return " "
    # What could not be decoded is a byte, other surrogates are no characters either.
    errors = "surrogateescape" if "\udc80" <= character <= "\udcff" else "surrogatepass"
    return "".join(f"\\x{byte:02x}" for byte in character.encode("utf-8", errors))
