"""Objects of the ``living`` theme: models and miniatures."""

from __future__ import annotations

import itertools

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic, wood
from ...kit.outlines import rectangle, smooth
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    drum,
    hull_solid,
    plate,
    rod,
    spindle,
    standing,
    standing_plate,
    straight,
)
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down
from ...kit.solids import box, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, Tile, tint_color


@category("model_lighthouse", size=(0.0861, 0.0848, 0.175), mass=0.25, material="ceramic",
          aliases=("lighthouse", "lighthouse model", "toy lighthouse", "miniature lighthouse",
          "lighthouse figurine"), themes=("living",), roles=("tall",), colors=("red",))  # fmt: skip
@from_pieces()
def model_lighthouse(look: Look) -> Pieces:
    """A lighthouse on a rock: a tapered striped tower, a deck, a lit room and a pointed roof."""
    color: RGB = look.color("red", "navy", "white")
    rock = standing((0.045, 0), (0.04, 0.012), (0.03, 0.02), sides=9)
    body = disc(0.024, 0.12, (0, 0, 0.018), top=0.015)
    deck, room = disc(0.021, 0.004, (0, 0, 0.138)), disc(0.011, 0.02, (0, 0, 0.142))
    roof = disc(0.014, 0.018, (0, 0, 0.162), top=0.0008)
    stripes = surfaces.stripes([color, (240, 238, 232)], 3)
    return [(rock, dye(look, "gray", "charcoal")), (body, stripes), (deck, dye(look, "charcoal")),
            (room, surfaces.plain((250, 226, 140))), (roof, surfaces.plain(color))]  # fmt: skip


@category("model_windmill", size=(0.137, 0.0921, 0.186), mass=0.2, material="ceramic",
          aliases=("windmill model", "miniature windmill", "dutch windmill"), themes=("living",),
          roles=("tall",), colors=("white",))  # fmt: skip
@from_pieces()
def model_windmill(look: Look) -> Pieces:
    """A windmill on a green base: an eight-sided tower with a cap, four sails and a door."""
    wall = plastic(look, "white", "cream", "brown", "beige")
    roof = dye(look, "terracotta", "brown", "charcoal")
    body = disc(0.035, 0.11, (0, 0, 0.006), top=0.022, sides=8)
    cap = disc(0.026, 0.026, (0, 0, 0.116), top=0.004)
    sails = []
    for k in range(4):
        frame = [at_box(0.004, 0.003, 0.075), at_box(0.022, 0.002, 0.056, (0.011, 0, 0.018))]
        sails += [s.turn(1, 0.5 + np.pi / 2 * k).move(0, -0.036, 0.115) for s in frame]
    axle = straight((0, -0.01, 0.115), (0, -0.038, 0.115), 0.005)
    door = at_box(0.018, 0.004, 0.032, (0, -0.032, 0.006))
    return [(at_block(0.09, 0.09, 0.006, 0.01), dye(look, "green")), (body, wall), (cap, roof),
            (join([*sails, axle]), dye(look, "cream", "wooden")), (door, roof)]  # fmt: skip


WHITE = surfaces.plain((244, 242, 238))


@category("ship_in_a_bottle", size=(0.25, 0.092, 0.106), mass=0.4, material="glass",
          aliases=("ship in bottle", "bottled ship", "bottle ship", "boat in a bottle"),
          themes=("living",), roles=("big",), colors=("brown",))  # fmt: skip
