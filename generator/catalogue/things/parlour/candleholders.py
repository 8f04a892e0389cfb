"""Candlesticks and candelabra that stand empty, and the candles that a text puts into them."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart, Slot
from ...build.category import Category
from ...build.collision import cylinder_part, hull_of, hull_part
from ...build.recipes import rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, join, lathe
from ...holder import Holder, read_room
from ...surfaces import textures
from ...surfaces.look import Look

_ROOM = (0.022, 0.022, 0.22)
"""The candle that a socket is made for where none is given, metres."""
_PLAY = 0.0007  # metres of room on each side of a candle
_DEPTH = 0.036  # metres


def _socket(half: float, at: tuple[float, float, float]) -> tuple[Solid, list[ConvexPart]]:
    """Return a cup for a candle of half width ``half`` on a place, and its walls."""
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


def empty_candlestick(look: Look) -> Shape:
    """A turned candlestick, empty; for several candles it has arms."""
    if int(look.attributes.get("places", 1)) > 1:
        return empty_candelabra(look)
    a, b, _ = read_room(look.attributes.get("room"), _ROOM)
    half, h = max(a, b) / 2, look.between(0.075, 0.12)
    skin = look.surface(
        look.color("brass", "silver", "gold", "black", "copper", "white", "wooden"),
        look.pick(["metal", "ceramic"]),
    )
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
    """A candelabra without candles: arms in one plane, a socket on each."""
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


def long_candle(look: Look) -> Shape:
    """A long straight candle, to be put into a candlestick."""
    r, h = 0.0105, look.between(0.15, 0.2)
    wax = textures.speckles(
        look.rng, look.color("white", "ivory", "cream", "red", "navy", "sage"), 4, 32
    )
    stick = lathe([(0, 0), (r, 0), (0.96 * r, h - 0.004), (0.6 * r, h), (0, h)], 18)
    wick = cylinder(0.0009, 0.009, 6).move(z=h - 0.002)
    return shape([(stick, wax), (wick, textures.plain((40, 34, 30)))], [cylinder_part(0.97 * r, h)])


_HOLDER = Holder("end", (0.05, 0.05, 0.3))

CATEGORIES = (
    Category("empty_candlestick", empty_candlestick, (0.095, 0.095, 0.125), 0.45,
             ("empty candle holder",), ("dining", "living"), ("tall",), holder=_HOLDER),
    Category("empty_candelabra", empty_candelabra, (0.14, 0.12, 0.194), 0.8,
             (), ("dining", "living"), ("tall",), holder=_HOLDER),
    Category("long_candle", long_candle, (0.021, 0.021, 0.182), 0.05,
             ("dinner stick candle",), ("dining", "living"), ("tall", "round")),
)  # fmt: skip
