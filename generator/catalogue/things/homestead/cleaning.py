"""Things to clean with: plungers, brushes, squeegees, rollers, vacuum cleaners, brooms."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import side_view
from ...build.making import DARK, at_box, drum, plate, standing, steel
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import block, join, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def plunger(look: Look) -> Shape:
    """A plunger standing on its rubber cup."""
    color = look.color("red", "black", "terracotta", "blue")
    k = look.between(0.7, 0.9)
    cup = standing(
        (0.055, 0),
        (0.06, 0.006),
        (0.058, 0.03),
        (0.04, 0.062),
        (0.018, 0.075),
        (0.016, 0.09),
        sides=28,
    )
    rim = torus(0.058, 0.004, 30, 6).move(z=0.012)
    stick = drum(0.0105, 0.26, (0, 0, 0.07), top=0.0115, sides=16)
    end = ball(0.026, 0.026, 0.026, (0, 0, 0.33), 14)
    return put_down(
        [
            (join([cup, rim]), textures.speckles(look.rng, color, 4)),
            (join([stick, end]), textures.wood(look.rng, (222, 186, 132))),
        ],
        cup,
        stick,
        factor=k,
    )


def toilet_brush(look: Look) -> Shape:
    """A toilet brush standing in its holder."""
    color = look.color("white", "black", "silver", "teal", "gray")
    k = look.between(0.75, 0.95)
    pot = standing((0.048, 0), (0.05, 0.004), (0.046, 0.12), (0.04, 0.126), sides=28)
    hole = drum(0.037, 0.0008, (0, 0, 0.1256))
    collar = drum(0.03, 0.006, (0, 0, 0.126), top=0.01)
    stick = drum(0.0075, 0.23, (0, 0, 0.13), top=0.009, sides=14)
    end = ball(0.024, 0.024, 0.02, (0, 0, 0.362), 12)
    return put_down(
        [
            (pot, look.surface(color, "plastic")),
            (hole, plain(DARK)),
            (join([collar, stick, end]), plain(tint_color(color, 0.85))),
        ],
        pot,
        stick,
        factor=k,
    )


def squeegee(look: Look) -> Shape:
    """A squeegee lying: a rubber blade in a bar, and a handle."""
    color = look.color("blue", "green", "black", "silver", "yellow")
    k = look.between(0.8, 1.05)
    rail = at_box(0.022, 0.25, 0.014, (0.09, 0, 0.002))
    blade = at_box(0.02, 0.255, 0.004, (0.108, 0, 0.006))
    neck = plate([(0.0, -0.012), (0.085, -0.03), (0.085, 0.03), (0.0, 0.012)], 0.014)
    handle = rod(
        [(0.02, 0, 0.012), (-0.05, 0, 0.013), (-0.12, 0, 0.012)], [0.012, 0.014, 0.0115], 12
    )
    return put_down(
        [
            (join([rail, neck]), plain(color)),
            (blade, plain((40, 40, 44))),
            (handle, plain(tint_color(color, 0.75))),
        ],
        join([rail, blade]),
        handle,
        neck,
        factor=k,
        foot=0.15,
    )


def lint_roller(look: Look) -> Shape:
    """A sticky roller lying, its handle bent."""
    color = look.color("pink", "blue", "white", "green", "black")
    k = look.between(0.85, 1.1)
    paper = drum(0.024, 0.1, (-0.02, 0, 0.0235), 0, sides=26)
    core = [drum(0.019, 0.004, (x, 0, 0.0235), 0, sides=22) for x in (-0.024, 0.08)]
    handle = rod(
        [(-0.02, 0, 0.0235), (-0.05, 0, 0.024), (-0.1, 0, 0.014), (-0.14, 0, 0.012)],
        [0.006, 0.01, 0.013, 0.0115],
        12,
    )
    lines = textures.stripes([(244, 244, 240), (226, 232, 236)], 10, upright=True)
    return put_down(
        [(paper, lines), (join([*core, handle]), plain(color))], paper, handle, factor=k, foot=0.2
    )


def robot_vacuum(look: Look) -> Shape:
    """A robot vacuum cleaner: a low disc with a bumper, a button and a turret."""
    color = look.color("black", "white", "charcoal", "gray")
    k = look.between(0.75, 0.95)
    foot, body = (
        drum(0.13, 0.012),
        standing(
            (0.155, 0.0), (0.158, 0.008), (0.158, 0.055), (0.15, 0.066), at=(0, 0, 0.008), sides=36
        ),
    )
    band = torus(0.157, 0.005, 40, 6).scale(1, 1, 3).move(z=0.04)
    top = drum(0.12, 0.002, (0, 0, 0.0735), sides=36)
    turret = drum(0.036, 0.018, (0, 0.06, 0.073), sides=26, bevel=0.003)
    keys = [
        drum(0.012, 0.003, (0.0, -0.06, 0.0745)),
        drum(0.007, 0.003, (0.03, -0.06, 0.0745)),
        drum(0.007, 0.003, (-0.03, -0.06, 0.0745)),
    ]
    brush = [
        at_box(0.05, 0.004, 0.004, (0.025, 0, 0)).turn(2, 2.1 * n).move(0.12, -0.1, 0.003)
        for n in range(3)
    ]
    shade = tint_color(color, 1.25 if sum(color) < 300 else 0.9)
    return put_down(
        [
            (join([foot, body]), textures.speckles(look.rng, color, 3)),
            (join([band, turret]), plain(DARK)),
            (top, plain(shade)),
            (join(keys), plain((120, 190, 220))),
            (join(brush), plain((210, 90, 50))),
        ],
        foot,
        body,
        turret,
        factor=k,
    )


def hand_vacuum(look: Look) -> Shape:
    """A hand-held vacuum cleaner lying: a clear nose, a body and a handle."""
    color = look.color("red", "gray", "blue", "white", "purple")
    k = look.between(0.75, 0.95)
    nose = side_view([(0.05, 0.0), (0.18, 0.0), (0.175, 0.025), (0.05, 0.095)], 0.085)
    body = block(0.13, 0.098, 0.098, 0.03, 0.012).move(-0.01, 0, 0.0)
    tail = rod([(-0.06, 0, 0.05), (-0.12, 0, 0.06), (-0.18, 0, 0.035)], [0.034, 0.026, 0.022], 12)
    handle = rod([(0.03, 0, 0.095), (0.0, 0, 0.14), (-0.08, 0, 0.14), (-0.13, 0, 0.075)], 0.013, 10)
    button = at_box(0.024, 0.014, 0.006, (-0.02, 0, 0.151))
    lip = at_box(0.008, 0.087, 0.026, (0.178, 0, 0))
    return put_down(
        [
            (join([body, tail, handle]), plain(color)),
            (nose, plain((176, 184, 190))),
            (join([button, lip]), plain(DARK)),
        ],
        nose,
        body,
        tail,
        handle,
        factor=k,
    )


def mop_head(look: Look) -> Shape:
    """A mop head lying: strings spread from a socket."""
    color = look.color("white", "cream", "sky", "gray")
    k = look.between(0.8, 1.05)
    cords = []
    for n in range(26):
        a = -1.1 + 2.2 * n / 25
        long, lift = look.between(0.13, 0.17), 0.006 + 0.006 * (n % 3)
        path = [
            (0, 0.2 * 0.03 * a, 0.022),
            (0.04 * np.cos(a), 0.05 * np.sin(a), 0.018 + lift * 0.5),
            (long * np.cos(a), long * np.sin(a), 0.0055),
        ]
        cords.append(rod(path, [0.008, 0.0075, 0.0055], 6, 3))
    clamp = block(0.03, 0.06, 0.034, 0.008, 0.004)
    socket = drum(0.015, 0.07, (-0.085, 0, 0.017), 0, top=0.018, sides=18)
    yarn = textures.knitting(look.rng, color, 20)
    tone = look.own_color("blue", "red", "green", "yellow")
    return put_down(
        [(join(cords), yarn), (join([clamp, socket]), plain(tone))],
        join(cords),
        clamp,
        socket,
        factor=k,
        foot=0.15,
    )


def broom_head(look: Look) -> Shape:
    """A broom head standing on its bristles, with the socket for a stick."""
    color = look.color("red", "blue", "wooden", "green", "black")
    k = look.between(0.7, 0.9)
    top = block(0.27, 0.055, 0.026, 0.02, 0.006).move(z=0.072)
    tufts = [
        drum(0.0105, 0.078, (x, y, 0), top=0.0075, sides=8)
        for x in np.linspace(-0.12, 0.12, 12)
        for y in (-0.016, 0.002, 0.018)
    ]
    socket = drum(0.02, 0.045, (0, 0, 0.095), top=0.015, sides=18)
    hole = drum(0.0115, 0.001, (0, 0, 0.1396))
    tone = look.own_color("tan", "mustard", "gray", "black")
    return put_down(
        [
            (join([top, socket]), look.surface(color, "plastic")),
            (join(tufts), textures.scratches(look.rng, tone, tint_color(tone, 0.7), 90)),
            (hole, plain(DARK)),
        ],
        top,
        join(tufts),
        socket,
        factor=k,
    )


def hand_brush(look: Look) -> Shape:
    """A hand brush lying on its bristles."""
    color = look.color("red", "wooden", "blue", "green", "tan")
    k = look.between(0.8, 1.05)
    head = block(0.15, 0.05, 0.018, 0.014, 0.005).move(0.05, 0, 0.05)
    handle = rod(
        [(-0.02, 0, 0.058), (-0.07, 0, 0.056), (-0.13, 0, 0.052)], [0.014, 0.011, 0.0135], 12
    )
    tufts = [
        drum(0.0095, 0.055, (x, y, 0), top=0.007, sides=8)
        for x in np.linspace(-0.012, 0.112, 8)
        for y in (-0.016, 0, 0.016)
    ]
    tone = look.own_color("black", "tan", "cream", "brown")
    return put_down(
        [
            (join([head, handle]), look.surface(color, "wood")),
            (join(tufts), textures.scratches(look.rng, tone, tint_color(tone, 0.7), 90)),
        ],
        join(tufts),
        head,
        handle,
        factor=k,
    )


def bottle_brush(look: Look) -> Shape:
    """A long thin brush lying: bristles round a twisted wire, a handle."""
    color = look.color("white", "blue", "pink", "green", "yellow")
    k = look.between(0.8, 1.1)
    t = np.linspace(0, 1, 60)
    path = np.column_stack([0.02 + 0.11 * t, 0 * t, 0.019 + 0 * t])
    brush = tube(path, 0.0175 * (1 + 0.12 * (-1) ** np.arange(60)), 14)
    wire = straight((-0.1, 0, 0.019), (0.135, 0, 0.019), 0.0022, 8)
    wire = wire.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] - 0.013 * np.clip((0.0 - p[:, 0]) / 0.1, 0, 1)]
        )
    )
    handle = rod([(-0.08, 0, 0.009), (-0.15, 0, 0.0075)], [0.006, 0.008], 10)
    fur = textures.scratches(look.rng, color, tint_color(color, 0.8), 120)
    return put_down(
        [
            (brush, fur),
            (wire, steel(look)),
            (handle, plain(look.own_color("blue", "green", "white"))),
        ],
        straight((0.02, 0, 0.0185), (0.13, 0, 0.0185), 0.018, 14),
        handle,
        wire,
        factor=k,
        foot=0.3,
    )


CATEGORIES = (
    Category("plunger", plunger, (0.0987, 0.0992, 0.274), 0.3, ("sink plunger", "toilet plunger",
             "drain plunger"), ("living",), ("tall",), ("red",)),
    Category("toilet_brush", toilet_brush, (0.0843, 0.0843, 0.314), 0.4, ("loo brush",
             "toilet brush holder", "lavatory brush"), ("vanity",), ("tall",), ("white",)),
    Category("squeegee", squeegee, (0.224, 0.24, 0.0254), 0.12, ("window squeegee",
             "shower squeegee", "window wiper"), ("living",), ("big",), ("blue",)),
    Category("lint_roller", lint_roller, (0.213, 0.0456, 0.0449), 0.1, ("sticky roller",
             "lint remover", "clothes roller"), ("living",), (), ("pink", "blue")),
    Category("robot_vacuum", robot_vacuum, (0.283, 0.276, 0.0775), 2.2, ("robot vacuum cleaner",
             "robotic vacuum", "roomba", "robot hoover"), ("living",),
             ("flat", "big"), ("black", "white")),
    Category("hand_vacuum", hand_vacuum, (0.318, 0.0839, 0.136), 0.9, ("handheld vacuum",
             "hand-held vacuum", "vacuum cleaner", "handheld vacuum cleaner",
             "dustbuster", "hoover", "mini vacuum"), ("living",), ("big",), ("red", "gray")),
    Category("mop_head", mop_head, (0.225, 0.249, 0.0311), 0.25, ("mop", "string mop",
             "floor mop"), ("living",), ("big",), ("white",)),
    Category("broom_head", broom_head, (0.208, 0.0432, 0.108), 0.3, ("brush head",
             "floor brush", "sweeping brush"), ("living",), ("big",), ("red", "blue")),
    Category("hand_brush", hand_brush, (0.243, 0.0484, 0.0683), 0.12, ("dustpan brush",
             "banister brush", "bench brush", "crumb sweeper", "table brush"),
             ("living",), (), ("red", "wooden")),
    Category("bottle_brush", bottle_brush, (0.26, 0.0357, 0.0347), 0.04, ("bottle cleaning brush",
             "test tube brush", "tube brush"), ("kitchen",), (), ("white", "blue")),
)  # fmt: skip
"""The module's categories."""
