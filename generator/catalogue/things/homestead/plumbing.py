"""Taps, shower heads, plugs and stoppers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import at_box, drum, standing, steel
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import join, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def tap(look: Look) -> Shape:
    """A tap standing: a body, a curved spout and a handle."""
    color = look.color("silver", "silver", "gold", "black", "copper")
    k = look.between(0.85, 1.1)
    base = standing(
        (0.028, 0),
        (0.028, 0.006),
        (0.018, 0.014),
        (0.0165, 0.1),
        (0.019, 0.106),
        (0.017, 0.115),
        sides=24,
    )
    spout = rod(
        [(0, 0, 0.085), (0, -0.04, 0.12), (0, -0.09, 0.115), (0, -0.105, 0.082)],
        [0.013, 0.012, 0.011, 0.0115],
        14,
    )
    tip = drum(0.0132, 0.01, (0, -0.106, 0.075), sides=18)
    if look.chance(0.5):
        handle = [
            rod([(-0.036, 0, 0.127), (0.036, 0, 0.127)], 0.0075, 10),
            rod([(0, -0.036, 0.127), (0, 0.036, 0.127)], 0.0075, 10),
        ]
    else:
        handle = [rod([(0, 0, 0.12), (0, 0.05, 0.145)], [0.009, 0.006], 10)]
    stem, dot = drum(0.009, 0.018, (0, 0, 0.112)), drum(0.006, 0.003, (0, 0, 0.132))
    foot = at_box(0.05, 0.1, 0.003, (0, -0.02, 0))
    return put_down(
        [
            (join([base, spout, tip, *handle, stem]), steel(look, color)),
            (dot, plain(look.pick([(60, 110, 200), (210, 60, 50)]))),
            (foot, steel(look, tint_color(color, 0.9))),
        ],
        base,
        foot,
        spout,
        join(handle),
        factor=k,
    )


def shower_head(look: Look) -> Shape:
    """A hand shower lying, its nozzles up."""
    color = look.color("silver", "white", "black", "gold")
    k = look.between(0.85, 1.1)
    head = standing((0.02, 0), (0.046, 0.012), (0.05, 0.018), (0.05, 0.026), sides=32)
    face = drum(0.045, 0.0012, (0, 0, 0.0255), sides=32)
    handle = rod([(0.03, 0, 0.013), (0.09, 0, 0.012), (0.19, 0, 0.014)], [0.013, 0.011, 0.0125], 14)
    collar = drum(0.0115, 0.02, (0.185, 0, 0.014), 0, sides=14)
    holes = prints.mesh_holes((200, 204, 208), (60, 62, 68), 10, 10)
    return put_down(
        [
            (join([head, handle]), look.surface(color, "chrome")),
            (face, holes),
            (collar, plain((120, 124, 130))),
        ],
        head,
        handle,
        factor=k,
        foot=0.15,
    )


def sink_plug(look: Look) -> Shape:
    """A rubber plug with a ball chain."""
    color = look.color("black", "white", "charcoal", "blue")
    k = look.between(0.85, 1.2)
    body = standing((0.018, 0), (0.02, 0.013), (0.024, 0.014), (0.0245, 0.018), sides=26)
    eye = torus(0.0055, 0.0012, 16, 6).turn(0, np.pi / 2).move(0, 0, 0.021)
    beads = []
    for n in range(16):
        t = n / 15
        p = (0.004 + 0.085 * t, 0.02 * np.sin(5 * t), 0.002 + 0.022 * np.clip(1 - 3.2 * t, 0, 1))
        beads.append(ball(0.0045, 0.0045, 0.0042, p, 8))
    ring = torus(0.008, 0.0012, 18, 6).move(0.1, -0.018, 0.0014)
    return put_down(
        [(body, textures.speckles(look.rng, color, 4)), (join([eye, *beads, ring]), steel(look))],
        body,
        join([*beads[6:], ring]),
        factor=k,
    )


def stopper(look: Look) -> Shape:
    """A tapered rubber stopper standing on its wider end or its narrower one."""
    color = look.color("terracotta", "black", "gray", "red", "cream")
    r = look.between(0.012, 0.022)
    body = drum(r, 1.3 * r, top=0.76 * r, sides=26, bevel=0.03 * r)
    hole = drum(0.18 * r, 0.0005, (0, 0, 1.3 * r - 0.0002), sides=14)
    return put_down(
        [(body, textures.speckles(look.rng, color, 5)), (hole, plain((50, 40, 40)))], body
    )


CATEGORIES = (
    Category("tap", tap, (0.063, 0.156, 0.136), 0.7, ("faucet", "water tap", "bathroom tap",
             "kitchen tap", "sink tap", "mixer tap"), ("workbench",), ("tall",),
             ("silver",)),
    Category("shower_head", shower_head, (0.238, 0.0935, 0.025), 0.25, ("showerhead",
             "hand shower", "shower handset"), ("vanity",), ("big",), ("silver",)),
    Category("sink_plug", sink_plug, (0.13, 0.0503, 0.027), 0.04, ("bath plug", "basin plug",
             "bathtub plug", "plug and chain"), ("vanity",), (), ("black",)),
    Category("rubber_stopper", stopper, (0.0331, 0.0333, 0.022), 0.012, (
             "stopper", "lab stopper"), ("lab",), ("round",), ("terracotta",)),
)  # fmt: skip
"""The module's categories."""
