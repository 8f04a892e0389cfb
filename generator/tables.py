"""Tables with a top outline, legs and a material; the top is exactly flat at canonical z = +0.5."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from tabletop_objects.kit import surfaces
from tabletop_objects.kit.outlines import ellipse, rectangle, rounded_polygon
from tabletop_objects.kit.parts import box_part, cylinder_part, hull_of
from tabletop_objects.kit.shapes import Shape, mesh_of, shape
from tabletop_objects.kit.solids import Solid, box, cylinder, loft, prism, tube
from tabletop_objects.kit.surfaces import METALS, RGB, WOODS, Tile, rgb, tint_color
from tabletop_objects.values import parts_to_unit_box, to_unit_box

from .errors import InputError, choices
from .scene import TABLE, ConvexPart, Model, Physics, PlannedTable

OUTLINES = ("rectangle", "square", "round", "oval", "triangle", "slatted")
"""The shapes of a tabletop."""


def outline_of(plan: PlannedTable) -> Float[np.ndarray, "k 2"]:
    """Return the tabletop's convex counter-clockwise outline of at most 16 points, in metres."""
    x, y, _ = plan.size
    if plan.outline in ("round", "oval"):
        circle = ellipse(2, 2, 16)
        if plan.outline == "oval":  # a superellipse, which is fuller than an ellipse
            circle = np.sign(circle) * np.abs(circle) ** 0.8
        return circle * [x / 2, y / 2]
    if plan.outline == "triangle":
        corners = np.array([[-0.5, -0.5], [0.5, -0.5], [0.0, 0.5]]) * [x, y]
        points = rounded_polygon(corners, 0.1 * min(x, y), 4)
        low, high = points.min(0), points.max(0)
        return (points - (low + high) / 2) / (high - low) * [x, y]
    radius = 0.0 if plan.outline == "slatted" else 0.02 * min(x, y)
    return rectangle(x, y, radius, 2)


def build_table(plan: PlannedTable, seed: int) -> Model:
    """Build the canonical model, a top and legs, of a planned table of ``plan.size`` metres.

    Raises:
        InputError: the outline or the legs are unknown, or a side is outside 0.2 to 4 m.
    """
    if not all(0.2 <= side <= 4.0 for side in plan.size):
        raise InputError(f"Each side of a table must measure 0.2 to 4 m, got {plan.size}.")
    if plan.legs not in LEGS:
        raise InputError(f"Unknown table legs {plan.legs!r}." + choices(plan.legs, LEGS))
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 7])
    made = _table(plan, rng)
    unit, center, extent = to_unit_box(mesh_of(made))
    return Model(
        TABLE,
        TABLE,
        unit,
        np.array(plan.size),
        Physics(600.0, _friction(plan.material)),
        parts_to_unit_box(made.parts, center, extent),
        category=TABLE,
    )


def _friction(material: str) -> float:
    """Return a tabletop's sliding friction, which is lower for polished stone, glass and metal."""
    smooth = {"glass", "marble", "stone", *METALS}
    return 0.45 if smooth & set(material.lower().replace("-", " ").split()) else 0.5


def _table(plan: PlannedTable, rng: np.random.Generator) -> Shape:
    """Return the shape of a table in metres, standing on z = 0."""
    top_tile, leg_tile = _tiles(plan, rng)
    height = plan.size[2]
    thick = 0.02 if plan.material.startswith("glass") else 0.034
    top, top_part = _top(plan, height - thick, height)
    solids, parts = LEGS[plan.legs](_feet(plan), height - thick, min(plan.size[:2]))
    pieces = [(solid, top_tile) for solid in top]
    pieces += [(solid, leg_tile) for solid in solids]
    if plan.outline in ("rectangle", "square", "slatted") and plan.legs not in ("pedestal",):
        pieces += [(solid, leg_tile) for solid in _apron(plan, height - thick)]
    return shape(pieces, [top_part, *parts])


