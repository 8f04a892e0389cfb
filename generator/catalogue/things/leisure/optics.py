"""What one looks through and finds the way with, and what holds it up."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..tools.tools import lying

DARK: RGB = (38, 36, 38)


def binoculars(look: Look) -> Shape:
    """Binoculars standing on their objectives' ends or lying, eyepieces up."""
    k = look.between(0.85, 1.08)
    color = look.color("black", "olive", "charcoal", "green", "navy", "black")
    rubber = textures.spots(look.rng, color, tint_color(color, 0.75), 0.2)
    dark = textures.speckles(look.rng, DARK, 4)
    barrels, rims, lenses, parts = [], [], [], []
    for s in (-1, 1):
        barrel = lathe(
            [
                (0, 0),
                (0.029, 0),
                (0.03, 0.03),
                (0.03, 0.055),
                (0.024, 0.075),
                (0.023, 0.1),
                (0.016, 0.112),
                (0, 0.112),
            ],
            24,
        ).scale(k, k, k)
        eye = lathe([(0, 0.108), (0.0175, 0.108), (0.02, 0.14), (0.014, 0.14), (0.012, 0.134),
                     (0, 0.134)], 22).scale(k, k, k)  # fmt: skip
        glass = lathe([(0, 0.1345), (0.0118, 0.1345), (0.011, 0.136), (0, 0.137)], 18).scale(
            k, k, k
        )
        x = s * 0.034 * k
        barrels.append(barrel.move(x=x))
        rims.append(eye.move(x=x * 0.94))
        lenses.append(glass.move(x=x * 0.94))
        parts += [hull_of(barrels[-1]), hull_of(rims[-1])]
    bridge = [block(0.05 * k, 0.034 * k, 0.06 * k, 0.012, 0.004).move(z=0.035 * k),
              cylinder(0.011 * k, 0.03 * k, 18, bevel=0.001).move(z=0.094 * k)]  # fmt: skip
    rings = [
        torus(0.0295 * k, 0.002 * k, 26, 6).move(x=s * 0.034 * k, z=0.003 * k) for s in (-1, 1)
    ]
    return shape(
        [(join(barrels), rubber), (join([*rims, *bridge, *rings]), dark),
         (join(lenses), textures.plain((96, 70, 120)))],
        [*parts, hull_of(*bridge)],
    )  # fmt: skip


def telescope(look: Look) -> Shape:
    """A small telescope on a tripod, pointing up to the left."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "brass", "black", "navy", "red", "silver", "blue")
    tube_tile = look.surface(color, "metal")
    dark = textures.speckles(look.rng, look.own_color("black", "brown", "charcoal"), 4)
    brass = textures.brushed_metal(look.rng, look.own_color("brass", "silver", "gold"))
    profile = [(0, 0), (0.022, 0), (0.022, 0.2), (0.026, 0.2), (0.026, 0.26), (0.022, 0.26),
               (0.022, 0.25), (0, 0.25)]  # fmt: skip
    main = lathe(profile, 26).move(z=-0.1)
    eye = lathe([(0, -0.15), (0.011, -0.15), (0.013, -0.14), (0.013, -0.1), (0, -0.1)], 20)
    bands = [torus(0.0225, 0.0025, 26, 6).move(z=z) for z in (-0.095, -0.02, 0.09)]
    finder = join([cylinder(0.006, 0.07, 12).move(0, 0.036, -0.09),
                     box(0.004, 0.02, 0.008).move(0, 0.028, -0.07)])  # fmt: skip
    rise = look.between(0.35, 0.6)
    high = 0.155

    def up(solid: Solid) -> Solid:
        return solid.turn(1, -(np.pi / 2 - rise)).move(z=high).scale(k, k, k)

    feet, parts = [], []
    for n in range(3):
        a = np.pi / 2 + 2 * np.pi * n / 3
        leg = tube([(0.008 * k * np.cos(a), 0.008 * k * np.sin(a), (high - 0.02) * k),
                    (0.09 * k * np.cos(a), 0.09 * k * np.sin(a), 0.004 * k)],
                   [0.0055 * k, 0.004 * k], 8)  # fmt: skip
        feet.append(leg)
        parts.append(hull_of(leg))
    head = join([cylinder(0.013 * k, 0.022 * k, 16).move(z=(high - 0.035) * k),
                   box(0.016 * k, 0.03 * k, 0.03 * k).move(z=(high - 0.022) * k)])  # fmt: skip
    spread = [tube([_half_leg(n, k, high), (0, 0, 0.06 * k)], 0.0022 * k, 6) for n in range(3)]
    return shape(
        [(up(main), tube_tile), (join([up(eye), up(finder), head]), dark),
         (join([up(b) for b in bands]), brass), (join([*feet, *spread]), dark)],
        [*parts, hull_of(up(main)), hull_of(up(eye)), hull_of(head)],
    )  # fmt: skip


def _half_leg(n: int, k: float, high: float) -> tuple[float, float, float]:
    """Return a point halfway down leg ``n`` of a telescope's tripod."""
    a = np.pi / 2 + 2 * np.pi * n / 3
    return 0.05 * k * float(np.cos(a)), 0.05 * k * float(np.sin(a)), 0.5 * (high - 0.02) * k


