"""Features of the state and height maps, with a grasp chosen by a network head.

The observation has no grasp hint, so ``GraspHead`` finds a grasp in the maps. Eight features,
called the *way*, are computed geometrically from the grasp and the state; they replace the entries
of the grasp hint (``observations.grasp_hint``):

=====  =======================================================================================
0-2    desired minus current position of the tool, base frame, m
3      remaining turn of the hand, rad
4      desired opening of the fingers, m
5      expected or current width between the fingers, m
6      how much the tool has to rise to clear objects on its way, m
7      1 on the way to a grasp, -1 with the target in both fingers, 0 with it released in its goal
=====  =======================================================================================

With the target in the fingers, the way leads to the middle of the goal region, at a height that
clears whatever lies there under the target's outline (map 2 under map 0). The hand turns only as
far as the last joint's range requires. If the region is in the air (Lift), the way leads straight
up. All features depend only on a single observation.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import torch
from gymnasium import spaces
from jaxtyping import Bool, Float, Real
from stable_baselines3.common.torch_layers import BaseFeaturesExtractor
from torch import Tensor

from generator.errors import InputError

from ...expert.arm import MIDDLE, ROLL_RANGE
from ...expert.driver import NEAR
from ...expert.path import CLEAR, ROOM
from ...expert.planning.grasps import TIP
from ...expert.planning.placement import FINGER_HALF, PAD, PALM, PALM_Z, RELEASE, SHAFT, SHAFT_Z
from ...observations.bounds import GOAL_BOUNDS, ROBOT_BOUNDS, SLOT_BOUNDS
from ...observations.grasp_hint import HINT_BOUNDS
from ...observations.height_map import CELL, CELLS, STEP, height_map_space
from ...parallel.core.arrays import wrap
from ...rendering.views import SLOTS
from .grasp_head import GraspHead
from .network import TableExtractor

_ROBOT, _SLOT = len(ROBOT_BOUNDS), len(SLOT_BOUNDS)
_FLAT = _ROBOT + SLOTS * _SLOT + len(GOAL_BOUNDS)
_REGION = slice(_FLAT - len(GOAL_BOUNDS) + 1, _FLAT)  # centre, semi-axes x and y, yaw, z, way
# metres: extra opening to release; largest opening; maximum of entry 6
_WIDER, _WIDEST, _HIGHEST = 0.024, 0.08, 0.3
_IN_AIR = 0.03  # a region higher than this above the surface below it counts as in the air, metres


class LookExtractor(BaseFeaturesExtractor):
    """A feature extractor that takes the state and height maps and computes its own grasp hint.

    The head is trained only by ``demonstrations.grasp_lessons``, not through the features.

    Raises:
        InputError: the observation has other parts.
    """

    def __init__(self, observation_space: spaces.Dict, width: int = 64) -> None:
        parts = getattr(observation_space, "spaces", {})
        shapes = {name: part.shape for name, part in parts.items()}
        if shapes != {"state": (_FLAT,), "height_map": height_map_space().shape}:
            raise InputError(
                "LookExtractor requires the flat state and the height maps, got "
                f"{observation_space}. Create the environment with geometry='height_map' and "
                "without a grasp hint."
            )
        table = TableExtractor(
            spaces.Box(-np.inf, np.inf, (_FLAT + len(HINT_BOUNDS),), np.float32), width
        )
        super().__init__(observation_space, table.features_dim)
        self.table, self.head = table, GraspHead().requires_grad_(False)
        self._last: tuple[bytes, Tensor] | None = None

    def forward(self, observations: dict[str, Any]) -> Float[Tensor, "n f"]:
        """Compute the features of a batch of observations."""
        state, maps = observations["state"], observations["height_map"]
        return self.features(state, ways(state, maps, self.plans(state, maps)))

    def features(
        self, state: Float[Tensor, "n o"], way: Float[Tensor, "n 8"]
    ) -> Float[Tensor, "n f"]:
        """Compute the features from states and the way features (see the module docstring)."""
        return self.table(torch.cat([state, way], 1))

    def plans(
        self, state: Float[Tensor, "n o"], maps: Real[Tensor, "n 3 48 48"]
    ) -> Float[Tensor, "n 6"]:
        """Return the grasp of each target (``grasp_head.PLAN``), or zeros if no grasp is needed.

        The grasp of a single observation is cached while the head's inputs do not change.
        """
        plans = state.new_zeros(len(state), 6)
        rows = torch.nonzero(~(is_held(state) | at_goal(state))).flatten()
        if len(rows) == 0:
            return plans
        stands = base_from_target(state[rows])
        if len(state) > 1:
            plans[rows] = self.head.plan(maps[rows], stands)
            return plans
        key = (
            maps[:, :2].to(torch.uint8).numpy().tobytes()
            + (1000 * stands).round().numpy().tobytes()
        )
        if self._last is None or self._last[0] != key:
            self._last = key, self.head.plan(maps, (1000 * stands).round() / 1000)
        return self._last[1].clone()

    def _apply(self, fn: Any, recurse: bool = True) -> Any:
        self._last = None
        return super()._apply(fn, recurse)


def is_held(state: Float[Tensor, "n o"]) -> Bool[Tensor, "n"]:
    """Return whether both fingers touch the target."""
    return (state[:, 32] > 0.5) & (state[:, 33] > 0.5)


def at_goal(state: Float[Tensor, "n o"]) -> Bool[Tensor, "n"]:
    """Return whether the target is in the goal region and not held by both fingers."""
    _, _, _, a, b, yaw, high, x, y, z = state[:, _REGION].unbind(1)
    c, s = yaw.cos(), yaw.sin()
    across = ((c * x + s * y) / a) ** 2 + ((c * y - s * x) / b) ** 2
    return (across <= 1) & (z.abs() <= high) & ~is_held(state)


def heading_of(state: Float[Tensor, "n o"]) -> Float[Tensor, "n"]:
    """Return the bearing of the x axis of the target's box in the base frame, in radians."""
    return torch.atan2(state[:, _ROBOT + 4], state[:, _ROBOT + 3])


