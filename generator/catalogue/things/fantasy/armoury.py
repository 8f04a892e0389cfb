"""Of knights, pirates and wizards: wands, potions, shields, blades, guns, chains."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    plate,
    shine,
    spindle,
    standing,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod
from ...build.solids import join, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows, wide


def _wand(look: Look) -> Pieces:
    tile = wood(look, "brown", "wooden", "black", "maroon")
    body = spindle(
        (-0.15, 0.004),
        (-0.145, 0.009),
        (-0.135, 0.006),
        (-0.12, 0.0085),
        (-0.1, 0.0065),
        (-0.085, 0.0095),
        (-0.075, 0.0055),
        (0.15, 0.0022),
        (0.153, 0.001),
        z=0.009,
    )
    bands = [spindle((x, 0.0094), (x + 0.003, 0.0094), z=0.0091) for x in (-0.118, -0.087)]
    return [(body, tile), (join(bands), shine(look, "gold", "silver"))]


def _staff(look: Look) -> Pieces:
    """A staff with claws round a crystal ball, lying; or a sceptre with a crown and a gem."""
    tile = wood(look, "brown", "wooden")
    stick = rod(
        [(-0.24, 0, 0.012), (-0.1, 0.006, 0.012), (0.06, -0.004, 0.013), (0.12, 0, 0.03)],
        [0.009, 0.011, 0.012, 0.014],
        10,
    )
    orb = ball(0.05, 0.05, 0.05, (0.16, 0, 0.03), 20)
    claws = [
        rod(
            [
                (0.115, 0, 0.03),
                (0.135, 0.03 * np.cos(a), 0.03 + 0.027 * np.sin(a)),
                (0.165, 0.029 * np.cos(a), 0.03 + 0.026 * np.sin(a)),
                (0.188, 0.014 * np.cos(a), 0.03 + 0.014 * np.sin(a)),
            ],
            [0.007, 0.005, 0.004, 0.002],
            8,
        )
        for a in (0.6, 2.2, 3.8, 5.4)
    ]
    color = look.own_color("cyan", "purple", "green", "red")
    return [
        (stick, tile),
        (orb, textures.gradient(color, tint_color(color, 1.6), look.rng)),
        (join(claws), tile),
    ]


def _sceptre(look: Look) -> Pieces:
    gold = metal(look, "gold", "gold", "silver")
    z = 0.03
    body = spindle(
        (-0.2, 0.012),
        (-0.19, 0.016),
        (-0.18, 0.007),
        (-0.05, 0.0075),
        (-0.04, 0.014),
        (-0.03, 0.0075),
        (0.1, 0.0075),
        (0.11, 0.02),
        (0.125, 0.024),
        (0.13, 0.01),
        z=z,
    )
    head = [ball(0.056, 0.056, 0.056, (0.15, 0, z), 18)]
    bands = [
        torus(0.028, 0.0028, 26, 6).move(0.15, 0, z),
        torus(0.028, 0.0028, 26, 6).turn(0, np.pi / 2).move(0.15, 0, z),
    ]
    cross = [
        at_box(0.03, 0.006, 0.006, (0.193, 0, z - 0.003)),
        at_box(0.006, 0.022, 0.006, (0.195, 0, z - 0.003)),
    ]
    gem = ball(0.014, 0.014, 0.014, (-0.19, 0, z), 8)
    prop = at_box(0.02, 0.02, 0.02, (-0.19, 0, 0))
    return [
        (body, gold),
        (head[0], dye(look, "crimson", "navy", "purple")),
        (join(bands), gold),
        (join(cross), gold),
        (gem, dye(look, "crimson", "green")),
        (prop, gold),
    ]


def _potion(look: Look) -> Pieces:
    """A round flask of glowing liquid with a cork and a tag."""
    color = look.color("red", "blue", "green", "purple", "magenta", "cyan")
    body = standing(
        (0.02, 0),
        (0.036, 0.01),
        (0.04, 0.035),
        (0.03, 0.058),
        (0.012, 0.07),
        (0.012, 0.095),
        (0.016, 0.098),
        (0.016, 0.102),
    )
    glass = textures.stack(
        (textures.plain(color), 6),
        (textures.plain(tint_color(color, 1.35)), 1),
        (textures.plain((214, 228, 232)), 4),
    )
    cork = disc(0.0105, 0.016, (0, 0, 0.1), top=0.0125)
    cord = torus(0.0135, 0.0022, 22, 6).move(z=0.076)
    tag = at_block(0.022, 0.03, 0.0016, 0.004).turn(0, np.pi / 2 - 0.3).move(0.006, -0.042, 0.028)
    return [
        (body, glass),
        (cork, dye(look, "tan", "brown")),
        (cord, dye(look, "beige", "brown")),
        (tag, dye(look, "cream", "beige")),
    ]


def _shield(look: Look) -> Pieces:
    """A heater shield lying: a rim, a quartered field, a boss."""
    a, b = (
        look.color("red", "blue", "wooden", "green", "purple"),
        look.own_color("white", "gold", "yellow", "silver"),
    )
    outline = np.concatenate(
        [
            [(-0.1, 0.12), (-0.1, 0.0)],
            smooth([(-0.1, 0.0), (-0.085, -0.06), (-0.045, -0.11), (0, -0.14)], 5)[1:],
            smooth([(0, -0.14), (0.045, -0.11), (0.085, -0.06), (0.1, 0.0)], 5)[1:],
            [(0.1, 0.12)],
        ]
    )
    image = prints.canvas(96, 124, a)
    prints.fill(image, 0.5, 0, 0.5, 0.46, b)
    prints.fill(image, 0, 0.46, 0.5, 0.54, b)
    wooden = look.attributes.get("material", "").startswith("wood") or look.chance(0.25)
    field = textures.wood(look.rng, a) if wooden else image
    body, front = plate(outline, 0.012), plate(0.92 * outline + [0, -0.001], 0.002, 0.011)
    boss = ball(0.044, 0.044, 0.02, (0, 0.01, 0.013), 18)
    studs = [
        disc(0.0045, 0.003, (x, y, 0.0115), sides=10)
        for x, y in (
            (-0.094, 0.113),
            (0.094, 0.113),
            (0, 0.114),
            (-0.094, 0.03),
            (0.094, 0.03),
            (0, -0.13),
            (-0.06, -0.087),
            (0.06, -0.087),
        )
    ]
    return [
        (body, shine(look, "silver", "gold", "bronze")),
        (boss, shine(look, "silver", "gold")),
        (front, field),
        (join(studs), shine(look, "silver", "gold")),
    ]


def _blade(bend: float, long: float, wide: float, guard: str) -> Drawing:
    """A sword, cutlass or dagger lying: blade, guard, grip, pommel."""

    def draw(look: Look) -> Pieces:
        steel = look.surface(
            look.color("silver", "gray", "wooden" if guard == "toy" else "silver"),
            "metal" if guard != "toy" else "wood",
        )
        z = 0.008
        t = np.linspace(0, 1, 14)
        mid = np.column_stack([long * t, bend * t**2])
        half = 0.5 * wide * np.where(t < 0.75, 1, np.maximum((1 - t) / 0.25, 0.02) ** 0.7)
        outline = np.concatenate(
            [mid + np.column_stack([0 * t, -half]), (mid + np.column_stack([0 * t, half]))[::-1]]
        )
        edge = plate(outline, 0.003, z - 0.0015)
        ridge = plate(
            np.concatenate(
                [np.add(mid[:11], (0, -0.12 * wide)), np.add(mid[:11], (0, 0.12 * wide))[::-1]]
            ),
            0.005,
            z - 0.0025,
        )
        gold = shine(look, "gold", "brass", "silver")
        cross = at_block(
            0.012, 0.085 if guard != "cut" else 0.05, 0.014, 0.005, (-0.004, 0, z - 0.007)
        )
        grip = spindle((-0.085, 0.007), (-0.045, 0.0085), (-0.008, 0.007), z=z)
        end = ball(0.02, 0.02, 0.016, (-0.092, 0, z), 14)
        foot = at_box(0.4 * long, 0.5 * wide, z, (0.42 * long, bend * 0.18, 0))
        pieces: Pieces = [
            (edge, steel),
            (cross, gold),
            (grip, dye(look, "brown", "black", "maroon")),
            (end, gold),
            (foot, steel),
            (ridge, steel),
        ]
        if guard == "cut":
            bow = rod(
                [(0.0, -0.022, z), (-0.03, -0.045, z), (-0.075, -0.036, z), (-0.094, 0, z)],
                0.0035,
                8,
                5,
            )
            pieces.append((bow, gold))
        if guard == "gem":
            gems = [
                ball(0.009, 0.009, 0.007, p, 8)
                for p in (
                    (-0.004, 0, z + 0.007),
                    (-0.004, 0.026, z + 0.007),
                    (-0.004, -0.026, z + 0.007),
                    (-0.092, 0, z + 0.008),
                )
            ]
            pieces.append((join(gems), dye(look, "crimson", "green", "blue")))
        return pieces

    return draw


_row = Rows("toys", ("brown",), role=wide).of_drawing


CATEGORIES = (
    _row("magic_wand", _wand, (0.303, 0.019, 0.0185), 0.04, ("wand", "wizard wand", "wooden wand",
             "magician wand", "fairy wand"), foot=0.12, bodies=1),
    _row("wizard_staff", _staff, (0.44, 0.06, 0.058), 0.3, ("wizard staff head", "magic staff",
             "staff with a crystal", "wizard stick"), foot=0.08),
    _row("sceptre", _sceptre, (0.41, 0.058, 0.06), 0.6, ("scepter", "royal sceptre",
             "king sceptre", "golden sceptre", "mace"), ("gold",), 0.05),
    _row("potion_bottle", _potion, (0.08, 0.085, 0.116), 0.25, ("potion", "healing potion",
             "mana potion", "magic potion", "health potion", "love potion", "elixir",
             "poison bottle", "poison", "vial of potion"), ("red", "blue"), bodies=2),
    _row("toy_shield", _shield, (0.2, 0.26, 0.0235), 0.4, ("shield", "wooden shield",
             "knight shield", "medieval shield", "mini shield"), ("red", "blue"), bodies=2),
    _row("toy_sword", _blade(0.0, 0.3, 0.03, "toy"), (0.4, 0.085, 0.016), 0.2, ("sword",
             "wooden sword", "knight sword", "mini sword", "play sword", "katana",
             "samurai sword", "foam sword"), ("silver", "wooden")),
    _row("cutlass", _blade(0.055, 0.26, 0.032, "cut"), (0.361, 0.105, 0.0165), 0.3, ("pirate sword",
             "sabre", "saber", "scimitar"), ("silver",)),
)  # fmt: skip
"""The module's categories."""
