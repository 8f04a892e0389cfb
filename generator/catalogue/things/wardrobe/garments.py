"""Clothes folded or laid on a table: shirts, trousers, socks, ties, belts."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part
from ...build.forms import above
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, leather, pad, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..nature.gardening import hand_shape

TONES = ("white", "navy", "red", "gray", "teal", "black", "mustard", "pink", "green", "sky")


def _pile(x: float, y: float, h: float, count: int) -> Solid:
    """Return folded cloth: rounded layers on each other."""
    t = h / count
    return join([pad(x * (1 - 0.008 * n), y * (1 - 0.012 * n), t, 0.012, soft=0.5, steps=4)
                 .move(0, 0.002 * n, n * t) for n in range(count)])  # fmt: skip


def t_shirt(look: Look) -> Shape:
    """A folded T-shirt, its neck in front."""
    x, y, h = look.between(0.21, 0.25), look.between(0.25, 0.29), look.between(0.028, 0.04)
    color = look.color(*TONES)
    body = _pile(x, y, h, 3)
    collar = torus(0.042, 0.005, 26, 6).scale(1.25, 0.75, 0.6).move(0, y / 2 - 0.055, h)
    inside = cylinder(0.04, 0.0012, 26).scale(1.25, 0.75, 1).move(0, y / 2 - 0.055, h - 0.0008)
    print_ = look.chance(0.5)
    pieces: Pieces = [(body, textures.fabric(look.rng, color)),
                      (collar, textures.plain(tint_color(color, 0.85))),
                      (inside, textures.plain(tint_color(color, 0.6)))]  # fmt: skip
    if print_:
        mark = cylinder(0.045, 0.001, 26).move(0, -0.04, h - 0.0005)
        pieces.append((mark, textures.plain(look.own_color("red", "yellow", "white", "teal"))))
    return put_down(pieces, body)


def shirt(look: Look) -> Shape:
    """A folded shirt with a collar and buttons."""
    x, y, h = look.between(0.21, 0.25), look.between(0.27, 0.31), look.between(0.03, 0.042)
    color = look.color("white", "sky", "pink", "navy", "gray", "green")
    cloth = (textures.stripes([color, color, tint_color(color, 0.75)], 12, upright=True, side=128)
             if look.chance(0.4) else textures.fabric(look.rng, color))  # fmt: skip
    body = _pile(x, y, h, 3)
    at = y / 2 - 0.05
    lapels = [prism([(0, -0.04), (s * 0.055, -0.012), (s * 0.05, 0.026), (s * 0.012, 0.03)][::s], 0,
                    0.006).move(0, at, h - 0.001) for s in (1, -1)]  # fmt: skip
    band = torus(0.04, 0.007, 24, 6).scale(1.1, 0.7, 1).move(0, at + 0.022, h)
    strip = box(0.022, y - 0.1, 0.0014).move(0, -0.045, h - 0.0005)
    buttons = [cylinder(0.0055, 0.002, 14).move(0, at - 0.06 - 0.05 * n, h) for n in range(4)]
    return put_down(
        [
            (body, cloth),
            (join([*lapels, band, strip]), textures.plain(tint_color(color, 1.08))),
            (
                join(buttons),
                textures.plain((244, 242, 236) if sum(color) < 500 else (120, 110, 104)),
            ),
        ],
        body,
    )


def sweater(look: Look) -> Shape:
    """A folded knitted sweater, thick, its ribbed neck in front."""
    x, y, h = look.between(0.24, 0.29), look.between(0.26, 0.3), look.between(0.06, 0.08)
    color = look.color("mustard", "gray", "cream", "red", "navy", "green", "teal", "brown")
    knit = textures.knitting(look.rng, color, 30)
    body = _pile(x, y, h, 3)
    neck = torus(0.045, 0.0095, 26, 8).scale(1.25, 0.75, 0.8).move(0, y / 2 - 0.07, h - 0.001)
    inside = cylinder(0.042, 0.0012, 26).scale(1.25, 0.75, 1).move(0, y / 2 - 0.07, h - 0.0006)
    stripes = [box(x - 0.03, 0.014, 0.001).move(0, -0.06 - 0.028 * n, h - 0.0003) for n in range(2)]
    other = textures.plain(tint_color(color, 0.6) if sum(color) > 330 else (240, 234, 220))
    pieces: Pieces = [(body, knit), (neck, knit), (inside, textures.plain(tint_color(color, 0.5)))]
    if look.chance(0.5):
        pieces.append((join(stripes), other))
    return put_down(pieces, body)


def jeans(look: Look) -> Shape:
    """Folded jeans with a waistband, a pocket and orange seams."""
    x, y, h = look.between(0.2, 0.24), look.between(0.27, 0.31), look.between(0.035, 0.05)
    color = look.color("navy", "blue", "black", "gray", "indigo")
    denim = textures.scratches(look.rng, color, tint_color(color, 1.35), 200)
    body = _pile(x, y, h, 2)
    waist = block(x - 0.012, 0.03, 0.006, 0.006, 0.002).move(0, y / 2 - 0.02, h - 0.001)
    pocket = prism([(-0.045, 0.05), (-0.045, -0.02), (0, -0.05), (0.045, -0.02), (0.045, 0.05)], 0,
                   0.002).move(0, 0.03, h - 0.0006)  # fmt: skip
    run = [(-0.039, 0.076, 0), (-0.039, 0.013, 0), (0, -0.013, 0), (0.039, 0.013, 0)]
    seam = tube(np.array([*run, (0.039, 0.076, 0)]) + np.array([0, 0, h + 0.0016]), 0.0011, 5)
    loops = [
        box(0.008, 0.034, 0.003).move(i * x * 0.33, y / 2 - 0.02, h + 0.004) for i in (-1, 0, 1)
    ]
    knob = cylinder(0.007, 0.003, 16).move(0.45 * x - 0.02, y / 2 - 0.02, h + 0.004)
    return put_down(
        [
            (join([body, waist, *loops]), denim),
            (pocket, textures.plain(tint_color(color, 1.15))),
            (join([seam, knob]), textures.plain((206, 140, 70))),
        ],
        body,
    )


def sock(look: Look) -> Shape:
    """A sock lying flat, its toe to the left."""
    color = look.color(*TONES, "orange", "purple")
    other = look.own_color("white", "red", "navy", "yellow")
    side = smooth([(0.03, 0.1), (-0.03, 0.1), (-0.03, 0.0), (-0.045, -0.025), (-0.095, -0.036),
                   (-0.108, -0.06), (-0.09, -0.08), (-0.02, -0.08), (0.026, -0.062), (0.031, -0.02),
                   (0.03, 0.098)], 3)[:-1]  # fmt: skip
    body = prism(side, 0, 0.009)
    top = prism(side * 0.94 - [0.001, 0.0], 0.0088, 0.0115)
    cuff = pad(0.066, 0.03, 0.0135, 0.006, soft=0.5).move(0, 0.09)
    toe = ball(0.042, 0.046, 0.0135, (-0.088, -0.058, 0.0062), 14)
    heel = ball(0.034, 0.036, 0.0132, (0.016, -0.06, 0.0062), 14)
    knit = textures.stripes([color, color, other], 6, side=96) if look.chance(0.4) else (
        textures.knitting(look.rng, color, 26))  # fmt: skip
    pieces: Pieces = [(join([body, top]), knit), (join([cuff, toe, heel]), textures.plain(
        tint_color(color, 0.7) if sum(color) > 250 else other))]  # fmt: skip
    leg = body.vertices[body.vertices[:, 1] > -0.045]
    foot = body.vertices[body.vertices[:, 1] < -0.018]
    return shape(pieces, [hull_part(leg), hull_part(foot), hull_part(cuff.vertices)]).scale(
        look.between(0.85, 1.12))  # fmt: skip


def glove(look: Look) -> Shape:
    """A knitted glove lying flat."""
    return hand_shape(look, ("gray", "red", "navy", "black", "teal", "mustard"), 0.05, knit=True)


def rubber_glove(look: Look) -> Shape:
    """A rubber glove lying flat, with a long cuff."""
    return hand_shape(look, ("yellow", "yellow", "pink", "blue", "green"), 0.09, knit=False)


def mitten(look: Look) -> Shape:
    """A knitted mitten lying flat, or an oven mitt."""
    color = look.color("red", "gray", "navy", "teal", "mustard", "green", "white")
    knit = (textures.knitting(look.rng, color, 24) if look.chance(0.6) else
            textures.fabric(look.rng, color, (246, 244, 238), 20))  # fmt: skip
    palm = pad(0.15, 0.1, 0.026, 0.048, soft=0.5, steps=6)
    thumb = pad(0.085, 0.04, 0.024, 0.0195, soft=0.5).turn(2, 0.75).move(0.014, -0.058)
    cuff = pad(0.055, 0.108, 0.029, 0.008, soft=0.4).move(0.09)
    pieces: Pieces = [(join([palm, thumb]), knit), (cuff, textures.plain(tint_color(color, 0.65)))]
    return put_down(pieces, palm, thumb, cuff, factor=look.between(0.9, 1.12))


def beanie(look: Look) -> Shape:
    """A knitted hat lying on its rim: a turned-up brim, a pompom."""
    color = look.color("red", "navy", "gray", "mustard", "teal", "black", "orange", "green")
    k = look.between(0.9, 1.1)
    crown = lathe([(0, 0), (0.088, 0), (0.09, 0.05), (0.07, 0.1), (0.03, 0.126), (0, 0.13)], 30)
    brim = lathe(
        [(0.08, 0), (0.094, 0), (0.097, 0.02), (0.094, 0.045), (0.08, 0.045)], 30, loop=True
    )
    tuft = ball(0.05, 0.05, 0.046, (0, 0, 0.142), 12)
    pieces: Pieces = [
        (crown.scale(1, 0.85, 1), textures.knitting(look.rng, color, 22)),
        (
            brim.scale(1, 0.85, 1),
            textures.stripes([color, tint_color(color, 0.8)], 40, upright=True, side=160),
        ),
    ]
    if look.chance(0.6):
        pieces.append((tuft, textures.scratches(look.rng, (240, 236, 226), (206, 200, 190), 90)))
    return put_down(pieces, pieces[0][0], pieces[1][0], factor=k)


def tie(look: Look) -> Shape:
    """A necktie lying flat: its knot to the right, its point to the left."""
    color = look.color("navy", "red", "green", "purple", "black", "gray", "teal")
    other = look.own_color("white", "gold", "silver", "sky")
    silk = textures.stripes([color, color, color, other], 9, upright=True, side=128)
    blade_ = prism(
        [(-0.23, 0), (-0.19, -0.04), (0.16, -0.016), (0.16, 0.016), (-0.19, 0.04)], 0, 0.004
    )
    tail = prism([(-0.17, 0.002), (-0.14, -0.022), (0.15, -0.01), (0.15, 0.014), (-0.14, 0.026)], 0,
                 0.0035).turn(2, -0.11).move(0, 0.012)  # fmt: skip
    knot = prism([(0.15, -0.016), (0.2, -0.024), (0.2, 0.024), (0.15, 0.016)], 0, 0.014, 0.004)
    loop = rod(
        [
            (0.19, -0.018, 0.005),
            (0.25, -0.045, 0.004),
            (0.29, 0, 0.004),
            (0.25, 0.045, 0.004),
            (0.19, 0.018, 0.005),
        ],
        0.0045,
        6,
    )
    cloth = textures.plain(tint_color(color, 0.8))
    return put_down([(blade_.move(z=0.0034), silk), (tail, cloth), (knot, silk), (loop, cloth)],
                   join([blade_, tail]), knot, loop, factor=look.between(0.75, 0.95))  # fmt: skip


def bow_tie(look: Look) -> Shape:
    """A bow tie lying flat."""
    color = look.color("black", "red", "navy", "purple", "green", "white", "gold")
    cloth = (textures.spots(look.rng, color, tint_color(color, 1.7), 0.12) if look.chance(0.4)
             else textures.fabric(look.rng, color))  # fmt: skip
    wings = [
        loft(
            np.stack(
                [
                    np.array(
                        [
                            (s * x, -w, 0.009 - t),
                            (s * x, w, 0.009 - t),
                            (s * x, w, 0.009 + t),
                            (s * x, -w, 0.009 + t),
                        ]
                    )
                    for x, w, t in (
                        (0.004, 0.011, 0.006),
                        (0.03, 0.024, 0.0085),
                        (0.055, 0.026, 0.004),
                    )
                ]
            ),
            np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]),
        )
        for s in (-1, 1)
    ]
    knot = pad(0.022, 0.026, 0.018, 0.006, soft=0.4)
    return put_down([(join(wings), cloth), (knot, textures.plain(tint_color(color, 0.85)))],
                   *wings, knot, factor=look.between(0.9, 1.15))  # fmt: skip


def belt(look: Look) -> Shape:
    """A leather belt rolled up, standing on its edge, with its buckle."""
    color = look.color("brown", "black", "tan", "navy", "maroon", "white")
    a = np.linspace(0, 2 * np.pi * 3.2, 90)
    r = 0.018 + 0.0052 * a / (2 * np.pi) * 1.25
    path = np.column_stack([r * np.cos(a), r * np.sin(a)])
    way = np.gradient(path, axis=0)
    side = np.column_stack([-way[:, 1], way[:, 0]]) / np.linalg.norm(way, axis=1)[:, None] * 0.0017
    w = 0.032
    rings = [np.array([(*(p - n), 0), (*(p + n), 0), (*(p + n), w), (*(p - n), w)])
             for p, n in zip(path, side, strict=True)]  # fmt: skip
    coil = loft(np.stack(rings), np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]))
    end = path[-1]
    frame = torus(0.016, 0.0026, 20, 6).turn(0, np.pi / 2).scale(1, 1, 1.15)
    turn = float(np.arctan2(*way[-1][::-1]))
    buckle = frame.turn(2, turn).move(float(end[0]), float(end[1]), w / 2)
    buckle = buckle.move(z=max(0.0, -float(buckle.bounds[0, 2])))
    prong = straight(
        (float(end[0]) - 0.012 * np.cos(turn), float(end[1]) - 0.012 * np.sin(turn), w / 2),
        (float(end[0]) + 0.018 * np.cos(turn), float(end[1]) + 0.018 * np.sin(turn), w / 2),
        0.0018,
        6,
    )
    metal = textures.brushed_metal(look.rng, look.pick([(206, 172, 96), (190, 194, 200)]))
    made = shape([(coil, leather(look.rng, color)), (join([buckle, prong]), metal)],
                 [hull_part(coil.vertices), hull_part(above(buckle.vertices))])  # fmt: skip
    return made.scale(look.between(0.92, 1.15))


CATEGORIES = (
    Category("t_shirt", t_shirt, (0.23, 0.27, 0.037), 0.16, ("t-shirt", "tshirt", "tee shirt",
             "folded t-shirt", "folded tshirt", "tee"), ("living",), ("big",
             "support"), ("white", "navy"), state="lying folded"),
    Category("shirt", shirt, (0.23, 0.29, 0.045), 0.22, ("folded shirt", "dress shirt", "blouse",
             "button down shirt", "polo shirt"), ("living",), ("big", "support"), ("white",
             "sky"), state="lying folded"),
    Category("sweater", sweater, (0.265, 0.28, 0.078), 0.5, ("folded sweater", "jumper",
             "pullover", "cardigan", "wool sweater", "hoodie", "knitted sweater"), ("living",),
             ("big", "support"), ("mustard", "gray"), state="lying folded"),
    Category("jeans", jeans, (0.22, 0.29, 0.048), 0.6, ("pair of jeans", "folded jeans", "trousers",
             "pants", "folded trousers"), ("living",), ("big", "support"), ("navy",
             "blue"), state="lying folded"),
    Category("sock", sock, (0.137, 0.18, 0.0135), 0.03, ("ankle sock", "wool sock", "knitted sock",
             "baby sock", "pair of socks", "trouser sock", "leg warmer"), ("living",), (),
             ("white", "red"),
             state="lying flat"),
    Category("glove", glove, (0.22, 0.13, 0.023), 0.05, ("knitted glove", "wool glove",
             "winter glove", "leather glove"), ("living",), (), ("gray", "red"),
             state="lying flat"),
    Category("rubber_glove", rubber_glove, (0.266, 0.146, 0.0237), 0.05, ("latex glove",
             "cleaning glove", "dish glove", "household glove",), ("kitchen",),
             (), ("yellow",), state="lying flat"),
    Category("mitten", mitten, (0.195, 0.14, 0.029), 0.06, ("winter mitten", "pot holder mitt",
             "wool mitten"),
             ("living", "kitchen"), (), ("red", "gray"),
             state="lying flat"),
    Category("beanie", beanie, (0.194, 0.165, 0.15), 0.09, ("bobble hat", "winter hat",
             "wool hat", "knit hat", "knitted hat", "woolly hat", "knit cap", "wool cap",
             "watch cap", "snood", "hair net"),
             ("living",), ("big",), ("red", "navy")),
    Category("tie", tie, (0.44, 0.085, 0.012), 0.06, ("necktie", "neck tie", "silk tie",
                 "cravat", "groom's tie"),
             ("living",), ("big",), ("navy", "red"), state="lying flat"),
    Category("bow_tie", bow_tie, (0.113, 0.053, 0.0185), 0.02, ("bowtie", "dickie bow"),
             ("living",), (), ("black", "red"), state="lying flat"),
    Category("belt", belt, (0.0765, 0.0857, 0.0437), 0.18, ("leather belt", "rolled belt",
             "waist belt", "camera strap", "razor strop", "strop", "guitar strap",
             "anti-static wrist strap"), ("living",), (), ("brown", "black"),
             state="lying rolled up"),
)  # fmt: skip
"""The module's categories."""