@from_pieces(bodies=6)
def ship_in_a_bottle(look: Look) -> Pieces:
    """A sailing ship in a bottle on a stand; the bottle is modelled as a frame of glass rods."""
    stand = [at_box(0.014, 0.09, 0.022, (x, 0, 0)) for x in (-0.06, 0.05)]
    z = 0.06
    floor = plate(rectangle(0.14, 0.07, 0.03), 0.012, z - 0.026)
    hull = hull_solid([(x, y, h) for x, w, h in ((-0.05, 0.012, z - 0.004),
                                                 (-0.035, 0.006, z - 0.02), (0.03, 0.006, z - 0.02),
                                                 (0.055, 0.002, z - 0.002),
                                                 (-0.05, 0.01, z + 0.004))
                       for y in (-w, w)])  # fmt: skip
    masts = [straight((x, 0, z - 0.004), (x, 0, z + 0.034), 0.0013, 6) for x in (-0.03, 0.0, 0.028)]
    sails = [at_box(0.002, w, 0.013, (x, 0, z + h)) for x in (-0.028, 0.002, 0.03) for w,
             h in ((0.034, 0.002), (0.026, 0.018))]  # fmt: skip
    hoops = [torus(r, 0.0016, 32, 5).turn(1, np.pi / 2).move(x, 0, z) for x,
             r in ((-0.075, 0.036), (-0.03, 0.044), (0.03, 0.044), (0.075, 0.036))]  # fmt: skip
    spines = [tube(smooth([(-0.088, 0.018 * np.cos(a), z + 0.018 * np.sin(a)),
                           (-0.07, 0.04 * np.cos(a), z + 0.04 * np.sin(a)),
                           (0.0, 0.044 * np.cos(a), z + 0.044 * np.sin(a)),
                           (0.06, 0.042 * np.cos(a), z + 0.042 * np.sin(a)),
                           (0.095, 0.016 * np.cos(a), z + 0.016 * np.sin(a))], 5), 0.0011, 5)
              for a in np.arange(10) * 0.6283]  # fmt: skip
    neck = [lathe([(0.012, 0), (0.016, 0), (0.014, 0.045), (0.017, 0.05), (0.012, 0.05)], 20,
                  loop=True).turn(1, np.pi / 2).move(0.094, 0, z)]  # fmt: skip
    cork = spindle((0.138, 0.0115), (0.158, 0.013), z=z)
    back = (lathe([(0.0, 0), (0.03, 0), (0.034, 0.006), (0, 0.006)],
                  26).turn(1, np.pi / 2).move(-0.09, 0, z))  # fmt: skip
    glass = surfaces.plain((190, 220, 216))
    return [(join([*hoops, *spines]), glass), (join(neck), glass), (join([back]), glass),
            (stand[0], wood(look, "brown", "wooden")), (stand[1], wood(look, "brown", "wooden")),
            (cork, dye(look, "tan")), (floor, surfaces.plain((60, 130, 180))),
            (hull, plastic(look, "brown", "red", "navy")), (join(masts), dye(look, "brown")),
            (join(sails), WHITE)]  # fmt: skip


@category("miniature_house", size=(0.14, 0.12, 0.155), mass=0.3, material="wood", hollow=True,
          aliases=("toy house", "model house", "house model", "house", "cottage", "little house",
          "ceramic house", "wooden house", "village house", "cabin", "log cabin model"),
          themes=("living",), colors=("cream", "pink"))  # fmt: skip
@from_pieces(bodies=4)
def miniature_house(look: Look) -> Pieces:
    """A small house: walls with windows and a door, a tiled roof and a chimney."""
    color = look.color("cream", "pink", "sky", "yellow", "white", "terracotta")
    front = prints.canvas(96, 80, color)
    for x in (0.12, 0.66):
        for y in (0.1, 0.52):
            prints.fill(front, x, y, 0.22, 0.3, (250, 250, 246))
            prints.fill(front, x + 0.02, y + 0.03, 0.18, 0.24, (110, 150, 190))
            prints.fill(front, x + 0.1, y, 0.02, 0.3, (250, 250, 246))
    prints.fill(front, 0.41, 0.48, 0.18, 0.52, (120, 60, 44))
    body = at_box(0.11, 0.09, 0.085, (0, 0, 0.006))
    roof = standing_plate([(-0.065, 0.088), (0.065, 0.088), (0, 0.14)], 0.104)
    chimney = at_box(0.016, 0.016, 0.045, (0.032, 0.015, 0.11))
    face = at_box(0.11, 0.001, 0.085, (0, -0.0452, 0.006))
    plain = surfaces.plain(color)
    return [(at_block(0.14, 0.12, 0.006, 0.004), dye(look, "green", "sage")), (body, plain),
            (roof, dye(look, "terracotta", "charcoal", "brown", "teal")),
            (chimney, dye(look, "terracotta", "brown")), (face, front)]  # fmt: skip


