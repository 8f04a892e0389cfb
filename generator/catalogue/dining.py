"""What one eats and drinks from."""

from __future__ import annotations

import numpy as np

from ..scene import ConvexPart
from . import textures
from .category import Category
from .collision import box_part, cylinder_part, frame_parts, ring_parts
from .colors import RGB, tinted
from .look import Look
from .outlines import smooth
from .shape import Shape, shape
from .solids import Solid, box, lathe, open_box, tube
from .textures import Tile


def handle(radius: float, low: float, high: float, reach: float, thick: float) -> Solid:
    """Return an ear-shaped handle on the +x side of a wall of ``radius``."""
    path = smooth(
        [
            (radius, 0, high),
            (radius + 0.6 * reach, 0, high + 0.04 * (high - low)),
            (radius + reach, 0, low + 0.62 * (high - low)),
            (radius + 0.72 * reach, 0, low + 0.22 * (high - low)),
            (radius, 0, low),
        ],
        4,
    )
    return tube(path, thick, 8, squash=0.75)


def handle_part(radius: float, low: float, high: float, reach: float, thick: float) -> ConvexPart:
    """Return a handle's collision box."""
    return box_part(reach, 2 * thick, high - low, (radius + reach / 2, 0, low))


def decorated(look: Look, color: RGB) -> Tile:
    """Return a glaze for the outside of crockery: plain, banded, spotted, two-tone."""
    other = look.fixed("white", "navy", "terracotta", "teal", "cream", "mustard")
    style = int(look.rng.integers(5))
    glaze = look.surface(color, "ceramic")
    if look.material or style <= 1:
        return glaze
    if style == 2:
        return textures.stacked((glaze, 5), (textures.plain(other), 1), (glaze, 1.4))
    if style == 3:
        return textures.spotted(look.rng, color, tinted(color, 0.6))
    return textures.stacked((textures.plain(tinted(color, 0.55)), 2), (glaze, 4))


def mug(look: Look) -> Shape:
    """A mug with an ear; a ball falls into it."""
    r, h, wall = look.between(0.039, 0.043), look.between(0.088, 0.102), 0.0045
    top = r * look.pick([1.0, 1.0, 1.06])
    color = look.color("white", "red", "blue", "teal", "mustard", "sage", "black", "terracotta")
    glaze, inside = decorated(look, color), look.surface(tinted(color, 1.4), "ceramic")
    body = lathe(
        [
            (0, 0),
            (r * 0.86, 0),
            (r, 0.006),
            (top, h - 0.002),
            (top - wall / 2, h),
            (top - wall, h - 0.002),
            (r - wall, 0.012),
            (r * 0.7, 0.006),
            (0, 0.006),
        ],
        v=[0, 0, 0.02, 0.96, 0.97, 0.98, 0.99, 1, 1],
    )
    ear = handle(r - 0.002, 0.22 * h, 0.82 * h, 0.026, 0.0055)
    tile = textures.stacked((glaze, 97), (inside, 4), side=128)
    wedges = ring_parts(
        [(r * 0.86, 0.0), (r, 0.006), (top, h)], [(top - wall, h), (r - wall, 0.006)]
    )
    bottom = cylinder_part(r * 0.86, 0.006)
    return shape(
        [(body, tile), (ear, look.surface(color, "ceramic"))],
        [*wedges, bottom, handle_part(r, 0.22 * h, 0.8 * h, 0.022, 0.005)],
    )


def bowl(look: Look) -> Shape:
    """An open bowl on a foot ring."""
    r, h, wall = look.between(0.07, 0.085), look.between(0.055, 0.072), 0.005
    foot = 0.45 * r
    color = look.color("white", "cream", "teal", "blue", "terracotta", "sage", "wooden")
    t = np.linspace(0, np.pi / 2, 8)
    outer = np.column_stack([foot + (r - foot) * np.sin(t), h * (1 - np.cos(t))])
    inner = np.column_stack([outer[:, 0] - wall, 0.007 + (h - 0.007) * (1 - np.cos(t))])[::-1]
    v = [0, *np.linspace(0.02, 0.95, 8), *np.linspace(0.97, 1, 8), 1]
    body = lathe([(0, 0), *outer, *inner, (0, 0.007)], v=v)
    inside = look.surface(look.pick([tinted(color, 1.5), color]), "ceramic")
    tile = textures.stacked((decorated(look, color), 96), (inside, 4))
    wedges = ring_parts(
        [(foot, 0), tuple(outer[3]), tuple(outer[5]), (r, h)],
        [(r - wall, h), (foot - wall, 0.007)],
    )
    return shape([(body, tile)], [*wedges, cylinder_part(foot, 0.007)])


