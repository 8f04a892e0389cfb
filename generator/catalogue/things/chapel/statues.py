"""Statues of the holy, and models of the houses they are in."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import Drawing, at_block, at_box, disc, dye, of, plastic, shine, standing
from ...build.recipes import Pieces, ball, rod, standing_plate, straight
from ...build.solids import Solid, join
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def _cast(look: Look, *palette: str) -> textures.Tile:
    """Bronze, gold, stone or jade."""
    color = look.color(*palette)
    return look.surface(color, look.pick(["metal", "stoneware"]))


def _head(z: float, r: float) -> list[Solid]:
    """A head with long ears, a bun and a topknot."""
    ears = [ball(0.2 * r, 0.35 * r, 0.9 * r, (s * 0.9 * r, 0, z - 0.15 * r), 8) for s in (-1, 1)]
    return [ball(1.75 * r, 1.8 * r, 2.1 * r, (0, 0, z), 18), *ears,
            ball(1.85 * r, 1.8 * r, 1.5 * r, (0, 0.12 * r, z + 0.5 * r), 16),
            ball(0.8 * r, 0.8 * r, 0.8 * r, (0, 0.1 * r, z + 1.25 * r), 12)]  # fmt: skip


def _face(z: float, y: float, r: float) -> list[Solid]:
    """Closed eyes, a nose and a mouth."""
    eyes = [ball(0.42 * r, 0.12 * r, 0.1 * r, (s * 0.38 * r, y + 0.06 * r, z + 0.08 * r), 8)
            for s in (-1, 1)]  # fmt: skip
    return [*eyes, ball(0.5 * r, 0.12 * r, 0.1 * r, (0, y + 0.06 * r, z - 0.5 * r), 8)]


def _buddha(look: Look) -> Pieces:
    """A seated figure with crossed legs, hands in its lap, on a lotus seat."""
    tile = _cast(look, "gold", "bronze", "gray", "sage", "charcoal")
    seat = standing((0.055, 0), (0.06, 0.006), (0.05, 0.014), (0.056, 0.024), (0.05, 0.026))
    legs = [ball(0.062, 0.042, 0.03, (s * 0.03, -0.012, 0.036), 16) for s in (-1, 1)]
    lap = ball(0.07, 0.06, 0.034, (0, 0, 0.036), 16)
    body = standing((0.03, 0.03), (0.028, 0.06), (0.034, 0.085), (0.03, 0.096), (0.012, 0.104),
                    (0.01, 0.11)).scale(1, 0.72, 1)  # fmt: skip
    arms = [rod([(s * 0.03, 0, 0.092), (s * 0.042, -0.006, 0.066), (s * 0.03, -0.024, 0.052),
                 (s * 0.006, -0.032, 0.05)], [0.01, 0.0095, 0.008, 0.007], 10) for s in (-1,
             1)]  # fmt: skip
    head = _head(0.125, 0.017)
    dark = textures.plain(tint_color(look.own_color("charcoal"), 0.7))
    return [(seat, tile), (join([lap, *legs]), tile), (join([body, *arms]), tile),
            (join(head), tile), (join(_face(0.125, -0.0155, 0.017)), dark)]  # fmt: skip


def _buddha_head(look: Look) -> Pieces:
    tile = _cast(look, "gray", "gold", "bronze", "cream", "charcoal")
    base = at_block(0.08, 0.07, 0.02, 0.01)
    neck = standing((0.03, 0.02), (0.026, 0.05))
    curls = [ball(0.011, 0.011, 0.011, (0.044 * np.sin(t) * np.cos(a), 0.006 + 0.045 * np.sin(t)
             * np.sin(a), 0.112 + 0.044 * np.cos(t)), 6)
             for t in (0.5, 0.9, 1.3) for a in np.linspace(-0.35, np.pi + 0.35, 11)]  # fmt: skip
    dark = textures.plain((44, 40, 38))
    return [(base, tile), (neck, tile), (join(_head(0.1, 0.046)), tile), (join(curls), tile),
            (join(_face(0.1, -0.041, 0.046)), dark)]  # fmt: skip


def _robed_figure(robe: tuple[str, ...], veil: tuple[str, ...], halo: bool) -> Drawing:
    """A standing robed figure, hands folded, a veil over its head."""

    def draw(look: Look) -> Pieces:
        gown, cover = plastic(look, *robe), dye(look, *veil)
        skin = dye(look, "tan", "beige", "cream")
        base = disc(0.036, 0.012, sides=28)
        body = standing((0.032, 0.012), (0.03, 0.05), (0.022, 0.1), (0.026, 0.13), (0.012, 0.148))
        cloak = standing((0.034, 0.012), (0.035, 0.07), (0.03, 0.125), (0.02, 0.152),
                         (0.0165, 0.175), (0.006, 0.186)).scale(1, 0.82,
             1).move(y=0.007)  # fmt: skip
        face = ball(0.024, 0.024, 0.03, (0, -0.006, 0.164), 14)
        arms = [rod([(s * 0.024, -0.004, 0.128), (s * 0.02, -0.022, 0.108), (s * 0.003, -0.03,
             0.118)],
                    [0.008, 0.0075, 0.006], 10) for s in (-1, 1)]  # fmt: skip
        hands = ball(0.01, 0.012, 0.02, (0, -0.033, 0.126), 10)
        pieces: Pieces = [(base, dye(look, "gold", "white")), (body, gown), (cloak, cover),
                          (face, skin), (join(arms), cover), (hands, skin)]  # fmt: skip
        if halo:
            ring = disc(0.024, 0.0025).turn(0, np.pi / 2).move(0, 0.02, 0.168)
            pieces.append((ring, shine(look, "gold")))
        return pieces

    return draw


def _deity(many: bool, elephant: bool) -> Drawing:
    """A seated Hindu deity with a tall crown, four arms; an elephant's head or a human one."""

    def draw(look: Look) -> Pieces:
        tile = _cast(look, "gold", "bronze", "copper", "blue" if not elephant else "gold")
        gold = shine(look, "gold")
        seat = standing((0.055, 0), (0.058, 0.012), (0.05, 0.02))
        legs = [ball(0.06, 0.045, 0.032, (s * 0.03, -0.01, 0.032), 16) for s in (-1, 1)]
        belly = ball(0.066, 0.056, 0.07, (0, 0, 0.062), 18)
        arms = []
        for s in (-1, 1):
            arms += [rod([(s * 0.03, 0, 0.085), (s * 0.055, -0.01, 0.07), (s * 0.05, -0.03, 0.06)],
                         [0.009, 0.008, 0.007], 8),
                     rod([(s * 0.03, 0.004, 0.088), (s * 0.062, 0.004, 0.092),
                          (s * 0.06, 0, 0.122)], [0.009, 0.008, 0.006], 8)]  # fmt: skip
        head = [ball(0.038, 0.036, 0.04, (0, -0.004, 0.114), 16)]
        if elephant:
            head += [ball(0.032, 0.008, 0.04, (s * 0.032, 0.002, 0.114), 12) for s in (-1, 1)]
            head.append(rod([(0, -0.018, 0.112), (0, -0.032, 0.098), (0.004, -0.034, 0.076),
                             (0.014, -0.038, 0.064)], [0.01, 0.009, 0.0075, 0.005],
             10))  # fmt: skip
        crown = standing((0.02, 0.126), (0.021, 0.134), (0.013, 0.148), (0.004, 0.164))
        back = standing_plate(np.column_stack([0.05 * np.cos(t := np.linspace(0, 2 * np.pi,
             28)[:-1]),
                                               0.1 + 0.05 * np.sin(t)]), 0.004, 0.022)  # fmt: skip
        stay = at_box(0.02, 0.006, 0.06, (0, 0.022, 0))
        pieces: Pieces = [(seat, tile), (join([*legs, belly]), tile), (join(arms), tile),
                          (join(head), tile), (crown, gold)]  # fmt: skip
        return [*pieces, (join([back, stay]), gold)] if many else pieces

    return draw


