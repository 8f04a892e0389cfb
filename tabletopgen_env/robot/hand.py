"""The Panda's hand, on an arm or alone: fingers with soft pads, and their actuator."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import franka
from .shells import COLORS, arm_shells, join
from .tool import add_tool

if TYPE_CHECKING:
    import mujoco

HAND = "hand"
"""Name of the hand's body."""

FINGERS = ("left_finger", "right_finger")
"""Names of the fingers' bodies."""

FINGER_JOINTS: tuple[str, ...] = ("finger_joint1", "finger_joint2")
"""Names of the fingers' slides."""

GRIPPER = "actuator8"
"""Name of the gripper's actuator (0-255)."""


def hand_spec() -> mujoco.MjSpec:
    """Return the hand alone, fixed to the world with the flange at the origin and z outwards."""
    import mujoco

    spec = mujoco.MjSpec()
    spec.modelname = HAND
    spec.compiler.degree = False
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    add_colors(spec)
    add_hand(spec, spec.worldbody.add_body(name=HAND, gravcomp=1))
    add_gripper(spec)
    for finger in FINGERS:
        spec.add_exclude(bodyname1=HAND, bodyname2=finger)
    spec.add_exclude(bodyname1=FINGERS[0], bodyname2=FINGERS[1])
    return spec


def add_colors(spec: mujoco.MjSpec) -> None:
    """Add the materials of the robot's shells."""
    for name, rgba in COLORS.items():
        spec.add_material(name=name, rgba=rgba, specular=0.4, shininess=0.5)


def add_hand(spec: mujoco.MjSpec, hand: mujoco.MjsBody) -> None:
    """Add the shape, fingers, tool centre point and wrist camera to the hand's body."""
    import mujoco

    dress(spec, hand)
    box = mujoco.mjtGeom.mjGEOM_BOX
    _collide(hand, "hand_collision", type=box, size=[0.0315, 0.102, 0.033], pos=[0, 0, 0.033])
    add_tool(hand)
    for name, joint, quat in zip(FINGERS, FINGER_JOINTS, ([1, 0, 0, 0], [0, 0, 0, 1]), strict=True):
        finger = hand.add_body(name=name, pos=[0, 0, franka.FINGER_MOUNT], quat=quat, gravcomp=1)
        finger.add_joint(
            name=joint,
            type=mujoco.mjtJoint.mjJNT_SLIDE,
            axis=[0, 1, 0],
            range=[0, franka.FINGER_STROKE],
            limited=True,
            armature=0.1,
            damping=[200, 0, 0],  # friction of the drive: 0.14 m/s at full force
        )
        dress(spec, finger)
        _collide(
            finger, f"{name}_shaft", type=box, size=[0.0105, 0.0095, 0.017], pos=[0, 0.0165, 0.018]
        )
        _add_pad(finger)


def _add_pad(finger: mujoco.MjsBody) -> None:
    """Add the pad of a finger: six spheres, and a box behind them that closes the gaps."""
    # The contact point of a sphere moves smoothly, so six spheres hold like a soft pad. On a box
    # the contact point jumps from edge to edge, and a curved object slips out of the hand.
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


def dress(spec: mujoco.MjSpec, body: mujoco.MjsBody) -> None:
    """Add the inertia, capsules and shells to ``body``."""
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
    shells = arm_shells()[body.name]
    for color in dict.fromkeys(shell.color for shell in shells):  # few geoms: each costs time
        name = f"{body.name}_{color}"
        vertices, faces = join([shell for shell in shells if shell.color == color])
        spec.add_mesh(
            name=name,
            uservert=vertices.astype(np.float32).ravel(),
            userface=faces.astype(np.int32).ravel(),
            inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL,
        )
        body.add_geom(
            name=name,
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=name,
            material=color,
            contype=0,
            conaffinity=0,
            group=2,
            mass=0,
        )


def _collide(body: mujoco.MjsBody, name: str, **geom: Any) -> None:
    """Add an invisible collision geom (group 3, as in Menagerie)."""
    body.add_geom(name=name, group=3, mass=0, rgba=[0.9, 0.4, 0.2, 0.4], **geom)


def add_gripper(spec: mujoco.MjSpec) -> None:
    """Add the gripper's actuator, which drives both fingers through a tendon."""
    import mujoco

    affine = {"gaintype": mujoco.mjtGain.mjGAIN_FIXED, "biastype": mujoco.mjtBias.mjBIAS_AFFINE}
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
    # The closed position (0) lies 5 mm beyond contact, so that the hand holds even a sheet. The
    # force is limited to 60 N over both fingers, below the 70 N that Franka specifies for the hand.
    stiffness, damping, beyond = 4000.0, 20.0, 0.005
    span = franka.FINGER_STROKE + beyond
    spec.add_actuator(
        name=GRIPPER,
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
