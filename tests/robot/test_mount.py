import mujoco
import numpy as np
import pytest
from toy import toy_object, toy_scene, toy_table

from generator.errors import InputError
from generator.geometry import inside_margin, rotation_z
from tabletopgen_env.robot.kinematics import solve_ik
from tabletopgen_env.robot.mount import PEDESTAL_RADIUS, Mount, add_pedestal, obstacle, reachable

DOWN = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])


def polygon(sides: int, radius: float) -> np.ndarray:
    angles = np.pi / 2 + np.linspace(0, 2 * np.pi, sides, endpoint=False)
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


TABLES = {
    "rectangle": toy_table(),
    "round": toy_table(polygon(40, 0.5), (1.0, 1.0, 0.74)),
    "triangle": toy_table(polygon(3, 0.6), (1.04, 0.9, 0.7)),
    "square": toy_table(polygon(4, 0.6) @ rotation_z(np.pi / 4)[:2, :2], (0.85, 0.85, 0.5)),
}


@pytest.mark.parametrize("shape", TABLES)
def test_base_stands_beside_the_table_and_faces_it(shape: str) -> None:
    table = TABLES[shape]
    mount = Mount.beside(toy_scene((toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0)),), table))
    assert inside_margin(mount.position[None, :2], table.outline)[0] < -PEDESTAL_RADIUS
    middle = (table.outline.min(0) + table.outline.max(0)) / 2
    ahead = rotation_z(mount.yaw)[:2, 0]
    to_middle = middle - mount.position[:2]
    assert ahead @ to_middle == pytest.approx(np.linalg.norm(to_middle), abs=1e-9)
    assert mount.position[2] == pytest.approx(table.height, abs=0.02)
    assert reachable(mount, np.array([0, 0, table.height + 0.05]))


@pytest.mark.parametrize("shape", ["rectangle", "square"])
def test_an_empty_table_is_served_from_the_viewers_side(shape: str) -> None:
    mount = Mount.beside(toy_scene((), TABLES[shape]))
    assert mount.position[1] < 0
    assert abs(mount.position[0]) < 0.05


def test_it_goes_where_more_objects_are_in_reach() -> None:
    far = toy_scene(
        (toy_object("cube", (0.04, 0.04, 0.04), (0.85, 0.2)),), toy_table(size=(2.0, 0.8, 0.74))
    )
    mount = Mount.beside(far)
    assert reachable(mount, far.objects[0].pose.position)


def test_it_keeps_clear_of_objects_at_the_edge() -> None:
    wall = toy_object("wall", (1.1, 0.05, 0.35), (0.0, -0.3))
    mount = Mount.beside(toy_scene((wall, toy_object("cube", (0.04, 0.04, 0.04), (0.2, 0.15)))))
    assert mount.position[1] > -0.3


def test_it_does_not_reach_past_what_is_tall() -> None:
    monitor = toy_object("monitor", (0.5, 0.1, 0.4), (0.0, -0.05))
    cube = toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.12))
    scene = toy_scene((monitor, cube))
    front = Mount(np.array([0.0, -0.452, 0.75]), np.pi / 2)
    assert obstacle(scene, front, "cube") == "monitor"
    assert obstacle(scene, front, "monitor") is None
    assert Mount.beside(scene).position[1] > 0.3


def test_reaches_never_promises_what_inverse_kinematics_cannot_do() -> None:
    mount = Mount(np.array([0.2, -0.5, 0.75]), 1.2)
    rng = np.random.default_rng(0)
    points = mount.position + rng.uniform([-0.9, -0.9, 0.0], [0.9, 0.9, 0.35], (150, 3))
    promised = points[mount.reaches(points)]
    assert len(promised) > 30
    for point in promised:
        local = (point - mount.position) @ rotation_z(mount.yaw)
        assert solve_ik(local, DOWN).solved, local


def test_pedestal_stands_on_the_floor_and_carries_the_base() -> None:
    mount = Mount.beside(toy_scene())
    spec = mujoco.MjSpec()
    add_pedestal(spec, mount)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    tops = data.geom_xpos[:, 2] + model.geom_size[:, 1]
    bottoms = data.geom_xpos[:, 2] - model.geom_size[:, 1]
    assert bottoms.min() == pytest.approx(0.0)
    assert tops.max() == pytest.approx(mount.position[2])


def test_a_mount_must_be_finite() -> None:
    with pytest.raises(InputError, match="finite"):
        Mount(np.zeros(3), float("nan"))
