"""Objects of the ``food`` theme: snacks."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc, ellipse, rectangle
from ...kit.parts import above, hull_of, hull_part
from ...kit.primitives import bent_rod, blade, limb, lobe, pad, scatter
from ...kit.shapes import Category, Shape, category, keep_still, settle, shape
from ...kit.solids import Solid, box, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...kit.surfaces import RGB, Look, readable_on, speck, tint_color


@category("temaki", size=(0.135, 0.054, 0.0556), mass=0.08, material="food",
          aliases=("hand roll", "sushi hand roll", "sushi cone"), themes=("food",),
          roles=("edible",), colors=("coral",), state="lying")  # fmt: skip
def temaki(look: Look) -> Shape:
    """A temaki lying flat: a cone of seaweed filled with rice, salmon and cucumber."""
    k, color = look.between(0.88, 1.1), look.color("coral", "orange", "crimson")
    cone = (lathe([(0, 0), (0.004, 0), (0.028, 0.1), (0.024, 0.1), (0.002, 0.01), (0, 0.01)],
                  22).turn(1, -np.pi / 2).turn(1, 0.27).move(0.05, 0, 0.004))  # fmt: skip
    rice = (scatter(look, 0.018, 26, (0.008, 0.011), 0.0,
                    dome=0.01).turn(1, -np.pi / 2).move(-0.043, 0, 0.028))  # fmt: skip
    fish = [box(0.012, 0.012, 0.05).turn(1, -1.2).move(-0.04, y, 0.026) for y in (-0.008, 0.006)]
    green = box(0.007, 0.008, 0.05).turn(1, -1.15).move(-0.036, 0.0, 0.036)
    return settle([(cone, surfaces.speckles(look.rng, (34, 50, 38), 10)),
                   (rice, surfaces.plain((250, 248, 240))), (join(fish),
                       surfaces.stripes([color, tint_color(color, 1.4)], 4)),
                   (green, surfaces.plain((120, 170, 90)))], 0.03, hulls=[[0],
                       [1, 2]]).scale(k)  # fmt: skip


def bun(
    d: tuple[float, float], tall: float, palette: tuple[str, ...], kind: str
) -> Callable[[Look], Shape]:
    """Return the shape function of a small round snack: a mochi, a dorayaki or a scotch egg."""

    def make(look: Look) -> Shape:
        size, color = look.between(*d), look.color(*palette)
        h = tall * size
        if kind == "sandwich":
            cake = [ellipsoid(size, size, 0.62 * h, 26, 10).move(z=z * h) for z in (0.3, 0.74)]
            fill = cylinder(0.42 * size, 0.3 * h, 24).move(z=0.38 * h)
            return settle([(join(cake), surfaces.gradient(tint_color(color, 1.3),
                                                          tint_color(color, 0.75), look.rng)),
                           (fill, surfaces.plain((84, 44, 40)))], 0.02, hulls=[[0]])  # fmt: skip
        body = ellipsoid(size, size, h, 24, 14)
        if kind == "mochi":
            tile = surfaces.spots(look.rng, color, tint_color(color, 1.4), 0.2)
            return settle([(body, tile)], 0.17)
        if kind == "egg":
            half = body.bend(
                lambda p: np.column_stack([p[:, :2], np.minimum(p[:, 2], 0.02 * size)])
            )
            image = prints.canvas(128, 128, (160, 96, 56))
            for r, tone in (
                (0.44, (214, 160, 130)),
                (0.33, (250, 248, 240)),
                (0.19, (244, 180, 60)),
            ):
                prints.disc(image, 0.5, 0.5, r, tone)
            face = cylinder(0.495 * size, 0.0008, 28).move(z=0.02 * size)
            return settle([(half, surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.3)),
                           (face, image)], 0.12, hulls=[[0]])  # fmt: skip
        sauce = ellipsoid(0.8 * size, 0.8 * size, 0.4 * h, 18, 8).move(z=0.32 * h)
        flakes = scatter(
            look, 0.3 * size, 9, (0.14 * size, 0.22 * size), 0.48 * h, stretch=(1, 0.5, 0.2)
        )
        return settle([(body, crust(look, color)), (sauce, surfaces.plain((84, 46, 30))),
                       (flakes, surfaces.plain((150, 180, 100)))], 0.1, hulls=[[0]])  # fmt: skip

    return make


@category("shumai", size=(0.0412, 0.0402, 0.039), mass=0.022, material="food",
          aliases=("siu mai", "shaomai", "open dumpling"), themes=("food",),
          roles=("edible", "round"), colors=("yellow",))  # fmt: skip
def shumai(look: Look) -> Shape:
    """A shumai: an open, frilled dumpling with its filling visible and a pea on top."""
    k, color = look.between(0.88, 1.12), look.color("yellow", "cream", "gold")
    skin = lathe([(0, 0), (0.014, 0), (0.018, 0.012), (0.0165, 0.024), (0.019, 0.03),
                  (0.0165, 0.03), (0.014, 0.025), (0, 0.024)], 40)  # fmt: skip
    fill = ellipsoid(0.03, 0.03, 0.016, 16, 8).move(z=0.026)
    pea = ellipsoid(0.007, 0.007, 0.007, 10, 7).move(z=0.034)
    made = [(lobe(skin, 14, 0.12), surfaces.speckles(look.rng, tint_color(color, 1.1), 6)),
            (fill, surfaces.spots(look.rng, (214, 150, 120), (240, 200, 180), 0.3)),
            (pea, surfaces.plain(look.own_color("orange", "green", "coral")))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0, 1]])


BAKED = ("wooden", "tan", "amber", "copper")


@category("quesadilla", size=(0.149, 0.0871, 0.016), mass=0.18, material="food",
          aliases=("quesadilla slice", "cheese quesadilla"), themes=("food",), roles=("edible",),
          colors=("tan",), state="lying flat")  # fmt: skip
def quesadilla(look: Look) -> Shape:
    """Two wedges of a toasted, folded tortilla with cheese and filling at their edges."""
    r, color = look.between(0.08, 0.1), look.color("tan", "wooden", "beige")
    wedge = np.array([(0.0, 0.0), *arc((0, 0), r, 0.1, 1.3, 7)])
    pieces = []
    for n, turn in enumerate((0.0, 1.5)):
        z = 0.0
        for solid, tile in (
            (prism(wedge, 0, 0.004), toasted_slice(look, color)),
            (
                prism(wedge * 0.98, 0.004, 0.012),
                surfaces.spots(look.rng, (244, 196, 84), (150, 80, 50), 0.2),
            ),
            (prism(wedge, 0.012, 0.016), toasted_slice(look, color)),
        ):
            pieces.append((solid.turn(2, turn).move(-0.3 * r + 0.02 * n, -0.35 * r, z), tile))
    return shape(
        pieces, [hull_of(*[s for s, _ in pieces[:3]]), hull_of(*[s for s, _ in pieces[3:]])]
    )


def half_moon(
    long: tuple[float, float], crimped: bool, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a half-moon pastry with a crimped edge."""

    def make(look: Look) -> Shape:
        r, color = look.between(*long) / 2, look.color(*palette)
        a = np.linspace(0, np.pi, 17)
        rings = []
        for s, z in ((0.96, 0), (1.0, 0.05), (0.86, 0.34), (0.6, 0.56), (0.2, 0.62), (0.02, 0.62)):
            curve = np.column_stack(
                [r * s * np.cos(a), -0.12 * r + r * (0.08 + 0.95 * s) * np.sin(a) * 0.85]
            )
            rings.append(np.column_stack([curve, np.full(17, z * r * 0.85)]))
        flat = np.column_stack([np.cos(a), np.sin(a)])
        body = loft(np.stack(rings), flat)
        count = 15
        edge = [ellipsoid(0.12 * r, 0.1 * r, 0.09 * r, 7, 5).move(0.98 * r * np.cos(t),
            -0.12 * r + 0.86 * r * np.sin(t), 0.05 * r)
                for t in np.linspace(0.05, np.pi - 0.05, count)] if crimped else []  # fmt: skip
        pieces = [(body, crust(look, color))]
        if edge:
            pieces.append((join(edge), crust(look, tint_color(color, 0.9))))
        return settle(pieces, 0.02, hulls=[[0]])

    return make


