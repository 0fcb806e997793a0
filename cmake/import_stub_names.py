"""Import the classes of VTK that stubs name without importing them.

Usage: import_stub_names.py ROOT PACKAGE FOLDER MODULE...

ROOT is the Python package of VTK, PACKAGE that of the wrapped modules MODULE..., whose stubs lie in
FOLDER. Upstream: VTK 9.7's generate_pyi writes ``'vtkCamera'`` without saying where that class
comes from, so a type checker takes it for a mistake.
"""

import importlib
import re
import sys
from pathlib import Path


def home_of(name, root):
    """Return the module of VTK that wraps a class; None if none of those that are loaded does."""
    for module in sorted(sys.modules):
        if module.startswith(f"{root}.vtk") and name in vars(sys.modules[module]):
            return module
    return None


def with_imports(text, root):
    """Return the text of a stub with the imports that are missing, after those that it has."""
    named = set(re.findall(r"'(vtk\w+)'", text))
    own = set(re.findall(r"^class (\w+)", text, flags=re.MULTILINE))
    homes = {name: home_of(name, root) for name in sorted(named - own)}
    lines = [f"from {home} import {name}" for name, home in homes.items() if home]
    *_, last = re.finditer(r"^import \S+\n", text, flags=re.MULTILINE)
    return text[: last.end()] + "".join(f"{line}\n" for line in lines) + text[last.end() :]


def main(root, package, folder, *names):
    for name in names:
        importlib.import_module(f"{package}.{name}")
    for name in names:
        path = Path(folder, f"{name}.pyi")
        text = path.read_text(encoding="utf-8")
        path.write_text(with_imports(text, root), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
