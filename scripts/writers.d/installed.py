"""Where the programs are that scripts/writers has installed, and how they are run."""

from __future__ import annotations

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

_LONGEST = 300  # seconds; all of them need less than ten


@dataclass(frozen=True)
class Installed:
    """The programs of Debian and of PyPI below a folder."""

    folder: Path

    @property
    def debian(self) -> Path:
        return self.folder / "debian"

    def run_debian(self, command: list[str], cwd: Path) -> str:
        """Run a program of Debian and return what it prints."""
        return _run([str(self.debian / "usr/bin" / command[0]), *command[1:]], cwd, self._paths())

    def run_python(self, script: str, cwd: Path, *arguments: str) -> str:
        """Run a script with what is installed from PyPI and return what it prints."""
        (cwd / "script.py").write_text(script)
        pypi = self.folder / "pypi"
        paths = {"LD_LIBRARY_PATH": str(pypi / "lib")}  # where the package mpich has its library
        return _run([str(pypi / "bin/python"), "script.py", *arguments], cwd, paths)

    def _paths(self) -> dict[str, str]:
        """Return what programs need that are not where Debian builds them for."""
        usr = self.debian / "usr"
        libraries = next(usr.glob("lib/*-linux-gnu"))
        blas = libraries / "libopenblas.so.0"  # update-alternatives makes it in a system
        if not blas.exists() and (built := sorted(libraries.glob("openblas*/libopenblas*-r*.so"))):
            blas.symlink_to(built[0])
        esys = usr / "lib/python3/dist-packages/esys/lsm"
        yade = libraries / "yade-double"
        search = [
            libraries,
            self.debian / "lib" / libraries.name,
            usr / "lib",
            *(libraries / name for name in ("blas", "lapack", "pmix2/lib")),
            *(yade, yade / "py/yade", yade / "py/yade/qt"),
            *(esys, esys / "util", esys / "geometry"),
        ]
        mpi = libraries / "openmpi"
        return {
            "LD_LIBRARY_PATH": ":".join(map(str, search)),
            "PYTHONPATH": str(usr / "lib/python3/dist-packages"),
            "PATH": f"{usr / 'bin'}:{os.environ['PATH']}",
            "YADE_PREFIX": str(usr),
            "GMXLIB": str(usr / "share/gromacs/top"),
            "OPENBLAS_NUM_THREADS": "1",
            "OPAL_PREFIX": str(mpi),
            "OPAL_BINDIR": str(usr / "bin"),
            "OPAL_LIBDIR": str(mpi / "lib"),
            "OPAL_PKGLIBDIR": str(mpi / "lib/openmpi3"),
            "OPAL_DATADIR": str(usr / "share"),
            "OPAL_PKGDATADIR": str(usr / "share/openmpi"),
            "OPAL_SYSCONFDIR": str(self.debian / "etc"),
            "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        }


def _run(command: list[str], cwd: Path, paths: dict[str, str]) -> str:
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    done = subprocess.run(
        command,
        cwd=cwd,
        env=environment | paths,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=_LONGEST,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}: exit status {done.returncode}\n{done.stdout}")
    return done.stdout
