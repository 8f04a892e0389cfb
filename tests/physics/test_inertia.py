import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import UNIT, sphere_mesh
from toy import cube_mesh

from generator.errors import SceneError
from generator.physics.inertia import (
    LEAST_GYRATION,
    body_mass,
    box_mass,
    is_watertight,
    join_bodies,
    parts_mass,
)
from generator.physics.parts import model_parts
from generator.scene import ConvexPart, Mesh, Physics
from tabletop_objects import build

SIDE = st.floats(0.01, 0.5)


def box_inertia(mass: float, size: np.ndarray) -> np.ndarray:
    return mass / 12 * np.diag(size @ size - size**2)


@given(SIDE, SIDE, SIDE)
@settings(max_examples=30, deadline=None)
def test_a_solid_box_is_exact(x: float, y: float, z: float) -> None:
    size = np.array([x, y, z])
    if size.min() < 0.2 * size.max():
        return  # inertia of needles and sheets is kept off zero
    found = body_mass(cube_mesh(), size, Physics(800.0), ())
    assert found.mass == pytest.approx(max(800 * x * y * z, 2e-3))
    np.testing.assert_allclose(found.com, 0, atol=1e-9)
    np.testing.assert_allclose(found.inertia, box_inertia(found.mass, size), rtol=1e-5, atol=1e-12)


@pytest.mark.slow
def test_a_solid_and_a_hollow_sphere() -> None:
    mesh, size, radius = sphere_mesh(192, 96), np.full(3, 0.1), 0.05
    solid = body_mass(mesh, size, Physics(1000.0), ())
    assert solid.mass == pytest.approx(1000 * 4 / 3 * np.pi * radius**3, rel=2e-3)
    np.testing.assert_allclose(np.diag(solid.inertia), 2 / 5 * solid.mass * radius**2, rtol=2e-3)
    hollow = body_mass(mesh, size, Physics(1000.0, shell=0.002), ())
    assert hollow.mass == pytest.approx(1000 * 0.002 * 4 * np.pi * radius**2, rel=2e-3)
    np.testing.assert_allclose(np.diag(hollow.inertia), 2 / 3 * hollow.mass * radius**2, rtol=2e-3)


def test_a_seam_leaves_a_mesh_closed_and_a_missing_face_opens_it() -> None:
    mesh = sphere_mesh()
    assert is_watertight(mesh)
    assert not is_watertight(
        Mesh(mesh.vertices, np.delete(mesh.faces, 500, 0), mesh.uv, mesh.texture)
    )
    assert not is_watertight(Mesh(mesh.vertices, mesh.faces[:, ::-1], mesh.uv, mesh.texture))


def test_an_open_mesh_takes_its_parts_volume() -> None:
    cube = cube_mesh()
    open_cube = dataclasses.replace(cube, faces=cube.faces[:-2])
    size = np.array([0.1, 0.2, 0.3])
    found = body_mass(open_cube, size, Physics(500.0), (ConvexPart(UNIT * size, "box"),))
    assert found.mass == pytest.approx(500 * 0.006)
    np.testing.assert_allclose(found.inertia, box_inertia(3.0, size), rtol=1e-6, atol=1e-12)


def test_parts_off_centre_move_the_centre_of_mass() -> None:
    light, heavy = (
        ConvexPart(UNIT * 0.1 + [0.1, 0, 0]),
        ConvexPart(UNIT * [0.2, 0.1, 0.1] - [0.1, 0, 0]),
    )
    found = parts_mass((light, heavy), 1000.0)
    assert found.mass == pytest.approx(3.0)
    np.testing.assert_allclose(found.com, [(0.1 - 0.2) / 3, 0, 0], atol=1e-9)


def test_neither_closed_mesh_nor_parts_is_an_error() -> None:
    cube = cube_mesh()
    with pytest.raises(SceneError, match="no mass"):
        body_mass(dataclasses.replace(cube, faces=cube.faces[:-1]), np.ones(3), Physics(), ())


def rod(length: float, diameter: float) -> np.ndarray:
    """Principal moments of a solid cylinder along x, per kg."""
    across = diameter**2 / 16 + length**2 / 12
    return np.array([diameter**2 / 8, across, across])


def plate(size: np.ndarray) -> np.ndarray:
    """Principal moments of a solid box, per kg."""
    return (size @ size - size**2) / 12


def pot(radius: float, height: float) -> np.ndarray:
    """Principal moments, per kg, of a thin can along z that is open above."""
    side, bottom = 2 * height / (2 * height + radius), radius / (2 * height + radius)
    low = side * height / 2  # the centre over the bottom
    across = side * (radius**2 / 2 + height**2 / 12 + (height / 2 - low) ** 2)
    across += bottom * (radius**2 / 4 + low**2)
    return np.array([across, across, (side + bottom / 2) * radius**2])


@pytest.mark.parametrize(
    ("key", "like"),
    [
        ("pencil", lambda size: rod(size[0], size[1:].mean())),
        ("marker", lambda size: rod(size[0], 0.85 * size[1])),  # its cap is wider than it is
        ("knife", lambda size: plate(size * [1, 0.75, 1])),  # it tapers
        ("fork", lambda size: plate(size * [1, 0.75, 1])),
        ("ruler", plate),
        ("mug", lambda size: pot(size[1] / 2, size[2])),
        ("book", plate),
    ],
)
def test_things_turn_as_the_solids_they_are_like(key: str, like) -> None:
    model = build(key, 0)
    found = body_mass(model.mesh, model.size, model.physics, model_parts(model, model.size))
    ratio = np.diag(found.inertia) / found.mass / like(model.size)
    assert ratio.min() > 1 / 1.5, ratio
    assert ratio.max() < 1.5, ratio


def test_thin_and_light_things_keep_a_sound_inertia() -> None:
    size = np.array([0.1, 0.0003, 0.0003])
    found = body_mass(cube_mesh(), size, Physics(100.0), ())
    values = np.linalg.eigvalsh(found.inertia)
    assert found.mass == pytest.approx(2e-3)
    assert values[0] == pytest.approx(2e-3 * (LEAST_GYRATION * np.linalg.norm(size)) ** 2)
    assert values[2] <= values[0] + values[1] + 1e-15


def test_two_halves_make_the_whole_box() -> None:
    size, half = np.array([0.2, 0.1, 0.06]), np.array([0.1, 0.1, 0.06])
    halves = [box_mass(0.4, np.array([x, 0.02, 0.01]), half) for x in (-0.05, 0.05)]
    whole = join_bodies(halves)
    assert whole.mass == pytest.approx(0.8)
    np.testing.assert_allclose(whole.com, [0, 0.02, 0.01], atol=1e-12)
    np.testing.assert_allclose(whole.inertia, box_inertia(0.8, size), atol=1e-12)
