"""From pictures to what a policy that looks is told: an estimate of its state and height maps.

The flat state and the height maps of the simulator (``observations``) are what no robot has. Here
they are estimated from one observation of "pixels+proprio" with depth, calibrations and a mask of
the target: depth becomes points in the base frame, the points under the masks are the target, and
what else is seen near it is what a hand meets on its way. Of the state there are

- the robot's entries, as it feels them, and its touch: both fingers touch the target when they
  were told to close, rest, and did not meet,
- the target's slot: the box of its points with axes along the base frame's, its velocities 0,
- the table's height: that at which most points are,
- the goal region: where the target is to be raised to (Lift), or, if no target is seen, the middle
  of the ball in the marker's green (Reach); with semi-axes of 0 where that is hidden, too.

All other entries are 0. Maps 0 and 1 are of the points in the same frame; what the cameras do not
see is missing in them, what lies higher than the hand too, since it may be the arm.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import torch
from jaxtyping import Bool, Float, Num
from torch import Tensor
from torch.nn import functional

from ...goals.goal import ASTRAY, RAISED, REACHED
from ...observations.bounds import GOAL_BOUNDS, ROBOT_BOUNDS, SLOT_BOUNDS
from ...observations.height_map import CELL, CELLS, MAPS, STEP
from ...observations.proprioception import SHARED
from ...rendering.views import DEPTH_FAR, SLOTS
from ...tasks.reach import Reach

STATE = len(ROBOT_BOUNDS) + SLOTS * len(SLOT_BOUNDS) + len(GOAL_BOUNDS)
"""Entries of an estimated state."""

_SLOT, _GOAL = len(ROBOT_BOUNDS), STATE - len(GOAL_BOUNDS)
_FEWEST, _LEAST_GREEN = 6, 3  # points that a thing, and the marker, is taken to be seen by
_BINS, _BIN, _LOWEST = 100, 0.01, -0.5  # heights among which the table's is looked for, metres
_NEAR = 1.2  # metres from the base's axis within which points count
_STRIDE = 7  # of the points that the table's height is taken from
_SEAM = 0.004  # metres above the table up to which points may be the table's
_SUNK = 0.02  # metres above the table up to which what is seen of a thing begins at the table
_THINNEST = 0.003  # half an extent, metres
_HAND = ((-0.05, -0.13, -0.30), (0.05, 0.13, 0.02))  # the hand's box, its own frame, metres
_ABOVE = 0.10  # metres above the tool from which on points may be the arm's
_CLOSING, _GRIPPED, _RESTING = -0.2, 0.003, 0.01  # command, metres, metres a second
_WITHIN = 0.04  # metres from the target's box to the tool in a grasp
_RAISED = (ASTRAY, ASTRAY, (RAISED[1] - RAISED[0]) / 2)  # semi-axes of Lift's region, metres
_RISE = sum(RAISED) / 2  # from where the target stands to the region's middle, metres
_REACHED = (REACHED, REACHED, REACHED)  # semi-axes of Reach's region, metres
_BALL = Reach.marker_radius
_SEEDS, _FITS = 12, 6  # points around which the ball is looked for, and steps of a fit
_NEAR_BALL = 0.003  # metres from the ball's surface within which points are of it
_GREEN, _RED_SHARE, _BLUE_SHARE = 60.0, 0.40, 0.60  # the marker's: least green; others' most


def cameras_of(names: Iterable[str]) -> tuple[str, ...]:
    """Return the cameras that an observation has depth, mask and calibration of."""
    known = set(names)
    cameras = sorted(n.removesuffix("_calibration") for n in known if n.endswith("_calibration"))
    return tuple(c for c in cameras if {f"{c}_depth", f"{c}_target"} <= known)


def perceive(
    seen: Mapping[str, Num[Tensor, "n ..."]],
) -> tuple[Float[Tensor, "n s"], Float[Tensor, "n 3 48 48"], Float[Tensor, "n"]]:
    """Return estimates of the flat states and height maps of a batch of observations.

    The third are how many points are of the marker, 0 where none is shown or it is hidden.
    """
    cameras = cameras_of(seen)
    found = [
        _perceive_one({name: part[row].float() for name, part in seen.items()}, cameras)
        for row in range(len(seen["proprio"]))
    ]
    states, maps, shown = zip(*found, strict=True)
    return torch.stack(states), torch.stack(maps), torch.stack(shown)


def _perceive_one(
    seen: Mapping[str, Float[Tensor, "..."]], cameras: Iterable[str]
) -> tuple[Float[Tensor, "s"], Float[Tensor, "3 48 48"], Float[Tensor, ""]]:
    felt = seen["proprio"]
    clouds = [_cloud(seen, camera) for camera in cameras]
    points, marked, green = (torch.cat(parts) for parts in zip(*clouds, strict=True))
    target, table = points[marked], table_height(points[::_STRIDE])
    state, maps, shown = (
        felt.new_zeros(STATE),
        felt.new_zeros(MAPS, CELLS, CELLS),
        felt.new_zeros(()),
    )
    state[:SHARED] = felt[:SHARED]
    state[37] = table
    if len(target) >= _FEWEST:
        middle, half = box_of(target, table)
        _write_target(state, felt, middle, half)
        maps[0] = _close(height_grid(target, middle, table))
        rest = points[~marked & _is_around(points, middle, table)]
        maps[1] = height_grid(rest[~is_robot(rest, felt)], middle, table)
        region, semi = middle + middle.new_tensor([0, 0, _RISE]), _RAISED
        region[2] = table + half[2] + _RISE
        start = middle
    else:
        start, (ball, count) = felt[15:18], find_ball(points[green & ~marked])
        region, semi = (ball, _REACHED) if count else (start, (0.0, 0.0, 0.0))
        shown = shown + count
    goal = state[_GOAL:]
    goal[1:4], goal[8:11] = region, region - start
    goal[4], goal[5], goal[7] = semi
    return state, maps, shown


def recall_goal(
    state: Float[Tensor, "n s"], shown: Float[Tensor, "n"], kept: Float[Tensor, "n 4"]
) -> tuple[Float[Tensor, "n s"], Float[Tensor, "n 4"]]:
    """Return states with the marker where it was seen best, and what is kept of it.

    The hand hides the marker at last, and what peeps out tells little of where it is. ``shown`` is
    by how many points it is seen now; ``kept`` by how many it was seen best, and where it was then,
    base frame, metres.
    """
    filled, after = state.clone(), kept.clone()
    better = (shown > 0) & (shown >= kept[:, 0])
    after[better, 0], after[better, 1:] = shown[better], state[better, _GOAL + 1 : _GOAL + 4]
    again = ~better & (kept[:, 0] > 0)
    filled[again, _GOAL + 1 : _GOAL + 4] = kept[again, 1:]
    filled[again, _GOAL + 8 :] = kept[again, 1:] - state[again, 15:18]
    semi = state.new_tensor(_REACHED)
    filled[again, _GOAL + 4], filled[again, _GOAL + 5], filled[again, _GOAL + 7] = semi
    return filled, after


def _cloud(
    seen: Mapping[str, Float[Tensor, "..."]], camera: str
) -> tuple[Float[Tensor, "m 3"], Bool[Tensor, "m"], Bool[Tensor, "m"]]:
    """Return the points that a camera sees, which are the target's, and which are green."""
    depth, told = seen[f"{camera}_depth"], seen[f"{camera}_calibration"]
    pose, lens = told[:12].view(3, 4), told[12:].clamp(min=1e-3) * len(depth)
    rows = torch.arange(depth.shape[0], dtype=depth.dtype)[:, None]
    columns = torch.arange(depth.shape[1], dtype=depth.dtype)[None]
    across, down = (columns - lens[2]) / lens[0], (rows - lens[3]) / lens[1]
    there = torch.stack([across * depth, down * depth, depth], 0).view(3, -1)
    x, y, z = pose[:, :3] @ there + pose[:, 3:]
    counts = (depth.view(-1) < DEPTH_FAR - 0.1) & (x * x + y * y < _NEAR**2) & (z > _LOWEST)
    marked = seen[f"{camera}_target"].view(-1) > 0.5
    green = _is_green(seen[camera]) if camera in seen else torch.zeros_like(marked)
    kept = torch.nonzero(counts)[:, 0]
    return torch.stack([x[kept], y[kept], z[kept]], 1), marked[kept], green[kept]