@category("tostada", size=(0.133, 0.134, 0.0266), mass=0.1, material="food",
          aliases=("bean tostada",), themes=("food",), roles=("edible", "flat"), colors=("amber",),
          state="lying flat")  # fmt: skip
def tostada(look: Look) -> Shape:
    """A tostada: a flat, crisp tortilla topped with beans, lettuce, tomato and cheese."""
    r, color = look.between(0.06, 0.072), look.color("amber", "tan", "gold")
    disc = cylinder(r, 0.004, 30)
    beans = cylinder(0.86 * r, 0.005, 26).move(z=0.003)
    green = scatter(look, 0.7 * r, 26, (0.012, 0.02), 0.009, dome=0.008, stretch=(1, 0.4, 0.3))
    red = scatter(look, 0.6 * r, 12, (0.008, 0.011), 0.016, dome=0.006)
    white = scatter(look, 0.55 * r, 14, (0.006, 0.009), 0.018, dome=0.006, stretch=(1.6, 0.4, 0.4))
    return settle([(disc, toasted_slice(look, color)),
                   (beans, surfaces.spots(look.rng, (110, 66, 48), (80, 46, 36), 0.2)),
                   (green, surfaces.plain((110, 160, 70))), (red, surfaces.plain((206, 52, 44))),
                   (white, surfaces.plain((250, 244, 226)))], 0.0, hulls=[[0],
                       [1, 2, 3, 4]])  # fmt: skip


