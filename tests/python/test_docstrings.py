"""The examples in the docstrings do what they say."""

import doctest
import importlib
import pkgutil

import pytest
import spherepacking

MODULES = [
    module.name
    for module in pkgutil.walk_packages(spherepacking.__path__, "spherepacking.")
    # Not the wrapped modules, what runs the command, and what needs Embree.
    if not module.name.rpartition(".")[2].startswith(("vtkSphere", "__main__", "embree"))
]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    module = importlib.import_module(name)
    found = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE)
    assert found.failed == 0


def test_there_are_examples():
    assert "spherepacking.accessor" in MODULES
    finder = doctest.DocTestFinder()
    module = importlib.import_module("spherepacking.accessor")
    assert sum(bool(test.examples) for test in finder.find(module)) >= 5
