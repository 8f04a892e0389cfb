"""Objects of the ``coffee`` theme: brewers."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part, open_vessel
from ...kit.primitives import ball, facing, limb, side_view, straight
from ...kit.shapes import Shape, category, settle, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, sweep, torus, tube
from ...kit.surfaces import RGB, Look, tint_color

DARK: RGB = (38, 39, 43)


@category("moka_pot", size=(0.16, 0.09, 0.19), mass=0.5, material="metal",
          aliases=("stovetop espresso maker", "espresso pot", "moka", "bialetti", "espresso maker",
          "italian coffee maker"), themes=("coffee", "kitchen"), roles=("tall",),
          colors=("silver", "red"))  # fmt: skip
def moka_pot(look: Look) -> Shape:
    """An eight-sided stove-top espresso pot with a waist and a black handle on the right."""
    k, h = look.between(0.85, 1.08), look.between(0.165, 0.21)
    color = look.color("silver", "silver", "silver", "red", "black", "copper", "teal", "white")
    lower, sides = look.surface(color, "metal"), look.pick([8, 8, 8, 28])
    steel = surfaces.brushed_metal(look.rng, (192, 194, 198)) if look.chance(0.5) else lower
    r, waist = 0.046 * k, 0.44 * h
    base = lathe([(0, 0), (0.96 * r, 0), (r, 0.01), (0.8 * r, waist), (0, waist)], sides)
    ring = cylinder(0.86 * r, 0.03 * h, 30, bevel=0.001).move(z=waist)
    top = lathe([(0, 0.46 * h), (0.74 * r, 0.46 * h), (1.02 * r, 0.82 * h), (0, 0.82 * h)], sides)
    lid = lathe([(0, 0.82 * h), (1.05 * r, 0.82 * h), (1.03 * r, 0.835 * h), (0.3 * r, 0.9 * h),
                 (0, 0.905 * h)], sides)  # fmt: skip
    knob = lathe([(0, 0.9 * h), (0.006, 0.9 * h), (0.008, 0.94 * h), (0.013, 0.965 * h),
                  (0.01, h), (0, h)], 14)  # fmt: skip
    beak = side_view([(-0.6 * r, 0.55 * h), (-0.6 * r, 0.82 * h), (-1.42 * r, 0.82 * h)],
                     0.02 * k)  # fmt: skip
    grip = sweep(
        smooth([(0.9 * r, 0, 0.77 * h), (1.7 * r, 0, 0.8 * h), (2.0 * r, 0, 0.7 * h),
                (1.85 * r, 0, 0.3 * h)], 4), rectangle(0.02, 0.011, 0.004, 2),
    )  # fmt: skip
    dark = surfaces.speckles(look.rng, look.own_color("black", "black", "black", "brown"), 3, 32)
    valve = facing(cylinder(0.006, 0.008, 10)).move(y=-0.88 * r, z=0.25 * h)
    return shape(
        [(base, lower), (join([top, lid, beak]), lower), (join([ring, valve]), steel),
         (join([grip, knob]), dark)],
        [hull_of(base), hull_of(top), hull_of(lid), hull_of(knob), hull_of(beak),
         hull_part(grip.vertices[grip.vertices[:, 0] > 1.5 * r])],
    )  # fmt: skip


@category("espresso_machine", size=(0.248, 0.329, 0.322), mass=6.0, material="device",
          aliases=("espresso coffee machine", "cappuccino machine", "nespresso machine",
          "capsule machine"), themes=("coffee", "kitchen"), roles=("tall", "big"),
          colors=("silver", "red"))  # fmt: skip
def espresso_machine(look: Look) -> Shape:
    """An espresso machine with a filter holder, a drip tray, a steam wand and cups on top."""
    x, y, h = look.between(0.22, 0.3), look.between(0.25, 0.3), look.between(0.28, 0.33)
    color = look.color("silver", "silver", "red", "black", "cream", "mint", "white")
    skin, dark = look.surface(color, "metal"), surfaces.plain(DARK)
    steel = surfaces.brushed_metal(look.rng, (194, 196, 200))
    tray = block(x, y, 0.055, 0.012, 0.004)
    back = block(x, 0.48 * y, h, 0.012, 0.004).move(y=0.26 * y)
    head = block(x, 0.86 * y, 0.33 * h, 0.014, 0.005).move(y=0.07 * y, z=0.67 * h)
    grate = box(0.84 * x, 0.42 * y, 0.003).move(y=-0.24 * y, z=0.054)
    grid = surfaces.grid((34, 35, 38), (150, 152, 156), 0, 14, 64, 2)
    group = cylinder(0.034, 0.035, 26, bevel=0.003).move(0, -0.2 * y, 0.67 * h - 0.034)
    basket = cylinder(0.033, 0.028, 26).move(0, -0.2 * y, 0.67 * h - 0.06)
    grip = facing(cylinder(0.013, 0.105, 14, top=0.016, bevel=0.003)).turn(0, 0.1)
    grip = grip.move(0, -0.2 * y - 0.03, 0.67 * h - 0.046)
    spouts = [cylinder(0.006, 0.022, 10).move(s * 0.01, -0.2 * y, 0.67 * h - 0.08)
              for s in (-1, 1)]  # fmt: skip
    wand = tube(smooth([(0.4 * x, -0.3 * y, 0.68 * h), (0.42 * x, -0.36 * y, 0.55 * h),
                        (0.42 * x, -0.4 * y, 0.3 * h)], 4), 0.005, 8)  # fmt: skip
    face = prints.canvas(160, 56, tint_color(color, 0.95))
    prints.disc(face, 0.16, 0.5, 0.36, (246, 246, 242))
    prints.disc(face, 0.16, 0.5, 0.36, DARK, 0.3)
    prints.stroke(face, [(0.16, 0.5), (0.2, 0.3)], 0.05, (200, 40, 40))
    for k in range(3):
        prints.disc(face, 0.46 + 0.17 * k, 0.5, 0.2, DARK)
        prints.disc(face, 0.46 + 0.17 * k, 0.5, 0.13, (224, 226, 230))
    front = box(0.86 * x, 0.004, 0.2 * h).move(y=-0.36 * y - 0.002, z=0.735 * h)
    pieces = [(join([tray, back, head]), skin), (grate, grid), (front, face),
              (join([group, basket, *spouts, wand]), steel), (grip, dark)]  # fmt: skip
    if look.chance(0.6):
        cup = lathe([(0, 0), (0.02, 0), (0.03, 0.045), (0.027, 0.045), (0.018, 0.004), (0, 0.004)])
        pieces.append((join([cup.move(s * 0.22 * x, 0.1 * y, h) for s in (-1, 1)]),
                       surfaces.plain((242, 240, 236))))  # fmt: skip
    return shape(pieces, [hull_of(tray), hull_of(back), hull_of(head), hull_of(group, basket),
                          hull_of(grip), hull_of(wand)])  # fmt: skip


@category("coffee_grinder", size=(0.134, 0.125, 0.235), mass=0.9, material="wood", assembled=True,
          aliases=("coffee mill", "grinder", "hand grinder", "burr grinder"),
          themes=("coffee", "kitchen"), roles=("tall",), colors=("wooden", "black"))  # fmt: skip
def coffee_grinder(look: Look) -> Shape:
    """A wooden coffee mill with a crank and a drawer, or an electric coffee grinder."""
    if look.chance(0.55):
        s, h = look.between(0.105, 0.13), look.between(0.1, 0.13)
        color = look.color("wooden", "brown", "tan", "maroon", "black", "teal")
        wood = look.surface(color, "wood")
        metal = surfaces.brushed_metal(
            look.rng, look.own_color("brass", "copper", "silver", "charcoal")
        )
        feet = box(s + 0.014, s + 0.014, 0.012)
        body, top = box(s, s, h).move(z=0.012), box(s + 0.01, s + 0.01, 0.01).move(z=h + 0.012)
        face = surfaces.wood(look.rng, tint_color(color, 1.2))
        drawer = box(0.72 * s, 0.008, 0.42 * h).move(y=-s / 2 - 0.003, z=0.2 * h)
        pull = ellipsoid(0.016, 0.016, 0.016, 12, 8).move(y=-s / 2 - 0.012, z=0.41 * h)
        z = h + 0.022
        cup = lathe([(0, z), (0.024, z), (0.044, z + 0.03), (0.046, z + 0.04), (0.03, z + 0.056),
                     (0.008, z + 0.062), (0, z + 0.062)], 24)  # fmt: skip
        a = look.between(-0.6, 0.6)
        arm = tube(smooth([(0, 0, z + 0.055), (0, 0, z + 0.08), (0.05, 0, z + 0.088),
                           (0.11, 0, z + 0.084)], 4), 0.0045, 8)  # fmt: skip
        knob = ellipsoid(0.026, 0.026, 0.034, 14, 10).move(0.112, 0, z + 0.1)
        arm, knob = arm.turn(2, a), knob.turn(2, a)
        return shape(
            [(join([feet, body, top, knob]), wood), (drawer, face),
             (join([pull, cup, arm]), metal)],
            [hull_of(feet), hull_of(body), hull_of(top), hull_of(cup), hull_of(knob, arm)],
        )  # fmt: skip
    r, h = look.between(0.05, 0.06), look.between(0.2, 0.25)
    color = look.color("black", "silver", "white", "red", "mint")
    body = lathe([(0, 0), (r, 0), (r, 0.02), (0.86 * r, 0.3 * h), (0.9 * r, 0.62 * h),
                  (0, 0.62 * h)], 28)  # fmt: skip
    beans = surfaces.spots(look.rng, (72, 44, 28), (40, 24, 16), 0.4)
    clear = surfaces.plain((204, 214, 218))
    hopper = lathe([(0, 0.62 * h), (0.84 * r, 0.62 * h), (1.1 * r, 0.94 * h), (0, 0.94 * h)], 28,
                   v=[0, 0.05, 0.95, 1])  # fmt: skip
    lid = cylinder(1.12 * r, 0.06 * h, 28, bevel=0.002).move(z=0.94 * h)
    dial = facing(cylinder(0.02, 0.012, 20, bevel=0.002)).move(y=-0.84 * r, z=0.42 * h)
    return shape([(body, look.surface(color)), (hopper, surfaces.stack((beans, 60), (clear, 40))),
                  (join([lid, dial]), surfaces.plain(DARK))], [hull_of(body), hull_of(hopper),
                                                               hull_of(lid)])  # fmt: skip


STEEL: RGB = (188, 191, 196)
GLASS: RGB = (212, 224, 226)
COFFEE: RGB = (58, 34, 22)


@category("coffee_filter", size=(0.113, 0.112, 0.0436), mass=0.002, material="paper", hollow=True,
          aliases=("paper filter", "filter paper", "paper coffee filter", "basket filter"),
          themes=("coffee",), roles=("container", "round"), colors=("white",))  # fmt: skip
def coffee_filter(look: Look) -> Shape:
    """An open, fluted paper coffee filter."""
    r, h = look.between(0.05, 0.058), look.between(0.038, 0.048)
    color = look.color("white", "white", "tan")
    body, parts = open_vessel([(0.52 * r, 0), (r, h)], 0.0014, 0.0014, 60)
    pleat = body.bend(lambda p: p * np.column_stack([*[1 + 0.035 * np.cos(30 * np.arctan2(
        p[:, 1], p[:, 0])) * (p[:, 2] / h)] * 2, np.ones(len(p))]))  # fmt: skip
    folds = surfaces.stripes([color, tint_color(color, 0.86)], 30, upright=True, side=120)
    return shape([(pleat, folds)], parts)


@category("coffee_dripper", size=(0.148, 0.118, 0.0762), mass=0.3, material="ceramic", hollow=True,
          aliases=("pour over dripper", "dripper", "pour-over dripper", "v60", "pour over cone",
          "coffee cone"), themes=("coffee",), roles=("container", "round"),
          colors=("white",))  # fmt: skip
def coffee_dripper(look: Look) -> Shape:
    """A pour-over coffee dripper: an open, ribbed cone with a handle and a flat base."""
    k = look.between(0.94, 1.08)
    color = look.color("white", "red", "black", "teal", "clear", "brown")
    r, h = 0.058 * k, 0.075 * k
    body, parts = open_vessel([(0.3 * r, 0), (0.34 * r, 0.14 * h), (r, h)], 0.004, 0.004, 32)
    foot = lathe(
        [(0.28 * r, 0), (0.86 * r, 0), (0.86 * r, 0.005), (0.28 * r, 0.005)], 32, loop=True
    )
    grip = torus(0.021 * k, 0.005 * k, 22, 8).turn(0, np.pi / 2).scale(1, 1, 1.15)
    grip = grip.move(x=0.062 * k, z=0.45 * h)
    ribs = [tube([(0.36 * r * np.cos(a), 0.36 * r * np.sin(a), 0.2 * h), (0.9 * r * np.cos(a + 0.7),
            0.9 * r * np.sin(a + 0.7), 0.92 * h)], 0.0022, 5)
            for a in 2 * np.pi * np.arange(9) / 9]  # fmt: skip
    glaze = look.surface(color, "ceramic")
    return shape([(join([body, grip]), glaze), (foot, glaze), (join(ribs), surfaces.plain(
                  tint_color(color, 0.85)))], [*parts, cylinder_part(0.86 * r, 0.005),
                                               hull_of(grip)])  # fmt: skip


@category("chemex", size=(0.124, 0.124, 0.215), mass=0.7, material="glass", hollow=True,
          aliases=("chemex coffee maker", "pour over carafe", "pour over coffee maker",
          "glass coffee maker"), themes=("coffee",), roles=("tall", "round"),
          colors=("wooden",))  # fmt: skip
@vary()
def chemex(look: Look) -> Shape:
    """A Chemex: an hourglass-shaped glass carafe with a wooden collar, half full of coffee."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "wooden", "brown", "black")
    r, h = 0.062 * k, 0.215 * k
    low = lathe([(0, 0), (0.93 * r, 0), (r, 0.04 * h), (0.98 * r, 0.12 * h), (0.7 * r, 0.32 * h),
                 (0, 0.32 * h)], 32)  # fmt: skip
    mid = lathe([(0, 0.32 * h), (0.7 * r, 0.32 * h), (0.38 * r, 0.52 * h), (0, 0.52 * h)], 32)
    cone, _ = open_vessel([(0.38 * r, 0), (0.98 * r, 0.48 * h)], 0.003, 0.004, 32)
    cone = cone.move(z=0.52 * h)
    collar = lathe([(0.3 * r, 0.44 * h), (0.6 * r, 0.44 * h), (0.46 * r, 0.52 * h), (0.6 * r,
                    0.6 * h), (0.3 * r, 0.6 * h)], 28, loop=True)  # fmt: skip
    cord = [torus(0.48 * r, 0.0022, 24, 6).move(z=0.52 * h), ball(0.013, 0.013, 0.013,
            (0, -0.56 * r, 0.5 * h), 10)]  # fmt: skip
    clear = surfaces.plain(GLASS)
    return shape(
        [
            (low, surfaces.speckles(look.rng, COFFEE, 4)),
            (join([mid, cone]), clear),
            (collar, look.surface(color, "wood")),
            (join(cord), surfaces.plain((120, 82, 54))),
        ],
        [hull_of(low, mid), hull_of(cone), hull_of(collar, *cord)],
    )


