"""Objects of the ``living`` theme: figurines."""

from __future__ import annotations

from collections.abc import Callable
from types import MappingProxyType

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic, shine
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import above, box_part, cylinder_part, hull_above, hull_of
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    drum,
    hull_solid,
    limb,
    plate,
    rod,
    standing,
    standing_plate,
)
from ...kit.shapes import (
    Category,
    Drawing,
    Pieces,
    Shape,
    category,
    from_pieces,
    put_down,
    shape,
    vary,
)
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
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, Tile, plain, tint_color

SKIN: RGB = (232, 192, 158)


def person(x: float, y: float, h: float, z: float = 0.0) -> tuple[Solid, Solid]:
    """Return the robe and the head of a small wooden figure of height ``h``."""
    robe = lathe(
        [(0, 0), (0.26 * h, 0), (0.22 * h, 0.3 * h), (0.13 * h, 0.7 * h), (0, 0.74 * h)], 16
    )
    head = ball(0.25 * h, 0.25 * h, 0.27 * h, (0, 0, 0.86 * h), 12)
    return robe.move(x, y, z), head.move(x, y, z)


@category("nativity_set", size=(0.21, 0.111, 0.149), mass=0.6, material="wood", assembled=True,
          aliases=("nativity scene", "nativity", "christmas crib", "creche", "nativity figures",
          "manger scene", "creches"), themes=("living",), roles=("big",),
          colors=("wooden",))  # fmt: skip
@vary()
def nativity_set(look: Look) -> Shape:
    """A nativity scene: a stable with a star, Mary, Joseph, a king and the crib."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "wooden", "brown")
    floor = block(0.2, 0.11, 0.008, 0.004)
    posts = [
        box(0.01, 0.01, 0.085).move(s * 0.085, y, 0.008) for s in (-1, 1) for y in (0.04, -0.03)
    ]
    back = box(0.18, 0.005, 0.085).move(0, 0.045, 0.008)
    roof = [box(0.122, 0.1, 0.005).turn(1, s * 0.5).move(s * 0.049, 0.006, 0.112) for s in (-1, 1)]
    star = join([box(0.026, 0.003, 0.006).turn(1, a).move(0, -0.046, 0.135)
                 for a in (0, np.pi / 3, 2 * np.pi / 3)])  # fmt: skip
    crib = block(0.03, 0.02, 0.012, 0.002).move(0, -0.025, 0.008)
    child = ball(0.022, 0.012, 0.01, (0, -0.025, 0.021), 10)
    robes, heads = [], []
    tones = ((50, 90, 170), (124, 84, 56), (150, 40, 60), (110, 110, 60))
    pieces: Pieces = []
    for (x, y, h), tone in zip(((-0.035, -0.012, 0.056), (0.036, -0.01, 0.064), (0.068, -0.035,
                               0.058), (-0.068, -0.032, 0.05)), tones, strict=True):  # fmt: skip
        robe, head = person(x, y, h, 0.008)
        robes.append(robe)
        heads.append(head)
        pieces.append((robe, surfaces.plain(tone)))
    wood = look.surface(color, "wood")
    frame = join([floor, *posts, back])
    return shape([(frame, wood), (join(roof), surfaces.scratches(look.rng, (150, 110, 62),
                                                                 (200, 164, 100), 90)),
                  (star, surfaces.plain((246, 206, 80))), (crib, surfaces.plain((170, 126, 70))),
                  (child, surfaces.plain((248, 240, 220))), (join(heads), surfaces.plain(SKIN)),
                  *pieces], [hull_of(floor), hull_of(back), hull_of(*roof), hull_of(star),
                             hull_of(*posts[:2]), hull_of(*posts[2:]),
                             *(hull_of(r, h) for r,
                               h in zip(robes, heads, strict=True))]).scale(k)  # fmt: skip


@category("cake_topper", size=(0.0709, 0.0687, 0.093), mass=0.06, material="plastic",
          assembled=True, aliases=("bride and groom cake topper", "wedding cake topper",
          "bride and groom", "bride and groom figurine", "bride and groom topper"),
          themes=("living",), colors=("white",))  # fmt: skip
@vary()
def cake_topper(look: Look) -> Shape:
    """A bride and groom on a small white base."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "white", "ivory")
    base = cylinder(0.034, 0.009, 30, bevel=0.002)
    gown = lathe(np.maximum(smooth([(0, 0), (0.022, 0), (0.02, 0.015), (0.011, 0.036),
                                    (0.0075, 0.044), (0.0095, 0.056), (0.006, 0.063), (0, 0.064)],
                                   3), 0), 20).move(-0.013, 0, 0.008)  # fmt: skip
    veil = lathe([(0, 0.03), (0.013, 0.03), (0.0125, 0.066), (0.006, 0.078), (0, 0.079)], 16)
    veil = veil.scale(1, 0.6, 1).move(-0.013, 0.007, 0.008)
    legs = block(0.018, 0.012, 0.032, 0.004).move(0.015, 0, 0.008)
    coat = lathe([(0, 0.028), (0.0115, 0.028), (0.0125, 0.05), (0.0095, 0.063), (0, 0.066)], 16)
    coat = coat.scale(1, 0.75, 1).move(0.015, 0, 0.008)
    heads = [ball(0.015, 0.015, 0.017, (x, -0.001, z), 12) for x, z in ((-0.013, 0.08),
             (0.015, 0.082))]  # fmt: skip
    hair = [ball(0.016, 0.014, 0.012, (0.015, 0.0025, 0.086), 10)]
    shirt = prism(np.array([(0, 0), (0.004, 0.016), (-0.004, 0.016)]), -0.001, 0.001).turn(
        0, np.pi / 2).move(0.015, -0.0092, 0.052)  # fmt: skip
    flowers = ball(0.013, 0.012, 0.012, (-0.006, -0.012, 0.05), 10)
    arms = [limb([(-0.022, -0.002, 0.066), (-0.023, -0.009, 0.056), (-0.008, -0.012, 0.052)],
                 [0.0032] * 3, 6)]  # fmt: skip
    sleeve = [limb([(0.025, 0, 0.068), (0.028, -0.002, 0.056), (0.026, -0.006, 0.046)],
                   [0.0038] * 3, 6), limb([(0.006, 0, 0.066), (0.002, -0.004, 0.058),
                   (-0.004, -0.008, 0.054)], [0.0035] * 3, 6)]  # fmt: skip
    dark = surfaces.plain((34, 34, 42))
    white = surfaces.speckles(look.rng, color, 3)
    people = [gown, veil, legs, coat, *heads]
    return shape([(base, white), (join([gown, veil, shirt]), white),
                  (join([legs, coat, *sleeve]), dark),
                  (join([*heads, *arms]), surfaces.plain(SKIN)),
                  (join(hair), surfaces.plain((70, 46, 32))),
                  (flowers, surfaces.spots(look.rng, (226, 90, 120), (90, 140, 70), 0.3))],
                 [hull_of(base), hull_of(*people)]).scale(k)  # fmt: skip


def _cast(look: Look, *palette: str) -> surfaces.Tile:
    """Return a metal or stoneware texture for a statue, in a colour from ``palette``."""
    color = look.color(*palette)
    return look.surface(color, look.pick(["metal", "stoneware"]))


def _head(z: float, r: float) -> list[Solid]:
    """Return the parts of a Buddha's head: the head, long ears, hair and a topknot."""
    ears = [ball(0.2 * r, 0.35 * r, 0.9 * r, (s * 0.9 * r, 0, z - 0.15 * r), 8) for s in (-1, 1)]
    return [ball(1.75 * r, 1.8 * r, 2.1 * r, (0, 0, z), 18), *ears,
            ball(1.85 * r, 1.8 * r, 1.5 * r, (0, 0.12 * r, z + 0.5 * r), 16),
            ball(0.8 * r, 0.8 * r, 0.8 * r, (0, 0.1 * r, z + 1.25 * r), 12)]  # fmt: skip


