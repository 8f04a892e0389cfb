"""Easter and Halloween things: eggs, baskets, pumpkins, skulls."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, ring_parts
from ...build.forms import above, lobe
from ...build.recipes import Pieces, ball, open_vessel, put_down, rod, standing_plate
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, refine, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GAY = ("red", "blue", "yellow", "green", "pink", "purple", "orange", "teal")


def witch_hat(look: Look) -> Shape:
    """A witch's hat: a wide brim, a bent cone, a band with a buckle."""
    color = look.color("black", "black", "purple", "charcoal")
    cloth = textures.fabric(look.rng, color)
    k = look.between(0.85, 1.15)
    brim = lathe([(0, 0), (0.1, 0), (0.105, 0.004), (0.1, 0.006), (0, 0.01)], 32)
    cone = rod([(0, 0, 0.004), (0, 0, 0.06), (0.008, 0, 0.11), (0.035, 0, 0.15)],
               [0.058, 0.036, 0.02, 0.004], 22, 5)  # fmt: skip
    band = cylinder(0.0575, 0.018, 28, top=0.052).move(z=0.008)
    buckle = box(0.026, 0.004, 0.02).move(0, -0.054, 0.008)
    inner = box(0.016, 0.004, 0.011).move(0, -0.0551, 0.0125)
    hue = textures.plain(look.own_color("purple", "orange", "green", "red"))
    return put_down(
        [
            (join([brim, cone]), cloth),
            (band, hue),
            (buckle, textures.plain((224, 184, 80))),
            (inner, hue),
        ],
        brim,
        cone,
        factor=k,
    )


