"""What stands on a desk: book ends, folders, calendars, bells."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import side_view
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, ellipsoid, join, lathe, prism, torus
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def bookend(look: Look) -> Shape:
    """A book end: an angle of sheet steel or wood, or an L with a solid block or a ball."""
    x, y, h = look.between(0.1, 0.13), look.between(0.1, 0.13), look.between(0.13, 0.17)
    color = look.color("black", "silver", "red", "white", "teal", "gold", "wooden")
    kind = look.pick(["sheet", "wood", "ball"])
    if kind == "sheet":
        foot = box(y, x, 0.0016)
        outline = rectangle(x, h, 0.03, 5) + np.array([0, h / 2])
        hole = rectangle(0.46 * x, 0.46 * h, 0.02, 4) + np.array([0, 0.52 * h])
        wall = prism(outline, 0, 0.0016).turn(0, np.pi / 2).turn(2, np.pi / 2)
        inner = prism(hole, 0, 0.0022).turn(0, np.pi / 2).turn(2, np.pi / 2)
        wall, inner = wall.move(x=-y / 2), inner.move(x=-y / 2 - 0.0003)
        skin = look.surface(color, "metal")
        return shape([(join([foot, wall]), skin), (inner, textures.plain(tint_color(color, 0.55)))],
                     [hull_of(foot), hull_of(wall)])  # fmt: skip
    wood = look.surface(color, "wood" if kind == "wood" else "metal")
    foot, wall = box(y, x, 0.014), box(0.016, x, h - 0.014).move(x=-y / 2 + 0.008, z=0.014)
    if kind == "wood":
        prop = side_view(np.array([(-y / 2 + 0.016, 0.014), (0.36 * y, 0.014),
                                   (-y / 2 + 0.016, 0.8 * h)]), 0.02)  # fmt: skip
        return shape(
            [(join([foot, wall, prop]), wood)], [hull_of(foot), hull_of(wall), hull_of(prop)]
        )
    ball = ellipsoid(0.62 * y, 0.62 * y, 0.62 * y, 22, 14).move(x=0.1 * y, z=0.32 * y + 0.01)
    other = look.surface(look.own_color("gold", "white", "silver", "black"), "marble")
    return shape([(join([foot, wall]), wood), (ball, other)],
                 [hull_of(foot), hull_of(wall), hull_of(ball)])  # fmt: skip


def folder(look: Look) -> Shape:
    """A manila or coloured folder lying flat, a tab at its back, sheets showing."""
    x, y, h = look.between(0.3, 0.32), look.between(0.225, 0.245), look.between(0.006, 0.014)
    color = look.color("tan", "beige", "beige", "red", "blue", "green", "yellow", "gray")
    card = textures.speckles(look.rng, color, 5, 64)
    low = box(x, y, 0.001)
    at = look.pick([-0.3, 0.0, 0.3])
    tab = prism(np.array([(-0.16 * x, 0), (0.16 * x, 0), (0.12 * x, 0.018), (-0.12 * x, 0.018)]),
                0, 0.001).move(x=at * x, y=y / 2)  # fmt: skip
    sheets = box(0.95 * x, 0.94 * y, h - 0.002).move(x=0.006, y=0.008, z=0.001)
    cover = box(x, y - 0.004, 0.001).bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.004 * (p[:, 1] < 0)])
    ).move(y=-0.002, z=h - 0.001)  # fmt: skip
    image = textures.fit(card, 128, 176).copy()
    kind = int(look.rng.integers(3))
    if kind == 0:
        prints.write(image, look.pick(["TOP SECRET", "REPORT", "INVOICES", "2026"]), 0.5, 0.4, 0.12,
                     (176, 40, 40), bold=True)  # fmt: skip
    elif kind == 1:
        prints.fill(image, 0.3, 0.3, 0.4, 0.24, (248, 247, 242))
        prints.lines(image, look.rng, (0.34, 0.36, 0.32, 0.14), 3, (90, 90, 96))
    sign = prints.canvas(64, 16, (248, 247, 242))
    prints.lines(sign, look.rng, (0.1, 0.3, 0.8, 0.5), 1, (60, 60, 66))
    slip = box(0.2 * x, 0.01, 0.0004).move(x=at * x, y=y / 2 + 0.008, z=0.001)
    return shape(
        [
            (join([low, tab]), card),
            (sheets, prints.pages(look.rng, (246, 244, 238))),
            (cover, image),
            (slip, sign),
        ],
        [box_part(x, y, h)],
    )


def calendar(look: Look) -> Shape:
    """A desk calendar: a tent with a month and a picture, ring-bound, or a pair of date blocks."""
    color = look.color("white", "red", "navy", "teal", "black", "wooden", "mustard")
    if look.chance(0.25):
        wood = look.surface(color, "wood")
        x = look.between(0.11, 0.13)
        tray = [box(x, 0.05, 0.01), box(x, 0.008, 0.075).move(y=0.021, z=0.01)]
        pieces, parts = [(join(tray), wood)], [hull_of(s) for s in tray]
        for k, digit in enumerate((look.rng.integers(0, 3), look.rng.integers(1, 10))):
            face = prints.canvas(64, 64, (246, 240, 226))
            prints.write(face, str(int(digit)), 0.5, 0.5, 0.7, (40, 40, 46), bold=True)
            cube = box(0.04, 0.036, 0.04).move((k - 0.5) * 0.045, -0.002, 0.027)
            pieces.append((cube, face))
        month = prints.canvas(128, 24, (246, 240, 226))
        name = look.pick(["JANUARY", "MAY", "JULY", "OCTOBER", "MARCH"])
        prints.write(month, name, 0.5, 0.5, 0.6, (176, 40, 40), bold=True)
        bar = box(0.09, 0.036, 0.017).move(y=-0.002, z=0.01)
        pieces.append((bar, month))
        parts.append(box_part(0.09, 0.036, 0.057, (0, -0.002, 0.01)))
        return shape(pieces, parts)
    x, h = look.between(0.17, 0.22), look.between(0.13, 0.17)
    y = 0.5 * h
    image = prints.canvas(192, 144, (250, 249, 246))
    picture = look.chance(0.5)
    left = 0.5 if picture else 0.06
    if picture:
        image[14:, 8:90] = prints.artwork(look.rng, 82, 130)
    title: tuple[float, float, float] = color if sum(color) < 520 else (180, 40, 44)
    months = ["JAN", "MAY", "JULY", "OCT", "NOV", "APRIL"]
    part = image[:, int(left * 192) : 186]
    prints.fill(part, 0, 0.06, 1, 0.16, title)
    prints.write(part, look.pick(months), 0.5, 0.14, 0.12, readable_on(title), bold=True)
    start = int(look.rng.integers(7))
    for day in range(31):
        u, v = (day + start) % 7, (day + start) // 7
        tone = (196, 60, 56) if u == 6 else (80, 82, 90)
        prints.fill(part, 0.05 + 0.135 * u, 0.3 + 0.115 * v, 0.075, 0.055, tone)
    lean = np.arctan2(0.5 * y, h)
    sheet = box(x, 0.003, h)
    front = sheet.turn(0, -lean).move(y=-0.5 * y)
    back = sheet.turn(0, lean).move(y=0.5 * y)
    foot = box(x, y, 0.002)
    wire = torus(0.006, 0.001, 12, 5).turn(1, np.pi / 2)
    rings = [wire.move(x=(k / 15 - 0.5) * 0.9 * x, z=h - 0.002) for k in range(16)]
    page = box(0.94 * x, 0.001, 0.92 * h).turn(0, -lean).move(y=-0.5 * y - 0.0022, z=0.003)
    card = look.surface(color)
    return shape([(join([front, back, foot]), card), (page, image),
                  (join(rings), textures.plain((70, 72, 78)))],
                 [hull_of(front, foot), hull_of(back)])  # fmt: skip


def desk_bell(look: Look) -> Shape:
    """A reception bell: a metal dome with a button on a round base; or a hand bell."""
    r = look.between(0.037, 0.045)
    color = look.color("silver", "silver", "gold", "brass", "copper", "red", "black")
    metal = look.surface(color, "metal")
    if look.chance(0.7):
        base = lathe([(0, 0), (1.1 * r, 0), (1.1 * r, 0.006), (0.95 * r, 0.012), (0, 0.012)], 32)
        t = np.linspace(0, np.pi / 2, 9)
        dome = lathe(
            [
                (0, 0.02),
                *((r * np.cos(a) ** 0.75, 0.02 + 0.62 * r * np.sin(a)) for a in t[:-1]),
                (0, 0.02 + 0.62 * r),
            ],
            32,
        )
        post = cylinder(0.009, 0.012, 14).move(z=0.011)
        knob = lathe(
            [(0, 0), (0.004, 0), (0.004, 0.006), (0.009, 0.008), (0.008, 0.013), (0, 0.015)], 18
        )
        knob = knob.move(z=0.018 + 0.62 * r)
        dark = textures.speckles(look.rng, look.own_color("black", "brown", "black"), 3, 32)
        return shape([(base, dark), (join([dome, post, knob]), metal)],
                     [hull_of(base), cylinder_part(0.009, 0.012, (0, 0, 0.011)), hull_of(dome),
                      hull_of(knob)])  # fmt: skip
    bell = lathe([(0, 0.006), (0.85 * r, 0), (r, 0.001), (0.7 * r, 0.6 * r), (0.5 * r, 1.4 * r),
                  (0.2 * r, 1.6 * r), (0, 1.62 * r)], 28)  # fmt: skip
    grip = lathe([(0, 1.6 * r), (0.1 * r, 1.6 * r), (0.24 * r, 1.9 * r), (0.16 * r, 2.5 * r),
                  (0.26 * r, 3.0 * r), (0, 3.1 * r)], 16)  # fmt: skip
    wood = textures.wood(look.rng, look.pick([(112, 76, 50), (60, 46, 42), (176, 128, 80)]))
    return shape([(bell, metal), (grip, wood)], [hull_of(bell), hull_of(grip)])


CATEGORIES = (
    Category("bookend", bookend, (0.115, 0.115, 0.15), 0.6, ("book end", "book stop",
             "book stand"), ("office", "living"), ("tall",), ("black", "silver")),
    Category("folder", folder, (0.311, 0.251, 0.013), 0.12, ("document folder", "file folder",
             "manila folder", "paper folder", "dossier", "folder of documents", "portfolio",
             "file"), ("office",), ("flat", "support", "big"), ("tan", "blue"),
             state="lying flat"),
    Category("calendar", calendar, (0.183, 0.07, 0.134), 0.16, ("desk calendar", "tent calendar",
             "desktop calendar", "flip calendar", "perpetual calendar"), ("office",), ("tall",),
             ("white", "red")),
    Category("desk_bell", desk_bell, (0.0862, 0.0862, 0.0835), 0.2, ("bell", "call bell",
             "service bell", "reception bell", "counter bell", "table bell",
             "hotel bell"), ("office", "dining"), ("round",), ("silver", "gold")),
)  # fmt: skip
"""The module's categories."""
