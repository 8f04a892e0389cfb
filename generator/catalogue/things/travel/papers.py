"""Papers and small things for a journey: passports, tickets, labels, masks."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_part
from ...build.outlines import smooth
from ...build.recipes import put_down, rod
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, loft, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def passport(look: Look) -> Shape:
    """A passport lying: a coat of arms and a word in gold on its cover."""
    color = look.color("maroon", "navy", "green", "crimson", "black", "teal")
    k = look.between(0.92, 1.15)
    image = prints.canvas(88, 125, color)
    gold = (222, 190, 110)
    prints.disc(image, 0.5, 0.5, 0.17, gold, 0.15)
    prints.polygon(
        image, [(0.38, 0.42), (0.62, 0.42), (0.62, 0.52), (0.5, 0.61), (0.38, 0.52)], gold
    )
    prints.write(image, "PASSPORT", 0.5, 0.16, 0.09, gold, bold=True)
    prints.fill(image, 0.44, 0.84, 0.12, 0.05, gold)
    pages = box(0.085, 0.121, 0.0044).move(z=0.0006)
    covers = [block(0.088, 0.125, 0.0008, 0.003).move(z=z) for z in (0, 0.0049)]
    face = box(0.0875, 0.1245, 0.0004).move(z=0.0055)
    return shape(
        [(pages, prints.pages(look.rng)), (join(covers), textures.plain(color)), (face, image)],
        [box_part(0.088, 0.125, 0.0059)],
    ).scale(k)


def _slip(
    look: Look, x: float, y: float, image: textures.Tile, color: tuple[float, float, float]
) -> Shape:
    """Return a flat card with a picture on it, not quite flat in its body's colour."""
    k = look.between(0.9, 1.15)
    card = box(x, y, 0.0012)
    face = box(x - 0.0006, y - 0.0006, 0.0003).move(z=0.0011)
    return shape([(card, textures.plain(color)), (face, image)], [box_part(x, y, 0.0014)]).scale(k)


def boarding_pass(look: Look) -> Shape:
    """A boarding pass: a coloured band, a plane's route, a bar code, a stub."""
    color = look.color("blue", "red", "teal", "orange", "purple", "green")
    image = prints.canvas(200, 80, (246, 246, 244))
    prints.fill(image, 0, 0, 1, 0.24, color)
    prints.write(image[:20, 6:120], "BOARDING PASS", 0.5, 0.5, 0.62, readable_on(color), bold=True)
    prints.write(
        image[24:52, 6:60], look.pick(["LHR", "JFK", "CDG"]), 0.5, 0.5, 0.75, (40, 44, 60), True
    )
    prints.write(
        image[24:52, 84:138], look.pick(["NRT", "SFO", "FCO"]), 0.5, 0.5, 0.75, (40, 44, 60), True
    )
    prints.polygon(image, [(0.32, 0.46), (0.4, 0.48), (0.32, 0.5)], color)
    prints.fill(image, 0.3, 0.47, 0.04, 0.02, color)
    prints.lines(image, look.rng, (0.04, 0.72, 0.5, 0.2), 3, (120, 120, 126))
    prints.barcode(image, look.rng, 0.76, 0.4, 0.2)
    prints.fill(image, 0.715, 0, 0.005, 1, (150, 150, 156))
    return _slip(look, 0.19, 0.076, image, (236, 236, 234))


def ticket(look: Look) -> Shape:
    """An entrance ticket with notched ends and a star."""
    color = look.color("red", "yellow", "blue", "green", "orange", "pink", "purple")
    image = prints.canvas(128, 60, color)
    ink = readable_on(color)
    prints.fill(image, 0.1, 0.12, 0.8, 0.05, ink)
    prints.fill(image, 0.1, 0.83, 0.8, 0.05, ink)
    prints.write(
        image[:, 20:108], look.pick(["ADMIT ONE", "TICKET", "CINEMA"]), 0.5, 0.5, 0.36, ink, True
    )
    for x in (0.1, 0.9):
        prints.disc(image, x, 0.5, 0.09, ink)
    w, h, r = 0.048, 0.021, 0.007
    a = np.linspace(np.pi / 2, -np.pi / 2, 6)
    left = np.column_stack([-w + r * np.cos(a), r * np.sin(a)])
    outline = np.concatenate([[(-w, -h), (w, -h)], -left, [(w, h), (-w, h)], left])
    card = prism(outline, 0, 0.0012)
    face = prism(outline * 0.99, 0.0011, 0.0015)
    made = shape([(card, textures.plain(tint_color(color, 0.9))), (face, image)],
                 [box_part(2 * w, 2 * h, 0.0015)])  # fmt: skip
    return made.scale(look.between(0.9, 1.25))


