"""Gear for brewing coffee and serving drinks: drippers, presses, filters, sleeves."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.outlines import smooth
from ...build.recipes import ball, open_vessel, straight
from ...build.settled import limb, scatter
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, torus, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (188, 191, 196)
GLASS: RGB = (212, 224, 226)
COFFEE: RGB = (58, 34, 22)


def filter_paper(look: Look) -> Shape:
    """A cone of filter paper opened and standing on its rim edge, or a fluted cup."""
    r, h = look.between(0.05, 0.058), look.between(0.038, 0.048)
    color = look.color("white", "white", "tan")
    body, parts = open_vessel([(0.52 * r, 0), (r, h)], 0.0014, 0.0014, 60)
    pleat = body.bend(lambda p: p * np.column_stack([*[1 + 0.035 * np.cos(30 * np.arctan2(
        p[:, 1], p[:, 0])) * (p[:, 2] / h)] * 2, np.ones(len(p))]))  # fmt: skip
    folds = textures.stripes([color, tint_color(color, 0.86)], 30, upright=True, side=120)
    return shape([(pleat, folds)], parts)


def dripper(look: Look) -> Shape:
    """A pour-over dripper: a ribbed cone on a flat foot with a handle, open above."""
    k = look.between(0.94, 1.08)
    color = look.color("white", "red", "black", "teal", "clear", "brown")
    r, h = 0.058 * k, 0.075 * k
    body, parts = open_vessel([(0.3 * r, 0), (0.34 * r, 0.14 * h), (r, h)], 0.004, 0.004, 32)
    foot = lathe(
        [(0.28 * r, 0), (0.86 * r, 0), (0.86 * r, 0.005), (0.28 * r, 0.005)], 32, loop=True
    )
    grip = torus(0.021 * k, 0.005 * k, 22, 8).turn(0, np.pi / 2).scale(1, 1, 1.15)
    grip = grip.move(x=0.062 * k, z=0.45 * h)
    ribs = [tube([(0.36 * r * np.cos(a), 0.36 * r * np.sin(a), 0.2 * h), (0.9 * r * np.cos(a + 0.7),
            0.9 * r * np.sin(a + 0.7), 0.92 * h)], 0.0022, 5)
            for a in 2 * np.pi * np.arange(9) / 9]  # fmt: skip
    glaze = look.surface(color, "ceramic")
    return shape([(join([body, grip]), glaze), (foot, glaze), (join(ribs), textures.plain(
                  tint_color(color, 0.85)))], [*parts, cylinder_part(0.86 * r, 0.005),
                                               hull_of(grip)])  # fmt: skip


def hourglass_pot(look: Look) -> Shape:
    """A Chemex: an hourglass of glass with a wooden collar, coffee in its lower half."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "wooden", "brown", "black")
    r, h = 0.062 * k, 0.215 * k
    low = lathe([(0, 0), (0.93 * r, 0), (r, 0.04 * h), (0.98 * r, 0.12 * h), (0.7 * r, 0.32 * h),
                 (0, 0.32 * h)], 32)  # fmt: skip
    mid = lathe([(0, 0.32 * h), (0.7 * r, 0.32 * h), (0.38 * r, 0.52 * h), (0, 0.52 * h)], 32)
    cone, _ = open_vessel([(0.38 * r, 0), (0.98 * r, 0.48 * h)], 0.003, 0.004, 32)
    cone = cone.move(z=0.52 * h)
    collar = lathe([(0.3 * r, 0.44 * h), (0.6 * r, 0.44 * h), (0.46 * r, 0.52 * h), (0.6 * r,
                    0.6 * h), (0.3 * r, 0.6 * h)], 28, loop=True)  # fmt: skip
    cord = [torus(0.48 * r, 0.0022, 24, 6).move(z=0.52 * h), ball(0.013, 0.013, 0.013,
            (0, -0.56 * r, 0.5 * h), 10)]  # fmt: skip
    clear = textures.plain(GLASS)
    return shape(
        [
            (low, textures.speckles(look.rng, COFFEE, 4)),
            (join([mid, cone]), clear),
            (collar, look.surface(color, "wood")),
            (join(cord), textures.plain((120, 82, 54))),
        ],
        [hull_of(low, mid), hull_of(cone), hull_of(collar, *cord)],
    )