def lowest_of(state: Float[Tensor, "n o"]) -> Float[Tensor, "n"]:
    """Return the height of the lowest corner of the target's box in the base frame, in metres."""
    return state[:, _ROBOT + 2] - _reach(state[:, _ROBOT : _ROBOT + _SLOT])[:, 2]


def base_from_target(state: Float[Tensor, "n o"]) -> Float[Tensor, "n 4"]:
    """Return the grasp head's inputs other than the maps; see ``grasp_head.STANDS``."""
    x, y = _turn(-state[:, _ROBOT], -state[:, _ROBOT + 1], -heading_of(state))
    table = state[:, 37]
    return torch.stack([x, y, lowest_of(state) - table, table], 1)


def release_height(
    state: Float[Tensor, "n o"], maps: Real[Tensor, "n 3 48 48"]
) -> tuple[Float[Tensor, "n"], Float[Tensor, "n"]]:
    """Return the tool's height for releasing the unrotated target at the centre of its goal.

    The second array is the height of the surface there under the target. Both are in the base
    frame, in metres. The target is assumed to be as wide as its box, and the open hand as wide as
    in ``expert.planning.placement``; both are enlarged by one cell on all sides.
    """
    heights = maps[:, 2].float() * STEP + state[:, 37, None, None]
    heading, low = heading_of(state), lowest_of(state)
    dx, dy = _turn(state[:, 15] - state[:, _ROBOT], state[:, 16] - state[:, _ROBOT + 1], -heading)
    axis = (torch.arange(CELLS) - (CELLS - 1) / 2) * CELL
    x, y = axis[None, :, None], axis[None, None, :]
    opening = torch.atan2(state[:, 19], state[:, 18]) - math.pi / 2 - heading
    u, v = (
        each.abs()
        for each in _turn(x - dx[:, None, None], y - dy[:, None, None], -opening[:, None, None])
    )
    bx, by = _turn_box(state, heading)
    own = (x.abs() <= bx[:, None, None] + CELL) & (y.abs() <= by[:, None, None] + CELL)
    inner = ((state[:, 14] + _WIDER).clamp(max=_WIDEST) / 2)[:, None, None]
    finger = (v <= FINGER_HALF + CELL) & (u >= inner - CELL)
    pad, shaft = finger & (u <= inner + PAD + CELL), finger & (u <= inner + SHAFT + CELL)
    palm = (u <= PALM[0] + CELL) & (v <= PALM[1] + CELL)
    hanging = (state[:, 17] - low).clamp(min=TIP)
    under = torch.where(own, heights, state[:, 37, None, None]).amax((1, 2))
    best = under + hanging
    for mask, rise in ((pad, TIP), (shaft, TIP - SHAFT_Z), (palm, TIP - PALM_Z)):
        best = torch.maximum(best, torch.where(mask, heights, -1.0).amax((1, 2)) + rise)
    return best + RELEASE, under


