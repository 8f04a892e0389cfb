"""Objects of the ``workbench`` theme: fasteners."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import metal, plastic, shine
from ...kit.outlines import arc
from ...kit.parts import cylinder_part, flat_foot, hull_of, ring_parts
from ...kit.primitives import at_block, at_box, disc, lay_down, spindle, standing, straight
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, shape, vary
from ...kit.solids import box, cylinder, join, lathe, torus, tube
from ...kit.surfaces import Look, tint_color
from .materials import WOODEN, _rod

BLACK = surfaces.plain((34, 34, 37))


@category("ratchet_strap", size=(0.24, 0.078, 0.036), mass=0.5, material="fabric", assembled=True,
          aliases=("tie down strap", "cargo strap", "lashing strap"), themes=("workbench",),
          colors=("orange",))  # fmt: skip
@from_pieces()
def ratchet_strap(look: Look) -> Pieces:
    """A ratchet strap: a roll of webbing with a steel ratchet at its end."""
    color = look.color("orange", "blue", "yellow", "red", "green")
    a = np.linspace(0, 2 * np.pi * 5, 120)
    r = 0.014 + 0.0032 * a / (2 * np.pi) * 1.3
    roll = [disc(0.038, 0.035)]
    spiral = tube(np.column_stack([r * np.cos(a), r * np.sin(a), 0 * a + 0.0352]), 0.0009, 4)
    tail = at_box(0.1, 0.003, 0.034, (0.05, -0.0365, 0))
    frame = [at_box(0.1, 0.004, 0.03, (0.13, y - 0.03, 0)) for y in (0.0, 0.03)]
    drum = straight((0.14, -0.034, 0.015), (0.14, 0.004, 0.015), 0.012, 12)
    grip = at_block(0.03, 0.04, 0.026, 0.006, (0.185, -0.015, 0.002))
    return [(roll[0], surfaces.speckles(look.rng, color, 6)), (tail, surfaces.plain(color)),
            (join([*frame, drum]), shine(look)), (grip, BLACK),
            (spiral, surfaces.plain(tint_color(color, 0.5)))]  # fmt: skip


HOSE_CLIP_BLACK = surfaces.plain((34, 34, 37))


@category("rivet", size=(0.0104, 0.0104, 0.016), mass=0.002, material="metal",
          aliases=("pop rivet", "steel rivet", "metal stud", "stud", "rivet nail"),
          themes=("workbench",), colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def rivet(look: Look) -> Pieces:
    """A rivet standing on its head with its shank up."""
    steel = metal(look, "silver", "copper", "gray")
    return [(standing((0.0048, 0), (0.0052, 0.0012), (0.0035, 0.003), (0.0022, 0.0034),
                      (0.0022, 0.016)), steel)]  # fmt: skip


@category("wall_plug", size=(0.033, 0.0088, 0.0088), mass=0.001, material="plastic",
          aliases=("rawlplug", "wall anchor", "screw anchor", "screw plug", "dowel plug",
          "rawl plug"), themes=("workbench",), colors=("red", "gray"), state="lying")  # fmt: skip
@from_pieces(foot=0.1)
def wall_plug(look: Look) -> Pieces:
    """A wall plug lying flat: a ribbed sleeve with a collar."""
    points = [(-0.016, 0.0046), (-0.014, 0.0046)]
    for k in range(8):
        points += [(-0.013 + 0.0036 * k, 0.0029), (-0.011 + 0.0036 * k, 0.0037)]
    return [(spindle(*points, (0.017, 0.0018), z=0.0042), plastic(look, "red", "gray", "brown",
                                                                  "white", "yellow"))]  # fmt: skip


@category("screw_eye", size=(0.042, 0.0184, 0.004), mass=0.003, material="metal",
          aliases=("eye screw", "eye bolt", "eyelet screw", "ring bolt", "hook screw"),
          themes=("workbench",), colors=("silver",), state="lying")  # fmt: skip
@from_pieces(foot=0.1, bodies=2)
def screw_eye(look: Look) -> Pieces:
    """A screw eye lying flat: a ring on the left and a threaded, pointed shank on the right."""
    steel = metal(look, "silver", "gold", "brass")
    ring = torus(0.0075, 0.0017, 22, 7).move(-0.008, 0, 0.0018)
    shank = spindle((0.0, 0.0017), (0.018, 0.0017), (0.024, 0.0004), z=0.0018)
    thread = spindle(
        *[(0.008 + 0.001 * k, 0.0021 - 0.0006 * (k % 2)) for k in range(13)], z=0.0021, sides=10
    )
    return [(ring, steel), (shank, steel), (thread, steel)]


@category("thumbtack", size=(0.0104, 0.0104, 0.0095), mass=0.0006, material="metal",
          aliases=("drawing pin", "tack", "brad", "single thumbtack", "carpet tack",
          "upholstery tack", "brass tack"), themes=("workbench",), colors=("gold",),
          state="lying")  # fmt: skip
@from_pieces(bodies=1)
def thumbtack(look: Look) -> Pieces:
    """A drawing pin lying on its flat head with its point up."""
    steel = metal(look, "gold", "silver", "brass", "red", "blue")
    head = standing((0.0042, 0), (0.0052, 0.0007), (0.004, 0.0012), sides=20)
    return [(head, steel), (standing((0.0006, 0.001), (0.00055, 0.007), (0.0001, 0.0095), sides=8),
                            shine(look))]  # fmt: skip


@category("staple", size=(0.0126, 0.0068, 0.0006), mass=0.0001, material="metal",
          aliases=("single staple", "wire staple", "loose staple"), themes=("workbench",),
          colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def staple(look: Look) -> Pieces:
    """One staple, lying on its side."""
    steel = metal(look, "silver", "gray", "gold")
    way = [(-0.006, -0.006), (-0.006, 0.0), (0.006, 0.0), (0.006, -0.006)]
    return [
        (at_box(0.0126, 0.0007, 0.0006), steel),
        *((at_box(0.0007, 0.0065, 0.0006, (x, -0.0033, 0)), steel) for x, _ in (way[0], way[3])),
    ]


@category("staple_strip", size=(0.05, 0.0126, 0.0064), mass=0.004, material="metal",
          aliases=("strip of staples", "staples", "box of staples"), themes=("workbench",),
          colors=("silver",), state="lying")  # fmt: skip
@vary()
@from_pieces()
def staple_strip(look: Look) -> Pieces:
    """A strip of staples with their legs down."""
    lines = surfaces.stripes([(206, 208, 212), (150, 152, 158)], 24, upright=True)
    top = at_box(0.05, 0.0126, 0.0008, (0, 0, 0.0056))
    sides = [at_box(0.05, 0.0008, 0.006, (0, s * 0.0059, 0)) for s in (-1, 1)]
    return [(top, lines), (sides[0], lines), (sides[1], lines)]


@category("hose_clip", size=(0.0403, 0.0507, 0.0101), mass=0.015, material="metal",
          aliases=("jubilee clip", "hose clamp", "pipe clip", "worm clip"), themes=("workbench",),
          colors=("silver",), state="lying")  # fmt: skip
@vary()
@from_pieces(bodies=2)
def hose_clip(look: Look) -> Pieces:
    """A hose clip lying flat: a slotted metal band bent into a ring, with a screw in a housing."""
    steel = metal(look, "silver", "silver", "gray")
    band = lathe([(0.019, 0), (0.02, 0), (0.02, 0.009), (0.019, 0.009)], 36, loop=True)
    box = at_block(0.014, 0.01, 0.01, 0.002, (0, 0.022, 0))
    screw = spindle((-0.012, 0.0032), (-0.008, 0.0042), (0.009, 0.003), z=0.0045).move(y=0.0255)
    slits = [
        at_box(0.0012, 0.0008, 0.006, (0.0202 * np.sin(a), -0.0202 * np.cos(a), 0.0015)).turn(2, 0)
        for a in np.linspace(-0.7, 0.7, 9)
    ]
    return [(band, steel), (box, steel), (screw, shine(look)), (join(slits), HOSE_CLIP_BLACK)]


@category("standoff", size=(0.022, 0.0064, 0.0056), mass=0.002, material="metal",
          aliases=("hex standoff", "threaded insert", "hex spacer", "brass standoff"),
          themes=("workbench",), colors=("brass",), state="lying")  # fmt: skip
@from_pieces(bodies=2)
def standoff(look: Look) -> Pieces:
    """A hexagonal metal standoff lying flat: a thin stud on the right and a hole on the left."""
    steel = metal(look, "brass", "silver", "gold")
    return [(spindle((-0.008, 0.0032), (0.008, 0.0032), sides=6, z=0.0028), steel),
            (spindle((0.008, 0.0016), (0.014, 0.0016), sides=10, z=0.0028), steel),
            (spindle((-0.0081, 0.0017), (-0.0079, 0.0017), z=0.0028), HOSE_CLIP_BLACK)]  # fmt: skip


VELCRO_STRAP_BLACK = surfaces.plain((34, 34, 37))


@category("cable_clip", size=(0.017, 0.00978, 0.0196), mass=0.002, material="plastic",
          aliases=("wire clip", "nail clip", "cable tack"), themes=("workbench",),
          colors=("white",), state="lying")  # fmt: skip
@from_pieces(bodies=2)
def cable_clip(look: Look) -> Pieces:
    """A cable clip: a small plastic block with an arch on top and an upright metal nail."""
    tile = plastic(look, "white", "black", "gray")
    body = at_block(0.016, 0.01, 0.008, 0.002)
    loop = (tube([(*p, 0.0) for p in arc((0, 0), 0.006, 0, np.pi, 10)], 0.0022,
                 7).turn(0, np.pi / 2).move(-0.001, 0, 0.008))  # fmt: skip
    nail = standing((0.0012, 0.0), (0.0012, 0.018), (0.0028, 0.019), (0.0028, 0.02), sides=10).move(
        x=0.0055
    )
    return [(body, tile), (loop, tile), (nail, shine(look))]


@category("velcro_strap", size=(0.09, 0.064, 0.02), mass=0.006, material="fabric",
          aliases=("hook and loop strap", "cable strap", "velcro tie", "velcro", "cable tie strap",
          "watch band strap"), themes=("workbench",), colors=("black",), state="lying")  # fmt: skip
@from_pieces(bodies=2)
def velcro_strap(look: Look) -> Pieces:
    """A hook-and-loop strap closed into a ring, with a buckle and a free end."""
    color = look.color("black", "blue", "red", "gray", "green")
    loop = lathe([(0.028, 0), (0.03, 0), (0.03, 0.018), (0.028, 0.018)], 40, loop=True)
    tail = at_box(0.06, 0.0022, 0.018, (0.03, -0.0295, 0)).turn(2, 0.08)
    buckle = at_block(0.008, 0.008, 0.02, 0.002, (0.0, -0.03, 0))
    return [(loop, surfaces.fabric(look.rng, color)), (tail, surfaces.fabric(look.rng, color)),
            (buckle, VELCRO_STRAP_BLACK)]  # fmt: skip


METALS = ("silver", "silver", "gold", "brass", "charcoal", "gray")


@category("screw", size=(0.0452, 0.0113, 0.0113), mass=0.008, material="metal", assembled=True,
          aliases=("wood screw", "metal screw", "loose screw", "self tapping screw",
          "self-tapping screw", "thumbscrew", "grub screw", "machine screw"), themes=("workbench",),
          roles=("flat",), colors=("silver", "gold"), state="lying flat")  # fmt: skip
def screw(look: Look) -> Shape:
    """A wood screw lying flat: a countersunk head with a cross recess, a thread and a point."""
    k = look.between(0.85, 1.3)
    color = look.color(*METALS)
    long, r = 0.04 * k, 0.0024 * k
    shank = lathe([(0, 0), (2.1 * r, 0), (2.1 * r, 0.0006), (r, 0.0035 * k), (r, 0.72 * long),
                   (0.2 * r, long), (0, long)], 12)  # fmt: skip
    a = np.linspace(0, 9 * 2 * np.pi, 72)
    t = a / a[-1]
    away = 0.95 * r * np.clip((1 - t) / 0.3, 0.15, 1)
    thread = tube(np.column_stack([away * np.cos(a), away * np.sin(a), 0.3 * long + 0.69 * long
                                   * t]), 0.00055 * k, 3)  # fmt: skip
    cross = [box(2.6 * r, 0.6 * r, 0.0004).turn(2, n * np.pi / 2).move(z=-0.0002) for n in (0, 1)]
    lean = np.arctan2(1.3 * r, long)
    lay = [lay_down(s).turn(1, lean) for s in (join([shank, thread]), join(cross))]
    low = min(float(s.bounds[0, 2]) for s in lay)
    body, mark = (s.move(x=-long / 2, z=-low) for s in lay)
    skin, dark = look.surface(color, "metal"), surfaces.plain(tint_color(color, 0.35))
    return shape([(body, skin), (mark, dark)], [flat_foot(body.vertices, 0.15)])


@category("nail", size=(0.0663, 0.00899, 0.00904), mass=0.006, material="metal", assembled=True,
          aliases=("iron nail",), themes=("workbench",), roles=("flat",), colors=("silver",),
          state="lying flat")  # fmt: skip
def nail(look: Look) -> Shape:
    """A nail lying flat: a flat head and a long point."""
    k = look.between(0.8, 1.25)
    color = look.color("silver", "gray", "charcoal", "silver", "bronze", "copper")
    long, r = 0.065 * k, 0.0017 * k
    one = lathe([(0, 0), (2.6 * r, 0), (2.6 * r, 0.0012 * k), (r, 0.002 * k), (r, 0.93 * long),
                 (0.1 * r, long), (0, long)], 12)  # fmt: skip
    body = lay_down(one).turn(1, np.arctan2(1.6 * r, long))
    body = body.move(x=-long / 2, z=-float(body.bounds[0, 2]))
    return shape([(body, look.surface(color, "metal"))], [flat_foot(body.vertices, 0.15)])


@category("bolt", size=(0.0376, 0.0206, 0.04), mass=0.035, material="metal", assembled=True,
          aliases=("hex bolt", "machine bolt", "threaded bolt", "wheel axle", "axle",
          "spoke nipple", "carriage bolt", "dental implant"), themes=("workbench",),
          colors=("silver",))  # fmt: skip
def bolt(look: Look) -> Shape:
    """A hexagon bolt with a nut on its thread, standing on its head or lying flat."""
    k = look.between(0.8, 1.4)
    color = look.color(*METALS)
    metal = look.surface(color, "metal")
    head = cylinder(0.0095 * k, 0.0065 * k, 6, bevel=0.0006)
    long, r = 0.042 * k, 0.005 * k
    rod = cylinder(r, long, 18, bevel=0.0008).move(z=0.006 * k)
    rings = [torus(r, 0.0007 * k, 16, 4).move(z=0.016 * k + 0.0016 * k * n) for n in range(19)]
    z = look.between(0.018, 0.034) * k
    nut = lathe([(0.9 * r, 0), (0.0093 * k, 0), (0.0093 * k, 0.0075 * k), (0.9 * r, 0.0075 * k)], 6,
                loop=True)  # fmt: skip
    pieces = [head, rod, *rings]
    if look.chance(0.6):
        pieces.append(nut.move(z=z))
    if look.chance(0.6):
        return shape([(join(pieces), metal)], [hull_of(head), cylinder_part(r, long + 0.006 * k),
                                               *([hull_of(pieces[-1])] if len(pieces) > 21
                                                 else [])])  # fmt: skip
    turned = [s.turn(2, np.pi / 6).turn(1, np.pi / 2) for s in pieces]
    low = float(turned[0].bounds[0, 2])
    lean = np.arctan2(-low - r - 0.0006 * k, long)
    turned = [s.turn(1, lean) for s in turned]
    low = min(float(s.bounds[0, 2]) for s in turned)
    turned = [s.move(x=-0.5 * long, z=-low) for s in turned]
    return shape([(join(turned), metal)], [flat_foot(turned[0].vertices, 0.12),
                                           flat_foot(turned[1].vertices, 0.12)])  # fmt: skip


@category("nut", size=(0.0197, 0.0213, 0.00567), mass=0.01, material="metal", assembled=True,
          aliases=("hex nut", "metal nut", "hexagon nut", "square nut", "wing nut"),
          themes=("workbench",), roles=("flat",), colors=("silver",),
          state="lying flat")  # fmt: skip
def nut(look: Look) -> Shape:
    """A hexagon nut or a washer, lying flat."""
    k = look.between(0.8, 1.4)
    color = look.color(*METALS)
    metal = look.surface(color, "metal")
    one = lathe([(0.0052, 0), (0.0085, 0), (0.0095, 0.0008), (0.0095, 0.0072), (0.0085, 0.008),
                 (0.0052, 0.008)], 6, loop=True).scale(k, k, k)  # fmt: skip
    ring = lathe([(0.0055, 0), (0.011, 0), (0.011, 0.0015), (0.0055, 0.0015)], 28, loop=True).scale(
        k, k, k
    )
    if look.chance(0.75):
        flat = float(np.cos(np.pi / 6))
        return shape([(one, metal)], ring_parts(
            [(0.0095 * flat * k, 0), (0.0095 * flat * k, 0.008 * k)],
            [(0.0052 * k, 0.008 * k), (0.0052 * k, 0)], 8))  # fmt: skip
    return shape([(ring, metal)], ring_parts([(0.011 * k, 0), (0.011 * k, 0.0015 * k)],
                                             [(0.0055 * k, 0.0015 * k), (0.0055 * k, 0)],
                                             8))  # fmt: skip


WASHER_METALS = ("silver", "silver", "brass", "charcoal", "gray", "copper")


@category("washer", size=(0.0245, 0.0245, 0.0017), mass=0.004, material="metal",
          aliases=("metal washer", "flat washer", "steel washer", "metal ring", "bike washer",
          "cleat", "spacer ring"), themes=("workbench",), roles=("flat", "round"),
          colors=("silver",))  # fmt: skip
def washer(look: Look) -> Shape:
    """A flat metal washer."""
    k = look.between(0.85, 1.3)
    r, hole, h = 0.0115 * k, 0.0055 * k, 0.0017
    body = lathe([(hole, 0), (r, 0), (r, h), (hole, h)], 32, loop=True)
    return shape([(body, look.surface(look.color(*WASHER_METALS), "metal"))],
                 ring_parts([(r, 0), (r, h)], [(hole, h), (hole, 0)], 8))  # fmt: skip


@category("circlip", size=(0.027, 0.027, 0.0024), mass=0.002, material="metal",
          aliases=("retaining ring", "snap ring", "c clip", "piston ring"), themes=("workbench",),
          colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def circlip(look: Look) -> Pieces:
    """A circlip lying flat: an open metal ring with a lug on each side of its gap."""
    steel = metal(look, "silver", "charcoal")
    a = np.linspace(-1.25, np.pi + 1.25, 40)
    way = np.column_stack([0.012 * np.cos(a), 0.012 * np.sin(a), 0 * a + 0.0012])
    ears = [at_block(0.005, 0.004, 0.0022, 0.0018, (s * 0.0042, -0.0118, 0)) for s in (-1, 1)]
    return [(tube(way, 0.0016, 6, squash=0.75), steel), (join(ears), steel)]


@category("turnbuckle", size=(0.168, 0.0251, 0.0116), mass=0.12, material="metal", assembled=True,
          aliases=("wire tensioner", "rigging screw"), themes=("workbench",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.08)
def turnbuckle(look: Look) -> Pieces:
    """A turnbuckle lying flat: two bars between end blocks and an eye bolt at each end."""
    steel = metal(look, "silver", "gray")
    frame = [
        straight((-0.035, s * 0.009, 0.007), (0.035, s * 0.009, 0.007), 0.003, 8) for s in (-1, 1)
    ]
    ends = [at_block(0.014, 0.024, 0.012, 0.004, (s * 0.036, 0, 0.001)) for s in (-1, 1)]
    bolts = [straight((s * 0.015, 0, 0.007), (s * 0.065, 0, 0.007), 0.0034, 8) for s in (-1, 1)]
    eyes = [torus(0.01, 0.003, 20, 7).move(s * 0.074, 0, 0.0068) for s in (-1, 1)]
    return [(join([*frame, *ends]), steel), (join(bolts), shine(look)), (eyes[0], steel),
            (eyes[1], steel)]  # fmt: skip


CATEGORIES = (
    Category("dowel", _rod(0.008, 0.24, WOODEN, "wood"), size=(0.238, 0.0159, 0.0159), mass=0.03,
             material="wood", aliases=("wooden dowel", "wooden rod", "stick", "wooden stick",
             "dowel rod", "relay baton", "walking cane", "walking stick", "trekking pole",
             "tent pole", "barber pole", "niddy noddy", "drop spindle", "metal shaft", "shaft",
             "spoke", "mahl stick", "long stick", "stretcher bar"), themes=("workbench",),
             colors=("wooden",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
