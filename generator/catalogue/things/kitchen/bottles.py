"""Bottles and jars with printed labels."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, lathe
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

PRINTS = ("red", "navy", "teal", "green", "mustard", "crimson", "orange", "purple", "blue")


def cap_ribs(color: RGB) -> textures.Tile:
    """A screw cap's side."""
    return textures.stripes([color, tint_color(color, 0.75)], 16, upright=True, side=64)


def label_skin(
    look: Look, base: RGB, word: str, low: float, high: float, ground: RGB = (244, 242, 234)
) -> textures.Tile:
    """A bottle's skin: plain, a label between the heights v ``low`` and ``high``, plain."""
    print_ = prints.label(look.rng, word, look.own_color(*PRINTS), ground)
    skin = textures.speckles(look.rng, base, 3, 32)
    return textures.stack((skin, low), (print_, high - low), (skin, 1 - high), side=192)


def vessel(
    r: float,
    h: float,
    neck: float,
    shoulder: float,
    rise: float,
    *,
    waist: bool = False,
    sides: int = 32,
) -> Solid:
    """Return a bottle's body up to its mouth at ``h``, with ``waist`` gripped in the middle.

    It is straight up to z ``shoulder`` and has its ``neck`` radius from z ``rise`` on. v runs
    with z along the outside, so that labels sit where they are meant to.
    """
    t = np.linspace(0, 1, 6)[1:-1]
    bow = [
        (neck + (r - neck) * (0.5 + 0.5 * np.cos(np.pi * k)), shoulder + (rise - shoulder) * k)
        for k in t
    ]
    grip = [(0.88 * r, k * shoulder) for k in (0.5, 0.6)] if waist else []
    ends = [(r, k * shoulder) for k in (0.4, 0.7)] if waist else []
    profile = [(0, 0), (0.92 * r, 0), (r, 0.005), *ends[:1], *grip, *ends[1:], (r, shoulder), *bow,
               (neck, rise), (neck, h), (0, h)]  # fmt: skip
    return lathe(profile, sides, v=[0, *(z / h for _, z in profile[1:-1]), 1])


def vessel_parts(
    body: Solid, r: float, shoulder: float, neck: float, h: float, rise: float
) -> list[ConvexPart]:
    """Return a vessel's body, shoulder and neck."""
    upper = body.vertices[(body.vertices[:, 2] >= shoulder) & (body.vertices[:, 2] <= rise + 1e-6)]
    return [
        cylinder_part(0.99 * r, shoulder),
        hull_part(upper),
        cylinder_part(neck, h - rise, (0, 0, rise)),
    ]


def bottle(look: Look) -> Shape:
    """A bottle of water, juice, soda, beer or milk with a label and a cap."""
    kind = look.pick(["water", "juice", "soda", "beer", "milk", "flask"])
    r, h = look.between(0.03, 0.037), look.between(0.195, 0.24)
    neck, shoulder, rise = {
        "water": (0.0125, 0.7, 0.86),
        "juice": (0.0165, 0.66, 0.88),
        "soda": (0.0125, 0.56, 0.86),
        "beer": (0.0125, 0.58, 0.76),
        "milk": (0.018, 0.62, 0.86),
        "flask": (0.022, 0.86, 0.93),
    }[kind]
    color = look.color(*{
        "water": ("sky", "clear", "cyan", "mint"),
        "juice": ("orange", "red", "yellow", "lime", "purple"),
        "soda": ("brown", "green", "orange", "clear", "maroon"),
        "beer": ("brown", "green", "amber"),
        "milk": ("white", "cream", "pink", "brown"),
        "flask": ("teal", "black", "silver", "coral", "navy", "sage", "white", "yellow"),
    }[kind])  # fmt: skip
    word = look.pick({
        "water": ["WATER", "PURE", "SPRING"], "juice": ["JUICE", "FRESH", "MANGO"],
        "soda": ["SODA", "COLA", "FIZZ"], "beer": ["LAGER", "ALE", "STOUT"],
        "milk": ["MILK", "DAIRY", "OAT"], "flask": ["TREK", "HYDRO", "GYM"],
    }[kind])  # fmt: skip
    waist = kind in ("water", "juice") and look.chance(0.6)
    body = vessel(r, h, neck, shoulder * h, rise * h, waist=waist)
    low, high = look.between(0.14, 0.26), look.between(0.46, 0.56)
    if kind == "flask":
        tile = look.surface(color, look.pick(["metal", "plastic"]))
        if look.chance(0.6):
            sign = prints.canvas(128, 128, color)
            prints.write(sign[:, 40:88], word, 0.5, 0.45, 0.14, tint_color(color, 0.4), bold=True)
            prints.fill(sign, 0, 0.86, 1, 0.14, tint_color(color, 0.6))
            tile = sign
    else:
        ground = look.pick([(244, 242, 234), (250, 226, 120), (34, 40, 52), (206, 226, 236)])
        tile = label_skin(look, color, word, low, high, ground)
    cap = cylinder(neck + 0.0017, 0.016, 20, bevel=0.001).move(z=h - 0.004)
    lid = cap_ribs(look.own_color("white", "red", "blue", "green", "black", "gold", "silver"))
    return shape(
        [(body, tile), (cap, lid)],
        [*vessel_parts(body, 0.86 * r if waist else r, shoulder * h, neck, h, rise * h),
         cylinder_part(neck + 0.0017, 0.016, (0, 0, h - 0.004))],
    )  # fmt: skip


