"""Objects of the ``craft`` theme: art supplies."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, steel, tool_steel
from ...kit.outlines import ellipse, rectangle
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...kit.primitives import (
    at_box,
    ball,
    drum,
    label_skin,
    lay_down,
    plate,
    rod,
    standing,
    standing_plate,
    vessel,
    vessel_parts,
)
from ...kit.shapes import Category, Pieces, Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, open_box, prism, tube
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color
from ..toys.vehicles import _paper, sheet
from .sewing_supplies import HUES


@category("easel", size=(0.196, 0.191, 0.277), mass=0.4, material="wood", assembled=True,
          aliases=("table easel", "wooden easel", "mini easel", "display easel", "tabletop easel",
          "artist's easel"), themes=("craft",), roles=("tall",), colors=("wooden",))  # fmt: skip
def easel(look: Look) -> Shape:
    """A small, empty table easel with a ledge."""
    color = look.color("wooden", "tan", "brown", "white", "black")
    k = look.between(0.8, 1.05)
    legs = [rod([(s * 0.09, -0.05, 0.005), (s * 0.02, 0.02, 0.27)], 0.007, 6) for s in (-1, 1)]
    rear = rod([(0, 0.12, 0.005), (0, 0.018, 0.25)], 0.007, 6)
    ledge = [at_box(0.2, 0.034, 0.01, (0, -0.05, 0.06)),
             at_box(0.2, 0.006, 0.018, (0, -0.066, 0.06))]  # fmt: skip
    cross, top = (at_box(0.085, 0.012, 0.014, (0, -0.002, 0.17)),
                  block(0.06, 0.014, 0.03, 0.004).move(0, 0.018, 0.255))  # fmt: skip
    chain = rod([(0, 0.075, 0.11), (0, 0.03, 0.095), (0, -0.02, 0.1)], 0.0015, 6)
    return put_down([(join([*legs, rear, *ledge, cross, top]), look.surface(color, "wood")),
                     (chain, steel(look, BRASS_TONE))], *legs, rear, *ledge, top,
                    factor=k)  # fmt: skip


@category("paint_bottle", size=(0.073, 0.073, 0.185), mass=0.45, material="plastic",
          aliases=("bottle of paint", "paint", "paint pot"), themes=("craft",),
          roles=("tall", "round"), colors=("red", "blue", "yellow"), common=True)  # fmt: skip
def paint_bottle(look: Look) -> Shape:
    """A bottle of paint with a label in the paint's colour, and with a pump, nozzle or wide cap."""
    r, h = look.between(0.033, 0.04), look.between(0.128, 0.152)
    color = look.color(
        *("red", "blue", "yellow", "green", "purple", "orange", "teal", "pink", "white", "brown")
    )
    kind = look.pick(["pump", "pump", "nozzle", "cap"])
    word = look.pick(["PAINT", "ACRYL", "TEMPERA", "GOUACHE"])
    body = vessel(r, h, 0.014, look.between(0.72, 0.84) * h, 0.95 * h)
    ground = look.pick([(244, 242, 234), (250, 250, 250), (38, 38, 42), tint_color(color, 1.6)])
    skin = label_skin(look, color, word, look.between(0.14, 0.26), look.between(0.54, 0.68), ground)
    top = surfaces.plain(look.pick([(238, 238, 236), (238, 238, 236), (40, 40, 44), color]))
    pieces = [(body, skin)]
    parts = vessel_parts(body, r, 0.72 * h, 0.014, h, 0.95 * h)
    if kind == "pump":
        collar = cylinder(0.0165, 0.014, 20, bevel=0.001).move(z=h - 0.002)
        stem = cylinder(0.005, 0.026, 12).move(z=h + 0.01)
        head = box(0.016, 0.045, 0.012).move(y=-0.012, z=h + 0.034)
        pieces += [(collar, top), (stem, top), (head, top)]
        parts += [cylinder_part(0.0165, 0.014, (0, 0, h - 0.002)),
                  cylinder_part(0.005, 0.026, (0, 0, h + 0.01)),
                  box_part(0.016, 0.045, 0.012, (0, -0.012, h + 0.034))]  # fmt: skip
    else:
        wide = 0.0165 if kind == "nozzle" else 0.6 * r
        tall, tip = (0.042, 0.004) if kind == "nozzle" else (0.028, 0.55 * r)
        cap = cylinder(wide, tall, 20, top=tip, bevel=0.001).move(z=h - 0.002)
        pieces.append((cap, top))
        parts.append(hull_of(cap))
    return shape(pieces, parts)


