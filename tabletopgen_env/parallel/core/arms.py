"""Forward and inverse kinematics of n arms, with the formulas of ``robot.kinematics``."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ...robot import franka
from ...robot.kinematics import HIGHEST, HOME, LOWEST, MAX_STEP
from .arrays import Array, apply, like, namespace, squares

_A, _D, _ALPHA = (
    np.array([getattr(joint, name) for joint in franka.JOINTS]) for name in ("a", "d", "alpha")
)


@dataclass(frozen=True, eq=False)
class Arms:
    """Tool points (m), rotations and geometric Jacobians of n arms in the base frame."""

    tool: Float[Array, "n 3"]
    hand: Float[Array, "n 3 3"]
    jacobian: Float[Array, "n 6 7"]


def arms_at(joints: Float[Array, "n 7"]) -> Arms:
    """Compute forward kinematics for joint angles in radians, with the chain of ``robot.chain``."""
    xp = namespace(joints)
    cosines, sines = xp.cos(joints), xp.sin(joints)
    x, y, z = (like(column, joints)[None] for column in np.eye(3))
    at = like(np.zeros(3), joints)[None]
    axes, places = [], []
    for k in range(7):
        # Rot_x(alpha) Trans_x(a), then Rot_z(q) Trans_z(d)
        ca, sa = float(np.cos(_ALPHA[k])), float(np.sin(_ALPHA[k]))
        at = at + float(_A[k]) * x
        y, z = ca * y + sa * z, ca * z - sa * y
        c, s = cosines[:, k : k + 1], sines[:, k : k + 1]
        x, y = c * x + s * y, c * y - s * x
        at = at + float(_D[k]) * z
        axes.append(xp.broadcast_to(z, at.shape))
        places.append(at)
    tool = at + (franka.FLANGE + franka.TCP) * z
    c, s = float(np.cos(franka.HAND_YAW)), float(np.sin(franka.HAND_YAW))
    hand = xp.stack([c * x + s * y, c * y - s * x, xp.broadcast_to(z, x.shape)], axis=-1)
    turns = xp.stack([xp.broadcast_to(axis, tool.shape) for axis in axes], axis=-1)
    levers = tool[..., None] - xp.stack(
        [xp.broadcast_to(place, tool.shape) for place in places], axis=-1
    )
    return Arms(tool, hand, xp.concat([_cross(turns, levers), turns], axis=1))


def rotation_vectors(rotations: Float[Array, "n 3 3"]) -> Float[Array, "n 3"]:
    """Return rotation vectors (axis times angle in [0, pi) rad), less accurate near pi."""
    xp = namespace(rotations)
    skew = xp.stack(
        [rotations[:, 2, 1] - rotations[:, 1, 2], rotations[:, 0, 2] - rotations[:, 2, 0],
         rotations[:, 1, 0] - rotations[:, 0, 1]], axis=-1)  # fmt: skip
    sine = xp.sqrt(squares(skew)) / 2
    cosine = (rotations[:, 0, 0] + rotations[:, 1, 1] + rotations[:, 2, 2] - 1) / 2
    small = sine <= 1e-7
    scale = xp.where(small, xp.full_like(sine, 0.5),
                     xp.atan2(sine, cosine) / (2 * xp.clip(sine, min=1e-7)))  # fmt: skip
    return skew * scale[:, None]


def rotations_of(vectors: Float[Array, "n 3"]) -> Float[Array, "n 3 3"]:
    """Return the rotation matrices of rotation vectors in radians (Rodrigues' formula)."""
    xp = namespace(vectors)
    angle = xp.sqrt(squares(vectors))[:, None, None]
    x, y, z = (vectors[:, k] for k in range(3))
    zero = xp.zeros_like(x)
    skew = xp.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1)
    skew = xp.reshape(skew, (-1, 3, 3))
    safe = xp.clip(angle, min=1e-9)
    first = xp.where(angle < 1e-4, 1 - angle * angle / 6, xp.sin(safe) / safe)
    second = xp.where(angle < 1e-4, 0.5 - angle * angle / 24, (1 - xp.cos(safe)) / (safe * safe))
    eye = like(np.eye(3), vectors)
    return eye + first * skew + second * (skew @ skew)


def ik_steps(
    joints: Float[Array, "n 7"],
    position: Float[Array, "n 3"],
    rotation: Float[Array, "n 3 3"],
    pull: float,
) -> Float[Array, "n 7"]:
    """Take a damped-least-squares step per arm towards a tool pose; see ``kinematics.ik_step``."""
    xp = namespace(joints)
    arms = arms_at(joints)
    turn = rotation_vectors(rotation @ xp.matrix_transpose(arms.hand))
    left = xp.concat([position - arms.tool, turn], axis=-1)
    lowest, highest = (like(bound, joints) for bound in (LOWEST, HIGHEST))
    square = xp.sum(left * left, axis=-1)
    damping = 1e-5 + 1e-2 * xp.clip(square, max=1.0)
    rest = pull * (like(HOME, joints) - joints)
    new = joints + _damped_steps(arms.jacobian, left, rest, damping)
    outside = xp.any((new < lowest) | (new > highest), axis=-1)
    if not xp.any(outside):
        return new
    lowest = xp.minimum(lowest, joints + MAX_STEP)
    highest = xp.maximum(highest, joints - MAX_STEP)
    free = xp.ones_like(joints)
    for _ in range(2):
        inside = xp.minimum(xp.maximum(new, lowest), highest)
        out = (free * (new - inside) * (new - joints) > 0) & outside[:, None]
        free = xp.where(out, xp.zeros_like(free), free)
        rest = xp.where(out, inside - joints, rest)
        left = left - apply(arms.jacobian, xp.where(out, rest, xp.zeros_like(rest)))
        again = joints + _damped_steps(arms.jacobian * free[:, None], left, rest, damping)
        new = xp.where(xp.any(out, axis=-1)[:, None], again, new)
    inside = xp.minimum(xp.maximum(new, lowest), highest)
    return xp.where(outside[:, None], inside, new)


def _damped_steps(
    jacobian: Float[Array, "n 6 7"],
    error: Float[Array, "n 6"],
    rest: Float[Array, "n 7"],
    damping: Float[Array, "n"],
) -> Float[Array, "n 7"]:
    xp = namespace(error)
    turned = xp.matrix_transpose(jacobian)
    square = jacobian @ turned + damping[:, None, None] * like(np.eye(6), error)
    solved = xp.linalg.solve(square, (error - apply(jacobian, rest))[..., None])
    step = rest + (turned @ solved)[..., 0]
    largest = xp.max(xp.abs(step), axis=-1)[:, None]
    return step * xp.clip(MAX_STEP / xp.clip(largest, min=1e-9), max=1.0)


def _cross(a: Float[Array, "n 3 7"], b: Float[Array, "n 3 7"]) -> Float[Array, "n 3 7"]:
    xp = namespace(a)
    (x, y, z), (u, v, w) = ((m[:, 0], m[:, 1], m[:, 2]) for m in (a, b))
    return xp.stack([y * w - z * v, z * u - x * w, x * v - y * u], axis=1)
