"""Stringed instruments by their proportions, lying; harps and lyres standing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...build.category import Category
from ...build.making import Drawing, at_box, disc, dye, of, plate, shine, wood
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod, straight
from ...build.shape import Shape
from ...build.solids import Solid, join, tube
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.look import Look

CREAM = textures.plain((236, 226, 200))


@dataclass(frozen=True)
class Lute:
    """The proportions of a plucked instrument, metres.

    Attributes:
        body: points (x, half width) of its body's outline from the tail to the neck.
        neck: the neck's length.
        wide: the neck's width.
        head: the head's length.
        strings: how many strings it has.
        deep: its body's depth.
        face: the colours of its face; empty for that of its back.
        hole: the sound hole's radius; 0 for none.
        round_back: whether its back is bulged like half a pear.
    """

    body: tuple[tuple[float, float], ...]
    neck: float
    wide: float
    head: float
    strings: int
    deep: float = 0.04
    face: tuple[str, ...] = ("tan", "beige")
    hole: float = 0.02
    round_back: bool = False


def _outline(points: tuple[tuple[float, float], ...]) -> np.ndarray:
    upper = smooth(points, 6)
    upper[:, 1] = np.maximum(upper[:, 1], 0.004)
    return np.concatenate([upper * [1, -1], upper[::-1]])


def _strings(lute: Lute, z: float, start: float, end: float) -> Solid:
    n = lute.strings
    rows = (np.arange(n) / max(n - 1, 1) - 0.5) * 0.75 * lute.wide
    return join([tube([(start, 1.3 * y, z), (end, y, z)], 0.0007, 4) for y in rows])


def _plucked_strings(lute: Lute, back: tuple[str, ...]) -> Drawing:
    def draw(look: Look) -> Pieces:
        skin = wood(look, *back)
        front = dye(look, *lute.face) if lute.face else skin
        outline = _outline(lute.body)
        tail, top = lute.body[0][0], lute.body[-1][0]
        if lute.round_back:
            wide = max(w for _, w in lute.body)
            flat = plate(outline, 0.006, lute.deep - 0.006)
            bowl = ball(0.94 * (top - tail), 1.9 * wide, 2 * lute.deep - 0.012,
                        ((top + tail) / 2, 0, lute.deep - 0.006), 20)  # fmt: skip
            bowl = bowl.bend(lambda p: np.column_stack(
                [p[:, :2], np.minimum(p[:, 2], lute.deep - 0.004)]))  # fmt: skip
            pieces: Pieces = [(bowl, skin), (flat, front)]
        else:
            pieces = [(plate(outline, lute.deep), skin),
                      (plate(0.97 * outline + [0.015 * (top + tail), 0], 0.0012,
             lute.deep - 0.0004),
                       front)]  # fmt: skip
        z = lute.deep
        end = top + lute.neck
        neck = at_box(
            lute.neck + 0.03, lute.wide, 0.014, (top + lute.neck / 2 - 0.015, 0, z - 0.01)
        )
        board = at_box(lute.neck + 0.05, lute.wide, 0.004,
                       (top + lute.neck / 2 - 0.025, 0, z + 0.002))  # fmt: skip
        frets = [at_box(0.0014, lute.wide, 0.0012, (top + lute.neck * f, 0, z + 0.0055))
                 for f in np.linspace(0.05, 0.95, 9)]  # fmt: skip
        head = plate([(end - 0.002, -0.5 * lute.wide), (end + lute.head, -0.8 * lute.wide),
                      (end + lute.head, 0.8 * lute.wide), (end - 0.002, 0.5 * lute.wide)],
                     0.011, z - 0.009)  # fmt: skip
        pegs = [straight((end + lute.head * f, 0.5 * s * lute.wide, z - 0.003),
                         (end + lute.head * f, 1.25 * s * lute.wide, z - 0.003), 0.0032, 6)
                for f in np.linspace(0.25, 0.85, max(lute.strings // 2, 2)) for s in (-1,
             1)]  # fmt: skip
        middle = tail + 0.24 * (top - tail)
        bridge = at_box(0.01, 1.6 * lute.wide, 0.006, (middle, 0, z))
        dark = dye(look, "black", "brown")
        pieces += [(neck, skin), (head, skin), (board, dark), (bridge, dark),
                   (join(frets), shine(look)), (join(pegs), CREAM),
                   (_strings(lute, z + 0.0075, middle, end + 0.2 * lute.head),
                    textures.plain((226, 226, 222)))]  # fmt: skip
        if lute.hole:
            at = tail + 0.66 * (top - tail)
            pieces.append((disc(lute.hole, 0.0012, (at, 0, z)), textures.plain((30, 24, 20))))
        return pieces

    return draw


_PEAR = ((-0.13, 0.0), (-0.12, 0.05), (-0.06, 0.085), (0.0, 0.075), (0.06, 0.04), (0.1, 0.014))
_LUTE = ((-0.16, 0.0), (-0.145, 0.07), (-0.07, 0.115), (0.02, 0.1), (0.1, 0.05), (0.14, 0.018))
_GOURD = ((-0.1, 0.0), (-0.09, 0.05), (-0.04, 0.08), (0.02, 0.07), (0.07, 0.03), (0.1, 0.022))
_DOUBLE = ((-0.13, 0.0), (-0.125, 0.045), (-0.09, 0.085), (-0.03, 0.06), (0.03, 0.055),
           (0.08, 0.075), (0.115, 0.06), (0.08, 0.018))  # fmt: skip


def _electric(look: Look) -> Pieces:
    """A solid electric guitar with horns, pickups and knobs."""
    body = _DOUBLE
    lute = Lute(body, 0.26, 0.032, 0.075, 6, 0.026, (), 0.0)
    pieces = _plucked_strings(lute, ("red", "black", "sky", "white", "mustard", "teal"))(look)
    color = look.surface(look.color("red", "black", "sky", "white", "mustard", "teal"))
    pieces = [(s, color if k < 2 else t) for k, (s, t) in enumerate(pieces)]
    neck = dye(look, "wooden", "tan")
    pieces[2:4] = [(pieces[2][0], neck), (pieces[3][0], neck)]
    guard = plate(_outline(((-0.1, 0.0), (-0.08, 0.05), (-0.02, 0.036), (0.05, 0.035), (0.06,
             0.0))),
                  0.0012, 0.0262)  # fmt: skip
    pickups = [at_box(0.012, 0.045, 0.004, (x, 0, 0.0272)) for x in (-0.045, 0.0, 0.04)]
    knobs = [disc(0.006, 0.008, (x, -0.052, 0.026)) for x in (-0.075, -0.05)]
    return [*pieces, (guard, dye(look, "white", "black")), (join(pickups), dye(look, "black")),
            (join(knobs), dye(look, "silver", "black"))]  # fmt: skip


def _banjo(look: Look) -> Pieces:
    """A banjo: a drum with a skin and brackets, a long neck."""
    lute = Lute(((-0.13, 0.0), (-0.12, 0.05), (-0.03, 0.05), (0.0, 0.0)), 0.26, 0.032, 0.07, 5,
                0.05, (), 0.0)  # fmt: skip
    parts = _plucked_strings(lute, ("brown", "wooden"))(look)
    skin = wood(look, "brown", "wooden", "maroon")
    rim = disc(0.092, 0.052, (-0.065, 0, 0), sides=36)
    head = disc(0.085, 0.0012, (-0.065, 0, 0.0516), sides=36)
    nuts = [disc(0.0035, 0.04, (-0.065 + 0.0945 * np.cos(a), 0.0945 * np.sin(a), 0.008), sides=8)
            for a in np.arange(16) * np.pi / 8]  # fmt: skip
    bridge = at_box(0.005, 0.045, 0.008, (-0.1, 0, 0.0525))
    return [(rim, skin), *parts[2:4], *parts[4:5], *parts[6:], (head, CREAM), (join(nuts),
             shine(look)),
            (bridge, dye(look, "tan"))]  # fmt: skip


def _harp(look: Look) -> Pieces:
    """A small harp standing: a sound box, a curved neck, a pillar, strings between."""
    tile = wood(look, "brown", "wooden", "gold", "tan")
    base = at_box(0.12, 0.07, 0.016, (0.0, 0, 0))
    box = straight((-0.045, 0, 0.014), (0.085, 0, 0.22), (0.03, 0.014), 4)
    pillar = rod([(-0.05, 0, 0.012), (-0.075, 0, 0.14), (-0.07, 0, 0.285)], 0.009, 10)
    neck = rod([(-0.07, 0, 0.28), (-0.02, 0, 0.3), (0.03, 0, 0.25), (0.09, 0, 0.225)], 0.009, 10, 6)
    lines = []
    for k in range(12):
        t = (k + 0.5) / 12
        x = -0.06 + 0.13 * t
        low = 0.014 + 0.206 * (x + 0.045 + 0.02) / 0.13
        high = float(np.interp(x, [-0.07, -0.02, 0.03, 0.09], [0.285, 0.3, 0.25, 0.222]))
        if high > low + 0.01:
            lines.append(straight((x, 0, max(low, 0.016)), (x, 0, high), 0.0008, 4))
    return [(base, tile), (box, tile), (pillar, tile), (neck, tile),
            (join(lines), dye(look, "gold", "cream"))]  # fmt: skip


def _lyre(look: Look) -> Pieces:
    """A lyre lying: a bowl, two curved arms, a yoke, strings."""
    tile = wood(look, "brown", "wooden", "tan", "gold")
    bowl = plate(_outline(((-0.1, 0.0), (-0.095, 0.045), (-0.05, 0.065), (-0.02, 0.06), (0.0,
             0.0))),
                 0.03)  # fmt: skip
    arms = [rod([(-0.02, s * 0.05, 0.015), (0.03, s * 0.075, 0.015), (0.08, s * 0.06, 0.015),
                 (0.115, s * 0.07, 0.015)], 0.008, 10) for s in (-1, 1)]  # fmt: skip
    yoke = straight((0.105, -0.085, 0.022), (0.105, 0.085, 0.022), 0.006)
    lines = [tube([(-0.07, y, 0.034), (0.105, 1.6 * y, 0.029)], 0.0009, 4)
             for y in np.linspace(-0.02, 0.02, 7)]  # fmt: skip
    hole = disc(0.016, 0.001, (-0.035, 0, 0.0296))
    return [(bowl, tile), *((a, tile) for a in arms), (yoke, tile), (join(lines), CREAM),
            (hole, dye(look, "black")), (at_box(0.006, 0.05, 0.006, (-0.07, 0, 0.0295)), dye(look,
             "black"))]  # fmt: skip


def _zither(look: Look) -> Pieces:
    """A flat box with slanting ends and many strings."""
    tile = wood(look, "wooden", "brown", "tan")
    body = plate([(-0.17, -0.09), (0.17, -0.09), (0.11, 0.09), (-0.11, 0.09)], 0.035)
    lines = [tube([(-0.16 + 0.0033 * k, -0.08 + 0.0095 * k, 0.041),
                   (0.16 - 0.0033 * k, -0.08 + 0.0095 * k, 0.041)], 0.0008,
             4) for k in range(17)]  # fmt: skip
    rails = [
        straight((s * 0.15, -0.085, 0.037), (s * 0.1, 0.085, 0.037), 0.0045, 6) for s in (-1, 1)
    ]
    holes = [disc(0.02, 0.001, (x, 0.0, 0.0346)) for x in (-0.06, 0.06)]
    return [(body, tile), (join(lines), textures.plain((222, 222, 218))),
            (join(rails), dye(look, "brown", "black")), (join(holes), dye(look,
             "black"))]  # fmt: skip


def _lute(lute: Lute, *back: str) -> Callable[[Look], Shape]:
    return of(_plucked_strings(lute, back or ("brown", "wooden", "maroon")), 0.06, bodies=4)


CATEGORIES = (
    Category("electric_guitar", of(_electric, bodies=4), (0.547, 0.171, 0.0343), 0.9,
             ("toy electric guitar", "mini electric guitar", "bass guitar", "electric bass",
              "stratocaster"), ("living",), ("big",), ("red", "black"), state="lying flat"),
    Category("banjo", of(_banjo, bodies=3), (0.47, 0.192, 0.06), 0.9, ("small banjo",),
             ("living",), ("big",), ("brown",), state="lying flat"),
    Category("mandolin", _lute(Lute(_PEAR, 0.16, 0.03, 0.07, 8, 0.045)), (0.46, 0.17, 0.054), 0.6,  # type: ignore[arg-type]
             ("bouzouki", "balalaika"), ("living",), ("big",), ("brown",), state="lying flat"),
    Category("lute", _lute(Lute(_LUTE, 0.15, 0.045, 0.08, 10, 0.08, round_back=True, hole=0.03)),  # type: ignore[arg-type]
             (0.53, 0.23, 0.09), 0.8, ("oud", "theorbo", "medieval lute"), ("living",), ("big",),
             ("brown",), state="lying flat"),
    at_rest(Category("sitar", _lute(Lute(_GOURD, 0.34, 0.05, 0.09, 9, 0.08, ("tan", "brown"), 0.0,
             True)),  # type: ignore[arg-type]
             (0.63, 0.16, 0.09), 0.9, ("tanpura", "shamisen", "erhu", "pipa"), ("living",),
             ("big",), ("brown",), state="lying flat")),
    Category("harp", of(_harp), (0.18, 0.07, 0.305), 0.8, ("lever harp", "mini harp", "celtic harp",
             "small harp", "toy harp"), ("living",), ("tall",), ("brown", "gold")),
    Category("lyre", of(_lyre, 0.06), (0.217, 0.169, 0.0354), 0.4, ("lyra", "kithara"), ("living",),
             ("big",), ("brown",), state="lying flat"),
    Category("dulcimer", of(_zither, bodies=1), (0.34, 0.18, 0.042), 1.2, ("zither", "autoharp",
             "hammered dulcimer", "psaltery", "santoor", "guzheng", "koto"), ("living",), ("big",),
             ("wooden",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
