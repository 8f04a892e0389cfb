"""Objects of the ``medical`` theme: instruments."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, rounded_polygon, smooth
from ...kit.parts import box_part, flat_foot, hull_of, hull_part
from ...kit.primitives import lay_down
from ...kit.shapes import Shape, category, shape
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
    tube,
)
from ...kit.surfaces import RGB, Look, tint_color


@category("stethoscope", size=(0.36, 0.16, 0.024), mass=0.15, material="rubber", assembled=True,
          aliases=("doctor stethoscope",), themes=("medical",), roles=("big",),
          colors=("black", "blue"), state="lying flat")  # fmt: skip
def stethoscope(look: Look) -> Shape:
    """A stethoscope lying flat: two ear tubes on the left, a loop of tubing and a chest piece."""
    k = look.between(0.85, 1.05)
    color = look.color("black", "blue", "red", "teal", "maroon", "navy", "green", "purple")
    rubber = surfaces.plain(color)
    steel = surfaces.brushed_metal(look.rng, look.own_color("silver", "silver", "gold"))
    r = 0.0052 * k
    arms, tips = [], []
    for s in (-1, 1):
        path = (smooth([(-0.03, s * 0.008, 0.006), (-0.09, s * 0.034, 0.006),
                        (-0.15, s * 0.042, 0.006), (-0.185, s * 0.026, 0.006)], 5) * k)  # fmt: skip
        arms.append(tube(path, 0.0031 * k, 8))
        tips.append(
            ellipsoid(0.017 * k, 0.012 * k, 0.012 * k, 12, 8).move(
                -0.188 * k, s * 0.024 * k, 0.006 * k
            )
        )
    fork = [tube(smooth([(0.03, 0, r / k), (0.0, s * 0.004, r / k), (-0.035, s * 0.0095, r / k),
                         (-0.06, s * 0.02, r / k)], 4) * k, 0.0048 * k, 8)
            for s in (-1, 1)]  # fmt: skip
    bend = (smooth([(0.028, 0, r / k), (0.1, 0.0, r / k), (0.16, 0.03, r / k), (0.15, 0.085, r / k),
                    (0.08, 0.1, r / k), (0.02, 0.085, r / k), (-0.03, 0.09, r / k)], 6)
            * k)  # fmt: skip
    hose = tube(bend, r, 9)
    chest = lathe([(0, 0), (0.021, 0), (0.0225, 0.003), (0.0225, 0.006), (0.012, 0.01),
                   (0.0085, 0.016), (0.012, 0.02), (0.016, 0.0215), (0.016, 0.024), (0, 0.024)],
                  28).scale(k, k, k)  # fmt: skip
    chest = chest.move(-0.055 * k, 0.092 * k)
    stem = tube([(-0.03 * k, 0.09 * k, 0.006 * k), (-0.05 * k, 0.092 * k, 0.012 * k)], 0.004 * k, 8)
    disc = cylinder(0.0145 * k, 0.0006, 24).move(-0.055 * k, 0.092 * k, 0.0238 * k)
    parts = [hull_of(chest), *(hull_of(a, t) for a, t in zip(arms, tips, strict=True)),
             hull_of(*fork)]  # fmt: skip
    step = 6
    for n in range(0, len(bend) - 1, step):
        near = bend[n : n + step + 1]
        points = np.concatenate([near + np.array([dx, dy, z]) for dx in (-0.7 * r, 0.7 * r)
                                 for dy in (-0.7 * r, 0.7 * r)
                                 for z in (-0.98 * r, 0.8 * r)])  # fmt: skip
        parts.append(hull_part(points))
    return shape([(join([*arms, chest, stem]), steel), (join([*fork, hose]), rubber),
                  (join(tips), surfaces.plain((60, 60, 64))),
                  (disc, surfaces.plain((236, 236, 232)))], parts)  # fmt: skip


@category("blood_pressure_monitor", size=(0.228, 0.119, 0.0784), mass=0.45, material="device",
          aliases=("blood pressure cuff", "blood pressure meter", "sphygmomanometer",
          "blood pressure gauge", "blood pressure machine", "bp monitor"), themes=("medical",),
          roles=("big",), colors=("white",))  # fmt: skip
def blood_pressure_monitor(look: Look) -> Shape:
    """A blood pressure monitor with a sloped display, a button and a hose to its rolled cuff."""
    x, y, h = look.between(0.115, 0.14), look.between(0.1, 0.12), look.between(0.05, 0.065)
    color = look.color("white", "white", "gray", "sky", "charcoal", "silver")
    body = loft(np.stack([np.column_stack([rectangle(1, 1, 0.14, 4) * [a, b] + [0, d],
                                           np.full(20, z)]) for a, b, d,
                          z in ((x, y, 0, 0), (x, y, 0, 0.018), (0.94 * x, 0.6 * y, 0.16 * y, h))]),
                rectangle(1, 1, 0.14, 4))  # fmt: skip
    lean = np.arctan2(h - 0.018, 0.36 * y)
    face = prints.canvas(112, 72, (168, 184, 160))
    for row, value in enumerate(
        (look.rng.integers(110, 140), look.rng.integers(68, 90), look.rng.integers(58, 90))
    ):
        prints.write(face, str(int(value)), 0.62, 0.2 + 0.3 * row, 0.24, (34, 40, 36), bold=True)
        prints.fill(face, 0.1, 0.16 + 0.3 * row, 0.16, 0.06, (80, 92, 80))
    panel = box(0.66 * x, 0.4 * y, 0.003).turn(0, lean)
    panel = panel.move(-0.1 * x, -0.3 * y - 0.0015 * np.sin(lean), 0.5 * (h + 0.018) - 0.0005)
    button = (cylinder(0.013, 0.006, 22, bevel=0.001).turn(0, lean).move(0.36 * x, -0.3 * y, 0.5
                                                                         * (h
                                                                            + 0.018)))  # fmt: skip
    blue = surfaces.plain(look.own_color("blue", "green", "orange", "navy"))
    cloth = surfaces.fabric(look.rng, look.own_color("navy", "gray", "charcoal", "blue"))
    r = look.between(0.036, 0.044)
    a = np.linspace(0, 3.4 * np.pi, 40)
    away = r * (1 - 0.06 * a / np.pi)
    inner = np.column_stack([away * np.cos(a), away * np.sin(a)])
    cuff = sweep(
        np.column_stack([inner[:, 0], np.zeros(40), inner[:, 1]]), rectangle(0.004, 0.1, 0.0015, 1)
    )
    cuff = cuff.move(x=x / 2 + 0.065, z=-float(cuff.bounds[0, 2]))
    hose = tube(smooth([(x / 2 - 0.004, 0.1 * y, 0.012), (x / 2 + 0.015, -0.3 * y, 0.005),
                        (x / 2 + 0.05, -0.55 * y, 0.005), (x / 2 + 0.065, -0.48 * y, 0.006)], 4),
                0.0032, 8)  # fmt: skip
    shell = surfaces.speckles(look.rng, color, 3, 32)
    return shape([(body, shell), (panel, face), (button, blue), (cuff, cloth),
                  (hose, surfaces.plain((150, 152, 156)))],
                 [hull_of(body), flat_foot(cuff.vertices, 0.1)])  # fmt: skip


@category("syringe", size=(0.165, 0.043, 0.0195), mass=0.012, material="plastic",
          aliases=("injection", "hypodermic needle", "medical syringe", "needle syringe",
          "solder sucker", "desoldering pump", "butterfly needle", "cannula", "epipen",
          "amalgam gun"), themes=("medical", "lab"), roles=("flat",), colors=("sky", "orange"),
          state="lying flat", common=True)  # fmt: skip
def syringe(look: Look) -> Shape:
    """A syringe lying with its tip on the left: a scale, a plunger, wings and a needle or cap."""
    r, long = look.between(0.0075, 0.012), look.between(0.068, 0.086)
    color = look.color("sky", "orange", "green", "pink", "purple", "blue", "yellow")
    pull, filled = look.between(0.2, 0.55), look.chance(0.6)
    fluid = look.own_color("cream", "red", "sky", "amber", "mint") if filled else (222, 230, 234)
    clear = (226, 233, 236)
    barrel = prints.canvas(96, 128, clear)
    prints.fill(barrel, 0, 0, 1, 1 - pull, tint_color(fluid, 1.1))
    prints.fill(barrel, 0, 1 - pull, 1, 0.09, (46, 46, 50))
    for k in range(21):
        wide = 0.22 if k % 5 == 0 else 0.12
        prints.fill(barrel, 0.26, 0.05 + 0.042 * k, wide, 0.011, (30, 44, 70))

    def lay(height: float, radius: float, x: float, top: float | None = None) -> Solid:
        solid = cylinder(radius, height, 16, top=top).turn(1, -np.pi / 2)
        return solid.move(x + height, 0, r)

    plain, dark = surfaces.plain((236, 240, 242)), surfaces.plain(color)
    body = lay(long, r, 0)
    wings = block(0.0028, 4.4 * r, 1.3 * r, 0.0012).move(long, 0, 0.35 * r)
    rod = long * (0.2 + pull)
    cross = [box(rod, 0.0022, 1.3 * r).move(long + rod / 2, 0, 0.35 * r),
             box(rod, 1.3 * r, 0.0022).move(long + rod / 2, 0, r - 0.0011)]  # fmt: skip
    thumb = lay(0.003, 0.95 * r, long + rod)
    nose = lay(0.006, 0.32 * r, -0.006)
    hub = lay(0.011, 0.28 * r, -0.015, 0.45 * r)
    capped = look.chance(0.4)
    reach = 0.036 if capped else 0.032
    tip = lay(reach, 0.3 * r if capped else 0.0005, -0.012 - reach, 0.42 * r if capped else 0.0005)
    grip = dark if look.chance(0.5) else plain
    pieces = [(body, barrel), (join([wings, nose]), plain), (join(cross), grip), (thumb, grip),
              (hub, dark), (tip, dark if capped else surfaces.plain((176, 180, 186)))]  # fmt: skip
    needle = box_part(reach + 0.012, 0.5 * r, 0.5 * r, (-(reach + 0.012) / 2, 0, 0.75 * r))
    return shape(
        pieces,
        [box_part(long, 1.5 * r, 2 * r, (long / 2, 0, 0)), hull_of(wings), needle,
         box_part(rod, 1.3 * r, 1.3 * r, (long + rod / 2, 0, 0.35 * r)), hull_of(thumb)],
    )  # fmt: skip


@category("thermometer", size=(0.126, 0.0195, 0.0125), mass=0.015, material="plastic",
          aliases=("digital thermometer", "medical thermometer", "fever thermometer",
          "clinical thermometer", "clinical digital thermometer", "depth sounder",
          "galileo thermometer", "barometer tube"), themes=("medical",), roles=("flat",),
          colors=("white", "sky"), state="lying flat", common=True)  # fmt: skip
def thermometer(look: Look) -> Shape:
    """A digital fever thermometer with a slim tip on the left, a display and a button."""
    k, wide = look.between(0.92, 1.08), look.between(0.008, 0.0115)
    color = look.color("white", "white", "sky", "mint", "pink", "teal", "yellow")
    accent = look.own_color("blue", "teal", "pink", "orange", "green", "gray", "violet")
    neck = look.between(-0.025, -0.005)
    half = np.array([(-0.05, -0.0028), (neck, -0.0035), (neck + 0.02, -wide), (0.07, -wide)])
    corners = np.concatenate([half, half[::-1] * [1, -1]]) * [k, 1]
    high = look.between(0.0095, 0.012)
    skin = surfaces.speckles(look.rng, color, 3, 32)
    low = prism(rounded_polygon(corners[[0, 3, 4, 7]], 0.0022), 0.002, 0.6 * high, 0.001)
    grip = np.array([(neck, -0.004), (neck + 0.02, -wide), (0.07, -wide), (0.07, wide),
                     (neck + 0.02, wide), (neck, 0.004)]) * [k, 1]  # fmt: skip
    body = prism(rounded_polygon(grip, 0.0025), 0, high, 0.002)
    metal = cylinder(0.0026, 0.012, 12, top=0.0022, bevel=0.0008).turn(1, -np.pi / 2)
    metal = metal.move(-0.048 * k, 0, 0.002 + 0.3 * high)
    lit = look.pick(
        [(176, 196, 172), (196, 204, 196), (120, 214, 140), (240, 170, 90), (34, 40, 52)]
    )
    face = prints.canvas(96, 40, lit)
    ink = (34, 38, 40) if sum(lit) > 300 else (220, 240, 250)
    prints.write(face, look.pick(["36.6", "37.2", "38.5", "39.1", "36.9", "98.6"]), 0.46, 0.5, 0.62,
                 ink, bold=True)  # fmt: skip
    start = neck + 0.024
    bezel = block(0.036 * k, 1.5 * wide, 0.0012, 0.002).move((start + 0.016) * k, 0, high - 4e-4)
    screen = box(0.028 * k, 1.1 * wide, 0.0006).move((start + 0.016) * k, 0, high + 7e-4)
    knob = cylinder(0.5 * wide, 0.0022, 20, bevel=6e-4).move(0.058 * k, 0, high - 4e-4)
    if look.chance(0.5):
        knob = block(0.014, wide, 0.0022, 0.003, 6e-4).move(0.058 * k, 0, high - 4e-4)
    trim = surfaces.plain(accent)
    pieces = [(low, skin), (body, skin), (metal, surfaces.plain((186, 190, 196))), (bezel, trim),
              (screen, face), (knob, trim)]  # fmt: skip
    return shape(pieces, [hull_of(body), hull_of(low), hull_of(metal)])


STEEL: RGB = (186, 189, 194)


def _steel(look: Look) -> surfaces.Tile:
    return look.surface(look.color("silver", "silver", "gray"), "metal")


@category("scalpel", size=(0.149, 0.0115, 0.0046), mass=0.02, material="metal",
          aliases=("surgical knife", "lancet", "surgical scalpel", "scalpel blade", "dental probe",
          "dental scaler", "lino cutter", "cuticle pusher"), themes=("medical",), roles=("flat",),
          colors=("silver",), state="lying flat")  # fmt: skip
def scalpel(look: Look) -> Shape:
    """A scalpel lying flat: a flat handle and a small curved blade."""
    k = look.between(0.92, 1.08)
    metal = _steel(look)
    handle = prism(np.array([(-0.075, -0.003), (0.02, -0.0045), (0.035, -0.002), (0.035, 0.002),
                             (0.02, 0.0045), (-0.075, 0.004)]) * k, 0, 0.004 * k)  # fmt: skip
    edge = smooth([(0.032, -0.003), (0.055, -0.0065), (0.069, -0.003), (0.074, 0.0035)], 4)
    blade = prism(np.concatenate([edge, [(0.032, 0.003)]]) * k, 0.0012 * k, 0.0026 * k)
    ribs = [box(0.0012, 0.006 * k, 0.0008).move((-0.02 + 0.004 * n) * k, 0, 0.004 * k - 0.0002)
            for n in range(9)]  # fmt: skip
    return shape([(handle, metal), (blade, surfaces.plain((214, 217, 222))),
                  (join(ribs), surfaces.plain((110, 112, 118)))],
                 [hull_of(handle), hull_of(blade)])  # fmt: skip


@category("kidney_dish", size=(0.213, 0.12, 0.033), mass=0.15, material="metal", hollow=True,
          aliases=("emesis basin", "kidney bowl", "kidney tray", "instrument tray", "surgical tray",
          "medical tray"), themes=("medical",), roles=("container", "big"),
          colors=("silver",))  # fmt: skip
def kidney_dish(look: Look) -> Shape:
    """An open, kidney-shaped steel dish."""
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


@category("reflex_hammer", size=(0.2, 0.052, 0.018), mass=0.08, material="plastic", assembled=True,
          aliases=("neurological hammer", "tendon hammer", "medical hammer"), themes=("medical",),
          colors=("terracotta",), state="lying flat")  # fmt: skip
def reflex_hammer(look: Look) -> Shape:
    """A reflex hammer lying flat: a rubber triangle on a slim handle."""
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
    return shape([(head, surfaces.speckles(look.rng, color, 5, 32)),
                  (join([rod, grip]), surfaces.brushed_metal(look.rng, STEEL))],
                 [flat_foot(head.vertices, 0.1), hull_of(rod), hull_of(grip)])  # fmt: skip


@category("forehead_thermometer", size=(0.11, 0.128, 0.035), mass=0.12, material="device",
          aliases=("infrared thermometer", "thermometer gun", "ir thermometer", "ear thermometer",
          "temperature gun", "contactless thermometer", "non contact thermometer"),
          themes=("medical",), colors=("white",), state="lying flat")  # fmt: skip
def forehead_thermometer(look: Look) -> Shape:
    """An infrared thermometer lying on its side: a pistol grip, a screen and a lens."""
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
    return shape([(join([top, grip]), look.surface(color, "plastic")), (lens, surfaces.plain(
                  (50, 50, 56))), (trigger, surfaces.plain(accent)), (screen, shown)],
                 [hull_of(top), hull_of(grip), hull_of(lens)])  # fmt: skip


@category("oximeter", size=(0.0615, 0.035, 0.033), mass=0.05, material="plastic",
          aliases=("pulse oximeter", "finger oximeter", "pulse meter"), themes=("medical",),
          colors=("white", "blue"))  # fmt: skip
def oximeter(look: Look) -> Shape:
    """A pulse oximeter lying flat: a clip with a lit screen."""
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
                  (join([knob, mid]), surfaces.plain((96, 98, 104)))],
                 [box_part(x, y, 0.032 * k)])  # fmt: skip
