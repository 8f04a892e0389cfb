"""Electric kitchen machines: bread makers, grills, fryers, sealers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import facing
from ...build.outlines import rectangle
from ...build.recipes import pad
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

BODY = ("white", "black", "silver", "red", "cream", "gray", "mint")


STEEL: RGB = (190, 194, 200)


INK: RGB = (34, 36, 40)


def turn_knob(r: float, x: float, y: float, z: float) -> Solid:
    """Return a knob on a front."""
    return facing(cylinder(r, 0.012, 18, top=0.85 * r)).move(x, y, z)


def _panel(look: Look, wide: int = 128, tall: int = 48) -> textures.Tile:
    image = prints.canvas(wide, tall, INK)
    prints.fill(image, 0.08, 0.2, 0.34, 0.6, (150, 200, 170))
    prints.write(
        image[:, : int(0.5 * wide)],
        look.pick(["12:30", "0:45", "3:20", "1:00"]),
        0.5,
        0.5,
        0.4,
        (30, 50, 40),
        bold=True,
    )
    for n in range(6):
        prints.disc(image, 0.55 + 0.16 * (n % 3), 0.32 + 0.38 * (n // 3), 0.12, (200, 204, 208))
    return image


def bread_maker(look: Look) -> Shape:
    """A bread maker: a tall rounded box, a window in its lid, a panel beside it."""
    k, color = look.between(0.88, 1.05), look.color(*BODY)
    x, y, h = 0.32 * k, 0.22 * k, 0.26 * k
    body, lid = (
        block(x, y, h, 0.04 * k, 0.004),
        block(0.7 * x, 0.9 * y, 0.03 * k, 0.03 * k, 0.008).move(-0.12 * x, 0, h),
    )
    window = box(0.3 * x, 0.4 * y, 0.001).move(-0.12 * x, 0, h + 0.03 * k - 0.0004)
    panel = box(0.2 * x, 0.7 * y, 0.002).move(0.36 * x, 0, h - 0.0005)
    grip = box(0.2 * x, 0.012, 0.012).move(-0.12 * x, -0.46 * y, h + 0.008 * k)
    slots = [box(0.001, 0.3 * y, 0.004).move(x / 2, 0, 0.3 * h + 0.012 * n) for n in range(4)]
    tile = look.surface(color, "plastic")
    return shape([(body, tile), (lid, textures.speckles(look.rng, tint_color(color, 0.9), 3)),
                  (window, textures.plain((70, 60, 54))),
                  (panel, _panel(look, 48, 128)), (join([grip, *slots]), textures.plain(INK))],
                  [box_part(x, y, h), hull_of(lid)])  # fmt: skip


def _griddle(ribs: bool, wide: float, open_: float) -> Callable[[Look], Shape]:
    """Return the shape function of a clamshell grill, shut or with its lid up."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.88, 1.08), look.color("black", "silver", "red", "gray", "white")
        x, y, h = wide * k, 0.24 * k, 0.05 * k
        low = block(x, y, h, 0.03 * k, 0.006)
        plate = box(0.86 * x, 0.84 * y, 0.003).move(z=h - 0.0006)
        bars = (
            [box(0.006, 0.8 * y, 0.003).move(i * 0.05 * x, 0, h + 0.002) for i in range(-8, 9)]
            if ribs
            else []
        )
        lean = look.pick([0.0, open_])
        top = (
            block(x, y, h, 0.03 * k, 0.008).move(y=-y / 2).turn(0, -lean).move(y=y / 2, z=h + 0.008)
        )
        grip = tube(
            [
                (-0.22 * x, -y, 0.4 * h),
                (-0.22 * x, -y - 0.035, 0.4 * h),
                (0.22 * x, -y - 0.035, 0.4 * h),
                (0.22 * x, -y, 0.4 * h),
            ],
            0.008 * k,
            8,
        )
        grip = grip.turn(0, -lean).move(y=y / 2, z=h + 0.008)
        hinge = [
            cylinder(0.011, 0.03, 12).turn(1, np.pi / 2).move(s * 0.3 * x - 0.015, y / 2, h + 0.003)
            for s in (-1, 1)
        ]
        lamp = [box(0.006, 0.002, 0.006).move(s * 0.02, -y / 2 - 0.0005, 0.5 * h) for s in (-1, 1)]
        tile = look.surface(color, "steel" if color[0] > 170 and color[1] > 160 else "plastic")
        dark = textures.plain((46, 46, 50))
        pieces = [(join([low, top]), tile), (join([plate, *bars]), textures.plain((62, 62, 66))),
                  (join([grip, *hinge]), dark),
                  (join(lamp), textures.plain((226, 60, 50)))]  # fmt: skip
        return shape(pieces, [hull_of(low), hull_of(top), hull_of(grip)])

    return make


