"""Objects of the ``living`` theme: clothes."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import leather, steel
from ...kit.outlines import rectangle, smooth
from ...kit.parts import above, hull_of, hull_part, ring_parts
from ...kit.primitives import at_box, ball, drum, facing, limb, pad, plate, rod, spread, straight
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import (
    Solid,
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
from ...kit.surfaces import RGB, Look, Tile, plain, readable_on, tint_color
from .cleaners import STEEL


@category("sash", size=(0.289, 0.18, 0.00865), mass=0.03, material="fabric", assembled=True,
          aliases=("birthday sash", "satin sash", "pageant sash", "winner's sash"),
          themes=("living",), colors=("pink",), state="lying flat")  # fmt: skip
def sash(look: Look) -> Shape:
    """A satin sash with lettering, lying in a loop."""
    k = look.between(0.94, 1.06)
    color = look.color("pink", "white", "red", "purple", "gold", "sky")
    u = np.linspace(0, 1, 26)
    turn = np.pi * (0.12 + 0.76 * u)
    image = prints.canvas(320, 48, color)
    ink = readable_on(color) if sum(color) > 380 else (246, 220, 140)
    prints.write(image, look.pick(["BIRTHDAY GIRL", "BIRTHDAY BOY", "WINNER", "BRIDE TO BE"]), 0.5,
                 0.5, 0.6, ink, bold=True)  # fmt: skip
    grid = np.stack([np.stack([(0.13 + s * 0.022) * -np.cos(turn), (0.11 + s * 0.022) * -np.sin(
        turn) + 0.06, 0.0006 + 0.0012 * np.sin(9 * u) ** 2], -1) for s in (1, -1)])  # fmt: skip
    front = spread(grid, 0.0016)
    uv = np.column_stack(
        [np.tile(np.concatenate([u, u]), 2), np.tile(np.repeat([0.0, 1.0], 26), 2)]
    )
    front = Solid(front.vertices, front.faces, uv)
    back = limb([(-0.118, 0.02, 0.004), (-0.06, 0.075, 0.006), (0.05, 0.078, 0.006),
                 (0.118, 0.02, 0.004)], [0.02] * 4, 8, squash=0.14)  # fmt: skip
    return put_down([(front, image), (back, surfaces.plain(tint_color(color, 0.88)))], front, back,
                    factor=k)  # fmt: skip


@category("buckle", size=(0.0611, 0.052, 0.00956), mass=0.05, material="metal",
          aliases=("belt buckle", "brass buckle", "metal buckle"), themes=("living",),
          roles=("flat",), colors=("silver",))  # fmt: skip
def buckle(look: Look) -> Shape:
    """A belt buckle lying flat: a frame, a bar and a prong."""
    color = look.color("silver", "gold", "bronze", "copper")
    k = look.between(0.8, 1.2)
    a = rectangle(0.06, 0.05, look.pick([0.004, 0.012, 0.02]), 5)
    path = np.column_stack([a, np.full(len(a), 0.0032)])
    frame = tube(path, 0.0034, 8, loop=True)
    rail = at_box(0.004, 0.046, 0.004, (-0.008, 0, 0.001))
    prong = rod([(-0.008, 0, 0.006), (0.01, 0, 0.0085), (0.031, 0, 0.0078)], 0.0019, 8)
    return put_down([(join([frame, rail, prong]), steel(look, color))], frame, factor=k)


CLOTH = ("navy", "red", "gray", "teal", "black", "pink", "sky", "green", "white")


def cloth(look: Look, color: RGB) -> Tile:
    """Return a texture of plain, striped or checked cloth."""
    kind = look.pick([0, 0, 1, 2])
    if kind == 1:
        return surfaces.stripes([color, color, tint_color(color, 1.5)], 7, upright=look.chance(0.5))
    return surfaces.fabric(look.rng, color, tint_color(color, 1.45) if kind == 2 else None)


def mirror(half: list[tuple[float, float]]) -> np.ndarray:
    """Return the symmetric outline whose right half, from bottom to top, is ``half``."""
    right = np.array(half, float)
    left = right[::-1] * [-1, 1]
    return np.concatenate([right, left[np.abs(left[:, 0]) > 1e-9]])


@category("shorts", size=(0.244, 0.202, 0.0157), mass=0.15, material="fabric",
          aliases=("pair of shorts", "boxer shorts", "swimming trunks", "swim shorts", "trunks",
          "swim trunks", "running shorts", "boxers"), themes=("living",), roles=("flat", "big"),
          colors=("navy", "red"))  # fmt: skip
def shorts(look: Look) -> Shape:
    """Shorts with a waistband and a drawstring, lying flat."""
    color = look.color(*CLOTH)
    k, leg = look.between(0.9, 1.1), look.between(0.9, 1.15)
    rim = mirror([(0.0, -0.03), (0.018, -0.115 * leg), (0.125, -0.1 * leg), (0.1, 0.085)])
    body = plate(rim, 0.012)
    band = at_box(0.2, 0.022, 0.0135, (0, 0.078, 0))
    seam = at_box(0.003, 0.11, 0.001, (0, 0.022, 0.0118))
    hems = [plate([(s * 0.0165, -0.104 * leg), (s * 0.018, -0.115 * leg), (s * 0.125, -0.1 * leg),
                 (s * 0.1225, -0.088 * leg)], 0.013) for s in (-1, 1)]  # fmt: skip
    cords = [tube(smooth([(s * 0.004, 0.078, 0.0145), (s * 0.014, 0.05, 0.0142),
                          (s * 0.01, 0.03, 0.0142)], 4), 0.0018, 6) for s in (-1, 1)]  # fmt: skip
    dark = plain(tint_color(color, 0.65))
    return put_down([(body, cloth(look, color)),
                     (join([band, *hems]), plain(tint_color(color, 0.85))), (seam, dark),
                     (join(cords), plain((240, 238, 230)))], body, band, factor=k)  # fmt: skip


@category("briefs", size=(0.235, 0.158, 0.0107), mass=0.05, material="fabric",
          aliases=("underpants", "knickers", "panties", "underwear", "pair of knickers"),
          themes=("living",), roles=("flat", "big"), colors=("white",))  # fmt: skip
def briefs(look: Look) -> Shape:
    """Underpants, lying flat."""
    color = look.color("white", "pink", "gray", "black", "sky", "red", "lavender")
    k = look.between(0.9, 1.1)
    rim = mirror([(0.0, -0.075), (0.026, -0.07), (0.05, -0.02), (0.115, 0.03), (0.105, 0.075)])
    body = plate(rim, 0.008)
    band = plate([(-0.105, 0.06), (0.105, 0.06), (0.104, 0.08), (-0.104, 0.08)], 0.0105)
    edge = [tube(smooth([(s * 0.026, -0.07, 0.0075), (s * 0.05, -0.02, 0.0075),
                         (s * 0.114, 0.029, 0.0075)], 4), 0.0022, 6) for s in (-1, 1)]  # fmt: skip
    trim = plain(tint_color(color, 0.75) if sum(color) > 260 else (210, 210, 214))
    return put_down([(body, cloth(look, color)), (join([band, *edge]), trim)], body, band, factor=k)


@category("bra", size=(0.295, 0.172, 0.0388), mass=0.08, material="fabric",
          aliases=("brassiere", "sports bra"), themes=("living",), roles=("big",),
          colors=("white", "pink"))  # fmt: skip
def bra(look: Look) -> Shape:
    """A bra with two cups, straps and a band, lying flat."""
    color = look.color("white", "black", "pink", "red", "lavender", "beige", "teal")
    k = look.between(0.9, 1.1)
    cups = [ball(0.105, 0.1, 0.075, (s * 0.056, 0, 0.002), 20) for s in (-1, 1)]
    band = at_box(0.3, 0.034, 0.006, (0, -0.028, 0))
    straps = [tube(smooth([(s * 0.07, 0.03, 0.026), (s * 0.075, 0.09, 0.004),
                           (s * 0.1, 0.12, 0.004), (s * 0.14, 0.06, 0.004),
                           (s * 0.142, -0.02, 0.004)], 5), 0.0055, 8, squash=0.5)
              for s in (-1, 1)]  # fmt: skip
    bow = [ball(0.014, 0.01, 0.008, (s * 0.007, -0.02, 0.02), 8) for s in (-1, 1)]
    lace = [tube(smooth([(s * (0.056 - 0.05 * np.cos(a)), 0.046 * np.sin(a), 0.012)
                         for a in np.linspace(0.2, np.pi - 0.2, 7)], 3), 0.003, 6)
            for s in (-1, 1)]  # fmt: skip
    trim = plain(tint_color(color, 0.7) if sum(color) > 240 else (120, 120, 126))
    return put_down([(join([*cups, band]), surfaces.speckles(look.rng, color, 4)),
                     (join([*straps, *bow, *lace]), trim)], *cups, band, *straps,
                    factor=k)  # fmt: skip


@category("swimsuit", size=(0.177, 0.291, 0.00883), mass=0.12, material="fabric",
          aliases=("swimming costume", "bathing suit", "one-piece swimsuit", "leotard"),
          themes=("living",), roles=("flat", "big"), colors=("navy", "red"))  # fmt: skip
def swimsuit(look: Look) -> Shape:
    """A one-piece swimsuit, lying flat."""
    color = look.color("navy", "red", "teal", "pink", "black", "yellow")
    k = look.between(0.85, 1.1)
    half = [(0.0, -0.15), (0.022, -0.145), (0.05, -0.09), (0.088, -0.05), (0.068, 0.02),
            (0.075, 0.06), (0.05, 0.085), (0.056, 0.14), (0.042, 0.14), (0.036, 0.08),
            (0.0, 0.055)]  # fmt: skip
    body = plate(mirror(half), 0.008)
    belt = plate([(-0.0715, 0.0), (0.0715, 0.0), (0.0695, 0.016), (-0.0695, 0.016)], 0.0088)
    return put_down([(body, cloth(look, color)), (belt, plain(look.own_color("white", "yellow",
                                                                             "navy")))], body,
                    factor=k)  # fmt: skip


@category("bikini", size=(0.289, 0.26, 0.0103), mass=0.08, material="fabric",
          aliases=("bikini top", "two-piece swimsuit"), themes=("living",), roles=("flat", "big"),
          colors=("red",))  # fmt: skip
def bikini(look: Look) -> Shape:
    """A bikini lying flat, with its top above its bottom."""
    color = look.color("red", "yellow", "turquoise", "pink", "navy", "orange")
    k = look.between(0.9, 1.1)
    cups = [plate([(s * 0.004, 0.03), (s * 0.085, 0.03), (s * 0.05, 0.1)], 0.01) for s in (-1, 1)]
    band = tube(
        smooth([(-0.14, 0.036, 0.003), (0, 0.03, 0.003), (0.14, 0.036, 0.003)], 5), 0.003, 8
    )
    ties = [tube(smooth([(s * 0.05, 0.095, 0.003), (s * 0.045, 0.13, 0.003),
                         (s * 0.02, 0.15, 0.003)], 4), 0.0025, 8) for s in (-1, 1)]  # fmt: skip
    rim = mirror([(0.0, -0.1), (0.02, -0.096), (0.04, -0.05), (0.085, -0.025), (0.082, 0.0)])
    low = plate(rim, 0.008)
    knots = [tube(smooth([(s * 0.083, -0.012, 0.004), (s * 0.105, -0.02, 0.004),
                          (s * 0.11, -0.045, 0.003)], 4), 0.0025, 8) for s in (-1, 1)]  # fmt: skip
    return put_down([(join([*cups, low]), cloth(look, color)), (join([band, *ties, *knots]),
                     plain(tint_color(color, 0.75)))], *cups, low, band, factor=k)  # fmt: skip


@category("waistcoat", size=(0.232, 0.318, 0.014), mass=0.3, material="fabric",
          aliases=("suit vest", "gilet", "formal vest"), themes=("living",), roles=("flat", "big"),
          colors=("charcoal",))  # fmt: skip
def waistcoat(look: Look) -> Shape:
    """A buttoned waistcoat, lying flat."""
    color = look.color("charcoal", "navy", "brown", "gray", "maroon", "black", "olive")
    k = look.between(0.85, 1.05)
    half = [(0.0, -0.14), (0.03, -0.165), (0.05, -0.145), (0.12, -0.135), (0.115, 0.0),
            (0.09, 0.075), (0.095, 0.15), (0.05, 0.165), (0.0, 0.03)]  # fmt: skip
    body = plate(mirror(half), 0.012)
    back = plate([(-0.055, 0.02), (0.055, 0.02), (0.05, 0.16), (-0.05, 0.16)], 0.006)
    edge = [tube(np.array([(s * 0.049, 0.163, 0.0118), (s * 0.002, 0.032, 0.0118)]), 0.0022, 6)
            for s in (-1, 1)]  # fmt: skip
    seam = at_box(0.002, 0.165, 0.0012, (0, -0.054, 0.0115))
    buttons = [drum(0.0055, 0.003, (0.009, 0.01 - 0.035 * n, 0.0115), sides=12) for n in range(4)]
    welts = [at_box(0.05, 0.008, 0.0014, (s * 0.06, -0.07, 0.0115)) for s in (-1, 1)]
    dark = plain(tint_color(color, 0.55))
    return put_down([(body, surfaces.fabric(look.rng, color, tint_color(color, 1.2)
                                            if look.chance(0.4) else None)),
                     (back, plain(tint_color(color, 0.7))), (join([*edge, seam, *welts]), dark),
                     (join(buttons), plain((230, 220, 196)))], body, factor=k)  # fmt: skip


@category("vest", size=(0.201, 0.315, 0.00977), mass=0.12, material="fabric",
          aliases=("tank top", "vest top", "undershirt", "sleeveless shirt", "singlet"),
          themes=("living",), roles=("flat", "big"), colors=("white",))  # fmt: skip
def vest(look: Look) -> Shape:
    """A sleeveless vest, lying flat."""
    color = look.color("white", "gray", "black", "navy", "yellow", "red")
    k = look.between(0.85, 1.05)
    half = [(0.0, -0.17), (0.105, -0.17), (0.1, 0.04), (0.075, 0.08), (0.07, 0.16), (0.045, 0.16),
            (0.04, 0.1), (0.0, 0.08)]  # fmt: skip
    body = plate(mirror(half), 0.009)
    hem = at_box(0.21, 0.01, 0.0098, (0, -0.163, 0))
    trims = [tube(smooth([(s * 0.075, 0.158, 0.0085), (s * 0.075, 0.08, 0.0085),
                          (s * 0.1, 0.04, 0.0085)], 4), 0.002, 6) for s in (-1, 1)]  # fmt: skip
    trims.append(tube(smooth([(-0.042, 0.158, 0.0085), (-0.038, 0.105, 0.0085), (0, 0.083, 0.0085),
                              (0.038, 0.105, 0.0085), (0.042, 0.158, 0.0085)], 4), 0.002,
                      6))  # fmt: skip
    return put_down([(body, cloth(look, color)),
                     (join([hem, *trims]), plain(tint_color(color, 0.8)))], body,
                    factor=k)  # fmt: skip


@category("bodysuit", size=(0.251, 0.221, 0.0113), mass=0.06, material="fabric",
          aliases=("baby bodysuit", "babygro", "baby grow", "onesie", "baby onesie", "romper",
          "baby vest", "baby clothes"), themes=("living",), roles=("flat", "big"),
          colors=("white", "sky"))  # fmt: skip
def bodysuit(look: Look) -> Shape:
    """A baby's bodysuit with snaps at the bottom, lying flat."""
    color = look.color("white", "sky", "pink", "mint", "yellow", "cream", "lavender")
    k = look.between(0.85, 1.1)
    half = [(0.0, -0.115), (0.022, -0.112), (0.04, -0.07), (0.075, -0.04), (0.072, 0.05),
            (0.12, 0.035), (0.128, 0.075), (0.06, 0.11), (0.03, 0.11), (0.0, 0.092)]  # fmt: skip
    body = plate(mirror(half), 0.009)
    snaps = [drum(0.004, 0.003, (0.012 * n, -0.106, 0.0085), sides=10) for n in (-1, 0, 1)]
    tone = look.own_color("coral", "teal", "navy", "mustard", "pink")
    x, y = 0.0, 0.01
    heart = [drum(0.013, 0.0012, (s * 0.009, y + 0.009, 0.0086), sides=18) for s in (-1, 1)]
    heart.append(plate([(-0.021, y + 0.004), (x, y - 0.024), (0.021, y + 0.004), (x, y + 0.012)],
                       0.0012, at=(0, 0, 0.0086)))  # fmt: skip
    collar = tube(
        smooth([(-0.03, 0.108, 0.0085), (0, 0.092, 0.0088), (0.03, 0.108, 0.0085)], 5), 0.003, 6
    )
    return put_down([(body, cloth(look, color)), (join(snaps), steel(look)),
                     (join(heart), plain(tone)), (collar, plain(tint_color(color, 0.75)))], body,
                    factor=k)  # fmt: skip


