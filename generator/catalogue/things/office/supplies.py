"""Small office and school supplies: rubbers, sharpeners, crayons, clips, punches, stamps."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import side_view
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, open_box, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

RAINBOW = ("red", "orange", "yellow", "green", "teal", "blue", "purple", "pink", "brown", "black")


def eraser(look: Look) -> Shape:
    """A rubber: white in a printed sleeve, pink and slanted, or of two colours."""
    x, y, h = look.between(0.045, 0.06), look.between(0.019, 0.024), look.between(0.011, 0.014)
    kind = look.pick(["sleeve", "sleeve", "pink", "two"])
    if kind == "sleeve":
        color = look.color("blue", "black", "green", "red", "navy", "teal", "orange")
        core = block(x, y, h, 0.002, 0.001)
        image = prints.canvas(96, 40, color)
        prints.fill(image, 0, 0, 0.3, 1, tint_color(color, 0.6))
        prints.fill(image, 0.3, 0, 0.05, 1, (248, 248, 246))
        prints.write(image[:, 36:], look.pick(["ERASER", "SOFT", "PLAST", "RUB"]), 0.5, 0.5, 0.42,
                     (248, 248, 246), bold=True)  # fmt: skip
        sleeve = box(0.66 * x, y + 0.0008, h + 0.0006).move(x=0.14 * x)
        white = textures.speckles(look.rng, look.pick([(246, 246, 244), (232, 238, 246)]), 4, 32)
        return shape([(core.move(z=0.0003), white), (sleeve, image)],
                     [box_part(x, y, h, (0, 0, 0.0003)), box_part(0.66 * x, y, h + 0.0003,
                                                                  (0.14 * x, 0, 0))])  # fmt: skip
    outline = np.array([(-0.5 * x, 0), (0.38 * x, 0), (0.5 * x, h), (-0.38 * x, h)])
    body = side_view(outline, y, 0.001)
    color = look.color("pink", "coral", "pink", "sky", "lime")
    tile = textures.speckles(look.rng, color, 5, 32)
    if kind == "pink":
        sign = prints.canvas(96, 32, color)
        prints.write(
            sign, look.pick(["PINK", "SCHOOL", "RUBBER"]), 0.5, 0.5, 0.5, tint_color(color, 0.4)
        )
        plate = box(0.6 * x, 0.7 * y, 0.0003).move(z=h - 0.0001)
        return shape([(body, tile), (plate, sign)], [hull_of(body)])
    half = textures.speckles(look.rng, look.own_color("blue", "navy", "gray"), 5, 32)
    cut = side_view(
        np.array(
            [
                (0.1 * x, -0.0002),
                (0.39 * x, -0.0002),
                (0.505 * x, h + 0.0004),
                (0.1 * x, h + 0.0004),
            ]
        ),
        y + 0.0006,
        0.001,
    ).move(z=0.0002)
    return shape([(body, tile), (cut, half)], [hull_of(body, cut)])


def pencil_sharpener(look: Look) -> Shape:
    """A pencil sharpener: a small wedge with its blade, a tub, or one with a crank."""
    color = look.color("red", "blue", "silver", "green", "yellow", "pink", "black", "orange")
    steel = textures.brushed_metal(look.rng, (196, 199, 204))
    dark = textures.plain((36, 36, 40))
    kind = look.pick(["wedge", "wedge", "tub", "crank"])
    if kind == "wedge":
        x, y, h = 0.027, 0.0155, 0.0125
        body = prism(np.array([(-x / 2, -y / 2), (x / 2, -0.36 * y), (x / 2, 0.36 * y),
                               (-x / 2, y / 2)]), 0, h, 0.001)  # fmt: skip
        ribs = [box(0.0016, 1.04 * y, 0.7 * h).move(0.1 * x + 0.004 * k, 0, 0.15 * h)
                for k in range(-1, 3)]  # fmt: skip
        blade = box(0.023, 0.009, 0.0012).turn(2, 0.12).move(0, -0.001, h - 0.0002)
        screw = cylinder(0.0024, 0.002, 14).move(0.001, -0.001, h)
        slot = box(0.004, 0.0006, 0.0004).move(0.001, -0.001, h + 0.0018)
        hole = cylinder(0.0042, 0.0006, 16).turn(1, np.pi / 2).move(x=-x / 2 - 0.0003, z=0.5 * h)
        skin = look.surface(color, look.pick(["plastic", "metal"]))
        return shape(
            [
                (join([body, *ribs]), skin),
                (join([blade, screw]), steel),
                (join([hole, slot]), dark),
            ],
            [hull_of(body), hull_of(blade)],
        ).scale(1.15)
    if kind == "tub":
        r, h = 0.019, look.between(0.034, 0.044)
        tub = lathe([(0, 0), (0.9 * r, 0), (r, 0.004), (r, 0.7 * h), (0, 0.7 * h)], 26)
        lid = lathe([(0, 0.7 * h), (1.03 * r, 0.7 * h), (1.03 * r, 0.86 * h), (0.7 * r, h),
                     (0, h)], 26)  # fmt: skip
        hole = cylinder(0.0045, 0.0006, 16).move(x=0.005, z=h - 0.0002)
        shavings = textures.speckles(look.rng, (222, 206, 176), 20, 32)
        clear = textures.stack((shavings, 4), (textures.plain(tint_color(color, 1.6)), 6))
        return shape([(tub, clear), (lid, textures.plain(color)), (hole, dark)],
                     [hull_of(tub), hull_of(lid)])  # fmt: skip
    body = block(0.055, 0.07, 0.09, 0.012, 0.004)
    drawer = box(0.04, 0.003, 0.035).move(y=-0.036, z=0.012)
    face = cylinder(0.02, 0.012, 26, bevel=0.002).turn(0, np.pi / 2).move(y=-0.034, z=0.067)
    hole = cylinder(0.0048, 0.001, 16).turn(0, np.pi / 2).move(y=-0.0458, z=0.067)
    arm = [
        cylinder(0.005, 0.02, 12).turn(0, -np.pi / 2).move(y=0.034, z=0.06),
        tube([(0, 0.052, 0.06), (0.02, 0.052, 0.095)], 0.004, 8),
        cylinder(0.007, 0.024, 12, bevel=0.001).turn(0, -np.pi / 2).move(0.02, 0.05, 0.095),
    ]
    skin = textures.speckles(look.rng, color, 3, 32)
    return shape([(body, skin), (drawer, textures.plain(tint_color(color, 1.5))),
                  (join([face, *arm]), steel), (hole, dark)],
                 [hull_of(body), hull_of(face), hull_of(*arm)]).scale(0.55)  # fmt: skip


def _crayon(length: float, r: float) -> Solid:
    """Return a wax crayon standing on its flat end, pointed above."""
    return lathe([(0, 0), (r, 0), (r, 0.84 * length), (0.72 * r, 0.86 * length), (0.3 * r, length),
                  (0, length)], 14, v=[0, 0.0, 0.84, 0.86, 1, 1])  # fmt: skip


def _crayon_tile(color: RGB) -> textures.Tile:
    wax, paper = textures.plain(color), textures.plain(tint_color(color, 1.25))
    line = textures.plain((40, 38, 42))
    return textures.stack((wax, 6), (paper, 5), (line, 3), (paper, 56), (line, 3), (paper, 5),
                            (wax, 22), side=128)  # fmt: skip


def crayon(look: Look) -> Shape:
    """A wax crayon in its paper sleeve, lying flat."""
    color = look.color(*RAINBOW)
    length, r = look.between(0.07, 0.095), look.between(0.004, 0.0055)
    rod = _crayon(length, r).turn(1, -np.pi / 2).move(x=length / 2, z=r)
    rod = rod.move(z=-float(rod.bounds[0, 2]))
    return shape([(rod, _crayon_tile(color))],
                 [box_part(0.84 * length, 1.2 * r, float(rod.bounds[1, 2]), (0.08 * length, 0, 0)),
                  hull_of(rod)])  # fmt: skip


def crayon_box(look: Look) -> Shape:
    """An open box of crayons, their tips in two rows."""
    rows, columns = 2, look.pick([4, 6, 8])
    r, long = 0.0045, 0.088
    x, y, h = columns * 2.15 * r + 0.004, rows * 2.15 * r + 0.004, 0.068
    color = look.color("yellow", "yellow", "green", "orange", "blue", "red")
    front = prints.canvas(96, 128, color)
    prints.polygon(
        front, [(0, 1), (0, 0.62), (1, 0.78), (1, 1)], look.own_color("green", "red", "blue")
    )
    prints.fill(front, 0.08, 0.14, 0.84, 0.3, look.own_color("green", "navy", "black"))
    prints.write(front, look.pick(["CRAYONS", "CRAYON", "WAX"]), 0.5, 0.3, 0.16, (250, 250, 246),
                 bold=True)  # fmt: skip
    for k, name in enumerate(("red", "blue", "yellow")):
        prints.stroke(
            front, [(0.24 + 0.2 * k, 0.88), (0.34 + 0.2 * k, 0.56)], 0.05, look.own_color(name)
        )
    flap = box(x, 0.001, 0.036).turn(0, -0.35).move(y=y / 2, z=h)
    pieces = [(box(x, y, h), front), (flap, textures.plain(tint_color(color, 0.9)))]
    one = _crayon(long, r)
    for i in range(columns):
        for j in range(rows):
            tone = look.own_color(RAINBOW[(3 * i + 5 * j) % len(RAINBOW)])
            at = ((i - (columns - 1) / 2) * 2.15 * r, (j - 0.5) * 2.15 * r, 0.002 + 0.004 * j)
            pieces.append((one.move(*at), _crayon_tile(tone)))
    return shape(pieces, [box_part(x, y, h), box_part(x - 0.006, y - 0.006, long - h, (0, 0, h)),
                          hull_of(flap)])  # fmt: skip


def pencil_set(look: Look) -> Shape:
    """Coloured pencils: a flat open tin with a row of them."""
    count = look.pick([8, 10, 12])
    r, long = 0.0038, 0.168
    x, y, h = long + 0.014, count * 2.15 * r + 0.012, 0.014
    color = look.color("silver", "red", "blue", "black", "green", "teal", "white")
    tin = look.surface(color, "metal")
    pieces = [(join(open_box(x, y, h, 0.002, 0.002)), tin)]
    for k in range(count):
        tone = look.own_color(RAINBOW[k * len(RAINBOW) // count], spread=14)
        rod = lathe([(0, 0), (0.0009, 0.003), (r, 0.019), (r, long), (0, long)], 6)
        rod = rod.turn(1, np.pi / 2).move(-long / 2, (k - (count - 1) / 2) * 2.15 * r, 0.0065)
        tile = textures.stack((textures.plain(tone), 3), (textures.plain((222, 186, 132)), 9),
                                (textures.plain(tone), 88), side=128)  # fmt: skip
        pieces.append((rod, tile))
    if look.chance(0.5):
        lid = prints.canvas(176, 96, color)
        for k in range(6):
            tone = look.own_color(RAINBOW[k])
            prints.stroke(lid, [(0.12 + 0.1 * k, 0.9), (0.2 + 0.1 * k, 0.5)], 0.07, tone)
        prints.write(lid, "COLORS", 0.5, 0.26, 0.22, readable_on(color), bold=True)
        cover = box(x, 0.004, y).turn(0, -0.5).move(y=y / 2 + 0.001, z=h - 0.003)
        pieces.append((cover, lid))
        return shape(pieces, [box_part(x, y, h - 0.002), hull_of(cover)])
    return shape(pieces, [box_part(x, y, h - 0.002)])


CATEGORIES = (
    Category("eraser", eraser, (0.053, 0.0217, 0.0127), 0.018, ("rubber", "pencil eraser",
             "rubber eraser"), ("office", "craft"), ("flat",), ("white", "pink"),
             state="lying flat"),
    Category("pencil_sharpener", pencil_sharpener, (0.032, 0.0331, 0.029), 0.015, ("sharpener",
             "electric sharpener",),
             ("office", "craft"), (), ("red", "silver")),
    Category("crayon", crayon, (0.086, 0.00917, 0.00894), 0.005, ("wax crayon",),
        ("craft", "toys"), ("flat",), ("red", "blue"),
             state="lying flat"),
    Category("crayon_box", crayon_box, (0.0596, 0.0362, 0.102), 0.07, ("box of crayons",
             "pack of crayons", "crayon pack", "wax crayons"), ("craft", "toys"), (), ("yellow",)),
    Category("pencil_set", pencil_set, (0.182, 0.102, 0.0305), 0.16, ("colored pencil set",
             "coloured pencil set", "set of colored pencils", "pencil box",
             "set of coloured pencils", "box of colored pencils", "tin of pencils",
             "pencil tin", "set of pencils", "color pencil set"),
             ("craft", "office"), ("flat",), ("red", "blue"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