def _top(plan: PlannedTable, low: float, high: float) -> tuple[list[Solid], ConvexPart]:
    """Return the solids and the one collision part of the tabletop, from z ``low`` to ``high``."""
    x, y, _ = plan.size
    outline = outline_of(plan)
    if plan.outline == "slatted":
        count = max(4, round(y / 0.1))
        pitch = (y + 0.007) / count
        boards = [
            prism(rectangle(x, pitch - 0.007), low, high)
            .paint((0, k / count), (1, (k + 1) / count))
            .move(y=-y / 2 + (pitch - 0.007) / 2 + k * pitch)
            for k in range(count)
        ]
        return boards, box_part(x, y, high - low, (0, 0, low))
    if plan.outline in ("rectangle", "square"):
        return [prism(outline, low, high)], box_part(x, y, high - low, (0, 0, low))
    fine = outline
    if plan.outline in ("round", "oval"):
        fine = ellipse(2, 2, 64)
        if plan.outline == "oval":
            fine = np.sign(fine) * np.abs(fine) ** 0.8
        fine = fine * [x / 2, y / 2]
    solid = prism(fine, low, high)
    return [solid], hull_of(prism(outline, low, high))


def _apron(plan: PlannedTable, top: float) -> list[Solid]:
    """Return the boards under the rim of a rectangular tabletop."""
    x, y, _ = plan.size
    inset, tall, thick = 0.07, 0.06, 0.018
    long, deep = x - 2 * inset, y - 2 * inset
    return [box(long, thick, tall).move(y=side * deep / 2, z=top - tall) for side in (-1, 1)] + [
        box(thick, deep, tall).move(x=side * long / 2, z=top - tall) for side in (-1, 1)
    ]


def _feet(plan: PlannedTable) -> Float[np.ndarray, "k 2"]:
    """Return the points near the tabletop's corners (three for a triangle) where legs join it."""
    x, y, _ = plan.size
    if plan.outline == "triangle":
        return np.array([[-0.36, -0.39], [0.36, -0.39], [0.0, 0.26]]) * [x, y]
    if plan.outline in ("round", "oval"):
        return np.array([[-0.3, -0.3], [0.3, -0.3], [0.3, 0.3], [-0.3, 0.3]]) * [x, y]
    at = np.array([x, y]) / 2 - 0.07
    return np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * at


# ------------------------------------------------------------------------------------- legs

Legs = tuple[list[Solid], list[ConvexPart]]


def _post(foot: np.ndarray, top: float, low: float, high: float, lean: float = 0.0) -> Solid:
    """Return a square post, ``low`` wide at the floor and ``high`` wide at the top, in metres."""
    outward = foot / np.hypot(*foot) * lean
    square = rectangle(1, 1)
    rings = np.stack(
        [
            np.column_stack([square * side + foot + shift, np.full(4, z)])
            for side, shift, z in [(low, outward, 0.0), (high, 0 * outward, top)]
        ]
    )
    return loft(rings, square)


