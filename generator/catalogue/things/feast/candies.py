"""Hard and cut sweets by the piece: gums, humbugs, rock, nougat, brittle."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.recipes import pad
from ...build.settled import rod, settle
from ...build.shape import Shape, shape
from ...build.solids import block, cylinder, ellipsoid, join, lathe, prism, tube
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "orange", "yellow", "green", "pink", "purple", "sky", "lime", "white")


def _ball(d: tuple[float, float], speckled: bool) -> Callable[[Look], Shape]:
    def make(look: Look) -> Shape:
        size, color = look.between(*d), look.color(*BRIGHT)
        body = ellipsoid(size, size, 0.98 * size, 22, 14)
        tile = textures.spots(look.rng, color, tint_color(look.own_color("red", "sky", "yellow"),
                                                          1.1), 0.12) if speckled else (
            textures.gradient(tint_color(color, 0.85), tint_color(color, 1.25),
                              look.rng))  # fmt: skip
        return settle([(body, tile)], 0.07)

    return make


def jelly_bean(look: Look) -> Shape:
    """A jelly bean: a small glossy bean."""
    long, color = look.between(0.016, 0.021), look.color(*BRIGHT, "black")
    body = rod(long, 0.3 * long, blunt=3.2, bend=0.16 * long)
    tile = (
        textures.spots(look.rng, color, tint_color(color, 0.8), 0.06)
        if look.chance(0.3)
        else textures.gradient(tint_color(color, 0.9), tint_color(color, 1.2), look.rng)
    )
    return settle([(body, tile)], 0.14)


def peppermint(look: Look) -> Shape:
    """A round flat peppermint with red swirls, sometimes in clear wrapping."""
    r, color = look.between(0.011, 0.014), look.color("red", "red", "green", "sky", "pink")
    t = 0.55 * r
    body = lathe([(0, 0), (0.8 * r, 0), (r, 0.3 * t), (r, 0.7 * t), (0.8 * r, t), (0, t)], 30)
    rows, columns = np.mgrid[0:96, 0:96] / 95 - 0.5
    turn = np.arctan2(rows, columns) + 4 * np.hypot(rows, columns)
    swirl = np.where(
        (np.sin(3 * turn) > 0.2)[..., None], np.array(color), np.array((250, 248, 244))
    ).astype(np.uint8)
    face = cylinder(0.82 * r, 0.0004, 28).move(z=t - 0.0002)
    pieces = [
        (body, textures.stripes([color, (250, 248, 244), (250, 248, 244)], 3, upright=True)),
        (face, swirl),
    ]
    if look.chance(0.4):
        ends = [
            lathe([(0, 0), (0.15 * r, 0), (0.8 * r, r), (0, 0.8 * r)], 10)
            .turn(1, s * np.pi / 2)
            .scale(1, 1, 0.5)
            .move(s * 0.95 * r, 0, 0.5 * t)
            for s in (-1, 1)
        ]
        pieces.append((join(ends), textures.plain((236, 240, 244))))
    return settle(pieces, 0.02)


def _cube(
    size: tuple[float, float], flat: float, palette: tuple[str, ...], kind: str
) -> Callable[[Look], Shape]:
    """Return the shape function of a cut block of a sweet: fudge, toffee, nougat, delight."""

    def make(look: Look) -> Shape:
        x, color = look.between(*size), look.color(*palette)
        y, h = x * look.between(0.8, 1.0), x * flat * look.between(0.9, 1.1)
        body = pad(x, y, h, 0.12 * x, soft=0.2)
        tile = {
            "fudge": lambda: textures.speckles(look.rng, color, 16),
            "nougat": lambda: textures.spots(look.rng, color, look.own_color("tan", "green",
                "copper"), 0.14),
            "sugar": lambda: textures.spots(look.rng, color, (250, 246, 244), 0.3),
            "layers": lambda: textures.stripes([color, (34, 32, 34), (248, 246, 240), (34, 32, 34),
                                                color], 1),
        }[kind]()  # fmt: skip
        return shape([(body, tile)], [hull_of(body)])

    return make


def allsort(look: Look) -> Shape:
    """A liquorice allsort: a layered square, a coconut wheel or a bobbly button."""
    color = look.color("pink", "yellow", "orange", "white", "sky")
    kind = look.pick(["layers", "wheel", "bobbles"])
    k = look.between(0.9, 1.15)
    dark: RGB = (36, 32, 34)
    if kind == "layers":
        bands = [
            (
                block(0.018, 0.018, 0.0042, 0.001).move(z=0.0042 * n),
                textures.plain(color if n % 2 == 0 else dark),
            )
            for n in range(5)
        ]
        return shape(
            [(s.scale(k, k, k), t) for s, t in bands],
            [hull_of(*[s.scale(k, k, k) for s, _ in bands])],
        )
    if kind == "wheel":
        wheel = cylinder(0.011, 0.013, 26, bevel=0.001)
        core = cylinder(0.0045, 0.0134, 18)
        return shape(
            [
                (wheel.scale(k, k, k), textures.speckles(look.rng, color, 10)),
                (core.scale(k, k, k), textures.plain(dark)),
            ],
            [hull_of(wheel.scale(k, k, k))],
        )
    disc = lathe([(0, 0), (0.009, 0), (0.011, 0.003), (0.009, 0.007), (0, 0.008)], 22)
    dots = [
        ellipsoid(0.003, 0.003, 0.003, 6, 4).move(
            0.009 * np.sqrt(n / 30) * np.cos(2.4 * n),
            0.009 * np.sqrt(n / 30) * np.sin(2.4 * n),
            0.0077,
        )
        for n in range(30)
    ]
    made = join([disc, *dots]).scale(k, k, k)
    return shape([(made, textures.speckles(look.rng, color, 6))], [hull_of(made)])


def humbug(look: Look) -> Shape:
    """A humbug: a striped pillow of boiled sugar."""
    k, color = look.between(0.9, 1.15), look.color("black", "brown", "maroon", "green")
    x = np.linspace(-1, 1, 11)
    body = tube(
        np.column_stack([0.013 * x, 0 * x, 0 * x]),
        0.0095 * np.maximum(1 - np.abs(x) ** 3, 0.02) ** 0.5,
        12,
        squash=0.8,
    )
    body = body.bend(lambda p: np.column_stack([p[:, 0], p[:, 1], p[:, 2]]))
    stripes = textures.stripes([color, color, (246, 236, 212)], 6, upright=True)
    return settle([(body, stripes)], 0.14).scale(k)


def rock(look: Look) -> Shape:
    """A stick of seaside rock: a pink cylinder, letters in its white ends."""
    long, r = look.between(0.14, 0.2), look.between(0.0105, 0.013)
    color = look.color("pink", "pink", "magenta", "red", "green", "sky")
    stick = cylinder(r, long, 24).turn(1, np.pi / 2).move(-long / 2, 0, r)
    image = prints.canvas(64, 64, (250, 248, 246))
    prints.disc(image, 0.5, 0.5, 0.36, color, 0.3)
    prints.write(image, "ROCK", 0.5, 0.5, 0.2, (196, 40, 60), bold=True)
    ends = [
        cylinder(0.86 * r, 0.0006, 20).turn(1, s * np.pi / 2).move(s * long / 2, 0, r)
        for s in (-1, 1)
    ]
    wrap = cylinder(1.02 * r, 0.2 * long, 24).turn(1, np.pi / 2).move(-0.1 * long, 0, r)
    label = prints.canvas(96, 64, (248, 246, 240))
    prints.write(
        label, look.pick(["SEASIDE", "BRIGHTON", "PIER"]), 0.5, 0.5, 0.2, (50, 90, 170), bold=True
    )
    return settle(
        [
            (stick, textures.stripes([color, tint_color(color, 1.15)], 5, upright=True)),
            (join(ends), image),
            (wrap, label),
        ],
        0.06,
        hulls=[[0]],
    )


def brittle(look: Look) -> Shape:
    """A broken slab of peanut brittle: amber sugar full of nuts."""
    k, color = look.between(0.85, 1.15), look.color("amber", "copper", "gold", "bronze")
    corners = np.array(
        [
            (-0.04, -0.024),
            (0.006, -0.03),
            (0.042, -0.014),
            (0.034, 0.02),
            (-0.006, 0.03),
            (-0.036, 0.014),
        ]
    )
    slab = prism(corners * (1 + 0.1 * look.rng.uniform(-1, 1, (6, 1))), 0, 0.007)
    nuts = [
        ellipsoid(0.014, 0.008, 0.006, 8, 5)
        .turn(2, 2.1 * n)
        .move(
            0.028 * np.cos(2.4 * n) * np.sqrt(n / 13),
            0.018 * np.sin(2.4 * n) * np.sqrt(n / 13),
            0.007,
        )
        for n in range(13)
    ]
    made = [
        (slab, textures.speckles(look.rng, color, 12)),
        (join(nuts), textures.speckles(look.rng, (226, 190, 130), 10)),
    ]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0]])


_F = ("food",)


_E, _R = ("edible",), ("edible", "round")

CATEGORIES = (
    Category("jelly_bean", jelly_bean, (0.0194, 0.0111, 0.00917), 0.0012,
             ("jellybean",), _F, _E, ("red",), state="lying"),
    Category("gumball", _ball((0.018, 0.025), False), (0.0218, 0.0221, 0.0201), 0.006,
             ("bubblegum ball", "bubble gum ball", "gum ball", "aniseed ball", "malt ball"), _F,
             _R, ("red",)),
    Category("gobstopper", _ball((0.024, 0.034), True), (0.0288, 0.0291, 0.0265), 0.014,
             ("jawbreaker", "everlasting gobstopper"), _F, _R, ("white",)),
    Category("peppermint", peppermint, (0.0331, 0.0248, 0.00771), 0.004,
             ("mint imperial", "peppermint candy", "mint sweet", "starlight mint",
                 "butterscotch"), _F, _R, ("red",)),
    Category("fudge", _cube((0.022, 0.028), 0.75, ("tan", "wooden", "brown", "copper"), "fudge"),
             (0.025, 0.0226, 0.0176), 0.014, ("square of fudge", "fudge piece",
                                              "fudge cube",
             "toffee", "caramel square", "tablet of fudge", "salted caramel"), _F, _E, ("tan",)),
    Category("nougat", _cube((0.028, 0.038), 0.5, ("ivory", "cream", "white", "pink"), "nougat"),
             (0.0329, 0.0311, 0.016), 0.018, ("turron", "nougat bar", "piece of nougat"), _F, _E,
             ("ivory",)),
    Category("liquorice_allsort", allsort, (0.0204, 0.0205, 0.0146), 0.005,
             ("allsort", "licorice allsort"), _F, _E, ("pink",)),
    Category("humbug", humbug, (0.0265, 0.0194, 0.0133), 0.005, ("mint humbug", "pear drop",
                 "sherbet lemon"), _F, _E, ("black",), state="lying"),
    Category("stick_of_rock", keep_still(rock), (0.18, 0.0248, 0.0233), 0.07,
             ("rock candy stick", "seaside rock", "rock candy", "brighton rock"), _F, _E,
             ("pink",), state="lying"),
    Category("peanut_brittle", brittle, (0.081, 0.0571, 0.00972), 0.025,
             ("brittle", "nut brittle", "sesame brittle", "honeycomb piece"), _F, _E,
             ("amber",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
