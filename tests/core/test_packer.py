"""vtkSpherePacker: packings checked sphere by sphere, on random, on real and on hard surfaces."""

import numpy as np
import pytest
import pyvista as pv
from spherepacking.backend import vtkSpherePacker
from surfaces import (
    ball,
    blob,
    check_packing,
    distances,
    read_off,
    surface_of,
    together,
    triangles_of,
    winding_numbers,
)


def packer_of(mesh, count=200, seed=0):
    packer = vtkSpherePacker()
    packer.SetInputData(mesh)
    packer.SetNumberOfSpheres(count)
    packer.SetSeed(seed)
    return packer


def pack(mesh, count=200, seed=0):
    packer = packer_of(mesh, count, seed)
    packer.Update()
    assert packer.GetErrorMessage() == ""
    return pv.wrap(packer.GetOutput())


def message_of(packer):
    errors = []
    for source in (packer, packer.GetExecutive()):
        source.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    packer.Update()
    assert errors
    assert packer.GetOutput().GetNumberOfPoints() == 0
    return packer.GetErrorMessage()


# --- random and real surfaces -----------------------------------------------------------------


@pytest.mark.parametrize("roughness", [0.0, 0.3, 0.8])
def test_random_surfaces(rng, roughness):
    mesh = blob(rng, roughness)
    packing = pack(mesh, 400)
    assert packing.n_points == 400
    check_packing(packing, mesh, rng)
    assert packing.field_data["volume_fraction"][0] > 0.6


def test_bunny(data_file, rng):
    mesh = pv.read(data_file("blob.obj"))
    packing = pack(mesh, 300)
    check_packing(packing, mesh, rng, samples=60)
    assert packing.field_data["volume_fraction"][0] > 0.65


def test_pig(data_file, rng):
    mesh = read_off(data_file("blob.off"))
    packing = pack(mesh, 500)
    check_packing(packing, mesh, rng)
    assert packing.field_data["volume_fraction"][0] > 0.7


def test_dragon_with_edges_that_many_triangles_share(data_file, rng):
    mesh = pv.read(data_file("cubes.ply"))
    packing = pack(mesh, 300)
    # As scanned it is turned outwards everywhere.
    check_packing(packing, mesh, rng, samples=40)
    assert packing.field_data["volume_fraction"][0] > 0.55


# --- the largest comes first ------------------------------------------------------------------


def test_ball_first_in_a_ball(rng):
    mesh = blob(rng, roughness=0.0)
    center = np.asarray(mesh.points).mean(axis=0)
    corners = triangles_of(mesh)
    most = np.linalg.norm(corners[0, 0] - center)
    least = distances(mesh, [center])[0]
    packing = pack(mesh, 5)
    assert 0.999999 * least <= packing["radius"][0] <= most
    assert np.linalg.norm(packing.points[0] - center) < most - least


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_cube_holds_its_inscribed_sphere(seed):
    packing = pack(pv.Cube(), 9, seed)
    assert packing["radius"][0] == pytest.approx(0.5, rel=1e-5)
    np.testing.assert_allclose(packing.points[0], 0, atol=1e-4)
    # In a corner, r (1 + sqrt(3)) + 1/2 is half of the diagonal.
    corner = (np.sqrt(3) - 1) / (np.sqrt(3) + 1) / 2
    np.testing.assert_allclose(packing["radius"][1:], corner, rtol=1e-3)


def test_tetrahedron():
    mesh = pv.Tetrahedron()
    edge = np.linalg.norm(mesh.points[0] - mesh.points[1])
    assert pack(mesh, 1)["radius"][0] == pytest.approx(edge / np.sqrt(24), rel=1e-5)


