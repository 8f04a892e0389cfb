"""Forward and inverse kinematics of the Panda, in the frame of its base.

Plain numpy on the published geometry: no simulator, no state, about 0.02 ms a Jacobian, so that
controllers, planners and samplers can all afford it. The tool centre point is the ``tcp`` site:
z along the fingers, y along their opening direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from . import franka

LOWER: Float[np.ndarray, "7"] = np.array([joint.low for joint in franka.JOINTS])
"""Lower joint limits, radians."""

UPPER: Float[np.ndarray, "7"] = np.array([joint.high for joint in franka.JOINTS])
"""Upper joint limits, radians."""

HOME: Float[np.ndarray, "7"] = np.array(franka.HOME)
"""Home pose, radians."""

_A, _D, _ALPHA = (
    np.array([getattr(joint, name) for joint in franka.JOINTS]) for name in ("a", "d", "alpha")
)
_CA, _SA = np.cos(_ALPHA), np.sin(_ALPHA)
_LOCAL = np.zeros((7, 4, 4))
_LOCAL[:, 0, 3], _LOCAL[:, 1, 2], _LOCAL[:, 2, 2] = _A, -_SA, _CA
_LOCAL[:, 1, 3], _LOCAL[:, 2, 3], _LOCAL[:, 3, 3] = -_D * _SA, _D * _CA, 1.0
_HAND = np.eye(4)
_HAND[:2, :2] = [
    [np.cos(franka.HAND_YAW), -np.sin(franka.HAND_YAW)],
    [np.sin(franka.HAND_YAW), np.cos(franka.HAND_YAW)],
]
_HAND[2, 3] = franka.FLANGE + franka.TCP
_MAX_STEP = 0.2
_MARGIN = 0.02
_LOWEST, _HIGHEST = LOWER + _MARGIN, UPPER - _MARGIN
# Shoulder, elbow and wrist lie on a line at -0.467: beyond it the arm would get shorter again, and
# near it the joint would go to and fro. What is kept costs 2 mm of reach.
_HIGHEST[3] = -0.62
_EYE = np.eye(6)
for _constant in (LOWER, UPPER, HOME, _CA, _SA, _LOCAL, _HAND, _LOWEST, _HIGHEST, _EYE):
    _constant.setflags(write=False)


@dataclass(frozen=True, eq=False)
class IkSolution:
    """Joints found by ``solve_ik``, and what is left: metres and radians."""

    joints: Float[np.ndarray, "7"]
    position_error: float
    rotation_error: float

    @property
    def solved(self) -> bool:
        """Whether the target was met to 1 mm and 0.01 rad."""
        return self.position_error < 1e-3 and self.rotation_error < 1e-2


def link_frames(joints: Float[np.ndarray, "7"]) -> Float[np.ndarray, "8 4 4"]:
    """Return the frames of links 1 to 7 and of the tool centre point, in the base frame.

    Each is the product of the modified Denavit-Hartenberg transforms
    ``Rot_x(alpha) Trans_x(a) Rot_z(q) Trans_z(d)`` (Craig's convention) before it.
    """
    c, s = np.cos(joints), np.sin(joints)
    local = _LOCAL.copy()
    local[:, 0, 0], local[:, 0, 1] = c, -s
    local[:, 1, 0], local[:, 1, 1] = s * _CA, c * _CA
    local[:, 2, 0], local[:, 2, 1] = s * _SA, c * _SA
    frames = np.empty((8, 4, 4))
    frames[0] = local[0]
    for i in range(1, 7):
        np.dot(frames[i - 1], local[i], out=frames[i])
    np.dot(frames[6], _HAND, out=frames[7])
    return frames


def forward(
    joints: Float[np.ndarray, "7"],
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
    """Return position (m) and rotation of the tool centre point in the base frame."""
    tcp = link_frames(joints)[7]
    return tcp[:3, 3].copy(), tcp[:3, :3].copy()


def jacobian(frames: Float[np.ndarray, "8 4 4"]) -> Float[np.ndarray, "6 7"]:
    """Return the geometric Jacobian of the tool centre point: linear rows, then angular."""
    axes = frames[:7, :3, 2]
    arms = frames[7, :3, 3] - frames[:7, :3, 3]
    full = np.empty((6, 7))
    (x, y, z), (u, v, w) = axes.T, arms.T
    full[0], full[1], full[2] = y * w - z * v, z * u - x * w, x * v - y * u
    full[3:] = axes.T
    return full


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
    """Return the rotation of a hand that points straight down, its x axis at ``yaw``."""
    c, s = np.cos(yaw), np.sin(yaw)
    return np.array([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]])


def ik_step(
    joints: Float[np.ndarray, "7"],
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    pull: float = 0.05,
) -> tuple[Float[np.ndarray, "7"], float, float]:
    """Take one damped-least-squares step towards a tool pose given in the base frame.

    ``dq = p + J^T (J J^T + lambda^2 I)^-1 (e - J p)``, ``p = pull (HOME - q)``, with lambda
    shrinking with the error: of the pull remains what lies in J's null space. Joints that would
    leave their range go to its end and the others make up for it. The elbow stays short of
    straight. No joint moves by more than 0.2 rad, also where it comes back from out of its range.

    Returns:
        The new joints, and the errors (m, rad) *before* the step.
    """
    frames = link_frames(joints)
    error = np.empty(6)
    error[:3] = position - frames[7, :3, 3]
    error[3:] = rotation_vector(rotation @ frames[7, :3, :3].T)
    full = jacobian(frames)
    damping = (1e-5 + 1e-2 * min(1.0, float(error @ error))) * _EYE
    free, jac, rest = np.ones(7, bool), full, pull * (HOME - joints)
    # What is out of its range, such as a straight elbow, comes back by no more than a step.
    lowest = np.minimum(_LOWEST, joints + _MAX_STEP)
    highest = np.maximum(_HIGHEST, joints - _MAX_STEP)
    left = error
    for _ in range(3):
        step = rest + jac.T @ np.linalg.solve(jac @ jac.T + damping, left - jac @ rest)
        step *= min(1.0, _MAX_STEP / max(float(np.abs(step).max()), 1e-9))
        new = joints + step
        inside = np.minimum(np.maximum(new, lowest), highest)
        out = free & ((new - inside) * step > 0)
        if not np.count_nonzero(out):
            break
        free &= ~out
        ends = inside - joints
        left = left - full[:, out] @ ends[out]
        jac, rest = full * free, np.where(out, ends, rest)
    return inside, _length(error[:3]), _length(error[3:])


def solve_ik(
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    start: Float[np.ndarray, "7"] = HOME,
    iterations: int = 60,
) -> IkSolution:
    """Find joints that bring the tool centre point to a pose in the base frame (metres).

    Starts from ``start``, on whose branch it stays where it can, then from a few postures that face
    the target, each for ``iterations`` steps. Returns the best attempt, so look at ``solved``.
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


def _badness(solution: IkSolution) -> float:
    return solution.position_error + 0.1 * solution.rotation_error


def _descend(
    position: Float[np.ndarray, "3"],
    rotation: Float[np.ndarray, "3 3"],
    seed: Float[np.ndarray, "7"],
    iterations: int,
) -> IkSolution:
    joints = np.clip(seed, _LOWEST, _HIGHEST)
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
