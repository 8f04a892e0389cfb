"""Instruments and containers of a surgery."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, flat_foot, hull_of
from ...build.forms import lay_down
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    join,
    lathe,
    loft,
    prism,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

STEEL: RGB = (186, 189, 194)


def _steel(look: Look) -> textures.Tile:
    return look.surface(look.color("silver", "silver", "gray"), "metal")


def scalpel(look: Look) -> Shape:
    """A scalpel lying: flat handle, small curved blade."""
    k = look.between(0.92, 1.08)
    metal = _steel(look)
    handle = prism(np.array([(-0.075, -0.003), (0.02, -0.0045), (0.035, -0.002), (0.035, 0.002),
                             (0.02, 0.0045), (-0.075, 0.004)]) * k, 0, 0.004 * k)  # fmt: skip
    edge = smooth([(0.032, -0.003), (0.055, -0.0065), (0.069, -0.003), (0.074, 0.0035)], 4)
    blade = prism(np.concatenate([edge, [(0.032, 0.003)]]) * k, 0.0012 * k, 0.0026 * k)
    ribs = [box(0.0012, 0.006 * k, 0.0008).move((-0.02 + 0.004 * n) * k, 0, 0.004 * k - 0.0002)
            for n in range(9)]  # fmt: skip
    return shape([(handle, metal), (blade, textures.plain((214, 217, 222))),
                  (join(ribs), textures.plain((110, 112, 118)))],
                 [hull_of(handle), hull_of(blade)])  # fmt: skip


def kidney_dish(look: Look) -> Shape:
    """A kidney-shaped steel dish, open."""
    k = look.between(0.88, 1.06)
    metal = _steel(look)
    t = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    x, y = 0.11 * np.cos(t), 0.052 * np.sin(t)
    outline = np.column_stack([x, y + 0.05 * (1 - (x / 0.075) ** 2) * 0.5]) * k
    outline -= (outline.max(0) + outline.min(0)) / 2
    h, w = 0.034 * k, 0.003
    rings = []
    for f, z in ((0.0, 0.0), (0.82, 0.0), (0.9, 0.006), (1.0, h), (0.965, h), (0.87, 0.008),
                 (0.8, w), (0.0, w)):  # fmt: skip
        rings.append(np.column_stack([outline * f, np.full(40, z)]))
    body = loft(np.stack(rings), None, profile=np.array([(0, 0), (0.05, 0), (0.06, 0.006),
                (0.07, h), (0.068, h), (0.058, 0.008), (0.05, w), (0, w)]))  # fmt: skip
    n, parts = 10, []
    for m in range(n):
        index = np.arange(m * 4, m * 4 + 5) % 40
        low, high = outline[index], outline[index]
        corners = [np.column_stack([f * p, np.full(5, z)]) for f, p, z in (
            (0.9, low, 0.0005), (0.8, low, 0.0005), (1.0, high, h), (0.955, high, h))]  # fmt: skip
        parts.append(hull_of(Solid(np.concatenate(corners), np.zeros((0, 3), int),
                                   np.zeros((20, 2)))))  # fmt: skip
    for a, b in ((0, 14), (13, 27), (26, 41)):
        index = np.arange(a, b) % 40
        floor = outline[index] * 0.82
        points = np.concatenate([np.column_stack([floor, np.full(len(floor), z)]) for z in (0, w)])
        parts.append(hull_of(Solid(points, np.zeros((0, 3), int), np.zeros((len(points), 2)))))
    return shape([(body, metal)], parts)


def inhaler(look: Look) -> Shape:
    """An asthma inhaler lying on its side: a canister in a bent holder."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "blue", "purple", "orange", "teal", "brown")
    h = 0.024 * k
    boot = prism(np.array([(-0.016, 0.03), (-0.016, -0.026), (-0.008, -0.03), (0.014, -0.03),
                           (0.045, -0.036), (0.05, -0.018), (0.016, -0.006), (0.016, 0.03)]) * k,
                 0, h)  # fmt: skip
    can = cylinder(0.0105 * k, 0.042 * k, 22, bevel=0.002).turn(0, -np.pi / 2)
    can = can.move(y=0.012 * k, z=h / 2)
    cap = (
        block(0.01 * k, 0.02 * k, 0.9 * h, 0.002)
        .turn(2, -0.25)
        .move(0.051 * k, -0.027 * k, 0.05 * h)
    )
    label = box(0.02 * k, 0.03 * k, 0.0006).move(y=0.004 * k, z=h - 0.0002)
    sign = prints.canvas(40, 60, (244, 244, 240))
    prints.lines(sign, look.rng, (0.1, 0.2, 0.8, 0.6), 5, tint_color(color, 0.7))
    return shape([(boot, look.surface(color, "plastic")), (can, textures.brushed_metal(
                  look.rng, STEEL)), (cap, textures.plain(tint_color(color, 0.6))), (label, sign)],
                 [box_part(0.032 * k, 0.06 * k, h, (0, 0, 0)),
                  hull_of(prism(np.array([(0.0, -0.03), (0.045, -0.036), (0.05, -0.018),
                                          (0.0, -0.004)]) * k, 0, h)), hull_of(can)])  # fmt: skip


