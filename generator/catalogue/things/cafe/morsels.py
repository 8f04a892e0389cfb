"""Small things by the piece: cubes, seeds, pods, spices, a scoop of this and that."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import blade
from ...build.outlines import smooth
from ...build.recipes import ball
from ...build.settled import limb, rod, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, join, lathe, loft
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def cube(form: tuple[float, float, float], palette: tuple[str, ...], spot: float, deep: float,
         soft: float = 0.0015) -> Callable[[Look], Shape]:  # fmt: skip
    """Return a small block with a spotted surface: bread, wax, coal, lighter."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        body = block(x, y, h, 0.12 * min(x, y), soft)
        tile = textures.spots(look.rng, color, tint_color(color, deep), spot)
        return shape([(body, tile)], [box_part(x, y, h)])

    return make


def crouton(look: Look) -> Shape:
    """A cube of bread: white crumb with holes, one side of crust."""
    x = look.between(0.019, 0.024)
    color = look.color("cream", "beige", "amber")
    crumb = textures.spots(look.rng, tint_color(color, 1.25), tint_color(color, 0.85), 0.2)
    rind = block(0.98 * x, 0.98 * x, 0.0022, 0.001).move(z=x - 0.001)
    return shape([(block(x, x, x, 0.0015, 0.0008), crumb),
                  (rind, textures.speckles(look.rng, (170, 104, 50), 10))],
                 [box_part(x, x, x + 0.001)])  # fmt: skip


