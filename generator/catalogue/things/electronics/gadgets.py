"""Sound, cameras and things with buttons."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.outlines import arc, rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, prism, sweep, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

DARK = (40, 41, 45)


def headphones(look: Look) -> Shape:
    """Over-ear headphones lying on their cups and the back of their band."""
    color = look.color("black", "black", "white", "navy", "red", "silver", "pink", "teal", "cream")
    pad = look.own_color("black", "brown", "gray", "white", "tan")
    other = look.pick([color, color, tint_color(color, 0.5), tint_color(color, 1.5)])
    outer = textures.speckles(look.rng, other, 3, 32)
    badge = look.pick([None, (200, 170, 90), (214, 60, 60), (230, 232, 236)])
    shell = textures.speckles(look.rng, color, 3, 32)
    soft = textures.speckles(look.rng, tint_color(pad, 0.9), 4, 32)
    r, half = look.between(0.031, 0.04), look.between(0.07, 0.081)
    wide, thick = look.between(0.016, 0.03), look.between(0.005, 0.01)
    curve = arc((0, 0), half, 0, np.pi, 18) * [1, 1.2]
    cups, cushions = [], []
    for side in (-1, 1):
        way = -side * 0.45 * np.pi
        cups.append(cylinder(r, 0.018, 24, bevel=0.005).move(z=-0.009).turn(1, way))
        cushions.append(torus(r - 0.011, 0.0105, 24, 8).move(z=0.014).turn(1, way))
    lift = -min(solid.bounds[0, 2] for solid in cups + cushions)
    drop = (lift - 0.013) / curve[:, 1].max()  # the band's far end touches the table
    path = np.column_stack([curve, lift - drop * curve[:, 1]])
    band = sweep(path, rectangle(thick, wide, 0.4 * thick, 2))
    band = band.move(z=max(0.0, -band.bounds[0, 2]))
    cups = [c.move(x=side * half, z=lift) for c, side in zip(cups, (-1, 1), strict=True)]
    cushions = [c.move(x=side * half, z=lift) for c, side in zip(cushions, (-1, 1), strict=True)]
    across = band.vertices[:, 0]
    spans = [np.abs(across - c) <= 0.26 * half for c in np.linspace(-0.75, 0.75, 4) * half]
    pieces = [(band, shell), *[(c, outer) for c in cups], *[(c, soft) for c in cushions]]
    if badge is not None:
        for side in (-1, 1):
            mark = cylinder(0.4 * r, 0.001, 18).move(z=-0.0097).turn(1, -side * 0.45 * np.pi)
            pieces.append((mark.move(x=side * half, z=lift), textures.plain(badge)))
    return shape(
        pieces,
        [
            *[hull_of(a, b) for a, b in zip(cups, cushions, strict=True)],
            *[hull_part(band.vertices[span]) for span in spans],
        ],
    )


def speaker(look: Look) -> Shape:
    """A small loudspeaker box with two drivers facing the viewer."""
    x, y, z = look.between(0.1, 0.12), look.between(0.1, 0.125), look.between(0.17, 0.2)
    color = look.color("black", "walnut brown", "white", "charcoal", "teal", "red", "cream", "sage")
    if look.chance(0.35):
        return _mesh_speaker(look, color, x, y, z)
    cone_color, metal = (
        look.own_color("charcoal", "amber", "gray", "white", "red"),
        look.chance(0.6),
    )
    body = block(x, y, z, look.pick([0.0, 0.008, 0.02]))
    front = box(x * 0.94, 0.004, z * 0.96).move(y=-y / 2 - 0.001, z=0.02 * z)
    face = textures.plain(look.pick([tint_color(DARK, 0.9), tint_color(color, 0.85)]))
    pieces = [(body, look.surface(color, look.pick(["plastic", "wood"]))), (front, face)]
    for radius, height in [(0.36 * x, 0.33), (0.2 * x, 0.76)]:
        at = {"y": -y / 2 - 0.003, "z": height * z}
        ring = torus(radius, 0.003, 28, 6).turn(0, np.pi / 2).move(**at)
        cone = cylinder(radius, 0.002, 28).turn(0, np.pi / 2).move(**at)
        cap = ellipsoid(0.8 * radius, 0.012, 0.8 * radius, 16, 8).move(**at)
        pieces += [
            (ring, textures.plain((150, 152, 156) if metal else (60, 62, 66))),
            (cone, textures.plain(cone_color)),
            (cap, textures.plain(DARK)),
        ]
    return shape(pieces, [box_part(x, y, z)])


def _mesh_speaker(look: Look, color: RGB, x: float, y: float, z: float) -> Shape:
    """Return a portable speaker: a rounded body in cloth or grille, a strip of buttons on top."""
    skin = textures.fabric(look.rng, color)
    if look.chance(0.4):
        skin = prints.mesh_holes(color, tint_color(color, 0.5), 16, 32)
    if look.chance(0.5):
        body = cylinder(0.5 * x, z, 32, bevel=0.008).scale(1, y / x, 1)
    else:
        body = block(x, y, z, 0.45 * y, 0.006)
    ends = [block(0.9 * x, 0.9 * y, 0.006, 0.4 * y, 0.002).move(z=h) for h in (0.0, z - 0.003)]
    image = prints.canvas(64, 64, tint_color(color, 0.5))
    prints.write(image, "-  +", 0.5, 0.5, 0.3, (240, 240, 240))
    badge = box(0.3 * x, 0.003, 0.05 * z).move(y=-0.5 * y, z=look.between(0.1, 0.8) * z)
    return shape(
        [(body, skin), (ends[0], textures.plain(DARK)), (ends[1], image),
         (badge, textures.plain((226, 226, 224)))],
        [hull_of(body)],
    )  # fmt: skip


def remote_control(look: Look) -> Shape:
    """A television remote lying flat, buttons up, pointing away."""
    x, y, h = look.between(0.038, 0.052), look.between(0.145, 0.2), look.between(0.012, 0.021)
    color = look.color("black", "black", "charcoal", "white", "gray", "silver", "navy", "beige")
    body = block(x, y, h, look.pick([0.004, 0.012, 0.018]), 0.004)
    pad, rows, low = look.pick([0.16, 0.34]), look.pick([2, 3, 4, 5]), look.between(0.5, 0.6)
    face = prints.canvas(48, 176, color)
    ink = readable_on(color)
    prints.disc(face, 0.5, 0.06, 0.022, (206, 52, 46))
    square, caps = look.chance(0.4), look.pick([tint_color(ink, 0.8), tint_color(color, 1.35)])
    for row in range(rows):
        for k in range(3):
            at = (0.25 + 0.25 * k, pad + 0.062 * row)
            if square:
                prints.fill(face, at[0] - 0.08, at[1] - 0.016, 0.16, 0.032, caps)
            else:
                prints.disc(face, *at, 0.02, caps)
    ring = low + 0.08 if pad < 0.2 else 0.2
    prints.disc(face, 0.5, ring, 0.09, tint_color(ink, 0.6), 0.045)
    prints.disc(face, 0.5, ring, 0.03, ink)
    for k, tint in enumerate([(206, 52, 46), (70, 160, 80), (230, 190, 60), (60, 110, 200)]):
        prints.fill(face, 0.14 + 0.19 * k, 0.76, 0.14, 0.025, tint)
    return shape(
        [(body, textures.plain(color)), (box(x * 0.76, y * 0.93, 0.0008).move(z=h), face)],
        [box_part(x, y, h)],
    )


def walkie_talkie(look: Look) -> Shape:
    """A hand radio standing upright: speaker grille, display, antenna."""
    x, y, z = look.between(0.055, 0.062), look.between(0.032, 0.038), look.between(0.1, 0.115)
    color = look.color("black", "yellow", "red", "olive", "blue", "orange", "gray", "teal")
    shell, dark = textures.speckles(look.rng, color, 3, 32), textures.plain(DARK)
    body = block(x, y, z, 0.01, 0.003)
    grille = box(x * 0.7, 0.002, z * 0.34).move(y=-y / 2 - 0.0005, z=0.1 * z)
    view = box(x * 0.6, 0.002, z * 0.18).move(y=-y / 2 - 0.0005, z=0.68 * z)
    screen = prints.canvas(64, 32, (150, 190, 150))
    prints.write(screen, f"CH {int(look.rng.integers(1, 23))}", 0.5, 0.5, 0.5, (30, 50, 30))
    antenna = cylinder(0.007, 0.075, 14, top=0.0055, bevel=0.001).move(x=-0.3 * x, z=z)
    knob = cylinder(0.0075, 0.013, 14, bevel=0.001).move(x=0.25 * x, z=z)
    button = box(0.004, 0.014, 0.03).move(x=-x / 2 - 0.001, z=0.55 * z)
    return shape(
        [
            (body, shell),
            (grille, prints.mesh_holes((70, 70, 74), (20, 20, 22), 7, 7)),
            (view, screen),
            (antenna, dark),
            (knob, dark),
            (button, dark),
        ],
        [
            box_part(x, y, z),
            cylinder_part(0.007, 0.075, (-0.3 * x, 0, z)),
            cylinder_part(0.0075, 0.013, (0.25 * x, 0, z)),
        ],
    )


def camera(look: Look) -> Shape:
    """A photo camera, its lens towards the viewer."""
    x, y, z = look.between(0.118, 0.132), look.between(0.042, 0.05), look.between(0.072, 0.082)
    color = look.color("black", "black", "silver", "brown", "navy", "red", "teal", "cream", "pink")
    leather = textures.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.6), 0.2)
    metal = textures.speckles(look.rng, look.own_color("black", "silver", "charcoal"), 3, 32)
    r, reach = look.between(0.3, 0.43) * z, look.between(0.02, 0.055)
    body = block(x, y, z * 0.76, 0.012)
    top = block(x, y, z * 0.24, 0.012, 0.002).move(z=z * 0.76)
    tall, aside = look.between(0.006, 0.022), look.pick([0.0, 0.0, -0.25 * x])
    hump = block(0.042, y * 0.9, tall, 0.4 * tall, 0.2 * tall).move(x=aside, z=z - 0.002)
    lens = cylinder(r, reach, 28, bevel=0.002).turn(0, np.pi / 2).move(y=-y / 2 + 0.001, z=0.46 * z)
    ring = torus(r - 0.003, 0.003, 28, 6).turn(0, np.pi / 2).move(y=-y / 2 - reach, z=0.46 * z)
    glass = (
        cylinder(r - 0.006, 0.001, 24).turn(0, np.pi / 2).move(y=-y / 2 - reach + 0.001, z=0.46 * z)
    )
    dial = cylinder(0.009, 0.007, 16).move(x=0.35 * x, z=z - 0.001)
    button = cylinder(0.005, 0.006, 14).move(x=-0.37 * x, z=z - 0.001)
    shine = prints.canvas(32, 32, (28, 34, 62))
    prints.disc(shine, 0.35, 0.35, 0.15, (120, 140, 190))
    low = 0.46 * z - r
    pieces = [
        (body, leather),
        (top, metal),
        (hump, metal),
        (lens, metal),
        (ring, textures.plain((70, 72, 78))),
        (glass, shine),
        (dial, textures.plain((170, 172, 176))),
        (button, textures.plain((190, 60, 50))),
    ]
    return shape(
        pieces,
        [
            box_part(x, y, z),
            box_part(0.042, y * 0.9, tall - 0.003, (aside, 0, z)),
            cylinder_part(r, reach, (0, -y / 2 - reach, low + r), 1),
        ],
    )


def game_controller(look: Look) -> Shape:
    """A game pad lying flat: two grips, sticks, buttons."""
    color = look.color("black", "white", "blue", "red", "purple", "teal", "pink", "gray", "lime")
    shell = textures.speckles(look.rng, color, 3, 32)
    dark = textures.plain(
        look.pick([tint_color(DARK, 0.8), (226, 226, 228), tint_color(color, 0.5)])
    )
    rear = look.pick([shell, textures.speckles(look.rng, tint_color(color, 0.55), 3, 32)])
    low = look.pick([0.0, 0.0, -0.02])  # where the left stick sits
    span = look.between(0.92, 1.06)
    half = np.array(  # from the middle of the front round to the middle of the back
        [
            (0, -0.018),
            (0.028, -0.02),
            (0.042, -0.048),
            (0.058, -0.062),
            (0.073, -0.056),
            (0.078, -0.036),
            (0.072, 0.012),
            (0.056, 0.036),
            (0.026, 0.038),
        ]
    ) * [1.0, span]
    outline = np.concatenate([half, half[:0:-1] * [-1, 1]])
    body = prism(outline, 0.004, 0.03)
    back = prism(outline * 0.93, 0.0, 0.034)
    pieces = [(body, rear), (back, shell)]
    for x, y in [(-0.026 + low, -0.004 - 0.6 * low), (0.026, -0.004)]:
        pieces.append((cylinder(0.0095, 0.014, 18, bevel=0.002).move(x, y, 0.033), dark))
    paints = [(206, 52, 46), (70, 160, 80), (60, 110, 200), (230, 190, 60)]
    for k, paint in enumerate(paints):
        angle = np.pi / 2 * k
        at = (0.05 + 0.0095 * np.cos(angle), 0.015 + 0.0095 * np.sin(angle))
        pieces.append((cylinder(0.0045, 0.005, 12).move(*at, 0.033), textures.plain(paint)))
    cross = [box(*size, 0.004) for size in ((0.022, 0.0075), (0.0075, 0.022))]
    pieces += [(bar.move(-0.05 - 1.1 * low, 0.015 + low, 0.033), dark) for bar in cross]
    right = prism(half[1:], 0.0, 0.034)
    left = prism((half[1:] * [-1, 1])[::-1], 0.0, 0.034)
    return shape(
        pieces,
        [hull_of(right), hull_of(left), box_part(0.056, 0.05 * span, 0.034, (0, 0.009 * span, 0))],
    )


def _mark(color: RGB, y: float, z: float, shown: bool) -> list[tuple[Solid, textures.Tile]]:
    """Return a maker's mark on the front, if shown."""
    mark = box(0.012, 0.0008, 0.005).move(y=-y / 2, z=0.74 * z)
    return [(mark, textures.plain(tint_color(color, 0.5)))] if shown else []


