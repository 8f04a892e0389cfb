"""Bottles, tubes, cans and sticks of the bathroom."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.outlines import rectangle
from ...build.recipes import Pieces, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft
from ...surfaces import labels, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.ink import canvas, disc, fill, write
from ...surfaces.look import Look
from ...surfaces.textures import Tile


def _front(look: Look, words: tuple[str, ...], color: RGB) -> Tile:
    """Return a label for a front: a title on a ground that suits ``color``."""
    pale = sum(color) > 480
    ground = tint_color(color, 0.92) if pale else color
    ink = tint_color(color, 0.35) if pale else (250, 250, 246)
    image = canvas(72, 112, ground)
    kind = int(look.rng.integers(3))
    other = look.own_color("teal", "gold", "pink", "navy", "green", "orange")
    if kind == 0:
        disc(image, 0.5, 0.68, 0.14, other)
        disc(image, 0.5, 0.68, 0.08, tint_color(other, 1.5))
    elif kind == 1:
        fill(image, 0, 0.58, 1, 0.05, other)
        fill(image, 0, 0.66, 1, 0.02, other)
    else:
        fill(image, 0.1, 0.52, 0.8, 0.34, other)
    write(image, look.pick(words), 0.5, 0.3, 0.14, ink, bold=True)
    fill(image, 0.25, 0.41, 0.5, 0.015, ink)
    return image


def _bottle(
    look: Look, words: tuple[str, ...], colors: tuple[str, ...], h: float, *, cap: str = "flip"
) -> Shape:
    """A flat-oval plastic bottle; ``cap`` is "flip", "pump" or "screw"."""
    color = look.color(*colors)
    x, y, h = look.between(0.056, 0.07), look.between(0.034, 0.042), h * look.between(0.9, 1.1)
    outline = rectangle(1, 1, 0.48, 6)
    waist = look.pick([1.0, 1.0, 0.93])
    levels = [(0.93, 0.0), (1.0, 0.03), (waist, 0.5), (1.0, 0.85), (0.8, 0.95), (0.42, 1.0)]
    body = loft(np.stack([np.column_stack([outline * [x * f, y * f], np.full(len(outline), h * z)])
                          for f, z in levels]), outline)  # fmt: skip
    label = box(0.72 * x, 0.0012, 0.56 * h).move(0, -0.5 * y * waist - 0.0002, 0.18 * h)
    lid = tint_color(color, 0.6) if look.chance(0.5) else (246, 246, 244)
    pieces: Pieces = [(body, look.surface(color, "plastic")), (label, _front(look, words, color))]
    if cap == "pump":
        neck = cylinder(0.4 * y, 0.016, 18, bevel=0.002).move(z=h - 0.002)
        stem = cylinder(0.004, 0.024, 10).move(z=h + 0.012)
        head = join(
            [
                block(0.02, 0.016, 0.01, 0.005, 0.002),
                straight((0, 0, 0.006), (0, -0.032, 0.003), 0.004),
            ]
        ).move(z=h + 0.034)
        top = join([neck, stem, head])
    elif cap == "screw":
        top = cylinder(0.38 * y, 0.02, 20, bevel=0.0015).move(z=h - 0.002)
    else:
        top = block(0.6 * x, 0.7 * y, 0.022, 0.45 * y, 0.002).move(z=h - 0.004)
    pieces.append((top, textures.plain(lid)))
    return put_down(pieces, body, top)


def _tube(look: Look, words: tuple[str, ...], colors: tuple[str, ...], h: float) -> Shape:
    """A soft tube standing on its cap, flat at its upper end."""
    color = look.color(*colors)
    r, h = look.between(0.02, 0.026), h * look.between(0.88, 1.12)
    outline = rectangle(2, 2, 0.98, 7)
    levels = [
        (r, r, 0.022),
        (r, r, 0.045),
        (1.05 * r, 0.8 * r, 0.5 * h),
        (1.2 * r, 0.35 * r, 0.9 * h),
        (1.22 * r, 0.0016, 0.96 * h),
        (1.22 * r, 0.0016, h),
    ]
    body = loft(np.stack([np.column_stack([outline * [a, b], np.full(len(outline), z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    cap = cylinder(0.92 * r, 0.024, 26, bevel=0.0015)
    label = loft(np.stack([np.array([(-a, -b - 0.0004, z), (a, -b - 0.0004, z), (a, -b + 0.002, z),
                                     (-a, -b + 0.002, z)]) for a, b, z in (
                 (0.55 * r, 1.01 * r, 0.04), (0.6 * r, 0.83 * r, 0.5 * h),
                 (0.66 * r, 0.45 * r, 0.86 * h))]),
                 np.array([(-r, -1.0), (r, -1.0), (r, 1.0), (-r, 1.0)]))  # fmt: skip
    low = label.vertices[:, 2].min()
    uv = np.column_stack([(label.vertices[:, 0] / (1.32 * r)) + 0.5,
                          (label.vertices[:, 2] - low) / np.ptp(label.vertices[:, 2])])  # fmt: skip
    label = Solid(label.vertices, label.faces, np.clip(uv, 0, 1))
    lid = look.pick([(246, 246, 244), tint_color(color, 0.55), (206, 172, 96)])
    return put_down([(body, look.surface(color, "plastic")), (cap, textures.plain(lid)),
                    (label, _front(look, words, color))], cap, body)  # fmt: skip


def _aerosol(
    look: Look, words: tuple[str, ...], colors: tuple[str, ...], r: float, h: float
) -> Shape:
    """A spray can with a domed shoulder and a cap."""
    color = look.color(*colors)
    k = look.between(0.9, 1.1)
    print_ = labels.label(
        look.rng,
        look.pick(words),
        look.own_color("blue", "red", "green", "black", "teal", "purple"),
        color,
    )
    body = lathe([(0, 0), (r, 0), (r, h), (0, h)], 30, v=[0, 0, 1, 1])
    dome = lathe([(0, h - 0.001), (r, h - 0.001), (0.8 * r, h + 0.01), (0, h + 0.012)], 28)
    cap = cylinder(0.78 * r, 0.032, 26, bevel=0.003).move(z=h + 0.006)
    lid = look.pick([(244, 244, 242), (60, 62, 68), tint_color(color, 0.6)])
    made = shape([(body, print_), (dome, textures.brushed_metal(look.rng, (204, 206, 210))),
                  (cap, textures.plain(lid))], [cylinder_part(r, h), hull_of(cap)])  # fmt: skip
    return made.scale(k)


def shampoo(look: Look) -> Shape:
    """A shampoo bottle with a flip cap."""
    return _bottle(look, ("SHAMPOO",), ("green", "pink", "orange", "sky", "white", "purple"), 0.175)


def conditioner(look: Look) -> Shape:
    """A bottle of hair conditioner."""
    return _bottle(
        look, ("CONDITION",), ("white", "cream", "teal", "gold", "pink", "lavender"), 0.165
    )


def body_lotion(look: Look) -> Shape:
    """A bottle of body lotion with a pump."""
    return _bottle(
        look,
        ("LOTION", "BODY MILK"),
        ("white", "cream", "pink", "sky", "sage", "yellow"),
        0.15,
        cap="pump",
    )


def sunscreen(look: Look) -> Shape:
    """A bottle of sunscreen."""
    return _bottle(look, ("SPF 50", "SUN 30"), ("orange", "yellow", "amber", "sky", "white"), 0.145)


def mouthwash(look: Look) -> Shape:
    """A bottle of coloured mouthwash."""
    return _bottle(look, ("FRESH", "MOUTH"), ("teal", "blue", "green", "purple", "sky"), 0.165,
                   cap="screw")  # fmt: skip


def aftershave(look: Look) -> Shape:
    """A square glass bottle of aftershave with a heavy cap."""
    color = look.color("navy", "amber", "black", "green", "sky", "gray", "silver")
    x, y, h = look.between(0.046, 0.06), look.between(0.026, 0.034), look.between(0.07, 0.09)
    body = block(x, y, h, 0.005, 0.003)
    neck = cylinder(0.009, 0.01, 16).move(z=h - 0.001)
    cap = block(0.03, 0.024, 0.026, 0.004, 0.002).move(z=h + 0.006)
    label = box(0.66 * x, 0.001, 0.46 * h).move(0, -y / 2, 0.22 * h)
    image = canvas(64, 48, (236, 236, 232))
    write(image, look.pick(["HOMME", "SPORT", "WOOD", "NO. 5"]), 0.5, 0.5, 0.3, (40, 40, 46), True)
    metal = textures.brushed_metal(
        look.rng, look.pick([(200, 202, 206), (70, 70, 76), (206, 172, 96)])
    )
    return put_down(
        [
            (body, textures.gradient(tint_color(color, 0.8), tint_color(color, 1.3), look.rng)),
            (join([neck, cap]), metal),
            (label, image),
        ],
        body,
        cap,
    )


def hand_cream(look: Look) -> Shape:
    """A tube of hand cream standing on its cap."""
    return _tube(
        look, ("HAND", "CREAM"), ("pink", "white", "sage", "lavender", "yellow", "sky"), 0.12
    )


def hair_gel(look: Look) -> Shape:
    """A tube of face wash or gel standing on its cap."""
    return _tube(look, ("FACE", "GEL", "WASH"), ("teal", "blue", "green", "white", "orange"), 0.16)


def shaving_foam(look: Look) -> Shape:
    """A can of shaving foam."""
    return _aerosol(look, ("SHAVE", "FOAM"), ("white", "blue", "silver", "green"), 0.026, 0.125)


def hairspray(look: Look) -> Shape:
    """A tall can of hair spray."""
    return _aerosol(
        look, ("HAIR", "STYLE"), ("purple", "black", "gold", "pink", "white"), 0.024, 0.185
    )


def deodorant(look: Look) -> Shape:
    """A deodorant stick: an oval body, its cap on."""
    color = look.color("white", "blue", "black", "green", "pink", "teal", "gray")
    h = look.between(0.095, 0.12)
    lower = block(0.056, 0.032, 0.58 * h, 0.0155, 0.002)
    upper = block(0.058, 0.034, 0.44 * h, 0.0165, 0.004).move(z=0.56 * h)
    foot = block(0.05, 0.027, 0.008, 0.013)
    label = box(0.034, 0.001, 0.4 * h).move(0, -0.0162, 0.1 * h)
    lid = look.pick([tint_color(color, 0.5), (246, 246, 244), tint_color(color, 1.4)])
    return put_down(
        [
            (join([lower, foot]), look.surface(color, "plastic")),
            (upper, textures.plain(lid)),
            (label, _front(look, ("DEO", "48H", "FRESH"), color)),
        ],
        lower,
        upper,
    )


def foundation(look: Look) -> Shape:
    """A glass bottle of skin-coloured foundation with a black or gold cap."""
    color = look.color("beige", "tan", "bronze", "cream", "brown")
    x, h = look.between(0.03, 0.038), look.between(0.06, 0.075)
    body = block(x, x, h, 0.006, 0.003)
    cap = cylinder(0.38 * x, 0.034, 22, bevel=0.001).move(z=h - 0.002)
    label = box(0.8 * x, 0.001, 0.2 * h).move(0, -x / 2, 0.4 * h)
    lid = textures.plain(look.pick([(36, 36, 40), (206, 172, 96), (240, 240, 238)]))
    return put_down(
        [(body, textures.plain(color)), (cap, lid), (label, textures.plain((40, 36, 34)))],
        body,
        cap,
    )


def cleanser(look: Look) -> Shape:
    """A bottle of bleach or cleaner with a moulded handle and a ribbed cap."""
    color = look.color("white", "blue", "yellow", "green", "orange")
    k = look.between(0.9, 1.1)
    outline = rectangle(1, 1, 0.4, 5)
    levels = [(0.095, 0.056, 0), (0.1, 0.06, 0.01), (0.1, 0.06, 0.13), (0.07, 0.05, 0.18),
              (0.036, 0.034, 0.2), (0.03, 0.03, 0.215)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b] - [0.2 * (0.1 - a), 0], np.full(
        len(outline), z)]) for a, b, z in levels]), outline)  # fmt: skip
    grip = rod([(-0.018, 0, 0.2), (0.03, 0, 0.195), (0.05, 0, 0.165), (0.046, 0, 0.12)],
               [0.009, 0.01, 0.011, 0.011], 10)  # fmt: skip
    cap = cylinder(0.019, 0.026, 20, bevel=0.001).move(-0.014, 0, 0.213)
    label = box(0.074, 0.001, 0.09).move(0, -0.0302, 0.025)
    hue = look.own_color("blue", "red", "green", "navy")
    image = canvas(96, 112, hue)
    disc(image, 0.5, 0.62, 0.2, (250, 250, 246))
    write(
        image, look.pick(["BLEACH", "CLEAN", "POWER"]), 0.5, 0.24, 0.16, (250, 250, 246), bold=True
    )
    pieces: Pieces = [
        (join([body, grip]), look.surface(color, "plastic")),
        (cap, textures.plain(hue)),
        (label, image),
    ]
    return put_down(pieces, body, grip, cap, factor=k)


CATEGORIES = (
    Category("shampoo", shampoo, (0.063, 0.0385, 0.193), 0.3, ("shampoo bottle",
             "bottle of shampoo", "shower gel", "body wash", "shower gel bottle", "bubble bath",
             "bath gel", "mini shampoo bottle"), ("vanity",), ("tall",), ("green", "pink")),
    Category("conditioner", conditioner, (0.063, 0.0385, 0.183), 0.3, ("hair conditioner",
             "conditioner bottle", "bottle of conditioner"), ("vanity",), ("tall",), ("white",)),
    Category("body_lotion", body_lotion, (0.063, 0.05, 0.195), 0.3, ("lotion", "lotion bottle",
             "body cream", "bottle of lotion", "pump bottle", "body milk", "balm lotion",
             "hand sanitizer", "hand sanitiser", "hand gel", "micellar water",
             "hand sanitizer bottle"),
             ("vanity",),
             ("tall",), ("white", "pink")),
    Category("sunscreen", sunscreen, (0.063, 0.0385, 0.163), 0.22, ("sun cream", "sunblock",
                 "sun lotion", "bottle of sunscreen", "suntan lotion", "sunscreen bottle",
                 "sunscreen tube", "sun cream bottle", "tube of sunscreen"),
             ("vanity",), ("tall",), ("orange", "yellow")),
    Category("mouthwash", mouthwash, (0.063, 0.0385, 0.183), 0.5, ("mouth wash",
             "bottle of mouthwash", "mouthwash bottle"), ("vanity",), ("tall",), ("teal", "blue")),
    Category("aftershave", aftershave, (0.053, 0.03, 0.112), 0.2, ("cologne", "after shave",
             "aftershave bottle", "cologne bottle", "eau de cologne"), ("vanity",), ("tall",),
             ("navy", "amber")),
    Category("hand_cream", hand_cream, (0.056, 0.046, 0.12), 0.07, ("hand cream tube",
             "tube of hand cream", "tube of cream", "hand lotion", "ointment",
             "tube of ointment", "cream tube",
             "moisturiser tube", "primer tube", "ointment tube", "tube of antiseptic cream",
             "burn gel tube", "arnica tube", "antiseptic cream", "contact lens solution tube",
             "sun cream tube"), ("vanity",), ("tall",), ("pink", "white")),
    Category("face_wash", hair_gel, (0.056, 0.046, 0.16), 0.15, ("facial cleanser", "hair gel",
             "face wash tube", "facewash", "tube of gel"), ("vanity",), ("tall",), ("teal",
             "blue")),
    Category("shaving_foam", shaving_foam, (0.052, 0.052, 0.163), 0.25, ("shaving cream",
             "can of shaving foam", "shaving gel", "can of shaving cream"), ("vanity",), ("tall",
             "round"), ("white", "blue")),
    Category("hairspray", hairspray, (0.048, 0.048, 0.223), 0.25, ("hair spray",
             "can of hairspray", "dry shampoo", "can of hair spray"), ("vanity",),
             ("tall", "round"), ("purple",)),
    Category("deodorant", deodorant, (0.058, 0.034, 0.108), 0.1, ("deodorant stick", "deo",
             "antiperspirant", "roll on", "roll-on", "roll-on deodorant", "roll on deodorant"),
             ("vanity",), ("tall",), ("white", "blue")),
    Category("foundation", foundation, (0.034, 0.034, 0.1), 0.12, ("foundation bottle",
             "liquid foundation", "concealer", "makeup foundation"), ("vanity",), ("tall",),
             ("beige",)),
    Category("bleach", cleanser, (0.12, 0.06, 0.239), 1.0, ("bleach bottle", "bleach cleanser",
             "cleaner bottle", "cleanser", "fabric softener",
             "bottle of bleach", "toilet cleaner", "floor cleaner"),
             ("kitchen",), ("tall",), ("white", "blue")),
)  # fmt: skip
"""The module's categories."""