def _straight(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    side = float(np.clip(0.075 * width, 0.03, 0.06))
    return (
        [box(side, side, top).move(*foot) for foot in feet],
        [box_part(side, side, top, (*foot, 0)) for foot in feet],
    )


def _tapered_legs(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    side = float(np.clip(0.08 * width, 0.03, 0.065))
    posts = [_post(foot, top, 0.5 * side, side) for foot in feet]
    return posts, [hull_of(post) for post in posts]


def _splayed_legs(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    side = float(np.clip(0.07 * width, 0.03, 0.055))
    posts = [_post(foot * 0.82, top, 0.55 * side, side, 0.09 * width) for foot in feet]
    return posts, [hull_of(post) for post in posts]


def _trestle(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    if len(feet) == 3:  # a triangular top has no two parallel ends to support
        return _straight(feet, top, width)
    reach = np.abs(feet).max(0)
    side = 0.045
    pieces: list[tuple[tuple[float, float, float], tuple[float, float, float]]] = []
    for end in (-1, 1):
        x = end * reach[0] * 0.86
        pieces += [
            ((side * 1.6, 2 * reach[1], 0.05), (x, 0, 0)),
            ((side * 1.6, 2 * reach[1] * 0.85, 0.05), (x, 0, top - 0.05)),
            ((side, 2.6 * side, top - 0.1), (x, 0, 0.05)),
        ]
    pieces.append(((2 * reach[0] * 0.86 - side, side * 0.7, 0.08), (0, 0, 0.3 * top)))
    return (
        [box(*size).move(*at) for size, at in pieces],
        [box_part(*size, at) for size, at in pieces],
    )


def _pedestal(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    base = 0.29 * width
    solids = [
        cylinder(base, 0.035, 32, bevel=0.01),
        cylinder(0.1 * width, 0.12 * top, 24, top=0.05 * width).move(z=0.03),
        cylinder(0.05 * width, top - 0.05, 24).move(z=0.04),
        cylinder(0.05 * width, 0.06, 24, top=0.16 * width).move(z=top - 0.06),
    ]
    parts = [
        cylinder_part(base, 0.035),
        cylinder_part(0.05 * width, top - 0.035, (0, 0, 0.035)),
    ]
    return solids, parts


def _hairpin(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    rod = 0.007
    solids, parts = [], []
    for foot in feet:
        way = foot / np.hypot(*foot)
        side = np.array([-way[1], way[0]])
        for sign in (-1, 1):
            high, low = foot - 0.03 * way + sign * 0.055 * side, foot + sign * 0.004 * side
            solids.append(tube([(*low, 0.0), (*low, 0.012), (*high, top)], rod, 8))
        parts.append(box_part(0.02, 0.02, top, (*foot, 0)))
    return solids, parts


def _metal(feet: Float[np.ndarray, "k 2"], top: float, width: float) -> Legs:
    side = 0.028
    solids = [box(side, side, top).move(*foot) for foot in feet]
    parts = [box_part(side, side, top, (*foot, 0)) for foot in feet]
    for a, b in zip(feet, np.roll(feet, -1, 0), strict=True):
        span, (x, y) = np.abs(b - a), (a + b) / 2
        if span.min() < 1e-9:
            size = np.maximum(span - side, 0) + np.where(span < 1e-9, side, 0)
            solids.append(box(size[0], size[1], side).move(x, y, top - side))
    return solids, parts


LEGS: Mapping[str, Callable[[Float[np.ndarray, "k 2"], float, float], Legs]] = MappingProxyType(
    {
        "straight": _straight,
        "tapered": _tapered_legs,
        "splayed": _splayed_legs,
        "trestle": _trestle,
        "pedestal": _pedestal,
        "hairpin": _hairpin,
        "metal": _metal,
    }
)
"""Leg styles: functions of the joints with the top, the height under it, and the shorter side."""


# -------------------------------------------------------------------------------- materials


def _tiles(plan: PlannedTable, rng: np.random.Generator) -> tuple[Tile, Tile]:
    """Return the textures of the tabletop and of the legs."""
    words = plan.material.lower().replace("-", " ").split()
    asked = rgb(plan.color) if plan.color else None
    dark: RGB = (58, 58, 62)
    planks = 0 if plan.outline in ("round", "oval", "triangle") else 5
    if plan.outline == "slatted":
        planks = max(4, round(plan.size[1] / 0.1))
    if "marble" in words or "stone" in words:
        ground = asked or (234, 232, 228)
        return surfaces.marble(rng, ground, tint_color(ground, 0.6), 256), surfaces.speckles(
            rng, dark, 3
        )
    if "glass" in words:
        ground = asked or (196, 220, 218)
        return surfaces.marble(rng, ground, tint_color(ground, 1.2), 64), surfaces.brushed_metal(
            rng, METALS["steel"]
        )
    for word in words:
        if word in METALS:
            ground = asked or METALS[word]
            return surfaces.brushed_metal(rng, ground, 128), surfaces.brushed_metal(
                rng, tint_color(ground, 0.75)
            )
    for word in words:
        if word in WOODS:
            ground = asked or WOODS[word]
            top = surfaces.wood(rng, ground, side=256, planks=planks)
            legs = (
                surfaces.speckles(rng, dark, 3, 16)
                if plan.legs in ("hairpin", "metal")
                else surfaces.wood(rng, tint_color(ground, 0.88), side=64)
            )
            return top, legs
    ground = asked or rgb(plan.material) or WOODS["oak"]
    legs = ground if plan.legs not in ("hairpin", "metal") else dark
    return surfaces.speckles(rng, ground, 2, 128), surfaces.speckles(rng, tint_color(legs, 0.92), 3)
