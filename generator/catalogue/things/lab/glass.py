"""Laboratory ware: tubes, cylinders, funnels, burners, stands, models."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, resting_ball, ring_parts
from ...build.forms import above
from ...build.hollow import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    open_box,
    prism,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

LIQUIDS = ("blue", "teal", "amber", "pink", "green", "violet", "coral", "red")
GLASS: RGB = (206, 222, 226)
STEEL: RGB = (186, 189, 194)


def _lay(solid: Solid, x: float, z: float) -> Solid:
    return solid.turn(1, np.pi / 2).move(x=x, z=z)


def _marks(ground: RGB, count: int = 10) -> textures.Tile:
    image = prints.canvas(96, 128, ground)
    for n in range(count):
        prints.fill(image, 0.44, 0.12 + 0.76 * n / count, 0.12 if n % 2 else 0.07, 0.012,
                    (60, 84, 100))  # fmt: skip
    return image


def test_tube(look: Look) -> Shape:
    """One stoppered test tube lying, liquid in it."""
    k = look.between(0.9, 1.1)
    color = look.color(*LIQUIDS)
    r, long = 0.009 * k, 0.13 * k
    a = np.linspace(-np.pi / 2, 0, 6)
    bottom = [(r * np.cos(t), r + r * np.sin(t)) for t in a]
    body = lathe([(0, 0), *bottom[1:], (r, long - 0.003), (1.18 * r, long - 0.002),
        (1.18 * r, long),
                  (0, long)], 22, v=[0, *np.linspace(0.01, 0.07, 5), 0.96, 0.97, 0.99,
                      1])  # fmt: skip
    body = _lay(body, -long / 2, 1.18 * r)
    share = look.between(0.4, 0.7)
    tile = textures.stack((textures.plain(color), share), (textures.plain(GLASS), 1 - share))
    cork = _lay(cylinder(r, 0.018 * k, 16, top=1.2 * r), long / 2 - 0.006 * k, 1.18 * r)
    stop = textures.speckles(look.rng, look.own_color("tan", "black", "red", "white"), 6, 32)
    low = min(float(s.bounds[0, 2]) for s in (body, cork))
    body, cork = body.move(z=-low), cork.move(z=-low)
    return shape([(body, tile), (cork, stop)], [flat_foot(body.vertices, 0.1), hull_of(cork)],
                 opacity=0.8)  # fmt: skip


def tube_stand(look: Look) -> Shape:
    """An empty rack for test tubes: a board with round holes over a base."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "white", "blue", "wooden", "beige")
    wood = look.surface(color, "wood")
    count, pitch = 6, 0.03 * k
    x, y, top = pitch * count + 0.01, 0.06 * k, 0.06 * k
    hole, wall = 0.011 * k, 0.007
    base = box(x, y, wall)
    ends = [box(0.007, y, top).move(x=s * (x - 0.007) / 2) for s in (-1, 1)]
    rails = [box(x, (y - 2 * hole) / 2, wall).move(y=s * (y + 2 * hole) / 4, z=top - wall)
             for s in (-1, 1)]  # fmt: skip
    bars = [box(pitch - 2 * hole, 2 * hole, wall).move((n - count / 2) * pitch, 0, top - wall)
            for n in range(1, count)]  # fmt: skip
    return shape([(join([base, *ends, *rails, *bars]), wood)],
                 [hull_of(s) for s in (base, *ends, *rails, *bars)])  # fmt: skip


