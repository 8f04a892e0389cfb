"""Things a table is laid with: gravy boats, tureens, platters, domes, egg cups, toast racks."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.settled import lift_parts, settle, stretch_parts
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

CHINA = ("white", "white", "cream", "sky", "navy", "sage", "terracotta", "black", "teal")


def _china(look: Look, *palette: str) -> tuple[textures.Tile, textures.Tile]:
    """Return the tile of a vessel glazed outside and plain inside, and its plain glaze."""
    color = look.color(*(palette or CHINA))
    plain = look.surface(color, "ceramic")
    return textures.stack((glaze_tile(look, color), 50), (plain, 50), side=160), plain


def gravy_boat(look: Look) -> Shape:
    """A sauce boat: an oval jug with a long lip to the left and an ear."""
    r, h = look.between(0.04, 0.047), look.between(0.07, 0.082)
    tile, plain = _china(look)
    side = [(0.62 * r, 0.012), (0.86 * r, 0.3 * h), (r, 0.65 * h), (0.98 * r, h)]
    body, parts = open_vessel(side, 0.004, 0.016)

    def lip(p: np.ndarray) -> np.ndarray:
        up = np.clip((p[:, 2] / h - 0.35) / 0.65, 0, 1)
        left, mid = np.clip(-p[:, 0] / r, 0, 1), np.abs(p[:, 1]) / r
        out = -0.62 * r * up * left**2
        return np.column_stack([p[:, 0] * 1.35 + out, p[:, 1] * (1 - 0.45 * up * left**2),
                                p[:, 2] + 0.2 * h * up * left**2 * (1 - 0.5 * mid)])  # fmt: skip

    foot = lathe([(0, 0), (0.78 * r, 0), (0.7 * r, 0.006), (0.45 * r, 0.014), (0, 0.014)], 28)
    ear = tube(smooth([(1.26 * r, 0, 0.9 * h), (1.9 * r, 0, 0.98 * h), (1.95 * r, 0, 0.55 * h),
                       (1.2 * r, 0, 0.32 * h)], 5), 0.0042, 8)  # fmt: skip
    lug = box_part(0.6 * r, 0.009, 0.5 * h, (1.6 * r, 0, 0.42 * h))
    return shape([(body.bend(lip), tile), (foot.scale(1.35, 1, 1), plain), (ear, plain)],
                 [*stretch_parts(parts, 1.33, 0.98),
                  *stretch_parts([cylinder_part(0.78 * r, 0.014)], 1.35, 1), lug])  # fmt: skip


def butter_dish(look: Look) -> Shape:
    """A butter dish: a flat tray under a lid with a knob."""
    x, y, h = look.between(0.15, 0.175), look.between(0.09, 0.105), look.between(0.055, 0.065)
    color = look.color(*CHINA)
    plain = look.surface(color, "ceramic")
    tray = block(x, y, 0.012, 0.022, 0.004)
    rim = block(0.99 * x, 0.99 * y, 0.004, 0.022, 0.001).move(z=0.0115)
    lid = block(0.78 * x, 0.7 * y, h, 0.014, 0.008).move(z=0.0135)
    knob = lathe([(0, 0), (0.006, 0), (0.005, 0.006), (0.011, 0.013), (0.008, 0.02), (0, 0.021)],
                 20).move(z=h + 0.0125)  # fmt: skip
    face = look.pick([glaze_tile(look, color), plain])
    wood = look.surface(look.own_color("wooden", "tan"), "wood")
    return shape([(join([tray, rim]), look.pick([plain, wood])), (lid, face), (knob, plain)],
                 [hull_of(tray, rim), hull_of(lid), hull_of(knob)])  # fmt: skip


def tureen(look: Look) -> Shape:
    """A soup tureen with two ears and a domed lid, a ladle's handle sticking out."""
    r, h = look.between(0.095, 0.115), look.between(0.11, 0.13)
    tile, plain = _china(look)
    body = lathe([(0, 0), (0.6 * r, 0), (0.58 * r, 0.1 * h), (0.82 * r, 0.3 * h), (r, 0.62 * h),
                  (0.97 * r, 0.96 * h), (r, h), (0, h)], 32)  # fmt: skip
    lid = lathe([(0, h), (0.98 * r, h), (0.96 * r, 1.06 * h), (0.7 * r, 1.25 * h),
                 (0.3 * r, 1.38 * h), (0, 1.4 * h)], 32)  # fmt: skip
    knob = ellipsoid(0.24 * r, 0.24 * r, 0.2 * r, 16, 10).move(z=1.46 * h)
    ears = [tube(smooth([(s * 0.95 * r, -0.03, 0.78 * h), (s * 1.28 * r, -0.02, 0.84 * h),
                         (s * 1.28 * r, 0.02, 0.84 * h), (s * 0.95 * r, 0.03, 0.78 * h)], 4),
                 0.006, 8) for s in (-1, 1)]  # fmt: skip
    rim = torus(0.985 * r, 0.004, 36, 6).move(z=h)
    tone = textures.plain(tint_color(look.own_color("navy", "gold", "teal", "white"), 1.0))
    return shape(
        [(body, tile), (lid, tile), (join([knob, *ears]), plain), (rim, tone)],
        [hull_of(body), hull_of(lid, knob), *(hull_of(e) for e in ears)],
    )


