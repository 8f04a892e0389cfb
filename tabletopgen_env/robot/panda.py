"""The Franka Panda with its hand, as a MuJoCo specification built in code.

Joints, actuators and their order, limits, gains, home pose and the gripper's 0-255 command agree
with the MuJoCo Menagerie model, so policies transfer between ``visuals="primitive"`` (light: a few
colliding capsules and boxes, and low-poly shells) and ``visuals="menagerie"`` (the scanned covers).
There is one deliberate difference: this gripper squeezes with a force like that of the real hand
(up to 30 N per finger), while Menagerie's servo holds a 4 cm object with 1 N.

Frames: ``link0`` is the base, x forward, z up. ``tcp`` is the tool centre point between the
fingertips, z along the fingers (out of the hand), y along the opening direction.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from generator.errors import InputError

from . import franka
from .hand import FINGERS, GRIPPER, HAND, add_colors, add_gripper, add_hand, dress

if TYPE_CHECKING:
    import mujoco

ARM_JOINTS: tuple[str, ...] = tuple(f"joint{i}" for i in range(1, 8))
"""Names of the arm's joints, base to wrist."""

ACTUATORS: tuple[str, ...] = (*(f"actuator{i}" for i in range(1, 8)), GRIPPER)
"""Names of the actuators: seven position servos (radians) and the gripper (0-255)."""

HOME_QPOS: tuple[float, ...] = (*franka.HOME, franka.FINGER_STROKE, franka.FINGER_STROKE)
"""Joint positions at home: seven angles (rad), two fingers (m)."""

HOME_CTRL: tuple[float, ...] = (*franka.HOME, franka.GRIPPER_CTRL)
"""Commands that hold the home pose."""

_LINKS = tuple(f"link{i}" for i in range(8))


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
        """Return a new specification to attach to a scene.

        ``scene.attach(Panda().spec(), prefix="panda/", frame=frame)`` places the base at ``frame``;
        then set the home pose by joint name (``HOME_QPOS``, ``HOME_CTRL``).

        Raises:
            BackendError: ``visuals`` is "menagerie" and the meshes are not installed.
        """
        if self.visuals == "menagerie":
            from .menagerie import menagerie

            return menagerie()
        return _primitive()


# -------------------------------------------------------------------------- primitive model


def _primitive() -> mujoco.MjSpec:
    import mujoco

    spec = mujoco.MjSpec()
    spec.modelname = "panda"
    spec.compiler.degree = False
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    add_colors(spec)
    body = spec.worldbody.add_body(name="link0")
    dress(spec, body)
    for i, joint in enumerate(franka.JOINTS, start=1):
        body = _add_link(spec, body, i, joint)
    half = franka.HAND_YAW / 2
    turn = [np.cos(half), 0, 0, np.sin(half)]
    add_hand(spec, body.add_body(name=HAND, pos=[0, 0, franka.FLANGE], quat=turn, gravcomp=1))
    _add_actuators(spec)
    _exclude_neighbours(spec)
    return spec


def _add_link(
    spec: mujoco.MjSpec, parent: mujoco.MjsBody, number: int, joint: franka.Joint
) -> mujoco.MjsBody:
    """Add link ``number`` and its joint at the modified-DH frame."""
    body = parent.add_body(
        name=f"link{number}",
        pos=joint.place,
        quat=joint.turn,
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
    dress(spec, body)
    return body


def _add_actuators(spec: mujoco.MjSpec) -> None:
    """Add seven position servos and the gripper."""
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
    add_gripper(spec)


def _exclude_neighbours(spec: mujoco.MjSpec) -> None:
    """Exclude collisions of bodies up to three joints apart; joint limits separate the fingers."""
    chain = [*_LINKS, HAND]
    pairs = [(a, b) for i, a in enumerate(chain) for b in chain[i + 1 : i + 4]]
    pairs += [(link, finger) for link in chain[-4:] for finger in FINGERS]
    pairs.append(FINGERS)
    for a, b in pairs:
        spec.add_exclude(bodyname1=a, bodyname2=b)