@category("nachos", size=(0.198, 0.198, 0.0697), mass=0.4, material="ceramic", assembled=True,
          aliases=("nacho", "plate of nachos", "loaded nachos", "bowl of nachos", "tortilla chips"),
          themes=("food",), roles=("edible",), colors=("gold",))  # fmt: skip
def nachos(look: Look) -> Shape:
    """A plate of nachos: corn chips under cheese, with dots of salsa and jalapeno."""
    k, color = look.between(0.85, 1.05), look.color("gold", "amber", "yellow")
    plate = lathe([(0, 0), (0.07, 0), (0.1, 0.012), (0.1, 0.015), (0.07, 0.006), (0, 0.006)], 32)
    chips = []
    for n in range(34):
        out, a = 0.075 * np.sqrt((n + 0.5) / 34), 2.4 * n
        one = (
            prism([(-0.02, -0.014), (0.02, -0.014), (0, 0.022)], 0, 0.0022)
            .turn(0, look.between(-0.6, 0.6) * (1 - 0.7 * n / 34))
            .turn(1, look.between(-0.5, 0.5) * (1 - 0.7 * n / 34))
            .turn(2, a)
        )
        chips.append(one.move(out * np.cos(a), out * np.sin(a), 0.017 + 0.032 * (1 - n / 34)))
    cheese = (
        ellipsoid(0.1, 0.09, 0.05, 20, 10)
        .bend(lambda p: p * (1 + 0.12 * np.sin(110 * p[:, :1]) * np.cos(100 * p[:, 1:2])))
        .move(z=0.016)
        .bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.005)]))
    )
    red, green = (
        scatter(look, 0.05, 12, (0.008, 0.012), 0.034, dome=0.012),
        scatter(look, 0.055, 7, (0.011, 0.013), 0.036, dome=0.01, stretch=(1, 1, 0.35)),
    )
    made = [(plate, surfaces.plain((236, 232, 224))),
            (join(chips), surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.1)),
            (cheese, surfaces.speckles(look.rng, (248, 190, 70), 10)),
            (red, surfaces.plain((200, 50, 44))),
            (green, surfaces.plain((90, 150, 60)))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.03, hulls=[[0], [1, 2, 3]])


@category("enchilada", size=(0.189, 0.151, 0.0457), mass=0.5, material="ceramic",
          aliases=("plate of enchiladas", "enchiladas", "cannelloni", "fajita plate"),
          themes=("food",), roles=("edible",), colors=("terracotta",))  # fmt: skip