def serving_platter(look: Look) -> Shape:
    """A flat oval dish with a broad rim."""
    x, y, h = look.between(0.32, 0.38), look.between(0.22, 0.26), look.between(0.024, 0.03)
    color = look.color(*CHINA)
    plain = look.surface(color, "ceramic")
    dish = lathe([(0, 0), (0.36, 0), (0.38, 0.2), (0.5, 0.94), (0.495, 1), (0.36, 0.5),
                  (0, 0.42)], 44).scale(x, y, h)  # fmt: skip
    band = look.chance(0.5)
    line = lathe([(0.44, 0.78), (0.462, 0.86), (0.462, 0.9), (0.44, 0.82)], 44, loop=True)
    tone = look.own_color("navy", "gold", "teal") if band else tint_color(color, 0.8)
    well = lathe([(0.355, 0.46), (0.372, 0.56), (0.372, 0.6), (0.355, 0.52)], 44, loop=True)
    shade = textures.plain(tint_color(color, 0.72))
    pieces = [(dish, plain), (line.scale(x, y, h), textures.plain(tone)),
              (well.scale(x, y, h), shade)]  # fmt: skip
    inner = stretch_parts([cylinder_part(0.37, 0.44 * h)], x, y)
    wall = ring_parts([(0.37, 0.02 * h), (0.5, 0.94 * h)], [(0.495, h), (0.36, 0.5 * h)],
                      stretch=(x, y))  # fmt: skip
    return shape(pieces, [*inner, *wall])


def serving_bowl(look: Look) -> Shape:
    """A large deep bowl for salad or fruit, of wood, glass or china."""
    r, h = look.between(0.115, 0.14), look.between(0.085, 0.105)
    color = look.color("wooden", "white", "teal", "cream", "navy", "terracotta")
    plain = look.surface(color, look.pick(["wood", "ceramic"]))
    side = [(0.45 * r, 0), (0.72 * r, 0.22 * h), (0.92 * r, 0.6 * h), (r, h)]
    body, parts = open_vessel(side, 0.006, 0.008)
    return shape([(body, textures.stack((plain, 50), (look.surface(tint_color(color, 1.2),
                 "ceramic") if look.chance(0.3) else plain, 50)))], parts)  # fmt: skip


def cloche(look: Look) -> Shape:
    """A dome of steel or glass with a knob over a plate."""
    r, h = look.between(0.115, 0.14), look.between(0.1, 0.13)
    plate = lathe([(0, 0), (0.8 * r, 0), (1.12 * r, 0.012), (1.12 * r, 0.015), (0.8 * r, 0.006),
                   (0, 0.006)], 36)  # fmt: skip
    t = np.linspace(0, np.pi / 2, 9)
    arch = np.column_stack([r * np.cos(t) ** 0.8, 0.012 + h * np.sin(t)])[:-1]
    dome = lathe([(0, 0.0055), (r, 0.0055), *arch, (0, 0.012 + h)], 36)
    knob = lathe([(0, 0), (0.006, 0), (0.006, 0.012), (0.016, 0.02), (0.012, 0.03), (0, 0.031)],
                 20).move(z=h + 0.011)  # fmt: skip
    color = look.color("silver", "silver", "copper", "gold", "clear")
    skin = look.surface(color, "metal")
    tone = look.surface(look.own_color("black", "wooden", "gold"), "wood")
    china = textures.plain(look.own_color("white", "cream", "charcoal"))
    return shape([(plate, china), (dome, skin), (knob, tone)],
                 [hull_of(plate), hull_of(dome), hull_of(knob)])  # fmt: skip