def raclette_grill(look: Look) -> Shape:
    """A raclette grill: a plate on legs over a shelf of little pans with handles."""
    k, color = look.between(0.88, 1.05), look.color("black", "red", "silver", "gray")
    x, y = 0.38 * k, 0.2 * k
    shelf, plate = (
        block(x, y, 0.012, 0.03 * k).move(z=0.02),
        block(x, y, 0.014, 0.03 * k, 0.004).move(z=0.085 * k),
    )
    feet = [
        cylinder(0.012, 0.022, 12).move(i * 0.42 * x, j * 0.36 * y, 0)
        for i in (-1, 1)
        for j in (-1, 1)
    ]
    posts = [box(0.02, 0.02, 0.075 * k).move(s * 0.46 * x, 0, 0.025) for s in (-1, 1)]
    pans, grips = [], []
    for i in range(-1, 3):
        for s in (-1, 1):
            at = ((i - 0.5) * 0.23 * x, s * 0.4 * y)
            pans.append(block(0.07 * k, 0.09 * k, 0.012, 0.012).move(*at, 0.032))
            grips.append(
                limb(
                    [
                        (at[0], s * 0.6 * y, 0.04),
                        (at[0], s * 0.75 * y, 0.046),
                        (at[0], s * 0.95 * y, 0.05),
                    ],
                    [0.005, 0.007, 0.007],
                    7,
                )
            )
    ribs = [
        box(0.4 * x, 0.004, 0.002).move(-0.22 * x, j * 0.09 * y, 0.085 * k + 0.0135)
        for j in range(-4, 5)
    ]
    knob = turn_knob(0.016, 0.0, -y / 2, 0.026)
    tile = look.surface(color, "plastic")
    return shape([(join([shelf, *posts, *feet]), tile), (join([plate, *ribs]),
                                                         textures.plain((52, 52, 56))),
                                                         (join(pans), textures.plain((70, 70, 74))),
                  (join([*grips, knob]), textures.plain((30, 30, 32)))],
                  [hull_of(shelf, *feet), *[hull_of(p) for p in posts], hull_of(plate),
                   hull_of(*grips)])  # fmt: skip