def luggage_tag(look: Look) -> Shape:
    """A luggage tag lying with its strap."""
    color = look.color("brown", "red", "black", "teal", "tan", "navy", "pink")
    k = look.between(0.9, 1.15)
    body = prism([(-0.05, -0.018), (-0.034, -0.03), (0.05, -0.03), (0.05, 0.03), (-0.034, 0.03),
                  (-0.05, 0.018)], 0, 0.004)  # fmt: skip
    window = box(0.06, 0.04, 0.0006).move(0.012, 0, 0.0038)
    image = prints.canvas(96, 64, (246, 244, 238))
    prints.lines(image, look.rng, (0.1, 0.2, 0.8, 0.6), 4, (90, 90, 96), 0.3)
    strap = rod(
        [
            (-0.04, 0, 0.004),
            (-0.07, 0.012, 0.004),
            (-0.105, 0.004, 0.003),
            (-0.1, -0.012, 0.003),
            (-0.07, -0.01, 0.004),
            (-0.04, -0.002, 0.005),
        ],
        0.0032,
        6,
    )
    return put_down([(join([body, strap]), textures.speckles(look.rng, color, 7)), (window, image)],
                   body, strap, factor=k)  # fmt: skip


def travel_pillow(look: Look) -> Shape:
    """A horseshoe-shaped neck pillow lying, open to the front."""
    color = look.color("gray", "navy", "teal", "pink", "mustard", "purple", "black")
    k = look.between(0.85, 1.05)
    a = np.linspace(-0.28 * np.pi, 1.28 * np.pi, 26)
    path = np.column_stack([0.09 * np.cos(a), 0.095 * np.sin(a), np.full(26, 0.042)])
    ends = np.clip(np.minimum(a - a[0], a[-1] - a) / 0.35, 0.3, 1) ** 0.5
    body = tube(path, 0.045 * ends, 12)
    v = body.vertices
    parts = [hull_part(v[(v[:, 0] < -0.02) & (v[:, 1] < 0.06)]), hull_part(v[(v[:, 0] > 0.02)
             & (v[:, 1] < 0.06)]), hull_part(v[v[:, 1] > 0.03])]  # fmt: skip
    plush = textures.scratches(look.rng, color, tint_color(color, 0.88), 120)
    low = float(v[:, 2].min())
    made = shape([(body.move(z=-low), plush)], [type(p)(p.vertices - [0, 0, low]) for p in parts])
    return made.scale(k)


def eye_mask(look: Look) -> Shape:
    """A padded sleeping mask lying with its elastic band."""
    color = look.color("black", "navy", "pink", "lavender", "gray", "teal")
    k = look.between(0.9, 1.1)
    side = smooth(
        [
            (-0.1, 0.006),
            (-0.07, 0.042),
            (0, 0.034),
            (0.07, 0.042),
            (0.1, 0.006),
            (0.07, -0.04),
            (0.02, -0.036),
            (0, -0.012),
            (-0.02, -0.036),
            (-0.07, -0.04),
            (-0.1, 0.006),
        ],
        3,
    )[:-1]
    side = side[::-1]
    n = len(side)
    body = loft(np.stack([np.column_stack([side * g, np.full(n, z)]) for g, z in (
        (0.95, 0), (1.0, 0.004), (0.96, 0.009), (0.8, 0.012))]), side)  # fmt: skip
    band = rod([(-0.096, 0, 0.005), (-0.09, 0.05, 0.004), (0, 0.085, 0.004), (0.09, 0.05, 0.004),
                (0.096, 0, 0.005)], 0.0035, 6)  # fmt: skip
    lids = [
        rod(
            [
                (s * 0.05 - 0.024, 0.006, 0.011),
                (s * 0.05, -0.008, 0.0125),
                (s * 0.05 + 0.024, 0.006, 0.011),
            ],
            0.0013,
            5,
        )
        for s in (-1, 1)
    ]
    ink = textures.plain((250, 246, 240) if sum(color) < 400 else (70, 60, 80))
    return put_down(
        [
            (body, textures.fabric(look.rng, color)),
            (band, textures.plain(tint_color(color, 0.7) if sum(color) > 200 else (90, 90, 96))),
            (join(lids), ink),
        ],
        body,
        factor=k,
    )