def _cylinder_glass(look: Look) -> Shape:
    """A measuring cylinder: a tall open tube with a scale on a broad foot."""
    k = look.between(0.85, 1.1)
    color = look.color("clear", "clear", "blue", "amber")
    side = [(0.03 * k, 0.0), (0.03 * k, 0.006), (0.0145 * k, 0.012), (0.0145 * k, 0.17 * k),
            (0.0165 * k, 0.176 * k)]  # fmt: skip
    body = lathe([(0, 0), *side, (0.0125 * k, 0.176 * k), (0.0125 * k, 0.014), (0, 0.014)], 28,
                 v=[0, 0.02, 0.04, 0.08, 0.92, 0.95, 0.96, 0.99, 1])  # fmt: skip
    liquid = look.own_color(*LIQUIDS)
    level = look.between(0.2, 0.6) * 0.16 * k
    fluid = cylinder(0.0121 * k, level, 20).move(z=0.0142)
    wall = ring_parts([(0.0145 * k, 0.012), (0.0145 * k, 0.176 * k)],
                      [(0.0125 * k, 0.176 * k), (0.0125 * k, 0.012)], 8)  # fmt: skip
    return shape([(body, _marks(color, 16)), (fluid, textures.plain(liquid))],
                 [*wall, cylinder_part(0.0299 * k, 0.012)], opacity=0.66)  # fmt: skip


def funnel(look: Look) -> Shape:
    """A funnel standing on its rim, stem up."""
    k = look.between(0.85, 1.15)
    color = look.color("white", "blue", "red", "clear", "orange", "silver", "green")
    r, h = 0.045 * k, 0.05 * k
    body = lathe([(0.94 * r, 0), (r, 0), (r, 0.003), (0.0085 * k, h), (0.006 * k, h + 0.05 * k),
                  (0.0045 * k, h + 0.05 * k), (0.0068 * k, h)], 34, loop=True)  # fmt: skip
    dark = cylinder(0.0046 * k, 0.001, 16).move(z=h + 0.0488 * k)
    cone = ring_parts([(r, 0), (0.0085 * k, h)], [(0.0068 * k, h), (0.94 * r, 0)], 12)
    stem = cylinder_part(0.0062 * k, 0.05 * k, (0, 0, h))
    return shape([(body, look.surface(color, "plastic")), (dark, textures.plain((40, 40, 42)))],
                 [*cone, stem])  # fmt: skip


def bunsen_burner(look: Look) -> Shape:
    """A Bunsen burner: foot, barrel with an air ring, gas inlet, some alight."""
    k = look.between(0.9, 1.08)
    color = look.color("charcoal", "green", "black", "blue", "gray")
    foot = lathe(np.array([(0, 0), (0.04, 0), (0.041, 0.004), (0.036, 0.012), (0.014, 0.022),
                           (0, 0.024)]) * k, 30)  # fmt: skip
    barrel = lathe(np.array([(0, 0.02), (0.008, 0.02), (0.008, 0.13), (0.0092, 0.132),
                             (0.0092, 0.14), (0.0065, 0.14), (0.0065, 0.136), (0, 0.136)]) * k,
                                 22)  # fmt: skip
    collar = cylinder(0.0108 * k, 0.02 * k, 22).move(z=0.032 * k)
    inlet = _lay(cylinder(0.0048 * k, 0.05 * k, 14), 0.005 * k, 0.03 * k)
    knob = _lay(cylinder(0.009 * k, 0.008 * k, 12), -0.03 * k, 0.03 * k)
    spots = [box(0.006 * k, 0.001, 0.009 * k).move(y=-0.0106 * k, z=0.037 * k)]
    brass = textures.brushed_metal(look.rng, (204, 170, 96))
    steel = textures.brushed_metal(look.rng, STEEL)
    pieces = [(foot, look.surface(color, "metal")), (barrel, steel),
              (join([collar, inlet, knob]), brass), (join(spots),
                  textures.plain((30, 30, 32)))]  # fmt: skip
    if look.chance(0.4):
        flame = lathe(np.array([(0, 0.134), (0.005, 0.138), (0.0085, 0.15), (0.006, 0.172),
                                (0.001, 0.19), (0, 0.192)]) * k, 16)  # fmt: skip
        pieces.append((flame, textures.gradient((70, 120, 240), (150, 200, 250), look.rng)))
    return shape(pieces, [cylinder_part(0.04 * k, 0.011 * k), hull_of(foot),
                          cylinder_part(0.0092 * k, 0.12 * k, (0, 0, 0.02 * k)),
                          hull_of(collar), hull_of(inlet)])  # fmt: skip


