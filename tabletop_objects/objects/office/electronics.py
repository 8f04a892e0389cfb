"""Objects of the ``office`` theme: electronics."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import DARK, glaze_tile, plastic, steel
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, hull_part, ring_parts
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    drum,
    facing,
    lay_down,
    plate,
    rod,
    side_view,
    straight,
)
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    sweep,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, plain, tint_color
from .computers import _slab

POWER_BANK_DARK: RGB = (32, 32, 35)


@category("power_bank", size=(0.1345, 0.067, 0.018), mass=0.22, material="device",
          aliases=("powerbank", "portable charger", "battery pack", "external battery",
          "jump starter", "car jump starter"), themes=("office",), roles=("flat",),
          colors=("black", "white"))  # fmt: skip
def power_bank(look: Look) -> Shape:
    """A power bank lying flat: a rounded case with ports and four lights."""
    k = look.between(0.88, 1.1)
    x, y, h = 0.135 * k, 0.068 * k, 0.018 * k
    color = look.color("black", "white", "silver", "blue", "pink", "charcoal", "red")
    body = block(x, y, h, 0.012, 0.004)
    lights = [box(0.0045, 0.0022, 0.0006).move(0.36 * x, (n - 1.5) * 0.008, h - 0.0002)
              for n in range(4)]  # fmt: skip
    ports = [box(0.002, 0.012, 0.006).move(0.5 * x, s * 0.018, h / 2 - 0.003) for s in (-1, 1)]
    sign = prints.canvas(96, 48, color)
    prints.write(sign, look.pick(["10000", "20000 mAh", "POWER", "5V 2A"]), 0.5, 0.5, 0.3,
                 tint_color(color, 1.6) if sum(color) < 380 else tint_color(color,
                     0.5))  # fmt: skip
    face = box(0.5 * x, 0.55 * y, 0.0005).move(x=-0.12 * x, z=h - 0.0002)
    return shape([(body, look.surface(color, "plastic")), (face, sign),
                  (join(lights), surfaces.plain((120, 220, 240))),
                      (join(ports), surfaces.plain(POWER_BANK_DARK))],
                 [hull_of(body)])  # fmt: skip


@category("desk_fan", size=(0.185, 0.15, 0.235), mass=0.9, material="device",
          aliases=("fan", "table fan", "electric fan", "usb fan", "fan heater", "desk heater"),
          themes=("office", "living"), roles=("tall", "big"), colors=("white", "black"),
          common=True)  # fmt: skip
def desk_fan(look: Look) -> Shape:
    """A small desk fan with a wire cage, blades and a base."""
    r = look.between(0.075, 0.105)
    color = look.color("white", "black", "teal", "pink", "sky", "silver")
    mid, deep = 1.55 * r, 0.42 * r
    paint = surfaces.speckles(look.rng, color, 3, 32)
    wire = surfaces.plain(tint_color(color, 0.8))
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
    fins = surfaces.speckles(
        look.rng, look.own_color("sky", "white", "gray", "mint", "black"), 3, 32
    )
    ball = up(cylinder(1.0 * r, 0.5 * r, 16).move(z=-deep))
    return shape(
        [(cage, wire), (up(join(blades)), fins), (up(join([hub, motor])), paint),
         (join([foot, post]), paint)],
        [cylinder_part(0.72 * r, 0.014), hull_of(post), hull_part(ball.vertices),
         hull_of(up(motor))],
    )  # fmt: skip


@category("power_strip", size=(0.35, 0.085, 0.042), mass=0.4, material="device",
          aliases=("extension cord", "power bar", "socket strip", "multi socket",
          "power outlet strip", "multi plug adaptor", "multi-plug adaptor", "surge protector"),
          themes=("office", "workbench"), colors=("white", "black"), state="lying flat",
          common=True)  # fmt: skip
def power_strip(look: Look) -> Shape:
    """A power strip with sockets, a lit switch and a short piece of cable."""
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
    lamp = surfaces.plain(look.own_color("red", "orange", "green"))
    shell = surfaces.speckles(look.rng, color, 3, 32)
    return shape([(body, shell), (top, face), (switch, lamp),
                  (cable, surfaces.plain(tint_color(color, 0.9)))],
                 [box_part(x, y, h), hull_of(switch)])  # fmt: skip


SPEAKER_DARK = (40, 41, 45)


@category("headphones", size=(0.185, 0.135, 0.073), mass=0.25, material="device",
          aliases=("headphone", "earphones", "ear defenders"), themes=("office", "living"),
          colors=("black", "white"), state="lying down", common=True)  # fmt: skip
def headphones(look: Look) -> Shape:
    """Over-ear headphones, lying on their cups and the back of their headband."""
    color = look.color("black", "black", "white", "navy", "red", "silver", "pink", "teal", "cream")
    pad = look.own_color("black", "brown", "gray", "white", "tan")
    other = look.pick([color, color, tint_color(color, 0.5), tint_color(color, 1.5)])
    outer = surfaces.speckles(look.rng, other, 3, 32)
    badge = look.pick([None, (200, 170, 90), (214, 60, 60), (230, 232, 236)])
    shell = surfaces.speckles(look.rng, color, 3, 32)
    soft = surfaces.speckles(look.rng, tint_color(pad, 0.9), 4, 32)
    r, half = look.between(0.031, 0.04), look.between(0.07, 0.081)
    wide, thick = look.between(0.016, 0.03), look.between(0.005, 0.01)
    curve = arc((0, 0), half, 0, np.pi, 18) * [1, 1.2]
    cups, cushions = [], []
    for side in (-1, 1):
        way = -side * 0.45 * np.pi
        cups.append(cylinder(r, 0.018, 24, bevel=0.005).move(z=-0.009).turn(1, way))
        cushions.append(torus(r - 0.011, 0.0105, 24, 8).move(z=0.014).turn(1, way))
    lift = -min(solid.bounds[0, 2] for solid in cups + cushions)
    drop = (lift - 0.013) / curve[:, 1].max()  # the far end of the headband touches the table
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
            pieces.append((mark.move(x=side * half, z=lift), surfaces.plain(badge)))
    return shape(pieces, [*[hull_of(a, b) for a, b in zip(cups, cushions, strict=True)],
                          *[hull_part(band.vertices[span]) for span in spans]])  # fmt: skip


@category("speaker", size=(0.11, 0.12, 0.185), mass=0.9, material="device",
          aliases=("loudspeaker", "bluetooth speaker"), themes=("office", "living"),
          roles=("tall",), colors=("black", "white"), common=True)  # fmt: skip
def speaker(look: Look) -> Shape:
    """A small loudspeaker box with two drivers that face the viewer."""
    x, y, z = look.between(0.1, 0.12), look.between(0.1, 0.125), look.between(0.17, 0.2)
    color = look.color("black", "walnut brown", "white", "charcoal", "teal", "red", "cream", "sage")
    if look.chance(0.35):
        return _mesh_speaker(look, color, x, y, z)
    cone_color, metal = (look.own_color("charcoal", "amber", "gray", "white", "red"),
                         look.chance(0.6))  # fmt: skip
    body = block(x, y, z, look.pick([0.0, 0.008, 0.02]))
    front = box(x * 0.94, 0.004, z * 0.96).move(y=-y / 2 - 0.001, z=0.02 * z)
    face = surfaces.plain(look.pick([tint_color(SPEAKER_DARK, 0.9), tint_color(color, 0.85)]))
    pieces = [(body, look.surface(color, look.pick(["plastic", "wood"]))), (front, face)]
    for radius, height in [(0.36 * x, 0.33), (0.2 * x, 0.76)]:
        at = {"y": -y / 2 - 0.003, "z": height * z}
        ring = torus(radius, 0.003, 28, 6).turn(0, np.pi / 2).move(**at)
        cone = cylinder(radius, 0.002, 28).turn(0, np.pi / 2).move(**at)
        cap = ellipsoid(0.8 * radius, 0.012, 0.8 * radius, 16, 8).move(**at)
        pieces += [(ring, surfaces.plain((150, 152, 156) if metal else (60, 62, 66))),
                   (cone, surfaces.plain(cone_color)),
                   (cap, surfaces.plain(SPEAKER_DARK))]  # fmt: skip
    return shape(pieces, [box_part(x, y, z)])


def _mesh_speaker(look: Look, color: RGB, x: float, y: float, z: float) -> Shape:
    """Return a rounded portable speaker with cloth or a grille and a strip of buttons on top."""
    skin = surfaces.fabric(look.rng, color)
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
        [(body, skin), (ends[0], surfaces.plain(SPEAKER_DARK)), (ends[1], image),
         (badge, surfaces.plain((226, 226, 224)))],
        [hull_of(body)],
    )  # fmt: skip


def _mark(color: RGB, y: float, z: float, shown: bool) -> list[tuple[Solid, surfaces.Tile]]:
    """Return the logo on the front of an earbud case, or an empty list if not ``shown``."""
    mark = box(0.012, 0.0008, 0.005).move(y=-y / 2, z=0.74 * z)
    return [(mark, surfaces.plain(tint_color(color, 0.5)))] if shown else []


@category("earbuds_case", size=(0.058, 0.024, 0.046), mass=0.045, material="device",
          aliases=("earbuds", "airpods", "earbud case", "airpods case", "wireless earbuds case"),
          themes=("office", "coffee"), colors=("white", "black"), common=True)  # fmt: skip
def earbuds_case(look: Look) -> Shape:
    """A closed charging case for earbuds."""
    color = look.color("white", "white", "black", "mint", "navy", "pink", "red", "lavender", "teal")
    x, y, z = look.between(0.05, 0.064), look.between(0.021, 0.028), look.between(0.04, 0.052)
    lamp, mark = look.pick([(90, 220, 120), (240, 160, 60), (250, 250, 250)]), look.chance(0.5)
    low = block(x, y, z * 0.62, 0.0115, 0.0015)
    lid = block(x, y, z * 0.37, 0.0115, 0.0015).move(z=0.63 * z)
    light = box(0.003, 0.001, 0.003).move(y=-y / 2, z=0.42 * z)
    shell = surfaces.speckles(look.rng, color, 2, 16)
    return shape([(low, shell), (lid, shell), (light, surfaces.plain(lamp)),
                  *_mark(color, y, z, mark)], [box_part(x, y, z * 0.62),
                                               box_part(x, y, z * 0.37,
                                                        (0, 0, 0.63 * z))])  # fmt: skip


@category("smartphone", size=(0.074, 0.153, 0.0086), mass=0.18, material="device",
          aliases=("phone", "mobile phone", "cell phone", "cellphone", "mobile", "iphone"),
          themes=("office", "coffee", "living", "vanity"), roles=("flat", "screen"),
          colors=("black", "silver"), state="lying flat", common=True)  # fmt: skip
def smartphone(look: Look) -> Shape:
    """A smartphone lying on its back or on its face."""
    return _slab(look, look.between(0.066, 0.079), look.between(0.14, 0.166),
                 look.between(0.0072, 0.0088), look.between(0.002, 0.006),
                 prints.apps(look.rng))  # fmt: skip


PROJECTOR_DARK: RGB = (30, 30, 33)
CHARGER_DARK: RGB = (36, 37, 41)


@category("charger", size=(0.0964, 0.0612, 0.0302), mass=0.07, material="plastic", assembled=True,
          aliases=("phone charger", "usb charger", "power adapter", "adapter", "wall charger",
          "charging plug", "power brick", "plug", "wireless charger"), themes=("office",),
          colors=("white", "black"), state="lying flat")  # fmt: skip
def charger(look: Look) -> Shape:
    """A charger lying on its back: a block with two pins on the left, a socket and a cable."""
    x, y, h = look.between(0.04, 0.055), look.between(0.04, 0.06), look.between(0.027, 0.033)
    color = look.color("white", "white", "black", "gray", "charcoal", "sky")
    body = block(x, y, h, 0.008, 0.004)
    steel = surfaces.plain((206, 206, 206))
    pins = [cylinder(0.0022, 0.018, 12).turn(0, -np.pi / 2).move(s * 0.0095, y / 2 - 0.001, 0.5 * h)
            for s in (-1, 1)]  # fmt: skip
    if look.chance(0.5):
        pins = [box(0.0015, 0.018, 0.0065).move(s * 0.0064, y / 2 + 0.008, 0.5 * h - 0.003)
                for s in (-1, 1)]  # fmt: skip
    port = box(0.011, 0.0006, 0.005).move(y=-y / 2 - 0.0002, z=0.5 * h - 0.002)
    sign = prints.canvas(48, 48, tint_color(color, 0.97))
    ink = tint_color(color, 0.7) if sum(color) > 300 else (120, 122, 128)
    prints.lines(sign, look.rng, (0.15, 0.2, 0.7, 0.5), 5, ink)
    plate = box(0.7 * x, 0.7 * y, 0.0003).move(z=h - 0.0001)
    pieces = [(body, surfaces.speckles(look.rng, color, 2, 32)), (join(pins), steel),
              (port, surfaces.plain(CHARGER_DARK)), (plate, sign)]  # fmt: skip
    if look.chance(0.6):
        way = smooth([(0, -y / 2 + 0.001, 0.5 * h), (0, -y / 2 - 0.02, 0.4 * h),
                      (0.02, -y / 2 - 0.04, 0.003), (-0.03, -y / 2 - 0.055, 0.003),
                      (-0.045, -y / 2 - 0.02, 0.003), (-0.05, 0, 0.003)], 5)  # fmt: skip
        pieces.append((tube(way, 0.0017, 6), surfaces.plain(tint_color(color, 0.96))))
    turned = [(solid.turn(2, np.pi / 2), tile) for solid, tile in pieces]
    return shape(turned, [hull_of(turned[0][0]), hull_of(turned[1][0])])


@category("projector", size=(0.225, 0.201, 0.085), mass=2.0, material="device",
          aliases=("video projector", "beamer", "mini projector", "data projector",
          "film projector", "fog machine", "smoke machine", "slide viewer"), themes=("office",),
          roles=("big",), colors=("white",))  # fmt: skip
def projector(look: Look) -> Shape:
    """A small video projector with a lens in front, vents and buttons."""
    k = look.between(0.88, 1.08)
    x, y, h = 0.23 * k, 0.19 * k, 0.085 * k
    color = look.color("white", "white", "black", "gray", "charcoal")
    body = block(x, y, h - 0.008, 0.02, 0.006).move(z=0.008)
    feet = [cylinder(0.011, 0.009, 12).move(s * 0.38 * x, t * 0.36 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    at = (0.22 * x, -y / 2, 0.52 * h)
    barrel = facing(lathe([(0, 0), (0.034 * k, 0), (0.034 * k, 0.016 * k), (0.029 * k, 0.016 * k),
                           (0.026 * k, 0.01 * k), (0, 0.008 * k)], 30)).move(*at)  # fmt: skip
    glass = facing(lathe([(0, 0), (0.025 * k, 0.004), (0.014 * k, 0.011 * k), (0, 0.0135 * k)],
                         26)).move(*at)  # fmt: skip
    vent = prints.canvas(96, 40, color)
    for n in range(9):
        prints.fill(vent, 0.08 + 0.1 * n, 0.1, 0.05, 0.8, tint_color(color, 0.35))
    vents = box(0.38 * x, 0.0014, 0.42 * h).move(x=-0.22 * x, y=-y / 2, z=0.3 * h)
    knobs = [cylinder(0.008 * k, 0.003, 16).move((-0.06 + 0.03 * n) * k, 0.03 * k, h - 0.001)
             for n in range(4)]  # fmt: skip
    ring = torus(0.028 * k, 0.003, 26, 6).move(0.22 * x, -0.24 * y, h - 0.0005)
    return shape([(body, look.surface(color, "plastic")),
                  (join(feet), surfaces.plain(PROJECTOR_DARK)),
                  (barrel, surfaces.plain((46, 46, 50))), (vents, vent),
                  (glass, surfaces.gradient((40, 50, 90), (120, 160, 220), look.rng)),
                  (join([*knobs, ring]), surfaces.plain(tint_color(color, 0.6)))],
                 [box_part(x, y, h), hull_of(barrel)])  # fmt: skip


ACTION_CAMERA_DARK = (40, 42, 46)


@category("action_camera", size=(0.067, 0.043, 0.055), mass=0.15, material="device",
          aliases=("gopro", "action cam", "sports camera", "dashcam", "dash cam"),
          themes=("office", "gaming"), colors=("black",), common=True)  # fmt: skip
def action_camera(look: Look) -> Shape:
    """A small action camera with its square lens towards the viewer."""
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
    tiles = [surfaces.speckles(look.rng, color, 4), face,
             surfaces.plain(tint_color(color, 0.6)), shine, surfaces.plain(lamp)]  # fmt: skip
    pieces = list(zip(raised, tiles, strict=True))
    parts = [hull_of(raised[0]), hull_of(raised[2], raised[3])]
    if base:
        foot = block(0.034, 0.034, 0.004, 0.006, 0.001)
        pieces.append((join([*feet, foot]), surfaces.plain(ACTION_CAMERA_DARK)))
        parts.append(box_part(0.034, 0.034, 0.0085))
    return shape(pieces, parts)


@category("ring_light", size=(0.18, 0.13, 0.327), mass=0.45, material="plastic", assembled=True,
          aliases=("selfie light", "ring lamp", "photo light", "studio light", "camera flash"),
          themes=("office",), roles=("tall", "big"), colors=("black",))  # fmt: skip
def ring_light(look: Look) -> Shape:
    """A ring light on a small tripod."""
    k = look.between(0.85, 1.02)
    color = look.color("black", "white", "pink", "black")
    r, top = 0.085 * k, 0.25 * k
    frame = torus(r, 0.012 * k, 40, 8).turn(0, np.pi / 2).move(z=top)
    glow = lathe(
        [(0.89 * r, 0), (1.11 * r, 0), (1.11 * r, 0.004), (0.89 * r, 0.004)], 40, loop=True
    )
    glow = facing(glow).move(y=-0.0095 * k, z=top)
    post = cylinder(0.006 * k, top - r - 0.03 * k, 14).move(z=0.035 * k)
    legs = [tube([(0, 0, 0.05 * k), (0.085 * k * np.cos(a), 0.085 * k * np.sin(a), 0.0055 * k)],
                 0.005 * k, 8) for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    hub = cylinder(0.011 * k, 0.03 * k, 18).move(z=0.035 * k)
    legs = [s.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])) for s in legs]
    low = min(float(s.bounds[0, 2]) for s in legs)
    legs = [s.move(z=-low) for s in legs]
    ring = ring_parts([(1.13 * r, -0.011 * k), (1.13 * r, 0.011 * k)],
                      [(0.87 * r, 0.011 * k), (0.87 * r, -0.011 * k)], 8)  # fmt: skip
    upright = [p.__class__(p.vertices[:, [0, 2, 1]] * [1, -1, 1] + [0, 0, top]) for p in ring]
    return shape([(join([frame, post, hub, *legs]), look.surface(color, "plastic")),
                  (glow, surfaces.plain((255, 250, 232)))],
                 [*upright, hull_of(post), hull_of(hub), *(hull_of(s) for s in legs)])  # fmt: skip


@category("laser_pointer", size=(0.1365, 0.014, 0.0145), mass=0.04, material="plastic",
          aliases=("laser pen", "laser", "presentation pointer", "presentation clicker",
          "presentation remote"), themes=("office",), colors=("silver", "black"),
          state="lying flat")  # fmt: skip
def laser_pointer(look: Look) -> Shape:
    """A laser pointer lying flat: a slim tube with a button and a red tip."""
    k = look.between(0.92, 1.08)
    color = look.color("silver", "black", "black", "gold", "red", "blue")
    body = lathe(np.array([(0, 0), (0.0045, 0), (0.0062, 0.006), (0.0066, 0.03), (0.0066, 0.128),
                           (0.0055, 0.135), (0, 0.135)]) * k, 20)  # fmt: skip
    body = lay_down(body, -0.0675 * k, 0.0066 * k)
    tip = lay_down(cylinder(0.0025 * k, 0.002, 12), -0.0675 * k - 0.0014, 0.0066 * k)
    knob = block(0.011 * k, 0.0055 * k, 0.0025 * k, 0.002).move(x=-0.02 * k, z=0.0124 * k)
    rings = [lay_down(torus(0.0066 * k, 0.0006, 18, 5), x * k, 0.0066 * k) for x in (0.01, 0.05)]
    return shape([(body, look.surface(color, "metal")), (tip, surfaces.plain((250, 50, 50))),
                  (join([knob, *rings]), surfaces.plain((160, 162, 168)
                      if sum(color) < 300 else POWER_BANK_DARK))],
                 [flat_foot(body.vertices, 0.1), hull_of(knob)])  # fmt: skip


def _handset(length: float, z: float) -> Solid:
    """Return a telephone handset along x at height ``z``, with its earpiece and mouthpiece down."""
    t = np.linspace(-1, 1, 9)
    path = np.column_stack([0.42 * length * t, 0 * t, z + 0.012 - 0.012 * np.abs(t) ** 2.5])
    grip = sweep(path, rectangle(0.034, 0.022, 0.008, 3))
    ends = [lathe([(0, -0.012), (0.024, -0.012), (0.027, 0.0), (0.02, 0.016), (0, 0.018)], 22)
            .move(s * 0.42 * length, 0, z - 0.002) for s in (-1, 1)]  # fmt: skip
    return join([grip, *ends])


@category("telephone", size=(0.226, 0.207, 0.124), mass=0.9, material="device",
          aliases=("desk phone", "landline phone", "rotary phone", "landline", "office phone",
          "desk telephone", "corded phone", "rotary telephone", "old telephone", "desktop phone"),
          themes=("office",), roles=("big",), colors=("black", "red"))  # fmt: skip
def telephone(look: Look) -> Shape:
    """A desk telephone: an old model with a dial, or a newer model with keys and a display."""
    color = look.color("black", "red", "cream", "white", "green", "gray", "charcoal", "sky")
    skin = surfaces.speckles(look.rng, color, 3, 32)
    if look.chance(0.5):
        k = look.between(0.92, 1.08)
        outline = rectangle(1, 1, 0.16, 4)
        rings = [(0.21, 0.2, 0, 0), (0.21, 0.2, 0.02, 0), (0.17, 0.15, 0.06, 0.015),
                 (0.13, 0.075, 0.095, 0.035), (0.12, 0.065, 0.1, 0.035)]  # fmt: skip
        body = loft(np.stack([np.column_stack([outline * [a * k, b * k] + [0, d * k],
                                               np.full(len(outline), z * k)])
                              for a, b, z, d in rings]), outline)  # fmt: skip
        face = prints.canvas(128, 128, (236, 232, 222))
        prints.disc(
            face, 0.5, 0.5, 0.5, tint_color(color, 0.7) if sum(color) > 250 else (206, 208, 212)
        )
        for n in range(10):
            a = -0.9 + n * 0.56
            u, v = 0.5 + 0.34 * np.cos(a), 0.5 + 0.34 * np.sin(a)
            prints.disc(face, u, v, 0.075, (250, 248, 240))
            prints.write(face, str(n), u, v, 0.07, (40, 40, 44))
        prints.disc(face, 0.5, 0.5, 0.16, (250, 248, 240))
        dial = cylinder(0.044 * k, 0.012, 32, bevel=0.002).turn(0, 0.55)
        dial = dial.move(y=-0.039 * k, z=0.072 * k)
        forks = [block(0.03, 0.06 * k, 0.022, 0.008, 0.003).move(s * 0.05 * k, 0.035 * k, 0.095 * k)
                 for s in (-1, 1)]  # fmt: skip
        hand = _handset(0.22 * k, 0.125 * k).move(y=0.035 * k)
        return shape([(join([body, *forks]), skin), (dial, face), (hand, skin)],
                     [hull_part(body.vertices[body.vertices[:, 2] < 0.07 * k]),
                      hull_part(body.vertices[body.vertices[:, 2] > 0.05 * k]),
                      hull_of(*forks), hull_of(hand)])  # fmt: skip
    x, y = look.between(0.18, 0.21), look.between(0.19, 0.22)
    wedge = side_view(np.array([(-y / 2, 0), (y / 2, 0), (y / 2, 0.065), (-y / 2, 0.022)]), x)
    body = wedge.turn(2, np.pi / 2)
    lean = np.arctan2(0.043, y)
    face = prints.canvas(128, 144, tint_color(color, 0.94))
    prints.fill(face, 0.1, 0.06, 0.8, 0.22, (176, 196, 172))
    prints.write(face, look.pick(["10:24", "LINE 1", "09:41"]), 0.5, 0.17, 0.1, (40, 46, 40))
    tone = (230, 230, 228) if sum(color) < 330 else (70, 72, 78)
    for n in range(12):
        prints.fill(face, 0.12 + 0.2 * (n % 3), 0.36 + 0.14 * (n // 3), 0.16, 0.095, tone)
    for n in range(5):
        prints.fill(face, 0.78, 0.36 + 0.11 * n, 0.14, 0.06, [(200, 60, 50), tone][n > 0])
    panel = box(0.58 * x, 0.9 * y, 0.003).turn(0, lean).move(0.18 * x, 0, 0.0425)
    cradle = box(0.28 * x, 0.86 * y, 0.012).turn(0, lean).move(-0.31 * x, 0, 0.0425)
    hand = _handset(0.2, 0).turn(2, np.pi / 2).turn(0, lean).move(-0.31 * x, 0, 0.068)
    cord = tube(smooth([(-0.31 * x, -0.46 * y, 0.05), (-0.55 * x, -0.4 * y, 0.02),
                        (-0.58 * x, 0.0, 0.004), (-0.5 * x, 0.3 * y, 0.02)], 5), 0.003,
                7)  # fmt: skip
    return shape([(join([body, cradle]), skin), (panel, face), (hand, skin),
                  (cord, surfaces.plain(tint_color(color, 0.8)))],
                 [hull_of(body), hull_of(cradle), hull_of(hand)])  # fmt: skip


@category("camcorder", size=(0.135, 0.12, 0.0622), mass=0.35, material="plastic",
          aliases=("video camera", "handycam"), themes=("office",), colors=("black",))  # fmt: skip
def camcorder(look: Look) -> Shape:
    """A camcorder with its screen folded out."""
    color = look.color("black", "silver", "charcoal", "white")
    k = look.between(0.85, 1.1)
    body = block(0.12, 0.055, 0.062, 0.016, 0.008)
    lens = [drum(0.024, 0.03, (0.05, 0, 0.034), 0), drum(0.018, 0.001, (0.0795, 0, 0.034), 0)]
    screen = at_box(0.07, 0.006, 0.045, (0.0, -0.062, 0.01)).turn(2, 0.0)
    hinge = at_box(0.012, 0.04, 0.03, (0.038, -0.04, 0.016))
    view = at_box(0.062, 0.0012, 0.037, (0.0, -0.0655, 0.014))
    strap = rod([(0.04, 0.027, 0.035), (0.02, 0.05, 0.035), (-0.03, 0.05, 0.035),
                 (-0.05, 0.027, 0.035)], 0.006, 8)  # fmt: skip
    button = drum(0.007, 0.004, (-0.045, 0, 0.061))
    return put_down([(join([body, hinge, screen]), look.surface(color, "plastic")),
                     (lens[0], plain(DARK)), (lens[1], plain((60, 70, 110))),
                     (view, plain((60, 110, 150))), (strap, plain((52, 52, 56))),
                     (button, plain((210, 40, 40)))], body, lens[0], join([screen, hinge]), strap,
                    factor=k)  # fmt: skip


@category("phone_case", size=(0.147, 0.0725, 0.0103), mass=0.03, material="plastic",
          aliases=("phone cover", "smartphone case", "mobile phone case", "iphone case",
          "screen protector"), themes=("office",), roles=("flat",),
          colors=("pink", "black"))  # fmt: skip
def phone_case(look: Look) -> Shape:
    """A phone case lying on its rims with its back up and a cut-out for the cameras."""
    color = look.color("pink", "black", "sky", "mint", "red", "lavender", "clear")
    k = look.between(0.92, 1.08)
    back = block(0.148, 0.073, 0.01, 0.01, 0.003)
    hole = plate(rectangle(0.034, 0.034, 0.008), 0.0006, at=(-0.05, 0.014, 0.0097))
    rim = plate(rectangle(0.038, 0.038, 0.01), 0.0012, at=(-0.05, 0.014, 0.0092))
    image = surfaces.speckles(look.rng, color, 4).copy()
    spots = []
    if look.chance(0.6):
        tone = look.own_color("white", "coral", "navy", "mustard")
        spots = [drum(look.between(0.003, 0.007), 0.0006, (look.between(-0.02, 0.06),
                                                           look.between(-0.026, 0.026), 0.0097),
                      sides=14) for _ in range(9)]  # fmt: skip
        return put_down([(back, image), (rim, plain(tint_color(color, 0.7))),
                         (hole, plain((40, 42, 46))), (join(spots), plain(tone))], back,
                        factor=k)  # fmt: skip
    return put_down([(back, image), (rim, plain(tint_color(color, 0.7))),
                     (hole, plain((40, 42, 46)))], back, factor=k)  # fmt: skip


@category("earbud", size=(0.0503, 0.0195, 0.0159), mass=0.006, material="plastic",
          aliases=("wireless earbud", "earphone", "airpod", "in-ear headphone"), themes=("office",),
          colors=("white",))  # fmt: skip
def earbud(look: Look) -> Shape:
    """A wireless earbud lying flat: a bud with a soft tip and a stem."""
    color = look.color("white", "black", "white", "pink", "silver")
    k = look.between(0.9, 1.25)
    bud = ball(0.018, 0.016, 0.016, (0.012, 0, 0.0075), 16)
    tip = ball(0.011, 0.012, 0.011, (0.02, 0.005, 0.0085), 12)
    stem = rod(
        [(0.008, 0, 0.006), (-0.006, 0, 0.0042), (-0.022, 0, 0.0032)], [0.0042, 0.0034, 0.003], 10
    )
    end = drum(0.0032, 0.0015, (-0.0235, 0, 0.0032), 0, sides=10)
    return put_down([(join([bud, stem]), plain(color)), (tip, plain(tint_color(color, 0.8))),
                     (end, steel(look))], bud, stem, factor=k, foot=0.25)  # fmt: skip


@category("conference_phone", size=(0.214, 0.203, 0.036), mass=0.6, material="device",
          aliases=("conference speaker", "speakerphone", "conference telephone", "meeting phone"),
          themes=("office",), roles=("big",), colors=("charcoal",))  # fmt: skip
def conference_phone(look: Look) -> Shape:
    """A three-armed conference phone with a speaker, keys and a small screen."""
    color = look.color("charcoal", "black", "gray", "white")
    k = look.between(0.8, 1.0)
    a = np.linspace(0, 2 * np.pi, 61)[:-1]
    r = 0.1 + 0.035 * np.cos(3 * (a - np.pi / 2)) ** 3
    rim = np.column_stack([r * np.cos(a), r * np.sin(a)])
    body, top = plate(rim, 0.02), plate(0.82 * rim, 0.016, at=(0, 0, 0.019))
    grille = drum(0.042, 0.006, (0, 0.005, 0.034), sides=28)
    keys = [at_box(0.01, 0.007, 0.003, (-0.013 + 0.013 * (n % 3), -0.052 - 0.0095 * (n // 3),
                                        0.0345)) for n in range(6)]  # fmt: skip
    screen = at_box(0.038, 0.018, 0.0014, (0, 0.062, 0.0346))
    lamps = [drum(0.0035, 0.002, (0.082 * np.cos(q), 0.082 * np.sin(q), 0.034)) for q in np.pi / 2
             + np.arange(3) * 2.0944]  # fmt: skip
    return put_down([(body, plain(tint_color(color, 0.8))),
                     (top, surfaces.speckles(look.rng, color, 3)),
                     (grille, prints.mesh_holes((84, 86, 92), (30, 30, 34))),
                     (join(keys), plain((206, 208, 212))), (screen, plain((120, 180, 200))),
                     (join(lamps), plain((80, 200, 110)))], body, top, factor=k)  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("headset_receiver", size=(0.0913, 0.0644, 0.102), mass=0.08, material="device",
          aliases=("wireless receiver", "signal receiver", "receiver", "wireless transmitter",
          "bluetooth adapter"), themes=("office",), colors=("black",))  # fmt: skip
@from_pieces()
def headset_receiver(look: Look) -> Pieces:
    """A headset receiver: a flat, rounded box with an upright antenna and a green light."""
    tile = plastic(look, "black", "charcoal", "white")
    body = at_block(0.09, 0.06, 0.02, 0.008)
    mast = straight((0.032, 0.02, 0.016), (0.032, 0.03, 0.1), 0.0035, 8)
    lamp = ball(0.005, 0.005, 0.005, (-0.03, -0.015, 0.02), 8)
    return [(body, tile), (mast, BLACK), (lamp, surfaces.plain((90, 230, 110)))]


@category("alarm_clock", size=(0.095, 0.05, 0.135), mass=0.25, material="device",
          aliases=("clock", "table clock"), themes=("office", "living"),
          colors=("red", "teal", "black"), common=True)  # fmt: skip
def alarm_clock(look: Look) -> Shape:
    """A round twin-bell alarm clock or a digital alarm clock, facing the viewer."""
    color = look.color("red", "teal", "black", "gold", "white", "pink", "mint", "navy", "orange")
    skin = surfaces.speckles(look.rng, color, 3, 32)
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
    metal = surfaces.brushed_metal(look.rng, look.own_color("gold", "silver"))
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


@category("desk_lamp", size=(0.16, 0.21, 0.36), mass=0.9, material="device",
          aliases=("lamp", "table lamp", "reading lamp", "light"),
          themes=("office", "living", "craft"), roles=("tall", "big"),
          colors=("black", "white", "brass"), common=True)  # fmt: skip
def desk_lamp(look: Look) -> Shape:
    """A desk lamp: a jointed arm with a tilted shade or a light bar, or a shade on a base."""
    color = look.color(*("black", "black", "white", "teal", "red", "brass", "mustard", "silver",
                         "sage", "navy"), *("pink", "copper"))  # fmt: skip
    if look.chance(0.6):
        return _arm_lamp(look, color)
    return _shade_lamp(look, color)


def _arm_lamp(look: Look, color: RGB) -> Shape:
    """Return a lamp with two arms, or with a single curved arm, on a heavy base."""
    skin = surfaces.speckles(look.rng, color, 3, 32)
    metal = look.pick(
        [skin, surfaces.brushed_metal(look.rng, look.own_color("brass", "silver", "copper"))]
    )
    r = look.between(0.066, 0.084)
    square, bar, bow = look.chance(0.3), look.chance(0.35), look.chance(0.3)
    base = (block(1.8 * r, 1.8 * r, 0.018, 0.02, 0.004) if square
            else cylinder(r, look.between(0.014, 0.024), 32, bevel=0.004))  # fmt: skip
    elbow = np.array([0.02, 0.07, look.between(0.18, 0.24)])
    head = np.array([0.0, -0.075, look.between(0.33, 0.38)])
    if bow:
        path = [(0, 0.03, 0.012), (0, 0.085, 0.2), (0, 0.04, head[2] + 0.02), head]
        arms = [tube(smooth(path, 6), 0.006, 8)]
    else:
        arms = [tube([(0, 0.03, 0.012), elbow], 0.006, 10), tube([elbow, head], 0.006, 10)]
    joint = ellipsoid(0.024, 0.024, 0.024, 14, 8).move(*(head if bow else elbow))
    glow = surfaces.plain((255, 240, 196))
    if bar:
        shade = block(0.07, 0.2, 0.014, 0.02, 0.003).move(z=0.004)
        light = block(0.056, 0.18, 0.003, 0.016).move(z=0.0025)
        tilt = (s.turn(0, 0.12).move(*head).move(z=-0.012) for s in (shade, light))
    else:
        wide, tall, wall = look.between(0.056, 0.076), look.between(0.07, 0.095), 0.003
        round_ = look.chance(0.4)
        side = ([(0.024, tall - 0.005), (0.9 * wide, 0.45 * tall)] if round_
                else [(0.024, tall - 0.005)])  # fmt: skip
        shade = lathe(
            [(0, tall), *side, (wide, -0.01), (wide - wall, -0.01),
             *[(x - wall, z - 0.004) for x, z in side[::-1]], (0, tall - 0.007)], 28,
        )  # fmt: skip
        bulb = ellipsoid(0.042, 0.042, 0.05, 14, 8).move(z=0.018)
        tilt = (s.turn(0, -0.5).move(*head).move(z=-0.04) for s in (shade, bulb))
    shade, light = tilt
    return shape([(base, skin), *((arm, metal) for arm in arms), (joint, skin), (shade, skin),
                  (light, glow)], [hull_of(base), *[hull_of(arm) for arm in arms],
                                   hull_of(shade)])  # fmt: skip


def _shade_lamp(look: Look, color: RGB) -> Shape:
    """Return a table lamp with a plain, banded or pleated fabric shade on a turned base."""
    feet = [
        [(0.06, 0), (0.06, 0.01), (0.018, 0.03), (0.03, 0.08), (0.012, 0.15), (0.008, 0.22)],
        [(0.05, 0), (0.062, 0.04), (0.055, 0.09), (0.02, 0.13), (0.012, 0.16), (0.008, 0.22)],
        [(0.062, 0), (0.062, 0.012), (0.01, 0.02), (0.008, 0.1), (0.008, 0.16), (0.008, 0.22)],
        [(0.036, 0), (0.052, 0.03), (0.036, 0.06), (0.05, 0.095), (0.016, 0.15), (0.008, 0.22)],
    ]
    side = look.pick(feet)
    foot = lathe([(0, 0), *side, (0, 0.22)], 28, v=[0, *np.linspace(0.02, 0.98, 6), 1])
    hue = look.pick([color, (250, 246, 236), (236, 222, 190)])
    cloth = surfaces.gradient((255, 246, 214), tint_color(hue, 1.5), look.rng, 2)
    kind = int(look.rng.integers(4))
    if kind == 1:
        band = surfaces.plain(tint_color(color, 0.8))
        cloth = surfaces.stack((band, 1), (cloth, 8), (band, 1))
    elif kind == 2:
        cloth = surfaces.stripes([(250, 240, 214), (228, 214, 184)], 20, upright=True, side=128)
    elif kind == 3:
        cloth = surfaces.fabric(look.rng, tint_color(hue, 1.2))
    top, wide = look.between(0.045, 0.078), look.between(0.08, 0.095)
    shade = lathe(
        [(wide, 0.17), (top, 0.31), (top - 0.003, 0.31), (wide - 0.003, 0.17)], 32, loop=True
    )
    glow = surfaces.plain((255, 240, 196))
    cap = cylinder(top - 0.001, 0.002, 28).move(z=0.296)
    bulb = ellipsoid(0.05, 0.05, 0.06, 14, 8).move(z=0.235)
    wide_foot = min(r for r, z in side if z <= 0.012)
    return shape([(foot, glaze_tile(look, color)), (shade, cloth), (cap, glow), (bulb, glow)],
                 [cylinder_part(wide_foot, 0.012), cylinder_part(0.018, 0.16, (0, 0, 0.012)),
                  hull_of(shade)])  # fmt: skip


@category("camera_lens", size=(0.077, 0.077, 0.085), mass=0.4, material="glass", aliases=("lens",
          "photo lens", "zoom lens", "telephoto lens", "objective", "lens hood", "lens filter",
          "lens cap"), themes=("office", "living"), roles=("round",),
          colors=("black",))  # fmt: skip
def camera_lens(look: Look) -> Shape:
    """A camera lens standing on its mount, capped or with its glass up."""
    r, h = look.between(0.033, 0.04), look.between(0.06, 0.11)
    color = look.color("black", "black", "charcoal", "white", "silver")
    skin = surfaces.speckles(look.rng, color, 3, 32)
    ribs = surfaces.stripes([(30, 30, 33), (58, 59, 63)], 48, upright=True, side=192)
    mount = cylinder(0.86 * r, 0.006, 30).move(z=0)
    body = lathe([(0, 0.005), (0.92 * r, 0.005), (0.92 * r, 0.2 * h), (r, 0.3 * h), (r, 0.92 * h),
                  (0.97 * r, h), (0.88 * r, h), (0.8 * r, h - 0.006), (0, h - 0.006)],
                 34)  # fmt: skip
    grip = lathe([(0.9 * r, 0.45 * h), (1.05 * r, 0.45 * h), (1.05 * r, 0.72 * h),
                  (0.9 * r, 0.72 * h)], 40, loop=True)  # fmt: skip
    mark = torus(1.003 * r, 0.0012, 34, 5).move(z=0.84 * h)
    red = surfaces.plain(look.own_color("red", "gold", "blue", "white"))
    glass = prints.canvas(96, 96, (26, 30, 44))
    prints.disc(glass, 0.5, 0.5, 0.42, (44, 52, 84))
    prints.disc(glass, 0.5, 0.5, 0.26, (70, 60, 110))
    prints.disc(glass, 0.38, 0.36, 0.09, (160, 180, 210))
    front = lathe([(0, 0), (0.78 * r, 0), (0.5 * r, 0.004), (0, 0.006)], 28,
                  v=[0, 0, 0.5, 1]).move(z=h - 0.007)  # fmt: skip
    pieces = [(join([mount]), surfaces.plain((176, 178, 184))), (body, skin), (grip, ribs),
              (mark, red)]  # fmt: skip
    parts = [
        cylinder_part(0.86 * r, 0.006),
        hull_of(body),
        cylinder_part(1.04 * r, 0.27 * h, (0, 0, 0.45 * h)),
    ]
    if look.chance(0.4):
        cap = cylinder(0.95 * r, 0.006, 32, bevel=0.001).move(z=h - 0.002)
        pieces.append((cap, surfaces.plain((44, 45, 49))))
        parts.append(hull_of(cap))
    else:
        disc = cylinder(0.78 * r, 0.0006, 30).move(z=h - 0.0058)
        pieces += [(disc, glass), (front.scale(0.6, 0.6, 1), surfaces.plain((36, 42, 70)))]
    return shape(pieces, parts)


@category("cable", size=(0.18, 0.101, 0.0137), mass=0.08, material="plastic", assembled=True,
          aliases=("usb cable", "charging cable", "coiled cable", "cable coil", "charger cable",
          "coil of cable", "power cable", "hdmi cable", "ethernet cable", "inner tube",
          "bike cable", "cable connector", "heat shrink tube", "kettle lead", "guitar lead",
          "jump lead", "scart lead", "micro usb cable", "figure eight lead", "figure-eight lead",
          "guitar cable", "audio cable", "air line", "rubber tubing", "catheter",
          "speaker wire coil", "cable sleeve", "aux cable", "power lead", "mains lead",
          "phone lead"), themes=("office", "gaming"), roles=("flat",), colors=("black", "white"),
          state="lying coiled")  # fmt: skip
def cable(look: Look) -> Shape:
    """A coiled cable tied in the middle, with its plug beside it."""
    color = look.color("black", "white", "gray", "red", "blue", "charcoal")
    r, thick = look.between(0.045, 0.06), look.between(0.0022, 0.0032)
    t = np.linspace(0, 5 * 2 * np.pi, 150)
    wobble = 1 + 0.06 * np.sin(2.3 * t) + 0.05 * np.sin(0.7 * t + 1)
    path = np.column_stack([1.25 * r * wobble * np.cos(t), 0.8 * r * wobble * np.sin(t), thick + 1.5
                            * thick * t / t[-1] + 0.5 * thick * np.sin(3 * t)])  # fmt: skip
    ends = smooth([path[-1], path[-1] + [0.02, 0.03, 0], (1.5 * r, 0.75 * r, thick + 0.002),
                   (1.75 * r, 0.3 * r, thick + 0.002)], 4)  # fmt: skip
    cable = tube(np.concatenate([path, ends[2:]]), thick, 6)
    plug = block(0.013, 0.03, 0.008, 0.003, 0.001).move(1.75 * r, 0.3 * r - 0.014)
    tip = box(0.008, 0.012, 0.0035).move(1.75 * r, 0.3 * r - 0.034, 0.0022)
    tie = block(0.012, 0.34 * r, 5 * thick, 0.004).move(x=0, y=-0.8 * r)
    tone = surfaces.plain(look.own_color("black", "white", "green", "orange"))
    low, high = 0.62, 1.1
    ring = ring_parts([(high * r, 0.0), (high * r, 4.4 * thick)],
                      [(low * r, 4.4 * thick), (low * r, 0.0)], 12,
                      stretch=(1.25, 0.8))  # fmt: skip
    return shape([(cable, surfaces.plain(color)), (plug, surfaces.plain(tint_color(color, 0.85))),
                  (tip, surfaces.plain((190, 192, 198))), (tie, tone)],
                 [*ring, hull_of(plug), hull_of(tie)])  # fmt: skip


@category("calculator", size=(0.084, 0.14, 0.014), mass=0.11, material="device",
          aliases=("pocket calculator", "numeric keypad", "number pad"), themes=("office",),
          roles=("flat",), colors=("charcoal", "white"), state="lying flat",
          common=True)  # fmt: skip
def calculator(look: Look) -> Shape:
    """A pocket calculator lying flat with its display at the far end."""
    x, y, h = look.between(0.078, 0.09), look.between(0.13, 0.15), 0.013
    color = look.color("charcoal", "white", "navy", "gray", "pink", "teal", "yellow", "black")
    cap, mark = (look.pick([(232, 232, 230), (60, 62, 68), (250, 236, 200)]),
                 look.own_color("orange", "red", "teal", "blue", "yellow"))  # fmt: skip
    face = prints.canvas(96, 160, color)
    prints.fill(face, 0.1, 0.06, 0.8, 0.17, (178, 196, 170))
    prints.write(face, str(int(look.rng.integers(100, 99999))), 0.62, 0.15, 0.1, (40, 46, 40))
    pad = prints.keys([(1,) * 4] * 5, cap, tint_color(color, 0.9), accent=mark, width=80,
                      height=100)  # fmt: skip
    face[52:152, 8:88] = pad
    body = block(x, y, h, 0.008, 0.002)
    return shape([(body, surfaces.plain(color)), (box(x * 0.92, y * 0.94, 0.0008).move(z=h), face)],
                 [box_part(x, y, h)])  # fmt: skip