def _face(z: float, y: float, r: float) -> list[Solid]:
    """Return the closed eyes and the mouth of a Buddha's face."""
    eyes = [ball(0.42 * r, 0.12 * r, 0.1 * r, (s * 0.38 * r, y + 0.06 * r, z + 0.08 * r), 8)
            for s in (-1, 1)]  # fmt: skip
    return [*eyes, ball(0.5 * r, 0.12 * r, 0.1 * r, (0, y + 0.06 * r, z - 0.5 * r), 8)]


@category("buddha_statue", size=(0.12, 0.12, 0.155), mass=0.5, material="ceramic",
          aliases=("buddha", "buddha figurine", "jade buddha", "buddha figure", "seated buddha",
          "guanyin statue", "meditating statue", "golden buddha"), themes=("living",),
          colors=("gold", "bronze"))  # fmt: skip
@from_pieces(bodies=4)
def buddha_statue(look: Look) -> Pieces:
    """A Buddha sitting cross-legged on a lotus seat with its hands in its lap."""
    tile = _cast(look, "gold", "bronze", "gray", "sage", "charcoal")
    seat = standing((0.055, 0), (0.06, 0.006), (0.05, 0.014), (0.056, 0.024), (0.05, 0.026))
    legs = [ball(0.062, 0.042, 0.03, (s * 0.03, -0.012, 0.036), 16) for s in (-1, 1)]
    lap = ball(0.07, 0.06, 0.034, (0, 0, 0.036), 16)
    body = standing((0.03, 0.03), (0.028, 0.06), (0.034, 0.085), (0.03, 0.096), (0.012, 0.104),
                    (0.01, 0.11)).scale(1, 0.72, 1)  # fmt: skip
    arms = [rod([(s * 0.03, 0, 0.092), (s * 0.042, -0.006, 0.066), (s * 0.03, -0.024, 0.052),
                 (s * 0.006, -0.032, 0.05)], [0.01, 0.0095, 0.008, 0.007], 10) for s in (-1,
             1)]  # fmt: skip
    head = _head(0.125, 0.017)
    dark = surfaces.plain(tint_color(look.own_color("charcoal"), 0.7))
    return [(seat, tile), (join([lap, *legs]), tile), (join([body, *arms]), tile),
            (join(head), tile), (join(_face(0.125, -0.0155, 0.017)), dark)]  # fmt: skip


@category("buddha_head", size=(0.0976, 0.0994, 0.183), mass=0.9, material="ceramic",
          aliases=("head of buddha", "buddha bust"), themes=("living",), roles=("tall",),
          colors=("gray",))  # fmt: skip
@from_pieces(bodies=4)
def buddha_head(look: Look) -> Pieces:
    """A Buddha head on a neck and a base, with long ears, rows of curls and closed eyes."""
    tile = _cast(look, "gray", "gold", "bronze", "cream", "charcoal")
    base = at_block(0.08, 0.07, 0.02, 0.01)
    neck = standing((0.03, 0.02), (0.026, 0.05))
    curls = [ball(0.011, 0.011, 0.011, (0.044 * np.sin(t) * np.cos(a), 0.006 + 0.045 * np.sin(t)
             * np.sin(a), 0.112 + 0.044 * np.cos(t)), 6)
             for t in (0.5, 0.9, 1.3) for a in np.linspace(-0.35, np.pi + 0.35, 11)]  # fmt: skip
    dark = surfaces.plain((44, 40, 38))
    return [(base, tile), (neck, tile), (join(_head(0.1, 0.046)), tile), (join(curls), tile),
            (join(_face(0.1, -0.041, 0.046)), dark)]  # fmt: skip


def _robed_figure(robe: tuple[str, ...], veil: tuple[str, ...], halo: bool) -> Drawing:
    """Return the drawing function of a robed, veiled figure standing with folded hands."""

    def draw(look: Look) -> Pieces:
        gown, cover = plastic(look, *robe), dye(look, *veil)
        skin = dye(look, "tan", "beige", "cream")
        base = disc(0.036, 0.012, sides=28)
        body = standing((0.032, 0.012), (0.03, 0.05), (0.022, 0.1), (0.026, 0.13), (0.012, 0.148))
        cloak = standing((0.034, 0.012), (0.035, 0.07), (0.03, 0.125), (0.02, 0.152),
                         (0.0165, 0.175), (0.006, 0.186)).scale(1, 0.82,
             1).move(y=0.007)  # fmt: skip
        face = ball(0.024, 0.024, 0.03, (0, -0.006, 0.164), 14)
        arms = [rod([(s * 0.024, -0.004, 0.128), (s * 0.02, -0.022, 0.108), (s * 0.003, -0.03,
             0.118)],
                    [0.008, 0.0075, 0.006], 10) for s in (-1, 1)]  # fmt: skip
        hands = ball(0.01, 0.012, 0.02, (0, -0.033, 0.126), 10)
        pieces: Pieces = [(base, dye(look, "gold", "white")), (body, gown), (cloak, cover),
                          (face, skin), (join(arms), cover), (hands, skin)]  # fmt: skip
        if halo:
            ring = disc(0.024, 0.0025).turn(0, np.pi / 2).move(0, 0.02, 0.168)
            pieces.append((ring, shine(look, "gold")))
        return pieces

    return draw


def _deity(many: bool, elephant: bool) -> Drawing:
    """Return the drawing function of a seated deity with a crown and a human or elephant head."""

    def draw(look: Look) -> Pieces:
        tile = _cast(look, "gold", "bronze", "copper", "blue" if not elephant else "gold")
        gold = shine(look, "gold")
        seat = standing((0.055, 0), (0.058, 0.012), (0.05, 0.02))
        legs = [ball(0.06, 0.045, 0.032, (s * 0.03, -0.01, 0.032), 16) for s in (-1, 1)]
        belly = ball(0.066, 0.056, 0.07, (0, 0, 0.062), 18)
        arms = []
        for s in (-1, 1):
            arms += [rod([(s * 0.03, 0, 0.085), (s * 0.055, -0.01, 0.07), (s * 0.05, -0.03, 0.06)],
                         [0.009, 0.008, 0.007], 8),
                     rod([(s * 0.03, 0.004, 0.088), (s * 0.062, 0.004, 0.092),
                          (s * 0.06, 0, 0.122)], [0.009, 0.008, 0.006], 8)]  # fmt: skip
        head = [ball(0.038, 0.036, 0.04, (0, -0.004, 0.114), 16)]
        if elephant:
            head += [ball(0.032, 0.008, 0.04, (s * 0.032, 0.002, 0.114), 12) for s in (-1, 1)]
            head.append(rod([(0, -0.018, 0.112), (0, -0.032, 0.098), (0.004, -0.034, 0.076),
                             (0.014, -0.038, 0.064)], [0.01, 0.009, 0.0075, 0.005],
             10))  # fmt: skip
        crown = standing((0.02, 0.126), (0.021, 0.134), (0.013, 0.148), (0.004, 0.164))
        back = standing_plate(np.column_stack([0.05 * np.cos(t := np.linspace(0, 2 * np.pi,
             28)[:-1]),
                                               0.1 + 0.05 * np.sin(t)]), 0.004, 0.022)  # fmt: skip
        stay = at_box(0.02, 0.006, 0.06, (0, 0.022, 0))
        pieces: Pieces = [(seat, tile), (join([*legs, belly]), tile), (join(arms), tile),
                          (join(head), tile), (crown, gold)]  # fmt: skip
        return [*pieces, (join([back, stay]), gold)] if many else pieces

    return draw


