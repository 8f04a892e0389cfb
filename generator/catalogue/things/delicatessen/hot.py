"""Roasts, chops, patties and breakfasts, hot from the pan."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import speck
from ...build.outlines import smooth
from ...build.recipes import ball, straight
from ...build.settled import hull_above, limb, rod, scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..food.food import skin
from .shore import _dome


def patty(look: Look) -> Shape:
    """A grilled burger patty with dark grill lines."""
    r, h = look.between(0.046, 0.054), look.between(0.016, 0.02)
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.35 * h), (r, 0.7 * h), (0.9 * r, h), (0, h)], 28)
    color = tint_color(look.color("brown", "brown", "bronze"), 0.95)
    bars = [box(2 * np.sqrt(r * r - y * y) * 0.86, 0.004, 0.001).move(y=y, z=h - 0.0005)
            for y in (-0.026, -0.013, 0, 0.013, 0.026)]  # fmt: skip
    return shape([(body, textures.spots(look.rng, color, tint_color(color, 0.6), 0.3)),
                  (join(bars), textures.plain(tint_color(color, 0.4)))],
                 [hull_of(body)])  # fmt: skip


def joint(look: Look) -> Shape:
    """A roast joint tied with string, one slice cut, pink inside."""
    long, r = look.between(0.15, 0.19), look.between(0.045, 0.055)
    body = rod(long, r, blunt=8, squash=0.85)
    loops = [torus(1.0 * r, 0.0014, 26, 6).turn(1, np.pi / 2).scale(1, 1, 0.86).move(x=u * long)
             for u in (-0.28, -0.08, 0.12)]  # fmt: skip
    face = cylinder(0.88 * r, 0.003, 26).turn(1, np.pi / 2).scale(1, 1, 0.85).move(x=0.478 * long)
    cut = block(0.014, 1.7 * r, 0.009, 0.006, 0.002).scale(6.0, 1, 1).move(x=0.78 * long,
                                                                         z=-0.85 * r)  # fmt: skip
    dark = skin(look, tint_color(look.color("brown", "bronze"), 0.8), (70, 38, 22), 1.0)
    rare = textures.spots(look.rng, (206, 120, 104), (176, 86, 72), 0.2)
    return settle([(body, dark), (join([face, cut]), rare),
                   (join(loops), textures.plain((232, 218, 186)))], 0.1,
                  hulls=[[0], [1]])  # fmt: skip


def meatloaf(look: Look) -> Shape:
    """A brown loaf of meat with a red glaze, its end cut."""
    x, y, h = look.between(0.17, 0.2), look.between(0.085, 0.1), look.between(0.06, 0.07)
    body = block(x, y, h, 0.02, 0.012)
    glaze = block(0.9 * x, 0.72 * y, 0.01, 0.018, 0.004).move(z=h - 0.006)
    tone = look.color("red", "crimson", "brown")
    meat = textures.spots(look.rng, (132, 84, 52), (92, 54, 34), 0.3)
    return shape([(body, meat), (glaze, textures.speckles(look.rng, tint_color(tone, 0.75), 8))],
                 [box_part(x, y, h + 0.004)])  # fmt: skip


def chop(look: Look) -> Shape:
    """A grilled chop: meat, a rim of fat, the bone sticking out."""
    k = look.between(0.9, 1.1)
    ring = smooth(
        np.array(
            [
                (-0.042, 0.0),
                (-0.03, -0.03),
                (0.005, -0.035),
                (0.034, -0.02),
                (0.03, 0.014),
                (0.0, 0.03),
                (-0.03, 0.024),
                (-0.042, 0.0),
            ]
        ),
        4,
    )[:-1]
    fat = prism(ring * 1.1, 0, 0.017, 0.004)
    meat = prism(ring * 0.96, 0.001, 0.0185, 0.003)
    bone = limb([(0.02, -0.004, 0.009), (0.048, 0.012, 0.009), (0.076, 0.022, 0.008)],
                [0.007, 0.0055, 0.007], 8)  # fmt: skip
    color = look.color("brown", "bronze", "brown")
    tile = textures.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.5), 0.22)
    return settle([(fat, textures.speckles(look.rng, (238, 210, 170), 8)), (meat, tile),
                   (bone, textures.plain((236, 226, 206)))], 0.02,
                  hulls=[[0, 1], [2]]).scale(k)  # fmt: skip


def breast(look: Look) -> Shape:
    """A chicken breast fillet, raw or grilled."""
    k = look.between(0.9, 1.1)
    ring = smooth(
        np.array(
            [
                (-0.075, 0.0),
                (-0.04, -0.035),
                (0.02, -0.042),
                (0.065, -0.014),
                (0.07, 0.012),
                (0.02, 0.036),
                (-0.04, 0.026),
                (-0.075, 0.0),
            ]
        ),
        5,
    )[:-1]
    body = _dome(ring, 0.03)
    color = look.color("beige", "amber", "tan")
    pieces = [(body, skin(look, tint_color(color, 1.1), tint_color(color, 0.85), 0.7))]
    if look.chance(0.6):
        bars = [ellipsoid(0.055, 0.004, 0.003, 8, 4).turn(2, 0.9).move(x, -0.003, 0.0285)
                for x in (-0.02, 0.0, 0.02)]  # fmt: skip
        pieces.append((join(bars), textures.plain((110, 66, 36))))
    return shape(pieces, [hull_of(body)]).scale(k)


def omelette(look: Look) -> Shape:
    """A folded omelette with herbs."""
    k = look.between(0.9, 1.1)
    a = np.linspace(0, np.pi, 16)
    half = np.column_stack([0.09 * np.cos(a), 0.075 * np.sin(a) - 0.03])
    low, top = prism(half, 0, 0.012, 0.004), prism(half * 0.97, 0.0118, 0.026, 0.005)
    egg = textures.spots(look.rng, tint_color(look.color("yellow", "amber"), 1.1), (226, 160, 70),
                         0.16)  # fmt: skip
    herbs = scatter(look, 0.045, 18, (0.003, 0.005), 0.026, stretch=(1.2, 0.5, 0.3))
    return shape([(join([low, top]), egg), (herbs, textures.plain((80, 130, 60)))],
                 [hull_of(low), hull_of(top)]).scale(k)  # fmt: skip


def scrambled_eggs(look: Look) -> Shape:
    """A heap of scrambled egg with chives."""
    x = look.between(0.095, 0.11)
    heap = []
    for k in range(30):
        away, turn = 0.42 * x * np.sqrt((k + 0.5) / 30), 2.4 * k
        size = look.between(0.02, 0.03), look.between(0.018, 0.026)
        one = ellipsoid(*size, 0.017, 10, 6).turn(2, k)
        heap.append(
            one.move(away * np.cos(turn), away * np.sin(turn), 0.009 + 0.016 * (1 - k / 30))
        )
    egg = textures.speckles(look.rng, tint_color(look.color("yellow", "yellow", "amber"), 1.25), 10)
    chives = scatter(look, 0.3 * x, 10, (0.004, 0.006), 0.032, stretch=(1, 0.5, 0.4))
    return settle([(join(heap), egg), (chives, textures.plain((80, 140, 60)))], 0.05)


def pudding_slice(look: Look) -> Shape:
    """A round slice of black pudding with pale fat in it."""
    r, h = look.between(0.027, 0.033), look.between(0.012, 0.016)
    color = look.color("black", "charcoal", "maroon")
    tile = speck(textures.speckles(look.rng, tint_color(color, 0.9), 6), look.rng, (206, 190, 176),
                 20, 5)  # fmt: skip
    body = cylinder(r, h, 26, bevel=0.0015)
    face = cylinder(0.95 * r, 0.0008, 26).move(z=h - 0.0004)
    return shape([(body, textures.plain(tint_color(color, 0.7))), (face, tile)],
                 [cylinder_part(r, h)])  # fmt: skip


def kebab_skewer(look: Look) -> Shape:
    """Kofta: minced meat pressed round a flat skewer."""
    k = look.between(0.92, 1.08)
    a = np.linspace(-1, 1, 24)
    radii = 0.0135 * np.sqrt(np.maximum(1 - np.abs(a) ** 8, 0.06)) * (1 + 0.08 * np.sin(14 * a))
    meat = tube(np.column_stack([0.075 * a, 0 * a, 0 * a]), radii, 12)
    stick = straight((-0.15, 0, 0), (0.13, 0, 0), 0.0018, 6)
    brown = textures.spots(look.rng, tint_color(look.color("brown", "bronze"), 0.9), (70, 40, 24),
                           0.3)  # fmt: skip
    return settle([(meat, brown), (stick, textures.brushed_metal(look.rng, (190, 192, 196)))], 0.12,
                  hulls=[[0, 1]]).scale(k)  # fmt: skip


def hot_dog_bun(look: Look) -> Shape:
    """A long soft roll split along its top."""
    k = look.between(0.92, 1.08)
    halves = [rod(0.155, 0.024, blunt=5, squash=0.95).move(y=s * 0.017) for s in (-1, 1)]
    base = rod(0.15, 0.026, blunt=5, squash=0.5).move(z=-0.01)
    crumb = box(0.125, 0.012, 0.004).move(z=0.0085)
    return settle([(join([*halves, base]), skin(look, (222, 164, 88), (186, 120, 56), 0.8)),
                   (crumb, textures.plain((246, 228, 186)))], 0.12).scale(k)  # fmt: skip


def hedgehog(look: Look) -> Shape:
    """Half a melon in foil stuck with sticks of cheese and pineapple."""
    r = look.between(0.062, 0.072)
    dome = lathe([(0, 0), (r, 0), (0.96 * r, 0.3 * r), (0.7 * r, 0.72 * r), (0.3 * r, 0.93 * r),
                  (0, 0.96 * r)], 28)  # fmt: skip
    sticks, cheese, fruit = [], [], []
    for n in range(26):
        up = 1 - 0.86 * (n + 0.5) / 26
        flat = np.sqrt(1 - up * up)
        way = np.array([flat * np.cos(2.4 * n), flat * np.sin(2.4 * n), up])
        a, b = way * r * 0.92, way * r * 1.5
        sticks.append(tube([a, b], 0.001, 5))
        cheese.append(box(0.014, 0.014, 0.012).turn(2, n).move(*(way * r * 1.2)))
        fruit.append(ball(0.014, 0.014, 0.012, tuple(way * r * 1.42), 7))
    foil = textures.brushed_metal(look.rng, look.color("silver", "silver", "green"))
    return shape([(dome, foil), (join(sticks), textures.plain((222, 188, 136))),
                  (join(cheese), textures.plain((246, 196, 84))),
                  (join(fruit), textures.plain((248, 226, 96)))],
                 [hull_of(dome), hull_above(*cheese, *fruit)])  # fmt: skip


_K = ("kitchen", "dining")
_E = ("edible",)
_R = ("edible", "round")
_L = "lying flat"


CATEGORIES = (
    Category("burger_patty", patty, (0.1, 0.1, 0.0188), 0.11, ("patty", "hamburger patty",
             "meat patty", "beef patty", "veggie patty", "sausage patty", "salisbury steak"), _K,
             ("edible", "flat", "round"), ("brown",), state=_L),
    Category("roast_beef", joint, (0.258, 0.0995, 0.0765), 1.0, ("roast beef joint", "beef joint",
             "roast joint", "joint of beef", "brisket", "pot roast", "roast pork", "roast lamb",
             "sunday roast", "gammon joint"), _K, ("edible", "big"), ("brown",), state=_L),
    Category("meatloaf", meatloaf, (0.189, 0.092, 0.0688), 0.8, ("meat loaf", "nut roast", "pate",
             "terrine"), _K, _E, ("red",)),
    vary(Category("lamb_chop", chop, (0.152, 0.0753, 0.018), 0.12, ("pork chop", "cutlet",
             "lamb cutlet",
             "chop", "veal chop"), _K, ("edible", "flat"), ("brown",), state=_L)),
    Category("chicken_breast", breast, (0.148, 0.0791, 0.0298), 0.17, ("chicken fillet",
             "breast of chicken", "turkey breast", "duck breast", "grilled chicken"), _K, _E,
             ("beige",), state=_L),
    Category("omelette", omelette, (0.178, 0.0862, 0.0264), 0.15, ("omelet", "folded omelette",
             "frittata", "tamagoyaki"), ("breakfast",), ("edible", "flat"), ("yellow",),
             state=_L),
    Category("scrambled_eggs", scrambled_eggs, (0.1, 0.101, 0.0308), 0.12, ("heap of scrambled egg",
             "scrambled egg", "scrambled egg heap",
             "bowl of scrambled eggs"), ("breakfast",), _E, ("yellow",), state=_L),
    Category("black_pudding", pudding_slice, (0.0589, 0.0593, 0.0143), 0.03, ("black pudding slice",
             "blood sausage", "slice of black pudding", "white pudding"), ("breakfast",),
             ("edible", "round", "flat"), ("black",), state=_L),
    vary(Category("kofta", kebab_skewer, (0.275, 0.0286, 0.0251), 0.1, ("kofta kebab",
             "seekh kebab",
             "kofte", "kafta", "adana kebab"), _K, _E, ("brown",), state=_L)),
    vary(Category("hot_dog_bun", hot_dog_bun, (0.153, 0.0811, 0.0391), 0.05, ("hotdog bun",
             "finger roll", "brioche hot dog bun", "sub roll", "hot dog roll"), _K, _E, (),
             state=_L)),
    Category("pineapple_hedgehog", hedgehog, (0.192, 0.191, 0.0991), 0.6,
             ("cheese and pineapple hedgehog", "cheese hedgehog", "cheese and pineapple"),
             ("dining",), _R, ("silver",)),
)  # fmt: skip
"""The module's categories."""