@category("braces", size=(0.146, 0.344, 0.00678), mass=0.09, material="fabric",
          aliases=("suspenders", "pair of braces", "pair of suspenders", "trouser braces"),
          themes=("living",), roles=("flat", "big"), colors=("red",))  # fmt: skip
def braces(look: Look) -> Shape:
    """Elastic braces with clips lying flat: two straps that meet at the back."""
    color = look.color("red", "navy", "black", "green", "mustard", "gray")
    k = look.between(0.85, 1.1)
    straps = []
    for s in (-1, 1):
        path = [(0, 0.12, 0.002), (s * 0.02, 0.06, 0.0022), (s * 0.06, -0.02, 0.002),
                (s * 0.055, -0.11, 0.002)]  # fmt: skip
        straps.append(tube(smooth(path, 5), 0.011, 8, squash=0.16))
    back = at_box(0.022, 0.08, 0.0035, (0, 0.155, 0))
    patch = plate([(-0.02, 0.12), (0, 0.095), (0.02, 0.12), (0, 0.145)], 0.0055)
    clips = [at_box(0.02, 0.028, 0.007, (x, y, 0)) for x, y in ((-0.055, -0.122), (0.055, -0.122),
                                                                (0, 0.205))]  # fmt: skip
    slides = [at_box(0.027, 0.012, 0.0055, (s * 0.062, -0.04, 0)) for s in (-1, 1)]
    lines = surfaces.stripes([color, tint_color(color, 1.25), color], 3, upright=True)
    return put_down([(join([*straps, back]), lines), (patch, plain((110, 72, 48))),
                     (join([*clips, *slides]), steel(look))], *straps, back, join(clips[:2]),
                    factor=k)  # fmt: skip


