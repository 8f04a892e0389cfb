"""Small devices people carry about."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.forms import facing
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, prism, sweep, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look
from ..tools.tools import lying

DARK = (40, 42, 46)


def hard_drive(look: Look) -> Shape:
    """A portable hard drive lying flat with its short cable."""
    x, y, h = look.between(0.075, 0.085), look.between(0.11, 0.125), look.between(0.012, 0.02)
    color = look.color("black", "silver", "red", "blue", "charcoal", "orange")
    face = prints.canvas(96, 144, color)
    style = int(look.rng.integers(3))
    if style == 0:
        for k in range(6):
            prints.fill(face, 0, 0.1 + 0.14 * k, 1, 0.03, tint_color(color, 0.75))
    elif style == 1:
        prints.fill(face, 0.58, 0, 0.42, 1, tint_color(color, 0.7))
    prints.write(face, look.pick(["1 TB", "2 TB", "SSD", "4 TB"]), 0.5, 0.2, 0.14,
                 readable_on(color), bold=True)  # fmt: skip
    prints.disc(face, 0.86, 0.93, 0.02, (110, 190, 250))
    body = block(x, y, h, 0.008, 0.003)
    top = block(0.94 * x, 0.95 * y, 0.0008, 0.006).move(z=h - 0.0002)
    z = 0.5 * h
    cable = smooth(
        [(0, y / 2, z), (0, y / 2 + 0.018, z), (0.02, y / 2 + 0.042, 0.004),
         (0.058, y / 2 + 0.03, 0.0026), (0.066, y / 2 - 0.02, 0.0026),
         (0.062, y / 2 - 0.062, 0.0032)], 4,
    )  # fmt: skip
    plugs = [box(0.014, 0.022, 0.007).move(0, y / 2 + 0.01, max(z - 0.0035, 0)),
             box(0.014, 0.026, 0.007).move(0.062, y / 2 - 0.07, 0)]  # fmt: skip
    tip = box(0.012, 0.014, 0.0045).move(0.062, y / 2 - 0.088, 0.001)
    return shape(
        [(body, textures.speckles(look.rng, color, 3, 32)), (top, face),
         (join([tube(cable, 0.0024, 6), *plugs]), textures.plain(DARK)),
         (tip, textures.plain((186, 188, 192)))],
        [box_part(x, y, h), hull_of(*plugs[1:], tip)],
    )  # fmt: skip


def action_camera(look: Look) -> Shape:
    """A small action camera, its square lens towards the viewer."""
    k = look.between(0.92, 1.12)
    x, y, z = 0.066 * k, 0.03 * k, 0.048 * k
    color = look.color("black", "charcoal", "gray", "white", "blue")
    body = block(x, y, z, 0.006, 0.003)
    face = prints.canvas(96, 72, tint_color(color, 0.82))
    for j in range(6):
        prints.fill(face, 0.05, 0.1 + 0.14 * j, 0.42, 0.04, tint_color(color, 0.65))
    prints.fill(face, 0.07, 0.58, 0.4, 0.32, (28, 30, 36))
    prints.write(face[44:62, 8:44], look.pick(["4K", "5K", "HD"]), 0.5, 0.5, 0.7, (235, 235, 235),
                 bold=True)  # fmt: skip
    front = box(0.94 * x, 0.0016, 0.92 * z).move(y=-y / 2 - 0.0002, z=0.04 * z)
    mount = facing(prism(rectangle(0.42 * x, 0.42 * x, 0.004, 3), 0, 0.008, 0.001))
    mount = mount.move(0.23 * x, -y / 2, 0.64 * z)
    lens = facing(cylinder(0.011 * k, 0.004, 22, bevel=0.001)).move(
        0.23 * x, -y / 2 - 0.0075, 0.64 * z
    )
    shine = prints.canvas(32, 32, (24, 28, 56))
    prints.disc(shine, 0.4, 0.36, 0.2, (110, 130, 190))
    button = cylinder(0.006, 0.002, 16, bevel=0.0005).move(x=-0.25 * x, z=z - 0.0005)
    feet = [box(0.003, 0.014, 0.009).move(x=0.006 * s) for s in (-1, 0, 1)]
    lamp = look.own_color("red", "orange", "sky")
    base = 0.008 if look.chance(0.6) else 0.0
    raised = [s.move(z=base) for s in (body, front, mount, lens, button)]
    tiles = [textures.speckles(look.rng, color, 4), face,
             textures.plain(tint_color(color, 0.6)), shine, textures.plain(lamp)]  # fmt: skip
    pieces = list(zip(raised, tiles, strict=True))
    parts = [hull_of(raised[0]), hull_of(raised[2], raised[3])]
    if base:
        foot = block(0.034, 0.034, 0.004, 0.006, 0.001)
        pieces.append((join([*feet, foot]), textures.plain(DARK)))
        parts.append(box_part(0.034, 0.034, 0.0085))
    return shape(pieces, parts)


def wristwatch(look: Look) -> Shape:
    """A watch with its strap closed, lying with the dial up."""
    r = look.between(0.018, 0.022)
    smart = look.chance(0.35)
    strap_color = look.color("brown", "black", "silver", "navy", "red", "teal", "tan")
    metal = textures.brushed_metal(look.rng, look.own_color("silver", "gold", "charcoal", "copper"))
    ry, rz = look.between(0.027, 0.03), look.between(0.021, 0.024)
    a = np.linspace(0, 2 * np.pi, 33)[:-1]
    path = np.column_stack([np.zeros(32), ry * np.sin(a), rz + rz * np.cos(a)])
    width = 1.05 * r
    strap = sweep(path, rectangle(width, 0.003, 0.001, 1), loop=True)
    strap = strap.move(z=-float(strap.vertices[:, 2].min()))
    top = float(strap.vertices[:, 2].max())
    if smart:
        case = block(1.7 * r, 2.0 * r, 0.009, 0.006, 0.002).move(z=top - 0.004)
        glass = block(1.5 * r, 1.8 * r, 0.0012, 0.005).move(z=top + 0.0045)
        face = prints.canvas(64, 80, (18, 20, 24))
        prints.write(face, f"{look.rng.integers(1, 13)}:{look.rng.integers(10, 60)}", 0.5, 0.35,
                     0.26, (240, 240, 244), bold=True)  # fmt: skip
        for k, ink in enumerate([(230, 70, 90), (120, 220, 90), (80, 190, 230)]):
            prints.disc(face, 0.25 + 0.25 * k, 0.74, 0.09, ink)
    else:
        case = cylinder(r, 0.009, 30, bevel=0.0015).move(z=top - 0.004)
        glass = cylinder(0.87 * r, 0.0012, 28).move(z=top + 0.0045)
        ground = look.own_color("white", "navy", "black", "cream", "green")
        face = prints.clock_face(look.rng, ground, readable_on(ground))
    crown = lying(cylinder(0.003, 0.004, 10), 0.98 * r if not smart else 0.83 * r, top + 0.0005)
    band = textures.stripes([strap_color, tint_color(strap_color, 0.82)], 14)
    return shape(
        [(strap, band), (join([case, crown]), metal), (glass, face)],
        [box_part(width, 1.1 * ry, 0.004),
         *(hull_part(strap.vertices[(s * strap.vertices[:, 1] > 0.45 * ry)]) for s in (-1, 1)),
         hull_of(case)],
    )  # fmt: skip


def handheld_console(look: Look) -> Shape:
    """A handheld games console lying flat: screen between two coloured grips."""
    k = look.between(0.94, 1.08)
    x, y, h = 0.235 * k, 0.1 * k, 0.0145
    left, right = (
        look.color("red", "black", "teal", "purple"),
        look.own_color("blue", "red", "yellow"),
    )
    if look.chance(0.3):
        right = left
    middle = box(0.7 * x, y, h)
    screen = box(0.66 * x, 0.84 * y, 0.0008).move(z=h)
    picture = prints.landscape(look.rng, 192, 108)
    for _ in range(4):
        prints.fill(picture, look.rng.uniform(0, 0.8), look.rng.uniform(0.5, 0.85), 0.16, 0.06,
                    look.own_color("brown", "green", "orange"))  # fmt: skip
    prints.disc(picture, 0.3, 0.5, 0.06, (220, 50, 40))
    frame = np.pad(picture, ((6, 6), (8, 8), (0, 0)))
    pieces, buttons, sticks = [(middle, textures.plain(DARK)), (screen, frame)], [], []
    for s, color in ((-1, left), (1, right)):
        grip = block(0.16 * x, y, h, 0.03 if y > 0.06 else 0.01, 0.003).move(x=s * 0.42 * x)
        pieces.append((grip, textures.speckles(look.rng, color, 4)))
        up, down = 0.22 * y, -0.12 * y
        stick = join([cylinder(0.0075, 0.005, 16), cylinder(0.0095, 0.003, 18).move(z=0.005)])
        sticks.append(stick.move(s * 0.42 * x, up if s < 0 else down, h))
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            at = (s * 0.42 * x + 0.0085 * dx, (down if s < 0 else up) + 0.0085 * dy, h - 0.0005)
            buttons.append(cylinder(0.0038, 0.0024, 12).move(*at))
    pieces.append((join([*buttons, *sticks]), textures.plain((28, 29, 32))))
    return shape(pieces, [box_part(x, y, h), *(hull_of(s) for s in sticks)])


CATEGORIES = (
    Category("hard_drive", hard_drive, (0.11, 0.16, 0.017), 0.2,
             ("external hard drive", "hard disk", "external drive", "ssd", "portable drive",
              "hdd", "server blade"), ("office", "gaming"), ("flat",), ("black", "silver"),
             state="lying flat"),
    Category("action_camera", action_camera, (0.067, 0.043, 0.055), 0.15,
             ("gopro", "action cam", "sports camera", "dashcam", "dash cam"), ("office",
             "gaming"), (), ("black",)),
    Category("wristwatch", wristwatch, (0.041, 0.062, 0.052), 0.07,
             ("watch", "wrist watch", "smartwatch", "smart watch", "hand watch",
             "digital watch", "nurse watch", "gold watch", "kid watch", "kids watch", "swatch",
             "chronograph", "fitness tracker", "fitness band", "watch strap", "smart band"),
             ("vanity", "office"), (), ("brown", "black"), state="lying, strap closed"),
    Category("handheld_console", handheld_console, (0.235, 0.1, 0.0225), 0.4,
             ("handheld game", "portable console", "nintendo switch",
              "handheld game console", "game boy", "gameboy"), ("gaming", "toys"), ("flat",),
             ("red", "black"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