def plate(look: Look) -> Shape:
    """A dinner plate with a low rim."""
    r, h, t = look.between(0.115, 0.135), look.between(0.02, 0.026), 0.0045
    color = look.color("white", "cream", "blue", "sage", "terracotta", "gray")
    rim = look.fixed("navy", "gold", "teal", "white", "terracotta")
    well = 0.66 * r
    body = lathe(
        [
            (0, 0),
            (well, 0),
            (well * 1.06, 0.003),
            (r, h - t * 0.6),
            (r, h),
            (well * 1.08, 0.009),
            (well, t + 0.002),
            (0, t + 0.002),
        ],
        v=[0, 0, 0.05, 0.5, 0.52, 0.75, 0.8, 1],
    )
    glaze = look.surface(color, "ceramic")
    ring = textures.plain(rim if look.chance(0.5) else tinted(color, 0.9))
    tile = textures.stacked((glaze, 51), (ring, 6), (glaze, 43))
    wedges = ring_parts([(well, 0), (r, h - t * 0.6), (r, h)], [(well, t + 0.002)], 8)
    return shape([(body, tile)], [cylinder_part(well, t + 0.002), *wedges])


def saucer(look: Look) -> Shape:
    """A small plate for a cup."""
    return plate(look).scaled(0.6)


def teacup(look: Look) -> Shape:
    """A wide, thin cup with an ear, on its foot."""
    r, h, wall = look.between(0.042, 0.048), look.between(0.056, 0.064), 0.0035
    foot = 0.5 * r
    color = look.color("white", "cream", "pink", "sky", "mint", "navy")
    t = np.linspace(0, np.pi / 2, 7)
    outer = np.column_stack([foot + (r - foot) * np.sin(t) ** 0.8, 0.005 + (h - 0.005) * t / t[-1]])
    inner = np.column_stack([outer[:, 0] - wall, 0.011 + (h - 0.011) * t / t[-1]])[::-1]
    v = [0, 0, 0.03, *np.linspace(0.06, 0.95, 7), *np.linspace(0.97, 1, 7), 1]
    body = lathe([(0, 0), (foot, 0), (foot, 0.004), *outer, *inner, (0, 0.01)], v=v)
    tile = textures.stacked((decorated(look, color), 96), (look.surface(color, "ceramic"), 4))
    ear = handle(0.95 * r, 0.42 * h, 0.86 * h, 0.02, 0.0032)
    wedges = ring_parts([(foot, 0), tuple(outer[2]), (r, h)], [(r - wall, h), (foot - wall, 0.01)])
    return shape(
        [(body, tile), (ear, look.surface(color, "ceramic"))],
        [*wedges, cylinder_part(foot, 0.01), handle_part(r, 0.42 * h, 0.86 * h, 0.016, 0.003)],
    )


def glass(look: Look) -> Shape:
    """A drinking glass, sometimes with a drink in it."""
    r, h, wall = look.between(0.034, 0.04), look.between(0.1, 0.14), 0.0028
    low = r * look.pick([0.8, 0.9, 1.0])
    color = look.color("clear", "clear", "sky", "mint", "amber")
    body = lathe(
        [(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.009), (0, 0.009)],
        v=[0, 0, 0.95, 0.96, 0.99, 1],
    )
    return shape(
        [(body, textures.plain(tinted(color, 1.2)))],
        [
            *ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.009)]),
            cylinder_part(low, 0.009),
        ],
        opacity=0.45,
    )


