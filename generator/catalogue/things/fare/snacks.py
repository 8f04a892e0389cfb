"""Filled, folded and cut food by the piece: dumplings, tacos, wraps, slices, cheeses, tofu."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe, speck
from ...build.outlines import arc
from ...build.settled import hull_above, rod, scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin


def dumpling(look: Look) -> Shape:
    """A folded dumpling, its pleated seam up, or a round steamed one."""
    color = look.color("cream", "ivory", "beige", "tan")
    tile = skin(look, color, tint_color(color, 0.88), 0.7)
    if look.chance(0.6):
        x, h = look.between(0.062, 0.074), look.between(0.03, 0.036)
        a = np.linspace(0, np.pi, 13)
        path = np.column_stack([-0.5 * x * np.cos(a), 0.012 * np.sin(a) - 0.006, 0.3 * h + 0 * a])
        radii = 0.46 * h * (0.28 + 0.72 * np.sin(a))
        body = tube(path, radii, 14)
        seam = tube(path + np.column_stack([0 * a, 0 * a, 0.2 * h + 0.5 * radii]),
                    0.0028 + 0 * a, 8)  # fmt: skip
        folds = [ellipsoid(0.0062, 0.011, 0.008, 8, 6).move(*(path[n] + [0, -0.002, 0.16 * h
                 + 0.52 * radii[n]])) for n in range(2, 11)]  # fmt: skip
        return settle([(join([body, seam, *folds]), tile)], 0.15)
    r, h = look.between(0.022, 0.028), look.between(0.028, 0.034)
    body = lobe(lathe([(0, 0), (0.85 * r, 0), (r, 0.3 * h), (0.8 * r, 0.66 * h),
                       (0.32 * r, 0.9 * h),
                       (0.2 * r, h), (0, 0.94 * h)], 60), 16, 0.09)  # fmt: skip
    return shape([(body, tile)], [hull_of(body)])


def spring_roll(look: Look) -> Shape:
    """A fried roll lying, its wrapper's edge showing."""
    long, r = look.between(0.085, 0.11), look.between(0.012, 0.015)
    body = rod(long, r, blunt=10)
    edge = tube([(s * 0.47 * long, 0.5 * r * s, 0.86 * r) for s in (-1, 0, 1)], 0.0016, 6)
    color = look.color("amber", "golden", "tan")
    crisp = textures.spots(look.rng, color, tint_color(color, 0.72), 0.12)
    return settle([(body, crisp), (edge, textures.plain(tint_color(color, 0.75)))], 0.12)


def taco(look: Look) -> Shape:
    """A folded taco standing on its fold, meat, lettuce and tomato in it."""
    r, t = look.between(0.06, 0.07), 0.003
    half = np.concatenate([arc((0, 0), r, 0, np.pi, 18)])
    gap = look.between(0.012, 0.015)
    walls = []
    for s in (-1, 1):
        wall = prism(half, 0, t).turn(0, np.pi / 2)
        low = wall.move(y=t / 2).turn(0, np.pi).move(z=r)
        walls.append(low.turn(0, s * 0.14).move(y=s * (gap - 0.002)))
    floor = rod(1.2 * r, 0.011, blunt=4).move(z=0.012)
    shell = skin(look, look.color("golden", "amber", "tan"), (196, 140, 60), 0.7)
    meat = rod(1.75 * r, 0.014, blunt=3).move(z=r - 0.014)
    green = [
        ellipsoid(0.03, 0.012, 0.014, 8, 5)
        .turn(2, look.between(-0.5, 0.5))
        .move((n - 3) * 0.25 * r, look.between(-0.004, 0.004), r + 0.001)
        for n in range(7)
    ]
    red = [box(0.008, 0.008, 0.008).turn(2, n).move((n - 2) * 0.36 * r, 0.004 * (-1) ** n,
           r + 0.004) for n in range(5)]  # fmt: skip
    made = [(join([*walls, floor]), shell), (meat, textures.spots(look.rng, (112, 66, 40),
            (70, 40, 26), 0.3)), (join(green), textures.speckles(look.rng, (120, 172, 66), 12)),
            (join(red), textures.plain((206, 56, 40)))]  # fmt: skip
    return settle(made, 0.06)


