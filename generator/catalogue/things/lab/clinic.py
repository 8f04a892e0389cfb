"""Medical things: syringe, fever thermometer, roll of bandage."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.outlines import rectangle, rounded_polygon, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, prism, sweep
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def syringe(look: Look) -> Shape:
    """A syringe lying with its tip to the left: scale, plunger, wings, a needle or its cap."""
    r, long = look.between(0.0075, 0.012), look.between(0.068, 0.086)
    color = look.color("sky", "orange", "green", "pink", "purple", "blue", "yellow")
    pull, filled = look.between(0.2, 0.55), look.chance(0.6)
    fluid = look.own_color("cream", "red", "sky", "amber", "mint") if filled else (222, 230, 234)
    clear = (226, 233, 236)
    barrel = prints.canvas(96, 128, clear)
    prints.fill(barrel, 0, 0, 1, 1 - pull, tint_color(fluid, 1.1))
    prints.fill(barrel, 0, 1 - pull, 1, 0.09, (46, 46, 50))
    for k in range(21):
        wide = 0.22 if k % 5 == 0 else 0.12
        prints.fill(barrel, 0.26, 0.05 + 0.042 * k, wide, 0.011, (30, 44, 70))

    def lay(height: float, radius: float, x: float, top: float | None = None) -> Solid:
        solid = cylinder(radius, height, 16, top=top).turn(1, -np.pi / 2)
        return solid.move(x + height, 0, r)

    plain, dark = textures.plain((236, 240, 242)), textures.plain(color)
    body = lay(long, r, 0)
    wings = block(0.0028, 4.4 * r, 1.3 * r, 0.0012).move(long, 0, 0.35 * r)
    rod = long * (0.2 + pull)
    cross = [box(rod, 0.0022, 1.3 * r).move(long + rod / 2, 0, 0.35 * r),
             box(rod, 1.3 * r, 0.0022).move(long + rod / 2, 0, r - 0.0011)]  # fmt: skip
    thumb = lay(0.003, 0.95 * r, long + rod)
    nose = lay(0.006, 0.32 * r, -0.006)
    hub = lay(0.011, 0.28 * r, -0.015, 0.45 * r)
    capped = look.chance(0.4)
    reach = 0.036 if capped else 0.032
    tip = lay(reach, 0.3 * r if capped else 0.0005, -0.012 - reach, 0.42 * r if capped else 0.0005)
    grip = dark if look.chance(0.5) else plain
    pieces = [(body, barrel), (join([wings, nose]), plain), (join(cross), grip), (thumb, grip),
              (hub, dark), (tip, dark if capped else textures.plain((176, 180, 186)))]  # fmt: skip
    needle = box_part(reach + 0.012, 0.5 * r, 0.5 * r, (-(reach + 0.012) / 2, 0, 0.75 * r))
    return shape(
        pieces,
        [box_part(long, 1.5 * r, 2 * r, (long / 2, 0, 0)), hull_of(wings), needle,
         box_part(rod, 1.3 * r, 1.3 * r, (long + rod / 2, 0, 0.35 * r)), hull_of(thumb)],
    )  # fmt: skip


def thermometer(look: Look) -> Shape:
    """A digital fever thermometer: slim tip to the left, display, button."""
    k, wide = look.between(0.92, 1.08), look.between(0.008, 0.0115)
    color = look.color("white", "white", "sky", "mint", "pink", "teal", "yellow")
    accent = look.own_color("blue", "teal", "pink", "orange", "green", "gray", "violet")
    neck = look.between(-0.025, -0.005)
    half = np.array([(-0.05, -0.0028), (neck, -0.0035), (neck + 0.02, -wide), (0.07, -wide)])
    corners = np.concatenate([half, half[::-1] * [1, -1]]) * [k, 1]
    high = look.between(0.0095, 0.012)
    skin = textures.speckles(look.rng, color, 3, 32)
    low = prism(rounded_polygon(corners[[0, 3, 4, 7]], 0.0022), 0.002, 0.6 * high, 0.001)
    grip = np.array([(neck, -0.004), (neck + 0.02, -wide), (0.07, -wide), (0.07, wide),
                     (neck + 0.02, wide), (neck, 0.004)]) * [k, 1]  # fmt: skip
    body = prism(rounded_polygon(grip, 0.0025), 0, high, 0.002)
    metal = cylinder(0.0026, 0.012, 12, top=0.0022, bevel=0.0008).turn(1, -np.pi / 2)
    metal = metal.move(-0.048 * k, 0, 0.002 + 0.3 * high)
    lit = look.pick(
        [(176, 196, 172), (196, 204, 196), (120, 214, 140), (240, 170, 90), (34, 40, 52)]
    )
    face = prints.canvas(96, 40, lit)
    ink = (34, 38, 40) if sum(lit) > 300 else (220, 240, 250)
    prints.write(face, look.pick(["36.6", "37.2", "38.5", "39.1", "36.9", "98.6"]), 0.46, 0.5, 0.62,
                 ink, bold=True)  # fmt: skip
    start = neck + 0.024
    bezel = block(0.036 * k, 1.5 * wide, 0.0012, 0.002).move((start + 0.016) * k, 0, high - 4e-4)
    screen = box(0.028 * k, 1.1 * wide, 0.0006).move((start + 0.016) * k, 0, high + 7e-4)
    knob = cylinder(0.5 * wide, 0.0022, 20, bevel=6e-4).move(0.058 * k, 0, high - 4e-4)
    if look.chance(0.5):
        knob = block(0.014, wide, 0.0022, 0.003, 6e-4).move(0.058 * k, 0, high - 4e-4)
    trim = textures.plain(accent)
    pieces = [(low, skin), (body, skin), (metal, textures.plain((186, 190, 196))), (bezel, trim),
              (screen, face), (knob, trim)]  # fmt: skip
    return shape(pieces, [hull_of(body), hull_of(low), hull_of(metal)])


def bandage_roll(look: Look) -> Shape:
    """A roll of gauze or elastic bandage on its end, its tail loose or held by clips or tape."""
    r, h = look.between(0.02, 0.032), look.between(0.05, 0.09)
    color = look.color("white", "white", "cream", "tan", "beige", "blue", "pink", "green", "red")
    ridged = look.chance(0.5)
    cloth = textures.fabric(look.rng, color, threads=40)
    if ridged:
        cloth = np.clip(cloth * (1 - 0.14 * (np.arange(128) % 6 < 2))[None, :, None], 0, 255)
    edge = look.own_color("blue", "red", "navy") if look.chance(0.3) else None
    image = cloth.astype(np.uint8)
    if edge is not None:
        for at in (0.06, 0.9):
            prints.fill(image, 0, at, 1, 0.04, edge)
    side = 128
    v, u = (np.mgrid[0:side, 0:side] + 0.5) / side - 0.5
    away, around = np.hypot(u, v), np.arctan2(v, u)
    shade = 0.8 + 0.2 * np.sin(2 * np.pi * (9 * 2 * away) + around)
    shade[away < 0.08] = 0.35
    spiral = np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)
    body = cylinder(r, h, 32, bevel=0.0008)
    cap = cylinder(0.97 * r, 0.0008, 32).move(z=h - 2e-4)
    pieces = [(body, image), (cap, spiral)]
    parts = [cylinder_part(r, h)]
    kind = look.pick(["tail", "tail", "clips", "tape", "label"])
    if kind == "tail":
        out = look.between(0.02, 0.045)
        path = smooth(
            [
                (-0.3 * r, -0.97 * r, h / 2),
                (0.4 * r, -1.0 * r, h / 2),
                (r + 0.4 * out, -1.0 * r, h / 2),
                (r + out, -1.0 * r - 0.3 * out, h / 2),
            ],
            4,
        )
        tail = sweep(path, rectangle(0.0014, 0.995 * h))
        pieces.append((tail, textures.plain(tint_color(color, 0.95))))
        parts.append(hull_of(sweep(path[-6:], rectangle(0.0014, 0.995 * h)).move(z=-0.0025 * h)))
    elif kind == "clips":
        for z in (0.3, 0.62):
            clip = block(0.016, 0.002, 0.007, 0.0008).move(0, -r, z * h)
            pieces.append((clip, textures.plain((206, 172, 96))))
    else:
        tall = 0.24 if kind == "tape" else 0.5
        band = prints.canvas(160, 64, look.own_color("white", "blue", "green", "red"))
        ink = (246, 246, 242) if band[0, 0].sum() < 600 else (206, 44, 44)
        if kind == "label":
            prints.fill(band, 0.44, 0.43, 0.12, 0.14, ink)
            prints.fill(band, 0.475, 0.29, 0.05, 0.42, ink)
        ring = cylinder(r + 6e-4, tall * h, 32).move(z=(0.5 - tall / 2) * h)
        pieces.append((ring, band))
    return shape(pieces, parts)


CATEGORIES = (
    Category("syringe", syringe, (0.165, 0.043, 0.0195), 0.012,
             ("injection", "hypodermic needle", "medical syringe", "needle syringe",
             "solder sucker", "desoldering pump", "butterfly needle", "cannula", "epipen",
             "amalgam gun"),
             ("medical", "lab"), ("flat",), ("sky", "orange"), state="lying flat"),
    Category("thermometer", thermometer, (0.126, 0.0195, 0.0125), 0.015,
             ("digital thermometer", "medical thermometer", "fever thermometer",
              "clinical thermometer", "clinical digital thermometer", "depth sounder",
              "galileo thermometer", "barometer tube"),
             ("medical",), ("flat",), ("white", "sky"), state="lying flat"),
    Category("bandage_roll", bandage_roll, (0.063, 0.055, 0.07), 0.03,
             ("bandage", "roll of bandage", "gauze roll", "roll of gauze",
              "elastic bandage", "medical bandage",
             "triangular bandage", "cotton wool roll", "cotton roll", "arm sling", "knee brace",
             "neck brace", "wrist splint", "finger splint", "compression bandage", "sam splint",
             "sling"),
             ("medical",), ("round",), ("white", "tan")),
)  # fmt: skip
"""The module's categories."""
