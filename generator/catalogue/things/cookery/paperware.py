"""Rolls, cloths and throwaway tableware: foil, paper towels, plates, cups, straws, mitts."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import spread
from ...build.outlines import smooth
from ...build.recipes import open_vessel
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look

CLOTH = ("red", "navy", "sage", "mustard", "white", "teal", "gray", "pink")


def _roll_box(look: Look, word: str, tile: textures.Tile, palette: tuple[str, ...]) -> Shape:
    """Return a long box of foil or film, a sheet pulled out over its front edge."""
    x, y, h = look.between(0.29, 0.32), look.between(0.046, 0.054), look.between(0.046, 0.054)
    color = look.color(*palette)
    face = prints.canvas(224, 40, color)
    prints.write(face, word, 0.5, 0.5, 0.6, readable_on(color), bold=True)
    prints.fill(face, 0, 0, 1, 0.1, tint_color(color, 1.5))
    body = box(x, y, h)
    front = box(x, 0.0008, h).move(y=-y / 2)
    top = box(x, y, 0.0008).move(z=h - 0.0002)
    teeth = box(x, 0.002, 0.006).move(y=-y / 2 - 0.001, z=0.55 * h)
    u, v = np.meshgrid(np.linspace(-0.46, 0.46, 8), np.linspace(0, 1, 7))
    fall = np.stack([u * x, -0.5 * y - 0.002 - 0.05 * v, 0.56 * h * (1 - v) ** 1.4 + 0.0006], -1)
    sheet = spread(fall[::-1], 0.0006)
    return shape([(body, textures.plain(tint_color(color, 0.9))), (front, face), (top, face),
                  (teeth, textures.plain((190, 194, 200))), (sheet, tile)],
                 [box_part(x, y, h)])  # fmt: skip


def foil_roll(look: Look) -> Shape:
    """A box of aluminium foil, a sheet of it pulled out."""
    foil = textures.noise(look.rng, 96, 96, (12, 12), 2)[..., None] * 26
    tile = np.clip(np.array((206, 209, 214)) + foil, 0, 255).astype(np.uint8)
    return _roll_box(look, "FOIL", tile, ("blue", "red", "navy", "green"))


def cling_film(look: Look) -> Shape:
    """A box of cling film, a clear sheet of it pulled out."""
    return _roll_box(look, "CLING FILM", textures.plain((222, 236, 240)),
                     ("green", "yellow", "teal", "purple"))  # fmt: skip


def paper_towel_roll(look: Look) -> Shape:
    """A roll of kitchen paper standing, alone or on a holder."""
    r, h = look.between(0.052, 0.064), look.between(0.22, 0.25)
    color = look.color("white", "white", "white", "cream")
    quilt = textures.grid(tint_color(color, 0.93), color, 14, 14, 128)
    roll = lathe([(0.3 * r, 0), (r, 0), (r, h), (0.3 * r, h)], 36, loop=True)
    core = lathe([(0.26 * r, 0), (0.31 * r, 0), (0.31 * r, h), (0.26 * r, h)], 24, loop=True)
    flap = box(0.0012, 0.05, h).move(r - 0.0006, -0.03, 0).turn(2, -0.4)
    brown = textures.plain((190, 156, 112))
    if look.chance(0.5):
        return shape([(join([roll, flap]), quilt), (core, brown)], [cylinder_part(r, h)])
    base = cylinder(1.25 * r, 0.014, 36, bevel=0.003)
    post = cylinder(0.1 * r, h + 0.045, 16).move(z=0.01)
    ball = cylinder(0.18 * r, 0.018, 18, bevel=0.004).move(z=h + 0.042)
    wood = look.surface(look.own_color("wooden", "black", "silver", "white"), "wood")
    return shape([(join([s.move(z=0.0135) for s in (roll, flap)]), quilt),
                  (core.move(z=0.0135), brown), (join([base, post, ball]), wood)],
                 [cylinder_part(1.25 * r, 0.014), cylinder_part(r, h, (0, 0, 0.0135)),
                  hull_of(ball)])  # fmt: skip


def paper_plate(look: Look) -> Shape:
    """A throwaway plate with a crimped rim."""
    r, h = look.between(0.1, 0.12), look.between(0.014, 0.019)
    color = look.color("white", "white", "red", "sky", "yellow", "pink", "tan")
    body = lathe([(0, 0), (0.66 * r, 0), (0.78 * r, 0.7 * h), (r, h), (0.99 * r, h),
                  (0.77 * r, 0.7 * h + 0.0015), (0.65 * r, 0.0016), (0, 0.0016)], 48)  # fmt: skip
    ribs = textures.stripes([color, tint_color(color, 0.93)], 48, upright=True, side=192)
    plain = textures.fit(textures.speckles(look.rng, color, 3), 64, 64)
    tile = textures.stack((plain, 26), (ribs, 24), (ribs, 24), (plain, 26), side=192)
    rim = [hull_part([(q * r * np.cos(a), q * r * np.sin(a), z) for a in np.linspace(
        k * np.pi / 6, (k + 1) * np.pi / 6, 3) for q, z in ((0.65, 0), (0.78, 0.7 * h), (1.0, h),
        (0.66, 0.002))]) for k in range(12)]  # fmt: skip
    return shape([(body, tile)], [cylinder_part(0.65 * r, 0.0018), *rim])


def plastic_cup(look: Look) -> Shape:
    """A throwaway cup with a rolled rim and grooves."""
    r, h = look.between(0.04, 0.047), look.between(0.095, 0.12)
    color = look.color("red", "red", "white", "blue", "clear", "yellow", "green", "orange")
    skin = look.surface(color, "plastic")
    side = [(0.7 * r, 0), (0.78 * r, 0.35 * h), (0.86 * r, 0.65 * h), (0.96 * r, h)]
    body, parts = open_vessel(side, 0.0016, 0.003, 32)
    rings = [torus(k * r, 0.0012, 32, 6).move(z=z * h) for k, z in ((0.755, 0.25), (0.8, 0.42),
             (0.845, 0.6))]  # fmt: skip
    rim = torus(0.965 * r, 0.0022, 36, 8).move(z=h - 0.002)
    inside = textures.plain((246, 246, 244)) if look.chance(0.7) else skin
    return shape([(body, textures.stack((skin, 50), (inside, 50))), (join([*rings, rim]), skin)],
                 parts)  # fmt: skip


def plastic_fork(look: Look) -> Shape:
    """A throwaway fork of white or coloured plastic, or of wood, lying."""
    long = look.between(0.155, 0.18)
    color = look.color("white", "white", "black", "clear", "red", "green", "tan")
    skin = look.surface(color, "plastic")
    palm = prism(np.array([(-0.34, -0.072), (-0.2, -0.078), (-0.1, -0.022), (0.0, -0.02), (0.5,
                  -0.045), (0.5, 0.045), (0, 0.02), (-0.1, 0.022), (-0.2, 0.078), (-0.34, 0.072)])
                 * long, 0.001, 0.0034)  # fmt: skip
    tines = [tube([(-0.33 * long, y * long, 0.0024), (-0.42 * long, y * long, 0.0016),
                   (-0.5 * long, y * long, 0.004)], [0.0016, 0.0014, 0.0006], 6)
             for y in (-0.06, -0.02, 0.02, 0.06)]  # fmt: skip
    rib = box(0.5 * long, 0.0022, 0.005).move(x=0.24 * long)
    return settle([(join([palm, *tines, rib]), skin)], 0.02)


def straw(look: Look) -> Shape:
    """A striped drinking straw lying, bent or straight."""
    long, r = look.between(0.19, 0.22), look.between(0.0028, 0.0036)
    color = look.color("red", "blue", "green", "pink", "black", "yellow", "teal")
    path = [(-0.5 * long, 0, 0), (0.2 * long, 0, 0), (0.5 * long, 0, 0)]
    if look.chance(0.5):
        path = [(-0.5 * long, 0, 0), (0.22 * long, 0, 0), (0.28 * long, 0.008, 0),
                (0.4 * long, 0.06, 0)]  # fmt: skip
    body = tube(smooth(path, 4), r, 10)
    y, x = np.mgrid[0:160, 0:32]
    band = ((x / 32 + 10 * y / 160) % 1) < 0.45
    tile = np.where(band[..., None], np.array(color), np.array((250, 248, 244))).astype(np.uint8)
    dark = [cylinder(0.72 * r, 0.0004, 10).turn(1, np.pi / 2).move(x=-0.5 * long - 0.0003)]
    return settle([(body, tile), (join(dark), textures.plain((60, 56, 56)))], 0.14)


def skewer(look: Look) -> Shape:
    """A bare skewer of wood or steel lying."""
    long = look.between(0.22, 0.27)
    color = look.color("tan", "wooden", "silver")
    skin = look.surface(color, "metal" if color[2] > 150 else "wood")
    rod = limb([(-0.5 * long, 0, 0), (-0.46 * long, 0, 0), (0, 0, 0), (0.5 * long, 0, 0)],
               [0.0003, 0.0016, 0.0017, 0.0017], 8)  # fmt: skip
    ring = torus(0.008, 0.0017, 18, 8).move(x=0.5 * long + 0.008)
    return settle([(rod, skin), (ring, skin)], 0.14)


def oven_mitt(look: Look) -> Shape:
    """A quilted oven mitt lying flat, its thumb to the front."""
    color = look.color(*CLOTH)
    k, h = look.between(0.92, 1.1), look.between(0.024, 0.03)
    hand = smooth(np.array([(-0.14, -0.065), (-0.05, -0.07), (0.01, -0.075), (0.05, -0.105),
                            (0.09, -0.1), (0.085, -0.07), (0.06, -0.045), (0.1, -0.04),
                            (0.135, -0.02), (0.14, 0.02), (0.12, 0.055), (0.07, 0.072),
                            (-0.04, 0.07), (-0.14, 0.065)]), 3) * k  # fmt: skip
    mid = np.array([0.0, -0.005])
    rings = np.stack(
        [
            np.column_stack([(hand - mid) * f + mid, np.full(len(hand), z)])
            for f, z in ((0.92, 0), (1.0, 0.3 * h), (1.0, 0.6 * h), (0.9, h))
        ]
    )
    body = loft(rings, hand)
    quilt = textures.grid(tint_color(color, 0.7), color, 12, 12, 128)
    cuff = box(0.024, 0.15 * k, 1.06 * h).move(x=-0.14 * k)
    loop = torus(0.014, 0.003, 16, 6).move(-0.14 * k - 0.018, 0.05 * k, 0.4 * h)
    other = textures.fabric(look.rng, look.own_color("white", "charcoal", "cream", "navy"))
    return shape([(body, quilt), (join([cuff, loop]), other)],
                 [hull_part(body.vertices[body.vertices[:, 1] > -0.078 * k]), hull_of(cuff),
                  hull_part(body.vertices[(body.vertices[:, 1] < -0.04 * k) & (
                      body.vertices[:, 0] > 0)])])  # fmt: skip


def pot_holder(look: Look) -> Shape:
    """A square quilted pot holder with a loop."""
    x, h = look.between(0.17, 0.2), look.between(0.009, 0.013)
    color = look.color(*CLOTH)
    quilt = textures.grid(tint_color(color, 0.72), color, 7, 7, 128)
    body = block(0.95 * x, 0.95 * x, h, 0.014, 0.004)
    hem = block(x, x, 0.6 * h, 0.018, 0.002).move(z=0.2 * h)
    loop = torus(0.016, 0.003, 16, 6).move(0.53 * x, 0.53 * x, 0.5 * h)
    other = textures.fabric(look.rng, look.own_color("white", "charcoal", "cream", "red"))
    return shape([(hem, other), (body, quilt), (loop, other)], [hull_of(body, hem)])


def tea_towel(look: Look) -> Shape:
    """A folded tea towel, striped or checked, lying."""
    x, y, h = look.between(0.21, 0.26), look.between(0.15, 0.18), look.between(0.014, 0.02)
    color = look.color("red", "navy", "sage", "teal", "mustard", "gray", "white")
    if look.chance(0.5):
        cloth = textures.fabric(look.rng, (244, 242, 234), color)
    else:
        cloth = np.asarray(textures.fabric(look.rng, (244, 242, 234))).copy()
        for u in (0.1, 0.15, 0.8, 0.85):
            prints.fill(cloth, u, 0, 0.03, 1, color)
    folds = [block(x, y * (1 - 0.012 * k), h / 4 * 0.98, 0.006, 0.0012).move(y=0.004 * k,
             z=h / 4 * k) for k in range(4)]  # fmt: skip
    roll = tube([(-0.49 * x, -0.5 * y, h / 2), (0.49 * x, -0.5 * y, h / 2)], h / 2, 10)
    return shape([(join([*folds, roll]), cloth)], [hull_of(*folds)])


def apron(look: Look) -> Shape:
    """A folded apron lying, its pocket up and its strings beside it."""
    x, y, h = look.between(0.24, 0.28), look.between(0.26, 0.3), look.between(0.014, 0.02)
    color = look.color("navy", "red", "black", "tan", "sage", "white", "gray")
    cloth = textures.fabric(look.rng, color)
    bib = prism(
        np.array(
            [
                (-0.5, -0.5),
                (0.5, -0.5),
                (0.5, 0.08),
                (0.3, 0.26),
                (0.26, 0.5),
                (-0.26, 0.5),
                (-0.3, 0.26),
                (-0.5, 0.08),
            ]
        )
        * [x, y],
        0,
        h,
        0,
    )
    pocket = box(0.55 * x, 0.3 * y, 0.003).move(y=-0.2 * y, z=h - 0.0008)
    seam = [box(0.0025, 0.3 * y, 0.0006).move(y=-0.2 * y, z=h + 0.002)]
    neck = tube(smooth([(-0.2 * x, 0.5 * y, h - 0.003), (-0.2 * x, 0.6 * y, 0.004), (0, 0.66 * y,
                 0.003), (0.2 * x, 0.6 * y, 0.004), (0.2 * x, 0.5 * y, h - 0.003)], 5), 0.004, 6,
                squash=0.5)  # fmt: skip
    ties = [tube(smooth([(s * 0.5 * x, 0.06 * y, 0.5 * h), (s * 0.62 * x, -0.02 * y, 0.002),
                         (s * 0.6 * x, -0.25 * y, 0.002)], 5), 0.0035, 6, squash=0.5)
            for s in (-1, 1)]  # fmt: skip
    dark = textures.fabric(look.rng, tint_color(color, 0.72))
    pale = textures.plain(tint_color(color, 1.4))
    return shape([(bib, cloth), (join([pocket, neck, *ties]), dark), (join(seam), pale)],
                 [hull_of(bib)])  # fmt: skip


_K = ("kitchen",)
CATEGORIES = (
    Category("foil_roll", foil_roll, (0.305, 0.103, 0.0509), 0.35, ("aluminium foil",
             "aluminum foil", "tin foil", "roll of foil", "foil", "roll of aluminium foil",
             "roll of aluminum foil", "aluminum foil roll", "aluminium foil roll", "baking paper",
             "parchment paper", "carrier bag roll"), _K, (), ("blue",), state="lying flat"),
    Category("cling_film", cling_film, (0.305, 0.101, 0.0513), 0.3, ("plastic wrap", "cling wrap",
             "food wrap", "roll of cling film", "saran wrap", "clingfilm", "roll of plastic wrap"),
             _K, (), ("green",), state="lying flat"),
    Category("paper_towel_roll", paper_towel_roll, (0.126, 0.136, 0.26), 0.3, ("paper towel",
             "kitchen roll", "roll of paper towels", "kitchen paper", "paper towel holder",
             "toilet paper", "roll of paper", "paper roll", "kitchen towel roll", "bin bag roll",
             "roll of bin bags", "newspaper roll"),
             _K, ("tall", "round"), ("white",)),
    Category("paper_plate", paper_plate, (0.223, 0.223, 0.0163), 0.012, ("disposable plate",
             "plastic plate", "party plate"), ("dining",), ("support", "flat", "round"), ("white",),
             state="lying flat"),
    Category("plastic_cup", plastic_cup, (0.0888, 0.0888, 0.103), 0.012, ("disposable plastic cup",
             "solo cup", "party cup"), ("dining",), ("container", "round", "tall"), ("red",)),
    Category("plastic_fork", plastic_fork, (0.171, 0.0267, 0.0049), 0.005, ("disposable fork",
             "plastic cutlery"), ("dining",), ("flat",), ("white",), state="lying flat"),
    Category("straw", straw, (0.196, 0.0433, 0.00538), 0.002, ("drinking straw", "paper straw",
             "plastic straw", "striped straw", "bendy straw", "paper straw bundle"), ("dining",),
             (), ("red",),
             state="lying flat"),
    Category("skewer", skewer, (0.27, 0.0194, 0.00298), 0.006, ("kebab skewer", "bamboo skewer"),
             _K, (), ("tan", "silver"), state="lying flat"),
    Category("oven_mitt", oven_mitt, (0.313, 0.179, 0.0282), 0.09, ("oven glove", "kitchen glove",
             "oven mitten", "baking glove", "baking mitt"), _K, ("flat", "big"), ("red",),
             state="lying flat"),
    Category("pot_holder", pot_holder, (0.208, 0.208, 0.0101), 0.05, ("potholder",
             "quilted pot holder"), _K, ("flat", "support"), ("red",), state="lying flat"),
    Category("tea_towel", tea_towel, (0.242, 0.183, 0.0177), 0.08, ("dish towel", "kitchen towel",
             "dishcloth", "dish cloth", "kitchen cloth", "dish rag", "folded tea towel",
             "cheesecloth"), _K,
             ("flat", "support"), ("red", "navy"), state="lying flat"),
    Category("apron", apron, (0.33, 0.329, 0.0201), 0.2, ("kitchen apron", "cooking apron",
             "chef apron"), _K, ("flat", "big"), ("navy", "red"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