@category("totem", size=(0.142, 0.07, 0.175), mass=0.2, material="wood",
          aliases=("tiki statue", "tiki"), themes=("living",), roles=("tall",),
          colors=("brown",))  # fmt: skip
@from_pieces()
def totem(look: Look) -> Pieces:
    """A carved totem pole of stacked faces with wings."""
    wood = look.surface(look.color("brown", "wooden", "tan"), "wood")
    pieces: Pieces = [(disc(0.034, 0.01), wood)]
    eyes, beaks = [], []
    for k in range(3):
        z = 0.01 + 0.055 * k
        pieces.append((disc(0.026, 0.053, (0, 0, z)), wood if k % 2 else dye(
            look, "red", "teal", "mustard")))  # fmt: skip
        eyes += [ball(0.015, 0.008, 0.013, (s * 0.011, -0.023, z + 0.036), 10) for s in (-1, 1)]
        beaks.append(ball(0.02, 0.03, 0.012, (0, -0.024, z + 0.016), 10))
    wings = [at_box(0.05, 0.008, 0.032, (s * 0.046, 0, 0.128)) for s in (-1, 1)]
    return [*pieces, (join(wings), dye(look, "red", "teal")), (join(eyes), dye(look, "white")),
            (join(beaks), dye(look, "black", "yellow"))]  # fmt: skip


BLACK = surfaces.plain((34, 34, 37))


@category("lucky_cat", size=(0.1, 0.09, 0.13), mass=0.3, material="ceramic", hollow=True,
          aliases=("maneki neko", "maneki-neko", "beckoning cat", "waving cat", "fortune cat",
          "chinese lucky cat"), themes=("living",), colors=("white", "gold"))  # fmt: skip
@from_pieces(bodies=5)
def lucky_cat(look: Look) -> Pieces:
    """A lucky cat with a raised paw, a red collar and a gold coin."""
    coat = plastic(look, "white", "gold", "black", "red")
    body = standing((0.032, 0), (0.04, 0.012), (0.036, 0.05), (0.022, 0.07))
    head = ball(0.07, 0.06, 0.058, (0, -0.004, 0.09), 20)
    ears = [hull_solid([(s * 0.03, -0.008, 0.105), (s * 0.012, -0.008, 0.112),
                        (s * 0.022, 0.006, 0.108), (s * 0.028, -0.004, 0.13)])
            for s in (-1, 1)]  # fmt: skip
    paw = rod([(0.032, -0.01, 0.055), (0.05, -0.016, 0.085), (0.046, -0.02, 0.118)],
              [0.012, 0.011, 0.014], 10)  # fmt: skip
    arm = rod([(-0.032, -0.012, 0.055), (-0.036, -0.034, 0.035), (-0.012, -0.042, 0.036)],
              [0.012, 0.011, 0.01], 10)  # fmt: skip
    collar = torus(0.026, 0.004, 26, 6).move(0, -0.002, 0.066)
    coin = at_block(0.022, 0.03, 0.004, 0.01).turn(0, np.pi / 2).move(0.0, -0.041, 0.034)
    eyes = [ball(0.011, 0.004, 0.005, (s * 0.014, -0.0325, 0.096), 8) for s in (-1, 1)]
    nose = ball(0.006, 0.004, 0.004, (0, -0.0345, 0.087), 8)
    feet = [ball(0.022, 0.028, 0.016, (s * 0.02, -0.032, 0.007), 10) for s in (-1, 1)]
    return [(body, coat), (head, coat), (join(feet), coat), (paw, coat), (arm, coat),
            (join(ears), coat), (collar, surfaces.plain((206, 36, 40))),
            (coin, shine(look, "gold")), (join(eyes), BLACK),
            (nose, surfaces.plain((230, 120, 130)))]  # fmt: skip


@category("garden_gnome", size=(0.114, 0.0863, 0.205), mass=0.35, material="ceramic",
          aliases=("gnome", "garden dwarf", "dwarf", "gnome figurine"), themes=("living",),
          roles=("tall",), colors=("red",))  # fmt: skip
def garden_gnome(look: Look) -> Shape:
    """A garden gnome with a pointed hat and a white beard."""
    color = look.color("red", "blue", "green", "red")
    k = look.between(0.85, 1.15)
    coat = standing((0.038, 0.014), (0.042, 0.03), (0.036, 0.075), (0.024, 0.09), sides=22)
    feet = [ball(0.034, 0.05, 0.028, (s * 0.018, -0.012, 0.012), 12) for s in (-1, 1)]
    belt = standing((0.0415, 0), (0.041, 0.01), at=(0, 0, 0.045), sides=22)
    head = ball(0.05, 0.048, 0.046, (0, 0, 0.104), 16)
    nose = ball(0.016, 0.016, 0.015, (0, -0.026, 0.104), 10)
    beard = ball(0.05, 0.03, 0.06, (0, -0.018, 0.082), 14)
    hat = standing(
        (0.03, 0), (0.031, 0.006), (0.016, 0.045), (0.002, 0.085), at=(0, 0.002, 0.114), sides=20
    )
    arms = [rod([(s * 0.028, 0, 0.083), (s * 0.045, -0.008, 0.06), (s * 0.03, -0.032, 0.055)],
                0.0105, 8) for s in (-1, 1)]  # fmt: skip
    eyes = [ball(0.005, 0.004, 0.006, (s * 0.01, -0.0225, 0.111), 6) for s in (-1, 1)]
    tone = look.own_color("blue", "green", "mustard", "brown", "teal")
    return put_down([(join([coat, *arms]), plain(tone)), (join([*feet, belt, *eyes]),
                                                          plain((50, 40, 36))),
                     (join([head, nose]), plain((240, 196, 164))), (beard, plain((244, 242, 236))),
                     (hat, surfaces.speckles(look.rng, color, 4))], join(feet), coat, head, hat,
                    factor=k, foot=0.3)  # fmt: skip


DARK = surfaces.plain((34, 32, 34))
GOLD = (222, 180, 80)


def _trunk(color: RGB, look: Look) -> tuple[Solid, Pieces]:
    """Return a figure's coat as a solid, then the textured coat, trim, belt and buckle."""
    coat = lathe([(0, 0), (0.036, 0), (0.04, 0.014), (0.03, 0.056), (0.018, 0.078), (0, 0.082)], 22)
    trim = torus(0.037, 0.0055, 24, 8).move(z=0.0075)
    belt = torus(0.0372, 0.0045, 24, 6).scale(1, 1, 1.2).move(z=0.03)
    buckle = box(0.014, 0.004, 0.012).move(0, -0.0405, 0.024)
    return coat, [(coat, surfaces.speckles(look.rng, color, 5)), (trim, surfaces.plain((246, 244,
                   240))), (belt, DARK), (buckle, surfaces.plain(GOLD))]  # fmt: skip


@category("santa", size=(0.082, 0.1, 0.148), mass=0.2, material="plastic", aliases=("santa claus",
          "santa figure", "father christmas", "santa figurine", "saint nicholas",
          "santa claus figure", "christmas gnome", "father christmas ornament", "santa ornament",
          "chocolate santa"), themes=("living",), colors=("red",))  # fmt: skip
