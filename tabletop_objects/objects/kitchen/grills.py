"""Objects of the ``kitchen`` theme: grills."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import box_part, cylinder_part, hull_of, open_vessel
from ...kit.primitives import facing, limb, straight
from ...kit.shapes import Category, Shape, category, settle, shape, vary
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, torus, tube
from ...kit.surfaces import RGB, Look, tint_color

STEEL: RGB = (188, 191, 196)


def _coals(look: Look, x: float, y: float, z: float, count: int) -> tuple[Solid, Solid]:
    dark, hot = [], []
    for n in range(count):
        lump = box(0.026, 0.024, 0.016).turn(2, look.between(0, 3))
        lump = lump.move(look.between(-x, x), look.between(-y, y), z)
        (hot if n % 4 == 0 else dark).append(lump)
    return join(dark), join(hot)


@category("tabletop_grill", size=(0.335, 0.277, 0.128), mass=2.0, material="metal", assembled=True,
          aliases=("tabletop barbecue", "mini barbecue", "barbecue grill", "charcoal grill",
          "bbq grill", "hibachi", "barbecue", "small grill", "table grill"), themes=("kitchen",),
          roles=("big",), colors=("black", "red"))  # fmt: skip
def tabletop_grill(look: Look) -> Shape:
    """A round table-top barbecue on three legs, with coals, a grate and side handles."""
    k = look.between(0.92, 1.06)
    color = look.color("black", "red", "green", "navy")
    r = 0.14
    bowl = lathe([(0, 0.05), (0.5 * r, 0.05), (0.9 * r, 0.085), (r, 0.13), (0.95 * r, 0.13),
                  (0.85 * r, 0.09), (0, 0.075)], 36)  # fmt: skip
    legs = [straight((0.6 * r * np.cos(a), 0.6 * r * np.sin(a), 0.065), (0.85 * r * np.cos(a), 0.85
                                                                         * r * np.sin(a), 0.004),
                     0.005) for a in (0.52, 2.62, 4.71)]  # fmt: skip
    bars = [straight((-np.sqrt(max(0.9025 * r * r - y * y, 0)), y, 0.126),
                     (np.sqrt(max(0.9025 * r * r - y * y, 0)), y, 0.126), 0.0016, 5)
            for y in np.linspace(-0.85 * r, 0.85 * r, 15)]  # fmt: skip
    rim = torus(0.97 * r, 0.003, 36, 6).move(z=0.128)
    grips = [limb([(s * 0.98 * r, -0.03, 0.11), (s * 1.15 * r, -0.026, 0.112),
                   (s * 1.15 * r, 0.026, 0.112), (s * 0.98 * r, 0.03, 0.11)], [0.005] * 4, 8)
             for s in (-1, 1)]  # fmt: skip
    dark, hot = _coals(look, 0.065, 0.065, 0.085, 18)
    steel = surfaces.brushed_metal(look.rng, STEEL)
    return shape([(bowl, surfaces.speckles(look.rng, color, 5)), (join([*legs, *bars, rim]), steel),
                  (join(grips), surfaces.wood(look.rng, (150, 104, 62))),
                  (dark, surfaces.speckles(look.rng, (46, 44, 44), 14)),
                  (hot, surfaces.spots(look.rng, (230, 90, 30), (90, 40, 30), 0.4))],
                 [hull_of(bowl), *(hull_of(leg) for leg in legs), *(hull_of(g) for g in grips)]
                 ).scale(k)  # fmt: skip


@category("disposable_barbecue", size=(0.315, 0.243, 0.0654), mass=0.8, material="metal",
          assembled=True,
          aliases=("disposable bbq", "instant barbecue", "foil barbecue", "disposable grill"),
          themes=("kitchen",), roles=("big", "flat"), colors=("silver",))  # fmt: skip
@vary()
def disposable_barbecue(look: Look) -> Shape:
    """A disposable barbecue: a foil tray of charcoal under a wire grid."""
    k = look.between(0.94, 1.06)
    color = look.color("silver", "silver", "gray")
    x, y, h = 0.29 * k, 0.22 * k, 0.05 * k
    rim = block(1.06 * x, 1.08 * y, 0.004, 0.012).move(z=h - 0.003)
    body = block(0.94 * x, 0.94 * y, h - 0.002, 0.012)
    bed = block(0.9 * x, 0.9 * y, 0.002, 0.01).move(z=h)
    dark, hot = _coals(look, 0.42 * x, 0.4 * y, h - 0.006, 40)
    wires = [straight((-0.48 * x, v, h + 0.012), (0.48 * x, v, h + 0.012), 0.0012, 4)
             for v in np.linspace(-0.42 * y, 0.42 * y, 9)]  # fmt: skip
    wires += [straight((v, -0.46 * y, h + 0.013), (v, 0.46 * y, h + 0.013), 0.0012, 4)
              for v in np.linspace(-0.44 * x, 0.44 * x, 12)]  # fmt: skip
    foil = surfaces.brushed_metal(look.rng, color)
    return shape([(join([body, rim]), foil), (bed, surfaces.plain((40, 38, 38))),
                  (dark, surfaces.speckles(look.rng, (46, 44, 44), 14)),
                  (hot, surfaces.spots(look.rng, (150, 146, 140), (206, 96, 40), 0.2)),
                  (join(wires), surfaces.plain((176, 180, 184)))],
                 [box_part(0.94 * x, 0.94 * y, h), box_part(1.05 * x, 1.07 * y, 0.004,
                  (0, 0, h - 0.003)), box_part(0.9 * x, 0.9 * y, 0.012, (0, 0, h))])  # fmt: skip


@category("chimney_starter", size=(0.241, 0.162, 0.202), mass=1.2, material="metal", hollow=True,
          aliases=("charcoal chimney", "charcoal starter"), themes=("kitchen",), roles=("tall",),
          colors=("silver",))  # fmt: skip
@vary()
def chimney_starter(look: Look) -> Shape:
    """A chimney starter: a perforated steel can with a handle and coals on top."""
    k = look.between(0.92, 1.06)
    color = look.color("silver", "silver", "black")
    r, h = 0.08 * k, 0.2 * k
    body, _ = open_vessel([(r, 0), (r, h)], 0.003, 0.6 * h, 36)
    image = surfaces.fit(surfaces.brushed_metal(look.rng, color), 128, 256).copy()
    for n in range(12):
        for row in (0.88, 0.96):
            prints.disc(image, (n + 0.5 * (row > 0.9)) / 12, 0.5 + 0.5 * row, 0.022, (30, 30, 32))
    grip = limb([(r, 0, 0.86 * h), (1.75 * r, 0, 0.82 * h), (1.8 * r, 0, 0.35 * h),
                 (r, 0, 0.24 * h)], [0.008] * 4, 8)  # fmt: skip
    shield = box(0.003, 0.09 * k, 0.7 * h).move(x=1.15 * r, z=0.15 * h)
    dark, hot = _coals(look, 0.045 * k, 0.045 * k, 0.9 * h, 14)
    low, _ = _coals(look, 0.045 * k, 0.045 * k, 0.8 * h, 14)
    return shape([(body, image), (grip, surfaces.plain((36, 34, 34))),
                  (shield, surfaces.brushed_metal(look.rng, STEEL)),
                  (join([dark, low]), surfaces.speckles(look.rng, (46, 44, 44), 14)),
                  (hot, surfaces.spots(look.rng, (230, 90, 30), (90, 40, 30), 0.4))],
                 [cylinder_part(r, h), hull_of(grip), hull_of(shield)])  # fmt: skip


def cube(form: tuple[float, float, float], palette: tuple[str, ...], spot: float, deep: float,
         soft: float = 0.0015) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape function of a small, spotted block, such as a cube of bread or coal."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        x, y, h = (v * k for v in form)
        color = look.color(*palette)
        body = block(x, y, h, 0.12 * min(x, y), soft)
        tile = surfaces.spots(look.rng, color, tint_color(color, deep), spot)
        return shape([(body, tile)], [box_part(x, y, h)])

    return make


@category("charcoal_briquette", size=(0.0524, 0.0524, 0.0302), mass=0.03, material="wood",
          aliases=("briquette", "lump of coal", "piece of coal", "lump of charcoal",
          "barbecue charcoal", "charcoal"), themes=("kitchen",), colors=("black",))  # fmt: skip
@vary()
def charcoal_briquette(look: Look) -> Shape:
    """A pillow-shaped briquette of charcoal."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "charcoal", "black")
    x = 0.052 * k
    outline = np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)])
    ring = np.concatenate([a + (b - a) * np.linspace(0, 1, 6, endpoint=False)[:, None] for a,
                           b in zip(outline, np.roll(outline, -1, 0), strict=True)])  # fmt: skip
    ring = ring * (1 - 0.12 * (np.linalg.norm(ring, axis=1, keepdims=True) - 0.5)) * x
    levels = [(0.5, 0), (0.86, 0.12), (1.0, 0.42), (1.0, 0.58), (0.86, 0.88), (0.5, 1.0)]
    body = loft(np.stack([np.column_stack([ring * f, np.full(len(ring), 0.03 * k * z)])
                          for f, z in levels]), ring)  # fmt: skip
    tile = surfaces.spots(look.rng, tint_color(color, 0.8), (96, 94, 92), 0.14)
    return shape([(body, tile)], [hull_of(body)])


