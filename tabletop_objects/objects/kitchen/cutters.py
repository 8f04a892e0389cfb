"""Objects of the ``kitchen`` theme: cutting tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, hull_above, hull_of, hull_part
from ...kit.primitives import ball, bent_rod, limb, straight
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, put_down, shape
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
from ...kit.surfaces import RGB, Look, tint_color
from .appliances import metal
from .utensils import Head, bright_steel, grip_bar, steel, with_handle


@category("pizza_cutter", size=(0.215, 0.08, 0.019), mass=0.12, material="metal",
          aliases=("pizza wheel", "pizza slicer", "rolling cutter", "tracing wheel"),
          themes=("kitchen",), roles=("flat",), colors=("black", "red"),
          state="lying flat")  # fmt: skip
def pizza_cutter(look: Look) -> Shape:
    """A pizza cutter lying flat with its wheel on the left."""
    r, long = look.between(0.034, 0.046), look.between(0.2, 0.23)
    color = look.color("black", "red", "wooden", "white", "green", "teal")
    wheel = lathe([(0, 0.0085), (0.8 * r, 0.0085), (r, 0.0095), (0.8 * r, 0.0105), (0, 0.0105)], 34)
    wheel = wheel.move(x=-0.5 * long + r)
    hub = cylinder(0.008, 0.019, 16, bevel=0.002).move(x=-0.5 * long + r)
    arms = [box(r + 0.03, 0.012, 0.002).move(-0.5 * long + r + 0.5 * (r + 0.02), 0, z)
            for z in (0.0055, 0.0115)]  # fmt: skip
    start = -0.5 * long + 2 * r + 0.012
    grip = grip_bar(start, 0.5 * long, 0.028, 0.0095)
    guard = block(0.01, 0.034, 0.018, 0.004, 0.002).move(x=start + 0.004)
    return shape([(join([wheel, *arms]), bright_steel(look)), (hub, surfaces.plain((60, 62, 66))),
                  (join([grip, guard]), look.surface(color, "plastic"))],
                 [hull_of(wheel), hull_of(hub), hull_of(*arms), hull_of(grip),
                  hull_of(guard)])  # fmt: skip


@category("mandoline", size=(0.29, 0.109, 0.0985), mass=0.5, material="plastic", assembled=True,
          aliases=("mandolin slicer", "vegetable slicer", "mandoline slicer"), themes=("kitchen",),
          roles=("big",), colors=("white", "black"))  # fmt: skip
def mandoline(look: Look) -> Shape:
    """A mandoline slicer: a sloping board with a slanted blade, on a stand."""
    x, y = look.between(0.28, 0.34), look.between(0.1, 0.12)
    color = look.color("white", "black", "red", "green", "sage", "silver")
    skin = look.surface(color, "plastic")
    board = block(x, y, 0.01, 0.02, 0.002)
    rails = [box(0.82 * x, 0.008, 0.014).move(0, s * 0.44 * y, 0.004) for s in (-1, 1)]
    blade = prism(np.array([(-0.02, -0.4 * y), (0.0, -0.4 * y), (0.03, 0.4 * y), (0.01, 0.4 * y)]),
                  0.0095, 0.012)  # fmt: skip
    guard = block(0.075, 0.8 * y, 0.014, 0.02, 0.004).move(0.24 * x, 0, 0.0105)
    knob = cylinder(0.018, 0.02, 20, top=0.022, bevel=0.004).move(0.24 * x, 0, 0.024)
    dark = surfaces.plain(tint_color(color, 0.55) if sum(color) > 200 else (110, 112, 116))
    lean = 0.3
    up = [(s.turn(1, lean).move(z=0.5 * x * np.sin(lean)), t) for s, t in ((join([board, *rails]),
                                                                            skin),
                                                                           (blade,
                                                                            bright_steel(look)),
                                                                           (join([guard, knob]),
                                                                            dark))]  # fmt: skip
    legs = [box(0.012, 0.012, 0.28 * x).turn(1, -0.25).move(-0.3 * x, s * 0.42 * y, 0)
            for s in (-1, 1)]  # fmt: skip
    bar = box(0.02, y, 0.006).move(-0.31 * x)
    up.append((join([*legs, bar]), skin))
    return shape(up, [hull_above(up[0][0]), hull_of(up[2][0]), hull_above(*legs, bar)])


@category("cookie_cutter", size=(0.0761, 0.0725, 0.0243), mass=0.025, material="metal",
          aliases=("biscuit cutter", "pastry cutter", "cookie stamp"), themes=("kitchen",),
          roles=("flat",), colors=("silver", "red"), state="lying flat")  # fmt: skip
def cookie_cutter(look: Look) -> Shape:
    """A cookie cutter: a thin wall in the shape of a star, heart, flower or circle."""
    r, h = look.between(0.03, 0.042), look.between(0.02, 0.026)
    color = look.color("silver", "silver", "copper", "red", "green", "blue", "pink")
    skin = look.surface(color, "metal")
    kind = look.pick(["star", "heart", "flower", "round"])
    t = np.linspace(0, 2 * np.pi, 61)[:-1]
    if kind == "star":
        away = 0.78 + 0.3 * np.abs(((t * 5 / (2 * np.pi)) % 1) - 0.5) * 2 - 0.1
        ring = np.column_stack([away * np.sin(t), away * np.cos(t)])[::-1]
    elif kind == "heart":
        ring = np.column_stack([np.sin(t) ** 3, (13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(
            3 * t) - np.cos(4 * t)) / 15])[::-1]  # fmt: skip
    elif kind == "flower":
        away = 0.86 + 0.14 * np.cos(6 * t)
        ring = np.column_stack([away * np.cos(t), away * np.sin(t)])
    else:
        ring = np.column_stack([np.cos(t), np.sin(t)])
    ring = ring * r
    lip, thin = 1.06, 0.955
    loop = np.stack([np.column_stack([ring * k, np.full(len(ring), z)]) for k,
                     z in ((1.0, 0), (1.0, h - 0.002), (lip, h - 0.002), (lip, h), (thin, h),
                           (thin, 0))])  # fmt: skip
    wall = loft(loop, ring, profile=np.array([(k * r, z) for k, z in ((1.0, 0), (1.0, h - 0.002),
                                                                      (lip, h - 0.002), (lip, h),
                                                                      (thin, h), (thin, 0))]),
                loop=True)  # fmt: skip
    parts = []
    for k in range(12):
        span = np.arange(5 * k, 5 * k + 6) % 60
        points = np.concatenate([np.column_stack([ring[span] * f, np.full(6, z)])
                                 for f in (1.0, thin) for z in (0, h)])  # fmt: skip
        parts.append(hull_part(points))
    return shape([(wall, skin)], parts)


STEEL: RGB = (188, 191, 196)


@category("cheese_plane", size=(0.246, 0.0724, 0.0206), mass=0.08, material="metal", assembled=True,
          aliases=("cheese slicer", "cheese shaver", "truffle slicer"),
          themes=("kitchen", "dining"), colors=("wooden",), state="lying flat")  # fmt: skip
def cheese_plane(look: Look) -> Shape:
    """A cheese plane lying flat: a slotted blade with a handle."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "black", "red", "silver", "teal")
    plate = prism(np.array([(-0.012, -0.02), (0.03, -0.036), (0.1, -0.034), (0.1, 0.034),
                            (0.03, 0.036), (-0.012, 0.02)]), 0.004, 0.0058)  # fmt: skip
    slot = box(0.005, 0.05, 0.0024).move(x=0.05, z=0.0038)
    lip = box(0.008, 0.05, 0.0016).turn(1, 0.3).move(x=0.058, z=0.0066)
    neck = straight((-0.012, 0, 0.006), (-0.04, 0, 0.011), 0.0045)
    grip = bent_rod(0.11, 0.0105, blunt=6).move(x=-0.09, z=0.0105)
    steel = surfaces.brushed_metal(look.rng, STEEL)
    return put_down([(join([plate, neck, lip]), steel), (slot, surfaces.plain((40, 42, 46))),
                     (grip, look.surface(color, "wood"))], plate, grip, factor=k,
                    foot=0.35)  # fmt: skip