def _totem(look: Look) -> Pieces:
    """A carved pole of stacked faces with wings."""
    wood = look.surface(look.color("brown", "wooden", "tan"), "wood")
    pieces: Pieces = [(disc(0.034, 0.01), wood)]
    eyes, beaks = [], []
    for k in range(3):
        z = 0.01 + 0.055 * k
        pieces.append((disc(0.026, 0.053, (0, 0, z)), wood if k % 2 else dye(
            look, "red", "teal", "mustard")))  # fmt: skip
        eyes += [ball(0.015, 0.008, 0.013, (s * 0.011, -0.023, z + 0.036), 10) for s in (-1, 1)]
        beaks.append(ball(0.02, 0.03, 0.012, (0, -0.024, z + 0.016), 10))
    wings = [at_box(0.05, 0.008, 0.032, (s * 0.046, 0, 0.128)) for s in (-1, 1)]
    return [*pieces, (join(wings), dye(look, "red", "teal")), (join(eyes), dye(look, "white")),
            (join(beaks), dye(look, "black", "yellow"))]  # fmt: skip


def _church(look: Look) -> Pieces:
    wall = plastic(look, "white", "cream", "beige", "gray")
    roof, dark = dye(look, "terracotta", "charcoal", "teal"), textures.plain((54, 60, 84))
    nave = at_box(0.06, 0.1, 0.055, (0, 0.02, 0.006))
    top = standing_plate([(-0.034, 0.061), (0.034, 0.061), (0, 0.095)], 0.104, 0.02)
    tower = at_box(0.034, 0.034, 0.11, (0, -0.045, 0.006))
    spire = disc(0.026, 0.07, (0, -0.045, 0.116), top=0.0005, sides=4).turn(2, np.pi / 4)
    spire = disc(0.026, 0.07, top=0.0005, sides=4).turn(2, np.pi / 4).move(0, -0.045, 0.116)
    cross = [at_box(0.002, 0.002, 0.018, (0, -0.045, 0.184)), at_box(0.01, 0.002, 0.002,
             (0, -0.045, 0.194))]  # fmt: skip
    holes = [at_box(0.014, 0.002, 0.026, (0, -0.062, 0.006)), at_box(0.01, 0.002, 0.02,
             (0, -0.062, 0.08))] + [at_box(0.0612, 0.011, 0.026, (0, y, 0.022)) for y in
             (0.0, 0.025, 0.05)]  # fmt: skip
    return [(at_block(0.1, 0.15, 0.006, 0.004), dye(look, "green", "gray")), (nave, wall),
            (top, roof), (tower, wall), (spire, roof), (join(cross), shine(look, "gold")),
            (join(holes), dark)]  # fmt: skip


