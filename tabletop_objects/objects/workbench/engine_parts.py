"""Objects of the ``workbench`` theme: engine parts."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, metal, plastic, shine
from ...kit.outlines import arc
from ...kit.primitives import at_block, at_box, disc, plate, rod, spindle, standing, straight
from ...kit.shapes import Pieces, category, from_pieces
from ...kit.solids import Solid, join, lathe, prism, torus, tube
from ...kit.surfaces import Look
from .car_parts import DIPSTICK_BLACK

DARK = surfaces.plain((28, 28, 30))


@category("spark_plug", size=(0.081, 0.021, 0.0185), mass=0.05, material="metal",
          aliases=("sparking plug", "glow plug", "spark plug lead"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(foot=0.1)
def spark_plug(look: Look) -> Pieces:
    """A spark plug lying flat: its terminal, ribbed insulator, hexagon, thread and electrode."""
    steel = metal(look, "silver", "gray")
    white = spindle((-0.035, 0.0045), (-0.034, 0.005), (-0.03, 0.0045), (-0.028, 0.005),
                   (-0.024, 0.0045), (-0.022, 0.005), (-0.005, 0.0062), z=0.01)  # fmt: skip
    tip = spindle((-0.045, 0.0022), (-0.043, 0.0032), (-0.035, 0.0032), z=0.01)
    hexagon = spindle(
        (-0.006, 0.0085), (-0.004, 0.0105), (0.004, 0.0105), (0.006, 0.0085), sides=6, z=0.0092
    )
    shoulder = spindle((0.005, 0.0085), (0.011, 0.0085), (0.012, 0.007), z=0.01)
    points = [(0.012 + 0.001 * k, 0.0068 - 0.0008 * (k % 2)) for k in range(19)]
    thread = spindle(*points, z=0.01, sides=14)
    end = straight((0.03, 0, 0.01), (0.034, 0, 0.01), 0.0018)
    hook = rod([(0.03, 0, 0.016), (0.036, 0, 0.0155), (0.036, 0, 0.01)], 0.0011, 6)
    return [(hexagon, steel), (white, surfaces.plain((240, 238, 232))), (thread, shine(look)),
            (join([tip, shoulder, end, hook]), steel)]  # fmt: skip


@category("oil_filter", size=(0.077, 0.077, 0.0885), mass=0.3, material="metal",
          aliases=("fuel filter", "car oil filter"), themes=("workbench",),
          colors=("orange", "white"))  # fmt: skip
@from_pieces(bodies=1)
def oil_filter(look: Look) -> Pieces:
    """A painted oil filter canister with flutes at the bottom and a printed band."""
    color = look.color("orange", "white", "blue", "black", "red")
    can = standing((0.034, 0), (0.038, 0.004), (0.038, 0.075), (0.033, 0.085), (0.02, 0.088))
    flutes = [at_box(0.004, 0.008, 0.028, (0.0365 * np.cos(a), 0.0365 * np.sin(a), 0.052))
              for a in np.arange(14) * 0.4488]  # fmt: skip
    image = surfaces.stack(
        (surfaces.plain(color), 3), (surfaces.plain((240, 240, 238)), 1), (surfaces.plain(color), 5)
    )
    gasket = torus(0.03, 0.003, 30, 6).move(z=0.086)
    hole = disc(0.01, 0.001, (0, 0, 0.0876))
    return [(can, image), (join(flutes), surfaces.plain(color)), (gasket, DARK), (hole, DARK)]


@category("air_filter", size=(0.22, 0.17, 0.035), mass=0.25, material="metal",
          aliases=("cabin filter", "pollen filter", "hepa filter", "engine filter"),
          themes=("workbench",), colors=("orange", "black"))  # fmt: skip
@from_pieces()
def air_filter(look: Look) -> Pieces:
    """A panel filter: a frame around pleated paper."""
    frame = plastic(look, "orange", "black", "blue", "gray")
    color = look.own_color("cream", "white", "beige")
    sides = [at_box(0.22, 0.012, 0.035, (0, s * 0.079, 0)) for s in (-1, 1)]
    ends = [at_box(0.012, 0.146, 0.035, (s * 0.104, 0, 0)) for s in (-1, 1)]
    pleats = surfaces.stripes([color, tuple(0.72 * c for c in color)], 16, upright=True)  # type: ignore[list-item]
    ridges = [prism(np.array([(-0.0055, 0), (0.0055, 0), (0, 0.022)]), -0.073, 0.073).turn(0,
             np.pi / 2)
              .move(-0.0915 + 0.0114 * k, 0, 0.008) for k in range(17)]  # fmt: skip
    bed = at_box(0.196, 0.146, 0.01)
    return [*((s, frame) for s in (*sides, *ends)), (bed, pleats),
            (join(ridges), surfaces.plain(color))]  # fmt: skip


@category("piston", size=(0.077, 0.078, 0.052), mass=0.4, material="metal",
          aliases=("engine piston",), themes=("workbench",), colors=("silver",))  # fmt: skip
@from_pieces(bodies=1)
def piston(look: Look) -> Pieces:
    """A piston standing on its skirt, with two dark rings near its top and a pin hole in front."""
    steel = metal(look, "silver", "gray")
    body = standing((0.036, 0), (0.038, 0.004), (0.038, 0.03), (0.0365, 0.031), (0.0365, 0.034),
             (0.038, 0.035),
                    (0.038, 0.039), (0.0365, 0.04), (0.0365, 0.043), (0.038, 0.044), (0.038,
             0.05), (0.036, 0.052), sides=32)  # fmt: skip
    rings = [torus(0.037, 0.0012, 32, 6).move(z=z) for z in (0.0325, 0.0415)]
    bosses = [disc(0.011, 0.004).turn(0, np.pi / 2).move(0, -0.0355, 0.017)]
    bore = disc(0.0075, 0.001).turn(0, np.pi / 2).move(0, -0.039, 0.017)
    return [(body, steel), (join(rings), dye(look, "charcoal")), (join(bosses), steel),
            (bore, DARK)]  # fmt: skip


@category("connecting_rod", size=(0.18, 0.064, 0.018), mass=0.5, material="metal",
          aliases=("con rod", "conrod", "track rod end", "ball joint", "rocker arm", "rotor arm"),
          themes=("workbench",), colors=("silver",))  # fmt: skip
@from_pieces()
def connecting_rod(look: Look) -> Pieces:
    """A connecting rod lying flat: a beam between a big ring on the left and a small one."""
    steel = metal(look, "silver", "gray", "charcoal")
    big = lathe([(0.02, 0), (0.032, 0), (0.032, 0.018), (0.02, 0.018)], 28, loop=True).move(x=-0.06)
    small = lathe([(0.01, 0), (0.018, 0), (0.018, 0.018), (0.01, 0.018)], 24, loop=True).move(
        x=0.07
    )
    beam = plate(
        [(-0.034, -0.014), (0.056, -0.009), (0.056, 0.009), (-0.034, 0.014)], 0.013, 0.0025
    )
    return [(big, steel), (small, steel), (beam, steel)]


@category("crankshaft", size=(0.418, 0.0678, 0.0918), mass=4.0, material="metal",
          aliases=("crank shaft",), themes=("workbench",), colors=("silver",))  # fmt: skip
@from_pieces(foot=0.02, bodies=(0, 1, 3))
def crankshaft(look: Look) -> Pieces:
    """A crankshaft lying flat: journals, webs with counterweights, and pins on both sides."""
    steel = metal(look, "silver", "gray", "charcoal")
    journals = [spindle((x, 0.016), (x + 0.034, 0.016), z=0.048)
                for x in (-0.19, -0.105, -0.02, 0.065, 0.15)]  # fmt: skip
    web = np.concatenate(
        [arc((0, -0.012), 0.034, np.pi, 2 * np.pi, 10), arc((0, 0.026), 0.02, 0, np.pi, 8)]
    )
    pieces: list[Solid] = []
    pins = []
    for k, x in enumerate((-0.157, -0.072, 0.013, 0.098)):
        flip = 1 if k in (0, 3) else -1
        for dx in (0, 0.034):
            one = (prism(web * [1, 1] if flip > 0 else (-web), 0,
                         0.01).turn(0, np.pi / 2).turn(2, np.pi / 2))  # fmt: skip
            pieces.append(one.move(x + dx, 0, 0.048))
        pins.append(spindle((x + 0.008, 0.014), (x + 0.036, 0.014), z=0.048 + flip * 0.024))
    nose = spindle((-0.225, 0.01), (-0.19, 0.012), z=0.048)
    flange = spindle((0.184, 0.03), (0.194, 0.03), z=0.048)
    return [(join(pieces), steel), (join([*journals, nose]), shine(look)), (join(pins),
             shine(look)),
            (flange, steel)]  # fmt: skip


@category("camshaft", size=(0.36, 0.048, 0.046), mass=1.5, material="metal",
          aliases=("cam shaft", "drive shaft"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(foot=0.05)
def camshaft(look: Look) -> Pieces:
    """A camshaft lying flat: a bright shaft with eight cams at various angles and an end disc."""
    steel = metal(look, "silver", "gray", "charcoal")
    shaft = spindle((-0.18, 0.009), (0.18, 0.009), z=0.022)
    lobe = np.concatenate(
        [arc((0, 0), 0.015, np.pi * 0.9, 2.1 * np.pi, 14), [(0.006, 0.021), (-0.006, 0.021)]]
    )
    lobes = []
    for k in range(8):
        a = (0, 2.4, 3.9, 1.2)[k % 4]
        one = prism(lobe, 0, 0.013).turn(2, a).turn(0, np.pi / 2).turn(2, np.pi / 2)
        lobes.append(one.move(-0.15 + 0.04 * k, 0, 0.022))
    end = spindle((0.17, 0.024), (0.18, 0.024), sides=20, z=0.0225)
    return [(shaft, shine(look)), (join(lobes), steel), (end, steel)]


@category("cylinder_head", size=(0.34, 0.166, 0.095), mass=6.0, material="metal",
          aliases=("engine block", "engine head", "gearbox"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces()
def cylinder_head(look: Look) -> Pieces:
    """A cylinder head: a metal block with bolts and four dark plugs on top and ports in front."""
    steel = metal(look, "silver", "gray")
    body = at_box(0.34, 0.16, 0.07)
    deck = at_box(0.32, 0.06, 0.02, (0, 0, 0.07))
    ports = [disc(0.02, 0.004).turn(0, np.pi / 2).move(x, -0.079, 0.035)
             for x in (-0.12, -0.04, 0.04, 0.12)]  # fmt: skip
    bolts = [disc(0.009, 0.012, (x, s * 0.06, 0.07), sides=6) for x in np.linspace(-0.15, 0.15, 5)
             for s in (-1, 1)]  # fmt: skip
    plugs = [disc(0.012, 0.006, (x, 0, 0.089)) for x in (-0.12, -0.04, 0.04, 0.12)]
    return [(body, steel), (deck, dye(look, "gray", "charcoal")), (join(ports), DARK),
            (join(bolts), shine(look)), (join(plugs), DARK)]  # fmt: skip


TURBOCHARGER_DARK = surfaces.plain((28, 28, 30))


@category("carburettor", size=(0.108, 0.06, 0.085), mass=0.7, material="metal",
          aliases=("carburetor", "throttle body", "fuel injector", "carb"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(bodies=3)
def carburettor(look: Look) -> Pieces:
    """A carburettor: a bowl, a throat with a flap, screws and a lever."""
    steel = metal(look, "silver", "gold", "gray")
    base = at_block(0.09, 0.06, 0.01, 0.008)
    bowl = at_block(0.05, 0.055, 0.045, 0.01, (-0.012, 0, 0.01))
    throat = lathe([(0.018, 0), (0.026, 0), (0.026, 0.06), (0.03, 0.075), (0.024, 0.075),
                    (0.018, 0.05)], 26, loop=True).move(0.02, 0, 0.01)  # fmt: skip
    flap = disc(0.0185, 0.002, (0.02, 0, 0.045))
    lever = [at_block(0.01, 0.004, 0.04, 0.002, (-0.03, -0.032, 0.03)),
             straight((-0.03, -0.034, 0.06), (-0.03, -0.02, 0.06), 0.004)]  # fmt: skip
    screws = [disc(0.004, 0.012, (x, y, 0.053), sides=10) for x in (-0.03, -0.005)
              for y in (-0.018, 0.018)]  # fmt: skip
    pipe = straight((-0.03, 0, 0.04), (-0.06, 0, 0.045), 0.005)
    return [(base, steel), (bowl, steel), (throat, steel), (flap, shine(look, "brass")),
             (join(lever), shine(look)),
            (join(screws), shine(look, "brass")), (pipe, shine(look, "brass"))]  # fmt: skip


@category("turbocharger", size=(0.163, 0.149, 0.135), mass=3.0, material="metal",
          aliases=("turbo", "supercharger"), themes=("workbench",), colors=("silver",))  # fmt: skip
@from_pieces(bodies=7)
def turbocharger(look: Look) -> Pieces:
    """A turbocharger: two spiral housings on one shaft."""
    pieces: Pieces = []
    for x, tile, r in (
        (-0.04, metal(look, "silver", "gray"), 0.05),
        (0.045, dye(look, "charcoal", "bronze"), 0.044),
    ):
        a = np.linspace(0, 1.9 * np.pi, 34)
        radii = np.linspace(0.008, 0.02, 34)
        path = np.column_stack([0 * a + x, r * np.cos(a), 0.07 + r * np.sin(a)])
        out = np.array([[x, path[-1, 1] + 0.01, path[-1, 2] + 0.03],
                        [x, path[-1, 1] + 0.012, path[-1, 2] + 0.055]])  # fmt: skip
        pieces.append((tube(np.concatenate([path, out]), [*radii, 0.02, 0.021], 12), tile))
        core = disc(r, 0.022, sides=26).turn(1, np.pi / 2).move(x - 0.011, 0, 0.07)
        pieces.append((core, tile))
    neck = straight((-0.06, 0, 0.07), (-0.09, 0, 0.07), 0.026, 20)
    hole = disc(0.02, 0.001).turn(1, np.pi / 2).move(-0.0912, 0, 0.07)
    fins = [at_box(0.001, 0.004, 0.036, (0, 0, -0.018)).turn(0, k).move(-0.0915, 0, 0.07)
            for k in (0, 0.79, 1.57, 2.36)]  # fmt: skip
    shaft = straight((-0.03, 0, 0.07), (0.04, 0, 0.07), 0.024, 16)
    foot = at_box(0.05, 0.05, 0.03, (0.0, 0, 0))
    return [*pieces, (neck, pieces[0][1]), (shaft, shine(look)), (foot, shine(look, "charcoal")),
            (hole, TURBOCHARGER_DARK), (join(fins), shine(look))]  # fmt: skip


@category("flywheel", size=(0.27, 0.27, 0.0277), mass=4.0, material="metal",
          aliases=("fly wheel", "clutch disc", "clutch plate"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(bodies=2)
def flywheel(look: Look) -> Pieces:
    """A flywheel lying flat: a disc with a toothed rim and six small holes around a wide one."""
    n = 60
    a = np.arange(2 * n) * np.pi / n
    r = np.where(np.arange(2 * n) % 2, 0.125, 0.13)
    ring = prism(np.column_stack([r * np.cos(a), r * np.sin(a)]), 0, 0.014)
    steel = metal(look, "silver", "gray")
    face = lathe([(0.03, 0), (0.118, 0), (0.118, 0.026), (0.03, 0.026)], 40, loop=True)
    holes = [disc(0.006, 0.001, (0.042 * np.cos(t), 0.042 * np.sin(t), 0.0256), sides=12)
             for t in np.arange(6) * np.pi / 3]  # fmt: skip
    return [(ring, dye(look, "charcoal")), (face, steel), (join(holes), TURBOCHARGER_DARK),
            (disc(0.0295, 0.002, (0, 0, 0.01)), TURBOCHARGER_DARK)]  # fmt: skip


@category("ignition_coil", size=(0.187, 0.0467, 0.0298), mass=0.2, material="metal",
          aliases=("coil pack",), themes=("workbench",), colors=("black",))  # fmt: skip
@from_pieces(foot=0.05)
def ignition_coil(look: Look) -> Pieces:
    """An ignition coil lying flat: a round stem on the left and a box with a lug and a plug."""
    body = at_block(0.04, 0.03, 0.03, 0.005, (0.06, 0, 0))
    stem = spindle((-0.09, 0.009), (-0.085, 0.012), (0.0, 0.012), (0.045, 0.01), z=0.0145)
    plug = at_block(0.02, 0.024, 0.02, 0.003, (0.088, 0, 0.004))
    lug = at_block(0.02, 0.02, 0.006, 0.008, (0.06, 0.022, 0.006))
    return [(body, plastic(look, "black", "charcoal", "red")), (stem, dye(look, "black")),
            (plug, dye(look, "gray")), (lug, dye(look, "black"))]  # fmt: skip


@category("gasket", size=(0.3, 0.12, 0.0028), mass=0.1, material="rubber",
          aliases=("head gasket", "engine gasket", "rubber gasket"), themes=("workbench",),
          colors=("charcoal",))  # fmt: skip
@from_pieces(bodies=1)
def gasket(look: Look) -> Pieces:
    """A head gasket: a thin plate with large and small holes printed on it."""
    color = look.color("charcoal", "silver", "brown", "copper")
    body = at_block(0.3, 0.12, 0.002, 0.012)
    holes = [disc(0.034, 0.0004, (x, 0, 0.0019)) for x in (-0.105, -0.035, 0.035, 0.105)]
    rims = [torus(0.035, 0.0012, 30, 5).move(x, 0, 0.0016) for x in (-0.105, -0.035, 0.035, 0.105)]
    small = [disc(0.005, 0.0004, (x, s * 0.05, 0.0019), sides=12)
             for x in np.linspace(-0.14, 0.14, 7) for s in (-1, 1)]  # fmt: skip
    return [(body, surfaces.speckles(look.rng, color, 6)),
            (join([*holes, *small]), surfaces.plain((214, 208, 198))),
            (join(rims), shine(look, "copper", "silver"))]  # fmt: skip


@category("alternator", size=(0.14, 0.125, 0.132), mass=4.0, material="metal",
          aliases=("car alternator", "starter motor"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(bodies=3)
def alternator(look: Look) -> Pieces:
    """An alternator: a round, ribbed housing with slots, a pulley and lugs."""
    steel = metal(look, "silver", "gray")
    z = 0.07
    body = spindle((-0.05, 0.045), (-0.04, 0.06), (0.045, 0.06), (0.055, 0.045), z=z)
    band = spindle((-0.012, 0.0615), (0.018, 0.0615), z=z)
    slots = [at_box(0.02, 0.004, 0.012, (-0.03 if k % 2 else 0.034, 0,
                                         0.053)).turn(0, 0.42 * k).move(z=z)
             for k in range(15)]  # fmt: skip
    pulley = [spindle((x, 0.028), (x + 0.004, 0.025), (x + 0.008, 0.028), z=z)
              for x in (0.062, 0.07, 0.078)]  # fmt: skip
    lugs = [at_block(0.03, 0.026, 0.07, 0.008, (0, s * 0.035, 0)) for s in (-1, 1)]
    return [(body, steel), (join(lugs), steel), (join(pulley), dye(look, "charcoal", "silver")),
            (band, dye(look, "charcoal")), (join(slots), TURBOCHARGER_DARK)]  # fmt: skip


@category("water_pump", size=(0.144, 0.0993, 0.0666), mass=1.2, material="metal",
          aliases=("fuel pump", "coolant pump", "oil pump"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
@from_pieces(bodies=4)
def water_pump(look: Look) -> Pieces:
    """A water pump: a round body on a flange, a grooved pulley on top, and a pipe."""
    steel = metal(look, "silver", "gray", "bronze")
    body = disc(0.045, 0.04, (0, 0, 0.0))
    flange = at_block(0.12, 0.06, 0.012, 0.02)
    pulley = lathe([(0, 0), (0.05, 0), (0.046, 0.006), (0.05, 0.012), (0, 0.012)], 32).move(z=0.055)
    hub = disc(0.016, 0.02, (0, 0, 0.04))
    pipe = straight((0.03, 0, 0.022), (0.08, 0.02, 0.026), 0.013, 14)
    return [(flange, steel), (body, steel), (hub, shine(look)),
            (pulley, dye(look, "charcoal", "silver")), (pipe, steel)]  # fmt: skip


@category("dipstick", size=(0.42, 0.044, 0.008), mass=0.05, material="metal",
          aliases=("oil dipstick",), themes=("workbench",), roles=("flat", "big"),
          colors=("yellow",))  # fmt: skip
@from_pieces()
def dipstick(look: Look) -> Pieces:
    """A dipstick lying flat: a ring on the right, a thin wire and a flat tip with two marks."""
    wire = rod([(-0.2, 0, 0.002), (0.1, 0, 0.002), (0.15, 0, 0.003)], 0.0018, 6)
    blade = at_box(0.06, 0.006, 0.0022, (-0.2, 0, 0))
    marks = [at_box(0.0015, 0.006, 0.0006, (x, 0, 0.0021)) for x in (-0.215, -0.19)]
    ring = torus(0.018, 0.004, 24, 8).move(0.17, 0, 0.004)
    return [(ring, plastic(look, "yellow", "orange", "red")), (wire, shine(look)),
            (blade, shine(look)), (join(marks), DIPSTICK_BLACK)]  # fmt: skip
