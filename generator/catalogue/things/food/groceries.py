"""Packed goods: cans, bags, tins, boxes and paper cups with their prints."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of, hull_part, ring_parts
from ...build.forms import above, lobe, packet, pillow, speck, turned_to, wrap
from ...build.outlines import ellipse, rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, loft, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look
from ..kitchen.bottles import PRINTS


def meat_can(look: Look) -> Shape:
    """A rectangular can of luncheon meat with a pull ring."""
    x, y, h = look.between(0.09, 0.105), look.between(0.055, 0.062), look.between(0.075, 0.088)
    color, ground = (
        look.color("navy", "blue", "red", "green"),
        look.own_color("yellow", "cream", "sky"),
    )
    word = look.pick(["MEAT", "HAM", "PORK", "BEEF", "TUNA"])
    outline, share = rectangle(x, y, 0.018, 5), x / (x + y) / 2
    label = turned_to(wrap(look, word, ground, color, share=share), share / 2 + 0.03)
    tin = textures.brushed_metal(look.rng, (190, 190, 186))
    body = packet(outline, [(0.003, 1, 1), (h - 0.004, 1, 1)])
    ends = [block(x + 0.003, y + 0.003, 0.004, 0.0185, 0.001).move(z=z) for z in (0, h - 0.005)]
    ring = torus(0.009, 0.0014, 18, 6).scale(1, 0.8, 1).move(0.18 * x, 0, h + 0.0005)
    key = box(0.016, 0.006, 0.001).move(x=0.33 * x, z=h - 0.001)
    return shape(
        [(body, label), (join([*ends, ring, key]), tin)],
        [hull_of(*ends)],
    )


def coffee_bag(look: Look) -> Shape:
    """A standing bag of coffee with a folded, clipped top."""
    x, y, h = look.between(0.085, 0.11), look.between(0.055, 0.07), look.between(0.17, 0.23)
    color = look.color("brown", "black", "tan", "red", "green", "cream", "teal")
    word = look.pick(["COFFEE", "ROAST", "ARABICA", "BEANS", "ESPRESSO"])
    image = prints.canvas(320, 160, color)
    other = look.own_color("cream", "mustard", "white", "copper", "orange")
    kind = int(look.rng.integers(2))
    for u in (0.0, 0.5):
        start, wide = int(u * 320) + 5, int(160 * x / (x + y)) - 8
        part = image[:, start : start + wide]
        if kind:
            prints.fill(part, 0.12, 0.36, 0.76, 0.44, other)
        else:
            prints.disc(part, 0.5, 0.58, 0.26, other)
        ink = readable_on(other)
        prints.write(part[:, 12:-12], word, 0.5, 0.52, 0.16, ink, bold=True)
        prints.write(part, "250 g", 0.5, 0.7, 0.09, ink)
    outline = rectangle(x, y, 0.006, 2)
    body = packet(
        outline,
        [(0, 0.94, 0.94), (0.004, 1, 1), (0.55 * h, 1.0, 1.0), (0.86 * h, 1.0, 0.5),
         (0.93 * h, 1.0, 0.12), (h, 1.0, 0.1)],
    )  # fmt: skip
    clip = box(1.02 * x, 0.016, 0.014).move(z=0.92 * h)
    tie = textures.plain(look.own_color("gold", "black", "tan", "silver"))
    return shape(
        [(body, image), (clip, tie)],
        [hull_part(body.vertices[body.vertices[:, 2] < 0.6 * h]),
         hull_part(body.vertices[body.vertices[:, 2] > 0.5 * h])],
    )  # fmt: skip


def chips_bag(look: Look) -> Shape:
    """A puffed bag of crisps lying on its back."""
    x, y, z = look.between(0.15, 0.19), look.between(0.19, 0.25), look.between(0.045, 0.06)
    color = look.color("red", "yellow", "green", "blue", "orange", "purple")
    other = look.own_color("yellow", "white", "red", "orange")
    front = prints.canvas(128, 160, color)
    prints.disc(front, 0.5, 0.4, 0.3, other)
    prints.disc(front, 0.5, 0.4, 0.26, tint_color(color, 0.8))
    word = look.pick(["CHIPS", "CRISPS", "NACHO", "SALTY", "CORN"])
    prints.write(front[:, 16:-16], word, 0.5, 0.4, 0.15, (255, 250, 235), bold=True)
    for _ in range(4):
        a, b = look.rng.uniform(0.2, 0.8), look.rng.uniform(0.68, 0.84)
        prints.disc(front, a, b, 0.075, (236, 196, 96))
    for v in (0.0, 0.95):
        prints.fill(front, 0, v, 1, 0.05, (212, 212, 216))
    n = 14
    u, v = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    puff = (np.clip(1 - u**4, 0, 1) * np.clip(1 - v**4, 0, 1)) ** 0.6
    crease = 1 + 0.06 * textures.noise(look.rng, n, n, (3, 3), 1)
    lift = np.maximum(0.5 * z * puff * crease, 0.0006)
    wave = 1 - 0.05 * (1 - np.abs(v) ** 2)
    bag = pillow(u * wave * x / 2, v * y / 2, lift)
    return shape(
        [(bag.move(z=0.42 * z), front)],
        [box_part(0.62 * x, 0.66 * y, 0.84 * z), hull_of(bag.move(z=0.42 * z).bend(above))],
    )


def tea_tin(look: Look) -> Shape:
    """A tin of tea: round or square, its lid on."""
    w, h = look.between(0.07, 0.085), look.between(0.1, 0.14)
    color = look.color("green", "red", "teal", "navy", "gold", "black", "maroon")
    other = look.own_color("gold", "cream", "mustard", "sage")
    word = look.pick(["TEA", "CHAI", "GREEN", "EARL", "OOLONG"])
    label = wrap(look, word, other, color, fronts=2, share=0.22)
    lid_tile = textures.speckles(look.rng, tint_color(color, look.pick([0.75, 1.3])), 4)
    if look.chance(0.5):
        body, lid = cylinder(w / 2, 0.8 * h, 32), cylinder(w / 2 + 0.001, 0.2 * h, 32, bevel=0.002)
        part = cylinder_part(w / 2, h)
        knob = torus(0.4 * w, 0.0015, 28, 6).move(z=h)
    else:
        body = packet(rectangle(w, w, 0.006, 2), [(0, 1, 1), (0.8 * h, 1, 1)])
        label = turned_to(label, 0.135)
        lid, part = block(w + 0.002, w + 0.002, 0.2 * h, 0.007, 0.003), box_part(w, w, h)
        knob = block(0.6 * w, 0.6 * w, 0.004, 0.005, 0.001).move(z=h - 0.001)
    return shape([(body, label), (lid.move(z=0.8 * h), lid_tile), (knob, lid_tile)], [part])


def wipes_canister(look: Look) -> Shape:
    """A canister of cleaning wipes, one pulled through its lid."""
    r, h = look.between(0.037, 0.044), look.between(0.16, 0.2)
    color = look.color("yellow", "green", "sky", "lavender", "orange", "teal", "white")
    accent = look.own_color("navy", "green", "blue", "teal", "purple")
    label = wrap(look, look.pick(["WIPES", "CLEAN", "FRESH", "WIPE"]), accent, color)
    white = textures.speckles(look.rng, look.own_color("white", "white", "blue", "green"), 3, 32)
    lid = lathe([(0, 0), (r + 0.001, 0), (r + 0.001, 0.014), (0.86 * r, 0.022), (0, 0.022)], 28)
    flap = block(1.1 * r, 0.9 * r, 0.006, 0.008, 0.001).move(z=h + 0.02)
    pieces = [(cylinder(r, h, 28), label), (lid.move(z=h), white), (flap, white)]
    if look.chance(0.6):
        sheet = lathe([(0, 0), (0.22 * r, 0), (0.3 * r, 0.012), (0.62 * r, 0.034), (0, 0.02)], 20)
        pieces.append((lobe(sheet, 5, 0.5).move(z=h + 0.024), textures.plain((246, 247, 248))))
    return shape(pieces, [cylinder_part(r, h + 0.024)])


def tissue_box(look: Look) -> Shape:
    """A box of tissues, one standing out of its slot."""
    cube = look.chance(0.35)
    x = look.between(0.11, 0.12) if cube else look.between(0.21, 0.24)
    y, h = look.between(0.108, 0.12), look.between(0.115, 0.13) if cube else look.between(0.06, 0.1)
    color = look.color("sky", "pink", "sage", "white", "lavender", "teal", "beige")
    other = look.own_color("white", "navy", "coral", "mustard", "green")
    pattern = [
        textures.stripes([color, color, other], 7, upright=True, side=128),
        prints.landscape(look.rng, 192, 96),
        speck(textures.speckles(look.rng, color, 4, 96), look.rng, other, 60, 5),
        textures.gradient(color, tint_color(color, 1.5), look.rng),
    ][int(look.rng.integers(4))]
    slot = cylinder(0.028, 0.0008, 24).scale(0.3 * x / 0.028, 0.8, 1).move(z=h)
    t = np.linspace(0, 1, 6)
    fan = [ellipse(0.02 + 0.06 * k, 0.012 + 0.03 * k**2, 24) for k in t]
    ruffle = [f * (1 + 0.22 * k * np.cos(5 * np.arange(24) * 2 * np.pi / 24))[:, None]
              for f, k in zip(fan, t, strict=True)]  # fmt: skip
    rise = [0.055 * k + 0.016 * k * np.cos(np.arange(24) * 2 * np.pi / 8) for k in t]
    rings = np.stack([np.column_stack([f, h - 0.002 + z])
                      for f, z in zip(ruffle, rise, strict=True)])  # fmt: skip
    tissue = loft(rings, ellipse(1, 1, 24), profile=np.column_stack([t, t]))
    return shape(
        [(box(x, y, h), pattern), (slot, textures.plain((70, 72, 76))),
         (tissue, textures.gradient((222, 226, 230), (250, 250, 250), look.rng))],
        [box_part(x, y, h), cylinder_part(0.02, 0.05, (0, 0, h))],
    )  # fmt: skip


def paper_cup(look: Look) -> Shape:
    """A paper cup for coffee to go, with its lid and sleeve, or open."""
    r, h = look.between(0.039, 0.045), look.between(0.095, 0.13)
    base = 0.7 * r
    color = look.color("white", "brown", "tan", "red", "green", "black", "cream")
    sleeve = look.own_color("tan", "brown", "teal", "charcoal", "tan")
    print_ = wrap(look, look.pick(["COFFEE", "CAFE", "HOT", "LATTE"]), color, sleeve, share=0.24)
    paper = textures.speckles(look.rng, color, 3, 32)

    def at(z: float) -> float:
        return base + (r - base) * z / h

    wall = 0.0018
    body = lathe([(0, 0), (base, 0), (r, h), (r - wall, h), (base - wall, wall), (0, wall)], 30)
    low, high = 0.28 * h, 0.72 * h
    band = lathe([(at(low) - 0.0005, low), (at(low) + 0.0012, low), (at(high) + 0.0012, high),
                  (at(high) - 0.0005, high)], 30, loop=True, v=[0, 0, 1, 1])  # fmt: skip
    rim = torus(r, 0.0016, 30, 6).move(z=h)
    if look.chance(0.3):
        drink = cylinder(at(0.85 * h) - 0.5 * wall, 0.001, 24).move(z=0.84 * h)
        floor = cylinder_part(base, 0.006)
        parts = ring_parts([(base, 0), (r, h)], [(r - wall, h), (base - wall, 0)], 10)
        surface = textures.gradient((74, 44, 26), (120, 80, 50), look.rng)
        return shape([(join([body, rim]), paper), (band, print_), (drink, surface)],
                     [floor, *parts])  # fmt: skip
    lid = lathe(
        [(0, 0), (r + 0.002, 0), (r + 0.002, 0.006), (0.88 * r, 0.008), (0.84 * r, 0.016),
         (0.78 * r, 0.016), (0.76 * r, 0.012), (0, 0.012)],
        30,
    ).move(z=h - 0.002)  # fmt: skip
    plastic = textures.plain(look.own_color("white", "black", "white", "brown"))
    return shape(
        [(join([body, rim]), paper), (band, print_), (lid, plastic)],
        [hull_of(body), cylinder_part(0.86 * r, 0.016, (0, 0, h - 0.002))],
    )


def spray_bottle(look: Look) -> Shape:
    """A cleaner's spray bottle with its trigger."""
    r, h = look.between(0.036, 0.043), look.between(0.15, 0.18)
    color = look.color("sky", "clear", "green", "white", "orange", "lavender", "yellow")
    label = wrap(look, look.pick(["CLEAN", "GLASS", "SHINE", "MIST", "PLANTS"]),
                 look.own_color(*PRINTS), (246, 246, 242))  # fmt: skip
    skin = textures.speckles(look.rng, color, 3, 32)
    body = lathe(
        [(0, 0), (0.95 * r, 0), (r, 0.006), (r, 0.62 * h), (0.8 * r, 0.74 * h),
         (0.42 * r, 0.86 * h), (0.36 * r, h), (0, h)],
        28, v=[0, 0, 0.03, 0.62, 0.74, 0.86, 0.97, 1],
    ).scale(1, 0.72, 1)  # fmt: skip
    tile = textures.stack((skin, 0.14), (label, 0.42), (skin, 0.44), side=192)
    head = textures.speckles(
        look.rng, look.own_color("white", "red", "blue", "black", "green"), 3, 32
    )
    collar = cylinder(0.44 * r, 0.018, 18, bevel=0.001).move(z=h - 0.008)
    top = box(0.07, 0.022, 0.022).bend(
        lambda p: np.column_stack([p[:, 0], p[:, 1], p[:, 2] - 0.1 * (p[:, 0] + 0.02)])
    )
    nose = cylinder(0.008, 0.014, 14).turn(1, -np.pi / 2).move(x=-0.04, z=h + 0.026)
    trigger = tube(smooth([(-0.022, 0, h + 0.014), (-0.032, 0, h - 0.006), (-0.046, 0, h - 0.034)]),
                   0.0045, 8)  # fmt: skip
    return shape(
        [(body, tile), (join([collar, top.move(x=-0.006, z=h + 0.012), trigger]), head),
         (nose, textures.plain((60, 62, 68)))],
        [hull_part(body.vertices[body.vertices[:, 2] < 0.76 * h]),
         hull_part(body.vertices[body.vertices[:, 2] > 0.7 * h]),
         box_part(0.066, 0.02, 0.02, (-0.006, 0, h + 0.014)), hull_of(trigger)],
    )  # fmt: skip


