"""Check that what is compiled for AVX2 defines nothing that the linker could take for other code.

    python scripts/check_symbols.py BUILD_FOLDER

An inline function that is compiled in several objects is kept once by the linker, from whichever
object comes first. One from an object for AVX2 would end the process on other processors, so all
that such an object shares has to lie in the namespace Avx2 (see base/Simd.h). BUILD_FOLDER is one
that CMake has configured; its sources *Avx2.cxx are compiled here as in the build, and once more
with the least optimisation that inlines. Prints what is found, and exits with status 1 if anything
is.
"""

from __future__ import annotations

import json
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# Weak definitions, as nm tells them: functions, and data with or without a type.
WEAK = "WVuw"
# What the linker may share: no code, but a reference to the runtime of exceptions.
HARMLESS = re.compile(r"^DW\.ref\.")


def commands_of(build: Path) -> list[list[str]]:
    """The compiler's commands for the sources, without their output."""
    commands = []
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if entry["file"].endswith("Avx2.cxx"):
            words = shlex.split(entry["command"])
            output = words.index("-o")
            commands.append(words[:output] + words[output + 2 :])
    return commands


def shared_symbols(command: list[str]) -> list[str]:
    """Names outside of the namespace that the object of a command shares with others."""
    with tempfile.NamedTemporaryFile(suffix=".o") as target:
        subprocess.run([*command, "-o", target.name], check=True)
        listing = subprocess.run(
            ["nm", "--demangle", "--defined-only", target.name],
            check=True,
            capture_output=True,
            text=True,
        ).stdout
    symbols = [line.split(maxsplit=2)[1:] for line in listing.splitlines()]
    return [
        name
        for kind, name in symbols
        if kind in WEAK and "Avx2" not in name and not HARMLESS.match(name)
    ]


def main(build: Path) -> int:
    commands = commands_of(build)
    if not commands:
        print(f"{build}: found no sources *Avx2.cxx, as on processors other than x86-64")
        return 0
    levels = [[*command, level] for command in commands for level in ("-O3", "-O1")]
    with ThreadPoolExecutor() as threads:
        found = list(threads.map(shared_symbols, levels))
    for command, names in zip(levels, found, strict=True):
        source = next(word for word in command if word.endswith("Avx2.cxx"))
        for name in names:
            print(f"{source} ({command[-1]}): found {name}, expected it in the namespace Avx2")
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
