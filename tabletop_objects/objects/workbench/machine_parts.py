"""Objects of the ``workbench`` theme: machine parts."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import DARK, dye, metal, shine, steel
from ...kit.outlines import arc, ellipse, rectangle
from ...kit.parts import cylinder_part, hull_of, ring_parts
from ...kit.primitives import at_block, at_box, disc, drum, plate
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain
from .bike_parts import _teeth


@category("o_ring", size=(0.0344, 0.0344, 0.0043), mass=0.001, material="rubber",
          aliases=("oring", "rubber washer", "rubber seal", "rubber o ring", "o-ring"),
          themes=("workbench",), colors=("black",), state="lying")  # fmt: skip
@from_pieces(foot=0.08)
def o_ring(look: Look) -> Pieces:
    """A thin rubber O-ring with a round cross-section, lying flat."""
    return [(torus(0.015, 0.0022, 36, 10).move(z=0.0021), look.surface(look.color("black",
                                                                                  "charcoal", "red",
                                                                                  "orange"),
                                                                       "rubber"))]  # fmt: skip


@category("bushing", size=(0.023, 0.023, 0.016), mass=0.02, material="metal", aliases=("bush",
          "sleeve bearing", "spacer", "metal sleeve", "collet", "metal spacer", "tube spacer"),
          themes=("workbench",), colors=("brass",), state="lying")  # fmt: skip
@from_pieces()
def bushing(look: Look) -> Pieces:
    """A short, plain metal bushing, standing on its end."""
    return [(lathe([(0.006, 0), (0.0115, 0), (0.0115, 0.016), (0.006, 0.016)], 26, loop=True),
             metal(look, "brass", "bronze", "silver", "black"))]  # fmt: skip


@category("pulley", size=(0.06, 0.13, 0.022), mass=0.2, material="metal",
          aliases=("pulley block", "block and tackle", "rope pulley"), themes=("workbench",),
          colors=("silver",), state="lying")  # fmt: skip
@from_pieces(bodies=3)
def pulley(look: Look) -> Pieces:
    """A pulley block with a grooved wheel and a hook, lying flat."""
    steel = metal(look, "silver", "gray", "charcoal", "brass")
    wheel = lathe([(0, 0), (0.03, 0), (0.024, 0.006), (0.03, 0.012), (0, 0.012)], 32).move(z=0.004)
    cheeks = [at_block(0.03, 0.085, 0.003, 0.014, (0, 0.006, z)) for z in (0.0, 0.0165)]
    axle = disc(0.006, 0.022)
    hook = tube(
        [(*p, 0.01) for p in arc((0, 0.066), 0.014, -np.pi * 0.5, np.pi * 1.1, 16)], 0.0035, 8
    )
    return [(wheel, dye(look, "brass", "red", "gray")), (cheeks[0], steel), (cheeks[1], steel),
            (axle, shine(look)), (hook, steel)]  # fmt: skip


@category("gear", size=(0.059, 0.059, 0.012), mass=0.06, material="metal", aliases=("cogwheel",
          "cog", "gear wheel", "toothed wheel", "sprocket", "freewheel", "cassette sprocket",
          "pulley wheel", "gear set", "spirograph"), themes=("workbench",), roles=("flat", "round"),
          colors=("silver", "brass"))  # fmt: skip
def gear(look: Look) -> Shape:
    """A toothed wheel, lying flat."""
    k = look.between(0.8, 1.2)
    color = look.color("silver", "brass", "charcoal", "red", "yellow", "blue", "gold")
    teeth, r, h = int(look.rng.integers(12, 20)), 0.03 * k, 0.009 * k
    angles, radii = [], []
    for n in range(teeth):
        for a, f in ((0.0, 0.86), (0.3, 0.86), (0.42, 1.0), (0.72, 1.0), (0.84, 0.86)):
            angles.append((n + a) * 2 * np.pi / teeth)
            radii.append(f * r)
    outline = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])
    body = prism(outline, 0, h)
    tile = look.surface(color, "metal")
    hub = cylinder(0.26 * r, h * 1.35, 24)
    dark = surfaces.plain((26, 26, 28))
    bore = cylinder(0.13 * r, 0.0005, 16).move(z=h * 1.35)
    holes = [cylinder(0.13 * r, 0.0005, 16).move(0.55 * r * np.cos(a), 0.55 * r * np.sin(a), h)
             for a in np.arange(5) * 2 * np.pi / 5]  # fmt: skip
    return shape([(join([body, hub]), tile), (join([bore, *holes]), dark)],
                 [cylinder_part(0.97 * r, h), hull_of(hub)])  # fmt: skip


@category("bearing", size=(0.041, 0.041, 0.0113), mass=0.05, material="metal",
          aliases=("ball bearing", "wheel bearing", "ball race", "roller bearing"),
          themes=("workbench",), roles=("flat", "round"), colors=("silver",))  # fmt: skip
def bearing(look: Look) -> Shape:
    """A ball bearing lying flat: two rings with a shield or balls between them."""
    k = look.between(0.85, 1.2)
    color = look.color("silver", "silver", "gray", "charcoal")
    r, h = 0.02 * k, 0.011 * k
    metal = look.surface(color, "metal")
    rings = [lathe([(a * r, 0), (b * r, 0), (b * r, h), (a * r, h)], 34, loop=True)
             for a, b in ((0.42, 0.58), (0.82, 1.0))]  # fmt: skip
    shield = lathe([(0.57 * r, 0.08 * h), (0.83 * r, 0.08 * h), (0.83 * r, 0.9 * h),
                    (0.57 * r, 0.9 * h)], 34, loop=True)  # fmt: skip
    pieces = [(join(rings), metal)]
    if look.chance(0.5):
        pieces.append((shield, surfaces.plain(look.own_color("black", "blue", "red", "gray"))))
    else:
        balls = [lathe([(0, 0), (0.0026, 0.001), (0.0036, 0.0036), (0.0026, 0.0062), (0, 0.0072)],
                       12).scale(k, k, k).move(0.7 * r * np.cos(a), 0.7 * r * np.sin(a), 0.2 * h)
                 for a in np.arange(9) * 2 * np.pi / 9]  # fmt: skip
        web = shield.scale(1, 1, 0.4).move(z=0.3 * h)
        pieces.append((join(balls), surfaces.plain((226, 228, 232))))
        pieces.append((web, surfaces.plain((70, 66, 60))))
    return shape(pieces, ring_parts([(r, 0), (r, h)], [(0.42 * r, h), (0.42 * r, 0)], 10))


@category("spring", size=(0.0275, 0.0275, 0.0455), mass=0.015, material="metal", assembled=True,
          aliases=("coil spring", "metal spring", "compression spring"), themes=("workbench",),
          roles=("round",), colors=("silver",))  # fmt: skip
def spring(look: Look) -> Shape:
    """An upright coil spring."""
    k = look.between(0.85, 1.2)
    color = look.color("silver", "silver", "charcoal", "gold", "blue", "red")
    turns, r, h, wire = 6, 0.012 * k, 0.045 * k, 0.0016 * k
    t = np.linspace(0, 1, 110)
    a = 2 * np.pi * (turns + 2) * t
    z = wire + (h - 2 * wire) * np.clip((t * (turns + 2) - 1) / turns, 0, 1)
    coil = tube(np.column_stack([r * np.cos(a), r * np.sin(a), z]), wire, 6)
    return shape([(coil, look.surface(color, "metal"))],
                 ring_parts([(r + 0.9 * wire, 0.0002), (r + 0.9 * wire, 0.99 * h)],
                            [(r - wire, 0.99 * h), (r - wire, 0.0002)],
                            10))  # fmt: skip


@category("chain", size=(0.112, 0.0415, 0.0088), mass=0.08, material="metal", assembled=True,
          aliases=("metal chain", "steel chain", "iron chain", "chain link", "length of chain",
          "master link", "bike chain"), themes=("workbench",), colors=("silver",))  # fmt: skip
def chain(look: Look) -> Shape:
    """A piece of chain, lying in a curve."""
    k = look.between(0.85, 1.15)
    metal = look.surface(look.color("silver", "gray", "charcoal", "gold", "brass"), "metal")
    links, n, r = [], 11, 0.0018 * k
    long = 0.008 * k
    ring = ellipse(2 * long, 1.15 * long, 12)
    bow = look.between(0.9, 1.4)
    for m in range(n):
        t = (m - (n - 1) / 2) / n
        way = np.column_stack([ring, np.zeros(12)])
        link = tube(way, r, 6, loop=True)
        link = link.turn(0, 0.35 if m % 2 else -0.75).turn(2, -2 * bow * t * 1.1)
        link = link.move(0.0118 * k * (m - (n - 1) / 2) * (1 - 0.1 * abs(t)),
                         -0.06 * k * bow * t * t * 2)  # fmt: skip
        links.append(link)
    links = [s.move(z=-float(s.bounds[0, 2])) for s in links]
    return shape([(join(links), metal)], [hull_of(s) for s in links])


@category("crank", size=(0.244, 0.157, 0.0157), mass=0.45, material="metal", aliases=("crankset",
          "chainset", "crank arm", "chainring", "bike crank", "chain ring", "pedal crank"),
          themes=("workbench",), roles=("flat",), colors=("silver",))  # fmt: skip
def crank(look: Look) -> Shape:
    """A crank arm with a chainring, lying flat."""
    color = look.color("silver", "black", "charcoal")
    k = look.between(0.85, 1.1)
    ring = _teeth(0.08, 36, 0.004, 0.004)
    hole = drum(0.052, 0.0006, (0, 0, 0.0036), sides=30)
    spider = [
        at_box(0.075, 0.014, 0.006, (0.036, 0, 0.002)).turn(2, n * 2 * np.pi / 5) for n in range(5)
    ]
    hub = drum(0.018, 0.014, (0, 0, 0.002), bevel=0.002)
    arm = plate(rectangle(0.18, 0.026, 0.012), 0.01, at=(0.078, 0, 0.005), bevel=0.002)
    eye = drum(0.008, 0.0006, (0.157, 0, 0.0148))
    return put_down([(join([ring, *spider]), steel(look)), (hole, plain((60, 62, 66))),
                     (join([hub, arm]), look.surface(color, "metal")), (eye, plain(DARK))],
                    ring, arm, factor=k)  # fmt: skip