def enchilada(look: Look) -> Shape:
    """A plate of enchiladas: three filled rolls under red sauce and cheese."""
    k, color = look.between(0.85, 1.05), look.color("terracotta", "red", "crimson", "green")
    plate = prism(rectangle(0.2, 0.16, 0.06), 0, 0.008, 0.003)
    rolls = [bent_rod(0.15, 0.02, blunt=8).move(0, y, 0.022) for y in (-0.042, 0.0, 0.042)]
    sauce = pad(0.11, 0.125, 0.014, 0.03).move(z=0.032)
    cheese, herbs = (
        scatter(look, 0.045, 24, (0.006, 0.011), 0.046, stretch=(1.8, 0.5, 0.4)),
        scatter(look, 0.05, 12, (0.006, 0.009), 0.047, stretch=(1, 0.6, 0.3)),
    )
    made = [(plate, surfaces.plain((240, 238, 232))),
            (join(rolls), toasted_slice(look, (214, 172, 110))),
            (sauce, surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.2)),
            (cheese, surfaces.plain((252, 232, 160))),
            (herbs, surfaces.plain((90, 150, 70)))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0], [1, 2]])


@category("tamale", size=(0.171, 0.0871, 0.0325), mass=0.12, material="food", aliases=("tamal",),
          themes=("food",), roles=("edible",), colors=("tan",), state="lying")  # fmt: skip
def tamale(look: Look) -> Shape:
    """A tamale: dough in an open corn husk that is tied at one end."""
    k, color = look.between(0.85, 1.1), look.color("tan", "beige", "wooden")
    dough = bent_rod(0.095, 0.018, blunt=5).move(0.01, 0, 0.02)
    husk = [blade([(-0.075, 0, 0.012), (-0.02, 0.026 * s, 0.006), (0.08, 0.038 * s, 0.006)], 0.045,
                  thick=0.18) for s in (-1, -0.3, 0.3, 1)]  # fmt: skip
    tie = ellipsoid(0.01, 0.026, 0.02, 10, 6).move(-0.052, 0, 0.011)
    tail = [limb([(-0.055, 0, 0.01), (-0.08, 0.012 * s, 0.012), (-0.1, 0.022 * s, 0.008)],
                 [0.004, 0.006, 0.002], 6) for s in (-1, 0, 1)]  # fmt: skip
    return settle([(dough, surfaces.spots(look.rng, (238, 206, 120), (206, 160, 80), 0.2)),
                   (join([*husk, *tail]), surfaces.stripes([color, tint_color(color, 1.2), color],
                                                           9)),
                   (tie, surfaces.plain(tint_color(color, 0.75)))], 0.06,
                   hulls=[[0], [1]]).scale(k)  # fmt: skip


@category("elote", size=(0.257, 0.0456, 0.042), mass=0.25, material="food", assembled=True,
          aliases=("mexican street corn", "grilled corn", "corn on a stick"), themes=("food",),
          roles=("edible",), colors=("yellow",), state="lying")  # fmt: skip
@keep_still
def elote(look: Look) -> Shape:
    """A grilled corn cob on a stick, with cream, cheese and chilli."""
    k, color = look.between(0.88, 1.08), look.color("yellow", "gold", "amber")
    cob = limb([(-0.09, 0, 0), (-0.07, 0, 0), (0.0, 0, 0), (0.07, 0, 0), (0.085, 0, 0)],
               [0.006, 0.019, 0.023, 0.021, 0.012], 20)  # fmt: skip
    y, x = np.mgrid[0:96, 0:96]
    grain = np.abs(np.sin(np.pi * x / 8)) * np.abs(np.sin(np.pi * y / 5))
    image = np.clip(np.array(color) * (0.7 + 0.4 * grain[..., None]), 0, 255).astype(np.uint8)
    image = speck(image, look.rng, (70, 44, 30), 36, 4)
    cream = [ellipsoid(0.02, 0.012, 0.006, 8, 5).move(-0.06 + 0.012 * n, 0.012 * np.sin(2.1 * n),
                                                      0.019) for n in range(11)]  # fmt: skip
    chili = [ellipsoid(0.003, 0.003, 0.002, 6, 4).move(-0.06 + 0.006 * n, 0.011 * np.sin(3.3 * n),
                                                       0.0215) for n in range(22)]  # fmt: skip
    stick = tube([(0.08, 0, 0), (0.17, 0, 0)], 0.004, 8)
    return settle([(cob, image), (join(cream), surfaces.plain((250, 246, 236))),
                   (join(chili), surfaces.plain((206, 60, 40))),
                   (stick, surfaces.plain((226, 198, 150)))], 0.08,
                  hulls=[[0], [3]]).scale(k)  # fmt: skip