def aeropress(look: Look) -> Shape:
    """A plunger in a ribbed cylinder with a flange and filter cap."""
    k = look.between(0.94, 1.06)
    color = look.color("charcoal", "charcoal", "black", "gray", "clear")
    cap = cylinder(0.032, 0.014, 28, bevel=0.002)
    body = cylinder(0.029, 0.11, 28).move(z=0.012)
    ring = cylinder(0.049, 0.005, 6).move(z=0.03)
    collar = cylinder(0.035, 0.006, 28).move(z=0.118)
    rod_ = cylinder(0.025, 0.07, 28).move(z=0.12)
    top = cylinder(0.033, 0.006, 28, bevel=0.001).move(z=0.188)
    image = prints.canvas(128, 96, tint_color(color, 1.15))
    for n in range(4):
        prints.disc(image, 0.5, 0.2 + 0.2 * n, 0.07, (220, 180, 90), 0.055)
    dark = textures.speckles(look.rng, tint_color(color, 0.8), 4)
    return shape(
        [
            (body, image),
            (join([cap, ring, collar]), dark),
            (join([rod_, top]), textures.speckles(look.rng, tint_color(color, 1.25), 4)),
        ],
        [hull_of(cap), hull_of(body, collar), hull_of(ring), hull_of(rod_, top)],
    ).scale(k)


def tamper(look: Look) -> Shape:
    """A coffee tamper: a heavy steel base with a turned handle."""
    k = look.between(0.94, 1.06)
    color = look.color("wooden", "black", "red", "brown", "silver")
    base = lathe(
        [(0, 0), (0.029, 0), (0.029, 0.011), (0.022, 0.018), (0.01, 0.024), (0, 0.024)], 32
    )
    grip = lathe(np.maximum(smooth([(0, 0.022), (0.009, 0.022), (0.011, 0.034), (0.0185, 0.056),
                 (0.02, 0.07), (0.012, 0.082), (0, 0.084)], 3), 0), 26)  # fmt: skip
    return shape([(base, textures.brushed_metal(look.rng, STEEL)), (grip, look.surface(color,
                  "wood"))], [hull_of(base), hull_of(grip)]).scale(k)  # fmt: skip


def stirrer(look: Look) -> Shape:
    """A flat wooden stick with round ends."""
    k = look.between(0.95, 1.2)
    color = look.color("wooden", "wooden", "white", "black")
    body = block(0.14 * k, 0.0085 * k, 0.0019, 0.004 * k)
    return shape([(body, look.surface(color, "wood"))], [box_part(0.14 * k, 0.0085 * k, 0.0019)])


def sleeve(look: Look) -> Shape:
    """A corrugated cardboard sleeve of a cup, standing."""
    k = look.between(0.94, 1.08)
    color = look.color("tan", "tan", "brown", "white")
    r, h, t = 0.035 * k, 0.062 * k, 0.0022
    ring = lathe([(r, 0), (1.18 * r, h), (1.18 * r - t, h), (r - t, 0)], 40, loop=True)
    ribs = textures.stripes([color, tint_color(color, 0.86)], 30, upright=True, side=180).copy()
    patch = ribs[:, 72:108]
    prints.disc(patch, 0.5, 0.5, 0.09, tint_color(color, 0.5))
    return shape(
        [(ring, ribs)], ring_parts([(r, 0), (1.18 * r, h)], [(1.18 * r - t, h), (r - t, 0)], 14)
    )


