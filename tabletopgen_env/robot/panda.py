"""The Franka Panda with its hand, as a MuJoCo specification built in code.

Joints, actuators and their order, limits, gains, home pose and the gripper's 0-255 command agree
with the MuJoCo Menagerie model, so a policy carries over between ``visuals="primitive"`` (light:
a few capsules and boxes collide, low-poly shells are drawn) and ``visuals="menagerie"`` (the
scanned covers). One thing differs on purpose: this gripper squeezes with a force like the real
hand's (up to 30 N a finger), while Menagerie's servo holds a 4 cm object with 1 N.

Frames: ``link0`` is the base, x forward, z up. ``tcp`` is the tool centre point between the
fingertips, z along the fingers (out of the hand), y along the opening direction.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from generator.errors import InputError

from . import franka
from .shells import COLORS, arm_shells
from .tool import add_tool

if TYPE_CHECKING:
    import mujoco

ARM_JOINTS: tuple[str, ...] = tuple(f"joint{i}" for i in range(1, 8))
"""Names of the arm's joints, base to wrist."""

FINGER_JOINTS: tuple[str, ...] = ("finger_joint1", "finger_joint2")
"""Names of the fingers' slides."""

ACTUATORS: tuple[str, ...] = tuple(f"actuator{i}" for i in range(1, 9))
"""Names of the actuators: seven position servos (radians) and the gripper (0-255)."""


HOME_QPOS: tuple[float, ...] = (*franka.HOME, franka.FINGER_STROKE, franka.FINGER_STROKE)
"""Joint positions at home: seven angles (rad), two fingers (m)."""

HOME_CTRL: tuple[float, ...] = (*franka.HOME, franka.GRIPPER_CTRL)
"""Commands that hold the home pose."""

_LINKS = tuple(f"link{i}" for i in range(8))
_FINGERS = ("left_finger", "right_finger")


@dataclass(frozen=True)
class Panda:
    """A Franka Panda.

    Args:
        visuals: "primitive" for the light model built here, "menagerie" for the official meshes,
            read from ``$MENAGERIE_ROOT`` or the ``mujoco-menagerie`` package's cache.
    """

    visuals: Literal["primitive", "menagerie"] = "primitive"

    def __post_init__(self) -> None:
        if self.visuals not in ("primitive", "menagerie"):
            raise InputError(
                f"Panda.visuals must be 'primitive' or 'menagerie', got {self.visuals!r}."
            )

    def spec(self) -> mujoco.MjSpec:
        """Return a fresh specification, to be attached to a scene.

        ``scene.attach(Panda().spec(), prefix="panda/", frame=frame)`` puts the base at ``frame``;
        then set the home pose by joint name (``HOME_QPOS``, ``HOME_CTRL``).

        Raises:
            BackendError: the Menagerie meshes were asked for and are not on this machine.
        """
        if self.visuals == "menagerie":
            from .menagerie import menagerie

            return menagerie()
        return _primitive()


# -------------------------------------------------------------------------------- our own model


def _primitive() -> mujoco.MjSpec:
    import mujoco

    spec = mujoco.MjSpec()
    spec.modelname = "panda"
    spec.compiler.degree = False
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    for name, rgba in COLORS.items():
        spec.add_material(name=name, rgba=rgba, specular=0.4, shininess=0.5)
    body = spec.worldbody.add_body(name="link0")
    _dress(spec, body)
    for i, joint in enumerate(franka.JOINTS, start=1):
        body = _add_link(spec, body, i, joint)
    _add_hand(spec, body)
    _add_actuators(spec)
    _exclude_neighbours(spec)
    return spec


def _add_link(
    spec: mujoco.MjSpec, parent: mujoco.MjsBody, number: int, joint: franka.Joint
) -> mujoco.MjsBody:
    """Add link ``number`` at its modified-DH frame, with its joint."""
    c, s = np.cos(joint.alpha / 2), np.sin(joint.alpha / 2)
    body = parent.add_body(
        name=f"link{number}",
        pos=[joint.a, -joint.d * np.sin(joint.alpha), joint.d * np.cos(joint.alpha)],
        quat=[c, s, 0, 0],
        gravcomp=1,
    )
    body.add_joint(
        name=f"joint{number}",
        axis=[0, 0, 1],
        range=[joint.low, joint.high],
        limited=True,
        armature=0.1,
        damping=[1, 0, 0],
    )
    _dress(spec, body)
    return body


def _add_hand(spec: mujoco.MjSpec, link7: mujoco.MjsBody) -> None:
    """Add hand, fingers, tool centre point and wrist camera."""
    import mujoco

    half = franka.HAND_YAW / 2
    hand = link7.add_body(
        name="hand",
        pos=[0, 0, franka.FLANGE],
        quat=[np.cos(half), 0, 0, np.sin(half)],
        gravcomp=1,
    )
    _dress(spec, hand)
    box = mujoco.mjtGeom.mjGEOM_BOX
    _collide(hand, "hand_collision", type=box, size=[0.0315, 0.102, 0.033], pos=[0, 0, 0.033])
    add_tool(hand)
    for name, joint, quat in zip(
        _FINGERS, FINGER_JOINTS, ([1, 0, 0, 0], [0, 0, 0, 1]), strict=True
    ):
        finger = hand.add_body(name=name, pos=[0, 0, franka.FINGER_MOUNT], quat=quat, gravcomp=1)
        finger.add_joint(
            name=joint,
            type=mujoco.mjtJoint.mjJNT_SLIDE,
            axis=[0, 1, 0],
            range=[0, franka.FINGER_STROKE],
            limited=True,
            armature=0.1,
            damping=[200, 0, 0],  # the drive's friction: 0.14 m/s at full force
        )
        _dress(spec, finger)
        _collide(
            finger, f"{name}_shaft", type=box, size=[0.0105, 0.0095, 0.017], pos=[0, 0.0165, 0.018]
        )
        _add_pad(finger)