def briquette(look: Look) -> Shape:
    """A pillow-shaped briquette of charcoal."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "charcoal", "black")
    x = 0.052 * k
    outline = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])
    ring = np.concatenate(
        [
            a + (b - a) * np.linspace(0, 1, 6, endpoint=False)[:, None]
            for a, b in zip(outline, np.roll(outline, -1, 0), strict=True)
        ]
    )
    ring = ring * (1 - 0.12 * (np.linalg.norm(ring, axis=1, keepdims=True) - 0.5)) * x
    levels = [(0.5, 0), (0.86, 0.12), (1.0, 0.42), (1.0, 0.58), (0.86, 0.88), (0.5, 1.0)]
    body = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), 0.03 * k * z)])
                          for f, z in levels]), ring)  # fmt: skip
    tile = textures.spots(look.rng, tint_color(color, 0.8), (96, 94, 92), 0.14)
    return shape([(body, tile)], [hull_of(body)])


def pod(look: Look) -> Shape:
    """A green cardamom pod with its three ribs."""
    k = look.between(0.9, 1.15)
    color = look.color("olive", "lime", "beige")
    body = rod(0.022, 0.0052, blunt=2.4)
    ribs = [limb([(-0.009, 0.0022 * np.cos(a), 0.0022 * np.sin(a)), (0, 0.005 * np.cos(a), 0.005 *
                 np.sin(a)), (0.009, 0.0022 * np.cos(a), 0.0022 * np.sin(a))], [0.0006] * 3, 5)
            for a in (0.5, 2.6, 1.55)]  # fmt: skip
    stalk = limb([(0.01, 0, 0), (0.014, 0.001, 0)], [0.0008, 0.0005], 5)
    return settle(
        [
            (body, textures.gradient(tint_color(color, 1.1), tint_color(color, 1.3), look.rng)),
            (join([*ribs, stalk]), textures.plain(tint_color(color, 0.8))),
        ],
        0.16,
    ).scale(k)


def anise(look: Look) -> Shape:
    """A star of eight woody pods with shiny seeds."""
    k = look.between(0.9, 1.2)
    color = look.color("brown", "brown", "bronze")
    pods, seeds = [], []
    for n in range(8):
        a = n * np.pi / 4
        way = np.array([np.cos(a), np.sin(a)])
        pods.append(
            blade(
                [(0, 0, 0.0035), (*(0.009 * way), 0.005), (*(0.019 * way), 0.004)],
                0.0085,
                thick=0.5,
            )
        )
        seeds.append(ball(0.0042, 0.003, 0.003, (*(0.0085 * way), 0.0066), 8))
    return settle([(join(pods), textures.speckles(look.rng, tint_color(color, 0.95), 14)),
                   (join(seeds), textures.plain((150, 84, 40)))], 0.05).scale(k)  # fmt: skip


def seed(palette: tuple[str, ...], form: tuple[float, float, float], striped: bool
         ) -> Callable[[Look], Shape]:  # fmt: skip
    """Return one flat pointed seed, plain or striped."""

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
        tile = textures.stripes([color, other, color], 2) if striped else textures.gradient(
            tint_color(color, 0.95), tint_color(color, 1.15), look.rng)  # fmt: skip
        return shape([(body, tile)], [hull_of(body)])

    return make


def wax_melt(look: Look) -> Shape:
    """A scented wax melt: a small fluted block of wax."""
    k = look.between(0.9, 1.15)
    color = look.color("pink", "lavender", "cream", "mint", "coral", "yellow")
    body = lathe([(0, 0), (0.02, 0), (0.016, 0.013), (0.013, 0.015), (0, 0.015)], 30)
    flute = body.bend(lambda p: p * np.column_stack([*[1 + 0.08 * np.cos(8 * np.arctan2(
        p[:, 1], p[:, 0]))] * 2, np.ones(len(p))]))  # fmt: skip
    return shape([(flute, textures.speckles(look.rng, color, 6))], [hull_of(flute)]).scale(k)


def nut_shell(look: Look) -> Shape:
    """A Brazil nut: three-sided, ridged, brown."""
    k = look.between(0.9, 1.1)
    color = look.color("brown", "bronze")
    ring = smooth([(-0.5, -0.05), (-0.2, -0.3), (0.25, -0.28), (0.5, 0.0), (0.3, 0.3), (-0.2, 0.28),
                   (-0.5, -0.05)], 3)[:-1] * 0.045  # fmt: skip
    levels = [(0.75, 0), (1.0, 0.006), (0.85, 0.012), (0.3, 0.02), (0.1, 0.021)]
    body = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
                ring)  # fmt: skip
    return shape([(body, textures.scratches(look.rng, color, tint_color(color, 0.7), 60))],
                 [hull_of(body)]).scale(k)  # fmt: skip


def chips(look: Look) -> Shape:
    """A heap of wood chips for smoking."""
    color = look.color("tan", "wooden", "brown")
    made: list[Solid] = []
    for n in range(26):
        away, a = 0.045 * np.sqrt((n + 0.5) / 26), 2.4 * n
        one = box(look.between(0.02, 0.034), look.between(0.01, 0.016), 0.004)
        made.append(one.turn(1, look.between(-0.3, 0.3)).turn(2, look.between(0, 3)).move(
            away * np.cos(a), away * np.sin(a), 0.003 + 0.018 * (1 - n / 26)))  # fmt: skip
    return settle([(join(made), textures.wood(look.rng, color))], 0.02)


def coffee_bean(look: Look) -> Shape:
    """A roasted coffee bean, its groove up."""
    k = look.between(0.9, 1.2)
    color = look.color("brown", "brown", "bronze")
    half = rod(0.0125, 0.0046, blunt=2.3, squash=0.75)
    groove = limb([(-0.0048, 0.0004, 0.0019), (-0.0018, -0.0005, 0.0031), (0.0018, 0.0005, 0.0031),
                   (0.0048, -0.0004, 0.0019)], [0.0006] * 4, 6)  # fmt: skip
    tone = tint_color(color, 0.75)
    return settle([(half, textures.speckles(look.rng, tone, 8)),
                   (groove, textures.plain(tint_color(tone, 0.45)))], 0.16).scale(k)  # fmt: skip


def pecan(look: Look) -> Shape:
    """A pecan half: an oval with a groove and wrinkles."""
    k = look.between(0.9, 1.1)
    color = look.color("copper", "brown", "bronze")
    lobes = [rod(0.032, 0.0068, blunt=2.6, bend=-s * 0.002).move(y=s * 0.0048) for s in (-1, 1)]
    tile = textures.scratches(look.rng, tint_color(color, 0.9), tint_color(color, 0.6), 60)
    return settle([(join(lobes), tile)], 0.2).scale(k)


_K = ("kitchen",)
_E = ("edible",)
_D = "lying flat"
CATEGORIES = (
    Category("crouton", crouton, (0.0216, 0.0216, 0.0228), 0.002, ("bread cube", "cube of bread",
             "bread crouton", "toasted bread cube"), _K, _E, ("cream",)),
    vary(Category("charcoal_briquette", briquette, (0.0524, 0.0524, 0.0302), 0.03, ("briquette",
             "lump of coal", "piece of coal", "lump of charcoal", "barbecue charcoal",
             "charcoal"), _K, (), ("black",))),
    Category("firelighter", cube((0.04, 0.026, 0.02), ("white", "tan", "ivory"), 0.3, 0.85),
             (0.0418, 0.0272, 0.0209), 0.015, ("fire lighter", "fire starter", "firestarter",
             "fire lighter cube"), _K, (), ("white",)),
    Category("cardamom_pod", pod, (0.0258, 0.0107, 0.00916), 0.0003, ("cardamom", "green cardamom",
             "cardamom seed"), _K, (), ("olive",), state=_D),
    Category("star_anise", anise, (0.0424, 0.0424, 0.00593), 0.0015, ("anise star",
             "star anise pod", "aniseed star"), _K, ("flat",), ("brown",), state=_D),
    Category("sunflower_seed", seed(("black", "charcoal"), (0.014, 0.0075, 0.0042), True),
             (0.0145, 0.00775, 0.00434), 0.0002, ("striped seed",), _K, _E,
             ("black",), state=_D),
    Category("pumpkin_seed", seed(("ivory", "olive", "cream"), (0.017, 0.0095, 0.003), False),
             (0.0174, 0.00973, 0.00307), 0.0002, ("seed", "squash seed", "melon seed",
             "apple pip", "pip", "pepita"), _K, _E, ("ivory",), state=_D),
    Category("wax_melt", wax_melt, (0.0425, 0.0438, 0.0152), 0.01, ("scented wax melt", "wax cube",
             "scented wax", "wax tart"), ("living",), (), ("pink",)),
    Category("brazil_nut", nut_shell, (0.044, 0.0286, 0.0205), 0.008,
             ("brazil nut in its shell",), _K, _E, ("brown",), state=_D),
    Category("coffee_bean", coffee_bean, (0.0128, 0.00939, 0.00643), 0.0002, ("roasted coffee bean",
             "espresso bean"), _K, _E, ("brown",), state=_D),
    Category("pecan", pecan, (0.0329, 0.0206, 0.0107), 0.002, ("pecan nut", "pecan half"), _K, _E,
             ("copper",), state=_D),
    Category("wood_chips", chips, (0.112, 0.107, 0.0256), 0.04, ("wood chip", "smoking chips",
             "pile of wood chips", "wood chippings", "bark chip"), _K, (), ("tan",), state=_D),
)  # fmt: skip
"""The module's categories."""
