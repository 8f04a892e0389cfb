"""Cheeses by the piece, and what cuts them."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.outlines import arc, smooth
from ...build.recipes import ball, put_down, straight
from ...build.settled import rod, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (188, 191, 196)


def cheese_wheel(profile: list[tuple[float, float]], segments: int) -> Solid:
    """Return a body turned from a smooth curve through ``profile``."""
    curve = np.maximum(smooth(profile, 4), 0)
    return lathe(curve, segments)


def wedge(flesh: tuple[str, ...], rind: RGB, veins: RGB | None):
    """Return a wedge cut from a round cheese, with a rind and veins or holes."""

    def make(look: Look) -> Shape:
        r, h = look.between(0.1, 0.12), look.between(0.042, 0.055)
        half = look.between(0.26, 0.34)
        outline = np.concatenate([[(0.0, 0.0)], arc((0, 0), r, -half, half, 8)]) - [0.6 * r, 0]
        color = look.color(*flesh)
        body = prism(outline, 0, h)
        rim = arc((0, 0), 1.0 * r, -half, half, 8) - [0.6 * r, 0]
        outer = arc((0, 0), 1.04 * r, half, -half, 8) - [0.6 * r, 0]
        back = prism(np.concatenate([outer[::-1], rim[::-1]]), 0, h)
        tile = (textures.speckles(look.rng, color, 5) if veins is None
                else textures.marble(look.rng, color, veins))  # fmt: skip
        return shape([(body, tile), (back, textures.speckles(look.rng, rind, 10))],
                     [hull_of(body, back)])  # fmt: skip

    return make


def cheese_block(look: Look) -> Shape:
    """A rectangular block of firm cheese."""
    k = look.between(0.9, 1.12)
    color = look.color("yellow", "amber", "cream", "orange")
    x, y, h = 0.115 * k, 0.065 * k, 0.045 * k
    tone = tint_color(color, 1.12)
    body = block(x, y, h, 0.002, 0.0008)
    return shape([(body, textures.spots(look.rng, tone, tint_color(tone, 0.93), 0.1))],
                 [box_part(x, y, h)])  # fmt: skip


def cheese_cube(look: Look) -> Shape:
    """One bite-sized cube of cheese."""
    x = look.between(0.017, 0.021)
    color = look.color("yellow", "yellow", "amber")
    return shape(
        [(block(x, x, x, 0.001, 0.0005), textures.speckles(look.rng, tint_color(color, 1.25), 5))],
        [box_part(x, x, x)],
    )


def cheese_log(look: Look) -> Shape:
    """A white log of goat's cheese with a wrinkled rind."""
    long, r = look.between(0.12, 0.15), look.between(0.021, 0.025)
    body = cylinder(r, long, 26, bevel=0.003).turn(1, np.pi / 2).move(x=-long / 2)
    rind = textures.scratches(look.rng, look.color("white", "ivory"), (222, 218, 206), 90)
    return settle([(body, rind)], 0.1)


def wax_round(look: Look) -> Shape:
    """A small round cheese in red wax with its pull tab."""
    r, h = look.between(0.019, 0.022), look.between(0.017, 0.02)
    color = look.color("red", "red", "yellow", "green")
    body = lathe([(0, 0), (0.8 * r, 0), (r, 0.25 * h), (r, 0.75 * h), (0.8 * r, h), (0, h)], 26)
    tab = box(0.006, 0.0012, 0.5 * h).move(0, -r, 0.25 * h)
    return shape([(body, textures.speckles(look.rng, color, 4)), (tab, textures.plain(
                  tint_color(color, 1.3)))], [hull_of(body, tab)])  # fmt: skip


