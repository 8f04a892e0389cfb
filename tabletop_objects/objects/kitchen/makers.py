"""Objects of the ``kitchen`` theme: machines that make food and drinks."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import steel
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import drum, facing, side_view, standing
from ...kit.shapes import Shape, category, put_down, shape, vary
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from .appliances import metal
from .grills import _panel, turn_knob

BODY = ("black", "silver", "white", "red", "cream", "mint", "charcoal")
DARK = (36, 37, 40)


@category("waffle_iron", size=(0.202, 0.272, 0.278), mass=2.2, material="device",
          aliases=("waffle maker",), themes=("kitchen",), roles=("big",),
          colors=("black", "silver"))  # fmt: skip
def waffle_iron(look: Look) -> Shape:
    """A round waffle iron with its lid raised above a waffle pattern."""
    r = look.between(0.095, 0.11)
    color = look.color(*BODY)
    skin = look.surface(color, "metal")
    base = cylinder(r, 0.045, 36, bevel=0.006)
    plate = cylinder(0.88 * r, 0.004, 34).move(z=0.043)
    ribs = []
    for k in range(7):
        at = (k / 6 - 0.5) * 1.5 * r
        long = 2 * np.sqrt(max((0.86 * r) ** 2 - at * at, 0))
        bar = box(long, 0.006, 0.004)
        ribs += [bar.move(y=at, z=0.046), bar.turn(2, np.pi / 2).move(x=at, z=0.046)]
    iron = surfaces.plain((70, 70, 74))
    inside = join([plate, *ribs])
    up = np.deg2rad(72)
    lid = cylinder(r, 0.04, 36, bevel=0.008).move(y=-r)
    face = inside.move(y=-r, z=-0.05)
    grip = box(0.07, 0.03, 0.014).move(y=-2 * r - 0.012, z=0.012)
    raised = [s.turn(0, -up).move(y=0.99 * r + 0.008, z=0.052) for s in (lid, face, grip)]
    hinge = box(0.08, 0.03, 0.06).move(y=r)
    front = box(0.07, 0.03, 0.014).move(y=-r - 0.012, z=0.024)
    dark = surfaces.plain(DARK)
    return shape([(base, skin), (inside, iron), (raised[0], skin), (raised[1], iron),
                  (join([raised[2], hinge, front]), dark)],
                 [cylinder_part(r, 0.045), hull_of(raised[0]), hull_of(raised[2]), hull_of(hinge),
                  hull_of(front)])  # fmt: skip


@category("coffee_machine", size=(0.217, 0.233, 0.341), mass=2.4, material="device",
          aliases=("coffee maker", "drip coffee maker", "filter coffee machine", "coffeemaker",
          "drip coffee machine"), themes=("kitchen", "coffee"), roles=("big", "tall"),
          colors=("black",))  # fmt: skip
def coffee_machine(look: Look) -> Shape:
    """A filter coffee machine: a glass pot on a hot plate under a filter, and a water tank."""
    x, y, h = look.between(0.19, 0.22), look.between(0.22, 0.25), look.between(0.32, 0.36)
    color = look.color("black", "silver", "white", "red", "cream", "charcoal")
    skin = look.surface(color, "plastic")
    base = block(x, y, 0.12 * h, 0.03, 0.004)
    back = block(x, 0.36 * y, h, 0.03, 0.006).move(y=0.32 * y)
    head = block(x, 0.96 * y, 0.26 * h, 0.04, 0.008).move(y=0.01 * y, z=0.74 * h)
    cone = cylinder(0.24 * x, 0.1 * h, 24, top=0.34 * x).move(y=-0.17 * y, z=0.655 * h)
    r = 0.33 * x
    z = 0.12 * h
    plate = cylinder(1.02 * r, 0.004, 30).move(y=-0.17 * y, z=z - 0.001)
    pot = lathe([(0, 0), (0.86 * r, 0), (r, 0.12 * h), (0.96 * r, 0.26 * h), (0.66 * r, 0.42 * h),
                 (0.7 * r, 0.46 * h), (0, 0.46 * h)], 30).move(y=-0.17 * y, z=z
                                                               + 0.002)  # fmt: skip
    ear = tube(smooth([(0.6 * r, -0.17 * y, z + 0.42 * h), (1.5 * r, -0.17 * y, z + 0.42 * h),
                       (1.5 * r, -0.17 * y, z + 0.16 * h), (1.25 * r, -0.17 * y, z + 0.12 * h)], 4),
               0.008, 8).turn(2, 0.0)  # fmt: skip
    top = cylinder(0.72 * r, 0.02 * h, 24).move(y=-0.17 * y, z=z + 0.46 * h)
    light = box(0.02, 0.001, 0.01).move(0.3 * x, -y / 2, 0.05 * h)
    coffee = surfaces.stack((surfaces.plain((60, 34, 20)), 42), (surfaces.plain(
        (196, 208, 214)), 58))  # fmt: skip
    dark = surfaces.plain(DARK if sum(color) > 200 else (96, 98, 102))
    return shape([(join([base, back, head]), skin), (join([cone, plate, ear, top]), dark),
                  (pot, coffee), (light, surfaces.plain((230, 60, 40)))],
                 [box_part(x, y, 0.12 * h), hull_of(back), hull_of(head), hull_of(cone),
                  hull_of(pot), hull_of(ear)])  # fmt: skip


@category("pasta_machine", size=(0.27, 0.175, 0.157), mass=2.5, material="device",
          aliases=("pasta maker", "pasta roller", "noodle maker"), themes=("kitchen",),
          roles=("big",), colors=("silver",))  # fmt: skip
@vary()
def pasta_machine(look: Look) -> Shape:
    """A pasta machine with chrome sides, rollers, a dial, a crank and a sheet of dough."""
    k, color = look.between(0.9, 1.06), look.color("silver", "silver", "red", "black")
    cheeks = [side_view(np.array([(-0.055, 0), (0.055, 0), (0.05, 0.09), (0.03, 0.125),
                                  (-0.03, 0.125), (-0.05, 0.1)]), 0.014)
              .turn(2, np.pi / 2).move(x=s * 0.085) for s in (-1, 1)]  # fmt: skip
    rollers = [
        cylinder(0.017, 0.16, 22).turn(1, np.pi / 2).move(-0.08, y, 0.1) for y in (-0.018, 0.018)
    ]
    tray = box(0.16, 0.09, 0.006).turn(0, 0.35).move(0, -0.045, 0.04)
    foot = [box(0.19, 0.03, 0.012).move(y=y) for y in (-0.045, 0.045)]
    dial = cylinder(0.02, 0.02, 20).turn(1, -np.pi / 2).move(-0.09, 0, 0.075)
    crank = tube(
        [(0.09, 0, 0.08), (0.115, 0, 0.08), (0.118, 0, 0.15), (0.125, 0, 0.152)], 0.0045, 8
    )
    grip = (lathe([(0, 0), (0.01, 0.002), (0.012, 0.03), (0.009, 0.05), (0, 0.05)],
                  16).turn(1, np.pi / 2).move(0.122, 0, 0.152))  # fmt: skip
    dough = box(0.13, 0.11, 0.0022).turn(0, 0.55).move(0, -0.075, 0.038)
    made = [(join([*cheeks, *foot]), look.surface(color, "chrome")),
            (join([*rollers, tray, crank]), metal(look)), (join([dial, grip]),
                                                            surfaces.plain((30, 30, 34))),
            (dough, surfaces.speckles(look.rng, (244, 222, 150), 8))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(crank.scale(k, k, k), grip.scale(k, k, k)),
                        hull_of(made[3][0])])  # fmt: skip


BREAD_MAKER_BODY = ("white", "black", "silver", "red", "cream", "gray", "mint")
INK: RGB = (34, 36, 40)


@category("bread_maker", size=(0.307, 0.211, 0.279), mass=5.0, material="device",
          aliases=("breadmaker", "bread machine", "bread baker"), themes=("kitchen",),
          roles=("big",), colors=("white", "black"))  # fmt: skip
def bread_maker(look: Look) -> Shape:
    """A bread maker: a tall, rounded box with a window in its lid and a control panel."""
    k, color = look.between(0.88, 1.05), look.color(*BREAD_MAKER_BODY)
    x, y, h = 0.32 * k, 0.22 * k, 0.26 * k
    body, lid = (block(x, y, h, 0.04 * k, 0.004), block(0.7 * x, 0.9 * y, 0.03 * k, 0.03 * k,
                                                        0.008).move(-0.12 * x, 0, h))  # fmt: skip
    window = box(0.3 * x, 0.4 * y, 0.001).move(-0.12 * x, 0, h + 0.03 * k - 0.0004)
    panel = box(0.2 * x, 0.7 * y, 0.002).move(0.36 * x, 0, h - 0.0005)
    grip = box(0.2 * x, 0.012, 0.012).move(-0.12 * x, -0.46 * y, h + 0.008 * k)
    slots = [box(0.001, 0.3 * y, 0.004).move(x / 2, 0, 0.3 * h + 0.012 * n) for n in range(4)]
    tile = look.surface(color, "plastic")
    return shape([(body, tile), (lid, surfaces.speckles(look.rng, tint_color(color, 0.9), 3)),
                  (window, surfaces.plain((70, 60, 54))),
                  (panel, _panel(look, 48, 128)), (join([grip, *slots]), surfaces.plain(INK))],
                  [box_part(x, y, h), hull_of(lid)])  # fmt: skip


@category("crepe_maker", size=(0.348, 0.322, 0.075), mass=1.3, material="device",
          aliases=("pancake maker", "tortilla maker", "crepe pan", "electric crepe maker",
          "roti maker"), themes=("kitchen",), roles=("big", "round"),
          colors=("black",))  # fmt: skip
def crepe_maker(look: Look) -> Shape:
    """A crepe maker: a wide, black disc on a low base with a thin crepe and a wooden spreader."""
    k, color = (look.between(0.9, 1.1), look.color("black", "red", "silver", "white", "cream",
                                                   "teal"))  # fmt: skip
    r = 0.16 * k
    base = lathe([(0, 0), (0.8 * r, 0), (0.95 * r, 0.03), (r, 0.045), (0, 0.045)], 36)
    plate = cylinder(0.99 * r, 0.012, 40, bevel=0.003).move(z=0.045)
    crepe = cylinder(0.78 * r, 0.0015, 34).move(z=0.057)
    tee = [tube([(0.1 * r, -0.1 * r, 0.064), (1.15 * r, -0.5 * r, 0.07)], 0.005, 8),
           tube([(-0.02 * r, -0.42 * r, 0.063), (0.22 * r, 0.2 * r, 0.063)], 0.006, 8)]  # fmt: skip
    lamp = [box(0.012, 0.004, 0.008).move(0.02 * s, -0.93 * r, 0.018) for s in (-1, 1)]
    return shape([(base, look.surface(color, "plastic")), (plate, surfaces.plain((44, 44, 48))),
                  (crepe, surfaces.spots(look.rng, (236, 206, 140), (206, 156, 84), 0.2)),
                  (join(tee), surfaces.wood(look.rng, (206, 168, 112))),
                  (join(lamp), surfaces.plain((226, 60, 50)))], [hull_of(base, plate),
                      hull_of(*tee)])  # fmt: skip


STEEL: RGB = (190, 194, 200)


@category("candyfloss_machine", size=(0.273, 0.273, 0.213), mass=1.4, material="device",
          aliases=("candy floss machine", "cotton candy machine", "cotton candy maker",
          "candyfloss maker"), themes=("kitchen",), roles=("big", "round"),
          colors=("red",))  # fmt: skip
def candyfloss_machine(look: Look) -> Shape:
    """A candyfloss machine: a wide bowl with a spinner on a base, and pink floss on a stick."""
    k, color = look.between(0.88, 1.05), look.color("red", "pink", "sky", "white")
    base = lathe([(0, 0), (0.1, 0), (0.095, 0.02), (0.08, 0.1), (0, 0.1)], 28)
    bowl = lathe([(0, 0.1), (0.1, 0.1), (0.14, 0.15), (0.142, 0.17), (0.134, 0.17), (0.1, 0.112),
                  (0, 0.112)], 36)  # fmt: skip
    spin = lathe([(0, 0.11), (0.03, 0.11), (0.028, 0.14), (0.012, 0.146), (0, 0.146)], 20)
    floss = [ellipsoid(0.06, 0.056, 0.05, 10, 7).move(0.055 * np.cos(a), 0.055 * np.sin(a), 0.165
                                                      + 0.016 * (n % 3)) for n,
             a in enumerate(np.arange(8) * 0.8)]  # fmt: skip
    made = [(base, look.surface(color, "plastic")),
            (bowl, surfaces.speckles(look.rng, tint_color(color, 1.4), 3)),
            (spin, surfaces.brushed_metal(look.rng, STEEL)),
            (join(floss), surfaces.scratches(look.rng, (244, 178, 206), (252, 212, 228), 200)),
            (turn_knob(0.014, 0, -0.086, 0.05), surfaces.plain((250, 250, 246)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0]), hull_of(made[3][0])])


SODA_MAKER_STEEL: RGB = (190, 194, 200)


@category("yoghurt_maker", size=(0.245, 0.254, 0.118), mass=1.3, material="device",
          aliases=("yogurt maker", "yoghurt machine", "yogurt machine"), themes=("kitchen",),
          roles=("round",), colors=("white",))  # fmt: skip
def yoghurt_maker(look: Look) -> Shape:
    """A yoghurt maker: a round base with small jars under a clear cover."""
    k, color = look.between(0.9, 1.1), look.color("white", "gray", "mint", "sky", "pink")
    r = 0.115 * k
    base = lathe([(0, 0), (0.96 * r, 0), (r, 0.01), (r, 0.055), (0.94 * r, 0.06), (0, 0.06)], 36)
    places = [(0.0, 0.0), *[(0.63 * r * np.cos(a), 0.63 * r * np.sin(a)) for a in np.pi / 3
                            * np.arange(6)]]  # fmt: skip
    jars = [cylinder(0.25 * r, 0.05, 16).move(x, y, 0.058) for x, y in places]
    lids = [cylinder(0.27 * r, 0.014, 16).move(x, y, 0.104) for x, y in places]
    rim = torus(0.98 * r, 0.004, 36, 6).move(z=0.06)
    hue = look.own_color("sky", "pink", "lime", "red", "purple")
    return shape([(base, look.surface(color, "plastic")),
                  (join(jars), surfaces.plain((246, 244, 238))), (join(lids), surfaces.plain(hue)),
                  (rim, surfaces.plain(tint_color(color, 0.8))),
                  (turn_knob(0.012, 0, -0.99 * r, 0.03),
                      surfaces.plain((90, 94, 100)))],
                 [hull_of(base), hull_of(*jars, *lids)])  # fmt: skip


@category("popcorn_maker", size=(0.199, 0.173, 0.313), mass=1.8, material="device",
          aliases=("popcorn machine", "popcorn popper"), themes=("kitchen",), roles=("big",),
          colors=("red",))  # fmt: skip
def popcorn_maker(look: Look) -> Shape:
    """The cabinet of a popcorn cart, with popcorn behind windows and a striped, peaked roof."""
    k, color = look.between(0.85, 1.05), look.color("red", "red", "crimson", "navy", "yellow")
    x, y, h = 0.2 * k, 0.17 * k, 0.22 * k
    base = block(x, y, 0.05 * k, 0.008, 0.002)
    posts = [box(0.01, 0.01, h).move(i * (x / 2 - 0.006), j * (y / 2 - 0.006), 0.05 * k)
             for i in (-1, 1) for j in (-1, 1)]  # fmt: skip
    roof = block(1.04 * x, 1.04 * y, 0.014, 0.008).move(z=h + 0.05 * k)
    peak = (prism(np.array([(-0.5 * x, 0), (0.5 * x, 0), (0.3 * x, 0.045 * k),
                            (-0.3 * x, 0.045 * k)]), -0.45 * y, 0.45
                  * y).turn(0, np.pi / 2).move(z=h + 0.05 * k + 0.012))  # fmt: skip
    image = surfaces.stack((surfaces.spots(look.rng, (250, 240, 200), (226, 190, 110), 0.2), 0.4),
                           (surfaces.plain((206, 222, 228)), 0.6))  # fmt: skip
    glass = box(0.95 * x, 0.95 * y, h).move(z=0.05 * k)
    heap = [ellipsoid(0.02, 0.019, 0.018, 6, 4).move(0.35 * x * np.cos(2.4 * n) * np.sqrt(n / 20),
                                                     -y / 2 + 0.002, 0.08 * k + 0.0035 * k
                                                     * (20 - n)) for n in range(20)]  # fmt: skip
    sign = prints.canvas(160, 48, (250, 240, 210))
    prints.write(sign, "POPCORN", 0.5, 0.5, 0.5, color, bold=True)
    board = box(0.8 * x, 0.002, 0.04 * k).move(y=-0.505 * y, z=0.005 * k)
    front = box(0.62 * x, 0.002, 0.034 * k).move(y=-0.47 * y, z=h + 0.066 * k)
    tile = look.surface(color, "plastic")
    return shape([(join([base, *posts, roof, peak]), tile), (glass, image),
                  (join(heap), surfaces.plain((250, 236, 190))), (board, sign), (front, sign)],
                 [hull_of(base), hull_of(glass), hull_of(roof, peak)])  # fmt: skip


@category("ice_cream_maker", size=(0.212, 0.203, 0.259), mass=2.2, material="device",
          aliases=("ice cream machine", "gelato maker", "sorbet maker", "frozen yogurt maker"),
          themes=("kitchen",), roles=("big", "round"), colors=("white",))  # fmt: skip
def ice_cream_maker(look: Look) -> Shape:
    """An ice cream maker: a round tub with a clear lid and a motor on top."""
    k, color = (look.between(0.9, 1.08), look.color("white", "cream", "pink", "mint", "silver",
                                                    "red"))  # fmt: skip
    r, h = 0.1 * k, 0.17 * k
    tub = lathe([(0, 0), (0.9 * r, 0), (r, 0.02), (r, h), (0, h)], 34)
    lid = lathe([(0, 0), (0.97 * r, 0), (0.86 * r, 0.035 * k), (0, 0.04 * k)], 34).move(z=h)
    motor = block(0.1 * k, 0.07 * k, 0.05 * k, 0.02 * k, 0.008).move(z=h + 0.036 * k)
    arms = box(2.1 * r, 0.03 * k, 0.02 * k).move(z=h + 0.038 * k)
    cone = [prism([(0, -0.03), (0.014, 0), (-0.014, 0)], 0, 0.0012),
            cylinder(0.014, 0.0013, 16).move(0, 0.006)]  # fmt: skip
    marks = [facing(s).scale(k, 1, k).move(y=-1.0 * r, z=0.55 * h) for s in cone]
    return shape([(tub, look.surface(color, "plastic")), (lid, surfaces.plain((214, 226, 232))),
                  (join([motor, arms]), surfaces.speckles(look.rng, tint_color(color, 0.75), 3)),
                  (marks[0], surfaces.plain((206, 150, 84))), (marks[1],
                      surfaces.plain((236, 150, 170))),
                      (turn_knob(0.01, 0, -0.034 * k, h + 0.06 * k),
                                                         surfaces.plain((90, 94, 98)))],
                 [hull_of(tub), hull_of(lid), hull_of(motor, arms)])  # fmt: skip


@category("soda_maker", size=(0.115, 0.192, 0.395), mass=1.3, material="device",
          aliases=("sodastream", "soda stream", "soda machine", "carbonator",
          "sparkling water maker"), themes=("kitchen",), roles=("tall", "big"),
          colors=("black",))  # fmt: skip
def soda_maker(look: Look) -> Shape:
    """A soda maker: a tall, arched body with a lever and a clear bottle under its head."""
    k, color = look.between(0.9, 1.06), look.color("black", "white", "red", "silver", "sky")
    h = 0.4 * k
    foot = block(0.12 * k, 0.2 * k, 0.02, 0.05 * k, 0.004)
    spine = block(0.1 * k, 0.07 * k, 0.92 * h, 0.03 * k, 0.008).move(y=0.055 * k, z=0.015)
    head = block(0.11 * k, 0.17 * k, 0.11 * h * 1.6, 0.04 * k, 0.012).move(y=0.005 * k, z=0.82 * h)
    r = 0.036 * k
    bottle = lathe(
        [(0, 0), (r, 0), (r, 0.18 * k), (0.4 * r, 0.26 * k), (0.4 * r, 0.31 * k), (0, 0.31 * k)], 24
    ).move(y=-0.045 * k, z=0.02)
    lever = block(0.03 * k, 0.06 * k, 0.012, 0.006).move(0, -0.04 * k, 0.82 * h + 0.176 * h)
    return shape([(join([foot, spine, head]), look.surface(color, "plastic")),
                  (bottle, surfaces.gradient((176, 214, 232), (222, 236, 242), look.rng)),
                  (lever, surfaces.brushed_metal(look.rng, SODA_MAKER_STEEL))], [hull_of(foot),
                      hull_of(spine), hull_of(head, lever), hull_of(bottle)])  # fmt: skip


@category("tortilla_press", size=(0.2, 0.272, 0.211), mass=1.5, material="metal",
          aliases=("roti press",), themes=("kitchen",), roles=("big",),
          colors=("black",))  # fmt: skip
def tortilla_press(look: Look) -> Shape:
    """A tortilla press: two hinged round plates with a lever and a ball of dough."""
    k, color = look.between(0.88, 1.06), look.color("black", "silver", "red", "gray")
    low = cylinder(0.1, 0.014, 34, bevel=0.002).move(z=0.008)
    feet = [cylinder(0.012, 0.01, 12).move(0.07 * np.cos(a), 0.07 * np.sin(a), 0)
            for a in np.arange(4) * 1.57 + 0.8]  # fmt: skip
    up = [
        s.turn(0, -1.0).move(y=0.1, z=0.03)
        for s in (
            cylinder(0.1, 0.012, 34, bevel=0.002).move(y=-0.1),
            box(0.02, 0.2, 0.01).move(0, -0.1, 0.012),
        )
    ]
    hinge = box(0.05, 0.02, 0.03).move(y=0.105, z=0.006)
    lever = (tube([(0, -0.1, 0.018), (0, -0.135, 0.03), (0, -0.2, 0.034)], 0.0085,
                  9).turn(2, np.pi).move(0, -0.03, 0.0))  # fmt: skip
    dough = ellipsoid(0.05, 0.05, 0.024, 16, 9).move(z=0.03)
    made = [
        (join([low, *up, hinge]), look.surface(color, "iron" if sum(color) < 300 else "plastic")),
        (join([*feet, lever]), surfaces.plain((36, 36, 40))),
        (dough, surfaces.speckles(look.rng, (244, 228, 176), 8)),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(*[s.scale(k, k, k) for s in (low, *feet)]),
                        hull_of(*[s.scale(k, k, k) for s in up]),
                        hull_of(lever.scale(k, k, k))])  # fmt: skip


@category("butter_churn", size=(0.129, 0.129, 0.284), mass=0.9, material="wood",
          aliases=("churn", "milk churn"), themes=("kitchen",), roles=("tall",),
          colors=("wooden",))  # fmt: skip
def butter_churn(look: Look) -> Shape:
    """A butter churn: a wooden tub with hoops and a plunger through its lid."""
    color = look.color("wooden", "tan", "brown")
    k = look.between(0.8, 1.05)
    tub = standing((0.07, 0), (0.056, 0.18), (0.054, 0.18), sides=20)
    hoops = [standing((r, 0), (r - 0.0012, 0.014), at=(0, 0, z), sides=20) for r,
             z in ((0.0705, 0.02), (0.0645, 0.09), (0.0595, 0.15))]  # fmt: skip
    lid, stick = drum(0.058, 0.014, (0, 0, 0.178)), drum(0.008, 0.12, (0, 0, 0.19), sides=12)
    staves = surfaces.stripes(
        [color, tint_color(color, 0.82), tint_color(color, 1.12)], 6, upright=True
    )
    return put_down([(tub, staves), (join(hoops), steel(look, (120, 110, 100))),
                     (join([lid, stick]), surfaces.wood(look.rng, color))], tub, lid, stick,
                    factor=k)  # fmt: skip