@category("dollhouse", size=(0.29, 0.15, 0.3), mass=1.2, material="wood", hollow=True,
          aliases=("doll house", "doll's house", "dolls house", "barbie house"), themes=("living",),
          roles=("big", "tall"), colors=("pink",))  # fmt: skip
@from_pieces(bodies=8)
def dollhouse(look: Look) -> Pieces:
    """A doll's house with an open front, two floors, four rooms and a pitched roof."""
    tile = plastic(look, "pink", "white", "sky", "cream", "mint")
    x, y, h = 0.26, 0.13, 0.2
    walls = [at_box(0.006, y, h, (s * (x / 2 - 0.003), 0, 0.006)) for s in (-1, 1)]
    middle = at_box(0.005, y - 0.01, h, (0.02, 0, 0.006))
    floors = [at_box(x, y, 0.006, (0, 0, z)) for z in (0, 0.1, 0.2)]
    back = at_box(x, 0.005, h, (0, y / 2 - 0.0025, 0.006))
    roof = [
        at_box(0.165, y + 0.02, 0.007).turn(1, s * 0.62).move(s * 0.067, 0, 0.25) for s in (-1, 1)
    ]
    gable = standing_plate([(-0.13, 0.206), (0.13, 0.206), (0, 0.297)], 0.005, y / 2 - 0.003)
    bed = [
        at_box(0.07, 0.05, 0.018, (-0.075, 0.02, 0.106)),
        at_box(0.006, 0.05, 0.035, (-0.108, 0.02, 0.106)),
    ]
    table = [disc(0.026, 0.003, (-0.06, -0.01, 0.036)), disc(0.004, 0.03, (-0.06, -0.01, 0.006))]
    sofa = [
        at_box(0.06, 0.026, 0.018, (0.075, 0.035, 0.006)),
        at_box(0.06, 0.008, 0.036, (0.075, 0.05, 0.006)),
    ]
    shelf = at_box(0.04, 0.018, 0.06, (0.08, 0.05, 0.106))
    return [*((w, tile) for w in walls), *((f, wood(look, "wooden")) for f in floors),
            (back, dye(look, "cream", "pink", "mint")), *((r, dye(look, "terracotta", "purple",
                                                                  "red", "teal")) for r in roof),
            (middle, tile), (gable, tile), (join(bed), dye(look, "red", "purple", "blue")),
            (join(table), dye(look, "wooden", "white")), (join(sofa), dye(look, "teal", "yellow",
                                                                          "orange")),
            (shelf, dye(look, "brown", "wooden"))]  # fmt: skip


@category("toy_castle", size=(0.19, 0.19, 0.16), mass=0.4, material="plastic", hollow=True,
          aliases=("castle model", "toy fort", "toy fortress", "sand castle", "sandcastle"),
          themes=("living",), roles=("big",), colors=("gray",))  # fmt: skip
@from_pieces(bodies=10)
def toy_castle(look: Look) -> Pieces:
    """A castle with four round towers, battlements and a gate."""
    stone = plastic(look, "gray", "beige", "tan", "pink")
    base = at_block(0.19, 0.19, 0.006, 0.01)
    towers, roofs = [], []
    for x in (-0.07, 0.07):
        for y in (-0.07, 0.07):
            towers.append(disc(0.022, 0.1, (x, y, 0.006)))
            roofs.append(disc(0.027, 0.045, (x, y, 0.106), top=0.0008))
    walls = [at_box(0.13, 0.012, 0.06, (0, s * 0.07, 0.006)) for s in (-1, 1)] + [
        at_box(0.012, 0.13, 0.06, (s * 0.07, 0, 0.006)) for s in (-1, 1)
    ]
    teeth = [at_box(0.01, 0.012, 0.01, (x, s * 0.07, 0.066)) for s in (-1, 1)
             for x in (-0.04, -0.016, 0.016, 0.04)]  # fmt: skip
    keep = at_box(0.06, 0.06, 0.1, (0, 0.01, 0.006))
    more = [
        at_box(0.012, 0.012, 0.012, (x, y, 0.106)) for x in (-0.024, 0.024) for y in (-0.014, 0.034)
    ]
    gate = at_box(0.03, 0.014, 0.036, (0, -0.0705, 0.006))
    flag = [
        straight((0, 0.01, 0.105), (0, 0.01, 0.16), 0.0015, 6),
        at_box(0.03, 0.0015, 0.018, (0.015, 0.01, 0.14)),
    ]
    return [(base, dye(look, "green", "gray")), *((t, stone) for t in towers),
            *((w, stone) for w in walls), (keep, stone),
            (join(roofs), dye(look, "blue", "red", "purple")), (join([*teeth, *more]), stone),
            (gate, dye(look, "brown")), (join(flag), dye(look, "red", "yellow"))]  # fmt: skip


