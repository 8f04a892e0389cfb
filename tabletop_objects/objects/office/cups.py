"""Objects of the ``office`` theme: cups."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import contents, glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part, ring_parts
from ...kit.prints import wrap
from ...kit.shapes import Shape, category, shape
from ...kit.solids import Solid, cylinder, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ...values import ConvexPart


@category("paper_cup", size=(0.087, 0.087, 0.125), mass=0.26, material="paper",
          aliases=("takeaway cup", "takeaway coffee", "coffee to go", "to go cup", "disposable cup",
          "takeout cup", "takeout coffee", "takeaway coffee cup", "paper coffee cup"),
          themes=("office", "coffee"), roles=("tall", "round"), colors=("white", "brown"),
          common=True)  # fmt: skip
def paper_cup(look: Look) -> Shape:
    """A paper coffee cup with a sleeve, with or without a lid."""
    r, h = look.between(0.039, 0.045), look.between(0.095, 0.13)
    base = 0.7 * r
    color = look.color("white", "brown", "tan", "red", "green", "black", "cream")
    sleeve = look.own_color("tan", "brown", "teal", "charcoal", "tan")
    print_ = wrap(look, look.pick(["COFFEE", "CAFE", "HOT", "LATTE"]), color, sleeve, share=0.24)
    paper = surfaces.speckles(look.rng, color, 3, 32)

    def at(z: float) -> float:
        return base + (r - base) * z / h

    wall = 0.0018
    body = lathe([(0, 0), (base, 0), (r, h), (r - wall, h), (base - wall, wall), (0, wall)], 30)
    low, high = 0.28 * h, 0.72 * h
    band = lathe([(at(low) - 0.0005, low), (at(low) + 0.0012, low), (at(high) + 0.0012, high),
                  (at(high) - 0.0005, high)], 30, loop=True, v=[0, 0, 1, 1])  # fmt: skip
    rim = torus(r, 0.0016, 30, 6).move(z=h)
    if look.chance(0.3):
        drink = cylinder(at(0.85 * h) - 0.5 * wall, 0.001, 24).move(z=0.84 * h)
        floor = cylinder_part(base, 0.006)
        parts = ring_parts([(base, 0), (r, h)], [(r - wall, h), (base - wall, 0)], 10)
        surface = surfaces.gradient((74, 44, 26), (120, 80, 50), look.rng)
        return shape([(join([body, rim]), paper), (band, print_), (drink, surface)],
                     [floor, *parts])  # fmt: skip
    lid = lathe(
        [(0, 0), (r + 0.002, 0), (r + 0.002, 0.006), (0.88 * r, 0.008), (0.84 * r, 0.016),
         (0.78 * r, 0.016), (0.76 * r, 0.012), (0, 0.012)],
        30,
    ).move(z=h - 0.002)  # fmt: skip
    plastic = surfaces.plain(look.own_color("white", "black", "white", "brown"))
    return shape([(join([body, rim]), paper), (band, print_), (lid, plastic)],
                 [hull_of(body), cylinder_part(0.86 * r, 0.016, (0, 0, h - 0.002))])  # fmt: skip


@category("thermos", size=(0.08, 0.076, 0.245), mass=0.6, material="metal", hollow=True,
          aliases=("vacuum flask", "thermos flask", "thermos bottle", "insulated bottle",
          "thermos mug", "water filter", "dewar flask"), themes=("office", "coffee", "tea"),
          roles=("tall", "round"), colors=("green", "navy"), common=True)  # fmt: skip
def thermos(look: Look) -> Shape:
    """A vacuum flask with a cup as its lid."""
    r, h = look.between(0.034, 0.042), look.between(0.22, 0.29)
    color = look.color("green", "navy", "silver", "red", "black", "teal", "white")
    metal = surfaces.brushed_metal(look.rng, (178, 182, 188))
    coat = surfaces.brushed_metal(look.rng, color)
    if look.chance(0.35):
        coat = surfaces.stack((coat, 0.5), (surfaces.plain(readable_on(color)), 0.04), (coat, 0.4))
    foot = cylinder(r, 0.014, 30, bevel=0.002)
    body = lathe([(0, 0), (r, 0), (r, 0.6 * h), (0.84 * r, 0.68 * h), (0, 0.68 * h)], 30,
                 v=[0, 0, 0.9, 0.99, 1]).move(z=0.012)  # fmt: skip
    collar = cylinder(0.86 * r, 0.03 * h, 28).move(z=0.012 + 0.675 * h)
    cup = lathe(
        [(0, 0), (0.9 * r, 0), (0.84 * r, 0.2 * h), (0.78 * r, 0.215 * h), (0, 0.215 * h)], 28
    )
    cup = cup.move(z=0.012 + 0.7 * h)
    shiny = look.chance(0.5)
    pieces = [(body, coat), (join([foot, collar]), metal), (cup, metal if shiny else coat)]
    parts = [cylinder_part(r, 0.62 * h), hull_of(body), hull_of(cup)]
    if look.chance(0.5):
        z = 0.012 + 0.7 * h
        bow = tube([(0.85 * r, 0, z + 0.17 * h), (1.4 * r, 0, z + 0.15 * h),
                    (1.4 * r, 0, z + 0.06 * h),
                    (0.87 * r, 0, z + 0.03 * h)], 0.0045, 8)  # fmt: skip
        pieces.append((bow, surfaces.plain((50, 52, 56))))
        parts.append(hull_part(bow.vertices))
    return shape(pieces, parts)


DRINKS: tuple[RGB, ...] = ((58, 34, 22), (150, 100, 64), (196, 160, 120), (166, 88, 32))
"""Black and white coffee, milk foam, tea."""


EARS = ("ear", "square", "ring")


def handle(
    radii: tuple[float, float],
    low: float,
    high: float,
    reach: float,
    thick: float,
    kind: str = "ear",
) -> Solid:
    """Return an ear-shaped, square or ring-shaped handle on the +x side of a vessel's wall.

    ``radii`` are the radii of the wall at the heights ``low`` and ``high``.
    """
    ways = {
        "ear": [(0, 1.0), (0.6, 1.04), (1, 0.62), (0.72, 0.22), (0, 0)],
        "square": [(0, 1.0), (0.8, 1.0), (0.96, 0.9), (0.96, 0.12), (0.8, 0.02), (0, 0)],
        "ring": [(0, 0.92), (0.55, 1.0), (0.95, 0.72), (0.95, 0.32), (0.55, 0.02), (0, 0.1)],
    }[kind]
    start, step = radii[0], radii[1] - radii[0]
    points = [(start + z * step + x * reach, 0, low + z * (high - low)) for x, z in ways]
    return tube(smooth(points, 4), thick, 8, squash=0.75)


def handle_part(radius: float, low: float, high: float, reach: float, thick: float) -> ConvexPart:
    """Return the collision box of a vessel's handle."""
    return box_part(reach, 2 * thick, high - low, (radius + reach / 2, 0, low))


