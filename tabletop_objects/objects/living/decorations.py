"""Objects of the ``living`` theme: decorations."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, metal, steel, wood
from ...kit.outlines import ellipse, smooth
from ...kit.parts import (
    above,
    box_part,
    cylinder_part,
    flat_foot,
    hull_above,
    hull_of,
    hull_part,
    open_vessel,
    ring_parts,
)
from ...kit.primitives import (
    at_box,
    ball,
    disc,
    drum,
    limb,
    lobe,
    pad,
    plate,
    rod,
    side_view,
    spindle,
    standing,
    standing_plate,
    straight,
)
from ...kit.shapes import (
    Category,
    Drawing,
    Pieces,
    Shape,
    category,
    from_pieces,
    put_down,
    settle,
    shape,
    vary,
)
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    refine,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color
from .figurines import person

GAY: tuple[RGB, ...] = ((226, 52, 60), (250, 200, 50), (60, 160, 84), (50, 120, 210),
                        (240, 120, 40), (220, 80, 160))  # fmt: skip


def _winding(long: float, wide: float, turns: float, count: int) -> np.ndarray:
    """Return ``count`` points of a path on the table that winds along x."""
    t = np.linspace(0, 1, count)
    return np.column_stack([long * (t - 0.5), wide * np.sin(2 * np.pi * turns * t), 0 * t])


@category("tinsel", size=(0.319, 0.121, 0.026), mass=0.03, material="paper", assembled=True,
          aliases=("string of tinsel", "tinsel garland", "piece of tinsel", "length of tinsel",
          "christmas garland"), themes=("living",), colors=("silver", "gold"),
          state="lying flat")  # fmt: skip
def tinsel(look: Look) -> Shape:
    """A length of glittering tinsel winding over the table."""
    k = look.between(0.9, 1.1)
    color = look.color("silver", "gold", "red", "green", "blue", "purple")
    path = _winding(0.3, 0.045, 1.6, 60)
    core = tube(path + np.array([0, 0, 0.012]), 0.004, 5)
    spikes = []
    for n in range(170):
        at = path[int(n * 59 / 169)] + [0, 0, 0.012]
        a, b = look.rng.uniform(0, 6.28), look.rng.uniform(-0.5, 1)
        way = 0.017 * np.array([np.cos(a) * np.sqrt(1 - b * b), np.sin(a) * np.sqrt(1 - b * b), b])
        tip = at + way
        spikes.append(tube([at, [tip[0], tip[1], max(tip[2], 0.0005)]], [0.0022, 0.0009], 3))
    shine = surfaces.stripes([tint_color(color, 1.4), color, tint_color(color, 0.65)], 8)
    body = join([core, *spikes])
    return shape([(body, shine)], [hull_above(*spikes[n : n + 34]) for n in range(0, 170, 34)]
                 ).scale(k)  # fmt: skip


def _flag(look: Look, tone: RGB, letter: str) -> surfaces.Tile:
    image = prints.canvas(48, 56, tone)
    if letter:
        prints.disc(image, 0.5, 0.38, 0.26, (250, 248, 240))
        prints.write(image, letter, 0.5, 0.38, 0.34, tint_color(tone, 0.7), bold=True)
    else:
        prints.disc(image, 0.35, 0.25, 0.06, tint_color(tone, 1.6))
        prints.disc(image, 0.65, 0.25, 0.06, tint_color(tone, 1.6))
        prints.disc(image, 0.5, 0.5, 0.06, tint_color(tone, 1.6))
    return image


def bunting(word: str, cut: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a string of triangular or lettered flags, lying in an arc."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        color = look.color("white", "cream", "red", "blue", "pink")
        own = "color" in look.attributes
        count = len(word) if word else 7
        pieces: list[tuple[Solid, surfaces.Tile]] = []
        cord = []
        for n in range(count):
            a = (n - (count - 1) / 2) * 0.34
            at = np.array([0.3 * np.sin(a), 0.3 * np.cos(a) - 0.26])
            outline = [(-0.024, 0), (0, -0.058), (0.024, 0)] if cut else [(-0.022, 0),
                       (-0.022, -0.046), (0.0, -0.056), (0.022, -0.046), (0.022, 0)]  # fmt: skip
            flag = prism(1.35 * np.array(outline), 0, 0.0014)
            face = prism(1.35 * (np.array(outline) * 0.98 - [0, 0.0005]), 0.0012, 0.0018)
            tone = tint_color(color, 1 - 0.09 * (n % 3)) if own else GAY[n % 6]
            turned = [s.turn(2, -a).move(at[0], at[1], 0) for s in (flag, face)]
            face_tile = _flag(look, tone, word[n] if word else "")
            pieces += [(turned[0], surfaces.plain(tone)), (turned[1], face_tile)]
            cord.append((at[0], at[1], 0.0022))
        ends = [(cord[0][0] - 0.03, cord[0][1] - 0.02, 0.0018), *cord,
                (cord[-1][0] + 0.03, cord[-1][1] - 0.02, 0.0018)]  # fmt: skip
        string = tube(smooth(ends, 4), 0.0018, 6)
        pieces.append((string, surfaces.plain(color)))
        flags = [s for s, _ in pieces[:-1]]
        half = len(flags) // 2 // 2 * 2
        return shape(
            pieces, [hull_of(*flags[: half // 2 * 2]), hull_of(*flags[half // 2 * 2 :])]
        ).scale(k)

    return make


@category("snowflake", size=(0.0992, 0.109, 0.00486), mass=0.01, material="paper", assembled=True,
          aliases=("snowflake ornament", "paper snowflake", "snowflake decoration",
          "wooden snowflake"), themes=("living",), roles=("flat",), colors=("white",),
          state="lying flat")  # fmt: skip
def snowflake(look: Look) -> Shape:
    """A six-armed snowflake with a loop for hanging, lying flat."""
    k = look.between(0.85, 1.2)
    color = look.color("white", "silver", "sky", "white", "gold")
    arms = []
    for n in range(6):
        a = np.pi / 3 * n
        way, side = np.array([np.cos(a), np.sin(a)]), np.array([-np.sin(a), np.cos(a)])

        def rod_(p: np.ndarray, q: np.ndarray, wide: float = 0.0026) -> Solid:
            return tube([(*p, 0.0025), (*q, 0.0025)], wide, 6)

        arms.append(rod_(0 * way, 0.046 * way))
        for d, reach in ((0.018, 0.011), (0.031, 0.014)):
            arms += [rod_(d * way, (d + 0.6 * reach) * way + s * reach * side, 0.0021)
                     for s in (-1, 1)]  # fmt: skip
    loop = torus(0.006, 0.001, 16, 6).move(0, 0.052, 0.0015)
    glitter = surfaces.spots(look.rng, color, (255, 255, 255), 0.2)
    return put_down([(join([*arms, loop]), glitter)], factor=k)


@category("icicle", size=(0.155, 0.0215, 0.0174), mass=0.02, material="glass",
          aliases=("icicle ornament", "glass icicle", "icicle decoration"), themes=("living",),
          colors=("clear",), state="lying flat")  # fmt: skip
def icicle(look: Look) -> Shape:
    """A twisted glass icicle with a gold cap and a loop, lying flat."""
    k = look.between(0.85, 1.15)
    color = look.color("clear", "sky", "silver", "white")
    t = np.linspace(0, 1, 40)
    strands = [tube(np.column_stack([0.13 * t - 0.065, 0.0045 * (1 - 0.8 * t) * np.cos(16 * t + a),
                                     0.0045 * (1 - 0.8 * t) * np.sin(16 * t + a)]),
                    0.0062 * (1 - 0.86 * t), 7) for a in (0, np.pi)]  # fmt: skip
    cap = cylinder(0.009, 0.01, 16).turn(1, np.pi / 2).move(x=-0.072)
    loop = torus(0.006, 0.001, 16, 6).move(x=-0.078)
    return settle([(join(strands), surfaces.gradient(color, tint_color(color, 1.4), look.rng)),
                   (join([cap, loop]), surfaces.plain((214, 176, 90)))], 0.12).scale(k)  # fmt: skip


@category("sleigh", size=(0.149, 0.0513, 0.0698), mass=0.1, material="plastic", assembled=True,
          aliases=("sleigh ornament", "mini sled", "toy sleigh", "sled", "santa's sleigh",
          "toy sled", "sledge"), themes=("living",), colors=("red",))  # fmt: skip
def sleigh(look: Look) -> Shape:
    """A small sleigh on curved runners with a sack of presents."""
    k = look.between(0.85, 1.15)
    color = look.color("red", "red", "green", "wooden", "gold")
    side = smooth(np.array([(-0.06, 0.02), (0.035, 0.02), (0.06, 0.034), (0.066, 0.056),
                            (0.05, 0.05), (0.03, 0.042), (-0.02, 0.044), (-0.045, 0.07),
                            (-0.066, 0.072), (-0.06, 0.02)]), 3)[:-1]  # fmt: skip
    walls = [standing_plate(side, 0.004).move(y=s * 0.026) for s in (-1, 1)]
    seat = box(0.1, 0.05, 0.004).move(-0.01, 0, 0.019)
    back = box(0.004, 0.052, 0.048).turn(1, -0.12).move(-0.06, 0, 0.022)
    front = box(0.004, 0.052, 0.024).turn(1, 0.4).move(0.054, 0, 0.024)
    runners = [limb([(-0.075, s * 0.022, 0.004), (0.05, s * 0.022, 0.004),
                     (0.082, s * 0.022, 0.016), (0.082, s * 0.022, 0.034),
                     (0.07, s * 0.022, 0.038)], [0.0032] * 5, 7) for s in (-1, 1)]  # fmt: skip
    posts = [tube([(x, s * 0.022, 0.004), (x, s * 0.022, 0.022)], 0.0025, 6) for s in (-1, 1)
             for x in (-0.045, 0.03)]  # fmt: skip
    sack = ellipsoid(0.056, 0.044, 0.05, 16, 8).move(-0.022, 0, 0.046)
    gifts = [block(0.022, 0.022, 0.022, 0.001).turn(2, 0.4).move(0.024, s * 0.01, 0.023)
             for s in (-1, 1)]  # fmt: skip
    gold = surfaces.plain((214, 176, 90))
    body = join([*walls, seat, back, front])
    return shape(
        [
            (body, look.surface(color, "plastic")),
            (join([*runners, *posts]), gold),
            (sack, surfaces.fabric(look.rng, (128, 92, 60))),
            (join(gifts), surfaces.plain((60, 130, 90))),
        ],
        [hull_of(*runners, *posts), hull_of(body), hull_of(sack, *gifts)],
    ).scale(k)


@category("evil_eye", size=(0.0438, 0.0981, 0.008), mass=0.015, material="glass", assembled=True,
          aliases=("evil eye charm", "nazar", "evil eye bead", "evil eye amulet", "nazar amulet"),
          themes=("living",), roles=("flat",), colors=("navy",), state="lying flat")  # fmt: skip
def evil_eye(look: Look) -> Shape:
    """An evil-eye charm: rings of blue, white and black glass with a loop."""
    r = look.between(0.018, 0.026)
    color = look.color("navy", "blue", "blue")
    rings = [(r, 0.006, color), (0.64 * r, 0.0068, (250, 250, 250)), (0.44 * r, 0.0074,
             (90, 180, 226)), (0.24 * r, 0.008, (20, 20, 26))]  # fmt: skip
    pieces = [(cylinder(a, h, 26, bevel=0.0008), surfaces.plain(tone)) for a, h, tone in rings]
    loop = torus(0.004, 0.001, 14, 6).move(0, 1.16 * r, 0.002)
    cord = limb([(0, 1.16 * r, 0.002), (0.004, 1.16 * r + 0.03, 0.0016), (-0.003, 1.16 * r + 0.05,
                0.0016)], [0.0012] * 3, 5)  # fmt: skip
    pieces.append((join([loop, cord]), surfaces.plain((50, 80, 150))))
    return shape(pieces, [cylinder_part(r, 0.008), hull_of(loop, cord)])


SKIN: RGB = (232, 192, 158)


@category("christmas_pyramid", size=(0.155, 0.155, 0.204), mass=0.4, material="wood",
          assembled=True,
          aliases=("candle pyramid", "wooden christmas pyramid", "german christmas pyramid"),
          themes=("living",), roles=("tall",), colors=("wooden",))  # fmt: skip
def christmas_pyramid(look: Look) -> Shape:
    """A wooden Christmas pyramid with two decks of figures, candles and a fan on top."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "wooden", "red", "green")
    base = prism(ellipse(0.17, 0.17, 8, np.pi / 8), 0, 0.012)
    decks = [cylinder(0.055, 0.005, 28).move(z=0.03), cylinder(0.038, 0.005, 28).move(z=0.1)]
    pole = straight((0, 0, 0.01), (0, 0, 0.2), 0.003)
    legs = [rod([(0.07 * np.cos(a), 0.07 * np.sin(a), 0.01), (0.064 * np.cos(a), 0.064 * np.sin(a),
                0.1), (0.012 * np.cos(a), 0.012 * np.sin(a), 0.172)], 0.004, 7)
            for a in (0.785, 2.356, 3.927, 5.498)]  # fmt: skip
    blades = []
    for n in range(10):
        blade = box(0.06, 0.024, 0.0018).move(x=0.045).turn(0, 0.45).turn(2, 2 * np.pi * n / 10)
        blades.append(blade.move(z=0.2))
    hub = cylinder(0.015, 0.012, 18).move(z=0.194)
    tips = [cylinder(0.0055, 0.026, 12).move(0.072 * np.cos(a), 0.072 * np.sin(a), 0.012)
            for a in (0, 1.571, 3.142, 4.712)]  # fmt: skip
    flames = [ball(0.006, 0.006, 0.012, (0.072 * np.cos(a), 0.072 * np.sin(a), 0.044), 8)
              for a in (0, 1.571, 3.142, 4.712)]  # fmt: skip
    people = []
    for n in range(4):
        a = 1.571 * n + 0.4
        people += [*person(0.036 * np.cos(a), 0.036 * np.sin(a), 0.04, 0.034)]
        people += [*person(0.022 * np.cos(a), 0.022 * np.sin(a), 0.032, 0.104)]
    wood = look.surface(color, "wood")
    pale = surfaces.wood(look.rng, (226, 190, 136))
    frame = join([base, *decks, *legs, pole])
    return shape(
        [
            (frame, wood),
            (join([*blades, hub]), pale),
            (join(people[::2]), surfaces.stripes([(180, 50, 50), (60, 110, 70)], 1, upright=True)),
            (join(people[1::2]), surfaces.plain(SKIN)),
            (join(tips), surfaces.plain((248, 240, 216))),
            (join(flames), surfaces.plain((252, 196, 60))),
        ],
        [hull_of(base), hull_of(*legs), hull_of(*blades, hub), hull_of(*tips)],
    ).scale(k)


