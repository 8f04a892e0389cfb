"""Objects of the ``workbench`` theme: electronics."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, STEEL_TONE, dye, plastic, shine, steel
from ...kit.outlines import ellipse, smooth
from ...kit.parts import above, box_part, cylinder_part, flat_foot, hull_of
from ...kit.primitives import at_block, at_box, disc, drum, facing, lay_down, rod, spindle
from ...kit.shapes import Category, Drawing, Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import block, box, cylinder, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, plain, tint_color


@category("battery", size=(0.0242, 0.0209, 0.0506), mass=0.05, material="metal", assembled=True,
          aliases=("aa battery", "aaa battery", "batteries", "9v battery", "d battery",
          "alkaline battery", "d cell", "c cell", "aa cell", "pack of batteries"),
          themes=("workbench", "office"), colors=("black", "gold"))  # fmt: skip
def battery(look: Look) -> Shape:
    """An upright, round AA or AAA cell, or a rectangular 9 V block."""
    color = look.color("black", "gold", "green", "red", "blue", "orange", "silver", "yellow")
    steel = surfaces.plain((200, 202, 208))
    other = look.pick([(200, 150, 80), (206, 208, 212), (40, 40, 44), (230, 190, 60)])
    image = prints.canvas(128, 96, color)
    prints.fill(image, 0, 0, 1, 0.3, other)
    prints.write(image[:, 44:84], look.pick(["AA", "1.5V", "POWER", "ALKA"]), 0.5, 0.6, 0.2,
                 (250, 250, 248) if sum(color) < 400 else (30, 30, 34), bold=True)  # fmt: skip
    if look.chance(0.75):
        r, h = look.pick([(0.00725, 0.0505), (0.0165, 0.06), (0.013, 0.05)])
        body = lathe([(0, 0), (0.9 * r, 0), (r, 0.001), (r, 0.955 * h), (0.86 * r, 0.96 * h),
                      (0.4 * r, 0.962 * h), (0.38 * r, h), (0, h)], 24,
                     v=[0, 0, 0.02, 0.93, 0.95, 0.97, 0.99, 1])  # fmt: skip
        tile = surfaces.stack((steel, 2), (image, 91), (steel, 7), side=128)
        return shape([(body, tile)], [cylinder_part(r, 0.955 * h), cylinder_part(0.36 * r, h)])
    x, y, h = 0.0265, 0.0175, 0.0455
    body = block(x, y, h, 0.002, 0.0005)
    snaps = [cylinder(0.003, 0.0025, 12).move(x=-0.0063, z=h),
             lathe([(0, 0), (0.0042, 0), (0.0044, 0.0025), (0.003, 0.0025), (0.003, 0.001),
                    (0, 0.001)], 6).move(x=0.0063, z=h)]  # fmt: skip
    panel = box(x, 0.0004, 0.9 * h).move(y=-y / 2 - 0.0001, z=0.05 * h)
    front = image[:, 34:94].copy()
    return shape([(body, surfaces.plain(color)), (panel, front), (join(snaps), steel)],
                 [box_part(x, y, h), hull_of(*snaps)])  # fmt: skip


@category("light_bulb", size=(0.105, 0.0577, 0.0576), mass=0.045, material="glass", assembled=True,
          aliases=("lightbulb", "bulb", "led bulb", "lamp bulb", "incandescent bulb"),
          themes=("workbench",), colors=("white", "amber"), state="lying down")  # fmt: skip
def light_bulb(look: Look) -> Shape:
    """A light bulb lying on its side: clear, white or amber glass with a screw base."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "white", "amber", "clear", "golden", "sky")
    t = np.linspace(0.16 * np.pi, np.pi, 12)
    ball = [(0.03 * k * np.sin(a), 0.078 * k - 0.03 * k * np.cos(a) * 1.02) for a in t]
    ball[-1] = (0.0, ball[-1][1])
    glass = lathe([(0, 0.026 * k), (0.0125 * k, 0.026 * k), (0.014 * k, 0.036 * k), *ball], 26)
    a = np.linspace(0, 4 * 2 * np.pi, 40)
    thread = tube(np.column_stack([0.0132 * k * np.cos(a), 0.0132 * k * np.sin(a),
                                   0.007 * k + 0.017 * k * a / a[-1]]), 0.0012 * k, 5)  # fmt: skip
    base = lathe([(0, 0), (0.004, 0), (0.006, 0.004), (0.0128 * k, 0.006 * k),
                  (0.0128 * k, 0.027 * k), (0, 0.027 * k)], 22)  # fmt: skip
    down = [s.turn(1, np.pi / 2 + np.arctan2(0.0155, 0.095)).move(x=-0.05 * k)
            for s in (glass, thread, base)]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s in down)
    glass, thread, base = (s.move(z=-low) for s in down)
    shine = surfaces.gradient(tint_color(color, 1.05), tint_color(color, 1.3), look.rng, 2)
    metal = surfaces.plain((190, 188, 182))
    return shape([(glass, shine), (join([thread, base]), metal)],
                 [hull_of(base, thread), flat_foot(glass.vertices, 0.08)])  # fmt: skip