def edam(look: Look) -> Shape:
    """A ball of cheese in red wax with a wedge-shaped cut."""
    r = look.between(0.062, 0.072)
    color = look.color("red", "red", "yellow")
    body = cheese_wheel([(0, 0), (0.5 * r, 0), (0.9 * r, 0.42 * r), (r, 0.85 * r), (0.9 * r,
    1.3 * r),
                   (0.5 * r, 1.65 * r), (0, 1.72 * r)], 32)  # fmt: skip
    wax = textures.speckles(look.rng, color, 5)
    label = lathe([(0, 1.715 * r), (0.42 * r, 1.67 * r), (0.42 * r, 1.69 * r), (0, 1.74 * r)], 26)
    return shape([(body, wax), (label, textures.plain((246, 240, 214)))], [hull_of(body)])


def cheese_ball(look: Look) -> Shape:
    """A soft white ball of fresh cheese, knotted on top."""
    r = look.between(0.036, 0.044)
    body = cheese_wheel([(0, 0), (0.6 * r, 0), (0.92 * r, 0.3 * r), (r, 0.65 * r), (0.85 * r,
    1.1 * r),
                   (0.5 * r, 1.42 * r), (0.2 * r, 1.52 * r), (0.13 * r, 1.6 * r),
                   (0.2 * r, 1.68 * r), (0, 1.74 * r)], 26)  # fmt: skip
    return shape([(body, textures.speckles(look.rng, look.color("ivory", "white"), 4))],
                 [hull_of(body)])  # fmt: skip


def slicer(look: Look) -> Shape:
    """A cheese plane lying: a slotted blade with a handle."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "black", "red", "silver", "teal")
    plate = prism(np.array([(-0.012, -0.02), (0.03, -0.036), (0.1, -0.034), (0.1, 0.034),
                            (0.03, 0.036), (-0.012, 0.02)]), 0.004, 0.0058)  # fmt: skip
    slot = box(0.005, 0.05, 0.0024).move(x=0.05, z=0.0038)
    lip = box(0.008, 0.05, 0.0016).turn(1, 0.3).move(x=0.058, z=0.0066)
    neck = straight((-0.012, 0, 0.006), (-0.04, 0, 0.011), 0.0045)
    grip = rod(0.11, 0.0105, blunt=6).move(x=-0.09, z=0.0105)
    steel = textures.brushed_metal(look.rng, STEEL)
    return put_down([(join([plate, neck, lip]), steel), (slot, textures.plain((40, 42, 46))),
                     (grip, look.surface(color, "wood"))], plate, grip, factor=k,
                    foot=0.35)  # fmt: skip


def wire_slicer(look: Look) -> Shape:
    """A board with a wire on a bow that cuts cheese."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "white", "cream")
    x, y = 0.22 * k, 0.14 * k
    board = block(x, y, 0.018, 0.006, 0.002)
    slot = box(0.003, 0.9 * y, 0.0006).move(x=0.18 * x, z=0.0177)
    arm = [straight((0.18 * x, s * 0.42 * y, 0.018), (0.18 * x, s * 0.42 * y, 0.062), 0.0028)
           for s in (-1, 1)]  # fmt: skip
    bar = straight((0.18 * x, -0.42 * y, 0.06), (0.18 * x, 0.42 * y, 0.06), 0.0028)
    wire = straight((0.18 * x, -0.42 * y, 0.03), (0.18 * x, 0.42 * y, 0.03), 0.0006, 5)
    knob = ball(0.016, 0.016, 0.016, (0.18 * x, 0, 0.066), 12)
    steel = textures.brushed_metal(look.rng, STEEL)
    return shape(
        [
            (board, look.surface(color, "wood")),
            (slot, textures.plain((60, 46, 36))),
            (join([*arm, bar, wire, knob]), steel),
        ],
        [box_part(x, y, 0.018), hull_of(bar, knob), *(hull_of(a) for a in arm)],
    )


def paste(look: Look) -> Shape:
    """A slab of dark red fruit paste."""
    k = look.between(0.9, 1.1)
    x, y, h = 0.07 * k, 0.05 * k, 0.022 * k
    tone = look.color("crimson", "maroon")
    return shape([(block(x, y, h, 0.003, 0.0015), textures.gradient(tint_color(tone, 0.8),
                  tint_color(tone, 1.1), look.rng))], [box_part(x, y, h)])  # fmt: skip