@category("tabletop_fountain", size=(0.184, 0.184, 0.18), mass=1.5, material="ceramic",
          aliases=("water fountain", "fountain", "table fountain", "indoor fountain",
          "desk fountain"), themes=("living",), roles=("big",), colors=("gray",))  # fmt: skip
@from_pieces(bodies=7)
def tabletop_fountain(look: Look) -> Pieces:
    """A table-top fountain: stepped bowls with running water, and pebbles."""
    stone = look.surface(look.color("gray", "charcoal", "terracotta", "beige"), "stoneware")
    base = standing((0.07, 0), (0.09, 0.012), (0.092, 0.04), (0.084, 0.04), (0.08, 0.026), sides=30)
    water = [disc(0.081, 0.004, (0, 0, 0.028))]
    pieces: Pieces = [(base, stone)]
    tops = []
    for k, (x, y, z, r) in enumerate(
        ((0.025, 0.02, 0.075, 0.04), (-0.025, 0.01, 0.115, 0.034), (0.008, 0.025, 0.155, 0.028))
    ):
        stem = disc(0.014, z - 0.026, (x, y, 0.026), top=0.01)
        dish = standing(
            (0.3 * r, 0), (0.9 * r, 0.012), (r, 0.024), (0.9 * r, 0.024), (0.84 * r, 0.016)
        ).move(x, y, z)
        pieces += [(stem, stone), (dish, stone)]
        tops.append(disc(0.84 * r, 0.004, (x, y, z + 0.017)))
        drop = z - (0.04 if k else 0.045)
        tops.append(rod([(x, y - 0.95 * r, z + 0.02), (x, y - 1.1 * r, z + 0.008),
                         (x, y - 1.12 * r, drop)], 0.004, 8))  # fmt: skip
    rocks = [ball(0.022, 0.018, 0.014, (0.06 * np.cos(a), 0.06 * np.sin(a), 0.034), 8)
             for a in np.arange(7) * 0.9]  # fmt: skip
    return [*pieces, (join([*water, *tops]), surfaces.plain((150, 204, 226))),
            (join(rocks), dye(look, "beige", "white", "gray"))]  # fmt: skip


