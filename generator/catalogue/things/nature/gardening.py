"""Garden hand tools and supplies."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.outlines import rectangle
from ...build.recipes import Pieces, ball, pad, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, join, lathe, loft, open_box, prism
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

STEEL = (150, 154, 160)


def _hand_tool(look: Look, kind: str) -> Shape:
    """A garden hand fork or rake lying, its tines to the left."""
    color = look.color("green", "wooden", "red", "orange", "teal", "brown", "black")
    handle = look.surface(color, look.pick(["wood", "plastic"]) if color[0] > 150 else "plastic")
    steel = textures.brushed_metal(look.rng, STEEL)
    grip = rod([(0.03, 0, 0.0135), (0.08, 0, 0.0135), (0.13, 0, 0.0135), (0.155, 0, 0.0135)],
               [0.0115, 0.0135, 0.0125, 0.0105], 12)  # fmt: skip
    neck = rod([(0.035, 0, 0.0135), (-0.01, 0, 0.017), (-0.045, 0, 0.012)], 0.005, 8)
    if kind == "fork":
        tines = [
            rod(
                [(-0.04, 0.02 * n, 0.012), (-0.09, 0.021 * n, 0.006), (-0.135, 0.02 * n, 0.003)],
                [0.0042, 0.0038, 0.0012],
                7,
            )
            for n in (-1, 0, 1)
        ]
        bar = straight((-0.042, -0.022, 0.012), (-0.042, 0.022, 0.012), 0.0045)
    else:
        tines = [rod([(-0.07, 0.015 * n, 0.024), (-0.1, 0.019 * n, 0.024), (-0.108, 0.02 * n, 0.0)],
                     [0.003, 0.003, 0.0018], 7) for n in (-2, -1, 0, 1, 2)]  # fmt: skip
        fan = [
            rod(
                [(-0.04, 0, 0.012), (-0.055, 0.009 * n, 0.02), (-0.072, 0.015 * n, 0.024)], 0.003, 7
            )
            for n in (-2, -1, 0, 1, 2)
        ]
        bar = join([straight((-0.07, -0.03, 0.024), (-0.07, 0.03, 0.024), 0.0035), *fan])
    pieces: Pieces = [(grip, handle), (join([neck, bar, *tines]), steel)]
    return put_down(pieces, grip, neck, join([bar, *tines]), factor=look.between(0.9, 1.12))


def hand_fork(look: Look) -> Shape:
    """A garden hand fork with three tines."""
    return _hand_tool(look, "fork")


def hand_rake(look: Look) -> Shape:
    """A small rake or cultivator with five tines."""
    return _hand_tool(look, "rake")


def secateurs(look: Look) -> Shape:
    """Pruning shears lying flat, a little open: curved blades to the left, coloured grips."""
    color = look.color("red", "orange", "green", "yellow", "black", "teal")
    skin = textures.speckles(look.rng, color, 4)
    blade = prism([(0.012, -0.008), (0.012, 0.008), (-0.004, 0.014), (-0.03, 0.016), (-0.06, 0.007),
                   (-0.07, 0.001), (-0.04, -0.002), (-0.008, -0.006)], 0.007, 0.011)  # fmt: skip
    hook = prism([(-0.012, -0.004), (-0.035, -0.005), (-0.056, 0.003), (-0.06, -0.001),
                  (-0.042, -0.017), (-0.015, -0.02), (0.012, -0.012), (0.012, 0.008),
                  (0.0, 0.008)], 0.003, 0.0068)  # fmt: skip
    pin = cylinder(0.0085, 0.013, 16).move(z=0.002)
    grips = [rod([(0.005, -s * 0.006, 0.0075), (0.04, s * 0.017, 0.0075), (0.08, s * 0.023, 0.0075),
                  (0.125, s * 0.014, 0.0075)], [0.006, 0.0075, 0.0075, 0.006], 10)
             for s in (-1, 1)]  # fmt: skip
    steel = textures.brushed_metal(look.rng, (190, 194, 200))
    coil = join(
        [
            cylinder(0.006, 0.002, 12)
            .turn(0, np.pi / 2)
            .move(0.035, 0.004 + 0.0035 * n - 0.006, 0.0075)
            for n in range(4)
        ]
    )
    pieces: Pieces = [(join([blade, pin, coil]), steel), (hook, textures.plain((70, 72, 78))),
                      (join(grips), skin)]  # fmt: skip
    return put_down(pieces, join([hook, blade, pin]), *grips, factor=look.between(0.9, 1.1))


def hand_shape(look: Look, colors: tuple[str, ...], cuff: float, *, knit: bool) -> Shape:
    """A glove lying flat, its fingers to the left; mittens have one wide finger."""
    color = look.color(*colors)
    skin = textures.knitting(look.rng, color, 26) if knit else textures.speckles(look.rng, color, 7)
    k = look.between(0.9, 1.12)
    palm = pad(0.1, 0.095, 0.02, 0.03, soft=0.5).move(0.02)
    fingers = [pad(0.085, 0.0245, 0.019, 0.0122, soft=0.5).turn(2, -0.05 * y)
               .move(-0.055 - 0.012 * (1 - (y / 1.7) ** 2), 0.0235 * y)
               for y in (-1.5, -0.5, 0.5, 1.5)]  # fmt: skip
    thumb = pad(0.08, 0.028, 0.019, 0.0135, soft=0.5).turn(2, 0.85).move(-0.002, -0.058)
    sleeve = pad(cuff, 0.1, 0.023, 0.01, soft=0.4).move(0.06 + cuff / 2)
    other = textures.plain(tint_color(color, 0.65))
    pieces: Pieces = [(join([palm, *fingers, thumb]), skin), (sleeve, other)]
    return put_down(pieces, palm, join(fingers), thumb, sleeve, factor=k)


def garden_glove(look: Look) -> Shape:
    """A garden glove with a coloured palm and a knitted cuff."""
    return hand_shape(look, ("green", "yellow", "orange", "tan", "pink", "blue"), 0.045, knit=False)


def fertilizer_bag(look: Look) -> Shape:
    """A small sack of fertilizer or compost standing, a plant on its front."""
    x, y, h = look.between(0.12, 0.15), look.between(0.06, 0.075), look.between(0.17, 0.21)
    color = look.color("green", "olive", "yellow", "brown", "white", "teal")
    image = prints.canvas(112, 160, color)
    prints.fill(image, 0, 0.12, 1, 0.2, (248, 246, 238))
    prints.write(
        image,
        look.pick(["PLANT FOOD", "COMPOST", "FERTILIZER", "SOIL"]),
        0.5,
        0.225,
        0.12,
        tint_color(color, 0.55),
        bold=True,
    )
    prints.stroke(image, [(0.5, 0.85), (0.5, 0.45)], 0.025, (60, 110, 50))
    for s in (-1, 1):
        for z in (0.5, 0.62, 0.74):
            prints.polygon(
                image,
                [
                    (0.5, z + 0.06),
                    (0.5 + s * 0.2, z - 0.03),
                    (0.5 + s * 0.26, z + 0.03),
                    (0.5 + s * 0.1, z + 0.08),
                ],
                (96, 160, 76),
            )
    prints.fill(image, 0.2, 0.85, 0.6, 0.09, (96, 66, 44))
    outline = rectangle(1, 1, 0.3, 3)
    levels = [(0.94, 0.9, 0), (1, 1, 0.02), (1, 1, 0.6), (0.98, 0.6, 0.85), (0.97, 0.1, 0.97),
              (0.97, 0.08, 1.0)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [x * a, y * b], np.full(len(outline), h * z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    front = box(0.84 * x, 0.0008, 0.56 * h).move(0, -y / 2, 0.04 * h)
    z = body.vertices[:, 2]
    return shape(
        [(body, textures.speckles(look.rng, color, 4)), (front, image)],
        [hull_part(body.vertices[z < 0.7 * h]), hull_part(body.vertices[z > 0.5 * h])],
    )


def plant_label(look: Look) -> Shape:
    """A plant label lying flat: a pointed stake with a name."""
    color = look.color("white", "wooden", "yellow", "green", "tan")
    outline = np.array([(-0.06, 0), (-0.04, -0.009), (0.055, -0.009), (0.06, -0.005), (0.06, 0.005),
                        (0.055, 0.009), (-0.04, 0.009)])  # fmt: skip
    body = prism(outline, 0, 0.0022)
    sign = prints.canvas(128, 24, color)
    prints.write(
        sign,
        look.pick(["BASIL", "MINT", "TOMATO", "ROSE", "THYME", "PEAS"]),
        0.5,
        0.5,
        0.7,
        (40, 60, 40),
        bold=True,
    )
    face = box(0.075, 0.015, 0.0005).move(0.015, 0, 0.002)
    return put_down([(body, look.surface(color, "plastic")), (face, sign)], body,
                   factor=look.between(0.85, 1.25))  # fmt: skip


def seed_tray(look: Look) -> Shape:
    """A tray of seedlings: six cells of soil, two leaves in each."""
    color = look.color("black", "green", "brown", "terracotta", "charcoal")
    x, y, h = look.between(0.16, 0.2), look.between(0.11, 0.13), 0.05
    walls = open_box(x, y, h, 0.004, 0.004)
    bars = [box(0.004, y - 0.008, h - 0.006).move((n - 1.5) * x / 3, 0, 0.003)
            for n in (1, 2)]  # fmt: skip
    bars.append(box(x - 0.008, 0.004, h - 0.006).move(0, 0, 0.003))
    soil = box(x - 0.006, y - 0.006, h - 0.014).move(z=0.003)
    shoots: list[Solid] = []
    tops: list[Solid] = []
    for i in (-1, 0, 1):
        for j in (-1, 1):
            tall = look.between(0.02, 0.04)
            at = (i * x / 3, j * y / 4)
            shoots.append(straight((*at, h - 0.014), (*at, h + tall - 0.01), 0.0015, 6))
            turn = look.between(0, 3)
            tops += [ball(0.024, 0.012, 0.003, (0.011, 0, 0), 10).turn(1, -0.4).turn(2, turn + a)
                     .move(*at, h + tall - 0.012) for a in (0, np.pi)]  # fmt: skip
    earth = textures.speckles(look.rng, (76, 56, 42), 26)
    pieces: Pieces = [
        (join([*walls, *bars]), look.surface(color, "plastic")),
        (soil, earth),
        (join([*shoots, *tops]), textures.plain(look.own_color("green", "lime"))),
    ]
    return shape(pieces, [box_part(x, y, h), hull_of(join(tops))])


def garden_hose_nozzle(look: Look) -> Shape:
    """A hose's spray gun lying on its side."""
    color = look.color("green", "yellow", "blue", "orange", "red")
    barrel = (
        cylinder(0.014, 0.1, 18, top=0.018, bevel=0.002).turn(1, -np.pi / 2).move(0.03, 0, 0.02)
    )
    head = cylinder(0.02, 0.018, 20, bevel=0.002).turn(1, -np.pi / 2).move(-0.068, 0, 0.02)
    grip = rod([(0.02, 0, 0.018), (0.045, 0.04, 0.017), (0.055, 0.085, 0.016)],
               [0.014, 0.013, 0.014], 12)  # fmt: skip
    joint = cylinder(0.012, 0.022, 16).turn(0, -np.pi / 2).move(0.057, 0.09, 0.015)
    lever = rod([(-0.02, 0.012, 0.02), (0.005, 0.04, 0.018), (0.025, 0.07, 0.018)], 0.0055, 8)
    skin = textures.speckles(look.rng, color, 4)
    dark = textures.plain((52, 54, 58))
    pieces: Pieces = [(join([barrel, grip]), skin), (join([head, joint, lever]), dark)]
    return put_down(pieces, join([barrel, head]), join([grip, joint]), lever,
                   factor=look.between(0.9, 1.1), foot=0.3)  # fmt: skip


