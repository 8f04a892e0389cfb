import mujoco
import numpy as np
import pytest

from generator.errors import BackendError, InputError
from tabletopgen_env.robot import franka
from tabletopgen_env.robot.hand import FINGER_JOINTS
from tabletopgen_env.robot.kinematics import ik_step, solve_ik
from tabletopgen_env.robot.panda import (
    ACTUATORS,
    ARM_JOINTS,
    HOME_CTRL,
    HOME_QPOS,
    Panda,
)
from tabletopgen_env.robot.shells import arm_shells
from tabletopgen_env.robot.tool import TCP_SITE, WRIST_CAMERA

DOWN = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return Panda().spec().compile()


def at_home(model: mujoco.MjModel) -> mujoco.MjData:
    data = mujoco.MjData(model)
    for name, value in zip((*ARM_JOINTS, *FINGER_JOINTS), HOME_QPOS, strict=True):
        data.joint(name).qpos = value
    for name, value in zip(ACTUATORS, HOME_CTRL, strict=True):
        data.actuator(name).ctrl = value
    mujoco.mj_forward(model, data)
    return data


def test_tcp_at_home_is_where_the_published_geometry_puts_it(model: mujoco.MjModel) -> None:
    # x: elbow offset out and back, forearm, wrist offset; z: base, upper arm, minus flange and tool
    data = at_home(model)
    expected = [0.0825 + 0.384 + 0.088, 0.0, 0.333 + 0.316 + 0.0825 - 0.107 - 0.1034]
    np.testing.assert_allclose(data.site(TCP_SITE).xpos, expected, atol=1e-9)
    np.testing.assert_allclose(data.site(TCP_SITE).xmat.reshape(3, 3), DOWN, atol=1e-9)
    assert data.ncon == 0


def test_joints_and_actuators_are_in_menageries_order_with_frankas_limits(
    model: mujoco.MjModel,
) -> None:
    assert [model.joint(i).name for i in range(model.njnt)] == [*ARM_JOINTS, *FINGER_JOINTS]
    assert [model.actuator(i).name for i in range(model.nu)] == list(ACTUATORS)
    for i, joint in enumerate(franka.JOINTS):
        np.testing.assert_allclose(model.jnt_range[i], [joint.low, joint.high])
        np.testing.assert_allclose(model.actuator_ctrlrange[i], [joint.low, joint.high])
        np.testing.assert_allclose(model.actuator_forcerange[i], [-joint.torque, joint.torque])
    np.testing.assert_allclose(model.actuator_ctrlrange[7], [0, 255])
    np.testing.assert_allclose(model.jnt_range[7:], [[0, 0.04]] * 2)


def test_it_is_light(model: mujoco.MjModel) -> None:
    assert model.mesh_facenum.sum() < 3000
    assert (model.geom_contype > 0).sum() <= 32
    assert model.camera(WRIST_CAMERA).id >= 0


def test_mass_is_that_of_the_identified_links(model: mujoco.MjModel) -> None:
    assert model.body_mass.sum() == pytest.approx(17.45, abs=0.05)


def test_shells_are_closed_and_turn_outwards() -> None:
    for body, shells in arm_shells().items():
        for shell in shells:
            a, b, c = (shell.vertices[shell.faces[:, k]] for k in range(3))
            volume = (a * np.cross(b, c)).sum() / 6
            assert volume > 0, body
            edges = np.sort(shell.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
            assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all(), body


def test_shells_are_built_once_for_all_and_stay_as_they_are() -> None:
    assert arm_shells() is arm_shells()
    for shell in (shell for shells in arm_shells().values() for shell in shells):
        assert not shell.vertices.flags.writeable and not shell.faces.flags.writeable


def test_it_holds_its_home_pose_against_gravity(model: mujoco.MjModel) -> None:
    data = at_home(model)
    mujoco.mj_step(model, data, 1000)
    np.testing.assert_allclose(data.qpos[:7], HOME_QPOS[:7], atol=1e-3)


def test_it_does_not_hit_itself_in_reasonable_poses(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    for radius in (0.3, 0.5, 0.7):
        for bearing in (-1.0, 0.0, 1.0):
            target = np.array([radius * np.cos(bearing), radius * np.sin(bearing), 0.02])
            data.qpos[:7] = solve_ik(target, DOWN).joints
            mujoco.mj_forward(model, data)
            assert data.ncon == 0, (radius, bearing)


@pytest.mark.parametrize("width", [0.003, 0.04, 0.07])
def test_the_gripper_lifts_a_box_and_holds_it(width: float) -> None:
    spec = Panda().spec()
    spec.option.timestep = 0.002
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 0.1])
    box = spec.worldbody.add_body(name="box", pos=[0.5, 0, 0.025])
    box.add_freejoint()
    box.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[width / 2, 0.02, 0.025],
        mass=0.3,
        friction=[0.6, 0.005, 1e-4],
    )
    model = spec.compile()
    data = at_home(model)
    joints, heights = solve_ik(np.array([0.5, 0.0, 0.2]), DOWN).joints, []
    data.qpos[:7] = joints
    for begin, end, grip in (
        (0.2, 0.025, 255),
        (0.025, 0.025, 0),
        (0.025, 0.13, 0),
        (0.13, 0.13, 0),
        (0.13, 0.13, 0),
    ):
        for height in np.linspace(begin, end, 100):
            joints, _, _ = ik_step(joints, np.array([0.5, 0.0, height]), DOWN)
            data.ctrl[:] = [*joints, grip]
            mujoco.mj_step(model, data, 10)
            heights.append(data.body("box").xpos[2])
    assert heights[-1] > 0.12
    assert abs(heights[-1] - heights[-100]) < 1e-3  # two seconds earlier


def test_menageries_model_is_the_same_robot(
    monkeypatch: pytest.MonkeyPatch, tmp_path, model: mujoco.MjModel
) -> None:
    # A stand-in with Menagerie's names: the official meshes are not part of this project.
    folder = tmp_path / "franka_emika_panda"
    folder.mkdir()
    twin = Panda().spec()
    twin.delete(twin.site(TCP_SITE))
    twin.delete(twin.camera(WRIST_CAMERA))
    twin.compile()
    (folder / "panda.xml").write_text(twin.to_xml())
    monkeypatch.setenv("MENAGERIE_ROOT", str(tmp_path))
    other = Panda("menagerie").spec().compile()
    assert [other.joint(i).name for i in range(9)] == [model.joint(i).name for i in range(9)]
    data = at_home(other)
    here = at_home(model).site(TCP_SITE).xpos
    np.testing.assert_allclose(data.site(TCP_SITE).xpos, here, atol=1e-9)
    assert other.camera(WRIST_CAMERA).id >= 0


def test_without_menagerie_the_error_says_how_to_get_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path
) -> None:
    monkeypatch.delenv("MENAGERIE_ROOT", raising=False)
    monkeypatch.setenv("MENAGERIE_CACHE_DIR", str(tmp_path))
    with pytest.raises(BackendError, match="pip install mujoco-menagerie"):
        Panda("menagerie").spec()
    with pytest.raises(InputError, match="'primitive' or 'menagerie'"):
        Panda("shiny")  # type: ignore[arg-type]
