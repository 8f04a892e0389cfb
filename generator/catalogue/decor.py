"""What stands on a table to look at, or to see by."""

from __future__ import annotations

import itertools

import numpy as np

from . import prints, textures
from .category import Category
from .collision import box_part, cylinder_part, hull_of, hull_part
from .colors import RGB, tinted
from .look import Look
from .shape import Shape, shape
from .solids import (
    Solid,
    arc,
    block,
    box,
    cylinder,
    ellipsoid,
    joined,
    lathe,
    lifted,
    loft,
    rectangle,
    smooth,
    torus,
    tube,
)


def _stem(base: np.ndarray, tip: np.ndarray, thick: float = 0.0022) -> Solid:
    middle = (base + tip) / 2 + np.array([0, 0, 0.12]) * np.linalg.norm(tip[:2] - base[:2])
    return tube(smooth([base, middle, tip], 3), thick, 6)


def _leaf(length: float, width: float, angle: float, lift: float) -> Solid:
    """Return a thin curved leaf that starts at the origin and points along ``angle``."""
    t = np.linspace(0, 1, 7)
    half = width / 2 * np.sin(np.pi * np.clip(t * 0.94 + 0.03, 0, 1)) ** 0.75
    rise = length * (np.sin(lift) * t - 0.35 * np.cos(lift) * t**2)
    along = length * np.cos(lift) * t
    section = np.array([(-1.0, 0.0), (0.0, -0.3), (1.0, 0.0), (0.0, -0.05)])
    thick = np.array([0, 0, 0, 0.0008])
    rings = np.stack(
        [
            np.column_stack([np.full(4, x), section[:, 0] * w, section[:, 1] * w + z + thick])
            for x, w, z in zip(along, half, rise, strict=True)
        ]
    )
    return loft(rings, section, profile=np.column_stack([along, rise])).turned(2, angle)


def vase(look: Look) -> Shape:
    """A curved vase, open at the top; some hold flowers."""
    r, h = look.between(0.045, 0.06), look.between(0.17, 0.24)
    color = look.color("white", "teal", "terracotta", "navy", "cream", "sage", "mustard")
    style, phase = int(look.rng.integers(3)), look.between(0.4, 1.1)
    t = np.linspace(0, 1, 14)
    swell = [
        0.66 + 0.34 * np.sin(np.pi * (0.15 + 0.95 * t)),
        0.62 + 0.38 * np.sin(2 * np.pi * (t * 0.75 + 0.02)) * (1 - 0.35 * t),
        0.75 + 0.25 * np.cos(2 * np.pi * t * 0.8 + phase),
    ][style]
    swell = np.maximum(swell / swell.max(), 0.3)
    outer = np.column_stack([r * swell, h * t])
    wall = 0.004
    inner = np.column_stack([outer[:, 0] - wall, outer[:, 1]])[:1:-1]
    body = lathe(
        [(0, 0), *outer, *inner, (0, inner[-1, 1])],
        v=[0, *np.linspace(0.01, 0.93, 14), *np.linspace(0.95, 0.99, len(inner)), 1],
    )
    glaze = look.surface(color, "ceramic")
    if not look.material:
        other = tinted(color, look.pick([0.6, 1.5]))
        glaze = look.pick(
            [glaze, textures.gradient(tinted(color, 0.6), color, look.rng),
             textures.stacked((glaze, 5), (textures.plain(other), 1), (glaze, 2)),
             textures.spotted(look.rng, color, other, 0.04)]
        )  # fmt: skip
    pieces = [(body, glaze)]
    levels = [0, 4, 9, 13]
    parts = [
        hull_part(_between(body, a * h / 13, b * h / 13)) for a, b in itertools.pairwise(levels)
    ]
    if look.chance(0.45):
        pieces += _flowers(look, float(outer[-1, 0]), h)
    return shape(pieces, parts)


def _between(body: Solid, low: float, high: float) -> np.ndarray:
    """Return a body's vertices between two heights."""
    z = body.vertices[:, 2]
    return body.vertices[(z >= low - 1e-6) & (z <= high + 1e-6)]