def wine_bottle(look: Look) -> Shape:
    """A tall bottle of wine or oil with a paper label and a foil or a cork."""
    kind = look.pick(["bordeaux", "burgundy", "champagne", "oil"])
    r, h = look.between(0.035, 0.04), look.between(0.285, 0.32)
    neck, shoulder, rise = {
        "bordeaux": (0.0135, 0.6, 0.73),
        "burgundy": (0.0135, 0.44, 0.76),
        "champagne": (0.0145, 0.42, 0.82),
        "oil": (0.013, 0.66, 0.76),
    }[kind]
    r = {"champagne": 1.08 * r, "oil": 0.86 * r}.get(kind, r)
    color = look.color("green", "olive", "maroon", "black", "amber", "teal", "brown", "mustard")
    word = look.pick(["ROSSO", "1998", "VALLEY", "BRUT", "OLIVE", "RESERVA", "BLANC"])
    body = vessel(r, h, neck, shoulder * h, rise * h)
    top = look.between(0.8, 0.88)
    foil = cylinder(neck + 0.0013, (1.01 - top) * h, 20, bevel=0.001).move(z=top * h)
    paper = look.pick([(244, 242, 234), (236, 224, 196), (40, 38, 40), (122, 30, 40)])
    skin = label_skin(look, tint_color(color, 0.55), word, look.between(0.1, 0.18),
                     min(shoulder - 0.03, look.between(0.36, 0.5)), paper)  # fmt: skip
    seal = look.own_color("crimson", "gold", "black", "green", "silver", "white")
    return shape(
        [(body, skin), (foil, textures.speckles(look.rng, seal, 3, 32))],
        [*vessel_parts(body, r, shoulder * h, neck, h, rise * h),
         cylinder_part(neck + 0.0013, (1.01 - top) * h, (0, 0, top * h))],
    )  # fmt: skip


def sauce_bottle(look: Look) -> Shape:
    """A bottle of ketchup, mustard or hot sauce: squeezed, standing on its cap, or of glass."""
    r, h = look.between(0.028, 0.034), look.between(0.14, 0.17)
    color = look.color("red", "yellow", "red", "brown", "green", "cream", "orange", "black")
    kind = look.pick(["squeeze", "squeeze", "glass", "turned"])
    word = "MUSTARD" if color[1] > 150 else "KETCHUP" if color[0] > 150 else "SAUCE"
    if min(color) > 150:
        word = "MAYO"
    ground = look.pick([tint_color(color, 0.8), (246, 244, 236), (250, 220, 90), (40, 90, 60)])
    cap = textures.plain(look.own_color("white", "white", "green", "red", "black", "gold"))
    if kind == "turned":
        base = cylinder(0.86 * r, 0.03, 24, bevel=0.002)
        flipped = lathe(
            [(0, 0), (0.8 * r, 0), (0.9 * r, 0.2 * h), (r, 0.5 * h), (0.96 * r, 0.92 * h),
             (0.8 * r, h), (0, h)], v=[0, 0.01, 0.2, 0.5, 0.9, 0.98, 1],
        )  # fmt: skip
        body = flipped.move(z=0.028)
        return shape(
            [(body, label_skin(look, color, word, 0.3, 0.75, ground)), (base, cap)],
            [cylinder_part(0.86 * r, 0.03), hull_of(body)],
        )
    neck, shoulder, rise = (0.016, 0.72, 0.94) if kind == "squeeze" else (0.011, 0.5, 0.82)
    body = vessel(r, h, neck, shoulder * h, rise * h)
    tip = 0.0032 if kind == "squeeze" else neck + 0.0015
    nozzle = cylinder(neck - 0.001 if kind == "squeeze" else tip, 0.034, 18, top=tip)
    nozzle = nozzle.move(z=h + 0.006 if kind == "squeeze" else h - 0.006)
    collar = cylinder(neck + 0.0015, 0.009, 20, bevel=0.001).move(z=h - 0.002)
    return shape(
        [(body, label_skin(look, color, word, look.between(0.16, 0.28), shoulder - 0.1, ground)),
         (nozzle, cap), (collar, cap)],
        [*vessel_parts(body, r, shoulder * h, neck, h, rise * h), hull_of(nozzle, collar)],
    )  # fmt: skip