@category("toy_theatre", size=(0.22, 0.14, 0.215), mass=0.5, material="wood",
          aliases=("toy theater", "puppet theatre", "puppet theater", "model theatre",
          "puppet stage"), themes=("living",), roles=("big",), colors=("gold",))  # fmt: skip
@from_pieces()
def toy_theatre(look: Look) -> Pieces:
    """A toy theatre: a frame with red curtains, a painted backdrop and a floor."""
    frame = wood(look, "gold", "brown", "wooden")
    floor = at_box(0.22, 0.14, 0.012)
    posts = [at_box(0.022, 0.014, 0.16, (s * 0.099, -0.05, 0.012)) for s in (-1, 1)]
    arch = standing_plate(
        [(-0.11, 0.172), (0.11, 0.172), (0.11, 0.185), (0, 0.215), (-0.11, 0.185)], 0.014, -0.05
    )
    drop = at_box(0.2, 0.006, 0.17, (0, 0.06, 0.012))
    art = surfaces.fit(prints.landscape(look.rng), 96, 128)
    folds = [disc(0.009, 0.155, (s * (0.082 - 0.013 * k), -0.04, 0.012), sides=10) for s in (-1, 1)
             for k in range(3)]  # fmt: skip
    swag = [ball(0.06, 0.014, 0.03, (x, -0.045, 0.165), 12) for x in (-0.055, 0, 0.055)]
    actors = [standing((0.012, 0.012), (0.006, 0.04), (0.009, 0.052), (0.004, 0.06),
                       sides=12).move(x, 0.01) for x in (-0.03, 0.03)]  # fmt: skip
    return [(floor, frame), (posts[0], frame), (posts[1], frame), (arch, frame), (drop, art),
            (join(folds), red := dye(look, "crimson", "red", "maroon")), (join(swag), red),
            (actors[0], dye(look, "blue", "green")),
            (actors[1], dye(look, "yellow", "pink"))]  # fmt: skip


@category("model_tank", size=(0.2, 0.1, 0.078), mass=0.3, material="plastic",
          aliases=("toy tank", "army tank", "panzer", "battle tank", "military tank"),
          themes=("living",), colors=("olive",))  # fmt: skip
@from_pieces(bodies=6)
def model_tank(look: Look) -> Pieces:
    """A model tank with tracks, a hull and a turret with a gun."""
    tile = plastic(look, "olive", "sage", "tan", "gray")
    tracks = [at_block(0.15, 0.026, 0.036, 0.008).move(y=s * 0.036) for s in (-1, 1)]
    wheels = [disc(0.011, 0.003).turn(0, np.pi / 2).move(x, -0.0485 if s < 0 else 0.0515, 0.015)
              for s in (-1, 1) for x in np.linspace(-0.055, 0.055, 5)]  # fmt: skip
    hull = hull_solid([(x, y, z) for y in (-0.042, 0.042) for x,
                       z in ((-0.075, 0.03), (-0.07, 0.05), (0.045, 0.05), (0.08, 0.034),
                             (0.075, 0.02), (-0.07, 0.02))])  # fmt: skip
    turret = hull_solid([(x, y, z) for x, y, z in ((-0.045, -0.03, 0.05), (-0.045, 0.03, 0.05),
                                                   (0.03, -0.024, 0.05), (0.03, 0.024, 0.05),
                                                   (-0.04, -0.024, 0.074), (-0.04, 0.024, 0.074),
                                                   (0.012, -0.018, 0.074),
                                                   (0.012, 0.018, 0.074))])  # fmt: skip
    barrel = straight((0.015, 0, 0.063), (0.12, 0, 0.066), 0.0045, 10)
    hatch = disc(0.012, 0.005, (-0.018, 0.005, 0.0735))
    return [(tracks[0], dye(look, "charcoal")), (tracks[1], dye(look, "charcoal")), (hull, tile),
            (turret, tile), (barrel, tile), (hatch, tile),
            (join(wheels), dye(look, "olive", "gray"))]  # fmt: skip


