"""Objects of the ``dining`` theme: boxes."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle
from ...kit.parts import box_part, hull_of
from ...kit.primitives import ball, limb, scatter
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, loft, prism
from ...kit.surfaces import Look, tint_color
from ..kitchen.bags import panel


@category("bento_box", size=(0.225, 0.163, 0.0482), mass=0.6, material="plastic",
          aliases=("bento", "japanese lunch box", "airline meal"), themes=("dining",),
          roles=("edible",), colors=("black", "red"))  # fmt: skip
def bento_box(look: Look) -> Shape:
    """An open lacquered box with compartments for rice, fish, egg and greens."""
    x, y, h = look.between(0.21, 0.25), look.between(0.15, 0.17), look.between(0.045, 0.055)
    color = look.color("black", "black", "red", "maroon", "wooden", "navy")
    skin = look.surface(color, "plastic")
    walls = [box(x, 0.006, h).move(y=s * (y / 2 - 0.003)) for s in (-1, 1)]
    walls += [box(0.006, y - 0.012, h).move(x=s * (x / 2 - 0.003)) for s in (-1, 1)]
    walls += [box(0.005, y - 0.012, 0.85 * h).move(x=0.02), box(0.5 * x - 0.02, 0.005, 0.85 * h)
              .move(0.26 * x + 0.007, 0.01)]  # fmt: skip
    floor = box(x, y, 0.006)
    z = 0.55 * h
    rice = block(0.5 * x, 0.88 * y, z, 0.01, 0.006).move(-0.225 * x, 0, 0.006)
    plum = ellipsoid(0.024, 0.024, 0.016, 16, 8).move(-0.22 * x, 0, z + 0.009)
    fish = [block(0.026, 0.055, 0.01, 0.008, 0.003).turn(1, -0.3).move(0.14 * x + 0.024 * k,
            0.26 * y, z) for k in range(3)]  # fmt: skip
    egg = [block(0.02, 0.03, 0.022, 0.005, 0.003).move(0.16 * x + 0.022 * k, -0.16 * y, 0.4 * z)
           for k in range(2)]  # fmt: skip
    green = scatter(look, 0.022, 9, (0.014, 0.018), z).move(0.38 * x, -0.2 * y)
    fill = box(0.36 * x, 0.86 * y, 0.75 * z).move(0.27 * x, 0, 0.006)
    return shape(
        [(join([*walls, floor]), skin),
         (rice, surfaces.spots(look.rng, (248, 246, 238), (226, 222, 210), 0.3)),
         (plum, surfaces.plain((190, 40, 56))), (join(fish), surfaces.plain((240, 128, 96))),
         (join(egg), surfaces.plain((248, 208, 80))), (green, surfaces.plain((96, 158, 70))),
         (fill, surfaces.plain((120, 150, 84)))],
        [box_part(x, y, h)],
    )  # fmt: skip


@category("pizza_box", size=(0.323, 0.325, 0.0403), mass=0.35, material="paper",
          aliases=("pizza carton", "box of pizza", "boxed pizza"), themes=("dining",),
          roles=("flat", "support", "big"), colors=("red",), state="lying flat")  # fmt: skip
def pizza_box(look: Look) -> Shape:
    """A flat, square cardboard box with the word PIZZA on its lid."""
    x, h = look.between(0.3, 0.34), look.between(0.038, 0.046)
    color = look.color("red", "green", "orange", "navy", "red")
    card = surfaces.speckles(look.rng, look.pick([(244, 240, 230), (206, 170, 122)]), 5)
    face = np.asarray(surfaces.fit(card, 160, 160)).copy()
    prints.disc(face, 0.5, 0.58, 0.27, (206, 152, 86))
    prints.disc(face, 0.5, 0.58, 0.24, (240, 196, 96))
    for a, d in ((0.2, 0.13), (1.5, 0.15), (2.7, 0.12), (3.9, 0.15), (5.2, 0.14), (0, 0)):
        prints.disc(face, 0.5 + d * np.cos(a), 0.58 + d * np.sin(a), 0.035, (190, 44, 34))
    prints.write(face, "PIZZA", 0.5, 0.17, 0.2, color, bold=True)
    body = block(x, x, h, 0.006, 0.002)
    top = box(0.97 * x, 0.97 * x, 0.001).move(z=h - 0.0004)
    flap = box(0.3 * x, 0.004, 0.6 * h).move(y=-x / 2, z=0.2 * h)
    return shape([(body, card), (top, face), (flap, surfaces.plain((190, 156, 112)))],
                 [box_part(x, x, h)])  # fmt: skip


@category("takeaway_box", size=(0.112, 0.103, 0.129), mass=0.3, material="paper", assembled=True,
          aliases=("takeout box", "take out box", "chinese takeout", "takeaway container",
          "takeout container", "noodle box", "to go box", "take away box", "chinese takeaway",
          "doggy bag", "chinese takeout box"), themes=("dining",),
          colors=("white", "red"))  # fmt: skip
def takeaway_box(look: Look) -> Shape:
    """A folded paper container for takeaway food with a wire handle, or a clamshell box."""
    color = look.color("white", "red", "white", "tan", "black")
    if look.chance(0.6):
        x, h = look.between(0.085, 0.1), look.between(0.09, 0.105)
        unit = rectangle(1, 1, 0.05, 2)
        rings = np.stack([np.column_stack([unit * [x * k, 0.85 * x * k], np.full(len(unit), z)])
                          for k, z in ((0.72, 0), (1.0, h), (0.96, h + 0.002))])  # fmt: skip
        pail = loft(rings, unit)
        roof = prism(np.array([(-0.5 * x, 0), (0.5 * x, 0), (0.2 * x, 0.02), (-0.2 * x, 0.02)]),
                     -0.4 * x, 0.4 * x).turn(0, np.pi / 2).move(z=h)  # fmt: skip
        wire = limb([(-0.49 * x, 0, 0.85 * h), (-0.44 * x, 0, h + 0.035), (0, 0, h + 0.052),
                     (0.44 * x, 0, h + 0.035), (0.49 * x, 0, 0.85 * h)], [0.0012] * 5,
                    6)  # fmt: skip
        face = prints.canvas(96, 96, color)
        ink = (196, 42, 40) if sum(color) > 380 else (250, 240, 220)
        prints.disc(face, 0.5, 0.52, 0.26, ink)
        prints.polygon(face, [(0.3, 0.55), (0.5, 0.3), (0.7, 0.55)], color)
        prints.fill(face, 0.38, 0.55, 0.24, 0.12, color)
        front = box(0.6 * x, 0.001, 0.6 * h)
        lean = np.arctan2(0.14 * 0.85 * x, h)
        front = front.turn(0, lean).move(y=-0.36 * 0.85 * x - 0.0006, z=0.16 * h)
        front = front.move(y=-0.14 * 0.85 * x * 0.16)
        return shape([(pail, surfaces.speckles(look.rng, color, 4)), (roof, surfaces.plain(
            tint_color(color, 0.9))), (wire, surfaces.plain((180, 184, 190))), (front, face)],
            [hull_of(pail), hull_of(roof), hull_of(wire)])  # fmt: skip
    x, h = look.between(0.15, 0.18), look.between(0.06, 0.075)
    unit = rectangle(1, 1, 0.12, 4)
    rings = np.stack([np.column_stack([unit * x * k, np.full(len(unit), z)]) for k, z in (
        (0.86, 0), (0.98, 0.5 * h - 0.003), (1.03, 0.5 * h - 0.003), (1.03, 0.5 * h + 0.003),
        (0.98, 0.5 * h + 0.003), (0.8, h))])  # fmt: skip
    body = loft(rings, unit)
    tab = box(0.03, 0.012, 0.005).move(0, -0.52 * x, 0.5 * h - 0.0025)
    return shape([(body, surfaces.speckles(look.rng, color, 4)),
                  (tab, surfaces.plain(tint_color(color, 0.85)))], [hull_of(body)])  # fmt: skip


@category("gift_hamper", size=(0.303, 0.216, 0.299), mass=3.0, material="wood", assembled=True,
          aliases=("hamper", "food hamper", "christmas hamper"), themes=("dining",), roles=("big",),
          colors=("tan",))  # fmt: skip
def gift_hamper(look: Look) -> Shape:
    """A wicker hamper filled with bottles, jars and fruit, with a ribbon on its front."""
    k = look.between(0.94, 1.06)
    color = look.color("tan", "brown", "bronze")
    x, y, h = 0.3 * k, 0.2 * k, 0.11 * k
    body = block(x, y, h, 0.015)
    straw = block(0.94 * x, 0.9 * y, 0.006, 0.012).move(z=h - 0.003)
    wine = [cylinder(0.031, 0.12, 22).move(-0.09 * k, 0.03, h), cylinder(0.011, 0.07, 16).move(
            -0.09 * k, 0.03, h + 0.118)]  # fmt: skip
    jars = [cylinder(0.032, 0.06, 22, bevel=0.003).move(0.0, 0.04, h),
            cylinder(0.032, 0.055, 22, bevel=0.003).move(0.075 * k, 0.035, h)]  # fmt: skip
    lids = [cylinder(0.03, 0.014, 22).move(0.0, 0.04, h + 0.06),
            cylinder(0.03, 0.014, 22).move(0.075 * k, 0.035, h + 0.055)]  # fmt: skip
    fruit = [ball(0.06, 0.06, 0.056, (dx * k, -0.045, h + 0.018), 14) for dx in (-0.09, 0.095)]
    pack = block(0.09, 0.05, 0.05, 0.002).move(0.0, -0.045, h)
    bow = [ball(0.05, 0.014, 0.034, (s * 0.028, -0.5 * y - 0.006, 0.62 * h), 12) for s in (-1, 1)]
    tie = box(0.02, 1.01 * y, 1.01 * h)
    weave = surfaces.basketwork(look.rng, color, 16)
    red = surfaces.plain(look.own_color("red", "gold", "green"))
    return shape([(body, weave), (straw, surfaces.scratches(look.rng, (222, 196, 130),
                                                            (186, 150, 84), 120)),
                  (join(wine), surfaces.plain((36, 60, 44))),
                  (join(jars), surfaces.plain((190, 60, 40))),
                  (join(lids), surfaces.plain((222, 184, 80))),
                  (join(fruit), surfaces.speckles(look.rng, (216, 60, 50), 12)),
                  (pack, panel(look, "TEA", (40, 80, 140), 90, 50)), (join([*bow, tie]), red)],
                 [box_part(x, y, h + 0.003), hull_of(*wine), hull_of(*jars, *lids), hull_of(pack),
                  hull_of(*bow), *(hull_of(f) for f in fruit)])  # fmt: skip
