"""The six men of chess, each in its own shape."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.forms import side_view
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, ellipsoid, join, lathe
from ...surfaces.look import Look

Head = Callable[[float, float], list[Solid]]
"""Makes what stands on a body of radius r and height h."""

COLORS = ("cream", "black", "white", "brown", "charcoal", "tan")


def _body(r: float, h: float, neck: float) -> list[tuple[float, float]]:
    """Return the turned side of a man: foot, waist and collar, up to ``h``."""
    return [(0, 0), (r, 0), (r, 0.14 * r), (0.94 * r, 0.34 * r), (0.78 * r, 0.5 * r),
            (0.8 * r, 0.62 * r), (0.55 * r, 0.9 * r), (neck * r, 0.62 * h), (neck * r, 0.86 * h),
            (1.75 * neck * r, 0.9 * h), (1.75 * neck * r, 0.94 * h), (neck * r, h)]  # fmt: skip


def _pawn(r: float, h: float) -> list[Solid]:
    return [ellipsoid(1.15 * r, 1.15 * r, 1.15 * r, 18, 12).move(z=h + 0.4 * r)]


def _rook(r: float, h: float) -> list[Solid]:
    tower = lathe(
        [(0, h - 0.002), (0.62 * r, h - 0.002), (0.74 * r, h + 0.6 * r), (0, h + 0.6 * r)], 24
    )
    teeth = [box(0.26 * r, 0.34 * r, 0.34 * r).move(0.6 * r, 0, h + 0.58 * r).turn(2, a)
             for a in 2 * np.pi * np.arange(6) / 6]  # fmt: skip
    return [tower, *teeth]


def _bishop(r: float, h: float) -> list[Solid]:
    hat = lathe([(0, h - 0.002), (0.4 * r, h), (0.6 * r, h + 0.5 * r), (0.44 * r, h + 1.0 * r),
                 (0.12 * r, h + 1.4 * r), (0, h + 1.42 * r)], 22)  # fmt: skip
    slit = box(0.7 * r, 0.1 * r, 0.5 * r).turn(1, -0.6).move(0.3 * r, 0, h + 0.75 * r)
    return [hat, slit, ellipsoid(0.26 * r, 0.26 * r, 0.26 * r, 12, 8).move(z=h + 1.5 * r)]


def _queen(r: float, h: float) -> list[Solid]:
    cup = lathe([(0, h - 0.002), (0.4 * r, h), (0.5 * r, h + 0.6 * r), (0.8 * r, h + 1.1 * r),
                 (0.5 * r, h + 1.05 * r), (0, h + 1.2 * r)], 24)  # fmt: skip
    tips = [ellipsoid(0.28 * r, 0.28 * r, 0.3 * r, 8, 6).move(0.7 * r, 0, h + 1.14 * r).turn(2, a)
            for a in 2 * np.pi * np.arange(8) / 8]  # fmt: skip
    return [cup, *tips, ellipsoid(0.4 * r, 0.4 * r, 0.4 * r, 12, 8).move(z=h + 1.3 * r)]


def _king(r: float, h: float) -> list[Solid]:
    cup = lathe([(0, h - 0.002), (0.42 * r, h), (0.56 * r, h + 0.7 * r), (0.74 * r, h + 1.1 * r),
                 (0.4 * r, h + 1.3 * r), (0, h + 1.34 * r)], 24)  # fmt: skip
    return [cup, box(0.2 * r, 0.2 * r, 0.8 * r).move(z=h + 1.3 * r),
            box(0.6 * r, 0.2 * r, 0.2 * r).move(z=h + 1.68 * r)]  # fmt: skip


def _knight(r: float, h: float) -> list[Solid]:
    side = smooth([(-0.5, 0), (0.62, 0), (0.78, 0.7), (0.66, 1.3), (0.3, 1.75), (0.22, 2.05),
                   (0.02, 1.82), (-0.5, 1.5), (-0.92, 1.1), (-0.86, 0.85), (-0.6, 0.85),
                   (-0.2, 0.95), (-0.38, 0.5)], 3)  # fmt: skip
    head = side_view(side * r, 0.56 * r).move(z=h - 0.02 * r)
    ears = [box(0.14 * r, 0.16 * r, 0.3 * r).move(0.24 * r, s * 0.17 * r, h + 1.84 * r)
            for s in (-1, 1)]  # fmt: skip
    return [head, *ears]


def man(height: float, neck: float, head: Head) -> Callable[[Look], Shape]:
    """Return the shape function of a chess man of about this body height, in metres."""

    def make(look: Look) -> Shape:
        r = look.between(0.0145, 0.0175)
        h = height * r / 0.016 * look.between(0.94, 1.08)
        body = lathe([*_body(r, h, neck), (0, h)], 24)
        tile = look.surface(look.color(*COLORS), look.pick(["plastic", "wood", "plastic"]))
        top = head(r, h)
        return shape([(body, tile), (join(top), tile)],
                     [cylinder_part(0.99 * r, 0.2 * r), hull_of(body), hull_of(*top)])  # fmt: skip

    return make


def _row(key: str, make: Callable[[Look], Shape], mass: float, *aliases: str) -> Category:
    return Category(f"chess_{key}", make, SIZES[key], mass, (key, *aliases), ("games",), ("round",),
                    ("cream", "black"))  # fmt: skip


SIZES = {
    "king": (0.0323, 0.0323, 0.0811), "queen": (0.0323, 0.0323, 0.0743),
    "bishop": (0.0323, 0.0323, 0.0624), "knight": (0.0323, 0.0323, 0.0551),
    "rook": (0.0323, 0.0323, 0.044), "pawn": (0.0323, 0.0323, 0.0397),
}  # fmt: skip
CATEGORIES = (
    _row("king", man(0.05, 0.34, _king), 0.05, "king chess piece"),
    _row("queen", man(0.046, 0.34, _queen), 0.045, "queen chess piece"),
    _row("bishop", man(0.036, 0.32, _bishop), 0.035, "bishop chess piece"),
    _row("knight", man(0.02, 0.6, _knight), 0.035, "knight chess piece"),
    _row("rook", man(0.028, 0.46, _rook), 0.035, "chess castle", "rook chess piece"),
    _row("pawn", man(0.024, 0.32, _pawn), 0.02, "pawn chess piece"),
)
"""The module's categories."""
