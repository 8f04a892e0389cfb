"""Bread and pastries by the piece: toast, rolls, bagels, pretzels, waffles, tarts, macarons."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe, speck
from ...build.outlines import ellipse, rectangle, smooth
from ...build.settled import limb, rod, scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin

CRUST: RGB = (196, 136, 72)
DARK: RGB = (150, 94, 46)


def _crust(look: Look) -> textures.Tile:
    color = look.color("amber", "copper", "tan")
    return skin(look, tint_color(color, 0.95), DARK, 0.7)


def toast(look: Look) -> Shape:
    """A slice of toasted bread lying flat, its crust darker than its crumb."""
    side = [(-0.9, -1), (0.9, -1), (0.94, 0.3), (1.06, 0.55), (0.95, 0.92), (0.5, 1.04),
            (0, 0.97)]  # fmt: skip
    half = np.array(side + [(-x, y) for x, y in side[2:6][::-1]], float)
    ring = smooth(np.concatenate([half, half[:1]]), 3)[:-1]
    w, t = look.between(0.05, 0.058), look.between(0.012, 0.016)
    color = look.color("tan", "amber", "tan", "beige")
    face = textures.spots(look.rng, tint_color(color, 1.15), tint_color(color, 0.72), 0.35)
    edge = prism(w * ring, 0, t)
    crumb = prism(0.9 * w * ring, 0.0008, t + 0.0008)
    return shape([(edge, textures.speckles(look.rng, (140, 84, 42), 8)), (crumb, face)],
                 [hull_of(edge), hull_of(crumb)])  # fmt: skip


def baguette(look: Look) -> Shape:
    """A long crusty loaf with slanted cuts."""
    long, r = look.between(0.4, 0.48), look.between(0.028, 0.034)
    bread = rod(long, r, blunt=5, squash=0.8)
    cuts = [ellipsoid(0.075, 0.02, 0.012, 12, 6).turn(2, 0.45).move(x=u * long, z=0.76 * r)
            for u in (-0.34, -0.17, 0.0, 0.17, 0.34)]  # fmt: skip
    pale = textures.speckles(look.rng, (236, 204, 146), 8)
    return settle([(bread, _crust(look)), (join(cuts), pale)], 0.1)


def bread_roll(look: Look) -> Shape:
    """A round roll with a cut across its top."""
    r, h = look.between(0.04, 0.05), look.between(0.045, 0.058)
    dome = lathe([(0, 0), (0.8 * r, 0), (r, 0.28 * h), (0.9 * r, 0.62 * h), (0.5 * r, 0.94 * h),
                  (0, h)], 26)  # fmt: skip
    pieces = [(dome, _crust(look))]
    if look.chance(0.5):
        cut = ellipsoid(1.2 * r, 0.011, 0.01, 12, 6).move(z=0.96 * h)
        pieces.append((cut, textures.speckles(look.rng, (240, 212, 160), 6)))
    else:
        pieces.append((scatter(look, 0.7 * r, 26, (0.0035, 0.0045), 0.8 * h, dome=0.2 * h,
                               stretch=(1, 0.7, 0.5)),
                       textures.plain((246, 232, 190))))  # fmt: skip
    return shape(pieces, [hull_of(dome)])


def bagel(look: Look) -> Shape:
    """A ring of bread with seeds on it."""
    r, t = look.between(0.031, 0.036), look.between(0.018, 0.021)
    ring = torus(r, t, 30, 12).scale(1, 1, 0.85)
    color = look.pick([(246, 232, 190), (50, 46, 48)])
    seeds = []
    for k in range(34):
        a, b = 2.4 * k, look.between(-0.9, 0.9)
        at = (r + t * np.sin(b)) * np.array([np.cos(a), np.sin(a)])
        seeds.append(ellipsoid(0.0045, 0.003, 0.002, 6, 4).turn(2, a).move(
            at[0], at[1], 0.85 * t * np.cos(b)))  # fmt: skip
    return settle([(ring, _crust(look)), (join(seeds), textures.plain(color))], 0.1)


def pretzel(look: Look) -> Shape:
    """A salted pretzel knot lying flat."""
    k, r = look.between(0.95, 1.15), look.between(0.0072, 0.009)
    half = [(0.0, -0.054), (0.036, -0.046), (0.062, -0.014), (0.057, 0.024), (0.03, 0.032),
            (0.004, 0.002), (-0.024, -0.04)]  # fmt: skip
    first = [(x, y, 0.0 if n < 4 else 0.0035) for n, (x, y) in enumerate(half)]
    second = [(-x, y, 0.0 if n < 4 else 0.0065) for n, (x, y) in enumerate(half)]
    path = k * np.array([*second[::-1], *first[1:]])
    radii = r * np.concatenate([[0.55, 0.7], np.full(len(path) - 4, 1.0), [0.7, 0.55]])
    knot = limb(path, [*radii], 10)
    salt = []
    points = smooth(path, 4)
    for _ in range(22):
        n = int(look.rng.integers(4, len(points) - 4))
        x, y, z = points[n]
        salt.append(box(0.003, 0.0025, 0.0022).turn(2, look.between(0, 3)).move(
            x, y, z + 0.85 * r))  # fmt: skip
    brown = skin(look, look.color("bronze", "brown", "copper"), (104, 56, 26), 0.6)
    return settle([(knot, brown), (join(salt), textures.plain((250, 248, 240)))], 0.15)


def muffin(look: Look) -> Shape:
    """A muffin in a pleated paper case, blueberries or chocolate in its dome."""
    r, h = look.between(0.032, 0.037), look.between(0.062, 0.074)
    case = lobe(lathe([(0, 0), (0.72 * r, 0), (r, 0.5 * h), (0, 0.5 * h)], 60), 30, 0.07)
    dome = lathe([(0, 0.46 * h), (1.06 * r, 0.47 * h), (1.24 * r, 0.6 * h), (1.1 * r, 0.8 * h),
                  (0.62 * r, 0.96 * h), (0, h)], 28)  # fmt: skip
    tone: RGB = look.pick([(216, 158, 84), (206, 146, 76), (92, 54, 36)])
    dots = (52, 46, 92) if sum(tone) > 300 else (48, 28, 20)
    crumb = speck(skin(look, tone, tint_color(tone, 0.75)), look.rng, dots, 30, 6)
    paper = look.color("white", "brown", "cream", "pink", "sky", "red")
    return shape([(case, textures.speckles(look.rng, paper, 5)), (dome, crumb)],
                 [hull_of(case), hull_of(dome)])  # fmt: skip


def waffle(look: Look) -> Shape:
    """A square or round waffle with deep pockets."""
    x, t = look.between(0.1, 0.125), look.between(0.016, 0.02)
    round_ = look.chance(0.4)
    base = cylinder(x / 2, 0.6 * t, 36) if round_ else block(x, x, 0.6 * t, 0.008)
    ribs = []
    for k in range(6):
        at = (k / 5 - 0.5) * 0.94 * x
        long = 2 * np.sqrt(max(0.25 * x * x - at * at, (0.1 * x) ** 2)) if round_ else x
        rib = box(0.98 * long, 0.05 * x, t)
        ribs += [rib.move(y=at), rib.turn(2, np.pi / 2).move(x=at)]
    gold = skin(look, look.color("amber", "tan", "golden"), DARK, 0.6)
    pieces = [(base, textures.speckles(look.rng, (190, 124, 60), 8)), (join(ribs), gold)]
    parts = [cylinder_part(x / 2, t) if round_ else box_part(x, x, t)]
    if look.chance(0.5):
        pat = block(0.024, 0.024, 0.008, 0.003, 0.002).turn(2, 0.4).move(z=t - 0.0005)
        pieces.append((pat, textures.plain((250, 228, 130))))
        parts.append(hull_of(pat))
    return shape(pieces, parts)


def tart(look: Look) -> Shape:
    """A small fluted tart with custard and berries."""
    r, h = look.between(0.045, 0.058), look.between(0.022, 0.028)
    shell = lobe(lathe([(0, 0), (0.8 * r, 0), (r, h), (0.9 * r, h), (0.84 * r, 0.7 * h),
                        (0, 0.7 * h)], 60), 22, 0.05)  # fmt: skip
    cream = cylinder(0.87 * r, 0.12 * h, 28).move(z=0.68 * h)
    tone = look.color("red", "indigo", "crimson", "orange")
    fruit = scatter(look, 0.72 * r, 15, (0.016, 0.02), h, dome=0.1 * h)
    return shape([(shell, _tint(look)), (cream, textures.speckles(look.rng, (248, 222, 140), 5)),
                  (fruit, textures.gradient(tint_color(tone, 0.8), tone, look.rng))],
                 [hull_of(shell), hull_of(fruit)])  # fmt: skip


def _tint(look: Look) -> textures.Tile:
    return skin(look, CRUST, DARK, 0.5)


def cinnamon_roll(look: Look) -> Shape:
    """A rolled bun seen from above as a spiral, with icing."""
    r, h = look.between(0.042, 0.05), look.between(0.034, 0.042)
    t = np.linspace(0.4, 5.6 * np.pi, 64)
    away = 0.9 * r * t / t[-1]
    spiral = np.column_stack([away * np.cos(t), away * np.sin(t), np.zeros(64)])
    roll = tube(spiral, 0.16 * r, 8)
    roll = roll.scale(1, 1, 0.47 * h / (0.16 * r)).move(z=0.5 * h)
    core = cylinder(0.86 * r, 0.62 * h, 26).move(z=0.05 * h)
    brown = textures.speckles(look.rng, (112, 62, 32), 8)
    pieces = [(roll, skin(look, (214, 156, 90), (176, 112, 56), 0.6)), (core, brown)]
    if look.chance(0.5):
        w = np.linspace(-0.75, 0.75, 40)
        zig = np.column_stack([w * r, 0.6 * r * np.sin(9 * w) * np.sqrt(1 - w**2),
                               np.full(40, 0.98 * h)])  # fmt: skip
        pieces.append((tube(zig, 0.0024, 6, squash=0.7), textures.plain((250, 246, 236))))
    return settle(pieces, 0.02)


def gingerbread_man(look: Look) -> Shape:
    """A gingerbread man lying on his back, eyes, smile and buttons of icing."""
    k, t = look.between(0.9, 1.1), look.between(0.009, 0.012)
    head = prism(ellipse(0.052, 0.052, 24), 0, t, 0.002).move(y=0.046)
    trunk = prism(rectangle(0.044, 0.07, 0.016), 0, t, 0.002).move(y=-0.005)
    arms = prism(rectangle(0.112, 0.026, 0.0125), 0.0001, t - 0.0001, 0.002).move(y=0.012)
    legs = [prism(rectangle(0.028, 0.066, 0.0135), 0.0001, t - 0.0002, 0.002)
            .turn(2, s * 0.24).move(s * 0.02, -0.05) for s in (-1, 1)]  # fmt: skip
    parts = [head, trunk, arms, *legs]
    dot = cylinder(0.0028, 0.002, 10).move(z=t - 0.0008)
    eyes = [dot.move(s * 0.009, 0.053) for s in (-1, 1)]
    buttons = [dot.scale(1.3, 1.3, 1).move(0, y) for y in (0.012, -0.006, -0.024)]
    a = np.linspace(-2.5, -0.64, 8)
    lips = tube(np.column_stack([0.013 * np.cos(a), 0.048 + 0.013 * np.sin(a), np.full(8, t)]),
                0.0012, 5)  # fmt: skip
    cuffs = [tube([(s * 0.047, 0.001, t), (s * 0.044, 0.012, t), (s * 0.047, 0.023, t)], 0.0013, 5)
             for s in (-1, 1)]  # fmt: skip
    cuffs += [tube([(s * 0.02, -0.071, t), (s * 0.03, -0.068, t), (s * 0.038, -0.066, t)], 0.0013,
                   5) for s in (-1, 1)]  # fmt: skip
    icing = textures.plain((250, 248, 242))
    tone = textures.plain(look.own_color("red", "green", "blue"))
    brown = textures.speckles(look.rng, look.color("copper", "brown", "bronze"), 8)
    made = shape([(join(parts), brown), (join([*eyes, lips, *cuffs]), icing),
                  (join(buttons), tone)], [hull_of(p) for p in parts])  # fmt: skip
    return made.scale(k)


def brownie(look: Look) -> Shape:
    """A square of brownie with a crackled top, walnuts in it."""
    x, h = look.between(0.055, 0.068), look.between(0.028, 0.034)
    dark = textures.spots(look.rng, (66, 38, 26), (40, 22, 16), 0.2)
    top = speck(textures.spots(look.rng, (104, 64, 42), (60, 34, 24), 0.25), look.rng,
                (206, 160, 106), 7, 9)  # fmt: skip
    return shape([(block(x, x, h, 0.004, 0.001), dark),
                  (block(x, x, 0.003, 0.004, 0.001).move(z=h - 0.0015), top)],
                 [box_part(x, x, h + 0.0015)])  # fmt: skip


def macaron(look: Look) -> Shape:
    """Two smooth almond shells with ruffled feet around a cream."""
    r, h = look.between(0.021, 0.025), look.between(0.024, 0.028)
    color = look.color("pink", "mint", "yellow", "lavender", "brown", "coral", "sky", "green")
    shell = [(0, 0), (0.7 * r, 0.01 * h), (0.95 * r, 0.13 * h), (r, 0.24 * h), (r, 0.38 * h),
             (0, 0.38 * h)]  # fmt: skip
    lower = lathe(shell, 28)
    upper = lathe([(x, h - z) for x, z in shell[::-1]], 28)
    feet = [lobe(torus(r, 0.045 * h, 48, 6), 20, 0.05).move(z=z) for z in (0.36 * h, 0.64 * h)]
    cream = cylinder(0.96 * r, 0.26 * h, 26).move(z=0.37 * h)
    white = textures.plain(tint_color(color, 1.55))
    pieces = [(join([lower, upper, *feet]), textures.speckles(look.rng, color, 5)), (cream, white)]
    return shape(pieces, [hull_of(*(s for s, _ in pieces))])


def eclair(look: Look) -> Shape:
    """A long choux pastry with glossy chocolate on top."""
    long, r = look.between(0.115, 0.14), look.between(0.019, 0.022)
    dough = rod(long, r, blunt=5, squash=0.85)
    glaze = rod(0.93 * long, 0.86 * r, blunt=6, squash=0.5).move(z=0.5 * r)
    tone = look.color("brown", "brown", "pink", "cream", "maroon")
    dark = textures.speckles(look.rng, tint_color(tone, 0.62), 4)
    w = np.linspace(-0.4, 0.4, 40)
    zig = np.column_stack([w * long, 0.35 * r * np.sin(44 * w), np.full(40, 0.93 * r)])
    return settle([(dough, _tint(look)), (glaze, dark),
                   (tube(zig, 0.0013, 5), textures.plain(tint_color(tone, 1.6)))], 0.1)  # fmt: skip


CATEGORIES = (
    Category("toast", toast, (0.116, 0.116, 0.0144), 0.03, ("slice of bread", "bread slice",
             "slice of toast", "piece of toast", "piece of bread", "toasted bread", "toast slice"),
             ("breakfast", "kitchen"), ("edible", "flat", "support"), ("tan",), state="lying flat"),
    Category("baguette", baguette, (0.418, 0.0629, 0.049), 0.25, ("french bread", "french loaf",
             "stick of bread", "french stick"), ("kitchen", "dining"), ("edible", "big"),
             ("amber",), state="lying flat"),
    Category("bread_roll", bread_roll, (0.0903, 0.091, 0.0528), 0.06, ("bun", "dinner roll",
             "burger bun", "bread bun"), ("breakfast", "dining"), ("edible",
             "round"), ("amber",)),
    Category("bagel", bagel, (0.106, 0.106, 0.0301), 0.1, ("sesame bagel", "poppy seed bagel",
             "simit"),
             ("breakfast",), ("edible", "round", "flat"), ("amber",), state="lying flat"),
    Category("pretzel", pretzel, (0.152, 0.11, 0.0212), 0.08, ("soft pretzel", "brezel",
             "salted pretzel"), ("kitchen", "dining"), ("edible", "flat"), ("brown",),
             state="lying flat"),
    Category("muffin", muffin, (0.0855, 0.0855, 0.0682), 0.1, ("blueberry muffin",
             "chocolate muffin"), ("coffee",), ("edible", "round"), ("white", "brown")),
    Category("waffle", waffle, (0.113, 0.113, 0.0225), 0.08, ("belgian waffle",), ("breakfast",),
             ("edible", "flat"), ("amber",), state="lying flat"),
    Category("tart", tart, (0.107, 0.106, 0.0374), 0.09, ("fruit tart", "tartlet", "egg tart",
             "berry tart", "custard tart", "fruit tartlet"), ("coffee", "tea"), ("edible", "round"),
             ("red",)),
    Category("cinnamon_roll", cinnamon_roll, (0.0837, 0.0887, 0.037), 0.09, ("cinnamon bun",
             "sticky bun", "chelsea bun"), ("coffee",), ("edible", "round"), ()),
    Category("gingerbread_man", gingerbread_man, (0.112, 0.155, 0.012), 0.04, ("gingerbread",
             "gingerbread cookie", "gingerbread biscuit", "gingerbread man ornament"), ("coffee",
             "tea"), ("edible", "flat"), ("brown",), state="lying flat"),
    Category("brownie", brownie, (0.0612, 0.0612, 0.0325), 0.08, ("chocolate brownie",
             "brownie square"), ("coffee",), ("edible",), ()),
    Category("macaron", macaron, (0.0482, 0.0482, 0.0261), 0.018, ("macaroon", "french macaron"),
             ("coffee", "tea"), ("edible", "round"), ("pink", "mint")),
    Category("eclair", eclair, (0.126, 0.0419, 0.0343), 0.08, ("chocolate eclair",), ("coffee",),
             ("edible",), ("brown",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