def deep_fryer(look: Look) -> Shape:
    """A deep fryer: a steel box of oil with a wire basket on a long handle."""
    k, color = look.between(0.88, 1.05), look.color("silver", "black", "white", "red")
    x, y, h = 0.2 * k, 0.27 * k, 0.16 * k
    body = block(x, y, h, 0.02 * k, 0.004)
    rim = block(1.04 * x, 1.03 * y, 0.014, 0.022 * k).move(z=h - 0.006)
    oil = box(0.84 * x, 0.7 * y, 0.001).move(y=-0.06 * y, z=h + 0.008)
    bx, by = 0.72 * x, 0.56 * y
    wires = [box(0.0022, by, 0.0022).move(i * bx / 8, -0.06 * y, h + 0.012) for i in range(-4, 5)]
    wires += [
        box(bx, 0.0022, 0.0022).move(0, j * by / 8 - 0.06 * y, h + 0.012) for j in range(-4, 5)
    ]
    wires += [box(bx, 0.003, 0.02).move(0, s * by / 2 - 0.06 * y, h + 0.01) for s in (-1, 1)]
    wires += [box(0.003, by, 0.02).move(s * bx / 2, -0.06 * y, h + 0.01) for s in (-1, 1)]
    chips = [
        box(0.009, 0.04, 0.009)
        .turn(2, 1.3 * n)
        .move(
            bx * (0.3 * np.cos(2.4 * n)),
            by * 0.3 * np.sin(1.7 * n) - 0.06 * y,
            h + 0.013 + 0.003 * (n % 3),
        )
        for n in range(14)
    ]
    grip = limb(
        [(0, -0.34 * y, h + 0.024), (0, -0.55 * y, h + 0.04), (0, -0.8 * y, h + 0.042)],
        [0.006, 0.01, 0.012],
        8,
    )
    box_ = block(0.6 * x, 0.06 * y, 0.5 * h, 0.01).move(y=0.5 * y, z=0.5 * h + 0.02)
    return shape([(body, look.surface(color, "steel" if color[0] > 150 else "plastic")),
                  (join([rim, box_]), textures.plain(INK)), (oil, textures.plain((206, 160, 60))),
                  (join(wires), textures.plain((214, 218, 222))), (join(chips),
                      textures.plain((240, 200, 100))), (grip, textures.plain((30, 30, 32))),
                  (turn_knob(0.016, 0, -0.5 * y, 0.3 * h), textures.plain((90, 94, 98)))],
                  [hull_of(body, rim), hull_of(box_), hull_of(grip)])  # fmt: skip


def crepe_maker(look: Look) -> Shape:
    """A crepe maker: a wide black disc on a low base, a thin crepe and a wooden spreader on it."""
    k, color = (
        look.between(0.9, 1.1),
        look.color("black", "red", "silver", "white", "cream", "teal"),
    )
    r = 0.16 * k
    base = lathe([(0, 0), (0.8 * r, 0), (0.95 * r, 0.03), (r, 0.045), (0, 0.045)], 36)
    plate = cylinder(0.99 * r, 0.012, 40, bevel=0.003).move(z=0.045)
    crepe = cylinder(0.78 * r, 0.0015, 34).move(z=0.057)
    tee = [
        tube([(0.1 * r, -0.1 * r, 0.064), (1.15 * r, -0.5 * r, 0.07)], 0.005, 8),
        tube([(-0.02 * r, -0.42 * r, 0.063), (0.22 * r, 0.2 * r, 0.063)], 0.006, 8),
    ]
    lamp = [box(0.012, 0.004, 0.008).move(0.02 * s, -0.93 * r, 0.018) for s in (-1, 1)]
    return shape([(base, look.surface(color, "plastic")), (plate, textures.plain((44, 44, 48))),
                  (crepe, textures.spots(look.rng, (236, 206, 140), (206, 156, 84), 0.2)),
                  (join(tee), textures.wood(look.rng, (206, 168, 112))),
                  (join(lamp), textures.plain((226, 60, 50)))], [hull_of(base, plate),
                      hull_of(*tee)])  # fmt: skip


def vacuum_sealer(look: Look) -> Shape:
    """A vacuum sealer: a long flat machine, a hinged lid, buttons, a bag in its mouth."""
    k, color = look.between(0.9, 1.08), look.color("black", "silver", "white", "red")
    x, y, h = 0.37 * k, 0.13 * k, 0.05 * k
    low, lid = (
        block(x, y, 0.55 * h, 0.02 * k, 0.004),
        block(0.98 * x, 0.6 * y, 0.5 * h, 0.02 * k, 0.008).move(y=-0.12 * y, z=0.52 * h),
    )
    panel = box(0.4 * x, 0.26 * y, 0.002).move(y=0.33 * y, z=0.55 * h - 0.0006)
    bag = prism(rectangle(0.5 * x, 0.14 * k, 0.004), 0, 0.002).move(y=-y / 2 - 0.055 * k, z=0.001)
    meat = pad(0.36 * x, 0.1 * k, 0.018, 0.02).move(y=-y / 2 - 0.06 * k, z=0.002)
    return shape([(join([low, lid]), look.surface(color, "plastic")), (panel, _panel(look)),
                  (bag, textures.plain((226, 232, 236))), (meat, textures.plain((196, 92, 84)))],
                 [hull_of(low), hull_of(lid), hull_of(meat), hull_of(bag)])  # fmt: skip


