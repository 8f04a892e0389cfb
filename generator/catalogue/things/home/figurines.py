"""Small figures for shelves: animals and people in porcelain, wood or metal; nesting dolls."""

from __future__ import annotations

from collections.abc import Callable
from types import MappingProxyType

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of
from ...build.forms import above
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile

Named = list[tuple[Solid, str]]
"""Solids and the paint each takes: "skin", "pale", "dark" or "accent"."""


def _ball(x: float, y: float, z: float, at: tuple[float, float, float]) -> Solid:
    """Return an ellipsoid with diameters x, y, z about ``at``."""
    return ellipsoid(x, y, z, 16, 10).move(*at)


def _cat() -> Named:
    made = [(_ball(0.042, 0.05, 0.07, (0, 0.004, 0.032)), "skin"),
            (_ball(0.036, 0.032, 0.031, (0, -0.008, 0.075)), "skin"),
            (_ball(0.022, 0.01, 0.034, (0, -0.02, 0.036)), "pale"),
            (_ball(0.006, 0.005, 0.004, (0, -0.025, 0.073)), "accent"),
            (tube(smooth([(0.012, 0.025, 0.006), (0.034, 0.014, 0.006), (0.034, -0.012, 0.006)], 4),
                  0.005, 8), "skin")]  # fmt: skip
    for s in (-1, 1):
        made += [(cylinder(0.008, 0.017, 4, top=0.0008).move(s * 0.011, -0.006, 0.084), "skin"),
                 (_ball(0.012, 0.02, 0.012, (s * 0.01, -0.022, 0.005)), "pale"),
                 (_ball(0.005, 0.004, 0.006, (s * 0.008, -0.0225, 0.079)), "dark")]  # fmt: skip
    return made


def _rabbit() -> Named:
    made = [(_ball(0.042, 0.05, 0.055, (0, 0.006, 0.026)), "skin"),
            (_ball(0.034, 0.036, 0.034, (0, -0.008, 0.062)), "skin"),
            (_ball(0.016, 0.016, 0.016, (0, 0.033, 0.014)), "pale"),
            (_ball(0.005, 0.005, 0.004, (0, -0.026, 0.06)), "accent")]  # fmt: skip
    for s in (-1, 1):
        ear = ellipsoid(0.012, 0.008, 0.042, 12, 8).turn(1, s * 0.22)
        made += [(ear.move(s * 0.012, 0, 0.092), "skin"),
                 (ear.scale(0.6, 0.6, 0.8).move(s * 0.012, -0.003, 0.092), "pale"),
                 (_ball(0.014, 0.024, 0.012, (s * 0.012, -0.02, 0.005)), "skin"),
                 (_ball(0.005, 0.004, 0.006, (s * 0.009, -0.0235, 0.067)), "dark")]  # fmt: skip
    return made


def _owl() -> Named:
    made = [(_ball(0.056, 0.05, 0.08, (0, 0, 0.038)), "skin"),
            (_ball(0.036, 0.012, 0.046, (0, -0.021, 0.028)), "pale"),
            (cylinder(0.005, 0.011, 8, top=0.0006).turn(0, np.pi / 2 + 0.4)
             .move(0, -0.022, 0.056), "accent")]  # fmt: skip
    for s in (-1, 1):
        made += [(_ball(0.024, 0.008, 0.024, (s * 0.012, -0.0185, 0.062)), "pale"),
                 (_ball(0.012, 0.006, 0.012, (s * 0.012, -0.022, 0.062)), "dark"),
                 (cylinder(0.009, 0.016, 6, top=0.001).move(s * 0.016, -0.004, 0.07), "skin"),
                 (_ball(0.014, 0.034, 0.05, (s * 0.027, 0.004, 0.034)), "accent")]  # fmt: skip
    return made