def burrito(look: Look) -> Shape:
    """A rolled wrap cut open at its left end, foil or paper round the right one."""
    long, r = look.between(0.14, 0.17), look.between(0.026, 0.031)
    body = rod(long, r, blunt=9, squash=0.88)
    face = cylinder(0.86 * r, 0.004, 24).turn(1, np.pi / 2).scale(1, 1, 0.88).move(-0.502 * long)
    fill = speck(speck(speck(textures.spots(look.rng, (176, 110, 60), (96, 56, 34), 0.25), look.rng,
                 (206, 52, 40), 16, 12), look.rng, (110, 164, 66), 16, 12), look.rng,
                 (246, 240, 220), 22, 10)  # fmt: skip
    color = look.color("cream", "beige", "ivory")
    wrap = textures.spots(look.rng, color, (190, 150, 96), 0.1)
    foil = rod(0.55 * long, 1.03 * r, blunt=9, squash=0.89).move(x=0.24 * long)
    paper = look.pick([textures.brushed_metal(look.rng, (200, 203, 208)),
                       textures.plain((226, 206, 170))])  # fmt: skip
    return settle([(body, wrap), (face, fill), (foil, paper)], 0.12)


def flatbread(look: Look) -> Shape:
    """A round flat bread with browned spots."""
    r, h = look.between(0.085, 0.11), look.between(0.006, 0.01)
    phase = look.between(0, 6)
    body = cylinder(r, h, 40, bevel=0.4 * h).bend(
        lambda p: (
            p
            * np.column_stack(
                [f := 1 + 0.025 * np.sin(3 * np.arctan2(p[:, 1], p[:, 0]) + phase), f, 0 * f + 1]
            )
        )
    )
    color = look.color("cream", "beige", "tan")
    face = textures.spots(look.rng, color, tint_color(color, 0.9), 0.2)
    y, x = np.mgrid[0:128, 0:128]
    for _ in range(16):
        a, b, d = look.rng.uniform(8, 120), look.rng.uniform(8, 120), look.rng.uniform(3, 9)
        face[np.hypot(x - a, y - b) < d] = np.array((176, 118, 62), np.uint8)
    return shape([(body, face)], [cylinder_part(0.97 * r, h)])


def _wedge(r: float, angle: float, low: float, high: float) -> Solid:
    """Return a slice of a round thing, its tip to the front."""
    a = np.linspace(np.pi / 2 - angle / 2, np.pi / 2 + angle / 2, 9)
    outline = np.concatenate([[(0, 0)], np.column_stack([r * np.cos(a), r * np.sin(a)])])
    return prism(outline - [0, 0.55 * r], low, high)


def pizza_slice(look: Look) -> Shape:
    """A slice of pizza, its crust at the back."""
    r, angle = look.between(0.15, 0.18), look.between(0.68, 0.82)
    base = _wedge(r, angle, 0, 0.008)
    cheese = _wedge(0.9 * r, 0.93 * angle, 0.0076, 0.0105).move(y=-0.045 * r)
    a = np.linspace(np.pi / 2 - 0.47 * angle, np.pi / 2 + 0.47 * angle, 11)
    at = np.column_stack([0.95 * r * np.cos(a), 0.95 * r * np.sin(a) - 0.55 * r, 0.011 + 0 * a])
    crust = tube(at, 0.0115, 10)
    melt = textures.spots(look.rng, (242, 200, 96), (214, 120, 60), 0.2)
    color = look.color("crimson", "red", "maroon", "olive")
    places = [(0, 0.32), (-0.14, 0.6), (0.13, 0.64), (0.0, 0.78), (-0.02, 0.5)]
    discs = [cylinder(0.013, 0.002, 18, bevel=0.0005).move(u * r, (v - 0.55) * r, 0.0098)
             for u, v in places]  # fmt: skip
    return shape([(join([base, crust]), skin(look, (206, 152, 86), (150, 92, 44))),
                  (cheese, melt), (join(discs), textures.plain(color))],
                 [hull_of(base, cheese), hull_above(crust)])  # fmt: skip


