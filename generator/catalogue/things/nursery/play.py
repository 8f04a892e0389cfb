"""Things to play with: soldiers, puppets, masks, puzzles, sand toys."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import flat_foot
from ...build.outlines import ellipse, smooth
from ...build.recipes import Pieces, ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, prism
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

SKIN = ((244, 206, 178), (226, 176, 140), (150, 100, 70))


def toy_soldier(look: Look) -> Shape:
    """A toy soldier at attention on a base, his tall hat on and a rifle at his side."""
    color = look.color("red", "blue", "green", "navy", "olive")
    coat = textures.speckles(look.rng, color, 4)
    plain = look.chance(0.3)  # one cast in one colour
    skin = coat if plain else textures.plain(look.pick(SKIN))
    dark = coat if plain else textures.plain((36, 36, 40))
    pale = coat if plain else textures.plain((244, 242, 236))
    base = cylinder(0.02, 0.004, 22)
    legs = [straight((s * 0.0065, 0, 0.003), (s * 0.006, 0, 0.036), 0.0058, 10) for s in (-1, 1)]
    chest = lathe([(0, 0.033), (0.012, 0.033), (0.0115, 0.045), (0.0145, 0.063), (0.006, 0.069),
                   (0, 0.07)], 18).scale(1, 0.75, 1)  # fmt: skip
    arms = [straight((s * 0.0145, 0, 0.063), (s * 0.016, -0.003, 0.04), 0.004, 8) for s in (-1, 1)]
    head = ball(0.016, 0.016, 0.018, (0, 0, 0.076), 14)
    hat = cylinder(0.0088, 0.022, 16, top=0.0095, bevel=0.001).move(z=0.08)
    belts = [box(0.004, 0.0008, 0.036).turn(1, s * 0.5).move(s * 0.009, -0.0105, 0.034)
             for s in (-1, 1)]  # fmt: skip
    gun = straight((0.02, -0.004, 0.02), (0.02, -0.004, 0.092), 0.0018, 6)
    pieces: Pieces = [(base, textures.plain((70, 110, 60)) if not plain else coat),
                      (join(legs), textures.plain((60, 64, 90)) if not plain else coat),
                      (join([chest, *arms]), coat), (head, skin), (join([hat, gun]), dark),
                      (join(belts), pale)]  # fmt: skip
    return put_down(pieces, base, join([*legs, chest]), join([head, hat]), join([*arms, gun]),
                   factor=look.between(0.85, 1.15))  # fmt: skip


def puppet(look: Look) -> Shape:
    """A hand puppet standing on the rim of its gown, arms out."""
    color = look.color("red", "green", "blue", "purple", "orange", "yellow")
    cloth = textures.fabric(look.rng, color, look.pick([None, tint_color(color, 1.5)]), 24)
    skin = textures.plain(look.pick(SKIN))
    gown = lathe([(0, 0), (0.05, 0), (0.052, 0.006), (0.034, 0.07), (0.024, 0.13), (0, 0.135)], 22)
    arms = [rod([(s * 0.02, 0, 0.118), (s * 0.048, -0.004, 0.116), (s * 0.07, -0.008, 0.126)],
                [0.012, 0.013, 0.012], 10) for s in (-1, 1)]  # fmt: skip
    hands = [ball(0.024, 0.022, 0.026, (s * 0.076, -0.009, 0.13), 10) for s in (-1, 1)]
    head = ball(0.062, 0.06, 0.066, (0, 0, 0.165), 18)
    nose = ball(0.016, 0.022, 0.016, (0, -0.034, 0.163), 10)
    hat = cylinder(0.031, 0.05, 20, top=0.002).turn(0, 0.12).move(0, 0.002, 0.182)
    tip = ball(0.014, 0.014, 0.014, (0, -0.004, 0.232), 8)
    eyes = [ball(0.009, 0.005, 0.01, (s * 0.013, -0.0285, 0.173), 8) for s in (-1, 1)]
    mouth = ball(0.022, 0.006, 0.006, (0, -0.0272, 0.15), 10)
    buttons = [ball(0.009, 0.006, 0.009, (0, -0.031 - 0.008 * n, 0.09 - 0.03 * n), 8)
               for n in range(2)]  # fmt: skip
    other = textures.plain(look.own_color("yellow", "white", "teal", "red"))
    pieces: Pieces = [(join([gown, *arms]), cloth), (join([head, *hands]), skin),
                      (join([nose, mouth]), textures.plain((214, 60, 56))), (hat, other),
                      (join([tip, *buttons]), textures.plain((250, 246, 236))),
                      (join(eyes), textures.plain((34, 32, 34)))]  # fmt: skip
    return put_down(pieces, gown, *arms, join([head, hat]), factor=look.between(0.9, 1.1))


def mask(look: Look) -> Shape:
    """A half mask lying on its back with eye holes painted dark, gold trim and a feather."""
    color = look.color("red", "black", "purple", "gold", "white", "blue", "green")
    upper = smooth([(-0.09, 0.018), (-0.1, 0.05), (-0.06, 0.035), (0, 0.026), (0.06, 0.035),
                    (0.1, 0.05), (0.09, 0.018)], 3)  # fmt: skip
    lower = smooth(
        [
            (0.09, 0.018),
            (0.075, -0.028),
            (0.03, -0.035),
            (0.008, -0.008),
            (0, 0.0),
            (-0.008, -0.008),
            (-0.03, -0.035),
            (-0.075, -0.028),
            (-0.09, 0.018),
        ],
        3,
    )
    outline = np.concatenate([upper[::-1], lower[::-1][1:-1]])

    def vault(p: np.ndarray) -> np.ndarray:
        rise = 0.034 * (1 - (p[:, 0] / 0.105) ** 2)
        return np.column_stack([p[:, :2], p[:, 2] + np.maximum(rise, 0)])

    def layer(points: np.ndarray, low: float, high: float) -> Solid:
        return prism(points, low, high).bend(vault)

    face = layer(outline, 0, 0.004)
    trim = layer(outline * 0.9, 0.0038, 0.0048)
    eyes = [
        layer(ellipse(0.038, 0.019, 16) + np.array([s * 0.042, 0.002]), 0.0045, 0.0056)
        for s in (-1, 1)
    ]
    rims = [
        layer(ellipse(0.05, 0.03, 16) + np.array([s * 0.042, 0.002]), 0.0042, 0.0052)
        for s in (-1, 1)
    ]
    gem = ball(0.013, 0.013, 0.008, (0, 0.014, 0.039), 10)
    gold = textures.plain((220, 178, 90) if color[0] < 190 or color[1] < 140 else (120, 40, 60))
    pieces: Pieces = [(face, gold), (trim, textures.speckles(look.rng, color, 5)),
                      (join(rims), gold), (join(eyes), textures.plain((26, 24, 28))),
                      (gem, textures.plain((200, 40, 70)))]  # fmt: skip
    return put_down(pieces, face, factor=look.between(0.88, 1.12), foot=0.25)


def toy_spade(look: Look) -> Shape:
    """A child's sand spade lying flat, its blade to the left."""
    color = look.color("red", "blue", "yellow", "green", "orange", "pink")
    outline = [(-0.125, 0), (-0.115, -0.024), (-0.04, -0.032), (-0.034, 0), (-0.04, 0.032),
               (-0.115, 0.024)]  # fmt: skip
    blade = prism(outline, 0, 0.004).turn(1, 0.06).move(z=0.0)
    blade = blade.move(z=-float(blade.bounds[0, 2]))
    shaft = rod([(-0.07, 0, 0.007), (-0.02, 0, 0.012), (0.04, 0, 0.0075), (0.09, 0, 0.0075)],
                0.0075, 10)  # fmt: skip
    grip = straight((0.092, -0.028, 0.0075), (0.092, 0.028, 0.0075), 0.0075, 10)
    paint = textures.speckles(look.rng, color, 4)
    pieces: Pieces = [(join([blade, shaft, grip]), paint)]
    return put_down(pieces, blade, shaft, grip, factor=look.between(0.85, 1.12))


