"""Electronics around a desk: consoles, screens, hubs, supplies, stands, drones."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.forms import facing, lay_down
from ...build.outlines import ellipse, rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK: RGB = (32, 32, 35)
STEEL: RGB = (196, 198, 202)


def game_console(look: Look) -> Shape:
    """A home game console lying: a low box with a disc slot, light and buttons."""
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
                  (join([gap, slot, *ports, *vents]), textures.plain(DARK)),
                  (light, textures.plain(glow)), (mark, textures.plain(tint_color(color, 0.6)
                      if sum(
                      color) > 300 else (120, 122, 128)))],
                 [hull_of(body), hull_of(upper), hull_of(gap)])  # fmt: skip


def television(look: Look) -> Shape:
    """A small flat television on two feet, a picture on it."""
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
                  (join([*feet, *bars]), textures.plain(tint_color(color, 0.7))),
                  (dot, textures.plain((210, 60, 50)))],
                 [hull_of(case), *(hull_of(s) for s in bars),
                     *(hull_of(f) for f in feet)])  # fmt: skip


def drone(look: Look) -> Shape:
    """A quadcopter standing on its feet: body, four arms with rotors, camera."""
    k = look.between(0.88, 1.08)
    color = look.color("white", "gray", "black", "charcoal", "orange", "red")
    tile = look.surface(color, "plastic")
    z = 0.034 * k
    body = ellipsoid(0.1, 0.075, 0.045, 24, 12).scale(k, k, k).move(z=z + 0.006 * k)
    arms, rotors, parts = [], [], []
    for s in (-1, 1):
        for t in (-1, 1):
            end = (s * 0.085 * k, t * 0.085 * k, z + 0.008 * k)
            arms.append(tube([(s * 0.025 * k, t * 0.02 * k, z + 0.005 * k), end], 0.0062 * k, 8))
            arms.append(cylinder(0.011 * k, 0.026 * k, 18).move(*end[:2], z))
            arms.append(tube([(*end[:2], z + 0.002), (s * 0.09 * k, t * 0.09 * k, 0.0035 * k)],
                             0.0035 * k, 8))  # fmt: skip
            turn = look.between(0, 3)
            blade = prism(rectangle(0.105 * k, 0.012 * k, 0.006 * k, 4), 0, 0.0016)
            rotors.append(blade.turn(2, turn).move(*end[:2], z + 0.027 * k))
            parts += [hull_of(a) for a in arms[-3:]]
            parts.append(hull_of(rotors[-1]))
    low = min(float(a.bounds[0, 2]) for a in arms)
    eye = [ellipsoid(0.026, 0.026, 0.026, 16, 10).scale(k, k, k).move(0, -0.034 * k, z - 0.008 * k)]
    lens = facing(cylinder(0.0065 * k, 0.004 * k, 16)).move(0, -0.0445 * k, z - 0.008 * k)
    stripe = block(0.03 * k, 0.04 * k, 0.003, 0.006).move(z=z + 0.0272 * k)
    parts = [p.__class__(p.vertices - [0, 0, low], p.kind, p.axis) for p in parts]
    drawn = [(join([body, *arms]), tile), (join(rotors), textures.plain(DARK)),
             (join(eye), textures.plain((60, 62, 66))), (lens, textures.plain((20, 22, 40))),
             (stripe, textures.plain(look.own_color("red", "cyan", "charcoal",
                 "orange")))]  # fmt: skip
    moved = [(s.move(z=-low), t) for s, t in drawn]
    return shape(moved, [hull_of(moved[0][0].__class__(body.vertices - [0, 0, low], body.faces,
                                                       body.uv)), *parts])  # fmt: skip


def power_bank(look: Look) -> Shape:
    """A power bank lying: rounded slab, ports, four lights."""
    k = look.between(0.88, 1.1)
    x, y, h = 0.135 * k, 0.068 * k, 0.018 * k
    color = look.color("black", "white", "silver", "blue", "pink", "charcoal", "red")
    body = block(x, y, h, 0.012, 0.004)
    lights = [box(0.0045, 0.0022, 0.0006).move(0.36 * x, (n - 1.5) * 0.008, h - 0.0002)
              for n in range(4)]  # fmt: skip
    ports = [box(0.002, 0.012, 0.006).move(0.5 * x, s * 0.018, h / 2 - 0.003) for s in (-1, 1)]
    sign = prints.canvas(96, 48, color)
    prints.write(sign, look.pick(["10000", "20000 mAh", "POWER", "5V 2A"]), 0.5, 0.5, 0.3,
                 tint_color(color, 1.6) if sum(color) < 380 else tint_color(color,
                     0.5))  # fmt: skip
    face = box(0.5 * x, 0.55 * y, 0.0005).move(x=-0.12 * x, z=h - 0.0002)
    return shape([(body, look.surface(color, "plastic")), (face, sign),
                  (join(lights), textures.plain((120, 220, 240))),
                      (join(ports), textures.plain(DARK))],
                 [hull_of(body)])  # fmt: skip


def usb_hub(look: Look) -> Shape:
    """A USB hub lying: a bar with four sockets and a short lead with a plug."""
    k = look.between(0.9, 1.1)
    x, y, h = 0.1 * k, 0.03 * k, 0.012 * k
    color = look.color("black", "silver", "white", "gray", "blue")
    body = block(x, y, h, 0.005, 0.002)
    ports, tongues = [], []
    for n in range(4):
        u = (n - 1.5) * 0.023 * k
        ports.append(box(0.0145 * k, 0.0022, 0.0065 * k).move(u, -y / 2, 0.25 * h))
        tongues.append(box(0.011 * k, 0.0026, 0.002 * k).move(u, -y / 2, 0.45 * h))
    way = smooth([(x / 2 - 0.002, 0, h / 2), (x / 2 + 0.02, 0.002, h / 2), (x / 2 + 0.045, 0.022,
                  0.0035), (x / 2 + 0.06, 0.045, 0.0035)], 5)  # fmt: skip
    lead = tube(way, 0.0021, 8)
    plug = block(0.014, 0.026, 0.008, 0.002, 0.001).turn(2, -0.5).move(x / 2 + 0.064, 0.056, 0)
    tip = box(0.012, 0.016, 0.0046).turn(2, -0.5).move(x / 2 + 0.0725, 0.0715, 0.0015)
    black = textures.plain(DARK)
    return shape([(body, look.surface(color, "plastic")), (join(ports), black),
                  (join(tongues), textures.plain((60, 110, 210))), (join([lead, plug]), black),
                  (tip, textures.plain(STEEL))],
                 [hull_of(body), hull_of(plug), hull_of(tip)])  # fmt: skip


def power_supply(look: Look) -> Shape:
    """A bench power supply standing: two displays, knobs, red and black sockets."""
    k = look.between(0.85, 1.05)
    x, y, h = 0.14 * k, 0.2 * k, 0.16 * k
    color = look.color("gray", "white", "charcoal", "blue", "cream")
    body = block(x, y, h - 0.008, 0.005, 0.002).move(z=0.008)
    feet = [cylinder(0.009, 0.009, 12).move(s * 0.36 * x, t * 0.38 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    image = prints.canvas(96, 112, tint_color(color, 0.9))
    for n, (unit, tone) in enumerate((("V", (255, 80, 70)), ("A", (90, 240, 120)))):
        prints.fill(image, 0.1, 0.08 + 0.24 * n, 0.8, 0.2, (22, 20, 22))
        value = f"{look.between(1, 24) if n == 0 else look.between(0, 3):05.2f}"
        prints.write(image, value + unit, 0.5, 0.18 + 0.24 * n, 0.15, tone, bold=True)
    front = box(0.94 * x, 0.0012, 0.92 * (h - 0.008)).move(y=-y / 2, z=0.008 + 0.04 * h)
    knobs = [facing(cylinder(0.012 * k, 0.013 * k, 20, bevel=0.001)).move((n - 0.5) * 0.06 * k,
             -y / 2, 0.43 * h) for n in (0, 1)]  # fmt: skip
    posts = [facing(cylinder(0.0085 * k, 0.018 * k, 16, bevel=0.001)).move(
        (n - 1) * 0.036 * k, -y / 2, 0.2 * h) for n in range(3)]  # fmt: skip
    tones = ((40, 40, 44), (60, 150, 80), (206, 50, 46))
    bow = tube(smooth([(0, -0.3 * y, h - 0.004), (0, -0.24 * y, h + 0.014),
        (0, 0.24 * y, h + 0.014),
                       (0, 0.3 * y, h - 0.004)], 3), 0.005, 8)  # fmt: skip
    return shape([(body, look.surface(color, "metal")), (front, image),
                  (join([*knobs, *feet, bow]), textures.plain(DARK)),
                  *[(p, textures.plain(c)) for p, c in zip(posts, tones, strict=True)]],
                 [box_part(x, y, h), hull_of(*knobs), hull_of(*posts), hull_of(bow)])  # fmt: skip


def _text_page(look: Look) -> textures.Tile:
    image = prints.canvas(128, 176, (222, 222, 214))
    prints.write(
        image, look.pick(["CHAPTER 1", "CHAPTER 7", "PART TWO"]), 0.5, 0.12, 0.06, (40, 40, 40)
    )
    prints.lines(image, look.rng, (0.1, 0.22, 0.8, 0.68), 17, (84, 84, 84), 0.35)
    return image


def e_reader(look: Look) -> Shape:
    """An e-reader lying, a page of text on it."""
    k = look.between(0.94, 1.08)
    x, y, h = 0.118 * k, 0.165 * k, 0.0085
    color = look.color("black", "black", "white", "charcoal", "navy")
    screen = box(0.82 * x, 0.8 * y, 0.0005).move(y=0.03 * y, z=h - 0.0002)
    knob = block(0.014, 0.007, 0.0008, 0.003).move(y=-0.44 * y, z=h - 0.0003)
    return shape([(block(x, y, h, 0.01, 0.002), look.surface(color, "plastic")),
                  (screen, _text_page(look)), (knob, textures.plain((110, 110, 114)))],
                 [box_part(x, y, h)])  # fmt: skip


def scanner(look: Look) -> Shape:
    """A flatbed scanner, its lid closed."""
    k = look.between(0.85, 1.0)
    x, y, h = 0.28 * k, 0.38 * k, 0.055 * k
    color = look.color("white", "gray", "black", "charcoal")
    body = block(x, y, 0.6 * h, 0.012, 0.003)
    lid = block(0.98 * x, 0.9 * y, 0.36 * h, 0.012, 0.004).move(y=0.04 * y, z=0.63 * h)
    seam = box(0.97 * x, 0.9 * y, 0.06 * h).move(y=0.04 * y, z=0.59 * h)
    keys = [cylinder(0.006, 0.0016, 14).move((n - 1.5) * 0.02, -0.458 * y, 0.6 * h - 0.0004)
            for n in range(4)]  # fmt: skip
    line = box(0.82 * x, 0.0015, 0.0006).move(y=-0.3 * y, z=0.99 * h - 0.0002)
    mark = box(0.2 * x, 0.02 * y, 0.0006).move(y=-0.35 * y, z=0.99 * h - 0.0002)
    tile = look.surface(color, "plastic")
    glow = look.own_color("lime", "cyan", "blue")
    return shape([(body, tile), (lid, tile), (join([seam, line, mark]), textures.plain(
                  tint_color(color, 0.55))), (join(keys), textures.plain(glow))],
                 [hull_of(body), hull_of(lid), hull_of(seam)])  # fmt: skip


def graphics_tablet(look: Look) -> Shape:
    """A drawing tablet with keys at its side and a pen on it."""
    k = look.between(0.88, 1.05)
    x, y, h = 0.29 * k, 0.19 * k, 0.0085
    color = look.color("black", "charcoal", "black", "white")
    pale = tint_color(color, 1.22) if sum(color) < 400 else tint_color(color, 0.9)
    area = prints.canvas(128, 96, pale)
    for u, v in ((0.05, 0.07), (0.95, 0.07), (0.05, 0.93), (0.95, 0.93)):
        prints.fill(area, u - 0.02, v - 0.004, 0.04, 0.008, (190, 192, 196))
        prints.fill(area, u - 0.003, v - 0.03, 0.006, 0.06, (190, 192, 196))
    keys = [block(0.02 * k, 0.014 * k, 0.0016, 0.003).move(-0.43 * x, (n - 2.5) * 0.02 * k,
        h - 0.0006)
            for n in range(6)]  # fmt: skip
    pen = lay_down(lathe(np.array([(0, 0), (0.0008, 0), (0.0048, 0.018), (0.0058, 0.05),
                               (0.005, 0.15), (0, 0.152)]) * k, 16), -0.07 * k,
                                   h + 0.0058 * k)  # fmt: skip
    pen = pen.turn(2, 0.5).move(x=0.06 * x)
    return shape([(block(x, y, h, 0.01, 0.002), look.surface(color, "plastic")),
                  (box(0.78 * x, 0.86 * y, 0.0005).move(x=0.05 * x, z=h - 0.0002), area),
                  (join(keys), textures.plain(tint_color(pale, 0.8))), (pen, textures.plain(
                      (70, 70, 76)))], [box_part(x, y, h), hull_of(pen)])  # fmt: skip


CATEGORIES = (
    Category("television", television, (0.47, 0.15, 0.302), 3.0, ("tv", "flat screen tv",
             "smart tv", "flatscreen", "tv set", "television set", "flat screen", "small tv"),
             ("living",), ("big", "tall", "screen"), ("black",)),
    Category("game_console", game_console, (0.27, 0.22, 0.0565), 2.8, ("gaming console",
             "video game console", "console", "playstation", "xbox", "home console"), ("living",),
             ("big",), ("black", "white")),
    Category("drone", drone, (0.27, 0.27, 0.0605), 0.3, ("quadcopter", "quadrocopter",
             "camera drone", "mini drone", "toy drone"), ("electronics",), ("big",),
             ("white", "gray")),
    Category("power_bank", power_bank, (0.1345, 0.067, 0.018), 0.22, ("powerbank",
             "portable charger", "battery pack", "external battery",
             "jump starter", "car jump starter"), ("office",), ("flat",),
             ("black", "white")),
    Category("usb_hub", usb_hub, (0.179, 0.0955, 0.012), 0.06, ("usb splitter", "usb port hub",
             "usb multiport", "hub",
             "splitter", "cable splitter"), ("office",), ("flat",), ("black",)),
    Category("power_supply", power_supply, (0.133, 0.209, 0.172), 2.5, ("bench power supply",
             "lab power supply", "dc power supply", "variable power supply", "power supply unit",
             "psu"), ("electronics",),
             ("big",), ("gray",)),
    Category("e_reader", e_reader, (0.119, 0.1667, 0.0088), 0.19, ("ereader", "e-reader",
             "ebook reader", "kindle", "e-book", "e-book reader", "ebook", "e reader"),
             ("living",), ("flat", "screen"), ("black",)),
    Category("scanner", scanner, (0.26, 0.353, 0.0505), 2.0, ("flatbed scanner",
             "document scanner", "photo scanner"), ("office",), ("big", "support", "flat"),
             ("white",)),
    Category("graphics_tablet", graphics_tablet, (0.28, 0.1835, 0.02), 0.5, ("drawing tablet",
             "pen tablet", "graphic tablet", "digital drawing tablet"), ("office",),
             ("flat", "big"), ("black",)),
)  # fmt: skip
"""The module's categories."""
