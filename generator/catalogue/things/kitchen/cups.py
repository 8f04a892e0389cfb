"""Mugs and teacups."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import bowl_parts, box_part, cylinder_part, ring_parts
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, lathe, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.contents import contents
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

DRINKS: tuple[RGB, ...] = ((58, 34, 22), (150, 100, 64), (196, 160, 120), (166, 88, 32))
"""Black and white coffee, milk foam, tea."""

EARS = ("ear", "square", "ring")


def handle(
    radii: tuple[float, float],
    low: float,
    high: float,
    reach: float,
    thick: float,
    kind: str = "ear",
) -> Solid:
    """Return an ear-shaped, squarish or ring handle on the +x side of a wall.

    ``radii`` are the wall's at heights ``low`` and ``high``.
    """
    ways = {
        "ear": [(0, 1.0), (0.6, 1.04), (1, 0.62), (0.72, 0.22), (0, 0)],
        "square": [(0, 1.0), (0.8, 1.0), (0.96, 0.9), (0.96, 0.12), (0.8, 0.02), (0, 0)],
        "ring": [(0, 0.92), (0.55, 1.0), (0.95, 0.72), (0.95, 0.32), (0.55, 0.02), (0, 0.1)],
    }[kind]
    start, step = radii[0], radii[1] - radii[0]
    points = [(start + z * step + x * reach, 0, low + z * (high - low)) for x, z in ways]
    return tube(smooth(points, 4), thick, 8, squash=0.75)


def handle_part(radius: float, low: float, high: float, reach: float, thick: float) -> ConvexPart:
    """Return a handle's collision box."""
    return box_part(reach, 2 * thick, high - low, (radius + reach / 2, 0, low))


def _drink(look: Look, radius: float, height: float) -> list[tuple[Solid, textures.Tile]]:
    """Return the surface of a drink, or nothing: most cups are empty where nothing is said."""
    full, color = look.chance(0.3), look.pick(DRINKS)
    said = contents(look, radius, height)
    if said is not None:
        return said
    if not full:
        return []
    foam = textures.spots(look.rng, color, tint_color(color, 1.3), look.between(0.01, 0.2), 48)
    return [(cylinder(radius, 0.0016, 28).move(z=height), foam)]


def mug(look: Look) -> Shape:
    """A mug with an ear, straight, flaring, bellied or of enamel; a ball falls into it."""
    r, h, wall = look.between(0.037, 0.044), look.between(0.082, 0.108), 0.0045
    kind = look.pick(["straight", "straight", "flared", "belly", "enamel", "round"])
    color = look.color(
        *("white", "white", "red", "blue", "teal", "mustard", "sage", "black", "terracotta"),
        *("pink", "navy", "gray", "cream", "green", "orange", "lavender"),
    )
    glaze, inside = (
        glaze_tile(look, color, words=True),
        look.surface(tint_color(color, 1.4), "ceramic"),
    )
    if kind == "enamel":
        inside = textures.plain((242, 240, 234))
    t = np.linspace(0, 1, 7)
    swell = {
        "straight": 1 + 0 * t,
        "flared": 0.78 + 0.27 * t,
        "belly": 0.9 + 0.16 * np.sin(np.pi * (0.1 + 0.75 * t)),
        "enamel": 0.97 + 0.03 * t,
        "round": 0.62 + 0.42 * np.sin(np.pi / 2 * np.minimum(1.35 * t + 0.12, 1.15)),
    }[kind]
    side = np.column_stack([r * swell, 0.006 + (h - 0.008) * t])
    inner = [(radius - wall, max(z, 0.007)) for radius, z in side[::-1]]
    foot, top = 0.9 * side[0, 0], float(side[-1, 0])
    body = lathe(
        [(0, 0), (foot, 0), *side, (top - wall / 2, h), *inner, (0, 0.007)],
        v=[0, 0, *np.linspace(0.02, 0.96, 7), 0.97, *np.linspace(0.98, 0.995, 7), 1],
    )
    low, high = look.between(0.16, 0.28) * h, look.between(0.78, 0.88) * h
    reach, thick = look.between(0.024, 0.03), look.between(0.0042, 0.006)
    touch, top_touch = np.interp([low, high], side[:, 1], side[:, 0]) - 0.002
    ear = handle((touch, top_touch), low, high, reach, thick, look.pick(EARS))
    rim = textures.plain(tint_color(color, 0.35)) if kind == "enamel" else inside
    tile = textures.stack((glaze, 96), (rim, 2), (inside, 3), side=192)
    ear_color = look.pick([color, color, tint_color(color, 0.5)])
    wedges = ring_parts(
        [(foot, 0.0), tuple(side[0]), tuple(side[3]), (top, h)],
        [(top - wall, h), (float(side[0, 0]) - wall, 0.007)],
    )
    level = float(np.interp(0.84 * h, side[:, 1], side[:, 0])) - wall + 0.0006
    return shape(
        [(body, tile), (ear, look.surface(ear_color, "ceramic")), *_drink(look, level, 0.84 * h)],
        [*wedges, cylinder_part(foot, 0.007),
         handle_part(top_touch, low, 0.98 * high, 0.8 * reach - (top_touch - touch) / 2, thick)],
    )  # fmt: skip