def santa(look: Look) -> Shape:
    """A Santa Claus figure with a red coat, a white beard, a pointed hat and a sack on his back."""
    color = look.color("red", "red", "crimson", "maroon")
    coat, pieces = _trunk(color, look)
    white = surfaces.spots(look.rng, (248, 246, 242), (228, 226, 222), 0.2)
    skin = surfaces.plain(look.pick([(240, 196, 168), (206, 150, 112), (130, 86, 60)]))
    head = ball(0.036, 0.035, 0.036, (0, -0.001, 0.09), 16)
    beard = join(
        [
            ball(0.034, 0.024, 0.038, (0, -0.012, 0.076), 14),
            *[ball(0.017, 0.01, 0.008, (s * 0.007, -0.0195, 0.0865), 8) for s in (-1, 1)],
        ]
    )
    nose = ball(0.009, 0.009, 0.008, (0, -0.02, 0.0915), 8)
    eyes = [ball(0.005, 0.003, 0.005, (s * 0.007, -0.0175, 0.097), 8) for s in (-1, 1)]
    brim = torus(0.0165, 0.0052, 20, 8).move(z=0.104)
    hat = rod([(0, 0, 0.102), (0.002, 0.002, 0.124), (0.016, 0.006, 0.138), (0.026, 0.006, 0.132)],
              [0.0165, 0.011, 0.006, 0.003], 12)  # fmt: skip
    bob = ball(0.012, 0.012, 0.012, (0.029, 0.006, 0.13), 8)
    arms = [rod([(s * 0.02, 0, 0.07), (s * 0.036, -0.008, 0.055), (s * 0.03, -0.026, 0.046)],
                [0.009, 0.008, 0.007], 8) for s in (-1, 1)]  # fmt: skip
    cuffs = [ball(0.017, 0.014, 0.017, (s * 0.03, -0.026, 0.046), 8) for s in (-1, 1)]
    sack = ball(0.05, 0.036, 0.06, (0.004, 0.036, 0.052), 14)
    red = surfaces.plain(color)
    pieces += [(head, skin), (beard, white), (nose, surfaces.plain((226, 130, 110))),
               (join(eyes), DARK), (join([brim, bob, *cuffs]), white), (join([hat, *arms]), red),
               (sack, surfaces.fabric(look.rng, (150, 108, 70)))]  # fmt: skip
    return put_down(pieces, coat, sack, join([head, brim, hat]), factor=look.between(0.9, 1.2))


@category("snowman", size=(0.13, 0.08, 0.167), mass=0.15, material="plastic",
          aliases=("snowman figure", "snow man", "snowman figurine", "snowman ornament"),
          themes=("living",), colors=("white",))  # fmt: skip
def snowman(look: Look) -> Shape:
    """A snowman of two or three balls with a hat, a scarf and a carrot nose."""
    color = look.color("white", "white", "ivory", "sky")
    snow = surfaces.speckles(look.rng, color, 4)
    tint = look.own_color("red", "blue", "green", "orange", "purple")
    low = ball(0.078, 0.076, 0.07, (0, 0, 0.032), 20)
    mid = ball(0.056, 0.055, 0.052, (0, 0, 0.083), 18)
    head = ball(0.044, 0.043, 0.042, (0, 0, 0.122), 16)
    brim, crown = cylinder(0.028, 0.003, 20).move(z=0.138), cylinder(0.018, 0.024, 20).move(z=0.139)
    band = cylinder(0.0184, 0.006, 20).move(z=0.1415)
    nose = cylinder(0.0045, 0.022, 8, top=0.0006).turn(0, np.pi / 2).move(0, -0.019, 0.12)
    coal = [ball(0.0055, 0.004, 0.0055, (s * 0.008, -0.0195, 0.128), 8) for s in (-1, 1)]
    coal += [ball(0.007, 0.005, 0.007, (0, -y, z), 8) for y, z in ((0.0275, 0.09), (0.0265, 0.075),
                                                                  (0.035, 0.05))]  # fmt: skip
    arms = [rod([(s * 0.024, 0, 0.086), (s * 0.046, -0.004, 0.098), (s * 0.062, -0.006, 0.112)],
                0.0022, 6) for s in (-1, 1)]  # fmt: skip
    scarf = torus(0.021, 0.0065, 22, 8).move(z=0.103)
    tail = box(0.013, 0.005, 0.034).turn(0, 0.2).move(0.012, -0.028, 0.07)
    knit = surfaces.stripes([tint, tint_color(tint, 1.6)], 6, upright=True)
    pieces: Pieces = [(join([low, mid, head]), snow), (join([brim, crown, *coal]), DARK),
                      (join([band, scarf, tail]), knit), (nose, surfaces.plain((236, 130, 40))),
                      (join(arms), surfaces.plain((96, 68, 46)))]  # fmt: skip
    return put_down(pieces, low, mid, join([head, brim, crown]), factor=look.between(0.85, 1.2))


@category("nutcracker", size=(0.085, 0.062, 0.205), mass=0.25, material="wood",
          aliases=("nutcracker figure", "nutcracker soldier", "wooden nutcracker",
          "christmas nutcracker"), themes=("living",), roles=("tall",),
          colors=("red",))  # fmt: skip
def nutcracker(look: Look) -> Shape:
    """A nutcracker soldier on a round base, with a tall hat, a white beard and a red coat."""
    color = look.color("red", "blue", "green", "purple")
    coat = surfaces.speckles(look.rng, color, 4)
    skin = surfaces.plain((240, 200, 170))
    white, gold = surfaces.plain((246, 244, 240)), surfaces.plain(GOLD)
    foot = cylinder(0.03, 0.01, 24, bevel=0.002)
    legs = [cylinder(0.0095, 0.062, 14).move(s * 0.011, 0, 0.009) for s in (-1, 1)]
    boots = [cylinder(0.0108, 0.026, 14).move(s * 0.011, -0.001, 0.0095) for s in (-1, 1)]
    chest = cylinder(0.0235, 0.052, 20, top=0.026, bevel=0.002).scale(1, 0.8, 1).move(z=0.068)
    belt = cylinder(0.0252, 0.007, 20).scale(1, 0.8, 1).move(z=0.073)
    arms = [cylinder(0.008, 0.05, 12, bevel=0.002).move(s * 0.033, 0, 0.068) for s in (-1, 1)]
    pads = [ball(0.022, 0.024, 0.012, (s * 0.031, 0, 0.119), 10) for s in (-1, 1)]
    head = cylinder(0.0195, 0.036, 20, bevel=0.002).move(z=0.119)
    beard = box(0.022, 0.01, 0.026).move(0, -0.017, 0.105)
    hair = ball(0.044, 0.03, 0.034, (0, 0.01, 0.133), 14)
    hat = cylinder(0.02, 0.04, 20, top=0.023, bevel=0.002).move(z=0.154)
    peak = cylinder(0.0215, 0.004, 20).move(0, -0.004, 0.153)
    badge = ball(0.014, 0.006, 0.014, (0, -0.0205, 0.175), 10)
    buttons = [ball(0.006, 0.004, 0.006, (s * 0.008, -0.0205, z), 8) for s in (-1, 1)
               for z in (0.09, 0.102, 0.112)]  # fmt: skip
    eyes = [ball(0.006, 0.004, 0.007, (s * 0.008, -0.018, 0.142), 8) for s in (-1, 1)]
    mouth = box(0.02, 0.003, 0.009).move(0, -0.0185, 0.126)
    pieces: Pieces = [(join([foot, hat, *boots, peak]), surfaces.plain((40, 40, 48))),
                      (join([chest, *arms]), coat), (join([*legs, beard, hair, mouth]), white),
                      (join([belt, badge, *pads, *buttons]), gold), (head, skin),
                      (join(eyes), DARK)]  # fmt: skip
    return put_down(pieces, foot, join(legs), join([chest, *arms]), join([head, hat]),
                   factor=look.between(0.9, 1.25))  # fmt: skip


@category("sculpture", size=(0.09, 0.085, 0.18), mass=0.9, material="stone", aliases=("statue",
          "bust", "statuette", "ornament", "marble bust", "venus de milo statuette",
          "nefertiti bust", "bronze statuette", "wood carving", "ivory carving", "jade carving",
          "scrimshaw", "plaster cast", "garden ornament"), themes=("living", "office"),
          roles=("tall",), colors=("white", "bronze"), common=True)  # fmt: skip
