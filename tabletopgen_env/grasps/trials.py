"""Grasp trials in MuJoCo: the Panda's hand grasps a single object, lifts it and shakes it.

The hand is fixed and gravity varies instead: an acceleration a of the hand is equivalent to gravity
g - a, and a slow rotation of the hand to a rotation of gravity. The object floats while the fingers
close, so that it can yield, as in C. Eppner, A. Mousavian, D. Fox, "ACRONYM: a large-scale grasp
dataset based on simulation", ICRA 2021. Three stages follow in order:

======  ============================================================================
lift    gravity increases along the object's -z axis: the object hangs upright from the hand
turn    gravity rotates once about the object's x axis, then once about its y axis
shake   the hand oscillates along the object's x, y and z axes, one after another
======  ============================================================================

A stage is passed if both fingers still touch the object, and it has moved in the hand by less than
``SLIP`` and rotated by less than ``TWIST`` since they closed. Every trial draws an error of the
hand's pose and the friction of its pads.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import mujoco
import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from generator.physics.mjcf import object_document
from generator.physics.spec import compile_spec, new_data, spec_of
from generator.scene import Object

from ..robot import franka
from ..robot.hand import FINGER_JOINTS, FINGERS, hand_spec
from ..robot.tool import TCP_SITE
from .candidates import GraspCandidate

SLIP, TWIST = 0.02, float(np.deg2rad(30.0))
"""Maximum motion of a held object in the hand, in metres and radians."""

STAGES = ("close", "lift", "turn", "shake")
"""The stages of a trial."""

ERROR = (0.0025, float(np.deg2rad(3.0)))
"""Standard deviations of the hand's position along each axis (m) and rotation about each (rad)."""

FRICTION = (0.5, 1.0)
"""Range of the factor applied to the finger pads' friction coefficient of 1.3."""

GRAVITY, SWING = 9.81, 5.0
"""Accelerations of the lift and of the shake, in m/s²."""

_HAND = "hand/"
_STEP = 0.004  # seconds; half of it gives the same results
_CLOSE, _RAMP, _HOLD, _TURN, _SWING_TIME = 0.4, 0.1, 0.16, 0.4, 0.2  # seconds
_EVERY = 5  # steps with constant gravity
_LOOK = 25  # steps between two checks of the hold
_DEEP = 1e-3  # maximum overlap of the open hand with the object, metres


@dataclass(frozen=True)
class Trial:
    """The result of a trial: the number of ``STAGES`` passed and the gap of the closed fingers."""

    passed: int
    width: float


