"""A scripted expert for PickPlace: it plans from what it sees now and acts like any policy.

The expert drives the environment through its own normalised actions, by a proportional law on the
tool's present pose, so its demonstrations hold nothing a learner cannot see: no hidden timer moves
the arm, each phase ends when its aim is met.

=========  =====================================================================================
approach   rise over what is in the way, go above the grasp, turn the hand
descend    straight down with the fingers opened as far as there is room
close      until the fingers stand still
lift       straight up; if the object stays behind, plan another grasp
carry      over what is in the way, to above the goal
lower      until the object stands, or hangs as deep in the container as the fingers allow
release    open
retreat    straight up, then stay
stuck      stand still: the object has come to lie where no grasp reaches it
=========  =====================================================================================
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from jaxtyping import Float

from generator.errors import InputError, SceneError
from generator.geometry import wrap

from ..actions import EE_STEP, EE_TURN, Servos
from ..robot import franka
from ..robot.kinematics import HOME, LOWER, UPPER, solve_ik
from .grasps import TIP, Grasp, plan_grasps
from .path import clear_height

if TYPE_CHECKING:
    from ..env import TabletopEnv

Phase = Literal[
    "approach", "descend", "close", "lift", "carry", "lower", "release", "retreat", "stuck"
]

_GAIN, _TURN_GAIN = 0.3, 0.4
_HOVER = 0.06
_LIFT = 0.06
_NEAR, _FINE, _TURNED = 0.02, 0.005, 0.05
_SLIP = 0.03
_MOVED = 0.015
_PATIENCE: dict[Phase, int] = {
    "approach": 55, "descend": 30, "close": 14, "lift": 30, "carry": 80, "lower": 45,
    "release": 8, "retreat": 60, "stuck": 60,
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Plan:
    """A grasp that can be reached: the hand's yaw in the base frame, and where the object was."""

    grasp: Grasp
    yaw: float
    seen: Float[np.ndarray, "3"]