def _add_pad(finger: mujoco.MjsBody) -> None:
    """Give a finger its pad: six knobs, and behind them a box that closes the gaps."""
    # A sphere touches in one point that moves smoothly, so six hold like a soft pad; on a box that
    # point jumps from edge to edge, and a curved thing wanders out of the hand.
    import mujoco

    grip: dict[str, Any] = {
        "condim": 4,
        "friction": [1.3, 0.01, 1e-4],
        "priority": 1,
        "solref": [0.01, 1],
        "solimp": [0.95, 0.99, 0.001, 0.5, 2],
    }
    places = [(x, 0.005, z) for x in (-0.0055, 0.0055) for z in (0.0385, 0.0437, 0.0489)]
    for i, place in enumerate(places):
        knob = mujoco.mjtGeom.mjGEOM_SPHERE
        _collide(finger, f"{finger.name}_pad_{i}", type=knob, size=[0.005, 0, 0], pos=place, **grip)
    _collide(
        finger,
        f"{finger.name}_pad",
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[0.0095, 0.0053, 0.0093],
        pos=[0, 0.0067, 0.0445],
        **grip,
    )


def _dress(spec: mujoco.MjSpec, body: mujoco.MjsBody) -> None:
    """Give ``body`` its inertia, capsules and shells."""
    import mujoco

    inertial = franka.INERTIALS[body.name]
    body.explicitinertial = True
    body.mass = inertial.mass
    body.ipos = inertial.com
    body.fullinertia = inertial.inertia
    for i, capsule in enumerate(franka.CAPSULES.get(body.name, ())):
        _collide(
            body,
            f"{body.name}_collision_{i}",
            type=mujoco.mjtGeom.mjGEOM_CAPSULE,
            fromto=[*capsule.start, *capsule.end],
            size=[capsule.radius, 0, 0],
        )
    for i, shell in enumerate(arm_shells()[body.name]):
        name = f"{body.name}_shell_{i}"
        spec.add_mesh(
            name=name,
            uservert=np.asarray(shell.vertices, np.float32).ravel(),
            userface=np.asarray(shell.faces, np.int32).ravel(),
            inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL,
        )
        body.add_geom(
            name=name,
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=name,
            material=shell.color,
            contype=0,
            conaffinity=0,
            group=2,
            mass=0,
        )


def _collide(body: mujoco.MjsBody, name: str, **geom: Any) -> None:
    """Add an invisible colliding geom (group 3, as Menagerie)."""
    body.add_geom(name=name, group=3, mass=0, rgba=[0.9, 0.4, 0.2, 0.4], **geom)


def _add_actuators(spec: mujoco.MjSpec) -> None:
    """Seven position servos and the gripper, which drives both fingers through a tendon."""
    import mujoco

    affine = {"gaintype": mujoco.mjtGain.mjGAIN_FIXED, "biastype": mujoco.mjtBias.mjBIAS_AFFINE}
    for name, target, joint in zip(ACTUATORS, ARM_JOINTS, franka.JOINTS, strict=False):
        spec.add_actuator(
            name=name,
            target=target,
            trntype=mujoco.mjtTrn.mjTRN_JOINT,
            gainprm=[joint.stiffness, *[0] * 9],
            biasprm=[0, -joint.stiffness, -joint.damping, *[0] * 7],
            ctrlrange=[joint.low, joint.high],
            ctrllimited=True,
            forcerange=[-joint.torque, joint.torque],
            forcelimited=True,
            **affine,
        )
    tendon = spec.add_tendon(name="split")
    for joint in FINGER_JOINTS:
        tendon.wrap_joint(joint, 0.5)
    equality = spec.add_equality(
        type=mujoco.mjtEq.mjEQ_JOINT,
        objtype=mujoco.mjtObj.mjOBJ_JOINT,
        name1=FINGER_JOINTS[0],
        name2=FINGER_JOINTS[1],
        solref=[0.005, 1],
        solimp=[0.95, 0.99, 0.001, 0.5, 2],
    )
    equality.data[:5] = [0, 1, 0, 0, 0]
    # Closed (0) aims 5 mm beyond contact, so that even a sheet is held; the force is limited to
    # 60 N over both fingers, below the 70 N that Franka gives for the hand.
    stiffness, damping, beyond = 4000.0, 20.0, 0.005
    span = franka.FINGER_STROKE + beyond
    spec.add_actuator(
        name=ACTUATORS[-1],
        target="split",
        trntype=mujoco.mjtTrn.mjTRN_TENDON,
        gainprm=[stiffness * span / franka.GRIPPER_CTRL, *[0] * 9],
        biasprm=[-stiffness * beyond, -stiffness, -damping, *[0] * 7],
        ctrlrange=[0, franka.GRIPPER_CTRL],
        ctrllimited=True,
        forcerange=[-60, 60],
        forcelimited=True,
        **affine,
    )


def _exclude_neighbours(spec: mujoco.MjSpec) -> None:
    """Let bodies within three joints of one another not collide; the fingers have joint limits."""
    chain = [*_LINKS, "hand"]
    pairs = [(a, b) for i, a in enumerate(chain) for b in chain[i + 1 : i + 4]]
    pairs += [(link, finger) for link in chain[-4:] for finger in _FINGERS]
    pairs.append(_FINGERS)
    for a, b in pairs:
        spec.add_exclude(bodyname1=a, bodyname2=b)
