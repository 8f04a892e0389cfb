"""Which turns leave an object as it is, and yaw errors that respect them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from posing.symmetry import best_turn, cloud, order, posed, yaw_error
from shapes import cylinder_mesh, sphere_mesh
from toy import CUBE_FACES, corners

from generator.catalogue import build
from generator.geometry import wrap
from generator.scene import Mesh


def box(printed: bool = False) -> Mesh:
    """The unit box; ``printed``, its side towards -y is half red."""
    points = corners([-0.5] * 3, [0.5] * 3)[CUBE_FACES].reshape(-1, 3)
    faces = np.arange(36).reshape(-1, 3)
    texture = np.full((1, 2, 3), 190, np.uint8)
    texture[0, 1] = (200, 20, 20)
    uv = np.full((36, 2), 0.25)
    if printed:
        front = (points[faces][..., 1] < -0.49).all(1)
        uv[faces[front].ravel(), 0] = 0.25 + 0.5 * (points[faces[front].ravel(), 0] > 0)
    return Mesh(points, faces, uv, texture)


@pytest.mark.parametrize(
    ("mesh", "size", "expected"),
    [
        (box(), (0.2, 0.1, 0.08), 2),
        (box(), (0.1, 0.1, 0.2), 4),
        (cylinder_mesh(), (0.08, 0.08, 0.1), math.inf),
        (sphere_mesh(), (0.1, 0.1, 0.1), math.inf),
        (box(printed=True), (0.2, 0.1, 0.08), 1),
        (box(printed=True), (0.1, 0.1, 0.2), 1),
        (build("mug", 5).mesh, tuple(build("mug", 5).size), 1),
    ],
)
def test_the_order_of_symmetry_is_seen_from_shape_and_look(
    mesh: Mesh, size: tuple[float, float, float], expected: float
) -> None:
    assert order(mesh, np.array(size)) == expected


def test_a_yaw_error_is_modulo_the_symmetry() -> None:
    quarter = np.pi / 2
    assert yaw_error(0.1 + 2 * quarter, 0.1, 1) == pytest.approx(180)
    assert yaw_error(0.1 + 2 * quarter, 0.1, 2) == pytest.approx(0, abs=1e-6)
    assert yaw_error(0.1 + quarter, 0.1, 2) == pytest.approx(90)
    assert yaw_error(0.1 - quarter, 0.1, 4) == pytest.approx(0, abs=1e-6)
    assert yaw_error(-3.1, 3.1, 1) == pytest.approx(np.rad2deg(2 * np.pi - 6.2))
    assert yaw_error(1.0, 2.0, math.inf) == 0


@pytest.mark.parametrize("turn", [20.0, -75.0, 180.0])
def test_models_of_another_make_are_held_together_by_their_surfaces(turn: float) -> None:
    true = build("mug", 5)
    found = build("mug", 9)  # another mug
    yaw = 0.7
    a = posed(cloud(found.mesh, found.size, 1200), yaw + np.deg2rad(turn))
    b = posed(cloud(true.mesh, true.size, 1200), yaw)
    got = best_turn(a, b)
    assert got is not None
    assert abs(np.rad2deg(wrap(got - np.deg2rad(turn)))) < 4


def test_a_round_model_of_a_mug_has_no_yaw() -> None:
    mug = build("mug", 5)
    can = cloud(cylinder_mesh(), np.array([0.08, 0.08, 0.1]), 1200)
    assert best_turn(can, cloud(mug.mesh, mug.size, 1200)) is None
