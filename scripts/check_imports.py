"""Check what import-linter does not see: imports of the package's root, which leads to every floor.

    python scripts/check_imports.py [FOLDER]

The modules of the package may take its version alone from its root, and import nothing by a name
that is made while the program runs. The root itself may, and backend/, which imports VTK by the
name that PyVista has chosen. Prints each import that is against that,
with file and line, and exits with status 1 if there is one. FOLDER is python/spherepacking by
default.
"""

from __future__ import annotations

import ast
import sys
from pathlib import Path

ALLOWED = {"__version__"}
FREE = ("__init__.py", "backend")


def roots_of(node: ast.AST, package: str, depth: int, folder: Path) -> list[str]:
    """What a statement takes from the root of a package, in a module `depth` folders below it."""
    if isinstance(node, ast.Import):
        return ["all of it" for name in node.names if name.name == package]
    if isinstance(node, ast.ImportFrom):
        at_root = node.level == depth + 1 or node.level == 0
        if at_root and (node.module or "") == (package if node.level == 0 else ""):
            names = [name.name for name in node.names]
            return [n for n in names if n not in ALLOWED and not is_module(folder / n)]
    if isinstance(node, ast.Call):
        called = ast.unparse(node.func)
        return [called] if called.split(".")[-1] in ("import_module", "__import__") else []
    return []


def is_module(path: Path) -> bool:
    """Whether a module or a folder of modules lies there, which import-linter sees."""
    return path.is_dir() or path.with_suffix(".py").is_file()


def main(folder: Path) -> int:
    faults = []
    for file in sorted(folder.rglob("*.py")):
        inside = file.relative_to(folder)
        if inside.parts[0] in FREE:
            continue
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            for taken in roots_of(node, folder.name, len(inside.parts) - 1, folder):
                faults.append(
                    f"{file}:{node.lineno}: found an import of {taken} from the root, or by a made "
                    "name, expected one from the module that has it"
                )
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    root = Path(__file__).resolve().parents[1]
    sys.exit(main(Path(sys.argv[1]) if len(sys.argv) > 1 else root / "python" / "spherepacking"))
