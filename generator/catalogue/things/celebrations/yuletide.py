"""Nativity scenes, Christmas pyramids, cake toppers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import ellipse, smooth
from ...build.recipes import Pieces, ball, rod, straight
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look

SKIN: RGB = (232, 192, 158)


def _person(x: float, y: float, h: float, z: float = 0.0) -> tuple[Solid, Solid]:
    """Return a robe and a head of a small wooden figure."""
    robe = lathe(
        [(0, 0), (0.26 * h, 0), (0.22 * h, 0.3 * h), (0.13 * h, 0.7 * h), (0, 0.74 * h)], 16
    )
    head = ball(0.25 * h, 0.25 * h, 0.27 * h, (0, 0, 0.86 * h), 12)
    return robe.move(x, y, z), head.move(x, y, z)


def nativity(look: Look) -> Shape:
    """A stable with a star, Mary, Joseph, a king and the crib."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "wooden", "brown")
    floor = block(0.2, 0.11, 0.008, 0.004)
    posts = [
        box(0.01, 0.01, 0.085).move(s * 0.085, y, 0.008) for s in (-1, 1) for y in (0.04, -0.03)
    ]
    back = box(0.18, 0.005, 0.085).move(0, 0.045, 0.008)
    roof = [box(0.122, 0.1, 0.005).turn(1, s * 0.5).move(s * 0.049, 0.006, 0.112) for s in (-1, 1)]
    star = join([box(0.026, 0.003, 0.006).turn(1, a).move(0, -0.046, 0.135)
                 for a in (0, np.pi / 3, 2 * np.pi / 3)])  # fmt: skip
    crib = block(0.03, 0.02, 0.012, 0.002).move(0, -0.025, 0.008)
    child = ball(0.022, 0.012, 0.01, (0, -0.025, 0.021), 10)
    robes, heads = [], []
    tones = ((50, 90, 170), (124, 84, 56), (150, 40, 60), (110, 110, 60))
    pieces: Pieces = []
    for (x, y, h), tone in zip(((-0.035, -0.012, 0.056), (0.036, -0.01, 0.064), (0.068, -0.035,
                               0.058), (-0.068, -0.032, 0.05)), tones, strict=True):  # fmt: skip
        robe, head = _person(x, y, h, 0.008)
        robes.append(robe)
        heads.append(head)
        pieces.append((robe, textures.plain(tone)))
    wood = look.surface(color, "wood")
    frame = join([floor, *posts, back])
    return shape(
        [
            (frame, wood),
            (join(roof), textures.scratches(look.rng, (150, 110, 62), (200, 164, 100), 90)),
            (star, textures.plain((246, 206, 80))),
            (crib, textures.plain((170, 126, 70))),
            (child, textures.plain((248, 240, 220))),
            (join(heads), textures.plain(SKIN)),
            *pieces,
        ],
        [
            hull_of(floor),
            hull_of(back),
            hull_of(*roof),
            hull_of(star),
            hull_of(*posts[:2]),
            hull_of(*posts[2:]),
            *(hull_of(r, h) for r, h in zip(robes, heads, strict=True)),
        ],
    ).scale(k)


