"""Objects of the ``living`` theme: vases."""

from __future__ import annotations

import numpy as np

from ...kit import materials, prints, surfaces
from ...kit.materials import dye, glaze_tile, metal
from ...kit.outlines import smooth
from ...kit.parts import bowl_parts, cylinder_part, open_vessel
from ...kit.primitives import drum, rod, standing
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, ellipsoid, join, lathe, tube
from ...kit.surfaces import Look, plain, tint_color
from ...values import ConvexPart


@category("urn", size=(0.208, 0.147, 0.22), mass=1.0, material="ceramic", hollow=True,
          aliases=("funeral urn", "lidded urn", "ginger jar", "cremation urn", "grecian urn"),
          themes=("living",), roles=("tall",), colors=("brown", "navy"))  # fmt: skip
@from_pieces(bodies=2)
def urn(look: Look) -> Pieces:
    """A footed urn with a lid and two handles."""
    color = look.color("brown", "navy", "gold", "teal", "white", "charcoal")
    tile = (materials.glaze_tile(look, color) if look.chance(0.5)
            else metal(look, "brass", "bronze", "silver"))  # fmt: skip
    body = standing((0.04, 0), (0.04, 0.01), (0.022, 0.022), (0.055, 0.07), (0.07, 0.11),
                    (0.06, 0.145), (0.036, 0.165))  # fmt: skip
    lid = standing(
        (0.042, 0.165), (0.04, 0.172), (0.02, 0.188), (0.008, 0.192), (0.012, 0.202), (0.004, 0.21)
    )
    grips = [rod([(s * 0.062, 0, 0.13), (s * 0.09, 0, 0.135), (s * 0.09, 0, 0.1),
                  (s * 0.066, 0, 0.085)], 0.006, 8) for s in (-1, 1)]  # fmt: skip
    return [(body, tile), (lid, tile), (join(grips), dye(look, "gold", "brown"))]


@category("amphora", size=(0.13, 0.13, 0.217), mass=0.8, material="ceramic", hollow=True,
          aliases=("greek amphora", "roman amphora", "clay amphora", "kylix", "greek urn"),
          themes=("living",), roles=("tall",), colors=("terracotta",))  # fmt: skip
def amphora(look: Look) -> Shape:
    """An amphora on a small base, with two handles and a painted band."""
    color = look.color("terracotta", "tan", "brown", "cream")
    k = look.between(0.85, 1.1)
    side = [(0.032, 0), (0.026, 0.01), (0.03, 0.03), (0.062, 0.09), (0.068, 0.125), (0.052, 0.165),
            (0.022, 0.185), (0.019, 0.215), (0.028, 0.226)]  # fmt: skip
    pot = standing(*side, (0.022, 0.226), sides=28)
    mouth = drum(0.02, 0.0008, (0, 0, 0.2256))
    handles = [rod([(s * 0.02, 0, 0.212), (s * 0.052, 0, 0.214), (s * 0.062, 0, 0.185),
                    (s * 0.054, 0, 0.155)], 0.0058, 8) for s in (-1, 1)]  # fmt: skip
    image = surfaces.speckles(look.rng, color, 8, 128).copy()
    ink = look.own_color("black", "brown", "navy")
    for v, h in ((0.02, 0.02), (0.4, 0.02), (0.56, 0.02), (0.72, 0.05)):
        prints.fill(image, 0, v, 1, h, ink)
    prints.stroke(image, [(n / 16, 0.49 + 0.035 * (-1) ** n) for n in range(17)], 0.02, ink)
    return put_down([(pot, image), (mouth, plain((50, 36, 30))),
                     (join(handles), plain(tint_color(color, 0.8)))], pot, *handles,
                    factor=k)  # fmt: skip


def _stem(base: np.ndarray, tip: np.ndarray, thick: float = 0.0022) -> Solid:
    middle = (base + tip) / 2 + np.array([0, 0, 0.12]) * np.linalg.norm(tip[:2] - base[:2])
    return tube(smooth([base, middle, tip], 3), thick, 6)


@category("vase", size=(0.14, 0.13, 0.27), mass=0.6, material="ceramic", hollow=True,
          assembled=True, aliases=("flower vase", "flowers", "flower", "vase of flowers",
          "flower arrangement", "floral arrangement", "centrepiece", "floral centrepiece",
          "centerpiece", "flower centrepiece", "table centrepiece", "krater", "bell krater",
          "burial urn", "funerary urn", "lekythos", "aryballos", "maya vase", "cameo glass vase",
          "jardiniere"), themes=("living", "dining", "office"),
          roles=("container", "tall", "round"), colors=("white", "teal", "navy"),
          opened="empty_vase", common=True)  # fmt: skip