def face_mask(look: Look) -> Shape:
    """A pleated face mask lying, its ear loops at its sides."""
    k = look.between(0.92, 1.05)
    color = look.color("blue", "sky", "white", "black", "mint", "pink")
    tone = tint_color(color, 1.3) if sum(color) < 380 and color[2] > 90 else color
    x, y = 0.17 * k, 0.095 * k
    image = textures.fit(textures.fabric(look.rng, tone), 96, 128).copy()
    for v in (0.22, 0.42, 0.62, 0.8):
        prints.fill(image, 0, v, 1, 0.03, tint_color(tone, 0.75))
    for v in (0.0, 0.95):
        prints.fill(image, 0, v, 1, 0.05, tint_color(tone, 0.85))
    levels = [(-0.5, 0.003), (-0.28, 0.008), (0.0, 0.011), (0.28, 0.008), (0.5, 0.003)]
    rings = [np.array([(-x / 2, v * y, 0), (x / 2, v * y, 0), (0.34 * x, v * y, z),
                       (-0.34 * x, v * y, z)]) for v, z in levels]  # fmt: skip
    body = loft(np.stack(rings)[::-1], rectangle(1, 1),
                profile=np.array([(v, 0) for v, _ in levels[::-1]]))  # fmt: skip
    top = body.vertices
    uv = np.column_stack([top[:, 0] / x + 0.5, top[:, 1] / y + 0.5])
    body = Solid(body.vertices, body.faces, np.clip(uv, 0, 1))
    loops = [tube(smooth([(s * 0.49 * x, 0.42 * y, 0.002), (s * 0.66 * x, 0.3 * y, 0.002),
                          (s * 0.69 * x, -0.1 * y, 0.002), (s * 0.49 * x, -0.42 * y, 0.002)], 5),
                  0.0013, 6) for s in (-1, 1)]  # fmt: skip
    return shape([(body, image), (join(loops), textures.plain((244, 244, 242)))],
                 [hull_of(body)])  # fmt: skip


