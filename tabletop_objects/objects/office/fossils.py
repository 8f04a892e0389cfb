"""Objects of the ``office`` theme: fossils."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import arc, smooth
from ...kit.primitives import at_block, ball, disc, hull_solid, plate, spindle
from ...kit.shapes import Category, Drawing, Pieces, at_rest, category, from_pieces
from ...kit.solids import Solid, join, tube
from ...kit.surfaces import Look, tint_color

STONE = ("tan", "brown", "gray", "beige")


def _skin(look: Look, *palette: str) -> surfaces.Tile:
    color = look.color(*palette)
    return surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.12)


def _coil(scale: float) -> Solid:
    """Return a ribbed spiral shell, lying flat."""
    t = np.linspace(0, 1, 130)
    a = 2 * np.pi * 2.9 * t
    r = 0.006 * np.exp(1.95 * t)
    path = np.column_stack([r * np.cos(a), r * np.sin(a), np.full(130, 0.012)]) * scale
    ribs = 1 + 0.1 * np.cos(2 * np.pi * 48 * t)
    return tube(path, 0.36 * r * ribs * scale, 8)


@category("ammonite", size=(0.0889, 0.089, 0.0328), mass=0.2, material="stone",
          aliases=("fossil ammonite", "nautilus", "nautilus shell"), themes=("office",),
          colors=("tan", "gray"), state="lying")  # fmt: skip
@at_rest
@from_pieces(foot=0.06)
def ammonite(look: Look) -> Pieces:
    """A ribbed spiral shell of stone."""
    coil = _coil(1.0)
    return [(coil.move(z=-float(coil.bounds[0, 2])), _skin(look, *STONE))]


@category("trilobite", size=(0.0543, 0.0806, 0.0192), mass=0.06, material="stone",
          aliases=("trilobite fossil", "fossil trilobite"), themes=("office",),
          colors=("charcoal",), state="lying")  # fmt: skip
@from_pieces(bodies=2)
def trilobite(look: Look) -> Pieces:
    """A trilobite with a broad head, ribs over three lobes and a narrow tail."""
    dark = _skin(look, "charcoal", "brown", "black")
    base = plate(np.column_stack([0.027 * np.cos(a := np.linspace(0, 2 * np.pi, 32)[:-1]),
                                  0.04 * np.sin(a)]), 0.006)  # fmt: skip
    head = ball(0.05, 0.03, 0.022, (0, 0.024, 0.006))
    pieces: Pieces = [(base, dark), (head, dark)]
    ribs = []
    for k in range(11):
        y = 0.012 - 0.0045 * k
        wide = 0.024 * np.sqrt(max(1 - (y / 0.041) ** 2, 0.06))
        path = smooth([(-wide, y - 0.003, 0.005), (-0.5 * wide, y, 0.009), (0, y + 0.0006, 0.0125),
                       (0.5 * wide, y, 0.009), (wide, y - 0.003, 0.005)], 4)  # fmt: skip
        ribs.append(tube(path, 0.0021, 6))
    axis = tube([(0, 0.014, 0.009), (0, -0.01, 0.0085), (0, -0.036, 0.005)],
                [0.0065, 0.005, 0.0015], 10)  # fmt: skip
    eyes = [ball(0.008, 0.009, 0.008, (s * 0.013, 0.026, 0.015), 10) for s in (-1, 1)]
    shade = surfaces.plain((40, 34, 30))
    return [*pieces, (join(ribs), dark), (axis, dark), *((e, shade) for e in eyes)]


def _tooth(long: float, serrated: bool) -> np.ndarray:
    """Return the flat outline of a triangular tooth with two roots."""
    w = 0.78 * long
    left = smooth([(-0.5 * w, 0), (-0.36 * w, 0.35 * long), (-0.08 * w, 0.85 * long), (0, long)], 6)
    right = left[::-1] * [-1, 1]
    root = smooth([(0.5 * w, 0), (0.42 * w, -0.3 * long), (0.2 * w, -0.3 * long),
                   (0, -0.14 * long), (-0.2 * w, -0.3 * long), (-0.42 * w, -0.3 * long),
                   (-0.5 * w, 0)], 4)  # fmt: skip
    return np.concatenate([left, right[1:], root[1:-1]])


def _shark(long: float) -> Drawing:
    def draw(look: Look) -> Pieces:
        """A shark tooth, lying flat."""
        color = look.color("gray", "charcoal", "cream", "tan")
        outline = _tooth(long, True)
        body = plate(outline, 0.14 * long)
        crown = outline[outline[:, 1] > -0.02 * long]
        mid = 0.3 * long
        bulge = hull_solid(np.concatenate([
            np.column_stack([crown, np.full(len(crown), 0.13 * long)]),
            [(0.0, mid, 0.24 * long), (0, 0.1 * long, 0.24 * long)]]))  # fmt: skip
        root = surfaces.spots(look.rng, tint_color(color, 0.62), tint_color(color, 0.45), 0.2)
        return [(body, root), (bulge, surfaces.gradient(tint_color(color, 0.85),
                 tint_color(color, 1.4), look.rng))]  # fmt: skip

    return draw


def _fang(bend: float, r: float) -> Drawing:
    def draw(look: Look) -> Pieces:
        """A curved tooth or claw, lying flat."""
        color = look.color("tan", "brown", "charcoal", "cream")
        path = smooth([(-0.035, -bend, r), (-0.012, 0.2 * bend, r), (0.015, 0.1 * bend, 0.8 * r),
                       (0.042, -bend, 0.35 * r)], 6)  # fmt: skip
        radii = np.interp(np.linspace(0, 1, len(path)), [0, 0.3, 0.7, 1], [r, r, 0.62 * r, 0.001])
        return [(tube(path, radii, 12), surfaces.gradient(tint_color(color, 0.6), color, look.rng))]

    return draw


@category("belemnite", size=(0.081, 0.0132, 0.0132), mass=0.02, material="stone",
          aliases=("belemnite fossil",), themes=("office",), colors=("brown",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.15)
def belemnite(look: Look) -> Pieces:
    """A smooth, bullet-shaped fossil lying flat, blunt on the left and pointed on the right."""
    return [(spindle((-0.04, 0.005), (-0.038, 0.0062), (0.01, 0.0066), (0.032, 0.0035),
                    (0.041, 0.0006), sides=14), _skin(look, "brown", "amber", "gray"))]  # fmt: skip


@category("crinoid", size=(0.06, 0.017, 0.017), mass=0.02, material="stone",
          aliases=("crinoid stem", "sea lily", "crinoid fossil"), themes=("office",),
          colors=("beige",), state="lying")  # fmt: skip
@from_pieces(foot=0.15)
def crinoid(look: Look) -> Pieces:
    """A crinoid fossil lying flat: the stem of a sea lily with stacked rings."""
    tile = _skin(look, "beige", "gray", "tan")
    points: list[tuple[float, float]] = []
    for k in range(11):
        x = -0.03 + 0.0054 * k
        points += [(x, 0.0072), (x + 0.0008, 0.0085), (x + 0.004, 0.0085), (x + 0.0048, 0.0072)]
    return [(spindle(*points, sides=14), tile)]


@category("brachiopod", size=(0.036, 0.031, 0.018), mass=0.015, material="stone",
          aliases=("brachiopod fossil", "lamp shell"), themes=("office",), colors=("gray",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.05, bodies=1)
def brachiopod(look: Look) -> Pieces:
    """A ribbed fossil shell."""
    color = look.color("gray", "tan", "brown")
    body = ball(0.036, 0.03, 0.02, (0, 0, 0.008), 20)

    def ribbed_shell(p: np.ndarray) -> np.ndarray:
        a = np.arctan2(p[:, 0], p[:, 1] + 0.017)
        return p * np.column_stack([1 + 0.05 * np.cos(26 * a), 1 + 0.05 * np.cos(26 * a),
                                    np.ones(len(p))])  # fmt: skip

    tile = surfaces.stripes([tint_color(color, 1.15), tint_color(color, 0.6)], 14, upright=True)
    return [(body.bend(ribbed_shell), tile)]


@category("mammoth_tooth", size=(0.151, 0.0604, 0.0518), mass=0.7, material="stone",
          aliases=("mammoth molar",), themes=("office",), colors=("brown",))  # fmt: skip
@from_pieces(bodies=1)
def mammoth_tooth(look: Look) -> Pieces:
    """A mammoth tooth: a long block with ridges across it."""
    color = look.color("brown", "tan", "charcoal")
    base = at_block(0.15, 0.06, 0.05, 0.025)
    dark, pale = (surfaces.speckles(look.rng, tint_color(color, f), 8) for f in (0.8, 1.5))
    ridges = [
        at_block(0.0105, 0.052, 0.003, 0.005, (x, 0, 0.0485)) for x in np.linspace(-0.06, 0.06, 10)
    ]
    roots = [disc(0.012, 0.02, (x, 0, 0)) for x in (-0.04, 0.04)]
    return [(base, dark), (join(ridges), pale), (join(roots), dark)]


@category("fish_fossil", size=(0.13, 0.085, 0.0134), mass=0.3, material="stone",
          aliases=("fossil fish", "fossil plate", "fish skeleton fossil", "fossil leaf",
          "fern fossil"), themes=("office",), roles=("flat",), colors=("beige",),
          state="lying")  # fmt: skip
@from_pieces(bodies=1)
def fish_fossil(look: Look) -> Pieces:
    """A slab with the imprint of a fish skeleton."""
    color = look.color("beige", "tan", "gray")
    base = at_block(0.13, 0.085, 0.012, 0.01)
    dark = surfaces.plain(tint_color(color, 0.38))
    lines = [tube(smooth([(-0.045, 0, 0.012), (0, 0.003, 0.012), (0.04, 0, 0.012)], 5), 0.0014, 6)]
    for x in np.linspace(-0.03, 0.026, 9):
        y = 0.018 * np.sqrt(1 - (x / 0.05) ** 2)
        lines += [tube([(x, 0, 0.012), (x - 0.008, s * y, 0.012)], 0.0009, 5) for s in (-1, 1)]
    lines += [tube([(-0.045, 0, 0.012), (-0.058, s * 0.015, 0.012)], 0.0016, 5) for s in (-1, 1)]
    head = disc(0.012, 0.0008, (0.043, 0, 0.0117))
    eye = disc(0.0025, 0.0008, (0.045, 0.003, 0.0122), sides=12)
    ring = tube([(*p, 0.012) for p in arc((0.041, 0), 0.014, -1.6, 1.6, 10)], 0.001, 5)
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.85), 0.2)
    return [(base, tile), (join([*lines, ring]), dark),
            (head, surfaces.plain(tint_color(color, 0.55))), (eye, dark)]  # fmt: skip


@category("petrified_wood", size=(0.081, 0.055, 0.056), mass=0.35, material="stone",
          aliases=("fossil wood", "petrified log", "piece of petrified wood"), themes=("office",),
          colors=("brown",), state="lying")  # fmt: skip
@from_pieces(foot=0.12)
def petrified_wood(look: Look) -> Pieces:
    """A short log of petrified wood lying flat, with dark mottled bark and rings on its ends."""
    color = look.color("brown", "terracotta", "tan")
    body = spindle((-0.04, 0.028), (0.04, 0.026), sides=11)
    rings = np.zeros((64, 64, 3))
    y, x = np.mgrid[0:64, 0:64] / 63 - 0.5
    band = (np.hypot(x, y) * 22).astype(int) % 3
    for k, f in enumerate((0.7, 1.0, 1.35)):
        rings[band == k] = tint_color(color, f)
    ends = [disc(0.0255, 0.0006).turn(1, np.pi / 2).move(s * 0.0398, 0, 0.028) for s in (-1, 1)]
    bark = surfaces.spots(look.rng, tint_color(color, 0.75), tint_color(color, 0.5), 0.25)
    return [(body, bark), *((e, rings.astype(np.uint8)) for e in ends)]


CATEGORIES = (
    Category("shark_tooth", from_pieces()(_shark(0.035)), size=(0.0273, 0.0455, 0.0084), mass=0.008,
             material="stone", aliases=("fossil shark tooth",), themes=("office",),
             colors=("gray",), state="lying"),
    Category("megalodon_tooth", from_pieces()(_shark(0.1)), size=(0.078, 0.13, 0.024), mass=0.25,
             material="stone", aliases=("megalodon", "giant shark tooth"), themes=("office",),
             colors=("gray",), state="lying"),
    Category("dinosaur_tooth", from_pieces(foot=0.15)(_fang(0.006, 0.01)),
             size=(0.0799, 0.026, 0.02), mass=0.04, material="stone", aliases=("t rex tooth",
             "tyrannosaurus tooth", "animal tooth", "fang", "tusk", "crocodile tooth"),
             themes=("office",), colors=("tan",), state="lying"),
    Category("dinosaur_claw", from_pieces(foot=0.15)(_fang(0.022, 0.01)),
             size=(0.086, 0.0437, 0.0203), mass=0.04, material="stone",
             aliases=("raptor claw", "claw", "animal claw"), themes=("office",),
             colors=("charcoal",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