@category("cardboard_tube", size=(0.0446, 0.0446, 0.165), mass=0.01, material="paper", hollow=True,
          aliases=("toilet roll tube", "paper towel tube", "empty toilet roll", "kitchen roll tube",
          "cardboard roll", "paper tube", "empty roll", "film poster tube", "poster tube"),
          themes=("craft",), roles=("tall",), colors=("tan",))  # fmt: skip
def cardboard_tube(look: Look) -> Shape:
    """An empty cardboard tube with a visible spiral seam, standing upright."""
    color = look.color("tan", "brown", "beige", "wooden")
    long = look.pick([0.1, 0.1, 0.23]) * look.between(0.92, 1.08)
    r = look.between(0.02, 0.024)
    wall = lathe([(r, 0), (r, long), (r - 0.0016, long), (r - 0.0016, 0)], 28, loop=True)
    y, x = np.mgrid[0:96, 0:96] / 96
    seam = (np.abs((x + 2 * y) % 1 - 0.5) < 0.03)[..., None]
    image = np.where(seam, np.array(color) * 0.75, np.array(color) + 6 * np.sin(60 * x)[..., None])
    parts = ring_parts([(r, 0), (r, long)], [(r - 0.0016, long), (r - 0.0016, 0)])
    return shape([(wall, np.clip(image, 0, 255).astype(np.uint8))], parts)


def stick(radius: float, long: float, palette: tuple[str, ...], square: bool) -> Callable:
    """A stick of chalk, pastel or charcoal, lying flat."""

    def make(look: Look) -> Shape:
        k = look.between(0.85, 1.1)
        color = look.color(*palette)
        r, n = radius * k, long * k * look.between(0.8, 1.1)
        dust = surfaces.spots(look.rng, color, tint_color(color, 1.2 if sum(color) < 600 else 0.9),
                              0.15)  # fmt: skip
        if square:
            body = box(n, 1.8 * r, 1.8 * r)
            return shape([(body, dust)], [hull_of(body)])
        body = lay_down(cylinder(r, n, 20, top=0.88 * r), -n / 2, r)
        body = body.move(z=-float(body.bounds[0, 2]))
        return shape([(body, dust)], [flat_foot(body.vertices, 0.12)])

    return make


RAINBOW = ("red", "orange", "yellow", "green", "teal", "blue", "purple", "pink", "brown", "black")


def _crayon(length: float, r: float) -> Solid:
    """Return a pointed wax crayon standing on its flat end."""
    return lathe([(0, 0), (r, 0), (r, 0.84 * length), (0.72 * r, 0.86 * length), (0.3 * r, length),
                  (0, length)], 14, v=[0, 0.0, 0.84, 0.86, 1, 1])  # fmt: skip


def _crayon_tile(color: RGB) -> surfaces.Tile:
    wax, paper = surfaces.plain(color), surfaces.plain(tint_color(color, 1.25))
    line = surfaces.plain((40, 38, 42))
    return surfaces.stack((wax, 6), (paper, 5), (line, 3), (paper, 56), (line, 3), (paper, 5),
                            (wax, 22), side=128)  # fmt: skip


@category("crayon", size=(0.086, 0.00917, 0.00894), mass=0.005, material="plastic",
          aliases=("wax crayon",), themes=("craft", "toys"), roles=("flat",),
          colors=("red", "blue"), state="lying flat")  # fmt: skip
def crayon(look: Look) -> Shape:
    """A wax crayon in its paper sleeve, lying flat."""
    color = look.color(*RAINBOW)
    length, r = look.between(0.07, 0.095), look.between(0.004, 0.0055)
    rod = _crayon(length, r).turn(1, -np.pi / 2).move(x=length / 2, z=r)
    rod = rod.move(z=-float(rod.bounds[0, 2]))
    return shape([(rod, _crayon_tile(color))],
                 [box_part(0.84 * length, 1.2 * r, float(rod.bounds[1, 2]), (0.08 * length, 0, 0)),
                  hull_of(rod)])  # fmt: skip