def wine_glass(look: Look) -> Shape:
    """A stemmed glass."""
    r, h, wall = look.between(0.036, 0.042), look.between(0.18, 0.215), 0.0022
    cup = look.between(0.42, 0.5) * h
    foot = 0.9 * r
    t = np.linspace(0, 1, 8)
    outer = np.column_stack([r * np.sin(0.2 + 2.05 * t), cup + (h - cup) * t])
    outer[0, 0] = 0.006
    inner = np.column_stack([np.maximum(outer[:, 0] - wall, 0.001), outer[:, 1] + 0.004])[::-1]
    inner[0, 1] = h
    stem = [(0, 0), (foot, 0), (foot, 0.0015), (0.006, 0.008), (0.0042, 0.03), (0.0042, cup - 0.02)]
    body = lathe([*stem, *outer, *inner, (0, cup + 0.004)], 28)
    color = look.color("clear", "clear", "sky", "pink")
    rim = float(outer[-1, 0])
    wedges = ring_parts(
        [(0.006, cup), tuple(outer[3]), tuple(outer[5]), (rim, h)],
        [(rim - wall, h), (0.003, cup + 0.004)],
    )
    return shape(
        [(body, textures.plain(tinted(color, 1.2)))],
        [*wedges, cylinder_part(foot, 0.004), cylinder_part(0.0042, cup, (0, 0, 0.002))],
        opacity=0.45,
    )


# ---------------------------------------------------------------------------------- cutlery


def napkins(look: Look) -> Shape:
    """A stack of folded napkins."""
    side, h = look.between(0.15, 0.17), look.between(0.012, 0.03)
    color = look.color("white", "red", "cream", "sage", "navy", "pink")
    cloth = textures.fabric(look.rng, color, look.fixed("white") if look.chance(0.4) else None)
    layers = 4
    pieces = [
        (
            box(side, side, h / layers - 0.0006)
            .turned(2, look.between(-0.03, 0.03))
            .moved(z=k * h / layers),
            cloth,
        )
        for k in range(layers)
    ]
    return shape(pieces, [box_part(side, side, h - 0.0006)])


def tray(look: Look) -> Shape:
    """A serving tray with a low rim and two grips."""
    x, y, h = look.between(0.36, 0.42), look.between(0.25, 0.29), 0.035
    wall = 0.009
    color = look.color("wooden", "white", "black", "teal", "brown")
    tile = look.surface(color, "wood")
    grip = [
        tube([(side * x / 2, -0.06, h - 0.006), (side * (x / 2 + 0.012), -0.05, h + 0.016),
              (side * (x / 2 + 0.012), 0.05, h + 0.016), (side * x / 2, 0.06, h - 0.006)], 0.005, 8)
        for side in (-1, 1)
    ]  # fmt: skip
    dark = textures.plain(tinted(color, 0.6))
    parts = frame_parts(x, y, h, wall, 0.008)
    return shape(
        [*((solid, tile) for solid in open_box(x, y, h, wall, 0.008)), *((g, dark) for g in grip)],
        parts,
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
    Category(
        "glass",
        glass,
        (0.074, 0.074, 0.12),
        0.24,
        ("tumbler", "drinking glass", "water glass", "glass of water", "cocktail glass"),
        ("dining", "kitchen"),
        ("container", "round", "tall"),
        ("clear",),
    ),
    Category(
        "wine_glass",
        wine_glass,
        (0.078, 0.078, 0.2),
        0.15,
        ("goblet", "champagne glass", "wineglass"),
        ("dining",),
        ("round", "tall"),
        ("clear",),
    ),
    Category(
        "bowl",
        bowl,
        (0.155, 0.155, 0.063),
        0.35,
        ("dish", "salad bowl", "soup bowl"),
        ("dining", "kitchen"),
        ("container", "round"),
        ("white", "cream", "teal", "blue"),
    ),
    Category(
        "plate",
        plate,
        (0.25, 0.25, 0.023),
        0.5,
        ("dinner plate",),
        ("dining", "kitchen"),
        ("support", "flat", "round"),
        ("white", "cream", "blue"),
    ),
    Category(
        "saucer",
        saucer,
        (0.15, 0.15, 0.014),
        0.16,
        ("small plate", "dessert plate"),
        ("coffee", "dining"),
        ("support", "flat", "round"),
        ("white",),
    ),
    Category(
        "napkins",
        napkins,
        (0.163, 0.163, 0.021),
        0.08,
        ("napkin", "napkin stack", "stack of napkins", "folded napkin", "tissue", "cloth", "towel"),
        ("dining", "kitchen"),
        ("support", "flat"),
        ("white", "red"),
        state="lying flat",
    ),
    Category(
        "tray",
        tray,
        (0.42, 0.27, 0.053),
        0.8,
        ("serving tray", "platter"),
        ("dining", "coffee", "kitchen"),
        ("container", "support", "big", "flat"),
        ("wooden", "white", "black"),
    ),
)
