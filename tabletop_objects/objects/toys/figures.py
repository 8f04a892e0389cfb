"""Objects of the ``toys`` theme: figures."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, plastic
from ...kit.parts import box_part
from ...kit.primitives import at_block, at_box, ball, disc, drum, plate, rod, standing, straight
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus
from ...kit.surfaces import Look, plain, tint_color

BLACK = surfaces.plain((34, 34, 37))


@category("lego_figure", size=(0.0297, 0.0167, 0.0412), mass=0.004, material="plastic",
          aliases=("minifigure", "lego minifigure", "lego man", "minifig", "brick figure",
          "lego person"), themes=("toys",), colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=4)
def lego_figure(look: Look) -> Pieces:
    """A small, jointed brick figure."""
    shirt, trousers = plastic(look, *PAINTS), dye(look, "blue", "black", "gray", "green", "red")
    yellow = surfaces.plain((246, 206, 70))
    legs = [at_box(0.0075, 0.008, 0.0135, (s * 0.0041, 0, 0)) for s in (-1, 1)]
    hips = at_box(0.016, 0.008, 0.004, (0, 0, 0.0135))
    body = prism(np.array([(-0.008, 0.0175), (0.008, 0.0175), (0.0062, 0.03), (-0.0062, 0.03)]),
                 -0.004, 0.004).turn(0, np.pi / 2)  # fmt: skip
    arms = [rod([(s * 0.0068, 0, 0.028), (s * 0.0105, -0.001, 0.023), (s * 0.0112, -0.006, 0.0175)],
                0.0024, 8) for s in (-1, 1)]  # fmt: skip
    hands = [torus(0.0022, 0.0012, 12, 5).move(s * 0.0113, -0.008, 0.0165) for s in (-1, 1)]
    head = [disc(0.0051, 0.0085, (0, 0, 0.0305)), disc(0.0025, 0.002, (0, 0, 0.0388))]
    face = [ball(0.0014, 0.0008, 0.0014, (s * 0.0019, -0.0049, 0.036), 8) for s in (-1, 1)]
    face.append(at_box(0.0036, 0.0006, 0.0007, (0, -0.0051, 0.0328)))
    return [(join([*legs, hips]), trousers), (body, shirt), (join(arms), shirt),
            (join(head), yellow), (join(hands), yellow), (join(face), BLACK)]  # fmt: skip


@category("vinyl_figure", size=(0.064, 0.064, 0.09), mass=0.1, material="plastic", hollow=True,
          aliases=("funko pop", "funko", "collectible figure", "pop figure", "funko figure",
          "anime figure"), themes=("toys",), colors=("black",))  # fmt: skip
@from_pieces(bodies=7)
def vinyl_figure(look: Look) -> Pieces:
    """A collector's figure on a base, with a huge square head and black eyes."""
    hair, shirt = plastic(look, "black", "brown", "red", "yellow", "purple"), dye(look, *PAINTS)
    skin = dye(look, "beige", "tan", "brown")
    base = disc(0.032, 0.004)
    legs = [at_block(0.013, 0.014, 0.018, 0.005, (s * 0.009, 0, 0.004)) for s in (-1, 1)]
    body = at_block(0.03, 0.02, 0.022, 0.008, (0, 0, 0.02))
    arms = [rod([(s * 0.015, 0, 0.038), (s * 0.021, -0.003, 0.026)], 0.0055, 8) for s in (-1, 1)]
    head = at_block(0.056, 0.048, 0.042, 0.018, (0, 0, 0.041))
    top = at_block(0.06, 0.05, 0.018, 0.02, (0, 0.002, 0.073))
    back = at_block(0.058, 0.02, 0.032, 0.009, (0, 0.018, 0.046))
    eyes = [ball(0.011, 0.004, 0.012, (s * 0.014, -0.0235, 0.058), 12) for s in (-1, 1)]
    nose = ball(0.006, 0.005, 0.005, (0, -0.0245, 0.051), 8)
    return [(base, BLACK), (join(legs), dye(look, "navy", "black", "brown")), (body, shirt),
            (head, skin), (top, hair), (back, hair), (join(arms), shirt), (join(eyes), BLACK),
            (nose, skin)]  # fmt: skip


@category("bobblehead", size=(0.0696, 0.0757, 0.139), mass=0.15, material="plastic",
          aliases=("bobble head", "nodding figure", "bobblehead figure"), themes=("toys",),
          colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=8)
