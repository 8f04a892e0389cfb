"""Objects of the ``toys`` theme: baby supplies."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse
from ...kit.parts import box_part
from ...kit.primitives import ball, pad, rod, straight
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import block, cylinder, join, lathe, prism, torus
from ...kit.surfaces import Look, tint_color

SOFT = ("sky", "pink", "mint", "lavender", "yellow", "teal", "coral", "orange")


@category("rattle", size=(0.163, 0.053, 0.051), mass=0.05, material="plastic",
          aliases=("baby rattle", "toy rattle", "rattle toy", "teether", "baby gym toy",
          "car seat toy"), themes=("toys",), colors=("sky", "pink"),
          state="lying flat")  # fmt: skip
def rattle(look: Look) -> Shape:
    """A baby rattle lying flat: a ball with bands and a handle with a ring at its end."""
    color = look.color(*SOFT)
    other = surfaces.plain(look.own_color(*SOFT))
    head = ball(0.052, 0.052, 0.052, (-0.045, 0, 0.0245), 18)
    band = cylinder(0.0268, 0.012, 20).move(z=-0.006).turn(1, np.pi / 2).move(-0.045, 0, 0.0245)
    grip = straight((-0.024, 0, 0.02), (0.045, 0, 0.011), [0.008, 0.006], 10)
    ring = torus(0.02, 0.006, 22, 8).move(0.064, 0, 0.0058)
    pieces: Pieces = [(head, surfaces.speckles(look.rng, color, 4)), (band, other), (ring, other),
                      (grip, surfaces.plain((246, 244, 238)))]  # fmt: skip
    return put_down(pieces, head, grip, ring, factor=look.between(0.9, 1.12))


@category("pacifier", size=(0.054, 0.055, 0.043), mass=0.02, material="plastic",
          aliases=("dummy", "baby pacifier", "soother", "baby dummy"), themes=("toys",),
          colors=("sky", "pink"), state="lying flat")  # fmt: skip
def pacifier(look: Look) -> Shape:
    """A baby's dummy lying on its shield, with the teat up and the ring at the side."""
    color = look.color(*SOFT)
    outline = ellipse(0.046, 0.036, 24) * (1 + 0.12 * np.abs(np.cos(np.linspace(0, 2 * np.pi, 24,
                                           endpoint=False))))[:, None]  # fmt: skip
    shield = prism(outline, 0, 0.005, 0.0).move(z=0.008)
    knob = cylinder(0.011, 0.009, 18)
    ring = torus(0.013, 0.0028, 20, 8).turn(0, np.pi / 2).turn(0, np.pi / 2 - 0.15)
    ring = ring.move(0, -0.016, 0.0045)
    teat = lathe([(0, 0), (0.006, 0), (0.005, 0.008), (0.009, 0.018), (0.008, 0.025), (0, 0.028)],
                 18).move(z=0.013)  # fmt: skip
    pieces: Pieces = [(shield, surfaces.speckles(look.rng, color, 4)),
                      (join([knob, ring]), surfaces.plain(tint_color(color, 1.4))),
                      (teat, surfaces.plain((232, 206, 160)))]  # fmt: skip
    return put_down(pieces, join([shield, knob]), ring, teat, factor=look.between(0.95, 1.15))


@category("baby_bottle", size=(0.059, 0.059, 0.161), mass=0.25, material="plastic",
          aliases=("feeding bottle", "nursing bottle", "baby milk bottle", "infant bottle",
          "bottle teat", "bottle warmer", "breast pump", "bottle steriliser", "nasal aspirator"),
          themes=("toys",), roles=("tall", "round"), colors=("sky", "pink"))  # fmt: skip
def baby_bottle(look: Look) -> Shape:
    """A baby's bottle of milk with a ring and a teat."""
    r, h = look.between(0.027, 0.032), look.between(0.1, 0.13)
    color = look.color(*SOFT)
    milk = lathe([(0, 0), (0.94 * r, 0), (r, 0.006), (r, 0.62 * h), (0, 0.62 * h)], 26)
    top = lathe([(0, 0.62 * h), (r, 0.62 * h), (r, 0.9 * h), (0.8 * r, h), (0, h)], 26)
    ring = cylinder(0.88 * r, 0.018, 26, bevel=0.002).move(z=h - 0.001)
    teat = lathe([(0, 0), (0.6 * r, 0), (0.5 * r, 0.01), (0.22 * r, 0.018), (0.2 * r, 0.028),
                  (0, 0.031)], 18).move(z=h + 0.016)  # fmt: skip
    marks = join([cylinder(1.006 * r, 0.0012, 26).move(z=z * h) for z in (0.2, 0.32, 0.44, 0.56)])
    pieces: Pieces = [(milk, surfaces.plain((250, 248, 240))),
                      (top, surfaces.plain((222, 232, 238))),
                      (ring, surfaces.speckles(look.rng, color, 3)), (marks, surfaces.plain(color)),
                      (teat, surfaces.plain((232, 206, 160)))]  # fmt: skip
    return put_down(pieces, join([milk, top]), ring, teat)


