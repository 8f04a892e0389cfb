"""Objects of the ``electronics`` theme: computer parts."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Category, Shape, category, shape, vary
from ...kit.solids import block, box, cylinder, join, lathe, prism
from ...kit.surfaces import RGB, Look, tint_color


@category("heatsink", size=(0.051, 0.051, 0.0286), mass=0.07, material="metal",
          aliases=("heat sink", "cooler block", "cpu cooler"), themes=("electronics",),
          colors=("silver",))  # fmt: skip
def heatsink(look: Look) -> Shape:
    """A heat sink: a block of metal fins."""
    k = look.between(0.85, 1.2)
    metal = look.surface(look.color("silver", "black", "silver", "blue", "copper", "gold"), "metal")
    side, h = 0.05 * k, 0.028 * k
    fins = [box(0.0016 * k, side, h).move(x=(n - 6) * side / 12.9) for n in range(13)]
    return shape([(join([box(side, side, 0.006 * k), *fins]), metal)],
                 [box_part(side, side, h)])  # fmt: skip


@category("case_fan", size=(0.08, 0.08, 0.025), mass=0.1, material="plastic",
          aliases=("computer fan", "pc fan", "cooling fan", "cpu fan"), themes=("electronics",),
          roles=("flat",), colors=("black",))  # fmt: skip
def case_fan(look: Look) -> Shape:
    """A square computer fan lying flat, with a frame, a hub and seven blades."""
    k = look.between(0.85, 1.15)
    color = look.color("black", "black", "white", "charcoal", "brown")
    side, h = 0.08 * k, 0.025 * k
    r = 0.46 * side
    frame = [lathe([(r, 0), (1.08 * r, 0), (1.08 * r, h), (r, h)], 32, loop=True)]
    for s in (-1, 1):
        for t in (-1, 1):
            corner = block(0.19 * side, 0.19 * side, 0.004, 0.003)
            at = (s * 0.4 * side, t * 0.4 * side)
            frame += [corner.move(*at, z) for z in (0.0, h - 0.004)]
    rims = [box(side, 0.06 * side, h).move(y=s * 0.47 * side) for s in (-1, 1)]
    rims += [box(0.06 * side, side, h).move(x=s * 0.47 * side) for s in (-1, 1)]
    blades = []
    for n in range(7):
        wing = box(0.3 * side, 0.2 * side, 0.0016).turn(0, 0.5).move(x=0.27 * side, z=0.5 * h)
        blades.append(wing.turn(2, n * 2 * np.pi / 7))
    hub = cylinder(0.17 * side, 0.8 * h, 24).move(z=0.1 * h)
    sign = prints.canvas(48, 48, tint_color(color, 1.15))
    prints.disc(sign, 0.5, 0.5, 0.3, look.own_color("red", "blue", "white", "orange"))
    badge = prism(ellipse(0.28 * side, 0.28 * side, 24), 0.9 * h, 0.92 * h)
    tone = look.own_color("charcoal", "gray", "white", "red", "cyan")
    return shape([(join([*frame, *rims]), surfaces.speckles(look.rng, color, 3, 32)),
                  (join([*blades, hub]), surfaces.plain(tone)), (badge, sign)],
                 [box_part(side, side, h)])  # fmt: skip


@category("graphics_card", size=(0.242, 0.122, 0.0392), mass=0.9, material="device",
          aliases=("gpu", "video card", "graphic card"), themes=("electronics",),
          roles=("flat", "big"), colors=("black",))  # fmt: skip
def graphics_card(look: Look) -> Shape:
    """A graphics card lying with its fans up and its bracket on the left."""
    k = look.between(0.88, 1.04)
    x, y, h = 0.25 * k, 0.11 * k, 0.04 * k
    color = look.color("black", "charcoal", "white", "gray", "red")
    board = box(x, y, 0.003).move(z=0.002)
    cover = block(0.97 * x, 0.94 * y, h - 0.005, 0.012, 0.004).move(z=0.005)
    pieces = [(board, surfaces.plain((34, 82, 58))), (cover, look.surface(color, "plastic"))]
    count = look.pick([2, 2, 3])
    for n in range(count):
        u = ((n + 0.5) / count - 0.5) * 0.94 * x
        r = min(0.42 * y, 0.43 * x / count)
        image = prints.canvas(96, 96, tint_color(color, 0.6))
        for m in range(11):
            t = m * 2 * np.pi / 11
            prints.polygon(image, [(0.5, 0.5), (0.5 + 0.46 * np.cos(t), 0.5 + 0.46 * np.sin(t)),
                                   (0.5 + 0.46 * np.cos(t + 0.3), 0.5 + 0.46 * np.sin(t + 0.3))],
                           (96, 98, 102))  # fmt: skip
        prints.disc(image, 0.5, 0.5, 0.16, (30, 30, 32))
        prints.disc(image, 0.5, 0.5, 0.06, look.own_color("red", "lime", "silver", "cyan"))
        pieces.append((prism(ellipse(2 * r, 2 * r, 30), h - 0.0005, h + 0.0006).move(x=u), image))
    bracket = box(0.002, 1.1 * y, h).move(x=-x / 2 - 0.001)
    edge = prints.canvas(64, 8, GOLD)
    for n in range(16):
        prints.fill(edge, n / 16, 0, 0.015, 1, (40, 80, 60))
    fingers = box(0.36 * x, 0.008, 0.0032).move(x=-0.12 * x, y=-y / 2 - 0.003, z=0.0019)
    return shape([*pieces, (bracket, surfaces.brushed_metal(look.rng, STEEL)), (fingers, edge)],
                 [box_part(x, y, h, (0, 0, 0)), hull_of(bracket)])  # fmt: skip


def _stick(
    x: float, y: float, chips: int, palette: tuple[str, ...], label: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """A small circuit board lying flat, with black chips or a label and gold contacts."""

    def make(look: Look) -> Shape:
        k = look.between(0.97, 1.05)
        color = look.color(*palette)
        a, b = x * k, y * k
        image = prints.canvas(128, max(int(128 * y / x), 24), color)
        for n in range(24 if chips else 8):
            prints.fill(image, 0.05 + (0.9 * n / 24 if chips else 0.115 * n), 0.9 if chips else 0.0,
                        0.02 if chips else 0.06, 0.1 if chips else 0.12, GOLD)  # fmt: skip
        if label:
            tone = look.own_color("red", "navy", "orange", "teal", "gold")
            prints.fill(image, 0.1, 0.24, 0.8, 0.62, (246, 244, 240))
            prints.fill(image, 0.1, 0.24, 0.8, 0.3, tone)
            prints.write(image, look.pick(label), 0.5, 0.7, 0.2, DARK, bold=True)
        pieces = [(box(a, b, 0.0021), surfaces.plain(tint_color(color, 0.85))),
                  (box(0.99 * a, 0.99 * b, 0.0003).move(z=0.002), image)]  # fmt: skip
        parts = [box_part(a, b, 0.0022)]
        for n in range(chips):
            u = ((n + 0.5) / chips - 0.5) * 0.95 * a
            pieces.append((box(0.8 * a / chips, 0.5 * b, 0.0016).move(u, 0.1 * b, 0.0021),
                           surfaces.plain(DARK)))  # fmt: skip
        if chips:
            parts.append(box_part(0.93 * a, 0.5 * b, 0.0015, (0, 0.1 * b, 0.0022)))
        return shape(pieces, parts)

    return make


STEEL: RGB = (196, 198, 202)
GOLD: RGB = (214, 178, 92)
DARK: RGB = (32, 32, 35)


@category("cpu", size=(0.041, 0.041, 0.0041), mass=0.03, material="metal",
          aliases=("processor", "computer processor", "microprocessor"), themes=("electronics",),
          roles=("flat",), colors=("green",))  # fmt: skip
def cpu(look: Look) -> Shape:
    """A processor: a metal lid on a green board with gold contacts."""
    k = look.between(0.95, 1.1)
    color = look.color("green", "green", "teal", "blue")
    side, h = 0.04 * k, 0.0015
    board = surfaces.fit(surfaces.speckles(look.rng, color, 4, 32), 96, 96).copy()
    for n in range(20):
        for v in (0.03, 0.94):
            prints.fill(board, 0.04 + 0.047 * n, v, 0.02, 0.03, GOLD)
            prints.fill(board, v, 0.04 + 0.047 * n, 0.03, 0.02, GOLD)
    prints.polygon(board, [(0, 1), (0.06, 1), (0, 0.94)], GOLD)
    lid_print = prints.canvas(96, 96, (198, 200, 204))
    for n, text in enumerate((look.pick(["CORE X7", "R9 5900", "i7-12K"]), "3.60 GHZ", "MALAY")):
        prints.write(lid_print, text, 0.5, 0.3 + 0.18 * n, 0.12, (110, 112, 116))
    lid = block(0.78 * side, 0.78 * side, 0.0026, 0.003, 0.0006).move(z=h - 0.0001)
    return shape([(box(side, side, h), board), (lid, surfaces.brushed_metal(look.rng, STEEL)),
                  (box(0.7 * side, 0.7 * side, 0.0003).move(z=h + 0.0023), lid_print)],
                 [box_part(side, side, h), hull_of(lid)])  # fmt: skip


CATEGORIES = (
    Category("ram_stick",
             vary(0.04)(_stick(0.133, 0.03, 8, ("green", "black", "green", "blue"), ())),
             size=(0.134, 0.0303, 0.0037), mass=0.03, material="plastic", aliases=("ram",
             "memory module", "ram module", "ram memory", "memory chip", "ram card"),
             themes=("electronics",), roles=("flat",), colors=("green",)),
    Category("memory_card", _stick(0.024, 0.032, 0, ("black", "blue", "charcoal"), ("32 GB",
             "64 GB", "128 GB", "16 GB")), size=(0.0243, 0.0323, 0.0023), mass=0.003,
             material="plastic", aliases=("sd card", "micro sd card", "memory sd card",
             "camera card", "microsd card", "sim card", "micro sd"), themes=("electronics",),
             roles=("flat",), colors=("black", "blue")),
)  # fmt: skip
"""Objects that share their drawing functions."""
