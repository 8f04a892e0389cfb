"""Party things: hats, balloons, wrapping, Easter and Halloween."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, hull_part
from ...build.forms import above, lobe
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, join, lathe, loft, prism, torus
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


def party_hat(look: Look) -> Shape:
    """A paper cone with a pattern, a frill and a pompom."""
    r, h = look.between(0.05, 0.062), look.between(0.13, 0.165)
    paper = textures.fit(glaze_tile(look, look.color(*GAY)), 128, 128)
    cone = cylinder(r, h, 28, top=0.003)
    frill = lobe(torus(r, 0.006, 36, 6), 24, 0.06).move(z=0.0058)
    tuft = [ball(0.022, 0.009, 0.009, (0.008, 0, 0), 8).turn(1, 0.5 * n).turn(2, 1.3 * n).move(z=h)
            for n in range(10)]  # fmt: skip
    other = textures.plain(look.own_color(*GAY))
    return put_down([(cone, paper), (frill, other), (join(tuft), other)], cone, join(tuft))


def balloon(look: Look) -> Shape:
    """A balloon on a stick that stands in a small weight."""
    color = look.color(*GAY, "white", "gold")
    d = look.between(0.13, 0.17)
    weight = lathe(
        [(0, 0), (0.042, 0), (0.044, 0.01), (0.034, 0.034), (0.008, 0.04), (0, 0.04)], 22
    )
    stick = straight((0, 0, 0.036), (0, 0, 0.13), 0.0025)
    body = lathe(np.concatenate([[(0, 0)], smooth([(0.01, 0.004), (0.3 * d, 0.22 * d),
                 (0.5 * d, 0.68 * d), (0.34 * d, 1.05 * d), (0.04 * d, 1.18 * d)], 5),
                 [(0, 1.18 * d)]]), 26).move(z=0.13)  # fmt: skip
    knot = cylinder(0.008, 0.01, 12, top=0.003).move(z=0.124)
    skin = textures.gradient(tint_color(color, 0.88), tint_color(color, 1.15), look.rng, 2)
    pieces: Pieces = [(body, skin), (knot, textures.plain(tint_color(color, 0.8))),
                      (stick, textures.plain((244, 244, 240))),
                      (weight, textures.speckles(look.rng, look.own_color("silver", "gold", "red",
                                                                          "blue"), 5))]  # fmt: skip
    return put_down(pieces, weight, stick, body)


def party_popper(look: Look) -> Shape:
    """A party popper standing on its cap, its string above."""
    color = look.color(*GAY, "gold")
    paper = textures.stripes([color, tint_color(color, 1.6), look.own_color(*GAY)], 3, side=96)
    body = cylinder(0.022, 0.05, 24, top=0.018)
    neck = cylinder(0.0175, 0.03, 20, top=0.007).move(z=0.049)
    rim = cylinder(0.0235, 0.006, 24)
    string = rod([(0, 0, 0.078), (0.006, 0, 0.09), (0.02, 0, 0.082), (0.026, 0, 0.062)], 0.0013, 6)
    pieces: Pieces = [(join([body, neck]), paper), (rim, textures.plain((240, 220, 130))),
                      (string, textures.plain((250, 250, 246)))]  # fmt: skip
    return put_down(pieces, join([body, rim]), neck, factor=look.between(0.9, 1.2))


def cracker(look: Look) -> Shape:
    """A paper cracker lying: a roll twisted at both ends with gold bands."""
    color = look.color("red", "green", "gold", "crimson", "silver", "blue", "white")
    paper = textures.fit(glaze_tile(look, color), 128, 128)
    side = [(0, -0.14), (0.026, -0.14), (0.024, -0.115), (0.009, -0.078), (0.023, -0.062),
            (0.023, 0.062), (0.009, 0.078), (0.024, 0.115), (0.026, 0.14), (0, 0.14)]  # fmt: skip
    roll = lathe(side, 22).turn(1, np.pi / 2).move(z=0.0225)
    bands = [cylinder(0.0236, 0.009, 22).move(z=z - 0.0045).turn(1, np.pi / 2).move(z=0.0225)
             for z in (-0.05, 0.05)]  # fmt: skip
    ties = [torus(0.0095, 0.0026, 16, 6).turn(1, np.pi / 2).move(x, 0, 0.0225)
            for x in (-0.078, 0.078)]  # fmt: skip
    gold = textures.plain((224, 184, 90) if color[2] > 60 else (240, 240, 236))
    x = roll.vertices[:, 0]
    foot = [flat_foot(above(roll.vertices[np.abs(x) < 0.07]), 0.05),
            *[hull_part(above(roll.vertices[s * x > 0.075])) for s in (-1, 1)]]  # fmt: skip
    made = shape([(roll, paper), (join([*bands, *ties]), gold)], foot)
    return made.scale(look.between(0.85, 1.1))


def wrapping_paper(look: Look) -> Shape:
    """A roll of wrapping paper lying, its loose end on the table."""
    long, r = look.between(0.26, 0.34), look.between(0.02, 0.026)
    color = look.color("red", "green", "blue", "gold", "pink", "teal", "white")
    paper = textures.fit(glaze_tile(look, color), 128, 128)
    roll = cylinder(r, long, 26).move(z=-long / 2).turn(1, np.pi / 2).move(z=0.985 * r)
    hole = cylinder(0.6 * r, long + 0.001, 20).move(z=-long / 2 - 0.0005).turn(1, np.pi / 2)
    end = box(long, 1.6 * r, 0.0015).move(0, -0.8 * r, 0)
    return shape(
        [(join([roll, end]), paper), (hole.move(z=0.985 * r), textures.plain((190, 160, 120)))],
        [flat_foot(above(roll.vertices), 0.06), box_part(long, 1.6 * r, 0.0015, (0, -0.8 * r, 0))],
    )


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
    sheen = textures.stripes([color, tint_color(color, 1.25), color], 2, side=32)
    return put_down([(join([*loops, pad_]), sheen)], factor=look.between(0.85, 1.2))


def ribbon(look: Look) -> Shape:
    """A reel of ribbon lying, its end hanging loose."""
    r, wide = look.between(0.026, 0.034), look.between(0.014, 0.024)
    color = look.color("red", "pink", "gold", "blue", "green", "purple", "white", "silver")
    sheen = textures.brushed_metal(look.rng, color)
    coil = cylinder(r, wide, 30, bevel=0.001)
    core = cylinder(0.45 * r, wide + 0.001, 22)
    path = [
        (0, -r + 0.001, wide / 2),
        (0.5 * r, -1.06 * r, wide / 2),
        (1.1 * r, -0.9 * r, wide / 2),
        (1.5 * r, -1.2 * r, wide / 2),
        (1.9 * r, -1.05 * r, wide / 2),
    ]
    curve = smooth(path, 5)
    tail = loft(np.stack([np.array([[x, y - 0.0006, 0], [x, y + 0.0006, 0], [x, y + 0.0006, wide],
                                    [x, y - 0.0006, wide]]) for x, y, _ in curve]),
                np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]))  # fmt: skip
    return put_down(
        [(join([coil, tail]), sheen), (core, textures.plain((244, 240, 230)))], coil, tail
    )


def gift_tag(look: Look) -> Shape:
    """A gift tag lying flat with a hole and a string."""
    color = look.color("tan", "red", "white", "green", "gold", "pink")
    outline = [(-0.036, -0.008), (-0.024, -0.02), (0.036, -0.02), (0.036, 0.02), (-0.024, 0.02),
               (-0.036, 0.008)]  # fmt: skip
    card = prism(outline, 0, 0.0018)
    image = prints.canvas(96, 56, color)
    ink = readable_on(color)
    prints.write(image, look.pick(["FOR YOU", "TO:", "WITH LOVE"]), 0.55, 0.4, 0.26, ink)
    prints.fill(image, 0.3, 0.68, 0.5, 0.04, ink)
    face = box(0.056, 0.036, 0.0004).move(0.006, 0, 0.0017)
    eye = torus(0.0035, 0.0012, 14, 6).move(-0.027, 0, 0.0016)
    string = rod([(-0.027, 0, 0.002), (-0.045, 0.008, 0.0018), (-0.06, -0.004, 0.0012),
                  (-0.044, -0.01, 0.0014), (-0.028, -0.001, 0.0022)], 0.0008, 5)  # fmt: skip
    return put_down(
        [
            (card, textures.plain(color)),
            (face, image),
            (eye, textures.plain((206, 172, 96))),
            (string, textures.plain((226, 200, 150))),
        ],
        card,
        string,
        factor=look.between(0.9, 1.25),
    )


def birthday_cake(look: Look) -> Shape:
    """A frosted cake on a plate with candles burning on it and piped drops."""
    color = look.color("pink", "white", "brown", "yellow", "mint", "sky", "lavender")
    r, h = look.between(0.075, 0.095), look.between(0.055, 0.075)
    plate = cylinder(1.25 * r, 0.007, 32, bevel=0.002)
    body = cylinder(r, h, 32, bevel=0.004).move(z=0.006)
    drops = [ball(0.02, 0.02, 0.017, (0.9 * r * np.cos(a), 0.9 * r * np.sin(a), h + 0.01), 8)
             for a in 2 * np.pi * np.arange(14) / 14]  # fmt: skip
    foot = [ball(0.018, 0.018, 0.016, (1.01 * r * np.cos(a), 1.01 * r * np.sin(a), 0.012), 8)
            for a in 2 * np.pi * np.arange(20) / 20]  # fmt: skip
    count = look.pick([5, 6, 8])
    places = [
        (0.5 * r * np.cos(a), 0.5 * r * np.sin(a)) for a in 2 * np.pi * np.arange(count) / count
    ]
    sticks = [cylinder(0.0034, 0.045, 10).move(x, y, h + 0.004) for x, y in places]
    flames = [ball(0.006, 0.006, 0.014, (x, y, h + 0.056), 8) for x, y in places]
    wax = textures.stripes([look.own_color(*GAY), (250, 250, 246)], 4)
    cream = textures.plain((250, 244, 232) if color[2] < 220 else look.own_color("pink", "brown"))
    pieces: Pieces = [(plate, textures.plain((240, 240, 238))), (body, textures.speckles(look.rng,
                      color, 5)), (join([*drops, *foot]), cream), (join(sticks), wax),
                      (join(flames), textures.plain((252, 196, 60)))]  # fmt: skip
    return shape(pieces, [cylinder_part(1.25 * r, 0.007), hull_of(body), hull_of(*sticks)])


def birthday_candle(look: Look) -> Shape:
    """A thin striped candle in a holder shaped like a flower, burning."""
    h = look.between(0.05, 0.065)
    wax = textures.stripes([look.color(*GAY), (250, 250, 246)], 4)
    petals = lobe(cylinder(0.011, 0.008, 24, bevel=0.001), 6, 0.15)
    stick = cylinder(0.0036, h, 12).move(z=0.006)
    flame = ball(0.007, 0.007, 0.014, (0, 0, h + 0.011), 8)
    pieces: Pieces = [(petals, textures.plain((250, 250, 246))), (stick, wax),
                      (flame, textures.plain((252, 196, 60)))]  # fmt: skip
    return put_down(pieces, petals, stick)


CATEGORIES = (
    Category("birthday_candle", birthday_candle, (0.024, 0.024, 0.072), 0.004,
             ("cake candle", "party candle"), ("living",), ("round",), ("pink", "blue")),
    Category("party_hat", party_hat, (0.125, 0.125, 0.155), 0.02, ("birthday hat", "paper hat",
             "cone hat", "cardboard hat"), ("living",), ("tall",), ("red", "blue")),
    Category("balloon", balloon, (0.15, 0.15, 0.31), 0.15, ("party balloon", "birthday balloon"),
             ("living",), ("tall",), ("red", "blue")),
    Category("party_popper", party_popper, (0.05, 0.047, 0.095), 0.015, ("confetti popper",
             "confetti cannon"), ("living",), (), ("red", "gold")),
    Category("christmas_cracker", cracker, (0.27, 0.05, 0.047), 0.03, ("party cracker",
             "paper cracker", "bonbon cracker"), ("living",), (), ("red", "green"), state="lying"),
    Category("wrapping_paper", wrapping_paper, (0.3, 0.06, 0.046), 0.12, ("gift wrap",
             "roll of wrapping paper", "wrapping paper roll", "gift paper", "roll of gift wrap",
             "gift wrap roll"),
             ("living",), (), ("red", "gold"), state="lying"),
    Category("bow", bow, (0.0712, 0.0712, 0.0488), 0.008, ("gift bow", "ribbon bow", "hair bow",
             "red bow"), ("living",), (), ("red", "gold")),
    Category("ribbon", ribbon, (0.09, 0.065, 0.019), 0.03, ("roll of ribbon", "ribbon spool",
             "spool of ribbon", "satin ribbon", "gift ribbon", "ribbon roll", "lace",
             "reel of ribbon", "bias binding", "velcro strip", "lace trim", "pompom trim",
             "elastic roll", "roll of elastic"), ("craft",), (), ("red", "pink"),
             state="lying flat"),
    Category("gift_tag", gift_tag, (0.1, 0.042, 0.0035), 0.003, ("name tag", "label tag",
             "present tag", "paper tag", "do not disturb sign",
             "museum label"), ("living",), ("flat",), ("tan",),
             state="lying flat"),
    Category("birthday_cake", birthday_cake, (0.21, 0.21, 0.125), 0.8, ("cake with candles",
             "candle cake"), ("living", "dining"), ("edible",), ("pink", "white")),
)  # fmt: skip
"""The module's categories."""
