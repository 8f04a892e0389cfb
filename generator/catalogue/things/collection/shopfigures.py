"""More toys: animals of balloons, cranes, runs for marbles, small kitchens."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_box,
    disc,
    dye,
    metal,
    of,
    plastic,
    plate,
    shine,
    standing,
    wood,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import Solid, join, lathe, torus, tube
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 242, 238))


def _gyro(look: Look) -> Pieces:
    """A gyroscope on its stand: a heavy disc in crossed rings."""
    brass, steel = metal(look, "silver", "brass", "gold"), shine(look, "silver", "brass")
    foot = standing(
        (0.026, 0), (0.022, 0.006), (0.006, 0.012), (0.005, 0.03), (0.009, 0.034), sides=20
    )
    z = 0.072
    rings = [
        torus(0.034, 0.0022, 34, 6).move(z=z),
        torus(0.036, 0.0022, 34, 6).turn(0, np.pi / 2).move(z=z),
    ]
    wheel = lathe([(0.016, 0), (0.027, 0), (0.027, 0.01), (0.016, 0.01)], 30, loop=True).move(
        z=z - 0.005
    )
    web = disc(0.018, 0.003, (0, 0, z - 0.0015))
    axle = straight((0, 0, 0.034), (0, 0, 0.112), 0.0028, 10)
    return [
        (foot, steel),
        (rings[0], steel),
        (rings[1], steel),
        (join([wheel, web]), brass),
        (axle, steel),
    ]


def _jacks(look: Look) -> Pieces:
    """Five six-pointed metal jacks and a rubber ball."""
    pieces: Pieces = [
        (
            ball(0.024, 0.024, 0.024, (0.0, 0.0, 0.0114), 18),
            plastic(look, "red", "blue", "pink", "green"),
        )
    ]
    for k in range(5):
        a = 1.2566 * k + 0.4
        x, y, z = 0.038 * np.cos(a), 0.032 * np.sin(a), 0.0095
        arms = [straight(tuple(-0.009 * d), tuple(0.009 * d), 0.0014, 6) for d in np.eye(3)]
        tips = [
            ball(0.0042, 0.0042, 0.0042, tuple(s * 0.009 * d), 8)
            for d in np.eye(3)
            for s in (-1, 1)
        ]
        one = join([*arms, *tips]).turn(0, 0.7).turn(1, 0.6)
        pieces.append((one.move(x, y, z - 0.0004), shine(look, "silver", "gold")))
    return pieces


def _magnets(look: Look) -> Pieces:
    """A see-through square tile in a coloured frame."""
    color = look.color("red", "blue", "green", "yellow", "orange", "purple")
    frame = [at_box(0.075, 0.006, 0.006, (0, s * 0.0345, 0)) for s in (-1, 1)]
    frame += [at_box(0.006, 0.063, 0.006, (s * 0.0345, 0, 0)) for s in (-1, 1)]
    pane = at_box(0.064, 0.064, 0.003, (0, 0, 0.0015))
    bars = [
        at_box(0.064, 0.003, 0.0035, (0, 0, 0.0015)),
        at_box(0.003, 0.064, 0.0035, (0, 0, 0.0015)),
    ]
    return [
        (join(frame), textures.plain(color)),
        (pane, textures.plain(tint_color(color, 1.45))),
        (join(bars), textures.plain(tint_color(color, 1.1))),
    ]


def _balloons(look: Look) -> Pieces:
    """A dog twisted of long balloons."""
    color = look.color("pink", "red", "blue", "yellow", "green", "orange")

    def sausage(a: tuple[float, float, float], b: tuple[float, float, float], r: float) -> Solid:
        p, q = np.array(a), np.array(b)
        t = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 13))
        path = p + (q - p) * ((t + 1) / 2)[:, None]
        return tube(path, r * np.maximum(1 - np.abs(t) ** 5, 0.02) ** 0.5, 14)

    limbs = [
        sausage((x, y, 0.012), (0.8 * x, 0.7 * y, 0.085), 0.016)
        for x in (-0.06, 0.06)
        for y in (-0.02, 0.02)
    ]
    body = sausage((-0.06, 0, 0.1), (0.06, 0, 0.1), 0.019)
    neck = sausage((0.055, 0, 0.105), (0.085, 0, 0.165), 0.016)
    ears = [sausage((0.08, s * 0.005, 0.165), (0.062, s * 0.022, 0.215), 0.014) for s in (-1, 1)]
    nose = sausage((0.085, 0, 0.17), (0.135, 0, 0.168), 0.016)
    tail = sausage((-0.062, 0, 0.105), (-0.095, 0, 0.17), 0.012)
    skin = textures.gradient(tint_color(color, 0.85), tint_color(color, 1.25), look.rng)
    return [
        *((s, skin) for s in limbs),
        (body, skin),
        (neck, skin),
        (nose, skin),
        (tail, skin),
        (join(ears), skin),
    ]  # type: ignore[arg-type]


def _hobby(look: Look) -> Pieces:
    """A stuffed horse's head lying, a short stick below."""
    coat = textures.fabric(look.rng, look.color("brown", "tan", "gray", "white"))
    neck = rod([(-0.06, 0, 0.05), (0.02, 0.0, 0.055), (0.08, 0.02, 0.055)], [0.05, 0.042, 0.04], 14)
    head = rod(
        [(0.08, 0.02, 0.055), (0.1, -0.04, 0.05), (0.1, -0.1, 0.045)], [0.045, 0.038, 0.028], 14
    )
    ears = [
        rod([(0.105, 0.045, 0.055 + s * 0.02), (0.14, 0.065, 0.06 + s * 0.026)], [0.014, 0.003], 8)
        for s in (-1, 1)
    ]
    mane = [
        ball(0.04, 0.03, 0.035, (-0.05 + 0.035 * k, 0.045 + 0.006 * k, 0.065), 10) for k in range(5)
    ]
    stick = straight((-0.22, 0, 0.04), (-0.05, 0, 0.05), 0.012, 12)
    eye = ball(0.014, 0.014, 0.008, (0.105, -0.01, 0.09), 10)
    return [
        (neck, coat),
        (head, coat),
        (stick, wood(look, "wooden")),
        (join(ears), coat),
        (join(mane), dye(look, "black", "brown", "cream")),
        (eye, BLACK),
    ]