@category("bib", size=(0.2, 0.21, 0.007), mass=0.03, material="fabric", aliases=("baby bib",),
          themes=("toys",), roles=("flat",), colors=("white", "sky"),
          state="lying flat")  # fmt: skip
def bib(look: Look) -> Shape:
    """A baby's bib with a picture, lying flat."""
    color = look.color("white", *SOFT)
    other = look.own_color("red", "blue", "teal", "orange", "purple")
    a = np.linspace(-1.15, np.pi + 1.15, 24)
    outer = np.column_stack([0.09 * np.cos(a), 0.1 * np.sin(a) * -1.0])
    inner = np.column_stack([0.045 * np.cos(a), 0.045 * np.sin(a) * -1.0 + 0.038])
    outline = np.concatenate([outer, inner[::-1]])
    image = prints.canvas(96, 96, color)
    prints.disc(image, 0.5, 0.75, 0.16, other)
    for s in (-1, 1):
        prints.disc(image, 0.5 + s * 0.13, 0.6, 0.07, other)
        prints.disc(image, 0.5 + s * 0.06, 0.73, 0.02, (30, 30, 32))
    prints.disc(image, 0.5, 0.8, 0.06, tint_color(other, 1.6))
    cloth = prism(outline[::-1], 0, 0.004)
    rim = rod(np.column_stack([outer, np.full(24, 0.003)])[::2], 0.003, 6, 2)
    factor = look.between(0.95, 1.2)
    made = shape([(cloth, image), (rim, surfaces.plain(other))],
                 [box_part(0.14, 0.09, 0.004, (0, -0.05, 0)), box_part(0.03, 0.08, 0.004,
                  (-0.06, 0.02, 0)), box_part(0.03, 0.08, 0.004, (0.06, 0.02, 0))])  # fmt: skip
    return made.scale(factor)


@category("diaper", size=(0.165, 0.103, 0.031), mass=0.04, material="fabric",
          aliases=("nappy", "baby diaper", "folded diaper", "folded nappy", "bedpan pad"),
          themes=("toys",), roles=("flat",), colors=("white",), state="lying folded")  # fmt: skip
def diaper(look: Look) -> Shape:
    """A folded nappy with tapes and a printed band."""
    color = look.color("white", "white", "mint", "sky", "pink", "yellow")
    cloth = surfaces.fabric(look.rng, color)
    pads = [pad(0.16, 0.1, 0.016, 0.03, soft=0.5).move(z=0.013 * n) for n in range(2)]
    band = block(0.15, 0.022, 0.0014, 0.004).move(0, 0.032, 0.0285)
    image = prints.canvas(128, 24, tint_color(color, 1.1))
    for k in range(7):
        prints.disc(image, (k + 0.5) / 7, 0.5, 0.3, look.own_color(*SOFT))
    tapes = [block(0.03, 0.02, 0.0016, 0.006).move(s * 0.066, 0.032, 0.0292) for s in (-1, 1)]
    pieces: Pieces = [(join(pads), cloth), (band, image), (join(tapes), surfaces.plain((240, 240,
                      236)))]  # fmt: skip
    return put_down(pieces, join(pads), factor=look.between(0.9, 1.15))


@category("baby_shoes", size=(0.114, 0.1, 0.066), mass=0.06, material="fabric",
          aliases=("baby shoe", "bootie", "baby bootie", "pair of baby shoes", "baby booties",
          "baby bootee", "bootee", "booties"), themes=("toys",),
          colors=("pink", "sky"))  # fmt: skip
def baby_shoes(look: Look) -> Shape:
    """A pair of knitted baby shoes with bows, facing the viewer."""
    color = look.color(*SOFT, "white")
    knit = surfaces.knitting(look.rng, color, 16)
    bow = surfaces.plain(look.own_color("white", "red", "navy", "gold"))
    shoes, bows, hulls = [], [], []
    for s in (-1, 1):
        foot = ball(0.05, 0.1, 0.05, (s * 0.032, 0, 0.02), 18)
        cuff = lathe([(0, 0.03), (0.022, 0.03), (0.026, 0.062), (0.02, 0.066), (0.017, 0.05),
                      (0, 0.05)], 18).move(s * 0.032, 0.022)  # fmt: skip
        shoes += [foot, cuff]
        hulls += [foot, cuff]
        loops = [ball(0.016, 0.006, 0.01, (s * 0.032 + t * 0.008, -0.012, 0.047), 8)
                 for t in (-1, 1)]  # fmt: skip
        bows += [*loops, ball(0.007, 0.007, 0.007, (s * 0.032, -0.014, 0.047), 8)]
    return put_down([(join(shoes), knit), (join(bows), bow)], *hulls, factor=look.between(0.9, 1.1))
