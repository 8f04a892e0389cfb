"""Under which turns about the vertical an object looks as before, told from its mesh."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float
from scipy.spatial import KDTree

from ..geometry import rotation_z, wrap
from ..scene import Mesh

STEPS = 72
"""Turns tried: every 5 degrees."""

_POINTS, _MOST_POINTS = 600, 60_000
_SHARE, _LEAST = 0.03, 1e-3  # how far a surface may miss itself: of its radius, and metres
_MOST = 0.985  # share of the surface that must come as near as that


@dataclass(frozen=True, eq=False)
class Symmetry:
    """``same[k]`` says whether a turn by ``k`` steps of 5 degrees leaves the shape as it is."""

    same: Bool[np.ndarray, "72"]

    @property
    def round(self) -> bool:
        """Whether every turn does."""
        return bool(self.same.all())

    @property
    def order(self) -> int:
        """How many turns do: 1 for a shape with a front, 2 for a book, 4 for a cube; 72 is round.

        Neighbouring turns that both do count once, as shapes are the same to a tolerance.
        """
        if self.round:
            return STEPS
        return max(1, int((self.same & ~np.roll(self.same, 1)).sum()))

    def error(self, turn: float) -> float:
        """Return by how far ``turn`` (radians) misses the nearest one that changes nothing.

        In [0, pi]. Of neighbouring turns that all leave the shape as it is (to a tolerance), the
        middle one counts.
        """
        if self.round:
            return 0.0
        angles = self._middles()
        return min(abs(wrap(turn - angle)) for angle in angles)

    def _middles(self) -> list[float]:
        """Return the middle of each run of neighbouring turns, radians."""
        start = int(np.flatnonzero(~self.same)[0])
        turned = np.roll(self.same, -start)
        edges = np.flatnonzero(np.diff(np.concatenate([[False], turned, [False]]).astype(int)))
        runs = edges.reshape(-1, 2)
        step = 2 * np.pi / STEPS
        return [wrap((start + (a + b - 1) / 2) * step) for a, b in runs]


def symmetry(mesh: Mesh, scale: Float[np.ndarray, "3"], seed: int = 0) -> Symmetry:
    """Return the turns about the vertical through the box's middle that leave a mesh as it is.

    The surface counts as the same where all but a sixtieth of it comes within 3 % of the shape's
    radius (1 mm at least) of where it was. Colours and prints are not looked at.

    Args:
        mesh: canonical mesh.
        scale: its extent, metres.
        seed: of the points on the surface that are compared.
    """
    corners = (mesh.vertices.astype(float) * np.asarray(scale, float))[mesh.faces]
    rng = np.random.default_rng(seed)
    points = _sampled(corners, _POINTS, rng)
    near = max(_LEAST, _SHARE * float(np.linalg.norm(points[:, :2], axis=1).max()))
    spacing = near / 2
    dense = int(np.clip(_area(corners).sum() / spacing**2, _POINTS, _MOST_POINTS))
    surface = KDTree(_sampled(corners, dense, rng))
    same = np.ones(STEPS, bool)
    for k in range(1, STEPS // 2 + 1):  # a turn back is as good as a turn
        away = surface.query(points @ rotation_z(2 * np.pi * k / STEPS).T)[0]
        same[k] = same[-k] = float((away <= near + spacing).mean()) >= _MOST
    return Symmetry(same)


def _sampled(
    corners: Float[np.ndarray, "m 3 3"], count: int, rng: np.random.Generator
) -> Float[np.ndarray, "n 3"]:
    """Return points spread evenly over triangles."""
    area = _area(corners)
    face = rng.choice(len(corners), count, p=area / area.sum())
    u, v = rng.random((2, count, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    a, b, c = (corners[face, k] for k in range(3))
    return a + u * (b - a) + v * (c - a)


def _area(corners: Float[np.ndarray, "m 3 3"]) -> Float[np.ndarray, "m"]:
    sides = corners[:, 1:] - corners[:, :1]
    return np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
