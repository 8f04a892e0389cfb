"""Stands, lights, cameras and reels around a desk."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, flat_foot, hull_of, ring_parts
from ...build.forms import above, facing, lay_down, side_view
from ...build.outlines import ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .desktop import DARK


def security_camera(look: Look) -> Shape:
    """A security camera on a foot: a bullet with a dark glass front."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "white", "black", "gray")
    tile = look.surface(color, "plastic")
    base = cylinder(0.034 * k, 0.014 * k, 28, bevel=0.003)
    post = tube([(0, 0.004, 0.012), (0, 0.0, 0.05 * k)], 0.0075 * k, 12)
    tube_ = facing(lathe(np.array([(0, -0.055), (0.02, -0.055), (0.027, -0.048), (0.027, 0.05),
                                   (0.024, 0.053), (0.021, 0.049), (0, 0.049)]) * k,
                                       28))  # fmt: skip
    tube_ = tube_.turn(0, 0.12).move(z=0.076 * k)
    hood = facing(prism(_half(0.031 * k, 0.0285 * k), -0.045 * k, 0.068 * k)).turn(0, 0.12).move(
        z=0.076 * k)  # fmt: skip
    glass = (
        facing(cylinder(0.0212 * k, 0.0008, 26).move(z=0.0492 * k)).turn(0, 0.12).move(z=0.076 * k)
    )
    lens = (
        facing(cylinder(0.0095 * k, 0.0016, 20).move(z=0.0494 * k)).turn(0, 0.12).move(z=0.076 * k)
    )
    dots = [facing(cylinder(0.0022 * k, 0.0014, 8).move(0.0155 * k * np.cos(a),
        0.0155 * k * np.sin(a),
            0.0495 * k)).turn(0, 0.12).move(z=0.076 * k)
                for a in np.arange(8) * np.pi / 4]  # fmt: skip
    return shape([(join([base, post, tube_, hood]), tile), (glass, textures.plain((24, 24, 28))),
                  (lens, textures.gradient((30, 30, 60), (90, 110, 190), look.rng)),
                  (join(dots), textures.plain((150, 60, 60)))],
                 [hull_of(base), hull_of(post), hull_of(tube_), hull_of(hood)])  # fmt: skip


def _half(outer: float, inner: float) -> np.ndarray:
    a = np.linspace(-0.2, np.pi + 0.2, 18)
    ring = np.column_stack([np.cos(a), np.sin(a)])
    return np.concatenate([outer * ring, inner * ring[::-1]])


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
                  (glow, textures.plain((255, 250, 232)))],
                 [*upright, hull_of(post), hull_of(hub), *(hull_of(s) for s in legs)])  # fmt: skip


def laser_pointer(look: Look) -> Shape:
    """A laser pointer lying: a slim tube with a button, a red glint at its tip."""
    k = look.between(0.92, 1.08)
    color = look.color("silver", "black", "black", "gold", "red", "blue")
    body = lathe(np.array([(0, 0), (0.0045, 0), (0.0062, 0.006), (0.0066, 0.03), (0.0066, 0.128),
                           (0.0055, 0.135), (0, 0.135)]) * k, 20)  # fmt: skip
    body = lay_down(body, -0.0675 * k, 0.0066 * k)
    tip = lay_down(cylinder(0.0025 * k, 0.002, 12), -0.0675 * k - 0.0014, 0.0066 * k)
    knob = block(0.011 * k, 0.0055 * k, 0.0025 * k, 0.002).move(x=-0.02 * k, z=0.0124 * k)
    rings = [lay_down(torus(0.0066 * k, 0.0006, 18, 5), x * k, 0.0066 * k) for x in (0.01, 0.05)]
    return shape([(body, look.surface(color, "metal")), (tip, textures.plain((250, 50, 50))),
                  (join([knob, *rings]), textures.plain((160, 162, 168)
                      if sum(color) < 300 else DARK))],
                 [flat_foot(body.vertices, 0.1), hull_of(knob)])  # fmt: skip


def headphone_stand(look: Look) -> Shape:
    """A stand for headphones: a foot, a post, a curved saddle on top."""
    k = look.between(0.88, 1.04)
    color = look.color("black", "wooden", "silver", "white", "charcoal", "wooden")
    tile = look.surface(color, look.pick(["wood", "metal", "plastic"]))
    foot = cylinder(0.065 * k, 0.012 * k, 34, bevel=0.003)
    post = block(0.028 * k, 0.014 * k, 0.24 * k, 0.004).move(z=0.011 * k)
    a = np.linspace(0.35, np.pi - 0.35, 12)
    curve = np.column_stack([0.055 * np.cos(a), 0.21 + 0.05 * np.sin(a)])
    under = (curve - [0, 0.21]) * 0.84 + [0, 0.21]
    saddle = side_view(np.concatenate([curve, under[::-1]]) * k, 0.05 * k)
    halves = [hull_of(side_view(np.concatenate([curve[m], under[m][::-1]]) * k, 0.05 * k))
              for m in (slice(0, 5), slice(4, 8), slice(7, 12))]  # fmt: skip
    return shape([(join([foot, post, saddle]), tile)],
                 [hull_of(foot), hull_of(post), *halves])  # fmt: skip