def hand_shape(look: Look, colors: tuple[str, ...], cuff: float, *, knit: bool) -> Shape:
    """Return a glove with a cuff, lying flat with its fingers on the left."""
    color = look.color(*colors)
    skin = surfaces.knitting(look.rng, color, 26) if knit else surfaces.speckles(look.rng, color, 7)
    k = look.between(0.9, 1.12)
    palm = pad(0.1, 0.095, 0.02, 0.03, soft=0.5).move(0.02)
    fingers = [pad(0.085, 0.0245, 0.019, 0.0122, soft=0.5).turn(2, -0.05 * y)
               .move(-0.055 - 0.012 * (1 - (y / 1.7) ** 2), 0.0235 * y)
               for y in (-1.5, -0.5, 0.5, 1.5)]  # fmt: skip
    thumb = pad(0.08, 0.028, 0.019, 0.0135, soft=0.5).turn(2, 0.85).move(-0.002, -0.058)
    sleeve = pad(cuff, 0.1, 0.023, 0.01, soft=0.4).move(0.06 + cuff / 2)
    other = surfaces.plain(tint_color(color, 0.65))
    pieces: Pieces = [(join([palm, *fingers, thumb]), skin), (sleeve, other)]
    return put_down(pieces, palm, join(fingers), thumb, sleeve, factor=k)


