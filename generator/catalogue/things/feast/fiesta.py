"""Sombreros and pinatas."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.outlines import rectangle
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import ellipsoid, join, lathe, prism
from ...surfaces import textures
from ...surfaces.look import Look


def sombrero(look: Look) -> Shape:
    """A sombrero: a very wide turned-up brim, a tall crown, bands of bright embroidery."""
    k, color = look.between(0.85, 1.0), look.color("tan", "red", "black", "green", "wooden")
    body = lathe(
        [
            (0, 0),
            (0.15, 0),
            (0.2, 0.03),
            (0.205, 0.05),
            (0.195, 0.048),
            (0.15, 0.018),
            (0.075, 0.014),
            (0.06, 0.07),
            (0.035, 0.125),
            (0.015, 0.138),
            (0, 0.138),
        ],
        40,
    )
    bright = [(206, 44, 60), (250, 206, 60), (60, 150, 90), (52, 104, 190)]
    tile = textures.stack((textures.speckles(look.rng, color, 8), 0.38),
                          (textures.stripes(bright, 8, upright=True), 0.06),
                          (textures.speckles(look.rng, color, 8), 0.22),
                          (textures.stripes(bright[::-1], 10, upright=True), 0.06),
                          (textures.speckles(look.rng, color, 8), 0.28), side=160)  # fmt: skip
    pom = [
        ellipsoid(0.014, 0.014, 0.014, 6, 4).move(0.204 * np.cos(a), 0.204 * np.sin(a), 0.05)
        for a in np.arange(22) * 2 * np.pi / 22
    ]
    return shape(
        [(body.scale(k, k, k), tile), (join(pom).scale(k, k, k), textures.plain((250, 206, 60)))],
        [
            hull_part(body.scale(k, k, k).vertices[body.vertices[:, 2] < 0.055]),
            hull_part(
                body.scale(k, k, k).vertices[
                    np.hypot(body.vertices[:, 0], body.vertices[:, 1]) < 0.08
                ]
            ),
        ],
    )


def pinata(look: Look) -> Shape:
    """A pinata: a paper donkey in fringed stripes of bright colours."""
    k, color = look.between(0.85, 1.05), look.color("pink", "yellow", "turquoise", "orange")
    bodies = [prism(rectangle(0.16, 0.07, 0.02), 0, 0.08).move(0, 0, 0.075),
              prism(rectangle(0.05, 0.05, 0.014), 0, 0.08).turn(1, -0.35).move(-0.07, 0, 0.13),
              prism(rectangle(0.085, 0.045, 0.014), 0, 0.045).turn(1, 0.25).move(-0.12, 0,
                  0.2)]  # fmt: skip
    bodies += [
        prism(rectangle(0.034, 0.028, 0.006), 0, 0.085).move(x, y, 0)
        for x in (-0.055, 0.055)
        for y in (-0.02, 0.02)
    ]
    ears = [
        prism(rectangle(0.012, 0.018, 0.004), 0, 0.05)
        .turn(0, -0.2 * s)
        .move(-0.09, 0.014 * s, 0.24)
        for s in (-1, 1)
    ]
    tail = limb([(0.08, 0, 0.14), (0.1, 0, 0.12), (0.105, 0, 0.08)], [0.006, 0.008, 0.012], 8)
    hues = [color, (250, 206, 60), (72, 184, 184), (236, 84, 140), (90, 170, 80), (238, 132, 38)]
    fringe = textures.stripes(hues, 1, side=96)
    noisy = textures.noise(look.rng, 96, 96, (8, 30), 2)[..., None] * 26
    tile = np.clip(fringe + noisy, 0, 255).astype(np.uint8)
    made = [
        (join(bodies), tile),
        (join([*ears, tail]), textures.plain(color)),
        (
            join(
                [ellipsoid(0.01, 0.006, 0.012, 8, 6).move(-0.135, s * 0.024, 0.22) for s in (-1, 1)]
            ),
            textures.plain((24, 24, 28)),
        ),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(*[b.scale(k, k, k) for b in bodies[:1]]),
            hull_of(*[b.scale(k, k, k) for b in bodies[1:3]]),
            *[hull_of(b.scale(k, k, k)) for b in bodies[3:]],
        ],
    )


CATEGORIES = (
    Category("sombrero", sombrero, (0.392, 0.39, 0.129), 0.25, ("mexican hat", "mariachi hat"),
             ("toys",), ("big", "round"), ("tan",)),
    Category("pinata", pinata, (0.262, 0.066, 0.274), 0.3, ("donkey pinata", "party pinata"),
             ("toys",), ("tall", "big"), ("pink",)),
)  # fmt: skip
"""The module's categories."""