@category("wood_chips", size=(0.112, 0.107, 0.0256), mass=0.04, material="wood",
          aliases=("wood chip", "smoking chips", "pile of wood chips", "wood chippings",
          "bark chip"), themes=("kitchen",), colors=("tan",), state="lying flat")  # fmt: skip
def wood_chips(look: Look) -> Shape:
    """A heap of wood chips for smoking."""
    color = look.color("tan", "wooden", "brown")
    made: list[Solid] = []
    for n in range(26):
        away, a = 0.045 * np.sqrt((n + 0.5) / 26), 2.4 * n
        one = box(look.between(0.02, 0.034), look.between(0.01, 0.016), 0.004)
        made.append(one.turn(1, look.between(-0.3, 0.3)).turn(2, look.between(0, 3)).move(
            away * np.cos(a), away * np.sin(a), 0.003 + 0.018 * (1 - n / 26)))  # fmt: skip
    return settle([(join(made), surfaces.wood(look.rng, color))], 0.02)


INK: RGB = (34, 36, 40)


def turn_knob(r: float, x: float, y: float, z: float) -> Solid:
    """Return a control knob of radius ``r`` at (x, y, z) on the front panel of an appliance."""
    return facing(cylinder(r, 0.012, 18, top=0.85 * r)).move(x, y, z)


