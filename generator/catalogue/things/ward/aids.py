"""Medical and dental aids: tests, probes, bins, teeth, plates, pads."""

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
    wood,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, torus, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


WHITE = textures.plain((244, 243, 240))


def _scope(look: Look) -> Pieces:
    """An otoscope lying: a handle, a round head with a cone."""
    z = 0.016
    grip = spindle((-0.11, 0.012), (-0.1, 0.0155), (0.02, 0.0145), (0.03, 0.011), z=z)
    neck = spindle((0.03, 0.008), (0.055, 0.008), z=z)
    head = disc(0.019, 0.024, (0.07, 0, 0.004))
    cone = straight((0.07, -0.012, z), (0.07, -0.05, z), (0.011, 0.003), 14)
    lens = disc(0.013, 0.014).turn(0, -np.pi / 2).move(0.07, 0.012, z)
    return [
        (grip, plastic(look, "black", "navy", "silver")),
        (head, dye(look, "black", "silver")),
        (neck, shine(look)),
        (cone, BLACK),
        (lens, shine(look)),
    ]


def _spatula(look: Look) -> Pieces:
    return [(at_block(0.15, 0.018, 0.0016, 0.0088), wood(look, "beige", "cream", "tan"))]


def _bin(look: Look) -> Pieces:
    """A yellow sharps bin with a lid and a warning sign."""
    body = at_block(0.13, 0.1, 0.16, 0.014)
    lid = at_block(0.136, 0.106, 0.03, 0.016, (0, 0, 0.158))
    slot = at_block(0.06, 0.03, 0.004, 0.01, (0, 0.01, 0.186))
    image = prints.canvas(64, 64, (246, 206, 60))
    prints.disc(image, 0.5, 0.38, 0.24, (30, 30, 32), 0.19)
    for k in range(3):
        a = np.pi / 2 + k * 2.0944
        prints.disc(
            image, 0.5 + 0.15 * np.cos(a), 0.38 - 0.15 * np.sin(a), 0.11, (30, 30, 32), 0.06
        )
    prints.write(image, "SHARPS", 0.5, 0.82, 0.2, (30, 30, 32), True)
    return [
        (body, plastic(look, "yellow", "yellow", "red")),
        (lid, dye(look, "red", "orange", "blue")),
        (slot, BLACK),
        (at_box(0.09, 0.002, 0.1, (0, -0.0505, 0.025)), image),
    ]


def _cassette(kind: str) -> Drawing:
    """A test stick or cassette with a window and lines."""

    def draw(look: Look) -> Pieces:
        lines = look.pick([1, 2])
        if kind == "cassette":
            body = at_block(0.07, 0.02, 0.005, 0.006)
            image = prints.canvas(160, 44, (246, 246, 244))
            prints.fill(image, 0.3, 0.25, 0.3, 0.5, (226, 232, 240))
            for k in range(lines):
                prints.fill(image, 0.38 + 0.1 * k, 0.27, 0.022, 0.46, (200, 40, 70))
            prints.disc(image, 0.8, 0.5, 0.3, (190, 198, 208))
            return [
                (body, plastic(look, "white", "cream")),
                (at_box(0.064, 0.0165, 0.0005, (0, 0, 0.0048)), image),
            ]
        body = at_block(0.12, 0.018, 0.011, 0.007)
        cap = at_block(0.04, 0.02, 0.0125, 0.007, (0.052, 0, 0))
        image = prints.canvas(96, 24, (236, 240, 244))
        for k in range(lines):
            prints.fill(image, 0.35 + 0.2 * k, 0.1, 0.06, 0.8, (214, 60, 120))
        return [
            (body, plastic(look, "white", "cream")),
            (cap, dye(look, "pink", "blue", "purple")),
            (at_block(0.034, 0.009, 0.0006, 0.003, (-0.018, 0, 0.0107)), image),
        ]

    return draw


def _strip(look: Look) -> Pieces:
    image = prints.canvas(160, 16, (246, 244, 236))
    for k, name in enumerate(("yellow", "orange", "green", "teal")):
        prints.fill(image, 0.04 + 0.12 * k, 0, 0.1, 1, look.own_color(name))
    return [(at_box(0.075, 0.0075, 0.0009), image)]