@category("crayon_box", size=(0.0596, 0.0362, 0.102), mass=0.07, material="paper", assembled=True,
          aliases=("box of crayons", "pack of crayons", "crayon pack", "wax crayons"),
          themes=("craft", "toys"), colors=("yellow",))  # fmt: skip
def crayon_box(look: Look) -> Shape:
    """An open box of crayons in two rows, with their tips visible."""
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
    pieces = [(box(x, y, h), front), (flap, surfaces.plain(tint_color(color, 0.9)))]
    one = _crayon(long, r)
    for i in range(columns):
        for j in range(rows):
            tone = look.own_color(RAINBOW[(3 * i + 5 * j) % len(RAINBOW)])
            at = ((i - (columns - 1) / 2) * 2.15 * r, (j - 0.5) * 2.15 * r, 0.002 + 0.004 * j)
            pieces.append((one.move(*at), _crayon_tile(tone)))
    return shape(pieces, [box_part(x, y, h), box_part(x - 0.006, y - 0.006, long - h, (0, 0, h)),
                          hull_of(flap)])  # fmt: skip


@category("pencil_set", size=(0.182, 0.102, 0.0305), mass=0.16, material="metal", assembled=True,
          aliases=("colored pencil set", "coloured pencil set", "set of colored pencils",
          "pencil box", "set of coloured pencils", "box of colored pencils", "tin of pencils",
          "pencil tin", "set of pencils", "color pencil set"), themes=("craft", "office"),
          roles=("flat",), colors=("red", "blue"), state="lying flat")  # fmt: skip
def pencil_set(look: Look) -> Shape:
    """A flat open tin with a row of coloured pencils."""
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
        tile = surfaces.stack((surfaces.plain(tone), 3), (surfaces.plain((222, 186, 132)), 9),
                                (surfaces.plain(tone), 88), side=128)  # fmt: skip
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


PAPERS = ("red", "blue", "yellow", "pink", "teal", "orange", "purple", "white", "mint")


@category("origami_crane", size=(0.147, 0.127, 0.0672), mass=0.004, material="paper",
          assembled=True, aliases=("origami", "paper crane", "origami bird", "folded crane",
          "paper bird", "origami figure", "origami swan"), themes=("craft", "toys"),
          colors=("red", "blue"))  # fmt: skip
def origami_crane(look: Look) -> Shape:
    """A folded paper crane with raised wings, a neck and a tail."""
    color = look.color(*PAPERS)
    k = look.between(0.8, 1.25)
    body = [sheet((0.026, s * 0.001, 0.032), (-0.026, s * 0.001, 0.032), (0, s * 0.017, 0.0))
            for s in (1, -1)]  # fmt: skip
    front = [sheet((0.026, 0.001, 0.032), (0, s * 0.017, 0.0), (0, 0, 0.04)) for s in (1, -1)]
    wings = [sheet((0.02, s * 0.002, 0.03), (-0.02, s * 0.002, 0.03), (-0.006, s * 0.062, 0.052))
             for s in (1, -1)]  # fmt: skip
    neck = standing_plate([(0.006, 0.012), (0.02, 0.012), (0.058, 0.062), (0.052, 0.066)], 0.004)
    beak = standing_plate([(0.052, 0.065), (0.058, 0.061), (0.076, 0.05), (0.058, 0.066)], 0.0035)
    tail = standing_plate([(-0.02, 0.012), (-0.006, 0.012), (-0.068, 0.06)], 0.004)
    keel = standing((0.015, 0), (0.012, 0.012), (0.002, 0.034), sides=4).scale(1.4, 1, 1)
    inner = surfaces.plain(tint_color(color, 1.35))
    paper = _paper(look, color)
    return put_down([(join([*body, *front, keel, neck, tail]), paper), (join(wings), paper),
                     (beak, inner)], keel, *wings, neck, tail, factor=k)  # fmt: skip


@category("googly_eye", size=(0.0241, 0.0243, 0.00656), mass=0.001, material="plastic",
          aliases=("googly eyes", "google eye", "wiggle eye", "craft eye", "toy eye"),
          themes=("craft",), roles=("flat",), colors=("white",))  # fmt: skip
