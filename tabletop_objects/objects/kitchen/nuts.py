"""Objects of the ``kitchen`` theme: nuts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...kit import surfaces
from ...kit.outlines import smooth
from ...kit.parts import flat_foot, hull_of
from ...kit.primitives import bent_rod, limb
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import Solid, box, cylinder, ellipsoid, join, lathe, loft, torus, tube
from ...kit.surfaces import Look, streaks, tint_color


def seed(palette: tuple[str, ...], form: tuple[float, float, float], striped: bool
         ) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape function of one flat, pointed seed, plain or striped."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.15)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        half = smooth([(-0.5, 0.0), (-0.3, 0.36), (0.1, 0.5), (0.4, 0.28), (0.5, 0.0)], 3)
        outline = np.concatenate([half[::-1], (half * [1, -1])[1:-1]]) * [x, y]
        levels = [(0.7, 0), (1.0, 0.35), (1.0, 0.6), (0.6, 1.0)]
        body = loft(np.stack([np.column_stack([outline * f, np.full(len(outline), h * z)])
                              for f, z in levels]), outline)  # fmt: skip
        other = (236, 232, 222) if striped else tint_color(color, 0.9)
        tile = surfaces.stripes([color, other, color], 2) if striped else surfaces.gradient(
            tint_color(color, 0.95), tint_color(color, 1.15), look.rng)  # fmt: skip
        return shape([(body, tile)], [hull_of(body)])

    return make


@category("brazil_nut", size=(0.044, 0.0286, 0.0205), mass=0.008, material="food",
          aliases=("brazil nut in its shell",), themes=("kitchen",), roles=("edible",),
          colors=("brown",), state="lying flat")  # fmt: skip
def brazil_nut(look: Look) -> Shape:
    """A brown, ridged, three-sided Brazil nut."""
    k = look.between(0.9, 1.1)
    color = look.color("brown", "bronze")
    ring = smooth([(-0.5, -0.05), (-0.2, -0.3), (0.25, -0.28), (0.5, 0.0), (0.3, 0.3), (-0.2, 0.28),
                   (-0.5, -0.05)], 3)[:-1] * 0.045  # fmt: skip
    levels = [(0.75, 0), (1.0, 0.006), (0.85, 0.012), (0.3, 0.02), (0.1, 0.021)]
    body = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
                ring)  # fmt: skip
    return shape([(body, surfaces.scratches(look.rng, color, tint_color(color, 0.7), 60))],
                 [hull_of(body)]).scale(k)  # fmt: skip


@category("pecan", size=(0.0329, 0.0206, 0.0107), mass=0.002, material="food",
          aliases=("pecan nut", "pecan half"), themes=("kitchen",), roles=("edible",),
          colors=("copper",), state="lying flat")  # fmt: skip
def pecan(look: Look) -> Shape:
    """A pecan half: an oval with a groove and wrinkles."""
    k = look.between(0.9, 1.1)
    color = look.color("copper", "brown", "bronze")
    lobes = [
        bent_rod(0.032, 0.0068, blunt=2.6, bend=-s * 0.002).move(y=s * 0.0048) for s in (-1, 1)
    ]
    tile = surfaces.scratches(look.rng, tint_color(color, 0.9), tint_color(color, 0.6), 60)
    return settle([(join(lobes), tile)], 0.2).scale(k)


@dataclass(frozen=True)
class Heap:
    """A heap of grains: ``r`` is the range of its radius and ``grain`` a grain's size, in metres.

    ``form`` names the shape of a grain: "ball", "chip", "cube", "strand", "ring", or "powder" for
    no visible grains.
    """

    r: tuple[float, float]
    grain: float
    form: str
    colors: tuple[str, ...]
    steep: float = 0.5


def _grain(form: str, d: float) -> Solid:
    if form == "ball":
        return ellipsoid(d, 0.9 * d, 0.8 * d, 6, 4)
    if form == "chip":
        return box(d, 0.7 * d, 0.25 * d).move(z=-0.12 * d)
    if form == "strand":
        return tube([(-d, 0, 0), (-0.3 * d, 0.25 * d, 0.1 * d), (d, -0.1 * d, 0)], 0.17 * d, 4)
    if form == "ring":
        return torus(0.5 * d, 0.16 * d, 9, 4)
    if form == "disc":
        return cylinder(0.5 * d, 0.25 * d, 9)
    return box(d, d, d).move(z=-0.5 * d)


def heap(kind: Heap) -> Callable[[Look], Shape]:
    """Return the shape function of the heap that ``kind`` describes."""

    def make(look: Look) -> Shape:
        r, color = look.between(*kind.r), look.color(*kind.colors)
        h = kind.steep * r * look.between(0.85, 1.15)
        core = ellipsoid(2 * r, 2 * r * look.between(0.85, 1), 2 * h, 20, 10)
        lumps = look.between(0, 6)
        core = core.bend(lambda p: p * (1 + 0.06 * np.sin(
            7 * p[:, :1] / r + lumps) * np.cos(6 * p[:, 1:2] / r)))  # fmt: skip
        dark, fine = tint_color(color, 0.8), kind.form == "powder"
        ground = surfaces.spots(look.rng, color if fine else dark, dark, 0.2 if fine else 0.3)
        pieces = [(core, ground)]
        if not fine:
            most = 110 if kind.form == "strand" else 80
            count = int(np.clip(2.2 * (r / kind.grain) ** 2, 14, most))
            count = most if kind.form == "strand" else count
            groups: tuple[list[Solid], ...] = ([], [], [])
            for k in range(count):
                t = (k + 0.5) / count * 1.25
                a, out = 2.4 * k, min(np.sqrt(t), 1.0) * r * (1 if t < 1 else look.between(1, 1.12))
                up = h * np.sqrt(max(1 - min(t, 1), 0)) + 0.3 * kind.grain
                one = _grain(kind.form, kind.grain * look.between(0.85, 1.15))
                one = one.turn(0, look.between(-0.6, 0.6)).turn(1, look.between(-0.6, 0.6))
                one = one.turn(2, look.between(0, 6.3))
                groups[k % 3].append(one.move(out * np.cos(a), out * np.sin(a), up))
            for group, tone in zip(groups, (1.0, 0.9, 1.12), strict=True):
                pieces.append((join(group), surfaces.plain(tint_color(color, tone))))
        cut = [(s.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])), t)
               for s, t in pieces]  # fmt: skip
        return shape(cut, [flat_foot(cut[0][0].vertices, 0.2)])

    return make


@category("walnut", size=(0.0428, 0.0378, 0.0352), mass=0.012, material="food",
          aliases=("walnut half", "walnut shell", "peach pit"), themes=("kitchen", "food"),
          roles=("edible",), colors=("tan",))  # fmt: skip
def walnut(look: Look) -> Shape:
    """A walnut in its wrinkled shell, with an upright seam."""
    d = look.between(0.034, 0.04)
    color = look.color("tan", "wooden", "beige")
    phase = look.rng.uniform(0, 6, 2)

    def warp(p: np.ndarray) -> np.ndarray:
        wave = 0.03 * np.sin(p @ np.array([420, 300, 360]) + phase[0])
        wave = wave + 0.03 * np.sin(p @ np.array([-350, 420, 260]) + phase[1])
        seam = 0.07 * np.exp(-((p[:, 1] / (0.06 * d)) ** 2))
        return p * (1 + wave + seam)[:, None]

    body = ellipsoid(1.1 * d, d, d, 34, 22).bend(warp)
    shell = surfaces.spots(look.rng, color, tint_color(color, 0.72), 0.25)
    return settle([(body, shell)], 0.12)


@category("almond", size=(0.0253, 0.0144, 0.00734), mass=0.0014, material="food",
          aliases=("pine nut", "pine kernel"), themes=("kitchen", "food"), roles=("edible",),
          colors=("brown",), state="lying flat")  # fmt: skip
def almond(look: Look) -> Shape:
    """An almond lying flat with its point on the left."""
    long = look.between(0.023, 0.028)
    color = look.color("copper", "brown", "bronze")
    body = limb([(-0.5 * long, 0, 0), (-0.2 * long, 0, 0), (0.15 * long, 0, 0), (0.42 * long, 0, 0),
                 (0.5 * long, 0, 0)], [0.0004, 0.005, 0.0072, 0.005, 0.001], 16, 0.6)  # fmt: skip
    return settle([(body, surfaces.stripes([tint_color(color, 0.9), tint_color(color, 0.72)], 9,
                                           upright=True))], 0.15)  # fmt: skip


@category("hazelnut", size=(0.0191, 0.0191, 0.0191), mass=0.003, material="food",
          aliases=("macadamia", "filbert", "macadamia nut", "cobnut", "beechnut"),
          themes=("kitchen", "food"), roles=("edible", "round"), colors=("copper",))  # fmt: skip
def hazelnut(look: Look) -> Shape:
    """A hazelnut with its tip up and a pale scar at the bottom."""
    r = look.between(0.0085, 0.0105)
    color = look.color("copper", "bronze", "brown")
    body = lathe([(0, 0), (0.55 * r, 0), (0.92 * r, 0.5 * r), (r, 0.95 * r), (0.75 * r, 1.5 * r),
                  (0.3 * r, 1.86 * r), (0, 2.0 * r)], 24)  # fmt: skip
    tile = surfaces.stack((surfaces.plain((222, 190, 140)), 0.3), (streaks(
        look.rng, color, tint_color(color, 0.7), 14), 0.7))  # fmt: skip
    return shape([(body, tile)], [hull_of(body)])


@category("peanut", size=(0.0414, 0.0165, 0.0144), mass=0.002, material="food",
          aliases=("groundnut", "monkey nut"), themes=("kitchen", "food"), roles=("edible",),
          colors=("tan",), state="lying flat")  # fmt: skip
def peanut(look: Look) -> Shape:
    """A peanut in its waisted shell, lying flat."""
    long, r = look.between(0.036, 0.044), look.between(0.0075, 0.009)
    body = limb([(-0.5 * long, 0, 0), (-0.42 * long, 0, 0), (-0.24 * long, 0.001, 0), (0, 0.002, 0),
                 (0.24 * long, 0.001, 0), (0.42 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.1 * r, 0.7 * r, r, 0.72 * r, 1.02 * r, 0.75 * r, 0.1 * r], 16)  # fmt: skip
    color = look.color("tan", "beige", "wooden")
    y, x = np.mgrid[0:96, 0:96]
    net = (np.abs(np.sin(np.pi * x / 12)) < 0.25) | (np.abs(np.sin(np.pi * y / 12)) < 0.25)
    tile = np.where(net[..., None], np.array(tint_color(color, 0.78)), np.array(color))
    return settle([(body, tile.astype(np.uint8))], 0.13)


@category("cashew", size=(0.0244, 0.0128, 0.00952), mass=0.0016, material="food",
          aliases=("cashew nut",), themes=("kitchen", "food"), roles=("edible",), colors=("cream",),
          state="lying flat")  # fmt: skip
def cashew(look: Look) -> Shape:
    """A curved cashew, lying flat."""
    k = look.between(0.9, 1.15)
    a = np.linspace(0.3, 2.85, 7)
    path = np.column_stack([0.0105 * np.cos(a), 0.009 * np.sin(a), 0 * a])
    color = look.color("cream", "beige", "tan")
    body = limb(path, [0.0012, 0.0042, 0.0052, 0.0052, 0.0055, 0.0048, 0.0012], 14)
    return settle([(body, surfaces.speckles(look.rng, color, 8))], 0.15).scale(k)


@category("pistachio", size=(0.0205, 0.0144, 0.00806), mass=0.0012, material="food",
          aliases=("pistachio nut",), themes=("kitchen", "food"), roles=("edible",),
          colors=("beige",), state="lying flat")  # fmt: skip
def pistachio(look: Look) -> Shape:
    """A pistachio with a pale shell that is open over the green kernel."""
    k = look.between(0.9, 1.15)
    color = look.color("beige", "cream", "tan")
    whole = bent_rod(0.02, 0.0058, blunt=2.3, squash=0.8)
    half = whole.bend(lambda p: np.column_stack([p[:, 0], np.maximum(p[:, 1], 0), p[:, 2]]))
    shells = [half.turn(2, 0.22).move(y=0.0007), half.turn(2, np.pi - 0.22).move(y=-0.0007)]
    nut = bent_rod(0.016, 0.0044, blunt=2.5, squash=0.9).move(x=0.001, z=0.0006)
    return settle([(join(shells), surfaces.speckles(look.rng, color, 6)),
                   (nut, surfaces.spots(look.rng, (140, 160, 76), (120, 80, 84), 0.25))],
                  0.15).scale(k)  # fmt: skip


@category("chestnut", size=(0.0311, 0.0257, 0.0273), mass=0.012, material="food",
          aliases=("conker", "sweet chestnut"), themes=("kitchen", "food"),
          roles=("edible", "round"), colors=("brown",))  # fmt: skip
def chestnut(look: Look) -> Shape:
    """A glossy chestnut with a pale scar."""
    d = look.between(0.028, 0.034)
    color = look.color("maroon", "brown", "copper")
    body = lathe([(0, 0), (0.3, 0), (0.48, 0.16), (0.5, 0.36), (0.36, 0.62), (0.12, 0.78),
                  (0.05, 0.86), (0, 0.87)], 26)  # fmt: skip
    tile = surfaces.stack((surfaces.plain((214, 180, 132)), 0.36), (streaks(
        look.rng, tint_color(color, 0.75), tint_color(color, 0.55), 16), 0.64))  # fmt: skip
    body = body.scale(d, 0.82 * d, d)
    return shape([(body, tile)], [hull_of(body)])


CATEGORIES = (
    Category("sunflower_seed", seed(("black", "charcoal"), (0.014, 0.0075, 0.0042), True),
             size=(0.0145, 0.00775, 0.00434), mass=0.0002, material="food",
             aliases=("striped seed",), themes=("kitchen",), roles=("edible",), colors=("black",),
             state="lying flat"),
    Category("pumpkin_seed", seed(("ivory", "olive", "cream"), (0.017, 0.0095, 0.003), False),
             size=(0.0174, 0.00973, 0.00307), mass=0.0002, material="food",
             aliases=("seed", "squash seed", "melon seed", "apple pip", "pip", "pepita"),
             themes=("kitchen",), roles=("edible",), colors=("ivory",), state="lying flat"),
    Category("chopped_nuts", heap(Heap((0.026, 0.036), 0.006, "cube", ("tan", "copper", "beige"))),
             size=(0.0754, 0.076, 0.0222), mass=0.03, material="food", aliases=("chopped nut",
             "crushed nut", "flaked almond", "chopped walnut", "heap of chopped nuts",
             "pile of chopped nuts", "mound of chopped nuts", "chopped nuts heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("tan",), state="heaped"),
    Category("sesame_seeds", heap(Heap((0.016, 0.024), 0.003, "ball", ("cream", "beige", "black"))),
             size=(0.0455, 0.0466, 0.0122), mass=0.01, material="food", aliases=("sesame seed",
             "mustard seed", "poppy seed", "chia seed", "cumin seed", "fennel seed",
             "coriander seed", "heap of sesame seeds", "pile of sesame seeds",
             "mound of sesame seeds", "sesame seeds heap"), themes=("kitchen", "food"),
             roles=("edible",), colors=("cream",), state="heaped"),
    Category("bird_seed", heap(Heap((0.03, 0.04), 0.004, "ball", ("tan", "mustard", "beige"))),
             size=(0.076, 0.077, 0.0195), mass=0.03, material="food", aliases=("birdseed",
             "hamster food", "seed mix", "heap of bird seed", "pile of bird seed",
             "mound of bird seed", "bird seed heap"), themes=("kitchen", "food"), roles=("edible",),
             colors=("tan",), state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
