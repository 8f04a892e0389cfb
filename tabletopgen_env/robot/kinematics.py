"""Forward and inverse kinematics of the Panda, in the frame of its base.

The functions use the published geometry and no scene. A step takes 0.03 ms, fast enough for
controllers, planners and samplers. The tool centre point is the ``tcp`` site: z along the fingers,
y along their opening direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float
from scipy.linalg import lapack

from . import franka
from .chain import chain_at

LOWER: Float[np.ndarray, "7"] = np.array([joint.low for joint in franka.JOINTS])
"""Lower joint limits, in radians."""

UPPER: Float[np.ndarray, "7"] = np.array([joint.high for joint in franka.JOINTS])
"""Upper joint limits, in radians."""

HOME: Float[np.ndarray, "7"] = np.array(franka.HOME)
"""Home pose, in radians."""

MAX_STEP = 0.2
"""Maximum motion of a joint in one step of ``ik_step``, in radians."""

_MARGIN = 0.02

LOWEST, HIGHEST = LOWER + _MARGIN, UPPER - _MARGIN
"""Lower and upper bounds of the joints that ``ik_step`` returns, in radians."""

_solve: Any = getattr(lapack, "dposv")  # noqa: B009 - made at run time, unknown to type checkers
# Shoulder, elbow and wrist are collinear at -0.467. Beyond this angle the arm would get shorter
# again, and near it the joint would oscillate. The margin reduces the reach by 2 mm.
HIGHEST[3] = -0.62
for _constant in (LOWER, UPPER, HOME, LOWEST, HIGHEST):
    _constant.setflags(write=False)


@dataclass(frozen=True, eq=False)
class IkSolution:
    """The joints found by ``solve_ik``, and the remaining errors in metres and radians."""

    joints: Float[np.ndarray, "7"]
    position_error: float
    rotation_error: float

    @property
    def solved(self) -> bool:
        """Whether the solution meets the target to within 1 mm and 0.01 rad."""
        return self.position_error < 1e-3 and self.rotation_error < 1e-2


def link_frames(joints: Float[np.ndarray, "7"]) -> Float[np.ndarray, "7 4 4"]:
    """Return the frames of links 1 to 7 in the base frame."""
    chain = chain_at(joints)
    frames = np.tile(np.eye(4), (7, 1, 1))
    frames[:, :3, :3], frames[:, :3, 3] = chain.turns, chain.links
    return frames


def forward(
    joints: Float[np.ndarray, "7"],
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
    """Return the position (m) and rotation of the tool centre point in the base frame."""
    chain = chain_at(joints)
    return chain.tool.copy(), chain.hand.copy()


def _length(vector: Float[np.ndarray, "n"]) -> float:
    return math.sqrt(vector @ vector)


def rotation_vector(rotation: Float[np.ndarray, "3 3"]) -> Float[np.ndarray, "3"]:
    """Return the axis of a rotation matrix times its angle (radians, in [0, pi])."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation.tolist()
    skew = np.array([zy - yz, xz - zx, yx - xy])
    sine, cosine = _length(skew) / 2, (xx + yy + zz - 1) / 2
    angle = math.atan2(sine, cosine)
    if sine > 1e-7:
        return skew * (angle / (2 * sine))
    if cosine > 0:
        return skew / 2
    axis = np.sqrt(np.maximum((np.diag(rotation) + 1) / 2, 0))
    largest = int(np.argmax(axis))
    signs = np.sign(rotation[largest])
    signs[largest] = 1.0
    return angle * axis * np.where(signs == 0, 1.0, signs)


def pointing_down(yaw: float) -> Float[np.ndarray, "3 3"]:
    """Return the rotation of a hand that points straight down, with its x axis at ``yaw``."""
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]])


def ik_step(
    joints: Float[np.ndarray, "7"],
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    pull: float = 0.05,
) -> tuple[Float[np.ndarray, "7"], float, float]:
    """Take one damped-least-squares step towards a tool pose given in the base frame.

    ``dq = p + J^T (J J^T + lambda^2 I)^-1 (e - J p)``, ``p = pull (HOME - q)``, with a lambda that
    decreases with the error: only the null-space component of the pull remains. Joints that would
    leave their range stop at its end, and the others compensate. The elbow never straightens fully.
    No joint moves by more than 0.2 rad, even if it returns from outside its range.

    Returns:
        The new joints, and the errors (m, rad) *before* the step.
    """
    chain = chain_at(joints)
    error = np.empty(6)
    error[:3] = position - chain.tool
    error[3:] = rotation_vector(rotation @ chain.hand.T)
    jac, rest = chain.jacobian(), pull * (HOME - joints)
    damping = 1e-5 + 1e-2 * min(1.0, float(error @ error))
    new = joints + _damped_step(jac, error, rest, damping)
    if np.count_nonzero((new < LOWEST) | (new > HIGHEST)):
        new = _turn_back(joints, new, jac, error, rest, damping)
    return new, _length(error[:3]), _length(error[3:])


