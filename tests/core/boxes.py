"""Filters from packings to boxes: their output box by box, and packings that are hard for them."""

import numpy as np
import pyvista as pv
from spherepacking.vtk_tools import ErrorLog


def boxes_of(algorithm, packing):
    algorithm.SetInputData(packing)
    with ErrorLog(algorithm) as log:
        algorithm.Update()
    assert not log.messages
    return pv.wrap(algorithm.GetOutput())


def refusal(algorithm, packing):
    algorithm.SetInputData(packing)
    with ErrorLog(algorithm) as log:
        algorithm.Update()
    assert algorithm.GetErrorCode() != 0
    assert algorithm.GetErrorMessage() in log.messages[0]
    assert algorithm.GetOutput().GetNumberOfCells() == 0
    return algorithm.GetErrorMessage()


def one_a_box(boxes, name):
    values = boxes.cell_data[name].reshape(boxes.n_points // 8, -1)
    assert (values == values[:, :1]).all()
    return values[:, 0]


def knot(n):
    t = np.linspace(0, 2 * np.pi, n, endpoint=False)
    return np.column_stack([np.cos(t), np.sin(2 * t), np.sin(3 * t)])


CASES = {
    "random": lambda rng: (rng.random((300, 3)), rng.uniform(0.0, 0.1, 300)),
    "small radii far away": lambda rng: (1e7 + 0.01 * rng.random((200, 3)), np.full(200, 1e-3)),
    "radius ratio 1e6": lambda rng: (rng.random((100, 3)), np.logspace(-6, 0, 100)),
    "one plane": lambda rng: (rng.random((100, 3)) * [1, 1, 0], rng.random(100) * 0.1),
    "one line": lambda rng: (rng.random((100, 3)) * [0, 0, 1], rng.random(100) * 0.01),
    "one point": lambda rng: (np.full((50, 3), 0.3), np.linspace(0, 1, 50)),
    "no extent": lambda rng: (np.full((5, 3), 0.3), np.zeros(5)),
    "flat without radii": lambda rng: (rng.random((50, 3)) * [1, 1, 0], np.zeros(50)),
    "duplicates": lambda rng: (np.repeat(rng.random((3, 3)), 1000, axis=0), np.full(3000, 0.2)),
    "tangent": lambda rng: (np.argwhere(np.ones((4, 4, 4))), np.full(64, 0.5)),
    "tiny lengths": lambda rng: (1e-200 * rng.random((50, 3)), np.full(50, 1e-201)),
    "large lengths": lambda rng: (1e200 * rng.random((50, 3)), np.full(50, 1e199)),
    "a knot": lambda rng: (knot(500), np.full(500, 0.03)),
}