def test_the_largest_lies_between_reflex_edges(rng):
    # A cross of four arms of width 1: the sphere in the middle touches the four inner edges.
    outline = [(3, 1), (1, 1), (1, 3), (-1, 3), (-1, 1), (-3, 1)]
    outline += [(-x, -y) for x, y in outline]
    base = pv.PolyData([(x / 2, y / 2, 0.0) for x, y in outline], faces=[12, *range(12)])
    mesh = base.triangulate().extrude((0, 0, 2), capping=True).triangulate().clean()
    packing = pack(mesh, 50)
    # The bottom of the extrusion is turned inwards.
    check_packing(packing, mesh, rng, inside=lambda places: np.abs(places[:, :2]).min(axis=1) < 0.5)
    assert packing["radius"][0] == pytest.approx(np.sqrt(0.5), rel=1e-4)


def test_equal_places_along_a_slab(rng):
    mesh = pv.Box((0, 1, 0, 1, 0, 0.1)).triangulate()
    packing = pack(mesh, 60)
    check_packing(packing, mesh, rng)
    assert packing["radius"][0] == pytest.approx(0.05, rel=1e-5)
    assert (packing["radius"] > 0.049).sum() > 30


# --- hard surfaces ----------------------------------------------------------------------------


def test_points_of_their_own_for_each_triangle(rng):
    mesh = ball()
    apart = surface_of(
        triangles_of(mesh).reshape(-1, 3), np.arange(3 * mesh.n_cells).reshape(-1, 3)
    )
    check_packing(pack(apart, 100), mesh, rng)


@pytest.mark.parametrize("turned", [0.3, 0.5, 1.0])
def test_triangles_turned_at_random(rng, turned):
    mesh = blob(rng)
    faces = mesh.faces.reshape(-1, 4)[:, 1:].copy()
    chosen = rng.random(len(faces)) < turned
    faces[chosen] = faces[chosen][:, ::-1]
    packing = pack(surface_of(mesh.points, faces), 300)
    check_packing(packing, mesh, rng)
    # Corners in another order round differently, which may change the order of places.
    straight = pack(mesh, 300)
    assert packing["radius"][0] == pytest.approx(straight["radius"][0], rel=1e-5)
    filled = [found.field_data["volume_fraction"][0] for found in (packing, straight)]
    assert filled[0] == pytest.approx(filled[1], abs=0.01)


def test_quads_and_triangles_are_the_same(rng):
    mesh = pv.Cube(x_length=2.0).clean()
    packing = pack(mesh, 50)
    check_packing(packing, mesh.triangulate(), rng)


def test_a_hole_inside(rng):
    mesh = together(ball(1.0), ball(0.5, subdivisions=2))
    packing = pack(mesh, 100)
    lengths = np.linalg.norm(packing.points, axis=1)
    check_packing(packing, mesh, rng, inside=lambda places: np.linalg.norm(places, axis=1) > 0.5)
    assert (lengths - packing["radius"] > 0.45).all()
    assert packing["radius"][0] == pytest.approx(0.25, rel=0.03)


def test_a_hole_that_shares_a_wall():
    mesh = together(
        pv.Cube(), pv.Cube(center=(-0.3, 0, 0), x_length=0.4, y_length=0.4, z_length=0.4)
    )
    packing = pack(mesh, 50)
    assert packing.field_data["surface_volume"][0] == pytest.approx(1 - 0.4**3)
    assert (np.abs(packing.points - [-0.3, 0, 0]).max(axis=1) > 0.2).all()


@pytest.mark.parametrize("turned", [False, True])
def test_every_triangle_twice(rng, turned):
    mesh = blob(rng)
    faces = mesh.faces.reshape(-1, 4)[:, 1:]
    twice = surface_of(mesh.points, np.vstack([faces, faces[:, ::-1] if turned else faces]))
    packing = pack(twice, 100)
    check_packing(packing, mesh, rng)
    assert packing.field_data["surface_volume"][0] == pytest.approx(mesh.volume, rel=1e-4)


def test_some_triangles_twice(rng):
    mesh = blob(rng)
    faces = mesh.faces.reshape(-1, 4)[:, 1:]
    more = faces[rng.random(len(faces)) < 0.3]
    packing = pack(surface_of(mesh.points, np.vstack([faces, more])), 100)
    check_packing(packing, mesh, rng)
    assert packing.field_data["surface_volume"][0] == pytest.approx(mesh.volume, rel=1e-4)


