"""Forks, spoons and knives, lying flat."""

from __future__ import annotations

import itertools

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, cylinder, join, loft, prism, refine
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile


def _bend(solid: Solid, length: float, dip: float) -> Solid:
    """Return flat cutlery with its neck raised, lying on its two ends."""
    return solid.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + dip * np.clip(np.cos(np.pi * p[:, 0] / length), 0, 1)]
        )
    )


def _slice(solid: Solid, edges: list[float]) -> list[ConvexPart]:
    x = solid.vertices[:, 0]
    return [
        hull_part(solid.vertices[(x >= a - 1e-6) & (x <= b + 1e-6)])
        for a, b in itertools.pairwise(edges)
    ]


def _mirror(half: list[tuple[float, float]]) -> np.ndarray:
    """Return a closed outline from its lower half, listed from left to right."""
    lower = np.array(half, float)
    upper = lower[::-1] * [1, -1]
    return np.concatenate([lower, upper[np.abs(upper[:, 1]) > 1e-9]])


def _metal(look: Look) -> Tile:
    """Return a flat of bright, brushed, golden, coppery or black metal, a little scratched."""
    color = look.color(*["silver"] * 5, "gray", "gray", "gold", "black", "copper", spread=6)
    tile = look.surface(color, "metal")
    if look.material:
        return tile
    worn = textures.scratches(
        look.rng, color, tint_color(color, 1.25), int(look.rng.integers(4, 26))
    )
    return look.pick([tile, worn])


def _grip_paint(look: Look) -> tuple[str, Tile]:
    """Return how a handle is made, "metal" or "sleeve", and the sleeve's tile."""
    color = look.own_color("black", "white", "brown", "red", "teal", "sky", "cream")
    sleeve = look.pick([textures.wood(look.rng, (150, 98, 60)), textures.plain(color),
                        textures.speckles(look.rng, color, 5, 32)])  # fmt: skip
    return ("sleeve" if look.chance(0.3) and not look.material else "metal"), sleeve


def _sleeve(long: float, start: float, wide: float) -> Solid:
    """Return the flattened sleeve of a handle from x ``start`` to the right end."""
    x = 0.5 * long - start
    return block(x, 2 * wide, 0.0052, wide, 0.0012).move(x=start + x / 2)


def fork(look: Look) -> Shape:
    """A fork lying flat, three or four tines to the left."""
    long, wide = look.between(0.175, 0.21), look.between(0.85, 1.15)
    steel, kind, sleeve = _metal(look), *_grip_paint(look)
    end = look.between(0.005, 0.0105)
    grip = [
        (-0.046, 0.0), (-0.044, -0.007 * wide), (-0.03, -0.0112 * wide), (-0.02, -0.0035),
        (0.02, -0.0028), (0.5 * long - 0.012, -end), (0.5 * long - 0.003, -0.8 * end),
        (0.5 * long, -0.4 * end),
    ]  # fmt: skip
    body = prism(_mirror([(x, y) for x, y in grip if y < 0 or x < -0.045]), 0, 0.0024)
    count = look.pick([3, 4, 4])
    pitch = 0.0174 * wide / (count - 1)
    half = 0.0019 * (1.3 if count == 3 else 1.0)
    tine = prism(np.array([(-0.5 * long, -0.0009), (-0.03, -half), (-0.03, half),
                           (-0.5 * long, 0.0009)]), 0, 0.0022)  # fmt: skip
    tines = [tine.move(y=(k - (count - 1) / 2) * pitch) for k in range(count)]
    fine = _bend(refine(join([body, *tines])), long, 0.008)
    pieces = [(fine, steel)]
    if kind == "sleeve":
        pieces.append((_bend(refine(_sleeve(long, 0.018, max(end, 0.006))), long, 0.008), sleeve))
    return shape(pieces, _slice(fine, [-0.5 * long, -0.04, 0.0, 0.5 * long]))


