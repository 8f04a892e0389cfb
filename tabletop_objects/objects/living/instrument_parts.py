"""Objects of the ``living`` theme: instrument parts."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, metal, plastic, shine, wood
from ...kit.outlines import rectangle
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_block, at_box, ball, disc, facing, rod, spindle, straight
from ...kit.shapes import Pieces, Shape, category, from_pieces, shape
from ...kit.solids import box, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...kit.surfaces import Look, tint_color


@category("metronome", size=(0.133, 0.118, 0.218), mass=0.45, material="wood",
          aliases=("wooden metronome",), themes=("living",), roles=("tall",),
          colors=("wooden", "black"))  # fmt: skip
def metronome(look: Look) -> Shape:
    """A pyramid-shaped metronome with a scale and its pendulum swung to one side."""
    k = look.between(0.9, 1.1)
    color = look.color("wooden", "brown", "black", "maroon", "red", "ivory", "teal")
    wood = look.surface(color, "wood")
    square = rectangle(1, 1)
    rings = [(0.115, 0, 0), (0.115, 0.014, 0), (0.105, 0.016, 0), (0.045, 0.2, 0.0),
             (0.04, 0.21, 0)]  # fmt: skip
    body = loft(np.stack([np.column_stack([square * s * k, np.full(4, z * k)]) for s, z,
                          _ in rings]), square)  # fmt: skip
    lean = np.arctan2(0.03, 0.184)
    plate = prism(
        np.array([(-0.036, 0.0), (0.036, 0.0), (0.014, 0.145), (-0.014, 0.145)]) * k, 0, 0.002
    )
    plate = facing(plate).turn(0, -lean).move(y=-0.0475 * k, z=0.045 * k)
    scale = prints.canvas(96, 192, (238, 226, 190))
    for n in range(14):
        prints.fill(scale, 0.44 - 0.16 * (n % 2), 0.08 + 0.065 * n, 0.12 + 0.32 * (n % 2), 0.012,
                    (60, 44, 30))  # fmt: skip
        if n % 2 == 0:
            prints.write(scale, str(40 + 12 * n), 0.7, 0.09 + 0.065 * n, 0.035, (60, 44, 30))
    swing = look.pick([-1, 1]) * look.between(0.15, 0.4)
    rod = box(0.0025, 0.0016, 0.165 * k)
    weight = prism(
        np.array([(-0.009, 0), (0.009, 0), (0.006, 0.016), (-0.006, 0.016)]) * k, 0, 0.006
    )
    weight = facing(weight).move(y=0.003, z=look.between(0.07, 0.12) * k)
    arm = [s.turn(1, swing).turn(0, -lean).move(y=-0.053 * k, z=0.04 * k) for s in (rod, weight)]
    feet = [ellipsoid(0.014, 0.014, 0.01, 12, 6).move(sx * 0.045 * k, sy * 0.045 * k, 0.002)
            for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    key = [cylinder(0.003, 0.02, 8).turn(1, np.pi / 2).move(x=0.05 * k, z=0.05 * k),
           box(0.003, 0.022, 0.014).move(0.05 * k + 0.021, 0, 0.043 * k)]  # fmt: skip
    brass = surfaces.brushed_metal(look.rng, (200, 164, 84))
    up = 0.003
    pieces = [(body, wood), (plate, scale), (join([*arm, *key]), brass), (join(feet), wood)]
    raised = [(s.move(z=up), t) for s, t in pieces]
    return shape(raised, [box_part(0.09 * k, 0.09 * k, 0.006), hull_of(raised[0][0]),
                          hull_of(*(a.move(z=up) for a in arm))])  # fmt: skip


@category("capo", size=(0.107, 0.0892, 0.0109), mass=0.04, material="metal",
          aliases=("guitar capo",), themes=("living",), roles=("flat",), colors=("black",),
          state="lying")  # fmt: skip
@from_pieces()
def capo(look: Look) -> Pieces:
    """A capo lying flat: two bars with a soft pad between them and two curved arms."""
    tile = metal(look, "black", "silver", "gold", "red")
    bar = at_block(0.07, 0.012, 0.008, 0.003, (0.01, 0.02, 0.004))
    under = at_block(0.055, 0.012, 0.007, 0.003, (0.012, -0.012, 0.004))
    arm = rod([(-0.02, 0.02, 0.008), (-0.035, 0.0, 0.008), (-0.03, -0.03, 0.008),
               (0.01, -0.05, 0.008)], 0.0055, 8)  # fmt: skip
    arm2 = rod([(-0.02, -0.012, 0.008), (-0.028, 0.012, 0.008), (-0.06, 0.03, 0.008)], 0.0055, 8)
    pad = at_block(0.06, 0.006, 0.0085, 0.002, (0.012, 0.012, 0.004))
    return [(s, tile) for s in (bar, under, arm, arm2)] + [(pad, dye(look, "black", "gray"))]


@category("rosin", size=(0.06, 0.06, 0.023), mass=0.03, material="fabric",
          aliases=("violin rosin", "block of rosin", "rosin cake", "colophony"), themes=("living",),
          colors=("amber",))  # fmt: skip
@from_pieces()
def rosin(look: Look) -> Pieces:
    """A round cake of rosin on a square piece of cloth."""
    cloth = dye(look, "navy", "maroon", "green")
    pad = at_block(0.06, 0.06, 0.01, 0.012)
    cake = disc(0.024, 0.014, (0, 0, 0.009))
    color = look.color("amber", "brown", "orange")
    return [
        (pad, cloth),
        (cake, surfaces.gradient(color, tint_color(color, 1.3), look.rng)),
    ]  # type: ignore[arg-type]


@category("guitar_tuner", size=(0.0501, 0.0227, 0.0496), mass=0.03, material="plastic",
          aliases=("clip on tuner", "tuner", "chromatic tuner", "instrument tuner"),
          themes=("living",), colors=("black",))  # fmt: skip
@from_pieces()
def guitar_tuner(look: Look) -> Pieces:
    """A clip-on guitar tuner: a round screen on a joint above a padded clip."""
    tile = plastic(look, "black", "charcoal", "red", "blue")
    jaw = [at_block(0.05, 0.02, 0.006, 0.003), at_block(0.046, 0.02, 0.006, 0.003,
                                                        (0.002, 0, 0.012))]  # fmt: skip
    hinge = disc(0.006, 0.02, (-0.018, 0, 0), sides=16)
    neck = straight((-0.012, 0, 0.018), (-0.008, 0, 0.03), 0.005)
    body = at_block(0.042, 0.028, 0.009, 0.01).turn(0, 0.9).move(-0.006, 0.006, 0.036)
    image = prints.canvas(64, 44, (20, 26, 34))
    for k in range(7):
        prints.fill(
            image, 0.12 + 0.115 * k, 0.15, 0.04, 0.2, (70, 210, 110) if k == 3 else (220, 120, 60)
        )
    prints.write(image, look.pick(["A", "E", "G", "D"]), 0.5, 0.66, 0.42, (90, 230, 130), True)
    face = at_box(0.036, 0.022, 0.001, (0, 0, 0.0087)).turn(0, 0.9).move(-0.006, 0.006, 0.036)
    return [*((j, tile) for j in jaw), (hinge, tile), (neck, tile), (body, tile), (face, image)]


@category("clarinet_reed", size=(0.0661, 0.0128, 0.00296), mass=0.001, material="wood",
          aliases=("reed", "saxophone reed", "sax reed", "oboe reed"), themes=("living",),
          roles=("flat",), colors=("beige",), state="lying")  # fmt: skip
@from_pieces()
def clarinet_reed(look: Look) -> Pieces:
    """A clarinet reed lying flat: a strip of cane that is thinner towards its right end."""
    tile = wood(look, "beige", "cream", "tan")
    body = at_block(0.067, 0.013, 0.003, 0.003).bend(
        lambda p: p * np.column_stack([np.ones((len(p), 2)), np.clip(0.75 - 11 * p[:, 0], 0.2,
             1)]))  # fmt: skip
    return [(body, tile)]


@category("guitar_string", size=(0.145, 0.103, 0.0046), mass=0.005, material="metal",
          assembled=True, aliases=("guitar strings", "set of strings", "violin string",
          "coil of string", "bass string"), themes=("living",), roles=("flat",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces()
def guitar_string(look: Look) -> Pieces:
    """A guitar string, coiled up in rings."""
    tile = metal(look, "silver", "bronze", "gold")
    a = np.linspace(0, 2 * np.pi * 6, 200)
    r = 0.05 + 0.0016 * np.sin(1.7 * a)
    coil = tube(np.column_stack([r * np.cos(a), r * np.sin(a), 0.0008 + 0.0006 * (a / a[-1]) * 5]),
                0.0007, 4)  # fmt: skip
    tail = tube([(0.05, 0, 0.003), (0.075, 0.012, 0.001), (0.09, 0.0, 0.0009)], 0.0007, 4)
    ball_end = disc(0.002, 0.0035, (0.0905, 0, 0), sides=10)
    return [(coil, tile), (join([tail, ball_end]), shine(look, "brass"))]


@category("guitar_pedal", size=(0.088, 0.125, 0.059), mass=0.4, material="device",
          aliases=("effects pedal", "effect pedal", "stompbox", "distortion pedal", "fuzz pedal",
          "loop pedal", "foot pedal"), themes=("living",), colors=("orange", "green"))  # fmt: skip
@from_pieces()
def guitar_pedal(look: Look) -> Pieces:
    """An effects pedal: a metal box with knobs, a light and a foot switch."""
    color = look.color("orange", "green", "yellow", "blue", "silver", "purple")
    body = at_block(0.075, 0.125, 0.045, 0.006)
    name = prints.canvas(64, 32, color)
    prints.write(
        name, look.pick(["DRIVE", "DELAY", "FUZZ", "CHORUS"]), 0.5, 0.5, 0.5, (26, 26, 28), True
    )
    tag = at_box(0.06, 0.026, 0.0008, (0, 0.0, 0.0446))
    knobs = [disc(0.009, 0.014, (x, 0.042, 0.044)) for x in (-0.022, 0, 0.022)]
    marks = [at_box(0.0015, 0.008, 0.0008, (x, 0.045, 0.0577)) for x in (-0.022, 0, 0.022)]
    switch = [disc(0.011, 0.004, (0, -0.038, 0.045)), disc(0.006, 0.014, (0, -0.038, 0.045))]
    lamp = ball(0.006, 0.006, 0.006, (0, 0.022, 0.046), 10)
    jacks = [straight((s * 0.037, 0.01, 0.022), (s * 0.044, 0.01, 0.022), 0.006) for s in (-1, 1)]
    return [(body, look.surface(color, "metal")), (join(knobs), dye(look, "black", "cream")),
            (join(switch), shine(look)), (tag, name), (join(marks), surfaces.plain((240, 240,
             236))),
            (lamp, surfaces.plain((230, 40, 40))), (join(jacks), shine(look))]  # fmt: skip


@category("baton", size=(0.35, 0.02, 0.017), mass=0.02, material="wood",
          aliases=("conductor baton", "conducting baton", "conductor stick"), themes=("living",),
          colors=("white",), state="lying")  # fmt: skip
@from_pieces(foot=0.15)
def baton(look: Look) -> Pieces:
    """A conductor's baton lying flat: a rounded wooden grip on the left and a tapered stick."""
    grip = spindle((-0.16, 0.004), (-0.155, 0.008), (-0.14, 0.009), (-0.12, 0.004), z=0.0085)
    stick = spindle((-0.122, 0.0022), (0.19, 0.0012), z=0.0085).turn(1, 0.022).move(z=0.0)
    rest = ball(0.02, 0.02, 0.017, (-0.145, 0, 0.0085), 12)
    return [(rest, wood(look, "brown", "wooden", "maroon")), (grip, dye(look, "brown", "wooden")),
            (stick, plastic(look, "white", "cream"))]  # fmt: skip


