"""Fish and shellfish, raw and cooked: whole fish, fillets, prawns, lobsters, crabs, sushi."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade, lobe, side_view
from ...build.outlines import smooth
from ...build.settled import hull_above, limb, rod, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, ellipsoid, join, lathe, loft, prism
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def fish(look: Look) -> Shape:
    """A whole fish lying on its side, head to the left."""
    long, tall, t = look.between(0.2, 0.26), look.between(0.066, 0.085), look.between(0.026, 0.034)
    color = look.color("silver", "gray", "sky", "teal", "coral", "gold", "olive")
    body = rod(0.8 * long, tall / 2, blunt=2.0, squash=t / tall, sides=16)
    body = body.bend(lambda p: np.column_stack([p[:, 0], p[:, 1] * (1 - 0.5 * np.clip(
        p[:, 0] / (0.4 * long), 0, 1)), p[:, 2]]))  # fmt: skip
    tail = prism(
        np.array(
            [
                (0.32, -0.005),
                (0.39, -0.024),
                (0.5, -0.2),
                (0.465, 0),
                (0.5, 0.2),
                (0.39, 0.024),
                (0.32, 0.005),
            ]
        )
        * [long, 0.5 * long],
        -0.0025,
        0.0025,
    )
    top = prism(np.array([(-0.12, 0.16), (0.12, 0.14), (0.1, 0.22), (-0.02, 0.25)]) * [
        long, 0.86 * tall / 0.2 * 0.55], -0.0025, 0.0025)  # fmt: skip
    low = prism(np.array([(0.12, -0.25), (0.18, -0.22), (0.16, -0.1), (0.04, -0.12)]) * [
        long, 0.86 * tall / 0.2 * 0.5], -0.0025, 0.0025)  # fmt: skip
    side = blade([(-0.14 * long, 0, 0.43 * t), (-0.08 * long, -0.004, 0.5 * t),
                  (-0.03 * long, -0.01, 0.49 * t)], 0.028, thick=0.25)  # fmt: skip
    eye = [cylinder(0.0065, 0.003, 14).move(-0.29 * long, 0.009, 0.3 * t)]
    pupil = [cylinder(0.0035, 0.0036, 12).move(-0.29 * long, 0.009, 0.3 * t)]
    gill = limb([(-0.19 * long, -0.3 * tall, 0.3 * t), (-0.175 * long, 0, 0.485 * t),
                 (-0.19 * long, 0.3 * tall, 0.3 * t)], [0.0012] * 3, 6)  # fmt: skip
    y, x = np.mgrid[0:128, 0:128]
    net = np.abs(np.sin(np.pi * (x / 8 + y / 6)) * np.sin(np.pi * (x / 8 - y / 6)))
    around = 0.5 + 0.5 * np.cos(2 * np.pi * x / 128)
    shade = (0.74 + 0.3 * net)[..., None] * (1 - 0.25 * around[..., None])
    scales = np.clip(np.array(color) * shade, 0, 255).astype(np.uint8)
    fin = textures.speckles(look.rng, tint_color(color, 0.68), 10)
    return settle(
        [
            (body, scales),
            (join([tail, top, low, side, gill]), fin),
            (join(eye), textures.plain((250, 248, 240))),
            (join(pupil), textures.plain((24, 24, 28))),
        ],
        0.18,
        hulls=[[0], [1]],
    )


def salmon(look: Look) -> Shape:
    """A pink fillet with pale lines, lying on its skin."""
    x, y, h = look.between(0.12, 0.15), look.between(0.055, 0.07), look.between(0.02, 0.027)
    side = np.array([(-0.5, 0), (0.5, 0), (0.47, 0.7), (0.2, 1.0), (-0.2, 0.9), (-0.47, 0.4)])
    body = side_view(side * [y, h], x, 0.004).turn(2, np.pi / 2)
    color = look.color("coral", "coral", "orange", "white", "pink")
    rows = np.linspace(0, 1, 128)
    line = np.abs(np.sin(np.pi * (9 * rows[:, None] + 1.2 * np.abs(rows[None] - 0.5)))) < 0.2
    flesh = np.where(line[..., None], np.array(tint_color(color, 1.5)), np.array(color))
    skin = block(x, 0.98 * y, 0.0022, 0.006)
    return shape([(body, flesh.astype(np.uint8)), (skin, textures.plain((126, 130, 136)))],
                 [hull_of(body)])  # fmt: skip


def shrimp(look: Look) -> Shape:
    """A cooked prawn curled on its side, its tail fan and legs out."""
    k = look.between(0.9, 1.2)
    a = np.linspace(-0.5, 3.5, 9)
    r = 0.021
    path = np.column_stack([r * np.cos(a), r * np.sin(a) * 0.9, 0 * a])
    body = limb(path, [0.0105 * s for s in (0.25, 0.7, 0.95, 1, 1, 0.94, 0.82, 0.66, 0.42)], 12)
    color = look.color("coral", "pink", "orange", "gray")
    bands = textures.stripes([color, color, tint_color(color, 1.5)], 6)
    end = path[-1]
    fan = [blade(end + np.array([(0, 0, 0), (0.009 * np.cos(t), 0.009 * np.sin(t), 0.001),
                              (0.018 * np.cos(t), 0.018 * np.sin(t), 0.0)]), 0.011, thick=0.3)
           for t in (-1.2, -0.75, -0.3)]  # fmt: skip
    legs = [limb([(0.55 * r * np.cos(t), 0.5 * r * np.sin(t), -0.002),
                  (0.1 * r * np.cos(t), 0.1 * r * np.sin(t) - 0.003, -0.004)],
                 [0.0014, 0.0006], 5) for t in (0.4, 1.0, 1.6, 2.2)]  # fmt: skip
    feel = [limb([(*path[0, :2], 0.002), (0.028, -0.028, 0.004), (0.008 + 0.006 * s, -0.042, 0)],
                 [0.0009, 0.0007, 0.0005], 5) for s in (-1, 1)]  # fmt: skip
    eye = ellipsoid(0.0035, 0.0035, 0.0035, 8, 6).move(path[0, 0] + 0.002, path[0, 1], 0.0035)
    trim = textures.plain(tint_color(color, 0.8))
    return settle(
        [(body, bands), (join([*fan, *legs, *feel]), trim), (eye, textures.plain((26, 24, 26)))],
        0.16,
        hulls=[[0], [1]],
    ).scale(k)


def _claw(s: int, at: tuple[float, float], size: float, turn: float) -> Solid:
    """Return an open pincer at the end of an arm, ``s`` its side."""
    palm = ellipsoid(1.0, 0.62, 0.42, 12, 6)
    finger = limb([(0.3, 0.16, 0), (0.7, 0.24, 0), (1.05, 0.06, 0)], [0.16, 0.13, 0.03], 6)
    thumb = limb([(0.3, -0.16, 0), (0.62, -0.26, 0), (0.95, -0.1, 0)], [0.12, 0.1, 0.03], 6)
    made = join([palm, finger, thumb]).scale(size, size, size)
    return made.turn(2, turn).move(at[0], at[1], 0.24 * size)


def lobster(look: Look) -> Shape:
    """A red lobster flat on its belly, claws to the left."""
    k = look.between(0.85, 1.1)
    color = look.color("red", "red", "crimson", "coral", "blue")
    head = ellipsoid(0.1, 0.05, 0.045, 18, 10).move(-0.02, 0, 0.02)
    rings = [ellipsoid(0.03, 0.048 - 0.003 * n, 0.034 - 0.002 * n, 12, 6).move(
        0.034 + 0.02 * n, 0, 0.017 - 0.001 * n) for n in range(6)]  # fmt: skip
    fan = [blade([(0.138, 0, 0.008), (0.155, 0.02 * s, 0.007), (0.182, 0.034 * s, 0.004)], 0.026,
                 thick=0.25) for s in (-1, -0.5, 0.02, 0.5, 1)]  # fmt: skip
    arms, legs, feel = [], [], []
    for s in (-1, 1):
        arms.append(limb([(-0.045, s * 0.018, 0.02), (-0.07, s * 0.05, 0.02),
                          (-0.105, s * 0.052, 0.016)], [0.007, 0.008, 0.009], 8))  # fmt: skip
        arms.append(_claw(s, (-0.128, s * 0.05), 0.056, np.pi + s * 0.12))
        for n in range(4):
            x = -0.03 + 0.018 * n
            legs.append(
                limb(
                    [
                        (x, s * 0.02, 0.016),
                        (x + 0.002, s * 0.045, 0.022),
                        (x + 0.008, s * 0.068, 0.002),
                    ],
                    [0.0036, 0.003, 0.0014],
                    5,
                )
            )
        feel.append(limb([(-0.068, s * 0.008, 0.024), (-0.11, s * 0.018, 0.045),
                          (-0.16, s * 0.02, 0.03)], [0.0017, 0.0013, 0.0006], 5))  # fmt: skip
    eyes = [ellipsoid(0.007, 0.007, 0.007, 8, 6).move(-0.06, s * 0.012, 0.035) for s in (-1, 1)]
    shell = textures.spots(look.rng, color, tint_color(color, 0.62), 0.08)
    body, limbs = join([head, *rings, *fan]), join([*arms, *legs, *feel])
    claws = [hull_above(arms[1]), hull_above(arms[3])]
    made = shape([(body, shell), (limbs, shell), (join(eyes), textures.plain((24, 22, 24)))],
                 [hull_above(body), *claws])  # fmt: skip
    return made.scale(k)


def crab(look: Look) -> Shape:
    """A crab flat on the table, claws to the front."""
    k = look.between(0.85, 1.12)
    color = look.color("red", "orange", "coral", "crimson", "blue")
    shell = ellipsoid(0.12, 0.085, 0.046, 24, 12).move(z=0.024)
    arms, legs, claws = [], [], []
    for s in (-1, 1):
        arms.append(limb([(s * 0.045, -0.025, 0.02), (s * 0.08, -0.035, 0.022),
                          (s * 0.072, -0.062, 0.016)], [0.008, 0.0095, 0.01], 8))  # fmt: skip
        claws.append(_claw(s, (s * 0.06, -0.078), 0.046, -np.pi / 2 - s * 0.6))
        for n in range(4):
            y = -0.015 + 0.017 * n
            out = 0.02 * (n - 1.2)
            legs.append(
                limb(
                    [
                        (s * 0.048, y, 0.02),
                        (s * 0.08, y + 0.4 * out, 0.03),
                        (s * 0.105, y + out, 0.001),
                    ],
                    [0.0055, 0.0045, 0.0018],
                    6,
                )
            )
    eyes = [ellipsoid(0.007, 0.007, 0.009, 8, 6).move(s * 0.014, -0.04, 0.038) for s in (-1, 1)]
    tile = textures.spots(look.rng, color, tint_color(color, 0.66), 0.1)
    made = shape([(shell, tile), (join([*arms, *claws, *legs]), tile),
                  (join(eyes), textures.plain((24, 22, 24)))],
                 [hull_above(shell), *(hull_above(c) for c in claws),
                  *(hull_above(join(legs[4 * n : 4 * n + 4])) for n in (0, 1))])  # fmt: skip
    return made.scale(k)


def oyster(look: Look) -> Shape:
    """Half an oyster shell with the oyster in it, lying."""
    k = look.between(0.9, 1.15)
    ring = (
        smooth(
            np.array(
                [
                    (0.5, 0),
                    (0.4, 0.26),
                    (0, 0.34),
                    (-0.38, 0.24),
                    (-0.52, 0),
                    (-0.36, -0.2),
                    (0, -0.3),
                    (0.4, -0.24),
                    (0.5, 0),
                ]
            ),
            3,
        )[:-1]
        * 0.085
    )
    levels = [(0.5, 0), (0.85, 0.006), (1, 0.014), (0.92, 0.014), (0.7, 0.007), (0.3, 0.006)]
    cup = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
               ring)  # fmt: skip
    rough = textures.spots(look.rng, (136, 130, 120), (86, 82, 78), 0.3)
    pearl = textures.speckles(look.rng, (238, 236, 230), 6)
    meat = ellipsoid(0.056, 0.034, 0.013, 18, 10).move(z=0.01)
    dark = ellipsoid(0.03, 0.018, 0.006, 12, 6).move(-0.004, 0.002, 0.0145)
    return shape([(cup, textures.stack((rough, 52), (pearl, 48))),
                  (meat, textures.speckles(look.rng, (206, 198, 178), 8)),
                  (dark, textures.plain((150, 142, 128)))], [hull_of(cup)]).scale(k)  # fmt: skip


def clam(look: Look) -> Shape:
    """A ribbed cockle, half open."""
    k = look.between(0.85, 1.15)
    color = look.color("beige", "cream", "tan", "terracotta", "charcoal")
    half = lobe(lathe([(0, 0), (0.022, 0), (0.02, 0.006), (0.012, 0.012), (0, 0.014)], 60), 26,
                0.07)  # fmt: skip
    low = half.bend(lambda p: np.column_stack([p[:, :2], 0.0135 - p[:, 2] * 0.95]))
    low = Solid(low.vertices, low.faces[:, ::-1], low.uv)
    up = half.turn(0, -0.6).move(y=0.004, z=0.0255)
    meat = ellipsoid(0.026, 0.024, 0.011, 14, 8).move(z=0.0165)
    tile = textures.stripes([color, tint_color(color, 0.8)], 8)
    body = join([low, up])
    return settle([(body, tile), (meat, textures.plain((236, 176, 110)))], 0.04).scale(k)


CATEGORIES = (
    Category("fish", fish, (0.205, 0.0866, 0.0272), 0.35, ("whole fish", "trout", "mackerel",
                 "sea bass", "herring", "grilled fish", "raw fish", "sardine", "anchovy", "cod",
                 "haddock", "sea bream", "red snapper", "whole trout", "kipper", "tilapia",
             "perch", "pollock", "carp"),
             ("kitchen",), ("edible",), ("silver", "gray"),
             state="lying flat"),
    Category("salmon", salmon, (0.128, 0.0627, 0.023), 0.15, ("salmon fillet", "salmon steak",
             "fish fillet", "fillet", "fillet of fish", "tuna steak", "cod fillet",
             "monkfish tail", "salmon portion", "trout fillet"), ("kitchen",),
             ("edible",), ("coral",), state="lying flat"),
    Category("shrimp", shrimp, (0.0583, 0.0738, 0.0183), 0.02, ("prawn", "king prawn"),
             ("dining",), ("edible",), ("coral",), state="lying flat"),
    Category("lobster", lobster, (0.354, 0.132, 0.0442), 0.6, ("boiled lobster",), ("dining",),
             ("edible", "big"), ("red",), state="lying flat"),
    Category("crab", crab, (0.216, 0.197, 0.0478), 0.4, ("boiled crab", "king crab"), ("dining",),
             ("edible", "big"), ("red",), state="lying flat"),
    vary(Category("oyster", oyster, (0.0878, 0.0551, 0.0177), 0.06, ("oyster shell", "raw oyster"),
             ("dining",), ("edible",), (), state="lying flat")),
    Category("clam", clam, (0.0453, 0.0468, 0.0406), 0.02, ("cockle", "shellfish"),
             ("dining",), ("edible",), (), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
