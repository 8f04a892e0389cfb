"""Food of Mexico, and folded pastries."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade, speck
from ...build.outlines import arc, rectangle
from ...build.recipes import pad
from ...build.settled import limb, rod, scatter, settle
from ...build.shape import Shape, shape
from ...build.solids import cylinder, ellipsoid, join, lathe, loft, prism, sweep, tube
from ...build.variants import keep_still
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .savouries import crust, toasted_slice

BAKED = ("wooden", "tan", "amber", "copper")


def quesadilla(look: Look) -> Shape:
    """Two wedges of a toasted folded tortilla, cheese and filling at their edges."""
    r, color = look.between(0.08, 0.1), look.color("tan", "wooden", "beige")
    wedge = np.array([(0.0, 0.0), *arc((0, 0), r, 0.1, 1.3, 7)])
    pieces = []
    for n, turn in enumerate((0.0, 1.5)):
        z = 0.0
        for solid, tile in (
            (prism(wedge, 0, 0.004), toasted_slice(look, color)),
            (
                prism(wedge * 0.98, 0.004, 0.012),
                textures.spots(look.rng, (244, 196, 84), (150, 80, 50), 0.2),
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
    """Return the shape function of a folded pastry: a half-moon with a crimped edge."""

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


def tostada(look: Look) -> Shape:
    """A tostada: a flat crisp tortilla with beans, lettuce, tomato and cheese on it."""
    r, color = look.between(0.06, 0.072), look.color("amber", "tan", "gold")
    disc = cylinder(r, 0.004, 30)
    beans = cylinder(0.86 * r, 0.005, 26).move(z=0.003)
    green = scatter(look, 0.7 * r, 26, (0.012, 0.02), 0.009, dome=0.008, stretch=(1, 0.4, 0.3))
    red = scatter(look, 0.6 * r, 12, (0.008, 0.011), 0.016, dome=0.006)
    white = scatter(look, 0.55 * r, 14, (0.006, 0.009), 0.018, dome=0.006, stretch=(1.6, 0.4, 0.4))
    return settle([(disc, toasted_slice(look, color)),
                   (beans, textures.spots(look.rng, (110, 66, 48), (80, 46, 36), 0.2)),
                   (green, textures.plain((110, 160, 70))), (red, textures.plain((206, 52, 44))),
                   (white, textures.plain((250, 244, 226)))], 0.0, hulls=[[0],
                       [1, 2, 3, 4]])  # fmt: skip


def nachos(look: Look) -> Shape:
    """A plate of nachos: corn chips heaped under cheese, with dots of salsa and jalapeno."""
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
    made = [(plate, textures.plain((236, 232, 224))),
            (join(chips), textures.spots(look.rng, color, tint_color(color, 0.75), 0.1)),
            (cheese, textures.speckles(look.rng, (248, 190, 70), 10)),
            (red, textures.plain((200, 50, 44))),
            (green, textures.plain((90, 150, 60)))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.03, hulls=[[0], [1, 2, 3]])


def enchilada(look: Look) -> Shape:
    """A plate of enchiladas: three filled rolls under red sauce and cheese."""
    k, color = look.between(0.85, 1.05), look.color("terracotta", "red", "crimson", "green")
    plate = prism(rectangle(0.2, 0.16, 0.06), 0, 0.008, 0.003)
    rolls = [rod(0.15, 0.02, blunt=8).move(0, y, 0.022) for y in (-0.042, 0.0, 0.042)]
    sauce = pad(0.11, 0.125, 0.014, 0.03).move(z=0.032)
    cheese, herbs = (
        scatter(look, 0.045, 24, (0.006, 0.011), 0.046, stretch=(1.8, 0.5, 0.4)),
        scatter(look, 0.05, 12, (0.006, 0.009), 0.047, stretch=(1, 0.6, 0.3)),
    )
    made = [(plate, textures.plain((240, 238, 232))),
            (join(rolls), toasted_slice(look, (214, 172, 110))),
            (sauce, textures.spots(look.rng, color, tint_color(color, 0.8), 0.2)),
            (cheese, textures.plain((252, 232, 160))),
            (herbs, textures.plain((90, 150, 70)))]  # fmt: skip
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0], [1, 2]])


def tamale(look: Look) -> Shape:
    """A tamale: dough in an opened corn husk tied at one end."""
    k, color = look.between(0.85, 1.1), look.color("tan", "beige", "wooden")
    dough = rod(0.095, 0.018, blunt=5).move(0.01, 0, 0.02)
    husk = [
        blade(
            [(-0.075, 0, 0.012), (-0.02, 0.026 * s, 0.006), (0.08, 0.038 * s, 0.006)],
            0.045,
            thick=0.18,
        )
        for s in (-1, -0.3, 0.3, 1)
    ]
    tie = ellipsoid(0.01, 0.026, 0.02, 10, 6).move(-0.052, 0, 0.011)
    tail = [
        limb(
            [(-0.055, 0, 0.01), (-0.08, 0.012 * s, 0.012), (-0.1, 0.022 * s, 0.008)],
            [0.004, 0.006, 0.002],
            6,
        )
        for s in (-1, 0, 1)
    ]
    return settle([(dough, textures.spots(look.rng, (238, 206, 120), (206, 160, 80), 0.2)),
                   (join([*husk, *tail]), textures.stripes([color, tint_color(color, 1.2), color],
                                                           9)),
                   (tie, textures.plain(tint_color(color, 0.75)))], 0.06,
                   hulls=[[0], [1]]).scale(k)  # fmt: skip


def churro(look: Look) -> Shape:
    """A churro: a ridged stick of fried dough rolled in sugar."""
    long, r = look.between(0.13, 0.18), look.between(0.009, 0.012)
    color, bend = look.color("copper", "wooden", "bronze"), look.between(0.0, 0.02)
    u = np.linspace(-1, 1, 15)
    a = np.arange(16) * np.pi / 8
    section = (
        np.column_stack([np.cos(a), np.sin(a)]) * (1 + 0.14 * (-1.0) ** np.arange(16))[:, None]
    )

    body = sweep(np.column_stack([long / 2 * u, bend * u * u, 0 * u]), section, r)
    return settle([(body, textures.spots(look.rng, color, (246, 232, 206), 0.12))], 0.1)


def elote(look: Look) -> Shape:
    """Grilled corn on a stick, cream, cheese and chilli on it."""
    k, color = look.between(0.88, 1.08), look.color("yellow", "gold", "amber")
    cob = limb(
        [(-0.09, 0, 0), (-0.07, 0, 0), (0.0, 0, 0), (0.07, 0, 0), (0.085, 0, 0)],
        [0.006, 0.019, 0.023, 0.021, 0.012],
        20,
    )
    y, x = np.mgrid[0:96, 0:96]
    grain = np.abs(np.sin(np.pi * x / 8)) * np.abs(np.sin(np.pi * y / 5))
    image = np.clip(np.array(color) * (0.7 + 0.4 * grain[..., None]), 0, 255).astype(np.uint8)
    image = speck(image, look.rng, (70, 44, 30), 36, 4)
    cream = [
        ellipsoid(0.02, 0.012, 0.006, 8, 5).move(-0.06 + 0.012 * n, 0.012 * np.sin(2.1 * n), 0.019)
        for n in range(11)
    ]
    chili = [
        ellipsoid(0.003, 0.003, 0.002, 6, 4).move(
            -0.06 + 0.006 * n, 0.011 * np.sin(3.3 * n), 0.0215
        )
        for n in range(22)
    ]
    stick = tube([(0.08, 0, 0), (0.17, 0, 0)], 0.004, 8)
    return settle(
        [
            (cob, image),
            (join(cream), textures.plain((250, 246, 236))),
            (join(chili), textures.plain((206, 60, 40))),
            (stick, textures.plain((226, 198, 150))),
        ],
        0.08,
        hulls=[[0], [3]],
    ).scale(k)


def concha(look: Look) -> Shape:
    """A concha: a round sweet bun with a shell pattern of sugar paste."""
    r, color = look.between(0.045, 0.056), look.color("pink", "yellow", "white", "brown", "cream")
    bun = lathe(
        [
            (0, 0),
            (0.9 * r, 0),
            (r, 0.2 * r),
            (0.9 * r, 0.55 * r),
            (0.5 * r, 0.82 * r),
            (0, 0.88 * r),
        ],
        32,
    )
    y, x = np.mgrid[0:128, 0:128]
    lines = (np.abs(((x / 128 * 12 + 0.5 * np.sin(y / 20)) % 1) - 0.5) < 0.12) | (
        np.abs(((y / 128 * 9) % 1) - 0.5) < 0.08
    )
    top = np.where(lines[..., None], np.array((226, 180, 120)), np.array(color)).astype(np.uint8)
    cap = lathe(
        [
            (0, 0.5 * r),
            (0.92 * r, 0.5 * r),
            (0.92 * r, 0.58 * r),
            (0.52 * r, 0.86 * r),
            (0, 0.93 * r),
        ],
        32,
    )
    return shape([(bun, crust(look, (206, 150, 84))), (cap, top)], [hull_of(bun, cap)])


_F = ("food",)


_E, _R = ("edible",), ("edible", "round")

CATEGORIES = (
    Category("quesadilla", quesadilla, (0.149, 0.0871, 0.016), 0.18, ("quesadilla slice",
        "cheese quesadilla"), _F, _E, ("tan",), state="lying flat"),
    Category("empanada", half_moon((0.1, 0.13), True, BAKED), (0.128, 0.056, 0.0319), 0.1,
             ("calzone", "sopapilla", "samosa pastry", "curry puff"),
             _F, _E, ("wooden",), state="lying flat"),
    Category("cornish_pasty", half_moon((0.16, 0.19), True, BAKED), (0.18, 0.079, 0.045), 0.25,
             ("meat pasty", "cheese pasty", "cheese and onion pasty"), _F, _E,
             ("wooden",), state="lying flat"),
    Category("tostada", tostada, (0.133, 0.134, 0.0266), 0.1, ("bean tostada",), _F,
             ("edible", "flat"), ("amber",), state="lying flat"),
    Category("nachos", nachos, (0.198, 0.198, 0.0697), 0.4, ("nacho", "plate of nachos",
        "loaded nachos", "bowl of nachos", "tortilla chips"), _F, _E, ("gold",)),
    Category("enchilada", enchilada, (0.189, 0.151, 0.0457), 0.5, ("plate of enchiladas",
        "enchiladas", "cannelloni", "fajita plate"), _F, _E, ("terracotta",)),
    Category("tamale", tamale, (0.171, 0.0871, 0.0325), 0.12, ("tamal",), _F, _E, ("tan",),
             state="lying"),
    Category("churro", keep_still(churro), (0.15, 0.0355, 0.0217), 0.03,
             ("churros stick", "youtiao"), _F, _E, ("copper",), state="lying"),
    Category("elote", keep_still(elote), (0.257, 0.0456, 0.042), 0.25, ("mexican street corn",
        "grilled corn", "corn on a stick"), _F, _E, ("yellow",), state="lying"),
    Category("concha", concha, (0.0991, 0.0991, 0.0461), 0.08, ("pan dulce", "mexican sweet bread",
        "melon pan"), _F, _R, ("pink",)),
)  # fmt: skip
"""The module's categories."""
