"""Objects of the ``living`` theme: electronics."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, DARK, dye, plastic, shine, steel
from ...kit.outlines import ellipse, smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_block, at_box, ball, disc, drum, facing, lies, rod, standing
from ...kit.prints import word_plate
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...kit.surfaces import RGB, Look, plain, readable_on, tint_color
from .cleaners import STEEL


@category("humidifier", size=(0.117, 0.117, 0.18), mass=0.5, material="device",
          aliases=("mist diffuser", "scent diffuser", "essential oil diffuser", "air purifier",
          "diffuser", "dehumidifier"), themes=("living",), colors=("white",))  # fmt: skip
@from_pieces(bodies=2)
def humidifier(look: Look) -> Pieces:
    """A rounded, drop-shaped diffuser or humidifier with a seam and a wisp of mist."""
    color = look.color("white", "wooden", "cream", "sky", "sage")
    low = standing((0.05, 0), (0.056, 0.01), (0.058, 0.05))
    high = standing((0.058, 0.052), (0.05, 0.09), (0.026, 0.125), (0.012, 0.135))
    ring = standing((0.0585, 0.046), (0.0585, 0.054))
    mist = [ball(0.016 + 0.006 * k, 0.014 + 0.005 * k, 0.02, (0.006 * (-1) ** k, 0, 0.142 + 0.013
                                                              * k), 10)
            for k in range(3)]  # fmt: skip
    return [(low, look.surface(color, "plastic")), (high, dye(look, "white", "cream")),
            (ring, dye(look, "gray", "gold")),
            (join(mist), surfaces.plain((236, 240, 244)))]  # fmt: skip


GAME_CONSOLE_DARK: RGB = (32, 32, 35)


@category("game_console", size=(0.27, 0.22, 0.0565), mass=2.8, material="device",
          aliases=("gaming console", "video game console", "console", "playstation", "xbox",
          "home console"), themes=("living",), roles=("big",),
          colors=("black", "white"))  # fmt: skip
def game_console(look: Look) -> Shape:
    """A home game console lying flat: a low box with a disc slot, a light and buttons."""
    k = look.between(0.85, 1.02)
    x, y, h = 0.28 * k, 0.23 * k, 0.06 * k
    color = look.color("black", "white", "charcoal", "gray", "black", "red")
    body = block(x, y, 0.45 * h, 0.008, 0.003)
    upper = block(1.03 * x, 1.03 * y, 0.45 * h, 0.008, 0.003).move(z=0.55 * h)
    gap = box(0.98 * x, 0.98 * y, 0.12 * h).move(z=0.44 * h)
    slot = box(0.42 * x, 0.002, 0.004).move(x=-0.2 * x, y=-0.515 * y, z=0.78 * h)
    light = box(0.9 * x, 0.002, 0.0025).move(y=-0.492 * y, z=0.49 * h)
    ports = [
        box(0.014, 0.002, 0.007).move((0.2 + 0.1 * n) * x, -0.515 * y, 0.72 * h) for n in (0, 1)
    ]
    vents = [box(0.004, 0.3 * y, 0.001).move((0.2 + 0.035 * n) * x, 0.25 * y, h - 0.0004)
             for n in range(7)]  # fmt: skip
    mark = prism(ellipse(0.04 * k, 0.04 * k, 24), h - 0.0003, h + 0.0006).move(x=-0.3 * x)
    glow = look.own_color("blue", "lime", "cyan", "white", "red")
    return shape([(join([body, upper]), look.surface(color, "plastic")),
                  (join([gap, slot, *ports, *vents]), surfaces.plain(GAME_CONSOLE_DARK)),
                  (light, surfaces.plain(glow)), (mark, surfaces.plain(tint_color(color, 0.6)
                      if sum(
                      color) > 300 else (120, 122, 128)))],
                 [hull_of(body), hull_of(upper), hull_of(gap)])  # fmt: skip


@category("television", size=(0.47, 0.15, 0.302), mass=3.0, material="device", aliases=("tv",
          "flat screen tv", "smart tv", "flatscreen", "tv set", "television set", "flat screen",
          "small tv"), themes=("living",), roles=("big", "tall", "screen"),
          colors=("black",))  # fmt: skip
def television(look: Look) -> Shape:
    """A small flat television on two feet, showing a picture."""
    k = look.between(0.85, 1.0)
    x, h, t = 0.5 * k, 0.29 * k, 0.03
    color = look.color("black", "black", "charcoal", "white", "silver")
    kind = look.chance(0.6)
    shown = prints.landscape(look.rng, 192, 108) if kind else prints.artwork(look.rng, 192, 108)
    lift = 0.035 * k
    case = block(x, t, h, 0.004, 0.002).move(z=lift)
    screen = box(0.965 * x, 0.0014, 0.93 * h).move(y=-t / 2, z=lift + 0.045 * h)
    feet = [join([tube([(s * 0.36 * x, 0, lift + 0.004), (s * 0.4 * x, f * 0.075 * k, 0.004)],
                       0.005, 8) for f in (-1, 1)]) for s in (-1, 1)]  # fmt: skip
    bars = [box(0.014, 0.16 * k, 0.005).move(x=s * 0.4 * x) for s in (-1, 1)]
    dot = box(0.012, 0.002, 0.002).move(y=-t / 2, z=lift + 0.02 * h)
    return shape([(case, look.surface(color, "plastic")), (screen, shown),
                  (join([*feet, *bars]), surfaces.plain(tint_color(color, 0.7))),
                  (dot, surfaces.plain((210, 60, 50)))],
                 [hull_of(case), *(hull_of(s) for s in bars),
                     *(hull_of(f) for f in feet)])  # fmt: skip


def _text_page(look: Look) -> surfaces.Tile:
    image = prints.canvas(128, 176, (222, 222, 214))
    prints.write(
        image, look.pick(["CHAPTER 1", "CHAPTER 7", "PART TWO"]), 0.5, 0.12, 0.06, (40, 40, 40)
    )
    prints.lines(image, look.rng, (0.1, 0.22, 0.8, 0.68), 17, (84, 84, 84), 0.35)
    return image


@category("e_reader", size=(0.119, 0.1667, 0.0088), mass=0.19, material="device",
          aliases=("ereader", "e-reader", "ebook reader", "kindle", "e-book", "e-book reader",
          "ebook", "e reader"), themes=("living",), roles=("flat", "screen"),
          colors=("black",))  # fmt: skip
def e_reader(look: Look) -> Shape:
    """An e-reader lying flat, showing a page of text."""
    k = look.between(0.94, 1.08)
    x, y, h = 0.118 * k, 0.165 * k, 0.0085
    color = look.color("black", "black", "white", "charcoal", "navy")
    screen = box(0.82 * x, 0.8 * y, 0.0005).move(y=0.03 * y, z=h - 0.0002)
    knob = block(0.014, 0.007, 0.0008, 0.003).move(y=-0.44 * y, z=h - 0.0003)
    return shape([(block(x, y, h, 0.01, 0.002), look.surface(color, "plastic")),
                  (screen, _text_page(look)), (knob, surfaces.plain((110, 110, 114)))],
                 [box_part(x, y, h)])  # fmt: skip


@category("remote_control", size=(0.046, 0.172, 0.019), mass=0.1, material="device",
          aliases=("remote", "tv remote", "remote controller"), themes=("living",), roles=("flat",),
          colors=("black",), state="lying flat", common=True)  # fmt: skip
def remote_control(look: Look) -> Shape:
    """A television remote control that lies with its buttons up and points away from the viewer."""
    x, y, h = look.between(0.038, 0.052), look.between(0.145, 0.2), look.between(0.012, 0.021)
    color = look.color("black", "black", "charcoal", "white", "gray", "silver", "navy", "beige")
    body = block(x, y, h, look.pick([0.004, 0.012, 0.018]), 0.004)
    pad, rows, low = look.pick([0.16, 0.34]), look.pick([2, 3, 4, 5]), look.between(0.5, 0.6)
    face = prints.canvas(48, 176, color)
    ink = readable_on(color)
    prints.disc(face, 0.5, 0.06, 0.022, (206, 52, 46))
    square, caps = look.chance(0.4), look.pick([tint_color(ink, 0.8), tint_color(color, 1.35)])
    for row in range(rows):
        for k in range(3):
            at = (0.25 + 0.25 * k, pad + 0.062 * row)
            if square:
                prints.fill(face, at[0] - 0.08, at[1] - 0.016, 0.16, 0.032, caps)
            else:
                prints.disc(face, *at, 0.02, caps)
    ring = low + 0.08 if pad < 0.2 else 0.2
    prints.disc(face, 0.5, ring, 0.09, tint_color(ink, 0.6), 0.045)
    prints.disc(face, 0.5, ring, 0.03, ink)
    for k, tint in enumerate([(206, 52, 46), (70, 160, 80), (230, 190, 60), (60, 110, 200)]):
        prints.fill(face, 0.14 + 0.19 * k, 0.76, 0.14, 0.025, tint)
    return shape([(body, surfaces.plain(color)), (box(x * 0.76, y * 0.93, 0.0008).move(z=h), face)],
                 [box_part(x, y, h)])  # fmt: skip


RETRO_TELEVISION_DARK: RGB = (30, 30, 33)


@category("game_cartridge", size=(0.0635, 0.07, 0.0105), mass=0.05, material="plastic",
          aliases=("cartridge", "video game cartridge", "game card", "video game"),
          themes=("living",), roles=("flat",), colors=("gray",))  # fmt: skip
def game_cartridge(look: Look) -> Shape:
    """A game cartridge lying with its label up."""
    k = look.between(0.9, 1.15)
    color = look.color("gray", "charcoal", "black", "gold", "red", "blue")
    x, y, h = 0.062 * k, 0.068 * k, 0.0095 * k
    art = surfaces.fit(prints.artwork(look.rng, 96, 80), 80, 96).copy()
    tone = look.own_color("red", "navy", "yellow", "purple")
    prints.fill(art, 0, 0, 1, 0.3, tone)
    prints.write(art, look.pick(["RACER", "QUEST", "JUMP!", "SPACE", "NINJA"]), 0.5, 0.15, 0.2,
                 readable_on(tone), bold=True)  # fmt: skip
    grips = [box(0.6 * x, 0.0022, 0.0012).move(y=(0.45 - 0.045 * n) * y, z=h - 0.0004)
             for n in range(4)]  # fmt: skip
    return shape([(block(x, y, h, 0.003, 0.001), look.surface(color, "plastic")),
                  (box(0.78 * x, 0.6 * y, 0.0005).move(y=-0.08 * y, z=h - 0.0002), art),
                  (join(grips), surfaces.plain(tint_color(color, 0.7)))],
                 [box_part(x, y, h)])  # fmt: skip


@category("radio", size=(0.245, 0.082, 0.239), mass=0.8, material="device", assembled=True,
          aliases=("portable radio", "transistor radio", "retro radio", "old radio",
          "vintage radio", "fm radio", "tabletop radio", "dictaphone", "pager", "baby monitor"),
          themes=("living",), roles=("tall", "big"), colors=("wooden", "red"))  # fmt: skip
def radio(look: Look) -> Shape:
    """A portable radio with a grille, a dial, knobs, a handle and an aerial."""
    k = look.between(0.88, 1.1)
    x, y, h = 0.22 * k, 0.07 * k, 0.125 * k
    color = look.color("wooden", "red", "teal", "cream", "black", "mint", "blue", "brown")
    body = block(x, y, h, 0.012, 0.006)
    image = prints.canvas(192, 108, tint_color(color, 0.92))
    dots = surfaces.fit(prints.mesh_holes(tint_color(color, 1.25), (36, 34, 34), 12, 12), 80, 92)
    image[14:94, 10:102] = dots
    prints.fill(image, 0.57, 0.14, 0.38, 0.32, (244, 236, 208))
    for n in range(9):
        prints.fill(image, 0.6 + 0.04 * n, 0.2, 0.006, 0.1 if n % 2 else 0.16, (70, 60, 50))
    prints.fill(image, 0.72, 0.14, 0.01, 0.32, (206, 44, 40))
    prints.write(image[50:64, 110:184], "FM  AM", 0.5, 0.4, 0.8, readable_on(color))
    front = box(0.95 * x, 0.0012, 0.88 * h).move(y=-y / 2 - 0.0002, z=0.06 * h)
    knobs = [facing(cylinder(0.015 * k, 0.012 * k, 22, bevel=0.001)).move(
        (0.055 + 0.04 * n) * k, -y / 2, 0.28 * h) for n in (0, 1)]  # fmt: skip
    bow = tube(np.array([(-0.45 * x, 0, 0.96 * h), (-0.42 * x, 0, 1.22 * h),
        (0.42 * x, 0, 1.22 * h),
                         (0.45 * x, 0, 0.96 * h)]), 0.0045 * k, 8)  # fmt: skip
    aerial = tube(np.array([(0.4 * x, 0.3 * y, 0.97 * h), (0.62 * x, 0.3 * y, 1.9 * h)]), 0.0018, 6)
    tip = cylinder(0.0032, 0.008, 10).move(0.62 * x, 0.3 * y, 1.88 * h)
    silver = surfaces.brushed_metal(look.rng, (200, 200, 202))
    return shape([(body, look.surface(color, "plastic")), (front, image), (join(knobs), silver),
                  (join([aerial, tip]), silver), (bow, surfaces.plain(tint_color(color, 0.5)))],
                 [box_part(x, y, h), hull_of(bow), hull_of(*knobs), hull_of(aerial)])  # fmt: skip


@category("smart_speaker", size=(0.1, 0.1, 0.1), mass=0.5, material="device",
          aliases=("voice assistant", "smart home speaker", "echo dot", "alexa", "google home",
          "home assistant"), themes=("living",), roles=("round",),
          colors=("charcoal", "gray"))  # fmt: skip
def smart_speaker(look: Look) -> Shape:
    """A smart speaker: a fabric-covered drum or dome with a ring of light on top."""
    k = look.between(0.88, 1.12)
    color = look.color("charcoal", "gray", "white", "blue", "sage", "pink", "black")
    cloth = surfaces.fabric(look.rng, color)
    r, h = 0.05 * k, look.pick([0.06, 0.1, 0.14]) * k
    body = lathe([(0, 0), (0.86 * r, 0), (r, 0.18 * h), (r, 0.8 * h), (0.9 * r, 0.97 * h),
                  (0.82 * r, h), (0, h)], 32)  # fmt: skip
    plate = cylinder(0.8 * r, 0.002, 32).move(z=h - 0.001)
    ring = torus(0.7 * r, 0.0022, 32, 6).move(z=h + 0.0008)
    signs = [box(0.3 * r, 0.05 * r, 0.0008).move(x=s * 0.35 * r, z=h + 0.0008) for s in (-1, 1)]
    signs.append(box(0.05 * r, 0.3 * r, 0.0008).move(x=0.35 * r, z=h + 0.0008))
    light = look.own_color("cyan", "blue", "lime", "orange")
    dark = tint_color(color, 0.55) if sum(color) < 500 else tint_color(color, 0.9)
    return shape([(body, cloth), (plate, surfaces.plain(dark)), (ring, surfaces.plain(light)),
                  (join(signs), surfaces.plain(readable_on(dark)))],
                 [hull_of(body)])  # fmt: skip


@category("retro_television", size=(0.285, 0.197, 0.329), mass=3.0, material="device",
          aliases=("old television", "retro tv", "old tv", "crt tv", "vintage tv", "crt television",
          "vintage television"), themes=("living",), roles=("big", "screen"),
          colors=("wooden",))  # fmt: skip
def retro_television(look: Look) -> Shape:
    """A small old television with a deep case, a bulging screen, knobs and an aerial."""
    k = look.between(0.85, 1.05)
    x, y, h = 0.3 * k, 0.2 * k, 0.23 * k
    color = look.color("wooden", "red", "brown", "cream", "black", "teal", "orange")
    body = block(x, y, h - 0.015, 0.014, 0.006).move(z=0.015)
    feet = [cylinder(0.01, 0.018, 12, top=0.013).move(s * 0.38 * x, t * 0.34 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    shown = prints.landscape(look.rng, 128, 104) if look.chance(0.6) else surfaces.stripes(
        [(240, 240, 236), (230, 220, 60), (60, 200, 210), (70, 190, 80), (200, 70, 190),
         (206, 52, 50), (50, 70, 190)], 1, upright=True)  # fmt: skip
    face = box(0.95 * x, 0.0014, 0.84 * h).move(y=-y / 2, z=0.11 * h)
    frame = facing(block(0.66 * x, 0.72 * h, 0.004, 0.02)).move(
        -0.12 * x, -y / 2 + 0.0005, 0.53 * h
    )
    screen = facing(prism(_round_box(0.6 * x, 0.65 * h), 0, 0.0065, 0.002)).move(
        -0.12 * x, -y / 2, 0.53 * h)  # fmt: skip
    knobs = [facing(cylinder(0.017 * k, 0.014 * k, 20, bevel=0.002)).move(
        0.35 * x, -y / 2, (0.72 - 0.2 * n) * h) for n in (0, 1)]  # fmt: skip
    slots = [box(0.14 * x, 0.002, 0.006 * k).move(0.35 * x, -y / 2 - 0.001, (0.2 + 0.05 * n) * h)
             for n in range(4)]  # fmt: skip
    horns = [tube(np.array([(0, 0.2 * y, h - 0.002), (s * 0.3 * x, 0.2 * y, 1.5 * h)]), 0.0022, 6)
             for s in (-1, 1)]  # fmt: skip
    knob = lathe([(0, 0), (0.024 * k, 0), (0.02 * k, 0.012 * k), (0, 0.016 * k)], 18).move(
        0, 0.2 * y, h - 0.001)  # fmt: skip
    silver = surfaces.brushed_metal(look.rng, (200, 200, 204))
    return shape([(body, look.surface(color, "wood")),
                  (face, surfaces.plain(tint_color(color, 0.7))),
                  (frame, surfaces.plain((50, 48, 50))), (screen, shown), (join(knobs), silver),
                  (join([*slots, *feet, knob]), surfaces.plain(RETRO_TELEVISION_DARK)),
                  (join(horns), silver)],
                 [box_part(x, y, h), *(hull_of(s) for s in (*horns, *knobs))])  # fmt: skip


def _round_box(x: float, y: float) -> np.ndarray:
    a = np.linspace(0, 2 * np.pi, 32, endpoint=False)
    c, s = np.cos(a), np.sin(a)
    return np.column_stack([np.sign(c) * np.abs(c) ** 0.45 * x / 2,
                            np.sign(s) * np.abs(s) ** 0.45 * y / 2])  # fmt: skip


@category("megaphone", size=(0.227, 0.172, 0.167), mass=0.5, material="plastic", hollow=True,
          aliases=("loudhailer", "bullhorn", "loud hailer"), themes=("living",), roles=("big",),
          colors=("white", "red"))  # fmt: skip
def megaphone(look: Look) -> Shape:
    """A megaphone, lying on its grip."""
    color = look.color("white", "red", "yellow", "blue", "black")
    k = look.between(0.8, 1.05)
    flare = [(0.024, 0), (0.026, 0.09), (0.05, 0.16), (0.088, 0.2)]
    horn = lathe([(0, 0), *flare, *[(r - 0.004, z) for r, z in flare[::-1]][:-1], (0, 0.02)], 28)
    horn = lies(horn, -0.06, 0, 0.087)
    back = drum(0.034, 0.05, (-0.1, 0, 0.087), 0, sides=22)
    rim = torus(0.087, 0.005, 30, 6).turn(1, np.pi / 2).move(0.139, 0, 0.087)
    grip = at_box(0.03, 0.024, 0.075, (-0.055, 0, 0))
    tone = look.own_color("red", "black", "gray")
    return put_down([(horn, plain(color)), (join([back, rim]), plain(tone)), (grip, plain(DARK))],
                    horn, back, grip, factor=k)  # fmt: skip


def switch(dimmer: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a square wall switch lying face up, with a rocker or a knob."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        color = look.color("white", "white", "silver", "black", "brass", "cream")
        x = 0.086 * k
        plate = block(x, x, 0.009, 0.006, 0.002)
        box_ = block(0.7 * x, 0.7 * x, 0.004, 0.003)
        skin = look.surface(color, "plastic")
        pale = tint_color(color, 0.9)
        screws = [cylinder(0.0032, 0.0008, 12).move(s * 0.36 * x, 0, 0.0088) for s in (-1, 1)]
        if dimmer:
            knob = cylinder(0.21 * x, 0.013, 30, bevel=0.0015).move(z=0.0085)
            mark = box(0.0016, 0.13 * x, 0.0006).move(y=0.09 * x, z=0.0213)
            ring = torus(0.23 * x, 0.001, 30, 5).move(z=0.009)
        else:
            knob = block(0.26 * x, 0.46 * x, 0.006, 0.002, 0.001).turn(0, 0.16).move(z=0.0065)
            mark = box(0.012, 0.0016, 0.0005).move(y=0.15 * x, z=0.0157)
            ring = block(0.31 * x, 0.52 * x, 0.0012, 0.002).move(z=0.0084)
        return shape([(plate, skin), (join([box_, ring]), surfaces.plain(pale)),
                      (knob, surfaces.plain(tint_color(color, 0.96))),
                      (join([*screws, mark]), surfaces.plain(tint_color(color, 0.5)))],
                     [box_part(x, x, 0.009), hull_of(knob)])  # fmt: skip

    return make


@category("smoke_alarm", size=(0.112, 0.112, 0.0388), mass=0.15, material="plastic",
          aliases=("smoke detector", "fire alarm", "carbon monoxide alarm", "co alarm"),
          themes=("living",), roles=("round",), colors=("white",))  # fmt: skip
def smoke_alarm(look: Look) -> Shape:
    """A smoke alarm lying flat: a round case with slots, a test button and a lamp."""
    color = look.color("white", "cream", "white", "gray")
    k = look.between(0.85, 1.15)
    base = drum(0.055, 0.008, sides=32)
    body = standing(
        (0.053, 0), (0.053, 0.016), (0.045, 0.027), (0.03, 0.03), at=(0, 0, 0.007), sides=32
    )
    slots = [
        at_box(0.012, 0.004, 0.012, (0.0505, 0, 0.011)).turn(2, n * np.pi / 12) for n in range(24)
    ]
    button = drum(0.012, 0.003, (0, 0, 0.036), bevel=0.001)
    grille = [torus(r, 0.0012, 26, 5).move(z=0.0365) for r in (0.018, 0.024)]
    lamp = drum(0.0025, 0.002, (0.022, 0.022, 0.034))
    return put_down([(join([base, body]), plain(color)), (join(slots), plain((70, 72, 76))),
                     (join([button, *grille]), plain(tint_color(color, 0.85))),
                     (lamp, plain((230, 40, 40)))], base, body, factor=k)  # fmt: skip


@category("thermostat", size=(0.0872, 0.0872, 0.0277), mass=0.15, material="plastic",
          aliases=("thermostat dial", "room thermostat"), themes=("living",), roles=("round",),
          colors=("silver", "white"))  # fmt: skip
def thermostat(look: Look) -> Shape:
    """A round thermostat with a lit dial, lying flat."""
    color = look.color("silver", "white", "black", "copper")
    k = look.between(0.85, 1.15)
    ring = drum(0.042, 0.026, sides=36, bevel=0.003)
    face = drum(0.036, 0.0012, (0, 0, 0.0255), sides=36)
    tone = look.pick([(40, 44, 50), (230, 120, 40), (40, 100, 180)])
    image = prints.canvas(128, 128, tone)
    for n in range(22):
        a = 0.75 * np.pi + n * 1.5 * np.pi / 21
        ends = [(0.5 + r * np.cos(a), 0.5 + r * np.sin(a)) for r in (0.4, 0.47)]
        prints.stroke(image, ends, 0.014, (250, 250, 250) if n < 13 else tint_color(tone, 1.4))
    prints.write(
        image, str(int(look.rng.integers(17, 25))), 0.5, 0.5, 0.3, (250, 250, 250), bold=True
    )
    return put_down([(ring, look.surface(color, "metal")), (face, image)], ring, factor=k)


@category("doorbell", size=(0.0344, 0.0812, 0.0162), mass=0.06, material="plastic",
          aliases=("door bell", "bell push", "video doorbell"), themes=("living",),
          colors=("white", "black"))  # fmt: skip
def doorbell(look: Look) -> Shape:
    """A doorbell lying flat: an oblong plate with a lit push button."""
    color = look.color("white", "black", "gold", "silver")
    k = look.between(0.85, 1.2)
    slab = block(0.036, 0.085, 0.014, 0.012, 0.003)
    ring = torus(0.0105, 0.002, 24, 6).move(0, -0.012, 0.0142)
    button = drum(0.0095, 0.004, (0, -0.012, 0.013), bevel=0.001)
    slot = [at_box(0.016, 0.002, 0.0008, (0, 0.016 + 0.005 * n, 0.0135)) for n in range(4)]
    return put_down([(slab, look.surface(color, "plastic")), (ring, steel(look)),
                     (button, plain(look.pick([(120, 190, 240), (250, 244, 220), (240, 170, 60)]))),
                     (join(slot), plain((90, 92, 98)))], slab, factor=k)  # fmt: skip


@category("gramophone", size=(0.284, 0.272, 0.413), mass=3.0, material="metal", assembled=True,
          aliases=("phonograph", "gramophone player", "wind-up gramophone"), themes=("living",),
          roles=("big",), colors=("brown",))  # fmt: skip
def gramophone(look: Look) -> Shape:
    """A gramophone: a wooden box with a record on its turntable and a brass horn."""
    color = look.color("brown", "wooden", "maroon", "black")
    k = look.between(0.85, 1.1)
    base, top = block(0.24, 0.24, 0.012, 0.008, 0.003), block(0.215, 0.215, 0.08, 0.005, 0.004)
    slab = drum(0.092, 0.006, (0, 0, 0.088), sides=36)
    record = drum(0.088, 0.003, (0, 0, 0.094), sides=36)
    badge = drum(0.03, 0.001, (0, 0, 0.0967), sides=24)
    flare = [(0.009, 0.0), (0.012, 0.05), (0.024, 0.1), (0.052, 0.15), (0.095, 0.19),
             (0.125, 0.2)]  # fmt: skip
    inner = [(r - 0.003, z + 0.0005) for r, z in flare]
    horn = lathe([(0, 0), *flare, *inner[::-1], (0, 0.002)], 30)
    horn = horn.turn(0, 0.75).move(0, 0.07, 0.19)
    arm = rod([(0, 0.1, 0.086), (0, 0.102, 0.16), (0, 0.085, 0.2), (0, 0.06, 0.192)], 0.009, 10)
    tone = rod([(0.02, 0.095, 0.14), (0.07, 0.06, 0.13), (0.062, 0.0, 0.102)], 0.005, 8)
    head = drum(0.013, 0.012, (0.06, -0.004, 0.0985))
    crank = rod([(0.107, 0, 0.05), (0.14, 0, 0.05), (0.14, 0, 0.02), (0.165, 0, 0.02)], 0.004, 8)
    groove = prints.canvas(96, 96, (30, 30, 32))
    for r in np.arange(0.18, 0.5, 0.05):
        prints.disc(groove, 0.5, 0.5, float(r), (58, 58, 62), float(r) - 0.012)
    label = plain(look.own_color("crimson", "navy", "mustard", "green"))
    brass = steel(look, look.pick([BRASS_TONE, (206, 170, 90), (188, 116, 76)]))
    return put_down([(join([base, top.move(z=0.01)]), look.surface(color, "wood")),
                     (slab, plain((70, 96, 70))), (record, groove), (badge, label),
                     (join([horn, arm, tone, head, crank]), brass)], base, top.move(z=0.01), horn,
                    arm, factor=k)  # fmt: skip


@category("walkman", size=(0.09, 0.118, 0.0325), mass=0.25, material="device",
          aliases=("cassette walkman", "portable cassette player", "discman", "voice recorder"),
          themes=("living",), roles=("flat",), colors=("blue", "silver"),
          state="lying")  # fmt: skip
@from_pieces(bodies=1)
def walkman(look: Look) -> Pieces:
    """A personal cassette or disc player with a window, buttons and a cord to its earphones."""
    shell = plastic(look, "blue", "silver", "yellow", "red", "charcoal")
    body = at_block(0.09, 0.118, 0.03, 0.008)
    image = prints.canvas(64, 48, (32, 34, 40))
    for x in (0.3, 0.7):
        prints.disc(image, x, 0.5, 0.2, (230, 228, 220))
        prints.disc(image, x, 0.5, 0.1, (40, 40, 44))
    prints.fill(image, 0.1, 0.82, 0.8, 0.08, (214, 120, 60))
    window = at_box(0.064, 0.05, 0.0008, (0, 0.006, 0.0297))
    keys = [
        at_block(0.014, 0.008, 0.004, 0.002, (-0.03 + 0.02 * k, -0.046, 0.0285)) for k in range(4)
    ]
    label = at_box(0.05, 0.012, 0.0008, (0, 0.045, 0.0297))
    return [(body, shell), (window, image), (join(keys), dye(look, "charcoal", "silver", "orange")),
            (label, word_plate("STEREO", (36, 38, 44), (230, 230, 226), 0.6))]  # fmt: skip


@category("mp3_player", size=(0.052, 0.092, 0.0098), mass=0.06, material="device",
          aliases=("ipod", "mp3", "music player", "media player", "ipod nano", "ipod classic"),
          themes=("living",), roles=("flat",), colors=("white", "silver"),
          state="lying")  # fmt: skip
@from_pieces(bodies=1)
def mp3_player(look: Look) -> Pieces:
    """A music player lying flat: a rounded case with a screen and a round click wheel."""
    shell = plastic(look, "white", "silver", "black", "pink", "blue", "green")
    body = at_block(0.052, 0.092, 0.009, 0.007)
    face = surfaces.fit(prints.apps(look.rng), 64, 64)
    wheel = disc(0.018, 0.0008, (0, -0.02, 0.0086))
    hub = disc(0.0065, 0.001, (0, -0.02, 0.0088))
    return [(body, shell), (at_box(0.042, 0.034, 0.0006, (0, 0.023, 0.0087)), face),
            (wheel, surfaces.plain((206, 208, 212))), (hub, shell)]  # fmt: skip


@category("travel_adapter", size=(0.068, 0.05, 0.0515), mass=0.1, material="plastic",
          aliases=("plug adapter", "adapter plug", "travel plug", "universal adapter",
          "socket adapter", "smart plug", "timer switch", "travel adaptor", "plug adaptor",
          "gender changer"), themes=("living", "office"), colors=("white", "black"))  # fmt: skip
def travel_adapter(look: Look) -> Shape:
    """A travel adapter lying on its back: a cube with sockets on top and pins on one side."""
    color = look.color("white", "black", "gray", "red", "teal")
    k = look.between(0.9, 1.12)
    body = block(0.052, 0.048, 0.05, 0.008, 0.003)
    top = cylinder(0.019, 0.001, 24).move(z=0.0496)
    holes = [cylinder(0.0028, 0.0006, 12).move(s * 0.0085, 0, 0.0504) for s in (-1, 1)]
    slots = [box(0.0015, 0.007, 0.0006).move(s * 0.006, 0.01, 0.0504) for s in (-1, 1)]
    usb = [box(0.013, 0.001, 0.005).move(0, -0.0242, z) for z in (0.016, 0.028)]
    pins = [box(0.018, 0.0065, 0.0022).move(0.033, s * 0.009, 0.024) for s in (-1, 1)]
    dark = surfaces.plain((36, 36, 40) if sum(color) > 200 else (150, 150, 156))
    return put_down([(body, look.surface(color, "plastic")),
                     (top, surfaces.plain(tint_color(color, 0.85) if sum(color) > 200
                                          else (70, 70, 74))), (join([*holes, *slots, *usb]), dark),
                     (join(pins), surfaces.brushed_metal(look.rng, (206, 208, 212)))], body,
                    join(pins), factor=k)  # fmt: skip


@category("iron", size=(0.24, 0.125, 0.118), mass=1.0, material="metal",
          aliases=("steam iron", "clothes iron", "flatiron", "electric iron"), themes=("living",),
          roles=("big",), colors=("white", "blue"))  # fmt: skip
def iron(look: Look) -> Shape:
    """A clothes iron resting on its sole plate, with its tip on the left."""
    color = look.color("white", "blue", "teal", "purple", "red", "green")
    base = smooth([(-0.12, 0), (-0.08, -0.03), (-0.02, -0.05), (0.08, -0.052), (0.095, -0.04),
                   (0.095, 0.04), (0.08, 0.052), (-0.02, 0.05), (-0.08, 0.03), (-0.12, 0)],
                  2)[:-1]  # fmt: skip
    n = len(base)
    sole = prism(base, 0, 0.006)
    body = loft(np.stack([np.column_stack([base * [a, b] + [x, 0], np.full(n, z)]) for a, b, x,
                          z in ((0.95, 0.94, 0, 0.005), (0.9, 0.9, 0.002, 0.03),
                                (0.7, 0.6, 0.012, 0.055), (0.5, 0.4, 0.02, 0.062))]),
                base)  # fmt: skip
    grip = rod([(-0.055, 0, 0.05), (-0.06, 0, 0.09), (-0.02, 0, 0.112), (0.06, 0, 0.108),
                (0.085, 0, 0.07), (0.085, 0, 0.02)], 0.0125, 12)  # fmt: skip
    dial = cylinder(0.018, 0.008, 20, bevel=0.001).move(0.012, 0, 0.06)
    cord = rod([(0.085, 0, 0.1), (0.12, 0, 0.08), (0.135, 0.02, 0.02), (0.12, 0.05, 0.004),
                (0.07, 0.075, 0.004)], 0.0032, 7)  # fmt: skip
    other = surfaces.plain(tint_color(color, 0.5) if sum(color) < 600 else (70, 90, 140))
    return put_down([(sole, surfaces.brushed_metal(look.rng, STEEL)),
                     (body, look.surface(color, "plastic")), (join([grip, dial]), other),
                     (cord, surfaces.plain((60, 60, 64)))], sole, body, grip,
                    factor=look.between(0.85, 1.05))  # fmt: skip


@category("amplifier", size=(0.268, 0.159, 0.28), mass=4.0, material="device",
          aliases=("guitar amplifier", "guitar amp", "amp", "practice amp", "bass amp",
          "combo amp"), themes=("living",), roles=("big",), colors=("black",))  # fmt: skip
@from_pieces(bodies=2)
def amplifier(look: Look) -> Pieces:
    """A guitar amplifier with a cloth front, a row of knobs and a handle."""
    shell = plastic(look, "black", "cream", "brown", "charcoal", "red")
    body = at_block(0.26, 0.14, 0.24, 0.012)
    grille = surfaces.fabric(look.rng, look.own_color("charcoal", "gray", "tan", "black"),
                             look.own_color("gray", "charcoal"))  # fmt: skip
    front = at_box(0.235, 0.004, 0.165, (0, -0.071, 0.016))
    panel = at_box(0.235, 0.004, 0.036, (0, -0.071, 0.192))
    knobs = [disc(0.009, 0.012).turn(0, np.pi / 2).move(x, -0.072, 0.21)
             for x in np.linspace(-0.09, 0.06, 6)]  # fmt: skip
    lamp = ball(0.009, 0.006, 0.009, (0.095, -0.074, 0.21), 10)
    name = at_box(0.06, 0.002, 0.018, (0, -0.073, 0.155))
    handle = rod(
        [(-0.06, 0, 0.238), (-0.05, 0, 0.262), (0.05, 0, 0.262), (0.06, 0, 0.238)], 0.006, 8
    )
    return [(body, shell), (handle, dye(look, "black")), (front, grille), (panel, shine(look,
             "gold", "silver")),
            (join(knobs), dye(look, "black", "cream")), (lamp, surfaces.plain((220, 40, 36))),
            (name, word_plate("AMP", (24, 24, 26), (230, 230, 226), 0.6))]  # fmt: skip


CATEGORIES = (
    Category("light_switch", switch(False), size=(0.0856, 0.0856, 0.0162), mass=0.08,
             material="plastic",
             aliases=("wall switch", "toggle switch plate", "switch plate", "electric switch"),
             themes=("living",), roles=("flat",), colors=("white",), state="lying flat"),
    Category("dimmer_switch", switch(True), size=(0.0873, 0.0873, 0.0219), mass=0.1,
             material="plastic", aliases=("dimmer", "light dimmer", "smart thermostat"),
             themes=("living",), roles=("flat",), colors=("white",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
