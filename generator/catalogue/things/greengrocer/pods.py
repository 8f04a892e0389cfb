"""Long vegetables, pods and spices that lie: one bent rod of many thicknesses and colours."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...build.category import Category
from ...build.forms import blade, streaks
from ...build.settled import limb, settle
from ...build.shape import Shape
from ...build.solids import cylinder, ellipsoid, join, lathe
from ...build.variants import at_rest, keep_still
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

GREEN: RGB = (92, 140, 62)


@dataclass(frozen=True)
class Pod:
    """A long thing: ``long`` its least and greatest length, metres.

    ``r`` gives its radius, in lengths, from left to right; ``bend`` how far it curves, in lengths;
    ``skin`` names its surface, ``end`` what grows at its right end.
    """

    long: tuple[float, float]
    r: tuple[float, ...]
    colors: tuple[str, ...]
    bend: float = 0.05
    skin: str = "speckles"
    end: str = ""


def _skin(look: Look, pod: Pod, color: RGB) -> textures.Tile:
    if pod.skin == "rings":
        return textures.stripes([color, color, color, tint_color(color, 0.8)], 9)
    if pod.skin == "ribs":
        return textures.stripes([color, tint_color(color, 0.78)], 7, upright=True)
    if pod.skin == "streaks":
        return streaks(look.rng, tint_color(color, 0.8), tint_color(color, 1.3), 12)
    if pod.skin == "white foot":
        return textures.gradient((246, 244, 226), color, look.rng)
    return textures.speckles(look.rng, color, 10)


def pod_of(pod: Pod) -> Callable[[Look], Shape]:
    """Return the shape function of one kind of long thing."""

    def make(look: Look) -> Shape:
        long, color = look.between(*pod.long), look.color(*pod.colors)
        bend = long * pod.bend * look.between(0.6, 1.4)
        x = np.linspace(-0.5, 0.5, len(pod.r))
        path = np.column_stack([x * long, bend * 4 * x * x, 0 * x])
        body = limb(path, [long * r for r in pod.r], 14)
        pieces = [(body, _skin(look, pod, color))]
        r, tip = long * max(pod.r), (0.5 * long, bend, 0.0)
        if pod.end == "stub":
            stub = limb([(tip[0] - 0.3 * r, bend, 0), (tip[0] + 0.5 * r, bend, 0),
                         (tip[0] + 1.1 * r, 1.1 * bend, 0.1 * r)], [0.6 * r, 0.4 * r, 0.34 * r],
                         8)  # fmt: skip
            pieces.append((stub, textures.plain((140, 158, 88))))
        elif pod.end == "stem":
            stem = limb([tip, (tip[0] + 0.12 * long, 1.5 * bend, 0)], [0.16 * r, 0.12 * r], 6)
            pieces.append((stem, textures.plain(tint_color(color, 0.6))))
        elif pod.end == "leaves":
            tuft = [blade([(tip[0] - 0.4 * r, bend, 0), (tip[0] + 1.5 * r, bend + 1.2 * r * s, 0),
                           (tip[0] + 4 * r, bend + 2 * r * s, -0.6 * r)], 0.9 * r, thick=0.25)
                    for s in (-1, -0.4, 0.3, 1)]  # fmt: skip
            pieces.append((join(tuft), textures.leaf(look.rng, GREEN)))
        elif pod.end == "head":
            head = ellipsoid(3.2 * r, 3 * r, 3 * r, 14, 8).move(tip[0] + 0.8 * r, bend, 0)
            pieces.append((head, textures.plain((236, 206, 104))))
        return settle(pieces, 0.14, hulls=[[0]])

    return make


def clove(look: Look) -> Shape:
    """A clove, the spice: a nail with a four-cornered crown, lying."""
    color = look.color("brown", "bronze", "maroon", "black")
    k = look.between(0.9, 1.25)
    stem = lathe([(0, 0), (0.0011, 0.0005), (0.0015, 0.006), (0.0021, 0.0095), (0, 0.0105)], 10)
    crown = [blade([(0, 0, 0.0085), (0.0016, 0, 0.0105), (0.0038, 0, 0.0118)], 0.0022).turn(2, a)
             for a in np.pi / 2 * np.arange(4) + 0.4]  # fmt: skip
    bud = ellipsoid(0.0032, 0.0032, 0.003, 10, 6).move(z=0.0118)
    dark, pale = textures.speckles(look.rng, color, 12, 32), textures.plain(tint_color(color, 1.3))
    laid = [(s.turn(1, np.pi / 2), t) for s, t in ((join([stem, *crown]), dark), (bud, pale))]
    return settle(laid, 0.16).scale(k)


def cinnamon_stick(look: Look) -> Shape:
    """A quill of cinnamon: a rolled bark, two scrolls side by side, lying."""
    long, r = look.between(0.07, 0.1), look.between(0.0055, 0.0075)
    color = look.color("copper", "brown", "terracotta", "bronze")
    scroll = lathe([(0.62 * r, 0), (r, 0), (r, long), (0.62 * r, long)], 18, loop=True)
    core = cylinder(0.3 * r, 0.98 * long, 10).move(z=0.01 * long)
    made = [s.turn(1, np.pi / 2).move(-0.5 * long, y, 0) for s in (scroll, core)
            for y in (-0.85 * r, 0.85 * r)]  # fmt: skip
    grain = textures.stripes([color, tint_color(color, 0.85), color], 8, upright=True)
    return settle([(join(made), grain)], 0.12)


_K = ("kitchen", "food")


def _row(
    key: str, pod: Pod, mass: float, size: tuple[float, float, float], *aliases: str
) -> Category:
    return Category(key, keep_still(pod_of(pod)), size, mass, aliases, _K, ("edible",),
                    (pod.colors[0],), state="lying flat")  # fmt: skip


CATEGORIES = (
    _row("tamarind_pod", Pod((0.11, 0.15), (0.02, 0.07, 0.085, 0.06, 0.088, 0.06, 0.088, 0.07,
         0.01), ("tan", "bronze", "copper", "brown"), 0.09, "speckles", "stem"), 0.02,
         (0.149, 0.0298, 0.0194),
         "tamarind"),
    _row("vanilla_pod", Pod((0.15, 0.19), (0.006, 0.014, 0.017, 0.016, 0.016, 0.01), ("black",
         "brown", "maroon", "charcoal"), 0.06, "ribs", "stem"), 0.004, (0.192, 0.0185, 0.00489),
         "vanilla bean",
         "vanilla stick"),
    _row("okra", Pod((0.08, 0.11), (0.004, 0.05, 0.075, 0.085, 0.08), ("green", "lime", "green",
         "maroon"), 0.05, "ribs", "stub"), 0.012, (0.105, 0.0203, 0.0136), "lady finger",
         "okra pod"),
    _row("daikon", Pod((0.24, 0.31), (0.006, 0.06, 0.1, 0.105, 0.1, 0.05), ("white", "ivory",
         "cream"), 0.02, "speckles", "leaves"), 0.5, (0.383, 0.114, 0.0479), "mooli",
         "white radish",
         "daikon radish"),
    _row("horseradish", Pod((0.2, 0.26), (0.01, 0.05, 0.06, 0.075, 0.08, 0.07), ("tan", "beige",
         "wooden"), 0.06, "rings", "leaves"), 0.2, (0.299, 0.0729, 0.0303), "horseradish root",
         "salsify"),
    _row("cassava", Pod((0.2, 0.27), (0.02, 0.09, 0.13, 0.14, 0.12, 0.06), ("brown", "bronze",
         "copper"), 0.03, "rings"), 0.5, (0.235, 0.0655, 0.0548), "yuca", "manioc", "cassava root"),
    _row("marrow", Pod((0.25, 0.32), (0.06, 0.14, 0.16, 0.165, 0.15, 0.07), ("green", "lime",
         "green"), 0.02, "streaks", "stub"), 1.2, (0.339, 0.0939, 0.0786), "vegetable marrow"),
    _row("lemongrass", Pod((0.26, 0.33), (0.03, 0.034, 0.026, 0.018, 0.014, 0.01), ("lime", "sage",
         "lime"), 0.03, "white foot"), 0.03, (0.297, 0.0255, 0.0169), "lemongrass stalk",
         "lemon grass",
         "stalk of lemongrass", "lemongrass stick"),
    _row("bean_sprout", Pod((0.05, 0.065), (0.004, 0.016, 0.024, 0.026), ("ivory", "white",
         "cream"), 0.16, "speckles", "head"), 0.001, (0.0618, 0.0126, 0.0039), "beansprout",
         "mung bean sprout"),
    _row("endive", Pod((0.13, 0.16), (0.14, 0.17, 0.16, 0.1, 0.015), ("cream", "ivory", "lime"),
         0.01, "streaks"), 0.12, (0.149, 0.0507, 0.0425), "chicory", "chicory head", "witloof"),
    _row("bamboo_shoot", Pod((0.12, 0.16), (0.14, 0.15, 0.11, 0.06, 0.006), ("tan", "cream",
         "olive"), 0.02, "rings"), 0.2, (0.143, 0.0436, 0.0359)),
    _row("baby_corn", Pod((0.08, 0.1), (0.05, 0.075, 0.075, 0.06, 0.008), ("yellow", "gold",
         "cream"), 0.02, "rings"), 0.012, (0.0887, 0.0138, 0.0115), "babycorn"),
    _row("turmeric", Pod((0.06, 0.085), (0.06, 0.11, 0.09, 0.11, 0.06), ("orange", "amber",
         "mustard"), 0.09, "rings"), 0.02, (0.0749, 0.0184, 0.0133), "turmeric root",
         "fresh turmeric"),
    at_rest(Category("clove", clove, (0.0145, 0.00765, 0.00643), 0.0001, ("whole clove",
             "clove spice"),
             _K, ("edible",),
             ("brown",), state="lying flat")),
    Category("cinnamon_stick", cinnamon_stick, (0.0855, 0.0242, 0.0113), 0.005, ("cinnamon quill",
             "stick of cinnamon", "cinnamon bark"), _K, ("edible",), ("copper",),
             state="lying flat"),
)  # fmt: skip
"""The module's categories."""