def beach_ball(look: Look) -> Shape:
    """An inflated beach ball in coloured sectors with white caps."""
    d = look.between(0.16, 0.22)
    first = look.color("red", "blue", "green", "pink", "orange", "yellow")
    panels = [first, (248, 247, 242), look.own_color("yellow", "sky"), (248, 247, 242),
              look.own_color("blue", "green", "orange"), (248, 247, 242)]  # fmt: skip
    tile = textures.stripes(panels, 1, upright=True, side=96).copy()
    tile[:7] = tile[-7:] = (248, 247, 242)
    tilt = look.between(0.3, 0.7)
    body = ellipsoid(d, d, d, 30, 18).turn(0, tilt).turn(2, look.between(0, 6)).move(z=0.49 * d)
    return shape([(body, tile)], [flat_foot(body.vertices, 0.03)])


CATEGORIES = (
    Category("toy_soldier", toy_soldier, (0.05, 0.04, 0.1), 0.03, ("soldier", "tin soldier",
                 "lead soldier", "army man", "plastic soldier", "soldier figure",
                 "painted miniature", "miniature", "wargaming miniature", "gaming miniature",
                 "warhammer figure", "wargame miniature", "warhammer miniature"),
             ("toys",), ("tall",),
             ("red", "blue")),
    Category("puppet", puppet, (0.175, 0.106, 0.24), 0.12, ("hand puppet", "glove puppet",
             "marionette", "finger puppet"), ("toys",), ("tall",), ("red", "green")),
    Category("mask", mask, (0.198, 0.084, 0.042), 0.06, ("carnival mask", "venetian mask",
             "theatre mask", "theater mask", "masquerade mask", "party mask",),
             ("toys", "living"), (), ("gold", "red"), state="lying flat"),
    Category("toy_spade", toy_spade, (0.225, 0.065, 0.02), 0.06, ("sand spade", "spade",
             "beach spade", "sand shovel", "toy shovel", "plastic shovel", "beach shovel"),
             ("toys",), (), ("red", "blue"), state="lying flat"),
    Category("beach_ball", beach_ball, (0.19, 0.19, 0.19), 0.09, ("inflatable ball",
             "inflatable beach ball", "water wings", "inflatable armband"), ("toys",), ("round",
             "big"), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
