"""What one eats and drinks from."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import bowl_parts, box_part, cylinder_part, frame_parts, hull_of, ring_parts
from ...build.shape import Shape, shape
from ...build.solids import box, lathe, open_box, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.contents import contents, drink_color
from ...surfaces.glazes import SIDE, glaze_tile
from ...surfaces.look import Look
from ...surfaces.textures import Tile


def bowl(look: Look) -> Shape:
    """An open bowl on a foot ring: round, conical, straight-sided or shallow."""
    r, h, wall = look.between(0.066, 0.09), look.between(0.05, 0.075), 0.005
    foot = look.between(0.4, 0.6) * r
    color = look.color(
        *("white", "white", "cream", "teal", "blue", "terracotta", "sage", "wooden", "black"),
        *("pink", "mustard", "gray", "navy", "coral"),
    )
    bulge = look.pick(["round", "round", "cone", "straight"])
    t = np.linspace(0, np.pi / 2, 8)
    x, z = {
        "round": (np.sin(t), 1 - np.cos(t)),
        "cone": (0.4 * np.sin(t) + 0.6 * t / t[-1], t / t[-1]),
        "straight": (np.minimum(1, np.sin(1.6 * np.minimum(t, 0.98))), (t / t[-1]) ** 1.6),
    }[bulge]
    outer = np.column_stack([foot + (r - foot) * x, h * z])
    inner = np.column_stack([outer[:, 0] - wall, 0.007 + (h - 0.007) * z])[::-1]
    v = [0, *np.linspace(0.02, 0.48, 8), *np.linspace(0.52, 0.99, 8), 1]
    body = lathe([(0, 0), *outer, *inner, (0, 0.007)], v=v)
    inside = look.surface(look.pick([tint_color(color, 1.5), color, (244, 242, 236)]), "ceramic")
    within = inside if look.chance(0.7) else glaze_tile(look, color)[::-1]
    rim = textures.plain(tint_color(color, 0.5)) if look.chance(0.3) else inside
    tile = textures.stack((glaze_tile(look, color), 48), (rim, 4), (within, 48), side=192)
    wedges = bowl_parts(outer, inner[::-1])
    level = float(np.interp(0.7 * h, inner[::-1, 1], inner[::-1, 0])) + 0.0005
    held = contents(look, level, 0.7 * h) or []
    return shape([(body, tile), *held], [*wedges, cylinder_part(foot, 0.007)])


def plate(look: Look) -> Shape:
    """A dinner plate: a low or wide rim, or a coupe; painted rings, rims and glazes."""
    r, h, t = look.between(0.11, 0.14), look.between(0.017, 0.028), 0.0045
    color = look.color(
        *("white", "white", "cream", "blue", "sage", "terracotta", "gray", "black", "teal"),
        *("pink", "mustard", "navy"),
    )
    well = look.pick([0.58, 0.66, 0.66, 0.78]) * r
    body = lathe(
        [
            (0, 0),
            (well, 0),
            (well * 1.06, 0.003),
            (r, h - t * 0.6),
            (r, h),
            (0.5 * (r + well * 1.08), 0.5 * (h + 0.009) - 0.001),
            (well * 1.08, 0.009),
            (well, t + 0.002),
            (0.5 * well, t + 0.002),
            (0, t + 0.002),
        ],
        v=[0, 0, 0.05, 0.3, 0.32, 0.46, 0.6, 0.66, 0.84, 1],
    )
    return shape([(body, _plate_glaze(look, color))], [
        cylinder_part(well, t + 0.002),
        *ring_parts([(well, 0), (r, h - t * 0.6), (r, h)], [(well, t + 0.002)], 16),
    ])  # fmt: skip


def _plate_glaze(look: Look, color: RGB) -> Tile:
    """Return a plate's glaze: its underside below v 0.3, its rim, and its well above 0.66."""
    glaze = look.surface(color, "ceramic")
    rim = look.own_color("navy", "gold", "teal", "white", "terracotta", "crimson", "black")
    kind = int(look.rng.integers(7))
    if look.material or kind == 0:
        return glaze
    if kind <= 2:
        wide = look.between(2, 14)
        return textures.stack((glaze, 31), (textures.plain(rim), wide), (glaze, 69 - wide))
    if kind == 3:
        line = textures.plain(rim)
        return textures.stack(
            (glaze, 31), (line, 3), (glaze, 4), (line, 1.5), (glaze, 24), (line, 1.5), (glaze, 35)
        )
    if kind == 4:
        pale = look.surface(look.pick([(244, 242, 236), tint_color(color, 1.4)]), "ceramic")
        return textures.stack((glaze, 31), (glaze_tile(look, color), 30), (pale, 39), side=192)
    if kind == 5:
        rings = textures.stripes([color, tint_color(color, 0.86)], 16, side=SIDE)
        return rings if look.chance(0.4) else textures.spots(
            look.rng, color, tint_color(color, 0.55), 0.05)  # fmt: skip
    return textures.gradient(tint_color(color, 0.45), tint_color(color, 1.3), look.rng, 9)