def sculpture(look: Look) -> Shape:
    """A small sculpture on a plinth: a bust, figure, twisted column, ring or stack of stones."""
    color = look.color("white", "bronze", "black", "gray", "gold", "terracotta", "teal", "pink")
    stone = look.surface(color, look.pick(["marble", "bronze", "stone"]))
    base = block(0.085, 0.085, 0.026, 0.004, 0.002)
    wood = surfaces.wood(look.rng, look.own_color("charcoal", "brown"), side=64)
    kind = look.pick(["bust", "bust", "twist", "stones", "figure", "ring"])
    if kind == "bust":
        chest = ellipsoid(0.11, 0.062, 0.085, 24, 12).move(z=0.05)
        neck = cylinder(0.018, 0.05, 20, top=0.016).move(z=0.078)
        head = ellipsoid(0.054, 0.066, 0.078, 24, 14).move(y=-0.004, z=0.155)
        nose = ellipsoid(0.012, 0.02, 0.024, 10, 8).move(y=-0.036, z=0.15)
        hair = ellipsoid(0.062, 0.066, 0.056, 20, 12).move(y=0.008, z=0.173)
        figure = [chest, neck, head, nose, hair]
    elif kind == "twist":
        square = rectangle(0.05, 0.05)
        rings = []
        for t in np.linspace(0, 1, 13):
            c, s = np.cos(2.4 * t), np.sin(2.4 * t)
            turned = square @ np.array([[c, s], [-s, c]]) * (1 - 0.45 * t)
            rings.append(np.column_stack([turned, np.full(4, 0.025 + 0.15 * t)]))
        figure = [loft(np.stack(rings), square, profile=np.array([(0.0, t) for t in range(13)]))]
    elif kind == "figure":  # a slender figure with raised arms
        robe = cylinder(0.03, 0.075, 18, top=0.014, bevel=0.002).move(z=0.024)
        trunk = ellipsoid(0.04, 0.026, 0.07, 18, 10).move(z=0.118)
        head = ellipsoid(0.024, 0.026, 0.03, 16, 10).move(z=0.166)
        arms = [tube(smooth([(s * 0.012, 0, 0.138), (s * 0.036, 0, 0.15), (s * 0.03, 0, 0.188)], 4),
                     0.0055, 8) for s in (-1, 1)]  # fmt: skip
        figure = [robe, trunk, head, *arms]
    elif kind == "ring":
        turn = look.between(-0.4, 0.4)
        hoop = torus(0.05, 0.013, 28, 12).turn(0, np.pi / 2).turn(2, turn).move(z=0.085)
        figure = [hoop, ellipsoid(0.034, 0.034, 0.034, 18, 12).move(z=0.162)]
    else:
        sizes = [(0.08, 0.04), (0.064, 0.036), (0.05, 0.03), (0.034, 0.024)]
        figure, z = [], 0.024
        for wide, tall in sizes:
            figure.append(
                ellipsoid(wide, 0.85 * wide, tall, 20, 10)
                .turn(1, look.between(-0.12, 0.12))
                .move(look.between(-0.004, 0.004), 0, z + tall / 2)
            )
            z += tall * 0.9
    return shape(
        [(base, wood), *((solid, stone) for solid in figure)],
        [box_part(0.085, 0.085, 0.026), *[hull_of(solid) for solid in figure]],
    )


Named = list[tuple[Solid, str]]
"""Solids and the paint each takes: "skin", "pale", "dark" or "accent"."""


def _ball(x: float, y: float, z: float, at: tuple[float, float, float]) -> Solid:
    """Return an ellipsoid with the diameters ``x``, ``y`` and ``z``, centred at ``at``."""
    return ellipsoid(x, y, z, 16, 10).move(*at)


def _cat() -> Named:
    made = [(_ball(0.042, 0.05, 0.07, (0, 0.004, 0.032)), "skin"),
            (_ball(0.036, 0.032, 0.031, (0, -0.008, 0.075)), "skin"),
            (_ball(0.022, 0.01, 0.034, (0, -0.02, 0.036)), "pale"),
            (_ball(0.006, 0.005, 0.004, (0, -0.025, 0.073)), "accent"),
            (tube(smooth([(0.012, 0.025, 0.006), (0.034, 0.014, 0.006), (0.034, -0.012, 0.006)], 4),
                  0.005, 8), "skin")]  # fmt: skip
    for s in (-1, 1):
        made += [(cylinder(0.008, 0.017, 4, top=0.0008).move(s * 0.011, -0.006, 0.084), "skin"),
                 (_ball(0.012, 0.02, 0.012, (s * 0.01, -0.022, 0.005)), "pale"),
                 (_ball(0.005, 0.004, 0.006, (s * 0.008, -0.0225, 0.079)), "dark")]  # fmt: skip
    return made


def _rabbit() -> Named:
    made = [(_ball(0.042, 0.05, 0.055, (0, 0.006, 0.026)), "skin"),
            (_ball(0.034, 0.036, 0.034, (0, -0.008, 0.062)), "skin"),
            (_ball(0.016, 0.016, 0.016, (0, 0.033, 0.014)), "pale"),
            (_ball(0.005, 0.005, 0.004, (0, -0.026, 0.06)), "accent")]  # fmt: skip
    for s in (-1, 1):
        ear = ellipsoid(0.012, 0.008, 0.042, 12, 8).turn(1, s * 0.22)
        made += [(ear.move(s * 0.012, 0, 0.092), "skin"),
                 (ear.scale(0.6, 0.6, 0.8).move(s * 0.012, -0.003, 0.092), "pale"),
                 (_ball(0.014, 0.024, 0.012, (s * 0.012, -0.02, 0.005)), "skin"),
                 (_ball(0.005, 0.004, 0.006, (s * 0.009, -0.0235, 0.067)), "dark")]  # fmt: skip
    return made


def _owl() -> Named:
    made = [(_ball(0.056, 0.05, 0.08, (0, 0, 0.038)), "skin"),
            (_ball(0.036, 0.012, 0.046, (0, -0.021, 0.028)), "pale"),
            (cylinder(0.005, 0.011, 8, top=0.0006).turn(0, np.pi / 2 + 0.4)
             .move(0, -0.022, 0.056), "accent")]  # fmt: skip
    for s in (-1, 1):
        made += [(_ball(0.024, 0.008, 0.024, (s * 0.012, -0.0185, 0.062)), "pale"),
                 (_ball(0.012, 0.006, 0.012, (s * 0.012, -0.022, 0.062)), "dark"),
                 (cylinder(0.009, 0.016, 6, top=0.001).move(s * 0.016, -0.004, 0.07), "skin"),
                 (_ball(0.014, 0.034, 0.05, (s * 0.027, 0.004, 0.034)), "accent")]  # fmt: skip
    return made


def _elephant() -> Named:
    trunk = smooth(
        [(0, -0.035, 0.046), (0, -0.05, 0.034), (0, -0.055, 0.016), (0, -0.064, 0.012)], 4
    )
    made = [(_ball(0.046, 0.064, 0.046, (0, 0.008, 0.042)), "skin"),
            (_ball(0.036, 0.034, 0.038, (0, -0.028, 0.054)), "skin"),
            (tube(trunk, np.linspace(0.0075, 0.004, len(trunk)), 10), "skin")]  # fmt: skip
    for s in (-1, 1):
        tusk = smooth(
            [(s * 0.009, -0.036, 0.042), (s * 0.011, -0.05, 0.034), (s * 0.011, -0.06, 0.038)], 3
        )
        made += [(_ball(0.03, 0.008, 0.036, (s * 0.026, -0.02, 0.056)), "accent"),
                 (tube(tusk, 0.0022, 6), "pale"),
                 (_ball(0.005, 0.004, 0.005, (s * 0.011, -0.0425, 0.06)), "dark")]  # fmt: skip
        made += [
            (cylinder(0.0095, 0.036, 12).move(s * 0.012, y, 0), "skin") for y in (-0.01, 0.026)
        ]
    return made