def teacup(look: Look) -> Shape:
    """A wide, thin cup with an ear, on its foot: bowl-shaped, tulip or straight."""
    r, h, wall = look.between(0.04, 0.05), look.between(0.052, 0.07), 0.0035
    foot = look.between(0.46, 0.6) * r
    color = look.color(
        "white", "white", "cream", "pink", "sky", "mint", "navy", "black", "terracotta", "mustard"
    )
    power, flare = look.pick([0.8, 0.5, 1.1]), look.pick([0.0, 0.0, 0.06])
    t = np.linspace(0, np.pi / 2, 7)
    out = foot + (r - foot) * np.sin(t) ** power + flare * r * (t / t[-1]) ** 4
    outer = np.column_stack([out, 0.005 + (h - 0.005) * t / t[-1]])
    inner = np.column_stack([outer[:, 0] - wall, 0.011 + (h - 0.011) * t / t[-1]])[::-1]
    v = [0, 0, 0.03, *np.linspace(0.06, 0.95, 7), *np.linspace(0.97, 1, 7), 1]
    body = lathe([(0, 0), (foot, 0), (foot, 0.004), *outer, *inner, (0, 0.01)], v=v)
    inside = look.surface(look.pick([color, (244, 242, 236)]), "ceramic")
    trim = textures.plain(look.own_color("gold", "silver", "navy")) if look.chance(0.35) else inside
    tile = textures.stack((glaze_tile(look, color), 94), (trim, 2), (inside, 4), side=192)
    kind = look.pick(EARS)
    ends = np.interp([0.36 * h, 0.86 * h], outer[:, 1], outer[:, 0]) - 0.0016
    ear = handle((ends[0], ends[1]), 0.36 * h, 0.86 * h, look.between(0.017, 0.022), 0.0032, kind)
    wedges = bowl_parts(np.array([(foot, 0), *outer[1:]]), inner[::-1])
    level = float(np.interp(0.82 * h, inner[::-1, 1], inner[::-1, 0])) + 0.0005
    return shape(
        [(body, tile), (ear, look.surface(color, "ceramic")), *_drink(look, level, 0.82 * h)],
        [
            *wedges,
            cylinder_part(foot, 0.01),
            handle_part(ends[1], 0.42 * h, 0.84 * h, 0.011, 0.003),
        ],
    )


CATEGORIES = (
    Category(
        "mug",
        mug,
        (0.11, 0.083, 0.095),
        0.3,
        ("coffee mug", "coffee cup", "cup"),
        ("office", "coffee", "kitchen"),
        ("container", "round"),
        ("white", "red", "blue", "teal", "black"),
    ),
    Category(
        "teacup",
        teacup,
        (0.106, 0.09, 0.06),
        0.16,
        ("tea cup", "espresso cup"),
        ("coffee", "dining"),
        ("container", "round"),
        ("white", "cream", "pink"),
    ),
)
