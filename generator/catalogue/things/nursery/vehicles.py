"""Toy vehicles: trucks, buses, boats, tractors, rockets."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import side_view
from ...build.recipes import Pieces, ball, put_down, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, prism
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

TYRE, GLASS = textures.plain((40, 40, 43)), textures.plain((176, 206, 224))
PALE = textures.plain((244, 244, 240))


def _wheels(spots: list[tuple[float, float, float]], y: float, thick: float = 0.012) -> Pieces:
    """Return wheels and hubs at each (x, radius, z of the axle) on both sides."""
    tyres: list[Solid] = []
    hubs: list[Solid] = []
    for x, r, z in spots:
        for s in (-1, 1):
            disc = cylinder(r, thick, 18, bevel=0.0015).move(z=-thick / 2).turn(0, np.pi / 2)
            tyres.append(disc.move(x, s * y, z))
            hub = cylinder(0.5 * r, thick + 0.002, 12).move(z=-thick / 2 - 0.001)
            hubs.append(hub.turn(0, np.pi / 2).move(x, s * y, z))
    return [(join(tyres), TYRE), (join(hubs), textures.plain((206, 206, 208)))]


def _windows(
    x: float, z: float, y: float, wide: float, tall: float, count: int, gap: float
) -> Solid:
    """Return a row of windows on both sides, from ``x`` on."""
    return join([box(wide, 2 * y + 0.0012, tall).move(x + gap * n, 0, z) for n in range(count)])


def _lorry(look: Look, kind: str) -> Shape:
    """A lorry that drives to the left: a cab and what it carries."""
    color = look.color(
        *{
            "fire": ("red", "crimson", "yellow", "maroon"),
            "dump": ("yellow", "orange", "green"),
            "box": ("red", "blue", "green", "yellow", "orange"),
        }[kind]
    )
    other = look.own_color("yellow", "white", "gray", "blue", "orange", "silver")
    paint, second = textures.speckles(look.rng, color, 4), textures.speckles(look.rng, other, 4)
    bed = box(0.17, 0.05, 0.014).move(z=0.014)
    cab = side_view([(-0.088, 0.022), (-0.036, 0.022), (-0.036, 0.078), (-0.07, 0.078),
                     (-0.086, 0.05)], 0.062)  # fmt: skip
    pane = box(0.004, 0.052, 0.02).turn(1, 0.5).move(-0.0795, 0, 0.051)
    sides = _windows(-0.054, 0.052, 0.031, 0.022, 0.018, 1, 0.1)
    lamps = join([ball(0.006, 0.011, 0.011, (-0.087, s * 0.022, 0.034), 10) for s in (-1, 1)])
    pieces: Pieces = [
        (bed, textures.plain((70, 70, 74))),
        (cab, paint),
        (join([pane, sides]), GLASS),
        (lamps, textures.plain((250, 236, 160))),
    ]
    hulls = [cab]
    if kind == "fire":
        load = block(0.115, 0.062, 0.046, 0.004, 0.002).move(0.028, 0, 0.026)
        rails = [box(0.15, 0.004, 0.005).move(0.01, s * 0.012, 0.078) for s in (-1, 1)]
        rungs = [box(0.004, 0.026, 0.004).move(-0.055 + 0.018 * n, 0, 0.0785) for n in range(8)]
        light = cylinder(0.007, 0.01, 12).move(-0.05, 0.016, 0.077)
        stripe = box(0.116, 0.0635, 0.007).move(0.028, 0, 0.04)
        pieces += [(load, paint), (join([*rails, *rungs]), PALE), (stripe, PALE),
                   (light, textures.plain((60, 120, 230)))]  # fmt: skip
        hulls += [load, join([*rails, *rungs])]
    elif kind == "dump":
        tub = loft(
            np.stack(
                [
                    np.array([(-a, -b, z), (c, -b, z), (c, b, z), (-a, b, z)])
                    for a, b, c, z in ((0.026, 0.024, 0.08, 0.03), (0.03, 0.034, 0.095, 0.074))
                ]
            ),
            np.array([(-0.03, -0.03), (0.09, -0.03), (0.09, 0.03), (-0.03, 0.03)]),
        )
        soil = box(0.112, 0.058, 0.003).move(0.033, 0, 0.0725)
        pieces += [(tub, second if look.chance(0.5) else paint),
                   (soil, textures.speckles(look.rng, (120, 88, 60), 30))]  # fmt: skip
        hulls.append(tub)
    else:
        load = box(0.122, 0.066, 0.068).move(0.03, 0, 0.027)
        pieces.append((load, second))
        hulls.append(load)
    pieces += _wheels([(-0.06, 0.016, 0.016), (0.025, 0.016, 0.016), (0.062, 0.016, 0.016)], 0.026)
    base = box_part(0.16, 0.062, 0.03)
    made = shape(pieces, [base, *[hull_of(s) for s in hulls]])
    return made.scale(look.between(0.84, 1.14))


def truck(look: Look) -> Shape:
    """A toy lorry with a box or a tipper full of soil."""
    return _lorry(look, look.pick(["dump", "box"]))


def fire_truck(look: Look) -> Shape:
    """A toy fire engine with its ladder."""
    return _lorry(look, "fire")


def bus(look: Look) -> Shape:
    """A toy bus, some with two decks."""
    color = look.color("red", "yellow", "blue", "green", "orange")
    paint = textures.speckles(look.rng, color, 4)
    decks = look.pick([1, 1, 2])
    h = 0.058 + 0.036 * (decks - 1)
    body = block(0.16, 0.052, h, 0.008, 0.005).turn(0, 0.0).move(z=0.012)
    glass = [_windows(-0.05, 0.038 + 0.036 * n, 0.026, 0.018, 0.02, 6, 0.023) for n in range(decks)]
    front = box(0.1605, 0.042, 0.024).move(z=0.036)
    stripe = box(0.1608, 0.0528, 0.004).move(z=0.028)
    pieces: Pieces = [(body, paint), (join([*glass, front]), GLASS),
                      (stripe, textures.plain(tint_color(color, 0.55)))]  # fmt: skip
    pieces += _wheels([(-0.05, 0.014, 0.014), (0.05, 0.014, 0.014)], 0.0225)
    return shape(pieces, [box_part(0.12, 0.05, 0.02), hull_of(body)]).scale(look.between(0.85, 1.1))


def tractor(look: Look) -> Shape:
    """A toy tractor with two large wheels behind."""
    color = look.color("green", "red", "blue", "orange")
    paint = textures.speckles(look.rng, color, 4)
    hood = block(0.07, 0.034, 0.03, 0.006, 0.003).move(-0.024, 0, 0.026)
    cab = block(0.045, 0.044, 0.05, 0.004, 0.002).move(0.028, 0, 0.03)
    roof = block(0.054, 0.052, 0.006, 0.006, 0.002).move(0.028, 0, 0.078)
    panes = join([box(0.034, 0.0455, 0.024), box(0.0465, 0.034, 0.024)]).move(0.028, 0, 0.05)
    pipe = straight((-0.03, 0.009, 0.05), (-0.03, 0.009, 0.078), 0.0035)
    seat = box(0.1, 0.026, 0.014).move(0, 0, 0.016)
    pieces: Pieces = [
        (hood, paint),
        (cab, paint),
        (roof, textures.plain(tint_color(color, 0.8))),
        (panes, GLASS),
        (join([pipe, seat]), textures.plain((60, 60, 64))),
    ]
    pieces += _wheels([(0.032, 0.029, 0.029)], 0.034, 0.018)
    pieces += _wheels([(-0.04, 0.017, 0.017)], 0.026)
    wheels = [box_part(0.04, 0.086, 0.04, (0.032, 0, 0)), box_part(0.03, 0.06, 0.03, (-0.04, 0, 0))]
    return shape(pieces, [*wheels, hull_of(hood), hull_of(cab, roof)]).scale(
        look.between(0.9, 1.15)
    )


def boat(look: Look) -> Shape:
    """A toy boat: a hull with a cabin and funnel, or a sail."""
    color = look.color("blue", "red", "white", "green", "orange")
    paint = textures.stack((textures.plain(tint_color(color, 0.6)), 0.35),
                           (textures.speckles(look.rng, color, 4), 0.65))  # fmt: skip
    deck = np.array([(-0.09, 0), (-0.06, -0.022), (-0.02, -0.032), (0.07, -0.028), (0.07, 0.028),
                     (-0.02, 0.032), (-0.06, 0.022)])  # fmt: skip
    hull = loft(
        np.stack(
            [
                np.column_stack([deck * [a, b], np.full(7, z)])
                for a, b, z in ((0.72, 0.6, 0), (0.9, 0.9, 0.016), (1, 1, 0.04))
            ]
        ),
        deck,
    )
    top = prism(deck * [0.94, 0.9], 0.0385, 0.0415)
    wood = textures.wood(look.rng, (206, 164, 110), planks=5)
    pieces: Pieces = [(hull, paint), (top, wood)]
    if look.chance(0.5):
        mast = straight((-0.01, 0, 0.04), (-0.01, 0, 0.16), 0.003)
        sails = [prism(outline, -0.0008, 0.0008).turn(0, np.pi / 2) for outline in (
            [(-0.004, 0.055), (0.062, 0.055), (-0.004, 0.155)],
            [(-0.018, 0.058), (-0.018, 0.145), (-0.075, 0.058)][::1])]  # fmt: skip
        cloth = textures.stripes([(246, 244, 238), look.own_color("white", "red", "navy")], 4)
        pieces += [(mast, wood), (join(sails), cloth)]
        return put_down(pieces, hull, join([mast, *sails]), factor=look.between(0.9, 1.1))
    cabin = block(0.06, 0.036, 0.03, 0.004, 0.002).move(0.015, 0, 0.041)
    holes = _windows(-0.003, 0.052, 0.018, 0.01, 0.01, 3, 0.018)
    funnel = cylinder(0.01, 0.035, 16).move(0.022, 0, 0.07)
    band = cylinder(0.0104, 0.01, 16).move(0.022, 0, 0.09)
    pieces += [
        (cabin, PALE),
        (holes, GLASS),
        (funnel, textures.plain(look.own_color("red", "yellow"))),
        (band, TYRE),
    ]
    return put_down(pieces, hull, cabin, funnel, factor=look.between(0.9, 1.1))


def rocket(look: Look) -> Shape:
    """A toy rocket on three fins, with portholes."""
    color = look.color("white", "silver", "red", "blue", "orange")
    other = textures.plain(look.own_color("red", "orange", "blue") if sum(color) > 500
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
    pieces: Pieces = [
        (body, textures.speckles(look.rng, color, 4)),
        (join([nose, *fins]), other),
        (join([jet, *rims]), textures.plain((110, 112, 118))),
        (join(eyes), GLASS),
    ]
    return put_down(pieces, body, nose, join(fins), factor=look.between(0.9, 1.1))


def helicopter(look: Look) -> Shape:
    """A toy helicopter on its skids."""
    color = look.color("red", "blue", "yellow", "green", "orange")
    paint = textures.speckles(look.rng, color, 4)
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
    grey = textures.plain((74, 76, 82))
    pieces: Pieces = [(join([body, boom, fin]), paint), (dome, GLASS),
                      (join([mast, *blades, *skids, *struts]), grey)]  # fmt: skip
    return put_down(pieces, join([*skids, *struts]), body, join([boom, fin]), join(blades),
                   factor=look.between(0.9, 1.1))  # fmt: skip


def train_track(look: Look) -> Shape:
    """A straight or curved piece of wooden track with two grooves."""
    color = look.color("wooden", "tan", "beige", "amber")
    wood = textures.wood(look.rng, color)
    groove = textures.plain(tint_color(color, 0.55))
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


CATEGORIES = (
    Category("toy_truck", truck, (0.19, 0.066, 0.088), 0.22, ("truck", "lorry", "toy lorry",
             "dump truck", "toy dump truck", "model truck", "delivery truck", "tipper truck",
             "pickup truck", "toy tipper", "garbage truck", "toy ambulance", "ambulance",
             "toy excavator"), ("toys",), (), ("red", "yellow")),
    Category("fire_truck", fire_truck, (0.178, 0.064, 0.085), 0.22, ("fire engine",
             "toy fire truck", "toy fire engine", "firetruck"), ("toys",), (), ("red",)),
    Category("toy_bus", bus, (0.157, 0.056, 0.078), 0.18, ("bus", "school bus", "double decker",
             "double decker bus", "toy school bus", "model bus", "coach",
             "double-decker bus model"), ("toys",), (), ("red",
             "yellow")),
    Category("toy_tractor", tractor, (0.122, 0.088, 0.086), 0.18, ("tractor", "model tractor",
             "farm tractor",
             "toy digger", "excavator", "toy bulldozer", "bulldozer", "digger"), ("toys",), (),
             ("green", "red")),
    Category("toy_boat", boat, (0.16, 0.064, 0.135), 0.12, ("boat", "ship", "toy ship",
             "sailboat", "toy sailboat", "sailing boat", "model boat", "model ship", "tugboat",
             "wooden boat", "yacht", "toy sailing boat", "gondola model"), ("toys",), (), ("blue",
             "red")),
    Category("toy_rocket", rocket, (0.073, 0.073, 0.169), 0.12, ("rocket", "rocket ship",
             "spaceship", "space shuttle", "model rocket", "toy spaceship", "space rocket",
             "space shuttle model"),
             ("toys",), ("tall",), ("white", "red")),
    Category("toy_helicopter", helicopter, (0.19, 0.13, 0.086), 0.1, ("helicopter",
             "model helicopter", "chopper", "balsa helicopter"), ("toys",), (), ("red", "blue")),
    Category("train_track", train_track, (0.16, 0.055, 0.0124), 0.05, ("wooden train track",
             "toy train track", "track piece", "railway track", "rail track", "toy station"),
             ("toys",),
             ("flat",), ("wooden",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