@category("garden_glove", size=(0.225, 0.13, 0.023), mass=0.06, material="fabric",
          aliases=("gardening glove", "work glove", "gardener glove"), themes=("living",),
          colors=("green", "tan"), state="lying flat")  # fmt: skip
def garden_glove(look: Look) -> Shape:
    """A garden glove with a coloured palm and a knitted cuff."""
    return hand_shape(look, ("green", "yellow", "orange", "tan", "pink", "blue"), 0.045, knit=False)


GOLD: RGB = (206, 172, 90)


@category("garter", size=(0.13, 0.133, 0.0251), mass=0.02, material="fabric", assembled=True,
          aliases=("wedding garter", "bridal garter", "lace garter"), themes=("living",),
          colors=("sky", "white"), state="lying")  # fmt: skip
def garter(look: Look) -> Shape:
    """A garter lying flat: a ring of gathered lace and satin with a small bow."""
    k, color = look.between(0.9, 1.1), look.color("sky", "white", "blue", "pink", "red", "ivory")
    a = np.linspace(0, 2 * np.pi, 121)[:-1]
    wave = 0.006 * np.sin(30 * a)
    rows = []
    for r0, z, amount in ((0.058, 0.0015, 1.0), (0.054, 0.012, 0.25), (0.058, 0.024, 1.0)):
        rows.append(np.column_stack([(r0 + amount * wave) * np.cos(a), (r0 + amount * wave)
                                     * np.sin(a), np.full(120, z)]))  # fmt: skip
    lace = [tube(rows[0], 0.0014, 5, loop=True), tube(rows[2], 0.0014, 5, loop=True)]
    band = lathe([(0.053, 0.002), (0.057, 0.002), (0.059, 0.012), (0.057, 0.0235), (0.053, 0.0235)],
                 60, loop=True)  # fmt: skip
    bow = [
        ellipsoid(0.022, 0.008, 0.014, 12, 7).turn(1, 0.3 * s).move(0.012 * s, -0.062, 0.013)
        for s in (-1, 1)
    ] + [ellipsoid(0.008, 0.009, 0.009, 9, 6).move(0, -0.064, 0.013)]
    made = [(band, surfaces.stripes([color, tint_color(color, 1.25)], 40, upright=True, side=160)),
            (join(lace), surfaces.plain((250, 250, 250))),
            (join(bow), surfaces.plain(tint_color(color, 0.8)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, ring_parts([(0.0585 * k, 0.0002), (0.0585 * k, 0.024 * k)],
                                  [(0.053 * k, 0.024 * k), (0.053 * k, 0.0002)], 12))  # fmt: skip


@category("veil", size=(0.309, 0.259, 0.0212), mass=0.06, material="fabric", assembled=True,
          aliases=("bridal veil", "wedding veil", "lace veil"), themes=("living",), roles=("big",),
          colors=("white",), state="lying")  # fmt: skip
def veil(look: Look) -> Shape:
    """A bridal veil lying flat: soft folds of white tulle gathered at a comb."""
    k, color = look.between(0.85, 1.05), look.color("white", "ivory", "cream")
    phase = look.between(0, 6)
    n = 28
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(0, 1, n))
    x, y = u * (0.03 + 0.13 * v) * k, (0.12 - 0.26 * v) * k
    z = 0.002 + (0.006 + 0.012 * v) * (0.5 + 0.5 * np.sin(9 * u + 1.6 * np.sin(3 * v) + phase))
    sheet = spread(np.stack([x[::-1], y[::-1], z[::-1]], -1), 0.0012)
    comb = box(0.07 * k, 0.012 * k, 0.008).move(y=0.122 * k)
    pearls = [ellipsoid(0.008, 0.008, 0.008, 9, 6).move(i * 0.011 * k, 0.122 * k, 0.011)
              for i in range(-3, 4)]  # fmt: skip
    tulle = surfaces.grid((226, 226, 230), color, 40, 40)
    return shape([(sheet, tulle), (comb, surfaces.plain(GOLD)),
                  (join(pearls), surfaces.plain((250, 248, 240)))],
                 [hull_of(sheet), hull_of(comb)])  # fmt: skip


@category("umbrella", size=(0.38, 0.085, 0.045), mass=0.35, material="fabric", assembled=True,
          aliases=("folded umbrella", "rolled umbrella", "closed umbrella", "parasol",
          "compact umbrella", "brolly"), themes=("living",), roles=("big",),
          colors=("black", "red"), state="lying")  # fmt: skip
def umbrella(look: Look) -> Shape:
    """A rolled umbrella lying flat with its crook handle on the right."""
    color = look.color("black", "red", "navy", "yellow", "green", "purple", "pink", "blue")
    cloth = lathe([(0, 0), (0.007, 0), (0.021, 0.05), (0.024, 0.19), (0.017, 0.24), (0.006, 0.25),
                   (0, 0.25)], 16)  # fmt: skip
    n = 16
    fold = np.where(np.arange(n) % 2 == 0, 1.0, 0.8)
    angle = np.arctan2(cloth.vertices[:, 1], cloth.vertices[:, 0])
    f = fold[(angle / (2 * np.pi) * n).round().astype(int) % n][:, None]
    cloth = cloth.bend(lambda p: p * np.column_stack([f, f, np.ones(len(p))]))
    cloth = cloth.turn(1, np.pi / 2).move(-0.14, 0, 0.0225)
    shaft = straight((-0.185, 0, 0.0225), (0.17, 0, 0.013), 0.0035, 8)
    crook = rod([(0.12, 0, 0.014), (0.18, 0, 0.011), (0.215, 0.022, 0.0095), (0.19, 0.052, 0.0085),
                 (0.16, 0.05, 0.0085)], 0.0085, 10)  # fmt: skip
    band = cylinder(0.0235, 0.014, 18).turn(1, np.pi / 2).move(0.0, 0, 0.0225)
    wood = surfaces.wood(look.rng, look.own_color("brown", "wooden", "charcoal"))
    ribs = surfaces.stripes([color, tint_color(color, 0.75)], 8, upright=True, side=64)
    pieces: Pieces = [(cloth, ribs), (shaft, surfaces.plain((70, 72, 76))), (crook, wood),
                      (band, surfaces.plain(tint_color(color, 0.6)))]  # fmt: skip
    return put_down(pieces, cloth, crook, factor=look.between(0.85, 1.1), foot=0.3)


@category("scarf", size=(0.25, 0.169, 0.0469), mass=0.2, material="fabric",
          aliases=("folded scarf", "wool scarf", "shawl", "knitted scarf", "cummerbund"),
          themes=("living",), colors=("red", "gray"), state="lying folded")  # fmt: skip
def scarf(look: Look) -> Shape:
    """A scarf folded into a long bundle with its fringed ends overlapping."""
    x, y, h = look.between(0.22, 0.28), look.between(0.1, 0.13), look.between(0.04, 0.055)
    color = look.color("red", "gray", "navy", "mustard", "teal", "cream", "maroon", "green", "pink")
    other = look.own_color("white", "black", "navy", "cream", "red", "yellow")
    cloth = look.pick([surfaces.stripes([color, other], 5, upright=True, side=96),
                       surfaces.fabric(look.rng, color, other, 24),
                       surfaces.knitting(look.rng, color, 26)])  # fmt: skip
    pieces, parts = [], []
    t = h / 2
    for n, (wide, off) in enumerate(((1.0, 0.0), (0.9, 0.01))):
        path = smooth([(-wide * x / 2, off, t * (n + 0.5)), (-0.2 * x, off, t * (n + 0.53)),
                       (0.2 * x, off, t * (n + 0.48)), (wide * x / 2, off, t * (n + 0.5))],
                      3)  # fmt: skip
        bundle = sweep(path, rectangle(y * (1 - 0.06 * n), 0.98 * t, 0.45 * t, 4))
        bundle = bundle.bend(above)
        pieces.append((bundle, cloth))
        parts.append(hull_of(bundle))
    tail = loft(np.stack([np.column_stack([rectangle(0.07, 0.006), np.full(4, 0.0)]),
                          np.column_stack([rectangle(0.07, 0.006), np.full(4, 0.075)])]),
                rectangle(0.07, 0.006))  # fmt: skip
    tail = facing(tail).move(0.12 * x, -y / 2 + 0.03, h - 0.004)
    hang = box(0.07, 0.007, h).move(0.12 * x, -y / 2 - 0.002)
    fringe = [tube([(0.12 * x - 0.032 + 0.008 * n, -y / 2 - 0.004, 0.006),
                    (0.12 * x - 0.032 + 0.008 * n, -y / 2 - 0.03, 0.002)], 0.0018, 5)
              for n in range(9)]  # fmt: skip
    pieces += [(join([tail, hang]), cloth), (join(fringe), surfaces.plain(color))]
    return shape(pieces, parts)


TONES = ("white", "navy", "red", "gray", "teal", "black", "mustard", "pink", "green", "sky")


def _pile(x: float, y: float, h: float, count: int) -> Solid:
    """Return a stack of ``count`` rounded layers of folded cloth with total height ``h``."""
    t = h / count
    return join([pad(x * (1 - 0.008 * n), y * (1 - 0.012 * n), t, 0.012, soft=0.5, steps=4)
                 .move(0, 0.002 * n, n * t) for n in range(count)])  # fmt: skip


@category("t_shirt", size=(0.23, 0.27, 0.037), mass=0.16, material="fabric",
          aliases=("t-shirt", "tshirt", "tee shirt", "folded t-shirt", "folded tshirt", "tee"),
          themes=("living",), roles=("big", "support"), colors=("white", "navy"),
          state="lying folded")  # fmt: skip
def t_shirt(look: Look) -> Shape:
    """A folded T-shirt with its neck in front."""
    x, y, h = look.between(0.21, 0.25), look.between(0.25, 0.29), look.between(0.028, 0.04)
    color = look.color(*TONES)
    body = _pile(x, y, h, 3)
    collar = torus(0.042, 0.005, 26, 6).scale(1.25, 0.75, 0.6).move(0, y / 2 - 0.055, h)
    inside = cylinder(0.04, 0.0012, 26).scale(1.25, 0.75, 1).move(0, y / 2 - 0.055, h - 0.0008)
    print_ = look.chance(0.5)
    pieces: Pieces = [(body, surfaces.fabric(look.rng, color)),
                      (collar, surfaces.plain(tint_color(color, 0.85))),
                      (inside, surfaces.plain(tint_color(color, 0.6)))]  # fmt: skip
    if print_:
        mark = cylinder(0.045, 0.001, 26).move(0, -0.04, h - 0.0005)
        pieces.append((mark, surfaces.plain(look.own_color("red", "yellow", "white", "teal"))))
    return put_down(pieces, body)


@category("shirt", size=(0.23, 0.29, 0.045), mass=0.22, material="fabric",
          aliases=("folded shirt", "dress shirt", "blouse", "button down shirt", "polo shirt"),
          themes=("living",), roles=("big", "support"), colors=("white", "sky"),
          state="lying folded")  # fmt: skip
def shirt(look: Look) -> Shape:
    """A folded shirt with a collar and buttons."""
    x, y, h = look.between(0.21, 0.25), look.between(0.27, 0.31), look.between(0.03, 0.042)
    color = look.color("white", "sky", "pink", "navy", "gray", "green")
    cloth = (surfaces.stripes([color, color, tint_color(color, 0.75)], 12, upright=True, side=128)
             if look.chance(0.4) else surfaces.fabric(look.rng, color))  # fmt: skip
    body = _pile(x, y, h, 3)
    at = y / 2 - 0.05
    lapels = [prism([(0, -0.04), (s * 0.055, -0.012), (s * 0.05, 0.026), (s * 0.012, 0.03)][::s], 0,
                    0.006).move(0, at, h - 0.001) for s in (1, -1)]  # fmt: skip
    band = torus(0.04, 0.007, 24, 6).scale(1.1, 0.7, 1).move(0, at + 0.022, h)
    strip = box(0.022, y - 0.1, 0.0014).move(0, -0.045, h - 0.0005)
    buttons = [cylinder(0.0055, 0.002, 14).move(0, at - 0.06 - 0.05 * n, h) for n in range(4)]
    return put_down([(body, cloth), (join([*lapels, band, strip]),
                                     surfaces.plain(tint_color(color, 1.08))),
                     (join(buttons), surfaces.plain((244, 242, 236) if sum(color) < 500
                                                    else (120, 110, 104)))], body)  # fmt: skip


@category("sweater", size=(0.265, 0.28, 0.078), mass=0.5, material="fabric",
          aliases=("folded sweater", "jumper", "pullover", "cardigan", "wool sweater", "hoodie",
          "knitted sweater"), themes=("living",), roles=("big", "support"),
          colors=("mustard", "gray"), state="lying folded")  # fmt: skip
def sweater(look: Look) -> Shape:
    """A thick, folded knitted sweater with its ribbed neck in front."""
    x, y, h = look.between(0.24, 0.29), look.between(0.26, 0.3), look.between(0.06, 0.08)
    color = look.color("mustard", "gray", "cream", "red", "navy", "green", "teal", "brown")
    knit = surfaces.knitting(look.rng, color, 30)
    body = _pile(x, y, h, 3)
    neck = torus(0.045, 0.0095, 26, 8).scale(1.25, 0.75, 0.8).move(0, y / 2 - 0.07, h - 0.001)
    inside = cylinder(0.042, 0.0012, 26).scale(1.25, 0.75, 1).move(0, y / 2 - 0.07, h - 0.0006)
    stripes = [box(x - 0.03, 0.014, 0.001).move(0, -0.06 - 0.028 * n, h - 0.0003) for n in range(2)]
    other = surfaces.plain(tint_color(color, 0.6) if sum(color) > 330 else (240, 234, 220))
    pieces: Pieces = [(body, knit), (neck, knit), (inside, surfaces.plain(tint_color(color, 0.5)))]
    if look.chance(0.5):
        pieces.append((join(stripes), other))
    return put_down(pieces, body)


@category("jeans", size=(0.22, 0.29, 0.048), mass=0.6, material="fabric",
          aliases=("pair of jeans", "folded jeans", "trousers", "pants", "folded trousers"),
          themes=("living",), roles=("big", "support"), colors=("navy", "blue"),
          state="lying folded")  # fmt: skip
def jeans(look: Look) -> Shape:
    """Folded jeans with a waistband, a pocket and orange seams."""
    x, y, h = look.between(0.2, 0.24), look.between(0.27, 0.31), look.between(0.035, 0.05)
    color = look.color("navy", "blue", "black", "gray", "indigo")
    denim = surfaces.scratches(look.rng, color, tint_color(color, 1.35), 200)
    body = _pile(x, y, h, 2)
    waist = block(x - 0.012, 0.03, 0.006, 0.006, 0.002).move(0, y / 2 - 0.02, h - 0.001)
    pocket = prism([(-0.045, 0.05), (-0.045, -0.02), (0, -0.05), (0.045, -0.02), (0.045, 0.05)], 0,
                   0.002).move(0, 0.03, h - 0.0006)  # fmt: skip
    run = [(-0.039, 0.076, 0), (-0.039, 0.013, 0), (0, -0.013, 0), (0.039, 0.013, 0)]
    seam = tube(np.array([*run, (0.039, 0.076, 0)]) + np.array([0, 0, h + 0.0016]), 0.0011, 5)
    loops = [
        box(0.008, 0.034, 0.003).move(i * x * 0.33, y / 2 - 0.02, h + 0.004) for i in (-1, 0, 1)
    ]
    knob = cylinder(0.007, 0.003, 16).move(0.45 * x - 0.02, y / 2 - 0.02, h + 0.004)
    return put_down([(join([body, waist, *loops]), denim),
                     (pocket, surfaces.plain(tint_color(color, 1.15))),
                     (join([seam, knob]), surfaces.plain((206, 140, 70)))], body)  # fmt: skip


@category("sock", size=(0.137, 0.18, 0.0135), mass=0.03, material="fabric", aliases=("ankle sock",
          "wool sock", "knitted sock", "baby sock", "pair of socks", "trouser sock", "leg warmer"),
          themes=("living",), colors=("white", "red"), state="lying flat")  # fmt: skip
def sock(look: Look) -> Shape:
    """A sock lying flat with its toe on the left."""
    color = look.color(*TONES, "orange", "purple")
    other = look.own_color("white", "red", "navy", "yellow")
    side = smooth([(0.03, 0.1), (-0.03, 0.1), (-0.03, 0.0), (-0.045, -0.025), (-0.095, -0.036),
                   (-0.108, -0.06), (-0.09, -0.08), (-0.02, -0.08), (0.026, -0.062), (0.031, -0.02),
                   (0.03, 0.098)], 3)[:-1]  # fmt: skip
    body = prism(side, 0, 0.009)
    top = prism(side * 0.94 - [0.001, 0.0], 0.0088, 0.0115)
    cuff = pad(0.066, 0.03, 0.0135, 0.006, soft=0.5).move(0, 0.09)
    toe = ball(0.042, 0.046, 0.0135, (-0.088, -0.058, 0.0062), 14)
    heel = ball(0.034, 0.036, 0.0132, (0.016, -0.06, 0.0062), 14)
    knit = surfaces.stripes([color, color, other], 6, side=96) if look.chance(0.4) else (
        surfaces.knitting(look.rng, color, 26))  # fmt: skip
    pieces: Pieces = [(join([body, top]), knit), (join([cuff, toe, heel]), surfaces.plain(
        tint_color(color, 0.7) if sum(color) > 250 else other))]  # fmt: skip
    leg = body.vertices[body.vertices[:, 1] > -0.045]
    foot = body.vertices[body.vertices[:, 1] < -0.018]
    return shape(pieces, [hull_part(leg), hull_part(foot), hull_part(cuff.vertices)]).scale(
        look.between(0.85, 1.12))  # fmt: skip


@category("glove", size=(0.22, 0.13, 0.023), mass=0.05, material="fabric",
          aliases=("knitted glove", "wool glove", "winter glove", "leather glove"),
          themes=("living",), colors=("gray", "red"), state="lying flat")  # fmt: skip
def glove(look: Look) -> Shape:
    """A knitted glove, lying flat."""
    return hand_shape(look, ("gray", "red", "navy", "black", "teal", "mustard"), 0.05, knit=True)


@category("mitten", size=(0.195, 0.14, 0.029), mass=0.06, material="fabric",
          aliases=("winter mitten", "pot holder mitt", "wool mitten"), themes=("living", "kitchen"),
          colors=("red", "gray"), state="lying flat")  # fmt: skip
def mitten(look: Look) -> Shape:
    """A knitted mitten, or an oven mitt, lying flat."""
    color = look.color("red", "gray", "navy", "teal", "mustard", "green", "white")
    knit = (surfaces.knitting(look.rng, color, 24) if look.chance(0.6) else
            surfaces.fabric(look.rng, color, (246, 244, 238), 20))  # fmt: skip
    palm = pad(0.15, 0.1, 0.026, 0.048, soft=0.5, steps=6)
    thumb = pad(0.085, 0.04, 0.024, 0.0195, soft=0.5).turn(2, 0.75).move(0.014, -0.058)
    cuff = pad(0.055, 0.108, 0.029, 0.008, soft=0.4).move(0.09)
    pieces: Pieces = [(join([palm, thumb]), knit), (cuff, surfaces.plain(tint_color(color, 0.65)))]
    return put_down(pieces, palm, thumb, cuff, factor=look.between(0.9, 1.12))


@category("tie", size=(0.44, 0.085, 0.012), mass=0.06, material="fabric",
          aliases=("necktie", "neck tie", "silk tie", "cravat", "groom's tie"), themes=("living",),
          roles=("big",), colors=("navy", "red"), state="lying flat")  # fmt: skip
def tie(look: Look) -> Shape:
    """A necktie lying flat with its knot on the right and its tip on the left."""
    color = look.color("navy", "red", "green", "purple", "black", "gray", "teal")
    other = look.own_color("white", "gold", "silver", "sky")
    silk = surfaces.stripes([color, color, color, other], 9, upright=True, side=128)
    blade_ = prism(
        [(-0.23, 0), (-0.19, -0.04), (0.16, -0.016), (0.16, 0.016), (-0.19, 0.04)], 0, 0.004
    )
    tail = prism([(-0.17, 0.002), (-0.14, -0.022), (0.15, -0.01), (0.15, 0.014), (-0.14, 0.026)], 0,
                 0.0035).turn(2, -0.11).move(0, 0.012)  # fmt: skip
    knot = prism([(0.15, -0.016), (0.2, -0.024), (0.2, 0.024), (0.15, 0.016)], 0, 0.014, 0.004)
    loop = rod([(0.19, -0.018, 0.005), (0.25, -0.045, 0.004), (0.29, 0, 0.004),
                (0.25, 0.045, 0.004), (0.19, 0.018, 0.005)], 0.0045, 6)  # fmt: skip
    cloth = surfaces.plain(tint_color(color, 0.8))
    return put_down([(blade_.move(z=0.0034), silk), (tail, cloth), (knot, silk), (loop, cloth)],
                   join([blade_, tail]), knot, loop, factor=look.between(0.75, 0.95))  # fmt: skip


@category("bow_tie", size=(0.113, 0.053, 0.0185), mass=0.02, material="fabric",
          aliases=("bowtie", "dickie bow"), themes=("living",), colors=("black", "red"),
          state="lying flat")  # fmt: skip
def bow_tie(look: Look) -> Shape:
    """A bow tie, lying flat."""
    color = look.color("black", "red", "navy", "purple", "green", "white", "gold")
    cloth = (surfaces.spots(look.rng, color, tint_color(color, 1.7), 0.12) if look.chance(0.4)
             else surfaces.fabric(look.rng, color))  # fmt: skip
    wings = [loft(np.stack([np.array([(s * x, -w, 0.009 - t), (s * x, w, 0.009 - t),
                                      (s * x, w, 0.009 + t), (s * x, -w, 0.009 + t)]) for x, w,
                            t in ((0.004, 0.011, 0.006), (0.03, 0.024, 0.0085),
                                  (0.055, 0.026, 0.004))]), np.array([(-1.0, -1.0), (1.0, -1.0),
                                                                      (1.0, 1.0), (-1.0, 1.0)]))
             for s in (-1, 1)]  # fmt: skip
    knot = pad(0.022, 0.026, 0.018, 0.006, soft=0.4)
    return put_down([(join(wings), cloth), (knot, surfaces.plain(tint_color(color, 0.85)))],
                   *wings, knot, factor=look.between(0.9, 1.15))  # fmt: skip


@category("belt", size=(0.0765, 0.0857, 0.0437), mass=0.18, material="leather", assembled=True,
          aliases=("leather belt", "rolled belt", "waist belt", "camera strap", "razor strop",
          "strop", "guitar strap", "anti-static wrist strap"), themes=("living",),
          colors=("brown", "black"), state="lying rolled up")  # fmt: skip
def belt(look: Look) -> Shape:
    """A rolled leather belt with its buckle, standing on its edge."""
    color = look.color("brown", "black", "tan", "navy", "maroon", "white")
    a = np.linspace(0, 2 * np.pi * 3.2, 90)
    r = 0.018 + 0.0052 * a / (2 * np.pi) * 1.25
    path = np.column_stack([r * np.cos(a), r * np.sin(a)])
    way = np.gradient(path, axis=0)
    side = np.column_stack([-way[:, 1], way[:, 0]]) / np.linalg.norm(way, axis=1)[:, None] * 0.0017
    w = 0.032
    rings = [np.array([(*(p - n), 0), (*(p + n), 0), (*(p + n), w), (*(p - n), w)])
             for p, n in zip(path, side, strict=True)]  # fmt: skip
    coil = loft(np.stack(rings), np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]))
    end = path[-1]
    frame = torus(0.016, 0.0026, 20, 6).turn(0, np.pi / 2).scale(1, 1, 1.15)
    turn = float(np.arctan2(*way[-1][::-1]))
    buckle = frame.turn(2, turn).move(float(end[0]), float(end[1]), w / 2)
    buckle = buckle.move(z=max(0.0, -float(buckle.bounds[0, 2])))
    prong = straight((float(end[0]) - 0.012 * np.cos(turn), float(end[1]) - 0.012 * np.sin(turn), w
                      / 2), (float(end[0]) + 0.018 * np.cos(turn), float(end[1]) + 0.018
                             * np.sin(turn), w / 2), 0.0018, 6)  # fmt: skip
    metal = surfaces.brushed_metal(look.rng, look.pick([(206, 172, 96), (190, 194, 200)]))
    made = shape([(coil, leather(look.rng, color)), (join([buckle, prong]), metal)],
                 [hull_part(coil.vertices), hull_part(above(buckle.vertices))])  # fmt: skip
    return made.scale(look.between(0.92, 1.15))


