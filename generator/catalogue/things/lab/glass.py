"""Laboratory ware: tubes, cylinders, funnels, burners, stands, models."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of, ring_parts
from ...build.forms import lay_down
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import (
    box,
    cylinder,
    join,
    lathe,
    open_box,
    tube,
)
from ...build.variants import keep_still, vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

LIQUIDS = ("blue", "teal", "amber", "pink", "green", "violet", "coral", "red")
GLASS: RGB = (206, 222, 226)


def marks(ground: RGB, count: int = 10) -> textures.Tile:
    """Return glass with a scale on its front."""
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
    body = lay_down(body, -long / 2, 1.18 * r)
    share = look.between(0.4, 0.7)
    tile = textures.stack((textures.plain(color), share), (textures.plain(GLASS), 1 - share))
    cork = lay_down(cylinder(r, 0.018 * k, 16, top=1.2 * r), long / 2 - 0.006 * k, 1.18 * r)
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
    return shape([(body, marks(color, 16)), (fluid, textures.plain(liquid))],
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
    solids = [lay_down(s, -0.118 * k, 0.015 * k) for s in (grip, shaft, tip, knob, hook)]
    lean = np.arctan2(0.0145, 0.19) * 0.95
    solids = [s.move(x=-0.08 * k, z=-0.015 * k).turn(1, lean) for s in solids]
    low = min(float(s.bounds[0, 2]) for s in solids)
    grip, shaft, tip, knob, hook = (s.move(z=-low) for s in solids)
    return shape([(join([grip, hook, shaft]), look.surface(color, "plastic")),
        (knob, textures.plain(
                  accent)), (tip, textures.plain(tint_color(accent, 1.4)))],
                 [flat_foot(grip.vertices, 0.08), hull_of(shaft), hull_of(tip), hull_of(knob),
                  hull_of(hook)])  # fmt: skip


def glass_rod(look: Look) -> Shape:
    """A glass rod for stirring, lying."""
    k = look.between(0.9, 1.1)
    r, long = 0.0032 * k, 0.2 * k
    side = [(0, 0), (0.7 * r, 0.0006), (r, 0.003), (r, long - 0.003), (0.7 * r, long - 0.0006),
            (0, long)]  # fmt: skip
    body = lay_down(lathe(side, 14), -long / 2, r)
    body = body.move(z=-body.bounds[0, 2])
    return shape([(body, textures.plain(look.color("clear", "sky", "clear")))],
                 [flat_foot(body.vertices, 0.1)], opacity=0.8)  # fmt: skip


def empty_beaker(look: Look) -> Shape:
    """A glass beaker with a scale and nothing in it."""
    r, h = look.between(0.036, 0.042), look.between(0.095, 0.11)
    side = [(r, 0), (r, h - 0.003), (1.06 * r, h)]
    body, parts = open_vessel(side, 0.003, 0.005)
    return shape([(body, marks(GLASS))], parts, opacity=0.6)


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


CATEGORIES = (
    Category("test_tube", test_tube, (0.142, 0.0214, 0.0214), 0.03, ("glass tube",
             "single test tube", "sample tube", "centrifuge tube", "vial", "culture tube",
             "blood tube", "vacutainer", "falcon tube", "boiling tube", "specimen tube",
             "blood sample tube", "homeopathic tube", "fulgurite"),
             ("lab",), (), ("clear", "blue"), None, "lying flat"),
    Category("tube_stand", tube_stand, (0.19, 0.06, 0.06), 0.15, ("empty test tube rack",
             "test tube holder", "test tube stand", "tube holder", "vial rack"), ("lab",),
             ("big",), ("wooden",)),
    Category("graduated_cylinder", _cylinder_glass, (0.0585, 0.0585, 0.172), 0.12,
             ("measuring cylinder", "glass cylinder", "mixing cylinder", "rain gauge tube",
             "tornado tube"), ("lab",),
             ("round", "tall"), ("clear",)),
    Category("funnel", funnel, (0.09, 0.09, 0.1), 0.04, ("lab funnel", "plastic funnel",
             "glass funnel", "kitchen funnel",
             "funnel for oil", "oil funnel"), ("lab", "kitchen"), ("round",), ("white", "blue")),
    Category("wash_bottle", wash_bottle, (0.099, 0.0715, 0.184), 0.3, ("lab wash bottle",
             "distilled water bottle", "squirt bottle", "rinse bottle"), ("lab",), ("tall",),
             ("white",)),
    Category("dropper", dropper, (0.149, 0.0195, 0.0195), 0.01, ("pipette", "eye dropper",
             "glass dropper", "transfer pipette", "eyedropper", "dropping pipette"), ("lab",), (),
             ("red",), None, "lying flat"),
    Category("micropipette", keep_still(micropipette), (0.236, 0.045, 0.033), 0.1, ("lab pipette",
             "pipettor", "automatic pipette", "pipette gun"), ("lab",), (), ("white",), None,
             "lying flat"),
    Category("glass_rod", glass_rod, (0.2, 0.0064, 0.0064), 0.02, ("stirring rod", "stir rod",
             "glass stirring rod", "glass stirrer", "stirring stick"), ("lab",), (), ("clear",),
             None, "lying flat"),
    vary(Category("empty_beaker", empty_beaker, (0.0827, 0.0827, 0.1025), 0.12, ("open beaker",),
             ("lab",), ("container", "round"), ("clear",))),
    Category("weighing_boat", weighing_boat, (0.075, 0.06, 0.016), 0.008, ("weigh boat",
             "weighing dish", "weighing tray"), ("lab",), ("container",), ("white",)),
    Category("crucible", crucible, (0.055, 0.055, 0.042), 0.05, ("porcelain crucible",), ("lab",),
        ("container", "round"), ("white",)),
)  # fmt: skip
"""The module's categories."""
