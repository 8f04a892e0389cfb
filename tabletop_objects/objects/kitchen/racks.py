"""Objects of the ``kitchen`` theme: racks."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_of
from ...kit.primitives import facing, side_view, vessel
from ...kit.shapes import Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color
from ...values import ConvexPart, Extent, Holder, Slot, read_room


@category("cone_holder", size=(0.192, 0.081, 0.142), mass=0.3, material="wood",
          aliases=("cone stand", "ice cream cone stand", "ice cream cone holder", "cone rack"),
          themes=("kitchen",), roles=("tall",), colors=("wooden",))  # fmt: skip
def cone_holder(look: Look) -> Shape:
    """A stand with three round holes, two of which hold ice cream cones."""
    k = look.between(0.94, 1.06)
    color = look.color("wooden", "clear", "white", "silver")
    top = block(0.19, 0.07, 0.008, 0.01, 0.001).move(z=0.11)
    legs = [block(0.008, 0.07, 0.112, 0.002).move(x=s * 0.09) for s in (-1, 1)]
    foot = block(0.19, 0.08, 0.008, 0.01, 0.001)
    rings = [torus(0.021, 0.003, 24, 6).move(x=x, z=0.119) for x in (-0.055, 0, 0.055)]
    cones = [cylinder(0.003, 0.1, 20, top=0.023).move(x=x, z=0.04) for x in (-0.055, 0.055)]
    hole = cylinder(0.019, 0.001, 20).move(0, 0, 0.1178)
    net = surfaces.grid((176, 116, 56), (222, 166, 96), 8, 10, width=2)
    return shape([(join([top, *legs, foot]), look.surface(color, "wood")),
                  (join(rings), surfaces.plain(tint_color(color, 0.8))), (join(cones), net),
                  (hole, surfaces.plain((50, 44, 40)))],
                 [hull_of(top), hull_of(foot), *(hull_of(s) for s in legs), hull_of(*cones)]
                 ).scale(k)  # fmt: skip


@category("trivet", size=(0.182, 0.182, 0.0135), mass=0.4, material="wood", assembled=True,
          aliases=("pot stand", "hot pad", "hot plate stand", "pan stand"), themes=("kitchen",),
          roles=("support", "flat"), colors=("black", "wooden"), state="lying flat")  # fmt: skip
def trivet(look: Look) -> Shape:
    """A trivet for hot pots: a lattice of bars, or a ring with spokes."""
    x, h = look.between(0.16, 0.2), look.between(0.012, 0.016)
    color = look.color("black", "wooden", "silver", "red", "tan", "teal")
    skin = look.surface(color, look.pick(["wood", "metal"]))
    if look.chance(0.5):
        bars = [box(x, 0.012, 0.5 * h).move(y=(k / 5 - 0.5) * 0.94 * x, z=0.5 * h)
                for k in range(6)]  # fmt: skip
        bars += [box(0.012, x, 0.55 * h).move(x=(k / 3 - 0.5) * 0.94 * x) for k in range(4)]
        return shape([(join(bars), skin)], [box_part(x, x, h)])
    rings = [lathe([(k * x - 0.006, 0.3 * h), (k * x + 0.006, 0.3 * h), (k * x + 0.006, h),
                    (k * x - 0.006, h)], 36, loop=True) for k in (0.18, 0.335, 0.49)]  # fmt: skip
    spokes = [box(0.98 * x, 0.01, 0.6 * h).move(z=0.3 * h).turn(2, k * np.pi / 3) for k in range(3)]
    feet = [cylinder(0.008, 0.6 * h, 12).move(0.44 * x * np.cos(a), 0.44 * x * np.sin(a))
            for a in np.arange(6) * np.pi / 3]  # fmt: skip
    return shape([(join([*rings, *spokes, *feet]), skin)], [cylinder_part(0.49 * x, h)])


@category("cooling_rack", size=(0.372, 0.258, 0.028), mass=0.4, material="metal", assembled=True,
          aliases=("wire rack", "cake rack", "baking rack", "cake cooling rack"),
          themes=("kitchen",), roles=("support", "flat", "big"), colors=("silver",))  # fmt: skip
def cooling_rack(look: Look) -> Shape:
    """A wire rack on four short feet."""
    x, y, h = look.between(0.34, 0.4), look.between(0.23, 0.27), look.between(0.022, 0.03)
    color = look.color("silver", "silver", "black", "copper")
    skin = look.surface(color, "metal")
    rods = [tube([(-x / 2, s * y / 2, h), (x / 2, s * y / 2, h)], 0.003, 6) for s in (-1, 1)]
    rods += [tube([(s * x / 2, -y / 2, h), (s * x / 2, y / 2, h)], 0.003, 6) for s in (-1, 1)]
    rods += [tube([(u * x, -y / 2, h), (u * x, y / 2, h)], 0.0018, 6)
             for u in np.linspace(-0.5, 0.5, 18)[1:-1]]  # fmt: skip
    rods += [tube([(-x / 2, u * y, h - 0.003), (x / 2, u * y, h - 0.003)], 0.0024, 6)
             for u in (-0.25, 0.25)]  # fmt: skip
    feet = [tube([(a * 0.46 * x, b * 0.46 * y, h), (a * 0.47 * x, b * 0.47 * y, 0)], 0.003, 6)
            for a in (-1, 1) for b in (-1, 1)]  # fmt: skip
    return shape([(join([*rods, *feet]), skin)],
                 [box_part(x, y, 0.005, (0, 0, h - 0.003)),
                  *(box_part(0.01, 0.01, h, (a * 0.465 * x, b * 0.465 * y, 0))
                    for a in (-1, 1) for b in (-1, 1))])  # fmt: skip


@category("spice_rack", size=(0.28, 0.102, 0.21), mass=1.6, material="wood", assembled=True,
          aliases=("spice shelf", "rack of spices", "spice holder"), themes=("kitchen",),
          roles=("tall", "big"), colors=("wooden",))  # fmt: skip
def spice_rack(look: Look) -> Shape:
    """A small, wooden, two-step rack with spice jars."""
    x, y, h = look.between(0.26, 0.31), look.between(0.095, 0.11), look.between(0.2, 0.23)
    color = look.color("wooden", "brown", "tan", "black", "white")
    wood = look.surface(color, "wood")
    ends = [box(0.01, y, h).move(x=s * (x / 2 - 0.005)) for s in (-1, 1)]
    shelves = [box(x - 0.02, y, 0.008).move(z=z) for z in (0.004, 0.52 * h)]
    bars = [box(x - 0.02, 0.005, 0.018).move(y=-y / 2 + 0.0025, z=z + 0.016)
            for z in (0.004, 0.52 * h)]  # fmt: skip
    back = box(x - 0.02, 0.005, h).move(y=y / 2 - 0.0025)
    pieces = [(join([*ends, *shelves, *bars, back]), wood)]
    tones = [(184, 60, 30), (206, 150, 40), (110, 76, 44), (84, 120, 56), (150, 40, 36)]
    caps = []
    for i, z in enumerate((0.012, 0.52 * h + 0.008)):
        for k in range(5):
            u = (k - 2) * 0.185 * x
            jar = cylinder(0.02, 0.3 * h, 18).move(u, 0, z)
            pieces.append((jar, surfaces.plain(tones[(k + 2 * i) % 5])))
            caps.append(cylinder(0.019, 0.07 * h, 18).move(u, 0, z + 0.3 * h))
    pieces.append((join(caps), surfaces.plain(look.own_color("black", "silver", "white"))))
    return shape(pieces, [box_part(x, y, h)])


def _rod(a: tuple[float, float, float], b: tuple[float, float, float], r: float) -> Solid:
    return tube([a, b], r, 6)


@category("dish_rack", size=(0.39, 0.3, 0.25), mass=2.2, material="metal", assembled=True,
          aliases=("drying rack", "dish drainer", "draining rack", "plate rack",
          "dish drying rack"), themes=("kitchen",), roles=("big",), colors=("silver", "black"),
          opened="empty_dish_rack")  # fmt: skip
def dish_rack(look: Look) -> Shape:
    """A wire dish rack on a drip tray, with a few plates standing in it."""
    x, y, h = look.between(0.34, 0.4), look.between(0.26, 0.3), look.between(0.1, 0.13)
    color = look.color("silver", "black", "white", "silver", "copper", "sage")
    wire, tray_tile = look.surface(color, "metal"), look.surface(
        look.own_color("white", "black", "gray", "sky"), "plastic")  # fmt: skip
    tray = block(x + 0.02, y + 0.02, 0.012, 0.02, 0.003)
    r, rods = 0.0035, []
    for z in (0.03, h):
        for s in (-1, 1):
            rods += [_rod((-x / 2, s * y / 2, z), (x / 2, s * y / 2, z), r),
                     _rod((s * x / 2, -y / 2, z), (s * x / 2, y / 2, z), r)]  # fmt: skip
    for sx in (-1, 1):
        for sy in (-1, 1):
            rods.append(_rod((sx * x / 2, sy * y / 2, 0.008), (sx * x / 2, sy * y / 2, h), r))
    count = 9
    for k in range(count):
        u = (k / (count - 1) - 0.5) * 0.92 * x
        rods.append(_rod((u, -y / 2, 0.03), (u, y / 2, 0.03), 0.0022))
        rods += [_rod((u, v * y, 0.03), (u, v * y, 0.03 + 0.6 * h), 0.0022) for v in (-0.12, 0.28)]
    pieces = [(tray, tray_tile), (join(rods), wire)]
    glaze = look.surface(
        look.own_color("white", "white", "cream", "sky", "teal", "pink"), "ceramic"
    )
    dishes = []
    disc = lathe([(0, 0), (0.07, 0), (0.11, 0.014), (0.108, 0.018), (0.068, 0.005), (0, 0.005)], 28)
    step = 0.92 * x / (count - 1)
    for k in range(int(look.rng.integers(2, 5))):
        plate = disc.turn(1, -np.pi / 2 + 0.12).move(x=-0.42 * x + (2 * k + 0.4) * step,
                                                         y=0.08 * y, z=0.033 + 0.108)  # fmt: skip
        dishes.append(plate)
    pieces.append((join(dishes), glaze))
    walls = frame_parts(x, y, h - 0.008, 0.008, 0.03)
    up = [type(p)(p.vertices + np.array([0, 0, 0.008]), p.kind, p.axis) for p in walls]
    return shape(pieces, [box_part(x + 0.02, y + 0.02, 0.012), *up, *(hull_of(d) for d in dishes)])


@category("wine_rack", size=(0.288, 0.292, 0.204), mass=2.8, material="wood", assembled=True,
          aliases=("wine holder", "wine stand", "bottle rack", "wine bottle rack",
          "wine bottle holder"), themes=("kitchen", "dining"), roles=("big", "support"),
          colors=("wooden", "black"), opened="empty_wine_rack")  # fmt: skip
def wine_rack(look: Look) -> Shape:
    """A two-row wooden wine rack, sometimes with metal rails, that holds some bottles."""
    pitch, y = look.between(0.1, 0.108), look.between(0.19, 0.22)
    columns = look.pick([2, 3, 3])
    x = columns * pitch
    color = look.color("wooden", "brown", "black", "tan", "charcoal", "white")
    wood = look.surface(color, "wood")
    r, levels = 0.008, (0.022, 0.022 + pitch)
    h = levels[1] + 0.065
    posts, rails = [], []
    for sy in (-1, 1):
        posts += [box(0.018, 0.018, h).move((k - columns / 2) * pitch, sy * (y / 2 - 0.009))
                  for k in range(columns + 1)]  # fmt: skip
        for z in levels:
            path = []
            for k in range(columns):
                middle = (k + 0.5 - columns / 2) * pitch
                path += [(middle + 0.41 * pitch * np.cos(a), sy * (y / 2 - 0.009), z + 0.046 + 0.041
                          * np.sin(a)) for a in np.linspace(np.pi, 2 * np.pi, 9)]  # fmt: skip
            rails.append(tube(path, 0.5 * r, 6))
    for s in (-1, 1):
        rails += [_rod((s * x / 2, -y / 2 + 0.01, z), (s * x / 2, y / 2 - 0.01, z), r)
                  for z in (0.03, h - 0.02)]  # fmt: skip
    pieces = [(join(posts), wood), (join(rails), wood if look.chance(0.5) else
                                      surfaces.brushed_metal(look.rng, (80, 82, 88)))]  # fmt: skip
    bottle = vessel(0.0365, 0.29, 0.014, 0.18, 0.21, sides=18)
    foil = cylinder(0.0152, 0.05, 14, bevel=0.001).move(z=0.242)
    bottles = []
    for k in range(columns):
        for z in levels:
            if (k == 0 and z == levels[0]) or look.chance(0.6):
                at = ((k + 0.5 - columns / 2) * pitch, 0.5 * y + 0.015, z + 0.043)
                hue = look.own_color("green", "maroon", "olive", "black")
                skin = surfaces.plain(tint_color(hue, 0.6))
                cap = surfaces.plain(look.own_color("crimson", "gold", "black", "silver"))
                pieces += [(facing(bottle).move(*at), skin), (facing(foil).move(*at), cap)]
                bottles.append(facing(bottle).move(*at))
    frame = [box_part(0.018, y, h, ((k - columns / 2) * pitch, 0, 0)) for k in range(columns + 1)]
    shelves = [box_part(x, y - 0.01, 0.006, (0, 0, z)) for z in levels]
    return shape(pieces, [*frame, *shelves, *(hull_of(b) for b in bottles)])


PLAY = 0.003  # clearance in a slot beside the object, metres
_Placed = tuple[float, float, float, float, float, float]  # dimensions of a box, and its position


def read_request(look: Look, places: int, room: Extent) -> tuple[int, Extent]:
    """Return the requested number of slots and object size, by default ``places`` and ``room``."""
    count = int(look.attributes.get("places", places))
    return count, read_room(look.attributes.get("room"), room)


def centres(count: int, pitch: float) -> list[float]:
    """Return ``count`` positions with the spacing ``pitch``, centred at 0."""
    return [(k - (count - 1) / 2) * pitch for k in range(count)]


def choose_slots(centres: list[float], count: int, z: float) -> list[Slot]:
    """Return ``count`` slots at height ``z``, with x positions chosen evenly from ``centres``."""
    which = np.linspace(0, len(centres) - 1, count).round().astype(int)
    return [Slot(np.array([centres[k], 0.0, z])) for k in which]


def _boards(boards: list[_Placed]) -> tuple[list[Solid], list[ConvexPart]]:
    """Return the solids and the collision boxes of boards with the given sizes and positions."""
    solids = [box(x, y, z).move(*at) for x, y, z, *at in boards]
    return solids, [box_part(x, y, z, at) for x, y, z, *at in boards]


def _wire(a: Extent, b: Extent, r: float = 0.0025) -> Solid:
    return tube([a, b], r, 6)


@category("empty_dish_rack", size=(0.28, 0.29, 0.168), mass=1.2, material="metal",
          aliases=("empty plate rack",), themes=("kitchen",), roles=("big",),
          colors=("silver", "black"), holder=Holder("edge", (0.1, 0.36, 0.3)))  # fmt: skip
def empty_dish_rack(look: Look) -> Shape:
    """An empty wire dish rack on a drip tray, with two rails that hold dishes between pegs."""
    count, (a, b, c) = read_request(look, 4, (0.024, 0.25, 0.25))
    color = look.color("silver", "black", "white", "silver", "copper", "sage")
    wire = look.surface(color, "metal")
    tray_tile = look.surface(look.own_color("white", "black", "gray", "sky"), "plastic")
    r = 0.003
    pitch = max(a + PLAY, 0.02) + 2 * r
    cells = max(count, round(0.24 / pitch))
    x, y = cells * pitch + 0.02, max(b + 0.02, 0.2)
    rail, peg = 0.018 + 0.1 * b, 0.5 * c
    high = rail + 0.55 * peg
    tray = block(x + 0.02, y + 0.02, 0.012, 0.02, 0.003)
    rods = [_wire((s * x / 2, t * y / 2, 0.008), (s * x / 2, t * y / 2, high))
            for s in (-1, 1) for t in (-1, 1)]  # fmt: skip
    for z in (rail, high):
        for s in (-1, 1):
            rods += [_wire((-x / 2, s * y / 2, z), (x / 2, s * y / 2, z)),
                     _wire((s * x / 2, -y / 2, z), (s * x / 2, y / 2, z))]  # fmt: skip
    for v in (-0.3 * b, 0.3 * b):
        rods.append(_wire((-x / 2, v, rail), (x / 2, v, rail), r))
        rods += [_wire((u, v, rail), (u, v, rail + peg), r) for u in centres(cells + 1, pitch)]
    parts = [hull_of(tray), *map(hull_of, rods)]
    slots = choose_slots(centres(cells, pitch), count, rail + r)
    return shape([(tray, tray_tile), (join(rods), wire)], parts, slots=slots)


@category("empty_wine_rack", size=(0.305, 0.16, 0.214), mass=1.4, material="wood",
          aliases=("empty wine holder",), themes=("kitchen", "dining"), roles=("big",),
          colors=("wooden", "black"), holder=Holder("side", (0.11, 0.38, 0.11)))  # fmt: skip
def empty_wine_rack(look: Look) -> Shape:
    """An empty wooden rack that holds wine bottles on their sides."""
    count, (a, b, c) = read_request(look, 4, (0.075, 0.31, 0.075))
    wood = look.surface(look.color("wooden", "brown", "black", "tan", "charcoal"), "wood")
    columns = max(2, min(3, count))
    rows = max(-(-count // columns), 1 if columns == 3 else 2)
    post, bar, pitch, level = 0.014, 0.012, a + 0.022, c + 0.026
    x, h = columns * pitch + post, rows * level + bar
    front, back = -0.06 * b, 0.36 * b
    boards = [(post, 0.03, h, u, v, 0.0) for u in centres(columns + 1, pitch)
              for v in (front, back)]  # fmt: skip
    boards += [(x, 0.02, bar, 0.0, v, k * level + 0.012) for k in range(rows)
               for v in (front, back)]  # fmt: skip
    boards += [(post, back - front, bar, s * (x - post) / 2, (front + back) / 2, z)
               for s in (-1, 1) for z in (0.012, h - bar)]  # fmt: skip
    solids, parts = _boards(boards)
    at = centres(columns, pitch)
    slots = [Slot(np.array([at[k % columns], 0.0, k // columns * level + 0.012 + bar]))
             for k in range(count)]  # fmt: skip
    return shape([(join(solids), wood)], parts, slots=slots)


@category("taco_holder", size=(0.192, 0.0958, 0.0493), mass=0.15, material="metal",
          aliases=("taco stand", "taco rack"), themes=("kitchen",), colors=("silver",))  # fmt: skip
def taco_holder(look: Look) -> Shape:
    """A taco holder: a wavy steel or coloured sheet with slots for three tacos."""
    k, color = (look.between(0.88, 1.08), look.color("silver", "silver", "red", "yellow", "green",
                                                     "wooden"))  # fmt: skip
    x = np.linspace(-0.1, 0.1, 29)
    z = 0.026 + 0.024 * np.cos(2 * np.pi * x / 0.0571)
    top, low = np.column_stack([x, z + 0.0025]), np.column_stack([x, np.maximum(z - 0.001, 0)])
    sheet = side_view(np.concatenate([low, top[::-1]]), 0.1)
    parts = [hull_of(side_view(np.concatenate([low[i : i + 3], top[i : i + 3][::-1]]),
                               0.1).scale(k, k, k)) for i in range(0, 27, 2)]  # fmt: skip
    return shape([(sheet.scale(k, k, k), look.surface(color, "steel" if color[2] > 150
                                                      else "plastic"))], parts)  # fmt: skip
