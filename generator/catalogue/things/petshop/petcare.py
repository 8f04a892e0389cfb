"""Things for pets: carriers, beds, wheels, posts, pads, perches."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part, ring_parts
from ...build.forms import above, facing
from ...build.outlines import rectangle, smooth
from ...build.settled import settle
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    torus,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (190, 194, 200)


def pet_carrier(look: Look) -> Shape:
    """A pet carrier: a plastic shell with slits, a barred door in front, a handle on top."""
    k, color = look.between(0.9, 1.1), look.color("gray", "beige", "blue", "pink", "teal")
    x, y, h = 0.24 * k, 0.34 * k, 0.22 * k
    low = block(x, y, 0.5 * h, 0.04 * k, 0.008)
    rings = [(1.0, 0.5), (1.0, 0.7), (0.94, 0.88), (0.8, 0.99), (0.7, 1.0)]

    outline = rectangle(0.97 * x, 0.97 * y, 0.04 * k)
    top = loft(
        np.stack([np.column_stack([outline * s, np.full(len(outline), z * h)]) for s, z in rings]),
        outline,
    )
    rim = block(1.03 * x, 1.02 * y, 0.05 * h, 0.04 * k).move(z=0.48 * h)
    door = facing(prism(rectangle(0.62 * x, 0.62 * h, 0.02 * k), 0, 0.004)).move(
        y=-0.497 * y, z=0.47 * h
    )
    bars = [
        box(0.004, 0.004, 0.58 * h).move(i * 0.06 * x, -0.51 * y, 0.18 * h) for i in range(-5, 6)
    ]
    bars += [box(0.62 * x, 0.004, 0.004).move(y=-0.51 * y, z=z * h) for z in (0.2, 0.47, 0.74)]
    slits = [box(0.002, 0.05 * k, 0.01 * k).move(s * 0.486 * x, j * 0.075 * k,
                                                 (0.58 + 0.09 * i) * h)
             for s in (-1, 1) for j in (-1, 0, 1) for i in range(2)]  # fmt: skip
    grip = tube(
        smooth(
            [
                (0, -0.07 * k, 0.98 * h),
                (0, -0.06 * k, 1.1 * h),
                (0, 0.06 * k, 1.1 * h),
                (0, 0.07 * k, 0.98 * h),
            ],
            4,
        ),
        0.008 * k,
        8,
    )
    pale, deep = (
        textures.speckles(look.rng, tint_color(color, 1.35), 4),
        textures.speckles(look.rng, color, 4),
    )
    dark = textures.plain((40, 42, 46))
    return shape([(low, deep), (top, pale), (rim, deep), (door, dark), (join(slits), dark),
                  (join(bars), textures.plain(STEEL)), (grip, deep)],
                 [hull_of(low, rim), hull_of(top), hull_of(grip), hull_of(*bars)])  # fmt: skip


def pet_bed(look: Look) -> Shape:
    """A round or oval pet bed: a thick soft rim round a cushion, lower in front."""
    k, color = (
        look.between(0.85, 1.05),
        look.color("gray", "beige", "brown", "blue", "pink", "teal"),
    )
    r, t, wide = 0.15 * k, 0.042 * k, look.between(1.0, 1.2)
    rim = torus(r - t, t, 40, 12).move(z=0.9 * t)
    rim = rim.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] * (1 + 0.28 * p[:, 1] / r)])).scale(
        wide, 1, 1
    )
    bed = ellipsoid(2 * (r - t), 2 * (r - t), 0.05 * k, 28, 10).move(z=0.024 * k).scale(wide, 1, 1)
    outside = textures.fabric(look.rng, color)
    soft = textures.scratches(look.rng, tint_color(color, 1.5), tint_color(color, 1.3), 200)
    inner = [(r - 2 * t, 1.4 * t), (r - 2 * t, 0.3 * t)]
    wall = ring_parts(
        [(r - 0.6 * t, 0), (0.98 * r, 0.3 * t), (0.98 * r, 1.4 * t)], inner, 14, stretch=(wide, 1.0)
    )
    return shape([(rim, outside), (bed, soft)], [*wall, hull_part(above(bed.vertices))])


def hamster_wheel(look: Look) -> Shape:
    """A running wheel: a ribbed drum between two rims on an upright stand."""
    k, color = (
        look.between(0.85, 1.1),
        look.color("blue", "pink", "green", "yellow", "purple", "orange"),
    )
    r, w = 0.07 * k, 0.05 * k
    z = r + 0.016
    drum = lathe([(0.94 * r, 0), (r, 0), (r, w), (0.94 * r, w)], 36, loop=True)
    back = cylinder(0.98 * r, 0.003, 36)
    spokes = [box(1.9 * r, 0.008, 0.004).turn(2, a).move(z=0.003) for a in np.pi / 3 * np.arange(3)]
    rungs = [
        box(0.006, 0.01, w).move(x=0.95 * r).turn(2, a) for a in 2 * np.pi * np.arange(18) / 18
    ]
    wheel = [facing(s).move(y=w / 2, z=z) for s in (drum, back, *spokes)]
    bars = [facing(s).move(y=w / 2, z=z) for s in rungs]
    axle = facing(cylinder(0.007, 0.02, 14)).move(y=w / 2 + 0.014, z=z)
    leg = prism(
        np.array([(-0.055, 0), (0.055, 0), (0.008, 1), (-0.008, 1)]) * [k, z + 0.008], 0, 0.008
    ).turn(0, np.pi / 2)
    leg = leg.move(y=w / 2 + 0.016)
    foot = block(0.12 * k, w + 0.06, 0.006, 0.01).move(y=0.008)
    tile, other = (
        textures.speckles(look.rng, color, 4),
        textures.plain(look.own_color("white", "yellow", "gray")),
    )
    return shape([(join(wheel), tile), (join(bars), textures.plain(tint_color(color, 0.75))),
                  (join([axle, leg, foot]), other)],
                 [hull_of(foot), hull_of(leg), hull_of(wheel[0])])  # fmt: skip


def scratching_post(look: Look) -> Shape:
    """A scratching post: a sisal-wound post on a plush base, a plush top, a hanging ball."""
    k, color = look.between(0.85, 1.05), look.color("beige", "gray", "brown", "cream", "pink")
    r, h, side = 0.028 * k, 0.3 * k, 0.2 * k
    base, top = (
        block(side, side, 0.022, 0.02, 0.004),
        block(0.12 * k, 0.12 * k, 0.02, 0.02, 0.004).move(z=h),
    )
    post = cylinder(r, h - 0.015, 24).move(z=0.018)
    cord = tube([(0.045 * k, -0.03 * k, h), (0.046 * k, -0.031 * k, h - 0.07 * k)], 0.001, 5)
    ball = ellipsoid(0.03 * k, 0.03 * k, 0.03 * k, 14, 9).move(0.046 * k, -0.031 * k, h - 0.08 * k)
    plush = textures.scratches(look.rng, color, tint_color(color, 0.85), 220)
    sisal = textures.stripes([(206, 178, 128), (186, 156, 104)], 20, side=120)
    return shape([(join([base, top]), plush), (post, sisal),
                  (cord, textures.plain((240, 238, 233))),
                  (ball, textures.plain(look.own_color("red", "blue", "white")))],
                 [hull_of(base), hull_of(post), hull_of(top)])  # fmt: skip


def muzzle(look: Look) -> Shape:
    """A dog's basket muzzle: bars round a snout, a strap behind, standing on its rim."""
    k, color = look.between(0.85, 1.15), look.color("black", "brown", "tan", "red")
    hoops = [torus(r, 0.0026, 26, 6).scale(1, 1.2, 1).move(z=z) for r, z in
             ((0.05, 0.003), (0.049, 0.03), (0.045, 0.058), (0.032, 0.084))]  # fmt: skip
    bars = [tube(smooth([(0.05 * np.cos(a), 0.06 * np.sin(a), 0.003), (0.049 * np.cos(a),
        0.059 * np.sin(a), 0.03),
                         (0.045 * np.cos(a), 0.054 * np.sin(a), 0.058),
                         (0.03 * np.cos(a), 0.036 * np.sin(a), 0.086),
                         (0, 0, 0.093)], 3), 0.0024,
                         6) for a in 2 * np.pi * np.arange(10) / 10]  # fmt: skip
    strap = (
        lathe([(0.062, 0), (0.0645, 0), (0.0645, 0.014), (0.062, 0.014)], 28, loop=True)
        .scale(1, 1.25, 1)
        .move(y=0.075)
    )
    tile = look.surface(color, "plastic")
    return settle(
        [(join([*hoops, *bars]), tile), (strap, textures.plain(tint_color(color, 0.7)))],
        0.0,
        hulls=[[0], [1]],
    ).scale(k)


