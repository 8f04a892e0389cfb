"""Objects of the ``vanity`` theme: makeup."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import rectangle
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import rod, straight
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, prism, torus
from ...kit.surfaces import Look, tint_color

CASES = ("black", "pink", "gold", "navy", "coral", "silver", "white", "purple")
STEEL = (196, 200, 206)


def _metal(look: Look) -> surfaces.Tile:
    return surfaces.brushed_metal(look.rng, look.pick([STEEL, (206, 172, 96), (70, 72, 78)]))


@category("mascara", size=(0.13, 0.042, 0.0172), mass=0.02, material="plastic", assembled=True,
          aliases=("mascara tube", "mascara wand", "mascara brush"), themes=("vanity",),
          colors=("black", "pink"), state="lying")  # fmt: skip
def mascara(look: Look) -> Shape:
    """A closed tube of mascara with its wand beside it."""
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
                      (join([wand, core, *bristles]), surfaces.plain((40, 38, 42)))]  # fmt: skip
    return put_down(pieces, join([case, neck]), cap, join([wand, core]))


@category("eyeliner", size=(0.128, 0.0089, 0.0089), mass=0.006, material="plastic",
          aliases=("eye liner", "eyeliner pencil", "eyebrow pencil", "lip liner", "kohl pencil",
          "makeup pencil", "lip pencil"), themes=("vanity",), colors=("black",),
          state="lying")  # fmt: skip
def eyeliner(look: Look) -> Shape:
    """An eyeliner pencil lying flat, with its tip on the left and a band near its other end."""
    color = look.color("black", "brown", "navy", "purple", "teal", "gold")
    long = look.between(0.11, 0.14)
    r = 0.0042
    h = long / 2
    stick = straight((-0.72 * h, 0, r), (h, 0, r), r, 12)
    wood = straight((-0.92 * h, 0, r), (-0.715 * h, 0, r), [0.0014, r], 12)
    tip = straight((-h, 0, r), (-0.915 * h, 0, r), [0.0003, 0.0014], 10)
    ring = straight((0.84 * h, 0, r), (0.88 * h, 0, r), 1.04 * r, 12)
    return put_down([(stick, look.surface(color, "plastic")),
                     (wood, surfaces.plain((222, 186, 140))),
                     (tip, surfaces.plain(tint_color(color, 0.7))), (ring, _metal(look))], stick,
                    wood, factor=look.between(0.95, 1.1), foot=0.4)  # fmt: skip


@category("eyeshadow_palette", size=(0.124, 0.09, 0.075), mass=0.09, material="plastic",
          aliases=("eyeshadow", "eye shadow", "eye shadow palette", "makeup palette",
          "make up palette", "cosmetic palette"), themes=("vanity",), colors=("black", "pink"),
          state="standing open")  # fmt: skip
def eyeshadow_palette(look: Look) -> Shape:
    """An open palette with pans of coloured powder and a mirror in its raised lid."""
    color = look.color(*CASES)
    columns = look.pick([3, 4, 5])
    x, y, t = 0.028 * columns + 0.012, 0.068, 0.01
    tray = block(x, y, t, 0.004, 0.0015)
    hue = look.pick(
        [(230, 180, 160), (180, 110, 150), (150, 120, 90), (120, 150, 180), (220, 140, 110)]
    )
    pans: list[tuple[Solid, surfaces.Tile]] = []
    for n in range(2 * columns):
        i, j = n % columns, n // columns
        tone = tint_color(hue, 0.45 + 1.2 * n / (2 * columns))
        shift = look.rng.uniform(-14, 14, 3)
        pan = cylinder(0.0115, 0.0014, 20).move((i - (columns - 1) / 2) * 0.028, (j - 0.5) * 0.031,
                                                t - 0.0006)  # fmt: skip
        tone = tuple(float(c) for c in np.clip(np.array(tone) + shift, 10, 250))
        pans.append((pan, surfaces.speckles(look.rng, tone, 6, 32)))  # type: ignore[arg-type]
    lid = (block(x, y, 0.006, 0.004, 0.001).move(y=y / 2).turn(0, 1.25).move(y=y / 2 - 0.003, z=t
                                                                             - 0.002))  # fmt: skip
    glass = block(x - 0.012, y - 0.014, 0.001, 0.003).move(y=y / 2, z=0.0056)
    glass = glass.turn(0, 1.25).move(y=y / 2 - 0.003, z=t - 0.002)
    sky = surfaces.gradient((170, 192, 206), (228, 238, 244), look.rng)
    case = look.surface(color, "plastic")
    return put_down([(tray, case), *pans, (lid, case), (glass, sky)], tray, lid)


@category("blusher", size=(0.0624, 0.119, 0.0237), mass=0.04, material="plastic",
          aliases=("blush", "blush pot", "rouge", "highlighter powder", "blusher compact"),
          themes=("vanity",), colors=("pink",))  # fmt: skip
def blusher(look: Look) -> Shape:
    """A round pot of blusher with its lid leaning on it."""
    color = look.color(*CASES)
    r = look.between(0.026, 0.034)
    powder = look.pick([(230, 130, 130), (222, 150, 130), (206, 110, 120), (236, 170, 150)])
    base = cylinder(r, 0.011, 28, bevel=0.0015)
    pan = cylinder(0.84 * r, 0.0014, 26).move(z=0.0104)
    swirl = torus(0.5 * r, 0.0012, 24, 5).move(z=0.0118)
    lid = cylinder(r, 0.005, 28, bevel=0.001).turn(0, 0.32).move(0, 1.88 * r, 0)
    lid = lid.move(z=-float(lid.bounds[0, 2]))
    made = surfaces.speckles(look.rng, powder, 6)
    case = look.surface(color, "plastic")
    return put_down([(base, case), (pan, made), (swirl, surfaces.plain(tint_color(powder, 0.9))),
                    (lid, case)], base, lid)  # fmt: skip


@category("makeup_brush", size=(0.16, 0.0215, 0.0205), mass=0.015, material="wood",
          aliases=("make-up brush", "make up brush", "powder brush", "cosmetic brush",
          "blush brush", "foundation brush", "lens brush", "beard brush", "blower brush",
          "tint brush", "blusher brush", "kabuki brush", "nail art brush", "blending brush",
          "eyeshadow brush", "lip brush"), themes=("vanity",), colors=("black", "pink"),
          state="lying")  # fmt: skip
def makeup_brush(look: Look) -> Shape:
    """A make-up brush lying flat: a long handle, a metal collar and a soft head on the left."""
    color = look.color("black", "pink", "wooden", "white", "gold", "purple", "teal")
    long = look.between(0.14, 0.18)
    h, wide = long / 2, look.between(0.009, 0.014)
    handle = rod(
        [(-0.1 * h, 0, 0.007), (0.3 * h, 0, 0.007), (h, 0, 0.006)], [0.006, 0.0062, 0.0028], 12
    )
    collar = straight((-0.42 * h, 0, 0.0075), (-0.08 * h, 0, 0.0072), [0.0072, 0.0062], 14)
    head = lathe([(0, 0), (0.0068, 0), (wide, 0.4 * h), (0.8 * wide, 0.53 * h), (0, 0.6 * h)], 18)
    head = head.turn(1, -np.pi / 2).move(-0.41 * h, 0, 0.92 * wide)
    hair = surfaces.scratches(look.rng, look.pick([(60, 44, 36), (206, 170, 130), (236, 220, 206)]),
                              (150, 110, 90), 90)  # fmt: skip
    return put_down([(handle, look.surface(color, "plastic")), (collar, _metal(look)), (head,
        hair)],
                   head, collar, handle)  # fmt: skip


@category("powder_puff", size=(0.072, 0.072, 0.0178), mass=0.006, material="fabric",
          aliases=("puff", "makeup sponge", "beauty sponge"), themes=("vanity",), roles=("round",),
          colors=("pink",))  # fmt: skip
def powder_puff(look: Look) -> Shape:
    """A round powder puff with a ribbon across it."""
    color = look.color("pink", "white", "cream", "beige", "lavender", "black")
    r = look.between(0.03, 0.042)
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.22 * r), (0.92 * r, 0.42 * r), (0, 0.48 * r)], 28)
    band = box(1.9 * r, 0.014, 0.002).move(z=0.47 * r)
    fluff = surfaces.scratches(look.rng, color, tint_color(color, 0.9), 120)
    return put_down([(body, fluff), (band, surfaces.plain(tint_color(color, 0.75)))], body)


@category("makeup_bag", size=(0.17, 0.07, 0.1), mass=0.12, material="fabric",
          aliases=("make-up bag", "cosmetic bag", "cosmetics bag", "make up bag", "toiletry bag",
          "wash bag", "toiletries bag", "zipper pouch", "dopp kit", "vanity case"),
          themes=("vanity",), colors=("pink", "navy"))  # fmt: skip
def makeup_bag(look: Look) -> Shape:
    """An upright, zipped make-up bag, wider at the bottom."""
    x, y, h = look.between(0.15, 0.19), look.between(0.06, 0.08), look.between(0.09, 0.11)
    color = look.color("pink", "navy", "black", "teal", "mustard", "coral", "sage", "gray")
    cloth = surfaces.fit(glaze_tile(look, color), 128, 128)
    outline = rectangle(1, 1, 0.28, 5)
    levels = [(0.94, 0.92, 0), (1.0, 1.0, 0.08), (1.0, 0.85, 0.5), (0.97, 0.4, 0.9),
              (0.95, 0.1, 1.0)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), h * z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    zip_ = box(0.93 * x, 0.005, 0.005).move(z=h - 0.002)
    pull = join([torus(0.005, 0.0014, 14, 6), box(0.02, 0.006, 0.0025).move(0.014)]).turn(
        0, np.pi / 2
    )
    pull = pull.turn(1, 0.7).move(0.4 * x, -0.006, h - 0.004)
    return put_down([(body, cloth), (join([zip_, pull]), _metal(look))], body)


@category("eyelash_curler", size=(0.103, 0.065, 0.017), mass=0.04, material="metal",
          aliases=("lash curler",), themes=("vanity",), colors=("silver", "gold"),
          state="lying")  # fmt: skip
def eyelash_curler(look: Look) -> Shape:
    """An eyelash curler lying flat: two ring handles and a curved clamp."""
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
                    (rubber, surfaces.plain((40, 40, 44)))], join(rings), join(stems),
                   join([*arch, *posts]), factor=look.between(0.95, 1.15))  # fmt: skip


@category("foundation", size=(0.034, 0.034, 0.1), mass=0.12, material="glass",
          aliases=("foundation bottle", "liquid foundation", "concealer", "makeup foundation"),
          themes=("vanity",), roles=("tall",), colors=("beige",))  # fmt: skip
def foundation(look: Look) -> Shape:
    """A glass bottle of skin-coloured foundation with a black or gold cap."""
    color = look.color("beige", "tan", "bronze", "cream", "brown")
    x, h = look.between(0.03, 0.038), look.between(0.06, 0.075)
    body = block(x, x, h, 0.006, 0.003)
    cap = cylinder(0.38 * x, 0.034, 22, bevel=0.001).move(z=h - 0.002)
    label = box(0.8 * x, 0.001, 0.2 * h).move(0, -x / 2, 0.4 * h)
    lid = surfaces.plain(look.pick([(36, 36, 40), (206, 172, 96), (240, 240, 238)]))
    return put_down([(body, surfaces.plain(color)), (cap, lid),
                     (label, surfaces.plain((40, 36, 34)))], body, cap)  # fmt: skip


@category("lipstick", size=(0.022, 0.022, 0.083), mass=0.025, material="plastic",
          aliases=("glitter tube", "lip gloss", "lip balm", "lip stain", "lipgloss", "chapstick",
          "lip salve", "brow gel"), themes=("vanity",), roles=("round",), colors=("black", "gold"),
          common=True)  # fmt: skip
def lipstick(look: Look) -> Shape:
    """An open lipstick standing upright: a tube, a ring and a coloured stick with a slanted tip."""
    case = surfaces.speckles(look.rng, look.color("black", "gold", "white", "navy"), 3)
    ring = surfaces.brushed_metal(look.rng, look.own_color("gold", "silver"))
    pigment = surfaces.plain(look.own_color("red", "crimson", "pink", "coral", "magenta"))
    base = cylinder(0.011, 0.042, 20, bevel=0.001)
    middle = cylinder(0.0092, 0.018, 20).move(z=0.042)
    stick = cylinder(0.0068, 0.02, 18).bend(
        lambda p: np.column_stack(
            [p[:, :2], np.where(p[:, 2] > 0.01, p[:, 2] + 0.5 * p[:, 1] + 0.003, p[:, 2])]
        )
    )
    return shape(
        [(base, case), (middle, ring), (stick.move(z=0.06), pigment)],
        [cylinder_part(0.011, 0.042), cylinder_part(0.0085, 0.04, (0, 0, 0.042))],
    )


@category("hand_mirror", size=(0.23, 0.116, 0.0125), mass=0.2, material="wood",
          aliases=("mirror", "handheld mirror"), themes=("vanity",), roles=("flat",),
          colors=("gold", "silver"), state="lying flat", common=True)  # fmt: skip
def hand_mirror(look: Look) -> Shape:
    """A round or oval hand mirror, lying face up."""
    frame = look.surface(
        look.color("gold", "silver", "pink", "white", "black", "teal", "brown"), "plastic"
    )
    sky = surfaces.gradient((176, 196, 208), (226, 236, 242), look.rng)
    r, long, oval = look.between(0.046, 0.062), look.between(0.09, 0.13), look.between(1.0, 1.3)
    wide, at = look.between(0.015, 0.024), -0.055
    back = cylinder(r, 0.011, 32, bevel=0.003).scale(oval, 1, 1).move(x=at)
    glass = cylinder(0.84 * r, 0.002, 32).scale(oval, 1, 1).move(x=at, z=0.0105)
    middle = at + oval * r + 0.46 * long
    grip = prism(rectangle(long, wide, 0.45 * wide), 0, 0.011, 0.003).move(x=middle)
    return shape(
        [(back, frame), (glass, sky), (grip, frame)],
        [hull_of(back), hull_of(glass), box_part(long, wide, 0.011, (middle, 0, 0))],
    )


@category("nail_polish", size=(0.028, 0.028, 0.07), mass=0.04, material="glass",
          aliases=("nail varnish", "nail polish bottle", "nail polish remover"), themes=("vanity",),
          colors=("red", "pink"), common=True)  # fmt: skip
def nail_polish(look: Look) -> Shape:
    """A small square bottle of nail polish with a tall black cap."""
    color = look.color("red", "pink", "violet", "coral", "navy", "teal", "gold")
    body = block(0.028, 0.028, 0.034, 0.006, 0.003)
    cap = cylinder(0.0085, 0.036, 16, top=0.0065, bevel=0.001).move(z=0.034)
    lid = surfaces.speckles(look.rng, look.own_color("black", "black", "white", "gold"), 3)
    return shape(
        [(body, surfaces.speckles(look.rng, color, 5)), (cap, lid)],
        [box_part(0.028, 0.028, 0.034), cylinder_part(0.0085, 0.036, (0, 0, 0.034))],
    )


@category("makeup_compact", size=(0.074, 0.095, 0.08), mass=0.07, material="plastic",
          aliases=("compact", "powder compact", "powder", "makeup", "face powder compact",
          "blush compact", "compact mirror", "bronzer", "face powder", "pressed powder",
          "foundation compact"), themes=("vanity",), colors=("black", "pink"),
          state="standing open", common=True)  # fmt: skip
def makeup_compact(look: Look) -> Shape:
    """An open compact with powder below and a mirror in its upright lid."""
    r, t = look.between(0.034, 0.039), 0.009
    case = surfaces.speckles(look.rng, look.color("black", "pink", "gold", "white"), 3)
    powder = surfaces.speckles(look.rng, look.own_color("tan", "beige", "coral", "pink"), 6)
    sky = surfaces.gradient((170, 192, 206), (228, 238, 244), look.rng)
    lift = np.deg2rad(72)
    base = cylinder(r, t, 28, bevel=0.002)
    pan = cylinder(r * 0.84, 0.0015, 28).move(z=t - 0.0005)
    lid = cylinder(r, 0.006, 28, bevel=0.001).move(y=r).turn(0, lift).move(y=r - 0.003, z=t)
    glass = cylinder(r * 0.86, 0.0012, 28).move(y=r, z=0.0053).turn(0, lift)
    glass = glass.move(y=r - 0.003, z=t)
    return shape([(base, case), (pan, powder), (lid, case), (glass, sky)],
                 [cylinder_part(r, t), hull_of(lid)])  # fmt: skip