def _penguin() -> Named:
    made = [(_ball(0.05, 0.044, 0.076, (0, 0, 0.036)), "skin"),
            (_ball(0.036, 0.016, 0.056, (0, -0.016, 0.032)), "pale"),
            (_ball(0.034, 0.034, 0.032, (0, -0.002, 0.078)), "skin"),
            (cylinder(0.005, 0.014, 8, top=0.0006).turn(0, np.pi / 2)
             .move(0, -0.016, 0.076), "accent")]  # fmt: skip
    for s in (-1, 1):
        wing = ellipsoid(0.008, 0.022, 0.048, 12, 8).turn(1, -0.25 * s)
        made += [(wing.move(s * 0.027, 0, 0.04), "skin"),
                 (_ball(0.018, 0.026, 0.008, (s * 0.012, -0.014, 0.003)), "accent"),
                 (_ball(0.005, 0.004, 0.006, (s * 0.008, -0.017, 0.083)), "dark")]  # fmt: skip
    return made


def _lady() -> Named:
    robe = lathe(
        [(0, 0), (0.028, 0), (0.029, 0.004), (0.016, 0.05), (0.0095, 0.066), (0, 0.07)], 20
    )
    made = [(robe.scale(1, 0.85, 1), "accent"),
            (_ball(0.026, 0.019, 0.036, (0, 0, 0.078)), "skin"),
            (_ball(0.021, 0.022, 0.026, (0, -0.002, 0.104)), "pale"),
            (_ball(0.024, 0.02, 0.025, (0, 0.003, 0.108)), "dark"),
            (_ball(0.012, 0.012, 0.012, (0, 0.008, 0.121)), "dark")]  # fmt: skip
    for s in (-1, 1):
        arm = smooth(
            [(s * 0.011, 0, 0.088), (s * 0.02, -0.004, 0.07), (s * 0.004, -0.016, 0.068)], 4
        )
        made.append((tube(arm, 0.004, 8), "skin"))
    return made


def _angel() -> Named:
    robe = lathe(
        [(0, 0), (0.026, 0), (0.027, 0.003), (0.012, 0.062), (0.008, 0.075), (0, 0.078)], 20
    )
    made = [(robe, "skin"), (_ball(0.024, 0.024, 0.026, (0, -0.002, 0.09)), "pale"),
            (_ball(0.027, 0.023, 0.025, (0, 0.003, 0.0945)), "dark"),
            (torus(0.012, 0.0015, 20, 6).move(0, 0, 0.109), "accent")]  # fmt: skip
    for s in (-1, 1):
        wing = ellipsoid(0.028, 0.006, 0.056, 14, 8).turn(1, -0.45 * s)
        arm = smooth(
            [(s * 0.009, -0.003, 0.07), (s * 0.014, -0.012, 0.056), (s * 0.002, -0.02, 0.06)], 4
        )
        made += [(wing.move(s * 0.022, 0.012, 0.064), "accent"), (tube(arm, 0.0038, 8), "skin")]
    return made


def _bird() -> Named:
    tail = ellipsoid(0.014, 0.044, 0.006, 12, 6).turn(0, 0.35).move(0, 0.038, 0.03)
    made = [(_ball(0.042, 0.06, 0.046, (0, 0, 0.026)), "skin"), (tail, "accent"),
            (_ball(0.034, 0.032, 0.032, (0, -0.02, 0.05)), "skin"),
            (_ball(0.03, 0.03, 0.03, (0, -0.014, 0.022)), "pale"),
            (cylinder(0.0045, 0.014, 8, top=0.0006).turn(0, np.pi / 2)
             .move(0, -0.033, 0.05), "dark")]  # fmt: skip
    for s in (-1, 1):
        made += [(_ball(0.01, 0.042, 0.026, (s * 0.019, 0.006, 0.03)), "accent"),
                 (_ball(0.005, 0.005, 0.005, (s * 0.011, -0.0315, 0.055)), "dark")]  # fmt: skip
    return made


FIGURES: MappingProxyType[str, Callable[[], Named]] = MappingProxyType(
    {"angel": _angel, "bird": _bird, "cat": _cat, "elephant": _elephant, "lady": _lady,
     "owl": _owl, "penguin": _penguin, "rabbit": _rabbit}
)  # fmt: skip
"""Kinds of figurines."""


@category("figurine", size=(0.062, 0.066, 0.105), mass=0.12, material="ceramic", hollow=True,
          assembled=True, aliases=("small statue", "porcelain figurine", "ceramic figurine",
          "animal figurine", "cat figurine", "owl figurine", "elephant figurine", "bird figurine",
          "angel figurine", "penguin figurine", "rabbit figurine", "porcelain figure",
          "fairy ornament", "angel ornament", "angel figure", "fairy figurine",
          "black cat figurine", "owl figure", "tea pet", "venus figurine", "cycladic figure",
          "terracotta warrior figure", "terracotta warrior", "benin bronze", "inca figure",
          "netsuke", "shabti", "taxidermy owl", "staffordshire figure", "big ben model", "big ben",
          "glass animal", "crystal swan", "swan ornament", "owl ornament", "elephant ornament",
          "angel wings ornament", "ceramic owl", "gryphon figure", "smurf figurine",
          "bonnet ornament", "lladro figurine", "kissing couple figurine"),
          themes=("living", "office"), colors=("white", "brown"), common=True)  # fmt: skip
def figurine(look: Look) -> Shape:
    """A stylised animal or person, painted or made of one material, often on a small base."""
    made = FIGURES[look.pick(sorted(FIGURES))]()
    k, finish = look.between(0.85, 1.1), look.pick(["painted", "painted", "glazed", "one"])
    color = look.color("white", "cream", "gray", "brown", "orange", "teal", "pink", "gold", "black")
    other = look.own_color("coral", "mustard", "teal", "navy", "gold", "pink", "crimson")
    skin = look.surface(
        color, "ceramic" if finish != "one" else look.pick(["bronze", "oak", "ceramic"])
    )
    pale = surfaces.plain(tint_color(color, 1.6) if sum(color) < 600 else (246, 226, 206))
    paints = {"skin": skin, "pale": pale, "dark": surfaces.plain((40, 34, 34)),
              "accent": surfaces.speckles(look.rng, other, 6, 32)}  # fmt: skip
    if finish == "one":
        paints = dict.fromkeys(paints, skin)
    elif finish == "glazed":
        paints["skin"] = surfaces.gradient(color, other, look.rng)
    solids = [(solid.bend(above), paint) for solid, paint in made]
    reach = float(np.abs(solids[0][0].vertices[:, :2]).max())
    pieces = [(solid.move(z=0.006), paints[paint]) for solid, paint in solids]
    base = cylinder(reach + 0.003, 0.0065, 28, bevel=0.0015)
    stand = look.pick(
        [skin, surfaces.wood(look.rng, (110, 76, 50), side=64), surfaces.plain(other)]
    )
    hulls = sorted((solid for solid, _ in pieces), key=lambda s: -s.volume)[:6]
    parts = [cylinder_part(reach + 0.003, 0.006), *map(hull_of, hulls)]
    return shape([*pieces, (base, stand)], parts).scale(k)