def crust(look: Look, color: RGB) -> surfaces.Tile:
    """Return a tile of baked dough that is darker at the bottom."""
    return surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.2), look.rng, 14)


def toasted_slice(look: Look, color: RGB) -> surfaces.Tile:
    """Return a tile of pale dough with brown spots."""
    return surfaces.spots(look.rng, tint_color(color, 1.35), tint_color(color, 0.7), 0.12)


@category("sausage_roll", size=(0.1, 0.046, 0.0332), mass=0.07, material="food",
          aliases=("mini sausage roll", "pig in blanket"), themes=("food",), roles=("edible",),
          colors=("wooden",), state="lying")  # fmt: skip
def sausage_roll(look: Look) -> Shape:
    """A sausage roll: scored flaky pastry around a pink filling, lying flat."""
    long, color = look.between(0.075, 0.12), look.color(*BAKED)
    body = (prism(rectangle(0.046, 0.032, 0.013), -long / 2, long
                  / 2).turn(0, np.pi / 2).turn(2, np.pi / 2).move(z=0.016))  # fmt: skip
    meat = (prism(rectangle(0.032, 0.02, 0.0095), -long / 2 - 0.001, long / 2
                  + 0.001).turn(0, np.pi / 2).turn(2, np.pi / 2).move(z=0.015))  # fmt: skip
    cuts = [box(0.003, 0.03, 0.002).turn(2, 0.4).move(x, 0, 0.0312)
            for x in np.linspace(-0.36, 0.36, 5) * long]  # fmt: skip
    return settle([(body, crust(look, color)), (meat, surfaces.spots(look.rng, (206, 140, 116),
                                                                     (160, 96, 80), 0.2)),
                   (join(cuts), surfaces.plain(tint_color(color, 0.6)))], 0.0,
                  hulls=[[0]])  # fmt: skip


@category("pita_pocket", size=(0.159, 0.102, 0.0313), mass=0.2, material="food",
          aliases=("filled pita", "pita sandwich", "falafel pita", "stuffed pita", "falafel wrap"),
          themes=("food",), roles=("edible",), colors=("tan",), state="lying")  # fmt: skip
def pita_pocket(look: Look) -> Shape:
    """A pita pocket: half a round bread, open at its straight side, with its filling showing."""
    k, color = look.between(0.88, 1.1), look.color("tan", "beige", "wooden")
    half = ellipsoid(0.15, 0.15, 0.034, 28, 10).bend(
        lambda p: np.column_stack([p[:, 0], np.minimum(p[:, 1], 0.0), p[:, 2]])
    )
    balls = [
        ellipsoid(0.03, 0.03, 0.026, 12, 8).move(x, 0.004, 0.004) for x in (-0.034, 0.0, 0.036)
    ]
    leaves = (scatter(look, 0.012, 14, (0.016, 0.026), 0.0,
                      stretch=(1, 0.6, 0.3)).scale(4.2, 1, 1).move(0, 0.01, 0.006))  # fmt: skip
    red = [ellipsoid(0.022, 0.02, 0.006, 10, 6).turn(0, 0.9).move(x, 0.014, 0.006)
           for x in (-0.05, -0.014, 0.02, 0.052)]  # fmt: skip
    return settle([(half, toasted_slice(look, color)), (join(balls), crust(look, (150, 96, 54))),
                   (leaves, surfaces.plain((110, 164, 76))),
                   (join(red), surfaces.plain((206, 56, 46)))], 0.06,
                  hulls=[[0], [1, 3]]).scale(k)  # fmt: skip


