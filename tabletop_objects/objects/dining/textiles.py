"""Objects of the ``dining`` theme: textiles."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import ellipse, rectangle
from ...kit.parts import box_part, hull_of
from ...kit.primitives import ball, pad, rod, standing, standing_plate
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import block, box, cylinder, join, prism
from ...kit.surfaces import RGB, Look, Tile, plain, tint_color
from ..living.textiles import flat
from ..toys.vehicles import sheet

WEAVES = ("woven", "braided", "bamboo", "checked", "bordered", "leafy", "striped", "plain")


@category("placemat", size=(0.42, 0.325, 0.003), mass=0.12, material="fabric",
          aliases=("place mat", "table mat", "dinner mat", "dining mat"),
          themes=("dining", "breakfast"), roles=("flat", "support", "big"),
          colors=("beige", "navy"), state="lying flat", common=True)  # fmt: skip
def placemat(look: Look) -> Shape:
    """A woven, braided, bamboo, checked, bordered or printed placemat, usually rectangular."""
    kind = look.pick(WEAVES)
    x, y = look.between(0.4, 0.46), look.between(0.29, 0.335)
    high = look.between(0.002, 0.004)
    color = look.color("tan", "beige", "navy", "gray", "sage", "red", "teal", "mustard", "white")
    other = look.own_color("white", "cream", "terracotta", "navy", "charcoal", "olive")
    if np.abs(np.array(other) - color).max() < 60:
        other = tint_color(color, 0.55 if sum(color) > 330 else 1.5)
    outline = look.pick([rectangle(x, y, 0.006), rectangle(x, y, 0.03), ellipse(x, y, 40)])
    if kind == "braided":
        outline = look.pick([ellipse(0.37, 0.37, 40), ellipse(x, y, 40)])
    elif kind == "bamboo":
        outline = rectangle(x, y, 0.004)
    mat = prism(outline, 0, high, 0.0008)
    return shape([(mat, _weave(look, kind, color, other))], [hull_of(mat)])


def _weave(look: Look, kind: str, color: RGB, other: RGB) -> Tile:
    side = 192
    v, u = (np.mgrid[0:side, 0:side] + 0.5) / side
    if kind == "woven":
        return surfaces.basketwork(look.rng, color, int(look.rng.integers(16, 30)))
    if kind == "braided":
        away, around = np.hypot(u - 0.5, v - 0.5), np.arctan2(v - 0.5, u - 0.5)
        turns = int(look.rng.integers(9, 16))
        shade = 0.72 + 0.28 * np.abs(np.sin(2 * np.pi * turns * away))
        shade = shade * (0.9 + 0.1 * np.sin(90 * around + 40 * away))
        ring = (np.floor(2 * turns * away) % look.pick([3, 5, 99]) == 2)[..., None]
        return np.clip(np.where(ring, other, color) * shade[..., None], 0, 255).astype(np.uint8)
    if kind == "bamboo":
        slats = int(look.rng.integers(40, 64))
        tone = look.rng.uniform(0.86, 1.06, slats)[np.minimum((v * slats).astype(int), slats - 1)]
        image = np.array(color) * (tone * (1 - 0.25 * ((v * slats) % 1 > 0.8)))[..., None]
        thread = np.abs((u * 6) % 1 - 0.5) < 0.018
        image[thread] = np.array(other)
        return np.clip(image, 0, 255).astype(np.uint8)
    if kind == "checked":
        count = int(look.rng.integers(5, 10))
        bands = (np.floor(u * 2 * count) % 2 + np.floor(v * 1.4 * count) % 2)[..., None] / 2
        image = np.array(other) * (1 - bands) + np.array(color) * bands
        return np.clip(image + look.rng.uniform(-5, 5, (side, side, 1)), 0, 255).astype(np.uint8)
    if kind == "striped":
        tones = [color] * 3 + [other] + [color] + [other]
        tile = surfaces.stripes(tones, int(look.rng.integers(1, 5)), upright=look.chance(0.5),
                                side=side)  # fmt: skip
        return np.clip(tile + look.rng.uniform(-6, 6, (side, side, 1)), 0, 255).astype(np.uint8)
    image = surfaces.fit(surfaces.fabric(look.rng, color), side, side).copy()
    if kind == "bordered":
        edge = np.maximum(np.abs(u - 0.5), np.abs(v - 0.5))
        for low, high in ((0.4, 0.43), (0.45, 0.46)):
            image[(edge > low) & (edge < high)] = np.array(other, np.uint8)
    elif kind == "leafy":
        for _ in range(34):
            x, y, turn = look.between(0, 1), look.between(0, 1), look.between(0, 6.28)
            c, s = np.cos(turn), np.sin(turn)
            lobe = ((0, 0), (0.045, 0.022), (0.09, 0), (0.045, -0.022))
            leaf = [(x + a * c - b * s, y + a * s + b * c) for a, b in lobe]
            prints.polygon(image, leaf, tint_color(other, look.between(0.85, 1.15)))
    return image


@category("napkins", size=(0.163, 0.163, 0.021), mass=0.08, material="paper",
          aliases=("napkin", "napkin stack", "stack of napkins", "folded napkin", "tissue"),
          themes=("dining", "kitchen"), roles=("support", "flat"), colors=("white", "red"),
          state="lying flat", common=True)  # fmt: skip
def napkins(look: Look) -> Shape:
    """A stack of folded napkins."""
    side, h = look.between(0.15, 0.17), look.between(0.012, 0.03)
    color = look.color("white", "red", "cream", "sage", "navy", "pink", "teal", "mustard", "gray")
    kind, other = int(look.rng.integers(4)), look.own_color("white", "red", "navy", "mustard")
    cloth = surfaces.fabric(look.rng, color, other if kind == 1 else None)
    if kind >= 2:
        cloth = glaze_tile(look, color)
    layers = 4
    pieces = [
        (
            box(side, side, h / layers - 0.0006)
            .turn(2, look.between(-0.03, 0.03))
            .move(z=k * h / layers),
            cloth,
        )
        for k in range(layers)
    ]
    return shape(pieces, [box_part(side, side, h - 0.0006)])


@category("napkin_swan", size=(0.204, 0.105, 0.125), mass=0.04, material="fabric", assembled=True,
          aliases=("folded napkin swan", "towel swan", "swan napkin", "swan"), themes=("dining",),
          colors=("white",))  # fmt: skip
def napkin_swan(look: Look) -> Shape:
    """A napkin folded into a swan."""
    color = look.color("white", "cream", "pink", "sky", "mint")
    k = look.between(0.85, 1.15)
    body = standing((0.045, 0), (0.052, 0.008), (0.046, 0.022), (0.016, 0.032), sides=20).scale(
        1.3, 1, 1
    )
    neck = rod([(0.045, 0, 0.018), (0.07, 0, 0.05), (0.05, 0, 0.095), (0.062, 0, 0.115),
                (0.08, 0, 0.108)], [0.016, 0.011, 0.009, 0.009, 0.005], 10)  # fmt: skip
    beak = cylinder(0.005, 0.016, 8, top=0.0008).turn(1, 1.9).move(0.079, 0, 0.109)
    wings = [sheet((0.03, s * 0.03, 0.02), (-0.05, s * 0.046, 0.02), (-0.088, s * 0.034, 0.075),
                    (-0.03, s * 0.046, 0.062), thick=0.004) for s in (1, -1)]  # fmt: skip
    tail = [standing_plate([(-0.09 - 0.01 * n, 0.02), (-0.03, 0.012), (-0.05, 0.05)], 0.005).turn(
        2, 0.25 * (n - 1)) for n in range(3)]  # fmt: skip
    cloth = surfaces.fabric(look.rng, color)
    eyes = [ball(0.004, 0.004, 0.004, (0.066, s * 0.008, 0.116), 6) for s in (-1, 1)]
    return put_down([(join([body, neck, *wings, *tail]), cloth), (beak, plain((230, 140, 50))),
                     (join(eyes), plain((40, 36, 36)))], body, neck, *wings, factor=k)  # fmt: skip


@category("table_runner", size=(0.58, 0.17, 0.0025), mass=0.12, material="fabric",
          aliases=("runner", "linen runner", "cloth runner"), themes=("dining",),
          roles=("flat", "support", "big"), colors=("beige", "red"),
          state="lying flat")  # fmt: skip
def table_runner(look: Look) -> Shape:
    """A long, narrow table runner with bands at its ends."""
    x, y = look.between(0.5, 0.62), look.between(0.15, 0.19)
    color = look.color("white", "beige", "red", "sage", "navy", "gray", "mustard")
    image = surfaces.fit(surfaces.fabric(look.rng, color, threads=40), 64, 192).copy()
    other = tint_color(color, 0.6) if sum(color) > 300 else (240, 234, 220)
    for u in (0.04, 0.08, 0.88, 0.92):
        prints.fill(image, u, 0, 0.022, 1, other)
    return flat(x, y, 0.0025, image, 0.012, color)


@category("tablecloth", size=(0.27, 0.2, 0.032), mass=0.35, material="fabric",
          aliases=("table cloth", "folded tablecloth", "tablecover"), themes=("dining",),
          roles=("support", "flat"), colors=("red", "white"), state="lying folded")  # fmt: skip
def tablecloth(look: Look) -> Shape:
    """A folded tablecloth: checked layers with a rounded fold in front."""
    x, y, h = look.between(0.24, 0.3), look.between(0.18, 0.22), look.between(0.025, 0.04)
    color = look.color("red", "blue", "white", "green", "yellow", "beige", "gray")
    cloth = surfaces.fabric(look.rng, color, (246, 244, 238), 26)
    count = look.pick([3, 4])
    t = h / count
    layers = [pad(x * (1 - 0.012 * n), y * (1 - 0.012 * n), t, 0.008, soft=0.45).move(
        0.002 * (n % 2), 0, n * t) for n in range(count)]  # fmt: skip
    return put_down([(join(layers), cloth)], join(layers))


@category("cloth", size=(0.45, 0.33, 0.0055), mass=0.5, material="fabric",
          aliases=("linen cloth", "velvet cloth", "spread cloth", "cotton cloth", "white cloth"),
          themes=("dining", "living"), roles=("flat", "support", "big"),
          colors=("white", "gray", "red"), state="lying flat")  # fmt: skip
def cloth(look: Look) -> Shape:
    """A plain cloth, folded once and lying flat."""
    x, y, z = look.between(0.4, 0.5), look.between(0.3, 0.36), look.between(0.005, 0.006)
    color = look.color("white", "gray", "beige", "navy", "red", "sage", "cream", "black")
    sheet = block(x, y, z, 0.008, 0.001)
    return shape([(sheet, look.surface(color, "fabric"))], [hull_of(sheet)])
