"""Fittings: hinges, brackets, hooks, chains, ropes, magnets."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, ring_parts
from ...build.outlines import arc, ellipse, rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism, sweep, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .hardware_parts import METALS
from .tools import steel


def _holes(places: list[tuple[float, float]], z: float, r: float = 0.003) -> Solid:
    return join([cylinder(r, 0.0005, 14).move(x, y, z - 0.0001) for x, y in places])


def hinge(look: Look) -> Shape:
    """A door hinge lying open: two plates and a knuckle."""
    k = look.between(0.85, 1.12)
    metal = look.surface(look.color(*METALS), "metal")
    long, wide, h = 0.075 * k, 0.03 * k, 0.0026
    plates = [block(wide, long, h, 0.004).move(x=s * (wide / 2 + 0.002)) for s in (-1, 1)]
    r = 0.0042 * k
    knuckle = [cylinder(r, long / 5 - 0.0006, 16).turn(0, -np.pi / 2).move(
        y=-long / 2 + n * long / 5, z=r) for n in range(5)]  # fmt: skip
    spots = [(s * x * wide, y * long) for s in (-1, 1) for x, y in ((0.6, -0.34), (0.75, 0.0),
                                                                    (0.6, 0.34))]  # fmt: skip
    return shape([(join([*plates, *knuckle]), metal), (_holes(spots, h), textures.plain((36, 34,
                                                                                         34)))],
                 [*(hull_of(s) for s in plates), hull_of(*knuckle)])  # fmt: skip


def bracket(look: Look) -> Shape:
    """An angle bracket standing: one arm on the table, one upright."""
    k = look.between(0.85, 1.15)
    metal = look.surface(look.color(*METALS, "white", "black"), "metal")
    a, wide, t = 0.06 * k, 0.022 * k, 0.0028
    foot = box(a, wide, t)
    wall = box(t, wide, a).move(x=-a / 2 + t / 2)
    dark = textures.plain((36, 34, 34))
    spots = _holes([(-0.012 * k, 0), (0.016 * k, 0)], t)
    side = _holes([(0.02 * k, 0), (0.046 * k, 0)], 0.0).turn(1, -np.pi / 2).scale(1, 1, 1)
    side = side.move(x=-a / 2 + t + 0.0003)
    rib = prism(np.array([(0, 0), (0.018, 0), (0, 0.018)]) * k, -0.003 * k, 0.003 * k)
    rib = rib.turn(0, np.pi / 2).move(x=-a / 2 + t, z=t)
    return shape([(join([foot, wall, rib]), metal), (join([spots, side]), dark)],
                 [hull_of(foot), hull_of(wall)])  # fmt: skip


def wall_hook(look: Look) -> Shape:
    """A coat hook lying on its plate, the hook upwards."""
    k = look.between(0.85, 1.15)
    metal = look.surface(look.color(*METALS, "black", "white"), "metal")
    plate = block(0.026 * k, 0.075 * k, 0.005 * k, 0.008, 0.001)
    way = np.array([(0, -0.012, 0.004), (0, -0.018, 0.02), (0, -0.01, 0.036), (0, 0.008, 0.04),
                    (0, 0.022, 0.034)]) * k  # fmt: skip
    arm = tube(way, np.array([0.006, 0.0052, 0.005, 0.005, 0.0045]) * k, 10)
    tip = lathe([(0, -0.007 * k), (0.0055 * k, -0.004 * k), (0.007 * k, 0.0),
                 (0.0055 * k, 0.004 * k), (0, 0.007 * k)], 14).move(*way[-1])  # fmt: skip
    dark = textures.plain((40, 38, 38))
    return shape([(join([plate, arm, tip]), metal), (_holes([(0, 0.03 * k), (0, -0.031 * k)],
                                                            0.005 * k), dark)],
                 [hull_of(plate), hull_of(arm), hull_of(tip)])  # fmt: skip


def chain(look: Look) -> Shape:
    """A piece of chain lying in a bow."""
    k = look.between(0.85, 1.15)
    metal = look.surface(look.color("silver", "gray", "charcoal", "gold", "brass"), "metal")
    links, n, r = [], 11, 0.0018 * k
    long = 0.008 * k
    ring = ellipse(2 * long, 1.15 * long, 12)
    bow = look.between(0.9, 1.4)
    for m in range(n):
        t = (m - (n - 1) / 2) / n
        way = np.column_stack([ring, np.zeros(12)])
        link = tube(way, r, 6, loop=True)
        link = link.turn(0, 0.35 if m % 2 else -0.75).turn(2, -2 * bow * t * 1.1)
        link = link.move(0.0118 * k * (m - (n - 1) / 2) * (1 - 0.1 * abs(t)),
                         -0.06 * k * bow * t * t * 2)  # fmt: skip
        links.append(link)
    links = [s.move(z=-float(s.bounds[0, 2])) for s in links]
    return shape([(join(links), metal)], [hull_of(s) for s in links])


def rope(look: Look) -> Shape:
    """A coil of rope lying, its end wound round it."""
    k = look.between(0.85, 1.1)
    color = look.color("tan", "beige", "white", "blue", "tan", "orange", "green")
    strands = textures.stripes([color, tint_color(color, 0.78), tint_color(color, 1.15)], 24,
                               side=192)  # fmt: skip
    r, tilt = 0.006 * k, 1.0
    t = np.linspace(0, 1, 150)
    a = 2 * np.pi * 6 * t
    away = (0.056 + 0.012 * np.sin(2.7 * a * tilt)) * k
    z = r + (0.026 * k) * (0.5 - 0.5 * np.cos(1.31 * a)) * (0.35 + 0.65 * t)
    coil = tube(np.column_stack([1.2 * away * np.cos(a), away * np.sin(a), z]), r, 7)
    b = 2 * np.pi * np.linspace(0, 2.6, 40)
    wind = np.column_stack([0.024 * np.cos(b) * k, (0.021 - 0.009 * b / 2 / np.pi) * k,
                            (0.021 + 0.02 * np.sin(b)) * k])  # fmt: skip
    wind = tube(wind @ np.array([[0, 1, 0], [1, 0, 0], [0, 0, 1]]) + [0.066 * k, 0, 0], r, 7)
    high = float(coil.bounds[1, 2])
    return shape([(coil, strands), (wind, strands)],
                 ring_parts([(0.068 * k, 0.0005), (0.068 * k, 0.9 * high)],
                            [(0.042 * k, 0.9 * high), (0.042 * k, 0.0005)], 10,
                            stretch=(1.2, 1.0)))  # fmt: skip


def horseshoe_magnet(look: Look) -> Shape:
    """A red horseshoe magnet lying, its poles bare."""
    k = look.between(0.85, 1.15)
    color = look.color("red", "red", "crimson", "blue")
    h = 0.012 * k
    curve = arc((0, 0), 0.024, 0, np.pi, 14)
    bow = np.concatenate([[(0.024, -0.022)], curve, [(-0.024, -0.022)]]) * k
    path = np.column_stack([bow, np.full(len(bow), h / 2)])
    body = sweep(path, rectangle(0.013 * k, h))
    tips = [box(0.0134 * k, 0.014 * k, h + 0.0004).move(s * 0.024 * k, -0.028 * k) for s in (-1, 1)]
    n = len(path)
    hulls = [hull_of(sweep(path[a:b], rectangle(0.013 * k, h))) for a, b in
             ((0, 4), (3, 7), (6, 11), (10, 14), (13, n))]  # fmt: skip
    return shape([(body, textures.speckles(look.rng, color, 4, 32)), (join(tips), steel(look))],
                 [*hulls, *(hull_of(s) for s in tips)])  # fmt: skip


def bar_magnet(look: Look) -> Shape:
    """A bar magnet, one half red, the other blue."""
    k = look.between(0.85, 1.15)
    color = look.color("red", "red", "crimson")
    x, y, h = 0.08 * k, 0.018 * k, 0.01 * k
    halves = [box(x / 2, y, h).move(x=s * x / 4) for s in (-1, 1)]
    other = look.own_color("blue", "navy", "white", "silver")
    marks = [box(0.004 * k, 0.01 * k, 0.0006).move(s * 0.4 * x, 0, h - 0.0002) for s in (-1, 1)]
    return shape([(halves[0], textures.speckles(look.rng, color, 3, 32)),
                  (halves[1], textures.speckles(look.rng, other, 3, 32)),
                  (join(marks), textures.plain((246, 246, 242)))], [box_part(x, y, h)])  # fmt: skip


CATEGORIES = (
    Category("hinge", hinge, (0.063, 0.074, 0.0083), 0.05, ("door hinge", "butt hinge",
             "cabinet hinge"), ("workbench",), ("flat",), ("brass", "silver")),
    Category("bracket", bracket, (0.06, 0.022, 0.06), 0.05, ("angle bracket", "l bracket",
             "corner bracket", "shelf bracket", "metal bracket", "stabiliser"), ("workbench",), (),
             ("silver",)),
    Category("wall_hook", wall_hook, (0.026, 0.075, 0.046), 0.05, ("hook", "coat hook",
             "metal hook", "towel hook", "key hook", "picture hanging kit", "wall peg"),
             ("workbench",),
             (),
             ("silver",)),
    Category("chain", chain, (0.112, 0.0415, 0.0088), 0.08, ("metal chain", "steel chain",
             "iron chain", "chain link", "length of chain", "master link", "bike chain"),
             ("workbench",), (), ("silver",)),
    Category("rope", rope, (0.185, 0.135, 0.045), 0.15, ("coil of rope", "rope coil",
             "coiled rope", "cord", "nautical rope", "climbing rope", "paracord bundle",
             "loop of rope", "paracord", "leash rope"), ("workbench",), (),
             ("tan",), 0.6),
    Category("horseshoe_magnet", horseshoe_magnet, (0.061, 0.066, 0.0124), 0.08, ("magnet",
             "u magnet", "toy magnet"), ("workbench",), ("flat",), ("red",)),
    Category("bar_magnet", bar_magnet, (0.08, 0.018, 0.0104), 0.07, ("magnetic bar",
             "magnet bar", "rod magnet"), ("workbench",), ("flat",), ("red",)),
)  # fmt: skip
"""The module's categories."""
