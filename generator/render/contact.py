"""Resting heights of objects that are lowered vertically onto another object's mesh."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ..geometry import rotation_z
from ..scene import TABLE, Mesh, Model, Placement
from .scanlines import nearest

_CELLS = 96  # number of cells across the lowered object


@dataclass(frozen=True, eq=False)
class Body:
    """A canonical mesh with its scale (extent in metres), yaw (radians) and box centre (metres)."""

    mesh: Mesh
    scale: Float[np.ndarray, "3"]
    yaw: float
    position: Float[np.ndarray, "3"]

    @property
    def vertices(self) -> Float[np.ndarray, "n 3"]:
        """The vertices in the world frame, in metres."""
        return (self.mesh.vertices * self.scale) @ rotation_z(self.yaw).T + self.position

    @property
    def footprint(self) -> Float[np.ndarray, "2 2"]:
        """The minimum and maximum x and y in the world frame, in metres."""
        across = self.vertices[:, :2]
        return np.stack([across.min(0), across.max(0)])

    def at_height(self, z: float) -> Body:
        """Return the body with its box centre at height ``z`` in metres."""
        return dataclasses.replace(self, position=np.array([*self.position[:2], z]))


def height_field(
    body: Body, low: Float[np.ndarray, "2"], cell: float, shape: tuple[int, int], top: bool
) -> Float[np.ndarray, "rows columns"]:
    """Return heights of the body's upper (``top``) or lower surface on a grid, with NaN elsewhere.

    Cell (r, c) is the vertical column at x = low_x + (c + 1/2) cell, y = low_y + (r + 1/2) cell.
    """
    vertices = body.vertices
    sign = 1.0 if top else -1.0
    base = float((sign * vertices[:, 2]).min()) - 1.0
    corners = np.column_stack([(vertices[:, :2] - low) / cell, sign * vertices[:, 2] - base])
    owner, near = nearest(corners[body.mesh.faces], shape[1], shape[0])
    return np.where(owner >= 0, sign * (near + base), np.nan).reshape(shape)


def resting_height(body: Body, support: Body | None, table_height: float) -> float:
    """Return the height of the box centre at which ``body`` first touches its support.

    ``support`` is the object on or in which the body stands, or None if it is the table alone,
    whose top is at ``table_height`` metres. The body's current height is ignored. When lowered
    vertically, the body meets its support where the gap between its lower surface and the support's
    upper surface closes first: an apple on the inner wall of a bowl, not at the height of its rim.
    It never sinks into the tabletop.
    """
    lying = body.at_height(0.0)
    vertices = lying.vertices
    lowest = table_height - float(vertices[:, 2].min())
    if support is None:
        return lowest
    low, high = vertices[:, :2].min(0), vertices[:, :2].max(0)
    cell = float((high - low).max()) / _CELLS
    rows, columns = np.maximum(np.ceil((high - low)[::-1] / cell).astype(int), 1)
    under = height_field(lying, low, cell, (int(rows), int(columns)), top=False)
    over = height_field(support, low, cell, (int(rows), int(columns)), top=True)
    gap = over - under
    return max(lowest, float(np.nanmax(gap))) if np.isfinite(gap).any() else lowest


def at_rest(
    placements: Sequence[Placement], models: Mapping[str, Model], table_height: float
) -> tuple[Placement, ...]:
    """Lower each placement onto its support; return the placements in the same order."""
    bodies: dict[str, Body] = {}
    waiting = list(placements)
    known = {p.name for p in placements}
    while waiting:
        ready = [p for p in waiting if p.on not in known or p.on in bodies] or waiting[:1]
        for p in ready:
            body = Body(models[p.name].mesh, p.scale, p.yaw, p.translation)
            support = bodies.get(p.on) if p.on != TABLE else None
            bodies[p.name] = body.at_height(resting_height(body, support, table_height))
        waiting = [p for p in waiting if p.name not in bodies]
    return tuple(dataclasses.replace(p, translation=bodies[p.name].position) for p in placements)