def egg_cup(look: Look) -> Shape:
    """An egg cup on its foot."""
    r, h = look.between(0.031, 0.034), look.between(0.054, 0.064)
    tile, plain = _china(look, "white", "yellow", "sky", "red", "mint", "wooden", "pink")
    side = [(0.42 * r, 0.45 * h), (0.8 * r, 0.58 * h), (0.97 * r, 0.8 * h), (r, h)]
    cup, parts = open_vessel([(a, z - 0.45 * h) for a, z in side], 0.003, 0.004)
    foot = lathe([(0, 0), (0.85 * r, 0), (0.8 * r, 0.06 * h), (0.3 * r, 0.2 * h),
                  (0.3 * r, 0.38 * h), (0.42 * r, 0.47 * h), (0, 0.47 * h)], 26)  # fmt: skip
    pieces = [(cup.move(z=0.45 * h), tile), (foot, plain)]
    made = [*lift_parts(parts, 0.45 * h), cylinder_part(0.84 * r, 0.08 * h),
            cylinder_part(0.3 * r, 0.42 * h, (0, 0, 0.06 * h))]  # fmt: skip
    return shape(pieces, made)


def napkin_ring(look: Look) -> Shape:
    """A broad ring standing on its edge face, or with a rolled napkin through it."""
    r, w = look.between(0.02, 0.024), look.between(0.026, 0.034)
    color = look.color("silver", "gold", "wooden", "copper", "white")
    skin = look.surface(color, look.pick(["metal", "wood"]))
    ring = lathe([(0.86 * r, 0), (0.97 * r, 0), (r, 0.1 * w), (r, 0.9 * w), (0.97 * r, w),
                  (0.86 * r, w)], 32, loop=True)  # fmt: skip
    if look.chance(0.6):
        return shape([(ring, skin)], ring_parts([(0.97 * r, 0), (r, 0.1 * w), (r, 0.9 * w),
                     (0.97 * r, w)], [(0.86 * r, w), (0.86 * r, 0)], 10))  # fmt: skip
    cloth = textures.fabric(look.rng, look.own_color("white", "cream", "red", "navy", "sage"))
    roll = [cylinder(0.8 * r, 0.16, 20).move(z=-0.081 + 0.5 * w)]
    fan = [box(0.0016, 1.9 * r * k, 0.05).turn(2, a).move(z=0.068 + 0.5 * w)
           for k, a in ((1.0, 0.3), (1.1, 1.2), (1.0, 2.2))]  # fmt: skip
    laid = [(s.turn(1, np.pi / 2).move(-0.5 * w, 0, r), t)
            for s, t in ((ring, skin), (join([*roll, *fan]), cloth))]  # fmt: skip
    return settle(laid, 0.07, hulls=[[0], [1]])


def toast_rack(look: Look) -> Shape:
    """A rack of hoops on a base for toast, a few slices in it."""
    x, y, h = look.between(0.15, 0.18), look.between(0.08, 0.095), look.between(0.09, 0.105)
    color = look.color("silver", "silver", "black", "copper", "white", "wooden")
    skin = look.surface(color, "metal")
    base = block(x, y, 0.006, 0.012, 0.001).move(z=0.012)
    feet = [cylinder(0.006, 0.013, 12).move(a * 0.42 * x, b * 0.38 * y) for a in (-1, 1)
            for b in (-1, 1)]  # fmt: skip
    count = 6
    at = [(k / (count - 1) - 0.5) * 0.88 * x for k in range(count)]
    hoops = [
        tube(
            smooth(
                [
                    (u, -0.42 * y, 0.015),
                    (u, -0.4 * y, 0.6 * h),
                    (u, 0, h),
                    (u, 0.4 * y, 0.6 * h),
                    (u, 0.42 * y, 0.015),
                ],
                4,
            ),
            0.0023,
            6,
        )
        for u in at
    ]
    loop = tube(smooth([(0, -0.012, h - 0.002), (0, -0.012, h + 0.02), (0, 0.012, h + 0.02),
                        (0, 0.012, h - 0.002)], 4), 0.0023, 6)  # fmt: skip
    pieces = [(join([base, *feet, *hoops, loop]), skin)]
    parts = [box_part(0.88 * x, 0.8 * y, 0.018), *(box_part(0.004, 0.8 * y, 0.7 * h, (u, 0, 0.016))
             for u in at)]  # fmt: skip
    slices = [
        block(0.09, 0.082, 0.011, 0.01).turn(1, np.pi / 2).move(0.5 * (a + b) - 0.0055, 0, 0.0615)
        for a, b in ((at[0], at[1]), (at[2], at[3]), (at[4], at[5]))
    ]
    chosen = slices[: int(look.rng.integers(0, 4))]
    if chosen:
        crust = textures.spots(look.rng, (214, 164, 98), (160, 104, 56), 0.3)
        pieces.append((join(chosen), crust))
        parts += [hull_of(s) for s in chosen]
    return shape(pieces, parts)