def _onion(x: float, y: float, z: float, r: float) -> Solid:
    return standing((0.8 * r, 0), (r, 0.45 * r), (0.95 * r, 0.85 * r), (0.5 * r, 1.5 * r),
                    (0.12 * r, 1.9 * r), (0.04 * r, 2.4 * r)).move(x, y, z)  # fmt: skip


def _mosque(look: Look) -> Pieces:
    wall, gold = plastic(look, "white", "cream", "beige"), dye(look, "gold", "teal", "blue")
    hall = at_box(0.1, 0.08, 0.05, (0, 0, 0.006))
    drum = disc(0.032, 0.016, (0, 0, 0.056))
    domes = [_onion(0, 0, 0.072, 0.033)]
    towers = []
    for x in (-0.06, 0.06):
        towers += [disc(0.009, 0.13, (x, -0.04, 0.006)), disc(0.012, 0.005, (x, -0.04, 0.1))]
        domes.append(_onion(x, -0.04, 0.136, 0.009))
    dark = textures.plain((60, 64, 84))
    doors = [at_box(w, 0.002, h, (x, -0.0405, 0.006)) for w, h, x in (
        (0.022, 0.036, 0), (0.012, 0.024, -0.032), (0.012, 0.024, 0.032))]  # fmt: skip
    return [(at_block(0.15, 0.12, 0.006, 0.004), dye(look, "beige", "gray")), (hall, wall),
            (drum, wall), (join(domes), gold), (join(towers[:2]), wall), (join(towers[2:]), wall),
            (join(doors), dark)]  # fmt: skip


def _temple(look: Look) -> Pieces:
    """A temple of columns with a gable."""
    stone = look.surface(look.color("white", "cream", "beige", "gray"), "stone")
    steps = [at_box(0.15 - 0.012 * k, 0.1 - 0.012 * k, 0.006, (0, 0, 0.006 * k)) for k in range(3)]
    posts = [disc(0.006, 0.055, (x, y, 0.018)) for x in np.linspace(-0.052, 0.052, 6)
             for y in (-0.03, 0.03)]  # fmt: skip
    hall = at_box(0.09, 0.036, 0.055, (0, 0.004, 0.018))
    beam = at_box(0.126, 0.076, 0.01, (0, 0, 0.073))
    gable = standing_plate([(-0.065, 0.083), (0.065, 0.083), (0, 0.112)], 0.08)
    return [
        (join(steps), stone),
        (join(posts), stone),
        (hall, stone),
        (beam, stone),
        (gable, stone),
    ]


def _pagoda(look: Look) -> Pieces:
    red, roof = plastic(look, "red", "maroon", "brown"), dye(look, "charcoal", "teal", "green")
    pieces: Pieces = [(at_box(0.12, 0.12, 0.01), dye(look, "gray"))]
    for k in range(4):
        s, z = 0.075 - 0.013 * k, 0.01 + 0.042 * k
        pieces.append((at_box(s, s, 0.03, (0, 0, z)), red))
        eave = disc(0.95 * s, 0.014, top=0.5 * s, sides=4).turn(2, np.pi / 4).move(z=z + 0.029)
        pieces.append((eave, roof))
    return [*pieces, (straight((0, 0, 0.175), (0, 0, 0.21), (0.004, 0.001)), shine(look, "gold"))]


