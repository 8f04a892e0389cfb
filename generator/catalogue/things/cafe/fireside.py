"""For grilling on and at the table: small barbecues, chimney starters, presses, claws."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.recipes import ball, open_vessel, straight
from ...build.settled import hull_above, limb, rod, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, torus
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (188, 191, 196)


def _coals(look: Look, x: float, y: float, z: float, count: int) -> tuple[Solid, Solid]:
    dark, hot = [], []
    for n in range(count):
        lump = box(0.026, 0.024, 0.016).turn(2, look.between(0, 3))
        lump = lump.move(look.between(-x, x), look.between(-y, y), z)
        (hot if n % 4 == 0 else dark).append(lump)
    return join(dark), join(hot)


def grill(look: Look) -> Shape:
    """A round tabletop barbecue on three legs: coals, a grate, side handles."""
    k = look.between(0.92, 1.06)
    color = look.color("black", "red", "green", "navy")
    r = 0.14
    bowl = lathe(
        [
            (0, 0.05),
            (0.5 * r, 0.05),
            (0.9 * r, 0.085),
            (r, 0.13),
            (0.95 * r, 0.13),
            (0.85 * r, 0.09),
            (0, 0.075),
        ],
        36,
    )
    legs = [
        straight(
            (0.6 * r * np.cos(a), 0.6 * r * np.sin(a), 0.065),
            (0.85 * r * np.cos(a), 0.85 * r * np.sin(a), 0.004),
            0.005,
        )
        for a in (0.52, 2.62, 4.71)
    ]
    bars = [
        straight(
            (-np.sqrt(max(0.9025 * r * r - y * y, 0)), y, 0.126),
            (np.sqrt(max(0.9025 * r * r - y * y, 0)), y, 0.126),
            0.0016,
            5,
        )
        for y in np.linspace(-0.85 * r, 0.85 * r, 15)
    ]
    rim = torus(0.97 * r, 0.003, 36, 6).move(z=0.128)
    grips = [
        limb(
            [
                (s * 0.98 * r, -0.03, 0.11),
                (s * 1.15 * r, -0.026, 0.112),
                (s * 1.15 * r, 0.026, 0.112),
                (s * 0.98 * r, 0.03, 0.11),
            ],
            [0.005] * 4,
            8,
        )
        for s in (-1, 1)
    ]
    dark, hot = _coals(look, 0.065, 0.065, 0.085, 18)
    steel = textures.brushed_metal(look.rng, STEEL)
    return shape([(bowl, textures.speckles(look.rng, color, 5)), (join([*legs, *bars, rim]), steel),
                  (join(grips), textures.wood(look.rng, (150, 104, 62))),
                  (dark, textures.speckles(look.rng, (46, 44, 44), 14)),
                  (hot, textures.spots(look.rng, (230, 90, 30), (90, 40, 30), 0.4))],
                 [hull_of(bowl), *(hull_of(leg) for leg in legs), *(hull_of(g) for g in grips)]
                 ).scale(k)  # fmt: skip


def tray_grill(look: Look) -> Shape:
    """A disposable barbecue: a foil tray of charcoal under a wire grid."""
    k = look.between(0.94, 1.06)
    color = look.color("silver", "silver", "gray")
    x, y, h = 0.29 * k, 0.22 * k, 0.05 * k
    rim = block(1.06 * x, 1.08 * y, 0.004, 0.012).move(z=h - 0.003)
    body = block(0.94 * x, 0.94 * y, h - 0.002, 0.012)
    bed = block(0.9 * x, 0.9 * y, 0.002, 0.01).move(z=h)
    dark, hot = _coals(look, 0.42 * x, 0.4 * y, h - 0.006, 40)
    wires = [straight((-0.48 * x, v, h + 0.012), (0.48 * x, v, h + 0.012), 0.0012, 4)
             for v in np.linspace(-0.42 * y, 0.42 * y, 9)]  # fmt: skip
    wires += [straight((v, -0.46 * y, h + 0.013), (v, 0.46 * y, h + 0.013), 0.0012, 4)
              for v in np.linspace(-0.44 * x, 0.44 * x, 12)]  # fmt: skip
    foil = textures.brushed_metal(look.rng, color)
    return shape([(join([body, rim]), foil), (bed, textures.plain((40, 38, 38))),
                  (dark, textures.speckles(look.rng, (46, 44, 44), 14)),
                  (hot, textures.spots(look.rng, (150, 146, 140), (206, 96, 40), 0.2)),
                  (join(wires), textures.plain((176, 180, 184)))],
                 [box_part(0.94 * x, 0.94 * y, h), box_part(1.05 * x, 1.07 * y, 0.004,
                  (0, 0, h - 0.003)), box_part(0.9 * x, 0.9 * y, 0.012, (0, 0, h))])  # fmt: skip


def chimney(look: Look) -> Shape:
    """A chimney starter: a steel can with holes, a handle and coals on top."""
    k = look.between(0.92, 1.06)
    color = look.color("silver", "silver", "black")
    r, h = 0.08 * k, 0.2 * k
    body, _ = open_vessel([(r, 0), (r, h)], 0.003, 0.6 * h, 36)
    image = textures.fit(textures.brushed_metal(look.rng, color), 128, 256).copy()
    for n in range(12):
        for row in (0.88, 0.96):
            prints.disc(image, (n + 0.5 * (row > 0.9)) / 12, 0.5 + 0.5 * row, 0.022, (30, 30, 32))
    grip = limb(
        [(r, 0, 0.86 * h), (1.75 * r, 0, 0.82 * h), (1.8 * r, 0, 0.35 * h), (r, 0, 0.24 * h)],
        [0.008] * 4,
        8,
    )
    shield = box(0.003, 0.09 * k, 0.7 * h).move(x=1.15 * r, z=0.15 * h)
    dark, hot = _coals(look, 0.045 * k, 0.045 * k, 0.9 * h, 14)
    low, _ = _coals(look, 0.045 * k, 0.045 * k, 0.8 * h, 14)
    return shape(
        [
            (body, image),
            (grip, textures.plain((36, 34, 34))),
            (shield, textures.brushed_metal(look.rng, STEEL)),
            (join([dark, low]), textures.speckles(look.rng, (46, 44, 44), 14)),
            (hot, textures.spots(look.rng, (230, 90, 30), (90, 40, 30), 0.4)),
        ],
        [cylinder_part(r, h), hull_of(grip), hull_of(shield)],
    )


def press(look: Look) -> Shape:
    """A burger press: a round metal plate with a handle on top."""
    k = look.between(0.94, 1.08)
    color = look.color("silver", "black", "red")
    dish = lathe(
        [(0, 0), (0.058, 0), (0.062, 0.004), (0.062, 0.022), (0.05, 0.027), (0, 0.028)], 36
    )
    post = cylinder(0.008, 0.03, 14).move(z=0.026)
    knob = lathe([(0, 0.052), (0.014, 0.052), (0.023, 0.066), (0.018, 0.078), (0, 0.08)], 24)
    rings = [torus(r, 0.0012, 32, 5).move(z=0.0275) for r in (0.024, 0.036)]
    return shape([(join([dish, *rings]), textures.brushed_metal(look.rng, color)),
                  (post, textures.brushed_metal(look.rng, STEEL)),
                  (knob, textures.wood(look.rng, (120, 78, 48)))],
                 [hull_of(dish), hull_of(post), hull_of(knob)]).scale(k)  # fmt: skip


def claw(look: Look) -> Shape:
    """A claw for pulling meat: a grip with long curved prongs, lying."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "black", "red", "wooden")
    grip = rod(0.11, 0.013, blunt=7).turn(2, np.pi / 2)
    plate = block(0.03, 0.095, 0.008, 0.004).move(x=0.018, z=-0.004)
    prongs = [
        limb([(0.028, y, 0), (0.075, y, 0.004), (0.105, y, -0.008)], [0.0045, 0.004, 0.001], 7)
        for y in np.linspace(-0.04, 0.04, 6)
    ]
    return settle(
        [
            (join([grip, plate]), look.surface(color, "plastic")),
            (join(prongs), textures.plain((44, 44, 48))),
        ],
        0.1,
        hulls=[[0], [1]],
    ).scale(k)


