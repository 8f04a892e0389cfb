"""Objects of the ``kitchen`` theme: leafy vegetables."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.primitives import blade, limb
from ...kit.shapes import Category, Shape, category, keep_still, settle
from ...kit.solids import Solid, cylinder, ellipsoid, join, outward
from ...kit.surfaces import Look, tint_color
from .vegetables import Pod, leafy, pod_of


def _stalked_leaf(
    long: tuple[float, float], stalks: tuple[str, ...], thick: float, leaf: float, count: int
) -> Callable[[Look], Shape]:
    """Return the shape function of leaves lying flat, with broad stalks that meet at the base."""

    def make(look: Look) -> Shape:
        size, stalk = look.between(*long), look.color(*stalks)
        green = look.own_color("green", "green", "olive", spread=12)
        low, tops = [], []
        for k in range(count):
            s = (k - (count - 1) / 2) / count
            z = 0.012 + 0.012 * (k % 2)
            mid = (-0.05 * size, 0.25 * size * s, z)
            low.append(limb([(-0.5 * size, 0.06 * size * s, 0.014), (-0.28 * size, 0.2 * size * s,
                z),
                             mid, (0.2 * size, 0.5 * size * s, z)],
                            [thick * size, 1.1 * thick * size, 0.5 * thick * size,
                             0.1 * thick * size], 8, 0.7))  # fmt: skip
            tops.append(blade([(-0.1 * size, 0.24 * size * s, z), (0.15 * size, 0.5 * size * s,
                z + 0.006),
                               (0.5 * size, 0.8 * size * s, 0.4 * z)], leaf * size,
                               thick=0.12))  # fmt: skip
        return settle([(join(low), surfaces.speckles(look.rng, stalk, 6)),
                       (join(tops), leafy(look, green))], 0.16)  # fmt: skip

    return make


@category("radicchio", size=(0.115, 0.123, 0.0757), mass=0.3, material="food",
          themes=("kitchen", "food"), roles=("edible", "round"), colors=("maroon",))  # fmt: skip
def radicchio(look: Look) -> Shape:
    """A head of radicchio with dark red leaves and white ribs."""
    color = look.color("maroon", "crimson", "purple")
    return settle([(head(look, look.between(0.045, 0.056), 8, 0.12), leafy(look, color))], 0.07)


@category("brussels_sprout", size=(0.046, 0.0428, 0.0272), mass=0.02, material="food",
          aliases=("sprout", "brussel sprout"), themes=("kitchen", "food"),
          roles=("edible", "round"), colors=("lime",))  # fmt: skip
def brussels_sprout(look: Look) -> Shape:
    """A Brussels sprout: a small, tight head with a cut base."""
    r = look.between(0.014, 0.019)
    color = look.color("lime", "green", "sage")
    ball = head(look, r, 6, 0.02)
    foot = cylinder(0.4 * r, 0.3 * r, 12).move(z=-0.16 * r)
    return settle([(ball, leafy(look, color)), (foot, surfaces.plain((240, 236, 200)))], 0.1,
                  hulls=[[0]])  # fmt: skip


def head(look: Look, r: float, layers: int, frill: float) -> Solid:
    """Return a head of lettuce, cabbage or the like: ``layers`` cupped leaves around a ball."""
    made = [ellipsoid(1.7 * r, 1.7 * r, 1.6 * r, 18, 10).move(z=0.82 * r)]
    for k in range(layers):
        turn = 2.4 * k
        size = r * (0.82 + 0.3 * k / layers)
        high = 1.75 - 0.35 * k / layers

        def cup(p: np.ndarray, size: float = size, high: float = high) -> np.ndarray:
            u, v = p[:, 0], p[:, 2]  # horizontal and vertical coordinates, both about -1 to 1
            t = np.clip(0.5 + 0.5 * v, 0, 1)
            out = size * (0.42 + 0.62 * np.sin(np.pi * (0.12 + 0.62 * t)))
            out = out + frill * size * t**3 * (0.5 + 0.5 * np.sin(9 * u))
            a = 1.05 * u * (0.55 + 0.45 * np.sin(np.pi * t))
            lift = high * size * 0.92 * t * (1 - 0.1 * u * u)
            thick = p[:, 1]
            return np.column_stack([(out + thick) * np.cos(a), (out + thick) * np.sin(a), lift])

        n, m = 10, 7
        sheet = ellipsoid(2, 0.012, 2, 2 * n, m)
        made.append(outward(sheet.bend(cup)).turn(2, turn))
    return join(made)


@category("lettuce", size=(0.173, 0.173, 0.104), mass=0.35, material="food",
          aliases=("head of lettuce", "lettuce head", "salad head", "kale", "iceberg lettuce"),
          themes=("kitchen", "food"), roles=("edible", "round"), colors=("lime",))  # fmt: skip
def lettuce(look: Look) -> Shape:
    """A head of lettuce with frilled leaves."""
    r = look.between(0.062, 0.075)
    color = look.color("lime", "green", "lime", "maroon")
    leaves = head(look, r, 9, 0.4)
    return settle([(leaves, leafy(look, tint_color(color, 1.05)))], 0.06)


@category("cabbage", size=(0.161, 0.165, 0.108), mass=0.9, material="food",
          aliases=("head of cabbage", "cabbage head"), themes=("kitchen", "food"),
          roles=("edible", "round"), colors=("sage", "purple"))  # fmt: skip
def cabbage(look: Look) -> Shape:
    """A round green, white or red cabbage with slightly open outer leaves."""
    r = look.between(0.068, 0.08)
    color = look.color("lime", "purple", "sage")
    return settle([(head(look, r, 7, 0.08), leafy(look, color))], 0.07)


CATEGORIES = (
    Category("pak_choi", _stalked_leaf((0.17, 0.2), ("white", "ivory", "sage"), 0.075, 0.3, 7),
             size=(0.188, 0.133, 0.0279), mass=0.15, material="food", assembled=True,
             aliases=("bok choy", "pak choy", "bok choi", "chinese cabbage", "napa cabbage",
             "chinese leaf"), themes=("kitchen", "food"), roles=("edible",), colors=("green",),
             state="lying flat"),
    Category("chard",
             _stalked_leaf((0.26, 0.31), ("crimson", "yellow", "white", "pink"), 0.03, 0.26, 5),
             size=(0.29, 0.192, 0.0238), mass=0.2, material="food", assembled=True,
             aliases=("swiss chard", "rainbow chard", "silverbeet", "chard leaf"),
             themes=("kitchen", "food"), roles=("edible",), colors=("crimson",),
             state="lying flat"),
    Category("spinach", _stalked_leaf((0.13, 0.16), ("lime", "sage", "pink"), 0.018, 0.3, 8),
             size=(0.141, 0.103, 0.0227), mass=0.1, material="food", assembled=True,
             aliases=("spinach bunch", "bunch of spinach", "spinach leaf", "baby spinach",
             "fresh spinach"), themes=("kitchen", "food"), roles=("edible",), colors=("green",),
             state="lying flat"),
    Category("endive", keep_still(pod_of(Pod((0.13, 0.16), (0.14, 0.17, 0.16, 0.1, 0.015), ("cream",
             "ivory", "lime"), 0.01, "streaks"))), size=(0.149, 0.0507, 0.0425), mass=0.12,
             material="food", aliases=("chicory", "chicory head", "witloof"),
             themes=("kitchen", "food"), roles=("edible",), colors=("cream",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