def laptop_stand(look: Look) -> Shape:
    """A raised stand for a laptop: a level plate on a bent back, open to the front."""
    k = look.between(0.9, 1.04)
    color = look.color("silver", "silver", "black", "white", "wooden", "gray")
    tile = look.surface(color, "metal")
    x, y, h, t = 0.26 * k, 0.22 * k, 0.11 * k, 0.006
    plate = block(x, y, t, 0.012).move(z=h - t)
    foot = block(x, y, t, 0.012)
    sides = [
        box(t, 0.7 * y, h - 2 * t + 0.001).move(s * 0.32 * x, 0.0, t - 0.0005) for s in (-1, 1)
    ]
    pads = [block(0.12 * x, 0.012, 0.0018, 0.004).move(s * 0.3 * x, u * y, h - 0.0006)
            for s in (-1, 1) for u in (-0.35, 0.35)]  # fmt: skip
    return shape([(join([plate, foot, *sides]), tile), (join(pads), textures.plain(DARK))],
                 [box_part(x, y, t + 0.001, (0, 0, h - t)), hull_of(foot),
                  *(hull_of(s) for s in sides)])  # fmt: skip


def docking_station(look: Look) -> Shape:
    """A docking station: a low wedge with rows of sockets."""
    k = look.between(0.9, 1.06)
    x, y, h = 0.2 * k, 0.08 * k, 0.028 * k
    color = look.color("black", "silver", "charcoal", "gray", "white")
    image = prints.canvas(176, 28, tint_color(color, 0.85))
    for n, (u, wide, tall) in enumerate(((0.08, 0.08, 0.3), (0.2, 0.08, 0.3), (0.32, 0.05, 0.22),
                                         (0.42, 0.05, 0.22), (0.54, 0.09, 0.34), (0.67, 0.09, 0.34),
                                         (0.8, 0.08, 0.5))):  # fmt: skip
        prints.fill(image, u, 0.5 - tall / 2, wide, tall, (20, 20, 24))
        if n < 2:
            prints.fill(image, u + 0.01, 0.48, wide - 0.02, 0.1, (60, 110, 210))
    prints.disc(image, 0.93, 0.5, 0.16, (20, 20, 24))
    front = box(0.97 * x, 0.0012, 0.9 * h).move(y=-y / 2, z=0.05 * h)
    lamp = cylinder(0.0022, 0.001, 10).move(0.44 * x, -0.35 * y, h - 0.0003)
    line = box(0.9 * x, 0.001, 0.0006).move(y=-0.25 * y, z=h - 0.0003)
    return shape([(block(x, y, h, 0.006, 0.003), look.surface(color, "metal")), (front, image),
                  (lamp, textures.plain((90, 220, 255))), (line, textures.plain(
                      tint_color(color, 0.6)))], [box_part(x, y, h)])  # fmt: skip