def lump(look: Look) -> Shape:
    """Wasabi: a small pressed cone of green paste."""
    r = look.between(0.013, 0.017)
    color = look.color("lime", "olive", "green")
    tone = tint_color((170.0, 196.0, 100.0), 1.0) if "color" not in look.attributes else color
    body = lathe([(0, 0), (r, 0), (0.95 * r, 0.35 * r), (0.5 * r, 1.0 * r), (0.2 * r, 1.35 * r),
                  (0, 1.4 * r)], 18)  # fmt: skip
    rough = body.bend(lambda p: p * (1 + 0.05 * np.sin(900 * p[:, :1] + 700 * p[:, 1:2])))
    return shape([(rough, textures.speckles(look.rng, tone, 14)),
                  (cylinder(0.5 * r, 0.0004, 10), textures.plain(tone))],
                 [cylinder_part(0.95 * r, 0.3 * r), hull_of(body)])  # fmt: skip


_K = ("kitchen", "dining")
_E = ("edible",)
CATEGORIES = (
    Category("blue_cheese", wedge(("cream", "ivory"), (196, 178, 140), (70, 96, 120)), (0.118,
             0.0714, 0.0494), 0.2, ("stilton", "stilton wedge", "blue cheese wedge", "roquefort",
             "gorgonzola", "wedge of stilton", "wedge of blue cheese"), _K, _E, ("cream",)),
    Category("hard_cheese", wedge(("cream", "beige"), (150, 104, 58), None), (0.115, 0.0685,
             0.0462), 0.25, ("parmesan", "pecorino", "parmesan wedge", "wedge of parmesan",
             "manchego", "gruyere", "wensleydale", "cheese rind", "raclette cheese", "raclette",
             "brie wedge", "wedge of brie"), _K, _E, ("cream",)),
    Category("cheese_block", cheese_block, (0.117, 0.0662, 0.0458), 0.3, ("block of cheese",
             "block of cheddar", "cheddar", "cheddar block", "cheddar cheese", "red leicester",
             "red leicester block", "monterey jack"), _K, _E, ("yellow",)),
    Category("cheese_cube", cheese_cube, (0.0193, 0.0193, 0.0193), 0.006, ("cube of cheese",
             "cheddar cube", "diced cheese"), _K, _E, ("yellow",)),
    Category("goat_cheese", cheese_log, (0.136, 0.0448, 0.04), 0.15, ("goat's cheese",
             "goats cheese", "goat's cheese log", "goat cheese log", "chevre", "cheese log"), _K,
             _E, ("white",), state="lying flat"),
    Category("babybel", wax_round, (0.0417, 0.0427, 0.0188), 0.022, ("mini cheese", "waxed cheese",
             "baby bel"), _K, ("edible", "round"), ("red",)),
    Category("edam", edam, (0.134, 0.134, 0.117), 0.9, ("edam cheese", "edam ball",
             "ball of edam"), _K, ("edible", "round"), ("red",)),
    Category("mozzarella", cheese_ball, (0.0772, 0.0777, 0.0715), 0.125, ("burrata",
             "ball of mozzarella", "mozzarella ball", "buffalo mozzarella", "bocconcini"), _K,
             ("edible", "round"), ("ivory",)),
    Category("cheese_plane", slicer, (0.246, 0.0724, 0.0206), 0.08, ("cheese slicer",
             "cheese shaver", "truffle slicer"), _K, (), ("wooden",), state="lying flat"),
    Category("cheese_wire", wire_slicer, (0.218, 0.139, 0.074), 0.6, ("wire cheese slicer",
             "cheese slicer board"), _K, (), ("wooden",)),
    Category("quince_paste", paste, (0.0726, 0.0519, 0.0228), 0.09, ("membrillo", "quince jelly",
             "fruit paste", "quince cheese"), _K, _E, ("crimson",)),
    Category("wasabi", lump, (0.0287, 0.0282, 0.0198), 0.008, ("wasabi paste", "lump of wasabi",
             "ball of wasabi"), ("dining",), _E, ()),
)  # fmt: skip
"""The module's categories."""