def _panel(look: Look, wide: int = 128, tall: int = 48) -> surfaces.Tile:
    image = prints.canvas(wide, tall, INK)
    prints.fill(image, 0.08, 0.2, 0.34, 0.6, (150, 200, 170))
    prints.write(image[:, : int(0.5 * wide)], look.pick(["12:30", "0:45", "3:20", "1:00"]), 0.5,
                 0.5, 0.4, (30, 50, 40), bold=True)  # fmt: skip
    for n in range(6):
        prints.disc(image, 0.55 + 0.16 * (n % 3), 0.32 + 0.38 * (n // 3), 0.12, (200, 204, 208))
    return image


def griddle(ribs: bool, wide: float, open_: float) -> Callable[[Look], Shape]:
    """Return the shape function of a clamshell grill, closed or with its lid up."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.88, 1.08), look.color("black", "silver", "red", "gray", "white")
        x, y, h = wide * k, 0.24 * k, 0.05 * k
        low = block(x, y, h, 0.03 * k, 0.006)
        plate = box(0.86 * x, 0.84 * y, 0.003).move(z=h - 0.0006)
        bars = ([box(0.006, 0.8 * y, 0.003).move(i * 0.05 * x, 0, h + 0.002) for i in range(-8, 9)]
                if ribs else [])  # fmt: skip
        lean = look.pick([0.0, open_])
        top = (
            block(x, y, h, 0.03 * k, 0.008).move(y=-y / 2).turn(0, -lean).move(y=y / 2, z=h + 0.008)
        )
        grip = tube([(-0.22 * x, -y, 0.4 * h), (-0.22 * x, -y - 0.035, 0.4 * h),
                     (0.22 * x, -y - 0.035, 0.4 * h), (0.22 * x, -y, 0.4 * h)], 0.008 * k,
                    8)  # fmt: skip
        grip = grip.turn(0, -lean).move(y=y / 2, z=h + 0.008)
        hinge = [
            cylinder(0.011, 0.03, 12).turn(1, np.pi / 2).move(s * 0.3 * x - 0.015, y / 2, h + 0.003)
            for s in (-1, 1)
        ]
        lamp = [box(0.006, 0.002, 0.006).move(s * 0.02, -y / 2 - 0.0005, 0.5 * h) for s in (-1, 1)]
        tile = look.surface(color, "steel" if color[0] > 170 and color[1] > 160 else "plastic")
        dark = surfaces.plain((46, 46, 50))
        pieces = [(join([low, top]), tile), (join([plate, *bars]), surfaces.plain((62, 62, 66))),
                  (join([grip, *hinge]), dark),
                  (join(lamp), surfaces.plain((226, 60, 50)))]  # fmt: skip
        return shape(pieces, [hull_of(low), hull_of(top), hull_of(grip)])

    return make


@category("raclette_grill", size=(0.356, 0.357, 0.0954), mass=2.2, material="device",
          aliases=("raclette maker", "raclette set"), themes=("kitchen",), roles=("big",),
          colors=("black", "red"))  # fmt: skip
def raclette_grill(look: Look) -> Shape:
    """A raclette grill: a hot plate on legs over a shelf of small pans with handles."""
    k, color = look.between(0.88, 1.05), look.color("black", "red", "silver", "gray")
    x, y = 0.38 * k, 0.2 * k
    shelf, plate = (block(x, y, 0.012, 0.03 * k).move(z=0.02),
                    block(x, y, 0.014, 0.03 * k, 0.004).move(z=0.085 * k))  # fmt: skip
    feet = [cylinder(0.012, 0.022, 12).move(i * 0.42 * x, j * 0.36 * y, 0) for i in (-1, 1)
            for j in (-1, 1)]  # fmt: skip
    posts = [box(0.02, 0.02, 0.075 * k).move(s * 0.46 * x, 0, 0.025) for s in (-1, 1)]
    pans, grips = [], []
    for i in range(-1, 3):
        for s in (-1, 1):
            at = ((i - 0.5) * 0.23 * x, s * 0.4 * y)
            pans.append(block(0.07 * k, 0.09 * k, 0.012, 0.012).move(*at, 0.032))
            grips.append(limb([(at[0], s * 0.6 * y, 0.04), (at[0], s * 0.75 * y, 0.046),
                               (at[0], s * 0.95 * y, 0.05)], [0.005, 0.007, 0.007], 7))  # fmt: skip
    ribs = [box(0.4 * x, 0.004, 0.002).move(-0.22 * x, j * 0.09 * y, 0.085 * k + 0.0135)
            for j in range(-4, 5)]  # fmt: skip
    knob = turn_knob(0.016, 0.0, -y / 2, 0.026)
    tile = look.surface(color, "plastic")
    return shape([(join([shelf, *posts, *feet]), tile), (join([plate, *ribs]),
                                                         surfaces.plain((52, 52, 56))),
                                                         (join(pans), surfaces.plain((70, 70, 74))),
                  (join([*grips, knob]), surfaces.plain((30, 30, 32)))],
                  [hull_of(shelf, *feet), *[hull_of(p) for p in posts], hull_of(plate),
                   hull_of(*grips)])  # fmt: skip


CATEGORIES = (
    Category("firelighter", cube((0.04, 0.026, 0.02), ("white", "tan", "ivory"), 0.3, 0.85),
             size=(0.0418, 0.0272, 0.0209), mass=0.015, material="wood",
             aliases=("fire lighter", "fire starter", "firestarter", "fire lighter cube"),
             themes=("kitchen",), colors=("white",)),
    Category("contact_grill", griddle(True, 0.32, 1.3), size=(0.311, 0.283, 0.217), mass=2.4,
             material="device", aliases=("electric grill", "george foreman grill", "health grill",
             "panini press", "panini grill", "panini maker", "grill press"), themes=("kitchen",),
             roles=("big",), colors=("black", "silver")),
)  # fmt: skip
"""Objects that share their drawing functions."""