def cable_reel(look: Look) -> Shape:
    """An extension cable on a reel, standing in its frame."""
    k = look.between(0.85, 1.0)
    color = look.color("orange", "red", "blue", "yellow", "black", "green")
    r, wide = 0.09 * k, 0.085 * k
    z = r + 0.012 * k
    discs = [facing(cylinder(r, 0.006 * k, 36)).move(y=y, z=z) for y in (-wide / 2 + 0.006 * k,
                                                                         wide / 2)]  # fmt: skip
    coil = facing(cylinder(0.8 * r, wide - 0.01 * k, 30)).move(y=wide / 2 - 0.004 * k, z=z)
    cord = textures.stripes([tint_color(color, 0.5), (40, 40, 42)], 14)
    face = prism(ellipse(0.9 * r, 0.9 * r, 28), 0, 0.004)
    face = facing(face).move(y=-wide / 2, z=z)
    sockets = [facing(cylinder(0.018 * k, 0.004, 18)).move(0.024 * k * np.cos(a), -wide / 2 - 0.003,
               z + 0.024 * k * np.sin(a))
                   for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    holes = [facing(cylinder(0.0026 * k, 0.001, 8)).move(0.024 * k * np.cos(a) + s * 0.006 * k,
             -wide / 2 - 0.0068, z + 0.024 * k * np.sin(a)) for s in (-1, 1)
             for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    rails = [tube(smooth([(-0.09 * k, y, 0.0055 * k), (0.09 * k, y, 0.0055 * k), (0.06 * k, y, z),
                          (0.02 * k, y, 2 * z + 0.015 * k), (-0.02 * k, y, 2 * z + 0.015 * k),
                          (-0.06 * k, y, z), (-0.09 * k, y, 0.0055 * k)], 2), 0.0052 * k, 8)
             for y in (-wide / 2 - 0.014 * k, wide / 2 + 0.01 * k)]  # fmt: skip
    grip = facing(cylinder(0.008 * k, wide + 0.034 * k, 14)).move(
        y=wide / 2 + 0.015 * k, z=2 * z + 0.014 * k)  # fmt: skip
    low = max(min(float(s.bounds[0, 2]) for s in rails), 0.0)
    feet = [box_part(0.18 * k, 0.01 * k, 0.0104 * k, (0, y, low)) for y in
            (-wide / 2 - 0.014 * k, wide / 2 + 0.01 * k)]  # fmt: skip
    return shape([(join(discs), look.surface(color, "plastic")), (coil, cord),
                  (face, textures.plain(DARK)), (join(sockets), textures.plain((90, 92, 96))),
                  (join(holes), textures.plain((16, 16, 18))),
                  (join([*rails, grip]), textures.plain((52, 52, 56)))],
                 [*feet, hull_of(*discs, coil), hull_of(grip),
                     *(hull_of(r_.bend(above)) for r_ in rails)])  # fmt: skip


def label_maker(look: Look) -> Shape:
    """A hand-held label printer lying: screen, keys, a label coming out."""
    k = look.between(0.9, 1.06)
    color = look.color("white", "blue", "black", "gray", "teal")
    x, y, h = 0.1 * k, 0.17 * k, 0.045 * k
    body = block(x, y, h, 0.02, 0.006)
    shown = prints.canvas(72, 32, (176, 196, 170))
    word = look.pick(["FILES", "HOME", "KEYS", "LABEL"])
    prints.write(shown, word, 0.5, 0.5, 0.5, (30, 36, 28), bold=True)
    screen = box(0.66 * x, 0.16 * y, 0.0008).move(y=0.27 * y, z=h - 0.0003)
    pad = prints.keys([(1,) * 7] * 5, (236, 236, 232), tint_color(color, 0.6), width=112, height=80)
    board = box(0.84 * x, 0.46 * y, 0.0008).move(y=-0.13 * y, z=h - 0.0003)
    strip = prints.canvas(96, 28, (250, 250, 246))
    prints.write(strip, word, 0.45, 0.5, 0.6, (20, 20, 24), bold=True)
    paper = box(0.05 * k, 0.0006, 0.013 * k).move(-0.5 * x - 0.022 * k, 0.36 * y, 0.4 * h)
    return shape([(body, look.surface(color, "plastic")), (screen, shown), (board, pad),
                  (paper, strip)], [hull_of(body)])  # fmt: skip


CATEGORIES = (
    Category("security_camera", security_camera, (0.068, 0.125, 0.112), 0.3, ("surveillance camera",
             "cctv camera", "ip camera", "cctv", "baby camera"), ("electronics",), (),
             ("white",)),
    Category("ring_light", ring_light, (0.18, 0.13, 0.327), 0.45, ("selfie light", "ring lamp",
             "photo light", "studio light", "camera flash"), ("office",), ("tall", "big"),
             ("black",)),
    Category("laser_pointer", laser_pointer, (0.1365, 0.014, 0.0145), 0.04, ("laser pen",
             "laser", "presentation pointer",
             "presentation clicker", "presentation remote"), ("office",), (),
             ("silver", "black"), None,
             "lying flat"),
    Category("headphone_stand", headphone_stand, (0.125, 0.125, 0.25), 0.5, ("headphone holder",
             "headset stand", "headphones stand", "headphones holder", "headset holder"),
             ("office",), ("tall",), ("black", "wooden")),
    Category("laptop_stand", laptop_stand, (0.252, 0.2135, 0.108), 1.6, ("laptop riser",
             "notebook stand", "laptop holder", "monitor riser", "computer stand",
             "monitor stand", "laptop platform"), ("office",), ("support", "big"), ("silver",)),
    Category("docking_station", docking_station, (0.196, 0.0795, 0.0278), 0.35, ("dock",
             "laptop dock", "usb dock", "usb c dock", "port replicator"), ("office",), (),
             ("black", "silver")),
    Category("cable_reel", cable_reel, (0.173, 0.112, 0.2), 1.2, ("extension reel", "cord reel",
             "extension cable reel", "cable drum", "extension lead", "extension cable"),
             ("workbench",), ("big",), ("orange",)),
    Category("label_maker", label_maker, (0.123, 0.1665, 0.045), 0.4, ("label printer",
             "labelmaker", "labeler", "labeller", "label writer", "label machine"), ("office",),
             (), ("white",)),
)  # fmt: skip
"""The module's categories."""