def glove_box(look: Look) -> Shape:
    """A box of disposable gloves, one sticking out."""
    k = look.between(0.9, 1.05)
    color = look.color("blue", "purple", "white", "green", "teal")
    x, y, h = 0.22 * k, 0.12 * k, 0.07 * k
    image = prints.canvas(176, 96, (244, 244, 242))
    prints.fill(image, 0, 0, 1, 0.34, color)
    prints.write(image, "GLOVES", 0.3, 0.18, 0.22, readable_on(color), bold=True)
    prints.disc(image, 0.62, 0.56, 0.27, (120, 124, 130))
    prints.disc(image, 0.62, 0.56, 0.24, (40, 44, 52))
    side = prints.canvas(176, 56, color)
    prints.write(side, look.pick(["NITRILE GLOVES", "100 GLOVES", "EXAM GLOVES"]), 0.5, 0.5, 0.3,
                 readable_on(color), bold=True)  # fmt: skip
    glove = look.own_color("sky", "white", "violet", "mint")
    at = np.array([0.12 * x, -0.06 * y, h])
    fingers = [tube(np.array([np.add(at, (0.004 * n, 0, -0.004)),
        np.add(at, (0.006 * n, 0.004, 0.016)),
                              np.add(at, (0.011 * n, 0.006, 0.03))]) ,
                                  np.array([0.0075, 0.007, 0.0045]), 8)
               for n in (-2, -0.6, 0.7, 2)]  # fmt: skip
    return shape([(box(x, y, h), side), (box(x, y, 0.0006).move(z=h - 0.0003), image),
                  (join(fingers), textures.plain(glove))],
                 [box_part(x, y, h), hull_of(*fingers)])  # fmt: skip


def reflex_hammer(look: Look) -> Shape:
    """A reflex hammer lying: a rubber triangle on a slim handle."""
    k = look.between(0.9, 1.08)
    color = look.color("terracotta", "black", "green", "blue", "orange")
    z = 0.008 * k
    head = prism(np.array([(0.075, -0.03), (0.1, 0.0), (0.075, 0.03), (0.068, 0.0)]) * k, 0, 2 * z)
    head = prism(np.array([(0.066, -0.012), (0.098, -0.026), (0.102, 0.0), (0.098, 0.026),
                           (0.066, 0.012)]) * k, 0, 2 * z, 0.003)  # fmt: skip
    rod = lay_down(cylinder(0.0028 * k, 0.1 * k, 12), -0.03 * k, z)
    grip = lay_down(lathe(np.array([(0, 0), (0.005, 0), (0.006, 0.01), (0.0045, 0.07), (0,
        0.072)]) * k,
                      16), -0.1 * k, z)  # fmt: skip
    lean = np.arctan2(z - 0.006 * k, 0.16 * k)
    solids = [s.move(x=-0.08 * k, z=-z).turn(1, -lean).move(x=0.08 * k, z=z)
              for s in (head, rod, grip)]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s in solids)
    head, rod, grip = (s.move(z=-low) for s in solids)
    return shape([(head, textures.speckles(look.rng, color, 5, 32)),
                  (join([rod, grip]), textures.brushed_metal(look.rng, STEEL))],
                 [flat_foot(head.vertices, 0.1), hull_of(rod), hull_of(grip)])  # fmt: skip


def forehead_thermometer(look: Look) -> Shape:
    """An infrared thermometer lying on its side: pistol grip, screen, lens."""
    k = look.between(0.9, 1.05)
    color = look.color("white", "white", "sky", "gray", "mint")
    accent = look.own_color("blue", "teal", "green", "purple", "orange")
    h = 0.036 * k
    top = prism(np.array([(-0.04, 0.02), (-0.046, -0.012), (-0.02, -0.02), (0.045, -0.014),
                          (0.055, -0.006), (0.055, 0.016), (0.045, 0.024), (-0.03, 0.028)]) * k,
                0, h, 0.004)  # fmt: skip
    grip = prism(np.array([(-0.038, -0.008), (-0.052, -0.095), (-0.022, -0.102), (-0.002, -0.008)])
                 * k, 0.08 * h, 0.92 * h, 0.003)  # fmt: skip
    lens = lay_down(cylinder(0.0125 * k, 0.008 * k, 20), 0.052 * k, h / 2).move(y=0.005 * k)
    trigger = box(0.012 * k, 0.02 * k, 0.5 * h).move(-0.004 * k, -0.028 * k, 0.25 * h)
    shown = prints.canvas(64, 40, (130, 210, 150))
    prints.write(shown, f"{look.between(36.2, 38.4):.1f}", 0.5, 0.5, 0.6, (20, 40, 26), bold=True)
    screen = box(0.032 * k, 0.02 * k, 0.0008).move(-0.012 * k, 0.006 * k, h - 0.0004)
    return shape([(join([top, grip]), look.surface(color, "plastic")), (lens, textures.plain(
                  (50, 50, 56))), (trigger, textures.plain(accent)), (screen, shown)],
                 [hull_of(top), hull_of(grip), hull_of(lens)])  # fmt: skip


