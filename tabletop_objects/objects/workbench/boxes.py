"""Objects of the ``workbench`` theme: boxes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import tool_steel
from ...kit.outlines import rectangle
from ...kit.parts import box_part, frame_parts, hull_of
from ...kit.primitives import lay_down
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, prism, tube
from ...kit.surfaces import Look, tint_color


def walls(x: float, y: float, h: float, wall: float, bottom: float) -> list[Solid]:
    """Return the bottom and the four walls of an open box on z = 0."""
    across = box(x, wall, h - bottom)
    along = box(wall, y - 2 * wall, h - bottom)
    return [box(x, y, bottom), *(across.move(y=s * (y - wall) / 2, z=bottom) for s in (-1, 1)),
            *(along.move(x=s * (x - wall) / 2, z=bottom) for s in (-1, 1))]  # fmt: skip


def case(
    size: tuple[float, float, float], wall: float, colors: tuple[str, ...], lining: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return a shape function for a case with an open lid that is hinged at the back."""

    def make(look: Look) -> Shape:
        k = look.between(0.95, 1.05)
        x, y, h = (float(v) * k for v in size)
        outside = look.surface(look.color(*colors), "plastic")
        inside = surfaces.plain(look.own_color(*lining))
        lid = box(x, 0.28 * h, 0.85 * y).move(y=y / 2 + 0.14 * h, z=0.1 * h)
        panel = box(x - 4 * wall, 0.004, 0.85 * y - 4 * wall).move(y=y / 2, z=0.1 * h + 2 * wall)
        handle = box(0.3 * x, 0.014, 0.016).move(y=-y / 2 - 0.007, z=0.55 * h)
        pieces = [*((s, outside) for s in walls(x, y, h, wall, wall)), (lid, outside),
                  (panel, inside), (handle, surfaces.plain((52, 52, 56)))]  # fmt: skip
        parts = [*frame_parts(x, y, h, wall, wall),
                 box_part(x, 0.28 * h, 0.85 * y + 0.1 * h, (0, y / 2 + 0.14 * h, 0))]  # fmt: skip
        return shape(pieces, parts)

    return make


DARK = (44, 46, 50)


@category("tool_kit", size=(0.3, 0.29, 0.2), mass=2.2, material="plastic", aliases=("toolkit",
          "socket set", "open tool case", "open toolbox", "tool set", "wrench set"),
          themes=("workbench",), roles=("big",), colors=("red", "black"), state="standing open",
          opened="tool_caddy", common=True)  # fmt: skip
def tool_kit(look: Look) -> Shape:
    """An open tool case with sockets, bits and a ratchet."""
    x, y, h = look.between(0.26, 0.34), look.between(0.17, 0.21), look.between(0.034, 0.042)
    color = look.color("red", "black", "blue", "orange", "green")
    shell, metal = surfaces.speckles(look.rng, color, 4), tool_steel(look)
    inlay = surfaces.speckles(look.rng, look.own_color("charcoal", "black"), 4)
    tray = block(x, y, h, 0.012, 0.003)
    bed = box(0.92 * x, 0.88 * y, 0.002).move(z=h - 0.0012)
    sockets = []
    for row in range(2):
        for k in range(8):
            r = x / 22 * (0.55 + 0.06 * k + 0.1 * row)
            at = ((k - 3.5) * x / 9.2, -0.3 * y + 0.24 * y * row, h)
            sockets.append(cylinder(r, 0.012, 12, bevel=0.001).move(*at))
    ratchet = [lay_down(cylinder(0.007, 0.5 * x, 12), -0.42 * x, h + 0.007).move(y=0.22 * y),
               cylinder(0.017, 0.016, 18, bevel=0.002).move(0.1 * x, 0.22 * y, h)]  # fmt: skip
    bits = [box(0.006, 0.026, 0.007).move(0.22 * x + 0.012 * k, 0.22 * y, h)
            for k in range(5)]  # fmt: skip
    lid = block(x, y, 0.02, 0.012, 0.003)
    inner = box(0.92 * x, 0.88 * y, 0.002).move(z=0.019)
    paper = prints.canvas(160, 96, (60, 62, 66))
    for k in range(6):
        prints.fill(paper, 0.08 + 0.15 * k, 0.2, 0.07, 0.55, (86, 88, 94))
    lean = np.pi / 2 - 0.22

    def tilt(solid: Solid) -> Solid:
        return solid.move(y=y / 2 + 0.002, z=-0.02).turn(0, lean).move(y=y / 2 + 0.016, z=0.02)

    bow = tube([(-0.04, -y / 2, h / 2), (-0.036, -y / 2 - 0.018, h / 2),
                (0.036, -y / 2 - 0.018, h / 2), (0.04, -y / 2, h / 2)], 0.006, 8)  # fmt: skip
    return shape(
        [(join([tray, tilt(lid)]), shell), (bed, inlay), (tilt(inner), paper),
         (join([*sockets, *ratchet, *bits]), metal), (bow, surfaces.plain(DARK))],
        [box_part(x, y, h), hull_of(tilt(lid)),
         box_part(0.92 * x, 0.5 * y, 0.01, (0, -0.2 * y, h))],
    )  # fmt: skip


