"""Objects of the ``kitchen`` theme: bottles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import smooth
from ...kit.parts import box_part, hull_of, hull_part
from ...kit.primitives import label_skin, limb, vessel, vessel_parts
from ...kit.prints import wrap
from ...kit.shapes import Shape, category, shape
from ...kit.solids import box, cylinder, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look


@category("milk_bottle", size=(0.078, 0.078, 0.21), mass=0.95, material="glass",
          aliases=("bottle of milk", "glass milk bottle"),
          themes=("kitchen", "dining", "breakfast"), roles=("tall", "round"),
          colors=("white",))  # fmt: skip
def milk_bottle(look: Look) -> Shape:
    """A glass bottle of milk with a wide mouth and a foil cap or a swing top."""
    r, h = look.between(0.036, 0.042), look.between(0.19, 0.23)
    milk = look.color("white", "white", "cream", "pink", "tan", "brown", spread=4)
    neck = 0.55 * r
    body = vessel(r, h, neck, 0.52 * h, 0.76 * h)
    glass = surfaces.plain((212, 224, 228))
    skin = surfaces.stack((surfaces.plain(milk), 0.8), (glass, 0.2), side=192)
    sign = prints.canvas(192, 64, milk)
    ink = look.own_color("blue", "red", "green", "navy", "teal")
    if sum(milk) < 480:
        ink = (246, 244, 238)
    prints.write(
        sign[:, 72:120], look.pick(["MILK", "FRESH", "DAIRY"]), 0.5, 0.35, 0.4, ink, bold=True
    )
    prints.fill(sign, 0.4, 0.66, 0.2, 0.06, ink)
    skin = surfaces.fit(skin, 192, 192).copy()
    skin[96:160] = sign
    tone = look.own_color("silver", "red", "blue", "gold", "green", "white")
    lid = lathe([(0, h - 0.012), (neck + 0.002, h - 0.012), (neck + 0.003, h),
                 (neck - 0.002, h + 0.003), (0, h + 0.002)], 28)  # fmt: skip
    collar = torus(neck, 0.0022, 28, 6).move(z=0.86 * h)
    return shape([(body, skin), (lid, surfaces.speckles(look.rng, tone, 8, 32)), (collar, glass)],
                 [*vessel_parts(body, r, 0.52 * h, neck, h, 0.76 * h), hull_of(lid)])  # fmt: skip


@category("spray_bottle", size=(0.09, 0.057, 0.2), mass=0.5, material="plastic",
          aliases=("cleaning spray", "spray cleaner", "trigger bottle", "window cleaner", "mister",
          "screen cleaning kit", "hand sanitizer spray"), themes=("kitchen", "workbench"),
          roles=("tall",), colors=("sky", "white"), common=True)  # fmt: skip
def spray_bottle(look: Look) -> Shape:
    """A spray bottle of cleaner with a trigger."""
    r, h = look.between(0.036, 0.043), look.between(0.15, 0.18)
    color = look.color("sky", "clear", "green", "white", "orange", "lavender", "yellow")
    label = wrap(look, look.pick(["CLEAN", "GLASS", "SHINE", "MIST", "PLANTS"]),
                 look.own_color(*PRINTS), (246, 246, 242))  # fmt: skip
    skin = surfaces.speckles(look.rng, color, 3, 32)
    body = lathe(
        [(0, 0), (0.95 * r, 0), (r, 0.006), (r, 0.62 * h), (0.8 * r, 0.74 * h),
         (0.42 * r, 0.86 * h), (0.36 * r, h), (0, h)],
        28, v=[0, 0, 0.03, 0.62, 0.74, 0.86, 0.97, 1],
    ).scale(1, 0.72, 1)  # fmt: skip
    tile = surfaces.stack((skin, 0.14), (label, 0.42), (skin, 0.44), side=192)
    head = surfaces.speckles(
        look.rng, look.own_color("white", "red", "blue", "black", "green"), 3, 32
    )
    collar = cylinder(0.44 * r, 0.018, 18, bevel=0.001).move(z=h - 0.008)
    top = box(0.07, 0.022, 0.022).bend(
        lambda p: np.column_stack([p[:, 0], p[:, 1], p[:, 2] - 0.1 * (p[:, 0] + 0.02)])
    )
    nose = cylinder(0.008, 0.014, 14).turn(1, -np.pi / 2).move(x=-0.04, z=h + 0.026)
    trigger = tube(smooth([(-0.022, 0, h + 0.014), (-0.032, 0, h - 0.006), (-0.046, 0, h - 0.034)]),
                   0.0045, 8)  # fmt: skip
    return shape(
        [(body, tile), (join([collar, top.move(x=-0.006, z=h + 0.012), trigger]), head),
         (nose, surfaces.plain((60, 62, 68)))],
        [hull_part(body.vertices[body.vertices[:, 2] < 0.76 * h]),
         hull_part(body.vertices[body.vertices[:, 2] > 0.7 * h]),
         box_part(0.066, 0.02, 0.02, (-0.006, 0, h + 0.014)), hull_of(trigger)],
    )  # fmt: skip


PRINTS = ("red", "navy", "teal", "green", "mustard", "crimson", "orange", "purple", "blue")
CLEAR: RGB = (208, 218, 216)


@category("hot_sauce", size=(0.0478, 0.0478, 0.176), mass=0.22, material="glass",
          aliases=("chili sauce", "chilli sauce", "hot sauce bottle", "bottle of hot sauce",
          "sriracha", "fish sauce", "chili oil"), themes=("kitchen",), roles=("tall", "round"),
          colors=("red",))  # fmt: skip
def hot_sauce(look: Look) -> Shape:
    """A slim bottle of hot sauce with a chilli on its label."""
    r, h = look.between(0.022, 0.027), look.between(0.14, 0.17)
    color = look.color("red", "red", "orange", "green", "crimson")
    body = vessel(r, h, 0.0095, 0.56 * h, 0.72 * h)
    ground = look.pick([(246, 240, 222), (250, 214, 90), (34, 34, 38)])
    skin = np.asarray(label_skin(look, color, look.pick(["HOT", "FIRE", "CHILI"]), 0.12, 0.48,
                                 ground)).copy()  # fmt: skip
    cap = cylinder(0.0115, 0.03, 20, bevel=0.001).move(z=h - 0.014)
    tone = surfaces.plain(look.own_color("red", "green", "white", "black"))
    return shape([(body, skin), (cap, tone)],
                 [*vessel_parts(body, r, 0.56 * h, 0.0095, h, 0.72 * h), hull_of(cap)])  # fmt: skip


def _cruet(look: Look, fill: RGB, word: str) -> Shape:
    """Return a slim bottle of oil or vinegar with a pouring spout or a cork."""
    r, h = look.between(0.031, 0.037), look.between(0.22, 0.27)
    square = look.chance(0.4)
    body = vessel(r, h, 0.012, 0.6 * h, 0.78 * h, sides=4 if square else 32)
    body = body.turn(2, np.pi / 4) if square else body
    skin = np.asarray(label_skin(look, fill, word, 0.2, 0.44, look.pick(
        [(246, 240, 222), (250, 250, 246)]))).copy()  # fmt: skip
    skin[: int(0.24 * len(skin))] = np.array(CLEAR, np.uint8)
    spout = limb([(0, 0, h - 0.004), (0, 0, h + 0.012), (0.006, 0, h + 0.028), (0.018, 0,
                  h + 0.04)], [0.0085, 0.0055, 0.0038, 0.003], 10)  # fmt: skip
    collar = cylinder(0.0145, 0.018, 20, bevel=0.001).move(z=h - 0.01)
    steel = surfaces.brushed_metal(look.rng, (196, 199, 204))
    wide = 0.7 * r if square else r
    return shape([(body, skin), (join([spout, collar]), steel)],
                 [hull_of(body.bend(lambda p: np.minimum(p, [1, 1, 0.6 * h]))),
                  *vessel_parts(body, wide, 0.6 * h, 0.012, h, 0.78 * h)[1:],
                  hull_of(spout, collar)])  # fmt: skip


@category("oil_bottle", size=(0.0621, 0.0621, 0.295), mass=0.8, material="glass",
          aliases=("olive oil", "bottle of olive oil", "oil cruet", "olive oil bottle",
          "cooking oil", "bottle of oil", "vegetable oil", "oil dispenser", "sunflower oil", "oil",
          "pre-shave oil bottle"), themes=("kitchen",), roles=("tall", "round"),
          colors=("mustard",))  # fmt: skip
def oil_bottle(look: Look) -> Shape:
    """A bottle of olive oil with a pouring spout."""
    return _cruet(
        look, look.color("mustard", "olive", "gold"), look.pick(["OLIVE", "OIL", "EXTRA"])
    )


@category("vinegar_bottle", size=(0.0555, 0.0555, 0.288), mass=0.75, material="glass",
          aliases=("vinegar", "bottle of vinegar", "balsamic vinegar", "vinegar cruet", "cruet"),
          themes=("kitchen",), roles=("tall", "round"), colors=("maroon",))  # fmt: skip
def vinegar_bottle(look: Look) -> Shape:
    """A bottle of vinegar with a pouring spout."""
    return _cruet(
        look, look.color("maroon", "amber", "brown", "beige"), look.pick(["VINEGAR", "BALSAMIC"])
    )
