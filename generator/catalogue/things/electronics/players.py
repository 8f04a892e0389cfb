"""What plays sound and pictures: turntables, radios, projectors."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import facing
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look
from .media import DARK, grooves


def record_player(look: Look) -> Shape:
    """A turntable: plinth, platter with a record, tone arm, knobs."""
    k = look.between(0.9, 1.02)
    x, y, h = 0.4 * k, 0.33 * k, 0.06 * k
    color = look.color("wooden", "black", "brown", "white", "red", "teal")
    body = block(x, y, h, 0.012, 0.003).move(z=0.012)
    feet = [cylinder(0.018, 0.013, 14).move(s * 0.42 * x, t * 0.4 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    top = h + 0.012
    r = 0.142 * k
    at = (-0.055 * k, 0.0)
    platter = cylinder(r, 0.012, 44).move(*at, top - 0.001)
    tile = grooves(look, (26, 26, 28))
    record = prism(ellipse(1.94 * r, 1.94 * r, 44), 0, 0.002).move(*at, top + 0.0108)
    base = cylinder(0.022 * k, 0.03 * k, 20).move(0.15 * k, 0.11 * k, top - 0.001)
    arm = tube([(0.15 * k, 0.13 * k, top + 0.03 * k), (0.15 * k, -0.01 * k, top + 0.03 * k),
                (0.125 * k, -0.055 * k, top + 0.022 * k), (0.06 * k, -0.085 * k, top + 0.017)],
               0.0032 * k, 8)  # fmt: skip
    head = box(0.016 * k, 0.028 * k, 0.008).turn(2, -1.1).move(0.055 * k, -0.087 * k, top + 0.013)
    knobs = [cylinder(0.011 * k, 0.012, 18).move(0.15 * k + s * 0.018 * k, -0.135 * k, top - 0.001)
             for s in (-1, 1)]  # fmt: skip
    pin = cylinder(0.003, 0.01, 10).move(*at, top + 0.011)
    silver = textures.brushed_metal(look.rng, (196, 198, 202))
    return shape([(body, look.surface(color, "wood")), (join(feet), textures.plain(DARK)),
                  (platter, silver), (record, tile), (join([base, arm, *knobs, pin]), silver),
                  (head, textures.plain(DARK))],
                 [box_part(x, y, top), cylinder_part(r, 0.0128, (*at, top)), hull_of(base),
                  *(hull_of(s) for s in knobs)])  # fmt: skip


def radio(look: Look) -> Shape:
    """A portable radio standing: grille, dial, knobs, handle, aerial."""
    k = look.between(0.88, 1.1)
    x, y, h = 0.22 * k, 0.07 * k, 0.125 * k
    color = look.color("wooden", "red", "teal", "cream", "black", "mint", "blue", "brown")
    body = block(x, y, h, 0.012, 0.006)
    image = prints.canvas(192, 108, tint_color(color, 0.92))
    dots = textures.fit(prints.mesh_holes(tint_color(color, 1.25), (36, 34, 34), 12, 12), 80, 92)
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
    silver = textures.brushed_metal(look.rng, (200, 200, 202))
    return shape([(body, look.surface(color, "plastic")), (front, image), (join(knobs), silver),
                  (join([aerial, tip]), silver), (bow, textures.plain(tint_color(color, 0.5)))],
                 [box_part(x, y, h), hull_of(bow), hull_of(*knobs), hull_of(aerial)])  # fmt: skip


def boombox(look: Look) -> Shape:
    """A boombox standing: two round speakers, a tape deck, a handle."""
    k = look.between(0.85, 1.0)
    x, y, h = 0.36 * k, 0.11 * k, 0.19 * k
    color = look.color("silver", "black", "red", "gray", "blue", "pink")
    image = prints.canvas(240, 128, color)
    for u in (0.2, 0.8):
        prints.disc(image, u, 0.58, 0.36, (26, 26, 28))
        prints.disc(image, u, 0.58, 0.32, (70, 70, 74))
        prints.disc(image, u, 0.58, 0.29, (40, 40, 44))
        prints.disc(image, u, 0.58, 0.12, (96, 96, 100))
    prints.fill(image, 0.38, 0.42, 0.24, 0.42, (40, 40, 44))
    prints.fill(image, 0.41, 0.5, 0.18, 0.22, (150, 170, 170))
    for u in (0.45, 0.55):
        prints.disc(image, u, 0.61, 0.05, (236, 236, 232))
    prints.fill(image, 0.05, 0.06, 0.9, 0.1, (30, 30, 32))
    prints.fill(image, 0.3, 0.08, 0.4, 0.06, (240, 220, 150))
    for n in range(6):
        prints.fill(image, 0.38 + 0.041 * n, 0.3, 0.034, 0.07, (200, 202, 206))
    front = box(0.98 * x, 0.0012, 0.97 * h).move(y=-y / 2 - 0.0002, z=0.012 * h)
    bow = tube(np.array([(-0.42 * x, 0, 0.97 * h), (-0.41 * x, 0, 1.25 * h),
        (0.41 * x, 0, 1.25 * h),
                         (0.42 * x, 0, 0.97 * h)]), 0.006 * k, 8)  # fmt: skip
    return shape([(block(x, y, h, 0.01, 0.004), look.surface(color, "plastic")), (front, image),
                  (bow, textures.plain((40, 40, 44)))], [box_part(x, y, h),
                      hull_of(bow)])  # fmt: skip


def clock_radio(look: Look) -> Shape:
    """A radio alarm clock with large lit figures."""
    k = look.between(0.9, 1.1)
    x, y, h = 0.17 * k, 0.09 * k, 0.06 * k
    color = look.color("black", "charcoal", "white", "wooden", "gray", "cream")
    image = prints.canvas(160, 56, (18, 16, 18))
    light = look.own_color("red", "lime", "cyan", "orange", "red")
    hour, minute = int(look.rng.integers(1, 13)), int(look.rng.integers(60))
    prints.write(image, f"{hour}:{minute:02d}", 0.5, 0.5, 0.62, light, bold=True)
    body = block(x, y, h, 0.012, 0.004)
    front = box(0.9 * x, 0.0012, 0.74 * h).move(y=-y / 2 - 0.0002, z=0.13 * h)
    dots = textures.fit(prints.mesh_holes(color, tint_color(color, 0.4), 6, 12), 64, 128)
    grille = box(0.6 * x, 0.35 * y, 0.0008).move(y=0.2 * y, z=h - 0.0003)
    bar = block(0.5 * x, 0.2 * y, 0.005, 0.004, 0.001).move(y=-0.2 * y, z=h - 0.001)
    return shape([(body, look.surface(color, "plastic")), (front, image), (grille, dots),
                  (bar, textures.plain(tint_color(color, 0.7)))],
                 [box_part(x, y, h), hull_of(bar)])  # fmt: skip


def smart_speaker(look: Look) -> Shape:
    """A smart speaker: a fabric drum or dome with a ring of light on top."""
    k = look.between(0.88, 1.12)
    color = look.color("charcoal", "gray", "white", "blue", "sage", "pink", "black")
    cloth = textures.fabric(look.rng, color)
    r, h = 0.05 * k, look.pick([0.06, 0.1, 0.14]) * k
    body = lathe([(0, 0), (0.86 * r, 0), (r, 0.18 * h), (r, 0.8 * h), (0.9 * r, 0.97 * h),
                  (0.82 * r, h), (0, h)], 32)  # fmt: skip
    plate = cylinder(0.8 * r, 0.002, 32).move(z=h - 0.001)
    ring = torus(0.7 * r, 0.0022, 32, 6).move(z=h + 0.0008)
    signs = [box(0.3 * r, 0.05 * r, 0.0008).move(x=s * 0.35 * r, z=h + 0.0008) for s in (-1, 1)]
    signs.append(box(0.05 * r, 0.3 * r, 0.0008).move(x=0.35 * r, z=h + 0.0008))
    light = look.own_color("cyan", "blue", "lime", "orange")
    dark = tint_color(color, 0.55) if sum(color) < 500 else tint_color(color, 0.9)
    return shape([(body, cloth), (plate, textures.plain(dark)), (ring, textures.plain(light)),
                  (join(signs), textures.plain(readable_on(dark)))],
                 [hull_of(body)])  # fmt: skip


def projector(look: Look) -> Shape:
    """A small video projector: lens at the front, vents, buttons."""
    k = look.between(0.88, 1.08)
    x, y, h = 0.23 * k, 0.19 * k, 0.085 * k
    color = look.color("white", "white", "black", "gray", "charcoal")
    body = block(x, y, h - 0.008, 0.02, 0.006).move(z=0.008)
    feet = [cylinder(0.011, 0.009, 12).move(s * 0.38 * x, t * 0.36 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    at = (0.22 * x, -y / 2, 0.52 * h)
    barrel = facing(lathe([(0, 0), (0.034 * k, 0), (0.034 * k, 0.016 * k), (0.029 * k, 0.016 * k),
                           (0.026 * k, 0.01 * k), (0, 0.008 * k)], 30)).move(*at)  # fmt: skip
    glass = facing(lathe([(0, 0), (0.025 * k, 0.004), (0.014 * k, 0.011 * k), (0, 0.0135 * k)],
                         26)).move(*at)  # fmt: skip
    vent = prints.canvas(96, 40, color)
    for n in range(9):
        prints.fill(vent, 0.08 + 0.1 * n, 0.1, 0.05, 0.8, tint_color(color, 0.35))
    vents = box(0.38 * x, 0.0014, 0.42 * h).move(x=-0.22 * x, y=-y / 2, z=0.3 * h)
    knobs = [cylinder(0.008 * k, 0.003, 16).move((-0.06 + 0.03 * n) * k, 0.03 * k, h - 0.001)
             for n in range(4)]  # fmt: skip
    ring = torus(0.028 * k, 0.003, 26, 6).move(0.22 * x, -0.24 * y, h - 0.0005)
    return shape([(body, look.surface(color, "plastic")), (join(feet), textures.plain(DARK)),
                  (barrel, textures.plain((46, 46, 50))), (vents, vent),
                  (glass, textures.gradient((40, 50, 90), (120, 160, 220), look.rng)),
                  (join([*knobs, ring]), textures.plain(tint_color(color, 0.6)))],
                 [box_part(x, y, h), hull_of(barrel)])  # fmt: skip


def retro_television(look: Look) -> Shape:
    """A small old television: a deep case, a bulging screen, knobs, an aerial."""
    k = look.between(0.85, 1.05)
    x, y, h = 0.3 * k, 0.2 * k, 0.23 * k
    color = look.color("wooden", "red", "brown", "cream", "black", "teal", "orange")
    body = block(x, y, h - 0.015, 0.014, 0.006).move(z=0.015)
    feet = [cylinder(0.01, 0.018, 12, top=0.013).move(s * 0.38 * x, t * 0.34 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    shown = prints.landscape(look.rng, 128, 104) if look.chance(0.6) else textures.stripes(
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
    silver = textures.brushed_metal(look.rng, (200, 200, 204))
    return shape([(body, look.surface(color, "wood")), (face,
        textures.plain(tint_color(color, 0.7))),
                  (frame, textures.plain((50, 48, 50))), (screen, shown), (join(knobs), silver),
                  (join([*slots, *feet, knob]), textures.plain(DARK)), (join(horns), silver)],
                 [box_part(x, y, h), *(hull_of(s) for s in (*horns, *knobs))])  # fmt: skip


def _round_box(x: float, y: float) -> np.ndarray:
    a = np.linspace(0, 2 * np.pi, 32, endpoint=False)
    c, s = np.cos(a), np.sin(a)
    return np.column_stack([np.sign(c) * np.abs(c) ** 0.45 * x / 2,
                            np.sign(s) * np.abs(s) ** 0.45 * y / 2])  # fmt: skip


CATEGORIES = (
    Category("record_player", record_player, (0.385, 0.317, 0.1), 4.0, ("turntable",
             "vinyl player", "vinyl turntable"), ("music",), ("big",),
             ("wooden", "black")),
    Category("radio", radio, (0.245, 0.082, 0.239), 0.8, ("portable radio", "transistor radio",
             "retro radio", "old radio", "vintage radio", "fm radio", "tabletop radio",
             "dictaphone", "pager", "baby monitor"),
             ("living",), ("tall", "big"), ("wooden", "red")),
    Category("boombox", boombox, (0.333, 0.106, 0.223), 2.2, ("ghetto blaster", "cassette player",
             "tape recorder", "stereo", "tape player", "cassette recorder",
             "cd player"), ("music",), ("big",),
             ("silver",)),
    Category("clock_radio", clock_radio, (0.17, 0.0905, 0.064), 0.4, ("radio alarm clock",
             "digital clock", "digital alarm clock", "radio clock", "led clock"), ("bedroom",), (),
             ("black",)),
    Category("smart_speaker", smart_speaker, (0.1, 0.1, 0.1), 0.5, ("voice assistant",
             "smart home speaker", "echo dot", "alexa", "google home", "home assistant"),
             ("living",), ("round",), ("charcoal", "gray")),
    Category("projector", projector, (0.225, 0.201, 0.085), 2.0, ("video projector", "beamer",
             "mini projector", "data projector", "film projector", "fog machine",
             "smoke machine", "slide viewer"), ("office",),
             ("big",),
             ("white",)),
    Category("retro_television", retro_television, (0.285, 0.197, 0.329), 3.0,
        ("old television", "retro tv",
             "old tv", "crt tv", "vintage tv", "crt television", "vintage television"),
                 ("living",), ("big", "screen"),
             ("wooden",)),
)  # fmt: skip
"""The module's categories."""