def drink(look: Look, radius: float, height: float) -> list[tuple[Solid, surfaces.Tile]]:
    """Return the surface of a cup's drink, or an empty list; by default, most cups are empty."""
    full, color = look.chance(0.3), look.pick(DRINKS)
    said = contents(look, radius, height)
    if said is not None:
        return said
    if not full:
        return []
    foam = surfaces.spots(look.rng, color, tint_color(color, 1.3), look.between(0.01, 0.2), 48)
    return [(cylinder(radius, 0.0016, 28).move(z=height), foam)]


@category("mug", size=(0.11, 0.083, 0.095), mass=0.3, material="ceramic", hollow=True,
          aliases=("coffee mug", "coffee cup", "cup"), themes=("office", "coffee", "kitchen"),
          roles=("container", "round"), colors=("white", "red", "blue", "teal", "black"),
          common=True)  # fmt: skip
def mug(look: Look) -> Shape:
    """A straight, flaring, bulbous or enamel mug with a handle, and with room inside for a ball."""
    r, h, wall = look.between(0.037, 0.044), look.between(0.082, 0.108), 0.0045
    kind = look.pick(["straight", "straight", "flared", "belly", "enamel", "round"])
    color = look.color(
        *("white", "white", "red", "blue", "teal", "mustard", "sage", "black", "terracotta"),
        *("pink", "navy", "gray", "cream", "green", "orange", "lavender"),
    )
    glaze, inside = (glaze_tile(look, color, words=True), look.surface(tint_color(color, 1.4),
                                                                       "ceramic"))  # fmt: skip
    if kind == "enamel":
        inside = surfaces.plain((242, 240, 234))
    t = np.linspace(0, 1, 7)
    swell = {"straight": 1 + 0 * t, "flared": 0.78 + 0.27 * t, "belly": 0.9 + 0.16
             * np.sin(np.pi * (0.1 + 0.75 * t)), "enamel": 0.97 + 0.03 * t, "round": 0.62 + 0.42
             * np.sin(np.pi / 2 * np.minimum(1.35 * t + 0.12, 1.15))}[kind]  # fmt: skip
    side = np.column_stack([r * swell, 0.006 + (h - 0.008) * t])
    inner = [(radius - wall, max(z, 0.007)) for radius, z in side[::-1]]
    foot, top = 0.9 * side[0, 0], float(side[-1, 0])
    body = lathe(
        [(0, 0), (foot, 0), *side, (top - wall / 2, h), *inner, (0, 0.007)],
        v=[0, 0, *np.linspace(0.02, 0.96, 7), 0.97, *np.linspace(0.98, 0.995, 7), 1],
    )
    low, high = look.between(0.16, 0.28) * h, look.between(0.78, 0.88) * h
    reach, thick = look.between(0.024, 0.03), look.between(0.0042, 0.006)
    touch, top_touch = np.interp([low, high], side[:, 1], side[:, 0]) - 0.002
    ear = handle((touch, top_touch), low, high, reach, thick, look.pick(EARS))
    rim = surfaces.plain(tint_color(color, 0.35)) if kind == "enamel" else inside
    tile = surfaces.stack((glaze, 96), (rim, 2), (inside, 3), side=192)
    ear_color = look.pick([color, color, tint_color(color, 0.5)])
    wedges = ring_parts([(foot, 0.0), tuple(side[0]), tuple(side[3]), (top, h)],
                        [(top - wall, h), (float(side[0, 0]) - wall, 0.007)])  # fmt: skip
    level = float(np.interp(0.84 * h, side[:, 1], side[:, 0])) - wall + 0.0006
    return shape(
        [(body, tile), (ear, look.surface(ear_color, "ceramic")), *drink(look, level, 0.84 * h)],
        [*wedges, cylinder_part(foot, 0.007),
         handle_part(top_touch, low, 0.98 * high, 0.8 * reach - (top_touch - touch) / 2, thick)],
    )  # fmt: skip