def lab_tripod(look: Look) -> Shape:
    """A tripod with a gauze mat on it, to heat things over."""
    k = look.between(0.9, 1.06)
    color = look.color("charcoal", "black", "gray", "silver")
    r, h = 0.062 * k, 0.13 * k
    ring = lathe([(0.82 * r, h - 0.006), (r, h - 0.006), (r, h), (0.82 * r, h)], 34, loop=True)
    legs = [tube([(1.22 * r * np.cos(a), 1.22 * r * np.sin(a), 0.0),
                  (0.9 * r * np.cos(a), 0.9 * r * np.sin(a), h - 0.003)], 0.0042 * k, 8)
            for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    net = textures.fit(textures.grid((120, 122, 126), (186, 188, 192), 16, 16, 96), 96, 96).copy()
    prints.disc(net, 0.5, 0.5, 0.34, (232, 230, 224))
    mat = box(1.9 * r, 1.9 * r, 0.002).move(z=h)
    return shape([(join([ring, *legs]), look.surface(color, "metal")), (mat, net)],
                 [*(hull_of(s.bend(above)) for s in legs),
                     cylinder_part(r, 0.006, (0, 0, h - 0.006)),
                  hull_of(mat)])  # fmt: skip


def wash_bottle(look: Look) -> Shape:
    """A soft squeeze bottle with a long bent spout."""
    k = look.between(0.9, 1.08)
    color = look.color("white", "white", "clear")
    cap_tone = look.own_color("red", "blue", "yellow", "green", "white", "orange")
    body = lathe(np.array([(0, 0), (0.034, 0), (0.036, 0.004), (0.036, 0.1), (0.03, 0.118),
                           (0.016, 0.126), (0.016, 0.134), (0, 0.134)]) * k, 30)  # fmt: skip
    image = prints.canvas(128, 96, color)
    front = image[:, 42:86]
    prints.fill(front, 0, 0.34, 1, 0.34, cap_tone)
    prints.write(front, look.pick(["WATER", "ETHANOL", "ACETONE"]), 0.5, 0.51, 0.16,
                 (250, 250, 248) if sum(cap_tone) < 500 else (30, 30, 30), bold=True)  # fmt: skip
    cap = cylinder(0.0185 * k, 0.02 * k, 22, bevel=0.001).move(z=0.13 * k)
    way = np.array([(0, 0, 0.148), (0.002, 0, 0.168), (0.016, 0, 0.182), (0.04, 0, 0.178),
                    (0.062, 0, 0.163)]) * k  # fmt: skip
    spout = tube(way, np.array([0.0045, 0.0042, 0.0038, 0.003, 0.0018]) * k, 10)
    return shape([(body, image), (cap, textures.speckles(look.rng, cap_tone, 4, 32)),
                  (spout, textures.plain((240, 240, 238)))],
                 [cylinder_part(0.036 * k, 0.104 * k), hull_of(body), hull_of(cap),
                  hull_of(spout)])  # fmt: skip


def dropper(look: Look) -> Shape:
    """A pipette with a rubber bulb, lying."""
    k = look.between(0.88, 1.1)
    color = look.color("red", "blue", "orange", "black", "white", "teal")
    stem = lathe(np.array([(0, 0), (0.0014, 0), (0.0018, 0.03), (0.0042, 0.04), (0.0042, 0.11),
                           (0, 0.11)]) * k, 16)  # fmt: skip
    bulb = lathe(np.array([(0, 0.104), (0.0052, 0.104), (0.0056, 0.112), (0.0095, 0.125),
                           (0.0098, 0.135), (0.006, 0.147), (0, 0.149)]) * k, 20)  # fmt: skip
    lean = np.arctan2(0.0084, 0.13)
    solids = [s.turn(1, np.pi / 2 - lean).move(x=-0.07 * k) for s in (stem, bulb)]
    low = min(float(s.bounds[0, 2]) for s in solids)
    stem, bulb = (s.move(z=-low) for s in solids)
    liquid = textures.stack((textures.plain(look.own_color(*LIQUIDS)), 0.45),
                            (textures.plain(GLASS), 0.55))  # fmt: skip
    return shape([(stem, liquid), (bulb, textures.speckles(look.rng, color, 4, 32))],
                 [hull_of(stem), flat_foot(bulb.vertices, 0.1)])  # fmt: skip


def micropipette(look: Look) -> Shape:
    """A laboratory pipette lying: plunger, grip with a hook, slender shaft and tip."""
    k = look.between(0.92, 1.06)
    color = look.color("white", "gray", "white", "sky")
    accent = look.own_color("blue", "yellow", "red", "green", "orange", "purple")
    grip = lathe(np.array([(0, 0.1), (0.008, 0.1), (0.011, 0.115), (0.0135, 0.16), (0.015, 0.2),
                           (0.011, 0.208), (0, 0.21)]) * k, 20)  # fmt: skip
    shaft = lathe(np.array([(0, 0.03), (0.0035, 0.03), (0.005, 0.06), (0.007, 0.1),
        (0, 0.101)]) * k,
                  16)  # fmt: skip
    tip = lathe(
        np.array([(0, 0), (0.0006, 0), (0.0036, 0.034), (0.0044, 0.042), (0, 0.042)]) * k, 14
    )
    knob = lathe(np.array([(0, 0.208), (0.004, 0.208), (0.004, 0.222), (0.0075, 0.224),
                           (0.0075, 0.234), (0, 0.236)]) * k, 18)  # fmt: skip
    hook = box(0.006 * k, 0.03 * k, 0.01 * k).move(y=0.02 * k, z=0.194 * k)
    solids = [_lay(s, -0.118 * k, 0.015 * k) for s in (grip, shaft, tip, knob, hook)]
    lean = np.arctan2(0.0145, 0.19) * 0.95
    solids = [s.move(x=-0.08 * k, z=-0.015 * k).turn(1, lean) for s in solids]
    low = min(float(s.bounds[0, 2]) for s in solids)
    grip, shaft, tip, knob, hook = (s.move(z=-low) for s in solids)
    return shape([(join([grip, hook, shaft]), look.surface(color, "plastic")),
        (knob, textures.plain(
                  accent)), (tip, textures.plain(tint_color(accent, 1.4)))],
                 [flat_foot(grip.vertices, 0.08), hull_of(shaft), hull_of(tip), hull_of(knob),
                  hull_of(hook)])  # fmt: skip


def retort_stand(look: Look) -> Shape:
    """A stand with a rod and a clamp that holds a burette."""
    k = look.between(0.8, 0.95)
    color = look.color("gray", "green", "charcoal", "blue", "white")
    base = box(0.13 * k, 0.2 * k, 0.016 * k)
    rod = cylinder(0.0055 * k, 0.4 * k, 14).move(y=0.07 * k, z=0.014 * k)
    boss = block(0.022 * k, 0.03 * k, 0.03 * k, 0.004).move(y=0.07 * k, z=0.27 * k)
    arm = tube(np.array([(0, 0.07, 0.285), (0, -0.01, 0.285)]) * k, 0.0045 * k, 8)
    ring = lathe([(0.009 * k, 0), (0.014 * k, 0), (0.014 * k, 0.016 * k), (0.009 * k, 0.016 * k)],
        20,
                 loop=True).move(y=-0.022 * k, z=0.277 * k)  # fmt: skip
    glass = lathe(np.array([(0, 0.07), (0.0015, 0.07), (0.002, 0.09), (0.0085, 0.105),
                            (0.0085, 0.4), (0.0105, 0.404), (0, 0.404)]) * k, 20)  # fmt: skip
    glass = glass.move(y=-0.022 * k)
    tap = _lay(cylinder(0.003 * k, 0.03 * k, 10), -0.015 * k, 0.096 * k).move(y=-0.022 * k)
    liquid = look.own_color(*LIQUIDS)
    fill = textures.stack((textures.plain(tint_color(liquid, 1.1)), 0.6), (_marks(GLASS), 0.4))
    steel = textures.brushed_metal(look.rng, STEEL)
    return shape([(base, look.surface(color, "metal")), (join([rod, arm]), steel),
                  (join([boss, ring]), textures.plain((70, 72, 76))), (glass, fill),
                  (tap, textures.plain((206, 52, 46)))],
                 [hull_of(base), hull_of(rod), hull_of(boss, arm), hull_of(ring),
                     hull_of(glass)])  # fmt: skip


def balance_scale(look: Look) -> Shape:
    """A beam balance with two hanging pans."""
    k = look.between(0.88, 1.06)
    metal = look.surface(look.color("brass", "gold", "silver", "copper", "black"), "metal")
    base = lathe(np.array([(0, 0), (0.06, 0), (0.062, 0.006), (0.05, 0.016), (0.012, 0.024),
                           (0, 0.024)]) * k, 30)  # fmt: skip
    post = lathe(np.array([(0, 0.02), (0.008, 0.02), (0.005, 0.06), (0.0065, 0.12), (0.005, 0.2),
                           (0.009, 0.215), (0.004, 0.228), (0, 0.232)]) * k, 18)  # fmt: skip
    tilt = look.between(-0.1, 0.1)
    beam = box(0.2 * k, 0.007 * k, 0.009 * k).turn(1, tilt).move(z=0.205 * k)
    pieces: list[Solid] = [base, post, beam]
    parts = [cylinder_part(0.06 * k, 0.008 * k), hull_of(base), hull_of(post), hull_of(beam)]
    for s in (-1, 1):
        x, top = s * 0.098 * k, (0.208 - s * 0.098 * np.tan(tilt)) * k
        bottom = top - 0.1 * k
        dish = lathe([(0, 0), (0.02 * k, 0.001), (0.04 * k, 0.01 * k), (0.041 * k, 0.012 * k),
                      (0.038 * k, 0.0115 * k), (0.02 * k, 0.003), (0, 0.002)], 26)  # fmt: skip
        pieces.append(dish.move(x=x, z=bottom))
        for a in np.arange(3) * 2 * np.pi / 3 + np.pi / 2:
            foot = (x + 0.039 * k * np.cos(a), 0.039 * k * np.sin(a), bottom + 0.011 * k)
            pieces.append(tube([foot, (x, 0, top)], 0.0009 * k, 5))
        parts += [cylinder_part(0.04 * k, 0.011 * k, (x, 0, bottom)),
                  box_part(0.012 * k, 0.012 * k, 0.088 * k,
                      (x, 0, bottom + 0.011 * k))]  # fmt: skip
    return shape([(join(pieces), metal)], parts)


def weighing_boat(look: Look) -> Shape:
    """A small open plastic tray for powders, a little powder in it."""
    k = look.between(0.85, 1.15)
    x, y, h, wall = 0.075 * k, 0.06 * k, 0.016 * k, 0.0018
    color = look.color("white", "white", "blue", "black", "clear")
    pieces = open_box(x, y, h, wall, 0.002)
    parts: list[ConvexPart] = [hull_of(s) for s in pieces]
    powder = lathe([(0, 0), (0.014 * k, 0), (0.008 * k, 0.004), (0, 0.006)], 18).move(z=0.0018)
    tone = look.own_color("white", "yellow", "blue", "cream", "tan")
    return shape([(join(pieces), look.surface(color, "plastic")), (powder, textures.spots(
                  look.rng, tone, tint_color(tone, 0.8), 0.2, 64))], parts)  # fmt: skip


def crucible(look: Look) -> Shape:
    """A small porcelain crucible, open."""
    k = look.between(0.88, 1.12)
    color = look.color("white", "white", "cream", "gray", "charcoal")
    side = [(0.014 * k, 0), (0.021 * k, 0.014 * k), (0.026 * k, 0.036 * k), (0.0275 * k, 0.042 * k)]
    body, parts = open_vessel(side, 0.0028, 0.004)
    return shape([(body, look.surface(color, "ceramic"))], parts)


def molecule_model(look: Look) -> Shape:
    """A ball-and-stick model of a small molecule."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "red", "blue", "black")
    ways = np.array([(0.94, 0, -0.33), (-0.47, 0.82, -0.33), (-0.47, -0.82, -0.33), (0, 0, 1.0)])
    long, big, small = 0.046 * k, 0.034 * k, 0.025 * k
    center = np.array([0, 0, 0.33 * long + small / 2])
    balls = [ellipsoid(big, big, big, 20, 12).move(*center)]
    outer = [ellipsoid(small, small, small, 16, 10).move(*(center + long * w)) for w in ways]
    rods = [tube([center, center + long * w], 0.0032 * k, 8) for w in ways]
    tone = look.own_color("white", "white", "red", "green", "yellow")
    feet = [resting_ball(small, small, small) for _ in range(3)]
    feet = [
        ConvexPart(np.add(p.vertices, (*(long * w)[:2], 0.0)))
        for p, w in zip(feet, ways, strict=False)
    ]
    return shape([(join(balls), textures.speckles(look.rng, color, 3, 32)),
                  (join(outer), textures.speckles(look.rng, tone, 3, 32)),
                  (join(rods), textures.plain((170, 172, 176)))],
                 [*feet, hull_of(balls[0]), hull_of(outer[3]),
                     *(hull_of(r) for r in rods)])  # fmt: skip


def glass_prism(look: Look) -> Shape:
    """A triangular glass prism lying, rainbow light in it."""
    k = look.between(0.88, 1.15)
    color = look.color("clear", "clear", "sky")
    long, side = 0.08 * k, 0.034 * k
    outline = np.array([(-side / 2, 0), (side / 2, 0), (0, 0.866 * side)])
    body = prism(outline, -long / 2, long / 2, 0.0008).turn(0, np.pi / 2).turn(2, np.pi / 2)
    tones = [(230, 60, 60), (240, 150, 50), (240, 220, 80), (90, 190, 100), (80, 130, 220),
             (150, 90, 200)]  # fmt: skip
    rainbow = textures.stripes([color, *(tint_color(t, 1.3) for t in tones)],
                               1, upright=True)  # fmt: skip
    return shape([(body, rainbow)], [hull_of(body)], opacity=0.78)


def newtons_cradle(look: Look) -> Shape:
    """Five steel balls hanging in a row from a frame."""
    k = look.between(0.85, 1.05)
    color = look.color("silver", "black", "gold", "charcoal")
    x, y, h = 0.15 * k, 0.11 * k, 0.14 * k
    base = block(1.12 * x, 1.1 * y, 0.014 * k, 0.008, 0.002)
    bars = [tube(np.array([(-x / 2, s * y / 2, 0.012), (-x / 2, s * y / 2, h),
        (x / 2, s * y / 2, h),
                           (x / 2, s * y / 2, 0.012)]), 0.0034 * k, 8)
                               for s in (-1, 1)]  # fmt: skip
    d = 0.022 * k
    balls, wires = [], []
    swing = look.between(0.3, 0.6) if look.chance(0.6) else 0.0
    for n in range(5):
        u = (n - 2) * d
        a = swing if n == 4 else 0.0
        at = np.array([u + np.sin(a) * 0.095 * k, 0, h - 0.095 * k * np.cos(a)])
        balls.append(ellipsoid(d, d, d, 16, 10).move(*at))
        wires += [tube([at, (u, s * y / 2, h)], 0.0006, 4) for s in (-1, 1)]
    wood = look.own_color("black", "brown", "wooden")
    return shape([(base, textures.wood(look.rng, wood)), (join(bars), look.surface(color, "metal")),
                  (join(balls), textures.brushed_metal(look.rng, (206, 208, 212))),
                  (join(wires), textures.plain((210, 210, 212)))],
                 [hull_of(base), *(box_part(x, 0.006 * k, 0.006 * k, (0, s * y / 2, h - 0.003 * k))
                                   for s in (-1, 1)),
                  *(box_part(0.0068 * k, 0.0068 * k, h - 0.004, (s * x / 2, t * y / 2, 0.002))
                    for s in (-1, 1) for t in (-1, 1)), hull_of(*balls)])  # fmt: skip


CATEGORIES = (
    Category("test_tube", test_tube, (0.142, 0.0214, 0.0214), 0.03, ("glass tube",
             "single test tube", "sample tube", "centrifuge tube", "vial", "culture tube"),
             ("lab",), (), ("clear", "blue"), None, "lying flat"),
    Category("tube_stand", tube_stand, (0.19, 0.06, 0.06), 0.15, ("empty test tube rack",
             "test tube holder", "test tube stand", "tube holder", "vial rack"), ("lab",),
             ("big",), ("wooden",)),
    Category("graduated_cylinder", _cylinder_glass, (0.0585, 0.0585, 0.172), 0.12,
             ("measuring cylinder", "glass cylinder", "mixing cylinder"), ("lab",),
             ("round", "tall"), ("clear",)),
    Category("funnel", funnel, (0.09, 0.09, 0.1), 0.04, ("lab funnel", "plastic funnel",
             "glass funnel", "kitchen funnel"), ("lab", "kitchen"), ("round",), ("white", "blue")),
    Category("bunsen_burner", bunsen_burner, (0.093, 0.081, 0.16), 0.5, ("gas burner",
             "lab burner", "bunsen"), ("lab",), ("tall",), ("charcoal",)),
    Category("lab_tripod", lab_tripod, (0.135, 0.124, 0.1305), 0.4, ("tripod stand",
             "heating tripod", "bunsen tripod", "laboratory tripod", "lab stand"), ("lab",),
             ("support", "tall"), ("charcoal",)),
    Category("wash_bottle", wash_bottle, (0.099, 0.0715, 0.184), 0.3, ("lab wash bottle",
             "distilled water bottle", "squirt bottle", "rinse bottle"), ("lab",), ("tall",),
             ("white",)),
    Category("dropper", dropper, (0.149, 0.0195, 0.0195), 0.01, ("pipette", "eye dropper",
             "glass dropper", "transfer pipette", "eyedropper", "dropping pipette"), ("lab",), (),
             ("red",), None, "lying flat"),
    Category("micropipette", micropipette, (0.236, 0.045, 0.033), 0.1, ("lab pipette",
             "pipettor", "automatic pipette", "pipette gun"), ("lab",), (), ("white",), None,
             "lying flat"),
    Category("retort_stand", retort_stand, (0.115, 0.175, 0.365), 1.1, ("burette stand",
             "burette", "ring stand", "clamp stand", "buret", "laboratory stand"), ("lab",),
             ("tall", "big"), ("gray",)),
    Category("balance_scale", balance_scale, (0.272, 0.12, 0.226), 0.7, ("beam balance",
             "balance", "scales of justice", "pan balance", "balance scales", "justice scales",
             "old scale"), ("lab",), ("tall", "big"), ("brass",)),
    Category("weighing_boat", weighing_boat, (0.075, 0.06, 0.016), 0.008, ("weigh boat",
             "weighing dish", "weighing tray"), ("lab",), ("container",), ("white",)),
    Category("crucible", crucible, (0.055, 0.055, 0.042), 0.05, ("porcelain crucible",), ("lab",),
        ("container", "round"), ("white",)),
    Category("molecule_model", molecule_model, (0.09, 0.103, 0.086), 0.06, ("molecule",
             "molecular model", "atom model", "ball and stick model"),
             ("lab",), (), ("black", "red")),
    Category("glass_prism", glass_prism, (0.0805, 0.034, 0.03), 0.09, ("prism",
             "optical prism", "light prism", "crystal prism", "triangular glass prism"), ("lab",),
             (), ("clear",)),
    Category("newtons_cradle", newtons_cradle, (0.16, 0.115, 0.137), 0.5, ("newton's cradle",
             "newton cradle", "pendulum balls", "pendulum", "desk pendulum"), ("office",),
             ("tall",), ("silver",)),
)  # fmt: skip
"""The module's categories."""
