"""Small heaps of loose or chopped things: one form of many grains and colours."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...build.category import Category
from ...build.collision import flat_foot
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


@dataclass(frozen=True)
class Heap:
    """A heap: ``r`` its least and greatest radius and ``grain`` a grain's size, metres.

    ``form`` names a grain's form: "ball", "chip", "cube", "strand", "ring" or "powder" for none.
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
    """Return the shape function of one kind of heap."""

    def make(look: Look) -> Shape:
        r, color = look.between(*kind.r), look.color(*kind.colors)
        h = kind.steep * r * look.between(0.85, 1.15)
        core = ellipsoid(2 * r, 2 * r * look.between(0.85, 1), 2 * h, 20, 10)
        lumps = look.between(0, 6)
        core = core.bend(lambda p: p * (1 + 0.06 * np.sin(
            7 * p[:, :1] / r + lumps) * np.cos(6 * p[:, 1:2] / r)))  # fmt: skip
        dark, fine = tint_color(color, 0.8), kind.form == "powder"
        ground = textures.spots(look.rng, color if fine else dark, dark, 0.2 if fine else 0.3)
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
                pieces.append((join(group), textures.plain(tint_color(color, tone))))
        cut = [(s.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])), t)
               for s, t in pieces]  # fmt: skip
        return shape(cut, [flat_foot(cut[0][0].vertices, 0.2)])

    return make


_K = ("kitchen", "food")


def _row(
    key: str, kind: Heap, mass: float, size: tuple[float, float, float], *aliases: str
) -> Category:
    noun = key.replace("_", " ").removesuffix(" heap")
    piled = (f"heap of {noun}", f"pile of {noun}", f"mound of {noun}")
    piled = piled if key.endswith("_heap") else (*piled, f"{noun} heap")
    return Category(key, heap(kind), size, mass, (*aliases, *piled), _K, ("edible",),
                    (kind.colors[0],), state="heaped")  # fmt: skip


CATEGORIES = (
    _row("kibble", Heap((0.028, 0.036), 0.009, "ball", ("brown", "copper", "tan", "bronze")), 0.03,
         (0.0722, 0.0722, 0.0228), "dry dog food", "dry cat food", "pet kibble", "dog kibble",
         "cat kibble",
         "cat biscuit"),
    _row("peppercorn_heap", Heap((0.018, 0.026), 0.005, "ball", ("black", "charcoal", "brown",
        "red")),
         0.01, (0.0504, 0.051, 0.0151)),
    _row("lemon_zest", Heap((0.018, 0.026), 0.006, "strand", ("yellow", "gold", "yellow")), 0.005,
         (0.0542, 0.0547, 0.0166), "orange zest", "lime zest", "citrus zest", "grated lemon zest"),
    _row("chopped_parsley", Heap((0.024, 0.034), 0.005, "chip", ("green", "green", "lime")), 0.01,
         (0.0662, 0.0663, 0.0178), "chopped herb", "chopped coriander", "chopped cilantro",
         "chopped basil",
         "chopped chive", "chopped dill", "chopped mint", "dried oregano", "dried herb"),
    _row("chopped_onion", Heap((0.03, 0.042), 0.007, "cube", ("white", "ivory", "lavender")), 0.06,
         (0.0859, 0.0862, 0.0251), "diced onion", "chopped shallot", "chopped garlic",
         "minced garlic"),
    _row("chopped_carrot", Heap((0.03, 0.042), 0.01, "disc", ("orange", "orange", "amber")), 0.06,
         (0.0857, 0.0842, 0.026), "diced carrot", "sliced carrot"),
    _row("chopped_pepper", Heap((0.03, 0.042), 0.009, "chip", ("red", "green", "yellow")), 0.06,
         (0.0877, 0.0879, 0.0248), "diced pepper", "chopped chilli", "chopped tomato",
         "diced tomato",
         "chopped bell pepper", "chopped vegetable"),
    _row("chopped_nuts", Heap((0.026, 0.036), 0.006, "cube", ("tan", "copper", "beige")), 0.03,
         (0.0754, 0.076, 0.0222), "chopped nut", "crushed nut", "flaked almond", "chopped walnut"),
    _row("sliced_spring_onion", Heap((0.024, 0.034), 0.007, "ring", ("lime", "green", "sage")),
         0.01, (0.0668, 0.0666, 0.0182), "chopped spring onion", "sliced leek", "sliced scallion"),
    _row("grated_cheese", Heap((0.03, 0.042), 0.009, "strand", ("yellow", "cream", "amber")), 0.04,
         (0.0877, 0.084, 0.0238), "shredded cheese", "grated cheddar", "grated parmesan",
         "grated carrot",
         "shredded cabbage"),
    _row("breadcrumbs", Heap((0.03, 0.042), 0.004, "cube", ("tan", "beige", "wooden")), 0.03,
         (0.0871, 0.0861, 0.0219), "breadcrumb", "bread crumb", "crumb", "cookie crumb",
         "crouton crumb"),
    _row("sea_salt", Heap((0.02, 0.03), 0.003, "cube", ("white", "pink", "ivory")), 0.02,
         (0.0564, 0.0561, 0.0158), "coarse salt", "salt crystal", "rock salt", "himalayan salt",
         "bath salt"),
    _row("ground_spice", Heap((0.02, 0.03), 0.003, "powder", ("terracotta", "mustard", "copper",
         "brown", "olive")), 0.015, (0.0463, 0.0432, 0.0115), "ground cinnamon", "turmeric powder",
         "curry powder", "ground cumin", "chilli powder", "spice powder"),
    _row("sesame_seeds", Heap((0.016, 0.024), 0.003, "ball", ("cream", "beige", "black")), 0.01,
         (0.0455, 0.0466, 0.0122), "sesame seed", "mustard seed", "poppy seed", "chia seed",
         "cumin seed",
         "fennel seed", "coriander seed"),
    _row("bird_seed", Heap((0.03, 0.04), 0.004, "ball", ("tan", "mustard", "beige")), 0.03,
         (0.076, 0.077, 0.0195), "birdseed", "hamster food", "seed mix"),
    _row("chocolate_chips", Heap((0.026, 0.036), 0.008, "ball", ("brown", "maroon", "cream")),
         0.03, (0.0697, 0.0691, 0.021), "chocolate chip", "choc chip", "cocoa nib"),
    _row("sprinkles", Heap((0.016, 0.024), 0.004, "strand", ("pink", "sky", "yellow", "red")), 0.01,
         (0.0472, 0.0465, 0.0132), "sprinkle", "hundreds and thousands", "cake sprinkle"),
    _row("raisin_heap", Heap((0.026, 0.036), 0.008, "ball", ("maroon", "brown", "black")), 0.03,
         (0.0725, 0.0729, 0.0211), "heap of sultana", "handful of raisin"),
    _row("croutons", Heap((0.03, 0.04), 0.012, "cube", ("wooden", "tan", "amber")), 0.03,
         (0.0855, 0.0836, 0.0304), "pile of croutons", "heap of croutons"),
    _row("desiccated_coconut", Heap((0.024, 0.034), 0.006, "strand", ("white", "ivory", "white")),
         0.01, (0.0674, 0.0682, 0.02), "coconut flake", "shredded coconut", "grated coconut"),
)  # fmt: skip
"""The module's categories."""
