"""Objects of the ``dining`` theme: candles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_of, hull_part
from ...kit.primitives import rod
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, cylinder, join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color
from ...values import ConvexPart, Holder, Slot, read_room


@category("candlestick", size=(0.126, 0.092, 0.245), mass=0.4, material="metal", hollow=True,
          assembled=True,
          aliases=("candle holder", "candleholder", "candlestick holder", "candle stick"),
          themes=("dining", "living"), roles=("tall",), colors=("brass", "silver"),
          opened="empty_candlestick")  # fmt: skip
def candlestick(look: Look) -> Shape:
    """A candle in a turned, slim or saucer-shaped candlestick, or a candelabrum with candles."""
    color = look.color("brass", "silver", "gold", "black", "copper", "white", "wooden")
    skin = look.surface(color, look.pick(["metal", "ceramic"]))
    wax = surfaces.speckles(
        look.rng, look.own_color("white", "ivory", "cream", "red", "navy", "sage"), 4, 32
    )
    h = look.between(0.1, 0.17)
    kind = look.pick(["turned", "turned", "saucer", "three"])
    tall = look.between(0.1, 0.16)

    def candle(x: float, z: float, long: float) -> list[tuple[Solid, surfaces.Tile]]:
        stick = lathe(
            [(0, 0), (0.0105, 0), (0.0098, long), (0.006, long + 0.002), (0, long + 0.001)], 18
        )
        wick = cylinder(0.0009, 0.009, 6).move(z=long)
        found = [(stick.move(x=x, z=z), wax), (wick.move(x=x, z=z), surfaces.plain((40, 34, 30)))]
        if lit:
            flame = lathe([(0, 0), (0.0045, 0.006), (0.003, 0.014), (0, 0.024)], 12).move(
                z=long + 0.006
            )
            found.append((flame.move(x=x, z=z), surfaces.gradient((246, 150, 40), (254, 240, 150),
                                                                  look.rng)))  # fmt: skip
        return found

    lit = look.chance(0.5)
    if kind == "saucer":
        dish = lathe([(0, 0), (0.04, 0), (0.058, 0.012), (0.056, 0.014), (0.038, 0.004),
                      (0.016, 0.004), (0.015, 0.03), (0.012, 0.03), (0.012, 0.02), (0, 0.02)],
                     30)  # fmt: skip
        ear = torus(0.014, 0.0035, 18, 8).turn(0, np.pi / 2).move(x=0.066, z=0.0185)
        pieces = [(join([dish, ear]), skin), *candle(0, 0.02, tall * 0.8)]
        return shape(pieces, [hull_part(dish.vertices[dish.vertices[:, 2] < 0.015]),
                              cylinder_part(0.015, 0.03), cylinder_part(0.0098, 0.8 * tall,
                                                                        (0, 0, 0.02)),
                              hull_of(ear)])  # fmt: skip
    foot = lathe([(0, 0), (0.042, 0), (0.042, 0.006), (0.02, 0.016), (0.008, 0.026),
                  (0.0065, 0.4 * h), (0.013, 0.47 * h), (0.0065, 0.54 * h), (0.008, 0.86 * h),
                  (0.018, 0.95 * h), (0.017, h), (0.0115, h), (0.0115, h - 0.01), (0, h - 0.01)],
                 28)  # fmt: skip
    parts = [
        cylinder_part(0.042, 0.007),
        cylinder_part(0.01, 0.9 * h),
        cylinder_part(0.0175, 0.06 * h, (0, 0, 0.94 * h)),
    ]
    pieces = [(foot, skin), *candle(0, h - 0.01, tall)]
    parts.append(cylinder_part(0.0098, tall, (0, 0, h - 0.01)))
    if kind == "three":
        cup = lathe([(0, -0.008), (0.006, -0.006), (0.017, 0.004), (0.0165, 0.012), (0, 0.012)], 20)
        for s in (-1, 1):
            arm = tube(smooth([(0, 0, 0.5 * h), (s * 0.04, 0, 0.42 * h), (s * 0.062, 0, 0.6 * h),
                               (s * 0.062, 0, 0.84 * h)], 4), 0.0045, 8)  # fmt: skip
            holder = cup.move(x=s * 0.062, z=0.84 * h)
            pieces += [(join([arm, holder]), skin),
                       *candle(s * 0.062, 0.84 * h + 0.012, 0.8 * tall)]  # fmt: skip
            parts += [
                hull_of(arm),
                hull_of(holder),
                cylinder_part(0.0098, 0.8 * tall, (s * 0.062, 0, 0.84 * h + 0.012)),
            ]
    return shape(pieces, parts)


@category("candle", size=(0.075, 0.075, 0.12), mass=0.2, material="wax", assembled=True,
          aliases=("scented candle", "pillar candle", "candle wick"),
          themes=("dining", "vanity", "living"), roles=("round",), colors=("cream", "white"),
          common=True)  # fmt: skip
def candle(look: Look) -> Shape:
    """A pillar candle on a dish, or a scented candle in a glass."""
    r, h = look.between(0.026, 0.036), look.between(0.06, 0.13)
    wax = look.color(
        *("cream", "white", "red", "sage", "lavender", "coral", "navy", "mustard", "pink", "black")
    )
    pale = 1.35 if sum(wax) > 240 else 1.06  # black wax is not tinted
    tile = surfaces.gradient(wax, tint_color(wax, pale), look.rng, 3)
    if look.chance(0.35):
        tile = glaze_tile(look, wax)
    wick = cylinder(0.0014, 0.016, 6).move(z=h - 0.004)
    flame = lathe([(0, 0), (0.0045, 0.008), (0.0035, 0.014), (0, 0.026)], 12).move(z=h + 0.008)
    fire = surfaces.gradient((255, 150, 40), (255, 236, 140), look.rng, 0)
    lit = [(wick, surfaces.plain((40, 36, 34))), (flame, fire)]
    tip = cylinder_part(0.003, 0.03, (0, 0, h))
    if look.chance(0.55):
        dish = lathe([(0, 0), (0.9 * r, 0), (1.5 * r, 0.01), (1.45 * r, 0.012), (0.9 * r, 0.004),
                      (0, 0.004)], 28)  # fmt: skip
        body = cylinder(r, h - 0.003, 28, bevel=0.002).move(z=0.003)
        metal = surfaces.brushed_metal(look.rng, look.own_color("gold", "silver", "black"))
        return shape([(body, tile), (dish, metal), *lit],
                     [hull_of(dish), cylinder_part(r, h - 0.003, (0, 0, 0.003)), tip])  # fmt: skip
    glass = lathe([(0, 0), (r, 0), (1.05 * r, h + 0.012), (1.05 * r - 0.003, h + 0.012),
                   (r - 0.002, h - 0.004), (0, h - 0.004)], 28,
                  v=[0, 0, 0.9, 0.93, 0.98, 1])  # fmt: skip
    word = look.pick(["CALM", "FIG", "CEDAR", "ROSE", "AMBER", "SEA"])
    ink = look.own_color("charcoal", "gold", "teal", "brown", "navy")
    print_ = prints.label(look.rng, word, ink, look.pick([tint_color(wax, 1.3), (246, 244, 238)]))
    skin = surfaces.stack((print_, 90), (tile, 10), side=128)
    return shape([(glass, skin), *lit], [cylinder_part(r, h), tip])


_ROOM = (0.022, 0.022, 0.22)
"""Size of the candle for which a socket is made by default, in metres."""


_PLAY = 0.0007  # clearance on each side of a candle, metres
_DEPTH = 0.036  # metres


def _socket(half: float, at: tuple[float, float, float]) -> tuple[Solid, list[ConvexPart]]:
    """Return a socket for a candle of half width ``half``, and its walls as collision parts."""
    hole, sides = half + _PLAY, 8
    outer = hole + 0.004
    turn = np.pi / sides
    r, w = hole / np.cos(turn), outer / np.cos(turn)
    cup = lathe(
        [(0, -0.006), (w, -0.006), (w, _DEPTH), (r, _DEPTH), (r, 0.0), (0, 0.0)], sides
    ).move(*at)
    walls = []
    for k in range(sides):
        angles = 2 * turn * np.array([k, k + 1])
        ring = np.vstack([radius * np.column_stack([np.cos(angles), np.sin(angles)])
                          for radius in (r, w)])  # fmt: skip
        walls.append(hull_part(np.vstack([np.column_stack([ring, np.full(4, z)]) + at
                                          for z in (0.0, _DEPTH)])))  # fmt: skip
    angles = 2 * turn * np.arange(sides)
    rim = w * np.column_stack([np.cos(angles), np.sin(angles)])
    floor = np.vstack([np.column_stack([rim, np.full(sides, z)]) for z in (-0.006, 0.0)]) + at
    return cup, [hull_part(floor), *walls]


@category("empty_candlestick", size=(0.095, 0.095, 0.125), mass=0.45, material="metal",
          assembled=True, aliases=("empty candle holder",), themes=("dining", "living"),
          roles=("tall",), holder=Holder("end", (0.05, 0.05, 0.3)))  # fmt: skip
def empty_candlestick(look: Look) -> Shape:
    """An empty turned candlestick, with arms if it is for several candles."""
    if int(look.attributes.get("places", 1)) > 1:
        return empty_candelabra(look)
    a, b, _ = read_room(look.attributes.get("room"), _ROOM)
    half, h = max(a, b) / 2, look.between(0.075, 0.12)
    skin = look.surface(look.color("brass", "silver", "gold", "black", "copper", "white", "wooden"),
                        look.pick(["metal", "ceramic"]))  # fmt: skip
    foot = max(0.046, 2.6 * half)
    stem = lathe(
        [(0, 0), (foot, 0), (foot, 0.006), (0.5 * foot, 0.016), (0.011, 0.026), (0.008, 0.4 * h),
         (0.016, 0.5 * h), (0.008, 0.6 * h), (0.01, h - 0.006), (0, h - 0.006)], 26,
    )  # fmt: skip
    cup, parts = _socket(half, (0.0, 0.0, h))
    body = [cylinder_part(foot, 0.008), cylinder_part(0.011, h - 0.014, (0, 0, 0.008))]
    slots = [Slot(np.array([0.0, 0.0, h]))]
    return shape([(join([stem, cup]), skin)], [*body, *parts], slots=slots)


def empty_candelabra(look: Look) -> Shape:
    """An empty candelabrum with arms in one plane, each carrying a socket."""
    a, b, _ = read_room(look.attributes.get("room"), _ROOM)
    count = max(1, min(9, int(look.attributes.get("places", 3))))
    half, arms = max(a, b) / 2, max(count, 3)
    metal = look.surface(look.color("silver", "gold", "black", "brass", "bronze"), "metal")
    step, top = max(0.05, 5.2 * half), 0.17
    reach = (arms - 1) / 2 * step
    foot = max(0.06, 0.45 * reach)
    solids: list[Solid] = [
        lathe([(0, 0), (foot, 0), (foot, 0.007), (0.35 * foot, 0.02), (0.009, 0.035),
               (0.007, 0.08), (0.013, 0.088), (0.007, 0.096), (0.007, top - 0.03),
               (0, top - 0.03)], 26)
    ]  # fmt: skip
    parts: list[ConvexPart] = [cylinder_part(foot, 0.009), cylinder_part(0.01, top - 0.04)]
    places = [(k - (arms - 1) / 2) * step for k in range(arms)]
    for x in places:
        arm = rod([(0, 0, top - 0.05), (0.6 * x, 0, top - 0.045), (x, 0, top - 0.03),
                   (x, 0, top - 0.004)], 0.0045, 8)  # fmt: skip
        cup, walls = _socket(half, (x, 0.0, top))
        solids += [arm, cup]
        parts += [hull_of(arm), *walls]
    used = [places[round(k)] for k in np.linspace(0, arms - 1, count)]
    slots = [Slot(np.array([x, 0.0, top])) for x in used]
    return shape([(join(solids), metal)], parts, slots=slots)


@category("long_candle", size=(0.021, 0.021, 0.182), mass=0.05, material="wax",
          aliases=("dinner stick candle",), themes=("dining", "living"),
          roles=("tall", "round"))  # fmt: skip
def long_candle(look: Look) -> Shape:
    """A long straight candle for a candlestick."""
    r, h = 0.0105, look.between(0.15, 0.2)
    wax = surfaces.speckles(
        look.rng, look.color("white", "ivory", "cream", "red", "navy", "sage"), 4, 32
    )
    stick = lathe([(0, 0), (r, 0), (0.96 * r, h - 0.004), (0.6 * r, h), (0, h)], 18)
    wick = cylinder(0.0009, 0.009, 6).move(z=h - 0.002)
    return shape([(stick, wax), (wick, surfaces.plain((40, 34, 30)))], [cylinder_part(0.97 * r, h)])


CATEGORIES = (
    Category("empty_candelabra", empty_candelabra, size=(0.14, 0.12, 0.194), mass=0.8,
             material="metal", assembled=True, themes=("dining", "living"), roles=("tall",),
             holder=Holder("end", (0.05, 0.05, 0.3))),
)  # fmt: skip
"""Objects that share their drawing functions."""
