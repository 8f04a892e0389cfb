"""By how much one object is turned against another, told by their surfaces."""

import itertools

import numpy as np
import pytest
from extent import part_of
from posing.turning import best_turn, turn_cloud
from shapes import cylinder_mesh

from generator.evaluation.surfaces.symmetry import Cloud, cloud
from generator.geometry import wrap
from generator.scene import Mesh, Model
from tabletop_objects import build


def resampled(model: Model) -> Cloud:
    """Return the object with other surface samples: its faces in another order."""
    mesh = model.mesh
    faces = mesh.faces[np.random.default_rng(0).permutation(len(mesh.faces))]
    return cloud(Mesh(mesh.vertices, faces, mesh.uv, mesh.texture), model.size)


@pytest.mark.slow
@pytest.mark.parametrize("turn", [20.0, -75.0, 180.0])
def test_models_of_another_make_are_held_together_by_their_surfaces(turn: float) -> None:
    true = build("mug", 5)
    found = build("mug", 9)  # another mug
    yaw = 0.7
    a = turn_cloud(cloud(found.mesh, found.size), yaw + np.deg2rad(turn))
    b = turn_cloud(cloud(true.mesh, true.size), yaw)
    got = best_turn(a, b)
    assert got is not None
    assert abs(np.rad2deg(wrap(got - np.deg2rad(turn)))) < 4


@pytest.mark.slow
@pytest.mark.parametrize(
    ("word", "turn"),
    part_of(
        itertools.product(["marker", "pencil", "fork", "smartphone"], [0.0, 180.0]),
        ("pencil", 0.0), ("pencil", 180.0), ("fork", 180.0), ("smartphone", 0.0),
    ),
)  # fmt: skip
def test_ends_that_are_nearly_alike_are_told_apart(word: str, turn: float) -> None:
    """A pencil turned end to end covers itself except for its tip, which decides."""
    model = build(word, 0)
    got = best_turn(
        turn_cloud(resampled(model), 0.7 + np.deg2rad(turn)),
        turn_cloud(cloud(model.mesh, model.size), 0.7),
    )
    assert got is not None
    assert abs(np.rad2deg(wrap(got - np.deg2rad(turn)))) < 4


@pytest.mark.slow
def test_a_round_model_of_a_mug_has_no_yaw() -> None:
    mug = build("mug", 5)
    can = cloud(cylinder_mesh(), np.array([0.08, 0.08, 0.1]))
    assert best_turn(can, cloud(mug.mesh, mug.size)) is None
