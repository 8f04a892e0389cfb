"""Objects of the ``breakfast`` theme: tableware."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of, lift_parts, open_vessel
from ...kit.shapes import Shape, category, shape
from ...kit.solids import block, cylinder, ellipsoid, join, lathe, tube
from ...kit.surfaces import Look, readable_on
from ...values import Holder
from ..dining.bowls import china
from ..kitchen.racks import _wire, centres, choose_slots, read_request

CHINA = ("white", "white", "cream", "sky", "navy", "sage", "terracotta", "black", "teal")


@category("butter_dish", size=(0.164, 0.0991, 0.0943), mass=0.55, material="ceramic", hollow=True,
          aliases=("butter box", "butter keeper"), themes=("breakfast", "dining"),
          colors=("white", "sky"))  # fmt: skip
def butter_dish(look: Look) -> Shape:
    """A butter dish: a flat tray covered by a lid with a knob."""
    x, y, h = look.between(0.15, 0.175), look.between(0.09, 0.105), look.between(0.055, 0.065)
    color = look.color(*CHINA)
    plain = look.surface(color, "ceramic")
    tray = block(x, y, 0.012, 0.022, 0.004)
    rim = block(0.99 * x, 0.99 * y, 0.004, 0.022, 0.001).move(z=0.0115)
    lid = block(0.78 * x, 0.7 * y, h, 0.014, 0.008).move(z=0.0135)
    knob = lathe([(0, 0), (0.006, 0), (0.005, 0.006), (0.011, 0.013), (0.008, 0.02), (0, 0.021)],
                 20).move(z=h + 0.0125)  # fmt: skip
    face = look.pick([glaze_tile(look, color), plain])
    wood = look.surface(look.own_color("wooden", "tan"), "wood")
    return shape([(join([tray, rim]), look.pick([plain, wood])), (lid, face), (knob, plain)],
                 [hull_of(tray, rim), hull_of(lid), hull_of(knob)])  # fmt: skip


@category("egg_cup", size=(0.0655, 0.0655, 0.0613), mass=0.1, material="ceramic", assembled=True,
          aliases=("eggcup", "egg holder", "egg stand"), themes=("breakfast",),
          roles=("container", "round"), colors=("white", "yellow"))  # fmt: skip
def egg_cup(look: Look) -> Shape:
    """A footed egg cup."""
    r, h = look.between(0.031, 0.034), look.between(0.054, 0.064)
    tile, plain = china(look, "white", "yellow", "sky", "red", "mint", "wooden", "pink")
    side = [(0.42 * r, 0.45 * h), (0.8 * r, 0.58 * h), (0.97 * r, 0.8 * h), (r, h)]
    cup, parts = open_vessel([(a, z - 0.45 * h) for a, z in side], 0.003, 0.004)
    foot = lathe([(0, 0), (0.85 * r, 0), (0.8 * r, 0.06 * h), (0.3 * r, 0.2 * h),
                  (0.3 * r, 0.38 * h), (0.42 * r, 0.47 * h), (0, 0.47 * h)], 26)  # fmt: skip
    pieces = [(cup.move(z=0.45 * h), tile), (foot, plain)]
    made = [*lift_parts(parts, 0.45 * h), cylinder_part(0.84 * r, 0.08 * h),
            cylinder_part(0.3 * r, 0.42 * h, (0, 0, 0.06 * h))]  # fmt: skip
    return shape(pieces, made)


@category("toast_rack", size=(0.159, 0.0853, 0.124), mass=0.3, material="metal", assembled=True,
          aliases=("toast holder",), themes=("breakfast",), colors=("silver",),
          opened="empty_toast_rack")  # fmt: skip
def toast_rack(look: Look) -> Shape:
    """A toast rack with hoops on a base and a few slices of toast in it."""
    x, y, h = look.between(0.15, 0.18), look.between(0.08, 0.095), look.between(0.09, 0.105)
    color = look.color("silver", "silver", "black", "copper", "white", "wooden")
    skin = look.surface(color, "metal")
    base = block(x, y, 0.006, 0.012, 0.001).move(z=0.012)
    feet = [cylinder(0.006, 0.013, 12).move(a * 0.42 * x, b * 0.38 * y) for a in (-1, 1)
            for b in (-1, 1)]  # fmt: skip
    count = 6
    at = [(k / (count - 1) - 0.5) * 0.88 * x for k in range(count)]
    hoops = [tube(smooth([(u, -0.42 * y, 0.015), (u, -0.4 * y, 0.6 * h), (u, 0, h),
                          (u, 0.4 * y, 0.6 * h), (u, 0.42 * y, 0.015)], 4), 0.0023, 6)
             for u in at]  # fmt: skip
    loop = tube(smooth([(0, -0.012, h - 0.002), (0, -0.012, h + 0.02), (0, 0.012, h + 0.02),
                        (0, 0.012, h - 0.002)], 4), 0.0023, 6)  # fmt: skip
    pieces = [(join([base, *feet, *hoops, loop]), skin)]
    parts = [box_part(0.88 * x, 0.8 * y, 0.018), *(box_part(0.004, 0.8 * y, 0.7 * h, (u, 0, 0.016))
             for u in at)]  # fmt: skip
    slices = [
        block(0.09, 0.082, 0.011, 0.01).turn(1, np.pi / 2).move(0.5 * (a + b) - 0.0055, 0, 0.0615)
        for a, b in ((at[0], at[1]), (at[2], at[3]), (at[4], at[5]))
    ]
    chosen = slices[: int(look.rng.integers(0, 4))]
    if chosen:
        crust = surfaces.spots(look.rng, (214, 164, 98), (160, 104, 56), 0.3)
        pieces.append((join(chosen), crust))
        parts += [hull_of(s) for s in chosen]
    return shape(pieces, parts)


_PLAY = 0.003  # clearance in a slot beside the object, metres


@category("empty_toast_rack", size=(0.108, 0.097, 0.101), mass=0.3, material="metal",
          aliases=("empty toast holder",), themes=("breakfast",), colors=("silver",),
          holder=Holder("edge", (0.04, 0.16, 0.16)))  # fmt: skip
def empty_toast_rack(look: Look) -> Shape:
    """An empty toast rack with hoops on a base."""
    count, (a, b, c) = read_request(look, 4, (0.0144, 0.116, 0.116))
    color = look.color("silver", "silver", "black", "copper", "white", "wooden")
    skin = look.surface(color, "metal")
    cells, r, floor = max(count, 4), 0.0024, 0.018
    pitch = a + _PLAY + 2 * r
    x, y, h = cells * pitch + 0.016, 0.84 * b, floor + 0.72 * c
    base = block(x, y, 0.006, 0.012, 0.001).move(z=floor - 0.006)
    feet = [cylinder(0.006, 0.013, 12).move(i * 0.42 * x, j * 0.38 * y) for i in (-1, 1)
            for j in (-1, 1)]  # fmt: skip
    at = centres(cells + 1, pitch)
    bow = [(-0.42 * y, floor - 0.002), (-0.4 * y, 0.66 * h), (-0.2 * y, 0.91 * h), (0.0, h),
           (0.2 * y, 0.91 * h), (0.4 * y, 0.66 * h), (0.42 * y, floor - 0.002)]  # fmt: skip
    hoops = [_wire((u, *a), (u, *b), r) for u in at for a, b in pairwise(bow)]
    spans = [hull_of(*hoops[k:n]) for m in range(0, len(hoops), 6)
             for k, n in ((m, m + 1), (m + 1, m + 3), (m + 3, m + 5), (m + 5, m + 6))]  # fmt: skip
    parts = [hull_of(base), *map(hull_of, feet), *spans]
    slots = choose_slots(centres(cells, pitch), count, floor)
    return shape([(join([base, *feet, *hoops]), skin)], parts, slots=slots)


@category("honey_pot", size=(0.0991, 0.0991, 0.151), mass=0.45, material="ceramic",
          aliases=("pot of honey", "honeypot"), themes=("breakfast",), roles=("round",),
          colors=("gold",))  # fmt: skip
def honey_pot(look: Look) -> Shape:
    """A bulbous honey pot with the word HONEY on its front and a honey dipper sticking out."""
    r, h = look.between(0.045, 0.055), look.between(0.085, 0.105)
    color = look.color("gold", "yellow", "cream", "terracotta", "white")
    image = prints.canvas(256, 128, color)
    prints.write(image[:, 86:170], "HONEY", 0.5, 0.5, 0.26, readable_on(color), bold=True)
    body = lathe([(0, 0), (0.72 * r, 0), (0.96 * r, 0.2 * h), (r, 0.45 * h), (0.86 * r, 0.78 * h),
                  (0.7 * r, 0.88 * h), (0.78 * r, h), (0.68 * r, h), (0.6 * r, 0.92 * h),
                  (0, 0.92 * h)], 32, v=[0, 0.01, 0.2, 0.45, 0.8, 0.9, 0.97, 0.98, 0.99,
                                         1])  # fmt: skip
    honey = cylinder(0.66 * r, 0.002, 28).move(z=0.93 * h)
    drip = [ellipsoid(0.016, 0.008, 0.03, 12, 8).turn(2, a).move(0.8 * r * np.sin(a), -0.8 * r
                                                                 * np.cos(a), 0.84 * h)
            for a in (-0.5, 0.2, 1.0)]  # fmt: skip
    stick = tube([(0, 0, 0.9 * h), (0.75 * r, 0.2 * r, 1.55 * h)], 0.0038, 8)
    gold = surfaces.gradient((222, 140, 20), (244, 184, 50), look.rng)
    wood = surfaces.wood(look.rng, (206, 164, 110))
    return shape([(body, image), (join([honey, *drip]), gold), (stick, wood)],
                 [hull_of(body), hull_of(stick)])  # fmt: skip