def _elephant() -> Named:
    trunk = smooth(
        [(0, -0.035, 0.046), (0, -0.05, 0.034), (0, -0.055, 0.016), (0, -0.064, 0.012)], 4
    )
    made = [(_ball(0.046, 0.064, 0.046, (0, 0.008, 0.042)), "skin"),
            (_ball(0.036, 0.034, 0.038, (0, -0.028, 0.054)), "skin"),
            (tube(trunk, np.linspace(0.0075, 0.004, len(trunk)), 10), "skin")]  # fmt: skip
    for s in (-1, 1):
        tusk = smooth(
            [(s * 0.009, -0.036, 0.042), (s * 0.011, -0.05, 0.034), (s * 0.011, -0.06, 0.038)], 3
        )
        made += [(_ball(0.03, 0.008, 0.036, (s * 0.026, -0.02, 0.056)), "accent"),
                 (tube(tusk, 0.0022, 6), "pale"),
                 (_ball(0.005, 0.004, 0.005, (s * 0.011, -0.0425, 0.06)), "dark")]  # fmt: skip
        made += [
            (cylinder(0.0095, 0.036, 12).move(s * 0.012, y, 0), "skin") for y in (-0.01, 0.026)
        ]
    return made


def _penguin() -> Named:
    made = [(_ball(0.05, 0.044, 0.076, (0, 0, 0.036)), "skin"),
            (_ball(0.036, 0.016, 0.056, (0, -0.016, 0.032)), "pale"),
            (_ball(0.034, 0.034, 0.032, (0, -0.002, 0.078)), "skin"),
            (cylinder(0.005, 0.014, 8, top=0.0006).turn(0, np.pi / 2)
             .move(0, -0.016, 0.076), "accent")]  # fmt: skip
    for s in (-1, 1):
        wing = ellipsoid(0.008, 0.022, 0.048, 12, 8).turn(1, -0.25 * s)
        made += [(wing.move(s * 0.027, 0, 0.04), "skin"),
                 (_ball(0.018, 0.026, 0.008, (s * 0.012, -0.014, 0.003)), "accent"),
                 (_ball(0.005, 0.004, 0.006, (s * 0.008, -0.017, 0.083)), "dark")]  # fmt: skip
    return made


def _lady() -> Named:
    robe = lathe(
        [(0, 0), (0.028, 0), (0.029, 0.004), (0.016, 0.05), (0.0095, 0.066), (0, 0.07)], 20
    )
    made = [(robe.scale(1, 0.85, 1), "accent"),
            (_ball(0.026, 0.019, 0.036, (0, 0, 0.078)), "skin"),
            (_ball(0.021, 0.022, 0.026, (0, -0.002, 0.104)), "pale"),
            (_ball(0.024, 0.02, 0.025, (0, 0.003, 0.108)), "dark"),
            (_ball(0.012, 0.012, 0.012, (0, 0.008, 0.121)), "dark")]  # fmt: skip
    for s in (-1, 1):
        arm = smooth(
            [(s * 0.011, 0, 0.088), (s * 0.02, -0.004, 0.07), (s * 0.004, -0.016, 0.068)], 4
        )
        made.append((tube(arm, 0.004, 8), "skin"))
    return made


def _angel() -> Named:
    robe = lathe(
        [(0, 0), (0.026, 0), (0.027, 0.003), (0.012, 0.062), (0.008, 0.075), (0, 0.078)], 20
    )
    made = [(robe, "skin"), (_ball(0.024, 0.024, 0.026, (0, -0.002, 0.09)), "pale"),
            (_ball(0.027, 0.023, 0.025, (0, 0.003, 0.0945)), "dark"),
            (torus(0.012, 0.0015, 20, 6).move(0, 0, 0.109), "accent")]  # fmt: skip
    for s in (-1, 1):
        wing = ellipsoid(0.028, 0.006, 0.056, 14, 8).turn(1, -0.45 * s)
        arm = smooth(
            [(s * 0.009, -0.003, 0.07), (s * 0.014, -0.012, 0.056), (s * 0.002, -0.02, 0.06)], 4
        )
        made += [(wing.move(s * 0.022, 0.012, 0.064), "accent"), (tube(arm, 0.0038, 8), "skin")]
    return made