@category("matryoshka", size=(0.065, 0.065, 0.112), mass=0.08, material="wood", hollow=True,
          aliases=("matryoshka doll", "matrioshka", "russian doll", "nesting doll",
          "russian nesting doll", "babushka doll", "babushka"), themes=("living", "toys"),
          roles=("round",), colors=("red", "blue"), common=True)  # fmt: skip
def matryoshka(look: Look) -> Shape:
    """A painted nesting doll with a scarf, a face and an apron with a flower."""
    h = look.between(0.085, 0.14)
    r = h * look.between(0.27, 0.31)
    head = look.between(0.7, 0.78)
    t = [0, 0, 0.03, 0.18, 0.34, 0.5, 0.6, 0.66, 0.76, 0.86, 0.94, 0.985, 1]
    radii = [0, 0.74, 0.82, 0.97, 1, 0.9, 0.76, head - 0.02, head + 0.02, head - 0.04, 0.5, 0.24, 0]
    profile = np.column_stack([np.array(radii) * r, np.array(t) * h])
    doll = lathe(profile, 32, v=t)
    color = look.color("red", "crimson", "blue", "green", "purple", "teal", "pink", "black")
    scarf = look.own_color("yellow", "mustard", "red", "coral", "teal", "navy", "pink", "lime")
    if np.abs(np.array(scarf) - color).max() < 60:
        scarf = tint_color(color, 1.55)
    parts = [cylinder_part(0.74 * r, 0.1 * h),
             hull_of(doll.bend(lambda p: np.minimum(p, [1, 1, 0.64 * h]))),
             hull_of(doll.bend(lambda p: np.maximum(p, [-1, -1, 0.64 * h])))]  # fmt: skip
    return shape([(doll, _paint(look, color, scarf))], parts)


