"""Objects of the ``craft`` theme: tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import lay_down
from ...kit.shapes import Shape, category, shape
from ...kit.solids import box, cylinder, prism, torus
from ...kit.surfaces import RGB, Look, Tile, readable_on, tint_color


@category("cutting_mat", size=(0.39, 0.27, 0.003), mass=0.4, material="rubber", friction=0.8,
          aliases=("craft mat", "self healing mat", "self-healing mat", "self healing cutting mat",
          "self-healing cutting mat", "grid mat"), themes=("craft", "workbench"),
          roles=("flat", "support", "big"), colors=("green", "blue"), state="lying flat",
          common=True)  # fmt: skip
def cutting_mat(look: Look) -> Shape:
    """A self-healing cutting mat with a ruled grid, numbers along its edges and slanted guides."""
    x, y = look.pick([(0.3, 0.22), (0.45, 0.3), (0.45, 0.3), (0.36, 0.26)])
    x, y = x * look.between(0.97, 1.03), y * look.between(0.97, 1.03)
    color = look.color("green", "green", "green", "teal", "blue", "charcoal", "pink", "purple")
    line = readable_on(color) if look.chance(0.3) else tint_color(color, look.pick([1.55, 1.75]))
    if look.chance(0.2):
        line = look.pick([(240, 210, 90), (244, 244, 236)])
    mat = prism(rectangle(x, y, 0.008), 0, 0.003, 0.0005)
    return shape([(mat, _rule(look, x, y, color, line))], [box_part(x, y, 0.003)])


def _between(a: RGB, b: RGB) -> RGB:
    """Return a mix of two colours that is closer to ``a`` than to ``b``."""
    red, green, blue = (0.55 * x + 0.45 * y for x, y in zip(a, b, strict=True))
    return red, green, blue


def _rule(look: Look, x: float, y: float, color: RGB, line: RGB) -> Tile:
    """Return a centimetre grid, with every fifth line stronger, inside a numbered border."""
    wide, tall = 400, round(400 * y / x)
    image = prints.canvas(wide, tall, color)
    left, top = 0.05, 0.05 * x / y
    across, down = int(x * 0.9 / 0.01), int(y * (1 - 2 * top) / 0.01)
    step = (1 - 2 * left) / across, (1 - 2 * top) / down
    faint = _between(color, line)
    for strong in (False, True):
        ink = line if strong else faint
        for k in range(across + 1):
            if (k % 5 == 0) == strong:
                prints.fill(image, left + k * step[0], top, 1 / wide, 1 - 2 * top, ink)
        for k in range(down + 1):
            if (k % 5 == 0) == strong:
                prints.fill(image, left, top + k * step[1], 1 - 2 * left, 1 / tall, ink)
    for k in range(0, across + 1, 5):
        for v in (0.5 * top, 1 - 0.5 * top):
            prints.write(image, str(k), left + k * step[0], v, 0.028, line)
    for k in range(0, down + 1, 5):
        prints.write(image, str(k), 0.5 * left, 1 - top - k * step[1], 0.028, line)
    if look.chance(0.7):
        for angle in np.deg2rad([30, 45, 60]):
            reach = min((1 - 2 * left) / np.cos(angle), (1 - 2 * top) * y / x / np.sin(angle))
            end = (left + reach * np.cos(angle), 1 - top - reach * np.sin(angle) * x / y)
            prints.stroke(image, [(left, 1 - top), end], 0.003, line)
    if look.chance(0.35):
        prints.disc(image, 0.62, 0.45, 0.26, line, 0.25)
        prints.disc(image, 0.62, 0.45, 0.16, line, 0.15)
    for _ in range(int(look.rng.integers(0, 9))):
        u, v, turn = look.between(0.1, 0.9), look.between(0.1, 0.9), look.between(0, 3)
        end = (u + 0.16 * np.cos(turn), v + 0.2 * np.sin(turn))
        prints.stroke(image, [(u, v), end], 0.002, tint_color(color, 0.78))
    return image


@category("scissors", size=(0.19, 0.08, 0.011), mass=0.07, material="metal",
          aliases=("pair of scissors", "shears", "scissor", "wick trimmer", "wick trimmers",
          "pinking shears", "sewing kit", "thread snips", "trauma shears"),
          themes=("craft", "office"), roles=("flat",), colors=("red", "black"),
          state="lying flat, closed", common=True)  # fmt: skip
def scissors(look: Look) -> Shape:
    """Closed scissors lying flat, with two finger loops on the right."""
    long = look.between(0.17, 0.2)
    color = look.color("red", "black", "orange", "blue", "teal", "pink", "lime", "violet", "gray")
    fat, wide = look.between(0.2, 0.3), look.between(0.014, 0.019)
    steel = surfaces.brushed_metal(look.rng, (190, 193, 198))
    grip = surfaces.speckles(look.rng, color, 4, 32)
    pieces = []
    for side, low in ((-1, 0.0), (1, 0.0024)):
        outline = np.array(
            [(-0.5 * long, 0), (0.02, -0.011), (0.045, -0.006), (0.045, 0.004), (0.0, 0.004)]
        )
        if side > 0:
            outline = outline[::-1] * [1, -1]
        blade = prism(outline, low, low + 0.0024)
        loop = torus(1.0, fat, 24, 8).scale(look.between(0.021, 0.027), wide, 0.005 / fat)
        loop = loop.turn(2, side * 0.3).move(0.5 * long - 0.022, side * 0.021, 0.0052)
        pieces += [(blade, steel), (loop, grip)]
    screw = cylinder(0.0045, 0.002, 14).move(x=0.012, z=0.0046)
    low = min(solid.bounds[0, 2] for solid, _ in pieces)
    pieces.append((screw, surfaces.plain((120, 122, 128))))
    pieces = [(solid.move(z=-low), tile) for solid, tile in pieces]
    return shape(pieces, [hull_of(solid) for solid, _ in pieces[:4]])


@category("magnifying_glass", size=(0.18, 0.09, 0.017), mass=0.12, material="glass",
          aliases=("magnifier", "loupe", "monocle", "bug viewer", "jeweller loupe", "loupe lens"),
          themes=("craft", "office"), roles=("flat",), colors=("black", "brown"),
          state="lying flat", common=True)  # fmt: skip
def magnifying_glass(look: Look) -> Shape:
    """A magnifying glass lying flat."""
    r = look.between(0.036, 0.045)
    dark = surfaces.speckles(look.rng, look.color("black", "brown", "navy", "red"), 4)
    metal = surfaces.brushed_metal(look.rng, look.own_color("black", "gold", "silver"))
    rim = torus(r, 0.0045, 32, 8).move(z=0.0055)
    lens = cylinder(r - 0.002, 0.004, 28, bevel=0.001).move(z=0.0035)
    sky = surfaces.gradient((196, 214, 220), (228, 238, 240), look.rng)
    neck = lay_down(cylinder(0.0045, 0.018, 12), r + 0.002, 0.0065)
    grip = lay_down(cylinder(0.0065, 0.085, 16, top=0.0085, bevel=0.002), r + 0.016, 0.0085)
    keel = box(0.075, 0.008, 0.004).move(x=r + 0.06)
    return shape(
        [(rim, metal), (lens, sky), (neck, metal), (grip, dark), (keel, dark)],
        [cylinder_part(r + 0.0045, 0.01, (0, 0, 0.0005)),
         box_part(0.085, 0.013, 0.0165, (r + 0.0585, 0, 0)),
         box_part(0.02, 0.008, 0.009, (r + 0.01, 0, 0.002))],
    )  # fmt: skip
