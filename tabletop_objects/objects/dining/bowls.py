"""Objects of the ``dining`` theme: bowls."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import contents, glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import bowl_parts, box_part, cylinder_part, hull_of, open_vessel, stretch_parts
from ...kit.primitives import limb, scatter
from ...kit.shapes import Shape, category, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color


@category("punch_bowl", size=(0.298, 0.27, 0.173), mass=2.5, material="glass", hollow=True,
          aliases=("bowl of punch", "punchbowl", "glass punch bowl"), themes=("dining",),
          roles=("big",), colors=("pink",))  # fmt: skip
def punch_bowl(look: Look) -> Shape:
    """A wide glass bowl of pink punch with fruit and a ladle hooked over its rim."""
    k = look.between(0.92, 1.06)
    color = look.color("pink", "red", "orange", "clear")
    foot = lathe([(0, 0), (0.06, 0), (0.05, 0.012), (0.03, 0.022), (0, 0.022)], 28)
    bowl = lathe([(0, 0.02), (0.06, 0.022), (0.12, 0.06), (0.135, 0.12), (0.13, 0.12),
                  (0.114, 0.064), (0, 0.05)], 36)  # fmt: skip
    punch = cylinder(0.124, 0.003, 34).move(z=0.095)
    fruit = scatter(look, 0.09, 9, (0.03, 0.036), 0.099, stretch=(1, 1, 0.25))
    ladle = [limb([(0.03, 0, 0.1), (0.09, 0, 0.15), (0.145, 0, 0.17), (0.16, 0, 0.15)], [0.0035]
                  * 4, 8), ellipsoid(0.05, 0.05, 0.02, 16, 6).move(0.02, 0, 0.102)]  # fmt: skip
    steel = surfaces.brushed_metal(look.rng, (190, 194, 198))
    return shape([(join([foot, bowl]), surfaces.plain((216, 228, 232))),
                  (punch, surfaces.speckles(look.rng, color, 5)),
                  (fruit, surfaces.plain((246, 206, 80))), (join(ladle), steel)],
                 [hull_of(foot), hull_of(bowl), hull_of(*ladle)]).scale(k)  # fmt: skip


CHINA = ("white", "white", "cream", "sky", "navy", "sage", "terracotta", "black", "teal")


def china(look: Look, *palette: str) -> tuple[surfaces.Tile, surfaces.Tile]:
    """Return a tile that is decorated outside and plain inside, and a tile of the plain glaze."""
    color = look.color(*(palette or CHINA))
    plain = look.surface(color, "ceramic")
    return surfaces.stack((glaze_tile(look, color), 50), (plain, 50), side=160), plain


@category("gravy_boat", size=(0.173, 0.0859, 0.0917), mass=0.35, material="ceramic", hollow=True,
          aliases=("sauce boat", "gravy jug", "sauceboat"), themes=("dining",),
          roles=("container",), colors=("white",))  # fmt: skip
def gravy_boat(look: Look) -> Shape:
    """An oval gravy boat with a long lip on the left and a handle."""
    r, h = look.between(0.04, 0.047), look.between(0.07, 0.082)
    tile, plain = china(look)
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


@category("tureen", size=(0.293, 0.218, 0.191), mass=1.6, material="ceramic", hollow=True,
          aliases=("soup tureen", "soup terrine", "covered dish"), themes=("dining",),
          roles=("big", "round"), colors=("white",))  # fmt: skip
def tureen(look: Look) -> Shape:
    """A soup tureen with two handles, a domed lid, and a ladle whose handle sticks out."""
    r, h = look.between(0.095, 0.115), look.between(0.11, 0.13)
    tile, plain = china(look)
    body = lathe([(0, 0), (0.6 * r, 0), (0.58 * r, 0.1 * h), (0.82 * r, 0.3 * h), (r, 0.62 * h),
                  (0.97 * r, 0.96 * h), (r, h), (0, h)], 32)  # fmt: skip
    lid = lathe([(0, h), (0.98 * r, h), (0.96 * r, 1.06 * h), (0.7 * r, 1.25 * h),
                 (0.3 * r, 1.38 * h), (0, 1.4 * h)], 32)  # fmt: skip
    knob = ellipsoid(0.24 * r, 0.24 * r, 0.2 * r, 16, 10).move(z=1.46 * h)
    ears = [tube(smooth([(s * 0.95 * r, -0.03, 0.78 * h), (s * 1.28 * r, -0.02, 0.84 * h),
                         (s * 1.28 * r, 0.02, 0.84 * h), (s * 0.95 * r, 0.03, 0.78 * h)], 4),
                 0.006, 8) for s in (-1, 1)]  # fmt: skip
    rim = torus(0.985 * r, 0.004, 36, 6).move(z=h)
    tone = surfaces.plain(tint_color(look.own_color("navy", "gold", "teal", "white"), 1.0))
    return shape([(body, tile), (lid, tile), (join([knob, *ears]), plain), (rim, tone)],
                 [hull_of(body), hull_of(lid, knob), *(hull_of(e) for e in ears)])  # fmt: skip


@category("serving_bowl", size=(0.256, 0.256, 0.0961), mass=0.8, material="wood", hollow=True,
          aliases=("fruit bowl", "bird bath"), themes=("dining",),
          roles=("container", "round", "big"), colors=("wooden", "white"))  # fmt: skip
def serving_bowl(look: Look) -> Shape:
    """A large, deep serving bowl for salad or fruit, made of wood, glass or porcelain."""
    r, h = look.between(0.115, 0.14), look.between(0.085, 0.105)
    color = look.color("wooden", "white", "teal", "cream", "navy", "terracotta")
    plain = look.surface(color, look.pick(["wood", "ceramic"]))
    side = [(0.45 * r, 0), (0.72 * r, 0.22 * h), (0.92 * r, 0.6 * h), (r, h)]
    body, parts = open_vessel(side, 0.006, 0.008)
    return shape([(body, surfaces.stack((plain, 50), (look.surface(tint_color(color, 1.2),
                 "ceramic") if look.chance(0.3) else plain, 50)))], parts)  # fmt: skip


@category("ramekin", size=(0.092, 0.092, 0.049), mass=0.19, material="ceramic", hollow=True,
          aliases=("souffle dish", "custard cup", "creme brulee", "pudding cup", "custard dish",
          "dip bowl", "sauce dish"), themes=("dining", "kitchen"), roles=("container", "round"),
          colors=("white",))  # fmt: skip
def ramekin(look: Look) -> Shape:
    """A small fluted dish with straight sides, empty or with a custard or souffle."""
    r, h = look.between(0.042, 0.05), look.between(0.042, 0.055)
    color = look.color("white", "white", "cream", "red", "teal", "navy", "mustard", "black")
    body, parts = open_vessel([(0.92 * r, 0), (0.94 * r, 0.1 * h), (0.97 * r, 0.9 * h), (r, h)],
                              0.005, 0.006, 36)  # fmt: skip
    skin = look.surface(color, "ceramic")
    tone = surfaces.stripes([color, tint_color(color, 0.86)], 36, upright=True, side=144)
    smooth_band = surfaces.fit(skin, 144, 144)
    outside = surfaces.stack((tone, 80), (smooth_band, 20), side=144)
    pieces = [(body, surfaces.stack((outside, 50), (skin, 50), side=192))]
    if look.chance(0.4):
        tone = look.pick([(232, 190, 90), (104, 62, 40), (240, 222, 170)])
        fill = surfaces.spots(look.rng, tone, tint_color(tone, 0.6), 0.12)
        pieces.append((lathe([(0, 0.007), (0.85 * r, 0.007), (0.89 * r, 0.84 * h), (0, 0.88 * h)]),
                       fill))  # fmt: skip
    return shape(pieces, parts)


@category("bowl", size=(0.155, 0.155, 0.063), mass=0.35, material="ceramic", hollow=True,
          aliases=("dish", "salad bowl", "soup bowl", "rice bowl", "holy water font"),
          themes=("dining", "kitchen"), roles=("container", "round"),
          colors=("white", "cream", "teal", "blue"), common=True)  # fmt: skip
def bowl(look: Look) -> Shape:
    """An open bowl on a foot ring: round, conical, straight-sided or shallow."""
    r, h, wall = look.between(0.066, 0.09), look.between(0.05, 0.075), 0.005
    foot = look.between(0.4, 0.6) * r
    color = look.color(*("white", "white", "cream", "teal", "blue", "terracotta", "sage", "wooden",
                         "black"), *("pink", "mustard", "gray", "navy", "coral"))  # fmt: skip
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
    rim = surfaces.plain(tint_color(color, 0.5)) if look.chance(0.3) else inside
    tile = surfaces.stack((glaze_tile(look, color), 48), (rim, 4), (within, 48), side=192)
    wedges = bowl_parts(outer, inner[::-1])
    level = float(np.interp(0.7 * h, inner[::-1, 1], inner[::-1, 0])) + 0.0005
    held = contents(look, level, 0.7 * h) or []
    return shape([(body, tile), *held], [*wedges, cylinder_part(foot, 0.007)])