def test_a_triangle_three_times(rng):
    mesh = ball(subdivisions=2)
    faces = mesh.faces.reshape(-1, 4)[:, 1:]
    more = faces[rng.random(len(faces)) < 0.3]
    packing = pack(surface_of(mesh.points, np.vstack([faces, more, more[:, ::-1]])), 100)
    check_packing(packing, mesh, rng)
    assert packing.field_data["surface_volume"][0] == pytest.approx(mesh.volume, rel=1e-4)


def test_a_triangle_twice_beside_a_wall():
    faces_of_cubes = together(pv.Cube(), pv.Cube(center=(1, 0, 0)))
    faces = faces_of_cubes.faces.reshape(-1, 4)[:, 1:]
    packing = pack(surface_of(faces_of_cubes.points, np.vstack([faces, faces[:1]])), 20)
    assert packing.field_data["surface_volume"][0] == pytest.approx(2.0)


@pytest.mark.parametrize("turned", ["the same way", "at random"])
def test_a_sheet_inside_each_triangle_twice(rng, turned):
    """It bounds nothing, but spheres do not cross it, and volume and inside are the cube's."""
    cube = pv.Cube().triangulate().clean()
    sheet = pv.Plane(i_size=0.8, j_size=0.8, i_resolution=8, j_resolution=8).triangulate().clean()
    sheet = sheet.translate((0.0, 0.0, 0.1))
    faces = np.tile(sheet.faces.reshape(-1, 4)[:, 1:], (2, 1))
    if turned == "at random":
        back = rng.random(len(faces)) < 0.5
        faces[back] = faces[back][:, ::-1]
    both = surface_of(
        np.vstack([cube.points, sheet.points]),
        np.vstack([cube.faces.reshape(-1, 4)[:, 1:], faces + cube.n_points]),
    )
    packing = pack(both, 200)
    assert packing.field_data["surface_volume"][0] == pytest.approx(1.0)
    check_packing(packing, together(cube, sheet), rng, inside=lambda points: np.abs(points) < 0.5)


def test_many_shells_that_overlap(rng):
    centers = rng.normal(size=(100, 3)) * 0.3
    mesh = together(*[ball(1.0, center, 2) for center in centers])
    packing = pack(mesh, 10)
    away = np.linalg.norm(packing.points[:, None] - centers, axis=2).min(axis=1)
    assert (away < 1.0).all()


def test_a_shell_that_pokes_out_is_no_hole():
    middle = np.full(3, 0.85 / np.sqrt(3.0))
    mesh = together(ball(1.0), ball(0.2, middle))
    packing = pack(mesh, 500)
    inside = np.linalg.norm(packing.points - middle, axis=1) < 0.2
    assert inside.any()
    volumes = 4 / 3 * np.pi * np.array([1.0, 0.2**3])
    assert packing.field_data["surface_volume"][0] == pytest.approx(volumes.sum(), rel=0.02)


def test_voxels_turned_at_random(rng):
    # Faces of one voxel belong to several patches, where four of them share an edge with others.
    voxels = pv.ImageData(dimensions=(9, 9, 9))
    voxels.cell_data["solid"] = np.random.default_rng(12).random(voxels.n_cells)
    solid = voxels.threshold(0.5, scalars="solid")
    faces = solid.extract_surface(algorithm=None).triangulate()
    corners = faces.faces.reshape(-1, 4)[:, 1:].copy()
    chosen = rng.random(len(corners)) < 0.5
    corners[chosen] = corners[chosen][:, ::-1]
    packing = pack(surface_of(faces.points, corners), 300)
    assert packing.field_data["surface_volume"][0] == pytest.approx(solid.n_cells)


def test_a_surface_that_crosses_itself():
    dome = pv.ParametricBohemianDome().triangulate().clean()
    packing = pack(dome, 50)
    assert packing.n_points == 50
    assert np.isnan(packing.field_data["volume_fraction"][0])


