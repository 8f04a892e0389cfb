"""Objects of the ``toys`` theme: weapons."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, metal, plastic, shine, wood
from ...kit.outlines import smooth
from ...kit.parts import hull_of
from ...kit.primitives import at_block, at_box, ball, disc, plate, rod, spindle, standing, straight
from ...kit.shapes import Category, Drawing, Pieces, Shape, category, from_pieces, shape
from ...kit.solids import block, join, torus, tube
from ...kit.surfaces import Look

BLACK = surfaces.plain((34, 34, 37))


def _gun(tank: bool, colors: tuple[str, ...]) -> Drawing:
    """A bright toy gun lying on its side, with an orange tip or a water tank."""

    def draw(look: Look) -> Pieces:
        tile, other = plastic(look, *colors), dye(look, "orange", "yellow", "black")
        side = np.array([(-0.08, 0.0), (0.07, 0.0), (0.07, 0.034), (-0.075, 0.038)])
        frame = plate(side, 0.028)
        grip = plate(
            [(-0.075, -0.07), (-0.04, -0.075), (-0.025, 0.005), (-0.078, 0.01)], 0.026, 0.001
        )
        barrel = straight((0.06, 0.018, 0.0145), (0.115, 0.018, 0.0145), 0.01, 14)
        tip = straight((0.105, 0.018, 0.0145), (0.125, 0.018, 0.0145), 0.013, 14)
        guard = rod([(-0.028, -0.002, 0.014), (-0.02, -0.028, 0.014), (0.01, -0.026, 0.014),
                     (0.016, 0.002, 0.014)], 0.0035, 6)  # fmt: skip
        trigger = at_block(0.006, 0.018, 0.008, 0.002, (-0.008, -0.01, 0.01))
        pieces: Pieces = [(frame, tile), (grip, tile), (barrel, other), (tip, other),
                          (join([guard, trigger]), other)]  # fmt: skip
        if tank:
            pieces.append((spindle((-0.05, 0.012), (-0.045, 0.02), (0.0, 0.02), (0.006, 0.012),
                                   z=0.0205).move(y=0.056),
                           surfaces.plain((150, 206, 236))))  # fmt: skip
            pieces.append((at_block(0.02, 0.014, 0.016, 0.004, (-0.022, 0.04, 0.006)), other))
        else:
            lines = [
                at_box(0.004, 0.022, 0.001, (-0.05 + 0.012 * k, 0.018, 0.0276)) for k in range(4)
            ]
            stripe = at_box(0.06, 0.008, 0.001, (0.03, 0.018, 0.0276))
            pieces += [(join(lines), BLACK), (stripe, other)]
        return pieces

    return draw


@category("toy_shield", size=(0.2, 0.26, 0.0235), mass=0.4, material="wood",
          aliases=("shield", "wooden shield", "knight shield", "medieval shield", "mini shield"),
          themes=("toys",), roles=("big",), colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=2)
def toy_shield(look: Look) -> Pieces:
    """A heater shield lying flat, with a rim, a quartered field and a boss."""
    a, b = (
        look.color("red", "blue", "wooden", "green", "purple"),
        look.own_color("white", "gold", "yellow", "silver"),
    )
    outline = np.concatenate([[(-0.1, 0.12), (-0.1, 0.0)], smooth([(-0.1, 0.0), (-0.085, -0.06),
                                                                   (-0.045, -0.11), (0, -0.14)],
                                                                  5)[1:],
                              smooth([(0, -0.14), (0.045, -0.11), (0.085, -0.06), (0.1, 0.0)],
                                     5)[1:], [(0.1, 0.12)]])  # fmt: skip
    image = prints.canvas(96, 124, a)
    prints.fill(image, 0.5, 0, 0.5, 0.46, b)
    prints.fill(image, 0, 0.46, 0.5, 0.54, b)
    wooden = look.attributes.get("material", "").startswith("wood") or look.chance(0.25)
    field = surfaces.wood(look.rng, a) if wooden else image
    body, front = plate(outline, 0.012), plate(0.92 * outline + [0, -0.001], 0.002, 0.011)
    boss = ball(0.044, 0.044, 0.02, (0, 0.01, 0.013), 18)
    studs = [disc(0.0045, 0.003, (x, y, 0.0115), sides=10) for x,
             y in ((-0.094, 0.113), (0.094, 0.113), (0, 0.114), (-0.094, 0.03), (0.094, 0.03),
                   (0, -0.13), (-0.06, -0.087), (0.06, -0.087))]  # fmt: skip
    return [(body, shine(look, "silver", "gold", "bronze")), (boss, shine(look, "silver", "gold")),
            (front, field), (join(studs), shine(look, "silver", "gold"))]  # fmt: skip


def _blade(bend: float, long: float, wide: float, guard: str) -> Drawing:
    """A sword, cutlass or dagger lying flat: a blade, a guard, a grip and a pommel."""

    def draw(look: Look) -> Pieces:
        steel = look.surface(look.color("silver", "gray", "wooden" if guard == "toy" else "silver"),
                             "metal" if guard != "toy" else "wood")  # fmt: skip
        z = 0.008
        t = np.linspace(0, 1, 14)
        mid = np.column_stack([long * t, bend * t**2])
        half = 0.5 * wide * np.where(t < 0.75, 1, np.maximum((1 - t) / 0.25, 0.02) ** 0.7)
        outline = np.concatenate(
            [mid + np.column_stack([0 * t, -half]), (mid + np.column_stack([0 * t, half]))[::-1]]
        )
        edge = plate(outline, 0.003, z - 0.0015)
        ridge = plate(np.concatenate([np.add(mid[:11], (0, -0.12 * wide)),
                                      np.add(mid[:11], (0, 0.12 * wide))[::-1]]), 0.005, z
                      - 0.0025)  # fmt: skip
        gold = shine(look, "gold", "brass", "silver")
        cross = at_block(
            0.012, 0.085 if guard != "cut" else 0.05, 0.014, 0.005, (-0.004, 0, z - 0.007)
        )
        grip = spindle((-0.085, 0.007), (-0.045, 0.0085), (-0.008, 0.007), z=z)
        end = ball(0.02, 0.02, 0.016, (-0.092, 0, z), 14)
        foot = at_box(0.4 * long, 0.5 * wide, z, (0.42 * long, bend * 0.18, 0))
        pieces: Pieces = [(edge, steel), (cross, gold), (grip, dye(look, "brown", "black",
                                                                   "maroon")), (end, gold),
                          (foot, steel), (ridge, steel)]  # fmt: skip
        if guard == "cut":
            bow = rod([(0.0, -0.022, z), (-0.03, -0.045, z), (-0.075, -0.036, z), (-0.094, 0, z)],
                      0.0035, 8, 5)  # fmt: skip
            pieces.append((bow, gold))
        if guard == "gem":
            gems = [ball(0.009, 0.009, 0.007, p, 8) for p in ((-0.004, 0, z + 0.007),
                                                              (-0.004, 0.026, z + 0.007),
                                                              (-0.004, -0.026, z + 0.007),
                                                              (-0.092, 0, z + 0.008))]  # fmt: skip
            pieces.append((join(gems), dye(look, "crimson", "green", "blue")))
        return pieces

    return draw


TOY_CANNON_BLACK = surfaces.plain((34, 34, 37))


@category("toy_cannon", size=(0.189, 0.0943, 0.0989), mass=0.4, material="wood",
          aliases=("cannon", "mini cannon", "model cannon", "ship cannon"), themes=("toys",),
          roles=("big",), colors=("charcoal",))  # fmt: skip
@from_pieces()
def toy_cannon(look: Look) -> Pieces:
    """A cannon on a wheeled carriage."""
    iron = metal(look, "charcoal", "bronze", "black", "brass")
    tile = wood(look, "brown", "wooden", "maroon")
    barrel = (spindle((-0.09, 0.008), (-0.082, 0.012), (-0.075, 0.022), (-0.06, 0.026),
                      (0.02, 0.021), (0.075, 0.018), (0.08, 0.023), (0.088, 0.022),
                      z=0).turn(1, -0.12).move(0, 0, 0.062))  # fmt: skip
    bore = spindle((0.0865, 0.013), (0.0885, 0.013), z=0).turn(1, -0.12).move(0, 0, 0.062)
    sides = [plate([(-0.085, 0.012), (0.045, 0.012), (0.05, 0.05), (0.0, 0.058), (-0.085, 0.028)],
                   0.012).turn(0, np.pi / 2).move(0, s * 0.026 + 0.006, 0)
             for s in (-1, 1)]  # fmt: skip
    floor = at_box(0.13, 0.05, 0.01, (-0.02, 0, 0.012))
    wheels = [disc(0.022, 0.01).turn(0, np.pi / 2).move(x, s * 0.04 + 0.005, 0.022)
              for x in (-0.06, 0.028) for s in (-1, 1)]  # fmt: skip
    return [(barrel, iron), (sides[0], tile), (sides[1], tile), (floor, tile),
            *((w, dye(look, "brown", "black")) for w in wheels),
            (bore, TOY_CANNON_BLACK)]  # fmt: skip


def _catapult(sling: bool) -> Drawing:
    """A toy siege engine: a frame on wheels, and a throwing arm with a weight or a bowl."""

    def draw(look: Look) -> Pieces:
        tile = wood(look, "wooden", "brown", "tan")
        beams = [at_box(0.2, 0.014, 0.016, (0, s * 0.045, 0.016)) for s in (-1, 1)]
        cross = [at_box(0.014, 0.1, 0.016, (x, 0, 0.016)) for x in (-0.09, 0.02, 0.09)]
        wheels = [disc(0.022, 0.009).turn(0, np.pi / 2).move(x, s * 0.058 + 0.0045, 0.022)
                  for x in (-0.07, 0.07) for s in (-1, 1)]  # fmt: skip
        tall = 0.14 if sling else 0.09
        posts = [straight((x, s * 0.045, 0.03), (0.015, s * 0.03, tall), 0.006, 6) for s in (-1, 1)
                 for x in (-0.04, 0.065)]  # fmt: skip
        axle = straight((0.015, -0.045, tall), (0.015, 0.045, tall), 0.006, 8)
        if sling:
            arm = straight((0.07, 0, tall - 0.035), (-0.12, 0, tall + 0.065), 0.006, 8)
            load = at_block(0.045, 0.045, 0.045, 0.004, (0.075, 0, tall - 0.085))
        else:
            arm = straight((0.03, 0, 0.03), (-0.08, 0, 0.11), 0.0065, 8)
            load = standing((0.012, 0), (0.024, 0.012), (0.026, 0.018)).move(-0.085, 0, 0.106)
        stone = ball(
            0.022, 0.022, 0.022, (-0.085, 0, 0.126) if not sling else (0.05, 0.0, 0.042), 12
        )
        return [(join(beams), tile), (join(cross), tile), *((w, dye(look, "brown", "wooden"))
                                                            for w in wheels), (posts[0], tile),
                (posts[2], tile), (join([posts[1], posts[3], axle]), tile), (arm, tile),
                (load, dye(look, "gray", "brown")), (stone, dye(look, "gray"))]  # fmt: skip

    return draw


@category("lightsaber", size=(0.256, 0.043, 0.046), mass=0.3, material="metal",
          aliases=("lightsaber hilt", "light saber", "laser sword", "lightsabre"), themes=("toys",),
          roles=("big",), colors=("silver",))  # fmt: skip
@from_pieces(foot=0.08, bodies=1)
def lightsaber(look: Look) -> Pieces:
    """A lightsaber hilt lying flat: a ribbed metal grip with a switch and a coloured light."""
    steel = metal(look, "silver", "gray", "black")
    z = 0.021
    body = spindle((-0.13, 0.016), (-0.125, 0.02), (-0.06, 0.02), (-0.055, 0.016), (0.0, 0.017),
                   (0.05, 0.016), (0.06, 0.021), (0.12, 0.021), (0.125, 0.018), z=z)  # fmt: skip
    ribs = [
        spindle((-0.12 + 0.013 * k, 0.0215), (-0.113 + 0.013 * k, 0.0215), z=z) for k in range(5)
    ]
    switch = at_block(0.03, 0.012, 0.006, 0.002, (0.02, 0, 0.037))
    button = disc(0.004, 0.004, (0.02, 0, 0.042))
    return [(body, steel), (join(ribs), TOY_CANNON_BLACK), (switch, shine(look, "gold", "silver")),
            (button, dye(look, "red")), (spindle((0.1245, 0.013), (0.126, 0.013), z=z),
                                         dye(look, "cyan", "green", "red"))]  # fmt: skip


@category("slingshot", size=(0.1, 0.17, 0.026), mass=0.07, material="wood", assembled=True,
          aliases=("catapult", "sling shot"), themes=("toys",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def slingshot(look: Look) -> Shape:
    """A forked wooden slingshot lying flat, with a rubber band and a leather pouch."""
    k = look.between(0.92, 1.08)
    wood = look.surface(look.color("wooden", "brown", "tan", "wooden"), "wood")
    z = r = 0.009 * k
    stem = [tube(smooth(np.array(p) * k + [0, 0, z], 4), r, 10) for p in (
        [(0, -0.085, 0), (0, -0.03, 0), (0, 0.0, 0)],
        [(0, -0.01, 0), (0.018, 0.02, 0), (0.036, 0.045, 0), (0.038, 0.075, 0)],
        [(0, -0.01, 0), (-0.018, 0.02, 0), (-0.036, 0.045, 0), (-0.038, 0.075, 0)])]  # fmt: skip
    band = [tube(smooth(np.array([(s * 0.038, 0.068, 0.021), (s * 0.025, 0.03, 0.015),
                                  (s * 0.008, -0.005, 0.022)]) * k, 4), 0.0035 * k, 6)
            for s in (-1, 1)]  # fmt: skip
    ties = [torus(0.0095 * k, 0.0022 * k, 16, 6).turn(0, np.pi / 2).move(s * 0.038 * k, 0.066 * k,
        z)
            for s in (-1, 1)]  # fmt: skip
    patch = block(0.026 * k, 0.016 * k, 0.004, 0.004).move(0, -0.006 * k, 0.0195 * k)
    return shape([(join(stem), wood), (join([*band, *ties]), surfaces.plain((176, 52, 44))),
                  (patch, surfaces.speckles(look.rng, (96, 62, 42), 8, 32))],
                 [*(hull_of(s) for s in stem), hull_of(patch)])  # fmt: skip


CATEGORIES = (
    Category("toy_gun", from_pieces()(_gun(False, ("blue", "yellow", "green", "orange", "black"))),
             size=(0.205, 0.113, 0.029), mass=0.15, material="plastic", aliases=("nerf gun",
             "cap gun", "popgun", "pop gun", "toy pistol", "toy blaster", "blaster", "ray gun",
             "laser gun", "nerf blaster", "dart gun"), themes=("toys",), colors=("blue", "orange")),
    Category("water_pistol",
             from_pieces()(_gun(True, ("green", "blue", "pink", "yellow", "orange"))),
             size=(0.205, 0.15, 0.041), mass=0.12, material="plastic",
             aliases=("water gun", "squirt gun", "super soaker"), themes=("toys",),
             colors=("green", "blue")),
    Category("toy_sword", from_pieces()(_blade(0.0, 0.3, 0.03, "toy")), size=(0.4, 0.085, 0.016),
             mass=0.2, material="wood", assembled=True, aliases=("sword", "wooden sword",
             "knight sword", "mini sword", "play sword", "katana", "samurai sword", "foam sword"),
             themes=("toys",), roles=("big",), colors=("silver", "wooden")),
    Category("cutlass", from_pieces()(_blade(0.055, 0.26, 0.032, "cut")),
             size=(0.361, 0.105, 0.0165), mass=0.3, material="metal", assembled=True,
             aliases=("pirate sword", "sabre", "saber", "scimitar"), themes=("toys",),
             roles=("big",), colors=("silver",)),
    Category("toy_trebuchet", from_pieces()(_catapult(True)), size=(0.22, 0.13, 0.21), mass=0.25,
             material="wood", assembled=True,
             aliases=("trebuchet", "model trebuchet", "siege engine"), themes=("toys",),
             roles=("big",), colors=("wooden",)),
    Category("toy_catapult", from_pieces()(_catapult(False)), size=(0.213, 0.126, 0.138), mass=0.2,
             material="wood", assembled=True,
             aliases=("catapult model", "model catapult", "wooden catapult", "mangonel"),
             themes=("toys",), roles=("big",), colors=("wooden",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
