"""Phones and tablets."""

from __future__ import annotations

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import block, cylinder
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _slab(look: Look, x: float, y: float, h: float, rim: float, screen: textures.Tile) -> Shape:
    """A thin slab with a screen on top, lying flat; some lie face down, or in a coloured cover."""
    color = look.color(
        *("black", "silver", "white", "navy", "gold", "mint", "red", "pink", "lavender", "teal")
    )
    case = textures.brushed_metal(look.rng, color, 32)
    radius = look.between(0.06, 0.13) * x
    kind = look.pick(["up", "up", "up", "cover", "down"])
    body = block(x, y, h, radius, 0.001)
    if kind == "down":
        bump = block(0.3 * x, 0.32 * x, 0.0018, 0.08 * x, 0.0004)
        bump = bump.move(-0.26 * x, y / 2 - 0.24 * x, h)
        lens = cylinder(0.055 * x, 0.001, 18)
        lenses = [lens.move(-0.26 * x, y / 2 - (0.17 + 0.14 * k) * x, h + 0.0018) for k in (0, 1)]
        logo = cylinder(0.06 * x, 0.0003, 20).move(y=0.05 * y, z=h)
        shine = textures.plain((24, 26, 36))
        return shape(
            [(body, case), (bump, textures.plain(tint_color(color, 0.8))),
             *((one, shine) for one in lenses), (logo, textures.plain(tint_color(color, 1.4)))],
            [box_part(x, y, h), hull_of(bump)],
        )  # fmt: skip
    glass = block(x * 0.97, y * 0.985, 0.0005, radius * 0.9).move(z=h)
    view = block(x - 2 * rim, y - 2.4 * rim, 0.0003, radius * 0.7).move(z=h + 0.0005)
    pieces = [(body, case), (glass, textures.plain((18, 18, 21))), (view, screen)]
    if kind == "cover":
        shell = block(x + 0.004, y + 0.004, 0.9 * h, radius + 0.002, 0.001)
        soft = look.own_color("red", "teal", "yellow", "pink", "black", "sky", "orange")
        pieces.append((shell, textures.speckles(look.rng, soft, 3, 32)))
    return shape(pieces, [box_part(x, y, h + 0.0008)])


def smartphone(look: Look) -> Shape:
    """A phone lying on its back, or on its face."""
    return _slab(
        look,
        look.between(0.066, 0.079),
        look.between(0.14, 0.166),
        look.between(0.0072, 0.0088),
        look.between(0.002, 0.006),
        prints.apps(look.rng),
    )


def tablet(look: Look) -> Shape:
    """A tablet or e-reader lying flat."""
    reader = look.chance(0.4)
    x, y = (0.118, 0.165) if reader else (look.between(0.165, 0.18), look.between(0.235, 0.25))
    page = prints.sheet(look.rng, picture=look.chance(0.3))
    tile = page if reader else prints.apps(look.rng, 128, 176)
    return _slab(look, x, y, 0.0075, 0.011 if reader else look.between(0.005, 0.012), tile)


CATEGORIES = (
    Category(
        "smartphone",
        smartphone,
        (0.074, 0.153, 0.0086),
        0.18,
        ("phone", "mobile phone", "cell phone", "cellphone", "mobile", "iphone"),
        ("office", "coffee", "living", "vanity"),
        ("flat", "screen"),
        ("black", "silver"),
        state="lying flat",
    ),
    Category(
        "tablet",
        tablet,
        (0.15, 0.21, 0.0083),
        0.4,
        ("ipad", "tablet computer"),
        ("office", "coffee", "living"),
        ("flat", "screen"),
        ("black", "silver"),
        state="lying flat",
    ),
)