def test_points_that_are_nearly_the_same(rng):
    mesh = ball()
    corners = triangles_of(mesh).reshape(-1, 3)
    points = corners + rng.uniform(-1e-8, 1e-8, corners.shape)
    packing = pack(surface_of(points, np.arange(len(points)).reshape(-1, 3)), 100)
    check_packing(packing, mesh, rng)
    # Ten times as far apart as what is the same.
    points = corners + rng.uniform(-2e-6, 2e-6, corners.shape)
    apart = surface_of(points, np.arange(len(points)).reshape(-1, 3))
    assert "open edges" in message_of(packer_of(apart))


def test_stacked_cubes_turned_at_random(rng):
    side = range(4)
    cubes = [
        pv.Cube(center=(x, y, z)).triangulate().clean() for x in side for y in side for z in side
    ]
    mesh = together(*cubes)
    faces = mesh.faces.reshape(-1, 4)[:, 1:].copy()
    chosen = rng.random(len(faces)) < 0.5
    faces[chosen] = faces[chosen][:, ::-1]
    packing = pack(surface_of(mesh.points, faces), 64)
    assert packing.field_data["surface_volume"][0] == pytest.approx(64.0)
    np.testing.assert_allclose(packing["radius"], 0.5, rtol=1e-3)


@pytest.mark.parametrize("thickness", [0.1, 0.01])
def test_a_thin_shell(rng, thickness):
    mesh = together(ball(1.0), ball(1.0 - thickness))
    packing = pack(mesh, 40)
    lengths = np.linalg.norm(packing.points, axis=1)
    check_packing(packing, mesh, rng, inside=lambda x: np.linalg.norm(x, axis=1) > 0.9 - thickness)
    assert (lengths > 1 - thickness - 0.02).all()
    assert packing["radius"][-1] > 0.3 * thickness


def test_a_hole_that_shares_two_walls():
    mesh = together(pv.Cube(), pv.Box((-0.5, 0, -0.5, 0, -0.3, 0.2)))
    packing = pack(mesh, 50)
    assert packing.field_data["surface_volume"][0] == pytest.approx(0.875)


@pytest.mark.parametrize("thickness", [2e-3, 1e-5])
def test_a_thin_plate(rng, thickness):
    mesh = pv.Cube(x_length=1.0, y_length=1.0, z_length=thickness).triangulate().clean()
    packing = pack(mesh, 20)
    check_packing(packing, mesh, rng)
    np.testing.assert_allclose(packing["radius"], 0.5 * thickness, rtol=1e-3)


def test_unused_points_do_not_matter(rng):
    mesh = pv.Cube().triangulate().clean()
    faces = mesh.faces.reshape(-1, 4)[:, 1:]
    more = surface_of(np.vstack([mesh.points, [[0, 0, 1e9]]]), faces)
    np.testing.assert_array_equal(pack(more, 20).points, pack(mesh, 20).points)


def test_a_shell_in_a_hole(rng):
    mesh = together(ball(1.0), ball(0.7), ball(0.4))
    packing = pack(mesh, 100)
    assert packing["radius"][0] == pytest.approx(0.4, rel=0.02)
    lengths = np.linalg.norm(packing.points, axis=1)
    assert ((lengths < 0.4) | (lengths > 0.69)).all()


def test_shells_apart(rng):
    mesh = together(ball(1.0), ball(0.5, (3, 0, 0)))
    packing = pack(mesh, 2)
    check_packing(packing, mesh, rng)
    np.testing.assert_allclose(packing.points, [[0, 0, 0], [3, 0, 0]], atol=1e-2)


def test_shells_that_overlap_are_one_solid_with_walls(rng):
    mesh = together(ball(1.0), ball(1.0, (1, 0, 0)))
    packing = pack(mesh, 200)
    check_packing(packing, mesh, rng, inside=lambda x: winding_numbers(mesh, x) > 0.99)
    # In both of them, too.
    assert (winding_numbers(mesh, packing.points) > 1.99).any()