def _flowers(look: Look, mouth: float, h: float) -> list[tuple[Solid, textures.Tile]]:
    """Return stems with blossoms and leaves that come out of a mouth at height ``h``."""
    green = textures.plain((74, 122, 62))
    petal = textures.speckled(look.rng, look.fixed("red", "pink", "yellow", "violet", "white"), 8)
    heart = textures.plain((206, 150, 50))
    pieces = []
    for k in range(5):
        angle, out = 2 * np.pi * k / 5 + look.between(-0.3, 0.3), look.between(0.01, 0.05)
        way = np.array([np.cos(angle), np.sin(angle), 0.0])
        tip = way * (mouth + out) + [0, 0, h + look.between(0.07, 0.13)]
        pieces.append((_stem(way * 0.5 * mouth + [0, 0, h - 0.03], tip), green))
        petals = [
            ellipsoid(0.026, 0.016, 0.007, 6, 4).moved(x=0.014, z=0.002).turned(2, np.pi / 3 * m)
            for m in range(6)
        ]
        pieces.append((joined(petals).moved(*tip), petal))
        pieces.append((ellipsoid(0.014, 0.014, 0.01, 8, 4).moved(*tip).moved(z=0.004), heart))
    return pieces


def potted_plant(look: Look) -> Shape:
    """A pot with a leafy plant, a succulent or a cactus."""
    r, h = look.between(0.045, 0.06), look.between(0.075, 0.095)
    color = look.color("terracotta", "white", "gray", "teal", "cream", "black")
    low = 0.75 * r
    pot = lathe(
        [(0, 0), (low, 0), (0.96 * r, 0.8 * h), (r, 0.8 * h), (r, h), (r - 0.005, h),
         (r - 0.005, 0.88 * h), (0, 0.88 * h)], 28,
    )  # fmt: skip
    soil = cylinder(r - 0.006, 0.004, 24).moved(z=0.88 * h)
    pieces = [(pot, look.surface(color, "ceramic")),
              (soil, textures.speckled(look.rng, (74, 54, 40), 14))]  # fmt: skip
    parts = [hull_of(pot)]
    kind = look.pick(["leafy", "leafy", "succulent", "cactus"])
    green = look.fixed("green", "olive", "sage", "teal")
    if kind == "cactus":
        ribs = textures.stripes([green, tinted(green, 0.75)], 9, upright=True, side=128)
        trunk = ellipsoid(0.05, 0.05, 0.15, 20, 12).moved(z=h + 0.05)
        arm = tube(smooth([(0.01, 0, h + 0.05), (0.042, 0, h + 0.055), (0.045, 0, h + 0.1)], 4),
                   0.011, 10)  # fmt: skip
        bloom = ellipsoid(0.02, 0.02, 0.016, 12, 6).moved(z=h + 0.125)
        pieces += [(trunk, ribs), (arm, ribs), (bloom, textures.plain((226, 110, 150)))]
        return shape(pieces, [*parts, hull_of(trunk), hull_of(arm)])
    count, lift = (22, 0.5) if kind == "leafy" else (20, 0.75)
    tile = textures.leaf(look.rng, green).transpose(1, 0, 2)
    leaves = []
    for k in range(count):
        ring = k / count
        long = look.between(0.075, 0.12) if kind == "leafy" else 0.065 * (1.2 - 0.7 * ring)
        wide = (0.45 if kind == "leafy" else 0.55) * long
        base = h * 0.9 + (look.between(0.0, 0.06) if kind == "leafy" else 0.012 * ring)
        steep = lift + (0.9 * ring if kind == "succulent" else look.between(-0.3, 0.75))
        leaves.append(_leaf(long, wide, 2.4 * k, steep).moved(z=base))
    if kind == "leafy":
        trunk = cylinder(0.0045, 0.075, 8).moved(z=0.86 * h)
        pieces.append((trunk, textures.plain((96, 84, 52))))
    crown = joined(leaves)
    pieces.append((crown, tile))
    inner = crown.vertices[np.hypot(*crown.vertices[:, :2].T) < 1.15 * r]
    return shape(pieces, [*parts, hull_part(inner)])


