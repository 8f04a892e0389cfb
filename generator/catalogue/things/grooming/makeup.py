"""Make-up, and what shapes nails, brows and lashes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.outlines import rectangle, smooth
from ...build.recipes import Pieces, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, loft, sweep, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

CASES = ("black", "pink", "gold", "navy", "coral", "silver", "white", "purple")
STEEL = (196, 200, 206)


def _metal(look: Look) -> textures.Tile:
    return textures.brushed_metal(look.rng, look.pick([STEEL, (206, 172, 96), (70, 72, 78)]))


def mascara(look: Look) -> Shape:
    """A mascara: its wand lies beside the closed tube's mouth, drawn out of it."""
    color = look.color(*CASES)
    r, long = look.between(0.0075, 0.0095), look.between(0.07, 0.085)
    case = cylinder(r, long, 20, bevel=0.001).turn(1, np.pi / 2).move(0.01, 0, 0.98 * r)
    neck = cylinder(0.55 * r, 0.008, 16).turn(1, -np.pi / 2).move(0.011, 0, 0.98 * r)
    y = 2.6 * r
    cap = cylinder(r, 0.055, 20, bevel=0.001).turn(1, np.pi / 2).move(0.02, y, 0.98 * r)
    wand = straight((0.021, y, 0.98 * r), (-0.02, y, 0.98 * r), 0.0011, 6)
    bristles = [
        torus(0.0024, 0.0011, 10, 4).turn(1, np.pi / 2).move(-0.045 + 0.0023 * n, y, 0.98 * r)
        for n in range(12)
    ]
    core = straight((-0.046, y, 0.98 * r), (-0.018, y, 0.98 * r), 0.0022, 6)
    pieces: Pieces = [(join([case, cap]), look.surface(color, "plastic")), (neck, _metal(look)),
                      (join([wand, core, *bristles]), textures.plain((40, 38, 42)))]  # fmt: skip
    return put_down(pieces, join([case, neck]), cap, join([wand, core]))


def eyeliner(look: Look) -> Shape:
    """An eyeliner pencil lying, its tip to the left, its cap beside the end."""
    color = look.color("black", "brown", "navy", "purple", "teal", "gold")
    long = look.between(0.11, 0.14)
    r = 0.0042
    h = long / 2
    stick = straight((-0.72 * h, 0, r), (h, 0, r), r, 12)
    wood = straight((-0.92 * h, 0, r), (-0.715 * h, 0, r), [0.0014, r], 12)
    tip = straight((-h, 0, r), (-0.915 * h, 0, r), [0.0003, 0.0014], 10)
    ring = straight((0.84 * h, 0, r), (0.88 * h, 0, r), 1.04 * r, 12)
    return put_down(
        [
            (stick, look.surface(color, "plastic")),
            (wood, textures.plain((222, 186, 140))),
            (tip, textures.plain(tint_color(color, 0.7))),
            (ring, _metal(look)),
        ],
        stick,
        wood,
        factor=look.between(0.95, 1.1),
        foot=0.4,
    )


def eyeshadow_palette(look: Look) -> Shape:
    """An open palette: pans of coloured powder, a mirror in the raised lid."""
    color = look.color(*CASES)
    columns = look.pick([3, 4, 5])
    x, y, t = 0.028 * columns + 0.012, 0.068, 0.01
    tray = block(x, y, t, 0.004, 0.0015)
    hue = look.pick(
        [(230, 180, 160), (180, 110, 150), (150, 120, 90), (120, 150, 180), (220, 140, 110)]
    )
    pans: list[tuple[Solid, textures.Tile]] = []
    for n in range(2 * columns):
        i, j = n % columns, n // columns
        tone = tint_color(hue, 0.45 + 1.2 * n / (2 * columns))
        shift = look.rng.uniform(-14, 14, 3)
        pan = cylinder(0.0115, 0.0014, 20).move((i - (columns - 1) / 2) * 0.028, (j - 0.5) * 0.031,
                                                t - 0.0006)  # fmt: skip
        tone = tuple(float(c) for c in np.clip(np.array(tone) + shift, 10, 250))
        pans.append((pan, textures.speckles(look.rng, tone, 6, 32)))  # type: ignore[arg-type]
    lid = (
        block(x, y, 0.006, 0.004, 0.001)
        .move(y=y / 2)
        .turn(0, 1.25)
        .move(y=y / 2 - 0.003, z=t - 0.002)
    )
    glass = block(x - 0.012, y - 0.014, 0.001, 0.003).move(y=y / 2, z=0.0056)
    glass = glass.turn(0, 1.25).move(y=y / 2 - 0.003, z=t - 0.002)
    sky = textures.gradient((170, 192, 206), (228, 238, 244), look.rng)
    case = look.surface(color, "plastic")
    return put_down([(tray, case), *pans, (lid, case), (glass, sky)], tray, lid)


