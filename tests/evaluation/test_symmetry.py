"""Rotational symmetries of objects, and yaw errors modulo symmetry."""

import math

import numpy as np
import pytest
from printed import box
from shapes import cylinder_mesh, sphere_mesh

from generator.evaluation.surfaces.symmetry import order, yaw_error
from generator.scene import Mesh
from tabletop_objects import build

MUG = build("mug", 5)
BOOK = build("book", 0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("mesh", "size", "expected"),
    [
        (box(), (0.2, 0.1, 0.08), 2),
        (box(), (0.1, 0.1, 0.2), 4),
        (cylinder_mesh(), (0.08, 0.08, 0.1), math.inf),
        (sphere_mesh(), (0.08, 0.08, 0.08), math.inf),
        (sphere_mesh(), (0.12, 0.08, 0.08), 2),
        (box(printed=True), (0.2, 0.1, 0.08), 1),
        (box(printed=True), (0.1, 0.1, 0.2), 1),
        (MUG.mesh, tuple(MUG.size), 1),
        (BOOK.mesh, tuple(BOOK.size), 1),
        (build("plate", 0).mesh, tuple(build("plate", 0).size), math.inf),
    ],
)
def test_the_order_of_symmetry_is_seen_from_shape_and_look(
    mesh: Mesh, size: tuple[float, float, float], expected: float
) -> None:
    assert order(mesh, np.array(size)) == expected


@pytest.mark.parametrize(
    ("mesh", "size", "expected"),
    [
        (box(printed=True), (0.2, 0.1, 0.08), 2),
        (BOOK.mesh, tuple(BOOK.size), 2),
        (MUG.mesh, tuple(MUG.size), 1),
    ],
)
def test_without_prints_the_shape_alone_counts(
    mesh: Mesh, size: tuple[float, float, float], expected: float
) -> None:
    assert order(mesh, np.array(size), prints=False) == expected


def test_a_yaw_error_is_modulo_the_symmetry() -> None:
    quarter = np.pi / 2
    assert yaw_error(0.1 + 2 * quarter, 0.1, 1) == pytest.approx(180)
    assert yaw_error(0.1 + 2 * quarter, 0.1, 2) == pytest.approx(0, abs=1e-6)
    assert yaw_error(0.1 + quarter, 0.1, 2) == pytest.approx(90)
    assert yaw_error(0.1 - quarter, 0.1, 4) == pytest.approx(0, abs=1e-6)
    assert yaw_error(0.1 + 1.5 * quarter, 0.1, 4) == pytest.approx(45)
    assert yaw_error(-3.1, 3.1, 1) == pytest.approx(np.rad2deg(2 * np.pi - 6.2))
    assert yaw_error(1.0, 2.0, math.inf) == 0