def test_cubes_that_share_an_edge(rng):
    # Four triangles meet there, and the second cube is turned inwards.
    one = pv.Box((0, 1, 0, 1, 0, 1)).triangulate().clean()
    other = pv.Box((1, 2, 1, 2, 0, 1)).triangulate().clean().flip_faces()
    packing = pack(together(one, other), 2)
    np.testing.assert_allclose(packing["radius"], 0.5, rtol=1e-4)
    middles = packing.points[np.argsort(packing.points[:, 0])]
    np.testing.assert_allclose(middles, [[0.5, 0.5, 0.5], [1.5, 1.5, 0.5]], atol=1e-3)


def test_needles_and_slivers(rng):
    mesh = pv.Cone(height=20.0, radius=0.05, resolution=7).triangulate().clean()
    check_packing(pack(mesh, 100), mesh, rng)


def test_many_spikes(rng):
    mesh = pv.Icosphere(nsub=3)
    lengths = np.where(rng.random(mesh.n_points) < 0.5, 0.02, 1.0)
    points = np.asarray(mesh.points, float) * lengths[:, None]
    spiky = surface_of(points, mesh.faces.reshape(-1, 4)[:, 1:])
    check_packing(pack(spiky, 300), spiky, rng)


@pytest.mark.parametrize("scale", [1e-12, 1e-3, 1e12])
def test_any_unit(rng, scale):
    mesh = blob(rng)
    middle = np.asarray(mesh.points).mean(axis=0)
    points = (np.asarray(mesh.points) - middle) / mesh.length
    whole = pack(surface_of(points, mesh.faces.reshape(-1, 4)[:, 1:]), 50)
    mesh = surface_of(scale * points, mesh.faces.reshape(-1, 4)[:, 1:])
    packing = pack(mesh, 50)
    check_packing(packing, mesh, rng)
    np.testing.assert_allclose(packing["radius"][0] / scale, whole["radius"][0], rtol=0.03)


def test_far_from_the_origin(rng):
    mesh = blob(rng)
    moved = surface_of(
        np.asarray(mesh.points) / mesh.length + 1e6, mesh.faces.reshape(-1, 4)[:, 1:]
    )
    check_packing(pack(moved, 100), moved, rng)


def test_as_far_as_doubles_hold_the_surface():
    mesh = pv.Cube().triangulate().clean()
    far = np.array([1e15, 0, 0])
    moved = surface_of(np.asarray(mesh.points) + far, mesh.faces.reshape(-1, 4)[:, 1:])
    packing = pack(moved, 50)
    assert packing.n_points
    assert packing["radius"].min() > 0.0
    outwards = np.abs(np.asarray(packing.points) - far).max(axis=1)
    assert (outwards + packing["radius"] <= 0.5).all()


# --- stopping ---------------------------------------------------------------------------------


def test_the_same_seed_gives_the_same_packing(rng):
    mesh = blob(rng)
    one, same, other = (pack(mesh, 300, seed) for seed in (4, 4, 5))
    np.testing.assert_array_equal(one.points, same.points)
    np.testing.assert_array_equal(one["radius"], same["radius"])
    assert not np.array_equal(one["radius"], other["radius"])


def test_the_threads_do_not_matter(rng):
    import importlib

    from spherepacking.backend import VTK_ROOT

    smp = importlib.import_module(f"{VTK_ROOT}.vtkCommonCore").vtkSMPTools
    mesh = blob(rng)
    before = smp.GetBackend()
    one = pack(mesh, 300)
    try:
        assert smp.SetBackend("Sequential")
        other = pack(mesh, 300)
    finally:
        smp.SetBackend(before)
    np.testing.assert_array_equal(one.points, other.points)
    np.testing.assert_array_equal(one["radius"], other["radius"])