def compass(look: Look) -> Shape:
    """A pocket compass lying: its rose and needle up, sometimes with a lid, or on a base plate."""
    r, h = look.between(0.026, 0.034), look.between(0.011, 0.015)
    color = look.color("brass", "silver", "black", "copper", "gold", "red", "teal")
    metal = look.surface(color, "metal")
    face = prints.canvas(128, 128, look.pick([(246, 242, 228), (250, 250, 248), (34, 38, 46)]))
    ink: RGB = (40, 40, 44) if int(face[0, 0, 0]) > 128 else (240, 240, 236)
    for n in range(36):
        a = np.pi * n / 18
        way = [(0.5 + s * np.sin(a), 0.5 - s * np.cos(a)) for s in (0.4 if n % 3 else 0.37, 0.45)]
        prints.stroke(face, way, 0.008, ink)
    for n, word in enumerate("NESW"):
        a = np.pi / 2 * n
        prints.write(face, word, 0.5 + 0.29 * np.sin(a), 0.5 - 0.29 * np.cos(a), 0.13,
                     (190, 40, 40) if word == "N" else ink, bold=True)  # fmt: skip
    turn = look.between(0, 6.28)
    for s, tone in ((1, (206, 40, 40)), (-1, (70, 90, 130))):
        tip = (0.5 + s * 0.36 * np.sin(turn), 0.5 - s * 0.36 * np.cos(turn))
        sides = [(0.5 + 0.045 * np.cos(turn) * e, 0.5 + 0.045 * np.sin(turn) * e) for e in (-1, 1)]
        prints.polygon(face, [sides[0], tip, sides[1]], tone)
    prints.disc(face, 0.5, 0.5, 0.03, (200, 164, 84))
    kind = look.pick(["plain", "lid", "plate"])
    base = 0.003 if kind == "plate" else 0.0
    body = lathe([(0, 0), (0.96 * r, 0), (r, 0.003), (r, h), (0.9 * r, h), (0.88 * r, h - 0.003),
                  (0, h - 0.003)], 36).move(z=base)  # fmt: skip
    dial = cylinder(0.88 * r, 0.0006, 36).move(z=base + h - 0.0031)
    pieces, parts = [(body, metal), (dial, face)], [cylinder_part(r, h, (0, 0, base))]
    if kind == "lid":
        lid = lathe([(0, 0), (r, 0), (r, 0.003), (0.8 * r, 0.005), (0, 0.005)], 36)
        lid = lid.turn(0, 1.9).move(y=1.05 * r, z=h + 0.9 * r)
        loop = torus(0.007, 0.0014, 18, 6).move(y=-r - 0.006, z=0.5 * h)
        pieces.append((join([lid, loop]), metal))
        hinge = box(0.012, 0.008, 0.006).move(y=r + 0.001, z=h - 0.005)
        pieces.append((hinge, metal))
        parts.append(hull_of(lid))
    elif kind == "plate":
        plate = block(2.3 * r, 3.6 * r, 0.0032, 0.006).move(y=0.4 * r)
        grid = prints.canvas(96, 144, (206, 222, 226))
        prints.fill(grid, 0.49, 0.04, 0.02, 0.3, (200, 40, 40))
        for n in range(24):
            prints.fill(grid, 0.0, 0.04 * n + 0.02, 0.05 + 0.03 * (n % 5 == 0), 0.006, (40, 40, 44))
        top = box(2.2 * r, 3.5 * r, 0.0004).move(y=0.4 * r, z=0.003)
        pieces += [(plate, textures.plain((206, 222, 226))), (top, grid)]
        parts.append(hull_of(plate))
    return shape(pieces, parts)


