"""What keeps a desk in order: caddies, cabinets, drawers, book ends, folders, calendars, bins."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.forms import facing
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, ellipsoid, join, lathe, open_box, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

WOODS = ("wooden", "brown", "tan", "white", "black", "maroon", "teal")


def desk_caddy(look: Look) -> Shape:
    """A caddy with compartments of two heights; books or pens go into it."""
    x, y = look.between(0.2, 0.25), look.between(0.12, 0.15)
    low, high, t = look.between(0.055, 0.07), look.between(0.1, 0.125), 0.005
    color = look.color("wooden", "tan", "white", "black", "gray", "sky", "mint", "pink")
    skin = look.surface(color, look.pick(["wood", "plastic"]))
    back, front = 0.5 * y, -0.5 * y
    walls = [box(x, y, t),
             box(x, t, high - t).move(y=back - t / 2, z=t),
             box(x, t, high - t).move(y=0.04 * y, z=t),
             box(x, t, low - t).move(y=front + t / 2, z=t)]  # fmt: skip
    walls += [box(t, 0.46 * y, high - t).move(s * (x / 2 - t / 2), 0.27 * y, t) for s in (-1, 1)]
    walls += [box(t, 0.54 * y, low - t).move(s * (x / 2 - t / 2), -0.23 * y, t) for s in (-1, 1)]
    split = [box(t, 0.44 * y, high - t).move(0.12 * x, 0.27 * y, t),
             box(t, 0.5 * y, low - t).move(-0.1 * x, -0.22 * y, t)]  # fmt: skip
    solids = [*walls, *split]
    return shape([(s, skin) for s in solids], [hull_of(s) for s in solids])


def _drawer(
    look: Look, wide: float, tall: float, at: tuple[float, float, float], knob: str
) -> tuple[Solid, Solid]:
    """Return a drawer's front and its pull, ``at`` the middle of its lower edge."""
    front = box(wide, 0.012, tall).move(*at)
    x, y, z = at
    if knob == "bar":
        pull = [box(0.3 * wide, 0.006, 0.008).move(x, y - 0.02, z + tall / 2),
                *[box(0.008, 0.016, 0.008).move(x + s * 0.12 * wide, y - 0.012, z + tall / 2)
                  for s in (-1, 1)]]  # fmt: skip
        return front, join(pull)
    ball = ellipsoid(0.018, 0.016, 0.018, 14, 8).move(x, y - 0.013, z + tall / 2)
    return front, ball


def cabinet(look: Look) -> Shape:
    """A small cabinet that stands on a desk: drawers, or drawers under a pair of doors."""
    x, y, h = look.between(0.22, 0.29), look.between(0.18, 0.22), look.between(0.24, 0.32)
    color = look.color(*WOODS)
    skin = look.surface(color, "wood")
    face = look.surface(tint_color(color, look.pick([1.0, 1.12, 0.86])), "wood")
    metal = textures.brushed_metal(look.rng, look.own_color("brass", "silver", "charcoal"))
    knob, count, doors = look.pick(["ball", "bar"]), look.pick([2, 3, 3]), look.chance(0.35)
    feet = join([box(0.024, 0.024, 0.014).move(sx * 0.42 * x, sy * 0.4 * y)
                   for sx in (-1, 1) for sy in (-1, 1)])  # fmt: skip
    body = box(x, y, h).move(z=0.012)
    top = block(x + 0.02, y + 0.02, 0.012, 0.005, 0.002).move(z=h + 0.011)
    fronts, pulls = [], []
    floor = 0.03
    room = (0.45 if doors else 0.93) * h
    for k in range(count):
        tall = room / count
        front, pull = _drawer(
            look, 0.88 * x, tall - 0.012, (0, -y / 2 - 0.004, floor + k * tall), knob
        )
        fronts.append(front)
        pulls.append(pull)
    if doors:
        for s in (-1, 1):
            z = floor + room
            fronts.append(box(0.435 * x, 0.012, 0.44 * h).move(s * 0.222 * x, -y / 2 - 0.004, z))
            pulls.append(ellipsoid(0.015, 0.015, 0.015, 12, 8).move(s * 0.04 * x, -y / 2 - 0.016,
                                                                     z + 0.2 * h))  # fmt: skip
    return shape(
        [(join([body, top]), skin), (feet, textures.plain(tint_color(color, 0.5))),
         *((front, face) for front in fronts), (join(pulls), metal)],
        [box_part(0.86 * x, 0.82 * y, 0.014), hull_of(body), hull_of(top), hull_of(*fronts),
         *(hull_of(p) for p in pulls)],
    )  # fmt: skip


