"""Objects of the ``kitchen`` theme: dairy."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import box_part, hull_of, hull_part, resting_ball
from ...kit.primitives import press_flat
from ...kit.shapes import Category, Shape, category, settle, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, prism
from ...kit.surfaces import RGB, Look, tint_color
from .nuts import Heap, heap


def cheese_wheel(profile: list[tuple[float, float]], segments: int) -> Solid:
    """Return a solid of revolution whose profile is a smooth curve through ``profile``."""
    curve = np.maximum(smooth(profile, 4), 0)
    return lathe(curve, segments)


def wedge(flesh: tuple[str, ...], rind: RGB, veins: RGB | None):
    """Return the shape function of a wedge of veined or speckled cheese with a rind."""

    def make(look: Look) -> Shape:
        r, h = look.between(0.1, 0.12), look.between(0.042, 0.055)
        half = look.between(0.26, 0.34)
        outline = np.concatenate([[(0.0, 0.0)], arc((0, 0), r, -half, half, 8)]) - [0.6 * r, 0]
        color = look.color(*flesh)
        body = prism(outline, 0, h)
        rim = arc((0, 0), 1.0 * r, -half, half, 8) - [0.6 * r, 0]
        outer = arc((0, 0), 1.04 * r, half, -half, 8) - [0.6 * r, 0]
        back = prism(np.concatenate([outer[::-1], rim[::-1]]), 0, h)
        tile = (surfaces.speckles(look.rng, color, 5) if veins is None
                else surfaces.marble(look.rng, color, veins))  # fmt: skip
        return shape([(body, tile), (back, surfaces.speckles(look.rng, rind, 10))],
                     [hull_of(body, back)])  # fmt: skip

    return make


@category("cheese_block", size=(0.117, 0.0662, 0.0458), mass=0.3, material="food",
          aliases=("block of cheese", "block of cheddar", "cheddar", "cheddar block",
          "cheddar cheese", "red leicester", "red leicester block", "monterey jack"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("yellow",))  # fmt: skip
def cheese_block(look: Look) -> Shape:
    """A rectangular block of firm cheese."""
    k = look.between(0.9, 1.12)
    color = look.color("yellow", "amber", "cream", "orange")
    x, y, h = 0.115 * k, 0.065 * k, 0.045 * k
    tone = tint_color(color, 1.12)
    body = block(x, y, h, 0.002, 0.0008)
    return shape([(body, surfaces.spots(look.rng, tone, tint_color(tone, 0.93), 0.1))],
                 [box_part(x, y, h)])  # fmt: skip


@category("cheese_cube", size=(0.0193, 0.0193, 0.0193), mass=0.006, material="food",
          aliases=("cube of cheese", "cheddar cube", "diced cheese"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("yellow",))  # fmt: skip
def cheese_cube(look: Look) -> Shape:
    """One bite-sized cube of cheese."""
    x = look.between(0.017, 0.021)
    color = look.color("yellow", "yellow", "amber")
    return shape(
        [(block(x, x, x, 0.001, 0.0005), surfaces.speckles(look.rng, tint_color(color, 1.25), 5))],
        [box_part(x, x, x)],
    )


@category("goat_cheese", size=(0.136, 0.0448, 0.04), mass=0.15, material="food",
          aliases=("goat's cheese", "goats cheese", "goat's cheese log", "goat cheese log",
          "chevre", "cheese log"), themes=("kitchen", "dining"), roles=("edible",),
          colors=("white",), state="lying flat")  # fmt: skip
def goat_cheese(look: Look) -> Shape:
    """A white log of goat's cheese with a wrinkled rind."""
    long, r = look.between(0.12, 0.15), look.between(0.021, 0.025)
    body = cylinder(r, long, 26, bevel=0.003).turn(1, np.pi / 2).move(x=-long / 2)
    rind = surfaces.scratches(look.rng, look.color("white", "ivory"), (222, 218, 206), 90)
    return settle([(body, rind)], 0.1)