DARK: RGB = (32, 32, 35)
WALKIE_TALKIE_DARK = (40, 41, 45)


@category("walkie_talkie", size=(0.06, 0.038, 0.183), mass=0.19, material="device",
          aliases=("walkie-talkie", "two-way radio", "hand radio"), themes=("workbench",),
          roles=("tall",), colors=("black", "yellow"), common=True)  # fmt: skip
def walkie_talkie(look: Look) -> Shape:
    """A walkie-talkie standing upright, with a speaker grille, a display and an antenna."""
    x, y, z = look.between(0.055, 0.062), look.between(0.032, 0.038), look.between(0.1, 0.115)
    color = look.color("black", "yellow", "red", "olive", "blue", "orange", "gray", "teal")
    shell, dark = surfaces.speckles(look.rng, color, 3, 32), surfaces.plain(WALKIE_TALKIE_DARK)
    body = block(x, y, z, 0.01, 0.003)
    grille = box(x * 0.7, 0.002, z * 0.34).move(y=-y / 2 - 0.0005, z=0.1 * z)
    view = box(x * 0.6, 0.002, z * 0.18).move(y=-y / 2 - 0.0005, z=0.68 * z)
    screen = prints.canvas(64, 32, (150, 190, 150))
    prints.write(screen, f"CH {int(look.rng.integers(1, 23))}", 0.5, 0.5, 0.5, (30, 50, 30))
    antenna = cylinder(0.007, 0.075, 14, top=0.0055, bevel=0.001).move(x=-0.3 * x, z=z)
    knob = cylinder(0.0075, 0.013, 14, bevel=0.001).move(x=0.25 * x, z=z)
    button = box(0.004, 0.014, 0.03).move(x=-x / 2 - 0.001, z=0.55 * z)
    return shape([(body, shell), (grille, prints.mesh_holes((70, 70, 74), (20, 20, 22), 7, 7)),
                  (view, screen), (antenna, dark), (knob, dark), (button, dark)],
                 [box_part(x, y, z), cylinder_part(0.007, 0.075, (-0.3 * x, 0, z)),
                  cylinder_part(0.0075, 0.013, (0.25 * x, 0, z))])  # fmt: skip


@category("cable_reel", size=(0.173, 0.112, 0.2), mass=1.2, material="plastic", assembled=True,
          aliases=("extension reel", "cord reel", "extension cable reel", "cable drum",
          "extension lead", "extension cable"), themes=("workbench",), roles=("big",),
          colors=("orange",))  # fmt: skip