def _stone(look: Look, *colors: str) -> Tile:
    """Return a texture of stone in the requested colour, or else in one of ``colors``."""
    color = look.color(*colors)
    if look.material:
        return look.surface(color, "stone")
    if look.chance(0.5):
        return surfaces.marble(look.rng, color, tint_color(color, 0.7))
    return surfaces.spots(look.rng, color, tint_color(color, 0.65), 0.2)


@category("obelisk", size=(0.0586, 0.0586, 0.168), mass=0.4, material="stone",
          aliases=("obelisk model", "stone obelisk", "egyptian obelisk"), themes=("living",),
          roles=("tall",), colors=("gray",))  # fmt: skip
def obelisk(look: Look) -> Shape:
    """An obelisk on a stepped base."""
    k = look.between(0.85, 1.2)
    steps = [at_box(0.06, 0.06, 0.01), at_box(0.046, 0.046, 0.012, (0, 0, 0.01))]
    shaft = drum(0.021, 0.13, (0, 0, 0.022), top=0.013, sides=4).turn(2, np.pi / 4)
    tip = drum(0.013, 0.02, (0, 0, 0.152), top=0.0005, sides=4).turn(2, np.pi / 4)
    stone = _stone(look, "gray", "beige", "charcoal", "tan", "terracotta")
    return put_down([(join([*steps, shaft, tip]), stone)], *steps, shaft, tip, factor=k)


@category("eiffel_tower", size=(0.107, 0.107, 0.2), mass=0.3, material="metal", assembled=True,
          aliases=("eiffel tower model", "model eiffel tower", "miniature eiffel tower",
          "eiffel tower figurine"), themes=("living",), roles=("tall",),
          colors=("bronze", "black"))  # fmt: skip
def eiffel_tower(look: Look) -> Shape:
    """A small metal model of the Eiffel Tower."""
    color = look.color("bronze", "black", "gold", "silver", "copper", "brown")
    k = look.between(0.85, 1.2)
    levels = [(0.05, 0.0), (0.034, 0.035), (0.026, 0.06), (0.014, 0.1), (0.006, 0.16),
              (0.003, 0.185)]  # fmt: skip
    slim = [0.006, 0.005, 0.004, 0.003, 0.002, 0.0016]
    line = [(r - 0.006 * (r > 0.01), z) for r, z in levels]
    legs = [
        rod([(sx * r, sy * r, z) for r, z in line], slim, 4, 3) for sx in (-1, 1) for sy in (-1, 1)
    ]
    decks = [box(2 * r, 2 * r, 0.005).move(z=z) for r, z in ((0.036, 0.036), (0.02, 0.08),
                                                             (0.008, 0.155))]  # fmt: skip
    rungs = []
    for (r, z), (q, w) in itertools.pairwise(levels[1:5]):
        for s in (-1, 1):
            for t in (-1, 1):
                e, f = 0.93 * r - 0.004, 0.93 * q - 0.003
                rungs.append(straight((t * e, s * e, z), (-t * f, s * f, w), 0.0013, 4))
                rungs.append(straight((s * e, t * e, z), (s * f, -t * f, w), 0.0013, 4))
    arch = [rod([(-0.036, s * 0.044, 0.008), (0, s * 0.037, 0.033), (0.036, s * 0.044, 0.008)],
                0.002, 5) for s in (-1, 1)]  # fmt: skip
    tip = straight((0, 0, 0.16), (0, 0, 0.2), [0.004, 0.001], 6)
    feet = [
        box(0.016, 0.016, 0.006).move(sx * 0.045, sy * 0.045) for sx in (-1, 1) for sy in (-1, 1)
    ]
    iron = surfaces.brushed_metal(look.rng, color)
    whole = join([*legs, *decks, *rungs, *arch, tip, *feet])
    return put_down([(whole, iron)], join(feet), join([*legs, *decks]), factor=k)