def drawer_box(look: Look) -> Shape:
    """A small box of drawers: one or two wide ones or a grid of little ones, one pulled out."""
    columns, rows = look.pick([(1, 1), (1, 2), (2, 2), (3, 2)])
    x, y, h = look.between(0.2, 0.25), look.between(0.13, 0.17), 0.065 * rows + 0.012
    color = look.color("wooden", "white", "black", "tan", "sky", "pink", "gray", "mint")
    skin = look.surface(color, look.pick(["wood", "plastic"]))
    face = look.surface(tint_color(color, look.pick([1.15, 0.85])), look.pick(["wood", "plastic"]))
    metal = textures.brushed_metal(look.rng, look.own_color("brass", "silver", "charcoal"))
    body = box(x, y, h)
    open_ = int(look.rng.integers(columns * rows)) if look.chance(0.7) else -1
    pieces, parts = [(body, skin)], [box_part(x, y, h)]
    wide, tall = (x - 0.012) / columns, (h - 0.01) / rows
    for k in range(columns * rows):
        u = (k % columns - (columns - 1) / 2) * wide
        z = 0.005 + (k // columns) * tall
        out = 0.36 * y if k == open_ else 0.0
        front, pull = _drawer(
            look, wide - 0.006, tall - 0.007, (u, -y / 2 - 0.002 - out, z + 0.003), "ball"
        )
        pieces += [(front, face), (pull, metal)]
        parts.append(hull_of(front, pull))
        if out:
            tray = open_box(wide - 0.016, out, tall - 0.02, 0.004, 0.004)
            moved = [s.move(u, -y / 2 - out / 2, z + 0.004) for s in tray]
            pieces.append((join(moved), face))
            parts += [hull_of(s) for s in moved[:3]]
    return shape(pieces, parts)


def waste_bin(look: Look) -> Shape:
    """A small desk bin, open or with a swing lid."""
    r, h = look.between(0.065, 0.08), look.between(0.15, 0.19)
    color = look.color("white", "gray", "black", "silver", "mint", "pink", "sky", "red")
    mesh = look.chance(0.35)
    skin = look.surface(color, "metal" if look.chance(0.4) else "plastic")
    if mesh:
        skin = prints.mesh_holes(color, tint_color(color, 0.35), 24, 40)
    side = [(0.78 * r, 0), (0.9 * r, 0.5 * h), (r, h)]
    body = lathe([(0, 0), *side, (r - 0.003, h), (0.78 * r - 0.003, 0.005), (0, 0.005)], 30)
    rim = torus(r - 0.001, 0.0035, 32, 6).move(z=h)
    plain = textures.plain(tint_color(color, 0.85))
    walls = [*ring_parts([side[0], side[2]], [(r - 0.003, h), (0.78 * r - 0.003, 0.005)]),
             cylinder_part(0.78 * r, 0.005)]  # fmt: skip
    if mesh or look.chance(0.4):
        return shape([(body, skin), (rim, plain)], walls)
    t = np.linspace(0, np.pi / 2, 7)
    lid = lathe([(0, h), *((1.03 * r * np.cos(a) ** 0.6, h + 0.5 * r * np.sin(a)) for a in t[:-1]),
                 (0, h + 0.5 * r)], 30)  # fmt: skip
    flap = facing(block(1.1 * r, 0.4 * r, 0.006, 0.006, 0.001)).turn(0, -0.5)
    flap = flap.move(y=-0.82 * r, z=h + 0.26 * r)
    return shape(
        [(body, skin), (join([lid, rim]), plain), (flap, textures.plain(tint_color(color, 0.6)))],
        [hull_of(body), hull_of(lid)],
    )


def cable_coil(look: Look) -> Shape:
    """A coiled cable tied in the middle, its plug lying beside."""
    color = look.color("black", "white", "gray", "red", "blue", "charcoal")
    r, thick = look.between(0.045, 0.06), look.between(0.0022, 0.0032)
    t = np.linspace(0, 5 * 2 * np.pi, 150)
    wobble = 1 + 0.06 * np.sin(2.3 * t) + 0.05 * np.sin(0.7 * t + 1)
    path = np.column_stack(
        [
            1.25 * r * wobble * np.cos(t),
            0.8 * r * wobble * np.sin(t),
            thick + 1.5 * thick * t / t[-1] + 0.5 * thick * np.sin(3 * t),
        ]
    )
    ends = smooth([path[-1], path[-1] + [0.02, 0.03, 0], (1.5 * r, 0.75 * r, thick + 0.002),
                   (1.75 * r, 0.3 * r, thick + 0.002)], 4)  # fmt: skip
    cable = tube(np.concatenate([path, ends[2:]]), thick, 6)
    plug = block(0.013, 0.03, 0.008, 0.003, 0.001).move(1.75 * r, 0.3 * r - 0.014)
    tip = box(0.008, 0.012, 0.0035).move(1.75 * r, 0.3 * r - 0.034, 0.0022)
    tie = block(0.012, 0.34 * r, 5 * thick, 0.004).move(x=0, y=-0.8 * r)
    tone = textures.plain(look.own_color("black", "white", "green", "orange"))
    low, high = 0.62, 1.1
    ring = ring_parts(
        [(high * r, 0.0), (high * r, 4.4 * thick)],
        [(low * r, 4.4 * thick), (low * r, 0.0)],
        12,
        stretch=(1.25, 0.8),
    )
    return shape([(cable, textures.plain(color)), (plug, textures.plain(tint_color(color, 0.85))),
                  (tip, textures.plain((190, 192, 198))), (tie, tone)],
                 [*ring, hull_of(plug), hull_of(tie)])  # fmt: skip


CATEGORIES = (
    Category("desk_caddy", desk_caddy, (0.225, 0.135, 0.113), 0.5, ("caddy", "desktop organizer",
             "desk organiser", "book caddy", "desk tidy", "stationery organizer", "pen organizer",
             "desktop caddy", "stationery holder", "drawer organiser", "cutlery organiser",
             "drawer organizer tray"),
             ("office",), ("container",), ("wooden",
             "white")),
    Category("cabinet", cabinet, (0.275, 0.235, 0.305), 3.0, ("wooden cabinet", "desk cabinet",
             "small cabinet", "white cabinet", "dollhouse cabinet", "chest of drawers", "cupboard",
             "mini cabinet", "wood cabinet", "tabletop cabinet", "filing cabinet"), ("office",
             "living"), ("big", "support", "tall"), ("wooden", "white")),
    Category("drawer_box", drawer_box, (0.224, 0.217, 0.134), 1.1, ("drawer unit",
             "box with drawers", "box of drawers", "mini drawers", "drawer organizer",
             "desk drawer", "box with a drawer", "jewelry drawer"), ("office", "craft", "vanity"),
             ("support", "big"), ("wooden", "white")),
    Category("waste_bin", waste_bin, (0.15, 0.15, 0.19), 0.35, ("trash can", "trash bin",
             "dustbin", "garbage can", "wastebasket", "rubbish bin", "waste basket",
             "wastepaper basket", "desk bin", "trashcan", "garbage bin", "mini trash can",
             "recycling bin"), ("office", "kitchen"), ("round", "tall", "big"), ("white", "gray")),
    Category("cable", cable_coil, (0.18, 0.101, 0.0137), 0.08, ("usb cable", "charging cable",
             "coiled cable", "cable coil", "charger cable", "coil of cable", "power cable",
             "hdmi cable", "ethernet cable", "inner tube", "bike cable", "cable connector",
             "heat shrink tube", "kettle lead", "guitar lead", "jump lead", "scart lead",
             "micro usb cable", "figure eight lead", "figure-eight lead", "guitar cable",
             "audio cable", "air line", "rubber tubing", "catheter", "speaker wire coil",
             "cable sleeve", "aux cable", "power lead", "mains lead", "phone lead"), ("office",
             "gaming"),
             ("flat",), ("black", "white"),
             state="lying coiled"),
)  # fmt: skip
"""The module's categories."""
