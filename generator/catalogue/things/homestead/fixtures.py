"""Fittings of a house: alarms, thermostats, bells, sockets, plugs, traps."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, DARK, STEEL_TONE, at_box, drum, plate, standing, steel
from ...build.recipes import put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import block, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def smoke_alarm(look: Look) -> Shape:
    """A smoke alarm lying: a round case with slots, a test button and a lamp."""
    color = look.color("white", "cream", "white", "gray")
    k = look.between(0.85, 1.15)
    base = drum(0.055, 0.008, sides=32)
    body = standing(
        (0.053, 0), (0.053, 0.016), (0.045, 0.027), (0.03, 0.03), at=(0, 0, 0.007), sides=32
    )
    slots = [
        at_box(0.012, 0.004, 0.012, (0.0505, 0, 0.011)).turn(2, n * np.pi / 12) for n in range(24)
    ]
    button = drum(0.012, 0.003, (0, 0, 0.036), bevel=0.001)
    grille = [torus(r, 0.0012, 26, 5).move(z=0.0365) for r in (0.018, 0.024)]
    lamp = drum(0.0025, 0.002, (0.022, 0.022, 0.034))
    return put_down(
        [
            (join([base, body]), plain(color)),
            (join(slots), plain((70, 72, 76))),
            (join([button, *grille]), plain(tint_color(color, 0.85))),
            (lamp, plain((230, 40, 40))),
        ],
        base,
        body,
        factor=k,
    )


def thermostat(look: Look) -> Shape:
    """A round thermostat lying, its dial lit."""
    color = look.color("silver", "white", "black", "copper")
    k = look.between(0.85, 1.15)
    ring = drum(0.042, 0.026, sides=36, bevel=0.003)
    face = drum(0.036, 0.0012, (0, 0, 0.0255), sides=36)
    tone = look.pick([(40, 44, 50), (230, 120, 40), (40, 100, 180)])
    image = prints.canvas(128, 128, tone)
    for n in range(22):
        a = 0.75 * np.pi + n * 1.5 * np.pi / 21
        ends = [(0.5 + r * np.cos(a), 0.5 + r * np.sin(a)) for r in (0.4, 0.47)]
        prints.stroke(image, ends, 0.014, (250, 250, 250) if n < 13 else tint_color(tone, 1.4))
    prints.write(
        image, str(int(look.rng.integers(17, 25))), 0.5, 0.5, 0.3, (250, 250, 250), bold=True
    )
    return put_down([(ring, look.surface(color, "metal")), (face, image)], ring, factor=k)


def doorbell(look: Look) -> Shape:
    """A doorbell lying: an oblong plate with a lit push button."""
    color = look.color("white", "black", "gold", "silver")
    k = look.between(0.85, 1.2)
    slab = block(0.036, 0.085, 0.014, 0.012, 0.003)
    ring = torus(0.0105, 0.002, 24, 6).move(0, -0.012, 0.0142)
    button = drum(0.0095, 0.004, (0, -0.012, 0.013), bevel=0.001)
    slot = [at_box(0.016, 0.002, 0.0008, (0, 0.016 + 0.005 * n, 0.0135)) for n in range(4)]
    return put_down(
        [
            (slab, look.surface(color, "plastic")),
            (ring, steel(look)),
            (button, plain(look.pick([(120, 190, 240), (250, 244, 220), (240, 170, 60)]))),
            (join(slot), plain((90, 92, 98))),
        ],
        slab,
        factor=k,
    )


def wall_socket(look: Look) -> Shape:
    """A wall socket lying on its back, with a switch."""
    color = look.color("white", "silver", "cream", "black")
    k = look.between(0.9, 1.1)
    box_ = at_box(0.07, 0.07, 0.022)
    slab = block(0.086, 0.086, 0.009, 0.004, 0.002).move(z=0.021)
    if look.chance(0.5):
        holes = [at_box(0.004, 0.009, 0.0008, (0, 0.006, 0.0296))]
        holes += [at_box(0.0075, 0.0035, 0.0008, (s * 0.011, -0.014, 0.0296)) for s in (-1, 1)]
    else:
        holes = [drum(0.0195, 0.0006, (0, -0.002, 0.0296), sides=28)]
    extra = [drum(0.0026, 0.0012, (s * 0.0095, -0.002, 0.0298)) for s in (-1, 1)]
    screws = [drum(0.0032, 0.001, (s * 0.033, -0.002, 0.0294)) for s in (-1, 1)]
    rock = (
        at_box(0.012, 0.018, 0.004, (0.024, 0.028, 0.029))
        if look.chance(0.7)
        else at_box(0.01, 0.01, 0.001, (0, 0.03, 0.0294))
    )
    return put_down(
        [
            (join([box_, slab, rock]), plain(color)),
            (join(holes), plain((74, 76, 82))),
            (join(extra), plain((30, 30, 34))),
            (join(screws), steel(look)),
        ],
        box_,
        slab,
        factor=k,
    )


def mains_plug(look: Look) -> Shape:
    """A mains plug lying with a piece of its cord."""
    color = look.color("black", "white", "gray", "red")
    k = look.between(0.9, 1.15)
    body = block(0.046, 0.05, 0.026, 0.012, 0.005)
    pins = [
        at_box(0.004, 0.022, 0.008, (0, 0.034, 0.009)),
        *[at_box(0.007, 0.02, 0.004, (s * 0.011, 0.033, 0.011)) for s in (-1, 1)],
    ]
    if look.chance(0.5):
        pins = [drum(0.0024, 0.022, (s * 0.0095, 0.024, 0.013), 1, sides=12) for s in (-1, 1)]
    relief = drum(0.007, 0.02, (0, -0.042, 0.012), 1, top=0.008, sides=14)
    cord = rod(
        [
            (0, -0.038, 0.012),
            (0.004, -0.065, 0.006),
            (0.03, -0.085, 0.0035),
            (0.065, -0.07, 0.0035),
        ],
        0.0034,
        8,
    )
    return put_down(
        [
            (join([body, relief, cord]), plain(color)),
            (join(pins), steel(look, look.pick([STEEL_TONE, BRASS_TONE]))),
        ],
        body,
        join(pins),
        cord,
        factor=k,
    )


def mouse_trap(look: Look) -> Shape:
    """A spring mousetrap, set, with a bit of cheese on it."""
    color = look.color("tan", "wooden", "beige")
    k = look.between(0.85, 1.25)
    base = at_box(0.1, 0.048, 0.008)
    hoop = rod(
        [
            (0.002, 0.019, 0.0105),
            (0.042, 0.019, 0.0105),
            (0.042, -0.019, 0.0105),
            (0.002, -0.019, 0.0105),
        ],
        0.0014,
        6,
        1,
    )
    coil = drum(0.0042, 0.04, (0.0, -0.02, 0.0115), 1, sides=12)
    pin = straight((-0.046, 0, 0.0105), (0.036, 0.004, 0.0125), 0.001, 6)
    pad_, cheese = (
        at_box(0.018, 0.016, 0.0014, (-0.022, 0, 0.009)),
        plate([(-0.008, -0.005), (0.008, -0.002), (-0.005, 0.007)], 0.008),
    )
    print_ = prints.canvas(96, 48, color)
    prints.write(
        print_, look.pick(["SNAP", "TRAP", "MOUSE"]), 0.75, 0.5, 0.24, (180, 40, 40), bold=True
    )
    return put_down(
        [
            (base, textures.wood(look.rng, color)),
            (at_box(0.098, 0.046, 0.0006, (0, 0, 0.0077)), print_),
            (join([hoop, coil, pin]), steel(look)),
            (pad_, steel(look, (190, 150, 80))),
            (cheese.move(-0.022, 0, 0.0102), plain((244, 206, 70))),
        ],
        base,
        hoop,
        factor=k,
    )


def extinguisher(look: Look) -> Shape:
    """A small fire extinguisher standing, with its lever and hose."""
    color = look.color("red", "red", "crimson", "orange")
    k = look.between(0.75, 0.95)
    body = standing(
        (0.045, 0),
        (0.05, 0.004),
        (0.05, 0.2),
        (0.042, 0.225),
        (0.018, 0.24),
        (0.015, 0.25),
        sides=28,
    )
    label = lathe([(0.0495, 0.07), (0.0506, 0.072), (0.0506, 0.16), (0.0495, 0.162)], 28, loop=True)
    image = prints.canvas(224, 80, (244, 240, 226))
    prints.write(image, "FIRE", 0.5, 0.3, 0.34, (190, 30, 30), bold=True)
    prints.lines(image, look.rng, (0.38, 0.55, 0.24, 0.35), 4, (60, 60, 64), 0.5)
    valve = [
        drum(0.014, 0.02, (0, 0, 0.248)),
        at_box(0.07, 0.016, 0.006, (0.02, 0, 0.27)),
        at_box(0.07, 0.016, 0.005, (0.024, 0, 0.284)),
    ]
    gauge = drum(0.012, 0.006, (0, -0.018, 0.262), 1)
    hose = rod(
        [(-0.012, 0, 0.26), (-0.06, 0, 0.25), (-0.066, 0, 0.16), (-0.062, 0, 0.1)], 0.0065, 10
    )
    return put_down(
        [
            (body, plain(color)),
            (label, image),
            (join([*valve[:1], gauge]), steel(look)),
            (join([*valve[1:], hose]), plain(DARK)),
        ],
        body,
        join(valve),
        hose,
        factor=k,
    )


CATEGORIES = (
    Category("smoke_alarm", smoke_alarm, (0.112, 0.112, 0.0388), 0.15, ("smoke detector",
             "fire alarm", "carbon monoxide alarm", "co alarm"),
             ("living",), ("round",), ("white",)),
    Category("thermostat", thermostat, (0.0872, 0.0872, 0.0277), 0.15, ("thermostat dial",
             "room thermostat"), ("living",), ("round",),
             ("silver", "white")),
    Category("doorbell", doorbell, (0.0344, 0.0812, 0.0162), 0.06, ("door bell", "bell push",
             "video doorbell"), ("living",), (), ("white", "black")),
    Category("wall_socket", wall_socket, (0.0865, 0.0865, 0.0324), 0.12, ("plug socket",
             "power outlet", "electrical outlet", "outlet", "wall outlet",
             "electric socket", "socket"), ("workbench",), (), ("white",)),
    Category("mains_plug", mains_plug, (0.09, 0.134, 0.0261), 0.07, ("electric plug",
             "three-pin plug"), ("workbench",), (),
             ("black", "white")),
    Category("mouse_trap", mouse_trap, (0.105, 0.0502, 0.019), 0.03, ("mousetrap", "rat trap",
             "spring trap"), ("living",), ("flat",), ("tan",)),
    Category("fire_extinguisher", extinguisher, (0.112, 0.086, 0.246), 1.2, ("extinguisher",
             "mini fire extinguisher"), ("workbench",), ("tall",), ("red",)),
)  # fmt: skip
"""The module's categories."""
