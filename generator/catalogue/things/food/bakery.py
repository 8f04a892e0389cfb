"""Bread, pastry and other things from a bag or box."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.shape import Shape, shape
from ...build.solids import box, cylinder, ellipsoid, join, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .food import halves


def bread_loaf(look: Look) -> Shape:
    """A loaf of bread with scored crust."""
    x, y, h = look.between(0.2, 0.24), look.between(0.095, 0.11), look.between(0.075, 0.09)
    crust = look.color("brown", "tan", "copper")
    tile = textures.scratches(look.rng, tint_color(crust, 1.15), (236, 210, 168), 90)
    outline = [(-y / 2, 0.006), (-0.42 * y, 0), (0.42 * y, 0), (y / 2, 0.006), (0.52 * y, 0.45 * h),
               (0.4 * y, 0.82 * h), (0.15 * y, h), (-0.15 * y, h), (-0.4 * y, 0.82 * h),
               (-0.52 * y, 0.45 * h)]  # fmt: skip
    body = prism(outline, -x / 2, x / 2, 0.016).turn(0, np.pi / 2).turn(2, np.pi / 2)
    body = body.move(z=-float(body.vertices[:, 2].min()))
    cuts = [
        ellipsoid(0.055, 0.012, 0.006, 12, 6).turn(2, 0.5).move(k * 0.28 * x, 0, h - 0.001)
        for k in (-1, 0, 1)
    ]
    pale = textures.speckles(look.rng, (238, 214, 172), 6)
    return shape([(body, tile), (join(cuts), pale)], [hull_of(body)])


def croissant(look: Look) -> Shape:
    """A croissant, crescent-shaped with ridges."""
    color = look.color("copper", "amber", "tan")
    a = np.linspace(np.deg2rad(195), np.deg2rad(345), 15)
    radii = 0.03 * np.clip(np.sin(np.linspace(0.12, np.pi - 0.12, 15)), 0.16, 1)
    radii *= 1 + 0.09 * np.cos(np.arange(15) * np.pi)
    path = np.column_stack([0.062 * np.cos(a), 0.062 * np.sin(a) + 0.045, 0.75 * radii])
    body = tube(path, radii, 10, squash=0.75)
    body = body.move(z=-float(body.vertices[:, 2].min()))
    tile = textures.scratches(look.rng, color, tint_color(color, 0.6), 120)
    return shape([(body, tile)], halves(body, 5))


def donut(look: Look) -> Shape:
    """A glazed ring donut with sprinkles."""
    dough = look.own_color("tan", "amber", "copper")
    icing = look.color("pink", "brown", "white", "lavender", "mint")
    base = torus(0.029, 0.0165, 28, 12).scale(1, 1, 0.95)
    base = base.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], -0.0135)]))
    glaze = torus(0.029, 0.0172, 28, 12).bend(
        lambda p: np.column_stack(
            [p[:, :2], np.maximum(p[:, 2], 0.003 * np.sin(4 * p[:, 0] / 0.03))]
        )
    )
    image = prints.canvas(128, 64, icing)
    for _ in range(60):
        i, j = look.rng.integers(0, 61), look.rng.integers(0, 124)
        image[i : i + 2, j : j + 4] = np.array(
            look.own_color("red", "yellow", "sky", "white"), np.uint8
        )
    sections = []
    for k in range(8):
        t = 2 * np.pi * (np.array([0, 0.5, 1]) + k) / 8
        rings = [(0.0125, 0.0135), (0.022, 0), (0.036, 0), (0.0455, 0.0135), (0.029, 0.03)]
        points = [(r * np.cos(u), r * np.sin(u), z) for u in t for r, z in rings]
        sections.append(hull_part(points))
    return shape(
        [(base.move(z=0.0135), textures.speckles(look.rng, dough, 6)),
         (glaze.move(z=0.0135), image)],
        sections,
    )  # fmt: skip


def cupcake(look: Look) -> Shape:
    """A cupcake in a paper case with a cherry on top."""
    case = look.color("pink", "teal", "white", "mustard", "violet")
    pleats = textures.stripes([case, tint_color(case, 0.8)], 18, upright=True)
    cream = textures.speckles(
        look.rng, look.own_color("white", "pink", "cream", "brown", "mint"), 5
    )
    cup = cylinder(0.024, 0.036, 24, top=0.033)
    tiers = [
        ellipsoid(2 * r, 2 * r, 0.026, 20, 8).move(z=z)
        for r, z in ((0.035, 0.041), (0.026, 0.054), (0.016, 0.066))
    ]
    cherry = ellipsoid(0.014, 0.014, 0.014, 12, 8).move(z=0.081)
    return shape(
        [(cup, pleats), (join(tiers), cream), (cherry, textures.plain((190, 30, 44)))],
        [hull_of(cup), hull_of(*tiers), hull_of(cherry)],
    )


def cheese(look: Look) -> Shape:
    """A wedge of cheese with holes."""
    color = look.color("yellow", "amber", "cream", "orange")
    image = textures.speckles(look.rng, color, 4, 96).copy()
    for _ in range(10):
        x, y = look.rng.uniform(0.1, 0.9, 2)
        prints.disc(image, float(x), float(y), look.between(0.03, 0.08), tint_color(color, 0.78))
    wedge = prism(
        [(-0.06, -0.035), (0.06, 0.0), (-0.06, 0.035)], 0, look.between(0.04, 0.05), 0.002
    )
    return shape([(wedge, image)], [hull_of(wedge)])


def cake(look: Look) -> Shape:
    """A round cake with icing and berries."""
    r, h = look.between(0.085, 0.1), look.between(0.06, 0.075)
    icing = look.color("white", "pink", "brown", "cream")
    sponge = textures.speckles(look.rng, look.own_color("tan", "brown", "amber"), 8)
    frost = textures.speckles(look.rng, icing, 4)
    side = textures.stack((frost, 2), (sponge, 3), (frost, 1), (sponge, 3), (frost, 2))
    top = cylinder(r + 0.002, 0.01, 32, bevel=0.003).move(z=h)
    pieces = [(cylinder(r, h, 32), side), (top, frost)]
    red = textures.plain(look.own_color("red", "crimson", "indigo"))
    berries = [
        ellipsoid(0.018, 0.018, 0.017, 10, 6).move(
            0.78 * r * np.cos(0.785 * k), 0.78 * r * np.sin(0.785 * k), h + 0.016
        )
        for k in range(8)
    ]
    return shape(
        [*pieces, (join(berries), red)],
        [cylinder_part(r, h + 0.01), cylinder_part(0.84 * r, 0.012, (0, 0, h + 0.01))],
    )


def sandwich(look: Look) -> Shape:
    """A triangular sandwich lying flat."""
    crumb = textures.speckles(look.rng, look.color("beige", "cream", "tan"), 6)
    corner = np.array([(-0.065, -0.045), (0.065, -0.045), (0.0, 0.06)])
    layers = [(0.0, 0.013, 1.0, crumb)]
    fills = (
        ("green", 0.013, 0.017, 1.05),
        ("red", 0.017, 0.022, 0.97),
        ("yellow", 0.022, 0.026, 1.02),
    )
    for name, low, high, grow in fills:
        layers.append((low, high, grow, textures.speckles(look.rng, look.own_color(name), 9)))
    layers.append((0.026, 0.039, 1.0, crumb))
    pieces = [(prism(corner * g, low, high, 0.001), tile) for low, high, g, tile in layers]
    return shape(pieces, [hull_of(*(p for p, _ in pieces))])


def cereal_box(look: Look) -> Shape:
    """A box of cereal standing."""
    x, y, h = look.between(0.17, 0.19), look.between(0.05, 0.06), look.between(0.24, 0.28)
    color = look.color("red", "yellow", "blue", "orange", "green")
    title = look.pick(["OATS", "FLAKES", "CRUNCH", "MUESLI"])
    face = prints.cover(look.rng, title, color, look.own_color("white", "yellow", "cream"))
    side = textures.plain(tint_color(color, 0.9))
    front = box(0.985 * x, 0.001, 0.985 * h).move(y=-y / 2, z=0.007 * h)
    back = box(0.985 * x, 0.001, 0.985 * h).move(y=y / 2, z=0.007 * h)
    return shape([(box(x, y, h), side), (front, face), (back, face)], [box_part(x, y, h)])


CATEGORIES = (
    Category(
        "bread_loaf",
        bread_loaf,
        (0.22, 0.107, 0.084),
        0.45,
        ("loaf of bread", "bread", "loaf", "rye sourdough", "colomba"),
        ("kitchen", "dining"),
        ("edible",),
        ("brown", "tan"),
        state="lying flat",
    ),
    Category(
        "croissant",
        croissant,
        (0.13, 0.08, 0.045),
        0.06,
        ("pastry",),
        ("coffee", "dining"),
        ("edible",),
        ("amber",),
        state="lying flat",
    ),
    Category(
        "donut",
        donut,
        (0.092, 0.092, 0.031),
        0.06,
        ("doughnut",),
        ("coffee",),
        ("edible", "round", "flat"),
        ("pink", "brown"),
        state="lying flat",
    ),
    Category(
        "cupcake",
        cupcake,
        (0.07, 0.07, 0.088),
        0.07,
        (),
        ("coffee", "dining"),
        ("edible", "round"),
        ("pink", "teal"),
    ),
    Category(
        "cheese",
        cheese,
        (0.12, 0.07, 0.045),
        0.2,
        ("cheese wedge", "wedge of cheese"),
        ("kitchen", "dining"),
        ("edible",),
        ("yellow",),
    ),
    Category(
        "cake",
        cake,
        (0.19, 0.19, 0.09),
        0.9,
        (),
        ("dining", "coffee"),
        ("edible", "round", "big"),
        ("white", "pink"),
    ),
    Category(
        "sandwich",
        sandwich,
        (0.137, 0.11, 0.039),
        0.13,
        ("toastie", "toasted sandwich"),
        ("dining", "office"),
        ("edible", "flat"),
        ("beige",),
        state="lying flat",
    ),
    Category(
        "cereal_box",
        cereal_box,
        (0.18, 0.055, 0.26),
        0.4,
        (
            "cereal",
            "cereal carton",
            "box of cereal",
            "cracker box",
            "box of cornflakes",
            "box of muesli",
            "box of granola",
        ),
        ("kitchen", "dining"),
        ("tall",),
        ("red", "yellow"),
    ),
)