def cake_slice(look: Look) -> Shape:
    """A slice of layer cake, its tip to the front, cream and a berry on top."""
    r, angle, h = look.between(0.095, 0.115), look.between(0.7, 0.9), look.between(0.06, 0.075)
    tone = look.color("brown", "cream", "pink", "yellow", "white")
    sponge = textures.spots(look.rng, look.pick([(226, 184, 118), (110, 68, 44), (170, 44, 46)]),
                            (150, 104, 60), 0.1)  # fmt: skip
    icing = textures.speckles(look.rng, tone, 5)
    side = textures.stack((sponge, 3), (icing, 1), (sponge, 3), (icing, 1.4), side=96)
    body = _wedge(r, angle, 0, h)
    top = _wedge(1.02 * r, 1.02 * angle, h - 0.001, h + 0.006)
    blob = lathe([(0, 0), (0.012, 0), (0.013, 0.005), (0.006, 0.011), (0, 0.016)], 20)
    berry = ellipsoid(0.019, 0.019, 0.018, 14, 8)
    spot = (0, 0.25 * r, h + 0.0055)
    pieces = [(body, side), (top, icing), (blob.move(*spot), textures.plain((252, 250, 244))),
              (berry.move(0, 0.25 * r, h + 0.024), textures.plain((200, 36, 44)))]  # fmt: skip
    return shape(pieces, [hull_of(body, top), hull_of(blob.move(*spot), pieces[3][0])])


def pie_slice(look: Look) -> Shape:
    """A slice of pie: filling between crusts, the rim at the back."""
    r, angle, h = look.between(0.105, 0.125), look.between(0.7, 0.9), look.between(0.032, 0.04)
    crust = skin(look, (214, 164, 98), (166, 110, 58), 0.6)
    tone = look.color("orange", "crimson", "indigo", "amber", "brown")
    body = _wedge(0.97 * r, 0.98 * angle, 0.003, 0.8 * h)
    shell = [_wedge(r, angle, 0, 0.005), _wedge(0.99 * r, angle, 0.78 * h, h)]
    a = np.linspace(np.pi / 2 - 0.48 * angle, np.pi / 2 + 0.48 * angle, 11)
    at = np.column_stack([0.97 * r * np.cos(a), 0.97 * r * np.sin(a) - 0.55 * r, 0.85 * h + 0 * a])
    rim = tube(at, 0.009, 10)
    slits = [box(0.003, 0.03, 0.002).turn(2, s * 0.25).move(s * 0.016, 0.1 * r, h - 0.001)
             for s in (-1, 1)]  # fmt: skip
    fill = textures.spots(look.rng, tone, tint_color(tone, 0.7), 0.2)
    return shape([(join([*shell, rim]), crust), (body, fill), (join(slits), fill)],
                 [hull_of(body, *shell)])  # fmt: skip


def cheese_wheel(look: Look) -> Shape:
    """A round of cheese with a slice cut out, or small and white."""
    r, h = look.between(0.07, 0.095), look.between(0.045, 0.06)
    color = look.color("yellow", "golden", "red", "orange", "cream")
    a = np.linspace(-1.15, 2 * np.pi - 2.0, 40)
    outline = np.concatenate([[(0, 0)], np.column_stack([r * np.cos(a), r * np.sin(a)])])
    body = prism(outline, 0.001, h - 0.001)
    inner = textures.spots(look.rng, (248, 222, 130), (226, 186, 88), 0.06)
    rind = [prism(outline * 1.005, z, z + 0.0022) for z in (0, h - 0.0022)]
    band = np.concatenate([1.012 * outline[1:], 0.985 * outline[:0:-1]])
    shell = join([*rind, prism(band, 0, h)])
    made = [(body, inner), (shell, textures.speckles(look.rng, color, 6))]
    label = cylinder(0.4 * r, 0.0008, 26).move(0.0, 0.35 * r, h - 0.0002)
    made.append((label, textures.plain(look.own_color("white", "red", "green", "gold"))))
    return shape(made, [hull_of(prism(outline[[0, *range(1, 21)]], 0, h)),
                        hull_of(prism(outline[[0, *range(20, 41)]], 0, h))])  # fmt: skip