def _damped_step(
    jac: Float[np.ndarray, "6 7"],
    error: Float[np.ndarray, "6"],
    rest: Float[np.ndarray, "7"],
    damping: float,
) -> Float[np.ndarray, "7"]:
    """Return the step of ``ik_step`` without joint limits."""
    square = jac @ jac.T
    square.ravel()[::7] += damping
    step = rest + _solve(square, error - jac @ rest)[1] @ jac
    largest = max(map(abs, step.tolist()))
    return step if largest <= MAX_STEP else step * (MAX_STEP / largest)


def _turn_back(
    joints: Float[np.ndarray, "7"],
    new: Float[np.ndarray, "7"],
    jac: Float[np.ndarray, "6 7"],
    left: Float[np.ndarray, "6"],
    rest: Float[np.ndarray, "7"],
    damping: float,
) -> Float[np.ndarray, "7"]:
    """Return a replacement for the joint angles ``new`` that stays within all joint ranges."""
    # Joints out of their range, such as a straight elbow, return by at most one step.
    lowest = np.minimum(LOWEST, joints + MAX_STEP)
    highest = np.maximum(HIGHEST, joints - MAX_STEP)
    free = np.ones(7)
    for _ in range(2):
        inside = np.minimum(np.maximum(new, lowest), highest)
        out = free * (new - inside) * (new - joints) > 0
        if not np.count_nonzero(out):
            return inside
        free[out] = 0.0
        rest = np.where(out, inside - joints, rest)
        left = left - jac @ (rest * out)
        new = joints + _damped_step(jac * free, left, rest, damping)
    return np.minimum(np.maximum(new, lowest), highest)


def solve_ik(
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    start: Float[np.ndarray, "7"] = HOME,
    iterations: int = 60,
) -> IkSolution:
    """Find joint angles that bring the tool centre point to a pose in the base frame (metres).

    The search starts from ``start``, whose branch it keeps if possible, then from a few postures
    that face the target, with ``iterations`` steps each. It returns the best attempt; check
    ``solved``.
    """
    bearing = float(np.arctan2(position[1], position[0]))
    seeds = [np.asarray(start, float)]
    seeds += [
        np.array([bearing, shoulder, 0.0, elbow, 0.0, wrist, roll])
        for shoulder, elbow, wrist in ((0.0, -1.57, 1.57), (0.4, -2.2, 2.6), (-0.4, -2.4, 2.2))
        for roll in (-0.785, 1.5, -2.3)
    ]
    found: list[IkSolution] = []
    for seed in seeds:
        found.append(_descend(position, rotation, seed, iterations))
        if found[-1].solved:
            return found[-1]
    return min(found, key=_badness)


def is_beyond_reach(position: Float[np.ndarray, "3"]) -> bool:
    """Return whether a tool position is too far for a downward-pointing hand at every yaw.

    The position is in the base frame, metres. It is beyond reach if the wrist would have to be
    farther from the shoulder than the elbow allows, by more than the tolerance of
    ``IkSolution.solved``; ``solve_ik`` then cannot solve the pose. Positions that are not beyond
    reach may still have no solution.
    """
    x, y, z = position.tolist()
    aside = max(math.hypot(x, y) - franka.JOINTS[6].a, 0.0)
    wrist = z + franka.FLANGE + franka.TCP
    return math.hypot(aside, wrist - franka.JOINTS[0].d) > _LONGEST + _TOLERATED


def _wrist_distance(elbow: float) -> float:
    """Return the distance in metres from shoulder to wrist at an elbow angle in radians."""
    upper, lower = franka.JOINTS[2:5:2]
    c, s = math.cos(elbow), math.sin(elbow)
    bent = franka.JOINTS[3].a
    along = upper.d - s * bent + c * lower.d
    aside = bent - c * bent - s * lower.d
    return math.hypot(along, aside)


_LONGEST = _wrist_distance(float(HIGHEST[3]))
_TOLERATED = 0.004  # 1 mm, and 0.01 rad over the 0.23 m between tool and wrist


def _badness(solution: IkSolution) -> float:
    return solution.position_error + 0.1 * solution.rotation_error


def _descend(
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    seed: Float[np.ndarray, "7"],
    iterations: int,
) -> IkSolution:
    joints = np.clip(seed, LOWEST, HIGHEST)
    best = IkSolution(joints, np.inf, np.inf)
    for k in range(iterations):
        pull = 0.05 * (1 - k / iterations)
        new, far, turned = ik_step(joints, position, rotation, pull=pull)
        found = IkSolution(joints, far, turned)
        if _badness(found) < _badness(best):
            best = found
        if far < 2e-4 and turned < 2e-3:
            break
        joints = new
    return best