@category("aeropress", size=(0.0867, 0.1, 0.198), mass=0.2, material="plastic",
          aliases=("aero press", "plunger brewer"), themes=("coffee",), roles=("tall",),
          colors=("charcoal",))  # fmt: skip
def aeropress(look: Look) -> Shape:
    """An AeroPress: a plunger in a ribbed cylinder with a flange and a filter cap."""
    k = look.between(0.94, 1.06)
    color = look.color("charcoal", "charcoal", "black", "gray", "clear")
    cap = cylinder(0.032, 0.014, 28, bevel=0.002)
    body = cylinder(0.029, 0.11, 28).move(z=0.012)
    ring = cylinder(0.049, 0.005, 6).move(z=0.03)
    collar = cylinder(0.035, 0.006, 28).move(z=0.118)
    rod_ = cylinder(0.025, 0.07, 28).move(z=0.12)
    top = cylinder(0.033, 0.006, 28, bevel=0.001).move(z=0.188)
    image = prints.canvas(128, 96, tint_color(color, 1.15))
    for n in range(4):
        prints.disc(image, 0.5, 0.2 + 0.2 * n, 0.07, (220, 180, 90), 0.055)
    dark = surfaces.speckles(look.rng, tint_color(color, 0.8), 4)
    return shape([(body, image), (join([cap, ring, collar]), dark),
                  (join([rod_, top]), surfaces.speckles(look.rng, tint_color(color, 1.25), 4))],
                 [hull_of(cap), hull_of(body, collar), hull_of(ring),
                  hull_of(rod_, top)]).scale(k)  # fmt: skip