def tripod(look: Look) -> Shape:
    """A small table tripod for a camera or phone, with a ball head and a grip."""
    k = look.between(0.85, 1.15)
    color = look.color("black", "silver", "charcoal", "red", "white", "blue")
    skin = look.surface(color, "metal")
    dark = textures.speckles(look.rng, DARK, 4)
    high = look.between(0.13, 0.2) * k
    legs, tips, parts = [], [], []
    for n in range(3):
        a = -np.pi / 2 + 2 * np.pi * n / 3
        top = np.array([0.012 * k * np.cos(a), 0.012 * k * np.sin(a), high])
        end = np.array([0.085 * k * np.cos(a), 0.085 * k * np.sin(a), 0.008 * k])
        mid = 0.45 * top + 0.55 * end
        upper, lower = tube([top, mid], 0.0075 * k, 10), tube([mid, end], 0.0052 * k, 10)
        tip = ellipsoid(0.016 * k, 0.016 * k, 0.014 * k, 12, 8).move(*end).move(z=-0.001 * k)
        legs += [upper, lower]
        tips.append(tip)
        parts.append(hull_of(upper, lower, tip))
    hub = lathe([(0, 0), (0.02, 0), (0.02, 0.016), (0.012, 0.022), (0, 0.022)], 20).scale(k, k, k)
    hub = hub.move(z=high - 0.008 * k)
    ball = ellipsoid(0.026 * k, 0.026 * k, 0.026 * k, 18, 12).move(z=high + 0.022 * k)
    plate = [cylinder(0.017 * k, 0.006 * k, 24).move(z=high + 0.033 * k),
             cylinder(0.003 * k, 0.006 * k, 10).move(z=high + 0.039 * k)]  # fmt: skip
    knob = lying(cylinder(0.006 * k, 0.014 * k, 12), 0.011 * k, high + 0.022 * k)
    top = [hub, ball, *plate]
    clamp_ = []
    if look.chance(0.5):
        clamp_ = [box(0.03 * k, 0.012 * k, 0.006 * k).move(z=high + 0.042 * k),
                  box(0.03 * k, 0.008 * k, 0.06 * k).move(y=0.006 * k, z=high + 0.042 * k),
                  box(0.03 * k, 0.02 * k, 0.006 * k).move(z=high + 0.1 * k)]  # fmt: skip
    pieces = [(join(legs), skin), (join([*tips, *top, knob, *clamp_]), dark)]
    parts += [hull_of(hub), hull_of(ball, *plate)]
    if clamp_:
        parts.append(hull_of(*clamp_))
    return shape(pieces, parts)