def corn_fork(look: Look) -> Shape:
    """A holder for corn: a tiny yellow cob with two pins, lying."""
    k = look.between(0.95, 1.2)
    color = look.color("yellow", "yellow", "green")
    cob = rod(0.036, 0.0095, blunt=3.5)
    pins = [straight((0.015, s * 0.004, 0), (0.042, s * 0.004, 0), [0.0012, 0.0006], 6)
            for s in (-1, 1)]  # fmt: skip
    husk = [ball(0.024, 0.009, 0.006, (-0.012, s * 0.007, 0.004), 8) for s in (-1, 1)]
    tile = textures.fit(textures.spots(look.rng, color, tint_color(color, 0.8), 0.35), 64, 64)
    return settle([(cob, tile), (join(pins), textures.plain((196, 198, 202))),
                   (join(husk), textures.plain((104, 160, 70)))], 0.14,
                  hulls=[[0], [1]]).scale(k)  # fmt: skip


def topper(look: Look) -> Shape:
    """An egg topper: a steel bell on a rod with a ball that slides on it."""
    k = look.between(0.94, 1.06)
    color = look.color("silver", "silver", "copper", "gold")
    bell = lathe([(0, 0.012), (0.017, 0.0), (0.0185, 0.0), (0.016, 0.014), (0.006, 0.022), (0,
                  0.023)], 26)  # fmt: skip
    stem = straight((0, 0, 0.02), (0, 0, 0.16), 0.003)
    weight = ball(0.026, 0.026, 0.024, (0, 0, 0.07), 18)
    cap = ball(0.013, 0.013, 0.012, (0, 0, 0.16), 12)
    metal = textures.brushed_metal(look.rng, color)
    foot = cylinder(0.018, 0.003, 26)
    return shape([(join([bell, stem, weight, cap, foot]), metal)],
                 [hull_of(foot, bell), hull_of(stem, cap), hull_of(weight)]).scale(k)  # fmt: skip


