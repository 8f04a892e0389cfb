"""Estimation of state and height maps from pictures.

A real robot has no access to the simulator's flat state and height maps (``observations``). This
module estimates them from one observation of "pixels+proprio" with depth, calibrations and a mask
of the target: depth becomes points in the base frame, the points under the masks are the target,
and other points near it are obstacles. The estimated state holds

- the robot's proprioceptive entries, and its touch: both fingers touch the target if they were
  commanded to close, are at rest, and did not close completely,
- the target's slot: the bounding box of its points along the axes of the base frame, with zero
  velocities,
- the table's height: the height with the most points,
- the goal region: the lifted position of the target (Lift), or, if no target is visible, the centre
  of the green marker ball (Reach), with zero semi-axes if the marker is hidden as well.

All other entries are 0. Maps 0 and 1 are built from the points in the same frame. They do not
contain surfaces that no camera sees, or points above the hand, which may belong to the arm.
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
_FEWEST, _LEAST_GREEN = 6, 3  # minimum number of points of a visible object, and of the marker
_BINS, _BIN, _LOWEST = 100, 0.01, -0.5  # range of heights searched for the table's, metres
_NEAR = 1.2  # points count within this distance from the base's axis, metres
_STRIDE = 7  # stride of the points used for the table's height
_SEAM = 0.004  # points up to this height above the table may belong to it, metres
_SUNK = 0.02  # an object visible down to this height above the table stands on it, metres
_THINNEST = 0.003  # minimum half extent, metres
_HAND = ((-0.05, -0.13, -0.30), (0.05, 0.13, 0.02))  # the hand's box in its own frame, metres
_ABOVE = 0.10  # points this far above the tool may belong to the arm, metres
_CLOSING, _GRIPPED, _RESTING = -0.2, 0.003, 0.01  # fingers: command, opening, speed (m, m/s)
_WITHIN = 0.04  # maximum distance from the target's box to the tool in a grasp, metres
_RAISED = (ASTRAY, ASTRAY, (RAISED[1] - RAISED[0]) / 2)  # semi-axes of Lift's region, metres
_RISE = sum(RAISED) / 2  # from the target's initial position to the region's centre, metres
_REACHED = (REACHED, REACHED, REACHED)  # semi-axes of Reach's region, metres
_BALL = Reach.marker_radius
_SEEDS, _FITS = 12, 6  # number of seed points for the ball, and of steps per fit
_NEAR_BALL = 0.003  # distance from the ball's surface within which points belong to it, metres
# marker colour: minimum green; maximum shares of red and blue
_GREEN, _RED_SHARE, _BLUE_SHARE = 60.0, 0.40, 0.60


def cameras_of(names: Iterable[str]) -> tuple[str, ...]:
    """Return the cameras whose depth, target mask and calibration are among ``names``."""
    known = set(names)
    cameras = sorted(n.removesuffix("_calibration") for n in known if n.endswith("_calibration"))
    return tuple(c for c in cameras if {f"{c}_depth", f"{c}_target"} <= known)


def perceive(
    seen: Mapping[str, Num[Tensor, "n ..."]],
) -> tuple[Float[Tensor, "n s"], Float[Tensor, "n 3 48 48"], Float[Tensor, "n"]]:
    """Estimate the flat states and height maps of a batch of observations.

    The third array holds the number of marker points, 0 if the marker is absent or hidden.
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
    """Replace poorly visible markers with better earlier sightings; return states and sightings.

    Near the end of a reach the hand hides the marker, and the visible rest is a poor estimate of
    its position. ``shown`` is the number of marker points in the current observation. ``kept`` is
    the largest number of points so far and the marker's position then, base frame, metres.
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
    """Return a camera's points, and masks of the points on the target and of green points."""
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
    """Return which pixels have the marker's colour; channels are on the first or the last axis."""
    last = picture if picture.shape[-1] == 3 else picture.movedim(0, -1)
    red, green, blue = last.reshape(-1, 3).unbind(1)
    return (green > _GREEN) & (red < _RED_SHARE * green) & (blue < _BLUE_SHARE * green)


