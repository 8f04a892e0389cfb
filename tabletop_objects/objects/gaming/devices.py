"""Objects of the ``gaming`` theme: electronic devices."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, hull_part
from ...kit.primitives import facing
from ...kit.shapes import Shape, category, shape
from ...kit.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    sweep,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, tint_color


@category("joystick", size=(0.19, 0.18, 0.22), mass=0.8, material="device", aliases=("flight stick",
          "flight joystick", "joy stick", "gaming joystick", "control stick"), themes=("gaming",),
          roles=("tall",), colors=("black",))  # fmt: skip
def joystick(look: Look) -> Shape:
    """A flight joystick: a grip with a trigger and a hat switch on a broad base with buttons."""
    k = look.between(0.92, 1.08)
    color = look.color("black", "charcoal", "gray", "navy", "black")
    trim = surfaces.plain(look.own_color("red", "orange", "blue", "silver", "lime"))
    skin = surfaces.speckles(look.rng, color, 4, 32)
    base = loft(np.stack([np.column_stack([rectangle(1, 1, 0.22, 4) * [a * k, b * k],
                                           np.full(20, z * k)]) for a, b,
                          z in ((0.19, 0.18, 0), (0.19, 0.18, 0.012), (0.15, 0.14, 0.045))]),
                rectangle(1, 1, 0.22, 4))  # fmt: skip
    boot = lathe([(0, 0.044 * k), (0.038 * k, 0.044 * k), (0.03 * k, 0.056 * k),
                  (0.034 * k, 0.06 * k), (0.018 * k, 0.075 * k), (0, 0.075 * k)], 24)  # fmt: skip
    grip = sweep(smooth([(0, 0.0, 0.07 * k), (0, 0.004 * k, 0.1 * k), (0, 0.0, 0.15 * k),
                         (0, -0.012 * k, 0.19 * k), (0, -0.022 * k, 0.212 * k)], 3),
                 rectangle(0.036 * k, 0.042 * k, 0.014, 4),
                 [0.75, 0.8, 0.86, 0.94, 1, 1, 0.98, 0.96, 0.98, 1.05, 1.1, 1.1, 1.0])  # fmt: skip
    hat = cylinder(0.008, 0.01, 14, bevel=0.002).move(0.004, -0.014 * k, 0.21 * k)
    thumb = facing(cylinder(0.006, 0.006, 14)).move(0.009, -0.036 * k, 0.195 * k)
    trigger = block(0.012, 0.014, 0.03 * k, 0.004, 0.002).move(y=0.022 * k, z=0.155 * k)
    buttons = [cylinder(0.0075, 0.006, 14).move(s * 0.055 * k, -0.05 * k + 0.026 * n * k, 0.043 * k)
               for s in (-1, 1) for n in range(3)]  # fmt: skip
    lever = box(0.02, 0.01, 0.014).move(0, 0.055 * k, 0.044 * k)
    return shape([(join([base, boot, grip]), skin), (join([hat, thumb, trigger, *buttons, lever]),
                                                     trim)], [hull_of(base), hull_of(boot),
                                                              hull_of(grip)])  # fmt: skip


DARK = (40, 42, 46)


@category("vr_headset", size=(0.18, 0.26, 0.13), mass=0.5, material="device",
          aliases=("vr goggles", "virtual reality headset", "vr glasses", "vr"), themes=("gaming",),
          colors=("white", "black"), common=True)  # fmt: skip
def vr_headset(look: Look) -> Shape:
    """A virtual-reality headset with a visor in front and straps behind."""
    x, z, y = look.between(0.17, 0.19), look.between(0.09, 0.105), look.between(0.06, 0.08)
    color = look.color("white", "black", "charcoal", "white")
    shell = surfaces.speckles(look.rng, color, 3, 32)
    dark = surfaces.speckles(look.rng, DARK, 4)
    visor = prism(rectangle(x, z, 0.035, 6), 0, y, 0.014)
    visor = facing(visor).move(y=-0.02, z=z / 2)
    plate = facing(prism(rectangle(0.84 * x, 0.72 * z, 0.028, 6), 0, 0.003)).move(
        y=-0.02 - y + 0.001, z=z / 2
    )
    glass = prints.canvas(128, 64, (26, 28, 34) if look.chance(0.6) else tint_color(color, 0.9))
    for u in (0.15, 0.85):
        prints.disc(glass, u, 0.25, 0.08, (70, 76, 92))
        prints.disc(glass, u, 0.78, 0.08, (70, 76, 92))
    pad = facing(prism(rectangle(0.86 * x, 0.86 * z, 0.03, 6), 0, 0.03)).move(y=0.005, z=z / 2)
    a = np.linspace(0, np.pi, 15)
    back = np.column_stack([0.49 * x * np.cos(a), 0.16 * np.sin(a) ** 0.8, np.full(15, 0.5 * z)])
    back[:, 2] += 0.1 * z * np.sin(a)
    strap = sweep(back, rectangle(0.008, 0.026, 0.003, 2))
    over = smooth([(0, -0.02, 0.96 * z), (0, 0.05, 1.3 * z), (0, 0.13, 1.05 * z),
                   (0, 0.16, 0.66 * z)], 4)  # fmt: skip
    crown = sweep(over, rectangle(0.024, 0.004, 0.0015, 2))
    rest = block(0.09, 0.022, 0.7 * z, 0.008, 0.004).move(y=0.15)
    return shape(
        [(visor, shell), (plate, glass), (join([pad, crown, rest]), dark),
         (strap, shell if look.chance(0.5) else dark)],
        [hull_of(visor, pad), hull_of(rest),
         *(box_part(0.008, 0.12, 0.026, (s * 0.46 * x, 0.06, 0.47 * z)) for s in (-1, 1))],
    )  # fmt: skip


@category("microphone", size=(0.104, 0.104, 0.19), mass=0.6, material="device",
          aliases=("mic", "podcast microphone", "usb microphone", "desk microphone"),
          themes=("gaming", "office"), roles=("tall", "round"), colors=("black", "silver"),
          common=True)  # fmt: skip
def microphone(look: Look) -> Shape:
    """A microphone on a table stand."""
    h, r = look.between(0.16, 0.22), look.between(0.022, 0.03)
    color = look.color("black", "silver", "charcoal", "red", "white")
    body_tile = surfaces.speckles(look.rng, color, 4)
    mesh = prints.mesh_holes(look.own_color("silver", "gray", "black"), (30, 30, 34), 18, 24)
    foot = cylinder(0.052, 0.01, 30, bevel=0.002)
    post = cylinder(0.005, 0.5 * h, 12).move(z=0.009)
    low, rise = 0.42 * h, look.between(0.04, 0.18)
    capsule = lathe([(0, 0), (0.9 * r, 0), (r, 0.004), (r, 0.3 * h), (0, 0.3 * h)], 26).move(z=low)
    a = np.linspace(0, np.pi / 2, 8)
    head = lathe([(0, 0), (1.03 * r, 0), *np.column_stack(
        [1.03 * r * np.cos(a), rise * h + r * np.sin(a)])[:-1], (0, rise * h + r)], 26)  # fmt: skip
    head = head.move(z=low + 0.3 * h)
    band = torus(1.02 * r, 0.002, 26, 6).move(z=low + 0.3 * h)
    knob = facing(cylinder(0.007, 0.005, 16)).move(y=-r, z=low + 0.14 * h)
    a = np.linspace(0, np.pi, 11)
    fork = tube(np.column_stack([-1.22 * r * np.cos(a), np.zeros(11),
                                 low + 0.14 * h - 0.16 * h * np.sin(a)]), 0.003, 8)  # fmt: skip
    trim = surfaces.plain(look.own_color("silver", "charcoal", "gold"))
    return shape(
        [(join([foot, post, fork]), surfaces.speckles(look.rng, DARK, 4)), (capsule, body_tile),
         (head, mesh), (join([band, knob]), trim)],
        [cylinder_part(0.052, 0.01), cylinder_part(0.005, 0.42 * h, (0, 0, 0.009)),
         hull_of(capsule), hull_of(head)],
    )  # fmt: skip


@category("handheld_console", size=(0.235, 0.1, 0.0225), mass=0.4, material="device",
          aliases=("handheld game", "portable console", "nintendo switch", "handheld game console",
          "game boy", "gameboy"), themes=("gaming", "toys"), roles=("flat",),
          colors=("red", "black"), state="lying flat", common=True)  # fmt: skip
def handheld_console(look: Look) -> Shape:
    """A handheld games console lying flat, with a screen between two coloured grips."""
    k = look.between(0.94, 1.08)
    x, y, h = 0.235 * k, 0.1 * k, 0.0145
    left, right = (
        look.color("red", "black", "teal", "purple"),
        look.own_color("blue", "red", "yellow"),
    )
    if look.chance(0.3):
        right = left
    middle = box(0.7 * x, y, h)
    screen = box(0.66 * x, 0.84 * y, 0.0008).move(z=h)
    picture = prints.landscape(look.rng, 192, 108)
    for _ in range(4):
        prints.fill(picture, look.rng.uniform(0, 0.8), look.rng.uniform(0.5, 0.85), 0.16, 0.06,
                    look.own_color("brown", "green", "orange"))  # fmt: skip
    prints.disc(picture, 0.3, 0.5, 0.06, (220, 50, 40))
    frame = np.pad(picture, ((6, 6), (8, 8), (0, 0)))
    pieces, buttons, sticks = [(middle, surfaces.plain(DARK)), (screen, frame)], [], []
    for s, color in ((-1, left), (1, right)):
        grip = block(0.16 * x, y, h, 0.03 if y > 0.06 else 0.01, 0.003).move(x=s * 0.42 * x)
        pieces.append((grip, surfaces.speckles(look.rng, color, 4)))
        up, down = 0.22 * y, -0.12 * y
        stick = join([cylinder(0.0075, 0.005, 16), cylinder(0.0095, 0.003, 18).move(z=0.005)])
        sticks.append(stick.move(s * 0.42 * x, up if s < 0 else down, h))
        for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            at = (s * 0.42 * x + 0.0085 * dx, (down if s < 0 else up) + 0.0085 * dy, h - 0.0005)
            buttons.append(cylinder(0.0038, 0.0024, 12).move(*at))
    pieces.append((join([*buttons, *sticks]), surfaces.plain((28, 29, 32))))
    return shape(pieces, [box_part(x, y, h), *(hull_of(s) for s in sticks)])


HEADSET_DARK: RGB = (38, 39, 43)


@category("headset", size=(0.212, 0.155, 0.196), mass=0.28, material="device",
          aliases=("gaming headset", "headset with microphone", "call center headset",
          "pc headset"), themes=("gaming", "office"), colors=("black", "white"))  # fmt: skip
def headset(look: Look) -> Shape:
    """A headset with a microphone arm, standing on its ear cups."""
    k = look.between(0.94, 1.08)
    color = look.color("black", "white", "charcoal", "red", "pink", "navy", "green")
    skin = surfaces.speckles(look.rng, color, 4, 32)
    trim = surfaces.plain(look.own_color("red", "silver", "lime", "blue", "black"))
    a = np.linspace(0, np.pi, 21)
    band = sweep(np.column_stack([-0.085 * k * np.cos(a), 0 * a, 0.075 * k + 0.1 * k * np.sin(a)]),
                 rectangle(0.032 * k, 0.01, 0.004, 3))  # fmt: skip
    cups, pads = [], []
    for s in (-1, 1):
        cup = cylinder(0.045 * k, 0.026 * k, 28, bevel=0.006).turn(1, s * np.pi / 2)
        pad = torus(0.03 * k, 0.013 * k, 26, 8).turn(1, np.pi / 2)
        cups.append(cup.move(x=s * 0.075 * k, z=0.045 * k))
        pads.append(pad.move(x=s * 0.068 * k, z=0.045 * k))
    arm = tube(smooth([(-0.09 * k, -0.02 * k, 0.03 * k), (-0.086 * k, -0.06 * k, 0.018 * k),
                       (-0.05 * k, -0.09 * k, 0.015 * k)], 5), 0.0035, 7)  # fmt: skip
    mic = (
        ellipsoid(0.026, 0.014, 0.014, 14, 8).turn(2, -0.7).move(-0.042 * k, -0.096 * k, 0.015 * k)
    )
    rings = [torus(0.03 * k, 0.002, 26, 6).turn(1, np.pi / 2).move(x=s * 0.1015 * k, z=0.045 * k)
             for s in (-1, 1)]  # fmt: skip
    soft = surfaces.speckles(look.rng, HEADSET_DARK, 6)
    return shape(
        [(join([band, *cups]), skin), (join([*pads, mic, arm]), soft), (join(rings), trim)],
        [
            *(flat_foot(c.vertices, 0.1) for c in cups),
            *(
                hull_part(band.vertices[(band.vertices[:, 0] > lo) & (band.vertices[:, 0] < hi)])
                for lo, hi in ((-0.1, -0.03), (-0.04, 0.04), (0.03, 0.1))
            ),
            hull_of(arm, mic),
        ],
    )