@category("babybel", size=(0.0417, 0.0427, 0.0188), mass=0.022, material="food",
          aliases=("mini cheese", "waxed cheese", "baby bel"), themes=("kitchen", "dining"),
          roles=("edible", "round"), colors=("red",))  # fmt: skip
def babybel(look: Look) -> Shape:
    """A small, round cheese in red wax with a pull tab."""
    r, h = look.between(0.019, 0.022), look.between(0.017, 0.02)
    color = look.color("red", "red", "yellow", "green")
    body = lathe([(0, 0), (0.8 * r, 0), (r, 0.25 * h), (r, 0.75 * h), (0.8 * r, h), (0, h)], 26)
    tab = box(0.006, 0.0012, 0.5 * h).move(0, -r, 0.25 * h)
    return shape([(body, surfaces.speckles(look.rng, color, 4)), (tab, surfaces.plain(
                  tint_color(color, 1.3)))], [hull_of(body, tab)])  # fmt: skip


@category("edam", size=(0.134, 0.134, 0.117), mass=0.9, material="food",
          aliases=("edam cheese", "edam ball", "ball of edam"), themes=("kitchen", "dining"),
          roles=("edible", "round"), colors=("red",))  # fmt: skip
def edam(look: Look) -> Shape:
    """A ball of Edam cheese in red wax with a wedge cut out."""
    r = look.between(0.062, 0.072)
    color = look.color("red", "red", "yellow")
    body = cheese_wheel([(0, 0), (0.5 * r, 0), (0.9 * r, 0.42 * r), (r, 0.85 * r), (0.9 * r,
    1.3 * r),
                   (0.5 * r, 1.65 * r), (0, 1.72 * r)], 32)  # fmt: skip
    wax = surfaces.speckles(look.rng, color, 5)
    label = lathe([(0, 1.715 * r), (0.42 * r, 1.67 * r), (0.42 * r, 1.69 * r), (0, 1.74 * r)], 26)
    return shape([(body, wax), (label, surfaces.plain((246, 240, 214)))], [hull_of(body)])


@category("mozzarella", size=(0.0772, 0.0777, 0.0715), mass=0.125, material="food",
          aliases=("burrata", "ball of mozzarella", "mozzarella ball", "buffalo mozzarella",
          "bocconcini"), themes=("kitchen", "dining"), roles=("edible", "round"),
          colors=("ivory",))  # fmt: skip
def mozzarella(look: Look) -> Shape:
    """A soft, white ball of mozzarella with a knot on top."""
    r = look.between(0.036, 0.044)
    body = cheese_wheel([(0, 0), (0.6 * r, 0), (0.92 * r, 0.3 * r), (r, 0.65 * r), (0.85 * r,
    1.1 * r),
                   (0.5 * r, 1.42 * r), (0.2 * r, 1.52 * r), (0.13 * r, 1.6 * r),
                   (0.2 * r, 1.68 * r), (0, 1.74 * r)], 26)  # fmt: skip
    return shape([(body, surfaces.speckles(look.rng, look.color("ivory", "white"), 4))],
                 [hull_of(body)])  # fmt: skip


@category("cheese_wheel", size=(0.169, 0.161, 0.054), mass=0.9, material="food",
          aliases=("wheel of cheese", "round of cheese", "gouda", "camembert", "brie", "brie wheel",
          "gouda wheel", "wheel of brie", "wheel of gouda", "wheel of camembert", "cheese round"),
          themes=("kitchen",), roles=("edible", "round"), colors=("yellow",))  # fmt: skip
