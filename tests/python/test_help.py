"""The first screen of ``help(spherepacking)``, and what the package offers by name."""

import inspect
import pkgutil
import pydoc
import subprocess
import sys

import pytest
import spherepacking

SCREEN = 50  # lines


def first_screen():
    """Return name, description and contents, as ``python -m pydoc spherepacking`` shows them."""
    text = pydoc.render_doc(spherepacking, renderer=pydoc.plaintext)
    return text.split("\nCLASSES\n")[0]


def test_the_first_screen_is_one():
    assert len(first_screen().splitlines()) <= SCREEN


@pytest.mark.parametrize(
    "name",
    [
        "pyvista.read",
        "packing.packing",
        "ray_cast",
        "path_trace",
        "metaballs",
        "plotter.packing",
        "add",
        "add_metaballs",
        "read",
        "write",
        "pack",
        "apollonian",
        "read_image",
        "write_image",
        "write_render",
        "compare_images",
    ],
)
def test_the_first_screen_shows_the_public_face(name):
    description = first_screen().split("\nPACKAGE CONTENTS\n")[0]
    assert f"``{name}``" in description or f"``{name}(" in description


def test_no_private_module_is_listed():
    names = [module.name for module in pkgutil.iter_modules(spherepacking.__path__)]
    assert "accessor" in names
    # Nor a library, which Python would take for a module if it lay beside the modules.
    assert [name for name in names if name.startswith(("_", "lib"))] == ["__main__"]


def test_all_that_the_first_screen_names_is_there():
    description = first_screen().split("\nPACKAGE CONTENTS\n")[0]
    for owner in (spherepacking.PackingAccessor, spherepacking.PackingComponent):
        assert owner.__name__ in description
    functions = [n for n in spherepacking.__all__ if inspect.isfunction(getattr(spherepacking, n))]
    assert [name for name in functions if f"``{name}``" not in description] == []


def test_names_are_imported_when_they_are_used():
    code = """
import sys
import spherepacking
before = {name for name in sys.modules if name.startswith("spherepacking.")}
assert before == set(), before
for name in spherepacking.__all__:
    getattr(spherepacking, name)
"""
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_type_checkers_see_every_name():
    """They read what is imported for them alone, not the table of homes."""
    source = inspect.getsource(spherepacking)
    for_checkers = source.partition("if TYPE_CHECKING:")[2].partition("__version__: str")[0]
    assert [name for name in spherepacking.__all__ if name not in for_checkers] == []
    assert sorted(spherepacking._HOMES) == sorted(spherepacking.__all__)