def _lighthouse(look: Look) -> Pieces:
    color: RGB = look.color("red", "navy", "white")
    rock = standing((0.045, 0), (0.04, 0.012), (0.03, 0.02), sides=9)
    body = disc(0.024, 0.12, (0, 0, 0.018), top=0.015)
    deck, room = disc(0.021, 0.004, (0, 0, 0.138)), disc(0.011, 0.02, (0, 0, 0.142))
    roof = disc(0.014, 0.018, (0, 0, 0.162), top=0.0008)
    stripes = textures.stripes([color, (240, 238, 232)], 3)
    return [(rock, dye(look, "gray", "charcoal")), (body, stripes), (deck, dye(look, "charcoal")),
            (room, textures.plain((250, 226, 140))), (roof, textures.plain(color))]  # fmt: skip


def _windmill(look: Look) -> Pieces:
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


CATEGORIES = (
    Category("buddha_statue", of(_buddha, bodies=4), (0.12, 0.12, 0.155), 0.5, ("buddha",
             "buddha figurine", "jade buddha", "buddha figure", "seated buddha", "guanyin statue",
             "meditating statue", "golden buddha"), ("living",), (), ("gold", "bronze")),
    Category("buddha_head", of(_buddha_head, bodies=4), (0.0976, 0.0994, 0.183), 0.9,
             ("head of buddha", "buddha bust"), ("living",), ("tall",), ("gray",)),
    Category("virgin_mary_statue", of(_robed_figure(("white", "cream"), ("sky", "blue"), True),
             bodies=4),
             (0.072, 0.072, 0.192), 0.4, ("virgin mary", "madonna", "madonna statue",
             "our lady statue", "mary statue", "mary figurine"), ("living",), ("tall",),
             ("white",)),
    Category("nativity_figure", of(_robed_figure(("brown", "crimson", "purple", "tan"),
             ("brown", "navy", "green", "maroon"), False), bodies=4), (0.072, 0.072, 0.186), 0.3,
             ("nativity figurine", "saint statue", "saint figurine", "jesus statue", "monk statue",
              "shepherd figure", "apostle statue", "jesus figurine", "monk figurine", "wise man",
              "angel statue"), ("living",), ("tall",), ("brown",)),
    Category("ganesha_statue", of(_deity(True, True), bodies=4), (0.141, 0.115, 0.163), 0.5,
             ("ganesha", "ganesh", "ganesh statue", "ganesha figurine", "ganesh figurine"),
             ("living",), (), ("gold",)),
    Category("shiva_statue", of(_deity(True, False), bodies=4), (0.146, 0.119, 0.168), 0.5,
             ("shiva", "vishnu statue", "hindu statue", "krishna figurine", "krishna statue",
              "lakshmi statue", "hindu deity", "hindu god", "nataraja"), ("living",), (),
             ("bronze",)),
    Category("totem", of(_totem), (0.142, 0.07, 0.175), 0.2, (
             "tiki statue", "tiki"), ("living",), ("tall",), ("brown",)),
    Category("church_model", of(_church), (0.1, 0.15, 0.202), 0.25, ("model church",
             "toy church", "chapel model", "miniature church", "model chapel"), ("toys",),
             ("tall",),
             ("white",)),
    Category("mosque_model", of(_mosque), (0.15, 0.12, 0.158), 0.3, ("model mosque",
             "toy mosque", "taj mahal model", "taj mahal"), ("toys",), (), ("white",)),
    Category("temple_model", of(_temple), (0.15, 0.1, 0.112), 0.4, ("model temple",
             "parthenon model", "greek temple"), ("toys",), (), ("white",)),
    Category("pagoda", of(_pagoda), (0.12, 0.12, 0.21), 0.3, ("model pagoda", "pagoda model",
             "japanese temple"), ("toys",), ("tall",), ("red",)),
    Category("model_lighthouse", of(_lighthouse), (0.0861, 0.0848, 0.175), 0.25, ("lighthouse",
             "lighthouse model", "toy lighthouse", "miniature lighthouse", "lighthouse figurine"),
             ("living",), ("tall",), ("red",)),
    Category("model_windmill", of(_windmill), (0.137, 0.0921, 0.186), 0.2, (
             "windmill model", "miniature windmill", "dutch windmill"),
             ("living",), ("tall",), ("white",)),
)  # fmt: skip
"""The module's categories."""
