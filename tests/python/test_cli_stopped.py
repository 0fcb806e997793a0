"""Ctrl-C while the command ``spherepacking`` is at work."""

import signal
import subprocess
import sys

import numpy as np
import pytest
from spherepacking.cli.main import main


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "two.spheres"
    path.write_text("0 0 0 2\n10 0 0 1\n")
    return path


def test_stopped_while_it_is_loaded():
    """Ctrl-C within the first tenth of a second, when the interpreter imports."""
    code = """
import sys
class Stop:
    def find_spec(self, name, path, target=None):
        if name == "cyclopts":
            raise KeyboardInterrupt
sys.meta_path.insert(0, Stop())
from spherepacking.__main__ import main
sys.exit(main())
"""
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False
    )
    assert (result.returncode, result.stderr) == (130, "spherepacking: stopped\n")


def test_stopped_later(file, monkeypatch, capsys):
    def describe(_packing):
        raise KeyboardInterrupt

    monkeypatch.setattr("spherepacking.cli.info.describe", describe)
    assert main(["info", str(file)]) == 130
    assert capsys.readouterr().err == "spherepacking: stopped\n"


def test_out_of_memory(file, monkeypatch, capsys):
    def describe(_packing):
        raise MemoryError("Unable to allocate 9.5 GiB")

    monkeypatch.setattr("spherepacking.cli.info.describe", describe)
    assert main(["info", str(file)]) == 2
    assert (
        capsys.readouterr().err == "spherepacking: not enough memory: Unable to allocate 9.5 GiB\n"
    )


@pytest.mark.parametrize("command", ["info", "render"])
def test_stopped_at_any_time(file, command):
    """Libraries that are being loaded may crash when Ctrl-C comes."""
    options = ["-o", file.with_suffix(".png")] if command == "render" else []
    for wait in np.linspace(0.05, 1.0, 8):
        process = subprocess.Popen(
            [sys.executable, "-m", "spherepacking", command, file, *options],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        )
        try:
            process.wait(wait)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
        # The first and the last milliseconds are the interpreter's: a traceback, or the signal.
        assert process.returncode in (0, 130, 1, -signal.SIGINT), said