def egg_carton(look: Look) -> Shape:
    """An open carton of eggs; empty, with as many ``places`` as the attribute says."""
    rows, pitch = 2, 0.048
    columns = int(look.pick([3, 5]))
    empty = look.attributes.get("state") == "empty"
    if "places" in look.attributes:
        columns, pitch = -(-int(look.attributes["places"]) // rows), 0.052
    color = look.color("gray", "beige", "sage", "lavender", "sky")
    pulp = textures.spots(look.rng, color, tint_color(color, 0.8), 0.1)
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
    pieces += [(join(some), textures.speckles(look.rng, look.own_color(name), 4))
               for name, some in eggs.items() if some]  # fmt: skip
    if not empty:
        return shape(pieces, [*frame_parts(x, y, h, 0.008, 0.01), hull_of(lid)])
    walls = [box_part(0.002, y, h, (pitch * (i - columns / 2), 0, 0)) for i in range(columns + 1)]
    walls += [box_part(x, 0.002, h, (0, pitch * (j - rows / 2), 0)) for j in range(rows + 1)]
    return shape(pieces, [box_part(x, y, floor), *walls, hull_of(lid)])


CATEGORIES = (
    Category("meat_can", meat_can, (0.1, 0.06, 0.083), 0.37,
             ("spam", "spam can", "luncheon meat", "canned meat", "potted meat can", "ham can",
              "rectangular can"), ("kitchen", "food"), (), ("navy", "blue")),
    Category("coffee_bag", coffee_bag, (0.1, 0.063, 0.2), 0.27,
             ("bag of coffee", "bag of coffee beans", "coffee packet", "coffee", "coffee pouch"),
             ("kitchen", "coffee"), ("tall",), ("brown", "black")),
    Category("chips_bag", chips_bag, (0.17, 0.22, 0.047), 0.12,
             ("bag of chips", "chip bag", "crisps", "potato chips", "chips", "snack bag",
                 "snack", "crisp packet",
             "packet of crisps", "packet of chips", "pack of crisps", "bag of crisps"),
             ("living", "dining"), ("flat",), ("red", "yellow"), state="lying flat"),
    Category("tea_tin", tea_tin, (0.078, 0.078, 0.122), 0.18,
             ("tea caddy", "tin of tea", "tea canister", "coffee tin", "tobacco tin", "pill case",
             "snuff box", "bait tin", "formula tin", "mess tin", "bar keeper's tin", "etui",
             "vesta case", "ant trap"),
             ("kitchen", "tea"), (), ("green", "red")),
    Category("wipes_canister", wipes_canister, (0.083, 0.083, 0.21), 0.35,
             ("wipes", "cleaning wipes", "disinfecting wipes", "wipe canister"),
             ("kitchen", "office"), ("tall", "round"), ("yellow", "green")),
    Category("tissue_box", tissue_box, (0.19, 0.114, 0.145), 0.16,
             ("box of tissues", "tissues", "facial tissues", "kleenex", "kleenex box"),
             ("living", "office", "vanity"), (), ("sky", "white")),
    Category("paper_cup", paper_cup, (0.087, 0.087, 0.125), 0.26,
             ("takeaway cup", "takeaway coffee", "coffee to go", "to go cup", "disposable cup",
              "takeout cup", "takeout coffee", "takeaway coffee cup", "paper coffee cup"),
             ("office", "coffee"), ("tall", "round"), ("white", "brown")),
    Category("spray_bottle", spray_bottle, (0.09, 0.057, 0.2), 0.5,
             ("cleaning spray", "spray cleaner", "trigger bottle", "window cleaner", "mister",
             "screen cleaning kit", "hand sanitizer spray"),
             ("kitchen", "workbench"), ("tall",), ("sky", "white")),
    Category("egg_carton", egg_carton, (0.21, 0.12, 0.08), 0.5,
             ("carton of eggs", "box of eggs", "egg box", "egg tray", "tray of eggs"),
             ("kitchen", "food"), (), ("gray", "beige"), state="lying open"),
)  # fmt: skip
"""The module's categories."""