def _hearing(look: Look) -> Pieces:
    tile = plastic(look, "beige", "gray", "silver", "brown")
    body = rod(
        [
            (-0.014, -0.006, 0.006),
            (-0.006, 0.008, 0.006),
            (0.008, 0.008, 0.006),
            (0.014, -0.002, 0.006),
        ],
        [0.0045, 0.006, 0.006, 0.0035],
        12,
    )
    pipe = rod([(0.014, -0.002, 0.006), (0.026, -0.012, 0.004), (0.022, -0.028, 0.003)], 0.0012, 6)
    bud = ball(0.009, 0.009, 0.009, (0.021, -0.031, 0.0044), 12)
    return [
        (body, tile),
        (pipe, textures.plain((226, 232, 236))),
        (bud, textures.plain((214, 222, 226))),
    ]


def _tooth(gold: bool, long: float) -> Drawing:
    """A molar: a crown with cusps on two roots, standing on its roots or lying."""

    def draw(look: Look) -> Pieces:
        color = look.color(*(("gold",) if gold else ("white", "ivory", "cream")))
        tile = (
            look.surface(color, "metal")
            if gold
            else textures.gradient(tint_color(color, 0.86), tint_color(color, 1.2), look.rng)
        )
        k = long / 0.02
        crown = at_block(0.0105, 0.0105, 0.008, 0.004, (0, 0, 0.0105))
        cusps = [
            ball(0.0058, 0.0058, 0.005, (x * 0.0026, y * 0.0026, 0.018), 10)
            for x in (-1, 1)
            for y in (-1, 1)
        ]
        roots = [
            rod(
                [
                    (x * 0.0026, y * 0.0022, 0.012),
                    (x * 0.0034, y * 0.003, 0.006),
                    (x * 0.0028, y * 0.0026, 0.0),
                ],
                [0.0034, 0.0026, 0.0016],
                10,
            )
            for x in (-1, 1)
            for y in (-1, 1)
        ]
        return [(s.scale(k, k, k), tile) for s in (crown, join(roots), join(cusps))]

    return draw


def _denture(full: bool) -> Drawing:
    """A dental plate, or a pair of jaws on a hinge."""

    def draw(look: Look) -> Pieces:
        pieces: Pieces = []
        gum = plastic(look, "pink", "coral")
        for level in range(2 if full else 1):
            a = np.linspace(0.15, np.pi - 0.15, 18)
            way = np.column_stack([0.026 * np.cos(a), 0.032 * np.sin(a) - 0.01, 0 * a + 0.007])
            base = tube(way, 0.0068, 10)
            teeth = [
                at_box(0.0058, 0.0052, 0.009, (0.026 * np.cos(t), 0.032 * np.sin(t) - 0.01, 0.01))
                for t in np.linspace(0.2, np.pi - 0.2, 14)
            ]
            palate = disc(0.022, 0.004, (0, -0.002, 0.0))
            group = [(base, gum), (join(teeth), WHITE), (palate, gum)]
            if level:
                group = [(s.turn(1, np.pi).turn(0, -0.35).move(z=0.047), t) for s, t in group]
            pieces += group
        return [(s.turn(2, np.pi), t) for s, t in pieces]

    return draw


def _retainer(wire: bool) -> Drawing:
    def draw(look: Look) -> Pieces:
        """A mouth plate: a horseshoe tray, or a plate with a wire."""
        a = np.linspace(0.1, np.pi - 0.1, 26)
        color = look.color("sky", "pink", "clear", "purple", "green")
        if not wire:
            inner, outer = (
                np.column_stack([r * np.cos(a), 1.2 * r * np.sin(a)]) for r in (0.021, 0.034)
            )
            floor = plate(np.concatenate([outer, inner[::-1]]) - [0, 0.018], 0.003)
            rims = [
                tube(
                    np.column_stack([r * np.cos(a), 1.2 * r * np.sin(a) - 0.018, 0 * a + 0.0065]),
                    0.0052,
                    6,
                    squash=1.2,
                )
                for r in (0.0335, 0.0215)
            ]
            tile = textures.plain(color)
            return [(floor, tile), (rims[0], tile), (rims[1], tile)]
        body = ball(0.05, 0.046, 0.02, (0, -0.004, 0.004), 20)
        wires = tube(
            np.column_stack([0.027 * np.cos(a), 0.03 * np.sin(a) - 0.006, 0 * a + 0.008]), 0.0009, 6
        )
        loops = [torus(0.005, 0.0008, 14, 5).move(s * 0.027, -0.004, 0.008) for s in (-1, 1)]
        return [
            (body, textures.spots(look.rng, color, tint_color(color, 1.5), 0.1)),
            (join([wires, *loops]), shine(look)),
        ]

    return draw


