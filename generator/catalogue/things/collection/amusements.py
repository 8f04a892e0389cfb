"""More toys: puzzles for the hands, surprises, springs, wheels."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    at_block,
    at_box,
    disc,
    dye,
    of,
    plastic,
    shine,
    words,
)
from ...build.recipes import Pieces, ball, rod
from ...build.solids import join, torus, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 242, 238))


def _fidget(look: Look) -> Pieces:
    """A cube with buttons, a switch, gears and a ball on its faces."""
    s = 0.033
    cube = at_block(s, s, s, 0.005)
    dots = [
        disc(0.004, 0.003, (x, y, s - 0.0005))
        for x, y in ((-0.009, -0.009), (0.009, -0.009), (0, 0), (-0.009, 0.009), (0.009, 0.009))
    ]
    front = [disc(0.009, 0.005).turn(0, np.pi / 2).move(0, -s / 2 + 0.0005, s / 2)]
    side = [at_block(0.005, 0.014, 0.007, 0.002, (s / 2, 0, s / 2 - 0.003))]
    return [
        (cube, plastic(look, "black", "white", "gray", "blue")),
        (join(dots), dye(look, "green", "red", "blue", "orange")),
        (front[0], dye(look, "black", "green", "gray")),
        (side[0], dye(look, "red", "green", "black")),
    ]


def _poppit(look: Look) -> Pieces:
    """A silicone mat with rows of bubbles in rainbow colours."""
    rows = ("red", "orange", "yellow", "green", "blue", "purple")
    base = [at_block(0.128, 0.0214, 0.005, 0.004, (0, 0.0535 - 0.0214 * k, 0)) for k in range(6)]
    pieces: Pieces = []
    asked = "color" in look.attributes
    for k, name in enumerate(rows):
        color = look.color(name) if asked else look.own_color(name)
        tile = textures.plain(color)
        pops = [
            ball(0.0165, 0.0165, 0.014, (-0.0525 + 0.021 * n, 0.0535 - 0.0214 * k, 0.004), 8)
            for n in range(6)
        ]
        pieces += [(base[k], tile), (join(pops), textures.plain(tint_color(color, 1.12)))]
    return pieces


def _eightball(look: Look) -> Pieces:
    """A black ball with an 8 in a white disc, upright on its flat window."""
    body = ball(0.1, 0.1, 0.1, (0, 0, 0.047), 32)
    badge = ball(0.046, 0.046, 0.012, (0, 0, 0.0926), 20).turn(0, -0.0)
    image = prints.canvas(64, 64, (246, 246, 244))
    prints.write(image, "8", 0.5, 0.5, 0.7, (20, 20, 22), True)
    top = disc(0.02, 0.0012, (0, 0, 0.0977))
    pieces = [
        (body, textures.speckles(look.rng, look.color("black", spread=4), 3)),
        (badge, WHITE),
        (top, image),
    ]
    return [(s.move(z=-0.047).turn(0, 0.55).move(z=0.047), t) for s, t in pieces]


def _sketcher(look: Look) -> Pieces:
    """A drawing toy: a red frame, a grey screen with a line, two white knobs."""
    frame = plastic(look, "red", "red", "pink", "blue")
    body = at_block(0.24, 0.2, 0.03, 0.02)
    image = prints.canvas(128, 92, (196, 198, 194))
    x, y, way = 0.3, 0.7, [(0.3, 0.7)]
    for k in range(16):
        if k % 2:
            x = float(np.clip(x + look.between(-0.25, 0.3), 0.1, 0.9))
        else:
            y = float(np.clip(y + look.between(-0.3, 0.25), 0.1, 0.9))
        way.append((x, y))
    prints.stroke(image, way, 0.016, (60, 60, 62))
    knobs = [disc(0.018, 0.012, (s * 0.092, -0.078, 0.029)) for s in (-1, 1)]
    name = at_box(0.1, 0.016, 0.0008, (0, -0.08, 0.0296))
    return [
        (body, frame),
        (join(knobs), WHITE),
        (at_box(0.19, 0.125, 0.0008, (0, 0.014, 0.0296)), image),
        (name, words("SKETCH", (214, 176, 70), (120, 30, 30), 0.6)),
    ]


def _viewer(look: Look) -> Pieces:
    """A picture viewer: two eyepieces, a paper reel on top, a lever."""
    tile = plastic(look, "red", "red", "blue", "brown")
    body = at_block(0.12, 0.06, 0.085, 0.014)
    eyes = [disc(0.019, 0.02).turn(0, np.pi / 2).move(s * 0.032, -0.028, 0.045) for s in (-1, 1)]
    lens = [disc(0.013, 0.001).turn(0, np.pi / 2).move(s * 0.032, -0.0478, 0.045) for s in (-1, 1)]
    reel = disc(0.045, 0.0016).turn(0, np.pi / 2).move(0, 0.004, 0.075)
    holes = [
        at_box(0.008, 0.003, 0.007, (0.034 * np.cos(a), 0.003, 0.072 + 0.034 * np.sin(a)))
        for a in np.linspace(0.3, np.pi - 0.3, 6)
    ]
    lever = at_block(0.012, 0.02, 0.03, 0.004, (0.066, 0, 0.045))
    return [
        (body, tile),
        (join(eyes), BLACK),
        (reel, WHITE),
        (lever, dye(look, "white", "black")),
        (join(lens), textures.plain((120, 150, 190))),
        (join(holes), textures.plain((80, 120, 190))),
    ]


def _jackbox(look: Look) -> Pieces:
    """A painted box, its lid open, a clown on a spring above it."""
    color = look.color("red", "blue", "yellow", "teal", "purple")
    side = textures.stripes([color, look.own_color("yellow", "white", "orange")], 3, upright=True)
    body = at_box(0.09, 0.09, 0.085)
    lid = at_box(0.09, 0.004, 0.09).turn(0, 0.35).move(0, 0.05, 0.084)
    t = np.linspace(0, 1, 90)
    a = 2 * np.pi * 6 * t
    spring = tube(
        np.column_stack([0.026 * np.cos(a), 0.026 * np.sin(a), 0.086 + 0.04 * t]), 0.0022, 6
    )
    frill = disc(0.036, 0.008, (0, 0, 0.122))
    head = ball(0.05, 0.05, 0.054, (0, 0, 0.152), 18)
    hat = disc(0.023, 0.05, (0, 0, 0.17), top=0.002)
    pom = ball(0.014, 0.014, 0.014, (0, 0, 0.221), 10)
    hair = [ball(0.026, 0.022, 0.026, (s * 0.026, 0.004, 0.158), 12) for s in (-1, 1)]
    eyes = [ball(0.007, 0.004, 0.009, (s * 0.01, -0.023, 0.158), 8) for s in (-1, 1)]
    nose = ball(0.013, 0.013, 0.013, (0, -0.027, 0.15), 12)
    crank = rod([(0.044, 0, 0.04), (0.06, 0, 0.04), (0.06, 0, 0.06)], 0.003, 8)
    return [
        (body, side),
        (lid, side),
        (spring, shine(look)),
        (frill, dye(look, "white", "yellow", "red")),
        (head, dye(look, "beige")),
        (hat, dye(look, "green", "purple", "blue")),
        (crank, shine(look)),
        (join(hair), dye(look, "orange", "red")),
        (join([nose, pom]), textures.plain((214, 40, 40))),
        (join(eyes), BLACK),
    ]


def _slinky(look: Look) -> Pieces:
    """A coiled spring toy bent over in an arch, or standing in a stack."""
    color = look.color("silver", "silver", "red", "blue", "green", "purple")
    arch = look.chance(0.6)
    n = 32 if arch else 24
    pieces = []
    for k in range(n):
        t = (k + 0.5) / n
        ring = torus(0.03, 0.0016, 14, 4)
        if arch:
            a = np.pi * (1 - t)
            pieces.append(
                ring.turn(1, a + np.pi).move(0.055 * np.cos(a), 0, 0.004 + 0.06 * np.sin(a))
            )
        else:
            pieces.append(ring.move(0.0004 * np.sin(k), 0, 0.0014 + 0.0021 * k))
    low = min(float(p.bounds[0, 2]) for p in pieces)
    pieces = [p.move(z=-low) for p in pieces]
    third = n // 4
    groups = [pieces[k * third : (k + 1) * third if k < 3 else n] for k in range(4)]
    tone = look.surface(color, "metal")
    return [(join(g), tone) for g in groups]


_row = Rows("toys", ("red", "blue")).of_shape


CATEGORIES = (
    _row("fidget_cube", of(_fidget), (0.0355, 0.037, 0.036), 0.04, ("fidget toy", "stress cube",
             "fidget die"), ("black",)),
    vary(_row("pop_it", of(_poppit, bodies=(0, 2, 4, 6, 8, 10)), (0.128, 0.128, 0.011), 0.06,
             ("popit",
             "pop it toy", "pop-it", "bubble popper", "push pop toy"), roles=("flat",))),
    vary(_row("magic_8_ball", of(_eightball, 0.06, bodies=1), (0.1, 0.1, 0.1), 0.35,
             ("magic eight ball", "8 ball", "fortune ball"), ("black",), ("round",))),
    _row("etch_a_sketch", of(_sketcher, bodies=2), (0.24, 0.2, 0.041), 0.5, ("drawing toy",
             "etch sketch", "magnetic drawing board", "sketch toy", "magna doodle"),
             roles=("flat", "big")),
    _row("view_master", of(_viewer, bodies=3), (0.128, 0.08, 0.12), 0.15, ("viewmaster",
             "view finder toy")),
    _row("jack_in_the_box", of(_jackbox, bodies=6), (0.112, 0.0992, 0.234), 0.4, ("jack in box",
             "clown in a box", "jack in the box toy"), roles=("tall",)),
    _row("slinky", of(_slinky), (0.133, 0.0632, 0.0769), 0.15, ("slinky toy", "spring toy",
             "rainbow spring"), ("silver",)),
)  # fmt: skip
"""The module's categories."""