def canteen(look: Look) -> Shape:
    """A round flat water bottle in felt, its cap on a chain, standing."""
    k = look.between(0.92, 1.06)
    color = look.color("olive", "tan", "gray", "green")
    r = 0.075
    drum = lathe([(0, -0.026), (0.82 * r, -0.024), (r, -0.012), (r, 0.012), (0.82 * r, 0.024), (0,
                  0.026)], 34).turn(0, np.pi / 2).move(z=0.96 * r)  # fmt: skip
    low = block(0.07, 0.046, 0.006, 0.01)
    neck = cylinder(0.014, 0.025, 18).move(z=1.9 * r)
    cap = cylinder(0.018, 0.02, 20, bevel=0.002).move(z=1.9 * r + 0.022)
    strap = torus(1.02 * r, 0.007, 36, 6).turn(0, np.pi / 2).move(z=0.97 * r + 0.006)
    chain = limb([(0.018, 0, 1.9 * r + 0.03), (0.05, -0.012, 1.75 * r), (0.04, -0.026, 1.5 * r)],
                 [0.0018] * 3, 5)  # fmt: skip
    return shape([(join([drum, low]), textures.fabric(look.rng, color)),
                  (strap, textures.plain(tint_color(color, 0.65))),
                  (join([neck]), textures.brushed_metal(look.rng, STEEL)),
                  (join([cap, chain]), textures.plain((44, 42, 40)))],
                 [hull_above(drum, low), hull_of(neck, cap)]).scale(k)  # fmt: skip


def siphon(look: Look) -> Shape:
    """A soda siphon: a ribbed bottle with a chrome head, lever and spout."""
    k = look.between(0.94, 1.06)
    color = look.color("teal", "sky", "red", "silver", "clear")
    body = lathe(
        [(0, 0), (0.044, 0), (0.047, 0.01), (0.047, 0.15), (0.03, 0.195), (0.018, 0.21), (0, 0.21)],
        28,
    )
    head = lathe(
        [(0, 0.205), (0.02, 0.205), (0.022, 0.23), (0.016, 0.26), (0.012, 0.275), (0, 0.277)], 22
    )
    spout = limb([(-0.012, 0, 0.25), (-0.045, 0, 0.25), (-0.056, 0, 0.225)], [0.006, 0.0055, 0.004],
                 8)  # fmt: skip
    lever = limb([(0.004, 0, 0.27), (0.035, 0, 0.266), (0.05, 0, 0.22), (0.052, 0, 0.17)],
                 [0.005, 0.005, 0.0045, 0.004], 8)  # fmt: skip
    foot = cylinder(0.046, 0.016, 28)
    chrome = textures.brushed_metal(look.rng, (206, 210, 214))
    net = textures.grid(tint_color(color, 0.8), tint_color(color, 1.15), 22, 22, width=1)
    return shape(
        [(body, net), (join([head, spout, lever, foot]), chrome)],
        [hull_of(body, foot), hull_of(head), hull_of(spout), hull_of(lever)],
    ).scale(k)


_K = ("kitchen",)
CATEGORIES = (
    Category("tabletop_grill", grill, (0.335, 0.277, 0.128), 2.0, ("tabletop barbecue",
             "mini barbecue", "barbecue grill", "charcoal grill", "bbq grill", "hibachi",
             "barbecue", "small grill", "table grill"), _K, ("big",), ("black", "red")),
    vary(Category("disposable_barbecue", tray_grill, (0.315, 0.243, 0.0654), 0.8,
             ("disposable bbq",
             "instant barbecue", "foil barbecue", "disposable grill"), _K, ("big", "flat"),
             ("silver",))),
    vary(Category("chimney_starter", chimney, (0.241, 0.162, 0.202), 1.2, ("charcoal chimney",
             "charcoal starter"), _K, ("tall",), ("silver",))),
    Category("burger_press", press, (0.122, 0.122, 0.0785), 0.4, ("patty press", "hamburger press",
             "bacon press"), _K, ("round",), ("silver",)),
    Category("meat_claw", claw, (0.12, 0.112, 0.0232), 0.08, ("bear claw shredder", "meat shredder",
             "shredding claw", "bbq claw"), _K, (), ("black",), state="lying flat"),
    vary(Category("corn_holder", corn_fork, (0.0704, 0.0243, 0.0172), 0.008, ("corn skewer",
             "corn fork",
             "corn cob holder"), _K, (), ("yellow",), state="lying flat")),
    Category("egg_topper", topper, (0.037, 0.0373, 0.167), 0.12, ("egg cracker", "egg opener",
             "egg clacker"), _K, ("tall",), ("silver",)),
    Category("canteen", canteen, (0.165, 0.053, 0.183), 0.9, ("water canteen", "army canteen",
             "field flask", "military canteen", "camping canteen"), ("travel",), ("tall",),
             ("olive",)),
    Category("soda_siphon", siphon, (0.119, 0.0965, 0.284), 1.2, ("seltzer bottle", "soda syphon",
             "cream whipper", "whipped cream dispenser"), ("dining",), ("tall",), ("teal",)),
)  # fmt: skip
"""The module's categories."""
