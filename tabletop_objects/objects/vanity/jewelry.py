"""Objects of the ``vanity`` theme: jewelry."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, glaze_tile
from ...kit.outlines import rectangle
from ...kit.parts import box_part, frame_parts, hull_of, hull_part, open_vessel, ring_parts
from ...kit.primitives import ball, facing, lay_down, rod, standing, straight
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    open_box,
    prism,
    sweep,
    torus,
    tube,
)
from ...kit.surfaces import Look, readable_on, tint_color


@category("drawstring_pouch", size=(0.09, 0.086, 0.078), mass=0.08, material="leather",
          aliases=("leather pouch", "coin pouch", "drawstring bag", "velvet pouch", "jewelry pouch",
          "jewellery pouch", "bag of marbles pouch"), themes=("vanity",),
          colors=("brown",))  # fmt: skip
@from_pieces(bodies=1)
def drawstring_pouch(look: Look) -> Pieces:
    """A plump pouch tied shut below its mouth, with two cord ends hanging on the right."""
    color = look.color("brown", "tan", "maroon", "black", "purple")
    body = standing((0.03, 0), (0.042, 0.01), (0.043, 0.03), (0.03, 0.052), (0.012, 0.062),
                    (0.022, 0.078), sides=20)  # fmt: skip
    cord = torus(0.0128, 0.0035, 20, 6).move(z=0.062)
    tails = [rod([(0.012, s * 0.008, 0.062), (0.03, s * 0.012, 0.05), (0.045, s * 0.016, 0.025)],
                 0.002, 6) for s in (-1, 1)]  # fmt: skip
    return [(body, look.surface(color, "speckled")), (cord, dye(look, "beige", "gold")),
            (join(tails), dye(look, "beige", "gold"))]  # fmt: skip


@category("wristwatch", size=(0.041, 0.062, 0.052), mass=0.07, material="metal", assembled=True,
          aliases=("watch", "wrist watch", "smartwatch", "smart watch", "hand watch",
          "digital watch", "nurse watch", "gold watch", "kid watch", "kids watch", "swatch",
          "chronograph", "fitness tracker", "fitness band", "watch strap", "smart band"),
          themes=("vanity", "office"), colors=("brown", "black"), state="lying, strap closed",
          common=True)  # fmt: skip
def wristwatch(look: Look) -> Shape:
    """A wristwatch with its strap closed, lying with its dial up."""
    r = look.between(0.018, 0.022)
    smart = look.chance(0.35)
    strap_color = look.color("brown", "black", "silver", "navy", "red", "teal", "tan")
    metal = surfaces.brushed_metal(look.rng, look.own_color("silver", "gold", "charcoal", "copper"))
    ry, rz = look.between(0.027, 0.03), look.between(0.021, 0.024)
    a = np.linspace(0, 2 * np.pi, 33)[:-1]
    path = np.column_stack([np.zeros(32), ry * np.sin(a), rz + rz * np.cos(a)])
    width = 1.05 * r
    strap = sweep(path, rectangle(width, 0.003, 0.001, 1), loop=True)
    strap = strap.move(z=-float(strap.vertices[:, 2].min()))
    top = float(strap.vertices[:, 2].max())
    if smart:
        case = block(1.7 * r, 2.0 * r, 0.009, 0.006, 0.002).move(z=top - 0.004)
        glass = block(1.5 * r, 1.8 * r, 0.0012, 0.005).move(z=top + 0.0045)
        face = prints.canvas(64, 80, (18, 20, 24))
        prints.write(face, f"{look.rng.integers(1, 13)}:{look.rng.integers(10, 60)}", 0.5, 0.35,
                     0.26, (240, 240, 244), bold=True)  # fmt: skip
        for k, ink in enumerate([(230, 70, 90), (120, 220, 90), (80, 190, 230)]):
            prints.disc(face, 0.25 + 0.25 * k, 0.74, 0.09, ink)
    else:
        case = cylinder(r, 0.009, 30, bevel=0.0015).move(z=top - 0.004)
        glass = cylinder(0.87 * r, 0.0012, 28).move(z=top + 0.0045)
        ground = look.own_color("white", "navy", "black", "cream", "green")
        face = prints.clock_face(look.rng, ground, readable_on(ground))
    crown = lay_down(cylinder(0.003, 0.004, 10), 0.98 * r if not smart else 0.83 * r, top + 0.0005)
    band = surfaces.stripes([strap_color, tint_color(strap_color, 0.82)], 14)
    return shape(
        [(strap, band), (join([case, crown]), metal), (glass, face)],
        [box_part(width, 1.1 * ry, 0.004),
         *(hull_part(strap.vertices[(s * strap.vertices[:, 1] > 0.45 * ry)]) for s in (-1, 1)),
         hull_of(case)],
    )  # fmt: skip


@category("trinket_dish", size=(0.105, 0.105, 0.021), mass=0.09, material="ceramic", hollow=True,
          aliases=("ring dish", "jewelry dish", "jewellery dish", "trinket tray", "key dish",
          "trinket bowl", "ring tray", "coin dish"), themes=("vanity",),
          roles=("container", "round", "support"), colors=("white", "pink"))  # fmt: skip
def trinket_dish(look: Look) -> Shape:
    """A small, gold-rimmed dish for rings and trinkets."""
    r = look.between(0.045, 0.06)
    color = look.color("white", "pink", "sage", "navy", "cream", "teal", "lavender")
    body, parts = open_vessel([(0.6 * r, 0), (0.9 * r, 0.008), (r, 0.02)], 0.0035, 0.004)
    rim = torus(0.985 * r, 0.0018, 32, 6).move(z=0.0195)
    return shape(
        [(body, look.surface(color, "ceramic")), (rim, surfaces.plain((222, 184, 96)))], parts
    )


@category("ring_box", size=(0.056, 0.07, 0.075), mass=0.08, material="leather",
          aliases=("ring holder", "watch case", "earring box", "cufflink box"), themes=("vanity",),
          colors=("navy",), state="standing open", common=True)  # fmt: skip
def ring_box(look: Look) -> Shape:
    """A small open jewellery box with a ring in it."""
    velvet = surfaces.fabric(look.rng, look.color(
        "navy", "crimson", "green", "black", "violet", "teal", "pink", "white", "brown"
    ))  # fmt: skip
    cushion = surfaces.plain(look.pick([(236, 228, 214), (40, 40, 46), (150, 30, 50)]))
    gold = surfaces.plain(look.pick([(214, 176, 88), (204, 206, 210), (216, 150, 120)]))
    base = block(0.056, 0.056, 0.028, 0.006, 0.002)
    pad = box(0.044, 0.044, 0.002).move(z=0.0275)
    lid = block(0.056, 0.02, 0.05, 0.004, 0.002).turn(0, np.deg2rad(-14)).move(y=0.032, z=0.026)
    ring = torus(0.0095, 0.0016, 24, 8).turn(0, np.pi / 2).move(z=0.036)
    gem = ellipsoid(0.006, 0.006, 0.006, 10, 6).move(z=0.048)
    return shape([(base, velvet), (pad, cushion), (lid, velvet), (ring, gold),
                  (gem, surfaces.plain((220, 238, 250)))], [box_part(0.056, 0.056, 0.029),
                                                            hull_of(lid),
                                                            box_part(0.02, 0.005, 0.02,
                                                                     (0, 0, 0.029))])  # fmt: skip


@category("jewelry_box", size=(0.185, 0.18, 0.19), mass=0.7, material="wood", assembled=True,
          aliases=("jewellery box", "jewel box", "jewelry case", "trinket box", "jewellery case"),
          themes=("vanity",), roles=("big",), colors=("brown", "pink"),
          state="standing open")  # fmt: skip
def jewelry_box(look: Look) -> Shape:
    """An open jewellery box with a mirror in its lid and a cushioned tray of pearls and rings."""
    x, y, h = look.between(0.16, 0.21), look.between(0.12, 0.15), look.between(0.06, 0.08)
    color = look.color("brown", "white", "pink", "maroon", "teal", "black", "wooden", "cream")
    skin = look.surface(color, look.pick(["wood", "leather"]))
    velvet = surfaces.speckles(
        look.rng, look.own_color("crimson", "navy", "cream", "purple", "pink"), 8
    )
    gold = surfaces.brushed_metal(look.rng, (212, 172, 82))
    case = join(open_box(x, y, h, 0.008, 0.008))
    bed = box(x - 0.016, y - 0.016, h - 0.022).move(z=0.008)
    lean = look.between(0.2, 0.4)
    lid = box(x, 0.014, 0.9 * y).turn(0, -lean).move(y=y / 2 + 0.004, z=h - 0.004)
    glass = box(0.84 * x, 0.001, 0.74 * y).turn(0, -lean)
    glass = glass.move(y=y / 2 + 0.004 - 0.0078 * np.cos(lean), z=h + 0.008)
    shine = surfaces.gradient((150, 172, 184), (226, 236, 240), look.rng, 3)
    top = h - 0.014
    t = np.linspace(0, 2 * np.pi, 22, endpoint=False)
    beads = [ellipsoid(0.0085, 0.0085, 0.0085, 8, 6).move(-0.2 * x + 0.03 * np.cos(a), 0.026
                                                          * np.sin(a), top + 0.004)
             for a in t]  # fmt: skip
    rings = [torus(0.0085, 0.0015, 16, 6).turn(0, np.pi / 2 - 0.2).move((0.14 + 0.12 * n) * x,
                                                                          -0.18 * y, top + 0.006)
             for n in range(3)]  # fmt: skip
    gems = [ellipsoid(0.007, 0.006, 0.006, 8, 5).move((0.14 + 0.12 * n) * x, -0.18 * y, top + 0.016)
            for n in range(3)]  # fmt: skip
    lock = facing(block(0.016, 0.02, 0.004, 0.004)).move(y=-y / 2, z=0.7 * h)
    pieces = [(join([case, lid]), skin), (bed, velvet), (glass, shine),
              (join(beads), surfaces.plain((246, 242, 234))), (join([*rings, lock]), gold),
              (join(gems), surfaces.plain(look.own_color("red", "cyan", "green",
                                                         "violet")))]  # fmt: skip
    return shape(pieces, [*frame_parts(x, y, h, 0.008, 0.008),
                          box_part(x - 0.016, y - 0.016, h - 0.014), hull_of(lid)])  # fmt: skip


@category("ring", size=(0.0226, 0.0263, 0.0072), mass=0.006, material="metal", assembled=True,
          aliases=("finger ring", "wedding ring", "engagement ring", "gold ring", "diamond ring",
          "wedding band", "posy ring", "jump ring", "curtain ring", "shower curtain ring",
          "split ring", "towel ring", "teething ring", "toe ring", "signet ring", "bishop ring",
          "nose ring", "friendship ring", "eternity ring", "signet seal ring", "engagement band"),
          themes=("vanity",), roles=("flat",), colors=("gold", "silver"),
          state="lying flat")  # fmt: skip
def ring(look: Look) -> Shape:
    """A finger ring with a stone, or a plain band, lying flat."""
    k = look.between(0.95, 1.15)
    color = look.color("gold", "silver", "gold", "copper", "silver")
    metal = look.surface(color, "metal")
    wide = look.between(0.002, 0.004)
    band = (lathe([(0.0088, -wide), (0.0102, -wide), (0.0106, 0), (0.0102, wide), (0.0088, wide)],
                  34, loop=True).scale(k, k, k).move(z=wide * k))  # fmt: skip
    angles = np.linspace(0, 2 * np.pi, 11)[:-1]
    parts = [box_part(0.0055 * k, 0.0055 * k, 2 * wide * k, (0.0075 * k * np.cos(a), 0.0075 * k
                                                             * np.sin(a), 0))
             for a in angles]  # fmt: skip
    pieces = [(band, metal)]
    if look.chance(0.75):
        gem = lathe(
            [(0, -0.003), (0.0036, 0.0005), (0.0024, 0.0022), (0, 0.0022)], look.pick([8, 6])
        )
        gem = gem.scale(k, k, k).turn(0, np.pi / 2).move(y=-0.0128 * k, z=wide * k)
        claw = cylinder(0.003 * k, 0.004 * k, 10).turn(0, np.pi / 2).move(y=-0.0092 * k, z=wide * k)
        up = max(0.0, -float(min(gem.bounds[0, 2], claw.bounds[0, 2])))
        tone = look.own_color("sky", "red", "green", "violet", "white", "navy")
        pieces = [(band.move(z=up), metal), (claw.move(z=up), metal),
                  (gem.move(z=up), surfaces.plain(tone))]  # fmt: skip
        parts = [type(p)(p.vertices + np.array([0, 0, up]), p.kind, p.axis) for p in parts]
        parts.append(hull_of(pieces[1][0], pieces[2][0]))
    return shape(pieces, parts)


@category("necklace", size=(0.155, 0.126, 0.00812), mass=0.04, material="metal", assembled=True,
          aliases=("pearl necklace", "jewelry", "jewellery", "string of pearls", "pearls",
          "gold necklace", "bead necklace", "gold chain", "rosary chain", "lariat", "sautoir",
          "choker"), themes=("vanity",), roles=("flat",), colors=("white", "gold"),
          state="lying flat")  # fmt: skip
def necklace(look: Look) -> Shape:
    """A necklace in a loop (pearls, beads, or a chain with a pendant), or a short bracelet."""
    color = look.color("white", "ivory", "gold", "silver", "red", "teal", "violet", "sky")
    r = look.between(0.05, 0.075)
    count = 44
    t = 2 * np.pi * np.arange(count) / count
    wobble = 1 + 0.08 * np.sin(2 * t + look.between(0, 6)) + 0.05 * np.sin(3 * t)
    path = np.column_stack([1.15 * r * wobble * np.cos(t), 0.9 * r * wobble * np.sin(t)])
    d = 2 * np.pi * r / count * 0.92
    kind = look.pick(["pearls", "chain", "beads"])
    pieces: list[tuple[Solid, surfaces.Tile]] = []
    if kind == "chain":
        d = 0.0035
        metal = look.own_color("gold", "silver", "copper")
        line = tube(np.column_stack([path, np.full(count, 0.5 * d)]), 0.5 * d, 6, loop=True)
        pieces.append((line, surfaces.stripes([metal, tint_color(metal, 0.55)], 60, side=240)))
    else:
        other = surfaces.plain(look.own_color("white", "gold", "navy", "coral", "mint"))
        main = surfaces.plain(color)
        one = ellipsoid(d, d, d, 8, 5)
        odd = [one.move(x, y, 0.5 * d) for x, y in path[1::2]]
        even = [one.move(x, y, 0.5 * d) for x, y in path[::2]]
        pieces += [(join(even), main), (join(odd), main if kind == "pearls" else other)]
    low = path[int(np.argmin(path[:, 1]))]
    if kind != "pearls":
        drop = _heart(0.016).move(low[0], low[1] - 0.014)
        pieces.append((drop, look.surface(color, "metal")))
    parts = []
    for k in range(0, count, 2):
        near = path[[k, (k + 1) % count, (k + 2) % count]]
        points = np.concatenate([np.column_stack([near + np.array([dx, dy]), np.full(3, z)])
                                 for dx in (-0.3 * d, 0.3 * d) for dy in (-0.3 * d, 0.3 * d)
                                 for z in (0, d)])  # fmt: skip
        parts.append(hull_part(points))
    return shape(pieces, parts)


def _heart(size: float) -> Solid:
    """Return a flat heart on z = 0 that points to -y and is ``size`` wide."""
    t = np.linspace(0, 2 * np.pi, 26)[:-1]
    x = 16 * np.sin(t) ** 3
    y = 13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)
    outline = np.column_stack([x, y])[::-1] * size / 34
    return loft(np.stack([np.column_stack([outline, np.full(len(outline), z)])
                          for z in (0, 0.004)]), outline)  # fmt: skip


@category("bracelet", size=(0.0676, 0.0676, 0.014), mass=0.025, material="metal", assembled=True,
          aliases=("bangle", "wristband", "beaded bracelet", "worry beads", "gold torc", "torc",
          "sweatband", "wrist band", "captain's armband", "loom band", "anklet", "ankle bracelet",
          "friendship bracelet", "charm bracelet"), themes=("vanity",), roles=("flat", "round"),
          colors=("gold", "silver"), state="lying flat")  # fmt: skip
def bracelet(look: Look) -> Shape:
    """A bangle, a bracelet of beads, or an open cuff, lying flat."""
    r = look.between(0.029, 0.035)
    color = look.color(
        "gold", "silver", "copper", "teal", "red", "wooden", "black", "violet", "sky"
    )
    metal = look.surface(color, "metal")
    angles = np.linspace(0, 2 * np.pi, 15)[:-1]
    if look.chance(0.5):
        wide = look.between(0.004, 0.011)
        band = lathe([(r - 0.0025, 0), (r, 0.0006), (r + 0.0006, wide), (r, 2 * wide - 0.0006),
                      (r - 0.0025, 2 * wide)], 40, loop=True)  # fmt: skip
        tile = metal if look.chance(0.5) else glaze_tile(look, color)
        return shape(
            [(band, tile)],
            [*ring_parts([(r, 0), (r, 2 * wide)], [(r - 0.0025, 2 * wide), (r - 0.0025, 0)])],
        )
    count = 20
    d = 2 * np.pi * r / count * 0.95
    other = surfaces.plain(look.own_color("white", "gold", "navy", "coral", "mint", "black"))
    bead = ellipsoid(d, d, d, 12, 8)
    at = [(r * np.cos(2 * np.pi * n / count), r * np.sin(2 * np.pi * n / count), 0.5 * d)
          for n in range(count)]  # fmt: skip
    step = look.pick([2, 4, 5])
    one = [bead.move(*p) for n, p in enumerate(at) if n % step]
    two = [bead.move(*p) for n, p in enumerate(at) if n % step == 0]
    parts = [box_part(0.9 * d, 0.9 * d, d, (r * np.cos(a), r * np.sin(a), 0)) for a in angles]
    return shape([(join(one), metal), (join(two), other)], parts)


GEMS = ("red", "blue", "green", "purple", "teal", "white", "pink", "amber")


def gold(look: Look, color: tuple[float, float, float]) -> surfaces.Tile:
    """Return a texture tile of brushed metal in ``color`` for a piece of jewellery."""
    return surfaces.brushed_metal(look.rng, color)


def _gem(r: float, h: float, sides: int = 8) -> Solid:
    """Return a cut stone on z = 0, with a girdle and a flat table on top."""
    return lathe([(0, 0), (0.55 * r, 0), (r, 0.45 * h), (0.6 * r, h), (0, h)], sides)


@category("earring", size=(0.045, 0.016, 0.008), mass=0.004, material="metal", assembled=True,
          aliases=("ear ring", "gold earring", "drop earring", "pearl earring", "hoop earring",
          "stud earring", "nose stud", "body piercing", "belly bar"), themes=("vanity",),
          colors=("gold", "silver"), state="lying")  # fmt: skip
def earring(look: Look) -> Shape:
    """An earring lying flat: a hook, a ring and a drop-shaped stone."""
    metal = gold(look, look.color("gold", "silver", "copper"))
    stone = look.own_color(*GEMS)
    k = look.between(0.9, 1.4)
    hook = rod([(0.012, 0, 0.001), (0.018, 0.006, 0.001), (0.027, 0.005, 0.001),
                (0.027, -0.004, 0.001), (0.018, -0.007, 0.001)], 0.0007, 6)  # fmt: skip
    ring = torus(0.003, 0.0007, 14, 6).move(0.0105, 0, 0.001)
    bezel = ellipsoid(0.019, 0.013, 0.004, 16, 8).move(-0.001, 0, 0.0018)
    drop = ellipsoid(0.015, 0.0095, 0.007, 10, 6).move(-0.001, 0, 0.0032)
    return put_down([(join([hook, ring, bezel]), metal),
                     (drop, surfaces.gradient(tint_color(stone, 0.8), tint_color(stone, 1.4),
                                              look.rng))], join([bezel, drop]), hook,
                    factor=k)  # fmt: skip


@category("brooch", size=(0.052, 0.052, 0.0125), mass=0.02, material="metal", aliases=("cameo",
          "pin badge", "badge", "broach", "flower brooch", "lapel pin", "fibula", "press pass",
          "enamel badge", "gold star sticker", "enamel pin", "aigrette"), themes=("vanity",),
          colors=("gold", "silver"), state="lying")  # fmt: skip
def brooch(look: Look) -> Shape:
    """A brooch lying flat: gold petals around a stone, or a cameo."""
    color = look.color("gold", "silver", "copper", "bronze")
    stone = look.own_color(*GEMS)
    k = look.between(0.9, 1.3)
    petals = [ellipsoid(0.018, 0.012, 0.006, 10, 6).move(0.0135).turn(2, 2 * np.pi * n / 8)
              .move(z=0.0025) for n in range(8)]  # fmt: skip
    beads = [ball(0.0045, 0.0045, 0.0045, (0.0215 * np.cos(a), 0.0215 * np.sin(a), 0.0045), 8)
             for a in 2 * np.pi * np.arange(8) / 8]  # fmt: skip
    base = cylinder(0.013, 0.005, 22)
    heart = _gem(0.0095, 0.007, 10).move(z=0.0045)
    return put_down([(join([*petals, base]), gold(look, color)),
                     (join(beads), surfaces.plain((246, 242, 234))),
                     (heart, surfaces.plain(stone))], join([*petals, base]), heart,
                    factor=k)  # fmt: skip


@category("cufflink", size=(0.0169, 0.0172, 0.0211), mass=0.008, material="metal",
          aliases=("cuff link",), themes=("vanity",), colors=("silver", "gold"),
          state="lying")  # fmt: skip
def cufflink(look: Look) -> Shape:
    """A cufflink standing on its bar: a post, and a disc with a stone on top."""
    color = look.color("silver", "gold", "black", "copper")
    k = look.between(0.9, 1.25)
    face = (cylinder(0.0085, 0.004, 22, bevel=0.0008) if look.chance(0.5) else
            block(0.015, 0.015, 0.004, 0.002, 0.0008))  # fmt: skip
    stone = cylinder(0.0062, 0.0012, 18).move(z=0.0035)
    post = straight((0, 0, -0.012), (0, 0, 0.001), 0.0017, 8)
    bar = straight((-0.0075, 0, -0.0125), (0.0075, 0, -0.0125), 0.0026, 10)
    whole = [(s.turn(0, 0.12), t) for s, t in (
        (join([face, post, bar]), gold(look, color)), (stone, surfaces.plain(look.own_color(
            "black", "navy", "red", "green", "white"))))]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s, _ in whole)
    whole = [(s.move(z=-low - 0.0004), t) for s, t in whole]
    return put_down(whole, whole[0][0], factor=k, foot=0.3)


@category("tie_clip", size=(0.059, 0.007, 0.0065), mass=0.008, material="metal",
          aliases=("tie pin", "tie bar", "tie clasp"), themes=("vanity",),
          colors=("silver", "gold"), state="lying")  # fmt: skip
def tie_clip(look: Look) -> Shape:
    """A tie clip lying flat: two flat bars joined at one end."""
    color = look.color("silver", "gold", "black", "copper", "bronze")
    k = look.between(0.9, 1.25)
    low = block(0.052, 0.006, 0.0013, 0.001)
    up = block(0.055, 0.0065, 0.0016, 0.001, 0.0004).move(z=0.0032)
    bend_ = cylinder(0.0024, 0.006, 12).move(z=-0.003).turn(0, np.pi / 2).move(0.027, 0, 0.0024)
    gem = _gem(0.0018, 0.0014).move(-0.02, 0, 0.0047)
    return put_down([(join([low, up, bend_]), gold(look, color)),
                     (gem, surfaces.plain((230, 240, 250)))], join([low, up]),
                    factor=k)  # fmt: skip


@category("pocket_watch", size=(0.088, 0.075, 0.0115), mass=0.09, material="metal", assembled=True,
          aliases=("pocketwatch", "fob watch", "watch on a chain", "antique watch",
          "watch movement", "nurse fob watch"), themes=("vanity", "office"),
          colors=("gold", "silver"), state="lying flat")  # fmt: skip
def pocket_watch(look: Look) -> Shape:
    """A pocket watch lying flat with its crown at the top and a curled chain beside it."""
    color = look.color("gold", "silver", "brass", "copper", "bronze")
    r = look.between(0.022, 0.027)
    case = lathe([(0, 0), (0.75 * r, 0), (r, 0.005), (r, 0.008), (0.88 * r, 0.0115),
                  (0.84 * r, 0.0105), (0, 0.0105)], 30)  # fmt: skip
    face = cylinder(0.84 * r, 0.0006, 30).move(z=0.0104)
    dial = prints.clock_face(look.rng, look.pick([(246, 242, 230), (240, 240, 240)]), (40, 38, 40))
    crown = straight((0, r - 0.001, 0.0065), (0, r + 0.006, 0.0065), 0.003, 10)
    bow = torus(0.0055, 0.0011, 16, 6).move(0, r + 0.0095, 0.0065)
    links: list[Solid] = []
    path = np.array([(0.006 + 0.0042 * n, r + 0.012 - 0.00035 * n * n) for n in range(14)])
    for n, (x, y) in enumerate(path):
        links.append(torus(0.0024, 0.0008, 8, 4).turn(0, 0.5 if n % 2 else -0.2).move(x, y, 0.0016))
    return put_down([(join([case, crown, bow]), gold(look, color)), (face, dial),
                    (join(links), gold(look, tint_color(color, 0.92)))], case, join([crown, bow]),
                   join(links))  # fmt: skip


@category("pendant", size=(0.093, 0.149, 0.00421), mass=0.015, material="metal", assembled=True,
          aliases=("locket", "heart pendant", "necklace with a pendant", "pendant necklace",
          "amulet", "gold pendant", "charm", "talisman", "amber pendant", "om pendant",
          "silver cross"), themes=("vanity",), roles=("flat",), colors=("gold", "silver"),
          state="lying flat")  # fmt: skip
def pendant(look: Look) -> Shape:
    """A pendant lying flat: a heart, a drop or a disc, with its chain in a loop."""
    color = look.color("gold", "silver", "copper")
    kind = look.pick(["heart", "gem", "disc"])
    a = np.linspace(np.pi / 2 + 0.35, 5 * np.pi / 2 - 0.35, 40)
    loop = np.column_stack([0.045 * np.cos(a), 0.055 * np.sin(a), np.full(40, 0.0012)])
    loop[:, 1] *= -1
    chain = tube(np.concatenate([[(0.0005, -0.0625, 0.0014)], loop, [(-0.0005, -0.0625, 0.0014)]]),
                 0.0011, 6)  # fmt: skip
    eye = torus(0.003, 0.0009, 14, 6).move(0, -0.064, 0.0014)
    if kind == "heart":
        t = np.linspace(0, 2 * np.pi, 30, endpoint=False)
        heart = np.column_stack([16 * np.sin(t) ** 3, 13 * np.cos(t) - 5 * np.cos(2 * t)
                                 - 2 * np.cos(3 * t) - np.cos(4 * t)]) * 0.0007  # fmt: skip
        charm = prism(heart[::-1], 0, 0.004).move(0, -0.079)
    elif kind == "gem":
        charm = _gem(0.011, 0.006, 8).scale(0.85, 1.2, 1).move(0, -0.081)
    else:
        charm = cylinder(0.0115, 0.0025, 26, bevel=0.0006).move(0, -0.0785)
    stone = surfaces.plain(look.own_color(*GEMS)) if kind != "disc" else gold(look, color)
    v = chain.vertices
    k = look.between(0.9, 1.25)
    made = shape(
        [(join([chain, eye]), gold(look, color)), (charm, stone)],
        [hull_part(v[v[:, 0] < 0]), hull_part(v[v[:, 0] > 0]), hull_part(charm.vertices)],
    )
    return made.scale(k)
