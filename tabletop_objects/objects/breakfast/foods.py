"""Objects of the ``breakfast`` theme: dishes and other food."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import skin
from ...kit.outlines import ellipse
from ...kit.parts import box_part, cylinder_part, hull_above, hull_of, hull_part
from ...kit.primitives import bent_rod, limb, lobe, scatter, spread, vessel
from ...kit.shapes import Shape, category, serve, settle, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, loft, prism, torus
from ...kit.surfaces import RGB, Look, readable_on, speck, tint_color
from ..dining.foods import filled_bowl, pool


@category("omelette", size=(0.178, 0.0862, 0.0264), mass=0.15, material="food",
          aliases=("omelet", "folded omelette", "frittata", "tamagoyaki"), themes=("breakfast",),
          roles=("edible", "flat"), colors=("yellow",), state="lying flat")  # fmt: skip
def omelette(look: Look) -> Shape:
    """A folded omelette with herbs."""
    k = look.between(0.9, 1.1)
    a = np.linspace(0, np.pi, 16)
    half = np.column_stack([0.09 * np.cos(a), 0.075 * np.sin(a) - 0.03])
    low, top = prism(half, 0, 0.012, 0.004), prism(half * 0.97, 0.0118, 0.026, 0.005)
    egg = surfaces.spots(look.rng, tint_color(look.color("yellow", "amber"), 1.1), (226, 160, 70),
                         0.16)  # fmt: skip
    herbs = scatter(look, 0.045, 18, (0.003, 0.005), 0.026, stretch=(1.2, 0.5, 0.3))
    return shape([(join([low, top]), egg), (herbs, surfaces.plain((80, 130, 60)))],
                 [hull_of(low), hull_of(top)]).scale(k)  # fmt: skip


@category("scrambled_eggs", size=(0.1, 0.101, 0.0308), mass=0.12, material="food",
          aliases=("heap of scrambled egg", "scrambled egg", "scrambled egg heap",
          "bowl of scrambled eggs"), themes=("breakfast",), roles=("edible",), colors=("yellow",),
          state="lying flat")  # fmt: skip
def scrambled_eggs(look: Look) -> Shape:
    """A heap of scrambled egg with chives."""
    x = look.between(0.095, 0.11)
    heap = []
    for k in range(30):
        away, turn = 0.42 * x * np.sqrt((k + 0.5) / 30), 2.4 * k
        size = look.between(0.02, 0.03), look.between(0.018, 0.026)
        one = ellipsoid(*size, 0.017, 10, 6).turn(2, k)
        heap.append(
            one.move(away * np.cos(turn), away * np.sin(turn), 0.009 + 0.016 * (1 - k / 30))
        )
    egg = surfaces.speckles(look.rng, tint_color(look.color("yellow", "yellow", "amber"), 1.25), 10)
    chives = scatter(look, 0.3 * x, 10, (0.004, 0.006), 0.032, stretch=(1, 0.5, 0.4))
    return settle([(join(heap), egg), (chives, surfaces.plain((80, 140, 60)))], 0.05)


@category("black_pudding", size=(0.0589, 0.0593, 0.0143), mass=0.03, material="food",
          aliases=("black pudding slice", "blood sausage", "slice of black pudding",
          "white pudding"), themes=("breakfast",), roles=("edible", "round", "flat"),
          colors=("black",), state="lying flat")  # fmt: skip
def black_pudding(look: Look) -> Shape:
    """A round slice of black pudding with pieces of pale fat."""
    r, h = look.between(0.027, 0.033), look.between(0.012, 0.016)
    color = look.color("black", "charcoal", "maroon")
    tile = speck(surfaces.speckles(look.rng, tint_color(color, 0.9), 6), look.rng, (206, 190, 176),
                 20, 5)  # fmt: skip
    body = cylinder(r, h, 26, bevel=0.0015)
    face = cylinder(0.95 * r, 0.0008, 26).move(z=h - 0.0004)
    return shape([(body, surfaces.plain(tint_color(color, 0.7))), (face, tile)],
                 [cylinder_part(r, h)])  # fmt: skip


@category("bowl_of_cereal", size=(0.196, 0.158, 0.0904), mass=0.6, material="ceramic",
          assembled=True, aliases=("cereal with milk", "bowl of cornflakes", "cereal and milk",
          "bowl of muesli", "bowl of granola", "muesli", "granola", "cornflakes"),
          themes=("breakfast",), roles=("edible", "round"), colors=("white", "sky"))  # fmt: skip
def bowl_of_cereal(look: Look) -> Shape:
    """A bowl of cereal in milk with a spoon."""
    r, h, dish, tile = filled_bowl(look, "white", "sky", "pink", "yellow", "navy")
    milk = pool(r, 0.4 * h, 0.8 * h)
    kind = look.pick(["rings", "flakes", "balls"])
    tone = look.pick([(224, 164, 80), (206, 140, 66), (140, 86, 50)])
    if kind == "rings":
        one = torus(0.0052, 0.0024, 12, 6)
        bits = join([one.turn(0, look.between(-0.5, 0.5)).move(
            a * np.cos(2.4 * n), a * np.sin(2.4 * n), 0.81 * h) for n in range(22)
            for a in [0.74 * r * np.sqrt((n + 0.5) / 22)]])  # fmt: skip
    else:
        flat = (1, 0.8, 0.3) if kind == "flakes" else (1, 1, 1)
        bits = scatter(look, 0.76 * r, 34, (0.01, 0.014), 0.8 * h, dome=0.06 * h, stretch=flat)
    spoon = [limb([(0.35 * r, 0.2 * r, 0.86 * h), (0.9 * r, 0.4 * r, 1.2 * h),
                   (1.45 * r, 0.62 * r, 1.45 * h)], [0.003, 0.0028, 0.0042], 8)]  # fmt: skip
    steel = surfaces.brushed_metal(look.rng, (190, 193, 198))
    food = [
        (milk, surfaces.plain((250, 249, 244))),
        (bits, surfaces.spots(look.rng, tone, tint_color(tone, 0.75), 0.2)),
    ]
    made = serve(look, dish, tile, food)
    return shape([*((p.solid, p.tile) for p in made.pieces), (join(spoon), steel)],
                 [*made.parts, hull_of(*spoon)])  # fmt: skip


@category("oatmeal", size=(0.157, 0.157, 0.065), mass=0.6, material="ceramic", aliases=("porridge",
          "bowl of porridge", "bowl of oatmeal", "bowl of oats", "acai bowl", "smoothie bowl",
          "yogurt bowl", "bowl of yogurt"), themes=("breakfast",), roles=("edible", "round"),
          colors=("white",))  # fmt: skip
def oatmeal(look: Look) -> Shape:
    """A bowl of porridge with berries and banana slices."""
    r, h, dish, tile = filled_bowl(look)
    porridge = lathe([(0, 0.4 * h), (0.6 * r, 0.4 * h), (0.89 * r, 0.82 * h), (0.5 * r, 0.9 * h),
                      (0, 0.92 * h)], 30)  # fmt: skip
    oats = surfaces.spots(look.rng, (226, 204, 164), (196, 164, 116), 0.3)
    berries = scatter(look, 0.3 * r, 9, (0.011, 0.015), 0.93 * h)
    rounds = [cylinder(0.0115, 0.005, 18, bevel=0.001).turn(0, 0.2).move(
        -0.42 * r + 0.01 * n, (0.3 - 0.26 * n) * r, 0.88 * h) for n in range(4)]  # fmt: skip
    food = [(porridge, oats), (berries.move(0.3 * r, 0), surfaces.plain(
        look.own_color("navy", "crimson", "purple"))),
            (join(rounds), surfaces.plain((248, 232, 180)))]  # fmt: skip
    return serve(look, dish, tile, food)


@category("sausage", size=(0.148, 0.0381, 0.0263), mass=0.08, material="food", aliases=("bratwurst",
          "frankfurter", "grilled sausage", "sausage link", "wiener", "chorizo"),
          themes=("breakfast", "dining"), roles=("edible",), colors=("brown",),
          state="lying flat")  # fmt: skip
def sausage(look: Look) -> Shape:
    """A curved grilled sausage lying flat, with its tied ends visible."""
    long, r = look.between(0.115, 0.145), look.between(0.0125, 0.0155)
    bend = look.between(0.006, 0.022)
    body = bent_rod(long, r, bend=bend, blunt=8)
    knots = [ellipsoid(0.012, 0.008, 0.008, 8, 6).move(s * 0.51 * long, 0.5 * bend)
             for s in (-1, 1)]  # fmt: skip
    color = look.color("terracotta", "copper", "maroon", "brown")
    marks = [ellipsoid(0.02, 0.004, 0.004, 8, 5).turn(2, 0.7).move(u * long, bend * (
             4 * u * u - 0.5), 0.9 * r) for u in (-0.3, -0.15, 0.0, 0.15, 0.3)]  # fmt: skip
    meat = skin(look, color, tint_color(color, 0.66), 0.7)
    return settle([(join([body, *knots]), meat),
                   (join(marks), surfaces.plain(tint_color(color, 0.45)))], 0.1)  # fmt: skip


@category("bacon", size=(0.198, 0.0359, 0.0106), mass=0.02, material="food", aliases=("bacon strip",
          "bacon slice", "bacon rasher", "rasher", "slice of bacon", "strip of bacon",
          "rasher of bacon", "piece of bacon"), themes=("breakfast",), roles=("edible", "flat"),
          state="lying flat")  # fmt: skip
def bacon(look: Look) -> Shape:
    """A wavy rasher of streaky bacon lying flat."""
    long, y, t = look.between(0.17, 0.21), look.between(0.028, 0.036), 0.0028
    n = 30
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, n), np.linspace(-0.5, 0.5, 4))
    wave = 0.0042 * (1 + np.sin(2 * np.pi * (3.5 * u + look.between(0, 1))))
    edge = 0.002 * np.sin(2 * np.pi * 2.3 * u)
    grid = np.stack([u * long, v * y + edge, wave], -1)
    solid = spread(grid, t)
    rows = np.linspace(0, 1, 64)[:, None] + 0.05 * surfaces.noise(look.rng, 64, 128, (2, 6), 2)
    fat = (np.sin(2 * np.pi * 2.2 * rows + 0.6) > 0.25)[..., None]
    color = look.color("crimson", "maroon", "terracotta")
    tile = np.where(fat, np.array((240, 206, 170)), np.array(tint_color(color, 0.9)))
    return settle([(solid, tile.astype(np.uint8))], 0.05)


@category("fried_egg", size=(0.101, 0.103, 0.0155), mass=0.05, material="food",
          aliases=("sunny side up egg", "egg sunny side up"), themes=("breakfast",),
          roles=("edible", "flat", "round"), colors=("yellow",), state="lying flat")  # fmt: skip
def fried_egg(look: Look) -> Shape:
    """A fried egg lying flat with its yolk up."""
    r = look.between(0.045, 0.055)
    ring = ellipse(2, 2, 36)
    turn = np.arctan2(ring[:, 1], ring[:, 0])
    wave = 1 + 0.07 * np.sin(3 * turn + look.between(0, 6)) + 0.05 * np.sin(
        5 * turn + look.between(0, 6))  # fmt: skip
    levels = [(0.97, 0), (1.0, 0.002), (0.94, 0.0036), (0.5, 0.0046), (0.1, 0.0056)]
    white = loft(np.stack([np.column_stack([ring * (r * k * wave)[:, None], np.full(36, z)])
                           for k, z in levels]), ring)  # fmt: skip
    edge = surfaces.plain((222, 184, 120))
    pale = surfaces.speckles(look.rng, (248, 246, 240), 4)
    at = (look.between(-0.1, 0.1) * r, look.between(-0.1, 0.1) * r)
    yolk = ellipsoid(0.78 * r, 0.78 * r, 0.021, 24, 10).move(*at, 0.005)
    color = look.color("yellow", "orange", "amber")
    tile = surfaces.stack((edge, 12), (pale, 88))
    return shape([(white, tile), (yolk, surfaces.speckles(look.rng, color, 5))],
                 [hull_of(white), hull_above(yolk)])  # fmt: skip


DARK: RGB = (150, 94, 46)


@category("waffle", size=(0.113, 0.113, 0.0225), mass=0.08, material="food",
          aliases=("belgian waffle",), themes=("breakfast",), roles=("edible", "flat"),
          colors=("amber",), state="lying flat")  # fmt: skip
def waffle(look: Look) -> Shape:
    """A square or round waffle with deep pockets."""
    x, t = look.between(0.1, 0.125), look.between(0.016, 0.02)
    round_ = look.chance(0.4)
    base = cylinder(x / 2, 0.6 * t, 36) if round_ else block(x, x, 0.6 * t, 0.008)
    ribs = []
    for k in range(6):
        at = (k / 5 - 0.5) * 0.94 * x
        long = 2 * np.sqrt(max(0.25 * x * x - at * at, (0.1 * x) ** 2)) if round_ else x
        rib = box(0.98 * long, 0.05 * x, t)
        ribs += [rib.move(y=at), rib.turn(2, np.pi / 2).move(x=at)]
    gold = skin(look, look.color("amber", "tan", "golden"), DARK, 0.6)
    pieces = [(base, surfaces.speckles(look.rng, (190, 124, 60), 8)), (join(ribs), gold)]
    parts = [cylinder_part(x / 2, t) if round_ else box_part(x, x, t)]
    if look.chance(0.5):
        pat = block(0.024, 0.024, 0.008, 0.003, 0.002).turn(2, 0.4).move(z=t - 0.0005)
        pieces.append((pat, surfaces.plain((250, 228, 130))))
        parts.append(hull_of(pat))
    return shape(pieces, parts)


@category("pancakes", size=(0.13, 0.13, 0.06), mass=0.35, material="food",
          aliases=("pancake stack", "stack of pancakes", "pancake", "hotcake", "plate of pancakes"),
          themes=("breakfast", "food"), roles=("round", "edible"), common=True)  # fmt: skip
def pancakes(look: Look) -> Shape:
    """A stack of pancakes with syrup and butter."""
    r, count = look.between(0.055, 0.07), int(look.rng.integers(3, 6))
    cakes, z = [], 0.0
    edge, brown = (238, 204, 140), look.own_color("copper", "brown", "amber")
    for _ in range(count):
        k = look.between(0.94, 1.04)
        dx, dy = look.rng.uniform(-0.003, 0.003, 2)
        cakes.append(cylinder(k * r, 0.0125, 30, bevel=0.0035).move(dx, dy, z))
        z += 0.012
    tile = surfaces.gradient(edge, tint_color(edge, 0.9), look.rng)
    faces = [cylinder(0.86 * r, 0.0009, 28).move(z=0.012 * (k + 1)) for k in range(count)]
    syrup = lobe(cylinder(0.62 * r, 0.003, 36, bevel=0.001), 5, 0.6).move(z=z)
    drips = [ellipsoid(0.013, 0.008, long, 10, 6).move(0, -r, z - long / 2).turn(2, 2.1 * k + 0.3)
             for k, long in enumerate(look.rng.uniform(0.016, 0.036, 3))]  # fmt: skip
    amber = surfaces.plain(look.own_color("brown", "maroon", "copper", "crimson"))
    butter = block(0.019, 0.019, 0.009, 0.003, 0.001).turn(2, 0.5).move(z=z + 0.002)
    return shape(
        [(join(cakes), tile), (join(faces), skin(look, brown, tint_color(brown, 1.2))),
         (join([syrup, *drips]), amber), (butter, surfaces.plain((250, 228, 132)))],
        [cylinder_part(0.96 * r, z), hull_of(butter)],
    )  # fmt: skip


@category("maple_syrup", size=(0.085, 0.06, 0.19), mass=0.5, material="glass", aliases=("syrup",
          "maple syrup bottle", "bottle of maple syrup", "pancake syrup", "syrup bottle",
          "bottle of syrup", "maple syrup jug"), themes=("breakfast", "kitchen"), roles=("tall",),
          colors=("brown", "amber"))  # fmt: skip
def maple_syrup(look: Look) -> Shape:
    """A flat bottle of maple syrup with a ring handle at its neck and a leaf on its label."""
    r, h = look.between(0.038, 0.046), look.between(0.16, 0.2)
    color = look.color("brown", "maroon", "amber", "bronze", "copper")
    syrup = tint_color(color, 0.75)
    body = vessel(r, h, 0.013, 0.5 * h, 0.78 * h)
    image = prints.canvas(256, 128, look.pick([(246, 240, 222), (196, 42, 40), (250, 226, 150)]))
    ground: RGB = tuple(float(c) for c in image[0, 0])  # type: ignore[assignment]
    front = image[:, 80:176]
    leaf = (196, 42, 40) if sum(ground) > 560 else (250, 244, 226)
    for a in (-1.25, -0.65, 0, 0.65, 1.25):
        tip = (0.5 + 0.3 * np.sin(a), 0.42 - 0.32 * np.cos(a))
        prints.polygon(front, [(0.42, 0.44), tip, (0.58, 0.44)], leaf)
    prints.fill(front, 0.485, 0.42, 0.03, 0.14, leaf)
    prints.write(front, look.pick(["MAPLE", "SYRUP", "ERABLE"]), 0.5, 0.76, 0.22,
                 readable_on(ground), bold=True)  # fmt: skip
    skin = surfaces.plain(syrup)
    tile = surfaces.stack((skin, 0.12), (image, 0.34), (skin, 0.54), side=192)
    tile = surfaces.fit(tile, 192, 256)
    ring = torus(0.013, 0.0045, 18, 8).turn(0, np.pi / 2).move(x=0.026, z=0.8 * h)
    cap = cylinder(0.0155, 0.02, 20, bevel=0.001).move(z=h - 0.006)
    tone = look.own_color("red", "black", "white", "gold", "brown")
    return shape(
        [(body.scale(1, 0.72, 1), tile), (ring, skin), (cap, surfaces.plain(tone))],
        [hull_part(body.vertices[body.vertices[:, 2] < 0.52 * h] * [1, 0.72, 1]),
         hull_part(body.vertices[body.vertices[:, 2] > 0.48 * h] * [1, 0.72, 1]),
         hull_of(ring), hull_of(cap)],
    )  # fmt: skip


def _panel(look: Look, title: str, color: RGB, ground: RGB, size: tuple[int, int]) -> surfaces.Tile:
    """Return the front of a box with a title on a curved band."""
    image = prints.canvas(*size, ground)
    prints.disc(image, 0.5, 1.1, 0.75, tint_color(color, 1.35))
    prints.fill(image, 0, 0.2, 1, 0.4, color)
    prints.write(image, title, 0.5, 0.41, 0.26, readable_on(color), bold=True)
    prints.lines(image, look.rng, (0.2, 0.7, 0.6, 0.16), 2, tint_color(color, 0.6))
    return image


@category("cream_cheese", size=(0.111, 0.0853, 0.0463), mass=0.24, material="paper",
          aliases=("cream cheese box", "box of cream cheese", "soft cheese", "cheese spread",
          "cream cheese tub"), themes=("breakfast", "kitchen"), colors=("blue",))  # fmt: skip
def cream_cheese(look: Look) -> Shape:
    """Cream cheese in a silvery, brick-shaped packet, or in a tub with a printed lid."""
    color = look.color("blue", "navy", "sky", "green", "teal", "red")
    ground = look.pick([(246, 246, 244), (206, 210, 216), (228, 236, 244)])
    word = look.pick(["CREAM", "CHEESE", "CREAM CHEESE", "SPREAD"])
    if look.chance(0.6):
        x, y, h = look.between(0.1, 0.125), look.between(0.055, 0.07), look.between(0.034, 0.042)
        side = _panel(look, word, color, ground, (160, 64))
        top = _panel(look, word, color, ground, (160, 88))
        lid = box(x, y, 0.0006).move(z=h - 0.0003)
        return shape([(box(x, y, h), side), (lid, top)], [box_part(x, y, h)])
    r, h = look.between(0.048, 0.056), look.between(0.045, 0.06)
    band = surfaces.fit(_panel(look, word, color, ground, (128, 64)), 64, 128)
    tub = lathe([(0, 0), (0.84 * r, 0), (0.97 * r, 0.8 * h), (0, 0.8 * h)], 34, v=[0, 0, 1, 1])
    wrap = np.concatenate([band, band, band], axis=1)
    lid = cylinder(r, 0.24 * h, 34, bevel=0.002).move(z=0.76 * h)
    disc = cylinder(0.9 * r, 0.0006, 34).move(z=h - 0.0003)
    return shape([(tub, wrap), (lid, surfaces.plain(ground)),
                  (disc, _panel(look, word, color, ground, (128, 128)))],
                 [hull_of(tub), cylinder_part(r, 0.24 * h, (0, 0, 0.76 * h))])  # fmt: skip


@category("yogurt", size=(0.0866, 0.0774, 0.0884), mass=0.18, material="plastic",
          aliases=("yoghurt", "yogurt cup", "cup of yogurt", "yoghurt pot", "pot of yoghurt",
          "yogurt pot", "skyr", "yoghurt cup", "yogurt container"), themes=("breakfast", "kitchen"),
          roles=("round",), colors=("pink", "sky"))  # fmt: skip
def yogurt(look: Look) -> Shape:
    """A cup of yoghurt with a foil lid and fruit printed on its side, sometimes open."""
    r, h = look.between(0.034, 0.042), look.between(0.075, 0.1)
    color = look.color("pink", "sky", "violet", "green", "orange", "crimson", "yellow", "blue")
    image = prints.label(look.rng, look.pick(["YOGURT", "YOGHURT", "SKYR", "GREEK"]), color,
                         (248, 247, 243))  # fmt: skip
    white = surfaces.plain((248, 247, 243))
    body = lathe([(0, 0), (0.72 * r, 0), (0.94 * r, 0.95 * h), (r, 0.96 * h), (r, h - 0.001),
                  (0, h - 0.001)], 30, v=[0, 0, 0.93, 0.95, 0.97, 1])  # fmt: skip
    tile = surfaces.stack((image, 94), (white, 6), side=160)
    foil = cylinder(1.01 * r, 0.0012, 34).move(z=h - 0.001)
    flap = box(0.018, 0.016, 0.0012).move(x=1.02 * r, z=h - 0.001)
    lid = prints.canvas(96, 96, (222, 224, 230))
    prints.disc(lid, 0.5, 0.5, 0.44, color)
    prints.disc(lid, 0.5, 0.5, 0.4, tint_color(color, 1.5))
    prints.write(lid, "YOGURT", 0.5, 0.5, 0.16, tint_color(color, 0.5), bold=True)
    return shape([(body, tile), (foil, lid), (flap, surfaces.plain((222, 224, 230)))],
                 [hull_of(body), cylinder_part(1.01 * r, 0.003, (0, 0, h - 0.003))])  # fmt: skip
