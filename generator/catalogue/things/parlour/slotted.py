"""Racks and blocks that stand empty, with a place for each thing that a text puts there.

The attributes "places" and "room" say for how many things they are built, and for how large ones.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ....scene import ConvexPart, Slot
from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, tube
from ...holder import Extent, Holder, read_room
from ...surfaces.look import Look

_PLAY = 0.003  # metres of room in a place beside the thing
_Placed = tuple[float, float, float, float, float, float]  # sides of a box, and where it stands


def _read_request(look: Look, places: int, room: Extent) -> tuple[int, Extent]:
    """Return how many places are asked for, and for how large things."""
    count = int(look.attributes.get("places", places))
    return count, read_room(look.attributes.get("room"), room)


def _centres(count: int, pitch: float) -> list[float]:
    """Return places in a row about 0."""
    return [(k - (count - 1) / 2) * pitch for k in range(count)]


def _choose_slots(centres: list[float], count: int, z: float) -> list[Slot]:
    """Return ``count`` of the places, spread over the row."""
    which = np.linspace(0, len(centres) - 1, count).round().astype(int)
    return [Slot(np.array([centres[k], 0.0, z])) for k in which]


def _boards(boards: list[_Placed]) -> tuple[list[Solid], list[ConvexPart]]:
    """Return boxes as solids and as collision parts."""
    solids = [box(x, y, z).move(*at) for x, y, z, *at in boards]
    return solids, [box_part(x, y, z, at) for x, y, z, *at in boards]


def _wire(a: Extent, b: Extent, r: float = 0.0025) -> Solid:
    return tube([a, b], r, 6)


def toast_rack(look: Look) -> Shape:
    """A rack of hoops on a base, empty."""
    count, (a, b, c) = _read_request(look, 4, (0.0144, 0.116, 0.116))
    color = look.color("silver", "silver", "black", "copper", "white", "wooden")
    skin = look.surface(color, "metal")
    cells, r, floor = max(count, 4), 0.0024, 0.018
    pitch = a + _PLAY + 2 * r
    x, y, h = cells * pitch + 0.016, 0.84 * b, floor + 0.72 * c
    base = block(x, y, 0.006, 0.012, 0.001).move(z=floor - 0.006)
    feet = [cylinder(0.006, 0.013, 12).move(i * 0.42 * x, j * 0.38 * y) for i in (-1, 1)
            for j in (-1, 1)]  # fmt: skip
    at = _centres(cells + 1, pitch)
    bow = [(-0.42 * y, floor - 0.002), (-0.4 * y, 0.66 * h), (-0.2 * y, 0.91 * h), (0.0, h),
           (0.2 * y, 0.91 * h), (0.4 * y, 0.66 * h), (0.42 * y, floor - 0.002)]  # fmt: skip
    hoops = [_wire((u, *a), (u, *b), r) for u in at for a, b in pairwise(bow)]
    spans = [hull_of(*hoops[k:n]) for m in range(0, len(hoops), 6)
             for k, n in ((m, m + 1), (m + 1, m + 3), (m + 3, m + 5), (m + 5, m + 6))]  # fmt: skip
    parts = [hull_of(base), *map(hull_of, feet), *spans]
    slots = _choose_slots(_centres(cells, pitch), count, floor)
    return shape([(join([base, *feet, *hoops]), skin)], parts, slots=slots)


def dish_rack(look: Look) -> Shape:
    """A wire rack for dishes on its drip tray, empty: two rails carry what stands between pegs."""
    count, (a, b, c) = _read_request(look, 4, (0.024, 0.25, 0.25))
    color = look.color("silver", "black", "white", "silver", "copper", "sage")
    wire = look.surface(color, "metal")
    tray_tile = look.surface(look.own_color("white", "black", "gray", "sky"), "plastic")
    r = 0.003
    pitch = max(a + _PLAY, 0.02) + 2 * r
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
        rods += [_wire((u, v, rail), (u, v, rail + peg), r) for u in _centres(cells + 1, pitch)]
    parts = [hull_of(tray), *map(hull_of, rods)]
    slots = _choose_slots(_centres(cells, pitch), count, rail + r)
    return shape([(tray, tray_tile), (join(rods), wire)], parts, slots=slots)


def letter_rack(look: Look) -> Shape:
    """A rack of upright boards, rising to the back, for letters and magazines."""
    count, (a, b, c) = _read_request(look, 3, (0.012, 0.19, 0.12))
    color = look.color("wooden", "brown", "white", "black", "gold", "wooden", "teal")
    skin = look.surface(color, look.pick(["wood", "metal"]))
    wall, floor = 0.005, 0.01
    pitch = max(a + _PLAY, 0.014) + wall
    cells = max(count, 2)
    y = 0.78 * b
    base = (cells * pitch + wall + 0.01, y + 0.01, floor, 0.0, 0.0, 0.0)
    heights = np.linspace(0.6, 0.82, cells + 1) * c
    rows = [(wall, y, float(h), u, 0.0, floor)
            for u, h in zip(_centres(cells + 1, pitch), heights, strict=True)]  # fmt: skip
    solids, parts = _boards([base, *rows])
    slots = _choose_slots(_centres(cells, pitch), count, floor)
    return shape([(join(solids), skin)], parts, slots=slots)


def wine_rack(look: Look) -> Shape:
    """A wooden rack for bottles of wine lying down, empty."""
    count, (a, b, c) = _read_request(look, 4, (0.075, 0.31, 0.075))
    wood = look.surface(look.color("wooden", "brown", "black", "tan", "charcoal"), "wood")
    columns = max(2, min(3, count))
    rows = max(-(-count // columns), 1 if columns == 3 else 2)
    post, bar, pitch, level = 0.014, 0.012, a + 0.022, c + 0.026
    x, h = columns * pitch + post, rows * level + bar
    front, back = -0.06 * b, 0.36 * b
    boards = [(post, 0.03, h, u, v, 0.0) for u in _centres(columns + 1, pitch)
              for v in (front, back)]  # fmt: skip
    boards += [(x, 0.02, bar, 0.0, v, k * level + 0.012) for k in range(rows)
               for v in (front, back)]  # fmt: skip
    boards += [(post, back - front, bar, s * (x - post) / 2, (front + back) / 2, z)
               for s in (-1, 1) for z in (0.012, h - bar)]  # fmt: skip
    solids, parts = _boards(boards)
    at = _centres(columns, pitch)
    slots = [
        Slot(np.array([at[k % columns], 0.0, k // columns * level + 0.012 + bar]))
        for k in range(count)
    ]
    return shape([(join(solids), wood)], parts, slots=slots)


def knife_block(look: Look) -> Shape:
    """A wooden block with slots for knives, empty."""
    count, (a, b, c) = _read_request(look, 5, (0.014, 0.04, 0.25))
    skin = look.surface(look.color("wooden", "brown", "black", "tan", "white"), "wood")
    wall, floor, h = 0.007, 0.012, 0.62 * c
    cells, pitch = max(count, 3), a + _PLAY + wall
    x, y = cells * pitch + wall, b + _PLAY
    boards = [(x, y + 2 * wall, floor, 0.0, 0.0, 0.0)]
    boards += [(wall, y, h - floor, u, 0.0, floor) for u in _centres(cells + 1, pitch)]
    boards += [(x, wall, h - floor, 0.0, s * (y + wall) / 2, floor) for s in (-1, 1)]
    solids, parts = _boards(boards)
    slots = _choose_slots(_centres(cells, pitch), count, floor)
    return shape([(join(solids), skin)], parts, slots=slots)


def tube_rack(look: Look) -> Shape:
    """An empty rack for test tubes: a board with holes over a base."""
    count, (a, b, c) = _read_request(look, 6, (0.0214, 0.0214, 0.142))
    color = look.color("wooden", "white", "blue", "wooden", "beige")
    wood = look.surface(color, "wood")
    hole, wall, cells = max(a, b) / 2 + 0.001, 0.007, max(count, 4)
    pitch, top = 2 * hole + 0.009, max(0.45 * c, 0.03)
    x, y = pitch * cells + 0.016, 2 * hole + 0.036
    rail = (y - 2 * hole) / 2
    boards = [(x, y, wall, 0.0, 0.0, 0.0)]
    boards += [(0.007, y, top, s * (x - 0.007) / 2, 0.0, 0.0) for s in (-1, 1)]
    boards += [(x, rail, wall, 0.0, s * (hole + rail / 2), top - wall) for s in (-1, 1)]
    bars = _centres(cells + 1, pitch)
    boards += [(pitch - 2 * hole, 2 * hole, wall, u, 0.0, top - wall) for u in bars]
    solids, parts = _boards(boards)
    slots = _choose_slots(_centres(cells, pitch), count, wall)
    return shape([(join(solids), wood)], parts, slots=slots)


CATEGORIES = (
    Category("empty_toast_rack", toast_rack, (0.108, 0.097, 0.101), 0.3, ("empty toast holder",),
             ("breakfast",), (), ("silver",), holder=Holder("edge", (0.04, 0.16, 0.16))),
    Category("empty_dish_rack", dish_rack, (0.28, 0.29, 0.168), 1.2, ("empty plate rack",),
             ("kitchen",), ("big",), ("silver", "black"),
             holder=Holder("edge", (0.1, 0.36, 0.3))),
    Category("letter_rack", letter_rack, (0.072, 0.158, 0.108), 0.4, ("letter holder",
             "mail rack", "mail holder", "letter sorter", "envelope holder", "magazine rack",
             "magazine holder", "file rack", "record rack", "book rack", "letter stand"),
             ("office",), (), ("wooden", "white"), holder=Holder("edge", (0.06, 0.36, 0.32))),
    Category("empty_wine_rack", wine_rack, (0.305, 0.16, 0.214), 1.4, ("empty wine holder",),
             ("kitchen", "dining"), ("big",), ("wooden", "black"),
             holder=Holder("side", (0.11, 0.38, 0.11))),
    Category("empty_knife_block", knife_block, (0.127, 0.057, 0.155), 1.2,
             ("empty knife holder",), ("kitchen",), ("tall",), ("wooden",),
             holder=Holder("end", (0.04, 0.09, 0.38))),
    Category("empty_tube_rack", tube_rack, (0.2124, 0.0594, 0.0639), 0.15, ("vial stand",),
             ("lab",), ("big",), ("wooden",), holder=Holder("end", (0.04, 0.04, 0.22))),
)  # fmt: skip
"""The module's categories."""
