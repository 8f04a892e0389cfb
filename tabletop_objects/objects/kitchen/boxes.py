"""Objects of the ``kitchen`` theme: boxes."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, frame_parts, hull_of
from ...kit.shapes import Category, Shape, category, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, loft, prism, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ..workbench.boxes import case


@category("bread_box", size=(0.356, 0.242, 0.185), mass=2.2, material="metal", hollow=True,
          aliases=("bread bin", "breadbox", "breadbin"), themes=("kitchen",), roles=("big",),
          colors=("cream", "silver"))  # fmt: skip
def bread_box(look: Look) -> Shape:
    """A bread bin with a rounded roll-up front and a knob."""
    x, y, h = look.between(0.34, 0.4), look.between(0.22, 0.26), look.between(0.17, 0.2)
    color = look.color("cream", "silver", "red", "mint", "black", "wooden", "white")
    skin = look.surface(color, look.pick(["metal", "metal", "wood"]))
    a = np.linspace(0, np.pi / 2, 8)
    arch = np.column_stack([0.25 * y - 0.75 * y * np.sin(a), 0.25 * h + 0.75 * h * np.cos(a)])
    side = np.concatenate([[(-0.5 * y, 0), (0.5 * y, 0), (0.5 * y, h)], arch])
    body = prism(side, -x / 2, x / 2)
    body = body.turn(0, np.pi / 2).turn(2, np.pi / 2)
    ends = [box(0.006, y * 1.02, 0.012).move(s * 0.49 * x) for s in (-1, 1)]
    grip = box(0.11, 0.012, 0.012).move(0, -0.47 * y, 0.48 * h)
    sign = prints.canvas(160, 48, color)
    prints.write(sign, "BREAD", 0.5, 0.5, 0.66, readable_on(color), bold=True)
    plate = box(0.16, 0.0012, 0.048).move(0, -0.5005 * y, 0.02 * h)
    dark = surfaces.plain(tint_color(color, 0.55))
    return shape([(body, skin), (join(ends), dark), (grip, look.surface(look.own_color(
        "wooden", "silver", "black"), "wood")), (plate, sign)], [hull_of(body)])  # fmt: skip


@category("cool_box", size=(0.394, 0.254, 0.216), mass=2.2, material="plastic", hollow=True,
          aliases=("cooler", "coolbox", "ice chest", "cooler box", "ice box"), themes=("kitchen",),
          roles=("big",), colors=("blue", "red"))  # fmt: skip
def cool_box(look: Look) -> Shape:
    """A cool box with a white lid and a carrying handle."""
    x, y, h = look.between(0.3, 0.36), look.between(0.2, 0.24), look.between(0.2, 0.24)
    color = look.color("blue", "red", "teal", "navy", "orange", "green")
    low = block(x, y, 0.78 * h, 0.03, 0.004)
    band = block(1.01 * x, 1.01 * y, 0.012, 0.03).move(z=0.74 * h)
    lid = block(1.03 * x, 1.04 * y, 0.2 * h, 0.03, 0.008).move(z=0.78 * h)
    arm = tube(smooth([(-0.52 * x, -0.03, 0.76 * h), (-0.5 * x, -0.5 * y - 0.012, 0.7 * h),
                       (0.5 * x, -0.5 * y - 0.012, 0.7 * h), (0.52 * x, -0.03, 0.76 * h)], 4),
               0.008, 8)  # fmt: skip
    snow = prints.canvas(96, 64, color)
    for k in range(3):
        a = k * np.pi / 3
        prints.stroke(snow, [(0.5 - 0.2 * np.cos(a), 0.5 - 0.32 * np.sin(a)),
                             (0.5 + 0.2 * np.cos(a), 0.5 + 0.32 * np.sin(a))], 0.06,
                      (250, 250, 252))  # fmt: skip
    front = box(0.5 * x, 0.001, 0.42 * h).move(y=-y / 2, z=0.16 * h)
    white = surfaces.speckles(look.rng, (240, 240, 238), 3)
    return shape([(low, look.surface(color, "plastic")), (join([band, lid, arm]), white),
                  (front, snow)], [hull_of(low), hull_of(lid), hull_of(arm)])  # fmt: skip


@category("cereal_box", size=(0.18, 0.055, 0.26), mass=0.4, material="paper", aliases=("cereal",
          "cereal carton", "box of cereal", "cracker box", "box of cornflakes", "box of muesli",
          "box of granola"), themes=("kitchen", "dining"), roles=("tall",),
          colors=("red", "yellow"), common=True)  # fmt: skip
def cereal_box(look: Look) -> Shape:
    """An upright cereal box."""
    x, y, h = look.between(0.17, 0.19), look.between(0.05, 0.06), look.between(0.24, 0.28)
    color = look.color("red", "yellow", "blue", "orange", "green")
    title = look.pick(["OATS", "FLAKES", "CRUNCH", "MUESLI"])
    face = prints.cover(look.rng, title, color, look.own_color("white", "yellow", "cream"))
    side = surfaces.plain(tint_color(color, 0.9))
    front = box(0.985 * x, 0.001, 0.985 * h).move(y=-y / 2, z=0.007 * h)
    back = box(0.985 * x, 0.001, 0.985 * h).move(y=y / 2, z=0.007 * h)
    return shape([(box(x, y, h), side), (front, face), (back, face)], [box_part(x, y, h)])


@category("egg_carton", size=(0.21, 0.12, 0.08), mass=0.5, material="paper",
          aliases=("carton of eggs", "box of eggs", "egg box", "egg tray", "tray of eggs"),
          themes=("kitchen", "food"), colors=("gray", "beige"), state="lying open",
          common=True)  # fmt: skip
def egg_carton(look: Look) -> Shape:
    """An open carton of eggs, or an empty one with as many cups as requested."""
    rows, pitch = 2, 0.048
    columns = int(look.pick([3, 5]))
    empty = look.attributes.get("state") == "empty"
    if "places" in look.attributes:
        columns, pitch = -(-int(look.attributes["places"]) // rows), 0.052
    color = look.color("gray", "beige", "sage", "lavender", "sky")
    pulp = surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.1)
    x, y, h = columns * pitch + 0.01, rows * pitch + 0.01, 0.042
    floor = 0.01 if empty else 0.018
    tray = [block(x, y, floor, 0.008, 0.003)]
    eggs: dict[str, list[Solid]] = {"cream": [], "tan": []}
    kind = look.pick([("cream", "cream"), ("tan", "tan"), ("cream", "tan")])
    for i in range(columns + 1):
        for j in range(rows + 1):
            at = (pitch * (i - columns / 2) * 0.97, pitch * (j - rows / 2) * 0.97)
            tray.append(cylinder(0.014, h, 8, top=0.005).move(*at))
            if i < columns and j < rows and (look.chance(0.85) or i + j == 0) and not empty:
                egg = ellipsoid(0.043, 0.043, 0.056, 14, 8)
                place = (pitch * (i + 0.5 - columns / 2), pitch * (j + 0.5 - rows / 2), 0.034)
                eggs[kind[int(look.rng.integers(2))]].append(egg.move(*place))
    lid = box(x, 0.004, 0.07).move(z=0.012).turn(0, -0.2).move(y=y / 2)
    pieces = [(join(tray), pulp), (lid, pulp)]
    pieces += [(join(some), surfaces.speckles(look.rng, look.own_color(name), 4))
               for name, some in eggs.items() if some]  # fmt: skip
    if not empty:
        return shape(pieces, [*frame_parts(x, y, h, 0.008, 0.01), hull_of(lid)])
    walls = [box_part(0.002, y, h, (pitch * (i - columns / 2), 0, 0)) for i in range(columns + 1)]
    walls += [box_part(x, 0.002, h, (0, pitch * (j - rows / 2), 0)) for j in range(rows + 1)]
    return shape(pieces, [box_part(x, y, floor), *walls, hull_of(lid)])


@category("milk_carton", size=(0.07, 0.07, 0.213), mass=0.75, material="paper",
          aliases=("carton", "carton of milk", "milk", "milk box", "tetra pak", "tetrapak carton"),
          themes=("kitchen", "dining"), roles=("tall",), colors=("blue", "red", "green"),
          common=True)  # fmt: skip
def milk_carton(look: Look) -> Shape:
    """A gable-top carton of milk with its printed front facing the viewer."""
    x, h = look.between(0.066, 0.074), look.between(0.15, 0.19)
    color = look.color("blue", "red", "green", "teal", "sky", "orange")
    word = look.pick(["MILK", "OATS", "JUICE", "CREAM"])
    front = prints.canvas(96, 160, (248, 248, 246))
    prints.fill(front, 0, 0.7, 1, 0.3, color)
    prints.disc(front, 0.5, 0.68, 0.16, tint_color(color, 1.4))
    prints.write(front, word, 0.5, 0.2, 0.14, color, bold=True)
    prints.lines(front, look.rng, (0.2, 0.36, 0.6, 0.08), 2, (140, 140, 150))
    square, ridge = rectangle(x, x), rectangle(x, 0.003)
    roof, top = h + 0.4 * x, h + 0.4 * x + 0.014
    gable = loft(
        np.stack(
            [np.column_stack([o, np.full(4, z)])
             for o, z in [(square, h), (ridge, roof), (ridge, top)]]
        ),
        square,
    )  # fmt: skip
    pieces = [(box(x, x, h), front), (gable, surfaces.speckles(look.rng, tint_color(color, 1.1),
                                                               3))]  # fmt: skip
    if look.chance(0.6):
        cap = cylinder(0.011, 0.012, 18, bevel=0.001).move(z=-0.002)
        cap = cap.turn(0, np.deg2rad(39)).move(y=-0.26 * x, z=h + 0.19 * x)
        pieces.append((cap, surfaces.plain(look.own_color("white", "red", "blue"))))
    return shape(pieces, [box_part(x, x, h), hull_of(gable)])


PALE: RGB = (246, 244, 238)


@category("ready_meal", size=(0.196, 0.149, 0.0359), mass=0.4, material="paper",
          aliases=("microwave meal", "tv dinner", "frozen dinner", "microwave dinner",
          "frozen meal"), themes=("kitchen",), roles=("flat",), colors=("green",),
          state="lying flat")  # fmt: skip
@vary()
def ready_meal(look: Look) -> Shape:
    """A ready meal: a black tray of food with compartments, under a printed sleeve."""
    k = look.between(0.95, 1.06)
    x, y, h = 0.19 * k, 0.14 * k, 0.036 * k
    color = look.color("green", "red", "navy", "purple", "orange", "brown")
    tray = block(x, y, 0.8 * h, 0.018, 0.004)
    rim = block(1.04 * x, 1.05 * y, 0.004, 0.02, 0.001).move(z=0.78 * h)
    stew = block(0.52 * x, 0.84 * y, 0.004, 0.012, 0.0015).move(x=-0.21 * x, z=0.86 * h)
    mash = block(0.34 * x, 0.4 * y, 0.004, 0.01, 0.0015).move(x=0.27 * x, y=0.22 * y, z=0.86 * h)
    peas = block(0.34 * x, 0.38 * y, 0.004, 0.01, 0.0015).move(x=0.27 * x, y=-0.22 * y, z=0.86 * h)
    bed = block(0.97 * x, 0.96 * y, 0.003, 0.014).move(z=0.84 * h)
    band = box(0.24 * x, 1.07 * y, 0.0012).move(x=0.0, z=0.97 * h)
    sign = prints.canvas(70, 200, color)
    prints.fill(sign, 0, 0.3, 1, 0.4, PALE)
    prints.write(sign, look.pick(["MEAL", "DINNER", "READY", "CURRY"]), 0.5, 0.5, 0.11,
                 tint_color(color, 0.6), bold=True)  # fmt: skip
    return shape([(join([tray, rim]), surfaces.plain((36, 36, 40))),
                  (bed, surfaces.plain((52, 50, 50))),
                  (stew, surfaces.spots(look.rng, (150, 82, 40), (212, 130, 60), 0.2)),
                  (mash, surfaces.speckles(look.rng, (244, 230, 176), 8)),
                  (peas, surfaces.spots(look.rng, (104, 164, 70), (70, 120, 50), 0.4)),
                  (band, sign)], [hull_of(tray), hull_of(rim, band)])  # fmt: skip


@category("cookie_box", size=(0.17, 0.058, 0.115), mass=0.28, material="paper",
          aliases=("box of cookies", "biscuit box", "box of biscuits", "cookies box",
          "box of crackers", "cookie packet", "biscuit packet", "packet of biscuits",
          "packet of cookies", "packet of crackers", "cracker packet"), themes=("kitchen", "tea"),
          colors=("blue", "red"))  # fmt: skip
def cookie_box(look: Look) -> Shape:
    """A box of biscuits with a picture of biscuits on its front."""
    x, y, h = look.between(0.15, 0.19), look.between(0.05, 0.065), look.between(0.1, 0.13)
    color = look.color("blue", "red", "green", "purple", "yellow", "brown", "teal", "pink")
    image = prints.canvas(176, 112, color)
    prints.disc(image, 0.5, 1.25, 0.75, tint_color(color, 1.4))
    word = look.pick(["COOKIES", "BISCUITS", "CHOCO", "CRACKERS"])
    prints.write(image, word, 0.5, 0.2, 0.2, readable_on(color), bold=True)
    dark = look.chance(0.3)
    for a in (0.24, 0.5, 0.76):
        prints.disc(image, a, 0.64, 0.2, (64, 42, 34) if dark else (214, 160, 90))
        prints.disc(image, a, 0.64, 0.17, (86, 58, 46) if dark else (226, 178, 110))
        for k in range(6):
            u, v = 0.1 * np.cos(k * 1.05 + a * 9), 0.1 * np.sin(k * 1.05 + a * 9)
            prints.disc(image, a + u * 112 / 176, 0.64 + v, 0.024, (76, 44, 28) if not dark
                        else (240, 236, 226))  # fmt: skip
    panel = box(x, 0.0006, h)
    top = box(x, y, 0.0006).move(z=h - 0.0003)
    sign = prints.canvas(176, 64, color)
    prints.write(sign, word, 0.5, 0.5, 0.4, readable_on(color), bold=True)
    return shape([(box(x, y, h), surfaces.speckles(look.rng, color, 2, 32)),
                  (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image), (top, sign)],
                 [box_part(x, y, h)])  # fmt: skip


@category("pudding_box", size=(0.098, 0.036, 0.083), mass=0.12, material="paper",
          aliases=("box of pudding", "chocolate pudding", "pudding", "gelatin box", "jello box",
          "pudding mix", "chocolate pudding box", "gelatin", "baking mix", "gelatin packet",
          "jelly packet"), themes=("kitchen",), colors=("brown", "red"))  # fmt: skip
def pudding_box(look: Look) -> Shape:
    """A small box of pudding or jelly powder with a picture of the dessert on its front."""
    x, y, h = look.between(0.085, 0.11), look.between(0.03, 0.04), look.between(0.075, 0.09)
    color = look.color("brown", "red", "yellow", "green", "orange", "crimson", "blue")
    word = look.pick(["PUDDING", "PUDDING", "JELLY", "CHOCOLATE", "GELATIN"])
    tone = look.pick([(96, 58, 38), (220, 60, 70), (244, 214, 120), (150, 200, 90)])
    image = prints.canvas(128, 104, color)
    prints.fill(image, 0, 0.1, 1, 0.28, (248, 246, 240))
    prints.write(image, word, 0.5, 0.25, 0.2, tint_color(color, 0.6), bold=True)
    prints.disc(image, 0.5, 0.68, 0.2, tone)
    prints.disc(image, 0.5, 0.52, 0.07, (252, 250, 244))
    prints.polygon(image, [(0.2, 0.7), (0.8, 0.7), (0.66, 0.92), (0.34, 0.92)], (250, 250, 250))
    panel = box(x, 0.0006, h)
    return shape([(box(x, y, h), surfaces.speckles(look.rng, color, 2, 32)),
                  (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image)],
                 [box_part(x, y, h)])  # fmt: skip


@category("juice_box", size=(0.0607, 0.0397, 0.157), mass=0.22, material="paper", assembled=True,
          aliases=("juice pack", "drink box", "box of juice", "juice carton with straw",
          "apple juice box", "juice pouch"), themes=("kitchen",), roles=("tall",),
          colors=("orange",))  # fmt: skip
def juice_box(look: Look) -> Shape:
    """A small carton of juice with a bent straw."""
    x, y, h = look.between(0.05, 0.058), look.between(0.036, 0.042), look.between(0.1, 0.12)
    color = look.color("orange", "green", "red", "purple", "yellow", "pink")
    face = prints.canvas(80, 150, color)
    prints.disc(face, 0.5, 0.64, 0.17, tint_color(color, 0.7))
    prints.disc(face, 0.46, 0.6, 0.05, tint_color(color, 1.5))
    prints.fill(face, 0.06, 0.12, 0.88, 0.2, (250, 248, 240))
    prints.write(face, look.pick(["JUICE", "APPLE", "ORANGE"]), 0.5, 0.22, 0.13,
                 tint_color(color, 0.6), bold=True)  # fmt: skip
    front = [box(0.98 * x, 0.001, 0.97 * h).move(y=s * y / 2, z=0.01 * h) for s in (-1, 1)]
    pipe = tube(smooth([(0.25 * x, 0, h - 0.01), (0.25 * x, 0, h + 0.028), (0.3 * x, 0, h + 0.036),
                        (0.62 * x, 0, h + 0.046)], 4), 0.0024, 8)  # fmt: skip
    return shape([(box(x, y, h), surfaces.plain(tint_color(color, 0.9))), (join(front), face),
                  (pipe, surfaces.plain((250, 248, 244)))],
                 [box_part(x, y, h), hull_of(pipe)])  # fmt: skip


Pieces = list[tuple[Solid, surfaces.Tile]]


@category("pasta_box", size=(0.1, 0.046, 0.23), mass=0.52, material="paper",
          aliases=("box of pasta", "spaghetti box", "macaroni box", "pasta packet", "macaroni",
          "lasagna box", "box of spaghetti", "box of macaroni"), themes=("kitchen",),
          roles=("tall",), colors=("blue",))  # fmt: skip
def pasta_box(look: Look) -> Shape:
    """A box of pasta: tall for spaghetti, or broad with a window that shows the pasta."""
    tall = look.chance(0.5)
    x, y, h = (look.between(0.07, 0.085), 0.04, look.between(0.25, 0.28)) if tall else (
        look.between(0.12, 0.14), look.between(0.045, 0.06), look.between(0.17, 0.2))  # fmt: skip
    color = look.color("blue", "navy", "blue", "red", "green", "yellow")
    word = look.pick(["SPAGHETTI", "PASTA"] if tall else ["PASTA", "PENNE", "FUSILLI"])
    image = prints.canvas(96, 160, color)
    prints.fill(image, 0.06, 0.13, 0.88, 0.18, (250, 250, 248))
    prints.write(image, word, 0.5, 0.22, 0.1, (196, 42, 40), bold=True)
    prints.fill(image, 0.16, 0.42, 0.68, 0.44, (238, 206, 120))
    for k in range(14):
        if tall:
            prints.fill(image, 0.17 + 0.047 * k, 0.42, 0.016, 0.44, (214, 170, 80))
        else:
            a, b = look.rng.uniform(0.2, 0.75), look.rng.uniform(0.46, 0.82)
            turn = look.rng.uniform(0, np.pi)
            tip = (a + 0.09 * np.cos(turn), b + 0.05 * np.sin(turn))
            prints.stroke(image, [(a, b), tip], 0.028, (222, 180, 90))
            prints.stroke(image, [(a, b), tip], 0.01, (196, 146, 60))
    prints.fill(image, 0, 0.93, 1, 0.025, (246, 240, 222))
    side = surfaces.speckles(look.rng, color, 2, 32)
    panel = box(x, 0.0006, h)
    return shape([(box(x, y, h), side), (panel.move(y=-y / 2), image),
                  (panel.move(y=y / 2), image)], [box_part(x, y, h)])  # fmt: skip


@category("tea_box", size=(0.135, 0.101, 0.114), mass=0.12, material="paper", assembled=True,
          aliases=("box of tea", "tea bags", "teabag box", "box of tea bags", "tea packet",
          "green tea box"), themes=("kitchen", "tea"), colors=("green", "yellow"))  # fmt: skip
def tea_box(look: Look) -> Shape:
    """A box of tea: closed, or open with a row of tea bags and a tag hanging out."""
    x, y, h = look.between(0.12, 0.15), look.between(0.065, 0.08), look.between(0.065, 0.085)
    color = look.color("green", "yellow", "red", "teal", "navy", "purple", "orange", "maroon")
    word = look.pick(["TEA", "GREEN TEA", "CHAMOMILE", "EARL GREY", "MINT", "CHAI"])
    image = prints.canvas(160, 88, color)
    for s in (-1, 1):
        prints.polygon(image, [(0.5, 0.86), (0.5 + 0.1 * s, 0.62), (0.5 + 0.24 * s, 0.58),
                               (0.5 + 0.16 * s, 0.8)], (110, 168, 80))  # fmt: skip
    prints.fill(image, 0.06, 0.12, 0.88, 0.4, (248, 244, 230))
    prints.write(image, word, 0.5, 0.32, 0.26, tint_color(color, 0.5), bold=True)
    skin = surfaces.speckles(look.rng, color, 2, 32)
    panel = box(x, 0.0006, h)
    if look.chance(0.55):
        lid = box(x, y, 0.0006).move(z=h - 0.0003)
        return shape([(box(x, y, h), skin), (panel.move(y=-y / 2), image),
                      (panel.move(y=y / 2), image), (lid, image)], [box_part(x, y, h)])  # fmt: skip
    flap = box(x, 0.002, 0.9 * y).turn(0, -0.5).move(y=y / 2 - 0.001, z=h - 0.004)
    bags = []
    count = 9
    paper = surfaces.speckles(look.rng, (240, 236, 222), 6, 32)
    for k in range(count):
        u = (k / (count - 1) - 0.5) * 0.84 * x
        bags.append(block(0.08 * x, 0.8 * y, 0.014, 0.003, 0.002).move(x=u, z=h - 0.008))
    string = tube([(0.2 * x, -0.3 * y, h + 0.004), (0.2 * x, -y / 2 - 0.003, h + 0.002),
                   (0.2 * x, -y / 2 - 0.004, 0.55 * h)], 0.0008, 5)  # fmt: skip
    tag = box(0.022, 0.001, 0.022).move(0.2 * x, -y / 2 - 0.004, 0.55 * h - 0.02)
    return shape(
        [(box(x, y, h), skin), (panel.move(y=-y / 2), image), (flap, image), (join(bags), paper),
         (string, surfaces.plain((250, 250, 246))), (tag, surfaces.plain(tint_color(color, 1.5)))],
        [box_part(x, y, h), hull_of(flap), hull_of(*bags)],
    )  # fmt: skip


@category("juice_carton", size=(0.077, 0.053, 0.194), mass=0.8, material="paper",
          aliases=("orange juice", "carton of juice", "orange juice carton", "apple juice",
          "carton of orange juice", "drink carton", "fruit juice", "boxed drink", "juice brick"),
          themes=("kitchen", "breakfast"), roles=("tall",), colors=("orange", "green"))  # fmt: skip
def juice_carton(look: Look) -> Shape:
    """A carton of juice: a tall carton with a screw cap, or a small one with a straw."""
    fruit, word = look.pick([("orange", "ORANGE"), ("red", "CHERRY"), ("green", "APPLE"),
                             ("purple", "GRAPE"), ("yellow", "MANGO"),
                             ("crimson", "TOMATO")])  # fmt: skip
    color = look.color(fruit)
    small = look.chance(0.4)
    x, y, h = (
        (0.052, 0.038, look.between(0.1, 0.115))
        if small
        else (look.between(0.085, 0.095), look.between(0.058, 0.066), look.between(0.19, 0.21))
    )
    ground = look.pick([(248, 248, 244), tint_color(color, 1.55), tint_color(color, 0.9)])
    image = prints.canvas(96, 160, ground)
    prints.fill(image, 0, 0, 1, 0.06, tint_color(color, 0.8))
    ink = readable_on(ground) if look.chance(0.5) else tint_color(color, 0.45)
    prints.write(image, word, 0.5, 0.2, 0.13, ink, bold=True)
    prints.write(image, "JUICE", 0.5, 0.31, 0.08, ink)
    tone = tint_color(color, 0.95)
    for a, b, s in ((0.5, 0.62, 0.17), (0.24, 0.74, 0.11), (0.78, 0.74, 0.11)):
        prints.disc(image, a, b, s, tone)
        prints.disc(image, a, b, 0.84 * s, tint_color(tone, 1.55))
        for k in range(8):
            way = (a + 0.75 * s * 160 / 96 * np.cos(k * np.pi / 4), b + 0.75 * s
                   * np.sin(k * np.pi / 4))  # fmt: skip
            prints.stroke(image, [(a, b), way], 0.008, tone)
    prints.fill(image, 0, 0.9, 1, 0.1, tint_color(color, 0.8))
    pieces: Pieces = [(box(x, y, h), image)]
    parts = [box_part(x, y, h)]
    if small:
        straw = tube(smooth([(0.015, 0.004, h - 0.002), (0.016, 0.003, h + 0.03),
                             (0.006, 0, h + 0.05)], 4), 0.0024, 8)  # fmt: skip
        pieces.append((straw, surfaces.stripes([(250, 250, 250), tone], 6)))
        parts.append(hull_of(straw))
    else:
        slope = box(x, y, 0.001).move(z=h - 0.0004)
        cap = cylinder(0.015, 0.016, 20, bevel=0.001).move(y=-0.14 * y, z=h)
        pieces += [
            (slope, surfaces.plain(tint_color(color, 0.9))),
            (cap, surfaces.plain(look.own_color("white", "orange", "green", "red"))),
        ]
        parts.append(hull_of(cap))
    return shape(pieces, parts)


@category("crate", size=(0.31, 0.225, 0.125), mass=0.9, material="wood", hollow=True,
          aliases=("wooden crate", "fruit crate", "apple crate", "vegetable crate", "produce crate",
          "wine crate", "milk crate"), themes=("kitchen",), roles=("container", "big"),
          colors=("wooden",))  # fmt: skip
def crate(look: Look) -> Shape:
    """An open crate: a wooden one with slats, or a plastic one with holes."""
    x, y, h = look.between(0.28, 0.34), look.between(0.2, 0.24), look.between(0.11, 0.14)
    color = look.color("wooden", "tan", "brown", "beige", "wooden")
    skin = look.surface(color, "wood")
    t = 0.008
    slats = [box(x, t, 0.25 * h).move(y=s * (y / 2 - t / 2), z=(0.02 + 0.34 * k) * h)
             for s in (-1, 1) for k in range(3)]  # fmt: skip
    slats += [box(t, y - 2 * t, 0.25 * h).move(x=s * (x / 2 - t / 2), z=(0.02 + 0.34 * k) * h)
              for s in (-1, 1) for k in range(3)]  # fmt: skip
    floor = [box(x - 2 * t, 0.17 * y, t).move(y=(k - 2) * 0.185 * y) for k in range(5)]
    posts = [box(0.016, 0.016, h).move(a * (x / 2 - t - 0.008), b * (y / 2 - t - 0.008))
             for a in (-1, 1) for b in (-1, 1)]  # fmt: skip
    return shape([(join([*slats, *floor]), skin),
                  (join(posts), surfaces.plain(tint_color(color, 0.7)))],
                 frame_parts(x, y, 0.95 * h, t, t))  # fmt: skip


CATEGORIES = (
    Category("open_lunch_box",
             case((0.2, 0.15, 0.07), 0.004, ("sky", "mint", "pink", "yellow"), ("white",)),
             size=(0.2, 0.18, 0.14), mass=0.3, material="plastic", hollow=True,
             aliases=("open lunchbox", "open food container"), themes=("kitchen",),
             roles=("container",), colors=("sky", "mint")),
)  # fmt: skip
"""Objects that share their drawing functions."""