def easter_egg(look: Look) -> Shape:
    """A painted egg lying."""
    color = look.color("pink", "sky", "yellow", "mint", "lavender", "orange", "red", "blue")
    d = look.between(0.042, 0.05)
    kind = look.pick(["bands", "dots", "zigzag"])
    pale = tint_color(color, 1.7)
    if kind == "bands":
        tile = textures.stripes([color, pale, look.own_color(*GAY), pale], 3, side=96)
    elif kind == "dots":
        tile = prints.canvas(96, 96, color)
        for k in range(36):
            prints.disc(
                tile, (k % 6 + 0.5 * (k // 6 % 2) + 0.2) / 6, (k // 6 + 0.5) / 6, 0.045, pale
            )
    else:
        tile = prints.canvas(96, 96, color)
        for z, hue in ((0.3, pale), (0.5, look.own_color(*GAY)), (0.7, pale)):
            line = [(n / 16, z + 0.05 * (-1) ** n) for n in range(17)]
            prints.stroke(tile, line, 0.045, hue)
    egg = ellipsoid(d, d, 1.32 * d, 24, 16).bend(
        lambda p: p * np.column_stack([*[1 - 0.9 * p[:, 2] / d * 0.14] * 2, np.ones(len(p))])
    )
    egg = egg.turn(1, np.pi / 2).move(z=0.485 * d)
    return shape([(egg, tile)], [flat_foot(above(egg.vertices), 0.06)])


def jack_o_lantern(look: Look) -> Shape:
    """A carved pumpkin with eyes, a nose and a toothed grin."""
    color = look.color("orange", "orange", "amber", "coral")
    d = look.between(0.11, 0.15)
    body = lobe(ellipsoid(d, d, 0.78 * d, 40, 14), 10, 0.12).move(z=0.37 * d)
    stem = rod([(0, 0, 0.72 * d), (0.004, 0, 0.82 * d), (0.018, 0, 0.9 * d)],
               [0.011, 0.008, 0.009], 8)  # fmt: skip
    r = 0.53 * d

    def carve(points: list[tuple[float, float]]) -> Solid:
        """Return a dark patch (x, z in units of the width) laid on the front."""
        plate = refine(refine(standing_plate(np.array(points) * d, 0.1 * d)))

        def wrap(p: np.ndarray) -> np.ndarray:
            z = (p[:, 2] - 0.37 * d) / (0.39 * d)
            reach = r * np.sqrt(np.maximum(1 - z**2, 0.05)) * 0.995
            depth = np.sqrt(np.maximum(reach**2 - p[:, 0] ** 2, 0))
            return np.column_stack([p[:, 0], -depth + 0.4 * p[:, 1] - 0.012 * d, p[:, 2]])

        return plate.bend(wrap)

    eyes = [carve([(s * 0.19 - 0.08, 0.48), (s * 0.19 + 0.08, 0.48), (s * 0.19, 0.62)])
            for s in (-1, 1)]  # fmt: skip
    nose = carve([(-0.035, 0.41), (0.035, 0.41), (0.0, 0.48)])
    grin = carve(
        [
            (-0.28, 0.37),
            (-0.17, 0.26),
            (-0.09, 0.26),
            (-0.09, 0.295),
            (-0.03, 0.295),
            (-0.03, 0.24),
            (0.09, 0.25),
            (0.17, 0.26),
            (0.28, 0.37),
            (0.13, 0.32),
            (0.08, 0.33),
            (0.08, 0.295),
            (0.02, 0.295),
            (0.02, 0.325),
            (-0.13, 0.325),
        ]
    )
    glow = textures.plain(look.pick([(30, 22, 18), (250, 206, 80)]))
    skin = textures.stripes([color, tint_color(color, 0.88)], 10, upright=True, side=96)
    return put_down([(body, skin), (stem, textures.plain((110, 120, 60))),
                    (join([*eyes, nose, grin]), glow)], body, stem)  # fmt: skip


def skull(look: Look) -> Shape:
    """A skull with dark eye holes and teeth, its face to the front."""
    color = look.color("ivory", "white", "cream", "black", "silver", "gold")
    bone = textures.speckles(look.rng, color, 8)
    hollow = textures.plain((28, 24, 24) if sum(color) > 250 else (190, 40, 40))
    brain = ball(0.086, 0.104, 0.084, (0, 0.008, 0.072), 22)
    face = ball(0.066, 0.05, 0.06, (0, -0.03, 0.05), 16)
    cheeks = [ball(0.026, 0.03, 0.02, (s * 0.027, -0.034, 0.045), 10) for s in (-1, 1)]
    jaw = lathe([(0, 0), (0.022, 0), (0.027, 0.012), (0.024, 0.028), (0, 0.03)], 18)
    jaw = jaw.move(0, -0.026, 0)
    back = cylinder(0.026, 0.04, 16).move(0, 0.012, 0)
    eyes = [ball(0.024, 0.014, 0.022, (s * 0.0165, -0.0475, 0.066), 12) for s in (-1, 1)]
    nose = standing_plate([(-0.0065, 0), (0.0065, 0), (0, 0.014)], 0.006).move(0, -0.0545, 0.041)
    teeth = [box(0.005, 0.004, 0.0085).move(0.0058 * n, -0.052 + 0.0009 * n * n, z)
             for n in (-3, -2, -1, 0, 1, 2, 3) for z in (0.0225, 0.013)]  # fmt: skip
    gap = box(0.04, 0.004, 0.022).move(0, -0.0485, 0.012)
    pieces: Pieces = [(join([brain, face, *cheeks, jaw, back]), bone),
                      (join([*eyes, nose, gap]), hollow),
                      (join(teeth), textures.plain(tint_color(color, 1.2)))]  # fmt: skip
    return put_down(pieces, brain, join([face, jaw]), back, factor=look.between(0.8, 1.1))


def easter_basket(look: Look) -> Shape:
    """A small round basket, open above, its handle folded down behind."""
    r, h = look.between(0.07, 0.09), look.between(0.065, 0.08)
    color = look.color("tan", "brown", "white", "pink", "sky", "bronze", "mint")
    body, _ = open_vessel([(0.8 * r, 0), (0.93 * r, 0.5 * h), (r, h)], 0.006, 0.006)
    rim = torus(0.98 * r, 0.006, 32, 8).move(z=h)
    grip = rod(
        [
            (-1.04 * r, 0, h),
            (-0.85 * r, 0.75 * r, h - 0.004),
            (0, 1.16 * r, h - 0.008),
            (0.85 * r, 0.75 * r, h - 0.004),
            (1.04 * r, 0, h),
        ],
        0.006,
        8,
    )
    loops = [
        ball(0.034, 0.01, 0.024, (-0.97 * r + 0.006 * s, s * 0.018, h - 0.004), 8) for s in (-1, 1)
    ]
    weave = textures.basketwork(look.rng, color, 14)
    knot = textures.plain(look.own_color("pink", "yellow", "lavender", "red"))
    wall = ring_parts([(0.8 * r, 0), (0.93 * r, 0.5 * h), (r, h)],
                      [(r - 0.006, h), (0.8 * r - 0.006, 0.006)], 14)  # fmt: skip
    return shape([(body, weave), (join([rim, grip]), textures.plain(tint_color(color, 0.85))),
                  (join(loops), knot)], [*wall, cylinder_part(0.78 * r, 0.006)])  # fmt: skip


CATEGORIES = (
    Category("witch_hat", witch_hat, (0.21, 0.21, 0.152), 0.08, ("wizard hat", "halloween hat",
             "pointed hat"), ("living",), (), ("black",)),
    Category("easter_egg", easter_egg, (0.061, 0.046, 0.045), 0.05, ("painted egg",
                 "decorated egg", "chocolate egg", "coloured egg", "dyed egg", "pysanka",
                 "foil wrapped egg", "creme egg", "faberge egg", "mini egg", "plastic egg",
                 "foil egg"), ("living",),
             ("round",), ("pink", "sky"), state="lying"),
    Category("jack_o_lantern", jack_o_lantern, (0.13, 0.135, 0.12), 0.5, ("carved pumpkin",
             "jack-o-lantern", "jack o'lantern", "pumpkin lantern"),
             ("living",), ("round",), ("orange",)),
    Category("skull", skull, (0.083, 0.11, 0.11), 0.35, ("human skull", "skull decoration",
             "halloween skull", "decorative skull", "plastic skull", "skull model"), ("living",),
             (), ("ivory",)),
    Category("easter_basket", easter_basket, (0.189, 0.183, 0.0791), 0.25, ("egg basket",
                 "gift basket", "basket with a handle", "flower basket"),
             ("living",), ("container", "round"), ("tan",)),
)  # fmt: skip
"""The module's categories."""
