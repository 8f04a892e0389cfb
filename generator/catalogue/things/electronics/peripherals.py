"""What is plugged into a computer, and a small one itself."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import facing
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK: RGB = (36, 37, 41)


def usb_stick(look: Look) -> Shape:
    """A USB stick: capped, swivelling in a metal bow, or all of metal."""
    x, y, h = look.between(0.038, 0.046), look.between(0.015, 0.019), look.between(0.007, 0.009)
    color = look.color("black", "red", "blue", "silver", "white", "green", "orange", "purple")
    steel = textures.plain((198, 200, 206))
    body = block(x, y, h, 0.003, 0.001)
    plug = box(0.0125, 0.012, 0.0045).move(x=-x / 2 - 0.006, z=0.5 * h - 0.00225)
    dots = box(0.002, 0.007, 0.0003).move(x=-x / 2 - 0.007, z=0.5 * h + 0.0021)
    skin = look.surface(color, look.pick(["plastic", "metal"]))
    pieces = [(body, skin), (plug, steel), (dots, textures.plain(DARK))]
    parts = [box_part(x, y, h), hull_of(plug)]
    kind = look.pick(["plain", "swivel", "label"])
    if kind == "swivel":
        bow = [block(0.8 * x, y + 0.0004, 0.0012, 0.003).move(x=0.12 * x, z=z)
               for z in (-0.0004, h - 0.0006)]  # fmt: skip
        pin = cylinder(0.0032, h + 0.0014, 14).move(x=0.36 * x)
        pieces += [(join(bow), steel), (pin, textures.plain((150, 152, 158)))]
    elif kind == "label":
        sign = prints.canvas(64, 32, tint_color(color, 1.4))
        prints.write(sign, look.pick(["16 GB", "32GB", "64GB", "USB"]), 0.5, 0.5, 0.5, (30, 30, 34))
        pieces.append((box(0.6 * x, 0.7 * y, 0.0003).move(z=h - 0.0001), sign))
    return shape(pieces, parts)


def charger(look: Look) -> Shape:
    """A plug-in charger lying on its back: a block with two pins to the left, a socket, a cable."""
    x, y, h = look.between(0.04, 0.055), look.between(0.04, 0.06), look.between(0.027, 0.033)
    color = look.color("white", "white", "black", "gray", "charcoal", "sky")
    body = block(x, y, h, 0.008, 0.004)
    steel = textures.plain((206, 206, 206))
    pins = [
        cylinder(0.0022, 0.018, 12).turn(0, -np.pi / 2).move(s * 0.0095, y / 2 - 0.001, 0.5 * h)
        for s in (-1, 1)
    ]
    if look.chance(0.5):
        pins = [box(0.0015, 0.018, 0.0065).move(s * 0.0064, y / 2 + 0.008, 0.5 * h - 0.003)
                for s in (-1, 1)]  # fmt: skip
    port = box(0.011, 0.0006, 0.005).move(y=-y / 2 - 0.0002, z=0.5 * h - 0.002)
    sign = prints.canvas(48, 48, tint_color(color, 0.97))
    ink = tint_color(color, 0.7) if sum(color) > 300 else (120, 122, 128)
    prints.lines(sign, look.rng, (0.15, 0.2, 0.7, 0.5), 5, ink)
    plate = box(0.7 * x, 0.7 * y, 0.0003).move(z=h - 0.0001)
    pieces = [(body, textures.speckles(look.rng, color, 2, 32)), (join(pins), steel),
              (port, textures.plain(DARK)), (plate, sign)]  # fmt: skip
    if look.chance(0.6):
        way = smooth([(0, -y / 2 + 0.001, 0.5 * h), (0, -y / 2 - 0.02, 0.4 * h),
                      (0.02, -y / 2 - 0.04, 0.003), (-0.03, -y / 2 - 0.055, 0.003),
                      (-0.045, -y / 2 - 0.02, 0.003), (-0.05, 0, 0.003)], 5)  # fmt: skip
        pieces.append((tube(way, 0.0017, 6), textures.plain(tint_color(color, 0.96))))
    turned = [(solid.turn(2, np.pi / 2), tile) for solid, tile in pieces]
    return shape(turned, [hull_of(turned[0][0]), hull_of(turned[1][0])])


def webcam(look: Look) -> Shape:
    """A webcam on a small stand or clip, its lens to the viewer."""
    color = look.color("black", "black", "charcoal", "white", "silver")
    shell = textures.speckles(look.rng, color, 3, 32)
    h = look.between(0.055, 0.075)
    if look.chance(0.5):
        body = facing(cylinder(0.024, 0.03, 28, bevel=0.004)).move(y=0.012, z=h)
        wide = 0.024
    else:
        wide = look.between(0.04, 0.05)
        body = facing(block(2 * wide, 0.03, 0.026, 0.0149, 0.003)).move(y=0.01, z=h)
    rim = facing(torus(0.0115, 0.0018, 26, 8)).move(y=-0.0175, z=h)
    lens = facing(lathe([(0, 0), (0.011, 0), (0.011, 0.002), (0.008, 0.003), (0, 0.0034)], 24))
    lens = lens.move(y=-0.015, z=h)
    glass = prints.canvas(48, 48, (22, 24, 30))
    prints.disc(glass, 0.5, 0.5, 0.3, (44, 56, 84))
    prints.disc(glass, 0.4, 0.38, 0.08, (150, 170, 200))
    lamp = facing(cylinder(0.0016, 0.001, 8)).move(x=min(0.018, 0.7 * wide), y=-0.0178, z=h)
    neck = cylinder(0.006, h - 0.02, 14).move(z=0.008)
    foot = block(0.05, 0.045, 0.01, 0.012, 0.003)
    flap = block(0.046, 0.01, 0.03, 0.004, 0.002).move(y=0.02, z=0.002)
    return shape([(body, shell), (join([rim]), textures.plain(tint_color(color, 0.7))),
                  (lens, glass), (lamp, textures.plain((90, 220, 120))),
                  (join([neck, foot, flap]), textures.speckles(look.rng, DARK, 4))],
                 [hull_of(foot), hull_of(flap), cylinder_part(0.006, h - 0.02, (0, 0, 0.008)),
                  hull_of(body)])  # fmt: skip


def trackpad(look: Look) -> Shape:
    """A flat touch pad of glass on a slanted metal wedge, or one with two keys."""
    x, y = look.between(0.13, 0.16), look.between(0.11, 0.12)
    color = look.color("white", "silver", "gray", "charcoal", "black")
    low, high = 0.0045, look.between(0.009, 0.013)
    wedge = block(x, y, high, 0.01).bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] * (low + (high - low)
                                                        * (p[:, 1] / y + 0.5)) / high])
    )  # fmt: skip
    keys = look.chance(0.45)
    image = prints.canvas(128, 96, color)
    if keys:
        prints.fill(image, 0, 0.8, 1, 0.012, tint_color(color, 0.6))
        prints.fill(image, 0.494, 0.8, 0.012, 0.2, tint_color(color, 0.6))
    prints.fill(image, 0, 0.0, 1, 0.01, tint_color(color, 0.8))
    lean = np.arctan2(high - low, y)
    pad = block(x - 0.004, y - 0.004, 0.0008, 0.009).turn(0, lean).move(z=(low + high) / 2 - 0.0003)
    return shape([(wedge, textures.brushed_metal(look.rng, tint_color(color, 0.85))), (pad, image)],
                 [hull_of(wedge)])  # fmt: skip


def mini_pc(look: Look) -> Shape:
    """A small desktop computer: a flat square or upright case with sockets and a power button."""
    s = look.between(0.115, 0.15)
    h = look.pick([look.between(0.036, 0.052), look.between(0.19, 0.24)])
    color = look.color("black", "silver", "charcoal", "white", "gray")
    shell = look.surface(color, look.pick(["metal", "plastic"]))
    tower = h > 0.1
    x, y = (0.42 * s, 1.2 * s) if tower else (s, s)
    body = block(x, y, h, 0.02 if not tower else 0.006, 0.003)
    face = prints.canvas(
        96, 32 if not tower else 160, tint_color(color, 0.7 if sum(color) > 250 else 1.3)
    )
    if tower:
        prints.disc(face, 0.5, 0.1, 0.04, (90, 200, 250))
        for k in range(8):
            prints.fill(face, 0.2, 0.5 + 0.05 * k, 0.6, 0.02, DARK)
        for k in (0, 1):
            prints.fill(face, 0.36, 0.22 + 0.08 * k, 0.28, 0.04, (30, 60, 120))
    else:
        prints.disc(face, 0.12, 0.5, 0.2, (90, 200, 250))
        for k in range(2):
            prints.fill(face, 0.32 + 0.18 * k, 0.34, 0.13, 0.32, (30, 60, 120))
        prints.fill(face, 0.7, 0.38, 0.08, 0.24, DARK)
        prints.disc(face, 0.88, 0.5, 0.13, DARK)
    front = box(0.9 * x, 0.002, 0.8 * h).move(y=-y / 2 - 0.0006, z=0.1 * h)
    pieces = [(body, shell), (front, face)]
    if not tower:
        mark = cylinder(0.16 * s, 0.0004, 24).move(z=h - 0.0001)
        pieces.append((mark, textures.plain(tint_color(color, 1.3 if sum(color) < 400 else 0.8))))
    return shape(pieces, [box_part(x, y, h)])


def wrist_rest(look: Look) -> Shape:
    """A soft bar for the wrists, its top rounded."""
    x, y, h = look.between(0.36, 0.44), look.between(0.07, 0.085), look.between(0.018, 0.022)
    bar = block(x, y, h, 0.45 * y, 0.4 * h, 8)
    base = block(x * 0.985, y * 0.94, 0.004, 0.42 * y)
    color = look.color("black", "charcoal", "navy", "gray", "purple", "brown")
    return shape(
        [(bar, look.surface(color, "fabric")), (base, textures.plain((40, 40, 44)))],
        [box_part(x, 0.8 * y, h)],
    )


CATEGORIES = (
    Category("wrist_rest", wrist_rest, (0.4, 0.078, 0.02), 0.18, ("wrist pad", "palm rest",
             "keyboard rest", "wrist support"), ("office",), ("flat",), ("black", "gray"), 0.8,
             "lying flat"),
    Category("usb_stick", usb_stick, (0.055, 0.017, 0.008), 0.01, ("flash drive", "usb flash drive",
             "memory stick", "thumb drive", "pen drive", "usb", "usb key",
             "usb drive", "usb plug", "dongle", "wifi dongle"),
             ("office", "gaming"), ("flat",),
             ("black",
             "red"), state="lying flat"),
    Category("charger", charger, (0.0964, 0.0612, 0.0302), 0.07, ("phone charger", "usb charger",
             "power adapter", "adapter", "wall charger", "charging plug", "power brick", "plug",
             "wireless charger"),
             ("office",), (), ("white", "black"), state="lying flat"),
    Category("webcam", webcam, (0.0764, 0.0475, 0.0827), 0.13, ("web camera", "web cam",
             "usb camera", "pc camera", "gimbal camera"), ("office", "gaming"), ("tall",),
             ("black",)),
    Category("trackpad", trackpad, (0.141, 0.116, 0.012), 0.2, ("touchpad", "magic trackpad",
             "touch pad"), ("office",), ("flat",), ("white",
             "silver"), state="lying flat"),
    Category("mini_pc", mini_pc, (0.103, 0.144, 0.0999), 1.2, ("mini computer", "server",
             "desktop computer", "pc", "computer tower", "pc tower", "mini server",
             "computer case", "set top box", "tv box", "nas", "blu-ray player", "dvd player",
             "set-top box", "network switch", "dvd drive", "nas box", "desktop pc", "vcr"),
             ("office", "gaming"), ("big",),
             ("black", "silver")),
)  # fmt: skip
"""The module's categories."""