def sous_vide(look: Look) -> Shape:
    """A sous vide stick lying: a steel tube with slots, a clip, a round screen at its head."""
    k, color = look.between(0.9, 1.08), look.color("black", "white", "gray", "teal")
    steel = cylinder(0.026, 0.18, 24, bevel=0.003).turn(1, np.pi / 2).move(-0.2, 0, 0.026)
    head = cylinder(0.03, 0.14, 26, bevel=0.008).turn(1, np.pi / 2).move(-0.03, 0, 0.03)
    clip = box(0.05, 0.014, 0.05).move(-0.02, 0.034, 0.004)
    slots = [
        box(0.04, 0.004, 0.003)
        .turn(0, a)
        .move(-0.17, 0.0255 * np.sin(-a), 0.026 + 0.0255 * np.cos(a))
        for a in (-0.8, -0.3, 0.3, 0.8)
    ]
    screen = box(0.05, 0.028, 0.001).move(0.055, 0, 0.0594)
    made = [
        (steel, textures.brushed_metal(look.rng, STEEL)),
        (join([head, clip]), look.surface(color, "plastic")),
        (join(slots), textures.plain((50, 52, 56))),
        (screen, _panel(look)),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    foot = box(0.2, 0.03, 0.02).scale(k, k, k)
    return shape(made, [hull_of(made[0][0], foot), hull_of(made[1][0])])


_K = ("kitchen",)


_B = ("big",)

CATEGORIES = (
    Category("bread_maker", bread_maker, (0.307, 0.211, 0.279), 5.0, ("breadmaker",
        "bread machine", "bread baker"), _K, _B, ("white", "black")),
    Category("contact_grill", _griddle(True, 0.32, 1.3), (0.311, 0.283, 0.217), 2.4,
             ("electric grill", "george foreman grill", "health grill", "panini press",
              "panini grill",
             "panini maker", "grill press"), _K, _B, ("black", "silver")),
    Category("sandwich_toaster", _griddle(False, 0.25, 1.2), (0.254, 0.294, 0.223), 1.5,
             ("toastie maker", "sandwich maker", "sandwich press", "doughnut maker", "donut maker",
             "cake pop maker"), _K, _B, ("black", "silver")),
    Category("raclette_grill", raclette_grill, (0.356, 0.357, 0.0954), 2.2,
             ("raclette maker", "raclette set"), _K, _B, ("black", "red")),
    Category("deep_fryer", deep_fryer, (0.2, 0.345, 0.208), 2.8, ("deep fat fryer", "chip fryer",
        "fryer", "chip pan"), _K, _B, ("silver",)),
    Category("crepe_maker", crepe_maker, (0.348, 0.322, 0.075), 1.3, ("pancake maker",
        "tortilla maker", "crepe pan", "electric crepe maker", "roti maker"), _K, ("big", "round"),
        ("black",)),
    Category("vacuum_sealer", vacuum_sealer, (0.367, 0.253, 0.0505), 1.6,
             ("food sealer", "bag sealer", "vacuum packer"), _K, _B, ("black",)),
    Category("sous_vide", sous_vide, (0.313, 0.0717, 0.061), 0.9, ("sous vide stick",
        "sous vide machine", "immersion circulator", "sous vide cooker"), _K, (), ("black",),
        state="lying"),
)  # fmt: skip
"""The module's categories."""