def blusher(look: Look) -> Shape:
    """A round pot of blusher, its lid lying against it."""
    color = look.color(*CASES)
    r = look.between(0.026, 0.034)
    powder = look.pick([(230, 130, 130), (222, 150, 130), (206, 110, 120), (236, 170, 150)])
    base = cylinder(r, 0.011, 28, bevel=0.0015)
    pan = cylinder(0.84 * r, 0.0014, 26).move(z=0.0104)
    swirl = torus(0.5 * r, 0.0012, 24, 5).move(z=0.0118)
    lid = cylinder(r, 0.005, 28, bevel=0.001).turn(0, 0.32).move(0, 1.88 * r, 0)
    lid = lid.move(z=-float(lid.bounds[0, 2]))
    made = textures.speckles(look.rng, powder, 6)
    case = look.surface(color, "plastic")
    return put_down([(base, case), (pan, made), (swirl, textures.plain(tint_color(powder, 0.9))),
                    (lid, case)], base, lid)  # fmt: skip


def makeup_brush(look: Look) -> Shape:
    """A make-up brush lying: a long handle, a metal collar, a soft head to the left."""
    color = look.color("black", "pink", "wooden", "white", "gold", "purple", "teal")
    long = look.between(0.14, 0.18)
    h, wide = long / 2, look.between(0.009, 0.014)
    handle = rod(
        [(-0.1 * h, 0, 0.007), (0.3 * h, 0, 0.007), (h, 0, 0.006)], [0.006, 0.0062, 0.0028], 12
    )
    collar = straight((-0.42 * h, 0, 0.0075), (-0.08 * h, 0, 0.0072), [0.0072, 0.0062], 14)
    head = lathe([(0, 0), (0.0068, 0), (wide, 0.4 * h), (0.8 * wide, 0.53 * h), (0, 0.6 * h)], 18)
    head = head.turn(1, -np.pi / 2).move(-0.41 * h, 0, 0.92 * wide)
    hair = textures.scratches(look.rng, look.pick([(60, 44, 36), (206, 170, 130), (236, 220, 206)]),
                              (150, 110, 90), 90)  # fmt: skip
    return put_down([(handle, look.surface(color, "plastic")), (collar, _metal(look)), (head,
        hair)],
                   head, collar, handle)  # fmt: skip


def powder_puff(look: Look) -> Shape:
    """A round powder puff with a ribbon across."""
    color = look.color("pink", "white", "cream", "beige", "lavender", "black")
    r = look.between(0.03, 0.042)
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.22 * r), (0.92 * r, 0.42 * r), (0, 0.48 * r)], 28)
    band = box(1.9 * r, 0.014, 0.002).move(z=0.47 * r)
    fluff = textures.scratches(look.rng, color, tint_color(color, 0.9), 120)
    return put_down([(body, fluff), (band, textures.plain(tint_color(color, 0.75)))], body)