def pyramid(look: Look) -> Shape:
    """A wooden Christmas pyramid: two decks of figures, candles, a fan on top."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "wooden", "red", "green")
    base = prism(ellipse(0.17, 0.17, 8, np.pi / 8), 0, 0.012)
    decks = [cylinder(0.055, 0.005, 28).move(z=0.03), cylinder(0.038, 0.005, 28).move(z=0.1)]
    pole = straight((0, 0, 0.01), (0, 0, 0.2), 0.003)
    legs = [rod([(0.07 * np.cos(a), 0.07 * np.sin(a), 0.01), (0.064 * np.cos(a), 0.064 * np.sin(a),
                0.1), (0.012 * np.cos(a), 0.012 * np.sin(a), 0.172)], 0.004, 7)
            for a in (0.785, 2.356, 3.927, 5.498)]  # fmt: skip
    blades = []
    for n in range(10):
        blade = box(0.06, 0.024, 0.0018).move(x=0.045).turn(0, 0.45).turn(2, 2 * np.pi * n / 10)
        blades.append(blade.move(z=0.2))
    hub = cylinder(0.015, 0.012, 18).move(z=0.194)
    tips = [cylinder(0.0055, 0.026, 12).move(0.072 * np.cos(a), 0.072 * np.sin(a), 0.012)
            for a in (0, 1.571, 3.142, 4.712)]  # fmt: skip
    flames = [ball(0.006, 0.006, 0.012, (0.072 * np.cos(a), 0.072 * np.sin(a), 0.044), 8)
              for a in (0, 1.571, 3.142, 4.712)]  # fmt: skip
    people = []
    for n in range(4):
        a = 1.571 * n + 0.4
        people += [*_person(0.036 * np.cos(a), 0.036 * np.sin(a), 0.04, 0.034)]
        people += [*_person(0.022 * np.cos(a), 0.022 * np.sin(a), 0.032, 0.104)]
    wood = look.surface(color, "wood")
    pale = textures.wood(look.rng, (226, 190, 136))
    frame = join([base, *decks, *legs, pole])
    return shape(
        [
            (frame, wood),
            (join([*blades, hub]), pale),
            (join(people[::2]), textures.stripes([(180, 50, 50), (60, 110, 70)], 1, upright=True)),
            (join(people[1::2]), textures.plain(SKIN)),
            (join(tips), textures.plain((248, 240, 216))),
            (join(flames), textures.plain((252, 196, 60))),
        ],
        [hull_of(base), hull_of(*legs), hull_of(*blades, hub), hull_of(*tips)],
    ).scale(k)


def topper(look: Look) -> Shape:
    """A bride and groom standing on a small white base."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "white", "ivory")
    base = cylinder(0.034, 0.009, 30, bevel=0.002)
    gown = lathe(
        np.maximum(
            smooth(
                [
                    (0, 0),
                    (0.022, 0),
                    (0.02, 0.015),
                    (0.011, 0.036),
                    (0.0075, 0.044),
                    (0.0095, 0.056),
                    (0.006, 0.063),
                    (0, 0.064),
                ],
                3,
            ),
            0,
        ),
        20,
    ).move(-0.013, 0, 0.008)
    veil = lathe([(0, 0.03), (0.013, 0.03), (0.0125, 0.066), (0.006, 0.078), (0, 0.079)], 16)
    veil = veil.scale(1, 0.6, 1).move(-0.013, 0.007, 0.008)
    legs = block(0.018, 0.012, 0.032, 0.004).move(0.015, 0, 0.008)
    coat = lathe([(0, 0.028), (0.0115, 0.028), (0.0125, 0.05), (0.0095, 0.063), (0, 0.066)], 16)
    coat = coat.scale(1, 0.75, 1).move(0.015, 0, 0.008)
    heads = [ball(0.015, 0.015, 0.017, (x, -0.001, z), 12) for x, z in ((-0.013, 0.08),
             (0.015, 0.082))]  # fmt: skip
    hair = [ball(0.016, 0.014, 0.012, (0.015, 0.0025, 0.086), 10)]
    shirt = prism(np.array([(0, 0), (0.004, 0.016), (-0.004, 0.016)]), -0.001, 0.001).turn(
        0, np.pi / 2).move(0.015, -0.0092, 0.052)  # fmt: skip
    flowers = ball(0.013, 0.012, 0.012, (-0.006, -0.012, 0.05), 10)
    arms = [limb([(-0.022, -0.002, 0.066), (-0.023, -0.009, 0.056), (-0.008, -0.012, 0.052)],
                 [0.0032] * 3, 6)]  # fmt: skip
    sleeve = [limb([(0.025, 0, 0.068), (0.028, -0.002, 0.056), (0.026, -0.006, 0.046)],
                   [0.0038] * 3, 6), limb([(0.006, 0, 0.066), (0.002, -0.004, 0.058),
                   (-0.004, -0.008, 0.054)], [0.0035] * 3, 6)]  # fmt: skip
    dark = textures.plain((34, 34, 42))
    white = textures.speckles(look.rng, color, 3)
    people = [gown, veil, legs, coat, *heads]
    return shape([(base, white), (join([gown, veil, shirt]), white),
                  (join([legs, coat, *sleeve]), dark),
                  (join([*heads, *arms]), textures.plain(SKIN)),
                  (join(hair), textures.plain((70, 46, 32))),
                  (flowers, textures.spots(look.rng, (226, 90, 120), (90, 140, 70), 0.3))],
                 [hull_of(base), hull_of(*people)]).scale(k)  # fmt: skip


_L = ("living",)


CATEGORIES = (
    vary(Category("nativity_set", nativity, (0.21, 0.111, 0.149), 0.6, ("nativity scene",
             "nativity",
             "christmas crib", "creche", "nativity figures", "manger scene", "creches"), _L,
             ("big",), ("wooden",))),
    Category("christmas_pyramid", pyramid, (0.155, 0.155, 0.204), 0.4, ("candle pyramid",
             "wooden christmas pyramid", "german christmas pyramid"), _L, ("tall",), ("wooden",)),
    vary(Category("cake_topper", topper, (0.0709, 0.0687, 0.093), 0.06,
             ("bride and groom cake topper",
             "wedding cake topper", "bride and groom", "bride and groom figurine",
             "bride and groom topper"), _L, (), ("white",))),
)  # fmt: skip
"""The module's categories."""
