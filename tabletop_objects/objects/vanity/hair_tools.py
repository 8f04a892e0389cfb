"""Objects of the ``vanity`` theme: hair tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse, smooth
from ...kit.parts import box_part, hull_of, hull_part, ring_parts
from ...kit.primitives import ball, lay_down, rod, straight
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, prism, tube
from ...kit.surfaces import Look, tint_color


@category("wig", size=(0.185, 0.186, 0.171), mass=0.2, material="fabric",
          aliases=("toupee", "hairpiece", "clown wig", "fancy dress wig"), themes=("vanity",),
          roles=("big",), colors=("brown",))  # fmt: skip
def wig(look: Look) -> Shape:
    """A wig standing upright: a cap of long, wavy, parted hair."""
    color = look.color("brown", "black", "yellow", "orange", "pink", "gray", "red")
    k = look.between(0.85, 1.05)
    long = look.between(0.06, 0.12)
    cap = ball(0.15, 0.17, 0.14, (0, 0.005, long + 0.02), 22)
    cap = cap.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], long - 0.01)]))
    locks = []
    for n in range(17):
        a = -0.5 * np.pi + 0.5 + n * (2 * np.pi - 1.0) / 16
        x, y = float(np.cos(a)), float(np.sin(a))
        wave = 0.006 * (-1) ** n
        path = [(0.03 * x, 0.03 * y, long + 0.085), (0.066 * x, 0.075 * y, long + 0.055),
                (0.078 * x + wave, 0.088 * y, 0.6 * long),
                (0.08 * x - wave, 0.09 * y, 0.012)]  # fmt: skip
        locks.append(rod(path, [0.006, 0.014, 0.015, 0.01], 7, 3))
    fringe = [rod([(x, -0.02, long + 0.088), (1.2 * x, -0.07, long + 0.066),
                   (1.25 * x, -0.083, long + 0.035)], [0.008, 0.013, 0.005], 7, 3)
              for x in (-0.045, -0.022, 0.0, 0.022, 0.045)]  # fmt: skip
    hair = surfaces.stripes(
        [color, tint_color(color, 0.8), tint_color(color, 1.15)], 5, upright=True
    )
    return put_down([(join([cap, *locks, *fringe]), hair)], cap, join(locks), factor=k)


HUES = ("pink", "black", "red", "teal", "purple", "gold", "navy", "white", "brown")


@category("hair_clip", size=(0.06, 0.05, 0.05), mass=0.015, material="plastic", assembled=True,
          aliases=("claw clip", "hairclip", "hair claw", "barrette", "hair slide",
          "barber's cape clip"), themes=("vanity",), colors=("pink", "black"))  # fmt: skip
def hair_clip(look: Look) -> Shape:
    """A hair claw clip lying with its teeth down, or a clip with a flower."""
    color = look.color(*HUES)
    k = look.between(0.85, 1.25)
    teeth: list[Solid] = []
    for s in (-1, 1):
        for n in range(6):
            x = 0.009 * (n - 2.5)
            teeth.append(rod([(x, s * 0.006, 0.03), (x, s * 0.02, 0.018), (x, s * 0.012, 0.001)],
                             [0.0038, 0.0034, 0.0016], 7))  # fmt: skip
    bars = [
        straight((-0.026, s * 0.014, 0.026), (0.026, s * 0.014, 0.026), 0.0045, 8) for s in (-1, 1)
    ]
    wings = [ball(0.032, 0.006, 0.02, (0, 0, 0), 12).turn(0, s * 0.6).move(0, s * 0.009, 0.041)
             for s in (-1, 1)]  # fmt: skip
    spring = straight((-0.014, 0, 0.031), (0.014, 0, 0.031), 0.0045, 10)
    skin = surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.1)
    pieces: Pieces = [(join([*teeth, *bars, *wings]), skin),
                      (spring, surfaces.plain((200, 202, 206)))]  # fmt: skip
    return put_down(pieces, join([*teeth, *bars]), join(wings), factor=k)


@category("hair_tie", size=(0.0872, 0.0858, 0.0254), mass=0.006, material="fabric",
          aliases=("scrunchie", "hair elastic", "hair scrunchie", "hair bobble", "hair extension"),
          themes=("vanity",), roles=("flat",), colors=("pink", "black"),
          state="lying flat")  # fmt: skip
def hair_tie(look: Look) -> Shape:
    """A scrunchie of gathered cloth, lying flat."""
    color = look.color(*HUES, "mustard", "sage")
    r = look.between(0.026, 0.036)
    n, m = 44, 8
    rings = []
    for k in range(n):
        a = 2 * np.pi * k / n
        grow = 0.011 * (1 + 0.28 * np.sin(11 * a) + 0.12 * np.sin(5 * a + 1))
        b = 2 * np.pi * np.arange(m) / m
        away = r + grow * np.cos(b)
        rings.append(np.column_stack([away * np.cos(a), away * np.sin(a), grow * np.sin(b) + 0.01]))
    body = loft(np.stack(rings), None, loop=True)
    cloth = surfaces.stripes([color, tint_color(color, 0.78), color], 22, side=128)
    wall = ring_parts([(r + 0.01, 0), (r + 0.011, 0.018)], [(r - 0.009, 0.018), (r - 0.009, 0)], 8)
    return shape([(body, cloth)], wall)


@category("headband", size=(0.15, 0.105, 0.02), mass=0.03, material="fabric", assembled=True,
          aliases=("hairband", "alice band", "head band", "reindeer antlers", "snorkel band",
          "sweat headband"), themes=("vanity",), colors=("pink", "black"),
          state="lying flat")  # fmt: skip
def headband(look: Look) -> Shape:
    """A headband lying flat: a stiff arch, sometimes with a bow."""
    color = look.color(*HUES)
    k = look.between(0.9, 1.1)
    a = np.linspace(-0.35, np.pi + 0.35, 22)
    path = np.column_stack([0.066 * np.cos(a), 0.07 * np.sin(a), np.full(22, 0.0092)])
    flat = tube(path, 0.009, 8)
    pieces: Pieces = [(flat, surfaces.fabric(look.rng, color))]
    bow = [ball(0.03, 0.016, 0.02, (0.042 + s * 0.014 * 0.7, 0.054 - s * 0.014, 0.014), 10)
           for s in (-1, 1)]  # fmt: skip
    if look.chance(0.6):
        knot = ball(0.012, 0.012, 0.016, (0.042, 0.054, 0.015), 8)
        pieces.append((join([*bow, knot]), surfaces.plain(look.own_color("white", "gold", "red"))))
    v = flat.vertices
    parts = [hull_part(v[(v[:, 0] < -0.03)]), hull_part(v[(v[:, 0] > 0.03)]),
             hull_part(v[(np.abs(v[:, 0]) < 0.04) & (v[:, 1] > 0.03)])]  # fmt: skip
    return shape(pieces, parts).scale(k)


@category("bobby_pin", size=(0.0644, 0.00789, 0.00263), mass=0.001, material="metal",
          aliases=("hair pin", "hairpin", "hair grip", "kirby grip"), themes=("vanity",),
          colors=("black",), state="lying flat")  # fmt: skip
def bobby_pin(look: Look) -> Shape:
    """A hair grip lying flat: a bent wire with one wavy leg."""
    color = look.color("black", "brown", "gold", "silver", "copper", "pink")
    path = smooth([(0.026, 0.0022, 0.001), (0.012, 0.003, 0.001), (0.004, 0.0012, 0.001),
                   (-0.004, 0.003, 0.001), (-0.012, 0.0012, 0.001), (-0.024, 0.0022, 0.001),
                   (-0.0275, 0.0, 0.001), (-0.024, -0.0024, 0.001), (0.028, -0.0012, 0.001)],
                  3)  # fmt: skip
    wire = tube(path, 0.0009, 6)
    tips = [ball(0.003, 0.003, 0.0026, (x, y, 0.0011), 8) for x,
            y in ((0.026, 0.0022), (0.028, -0.0012))]  # fmt: skip
    return put_down([(join([wire, *tips]), look.surface(color, "metal"))],
                   factor=look.between(0.85, 1.3))  # fmt: skip


@category("hair_roller", size=(0.063, 0.039, 0.038), mass=0.012, material="plastic",
          aliases=("hair curler", "curler", "velcro roller"), themes=("vanity",),
          colors=("pink", "purple"), state="lying")  # fmt: skip
def hair_roller(look: Look) -> Shape:
    """A hair roller lying flat: a perforated tube with rings at its ends."""
    color = look.color("pink", "purple", "green", "blue", "yellow", "red")
    r, long = look.between(0.014, 0.022), look.between(0.058, 0.068)
    body = lathe(
        [(0.8 * r, -long / 2), (r, -long / 2), (r, long / 2), (0.8 * r, long / 2)], 24, loop=True
    )
    rims = [lathe([(0.78 * r, z), (1.1 * r, z), (1.1 * r, z + 0.004), (0.78 * r, z + 0.004)], 24,
                  loop=True) for z in (-long / 2, long / 2 - 0.004)]  # fmt: skip
    whole = [(s.turn(1, np.pi / 2).move(z=1.08 * r), t) for s, t in (
        (body, prints.mesh_holes(color, tint_color(color, 0.4), 10, 14)),
        (join(rims), surfaces.plain(tint_color(color, 0.85))))]  # fmt: skip
    return put_down(whole, join([s for s, _ in whole]))


def _cord(x: float, z: float) -> Solid:
    """Return a short power cord that runs to the right from (x, 0, z)."""
    return rod([(x, 0, z), (x + 0.02, 0, z - 0.004), (x + 0.045, 0.02, 0.0035),
                (x + 0.03, 0.05, 0.0032), (x, 0.058, 0.0032)], 0.003, 7)  # fmt: skip


@category("curling_iron", size=(0.31, 0.08, 0.04), mass=0.3, material="plastic",
          aliases=("curling tongs", "curling wand", "hair tongs"), themes=("vanity",),
          colors=("black", "pink"), state="lying")  # fmt: skip
def curling_iron(look: Look) -> Shape:
    """A curling iron lying flat: a metal rod with a clip, a grip and a cord."""
    color = look.color("black", "pink", "purple", "white", "teal", "red")
    rod_ = straight((-0.15, 0, 0.0165), (0.0, 0, 0.0165), 0.0105, 16)
    tip = straight((-0.165, 0, 0.0165), (-0.149, 0, 0.0165), [0.006, 0.0095], 14)
    clip = rod(
        [(-0.135, 0, 0.0265), (-0.05, 0, 0.0275), (0.0, 0, 0.0285), (0.02, 0, 0.04)], 0.0045, 8
    )
    grip = straight((0.0, 0, 0.0165), (0.12, 0, 0.015), [0.0165, 0.0145], 18)
    ring = straight((-0.002, 0, 0.0165), (0.006, 0, 0.0165), 0.0172, 18)
    metal = surfaces.brushed_metal(look.rng, look.pick([(200, 204, 210), (206, 172, 96)]))
    dark = surfaces.plain((46, 46, 50))
    pieces: Pieces = [(join([rod_, clip]), metal), (join([tip, ring, _cord(0.118, 0.015)]), dark),
                      (grip, look.surface(color, "plastic"))]  # fmt: skip
    return put_down(pieces, rod_, grip, factor=look.between(0.85, 1.05))


@category("hair_straightener", size=(0.28, 0.08, 0.06), mass=0.35, material="plastic",
          aliases=("straightener", "flat iron", "hair iron", "straightening iron",
          "hair straighteners"), themes=("vanity",), colors=("black", "pink"),
          state="lying")  # fmt: skip
def hair_straightener(look: Look) -> Shape:
    """An open hair straightener lying flat: two hinged arms with plates."""
    color = look.color("black", "pink", "purple", "white", "gold", "teal")
    low = block(0.24, 0.03, 0.014, 0.008, 0.003)
    up = block(0.24, 0.03, 0.014, 0.008, 0.003).move(-0.12).turn(1, 0.14).move(0.12, 0, 0.0135)
    plates = [
        box(0.085, 0.024, 0.002).move(-0.07, 0, 0.0135),
        box(0.085, 0.024, 0.002).move(-0.19, 0, -0.0015).turn(1, 0.14).move(0.12, 0, 0.0135),
    ]
    hinge = cylinder(0.012, 0.032, 16).move(z=-0.016).turn(0, np.pi / 2).move(0.112, 0, 0.0125)
    knob = cylinder(0.005, 0.003, 12).move(0.03, 0, 0.0138)
    dark = surfaces.plain((48, 48, 52))
    pieces: Pieces = [(join([low, up]), look.surface(color, "plastic")),
                      (join(plates), surfaces.brushed_metal(look.rng, (190, 160, 130))),
                      (join([hinge, knob, _cord(0.12, 0.01)]), dark)]  # fmt: skip
    return put_down(pieces, low, up, factor=look.between(0.9, 1.08))


@category("hair_dryer", size=(0.205, 0.185, 0.073), mass=0.5, material="device",
          aliases=("hairdryer", "blow dryer", "blowdryer"), themes=("vanity",),
          colors=("black", "pink"), state="lying flat", common=True)  # fmt: skip
def hair_dryer(look: Look) -> Shape:
    """A hair dryer lying on its side with its nozzle towards +x."""
    k = look.between(0.92, 1.1)
    color = look.color("black", "pink", "white", "red", "teal", "purple", "charcoal")
    shell = surfaces.speckles(look.rng, color, 4)
    r = 0.036 * k
    barrel = lathe(
        [(0, 0), (0.7 * r, 0), (r, 0.02 * k), (r, 0.075 * k), (0.76 * r, 0.14 * k),
         (0.72 * r, 0.16 * k), (0.66 * r, 0.16 * k), (0, 0.15 * k)],
        26,
    )  # fmt: skip
    nozzle = lathe([(0, 0.152 * k), (0.76 * r, 0.152 * k), (0.6 * r, 0.2 * k), (0.5 * r, 0.2 * k),
                    (0, 0.18 * k)], 24).scale(1, 1.25, 1)  # fmt: skip
    grille = lay_down(cylinder(0.72 * r, 0.003, 24), -0.082 * k, r)
    grip = tube([(-0.03 * k, 0, 0.8 * r), (-0.024 * k, -0.07 * k, 0.6 * r),
                 (-0.03 * k, -0.14 * k, 0.5 * r)], [0.5 * r, 0.46 * r, 0.48 * r], 14)  # fmt: skip
    switch = box(0.012, 0.026, 0.004).move(-0.026 * k, -0.075 * k, 1.05 * r)
    keel = box(0.08 * k, 0.9 * r, 0.5 * r).move(x=-0.025 * k)
    trim = surfaces.plain(look.own_color("silver", "black", "gold", "charcoal"))
    body = lay_down(barrel, -0.08 * k, r)
    tip = lay_down(nozzle, -0.08 * k, r)
    return shape(
        [(join([body, grip, keel]), shell), (tip, trim), (switch, trim),
         (grille, prints.mesh_holes((70, 72, 76), (16, 16, 18), 9, 9))],
        [hull_of(body, keel), hull_of(tip), hull_of(grip, keel)],
    )  # fmt: skip


@category("hairbrush", size=(0.23, 0.07, 0.03), mass=0.1, material="wood", aliases=("paddle brush",
          "brush", "round brush", "hot brush", "detangling brush", "baby brush"),
          themes=("vanity",), roles=("flat",), colors=("black", "pink"), state="lying flat",
          common=True)  # fmt: skip
def hairbrush(look: Look) -> Shape:
    """A paddle brush lying on its back with its bristles up."""
    wood = look.surface(look.color("black", "pink", "wooden", "teal", "cream"), "plastic")
    pad = surfaces.grid((60, 52, 58), (196, 150, 160), 12, 8, 96, 2)
    head = prism(ellipse(0.105, 0.07, 24), 0, 0.014, 0.004).move(x=-0.06)
    grip = prism(
        [(-0.03, -0.013), (0.03, -0.009), (0.105, -0.013), (0.118, 0), (0.105, 0.013),
         (0.03, 0.009), (-0.03, 0.013)],
        0, 0.013,
    )  # fmt: skip
    bristles = prism(ellipse(0.084, 0.05, 20), 0.013, 0.03, 0.006).move(x=-0.06)
    return shape(
        [(head, wood), (grip, wood), (bristles, pad)],
        [hull_of(head), hull_of(bristles), box_part(0.15, 0.02, 0.013, (0.043, 0, 0))],
    )


@category("comb", size=(0.17, 0.032, 0.004), mass=0.018, material="plastic",
          aliases=("hair comb", "pocket comb", "barber comb"), themes=("vanity",), roles=("flat",),
          colors=("black",), state="lying flat")  # fmt: skip
def comb(look: Look) -> Shape:
    """A comb lying flat, with one row of coarse and fine teeth, or with a handle."""
    long, wide = look.between(0.15, 0.19), look.between(0.028, 0.036)
    color = look.color("black", "black", "bronze", "pink", "sky", "wooden", "red", "white")
    skin = look.surface(color, "plastic")
    t = 0.004
    handle = look.chance(0.4)
    span = 0.62 * long if handle else long
    spine = block(long, 0.011, t, 0.0054).move(y=wide / 2 - 0.0055)
    if handle:
        spine = join([spine, block(long - span + 0.01, 0.017, t, 0.008).move(
            x=span / 2, y=wide / 2 - 0.0085)])  # fmt: skip
    teeth = []
    x = -long / 2 + 0.006
    stop = -long / 2 + span - 0.006
    while x < stop:
        fine = x > -long / 2 + 0.5 * span
        teeth.append(
            box(0.0012 if fine else 0.0018, wide - 0.008, 0.7 * t).move(x, -0.004, 0.15 * t)
        )
        x += 0.0026 if fine else 0.0042
    ends = [box(0.006, wide - 0.003, t).move(u, -0.0015) for u in (-long / 2 + 0.003, -long / 2
                                                                   + span - 0.003)]  # fmt: skip
    return shape(
        [(join([spine, *teeth, *ends]), skin)],
        [box_part(span, wide, t, (-long / 2 + span / 2, 0, 0)), hull_of(spine)],
    )