def bobblehead(look: Look) -> Pieces:
    """A bobblehead: a figure with a big head on a spring."""
    base = disc(0.034, 0.01)
    shirt = plastic(look, *PAINTS)
    legs = [standing((0.008, 0.01), (0.009, 0.04)).move(x=s * 0.01) for s in (-1, 1)]
    body = standing((0.018, 0.038), (0.02, 0.05), (0.016, 0.068), (0.006, 0.072)).scale(1, 0.75, 1)
    arms = [rod([(s * 0.016, 0, 0.066), (s * 0.026, -0.006, 0.052), (s * 0.018, -0.016, 0.046)],
                [0.006, 0.0055, 0.005], 8) for s in (-1, 1)]  # fmt: skip
    neck = standing((0.005, 0.07), (0.005, 0.08))
    head = ball(0.05, 0.048, 0.056, (0, 0, 0.104), 20)
    cap = ball(0.053, 0.051, 0.036, (0, 0.002, 0.118), 18)
    brim = disc(0.02, 0.003, (0, -0.02, 0.113))
    eyes = [ball(0.008, 0.004, 0.009, (s * 0.01, -0.022, 0.105), 10) for s in (-1, 1)]
    grin = ball(0.018, 0.004, 0.005, (0, -0.0215, 0.091), 10)
    skin = dye(look, "beige", "tan", "brown")
    return [(base, BLACK), (join(legs), dye(look, "white", "navy", "gray")), (body, shirt),
            (neck, skin), (head, skin), (cap, shirt), (brim, shirt), (join(arms), skin),
            (join(eyes), BLACK), (grin, dye(look, "crimson"))]  # fmt: skip


MR_POTATO_HEAD_BLACK = surfaces.plain((34, 34, 37))
WHITE = surfaces.plain((244, 242, 238))


@category("mr_potato_head", size=(0.156, 0.0939, 0.141), mass=0.2, material="plastic",
          aliases=("potato head", "mrs potato head", "potato man"), themes=("toys",),
          colors=("tan",))  # fmt: skip
@from_pieces(foot=0.12, bodies=3)
def mr_potato_head(look: Look) -> Pieces:
    """A potato with a hat, eyes, a nose, a moustache, ears, arms and shoes."""
    body = ball(0.085, 0.075, 0.1, (0, 0, 0.066), 24)
    shoes = [ball(0.04, 0.056, 0.026, (s * 0.022, -0.01, 0.012), 14) for s in (-1, 1)]
    eyes = [ball(0.02, 0.012, 0.026, (s * 0.011, -0.033, 0.092), 12) for s in (-1, 1)]
    pupils = [ball(0.009, 0.006, 0.011, (s * 0.011, -0.0385, 0.09), 8) for s in (-1, 1)]
    nose = ball(0.02, 0.024, 0.02, (0, -0.041, 0.072), 12)
    lip = ball(0.044, 0.012, 0.012, (0, -0.0375, 0.056), 12)
    ears = [ball(0.014, 0.016, 0.026, (s * 0.044, 0, 0.082), 10) for s in (-1, 1)]
    arms = [rod([(s * 0.04, 0, 0.06), (s * 0.06, -0.01, 0.055), (s * 0.066, -0.012, 0.075)],
                [0.007, 0.007, 0.01], 8) for s in (-1, 1)]  # fmt: skip
    hat = [disc(0.036, 0.004, (0, 0, 0.108)), disc(0.023, 0.026, (0, 0, 0.11))]
    return [(body, surfaces.speckles(look.rng, look.color("tan", "brown"), 8)),
            (join(shoes), dye(look, "blue", "orange")), (join(hat), dye(look, "black", "green",
                                                                        "navy")),
            (join(ears), dye(look, "pink")), (join(arms), WHITE), (join(eyes), WHITE),
            (join(pupils), MR_POTATO_HEAD_BLACK), (nose, surfaces.plain((222, 60, 50))),
            (lip, MR_POTATO_HEAD_BLACK)]  # fmt: skip


@category("furby", size=(0.126, 0.111, 0.135), mass=0.3, material="plastic", aliases=("furry robot",
          "gremlin toy", "toy monster", "monster toy", "plush monster", "pokemon figure",
          "tamagotchi pet"), themes=("toys",), colors=("purple",))  # fmt: skip
