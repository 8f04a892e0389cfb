"""Racks and holders of a kitchen: dishes drying, wine lying, napkins and straws standing."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of
from ...build.forms import facing
from ...build.outlines import arc
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .bottles import vessel


def _rod(a: tuple[float, float, float], b: tuple[float, float, float], r: float) -> Solid:
    return tube([a, b], r, 6)


def dish_rack(look: Look) -> Shape:
    """A wire rack for dishes on its drip tray, with a few plates standing in it."""
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


def wine_rack(look: Look) -> Shape:
    """A rack for wine bottles lying down: of wood or wire, two rows, some bottles in it."""
    pitch, y = look.between(0.1, 0.108), look.between(0.19, 0.22)
    columns = look.pick([2, 3, 3])
    x = columns * pitch
    color = look.color("wooden", "brown", "black", "tan", "charcoal", "white")
    wood = look.surface(color, "wood")
    r, levels = 0.008, (0.022, 0.022 + pitch)
    h = levels[1] + 0.065
    posts, rails = [], []
    for sy in (-1, 1):
        posts += [
            box(0.018, 0.018, h).move((k - columns / 2) * pitch, sy * (y / 2 - 0.009))
            for k in range(columns + 1)
        ]
        for z in levels:
            path = []
            for k in range(columns):
                middle = (k + 0.5 - columns / 2) * pitch
                path += [
                    (
                        middle + 0.41 * pitch * np.cos(a),
                        sy * (y / 2 - 0.009),
                        z + 0.046 + 0.041 * np.sin(a),
                    )
                    for a in np.linspace(np.pi, 2 * np.pi, 9)
                ]
            rails.append(tube(path, 0.5 * r, 6))
    for s in (-1, 1):
        rails += [_rod((s * x / 2, -y / 2 + 0.01, z), (s * x / 2, y / 2 - 0.01, z), r)
                  for z in (0.03, h - 0.02)]  # fmt: skip
    pieces = [(join(posts), wood), (join(rails), wood if look.chance(0.5) else
                                      textures.brushed_metal(look.rng, (80, 82, 88)))]  # fmt: skip
    bottle = vessel(0.0365, 0.29, 0.014, 0.18, 0.21, sides=18)
    foil = cylinder(0.0152, 0.05, 14, bevel=0.001).move(z=0.242)
    bottles = []
    for k in range(columns):
        for z in levels:
            if (k == 0 and z == levels[0]) or look.chance(0.6):
                at = ((k + 0.5 - columns / 2) * pitch, 0.5 * y + 0.015, z + 0.043)
                hue = look.own_color("green", "maroon", "olive", "black")
                skin = textures.plain(tint_color(hue, 0.6))
                cap = textures.plain(look.own_color("crimson", "gold", "black", "silver"))
                pieces += [(facing(bottle).move(*at), skin), (facing(foil).move(*at), cap)]
                bottles.append(facing(bottle).move(*at))
    frame = [box_part(0.018, y, h, ((k - columns / 2) * pitch, 0, 0)) for k in range(columns + 1)]
    shelves = [box_part(x, y - 0.01, 0.006, (0, 0, z)) for z in levels]
    return shape(pieces, [*frame, *shelves, *(hull_of(b) for b in bottles)])


def napkin_holder(look: Look) -> Shape:
    """A napkin holder: two plates on a base with folded napkins between them."""
    x, y, h = look.between(0.14, 0.17), look.between(0.05, 0.07), look.between(0.09, 0.12)
    color = look.color("wooden", "silver", "black", "white", "copper", "teal", "red")
    skin = look.surface(color, look.pick(["wood", "metal"]))
    base = block(x, y, 0.01, 0.006, 0.002)
    kind = look.pick(["arch", "box", "fan"])
    outline = {
        "arch": np.concatenate(
            [
                [(-x / 2, 0), (x / 2, 0)],
                arc((0, 0.35 * h), x / 2, 0, np.pi, 14) * [1, 0.65 * h / (x / 2)]
                + [0, 0.35 * h * (1 - 0.65 * h / (x / 2))],
            ]
        ),
        "box": np.array([(-x / 2, 0), (x / 2, 0), (x / 2, 0.86 * h), (-x / 2, 0.86 * h)]),
        "fan": np.array([(-0.36 * x, 0), (0.36 * x, 0), (0.5 * x, 0.9 * h), (-0.5 * x, 0.9 * h)]),
    }[kind]
    plate = facing(prism(outline, 0, 0.006))
    sides = [plate.move(y=v, z=0.008) for v in (-y / 2 + 0.006, y / 2)]
    cloth = look.own_color("white", "white", "red", "cream", "sky", "yellow")
    sheets = textures.stripes([cloth, tint_color(cloth, 0.9)], 9, side=54).transpose(1, 0, 2)
    stack = box(0.86 * x, y - 0.02, 0.9 * h + 0.01).move(z=0.01)
    return shape([(join([base, *sides]), skin), (stack, sheets)],
                 [hull_of(base), *(hull_of(s) for s in sides), hull_of(stack)])  # fmt: skip


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
    pieces = [(body, look.surface(color)), (rim, textures.plain(tint_color(color, 0.9)))]
    for name, straws in groups.items():
        tone = look.own_color(name)
        pieces.append((join(straws), textures.stripes([tone, (246, 244, 238)], 8)))
    bunch = join([s for straws in groups.values() for s in straws])
    return shape(pieces, [cylinder_part(0.95 * r, h), hull_of(bunch)])


def dish_soap(look: Look) -> Shape:
    """A flat bottle of washing-up liquid with a push-pull cap."""
    x, h = look.between(0.075, 0.09), look.between(0.2, 0.235)
    color = look.color("green", "yellow", "sky", "orange", "blue", "lime", "pink")
    body = vessel(x / 2, h, 0.014, 0.66 * h, 0.93 * h, waist=look.chance(0.6)).scale(1, 0.56, 1)
    label = prints.label(look.rng, look.pick(["DISH", "CLEAN", "FRESH", "LEMON"]),
                         look.own_color("navy", "green", "red", "teal"),
                         (244, 244, 240))  # fmt: skip
    skin = textures.speckles(look.rng, color, 3, 32)
    tile = textures.stack((skin, 0.14), (label, 0.4), (skin, 0.46), side=192)
    cap = [cylinder(0.017, 0.016, 20, bevel=0.001).move(z=h - 0.004),
           cylinder(0.01, 0.016, 16, top=0.007).move(z=h + 0.011)]  # fmt: skip
    tone = look.own_color("white", "red", "blue", "green", "yellow")
    return shape([(body, tile), (join(cap), textures.plain(tone))],
                 [box_part(0.86 * x, 0.5 * x, 0.66 * h), hull_of(*cap), hull_of(body)])  # fmt: skip


CATEGORIES = (
    Category("dish_rack", dish_rack, (0.39, 0.3, 0.25), 2.2, ("drying rack", "dish drainer",
             "draining rack", "plate rack", "dish drying rack"), ("kitchen",), ("big",), ("silver",
             "black")),
    Category("wine_rack", wine_rack, (0.288, 0.292, 0.204), 2.8, ("wine holder", "wine stand",
             "bottle rack", "wine bottle rack", "wine bottle holder"), ("kitchen", "dining"),
             ("big", "support"), ("wooden", "black")),
    Category("napkin_holder", napkin_holder, (0.155, 0.06, 0.11), 0.4, ("napkin dispenser",
             "serviette holder", "tissue holder"), ("dining", "kitchen"), ("tall",), ("wooden",
             "silver")),
    Category("straw_holder", straw_holder, (0.0791, 0.0795, 0.219), 0.2, ("drinking straws",
             "straw dispenser", "cup of straws", "straw cup", "glass of straws"),
             ("dining", "kitchen"), ("tall", "round"), ("clear", "silver")),
    Category("dish_soap", dish_soap, (0.082, 0.046, 0.24), 0.55, ("washing up liquid",
             "dishwashing liquid", "dish soap bottle", "dish detergent", "detergent",
             "detergent bottle", "dishwasher soap", "washing-up liquid bottle",
             "washing-up liquid", "washing up liquid bottle"), ("kitchen",), ("tall",), ("green",
             "yellow")),
)  # fmt: skip
"""The module's categories."""