def ways(
    state: Float[Tensor, "n o"], maps: Real[Tensor, "n 3 48 48"], plan: Float[Tensor, "n 6"]
) -> Float[Tensor, "n 8"]:
    """Compute the way features (see the module docstring) for each grasp (``grasp_head.PLAN``)."""
    tool, low = state[:, 15:18], lowest_of(state)
    holding, put = is_held(state), at_goal(state)
    x, y = _turn(plan[:, 0], plan[:, 1], heading_of(state))
    grasp = torch.stack([x + state[:, _ROBOT], y + state[:, _ROBOT + 1], low + plan[:, 2]], 1)
    region = state[:, _REGION]
    hanging = (tool[:, 2] - low).clamp(min=TIP)
    bottom = region[:, 2] - region[:, 6] - (state[:, _ROBOT + 2] - low)
    high = under = state[:, 37]
    if holding.any():
        high, under = release_height(state, maps)
    in_air = bottom > under + _IN_AIR
    keep = torch.where(in_air, 0.0, _least_turn(state, tool[:, :2] + region[:, 7:9]))
    from_tool = state[:, _ROBOT : _ROBOT + 2] - tool[:, :2]
    turned = torch.stack(_turn(from_tool[:, 0], from_tool[:, 1], keep), 1)
    down = torch.cat([state[:, _ROBOT : _ROBOT + 2] + region[:, 7:9] - turned, high[:, None]], 1)
    up = torch.cat([tool[:, :2], tool[:, 2:] + region[:, 9:]], 1)
    place = torch.where(in_air[:, None], up, down)
    end = torch.where(holding[:, None], place, grasp)
    broad = from_tool.norm(dim=1) + _reach(state[:, _ROBOT : _ROBOT + _SLOT])[:, :2].amax(1)
    depth = torch.where(holding, hanging, TIP)
    rise = _rise(state, end, depth, torch.where(holding, broad, 0.0).clamp(min=ROOM))
    turn = torch.where(holding, keep, _turn_left(state, plan[:, 3], grasp))
    gap = state[:, 14]
    opening = torch.where(holding, (gap + _WIDER).clamp(max=_WIDEST), plan[:, 4])
    width = torch.where(holding, gap, plan[:, 5])
    kind = torch.where(holding, -1.0, 1.0)
    way = torch.cat([end - tool, torch.stack([turn, opening, width, rise, kind], 1)], 1)
    return torch.where(put[:, None], 0.0, way)


def _turn_left(
    state: Float[Tensor, "n o"], angle: Float[Tensor, "n"], at: Float[Tensor, "n 3"]
) -> Float[Tensor, "n"]:
    """Return the remaining turn of the last joint for a grasp; see ``expert.arm.turn_left``."""
    wanted = heading_of(state) + angle + math.pi / 2 - torch.atan2(at[:, 1], at[:, 0])
    return MIDDLE + wrap(wanted - MIDDLE) - _roll(state)