def saucer(look: Look) -> Shape:
    """A small plate for a cup."""
    return plate(look).scale(0.6)


def glass(look: Look) -> Shape:
    """A drinking glass: tapered, straight, waisted or faceted, sometimes with a drink in it."""
    r, h, wall = look.between(0.034, 0.042), look.between(0.095, 0.15), 0.0028
    kind = look.pick(["taper", "taper", "straight", "tulip", "faceted"])
    low = r * {"taper": look.between(0.7, 0.9), "tulip": 0.75}.get(kind, 0.98)
    color = look.color("clear", "clear", "clear", "sky", "mint", "amber", "pink", "green")
    t = np.linspace(0, 1, 6)
    swell = low + (r - low) * (t if kind != "tulip" else np.sin(np.pi * (0.05 + 0.62 * t)))
    outer = np.column_stack([swell, h * t])
    inner = np.column_stack([swell - wall, 0.009 + (h - 0.009) * t])[::-1]
    body = lathe(
        [(0, 0), *outer, *inner, (0, 0.009)],
        9 if kind == "faceted" else 32,
        v=[0, *np.linspace(0.01, 0.95, 6), *np.linspace(0.96, 0.99, 6), 1],
    )
    clear, hue = tint_color(color, 1.2), look.pick([(214, 120, 30), (150, 40, 40), (230, 200, 90)])
    tile = textures.plain(clear)
    if look.chance(0.4):  # the drink shows through the wall and from above
        level = look.between(0.45, 0.85)
        wet = textures.plain(look.pick([hue, hue, (204, 220, 226)]))
        tile = textures.stack((wet, 0.94 * level), (tile, 1.02 - 0.94 * level), (wet, 0.04))
    if drink := drink_color(look):
        wet = textures.plain(drink)
        tile = textures.stack((wet, 0.62), (textures.plain(clear), 0.34), (wet, 0.04))
    elif look.attributes.get("state") == "empty":
        tile = textures.plain(clear)
    top = float(outer[-1, 0]) * (np.cos(np.pi / 9) if kind == "faceted" else 1.0)
    foot = low * (np.cos(np.pi / 9) if kind == "faceted" else 1.0)
    middle = (float(outer[3, 0]) * top / float(outer[-1, 0]), float(outer[3, 1]))
    return shape(
        [(body, tile)],
        [
            *ring_parts([(foot, 0), middle, (top, h)], [(top - wall, h), (foot - wall, 0.009)]),
            cylinder_part(foot, 0.009),
        ],
        opacity=0.45,
    )