def puppy_pad(look: Look) -> Shape:
    """A puppy pad lying folded: white quilted layers with a coloured edge."""
    x, y, t = look.between(0.2, 0.24), look.between(0.15, 0.18), look.between(0.01, 0.02)
    color = look.color("blue", "sky", "pink", "green")
    image = textures.fit(textures.grid((222, 226, 230), (250, 250, 250), 9, 12), 128, 176).copy()
    for a, b, w, h in ((0, 0, 1, 0.06), (0, 0.94, 1, 0.06), (0, 0, 0.045, 1), (0.955, 0, 0.045, 1)):
        prints.fill(image, a, b, w, h, color)
    layers = [
        block(x - 0.004 * n, y - 0.003 * n, t / 4, 0.01, 0.0005).move(0, 0.001 * n, n * t / 4)
        for n in range(4)
    ]
    return shape([(join(layers), textures.plain(tint_color(color, 1.2))),
                  (box(0.93 * x, 0.92 * y, 0.0006).move(y=0.003, z=t - 0.0002), image)],
                 [box_part(x, y, t)])  # fmt: skip


def bird_perch(look: Look) -> Shape:
    """A bird's stand: a wooden bar on a post with two cups, on a tray."""
    k, color = look.between(0.85, 1.1), look.color("wooden", "brown", "tan")
    tray = block(0.18 * k, 0.13 * k, 0.012, 0.02, 0.002)
    post = cylinder(0.009 * k, 0.19 * k, 14).move(z=0.01)
    bar = tube([(-0.11 * k, 0, 0.2 * k), (0.11 * k, 0, 0.2 * k)], 0.01 * k, 12)
    cups = [lathe([(0, 0), (0.018, 0), (0.022, 0.026), (0.02, 0.026), (0.017, 0.003), (0, 0.003)],
                  18).move(s * 0.085 * k, 0, 0.205 * k)
            for s in (-1, 1)]  # fmt: skip
    wood = look.surface(color, "wood")
    return shape([(join([tray, post, bar]), wood),
                  (join(cups), textures.brushed_metal(look.rng, STEEL))],
                 [hull_of(tray), hull_of(post), hull_of(bar),
                  *[hull_of(c) for c in cups]])  # fmt: skip


