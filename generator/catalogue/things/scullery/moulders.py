"""Kitchen gadgets that cut, press and shape: egg slicers, moulds, nozzles, presses, rests."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import lobe, side_view
from ...build.outlines import arc, smooth
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, loft, prism, torus, tube
from ...build.variants import keep_still
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .contraptions import metal

STEEL: RGB = (190, 194, 200)


def egg_slicer(look: Look) -> Shape:
    """An egg slicer: a tray with a hollow, an egg on it, a hinged frame of wires above."""
    k, color = look.between(0.9, 1.1), look.color("white", "red", "silver", "yellow", "mint")
    tray = block(0.09, 0.12, 0.016, 0.012, 0.003)
    slots = [box(0.07, 0.002, 0.001).move(0, 0.008 * j, 0.0156) for j in range(-5, 6)]
    egg = ellipsoid(0.042, 0.056, 0.042, 20, 12).move(z=0.03)
    frame = [box(0.09, 0.006, 0.006).move(y=y) for y in (-0.104, 0.0)] + [
        box(0.006, 0.11, 0.006).move(s * 0.042, -0.052) for s in (-1, 1)
    ]
    wires = [
        tube([(-0.03 + 0.0075 * i, -0.104, 0.003), (-0.03 + 0.0075 * i, 0, 0.003)], 0.0007, 4)
        for i in range(9)
    ]
    up = [s.turn(0, -1.15).move(y=0.056, z=0.018) for s in frame]
    lines = [s.turn(0, -1.15).move(y=0.056, z=0.018) for s in wires]
    made = [
        (join([tray, *up]), look.surface(color, "plastic")),
        (join(slots), textures.plain((70, 72, 76))),
        (egg, textures.speckles(look.rng, (250, 246, 238), 4)),
        (join(lines), textures.plain(STEEL)),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(tray.scale(k, k, k)),
            hull_of(*[s.scale(k, k, k) for s in up]),
            hull_of(made[2][0]),
        ],
    )


def cherry_pitter(look: Look) -> Shape:
    """A cherry pitter lying: two sprung handles, a ring with a cherry, a plunger."""
    k, color = look.between(0.9, 1.12), look.color("red", "black", "silver", "green")
    arms = [
        tube(
            smooth(
                [
                    (-0.04, s * 0.012, 0.012),
                    (0.0, s * 0.022, 0.012),
                    (0.06, s * 0.026, 0.012),
                    (0.11, s * 0.018, 0.012),
                ],
                4,
            ),
            0.0075,
            9,
        )
        for s in (-1, 1)
    ]
    ring = (
        lathe([(0.011, 0), (0.016, 0), (0.016, 0.01), (0.011, 0.01)], 22, loop=True)
        .turn(0, np.pi / 2)
        .move(-0.05, -0.004, 0.016)
    )
    cherry = ellipsoid(0.022, 0.022, 0.022, 16, 10).move(-0.05, -0.009, 0.016)
    pin = tube([(-0.05, 0.022, 0.016), (-0.05, 0.004, 0.016)], 0.0025, 7)
    bow = torus(0.02, 0.005, 20, 7).scale(1, 1.1, 1).move(0.115, 0, 0.012)
    made = [
        (join(arms), look.surface(color, "plastic")),
        (join([ring, pin, bow]), metal(look)),
        (cherry, textures.speckles(look.rng, (150, 20, 40), 8)),
    ]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.02, hulls=[[0], [1]])


def mezzaluna(look: Look) -> Shape:
    """A mezzaluna lying: a half-moon blade with a knob handle at each end."""
    k, color = look.between(0.88, 1.1), look.color("wooden", "black", "brown", "red")
    outer, inner = (
        arc((0, 0), 0.1, np.pi + 0.35, 2 * np.pi - 0.35, 16),
        arc((0, 0.02), 0.088, 2 * np.pi - 0.42, np.pi + 0.42, 16),
    )
    blade = prism(np.concatenate([outer, inner]), 0, 0.002).move(z=0.012)
    knobs = [
        lathe(
            [(0, 0), (0.006, 0.002), (0.011, 0.02), (0.013, 0.05), (0.008, 0.062), (0, 0.064)], 16
        )
        .turn(0, -np.pi / 2)
        .move(s * 0.09, -0.036, 0.013)
        for s in (-1, 1)
    ]
    made = [(blade, metal(look, (206, 210, 214))), (join(knobs), look.surface(color, "wood"))]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.06, hulls=[[0], [1]])


def jelly_mould(look: Look) -> Shape:
    """A fluted mould standing upside down: a copper or tin dome with tiers."""
    k, color = look.between(0.88, 1.1), look.color("copper", "silver", "copper", "pink", "red")
    dome = lathe(
        [
            (0, 0),
            (0.078, 0),
            (0.078, 0.004),
            (0.066, 0.006),
            (0.062, 0.05),
            (0.05, 0.056),
            (0.046, 0.082),
            (0.034, 0.088),
            (0.03, 0.1),
            (0, 0.104),
        ],
        64,
    )
    made = lobe(dome, look.pick([10, 12, 14]), 0.12).scale(k, k, k)
    return shape(
        [
            (
                made,
                look.surface(
                    color, "copper" if color[0] > 1.3 * color[2] and color[1] > 80 else "plastic"
                ),
            )
        ],
        [hull_of(made)],
    )


def piping_nozzle(look: Look) -> Shape:
    """A piping nozzle standing on its wide end: a small steel cone with a star tip."""
    k, color = look.between(0.85, 1.3), look.color("silver", "silver", "gray", "gold")
    body = lathe([(0, 0), (0.012, 0), (0.0115, 0.004), (0.0045, 0.034), (0, 0.034)], 24)
    teeth = [
        prism([(-0.0018, 0), (0.0018, 0), (0, 0.006)], -0.0005, 0.0005)
        .turn(0, np.pi / 2)
        .move(y=-0.0042)
        .turn(2, a)
        .move(z=0.0335)
        for a in np.arange(6) * 1.047
    ]
    seam = box(0.0006, 0.001, 0.03).turn(0, -0.22).move(y=-0.0118, z=0.002)
    made = join([body, *teeth, seam]).scale(k, k, k)
    return shape([(made, look.surface(color, "steel"))], [hull_of(body.scale(k, k, k))])


def spoon_rest(look: Look) -> Shape:
    """A spoon rest: a shallow glazed dish shaped like a big spoon."""
    k, color = (
        look.between(0.88, 1.1),
        look.color("white", "sky", "red", "yellow", "teal", "cream", "gray"),
    )
    a = np.linspace(0.32, 2 * np.pi - 0.32, 26)
    outline = np.concatenate(
        [
            [(0.115, 0.022)],
            np.column_stack([0.056 * np.cos(a), 0.05 * np.sin(a)]),
            [(0.115, -0.022)],
        ]
    ) - [0.02, 0]

    def ring(s: float, z: float) -> np.ndarray:
        c = np.array([0.02, 0])
        return np.column_stack([c + (outline - c) * s, np.full(len(outline), z)])

    body = loft(
        np.stack([ring(0.86, 0), ring(1.0, 0.016), ring(0.94, 0.017), ring(0.8, 0.006)]), outline
    )
    tile = (
        textures.spots(look.rng, color, tint_color(color, 0.7 if sum(color) > 380 else 1.4), 0.03)
        if look.chance(0.5)
        else look.surface(color, "ceramic")
    )
    return shape([(body.scale(k, k, k), tile)], [hull_of(body.scale(k, k, 0.4 * k))])


def tortilla_press(look: Look) -> Shape:
    """A tortilla press: two round plates on a hinge, a lever, a ball of dough."""
    k, color = look.between(0.88, 1.06), look.color("black", "silver", "red", "gray")
    low = cylinder(0.1, 0.014, 34, bevel=0.002).move(z=0.008)
    feet = [
        cylinder(0.012, 0.01, 12).move(0.07 * np.cos(a), 0.07 * np.sin(a), 0)
        for a in np.arange(4) * 1.57 + 0.8
    ]
    up = [
        s.turn(0, -1.0).move(y=0.1, z=0.03)
        for s in (
            cylinder(0.1, 0.012, 34, bevel=0.002).move(y=-0.1),
            box(0.02, 0.2, 0.01).move(0, -0.1, 0.012),
        )
    ]
    hinge = box(0.05, 0.02, 0.03).move(y=0.105, z=0.006)
    lever = (
        tube([(0, -0.1, 0.018), (0, -0.135, 0.03), (0, -0.2, 0.034)], 0.0085, 9)
        .turn(2, np.pi)
        .move(0, -0.03, 0.0)
    )
    dough = ellipsoid(0.05, 0.05, 0.024, 16, 9).move(z=0.03)
    made = [
        (join([low, *up, hinge]), look.surface(color, "iron" if sum(color) < 300 else "plastic")),
        (join([*feet, lever]), textures.plain((36, 36, 40))),
        (dough, textures.speckles(look.rng, (244, 228, 176), 8)),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(*[s.scale(k, k, k) for s in (low, *feet)]),
            hull_of(*[s.scale(k, k, k) for s in up]),
            hull_of(lever.scale(k, k, k)),
        ],
    )


def taco_holder(look: Look) -> Shape:
    """A taco holder: a wavy steel or coloured sheet with slots for three tacos."""
    k, color = (
        look.between(0.88, 1.08),
        look.color("silver", "silver", "red", "yellow", "green", "wooden"),
    )
    x = np.linspace(-0.1, 0.1, 29)
    z = 0.026 + 0.024 * np.cos(2 * np.pi * x / 0.0571)
    top, low = np.column_stack([x, z + 0.0025]), np.column_stack([x, np.maximum(z - 0.001, 0)])
    sheet = side_view(np.concatenate([low, top[::-1]]), 0.1)
    parts = [
        hull_of(
            side_view(np.concatenate([low[i : i + 3], top[i : i + 3][::-1]]), 0.1).scale(k, k, k)
        )
        for i in range(0, 27, 2)
    ]
    return shape(
        [(sheet.scale(k, k, k), look.surface(color, "steel" if color[2] > 150 else "plastic"))],
        parts,
    )


_K = ("kitchen",)


_B = ("big",)

CATEGORIES = (
    Category("egg_slicer", egg_slicer, (0.089, 0.121, 0.117), 0.12, ("egg cutter", "egg wedger",
        "mozzarella slicer"), _K, (), ("white",)),
    Category("cherry_pitter", keep_still(cherry_pitter), (0.21, 0.068, 0.0321), 0.12,
             ("olive pitter", "cherry stoner", "cherry pit remover"), _K, (), ("red",),
             state="lying"),
    Category("mezzaluna", keep_still(mezzaluna), (0.203, 0.126, 0.0241), 0.25,
             ("herb chopper", "rocking knife", "herb cutter", "half moon knife"), _K, (),
             ("wooden",), state="lying flat"),
    Category("jelly_mould", jelly_mould, (0.155, 0.152, 0.0993), 0.2, ("jelly mold",
        "pudding mould", "bundt tin", "blancmange mould", "lamb mould", "mooncake mould",
        "chocolate mould",
             "fluted mould"), _K, ("round",), ("copper",)),
    Category("piping_nozzle", piping_nozzle, (0.027, 0.0273, 0.0444), 0.008,
             ("icing nozzle", "piping tip", "icing tip", "cake nozzle"), _K, ("round",),
             ("silver",)),
    Category("spoon_rest", spoon_rest, (0.162, 0.0946, 0.0162), 0.2, ("ladle rest",), _K, ("flat",),
             ("white",)),
    Category("taco_holder", taco_holder, (0.192, 0.0958, 0.0493), 0.15,
             ("taco stand", "taco rack"), _K, (), ("silver",)),
    Category("tortilla_press", tortilla_press, (0.2, 0.272, 0.211), 1.5, ("roti press",), _K, _B,
             ("black",)),
)  # fmt: skip
"""The module's categories."""