def _bird() -> Named:
    tail = ellipsoid(0.014, 0.044, 0.006, 12, 6).turn(0, 0.35).move(0, 0.038, 0.03)
    made = [(_ball(0.042, 0.06, 0.046, (0, 0, 0.026)), "skin"), (tail, "accent"),
            (_ball(0.034, 0.032, 0.032, (0, -0.02, 0.05)), "skin"),
            (_ball(0.03, 0.03, 0.03, (0, -0.014, 0.022)), "pale"),
            (cylinder(0.0045, 0.014, 8, top=0.0006).turn(0, np.pi / 2)
             .move(0, -0.033, 0.05), "dark")]  # fmt: skip
    for s in (-1, 1):
        made += [(_ball(0.01, 0.042, 0.026, (s * 0.019, 0.006, 0.03)), "accent"),
                 (_ball(0.005, 0.005, 0.005, (s * 0.011, -0.0315, 0.055)), "dark")]  # fmt: skip
    return made


FIGURES: MappingProxyType[str, Callable[[], Named]] = MappingProxyType(
    {"angel": _angel, "bird": _bird, "cat": _cat, "elephant": _elephant, "lady": _lady,
     "owl": _owl, "penguin": _penguin, "rabbit": _rabbit}
)  # fmt: skip
"""What a figurine may be."""


def figurine(look: Look) -> Shape:
    """A stylised animal or person, painted, or all of one material, often on a small base."""
    made = FIGURES[look.pick(sorted(FIGURES))]()
    k, finish = look.between(0.85, 1.1), look.pick(["painted", "painted", "glazed", "one"])
    color = look.color("white", "cream", "gray", "brown", "orange", "teal", "pink", "gold", "black")
    other = look.own_color("coral", "mustard", "teal", "navy", "gold", "pink", "crimson")
    skin = look.surface(
        color, "ceramic" if finish != "one" else look.pick(["bronze", "oak", "ceramic"])
    )
    pale = textures.plain(tint_color(color, 1.6) if sum(color) < 600 else (246, 226, 206))
    paints = {"skin": skin, "pale": pale, "dark": textures.plain((40, 34, 34)),
              "accent": textures.speckles(look.rng, other, 6, 32)}  # fmt: skip
    if finish == "one":
        paints = dict.fromkeys(paints, skin)
    elif finish == "glazed":
        paints["skin"] = textures.gradient(color, other, look.rng)
    solids = [(solid.bend(above), paint) for solid, paint in made]
    reach = float(np.abs(solids[0][0].vertices[:, :2]).max())
    pieces = [(solid.move(z=0.006), paints[paint]) for solid, paint in solids]
    base = cylinder(reach + 0.003, 0.0065, 28, bevel=0.0015)
    stand = look.pick(
        [skin, textures.wood(look.rng, (110, 76, 50), side=64), textures.plain(other)]
    )
    hulls = sorted((solid for solid, _ in pieces), key=lambda s: -s.volume)[:6]
    parts = [cylinder_part(reach + 0.003, 0.006), *map(hull_of, hulls)]
    return shape([*pieces, (base, stand)], parts).scale(k)


def matryoshka(look: Look) -> Shape:
    """A painted nesting doll: scarf, face, apron with a flower."""
    h = look.between(0.085, 0.14)
    r = h * look.between(0.27, 0.31)
    head = look.between(0.7, 0.78)
    t = [0, 0, 0.03, 0.18, 0.34, 0.5, 0.6, 0.66, 0.76, 0.86, 0.94, 0.985, 1]
    radii = [0, 0.74, 0.82, 0.97, 1, 0.9, 0.76, head - 0.02, head + 0.02, head - 0.04, 0.5, 0.24, 0]
    profile = np.column_stack([np.array(radii) * r, np.array(t) * h])
    doll = lathe(profile, 32, v=t)
    color = look.color("red", "crimson", "blue", "green", "purple", "teal", "pink", "black")
    scarf = look.own_color("yellow", "mustard", "red", "coral", "teal", "navy", "pink", "lime")
    if np.abs(np.array(scarf) - color).max() < 60:
        scarf = tint_color(color, 1.55)
    parts = [cylinder_part(0.74 * r, 0.1 * h),
             hull_of(doll.bend(lambda p: np.minimum(p, [1, 1, 0.64 * h]))),
             hull_of(doll.bend(lambda p: np.maximum(p, [-1, -1, 0.64 * h])))]  # fmt: skip
    return shape([(doll, _paint(look, color, scarf))], parts)