_P = ("living",)

CATEGORIES = (
    Category("pet_carrier", pet_carrier, (0.248, 0.349, 0.254), 1.4, ("cat carrier", "dog carrier",
        "pet crate", "dog crate", "cat crate",
             "animal carrier", "pet cage"), _P, ("big",), ("gray",)),
    Category("pet_bed", pet_bed, (0.312, 0.281, 0.0897), 0.5, ("dog bed", "cat bed", "puppy bed",
        "pet basket", "dog basket", "cat basket"), _P,
             ("container", "big"), ("gray",)),
    Category("hamster_wheel", hamster_wheel, (0.134, 0.108, 0.15), 0.15,
             ("running wheel", "exercise wheel", "pet wheel"), _P, (), ("blue",)),
    Category("scratching_post", scratching_post, (0.189, 0.189, 0.303), 1.2,
             ("cat scratching post", "scratch post", "cat tree",
             "cat post", "cat scratcher"), _P, ("tall",), ("beige",)),
    Category("muzzle", muzzle, (0.132, 0.225, 0.0979), 0.12, ("dog muzzle", "basket muzzle"), _P,
             (), ("black",)),
    Category("puppy_pad", puppy_pad, (0.219, 0.168, 0.0169), 0.08, ("puppy training pad",
        "pee pad", "training pad", "pet pad"), _P, ("flat",), ("blue",),
             state="lying folded"),
    Category("bird_perch", bird_perch, (0.223, 0.132, 0.234), 0.5, ("bird stand",
        "parrot stand", "parrot perch"), _P, ("tall",),
             ("wooden",)),
)  # fmt: skip
"""The module's categories."""