def wine_glass(look: Look) -> Shape:
    """A on_stem glass: tulip, balloon, flute or coupe; some hold wine."""
    r, h, wall = look.between(0.034, 0.044), look.between(0.175, 0.22), 0.0022
    kind = look.pick(["tulip", "tulip", "balloon", "flute", "cone"])
    r = {"flute": 0.84 * r, "balloon": 1.05 * r}.get(kind, r)
    cup = {"flute": 0.38, "balloon": 0.45, "cone": 0.6}.get(kind, look.between(0.42, 0.5)) * h
    foot = 0.9 * r if kind != "flute" else 1.05 * r
    t = np.linspace(0, 1, 8)
    swell = {
        "tulip": np.sin(0.2 + 2.05 * t),
        "balloon": np.sin(0.2 + 2.25 * t),
        "flute": np.sin(0.3 + 1.6 * t) ** 0.7,
        "cone": 0.12 + 0.88 * t,
    }[kind]
    outer = np.column_stack([r * swell, cup + (h - cup) * t])
    outer[0, 0] = 0.006
    inner = np.column_stack([np.maximum(outer[:, 0] - wall, 0.001), outer[:, 1] + 0.004])[::-1]
    inner[0, 1] = h
    stem = [(0, 0), (foot, 0), (foot, 0.0015), (0.006, 0.008), (0.0042, 0.03), (0.0042, cup - 0.02)]
    up, down = np.linspace(0.3, 0.8, 8), np.linspace(0.82, 0.99, 8)
    body = lathe(
        [*stem, *outer, *inner, (0, cup + 0.004)], 28, v=[*np.linspace(0, 0.28, 6), *up, *down, 1]
    )
    color = look.color("clear", "clear", "clear", "sky", "pink", "amber", "green")
    clear = textures.plain(tint_color(color, 1.2))
    wine = textures.plain(look.pick([(110, 16, 34), (226, 200, 110), (230, 150, 140)]))
    level = look.between(0.12, 0.3) if look.chance(0.5) else 0.0
    tile = clear
    if level:
        tile = textures.stack((clear, 0.3), (wine, level), (clear, 0.66 - level), (wine, 0.04))
    rim = float(outer[-1, 0])
    wedges = ring_parts(
        [(0.006, cup), tuple(outer[3]), tuple(outer[5]), (rim, h)],
        [(rim - wall, h), (0.003, cup + 0.004)],
    )
    return shape(
        [(body, tile)],
        [*wedges, cylinder_part(foot, 0.004), cylinder_part(0.0042, cup, (0, 0, 0.002))],
        opacity=0.45,
    )


def napkins(look: Look) -> Shape:
    """A stack of folded napkins."""
    side, h = look.between(0.15, 0.17), look.between(0.012, 0.03)
    color = look.color("white", "red", "cream", "sage", "navy", "pink", "teal", "mustard", "gray")
    kind, other = int(look.rng.integers(4)), look.own_color("white", "red", "navy", "mustard")
    cloth = textures.fabric(look.rng, color, other if kind == 1 else None)
    if kind >= 2:
        cloth = glaze_tile(look, color)
    layers = 4
    pieces = [
        (
            box(side, side, h / layers - 0.0006)
            .turn(2, look.between(-0.03, 0.03))
            .move(z=k * h / layers),
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
    dark = textures.plain(tint_color(color, 0.6))
    return shape(
        [*((solid, tile) for solid in open_box(x, y, h, wall, 0.008)), *((g, dark) for g in grip)],
        [*frame_parts(x, y, h, wall, 0.008), *map(hull_of, grip)],
    )


CATEGORIES = (
    Category(
        "glass",
        glass,
        (0.074, 0.074, 0.12),
        0.24,
        ("drinking glass", "water glass", "glass of water"),
        ("dining", "kitchen"),
        ("container", "round", "tall"),
        ("clear",),
    ),
    Category(
        "wine_glass",
        wine_glass,
        (0.078, 0.078, 0.2),
        0.15,
        ("goblet", "wineglass"),
        ("dining",),
        ("round", "tall"),
        ("clear",),
    ),
    Category(
        "bowl",
        bowl,
        (0.155, 0.155, 0.063),
        0.35,
        ("dish", "salad bowl", "soup bowl", "rice bowl", "holy water font"),
        ("dining", "kitchen"),
        ("container", "round"),
        ("white", "cream", "teal", "blue"),
    ),
    Category(
        "plate",
        plate,
        (0.25, 0.25, 0.023),
        0.5,
        (
            "dinner plate",
            "charger plate",
            "seder plate",
        ),
        ("dining", "kitchen"),
        ("support", "flat", "round"),
        ("white", "cream", "blue"),
    ),
    Category(
        "saucer",
        saucer,
        (0.15, 0.15, 0.014),
        0.16,
        ("dessert plate",),
        ("coffee", "dining"),
        ("support", "flat", "round"),
        ("white",),
    ),
    Category(
        "napkins",
        napkins,
        (0.163, 0.163, 0.021),
        0.08,
        ("napkin", "napkin stack", "stack of napkins", "folded napkin", "tissue"),
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
        ("serving tray",),
        ("dining", "coffee", "kitchen"),
        ("container", "support", "big", "flat"),
        ("wooden", "white", "black"),
    ),
)