@category("triangle_beater", size=(0.2, 0.011, 0.011), mass=0.03, material="metal",
          aliases=("beater", "triangle striker", "striker", "beater of a triangle",
          "drumstick of a triangle", "triangle stick"), themes=("living",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.15)
def triangle_beater(look: Look) -> Pieces:
    """A thin metal rod with a rubber grip."""
    return [(spindle((-0.1, 0.003), (0.06, 0.003), z=0.0055), metal(look, "silver", "gray")),
            (spindle((0.02, 0.0045), (0.03, 0.0056), (0.095, 0.0056), (0.1, 0.0045), z=0.0055),
             dye(look, "red", "black", "blue"))]  # fmt: skip


@category("mouthpiece", size=(0.027, 0.027, 0.08), mass=0.08, material="metal",
          aliases=("trumpet mouthpiece", "tuba mouthpiece", "trombone mouthpiece",
          "brass mouthpiece"), themes=("living",), colors=("silver",))  # fmt: skip
@from_pieces()
def mouthpiece(look: Look) -> Pieces:
    """A brass mouthpiece, standing on its cup."""
    tile = metal(look, "silver", "silver", "gold")
    return [(lathe([(0, 0), (0.0125, 0), (0.0135, 0.004), (0.012, 0.014), (0.006, 0.022),
                    (0.0042, 0.03), (0.005, 0.08), (0, 0.08)], 24), tile)]  # fmt: skip


@category("trumpet_mute", size=(0.12, 0.12, 0.13), mass=0.1, material="metal",
          aliases=("mute", "trombone mute", "straight mute"), themes=("living",),
          colors=("silver",))  # fmt: skip
@from_pieces()
def trumpet_mute(look: Look) -> Pieces:
    """A metal mute standing on its wide end, with three strips of cork near its narrow top."""
    tile = metal(look, "silver", "gold", "red", "black")
    cone = lathe([(0, 0), (0.06, 0), (0.06, 0.008), (0.05, 0.02), (0.02, 0.11), (0.02, 0.13),
                  (0, 0.13)], 28)  # fmt: skip
    corks = [at_block(0.006, 0.008, 0.03, 0.002, (0.024, 0, 0)).turn(1, -0.0).turn(2,
             a).move(z=0.09)
             for a in (0, 2.1, 4.2)]  # fmt: skip
    return [(cone, tile), (join(corks), dye(look, "tan"))]