def _paint(look: Look, color: RGB, scarf: RGB) -> Tile:
    """Return a doll's paint; u goes round with the face in the middle, v from foot to crown."""
    image = prints.canvas(256, 192, color)
    apron, petal = (
        look.own_color("cream", "white", "mustard", "sky"),
        look.own_color("red", "pink", "blue"),
    )
    hair = look.pick([(70, 44, 28), (214, 166, 84), (150, 82, 40), (40, 32, 30)])
    prints.fill(image, 0, 0, 1, 0.4, scarf)
    for k in range(24):
        prints.disc(image, (k % 8 + 0.5 * (k // 8 % 2)) / 8, 0.09 + 0.11 * (k // 8), 0.018, petal)
    prints.polygon(image, [(0.5, 0.38), (0.4, 0.5), (0.47, 0.52), (0.53, 0.52), (0.6, 0.5)], scarf)
    prints.disc(image, 0.5, 0.25, 0.128, hair)
    prints.disc(image, 0.5, 0.265, 0.108, (246, 214, 184))
    prints.polygon(image, [(0.43, 0.2), (0.5, 0.135), (0.57, 0.2), (0.5, 0.18)], hair)
    for s in (-1, 1):
        prints.disc(image, 0.5 + 0.03 * s, 0.25, 0.015, (44, 60, 90))
        prints.disc(image, 0.5 + 0.045 * s, 0.295, 0.022, (238, 150, 136))
    prints.fill(image, 0.485, 0.315, 0.03, 0.014, (200, 40, 50))
    prints.disc(image, 0.5, 0.72, 0.22, apron)
    prints.fill(image, 0, 0.94, 1, 0.06, look.own_color("gold", "black", "green", "mustard"))
    for x, y, size in ((0.5, 0.7, 0.085), (0.42, 0.8, 0.05), (0.58, 0.8, 0.05), (0.06, 0.7, 0.08),
                       (0.94, 0.7, 0.08), (0.25, 0.72, 0.06), (0.75, 0.72, 0.06)):  # fmt: skip
        for angle in np.arange(4) * np.pi / 2 + 0.8:
            leaf = (x + size * np.cos(angle), y + 1.1 * size * np.sin(angle))
            prints.disc(image, *leaf, 0.4 * size, (70, 130, 70))
        for angle in np.arange(6) * np.pi / 3:
            spot = (x + 0.42 * size * np.cos(angle), y + 0.56 * size * np.sin(angle))
            prints.disc(image, *spot, 0.42 * size, petal)
        prints.disc(image, x, y, 0.36 * size, (246, 210, 100))
    return image


CATEGORIES = (
    Category("figurine", figurine, (0.062, 0.066, 0.105), 0.12,
             ("small statue", "porcelain figurine",
             "ceramic figurine", "animal figurine",
                 "cat figurine", "owl figurine",
             "elephant figurine", "bird figurine",
                 "angel figurine", "penguin figurine",
             "rabbit figurine", "porcelain figure",
              "fairy ornament", "angel ornament", "angel figure", "fairy figurine",
              "black cat figurine", "owl figure", "tea pet", "venus figurine", "cycladic figure",
              "terracotta warrior figure", "terracotta warrior", "benin bronze", "inca figure",
              "netsuke", "shabti", "taxidermy owl", "staffordshire figure", "big ben model",
              "big ben", "glass animal", "crystal swan", "swan ornament", "owl ornament",
              "elephant ornament", "angel wings ornament", "ceramic owl", "gryphon figure",
              "smurf figurine", "bonnet ornament", "lladro figurine", "kissing couple figurine"),
             ("living", "office"), (), ("white", "brown")),
    Category("matryoshka", matryoshka, (0.065, 0.065, 0.112), 0.08,
             ("matryoshka doll", "matrioshka", "russian doll", "nesting doll",
              "russian nesting doll", "babushka doll", "babushka"),
             ("living", "toys"), ("round",), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
