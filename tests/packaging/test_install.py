"""What an installation offers, from a wheel as well as from a plain CMake install."""

import ast
import importlib
import importlib.metadata
import importlib.util
import inspect
import re
from pathlib import Path

import pytest
import pyvista  # noqa: F401  brings up the VTK that the modules were linked to

MODULES = ("vtkSpherePackingCore", "vtkSpherePackingRendering")
ABSTRACT = {"vtkSpherePackingBoxAlgorithm"}


def wrapped_classes(name):
    """Return the wrapped classes of one module by name."""
    module = importlib.import_module(f"spherepacking.{name}")
    found = dict(inspect.getmembers(module, inspect.isclass))
    assert found, f"{name} wraps no class"
    return found


def package_folder():
    return Path(importlib.util.find_spec("spherepacking").origin).parent


@pytest.mark.parametrize("name", MODULES)
def test_every_class_has_a_stub_with_its_members(name):
    tree = ast.parse((package_folder() / f"{name}.pyi").read_text(encoding="utf-8"))
    stubs = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    classes = wrapped_classes(name)
    assert set(stubs) >= set(classes)
    for class_name, wrapped in classes.items():
        if not class_name.startswith("vtk"):
            continue
        own = {key for key in vars(wrapped) if key[0].isupper() and callable(vars(wrapped)[key])}
        kinds = (ast.FunctionDef, ast.ClassDef)  # a nested enumeration is a class
        declared = {node.name for node in stubs[class_name].body if isinstance(node, kinds)}
        assert own <= declared, f"{class_name}: {sorted(own - declared)} have no stub"


@pytest.mark.parametrize("name", MODULES)
def test_stubs_import_the_classes_that_they_name(name):
    text = (package_folder() / f"{name}.pyi").read_text(encoding="utf-8")
    body = ast.parse(text).body
    known = {node.name for node in body if isinstance(node, ast.ClassDef)}
    for node in body:
        if isinstance(node, ast.ImportFrom):
            known |= {alias.name for alias in node.names}
    assert set(re.findall(r"'(vtk\w+)'", text)) <= known


def test_the_package_is_marked_as_typed():
    assert (package_folder() / "py.typed").is_file()


@pytest.mark.hard
@pytest.mark.parametrize("name", MODULES)
def test_every_class_is_made_prints_and_goes(name):
    for class_name, wrapped in wrapped_classes(name).items():
        if class_name in ABSTRACT:
            with pytest.raises(TypeError, match="abstract"):
                wrapped()
        elif class_name.startswith("vtk"):
            made = wrapped()
            assert made.GetClassName() == class_name
            assert class_name in str(made)


def test_the_metadata_is_found():
    distribution = importlib.metadata.distribution("spherepacking")
    scripts = {point.name: point.value for point in distribution.entry_points}
    assert scripts["spherepacking"] == "spherepacking.__main__:main"
    assert distribution.metadata["Requires-Python"] == ">=3.12"
