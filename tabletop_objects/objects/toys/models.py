"""Objects of the ``toys`` theme: models and miniatures."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, plastic, shine
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    drum,
    facing,
    plate,
    rod,
    standing,
    standing_plate,
    straight,
)
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down
from ...kit.solids import Solid, join, torus
from ...kit.surfaces import Look, plain, tint_color


@category("church_model", size=(0.1, 0.15, 0.202), mass=0.25, material="wood",
          aliases=("model church", "toy church", "chapel model", "miniature church",
          "model chapel"), themes=("toys",), roles=("tall",), colors=("white",))  # fmt: skip
@from_pieces()
def church_model(look: Look) -> Pieces:
    """A church with a gabled nave, and a tower with a spire and a gold cross."""
    wall = plastic(look, "white", "cream", "beige", "gray")
    roof, dark = dye(look, "terracotta", "charcoal", "teal"), surfaces.plain((54, 60, 84))
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


@category("mosque_model", size=(0.15, 0.12, 0.158), mass=0.3, material="ceramic",
          aliases=("model mosque", "toy mosque", "taj mahal model", "taj mahal"), themes=("toys",),
          colors=("white",))  # fmt: skip
@from_pieces()
def mosque_model(look: Look) -> Pieces:
    """A mosque: a hall with an onion dome on a drum, three doors, and two minarets in front."""
    wall, gold = plastic(look, "white", "cream", "beige"), dye(look, "gold", "teal", "blue")
    hall = at_box(0.1, 0.08, 0.05, (0, 0, 0.006))
    drum = disc(0.032, 0.016, (0, 0, 0.056))
    domes = [_onion(0, 0, 0.072, 0.033)]
    towers = []
    for x in (-0.06, 0.06):
        towers += [disc(0.009, 0.13, (x, -0.04, 0.006)), disc(0.012, 0.005, (x, -0.04, 0.1))]
        domes.append(_onion(x, -0.04, 0.136, 0.009))
    dark = surfaces.plain((60, 64, 84))
    doors = [at_box(w, 0.002, h, (x, -0.0405, 0.006)) for w, h, x in (
        (0.022, 0.036, 0), (0.012, 0.024, -0.032), (0.012, 0.024, 0.032))]  # fmt: skip
    return [(at_block(0.15, 0.12, 0.006, 0.004), dye(look, "beige", "gray")), (hall, wall),
            (drum, wall), (join(domes), gold), (join(towers[:2]), wall), (join(towers[2:]), wall),
            (join(doors), dark)]  # fmt: skip


@category("temple_model", size=(0.15, 0.1, 0.112), mass=0.4, material="wood",
          aliases=("model temple", "parthenon model", "greek temple"), themes=("toys",),
          colors=("white",))  # fmt: skip
@from_pieces()
def temple_model(look: Look) -> Pieces:
    """A temple with columns and a gable."""
    stone = look.surface(look.color("white", "cream", "beige", "gray"), "stone")
    steps = [at_box(0.15 - 0.012 * k, 0.1 - 0.012 * k, 0.006, (0, 0, 0.006 * k)) for k in range(3)]
    posts = [disc(0.006, 0.055, (x, y, 0.018)) for x in np.linspace(-0.052, 0.052, 6)
             for y in (-0.03, 0.03)]  # fmt: skip
    hall = at_box(0.09, 0.036, 0.055, (0, 0.004, 0.018))
    beam = at_box(0.126, 0.076, 0.01, (0, 0, 0.073))
    gable = standing_plate([(-0.065, 0.083), (0.065, 0.083), (0, 0.112)], 0.08)
    return [(join(steps), stone), (join(posts), stone), (hall, stone), (beam, stone),
            (gable, stone)]  # fmt: skip


@category("pagoda", size=(0.12, 0.12, 0.21), mass=0.3, material="ceramic",
          aliases=("model pagoda", "pagoda model", "japanese temple"), themes=("toys",),
          roles=("tall",), colors=("red",))  # fmt: skip
@from_pieces()
def pagoda(look: Look) -> Pieces:
    """A pagoda of four storeys, smaller towards the top, with wide roofs and a gold spike."""
    red, roof = plastic(look, "red", "maroon", "brown"), dye(look, "charcoal", "teal", "green")
    pieces: Pieces = [(at_box(0.12, 0.12, 0.01), dye(look, "gray"))]
    for k in range(4):
        s, z = 0.075 - 0.013 * k, 0.01 + 0.042 * k
        pieces.append((at_box(s, s, 0.03, (0, 0, z)), red))
        eave = disc(0.95 * s, 0.014, top=0.5 * s, sides=4).turn(2, np.pi / 4).move(z=z + 0.029)
        pieces.append((eave, roof))
    return [*pieces, (straight((0, 0, 0.175), (0, 0, 0.21), (0.004, 0.001)), shine(look, "gold"))]


@category("volcano", size=(0.241, 0.241, 0.119), mass=0.4, material="plastic",
          aliases=("toy volcano", "model volcano", "volcano kit"), themes=("toys", "lab"),
          roles=("big",), colors=("brown",))  # fmt: skip
def volcano(look: Look) -> Shape:
    """A model volcano with lava running down its sides."""
    color = look.color("brown", "charcoal", "gray", "terracotta")
    k = look.between(0.85, 1.15)
    cone = standing(
        (0.11, 0), (0.1, 0.008), (0.062, 0.06), (0.032, 0.115), (0.022, 0.115), sides=26
    )
    pool = drum(0.026, 0.004, (0, 0, 0.113))
    streams = []
    for n in range(6):
        a = 1.05 * n + look.between(-0.2, 0.2)
        long = look.between(0.35, 0.9)
        path = [(0.024, 0, 0.117), (0.036, 0, 0.111), (0.036 + 0.034 * long, 0, 0.111 - 0.06
                                                       * long), (0.036 + 0.055 * long, 0, 0.111
                                                                 - 0.088 * long)]  # fmt: skip
        streams.append(rod(path, [0.007, 0.007, 0.006, 0.008], 8).turn(2, a))
    base = drum(0.125, 0.008, sides=32)
    return put_down([(cone, surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.25)),
                     (base, plain((96, 140, 70))),
                     (join([pool, *streams]), surfaces.gradient((200, 40, 24), (250, 160, 40),
                                                                look.rng))], base, cone,
                    factor=k)  # fmt: skip


@category("wind_turbine", size=(0.14, 0.0876, 0.239), mass=0.12, material="plastic", assembled=True,
          aliases=("wind turbine model", "model wind turbine", "toy wind turbine", "windmill"),
          themes=("toys",), roles=("tall",), colors=("white",))  # fmt: skip
def wind_turbine(look: Look) -> Shape:
    """A white wind turbine on a green base."""
    color = look.color("white", "silver", "sky")
    k = look.between(0.8, 1.15)
    base = drum(0.045, 0.01, bevel=0.003)
    mast = drum(0.0075, 0.17, (0, 0, 0.008), top=0.0045)
    pod = at_box(0.014, 0.036, 0.014, (0, 0.002, 0.172))
    hub = ball(0.014, 0.018, 0.014, (0, -0.018, 0.179), 12)
    turn = look.between(0, 2)
    blades = []
    for n in range(3):
        rim = [(-0.003, 0.0), (0.006, 0.012), (0.008, 0.025), (0.001, 0.085), (-0.002, 0.085)]
        blades.append(
            facing(plate(rim, 0.003)).turn(1, turn + n * 2 * np.pi / 3).move(0, -0.019, 0.179)
        )
    return put_down([(base, plain(look.own_color("green", "lime", "tan"))),
                     (join([mast, pod, hub, *blades]), plain(color))], base, mast, pod, *blades,
                    factor=k)  # fmt: skip


@category("orrery", size=(0.201, 0.206, 0.116), mass=0.4, material="wood", assembled=True,
          aliases=("solar system model", "model solar system", "planetarium",
          "model of the solar system"), themes=("toys",), roles=("big",),
          colors=("gold",))  # fmt: skip
def orrery(look: Look) -> Shape:
    """A model of the sun and its planets on arms around a post."""
    color = look.color("gold", "wooden", "black", "bronze")
    k = look.between(0.85, 1.1)
    base, post = drum(0.05, 0.014, bevel=0.004), drum(0.005, 0.075, (0, 0, 0.012))
    sun = ball(0.05, 0.05, 0.05, (0, 0, 0.1), 20)
    tones = [(150, 140, 130), (220, 180, 120), (60, 120, 190), (190, 80, 50), (210, 170, 130),
             (220, 196, 140), (90, 130, 190)]  # fmt: skip
    arms, pieces = [], []
    for n, tone in enumerate(tones):
        a, r, z = 2.3 * n + 0.4, 0.045 + 0.0135 * n, 0.03 + 0.006 * n
        x, y = r * np.cos(a), r * np.sin(a)
        d = (0.01, 0.014, 0.015, 0.012, 0.026, 0.022, 0.018)[n]
        arms += [straight((0, 0, z), (x, y, z), 0.0014, 6), straight((x, y, z), (x, y, z + 0.03),
                                                                     0.0012, 6)]  # fmt: skip
        pieces.append((ball(d, d, d, (x, y, z + 0.03 + d / 2), 12), plain(tone)))
        if n == 5:
            pieces.append((torus(0.017, 0.0016, 22, 6).scale(1, 1, 0.5).move(x, y, z + 0.041),
                           plain((230, 214, 170))))  # fmt: skip
    metal = look.surface(color, "brass")
    return put_down([(join([base, post, *arms]), metal), (sun, surfaces.gradient((240, 150, 40),
                                                                                 (250, 220, 90),
                                                                                 look.rng)),
                     *pieces], base, post, sun, *(s for s, _ in pieces[2:]), factor=k)  # fmt: skip
