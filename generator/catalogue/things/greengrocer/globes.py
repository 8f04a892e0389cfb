"""Round fruit and spices by the piece: one form of many skins, tops and colours."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from ...build.category import Category
from ...build.forms import blade, streaks
from ...build.settled import settle
from ...build.shape import Shape
from ...build.solids import Solid, cylinder, ellipsoid, join, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

GREEN: RGB = (92, 140, 62)
BROWN: RGB = (112, 84, 54)


@dataclass(frozen=True)
class Globe:
    """A round fruit: ``d`` its smallest and largest width, metres, ``tall`` its height in widths.

    ``skin`` names its surface and ``bumps`` how many warts, spikes or hairs it has; ``top`` names
    what it carries; ``pear`` narrows it upwards; ``lying`` lays it on its side.
    """

    d: tuple[float, float]
    tall: float
    colors: tuple[str, ...]
    skin: str = "smooth"
    blush: RGB | None = None
    top: str = "stem"
    pear: float = 0.0
    bumps: int = 0
    lying: bool = False


def _ways(count: int, low: float = -0.72, high: float = 0.97) -> Float[np.ndarray, "n 2"]:
    """Return polar and azimuth angles of ``count`` points spread evenly over a ball."""
    rise = np.linspace(high, low, count)
    return np.column_stack([np.arccos(rise), 2.4 * np.arange(count)])


def _over(kind: Globe, r: float, one: Callable[[], Solid], sink: float) -> Solid:
    """Return a copy of ``one`` (it stands on z = 0) at every point of the skin, sunk a little."""
    made = []
    for polar, around in _ways(kind.bumps):
        solid = one().move(z=-sink).turn(1, polar).turn(2, around)
        narrow = 1 - kind.pear * np.cos(polar)
        at = r * np.sin(polar) * narrow
        made.append(solid.move(at * np.cos(around), at * np.sin(around),
                    kind.tall * r * np.cos(polar)))  # fmt: skip
    return join(made)


def _top(kind: Globe, r: float) -> list[tuple[Solid, textures.Tile]]:
    z = kind.tall * r
    green, brown = textures.plain(GREEN), textures.plain(BROWN)
    if kind.top == "stem":
        return [(tube([(0, 0, 0.95 * z), (0.05 * r, 0, 1.12 * z + 0.1 * r)], 0.07 * r, 7), brown)]
    if kind.top == "thick":
        return [(tube([(0, 0, 0.9 * z), (0.1 * r, 0, 1.3 * z)], [0.16 * r, 0.13 * r], 8), brown)]
    if kind.top == "calyx":
        leaves = [blade([(0, 0, 0.98 * z), (0.32 * r, 0, 1.05 * z), (0.62 * r, 0, 0.86 * z)],
                        0.5 * r, thick=0.2).turn(2, a)
                  for a in 2 * np.pi * np.arange(4) / 4 + 0.4]  # fmt: skip
        stub = cylinder(0.1 * r, 0.16 * r, 8).move(z=0.98 * z)
        return [(join([*leaves, stub]), textures.plain((124, 134, 74)))]
    if kind.top == "tuft":
        tuft = [blade([(0, 0, 0.95 * z), (0.1 * r, 0, 1.05 * z), (0.22 * r, 0, 1.22 * z)], 0.13 * r)
                .turn(2, 2 * np.pi * k / 5) for k in range(5)]  # fmt: skip
        return [(join(tuft), brown)]
    if kind.top == "leaf":
        leaf = blade([(0, 0, z), (0.5 * r, 0.1 * r, 1.25 * z), (1.3 * r, 0.2 * r, 1.2 * z)],
                     0.6 * r, thick=0.15)  # fmt: skip
        stub = tube([(0, 0, 0.95 * z), (0, 0, 1.1 * z)], 0.07 * r, 7)
        return [(join([leaf, stub]), green)]
    if kind.top == "stalks":
        stalks = []
        for k in range(6):
            a = 2 * np.pi * k / 6
            path = [(0.4 * r * np.cos(a), 0.4 * r * np.sin(a), 0.85 * z),
                    (0.7 * r * np.cos(a), 0.7 * r * np.sin(a), 1.5 * z),
                    (1.15 * r * np.cos(a), 1.15 * r * np.sin(a), 2.1 * z)]  # fmt: skip
            stalks.append(tube(path[:2], 0.07 * r, 6))
            stalks.append(blade(path[1:], 0.5 * r, thick=0.2))
        return [(join(stalks), green)]
    return []


def _peel(look: Look, kind: Globe, color: RGB) -> textures.Tile:
    if kind.skin == "streaks":
        return streaks(look.rng, color, tint_color(color, 1.35), 10)
    if kind.skin == "dark streaks":
        return streaks(look.rng, color, tint_color(color, 0.65), 14)
    if kind.skin in ("spots", "spiky", "warty"):
        return textures.spots(look.rng, color, tint_color(color, 0.78), 0.12)
    if kind.skin == "rings":
        return textures.stripes([color, color, tint_color(color, 0.72)], 8)
    return skin(look, color, kind.blush or tint_color(color, 0.82), 0.7)


def globe(kind: Globe) -> Callable[[Look], Shape]:
    """Return the shape function of one kind of round fruit."""

    def make(look: Look) -> Shape:
        d, color = look.between(*kind.d), look.color(*kind.colors)
        r, wobble = d / 2, look.between(0.94, 1.06)
        body = ellipsoid(d, d, kind.tall * d, 26, 16)
        if kind.pear:
            body = body.bend(lambda p: p * (
                1 - kind.pear * p[:, 2:] / (0.5 * kind.tall * d) * np.array([1, 1,
                    0])))  # fmt: skip
        pieces = [(body, _peel(look, kind, color)), *_top(kind, r)]
        deep = textures.plain(tint_color(color, 0.8))
        if kind.skin == "warty":
            s = 3.0 * r / np.sqrt(kind.bumps)
            pieces.append((_over(kind, r, lambda: ellipsoid(s, s, 0.5 * s, 6, 4), 0.0), deep))
        elif kind.skin == "spiky":
            s = 1.9 * r / np.sqrt(kind.bumps)
            spike = cylinder(s, 1.25 * s, 5, top=0.02 * s)
            pieces.append((_over(kind, r, lambda: spike, 0.25 * s), deep))
        elif kind.skin == "hairy":
            hair = tube([(0, 0, 0), (0.1 * r, 0, 0.24 * r), (0.3 * r, 0, 0.4 * r)],
                        [0.05 * r, 0.035 * r, 0.008 * r], 4)  # fmt: skip
            tips = textures.gradient(color, (168, 186, 84), look.rng)
            pieces.append((_over(kind, r, lambda: hair, 0.0), tips))
        made = [(s.scale(wobble, 1 / wobble, 1), t) for s, t in pieces]
        if kind.lying:
            way = look.between(0, 6.3)
            made = [(s.turn(1, np.pi / 2).turn(2, way), t) for s, t in made]
        return settle(made, 0.1 if kind.skin == "smooth" else 0.14, hulls=[[0]])

    return make


_K = ("kitchen", "food")


def _row(
    key: str, kind: Globe, mass: float, size: tuple[float, float, float], *aliases: str
) -> Category:
    roles = ("edible",) if kind.lying else ("round", "edible")
    big = (*roles, "big") if kind.d[0] > 0.09 else roles
    return Category(key, globe(kind), size, mass, aliases, _K, big, (kind.colors[0],))


CATEGORIES = (
    _row("gooseberry", Globe((0.016, 0.021), 1.12, ("lime", "sage", "lime", "maroon"), "streaks",
         top="tuft"), 0.005, (0.0182, 0.0179, 0.0193)),
    _row("lychee", Globe((0.03, 0.037), 1.05, ("crimson", "coral", "maroon", "pink"), "warty",
         bumps=60), 0.02, (0.0376, 0.0372, 0.0345), "litchi", "lichee"),
    _row("guava", Globe((0.062, 0.078), 1.1, ("lime", "sage", "yellow", "green"), "spots",
         top="tuft", pear=0.12), 0.12, (0.0708, 0.074, 0.076)),
    _row("persimmon", Globe((0.064, 0.078), 0.8, ("orange", "orange", "coral", "amber"),
         top="calyx"), 0.17, (0.0712, 0.0712, 0.0561), "sharon fruit", "kaki"),
    _row("quince", Globe((0.074, 0.088), 1.08, ("yellow", "gold", "lime"), "smooth", (150, 160, 80),
         "tuft", 0.2), 0.22, (0.0823, 0.0868, 0.0898)),
    _row("kumquat", Globe((0.022, 0.027), 1.4, ("orange", "orange", "amber"), "spots", top="leaf",
         lying=True), 0.015, (0.0306, 0.0339, 0.0243)),
    _row("rambutan", Globe((0.034, 0.041), 1.1, ("crimson", "red", "coral"), "hairy", bumps=70),
         0.03, (0.0538, 0.0526, 0.0431)),
    _row("durian", Globe((0.16, 0.19), 1.2, ("olive", "tan", "sage", "mustard"), "spiky",
         top="thick", bumps=130, lying=True), 2.0, (0.215, 0.231, 0.169)),
    _row("jackfruit", Globe((0.17, 0.21), 1.5, ("olive", "green", "sage", "mustard"), "warty",
         top="thick", bumps=80, lying=True), 4.5, (0.271, 0.29, 0.169), "jack fruit", "breadfruit"),
    _row("soursop", Globe((0.1, 0.125), 1.45, ("green", "sage", "green", "olive"), "spiky",
         top="thick", pear=0.2, bumps=90, lying=True), 0.7, (0.182, 0.154, 0.117), "custard apple",
         "cherimoya", "graviola"),
    _row("longan", Globe((0.022, 0.027), 0.98, ("tan", "wooden", "beige"), "spots"), 0.01,
         (0.0253, 0.0253, 0.0239)),
    _row("mangosteen", Globe((0.056, 0.068), 0.9, ("maroon", "purple", "maroon"), top="calyx"),
         0.1, (0.0627, 0.0634, 0.0552)),
    _row("loquat", Globe((0.032, 0.04), 1.2, ("orange", "amber", "yellow"), "smooth", None, "tuft",
         0.14, lying=True), 0.03, (0.0415, 0.0426, 0.032)),
    _row("greengage", Globe((0.035, 0.042), 1.04, ("lime", "olive", "lime", "sage"), "smooth",
         (170, 160, 60)), 0.04, (0.0375, 0.0374, 0.0391)),
    _row("kohlrabi", Globe((0.075, 0.09), 0.9, ("sage", "lime", "purple"), top="stalks"), 0.3,
         (0.0965, 0.0848, 0.106)),
    _row("celeriac", Globe((0.1, 0.12), 0.9, ("tan", "beige", "wooden"), "warty", top="stalks",
         bumps=46), 0.6, (0.126, 0.12, 0.132), "celery root"),
    _row("taro_root", Globe((0.06, 0.075), 1.45, ("brown", "bronze", "copper"), "rings", top="none",
         lying=True), 0.25, (0.0839, 0.0804, 0.0576), "taro", "eddoe"),
    _row("physalis", Globe((0.03, 0.036), 1.3, ("tan", "beige", "amber"), "dark streaks",
         top="stem", pear=0.35), 0.006, (0.0338, 0.0345, 0.0403), "cape gooseberry",
         "ground cherry"),
    _row("nutmeg", Globe((0.018, 0.022), 1.25, ("brown", "bronze", "copper"), "dark streaks",
         top="none", lying=True), 0.006, (0.0229, 0.0225, 0.0175), "whole nutmeg"),
    _row("peppercorn", Globe((0.0046, 0.006), 1.0, ("black", "charcoal", "red", "white", "brown"),
         "warty", top="none", bumps=30), 0.00008, (0.00623, 0.00636, 0.00507), "black peppercorn",
         "allspice berry",
         "pimento berry"),
    _row("juniper_berry", Globe((0.007, 0.009), 1.0, ("navy", "indigo", "navy", "purple"),
         top="tuft"), 0.0003, (0.00814, 0.00819, 0.00819), "juniper"),
    _row("raisin", Globe((0.008, 0.011), 1.5, ("maroon", "brown", "black"), "dark streaks",
         top="none", lying=True), 0.0006, (0.0114, 0.0125, 0.0079), "sultana", "dried grape"),
    _row("new_potato", Globe((0.034, 0.045), 1.25, ("tan", "beige", "wooden"), "spots", top="none",
         lying=True), 0.05, (0.0467, 0.0424, 0.0344), "baby potato", "jersey royal"),
    _row("prickly_pear", Globe((0.048, 0.058), 1.35, ("crimson", "green", "coral", "lime"), "warty",
         top="none", bumps=36, lying=True), 0.1, (0.0672, 0.066, 0.0515), "cactus fruit",
         "cactus pear"),
)  # fmt: skip
"""The module's categories."""
