"""Packs, plugs, rollers, cutters, parts of watches."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    plastic,
    plate,
    shine,
    spindle,
)
from ...build.recipes import Pieces, pad, rod, straight
from ...build.solids import join, lathe, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 243, 240))


def _spacer(look: Look) -> Pieces:
    body = spindle(
        (-0.07, 0.02), (-0.06, 0.028), (0.05, 0.028), (0.065, 0.018), (0.085, 0.014), z=0.028
    )
    back = spindle((-0.085, 0.014), (-0.068, 0.022), z=0.028)
    ring = spindle((0.048, 0.0295), (0.056, 0.0295), z=0.0285)
    return [
        (body, textures.plain(tint_color(look.color("clear", "sky"), 1.1))),
        (back, dye(look, "blue", "gray", "purple")),
        (ring, dye(look, "blue", "gray", "yellow")),
    ]


def _band(look: Look) -> Pieces:
    color = look.color("black", "orange", "blue", "red")
    loop = lathe([(0.045, 0), (0.047, 0), (0.047, 0.036), (0.045, 0.036)], 40, loop=True)
    tail = at_box(0.12, 0.0025, 0.036, (0.06, -0.046, 0)).turn(2, 0.04)
    stick = straight((-0.04, -0.053, 0.018), (0.04, -0.053, 0.018), 0.0055, 10)
    buckle = at_block(0.02, 0.008, 0.042, 0.003, (0.052, -0.047, 0))
    return [
        (loop, textures.fabric(look.rng, color)),
        (tail, textures.fabric(look.rng, color)),
        (stick, BLACK),
        (buckle, BLACK),
    ]


def _plugs(look: Look) -> Pieces:
    """One soft ear plug lying."""
    return [
        (
            spindle(
                (-0.012, 0.006),
                (-0.011, 0.0066),
                (0.004, 0.0058),
                (0.011, 0.0038),
                (0.0125, 0.002),
                z=0.0062,
            ),
            plastic(look, "orange", "yellow", "green", "pink"),
        )
    ]


def _pack(text: tuple[str, ...], size: tuple[float, float, float], *colors: str) -> Drawing:
    """A soft flat packet with a word."""

    def draw(look: Look) -> Pieces:
        x, y, h = size
        color = look.color(*colors)
        image = prints.canvas(128, round(128 * y / x), tint_color(color, 1.55))
        prints.fill(image, 0, 0, 1, 0.2, color)
        prints.fill(image, 0, 0.85, 1, 0.15, color)
        prints.write(
            image, look.pick(text), 0.5, 0.5, 0.24 * min(1, x / y), tint_color(color, 0.5), True
        )
        prints.lines(image, look.rng, (0.2, 0.66, 0.6, 0.1), 2, tint_color(color, 0.8))
        body = pad(x, y, h, 0.12 * min(x, y))
        rims = [at_box(0.06 * x, y, 0.0012, (s * 0.49 * x, 0, 0.4 * h)) for s in (-1, 1)]
        return [(body, image), (join(rims), textures.plain(tint_color(color, 1.2)))]

    return draw


def _roller(look: Look) -> Pieces:
    """A jade roller lying: a stone at each end of a handle."""
    color = look.color("sage", "pink", "green", "purple")
    stone = textures.marble(look.rng, color, tint_color(color, 1.5))
    z = 0.016
    grip = spindle((-0.05, 0.006), (0.05, 0.006), z=z)
    gold = [
        rod([(s * 0.05, 0, z), (s * 0.058, -0.024, z), (s * 0.075, -0.024, z)], 0.0018, 6)
        for s in (-1, 1)
    ]
    gold += [
        rod([(s * 0.05, 0, z), (s * 0.058, 0.024, z), (s * 0.075, 0.024, z)], 0.0018, 6)
        for s in (-1, 1)
    ]
    big = (
        spindle((-0.02, 0.01), (-0.012, 0.016), (0.012, 0.016), (0.02, 0.01), z=z)
        .turn(2, np.pi / 2)
        .move(x=0.075)
    )
    small = (
        spindle((-0.018, 0.005), (-0.01, 0.0085), (0.01, 0.0085), (0.018, 0.005), z=z)
        .turn(2, np.pi / 2)
        .move(x=-0.075)
    )
    return [
        (grip, stone),
        (big, stone),
        (small, stone),
        (join(gold), shine(look, "gold", "silver")),
    ]


def _toes(look: Look) -> Pieces:
    tile = plastic(look, "pink", "purple", "mint", "yellow")
    bar = at_block(0.085, 0.014, 0.018, 0.006)
    posts = [
        at_block(0.01, 0.034, 0.018, 0.0048, (-0.0375 + 0.01875 * k, 0.012, 0)) for k in range(5)
    ]
    return [(bar, tile), *((p, tile) for p in posts)]


def _cutter(look: Look) -> Pieces:
    tile = plastic(look, "sky", "clear", "pink", "green", "white")
    low, high = (
        at_block(0.075, 0.045, 0.016, 0.01),
        at_block(0.075, 0.045, 0.01, 0.01).turn(0, 0.6).move(0, 0.008, 0.03),
    )
    blade = at_box(0.05, 0.002, 0.014, (0, 0.004, 0.02)).turn(0, 0.0)
    slot = plate([(-0.02, -0.012), (0.02, -0.012), (0, 0.012)], 0.0006, 0.0157)
    half = disc(0.006, 0.004, (0, -0.006, 0.0155))
    return [
        (low, tile),
        (high, tile),
        (blade, shine(look)),
        (slot, textures.plain((200, 214, 222))),
        (half, WHITE),
    ]


def _lashes(look: Look) -> Pieces:
    """A pair of false lashes in a little tray."""
    tray = at_block(0.11, 0.045, 0.006, 0.01)
    lines = []
    for s in (-1, 1):
        a = np.linspace(0.5, np.pi - 0.5, 15)
        lines.append(
            tube(
                np.column_stack(
                    [s * 0.027 + 0.019 * np.cos(a), 0.019 * np.sin(a) - 0.016, 0 * a + 0.0068]
                ),
                0.0009,
                5,
            )
        )
        lines += [
            straight(
                (s * 0.027 + 0.019 * np.cos(t), 0.019 * np.sin(t) - 0.016, 0.0068),
                (s * 0.027 + 0.028 * np.cos(t), 0.029 * np.sin(t) - 0.016, 0.0072),
                0.0005,
                4,
            )
            for t in a
        ]
    return [(tray, plastic(look, "pink", "white", "purple", "clear")), (join(lines), BLACK)]


def _link(look: Look) -> Pieces:
    steel = shine(look, "silver", "gold")
    bars = [
        at_block(0.0055, 0.02, 0.003, 0.001, (-0.0058 + 0.0058 * k, 0.0016 * (k % 2), 0))
        for k in range(3)
    ]
    return [(b, steel) for b in bars] + [
        (straight((-0.009, -0.007, 0.0015), (0.009, -0.007, 0.0015), 0.0007, 6), steel)
    ]


def _mainspring(look: Look) -> Pieces:
    a = np.linspace(0, 2 * np.pi * 5, 150)
    r = 0.003 + 0.0022 * a / (2 * np.pi)
    spiral = tube(
        np.column_stack([r * np.cos(a), r * np.sin(a), 0 * a + 0.0015]), 0.0007, 5, squash=2.0
    )
    return [(spiral, textures.brushed_metal(look.rng, look.color("silver", "gray", "blue")))]


def _winder(look: Look) -> Pieces:
    shell = plastic(look, "black", "brown", "white", "maroon")
    body = at_block(0.15, 0.14, 0.13, 0.012)
    cup = disc(0.05, 0.012).turn(0, np.pi / 2).move(0, -0.066, 0.068)
    cushion = pad(0.05, 0.06, 0.03, 0.014).turn(0, np.pi / 2).move(0, -0.066, 0.068)
    face = disc(0.019, 0.008).turn(0, np.pi / 2).move(0, -0.094, 0.068)
    dial = disc(0.016, 0.001).turn(0, np.pi / 2).move(0, -0.1018, 0.068)
    return [
        (body, shell),
        (cup, shine(look)),
        (cushion, dye(look, "cream", "gray")),
        (face, shine(look, "gold", "silver")),
        (dial, prints.clock_face(look.rng, (244, 240, 230), (40, 40, 44))),
    ]


_row = Rows("lab", ("white",)).of_drawing


CATEGORIES = (
    _row("spacer_device", _spacer, (0.17, 0.059, 0.0575), 0.06, ("inhaler spacer",
             "asthma spacer", "aerochamber"), ("clear",), 0.06),
    _row("tourniquet", _band, (0.165, 0.105, 0.042), 0.08, ("combat tourniquet",
             "tourniquet strap"), ("black",), bodies=(0, 2, 3)),
    _row("ear_plug", _plugs, (0.0245, 0.0132, 0.0128), 0.0006, ("earplug", "foam ear plug",
             "foam earplug"), ("orange",), 0.1),
    _row("cold_pack", _pack(("COLD", "ICE PACK", "COOL"), (0.2, 0.13, 0.025), "sky", "blue"),
             (0.2, 0.125, 0.024), 0.4, ("instant ice pack",
             "heat pack", "hot pack", "hot cold pack"), ("blue",),
             roles=("flat", "big")),
    _row("wipe_packet", _pack(("WIPE", "ALCOHOL", "STERILE"), (0.06, 0.05, 0.004), "sky", "green",
             "blue"), (0.0636, 0.05, 0.004), 0.003, ("antiseptic wipe", "alcohol wipe",
             "alcohol pad", "whitener sachet", "condom",
             "gel sachet", "sample sachet", "condiment sachet", "antiseptic pad", "condom packet"),
             ("blue",), roles=("flat",)),
    _row("cleansing_wipes", _pack(("WIPES", "CLEANSE", "BABY"), (0.18, 0.1, 0.05), "pink", "mint",
             "sky"), (0.19, 0.1, 0.05), 0.25, ("cleansing wipe packet",
             "wet wipes pack", "makeup wipes"), ("pink",)),
    _row("jade_roller", _roller, (0.168, 0.0529, 0.0308), 0.09, ("face roller", "facial roller",
             "quartz roller", "gua sha"), ("sage", "pink"), 0.06, 3),
    _row("toe_separator", _toes, (0.085, 0.036, 0.018), 0.006, ("toe spacer", "toe separators",
             "pedicure separator"), ("pink",)),
    _row("pill_cutter", _cutter, (0.0755, 0.0483, 0.0502), 0.04, ("pill splitter", "pill crusher",
             "tablet cutter"), ("sky",)),
    _row("false_eyelashes", _lashes, (0.11, 0.045, 0.0075), 0.008, ("false eyelash",
             "fake lashes", "eyelash extension", "lash tray", "false eyelashes case"), ("pink",),
             bodies=1, roles=("flat",)),
    _row("watch_link", _link, (0.0182, 0.0216, 0.003), 0.003, ("bracelet link",
             "chain links piece"), ("silver",)),
    _row("mainspring", _mainspring, (0.0281, 0.027, 0.00264), 0.002, ("clock spring",
             "spiral spring", "hairspring", "torsion spring"), ("silver",)),
    _row("watch_winder", _winder, (0.15, 0.175, 0.13), 0.9, ("watch winding box", "watch display",
             "watch stand", "watch box"), ("black",), bodies=2),
)  # fmt: skip
"""The module's categories."""
