"""Personal things: clocks, pictures, globes, glasses."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.outlines import arc, ellipse, lift, rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, lathe, loft, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def alarm_clock(look: Look) -> Shape:
    """A round twin-bell clock, or a digital one; its face to the viewer."""
    color = look.color("red", "teal", "black", "gold", "white", "pink", "mint", "navy", "orange")
    skin = textures.speckles(look.rng, color, 3, 32)
    if look.chance(0.3):
        x, y, z = look.between(0.12, 0.15), 0.055, 0.065
        face = prints.canvas(128, 56, (18, 20, 22))
        hour, minute = int(look.rng.integers(24)), int(look.rng.integers(60))
        digits = look.pick([(240, 70, 50), (80, 230, 130), (120, 200, 250)])
        prints.write(face, f"{hour}:{minute:02d}", 0.5, 0.5, 0.52, digits, bold=True)
        body = block(x, y, z, 0.01, 0.004)
        view = box(0.9 * x, 0.002, 0.74 * z).move(y=-y / 2, z=0.13 * z)
        return shape([(body, skin), (view, face)], [box_part(x, y, z)])
    r, depth, lift = look.between(0.042, 0.05), 0.042, 0.014
    middle = r + lift
    case = cylinder(r, depth, 32, bevel=0.003).turn(0, np.pi / 2).move(y=depth / 2, z=middle)
    face = cylinder(0.88 * r, 0.001, 32).turn(0, np.pi / 2).move(y=-depth / 2 + 0.0002, z=middle)
    faces = [((250, 246, 234), (40, 40, 44)), ((30, 32, 38), (240, 238, 230)),
             (tint_color(color, 1.7), (50, 50, 56)), ((206, 226, 230), (30, 50, 80))]  # fmt: skip
    dial = prints.clock_face(look.rng, *look.pick(faces))
    metal = textures.brushed_metal(look.rng, look.own_color("gold", "silver"))
    pieces = [(case, skin), (face, dial)]
    feet, parts = [], [hull_part(case.vertices)]
    for side in (-1, 1):
        bell = ellipsoid(0.036, 0.03, 0.026, 16, 8).turn(1, side * 0.6)
        pieces.append((bell.move(side * 0.55 * r, 0, middle + 0.98 * r), metal))
        foot = tube([(side * 0.72 * r, 0, 0.0), (side * 0.5 * r, 0, lift + 0.3 * r)], 0.0045, 8)
        feet.append(foot.move(z=-foot.bounds[0, 2]))
        parts.append(box_part(0.02, 0.026, 0.024, (side * 0.55 * r, 0, middle + 0.9 * r)))
    pieces += [(foot, metal) for foot in feet]
    ear = tube(arc((0, 0), 0.018, 0, np.pi, 8) @ np.array([[1, 0, 0], [0, 0, 1]]), 0.002, 6)
    pieces.append((ear.move(z=middle + r + 0.008), metal))
    return shape(pieces, [box_part(1.6 * r, 0.034, lift + 0.1 * r), *parts])


def picture_frame(look: Look) -> Shape:
    """A framed picture leaning back on its stand, facing the viewer."""
    x, z = look.between(0.11, 0.16), look.between(0.15, 0.2)
    if look.chance(0.35):
        x, z = z, x
    color = look.color("wooden", "black", "white", "gold", "silver", "teal", "brown", "pink")
    rim, t = look.between(0.007, 0.02), look.between(0.01, 0.016)
    frame = look.surface(color, "wood" if look.chance(0.5) else "plastic")
    lean = -np.deg2rad(14)
    bars = [
        box(x, t, rim), box(x, t, rim).move(z=z - rim),
        box(rim, t, z - 2 * rim).move(x=-(x - rim) / 2, z=rim),
        box(rim, t, z - 2 * rim).move(x=(x - rim) / 2, z=rim),
    ]  # fmt: skip
    back = box(x - rim, 0.6 * t, z - rim).move(y=0.15 * t, z=rim / 2)
    mat = box(x - 2 * rim, 0.001, z - 2 * rim).move(y=-0.18 * t, z=rim)
    inner = rim + look.pick([0.001, 0.01, 0.018])
    view = box(x - 2 * inner, 0.001, z - 2 * inner).move(y=-0.22 * t, z=inner)
    art = prints.artwork(look.rng, round(128 * x / max(x, z)), round(128 * z / max(x, z)))
    plain, white = textures.plain(tint_color(color, 0.6)), textures.plain((246, 244, 238))
    pieces = [(s, frame) for s in bars] + [(back, plain), (mat, white), (view, art)]
    tilted = [(solid.turn(0, lean), tile) for solid, tile in pieces]
    low = min(solid.bounds[0, 2] for solid, _ in tilted)
    tilted = [(solid.move(z=-low), tile) for solid, tile in tilted]
    slope = np.tan(-lean)
    strut = loft(
        np.stack([lift(rectangle(0.03, 0.004) + np.array([0, y]), h)
                  for y, h in [(0.5 * z, 0.0), (0.62 * z * slope + 0.4 * t, 0.62 * z)]]),
        rectangle(0.03, 0.004),
    )  # fmt: skip
    panel = hull_of(*[solid for solid, _ in tilted])
    return shape([*tilted, (strut, plain)], [panel, hull_of(strut)])


def globe(look: Look) -> Shape:
    """A terrestrial globe on a foot, its axis leaning."""
    r = look.between(0.065, 0.08)
    sea: RGB = look.color("blue", "sky", "teal", "tan", "charcoal", "cream", "navy")
    land = textures.noise(look.rng, 96, 192, (4, 7), 3)
    land[:, -24:] += (land[:, :1] - land[:, -1:]) * np.linspace(0, 1, 24)
    image = prints.canvas(192, 96, sea)
    lands = [((122, 160, 84), (196, 170, 110)), ((214, 190, 140), (170, 120, 80)),
             ((226, 200, 90), (206, 110, 80)), ((236, 232, 220), (190, 186, 176))]  # fmt: skip
    low, high = look.pick(lands)
    image[land > 0.12] = low
    image[land > 0.5] = high
    image[:7] = image[-7:] = (240, 244, 246)
    image[::16] = (image[::16] * 0.9).astype(np.uint8)
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).turn(1, 0.41).move(z=r + 0.06)
    metal = textures.brushed_metal(look.rng, look.own_color("brass", "silver", "brown"))
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
    color = look.color("black", "black", "brown", "red", "gold", "navy", "silver", "teal", "pink")
    wire = look.chance(0.3)
    skin = textures.speckles(look.rng, color, 3, 16)
    if look.chance(0.25):
        skin = textures.spots(look.rng, (150, 96, 50), (60, 40, 30), 0.35)
    sun = look.chance(0.4)
    dark = look.pick([(60, 56, 60), (70, 50, 36), (50, 70, 60), (90, 110, 170)])
    tint = textures.plain(dark if sun else (206, 222, 228))
    half, tall = look.between(0.025, 0.0275), look.between(0.016, 0.023)
    square = look.pick([1.0, 1.0, 0.55, 0.7])
    thick = 0.0011 if wire else look.between(0.0018, 0.003)
    curve = ellipse(2, 2, 28)
    curve = np.sign(curve) * np.abs(curve) ** square * [half, tall]
    ring = np.column_stack([curve[:, 0], np.zeros(28), curve[:, 1]])
    pieces = []
    for side in (-1, 1):
        rim = tube(ring, thick, 6, loop=True)
        lens = prism(0.99 * curve, -0.0008, 0.0008).turn(0, np.pi / 2)
        at = (side * 0.036, 0, tall + thick)
        pieces += [(rim.move(*at), skin), (lens.move(*at), tint)]
        hinge = side * (0.036 + half)
        arm = tube([(hinge, 0, 1.35 * tall), (side * 0.067, 0.1, 1.3 * tall),
                    (side * 0.064, 0.135, 0.002)], max(thick, 0.0016), 6)  # fmt: skip
        pieces.append((arm.move(z=0.0002), skin))
    bridge = tube(smooth([(-0.01, 0, 0.03), (0, 0, 0.034), (0.01, 0, 0.03)], 3), 0.002, 6)
    pieces.append((bridge, skin))
    return shape(
        pieces,
        [
            box_part(0.12, 0.0036, 2 * tall),
            *[box_part(0.0036, 0.13, 1.3 * tall, (side * 0.0645, 0.066, 0)) for side in (-1, 1)],
        ],
    )


CATEGORIES = (
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
        (
            "photo frame",
            "frame",
            "framed photo",
            "picture",
            "photo",
            "photograph",
            "loom",
            "knitting loom",
            "weaving loom",
            "painting",
            "framed print",
            "framed painting",
            "oil painting",
            "framed picture",
            "digital photo frame",
            "framed certificate",
        ),
        ("office", "living", "vanity"),
        (),
        ("wooden", "black"),
        state="standing, leaning back",
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
        (
            "glasses",
            "spectacles",
            "sunglasses",
            "reading glasses",
            "eyeglass",
            "lorgnette",
            "pince-nez",
            "3d glasses",
            "safety goggles",
            "safety glasses",
            "lab goggles",
            "swimming goggles",
            "face shield",
        ),
        ("office", "living", "coffee"),
        (),
        ("black", "brown"),
        state="lying open",
    ),
)
