"""Objects of the ``toys`` theme: props."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, metal, shine, wood
from ...kit.outlines import ellipse, smooth
from ...kit.parts import hull_part, ring_parts
from ...kit.primitives import at_block, at_box, ball, disc, rod, spindle, standing
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, ellipsoid, join, lathe, loft, prism, torus
from ...kit.surfaces import Look, tint_color
from ..vanity.jewelry import gold


@category("magic_wand", size=(0.303, 0.019, 0.0185), mass=0.04, material="wood",
          aliases=("wand", "wizard wand", "wooden wand", "magician wand", "fairy wand"),
          themes=("toys",), roles=("big",), colors=("brown",))  # fmt: skip
@from_pieces(foot=0.12, bodies=1)
def magic_wand(look: Look) -> Pieces:
    """A wooden wand lying flat: a turned grip with two metal bands and a tapered shaft."""
    tile = wood(look, "brown", "wooden", "black", "maroon")
    body = spindle((-0.15, 0.004), (-0.145, 0.009), (-0.135, 0.006), (-0.12, 0.0085),
                   (-0.1, 0.0065), (-0.085, 0.0095), (-0.075, 0.0055), (0.15, 0.0022),
                   (0.153, 0.001), z=0.009)  # fmt: skip
    bands = [spindle((x, 0.0094), (x + 0.003, 0.0094), z=0.0091) for x in (-0.118, -0.087)]
    return [(body, tile), (join(bands), shine(look, "gold", "silver"))]


@category("wizard_staff", size=(0.44, 0.06, 0.058), mass=0.3, material="wood",
          aliases=("wizard staff head", "magic staff", "staff with a crystal", "wizard stick"),
          themes=("toys",), roles=("big",), colors=("brown",))  # fmt: skip
@from_pieces(foot=0.08)
def wizard_staff(look: Look) -> Pieces:
    """A staff with a crystal ball in claws, lying flat, or a sceptre with a crown and a gem."""
    tile = wood(look, "brown", "wooden")
    stick = rod([(-0.24, 0, 0.012), (-0.1, 0.006, 0.012), (0.06, -0.004, 0.013), (0.12, 0, 0.03)],
                [0.009, 0.011, 0.012, 0.014], 10)  # fmt: skip
    orb = ball(0.05, 0.05, 0.05, (0.16, 0, 0.03), 20)
    claws = [rod([(0.115, 0, 0.03), (0.135, 0.03 * np.cos(a), 0.03 + 0.027 * np.sin(a)),
                  (0.165, 0.029 * np.cos(a), 0.03 + 0.026 * np.sin(a)), (0.188, 0.014 * np.cos(a),
                                                                         0.03 + 0.014 * np.sin(a))],
                 [0.007, 0.005, 0.004, 0.002], 8) for a in (0.6, 2.2, 3.8, 5.4)]  # fmt: skip
    color = look.own_color("cyan", "purple", "green", "red")
    return [(stick, tile), (orb, surfaces.gradient(color, tint_color(color, 1.6), look.rng)),
            (join(claws), tile)]  # fmt: skip


@category("sceptre", size=(0.41, 0.058, 0.06), mass=0.6, material="metal",
          aliases=("scepter", "royal sceptre", "king sceptre", "golden sceptre", "mace"),
          themes=("toys",), roles=("big",), colors=("gold",))  # fmt: skip
@from_pieces(foot=0.05)
def sceptre(look: Look) -> Pieces:
    """A metal sceptre lying flat: a turned rod, a coloured ball in two rings and a cross."""
    gold = metal(look, "gold", "gold", "silver")
    z = 0.03
    body = spindle((-0.2, 0.012), (-0.19, 0.016), (-0.18, 0.007), (-0.05, 0.0075), (-0.04, 0.014),
                   (-0.03, 0.0075), (0.1, 0.0075), (0.11, 0.02), (0.125, 0.024), (0.13, 0.01),
                   z=z)  # fmt: skip
    head = [ball(0.056, 0.056, 0.056, (0.15, 0, z), 18)]
    bands = [torus(0.028, 0.0028, 26, 6).move(0.15, 0, z),
             torus(0.028, 0.0028, 26, 6).turn(0, np.pi / 2).move(0.15, 0, z)]  # fmt: skip
    cross = [
        at_box(0.03, 0.006, 0.006, (0.193, 0, z - 0.003)),
        at_box(0.006, 0.022, 0.006, (0.195, 0, z - 0.003)),
    ]
    gem = ball(0.014, 0.014, 0.014, (-0.19, 0, z), 8)
    prop = at_box(0.02, 0.02, 0.02, (-0.19, 0, 0))
    return [(body, gold), (head[0], dye(look, "crimson", "navy", "purple")), (join(bands), gold),
            (join(cross), gold), (gem, dye(look, "crimson", "green")), (prop, gold)]  # fmt: skip


@category("potion_bottle", size=(0.08, 0.085, 0.116), mass=0.25, material="glass",
          aliases=("potion", "healing potion", "mana potion", "magic potion", "health potion",
          "love potion", "elixir", "poison bottle", "poison", "vial of potion"), themes=("toys",),
          colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=2)
def potion_bottle(look: Look) -> Pieces:
    """A round flask of glowing liquid with a cork and a tag."""
    color = look.color("red", "blue", "green", "purple", "magenta", "cyan")
    body = standing((0.02, 0), (0.036, 0.01), (0.04, 0.035), (0.03, 0.058), (0.012, 0.07),
                    (0.012, 0.095), (0.016, 0.098), (0.016, 0.102))  # fmt: skip
    glass = surfaces.stack((surfaces.plain(color), 6), (surfaces.plain(tint_color(color, 1.35)), 1),
                           (surfaces.plain((214, 228, 232)), 4))  # fmt: skip
    cork = disc(0.0105, 0.016, (0, 0, 0.1), top=0.0125)
    cord = torus(0.0135, 0.0022, 22, 6).move(z=0.076)
    tag = at_block(0.022, 0.03, 0.0016, 0.004).turn(0, np.pi / 2 - 0.3).move(0.006, -0.042, 0.028)
    return [(body, glass), (cork, dye(look, "tan", "brown")), (cord, dye(look, "beige", "brown")),
            (tag, dye(look, "cream", "beige"))]  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("manacles", size=(0.222, 0.072, 0.016), mass=0.4, material="metal",
          aliases=("handcuff", "shackles", "cuffs"), themes=("toys",), roles=("big",),
          colors=("charcoal",))  # fmt: skip
@from_pieces()
def manacles(look: Look) -> Pieces:
    """Two iron cuffs joined by a chain."""
    iron = metal(look, "charcoal", "gray", "silver")
    cuffs = [
        lathe([(0.031, 0), (0.036, 0), (0.036, 0.014), (0.031, 0.014)], 32, loop=True).move(
            x=s * 0.075
        )
        for s in (-1, 1)
    ]
    locks = [at_block(0.018, 0.018, 0.016, 0.004, (s * 0.04, 0, 0)) for s in (-1, 1)]
    links = [
        torus(0.0075, 0.002, 16, 6)
        .scale(1.3, 0.8, 1)
        .turn(0, (k % 2) * 0.9)
        .move(-0.026 + 0.013 * k, 0, 0.0065)
        for k in range(5)
    ]
    return [(cuffs[0], iron), (cuffs[1], iron), (locks[0], iron), (locks[1], iron),
            (join(links), iron)]  # fmt: skip


@category("quill_and_ink", size=(0.135, 0.06, 0.21), mass=0.12, material="glass", assembled=True,
          aliases=("quill in an inkwell", "inkwell with a quill", "quill pen",
          "ink bottle with a quill"), themes=("toys",), colors=("white",))  # fmt: skip
@from_pieces(bodies=1)
def quill_and_ink(look: Look) -> Pieces:
    """An inkwell with a feather standing in it."""
    glass = dye(look, "navy", "black", "teal")
    pot = standing(
        (0.022, 0), (0.028, 0.006), (0.028, 0.028), (0.014, 0.036), (0.014, 0.044), (0.018, 0.046)
    )
    ink = disc(0.012, 0.001, (0, 0, 0.0456))
    shaft = rod([(0.0, 0.004, 0.03), (0.02, 0.012, 0.09), (0.06, 0.02, 0.17), (0.09, 0.022, 0.2)],
                [0.0018, 0.0018, 0.0012, 0.0006], 6)  # fmt: skip
    color = look.color("white", "cream", "brown", "gray", "red")
    vane = rod(
        [(0.02, 0.012, 0.09), (0.045, 0.017, 0.14), (0.07, 0.021, 0.18), (0.1, 0.023, 0.205)],
        [0.003, 0.02, 0.018, 0.001],
        10,
    ).bend(lambda p: np.column_stack([p[:, 0], 0.016 + 0.12 * (p[:, 1] - 0.016), p[:, 2]]))
    return [(pot, glass), (vane, surfaces.stripes([color, tint_color(color, 0.88)], 16)),
            (shaft, dye(look, "cream")), (ink, BLACK)]  # fmt: skip


@category("sombrero", size=(0.392, 0.39, 0.129), mass=0.25, material="fabric", hollow=True,
          aliases=("mexican hat", "mariachi hat"), themes=("toys",), roles=("big", "round"),
          colors=("tan",))  # fmt: skip
def sombrero(look: Look) -> Shape:
    """A sombrero with a very wide, turned-up brim, a tall crown and bands of bright embroidery."""
    k, color = look.between(0.85, 1.0), look.color("tan", "red", "black", "green", "wooden")
    body = lathe([(0, 0), (0.15, 0), (0.2, 0.03), (0.205, 0.05), (0.195, 0.048), (0.15, 0.018),
                  (0.075, 0.014), (0.06, 0.07), (0.035, 0.125), (0.015, 0.138), (0, 0.138)],
                 40)  # fmt: skip
    bright = [(206, 44, 60), (250, 206, 60), (60, 150, 90), (52, 104, 190)]
    tile = surfaces.stack((surfaces.speckles(look.rng, color, 8), 0.38),
                          (surfaces.stripes(bright, 8, upright=True), 0.06),
                          (surfaces.speckles(look.rng, color, 8), 0.22),
                          (surfaces.stripes(bright[::-1], 10, upright=True), 0.06),
                          (surfaces.speckles(look.rng, color, 8), 0.28), side=160)  # fmt: skip
    pom = [ellipsoid(0.014, 0.014, 0.014, 6, 4).move(0.204 * np.cos(a), 0.204 * np.sin(a), 0.05)
           for a in np.arange(22) * 2 * np.pi / 22]  # fmt: skip
    return shape(
        [(body.scale(k, k, k), tile), (join(pom).scale(k, k, k), surfaces.plain((250, 206, 60)))],
        [
            hull_part(body.scale(k, k, k).vertices[body.vertices[:, 2] < 0.055]),
            hull_part(
                body.scale(k, k, k).vertices[
                    np.hypot(body.vertices[:, 0], body.vertices[:, 1]) < 0.08
                ]
            ),
        ],
    )


@category("mask", size=(0.198, 0.084, 0.042), mass=0.06, material="plastic", assembled=True,
          aliases=("carnival mask", "venetian mask", "theatre mask", "theater mask",
          "masquerade mask", "party mask"), themes=("toys", "living"), colors=("gold", "red"),
          state="lying flat")  # fmt: skip
def mask(look: Look) -> Shape:
    """A half mask lying on its back, with dark painted eye holes, gold trim and a feather."""
    color = look.color("red", "black", "purple", "gold", "white", "blue", "green")
    upper = smooth([(-0.09, 0.018), (-0.1, 0.05), (-0.06, 0.035), (0, 0.026), (0.06, 0.035),
                    (0.1, 0.05), (0.09, 0.018)], 3)  # fmt: skip
    lower = smooth([(0.09, 0.018), (0.075, -0.028), (0.03, -0.035), (0.008, -0.008), (0, 0.0),
                    (-0.008, -0.008), (-0.03, -0.035), (-0.075, -0.028), (-0.09, 0.018)],
                   3)  # fmt: skip
    outline = np.concatenate([upper[::-1], lower[::-1][1:-1]])

    def vault(p: np.ndarray) -> np.ndarray:
        rise = 0.034 * (1 - (p[:, 0] / 0.105) ** 2)
        return np.column_stack([p[:, :2], p[:, 2] + np.maximum(rise, 0)])

    def layer(points: np.ndarray, low: float, high: float) -> Solid:
        return prism(points, low, high).bend(vault)

    face = layer(outline, 0, 0.004)
    trim = layer(outline * 0.9, 0.0038, 0.0048)
    eyes = [layer(ellipse(0.038, 0.019, 16) + np.array([s * 0.042, 0.002]), 0.0045, 0.0056)
            for s in (-1, 1)]  # fmt: skip
    rims = [layer(ellipse(0.05, 0.03, 16) + np.array([s * 0.042, 0.002]), 0.0042, 0.0052)
            for s in (-1, 1)]  # fmt: skip
    gem = ball(0.013, 0.013, 0.008, (0, 0.014, 0.039), 10)
    gold = surfaces.plain((220, 178, 90) if color[0] < 190 or color[1] < 140 else (120, 40, 60))
    pieces: Pieces = [(face, gold), (trim, surfaces.speckles(look.rng, color, 5)),
                      (join(rims), gold), (join(eyes), surfaces.plain((26, 24, 28))),
                      (gem, surfaces.plain((200, 40, 70)))]  # fmt: skip
    return put_down(pieces, face, factor=look.between(0.88, 1.12), foot=0.25)


@category("crown", size=(0.16, 0.16, 0.07), mass=0.15, material="metal", hollow=True,
          aliases=("tiara", "diadem", "golden crown", "gold crown", "king crown", "queen crown"),
          themes=("toys", "vanity"), colors=("gold",))  # fmt: skip
def crown(look: Look) -> Shape:
    """A crown or tiara standing upright: a band with points, balls and gems."""
    color = look.color("gold", "gold", "silver", "copper")
    r, h = look.between(0.06, 0.078), look.between(0.055, 0.075)
    n, count = 60, 10
    a = 2 * np.pi * np.arange(n) / n
    tip = 0.5 * h + 0.5 * h * np.abs(np.cos(count / 2 * a)) ** 3
    outer = np.column_stack([r * np.cos(a), r * np.sin(a)])
    grow = 1.14
    rings = [
        np.column_stack([outer, np.zeros(n)]),
        np.column_stack([outer * grow, tip]),
        np.column_stack([outer * (grow - 0.04), tip]),
        np.column_stack([outer * 0.96, np.zeros(n)]),
    ]
    wall = loft(np.stack(rings), None, loop=True)
    band = torus(r, 0.0035, 44, 8).move(z=0.004)
    rim = torus(1.045 * r, 0.0025, 44, 6).move(z=0.38 * h)
    pearls = [ball(0.009, 0.009, 0.009, (grow * r * np.cos(b), grow * r * np.sin(b), h + 0.002), 8)
              for b in 2 * np.pi * np.arange(count) / count]  # fmt: skip
    stones = [ball(0.011, 0.011, 0.014, (1.03 * r * np.cos(b), 1.03 * r * np.sin(b), 0.2 * h), 8)
              for b in 2 * np.pi * np.arange(count) / count]  # fmt: skip
    half = len(stones) // 2
    first, second = look.own_color("red", "purple"), look.own_color("blue", "green")
    ring = ring_parts([(r, 0), (grow * r, h)], [(1.08 * r, h), (0.955 * r, 0)], 12)
    return shape([(join([wall, band, rim]), gold(look, color)),
                  (join(pearls), surfaces.plain((246, 242, 234))),
                  (join(stones[:half]), surfaces.plain(first)),
                  (join(stones[half:]), surfaces.plain(second))], ring)  # fmt: skip
