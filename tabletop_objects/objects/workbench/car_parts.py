"""Objects of the ``workbench`` theme: car parts."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import cloth, dye, metal, plastic, shine
from ...kit.parts import ring_parts
from ...kit.primitives import at_block, at_box, ball, disc, plate, rod, spindle, standing
from ...kit.prints import word_plate
from ...kit.shapes import Pieces, Shape, at_rest, category, from_pieces, shape
from ...kit.solids import join, lathe, torus, tube
from ...kit.surfaces import Look

BLACK = surfaces.plain((34, 34, 37))


@category("steering_wheel", size=(0.353, 0.353, 0.0377), mass=1.5, material="plastic",
          assembled=True, aliases=("car steering wheel", "toy steering wheel"),
          themes=("workbench",), roles=("flat", "big"), colors=("black",))  # fmt: skip
@from_pieces(foot=0.0)
def steering_wheel(look: Look) -> Pieces:
    """A steering wheel lying flat: a rim, three spokes and a hub with a horn pad."""
    rim = torus(0.17, 0.014, 44, 10).move(z=0.03)
    spokes = [
        at_box(0.15, 0.035, 0.012, (0.085, 0, 0.022)).turn(2, a) for a in (0, np.pi, -np.pi / 2)
    ]
    hub = [disc(0.052, 0.035, (0, 0, 0.004)), disc(0.03, 0.006, (0, 0, 0.037))]
    return [(rim, plastic(look, "black", "brown", "charcoal", "tan")), *((s, dye(look, "charcoal",
             "silver")) for s in spokes),
            (hub[0], dye(look, "black")), (hub[1], shine(look))]  # fmt: skip


@category("hubcap", size=(0.34, 0.34, 0.032), mass=0.5, material="metal", hollow=True,
          aliases=("hub cap", "wheel trim", "alloy wheel"), themes=("workbench",),
          roles=("flat", "big"), colors=("silver",))  # fmt: skip
@from_pieces(bodies=1)
def hubcap(look: Look) -> Pieces:
    """A hubcap lying flat: a domed metal cover with eight dark oval slots around a badge."""
    steel = metal(look, "silver", "silver", "gray", "black")
    face = standing((0.165, 0), (0.17, 0.004), (0.165, 0.016), (0.13, 0.022), (0.05, 0.026),
                    (0.03, 0.03), sides=40)  # fmt: skip
    slots = [disc(0.018, 0.002, sides=14).scale(1.5, 1, 1).move(0.11, 0, 0.022).turn(2, a)
             for a in np.arange(8) * np.pi / 4]  # fmt: skip
    badge = disc(0.026, 0.003, (0, 0, 0.029))
    return [(face, steel), (join(slots), BLACK), (badge, dye(look, "blue", "red", "black"))]


@category("headlight", size=(0.17, 0.168, 0.173), mass=0.6, material="glass",
          aliases=("car headlight", "fog light"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@at_rest
@from_pieces(bodies=3)
def headlight(look: Look) -> Pieces:
    """A round headlight standing on its rim: a chrome ring and ribbed glass."""
    bowl = lathe(
        [(0, 0), (0.02, 0), (0.03, 0.012), (0.07, 0.05), (0.08, 0.07), (0.08, 0.08), (0, 0.08)], 32
    )
    lens = ball(0.15, 0.15, 0.036, (0, 0, 0.08), 28)
    ring = torus(0.08, 0.006, 36, 8).move(z=0.078)
    turn = np.pi / 2 - 0.12
    solids = [s.turn(0, turn) for s in (bowl, ring, lens)]
    low = min(float(s.bounds[0, 2]) for s in solids)
    foot = at_box(0.07, 0.08, 0.012, (0, 0.03, 0))
    bowl, ring, lens = (s.move(z=-low + 0.004) for s in solids)
    image = surfaces.stripes([(236, 242, 246), (206, 216, 224)], 12, upright=True)
    return [(foot, BLACK), (bowl, dye(look, "black", "charcoal")), (ring, shine(look)),
            (lens, image)]  # fmt: skip


@category("rear_view_mirror", size=(0.226, 0.122, 0.068), mass=0.3, material="plastic",
          aliases=("rearview mirror", "wing mirror", "car mirror", "side mirror"),
          themes=("workbench",), colors=("black",))  # fmt: skip
@from_pieces(bodies=3)
def rear_view_mirror(look: Look) -> Pieces:
    """A rear-view mirror: a wide, rounded mirror in a dark housing on a stalk."""
    shell = plastic(look, "black", "charcoal", "gray")
    body = at_block(0.22, 0.065, 0.022, 0.028).turn(0, np.pi / 2 - 0.25)
    glass = at_block(0.208, 0.055, 0.002, 0.025, (0, 0, 0.0215)).turn(0, np.pi / 2 - 0.25)
    low = float(body.bounds[0, 2])
    body, glass = body.move(z=-low), glass.move(z=-low)
    stalk = rod([(0, 0.012, 0.04), (0, 0.05, 0.03), (0, 0.065, 0.009)], 0.007, 10)
    base = disc(0.024, 0.01, (0, 0.065, 0))
    return [
        (body, shell),
        (stalk, shell),
        (base, shell),
        (glass, surfaces.gradient((150, 170, 186), (226, 236, 242), look.rng)),
    ]


@category("wiper_blade", size=(0.44, 0.016, 0.044), mass=0.2, material="plastic",
          aliases=("windscreen wiper", "windshield wiper", "wiper"), themes=("workbench",),
          roles=("big",), colors=("black",))  # fmt: skip
@from_pieces()
def wiper_blade(look: Look) -> Pieces:
    """A wiper blade standing on its rubber edge: a spine, a curved arm and a central clip."""
    rubber = at_box(0.44, 0.007, 0.012)
    spine = at_block(0.4, 0.011, 0.007, 0.003, (0, 0, 0.011))
    arms = rod([(-0.18, 0, 0.016), (-0.08, 0, 0.03), (0, 0, 0.034), (0.08, 0, 0.03),
                (0.18, 0, 0.016)], 0.004, 8)  # fmt: skip
    hook = at_block(0.04, 0.014, 0.02, 0.004, (0, 0, 0.022))
    foot = at_box(0.3, 0.016, 0.003)
    return [(rubber, BLACK), (spine, metal(look, "black", "charcoal")), (arms, dye(look, "black")),
            (hook, dye(look, "black", "gray")), (foot, BLACK)]  # fmt: skip


@category("gear_knob", size=(0.09, 0.09, 0.0995), mass=0.2, material="plastic",
          aliases=("gear stick", "gear lever", "shift knob", "gear shift"), themes=("workbench",),
          colors=("black",))  # fmt: skip
@from_pieces()
def gear_knob(look: Look) -> Pieces:
    """A gear knob on its collar with the shift pattern on top."""
    color = look.color("black", "brown", "silver", "white", "red")
    body = standing((0.014, 0), (0.016, 0.02), (0.026, 0.05), (0.026, 0.066), (0.018, 0.076))
    image = prints.canvas(64, 64, (30, 30, 32))
    for x in (0.28, 0.5, 0.72):
        prints.fill(image, x - 0.02, 0.24, 0.04, 0.52, (236, 236, 232))
    prints.fill(image, 0.27, 0.48, 0.46, 0.05, (236, 236, 232))
    for n, (x, y) in enumerate(
        ((0.28, 0.14), (0.28, 0.88), (0.5, 0.14), (0.5, 0.88), (0.72, 0.14)), 1
    ):
        prints.write(image, str(n), x, y, 0.17, (236, 236, 232))
    boot = standing((0.045, 0), (0.044, 0.006), (0.03, 0.016), (0.018, 0.03))
    return [(boot, dye(look, "black", "charcoal")), (body.move(z=0.022), look.surface(color)),
            (disc(0.017, 0.002, (0, 0, 0.0975)), image)]  # fmt: skip


DIPSTICK_BLACK = surfaces.plain((34, 34, 37))


@category("filler_cap", size=(0.0616, 0.0617, 0.0323), mass=0.06, material="plastic",
          aliases=("petrol cap", "radiator cap", "fuel cap", "gas cap", "distributor cap",
          "oil cap", "oil filler cap", "tank cap"), themes=("workbench",),
          colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def filler_cap(look: Look) -> Pieces:
    """A round filler cap with ribs around its side and a grip bar on top."""
    body = disc(0.03, 0.022)
    ribs = [at_box(0.003, 0.004, 0.02, (0.03 * np.cos(a), 0.03 * np.sin(a), 0.001))
            for a in np.arange(18) * 0.349]  # fmt: skip
    grip = at_block(0.05, 0.012, 0.012, 0.004, (0, 0, 0.021))
    tile = plastic(look, "black", "charcoal", "yellow", "silver")
    return [(body, tile), (grip, tile), (join(ribs), tile)]


@category("car_horn", size=(0.149, 0.101, 0.0827), mass=0.4, material="metal",
          aliases=("air horn",), themes=("workbench",), colors=("black", "red"))  # fmt: skip
@from_pieces(bodies=2)
def car_horn(look: Look) -> Pieces:
    """A round car horn lying flat: a slotted face, two shiny rings and a flared bell."""
    tile = metal(look, "black", "red", "silver")
    body = disc(0.045, 0.03)
    ring = [torus(0.045, 0.004, 30, 6).move(z=z) for z in (0.005, 0.026)]
    bell = (lathe([(0.012, 0), (0.016, 0.03), (0.04, 0.06), (0.037, 0.06), (0.01, 0.03)], 24,
                  loop=True).turn(1, np.pi / 2).move(0.035, 0, 0.04))  # fmt: skip
    slits = [at_box(0.06 - 0.01 * abs(k), 0.004, 0.001, (0, 0.014 * k, 0.0298))
             for k in (-2, -1, 0, 1, 2)]  # fmt: skip
    return [(body, tile), (bell, tile), (join(ring), shine(look)), (join(slits), DIPSTICK_BLACK)]


@category("car_fuse", size=(0.019, 0.02, 0.005), mass=0.002, material="plastic",
          aliases=("blade fuse", "electrical fuse"), themes=("workbench",),
          colors=("red", "blue"))  # fmt: skip
@from_pieces()
def car_fuse(look: Look) -> Pieces:
    """A blade fuse lying flat: a coloured body with two flat metal legs in front."""
    body = at_block(0.019, 0.005, 0.012, 0.0015, (0, 0, 0)).turn(0, np.pi / 2).move(z=0.0025)
    body = body.move(z=-float(body.bounds[0, 2]))
    y = float(body.bounds[0, 1])
    legs = [
        at_box(0.0055, 0.009, 0.001, (s * 0.006, y - 0.0035 + 0.012 * 0, 0.002)) for s in (-1, 1)
    ]
    return [(body, plastic(look, "red", "blue", "yellow", "green", "orange", "tan")),
            (join(legs), shine(look))]  # fmt: skip


@category("car_air_freshener", size=(0.0662, 0.137, 0.00233), mass=0.004, material="paper",
          aliases=("tree air freshener", "hanging air freshener"), themes=("workbench",),
          roles=("flat",), colors=("green",))  # fmt: skip
@from_pieces()
def car_air_freshener(look: Look) -> Pieces:
    """A hanging air freshener: a paper fir tree on a string."""
    color = look.color("green", "blue", "yellow", "red", "pink", "black")
    half = [(0.008, 0), (0.008, 0.012), (0.034, 0.012), (0.02, 0.036), (0.028, 0.036),
            (0.014, 0.06), (0.02, 0.06), (0.0, 0.092)]  # fmt: skip
    outline = [*half, *[(-x, y) for x, y in half[-2::-1]]]
    body = plate(outline, 0.002)
    loop = rod([(0, 0.088, 0.001), (0.016, 0.115, 0.001), (0, 0.14, 0.001), (-0.016, 0.115, 0.001),
                (0, 0.088, 0.001)], 0.0008, 5, 5)  # fmt: skip
    mark = at_box(0.034, 0.014, 0.0006, (0, 0.03, 0.0018))
    return [(body, surfaces.speckles(look.rng, color, 4)), (loop, surfaces.plain((236, 232, 224))),
            (mark, word_plate(look.pick(["PINE", "FRESH", "VANILLA"]), (250, 250, 246),
                              (40, 40, 44), 0.5))]  # fmt: skip


@category("fuzzy_dice", size=(0.209, 0.141, 0.0734), mass=0.1, material="fabric",
          aliases=("car mirror dice", "furry dice", "fluffy dice", "dice for a car mirror",
          "plush dice"), themes=("workbench",), colors=("red", "pink"))  # fmt: skip
@from_pieces(bodies=2)
def fuzzy_dice(look: Look) -> Pieces:
    """A pair of plush dice on a string."""
    color = look.color("red", "pink", "black", "white", "blue")
    ink = (240, 240, 238) if sum(color) < 500 else (30, 30, 32)
    face = prints.pips(5, color, ink)  # type: ignore[arg-type]
    cubes = [at_box(0.07, 0.07, 0.07).turn(2, a).move(x, y) for a, x,
             y in ((0.3, -0.055, 0), (0.8, 0.055, 0.02))]  # fmt: skip
    cord = rod([(-0.055, 0, 0.07), (-0.03, 0.06, 0.03), (0, 0.09, 0.002), (0.03, 0.08, 0.03),
                (0.055, 0.02, 0.07)], 0.0015, 6, 5)  # fmt: skip
    return [*((c, face) for c in cubes), (cord, surfaces.plain((240, 236, 226)))]


@category("key_fob", size=(0.128, 0.036, 0.0155), mass=0.05, material="plastic",
          aliases=("car key fob", "remote key", "car fob", "car key remote"), themes=("workbench",),
          colors=("black",))  # fmt: skip
@from_pieces(bodies=1)
def key_fob(look: Look) -> Pieces:
    """A car key lying flat: a rounded case with three buttons, a ring and a metal blade."""
    shell = plastic(look, "black", "charcoal", "silver")
    body = at_block(0.07, 0.036, 0.014, 0.014)
    keys = [at_block(0.012, 0.02, 0.002, 0.004, (x, 0, 0.0135)) for x in (-0.012, 0.004, 0.02)]
    ring = torus(0.013, 0.0016, 24, 6).move(-0.046, 0, 0.0018)
    blade = at_box(0.035, 0.009, 0.0025, (0.05, 0, 0.005))
    return [(body, shell), (join(keys), dye(look, "gray", "silver")),
            (join([ring, blade]), shine(look))]  # fmt: skip


@category("seat_belt_buckle", size=(0.335, 0.055, 0.024), mass=0.2, material="fabric",
          aliases=("seatbelt buckle", "seat belt", "seatbelt", "safety belt"),
          themes=("workbench",), roles=("flat",), colors=("black",))  # fmt: skip
@from_pieces()
def seat_belt_buckle(look: Look) -> Pieces:
    """A black buckle with a red button, a metal tongue and a piece of belt on each side."""
    webbing = cloth(look, "black", "charcoal", "red", "beige")
    belt = [at_box(0.12, 0.046, 0.003, (-0.1, 0, 0.006)), at_box(0.12, 0.046, 0.003,
                                                                 (0.115, 0, 0.006))]  # fmt: skip
    box = at_block(0.065, 0.055, 0.022, 0.008, (0.03, 0, 0))
    tongue = at_block(0.05, 0.05, 0.007, 0.006, (-0.035, 0, 0.004))
    button = at_block(0.018, 0.034, 0.003, 0.003, (0.014, 0, 0.021))
    return [(box, DIPSTICK_BLACK), (tongue, shine(look)), (join(belt), webbing),
            (button, surfaces.plain((206, 40, 38)))]  # fmt: skip


@category("tax_disc", size=(0.076, 0.076, 0.0016), mass=0.002, material="paper",
          aliases=("parking disc", "parking permit"), themes=("workbench",), roles=("flat",),
          colors=("blue",))  # fmt: skip
@from_pieces()
def tax_disc(look: Look) -> Pieces:
    """A round paper disc in a clear holder."""
    image = prints.canvas(64, 64, look.color("blue", "green", "red", "purple"))
    prints.disc(image, 0.5, 0.5, 0.36, (244, 240, 226))
    prints.write(
        image, look.pick(["JUN 12", "MAR 09", "SEP 14"]), 0.5, 0.5, 0.2, (30, 30, 34), True
    )
    return [(disc(0.038, 0.0016, sides=36), image)]


DARK = surfaces.plain((28, 28, 30))


@category("brake_pad", size=(0.178, 0.0741, 0.0172), mass=0.35, material="metal",
          aliases=("brake shoe", "brake lining"), themes=("workbench",),
          colors=("charcoal",))  # fmt: skip
@from_pieces()
def brake_pad(look: Look) -> Pieces:
    """A brake pad lying flat: a steel back with lugs and a dark lining with a groove."""
    a = np.linspace(0.5, np.pi - 0.5, 18)
    outer, inner = (np.column_stack([0.1 * np.cos(a), 0.1 * np.sin(a)]),
                    np.column_stack([0.052 * np.cos(a), 0.052 * np.sin(a)]))  # fmt: skip
    shape = np.concatenate([outer, inner[::-1]]) - [0, 0.08]
    back = plate(shape, 0.006)
    ears = [at_block(0.016, 0.014, 0.006, 0.003, (s * 0.082, -0.036, 0)) for s in (-1, 1)]
    small = [0.92 * shape[k] + [0, -0.0] for k in range(36)]
    lining = plate(np.array(small), 0.011, 0.006)
    groove = at_box(0.003, 0.046, 0.0008, (0, -0.005, 0.0166))
    return [(back, metal(look, "charcoal", "silver", "red")), (lining, surfaces.spots(look.rng,
             (62, 58, 56), (110, 100, 90), 0.1)),
            (join(ears), dye(look, "charcoal")), (groove, DARK)]  # fmt: skip


@category("brake_disc", size=(0.26, 0.26, 0.045), mass=3.0, material="metal",
          aliases=("brake rotor", "disc brake"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(bodies=2)
def brake_disc(look: Look) -> Pieces:
    """A brake disc lying flat: a broad ring and a hub with bolt holes."""
    steel = metal(look, "silver", "gray")
    ring = lathe([(0.055, 0), (0.13, 0), (0.13, 0.02), (0.055, 0.02)], 44, loop=True)
    hat = lathe([(0.03, 0), (0.068, 0), (0.066, 0.045), (0.03, 0.045)], 36, loop=True)
    holes = [disc(0.006, 0.001, (0.048 * np.cos(a), 0.048 * np.sin(a), 0.0446), sides=14)
             for a in np.arange(5) * 1.2566]  # fmt: skip
    vents = [disc(0.0045, 0.001, (r * np.cos(a), r * np.sin(a), 0.0196), sides=10)
             for r, o in ((0.085, 0.0), (0.112,
             0.13)) for a in np.arange(12) * np.pi / 6 + o]  # fmt: skip
    return [(ring, steel), (hat, dye(look, "gray", "charcoal")), (join([*holes, *vents]), DARK)]


@category("shock_absorber", size=(0.36, 0.058, 0.058), mass=1.5, material="metal",
          aliases=("damper", "car shock", "suspension strut", "coilover"), themes=("workbench",),
          colors=("red",))  # fmt: skip
@from_pieces(foot=0.08)
def shock_absorber(look: Look) -> Pieces:
    """A shock absorber lying flat: a rod and a tube with a coloured spring."""
    z = 0.03
    body = spindle((-0.16, 0.012), (-0.155, 0.017), (-0.02, 0.017), (-0.015, 0.012), z=z)
    shaft = spindle((-0.02, 0.006), (0.15, 0.006), z=z)
    seats = [spindle((x, 0.028), (x + 0.006, 0.028), z=z) for x in (-0.11, 0.12)]
    t = np.linspace(0, 1, 130)
    a = 2 * np.pi * 8 * t
    coil = tube(
        np.column_stack([-0.104 + 0.224 * t, 0.0245 * np.cos(a), z + 0.0245 * np.sin(a)]), 0.0042, 7
    )
    eyes = [lathe([(0.007, 0), (0.015, 0), (0.015, 0.022), (0.007, 0.022)], 20, loop=True).turn(0,
             np.pi / 2).move(x, 0.011, z)
            for x in (-0.172, 0.164)]  # fmt: skip
    return [(body, dye(look, "black", "silver")), (shaft, shine(look)), (join(seats),
             shine(look)), (coil, plastic(look, "red", "yellow", "blue", "black")),
            (join(eyes), dye(look, "charcoal"))]  # fmt: skip


@category("tyre", size=(0.213, 0.213, 0.0518), mass=0.5, material="rubber", hollow=True,
          aliases=("tire", "old tyre", "rubber tyre", "small tyre", "car tyre", "car tire",
          "toy tyre", "spare tyre", "rubber tire"), themes=("workbench",), roles=("round",),
          colors=("black",))  # fmt: skip
def tyre(look: Look) -> Shape:
    """A small rubber tyre with a tread, lying flat."""
    color = look.color("black", "charcoal", "gray")
    k, w = look.between(0.8, 1.2), look.between(0.8, 1.2)
    rim = [(0.058, 0.004), (0.09, 0.0), (0.098, 0.006), (0.1, 0.02 * w), (0.1, 0.034 * w),
           (0.098, 0.046 * w), (0.09, 0.052 * w), (0.058, 0.048 * w),
           (0.066, 0.026 * w)]  # fmt: skip
    body = lathe(rim, 40, loop=True)
    lugs = [
        at_box(0.008, 0.006, 0.05 * w, (0.1, 0, 0.001)).turn(2, n * np.pi / 18) for n in range(36)
    ]
    rubber = surfaces.speckles(look.rng, color, 6)
    parts = ring_parts([(0.09, 0.0), (0.1, 0.02 * w), (0.1, 0.034 * w), (0.09, 0.052 * w)],
                       [(0.062, 0.048 * w), (0.062, 0.004)])  # fmt: skip
    return shape([(join([body, *lugs]), rubber)], parts).scale(k)


@category("catalytic_converter", size=(0.288, 0.127, 0.0971), mass=2.5, material="metal",
          aliases=("exhaust", "silencer", "muffler", "exhaust pipe"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(foot=0.06)
def catalytic_converter(look: Look) -> Pieces:
    """A catalytic converter lying flat: an oval drum with three bands and two flanged pipes."""
    steel = metal(look, "silver", "gray", "bronze")
    body = spindle((-0.15, 0.024), (-0.11, 0.024), (-0.08, 0.05), (0.08, 0.05), (0.11, 0.024),
                   (0.15, 0.024), z=0.05).scale(1, 1.3, 1)  # fmt: skip
    shield = [spindle((x, 0.0512), (x + 0.006, 0.0512), z=0.05).scale(1, 1.29, 1)
              for x in (-0.06, 0.0, 0.054)]  # fmt: skip
    flanges = [spindle((x, 0.036), (x + 0.008, 0.036), sides=6, z=0.05) for x in (-0.15, 0.142)]
    return [(body, steel), (join(shield), steel), (join(flanges), dye(look, "charcoal"))]