def oximeter(look: Look) -> Shape:
    """A pulse oximeter lying: a clip with a lit screen."""
    k = look.between(0.95, 1.1)
    color = look.color("white", "blue", "black", "gray", "pink")
    x, y = 0.06 * k, 0.034 * k
    halves = [block(x, y, 0.0155 * k, 0.009, 0.004).move(z=z) for z in (0, 0.0165 * k)]
    shown = prints.canvas(96, 56, (16, 18, 24))
    prints.write(
        shown, str(int(look.rng.integers(95, 100))), 0.3, 0.45, 0.5, (80, 220, 240), bold=True
    )
    prints.write(shown, str(int(look.rng.integers(58, 90))), 0.75, 0.45, 0.4, (240, 210, 80))
    screen = box(0.6 * x, 0.66 * y, 0.0008).move(x=0.04 * x, z=0.032 * k - 0.0004)
    knob = cylinder(0.004 * k, 0.0012, 14).move(x=-0.36 * x, z=0.032 * k - 0.0003)
    mid = box(0.7 * x, 0.8 * y, 0.002).move(x=-0.1 * x, z=0.015 * k)
    return shape([(join(halves), look.surface(color, "plastic")), (screen, shown),
                  (join([knob, mid]), textures.plain((96, 98, 104)))],
                 [box_part(x, y, 0.032 * k)])  # fmt: skip


CATEGORIES = (
    Category("scalpel", scalpel, (0.149, 0.0115, 0.0046), 0.02, ("surgical knife",
             "lancet", "surgical scalpel",
             "scalpel blade", "dental probe", "dental scaler", "lino cutter", "cuticle pusher"),
             ("medical",), ("flat",), ("silver",), None,
             "lying flat"),
    Category("kidney_dish", kidney_dish, (0.213, 0.12, 0.033), 0.15, ("emesis basin",
             "kidney bowl", "kidney tray", "instrument tray", "surgical tray", "medical tray"),
             ("medical",), ("container", "big"), ("silver",)),
    Category("inhaler", inhaler, (0.0736, 0.0911, 0.0243), 0.04, ("asthma inhaler", "puffer",
             "asthma spray"), ("medical",), (), ("blue",)),
    Category("face_mask", face_mask, (0.228, 0.093, 0.011), 0.005, ("surgical mask",
             "medical mask", "dust mask", "facemask", "disposable mask",
             "cpr mask"),
             ("medical",), ("flat",), ("blue", "white"), 0.6),
    Category("glove_box", glove_box, (0.215, 0.117, 0.099), 0.3, ("box of gloves",
             "box of disposable gloves", "box of latex gloves", "glove dispenser"), ("medical",),
                 ("big",),
             ("blue",)),
    Category("reflex_hammer", reflex_hammer, (0.2, 0.052, 0.018), 0.08, ("neurological hammer",
             "tendon hammer", "medical hammer"), ("medical",), (), ("terracotta",), None,
             "lying flat"),
    Category("forehead_thermometer", forehead_thermometer, (0.11, 0.128, 0.035), 0.12,
             ("infrared thermometer", "thermometer gun", "ir thermometer", "ear thermometer",
             "temperature gun", "contactless thermometer", "non contact thermometer"),
             ("medical",), (), ("white",), None, "lying flat"),
    Category("oximeter", oximeter, (0.0615, 0.035, 0.033), 0.05, ("pulse oximeter",
             "finger oximeter", "pulse meter"), ("medical",), (),
             ("white", "blue")),
)  # fmt: skip
"""The module's categories."""