def cheese_slice(look: Look) -> Shape:
    """A square slice of cheese with holes shown, lying."""
    x, t = look.between(0.085, 0.095), look.between(0.003, 0.0045)
    color = look.color("yellow", "golden", "amber", "cream")
    face = textures.speckles(look.rng, color, 4, 96)
    y, u = np.mgrid[0:96, 0:96]
    for _ in range(8):
        a, b, d = look.rng.uniform(10, 86), look.rng.uniform(10, 86), look.rng.uniform(3, 9)
        face[np.hypot(u - a, y - b) < d] = np.array(tint_color(color, 0.72)).astype(np.uint8)
    return shape([(block(x, x, t, 0.006), face)], [box_part(x, x, t)])


def tofu(look: Look) -> Shape:
    """A white block of tofu with cut corners and a faint grid."""
    x, y, h = look.between(0.085, 0.1), look.between(0.065, 0.078), look.between(0.035, 0.045)
    color = look.color("ivory", "cream", "white", "ivory")
    tile = textures.spots(look.rng, color, tint_color(color, 0.93), 0.15)
    cut = [box(0.0014, y * 0.99, 0.001).move(x=(n - 1) * x / 3.2, z=h - 0.0006) for n in range(3)]
    cut += [box(x * 0.99, 0.0014, 0.001).move(y=(n - 0.5) * y / 2.4, z=h - 0.0006)
            for n in range(2)]  # fmt: skip
    return shape(
        [
            (block(x, y, h, 0.004, 0.002), tile),
            (join(cut), textures.plain(tint_color(color, 0.82))),
        ],
        [box_part(x, y, h)],
    )


def kebab(look: Look) -> Shape:
    """A skewer of grilled meat, pepper and onion lying."""
    long = look.between(0.21, 0.25)
    stick = tube([(-0.5 * long, 0, 0), (0.5 * long, 0, 0)], [0.0007, 0.0017], 6)
    tones: list[RGB] = [(126, 72, 40), (200, 46, 38), (126, 72, 40), (236, 226, 196),
                        (126, 72, 40), (88, 150, 62), (126, 72, 40)]  # fmt: skip
    pieces = [(stick, textures.wood(look.rng, (224, 190, 136)))]
    for n, tone in enumerate(tones):
        meat = tone == tones[0]
        size = 0.028 if meat else 0.026
        cube = block(0.02 if meat else 0.009, size, size, 0.006, 0.004)
        cube = cube.move(z=-size / 2).turn(0, 0.25 * (-1) ** n)
        pieces.append(
            (
                cube.move(x=-0.36 * long + 0.0195 * n),
                textures.spots(look.rng, tone, tint_color(tone, 0.55), 0.15),
            )
        )
    return settle(pieces, 0.12, hulls=[list(range(1, 8))])


def lasagna(look: Look) -> Shape:
    """A square of lasagne: layers of pasta, sauce and browned cheese."""
    x, y, h = look.between(0.085, 0.105), look.between(0.07, 0.085), look.between(0.036, 0.045)
    pasta, meat = textures.plain((240, 210, 140)), textures.spots(
        look.rng, (172, 60, 34), (110, 40, 24), 0.25)  # fmt: skip
    side = textures.stack(*[(pasta, 1), (meat, 2.2)] * 4, side=128)
    top = textures.spots(look.rng, (244, 206, 110), (190, 96, 40), 0.18)
    lid = block(1.02 * x, 1.02 * y, 0.006, 0.006, 0.002).move(z=h - 0.002)
    leaf = scatter(look, 0.016, 3, (0.018, 0.02), h + 0.0045, stretch=(1, 0.5, 0.2))
    return shape([(box(x, y, h), side), (lid, top), (leaf, textures.plain((70, 136, 58)))],
                 [hull_of(box(x, y, h), lid)])  # fmt: skip


