"""Bowls, tins, sieves and dishes to mix, bake, measure and store in."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of, hull_part
from ...build.forms import lobe
from ...build.outlines import rectangle, smooth
from ...build.recipes import open_vessel
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    open_box,
    sweep,
    torus,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look


def mixing_bowl(look: Look) -> Shape:
    """A large deep bowl of steel, plastic or glaze with a rolled rim, some with batter."""
    r, h = look.between(0.11, 0.135), look.between(0.1, 0.125)
    color = look.color("silver", "silver", "white", "cream", "red", "teal", "yellow", "sky", "pink")
    kind = look.pick(["metal", "plastic", "ceramic"])
    t = np.linspace(0, np.pi / 2, 8)
    side = [((0.42 + 0.58 * np.sin(a)) * r, h * (1 - np.cos(a)) ** 0.8) for a in t]
    body, parts = open_vessel(side, 0.003, 0.005, 34)
    skin = look.surface(color, kind) if kind != "ceramic" else glaze_tile(look, color)
    inside = look.surface(color if kind == "metal" else tint_color(color, 1.4), kind)
    rim = torus(r - 0.001, 0.0035, 36, 6).move(z=h - 0.003)
    pieces = [(body, textures.stack((skin, 50), (inside, 50), side=192)), (rim, inside)]
    if look.chance(0.25):
        batter = textures.speckles(look.rng, look.pick([(236, 214, 160), (96, 60, 40)]), 8)
        level = 0.45 * h
        wide = float(np.interp(level, [z for _, z in side], [x for x, _ in side])) - 0.004
        pieces.append((lathe([(0, 0.006), (0.5 * wide, 0.006), (wide, level), (0, level + 0.004)]),
                       batter))  # fmt: skip
    return shape(pieces, parts)


def colander(look: Look) -> Shape:
    """A colander: a perforated bowl on feet with two ears."""
    r, h = look.between(0.1, 0.12), look.between(0.085, 0.105)
    color = look.color("silver", "silver", "white", "red", "mint", "sky", "cream", "yellow")
    t = np.linspace(0, np.pi / 2, 8)
    side = [((0.5 + 0.5 * np.sin(a)) * r, h * (1 - np.cos(a)) ** 0.85) for a in t]
    body, parts = open_vessel(side, 0.003, 0.004, 34)
    skin = textures.fit(look.surface(color, "metal"), 256, 256).copy()
    v, u = np.mgrid[0:256, 0:256] / 256
    count, rows = 30, 26
    dots = np.hypot((u * count + 0.5 * (np.floor(v * rows) % 2)) % 1 - 0.5, (v * rows) % 1 - 0.5)
    near = np.minimum(np.abs(v - 0.5), np.abs(1 - v))
    holes = (dots < 0.27) & (np.abs(v - 0.5) > 0.08) & (near > 0.06)
    skin[holes] = np.array(tint_color(color, 0.28)).astype(np.uint8)
    plain = look.surface(color, "metal")
    foot = lathe([(0.5 * r, -0.016), (0.53 * r, -0.016), (0.56 * r, 0.008), (0.53 * r, 0.008)], 30,
                 loop=True)  # fmt: skip
    ears = [tube(smooth([(s * 0.97 * r, -0.035, h - 0.006), (s * (r + 0.028), -0.026, h),
                         (s * (r + 0.028), 0.026, h), (s * 0.97 * r, 0.035, h - 0.006)], 3),
                 0.004, 8) for s in (-1, 1)]  # fmt: skip
    rim = torus(r - 0.001, 0.0035, 36, 6).move(z=h - 0.003)
    pieces = [(body, skin), (join([foot, rim, *ears]), plain)]
    up = [(solid.move(z=0.016), tile) for solid, tile in pieces]
    raised = [type(p)(p.vertices + np.array([0, 0, 0.016]), p.kind, p.axis) for p in parts]
    lugs = [box_part(0.03, 0.06, 0.006, (s * (r + 0.012), 0, h + 0.011)) for s in (-1, 1)]
    return shape(up, [*raised, cylinder_part(0.53 * r, 0.018), *lugs])


def measuring_cup(look: Look) -> Shape:
    """A measuring cup: a glass jug with a red scale, or a steel cup with a long handle."""
    if look.chance(0.6):
        r, h = look.between(0.042, 0.055), look.between(0.085, 0.12)
        ink = look.color("red", "red", "blue", "green", "black")
        body, parts = open_vessel([(0.82 * r, 0), (0.88 * r, 0.3 * h), (0.95 * r, 0.7 * h), (r, h)],
                                  0.004, 0.006)  # fmt: skip
        face = prints.canvas(160, 96, (214, 226, 230))
        for k in range(6):
            long = 0.09 if k % 2 == 0 else 0.05
            prints.fill(face, 0.47, 0.14 + 0.13 * k, long, 0.03, ink)
            if k % 2 == 0:
                prints.write(face[:, 50:74], str(600 - 100 * k), 0.5, 0.16 + 0.13 * k, 0.11, ink)
        glass = textures.plain((206, 220, 224))
        tile = textures.stack((face, 50), (glass, 50), side=192)

        def lip_profile(p: np.ndarray) -> np.ndarray:
            up = np.clip((p[:, 2] / h - 0.7) / 0.3, 0, 1) ** 2
            left = np.clip(-p[:, 0] / r, 0, 1) ** 6
            return p + np.column_stack([-0.013 * up * left, 0 * up, 0 * up])

        ear = tube(
            smooth(
                [
                    (0.95 * r, 0, 0.88 * h),
                    (r + 0.035, 0, 0.86 * h),
                    (r + 0.035, 0, 0.3 * h),
                    (0.86 * r, 0, 0.2 * h),
                ],
                4,
            ),
            0.006,
            8,
        )
        return shape([(body.bend(lip_profile), tile), (ear, glass)],
                     [*parts, box_part(0.025, 0.012, 0.6 * h, (r + 0.026, 0, 0.24 * h))],
                     opacity=0.75)  # fmt: skip
    r, h = look.between(0.032, 0.044), look.between(0.035, 0.048)
    color = look.color("silver", "silver", "copper", "red", "teal", "white", "yellow", "black")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.85 * r, 0), (0.92 * r, 0.2 * h), (r, h)], 0.0016, 0.002)
    long = look.between(0.08, 0.1)
    grip = sweep([(0.95 * r, 0, h - 0.003), (r + long, 0, h - 0.0035)],
                 rectangle(0.018, 0.003, 0.0012, 2), [0.7, 1.0])  # fmt: skip
    mark = box(0.03, 0.009, 0.0004).move(r + 0.6 * long, 0, h - 0.0021)
    sign = prints.canvas(64, 20, tint_color(color, 0.95))
    prints.write(sign, look.pick(["1 CUP", "1/2", "1/3", "1/4"]), 0.5, 0.5, 0.7, (30, 30, 34))
    return shape([(body, skin), (grip, skin), (mark, sign)], [*parts, hull_of(grip)])


def baking_tray(look: Look) -> Shape:
    """A baking tray with a raised rim: empty, or with biscuits or buns on it."""
    x, y, h = look.between(0.3, 0.36), look.between(0.22, 0.26), look.between(0.016, 0.024)
    color = look.color("silver", "charcoal", "black", "gray", "copper")
    skin = look.surface(color, "metal")
    rims = [block(x, 0.008, 0.006, 0.003).move(y=s * (y / 2 - 0.001), z=h - 0.005)
            for s in (-1, 1)]  # fmt: skip
    rims += [block(0.008, y, 0.006, 0.003).move(x=s * (x / 2 - 0.001), z=h - 0.005)
             for s in (-1, 1)]  # fmt: skip
    pieces = [(join([*open_box(x, y, h, 0.003, 0.003), *rims]), skin)]
    kind = look.pick(["", "", "cookies", "buns", "paper"])
    parts = list(frame_parts(x, y, h, 0.003, 0.003))
    if kind in ("cookies", "buns"):
        dough = textures.spots(look.rng, (206, 156, 92), (110, 66, 40), 0.06)
        at = [((i - 1.5) * 0.23 * x, (j - 1) * 0.29 * y) for i in range(4) for j in range(3)]
        d, tall = (0.055, 0.011) if kind == "cookies" else (0.056, 0.034)
        one = lathe([(0, 0), (0.45 * d, 0), (0.5 * d, 0.4 * tall), (0.34 * d, 0.86 * tall),
                     (0, tall)], 16)  # fmt: skip
        pieces.append((join([one.move(a, b, 0.003) for a, b in at]), dough))
        parts += [cylinder_part(0.45 * d, tall, (a, b, 0.003)) for a, b in at]
    elif kind == "paper":
        pieces.append((box(0.94 * x, 0.9 * y, 0.001).move(z=0.003),
                       textures.speckles(look.rng, (222, 204, 168), 6)))  # fmt: skip
    return shape(pieces, parts)


def muffin_tin(look: Look) -> Shape:
    """A tin with six or twelve cups in a flat top, empty or with muffins."""
    rows, columns = 2, look.pick([3, 3, 4])
    pitch, r, h = 0.082, 0.034, look.between(0.03, 0.036)
    x, y = columns * pitch + 0.02, rows * pitch + 0.02
    color = look.color("charcoal", "silver", "black", "gray", "red", "copper")
    skin = look.surface(color, "metal")
    top = block(x, y, 0.003, 0.014).move(z=h - 0.003)
    at = [((i - (columns - 1) / 2) * pitch, (j - 0.5) * pitch)
          for i in range(columns) for j in range(rows)]  # fmt: skip
    cup = cylinder(0.72 * r, h - 0.002, 24, top=r)
    well = lathe([(0, 0.0), (0.92 * r, 0.0), (r, 0.0012), (1.04 * r, 0.0012), (1.04 * r, -0.001),
                  (0, -0.001)], 24)  # fmt: skip
    dark = textures.stack((textures.plain(tint_color(color, 0.45)), 1))
    pieces = [(join([top, *(cup.move(a, b) for a, b in at)]), skin)]
    parts = [box_part(x, y, 0.003, (0, 0, h - 0.003)),
             *(cylinder_part(0.72 * r, h - 0.002, (a, b, 0)) for a, b in at)]  # fmt: skip
    filled = look.chance(0.5)
    tone = look.pick([(214, 160, 90), (104, 64, 42), (226, 180, 110)])
    crumb = textures.spots(look.rng, tone, tint_color(tone, 0.5), 0.07)
    for a, b in at:
        if filled:
            bun = ellipsoid(2.2 * r, 2.2 * r, 0.04, 18, 10).move(a, b, h + 0.002)
            pieces.append((bun, crumb))
            parts.append(cylinder_part(0.8 * r, 0.014, (a, b, h)))
        else:
            pieces.append((well.move(a, b, h), dark))
    return shape(pieces, parts)


def ramekin(look: Look) -> Shape:
    """A small fluted dish with straight sides: empty, or with a custard or souffle."""
    r, h = look.between(0.042, 0.05), look.between(0.042, 0.055)
    color = look.color("white", "white", "cream", "red", "teal", "navy", "mustard", "black")
    body, parts = open_vessel([(0.92 * r, 0), (0.94 * r, 0.1 * h), (0.97 * r, 0.9 * h), (r, h)],
                              0.005, 0.006, 36)  # fmt: skip
    skin = look.surface(color, "ceramic")
    tone = textures.stripes([color, tint_color(color, 0.86)], 36, upright=True, side=144)
    smooth_band = textures.fit(skin, 144, 144)
    outside = textures.stack((tone, 80), (smooth_band, 20), side=144)
    pieces = [(body, textures.stack((outside, 50), (skin, 50), side=192))]
    if look.chance(0.4):
        tone = look.pick([(232, 190, 90), (104, 62, 40), (240, 222, 170)])
        fill = textures.spots(look.rng, tone, tint_color(tone, 0.6), 0.12)
        pieces.append((lathe([(0, 0.007), (0.85 * r, 0.007), (0.89 * r, 0.84 * h), (0, 0.88 * h)]),
                       fill))  # fmt: skip
    return shape(pieces, parts)


def pie(look: Look) -> Shape:
    """A round pie in its tin: a lattice of pastry, or a closed crust with slits."""
    r, h = look.between(0.105, 0.125), look.between(0.035, 0.045)
    crust = textures.spots(look.rng, (216, 164, 96), (168, 112, 58), 0.2)
    tin = look.surface(look.color("silver", "silver", "white", "charcoal", "terracotta"), "metal")
    dish = lathe([(0, 0), (0.78 * r, 0), (r, 0.8 * h), (0.96 * r, 0.82 * h), (0, 0.82 * h)], 32)
    edge = lobe(torus(0.93 * r, 0.0085, 48, 8), 24, 0.04).move(z=0.86 * h)
    tone = look.pick([(150, 28, 40), (206, 140, 50), (70, 40, 80), (190, 60, 40), (200, 110, 40)])
    fill = textures.spots(look.rng, tone, tint_color(tone, 1.5), 0.15)
    inner = cylinder(0.9 * r, 0.03 * h, 30).move(z=0.84 * h)
    pieces = [(dish, tin), (edge, crust)]
    if look.chance(0.65):
        strips = []
        for k in range(-2, 3):
            long = 2 * np.sqrt(max(0.9**2 - (0.36 * k) ** 2, 0.05)) * r
            for turn, lift in ((0.0, 0.0), (np.pi / 2, 0.0016)):
                strips.append(box(long, 0.15 * r, 0.005).move(y=0.36 * k * r).turn(2, turn)
                              .move(z=0.87 * h + lift))  # fmt: skip
        pieces += [(inner, fill), (join(strips), crust)]
    else:
        dome = lathe([(0, 0.83 * h), (0.92 * r, 0.83 * h), (0.7 * r, 1.08 * h), (0, 1.16 * h)], 30)
        slits = [box(0.05, 0.006, 0.003).move(x=0.05, z=1.085 * h).turn(2, k * np.pi / 2)
                 for k in range(4)]  # fmt: skip
        pieces += [(dome, crust), (join(slits), textures.plain(tone))]
    return shape(pieces, [hull_of(dish), hull_part(np.concatenate(
        [s.vertices for s, _ in pieces[1:]]))])  # fmt: skip


def food_container(look: Look) -> Shape:
    """A plastic box for food with a coloured lid and clips."""
    x, y, h = look.between(0.15, 0.2), look.between(0.11, 0.14), look.between(0.06, 0.09)
    color = look.color("red", "blue", "green", "teal", "orange", "pink", "gray", "yellow")
    food = look.pick([(214, 222, 224), (214, 222, 224), (220, 120, 60), (120, 160, 70),
                      (230, 210, 160)])  # fmt: skip
    clear = textures.plain((208, 218, 222))
    tile = textures.stack((textures.speckles(look.rng, food, 16, 32), 70), (clear, 30))
    outline = rectangle(1, 1, 0.12, 5)
    rings = np.stack([np.column_stack([outline * [x * k, y * k], np.full(len(outline), z)])
                      for k, z in ((0.9, 0), (0.93, 0.006), (1.0, h))])  # fmt: skip
    body = loft(rings, outline)
    lid = block(x + 0.008, y + 0.008, 0.014, 0.024, 0.003).move(z=h - 0.004)
    inset = block(0.8 * x, 0.76 * y, 0.002, 0.018).move(z=h + 0.0095)
    skin = look.surface(color, "plastic")
    clips = [box(0.05, 0.006, 0.022).move(y=s * (y / 2 + 0.005), z=h - 0.014) for s in (-1, 1)]
    clips += [box(0.006, 0.04, 0.022).move(x=s * (x / 2 + 0.005), z=h - 0.014) for s in (-1, 1)]
    return shape([(body, tile), (join([lid, *clips]), skin),
                  (inset, textures.plain(tint_color(color, 1.25)))],
                 [hull_of(body), hull_of(lid)], opacity=0.9)  # fmt: skip


def butter_dish(look: Look) -> Shape:
    """A stick of butter on a dish, its wrapper folded back, some of it cut off."""
    x, y, h = look.between(0.11, 0.13), look.between(0.055, 0.065), look.between(0.036, 0.044)
    color = look.color("white", "white", "sky", "cream", "teal", "pink", "navy")
    dish = loft(
        np.stack(
            [
                np.column_stack([rectangle(1, 1, 0.2, 4) * [a, b], np.full(20, z)])
                for a, b, z in (
                    (x + 0.02, y + 0.02, 0),
                    (x + 0.065, y + 0.06, 0.014),
                    (x + 0.055, y + 0.05, 0.014),
                    (x + 0.02, y + 0.02, 0.006),
                )
            ]
        ),
        rectangle(1, 1, 0.2, 4),
    )
    yellow = textures.speckles(look.rng, look.pick([(246, 222, 128), (248, 230, 156)]), 4, 32)
    kind = look.pick(["block", "cut", "wrapped"])
    stick = block(x, y, h, 0.003, 0.002).move(z=0.0055)
    pieces, parts = [(dish, look.surface(color, "ceramic"))], [hull_part(dish.vertices)]
    if kind == "cut":
        stick = block(0.72 * x, y, h, 0.003, 0.002).move(x=0.14 * x, z=0.0055)
        slice_ = block(0.1 * x, y, h, 0.002, 0.001).turn(1, -1.1).move(x=-0.34 * x, z=0.009)
        pieces.append((slice_, yellow))
    pieces.append((stick, yellow))
    parts.append(hull_of(stick))
    if kind == "wrapped":
        paper = prints.canvas(128, 64, (240, 236, 220))
        ink = look.own_color("blue", "red", "green", "gold")
        prints.fill(paper, 0, 0.1, 1, 0.12, ink)
        prints.write(paper, "BUTTER", 0.5, 0.55, 0.36, ink, bold=True)
        wrap = box(0.6 * x, y + 0.003, h + 0.0022).move(x=0.2 * x + 0.002, z=0.005)
        pieces.append((wrap, paper))
    return shape(pieces, parts)


CATEGORIES = (
    Category("mixing_bowl", mixing_bowl, (0.26, 0.26, 0.112), 0.55, ("batter bowl", "large bowl",
             "prep bowl", "steel bowl", "metal bowl"), ("kitchen",), ("container", "round", "big"),
             ("silver", "white")),
    Category("colander", colander, (0.289, 0.223, 0.119), 0.35, ("pasta strainer", "salad strainer",
             "drainer"), ("kitchen",), ("container", "round", "big"), ("silver", "white")),
    Category("measuring_cup", measuring_cup, (0.161, 0.0799, 0.0558), 0.3, ("measuring jug",
             "measure cup", "measuring glass", "glass measuring cup"), ("kitchen",), ("container",),
             ("silver", "red")),
    Category("baking_tray", baking_tray, (0.335, 0.245, 0.024), 0.6, ("baking sheet",
             "cookie sheet", "oven tray", "sheet pan", "baking pan", "cookie tray"), ("kitchen",),
             ("container", "support", "big", "flat"), ("silver", "charcoal")),
    Category("muffin_tin", muffin_tin, (0.317, 0.184, 0.0499), 0.55, ("muffin pan", "cupcake tin",
             "cupcake pan", "muffin tray", "bun tin", "resin mould", "silicone mould", "soap mould",
             "plaster mould", "candle mould", "copper jelly mould"), ("kitchen",), ("big",),
             ("charcoal", "silver")),
    Category("ramekin", ramekin, (0.092, 0.092, 0.049), 0.19, ("souffle dish", "custard cup",
             "creme brulee", "pudding cup", "custard dish", "dip bowl", "sauce dish"), ("dining",
             "kitchen"), ("container", "round"), ("white",)),
    Category("pie", pie, (0.235, 0.235, 0.044), 0.8, ("apple pie", "cherry pie", "pumpkin pie",
             "quiche", "fruit pie", "kunafa", "knafeh"), ("kitchen", "dining"), ("edible", "round",
             "big"), ("tan",)),
    Category("food_container", food_container, (0.186, 0.149, 0.0883), 0.45, ("tupperware",
             "plastic container", "storage container", "plastic box", "food box",
             "food storage container"), ("kitchen", "office"), (), ("blue", "green")),
    Category("butter", butter_dish, (0.18, 0.12, 0.045), 0.4, ("stick of butter", "butter stick",
             "block of butter", "pat of butter", "butter pat"), ("kitchen", "breakfast"), ("edible",
             ), ("yellow", "white")),
)  # fmt: skip
"""The module's categories."""
