"""Objects of the ``kitchen`` theme: appliances."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part, ring_parts
from ...kit.primitives import facing, limb, lobe, pad, side_view
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import (
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
from ...kit.surfaces import RGB, Look, Tile, readable_on, tint_color
from ..coffee.brewers import _spout, _steel
from .grills import _panel, griddle, turn_knob


@category("kitchen_timer", size=(0.0679, 0.0618, 0.0714), mass=0.1, material="plastic",
          assembled=True, aliases=("egg timer", "cooking timer"), themes=("kitchen",),
          colors=("red", "white"))  # fmt: skip
def kitchen_timer(look: Look) -> Shape:
    """A kitchen timer: a round dial on a stand, or a twist timer shaped like an egg or a tomato."""
    d = look.between(0.06, 0.072)
    color = look.color("red", "white", "yellow", "sky", "orange", "mint", "black", "silver")
    skin = look.surface(color, "plastic")
    marks = prints.canvas(128, 128, (248, 246, 240))
    prints.disc(marks, 0.5, 0.5, 0.48, (40, 40, 44), 0.46)
    for k in range(12):
        a = k * np.pi / 6
        prints.stroke(marks, [(0.5 + 0.36 * np.sin(a), 0.5 - 0.36 * np.cos(a)),
                              (0.5 + 0.44 * np.sin(a), 0.5 - 0.44 * np.cos(a))], 0.02,
                      (30, 30, 34))  # fmt: skip
    for k, word in enumerate(("0", "15", "30", "45")):
        a = k * np.pi / 2
        spot = (0.5 + 0.29 * np.sin(a), 0.5 - 0.29 * np.cos(a))
        prints.write(marks, word, *spot, 0.1, (30, 30, 34), bold=True)
    if look.chance(0.55):
        body = facing(cylinder(d / 2, 0.03, 36, bevel=0.005)).move(y=0.015, z=0.5 * d + 0.004)
        face = facing(cylinder(0.43 * d, 0.001, 36)).move(y=-0.0145, z=0.5 * d + 0.004)
        knob = facing(cylinder(0.16 * d, 0.012, 22, bevel=0.002)).move(y=-0.0155, z=0.5 * d + 0.004)
        mark = box(0.0024, 0.001, 0.14 * d).move(0, -0.0278, 0.5 * d + 0.006)
        foot = block(0.6 * d, 0.036, 0.012, 0.006)
        return shape([(join([body, foot]), skin), (face, marks), (knob, skin),
                      (mark, surfaces.plain((250, 250, 250)))],
                     [hull_of(body), box_part(0.6 * d, 0.036, 0.012), hull_of(knob)])  # fmt: skip
    low = lathe([(0, 0), (0.3 * d, 0), (0.46 * d, 0.2 * d), (0.5 * d, 0.44 * d), (0, 0.44 * d)], 32)
    ring = lathe([(0.4 * d, 0.43 * d), (0.505 * d, 0.43 * d), (0.495 * d, 0.56 * d),
                  (0.4 * d, 0.56 * d)], 32, v=[0, 0.02, 0.98, 1], loop=True)  # fmt: skip
    high = lathe([(0, 0.55 * d), (0.485 * d, 0.55 * d), (0.42 * d, 0.78 * d), (0.24 * d, 0.98 * d),
                  (0, 1.06 * d)], 32)  # fmt: skip
    scale = prints.canvas(256, 24, (248, 246, 240))
    for k in range(24):
        prints.fill(scale, k / 24, 0.0, 0.006, 0.5 if k % 2 else 0.9, (40, 40, 44))
    return shape([(join([low, high]), skin), (ring, scale)], [hull_of(low, high)])


BODY = ("black", "silver", "white", "red", "cream", "mint", "charcoal")
DARK = (36, 37, 40)


@category("air_fryer", size=(0.273, 0.331, 0.307), mass=4.5, material="device",
          aliases=("airfryer",), themes=("kitchen",), roles=("big", "tall"),
          colors=("black",))  # fmt: skip
def air_fryer(look: Look) -> Shape:
    """An egg-shaped air fryer with a drawer, a handle and a display."""
    x, h = look.between(0.25, 0.28), look.between(0.29, 0.33)
    color = look.color("black", "black", "white", "charcoal", "red", "silver", "cream")
    skin = look.surface(color, "plastic")
    body = lathe([(0, 0), (0.44, 0), (0.49, 0.08), (0.5, 0.4), (0.46, 0.76), (0.36, 0.95),
                  (0.2, 1), (0, 1)], 36).scale(x, x, h)  # fmt: skip
    seam = torus(0.498 * x, 0.0035, 40, 6).move(z=0.5 * h)
    low = block(0.42 * x, 0.02, 0.4 * h, 0.008).move(y=-0.49 * x, z=0.07 * h)
    grip = tube(smooth([(0, -0.48 * x, 0.42 * h), (0, -0.66 * x, 0.42 * h), (0, -0.68 * x, 0.3 * h),
                        (0, -0.68 * x, 0.2 * h)], 4), 0.013, 10)  # fmt: skip
    panel = prints.canvas(96, 80, DARK)
    prints.write(panel, look.pick(["180", "200", "15:00"]), 0.5, 0.35, 0.32, (120, 220, 240))
    for k in range(4):
        prints.disc(panel, 0.2 + 0.2 * k, 0.74, 0.07, (90, 94, 100))
    lean = 0.16
    screen = facing(block(0.09, 0.075, 0.012, 0.008)).turn(0, -lean)
    screen = screen.move(y=-0.452 * x, z=0.68 * h)
    trim = surfaces.plain(tint_color(color, 0.6) if sum(color) > 250 else (96, 98, 102))
    return shape([(body, skin), (join([seam, low, grip]), trim), (screen, panel)],
                 [hull_of(body), hull_of(low), hull_of(grip)])  # fmt: skip


@category("slow_cooker", size=(0.387, 0.262, 0.227), mass=4.5, material="device",
          aliases=("crockpot", "crock pot", "pressure cooker", "multicooker", "instant pot"),
          themes=("kitchen",), roles=("big",), colors=("silver", "red"))  # fmt: skip
def slow_cooker(look: Look) -> Shape:
    """An oval slow cooker with a glass lid, two handles and a dial."""
    x, h = look.between(0.3, 0.34), look.between(0.15, 0.18)
    color = look.color("silver", "red", "black", "white", "silver", "cream")
    skin = look.surface(color, "metal")
    y = 0.76
    pot = lathe([(0, 0.03), (0.42, 0.03), (0.5, 0.14), (0.5, 0.92), (0.52, 0.96), (0.52, 1),
                 (0, 1)], 40).scale(x, y * x, h)  # fmt: skip
    foot = lathe([(0, 0), (0.38, 0), (0.38, 0.05), (0, 0.05)], 36).scale(x, y * x, h)
    lid = lathe([(0, 1), (0.49, 1), (0.46, 1.06), (0.2, 1.2), (0, 1.22)], 40).scale(x, y * x, h)
    knob = lathe([(0, 0), (0.01, 0), (0.01, 0.01), (0.024, 0.014), (0.02, 0.026), (0, 0.028)],
                 22).move(z=1.21 * h)  # fmt: skip
    ears = [box(0.04, 0.09, 0.018).move(s * (x / 2 + 0.014), 0, 0.72 * h) for s in (-1, 1)]
    dial = facing(cylinder(0.021, 0.018, 24, bevel=0.002)).move(y=-y * x / 2 + 0.004, z=0.36 * h)
    mark = box(0.0035, 0.001, 0.016).move(0, -y * x / 2 - 0.0146, 0.36 * h)
    dark = surfaces.plain(DARK)
    return shape([(pot, skin), (lid, surfaces.plain((176, 190, 196))),
                  (join([foot, knob, *ears, dial]), dark), (mark, surfaces.plain((240, 240, 240)))],
                 [hull_of(foot), hull_of(pot), hull_of(lid), hull_of(knob),
                  *(hull_of(e) for e in ears)])  # fmt: skip


@category("toaster_oven", size=(0.403, 0.307, 0.234), mass=5.5, material="device",
          aliases=("mini oven", "oven", "countertop oven", "tabletop oven"), themes=("kitchen",),
          roles=("big",), colors=("black", "silver"))  # fmt: skip
def toaster_oven(look: Look) -> Shape:
    """A small oven with a glass door, a bar handle and knobs on the right."""
    x, y, h = look.between(0.38, 0.44), look.between(0.25, 0.29), look.between(0.22, 0.25)
    color = look.color(*BODY)
    skin = look.surface(color, "metal")
    body = block(x, y, h - 0.014, 0.012, 0.003).move(z=0.014)
    feet = [cylinder(0.014, 0.015, 14).move(a * 0.43 * x, b * 0.4 * y) for a in (-1, 1)
            for b in (-1, 1)]  # fmt: skip
    glow = prints.canvas(160, 112, (44, 40, 40))
    prints.fill(glow, 0.06, 0.08, 0.88, 0.84, (92, 62, 44))
    for k in range(3):
        prints.fill(
            glow, 0.08, 0.2 + 0.3 * k, 0.84, 0.03, (214, 120, 60) if k != 1 else (160, 160, 160)
        )
    door = box(0.68 * x, 0.01, 0.78 * h).move(-0.13 * x, -y / 2 - 0.003, 0.12 * h)
    pane = box(0.6 * x, 0.001, 0.58 * h).move(-0.13 * x, -y / 2 - 0.0085, 0.16 * h)
    bar = tube([(-0.42 * x, -y / 2 - 0.032, 0.82 * h), (0.16 * x, -y / 2 - 0.032, 0.82 * h)],
               0.007, 10)  # fmt: skip
    arms = [box(0.01, 0.034, 0.01).move(u * x, -y / 2 - 0.017, 0.8 * h) for u in (-0.4, 0.14)]
    knobs = [facing(cylinder(0.019, 0.02, 22, bevel=0.002)).move(0.36 * x, -y / 2, z * h)
             for z in (0.25, 0.5, 0.76)]  # fmt: skip
    marks = [box(0.003, 0.001, 0.015).move(0.36 * x, -y / 2 - 0.0204, z * h + 0.002)
             for z in (0.25, 0.5, 0.76)]  # fmt: skip
    dark = surfaces.plain(DARK if sum(color) > 200 else (104, 106, 110))
    return shape([(body, skin), (join([*feet, door]), dark), (pane, glow),
                  (join([bar, *arms]), _steel(look)), (join(knobs), dark),
                  (join(marks), surfaces.plain((240, 240, 240)))],
                 [hull_of(body), box_part(0.9 * x, 0.85 * y, 0.015), hull_of(door), hull_of(bar),
                  hull_of(*knobs)])  # fmt: skip


@category("food_processor", size=(0.248, 0.207, 0.369), mass=3.5, material="device",
          aliases=("kitchen machine", "food chopper"), themes=("kitchen",), roles=("big", "tall"),
          colors=("black", "white"))  # fmt: skip
def food_processor(look: Look) -> Shape:
    """A food processor: a clear bowl with a handle and a feed tube on a motor base."""
    x, h = look.between(0.19, 0.22), look.between(0.34, 0.39)
    color = look.color(*BODY)
    skin = look.surface(color, "plastic")
    base = block(x, 0.95 * x, 0.32 * h, 0.04, 0.008)
    r = 0.42 * x
    bowl = cylinder(0.94 * r, 0.4 * h, 34, top=r).move(z=0.33 * h)
    lid = lathe([(0, 0.73 * h), (1.05 * r, 0.73 * h), (1.03 * r, 0.78 * h), (0, 0.82 * h)], 34)
    feed = block(0.36 * r, 0.62 * r, 0.2 * h, 0.02).move(0.3 * r, 0, 0.79 * h)
    ear = tube(smooth([(0.95 * r, 0, 0.7 * h), (1.55 * r, 0, 0.68 * h), (1.55 * r, 0, 0.42 * h),
                       (0.9 * r, 0, 0.38 * h)], 4), 0.011, 10)  # fmt: skip
    hub = cylinder(0.18 * r, 0.3 * h, 16).move(z=0.33 * h)
    dial = facing(cylinder(0.024, 0.016, 24, bevel=0.003)).move(y=-0.475 * x, z=0.16 * h)
    food = look.pick([(214, 222, 226), (214, 222, 226), (150, 180, 90), (226, 150, 70)])
    tile = surfaces.stack((surfaces.plain(food), 45), (surfaces.plain((214, 224, 228)), 55))
    dark = surfaces.plain(DARK if sum(color) > 200 else (120, 122, 126))
    return shape([(base, skin), (bowl, tile), (join([lid, feed, ear]), surfaces.plain(
        (190, 202, 208))), (join([hub, dial]), dark)],
        [hull_of(base), hull_of(bowl), hull_of(lid), hull_of(feed), hull_of(ear)])  # fmt: skip


@category("hand_mixer", size=(0.324, 0.078, 0.124), mass=0.9, material="device",
          aliases=("electric mixer", "electric whisk", "handheld mixer", "hand blender",
          "electric hand mixer"), themes=("kitchen",), colors=("white", "red"))  # fmt: skip
def hand_mixer(look: Look) -> Shape:
    """An electric hand mixer standing on its heel, with its beaters on the left."""
    long = look.between(0.17, 0.195)
    color = look.color("white", "red", "mint", "black", "cream", "sky", "pink")
    skin = look.surface(color, "plastic")
    side = smooth(np.array([(-0.5, 0.0), (0.42, 0.0), (0.5, 0.06), (0.48, 0.3), (0.42, 0.36),
                            (0.3, 0.3), (0.12, 0.28), (0.1, 0.44), (0.36, 0.47), (0.44, 0.52),
                            (0.4, 0.6), (0.1, 0.62), (-0.3, 0.56), (-0.52, 0.34), (-0.55, 0.12),
                            (-0.5, 0.0)]), 2)[:-1] * long  # fmt: skip
    body = side_view(side, 0.078)
    steel = _steel(look)
    rods, hoops = [], []
    for s in (-1, 1):
        y = 0.02 * s
        rods.append(tube([(-0.53 * long, y, 0.028), (-0.53 * long - 0.06, y, 0.026)], 0.003, 8))
        for a in (0, np.pi / 2):
            t = np.linspace(0, 2 * np.pi, 17)[:-1]
            path = np.column_stack([-0.53 * long - 0.09 + 0.036 * np.cos(t), 0.021 * np.sin(t),
                                    0 * t])  # fmt: skip
            hoop = tube(path, 0.0018, 6, loop=True).turn(0, a + np.pi / 4)
            hoops.append(hoop.move(y=y, z=0.018 + 0.003))
    switch = block(0.034, 0.02, 0.012, 0.006, 0.002).move(-0.1 * long, 0, 0.6 * long)
    dark = surfaces.plain(tint_color(color, 0.55))
    return settle([(body, skin), (join([*rods, *hoops]), steel), (switch, dark)], 0.01,
                  hulls=[[0], [1], [2]])  # fmt: skip


MICROWAVE_DARK: RGB = (40, 42, 46)
SHELLS = ("silver", "white", "black", "red", "cream", "mint", "sky")


def _time(look: Look) -> str:
    return f"{int(look.rng.integers(1, 13))}:{int(look.rng.integers(60)):02d}"


@category("microwave", size=(0.46, 0.37, 0.274), mass=11.0, material="device",
          aliases=("microwave oven", "countertop microwave"), themes=("kitchen",), roles=("big",),
          colors=("white", "silver"))  # fmt: skip
def microwave(look: Look) -> Shape:
    """A microwave oven with a dark window, a handle, and either a clock and keys or two dials."""
    x, y, h = look.between(0.42, 0.5), look.between(0.3, 0.36), look.between(0.24, 0.29)
    color = look.color(*SHELLS)
    shell = look.surface(color, "metal" if look.chance(0.3) else "plastic")
    face = prints.canvas(240, 144, tint_color(color, 0.92) if look.chance(0.5) else MICROWAVE_DARK)
    ground = tuple(float(c) for c in face[0, 0])
    prints.fill(face, 0.05, 0.12, 0.62, 0.76, (22, 23, 26))
    prints.fill(face, 0.1, 0.2, 0.52, 0.6, (58, 56, 54))
    prints.polygon(face, [(0.14, 0.8), (0.3, 0.2), (0.36, 0.2), (0.2, 0.8)], (84, 84, 84))
    prints.fill(face, 0.745, 0, 0.008, 1, tint_color(ground, 0.5))  # type: ignore[arg-type]
    prints.fill(face, 0.79, 0.08, 0.17, 0.14, (14, 24, 18))
    prints.write(face[:, 188:232], _time(look), 0.5, 0.15, 0.09, (120, 240, 150), bold=True)
    dials = look.chance(0.4)
    if not dials:
        for k in range(12):
            prints.fill(face, 0.785 + 0.062 * (k % 3), 0.3 + 0.12 * (k // 3), 0.05, 0.085,
                        (206, 208, 212) if sum(ground) < 300 else (96, 98, 104))  # fmt: skip
        prints.fill(face, 0.785, 0.82, 0.174, 0.1, (90, 190, 110))
    front = box(x, 0.008, h).move(y=-y / 2 - 0.004, z=0.008)
    grip = tube(smooth([(0.19 * x, -y / 2, 0.2 * h), (0.19 * x, -y / 2 - 0.035, 0.26 * h),
                        (0.19 * x, -y / 2 - 0.035, 0.86 * h), (0.19 * x, -y / 2, 0.92 * h)], 3),
                0.007, 8)  # fmt: skip
    feet = [cylinder(0.014, 0.01, 12).move(sx * 0.4 * x, sy * 0.38 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    pieces = [(box(x, y, h).move(z=0.008), shell), (front, face),
              (join(feet), surfaces.plain(MICROWAVE_DARK)),
              (grip, surfaces.brushed_metal(
                  look.rng, look.own_color("silver", "charcoal")))]  # fmt: skip
    if dials:
        knob = facing(cylinder(0.026, 0.02, 24, top=0.022, bevel=0.002))
        pieces += [(knob.move(0.375 * x, -y / 2 - 0.007, z * h), surfaces.plain((200, 202, 206)))
                   for z in (0.28, 0.56)]  # fmt: skip
    return shape(pieces, [box_part(0.84 * x, 0.8 * y, 0.01), box_part(x, y + 0.008, h,
                                                                      (0, -0.004, 0.008)),
                          hull_of(grip)])  # fmt: skip


def _burner(look: Look, kind: str, r: float, z: float) -> list[tuple[Solid, surfaces.Tile]]:
    """Return a burner of radius ``r`` with its underside at height ``z``."""
    dark = surfaces.plain((34, 35, 38))
    if kind == "coil":
        hot = look.pick([(52, 50, 50), (52, 50, 50), (206, 62, 34)])
        bowl = cylinder(1.08 * r, 0.003, 32).move(z=z)
        coils = join([torus(r * k, 0.0055, 30, 8).move(z=z + 0.007) for k in (0.3, 0.6, 0.92)])
        return [(bowl, surfaces.brushed_metal(look.rng, (186, 188, 192))),
                (coils, surfaces.plain(hot))]  # fmt: skip
    if kind == "gas":
        cap = [cylinder(0.46 * r, 0.01, 26, bevel=0.002), cylinder(0.3 * r, 0.016, 26, bevel=0.002)]
        bars = [box(2.1 * r, 0.008, 0.009).turn(2, a).move(z=0.018) for a in (0, np.pi / 2)]
        posts = [box(0.008, 0.008, 0.02).move(1.02 * r * c, 1.02 * r * s)
                 for c, s in ((1, 0), (-1, 0), (0, 1), (0, -1))]  # fmt: skip
        ring = torus(0.86 * r, 0.004, 30, 6).move(z=0.022)
        return [(join(cap).move(z=z), surfaces.plain((70, 72, 78))),
                (join([*bars, *posts, ring]).move(z=z), dark)]  # fmt: skip
    disc = cylinder(r, 0.012, 34, bevel=0.002).move(z=z)
    mark = torus(0.55 * r, 0.0012, 30, 5).move(z=z + 0.0115)
    iron = surfaces.speckles(look.rng, (44, 44, 48), 4)
    return [(disc, iron), (mark, surfaces.plain((90, 90, 90)))]


@category("stove", size=(0.385, 0.316, 0.0865), mass=2.6, material="device", aliases=("hot plate",
          "hotplate", "portable stove", "flat stove", "toy stove", "cooktop", "hob",
          "electric stove", "gas stove", "cooker", "camping stove", "stovetop", "plate warmer",
          "burner", "hot plate stirrer", "magnetic stirrer", "hotplate stirrer"),
          themes=("kitchen",), roles=("big", "support"), colors=("white", "silver"))  # fmt: skip
def stove(look: Look) -> Shape:
    """A table-top stove with one or two burners and knobs in front."""
    count, kind = look.pick([1, 1, 2]), look.pick(["plate", "plate", "coil", "gas"])
    r = look.between(0.08, 0.095)
    x, y, h = 0.3 if count == 1 else 0.47, look.between(0.28, 0.31), look.between(0.06, 0.08)
    color = look.color("white", "silver", "black", "cream", "red", "charcoal")
    skin = look.surface(color, "metal")
    body = block(x, y, h - 0.01, 0.016, 0.005).move(z=0.01)
    feet = [cylinder(0.013, 0.012, 12).move(sx * 0.4 * x, sy * 0.4 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    pieces = [(body, skin), (join(feet), surfaces.plain(MICROWAVE_DARK))]
    at = [0.0] if count == 1 else [-0.115, 0.115]
    burners = [(solid.move(x=u, y=0.025), tile) for u in at
               for solid, tile in _burner(look, kind, r, h - 0.001)]  # fmt: skip
    knob = facing(join([cylinder(0.021, 0.018, 22, bevel=0.002),
                          box(0.008, 0.034, 0.026)]))  # fmt: skip
    ink = surfaces.plain(
        look.pick([MICROWAVE_DARK, MICROWAVE_DARK, (206, 208, 212), (196, 42, 40)])
    )
    if sum(color) < 200:
        ink = surfaces.plain((206, 208, 212))
    knobs = [knob.move(u if count == 2 else 0.2 * x, -y / 2, 0.5 * h) for u in at]
    lamp = box(0.012, 0.002, 0.006).move(-0.2 * x if count == 1 else 0, -y / 2, 0.5 * h)
    pieces += [*burners, (join(knobs), ink), (lamp, surfaces.plain((220, 60, 40)))]
    plates = [hull_of(*(s for s, _ in burners[2 * k : 2 * k + 2])) for k in range(count)]
    return shape(pieces, [box_part(0.84 * x, 0.84 * y, 0.012), hull_of(body), *plates,
                          *(hull_of(k) for k in knobs)])  # fmt: skip


@category("blender", size=(0.213, 0.181, 0.374), mass=2.4, material="device",
          aliases=("smoothie maker", "mixer jug", "smoothie blender"), themes=("kitchen",),
          roles=("tall", "big"), colors=("silver", "black"))  # fmt: skip
def blender(look: Look) -> Shape:
    """A blender: a motor base with buttons or a dial, and a lidded jug with a scale and a grip."""
    r, h = look.between(0.068, 0.078), look.between(0.34, 0.4)
    color = look.color("silver", "black", "red", "white", "cream", "mint", "charcoal")
    skin, dark = (look.surface(color, look.pick(["metal", "plastic"])),
                  surfaces.plain(MICROWAVE_DARK))  # fmt: skip
    z = 0.36 * h
    sides = look.pick([28, 28, 4])
    grow = 1.12 if sides == 4 else 1.0
    base = lathe([(0, 0), (1.1 * r * grow, 0), (1.1 * r * grow, 0.02), (0.84 * r * grow, 0.82 * z),
                  (0.7 * r * grow, z), (0, z)], sides)  # fmt: skip
    jug = lathe([(0, z), (0.66 * r, z), (0.7 * r, z + 0.02), (r, 0.9 * h), (0, 0.9 * h)], 26,
                v=[0, 0.01, 0.05, 0.99, 1])  # fmt: skip
    clear, juice = (206, 218, 222), look.own_color("pink", "orange", "green", "purple", "red")
    glass = prints.canvas(128, 128, clear)
    if look.chance(0.55):
        prints.fill(glass, 0, look.between(0.25, 0.6), 1, 1, juice)
    for k in range(7):
        prints.fill(glass, 0.5, 0.2 + 0.1 * k, 0.04 if k % 2 else 0.07, 0.014, (250, 250, 250))
    lid = lathe([(0, 0.9 * h), (1.02 * r, 0.9 * h), (1.0 * r, 0.945 * h), (0.42 * r, 0.95 * h),
                 (0.4 * r, h), (0, h)], 26)  # fmt: skip
    ear = tube(smooth([(0.9 * r, 0, 0.86 * h), (1.6 * r, 0, 0.84 * h), (1.56 * r, 0, 0.56 * h),
                       (0.76 * r, 0, 0.47 * h)], 4), 0.01, 8)  # fmt: skip
    front = facing(block(0.9 * r, 0.34 * z, 0.03, 0.006, 0.002)).move(y=-0.97 * r, z=0.36 * z)
    panel = prints.canvas(96, 48, MICROWAVE_DARK)
    for k in range(4):
        prints.disc(panel, 0.17 + 0.22 * k, 0.5, 0.17, (214, 216, 220) if k else (220, 60, 50))
    ring = torus(0.69 * r, 0.004, 28, 6).move(z=z)
    turn = 0.0 if sides == 28 else np.pi / 4
    return shape(
        [(base.turn(2, turn), skin), (jug, glass), (join([lid, ear, ring]), dark),
         (front, panel)],
        [hull_of(base.turn(2, turn)), hull_of(jug), hull_of(lid),
         box_part(0.7 * r, 0.02, 0.36 * h, (1.27 * r, 0, 0.48 * h))],
    )  # fmt: skip


@category("rice_cooker", size=(0.299, 0.265, 0.222), mass=2.2, material="device",
          aliases=("multi cooker", "electric steamer", "food steamer", "vegetable steamer"),
          themes=("kitchen",), roles=("big",), colors=("white", "red"))  # fmt: skip
def rice_cooker(look: Look) -> Shape:
    """A rice cooker: a bulbous pot with a domed lid, a carrying handle and a switch in front."""
    r, h = look.between(0.115, 0.135), look.between(0.17, 0.2)
    color = look.color("white", "white", "red", "silver", "black", "pink", "mint", "cream")
    skin = look.surface(color, "plastic")
    trim = surfaces.plain(look.own_color("silver", "charcoal", "gold", "gray"))
    body = lathe([(0, 0), (0.8 * r, 0), (0.93 * r, 0.08 * h), (r, 0.4 * h), (0.97 * r, 0.74 * h),
                  (0, 0.74 * h)], 32)  # fmt: skip
    band = torus(0.965 * r, 0.005, 34, 6).move(z=0.74 * h)
    lid = lathe([(0, 0.745 * h), (0.96 * r, 0.745 * h), (0.9 * r, 0.86 * h), (0.6 * r, 0.97 * h),
                 (0, h)], 32)  # fmt: skip
    vent = cylinder(0.014, 0.012, 16, bevel=0.002).move(y=0.4 * r, z=0.94 * h)
    a = np.linspace(0.12, np.pi - 0.12, 13)
    bail = tube(np.column_stack([1.04 * r * np.cos(a), np.full(13, 0.1 * r), 0.66 * h + 0.5 * h
                                 * np.sin(a)]), 0.008, 8, squash=0.6)  # fmt: skip
    if look.chance(0.4):
        bail = tube([(-0.045, 0, 0.985 * h), (-0.04, 0, 1.1 * h), (0.04, 0, 1.1 * h),
                     (0.045, 0, 0.985 * h)], 0.008, 8)  # fmt: skip
    panel = prints.canvas(96, 72, (232, 232, 230) if sum(color) < 560 else (72, 76, 84))
    ink = readable_on(tuple(float(c) for c in panel[0, 0]))  # type: ignore[arg-type]
    prints.write(panel, look.pick(["COOK", "RICE", "WARM"]), 0.5, 0.22, 0.2, ink, bold=True)
    prints.disc(panel, 0.3, 0.55, 0.1, (240, 130, 40))
    prints.disc(panel, 0.7, 0.55, 0.1, (90, 190, 110))
    prints.fill(panel, 0.3, 0.76, 0.4, 0.16, (196, 60, 50))
    front = facing(block(0.09, 0.075, 0.02, 0.012, 0.003)).move(y=-0.9 * r, z=0.34 * h)
    ears = [box(0.03, 0.06, 0.014).move(s * (r + 0.006), 0, 0.66 * h) for s in (-1, 1)]
    return shape(
        [(body, skin), (lid, skin), (join([band, bail]), trim), (front, panel),
         (join([vent, *ears]), surfaces.plain(MICROWAVE_DARK))],
        [hull_of(body), hull_of(lid), hull_of(front), *(hull_of(e) for e in ears)],
    )  # fmt: skip


@category("stand_mixer", size=(0.34, 0.21, 0.36), mass=7.0, material="device",
          aliases=("food mixer", "kitchen mixer", "mixer", "cake mixer"), themes=("kitchen",),
          roles=("tall", "big"), colors=("red", "mint"))  # fmt: skip
def stand_mixer(look: Look) -> Shape:
    """A stand mixer with its head on the left, above a steel bowl."""
    k = look.between(0.92, 1.08)
    color = look.color("red", "mint", "cream", "black", "silver", "pink", "sky", "white", "teal")
    skin, steel = look.surface(color, "plastic"), surfaces.brushed_metal(look.rng, (190, 193, 198))
    foot = block(0.33 * k, 0.2 * k, 0.035 * k, 0.06, 0.01)
    neck = block(0.09 * k, 0.11 * k, 0.24 * k, 0.03, 0.006).move(x=0.11 * k, z=0.02 * k)
    t = np.linspace(-1, 1, 15)
    wide = (1 - np.abs(t) ** 4) ** 0.4 * (0.9 - 0.12 * t)
    head = lathe([(max(w, 0.0), u) for w, u in zip(wide, t, strict=True)], 24)
    head = head.scale(0.062 * k, 0.066 * k, 0.17 * k).turn(1, np.pi / 2)
    head = head.move(x=-0.012 * k, z=0.3 * k)
    band = lathe([(0.2, -0.012), (0.98, -0.012), (0.98, 0.012), (0.2, 0.012)], 24, loop=True)
    band = band.scale(0.062 * k, 0.067 * k, 1).turn(1, np.pi / 2).move(x=-0.04 * k, z=0.3 * k)
    side = [(0.05 * k, 0), (0.085 * k, 0.03 * k), (0.1 * k, 0.08 * k), (0.105 * k, 0.125 * k)]
    inner = [(r - 0.003, max(z, 0.005)) for r, z in side[::-1]]
    bowl = lathe([(0, 0), *side, *inner, (0, 0.005)], 30).move(x=-0.07 * k, z=0.034 * k)
    shaft = cylinder(0.012 * k, 0.06 * k, 14).move(x=-0.07 * k, z=0.19 * k)
    beater = lathe(
        [(0, 0), (0.012, 0.004), (0.032, 0.05), (0.03, 0.07), (0.006, 0.1), (0, 0.1)], 16
    )
    beater = beater.scale(k, 0.3 * k, k).move(x=-0.07 * k, z=0.1 * k)
    lever = facing(cylinder(0.012, 0.02, 16, bevel=0.002)).move(0.05 * k, -0.06 * k, 0.29 * k)
    return shape(
        [(join([foot, neck, head]), skin), (join([bowl, shaft, band, beater]), steel),
         (lever, surfaces.plain(MICROWAVE_DARK))],
        [hull_of(foot), hull_of(neck), hull_of(head), hull_of(bowl)],
    )  # fmt: skip


@category("kitchen_scale", size=(0.176, 0.216, 0.0503), mass=0.6, material="device",
          aliases=("scale", "weighing scale", "digital scale", "food scale", "kitchen scales",
          "scales", "electronic scale"), themes=("kitchen",), roles=("support",),
          colors=("white", "black"))  # fmt: skip
def kitchen_scale(look: Look) -> Shape:
    """A flat digital kitchen scale, or one with a dial and a pan."""
    color = look.color("white", "black", "silver", "red", "mint", "sky", "cream")
    if look.chance(0.6):
        x, y, h = look.between(0.16, 0.18), look.between(0.2, 0.23), look.between(0.018, 0.026)
        face = prints.canvas(128, 160, color)
        prints.disc(face, 0.5, 0.4, 0.3, tint_color(color, 0.85), 0.285)
        prints.fill(face, 0.26, 0.78, 0.48, 0.14, (182, 198, 176))
        grams = f"{int(look.rng.integers(0, 999))} g"
        prints.write(face[:, 36:92], grams, 0.5, 0.855, 0.09, (36, 40, 36), bold=True)
        for u in (0.14, 0.86):
            prints.disc(face, u, 0.855, 0.04, tint_color(color, 0.6))
        body = block(x, y, h, 0.02, 0.003)
        top = block(x - 0.008, y - 0.008, 0.001, 0.018).move(z=h - 0.0004)
        plate = cylinder(0.42 * x, 0.008, 36, bevel=0.001).move(y=0.1 * y, z=h)
        steel = surfaces.brushed_metal(look.rng, (192, 194, 198))
        return shape(
            [(body, look.surface(color)), (top, face), (plate, steel)],
            [box_part(x, y, h), cylinder_part(0.42 * x, 0.008, (0, 0.1 * y, h))],
        )
    k = look.between(0.92, 1.08)
    body = lathe([(0, 0), (0.1 * k, 0), (0.1 * k, 0.02), (0.07 * k, 0.1 * k), (0.03 * k, 0.15 * k),
                  (0, 0.15 * k)], 4).turn(2, np.pi / 4)  # fmt: skip
    dial = facing(cylinder(0.048 * k, 0.02, 32, bevel=0.002)).turn(0, -0.26)
    dial = dial.move(y=-0.045 * k, z=0.068 * k)
    face = prints.clock_face(look.rng, (248, 248, 244), (40, 40, 44))
    pan = lathe([(0, 0), (0.06, 0), (0.1, 0.03), (0.097, 0.032), (0.058, 0.004), (0, 0.004)], 32)
    pan = pan.scale(k, k, 1).move(z=0.149 * k)
    return shape(
        [
            (body, look.surface(color)),
            (dial, face),
            (pan, surfaces.brushed_metal(look.rng, (192, 194, 198))),
        ],
        [hull_of(body), hull_part(pan.vertices[pan.vertices[:, 2] < 0.17 * k])],
    )


@category("kettle", size=(0.21, 0.146, 0.21), mass=1.0, material="metal", hollow=True,
          aliases=("electric kettle", "tea kettle", "copper kettle"), themes=("kitchen",),
          roles=("tall",), colors=("silver", "black"), common=True)  # fmt: skip
def kettle(look: Look) -> Shape:
    """An electric kettle on its base, a gooseneck kettle, or a domed stove-top kettle."""
    kind = look.pick(["jug", "jug", "gooseneck", "dome"])
    color = look.color(
        "silver", "silver", "black", "red", "white", "cream", "sage", "teal", "copper"
    )
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = surfaces.speckles(look.rng, look.own_color("charcoal", "black", "brown"), 3, 32)
    r, h = look.between(0.066, 0.078), look.between(0.18, 0.215)
    if kind == "dome":
        return _stove_kettle(look, 1.12 * r, 0.62 * h, skin, dark)
    up = look.between(0.62, 0.9)
    body = lathe(
        [(0, 0.02), (r, 0.02), (1.02 * r, 0.04), (up * r, 0.92 * h), (0.94 * up * r, 0.96 * h),
         (0, 0.96 * h)], v=[0, 0.01, 0.05, 0.9, 0.95, 1],
    )  # fmt: skip
    tile = skin
    if look.chance(0.35):  # a glass window or a band
        band = surfaces.plain(look.pick([(150, 186, 200), (40, 40, 44), (200, 202, 206)]))
        tile = surfaces.stack((skin, 3), (band, look.pick([1, 4])), (skin, 4), side=96)
    base = cylinder(1.02 * r, 0.02, 32, bevel=0.003)
    lid = lathe([(0, 0.95 * h), (0.9 * up * r, 0.95 * h), (0.75 * up * r, 0.98 * h), (0, h)], 28)
    knob = cylinder(0.011, 0.014, 16, bevel=0.002).move(z=0.99 * h)
    if kind == "jug":
        beak = np.array([(-1.1, 0.0), (-0.6, -0.4), (-0.6, 0.4)]) * r * (up + 0.24)
        spout = prism(beak, 0.72 * h, 0.93 * h)
    else:
        path = smooth([(-0.9 * r, 0, 0.16 * h), (-1.5 * r, 0, 0.28 * h), (-1.5 * r, 0, 0.7 * h),
                       (-1.95 * r, 0, 0.9 * h)], 4)  # fmt: skip
        spout = tube(path, np.linspace(0.011, 0.006, len(path)), 10)
    start = up * r - 0.008
    grip = sweep(
        smooth([(start, 0, 0.9 * h), (1.35 * r, 0, 0.93 * h), (1.62 * r, 0, 0.7 * h),
                (1.5 * r, 0, 0.34 * h), (1.25 * r, 0, 0.26 * h)], 4),
        rectangle(0.024, 0.014, 0.005, 2),
    )  # fmt: skip
    return shape(
        [(body, tile), (base, dark), (lid, dark), (knob, dark), (spout, skin), (grip, dark)],
        [cylinder_part(1.02 * r, 0.02), hull_of(body), hull_of(lid, knob), hull_of(spout),
         box_part(0.024, 0.022, 0.5 * h, (1.5 * r, 0, 0.32 * h)),
         box_part(0.7 * r, 0.022, 0.016, (1.05 * r, 0, 0.87 * h))],
    )  # fmt: skip


def _stove_kettle(look: Look, r: float, h: float, skin: Tile, dark: Tile) -> Shape:
    """Return a wide stove-top kettle with a handle over its dome."""
    t = np.linspace(0, 1, 8)
    dome = np.column_stack([r * np.cos(1.25 * t**1.3), 0.012 + (h - 0.012) * t])
    body = lathe([(0, 0), (0.9 * r, 0), *dome, (0, h)], 32)
    lid = lathe([(0, h - 0.002), (0.36 * r, h - 0.002), (0.3 * r, h + 0.006), (0, h + 0.01)], 24)
    knob = ellipsoid(0.02, 0.02, 0.018, 14, 8).move(z=h + 0.016)
    spout = _spout((-0.8 * r, 0.42 * h), (-1.4 * r, 0.98 * h), 0.02, 0.011)
    curve = arc((0, 0), 1.0, 0.0, np.pi, 16)
    path = np.column_stack(
        [0.8 * r * curve[:, 0], 0 * curve[:, 0], 0.62 * h + 0.95 * h * curve[:, 1]]
    )
    bow = sweep(path, rectangle(0.02, 0.011, 0.004, 2))
    top = float(path[:, 2].max())
    return shape(
        [(body, skin), (lid, skin), (knob, dark), (spout, skin), (bow, dark)],
        [hull_of(body), hull_of(lid, knob), hull_of(spout),
         box_part(0.9 * r, 0.02, 0.013, (0, 0, top - 0.013)),
         *[box_part(0.012, 0.018, 0.5 * h, (s * 0.73 * r, 0, 0.7 * h)) for s in (-1, 1)]],
    )  # fmt: skip


@category("toaster", size=(0.285, 0.168, 0.2), mass=1.4, material="device", themes=("kitchen",),
          roles=("big",), colors=("silver", "red"), common=True)  # fmt: skip
def toaster(look: Look) -> Shape:
    """A rounded, boxy or sloping two-slot toaster with a lever at its right end."""
    x, y, h = look.between(0.25, 0.3), look.between(0.155, 0.18), look.between(0.165, 0.195)
    color = look.color(
        "silver", "silver", "red", "cream", "black", "mint", "sky", "white", "pink", "copper"
    )
    skin = look.surface(color, "metal" if look.chance(0.5) else "plastic")
    dark = surfaces.plain((40, 40, 43))
    radius = look.pick([0.012, 0.035, 0.06])
    side = prism(rectangle(y, h, radius, 5), 0, x).turn(1, np.pi / 2).turn(0, np.pi / 2)
    low, high = side.bounds
    body = side.move(*(-(low + high) / 2)).move(z=h / 2 + 0.008)
    feet = [box(0.03, 0.02, 0.012).move(sx * 0.38 * x, sy * 0.3 * y) for sx in (-1, 1)
            for sy in (-1, 1)]  # fmt: skip
    top, slot = h + 0.008, look.between(0.6, 0.74)
    slots = [box(slot * x, 0.024, 0.002).move(y=s * 0.024, z=top - 0.0008) for s in (-1, 1)]
    lever = box(0.014, 0.03, 0.012).move(x=x / 2 + 0.006, z=look.between(0.5, 0.75) * h)
    rail = box(0.001, 0.008, 0.5 * h).move(x=x / 2 + 0.0003, z=0.24 * h)
    dial = cylinder(0.013, 0.01, 18, bevel=0.002).turn(1, np.pi / 2).move(x=x / 2, z=0.2 * h)
    pieces = [(body, skin), *((s, dark) for s in (*feet, *slots, lever, rail, dial))]
    front = int(look.rng.integers(4))
    if front == 1:  # a band in another colour with a name
        sign = prints.canvas(256, 48, look.own_color("white", "black", "gold", "charcoal"))
        prints.write(sign, look.pick(["TOAST", "CRISPY", "RETRO", "DAILY"]), 0.5, 0.5, 0.5,
                     tint_color(color, 0.6))  # fmt: skip
        pieces.append((box(0.7 * x, 0.0016, 0.045).move(y=-y / 2, z=0.35 * h), sign))
    elif front == 2:  # ends in another colour
        caps = [box(0.02, 0.9 * y, 0.72 * h).move(s * (x / 2 - 0.009), 0, 0.012) for s in (-1, 1)]
        pieces += [(cap, dark) for cap in caps]
    elif front == 3:
        lines = [
            box(0.8 * x, 0.0016, 0.004).move(y=-y / 2, z=(0.3 + 0.1 * k) * h) for k in (0, 1, 2)
        ]
        pieces += [(line, surfaces.plain(tint_color(color, 0.6))) for line in lines]
    if look.chance(0.5):
        crust = surfaces.gradient((200, 150, 88), (232, 196, 140), look.rng)
        toast = block(0.1, 0.013, 0.05, 0.005, 0.002)
        pieces += [
            (toast.move(y=s * 0.024, z=top - 0.012), crust) for s in look.pick([(1,), (-1, 1)])
        ]
    return shape(pieces, [box_part(0.82 * x, 0.8 * y, 0.012), hull_of(body), hull_of(lever)])


STEEL: RGB = (190, 194, 200)


def metal(look: Look, color: RGB = STEEL) -> surfaces.Tile:
    """Return a tile of brushed metal."""
    return surfaces.brushed_metal(look.rng, color)


@category("mincer", size=(0.233, 0.118, 0.209), mass=1.6, material="metal", assembled=True,
          aliases=("meat grinder", "meat mincer", "hand mincer", "sausage maker"),
          themes=("kitchen",), roles=("tall",), colors=("silver",))  # fmt: skip
def mincer(look: Look) -> Shape:
    """A hand mincer: a funnel on a barrel, a plate with holes, a crank and a base."""
    k, color = look.between(0.88, 1.06), look.color("silver", "silver", "red", "white", "cream")
    foot = block(0.11, 0.09, 0.014, 0.02, 0.003)
    neck = lathe([(0, 0), (0.03, 0), (0.018, 0.04), (0.022, 0.1), (0, 0.1)], 18).move(z=0.01)
    barrel = (lathe([(0, 0), (0.03, 0), (0.033, 0.03), (0.042, 0.09), (0.042, 0.11), (0, 0.11)],
                    22).turn(1, -np.pi / 2).move(0.05, 0, 0.125))  # fmt: skip
    hopper = lathe([(0, 0.14), (0.022, 0.14), (0.026, 0.17), (0.06, 0.21), (0.058, 0.212),
                    (0.02, 0.172), (0, 0.172)], 24)  # fmt: skip
    plate = cylinder(0.036, 0.003, 22).turn(1, -np.pi / 2).move(-0.06, 0, 0.125)
    meat = [limb([(-0.062, 0.024 * np.cos(a), 0.125 + 0.024 * np.sin(a)),
                  (-0.076, 0.024 * np.cos(a), 0.118 + 0.024 * np.sin(a)),
                  (-0.082, 0.024 * np.cos(a), 0.1 + 0.018 * np.sin(a))], [0.005, 0.005, 0.004],
                  6) for a in np.arange(7) * 0.9]  # fmt: skip
    crank = tube([(0.05, 0, 0.125), (0.085, 0, 0.125), (0.09, 0, 0.05), (0.1, 0, 0.048)], 0.006, 8)
    grip = (lathe([(0, 0), (0.011, 0.003), (0.013, 0.05), (0, 0.055)],
                  14).turn(1, np.pi / 2).move(0.096, 0, 0.048))  # fmt: skip
    made = [(join([foot, neck, barrel, hopper]), look.surface(color, "metal")),
            (plate, prints.mesh_holes((200, 202, 206), (60, 60, 64), 7, 7)),
            (join(meat), surfaces.plain((206, 92, 84))),
            (crank, metal(look)), (grip, surfaces.wood(look.rng, (150, 96, 60)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(foot.scale(k, k, k)), hull_of(neck.scale(k, k, k)),
                        hull_of(barrel.scale(k, k, k)), hull_of(hopper.scale(k, k, k)),
                        hull_of(made[3][0], made[4][0])])  # fmt: skip


@category("meat_slicer", size=(0.277, 0.194, 0.23), mass=4.0, material="device",
          aliases=("food slicer", "bread slicer", "ham slicer", "deli slicer"), themes=("kitchen",),
          roles=("big",), colors=("silver",))  # fmt: skip
def meat_slicer(look: Look) -> Shape:
    """A meat slicer: a large, round blade on a motor block, and a sliding tray with a sausage."""
    k, color = look.between(0.88, 1.02), look.color("silver", "red", "white", "black")
    base = block(0.3, 0.18, 0.05, 0.03, 0.006)
    motor = block(0.1, 0.1, 0.1, 0.03, 0.01).move(0.08, 0.03, 0.045)
    blade = facing(cylinder(0.095, 0.003, 44)).move(0.02, -0.03, 0.145)
    hub = facing(cylinder(0.03, 0.012, 24)).move(0.02, -0.03, 0.145)
    guard = facing(torus(0.098, 0.006, 36, 7)).move(0.02, -0.026, 0.145)
    tray = box(0.13, 0.09, 0.008).turn(1, -0.12).move(-0.06, -0.075, 0.065)
    wall = box(0.008, 0.09, 0.07).move(-0.12, -0.075, 0.06)
    ham = cylinder(0.032, 0.08, 20).turn(0, np.pi / 2).move(-0.05, -0.04, 0.108)
    made = [(join([base, motor]), look.surface(color, "plastic")), (join([blade, tray, wall]),
        metal(look, (206, 210, 214))), (join([guard]), surfaces.plain((70, 72, 76))),
            (hub, surfaces.plain(tint_color(color, 0.8))),
            (ham, surfaces.spots(look.rng, (206, 100, 96), (240, 200, 190), 0.2))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(base.scale(k, k, k)), hull_of(motor.scale(k, k, k)),
                        hull_of(blade.scale(k, k, k)), hull_of(tray.scale(k, k, k),
                                                               wall.scale(k, k, k))])  # fmt: skip


SOUS_VIDE_STEEL: RGB = (190, 194, 200)
INK: RGB = (34, 36, 40)


@category("deep_fryer", size=(0.2, 0.345, 0.208), mass=2.8, material="device",
          aliases=("deep fat fryer", "chip fryer", "fryer", "chip pan"), themes=("kitchen",),
          roles=("big",), colors=("silver",))  # fmt: skip
def deep_fryer(look: Look) -> Shape:
    """A deep fryer: a steel box of oil with a wire basket on a long handle."""
    k, color = look.between(0.88, 1.05), look.color("silver", "black", "white", "red")
    x, y, h = 0.2 * k, 0.27 * k, 0.16 * k
    body = block(x, y, h, 0.02 * k, 0.004)
    rim = block(1.04 * x, 1.03 * y, 0.014, 0.022 * k).move(z=h - 0.006)
    oil = box(0.84 * x, 0.7 * y, 0.001).move(y=-0.06 * y, z=h + 0.008)
    bx, by = 0.72 * x, 0.56 * y
    wires = [box(0.0022, by, 0.0022).move(i * bx / 8, -0.06 * y, h + 0.012) for i in range(-4, 5)]
    wires += [
        box(bx, 0.0022, 0.0022).move(0, j * by / 8 - 0.06 * y, h + 0.012) for j in range(-4, 5)
    ]
    wires += [box(bx, 0.003, 0.02).move(0, s * by / 2 - 0.06 * y, h + 0.01) for s in (-1, 1)]
    wires += [box(0.003, by, 0.02).move(s * bx / 2, -0.06 * y, h + 0.01) for s in (-1, 1)]
    chips = [box(0.009, 0.04, 0.009).turn(2, 1.3 * n).move(bx * (0.3 * np.cos(2.4 * n)), by * 0.3
                                                           * np.sin(1.7 * n) - 0.06 * y, h + 0.013
                                                           + 0.003 * (n % 3))
             for n in range(14)]  # fmt: skip
    grip = limb([(0, -0.34 * y, h + 0.024), (0, -0.55 * y, h + 0.04), (0, -0.8 * y, h + 0.042)],
                [0.006, 0.01, 0.012], 8)  # fmt: skip
    box_ = block(0.6 * x, 0.06 * y, 0.5 * h, 0.01).move(y=0.5 * y, z=0.5 * h + 0.02)
    return shape([(body, look.surface(color, "steel" if color[0] > 150 else "plastic")),
                  (join([rim, box_]), surfaces.plain(INK)), (oil, surfaces.plain((206, 160, 60))),
                  (join(wires), surfaces.plain((214, 218, 222))), (join(chips),
                      surfaces.plain((240, 200, 100))), (grip, surfaces.plain((30, 30, 32))),
                  (turn_knob(0.016, 0, -0.5 * y, 0.3 * h), surfaces.plain((90, 94, 98)))],
                  [hull_of(body, rim), hull_of(box_), hull_of(grip)])  # fmt: skip


@category("vacuum_sealer", size=(0.367, 0.253, 0.0505), mass=1.6, material="device",
          aliases=("food sealer", "bag sealer", "vacuum packer"), themes=("kitchen",),
          roles=("big",), colors=("black",))  # fmt: skip
def vacuum_sealer(look: Look) -> Shape:
    """A vacuum sealer: a long, flat machine with a hinged lid, buttons and a bag in its slot."""
    k, color = look.between(0.9, 1.08), look.color("black", "silver", "white", "red")
    x, y, h = 0.37 * k, 0.13 * k, 0.05 * k
    low, lid = (
        block(x, y, 0.55 * h, 0.02 * k, 0.004),
        block(0.98 * x, 0.6 * y, 0.5 * h, 0.02 * k, 0.008).move(y=-0.12 * y, z=0.52 * h),
    )
    panel = box(0.4 * x, 0.26 * y, 0.002).move(y=0.33 * y, z=0.55 * h - 0.0006)
    bag = prism(rectangle(0.5 * x, 0.14 * k, 0.004), 0, 0.002).move(y=-y / 2 - 0.055 * k, z=0.001)
    meat = pad(0.36 * x, 0.1 * k, 0.018, 0.02).move(y=-y / 2 - 0.06 * k, z=0.002)
    return shape([(join([low, lid]), look.surface(color, "plastic")), (panel, _panel(look)),
                  (bag, surfaces.plain((226, 232, 236))), (meat, surfaces.plain((196, 92, 84)))],
                 [hull_of(low), hull_of(lid), hull_of(meat), hull_of(bag)])  # fmt: skip


@category("sous_vide", size=(0.313, 0.0717, 0.061), mass=0.9, material="device",
          aliases=("sous vide stick", "sous vide machine", "immersion circulator",
          "sous vide cooker"), themes=("kitchen",), colors=("black",), state="lying")  # fmt: skip
def sous_vide(look: Look) -> Shape:
    """A sous vide stick lying flat: a slotted steel tube with a clip and a round screen."""
    k, color = look.between(0.9, 1.08), look.color("black", "white", "gray", "teal")
    steel = cylinder(0.026, 0.18, 24, bevel=0.003).turn(1, np.pi / 2).move(-0.2, 0, 0.026)
    head = cylinder(0.03, 0.14, 26, bevel=0.008).turn(1, np.pi / 2).move(-0.03, 0, 0.03)
    clip = box(0.05, 0.014, 0.05).move(-0.02, 0.034, 0.004)
    slots = [box(0.04, 0.004, 0.003).turn(0, a).move(-0.17, 0.0255 * np.sin(-a), 0.026 + 0.0255
                                                     * np.cos(a))
             for a in (-0.8, -0.3, 0.3, 0.8)]  # fmt: skip
    screen = box(0.05, 0.028, 0.001).move(0.055, 0, 0.0594)
    made = [(steel, surfaces.brushed_metal(look.rng, SOUS_VIDE_STEEL)),
            (join([head, clip]), look.surface(color, "plastic")),
            (join(slots), surfaces.plain((50, 52, 56))), (screen, _panel(look))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    foot = box(0.2, 0.03, 0.02).scale(k, k, k)
    return shape(made, [hull_of(made[0][0], foot), hull_of(made[1][0])])


MINI_FRIDGE_STEEL: RGB = (190, 194, 200)
MINI_FRIDGE_INK: RGB = (34, 36, 40)


@category("mini_fridge", size=(0.211, 0.271, 0.32), mass=2.5, material="device",
          aliases=("small fridge", "desk fridge", "fridge", "tabletop fridge", "refrigerator",
          "drinks fridge", "minifridge", "toy fridge"), themes=("kitchen",), roles=("big",),
          colors=("white",))  # fmt: skip
def mini_fridge(look: Look) -> Shape:
    """A small table-top fridge: a rounded cabinet with a door, a handle and a badge."""
    k, color = (look.between(0.85, 1.05), look.color("white", "pink", "mint", "red", "black", "sky",
                                                     "cream"))  # fmt: skip
    x, y, h = 0.23 * k, 0.24 * k, 0.32 * k
    body, door = (
        block(x, y, h, 0.03 * k, 0.01).move(z=0.008),
        facing(prism(rectangle(x, h, 0.03 * k), 0, 0.03 * k, 0.0)).move(y=-y / 2, z=0.008 + h / 2),
    )
    grip = [box(0.012, 0.02, 0.1 * k).move(0.4 * x, -y / 2 - 0.045 * k, 0.45 * h)]
    feet = [cylinder(0.012, 0.01, 12).move(i * 0.38 * x, j * 0.38 * y, 0) for i in (-1, 1)
            for j in (-1, 1)]  # fmt: skip
    badge = box(0.07 * k, 0.001, 0.014).move(-0.2 * x, -y / 2 - 0.0305 * k, 0.88 * h)
    gap = box(0.98 * x, 0.003, 0.97 * h).move(0, -y / 2 + 0.001, 0.015)
    hold = tube([(-0.06 * k, 0, h), (-0.05 * k, 0, h + 0.02), (0.05 * k, 0, h + 0.02),
                 (0.06 * k, 0, h)], 0.007, 8)  # fmt: skip
    tile, pale = (
        look.surface(color, "plastic"),
        surfaces.speckles(look.rng, tint_color(color, 1.2), 2),
    )
    return shape([(body, tile), (door, pale), (gap, surfaces.plain((80, 84, 88))),
                  (join([*grip, badge, hold]), surfaces.brushed_metal(look.rng, MINI_FRIDGE_STEEL)),
                  (join(feet), surfaces.plain(MINI_FRIDGE_INK))],
                 [hull_of(body, *feet), hull_of(door), hull_of(hold)])  # fmt: skip


@category("chocolate_fountain", size=(0.228, 0.229, 0.316), mass=1.5, material="device",
          aliases=("chocolate fondue fountain", "fondue fountain"), themes=("kitchen",),
          roles=("round", "tall"), colors=("silver",))  # fmt: skip
def chocolate_fountain(look: Look) -> Shape:
    """A chocolate fountain: three tiers of flowing chocolate above a steel bowl on a base."""
    k, color = look.between(0.88, 1.08), look.color("silver", "black", "red", "gold")
    base = lathe([(0, 0), (0.09, 0), (0.1, 0.012), (0.085, 0.07), (0, 0.07)], 30)
    bowl = lathe([(0, 0.07), (0.06, 0.07), (0.115, 0.1), (0.118, 0.108), (0.108, 0.106),
                  (0.06, 0.082), (0, 0.082)], 34)  # fmt: skip
    pool = cylinder(0.1, 0.002, 30).move(z=0.098)
    tiers = []
    for z, r in ((0.16, 0.075), (0.22, 0.056), (0.275, 0.038)):
        skirt = lathe([(0, z - 0.04), (0.92 * r, z - 0.045), (1.03 * r, z - 0.006), (r, z + 0.004),
                       (0.3 * r, z + 0.016), (0, z + 0.016)], 30)  # fmt: skip
        tiers.append(lobe(skirt, 14, 0.05))
    tower = cylinder(0.018, 0.21, 16).move(z=0.09)
    crown = lathe([(0, 0.29), (0.02, 0.29), (0.024, 0.31), (0.008, 0.325), (0, 0.326)], 18)
    choc = surfaces.stripes([(92, 54, 34), (112, 68, 44)], 16, upright=True, side=64)
    made = [(base,
             look.surface(color, "steel" if color[0] > 150 and color[2] > 120 else "plastic")),
             (bowl, surfaces.brushed_metal(look.rng, MINI_FRIDGE_STEEL)),
            (join([pool, *tiers, tower, crown]), choc), (turn_knob(0.014, 0, -0.092, 0.036),
                                                         surfaces.plain((90, 94, 98)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0]), *[hull_of(t.scale(k, k, k))
                                                                    for t in tiers]])  # fmt: skip


EGG_COOKER_STEEL: RGB = (190, 194, 200)
EGG_COOKER_INK: RGB = (34, 36, 40)


def _stack(trays: int, r: float) -> tuple[list[Solid], list[Solid]]:
    rings = [lathe([(0, 0), (0.97 * r, 0), (r, 0.006), (r, 0.03), (0.96 * r, 0.034), (0, 0.034)],
                   24).move(z=0.06 + 0.036 * n) for n in range(trays)]  # fmt: skip
    slots = [torus(1.0 * r, 0.002, 28, 4).move(z=0.06 + 0.036 * n + 0.017) for n in range(trays)]
    return rings, slots


@category("food_dehydrator", size=(0.286, 0.294, 0.24), mass=2.0, material="device",
          aliases=("dehydrator", "fruit dryer", "food dryer"), themes=("kitchen",),
          roles=("big", "round"), colors=("white",))  # fmt: skip
def food_dehydrator(look: Look) -> Shape:
    """A food dehydrator: a round base with a dial below vented trays and a lid."""
    k, color = look.between(0.9, 1.05), look.color("white", "black", "gray", "cream")
    r, count = 0.14 * k, look.pick([4, 5, 5])
    base = lathe([(0, 0), (1.02 * r, 0), (1.06 * r, 0.02), (r, 0.06), (0, 0.06)], 32)
    rings, slots = _stack(count, r)
    top = 0.06 + 0.036 * count
    lid = lathe([(0, 0), (r, 0), (0.9 * r, 0.014), (0.3 * r, 0.018), (0, 0.018)], 32).move(z=top)
    vents = [box(0.36 * r, 0.006, 0.002).move(x=0.62 * r).turn(2, a).move(z=top + 0.0145)
             for a in np.arange(12) * np.pi / 6]  # fmt: skip
    tile = look.surface(color, "plastic")
    return shape([(join([base, lid]), tile), (join(rings), surfaces.speckles(look.rng,
        tint_color(color, 0.85 if sum(color) > 400 else 1.25), 4)),
                  (join([*slots, *vents, turn_knob(0.016, 0, -1.03 * r, 0.032)]),
                   surfaces.plain((60, 62, 66)))],
                   [hull_of(base), hull_of(*rings, lid)])  # fmt: skip


@category("egg_cooker", size=(0.171, 0.182, 0.138), mass=0.6, material="device",
          aliases=("egg boiler", "egg steamer", "electric egg cooker"), themes=("kitchen",),
          roles=("round",), colors=("white",))  # fmt: skip
def egg_cooker(look: Look) -> Shape:
    """An egg cooker: a round heated base, eggs on a tray and a clear dome with a knob."""
    k, color = (look.between(0.9, 1.1), look.color("white", "silver", "red", "yellow", "mint",
                                                   "black"))  # fmt: skip
    r = 0.085 * k
    base = lathe(
        [(0, 0), (0.85 * r, 0), (r, 0.012), (0.98 * r, 0.045), (0.9 * r, 0.05), (0, 0.05)], 32
    )
    eggs = [ellipsoid(0.042 * k, 0.042 * k, 0.055 * k, 14, 10).move(0.58 * r * np.cos(a), 0.58 * r
                                                                    * np.sin(a), 0.07 * k)
            for a in np.pi / 3 * np.arange(6)]  # fmt: skip
    eggs.append(ellipsoid(0.042 * k, 0.042 * k, 0.055 * k, 14, 10).move(z=0.07 * k))
    tray = cylinder(0.92 * r, 0.003, 28).move(z=0.05)
    hoop = [tube([(0.93 * r * np.cos(a), 0.93 * r * np.sin(a), 0.05), (0.8 * r * np.cos(a),
        0.8 * r * np.sin(a), 0.1 * k),
                  (0.04 * r * np.cos(a), 0.04 * r * np.sin(a), 0.12 * k)], 0.0022,
                  5) for a in np.pi / 3 * np.arange(6) + 0.5]  # fmt: skip
    knob = lathe([(0, 0.115 * k), (0.016, 0.118 * k), (0.012, 0.135 * k), (0, 0.138 * k)], 14)
    return shape([(base, look.surface(color, "plastic")),
                  (join(eggs), surfaces.speckles(look.rng, (236, 208, 176), 6)),
                  (tray, surfaces.plain(EGG_COOKER_STEEL)),
                  (join(hoop), surfaces.plain((206, 216, 220))),
                  (knob, surfaces.plain(EGG_COOKER_INK)),
                  (turn_knob(0.011, 0, -0.99 * r, 0.026), surfaces.plain((220, 70, 50)))],
                 [hull_of(base), hull_of(*eggs, knob)])  # fmt: skip


SAMOVAR_STEEL: RGB = (190, 194, 200)


def _urn(samovar: bool) -> Callable[[Look], Shape]:
    """Return the shape function of an urn with a tap: a bulbous samovar or a plain boiler."""

    def make(look: Look) -> Shape:
        k = look.between(0.88, 1.06)
        color = look.color(*(("gold", "brass", "silver", "red", "copper") if samovar
                             else ("silver", "silver", "black", "white")))  # fmt: skip
        if samovar:
            body = lathe([(0, 0), (0.075, 0), (0.07, 0.02), (0.035, 0.045), (0.035, 0.06),
                          (0.07, 0.09), (0.1, 0.19), (0.104, 0.25), (0.09, 0.27), (0.05, 0.285),
                          (0.05, 0.3),
                          (0.062, 0.312), (0, 0.312)], 34)  # fmt: skip
            top = lathe([(0, 0.31), (0.035, 0.31), (0.055, 0.335), (0.05, 0.365), (0.02, 0.38),
                         (0.008, 0.395), (0, 0.398)], 24)  # fmt: skip
            z = 0.12
        else:
            body = lathe(
                [(0, 0), (0.1, 0), (0.1, 0.02), (0.105, 0.03), (0.105, 0.29), (0, 0.29)], 34
            )
            top = lathe([(0, 0.285), (0.108, 0.285), (0.1, 0.305), (0.03, 0.315), (0.03, 0.33),
                         (0, 0.332)], 30)  # fmt: skip
            z = 0.07
        tap = [tube([(0, -0.07, z), (0, -0.14, z), (0, -0.145, z - 0.025)], 0.008, 9),
               cylinder(0.011, 0.02, 12).move(0, -0.125, z - 0.004),
               box(0.034, 0.008, 0.007).move(0, -0.125, z + 0.018)]  # fmt: skip
        grips = [tube(smooth([(s * 0.095, 0, 0.2), (s * 0.13, 0, 0.21), (s * 0.13, 0, 0.245),
                              (s * 0.095, 0, 0.25)], 4), 0.007, 8) for s in (-1, 1)]  # fmt: skip
        dark = surfaces.plain((44, 36, 32))
        made = [(join([body, top]), look.surface(color, "brass" if samovar else "steel")),
                (join(tap[:2]), metal(look, (206, 172, 96) if samovar else SAMOVAR_STEEL)),
                (join([tap[2], *grips]), dark)]  # fmt: skip
        made = [(s.scale(k, k, k), t) for s, t in made]
        return shape(
            made,
            [
                hull_of(body.scale(k, k, k)),
                hull_of(top.scale(k, k, k)),
                hull_of(*[t.scale(k, k, k) for t in tap]),
                *[hull_of(g.scale(k, k, k)) for g in grips],
            ],
        )

    return make


@category("tea_warmer", size=(0.133, 0.131, 0.054), mass=0.4, material="ceramic",
          aliases=("teapot warmer", "teapot stand", "rechaud"), themes=("kitchen",),
          roles=("round", "support"), colors=("white",))  # fmt: skip
def tea_warmer(look: Look) -> Shape:
    """A tea warmer: a perforated ring for a pot, with a tea light inside."""
    k, color = look.between(0.88, 1.1), look.color("white", "black", "teal", "silver", "terracotta")
    wall = lathe([(0.058, 0), (0.066, 0), (0.068, 0.05), (0.06, 0.056), (0.05, 0.056),
                  (0.058, 0.046)], 34, loop=True)  # fmt: skip
    floor, candle = (cylinder(0.06, 0.004, 30), lathe([(0, 0.004), (0.019, 0.004), (0.019, 0.018),
                                                       (0, 0.018)], 18))  # fmt: skip
    flame = ellipsoid(0.006, 0.006, 0.014, 8, 6).move(z=0.026)
    holes = [facing(cylinder(0.009, 0.002, 14)).move(y=-0.0662, z=0.026).turn(2, a)
             for a in np.arange(9) * 0.698]  # fmt: skip
    made = [(join([wall, floor]), look.surface(color, "ceramic")),
            (candle, surfaces.plain((246, 242, 230))), (flame, surfaces.plain((255, 190, 70))),
            (join(holes), surfaces.plain((52, 40, 34)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [*ring_parts([(0.062 * k, 0), (0.067 * k, 0.05 * k), (0.062 * k, 0.056 * k)],
                                    [(0.05 * k, 0.056 * k), (0.057 * k, 0.0)], 12),
                        hull_of(floor.scale(k, k, k))])  # fmt: skip


CATEGORIES = (
    Category("samovar", _urn(True), size=(0.271, 0.246, 0.381), mass=3.0, material="metal",
             aliases=("tea urn", "russian samovar"), themes=("kitchen",), roles=("tall", "big"),
             colors=("gold",)),
    Category("hot_water_urn", _urn(False), size=(0.282, 0.26, 0.331), mass=2.5, material="metal",
             aliases=("water urn", "coffee urn", "water boiler", "catering urn", "hot drinks urn"),
             themes=("kitchen",), roles=("tall", "big"), colors=("silver",)),
    Category("sandwich_toaster", griddle(False, 0.25, 1.2), size=(0.254, 0.294, 0.223), mass=1.5,
             material="device", aliases=("toastie maker", "sandwich maker", "sandwich press",
             "doughnut maker", "donut maker", "cake pop maker"), themes=("kitchen",),
             roles=("big",), colors=("black", "silver")),
)  # fmt: skip
"""Objects that share their drawing functions."""
