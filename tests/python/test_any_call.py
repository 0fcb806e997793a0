"""Any arguments to any public call: a result, or one exception that says what was wrong.

Each example is a good call of which up to three arguments are replaced. SPHEREPACKING_CALLS says
how many examples there are; by default as many as take about a minute.
"""

import os
import warnings

import numpy as np
import pyvista as pv
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

EXAMPLES = int(os.environ.get("SPHEREPACKING_CALLS", "4000"))
LONGEST_MESSAGE = 300

CAMERA = [(0.0, 0.0, 9.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
LOOK = {
    "scalars": ["radius", "id", None],
    "rgb": [None, False],
    "cmap": ["viridis", None],
    "clim": [None, (0.0, 1.0), 2.0],
    "log_scale": [False, True],
}
FIELD = {
    "dimensions": [(5, 4, 3), 6],
    "kernel": ["inverse", "wyvill", "gaussian"],
    "weights": [None, [1.0] * 5],
    "count": [None, 3],
    "relative_error": [1e-3, 0.0],
    "bounds": [None, (-1, 1, -1, 1, -1, 1)],
    "radius": [None, 0.5, "radius"],
    **LOOK,
}
RAYS = {
    "camera": [CAMERA],
    "window_size": [(9, 7)],
    "structure": ["bvh", "grid", "none"],
    "cuts": [None, 3],
    "tile": [None, 4, (3, 5)],
    "color": [None, "red"],
    "random_colors": [False, True],
    "radius": [None, 0.5, "radius"],
    **LOOK,
}
CALLS = {
    "ray_cast": {**RAYS, "samples": [1, 2]},
    "path_trace": {
        **RAYS,
        "samples": [1, 2],
        "max_bounces": [0, 2],
        "albedo": [0.5],
        "sky": [1.0, (1.0, 0.5, 0.2), [(0.1, 0.1, 0.1), (1.0, 1.0, 1.0)]],
        "sun": [None, (1.0, 1.0, 1.0)],
        "seed": [0, 7],
        "time_budget": [None, 0.01],
        "noise_target": [None, 0.5],
        "min_samples": [2, 16],
        "exposure": [0.0, 1.0],
        "filmic": [False, True],
        "preview": [False],
        "sky_visible": [True, False],
    },
    "pick": {"camera": [CAMERA], "window_size": [(9, 7)], "x": [4], "y": [3.5], "radius": [None]},
    "metaball_field": {
        **FIELD,
        "threshold": [None, 1.0],
        "gradient": [False, True],
        "strongest": [False, True],
        "blend": [False, True],
    },
    "metaballs": {"threshold": [1.0], **FIELD, "coloring": ["blend", None]},
    "bvh_boxes": {"radius": [None, 0.5]},
    "grid_boxes": {"cuts": [0, 3], "radius": [None, 0.5]},
    "contacts": {"gap": [0.0, 0.1], "periodic": [None, False], "radius": [None, 0.5]},
    "replicate": {"nx": [1, 2], "ny": [1], "nz": [1, 3]},
    "ghosts": {"radius": [None]},
    "wrap": {},
    "with_radius": {"radius": [None, 0.5, "radius", [0.1] * 5]},
}
# What no user would give, or only by mistake; nothing that is right and takes long.
ODD = [
    None,
    True,
    -1,
    0,
    1e-320,
    -1e-222,
    -0.0,
    1e300,
    -1e300,
    float("nan"),
    float("inf"),
    2**31,
    2**63,
    10**400,
    3 + 4j,
    "",
    "3",
    "radius",
    "no such array",
    "\x1b[31m",
    b"radius",
    (),
    (0, 0),
    (1, 2, 3),
    (-1, 5),
    (float("nan"),) * 3,
    [1.0, 2.0, float("inf"), 4.0, 5.0],
    [[0.0] * 3] * 3,
    np.zeros(0),
    np.zeros(5),
    np.full(5, np.nan),
    np.full((5, 3), 0.5, dtype=np.float16),
    np.arange(5, dtype=np.uint8),
    np.array(["a", "b", "c", "d", "e"]),
    np.array([None] * 5),
    np.ma.masked_equal([1.0, 2, 3, 4, 5], 3),
    {},
    {1: 0.5},
    {"a"},
    object(),
    len,
    pv.Camera,
    pv.PolyData(),
    1e6,
    (1e20, 0, 0),
    range(3),
    np.float32(0.25),
    np.int64(2),
    np.bool_(True),
    np.datetime64("2020-01-01"),
]


def small_packing():
    """Five spheres, of which two coincide and one has the radius 0, in a tilted cell."""
    points = [(0, 0, 0), (1, 0, 0), (1, 0, 0), (0, 2, 0.5), (-1, -1, -1)]
    packing = pv.PolyData(np.array(points, dtype=float))
    packing["radius"] = [0.5, 0.25, 0.25, 0.0, 1.0]
    packing["id"] = np.arange(5)
    packing.field_data["cell_vectors"] = [[4.0, 0, 0], [1.0, 4, 0], [0, 0, 4]]
    packing.field_data["cell_origin"] = [[-2.0, -2, -2]]
    packing.field_data["cell_periodic"] = np.array([[1, 1, 0]], dtype=np.uint8)
    return packing


@st.composite
def calls(draw):
    """Draw the name of a call and its arguments."""
    name = draw(st.sampled_from(sorted(CALLS)))
    good = CALLS[name]
    arguments = {key: draw(st.sampled_from(values)) for key, values in good.items()}
    keys = draw(st.lists(st.sampled_from(sorted(good)), max_size=3)) if good else []
    for key in keys:
        number = st.floats() | st.integers(-3, 40)
        arguments[key] = draw(st.sampled_from(ODD) | number | st.tuples(number, number, number))
    return name, arguments


def check_message(error, arguments):
    """Assert that an exception is a sentence for a user."""
    message = error.args[0]
    names = (*arguments, "packing", "cell_vectors", "nx, ny, nz")
    assert message.startswith(tuple(f"{name}: " for name in names)), f"{error!r} of {arguments}"
    assert len(message) <= LONGEST_MESSAGE, message
    assert message.isprintable(), repr(message)


@settings(max_examples=EXAMPLES, suppress_health_check=list(HealthCheck), database=None)
@given(calls())
def test_any_arguments(call):
    name, arguments = call
    packing = small_packing()
    before = packing.copy()
    function = getattr(packing.packing, name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # That a surface is empty is no error.
        warnings.filterwarnings("ignore", "metaballs: the threshold", UserWarning)
        try:
            function(**arguments)
        except (TypeError, ValueError, KeyError) as error:
            check_message(error, arguments)
        except OSError as error:
            assert name == "path_trace"  # where a text may be the file of a sky
            check_message(ValueError(f"sky: {error}"), arguments)
    assert packing == before