def googly_eye(look: Look) -> Shape:
    """A stick-on googly eye: a white disc with a loose black pupil."""
    color = look.color("white", "white", "yellow", "sky", "pink", "lime")
    r = look.between(0.008, 0.016)
    a, d = look.between(0, 6.28), 0.36 * r
    back = drum(r, 0.25 * r, sides=26, bevel=0.05 * r)
    dome = standing((0.93 * r, 0), (0.9 * r, 0.12 * r), (0.6 * r, 0.2 * r), (0.2 * r, 0.24 * r),
                  at=(0, 0, 0.24 * r), sides=26)  # fmt: skip
    pupil = drum(
        0.5 * r, 0.3 * r, (d * np.cos(a), d * np.sin(a), 0.24 * r), sides=20, bevel=0.05 * r
    )
    return put_down(
        [(join([back, dome]), plain(color)), (pupil, plain((28, 28, 30)))], join([back, dome])
    )


@category("pipe_cleaner", size=(0.175, 0.0301, 0.00705), mass=0.003, material="fabric",
          aliases=("chenille stem", "fuzzy stick"), themes=("craft",), roles=("flat",),
          colors=("red", "blue"))  # fmt: skip
def pipe_cleaner(look: Look) -> Shape:
    """A fuzzy pipe cleaner bent in a wave, lying flat."""
    color = look.color("red", "blue", "green", "yellow", "pink", "purple", "orange", "brown")
    k, wave = look.between(0.8, 1.2), look.between(0.006, 0.02)
    x = np.linspace(-0.09, 0.09, 70)
    path = np.column_stack([x, wave * np.sin(x * 40), 0.0034 + 0 * x])
    t = np.arange(70)
    fuzz = tube(path, 0.0034 * (1 + 0.16 * np.cos(2.6 * t)), 8)
    fur = surfaces.scratches(look.rng, color, tint_color(color, 1.35), 120)
    halves = [tube(path[i : i + 19], 0.0034, 8) for i in (0, 17, 34, 51)]
    return put_down([(fuzz, fur)], *halves, factor=k, foot=0.4)


@category("lolly_stick", size=(0.127, 0.0135, 0.0022), mass=0.002, material="wood",
          aliases=("ice lolly stick", "lollipop stick", "wooden craft stick"), themes=("craft",),
          roles=("flat",), colors=("tan",))  # fmt: skip
def lolly_stick(look: Look) -> Shape:
    """A flat wooden lolly stick with round ends."""
    color = look.color("tan", "wooden", "red", "blue", "green", "yellow", "beige")
    long, w = look.between(0.1, 0.15), look.between(0.009, 0.017)
    made = plate(rectangle(long, w, 0.499 * w, 8), 0.0022, bevel=0.0004)
    return put_down([(made, surfaces.wood(look.rng, color))], made)


BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "black")


@category("paint_palette", size=(0.26, 0.19, 0.011), mass=0.16, material="wood",
          aliases=("palette", "artist palette", "painter's palette"), themes=("craft",),
          roles=("flat",), state="lying flat", common=True)  # fmt: skip
def paint_palette(look: Look) -> Shape:
    """A painter's palette with dabs of paint, lying flat."""
    wood = surfaces.wood(look.rng, look.pick([(206, 164, 112), (150, 100, 62), (226, 200, 160)]))
    if look.chance(0.4):
        wood = surfaces.plain(look.color("white", "cream", "black"))
    board = prism(ellipse(look.between(0.24, 0.28), look.between(0.175, 0.205), 28), 0, 0.006)
    pieces = [(board, wood)]
    for k, name in enumerate(
        look.rng.permutation(
            ["red", "blue", "yellow", "green", "white", "orange", "violet", "pink", "brown", "teal"]
        )[: look.rng.integers(4, 8)]
    ):
        a = 0.55 + 0.48 * k
        dab = ellipsoid(look.between(0.022, 0.038), look.between(0.02, 0.032), 0.009, 14, 6).move(
            0.095 * np.cos(a), 0.065 * np.sin(a), 0.0065
        )
        pieces.append((dab, surfaces.plain(look.own_color(name))))
    hole = cylinder(0.014, 0.0005, 18).move(0.05, -0.045, 0.0058)
    pieces.append((hole, surfaces.plain((120, 92, 62))))
    return shape(pieces, [hull_of(board)])