def _is_green(picture: Float[Tensor, "h w c"]) -> Bool[Tensor, "m"]:
    """Return which pixels have the marker's colour; channels are the first axis or the last."""
    last = picture if picture.shape[-1] == 3 else picture.movedim(0, -1)
    red, green, blue = last.reshape(-1, 3).unbind(1)
    return (green > _GREEN) & (red < _RED_SHARE * green) & (blue < _BLUE_SHARE * green)


def find_ball(points: Float[Tensor, "m 3"]) -> tuple[Float[Tensor, "3"], int]:
    """Return the middle of the ball that points are of best, and how many are near its surface.

    That is 0 if they are of none. The ball has the marker's radius; other things may have its
    colour. It is fitted to what is around each of some points; the fit with the most points near
    its surface is taken.
    """
    best, most = points.new_zeros(3), 0
    for seed in points[:: -(-len(points) // _SEEDS) or 1]:
        middle = _fit_ball(points[(points - seed).norm(dim=1) < 2 * _BALL])
        near = int((((points - middle).norm(dim=1) - _BALL).abs() < _NEAR_BALL).sum())
        if near >= _LEAST_GREEN and near > most:
            best, most = middle, near
    return best, most


def _fit_ball(points: Float[Tensor, "m 3"]) -> Float[Tensor, "3"]:
    """Return the middle of a ball by Gauss-Newton steps from below the points, seen from above."""
    middle = points.mean(0) - points.new_tensor([0, 0, _BALL / 2])
    damping = 1e-3 * torch.eye(3, dtype=points.dtype)
    for _ in range(_FITS):
        out = points - middle
        away = out.norm(dim=1).clamp(min=1e-6)
        out = out / away[:, None]
        middle = middle + torch.linalg.solve(out.T @ out + damping, out.T @ (away - _BALL))
    return middle


def _is_around(
    points: Float[Tensor, "m 3"], middle: Float[Tensor, "3"], table: Float[Tensor, ""]
) -> Bool[Tensor, "m"]:
    """Return which points are of things on the table that a map may show."""
    x, y, z = points.unbind(1)
    far = CELL * CELLS / 2
    return (z > table + _SEAM) & ((x - middle[0]).abs() < far) & ((y - middle[1]).abs() < far)


def is_robot(points: Float[Tensor, "m 3"], felt: Float[Tensor, "p"]) -> Bool[Tensor, "m"]:
    """Return which points may be the robot's: those in the hand's box, and all above it."""
    x, y = felt[18:21], felt[21:24]
    axes = torch.stack([x, y, torch.linalg.cross(x, y)], 1)
    own = (points - felt[15:18]) @ axes
    low, high = (points.new_tensor(bound) for bound in _HAND)
    return ((own > low) & (own < high)).all(1) | (points[:, 2] > felt[17] + _ABOVE)


def table_height(points: Float[Tensor, "m 3"]) -> Float[Tensor, ""]:
    """Return the height at which most points are, 0 if there are none, metres."""
    places = ((points[:, 2] - _LOWEST) / _BIN).floor()
    points = points[(places >= 0) & (places < _BINS)]
    if len(points) == 0:
        return points.new_zeros(())
    places = ((points[:, 2] - _LOWEST) / _BIN).long()
    counts = torch.bincount(places, minlength=_BINS)
    counts = counts + torch.cat([counts[1:], counts[:1]])  # a top may lie across two
    best = counts.argmax()
    return points[(places == best) | (places == best + 1), 2].median()


def box_of(
    points: Float[Tensor, "m 3"], table: Float[Tensor, ""]
) -> tuple[Float[Tensor, "3"], Float[Tensor, "3"]]:
    """Return middle and half extents of a thing's box along the base frame's axes, metres."""
    low, high = points.quantile(0.01, 0), points.quantile(0.99, 0)
    if low[2] < table + _SUNK:
        low[2] = table
    return (low + high) / 2, ((high - low) / 2).clamp(min=_THINNEST)


def height_grid(
    points: Float[Tensor, "m 3"], middle: Float[Tensor, "3"], table: Float[Tensor, ""]
) -> Float[Tensor, "48 48"]:
    """Return the greatest heights of points above the table by cells around a middle, in steps."""
    cells = ((points[:, :2] - middle[:2]) / CELL + CELLS / 2).floor().long()
    inside = ((cells >= 0) & (cells < CELLS)).all(1)
    cells, heights = cells[inside], ((points[inside, 2] - table) / STEP).round().clamp(0, 255)
    grid = points.new_zeros(CELLS * CELLS)
    grid.scatter_reduce_(0, cells[:, 0] * CELLS + cells[:, 1], heights, "amax")
    return grid.view(CELLS, CELLS)


def _close(grid: Float[Tensor, "48 48"]) -> Float[Tensor, "48 48"]:
    """Return a map with its holes of up to two cells filled."""
    padded = functional.pad(grid[None, None], (2, 2, 2, 2))
    wide = functional.max_pool2d(padded, 5, 1, 2)
    closed = -functional.max_pool2d(-wide, 5, 1, 2)
    return torch.maximum(grid, closed[0, 0, 2:-2, 2:-2])


def _write_target(
    state: Float[Tensor, "s"],
    felt: Float[Tensor, "p"],
    middle: Float[Tensor, "3"],
    half: Float[Tensor, "3"],
) -> None:
    """Write the target's slot, the way to it, and whether it is held."""
    slot = state[_SLOT : _SLOT + len(SLOT_BOUNDS)]
    slot[:3], slot[9:12] = middle, half
    slot[3] = slot[7] = slot[18] = 1.0
    state[34:37] = middle - felt[15:18]
    gap = ((felt[15:18] - middle).abs() - half).clamp(min=0).norm()
    closing, still = felt[31] < _CLOSING, felt[SHARED].abs() < _RESTING
    if closing and still and felt[14] > _GRIPPED and gap < _WITHIN:
        state[32:34] = 1.0