class PickPlaceExpert:
    """Solves ``TabletopGen/PickPlace-v0`` in the action mode "ee_delta".

    Args:
        env: the environment, wrapped or not.

    Call ``reset()`` after the environment's, then ``act()`` before each step. ``phase`` says what
    it is doing, ``attempts`` how many grasps it has begun.

    Raises:
        InputError: the environment has another action mode, rate or gripper.
        SceneError: at ``reset``, if no grasp of the target can be reached.
    """

    def __init__(self, env: Any) -> None:
        self._env: TabletopEnv = env.unwrapped
        if self._env.action_mode != "ee_delta" or self._env.controller.servos != Servos():
            raise InputError(
                "The expert acts in 'ee_delta' at 20 Hz with a continuous gripper; make the "
                "environment with these."
            )
        self.phase: Phase = "approach"
        self.attempts = 0

    def reset(self) -> None:
        """Plan for the episode that has just begun."""
        self.attempts = 0
        self._failed: tuple[Grasp, ...] = ()
        if not self._begin():
            raise SceneError(
                f"The expert finds no grasp of {self._env.episode.target!r} in scene "
                f"{self._env.world.scene.name!r} that the arm can reach; choose another target."
            )

    # ------------------------------------------------------------------------------------ acting

    def act(self) -> Float[np.ndarray, "5"]:
        """Return the next action, ``float32`` in [-1, 1]."""
        self._steps += 1
        late = self._steps > _PATIENCE[self.phase]
        phases: dict[Phase, Callable[[bool], Float[np.ndarray, "5"]]] = {
            "approach": self._approach,
            "descend": self._descend,
            "close": self._close,
            "lift": self._lift,
            "carry": self._carry,
            "lower": self._lower,
            "release": self._release,
            "retreat": self._retreat,
            "stuck": self._stuck,
        }
        return phases[self.phase](late).astype(np.float32)

    def _approach(self, late: bool) -> Float[np.ndarray, "5"]:
        if late or self._has_moved():
            return self._retry(failed=late)
        grasp = self._plan.grasp
        above = grasp.point + _up(_HOVER)
        near = np.linalg.norm((self._tool - above)[:2]) < _FINE
        if near and abs(self._turn_left()) < _TURNED and self._tool[2] < above[2] + _NEAR:
            return self._enter("descend")
        return self._travel(above, grasp.opening, depth=TIP)

    def _descend(self, late: bool) -> Float[np.ndarray, "5"]:
        grasp = self._plan.grasp
        if self._has_moved():
            return self._retry(failed=False)
        low = self._tool[2] - grasp.point[2] < 0.004
        if low or late:
            return self._enter("close")
        return self._go(grasp.point, grasp.opening, slow=0.7)

    def _close(self, late: bool) -> Float[np.ndarray, "5"]:
        gap = self._gap
        still = abs(gap - self._last_gap) < 2e-4 and self._steps > 4
        self._last_gap = gap
        if still or late:
            self._held = self._object - self._tool
            return self._enter("lift")
        return self._go(self._plan.grasp.point, 0.0)

    def _lift(self, late: bool) -> Float[np.ndarray, "5"]:
        target = self._plan.grasp.point + _up(_LIFT)
        if self._has_slipped():
            return self._retry()
        if self._tool[2] > target[2] - _NEAR or late:
            return self._enter("carry")
        return self._go(target, 0.0, slow=0.7)

    def _carry(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._has_slipped():
            return self._retry()
        goal = self._goal() + _up(0.04)
        away = float(np.linalg.norm((self._tool - goal)[:2]))
        if late or (away < 0.008 and self._tool[2] < goal[2] + _NEAR):
            return self._enter("lower")
        return self._travel(goal, 0.0, depth=self._hanging())

    def _lower(self, late: bool) -> Float[np.ndarray, "5"]:
        if self._has_slipped():
            return self._retry()
        goal = self._goal()
        if late or self._tool[2] < goal[2] + 0.004:
            return self._enter("release")
        return self._go(goal, 0.0, slow=0.4)

    def _release(self, late: bool) -> Float[np.ndarray, "5"]:
        if late or (self._gap > self._plan.grasp.opening - 0.004):
            return self._enter("retreat")
        return self._act(np.zeros(3), 0.0, self._plan.grasp.opening)

    def _retreat(self, late: bool) -> Float[np.ndarray, "5"]:
        if late or (self._steps > 25 and self._missed()):
            return self._retry()
        rise = self._placed[2] + 0.15 - self._tool[2]
        return self._act(np.array([0, 0, max(rise, 0.0)]), 0.0, self._plan.grasp.opening)

    # ---------------------------------------------------------------------------------- planning

    def _begin(self, failed: bool = False) -> bool:
        """Choose the best grasp that the arm can reach and approach it, or be stuck."""
        world, name = self._env.world, self._env.episode.target
        if failed:
            self._failed = (*self._failed, self._plan.grasp)
        self.attempts += 1
        for grasp in plan_grasps(world, name, self._failed)[:80]:
            yaw = self._reachable_yaw(grasp)
            if yaw is not None:
                self._plan = Plan(grasp, yaw, world.position(name))
                self._enter("approach")
                return True
        self.phase, self._steps = "stuck", 0
        return False

    def _reachable_yaw(self, grasp: Grasp) -> float | None:
        """Return the hand's yaw (base frame) that reaches the grasp most comfortably, if any."""
        world = self._env.world
        angle = grasp.angle - world.mount.yaw + np.pi / 2
        best: tuple[float, float] | None = None
        for yaw in (wrap(angle), wrap(angle + np.pi)):
            c, s = np.cos(yaw), np.sin(yaw)
            down = np.array([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]])
            stretch = 0.0
            for height in (0.0, _HOVER):
                found = solve_ik(world.to_base(grasp.point + _up(height)), down, iterations=40)
                inside = np.minimum(found.joints - LOWER, UPPER - found.joints).min()
                if not found.solved or inside < 0.05:
                    break
                stretch = max(stretch, float(np.abs(found.joints - HOME).max()))
            else:
                if best is None or stretch < best[0]:
                    best = stretch, yaw
        return None if best is None else best[1]

    def _stuck(self, late: bool) -> Float[np.ndarray, "5"]:
        if late:
            return self._retry(failed=False)
        return self._act(np.zeros(3), 0.0, 2 * franka.FINGER_STROKE)

    def _retry(self, failed: bool = True) -> Float[np.ndarray, "5"]:
        """Plan again, this grasp being to blame or not, and let go for this step."""
        self._begin(failed)
        return self._act(np.zeros(3), 0.0, 2 * franka.FINGER_STROKE)

    def _goal(self) -> Float[np.ndarray, "3"]:
        """Return where the tool has to be for the object to be let go, world frame."""
        world, episode = self._env.world, self._env.episode
        offset = self._object - self._tool
        region = self._env.task.region(world, episode)
        bottom = self._object[2] - world.lowest(episode.target)
        if episode.spot is not None:
            resting = np.array([*region.center[:2], episode.spot[2] + bottom + 0.004])
            return resting - offset
        hollow, container = episode.opening, episode.container
        assert hollow is not None and container is not None
        base = world.position(container)[2]
        resting = np.array([*region.center[:2], base + hollow.floor + bottom + 0.006])
        goal = resting - offset
        if not self._fingers_fit(2 * float(hollow.semi.min())):
            goal[2] = max(goal[2], base + hollow.rim + TIP + 0.004)
        return goal

    def _fingers_fit(self, across: float) -> bool:
        """Return whether the opened fingers go into a hollow ``across`` metres wide."""
        away = float(np.linalg.norm((self._object - self._tool)[:2]))
        return self._plan.grasp.opening + 2 * 0.028 + 2 * away < across

    # ----------------------------------------------------------------------------------- sensing

    @property
    def _tool(self) -> Float[np.ndarray, "3"]:
        world = self._env.world
        return world.data.site_xpos[world.tcp].copy()

    @property
    def _object(self) -> Float[np.ndarray, "3"]:
        return self._env.world.position(self._env.episode.target)

    @property
    def _gap(self) -> float:
        world = self._env.world
        return float(world.data.qpos[world.finger_qpos].sum())

    def _turn_left(self) -> float:
        """Return the yaw still to turn, radians."""
        world = self._env.world
        axis = world.base_rotation.T @ world.data.site_xmat[world.tcp].reshape(3, 3)[:, 0]
        return wrap(self._plan.yaw - float(np.arctan2(axis[1], axis[0])))

    def _hanging(self) -> float:
        """Return how far the held object, or the fingertips, reach below the tool."""
        below = self._tool[2] - self._env.world.lowest(self._env.episode.target)
        return max(float(below), TIP)

    def _has_moved(self) -> bool:
        return bool(np.linalg.norm(self._object - self._plan.seen) > _MOVED)

    def _has_slipped(self) -> bool:
        """Return whether the object has left the hand since the fingers closed."""
        return bool(np.linalg.norm(self._object - self._tool - self._held) > _SLIP)

    def _missed(self) -> bool:
        """Return whether the released object lies outside the goal."""
        world, episode, task = self._env.world, self._env.episode, self._env.task
        desired = task.desired(world, episode)
        across, up = task.distance(task.achieved(world, episode, desired), desired)
        return bool(across > 0 or up > 0)

    # ------------------------------------------------------------------------------------ moving

    def _enter(self, phase: Phase) -> Float[np.ndarray, "5"]:
        """Change to ``phase`` and stand still for this step."""
        self.phase = phase
        self._steps = 0
        self._last_gap = self._gap
        self._placed = self._tool
        closed = phase in ("close", "lift", "carry", "lower")
        return self._act(np.zeros(3), 0.0, 0.0 if closed else self._plan.grasp.opening)

    def _travel(
        self, point: Float[np.ndarray, "3"], opening: float, depth: float
    ) -> Float[np.ndarray, "5"]:
        """Go to ``point`` over whatever is in the way of something ``depth`` below the tool."""
        world, tool = self._env.world, self._tool
        high = clear_height(world, self._env.episode.target, tool, point) + depth
        high = max(high, point[2])
        if np.linalg.norm((point - tool)[:2]) < _NEAR:
            return self._go(point, opening)
        if tool[2] < high - 0.02:
            return self._go(np.array([*tool[:2], high + 0.02]), opening)
        return self._go(np.array([*point[:2], high]), opening)

    def _go(
        self, point: Float[np.ndarray, "3"], opening: float, slow: float = 1.0
    ) -> Float[np.ndarray, "5"]:
        return self._act(point - self._tool, self._turn_left(), opening, slow)

    def _act(
        self, move: Float[np.ndarray, "3"], turn: float, opening: float, slow: float = 1.0
    ) -> Float[np.ndarray, "5"]:
        """Return the action that moves (world frame, m), turns (rad) and opens (m)."""
        step = self._env.world.base_rotation.T @ move * (_GAIN / EE_STEP)
        step /= max(1.0, float(np.abs(step).max()) / slow)
        spin = np.clip(turn * _TURN_GAIN / EE_TURN, -1.0, 1.0)
        wide = 2 * opening / (2 * franka.FINGER_STROKE) - 1 if opening > 0 else -1.0
        return np.array([*step, spin, np.clip(wide, -1.0, 1.0)])


def _up(height: float) -> Float[np.ndarray, "3"]:
    return np.array([0.0, 0.0, height])