def makeup_bag(look: Look) -> Shape:
    """A zipped pouch standing, wider at its foot."""
    x, y, h = look.between(0.15, 0.19), look.between(0.06, 0.08), look.between(0.09, 0.11)
    color = look.color("pink", "navy", "black", "teal", "mustard", "coral", "sage", "gray")
    cloth = textures.fit(glaze_tile(look, color), 128, 128)
    outline = rectangle(1, 1, 0.28, 5)
    levels = [
        (0.94, 0.92, 0),
        (1.0, 1.0, 0.08),
        (1.0, 0.85, 0.5),
        (0.97, 0.4, 0.9),
        (0.95, 0.1, 1.0),
    ]
    body = loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), h * z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    zip_ = box(0.93 * x, 0.005, 0.005).move(z=h - 0.002)
    pull = join([torus(0.005, 0.0014, 14, 6), box(0.02, 0.006, 0.0025).move(0.014)]).turn(
        0, np.pi / 2
    )
    pull = pull.turn(1, 0.7).move(0.4 * x, -0.006, h - 0.004)
    return put_down([(body, cloth), (join([zip_, pull]), _metal(look))], body)


def tweezers(look: Look) -> Shape:
    """A pair of tweezers lying on its side."""
    color = look.color("silver", "pink", "black", "gold", "teal", "red")
    long = look.between(0.085, 0.105)
    h = long / 2
    arms = []
    for s in (-1, 1):
        path = smooth([(h, 0, 0.0045), (0.2 * h, s * 0.0058, 0.0045), (-0.6 * h, s * 0.005, 0.0045),
                       (-h, s * 0.0016, 0.0045)], 4)  # fmt: skip
        wide = np.interp(np.linspace(0, 1, len(path)), [0, 0.5, 0.85, 1], [1.0, 1.0, 0.7, 0.35])
        arms.append(_strip(path, wide))
    return put_down([(join(arms), look.surface(color, "metal"))], *arms)


def _strip(path: np.ndarray, wide: np.ndarray) -> Solid:
    """Return an upright strip 9 mm tall along a level path."""
    return sweep(path, rectangle(0.0014, 0.009), wide)


def nail_clippers(look: Look) -> Shape:
    """Nail clippers lying closed, the lever on top."""
    color = look.color("silver", "gold", "black", "pink", "blue")
    k = look.between(0.9, 1.2)
    steel = textures.brushed_metal(look.rng, STEEL)
    low = block(0.06, 0.012, 0.003, 0.003)
    jaws = block(0.014, 0.012, 0.009, 0.002, 0.001).move(-0.023)
    mid = block(0.055, 0.011, 0.002, 0.003).turn(1, 0.08).move(-0.002, 0, 0.006)
    lever = block(0.05, 0.01, 0.0026, 0.004).turn(1, -0.06).move(0.004, 0, 0.0112)
    post = cylinder(0.003, 0.016, 12).move(-0.017)
    return put_down([(join([low, jaws, mid, post]), steel), (lever, look.surface(color, "metal"))],
                   join([low, jaws]), join([mid, lever, post]), factor=k)  # fmt: skip


def eyelash_curler(look: Look) -> Shape:
    """An eyelash curler lying: two ring handles and a curved clamp."""
    color = look.color("silver", "gold", "pink", "black", "copper")
    metal = look.surface(color, "metal")
    rings = [
        torus(0.0125, 0.002, 22, 6).scale(1.3, 1, 1).move(0.04, s * 0.0165, 0.002) for s in (-1, 1)
    ]
    stems = [rod([(0.024, s * 0.012, 0.002), (0, -s * 0.002, 0.002), (-0.028, -s * 0.009, 0.003)],
                 0.0019, 7) for s in (-1, 1)]  # fmt: skip
    arch = [rod([(-0.03, -0.016, z), (-0.036, -0.008, z), (-0.038, 0, z), (-0.036, 0.008, z),
                 (-0.03, 0.016, z)], 0.002, 7) for z in (0.002, 0.014)]  # fmt: skip
    posts = [
        straight((-0.03, s * 0.016, 0.002), (-0.03, s * 0.016, 0.014), 0.0018, 6) for s in (-1, 1)
    ]
    rubber = rod(
        [(-0.0335, -0.013, 0.0052), (-0.038, 0, 0.0052), (-0.0335, 0.013, 0.0052)], 0.0018, 6
    )
    return put_down([(join([*rings, *stems, *arch, *posts]), metal),
                    (rubber, textures.plain((40, 40, 44)))], join(rings), join(stems),
                   join([*arch, *posts]), factor=look.between(0.95, 1.15))  # fmt: skip