class GraspBench:
    """An object and a hand, compiled once for all trials."""

    def __init__(self, thing: Object) -> None:
        spec = spec_of(object_document(thing), thing.name)
        spec.option.timestep = _STEP
        spec.option.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        hand = hand_spec()
        hand.assets = {**spec.assets, **hand.assets}
        spec.attach(hand, prefix=_HAND, frame=spec.worldbody.add_frame())
        self._model = model = compile_spec(spec, thing.name)
        self._data = data = new_data(model)
        mujoco.mj_forward(model, data)
        tool = model.site(_HAND + TCP_SITE).id
        self._tool = data.site_xpos[tool].copy()
        self._axes = data.site_xmat[tool].reshape(3, 3).copy()
        body = model.body(thing.name).id
        self._body = body
        self._free = int(model.jnt_qposadr[model.body_jntadr[body]])
        joints = [model.joint(_HAND + name) for name in FINGER_JOINTS]
        self._fingers = np.array([int(joint.qposadr[0]) for joint in joints])
        self._own = model.geom_bodyid == body
        sides = [model.body(_HAND + name).id for name in FINGERS]
        self._sides = [model.geom_bodyid == side for side in sides]
        self._pads = np.flatnonzero(
            [model.geom(k).name.startswith(tuple(f"{_HAND}{n}_pad" for n in FINGERS))
             for k in range(model.ngeom)]
        )  # fmt: skip
        self._friction = model.geom_friction.copy()

    def try_grasp(self, grasp: GraspCandidate, rng: np.random.Generator) -> Trial:
        """Try a grasp once, with random errors drawn from ``rng``."""
        model, data = self._model, self._data
        off = rng.normal(scale=ERROR[0], size=3)
        turned = Rotation.from_rotvec(rng.normal(scale=ERROR[1], size=3)).as_matrix()
        model.geom_friction[:] = self._friction
        model.geom_friction[self._pads, :2] *= rng.uniform(*FRICTION)
        mujoco.mj_resetData(model, data)
        # The pose of the tool in the object's frame determines the pose of the object.
        hand = grasp.rotation @ turned
        turn = self._axes @ hand.T
        position = grasp.position + grasp.rotation @ off
        data.qpos[self._free : self._free + 3] = self._tool - turn @ position
        quaternion = Rotation.from_matrix(turn).as_quat(scalar_first=True)
        data.qpos[self._free + 3 : self._free + 7] = quaternion
        data.qpos[self._fingers] = min(grasp.opening / 2, franka.FINGER_STROKE)
        model.opt.gravity[:] = 0.0
        mujoco.mj_forward(model, data)
        if self._overlaps():
            return Trial(0, grasp.width)
        return self._play(grasp)

    def _play(self, grasp: GraspCandidate) -> Trial:
        """Close the fingers and run the stages until the object is lost."""
        self._data.ctrl[:] = 0.0
        self._run(round(_CLOSE / _STEP))
        if not self._is_touched():
            return Trial(0, grasp.width)
        start = self._pose()
        width = float(self._data.qpos[self._fingers].sum().clip(0.0, 2 * franka.FINGER_STROKE))
        axes = self._data.xmat[self._body].reshape(3, 3).copy()
        passed = 1
        for stage in STAGES[1:]:
            for step, pull in enumerate(_pulls(stage)):
                self._model.opt.gravity[:] = axes @ pull
                self._run(_EVERY)
                if step % (_LOOK // _EVERY) == 0 and not self._holds(start):
                    return Trial(passed, width)
            if not self._holds(start):
                return Trial(passed, width)
            passed += 1
        return Trial(passed, width)

    def _run(self, steps: int) -> None:
        mujoco.mj_step(self._model, self._data, steps)

    def _pose(self) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
        """Return the pose of the object in the hand's frame."""
        data = self._data
        return data.xipos[self._body].copy(), data.xmat[self._body].reshape(3, 3).copy()

    def _holds(self, start: tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]) -> bool:
        """Return whether the object is still in the hand, close to its initial pose ``start``."""
        place, axes = self._pose()
        if np.linalg.norm(place - start[0]) > SLIP or not self._is_touched():
            return False
        cosine = (np.trace(axes @ start[1].T) - 1) / 2
        return bool(cosine > np.cos(TWIST))

    def _is_touched(self) -> bool:
        """Return whether both fingers touch the object."""
        geoms = self._data.contact.geom
        mine = self._own[geoms]
        touching = geoms[mine.any(1)]
        return all(bool(side[touching].any()) for side in self._sides)

    def _overlaps(self) -> bool:
        """Return whether the open hand overlaps the object."""
        contact = self._data.contact
        return bool((contact.dist < -_DEEP).any())


def _pulls(stage: str) -> Iterator[Float[np.ndarray, "3"]]:
    """Yield a stage's gravity vectors (m/s²), in the object's frame at the time of the grasp."""
    span = _STEP * _EVERY
    if stage == "lift":
        for k in range(round((_RAMP + _HOLD) / span)):
            share = min(1.0, (k + 1) * span / _RAMP)
            yield np.array([0.0, 0.0, -GRAVITY * share])
        return
    count = round((_TURN if stage == "turn" else _SWING_TIME) / span)
    for axis in range(2 if stage == "turn" else 3):
        for angle in 2 * np.pi * (np.arange(count) + 1) / count:
            if stage == "turn":
                pull = np.array([0.0, 0.0, -np.cos(angle)])
                pull[1 - axis] = np.sin(angle)
                yield GRAVITY * pull
            else:
                pull = np.array([0.0, 0.0, -GRAVITY])
                pull[axis] += SWING * np.sin(angle)
                yield pull