@category("cheese_wire", size=(0.218, 0.139, 0.074), mass=0.6, material="wood", assembled=True,
          aliases=("wire cheese slicer", "cheese slicer board"), themes=("kitchen", "dining"),
          colors=("wooden",))  # fmt: skip
def cheese_wire(look: Look) -> Shape:
    """A cheese board with a cutting wire stretched in a bow."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "white", "cream")
    x, y = 0.22 * k, 0.14 * k
    board = block(x, y, 0.018, 0.006, 0.002)
    slot = box(0.003, 0.9 * y, 0.0006).move(x=0.18 * x, z=0.0177)
    arm = [straight((0.18 * x, s * 0.42 * y, 0.018), (0.18 * x, s * 0.42 * y, 0.062), 0.0028)
           for s in (-1, 1)]  # fmt: skip
    bar = straight((0.18 * x, -0.42 * y, 0.06), (0.18 * x, 0.42 * y, 0.06), 0.0028)
    wire = straight((0.18 * x, -0.42 * y, 0.03), (0.18 * x, 0.42 * y, 0.03), 0.0006, 5)
    knob = ball(0.016, 0.016, 0.016, (0.18 * x, 0, 0.066), 12)
    steel = surfaces.brushed_metal(look.rng, STEEL)
    return shape([(board, look.surface(color, "wood")), (slot, surfaces.plain((60, 46, 36))),
                  (join([*arm, bar, wire, knob]), steel)],
                 [box_part(x, y, 0.018), hull_of(bar, knob),
                  *(hull_of(a) for a in arm)])  # fmt: skip


HUES = ("white", "green", "red", "gray", "black", "teal", "yellow")


@category("spiralizer", size=(0.324, 0.128, 0.151), mass=0.8, material="plastic", assembled=True,
          aliases=("spiraliser", "vegetable spiralizer", "spiral slicer"), themes=("kitchen",),
          roles=("big",), colors=("white", "green"))  # fmt: skip
def spiralizer(look: Look) -> Shape:
    """A spiralizer: a crank, a courgette pressed against a toothed blade, and spirals in front."""
    k, color = look.between(0.88, 1.05), look.color(*HUES)
    rails = [box(0.26, 0.014, 0.018).move(y=s * 0.05, z=0.008) for s in (-1, 1)]
    ends = [block(0.018, 0.12, 0.13, 0.006).move(x) for x in (-0.09, 0.06)]
    feet = [cylinder(0.014, 0.01, 14, top=0.01).move(i * 0.12, j * 0.05, 0) for i in (-1, 1)
            for j in (-1, 1)]  # fmt: skip
    blade = cylinder(0.05, 0.004, 28).turn(1, -np.pi / 2).move(-0.099, 0, 0.075)
    veg = limb([(-0.08, 0, 0.075), (-0.02, 0, 0.075), (0.05, 0, 0.075)], [0.022, 0.023, 0.02], 14)
    crank = tube([(0.05, 0, 0.075), (0.11, 0, 0.075), (0.112, 0, 0.14), (0.12, 0, 0.142)], 0.005, 8)
    grip = cylinder(0.01, 0.04, 14).turn(1, np.pi / 2).move(0.118, 0, 0.142)
    a = np.linspace(0, 18, 60)
    curl = tube(np.column_stack([-0.125 - 0.0012 * a + 0.02 * np.cos(a), 0.03 * np.sin(a), 0.004
                                 + 0.0012 * a]), 0.003, 5)  # fmt: skip
    made = [(join([*rails, *ends]), look.surface(color, "plastic")), (blade,
        prints.mesh_holes((206, 210, 214), (120, 124, 130), 5, 5)), (veg,
            surfaces.stripes([(86, 140, 66), (110, 164, 84)], 8, upright=True)),
            (join([crank]), metal(look)), (join([grip, *feet]), surfaces.plain((40, 42, 46))),
            (curl, surfaces.plain((176, 206, 120)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(*[s.scale(k, k, k) for s in (*rails, *feet)]),
                        *[hull_of(e.scale(k, k, k)) for e in ends],
                        hull_of(made[3][0], grip.scale(k, k, k)), hull_of(made[5][0])])  # fmt: skip


EGG_SLICER_STEEL: RGB = (190, 194, 200)


@category("egg_slicer", size=(0.089, 0.121, 0.117), mass=0.12, material="plastic", assembled=True,
          aliases=("egg cutter", "egg wedger", "mozzarella slicer"), themes=("kitchen",),
          colors=("white",))  # fmt: skip
def egg_slicer(look: Look) -> Shape:
    """An egg slicer: a tray with an egg in its hollow and a hinged frame of wires above."""
    k, color = look.between(0.9, 1.1), look.color("white", "red", "silver", "yellow", "mint")
    tray = block(0.09, 0.12, 0.016, 0.012, 0.003)
    slots = [box(0.07, 0.002, 0.001).move(0, 0.008 * j, 0.0156) for j in range(-5, 6)]
    egg = ellipsoid(0.042, 0.056, 0.042, 20, 12).move(z=0.03)
    frame = [box(0.09, 0.006, 0.006).move(y=y) for y in (-0.104, 0.0)] + [
        box(0.006, 0.11, 0.006).move(s * 0.042, -0.052) for s in (-1, 1)
    ]
    wires = [tube([(-0.03 + 0.0075 * i, -0.104, 0.003), (-0.03 + 0.0075 * i, 0, 0.003)], 0.0007, 4)
             for i in range(9)]  # fmt: skip
    up = [s.turn(0, -1.15).move(y=0.056, z=0.018) for s in frame]
    lines = [s.turn(0, -1.15).move(y=0.056, z=0.018) for s in wires]
    made = [
        (join([tray, *up]), look.surface(color, "plastic")),
        (join(slots), surfaces.plain((70, 72, 76))),
        (egg, surfaces.speckles(look.rng, (250, 246, 238), 4)),
        (join(lines), surfaces.plain(EGG_SLICER_STEEL)),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(tray.scale(k, k, k)), hull_of(*[s.scale(k, k, k) for s in up]),
                        hull_of(made[2][0])])  # fmt: skip


@category("peeler", size=(0.149, 0.0548, 0.0125), mass=0.045, material="plastic",
          aliases=("vegetable peeler", "potato peeler", "y peeler", "swivel peeler"),
          themes=("kitchen",), roles=("flat",), colors=("black", "red"),
          state="lying flat")  # fmt: skip
def peeler(look: Look) -> Shape:
    """A vegetable peeler lying flat: a Y-peeler or a straight peeler."""
    color = look.color("black", "red", "green", "white", "orange", "teal", "silver", "yellow")
    skin, steel = look.surface(color, "plastic"), bright_steel(look)
    if look.chance(0.6):
        wide = look.between(0.058, 0.066)
        grip = sweep([(-0.005, 0, 0.006), (0.03, 0, 0.0065), (0.075, 0, 0.006)],
                     rectangle(0.02, 0.012, 0.005, 3), [0.7, 1.0, 0.85])  # fmt: skip
        fork = sweep(smooth([(-0.06, -wide / 2, 0.006), (-0.03, -wide / 2, 0.006),
                             (-0.004, 0, 0.006), (-0.03, wide / 2, 0.006),
                             (-0.06, wide / 2, 0.006)], 4),
                     rectangle(0.01, 0.0115, 0.003, 2))  # fmt: skip
        edge = [box(0.004, wide - 0.004, 0.0016).turn(1, 0.5).move(x=u, z=0.006)
                for u in (-0.058, -0.051)]  # fmt: skip
        x = fork.vertices[:, 0]
        y = fork.vertices[:, 1]
        arms = [hull_part(fork.vertices[(s * y > 0.35 * wide)]) for s in (-1, 1)]
        return shape([(join([grip, fork]), skin), (join(edge), steel)],
                     [hull_of(grip), *arms, hull_part(fork.vertices[x > -0.028]),
                      hull_of(*edge)])  # fmt: skip
    grip = grip_bar(-0.01, 0.09, 0.021, 0.0066)
    ring = np.array([(0.5, 0), (0, 0.4), (-0.5, 0), (0, -0.12)])
    long = look.between(0.075, 0.085)
    path = np.column_stack([-0.005 - long * np.linspace(0, 1, 6), np.zeros(6), np.full(6, 0.006)])
    blade = sweep(path, ring, 0.017 * np.array([0.5, 0.9, 1, 1, 0.9, 0.2]))
    return shape([(grip, skin), (blade, steel)], [hull_of(grip), hull_of(blade)])


@category("grater", size=(0.11, 0.085, 0.24), mass=0.25, material="metal",
          aliases=("cheese grater", "box grater", "vegetable grater", "shredder"),
          themes=("kitchen",), roles=("tall",), colors=("silver", "black"))  # fmt: skip
def grater(look: Look) -> Shape:
    """A four-sided box grater with a handle on top."""
    x, y, h = look.between(0.095, 0.115), look.between(0.075, 0.085), look.between(0.19, 0.22)
    color = look.color("black", "red", "green", "teal", "orange", "silver", "white")
    face = surfaces.brushed_metal(look.rng, (196, 199, 204), 128).copy()
    face = surfaces.fit(face, 128, 128).copy()
    count = look.pick([7, 9])
    v, u = np.mgrid[0:128, 0:128] / 128
    cells = np.hypot(
        (u * count) % 1 - 0.5, ((v * count + 0.5 * (np.floor(u * count) % 2)) % 1) - 0.5
    )
    keep = (u > 0.1) & (u < 0.9) & (v > 0.12) & (v < 0.86)
    face[(cells < 0.36) & keep] = (236, 238, 242)
    face[(cells < 0.24) & keep] = (52, 54, 58)
    square = rectangle(1, 1)
    rings = np.stack([np.column_stack([square * [x * k, y * k], np.full(4, z)])
                      for k, z in ((1.0, 0.008), (0.78, h))])  # fmt: skip
    sides = []
    for k in range(4):
        a, b = rings[0][k], rings[0][(k + 1) % 4]
        c, d = rings[1][(k + 1) % 4], rings[1][k]
        inward = -0.002 * np.append((a + b)[:2] / np.linalg.norm((a + b)[:2]), 0)
        corners = np.array([a, b, c, d])
        quad = np.concatenate([corners, corners + inward])
        faces = np.array([[0, 1, 2], [0, 2, 3], [5, 4, 7], [5, 7, 6], [0, 4, 5], [0, 5, 1],
                          [1, 5, 6], [1, 6, 2], [2, 6, 7], [2, 7, 3], [3, 7, 4],
                          [3, 4, 0]])  # fmt: skip
        uv = np.array([(0, 0), (1, 0), (1, 1), (0, 1)] * 2, float)
        sides.append(Solid(quad, faces, uv))
    body = join(sides)
    skin = look.surface(color, "plastic")
    lid = block(0.8 * x, 0.8 * y, 0.012, 0.012, 0.003).move(z=h - 0.004)
    foot = loft(np.stack([np.column_stack([rectangle(x * k, y * k), np.full(4, z)])
                          for k, z in ((1.03, 0), (1.02, 0.012))]), square)  # fmt: skip
    ear = tube(smooth([(-0.3 * x, 0, h), (-0.27 * x, 0, h + 0.035), (0.27 * x, 0, h + 0.035),
                       (0.3 * x, 0, h)], 4), 0.007, 8)  # fmt: skip
    return shape([(body, face), (join([lid, foot, ear]), skin)],
                 [hull_of(body, foot), hull_of(lid), hull_of(ear)])  # fmt: skip


def _tube_head(look: Look, color: RGB, z: float) -> Pieces:
    pipe = (lathe([(0.0095, 0), (0.0108, 0), (0.0108, 0.09), (0.0095, 0.09)], 18,
                  loop=True).turn(1, -np.pi / 2).move(0, 0, z))  # fmt: skip
    teeth = [box(0.006, 0.003, 0.004).move(-0.092, 0, 0.0085).turn(0, a).move(z=z) for a in 2
             * np.pi * np.arange(8) / 8]  # fmt: skip
    return [(join([pipe, *teeth]), steel(look))]


def _rasp(long: float, wide: float) -> Head:
    def make(look: Look, color: RGB, z: float) -> Pieces:
        plate = prism(rectangle(long, wide, 0.004), 0, 0.0022).move(-long / 2, 0, z)
        image = surfaces.fit(steel(look), 64, 192).copy()
        for i in range(26):
            for j in range(5):
                at = ((i + 0.5 + 0.5 * (j % 2)) / 27, (j + 0.7) / 5.4)
                prints.disc(image, *at, 0.055, (60, 62, 68))
                prints.disc(image, at[0] - 0.006, at[1], 0.03, (230, 232, 236))
        rails = [box(long, 0.003, 0.006).move(-long / 2, s * wide / 2, z - 0.003) for s in (-1, 1)]
        face = box(0.96 * long, 0.9 * wide, 0.0004).move(-long / 2, 0, z + 0.0021)
        return [(join([plate, *rails]), steel(look)), (face, image)]

    return make


def _holes_tip(look: Look, color: RGB, z: float) -> Pieces:
    head = prism(rectangle(0.018, 0.02, 0.006), 0, 0.006).move(-0.009, 0, z - 0.003)
    rings = [torus(0.0022, 0.0009, 10, 5).turn(1, np.pi / 2).move(-0.019, y, z)
             for y in (-0.007, -0.0023, 0.0023, 0.007)]  # fmt: skip
    return [(head, steel(look)), (join(rings), surfaces.plain((60, 62, 68)))]


CATEGORIES = (
    Category("apple_corer", keep_still(with_handle(_tube_head, (0.08, 0.1), 0.012, r=0.011)),
             size=(0.199, 0.0253, 0.0248), mass=0.06, material="plastic",
             aliases=("corer", "pineapple corer"), themes=("kitchen",), colors=("black", "red"),
             state="lying flat"),
    Category("zester", keep_still(with_handle(_rasp(0.17, 0.03), (0.1, 0.12), 0.01)),
             size=(0.292, 0.0332, 0.0208), mass=0.09, material="plastic", aliases=("microplane",
             "lemon zester", "rasp grater", "hand grater", "nutmeg grater", "fine grater"),
             themes=("kitchen",), colors=("black", "red"), state="lying flat"),
    Category("citrus_zester", keep_still(with_handle(_holes_tip, (0.08, 0.1), 0.03)),
             size=(0.142, 0.0212, 0.0203), mass=0.05, material="plastic",
             aliases=("channel knife", "five hole zester"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
