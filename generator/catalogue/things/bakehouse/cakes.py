"""Whole cakes and cakes by the piece: sponges, rolls, rings, cheesecake, puddings."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import blade, lobe, speck
from ...build.outlines import arc
from ...build.recipes import ball
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin
from .loaves import crust

CREAM: RGB = (250, 244, 230)
PLATE = textures.plain((240, 240, 238))


def _spiral(roll: RGB, fill: RGB) -> textures.Tile:
    """Return the cut end of a roll: a spiral of sponge and cream."""
    y, x = np.mgrid[-1:1:96j, -1:1:96j]
    turn = (np.hypot(x, y) * 3.2 - np.arctan2(y, x) / (2 * np.pi)) % 1
    image = np.where((turn < 0.3)[..., None], np.array(fill), np.array(roll))
    return image.astype(np.uint8)


def swiss_roll(look: Look) -> Shape:
    """A rolled sponge, the spiral of jam and cream on its cut ends."""
    long, r = look.between(0.15, 0.19), look.between(0.036, 0.042)
    dark = look.chance(0.4)
    tone: RGB = (96, 58, 38) if dark else (232, 190, 116)
    color = look.color("cream", "crimson", "white")
    body = cylinder(r, long, 30).turn(1, np.pi / 2).move(x=-long / 2)
    face = cylinder(0.99 * r, 0.0012, 30).turn(1, np.pi / 2)
    end = _spiral(tone, color)
    return settle([(body, skin(look, tone, tint_color(tone, 0.8), 0.6)),
                   (join([face.move(x=-long / 2 - 0.0006), face.move(x=long / 2 - 0.0006)]), end)],
                  0.06)  # fmt: skip


def yule_log(look: Look) -> Shape:
    """A chocolate log with bark, a stub of a branch, holly and snow of sugar."""
    long, r = look.between(0.2, 0.24), look.between(0.038, 0.045)
    log = cylinder(r, long, 30).turn(1, np.pi / 2).move(x=-long / 2)
    stub = cylinder(0.6 * r, 0.05, 20).turn(1, 1.2).turn(2, 0.7).move(0.02, 0.2 * r, 0.3 * r)
    face = cylinder(0.98 * r, 0.0014, 30).turn(1, np.pi / 2)
    ends = join([face.move(x=-long / 2 - 0.0007), face.move(x=long / 2 - 0.0007)])
    bark = textures.scratches(look.rng, (92, 56, 36), (60, 34, 22), 140)
    sugar = [ellipsoid(0.05, 0.024, 0.01, 12, 6).move(x, 0.004, 0.95 * r) for x in (-0.06, 0.055)]
    leaves = [blade([(-0.01, 0, r), (-0.01 + 0.018 * np.cos(a), 0.018 * np.sin(a), r + 0.008),
                     (-0.01 + 0.036 * np.cos(a), 0.036 * np.sin(a), r + 0.002)], 0.016, thick=0.2)
              for a in (0.3, 2.4)]  # fmt: skip
    red = [ball(0.01, 0.01, 0.01, (-0.01 + x, y, r + 0.006), 10)
           for x, y in ((0, 0.004), (0.007, -0.004), (-0.006, -0.004))]  # fmt: skip
    return settle([(join([log, stub]), bark), (ends, _spiral((96, 58, 38), CREAM)),
                   (join(sugar), textures.plain((250, 250, 248))),
                   (join(leaves), textures.plain((40, 110, 60))),
                   (join(red), textures.plain((204, 30, 36)))], 0.06, hulls=[[0, 1]])  # fmt: skip


def battenberg(look: Look) -> Shape:
    """A pink and yellow chequered cake in marzipan."""
    long, x = look.between(0.12, 0.16), look.between(0.055, 0.065)
    image = prints.canvas(96, 96, (238, 206, 130))
    for i in range(2):
        for j in range(2):
            tone = (236, 150, 160) if (i + j) % 2 else (248, 226, 140)
            prints.fill(image, 0.08 + 0.43 * i, 0.08 + 0.43 * j, 0.41, 0.41, tone)
    body = block(x, long, x, 0.004)
    face = box(0.97 * x, 0.0012, 0.97 * x).move(y=-long / 2, z=0.01 * x)
    rear = face.move(y=long)
    color = look.color("yellow", "cream")
    wrap = textures.speckles(look.rng, tint_color(color, 1.25), 6)
    return shape([(body, wrap), (join([face, rear]), image)],
                 [box_part(x, long, x)])  # fmt: skip


def bundt(look: Look) -> Shape:
    """A fluted ring cake with icing running down it."""
    r, h = look.between(0.1, 0.115), look.between(0.07, 0.085)
    side = [(0.3 * r, 0), (0.96 * r, 0), (r, 0.3 * h), (0.9 * r, 0.72 * h), (0.66 * r, h),
            (0.46 * r, 0.92 * h), (0.32 * r, 0.6 * h)]  # fmt: skip
    ring = lobe(lathe(side, 64, loop=True), 12, 0.09)
    icing = lobe(lathe([(0.4 * r, 0.8 * h), (0.82 * r, 0.8 * h), (0.88 * r, 0.84 * h),
                        (0.68 * r, 1.05 * h), (0.45 * r, 0.97 * h)], 64, loop=True), 12,
                 0.09)  # fmt: skip
    runs = [ball(0.016, 0.016, 0.5 * h, (0.95 * r * np.cos(a), 0.95 * r * np.sin(a), 0.62 * h), 8)
            for a in 2 * np.pi * np.arange(6) / 6]  # fmt: skip
    tone = look.color("white", "brown", "pink", "cream")
    sweet = textures.speckles(look.rng, tone if sum(tone) > 380 else tint_color(tone, 0.7), 4)
    return shape([(ring, crust(look, (120, 66, 30))), (join([icing, *runs]), sweet)],
                 [hull_of(ring, icing)])  # fmt: skip


def victoria(look: Look) -> Shape:
    """Two sponges with jam and cream between, sugar on top."""
    r, h = look.between(0.085, 0.1), look.between(0.03, 0.036)
    low, top = cylinder(r, h, 36, bevel=0.006), cylinder(r, h, 36, bevel=0.006).move(z=h + 0.014)
    jam = cylinder(0.98 * r, 0.006, 36).move(z=h - 0.001)
    cream = [ball(0.022, 0.022, 0.014, (0.93 * r * np.cos(a), 0.93 * r * np.sin(a), h + 0.009), 8)
             for a in 2 * np.pi * np.arange(24) / 24]  # fmt: skip
    bed = cylinder(0.93 * r, 0.011, 30).move(z=h + 0.004)
    dust = cylinder(0.9 * r, 0.0012, 36).move(z=2 * h + 0.0135)
    sponge = skin(look, (226, 174, 96), (188, 124, 56), 0.8)
    berries = [ball(0.026, 0.026, 0.03, (0.02 * np.cos(a), 0.02 * np.sin(a), 2 * h + 0.022), 12)
               for a in (0.4, 2.5, 4.6)]  # fmt: skip
    return shape([(join([low, top]), sponge), (jam, textures.plain((176, 24, 46))),
                  (join([*cream, bed]), textures.plain(CREAM)),
                  (dust, textures.spots(look.rng, (248, 244, 236), (226, 190, 130), 0.15)),
                  (join(berries), textures.plain(look.color("red", "crimson")))],
                 [cylinder_part(r, 2 * h + 0.014), hull_of(*berries)])  # fmt: skip


def cheesecake(look: Look) -> Shape:
    """A slice of cheesecake: a dark crumb base, pale filling, fruit on top."""
    r, h = look.between(0.11, 0.125), look.between(0.045, 0.055)
    edge = arc((0, 0), r, -0.28, 0.28, 8)
    wedge = np.concatenate([[(0.0, 0.0)], edge]) - [0.6 * r, 0]
    base = prism(wedge, 0, 0.2 * h)
    fill = prism(0.985 * wedge, 0.19 * h, 0.88 * h)
    color = look.color("crimson", "red", "indigo", "amber")
    glaze = prism(0.97 * wedge, 0.87 * h, h, 0.002)
    fruit = [ball(0.019, 0.019, 0.016, (x * r, y * r, h + 0.004), 10)
             for x, y in ((0.22, 0.1), (0.24, -0.1), (0.05, 0.0))]  # fmt: skip
    body = join([base, fill, glaze])
    return shape([(base, textures.spots(look.rng, (150, 98, 52), (112, 68, 34), 0.3)),
                  (fill, textures.speckles(look.rng, (250, 238, 200), 4)),
                  (glaze, textures.plain(tint_color(color, 0.9))),
                  (join(fruit), textures.plain(color))],
                 [hull_of(body), hull_of(*fruit)])  # fmt: skip


def pudding(look: Look) -> Shape:
    """A round dark fruit pudding with white sauce and holly, on a plate."""
    r = look.between(0.055, 0.065)
    plate = cylinder(1.45 * r, 0.007, 32, bevel=0.002)
    dome = lathe([(0, 0), (0.8 * r, 0), (r, 0.5 * r), (0.9 * r, 1.05 * r), (0.5 * r, 1.5 * r),
                  (0, 1.6 * r)], 28).move(z=0.006)  # fmt: skip
    cap = lathe([(0, 1.1 * r), (0.88 * r, 1.1 * r), (0.8 * r, 1.28 * r), (0.5 * r, 1.56 * r),
                 (0, 1.66 * r)], 28).move(z=0.006)  # fmt: skip
    runs = [
        ball(0.3 * r, 0.3 * r, s * r, (0.93 * r * np.cos(a), 0.93 * r * np.sin(a), 1.02 * r), 10)
        for a, s in ((0.3, 0.7), (1.8, 0.5), (3.2, 0.8), (4.4, 0.5), (5.4, 0.8))
    ]
    leaves = [blade([(0, 0, 1.66 * r), (0.022 * np.cos(a), 0.022 * np.sin(a), 1.72 * r + 0.008),
                     (0.044 * np.cos(a), 0.044 * np.sin(a), 1.7 * r)], 0.02, thick=0.2)
              for a in (0.4, 2.7)]  # fmt: skip
    red = [ball(0.013, 0.013, 0.013, (x, y, 1.74 * r), 10)
           for x, y in ((0, 0.005), (0.007, -0.005), (-0.007, -0.004))]  # fmt: skip
    fruit = speck(textures.spots(look.rng, (62, 34, 22), (34, 18, 12), 0.3), look.rng,
                  (112, 60, 30), 30, 4)  # fmt: skip
    return shape([(plate, PLATE), (dome, fruit), (join([cap, *runs]), textures.plain(CREAM)),
                  (join(leaves), textures.plain((40, 110, 60))),
                  (join(red), textures.plain((204, 30, 36)))],
                 [cylinder_part(1.45 * r, 0.007), hull_of(dome, cap)])  # fmt: skip


def cake_pop(look: Look) -> Shape:
    """A ball of cake glazed and sprinkled, on a stick, lying."""
    r = look.between(0.018, 0.021)
    color = look.color("pink", "brown", "white", "mint", "sky", "yellow")
    head = ball(2 * r, 2 * r, 2 * r, (0, 0, r), 20)
    stick = tube([(0.6 * r, 0, r), (0.13, 0, 0.0022)], 0.0022, 8)
    dots = []
    for k in range(30):
        up = 1 - 1.5 * (k + 0.5) / 30
        flat = np.sqrt(1 - up * up)
        dots.append(ellipsoid(0.0035, 0.0016, 0.0016, 6, 3).turn(2, k).move(
            1.0 * r * flat * np.cos(2.4 * k), r * flat * np.sin(2.4 * k), r + r * up))  # fmt: skip
    tints = textures.stripes([(230, 60, 90), (250, 210, 60), (60, 160, 220), (250, 250, 250)], 2,
                             upright=True)  # fmt: skip
    return settle([(head, textures.speckles(look.rng, color, 5)),
                   (stick, textures.plain((246, 244, 238))), (join(dots), tints)], 0.1,
                  hulls=[[0], [1]])  # fmt: skip


def meringue(look: Look) -> Shape:
    """A piped swirl of meringue with a peak."""
    r = look.between(0.028, 0.036)
    t = np.linspace(0, 6.6 * np.pi, 70)
    s = t / t[-1]
    away = 0.66 * r * (1 - s) ** 0.8
    path = np.column_stack([away * np.cos(t), away * np.sin(t), 0.3 * r + 1.25 * r * s])
    swirl = tube(path, 0.36 * r * (1 - 0.75 * s), 8)
    core = lathe([(0, 0), (0.8 * r, 0), (0.8 * r, 0.4 * r), (0.2 * r, 1.3 * r), (0, 1.4 * r)], 20)
    color = look.color("white", "white", "pink", "cream")
    return settle([(join([swirl, core]), textures.speckles(look.rng, color, 5))], 0.03)


_T = ("coffee", "tea")
_E = ("edible",)
_L = "lying flat"


CATEGORIES = (
    Category("swiss_roll", swiss_roll, (0.177, 0.0805, 0.0753), 0.25, ("jam roll", "roulade",
             "arctic roll", "jelly roll", "jam roly-poly"), _T, _E, ("cream",), state=_L),
    Category("yule_log", yule_log, (0.222, 0.0995, 0.0891), 0.5, ("chocolate log", "buche de noel",
             "yule log cake", "christmas log"), _T, ("edible", "big"), (), state=_L),
    Category("battenberg", battenberg, (0.0606, 0.141, 0.0606), 0.25, ("battenberg cake",
             "battenburg", "chequered cake"), _T, _E, ("yellow",)),
    Category("bundt_cake", bundt, (0.219, 0.219, 0.0834), 0.7, ("bundt", "ring cake", "gugelhupf",
             "angel food cake", "lemon drizzle cake"), _T, ("edible", "round", "big"), ("white",)),
    vary(Category("victoria_sponge", victoria, (0.189, 0.189, 0.103), 0.6,
             ("victoria sponge cake",
             "sponge cake", "victoria sandwich", "layer cake", "jam sponge"), _T, ("edible",
             "round", "big"), ("red",))),
    Category("cheesecake", cheesecake, (0.115, 0.0637, 0.0625), 0.12, ("slice of cheesecake",
             "cheesecake slice", "piece of cheesecake", "strawberry cheesecake"), _T, _E, ("red",)),
    vary(Category("christmas_pudding", pudding, (0.174, 0.174, 0.112), 0.6, ("plum pudding",
             "xmas pudding", "figgy pudding", "sticky toffee pudding"), _T, ("edible", "round"),
             ())),
    Category("cake_pop", cake_pop, (0.15, 0.0401, 0.0353), 0.03, ("cake lollipop",), _T, _E,
             ("pink",), state=_L),
    Category("meringue", meringue, (0.0619, 0.0576, 0.053), 0.015, ("meringue nest",
             "meringue kiss", "pavlova"), _T, ("edible", "round"), ("white",)),
)  # fmt: skip
"""The module's categories."""
