"""Objects of the ``living`` theme: weapons."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import BRASS_TONE, DARK, STEEL_TONE, metal, steel
from ...kit.outlines import ellipse
from ...kit.primitives import at_box, ball, drum, plate, rod
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down
from ...kit.solids import block, join, lathe, torus
from ...kit.surfaces import Look, plain, tint_color


@category("bullet_casing", size=(0.012, 0.012, 0.05), mass=0.008, material="metal",
          aliases=("bullet", "cartridge case", "shell casing", "bullet shell", "bullet cartridge",
          "rifle cartridge"), themes=("living",), colors=("brass",))  # fmt: skip
@from_pieces()
def bullet_casing(look: Look) -> Pieces:
    """An empty brass cartridge case standing upright, with a rimmed base and a narrower neck."""
    brass = metal(look, "brass", "gold", "copper")
    body = lathe([(0, 0), (0.006, 0), (0.006, 0.002), (0.0052, 0.003), (0.0058, 0.004),
                  (0.0056, 0.036), (0.0042, 0.042), (0.0042, 0.05), (0.0036, 0.05), (0.0036, 0.03),
                  (0, 0.03)], 20)  # fmt: skip
    return [(body, brass)]


@category("dagger", size=(0.293, 0.0763, 0.0193), mass=0.35, material="metal", assembled=True,
          aliases=("bronze dagger", "dirk", "poniard", "ceremonial dagger", "sword hilt",
          "short sword"), themes=("living",), roles=("flat",), colors=("brown",))  # fmt: skip
def dagger(look: Look) -> Shape:
    """A dagger lying flat: a pointed blade with a ridge, a guard, a grip and a pommel."""
    k = look.between(0.85, 1.2)
    color = look.color("brown", "black", "maroon", "wooden", "navy")
    rim = [(0.02, -0.014), (0.13, -0.011), (0.19, 0), (0.13, 0.011), (0.02, 0.014)]
    blade = plate(rim, 0.003, at=(0, 0, 0.006))
    ridge = plate([(0.02, -0.003), (0.17, 0), (0.02, 0.003)], 0.0045, at=(0, 0, 0.0052))
    guard = block(0.012, 0.075, 0.012, 0.003).move(0.014, 0, 0.0015)
    grip = rod([(0.01, 0, 0.0075), (-0.04, 0, 0.0075), (-0.08, 0, 0.0075)],
               [0.007, 0.0095, 0.007], 12)  # fmt: skip
    bands = [drum(0.0102, 0.003, (-0.02 - 0.02 * n, 0, 0.0075), 0, sides=14) for n in range(3)]
    pommel = ball(0.022, 0.022, 0.02, (-0.088, 0, 0.009), 14)
    hilt = steel(look, look.pick([BRASS_TONE, STEEL_TONE, (150, 110, 62)]))
    metal = look.pick([STEEL_TONE, (150, 110, 62), (160, 164, 168)])
    return put_down(
        [(join([blade, ridge]), steel(look, metal)), (join([guard, *bands, pommel]), hilt),
         (grip, surfaces.speckles(look.rng, color, 8))],
        blade, guard, grip, pommel, factor=k, foot=0.25,
    )  # fmt: skip


@category("flintlock_pistol", size=(0.257, 0.0876, 0.0262), mass=0.6, material="metal",
          aliases=("flintlock", "duelling pistol", "dueling pistol", "antique pistol",
          "pirate pistol", "starting pistol", "starter pistol"), themes=("living",),
          roles=("flat",), colors=("brown",))  # fmt: skip
def flintlock_pistol(look: Look) -> Shape:
    """A muzzle-loading pistol, lying on its side."""
    k = look.between(0.85, 1.15)
    color = look.color("brown", "wooden", "maroon")
    stock = plate([(-0.11, -0.045), (-0.085, -0.052), (-0.055, -0.018), (0.0, -0.006), (0.1, 0.0),
                 (0.1, 0.01), (-0.05, 0.012), (-0.085, -0.01)], 0.02, at=(0, 0, 0))  # fmt: skip
    barrel = drum(0.0085, 0.2, (-0.045, 0.014, 0.0105), 0, top=0.0075, sides=16)
    bore = drum(0.005, 0.0012, (0.1545, 0.014, 0.0105), 0, sides=12)
    lock = plate(ellipse(0.06, 0.018, 16), 0.004, at=(-0.03, 0.002, 0.019))
    cock = rod([(-0.035, 0.002, 0.023), (-0.04, 0.022, 0.024), (-0.026, 0.03, 0.024)], 0.0035, 8)
    guard = rod([(-0.045, -0.01, 0.01), (-0.03, -0.033, 0.01), (-0.005, -0.028, 0.01),
                 (0.0, -0.006, 0.01)], 0.002, 6)  # fmt: skip
    cap = ball(0.034, 0.022, 0.022, (-0.098, -0.048, 0.01), 12)
    bands = [at_box(0.008, 0.03, 0.022, (x, 0.008, 0)) for x in (0.045, 0.095)]
    return put_down(
        [(stock, surfaces.wood(look.rng, color)), (join([barrel, lock, cock]), steel(look)),
         (bore, plain(DARK)), (join([guard, cap, *bands]), steel(look, BRASS_TONE))],
        stock, barrel, guard, factor=k,
    )  # fmt: skip


@category("arrowhead", size=(0.0595, 0.0323, 0.00781), mass=0.015, material="stone",
          aliases=("flint arrowhead", "stone arrowhead", "spearhead", "flint spearhead",
          "arrow head", "spear head", "bronze spearhead"), themes=("living",), roles=("flat",),
          colors=("gray",))  # fmt: skip
def arrowhead(look: Look) -> Shape:
    """A barbed arrowhead of knapped flint, lying flat."""
    color = look.color("charcoal", "gray", "brown", "tan", "cream")
    k, w = look.between(0.8, 1.4), look.between(0.8, 1.2)
    half = [(0.032, 0), (0.012, 0.008), (-0.006, 0.0135), (-0.02, 0.016), (-0.015, 0.008),
            (-0.025, 0.006)]  # fmt: skip
    rim = np.array([*half, *[(x, -y) for x, y in half[:0:-1]]]) * [1, w]
    jag = 1 + 0.05 * np.array([look.between(-1, 1) for _ in rim])[:, None]
    base = plate(rim * jag, 0.0035)
    ridge = plate(0.62 * rim * jag, 0.0035, at=(0.001, 0, 0.0024))
    top = plate(0.24 * rim, 0.002, at=(0.001, 0, 0.0055))
    flint = surfaces.scratches(look.rng, color, tint_color(color, 1.3), 70)
    return put_down([(base, flint), (join([ridge, top]), surfaces.scratches(look.rng,
                                                                            tint_color(color, 1.12),
                                                                            tint_color(color, 0.8),
                                                                            70))], base, ridge,
                    factor=k)  # fmt: skip


@category("gauntlet", size=(0.189, 0.116, 0.0658), mass=0.6, material="metal",
          aliases=("armored glove", "knight's glove", "armoured glove", "steel glove"),
          themes=("living",), roles=("big",), colors=("silver",))  # fmt: skip
def gauntlet(look: Look) -> Shape:
    """A plate-armour gauntlet with a flared cuff, lying flat."""
    color = look.color("silver", "gray", "bronze", "charcoal")
    k = look.between(0.85, 1.1)
    cuff = [drum(0.036 + 0.006 * n, 0.04, (-0.045 - 0.036 * n, 0, 0.05), 0, top=0.034 + 0.004 * n)
            for n in range(2)]  # fmt: skip
    cuff = [one.scale(1, 1.1, 0.75) for one in cuff]
    hand = [ball(0.075, 0.085, 0.05, (0.02, 0, 0.03), 16)]
    plates = [at_box(0.02, 0.082 - 0.004 * n, 0.008, (0.0 + 0.018 * n, 0, 0.048 - 0.002 * n))
              for n in range(3)]  # fmt: skip
    fingers, joints = [], []
    for n in range(4):
        y = 0.03 - 0.02 * n
        fingers.append(rod([(0.045, y, 0.03), (0.085, y, 0.022), (0.11 - 0.006 * abs(n - 1), y,
                                                                  0.011)], 0.0105, 8))  # fmt: skip
        joints += [torus(0.0105, 0.002, 12, 5).turn(1, 1.2).move(x, y, z) for x,
                   z in ((0.06, 0.027), (0.082, 0.022))]  # fmt: skip
    thumb = rod([(0.0, 0.036, 0.026), (0.03, 0.06, 0.02), (0.06, 0.062, 0.012)], 0.0115, 8)
    metal = steel(look, color)
    return put_down(
        [
            (join([*cuff, *hand, *fingers, thumb]), metal),
            (join([*plates, *joints]), steel(look, tint_color(color, 0.75))),
        ],
        *cuff,
        *hand,
        join(fingers),
        thumb,
        factor=k,
        foot=0.3,
    )
