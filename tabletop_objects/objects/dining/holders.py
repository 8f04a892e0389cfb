"""Objects of the ``dining`` theme: holders."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import arc
from ...kit.parts import cylinder_part, hull_of, ring_parts
from ...kit.primitives import facing, side_view
from ...kit.shapes import Shape, category, settle, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, tint_color


@category("napkin_ring", size=(0.102, 0.044, 0.0331), mass=0.04, material="metal", assembled=True,
          aliases=("serviette ring", "napkin band"), themes=("dining",),
          colors=("silver", "gold"))  # fmt: skip
def napkin_ring(look: Look) -> Shape:
    """A broad napkin ring standing on its edge, or with a rolled napkin through it."""
    r, w = look.between(0.02, 0.024), look.between(0.026, 0.034)
    color = look.color("silver", "gold", "wooden", "copper", "white")
    skin = look.surface(color, look.pick(["metal", "wood"]))
    ring = lathe([(0.86 * r, 0), (0.97 * r, 0), (r, 0.1 * w), (r, 0.9 * w), (0.97 * r, w),
                  (0.86 * r, w)], 32, loop=True)  # fmt: skip
    if look.chance(0.6):
        return shape([(ring, skin)], ring_parts([(0.97 * r, 0), (r, 0.1 * w), (r, 0.9 * w),
                     (0.97 * r, w)], [(0.86 * r, w), (0.86 * r, 0)], 10))  # fmt: skip
    cloth = surfaces.fabric(look.rng, look.own_color("white", "cream", "red", "navy", "sage"))
    roll = [cylinder(0.8 * r, 0.16, 20).move(z=-0.081 + 0.5 * w)]
    fan = [box(0.0016, 1.9 * r * k, 0.05).turn(2, a).move(z=0.068 + 0.5 * w)
           for k, a in ((1.0, 0.3), (1.1, 1.2), (1.0, 2.2))]  # fmt: skip
    laid = [(s.turn(1, np.pi / 2).move(-0.5 * w, 0, r), t)
            for s, t in ((ring, skin), (join([*roll, *fan]), cloth))]  # fmt: skip
    return settle(laid, 0.07, hulls=[[0], [1]])


@category("chopstick_rest", size=(0.0533, 0.0172, 0.0138), mass=0.02, material="ceramic",
          aliases=("chopsticks rest", "chopstick holder", "hashioki", "knife rest"),
          themes=("dining",), colors=("white",))  # fmt: skip
def chopstick_rest(look: Look) -> Shape:
    """A small curved porcelain rest for chopsticks."""
    x, y, h = look.between(0.045, 0.058), look.between(0.015, 0.019), look.between(0.012, 0.016)
    color = look.color("white", "navy", "sage", "black", "sky", "red", "terracotta")
    u = np.linspace(-1, 1, 17)
    top = 0.5 * h + 0.5 * h * u**2
    line = np.concatenate([np.column_stack([u, 0 * u]), np.column_stack([u, top])[::-1]])
    body = side_view(line * [x / 2, 1], y)
    halves = [hull_of(side_view(np.array([(0, 0), (s, 0), (s, h), (0, 0.5 * h)])[:: int(s)] * [
        x / 2, 1], y)) for s in (1.0, -1.0)]  # fmt: skip
    return shape([(body, glaze_tile(look, color))], halves)


@category("napkin_holder", size=(0.155, 0.06, 0.11), mass=0.4, material="wood", assembled=True,
          aliases=("napkin dispenser", "serviette holder", "tissue holder"),
          themes=("dining", "kitchen"), roles=("tall",), colors=("wooden", "silver"))  # fmt: skip
def napkin_holder(look: Look) -> Shape:
    """A napkin holder: two plates on a base with folded napkins between them."""
    x, y, h = look.between(0.14, 0.17), look.between(0.05, 0.07), look.between(0.09, 0.12)
    color = look.color("wooden", "silver", "black", "white", "copper", "teal", "red")
    skin = look.surface(color, look.pick(["wood", "metal"]))
    base = block(x, y, 0.01, 0.006, 0.002)
    kind = look.pick(["arch", "box", "fan"])
    outline = {"arch": np.concatenate([[(-x / 2, 0), (x / 2, 0)], arc((0, 0.35 * h), x / 2, 0,
                                                                      np.pi, 14)
                                       * [1, 0.65 * h / (x / 2)]
                                       + [0, 0.35 * h * (1 - 0.65 * h / (x / 2))]]),
               "box": np.array([(-x / 2, 0), (x / 2, 0), (x / 2, 0.86 * h), (-x / 2, 0.86 * h)]),
               "fan": np.array([(-0.36 * x, 0), (0.36 * x, 0), (0.5 * x, 0.9 * h),
                                (-0.5 * x, 0.9 * h)])}[kind]  # fmt: skip
    plate = facing(prism(outline, 0, 0.006))
    sides = [plate.move(y=v, z=0.008) for v in (-y / 2 + 0.006, y / 2)]
    cloth = look.own_color("white", "white", "red", "cream", "sky", "yellow")
    sheets = surfaces.stripes([cloth, tint_color(cloth, 0.9)], 9, side=54).transpose(1, 0, 2)
    stack = box(0.86 * x, y - 0.02, 0.9 * h + 0.01).move(z=0.01)
    return shape([(join([base, *sides]), skin), (stack, sheets)],
                 [hull_of(base), *(hull_of(s) for s in sides), hull_of(stack)])  # fmt: skip


@category("straw_holder", size=(0.0791, 0.0795, 0.219), mass=0.2, material="glass", assembled=True,
          aliases=("drinking straws", "straw dispenser", "cup of straws", "straw cup",
          "glass of straws"), themes=("dining", "kitchen"), roles=("tall", "round"),
          colors=("clear", "silver"))  # fmt: skip
def straw_holder(look: Look) -> Shape:
    """A glass or tin full of drinking straws."""
    r, h = look.between(0.034, 0.042), look.between(0.11, 0.13)
    color = look.color("clear", "silver", "red", "mint", "white", "sky")
    body = lathe(
        [(0, 0), (0.9 * r, 0), (r, h), (r - 0.003, h), (0.85 * r, 0.5 * h), (0, 0.5 * h)], 28
    )
    rim = torus(r, 0.002, 30, 6).move(z=h)
    tones = look.pick([("red", "blue", "yellow", "green", "pink"), ("red", "red"), ("black",),
                       ("tan", "beige"), ("teal", "pink", "violet")])  # fmt: skip
    groups: dict[str, list[Solid]] = {}
    for k in range(16):
        away, turn = r * np.sqrt((k + 0.5) / 16), 2.4 * k
        low = np.array([0.5 * away * np.cos(turn), 0.5 * away * np.sin(turn), 0.5 * h])
        high = np.array([0.95 * away * np.cos(turn), 0.95 * away * np.sin(turn),
                         h + look.between(0.07, 0.1)])  # fmt: skip
        groups.setdefault(tones[k % len(tones)], []).append(tube([low, high], 0.003, 7))
    pieces = [(body, look.surface(color)), (rim, surfaces.plain(tint_color(color, 0.9)))]
    for name, straws in groups.items():
        tone = look.own_color(name)
        pieces.append((join(straws), surfaces.stripes([tone, (246, 244, 238)], 8)))
    bunch = join([s for straws in groups.values() for s in straws])
    return shape(pieces, [cylinder_part(0.95 * r, h), hull_of(bunch)])