@from_pieces(bodies=3)
def furby(look: Look) -> Pieces:
    """A furry creature with pointed ears, big round eyes, a yellow beak, a pale belly and feet."""
    color = look.color("purple", "teal", "orange", "pink", "gray", "sky")
    fur = surfaces.scratches(look.rng, color, tint_color(color, 1.3), 160)
    body = standing((0.04, 0), (0.052, 0.02), (0.05, 0.06), (0.036, 0.1), (0.012, 0.115))
    belly = ball(0.06, 0.03, 0.06, (0, -0.036, 0.035), 16)
    ears = [plate([(-0.015, 0), (0.015, 0), (0.004, 0.06)],
                  0.006).turn(0, np.pi / 2).turn(1, s * 0.6).move(s * 0.03, 0.006, 0.085)
            for s in (-1, 1)]  # fmt: skip
    eyes = [ball(0.028, 0.012, 0.028, (s * 0.017, -0.04, 0.08), 14) for s in (-1, 1)]
    pupils = [ball(0.014, 0.008, 0.014, (s * 0.017, -0.0455, 0.08), 10) for s in (-1, 1)]
    beak = ball(0.022, 0.024, 0.016, (0, -0.048, 0.06), 12)
    feet = [ball(0.036, 0.046, 0.018, (s * 0.022, -0.034, 0.008), 12) for s in (-1, 1)]
    return [(body, fur), (belly, dye(look, "white", "cream")),
            (join(feet), dye(look, "yellow", "white")), (join(ears), fur), (join(eyes), WHITE),
            (join(pupils), MR_POTATO_HEAD_BLACK),
            (beak, surfaces.plain((246, 196, 60)))]  # fmt: skip


BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "lime")


@category("toy_robot", size=(0.083, 0.048, 0.143), mass=0.16, material="plastic", aliases=("robot",
          "action figure", "toy figure", "figure", "robot kit", "wind-up toy", "wind up toy",
          "star wars figure", "kinder toy", "cereal toy"), themes=("toys", "craft"),
          roles=("tall",), colors=("silver", "red", "teal"), common=True)  # fmt: skip
def toy_robot(look: Look) -> Shape:
    """A tin robot with a dial on its chest."""
    color, other = look.color("silver", "red", "teal", "blue", "mustard"), look.own_color(*BRIGHT)
    trim = surfaces.speckles(look.rng, other, 4)
    dark = surfaces.plain((50, 52, 56))
    chest = prints.canvas(64, 64, color)
    prints.fill(chest, 0.15, 0.2, 0.7, 0.55, (235, 235, 225))
    prints.disc(chest, 0.35, 0.45, 0.13, (200, 60, 50))
    prints.disc(chest, 0.66, 0.45, 0.1, (60, 120, 190))
    face = prints.canvas(64, 64, color)
    for x in (0.3, 0.7):
        prints.disc(face, x, 0.38, 0.13, (250, 240, 150))
        prints.disc(face, x, 0.38, 0.06, (30, 30, 30))
    prints.fill(face, 0.25, 0.68, 0.5, 0.1, (60, 40, 40))
    w = look.between(0.05, 0.06)
    legs = [box(0.02, 0.03, 0.035).move(x=s * 0.015) for s in (-1, 1)]
    feet = [block(0.026, 0.046, 0.012, 0.004, 0.002).move(s * 0.016, -0.005) for s in (-1, 1)]
    arms = [block(0.014, 0.02, 0.045, 0.004, 0.002).move(s * (w / 2 + 0.007), 0, 0.045)
            for s in (-1, 1)]  # fmt: skip
    body = box(w, 0.036, 0.052).move(z=0.035)
    head = box(0.04, 0.034, 0.032).move(z=0.09)
    mast = cylinder(0.002, 0.018, 8).move(z=0.12)
    knob = ellipsoid(0.009, 0.009, 0.009, 10, 6).move(z=0.139)
    return shape(
        [
            (body, chest),
            (head, face),
            (join(legs), dark),
            (join(feet), trim),
            (join(arms), trim),
            (cylinder(0.011, 0.004, 14).move(z=0.0865), dark),
            (mast, dark),
            (knob, surfaces.plain(other)),
        ],
        [
            box_part(0.058, 0.046, 0.035, (0, -0.005, 0)),
            box_part(w + 0.028, 0.036, 0.052, (0, 0, 0.035)),
            box_part(0.04, 0.034, 0.035, (0, 0, 0.087)),
            box_part(0.008, 0.008, 0.021, (0, 0, 0.122)),
        ],
    )


