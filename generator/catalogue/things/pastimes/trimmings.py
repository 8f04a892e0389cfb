"""What craft boxes hold: googly eyes, pipe cleaners, tassels, dreamcatchers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import drum, plate, standing, steel
from ...build.outlines import ellipse, rectangle
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import join, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def googly_eye(look: Look) -> Shape:
    """A stick-on eye: a white disc and a loose black pupil."""
    color = look.color("white", "white", "yellow", "sky", "pink", "lime")
    r = look.between(0.008, 0.016)
    a, d = look.between(0, 6.28), 0.36 * r
    back = drum(r, 0.25 * r, sides=26, bevel=0.05 * r)
    dome = standing((0.93 * r, 0), (0.9 * r, 0.12 * r), (0.6 * r, 0.2 * r), (0.2 * r, 0.24 * r),
                  at=(0, 0, 0.24 * r), sides=26)  # fmt: skip
    pupil = drum(
        0.5 * r, 0.3 * r, (d * np.cos(a), d * np.sin(a), 0.24 * r), sides=20, bevel=0.05 * r
    )
    return put_down(
        [(join([back, dome]), plain(color)), (pupil, plain((28, 28, 30)))], join([back, dome])
    )


def pipe_cleaner(look: Look) -> Shape:
    """A fuzzy chenille stem lying, bent in a wave."""
    color = look.color("red", "blue", "green", "yellow", "pink", "purple", "orange", "brown")
    k, wave = look.between(0.8, 1.2), look.between(0.006, 0.02)
    x = np.linspace(-0.09, 0.09, 70)
    path = np.column_stack([x, wave * np.sin(x * 40), 0.0034 + 0 * x])
    t = np.arange(70)
    fuzz = tube(path, 0.0034 * (1 + 0.16 * np.cos(2.6 * t)), 8)
    fur = textures.scratches(look.rng, color, tint_color(color, 1.35), 120)
    halves = [tube(path[i : i + 19], 0.0034, 8) for i in (0, 17, 34, 51)]
    return put_down([(fuzz, fur)], *halves, factor=k, foot=0.4)


def lolly_stick(look: Look) -> Shape:
    """A flat wooden stick with round ends."""
    color = look.color("tan", "wooden", "red", "blue", "green", "yellow", "beige")
    long, w = look.between(0.1, 0.15), look.between(0.009, 0.017)
    made = plate(rectangle(long, w, 0.499 * w, 8), 0.0022, bevel=0.0004)
    return put_down([(made, textures.wood(look.rng, color))], made)


def dreamcatcher(look: Look) -> Shape:
    """A hoop with a woven net, beads and hanging feathers, lying."""
    color = look.color("brown", "white", "turquoise", "purple", "tan", "red")
    k = look.between(0.85, 1.15)
    hoop = torus(0.06, 0.0045, 36, 8).move(0, 0.05, 0.0044)
    net = []
    for r, s in ((0.058, 0.042), (0.042, 0.026), (0.026, 0.011)):
        for n in range(12):
            a, b = n * np.pi / 6, (n + 0.5) * np.pi / 6
            start = (r * np.cos(a), 0.05 + r * np.sin(a), 0.004)
            net += [
                straight(start, (s * np.cos(e), 0.05 + s * np.sin(e), 0.004), 0.0006, 4)
                for e in (b, b - np.pi / 6)
            ]
    beads = [ball(0.008, 0.008, 0.008, (x, y, 0.0045), 10)
             for x, y in ((0, 0.05), (0.02, 0.07), (-0.025, 0.035), (0.03, -0.014), (-0.03, -0.014),
                          (0, -0.02))]  # fmt: skip
    cords, quills = [], []
    for x, y in ((-0.03, -0.002), (0, -0.01), (0.03, -0.002)):
        cords.append(straight((x, y, 0.003), (x, y - 0.04, 0.003), 0.0008, 5))
        quills.append(plate(ellipse(0.017, 0.06, 16), 0.0015).move(x, y - 0.06, 0.0008))
    wrap = textures.stripes([color, tint_color(color, 0.8)], 16, upright=True)
    other = look.own_color("white", "tan", "turquoise", "coral", "brown")
    return put_down(
        [
            (hoop, wrap),
            (join([*net, *cords]), plain((232, 224, 206))),
            (join(beads), plain(look.own_color("turquoise", "red", "navy"))),
            (join(quills), textures.scratches(look.rng, other, tint_color(other, 0.75), 70)),
        ],
        hoop,
        *quills,
        factor=k,
        foot=0.2,
    )


def tassel(look: Look) -> Shape:
    """A tassel lying: a loop, a bound head and a skirt of threads."""
    color = look.color("gold", "crimson", "navy", "cream", "green", "purple", "black")
    k = look.between(0.8, 1.25)
    loop = rod(
        [
            (0.02, 0.002, 0.002),
            (0.045, 0.009, 0.002),
            (0.055, 0, 0.002),
            (0.045, -0.009, 0.002),
            (0.02, -0.002, 0.002),
        ],
        0.0016,
        6,
    )
    head = ball(0.022, 0.02, 0.018, (0.012, 0, 0.0085), 14)
    band = drum(0.0085, 0.006, (-0.004, 0, 0.0085), 0, sides=14)
    skirt = rod(
        [(0.0, 0, 0.0082), (-0.03, 0, 0.0082), (-0.072, 0, 0.0075)], [0.0075, 0.0105, 0.012], 14
    )
    strands = textures.stripes([color, tint_color(color, 0.75)], 12, upright=True)
    return put_down(
        [
            (join([loop, head]), plain(color)),
            (skirt.scale(1, 1, 0.85), strands),
            (band, plain(tint_color(color, 0.6))),
        ],
        head,
        skirt.scale(1, 1, 0.85),
        factor=k,
        foot=0.3,
    )


def wind_chime(look: Look) -> Shape:
    """A wind chime lying: a round top with metal tubes on cords."""
    color = look.color("silver", "gold", "copper", "teal", "bronze")
    k = look.between(0.85, 1.15)
    top = drum(0.03, 0.008, (0, 0.09, 0), bevel=0.002)
    loop = torus(0.009, 0.0015, 16, 6).move(0, 0.126, 0.002)
    tubes, cords = [], []
    for n in range(5):
        x, long = 0.017 * (n - 2), 0.1 - 0.012 * abs(n - 1)
        tubes.append(straight((x, 0.035, 0.0057), (x, 0.035 - long, 0.0057), 0.006, 12))
        cords.append(straight((0.6 * x, 0.085, 0.005), (x, 0.034, 0.0055), 0.0007, 4))
    sail = plate(ellipse(0.026, 0.04, 18), 0.003).move(0, -0.1, 0)
    line = straight((0, -0.07, 0.003), (0, -0.084, 0.002), 0.0007, 4)
    wood = textures.wood(look.rng, (140, 92, 56))
    return put_down([(join([top, sail]), wood), (join(tubes), steel(look, color)),
                     (join([loop, *cords, line]), plain((220, 214, 200)))],
                    top, *tubes, sail, factor=k, foot=0.3)  # fmt: skip


CATEGORIES = (
    Category("googly_eye", googly_eye, (0.0241, 0.0243, 0.00656), 0.001,
             ("googly eyes", "google eye", "wiggle eye", "craft eye", "toy eye"), ("craft",),
             ("flat",),
             ("white",)),
    Category("pipe_cleaner", pipe_cleaner, (0.175, 0.0301, 0.00705), 0.003,
             ("chenille stem", "fuzzy stick"), ("craft",), ("flat",), ("red", "blue")),
    Category("lolly_stick", lolly_stick, (0.127, 0.0135, 0.0022), 0.002,
             ("ice lolly stick", "lollipop stick",
              "wooden craft stick"), ("craft",), ("flat",), ("tan",)),
    Category("dreamcatcher", dreamcatcher, (0.13, 0.216, 0.00898), 0.05,
             ("dream catcher",), ("living", "craft"), ("flat",), ("brown",)),
    Category("tassel", tassel, (0.144, 0.0269, 0.0196), 0.01,
             ("curtain tassel", "macrame knot", "tassel charm", "silk tassel"),
             ("craft",), (), ("gold",)),
    Category("wind_chime", wind_chime, (0.0825, 0.264, 0.0121), 0.2,
             ("wind chimes", "windchime", "chime"), ("living",), ("flat",), ("silver",)),
)  # fmt: skip
"""The module's categories."""