def _potato(look: Look) -> Pieces:
    """A potato with a hat, eyes, a nose, a moustache, ears, arms and shoes."""
    body = ball(0.085, 0.075, 0.1, (0, 0, 0.066), 24)
    shoes = [ball(0.04, 0.056, 0.026, (s * 0.022, -0.01, 0.012), 14) for s in (-1, 1)]
    eyes = [ball(0.02, 0.012, 0.026, (s * 0.011, -0.033, 0.092), 12) for s in (-1, 1)]
    pupils = [ball(0.009, 0.006, 0.011, (s * 0.011, -0.0385, 0.09), 8) for s in (-1, 1)]
    nose = ball(0.02, 0.024, 0.02, (0, -0.041, 0.072), 12)
    lip = ball(0.044, 0.012, 0.012, (0, -0.0375, 0.056), 12)
    ears = [ball(0.014, 0.016, 0.026, (s * 0.044, 0, 0.082), 10) for s in (-1, 1)]
    arms = [
        rod(
            [(s * 0.04, 0, 0.06), (s * 0.06, -0.01, 0.055), (s * 0.066, -0.012, 0.075)],
            [0.007, 0.007, 0.01],
            8,
        )
        for s in (-1, 1)
    ]
    hat = [disc(0.036, 0.004, (0, 0, 0.108)), disc(0.023, 0.026, (0, 0, 0.11))]
    return [
        (body, textures.speckles(look.rng, look.color("tan", "brown"), 8)),
        (join(shoes), dye(look, "blue", "orange")),
        (join(hat), dye(look, "black", "green", "navy")),
        (join(ears), dye(look, "pink")),
        (join(arms), WHITE),
        (join(eyes), WHITE),
        (join(pupils), BLACK),
        (nose, textures.plain((222, 60, 50))),
        (lip, BLACK),
    ]


def _furby(look: Look) -> Pieces:
    color = look.color("purple", "teal", "orange", "pink", "gray", "sky")
    fur = textures.scratches(look.rng, color, tint_color(color, 1.3), 160)
    body = standing((0.04, 0), (0.052, 0.02), (0.05, 0.06), (0.036, 0.1), (0.012, 0.115))
    belly = ball(0.06, 0.03, 0.06, (0, -0.036, 0.035), 16)
    ears = [
        plate([(-0.015, 0), (0.015, 0), (0.004, 0.06)], 0.006)
        .turn(0, np.pi / 2)
        .turn(1, s * 0.6)
        .move(s * 0.03, 0.006, 0.085)
        for s in (-1, 1)
    ]
    eyes = [ball(0.028, 0.012, 0.028, (s * 0.017, -0.04, 0.08), 14) for s in (-1, 1)]
    pupils = [ball(0.014, 0.008, 0.014, (s * 0.017, -0.0455, 0.08), 10) for s in (-1, 1)]
    beak = ball(0.022, 0.024, 0.016, (0, -0.048, 0.06), 12)
    feet = [ball(0.036, 0.046, 0.018, (s * 0.022, -0.034, 0.008), 12) for s in (-1, 1)]
    return [
        (body, fur),
        (belly, dye(look, "white", "cream")),
        (join(feet), dye(look, "yellow", "white")),
        (join(ears), fur),
        (join(eyes), WHITE),
        (join(pupils), BLACK),
        (beak, textures.plain((246, 196, 60))),
    ]


_row = Rows("toys", ("red", "blue")).of_shape


CATEGORIES = (
    _row("gyroscope", of(_gyro), (0.076, 0.076, 0.112), 0.12, ("gyro", "toy gyroscope"),
             ("silver",)),
    _row("jacks", of(_jacks), (0.0898, 0.0763, 0.0232), 0.06, ("jacks set", "set of jacks",
             "jacks game", "knucklebones", "jackstones")),
    _row("magnetic_tile", of(_magnets, bodies=(0, 1)), (0.075, 0.075, 0.006), 0.03, ("magna tile",
             "magnet tile", "magnetic building tile"), roles=("flat",)),
    _row("balloon_animal", of(_balloons, 0.05), (0.239, 0.0687, 0.208), 0.01, ("balloon dog",
             "balloon poodle", "balloon sculpture"), ("pink", "red"), ("big",)),
    at_rest(_row("hobby_horse", of(_hobby, 0.1), (0.37, 0.18, 0.1), 0.4, ("hobby horse head",
             "stick horse", "horse on a stick"), ("brown",), ("big",))),
    _row("mr_potato_head", of(_potato, 0.12, bodies=3), (0.156, 0.0939, 0.141), 0.2, ("potato head",
             "mrs potato head", "potato man"), ("tan",)),
    _row("furby", of(_furby, bodies=3), (0.126, 0.111, 0.135), 0.3, ("furry robot", "gremlin toy",
             "toy monster", "monster toy", "plush monster", "pokemon figure", "tamagotchi pet"),
             ("purple",)),
)  # fmt: skip
"""The module's categories."""