def paint_bottle(look: Look) -> Shape:
    """A bottle of paint with a pump, a nozzle or a wide cap; the label shows its colour."""
    r, h = look.between(0.033, 0.04), look.between(0.128, 0.152)
    color = look.color(
        *("red", "blue", "yellow", "green", "purple", "orange", "teal", "pink", "white", "brown")
    )
    kind = look.pick(["pump", "pump", "nozzle", "cap"])
    word = look.pick(["PAINT", "ACRYL", "TEMPERA", "GOUACHE"])
    body = vessel(r, h, 0.014, look.between(0.72, 0.84) * h, 0.95 * h)
    ground = look.pick([(244, 242, 234), (250, 250, 250), (38, 38, 42), tint_color(color, 1.6)])
    skin = label_skin(look, color, word, look.between(0.14, 0.26), look.between(0.54, 0.68), ground)
    top = textures.plain(look.pick([(238, 238, 236), (238, 238, 236), (40, 40, 44), color]))
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


def jar(look: Look) -> Shape:
    """A jar of jam, honey, pickles or spice: round, squat, tall or faceted, with a lid."""
    r, h = look.between(0.033, 0.043), look.between(0.08, 0.12)
    color = look.color(
        *("crimson", "amber", "purple", "orange", "olive", "brown", "cream", "green", "gold")
    )
    word = look.pick(["JAM", "HONEY", "PICKLES", "BERRY", "CURRY", "PESTO", "OLIVES", "SPICE"])
    shoulder, sides = look.between(0.74, 0.88), look.pick([32, 32, 32, 8])
    neck = look.between(0.7, 0.86) * r
    body = vessel(r, h, neck, shoulder * h, 0.94 * h, sides=sides)
    lid = cylinder(neck + 0.002, look.between(0.012, 0.02), 28, bevel=0.002).move(z=h - 0.003)
    other = look.own_color("white", "red", "gold", "navy", "black", "silver", "green")
    cloth = textures.fabric(look.rng, other, (246, 244, 238), 16)
    top = look.pick([cloth, textures.plain(other), textures.brushed_metal(look.rng, other)])
    ground = look.pick([(244, 242, 234), (250, 240, 200), (46, 52, 48), tint_color(color, 1.7)])
    skin = label_skin(look, color, word, look.between(0.18, 0.3), look.between(0.6, 0.72), ground)
    flat = np.cos(np.pi / sides)
    return shape(
        [(body, skin), (lid, top)],
        [*vessel_parts(body, r * flat, shoulder * h, neck * flat, h, 0.94 * h), hull_of(lid)],
    )


CATEGORIES = (
    Category(
        "bottle",
        bottle,
        (0.067, 0.067, 0.23),
        0.5,
        (
            "water bottle",
            "juice bottle",
            "soda bottle",
            "plastic bottle",
            "drink",
            "juice",
            "water",
            "barber's bottle",
            "after sun bottle",
            "micellar water bottle",
        ),
        ("dining", "kitchen", "office"),
        ("tall", "round"),
        ("green", "sky", "amber"),
    ),
    Category(
        "wine_bottle",
        wine_bottle,
        (0.075, 0.075, 0.31),
        1.2,
        ("wine", "bottle of wine", "champagne", "champagne bottle"),
        ("dining",),
        ("tall", "round"),
        ("green", "maroon"),
    ),
    Category(
        "sauce_bottle",
        sauce_bottle,
        (0.062, 0.062, 0.195),
        0.4,
        ("squeeze bottle", "sauce", "sauce dispenser"),
        ("dining", "kitchen"),
        ("tall", "round"),
        ("red", "yellow"),
    ),
    Category(
        "paint_bottle",
        paint_bottle,
        (0.073, 0.073, 0.185),
        0.45,
        ("bottle of paint", "paint", "paint pot"),
        ("craft",),
        ("tall", "round"),
        ("red", "blue", "yellow"),
    ),
    Category(
        "jar",
        jar,
        (0.076, 0.076, 0.115),
        0.4,
        (),
        ("kitchen", "dining"),
        ("round",),
        ("crimson", "amber"),
    ),
)