CATEGORIES = (
    Category("dumpling", dumpling, (0.0652, 0.0368, 0.0277), 0.025, ("gyoza", "potsticker",
             "dim sum", "wonton", "pierogi", "steamed dumpling", "xiao long bao", "bao", "bao bun",
             "ravioli", "momo"), ("dining",), ("edible",), ("cream",)),
    Category("spring_roll", spring_roll, (0.0956, 0.0262, 0.0225), 0.04, ("egg roll", "lumpia",
             "summer roll"), ("dining",), ("edible",), ("amber",), state="lying flat"),
    Category("taco", taco, (0.132, 0.028, 0.0735), 0.12, ("beef taco", "taco shell", "gordita",
                 "fajita"), ("dining",),
             ("edible",), ("golden",)),
    Category("burrito", burrito, (0.157, 0.0583, 0.0445), 0.3, ("wrap", "kebab wrap",
                 "sandwich wrap", "shawarma", "tortilla wrap", "chicken wrap", "doner kebab",
                 "gyros", "chimichanga"),
             ("dining",), ("edible",), (), state="lying flat"),
    Category("flatbread", flatbread, (0.197, 0.197, 0.00835), 0.08, ("tortilla", "naan", "pita",
             "pitta",
             "pita bread", "naan bread", "flat bread", "crepe", "chapati", "pitta bread",
             "roti", "paratha", "lavash", "lahmacun", "paratha bread"),
             ("dining",), ("edible", "flat", "round", "support"), ("cream",), state="lying flat"),
    Category("pizza_slice", pizza_slice, (0.123, 0.171, 0.0219), 0.12, ("slice of pizza",
             "piece of pizza"), ("dining",), ("edible", "flat"), ("red",), state="lying flat"),
    Category("cake_slice", cake_slice, (0.0862, 0.111, 0.0989), 0.12, ("slice of cake",
             "piece of cake", "cake piece",
             "slice of chocolate cake"), ("coffee",), ("edible",), ("brown", "pink")),
    Category("pie_slice", pie_slice, (0.0912, 0.119, 0.0393), 0.13, ("slice of pie", "piece of pie",
             "slice of apple pie", "slice of quiche"), ("coffee",), ("edible",), ("amber",)),
    Category("cheese_wheel", cheese_wheel, (0.169, 0.161, 0.054), 0.9, ("wheel of cheese",
             "round of cheese", "gouda", "camembert", "brie", "brie wheel", "gouda wheel",
             "wheel of brie", "wheel of gouda", "wheel of camembert", "cheese round"),
             ("kitchen",), ("edible", "round"), ("yellow",)),
    Category("cheese_slice", cheese_slice, (0.0884, 0.0884, 0.00383), 0.022, ("slice of cheese",
             "sliced cheese", "swiss cheese slice"), ("kitchen",), ("edible", "flat"),
             ("yellow",), state="lying flat"),
    Category("tofu", tofu, (0.0924, 0.0712, 0.0411), 0.3, ("block of tofu", "tofu block", "feta",
             "paneer", "halloumi", "bean curd"), ("kitchen",), ("edible",), ("ivory",)),
    vary(Category("kebab", kebab, (0.223, 0.0321, 0.0282), 0.12, ("shish kebab", "kabob",
             "meat skewer",
             "yakitori", "grilled skewer", "shashlik", "chicken skewer"), ("dining",), ("edible",),
             (), state="lying flat")),
    Category("lasagna", lasagna, (0.0962, 0.0791, 0.0465), 0.25, ("lasagne", "moussaka",
             "piece of lasagna"), ("dining",), ("edible",), ()),
)  # fmt: skip
"""The module's categories."""