@category("doll", size=(0.118, 0.15, 0.17), mass=0.16, material="fabric", aliases=("toy doll",
          "rag doll", "baby doll", "cloth doll", "dolly", "fabric doll", "porcelain doll",
          "elf on the shelf", "scarecrow figure", "scarecrow", "barbie", "barbie doll",
          "squeaky doll"), themes=("toys",), colors=("pink", "blue"), state="sitting")  # fmt: skip
def doll(look: Look) -> Shape:
    """A doll in a dress, sitting with its legs in front, or a rag doll with yarn hair."""
    color = look.color("red", "pink", "blue", "yellow", "lavender", "green", "teal")
    skin = surfaces.plain(
        look.pick([(244, 206, 178), (226, 176, 140), (150, 100, 70), (98, 66, 48)])
    )
    tone = look.pick([(70, 44, 30), (34, 28, 28), (206, 160, 80), (170, 80, 40)])
    hair = surfaces.scratches(look.rng, tone, tint_color(tone, 0.7), 70)
    dress = surfaces.fabric(look.rng, color, look.pick([None, (250, 248, 244)]), 20)
    gown = lathe([(0, 0), (0.05, 0), (0.047, 0.012), (0.03, 0.045), (0.021, 0.082), (0, 0.086)], 20)
    head = ball(0.052, 0.05, 0.054, (0, -0.001, 0.112), 18)
    cap = ball(0.058, 0.052, 0.05, (0, 0.006, 0.12), 18)
    locks = [ball(0.022, 0.022, 0.04, (s * 0.031, 0.002, 0.1), 10) for s in (-1, 1)]
    arms = [rod([(s * 0.018, 0, 0.076), (s * 0.037, -0.006, 0.056), (s * 0.044, -0.014, 0.036)],
                [0.009, 0.007, 0.006], 8) for s in (-1, 1)]  # fmt: skip
    hands = [ball(0.014, 0.014, 0.016, (s * 0.044, -0.015, 0.032), 8) for s in (-1, 1)]
    legs = [rod([(s * 0.017, -0.02, 0.011), (s * 0.018, -0.055, 0.01), (s * 0.019, -0.076, 0.01)],
                0.0095, 8) for s in (-1, 1)]  # fmt: skip
    shoes = [ball(0.02, 0.02, 0.026, (s * 0.019, -0.082, 0.011), 10) for s in (-1, 1)]
    eyes = [ball(0.007, 0.004, 0.008, (s * 0.01, -0.0248, 0.115), 8) for s in (-1, 1)]
    mouth = ball(0.012, 0.004, 0.004, (0, -0.0235, 0.102), 8)
    cheeks = [ball(0.009, 0.003, 0.007, (s * 0.016, -0.0212, 0.106), 8) for s in (-1, 1)]
    collar = torus(0.018, 0.005, 18, 6).move(z=0.086)
    pieces: Pieces = [(gown, dress), (join(arms), dress), (join([head, *hands, *legs]), skin),
                      (join([cap, *locks]), hair), (join(eyes), surfaces.plain((36, 44, 60))),
                      (join([mouth, *cheeks]), surfaces.plain((220, 96, 96))),
                      (collar, surfaces.plain((250, 248, 244))),
                      (join(shoes), surfaces.plain(tint_color(color, 0.55)))]  # fmt: skip
    return put_down(pieces, gown, join([*legs, *shoes]), join([head, cap]), *arms,
                   factor=look.between(1.0, 1.35))  # fmt: skip


SKIN = ((244, 206, 178), (226, 176, 140), (150, 100, 70))


@category("toy_soldier", size=(0.05, 0.04, 0.1), mass=0.03, material="plastic", aliases=("soldier",
          "tin soldier", "lead soldier", "army man", "plastic soldier", "soldier figure",
          "painted miniature", "miniature", "wargaming miniature", "gaming miniature",
          "warhammer figure", "wargame miniature", "warhammer miniature"), themes=("toys",),
          roles=("tall",), colors=("red", "blue"))  # fmt: skip