def desk_lamp(look: Look) -> Shape:
    """A lamp: an arm with a tilted shade, or a fabric shade on a foot."""
    color = look.color("black", "white", "teal", "red", "brass", "mustard", "silver")
    skin = textures.speckled(look.rng, color, 3, 32)
    glow = textures.plain((255, 240, 196))
    if look.chance(0.6):
        base = cylinder(0.078, 0.018, 32, bevel=0.004)
        elbow, head = np.array([0.02, 0.07, 0.21]), np.array([0.0, -0.075, 0.36])
        lower = tube([(0, 0.03, 0.012), elbow], 0.006, 10)
        upper = tube([elbow, head], 0.006, 10)
        joint = ellipsoid(0.024, 0.024, 0.024, 14, 8).moved(*elbow)
        wall = 0.003
        shade = lathe(
            [(0, 0.075), (0.024, 0.07), (0.066, -0.01), (0.066 - wall, -0.01), (0.022, 0.065),
             (0, 0.068)], 28,
        )  # fmt: skip
        bulb = ellipsoid(0.042, 0.042, 0.05, 14, 8).moved(z=0.018)
        shade, bulb = (s.turned(0, -0.5).moved(*head).moved(z=-0.04) for s in (shade, bulb))
        return shape(
            [
                (base, skin),
                (lower, skin),
                (upper, skin),
                (joint, skin),
                (shade, skin),
                (bulb, glow),
            ],
            [cylinder_part(0.078, 0.018), hull_of(lower), hull_of(upper), hull_of(shade)],
        )
    foot = lathe([(0, 0), (0.06, 0), (0.06, 0.01), (0.018, 0.03), (0.03, 0.08), (0.012, 0.15),
                  (0.008, 0.22), (0, 0.22)], 28)  # fmt: skip
    cloth = textures.gradient((255, 246, 214), tinted(color, 1.6), look.rng, 2)
    shade = lathe([(0.088, 0.17), (0.06, 0.31), (0.057, 0.31), (0.085, 0.17)], 32, loop=True)
    cap = cylinder(0.057, 0.002, 28).moved(z=0.296)
    bulb = ellipsoid(0.05, 0.05, 0.06, 14, 8).moved(z=0.235)
    return shape(
        [(foot, look.surface(color, "ceramic")), (shade, cloth), (cap, glow), (bulb, glow)],
        [cylinder_part(0.06, 0.012), cylinder_part(0.018, 0.16, (0, 0, 0.012)), hull_of(shade)],
    )


def night_light(look: Look) -> Shape:
    """A small glowing lamp: a mushroom, or a globe on a ring."""
    glow = look.color("yellow", "amber", "cream", "pink", "sky")
    warm = textures.gradient(tinted(glow, 1.55), tinted(glow, 1.2), look.rng, 2)
    foot = look.surface(look.fixed("white", "wooden", "gray"), "plastic")
    r = look.between(0.046, 0.058)
    if look.chance(0.5):
        stem = lathe([(0, 0), (0.62 * r, 0), (0.45 * r, 1.1 * r), (0, 1.1 * r)], 24)
        t = np.linspace(0, np.pi / 2, 8)
        dome = np.column_stack([r * np.cos(t), r * (1.0 + 0.75 * np.sin(t))])
        dome[-1, 0] = 0
        cap = lathe([(0, r), *dome], 28)
        return shape([(stem, foot), (cap, warm)], [hull_of(stem), hull_of(cap)])
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).moved(z=r + 0.012)
    base = cylinder(0.68 * r, 0.026, 28, bevel=0.003)
    return shape([(ball, warm), (base, foot)], [cylinder_part(0.68 * r, 0.026), hull_of(ball)])


def alarm_clock(look: Look) -> Shape:
    """A round twin-bell clock, or a digital one; its face to the viewer."""
    color = look.color("red", "teal", "black", "gold", "white", "pink")
    skin = textures.speckled(look.rng, color, 3, 32)
    if look.chance(0.3):
        x, y, z = look.between(0.12, 0.15), 0.055, 0.065
        face = prints.canvas(128, 56, (18, 20, 22))
        hour, minute = int(look.rng.integers(24)), int(look.rng.integers(60))
        digits = look.pick([(240, 70, 50), (80, 230, 130), (120, 200, 250)])
        prints.write(face, f"{hour}:{minute:02d}", 0.5, 0.5, 0.52, digits, bold=True)
        body = block(x, y, z, 0.01, 0.004)
        view = box(0.9 * x, 0.002, 0.74 * z).moved(y=-y / 2, z=0.13 * z)
        return shape([(body, skin), (view, face)], [box_part(x, y, z)])
    r, depth, lift = look.between(0.042, 0.05), 0.042, 0.014
    middle = r + lift
    case = cylinder(r, depth, 32, bevel=0.003).turned(0, np.pi / 2).moved(y=depth / 2, z=middle)
    face = cylinder(0.88 * r, 0.001, 32).turned(0, np.pi / 2).moved(y=-depth / 2 + 0.0002, z=middle)
    dial = prints.clock_face(look.rng, (250, 246, 234), (40, 40, 44))
    metal = textures.brushed(look.rng, look.fixed("gold", "silver"))
    pieces = [(case, skin), (face, dial)]
    feet, parts = [], [hull_part(case.vertices)]
    for side in (-1, 1):
        bell = ellipsoid(0.036, 0.03, 0.026, 16, 8).turned(1, side * 0.6)
        pieces.append((bell.moved(side * 0.55 * r, 0, middle + 0.98 * r), metal))
        foot = tube([(side * 0.72 * r, 0, 0.0), (side * 0.5 * r, 0, lift + 0.3 * r)], 0.0045, 8)
        feet.append(foot.moved(z=-foot.bounds[0, 2]))
        parts.append(box_part(0.02, 0.026, 0.024, (side * 0.55 * r, 0, middle + 0.9 * r)))
    pieces += [(foot, metal) for foot in feet]
    ear = tube(arc((0, 0), 0.018, 0, np.pi, 8) @ np.array([[1, 0, 0], [0, 0, 1]]), 0.002, 6)
    pieces.append((ear.moved(z=middle + r + 0.008), metal))
    return shape(pieces, [box_part(1.6 * r, 0.034, lift + 0.1 * r), *parts])


