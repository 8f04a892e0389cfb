"""Objects of the ``lab`` theme: models and miniatures."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, shine
from ...kit.parts import hull_of, resting_ball
from ...kit.primitives import at_block, ball, disc, rod, standing, straight
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, shape, vary
from ...kit.solids import ellipsoid, join, torus, tube
from ...kit.surfaces import Look, tint_color
from ...values import ConvexPart
from .teeth import _tooth


@category("molecule_model", size=(0.09, 0.103, 0.086), mass=0.06, material="plastic",
          assembled=True, aliases=("molecule", "molecular model", "atom model",
          "ball and stick model", "dna model", "cell model"), themes=("lab",),
          colors=("black", "red"))  # fmt: skip
def molecule_model(look: Look) -> Shape:
    """A ball-and-stick model of a small molecule."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "red", "blue", "black")
    ways = np.array([(0.94, 0, -0.33), (-0.47, 0.82, -0.33), (-0.47, -0.82, -0.33), (0, 0, 1.0)])
    long, big, small = 0.046 * k, 0.034 * k, 0.025 * k
    center = np.array([0, 0, 0.33 * long + small / 2])
    balls = [ellipsoid(big, big, big, 20, 12).move(*center)]
    outer = [ellipsoid(small, small, small, 16, 10).move(*(center + long * w)) for w in ways]
    rods = [tube([center, center + long * w], 0.0032 * k, 8) for w in ways]
    tone = look.own_color("white", "white", "red", "green", "yellow")
    feet = [resting_ball(small, small, small) for _ in range(3)]
    feet = [ConvexPart(np.add(p.vertices, (*(long * w)[:2], 0.0))) for p,
            w in zip(feet, ways, strict=False)]  # fmt: skip
    return shape([(join(balls), surfaces.speckles(look.rng, color, 3, 32)),
                  (join(outer), surfaces.speckles(look.rng, tone, 3, 32)),
                  (join(rods), surfaces.plain((170, 172, 176)))],
                 [*feet, hull_of(balls[0]), hull_of(outer[3]),
                     *(hull_of(r) for r in rods)])  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("brain_model", size=(0.135, 0.125, 0.13), mass=0.5, material="plastic",
          aliases=("model brain", "brain", "human brain model", "anatomical brain"),
          themes=("lab",), colors=("pink",))  # fmt: skip
@from_pieces(bodies=5)
def brain_model(look: Look) -> Pieces:
    """A brain model on a round black base: two folded halves, a striped cerebellum and a stem."""
    color = look.color("pink", "beige", "coral")
    pieces: Pieces = []

    def folds(p: np.ndarray) -> np.ndarray:
        wave = 1 + 0.035 * np.sin(160 * p[:, 0] + 3 * np.sin(150 * p[:, 1])) * np.cos(
            150 * p[:, 2] + 2 * np.sin(120 * p[:, 0])
        )
        return p * wave[:, None]

    skin = surfaces.spots(look.rng, color, tint_color(color, 0.78), 0.3)
    for s in (-1, 1):
        half = ball(0.13, 0.062, 0.095, (0, 0, 0), 40).bend(folds).move(0, s * 0.03, 0.085)
        pieces.append((half, skin))
    stem = rod([(0.03, 0, 0.06), (0.04, 0, 0.035), (0.045, 0, 0.014)], [0.016, 0.013, 0.01], 10)
    cere = ball(0.055, 0.08, 0.04, (0.045, 0, 0.05), 16)
    return [(disc(0.045, 0.014), BLACK), *pieces, (cere, surfaces.stripes([tint_color(color, 0.8),
                                                                           tint_color(color, 1.05)],
                                                                          8)),
            (stem, surfaces.plain(tint_color(color, 1.2)))]  # fmt: skip


@category("eye_model", size=(0.1, 0.125, 0.138), mass=0.3, material="plastic",
          aliases=("model eye", "eyeball model"), themes=("lab",), colors=("blue",))  # fmt: skip
@vary()
@from_pieces(bodies=2)
def eye_model(look: Look) -> Pieces:
    """A white eyeball on a black base, with an iris, a pupil, red veins and a nerve at the back."""
    iris = look.color("blue", "green", "brown", "gray")
    foot = standing((0.04, 0), (0.038, 0.008), (0.008, 0.016), (0.008, 0.04))
    globe = ball(0.1, 0.1, 0.1, (0, 0, 0.088), 30)
    cornea = [ball(0.05, 0.014, 0.05, (0, -0.0435, 0.088), 20),
              ball(0.022, 0.008, 0.022, (0, -0.0482, 0.088), 14)]  # fmt: skip
    veins = [rod([(0.05 * np.sin(t) * np.cos(a), 0.05 * np.cos(t) - 0.0, 0.088 + 0.05 * np.sin(t)
                   * np.sin(a)) for t in (0.2, 0.8, 1.4)], 0.001, 5)
             for a in (0.5, 1.6, 2.7, 3.8, 5.1)]  # fmt: skip
    nerve = rod([(0, 0.048, 0.088), (0, 0.07, 0.088)], 0.011, 10)
    return [(foot, BLACK), (globe, surfaces.plain((244, 240, 234))),
            (cornea[0], surfaces.plain(iris)), (cornea[1], BLACK), (nerve, dye(look, "coral")),
            (join(veins), surfaces.plain((204, 60, 56)))]  # fmt: skip


@category("skeleton_model", size=(0.13, 0.09, 0.34), mass=0.4, material="metal", assembled=True,
          aliases=("model skeleton", "human skeleton"), themes=("lab",), roles=("tall",),
          colors=("ivory",))  # fmt: skip