@category("clothes_hanger", size=(0.35, 0.146, 0.0142), mass=0.09, material="wood", assembled=True,
          aliases=("hanger", "coat hanger", "wooden hanger"), themes=("living",),
          roles=("big", "flat"), colors=("wooden",), state="lying flat")  # fmt: skip
def clothes_hanger(look: Look) -> Shape:
    """A clothes hanger, lying flat."""
    color = look.color("wooden", "black", "white", "pink", "brown", "blue")
    k = look.between(0.75, 0.95)
    wood = look.surface(color, "wood")
    arms = [rod([(0, 0.03, 0.008), (s * 0.08, 0.012, 0.008), (s * 0.2, -0.045, 0.008)],
                [0.0085, 0.008, 0.007], 10) for s in (-1, 1)]  # fmt: skip
    bar = straight((-0.19, -0.042, 0.008), (0.19, -0.042, 0.008), 0.004, 8)
    hook = rod([(0, 0.03, 0.008), (0, 0.06, 0.006), (0.024, 0.085, 0.003), (0.004, 0.112, 0.003),
                (-0.022, 0.092, 0.003)], 0.0022, 8)  # fmt: skip
    return put_down([(join([*arms, bar]), wood), (hook, surfaces.brushed_metal(look.rng, STEEL))],
                   *arms, bar, hook, factor=k)  # fmt: skip


