"""Objects of the ``coffee`` theme: cakes."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import skin
from ...kit.outlines import arc
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import ball, bent_rod, blade, lobe
from ...kit.shapes import Category, Shape, category, settle, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, speck, tint_color
from ..breakfast.breads import crust
from .cookies import biscuit_slab


@category("madeleine", size=(0.071, 0.0469, 0.0172), mass=0.025, material="food",
          aliases=("madeleine cake", "maamoul"), themes=("coffee", "tea"), roles=("edible",),
          state="lying flat")  # fmt: skip
@vary()
def madeleine(look: Look) -> Shape:
    """A small shell-shaped madeleine with its ribs up."""
    k = look.between(0.9, 1.1)
    shell = lobe(lathe([(0, 0), (0.026, 0), (0.024, 0.006), (0.014, 0.015), (0, 0.018)], 64), 22,
                 0.06)  # fmt: skip
    body = shell.scale(1.4, 0.92, 1).bend(lambda p: p * np.column_stack(
        [np.ones(len(p)), 1 - 5.0 * p[:, 0], np.ones(len(p))]))  # fmt: skip
    return shape([(body, skin(look, (232, 184, 104), (176, 108, 48), 0.9))],
                 [hull_of(body)]).scale(k)  # fmt: skip


@category("teacake", size=(0.0604, 0.0608, 0.0351), mass=0.03, material="food",
          aliases=("tea cake", "chocolate teacake", "marshmallow teacake", "chocolate kiss"),
          themes=("coffee", "tea"), roles=("edible", "round"), colors=("brown",))  # fmt: skip
@vary()
def teacake(look: Look) -> Shape:
    """A teacake: a dome of marshmallow on a biscuit, covered with chocolate."""
    r = look.between(0.027, 0.032)
    dome = lathe([(0, 0), (r, 0), (r, 0.2 * r), (0.92 * r, 0.6 * r), (0.6 * r, 1.05 * r),
                  (0, 1.2 * r)], 26)  # fmt: skip
    dark = surfaces.speckles(look.rng, tint_color(look.color("brown", "brown", "white"), 0.6), 5)
    foot = cylinder(1.04 * r, 0.14 * r, 26)
    return shape([(join([dome, foot]), dark)], [hull_of(dome, foot)])


CREAM: RGB = (250, 244, 230)


@category("rum_baba", size=(0.0707, 0.0679, 0.0684), mass=0.08, material="food",
          aliases=("baba", "savarin"), themes=("coffee", "tea"),
          roles=("edible", "round"))  # fmt: skip
@vary()
def rum_baba(look: Look) -> Shape:
    """A ring-shaped or cork-shaped soaked sponge cake with cream on top."""
    r, h = look.between(0.03, 0.036), look.between(0.036, 0.042)
    ring = lobe(lathe([(0, 0), (r, 0), (0.96 * r, 0.7 * h), (0.7 * r, h), (0, 0.9 * h)], 40), 10,
                0.1)  # fmt: skip
    swirl = [ball(s * r, s * r, 0.34 * r, (0, 0, h + 0.18 * r * n), 14)
             for n, s in enumerate((1.1, 0.8, 0.45))]  # fmt: skip
    cherry = ball(0.3 * r, 0.3 * r, 0.3 * r, (0, 0, h + 0.72 * r), 10)
    return shape([(ring, skin(look, (206, 138, 62), (156, 90, 36), 0.8)),
                  (join(swirl), surfaces.plain(CREAM)), (cherry, surfaces.plain((190, 24, 40)))],
                 [hull_of(ring), hull_of(*swirl)])  # fmt: skip


YULE_LOG_CREAM: RGB = (250, 244, 230)
PLATE = surfaces.plain((240, 240, 238))


def _spiral(roll: RGB, fill: RGB) -> surfaces.Tile:
    """Return the cut end of a roll: a spiral of sponge cake and cream."""
    y, x = np.mgrid[-1:1:96j, -1:1:96j]
    turn = (np.hypot(x, y) * 3.2 - np.arctan2(y, x) / (2 * np.pi)) % 1
    image = np.where((turn < 0.3)[..., None], np.array(fill), np.array(roll))
    return image.astype(np.uint8)


@category("swiss_roll", size=(0.177, 0.0805, 0.0753), mass=0.25, material="food",
          aliases=("jam roll", "roulade", "arctic roll", "jelly roll", "jam roly-poly"),
          themes=("coffee", "tea"), roles=("edible",), colors=("cream",),
          state="lying flat")  # fmt: skip
def swiss_roll(look: Look) -> Shape:
    """A Swiss roll with a spiral of jam and cream on its cut ends."""
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


@category("yule_log", size=(0.222, 0.0995, 0.0891), mass=0.5, material="food",
          aliases=("chocolate log", "buche de noel", "yule log cake", "christmas log"),
          themes=("coffee", "tea"), roles=("edible", "big"), state="lying flat")  # fmt: skip
def yule_log(look: Look) -> Shape:
    """A chocolate yule log with bark, the stub of a branch, holly and icing sugar."""
    long, r = look.between(0.2, 0.24), look.between(0.038, 0.045)
    log = cylinder(r, long, 30).turn(1, np.pi / 2).move(x=-long / 2)
    stub = cylinder(0.6 * r, 0.05, 20).turn(1, 1.2).turn(2, 0.7).move(0.02, 0.2 * r, 0.3 * r)
    face = cylinder(0.98 * r, 0.0014, 30).turn(1, np.pi / 2)
    ends = join([face.move(x=-long / 2 - 0.0007), face.move(x=long / 2 - 0.0007)])
    bark = surfaces.scratches(look.rng, (92, 56, 36), (60, 34, 22), 140)
    sugar = [ellipsoid(0.05, 0.024, 0.01, 12, 6).move(x, 0.004, 0.95 * r) for x in (-0.06, 0.055)]
    leaves = [blade([(-0.01, 0, r), (-0.01 + 0.018 * np.cos(a), 0.018 * np.sin(a), r + 0.008),
                     (-0.01 + 0.036 * np.cos(a), 0.036 * np.sin(a), r + 0.002)], 0.016, thick=0.2)
              for a in (0.3, 2.4)]  # fmt: skip
    red = [ball(0.01, 0.01, 0.01, (-0.01 + x, y, r + 0.006), 10)
           for x, y in ((0, 0.004), (0.007, -0.004), (-0.006, -0.004))]  # fmt: skip
    return settle([(join([log, stub]), bark), (ends, _spiral((96, 58, 38), YULE_LOG_CREAM)),
                   (join(sugar), surfaces.plain((250, 250, 248))),
                   (join(leaves), surfaces.plain((40, 110, 60))),
                   (join(red), surfaces.plain((204, 30, 36)))], 0.06, hulls=[[0, 1]])  # fmt: skip


@category("battenberg", size=(0.0606, 0.141, 0.0606), mass=0.25, material="food",
          aliases=("battenberg cake", "battenburg", "chequered cake"), themes=("coffee", "tea"),
          roles=("edible",), colors=("yellow",))  # fmt: skip
def battenberg(look: Look) -> Shape:
    """A pink and yellow chequered cake covered with marzipan."""
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
    wrap = surfaces.speckles(look.rng, tint_color(color, 1.25), 6)
    return shape([(body, wrap), (join([face, rear]), image)],
                 [box_part(x, long, x)])  # fmt: skip


@category("bundt_cake", size=(0.219, 0.219, 0.0834), mass=0.7, material="food",
          aliases=("bundt", "ring cake", "gugelhupf", "angel food cake", "lemon drizzle cake"),
          themes=("coffee", "tea"), roles=("edible", "round", "big"),
          colors=("white",))  # fmt: skip
def bundt_cake(look: Look) -> Shape:
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
    sweet = surfaces.speckles(look.rng, tone if sum(tone) > 380 else tint_color(tone, 0.7), 4)
    return shape([(ring, crust(look, (120, 66, 30))), (join([icing, *runs]), sweet)],
                 [hull_of(ring, icing)])  # fmt: skip


@category("victoria_sponge", size=(0.189, 0.189, 0.103), mass=0.6, material="food",
          aliases=("victoria sponge cake", "sponge cake", "victoria sandwich", "layer cake",
          "jam sponge"), themes=("coffee", "tea"), roles=("edible", "round", "big"),
          colors=("red",))  # fmt: skip
@vary()
def victoria_sponge(look: Look) -> Shape:
    """Two layers of sponge cake filled with jam and cream, dusted with sugar."""
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
    return shape([(join([low, top]), sponge), (jam, surfaces.plain((176, 24, 46))),
                  (join([*cream, bed]), surfaces.plain(YULE_LOG_CREAM)),
                  (dust, surfaces.spots(look.rng, (248, 244, 236), (226, 190, 130), 0.15)),
                  (join(berries), surfaces.plain(look.color("red", "crimson")))],
                 [cylinder_part(r, 2 * h + 0.014), hull_of(*berries)])  # fmt: skip


@category("cheesecake", size=(0.115, 0.0637, 0.0625), mass=0.12, material="food",
          aliases=("slice of cheesecake", "cheesecake slice", "piece of cheesecake",
          "strawberry cheesecake"), themes=("coffee", "tea"), roles=("edible",),
          colors=("red",))  # fmt: skip
def cheesecake(look: Look) -> Shape:
    """A slice of cheesecake with a dark crumb base, a pale filling and fruit on top."""
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
    return shape([(base, surfaces.spots(look.rng, (150, 98, 52), (112, 68, 34), 0.3)),
                  (fill, surfaces.speckles(look.rng, (250, 238, 200), 4)),
                  (glaze, surfaces.plain(tint_color(color, 0.9))),
                  (join(fruit), surfaces.plain(color))],
                 [hull_of(body), hull_of(*fruit)])  # fmt: skip


@category("christmas_pudding", size=(0.174, 0.174, 0.112), mass=0.6, material="food",
          aliases=("plum pudding", "xmas pudding", "figgy pudding", "sticky toffee pudding"),
          themes=("coffee", "tea"), roles=("edible", "round"))  # fmt: skip
@vary()
def christmas_pudding(look: Look) -> Shape:
    """A round, dark Christmas pudding with white sauce and holly on a plate."""
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
    fruit = speck(surfaces.spots(look.rng, (62, 34, 22), (34, 18, 12), 0.3), look.rng,
                  (112, 60, 30), 30, 4)  # fmt: skip
    return shape([(plate, PLATE), (dome, fruit),
                  (join([cap, *runs]), surfaces.plain(YULE_LOG_CREAM)),
                  (join(leaves), surfaces.plain((40, 110, 60))),
                  (join(red), surfaces.plain((204, 30, 36)))], [cylinder_part(1.45 * r, 0.007),
                                                                hull_of(dome, cap)])  # fmt: skip


@category("cake_pop", size=(0.15, 0.0401, 0.0353), mass=0.03, material="food", assembled=True,
          aliases=("cake lollipop",), themes=("coffee", "tea"), roles=("edible",), colors=("pink",),
          state="lying flat")  # fmt: skip
def cake_pop(look: Look) -> Shape:
    """A glazed ball of cake with sprinkles on a stick, lying flat."""
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
    tints = surfaces.stripes([(230, 60, 90), (250, 210, 60), (60, 160, 220), (250, 250, 250)], 2,
                             upright=True)  # fmt: skip
    return settle([(head, surfaces.speckles(look.rng, color, 5)),
                   (stick, surfaces.plain((246, 244, 238))), (join(dots), tints)], 0.1,
                  hulls=[[0], [1]])  # fmt: skip


@category("stollen", size=(0.237, 0.0951, 0.0661), mass=0.6, material="food",
          aliases=("christmas stollen", "stollen cake", "christstollen"), themes=("coffee",),
          roles=("edible", "big"), colors=("white",), state="lying flat")  # fmt: skip
def stollen(look: Look) -> Shape:
    """A folded fruit loaf covered with icing sugar, with one slice cut off."""
    long, r = look.between(0.19, 0.24), look.between(0.045, 0.052)
    body = bent_rod(long, r, blunt=5, squash=0.72)
    fold = bent_rod(0.92 * long, 0.62 * r, blunt=5, squash=0.7).move(y=-0.3 * r, z=0.42 * r)
    face = cylinder(0.8 * r, 0.014, 26).turn(1, np.pi / 2).scale(1, 1.1, 0.72).move(x=0.56 * long)
    sugar = surfaces.spots(look.rng, look.color("white", "white"), (226, 190, 140), 0.1)
    crumb = surfaces.spots(look.rng, (232, 198, 138), (110, 50, 40), 0.1)
    return settle([(join([body, fold]), sugar), (face, crumb)], 0.1, hulls=[[0], [1]])


@category("muffin", size=(0.0855, 0.0855, 0.0682), mass=0.1, material="food",
          aliases=("blueberry muffin", "chocolate muffin"), themes=("coffee",),
          roles=("edible", "round"), colors=("white", "brown"))  # fmt: skip
def muffin(look: Look) -> Shape:
    """A muffin with blueberries or chocolate in a pleated paper case."""
    r, h = look.between(0.032, 0.037), look.between(0.062, 0.074)
    case = lobe(lathe([(0, 0), (0.72 * r, 0), (r, 0.5 * h), (0, 0.5 * h)], 60), 30, 0.07)
    dome = lathe([(0, 0.46 * h), (1.06 * r, 0.47 * h), (1.24 * r, 0.6 * h), (1.1 * r, 0.8 * h),
                  (0.62 * r, 0.96 * h), (0, h)], 28)  # fmt: skip
    tone: RGB = look.pick([(216, 158, 84), (206, 146, 76), (92, 54, 36)])
    dots = (52, 46, 92) if sum(tone) > 300 else (48, 28, 20)
    crumb = speck(skin(look, tone, tint_color(tone, 0.75)), look.rng, dots, 30, 6)
    paper = look.color("white", "brown", "cream", "pink", "sky", "red")
    return shape([(case, surfaces.speckles(look.rng, paper, 5)), (dome, crumb)],
                 [hull_of(case), hull_of(dome)])  # fmt: skip


@category("brownie", size=(0.0612, 0.0612, 0.0325), mass=0.08, material="food",
          aliases=("chocolate brownie", "brownie square"), themes=("coffee",),
          roles=("edible",))  # fmt: skip
def brownie(look: Look) -> Shape:
    """A square brownie with a crackled top and walnuts."""
    x, h = look.between(0.055, 0.068), look.between(0.028, 0.034)
    dark = surfaces.spots(look.rng, (66, 38, 26), (40, 22, 16), 0.2)
    top = speck(surfaces.spots(look.rng, (104, 64, 42), (60, 34, 24), 0.25), look.rng,
                (206, 160, 106), 7, 9)  # fmt: skip
    return shape([(block(x, x, h, 0.004, 0.001), dark),
                  (block(x, x, 0.003, 0.004, 0.001).move(z=h - 0.0015), top)],
                 [box_part(x, x, h + 0.0015)])  # fmt: skip


def _wedge(r: float, angle: float, low: float, high: float) -> Solid:
    """Return a slice of a round object with its tip pointing to the front."""
    a = np.linspace(np.pi / 2 - angle / 2, np.pi / 2 + angle / 2, 9)
    outline = np.concatenate([[(0, 0)], np.column_stack([r * np.cos(a), r * np.sin(a)])])
    return prism(outline - [0, 0.55 * r], low, high)


@category("cake_slice", size=(0.0862, 0.111, 0.0989), mass=0.12, material="food",
          aliases=("slice of cake", "piece of cake", "cake piece", "slice of chocolate cake"),
          themes=("coffee",), roles=("edible",), colors=("brown", "pink"))  # fmt: skip
def cake_slice(look: Look) -> Shape:
    """A slice of layer cake, topped with cream and a berry, with its tip pointing to the front."""
    r, angle, h = look.between(0.095, 0.115), look.between(0.7, 0.9), look.between(0.06, 0.075)
    tone = look.color("brown", "cream", "pink", "yellow", "white")
    sponge = surfaces.spots(look.rng, look.pick([(226, 184, 118), (110, 68, 44), (170, 44, 46)]),
                            (150, 104, 60), 0.1)  # fmt: skip
    icing = surfaces.speckles(look.rng, tone, 5)
    side = surfaces.stack((sponge, 3), (icing, 1), (sponge, 3), (icing, 1.4), side=96)
    body = _wedge(r, angle, 0, h)
    top = _wedge(1.02 * r, 1.02 * angle, h - 0.001, h + 0.006)
    blob = lathe([(0, 0), (0.012, 0), (0.013, 0.005), (0.006, 0.011), (0, 0.016)], 20)
    berry = ellipsoid(0.019, 0.019, 0.018, 14, 8)
    spot = (0, 0.25 * r, h + 0.0055)
    pieces = [(body, side), (top, icing), (blob.move(*spot), surfaces.plain((252, 250, 244))),
              (berry.move(0, 0.25 * r, h + 0.024), surfaces.plain((200, 36, 44)))]  # fmt: skip
    return shape(pieces, [hull_of(body, top), hull_of(blob.move(*spot), pieces[3][0])])


@category("cupcake", size=(0.07, 0.07, 0.088), mass=0.07, material="food",
          themes=("coffee", "dining"), roles=("edible", "round"), colors=("pink", "teal"),
          common=True)  # fmt: skip
def cupcake(look: Look) -> Shape:
    """A cupcake in a paper case with a cherry on top."""
    case = look.color("pink", "teal", "white", "mustard", "violet")
    pleats = surfaces.stripes([case, tint_color(case, 0.8)], 18, upright=True)
    cream = surfaces.speckles(
        look.rng, look.own_color("white", "pink", "cream", "brown", "mint"), 5
    )
    cup = cylinder(0.024, 0.036, 24, top=0.033)
    tiers = [ellipsoid(2 * r, 2 * r, 0.026, 20, 8).move(z=z) for r,
             z in ((0.035, 0.041), (0.026, 0.054), (0.016, 0.066))]  # fmt: skip
    cherry = ellipsoid(0.014, 0.014, 0.014, 12, 8).move(z=0.081)
    return shape([(cup, pleats), (join(tiers), cream), (cherry, surfaces.plain((190, 30, 44)))],
                 [hull_of(cup), hull_of(*tiers), hull_of(cherry)])  # fmt: skip


CATEGORIES = (
    Category("blondie",
             biscuit_slab((228, 184, 116), (112, 66, 38), 16, 7, (), (0.062, 0.062, 0.03)),
             size=(0.0636, 0.0636, 0.0308), mass=0.07, material="food",
             aliases=("blondie square", "traybake square", "blondies"), themes=("coffee", "tea"),
             roles=("edible",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