def camera_lens(look: Look) -> Shape:
    """A camera lens standing on its mount, its glass up or capped."""
    r, h = look.between(0.033, 0.04), look.between(0.06, 0.11)
    color = look.color("black", "black", "charcoal", "white", "silver")
    skin = textures.speckles(look.rng, color, 3, 32)
    ribs = textures.stripes([(30, 30, 33), (58, 59, 63)], 48, upright=True, side=192)
    mount = cylinder(0.86 * r, 0.006, 30).move(z=0)
    body = lathe(
        [
            (0, 0.005),
            (0.92 * r, 0.005),
            (0.92 * r, 0.2 * h),
            (r, 0.3 * h),
            (r, 0.92 * h),
            (0.97 * r, h),
            (0.88 * r, h),
            (0.8 * r, h - 0.006),
            (0, h - 0.006),
        ],
        34,
    )
    grip = lathe(
        [(0.9 * r, 0.45 * h), (1.05 * r, 0.45 * h), (1.05 * r, 0.72 * h), (0.9 * r, 0.72 * h)],
        40,
        loop=True,
    )
    mark = torus(1.003 * r, 0.0012, 34, 5).move(z=0.84 * h)
    red = textures.plain(look.own_color("red", "gold", "blue", "white"))
    glass = prints.canvas(96, 96, (26, 30, 44))
    prints.disc(glass, 0.5, 0.5, 0.42, (44, 52, 84))
    prints.disc(glass, 0.5, 0.5, 0.26, (70, 60, 110))
    prints.disc(glass, 0.38, 0.36, 0.09, (160, 180, 210))
    front = lathe([(0, 0), (0.78 * r, 0), (0.5 * r, 0.004), (0, 0.006)], 28,
                  v=[0, 0, 0.5, 1]).move(z=h - 0.007)  # fmt: skip
    pieces = [(join([mount]), textures.plain((176, 178, 184))), (body, skin), (grip, ribs),
              (mark, red)]  # fmt: skip
    parts = [
        cylinder_part(0.86 * r, 0.006),
        hull_of(body),
        cylinder_part(1.04 * r, 0.27 * h, (0, 0, 0.45 * h)),
    ]
    if look.chance(0.4):
        cap = cylinder(0.95 * r, 0.006, 32, bevel=0.001).move(z=h - 0.002)
        pieces.append((cap, textures.plain((44, 45, 49))))
        parts.append(hull_of(cap))
    else:
        disc = cylinder(0.78 * r, 0.0006, 30).move(z=h - 0.0058)
        pieces += [(disc, glass), (front.scale(0.6, 0.6, 1), textures.plain((36, 42, 70)))]
    return shape(pieces, parts)


CATEGORIES = (
    Category("binoculars", binoculars, (0.118, 0.0571, 0.127), 0.6, ("binocular", "field glasses",
             "pair of binoculars", "opera glasses"), ("living",), ("tall",), ("black", "olive")),
    Category("telescope", telescope, (0.294, 0.144, 0.257), 0.9, ("spyglass", "toy telescope",
             "desktop telescope", "telescope eyepiece", "finderscope", "monocular",
             "teleconverter", "spotting scope", "kaleidoscope"), ("living", "office"), ("tall",
             "big"), ("white",
             "brass")),
    Category("compass", compass, (0.0607, 0.0792, 0.0333), 0.07, ("pocket compass",
             "magnetic compass", "hiking compass", "navigation compass", "sighting compass"),
             ("living", "office"),
             ("flat",), ("brass", "silver"), state="lying flat"),
    Category("tripod", tripod, (0.16, 0.14, 0.229), 0.3, ("mini tripod", "camera tripod",
             "phone tripod", "table tripod", "camera stand", "gimbal", "helping hands",
             "phone mount"), ("office",), ("tall",), ("black",
             "silver")),
    Category("camera_lens", camera_lens, (0.077, 0.077, 0.085), 0.4, ("lens", "photo lens",
             "zoom lens", "telephoto lens", "objective", "lens hood", "lens filter", "lens cap"),
             ("office", "living"), ("round",),
             ("black",)),
)  # fmt: skip
"""The module's categories."""
