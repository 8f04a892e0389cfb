"""Buns and pastries: scones, Danish, turnovers, strudel, cannoli, samosas, palmiers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe, speck
from ...build.outlines import smooth
from ...build.recipes import ball, pad
from ...build.settled import rod, scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import skin
from .loaves import crust

CREAM: RGB = (250, 244, 230)


def scone(look: Look) -> Shape:
    """A tall scone, split round its middle, fruit in it or cream and jam on it."""
    r, h = look.between(0.032, 0.037), look.between(0.042, 0.05)
    low = lathe([(0, 0), (0.94 * r, 0), (0.97 * r, 0.45 * h), (0, 0.45 * h)], 26)
    top = lathe([(0, 0.47 * h), (r, 0.48 * h), (0.98 * r, 0.86 * h), (0.8 * r, h), (0, h)], 26)
    seam = cylinder(0.93 * r, 0.05 * h, 26).move(z=0.44 * h)
    pieces = [(join([low, top]), speck(skin(look, (238, 208, 150), (206, 146, 76), 0.8), look.rng,
               (70, 44, 40), 12, 5)), (seam, textures.plain((250, 238, 208)))]  # fmt: skip
    if look.chance(0.5):
        pieces += [(ellipsoid(1.3 * r, 1.3 * r, 0.3 * h, 18, 8).move(z=h), textures.plain(CREAM)),
                   (ellipsoid(0.8 * r, 0.8 * r, 0.24 * h, 16, 8).move(z=1.1 * h),
                    textures.plain((176, 24, 46)))]  # fmt: skip
    return shape(pieces, [hull_of(low, top)])


def brioche(look: Look) -> Shape:
    """A fluted bun with a small ball on top."""
    r, h = look.between(0.036, 0.042), look.between(0.06, 0.068)
    base = lobe(lathe([(0, 0), (0.66 * r, 0), (r, 0.48 * h), (0.9 * r, 0.62 * h), (0.4 * r,
                0.74 * h), (0, 0.74 * h)], 48), 12, 0.14)  # fmt: skip
    head = ball(0.95 * r, 0.95 * r, 0.8 * r, (0, 0, 0.82 * h), 18)
    glaze = skin(look, tint_color(look.color("copper", "amber"), 0.95), (130, 70, 28), 0.8)
    return shape([(base, glaze), (head, glaze)], [hull_of(base), hull_of(head)])


def danish(look: Look) -> Shape:
    """A square of puff pastry, its corners folded in over custard or fruit, iced."""
    x = look.between(0.085, 0.1)
    base = block(x, x, 0.016, 0.008, 0.003)
    frame = [box(0.72 * x, 0.13 * x, 0.012).turn(2, 0.785 + n * 1.571).move(
        0.33 * x * np.cos(n * 1.571), 0.33 * x * np.sin(n * 1.571), 0.013)
        for n in range(4)]  # fmt: skip
    fill = ellipsoid(0.56 * x, 0.56 * x, 0.02, 20, 8).move(z=0.016)
    tone = look.own_color("amber", "red", "indigo", "yellow")
    t = np.linspace(-0.62, 0.62, 30)
    zig = np.column_stack([t * x * 0.8, 0.2 * x * np.sin(16 * t), np.full(30, 0.028)])
    return shape([(base, crust(look)), (join(frame), crust(look, (170, 104, 50))),
                  (fill, textures.speckles(look.rng, tone, 9)),
                  (tube(zig, 0.0018, 5), textures.plain(CREAM))],
                 [hull_of(base), hull_of(fill, *frame)])  # fmt: skip


def cross_bun(look: Look) -> Shape:
    """A glazed spiced bun with a pale cross."""
    r, h = look.between(0.042, 0.05), look.between(0.042, 0.05)
    side = [(0, 0), (0.86 * r, 0), (r, 0.3 * h), (0.9 * r, 0.66 * h), (0.5 * r, 0.94 * h), (0, h)]
    bun = lathe(side, 26)
    rise = np.array(side[2:])
    bars = []
    for turn in (0, np.pi / 2):
        half = [(x, 0, z + 0.0008) for x, z in rise]
        path = [*half, *[(-x, 0, z) for x, _, z in half[-2::-1]]]
        bars.append(tube(smooth(path, 3), 0.0042, 6, squash=0.5).turn(2, turn))
    brown = skin(look, (156, 92, 48), (110, 58, 28), 0.7)
    return shape([(bun, brown), (join(bars), textures.plain((246, 228, 186)))], [hull_of(bun)])


def turnover(look: Look) -> Shape:
    """A golden triangle of puff pastry with crimped edges."""
    k = look.between(0.9, 1.1)
    tri = np.array([(-0.06, -0.032), (0.06, -0.032), (0, 0.055)]) * k
    ring = smooth(np.concatenate([tri, tri[:1]]), 6)[:-1] * 0.3 + _edge(tri, 6) * 0.7
    levels = [(0.97, 0), (1.0, 0.004), (1.0, 0.008), (0.86, 0.01), (0.6, 0.026), (0.2, 0.03)]
    body = _stack(ring, [(f, z * k) for f, z in levels])
    cuts = [ellipsoid(0.022, 0.003, 0.002, 8, 4).turn(2, 1.2).move(0.014 * n, -0.004, 0.0285 * k)
            for n in (-1, 0, 1)]  # fmt: skip
    gold = textures.spots(look.rng, look.color("amber", "copper"), (170, 104, 46), 0.25)
    return shape([(body, gold), (join(cuts), textures.plain((110, 60, 30)))], [hull_of(body)])


def _edge(corners: np.ndarray, steps: int) -> np.ndarray:
    after = np.roll(corners, -1, 0)
    return np.concatenate([a + (b - a) * np.linspace(0, 1, steps, endpoint=False)[:, None]
                           for a, b in zip(corners, after, strict=True)])  # fmt: skip


def _stack(ring: np.ndarray, levels: list[tuple[float, float]]):
    from ...build.solids import loft

    return loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
                ring)  # fmt: skip


def samosa(look: Look) -> Shape:
    """A plump fried pyramid of pastry with a crimped seam."""
    k = look.between(0.9, 1.1)
    tri = np.array([(-0.046, -0.03), (0.046, -0.03), (0, 0.05)]) * k
    ring = _edge(tri, 6) * 0.72 + 0.28 * 0.042 * k * _unit(_edge(tri, 6))
    levels = [(0.82, 0), (1.0, 0.01), (0.95, 0.022), (0.62, 0.042), (0.25, 0.056), (0.06, 0.06)]
    body = _stack(ring, [(f, z * k) for f, z in levels])
    fried = textures.spots(look.rng, tint_color(look.color("amber", "copper"), 0.95),
                           (150, 84, 34), 0.28)  # fmt: skip
    return shape([(body, fried)], [hull_of(body)])


def _unit(p: np.ndarray) -> np.ndarray:
    return p / np.linalg.norm(p, axis=1, keepdims=True)


def strudel(look: Look) -> Shape:
    """A rolled pastry log, sugared and slashed."""
    long, r = look.between(0.2, 0.25), look.between(0.036, 0.042)
    body = rod(long, r, blunt=9, squash=0.7)
    cuts = [ellipsoid(0.05, 0.006, 0.006, 10, 5).turn(2, 1.1).move(x=u * long, z=0.66 * r)
            for u in (-0.3, -0.15, 0, 0.15, 0.3)]  # fmt: skip
    tile = speck(np.asarray(crust(look)), look.rng, (252, 250, 246), 90, 3)
    return settle([(body, tile), (join(cuts), textures.plain((122, 70, 34)))], 0.1)


def cannoli(look: Look) -> Shape:
    """A crisp tube filled with cream at both ends."""
    long, r = look.between(0.1, 0.12), look.between(0.016, 0.019)
    shell = cylinder(r, long, 24).turn(1, np.pi / 2).move(x=-long / 2)
    lip = torus(r, 0.0016, 22, 6).turn(1, np.pi / 2)
    cream = [ball(1.2 * r, 1.7 * r, 1.7 * r, (s * 0.5 * long, 0, 0), 14) for s in (-1, 1)]
    fried = textures.spots(look.rng, (206, 142, 78), (150, 90, 44), 0.35)
    chips = [box(0.003, 0.003, 0.002).move(s * (0.5 * long + 0.45 * r), 0.004 * n, 0.003 * n)
             for s in (-1, 1) for n in (-1, 0, 1)]  # fmt: skip
    return settle([(join([shell, lip.move(x=-long / 2), lip.move(x=long / 2)]), fried),
                   (join(cream), textures.plain(CREAM)),
                   (join(chips), textures.plain((70, 40, 26)))], 0.12, hulls=[[0, 1]])  # fmt: skip


def profiterole(look: Look) -> Shape:
    """A choux puff with chocolate poured over it."""
    r = look.between(0.021, 0.025)
    bun = lathe([(0, 0), (0.8 * r, 0), (r, 0.5 * r), (0.85 * r, 1.1 * r), (0.4 * r, 1.5 * r),
                 (0, 1.55 * r)], 22)  # fmt: skip
    cap = lathe([(0, 1.0 * r), (0.97 * r, 0.8 * r), (0.92 * r, 1.12 * r), (0.44 * r, 1.56 * r),
                 (0, 1.62 * r)], 22)  # fmt: skip
    runs = [ball(0.3 * r, 0.3 * r, 0.6 * r, (0.93 * r * np.cos(a), 0.93 * r * np.sin(a), 0.72 * r),
                 8) for a in (0.3, 1.7, 2.9, 4.2, 5.3)]  # fmt: skip
    dark = textures.plain(tint_color(look.color("brown", "brown", "white"), 0.55))
    return shape([(bun, crust(look)), (join([cap, *runs]), dark)], [hull_of(bun, cap)])


def palmier(look: Look) -> Shape:
    """A heart-shaped scroll of sugared puff pastry lying flat."""
    k = look.between(0.9, 1.15)
    t = np.linspace(0, 2.6 * np.pi, 40)
    away = 0.024 - 0.0024 * t
    half = np.column_stack([0.024 - away * np.cos(t), 0.012 + away * np.sin(t), 0 * t])
    arm = np.concatenate([[(0.002, -0.044, 0), (0.001, -0.02, 0)], half])
    sides = [tube(smooth(arm * [s, 1, 1], 2), 0.0052, 7) for s in (1, -1)]
    gold = textures.spots(look.rng, (232, 178, 100), (180, 108, 46), 0.3)
    return settle([(join(sides), gold)], 0.08).scale(k)


def bear_claw(look: Look) -> Shape:
    """A curved almond pastry with toes cut along its edge."""
    k = look.between(0.9, 1.1)
    body = rod(0.12, 0.025, bend=0.05, blunt=5, squash=0.75)
    toes = [ball(0.026, 0.036, 0.03, (0.03 * n, -0.028 + 0.006 * n * n, 0.002), 12)
            for n in (-1.6, -0.55, 0.55, 1.6)]  # fmt: skip
    nuts = scatter(look, 0.03, 14, (0.009, 0.012), 0.019, stretch=(1, 0.6, 0.3))
    return settle([(join([body, *toes]), crust(look)),
                   (nuts, textures.plain((240, 220, 176)))], 0.1).scale(k)  # fmt: skip


def baba(look: Look) -> Shape:
    """A soaked ring or cork of sponge with cream on it."""
    r, h = look.between(0.03, 0.036), look.between(0.036, 0.042)
    ring = lobe(lathe([(0, 0), (r, 0), (0.96 * r, 0.7 * h), (0.7 * r, h), (0, 0.9 * h)], 40), 10,
                0.1)  # fmt: skip
    swirl = [ball(s * r, s * r, 0.34 * r, (0, 0, h + 0.18 * r * n), 14)
             for n, s in enumerate((1.1, 0.8, 0.45))]  # fmt: skip
    cherry = ball(0.3 * r, 0.3 * r, 0.3 * r, (0, 0, h + 0.72 * r), 10)
    return shape([(ring, skin(look, (206, 138, 62), (156, 90, 36), 0.8)),
                  (join(swirl), textures.plain(CREAM)), (cherry, textures.plain((190, 24, 40)))],
                 [hull_of(ring), hull_of(*swirl)])  # fmt: skip


def pastry_square(look: Look) -> Shape:
    """Baklava: a diamond of thin layers, syrupy, green nuts on top."""
    x, h = look.between(0.042, 0.05), look.between(0.026, 0.032)
    body = box(x, x, h).turn(2, np.pi / 4).scale(1.35, 0.85, 1)
    layers = textures.stripes([(216, 156, 78), (168, 104, 44), (232, 182, 104)], 5)
    top = box(0.99 * x, 0.99 * x, 0.0012).turn(2, np.pi / 4).scale(1.35, 0.85, 1).move(z=h - 0.0005)
    nuts = scatter(look, 0.012, 12, (0.004, 0.006), h + 0.001)
    return shape([(body, layers), (top, textures.spots(look.rng, (222, 160, 78), (176, 108, 44),
                  0.25)), (nuts, textures.plain((116, 150, 60)))], [hull_of(body)])  # fmt: skip


def coil(look: Look) -> Shape:
    """A spiral of filled filo pastry."""
    r = look.between(0.055, 0.07)
    t = np.linspace(0.8, 5.4 * np.pi, 60)
    away = 0.86 * r * t / t[-1]
    path = np.column_stack([away * np.cos(t), away * np.sin(t), np.zeros(60)])
    roll = tube(path, 0.17 * r, 8)
    gold = textures.spots(look.rng, (220, 154, 78), (160, 90, 38), 0.3)
    return settle([(roll, gold)], 0.12)


def orange_spiral(look: Look) -> Shape:
    """Jalebi: a loose syrupy spiral, bright orange."""
    r = look.between(0.032, 0.04)
    t = np.linspace(0.5, 6.2 * np.pi, 70)
    away = 0.9 * r * t / t[-1]
    path = np.column_stack([away * np.cos(t), away * np.sin(t), 0.002 * np.sin(7 * t)])
    cross = tube([(-r, 0.1 * r, 0.003), (0, -0.1 * r, 0.0045), (r, 0.15 * r, 0.003)], 0.0032, 6)
    syrup = textures.gradient((226, 110, 20), (246, 156, 40), look.rng)
    return settle([(join([tube(path, 0.004, 7), cross]), syrup)], 0.1)


def case(look: Look) -> Shape:
    """An empty pleated paper case for a cupcake."""
    from ...build.recipes import open_vessel

    r, h = look.between(0.034, 0.038), look.between(0.03, 0.034)
    body, parts = open_vessel([(0.68 * r, 0), (r, h)], 0.0014, 0.0014, 48)
    color = look.color("pink", "white", "sky", "yellow", "mint", "red", "brown")
    pleats = textures.stripes([color, tint_color(color, 0.82)], 24, upright=True, side=96)
    return shape([(body, pleats)], parts)


def halva(look: Look) -> Shape:
    """A block of halva with pistachios."""
    x, y, h = look.between(0.09, 0.12), look.between(0.055, 0.07), look.between(0.035, 0.045)
    tile = speck(textures.scratches(look.rng, look.color("beige", "tan"), (214, 190, 150), 90),
                 look.rng, (130, 160, 76), 26, 5)  # fmt: skip
    return shape([(block(x, y, h, 0.003, 0.001), tile)], [box_part(x, y, h)])


def cushion(look: Look) -> Shape:
    """A glazed pastry square caramelised at its folded corners."""
    x = look.between(0.07, 0.085)
    body = pad(x, x, 0.04, 0.014, soft=0.6)
    flaps = [ball(0.036, 0.036, 0.018, (0.2 * x * i, 0.2 * x * j, 0.036), 12)
             for i in (-1, 1) for j in (-1, 1)]  # fmt: skip
    amber = textures.spots(look.rng, (206, 130, 56), (128, 66, 26), 0.3)
    return shape([(join([body, *flaps]), amber)], [hull_of(body), cylinder_part(0.3 * x, 0.042)])


_T = ("coffee", "tea")
_E = ("edible",)
CATEGORIES = (
    Category("scone", scone, (0.0695, 0.07, 0.0527), 0.07, ("fruit scone", "cheese scone",
             "rock cake", "soda scone"), _T, ("edible", "round"), ()),
    vary(Category("brioche", brioche, (0.0817, 0.0817, 0.0688), 0.06, ("brioche bun",
             "brioche roll",
             "brioches"), _T, ("edible", "round"), ("copper",))),
    Category("danish_pastry", danish, (0.117, 0.117, 0.0297), 0.09, ("danish", "fruit danish",
             "custard danish", "apple danish"), _T, ("edible", "flat"), ("amber",)),
    vary(Category("hot_cross_bun", cross_bun, (0.0997, 0.0997, 0.0509), 0.07, ("cross bun",
             "easter bun"), _T, ("edible", "round"), ())),
    Category("turnover", turnover, (0.119, 0.088, 0.0297), 0.09, ("apple turnover",
             "cherry turnover", "pasty", "puff pastry triangle"), _T,
             _E, ("amber",), state="lying flat"),
    Category("samosa", samosa, (0.0847, 0.08, 0.0591), 0.06, ("vegetable samosa", "somosa",
             "sambusa"), ("dining",), _E, ("amber",)),
    Category("strudel", strudel, (0.229, 0.0773, 0.0505), 0.45, ("apple strudel",
             "filo log"), _T, _E, ("amber",), state="lying flat"),
    Category("cannoli", cannoli, (0.13, 0.0394, 0.0343), 0.06, ("cannolo", "brandy snap",
             "cream horn", "cannolis"), _T, _E, (), state="lying flat"),
    Category("profiterole", profiterole, (0.0468, 0.0465, 0.0365), 0.025, ("cream puff",
             "choux bun"), _T, ("edible", "round"), ("brown",)),
    vary(Category("palmier", palmier, (0.0942, 0.0845, 0.00964), 0.02, ("elephant ear",
             "pig's ear pastry"), _T, ("edible", "flat"), (), state="lying flat")),
    Category("bear_claw", bear_claw, (0.134, 0.0792, 0.0349), 0.09, ("bear claw pastry",), _T, _E,
             (), state="lying flat"),
    vary(Category("rum_baba", baba, (0.0707, 0.0679, 0.0684), 0.08, ("baba", "savarin"), _T,
             ("edible",
             "round"), ())),
    Category("baklava", pastry_square, (0.0911, 0.0574, 0.0331), 0.04, ("piece of baklava",
             "baklawa"), _T, _E, ()),
    vary(Category("borek", coil, (0.115, 0.12, 0.0194), 0.15, ("burek", "bourekas",
             "spinach pie spiral",
             "filo pastry coil"), ("dining",), ("edible", "flat"), (), state="lying flat")),
    vary(Category("jalebi", orange_spiral, (0.0748, 0.0611, 0.012), 0.02, ("jilebi", "zalabia",
             "jalebis"), ("dining",), ("edible", "flat"), (), state="lying flat")),
    Category("cupcake_case", case, (0.0712, 0.0712, 0.0324), 0.003, ("muffin case", "cupcake liner",
             "paper baking case", "cake case", "empty cupcake case", "fairy cake case",
             "bun case"), ("kitchen",), ("container", "round"), ("pink",)),
    Category("halva", halva, (0.109, 0.0627, 0.0415), 0.25, ("halva block", "halwa",
             "block of halva", "piece of halva"), ("dining",), _E, ("beige",)),
    vary(Category("kouign_amann", cushion, (0.0744, 0.0744, 0.045), 0.09, ("kouign-amann",
             "puff pastry"), _T, _E, ())),
)  # fmt: skip
"""The module's categories."""