@category("toolbox", size=(0.33, 0.165, 0.19), mass=1.6, material="metal", hollow=True,
          aliases=("tool box", "tool case", "tool chest"), themes=("workbench",), roles=("big",),
          colors=("red", "blue"), opened="tool_caddy", common=True)  # fmt: skip
def toolbox(look: Look) -> Shape:
    """A closed toolbox with a handle on its lid."""
    x, y, h = look.between(0.3, 0.36), look.between(0.15, 0.18), look.between(0.11, 0.13)
    color = look.color("red", "blue", "black", "yellow", "orange")
    lower = surfaces.speckles(look.rng, color, 5)
    upper = surfaces.speckles(look.rng, tint_color(color, 0.7), 5)
    lid = prism(rectangle(0.96 * x, 0.92 * y, 0.02), h, h + 0.04, 0.012)
    bow = tube([(-0.06, 0, h + 0.036), (-0.055, 0, h + 0.062), (0.055, 0, h + 0.062),
                (0.06, 0, h + 0.036)], 0.008, 10)  # fmt: skip
    clips = [box(0.025, 0.006, 0.03).move(s * 0.3 * x, -y / 2 - 0.002, h - 0.012) for s in (-1, 1)]
    return shape(
        [(block(x, y, h, 0.012, 0.003), lower), (lid, upper), (bow, surfaces.plain((40, 40, 44))),
         (join(clips), tool_steel(look))],
        [box_part(x, y, h), box_part(0.94 * x, 0.88 * y, 0.04, (0, 0, h)),
         box_part(0.12, 0.016, 0.029, (0, 0, h + 0.04))],
    )  # fmt: skip


@category("screw_box", size=(0.16, 0.115, 0.03), mass=0.4, material="plastic",
          aliases=("box of screws", "box of nails", "screw organizer"), themes=("workbench",),
          roles=("flat",), colors=("blue",), common=True)  # fmt: skip
def screw_box(look: Look) -> Shape:
    """A flat plastic organiser with compartments for screws."""
    x, y, h = 0.16, 0.11, 0.03
    frame = surfaces.speckles(look.rng, look.color("blue", "red", "gray", "yellow"), 4)
    image = prints.canvas(160, 112, (190, 194, 198))
    for _ in range(170):
        i, j = look.rng.integers(0, 150), look.rng.integers(0, 104)
        tone = int(look.rng.integers(90, 230))
        image[j : j + 2, i : i + 9] = (tone, tone, tone - 10 if tone > 20 else tone)
    for k in range(1, 4):
        prints.fill(image, k / 4 - 0.01, 0, 0.02, 1, (70, 74, 80))
    prints.fill(image, 0, 0.49, 1, 0.025, (70, 74, 80))
    lid = box(0.95 * x, 0.92 * y, 0.001).move(z=h - 0.0005)
    latch = block(0.03, 0.006, 0.014, 0.002).move(y=-y / 2 - 0.002, z=0.01)
    return shape([(block(x, y, h, 0.006, 0.002), frame), (lid, image),
                  (latch, surfaces.plain((60, 62, 66)))], [box_part(x, y, h)])  # fmt: skip


CATEGORIES = (
    Category("tool_caddy",
             case((0.34, 0.19, 0.1), 0.005, ("red", "blue", "black", "yellow"), ("gray",)),
             size=(0.34, 0.23, 0.18), mass=1.6, material="plastic", hollow=True,
             aliases=("open tool box", "tool tray"), themes=("workbench",),
             roles=("container", "big"), colors=("red", "blue")),
)  # fmt: skip
"""Objects that share their drawing functions."""