@category("eye_mask", size=(0.2, 0.125, 0.0125), mass=0.03, material="fabric", assembled=True,
          aliases=("sleep mask", "sleeping mask", "blindfold"), themes=("living",), roles=("flat",),
          colors=("black", "navy"), state="lying flat")  # fmt: skip
def eye_mask(look: Look) -> Shape:
    """A padded sleeping mask with an elastic band, lying flat."""
    color = look.color("black", "navy", "pink", "lavender", "gray", "teal")
    k = look.between(0.9, 1.1)
    side = smooth([(-0.1, 0.006), (-0.07, 0.042), (0, 0.034), (0.07, 0.042), (0.1, 0.006),
                   (0.07, -0.04), (0.02, -0.036), (0, -0.012), (-0.02, -0.036), (-0.07, -0.04),
                   (-0.1, 0.006)], 3)[:-1]  # fmt: skip
    side = side[::-1]
    n = len(side)
    body = loft(np.stack([np.column_stack([side * g, np.full(n, z)]) for g, z in (
        (0.95, 0), (1.0, 0.004), (0.96, 0.009), (0.8, 0.012))]), side)  # fmt: skip
    band = rod([(-0.096, 0, 0.005), (-0.09, 0.05, 0.004), (0, 0.085, 0.004), (0.09, 0.05, 0.004),
                (0.096, 0, 0.005)], 0.0035, 6)  # fmt: skip
    lids = [rod([(s * 0.05 - 0.024, 0.006, 0.011), (s * 0.05, -0.008, 0.0125),
                 (s * 0.05 + 0.024, 0.006, 0.011)], 0.0013, 5) for s in (-1, 1)]  # fmt: skip
    ink = surfaces.plain((250, 246, 240) if sum(color) < 400 else (70, 60, 80))
    return put_down([(body, surfaces.fabric(look.rng, color)),
                     (band, surfaces.plain(tint_color(color, 0.7) if sum(color) > 200
                                           else (90, 90, 96))), (join(lids), ink)], body,
                    factor=k)  # fmt: skip