def _least_turn(state: Float[Tensor, "n o"], at: Float[Tensor, "n 2"]) -> Float[Tensor, "n"]:
    """Return the minimum turn of the hand with the target in it; see ``expert.arm.least_turn``."""
    turned = torch.atan2(state[:, 16], state[:, 15]) - torch.atan2(at[:, 1], at[:, 0])
    asked = _roll(state) + wrap(turned)
    return asked.clamp(MIDDLE - ROLL_RANGE, MIDDLE + ROLL_RANGE) - asked


def _roll(state: Float[Tensor, "n o"]) -> Float[Tensor, "n"]:
    """Return the hand's yaw relative to the tool's bearing, within the last joint's range."""
    relative = torch.atan2(state[:, 19], state[:, 18]) - torch.atan2(state[:, 16], state[:, 15])
    by_joint = MIDDLE - state[:, 6]
    return by_joint + wrap(relative - by_joint)


def _rise(
    state: Float[Tensor, "n o"],
    end: Float[Tensor, "n 3"],
    depth: Float[Tensor, "n"],
    broad: Float[Tensor, "n"],
) -> Float[Tensor, "n"]:
    """Return entry 6 of the way features: how far to raise the tool to clear objects near the path.

    Objects within ``broad`` of the path count.
    """
    tool, slots = state[:, 15:18], state[:, _ROBOT : _ROBOT + SLOTS * _SLOT]
    others = slots.reshape(-1, SLOTS, _SLOT)[:, 1:]
    way = (end - tool)[:, None, :2]
    away = others[..., :2] - tool[:, None, :2]
    length = way.square().sum(2).clamp(min=1e-9)
    along = ((away * way).sum(2) / length).clamp(0.0, 1.0)
    aside = (along[..., None] * way - away).norm(dim=2)
    reach = _reach(others)
    near = (aside < broad[:, None] + reach[..., :2].amax(2)) & (others[..., -1] > 0.5)
    tops = torch.where(near, others[..., 2] + reach[..., 2], -torch.inf).amax(1)
    high = torch.maximum(tops, state[:, 37]) + CLEAR + depth
    rise = (high - tool[:, 2]).clamp(0.0, _HIGHEST)
    return torch.where(length[:, 0].sqrt() <= NEAR, 0.0, rise)


def _reach(slots: Float[Tensor, "*n s"]) -> Float[Tensor, "*n 3"]:
    """Return the half extents of boxes along the base frame's axes, in metres."""
    x, y = slots[..., 3:6], slots[..., 6:9]
    axes = torch.stack([x, y, torch.linalg.cross(x, y)], -1)
    return (axes.abs() * slots[..., None, 9:12]).sum(-1)


def _turn_box(
    state: Float[Tensor, "n o"], heading: Float[Tensor, "n"]
) -> tuple[Float[Tensor, "n"], Float[Tensor, "n"]]:
    """Return the half extents of the target's box along and across ``heading``, in metres."""
    slot, bounds = state[:, _ROBOT : _ROBOT + _SLOT], []
    half = slot[:, 9:12]
    x, y = slot[:, 3:6], slot[:, 6:9]
    axes = torch.stack([x, y, torch.linalg.cross(x, y)], -1)
    c, s = heading.cos()[:, None], heading.sin()[:, None]
    for one, other, sign in ((0, 1, 1.0), (1, 0, -1.0)):
        bounds.append(((c * axes[:, one] + sign * s * axes[:, other]).abs() * half).sum(1))
    return bounds[0], bounds[1]


def _turn(
    x: Float[Tensor, "..."], y: Float[Tensor, "..."], angle: Float[Tensor, "..."]
) -> tuple[Float[Tensor, "..."], Float[Tensor, "..."]]:
    c, s = angle.cos(), angle.sin()
    return c * x - s * y, s * x + c * y