def test_minimum_radius(rng):
    mesh = blob(rng)
    least = 0.05 * mesh.length
    packer = packer_of(mesh, 10**6)
    packer.SetMinimumRadius(least)
    packer.Update()
    packing = pv.wrap(packer.GetOutput())
    assert 1 <= packing.n_points < 1000
    assert packing["radius"].min() > least
    check_packing(packing, mesh, rng)
    # No more of them fit anywhere.
    places = rng.uniform(*np.reshape(mesh.bounds, (3, 2)).T, (3000, 3))
    gaps = np.linalg.norm(places[:, None] - packing.points, axis=2) - packing["radius"]
    free = places[(gaps > least).all(axis=1)]
    free = free[winding_numbers(mesh, free) > 0.5] if len(free) else free
    assert not len(free) or (distances(mesh, free) < 1.02 * least).all()


def test_volume_fraction():
    packer = packer_of(pv.Cube(), 10**6)
    packer.SetVolumeFraction(0.7)
    packer.Update()
    packing = pv.wrap(packer.GetOutput())
    volumes = 4 / 3 * np.pi * packing["radius"] ** 3
    assert 0.7 <= volumes.sum() < 0.72


def test_stopped_packings_are_kept(rng):
    packer = packer_of(blob(rng), 10**6)

    def stop(algorithm, _):
        if algorithm.GetProgress() > 2e-4:
            algorithm.SetAbortExecute(1)

    packer.AddObserver("ProgressEvent", stop)
    packer.Update()
    assert packer.GetInterrupted()
    assert packer.GetErrorMessage() == ""
    assert 200 <= packer.GetOutput().GetNumberOfPoints() < 2000


def test_stopped_while_the_surface_is_turned(rng):
    mesh = together(*[ball(1.0, (3.0 * i, 0, 0)) for i in range(100)])
    packer = packer_of(mesh)
    packer.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
    packer.Update()
    assert packer.GetInterrupted()
    assert packer.GetErrorMessage() == ""
    assert packer.GetOutput().GetNumberOfPoints() == 0


# --- errors -----------------------------------------------------------------------------------


def test_an_open_surface_says_where():
    cube = pv.Cube().triangulate().clean()
    faces = cube.faces.reshape(-1, 4)[:, 1:]
    found = message_of(packer_of(surface_of(cube.points, faces[1:])))
    assert found.startswith("surface: found 3 open edges, the first from (")
    assert found.endswith("expected a closed surface")


def test_surfaces_that_are_none():
    nan = pv.Cube().triangulate()
    nan.points[3, 1] = np.nan
    assert "point 3 that are not finite" in message_of(packer_of(nan))
    assert "found no triangles" in message_of(packer_of(pv.PolyData(np.zeros((4, 3)))))
    missing = pv.PolyData()
    missing.points = np.zeros((4, 3))
    missing.faces = [3, 0, 1, 10**6]
    assert "found point 1000000 in cell 0, expected one of 4" in message_of(packer_of(missing))
    boy = pv.ParametricBoy().triangulate().clean()
    assert "has but one side" in message_of(packer_of(boy))
    one_side = surface_of([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [2, 1, 0]])
    assert "found 3 open edges" in message_of(packer_of(one_side))
    flat = pv.Tetrahedron()
    flat.points[:, 2] = 0.0
    assert "expected more than 1e-12 times the cube of that: a thicker one" in message_of(
        packer_of(flat)
    )


def test_a_volume_that_is_small_for_the_size_of_the_surface():
    """It does enclose one, of a million cubes, which the sentence has to say."""
    cube = pv.Cube().triangulate().clean()
    cube.points = cube.points.astype(float)
    cube.points[0] = -1e6
    assert message_of(packer_of(cube)).startswith(
        "surface: found a volume of 500001 at a size of about 1.04858e+06, expected more than 1e-12"
    )


@pytest.mark.parametrize(
    ("name", "value", "found"),
    [
        ("NumberOfSpheres", 0, "count: found 0"),
        ("MinimumRadius", -1.0, "min_radius: found -1"),
        ("MinimumRadius", np.nan, "min_radius: found nan"),
        ("VolumeFraction", 0.0, "fraction: found 0"),
        ("VolumeFraction", 1.5, "fraction: found 1.5"),
    ],
)
def test_bad_numbers(name, value, found):
    packer = packer_of(pv.Cube())
    getattr(packer, f"Set{name}")(value)
    assert message_of(packer).startswith(found)