def earbuds_case(look: Look) -> Shape:
    """A closed charging case for earbuds."""
    color = look.color("white", "white", "black", "mint", "navy", "pink", "red", "lavender", "teal")
    x, y, z = look.between(0.05, 0.064), look.between(0.021, 0.028), look.between(0.04, 0.052)
    lamp, mark = look.pick([(90, 220, 120), (240, 160, 60), (250, 250, 250)]), look.chance(0.5)
    low = block(x, y, z * 0.62, 0.0115, 0.0015)
    lid = block(x, y, z * 0.37, 0.0115, 0.0015).move(z=0.63 * z)
    light = box(0.003, 0.001, 0.003).move(y=-y / 2, z=0.42 * z)
    shell = textures.speckles(look.rng, color, 2, 16)
    return shape(
        [
            (low, shell),
            (lid, shell),
            (light, textures.plain(lamp)),
            *_mark(color, y, z, mark),
        ],
        [box_part(x, y, z * 0.62), box_part(x, y, z * 0.37, (0, 0, 0.63 * z))],
    )


CATEGORIES = (
    Category("headphones", headphones, (0.185, 0.135, 0.073), 0.25, ("headphone", "earphones",
             "ear defenders"), ("office", "living"), (), ("black", "white"), state="lying down"),
    Category("speaker", speaker, (0.11, 0.12, 0.185), 0.9, ("loudspeaker", "bluetooth speaker"),
             ("office", "living"), ("tall",), ("black", "white")),
    Category("remote_control", remote_control, (0.046, 0.172, 0.019), 0.1, ("remote", "tv remote",
             "remote controller"), ("living",), ("flat",), ("black",), state="lying flat"),
    Category("walkie_talkie", walkie_talkie, (0.06, 0.038, 0.183), 0.19, ("walkie-talkie",
             "two-way radio", "hand radio"), ("workbench",), ("tall",), ("black", "yellow")),
    Category("camera", camera, (0.125, 0.085, 0.093), 0.45, ("photo camera", "digital camera",
             "dslr", "leica", "polaroid camera", "film camera", "slr camera", "mirrorless camera"),
             ("living", "craft", "office"), (), ("black", "silver")),
    Category("game_controller", game_controller, (0.156, 0.1, 0.047), 0.23, ("gamepad",
             "controller", "game pad"), ("play", "living"), (), ("black", "white"),
             state="lying flat"),
    Category("earbuds_case", earbuds_case, (0.058, 0.024, 0.046), 0.045, ("earbuds", "airpods",
             "earbud case", "airpods case", "wireless earbuds case"), ("office", "coffee"), (),
             ("white", "black")),
)  # fmt: skip