@from_pieces()
def skeleton_model(look: Look) -> Pieces:
    """A skeleton hanging from a stand."""
    bone = look.surface(look.color("ivory", "cream", "white"))
    base, pole = (at_block(0.11, 0.09, 0.012, 0.01), straight((0, 0.025, 0.01), (0, 0.025, 0.33),
                                                              0.004, 8))  # fmt: skip
    skull = [ball(0.045, 0.05, 0.05, (0, 0, 0.315), 16), ball(0.03, 0.034, 0.03, (0, -0.006, 0.292),
                                                              12)]  # fmt: skip
    holes = [ball(0.012, 0.008, 0.013, (s * 0.011, -0.0225, 0.315), 8) for s in (-1, 1)] + [
        ball(0.006, 0.006, 0.008, (0, -0.0245, 0.303), 6)
    ]
    spine = [ball(0.012, 0.012, 0.01, (0, 0.006, 0.17 + 0.0115 * k), 8) for k in range(10)]
    ribs = [torus(1, 0.055, 16, 4).scale(0.036 - 0.0016 * abs(k - 2.5), 0.024,
                                         0.03).move(0, 0, 0.215 + 0.012 * k)
            for k in range(5)]  # fmt: skip
    hips = torus(1, 0.2, 18, 6).scale(0.03, 0.017, 0.03).move(0, 0, 0.163)
    limbs = []
    for s in (-1, 1):
        limbs += [rod([(s * 0.036, 0, 0.272), (s * 0.055, 0, 0.215), (s * 0.06, -0.006, 0.15)],
                      0.0042, 6), ball(0.014, 0.01, 0.022, (s * 0.061, -0.007, 0.138),
                                       8)]  # fmt: skip
        limbs += [
            rod([(s * 0.02, 0, 0.158), (s * 0.022, -0.003, 0.09), (s * 0.02, 0, 0.024)], 0.0052, 6),
            ball(0.016, 0.036, 0.011, (s * 0.02, -0.01, 0.018), 8),
        ]
    collar = straight((-0.036, 0, 0.275), (0.036, 0, 0.275), 0.0042, 6)
    return [(base, BLACK), (pole, shine(look)), (join(skull), bone), (join(spine), bone),
            (hips, bone), (join(ribs), bone), (join(limbs), bone), (collar, bone),
            (join(holes), BLACK)]  # fmt: skip


ANATOMICAL_MODEL_BLACK = surfaces.plain((34, 34, 37))


@category("anatomical_model", size=(0.165, 0.09, 0.283), mass=0.9, material="plastic",
          aliases=("anatomy model", "torso model", "human torso", "anatomical torso",
          "human body model"), themes=("lab",), roles=("tall",), colors=("white",))  # fmt: skip
@from_pieces(bodies=4)
def anatomical_model(look: Look) -> Pieces:
    """A torso with an open front and coloured organs."""
    skin = dye(look, "beige", "tan")
    foot = at_block(0.11, 0.09, 0.014, 0.02)
    body = standing((0.05, 0.014), (0.052, 0.05), (0.042, 0.1), (0.06, 0.16), (0.058, 0.185),
                    (0.018, 0.205), (0.016, 0.22)).scale(1, 0.66, 1)  # fmt: skip
    head = ball(0.05, 0.056, 0.066, (0, 0, 0.25), 18)
    arms = [ball(0.04, 0.036, 0.05, (s * 0.064, 0, 0.17), 12) for s in (-1, 1)]
    cavity = ball(0.076, 0.02, 0.15, (0, -0.026, 0.11), 18)
    lungs = [ball(0.03, 0.018, 0.055, (s * 0.019, -0.034, 0.15), 14) for s in (-1, 1)]
    heart = ball(0.022, 0.016, 0.026, (0.004, -0.042, 0.143), 12)
    liver = ball(0.05, 0.018, 0.024, (-0.008, -0.036, 0.112), 14)
    gut = tube(
        [(0.022 * np.sin(k * 1.6), -0.038, 0.095 - 0.0036 * k) for k in range(16)], 0.0055, 8
    )
    return [(foot, ANATOMICAL_MODEL_BLACK), (body, skin), (head, skin), (join(arms), skin),
            (cavity, dye(look, "maroon")), (join(lungs), surfaces.plain((230, 140, 150))),
            (heart, surfaces.plain((196, 36, 44))), (liver, surfaces.plain((130, 56, 44))),
            (gut, surfaces.plain((226, 168, 110)))]  # fmt: skip


WHITE = surfaces.plain((242, 242, 240))


@category("owl_pellet", size=(0.055, 0.028, 0.024), mass=0.01, material="plastic",
          aliases=("pellet",), themes=("lab",), colors=("gray",))  # fmt: skip
@from_pieces(foot=0.08, bodies=1)
def owl_pellet(look: Look) -> Pieces:
    """A furry owl pellet with four pieces of white bone on top."""
    color = look.color("gray", "charcoal", "brown")
    body = ball(0.055, 0.028, 0.026, (0, 0, 0.011), 18)
    bits = [rod([(x, y, 0.019), (x + 0.01, y + 0.006, 0.0235)], 0.0009, 5) for x,
            y in ((-0.016, -0.004), (-0.004, 0.003), (0.008, -0.006), (0.012, 0.002))]  # fmt: skip
    return [(body, surfaces.scratches(look.rng, color, tint_color(color, 1.4), 160)),
            (join(bits), WHITE)]  # fmt: skip


CATEGORIES = (
    Category("tooth_model", from_pieces()(_tooth(False, 0.1)), size=(0.0599, 0.0546, 0.101),
             mass=0.15, material="ceramic",
             aliases=("model tooth", "giant tooth", "dental model of a tooth"), themes=("lab",),
             colors=("white",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