def _long_roll(long: tuple[float, float], ridged: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a long filled roll, toasted with grill marks or crusty."""

    def make(look: Look) -> Shape:
        size, color = look.between(*long), look.color(*BAKED)
        w, h = 0.36 * size, 0.13 * size
        low, top = (
            pad(size, w, h, 0.16 * size, soft=0.4),
            pad(size, w, h, 0.16 * size, soft=0.5).move(z=1.65 * h),
        )
        fill = [prism(rectangle(0.97 * size, 1.05 * w, 0.15 * size), z * h, (z + 0.26) * h)
                for z in (0.95, 1.2, 1.45)]  # fmt: skip
        greens = scatter(look, 0.5 * w, 22, (0.012, 0.02), 1.35 * h, stretch=(1, 0.5, 0.4)).scale(
            2.4, 1, 1
        )
        pieces = [
            (join([low, top]), crust(look, color)),
            (fill[0], surfaces.plain((226, 130, 120))),
            (fill[1], surfaces.plain((250, 206, 90))),
            (fill[2], surfaces.plain((120, 170, 80))),
            (greens, surfaces.plain((236, 130, 50) if not ridged else (110, 160, 70))),
        ]
        if ridged:
            marks = [box(0.006, 0.84 * w, 0.002).turn(2, 0.5).move(x, 0, 2.63 * h)
                     for x in np.linspace(-0.36, 0.36, 7) * size]  # fmt: skip
            pieces.append((join(marks), surfaces.plain((90, 54, 32))))
        return shape(pieces, [hull_of(low), hull_of(top, *fill)])

    return make


@category("potato_crisp", size=(0.049, 0.038, 0.0034), mass=0.002, material="food",
          aliases=("single crisp", "single chip"), themes=("food",), roles=("edible",),
          colors=("amber",), state="lying flat")  # fmt: skip
def potato_crisp(look: Look) -> Shape:
    """A thin, golden potato crisp with blisters and brown spots."""
    outline = ellipse(look.between(0.042, 0.056), look.between(0.034, 0.042), 24)
    outline = outline * (1 + 0.05 * look.rng.normal(size=(24, 1)))
    color = look.color("amber", "gold")
    body = prism(outline, 0, 0.0026, 0.0008)
    blisters = [ellipsoid(0.008, 0.007, 0.0016, 8, 5).move(0.3 * x, 0.3 * y, 0.0026) for x,
                y in outline[[2, 11, 19]]]  # fmt: skip
    skin = surfaces.spots(look.rng, tint_color(color, 1.15), tint_color(color, 0.7), 0.06)
    return shape([(body, skin), (join(blisters), surfaces.plain(tint_color(color, 1.25)))],
                 [hull_of(body)])  # fmt: skip


def tub(
    words: tuple[str, ...], r: float, h: float, palette: tuple[str, ...], food: tuple[RGB, RGB]
) -> Callable[[Look], Shape]:
    """Return the shape function of a printed tub, closed, or open with its food visible."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.92, 1.08), look.color(*palette)
        a, b = r * k, h * k
        body = lathe(
            [(0, 0), (0.84 * a, 0), (0.86 * a, 0.03 * b), (a, b), (0, b)], 34, v=[0, 0, 0.03, 1, 1]
        )
        image = prints.canvas(320, 112, color)
        for start in (0, 160):
            part = image[:, start : start + 160]
            prints.disc(part, 0.5, 0.52, 0.4, (250, 248, 240))
            prints.write(part[:, 44:116], look.pick(list(words)), 0.5, 0.42, 0.24,
                         tint_color(color, 0.6), bold=True)  # fmt: skip
            prints.disc(part, 0.5, 0.72, 0.1, food[0])
        image = np.roll(image, 80, axis=1)
        if look.chance(0.5):
            rim = lathe([(0.9 * a, 0.97 * b), (1.03 * a, 0.97 * b), (1.03 * a, b + 0.002),
                         (0.9 * a, b + 0.002)], 34, loop=True)  # fmt: skip
            top = ellipsoid(1.84 * a, 1.84 * a, 0.3 * a, 24, 8).move(z=b - 0.002)
            return shape([(body, image), (rim, surfaces.plain(tint_color(color, 1.4))),
                          (top, surfaces.spots(look.rng, *food, 0.2))],
                         [hull_of(body, rim)])  # fmt: skip
        lid = lathe([(0, 0.98 * b), (1.05 * a, 0.96 * b), (1.05 * a, b + 0.006),
                     (0.96 * a, b + 0.008), (0.9 * a, b + 0.004), (0, b + 0.004)], 34)  # fmt: skip
        print_ = prints.canvas(128, 128, color)
        prints.disc(print_, 0.5, 0.5, 0.4, tint_color(color, 1.5))
        prints.write(print_, look.pick(list(words)), 0.5, 0.5, 0.14,
                     readable_on(tint_color(color, 1.5)), bold=True)  # fmt: skip
        face = cylinder(0.88 * a, 0.0006, 30).move(z=b + 0.004)
        return shape([(body, image), (lid, surfaces.plain(tint_color(color, 0.85))),
                      (face, print_)], [hull_of(body, lid)])  # fmt: skip

    return make


@category("bubble_tea", size=(0.0924, 0.0924, 0.218), mass=0.45, material="plastic", assembled=True,
          aliases=("boba", "boba tea", "pearl milk tea", "cup of bubble tea"), themes=("food",),
          roles=("tall", "round"), colors=("tan",))  # fmt: skip
def bubble_tea(look: Look) -> Shape:
    """A cup of bubble tea: milky tea with dark pearls, a domed lid and a wide straw."""
    k, color = (look.between(0.9, 1.08), look.color("tan", "pink", "mint", "lavender", "orange",
                                                    "beige"))  # fmt: skip
    r, h = 0.044 * k, 0.125 * k
    cup = lathe([(0, 0), (0.72 * r, 0), (r, h), (0, h)], 30, v=[0, 0, 1, 1])
    image = surfaces.fit(surfaces.speckles(look.rng, color, 8), 96, 192).copy()
    for _ in range(46):
        prints.disc(image, look.rng.random(), look.rng.uniform(0.74, 0.98), 0.05, (48, 30, 26))
    image[:10] = 240
    dome = lathe([(0, h), (1.04 * r, h), (1.04 * r, h + 0.006), (0.96 * r, h + 0.02 * k),
                  (0.6 * r, h + 0.036 * k), (0, h + 0.04 * k)], 28)  # fmt: skip
    straw = tube([(0.004, 0, h), (0.02 * k, 0, h + 0.09 * k)], 0.0055 * k, 12)
    return shape([(cup, image), (dome, surfaces.plain((232, 238, 240))),
                  (straw, surfaces.plain(look.own_color("pink", "green", "purple", "black",
                                                        "yellow")))], [hull_of(cup), hull_of(dome),
                                                                       hull_of(straw)])  # fmt: skip


@category("punnet", size=(0.148, 0.109, 0.0757), mass=0.35, material="plastic",
          aliases=("punnet of strawberries", "punnet of blueberries", "punnet of raspberries",
          "strawberry punnet", "box of strawberries", "fruit punnet", "punnet of berries",
          "punnet of cherries"), themes=("food",), colors=("red",))  # fmt: skip
def punnet(look: Look) -> Shape:
    """A clear or cardboard punnet heaped with strawberries or blueberries."""
    k, color = look.between(0.88, 1.06), look.color("red", "red", "indigo", "crimson", "maroon")
    x, y, h = 0.15 * k, 0.11 * k, 0.055 * k
    outline = rectangle(x, y, 0.02 * k)
    rings = [(0.84, 0), (1.0, h), (0.97, h), (0.82, 0.006)]
    tray = loft(np.stack([np.column_stack([outline * s, np.full(len(outline), z)]) for s,
                          z in rings]), outline)  # fmt: skip
    strawberry = color[0] > 150
    d = 0.03 * k if strawberry else 0.018 * k
    rows = [(i, j) for i in range(-2 if strawberry else -3, 3 if strawberry else 4)
            for j in range(-1 if strawberry else -2, 2 if strawberry else 3)]  # fmt: skip
    step = (x - 0.03 * k) / (5 if strawberry else 7)
    berries, caps = [], []
    for n, (i, j) in enumerate(rows):
        at = (i * step * 1.02, j * step * (1.0 if strawberry else 0.82), h + 0.25 * d
              * np.cos(2.3 * n))  # fmt: skip
        berries.append(ellipsoid(d, 0.9 * d, 0.95 * d, 8, 6).turn(2, n).move(*at))
        if strawberry:
            caps.append(ellipsoid(0.5 * d, 0.5 * d, 0.1 * d, 5, 4).move(at[0] + 0.18 * d, at[1],
                                                                        at[2] + 0.46
                                                                        * d))  # fmt: skip
    bed = prism(outline * 0.8, 0.006, 0.8 * h)
    seed = (surfaces.spots(look.rng, color, (250, 214, 120), 0.04) if strawberry
            else surfaces.spots(look.rng, color, tint_color(color, 1.3), 0.2))  # fmt: skip
    shell = (
        surfaces.plain((216, 226, 228))
        if look.chance(0.6)
        else surfaces.speckles(look.rng, (120, 150, 90), 6)
    )
    pieces: list[tuple[Solid, surfaces.Tile]] = [(tray, shell),
                                                 (bed, surfaces.plain(tint_color(color, 0.7))),
                                                 (join(berries), seed)]  # fmt: skip
    if caps:
        pieces.append((join(caps), surfaces.plain((90, 150, 66))))
    return shape(pieces, [hull_of(tray), hull_part(above(join(berries).vertices))])


CATEGORIES = (
    Category("takoyaki", bun((0.036, 0.044), 0.92, ("wooden", "copper", "amber"), "ball"),
             size=(0.0393, 0.0393, 0.0332), mass=0.025, material="food", aliases=("octopus ball",),
             themes=("food",), roles=("edible", "round"), colors=("wooden",)),
    Category("scotch_egg", bun((0.06, 0.072), 1.0, ("copper", "bronze", "wooden", "tan", "amber",
             "brown"), "egg"), size=(0.0633, 0.0633, 0.0297), mass=0.08, material="food",
             aliases=("half scotch egg",), themes=("food",), roles=("edible", "round"),
             colors=("copper",)),
    Category("empanada", half_moon((0.1, 0.13), True, BAKED), size=(0.128, 0.056, 0.0319), mass=0.1,
             material="food", aliases=("calzone", "sopapilla", "samosa pastry", "curry puff"),
             themes=("food",), roles=("edible",), colors=("wooden",), state="lying flat"),
    Category("cornish_pasty", half_moon((0.16, 0.19), True, BAKED), size=(0.18, 0.079, 0.045),
             mass=0.25, material="food",
             aliases=("meat pasty", "cheese pasty", "cheese and onion pasty"), themes=("food",),
             roles=("edible",), colors=("wooden",), state="lying flat"),
    Category("panini", _long_roll((0.16, 0.19), True), size=(0.173, 0.0668, 0.0601), mass=0.22,
             material="food", aliases=("toasted panini", "pressed sandwich"), themes=("food",),
             roles=("edible",), colors=("wooden",), state="lying flat"),
    Category("banh_mi", _long_roll((0.2, 0.25), False), size=(0.227, 0.088, 0.0783), mass=0.25,
             material="food", aliases=("sub sandwich", "submarine sandwich", "baguette sandwich",
             "filled baguette", "hoagie"), themes=("food",), roles=("edible",), colors=("wooden",),
             state="lying flat"),
    Category("hummus_tub", tub(("HUMMUS", "HOUMOUS", "DIP"), 0.055, 0.045, ("green", "orange",
             "red", "yellow"), ((226, 196, 140), (190, 150, 96))), size=(0.112, 0.112, 0.051),
             mass=0.22, material="plastic", aliases=("pot of hummus", "dip tub", "guacamole tub",
             "salsa tub", "houmous tub", "tub of dip"), themes=("food",), roles=("round",),
             colors=("green",)),
    Category("coleslaw_tub", tub(("SLAW", "SALAD", "DELI"), 0.058, 0.055, ("sky", "green", "white",
             "yellow"), ((244, 240, 214), (236, 150, 80))), size=(0.119, 0.12, 0.0618), mass=0.3,
             material="plastic", aliases=("tub of coleslaw", "potato salad tub", "pot of coleslaw",
             "tub of potato salad", "deli tub"), themes=("food",), roles=("round",),
             colors=("sky",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
