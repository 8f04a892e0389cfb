"""What a doctor listens and measures with."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import flat_foot, hull_of, hull_part
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, ellipsoid, join, lathe, loft, sweep, tube
from ...surfaces import prints, textures
from ...surfaces.look import Look


def stethoscope(look: Look) -> Shape:
    """A stethoscope lying: two ear tubes to the left, a loop of tube, the chest piece in front."""
    k = look.between(0.85, 1.05)
    color = look.color("black", "blue", "red", "teal", "maroon", "navy", "green", "purple")
    rubber = textures.plain(color)
    steel = textures.brushed_metal(look.rng, look.own_color("silver", "silver", "gold"))
    r = 0.0052 * k
    arms, tips = [], []
    for s in (-1, 1):
        path = (
            smooth(
                [
                    (-0.03, s * 0.008, 0.006),
                    (-0.09, s * 0.034, 0.006),
                    (-0.15, s * 0.042, 0.006),
                    (-0.185, s * 0.026, 0.006),
                ],
                5,
            )
            * k
        )
        arms.append(tube(path, 0.0031 * k, 8))
        tips.append(
            ellipsoid(0.017 * k, 0.012 * k, 0.012 * k, 12, 8).move(
                -0.188 * k, s * 0.024 * k, 0.006 * k
            )
        )
    fork = [
        tube(
            smooth(
                [
                    (0.03, 0, r / k),
                    (0.0, s * 0.004, r / k),
                    (-0.035, s * 0.0095, r / k),
                    (-0.06, s * 0.02, r / k),
                ],
                4,
            )
            * k,
            0.0048 * k,
            8,
        )
        for s in (-1, 1)
    ]
    bend = (
        smooth(
            [
                (0.028, 0, r / k),
                (0.1, 0.0, r / k),
                (0.16, 0.03, r / k),
                (0.15, 0.085, r / k),
                (0.08, 0.1, r / k),
                (0.02, 0.085, r / k),
                (-0.03, 0.09, r / k),
            ],
            6,
        )
        * k
    )
    hose = tube(bend, r, 9)
    chest = lathe(
        [
            (0, 0),
            (0.021, 0),
            (0.0225, 0.003),
            (0.0225, 0.006),
            (0.012, 0.01),
            (0.0085, 0.016),
            (0.012, 0.02),
            (0.016, 0.0215),
            (0.016, 0.024),
            (0, 0.024),
        ],
        28,
    ).scale(k, k, k)
    chest = chest.move(-0.055 * k, 0.092 * k)
    stem = tube([(-0.03 * k, 0.09 * k, 0.006 * k), (-0.05 * k, 0.092 * k, 0.012 * k)], 0.004 * k, 8)
    disc = cylinder(0.0145 * k, 0.0006, 24).move(-0.055 * k, 0.092 * k, 0.0238 * k)
    parts = [
        hull_of(chest),
        *(hull_of(a, t) for a, t in zip(arms, tips, strict=True)),
        hull_of(*fork),
    ]
    step = 6
    for n in range(0, len(bend) - 1, step):
        near = bend[n : n + step + 1]
        points = np.concatenate(
            [
                near + np.array([dx, dy, z])
                for dx in (-0.7 * r, 0.7 * r)
                for dy in (-0.7 * r, 0.7 * r)
                for z in (-0.98 * r, 0.8 * r)
            ]
        )
        parts.append(hull_part(points))
    return shape(
        [
            (join([*arms, chest, stem]), steel),
            (join([*fork, hose]), rubber),
            (join(tips), textures.plain((60, 60, 64))),
            (disc, textures.plain((236, 236, 232))),
        ],
        parts,
    )


def blood_pressure_monitor(look: Look) -> Shape:
    """A blood pressure monitor: its display on a slope, a button, a hose to its rolled cuff."""
    x, y, h = look.between(0.115, 0.14), look.between(0.1, 0.12), look.between(0.05, 0.065)
    color = look.color("white", "white", "gray", "sky", "charcoal", "silver")
    body = loft(
        np.stack(
            [
                np.column_stack([rectangle(1, 1, 0.14, 4) * [a, b] + [0, d], np.full(20, z)])
                for a, b, d, z in ((x, y, 0, 0), (x, y, 0, 0.018), (0.94 * x, 0.6 * y, 0.16 * y, h))
            ]
        ),
        rectangle(1, 1, 0.14, 4),
    )
    lean = np.arctan2(h - 0.018, 0.36 * y)
    face = prints.canvas(112, 72, (168, 184, 160))
    for row, value in enumerate(
        (look.rng.integers(110, 140), look.rng.integers(68, 90), look.rng.integers(58, 90))
    ):
        prints.write(face, str(int(value)), 0.62, 0.2 + 0.3 * row, 0.24, (34, 40, 36), bold=True)
        prints.fill(face, 0.1, 0.16 + 0.3 * row, 0.16, 0.06, (80, 92, 80))
    panel = box(0.66 * x, 0.4 * y, 0.003).turn(0, lean)
    panel = panel.move(-0.1 * x, -0.3 * y - 0.0015 * np.sin(lean), 0.5 * (h + 0.018) - 0.0005)
    button = (
        cylinder(0.013, 0.006, 22, bevel=0.001)
        .turn(0, lean)
        .move(0.36 * x, -0.3 * y, 0.5 * (h + 0.018))
    )
    blue = textures.plain(look.own_color("blue", "green", "orange", "navy"))
    cloth = textures.fabric(look.rng, look.own_color("navy", "gray", "charcoal", "blue"))
    r = look.between(0.036, 0.044)
    a = np.linspace(0, 3.4 * np.pi, 40)
    away = r * (1 - 0.06 * a / np.pi)
    inner = np.column_stack([away * np.cos(a), away * np.sin(a)])
    cuff = sweep(
        np.column_stack([inner[:, 0], np.zeros(40), inner[:, 1]]), rectangle(0.004, 0.1, 0.0015, 1)
    )
    cuff = cuff.move(x=x / 2 + 0.065, z=-float(cuff.bounds[0, 2]))
    hose = tube(
        smooth(
            [
                (x / 2 - 0.004, 0.1 * y, 0.012),
                (x / 2 + 0.015, -0.3 * y, 0.005),
                (x / 2 + 0.05, -0.55 * y, 0.005),
                (x / 2 + 0.065, -0.48 * y, 0.006),
            ],
            4,
        ),
        0.0032,
        8,
    )
    shell = textures.speckles(look.rng, color, 3, 32)
    return shape(
        [
            (body, shell),
            (panel, face),
            (button, blue),
            (cuff, cloth),
            (hose, textures.plain((150, 152, 156))),
        ],
        [hull_of(body), flat_foot(cuff.vertices, 0.1)],
    )


CATEGORIES = (
    Category("stethoscope", stethoscope, (0.36, 0.16, 0.024), 0.15, ("doctor stethoscope",),
             ("medical",), ("big",), ("black", "blue"), state="lying flat"),
    Category("blood_pressure_monitor", blood_pressure_monitor, (0.228, 0.119, 0.0784), 0.45,
             ("blood pressure cuff", "blood pressure meter", "sphygmomanometer",
             "blood pressure gauge", "blood pressure machine", "bp monitor"), ("medical",),
             ("big",), ("white",)),
)  # fmt: skip
"""The module's categories."""