def spoon(look: Look) -> Shape:
    """A spoon lying flat, its hollow bowl to the left: round, oval or pointed."""
    long = look.between(0.155, 0.2)
    steel, kind, sleeve = _metal(look), *_grip_paint(look)
    reach, wide = look.between(0.026, 0.034), look.between(0.0175, 0.023)
    end, pointed = look.between(0.005, 0.0095), look.between(-0.15, 0.25)
    middle = -0.5 * long + reach
    ring = ellipse(2, 2, 24)
    ring = np.column_stack([ring[:, 0], ring[:, 1] * (1 + pointed * ring[:, 0])]) * [reach, wide]
    levels = [(0.12, 0.0003), (0.62, 0.0014), (1.0, 0.0072), (0.9, 0.0072), (0.55, 0.003),
              (0.12, 0.0018)]  # fmt: skip
    head = loft(
        np.stack([np.column_stack([ring * k + [middle, 0], np.full(24, z)]) for k, z in levels]),
        ring, profile=np.array([(k * reach, z) for k, z in levels]),
    )  # fmt: skip
    neck = middle + 0.93 * reach
    grip = prism(
        _mirror([(neck, -0.0055), (neck + 0.012, -0.0036), (0.0, -0.0026),
                   (0.5 * long - 0.02, -end), (0.5 * long - 0.004, -0.8 * end),
                   (0.5 * long, -0.35 * end)]), 0, 0.0022,
    )  # fmt: skip

    def lift_neck(solid: Solid) -> Solid:
        def raise_neck(p: np.ndarray) -> np.ndarray:
            t = np.clip((p[:, 0] - neck) / (0.5 * long - neck), 0, 1)
            rise = 0.0055 * np.cos(np.pi / 2 * t) ** 0.8 + 0.004 * np.sin(np.pi * t)
            return np.column_stack([p[:, :2], p[:, 2] + rise])

        return refine(refine(solid)).bend(raise_neck)

    lift, hollow = lift_neck(grip), textures.plain(tuple(0.62 * c for c in steel.mean((0, 1))))
    pieces = [(head, textures.stack((steel, 57), (hollow, 43))),
              (lift, steel)]  # fmt: skip
    if kind == "sleeve":
        pieces.append((lift_neck(_sleeve(long, 0.03, max(end, 0.006))), sleeve))
    x = lift.vertices[:, 0]
    return shape(
        pieces,
        [hull_of(head), hull_part(lift.vertices[x <= 0.03]), hull_part(lift.vertices[x >= 0.028])],
    )


def knife(look: Look) -> Shape:
    """A table knife lying flat, or a kitchen knife: chef's, santoku, paring, serrated, steak."""
    kind = look.pick(["table", "table", "chef", "santoku", "bread", "steak"])
    long, wide, cut = {
        "table": (look.between(0.2, 0.23), 0.019, look.between(0.0, 0.03)),
        "chef": (look.between(0.28, 0.31), 0.04, 0.045),
        "santoku": (look.between(0.26, 0.29), 0.042, 0.035),
        "bread": (look.between(0.28, 0.31), 0.028, 0.04),
        "steak": (look.between(0.2, 0.23), 0.02, 0.005),
    }[kind]
    steel = textures.brushed_metal(
        look.rng, look.pick([(196, 199, 204), (176, 179, 184), (90, 92, 98)])
    )
    if look.chance(0.3):
        steel = textures.spots(look.rng, (186, 189, 194), (120, 116, 110), 0.03)
    tip = -0.5 * long
    edge = {
        "table": [(0.0, 0.3), (0.06, -0.35), (0.2, -0.5)],
        "chef": [(0.0, 0.42), (0.12, 0.0), (0.3, -0.35), (0.5, -0.5)],
        "santoku": [(0.0, -0.3), (0.03, -0.5), (0.5, -0.5)],
        "bread": [(0.0, -0.1), (0.04, -0.45), (0.3, -0.5)],
        "steak": [(0.0, 0.45), (0.1, -0.1), (0.3, -0.5)],
    }[kind]
    back = {"santoku": [(0.24, 0.5), (0.08, 0.25)], "table": [(0.14, 0.5)]}.get(kind, [(0.1, 0.5)])
    outline = [(tip + u * long, v * wide) for u, v in edge]
    outline += [(cut, -0.5 * wide), (cut, 0.5 * wide)]
    outline += [(tip + u * long, v * wide) for u, v in back]
    blade = prism(np.array(outline), 0.0, 0.002)
    metal = kind == "table" and look.chance(0.7)
    color = look.color("silver", "gray") if metal else look.color(
        "black", "wooden", "red", "charcoal", "brown", "white", "teal", "yellow")  # fmt: skip
    thick = 0.0075 if kind == "table" else 0.016
    grip = block(0.5 * long - cut, 0.8 * min(wide, 0.028), thick, 0.006, 0.002)
    grip = grip.move(x=cut + (0.5 * long - cut) / 2)
    tile = look.surface(color, "metal" if metal else look.pick(["plastic", "wood"]))
    pieces = [(blade, steel), (grip, tile)]
    if not metal and kind != "table":
        rivet = cylinder(0.0028, thick + 0.0004, 10)
        way = 0.5 * long - cut
        pieces += [(rivet.move(x=cut + u * way), textures.plain((196, 190, 170)))
                   for u in (0.22, 0.5, 0.78)]  # fmt: skip
    return shape(pieces, [hull_of(blade), hull_of(grip)])


CATEGORIES = (
    Category(
        "fork",
        fork,
        (0.195, 0.023, 0.0104),
        0.036,
        ("salad fork",),
        ("dining", "kitchen"),
        ("flat",),
        ("silver", "gold"),
        state="lying flat",
    ),
    Category(
        "spoon",
        spoon,
        (0.18, 0.04, 0.0115),
        0.04,
        (),
        ("dining", "kitchen", "coffee"),
        ("flat",),
        ("silver", "gold"),
        state="lying flat",
    ),
    Category(
        "knife",
        knife,
        (0.25, 0.028, 0.012),
        0.09,
        (
            "table knife",
            "letter opener",
        ),
        ("dining", "kitchen"),
        ("flat",),
        ("silver", "black"),
        state="lying flat",
    ),
)
