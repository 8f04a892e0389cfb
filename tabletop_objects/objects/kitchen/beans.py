"""Objects of the ``kitchen`` theme: beans and peas."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.primitives import bent_rod, limb
from ...kit.shapes import Shape, category, settle
from ...kit.solids import ellipsoid, join
from ...kit.surfaces import Look, tint_color


@category("coffee_bean", size=(0.0128, 0.00939, 0.00643), mass=0.0002, material="food",
          aliases=("roasted coffee bean", "espresso bean"), themes=("kitchen",), roles=("edible",),
          colors=("brown",), state="lying flat")  # fmt: skip
def coffee_bean(look: Look) -> Shape:
    """A roasted coffee bean with its groove up."""
    k = look.between(0.9, 1.2)
    color = look.color("brown", "brown", "bronze")
    half = bent_rod(0.0125, 0.0046, blunt=2.3, squash=0.75)
    groove = limb([(-0.0048, 0.0004, 0.0019), (-0.0018, -0.0005, 0.0031), (0.0018, 0.0005, 0.0031),
                   (0.0048, -0.0004, 0.0019)], [0.0006] * 4, 6)  # fmt: skip
    tone = tint_color(color, 0.75)
    return settle([(half, surfaces.speckles(look.rng, tone, 8)),
                   (groove, surfaces.plain(tint_color(tone, 0.45)))], 0.16).scale(k)  # fmt: skip


@category("pea_pod", size=(0.0984, 0.0249, 0.0147), mass=0.01, material="food",
          aliases=("pod of peas", "peapod", "edamame", "snap pea", "sugar snap", "edamame pod"),
          themes=("kitchen", "food"), roles=("edible",), colors=("green",),
          state="lying flat")  # fmt: skip
def pea_pod(look: Look) -> Shape:
    """An open pea pod with peas, lying flat."""
    long = look.between(0.075, 0.092)
    color = look.color("green", "lime", "green")
    half = bent_rod(long, 0.0085, blunt=3, bend=0.008, squash=0.8)
    low = half.bend(lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0.001)]))
    rim = limb([(-0.5 * long, 0.004, 0.001), (0, -0.0125, 0.002), (0.5 * long, 0.004, 0.001)],
               [0.0008, 0.0012, 0.0008], 6)  # fmt: skip
    peas = [ellipsoid(d := 0.0125 - 0.012 * abs(u), d, d, 14, 8).move(
            u * long, 0.032 * u * u - 0.004, 0.0035)
            for u in (-0.3, -0.15, 0.0, 0.15, 0.3)]  # fmt: skip
    stalk = limb([(0.48 * long, 0.004, 0), (0.58 * long, 0.006, 0.002), (0.64 * long, 0.01, 0.004)],
                 [0.0025, 0.0016, 0.0016], 7)  # fmt: skip
    return settle([(join([low, rim, stalk]), surfaces.speckles(look.rng, tint_color(color, 0.85),
                                                               8)),
                   (join(peas), surfaces.plain(tint_color(color, 1.25)))], 0.1)  # fmt: skip


@category("green_bean", size=(0.12, 0.0205, 0.00735), mass=0.007, material="food",
          aliases=("string bean", "runner bean", "french bean"), themes=("kitchen", "food"),
          roles=("edible",), colors=("green",), state="lying flat")  # fmt: skip
def green_bean(look: Look) -> Shape:
    """A long, slightly bent green bean, lying flat."""
    long, r = look.between(0.11, 0.14), look.between(0.0042, 0.0052)
    color = look.color("green", "green", "lime", "yellow")
    bend = look.between(0.01, 0.024)
    u = np.linspace(-0.5, 0.5, 9)
    body = limb(np.column_stack([u * long, 4 * bend * u * u, 0 * u]), [0.0007, 0.8 * r, r, 0.92 * r,
                                                                       r, 0.92 * r, r, 0.75 * r,
                                                                       0.0012], 12)  # fmt: skip
    return settle([(body, surfaces.speckles(look.rng, tint_color(color, 0.92), 12))], 0.2)


@category("bean", size=(0.0174, 0.00968, 0.00676), mass=0.0008, material="food",
          aliases=("kidney bean", "lentil"), themes=("kitchen", "food"), roles=("edible",),
          colors=("maroon",), state="lying flat")  # fmt: skip
def bean(look: Look) -> Shape:
    """A kidney bean, lying on its side."""
    long, r = look.between(0.015, 0.019), look.between(0.0042, 0.0052)
    color = look.color("maroon", "brown", "white", "black", "tan")
    body = bent_rod(long, r, blunt=2.6, bend=0.32 * r * 2, squash=0.85)
    return settle([(body, surfaces.speckles(look.rng, color, 8))], 0.15)


@category("pea", size=(0.00895, 0.00895, 0.00747), mass=0.0006, material="food",
          aliases=("chickpea",), themes=("kitchen", "food"), roles=("edible", "round"),
          colors=("green",))  # fmt: skip
def pea(look: Look) -> Shape:
    """A single green pea or chickpea."""
    d = look.between(0.008, 0.0105)
    color = look.color("green", "lime", "green")
    return settle(
        [(ellipsoid(d, d, 0.96 * d, 16, 10), surfaces.speckles(look.rng, color, 8))], 0.13
    )