def lazy_susan(look: Look) -> Shape:
    """A round turning tray on a low foot."""
    r, h = look.between(0.17, 0.2), look.between(0.03, 0.04)
    color = look.color("wooden", "tan", "white", "black", "brown")
    skin = look.surface(color, "wood")
    foot = cylinder(0.55 * r, 0.5 * h, 32)
    disc = cylinder(r, 0.5 * h, 44, bevel=0.003).move(z=0.48 * h)
    ring = lathe([(0.96 * r, 0.97 * h), (r, 0.97 * h), (r, 1.12 * h), (0.96 * r, 1.12 * h)], 44,
                 loop=True)  # fmt: skip
    return shape(
        [
            (foot, textures.plain(tint_color(color, 0.5))),
            (disc, skin),
            (ring, textures.plain(tint_color(color, 0.75))),
        ],
        [cylinder_part(0.55 * r, 0.5 * h), cylinder_part(r, 0.5 * h, (0, 0, 0.48 * h))],
    )


CATEGORIES = (
    Category("gravy_boat", gravy_boat, (0.173, 0.0859, 0.0917), 0.35, ("sauce boat", "gravy jug",
             "sauceboat"), ("dining",), ("container",), ("white",)),
    Category("butter_dish", butter_dish, (0.164, 0.0991, 0.0943), 0.55, ("butter box",
             "butter keeper"), ("breakfast", "dining"), (), ("white", "sky")),
    Category("tureen", tureen, (0.293, 0.218, 0.191), 1.6, ("soup tureen", "soup terrine",
             "covered dish"), ("dining",), ("big", "round"), ("white",)),
    Category("serving_platter", serving_platter, (0.355, 0.243, 0.0267), 0.9, ("platter",
             "oval platter", "oval plate", "serving plate", "serving dish",
             "oval dish", "epergne"), ("dining",), ("support", "flat", "big"), ("white",)),
    Category("serving_bowl", serving_bowl, (0.256, 0.256, 0.0961), 0.8, ("fruit bowl", "bird bath"),
             ("dining",), ("container", "round", "big"), ("wooden",
             "white")),
    Category("cloche", cloche, (0.287, 0.287, 0.161), 0.9, ("food cover", "cake dome", "dome cover",
             "serving dome", "food dome", "cheese dome"), ("dining",), ("big", "round", "tall"),
             ("silver",)),
    Category("egg_cup", egg_cup, (0.0655, 0.0655, 0.0613), 0.1, ("eggcup", "egg holder",
             "egg stand"), ("breakfast",), ("container", "round"), ("white", "yellow")),
    Category("napkin_ring", napkin_ring, (0.102, 0.044, 0.0331), 0.04, ("serviette ring",
             "napkin band"), ("dining",), (), ("silver", "gold")),
    Category("toast_rack", toast_rack, (0.159, 0.0853, 0.124), 0.3, ("toast holder",),
             ("breakfast",), (), ("silver",)),
    Category("lazy_susan", lazy_susan, (0.375, 0.375, 0.0403), 1.2, ("turntable tray",
             "rotating tray"), ("dining",), ("support", "flat", "round", "big"), ("wooden",)),
)  # fmt: skip
"""The module's categories."""