def toy_soldier(look: Look) -> Shape:
    """A toy soldier at attention on a base, with a tall hat and a rifle at his side."""
    color = look.color("red", "blue", "green", "navy", "olive")
    coat = surfaces.speckles(look.rng, color, 4)
    plain = look.chance(0.3)  # a figure cast in one colour
    skin = coat if plain else surfaces.plain(look.pick(SKIN))
    dark = coat if plain else surfaces.plain((36, 36, 40))
    pale = coat if plain else surfaces.plain((244, 242, 236))
    base = cylinder(0.02, 0.004, 22)
    legs = [straight((s * 0.0065, 0, 0.003), (s * 0.006, 0, 0.036), 0.0058, 10) for s in (-1, 1)]
    chest = lathe([(0, 0.033), (0.012, 0.033), (0.0115, 0.045), (0.0145, 0.063), (0.006, 0.069),
                   (0, 0.07)], 18).scale(1, 0.75, 1)  # fmt: skip
    arms = [straight((s * 0.0145, 0, 0.063), (s * 0.016, -0.003, 0.04), 0.004, 8) for s in (-1, 1)]
    head = ball(0.016, 0.016, 0.018, (0, 0, 0.076), 14)
    hat = cylinder(0.0088, 0.022, 16, top=0.0095, bevel=0.001).move(z=0.08)
    belts = [box(0.004, 0.0008, 0.036).turn(1, s * 0.5).move(s * 0.009, -0.0105, 0.034)
             for s in (-1, 1)]  # fmt: skip
    gun = straight((0.02, -0.004, 0.02), (0.02, -0.004, 0.092), 0.0018, 6)
    pieces: Pieces = [(base, surfaces.plain((70, 110, 60)) if not plain else coat),
                      (join(legs), surfaces.plain((60, 64, 90)) if not plain else coat),
                      (join([chest, *arms]), coat), (head, skin), (join([hat, gun]), dark),
                      (join(belts), pale)]  # fmt: skip
    return put_down(pieces, base, join([*legs, chest]), join([head, hat]), join([*arms, gun]),
                   factor=look.between(0.85, 1.15))  # fmt: skip


@category("puppet", size=(0.175, 0.106, 0.24), mass=0.12, material="fabric",
          aliases=("hand puppet", "glove puppet", "marionette", "finger puppet"), themes=("toys",),
          roles=("tall",), colors=("red", "green"))  # fmt: skip
def puppet(look: Look) -> Shape:
    """A hand puppet standing on the hem of its gown with outstretched arms."""
    color = look.color("red", "green", "blue", "purple", "orange", "yellow")
    cloth = surfaces.fabric(look.rng, color, look.pick([None, tint_color(color, 1.5)]), 24)
    skin = surfaces.plain(look.pick(SKIN))
    gown = lathe([(0, 0), (0.05, 0), (0.052, 0.006), (0.034, 0.07), (0.024, 0.13), (0, 0.135)], 22)
    arms = [rod([(s * 0.02, 0, 0.118), (s * 0.048, -0.004, 0.116), (s * 0.07, -0.008, 0.126)],
                [0.012, 0.013, 0.012], 10) for s in (-1, 1)]  # fmt: skip
    hands = [ball(0.024, 0.022, 0.026, (s * 0.076, -0.009, 0.13), 10) for s in (-1, 1)]
    head = ball(0.062, 0.06, 0.066, (0, 0, 0.165), 18)
    nose = ball(0.016, 0.022, 0.016, (0, -0.034, 0.163), 10)
    hat = cylinder(0.031, 0.05, 20, top=0.002).turn(0, 0.12).move(0, 0.002, 0.182)
    tip = ball(0.014, 0.014, 0.014, (0, -0.004, 0.232), 8)
    eyes = [ball(0.009, 0.005, 0.01, (s * 0.013, -0.0285, 0.173), 8) for s in (-1, 1)]
    mouth = ball(0.022, 0.006, 0.006, (0, -0.0272, 0.15), 10)
    buttons = [ball(0.009, 0.006, 0.009, (0, -0.031 - 0.008 * n, 0.09 - 0.03 * n), 8)
               for n in range(2)]  # fmt: skip
    other = surfaces.plain(look.own_color("yellow", "white", "teal", "red"))
    pieces: Pieces = [(join([gown, *arms]), cloth), (join([head, *hands]), skin),
                      (join([nose, mouth]), surfaces.plain((214, 60, 56))), (hat, other),
                      (join([tip, *buttons]), surfaces.plain((250, 246, 236))),
                      (join(eyes), surfaces.plain((34, 32, 34)))]  # fmt: skip
    return put_down(pieces, gown, *arms, join([head, hat]), factor=look.between(0.9, 1.1))


