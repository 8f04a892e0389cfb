"""What holds and curls hair."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part, ring_parts
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

HUES = ("pink", "black", "red", "teal", "purple", "gold", "navy", "white", "brown")


def hair_clip(look: Look) -> Shape:
    """A claw clip for hair lying with its teeth down, or a flower clip."""
    color = look.color(*HUES)
    k = look.between(0.85, 1.25)
    teeth: list[Solid] = []
    for s in (-1, 1):
        for n in range(6):
            x = 0.009 * (n - 2.5)
            teeth.append(rod([(x, s * 0.006, 0.03), (x, s * 0.02, 0.018), (x, s * 0.012, 0.001)],
                             [0.0038, 0.0034, 0.0016], 7))  # fmt: skip
    bars = [
        straight((-0.026, s * 0.014, 0.026), (0.026, s * 0.014, 0.026), 0.0045, 8) for s in (-1, 1)
    ]
    wings = [ball(0.032, 0.006, 0.02, (0, 0, 0), 12).turn(0, s * 0.6).move(0, s * 0.009, 0.041)
             for s in (-1, 1)]  # fmt: skip
    spring = straight((-0.014, 0, 0.031), (0.014, 0, 0.031), 0.0045, 10)
    skin = textures.spots(look.rng, color, tint_color(color, 0.6), 0.1)
    pieces: Pieces = [
        (join([*teeth, *bars, *wings]), skin),
        (spring, textures.plain((200, 202, 206))),
    ]
    return put_down(pieces, join([*teeth, *bars]), join(wings), factor=k)


def scrunchie(look: Look) -> Shape:
    """A hair tie of gathered cloth lying flat."""
    color = look.color(*HUES, "mustard", "sage")
    r = look.between(0.026, 0.036)
    n, m = 44, 8
    rings = []
    for k in range(n):
        a = 2 * np.pi * k / n
        grow = 0.011 * (1 + 0.28 * np.sin(11 * a) + 0.12 * np.sin(5 * a + 1))
        b = 2 * np.pi * np.arange(m) / m
        away = r + grow * np.cos(b)
        rings.append(np.column_stack([away * np.cos(a), away * np.sin(a), grow * np.sin(b) + 0.01]))
    body = loft(np.stack(rings), None, loop=True)
    cloth = textures.stripes([color, tint_color(color, 0.78), color], 22, side=128)
    wall = ring_parts([(r + 0.01, 0), (r + 0.011, 0.018)], [(r - 0.009, 0.018), (r - 0.009, 0)], 8)
    return shape([(body, cloth)], wall)


def headband(look: Look) -> Shape:
    """A headband lying: a stiff arch, some with a bow."""
    color = look.color(*HUES)
    k = look.between(0.9, 1.1)
    a = np.linspace(-0.35, np.pi + 0.35, 22)
    path = np.column_stack([0.066 * np.cos(a), 0.07 * np.sin(a), np.full(22, 0.0092)])
    flat = tube(path, 0.009, 8)
    pieces: Pieces = [(flat, textures.fabric(look.rng, color))]
    bow = [ball(0.03, 0.016, 0.02, (0.042 + s * 0.014 * 0.7, 0.054 - s * 0.014, 0.014), 10)
           for s in (-1, 1)]  # fmt: skip
    if look.chance(0.6):
        knot = ball(0.012, 0.012, 0.016, (0.042, 0.054, 0.015), 8)
        pieces.append((join([*bow, knot]), textures.plain(look.own_color("white", "gold", "red"))))
    v = flat.vertices
    parts = [hull_part(v[(v[:, 0] < -0.03)]), hull_part(v[(v[:, 0] > 0.03)]),
             hull_part(v[(np.abs(v[:, 0]) < 0.04) & (v[:, 1] > 0.03)])]  # fmt: skip
    return shape(pieces, parts).scale(k)


def bobby_pin(look: Look) -> Shape:
    """A hair grip lying: a bent wire, one leg waved."""
    color = look.color("black", "brown", "gold", "silver", "copper", "pink")
    path = smooth(
        [
            (0.026, 0.0022, 0.001),
            (0.012, 0.003, 0.001),
            (0.004, 0.0012, 0.001),
            (-0.004, 0.003, 0.001),
            (-0.012, 0.0012, 0.001),
            (-0.024, 0.0022, 0.001),
            (-0.0275, 0.0, 0.001),
            (-0.024, -0.0024, 0.001),
            (0.028, -0.0012, 0.001),
        ],
        3,
    )
    wire = tube(path, 0.0009, 6)
    tips = [
        ball(0.003, 0.003, 0.0026, (x, y, 0.0011), 8)
        for x, y in ((0.026, 0.0022), (0.028, -0.0012))
    ]
    return put_down([(join([wire, *tips]), look.surface(color, "metal"))],
                   factor=look.between(0.85, 1.3))  # fmt: skip


def hair_roller(look: Look) -> Shape:
    """A hair roller lying: a pierced tube with rings at its ends."""
    color = look.color("pink", "purple", "green", "blue", "yellow", "red")
    r, long = look.between(0.014, 0.022), look.between(0.058, 0.068)
    body = lathe(
        [(0.8 * r, -long / 2), (r, -long / 2), (r, long / 2), (0.8 * r, long / 2)], 24, loop=True
    )
    rims = [lathe([(0.78 * r, z), (1.1 * r, z), (1.1 * r, z + 0.004), (0.78 * r, z + 0.004)], 24,
                  loop=True) for z in (-long / 2, long / 2 - 0.004)]  # fmt: skip
    whole = [(s.turn(1, np.pi / 2).move(z=1.08 * r), t) for s, t in (
        (body, prints.mesh_holes(color, tint_color(color, 0.4), 10, 14)),
        (join(rims), textures.plain(tint_color(color, 0.85))))]  # fmt: skip
    return put_down(whole, join([s for s, _ in whole]))


def _cord(x: float, z: float) -> Solid:
    """Return a short power cord that leaves to the right from (x, 0, z)."""
    return rod(
        [
            (x, 0, z),
            (x + 0.02, 0, z - 0.004),
            (x + 0.045, 0.02, 0.0035),
            (x + 0.03, 0.05, 0.0032),
            (x, 0.058, 0.0032),
        ],
        0.003,
        7,
    )


def curling_iron(look: Look) -> Shape:
    """A curling iron lying: a metal rod with a clip, a grip, a cord."""
    color = look.color("black", "pink", "purple", "white", "teal", "red")
    rod_ = straight((-0.15, 0, 0.0165), (0.0, 0, 0.0165), 0.0105, 16)
    tip = straight((-0.165, 0, 0.0165), (-0.149, 0, 0.0165), [0.006, 0.0095], 14)
    clip = rod(
        [(-0.135, 0, 0.0265), (-0.05, 0, 0.0275), (0.0, 0, 0.0285), (0.02, 0, 0.04)], 0.0045, 8
    )
    grip = straight((0.0, 0, 0.0165), (0.12, 0, 0.015), [0.0165, 0.0145], 18)
    ring = straight((-0.002, 0, 0.0165), (0.006, 0, 0.0165), 0.0172, 18)
    metal = textures.brushed_metal(look.rng, look.pick([(200, 204, 210), (206, 172, 96)]))
    dark = textures.plain((46, 46, 50))
    pieces: Pieces = [(join([rod_, clip]), metal), (join([tip, ring, _cord(0.118, 0.015)]), dark),
                      (grip, look.surface(color, "plastic"))]  # fmt: skip
    return put_down(pieces, rod_, grip, factor=look.between(0.85, 1.05))


def straightener(look: Look) -> Shape:
    """A hair straightener lying open: two arms with plates that meet at a hinge."""
    color = look.color("black", "pink", "purple", "white", "gold", "teal")
    low = block(0.24, 0.03, 0.014, 0.008, 0.003)
    up = block(0.24, 0.03, 0.014, 0.008, 0.003).move(-0.12).turn(1, 0.14).move(0.12, 0, 0.0135)
    plates = [
        box(0.085, 0.024, 0.002).move(-0.07, 0, 0.0135),
        box(0.085, 0.024, 0.002).move(-0.19, 0, -0.0015).turn(1, 0.14).move(0.12, 0, 0.0135),
    ]
    hinge = cylinder(0.012, 0.032, 16).move(z=-0.016).turn(0, np.pi / 2).move(0.112, 0, 0.0125)
    knob = cylinder(0.005, 0.003, 12).move(0.03, 0, 0.0138)
    dark = textures.plain((48, 48, 52))
    pieces: Pieces = [(join([low, up]), look.surface(color, "plastic")),
                      (join(plates), textures.brushed_metal(look.rng, (190, 160, 130))),
                      (join([hinge, knob, _cord(0.12, 0.01)]), dark)]  # fmt: skip
    return put_down(pieces, low, up, factor=look.between(0.9, 1.08))


CATEGORIES = (
    Category("hair_clip", hair_clip, (0.06, 0.05, 0.05), 0.015, ("claw clip", "hairclip",
             "hair claw", "barrette", "hair slide", "barber's cape clip"), ("vanity",), (),
             ("pink", "black")),
    Category("hair_tie", scrunchie, (0.0872, 0.0858, 0.0254), 0.006, ("scrunchie",
             "hair elastic", "hair scrunchie", "hair bobble", "hair extension"),
             ("vanity",), ("flat",), ("pink", "black"), state="lying flat"),
    Category("headband", headband, (0.15, 0.105, 0.02), 0.03, ("hairband", "alice band",
             "head band", "reindeer antlers", "snorkel band", "sweat headband"), ("vanity",), (),
             ("pink", "black"),
             state="lying flat"),
    Category("bobby_pin", bobby_pin, (0.0644, 0.00789, 0.00263), 0.001, ("hair pin", "hairpin",
             "hair grip", "kirby grip"), ("vanity",), (), ("black",), state="lying flat"),
    Category("hair_roller", hair_roller, (0.063, 0.039, 0.038), 0.012, ("hair curler", "curler",
             "velcro roller"), ("vanity",), (), ("pink", "purple"), state="lying"),
    Category("curling_iron", curling_iron, (0.31, 0.08, 0.04), 0.3, ("curling tongs",
             "curling wand", "hair tongs"), ("vanity",), (), ("black", "pink"), state="lying"),
    Category("hair_straightener", straightener, (0.28, 0.08, 0.06), 0.35, ("straightener",
             "flat iron", "hair iron", "straightening iron", "hair straighteners"), ("vanity",),
             (), ("black", "pink"), state="lying"),
)  # fmt: skip
"""The module's categories."""