def travel_adapter(look: Look) -> Shape:
    """A travel plug adapter lying on its back: a cube with sockets, pins on its side."""
    color = look.color("white", "black", "gray", "red", "teal")
    k = look.between(0.9, 1.12)
    body = block(0.052, 0.048, 0.05, 0.008, 0.003)
    top = cylinder(0.019, 0.001, 24).move(z=0.0496)
    holes = [cylinder(0.0028, 0.0006, 12).move(s * 0.0085, 0, 0.0504) for s in (-1, 1)]
    slots = [box(0.0015, 0.007, 0.0006).move(s * 0.006, 0.01, 0.0504) for s in (-1, 1)]
    usb = [box(0.013, 0.001, 0.005).move(0, -0.0242, z) for z in (0.016, 0.028)]
    pins = [box(0.018, 0.0065, 0.0022).move(0.033, s * 0.009, 0.024) for s in (-1, 1)]
    dark = textures.plain((36, 36, 40) if sum(color) > 200 else (150, 150, 156))
    return put_down(
        [
            (body, look.surface(color, "plastic")),
            (top, textures.plain(tint_color(color, 0.85) if sum(color) > 200 else (70, 70, 74))),
            (join([*holes, *slots, *usb]), dark),
            (join(pins), textures.brushed_metal(look.rng, (206, 208, 212))),
        ],
        body,
        join(pins),
        factor=k,
    )


CATEGORIES = (
    Category("passport", passport, (0.091, 0.13, 0.0061), 0.035, ("travel passport", "visa",
             "passport cover", "travel document",), ("living",
             "office"), ("flat",), ("maroon", "navy"), state="lying flat"),
    Category("boarding_pass", boarding_pass, (0.195, 0.078, 0.00145), 0.005, ("plane ticket",
             "flight ticket", "airline ticket", "boarding card"), ("living", "office"), ("flat",),
             ("blue",), state="lying flat"),
    Category("ticket", ticket, (0.103, 0.045, 0.0016), 0.002, ("cinema ticket", "movie ticket",
                 "train ticket", "concert ticket", "raffle ticket", "theatre ticket",
                 "bus ticket", "betting slip", "lottery ticket"),
             ("living",), ("flat",), ("red", "yellow"), state="lying flat"),
    Category("luggage_tag", luggage_tag, (0.165, 0.0619, 0.00802), 0.02, ("baggage tag",
             "suitcase tag", "bag tag", "bookmark tag"), ("living",), ("flat",), ("brown", "red"),
             state="lying flat"),
    Category("travel_pillow", travel_pillow, (0.25, 0.2, 0.085), 0.25, ("neck pillow",
             "neck cushion", "travel cushion"), ("living",), ("big",), ("gray", "navy"),
             state="lying flat"),
    Category("eye_mask", eye_mask, (0.2, 0.125, 0.0125), 0.03, ("sleep mask", "sleeping mask",
             "blindfold"), ("living",),
             ("flat",), ("black", "navy"), state="lying flat"),
    Category("travel_adapter", travel_adapter, (0.068, 0.05, 0.0515), 0.1, ("plug adapter",
             "adapter plug", "travel plug", "universal adapter", "socket adapter", "smart plug",
             "timer switch", "travel adaptor", "plug adaptor", "gender changer"), ("living",
             "office"), (), ("white", "black")),
)  # fmt: skip
"""The module's categories."""