def siphon(look: Look) -> Shape:
    """A siphon brewer: two glass bulbs on a stand over a burner."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "brown", "wooden")
    foot = block(0.13, 0.1, 0.012, 0.02, 0.002)
    post = straight((0.055, 0, 0.01), (0.055, 0, 0.2), 0.0055)
    arm = straight((0.055, 0, 0.165), (0.0, 0, 0.165), 0.005)
    grip = limb([(0.058, 0, 0.19), (0.085, 0, 0.18), (0.088, 0, 0.12), (0.07, 0, 0.09)],
                [0.007] * 4, 8)  # fmt: skip
    low = ball(0.095, 0.095, 0.09, (-0.012, 0, 0.112), 24)
    neck = cylinder(0.016, 0.04, 20).move(-0.012, 0, 0.15)
    top = lathe([(0, 0), (0.02, 0), (0.044, 0.022), (0.047, 0.09), (0.043, 0.09), (0.04, 0.026),
                 (0, 0.008)], 28).move(-0.012, 0, 0.185)  # fmt: skip
    brew = cylinder(0.04, 0.03, 26).move(-0.012, 0, 0.2)
    lamp = lathe([(0, 0), (0.022, 0), (0.024, 0.018), (0.01, 0.03), (0, 0.03)], 22).move(-0.012, 0,
                 0.012)  # fmt: skip
    flame = ball(0.01, 0.01, 0.02, (-0.012, 0, 0.051), 10)
    steel = textures.brushed_metal(look.rng, STEEL)
    clear = textures.plain(GLASS)
    return shape(
        [
            (foot, look.surface(color, "wood")),
            (join([post, arm, lamp]), steel),
            (grip, look.surface(color, "wood")),
            (
                low,
                textures.stack(
                    (textures.plain(GLASS), 0.5), (textures.plain((236, 240, 240)), 0.5)
                ),
            ),
            (join([neck, top]), clear),
            (brew, textures.plain(COFFEE)),
            (flame, textures.plain((90, 150, 236))),
        ],
        [
            hull_of(foot),
            hull_of(post, grip),
            hull_of(low),
            hull_of(top, neck),
            hull_of(lamp),
            hull_of(arm),
        ],
    ).scale(k)


def dispenser(look: Look) -> Shape:
    """A drinks dispenser: a glass jar of juice on a stand, a lid, a tap in front."""
    k = look.between(0.92, 1.06)
    color = look.color("orange", "pink", "yellow", "red", "clear")
    stand = [torus(0.07, 0.004, 30, 6).move(z=0.06), torus(0.08, 0.004, 30, 6).move(z=0.004)]
    stand += [
        straight(
            (0.08 * np.cos(a), 0.08 * np.sin(a), 0.004),
            (0.07 * np.cos(a), 0.07 * np.sin(a), 0.06),
            0.0035,
            6,
        )
        for a in (0.785, 2.356, 3.927, 5.498)
    ]
    jar = lathe([(0, 0.062), (0.068, 0.062), (0.075, 0.075), (0.075, 0.22), (0.055, 0.245), (0,
                 0.245)], 32, v=[0, 0.02, 0.06, 0.86, 0.98, 1])  # fmt: skip
    lid = cylinder(0.06, 0.014, 30, bevel=0.002).move(z=0.244)
    knob = ball(0.02, 0.02, 0.018, (0, 0, 0.264), 12)
    tap = [
        straight((0, -0.07, 0.09), (0, -0.1, 0.09), 0.006),
        straight((0, -0.097, 0.096), (0, -0.097, 0.07), 0.005),
        box(0.03, 0.006, 0.008).move(0, -0.094, 0.096),
    ]
    fruit = scatter(look, 0.05, 6, (0.024, 0.03), 0.16)
    drink = textures.stack(
        (textures.speckles(look.rng, color, 5), 0.72), (textures.plain(GLASS), 0.28)
    )
    steel = textures.brushed_metal(look.rng, STEEL)
    return shape([(join(stand), textures.plain((44, 44, 48))), (jar, drink),
                  (join([lid, knob, *tap]), steel), (fruit, textures.plain((246, 220, 90)))],
                 [cylinder_part(0.083, 0.066), hull_of(jar), hull_of(lid, knob), hull_of(*tap)]
                 ).scale(k)  # fmt: skip


_C = ("coffee",)


CATEGORIES = (
    Category("coffee_filter", filter_paper, (0.113, 0.112, 0.0436), 0.002, ("paper filter",
             "filter paper", "paper coffee filter", "basket filter"), _C, ("container", "round"),
             ("white",)),
    Category("coffee_dripper", dripper, (0.148, 0.118, 0.0762), 0.3, ("pour over dripper",
             "dripper", "pour-over dripper", "v60", "pour over cone", "coffee cone"), _C,
             ("container", "round"), ("white",)),
    vary(Category("chemex", hourglass_pot, (0.124, 0.124, 0.215), 0.7, ("chemex coffee maker",
             "pour over carafe", "pour over coffee maker", "glass coffee maker"), _C,
             ("tall", "round"), ("wooden",))),
    Category("aeropress", aeropress, (0.0867, 0.1, 0.198), 0.2, ("aero press", "plunger brewer"),
             _C, ("tall",), ("charcoal",)),
    Category("coffee_tamper", tamper, (0.0593, 0.0593, 0.0859), 0.35, ("tamper",
             "espresso tamper"), _C, (), ("wooden",)),
    Category("stirrer", stirrer, (0.151, 0.00917, 0.0019), 0.002, ("coffee stirrer",
             "wooden stirrer", "stir stick", "drink stirrer", "cocktail stirrer", "swizzle stick",
             "popsicle stick", "craft stick", "ice pop stick"),
             _C, ("flat",), ("wooden",), state="lying flat"),
    Category("cup_sleeve", sleeve, (0.0829, 0.0829, 0.0622), 0.005, ("coffee sleeve",
             "cardboard sleeve", "coffee cup sleeve", "cup cosy"), _C, (), ("tan",)),
    vary(Category("siphon_brewer", siphon, (0.158, 0.098, 0.27), 1.0, ("siphon", "coffee siphon",
             "vacuum brewer", "syphon coffee maker", "siphon coffee maker"), _C, ("tall",),
             ("black",))),
    Category("drink_dispenser", dispenser, (0.166, 0.185, 0.271), 2.5, ("beverage dispenser",
             "juice dispenser", "drinks dispenser", "lemonade dispenser", "water dispenser"),
             ("dining",), ("tall", "big"), ("orange",)),
)  # fmt: skip
"""The module's categories."""
