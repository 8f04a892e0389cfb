"""Kit for swimming, training and juggling: goggles, rollers, bands, pads."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import DARK, at_box, drum, lies, plate, standing
from ...build.outlines import ellipse
from ...build.recipes import ball, pad, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain

BRIGHT = ("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")


def goggles(look: Look) -> Shape:
    """Swimming goggles lying: two lenses, a nose piece and a strap behind."""
    color = look.color(*BRIGHT)
    k = look.between(0.9, 1.15)
    cups, lenses = [], []
    for s in (-1, 1):
        cups.append(
            torus(0.0225, 0.006, 24, 8)
            .scale(1.25, 0.9, 1.6)
            .turn(0, 0.85)
            .move(s * 0.035, -0.02, 0.018)
        )
        lenses.append(
            plate(ellipse(0.054, 0.038, 22), 0.004, at=(0, 0, 0.003))
            .turn(0, 0.85)
            .move(s * 0.035, -0.021, 0.018)
        )
    nose = at_box(0.02, 0.008, 0.006, (0, -0.024, 0.018))
    a = np.linspace(0.15, np.pi - 0.15, 18)
    path = np.column_stack([0.068 * np.cos(a), -0.01 + 0.075 * np.sin(a), 0.013 + 0 * a])
    path = np.concatenate([[(0.06, -0.022, 0.018)], path, [(-0.06, -0.022, 0.018)]])
    strap = [
        tube(path, 0.0025, 8),
        tube(path - np.array([0, 0, 0.006]), 0.0025, 8),
        tube(path - np.array([0, 0, 0.0105]), 0.0025, 8),
    ]
    tint = look.pick([(150, 190, 210), (90, 100, 120), (220, 170, 90)])
    return put_down(
        [
            (join([*cups, nose]), plain(color)),
            (join(lenses), textures.gradient(tint, tint_color(tint, 1.5), look.rng)),
            (join(strap), plain(tint_color(color, 0.7))),
        ],
        *cups,
        join(strap),
        factor=k,
    )


def snorkel(look: Look) -> Shape:
    """A snorkel lying: a bent tube with a mouthpiece and a bright end."""
    color = look.color("blue", "black", "yellow", "green", "orange")
    k = look.between(0.85, 1.1)
    pipe = rod([(0.2, 0, 0.012), (0.0, 0.0, 0.012), (-0.12, 0, 0.012), (-0.17, 0.03, 0.012),
                (-0.15, 0.075, 0.012)], 0.0115, 14, 6)  # fmt: skip
    end = drum(0.0135, 0.03, (0.19, 0, 0.0135), 0, sides=16)
    mouth = pad(0.05, 0.026, 0.016, 0.008).move(-0.148, 0.082, 0.006)
    clip = torus(0.0125, 0.004, 18, 6).turn(1, np.pi / 2).move(0.02, 0, 0.0135)
    return put_down(
        [(pipe, plain(color)), (end, plain((240, 120, 40))), (join([mouth, clip]), plain(DARK))],
        straight((0.2, 0, 0.012), (-0.12, 0, 0.012), 0.0115, 12),
        mouth,
        pipe,
        factor=k,
        foot=0.3,
    )


def foam_roller(look: Look) -> Shape:
    """A ribbed foam roller standing on its end."""
    color = look.color("black", "teal", "purple", "orange", "blue", "gray")
    k = look.between(0.8, 1.15)
    outer = [(0.058, 0), (0.06, 0.004)]
    for n in range(5):
        z = 0.02 + 0.05 * n
        outer += [(0.062, z), (0.062, z + 0.034), (0.057, z + 0.037), (0.057, z + 0.047)]
    outer += [(0.062, 0.27), (0.058, 0.276)]
    body = lathe([(0, 0), *outer, (0.042, 0.276), (0.042, 0.262), (0, 0.262)], 30)
    inner = drum(0.041, 0.0008, (0, 0, 0.2616))
    return put_down(
        [(body, textures.speckles(look.rng, color, 8)), (inner, plain(DARK))], body, factor=k
    )


def resistance_band(look: Look) -> Shape:
    """A flat loop of rubber lying in a soft oval."""
    color = look.color(*BRIGHT)
    k = look.between(0.8, 1.2)
    a = np.linspace(0, 2 * np.pi, 41)[:-1]
    wave = look.between(0.0, 0.2)
    r = 1 + wave * np.cos(2 * a + 0.5) + 0.5 * wave * np.cos(3 * a)
    path = np.column_stack([0.09 * r * np.cos(a), 0.06 * r * np.sin(a), 0.0125 + 0 * a])
    ring = tube(path, 0.0024, 8, loop=True, squash=5.2)
    bits = [tube(np.roll(path, -5 * n, 0)[:7], 0.0024, 8, squash=5.2) for n in range(8)]
    return put_down([(ring, textures.speckles(look.rng, color, 4))], *bits, factor=k)


def knee_pad(look: Look) -> Shape:
    """A padded guard with a hard cap and two straps, lying."""
    color = look.color("black", "navy", "red", "charcoal", "pink")
    k = look.between(0.85, 1.15)
    body = pad(0.13, 0.18, 0.04, 0.05, soft=0.8)
    cap = standing(
        (0.045, 0), (0.044, 0.01), (0.034, 0.022), (0.014, 0.029), at=(0, 0, 0.036), sides=22
    ).scale(1, 1.25, 1)
    straps = [at_box(0.19, 0.03, 0.006, (0, s * 0.055, 0.012)) for s in (-1, 1)]
    cuts = [at_box(0.05, 0.006, 0.004, (0, y, 0.0635)) for y in (-0.012, 0.012)]
    return put_down(
        [
            (body, textures.fabric(look.rng, color)),
            (cap, plain(tint_color(color, 0.7) if sum(color) > 250 else (90, 92, 98))),
            (join([*straps, *cuts]), plain(DARK)),
        ],
        body,
        cap,
        *straps,
        factor=k,
    )


def juggling_club(look: Look) -> Shape:
    """A juggling club lying, with coloured rings."""
    color = look.color("red", "blue", "yellow", "green", "pink", "orange", "white")
    k = look.between(0.75, 1.0)
    profile = [
        (0.011, 0),
        (0.016, 0.008),
        (0.012, 0.02),
        (0.011, 0.1),
        (0.02, 0.16),
        (0.042, 0.26),
        (0.043, 0.31),
        (0.03, 0.38),
        (0.018, 0.4),
    ]
    bands = textures.stack(
        (plain((240, 240, 236)), 0.3),
        (plain(color), 0.42),
        (plain(tint_color(color, 0.6)), 0.06),
        (plain((244, 240, 230)), 0.22),
    )
    body = lies(standing(*profile, sides=22), -0.2, 0, 0.04)
    knob = ball(0.03, 0.03, 0.03, (-0.196, 0, 0.014), 12)
    body = body.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] - 0.024 * np.clip((0.06 - p[:, 0]) / 0.26, 0, 1)]
        )
    )
    return put_down([(body, bands), (knob, plain((60, 60, 64)))], body, knob, factor=k, foot=0.16)


def beanbag(look: Look) -> Shape:
    """A small square beanbag, plump, for throwing."""
    color = look.color(*BRIGHT)
    k = look.between(0.8, 1.2)
    body = pad(0.1, 0.1, 0.034, 0.022, soft=0.95)
    seam = [
        at_box(0.098, 0.0015, 0.002, (0, 0, 0.0332)),
        at_box(0.0015, 0.098, 0.002, (0, 0, 0.0332)),
    ]
    quarter = at_box(0.03, 0.03, 0.001, (0.02, 0.02, 0.0333))
    return put_down(
        [
            (body, textures.fabric(look.rng, color)),
            (join(seam), plain(tint_color(color, 0.6))),
            (quarter, plain(look.own_color("white", "yellow", "teal"))),
        ],
        body,
        factor=k,
    )


CATEGORIES = (
    Category("goggles", goggles, (0.144, 0.114, 0.0369), 0.05,
             ("swim goggles", "diving goggles", "ski goggles"), ("sports",),
             (), ("blue", "black")),
    Category("snorkel", snorkel, (0.402, 0.111, 0.0297), 0.15, ("snorkel tube", "diving snorkel"),
             ("sports",), ("big",), ("blue",)),
    Category("foam_roller", foam_roller, (0.119, 0.119, 0.266), 0.3, ("massage roller",
             "fitness roller", "exercise roller"),
             ("sports",), ("tall", "round"), ("black", "blue")),
    Category("resistance_band", resistance_band, (0.185, 0.111, 0.0234), 0.04,
             ("exercise band", "loop band", "workout band"), ("sports",), (),
             ("red", "blue")),
    Category("knee_pad", knee_pad, (0.184, 0.174, 0.0653), 0.15,
             ("kneepad", "elbow pad", "shin pad", "shin guard", "shinpad", "arm guard",
             "protective pad", "wrist guard"),
             ("sports",), (), ("black",)),
    Category("juggling_club", juggling_club, (0.348, 0.0728, 0.0699), 0.2, ("juggling pin",
             "indian club", "exercise club"),
             ("sports", "toys"), ("big",), ("red", "blue")),
    Category("beanbag", beanbag, (0.0997, 0.0997, 0.0351), 0.12,
             ("bean bag", "hacky sack", "juggling beanbag", "juggling bag", "cornhole bag",
             "sandbag", "small sandbag"),
             ("sports", "toys"), (), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
