"""Ghosts, mummies, bones, hands and eyes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, straight
from ...build.settled import hull_above, limb, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe, torus, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

WHITE = textures.plain((248, 246, 238))
BLACK = textures.plain((24, 22, 26))


def skeleton(look: Look) -> Shape:
    """A toy skeleton lying on its back."""
    k = look.between(0.9, 1.15)
    color = look.color("ivory", "white", "lime", "cream")
    bone = textures.speckles(look.rng, color, 6)
    skull = join([ellipsoid(0.032, 0.036, 0.03, 14, 8).move(0, 0.106, 0.015),
                  ellipsoid(0.022, 0.02, 0.018, 10, 6).move(0, 0.09, 0.011)])  # fmt: skip
    eyes = [ball(0.008, 0.008, 0.006, (s * 0.007, 0.104, 0.0275), 8) for s in (-1, 1)]
    mouth = ellipsoid(0.012, 0.003, 0.004, 8, 4).move(0, 0.087, 0.019)
    spine = straight((0, 0.085, 0.007), (0, -0.005, 0.007), 0.0034)
    ribs = [torus(0.02 - 0.0022 * abs(n - 1), 0.0018, 18, 6).turn(0, np.pi / 2).scale(1, 1, 0.45)
            .move(0, 0.066 - 0.011 * n, 0.0095) for n in range(5)]  # fmt: skip
    hips = ellipsoid(0.038, 0.018, 0.012, 12, 6).move(0, -0.006, 0.007)
    arms, legs = [], []
    for s in (-1, 1):
        arms.append(
            limb(
                [
                    (0, 0.074, 0.008),
                    (s * 0.03, 0.07, 0.007),
                    (s * 0.05, 0.03, 0.006),
                    (s * 0.055, -0.01, 0.005),
                ],
                [0.003, 0.0038, 0.0034, 0.0028],
                6,
            )
        )
        legs.append(
            limb(
                [(s * 0.012, -0.008, 0.007), (s * 0.018, -0.055, 0.006), (s * 0.02, -0.11, 0.005)],
                [0.0045, 0.004, 0.0034],
                6,
            )
        )
        arms += [tube([(s * 0.055, -0.01, 0.005), (s * 0.057 + 0.005 * n, -0.026, 0.003)], 0.0015,
                      5) for n in (-1, 0, 1)]  # fmt: skip
        legs.append(ellipsoid(0.012, 0.026, 0.009, 8, 5).move(s * 0.023, -0.116, 0.0045))
        arms.append(ball(0.009, 0.009, 0.009, (s * 0.0495, 0.031, 0.006), 8))
        legs.append(ball(0.011, 0.011, 0.01, (s * 0.018, -0.055, 0.0065), 8))
    return shape([(join([skull, spine, *ribs, hips]), bone), (join([*arms, *legs]), bone),
                  (join([*eyes, mouth]), BLACK)],
                 [hull_above(skull), hull_above(spine, *ribs, hips), hull_above(*arms[: len(arms)
                  // 2]), hull_above(*arms[len(arms) // 2 :]), hull_above(*legs[:3]),
                  hull_above(*legs[3:])]).scale(k)  # fmt: skip


def ghost(look: Look) -> Shape:
    """A white ghost with a wavy hem, round eyes and an open mouth."""
    k = look.between(0.85, 1.15)
    color = look.color("white", "white", "ivory", "lime")
    side = smooth([(0.0, 0), (0.03, 0), (0.037, 0.002), (0.033, 0.02), (0.027, 0.05), (0.026, 0.07),
                   (0.021, 0.09), (0.01, 0.1), (0, 0.102)], 3)  # fmt: skip
    side = np.maximum(side, 0)
    body = lathe(side, 40)
    wavy = body.bend(
        lambda p: (
            p
            * np.column_stack(
                [
                    *[
                        1
                        + 0.13
                        * np.clip(1 - p[:, 2] / 0.05, 0, 1)
                        * np.cos(7 * np.arctan2(p[:, 1], p[:, 0]))
                    ]
                    * 2,
                    np.ones(len(p)),
                ]
            )
        )
    )
    arms = [limb([(s * 0.02, -0.004, 0.056), (s * 0.036, -0.012, 0.06), (s * 0.046, -0.02, 0.07)],
                 [0.01, 0.0085, 0.004], 8) for s in (-1, 1)]  # fmt: skip
    eyes = [ellipsoid(0.009, 0.006, 0.013, 10, 6).move(s * 0.0095, -0.0225, 0.076) for s in (-1, 1)]
    mouth = ellipsoid(0.011, 0.006, 0.013, 10, 6).move(0, -0.0255, 0.057)
    return shape(
        [
            (join([wavy, *arms]), textures.speckles(look.rng, color, 4)),
            (join([*eyes, mouth]), BLACK),
        ],
        [hull_of(wavy), hull_of(*arms)],
    ).scale(k)


def mummy(look: Look) -> Shape:
    """A mummy standing, wrapped in bandages, eyes between them."""
    k = look.between(0.85, 1.15)
    color = look.color("cream", "ivory", "beige", "tan")
    body = lathe(np.maximum(smooth([(0, 0), (0.02, 0), (0.02, 0.01), (0.026, 0.045), (0.03, 0.075),
                 (0.018, 0.092), (0.0, 0.096)], 3), 0), 22).scale(1, 0.75, 1)  # fmt: skip
    head = ellipsoid(0.036, 0.036, 0.042, 18, 10).move(z=0.11)
    arms = [limb([(s * 0.027, -0.004, 0.08), (s * 0.03, -0.03, 0.076), (s * 0.024, -0.055, 0.078)],
                 [0.0095, 0.009, 0.008], 10) for s in (-1, 1)]  # fmt: skip
    feet = ellipsoid(0.046, 0.034, 0.016, 14, 6).move(0, -0.004, 0.008)
    bands = textures.stripes([color, color, color, tint_color(color, 0.68)], 9)
    gap = ellipsoid(0.03, 0.012, 0.008, 12, 6).move(0, -0.0135, 0.113)
    eyes = [ball(0.0065, 0.005, 0.006, (s * 0.0065, -0.018, 0.113), 8) for s in (-1, 1)]
    loose = tube(smooth([(0.022, 0.004, 0.05), (0.04, 0.0, 0.04), (0.046, -0.004, 0.02)], 3), 0.004,
                 6, squash=0.25)  # fmt: skip
    pieces: Pieces = [(body, bands), (head, bands), (join([*arms, feet, loose]), bands),
                      (gap, BLACK), (join(eyes), textures.plain((246, 230, 120)))]  # fmt: skip
    return shape(pieces, [hull_of(body, feet), hull_of(head), hull_of(*arms)]).scale(k)


def hand(look: Look) -> Shape:
    """A cut-off hand lying palm down, spread fingers, a red stump."""
    k = look.between(0.85, 1.05)
    color = look.color("beige", "lime", "tan", "ivory")
    flesh = tint_color((222.0, 184.0, 150.0), 1.0) if "color" not in look.attributes else color
    if look.chance(0.3) and "color" not in look.attributes:
        flesh = (150.0, 170.0, 120.0)
    palm = ellipsoid(0.08, 0.085, 0.034, 18, 10).move(0, 0, 0.016)
    wrist = cylinder(0.026, 0.05, 18).turn(0, np.pi / 2).scale(1, 1, 0.75).move(0, -0.022, 0.018)
    fingers = [
        limb(
            [(x, 0.03, 0.016), (1.3 * x, 0.03 + 0.55 * n, 0.022), (1.45 * x, 0.03 + n, 0.006)],
            [0.01, 0.0095, 0.0065],
            9,
        )
        for x, n in ((-0.028, 0.052), (-0.01, 0.068), (0.01, 0.064), (0.028, 0.046))
    ]
    thumb = limb([(0.03, -0.015, 0.015), (0.052, 0.008, 0.015), (0.062, 0.03, 0.007)],
                 [0.012, 0.0105, 0.007], 9)  # fmt: skip
    nails = [
        ellipsoid(0.009, 0.012, 0.004, 8, 4).move(1.44 * x, 0.026 + n, 0.011)
        for x, n in ((-0.028, 0.052), (-0.01, 0.068), (0.01, 0.064), (0.028, 0.046))
    ]
    stump = cylinder(0.0235, 0.003, 18).turn(0, np.pi / 2).scale(1, 1, 0.75).move(0, -0.0705, 0.018)
    bone = cylinder(0.008, 0.006, 12).turn(0, np.pi / 2).move(0, -0.0705, 0.018)
    skin = textures.speckles(look.rng, flesh, 9)
    return settle([(join([palm, wrist]), skin), (join([*fingers, thumb]), skin),
                   (stump, textures.spots(look.rng, (160, 24, 28), (110, 10, 16), 0.3)),
                   (join([bone, *nails]), WHITE)], 0.08, hulls=[[0], [1]]).scale(k)  # fmt: skip


def finger(look: Look) -> Shape:
    """A cut-off finger lying, with its nail and a red end."""
    k = look.between(0.9, 1.15)
    color = look.color("beige", "tan", "lime")
    flesh: RGB = (222, 184, 150) if "color" not in look.attributes else color
    rod_ = limb([(-0.035, 0, 0.0095), (-0.005, 0, 0.012), (0.02, 0, 0.011), (0.036, 0, 0.009)],
                [0.0095, 0.0098, 0.009, 0.005], 12)  # fmt: skip
    nail = ellipsoid(0.015, 0.01, 0.004, 10, 5).move(0.028, 0, 0.0165)
    end = cylinder(0.0085, 0.002, 14).turn(1, np.pi / 2).move(-0.0365, 0, 0.0095)
    folds = [tube([(x, -0.006, 0.0185), (x, 0, 0.0212), (x, 0.006, 0.0185)], 0.0008, 5)
             for x in (-0.008, -0.005, 0.012)]  # fmt: skip
    return settle([(rod_, textures.speckles(look.rng, flesh, 9)),
                   (nail, textures.plain((240, 214, 200))), (end, textures.plain((150, 20, 26))),
                   (join(folds), textures.plain(tint_color(flesh, 0.75)))], 0.14,
                  hulls=[[0]]).scale(k)  # fmt: skip


def eyeball(look: Look) -> Shape:
    """A staring eyeball with red veins, looking up to the front."""
    r = look.between(0.013, 0.019)
    color = look.color("blue", "green", "brown", "teal")
    globe = ball(2 * r, 2 * r, 2 * r, (0, 0, 0), 22)
    lean = 0.75

    def cap(share: float, out: float) -> Solid:
        a = np.linspace(0, share, 6)
        ring = np.column_stack([out * r * np.sin(a), out * r * np.cos(a)])[::-1]
        inner = np.column_stack([0.97 * r * np.sin(a), 0.97 * r * np.cos(a)])
        profile = np.concatenate([[(0, inner[0, 1])], inner[1:], ring[:-1], [(0, ring[-1, 1])]])
        return lathe(profile, 20).turn(0, lean)

    veins = [tube(smooth([(0.72 * r * np.cos(t), 0.72 * r * np.sin(t), 0.7 * r), (0.9 * r * np.cos(
             t + 0.15), 0.9 * r * np.sin(t + 0.15), 0.44 * r), (1.0 * r * np.cos(t - 0.1), 1.0 * r *
             np.sin(t - 0.1), 0.08 * r)], 3), 0.035 * r, 4).turn(0, lean)
             for t in np.arange(8) * 0.785]  # fmt: skip
    return settle([(globe, WHITE), (cap(0.62, 1.03), textures.plain(color)),
                   (cap(0.28, 1.06), BLACK), (join(veins), textures.plain((200, 50, 50)))], 0.12,
                  hulls=[[0]])  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("skeleton", skeleton, (0.136, 0.271, 0.0328), 0.05, ("toy skeleton",
             "plastic skeleton", "glow-in-the-dark skeleton", "skeleton figure", "mini skeleton",
             "halloween skeleton"), _L, (), ("ivory",), state=_D),
    Category("ghost", ghost, (0.0999, 0.0823, 0.103), 0.08, ("ghost figure", "ghost figurine",
             "halloween ghost", "ghost decoration", "toy ghost"), _L, (), ("white",)),
    Category("mummy", mummy, (0.0896, 0.0825, 0.136), 0.12, ("mummy figure", "mummy figurine",
             "toy mummy", "zombie figure", "zombie", "zombies"), _L, (), ("cream",)),
    vary(Category("severed_hand", hand, (0.113, 0.174, 0.0351), 0.15, ("fake hand", "zombie hand",
             "mannequin hand", "rubber hand", "plastic hand", "hand prop"), _L,
             (), (), state=_D)),
    vary(Category("severed_finger", finger, (0.0772, 0.0207, 0.0199), 0.012, ("fake finger",
             "rubber finger", "zombie finger", "plastic finger"), _L, (), (), state=_D)),
    Category("eyeball", eyeball, (0.0316, 0.0311, 0.0275), 0.01, ("fake eyeball", "glass eye",
             "plastic eyeball", "rubber eyeball", "candy eyeball"), _L, ("round",),
             ("blue",)),
)  # fmt: skip
"""The module's categories."""
