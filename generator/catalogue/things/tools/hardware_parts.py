"""Bits of hardware and building material: boards, pipes, gears, springs, hinges, ropes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of, ring_parts
from ...build.outlines import arc
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import textures
from ...surfaces.look import Look
from .tools import lying

METALS = ("silver", "silver", "brass", "charcoal", "gray", "copper")
WOODEN = ("wooden", "tan", "beige", "brown", "wooden")


def _board(x: float, y: float, h: float) -> Callable[[Look], Shape]:
    """A sawn piece of wood lying flat."""

    def make(look: Look) -> Shape:
        k = look.between(0.88, 1.1)
        body = box(x * k, y * k, h * k)
        tile = look.surface(look.color(*WOODEN), "wood")
        return shape([(body, tile)], [hull_of(body)])

    return make


def _rod(radius: float, long: float, palette: tuple[str, ...], material: str) -> Callable:
    """A round rod lying, flattened a little below so that it stays."""

    def make(look: Look) -> Shape:
        k = look.between(0.88, 1.1)
        r = radius * k
        body = lying(cylinder(r, long * k, 24, bevel=0.1 * r), -long * k / 2, r)
        tile = look.surface(look.color(*palette), material)
        return shape([(body, tile)], [flat_foot(body.vertices, 0.08)])

    return make


def pipe(look: Look) -> Shape:
    """A length of pipe lying."""
    k = look.between(0.88, 1.1)
    color = look.color("silver", "copper", "white", "gray", "copper", "charcoal")
    r, long = 0.014 * k, 0.2 * k
    body = lathe([(0.82 * r, 0), (r, 0), (r, long), (0.82 * r, long)], 24, loop=True)
    body = lying(body, -long / 2, r)
    outer = lying(cylinder(r, long, 24), -long / 2, r)
    return shape([(body, look.surface(color, "metal"))], [flat_foot(outer.vertices, 0.08)])


def pipe_fitting(look: Look) -> Shape:
    """An elbow or tee that joins pipes, lying."""
    k = look.between(0.85, 1.15)
    color = look.color("copper", "silver", "white", "brass", "charcoal", "gray")
    r = 0.013 * k
    tile = look.surface(color, "metal")
    if look.chance(0.6):
        way = arc((0.024, 0.024), 0.024, np.pi, 1.5 * np.pi, 8)
        way = np.concatenate([[(0, 0.036)], way, [(0.036, 0)]]) * k
    else:
        way = np.array([(-0.036, 0), (0.036, 0)]) * k
    path = np.column_stack([way, np.full(len(way), 1.16 * r)])
    pieces = [tube(path, r, 20)]
    ends = [(path[0], path[1]), (path[-1], path[-2])]
    if len(way) == 2:
        stem = np.array([(0, 0, 1.16 * r), (0, 0.036 * k, 1.16 * r)])
        pieces.append(tube(stem, r, 20))
        ends.append((stem[1], stem[0]))
    holes = []
    for tip, inner in ends:
        way_out = (tip - inner) / np.linalg.norm(tip - inner)
        pieces.append(tube([tip - 0.012 * k * way_out, tip], 1.16 * r, 20))
        holes.append(tube([tip - 0.002 * way_out, tip + 0.0004 * way_out], 0.84 * r, 20))
    hulls = [hull_of(s) for s in pieces[1:]]
    thirds = len(path) // 2 + 1
    hulls += [hull_of(tube(path[:thirds], r, 12)), hull_of(tube(path[thirds - 1 :], r, 12))] if (
        len(path) > 2) else [hull_of(pieces[0])]  # fmt: skip
    return shape([(join(pieces), tile), (join(holes), textures.plain((24, 24, 26)))], hulls)


def valve(look: Look) -> Shape:
    """A valve lying: a short pipe with nuts at its ends, a handwheel on top."""
    k = look.between(0.85, 1.12)
    color = look.color("brass", "brass", "silver", "copper")
    wheel = look.own_color("red", "blue", "red", "green")
    r = 0.0125 * k
    z = 1.35 * r
    body = lying(cylinder(r, 0.07 * k, 20), -0.035 * k, z)
    nuts = [lying(cylinder(1.42 * r, 0.016 * k, 6).turn(2, np.pi / 6), x * k, z)
            for x in (-0.04, 0.024)]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s in nuts)
    neck = cylinder(0.011 * k, 0.03 * k, 18, top=0.007 * k).move(z=z)
    stem = cylinder(0.003 * k, 0.03 * k, 10).move(z=z + 0.028 * k)
    top = z + 0.05 * k
    rim = torus(0.021 * k, 0.0034 * k, 28, 8).move(z=top)
    spokes = [box(0.04 * k, 0.004 * k, 0.003 * k).turn(2, a).move(z=top - 0.0015 * k)
              for a in (0.3, 0.3 + np.pi / 2)]  # fmt: skip
    solids = [s.move(z=-low) for s in (body, *nuts, neck, stem, rim, *spokes)]
    metal = look.surface(color, "metal")
    return shape([(join(solids[:5]), metal), (join(solids[5:]), textures.speckles(
                  look.rng, wheel, 4, 32))],
                 [hull_of(solids[0]), *(flat_foot(s.vertices, 0.15) for s in solids[1:3]),
                     hull_of(solids[3]), hull_of(solids[4]),
                     hull_of(solids[5])])  # fmt: skip


def gear(look: Look) -> Shape:
    """A toothed wheel lying flat."""
    k = look.between(0.8, 1.2)
    color = look.color("silver", "brass", "charcoal", "red", "yellow", "blue", "gold")
    teeth, r, h = int(look.rng.integers(12, 20)), 0.03 * k, 0.009 * k
    angles, radii = [], []
    for n in range(teeth):
        for a, f in ((0.0, 0.86), (0.3, 0.86), (0.42, 1.0), (0.72, 1.0), (0.84, 0.86)):
            angles.append((n + a) * 2 * np.pi / teeth)
            radii.append(f * r)
    outline = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    body = prism(outline, 0, h)
    tile = look.surface(color, "metal")
    hub = cylinder(0.26 * r, h * 1.35, 24)
    dark = textures.plain((26, 26, 28))
    bore = cylinder(0.13 * r, 0.0005, 16).move(z=h * 1.35)
    holes = [cylinder(0.13 * r, 0.0005, 16).move(0.55 * r * np.cos(a), 0.55 * r * np.sin(a), h)
             for a in np.arange(5) * 2 * np.pi / 5]  # fmt: skip
    return shape([(join([body, hub]), tile), (join([bore, *holes]), dark)],
                 [cylinder_part(0.97 * r, h), hull_of(hub)])  # fmt: skip


def bearing(look: Look) -> Shape:
    """A ball bearing lying: two rings with a shield or balls between."""
    k = look.between(0.85, 1.2)
    color = look.color("silver", "silver", "gray", "charcoal")
    r, h = 0.02 * k, 0.011 * k
    metal = look.surface(color, "metal")
    rings = [lathe([(a * r, 0), (b * r, 0), (b * r, h), (a * r, h)], 34, loop=True)
             for a, b in ((0.42, 0.58), (0.82, 1.0))]  # fmt: skip
    shield = lathe([(0.57 * r, 0.08 * h), (0.83 * r, 0.08 * h), (0.83 * r, 0.9 * h),
                    (0.57 * r, 0.9 * h)], 34, loop=True)  # fmt: skip
    pieces = [(join(rings), metal)]
    if look.chance(0.5):
        pieces.append((shield, textures.plain(look.own_color("black", "blue", "red", "gray"))))
    else:
        balls = [lathe([(0, 0), (0.0026, 0.001), (0.0036, 0.0036), (0.0026, 0.0062), (0, 0.0072)],
                       12).scale(k, k, k).move(0.7 * r * np.cos(a), 0.7 * r * np.sin(a), 0.2 * h)
                 for a in np.arange(9) * 2 * np.pi / 9]  # fmt: skip
        web = shield.scale(1, 1, 0.4).move(z=0.3 * h)
        pieces.append((join(balls), textures.plain((226, 228, 232))))
        pieces.append((web, textures.plain((70, 66, 60))))
    return shape(pieces, ring_parts([(r, 0), (r, h)], [(0.42 * r, h), (0.42 * r, 0)], 10))


def spring(look: Look) -> Shape:
    """A coil spring standing."""
    k = look.between(0.85, 1.2)
    color = look.color("silver", "silver", "charcoal", "gold", "blue", "red")
    turns, r, h, wire = 6, 0.012 * k, 0.045 * k, 0.0016 * k
    t = np.linspace(0, 1, 110)
    a = 2 * np.pi * (turns + 2) * t
    z = wire + (h - 2 * wire) * np.clip((t * (turns + 2) - 1) / turns, 0, 1)
    coil = tube(np.column_stack([r * np.cos(a), r * np.sin(a), z]), wire, 6)
    return shape([(coil, look.surface(color, "metal"))],
                 ring_parts([(r + 0.9 * wire, 0.0002), (r + 0.9 * wire, 0.99 * h)],
                            [(r - wire, 0.99 * h), (r - wire, 0.0002)],
                            10))  # fmt: skip


def washer(look: Look) -> Shape:
    """A flat washer."""
    k = look.between(0.85, 1.3)
    r, hole, h = 0.0115 * k, 0.0055 * k, 0.0017
    body = lathe([(hole, 0), (r, 0), (r, h), (hole, h)], 32, loop=True)
    return shape([(body, look.surface(look.color(*METALS), "metal"))],
                 ring_parts([(r, 0), (r, h)], [(hole, h), (hole, 0)], 8))  # fmt: skip


CATEGORIES = (
    Category("plank", _board(0.3, 0.08, 0.018), (0.297, 0.079, 0.0178), 0.27, ("wooden plank",
             "wood plank", "wood board", "piece of wood", "lumber", "timber", "floorboard",
             "scrap wood", "balsa wood sheet"), ("workbench",), ("flat", "support"), ("wooden",)),
    Category("wood_block", _board(0.09, 0.06, 0.045), (0.089, 0.0594, 0.0446), 0.15,
             ("block of wood", "wooden brick", "sanding block", "rectangular wooden block",
             "balsa wood block"),
             ("workbench",), (), ("wooden",)),
    Category("dowel", _rod(0.008, 0.24, WOODEN, "wood"), (0.238, 0.0159, 0.0159), 0.03,
             ("wooden dowel", "wooden rod", "stick",
             "wooden stick", "dowel rod", "relay baton",
             "walking cane", "walking stick", "trekking pole", "tent pole", "barber pole",
             "niddy noddy", "drop spindle", "metal shaft", "shaft", "spoke", "mahl stick",
             "long stick", "stretcher bar"), ("workbench",),
             (), ("wooden",), None, "lying flat"),
    Category("metal_rod", _rod(0.006, 0.2, ("silver", "gray", "brass", "copper"), "metal"),
             (0.198, 0.0119, 0.0119), 0.15, ("steel rod", "metal bar", "rod", "iron rod",
             "steel bar", "seat post", "handlebar stem"), ("workbench",), (), ("silver",), None,
             "lying flat"),
    Category("pipe", pipe, (0.198, 0.0277, 0.0277), 0.15, ("metal pipe", "copper pipe",
             "pvc pipe", "steel pipe", "plastic pipe", "pipe section",
             "pipe segment"), ("workbench",), (),
             ("copper", "silver"), None, "lying flat"),
    Category("pipe_fitting", pipe_fitting, (0.062, 0.052, 0.03), 0.08, ("pipe elbow",
             "elbow joint", "pipe connector", "pipe joint", "elbow pipe", "pipe tee", "u-bend",
             "u bend", "hose coupling", "hose connector"),
             ("workbench",), (), ("copper",)),
    Category("valve", valve, (0.079, 0.0475, 0.07), 0.2, ("gate valve", "water valve",
             "stopcock", "shutoff valve"), ("workbench",), (), ("brass",)),
    Category("gear", gear, (0.059, 0.059, 0.012), 0.06, ("cogwheel", "cog", "gear wheel",
             "toothed wheel", "sprocket", "freewheel", "cassette sprocket",
             "pulley wheel", "gear set", "spirograph"), ("workbench",), ("flat", "round"),
             ("silver",
             "brass")),
    Category("bearing", bearing, (0.041, 0.041, 0.0113), 0.05, ("ball bearing", "wheel bearing",
             "ball race", "roller bearing"),
             ("workbench",), ("flat", "round"), ("silver",)),
    Category("spring", spring, (0.0275, 0.0275, 0.0455), 0.015, ("coil spring", "metal spring",
             "compression spring"), ("workbench",), ("round",), ("silver",)),
    Category("washer", washer, (0.0245, 0.0245, 0.0017), 0.004, ("metal washer", "flat washer",
             "steel washer", "metal ring", "bike washer", "cleat", "spacer ring"), ("workbench",),
             ("flat",
             "round"),
             ("silver",)),
)  # fmt: skip
"""The module's categories."""