def _table_flag_flag() -> Drawing:
    def draw(look: Look) -> Pieces:
        """A small flag on a pole in a round base."""
        tones = [look.color(*PAINTS, "white"), look.own_color("white", "yellow"),
                 look.own_color(*PAINTS)]  # fmt: skip
        cloth = surfaces.stripes(tones, 1, upright=look.chance(0.5))
        foot = disc(0.03, 0.012, sides=28)
        pole = straight((0, 0, 0.01), (0, 0, 0.24), 0.0022, 8)
        tip = ball(0.008, 0.008, 0.008, (0, 0, 0.242), 10)
        x = np.linspace(0.001, 0.12, 14)
        wave = 0.005 * np.sin(x * 90)
        front = np.column_stack([x, wave - 0.0006])
        rear = np.column_stack([x, wave + 0.0006])[::-1]
        banner = prism(np.concatenate([front, rear]), 0.155, 0.232)
        image = surfaces.fit(cloth, 64, 64)
        uv = np.column_stack(
            [(banner.vertices[:, 0] - x[0]) / np.ptp(x), (banner.vertices[:, 2] - 0.155) / 0.077]
        )
        banner = Solid(banner.vertices, banner.faces, np.clip(uv, 0, 1))
        return [(foot, dye(look, "black", "wooden", "gold")), (pole, dye(look, "gold", "silver",
                                                                         "wooden")),
                (banner, image), (tip, dye(look, "gold"))]  # fmt: skip

    return draw


@category("pirate_flag", size=(0.181, 0.25, 0.00769), mass=0.03, material="wood",
          aliases=("jolly roger", "skull and crossbones flag"), themes=("living",), roles=("flat",),
          colors=("brown",))  # fmt: skip
@from_pieces(foot=0.1)
def pirate_flag(look: Look) -> Pieces:
    """A pirate flag lying flat with its pole on the left: a white skull and crossbones on black."""
    image = prints.canvas(96, 64, (26, 26, 28))
    prints.disc(image, 0.5, 0.4, 0.2, (244, 242, 236))
    prints.fill(image, 0.43, 0.5, 0.14, 0.16, (244, 242, 236))
    for s in (-1, 1):
        prints.disc(image, 0.5 + 0.055 * s, 0.4, 0.05, (26, 26, 28))
        prints.stroke(image, [(0.5 - 0.24 * s, 0.68), (0.5 + 0.24 * s, 0.9)], 0.06, (244, 242, 236))
    pole = spindle((-0.15, 0.004), (0.11, 0.004)).turn(2, np.pi / 2)
    return [
        (pole.move(x=-0.1), wood(look, "brown", "wooden")),
        (at_box(0.18, 0.12, 0.0014, (-0.006, 0.046, 0.0)), image),
    ]


GOLD = (222, 180, 80)


def star_outline(r: float, inner: float = 0.42, points: int = 5) -> np.ndarray:
    """Return the counter-clockwise outline of a star with one point up."""
    a = np.pi / 2 + np.pi * np.arange(2 * points) / points
    away = np.where(np.arange(2 * points) % 2 == 0, r, inner * r)
    return np.column_stack([away * np.cos(a), away * np.sin(a)])


@category("christmas_tree", size=(0.155, 0.155, 0.275), mass=0.4, material="plastic",
          assembled=True, aliases=("xmas tree", "mini christmas tree", "fir tree",
          "tabletop christmas tree", "small christmas tree"), themes=("living",), roles=("tall",),
          colors=("green",))  # fmt: skip
def christmas_tree(look: Look) -> Shape:
    """A small Christmas tree in a pot, with baubles and a star."""
    color = look.color("green", "green", "teal", "white", "olive")
    h = look.between(0.2, 0.26)
    tiers: list[Solid] = []
    for k in range(4):
        r = 0.078 * (1 - 0.2 * k)
        z = 0.045 + 0.2 * (h - 0.05) * k
        n = 22
        ring = np.where(np.arange(n) % 2 == 0, 1.0, 0.84)
        cone = cylinder(r, 0.36 * h, n, top=0.006)
        a = np.arctan2(cone.vertices[:, 1], cone.vertices[:, 0])
        step = ((a / (2 * np.pi) * n).round().astype(int)) % n
        f = np.where(cone.vertices[:, 2] < 0.01, ring[step], 1.0)[:, None]
        tiers.append(cone.bend(lambda p, f=f: p * np.column_stack([f, f, np.ones(len(p))]))
                     .turn(2, 0.4 * k).move(z=z))  # fmt: skip
    balls: dict[int, list[Solid]] = {0: [], 1: [], 2: []}
    for k in range(16):
        t = (k + 0.5) / 16
        z = 0.06 + 0.72 * (h - 0.06) * t
        r = 0.074 * (1 - 0.83 * t)
        balls[k % 3].append(
            ball(0.014, 0.014, 0.014, (r * np.cos(2.4 * k), r * np.sin(2.4 * k), z), 8)
        )
    top = max(float(t.bounds[1, 2]) for t in tiers)
    star = standing_plate(star_outline(0.02), 0.006).move(z=top + 0.012)
    trunk = cylinder(0.011, 0.05, 12)
    pot = cylinder(0.03, 0.032, 20, top=0.037)
    fir = surfaces.scratches(look.rng, color, tint_color(color, 1.35), 120)
    hues = [look.own_color("red", "blue", "purple"), GOLD, (236, 236, 240)]
    pieces: Pieces = [(join(tiers), fir), (trunk, surfaces.plain((96, 68, 46))),
                      (pot, surfaces.speckles(look.rng, look.own_color("red", "brown", "white"),
                                              5)),
                      (star, surfaces.plain((240, 196, 70)))]  # fmt: skip
    pieces += [(join(balls[k]), surfaces.plain(hues[k])) for k in range(3)]
    return put_down(pieces, pot, tiers[0], join(tiers[1:]), star)


@category("bauble", size=(0.075, 0.068, 0.075), mass=0.03, material="glass", assembled=True,
          aliases=("christmas ornament", "christmas bauble", "christmas ball", "tree ornament",
          "christmas tree ornament", "glass bauble", "christmas decoration", "hanging ornament",
          "glass ornament"), themes=("living",), roles=("round",),
          colors=("red", "gold"))  # fmt: skip