def _paint(look: Look, color: RGB, scarf: RGB) -> Tile:
    """Return a nesting doll's texture: u runs around it (its face is at 0.5), and v runs up."""
    image = prints.canvas(256, 192, color)
    apron, petal = (look.own_color("cream", "white", "mustard", "sky"),
                    look.own_color("red", "pink", "blue"))  # fmt: skip
    hair = look.pick([(70, 44, 28), (214, 166, 84), (150, 82, 40), (40, 32, 30)])
    prints.fill(image, 0, 0, 1, 0.4, scarf)
    for k in range(24):
        prints.disc(image, (k % 8 + 0.5 * (k // 8 % 2)) / 8, 0.09 + 0.11 * (k // 8), 0.018, petal)
    prints.polygon(image, [(0.5, 0.38), (0.4, 0.5), (0.47, 0.52), (0.53, 0.52), (0.6, 0.5)], scarf)
    prints.disc(image, 0.5, 0.25, 0.128, hair)
    prints.disc(image, 0.5, 0.265, 0.108, (246, 214, 184))
    prints.polygon(image, [(0.43, 0.2), (0.5, 0.135), (0.57, 0.2), (0.5, 0.18)], hair)
    for s in (-1, 1):
        prints.disc(image, 0.5 + 0.03 * s, 0.25, 0.015, (44, 60, 90))
        prints.disc(image, 0.5 + 0.045 * s, 0.295, 0.022, (238, 150, 136))
    prints.fill(image, 0.485, 0.315, 0.03, 0.014, (200, 40, 50))
    prints.disc(image, 0.5, 0.72, 0.22, apron)
    prints.fill(image, 0, 0.94, 1, 0.06, look.own_color("gold", "black", "green", "mustard"))
    for x, y, size in ((0.5, 0.7, 0.085), (0.42, 0.8, 0.05), (0.58, 0.8, 0.05), (0.06, 0.7, 0.08),
                       (0.94, 0.7, 0.08), (0.25, 0.72, 0.06), (0.75, 0.72, 0.06)):  # fmt: skip
        for angle in np.arange(4) * np.pi / 2 + 0.8:
            leaf = (x + size * np.cos(angle), y + 1.1 * size * np.sin(angle))
            prints.disc(image, *leaf, 0.4 * size, (70, 130, 70))
        for angle in np.arange(6) * np.pi / 3:
            spot = (x + 0.42 * size * np.cos(angle), y + 0.56 * size * np.sin(angle))
            prints.disc(image, *spot, 0.42 * size, petal)
        prints.disc(image, x, y, 0.36 * size, (246, 210, 100))
    return image


@category("scarab", size=(0.0707, 0.0502, 0.0261), mass=0.09, material="stone",
          aliases=("scarab beetle", "egyptian scarab", "scarab amulet"), themes=("living",),
          colors=("teal",))  # fmt: skip
def scarab(look: Look) -> Shape:
    """A carved stone scarab: wing cases, a head and legs on a flat oval."""
    color = look.color("turquoise", "teal", "green", "navy", "gold", "charcoal")
    k = look.between(0.85, 1.2)
    base = plate(ellipse(0.066, 0.046, 28), 0.006)
    back = ball(0.05, 0.041, 0.034, (-0.006, 0, 0.007), 20)
    collar = ball(0.02, 0.036, 0.024, (0.018, 0, 0.007), 16)
    head = ball(0.016, 0.022, 0.014, (0.028, 0, 0.006), 12)
    seam = [
        rod([(0.01, 0.0, 0.021), (-0.006, 0, 0.0243), (-0.03, 0, 0.01)], 0.0009, 6),
        rod([(0.01, 0.017, 0.011), (0.0105, 0, 0.021), (0.01, -0.017, 0.011)], 0.0009, 6),
    ]
    legs = [rod([(x, s * 0.016, 0.008), (x + d, s * 0.023, 0.008)], 0.002, 6) for x,
            d in ((0.016, 0.008), (0.0, 0.003), (-0.018, -0.006)) for s in (-1, 1)]  # fmt: skip
    dark = plain(tint_color(color, 0.45))
    return put_down(
        [(join([base, back, collar, head]), look.surface(color, "stone")),
         (join([*seam, *legs]), dark)],
        base, back, collar, head, factor=k,
    )  # fmt: skip


@category("moai", size=(0.0715, 0.0684, 0.114), mass=0.4, material="stone", aliases=("moai figure",
          "moai statue", "moai head", "easter island head", "easter island statue"),
          themes=("living",), colors=("gray",))  # fmt: skip
def moai(look: Look) -> Shape:
    """A moai head with a long nose, a heavy brow and a flat top."""
    k = look.between(0.85, 1.2)
    neck = block(0.052, 0.05, 0.03, 0.012)
    face = block(0.056, 0.056, 0.08, 0.014, 0.006).move(z=0.028)
    brow = at_box(0.054, 0.016, 0.012, (0, -0.026, 0.082))
    nose = at_box(0.015, 0.018, 0.042, (0, -0.028, 0.046))
    chin = block(0.034, 0.02, 0.014, 0.005).move(0, -0.024, 0.029)
    lips = at_box(0.026, 0.01, 0.006, (0, -0.028, 0.043))
    ears = [at_box(0.008, 0.016, 0.045, (s * 0.03, 0, 0.045)) for s in (-1, 1)]
    eyes = [at_box(0.014, 0.004, 0.008, (s * 0.016, -0.0275, 0.073)) for s in (-1, 1)]
    color = look.color("gray", "charcoal", "tan", "sage", spread=14)
    rock = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.2)
    body = [neck, face, brow, nose, chin, *ears]
    return put_down([(join([*body, lips]), rock), (join(eyes), plain(tint_color(color, 0.4)))],
                    *body, factor=k)  # fmt: skip


@category("totem_pole", size=(0.122, 0.0783, 0.175), mass=0.15, material="wood",
          aliases=("totem pole model", "carved totem"), themes=("living",), roles=("tall",),
          colors=("wooden",))  # fmt: skip
def totem_pole(look: Look) -> Shape:
    """A carved totem pole of three painted faces below a pair of wings."""
    k = look.between(0.85, 1.2)
    color = look.color("wooden", "brown", "tan")
    base = drum(0.03, 0.008)
    trunk = drum(0.021, 0.165, (0, 0, 0.007))
    paint: dict[str, list[Solid]] = {"red": [], "white": [], "black": [], "teal": []}
    for n in range(3):
        z = 0.018 + 0.05 * n
        paint[("red", "teal", "red")[n]] += [at_box(0.036, 0.01, 0.007, (0, -0.018, z + 0.035))]
        paint["white"] += [
            ball(0.015, 0.008, 0.013, (s * 0.01, -0.019, z + 0.027)) for s in (-1, 1)
        ]
        paint["black"] += [
            ball(0.007, 0.008, 0.008, (s * 0.01, -0.021, z + 0.027)) for s in (-1, 1)
        ]
        if n == 2:
            paint["teal"].append(drum(0.006, 0.03, (0, -0.017, z + 0.018), top=0.001, sides=8)
                                 .move(0, 0.017, -z - 0.018).turn(0, np.pi / 2)
                                 .move(0, -0.017, z + 0.018))  # fmt: skip
        else:
            paint["red"].append(at_box(0.026, 0.01, 0.009, (0, -0.018, z + 0.005)))
            paint["white"].append(at_box(0.022, 0.011, 0.003, (0, -0.018, z + 0.008)))
    rim = np.array(
        [(-0.06, 0.02), (0, 0.002), (0.06, 0.02), (0.054, 0.04), (0, 0.026), (-0.054, 0.04)]
    )
    wing = plate(rim, 0.008).turn(0, np.pi / 2).move(0, 0.012, 0.12)
    paint["teal"].append(wing)
    tones = {name: look.own_color(name) for name in paint}
    pieces = [(join([base, trunk]), surfaces.wood(look.rng, color))]
    pieces += [(join(solids), plain(tones[name])) for name, solids in paint.items()]
    return put_down(pieces, base, trunk, wing, factor=k)


@category("gargoyle", size=(0.0872, 0.076, 0.118), mass=0.35, material="ceramic",
          aliases=("gargoyle figurine", "gargoyle statue", "stone gargoyle"), themes=("living",),
          colors=("gray",))  # fmt: skip
def gargoyle(look: Look) -> Shape:
    """A stone gargoyle: a hunched figure with folded wings on a plinth."""
    k = look.between(0.9, 1.1)
    color = look.color("gray", "charcoal", "silver")
    plinth = block(0.06, 0.06, 0.022, 0.003, 0.002)
    body = lathe(np.maximum(smooth([(0, 0.02), (0.024, 0.02), (0.028, 0.04), (0.018, 0.07), (0,
                 0.08)], 3), 0), 18)  # fmt: skip
    head = ball(0.034, 0.038, 0.03, (0, -0.014, 0.084), 14)
    horns = [limb([(s * 0.01, -0.006, 0.094), (s * 0.018, 0.004, 0.108), (s * 0.014, 0.012, 0.116)],
                  [0.005, 0.0035, 0.001], 6) for s in (-1, 1)]  # fmt: skip
    snout = ball(0.018, 0.018, 0.014, (0, -0.034, 0.078), 10)
    arms = [limb([(s * 0.022, -0.006, 0.06), (s * 0.028, -0.024, 0.045),
                  (s * 0.018, -0.026, 0.024)], [0.008, 0.007, 0.008], 8)
            for s in (-1, 1)]  # fmt: skip
    wings = [prism(np.array([(0, 0), (0.03, 0.012), (0.034, 0.06), (0.018, 0.046), (0.004, 0.05)]),
                   -0.0025,
                   0.0025).turn(0, np.pi / 2).turn(2, 0.5).move(0.012, 0.014, 0.036)]  # fmt: skip
    wings.append(Solid(wings[0].vertices * [-1, 1, 1], wings[0].faces[:, ::-1], wings[0].uv))
    stone = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.2)
    thing = join([body, head, *horns, snout, *arms, *wings])
    return shape([(plinth, stone), (thing, stone)],
                 [hull_of(plinth), hull_above(thing)]).scale(k)  # fmt: skip


@category("piggy_bank", size=(0.14, 0.093, 0.115), mass=0.35, material="ceramic", hollow=True,
          aliases=("money box", "coin bank", "pig bank", "savings bank", "money bank"),
          themes=("living",), colors=("pink",))  # fmt: skip
def piggy_bank(look: Look) -> Shape:
    """A porcelain pig with a slot in its back."""
    color = look.color("pink", "pink", "white", "sky", "gold", "red")
    skin = surfaces.speckles(look.rng, color, 4)
    body = ball(0.115, 0.092, 0.09, (0, 0, 0.056), 24)
    snout = cylinder(0.02, 0.022, 20, bevel=0.003).turn(1, -np.pi / 2).move(-0.046, 0, 0.055)
    holes = [ball(0.004, 0.008, 0.011, (-0.068, s * 0.008, 0.056), 8) for s in (-1, 1)]
    eyes = [ball(0.008, 0.008, 0.009, (-0.045, s * 0.024, 0.075), 10) for s in (-1, 1)]
    ears = [cylinder(0.015, 0.024, 4, top=0.001).scale(0.6, 1, 1).turn(0, -s * 0.5)
            .move(-0.03, s * 0.027, 0.086) for s in (-1, 1)]  # fmt: skip
    legs = [cylinder(0.0145, 0.035, 16, top=0.017).move(sx * 0.032, sy * 0.025)
            for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    tail = rod([(0.055, 0, 0.06), (0.066, 0.006, 0.068), (0.064, -0.004, 0.076), (0.07, 0.0, 0.08)],
               0.003, 7)  # fmt: skip
    slot = box(0.034, 0.005, 0.004).move(0.004, 0, 0.0982)
    dark = surfaces.plain((44, 34, 36))
    return put_down([(join([body, snout, *ears, *legs, tail]), skin), (join([*holes, *eyes, slot]),
                                                                       dark)], body, join(legs),
                    join([snout]), factor=look.between(0.85, 1.15))  # fmt: skip


CATEGORIES = (
    Category("virgin_mary_statue",
             from_pieces(bodies=4)(_robed_figure(("white", "cream"), ("sky", "blue"), True)),
             size=(0.072, 0.072, 0.192), mass=0.4, material="ceramic", aliases=("virgin mary",
             "madonna", "madonna statue", "our lady statue", "mary statue", "mary figurine"),
             themes=("living",), roles=("tall",), colors=("white",)),
    Category("nativity_figure", from_pieces(bodies=4)(_robed_figure(("brown", "crimson", "purple",
             "tan"), ("brown", "navy", "green", "maroon"), False)), size=(0.072, 0.072, 0.186),
             mass=0.3, material="ceramic", aliases=("nativity figurine", "saint statue",
             "saint figurine", "jesus statue", "monk statue", "shepherd figure", "apostle statue",
             "jesus figurine", "monk figurine", "wise man", "angel statue"), themes=("living",),
             roles=("tall",), colors=("brown",)),
    Category("ganesha_statue", from_pieces(bodies=4)(_deity(True, True)),
             size=(0.141, 0.115, 0.163), mass=0.5, material="ceramic",
             aliases=("ganesha", "ganesh", "ganesh statue", "ganesha figurine", "ganesh figurine"),
             themes=("living",), colors=("gold",)),
    Category("shiva_statue", from_pieces(bodies=4)(_deity(True, False)), size=(0.146, 0.119, 0.168),
             mass=0.5, material="ceramic", aliases=("shiva", "vishnu statue", "hindu statue",
             "krishna figurine", "krishna statue", "lakshmi statue", "hindu deity", "hindu god",
             "nataraja"), themes=("living",), colors=("bronze",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