def flower_bulb(look: Look) -> Shape:
    """A flower bulb with its papery skin, roots and a green tip."""
    color = look.color("brown", "tan", "terracotta", "bronze", "amber", "beige")
    body = lathe([(0, 0), (0.01, 0), (0.021, 0.01), (0.023, 0.02), (0.013, 0.036), (0.004, 0.048),
                  (0, 0.05)], 20)  # fmt: skip
    tip = cylinder(0.005, 0.016, 10, top=0.0012).move(z=0.042)
    roots = [rod([(0.006, 0, 0.004), (0.014, 0, 0.002), (0.021, 0.003, 0.001)], 0.0009, 5)
             .turn(2, 0.7 * k) for k in range(9)]  # fmt: skip
    skin = textures.stripes([color, tint_color(color, 0.82), color], 9, upright=True, side=96)
    return put_down([(body, skin), (tip, textures.plain((110, 160, 80))),
                    (join(roots), textures.plain((226, 208, 176)))], body,
                   factor=look.between(0.85, 1.2))  # fmt: skip


CATEGORIES = (
    Category("hand_fork", hand_fork, (0.29, 0.05, 0.027), 0.18, ("garden fork", "weeding fork",
             "gardening fork", "garden hand fork", "dibber"), ("living",), (), ("green", "wooden"),
             state="lying flat"),
    Category("hand_rake", hand_rake, (0.265, 0.085, 0.027), 0.18, ("rake", "garden rake",
             "cultivator", "mini rake", "zen rake", "small rake"), ("living",), (),
             ("green",), state="lying flat"),
    Category("secateurs", secateurs, (0.197, 0.061, 0.015), 0.22, ("pruning shears", "pruner",
             "garden shears", "garden scissors", "hand pruner", "clippers", "garden clippers",
             "pair of secateurs", "pair of pruning shears"), ("living",), (), ("red", "green"),
             state="lying flat"),
    Category("garden_glove", garden_glove, (0.225, 0.13, 0.023), 0.06, ("gardening glove",
             "work glove", "gardener glove"), ("living",), (), ("green", "tan"),
             state="lying flat"),
    Category("fertilizer_bag", fertilizer_bag, (0.135, 0.068, 0.19), 0.9, ("fertilizer",
             "fertiliser", "bag of fertilizer", "potting soil", "compost", "fertiliser bag",
             "bag of soil", "bag of compost", "plant food", "compost bag", "potting soil bag",
             "bag of potting soil", "slug pellet tub"), ("living",), ("tall",), ("green",)),
    Category("plant_label", plant_label, (0.126, 0.019, 0.0026), 0.003, ("plant marker",
             "plant tag", "garden marker", "garden label", "seedling label"), ("living",),
             ("flat",), ("white", "wooden"), state="lying flat"),
    Category("seed_tray", seed_tray, (0.18, 0.12, 0.085), 0.5, ("seedling tray",
             "tray of seedlings", "seedling pot", "propagator", "starter tray",
             "coir pellet"),
             ("living",), (), ("black",)),
    Category("hose_nozzle", garden_hose_nozzle, (0.155, 0.125, 0.04), 0.15, ("spray nozzle",
             "garden hose nozzle", "hose gun", "garden nozzle", "hose sprayer", "sprinkler"),
             ("living",), (),
             ("green", "yellow"), state="lying"),
    Category("flower_bulb", flower_bulb, (0.046, 0.046, 0.06), 0.03, ("tulip bulb",
             "daffodil bulb", "plant bulb"), ("living",), (), ("brown",)),
)  # fmt: skip
"""The module's categories."""