def picture_frame(look: Look) -> Shape:
    """A framed picture leaning back on its stand, facing the viewer."""
    x, z = look.between(0.11, 0.16), look.between(0.15, 0.2)
    if look.chance(0.35):
        x, z = z, x
    color = look.color("wooden", "black", "white", "gold", "silver")
    rim, t = 0.014, 0.013
    frame = look.surface(color, "wood" if look.chance(0.5) else "plastic")
    lean = -np.deg2rad(14)
    bars = [
        box(x, t, rim), box(x, t, rim).moved(z=z - rim),
        box(rim, t, z - 2 * rim).moved(x=-(x - rim) / 2, z=rim),
        box(rim, t, z - 2 * rim).moved(x=(x - rim) / 2, z=rim),
    ]  # fmt: skip
    back = box(x - rim, 0.6 * t, z - rim).moved(y=0.15 * t, z=rim / 2)
    mat = box(x - 2 * rim, 0.001, z - 2 * rim).moved(y=-0.18 * t, z=rim)
    view = box(x - 3.4 * rim, 0.001, z - 3.4 * rim).moved(y=-0.22 * t, z=1.7 * rim)
    art = prints.landscape(look.rng, round(128 * x / max(x, z)), round(128 * z / max(x, z)))
    plain, white = textures.plain(tinted(color, 0.6)), textures.plain((246, 244, 238))
    pieces = [(s, frame) for s in bars] + [(back, plain), (mat, white), (view, art)]
    tilted = [(solid.turned(0, lean), tile) for solid, tile in pieces]
    low = min(solid.bounds[0, 2] for solid, _ in tilted)
    tilted = [(solid.moved(z=-low), tile) for solid, tile in tilted]
    slope = np.tan(-lean)
    strut = loft(
        np.stack([lifted(rectangle(0.03, 0.004) + np.array([0, y]), h)
                  for y, h in [(0.5 * z, 0.0), (0.62 * z * slope + 0.4 * t, 0.62 * z)]]),
        rectangle(0.03, 0.004),
    )  # fmt: skip
    panel = hull_of(*[solid for solid, _ in tilted])
    return shape([*tilted, (strut, plain)], [panel, hull_of(strut)])


def candle(look: Look) -> Shape:
    """A pillar candle on a dish, or a scented candle in a glass."""
    r, h = look.between(0.026, 0.036), look.between(0.06, 0.13)
    wax = look.color("cream", "white", "red", "sage", "lavender", "coral")
    tile = textures.gradient(wax, tinted(wax, 1.35), look.rng, 3)
    wick = cylinder(0.0014, 0.016, 6).moved(z=h - 0.004)
    flame = lathe([(0, 0), (0.0045, 0.008), (0.0035, 0.014), (0, 0.026)], 12).moved(z=h + 0.008)
    fire = textures.gradient((255, 150, 40), (255, 236, 140), look.rng, 0)
    lit = [(wick, textures.plain((40, 36, 34))), (flame, fire)]
    tip = cylinder_part(0.003, 0.03, (0, 0, h))
    if look.chance(0.5):
        dish = lathe([(0, 0), (0.9 * r, 0), (1.5 * r, 0.01), (1.45 * r, 0.012), (0.9 * r, 0.004),
                      (0, 0.004)], 28)  # fmt: skip
        body = cylinder(r, h - 0.003, 28, bevel=0.002).moved(z=0.003)
        metal = textures.brushed(look.rng, look.fixed("gold", "silver", "black"))
        return shape(
            [(body, tile), (dish, metal), *lit],
            [hull_of(dish), cylinder_part(r, h - 0.003, (0, 0, 0.003)), tip],
        )
    glass = lathe([(0, 0), (r, 0), (1.05 * r, h + 0.012), (1.05 * r - 0.003, h + 0.012),
                   (r - 0.002, h - 0.004), (0, h - 0.004)], 28,
                  v=[0, 0, 0.9, 0.93, 0.98, 1])  # fmt: skip
    word = look.pick(["CALM", "FIG", "CEDAR", "ROSE"])
    print_ = prints.label(look.rng, word, (90, 84, 78), tinted(wax, 1.3))
    skin = textures.stacked((print_, 90), (tile, 10), side=128)
    return shape([(glass, skin), *lit], [cylinder_part(r, h), tip])