def find_ball(points: Float[Tensor, "m 3"]) -> tuple[Float[Tensor, "3"], int]:
    """Fit the marker ball to points; return its centre and the number of points near its surface.

    The number is 0 if no ball fits. The ball has the marker's radius; other objects may share its
    colour. One ball is fitted around each of several seed points, and the fit with the most points
    near its surface is returned.
    """
    best, most = points.new_zeros(3), 0
    for seed in points[:: -(-len(points) // _SEEDS) or 1]:
        middle = _fit_ball(points[(points - seed).norm(dim=1) < 2 * _BALL])
        near = int((((points - middle).norm(dim=1) - _BALL).abs() < _NEAR_BALL).sum())
        if near >= _LEAST_GREEN and near > most:
            best, most = middle, near
    return best, most


def _fit_ball(points: Float[Tensor, "m 3"]) -> Float[Tensor, "3"]:
    """Fit a ball's centre to points on its upper side, by Gauss-Newton steps.

    They start below the mean of the points.
    """
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
    """Return which points are above the table and within a height map around ``middle``."""
    x, y, z = points.unbind(1)
    far = CELL * CELLS / 2
    return (z > table + _SEAM) & ((x - middle[0]).abs() < far) & ((y - middle[1]).abs() < far)


def is_robot(points: Float[Tensor, "m 3"], felt: Float[Tensor, "p"]) -> Bool[Tensor, "m"]:
    """Return which points may be the robot's: those in the hand's box or well above the tool."""
    x, y = felt[18:21], felt[21:24]
    axes = torch.stack([x, y, torch.linalg.cross(x, y)], 1)
    own = (points - felt[15:18]) @ axes
    low, high = (points.new_tensor(bound) for bound in _HAND)
    return ((own > low) & (own < high)).all(1) | (points[:, 2] > felt[17] + _ABOVE)


def table_height(points: Float[Tensor, "m 3"]) -> Float[Tensor, ""]:
    """Return the height (m) of the table, at which most points lie, or 0 if there are no points."""
    places = ((points[:, 2] - _LOWEST) / _BIN).floor()
    points = points[(places >= 0) & (places < _BINS)]
    if len(points) == 0:
        return points.new_zeros(())
    places = ((points[:, 2] - _LOWEST) / _BIN).long()
    counts = torch.bincount(places, minlength=_BINS)
    counts = counts + torch.cat([counts[1:], counts[:1]])  # a table top may straddle two bins
    best = counts.argmax()
    return points[(places == best) | (places == best + 1), 2].median()


def box_of(
    points: Float[Tensor, "m 3"], table: Float[Tensor, ""]
) -> tuple[Float[Tensor, "3"], Float[Tensor, "3"]]:
    """Return an object's bounding box along the base's axes: centre and half extents, in metres."""
    low, high = points.quantile(0.01, 0), points.quantile(0.99, 0)
    if low[2] < table + _SUNK:
        low[2] = table
    return (low + high) / 2, ((high - low) / 2).clamp(min=_THINNEST)


def height_grid(
    points: Float[Tensor, "m 3"], middle: Float[Tensor, "3"], table: Float[Tensor, ""]
) -> Float[Tensor, "48 48"]:
    """Return the maximum height above the table in each cell, in units of ``STEP``."""
    cells = ((points[:, :2] - middle[:2]) / CELL + CELLS / 2).floor().long()
    inside = ((cells >= 0) & (cells < CELLS)).all(1)
    cells, heights = cells[inside], ((points[inside, 2] - table) / STEP).round().clamp(0, 255)
    grid = points.new_zeros(CELLS * CELLS)
    grid.scatter_reduce_(0, cells[:, 0] * CELLS + cells[:, 1], heights, "amax")
    return grid.view(CELLS, CELLS)


def _close(grid: Float[Tensor, "48 48"]) -> Float[Tensor, "48 48"]:
    """Return a height map in which holes of up to two cells are filled."""
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
    """Write the target's slot, its offset from the tool, and whether it is held."""
    slot = state[_SLOT : _SLOT + len(SLOT_BOUNDS)]
    slot[:3], slot[9:12] = middle, half
    slot[3] = slot[7] = slot[18] = 1.0
    state[34:37] = middle - felt[15:18]
    gap = ((felt[15:18] - middle).abs() - half).clamp(min=0).norm()
    closing, still = felt[31] < _CLOSING, felt[SHARED].abs() < _RESTING
    if closing and still and felt[14] > _GRIPPED and gap < _WITHIN:
        state[32:34] = 1.0