def bauble(look: Look) -> Shape:
    """A glass Christmas bauble with a cap and a loop."""
    d = look.between(0.055, 0.08)
    color = look.color("red", "gold", "silver", "green", "blue", "purple", "pink")
    kind = look.pick(["plain", "band", "dots"])
    tile = surfaces.gradient(tint_color(color, 0.75), tint_color(color, 1.25), look.rng, 3)
    if kind != "plain":
        pale = tint_color(color, 1.75)
        other = surfaces.plain(pale)
        tile = (surfaces.stack((tile, 0.42), (other, 0.05), (tile, 0.06), (other, 0.05),
                               (tile, 0.42)) if kind == "band"
                else surfaces.spots(look.rng, color, pale, 0.12))  # fmt: skip
    lean = 0.5
    parts = [(ellipsoid(d, d, d, 26, 16), tile),
             (cylinder(0.009, 0.01, 16).move(z=0.49 * d), surfaces.plain((206, 172, 96))),
             (torus(0.006, 0.0012, 14, 6).turn(0, np.pi / 2).move(z=0.49 * d + 0.014),
              surfaces.plain((190, 160, 96)))]  # fmt: skip
    pieces = [(s.turn(1, lean).move(z=0.484 * d), t) for s, t in parts]
    return put_down(pieces, pieces[0][0], pieces[1][0])


@category("star", size=(0.12, 0.113, 0.022), mass=0.06, material="metal",
          aliases=("gold star", "christmas star", "tree topper", "star ornament", "paper star"),
          themes=("living",), roles=("flat",), colors=("gold",), state="lying flat")  # fmt: skip
def star(look: Look) -> Shape:
    """A faceted five-pointed star, lying flat."""
    color = look.color("gold", "yellow", "silver", "red", "white", "wooden")
    r = look.between(0.05, 0.075)
    outline = star_outline(r, 0.45)
    low = prism(outline, 0, 0.008)
    faces = [prism([outline[k - 1] * 0.999, outline[k] * 0.999, (0.0, 0.0)], 0.007, 0.0081)
             for k in range(10)]  # fmt: skip

    def peak(p: np.ndarray) -> np.ndarray:
        rise = 0.014 * (1 - np.minimum(np.hypot(p[:, 0], p[:, 1]) / (0.45 * r), 1))
        return np.column_stack([p[:, :2], p[:, 2] + np.where(p[:, 2] > 0.0075, rise, 0)])

    lit = join([f.bend(peak) for f in faces[::2]])
    shade = join([f.bend(peak) for f in faces[1::2]])
    return put_down([(low, look.surface(color, "metal")),
                     (lit, surfaces.plain(tint_color(color, 1.2))),
                     (shade, surfaces.plain(tint_color(color, 0.82)))], low,
                    join([lit, shade]))  # fmt: skip


@category("stocking", size=(0.15, 0.22, 0.026), mass=0.08, material="fabric",
          aliases=("christmas stocking", "xmas stocking", "holiday stocking"), themes=("living",),
          colors=("red",), state="lying flat")  # fmt: skip
def stocking(look: Look) -> Shape:
    """A Christmas stocking with a white cuff, lying flat with its toe on the left."""
    color = look.color("red", "green", "red", "crimson", "navy")
    knit = surfaces.knitting(look.rng, color, 22)
    outline = smooth([(0.035, 0.09), (-0.035, 0.09), (-0.034, 0.0), (-0.05, -0.03), (-0.1, -0.045),
                      (-0.112, -0.07), (-0.095, -0.09), (-0.02, -0.09), (0.03, -0.07),
                      (0.036, -0.02), (0.035, 0.088)], 3)[:-1]  # fmt: skip
    body = prism(outline, 0, 0.018)
    inner = prism(outline * 0.93 - [0.002, 0.001], 0.0175, 0.022)
    cuff = pad(0.086, 0.04, 0.026, 0.008, soft=0.5).move(0, 0.095)
    toe = ball(0.05, 0.055, 0.028, (-0.092, -0.068, 0.0115), 14)
    heel = ball(0.04, 0.045, 0.026, (0.018, -0.068, 0.0118), 14)
    loop = rod([(0.03, 0.11, 0.012), (0.036, 0.135, 0.008), (0.02, 0.14, 0.006),
                (0.024, 0.112, 0.01)], 0.003, 6)  # fmt: skip
    pale = surfaces.spots(look.rng, (246, 244, 238), (226, 224, 220), 0.3)
    pieces: Pieces = [(join([body, inner]), knit), (join([cuff, toe, heel]), pale),
                      (loop, surfaces.plain(color))]  # fmt: skip
    leg = body.vertices[body.vertices[:, 1] > -0.05]
    foot = body.vertices[body.vertices[:, 1] < -0.02]
    made = put_down(pieces, body, cuff)
    parts = (hull_part(leg), hull_part(foot), hull_of(cuff))
    return Shape(made.pieces, parts).scale(look.between(0.85, 1.1))


@category("snow_globe", size=(0.083, 0.083, 0.105), mass=0.35, material="wood",
          aliases=("snowglobe", "snow dome", "christmas snow globe", "glass snow globe"),
          themes=("living",), roles=("round",), colors=("wooden", "red"))  # fmt: skip
def snow_globe(look: Look) -> Shape:
    """A snow globe on a base: a pale globe with a small tree and a house in front."""
    d = look.between(0.075, 0.095)
    color = look.color("wooden", "red", "black", "gold", "brown", "navy", "green")
    base = lathe([(0, 0), (0.46 * d, 0), (0.48 * d, 0.008), (0.4 * d, 0.02), (0.38 * d, 0.034),
                  (0, 0.034)], 28)  # fmt: skip
    ground = lathe([(0, 0.03), (0.33 * d, 0.03), (0.3 * d, 0.045), (0, 0.05)], 24)
    top = 0.045
    cones = [cylinder(0.016 - 0.004 * k, 0.022, 12, top=0.001).move(-0.01, 0, top + 0.01 * k)
             for k in range(3)]  # fmt: skip
    house = box(0.018, 0.016, 0.014).move(0.014, -0.004, top)
    roof = side_view([(0.002, top + 0.014), (0.026, top + 0.014), (0.014, top + 0.026)], 0.019)
    roof = roof.move(y=-0.004)
    flakes = [ball(0.0028, 0.0028, 0.0028, (0.33 * d * np.cos(2.4 * k) * np.sqrt((k + 1) / 26), 0.33
                                            * d * np.sin(2.4 * k) * np.sqrt((k + 1) / 26), top
                                            + 0.012 + 0.0016 * ((k * 7) % 26)), 6)
              for k in range(26)]  # fmt: skip
    hoops = [torus(0.44 * d, 0.0011, 34, 6).turn(0, np.pi / 2).turn(2, a).move(z=0.034 + 0.4 * d)
             for a in (0.0, np.pi / 2)]  # fmt: skip
    glass = ball(0.9 * d, 0.9 * d, 0.9 * d, (0, 0, 0.034 + 0.4 * d), 20)
    back = [lathe([(0, 0.03), (0.3 * d, 0.032), (0.0, 0.034)], 12)]
    pieces: Pieces = [(join([base, *back]), look.surface(color, "wood")),
                      (join([ground, *flakes]), surfaces.plain((246, 248, 252))),
                      (join(cones), surfaces.plain((52, 110, 66))),
                      (house, surfaces.plain((226, 190, 150))),
                      (roof, surfaces.plain((190, 50, 46))),
                      (join(hoops), surfaces.plain((206, 224, 236)))]  # fmt: skip
    return shape(pieces, [hull_of(base), hull_of(glass)])


BALLOON_GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


@category("bow", size=(0.0712, 0.0712, 0.0488), mass=0.008, material="fabric", assembled=True,
          aliases=("gift bow", "ribbon bow", "hair bow", "red bow"), themes=("living",),
          colors=("red", "gold"))  # fmt: skip
def bow(look: Look) -> Shape:
    """A gift bow of many ribbon loops."""
    color = look.color("red", "gold", "blue", "pink", "silver", "green", "white")
    loops: list[Solid] = []
    for n, (count, lift) in enumerate(((8, 0.12), (7, 0.6), (5, 1.1))):
        for k in range(count):
            loop = torus(0.013, 0.0022, 14, 4).scale(1.25, 0.62, 1.9).turn(0, np.pi / 2)
            loop = loop.move(x=0.017).turn(1, -lift).turn(2, 2 * np.pi * k / count + 0.4 * n)
            loops.append(loop.move(z=0.012 + 0.002 * n))
    pad_ = cylinder(0.012, 0.004, 16)
    sheen = surfaces.stripes([color, tint_color(color, 1.25), color], 2, side=32)
    return put_down([(join([*loops, pad_]), sheen)], factor=look.between(0.85, 1.2))


