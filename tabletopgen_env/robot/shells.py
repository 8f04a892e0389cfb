"""The Panda's appearance: low-poly shells of revolution and swept tubes, defined by a few numbers.

Every shell is a closed triangle mesh in its body's frame, metres, with faces counter-clockwise seen
from outside. All shells together have less than 3,000 faces, a fortieth of the scanned covers,
because geometry dominates the drawing time on a CPU.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

import numpy as np
from jaxtyping import Float, Int

from .kinematics import HOME, forward, link_frames

WHITE, GREY, DARK, BLUE = "white", "grey", "dark", "blue"

COLORS: dict[str, tuple[float, float, float, float]] = {
    WHITE: (0.93, 0.94, 0.95, 1.0),
    GREY: (0.62, 0.64, 0.66, 1.0),
    DARK: (0.13, 0.14, 0.15, 1.0),
    BLUE: (0.10, 0.50, 0.78, 1.0),
}
"""RGBA of each finish."""


@dataclass(frozen=True, eq=False)
class RobotShell:
    """A coloured, closed, read-only mesh. ``color`` is a key of ``COLORS``."""

    color: str
    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]

    def __post_init__(self) -> None:
        self.vertices.setflags(write=False)
        self.faces.setflags(write=False)


def _rings(rings: Float[np.ndarray, "k s 3"], color: str) -> RobotShell:
    """Connect successive rings of points into a closed mesh, with a fan at each end."""
    k, s = rings.shape[:2]
    a = np.arange(s)
    b = (a + 1) % s
    sides = []
    for low in range(0, (k - 1) * s, s):
        sides.append(np.column_stack([low + a, low + b, low + s + b]))
        sides.append(np.column_stack([low + a, low + s + b, low + s + a]))
    low, high = k * s, k * s + 1
    bottom = np.column_stack([np.full(s, low), b, a])
    top = np.column_stack([np.full(s, high), (k - 1) * s + a, (k - 1) * s + b])
    vertices = np.vstack([rings.reshape(-1, 3), rings[0].mean(0), rings[-1].mean(0)])
    return RobotShell(color, vertices, np.concatenate([*sides, bottom, top]))


def tube(
    color: str,
    spine: list[tuple[float, float, float]],
    radii: list[float],
    rings: int = 5,
    sides: int = 12,
    cap: bool = False,
) -> RobotShell:
    """Sweep a circle along a smooth curve.

    ``spine`` holds the control points of a Bezier curve (m) and ``radii`` the radii at equal steps
    along it (m); ``cap`` rounds the end by a quarter circle.
    """
    t = np.linspace(0.0, 1.0, rings)
    points = np.repeat(np.array(spine, float)[None], rings, 0)
    while points.shape[1] > 1:  # de Casteljau
        points = points[:, :-1] * (1 - t)[:, None, None] + points[:, 1:] * t[:, None, None]
    centers = points[:, 0]
    radius = np.interp(t, np.linspace(0, 1, len(radii)), radii)
    tangents = np.gradient(centers, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    if cap:
        angles = np.deg2rad([35.0, 70.0])
        more = centers[-1] + radius[-1] * 0.8 * np.sin(angles)[:, None] * tangents[-1]
        centers = np.concatenate([centers, more])
        radius = np.append(radius, radius[-1] * np.cos(angles))
        tangents = np.concatenate([tangents, tangents[[-1, -1]]])
    return _rings(_circles(centers, tangents, radius, sides), color)


def _circles(
    centers: Float[np.ndarray, "k 3"],
    tangents: Float[np.ndarray, "k 3"],
    radius: Float[np.ndarray, "k"],
    sides: int,
) -> Float[np.ndarray, "k s 3"]:
    """Return circles about ``centers``, with their first axis transported without twist."""
    start = np.eye(3)[np.argmin(np.abs(tangents[0]))]
    angle = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    rings = []
    for center, tangent, r in zip(centers, tangents, radius, strict=True):
        start = start - tangent * (start @ tangent)
        start /= np.linalg.norm(start)
        other = np.cross(tangent, start)
        rings.append(center + r * (np.outer(np.cos(angle), start) + np.outer(np.sin(angle), other)))
    return np.array(rings)


def slab(
    color: str,
    center: tuple[float, float, float],
    half: tuple[float, float, float],
    taper: tuple[float, float] = (1.0, 1.0),
    round_off: float = 0.012,
    power: float = 4.0,
    sides: int = 12,
) -> RobotShell:
    """Return a box with a superelliptic outline and both ends bevelled by ``round_off`` metres.

    ``half`` are half extents; ``taper`` scales the outline at the bottom and at the top.
    """
    angle = np.linspace(0, 2 * np.pi, sides, endpoint=False) + np.pi / sides
    c, s = np.cos(angle), np.sin(angle)
    reach = (np.abs(c) ** power + np.abs(s) ** power) ** (-1 / power)
    outline = np.column_stack([c, s]) * reach[:, None] * np.array(half[:2])
    inner = 1 - round_off / min(half[:2])
    bevel = [(-1.0, inner), (-1 + round_off / half[2], 1.0), (1 - round_off / half[2], 1.0)]
    rings = []
    for height, shrink in [*bevel, (1.0, inner)]:
        scale = shrink * np.interp(height, [-1, 1], taper)
        z = np.full(sides, height * half[2])
        rings.append(np.column_stack([outline * scale, z]) + np.array(center))
    return _rings(np.array(rings), color)


@cache
def arm_shells() -> Mapping[str, tuple[RobotShell, ...]]:
    """Return the shells of every body of the robot, by body name; built once and read-only."""
    r, ring = 0.054, 0.0565
    shells = {
        "link0": (
            tube(WHITE, [(0, 0, 0.0), (0, 0, 0.14)], [0.088, 0.078, 0.066, 0.058, r], rings=3),
            slab(WHITE, (-0.075, 0, 0.042), (0.078, 0.085, 0.042), taper=(1.0, 0.72), power=5),
            slab(DARK, (-0.118, 0, 0.044), (0.034, 0.05, 0.026), round_off=0.006),
        ),
        "link1": (
            tube(DARK, [(0, 0, -0.193), (0, 0, -0.187)], [ring], rings=2),
            tube(WHITE, [(0, 0, -0.187), (0, 0, -0.08), (0, -0.02, -0.04), (0, -0.064, 0.0)], [r]),
            tube(WHITE, [(0, 0.0, 0), (0, -0.082, 0)], [r], rings=2, cap=True),
        ),
        "link2": (
            tube(DARK, [(0, 0, -0.003), (0, 0, 0.004)], [ring], rings=2),
            tube(WHITE, [(0, 0, 0.004), (0, 0, 0.082)], [r], rings=2, cap=True),
            tube(WHITE, [(0, 0, 0.064), (0, -0.04, 0.02), (0, -0.08, 0.0), (0, -0.19, 0)], [r]),
        ),
        "link3": (
            tube(DARK, [(0, 0, -0.123), (0, 0, -0.117)], [ring], rings=2),
            tube(
                WHITE,
                [(0, 0, -0.117), (0, 0, -0.05), (0.03, 0.03, -0.02), (0.0825, 0.058, 0)],
                [r, r, 0.05, 0.05],
            ),
            tube(DARK, [(0.0825, 0.002, 0), (0.0825, 0.078, 0)], [0.058, 0.06, 0.052], rings=3),
            tube(WHITE, [(0.0825, 0.07, 0), (0.0825, 0.084, 0)], [0.044, 0.04], rings=2, cap=True),
        ),
        "link4": (
            tube(DARK, [(0, 0, 0.002), (0, 0, 0.078)], [0.058, 0.06, 0.052], rings=3),
            tube(WHITE, [(0, 0, 0.07), (0, 0, 0.084)], [0.044, 0.04], rings=2, cap=True),
            tube(
                WHITE,
                [(0, 0, 0.055), (-0.05, 0.03, 0.03), (-0.0825, 0.05, 0), (-0.0825, 0.122, 0)],
                [0.05, 0.05, r, r],
            ),
        ),
        "link5": (
            tube(DARK, [(0, 0, -0.262), (0, 0, -0.256)], [ring], rings=2),
            tube(
                WHITE,
                [(0, 0, -0.256), (0, 0.0, -0.16), (0, 0.075, -0.12), (0, 0.078, 0.0)],
                [r, 0.056, 0.05, 0.043, 0.04],
                rings=6,
            ),
            tube(DARK, [(0, 0.05, 0), (0, 0.112, 0)], [0.052, 0.05, 0.046], rings=3),
            tube(WHITE, [(0, 0.108, 0), (0, 0.116, 0)], [0.036, 0.03], rings=2),
        ),
        "link6": (
            tube(DARK, [(0, 0, -0.048), (0, 0, 0.05)], [0.048], rings=2),
            tube(WHITE, [(0, 0, 0.046), (0, 0, 0.056)], [0.034, 0.03], rings=2),
            tube(
                WHITE,
                [(0.0, 0, -0.012), (0.04, 0, 0), (0.088, -0.005, 0)],
                [0.043, 0.043, 0.042],
                rings=3,
            ),
            tube(WHITE, [(0.088, 0.066, 0), (0.088, -0.05, 0)], [0.046, 0.047, 0.044], rings=3),
            tube(DARK, [(0.088, 0.066, 0), (0.088, 0.08, 0)], [0.045, 0.036], rings=2),
        ),
        "link7": (
            tube(WHITE, [(0, 0, 0.05), (0, 0, 0.088)], [0.044], rings=2),
            tube(DARK, [(0, 0, 0.088), (0, 0, 0.107)], [0.041, 0.038], rings=2),
            tube(
                WHITE, [(0.0, 0.0, 0.078), (0.058, 0.058, 0.078)], [0.026, 0.022], rings=2, cap=True
            ),
            tube(BLUE, [(0.061, 0.061, 0.094), (0.061, 0.061, 0.1005)], [0.009], rings=2, sides=6),
        ),
        "hand": (
            tube(DARK, [(0, 0, 0.0), (0, 0, 0.012)], [0.036], rings=2),
            slab(WHITE, (0, 0, 0.031), (0.0315, 0.102, 0.033), taper=(0.86, 1.0), power=6),
            slab(GREY, (0, 0, 0.0635), (0.019, 0.094, 0.0035), round_off=0.002, power=8),
            slab(GREY, (0.028, 0, 0.03), (0.0055, 0.06, 0.014), round_off=0.003, power=8),
        ),
        "left_finger": _finger(),
        "right_finger": _finger(),
    }
    return MappingProxyType(shells)


def _finger() -> tuple[RobotShell, ...]:
    return (
        slab(
            GREY, (0, 0.0145, 0.0105), (0.0105, 0.0115, 0.0105), round_off=0.002, sides=8, power=8
        ),
        slab(GREY, (0, 0.0165, 0.027), (0.0095, 0.0065, 0.012), round_off=0.002, sides=8, power=8),
        slab(DARK, (0, 0.007, 0.0445), (0.0105, 0.007, 0.0093), round_off=0.0015, sides=8, power=8),
    )


def join(
    shells: Sequence[RobotShell],
) -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "m 3"]]:
    """Return the vertices and faces of several shells as one mesh."""
    first = np.cumsum([0, *(len(shell.vertices) for shell in shells[:-1])])
    faces = [shell.faces + at for shell, at in zip(shells, first, strict=True)]
    return np.concatenate([shell.vertices for shell in shells]), np.concatenate(faces)


def arm_points() -> Float[np.ndarray, "n 3"]:
    """Return the tool centre point and points on all links in the home pose, in the base frame.

    A camera that shows all of them shows the whole robot.
    """
    points = [forward(HOME)[0][None]]
    for number, frame in enumerate([np.eye(4), *link_frames(HOME)]):
        shells = np.concatenate([shell.vertices for shell in arm_shells()[f"link{number}"]])
        points.append(shells @ frame[:3, :3].T + frame[:3, 3])
    return np.concatenate(points)
