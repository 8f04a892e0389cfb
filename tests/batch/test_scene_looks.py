"""Visual geoms of scenes, and the single model that draws them all."""

import mujoco
import numpy as np
import pytest
from tables import shipped

from tabletopgen_env.parallel.batch.bank import SceneBank
from tabletopgen_env.parallel.batch.union.look import LOOKING, DrawnPose, SceneLook

NAMES = ("vanity", "coffee-square", "tidy-task-2")


@pytest.fixture(scope="module")
def bank() -> SceneBank:
    return SceneBank(shipped(*NAMES), max_parts=None, pictures=True)


def corners(model: mujoco.MjModel, mesh: int, pose: DrawnPose) -> np.ndarray:
    """Return a mesh's vertices at the pose of a geom."""
    first = model.mesh_vertadr[mesh]
    points = model.mesh_vert[first : first + model.mesh_vertnum[mesh]]
    return points @ pose.rotation.T + pose.position


def test_every_mesh_is_drawn_where_the_scenes_own_model_has_it(bank: SceneBank) -> None:
    looks = bank.looks
    assert looks is not None
    rows, table = looks.rows, looks.marker + 1
    for k, world in enumerate(shipped(*NAMES)):
        for name in world.names:
            body = int(world.bodies[world.index(name)])
            geoms = np.flatnonzero(
                (world.model.geom_bodyid == body) & (world.model.geom_group == 2)
            )
            (own,) = geoms.tolist()
            turn = np.zeros(9)
            mujoco.mju_quat2Mat(turn, world.model.geom_quat[own])
            local = DrawnPose(world.model.geom_pos[own], turn.reshape(3, 3))
            wanted = corners(world.model, int(world.model.geom_dataid[own]), local)
            place = table + 1 + bank.slot(k, name)
            pose = DrawnPose(rows.pos[k, place], rows.mat[k, place])
            got = corners(looks.model, int(rows.data[k, place]), pose)
            assert got.shape == wanted.shape and np.abs(got - wanted).max() < 1e-4, name
        empty = table + 1 + np.flatnonzero(~bank.filled[k])
        assert (rows.data[k, empty] == -1).all() and (rows.pos[k, empty, 2] < -100).all()


def test_bodies_and_cameras_are_those_of_the_simulated_union(bank: SceneBank) -> None:
    looks, model = bank.looks, bank.union.model
    assert looks is not None and len(looks.bodies) == looks.model.ngeom
    assert looks.model.nv == 0 and looks.model.ncam == len(LOOKING)
    names = {model.body(int(k)).name for k in looks.bodies}
    assert {"world", "slot0", "panda/hand", "panda/left_finger"} <= names
    assert model.body(int(looks.camera_bodies[-1])).name == "panda/hand"
    fovy = {tuple(row) for row in looks.rows.fovy.round(3).tolist()}
    assert len(fovy) == len(NAMES), "the camera over a table shows all of it"


def test_equal_things_are_there_once() -> None:
    world = shipped(*NAMES)[1]
    one, other = SceneLook.of(world), SceneLook.of(world)
    assert one.table.skin.name == other.table.skin.name
    mugs = [part.skin.name for part in one.objects]
    assert len({*mugs}) < len(mugs), "two mugs wear one skin"


@pytest.mark.slow
def test_every_shipped_scene_can_be_drawn() -> None:
    for world in shipped():
        look = SceneLook.of(world)
        assert len(look.objects) == len(world.names), world.scene.name
        assert len(look.columns) == 3