def cable_reel(look: Look) -> Shape:
    """An extension cable on a reel in an upright frame."""
    k = look.between(0.85, 1.0)
    color = look.color("orange", "red", "blue", "yellow", "black", "green")
    r, wide = 0.09 * k, 0.085 * k
    z = r + 0.012 * k
    discs = [facing(cylinder(r, 0.006 * k, 36)).move(y=y, z=z) for y in (-wide / 2 + 0.006 * k,
                                                                         wide / 2)]  # fmt: skip
    coil = facing(cylinder(0.8 * r, wide - 0.01 * k, 30)).move(y=wide / 2 - 0.004 * k, z=z)
    cord = surfaces.stripes([tint_color(color, 0.5), (40, 40, 42)], 14)
    face = prism(ellipse(0.9 * r, 0.9 * r, 28), 0, 0.004)
    face = facing(face).move(y=-wide / 2, z=z)
    sockets = [facing(cylinder(0.018 * k, 0.004, 18)).move(0.024 * k * np.cos(a), -wide / 2 - 0.003,
               z + 0.024 * k * np.sin(a))
                   for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    holes = [facing(cylinder(0.0026 * k, 0.001, 8)).move(0.024 * k * np.cos(a) + s * 0.006 * k,
             -wide / 2 - 0.0068, z + 0.024 * k * np.sin(a)) for s in (-1, 1)
             for a in np.pi / 2 + np.arange(3) * 2 * np.pi / 3]  # fmt: skip
    rails = [tube(smooth([(-0.09 * k, y, 0.0055 * k), (0.09 * k, y, 0.0055 * k), (0.06 * k, y, z),
                          (0.02 * k, y, 2 * z + 0.015 * k), (-0.02 * k, y, 2 * z + 0.015 * k),
                          (-0.06 * k, y, z), (-0.09 * k, y, 0.0055 * k)], 2), 0.0052 * k, 8)
             for y in (-wide / 2 - 0.014 * k, wide / 2 + 0.01 * k)]  # fmt: skip
    grip = facing(cylinder(0.008 * k, wide + 0.034 * k, 14)).move(
        y=wide / 2 + 0.015 * k, z=2 * z + 0.014 * k)  # fmt: skip
    low = max(min(float(s.bounds[0, 2]) for s in rails), 0.0)
    feet = [box_part(0.18 * k, 0.01 * k, 0.0104 * k, (0, y, low)) for y in
            (-wide / 2 - 0.014 * k, wide / 2 + 0.01 * k)]  # fmt: skip
    return shape([(join(discs), look.surface(color, "plastic")), (coil, cord),
                  (face, surfaces.plain(DARK)), (join(sockets), surfaces.plain((90, 92, 96))),
                  (join(holes), surfaces.plain((16, 16, 18))),
                  (join([*rails, grip]), surfaces.plain((52, 52, 56)))],
                 [*feet, hull_of(*discs, coil), hull_of(grip),
                     *(hull_of(r_.bend(above)) for r_ in rails)])  # fmt: skip


@category("wall_socket", size=(0.0865, 0.0865, 0.0324), mass=0.12, material="plastic",
          aliases=("plug socket", "power outlet", "electrical outlet", "outlet", "wall outlet",
          "electric socket", "socket"), themes=("workbench",), colors=("white",))  # fmt: skip
def wall_socket(look: Look) -> Shape:
    """A wall socket with a switch, lying on its back."""
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
    rock = (at_box(0.012, 0.018, 0.004, (0.024, 0.028, 0.029)) if look.chance(0.7)
            else at_box(0.01, 0.01, 0.001, (0, 0.03, 0.0294)))  # fmt: skip
    return put_down([(join([box_, slab, rock]), plain(color)), (join(holes), plain((74, 76, 82))),
                     (join(extra), plain((30, 30, 34))), (join(screws), steel(look))], box_, slab,
                    factor=k)  # fmt: skip


@category("mains_plug", size=(0.09, 0.134, 0.0261), mass=0.07, material="plastic", assembled=True,
          aliases=("electric plug", "three-pin plug"), themes=("workbench",),
          colors=("black", "white"))  # fmt: skip
def mains_plug(look: Look) -> Shape:
    """A mains plug with a piece of its cord, lying flat."""
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
    cord = rod([(0, -0.038, 0.012), (0.004, -0.065, 0.006), (0.03, -0.085, 0.0035),
                (0.065, -0.07, 0.0035)], 0.0034, 8)  # fmt: skip
    return put_down([(join([body, relief, cord]), plain(color)),
                     (join(pins), steel(look, look.pick([STEEL_TONE, BRASS_TONE])))], body,
                    join(pins), cord, factor=k)  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("power_plug", size=(0.102, 0.105, 0.0435), mass=0.06, material="plastic", assembled=True,
          aliases=("uk plug", "electrical plug", "three pin plug", "wall socket plug",
          "plug with a cord"), themes=("workbench",), colors=("white",), state="lying")  # fmt: skip
@from_pieces(bodies=2)
def power_plug(look: Look) -> Pieces:
    """A three-pin plug with a short cord, lying on its back."""
    shell = plastic(look, "white", "black", "gray")
    body = at_block(0.05, 0.05, 0.022, 0.01)
    pins = [
        at_box(0.0065, 0.004, 0.017, (x, y, 0.021)) for x, y in ((-0.011, -0.008), (0.011, -0.008))
    ] + [at_box(0.004, 0.008, 0.022, (0, 0.013, 0.021))]
    cord = rod([(0, -0.024, 0.008), (0, -0.05, 0.005), (0.03, -0.075, 0.004),
                (0.075, -0.06, 0.004)], 0.0038, 8, 6)  # fmt: skip
    return [(body, shell), (join(pins), shine(look, "gold", "brass")), (cord, shell)]


def _schuko(kind: str) -> Drawing:
    """A small mains plug on a curled cord."""

    def draw(look: Look) -> Pieces:
        z = 0.008
        cord = rod([(-0.03, 0, z), (-0.05, 0.0, 0.004), (-0.08, 0.02, 0.003), (-0.06, 0.045, 0.003),
                    (-0.02, 0.04, 0.003)], 0.0028, 8, 6)  # fmt: skip
        if kind == "rj45":
            body = at_block(0.024, 0.0125, 0.009, 0.0015, (0.0, 0, 0.002))
            clip = at_box(0.016, 0.006, 0.0012, (-0.001, 0, 0.0118)).turn(1, 0.12)
            pins = [at_box(0.006, 0.0007, 0.0008, (0.0085, -0.0045 + 0.0013 * k, 0.0107))
                    for k in range(8)]  # fmt: skip
            boot = spindle((-0.032, 0.0035), (-0.011, 0.0062), z=0.0065)
            return [
                (body, surfaces.plain((216, 226, 232))),
                (boot, plastic(look, "blue", "gray", "yellow", "red", "black")),
                (cord, plastic(look, "blue", "gray", "yellow", "black")),
                (join([clip]), surfaces.plain((206, 216, 222))),
                (join(pins), shine(look, "gold")),
            ]
        ring = (0.0045, 0.0085) if kind == "phono" else (0.0032, 0.007)
        body = spindle((-0.032, 0.003), (-0.026, 0.0065), (0.006, 0.0078), (0.01, ring[1]), z=z)
        tip = spindle((0.01, ring[0]), (0.036, ring[0]), (0.04, 0.0012), z=z)
        band = [
            spindle((x, ring[0] * 1.04), (x + 0.0012, ring[0] * 1.04), z=z) for x in (0.022, 0.03)
        ]
        collar = spindle((0.009, ring[1]), (0.016 if kind == "phono" else 0.011, ring[1]), z=z)
        return [(body, plastic(look, "black", "silver", "red", "gold")),
                (tip, shine(look, "gold", "silver")), (cord, dye(look, "black", "charcoal")),
                (join(band), BLACK), (collar, shine(look))]  # fmt: skip

    return draw


@category("cable_organiser", size=(0.0911, 0.1, 0.0177), mass=0.04, material="plastic",
          aliases=("cable organizer", "cable holder", "cable tidy", "cord organizer",
          "cable management clip"), themes=("workbench",), colors=("black",),
          state="lying")  # fmt: skip
@from_pieces(bodies=2)
def cable_organiser(look: Look) -> Pieces:
    """A block with grooves for cables."""
    tile = plastic(look, "black", "white", "gray", "blue")
    body = at_block(0.09, 0.03, 0.008, 0.006)
    ribs = [at_block(0.011, 0.026, 0.012, 0.004, (-0.036 + 0.018 * k, 0, 0.006)) for k in range(5)]
    cords = [rod([(-0.027 + 0.018 * k, -0.045, 0.003), (-0.027 + 0.018 * k, -0.01, 0.012),
                  (-0.027 + 0.018 * k, 0.03, 0.012), (-0.02 + 0.022 * k, 0.055, 0.003)], 0.0022, 6)
             for k in range(4)]  # fmt: skip
    return [(body, tile), (join(ribs), tile), (join(cords), dye(look, "white", "black", "gray"))]


@category("flashlight", size=(0.155, 0.048, 0.05), mass=0.2, material="device",
          aliases=("torch", "headlamp", "head torch"), themes=("workbench",),
          colors=("black", "red"), state="lying flat", common=True)  # fmt: skip
def flashlight(look: Look) -> Shape:
    """A flashlight lying flat: a body, a flared head and a lens."""
    length, r = look.between(0.14, 0.17), look.between(0.014, 0.017)
    color = look.color("black", "red", "gray", "yellow", "blue")
    shell = surfaces.grid(tint_color(color, 0.7), color, 10, 14, 96, 1)
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.004), (r, 0.7 * length), (0, 0.7 * length)], 20)
    head = lathe(
        [(0, 0.66 * length), (r, 0.66 * length), (1.55 * r, 0.8 * length), (1.55 * r, length),
         (1.3 * r, length), (0.0, length - 0.004)],
        20,
    )  # fmt: skip
    lens = lay_down(cylinder(1.32 * r, 0.002, 20), length / 2 - 0.004, 1.55 * r)
    switch = block(0.02, 0.009, 0.005, 0.003).move(x=-0.02, z=2.5 * r)
    keel = box(0.6 * length, r, 0.7 * r).move(x=-0.15 * length)
    dark = surfaces.speckles(look.rng, tint_color(color, 0.75), 4)
    return shape([(lay_down(body, -length / 2, 1.55 * r), shell),
                  (lay_down(head, -length / 2, 1.55 * r), dark),
                  (lens, surfaces.gradient((230, 226, 190), (252, 250, 236), look.rng)),
                  (switch, surfaces.plain((200, 60, 50))), (keel, dark)],
                 [box_part(0.68 * length, 1.5 * r, 2.2 * r, (-0.16 * length, 0, 0)),
                  box_part(0.22 * length, 2.2 * r, 3.0 * r, (0.39 * length, 0, 0))])  # fmt: skip