@category("paint_tube", size=(0.123, 0.042, 0.02), mass=0.06, material="plastic",
          aliases=("tube of paint", "oil paint", "acrylic paint", "acrylic tube", "gouache tube",
          "watercolour tube", "oil paint tube"), themes=("craft",),
          colors=("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "black"),
          state="lying flat", common=True)  # fmt: skip
def paint_tube(look: Look) -> Shape:
    """A tube of paint lying on its flat side."""
    color = look.color(*BRIGHT, "crimson", "teal")
    body = prism(
        [(-0.06, -0.021), (0.035, -0.017), (0.048, -0.009), (0.048, 0.009), (0.035, 0.017),
         (-0.06, 0.021)],
        0, 0.02, 0.004,
    )  # fmt: skip
    image = prints.canvas(96, 48, (238, 238, 236))
    prints.fill(image, 0.3, 0, 0.4, 1, color)
    prints.write(image, "OIL", 0.5, 0.5, 0.3, (250, 250, 250))
    flat = box(0.08, 0.024, 0.0008).move(x=-0.01, z=0.0198)
    cap = cylinder(0.008, 0.016, 14, bevel=0.001).turn(1, np.pi / 2).move(0.047, 0, 0.0095)
    return shape([(body, surfaces.brushed_metal(look.rng, (206, 208, 212))), (flat, image),
                  (cap, surfaces.plain(tint_color(color, 0.7)))],
                 [hull_of(body), hull_of(cap)])  # fmt: skip


@category("canvas", size=(0.3, 0.235, 0.018), mass=0.35, material="fabric",
          aliases=("blank canvas", "painting canvas", "stretched canvas", "artist canvas"),
          themes=("craft",), roles=("flat",), colors=("white",), state="lying flat",
          common=True)  # fmt: skip
def canvas(look: Look) -> Shape:
    """A blank canvas on a stretcher frame, lying flat."""
    x, y, h = look.between(0.27, 0.33), look.between(0.21, 0.26), look.between(0.016, 0.02)
    cloth = surfaces.speckles(look.rng, look.color("white", "cream"), 5, 64)
    return shape([(block(x, y, h, 0.004, 0.002), cloth)], [box_part(x, y, h)])


@category("paint_brush", size=(0.18, 0.034, 0.011), mass=0.04, material="wood",
          aliases=("paintbrush", "artist brush", "fan brush", "sponge brush", "mop brush",
          "foam brush", "watercolour brush", "stencil brush", "glue brush"),
          themes=("craft", "workbench"), roles=("flat",), colors=("wooden", "red"),
          state="lying flat", common=True)  # fmt: skip
def paint_brush(look: Look) -> Shape:
    """A flat paint brush, lying on its side."""
    w = look.between(0.022, 0.045)
    wood = look.surface(look.color("wooden", "red", "black", "yellow"), "plastic")
    tip = look.own_color("tan", "brown", "black")
    hair = surfaces.stripes([tip, tint_color(tip, 0.7)], 14, upright=True)
    handle = prism(
        [(-0.12, -0.004), (-0.06, -0.008), (-0.01, -0.4 * w), (-0.01, 0.4 * w), (-0.06, 0.008),
         (-0.12, 0.004)],
        0.0, 0.01, 0.003,
    )  # fmt: skip
    ferrule = block(0.03, w, 0.011, 0.003, 0.001).move(x=0.0)
    bristle = prism(
        [(0.014, -w * 0.47), (0.06, -w * 0.42), (0.06, w * 0.42), (0.014, w * 0.47)], 0.0015, 0.009
    )
    return shape([(handle, wood), (ferrule, tool_steel(look)), (bristle, hair)],
                 [hull_of(handle), box_part(0.03, w, 0.011), hull_of(bristle)])  # fmt: skip


@category("glue_stick", size=(0.028, 0.028, 0.1), mass=0.035, material="plastic",
          aliases=("glue", "glue tube", "wood glue bottle"), themes=("craft", "office"),
          roles=("round",), colors=("yellow", "red"), common=True)  # fmt: skip
def glue_stick(look: Look) -> Shape:
    """A glue stick with its cap on, standing upright."""
    r, h = look.between(0.0125, 0.0145), look.between(0.085, 0.1)
    color = look.color("yellow", "red", "blue", "green", "violet")
    print_ = prints.label(look.rng, "GLUE", color, (246, 246, 242))
    foot = cylinder(r * 1.05, 0.012, 20, bevel=0.001)
    body = cylinder(r, 0.62 * h, 24).move(z=0.01)
    cap = cylinder(r * 1.08, 0.36 * h, 24, top=r, bevel=0.0015).move(z=0.01 + 0.62 * h)
    tint = surfaces.plain(color)
    return shape(
        [(foot, tint), (body, print_), (cap, tint)],
        [cylinder_part(r, 0.01 + 0.62 * h), hull_of(foot), hull_of(cap)],
    )


@category("mannequin", size=(0.104, 0.104, 0.24), mass=0.4, material="fabric",
          aliases=("dress form", "tailor dummy", "dressmaker dummy", "small mannequin",
          "mini mannequin", "tailors dummy", "mannequin head", "artist mannequin",
          "wooden mannequin"), themes=("craft",), roles=("tall",), colors=("beige",))  # fmt: skip
def mannequin(look: Look) -> Shape:
    """A dressmaker's mannequin on a stand, without a head or arms."""
    color = look.color("beige", "cream", "white", "black", "pink", "gray")
    levels = [(0.036, 0.03, 0.09), (0.046, 0.036, 0.105), (0.033, 0.027, 0.14),
              (0.042, 0.034, 0.17), (0.046, 0.032, 0.19), (0.02, 0.018, 0.21),
              (0.013, 0.013, 0.216), (0.0125, 0.0125, 0.23)]  # fmt: skip
    path = np.array(levels)
    body = lathe([(0, 0.09), *[(a, z) for a, _, z in levels], (0, 0.23)], 26).bend(
        lambda p: p * np.column_stack([np.ones(len(p)), np.interp(p[:, 2], path[:, 2],
                                       path[:, 1] / path[:, 0]), np.ones(len(p))]))  # fmt: skip
    knob = cylinder(0.008, 0.012, 14, top=0.005).move(z=0.229)
    pole = cylinder(0.005, 0.09, 12).move(z=0.006)
    foot = lathe([(0, 0), (0.05, 0), (0.052, 0.006), (0.03, 0.014), (0.008, 0.02), (0, 0.02)], 24)
    seam = [box(0.0014, 0.002, 0.1).move(0, -0.0335, 0.1)]
    wood = surfaces.wood(look.rng, look.own_color("brown", "wooden", "charcoal"))
    pieces: Pieces = [(body, surfaces.fabric(look.rng, color)), (join([knob, pole, foot]), wood),
                      (join(seam), surfaces.plain(tint_color(color, 0.7)))]  # fmt: skip
    return put_down(pieces, foot, pole, body, factor=look.between(0.9, 1.1))


@category("pompom", size=(0.037, 0.037, 0.036), mass=0.003, material="fabric", assembled=True,
          aliases=("pom pom", "pom-pom", "craft pompom", "fluffy ball", "pompom maker"),
          themes=("craft",), roles=("round",), colors=("red", "pink"))  # fmt: skip
def pompom(look: Look) -> Shape:
    """A fluffy pompom."""
    color = look.color(*HUES, "orange")
    d = look.between(0.025, 0.05)
    tufts = [ball(0.4 * d, 0.4 * d, 0.4 * d, tuple(0.34 * d * np.array([
        np.sqrt(1 - z * z) * np.cos(2.4 * k), np.sqrt(1 - z * z) * np.sin(2.4 * k), z])), 8)
        for k, z in enumerate(np.linspace(-0.95, 0.95, 34))]  # fmt: skip
    body = join([*tufts, ball(0.86 * d, 0.86 * d, 0.86 * d, (0, 0, 0), 10)]).move(z=0.47 * d)
    wool = surfaces.scratches(look.rng, color, tint_color(color, 0.75), 120)
    return put_down([(body, wool)], body)


CATEGORIES = (
    Category("pastel",
             stick(0.0055, 0.062, ("red", "orange", "purple", "teal", "green", "pink"), True),
             size=(0.058, 0.0097, 0.0097), mass=0.008, material="wax", friction=0.6,
             aliases=("oil pastel", "soft pastel", "pastel stick", "chalk pastel", "pastel crayon",
             "blending stump", "pencil stub"), themes=("craft",), colors=("red", "blue"),
             state="lying flat"),
    Category("charcoal_stick", stick(0.0042, 0.09, ("black", "charcoal", "black"), False),
             size=(0.084, 0.0082, 0.0082), mass=0.004, material="wax", friction=0.6,
             aliases=("drawing charcoal", "stick of charcoal", "charcoal piece", "willow charcoal"),
             themes=("craft",), colors=("black",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
