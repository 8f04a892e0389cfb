"""Objects of the ``food`` theme: sweets."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import smooth
from ...kit.parts import hull_of
from ...kit.primitives import bent_rod, pad
from ...kit.shapes import Category, Shape, category, keep_still, settle, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, tint_color

BRIGHT = ("red", "orange", "yellow", "green", "pink", "purple", "sky", "lime", "white")


def _ball(d: tuple[float, float], speckled: bool) -> Callable[[Look], Shape]:
    def make(look: Look) -> Shape:
        size, color = look.between(*d), look.color(*BRIGHT)
        body = ellipsoid(size, size, 0.98 * size, 22, 14)
        tile = surfaces.spots(look.rng, color, tint_color(look.own_color("red", "sky", "yellow"),
                                                          1.1), 0.12) if speckled else (
            surfaces.gradient(tint_color(color, 0.85), tint_color(color, 1.25),
                              look.rng))  # fmt: skip
        return settle([(body, tile)], 0.07)

    return make


@category("jelly_bean", size=(0.0194, 0.0111, 0.00917), mass=0.0012, material="food",
          aliases=("jellybean",), themes=("food",), roles=("edible",), colors=("red",),
          state="lying")  # fmt: skip
def jelly_bean(look: Look) -> Shape:
    """A small, glossy jelly bean."""
    long, color = look.between(0.016, 0.021), look.color(*BRIGHT, "black")
    body = bent_rod(long, 0.3 * long, blunt=3.2, bend=0.16 * long)
    tile = (surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.06) if look.chance(0.3)
            else surfaces.gradient(tint_color(color, 0.9), tint_color(color, 1.2),
                                   look.rng))  # fmt: skip
    return settle([(body, tile)], 0.14)


@category("peppermint", size=(0.0331, 0.0248, 0.00771), mass=0.004, material="food", assembled=True,
          aliases=("mint imperial", "peppermint candy", "mint sweet", "starlight mint",
          "butterscotch"), themes=("food",), roles=("edible", "round"),
          colors=("red",))  # fmt: skip
def peppermint(look: Look) -> Shape:
    """A round, flat peppermint with red swirls, sometimes in clear wrapping."""
    r, color = look.between(0.011, 0.014), look.color("red", "red", "green", "sky", "pink")
    t = 0.55 * r
    body = lathe([(0, 0), (0.8 * r, 0), (r, 0.3 * t), (r, 0.7 * t), (0.8 * r, t), (0, t)], 30)
    rows, columns = np.mgrid[0:96, 0:96] / 95 - 0.5
    turn = np.arctan2(rows, columns) + 4 * np.hypot(rows, columns)
    swirl = np.where(
        (np.sin(3 * turn) > 0.2)[..., None], np.array(color), np.array((250, 248, 244))
    ).astype(np.uint8)
    face = cylinder(0.82 * r, 0.0004, 28).move(z=t - 0.0002)
    pieces = [(body, surfaces.stripes([color, (250, 248, 244), (250, 248, 244)], 3, upright=True)),
              (face, swirl)]  # fmt: skip
    if look.chance(0.4):
        ends = [lathe([(0, 0), (0.15 * r, 0), (0.8 * r, r), (0, 0.8 * r)],
                      10).turn(1, s * np.pi / 2).scale(1, 1, 0.5).move(s * 0.95 * r, 0, 0.5 * t)
                for s in (-1, 1)]  # fmt: skip
        pieces.append((join(ends), surfaces.plain((236, 240, 244))))
    return settle(pieces, 0.02)


def _cube(
    size: tuple[float, float], flat: float, palette: tuple[str, ...], kind: str
) -> Callable[[Look], Shape]:
    """Return the shape function of a cube of fudge, toffee, nougat or Turkish delight."""

    def make(look: Look) -> Shape:
        x, color = look.between(*size), look.color(*palette)
        y, h = x * look.between(0.8, 1.0), x * flat * look.between(0.9, 1.1)
        body = pad(x, y, h, 0.12 * x, soft=0.2)
        tile = {
            "fudge": lambda: surfaces.speckles(look.rng, color, 16),
            "nougat": lambda: surfaces.spots(look.rng, color, look.own_color("tan", "green",
                "copper"), 0.14),
            "sugar": lambda: surfaces.spots(look.rng, color, (250, 246, 244), 0.3),
            "layers": lambda: surfaces.stripes([color, (34, 32, 34), (248, 246, 240), (34, 32, 34),
                                                color], 1),
        }[kind]()  # fmt: skip
        return shape([(body, tile)], [hull_of(body)])

    return make


@category("liquorice_allsort", size=(0.0204, 0.0205, 0.0146), mass=0.005, material="food",
          aliases=("allsort", "licorice allsort"), themes=("food",), roles=("edible",),
          colors=("pink",))  # fmt: skip
def liquorice_allsort(look: Look) -> Shape:
    """A liquorice allsort: a layered square, a coconut wheel or a button covered in beads."""
    color = look.color("pink", "yellow", "orange", "white", "sky")
    kind = look.pick(["layers", "wheel", "bobbles"])
    k = look.between(0.9, 1.15)
    dark: RGB = (36, 32, 34)
    if kind == "layers":
        bands = [(block(0.018, 0.018, 0.0042, 0.001).move(z=0.0042 * n),
                  surfaces.plain(color if n % 2 == 0 else dark)) for n in range(5)]  # fmt: skip
        return shape(
            [(s.scale(k, k, k), t) for s, t in bands],
            [hull_of(*[s.scale(k, k, k) for s, _ in bands])],
        )
    if kind == "wheel":
        wheel = cylinder(0.011, 0.013, 26, bevel=0.001)
        core = cylinder(0.0045, 0.0134, 18)
        return shape([(wheel.scale(k, k, k), surfaces.speckles(look.rng, color, 10)),
                      (core.scale(k, k, k), surfaces.plain(dark))],
                     [hull_of(wheel.scale(k, k, k))])  # fmt: skip
    disc = lathe([(0, 0), (0.009, 0), (0.011, 0.003), (0.009, 0.007), (0, 0.008)], 22)
    dots = [ellipsoid(0.003, 0.003, 0.003, 6, 4).move(0.009 * np.sqrt(n / 30) * np.cos(2.4 * n),
                                                      0.009 * np.sqrt(n / 30) * np.sin(2.4 * n),
                                                      0.0077) for n in range(30)]  # fmt: skip
    made = join([disc, *dots]).scale(k, k, k)
    return shape([(made, surfaces.speckles(look.rng, color, 6))], [hull_of(made)])


@category("humbug", size=(0.0265, 0.0194, 0.0133), mass=0.005, material="food",
          aliases=("mint humbug", "pear drop", "sherbet lemon"), themes=("food",),
          roles=("edible",), colors=("black",), state="lying")  # fmt: skip
def humbug(look: Look) -> Shape:
    """A humbug: a striped, pillow-shaped boiled sweet."""
    k, color = look.between(0.9, 1.15), look.color("black", "brown", "maroon", "green")
    x = np.linspace(-1, 1, 11)
    body = tube(np.column_stack([0.013 * x, 0 * x, 0 * x]), 0.0095 * np.maximum(1 - np.abs(x) ** 3,
                                                                                0.02) ** 0.5, 12,
                squash=0.8)  # fmt: skip
    body = body.bend(lambda p: np.column_stack([p[:, 0], p[:, 1], p[:, 2]]))
    stripes = surfaces.stripes([color, color, (246, 236, 212)], 6, upright=True)
    return settle([(body, stripes)], 0.14).scale(k)


@category("stick_of_rock", size=(0.18, 0.0248, 0.0233), mass=0.07, material="food",
          aliases=("rock candy stick", "seaside rock", "rock candy", "brighton rock"),
          themes=("food",), roles=("edible",), colors=("pink",), state="lying")  # fmt: skip
@keep_still
def stick_of_rock(look: Look) -> Shape:
    """A stick of seaside rock: a pink cylinder with letters in its white ends."""
    long, r = look.between(0.14, 0.2), look.between(0.0105, 0.013)
    color = look.color("pink", "pink", "magenta", "red", "green", "sky")
    stick = cylinder(r, long, 24).turn(1, np.pi / 2).move(-long / 2, 0, r)
    image = prints.canvas(64, 64, (250, 248, 246))
    prints.disc(image, 0.5, 0.5, 0.36, color, 0.3)
    prints.write(image, "ROCK", 0.5, 0.5, 0.2, (196, 40, 60), bold=True)
    ends = [cylinder(0.86 * r, 0.0006, 20).turn(1, s * np.pi / 2).move(s * long / 2, 0, r)
            for s in (-1, 1)]  # fmt: skip
    wrap = cylinder(1.02 * r, 0.2 * long, 24).turn(1, np.pi / 2).move(-0.1 * long, 0, r)
    label = prints.canvas(96, 64, (248, 246, 240))
    prints.write(
        label, look.pick(["SEASIDE", "BRIGHTON", "PIER"]), 0.5, 0.5, 0.2, (50, 90, 170), bold=True
    )
    return settle([(stick, surfaces.stripes([color, tint_color(color, 1.15)], 5, upright=True)),
                   (join(ends), image), (wrap, label)], 0.06, hulls=[[0]])  # fmt: skip


@category("peanut_brittle", size=(0.081, 0.0571, 0.00972), mass=0.025, material="food",
          aliases=("brittle", "nut brittle", "sesame brittle", "honeycomb piece"), themes=("food",),
          roles=("edible",), colors=("amber",), state="lying flat")  # fmt: skip
def peanut_brittle(look: Look) -> Shape:
    """A broken slab of peanut brittle: amber sugar full of nuts."""
    k, color = look.between(0.85, 1.15), look.color("amber", "copper", "gold", "bronze")
    corners = np.array([(-0.04, -0.024), (0.006, -0.03), (0.042, -0.014), (0.034, 0.02),
                        (-0.006, 0.03), (-0.036, 0.014)])  # fmt: skip
    slab = prism(corners * (1 + 0.1 * look.rng.uniform(-1, 1, (6, 1))), 0, 0.007)
    nuts = [ellipsoid(0.014, 0.008, 0.006, 8, 5).turn(2, 2.1 * n).move(0.028 * np.cos(2.4 * n)
                                                                       * np.sqrt(n / 13), 0.018
                                                                       * np.sin(2.4 * n)
                                                                       * np.sqrt(n / 13), 0.007)
            for n in range(13)]  # fmt: skip
    made = [
        (slab, surfaces.speckles(look.rng, color, 12)),
        (join(nuts), surfaces.speckles(look.rng, (226, 190, 130), 10)),
    ]
    return settle([(s.scale(k, k, k), t) for s, t in made], 0.0, hulls=[[0]])


@category("gumball_machine", size=(0.141, 0.141, 0.263), mass=0.9, material="plastic",
          aliases=("bubblegum machine", "sweet dispenser", "gum machine", "candy machine"),
          themes=("food",), roles=("tall", "round"), colors=("red",))  # fmt: skip
def gumball_machine(look: Look) -> Shape:
    """A gumball machine: a globe of coloured balls on a red stand with a crank."""
    k, color = look.between(0.85, 1.08), look.color("red", "red", "blue", "black", "pink")
    base = lathe([(0, 0), (0.06, 0), (0.062, 0.012), (0.045, 0.03), (0.045, 0.085), (0.056, 0.1),
                  (0.05, 0.108), (0, 0.108)], 28)  # fmt: skip
    globe = ellipsoid(0.145, 0.145, 0.14, 30, 18).move(z=0.17)
    image = prints.canvas(200, 100, (226, 236, 240))
    hues: tuple[RGB, ...] = ((206, 44, 44), (244, 206, 62), (60, 150, 80), (52, 104, 190),
                             (238, 132, 38), (240, 240, 236), (230, 120, 170))  # fmt: skip
    for n in range(230):
        prints.disc(image, look.rng.random(), look.rng.uniform(0.25, 1.0), 0.045, hues[n % 7])
    lid = lathe(
        [(0, 0.232), (0.036, 0.232), (0.032, 0.25), (0.01, 0.256), (0.008, 0.268), (0, 0.27)], 22
    )
    plate = box(0.05, 0.004, 0.05).move(0, -0.046, 0.036)
    handle = [box(0.03, 0.008, 0.007).move(0, -0.052, 0.066),
              box(0.024, 0.008, 0.016).move(0, -0.05, 0.036)]  # fmt: skip
    made = [(join([base, lid]), look.surface(color, "plastic")), (globe, image),
            (plate, surfaces.brushed_metal(look.rng, (200, 204, 208))),
            (join(handle), surfaces.plain((60, 62, 66)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made, [hull_of(base.scale(k, k, k)), hull_of(made[1][0]), hull_of(lid.scale(k, k, k))]
    )


@category("candy_dispenser", size=(0.0469, 0.0346, 0.124), mass=0.03, material="plastic",
          aliases=("pez",), themes=("food",), roles=("tall",), colors=("red",))  # fmt: skip
def candy_dispenser(look: Look) -> Shape:
    """A candy dispenser: a slim stem with a cartoon head that tips back."""
    k, color = (look.between(0.9, 1.1), look.color("red", "blue", "yellow", "green", "pink",
                                                   "purple"))  # fmt: skip
    stem, foot = box(0.02, 0.014, 0.08).move(z=0.006), block(0.034, 0.03, 0.007, 0.008)
    head = ellipsoid(0.034, 0.03, 0.034, 18, 12).move(z=0.1)
    ears = [ellipsoid(0.016, 0.007, 0.016, 10, 7).move(s * 0.016, 0.002, 0.116) for s in (-1, 1)]
    eyes = [ellipsoid(0.006, 0.004, 0.008, 8, 6).move(s * 0.007, -0.014, 0.104) for s in (-1, 1)]
    nose = ellipsoid(0.008, 0.008, 0.006, 8, 6).move(0, -0.0155, 0.097)
    hue = look.own_color("yellow", "white", "orange", "brown", "black")
    made = [(join([stem, foot]), look.surface(color, "plastic")),
            (join([head, *ears]), surfaces.speckles(look.rng, hue, 3)),
            (join([*eyes]), surfaces.plain((24, 24, 26))),
            (nose, surfaces.plain((206, 44, 44)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made, [hull_of(foot.scale(k, k, k)), hull_of(stem.scale(k, k, k)), hull_of(made[1][0])]
    )


@category("candyfloss", size=(0.281, 0.124, 0.0834), mass=0.03, material="food", assembled=True,
          aliases=("candy floss", "cotton candy", "fairy floss", "stick of candyfloss"),
          themes=("food",), roles=("edible",), colors=("pink",), state="lying")  # fmt: skip
def candyfloss(look: Look) -> Shape:
    """A pink cloud of candyfloss on a stick, lying flat."""
    k, color = look.between(0.85, 1.1), look.color("pink", "pink", "sky", "lavender", "mint")
    puffs = [ellipsoid(0.075, 0.07, 0.066, 12, 8).move(0.035 * np.cos(2.4 * n) - 0.02, 0.03
                                                       * np.sin(2.4 * n), 0.05 + 0.012
                                                       * np.cos(1.7 * n))
             for n in range(8)]  # fmt: skip
    stick = tube([(0.02, 0, 0.045), (0.2, 0, 0.004)], 0.0035, 8)
    fluff = surfaces.scratches(look.rng, color, tint_color(color, 1.4), 300)
    return settle(
        [(join(puffs), fluff), (stick, surfaces.plain((238, 222, 190)))], 0.08, hulls=[[0], [1]]
    ).scale(k)


@category("gummy_worm", size=(0.0867, 0.0314, 0.0079), mass=0.005, material="food",
          aliases=("sour worm", "jelly worm", "jelly snake", "gummy snake", "earthworm"),
          themes=("food",), roles=("edible",), colors=("red",), state="lying")  # fmt: skip
def gummy_worm(look: Look) -> Shape:
    """A ribbed jelly worm in two colours, coated with sugar."""
    long = look.between(0.07, 0.1)
    color = look.color("red", "green", "orange", "sky", "yellow", "pink")
    other = look.own_color("yellow", "lime", "sky", "pink")
    u = np.linspace(-1, 1, 25)
    path = np.column_stack([long / 2 * u, 0.012 * np.sin(5 * u), 0 * u])
    body = tube(path, 0.0042 * (1 + 0.12 * np.cos(30 * u)) * np.maximum(1 - u**8, 0.1), 8)
    half = np.where((np.linspace(0, 1, 96) > 0.5)[:, None, None], np.array(color), np.array(other))
    tile = np.broadcast_to(half, (96, 64, 3)).astype(np.uint8).copy()
    for _ in range(160):
        a, b = look.rng.integers(0, 95), look.rng.integers(0, 63)
        tile[a, b] = 250
    return settle([(body, tile)], 0.16)


@category("cola_bottle_sweet", size=(0.0342, 0.016, 0.0064), mass=0.004, material="food",
          aliases=("cola bottle", "gummy bottle", "fizzy cola bottle"), themes=("food",),
          roles=("edible",), colors=("brown",), state="lying flat")  # fmt: skip
def cola_bottle_sweet(look: Look) -> Shape:
    """A flat jelly sweet in the shape of a cola bottle, brown at the bottom and clear above."""
    k, color = look.between(0.9, 1.2), look.color("brown", "maroon", "copper")
    side = smooth(
        [(-0.016, 0.0075), (-0.006, 0.0055), (0.002, 0.0072), (0.008, 0.004), (0.016, 0.003)], 3
    )
    outline = np.concatenate([side[::-1], side * [1, -1]])
    body = prism(outline, 0, 0.006)
    tile = np.where(
        (np.linspace(0, 1, 64) > 0.62)[None, :, None], np.array((246, 206, 140)), np.array(color)
    )
    return shape(
        [(body.scale(k, k, k), np.broadcast_to(tile, (64, 64, 3)).astype(np.uint8).copy())],
        [hull_of(body.scale(k, k, k))],
    )


@category("fruit_pastille", size=(0.0266, 0.0224, 0.00874), mass=0.003, material="food",
          aliases=("pastille", "wine gum", "gumdrop", "gum drop", "lozenge", "fruit gum",
          "jelly sweet"), themes=("food",), roles=("edible",), colors=("red",))  # fmt: skip
def fruit_pastille(look: Look) -> Shape:
    """A fruit pastille: a sugared disc with a rounded top, or an oval lozenge."""
    r, color = (look.between(0.0095, 0.0125), look.color("red", "green", "yellow", "orange",
                                                         "purple", "black"))  # fmt: skip
    body = lathe([(0, 0), (r, 0), (0.95 * r, 0.5 * r), (0.6 * r, 0.75 * r), (0, 0.78 * r)], 24)
    body = body.scale(look.pick([1.0, 1.3]), 1, 1)
    return shape(
        [(body, surfaces.spots(look.rng, color, tint_color(color, 1.5), 0.25))], [hull_of(body)]
    )


CATEGORIES = (
    Category("gumball", _ball((0.018, 0.025), False), size=(0.0218, 0.0221, 0.0201), mass=0.006,
             material="food",
             aliases=("bubblegum ball", "bubble gum ball", "gum ball", "aniseed ball", "malt ball"),
             themes=("food",), roles=("edible", "round"), colors=("red",)),
    Category("gobstopper", _ball((0.024, 0.034), True), size=(0.0288, 0.0291, 0.0265), mass=0.014,
             material="food", aliases=("jawbreaker", "everlasting gobstopper"), themes=("food",),
             roles=("edible", "round"), colors=("white",)),
    Category("fudge", _cube((0.022, 0.028), 0.75, ("tan", "wooden", "brown", "copper"), "fudge"),
             size=(0.025, 0.0226, 0.0176), mass=0.014, material="food", aliases=("square of fudge",
             "fudge piece", "fudge cube", "toffee", "caramel square", "tablet of fudge",
             "salted caramel"), themes=("food",), roles=("edible",), colors=("tan",)),
    Category("nougat", _cube((0.028, 0.038), 0.5, ("ivory", "cream", "white", "pink"), "nougat"),
             size=(0.0329, 0.0311, 0.016), mass=0.018, material="food",
             aliases=("turron", "nougat bar", "piece of nougat"), themes=("food",),
             roles=("edible",), colors=("ivory",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
