"""Make what fuzzing of the readers begins with: every small input that the tests have.

Usage: make_corpus.py FOLDER

A target takes the format from the first byte and the options from the second, so that each input is
there once for every format. libFuzzer throws away those that teach it nothing.
"""

import ast
import hashlib
import sys
from pathlib import Path

TESTS = Path(__file__).parent.parent
FORMATS = 28
LARGEST = 2000


def texts_of(path):
    """Yield the texts of a Python file that may be the content of a packing's."""
    for node in ast.walk(ast.parse(path.read_text())):
        text = node.value if isinstance(node, ast.Constant) else None
        if isinstance(text, str) and "\n" in text and any(c.isdigit() for c in text):
            yield text.encode()


def inputs():
    """Yield each input once."""
    seen = set()
    for path in sorted((TESTS / "reader").glob("*.py")):
        seen.update(texts_of(path))
    for path in sorted((TESTS / "data").iterdir()):
        seen.add(path.read_bytes()[:LARGEST])
    return sorted(seen)


def main():
    """Write the inputs into the folder of the command line."""
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for data in inputs():
        for kind in range(FORMATS):
            content = bytes((kind, len(data) % 256)) + data[:LARGEST]
            (folder / hashlib.sha256(content).hexdigest()[:16]).write_bytes(content)


if __name__ == "__main__":
    main()