def cheese_wheel_(look: Look) -> Shape:
    """A round, labelled cheese with a slice cut out."""
    r, h = look.between(0.07, 0.095), look.between(0.045, 0.06)
    color = look.color("yellow", "golden", "red", "orange", "cream")
    a = np.linspace(-1.15, 2 * np.pi - 2.0, 40)
    outline = np.concatenate([[(0, 0)], np.column_stack([r * np.cos(a), r * np.sin(a)])])
    body = prism(outline, 0.001, h - 0.001)
    inner = surfaces.spots(look.rng, (248, 222, 130), (226, 186, 88), 0.06)
    rind = [prism(outline * 1.005, z, z + 0.0022) for z in (0, h - 0.0022)]
    band = np.concatenate([1.012 * outline[1:], 0.985 * outline[:0:-1]])
    shell = join([*rind, prism(band, 0, h)])
    made = [(body, inner), (shell, surfaces.speckles(look.rng, color, 6))]
    label = cylinder(0.4 * r, 0.0008, 26).move(0.0, 0.35 * r, h - 0.0002)
    made.append((label, surfaces.plain(look.own_color("white", "red", "green", "gold"))))
    return shape(made, [hull_of(prism(outline[[0, *range(1, 21)]], 0, h)),
                        hull_of(prism(outline[[0, *range(20, 41)]], 0, h))])  # fmt: skip


@category("cheese_slice", size=(0.0884, 0.0884, 0.00383), mass=0.022, material="food",
          aliases=("slice of cheese", "sliced cheese", "swiss cheese slice"), themes=("kitchen",),
          roles=("edible", "flat"), colors=("yellow",), state="lying flat")  # fmt: skip
def cheese_slice(look: Look) -> Shape:
    """A square slice of cheese with printed holes, lying flat."""
    x, t = look.between(0.085, 0.095), look.between(0.003, 0.0045)
    color = look.color("yellow", "golden", "amber", "cream")
    face = surfaces.speckles(look.rng, color, 4, 96)
    y, u = np.mgrid[0:96, 0:96]
    for _ in range(8):
        a, b, d = look.rng.uniform(10, 86), look.rng.uniform(10, 86), look.rng.uniform(3, 9)
        face[np.hypot(u - a, y - b) < d] = np.array(tint_color(color, 0.72)).astype(np.uint8)
    return shape([(block(x, x, t, 0.006), face)], [box_part(x, x, t)])


