"""Objects of the ``kitchen`` theme: bakeware."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_above, hull_of, open_vessel
from ...kit.primitives import lobe
from ...kit.shapes import Shape, category, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    open_box,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import Look, tint_color


@category("cupcake_case", size=(0.0712, 0.0712, 0.0324), mass=0.003, material="paper", hollow=True,
          aliases=("muffin case", "cupcake liner", "paper baking case", "cake case",
          "empty cupcake case", "fairy cake case", "bun case"), themes=("kitchen",),
          roles=("container", "round"), colors=("pink",))  # fmt: skip
def cupcake_case(look: Look) -> Shape:
    """An empty pleated paper case for a cupcake."""
    r, h = look.between(0.034, 0.038), look.between(0.03, 0.034)
    body, parts = open_vessel([(0.68 * r, 0), (r, h)], 0.0014, 0.0014, 48)
    color = look.color("pink", "white", "sky", "yellow", "mint", "red", "brown")
    pleats = surfaces.stripes([color, tint_color(color, 0.82)], 24, upright=True, side=96)
    return shape([(body, pleats)], parts)


@category("cake_board", size=(0.252, 0.252, 0.0102), mass=0.15, material="paper",
          aliases=("cake drum", "cake base", "round cake board", "silver cake board",
          "cake circle"), themes=("kitchen",), roles=("flat", "support", "round"),
          colors=("silver",), state="lying flat")  # fmt: skip
def cake_board(look: Look) -> Shape:
    """A round cake board covered in silver or gold foil."""
    r = look.between(0.11, 0.14)
    color = look.color("silver", "gold", "white", "silver")
    foil = surfaces.brushed_metal(look.rng, color)
    net = surfaces.grid(tint_color(color, 0.86), tint_color(color, 1.15), 16, 16, width=1)
    plate = cylinder(r, 0.01, 44, bevel=0.001)
    return shape([(plate, foil), (cylinder(0.97 * r, 0.0005, 44).move(z=0.0097), net)],
                 [cylinder_part(r, 0.01)])  # fmt: skip


def _ears(x: float, z: float, wide: float, reach: float, thick: float) -> list[Solid]:
    return [tube(smooth([(s * (x - 0.003), -wide, z), (s * (x + reach), -0.7 * wide, z + 0.004),
                         (s * (x + reach), 0.7 * wide, z + 0.004), (s * (x - 0.003), wide, z)], 4),
                 thick, 8) for s in (-1, 1)]  # fmt: skip


def _ear_parts(x: float, z: float, wide: float, reach: float) -> list:
    return [box_part(reach, 1.6 * wide, 0.01, (s * (x + 0.5 * reach), 0, z - 0.004))
            for s in (-1, 1)]  # fmt: skip


def _tin(look: Look, x: float, y: float, h: float, palette: tuple[str, ...], *,
         flare: float = 0.9, material: str = "metal", ears: float = 0.0) -> Shape:  # fmt: skip
    """Return an open rectangular tin with sloping walls and a rolled rim."""
    color = look.color(*palette)
    skin = look.surface(color, material)
    w = 0.004 if material == "metal" else 0.006
    unit = rectangle(1, 1, 0.1, 4)
    flat = np.full(len(unit), 0.0)
    levels = [(flare, 0), (1.0, h - 0.003), (1 + 6 * w / x, h - 0.003), (1 + 6 * w / x, h),
              (1 - 2 * w / x, h), (flare - 2 * w / x, w)]  # fmt: skip
    rings = np.stack([np.column_stack([unit * [x * k, y * (k - 1) * x / y + y], flat + z])
                      for k, z in levels])  # fmt: skip
    profile = np.array([(k * x / 2, z) for k, z in levels])
    body = loft(rings, unit, profile=profile)
    pieces = [(body, skin)]
    lean = 0.5 * (1 - flare) * x
    parts = [box_part(flare * x, flare * y, w)]
    for s in (-1, 1):
        for axis, (a, b) in enumerate(((x, y), (y, x))):
            low, high = 0.5 * a - lean, 0.5 * a
            ends = 0.5 * b
            points = [(s * u, v, z) for u, z in ((low, 0), (high, h), (low - w, 0), (high - w, h))
                      for v in (-(ends - lean * (1 - z / h)), ends - lean
                                * (1 - z / h))]  # fmt: skip
            array = np.array(points)
            parts.append(hull_above(Solid(array if axis == 0 else array[:, [1, 0, 2]],
                                          np.zeros((0, 3), int), np.zeros((8, 2)))))  # fmt: skip
    if ears:
        grips = _ears(x / 2 + 3 * w, h - 0.004, 0.035, ears, 0.005)
        pieces.append((join(grips), skin))
        parts += _ear_parts(x / 2 + 3 * w, h - 0.003, 0.035, ears)
    return shape(pieces, parts)


@category("roasting_tin", size=(0.41, 0.253, 0.0636), mass=1, material="metal", hollow=True,
          aliases=("roasting pan", "roasting tray", "roaster", "roasting dish"),
          themes=("kitchen",), roles=("container", "big"), colors=("silver",))  # fmt: skip
def roasting_tin(look: Look) -> Shape:
    """A deep rectangular roasting pan with handles."""
    return _tin(look, look.between(0.3, 0.35), look.between(0.22, 0.25), look.between(0.055, 0.068),
                ("silver", "charcoal", "black", "gray"), ears=0.022, flare=0.93)  # fmt: skip


@category("loaf_tin", size=(0.268, 0.143, 0.0642), mass=0.4, material="metal", hollow=True,
          aliases=("loaf pan", "bread tin", "bread pan"), themes=("kitchen",), roles=("container",),
          colors=("silver", "charcoal"))  # fmt: skip
def loaf_tin(look: Look) -> Shape:
    """A long, narrow loaf tin."""
    return _tin(look, look.between(0.23, 0.27), look.between(0.11, 0.125), look.between(0.06, 0.07),
                ("silver", "charcoal", "black", "copper", "red"))  # fmt: skip


@category("baking_dish", size=(0.37, 0.234, 0.0607), mass=1.3, material="ceramic", hollow=True,
          aliases=("gratin dish", "oven dish", "lasagna dish", "ovenproof dish", "casserole pan",
          "lasagne dish"), themes=("kitchen",), roles=("container", "big"),
          colors=("white", "red"))  # fmt: skip
def baking_dish(look: Look) -> Shape:
    """A rectangular ceramic baking dish with small handles."""
    return _tin(look, look.between(0.26, 0.31), look.between(0.18, 0.21), look.between(0.05, 0.06),
                ("white", "red", "blue", "cream", "teal", "terracotta"), material="ceramic",
                flare=0.92, ears=0.018)  # fmt: skip


@category("cake_tin", size=(0.223, 0.228, 0.0633), mass=0.5, material="metal", hollow=True,
          aliases=("cake pan", "springform pan", "springform", "cake mould", "round baking tin",
          "springform tin", "springform cake tin"), themes=("kitchen",),
          roles=("container", "round", "big"), colors=("charcoal",))  # fmt: skip
def cake_tin(look: Look) -> Shape:
    """A round cake tin with straight walls and a clasp."""
    r, h = look.between(0.1, 0.125), look.between(0.058, 0.07)
    color = look.color("charcoal", "silver", "black", "copper", "red", "pink")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.97 * r, 0), (0.985 * r, 0.5 * h), (r, h)], 0.0025, 0.003, 40)
    rims = [torus(k * r, 0.0025, 40, 6).move(z=z) for k, z in ((1.0, h - 0.0015), (0.985, 0.004))]
    clasp = [box(0.036, 0.006, 0.01).move(0, -r - 0.002, 0.72 * h),
             box(0.008, 0.008, 0.4 * h).move(0.012, -r - 0.003, 0.4 * h)]  # fmt: skip
    steel = surfaces.brushed_metal(look.rng, (198, 200, 205))
    return shape([(body, skin), (join(rims), skin), (join(clasp), steel)],
                 [*parts, hull_of(*clasp)])  # fmt: skip


@category("pie_dish", size=(0.265, 0.265, 0.0382), mass=0.8, material="ceramic", hollow=True,
          aliases=("pie tin", "pie plate", "quiche dish", "flan dish", "tart tin", "tart pan",
          "pie pan"), themes=("kitchen",), roles=("container", "round", "big"),
          colors=("white",))  # fmt: skip
def pie_dish(look: Look) -> Shape:
    """A shallow, round pie dish with a fluted rim."""
    r, h = look.between(0.12, 0.14), look.between(0.034, 0.042)
    color = look.color("white", "red", "cream", "blue", "terracotta", "sage")
    skin = look.surface(color, "ceramic")
    side = [(0.76 * r, 0), (0.86 * r, 0.5 * h), (0.92 * r, h - 0.003), (r, h)]
    body, parts = open_vessel(side, 0.005, 0.006, 48)

    def flute(p: np.ndarray) -> np.ndarray:
        up = np.clip(p[:, 2] / h - 0.7, 0, 1) * 3.3
        wave = 1 + 0.022 * up * np.sin(24 * np.arctan2(p[:, 1], p[:, 0]))
        return p * np.column_stack([wave, wave, np.ones(len(p))])

    return shape([(body.bend(flute), skin)], parts)


@category("mixing_bowl", size=(0.26, 0.26, 0.112), mass=0.55, material="metal", hollow=True,
          aliases=("batter bowl", "large bowl", "prep bowl", "steel bowl", "metal bowl"),
          themes=("kitchen",), roles=("container", "round", "big"),
          colors=("silver", "white"))  # fmt: skip
def mixing_bowl(look: Look) -> Shape:
    """A large, deep mixing bowl of steel, plastic or glazed ceramic, sometimes with batter."""
    r, h = look.between(0.11, 0.135), look.between(0.1, 0.125)
    color = look.color("silver", "silver", "white", "cream", "red", "teal", "yellow", "sky", "pink")
    kind = look.pick(["metal", "plastic", "ceramic"])
    t = np.linspace(0, np.pi / 2, 8)
    side = [((0.42 + 0.58 * np.sin(a)) * r, h * (1 - np.cos(a)) ** 0.8) for a in t]
    body, parts = open_vessel(side, 0.003, 0.005, 34)
    skin = look.surface(color, kind) if kind != "ceramic" else glaze_tile(look, color)
    inside = look.surface(color if kind == "metal" else tint_color(color, 1.4), kind)
    rim = torus(r - 0.001, 0.0035, 36, 6).move(z=h - 0.003)
    pieces = [(body, surfaces.stack((skin, 50), (inside, 50), side=192)), (rim, inside)]
    if look.chance(0.25):
        batter = surfaces.speckles(look.rng, look.pick([(236, 214, 160), (96, 60, 40)]), 8)
        level = 0.45 * h
        wide = float(np.interp(level, [z for _, z in side], [x for x, _ in side])) - 0.004
        pieces.append((lathe([(0, 0.006), (0.5 * wide, 0.006), (wide, level), (0, level + 0.004)]),
                       batter))  # fmt: skip
    return shape(pieces, parts)


@category("baking_tray", size=(0.335, 0.245, 0.024), mass=0.6, material="metal", hollow=True,
          aliases=("baking sheet", "cookie sheet", "oven tray", "sheet pan", "baking pan",
          "cookie tray"), themes=("kitchen",), roles=("container", "support", "big", "flat"),
          colors=("silver", "charcoal"))  # fmt: skip
def baking_tray(look: Look) -> Shape:
    """A baking tray with a raised rim, empty or with biscuits or buns."""
    x, y, h = look.between(0.3, 0.36), look.between(0.22, 0.26), look.between(0.016, 0.024)
    color = look.color("silver", "charcoal", "black", "gray", "copper")
    skin = look.surface(color, "metal")
    rims = [block(x, 0.008, 0.006, 0.003).move(y=s * (y / 2 - 0.001), z=h - 0.005)
            for s in (-1, 1)]  # fmt: skip
    rims += [block(0.008, y, 0.006, 0.003).move(x=s * (x / 2 - 0.001), z=h - 0.005)
             for s in (-1, 1)]  # fmt: skip
    pieces = [(join([*open_box(x, y, h, 0.003, 0.003), *rims]), skin)]
    kind = look.pick(["", "", "cookies", "buns", "paper"])
    parts = list(frame_parts(x, y, h, 0.003, 0.003))
    if kind in ("cookies", "buns"):
        dough = surfaces.spots(look.rng, (206, 156, 92), (110, 66, 40), 0.06)
        at = [((i - 1.5) * 0.23 * x, (j - 1) * 0.29 * y) for i in range(4) for j in range(3)]
        d, tall = (0.055, 0.011) if kind == "cookies" else (0.056, 0.034)
        one = lathe([(0, 0), (0.45 * d, 0), (0.5 * d, 0.4 * tall), (0.34 * d, 0.86 * tall),
                     (0, tall)], 16)  # fmt: skip
        pieces.append((join([one.move(a, b, 0.003) for a, b in at]), dough))
        parts += [cylinder_part(0.45 * d, tall, (a, b, 0.003)) for a, b in at]
    elif kind == "paper":
        pieces.append((box(0.94 * x, 0.9 * y, 0.001).move(z=0.003),
                       surfaces.speckles(look.rng, (222, 204, 168), 6)))  # fmt: skip
    return shape(pieces, parts)


@category("muffin_tin", size=(0.317, 0.184, 0.0499), mass=0.55, material="metal", hollow=True,
          aliases=("muffin pan", "cupcake tin", "cupcake pan", "muffin tray", "bun tin",
          "resin mould", "silicone mould", "soap mould", "plaster mould", "candle mould",
          "copper jelly mould"), themes=("kitchen",), roles=("big",),
          colors=("charcoal", "silver"))  # fmt: skip
def muffin_tin(look: Look) -> Shape:
    """A muffin tin with six or twelve cups in a flat top, empty or with muffins."""
    rows, columns = 2, look.pick([3, 3, 4])
    pitch, r, h = 0.082, 0.034, look.between(0.03, 0.036)
    x, y = columns * pitch + 0.02, rows * pitch + 0.02
    color = look.color("charcoal", "silver", "black", "gray", "red", "copper")
    skin = look.surface(color, "metal")
    top = block(x, y, 0.003, 0.014).move(z=h - 0.003)
    at = [((i - (columns - 1) / 2) * pitch, (j - 0.5) * pitch)
          for i in range(columns) for j in range(rows)]  # fmt: skip
    cup = cylinder(0.72 * r, h - 0.002, 24, top=r)
    well = lathe([(0, 0.0), (0.92 * r, 0.0), (r, 0.0012), (1.04 * r, 0.0012), (1.04 * r, -0.001),
                  (0, -0.001)], 24)  # fmt: skip
    dark = surfaces.stack((surfaces.plain(tint_color(color, 0.45)), 1))
    pieces = [(join([top, *(cup.move(a, b) for a, b in at)]), skin)]
    parts = [box_part(x, y, 0.003, (0, 0, h - 0.003)),
             *(cylinder_part(0.72 * r, h - 0.002, (a, b, 0)) for a, b in at)]  # fmt: skip
    filled = look.chance(0.5)
    tone = look.pick([(214, 160, 90), (104, 64, 42), (226, 180, 110)])
    crumb = surfaces.spots(look.rng, tone, tint_color(tone, 0.5), 0.07)
    for a, b in at:
        if filled:
            bun = ellipsoid(2.2 * r, 2.2 * r, 0.04, 18, 10).move(a, b, h + 0.002)
            pieces.append((bun, crumb))
            parts.append(cylinder_part(0.8 * r, 0.014, (a, b, h)))
        else:
            pieces.append((well.move(a, b, h), dark))
    return shape(pieces, parts)


@category("jelly_mould", size=(0.155, 0.152, 0.0993), mass=0.2, material="metal",
          aliases=("jelly mold", "pudding mould", "bundt tin", "blancmange mould", "lamb mould",
          "mooncake mould", "chocolate mould", "fluted mould"), themes=("kitchen",),
          roles=("round",), colors=("copper",))  # fmt: skip
def jelly_mould(look: Look) -> Shape:
    """An upside-down jelly mould: a fluted copper or tin dome with tiers."""
    k, color = look.between(0.88, 1.1), look.color("copper", "silver", "copper", "pink", "red")
    dome = lathe([(0, 0), (0.078, 0), (0.078, 0.004), (0.066, 0.006), (0.062, 0.05), (0.05, 0.056),
                  (0.046, 0.082), (0.034, 0.088), (0.03, 0.1), (0, 0.104)], 64)  # fmt: skip
    made = lobe(dome, look.pick([10, 12, 14]), 0.12).scale(k, k, k)
    return shape([(made, look.surface(color, "copper" if color[0] > 1.3 * color[2] and color[1] > 80
                                      else "plastic"))], [hull_of(made)])  # fmt: skip


@category("piping_nozzle", size=(0.027, 0.0273, 0.0444), mass=0.008, material="metal",
          aliases=("icing nozzle", "piping tip", "icing tip", "cake nozzle"), themes=("kitchen",),
          roles=("round",), colors=("silver",))  # fmt: skip
def piping_nozzle(look: Look) -> Shape:
    """A piping nozzle standing on its wide end: a small steel cone with a star-shaped tip."""
    k, color = look.between(0.85, 1.3), look.color("silver", "silver", "gray", "gold")
    body = lathe([(0, 0), (0.012, 0), (0.0115, 0.004), (0.0045, 0.034), (0, 0.034)], 24)
    teeth = [prism([(-0.0018, 0), (0.0018, 0), (0, 0.006)], -0.0005,
                   0.0005).turn(0, np.pi / 2).move(y=-0.0042).turn(2, a).move(z=0.0335)
             for a in np.arange(6) * 1.047]  # fmt: skip
    seam = box(0.0006, 0.001, 0.03).turn(0, -0.22).move(y=-0.0118, z=0.002)
    made = join([body, *teeth, seam]).scale(k, k, k)
    return shape([(made, look.surface(color, "steel"))], [hull_of(body.scale(k, k, k))])