def vase(look: Look) -> Shape:
    """A curved vase, open at the top, sometimes with flowers."""
    r, h = look.between(0.042, 0.064), look.between(0.16, 0.25)
    color = look.color(*("white", "white", "teal", "terracotta", "navy", "cream", "sage", "mustard",
                         "black"), *("pink", "gray", "sky"))  # fmt: skip
    style, phase = int(look.rng.integers(6)), look.between(0.4, 1.1)
    t = np.linspace(0, 1, 14)
    swell = [0.66 + 0.34 * np.sin(np.pi * (0.15 + 0.95 * t)), 0.62 + 0.38
             * np.sin(2 * np.pi * (t * 0.75 + 0.02)) * (1 - 0.35 * t), 0.75 + 0.25
             * np.cos(2 * np.pi * t * 0.8 + phase), 0.86 + 0.14 * t,
             np.where(t < 0.55, np.sin(np.pi * (0.16 + 0.74 * t / 0.55)), 0.32 + 0.08 * t), 0.55
             + 0.45 * t**0.7][style]  # fmt: skip
    swell = np.maximum(swell / swell.max(), 0.3)
    outer = np.column_stack([r * swell, h * t])
    wall = 0.004
    inner = np.column_stack([outer[:, 0] - wall, outer[:, 1]])[:1:-1]
    body = lathe(
        [(0, 0), *outer, *inner, (0, inner[-1, 1])],
        v=[0, *np.linspace(0.01, 0.93, 14), *np.linspace(0.95, 0.99, len(inner)), 1],
    )
    glaze = surfaces.fit(glaze_tile(look, color), 128, 128)
    pieces = [(body, glaze)]
    within = np.column_stack([np.maximum(outer[:, 0] - wall, 0.006), np.maximum(outer[:, 1], wall)])
    parts = [*bowl_parts(outer, within, 13), cylinder_part(float(outer[0, 0]), 2 * wall)]
    if look.chance(0.45) and look.attributes.get("state") != "empty":
        pieces += _flowers(look, float(outer[-1, 0]), h)
    return shape(pieces, parts)


def _flowers(look: Look, mouth: float, h: float) -> list[tuple[Solid, surfaces.Tile]]:
    """Return stems with blossoms that emerge from a vase's mouth at height ``h``."""
    green = surfaces.plain((74, 122, 62))
    petal = surfaces.speckles(
        look.rng, look.own_color("red", "pink", "yellow", "violet", "white"), 8
    )
    heart = surfaces.plain((206, 150, 50))
    pieces = []
    for k in range(5):
        angle, out = 2 * np.pi * k / 5 + look.between(-0.3, 0.3), look.between(0.01, 0.05)
        way = np.array([np.cos(angle), np.sin(angle), 0.0])
        tip = way * (mouth + out) + [0, 0, h + look.between(0.07, 0.13)]
        pieces.append((_stem(way * 0.5 * mouth + [0, 0, h - 0.03], tip), green))
        petals = [ellipsoid(0.026, 0.016, 0.007, 6, 4).move(x=0.014, z=0.002).turn(2, np.pi / 3 * m)
                  for m in range(6)]  # fmt: skip
        pieces.append((join(petals).move(*tip), petal))
        pieces.append((ellipsoid(0.014, 0.014, 0.01, 8, 4).move(*tip).move(z=0.004), heart))
    return pieces


@category("plant_pot", size=(0.13, 0.13, 0.11), mass=0.5, material="ceramic", hollow=True,
          aliases=("empty plant pot", "clay pot", "empty flower pot", "terracotta pot", "planter",
          "empty pot", "empty flowerpot", "flower planter"), themes=("living",),
          roles=("container", "round"), colors=("terracotta",))  # fmt: skip
def plant_pot(look: Look) -> Shape:
    """An empty flower pot of clay or glazed ceramic, sometimes on a saucer."""
    r, h = look.between(0.055, 0.075), look.between(0.09, 0.125)
    color = look.color(
        "terracotta", "terracotta", "terracotta", "white", "gray", "teal", "black", "cream"
    )
    clay = glaze_tile(look, color) if look.chance(0.4) else look.surface(color, "stoneware")
    base = 0.006 if look.chance(0.5) else 0.0
    side = [(0.68 * r, 0), (0.92 * r, 0.76 * h), (r, 0.77 * h), (1.03 * r, h)]
    body, parts = open_vessel(side, 0.006, 0.008, 30)
    inside = surfaces.speckles(look.rng, tint_color(color, 0.7), 8, 32)
    pieces = [(body.move(z=base), surfaces.stack((clay, 50), (inside, 50), side=192))]
    if look.chance(0.5):
        soil = surfaces.speckles(look.rng, (74, 54, 40), 14)
        level = 0.62 * h
        wide = float(np.interp(level, [0, 0.76 * h], [0.68 * r, 0.92 * r])) - 0.005
        pieces.append(
            (lathe([(0, 0.009), (0.64 * r, 0.009), (wide, level), (0, level)]).move(z=base), soil)
        )
    raised = [ConvexPart(p.vertices + np.array([0, 0, base]), p.kind, p.axis) for p in parts]
    if base:
        dish = lathe([(0, 0), (0.86 * r, 0), (0.98 * r, 0.016), (0.93 * r, 0.016), (0.84 * r, base),
                      (0, base)], 30)  # fmt: skip
        pieces.append((dish, look.surface(tint_color(color, 0.92), "ceramic")))
        raised.append(cylinder_part(0.86 * r, base))
    return shape(pieces, raised)


@category("empty_vase", size=(0.107, 0.107, 0.165), mass=0.6, material="ceramic", hollow=True,
          aliases=("vase for flowers",), themes=("living",), roles=("container", "round", "tall"),
          colors=("white", "teal"))  # fmt: skip
def empty_vase(look: Look) -> Shape:
    """An empty vase."""
    r, h = look.between(0.05, 0.057), look.between(0.155, 0.175)
    t = np.linspace(0, 1, 8)
    swell = 0.62 + 0.38 * np.sin(np.pi * (0.12 + 0.72 * t))
    color = look.color("white", "teal", "terracotta", "navy", "cream", "sage", "mustard", "pink")
    side = [(float(r * s), float(h * u)) for s, u in zip(swell, t, strict=True)]
    body, parts = open_vessel(side, 0.004, 0.008)
    return shape([(body, surfaces.fit(glaze_tile(look, color), 128, 128))], parts)
