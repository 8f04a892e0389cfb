"""Objects of the ``dining`` theme: meats."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import smooth
from ...kit.parts import hull_of
from ...kit.primitives import crockery, limb
from ...kit.shapes import Shape, category, serve, settle, shape, vary
from ...kit.solids import block, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...kit.surfaces import RGB, Look, speck, tint_color

BONE: RGB = (240, 230, 208)


def _roast(look: Look) -> surfaces.Tile:
    return skin(look, look.color("bronze", "copper", "amber"), (128, 66, 28), 0.9)


@category("roast_chicken", size=(0.321, 0.238, 0.144), mass=1.6, material="ceramic",
          aliases=("turkey", "roast turkey", "whole chicken", "roasted chicken", "roasted turkey",
          "thanksgiving turkey", "chicken", "roast duck", "roast goose", "rotisserie chicken",
          "cooked chicken"), themes=("dining",), roles=("edible", "big"),
          colors=("amber",))  # fmt: skip
def roast_chicken(look: Look) -> Shape:
    """A whole roast chicken, ringed by lettuce on an oval platter, with its legs on the right."""
    k = look.between(0.9, 1.1)
    body = ellipsoid(0.19, 0.15, 0.12, 26, 16).move(z=0.075)
    breast = [ellipsoid(0.14, 0.085, 0.09, 18, 10).move(-0.02, s * 0.028, 0.1) for s in (-1, 1)]
    legs, ends = [], []
    for s in (-1, 1):
        legs.append(limb([(-0.01, s * 0.06, 0.075), (0.035, s * 0.068, 0.085),
                          (0.085, s * 0.05, 0.075), (0.118, s * 0.035, 0.07)],
                         [0.026, 0.032, 0.02, 0.0085], 12))  # fmt: skip
        legs.append(limb([(-0.05, s * 0.065, 0.07), (-0.02, s * 0.085, 0.055),
                          (-0.055, s * 0.088, 0.045)], [0.014, 0.014, 0.008], 10))  # fmt: skip
        ends.append(ellipsoid(0.02, 0.016, 0.016, 10, 6).move(0.125, s * 0.033, 0.069))
    plate = crockery(0.15, 0.024, deep=False).scale(1.08, 0.8, 1)
    greens = [ellipsoid(0.055, 0.035, 0.014, 10, 6).turn(2, 1.1 * n).move(
        0.12 * np.cos(n * 0.785), 0.085 * np.sin(n * 0.785), 0.02) for n in range(8)]  # fmt: skip
    bird = join([body, *breast, *legs])
    meat = _roast(look)
    dish = surfaces.plain(look.own_color("white", "cream", "sky"))
    leaf = surfaces.speckles(look.rng, (110, 156, 66), 14)
    return serve(look, plate, dish, [(bird, meat), (join(ends), surfaces.plain(BONE)),
                                      (join(greens), leaf)]).scale(k)  # fmt: skip


@category("ham", size=(0.216, 0.12, 0.114), mass=1.5, material="food",
          aliases=("ham joint", "gammon", "baked ham", "leg of ham", "roast ham"),
          themes=("dining",), roles=("edible", "big"), state="lying flat")  # fmt: skip
def ham(look: Look) -> Shape:
    """A ham with its pink cut face on the left, a scored rind and a bone."""
    long, r = look.between(0.16, 0.19), look.between(0.055, 0.065)
    joint = lathe([(0, 0), (0.93 * r, 0), (r, 0.1 * long), (0.97 * r, 0.42 * long),
                   (0.6 * r, 0.78 * long), (0.28 * r, 0.97 * long), (0, long)], 28)  # fmt: skip
    rows, columns = np.mgrid[0:128, 0:128]
    net = (((rows + columns) % 21) < 2) | (((rows - columns) % 21) < 2)
    color = look.color("copper", "terracotta", "bronze")
    rind = np.where(net[..., None], np.array(tint_color(color, 0.55)), np.array(color))
    cut = cylinder(0.88 * r, 0.003, 28).move(z=-0.001)
    face = surfaces.noise(look.rng, 96, 96, (4, 4), 2)[..., None] * 16
    pink = np.clip(np.array((232, 138, 132)) + face, 0, 255).astype(np.uint8)
    bone = cylinder(0.15 * r, long + 0.042, 14, bevel=0.003).move(z=-0.004)
    pieces = [(joint, rind.astype(np.uint8)), (cut, pink), (bone, surfaces.plain(BONE))]
    laid = [(s.turn(1, np.pi / 2 - 0.1).move(x=-0.5 * long), tile) for s, tile in pieces]
    return settle(laid, 0.08)


@category("chicken_leg", size=(0.146, 0.0595, 0.0536), mass=0.12, material="food",
          aliases=("chicken drumstick", "turkey leg", "fried chicken", "chicken thigh",
          "chicken wing"), themes=("dining",), roles=("edible",), colors=("amber",),
          state="lying flat")  # fmt: skip
def chicken_leg(look: Look) -> Shape:
    """A roast drumstick lying flat with its bone on the right."""
    k = look.between(0.9, 1.12)
    meat = limb([(-0.058, 0, 0), (-0.05, 0, 0), (-0.03, 0, 0), (0, 0, 0), (0.03, 0, -0.004),
                 (0.045, 0, -0.007)], [0.006, 0.02, 0.029, 0.024, 0.012, 0.009], 16)  # fmt: skip
    bone = limb([(0.03, 0, -0.005), (0.06, 0, -0.011), (0.075, 0, -0.0125)],
                [0.0055, 0.005, 0.0065], 10)  # fmt: skip
    knobs = [ellipsoid(0.013, 0.012, 0.012, 10, 8).move(0.078, s * 0.0055, -0.013)
             for s in (-1, 1)]  # fmt: skip
    tip = join([bone, *knobs])
    return settle([(meat, _roast(look)), (tip, surfaces.plain(BONE))], 0.1).scale(k)


@category("meatball", size=(0.0348, 0.0351, 0.0288), mass=0.03, material="food",
          aliases=("swedish meatball",), themes=("dining",), roles=("edible", "round"),
          colors=("brown",))  # fmt: skip
def meatball(look: Look) -> Shape:
    """A browned ball of minced meat."""
    d = look.between(0.03, 0.04)
    phase = look.rng.uniform(0, 6, 2)

    def bumps(p: np.ndarray) -> np.ndarray:
        wave = 0.035 * np.sin(p @ np.array([300, 220, 180]) + phase[0])
        return p * (1 + wave + 0.03 * np.sin(p @ np.array([-260, 320, 240]) + phase[1]))[:, None]

    color = look.color("brown", "brown", "copper")
    meat = surfaces.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.5), 0.2)
    return settle([(ellipsoid(d, d, 0.92 * d, 24, 14).bend(bumps), meat)], 0.12)


@category("ribs", size=(0.14, 0.119, 0.0248), mass=0.45, material="food", aliases=("pork ribs",
          "spare ribs", "rack of ribs", "barbecue ribs", "bbq ribs", "slab of ribs", "pork rib"),
          themes=("dining",), roles=("edible",), state="lying flat")  # fmt: skip
def ribs(look: Look) -> Shape:
    """A slab of ribs lying flat with bone ends along one side."""
    n, pitch = 6, look.between(0.02, 0.024)
    ribs, bones = [], []
    for k in range(n):
        x = (k - (n - 1) / 2) * pitch
        ribs.append(limb([(x - 0.004, -0.05, 0.008), (x, 0, 0.013), (x + 0.004, 0.05, 0.008)],
                         [0.011, 0.0135, 0.011], 10))  # fmt: skip
        bones.append(limb([(x - 0.004, -0.045, 0.008), (x - 0.008, -0.066, 0.0065)],
                          [0.0048, 0.0056], 8))  # fmt: skip
    glaze = speck(_roast(look), look.rng, (88, 40, 22), 60, 4)
    return settle([(join(ribs), glaze), (join(bones), surfaces.plain(BONE))], 0.12)


@category("chicken_nugget", size=(0.046, 0.0341, 0.0168), mass=0.018, material="food",
          aliases=("nugget", "chicken bite"), themes=("dining",), roles=("edible",),
          colors=("amber",), state="lying flat")  # fmt: skip
def chicken_nugget(look: Look) -> Shape:
    """A breaded nugget, lying flat."""
    ring = smooth(np.array([(0.9, 0), (0.75, 0.62), (0, 0.72), (-0.8, 0.6), (-1, -0.1),
                            (-0.55, -0.66), (0.3, -0.62), (0.9, 0)]), 4)[:-1]  # fmt: skip
    k = look.between(0.022, 0.027)
    ring = ring * [k, k * look.between(0.85, 1.1)]
    body = prism(ring, 0, look.between(0.015, 0.019), 0.005)
    crumb = surfaces.spots(look.rng, look.color("amber", "tan", "bronze"), (166, 96, 36), 0.3)
    return shape([(body, crumb)], [hull_of(body)])


@category("kebab", size=(0.223, 0.0321, 0.0282), mass=0.12, material="food", aliases=("shish kebab",
          "kabob", "meat skewer", "yakitori", "grilled skewer", "shashlik", "chicken skewer"),
          themes=("dining",), roles=("edible",), state="lying flat")  # fmt: skip
@vary()
def kebab(look: Look) -> Shape:
    """A kebab: a skewer of grilled meat, pepper and onion, lying flat."""
    long = look.between(0.21, 0.25)
    stick = tube([(-0.5 * long, 0, 0), (0.5 * long, 0, 0)], [0.0007, 0.0017], 6)
    tones: list[RGB] = [(126, 72, 40), (200, 46, 38), (126, 72, 40), (236, 226, 196),
                        (126, 72, 40), (88, 150, 62), (126, 72, 40)]  # fmt: skip
    pieces = [(stick, surfaces.wood(look.rng, (224, 190, 136)))]
    for n, tone in enumerate(tones):
        meat = tone == tones[0]
        size = 0.028 if meat else 0.026
        cube = block(0.02 if meat else 0.009, size, size, 0.006, 0.004)
        cube = cube.move(z=-size / 2).turn(0, 0.25 * (-1) ** n)
        pieces.append(
            (
                cube.move(x=-0.36 * long + 0.0195 * n),
                surfaces.spots(look.rng, tone, tint_color(tone, 0.55), 0.15),
            )
        )
    return settle(pieces, 0.12, hulls=[list(range(1, 8))])


@category("steak", size=(0.151, 0.0943, 0.0214), mass=0.25, material="food", aliases=("beef steak",
          "meat", "beef", "piece of meat", "beefsteak", "raw steak", "grilled steak", "meat slice"),
          themes=("dining", "food"), roles=("flat", "edible"), colors=("brown",),
          state="lying flat")  # fmt: skip
def steak(look: Look) -> Shape:
    """A steak lying flat: grilled with dark stripes, or raw with a rim of fat."""
    k = look.between(0.9, 1.1)
    raw = look.chance(0.4)
    color = look.color("red", "crimson") if raw else look.color("brown", "maroon", "bronze")
    t = np.linspace(0, 2 * np.pi, 36, endpoint=False)
    away = (
        1
        + 0.13 * np.cos(2 * t + 0.6)
        + 0.07 * np.sin(3 * t)
        - 0.12 * np.exp(-((t - 2.1) ** 2) / 0.1)
    )
    outline = np.column_stack([0.066 * k * away * np.cos(t), 0.047 * k * away * np.sin(t)])
    meat = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.25).copy()
    if raw:
        meat = surfaces.marble(look.rng, color, (238, 206, 196))
    else:
        for row in range(10, 128, 24):
            for j in range(128):
                meat[(row + j // 3) % 128 : (row + j // 3) % 128 + 5, j] = (46, 28, 22)
    h = look.between(0.018, 0.026)
    rings = [(0.93, 0.0), (1.0, 0.3 * h), (0.99, 0.7 * h), (0.9, h)]
    body = loft(
        np.stack([np.column_stack([outline * s, np.full(36, z)]) for s, z in rings]), outline
    )
    fat = tube(np.column_stack([outline[3:16] * 1.0, np.full(13, 0.5 * h)]), 0.42 * h, 8)
    tone = (242, 226, 206) if raw else (206, 160, 100)
    return shape([(body, meat), (fat, surfaces.plain(tone))], [hull_of(body)])