def sculpture(look: Look) -> Shape:
    """A small sculpture on a plinth: a bust, a twist, or balanced stones."""
    color = look.color("white", "bronze", "black", "gray", "gold")
    stone = look.surface(color, look.pick(["marble", "bronze", "stone"]))
    base = block(0.085, 0.085, 0.026, 0.004, 0.002)
    wood = textures.wood(look.rng, look.fixed("charcoal", "brown"), side=64)
    kind = look.pick(["bust", "twist", "stones"])
    if kind == "bust":
        chest = ellipsoid(0.11, 0.062, 0.085, 24, 12).moved(z=0.05)
        neck = cylinder(0.018, 0.05, 20, top=0.016).moved(z=0.078)
        head = ellipsoid(0.054, 0.066, 0.078, 24, 14).moved(y=-0.004, z=0.155)
        nose = ellipsoid(0.012, 0.02, 0.024, 10, 8).moved(y=-0.036, z=0.15)
        hair = ellipsoid(0.062, 0.066, 0.056, 20, 12).moved(y=0.008, z=0.173)
        figure = [chest, neck, head, nose, hair]
    elif kind == "twist":
        square = rectangle(0.05, 0.05)
        rings = []
        for t in np.linspace(0, 1, 13):
            c, s = np.cos(2.4 * t), np.sin(2.4 * t)
            turned = square @ np.array([[c, s], [-s, c]]) * (1 - 0.45 * t)
            rings.append(np.column_stack([turned, np.full(4, 0.025 + 0.15 * t)]))
        figure = [loft(np.stack(rings), square, profile=[(0, t) for t in range(13)])]
    else:
        sizes = [(0.08, 0.04), (0.064, 0.036), (0.05, 0.03), (0.034, 0.024)]
        figure, z = [], 0.024
        for wide, tall in sizes:
            figure.append(
                ellipsoid(wide, 0.85 * wide, tall, 20, 10)
                .turned(1, look.between(-0.12, 0.12))
                .moved(look.between(-0.004, 0.004), 0, z + tall / 2)
            )
            z += tall * 0.9
    return shape(
        [(base, wood), *((solid, stone) for solid in figure)],
        [box_part(0.085, 0.085, 0.026), *[hull_of(solid) for solid in figure]],
    )


def globe(look: Look) -> Shape:
    """A terrestrial globe on a foot, its axis leaning."""
    r = look.between(0.065, 0.08)
    sea: RGB = look.color("blue", "sky", "teal", "tan")
    land = textures.noise(look.rng, 96, 192, (4, 7), 3)
    land[:, -24:] += (land[:, :1] - land[:, -1:]) * np.linspace(0, 1, 24)
    image = prints.canvas(192, 96, sea)
    image[land > 0.12] = (122, 160, 84)
    image[land > 0.5] = (196, 170, 110)
    image[:7] = image[-7:] = (240, 244, 246)
    image[::16] = (image[::16] * 0.9).astype(np.uint8)
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).turned(1, 0.41).moved(z=r + 0.06)
    metal = textures.brushed(look.rng, look.fixed("brass", "silver", "brown"))
    bow = tube(
        np.column_stack([np.sin(t := np.linspace(-0.3, 2.9, 20) + 0.41) * 1.12 * r, 0 * t,
                         -np.cos(t) * 1.12 * r + r + 0.06]), 0.0045, 8,
    )  # fmt: skip
    foot = lathe([(0, 0), (0.72 * r, 0), (0.72 * r, 0.008), (0.2 * r, 0.02), (0.1 * r, 0.058),
                  (0, 0.058)], 28)  # fmt: skip
    return shape(
        [(ball, image), (bow, metal), (foot, metal)],
        [
            cylinder_part(0.72 * r, 0.009),
            cylinder_part(0.16 * r, 0.05, (0, 0, 0.009)),
            hull_of(ball),
        ],
    )