def _figure(big: float) -> dict[str, list[Solid]]:
    """Return the parts of a standing figure by name; ``big`` is the width of its head."""
    legs = [drum(0.0125, 0.036, (s * 0.0145, 0, 0.006), top=0.014) for s in (-1, 1)]
    feet = [ball(0.026, 0.038, 0.02, (s * 0.0145, -0.005, 0.008), 12) for s in (-1, 1)]
    trunk = [block(0.054, 0.036, 0.045, 0.014, 0.006).move(z=0.036)]
    arms = [rod([(s * 0.024, 0, 0.072), (s * 0.04, -0.004, 0.056), (s * 0.038, -0.018, 0.044)],
                0.0095, 10) for s in (-1, 1)]  # fmt: skip
    hands = [ball(0.02, 0.02, 0.02, (s * 0.038, -0.02, 0.042), 10) for s in (-1, 1)]
    head = [ball(big, 0.92 * big, 0.94 * big, (0, 0, 0.076 + 0.4 * big), 18)]
    return {"legs": legs, "feet": feet, "trunk": trunk, "arms": arms, "hands": hands, "head": head}


@category("astronaut", size=(0.102, 0.0683, 0.124), mass=0.06, material="plastic",
          aliases=("astronaut figure", "toy astronaut", "spaceman", "cosmonaut",
          "astronaut figurine"), themes=("toys",), colors=("white",))  # fmt: skip
def astronaut(look: Look) -> Shape:
    """An astronaut in a white suit with a backpack, a round helmet and a gold visor."""
    color = look.color("white", "white", "orange", "sky", "silver")
    k = look.between(0.85, 1.2)
    f = _figure(0.052)
    visor = ball(0.04, 0.03, 0.03, (0, -0.0115, 0.097), 16)
    rim = torus(0.018, 0.003, 22, 6).scale(1.1, 0.85, 1).turn(0, np.pi / 2).move(0, -0.0185, 0.097)
    pack = block(0.046, 0.022, 0.046, 0.006, 0.004).move(0, 0.026, 0.04)
    panel = at_box(0.022, 0.004, 0.016, (0, -0.0175, 0.055))
    dots = [at_box(0.004, 0.005, 0.004, (0.006 * n, -0.018, 0.061)) for n in (-1, 0, 1)]
    badge = at_box(0.01, 0.004, 0.007, (0.016, -0.0172, 0.072))
    suit = surfaces.speckles(look.rng, color, 3)
    body = [*f["legs"], *f["trunk"], *f["arms"], *f["head"]]
    return put_down([(join([*body, rim]), suit), (join([*f["feet"], *f["hands"], pack]),
                                                  plain(tint_color(color, 0.72))),
                     (visor, plain(look.pick([(210, 160, 60), (60, 70, 90), (120, 150, 180)]))),
                     (panel, plain((90, 96, 106))), (join([*dots, badge]), plain((206, 60, 54)))],
                    join([*f["legs"], *f["feet"]]), f["trunk"][0], f["head"][0], pack, *f["arms"],
                    factor=k, foot=0.2)  # fmt: skip


@category("alien", size=(0.106, 0.0613, 0.157), mass=0.05, material="plastic",
          aliases=("alien figure", "toy alien", "martian", "alien toy"), themes=("toys",),
          colors=("green",))  # fmt: skip
def alien(look: Look) -> Shape:
    """A small alien with a big head, black eyes and antennae."""
    color = look.color("green", "lime", "teal", "purple", "gray")
    k = look.between(0.85, 1.2)
    f = _figure(0.062)
    head = f["head"][0].bend(lambda p: (p * np.column_stack([1 + 5 * np.clip(p[:, 2] - 0.1, -0.02,
                                                                             0.03), np.ones(len(p)),
                                                             np.ones(len(p))])))  # fmt: skip
    eyes = [ball(0.018, 0.01, 0.026, (0, 0, 0), 12).turn(1, s * 0.4).move(s * 0.0135, -0.024, 0.101)
            for s in (-1, 1)]  # fmt: skip
    feelers = [rod([(s * 0.01, 0, 0.125), (s * 0.02, 0, 0.143)], 0.0016, 6) for s in (-1, 1)]
    tips = [ball(0.008, 0.008, 0.008, (s * 0.02, 0, 0.144), 8) for s in (-1, 1)]
    suit = look.own_color("silver", "purple", "navy", "red")
    skin = surfaces.speckles(look.rng, color, 6)
    return put_down([(join([head, *f["hands"], *f["feet"], *feelers]), skin),
                     (join([*f["legs"], *f["trunk"], *f["arms"]]), plain(suit)),
                     (join(eyes), plain((22, 22, 26))), (join(tips), plain((244, 206, 62)))],
                    join([*f["legs"], *f["feet"]]), f["trunk"][0], head, *f["arms"], factor=k,
                    foot=0.2)  # fmt: skip
