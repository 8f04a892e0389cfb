"""Objects of the ``toys`` theme: vehicles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import DARK, plastic, steel
from ...kit.outlines import arc
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    drum,
    facing,
    plate,
    rod,
    side_view,
    standing,
    standing_plate,
    straight,
)
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...kit.surfaces import RGB, Look, Tile, plain, tint_color

BLACK = surfaces.plain((34, 34, 37))


@category("toy_crane", size=(0.192, 0.0726, 0.173), mass=0.2, material="plastic",
          aliases=("crane", "crane truck", "tower crane model", "model crane"), themes=("toys",),
          colors=("yellow",))  # fmt: skip
@from_pieces(bodies=5)
def toy_crane(look: Look) -> Pieces:
    """A wheeled toy crane with a lattice arm and a hook."""
    tile = plastic(look, "yellow", "orange", "red", "blue")
    base = at_block(0.13, 0.06, 0.02, 0.006, (0, 0, 0.014))
    wheels = [disc(0.014, 0.01).turn(0, np.pi / 2).move(x, s * 0.031 + 0.005, 0.014)
              for x in (-0.045, 0, 0.045) for s in (-1, 1)]  # fmt: skip
    cab = at_block(0.05, 0.05, 0.05, 0.006, (-0.02, 0, 0.034))
    pane = at_box(0.02, 0.0505, 0.022, (-0.006, 0, 0.054))
    boom = [straight((0.0, s * 0.014, 0.06), (0.115, s * 0.005, 0.17), 0.0032, 6) for s in (-1, 1)]
    rungs = [straight((0.0 + 0.115 * t, -0.014 + 0.009 * t, 0.06 + 0.11 * t),
                      (0.115 * t + 0.0, 0.014 - 0.009 * t, 0.06 + 0.11 * t), 0.002, 5)
             for t in np.linspace(0.1, 0.95, 8)]  # fmt: skip
    line = straight((0.115, 0, 0.168), (0.115, 0, 0.075), 0.0011, 5)
    hook = (tube([(*p, 0.0) for p in arc((0, 0), 0.008, -2.6, 1.2, 10)], 0.0022,
                 6).turn(0, np.pi / 2).move(0.115, 0, 0.068))  # fmt: skip
    return [(base, tile), (cab, tile), (join(boom), tile), (join(wheels[::2]), BLACK),
            (join(wheels[1::2]), BLACK), (join(rungs), tile), (join([line, hook]), BLACK),
            (pane, surfaces.plain((150, 196, 222)))]  # fmt: skip


def _side(outline: list[tuple[float, float]], width: float, bevel: float = 0.0) -> Solid:
    """Extrude a counter-clockwise side view, given in (x, z), along y to the given width."""
    return prism(outline, -width / 2, width / 2, bevel).turn(0, np.pi / 2)


@category("toy_car", size=(0.16, 0.07, 0.058), mass=0.16, material="plastic", aliases=("car",
          "model car", "miniature car", "race car", "vehicle", "matchbox car", "hot wheels car",
          "die cast car", "diecast car"), themes=("toys", "craft"),
          colors=("red", "blue", "yellow"), common=True)  # fmt: skip
def toy_car(look: Look) -> Shape:
    """A model car facing +x."""
    color = look.color("red", "blue", "navy", "silver", "yellow", "green", "white")
    paint, dark = surfaces.speckles(look.rng, color, 4), surfaces.plain((34, 38, 44))
    glass = surfaces.gradient((30, 36, 44), (92, 106, 118), look.rng)
    k, w = look.between(0.92, 1.1), look.between(0.062, 0.068)
    cabin = look.pick([-0.01, 0.0, 0.008])
    hull = _side(
        [(-0.07 * k, 0.009), (0.072 * k, 0.009), (0.08 * k, 0.016), (0.079 * k, 0.026),
         (0.052 * k, 0.034), (-0.072 * k, 0.037), (-0.079 * k, 0.03), (-0.08 * k, 0.016)],
        w, 0.006,
    )  # fmt: skip
    windows = _side(
        [(cabin - 0.06, 0.033), (cabin + 0.034, 0.031), (cabin + 0.008, 0.053),
         (cabin - 0.038, 0.054)],
        0.86 * w, 0.005,
    )  # fmt: skip
    roof = _side(
        [(cabin - 0.04, 0.0525), (cabin + 0.01, 0.0515), (cabin + 0.006, 0.0565),
         (cabin - 0.034, 0.0575)],
        0.78 * w, 0.002,
    )  # fmt: skip
    pillar = _side([(cabin - 0.018, 0.033), (cabin - 0.01, 0.033), (cabin - 0.012, 0.0535),
                    (cabin - 0.017, 0.0535)], 0.875 * w)  # fmt: skip
    places = [(x * k, s * (w / 2 - 0.004)) for x in (-0.048, 0.05) for s in (-1, 1)]
    wheel = cylinder(0.0135, 0.011, 18, bevel=0.002).turn(0, np.pi / 2).move(y=0.0055)
    rim = cylinder(0.008, 0.0122, 12).turn(0, np.pi / 2).move(y=0.0061)
    lamps = [ellipsoid(0.008, 0.013, 0.007, 10, 6).move(0.075 * k, s * 0.022, 0.0255)
             for s in (-1, 1)]  # fmt: skip
    tails = [box(0.004, 0.013, 0.006).move(-0.0785 * k, s * 0.022, 0.022) for s in (-1, 1)]
    pieces = [
        (hull, paint), (windows, glass), (roof, paint), (pillar, paint),
        (join([wheel.move(x, y, 0.0135) for x, y in places]), dark),
        (join([rim.move(x, y, 0.0135) for x, y in places]), surfaces.plain((196, 198, 202))),
        (join(lamps), surfaces.plain((246, 244, 226))),
        (join(tails), surfaces.plain((150, 20, 24))),
    ]  # fmt: skip
    if look.chance(0.4):
        stripe = surfaces.plain(look.own_color("white", "black", "yellow"))
        pieces.append(
            (box(0.044 * k, 0.014, 0.0012).turn(1, 0.28).move(0.054 * k, 0, 0.0335), stripe)
        )
        pieces.append((box(0.04, 0.014, 0.001).move(cabin - 0.014, 0, 0.0572), stripe))
    track = box_part(0.125 * k, w, 0.012)
    return shape(pieces, [track, hull_of(hull), hull_of(windows, roof)])


@category("toy_train", size=(0.115, 0.058, 0.088), mass=0.15, material="plastic",
          aliases=("train", "locomotive", "toy locomotive"), themes=("toys",),
          colors=("red", "blue"), common=True)  # fmt: skip
def toy_train(look: Look) -> Shape:
    """A wooden toy locomotive with four wheels."""
    paint = surfaces.speckles(look.rng, look.color("red", "blue", "green", "violet"), 4)
    other = surfaces.speckles(look.rng, look.own_color("yellow", "orange", "teal"), 4)
    wood = surfaces.wood(look.rng, (206, 164, 110))
    bed = block(0.11, 0.044, 0.014, 0.005, 0.002).move(z=0.014)
    boiler = cylinder(0.019, 0.062, 20, bevel=0.002).turn(1, np.pi / 2).move(-0.05, 0, 0.045)
    cab = block(0.036, 0.042, 0.052, 0.004, 0.002).move(x=0.034, z=0.028)
    roof = block(0.048, 0.05, 0.006, 0.004, 0.001).move(x=0.034, z=0.08)
    chimney = cylinder(0.0065, 0.024, 14, top=0.009).move(x=-0.034, z=0.062)
    wheels = [cylinder(0.0145, 0.007, 18, bevel=0.001).turn(0, np.pi / 2).move(x, y, 0.0145)
              for x in (-0.034, 0.034) for y in (-0.022, 0.029)]  # fmt: skip
    return shape([(bed, wood), (boiler, paint), (cab, paint), (roof, other), (chimney, other),
                  (join(wheels), other)], [box_part(0.084, 0.058, 0.014),
                                           box_part(0.11, 0.044, 0.014, (0, 0, 0.014)),
                                           box_part(0.062, 0.036, 0.036, (-0.02, 0, 0.028)),
                                           box_part(0.048, 0.05, 0.058, (0.034, 0, 0.028)),
                                           cylinder_part(0.0085, 0.022,
                                                         (-0.034, 0, 0.064))])  # fmt: skip


TYRE, GLASS = surfaces.plain((40, 40, 43)), surfaces.plain((176, 206, 224))
PALE = surfaces.plain((244, 244, 240))


def _wheels(spots: list[tuple[float, float, float]], y: float, thick: float = 0.012) -> Pieces:
    """Return a wheel and a hub on each side of a vehicle for each (x, radius, axle height)."""
    tyres: list[Solid] = []
    hubs: list[Solid] = []
    for x, r, z in spots:
        for s in (-1, 1):
            disc = cylinder(r, thick, 18, bevel=0.0015).move(z=-thick / 2).turn(0, np.pi / 2)
            tyres.append(disc.move(x, s * y, z))
            hub = cylinder(0.5 * r, thick + 0.002, 12).move(z=-thick / 2 - 0.001)
            hubs.append(hub.turn(0, np.pi / 2).move(x, s * y, z))
    return [(join(tyres), TYRE), (join(hubs), surfaces.plain((206, 206, 208)))]


def _windows(
    x: float, z: float, y: float, wide: float, tall: float, count: int, gap: float
) -> Solid:
    """Return ``count`` windows in a row on each side of a vehicle, starting at ``x``."""
    return join([box(wide, 2 * y + 0.0012, tall).move(x + gap * n, 0, z) for n in range(count)])


def _lorry(look: Look, kind: str) -> Shape:
    """A lorry facing left: a cab and its load."""
    color = look.color(
        *{
            "fire": ("red", "crimson", "yellow", "maroon"),
            "dump": ("yellow", "orange", "green"),
            "box": ("red", "blue", "green", "yellow", "orange"),
        }[kind]
    )
    other = look.own_color("yellow", "white", "gray", "blue", "orange", "silver")
    paint, second = surfaces.speckles(look.rng, color, 4), surfaces.speckles(look.rng, other, 4)
    bed = box(0.17, 0.05, 0.014).move(z=0.014)
    cab = side_view([(-0.088, 0.022), (-0.036, 0.022), (-0.036, 0.078), (-0.07, 0.078),
                     (-0.086, 0.05)], 0.062)  # fmt: skip
    pane = box(0.004, 0.052, 0.02).turn(1, 0.5).move(-0.0795, 0, 0.051)
    sides = _windows(-0.054, 0.052, 0.031, 0.022, 0.018, 1, 0.1)
    lamps = join([ball(0.006, 0.011, 0.011, (-0.087, s * 0.022, 0.034), 10) for s in (-1, 1)])
    pieces: Pieces = [(bed, surfaces.plain((70, 70, 74))), (cab, paint),
                      (join([pane, sides]), GLASS),
                      (lamps, surfaces.plain((250, 236, 160)))]  # fmt: skip
    hulls = [cab]
    if kind == "fire":
        load = block(0.115, 0.062, 0.046, 0.004, 0.002).move(0.028, 0, 0.026)
        rails = [box(0.15, 0.004, 0.005).move(0.01, s * 0.012, 0.078) for s in (-1, 1)]
        rungs = [box(0.004, 0.026, 0.004).move(-0.055 + 0.018 * n, 0, 0.0785) for n in range(8)]
        light = cylinder(0.007, 0.01, 12).move(-0.05, 0.016, 0.077)
        stripe = box(0.116, 0.0635, 0.007).move(0.028, 0, 0.04)
        pieces += [(load, paint), (join([*rails, *rungs]), PALE), (stripe, PALE),
                   (light, surfaces.plain((60, 120, 230)))]  # fmt: skip
        hulls += [load, join([*rails, *rungs])]
    elif kind == "dump":
        tub = loft(np.stack([np.array([(-a, -b, z), (c, -b, z), (c, b, z), (-a, b, z)]) for a, b, c,
                             z in ((0.026, 0.024, 0.08, 0.03), (0.03, 0.034, 0.095, 0.074))]),
                   np.array([(-0.03, -0.03), (0.09, -0.03), (0.09, 0.03),
                             (-0.03, 0.03)]))  # fmt: skip
        soil = box(0.112, 0.058, 0.003).move(0.033, 0, 0.0725)
        pieces += [(tub, second if look.chance(0.5) else paint),
                   (soil, surfaces.speckles(look.rng, (120, 88, 60), 30))]  # fmt: skip
        hulls.append(tub)
    else:
        load = box(0.122, 0.066, 0.068).move(0.03, 0, 0.027)
        pieces.append((load, second))
        hulls.append(load)
    pieces += _wheels([(-0.06, 0.016, 0.016), (0.025, 0.016, 0.016), (0.062, 0.016, 0.016)], 0.026)
    base = box_part(0.16, 0.062, 0.03)
    made = shape(pieces, [base, *[hull_of(s) for s in hulls]])
    return made.scale(look.between(0.84, 1.14))


@category("toy_truck", size=(0.19, 0.066, 0.088), mass=0.22, material="plastic", aliases=("truck",
          "lorry", "toy lorry", "dump truck", "toy dump truck", "model truck", "delivery truck",
          "tipper truck", "pickup truck", "toy tipper", "garbage truck", "toy ambulance",
          "ambulance", "toy excavator"), themes=("toys",), colors=("red", "yellow"))  # fmt: skip
def toy_truck(look: Look) -> Shape:
    """A toy lorry with a box or a tipper full of soil."""
    return _lorry(look, look.pick(["dump", "box"]))


@category("fire_truck", size=(0.178, 0.064, 0.085), mass=0.22, material="plastic",
          aliases=("fire engine", "toy fire truck", "toy fire engine", "firetruck"),
          themes=("toys",), colors=("red",))  # fmt: skip
def fire_truck(look: Look) -> Shape:
    """A toy fire engine with a ladder."""
    return _lorry(look, "fire")


@category("toy_bus", size=(0.157, 0.056, 0.078), mass=0.18, material="plastic", aliases=("bus",
          "school bus", "double decker", "double decker bus", "toy school bus", "model bus",
          "coach", "double-decker bus model"), themes=("toys",),
          colors=("red", "yellow"))  # fmt: skip
def toy_bus(look: Look) -> Shape:
    """A toy bus, sometimes with two decks."""
    color = look.color("red", "yellow", "blue", "green", "orange")
    paint = surfaces.speckles(look.rng, color, 4)
    decks = look.pick([1, 1, 2])
    h = 0.058 + 0.036 * (decks - 1)
    body = block(0.16, 0.052, h, 0.008, 0.005).turn(0, 0.0).move(z=0.012)
    glass = [_windows(-0.05, 0.038 + 0.036 * n, 0.026, 0.018, 0.02, 6, 0.023) for n in range(decks)]
    front = box(0.1605, 0.042, 0.024).move(z=0.036)
    stripe = box(0.1608, 0.0528, 0.004).move(z=0.028)
    pieces: Pieces = [(body, paint), (join([*glass, front]), GLASS),
                      (stripe, surfaces.plain(tint_color(color, 0.55)))]  # fmt: skip
    pieces += _wheels([(-0.05, 0.014, 0.014), (0.05, 0.014, 0.014)], 0.0225)
    return shape(pieces, [box_part(0.12, 0.05, 0.02), hull_of(body)]).scale(look.between(0.85, 1.1))


@category("toy_tractor", size=(0.122, 0.088, 0.086), mass=0.18, material="plastic",
          aliases=("tractor", "model tractor", "farm tractor", "toy digger", "excavator",
          "toy bulldozer", "bulldozer", "digger"), themes=("toys",),
          colors=("green", "red"))  # fmt: skip
def toy_tractor(look: Look) -> Shape:
    """A toy tractor with two large rear wheels."""
    color = look.color("green", "red", "blue", "orange")
    paint = surfaces.speckles(look.rng, color, 4)
    hood = block(0.07, 0.034, 0.03, 0.006, 0.003).move(-0.024, 0, 0.026)
    cab = block(0.045, 0.044, 0.05, 0.004, 0.002).move(0.028, 0, 0.03)
    roof = block(0.054, 0.052, 0.006, 0.006, 0.002).move(0.028, 0, 0.078)
    panes = join([box(0.034, 0.0455, 0.024), box(0.0465, 0.034, 0.024)]).move(0.028, 0, 0.05)
    pipe = straight((-0.03, 0.009, 0.05), (-0.03, 0.009, 0.078), 0.0035)
    seat = box(0.1, 0.026, 0.014).move(0, 0, 0.016)
    pieces: Pieces = [(hood, paint), (cab, paint), (roof, surfaces.plain(tint_color(color, 0.8))),
                      (panes, GLASS),
                      (join([pipe, seat]), surfaces.plain((60, 60, 64)))]  # fmt: skip
    pieces += _wheels([(0.032, 0.029, 0.029)], 0.034, 0.018)
    pieces += _wheels([(-0.04, 0.017, 0.017)], 0.026)
    wheels = [box_part(0.04, 0.086, 0.04, (0.032, 0, 0)), box_part(0.03, 0.06, 0.03, (-0.04, 0, 0))]
    return shape(pieces, [*wheels, hull_of(hood), hull_of(cab, roof)]).scale(
        look.between(0.9, 1.15)
    )


@category("toy_boat", size=(0.16, 0.064, 0.135), mass=0.12, material="wood", assembled=True,
          aliases=("boat", "ship", "toy ship", "sailboat", "toy sailboat", "sailing boat",
          "model boat", "model ship", "tugboat", "wooden boat", "yacht", "toy sailing boat",
          "gondola model"), themes=("toys",), colors=("blue", "red"))  # fmt: skip
def toy_boat(look: Look) -> Shape:
    """A toy boat: a hull with a cabin and a funnel, or with a sail."""
    color = look.color("blue", "red", "white", "green", "orange")
    paint = surfaces.stack((surfaces.plain(tint_color(color, 0.6)), 0.35),
                           (surfaces.speckles(look.rng, color, 4), 0.65))  # fmt: skip
    deck = np.array([(-0.09, 0), (-0.06, -0.022), (-0.02, -0.032), (0.07, -0.028), (0.07, 0.028),
                     (-0.02, 0.032), (-0.06, 0.022)])  # fmt: skip
    hull = loft(np.stack([np.column_stack([deck * [a, b], np.full(7, z)]) for a, b,
                          z in ((0.72, 0.6, 0), (0.9, 0.9, 0.016), (1, 1, 0.04))]),
                deck)  # fmt: skip
    top = prism(deck * [0.94, 0.9], 0.0385, 0.0415)
    wood = surfaces.wood(look.rng, (206, 164, 110), planks=5)
    pieces: Pieces = [(hull, paint), (top, wood)]
    if look.chance(0.5):
        mast = straight((-0.01, 0, 0.04), (-0.01, 0, 0.16), 0.003)
        sails = [prism(outline, -0.0008, 0.0008).turn(0, np.pi / 2) for outline in (
            [(-0.004, 0.055), (0.062, 0.055), (-0.004, 0.155)],
            [(-0.018, 0.058), (-0.018, 0.145), (-0.075, 0.058)][::1])]  # fmt: skip
        cloth = surfaces.stripes([(246, 244, 238), look.own_color("white", "red", "navy")], 4)
        pieces += [(mast, wood), (join(sails), cloth)]
        return put_down(pieces, hull, join([mast, *sails]), factor=look.between(0.9, 1.1))
    cabin = block(0.06, 0.036, 0.03, 0.004, 0.002).move(0.015, 0, 0.041)
    holes = _windows(-0.003, 0.052, 0.018, 0.01, 0.01, 3, 0.018)
    funnel = cylinder(0.01, 0.035, 16).move(0.022, 0, 0.07)
    band = cylinder(0.0104, 0.01, 16).move(0.022, 0, 0.09)
    pieces += [(cabin, PALE), (holes, GLASS), (funnel, surfaces.plain(look.own_color("red",
                                                                                     "yellow"))),
               (band, TYRE)]  # fmt: skip
    return put_down(pieces, hull, cabin, funnel, factor=look.between(0.9, 1.1))


@category("toy_rocket", size=(0.073, 0.073, 0.169), mass=0.12, material="plastic",
          aliases=("rocket", "rocket ship", "spaceship", "space shuttle", "model rocket",
          "toy spaceship", "space rocket", "space shuttle model"), themes=("toys",),
          roles=("tall",), colors=("white", "red"))  # fmt: skip
def toy_rocket(look: Look) -> Shape:
    """A toy rocket with portholes, standing on three fins."""
    color = look.color("white", "silver", "red", "blue", "orange")
    other = surfaces.plain(look.own_color("red", "orange", "blue") if sum(color) > 500
                           else (240, 240, 236))  # fmt: skip
    body = lathe([(0, 0.022), (0.018, 0.022), (0.026, 0.06), (0.027, 0.085), (0.021, 0.125),
                  (0, 0.125)], 24)  # fmt: skip
    nose = lathe([(0, 0.124), (0.0213, 0.124), (0.012, 0.15), (0.002, 0.168), (0, 0.169)], 24)
    jet = cylinder(0.012, 0.022, 18, top=0.009).move(z=0.006)
    fin = [(0.012, 0.03), (0.042, 0.0), (0.05, 0.0), (0.044, 0.045), (0.024, 0.075)]
    fins = [prism(fin, -0.002, 0.002).turn(0, np.pi / 2).turn(2, 2 * np.pi * n / 4 + 0.785)
            for n in range(4)]  # fmt: skip
    eyes = [
        cylinder(0.008, 0.004, 16).turn(0, np.pi / 2).move(0, -0.0245, z) for z in (0.095, 0.07)
    ]
    rims = [
        cylinder(0.0105, 0.003, 16).turn(0, np.pi / 2).move(0, -0.0243, z) for z in (0.095, 0.07)
    ]
    pieces: Pieces = [(body, surfaces.speckles(look.rng, color, 4)), (join([nose, *fins]), other),
                      (join([jet, *rims]), surfaces.plain((110, 112, 118))),
                      (join(eyes), GLASS)]  # fmt: skip
    return put_down(pieces, body, nose, join(fins), factor=look.between(0.9, 1.1))


@category("toy_helicopter", size=(0.19, 0.13, 0.086), mass=0.1, material="plastic", assembled=True,
          aliases=("helicopter", "model helicopter", "chopper", "balsa helicopter"),
          themes=("toys",), colors=("red", "blue"))  # fmt: skip
def toy_helicopter(look: Look) -> Shape:
    """A toy helicopter, standing on its skids."""
    color = look.color("red", "blue", "yellow", "green", "orange")
    paint = surfaces.speckles(look.rng, color, 4)
    body = ball(0.085, 0.05, 0.05, (-0.015, 0, 0.044), 18)
    dome = ball(0.044, 0.046, 0.042, (-0.038, 0, 0.048), 14)
    boom = straight((0.015, 0, 0.05), (0.095, 0, 0.058), [0.012, 0.005], 10)
    fin = prism([(0.085, 0.05), (0.105, 0.05), (0.11, 0.085), (0.098, 0.085)], -0.002, 0.002)
    fin = fin.turn(0, np.pi / 2)
    mast = straight((-0.015, 0, 0.066), (-0.015, 0, 0.082), 0.004)
    blades = [box(0.16, 0.011, 0.0022).turn(2, a).move(-0.015, 0, 0.081) for a in (0.5, 2.07)]
    skids = [straight((-0.06, s * 0.024, 0.003), (0.03, s * 0.024, 0.003), 0.003) for s in (-1, 1)]
    struts = [straight((x, s * 0.024, 0.003), (x, s * 0.014, 0.03), 0.0025, 6)
              for x in (-0.035, 0.01) for s in (-1, 1)]  # fmt: skip
    grey = surfaces.plain((74, 76, 82))
    pieces: Pieces = [(join([body, boom, fin]), paint), (dome, GLASS),
                      (join([mast, *blades, *skids, *struts]), grey)]  # fmt: skip
    return put_down(pieces, join([*skids, *struts]), body, join([boom, fin]), join(blades),
                   factor=look.between(0.9, 1.1))  # fmt: skip


@category("train_track", size=(0.16, 0.055, 0.0124), mass=0.05, material="wood",
          aliases=("wooden train track", "toy train track", "track piece", "railway track",
          "rail track", "toy station"), themes=("toys",), roles=("flat",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def train_track(look: Look) -> Shape:
    """A straight or curved piece of wooden track with two grooves."""
    color = look.color("wooden", "tan", "beige", "amber")
    wood = surfaces.wood(look.rng, color)
    groove = surfaces.plain(tint_color(color, 0.55))
    curved = look.chance(0.5)
    long = look.between(0.13, 0.17)

    def bow(p: np.ndarray) -> np.ndarray:
        if not curved:
            return p
        a = p[:, 0] / 0.18
        r = 0.18 - p[:, 1]
        return np.column_stack([r * np.sin(a), 0.18 - r * np.cos(a), p[:, 2]])

    def strip(y: float, wide: float, z: float, h: float) -> Solid:
        rings = [np.column_stack([np.full(4, x), [y - wide / 2, y + wide / 2, y + wide / 2,
                                                  y - wide / 2], [z, z, z + h, z + h]])
                 for x in np.linspace(-long / 2, long / 2, 9)]  # fmt: skip
        section = np.array([(-wide, -h), (wide, -h), (wide, h), (-wide, h)])
        return loft(np.stack(rings), section).bend(bow)

    bed = strip(0, 0.04, 0, 0.012)
    ruts = [strip(s * 0.0125, 0.006, 0.0118, 0.0006) for s in (-1, 1)]
    knob = join([box(0.012, 0.005, 0.012).move(long / 2 + 0.005), cylinder(0.006, 0.012, 14).move(
        long / 2 + 0.014)]).bend(bow)  # fmt: skip
    return put_down([(join([bed, knob]), wood), (join(ruts), groove)], bed)


def _paper(look: Look, color: RGB) -> Tile:
    """Return coloured paper, plain or patterned."""
    if look.chance(0.5):
        return surfaces.speckles(look.rng, color, 4, 32)
    image = prints.canvas(64, 64, color)
    for n in range(16):
        x, y = (n % 4 + 0.5 * (n // 4 % 2)) / 4 + 0.06, (n // 4 + 0.5) / 4
        prints.disc(
            image, x, y, 0.05, tint_color(color, 1.6) if sum(color) < 560 else (200, 90, 90)
        )
    return image


def sheet(*corners: tuple[float, float, float], thick: float = 0.0012) -> Solid:
    """Return a thin, flat piece of paper with corners at the given points (x, y, z)."""
    p = np.array(corners, float)
    way = np.cross(p[1] - p[0], p[2] - p[0])
    way = way / np.linalg.norm(way) * thick / 2
    rows = np.stack([p - way, p + way])
    flat = np.column_stack([np.zeros(len(p)), np.zeros(len(p))])
    u = (p[1] - p[0]) / np.linalg.norm(p[1] - p[0])
    v = np.cross(way / np.linalg.norm(way), u)
    flat = np.column_stack([(p - p[0]) @ u, (p - p[0]) @ v])
    return loft(rows, flat)


@category("paper_plane", size=(0.226, 0.147, 0.0356), mass=0.005, material="paper", assembled=True,
          aliases=("paper airplane", "paper aeroplane", "paper dart", "folded plane"),
          themes=("toys", "craft"), colors=("white",))  # fmt: skip
def paper_plane(look: Look) -> Shape:
    """A folded paper plane."""
    color = look.color("white", "cream", "sky", "yellow", "red", "mint")
    k, w = look.between(0.75, 1.15), look.between(0.85, 1.2)
    wings = [sheet((0.11, s * 0.001, 0.026), (-0.11, s * 0.004, 0.026),
                   (-0.11, s * 0.065 * w, 0.034)) for s in (1, -1)]  # fmt: skip
    keel = [sheet((0.11, s * 0.0008, 0.026), (-0.11, s * 0.004, 0.026), (-0.11, s * 0.0008, 0.0),
                   (-0.02, s * 0.0008, 0.0)) for s in (1, -1)]  # fmt: skip
    foot = plate([(-0.1, -0.012), (0.02, -0.004), (0.02, 0.004), (-0.1, 0.012)], 0.002)
    image = prints.canvas(64, 64, color)
    if look.chance(0.5):
        for n in range(1, 8):
            prints.fill(image, 0, n / 8, 1, 0.015, (130, 160, 210))
    return put_down([(join(wings), image), (join([*keel, foot]), plain(tint_color(color, 0.9)))],
                    foot, *wings, factor=k)  # fmt: skip


@category("paper_boat", size=(0.144, 0.0584, 0.0688), mass=0.005, material="paper", assembled=True,
          aliases=("origami boat", "folded boat", "paper ship"), themes=("toys", "craft"),
          colors=("white",))  # fmt: skip
def paper_boat(look: Look) -> Shape:
    """A folded paper boat with a raised middle fold."""
    color = look.color("white", "blue", "red", "yellow", "mint", "cream")
    k = look.between(0.75, 1.25)
    hull = [sheet((-0.075, s * 0.001, 0.05), (-0.03, s * 0.014, 0.0), (0.03, s * 0.014, 0.0),
                   (0.075, s * 0.001, 0.05), (0.0, s * 0.03, 0.036)) for s in (1, -1)]  # fmt: skip
    bottom = plate([(-0.04, 0), (-0.03, -0.014), (0.03, -0.014), (0.04, 0), (0.03, 0.014),
                    (-0.03, 0.014)], 0.0015)  # fmt: skip
    sail = standing_plate([(-0.032, 0.004), (0.032, 0.004), (0.0, 0.072)], 0.008)
    ends = [sheet((s * 0.075, 0.001, 0.05), (s * 0.03, 0.014, 0), (s * 0.03, -0.014, 0))
            for s in (1, -1)]  # fmt: skip
    paper = _paper(look, color)
    return put_down([(join([*hull, bottom, *ends]), paper),
                     (sail, surfaces.plain(tint_color(color, 1.2)))], join([*hull, bottom]), sail,
                    factor=k)  # fmt: skip


@category("glider", size=(0.241, 0.254, 0.0537), mass=0.02, material="wood", assembled=True,
          aliases=("balsa glider", "toy glider", "balsa plane", "wooden glider",
          "balsa wood glider", "model glider"), themes=("toys",), roles=("big",),
          colors=("tan",))  # fmt: skip
def glider(look: Look) -> Shape:
    """A glider of thin balsa wood, resting on its keel."""
    color = look.color("tan", "wooden", "cream")
    k = look.between(0.8, 1.15)
    body = facing(
        plate([(-0.12, 0.012), (0.11, 0.004), (0.125, 0.012), (0.11, 0.022), (-0.12, 0.018)], 0.005)
    ).move(y=0.0025)
    wing = plate([(0.055, 0), (0.045, 0.13), (0.02, 0.13), (0.01, 0), (0.02, -0.13),
                  (0.045, -0.13)][::-1], 0.0025, at=(0, 0, 0.022))  # fmt: skip
    tail = plate([(-0.085, 0), (-0.092, 0.05), (-0.115, 0.05), (-0.12, 0), (-0.115, -0.05),
                  (-0.092, -0.05)][::-1], 0.002, at=(0, 0, 0.018))  # fmt: skip
    fin = facing(
        plate([(-0.122, 0.018), (-0.085, 0.018), (-0.11, 0.055), (-0.122, 0.055)], 0.002)
    ).move(y=0.001)
    skid = at_box(0.12, 0.03, 0.004, (0.02, 0, 0.0))
    marks = [drum(0.012, 0.0006, (0.032, s * 0.1, 0.0243)) for s in (-1, 1)]
    return put_down([(join([body, wing, tail, fin]), surfaces.wood(look.rng, color)),
                     (skid, plain(tint_color(color, 0.7))),
                     (join(marks), plain(look.own_color("red", "blue", "green")))], skid, body,
                    wing, tail, factor=k)  # fmt: skip


@category("ufo", size=(0.135, 0.135, 0.0797), mass=0.08, material="plastic",
          aliases=("ufo toy", "flying saucer", "toy ufo", "spacecraft"), themes=("toys",),
          colors=("silver",))  # fmt: skip
def ufo(look: Look) -> Shape:
    """A flying saucer with a glass dome and lights, standing on three legs."""
    color = look.color("silver", "gray", "green", "purple", "blue")
    k = look.between(0.8, 1.2)
    saucer = standing((0.02, 0.02), (0.03, 0.022), (0.065, 0.034), (0.066, 0.038), (0.034, 0.05),
                      (0.03, 0.052), sides=32)  # fmt: skip
    dome = ball(0.056, 0.056, 0.056, (0, 0, 0.05), 20)
    lamps = [ball(0.008, 0.008, 0.008, (0.05 * np.cos(a), 0.05 * np.sin(a), 0.043), 8)
             for a in np.arange(10) * np.pi / 5]  # fmt: skip
    legs, feet = [], []
    for a in np.arange(3) * 2 * np.pi / 3 + np.pi / 2:
        x, y = float(np.cos(a)), float(np.sin(a))
        legs.append(straight((0.03 * x, 0.03 * y, 0.025), (0.046 * x, 0.046 * y, 0.003), 0.003, 8))
        feet.append(drum(0.008, 0.004, (0.046 * x, 0.046 * y, 0)))
    pilot = ball(0.02, 0.02, 0.026, (0, 0, 0.062), 10)
    return put_down([(saucer, steel(look, color)), (dome, plain((150, 206, 214))),
                     (pilot, plain((110, 190, 80))), (join(lamps), plain(look.own_color("yellow",
                                                                                        "red",
                                                                                        "lime"))),
                     (join([*legs, *feet]), steel(look))], saucer, dome, join(feet),
                    factor=k)  # fmt: skip


@category("satellite", size=(0.23, 0.0685, 0.123), mass=0.15, material="metal", assembled=True,
          aliases=("satellite model", "model satellite", "toy satellite", "space probe",
          "space station"), themes=("toys",), colors=("gold", "silver"))  # fmt: skip
def satellite(look: Look) -> Shape:
    """A satellite on a stand: a foil-wrapped body, two wings of solar cells and a dish."""
    color = look.color("gold", "silver", "white", "copper")
    k = look.between(0.85, 1.15)
    base, post = drum(0.035, 0.008, bevel=0.002), drum(0.004, 0.05, (0, 0, 0.006))
    body = block(0.04, 0.036, 0.05, 0.003, 0.002).move(z=0.052)
    wings = [at_box(0.085, 0.003, 0.036, (s * 0.075, 0, 0.06)) for s in (-1, 1)]
    arms = [straight((s * 0.018, 0, 0.078), (s * 0.034, 0, 0.078), 0.003, 8) for s in (-1, 1)]
    dish = lathe(
        [(0, 0), (0.012, 0.002), (0.024, 0.009), (0.0225, 0.011), (0.011, 0.005), (0, 0.0035)], 22
    )
    dish = dish.turn(0, 0.6).move(0, -0.01, 0.104)
    horn = straight((0, -0.014, 0.107), (0, -0.024, 0.12), [0.0025, 0.0008], 6)
    cells = surfaces.grid((180, 190, 210), (36, 60, 120), 4, 8, 128, 3)
    foil = surfaces.scratches(look.rng, color, tint_color(color, 1.4), 90)
    return put_down([(body, foil), (join(wings), cells), (join([base, post]), plain(DARK)),
                     (join([*arms, dish, horn]), plain((236, 236, 240)))], base, post, body,
                    join(wings), dish, factor=k)  # fmt: skip


@category("rover", size=(0.158, 0.113, 0.117), mass=0.15, material="plastic", assembled=True,
          aliases=("rover model", "mars rover", "moon rover", "lunar rover", "toy rover"),
          themes=("toys",), colors=("white",))  # fmt: skip
def rover(look: Look) -> Shape:
    """A six-wheeled rover with a camera mast, solar panels and an arm."""
    color = look.color("white", "silver", "gold", "orange")
    k = look.between(0.85, 1.15)
    wheels = [drum(0.017, 0.014, (x, s * 0.05 - 0.007, 0.017), 1, sides=16)
              for x in (-0.052, 0, 0.052) for s in (-1, 1)]  # fmt: skip
    rockers = [rod([(-0.052, s * 0.041, 0.018), (-0.026, s * 0.04, 0.04), (0, s * 0.041, 0.02),
                    (0.03, s * 0.04, 0.044), (0.052, s * 0.041, 0.018)], 0.003, 6)
               for s in (-1, 1)]  # fmt: skip
    body = block(0.09, 0.066, 0.026, 0.004, 0.002).move(z=0.034)
    deck = at_box(0.11, 0.09, 0.003, (-0.01, 0, 0.06))
    mast = drum(0.004, 0.045, (0.042, 0.016, 0.06))
    head = [at_box(0.016, 0.03, 0.014, (0.042, 0.016, 0.104))]
    eyes = [drum(0.0045, 0.003, (0.049, 0.016 + y, 0.111), 0, sides=10) for y in (-0.008, 0.008)]
    arm = rod([(0.045, -0.02, 0.05), (0.08, -0.02, 0.062), (0.088, -0.02, 0.035)], 0.0032, 8)
    cells = surfaces.grid((170, 180, 200), (34, 48, 96), 6, 6, 96, 2)
    return put_down([(join([body, *head]), surfaces.speckles(look.rng, color, 4)), (deck, cells),
                     (join([*wheels, *eyes]), plain(DARK)), (join([*rockers, mast, arm]),
                                                             steel(look))], body, deck, mast,
                    join(wheels[:2]), join(wheels[4:]), head[0], arm, factor=k)  # fmt: skip


@category("toy_airplane", size=(0.169, 0.2, 0.0788), mass=0.13, material="plastic", assembled=True,
          aliases=("airplane", "aeroplane", "plane", "model airplane", "toy plane", "model plane",
          "aircraft", "toy aeroplane", "toy jet", "jet", "toy aircraft", "airplane toy"),
          themes=("toys",), colors=("red", "yellow"))  # fmt: skip
def toy_airplane(look: Look) -> Shape:
    """A toy aeroplane with a stout body, broad wings and a propeller or jets."""
    k = look.between(0.9, 1.15)
    color = look.color("red", "yellow", "blue", "white", "orange", "green", "silver", "wooden")
    skin = look.surface(color, "plastic")
    other = surfaces.plain(look.own_color("blue", "red", "yellow", "white", "navy", "orange"))
    body = lathe(
        [(0, 0), (0.014, 0.004), (0.021, 0.03), (0.021, 0.08), (0.009, 0.15), (0, 0.155)], 22
    )
    body = body.scale(k, k, k).turn(1, np.pi / 2).move(-0.075 * k, 0, 0.04 * k)
    wing = block(0.042 * k, 0.19 * k, 0.006 * k, 0.018 * k, 0.002).move(-0.015 * k, 0, 0.032 * k)
    tail = block(0.022 * k, 0.07 * k, 0.004 * k, 0.01 * k, 0.001).move(0.066 * k, 0, 0.042 * k)
    fin = block(0.026 * k, 0.034 * k, 0.004 * k, 0.009 * k, 0.001).turn(0, np.pi / 2)
    fin = fin.move(0.066 * k, 0.002 * k, 0.058 * k)
    glass = ellipsoid(0.04 * k, 0.024 * k, 0.026 * k, 16, 10).move(-0.022 * k, 0, 0.058 * k)
    pieces = [(join([body]), skin), (join([wing, tail, fin]), other),
              (glass, surfaces.plain((40, 54, 70)))]  # fmt: skip
    parts = [hull_of(body), hull_of(wing), hull_of(tail), hull_of(fin), hull_of(glass)]
    dark = surfaces.plain((44, 46, 50))
    if look.chance(0.6):
        hub = lathe([(0, 0), (0.006, 0), (0, 0.012)], 14).scale(k, k, k)
        hub = hub.turn(1, -np.pi / 2).move(x=-0.074 * k, z=0.04 * k)
        blades = box(0.003 * k, 0.075 * k, 0.009 * k).move(x=-0.079 * k, z=0.0355 * k)
        pieces.append((join([hub, blades]), dark))
        parts.append(hull_of(hub))
    else:
        pods = [lathe([(0, 0), (0.008, 0), (0.0095, 0.012), (0.006, 0.034), (0, 0.034)], 16)
                .scale(k, k, k).turn(1, np.pi / 2).move(-0.04 * k, s * 0.05 * k, 0.025 * k)
                for s in (-1, 1)]  # fmt: skip
        pieces.append((join(pods), dark))
        parts += [hull_of(p) for p in pods]
    wheels, legs = [], []
    for x, y in ((-0.045, 0.022), (-0.045, -0.022), (0.06, 0.0)):
        r = 0.011 * k if x < 0 else 0.006 * k
        wheels.append(cylinder(r, 0.007 * k, 16, bevel=0.001).turn(0, np.pi / 2)
                      .move(x * k, y * k + 0.0035 * k, r))  # fmt: skip
        legs.append(tube([(x * k, y * k, r), (x * k, 0.6 * y * k, 0.035 * k)], 0.0024 * k, 6))
    pieces.append((join([*wheels, *legs]), dark))
    return shape(pieces, [*parts, *(hull_of(w) for w in wheels)])