def eyeglasses(look: Look) -> Shape:
    """Spectacles lying with their arms folded out behind, lenses to the viewer."""
    color = look.color("black", "brown", "red", "gold", "navy")
    skin = textures.speckled(look.rng, color, 3, 16)
    sun = look.chance(0.4)
    tint = textures.plain((60, 56, 60) if sun else (206, 222, 228))
    half, tall = 0.027, 0.021
    pieces = []
    for side in (-1, 1):
        rim = torus(1.0, 0.09, 28, 6).scaled(half, tall, 0.024).turned(0, np.pi / 2)
        lens = cylinder(1.0, 0.0015, 28).scaled(half, tall, 1).turned(0, np.pi / 2)
        at = (side * 0.036, 0, tall * 1.09)
        pieces += [(rim.moved(*at), skin), (lens.moved(*at), tint)]
        arm = tube([(side * 0.066, 0, 0.03), (side * 0.067, 0.1, 0.028),
                    (side * 0.064, 0.135, 0.002)], 0.0022, 6)  # fmt: skip
        pieces.append((arm.moved(z=0.0002), skin))
    bridge = tube(smooth([(-0.01, 0, 0.03), (0, 0, 0.034), (0.01, 0, 0.03)], 3), 0.002, 6)
    pieces.append((bridge, skin))
    return shape(
        pieces,
        [
            box_part(0.13, 0.004, 0.045),
            *[box_part(0.004, 0.134, 0.03, (side * 0.066, 0.067, 0)) for side in (-1, 1)],
        ],
    )


CATEGORIES = (
    Category(
        "vase",
        vase,
        (0.14, 0.13, 0.27),
        0.6,
        ("flower vase", "flowers", "flower", "vase of flowers", "bouquet"),
        ("living", "dining", "office"),
        ("tall", "round"),
        ("white", "teal", "navy"),
    ),
    Category(
        "potted_plant",
        potted_plant,
        (0.17, 0.17, 0.185),
        0.6,
        ("plant", "succulent", "cactus", "houseplant", "flower pot", "pot plant", "bonsai"),
        ("office", "living", "coffee"),
        ("tall",),
        ("terracotta", "white"),
    ),
    Category(
        "desk_lamp",
        desk_lamp,
        (0.16, 0.21, 0.36),
        0.9,
        ("lamp", "table lamp", "reading lamp", "light"),
        ("office", "living", "craft"),
        ("tall", "big"),
        ("black", "white", "brass"),
    ),
    Category(
        "night_light",
        night_light,
        (0.105, 0.105, 0.105),
        0.2,
        ("nightlight", "glow lamp", "lantern"),
        ("living", "vanity", "play"),
        ("round",),
        ("yellow", "cream"),
    ),
    Category(
        "alarm_clock",
        alarm_clock,
        (0.095, 0.05, 0.135),
        0.25,
        ("clock", "table clock"),
        ("office", "living"),
        (),
        ("red", "teal", "black"),
    ),
    Category(
        "picture_frame",
        picture_frame,
        (0.15, 0.085, 0.155),
        0.25,
        ("photo frame", "frame", "framed photo", "picture", "photo", "photograph"),
        ("office", "living", "vanity"),
        (),
        ("wooden", "black"),
        state="standing, leaning back",
    ),
    Category(
        "candle",
        candle,
        (0.075, 0.075, 0.12),
        0.2,
        ("scented candle", "pillar candle", "tea light"),
        ("dining", "vanity", "living"),
        ("round",),
        ("cream", "white"),
    ),
    Category(
        "sculpture",
        sculpture,
        (0.09, 0.085, 0.18),
        0.9,
        ("statue", "bust", "statuette", "ornament"),
        ("living", "office"),
        ("tall",),
        ("white", "bronze"),
    ),
    Category(
        "globe",
        globe,
        (0.165, 0.145, 0.215),
        0.6,
        ("world globe", "desk globe"),
        ("office", "living"),
        ("tall",),
        ("blue",),
    ),
    Category(
        "eyeglasses",
        eyeglasses,
        (0.138, 0.14, 0.046),
        0.03,
        ("glasses", "spectacles", "sunglasses", "reading glasses", "eyeglass"),
        ("office", "living", "coffee"),
        (),
        ("black", "brown"),
        state="lying open",
    ),
)
