"""What goes with a bicycle: reflectors, pumps, lights, horns, tools."""

from __future__ import annotations

from ...build.category import Category
from ...build.making import DARK, at_box, drum, lies, plate, standing, steel
from ...build.outlines import ellipse, rectangle
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import join, lathe
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def reflector(look: Look) -> Shape:
    """A round or oblong reflector lying, its prisms showing."""
    color = look.color("red", "amber", "white", "orange")
    k = look.between(0.85, 1.2)
    rim = ellipse(0.07, 0.07, 28) if look.chance(0.5) else rectangle(0.085, 0.045, 0.012)
    back, lens = plate(rim, 0.011), plate(0.88 * rim, 0.004, at=(0, 0, 0.0095))
    grid = textures.grid(tint_color(color, 0.65), tint_color(color, 1.15), 9, 9, 96, 3)
    return put_down([(back, plain(DARK)), (lens, grid)], back, factor=k)


def bike_pump(look: Look) -> Shape:
    """A hand pump lying, with its handle drawn out a little."""
    color = look.color("silver", "black", "red", "blue", "yellow")
    k = look.between(0.85, 1.15)
    barrel = drum(0.0135, 0.17, (-0.09, 0, 0.0155), 0, sides=20)
    rod_ = drum(0.006, 0.05, (0.07, 0, 0.0155), 0, sides=12)
    grip = drum(0.0155, 0.07, (0.1, 0, 0.0155), 0, sides=18, bevel=0.004)
    ends = [drum(0.0155, 0.016, (x, 0, 0.0155), 0, sides=18) for x in (-0.1, 0.072)]
    head = [
        at_box(0.024, 0.034, 0.026, (-0.11, 0.006, 0.0)),
        drum(0.008, 0.014, (-0.11, 0.022, 0.0135), 1),
    ]
    return put_down([(barrel, look.surface(color, "steel" if look.chance(0.5) else "plastic")),
                     (rod_, steel(look)), (join([grip, *ends, *head]), plain(DARK))],
                    barrel, grip, head[0], factor=k, foot=0.3)  # fmt: skip


def bike_light(look: Look) -> Shape:
    """A bicycle lamp on its clamp."""
    color = look.color("black", "charcoal", "red", "silver", "white")
    k = look.between(0.85, 1.15)
    lamp = look.pick([(236, 240, 244), (210, 40, 40), (236, 240, 244)])
    body = drum(0.021, 0.062, (0, -0.03, 0.048), 1, top=0.017)
    ring = drum(0.024, 0.012, (0, -0.04, 0.048), 1, bevel=0.002)
    lens = ball(0.04, 0.012, 0.04, (0, -0.04, 0.048), 18)
    knob = drum(0.008, 0.004, (0, 0.0, 0.066))
    stem = at_box(0.024, 0.026, 0.02, (0, 0, 0.016))
    clamp = [at_box(0.044, 0.034, 0.012), at_box(0.034, 0.03, 0.01, (0, 0, 0.01))]
    paint = textures.speckles(look.rng, color, 4)
    return put_down(
        [
            (join([body, ring, stem]), paint),
            (lens, plain(lamp)),
            (knob, plain((220, 60, 50))),
            (join(clamp), plain(DARK)),
        ],
        clamp[0],
        stem,
        body,
        ring,
        factor=k,
    )


def bike_horn(look: Look) -> Shape:
    """A horn with a rubber bulb, lying."""
    color = look.color("gold", "silver", "red", "blue")
    k = look.between(0.85, 1.15)
    flare = [(0.007, 0.0), (0.008, 0.05), (0.014, 0.085), (0.027, 0.108), (0.04, 0.115)]
    inner = [(r - 0.002, z + 0.0004) for r, z in flare]
    bell = lies(lathe([(0, 0), *flare, *inner[::-1], (0, 0.002)], 24), -0.01, 0, 0.04)
    bulb = ball(0.07, 0.05, 0.05, (-0.045, 0, 0.0275), 18)
    neck = rod([(-0.02, 0, 0.03), (0.0, 0, 0.04)], 0.0085, 10)
    bracket = at_box(0.016, 0.02, 0.036, (0.01, 0, 0))
    return put_down([(join([bell, neck]), steel(look, color)), (bulb, plain((34, 34, 36))),
                     (bracket, steel(look))], bell, bulb, bracket, factor=k, foot=0.1)  # fmt: skip


def tyre_lever(look: Look) -> Shape:
    """A flat lever with a hooked tip, lying."""
    color = look.color("blue", "yellow", "red", "black", "orange", "green")
    k = look.between(0.85, 1.15)
    rim = [
        (-0.06, -0.009),
        (0.03, -0.007),
        (0.055, -0.005),
        (0.06, 0),
        (0.055, 0.005),
        (0.03, 0.007),
        (-0.06, 0.009),
        (-0.066, 0),
    ]
    body, tip = plate(rim, 0.006, bevel=0.001), at_box(0.008, 0.01, 0.009, (0.055, 0, 0))
    rib = at_box(0.07, 0.004, 0.008, (-0.02, 0, 0))
    return put_down(
        [(join([body, tip]), plain(color)), (rib, plain(tint_color(color, 0.8)))], body, factor=k
    )


def co2_cartridge(look: Look) -> Shape:
    """A small steel gas cartridge lying."""
    color = look.color("silver", "gray", "gold", "blue")
    k = look.between(0.85, 1.15)
    profile = [
        (0.004, 0),
        (0.0085, 0.003),
        (0.0095, 0.008),
        (0.0095, 0.062),
        (0.006, 0.074),
        (0.0042, 0.078),
        (0.0042, 0.087),
    ]
    body = lies(standing(*profile, sides=20), -0.043, 0, 0.0088)
    band = drum(0.0096, 0.018, (-0.02, 0, 0.0088), 0, sides=20)
    return put_down(
        [(body, steel(look, color)), (band, plain(look.own_color("red", "blue", "black")))],
        body,
        factor=k,
        foot=0.4,
    )


CATEGORIES = (
    Category("reflector", reflector, (0.0748, 0.061, 0.0134), 0.03,
             ("bike reflector", "wheel reflector", "bicycle reflector", "spoke reflector",
              "rear reflector"), ("workbench",), ("flat",), ("red",)),
    Category("bike_pump", bike_pump, (0.287, 0.0507, 0.0303), 0.2,
             ("bicycle pump", "mini pump", "tyre pump", "tire pump",
              "lilo pump", "cycle pump"), ("workbench", "sports"), (), ("silver",
             "black")),
    Category("bike_light", bike_light, (0.0486, 0.0788, 0.0728), 0.1,
             ("bicycle light", "bike lamp", "rear light", "front light", "cycle light",
             "tail light",
              "bicycle lamp"), ("workbench",), (), ("black",)),
    Category("bike_horn", bike_horn, (0.181, 0.0786, 0.0786), 0.15,
             ("bicycle horn", "bulb horn", "clown horn", "squeeze horn"), ("toys",), (), ("gold",)),
    Category("tyre_lever", tyre_lever, (0.131, 0.0186, 0.00932), 0.02,
             ("tire lever", "bike lever"), ("workbench",), ("flat",), ("blue", "yellow")),
    Category("co2_cartridge", co2_cartridge, (0.0833, 0.0184, 0.0176), 0.05,
             ("gas cartridge", "co2 canister", "soda charger", "cream charger", "gas capsule"),
             ("workbench",), (), ("silver",)),
)  # fmt: skip
"""The module's categories."""