EASTER_EGG_GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


@category("easter_egg", size=(0.061, 0.046, 0.045), mass=0.05, material="food",
          aliases=("painted egg", "decorated egg", "chocolate egg", "coloured egg", "dyed egg",
          "pysanka", "foil wrapped egg", "creme egg", "faberge egg", "mini egg", "plastic egg",
          "foil egg"), themes=("living",), roles=("round",), colors=("pink", "sky"),
          state="lying")  # fmt: skip
def easter_egg(look: Look) -> Shape:
    """A painted egg, lying on its side."""
    color = look.color("pink", "sky", "yellow", "mint", "lavender", "orange", "red", "blue")
    d = look.between(0.042, 0.05)
    kind = look.pick(["bands", "dots", "zigzag"])
    pale = tint_color(color, 1.7)
    if kind == "bands":
        tile = surfaces.stripes([color, pale, look.own_color(*EASTER_EGG_GAY), pale], 3, side=96)
    elif kind == "dots":
        tile = prints.canvas(96, 96, color)
        for k in range(36):
            prints.disc(
                tile, (k % 6 + 0.5 * (k // 6 % 2) + 0.2) / 6, (k // 6 + 0.5) / 6, 0.045, pale
            )
    else:
        tile = prints.canvas(96, 96, color)
        for z, hue in ((0.3, pale), (0.5, look.own_color(*EASTER_EGG_GAY)), (0.7, pale)):
            line = [(n / 16, z + 0.05 * (-1) ** n) for n in range(17)]
            prints.stroke(tile, line, 0.045, hue)
    egg = ellipsoid(d, d, 1.32 * d, 24, 16).bend(
        lambda p: p * np.column_stack([*[1 - 0.9 * p[:, 2] / d * 0.14] * 2, np.ones(len(p))])
    )
    egg = egg.turn(1, np.pi / 2).move(z=0.485 * d)
    return shape([(egg, tile)], [flat_foot(above(egg.vertices), 0.06)])


@category("horseshoe", size=(0.112, 0.104, 0.00854), mass=0.3, material="metal", assembled=True,
          aliases=("lucky horseshoe", "horse shoe", "iron horseshoe", "horseshoe charm",
          "lucky charm"), themes=("living",), roles=("flat",), colors=("gray",),
          state="lying flat")  # fmt: skip
def horseshoe(look: Look) -> Shape:
    """A horseshoe lying flat, with nail holes along its two arms."""
    k, color = look.between(0.85, 1.15), look.color("gray", "silver", "bronze", "black", "gold")
    a = np.linspace(-0.62, np.pi + 0.62, 19)
    middle = np.column_stack([0.046 * np.cos(a), 0.054 * np.sin(a)])
    outer, inner = middle * 1.2, middle * np.array([0.78, 0.8])
    body = prism(np.concatenate([outer, inner[::-1]]) * k, 0, 0.008 * k)
    holes = [box(0.0035 * k, 0.006 * k, 0.0006).move(s * 0.043 * k, y * k, 0.0078 * k)
             for s in (-1, 1) for y in (-0.01, 0.006, 0.022)]  # fmt: skip
    metal = look.surface(color, "iron" if look.chance(0.5) else "steel")
    parts = []
    for i in range(0, 18, 3):
        ring = np.concatenate([outer[i : i + 4], inner[i : i + 4][::-1]]) * k
        parts.append(hull_of(prism(ring, 0, 0.008 * k)))
    return shape([(body, metal), (join(holes), surfaces.plain((24, 24, 26)))], parts)


@category("wreath", size=(0.27, 0.28, 0.055), mass=0.25, material="wood", assembled=True,
          aliases=("christmas wreath", "door wreath", "leaf wreath", "laurel wreath",
          "flower wreath", "garland"), themes=("living",), roles=("big",), colors=("green",),
          state="lying flat")  # fmt: skip
def wreath(look: Look) -> Shape:
    """A wreath of fir or leaves with berries and a bow, lying flat."""
    color = look.color("green", "green", "olive", "sage", "tan")
    big = look.between(0.085, 0.115)
    sprigs: list[Solid] = []
    for k in range(60):
        a = 2 * np.pi * k / 60
        leaf = ellipsoid(0.05, 0.013, 0.011, 6, 4).turn(1, look.between(-0.5, 0.2))
        leaf = leaf.turn(2, a + np.pi / 2 + (0.6, -0.6, 0.05)[k % 3])
        out = big + (0.012, -0.012, 0)[k % 3]
        sprigs.append(leaf.move(out * np.cos(a), out * np.sin(a), 0.02 + 0.004 * (k % 2)))
    core = torus(big, 0.019, 30, 8).move(z=0.016)
    berries = [ball(0.014, 0.014, 0.014, ((big + 0.012 * (k % 2)) * np.cos(2 * np.pi * k / 11),
               (big + 0.012 * (k % 2)) * np.sin(2 * np.pi * k / 11), 0.037), 8)
               for k in range(11)]  # fmt: skip
    loops = [ball(0.045, 0.03, 0.016, (s * 0.024, -big, 0.045), 10) for s in (-1, 1)]
    tails = [box(0.014, 0.05, 0.003).turn(2, s * 0.4).move(s * 0.012, -big - 0.02, 0.036)
             for s in (-1, 1)]  # fmt: skip
    red = surfaces.plain(look.own_color("red", "gold", "white", "crimson"))
    fir = surfaces.speckles(look.rng, color, 16)
    wedges = ring_parts(
        [(big + 0.02, 0), (big + 0.026, 0.035)], [(big - 0.02, 0.035), (big - 0.02, 0)], 10
    )
    return shape([(join(sprigs), fir), (core, surfaces.plain(tint_color(color, 0.6))),
                  (join(berries), red), (join([*loops, *tails]), red)], wedges)  # fmt: skip


@category("easter_tree", size=(0.218, 0.227, 0.233), mass=0.4, material="ceramic", assembled=True,
          aliases=("egg tree", "twig tree", "easter egg tree"), themes=("living",), roles=("tall",),
          colors=("white",))  # fmt: skip
def easter_tree(look: Look) -> Shape:
    """An Easter tree: bare twigs in a pot, hung with painted eggs."""
    k, color = look.between(0.85, 1.06), look.color("white", "sage", "pink", "terracotta", "sky")
    pot = lathe([(0, 0), (0.036, 0), (0.046, 0.06), (0.048, 0.068), (0.04, 0.068), (0.038, 0.06),
                 (0, 0.058)], 26)  # fmt: skip
    twigs, eggs = [], ([], [], [])
    for n in range(8):
        a, h = 2.4 * n, 0.2 + 0.02 * (n % 3)
        out = 0.05 + 0.035 * (n % 2)
        x, y = np.cos(a), np.sin(a)
        tip = (out * x, out * y, h)
        twigs.append(tube(smooth([(0.008 * x, 0.008 * y, 0.055),
                                  (0.3 * out * x, 0.3 * out * y, 0.12), tip], 3), 0.0018,
                          5))  # fmt: skip
        side = (1.35 * out * x - 0.02 * y, 1.35 * out * y + 0.02 * x, h - 0.04)
        twigs.append(tube([(0.6 * out * x, 0.6 * out * y, 0.6 * h + 0.02), side], 0.0013, 4))
        eggs[n % 3].append(
            ellipsoid(0.02, 0.02, 0.027, 12, 8).move(side[0], side[1], side[2] - 0.022)
        )
        twigs.append(tube([side, (side[0], side[1], side[2] - 0.01)], 0.0005, 4))
    hues = [look.own_color("yellow", "pink"), look.own_color("sky", "mint"),
            look.own_color("violet", "coral")]  # fmt: skip
    made = [(pot, look.surface(color, "ceramic")), (join(twigs), surfaces.plain((120, 92, 66))),
            *((join(e), surfaces.stripes([h, (250, 248, 240), h], 3)) for e,
              h in zip(eggs, hues, strict=True))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(*[t.scale(k, k, k) for t in twigs[::3]])])


@category("dreamcatcher", size=(0.13, 0.216, 0.00898), mass=0.05, material="fabric", assembled=True,
          aliases=("dream catcher",), themes=("living", "craft"), roles=("flat",),
          colors=("brown",))  # fmt: skip
def dreamcatcher(look: Look) -> Shape:
    """A dreamcatcher lying flat: a hoop with a woven net, beads and feathers."""
    color = look.color("brown", "white", "turquoise", "purple", "tan", "red")
    k = look.between(0.85, 1.15)
    hoop = torus(0.06, 0.0045, 36, 8).move(0, 0.05, 0.0044)
    net = []
    for r, s in ((0.058, 0.042), (0.042, 0.026), (0.026, 0.011)):
        for n in range(12):
            a, b = n * np.pi / 6, (n + 0.5) * np.pi / 6
            start = (r * np.cos(a), 0.05 + r * np.sin(a), 0.004)
            net += [straight(start, (s * np.cos(e), 0.05 + s * np.sin(e), 0.004), 0.0006, 4)
                    for e in (b, b - np.pi / 6)]  # fmt: skip
    beads = [ball(0.008, 0.008, 0.008, (x, y, 0.0045), 10)
             for x, y in ((0, 0.05), (0.02, 0.07), (-0.025, 0.035), (0.03, -0.014), (-0.03, -0.014),
                          (0, -0.02))]  # fmt: skip
    cords, quills = [], []
    for x, y in ((-0.03, -0.002), (0, -0.01), (0.03, -0.002)):
        cords.append(straight((x, y, 0.003), (x, y - 0.04, 0.003), 0.0008, 5))
        quills.append(plate(ellipse(0.017, 0.06, 16), 0.0015).move(x, y - 0.06, 0.0008))
    wrap = surfaces.stripes([color, tint_color(color, 0.8)], 16, upright=True)
    other = look.own_color("white", "tan", "turquoise", "coral", "brown")
    return put_down([(hoop, wrap), (join([*net, *cords]), plain((232, 224, 206))),
                     (join(beads), plain(look.own_color("turquoise", "red", "navy"))),
                     (join(quills), surfaces.scratches(look.rng, other, tint_color(other, 0.75),
                                                       70))], hoop, *quills, factor=k,
                    foot=0.2)  # fmt: skip


@category("wind_chime", size=(0.0825, 0.264, 0.0121), mass=0.2, material="metal", assembled=True,
          aliases=("wind chimes", "windchime", "chime"), themes=("living",), roles=("flat",),
          colors=("silver",))  # fmt: skip
def wind_chime(look: Look) -> Shape:
    """A wind chime lying flat: a round top with metal tubes on cords."""
    color = look.color("silver", "gold", "copper", "teal", "bronze")
    k = look.between(0.85, 1.15)
    top = drum(0.03, 0.008, (0, 0.09, 0), bevel=0.002)
    loop = torus(0.009, 0.0015, 16, 6).move(0, 0.126, 0.002)
    tubes, cords = [], []
    for n in range(5):
        x, long = 0.017 * (n - 2), 0.1 - 0.012 * abs(n - 1)
        tubes.append(straight((x, 0.035, 0.0057), (x, 0.035 - long, 0.0057), 0.006, 12))
        cords.append(straight((0.6 * x, 0.085, 0.005), (x, 0.034, 0.0055), 0.0007, 4))
    sail = plate(ellipse(0.026, 0.04, 18), 0.003).move(0, -0.1, 0)
    line = straight((0, -0.07, 0.003), (0, -0.084, 0.002), 0.0007, 4)
    wood = surfaces.wood(look.rng, (140, 92, 56))
    return put_down([(join([top, sail]), wood), (join(tubes), steel(look, color)),
                     (join([loop, *cords, line]), plain((220, 214, 200)))],
                    top, *tubes, sail, factor=k, foot=0.3)  # fmt: skip


@category("feather", size=(0.17, 0.031, 0.012), mass=0.001, material="paper", assembled=True,
          aliases=("bird feather", "quill", "plume"), themes=("living",), colors=("white", "gray"),
          state="lying flat")  # fmt: skip
def feather(look: Look) -> Shape:
    """A feather with its quill, lying flat."""
    color = look.color("white", "gray", "blue", "brown", "black", "red", "green")
    long = look.between(0.14, 0.2)
    half = np.array(
        smooth([(-0.22, 0.002), (-0.16, 0.07), (0.1, 0.1), (0.38, 0.075), (0.5, 0.0)], 4)
    )
    outline = np.concatenate([half[::-1], half[:-1] * [1, -0.8]]) * long

    def bow(p: np.ndarray) -> np.ndarray:
        return np.column_stack([p[:, :2], p[:, 2] + 0.6 * (p[:, 0] - 0.1 * long) ** 2 / long * 0.6])

    vane = prism(outline, 0.0008, 0.0018).bend(bow)
    quill = rod([(-0.5 * long, 0, 0.0035), (-0.2 * long, 0, 0.0026), (0.1 * long, 0, 0.0018),
                 (0.46 * long, 0, 0.0036)], [0.0012, 0.0012, 0.0009, 0.0004], 6)  # fmt: skip
    barbs = surfaces.stripes([color, tint_color(color, 0.86)], 22, upright=True, side=96)
    return put_down([(vane, barbs), (quill, surfaces.plain((240, 232, 214)))], vane, quill)


@category("gingerbread_house", size=(0.155, 0.14, 0.13), mass=0.5, material="food",
          aliases=("ginger bread house", "candy house"), themes=("living",),
          colors=("brown",))  # fmt: skip
def gingerbread_house(look: Look) -> Shape:
    """A gingerbread house with icing, sweets, a door and a chimney."""
    color = look.color("bronze", "brown", "copper", "terracotta")
    k = look.between(0.9, 1.15)
    w, d, h = 0.1, 0.085, 0.06
    crust = surfaces.speckles(look.rng, color, 12)
    walls = side_view([(-w / 2, 0), (w / 2, 0), (w / 2, h), (0, h + 0.055), (-w / 2, h)], d)
    long = 0.088
    slabs = [box(long, d + 0.024, 0.009).move(x=s * (long / 2 - 0.004)).turn(1, s * 0.832)
             .move(0, 0, h + 0.057) for s in (-1, 1)]  # fmt: skip
    edge = [rod([(s * 0.064, y, h - 0.006), (s * 0.03, y, h + 0.03), (0, y, h + 0.066)], 0.0045, 6)
            for s in (-1, 1) for y in (-d / 2 - 0.012, d / 2 + 0.012)]  # fmt: skip
    ridge = straight((0, -d / 2 - 0.012, h + 0.066), (0, d / 2 + 0.012, h + 0.066), 0.006)
    base = box(w + 0.05, d + 0.05, 0.006)
    door = box(0.024, 0.003, 0.036).move(0, -d / 2, 0.006)
    panes = [box(0.018, 0.003, 0.018).move(s * 0.032, -d / 2, 0.024) for s in (-1, 1)]
    frames = [box(0.023, 0.002, 0.023).move(s * 0.032, -d / 2, 0.0215) for s in (-1, 1)]
    chimney = box(0.018, 0.018, 0.04).move(0.03, 0.015, h + 0.025)
    drops: list[list[Solid]] = [[], [], []]
    for n in range(18):
        s, row, col = (-1) ** n, (n // 2) % 3, (n // 6)
        x = 0.018 + 0.02 * row
        at = (s * x, (col - 1) * 0.032, h + 0.064 - 1.1 * x + 0.003)
        drops[n % 3].append(ball(0.012, 0.012, 0.009, at, 8))
    icing = surfaces.plain((250, 248, 244))
    tints = [surfaces.plain(look.own_color(c)) for c in ("red", "green", "yellow")]
    pieces: Pieces = [(join([walls, chimney]), crust), (join(slabs), surfaces.speckles(look.rng,
                      tint_color(color, 0.75), 10)), (join([*edge, ridge, base, *frames]), icing),
                      (door, surfaces.plain((110, 60, 40))),
                      (join(panes), surfaces.plain((250, 214, 110)))]  # fmt: skip
    pieces += [(join(d), t) for d, t in zip(drops, tints, strict=True)]
    return put_down(pieces, base, walls, *slabs, factor=k)


@category("jack_o_lantern", size=(0.13, 0.135, 0.12), mass=0.5, material="food",
          aliases=("carved pumpkin", "jack-o-lantern", "jack o'lantern", "pumpkin lantern"),
          themes=("living",), roles=("round",), colors=("orange",))  # fmt: skip
def jack_o_lantern(look: Look) -> Shape:
    """A carved pumpkin with eyes, a nose and a toothed grin."""
    color = look.color("orange", "orange", "amber", "coral")
    d = look.between(0.11, 0.15)
    body = lobe(ellipsoid(d, d, 0.78 * d, 40, 14), 10, 0.12).move(z=0.37 * d)
    stem = rod([(0, 0, 0.72 * d), (0.004, 0, 0.82 * d), (0.018, 0, 0.9 * d)],
               [0.011, 0.008, 0.009], 8)  # fmt: skip
    r = 0.53 * d

    def carve(points: list[tuple[float, float]]) -> Solid:
        """Return a dark patch on a pumpkin's front with the corners (x, z), in pumpkin widths."""
        plate = refine(refine(standing_plate(np.array(points) * d, 0.1 * d)))

        def wrap(p: np.ndarray) -> np.ndarray:
            z = (p[:, 2] - 0.37 * d) / (0.39 * d)
            reach = r * np.sqrt(np.maximum(1 - z**2, 0.05)) * 0.995
            depth = np.sqrt(np.maximum(reach**2 - p[:, 0] ** 2, 0))
            return np.column_stack([p[:, 0], -depth + 0.4 * p[:, 1] - 0.012 * d, p[:, 2]])

        return plate.bend(wrap)

    eyes = [carve([(s * 0.19 - 0.08, 0.48), (s * 0.19 + 0.08, 0.48), (s * 0.19, 0.62)])
            for s in (-1, 1)]  # fmt: skip
    nose = carve([(-0.035, 0.41), (0.035, 0.41), (0.0, 0.48)])
    grin = carve([(-0.28, 0.37), (-0.17, 0.26), (-0.09, 0.26), (-0.09, 0.295), (-0.03, 0.295),
                  (-0.03, 0.24), (0.09, 0.25), (0.17, 0.26), (0.28, 0.37), (0.13, 0.32),
                  (0.08, 0.33), (0.08, 0.295), (0.02, 0.295), (0.02, 0.325),
                  (-0.13, 0.325)])  # fmt: skip
    glow = surfaces.plain(look.pick([(30, 22, 18), (250, 206, 80)]))
    skin = surfaces.stripes([color, tint_color(color, 0.88)], 10, upright=True, side=96)
    return put_down([(body, skin), (stem, surfaces.plain((110, 120, 60))),
                    (join([*eyes, nose, grin]), glow)], body, stem)  # fmt: skip


@category("easter_basket", size=(0.189, 0.183, 0.0791), mass=0.25, material="wood", hollow=True,
          aliases=("egg basket", "gift basket", "basket with a handle", "flower basket"),
          themes=("living",), roles=("container", "round"), colors=("tan",))  # fmt: skip
def easter_basket(look: Look) -> Shape:
    """A small, round, open basket with its handle folded down at the back."""
    r, h = look.between(0.07, 0.09), look.between(0.065, 0.08)
    color = look.color("tan", "brown", "white", "pink", "sky", "bronze", "mint")
    body, _ = open_vessel([(0.8 * r, 0), (0.93 * r, 0.5 * h), (r, h)], 0.006, 0.006)
    rim = torus(0.98 * r, 0.006, 32, 8).move(z=h)
    grip = rod([(-1.04 * r, 0, h), (-0.85 * r, 0.75 * r, h - 0.004), (0, 1.16 * r, h - 0.008),
                (0.85 * r, 0.75 * r, h - 0.004), (1.04 * r, 0, h)], 0.006, 8)  # fmt: skip
    loops = [
        ball(0.034, 0.01, 0.024, (-0.97 * r + 0.006 * s, s * 0.018, h - 0.004), 8) for s in (-1, 1)
    ]
    weave = surfaces.basketwork(look.rng, color, 14)
    knot = surfaces.plain(look.own_color("pink", "yellow", "lavender", "red"))
    wall = ring_parts([(0.8 * r, 0), (0.93 * r, 0.5 * h), (r, h)],
                      [(r - 0.006, h), (0.8 * r - 0.006, 0.006)], 14)  # fmt: skip
    return shape([(body, weave), (join([rim, grip]), surfaces.plain(tint_color(color, 0.85))),
                  (join(loops), knot)], [*wall, cylinder_part(0.78 * r, 0.006)])  # fmt: skip


BRASS = (206, 172, 96)


@category("mantel_clock", size=(0.16, 0.08, 0.162), mass=0.9, material="wood",
          aliases=("mantle clock", "mantelpiece clock", "wooden clock", "antique clock",
          "shelf clock", "grandfather clock", "grandfather clock model", "astronomical clock model",
          "ship clock"), themes=("living",), colors=("brown",))  # fmt: skip
def mantel_clock(look: Look) -> Shape:
    """A wooden mantel clock with an arched top, a dial and feet."""
    color = look.color("brown", "wooden", "black", "red", "tan")
    k = look.between(0.85, 1.15)
    a = np.linspace(0, np.pi, 13)
    arch = np.column_stack([0.06 * np.cos(a), 0.085 + 0.06 * np.sin(a)])
    outline = np.concatenate([[(-0.06, 0.018), (0.06, 0.018)], arch])
    body = prism(outline, -0.03, 0.03).turn(0, np.pi / 2)
    base = block(0.16, 0.08, 0.018, 0.004, 0.003)
    ring = torus(0.043, 0.004, 32, 8).turn(0, np.pi / 2).move(0, -0.031, 0.085)
    dial = cylinder(0.042, 0.002, 32).turn(0, np.pi / 2).move(0, -0.0295, 0.085)
    face = prints.clock_face(look.rng, (246, 240, 224), (44, 38, 36))
    knob = ball(0.016, 0.016, 0.02, (0, 0, 0.152), 12)
    wood = surfaces.wood(look.rng, color)
    return put_down([(join([body, base]), wood), (join([ring, knob]), surfaces.plain(BRASS)),
                     (dial, face)], base, body, factor=k)  # fmt: skip


@category("egg_dye_kit", size=(0.151, 0.0459, 0.182), mass=0.15, material="paper",
          aliases=("egg dye", "egg decorating kit", "egg colouring kit", "egg coloring kit",
          "egg painting kit", "easter egg dye", "egg dyeing kit"), themes=("living",),
          colors=("pink",))  # fmt: skip
def egg_dye_kit(look: Look) -> Shape:
    """An egg dyeing kit in a box, with painted eggs and pots of colour printed on its front."""
    k, color = look.between(0.9, 1.1), look.color("pink", "yellow", "sky", "mint", "lavender")
    x, y, h = 0.15 * k, 0.045 * k, 0.18 * k
    image = prints.canvas(170, 200, color)
    prints.write(image, "EGG DYE", 0.5, 0.13, 0.13, readable_on(color), bold=True)
    prints.write(image, "KIT", 0.5, 0.26, 0.1, readable_on(color), bold=True)
    hues: tuple[RGB, ...] = ((236, 84, 110), (250, 206, 60), (80, 160, 220), (110, 180, 90),
                             (150, 100, 190))  # fmt: skip
    for n, hue in enumerate(hues):
        at = 0.14 + 0.18 * n
        prints.disc(image, at, 0.54 + 0.05 * (n % 2), 0.08, hue)
        prints.disc(image, at, 0.51 + 0.05 * (n % 2), 0.07, hue)
        prints.fill(image, at - 0.07, 0.54 + 0.05 * (n % 2), 0.14, 0.02, (250, 248, 240))
        prints.fill(image, at - 0.06, 0.78, 0.12, 0.14, hue)
        prints.fill(image, at - 0.07, 0.75, 0.14, 0.04, (250, 250, 250))
    panel = box(x, 0.0005, h)
    return shape([(box(x, y, h), surfaces.plain(tint_color(color, 0.85))),
                  (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image)],
                 [box_part(x, y, h)])  # fmt: skip


@category("message_in_a_bottle", size=(0.22, 0.068, 0.068), mass=0.3, material="glass",
          aliases=("message in bottle", "letter in a bottle", "bottle message"), themes=("living",),
          colors=("cream",))  # fmt: skip
@from_pieces(foot=0.03, bodies=4)
def message_in_a_bottle(look: Look) -> Pieces:
    """A corked bottle lying flat, with a rolled-up sheet of paper inside."""
    z = 0.034
    glass = surfaces.plain((168, 206, 190))
    hoops = [torus(r, 0.0016, 28, 5).turn(1, np.pi / 2).move(x, 0, z) for x,
             r in ((-0.088, 0.03), (-0.03, 0.033), (0.03, 0.033))]  # fmt: skip
    wires = [tube(smooth([(-0.09, 0.03 * np.cos(a), z + 0.03 * np.sin(a)),
                          (0.0, 0.033 * np.cos(a), z + 0.033 * np.sin(a)),
                          (0.04, 0.032 * np.cos(a), z + 0.032 * np.sin(a)),
                          (0.07, 0.013 * np.cos(a), z + 0.013 * np.sin(a)),
                          (0.11, 0.012 * np.cos(a), z + 0.012 * np.sin(a))], 5), 0.0012, 5)
             for a in np.arange(9) * 0.698]  # fmt: skip
    base = spindle((-0.09, 0.03), (-0.087, 0.032), z=z)
    lip = torus(0.0125, 0.003, 22, 6).turn(1, np.pi / 2).move(0.11, 0, z)
    scroll = spindle((-0.06, 0.014), (0.05, 0.014), z=0.018)
    tie = spindle((-0.01, 0.0148), (0.0, 0.0148), z=0.018)
    cork = spindle((0.1, 0.011), (0.13, 0.0125), z=z)
    foot = at_box(0.12, 0.03, 0.003)
    return [(join([*hoops, *wires]), glass), (base, glass), (cork, dye(look, "tan")), (foot, glass),
            (lip, glass), (scroll, surfaces.spots(look.rng, look.color("cream", "beige"),
                                                  (176, 146, 102), 0.05)),
            (tie, dye(look, "crimson"))]  # fmt: skip


@category("zen_garden", size=(0.245, 0.184, 0.0368), mass=0.8, material="wood",
          aliases=("sand garden", "mini zen garden", "desktop zen garden", "japanese garden"),
          themes=("living",), roles=("flat", "big"), colors=("brown",))  # fmt: skip
@vary()
@from_pieces(bodies=5)
def zen_garden(look: Look) -> Pieces:
    """A tray of raked sand with three stones and a small rake."""
    tile = wood(look, "brown", "black", "wooden")
    sides = [at_box(0.24, 0.012, 0.03, (0, s * 0.084, 0)) for s in (-1, 1)] + [
        at_box(0.012, 0.156, 0.03, (s * 0.114, 0, 0)) for s in (-1, 1)
    ]
    image = np.zeros((96, 128, 3))
    y, x = np.mgrid[0:96, 0:128].astype(float)
    wave = np.sin(np.minimum(np.hypot(x - 84, y - 40), 34) * 0.9 + 0.0 * y)
    far = np.hypot(x - 84, y - 40) > 32
    wave = np.where(far, np.sin(0.9 * y + 0.6 * np.sin(0.05 * x)), wave)
    image[:] = (230, 216, 186)
    image = np.clip(image + 15 * wave[..., None], 0, 255).astype(np.uint8)
    sand = at_box(0.217, 0.157, 0.02)
    stones = [ball(a, b, c, (px, py, 0.021), 12) for a, b, c, px,
              py in ((0.036, 0.03, 0.03, 0.035, 0.012), (0.022, 0.02, 0.018, 0.058, -0.006),
                     (0.018, 0.022, 0.014, 0.026, -0.014))]  # fmt: skip
    rake = [straight((-0.09, -0.05, 0.024), (-0.02, -0.02, 0.03), 0.0025, 8),
            straight((-0.025, -0.004, 0.026), (-0.013, -0.034, 0.026), 0.0025, 8)]  # fmt: skip
    return [*((s, tile) for s in sides), (sand, image), *((s, surfaces.speckles(look.rng, c, 8))
                                                          for s,
                                                          c in zip(stones,
                                                                   ((70, 70, 74), (120, 116, 110),
                                                                    (96, 92, 90)), strict=True)),
            (join(rake), dye(look, "wooden", "tan"))]  # fmt: skip


@category("wire_tree", size=(0.115, 0.123, 0.172), mass=0.3, material="metal", assembled=True,
          aliases=("gem tree", "copper tree", "crystal tree", "money tree ornament", "jewelry tree",
          "jewellery tree", "tree ornament sculpture"), themes=("living",), roles=("tall",),
          colors=("copper",))  # fmt: skip
@from_pieces(bodies=3)
def wire_tree(look: Look) -> Pieces:
    """A tree of twisted wire on a stone, with beads as leaves."""
    wire = metal(look, "copper", "gold", "silver", "bronze")
    rock = ball(0.08, 0.06, 0.036, (0, 0, 0.01), 12)
    trunk = rod([(0, 0, 0.02), (0.006, 0.0, 0.06), (-0.004, 0, 0.095)], [0.011, 0.008, 0.007], 10)
    boughs, leaves = [], []
    for k in range(11):
        a, r, z = 2.4 * k, 0.03 + 0.03 * ((k * 7) % 11) / 11, 0.12 + 0.05 * (k / 11)
        tip = (r * np.cos(a), r * np.sin(a), z)
        boughs.append(
            rod([(-0.003, 0, 0.085), (0.4 * tip[0], 0.4 * tip[1], 0.5 * z + 0.045), tip], 0.0022, 6)
        )
        leaves += [ball(0.013, 0.013, 0.01, (tip[0] + 0.011 * np.cos(n * 1.6), tip[1] + 0.011
                                             * np.sin(n * 1.6), z + 0.004 * (n % 2)), 7)
                   for n in range(4)]  # fmt: skip
    return [(rock, dye(look, "gray", "charcoal", "beige")), (trunk, wire), (join(boughs), wire),
            (join(leaves), dye(look, "green", "pink", "teal", "purple", "amber"))]  # fmt: skip


CATEGORIES = (
    Category("bunting", bunting("", True), size=(0.551, 0.168, 0.00364), mass=0.03,
             material="fabric", assembled=True, aliases=("string of bunting", "pennant banner",
             "flag garland", "string of flags", "paper garland", "pennant"), themes=("living",),
             roles=("big",), colors=("white",), state="lying flat"),
    Category("party_banner", bunting("PARTY!", False), size=(0.516, 0.152, 0.00381), mass=0.03,
             material="paper", assembled=True,
             aliases=("birthday banner", "banner", "happy birthday banner", "letter banner"),
             themes=("living",), roles=("big",), colors=("white",), state="lying flat"),
    Category("table_flag", from_pieces(bodies=3)(_table_flag_flag()), size=(0.15, 0.06, 0.246),
             mass=0.08, material="wood", assembled=True, aliases=("flag", "small flag", "desk flag",
             "mini flag", "national flag", "country flag", "flag on a stand", "toy flag"),
             themes=("living",), roles=("tall",), colors=("red", "blue")),
)  # fmt: skip
"""Objects that share their drawing functions."""
