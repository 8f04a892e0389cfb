"""Tools of a workbench."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, prism, sweep, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GRIPS = ("red", "yellow", "blue", "orange", "green", "black", "teal", "gray", "lime", "violet")


def steel(look: Look) -> textures.Tile:
    """Return bare tool steel."""
    return textures.brushed_metal(look.rng, (170, 174, 180))


def lying(solid: Solid, x: float = 0.0, z: float = 0.0) -> Solid:
    """Return a solid that stands on z = 0 laid down along +x from ``x`` at height ``z``."""
    return solid.turn(1, np.pi / 2).move(x=x, z=z)


def screwdriver(look: Look) -> Shape:
    """A screwdriver lying: fluted grip, shaft, flat tip."""
    r, grip, shaft = look.between(0.013, 0.016), look.between(0.09, 0.105), look.between(0.09, 0.12)
    color = look.color(*GRIPS)
    flutes = textures.stripes([color, color, look.pick([tint_color(color, 0.6), (40, 40, 44)])], 6,
                              upright=True)  # fmt: skip
    if look.chance(0.3):
        flutes = textures.stack((textures.plain((40, 40, 44)), 1), (flutes, 3), (flutes, 1))
    handle = lathe(
        [(0, 0), (0.7 * r, 0), (r, 0.008), (r, 0.55 * grip), (0.72 * r, 0.75 * grip),
         (0.85 * r, 0.9 * grip), (0.55 * r, grip), (0, grip)],
        20,
    )  # fmt: skip
    start = -(grip + shaft) / 2
    rod = lying(cylinder(0.0035, shaft, 12), start + grip, r)
    tip = box(0.012, 0.008, 0.0018).move(start + grip + shaft - 0.006, 0, r - 0.0009)
    keel = box(0.6 * grip, 1.3 * r, 0.3 * r).move(x=start + 0.32 * grip)
    return shape(
        [(lying(handle, start, r), flutes), (rod, steel(look)), (tip, steel(look)),
         (keel, textures.plain(tint_color(color, 0.8)))],
        [box_part(0.62 * grip, 1.5 * r, 1.8 * r, (start + 0.33 * grip, 0, 0)),
         box_part(0.36 * grip, 1.3 * r, 1.4 * r, (start + 0.82 * grip, 0, 0.25 * r)),
         box_part(shaft, 0.007, 0.007, (start + grip + shaft / 2, 0, r - 0.0035))],
    )  # fmt: skip


def hammer(look: Look) -> Shape:
    """A claw hammer lying on its side."""
    paint = look.color(
        "wooden", "wooden", "tan", "red", "blue", "black", "yellow", "orange", "green"
    )
    wood = look.surface(paint, look.pick(["oak", "plastic"]))
    if look.chance(0.4):  # a grip of rubber
        rubber = textures.plain(look.own_color("black", "charcoal", "yellow", "blue"))
        wood = np.concatenate([textures.fit(rubber, 64, 26), textures.fit(wood, 64, 38)], 1)
    metal = textures.brushed_metal(look.rng, look.own_color("charcoal", "gray", "silver"))
    length = look.between(0.24, 0.33)
    handle = prism(
        [(-length / 2, -0.014), (-0.02, -0.011), (length / 2, -0.011), (length / 2, 0.011),
         (-0.02, 0.011), (-length / 2, 0.014)],
        0.002, 0.024, 0.004,
    )  # fmt: skip
    head = block(0.03, 0.075, 0.026, 0.004, 0.002).move(x=length / 2, y=-0.004)
    face = (
        cylinder(0.0135, 0.022, 18, bevel=0.002).turn(0, np.pi / 2).move(length / 2, -0.032, 0.0135)
    )
    claw = sweep(
        [(length / 2, 0.03, 0.013), (length / 2 - 0.006, 0.055, 0.013),
         (length / 2 - 0.02, 0.074, 0.013)],
        rectangle(0.022, 0.01, 0.002, 2), [1.0, 0.85, 0.45],
    )  # fmt: skip
    return shape(
        [(handle, wood), (head, metal), (face, metal), (claw, metal)],
        [box_part(length, 0.024, 0.024), box_part(0.03, 0.075, 0.026, (length / 2, -0.004, 0)),
         box_part(0.024, 0.022, 0.026, (length / 2, -0.043, 0)), hull_of(claw)],
    )  # fmt: skip


def wrench(look: Look) -> Shape:
    """A combination wrench lying flat: ring at one end, open jaw at the other."""
    hue = look.color("silver", "gray", "charcoal", "bronze", "red", "blue", spread=10)
    metal, length = textures.brushed_metal(look.rng, hue), look.between(0.14, 0.22)
    if look.chance(0.4):
        metal = textures.spots(look.rng, hue, (128, 84, 56), look.between(0.03, 0.14))
    shaft = prism(
        [(-length / 2 + 0.02, -0.006), (length / 2 - 0.02, -0.007), (length / 2 - 0.02, 0.007),
         (-length / 2 + 0.02, 0.006)],
        0.001, 0.0065, 0.001,
    )  # fmt: skip
    ring = torus(0.0125, 0.0042, 24, 8).scale(1, 1, 1.1).move(-length / 2 + 0.012, 0, 0.0046)
    x = length / 2 - 0.004
    jaw = [
        prism([(x - 0.024, 0.0), (x - 0.012, s * 0.005), (x + 0.014, s * 0.007),
               (x + 0.01, s * 0.017), (x - 0.012, s * 0.018)][:: s], 0, 0.008)
        for s in (-1, 1)
    ]  # fmt: skip
    return shape(
        [(shaft, metal), (ring, metal), (join(jaw), metal)],
        [box_part(length - 0.04, 0.013, 0.0065),
         cylinder_part(0.0166, 0.0088, (-length / 2 + 0.012, 0, 0)), *[hull_of(j) for j in jaw]],
    )  # fmt: skip


def pliers(look: Look) -> Shape:
    """Pliers lying flat with coloured grips."""
    grip = textures.speckles(look.rng, look.color(*GRIPS), 5)
    metal = textures.brushed_metal(
        look.rng, look.pick([(120, 124, 130), (70, 72, 76), (176, 178, 182)])
    )
    reach, gape = look.between(0.045, 0.075), look.between(0.85, 1.15)
    handles = [
        tube([(0.0, s * 0.005, 0.007), (-0.035, s * 0.02 * gape, 0.007),
              (-0.1, s * 0.026 * gape, 0.007)],
             [0.0055, 0.007, 0.0065], 10)
        for s in (-1, 1)
    ]  # fmt: skip
    jaws = [
        prism([(0.0, 0.0), (reach, s * 0.0006), (reach, s * 0.005), (0.02, s * 0.011),
               (-0.004, s * 0.011)][::s], 0.001, 0.013)
        for s in (-1, 1)
    ]  # fmt: skip
    pivot = cylinder(0.009, 0.0155, 18, bevel=0.001).move(x=0.006)
    return shape(
        [(join(handles), grip), (join(jaws), metal), (pivot, steel(look))],
        [*[hull_of(h) for h in handles], box_part(reach, 0.018, 0.013, (reach / 2, 0, 0.0005))],
    )


def tape_measure(look: Look) -> Shape:
    """A tape measure standing on its base with a bit of blade out."""
    side = look.between(0.062, 0.072)
    color = look.color("yellow", "orange", "red", "blue", "black", "silver", "lime", "white")
    word, ink = (
        look.pick(["5m", "3m", "8m", "PRO", "25ft"]),
        look.pick([(40, 40, 44), (236, 236, 232)]),
    )
    case = textures.speckles(look.rng, color, 4)
    face = prints.canvas(96, 96, color)
    if look.chance(0.5):
        prints.disc(face, 0.5, 0.5, 0.36, ink)
        prints.disc(face, 0.5, 0.5, 0.3, tint_color(color, 1.15))
        prints.write(face, word, 0.5, 0.5, 0.22, tint_color(color, 0.2), bold=True)
    else:
        prints.fill(face, 0, 0.3, 1, 0.4, ink)
        prints.write(face, word, 0.5, 0.5, 0.24, color, bold=True)
    body = (
        prism(rectangle(side, side, 0.02), 0, 0.036, 0.003)
        .turn(0, np.pi / 2)
        .move(y=0.018, z=side / 2)
    )
    badge = box(0.8 * side, 0.001, 0.8 * side).move(y=-0.0183, z=0.1 * side)
    blade = box(0.04, 0.02, 0.0014).move(x=side / 2 + 0.016, z=0.003)
    return shape(
        [
            (body, case),
            (badge, face),
            (
                blade,
                textures.stripes(
                    [look.pick([(244, 214, 70), (240, 240, 236)]), (40, 40, 40)], 8, upright=True
                ),
            ),
        ],
        [box_part(side, 0.036, side), box_part(0.036, 0.02, 0.0014, (side / 2 + 0.018, 0, 0.003))],
    )


def utility_knife(look: Look) -> Shape:
    """A box cutter lying flat with its blade out."""
    color = look.color("yellow", "red", "orange", "blue", "black", "lime", "teal", "silver")
    body = prism(
        [(-0.075, -0.011), (0.045, -0.013), (0.062, -0.006), (0.062, 0.006), (-0.07, 0.013)],
        0, 0.014, 0.003,
    )  # fmt: skip
    slider = block(0.018, 0.009, 0.004, 0.002).move(x=0.01, z=0.0135)
    blade = prism(
        [(0.058, -0.004), (0.088, -0.004), (0.078, 0.0045), (0.058, 0.0045)], 0.006, 0.008
    )
    return shape(
        [(body, textures.speckles(look.rng, color, 5)), (slider, textures.plain((44, 44, 48))),
         (blade, steel(look))],
        [hull_of(body), hull_of(blade)],
    )  # fmt: skip


CATEGORIES = (
    Category(
        "screwdriver",
        screwdriver,
        (0.2, 0.03, 0.03),
        0.1,
        (
            "driver",
            "nut driver",
            "disgorger",
            "awl tool",
            "sim tray tool",
            "clay sculpting tool",
            "loop tool",
            "hook remover",
            "drill brace",
            "watchmaker screwdriver",
            "spring bar tool",
            "case opener",
        ),
        ("workbench", "craft"),
        (),
        GRIPS,
        state="lying flat",
    ),
    Category(
        "hammer",
        hammer,
        (0.295, 0.127, 0.027),
        0.55,
        (
            "claw hammer",
            "ball-peen hammer",
            "sledgehammer",
            "lump hammer",
            "geologist hammer",
            "rock hammer",
            "jeweller hammer",
        ),
        ("workbench",),
        (),
        ("wooden", "red"),
        state="lying flat",
    ),
    Category(
        "wrench",
        wrench,
        (0.195, 0.036, 0.009),
        0.21,
        (
            "spanner",
            "chain tool",
            "chain breaker",
            "spoke key",
        ),
        ("workbench",),
        ("flat",),
        ("silver",),
        state="lying flat",
    ),
    Category(
        "pliers",
        pliers,
        (0.166, 0.066, 0.0155),
        0.2,
        (
            "plier",
            "pincers",
            "mole grips",
            "tongue-and-groove pliers",
            "rivet gun",
            "tile nipper",
            "eyelet pliers",
            "vise grips",
            "locking pliers",
            "mole grip",
            "hole punch pliers",
            "extraction forceps",
            "dental forceps",
        ),
        ("workbench", "craft"),
        (),
        GRIPS,
        state="lying flat",
    ),
    Category(
        "tape_measure",
        tape_measure,
        (0.1, 0.037, 0.067),
        0.2,
        ("measuring tape",),
        ("workbench",),
        (),
        ("yellow",),
    ),
    Category(
        "utility_knife",
        utility_knife,
        (0.163, 0.026, 0.0175),
        0.08,
        ("box cutter", "craft knife", "cutter", "glass cutter", "stanley knife", "die cutter"),
        ("workbench", "craft"),
        ("flat",),
        ("yellow", "red"),
        state="lying flat",
    ),
)