@category("cheese", size=(0.12, 0.07, 0.045), mass=0.2, material="food",
          aliases=("cheese wedge", "wedge of cheese"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("yellow",), common=True)  # fmt: skip
def cheese(look: Look) -> Shape:
    """A wedge of cheese with holes."""
    color = look.color("yellow", "amber", "cream", "orange")
    image = surfaces.speckles(look.rng, color, 4, 96).copy()
    for _ in range(10):
        x, y = look.rng.uniform(0.1, 0.9, 2)
        prints.disc(image, float(x), float(y), look.between(0.03, 0.08), tint_color(color, 0.78))
    wedge = prism(
        [(-0.06, -0.035), (0.06, 0.0), (-0.06, 0.035)], 0, look.between(0.04, 0.05), 0.002
    )
    return shape([(wedge, image)], [hull_of(wedge)])


@category("egg", size=(0.056, 0.043, 0.041), mass=0.058, material="food",
          aliases=("wooden egg", "marble egg", "hard boiled egg", "golden egg"),
          themes=("kitchen",), roles=("round", "edible"), colors=("cream", "tan"),
          state="lying flat", common=True)  # fmt: skip
def egg(look: Look) -> Shape:
    """An egg, lying on its side."""
    color = look.color("cream", "tan", "white", "beige")
    a = np.linspace(-np.pi / 2, np.pi / 2, 13)
    profile = np.column_stack([0.0215 * np.cos(a) * (1 - 0.12 * np.sin(a)), 0.028 * np.sin(a)])
    profile[[0, -1], 0] = 0
    body = press_flat(lathe(profile, 20).turn(1, np.pi / 2), 0.0198)
    shell = surfaces.spots(look.rng, color, tint_color(color, 0.85), 0.03)
    return shape([(body, shell)], [resting_ball(0.056, 0.043, 0.0405)])


@category("butter", size=(0.18, 0.12, 0.045), mass=0.4, material="ceramic",
          aliases=("stick of butter", "butter stick", "block of butter", "pat of butter",
          "butter pat"), themes=("kitchen", "breakfast"), roles=("edible",),
          colors=("yellow", "white"))  # fmt: skip
def butter(look: Look) -> Shape:
    """A stick of butter on a dish, partly cut, with its wrapper folded back."""
    x, y, h = look.between(0.11, 0.13), look.between(0.055, 0.065), look.between(0.036, 0.044)
    color = look.color("white", "white", "sky", "cream", "teal", "pink", "navy")
    dish = loft(np.stack([np.column_stack([rectangle(1, 1, 0.2, 4) * [a, b], np.full(20, z)]) for a,
                          b, z in ((x + 0.02, y + 0.02, 0), (x + 0.065, y + 0.06, 0.014),
                                   (x + 0.055, y + 0.05, 0.014), (x + 0.02, y + 0.02, 0.006))]),
                rectangle(1, 1, 0.2, 4))  # fmt: skip
    yellow = surfaces.speckles(look.rng, look.pick([(246, 222, 128), (248, 230, 156)]), 4, 32)
    kind = look.pick(["block", "cut", "wrapped"])
    stick = block(x, y, h, 0.003, 0.002).move(z=0.0055)
    pieces, parts = [(dish, look.surface(color, "ceramic"))], [hull_part(dish.vertices)]
    if kind == "cut":
        stick = block(0.72 * x, y, h, 0.003, 0.002).move(x=0.14 * x, z=0.0055)
        slice_ = block(0.1 * x, y, h, 0.002, 0.001).turn(1, -1.1).move(x=-0.34 * x, z=0.009)
        pieces.append((slice_, yellow))
    pieces.append((stick, yellow))
    parts.append(hull_of(stick))
    if kind == "wrapped":
        paper = prints.canvas(128, 64, (240, 236, 220))
        ink = look.own_color("blue", "red", "green", "gold")
        prints.fill(paper, 0, 0.1, 1, 0.12, ink)
        prints.write(paper, "BUTTER", 0.5, 0.55, 0.36, ink, bold=True)
        wrap = box(0.6 * x, y + 0.003, h + 0.0022).move(x=0.2 * x + 0.002, z=0.005)
        pieces.append((wrap, paper))
    return shape(pieces, parts)


CATEGORIES = (
    Category("blue_cheese", wedge(("cream", "ivory"), (196, 178, 140), (70, 96, 120)),
             size=(0.118, 0.0714, 0.0494), mass=0.2, material="food", aliases=("stilton",
             "stilton wedge", "blue cheese wedge", "roquefort", "gorgonzola", "wedge of stilton",
             "wedge of blue cheese"), themes=("kitchen", "dining"), roles=("edible",),
             colors=("cream",)),
    Category("hard_cheese", wedge(("cream", "beige"), (150, 104, 58), None),
             size=(0.115, 0.0685, 0.0462), mass=0.25, material="food", aliases=("parmesan",
             "pecorino", "parmesan wedge", "wedge of parmesan", "manchego", "gruyere",
             "wensleydale", "cheese rind", "raclette cheese", "raclette", "brie wedge",
             "wedge of brie"), themes=("kitchen", "dining"), roles=("edible",), colors=("cream",)),
    Category("grated_cheese",
             heap(Heap((0.03, 0.042), 0.009, "strand", ("yellow", "cream", "amber"))),
             size=(0.0877, 0.084, 0.0238), mass=0.04, material="food", aliases=("shredded cheese",
             "grated cheddar", "grated parmesan", "grated carrot", "shredded cabbage",
             "heap of grated cheese", "pile of grated cheese", "mound of grated cheese",
             "grated cheese heap"), themes=("kitchen", "food"), roles=("edible",),
             colors=("yellow",), state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