@category("coffee_tamper", size=(0.0593, 0.0593, 0.0859), mass=0.35, material="metal",
          assembled=True, aliases=("tamper", "espresso tamper"), themes=("coffee",),
          colors=("wooden",))  # fmt: skip
def coffee_tamper(look: Look) -> Shape:
    """A coffee tamper with a heavy steel base and a turned handle."""
    k = look.between(0.94, 1.06)
    color = look.color("wooden", "black", "red", "brown", "silver")
    base = lathe(
        [(0, 0), (0.029, 0), (0.029, 0.011), (0.022, 0.018), (0.01, 0.024), (0, 0.024)], 32
    )
    grip = lathe(np.maximum(smooth([(0, 0.022), (0.009, 0.022), (0.011, 0.034), (0.0185, 0.056),
                 (0.02, 0.07), (0.012, 0.082), (0, 0.084)], 3), 0), 26)  # fmt: skip
    return shape([(base, surfaces.brushed_metal(look.rng, STEEL)), (grip, look.surface(color,
                  "wood"))], [hull_of(base), hull_of(grip)]).scale(k)  # fmt: skip


@category("siphon_brewer", size=(0.158, 0.098, 0.27), mass=1.0, material="metal", assembled=True,
          aliases=("siphon", "coffee siphon", "vacuum brewer", "syphon coffee maker",
          "siphon coffee maker"), themes=("coffee",), roles=("tall",),
          colors=("black",))  # fmt: skip