def bath_bomb(look: Look) -> Shape:
    """A bath bomb: a rough ball with a seam and petals."""
    color = look.color("pink", "lavender", "yellow", "sky", "mint", "orange")
    d = look.between(0.055, 0.07)
    body = ellipsoid(d, d, d, 24, 14).move(z=0.475 * d)
    seam = cylinder(0.512 * d, 0.003, 28).move(z=0.474 * d)
    skin = textures.spots(
        look.rng, color, look.own_color("white", "purple", "yellow", "pink"), 0.14
    )
    return put_down([(body, skin), (seam, textures.plain(tint_color(color, 0.9)))], body)


CATEGORIES = (
    Category("mascara", mascara, (0.13, 0.042, 0.0172), 0.02, ("mascara tube", "mascara wand",
             "mascara brush"), ("vanity",), (), ("black", "pink"), state="lying"),
    Category("eyeliner", eyeliner, (0.128, 0.0089, 0.0089), 0.006, ("eye liner",
             "eyeliner pencil", "eyebrow pencil", "lip liner", "kohl pencil", "makeup pencil",
             "lip pencil"), ("vanity",), (), ("black",), state="lying"),
    Category("eyeshadow_palette", eyeshadow_palette, (0.124, 0.09, 0.075), 0.09, ("eyeshadow",
             "eye shadow", "eye shadow palette", "makeup palette", "make up palette",
             "cosmetic palette"), ("vanity",), (), ("black", "pink"), state="standing open"),
    Category("blusher", blusher, (0.0624, 0.119, 0.0237), 0.04, ("blush", "blush pot", "rouge",
             "highlighter powder", "blusher compact"), ("vanity",), (), ("pink",)),
    Category("makeup_brush", makeup_brush, (0.16, 0.0215, 0.0205), 0.015, ("make-up brush",
             "make up brush", "powder brush", "cosmetic brush", "blush brush",
             "foundation brush", "lens brush", "beard brush", "blower brush", "tint brush",
             "blusher brush", "kabuki brush", "nail art brush", "blending brush", "eyeshadow brush",
             "lip brush"),
             ("vanity",), (), ("black", "pink"), state="lying"),
    Category("powder_puff", powder_puff, (0.072, 0.072, 0.0178), 0.006, ("puff",
             "makeup sponge", "beauty sponge"), ("vanity",), ("round",), ("pink",)),
    Category("makeup_bag", makeup_bag, (0.17, 0.07, 0.1), 0.12, ("make-up bag", "cosmetic bag",
             "cosmetics bag", "make up bag", "toiletry bag", "wash bag", "toiletries bag",
             "zipper pouch", "dopp kit",
             "vanity case"), ("vanity",), (), ("pink", "navy")),
    Category("tweezers", tweezers, (0.095, 0.013, 0.009), 0.015, ("pair of tweezers", "tweezer",
             "eyebrow tweezers", "forceps", "epilator", "spudger", "haemostat", "hemostat",
             "tick remover", "needle holder", "tweezer set"),
             ("vanity",), (), ("silver",),
             state="lying"),
    Category("nail_clippers", nail_clippers, (0.063, 0.0126, 0.0168), 0.03, ("nail clipper",
             "nail cutter", "toenail clippers", "fingernail clippers"), ("vanity",), (),
             ("silver",), state="lying"),
    Category("eyelash_curler", eyelash_curler, (0.103, 0.065, 0.017), 0.04, ("lash curler",),
             ("vanity",), (), ("silver", "gold"), state="lying"),
    Category("bath_bomb", bath_bomb, (0.063, 0.063, 0.062), 0.12, ("bath fizzer", "bath ball"),
             ("vanity",), (), ("pink", "lavender")),
)  # fmt: skip
"""The module's categories."""