def _moulded_piece(look: Look) -> Pieces:
    """A plaster cast of a jaw on a base."""
    color = look.color("white", "cream", "yellow", "beige")
    tile = textures.speckles(look.rng, color, 5)
    a = np.linspace(0, np.pi, 20)
    base = plate(
        np.concatenate([np.column_stack([0.036 * np.cos(a), 0.045 * np.sin(a)])]) - [0, 0.02], 0.018
    )
    ridge = tube(
        np.column_stack(
            [0.027 * np.cos(a[1:-1]), 0.034 * np.sin(a[1:-1]) - 0.016, 0 * a[1:-1] + 0.018]
        ),
        0.007,
        8,
    )
    teeth = [
        at_block(0.0062, 0.006, 0.01, 0.002, (0.027 * np.cos(t), 0.034 * np.sin(t) - 0.016, 0.021))
        for t in np.linspace(0.2, np.pi - 0.2, 14)
    ]
    return [(base, tile), (ridge, tile), (join(teeth), textures.plain(tint_color(color, 1.2)))]


_row = Rows("lab", ("white",)).of_drawing


CATEGORIES = (
    _row("otoscope", _scope, (0.203, 0.0777, 0.0317), 0.12, ("ophthalmoscope", "ear scope",
             "dermatoscope", "laryngoscope"), ("black",), 0.08),
    _row("tongue_depressor", _spatula, (0.15, 0.018, 0.0016), 0.002, ("tongue spatula",
             "wooden spatula stick",
             "ice cream stick wooden"), ("beige",), roles=("flat",)),
    _row("sharps_container", _bin, (0.136, 0.106, 0.19), 0.3, ("sharps bin", "sharps box",
             "biohazard bin", "needle bin"), ("yellow",), bodies=2, roles=("tall",)),
    vary(_row("covid_test", _cassette("cassette"), (0.07, 0.02, 0.0053), 0.006,
             ("lateral flow test",
             "rapid test", "antigen test", "covid test kit", "test cassette",
             "rapid antigen test"), roles=("flat",)), 0.08),
    _row("pregnancy_test", _cassette("stick"), (0.134, 0.02, 0.0125), 0.012, ("test stick",
             "ovulation test"), bodies=2),
    vary(_row("test_strip", _strip, (0.075, 0.0075, 0.0009), 0.001, ("ph strip", "litmus paper",
             "urine test strip", "glucose strip", "ph paper", "indicator paper"), ("yellow",),
             roles=("flat",)), 0.08),
    _row("hearing_aid", _hearing, (0.046, 0.05, 0.012), 0.005, ("cochlear implant", "ear piece",
             "earpiece"), ("beige",), 0.1),
    _row("tooth", _tooth(False, 0.02), (0.0117, 0.0107, 0.0198), 0.002, ("molar", "human tooth",
             "milk tooth", "baby tooth", "false tooth", "wisdom tooth", "canine tooth",
             "dental crown")),
    _row("tooth_model", _tooth(False, 0.1), (0.0599, 0.0546, 0.101), 0.15, ("model tooth",
             "giant tooth", "dental model of a tooth")),
    _row("gold_tooth", _tooth(True, 0.02), (0.0116, 0.0105, 0.0195), 0.006, ("golden tooth",),
             ("gold",)),
    _row("denture", _denture(False), (0.066, 0.05, 0.019), 0.02, ("dental plate", "upper denture",
             "dental bridge"), ("pink",), bodies=(0, 2)),
    _row("false_teeth", _denture(True), (0.0628, 0.051, 0.0534), 0.04, ("set of false teeth",
             "dentures", "jaw model", "set of dentures", "articulator", "chattering teeth",
             "wind up teeth", "model teeth", "teeth model"), ("pink",)),
    _row("mouth_guard", _retainer(False), (0.0788, 0.0444, 0.0122), 0.015, ("mouthguard",
             "gum shield", "aligner", "dental aligner", "bite guard", "night guard",
             "clear aligner"), ("sky",), bodies=1),
    _row("retainer", _retainer(True), (0.066, 0.05, 0.014), 0.012, ("dental retainer",
             "dental brace", "braces retainer", "orthodontic retainer", "orthodontic brace"),
             ("sky", "pink"), bodies=1),
    _row("dental_mould", _moulded_piece, (0.0739, 0.046, 0.0318), 0.08, ("dental mold",
             "dental cast",
             "plaster teeth", "dental impression", "jaw cast")),
)  # fmt: skip
"""The module's categories."""