@category("sat_nav", size=(0.133, 0.12, 0.0812), mass=0.2, material="device",
          aliases=("satnav", "gps", "navigation device", "gps device", "navigator"),
          themes=("workbench",), colors=("black",))  # fmt: skip
@from_pieces(bodies=3)
def sat_nav(look: Look) -> Pieces:
    """A navigation device on a stand, with a map on its screen."""
    image = prints.canvas(128, 80, (206, 222, 196))
    for path in (
        [(0.0, 0.8), (0.4, 0.55), (1, 0.5)],
        [(0.2, 0), (0.35, 0.5), (0.3, 1)],
        [(0.7, 0), (0.75, 0.5), (0.95, 1)],
    ):
        prints.stroke(image, path, 0.06, (250, 250, 246))
    prints.stroke(image, [(0.5, 1), (0.5, 0.55), (0.75, 0.5), (0.72, 0)], 0.07, (220, 60, 160))
    prints.polygon(image, [(0.5, 0.7), (0.57, 0.92), (0.43, 0.92)], (40, 100, 220))
    prints.fill(image, 0, 0, 1, 0.16, (34, 60, 110))
    body = at_block(0.13, 0.08, 0.016, 0.01).turn(0, 1.25)
    face = at_box(0.114, 0.066, 0.001, (0, 0, 0.0158)).turn(0, 1.25)
    low = float(body.bounds[0, 2])
    arm = rod([(0, 0.02, 0.04), (0, 0.05, 0.03), (0, 0.06, 0.01)], 0.008, 10)
    cup = disc(0.03, 0.01, (0, 0.06, 0), top=0.02)
    shell = plastic(look, "black", "charcoal", "silver")
    return [(body.move(z=-low), shell), (arm, shell), (cup, shell), (face.move(z=-low), image)]


CATEGORIES = (
    Category("network_plug", from_pieces(bodies=3)(_schuko("rj45")), size=(0.095, 0.055, 0.013),
             mass=0.015, material="plastic", assembled=True, aliases=("rj45 connector",
             "rj 45 connector", "ethernet plug", "network connector", "patch cable end"),
             themes=("workbench",), colors=("blue",), state="lying"),
    Category("phono_plug", from_pieces(bodies=3)(_schuko("phono")), size=(0.125, 0.057, 0.0165),
             mass=0.02, material="plastic", assembled=True,
             aliases=("rca plug", "balun", "coax plug", "aerial plug", "antenna plug"),
             themes=("workbench",), colors=("black",), state="lying"),
    Category("jack_plug", from_pieces(bodies=3)(_schuko("jack")), size=(0.116, 0.0535, 0.0148),
             mass=0.02, material="plastic", assembled=True,
             aliases=("audio jack", "headphone plug", "headphone jack", "aux plug", "guitar plug"),
             themes=("workbench",), colors=("black",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
