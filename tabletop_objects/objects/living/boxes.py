"""Objects of the ``living`` theme: boxes."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, dye, glaze_tile, leather, plastic, steel
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_of, hull_part
from ...kit.primitives import at_box, ball, drum, pad, plate, straight
from ...kit.shapes import Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    loft,
    open_box,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import Look, plain, speck, tint_color
from ..workbench.boxes import walls
from .bags import _metal


@category("heart_box", size=(0.167, 0.151, 0.055), mass=0.2, material="paper",
          aliases=("heart shaped box", "heart-shaped box", "box of valentine chocolates",
          "heart shaped chocolate box", "valentine box"), themes=("living",),
          colors=("red",))  # fmt: skip
@from_pieces(bodies=2)
def heart_box(look: Look) -> Pieces:
    """A heart-shaped box with a bow on its lid."""
    t = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    outline = (np.column_stack([16 * np.sin(t) ** 3, 13 * np.cos(t) - 5 * np.cos(2 * t) - 2
                                * np.cos(3 * t) - np.cos(4 * t)]) * 0.0052)  # fmt: skip
    body, lid = plate(0.97 * outline, 0.03), plate(outline, 0.018, 0.026)
    bow = [ball(0.05, 0.022, 0.012, (s * 0.024, 0.004, 0.047), 12).turn(2, 0.0) for s in (-1, 1)]
    knot = ball(0.014, 0.016, 0.014, (0, 0.004, 0.048), 10)
    band = at_box(0.012, 0.12, 0.0012, (0, -0.012, 0.0436))
    return [(body, tile := plastic(look, "red", "pink", "crimson", "purple")), (lid, tile),
            (join([*bow, knot]), ribbon := dye(look, "white", "gold", "pink")),
            (band, ribbon)]  # fmt: skip


@category("tissue_box", size=(0.19, 0.114, 0.145), mass=0.16, material="paper",
          aliases=("box of tissues", "tissues", "facial tissues", "kleenex", "kleenex box"),
          themes=("living", "office", "vanity"), colors=("sky", "white"), common=True)  # fmt: skip
def tissue_box(look: Look) -> Shape:
    """A box of tissues with one tissue sticking out of its slot."""
    cube = look.chance(0.35)
    x = look.between(0.11, 0.12) if cube else look.between(0.21, 0.24)
    y, h = look.between(0.108, 0.12), look.between(0.115, 0.13) if cube else look.between(0.06, 0.1)
    color = look.color("sky", "pink", "sage", "white", "lavender", "teal", "beige")
    other = look.own_color("white", "navy", "coral", "mustard", "green")
    pattern = [
        surfaces.stripes([color, color, other], 7, upright=True, side=128),
        prints.landscape(look.rng, 192, 96),
        speck(surfaces.speckles(look.rng, color, 4, 96), look.rng, other, 60, 5),
        surfaces.gradient(color, tint_color(color, 1.5), look.rng),
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
        [(box(x, y, h), pattern), (slot, surfaces.plain((70, 72, 76))),
         (tissue, surfaces.gradient((222, 226, 230), (250, 250, 250), look.rng))],
        [box_part(x, y, h), cylinder_part(0.02, 0.05, (0, 0, h))],
    )  # fmt: skip


_CARTON = (190, 150, 104)
_WOODS = ("wood", "wooden", "oak", "walnut", "pine", "bamboo")


@category("open_box", size=(0.27, 0.19, 0.115), mass=0.5, material="paper", hollow=True,
          aliases=("open carton", "open cardboard box", "storage bin", "bin without a lid"),
          themes=("living",), roles=("container", "big"), colors=("tan", "wooden"))  # fmt: skip
def open_box_(look: Look) -> Shape:
    """A wooden box or a cardboard carton without a lid."""
    x, y, h = look.between(0.24, 0.3), look.between(0.17, 0.21), look.between(0.1, 0.13)
    wooden = look.attributes.get("material", "") in _WOODS
    skin = surfaces.speckles(look.rng, _CARTON, 4)
    if wooden:
        skin = look.surface(look.color("wooden"), "wood")
    elif "color" in look.attributes:
        skin = look.surface(look.color("tan"), "plastic")
    wall = 0.008 if wooden else 0.004
    return shape([(s, skin) for s in walls(x, y, h, wall, wall)], frame_parts(x, y, h, wall, wall))


@category("display_case", size=(0.21, 0.163, 0.174), mass=0.8, material="glass", hollow=True,
          aliases=("glass case", "glass display case", "showcase", "museum case", "vitrine"),
          themes=("living",), roles=("big",), colors=("brown", "black"))  # fmt: skip
def display_case(look: Look) -> Shape:
    """A glass case on a dark base, for small objects."""
    x, y, h = look.between(0.17, 0.23), look.between(0.13, 0.17), look.between(0.12, 0.17)
    color = look.color("brown", "black", "wooden", "white")
    base = block(x + 0.012, y + 0.012, 0.02, 0.003, 0.002)
    panes = [at_box(x, 0.003, h, (0, s * (y / 2 - 0.0015), 0.02)) for s in (-1, 1)]
    panes += [at_box(0.003, y - 0.006, h, (s * (x / 2 - 0.0015), 0, 0.02)) for s in (-1, 1)]
    panes += [at_box(x, y, 0.003, (0, 0, 0.02 + h))]
    posts = [at_box(0.005, 0.005, h + 0.003, (s * x / 2, t * y / 2, 0.02))
             for s in (-1, 1) for t in (-1, 1)]  # fmt: skip
    edges = [at_box(x, 0.005, 0.005, (0, s * y / 2, 0.02 + h)) for s in (-1, 1)]
    edges += [at_box(0.005, y, 0.005, (s * x / 2, 0, 0.02 + h)) for s in (-1, 1)]
    felt = at_box(x - 0.01, y - 0.01, 0.001, (0, 0, 0.0198))
    trim = steel(look, BRASS_TONE) if look.chance(0.5) else plain(tint_color(color, 0.8))
    return put_down([(base, look.surface(color, "wood")), (felt, plain(look.own_color("maroon",
                                                                                      "navy",
                                                                                      "cream"))),
                     (join(panes), plain((226, 236, 238))), (join([*posts, *edges]), trim)], base,
                    join(panes), opacity=0.55)  # fmt: skip


@category("butterfly_case", size=(0.2, 0.15, 0.026), mass=0.4, material="wood",
          aliases=("framed butterfly", "butterfly frame", "mounted butterfly", "insect case"),
          themes=("living",), roles=("flat", "big"), colors=("brown",))  # fmt: skip
def butterfly_case(look: Look) -> Shape:
    """A shallow framed case with a pinned butterfly in it, lying flat."""
    color = look.color("brown", "black", "wooden", "white")
    k = look.between(0.85, 1.15)
    wing = look.own_color("blue", "orange", "turquoise", "yellow", "coral")
    back = at_box(0.2, 0.15, 0.02)
    bars = [at_box(0.2, 0.014, 0.026, (0, s * 0.068, 0)) for s in (-1, 1)]
    bars += [at_box(0.014, 0.15, 0.026, (s * 0.093, 0, 0)) for s in (-1, 1)]
    fore = [(0.002, 0.004), (0.03, 0.006), (0.058, 0.034), (0.05, 0.046), (0.02, 0.03)]
    hind = [(0.002, -0.018), (0.026, -0.03), (0.04, -0.012), (0.03, 0.004), (0.002, 0.004)]
    wings = [np.array(w) * [s, 1] for w in (fore, hind) for s in (1, -1)]
    flat = [plate(w if s > 0 else w[::-1], 0.0015, at=(0, 0, 0.0205))
            for w, s in zip(wings, (1, -1, 1, -1), strict=True)]  # fmt: skip
    spots = [drum(0.0045, 0.001, (s * x, y, 0.0217)) for s in (-1, 1)
             for x, y in ((0.043, 0.03), (0.026, -0.012))]  # fmt: skip
    body = ball(0.008, 0.05, 0.008, (0, 0.0, 0.022), 10)
    return put_down(
        [(back, plain((244, 240, 228))), (join(bars), look.surface(color, "wood")),
         (join(flat), surfaces.gradient(tint_color(wing, 0.8), tint_color(wing, 1.2), look.rng)),
         (join([*spots, body]), plain((36, 32, 32)))], back, *bars, factor=k)  # fmt: skip


@category("picnic_hamper", size=(0.332, 0.26, 0.198), mass=1.8, material="wood", hollow=True,
          aliases=("picnic basket", "wicker hamper"), themes=("living",), roles=("big", "support"),
          colors=("tan",))  # fmt: skip
def picnic_hamper(look: Look) -> Shape:
    """A wicker picnic hamper with a lid, leather straps and a handle."""
    k, color = look.between(0.88, 1.04), look.color("tan", "wooden", "brown", "bronze")
    x, y, h = 0.34 * k, 0.22 * k, 0.17 * k
    outline = rectangle(x, y, 0.02 * k)
    rings = [
        np.column_stack([outline * s, np.full(len(outline), z)]) for s, z in ((0.92, 0), (1.0, h))
    ]
    body = loft(np.stack(rings), outline)
    lid = block(1.02 * x, 1.02 * y, 0.035 * k, 0.022 * k, 0.008).move(z=h)
    weave = surfaces.basketwork(look.rng, color, 18)
    straps = [
        box(0.022 * k, 0.003, 0.75 * h).move(s * 0.28 * x, -0.51 * y, 0.32 * h) for s in (-1, 1)
    ] + [box(0.022 * k, 1.03 * y, 0.003).move(s * 0.28 * x, 0, h + 0.0335 * k) for s in (-1, 1)]
    straps += [box(0.022 * k, 0.003, 0.035 * k).move(s * 0.28 * x, -0.514 * y, h) for s in (-1, 1)]
    buckles = [
        box(0.028 * k, 0.006, 0.016 * k).move(s * 0.28 * x, -0.515 * y, 0.62 * h) for s in (-1, 1)
    ]
    grip = tube(smooth([(-0.06 * k, -0.51 * y, h + 0.018 * k),
                        (-0.05 * k, -0.51 * y - 0.03, h + 0.018 * k),
                        (0.05 * k, -0.51 * y - 0.03, h + 0.018 * k),
                        (0.06 * k, -0.51 * y, h + 0.018 * k)], 4), 0.007 * k, 8)  # fmt: skip
    leather = surfaces.speckles(look.rng, (112, 66, 40), 9)
    pieces = [(join([body, lid]), weave), (join([*straps, grip]), leather),
              (join(buckles), surfaces.brushed_metal(look.rng, (206, 172, 96)))]  # fmt: skip
    if look.chance(0.4):
        cloth = (prism(rectangle(0.5 * x, 0.04, 0.004), 0, 0.05
                       * k).turn(0, np.pi / 2).move(0, -0.51 * y, h - 0.01))  # fmt: skip
        pieces.append((cloth, surfaces.fabric(look.rng, (236, 232, 226), (196, 42, 40))))
    return shape(pieces, [hull_of(body), hull_of(lid), hull_of(grip)])


BRASS = (206, 172, 96)


@category("treasure_chest", size=(0.163, 0.106, 0.097), mass=0.5, material="wood", aliases=("chest",
          "wooden chest", "pirate chest", "small chest", "toy chest", "reliquary casket", "casket",
          "mimic chest miniature"), themes=("living", "toys"), colors=("brown",))  # fmt: skip
def treasure_chest(look: Look) -> Shape:
    """A wooden chest with a vaulted lid, metal bands and a lock."""
    color = look.color("brown", "wooden", "tan", "red", "black")
    k = look.between(0.85, 1.15)
    x, y, h = 0.16, 0.1, 0.06
    wood = surfaces.wood(look.rng, color, planks=5)
    chest = box(x, y, h)
    lid = cylinder(y / 2, x, 24).move(z=-x / 2).turn(1, np.pi / 2).scale(1, 1, 0.72)
    lid = lid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])).move(z=h)
    bands: list[Solid] = []
    for u in (-0.42 * x, 0.0, 0.42 * x):
        bands.append(box(0.014, y + 0.003, h + 0.001).move(u))
        hoop = (
            cylinder(y / 2 + 0.0015, 0.014, 24).move(z=-0.007).turn(1, np.pi / 2).scale(1, 1, 0.74)
        )
        bands.append(hoop.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))
                     .move(u, 0, h))  # fmt: skip
    rim = box(x + 0.002, y + 0.002, 0.008).move(z=h - 0.005)
    lock = box(0.022, 0.006, 0.026).move(0, -y / 2 - 0.002, h - 0.018)
    hole = box(0.004, 0.002, 0.009).move(0, -y / 2 - 0.0055, h - 0.012)
    metal = surfaces.brushed_metal(look.rng, look.pick([BRASS, (96, 98, 104)]))
    return put_down([(join([chest, lid]), wood), (join([*bands, rim, lock]), metal),
                    (hole, surfaces.plain((30, 28, 28)))], chest, lid, factor=k)  # fmt: skip


@category("wooden_box", size=(0.195, 0.135, 0.082), mass=0.5, material="wood", hollow=True,
          aliases=("wood box", "open wooden box", "timber box"), themes=("living",),
          roles=("container",), colors=("wooden",))  # fmt: skip
def wooden_box(look: Look) -> Shape:
    """A wooden box without its lid."""
    x, y, h = look.between(0.17, 0.22), look.between(0.12, 0.15), look.between(0.07, 0.095)
    color = look.color("wooden", "tan", "brown", "white", "teal")
    t = 0.007
    wood = look.surface(color, "wood")
    joints = [box(0.0075, 0.0075, 0.2 * h).move(sx * (x / 2 - 0.0036), sy * (y / 2 - 0.0036), z * h)
              for sx in (-1, 1) for sy in (-1, 1) for z in (0.2, 0.6)]  # fmt: skip
    return shape([(join(open_box(x, y, h, t, t)), wood), (join(joints), surfaces.wood(look.rng,
                  tint_color(color, 0.75)))], frame_parts(x, y, h, t, t))  # fmt: skip


@category("music_box", size=(0.123, 0.072, 0.065), mass=0.3, material="wood",
          aliases=("musical box", "musical box toy"), themes=("living",),
          colors=("wooden", "red"))  # fmt: skip
def music_box(look: Look) -> Shape:
    """A music box with a crank, and with its drum and comb visible on top."""
    color = look.color("wooden", "red", "brown", "teal", "navy", "pink")
    k = look.between(0.85, 1.2)
    base = block(0.09, 0.07, 0.045, 0.004, 0.002)
    plate = box(0.078, 0.058, 0.001).move(z=0.0445)
    drum = cylinder(0.0115, 0.05, 20).move(z=-0.025).turn(1, np.pi / 2).move(-0.002, 0.008, 0.052)
    dots = prints.mesh_holes(BRASS, (110, 86, 40), 10, 18)
    comb = join(
        [box(0.0024, 0.022, 0.0016).move(-0.024 + 0.004 * n, -0.012, 0.047) for n in range(12)]
    )
    crank = join([straight((0.044, 0.008, 0.03), (0.062, 0.008, 0.03), 0.0024, 8),
                  straight((0.062, 0.008, 0.03), (0.062, -0.012, 0.04), 0.0024, 8),
                  straight((0.061, -0.012, 0.04), (0.074, -0.012, 0.04), 0.0042, 10)])  # fmt: skip
    return put_down([(base, look.surface(color, "wood")), (plate, surfaces.plain((60, 52, 46))),
                     (drum, dots), (comb, surfaces.brushed_metal(look.rng, (200, 204, 210))),
                     (crank, surfaces.brushed_metal(look.rng, BRASS))], base, drum, crank,
                    factor=k)  # fmt: skip


BRIGHT = ("red", "teal", "navy", "pink", "white", "lavender", "black", "sage", "mustard", "sky")


@category("gift_box", size=(0.155, 0.14, 0.13), mass=0.4, material="paper", aliases=("gift",
          "present", "wrapped gift", "wrapped present", "birthday present", "christmas present",
          "birthday gift", "gift package", "pass the parcel", "pass-the-parcel parcel"),
          themes=("living",), colors=("red", "teal"), opened="open_box")  # fmt: skip
def gift_box(look: Look) -> Shape:
    """A wrapped present: a box and a lid, crossed by a ribbon with a looped bow."""
    x, y, h = look.between(0.11, 0.19), look.between(0.11, 0.15), look.between(0.07, 0.13)
    color = look.color(*BRIGHT)
    ribbon = surfaces.plain(look.own_color("gold", "white", "red", "green", "pink", "silver"))
    paper = surfaces.fit(glaze_tile(look, color), 128, 128)
    lid = box(x + 0.006, y + 0.006, 0.028).move(z=h - 0.026)
    bands = [box(0.024, y + 0.0078, h + 0.0025), box(x + 0.0078, 0.024, h + 0.0025)]
    loops = []
    for n in range(int(look.pick([4, 6]))):
        a = 2 * np.pi * n / 6 + 0.3
        loop = torus(0.017, 0.0045, 16, 6).scale(1, 0.42, 1).turn(0, np.pi / 2)
        loops.append(loop.move(x=0.014, z=0.012).turn(1, -0.5).turn(2, a).move(z=h + 0.006))
    knot = ellipsoid(0.018, 0.018, 0.014, 12, 8).move(z=h + 0.012)
    tails = [box(0.05, 0.016, 0.002).turn(1, 0.3).move(x=0.03).turn(2, a).move(z=h + 0.012)
             for a in (0.7, -0.9)]  # fmt: skip
    top = join([*loops, knot, *tails])
    cover = surfaces.fit(look.pick([paper, surfaces.plain(tint_color(color, 0.8))]), 128, 128)
    return shape([(box(x, y, h - 0.01), paper), (lid, cover), (join(bands), ribbon), (top, ribbon)],
                 [box_part(x, y, h - 0.01), hull_of(lid), hull_of(top)])  # fmt: skip


@category("glasses_case", size=(0.163, 0.066, 0.047), mass=0.09, material="leather",
          aliases=("sunglasses case", "eyeglasses case", "spectacle case", "eyeglass case",
          "case for glasses", "spectacles case", "lens case", "key case", "lorgnette case",
          "camera case", "calling card case", "contact lens case", "retainer case"),
          themes=("living",), colors=("black", "brown"), state="lying")  # fmt: skip
def glasses_case(look: Look) -> Shape:
    """A closed hard case for glasses, lying flat."""
    x, y, h = look.between(0.155, 0.17), look.between(0.06, 0.07), look.between(0.042, 0.052)
    color = look.color("black", "brown", "navy", "red", "tan", "teal", "pink")
    body = pad(x, y, h, 0.03, soft=0.75, steps=6)
    seam = block(x + 0.0012, y + 0.0012, 0.002, 0.03).move(z=h / 2 - 0.001)
    mark = box(0.035, 0.008, 0.0006).move(0, 0, h - 0.0003)
    return put_down([(body, leather(look.rng, color)),
                     (seam, surfaces.plain(tint_color(color, 0.5))), (mark, _metal(look))],
                    body)  # fmt: skip


@category("laundry_basket", size=(0.307, 0.217, 0.145), mass=0.5, material="plastic", hollow=True,
          aliases=("clothes basket", "washing basket", "plastic basket", "laundry hamper"),
          themes=("living",), roles=("container", "big"), colors=("white", "blue"))  # fmt: skip
def laundry_basket(look: Look) -> Shape:
    """A small, oblong laundry basket with slits in its walls."""
    color = look.color("white", "blue", "teal", "gray", "pink", "green")
    x, y, h = look.between(0.27, 0.32), look.between(0.19, 0.22), look.between(0.13, 0.16)
    outline = rectangle(1, 1, 0.18, 5)
    t = 0.005
    levels = [(x - 0.03, y - 0.03, 0), (x, y, h), (x - 2 * t, y - 2 * t, h),
              (x - 0.03 - 2 * t, y - 0.03 - 2 * t, t)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b], np.full(len(outline), z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    slits = [box(0.012, 0.004, 0.6 * h).turn(0, s * 0.055).move(0.028 * n, s * (y / 2 - 0.009), 0.2
                                                                * h) for n in range(-4, 5)
             for s in (-1, 1)]  # fmt: skip
    rim = [np.column_stack([outline * [x + 0.012, y + 0.012], np.full(len(outline), z)])
           for z in (h - 0.012, h - 0.002)]  # fmt: skip
    inner = [np.column_stack([outline * [x - 0.006, y - 0.006], np.full(len(outline), z)])
             for z in (h - 0.002, h - 0.012)]  # fmt: skip
    lip = loft(np.stack([*rim, *inner]), None, loop=True)
    walls = [box_part(x - 0.04, y - 0.04, t)]
    for s in (-1, 1):
        for wide, deep, along in ((x, y, 0), (y, x, 1)):
            low, top = deep / 2 - 0.015, deep / 2
            corners = [(u * (wide / 2 - (0.015 if z == 0 else 0) - 0.012), s * (v - k * t * 1.2), z)
                       for u in (-1, 1) for z, v in ((0, low), (h, top))
                       for k in (0, 1)]  # fmt: skip
            pts = np.array(corners)
            walls.append(hull_part(pts if along == 0 else pts[:, [1, 0, 2]]))
    dark = surfaces.plain(tint_color(color, 0.45))
    return shape([(body, look.surface(color, "plastic")), (join(slits), dark),
                  (lip, surfaces.plain(tint_color(color, 0.9)))], walls)  # fmt: skip
