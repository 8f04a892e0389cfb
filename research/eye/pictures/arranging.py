"""Placement of objects on a table: apart, on top of, and inside each other, at rest."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass, field

import cv2
import numpy as np
from jaxtyping import Float, UInt8

from generator.geometry import inside_margin, rotation_z
from generator.layout.rest import surface
from generator.scene import Model
from tabletop_objects import CATEGORIES

from .supply import KEYS, Supply

_CELL = 0.004  # metres per cell of the occupancy map
_TRIES = 40
_TALL = 0.12  # metres: taller objects are often placed at the back


@dataclass(frozen=True, eq=False)
class Placed:
    """A model of the supply at rest. ``support`` 0 is the table, ``k`` the k-th placed object."""

    model: int
    size: Float[np.ndarray, "3"]
    yaw: float
    rotation: Float[np.ndarray, "3 3"]
    position: Float[np.ndarray, "3"]
    upright: bool = True
    support: int = 0

    def vertices(self, model: Model) -> Float[np.ndarray, "n 3"]:
        """Return the world vertices of ``model``, metres."""
        return (model.mesh.vertices * self.size) @ self.rotation.T + self.position


@dataclass(eq=False)
class _Ground:
    """The occupied part of a tabletop, as a raster."""

    outline: Float[np.ndarray, "k 2"]
    height: float
    cells: UInt8[np.ndarray, "h w"] = field(init=False)
    low: Float[np.ndarray, "2"] = field(init=False)

    def __post_init__(self) -> None:
        self.low = self.outline.min(0)
        span = np.ptp(self.outline, axis=0) / _CELL
        self.cells = np.zeros((int(span[1]) + 2, int(span[0]) + 2), np.uint8)

    def take(self, hull: Float[np.ndarray, "m 2"], gap: float) -> bool:
        """Occupy a convex footprint if it is free and on the table; return whether it was."""
        if (inside_margin(hull, self.outline) < 0.006).any():
            return False
        pixels = np.round((hull - self.low) / _CELL).astype(np.int32)
        x0, y0 = np.maximum(pixels.min(0) - 2, 0)
        x1, y1 = pixels.max(0) + 3
        part = self.cells[y0:y1, x0:x1]
        mask = np.zeros(part.shape, np.uint8)
        cv2.fillConvexPoly(mask, (pixels - [x0, y0]).astype(np.int32), 1)
        if gap > 0:
            mask = cv2.dilate(mask, np.ones((3, 3), np.uint8), iterations=int(gap / _CELL) + 1)
        if (part & mask).any():
            return False
        part |= mask
        return True


def arrange(
    rng: np.random.Generator,
    supply: Supply,
    outline: Float[np.ndarray, "k 2"],
    height: float,
    count: int,
    tidy: bool = False,
) -> list[Placed]:
    """Place up to ``count`` objects on a top with a convex outline (metres) at ``height``.

    ``tidy`` ones have about their real size, are apart, and mostly face the viewer. Tall objects
    are often placed at the back.
    """
    ground = _Ground(outline, height)
    choice = _candidates(rng, supply)
    front = tidy or rng.random() < 0.5
    tight = rng.random() < (0.1 if tidy else 0.35)
    center = outline.mean(0) + rng.uniform(-0.25, 0.25, 2) * np.ptp(outline, axis=0)
    spread = float(rng.uniform(0.08, 0.2)) if tight else 0.0
    grown = float(rng.uniform(0.9, 1.1 if tidy else 1.6))
    stacking = float(rng.choice([0.0, 0.25, 0.5, 0.8]))
    carriers = _carriers(rng, supply) if stacking >= 0.5 else []
    placed: list[Placed] = []
    for _ in range(count * 2):
        if len(placed) >= count:
            break
        index = carriers.pop() if carriers else int(rng.choice(choice))
        thing = _pose(rng, supply, index, front, grown)
        if placed and rng.random() < stacking:
            tried = (_stack(rng, supply, thing, placed, k) for k in _bases(rng, supply, placed))
            found = next((f for f in tried if f is not None), None)
        else:
            found = _lay(rng, supply, thing, ground, center, spread)
        if found is not None:
            placed.append(found)
    return placed


def _bases(rng: np.random.Generator, supply: Supply, placed: list[Placed]) -> list[int]:
    """Return some objects to put another on or in, those that hold or carry objects well first."""
    weights = []
    for thing in placed:
        flat = thing.size[2] < 0.35 * min(thing.size[0], thing.size[1])
        weights.append(4.0 if supply.models[thing.model].container else 2.0 if flat else 0.4)
    share = np.array(weights) / sum(weights)
    return rng.choice(len(placed), min(len(placed), 5), replace=False, p=share).tolist()


def _carriers(rng: np.random.Generator, supply: Supply) -> list[int]:
    """Return one or two boards, trays, books or vessels, to be placed first and then loaded."""
    wide = [
        k
        for k, model in enumerate(supply.models)
        if min(model.size[:2]) > 0.12 and (model.container or model.size[2] < 0.05)
    ]
    return rng.choice(wide, min(len(wide), int(rng.integers(1, 3))), replace=False).tolist()


def _candidates(rng: np.random.Generator, supply: Supply) -> list[int]:
    """Return the models for a scene: of one theme with a few others, or any."""
    every = range(len(supply.models))
    if rng.random() < 0.5:
        return list(every)
    themes = sorted({theme for key in KEYS for theme in CATEGORIES[key].themes})
    theme = themes[int(rng.integers(len(themes)))]
    chosen = [
        k for k in every if (c := supply.categories[k]) >= 0 and theme in CATEGORIES[KEYS[c]].themes
    ]
    strays = [int(k) for k in rng.integers(len(supply.models), size=3)]
    return chosen + strays if len(chosen) > 3 else list(every)


def _pose(
    rng: np.random.Generator, supply: Supply, index: int, front: bool, grown: float
) -> Placed:
    """Return an unplaced object with a random size and rotation; a few are tipped over."""
    model = supply.models[index]
    factor = rng.uniform(0.8, 1.25, 3) if rng.random() < 0.35 else rng.uniform(0.85, 1.2)
    size = model.size * factor * grown
    yaw = rng.normal(0, 0.45) if front and rng.random() < 0.8 else rng.uniform(-np.pi, np.pi)
    rotation = rotation_z(float(yaw))
    slender = size[2] > 0.5 * min(size[0], size[1])
    fallen = slender and rng.random() < 0.05
    if fallen:
        rotation = rotation @ _tip(int(rng.integers(4)))
    wrapped = float((yaw + np.pi) % (2 * np.pi) - np.pi)
    return Placed(index, size, wrapped, rotation, np.zeros(3), not fallen)


def _tip(side: int) -> Float[np.ndarray, "3 3"]:
    """Return the rotation of an object tipped over to one of four sides."""
    over = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    return rotation_z(side * np.pi / 2) @ over


def _lay(
    rng: np.random.Generator,
    supply: Supply,
    thing: Placed,
    ground: _Ground,
    center: Float[np.ndarray, "2"],
    spread: float,
) -> Placed | None:
    """Return the object at rest on a free part of the table, or None."""
    vertices = thing.vertices(supply.models[thing.model])
    across = cv2.convexHull(vertices[:, :2].astype(np.float32))[:, 0].astype(float)
    low, high = ground.outline.min(0), ground.outline.max(0)
    gap = float(rng.choice([0.0, 0.0, 0.01, 0.03]))
    behind = np.ptp(vertices[:, 2]) > _TALL and rng.random() < 0.5
    for attempt in range(_TRIES):
        wide = spread * (1 + attempt / 10)
        at = rng.uniform(low, high) if spread == 0 else rng.normal(center, wide)
        if behind:
            reach = np.ptp(vertices[:, 1]) / 2 + 0.01 + 0.02 * attempt
            at[1] = high[1] - rng.uniform(0.5, 1.0) * reach
        if ground.take(across + at, gap):
            position = np.array([*at, ground.height - vertices[:, 2].min()])
            return dataclasses.replace(thing, position=position)
    return None


def _stack(
    rng: np.random.Generator, supply: Supply, thing: Placed, placed: list[Placed], base: int
) -> Placed | None:
    """Return the object at rest on or in another one, or None if it would not be stable."""
    below = placed[base]
    lower = supply.models[below.model]
    if any(p.support == base + 1 for p in placed) and not lower.container:
        return None
    under = below.vertices(lower)
    own = thing.vertices(supply.models[thing.model])
    span, room = np.ptp(own, axis=0), np.ptp(under, axis=0)
    share = span[:2] / room[:2]
    if (share > (0.8 if lower.container else 1.05)).any():
        return None
    slack = np.maximum(room[:2] - span[:2], 0) / 2
    middle = (under.min(0) + under.max(0))[:2] / 2
    at = middle + rng.uniform(-0.5, 0.5, 2) * slack
    others = [p for p in placed if p.support == base + 1]
    corners = [under[lower.mesh.faces]]
    corners += [p.vertices(supply.models[p.model])[supply.models[p.model].mesh.faces]
                for p in others]  # fmt: skip
    own = own + np.array([*at, 0.0])
    grid = np.stack(np.meshgrid(*[(np.arange(9) + 0.5) / 9] * 2), -1).reshape(-1, 2)
    grid = grid * span[:2] + own.min(0)[:2]
    bottom = surface(own[supply.models[thing.model].mesh.faces], grid, upper=False)
    top = np.max([surface(c, grid, upper=True) for c in corners], axis=0)
    lift = _rest(bottom, top, grid)
    if lift is None:
        return None
    inside = own[:, 2].min() + lift < under[:, 2].max() - 0.15 * room[2]
    if inside and not lower.container:
        return None
    return dataclasses.replace(thing, position=np.array([*at, lift]), support=base + 1)


def _rest(
    bottom: Float[np.ndarray, "p"], top: Float[np.ndarray, "p"], grid: Float[np.ndarray, "p 2"]
) -> float | None:
    """Return how far to lift an object onto others, if it touches on all sides of its centre."""
    own = np.isfinite(bottom)
    both = own & np.isfinite(top)
    if both.sum() < 0.8 * own.sum() or both.sum() < 6:
        return None
    gap = (top - bottom)[both]
    lift = float(gap.max())
    touching = grid[both][gap > lift - 0.004]
    foot = grid[own][bottom[own] < bottom[own].min() + 0.004]
    if len(touching) < 0.3 * len(foot) or len(touching) < 3:
        return None
    middle = grid[own].mean(0)
    around = touching - middle
    balanced = (around.min(0) <= 1e-9).all() and (around.max(0) >= -1e-9).all()
    return lift + 0.0003 if balanced else None
