"""Electric devices round a desk: printer, router, drives, goggles, microphone, fan, watch."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import facing
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
    sweep,
    torus,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..tools.tools import lying

DARK = (40, 42, 46)


def printer(look: Look) -> Shape:
    """An ink-jet printer: lid, small screen, paper behind and a printed sheet in front."""
    x, y, h = look.between(0.36, 0.44), look.between(0.26, 0.32), look.between(0.13, 0.17)
    color = look.color("white", "black", "gray", "charcoal", "white")
    shell = textures.speckles(look.rng, color, 3, 32)
    other = textures.speckles(
        look.rng, tint_color(color, 0.72 if sum(color) > 300 else 1.25), 3, 32
    )
    body = block(x, y, h, 0.02, 0.008)
    lid = block(0.94 * x, 0.86 * y, 0.014, 0.014, 0.004).move(y=0.03 * y, z=h - 0.001)
    slot = box(0.66 * x, 0.004, 0.3 * h).move(y=-y / 2 - 0.001, z=0.14 * h)
    tray = box(0.6 * x, 0.12, 0.006).move(y=-y / 2 - 0.055, z=0.12 * h)
    sheet = prints.sheet(look.rng, picture=look.chance(0.6))
    page = box(0.21, 0.13, 0.0012).move(y=-y / 2 - 0.05, z=0.12 * h + 0.006)
    feed = box(0.21, 0.003, 0.13).turn(0, -0.28).move(y=0.42 * y, z=h)
    rest = box(0.25, 0.005, 0.085).turn(0, -0.28).move(y=0.45 * y, z=h)
    face = prints.canvas(96, 48, DARK)
    prints.fill(face, 0.08, 0.14, 0.5, 0.72, (90, 150, 210))
    for k, ink in enumerate([(80, 190, 110), (220, 220, 220), (220, 80, 60)]):
        prints.disc(face, 0.72 + 0.1 * k, 0.5, 0.11, ink)
    panel = box(0.1, 0.003, 0.04).move(-0.32 * x, -y / 2 - 0.001, 0.62 * h)
    return shape(
        [(body, shell), (join([lid, rest, tray]), other), (slot, textures.plain(DARK)),
         (page, sheet), (feed, textures.plain((248, 248, 246))), (panel, face)],
        [box_part(x, y, h), hull_of(lid), hull_of(feed, rest), hull_of(tray)],
    )  # fmt: skip


def router(look: Look) -> Shape:
    """A wireless router with upright antennas and a row of lamps."""
    x, y, h = look.between(0.18, 0.24), look.between(0.12, 0.15), look.between(0.028, 0.036)
    color = look.color("black", "white", "charcoal", "white")
    shell, dark = textures.speckles(look.rng, color, 3, 32), tint_color(color, 0.7)
    body = block(x, y, h, 0.02, 0.008)
    face = prints.canvas(160, 16, dark)
    for k in range(7):
        lamp = (90, 220, 120) if look.chance(0.7) else (230, 170, 60)
        prints.disc(face, 0.2 + 0.1 * k, 0.5, 0.2, lamp)
    strip = box(0.8 * x, 0.002, 0.3 * h).move(y=-y / 2 - 0.0004, z=0.34 * h)
    vents = textures.grid(tint_color(color, 0.6), color, 0, 12, 96, 3)
    top = block(0.7 * x, 0.5 * y, 0.001, 0.006).move(y=0.1 * y, z=h - 0.0003)
    count = int(look.rng.integers(2, 5))
    masts, parts = [], [box_part(x, y, h)]
    for k in range(count):
        at = (k - (count - 1) / 2) * 0.84 * x / max(count - 1, 1)
        tall, tilt = look.between(0.13, 0.16), 0.22 * at / x
        joint = lying(cylinder(0.007, 0.014, 12), at - 0.007, h * 0.6).move(y=y / 2 + 0.002)
        mast = block(0.013, 0.008, tall, 0.003, 0.002).turn(1, tilt)
        mast = mast.move(at, y / 2 + 0.004, 0.45 * h)
        masts += [joint, mast]
        parts.append(hull_of(mast))
    return shape(
        [(body, shell), (strip, face), (top, vents), (join(masts), textures.plain(dark))], parts
    )


def vr_headset(look: Look) -> Shape:
    """A virtual-reality headset: visor in front, straps behind."""
    x, z, y = look.between(0.17, 0.19), look.between(0.09, 0.105), look.between(0.06, 0.08)
    color = look.color("white", "black", "charcoal", "white")
    shell = textures.speckles(look.rng, color, 3, 32)
    dark = textures.speckles(look.rng, DARK, 4)
    visor = prism(rectangle(x, z, 0.035, 6), 0, y, 0.014)
    visor = facing(visor).move(y=-0.02, z=z / 2)
    plate = facing(prism(rectangle(0.84 * x, 0.72 * z, 0.028, 6), 0, 0.003)).move(
        y=-0.02 - y + 0.001, z=z / 2
    )
    glass = prints.canvas(128, 64, (26, 28, 34) if look.chance(0.6) else tint_color(color, 0.9))
    for u in (0.15, 0.85):
        prints.disc(glass, u, 0.25, 0.08, (70, 76, 92))
        prints.disc(glass, u, 0.78, 0.08, (70, 76, 92))
    pad = facing(prism(rectangle(0.86 * x, 0.86 * z, 0.03, 6), 0, 0.03)).move(y=0.005, z=z / 2)
    a = np.linspace(0, np.pi, 15)
    back = np.column_stack([0.49 * x * np.cos(a), 0.16 * np.sin(a) ** 0.8, np.full(15, 0.5 * z)])
    back[:, 2] += 0.1 * z * np.sin(a)
    strap = sweep(back, rectangle(0.008, 0.026, 0.003, 2))
    over = smooth([(0, -0.02, 0.96 * z), (0, 0.05, 1.3 * z), (0, 0.13, 1.05 * z),
                   (0, 0.16, 0.66 * z)], 4)  # fmt: skip
    crown = sweep(over, rectangle(0.024, 0.004, 0.0015, 2))
    rest = block(0.09, 0.022, 0.7 * z, 0.008, 0.004).move(y=0.15)
    return shape(
        [(visor, shell), (plate, glass), (join([pad, crown, rest]), dark),
         (strap, shell if look.chance(0.5) else dark)],
        [hull_of(visor, pad), hull_of(rest),
         *(box_part(0.008, 0.12, 0.026, (s * 0.46 * x, 0.06, 0.47 * z)) for s in (-1, 1))],
    )  # fmt: skip


def microphone(look: Look) -> Shape:
    """A microphone on a table stand."""
    h, r = look.between(0.16, 0.22), look.between(0.022, 0.03)
    color = look.color("black", "silver", "charcoal", "red", "white")
    body_tile = textures.speckles(look.rng, color, 4)
    mesh = prints.mesh_holes(look.own_color("silver", "gray", "black"), (30, 30, 34), 18, 24)
    foot = cylinder(0.052, 0.01, 30, bevel=0.002)
    post = cylinder(0.005, 0.5 * h, 12).move(z=0.009)
    low, rise = 0.42 * h, look.between(0.04, 0.18)
    capsule = lathe([(0, 0), (0.9 * r, 0), (r, 0.004), (r, 0.3 * h), (0, 0.3 * h)], 26).move(z=low)
    a = np.linspace(0, np.pi / 2, 8)
    head = lathe([(0, 0), (1.03 * r, 0), *np.column_stack(
        [1.03 * r * np.cos(a), rise * h + r * np.sin(a)])[:-1], (0, rise * h + r)], 26)  # fmt: skip
    head = head.move(z=low + 0.3 * h)
    band = torus(1.02 * r, 0.002, 26, 6).move(z=low + 0.3 * h)
    knob = facing(cylinder(0.007, 0.005, 16)).move(y=-r, z=low + 0.14 * h)
    a = np.linspace(0, np.pi, 11)
    fork = tube(np.column_stack([-1.22 * r * np.cos(a), np.zeros(11),
                                 low + 0.14 * h - 0.16 * h * np.sin(a)]), 0.003, 8)  # fmt: skip
    trim = textures.plain(look.own_color("silver", "charcoal", "gold"))
    return shape(
        [(join([foot, post, fork]), textures.speckles(look.rng, DARK, 4)), (capsule, body_tile),
         (head, mesh), (join([band, knob]), trim)],
        [cylinder_part(0.052, 0.01), cylinder_part(0.005, 0.42 * h, (0, 0, 0.009)),
         hull_of(capsule), hull_of(head)],
    )  # fmt: skip


def desk_fan(look: Look) -> Shape:
    """A small fan: wire cage, blades, foot."""
    r = look.between(0.075, 0.105)
    color = look.color("white", "black", "teal", "pink", "sky", "silver")
    mid, deep = 1.55 * r, 0.42 * r
    paint = textures.speckles(look.rng, color, 3, 32)
    wire = textures.plain(tint_color(color, 0.8))
    rings = [torus(k * r, 0.0026 if k == 1 else 0.0015, 32, 5).move(z=z)
             for k, z in ((1, 0), (0.7, 0.1 * r), (0.4, 0.14 * r), (0.7, -deep), (0.4, -deep),
                          (1, -0.3 * r))]  # fmt: skip
    spokes = []
    for k in range(16):
        c, s = np.cos(np.pi * k / 8), np.sin(np.pi * k / 8)
        way = [(0.16, 0.15), (0.6, 0.12), (1, 0), (1, -0.3), (0.6, -0.42), (0.16, -0.43)]
        spokes.append(tube([(u * r * c, u * r * s, v * r) for u, v in way], 0.0011, 4))
    hub = cylinder(0.17 * r, 0.03 * r + 0.003, 18, bevel=0.001).move(z=0.13 * r)
    motor = cylinder(0.3 * r, 0.5 * r, 20, bevel=0.008).move(z=-deep - 0.45 * r)
    blade = ellipsoid(0.72 * r, 0.5 * r, 0.004, 16, 4).turn(0, 0.45).move(x=0.46 * r)
    blades = [blade.turn(2, 2 * np.pi * k / 4 + 0.4).move(z=-0.18 * r) for k in range(4)]

    def up(solid: Solid) -> Solid:
        return facing(solid).move(y=-0.3 * r, z=mid)

    foot = cylinder(0.72 * r, 0.014, 30, bevel=0.004)
    post = block(0.28 * r, 0.2 * r, mid - 0.3 * r, 0.004, 0.002).move(y=0.25 * r, z=0.01)
    cage = up(join([*rings, *spokes]))
    fins = textures.speckles(
        look.rng, look.own_color("sky", "white", "gray", "mint", "black"), 3, 32
    )
    ball = up(cylinder(1.0 * r, 0.5 * r, 16).move(z=-deep))
    return shape(
        [(cage, wire), (up(join(blades)), fins), (up(join([hub, motor])), paint),
         (join([foot, post]), paint)],
        [cylinder_part(0.72 * r, 0.014), hull_of(post), hull_part(ball.vertices),
         hull_of(up(motor))],
    )  # fmt: skip


def power_strip(look: Look) -> Shape:
    """A power strip with sockets, a lit switch and a stub of cable."""
    count = int(look.rng.integers(3, 6))
    pitch, y, h = 0.05, look.between(0.05, 0.06), look.between(0.032, 0.04)
    x = pitch * count + 0.05
    color = look.color("white", "black", "gray", "white")
    face = prints.canvas(48 * count + 48, 56, tint_color(color, 0.96))
    wide = face.shape[1]
    for k in range(count):
        u = (72 + 48 * k) / wide
        prints.disc(face, u, 0.5, 0.36, tint_color(color, 0.75))
        prints.disc(face, u, 0.5, 0.31, tint_color(color, 0.86))
        for s in (-1, 1):
            prints.disc(face, u + s * 8 / wide, 0.5, 0.055, (24, 24, 26))
    body = block(x, y, h, 0.012, 0.004)
    top = block(0.97 * x, 0.86 * y, 0.001, 0.008).move(z=h - 0.0003)
    switch = box(0.02, 0.028, 0.005).move(x=-x / 2 + 0.024, z=h)
    cable = tube(smooth([(x / 2 - 0.004, 0, 0.016), (x / 2 + 0.03, 0, 0.012),
                         (x / 2 + 0.07, 0.02, 0.004), (x / 2 + 0.1, 0.05, 0.004)], 4),
                 0.0038, 8)  # fmt: skip
    lamp = textures.plain(look.own_color("red", "orange", "green"))
    shell = textures.speckles(look.rng, color, 3, 32)
    return shape(
        [
            (body, shell),
            (top, face),
            (switch, lamp),
            (cable, textures.plain(tint_color(color, 0.9))),
        ],
        [box_part(x, y, h), hull_of(switch)],
    )


CATEGORIES = (
    Category("printer", printer, (0.4, 0.45, 0.26), 4.5, ("inkjet printer", "copier",
             "fax machine", "laminator", "franking machine"),
             ("office",), ("big",), ("white", "black")),
    Category("router", router, (0.21, 0.15, 0.155), 0.4,
             ("wifi router", "wi-fi router", "modem", "wireless router", "access point",
             "wi-fi extender", "wifi extender"),
             ("office", "gaming"), (), ("black", "white")),
    Category("vr_headset", vr_headset, (0.18, 0.26, 0.13), 0.5,
             ("vr goggles", "virtual reality headset", "vr glasses", "vr"),
             ("gaming",), (), ("white", "black")),
    Category("microphone", microphone, (0.104, 0.104, 0.19), 0.6,
             ("mic", "podcast microphone", "usb microphone", "desk microphone"),
             ("gaming", "office"), ("tall", "round"), ("black", "silver")),
    Category("desk_fan", desk_fan, (0.185, 0.15, 0.235), 0.9,
             ("fan", "table fan", "electric fan", "usb fan", "fan heater", "desk heater"),
             ("office", "living"), ("tall", "big"),
             ("white", "black")),
    Category("power_strip", power_strip, (0.35, 0.085, 0.042), 0.4,
             ("extension cord", "power bar", "socket strip", "multi socket", "power outlet strip",
             "multi plug adaptor", "multi-plug adaptor", "surge protector"),
             ("office", "workbench"), (), ("white", "black"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