@vary()
def siphon_brewer(look: Look) -> Shape:
    """A siphon coffee maker with two glass bulbs on a stand over a burner."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "brown", "wooden")
    foot = block(0.13, 0.1, 0.012, 0.02, 0.002)
    post = straight((0.055, 0, 0.01), (0.055, 0, 0.2), 0.0055)
    arm = straight((0.055, 0, 0.165), (0.0, 0, 0.165), 0.005)
    grip = limb([(0.058, 0, 0.19), (0.085, 0, 0.18), (0.088, 0, 0.12), (0.07, 0, 0.09)],
                [0.007] * 4, 8)  # fmt: skip
    low = ball(0.095, 0.095, 0.09, (-0.012, 0, 0.112), 24)
    neck = cylinder(0.016, 0.04, 20).move(-0.012, 0, 0.15)
    top = lathe([(0, 0), (0.02, 0), (0.044, 0.022), (0.047, 0.09), (0.043, 0.09), (0.04, 0.026),
                 (0, 0.008)], 28).move(-0.012, 0, 0.185)  # fmt: skip
    brew = cylinder(0.04, 0.03, 26).move(-0.012, 0, 0.2)
    lamp = lathe([(0, 0), (0.022, 0), (0.024, 0.018), (0.01, 0.03), (0, 0.03)], 22).move(-0.012, 0,
                 0.012)  # fmt: skip
    flame = ball(0.01, 0.01, 0.02, (-0.012, 0, 0.051), 10)
    steel = surfaces.brushed_metal(look.rng, STEEL)
    clear = surfaces.plain(GLASS)
    return shape(
        [
            (foot, look.surface(color, "wood")),
            (join([post, arm, lamp]), steel),
            (grip, look.surface(color, "wood")),
            (
                low,
                surfaces.stack(
                    (surfaces.plain(GLASS), 0.5), (surfaces.plain((236, 240, 240)), 0.5)
                ),
            ),
            (join([neck, top]), clear),
            (brew, surfaces.plain(COFFEE)),
            (flame, surfaces.plain((90, 150, 236))),
        ],
        [
            hull_of(foot),
            hull_of(post, grip),
            hull_of(low),
            hull_of(top, neck),
            hull_of(lamp),
            hull_of(arm),
        ],
    ).scale(k)


@category("cezve", size=(0.175, 0.0766, 0.109), mass=0.25, material="metal", hollow=True,
          aliases=("turkish coffee pot", "ibrik", "briki", "turkish pot"), themes=("coffee",),
          roles=("container",), colors=("copper",))  # fmt: skip
def cezve(look: Look) -> Shape:
    """A small pot for Turkish coffee with a long, rising handle, open at the top."""
    k = look.between(0.92, 1.1)
    color = look.color("copper", "copper", "brass", "silver")
    r, h = 0.038 * k, 0.072 * k
    side = [(0.9 * r, 0), (r, 0.1 * h), (0.86 * r, 0.6 * h), (0.72 * r, 0.84 * h), (0.86 * r, h)]
    body, parts = open_vessel(side, 0.0026, 0.003, 30)
    grip = limb([(0.78 * r, 0, 0.84 * h), (1.6 * r, 0, 1.0 * h), (3.6 * r, 0, 1.45 * h)],
                [0.004, 0.0045, 0.006], 8)  # fmt: skip
    lip = ball(0.018 * k, 0.016 * k, 0.01 * k, (0, -0.84 * r, 0.98 * h), 10)
    brew = cylinder(0.8 * r, 0.0016, 26).move(z=0.55 * h)
    metal = surfaces.brushed_metal(look.rng, color)
    foam = surfaces.spots(look.rng, (96, 58, 34), (150, 104, 64), 0.3)
    pieces: list[tuple[Solid, surfaces.Tile]] = [(join([body, lip]), metal), (grip, look.surface(
        look.own_color("brown", "black"), "wood"))]  # fmt: skip
    if look.attributes.get("state") != "empty":
        pieces.append((brew, foam))
    return shape(pieces, [*parts, hull_of(grip)])


@category("dallah", size=(0.195, 0.122, 0.247), mass=0.7, material="metal", hollow=True,
          aliases=("arabic coffee pot", "arabian coffee pot", "brass coffee pot"),
          themes=("coffee",), roles=("tall",), colors=("gold",))  # fmt: skip
def dallah(look: Look) -> Shape:
    """An Arabic coffee pot with a waisted body, a tall pointed lid and a beak-shaped spout."""
    k = look.between(0.92, 1.08)
    color = look.color("gold", "brass", "silver", "copper")
    body = lathe(np.maximum(smooth([(0, 0), (0.05, 0), (0.056, 0.01), (0.058, 0.05), (0.036, 0.1),
                 (0.03, 0.125), (0.042, 0.155), (0, 0.157)], 3), 0), 30)  # fmt: skip
    lid = lathe(np.maximum(smooth([(0, 0.155), (0.043, 0.155), (0.036, 0.175), (0.014, 0.2), (0.006,
                0.215), (0.009, 0.225), (0.002, 0.245), (0, 0.246)], 3), 0), 26)  # fmt: skip
    spout = limb([(-0.03, 0, 0.1), (-0.062, 0, 0.13), (-0.078, 0, 0.16), (-0.1, 0, 0.168)],
                 [0.017, 0.013, 0.009, 0.004], 10)  # fmt: skip
    grip = limb([(0.032, 0, 0.148), (0.075, 0, 0.15), (0.086, 0, 0.1), (0.055, 0, 0.045)],
                [0.006, 0.007, 0.0065, 0.005], 8)  # fmt: skip
    bands = [torus(r, 0.0022, 28, 6).move(z=z) for r, z in ((0.0585, 0.045), (0.031, 0.122))]
    metal = surfaces.brushed_metal(look.rng, color)
    return shape([(join([body, lid]), metal), (join([spout, grip]), metal),
                  (join(bands), surfaces.plain(tint_color(color, 0.7)))],
                 [hull_of(body), hull_of(lid), hull_of(spout), hull_of(grip)]).scale(k)  # fmt: skip


@category("coffee_pot", size=(0.203, 0.126, 0.196), mass=0.6, material="metal", hollow=True,
          aliases=("percolator", "enamel coffee pot", "coffee percolator", "camping coffee pot",
          "tin coffee pot"), themes=("coffee",), roles=("tall",),
          colors=("silver", "navy"))  # fmt: skip
def coffee_pot(look: Look) -> Shape:
    """A tall enamel or steel coffee pot with a spout, a handle and a lid with a knob."""
    k = look.between(0.92, 1.08)
    color = look.color("silver", "navy", "white", "red", "teal", "copper")
    body = lathe(
        np.maximum(smooth([(0, 0), (0.058, 0), (0.06, 0.008), (0.052, 0.08), (0.042, 0.15), (0.04,
                   0.158), (0, 0.158)], 3), 0), 30)  # fmt: skip
    lid = lathe([(0, 0.156), (0.041, 0.156), (0.039, 0.166), (0.014, 0.178), (0, 0.179)], 26)
    knob = ball(0.02, 0.02, 0.02, (0, 0, 0.186), 14)
    spout = limb([(-0.046, 0, 0.07), (-0.075, 0, 0.1), (-0.084, 0, 0.135), (-0.1, 0, 0.15)],
                 [0.015, 0.011, 0.0085, 0.006], 10)  # fmt: skip
    grip = limb([(0.042, 0, 0.148), (0.085, 0, 0.145), (0.09, 0, 0.09), (0.054, 0, 0.05)],
                [0.0065, 0.007, 0.007, 0.0055], 8)  # fmt: skip
    metal = look.surface(color, "steel" if color[0] > 180 and color[2] > 180 else "plastic")
    dark = surfaces.plain((34, 32, 34))
    return shape(
        [(join([body, lid, spout]), metal), (join([knob, grip]), dark)],
        [hull_of(body), hull_of(lid, knob), hull_of(spout), hull_of(grip)],
    ).scale(k)


def _steel(look: Look) -> surfaces.Tile:
    return surfaces.brushed_metal(look.rng, (196, 199, 204))


@category("coffee_pod", size=(0.04, 0.0402, 0.0277), mass=0.006, material="metal",
          aliases=("coffee capsule", "coffee pad", "espresso capsule", "nespresso capsule"),
          themes=("coffee",), roles=("round",), colors=("gold",))  # fmt: skip
def coffee_pod(look: Look) -> Shape:
    """A coffee capsule with its foil side down."""
    r, h = look.between(0.016, 0.019), look.between(0.025, 0.03)
    color = look.color("gold", "purple", "red", "blue", "green", "brown", "black", "silver")
    body = lathe([(0, 0), (1.12 * r, 0), (1.14 * r, 0.06 * h), (0.98 * r, 0.08 * h),
                  (0.76 * r, 0.72 * h), (0.6 * r, 0.9 * h), (0.3 * r, h), (0, h)], 30)  # fmt: skip
    tile = surfaces.brushed_metal(look.rng, color)
    return shape([(body, tile)], [hull_of(body)])


@category("portafilter", size=(0.21, 0.082, 0.0524), mass=0.5, material="metal",
          aliases=("portafilter handle", "espresso handle", "filter holder"), themes=("coffee",),
          colors=("black",), state="lying flat")  # fmt: skip
def portafilter(look: Look) -> Shape:
    """A portafilter with ground coffee in its basket and its handle on the right."""
    r = look.between(0.032, 0.036)
    color = look.color("black", "wooden", "black", "brown", "white")
    steel = _steel(look)
    cup = lathe([(0, 0.012), (0.5 * r, 0.012), (0.92 * r, 0.02), (r, 0.026), (r, 0.05),
                 (0.9 * r, 0.05), (0.88 * r, 0.046), (0, 0.046)], 32)  # fmt: skip
    lugs = [box(0.012, 0.014, 0.006).move(s * (r + 0.002), 0, 0.042).turn(2, np.pi / 2)
            for s in (-1, 1)]  # fmt: skip
    spouts = [limb([(0, 0, 0.014), (0, s * 0.012, 0.01), (0, s * 0.018, 0.0)],
                   [0.0065, 0.006, 0.0055], 10) for s in (-1, 1)]  # fmt: skip
    puck = cylinder(0.87 * r, 0.003, 30).move(z=0.0445)
    neck = limb([(0.97 * r, 0, 0.038), (r + 0.02, 0, 0.036), (r + 0.035, 0, 0.034)],
                [0.006, 0.006, 0.007], 10)  # fmt: skip
    grip = limb([(r + 0.03, 0, 0.0345), (r + 0.06, 0, 0.028), (r + 0.12, 0, 0.0145),
                 (r + 0.14, 0, 0.0115), (r + 0.143, 0, 0.011)],
                [0.009, 0.0105, 0.0125, 0.0105, 0.005], 14)  # fmt: skip
    grounds = surfaces.spots(look.rng, (62, 38, 26), (40, 24, 16), 0.3)
    return settle([(join([cup, *lugs, *spouts, neck]), steel), (puck, grounds),
                   (grip, look.surface(color, "wood" if look.chance(0.3) else "plastic"))], 0.0,
                  hulls=[[0], [2]])  # fmt: skip


@category("milk_frother", size=(0.223, 0.0295, 0.0311), mass=0.12, material="plastic",
          aliases=("frother", "electric frother", "milk foamer", "handheld frother", "milk warmer"),
          themes=("coffee",), colors=("black",), state="lying flat")  # fmt: skip
def milk_frother(look: Look) -> Shape:
    """A battery-powered milk frother lying flat, with its whisk on the left."""
    long = look.between(0.21, 0.24)
    color = look.color("black", "silver", "white", "red", "copper", "mint")
    grip = limb([(0.02 * long, 0, 0), (0.06 * long, 0, 0), (0.2 * long, 0, 0), (0.46 * long, 0, 0),
                 (0.5 * long, 0, 0)], [0.005, 0.011, 0.0135, 0.0145, 0.009], 18)  # fmt: skip
    rod = tube([(0.03 * long, 0, 0), (-0.47 * long, 0, -0.0045)], 0.0014, 8)
    ring = torus(0.0095, 0.0022, 26, 8).turn(1, np.pi / 2).move(-0.47 * long, 0, -0.0045)
    knob = block(0.018, 0.01, 0.006, 0.004, 0.001).move(0.2 * long, 0, 0.011)
    steel = _steel(look)
    dark = surfaces.plain(tint_color(color, 0.6))
    return settle([(grip, look.surface(color, "plastic")), (join([rod, ring]), steel),
                   (knob, dark)], 0.06, hulls=[[0, 2], [1]])  # fmt: skip


def _spout(start: tuple[float, float], end: tuple[float, float], low: float, top: float) -> Solid:
    """Return a curved spout in the x-z plane on the -x side, with end radii ``low`` and ``top``."""
    (x0, z0), (x1, z1) = start, end
    path = smooth([(x0, 0, z0), (0.5 * (x0 + x1), 0, z0 + 0.25 * (z1 - z0)), (x1, 0, z1)], 4)
    return tube(path, np.linspace(low, top, len(path)), 10)


@category("teapot", size=(0.23, 0.14, 0.145), mass=0.7, material="ceramic", hollow=True,
          aliases=("tea pot", "pot of tea"), themes=("coffee", "dining", "kitchen"),
          colors=("white", "teal", "cream"), common=True)  # fmt: skip
def teapot(look: Look) -> Shape:
    """A round, tall or flat teapot with a spout on the left and a handle on the right or on top."""
    r, h = look.between(0.062, 0.078), look.between(0.1, 0.125)
    color = look.color(*("white", "white", "teal", "cream", "navy", "terracotta", "black", "pink",
                         "sage"), *("mustard", "sky", "brown", "red"))  # fmt: skip
    kind, bail = look.pick(["round", "round", "pear", "drum"]), look.chance(0.22)
    glaze, side = glaze_tile(look, color), look.surface(color, "ceramic")
    t = np.linspace(-1.0, 1.05, 12)
    lift = 0.5 + 0.5 * np.sin(t) / np.sin(1.05)
    swell = {"round": np.cos(t), "pear": np.cos(0.92 * t + 0.28) * (1 - 0.12 * lift),
             "drum": np.cos(t) ** 0.45 * (0.97 - 0.2 * lift)}[kind]  # fmt: skip
    wall = np.column_stack([r * swell, h * lift])
    wall[:, 1] = np.maximum(wall[:, 1] - wall[0, 1], 0)
    top = float(wall[-1, 1])
    body = lathe([(0, 0), *wall, (0, top)], v=[0, *np.linspace(0.02, 0.98, 12), 1])
    rim = min(0.92 * float(wall[-1, 0]), 0.6 * r)
    knob = look.between(0.008, 0.013)
    lid = lathe(
        [(0, top), (rim, top), (rim, top + 0.003), (0.6 * rim, top + 0.011), (0.007, top + 0.015),
         (0.006, top + 0.019), (knob, top + 0.025), (0.7 * knob, top + 0.033), (0, top + 0.034)],
        28,
    )  # fmt: skip
    low = float(np.interp(0.3 * top, wall[:, 1], wall[:, 0]))
    spout = _spout((-low + 0.012, 0.3 * top), (-low - 0.65 * r, 0.95 * top), 0.017, 0.0085)
    back = [np.interp(z * top, wall[:, 1], wall[:, 0]) - 0.004 for z in (0.86, 0.2)]
    grip = look.surface(look.pick([color, (150, 108, 66), (44, 44, 48)]), "plastic")
    if bail:
        curve = arc((0, 0), 1.0, 0.12 * np.pi, 0.88 * np.pi, 14)
        path = np.column_stack([0.98 * r * curve[:, 0], 0 * curve[:, 0],
                                0.35 * top + 1.15 * top * curve[:, 1]])  # fmt: skip
        ear = tube(path, 0.0055, 8)
        parts = [box_part(r, 0.011, 0.014, (0, 0, float(path[:, 2].max()) - 0.01))]
    else:
        ear = tube(
            smooth([(back[0], 0, 0.86 * top), (1.4 * r, 0, 0.92 * top), (1.62 * r, 0, 0.6 * top),
                    (1.38 * r, 0, 0.25 * top), (back[1], 0, 0.2 * top)], 4), 0.0065, 8,
        )  # fmt: skip
        parts = [box_part(0.72 * r, 0.013, 0.7 * top, (1.26 * r, 0, 0.2 * top))]
    ring = wall[:, 1]
    return shape(
        [(body, glaze), (lid, side), (spout, side), (ear, grip if bail else side)],
        [hull_part(body.vertices[body.vertices[:, 2] <= ring[5] + 1e-6]),
         hull_part(body.vertices[body.vertices[:, 2] >= ring[5] - 1e-6]),
         hull_of(lid), hull_of(spout), *parts],
    )  # fmt: skip


@category("french_press", size=(0.14, 0.105, 0.225), mass=0.6, material="glass", hollow=True,
          aliases=("coffee press", "cafetiere"), themes=("coffee", "kitchen"), roles=("tall",),
          colors=("silver", "black"), common=True)  # fmt: skip
def french_press(look: Look) -> Shape:
    """A French press: a glass beaker of coffee in a metal frame, with a plunger and a handle."""
    r, h = look.between(0.045, 0.052), look.between(0.15, 0.175)
    level = look.between(0.45, 0.75)
    coffee, clear = surfaces.plain((62, 38, 26)), surfaces.plain((206, 218, 220))
    metal = surfaces.brushed_metal(
        look.rng, look.color("silver", "black", "copper", "gold", "white", "red", "teal")
    )
    dark = surfaces.speckles(look.rng, (44, 44, 48), 3, 32)
    body = lathe([(0, 0.01), (r, 0.01), (r, h), (0, h)], v=[0, 0.01, 0.99, 1])
    tile = surfaces.stack((coffee, level), (clear, 1 - level), side=64)
    rings = [lathe([(0.98 * r, z), (1.03 * r, z), (1.03 * r, z + t), (0.98 * r, z + t)], loop=True)
             for z, t in ((0.004, 0.014), (0.5 * h, 0.006), (0.88 * h, 0.008))]  # fmt: skip
    bars = [box(0.007, 0.003, 0.9 * h).move(y=-1.02 * r).turn(2, np.pi / 2 * k + np.pi / 4)
            for k in range(4)]  # fmt: skip
    lid = lathe([(0, h), (1.05 * r, h), (1.02 * r, h + 0.01), (0.4 * r, h + 0.018), (0, h + 0.018)])
    rod = cylinder(0.0025, 0.03, 10).move(z=h + 0.014)
    knob = ellipsoid(0.018, 0.018, 0.018, 16, 10).move(z=h + 0.05)
    grip = tube(
        smooth([(1.0 * r, 0, 0.9 * h), (1.65 * r, 0, 0.88 * h), (1.8 * r, 0, 0.6 * h),
                (1.65 * r, 0, 0.2 * h), (1.0 * r, 0, 0.16 * h)], 4), 0.0075, 8,
    )  # fmt: skip
    foot = cylinder(1.03 * r, 0.01, 32, bevel=0.001)
    return shape(
        [(body, tile), (foot, metal), *((s, metal) for s in (*rings, *bars)), (lid, metal),
         (rod, metal), (knob, dark), (grip, dark)],
        [cylinder_part(1.03 * r, h), hull_of(lid), cylinder_part(0.007, 0.042, (0, 0, h + 0.016)),
         box_part(0.8 * r, 0.014, 0.75 * h, (1.42 * r, 0, 0.15 * h))],
    )  # fmt: skip
