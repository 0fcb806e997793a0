"""Write the metadata of a plain CMake install from pyproject.toml.

Usage: write_metadata.py PYPROJECT VERSION FOLDER

FOLDER receives ``<name>-<VERSION>.dist-info`` and one launcher per console script. Dependencies are
left out: a plain install uses what the system's package manager provides, under its own names.
There is no RECORD, so that pip refuses to uninstall what it did not install.
"""

import sys
import tomllib
from pathlib import Path

LAUNCHER = """\
#!{python}
import sys

from {module} import {function}

sys.exit({function}())
"""


def entry_points(project):
    """Return the text of entry_points.txt."""
    groups = {"console_scripts": project.get("scripts", {})} | project.get("entry-points", {})
    sections = []
    for group, entries in groups.items():
        lines = [f"{name} = {target}" for name, target in entries.items()]
        sections.append("\n".join([f"[{group}]", *lines]) + "\n")
    return "\n".join(sections)


def main(pyproject, version, folder):
    project = tomllib.loads(Path(pyproject).read_text(encoding="utf-8"))["project"]
    folder = Path(folder)
    info = folder / f"{project['name']}-{version}.dist-info"
    info.mkdir(parents=True, exist_ok=True)
    metadata = {
        "Metadata-Version": "2.4",
        "Name": project["name"],
        "Version": version,
        "Summary": project["description"],
        "License-Expression": project["license"],
        "Requires-Python": project["requires-python"],
    }
    text = "".join(f"{key}: {value}\n" for key, value in metadata.items())
    (info / "METADATA").write_text(text, encoding="utf-8")
    (info / "entry_points.txt").write_text(entry_points(project), encoding="utf-8")
    (info / "INSTALLER").write_text("cmake\n", encoding="utf-8")
    for name, target in project.get("scripts", {}).items():
        module, function = target.split(":")
        launcher = LAUNCHER.format(python=sys.executable, module=module, function=function)
        (folder / name).write_text(launcher, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
