"""Objects of the ``coffee`` theme: pastries."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import skin
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_of, hull_part
from ...kit.primitives import ball, bent_rod, lobe, pad, scatter
from ...kit.shapes import Shape, category, settle, shape, vary
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, loft, torus, tube
from ...kit.surfaces import RGB, Look, speck, tint_color
from ..breakfast.breads import crust
from ..kitchen.vegetables import halves
from .cakes import _wedge

CREAM: RGB = (250, 244, 230)


@category("scone", size=(0.0695, 0.07, 0.0527), mass=0.07, material="food",
          aliases=("fruit scone", "cheese scone", "rock cake", "soda scone"),
          themes=("coffee", "tea"), roles=("edible", "round"))  # fmt: skip
def scone(look: Look) -> Shape:
    """A tall scone, split around its middle, with fruit inside or with cream and jam on top."""
    r, h = look.between(0.032, 0.037), look.between(0.042, 0.05)
    low = lathe([(0, 0), (0.94 * r, 0), (0.97 * r, 0.45 * h), (0, 0.45 * h)], 26)
    top = lathe([(0, 0.47 * h), (r, 0.48 * h), (0.98 * r, 0.86 * h), (0.8 * r, h), (0, h)], 26)
    seam = cylinder(0.93 * r, 0.05 * h, 26).move(z=0.44 * h)
    pieces = [(join([low, top]), speck(skin(look, (238, 208, 150), (206, 146, 76), 0.8), look.rng,
               (70, 44, 40), 12, 5)), (seam, surfaces.plain((250, 238, 208)))]  # fmt: skip
    if look.chance(0.5):
        pieces += [(ellipsoid(1.3 * r, 1.3 * r, 0.3 * h, 18, 8).move(z=h), surfaces.plain(CREAM)),
                   (ellipsoid(0.8 * r, 0.8 * r, 0.24 * h, 16, 8).move(z=1.1 * h),
                    surfaces.plain((176, 24, 46)))]  # fmt: skip
    return shape(pieces, [hull_of(low, top)])


@category("brioche", size=(0.0817, 0.0817, 0.0688), mass=0.06, material="food",
          aliases=("brioche bun", "brioche roll", "brioches"), themes=("coffee", "tea"),
          roles=("edible", "round"), colors=("copper",))  # fmt: skip
@vary()
def brioche(look: Look) -> Shape:
    """A fluted brioche bun with a small ball on top."""
    r, h = look.between(0.036, 0.042), look.between(0.06, 0.068)
    base = lobe(lathe([(0, 0), (0.66 * r, 0), (r, 0.48 * h), (0.9 * r, 0.62 * h), (0.4 * r,
                0.74 * h), (0, 0.74 * h)], 48), 12, 0.14)  # fmt: skip
    head = ball(0.95 * r, 0.95 * r, 0.8 * r, (0, 0, 0.82 * h), 18)
    glaze = skin(look, tint_color(look.color("copper", "amber"), 0.95), (130, 70, 28), 0.8)
    return shape([(base, glaze), (head, glaze)], [hull_of(base), hull_of(head)])


@category("danish_pastry", size=(0.117, 0.117, 0.0297), mass=0.09, material="food",
          aliases=("danish", "fruit danish", "custard danish", "apple danish"),
          themes=("coffee", "tea"), roles=("edible", "flat"), colors=("amber",))  # fmt: skip
def danish_pastry(look: Look) -> Shape:
    """A square iced puff pastry with its corners folded over custard or fruit."""
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
                  (fill, surfaces.speckles(look.rng, tone, 9)),
                  (tube(zig, 0.0018, 5), surfaces.plain(CREAM))],
                 [hull_of(base), hull_of(fill, *frame)])  # fmt: skip


@category("hot_cross_bun", size=(0.0997, 0.0997, 0.0509), mass=0.07, material="food",
          aliases=("cross bun", "easter bun"), themes=("coffee", "tea"),
          roles=("edible", "round"))  # fmt: skip
@vary()
def hot_cross_bun(look: Look) -> Shape:
    """A glazed, spiced bun with a pale cross on top."""
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
    return shape([(bun, brown), (join(bars), surfaces.plain((246, 228, 186)))], [hull_of(bun)])


@category("turnover", size=(0.119, 0.088, 0.0297), mass=0.09, material="food",
          aliases=("apple turnover", "cherry turnover", "pasty", "puff pastry triangle"),
          themes=("coffee", "tea"), roles=("edible",), colors=("amber",),
          state="lying flat")  # fmt: skip
def turnover(look: Look) -> Shape:
    """A golden triangular turnover of puff pastry with crimped edges."""
    k = look.between(0.9, 1.1)
    tri = np.array([(-0.06, -0.032), (0.06, -0.032), (0, 0.055)]) * k
    ring = smooth(np.concatenate([tri, tri[:1]]), 6)[:-1] * 0.3 + edge(tri, 6) * 0.7
    levels = [(0.97, 0), (1.0, 0.004), (1.0, 0.008), (0.86, 0.01), (0.6, 0.026), (0.2, 0.03)]
    body = stack(ring, [(f, z * k) for f, z in levels])
    cuts = [ellipsoid(0.022, 0.003, 0.002, 8, 4).turn(2, 1.2).move(0.014 * n, -0.004, 0.0285 * k)
            for n in (-1, 0, 1)]  # fmt: skip
    gold = surfaces.spots(look.rng, look.color("amber", "copper"), (170, 104, 46), 0.25)
    return shape([(body, gold), (join(cuts), surfaces.plain((110, 60, 30)))], [hull_of(body)])


def edge(corners: np.ndarray, steps: int) -> np.ndarray:
    """Return points along the sides of the polygon ``corners``, with ``steps`` per side."""
    after = np.roll(corners, -1, 0)
    return np.concatenate([a + (b - a) * np.linspace(0, 1, steps, endpoint=False)[:, None]
                           for a, b in zip(corners, after, strict=True)])  # fmt: skip


def stack(ring: np.ndarray, levels: list[tuple[float, float]]):
    """Return the solid that joins scaled copies of ``ring``, one per (scale, z) in ``levels``."""
    return loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
                ring)  # fmt: skip


@category("strudel", size=(0.229, 0.0773, 0.0505), mass=0.45, material="food",
          aliases=("apple strudel", "filo log"), themes=("coffee", "tea"), roles=("edible",),
          colors=("amber",), state="lying flat")  # fmt: skip
def strudel(look: Look) -> Shape:
    """A rolled strudel with sugar and slashes on top."""
    long, r = look.between(0.2, 0.25), look.between(0.036, 0.042)
    body = bent_rod(long, r, blunt=9, squash=0.7)
    cuts = [ellipsoid(0.05, 0.006, 0.006, 10, 5).turn(2, 1.1).move(x=u * long, z=0.66 * r)
            for u in (-0.3, -0.15, 0, 0.15, 0.3)]  # fmt: skip
    tile = speck(np.asarray(crust(look)), look.rng, (252, 250, 246), 90, 3)
    return settle([(body, tile), (join(cuts), surfaces.plain((122, 70, 34)))], 0.1)


@category("cannoli", size=(0.13, 0.0394, 0.0343), mass=0.06, material="food",
          aliases=("cannolo", "brandy snap", "cream horn", "cannolis"), themes=("coffee", "tea"),
          roles=("edible",), state="lying flat")  # fmt: skip
def cannoli(look: Look) -> Shape:
    """A cannoli: a crisp pastry tube filled with cream at both ends."""
    long, r = look.between(0.1, 0.12), look.between(0.016, 0.019)
    shell = cylinder(r, long, 24).turn(1, np.pi / 2).move(x=-long / 2)
    lip = torus(r, 0.0016, 22, 6).turn(1, np.pi / 2)
    cream = [ball(1.2 * r, 1.7 * r, 1.7 * r, (s * 0.5 * long, 0, 0), 14) for s in (-1, 1)]
    fried = surfaces.spots(look.rng, (206, 142, 78), (150, 90, 44), 0.35)
    chips = [box(0.003, 0.003, 0.002).move(s * (0.5 * long + 0.45 * r), 0.004 * n, 0.003 * n)
             for s in (-1, 1) for n in (-1, 0, 1)]  # fmt: skip
    return settle([(join([shell, lip.move(x=-long / 2), lip.move(x=long / 2)]), fried),
                   (join(cream), surfaces.plain(CREAM)),
                   (join(chips), surfaces.plain((70, 40, 26)))], 0.12, hulls=[[0, 1]])  # fmt: skip


@category("profiterole", size=(0.0468, 0.0465, 0.0365), mass=0.025, material="food",
          aliases=("cream puff", "choux bun"), themes=("coffee", "tea"), roles=("edible", "round"),
          colors=("brown",))  # fmt: skip
def profiterole(look: Look) -> Shape:
    """A choux pastry puff with chocolate poured over it."""
    r = look.between(0.021, 0.025)
    bun = lathe([(0, 0), (0.8 * r, 0), (r, 0.5 * r), (0.85 * r, 1.1 * r), (0.4 * r, 1.5 * r),
                 (0, 1.55 * r)], 22)  # fmt: skip
    cap = lathe([(0, 1.0 * r), (0.97 * r, 0.8 * r), (0.92 * r, 1.12 * r), (0.44 * r, 1.56 * r),
                 (0, 1.62 * r)], 22)  # fmt: skip
    runs = [ball(0.3 * r, 0.3 * r, 0.6 * r, (0.93 * r * np.cos(a), 0.93 * r * np.sin(a), 0.72 * r),
                 8) for a in (0.3, 1.7, 2.9, 4.2, 5.3)]  # fmt: skip
    dark = surfaces.plain(tint_color(look.color("brown", "brown", "white"), 0.55))
    return shape([(bun, crust(look)), (join([cap, *runs]), dark)], [hull_of(bun, cap)])


@category("palmier", size=(0.0942, 0.0845, 0.00964), mass=0.02, material="food",
          aliases=("elephant ear", "pig's ear pastry"), themes=("coffee", "tea"),
          roles=("edible", "flat"), state="lying flat")  # fmt: skip
@vary()
def palmier(look: Look) -> Shape:
    """A heart-shaped scroll of sugared puff pastry, lying flat."""
    k = look.between(0.9, 1.15)
    t = np.linspace(0, 2.6 * np.pi, 40)
    away = 0.024 - 0.0024 * t
    half = np.column_stack([0.024 - away * np.cos(t), 0.012 + away * np.sin(t), 0 * t])
    arm = np.concatenate([[(0.002, -0.044, 0), (0.001, -0.02, 0)], half])
    sides = [tube(smooth(arm * [s, 1, 1], 2), 0.0052, 7) for s in (1, -1)]
    gold = surfaces.spots(look.rng, (232, 178, 100), (180, 108, 46), 0.3)
    return settle([(join(sides), gold)], 0.08).scale(k)


@category("bear_claw", size=(0.134, 0.0792, 0.0349), mass=0.09, material="food",
          aliases=("bear claw pastry",), themes=("coffee", "tea"), roles=("edible",),
          state="lying flat")  # fmt: skip
def bear_claw(look: Look) -> Shape:
    """A curved almond pastry with claws cut along its edge."""
    k = look.between(0.9, 1.1)
    body = bent_rod(0.12, 0.025, bend=0.05, blunt=5, squash=0.75)
    toes = [ball(0.026, 0.036, 0.03, (0.03 * n, -0.028 + 0.006 * n * n, 0.002), 12)
            for n in (-1.6, -0.55, 0.55, 1.6)]  # fmt: skip
    nuts = scatter(look, 0.03, 14, (0.009, 0.012), 0.019, stretch=(1, 0.6, 0.3))
    return settle([(join([body, *toes]), crust(look)),
                   (nuts, surfaces.plain((240, 220, 176)))], 0.1).scale(k)  # fmt: skip


@category("baklava", size=(0.0911, 0.0574, 0.0331), mass=0.04, material="food",
          aliases=("piece of baklava", "baklawa"), themes=("coffee", "tea"),
          roles=("edible",))  # fmt: skip
def baklava(look: Look) -> Shape:
    """A diamond of baklava with thin, syrupy layers and green nuts on top."""
    x, h = look.between(0.042, 0.05), look.between(0.026, 0.032)
    body = box(x, x, h).turn(2, np.pi / 4).scale(1.35, 0.85, 1)
    layers = surfaces.stripes([(216, 156, 78), (168, 104, 44), (232, 182, 104)], 5)
    top = box(0.99 * x, 0.99 * x, 0.0012).turn(2, np.pi / 4).scale(1.35, 0.85, 1).move(z=h - 0.0005)
    nuts = scatter(look, 0.012, 12, (0.004, 0.006), h + 0.001)
    return shape([(body, layers), (top, surfaces.spots(look.rng, (222, 160, 78), (176, 108, 44),
                  0.25)), (nuts, surfaces.plain((116, 150, 60)))], [hull_of(body)])  # fmt: skip


@category("kouign_amann", size=(0.0744, 0.0744, 0.045), mass=0.09, material="food",
          aliases=("kouign-amann", "puff pastry"), themes=("coffee", "tea"),
          roles=("edible",))  # fmt: skip
@vary()
def kouign_amann(look: Look) -> Shape:
    """A kouign-amann: a glazed square pastry with caramelised, folded corners."""
    x = look.between(0.07, 0.085)
    body = pad(x, x, 0.04, 0.014, soft=0.6)
    flaps = [ball(0.036, 0.036, 0.018, (0.2 * x * i, 0.2 * x * j, 0.036), 12)
             for i in (-1, 1) for j in (-1, 1)]  # fmt: skip
    amber = surfaces.spots(look.rng, (206, 130, 56), (128, 66, 26), 0.3)
    return shape([(join([body, *flaps]), amber)], [hull_of(body), cylinder_part(0.3 * x, 0.042)])


CRUST: RGB = (196, 136, 72)
DARK: RGB = (150, 94, 46)


@category("tart", size=(0.107, 0.106, 0.0374), mass=0.09, material="food", aliases=("fruit tart",
          "tartlet", "egg tart", "berry tart", "custard tart", "fruit tartlet"),
          themes=("coffee", "tea"), roles=("edible", "round"), colors=("red",))  # fmt: skip
def tart(look: Look) -> Shape:
    """A small fluted tart with custard and berries."""
    r, h = look.between(0.045, 0.058), look.between(0.022, 0.028)
    shell = lobe(lathe([(0, 0), (0.8 * r, 0), (r, h), (0.9 * r, h), (0.84 * r, 0.7 * h),
                        (0, 0.7 * h)], 60), 22, 0.05)  # fmt: skip
    cream = cylinder(0.87 * r, 0.12 * h, 28).move(z=0.68 * h)
    tone = look.color("red", "indigo", "crimson", "orange")
    fruit = scatter(look, 0.72 * r, 15, (0.016, 0.02), h, dome=0.1 * h)
    return shape([(shell, _tint(look)), (cream, surfaces.speckles(look.rng, (248, 222, 140), 5)),
                  (fruit, surfaces.gradient(tint_color(tone, 0.8), tone, look.rng))],
                 [hull_of(shell), hull_of(fruit)])  # fmt: skip


def _tint(look: Look) -> surfaces.Tile:
    return skin(look, CRUST, DARK, 0.5)


@category("cinnamon_roll", size=(0.0837, 0.0887, 0.037), mass=0.09, material="food",
          aliases=("cinnamon bun", "sticky bun", "chelsea bun"), themes=("coffee",),
          roles=("edible", "round"))  # fmt: skip
def cinnamon_roll(look: Look) -> Shape:
    """A cinnamon roll with icing on its spiral."""
    r, h = look.between(0.042, 0.05), look.between(0.034, 0.042)
    t = np.linspace(0.4, 5.6 * np.pi, 64)
    away = 0.9 * r * t / t[-1]
    spiral = np.column_stack([away * np.cos(t), away * np.sin(t), np.zeros(64)])
    roll = tube(spiral, 0.16 * r, 8)
    roll = roll.scale(1, 1, 0.47 * h / (0.16 * r)).move(z=0.5 * h)
    core = cylinder(0.86 * r, 0.62 * h, 26).move(z=0.05 * h)
    brown = surfaces.speckles(look.rng, (112, 62, 32), 8)
    pieces = [(roll, skin(look, (214, 156, 90), (176, 112, 56), 0.6)), (core, brown)]
    if look.chance(0.5):
        w = np.linspace(-0.75, 0.75, 40)
        zig = np.column_stack([w * r, 0.6 * r * np.sin(9 * w) * np.sqrt(1 - w**2),
                               np.full(40, 0.98 * h)])  # fmt: skip
        pieces.append((tube(zig, 0.0024, 6, squash=0.7), surfaces.plain((250, 246, 236))))
    return settle(pieces, 0.02)


@category("eclair", size=(0.126, 0.0419, 0.0343), mass=0.08, material="food",
          aliases=("chocolate eclair",), themes=("coffee",), roles=("edible",), colors=("brown",),
          state="lying flat")  # fmt: skip
def eclair(look: Look) -> Shape:
    """A long choux pastry with glossy chocolate on top."""
    long, r = look.between(0.115, 0.14), look.between(0.019, 0.022)
    dough = bent_rod(long, r, blunt=5, squash=0.85)
    glaze = bent_rod(0.93 * long, 0.86 * r, blunt=6, squash=0.5).move(z=0.5 * r)
    tone = look.color("brown", "brown", "pink", "cream", "maroon")
    dark = surfaces.speckles(look.rng, tint_color(tone, 0.62), 4)
    w = np.linspace(-0.4, 0.4, 40)
    zig = np.column_stack([w * long, 0.35 * r * np.sin(44 * w), np.full(40, 0.93 * r)])
    return settle([(dough, _tint(look)), (glaze, dark),
                   (tube(zig, 0.0013, 5), surfaces.plain(tint_color(tone, 1.6)))], 0.1)  # fmt: skip


@category("pie_slice", size=(0.0912, 0.119, 0.0393), mass=0.13, material="food",
          aliases=("slice of pie", "piece of pie", "slice of apple pie", "slice of quiche"),
          themes=("coffee",), roles=("edible",), colors=("amber",))  # fmt: skip
def pie_slice(look: Look) -> Shape:
    """A slice of pie with its rim at the back and a filling between two crusts."""
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
    fill = surfaces.spots(look.rng, tone, tint_color(tone, 0.7), 0.2)
    return shape([(join([*shell, rim]), crust), (body, fill), (join(slits), fill)],
                 [hull_of(body, *shell)])  # fmt: skip


@category("croissant", size=(0.13, 0.08, 0.045), mass=0.06, material="food", aliases=("pastry",),
          themes=("coffee", "dining"), roles=("edible",), colors=("amber",), state="lying flat",
          common=True)  # fmt: skip
def croissant(look: Look) -> Shape:
    """A crescent-shaped croissant with ridges."""
    color = look.color("copper", "amber", "tan")
    a = np.linspace(np.deg2rad(195), np.deg2rad(345), 15)
    radii = 0.03 * np.clip(np.sin(np.linspace(0.12, np.pi - 0.12, 15)), 0.16, 1)
    radii *= 1 + 0.09 * np.cos(np.arange(15) * np.pi)
    path = np.column_stack([0.062 * np.cos(a), 0.062 * np.sin(a) + 0.045, 0.75 * radii])
    body = tube(path, radii, 10, squash=0.75)
    body = body.move(z=-float(body.vertices[:, 2].min()))
    tile = surfaces.scratches(look.rng, color, tint_color(color, 0.6), 120)
    return shape([(body, tile)], halves(body, 5))


@category("donut", size=(0.092, 0.092, 0.031), mass=0.06, material="food", aliases=("doughnut",),
          themes=("coffee",), roles=("edible", "round", "flat"), colors=("pink", "brown"),
          state="lying flat", common=True)  # fmt: skip
def donut(look: Look) -> Shape:
    """A glazed, ring-shaped donut with sprinkles."""
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
        [(base.move(z=0.0135), surfaces.speckles(look.rng, dough, 6)),
         (glaze.move(z=0.0135), image)],
        sections,
    )  # fmt: skip


@category("eccles_cake", size=(0.0798, 0.0804, 0.0266), mass=0.06, material="food",
          aliases=("welsh cake", "chorley cake", "banbury cake", "mince pie"),
          themes=("coffee", "tea"), roles=("edible", "round", "flat"),
          colors=("amber",))  # fmt: skip
def eccles_cake(look: Look) -> Shape:
    """A round, flat currant cake with three cuts and sugar on top."""
    r, h = look.between(0.038, 0.044), look.between(0.022, 0.027)
    body = lathe([(0, 0), (0.85 * r, 0), (r, 0.4 * h), (0.85 * r, 0.85 * h), (0.4 * r, h), (0, h)],
                 26)  # fmt: skip
    cuts = [ellipsoid(0.03, 0.0035, 0.003, 8, 4).move(0, 0.011 * n, 0.99 * h) for n in (-1, 0, 1)]
    crumbs = scatter(look, 0.6 * r, 22, (0.0018, 0.0028), 0.96 * h)
    return shape([(body, crust(look)), (join(cuts), surfaces.plain((60, 32, 24))),
                  (crumbs, surfaces.plain((252, 250, 246)))], [hull_of(body)])  # fmt: skip
