"""The flat states of n worlds; see ``observations.modes`` for their entries."""

from __future__ import annotations

import math

from array_api_compat import device
from jaxtyping import Bool, Float, Int

from ...observations.bounds import BOUNDS
from ...rendering.views import SLOTS
from ...robot.panda import HOME_CTRL
from .arrays import Array, apply, like, namespace, squares, take_rows
from .goal_rows import GoalRows, regions, targets
from .readings import Readings


def slot_orders(
    rows: GoalRows, seen: Readings, active: Int[Array, "n"], present: Bool[Array, "n k"]
) -> Int[Array, "n slots"]:
    """Return the indices of the objects in the slots of each world, with -1 for empty slots.

    The order is target, the goal's object, then the nearest objects; only objects that are
    ``present`` have slots.
    """
    xp = namespace(seen.positions)
    count = present.shape[1]
    target, reference = (take_rows(v, active[:, None]) for v in (rows.target, rows.reference))
    center = take_rows(regions(rows, seen)[0], active[:, None])
    middle = xp.where((target >= 0)[..., None], take_rows(targets(rows, seen), active[:, None]),
                      center)  # fmt: skip
    far = xp.sqrt(squares(seen.positions - middle))
    number = xp.arange(count, device=device(far))[None]
    far = xp.where(present, far, xp.full_like(far, math.inf))
    far = xp.where(number == reference, xp.full_like(far, -1.0), far)
    far = xp.where(number == target, xp.full_like(far, -2.0), far)
    order = xp.argsort(far, axis=-1, stable=True)[:, :SLOTS]
    order = xp.where(take_rows(far, order) < math.inf, order, xp.full_like(order, -1))
    empty = xp.full((order.shape[0], SLOTS - order.shape[1]), -1, dtype=order.dtype,
                    device=device(far))  # fmt: skip
    return xp.concat([order, empty], axis=-1)


def flat_states(
    rows: GoalRows,
    seen: Readings,
    active: Int[Array, "n"],
    order: Int[Array, "n slots"],
    half_extents: Float[Array, "n k 3"],
    bare: bool = False,
) -> Float[Array, "n entries"]:
    """Return the flat state observations as ``float32``, without grasp hints or noise.

    ``half_extents`` are those of the objects, metres; ``bare`` limits the result to entries 0-267.
    """
    xp = namespace(seen.positions)
    bounds = like(BOUNDS[False, bare], seen.tool)
    now = active[:, None]
    slots = _slots(seen, order, half_extents)
    tooled = take_rows(rows.target, now) < 0
    at = xp.where(tooled, seen.tool, slots[:, 0, :3])
    fingers = xp.astype(take_rows(seen.touched, now)[:, 0, :2], at.dtype)
    parts = [
        seen.joints,
        seen.joint_velocities,
        seen.opening[:, None],
        seen.tool,
        seen.hand[:, :, 0],
        seen.hand[:, :, 1],
        seen.servos - seen.joints,
        2 * seen.gripper[:, None] / HOME_CTRL[7] - 1,
        fingers,
        at - seen.tool,
        rows.table,
        xp.reshape(slots, (slots.shape[0], -1)),
    ]
    if not bare:
        center, yaw = (take_rows(v, now)[:, 0] for v in regions(rows, seen))
        semi = take_rows(rows.semi, now)[:, 0]
        carried = xp.astype(take_rows(rows.reference, now) >= 0, at.dtype)
        parts += [carried, center, semi[:, :2], yaw[:, None], semi[:, 2:], center - at]
    entries = xp.concat(parts, axis=-1)
    return xp.astype(xp.clip(entries, -bounds, bounds), xp.float32)


def _slots(seen: Readings, order: Array, half_extents: Array) -> Float[Array, "n slots 19"]:
    xp = namespace(seen.positions)
    turned = take_rows(seen.rotations, order)
    mask = xp.astype(order >= 0, turned.dtype)[..., None]
    entries = [
        take_rows(seen.positions, order),
        turned[..., 0],
        turned[..., 1],
        take_rows(half_extents, order),
        take_rows(seen.linear, order),
        apply(turned, take_rows(seen.angular, order)),
        mask,
    ]
    return xp.concat(entries, axis=-1) * mask
