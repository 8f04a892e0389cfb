"""Objects of the ``dining`` theme: barware."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of, open_vessel, ring_parts
from ...kit.primitives import ball, facing, limb, scatter, straight
from ...kit.shapes import Category, Shape, at_rest, category, keep_still, settle, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color


@category("pitcher", size=(0.185, 0.12, 0.203), mass=0.7, material="ceramic", hollow=True,
          aliases=("jug", "water jug", "milk jug", "water pitcher", "creamer", "milk pitcher",
          "lemonade pitcher", "ewer", "cream jug"), themes=("dining", "kitchen"),
          roles=("container", "tall"), colors=("white", "sky"))  # fmt: skip
def pitcher(look: Look) -> Shape:
    """An open jug with a spout on the left and a handle on the right."""
    r, h = look.between(0.052, 0.066), look.between(0.17, 0.23)
    color = look.color("white", "sky", "cream", "terracotta", "teal", "mustard", "clear", "navy")
    kind = look.pick(["belly", "straight", "flared"])
    t = np.linspace(0, 1, 9)
    swell = {"belly": 0.78 + 0.34 * np.sin(np.pi * (0.1 + 0.86 * t)) ** 1.4 - 0.1 * t,
             "straight": 0.92 + 0.08 * t, "flared": 0.72 + 0.3 * t**1.5}[kind]  # fmt: skip
    body, parts = open_vessel([(r * s, h * u) for s, u in zip(swell, t, strict=True)], 0.005, 0.007)

    def lip_profile(p: np.ndarray) -> np.ndarray:
        up = np.clip((p[:, 2] / h - 0.72) / 0.28, 0, 1) ** 2
        left = np.clip(-p[:, 0] / r, 0, 1) ** 5
        return p + np.column_stack([-0.024 * up * left, -0.7 * p[:, 1] * up * left * 0.5,
                                    0.008 * up * left])  # fmt: skip

    rim, low = 0.96 * swell[-1] * r, float(np.interp(0.3, t, swell)) * r
    ear = tube(smooth([(rim, 0, 0.93 * h), (rim + 0.05, 0, 0.95 * h), (rim + 0.056, 0, 0.62 * h),
                       (low, 0, 0.3 * h)], 5), 0.0075, 10, squash=0.8)  # fmt: skip
    inside = look.surface(tint_color(color, 1.3), "ceramic")
    skin = glaze_tile(look, color)
    return shape(
        [(body.bend(lip_profile), surfaces.stack((skin, 50), (inside, 50), side=192)),
         (ear, look.surface(color, "ceramic"))],
        [*parts, box_part(0.03, 0.015, 0.55 * h, (rim + 0.04, 0, 0.38 * h))],
    )  # fmt: skip


@category("ice_bucket", size=(0.205, 0.205, 0.183), mass=1.6, material="metal", hollow=True,
          aliases=("wine cooler", "champagne bucket", "bucket of ice", "wine bucket",
          "champagne cooler"), themes=("dining",), roles=("round", "big"),
          colors=("silver", "copper"), opened="open_ice_bucket")  # fmt: skip
def ice_bucket(look: Look) -> Shape:
    """A bucket of ice cubes with two ring handles, sometimes with a bottle in it."""
    r, h = look.between(0.085, 0.105), look.between(0.16, 0.2)
    color = look.color("silver", "silver", "copper", "gold", "black", "clear", "white")
    skin = look.surface(color, "metal")
    low, level = 0.74 * r, 0.8 * h
    side = [(low, 0), (low + (r - low) * 0.97, 0.94 * h), (1.05 * r, 0.95 * h), (1.05 * r, h),
            (r - 0.004, h), (r - 0.012, level)]  # fmt: skip
    body = lathe([(0, 0), *side, (0, level)], 32)
    ring = torus(0.024, 0.0035, 20, 6).turn(1, np.pi / 2)
    ears = [ring.move(s * (0.95 * r + 0.004), 0, 0.74 * h) for s in (-1, 1)]
    cubes = []
    for k in range(18):
        away, turn = 0.72 * r * np.sqrt((k + 0.5) / 18), 2.4 * k
        cube = block(0.028, 0.028, 0.026, 0.004, 0.003).turn(0, look.between(-0.6, 0.6))
        cube = cube.turn(2, turn).move(away * np.cos(turn), away * np.sin(turn), level - 0.008)
        cubes.append(cube)
    ice = surfaces.speckles(look.rng, (214, 230, 238), 10, 32)
    top = max(float(c.bounds[1, 2]) for c in cubes)
    return shape(
        [(body, skin), (join(ears), skin), (join(cubes), ice)],
        [hull_of(body), *(hull_of(e) for e in ears),
         cylinder_part(0.6 * r, top - h, (0, 0, h)) if top > h + 0.001 else hull_of(body)],
    )  # fmt: skip


def metal(look: Look) -> surfaces.Tile:
    """Return a metal tile in the requested colour, or else in silver, gold, copper or black."""
    return look.surface(look.color("silver", "silver", "gold", "copper", "black"), "metal")


@category("jigger", size=(0.0436, 0.0438, 0.0888), mass=0.08, material="metal", hollow=True,
          aliases=("bar jigger", "spirit measure", "shot measure", "measuring jigger"),
          themes=("dining",), roles=("round", "tall"), colors=("silver",))  # fmt: skip
def jigger(look: Look) -> Shape:
    """A double jigger: two cones joined at their tips, open at the top."""
    r, h = look.between(0.02, 0.024), look.between(0.075, 0.095)
    skin = metal(look)
    side = [(0.86 * r, 0), (0.88 * r, 0.004), (0.3 * r, 0.42 * h), (0.3 * r, 0.46 * h), (r, h)]
    inner = [(r - 0.0012, h), (0.24 * r, 0.52 * h)]
    body = lathe([(0, 0), *side, *inner, (0, 0.5 * h)], 30)
    low = lathe([(0, 0), *side[:3], (0, 0.42 * h)], 20)
    walls = ring_parts([(0.3 * r, 0.44 * h), (r, h)], [(r - 0.0012, h), (0.24 * r, 0.5 * h)], 10)
    return shape(
        [(body, skin)], [hull_of(low), *walls, cylinder_part(0.28 * r, 0.09 * h, (0, 0, 0.42 * h))]
    )


@category("muddler", size=(0.207, 0.0319, 0.0288), mass=0.08, material="wood",
          aliases=("cocktail muddler",), themes=("dining",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def muddler(look: Look) -> Shape:
    """A cocktail muddler lying flat: a stick with a thick, ribbed end on the left."""
    long, r = look.between(0.19, 0.23), look.between(0.014, 0.017)
    wood = look.surface(look.color("wooden", "brown", "black", "silver"), "wood")
    body = limb([(-0.5 * long, 0, 0), (-0.45 * long, 0, 0), (-0.3 * long, 0, 0), (0, 0, 0),
                 (0.4 * long, 0, 0), (0.46 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.8 * r, r, 0.96 * r, 0.72 * r, 0.78 * r, 0.74 * r, 0.4 * r], 18)  # fmt: skip
    rings = [cylinder(1.02 * r, 0.002, 20).turn(1, np.pi / 2).move(x=(-0.45 + 0.03 * k) * long)
             for k in range(3)]  # fmt: skip
    dark = surfaces.plain((70, 48, 34))
    return settle([(body, wood), (join(rings), dark)], 0.1)


@category("ice_tongs", size=(0.155, 0.0433, 0.0121), mass=0.05, material="metal", assembled=True,
          aliases=("sugar tongs", "bar tongs", "ice cube tongs", "sugar tong"), themes=("dining",),
          colors=("silver",), state="lying flat")  # fmt: skip
def ice_tongs(look: Look) -> Shape:
    """Small ice tongs bent from one strip, with toothed ends, lying on their side."""
    long = look.between(0.14, 0.17)
    skin = metal(look)
    path = smooth([(-0.5 * long, -0.012, 0), (-0.2 * long, -0.02, 0), (0.3 * long, -0.018, 0),
                   (0.47 * long, -0.009, 0), (0.5 * long, 0, 0), (0.47 * long, 0.009, 0),
                   (0.3 * long, 0.018, 0), (-0.2 * long, 0.02, 0), (-0.5 * long, 0.012, 0)],
                  3)  # fmt: skip
    flat = tube(path, 0.0013, 6).scale(1, 1, 5.5)
    teeth = [box(0.004, 0.006, 0.012).move((-0.49 + 0.03 * k) * long, s * 0.012, -0.006)
             for k in range(3) for s in (-1, 1)]  # fmt: skip
    return settle([(join([flat, *teeth]), skin)], 0.02)


@category("hip_flask", size=(0.0918, 0.0273, 0.12), mass=0.15, material="metal", assembled=True,
          aliases=("pocket flask", "whiskey flask", "powder horn"), themes=("dining",),
          colors=("silver", "brown"))  # fmt: skip
def hip_flask(look: Look) -> Shape:
    """A curved, flat hip flask of steel or leather, standing upright."""
    x, h = look.between(0.088, 0.1), look.between(0.11, 0.13)
    color = look.color("silver", "brown", "black", "silver", "maroon", "navy")
    skin = look.surface(color, "metal")
    body = block(x, 0.026, 0.82 * h, 0.0125, 0.008, 5)
    body = body.bend(lambda p: p + np.column_stack([0 * p[:, 0], 2.4 * p[:, 0] ** 2, 0 * p[:, 0]]))
    neck = cylinder(0.0095, 0.1 * h, 18).move(y=0.001, z=0.81 * h)
    cap = cylinder(0.0125, 0.11 * h, 20, bevel=0.001).move(y=0.001, z=0.89 * h)
    band = block(0.99 * x, 0.0275, 0.44 * h, 0.0127, 0.0, 5).move(z=0.16 * h)
    band = band.bend(lambda p: p + np.column_stack([0 * p[:, 0], 2.4 * p[:, 0] ** 2, 0 * p[:, 0]]))
    leather = surfaces.spots(
        look.rng, look.own_color("brown", "black", "maroon"), (60, 40, 30), 0.1
    )
    pieces = [(body, skin), (join([neck, cap]), surfaces.brushed_metal(look.rng, (196, 199, 204)))]
    if look.chance(0.5):
        pieces.append((band, leather))
    return shape(pieces, [hull_of(body), hull_of(neck, cap)])


@category("cork", size=(0.0276, 0.0277, 0.0463), mass=0.005, material="wood", aliases=("wine cork",
          "champagne cork", "bottle cork", "bottle stopper", "wine stopper", "champagne stopper",
          "rubber bung", "cork stopper", "glass stopper", "bung"), themes=("dining",),
          roles=("round",), colors=("tan",))  # fmt: skip
def cork(look: Look) -> Shape:
    """A wine cork standing upright, or a champagne cork with a wider head."""
    r, h = look.between(0.0105, 0.0125), look.between(0.04, 0.05)
    color = look.color("tan", "beige", "wooden")
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.12)
    if look.chance(0.6):
        body = cylinder(r, h, 24, bevel=0.0008)
        return shape([(body, tile)], [cylinder_part(r, h)])
    body = lathe([(0, 0), (1.15 * r, 0), (1.25 * r, 0.1 * h), (1.05 * r, 0.5 * h), (r, 0.6 * h),
                  (1.35 * r, 0.66 * h), (1.4 * r, 0.8 * h), (1.0 * r, 0.98 * h), (0, h)],
                 26)  # fmt: skip
    return shape([(body, tile)], [hull_of(body)])


@category("bottle_cap", size=(0.0308, 0.0309, 0.00633), mass=0.002, material="metal",
          aliases=("crown cap", "beer cap", "bottle top", "beer bottle cap"), themes=("dining",),
          roles=("round", "flat"), colors=("red", "gold"), state="lying flat")  # fmt: skip
def bottle_cap(look: Look) -> Shape:
    """A crown cap lying with its crimped edge down."""
    r, h = look.between(0.0145, 0.0165), look.between(0.0058, 0.007)
    color = look.color("red", "gold", "blue", "green", "silver", "black", "white")
    t = 42
    body = lathe([(0, 0), (r, 0), (0.93 * r, 0.5 * h), (0.85 * r, 0.92 * h), (0, h)], t)

    def crimp(p: np.ndarray) -> np.ndarray:
        wave = 1 + 0.05 * np.cos(21 * np.arctan2(p[:, 1], p[:, 0])) * (1 - p[:, 2] / h)
        return p * np.column_stack([wave, wave, np.ones(len(p))])

    face = prints.canvas(64, 64, color)
    prints.disc(face, 0.5, 0.5, 0.34, tint_color(color, 1.5), 0.3)
    prints.write(face, look.pick(["ALE", "A", "CO", "IPA"]), 0.5, 0.5, 0.3, readable_on(color))
    top = cylinder(0.8 * r, 0.0005, 28).move(z=0.93 * h)
    return shape([(body.bend(crimp), surfaces.brushed_metal(look.rng, color)), (top, face)],
                 [hull_of(body)])  # fmt: skip


def _can(look: Look, r: float, h: float, word: str, palette: tuple[str, ...]) -> Shape:
    color = look.color(*palette)
    ground = look.pick([(244, 242, 234), (40, 42, 48), (226, 190, 90)])
    image = prints.label(look.rng, word, color, ground)
    steel = surfaces.plain((206, 209, 214))
    tile = surfaces.stack((steel, 6), (image, 84), (steel, 10), side=192)
    body = lathe([(0, 0.002), (0.8 * r, 0), (r, 0.06 * h), (r, 0.9 * h), (0.84 * r, 0.975 * h),
                  (0.85 * r, h), (0.8 * r, h), (0.76 * r, 0.975 * h), (0, 0.975 * h)], 32,
                 v=[0, 0.01, 0.06, 0.9, 0.97, 0.98, 0.985, 0.99, 1])  # fmt: skip
    tab = block(0.013, 0.02, 0.0014, 0.006).move(y=-0.004, z=0.975 * h)
    return shape([(body, tile), (tab, surfaces.plain((180, 184, 190)))], [hull_of(body)])


@category("beer_mat", size=(0.0993, 0.0993, 0.00356), mass=0.02, material="paper",
          aliases=("beermat", "beer coaster", "paper coaster", "beer mat collection"),
          themes=("dining",), roles=("flat", "support"), colors=("red",),
          state="lying flat")  # fmt: skip
def beer_mat(look: Look) -> Shape:
    """A printed beer mat of pulpboard, round or square."""
    x, h = look.between(0.09, 0.105), look.between(0.003, 0.004)
    color = look.color("red", "green", "navy", "gold", "white", "maroon")
    face = prints.canvas(128, 128, (244, 240, 228))
    prints.disc(face, 0.5, 0.5, 0.44, color)
    prints.disc(face, 0.5, 0.5, 0.38, (244, 240, 228), 0.36)
    prints.write(face, look.pick(["BEER", "ALE", "BRAU", "PUB"]), 0.5, 0.5, 0.22,
                 readable_on(color), bold=True)  # fmt: skip
    if look.chance(0.5):
        return shape([(cylinder(x / 2, h, 36), face)], [cylinder_part(x / 2, h)])
    return shape([(block(x, x, h, 0.01), face)], [box_part(x, x, h)])


@category("soda_siphon", size=(0.119, 0.0965, 0.284), mass=1.2, material="glass", assembled=True,
          aliases=("seltzer bottle", "soda syphon", "cream whipper", "whipped cream dispenser"),
          themes=("dining",), roles=("tall",), colors=("teal",))  # fmt: skip
def soda_siphon(look: Look) -> Shape:
    """A soda siphon: a ribbed bottle with a chrome head, a lever and a spout."""
    k = look.between(0.94, 1.06)
    color = look.color("teal", "sky", "red", "silver", "clear")
    body = lathe([(0, 0), (0.044, 0), (0.047, 0.01), (0.047, 0.15), (0.03, 0.195), (0.018, 0.21),
                  (0, 0.21)], 28)  # fmt: skip
    head = lathe(
        [(0, 0.205), (0.02, 0.205), (0.022, 0.23), (0.016, 0.26), (0.012, 0.275), (0, 0.277)], 22
    )
    spout = limb([(-0.012, 0, 0.25), (-0.045, 0, 0.25), (-0.056, 0, 0.225)], [0.006, 0.0055, 0.004],
                 8)  # fmt: skip
    lever = limb([(0.004, 0, 0.27), (0.035, 0, 0.266), (0.05, 0, 0.22), (0.052, 0, 0.17)],
                 [0.005, 0.005, 0.0045, 0.004], 8)  # fmt: skip
    foot = cylinder(0.046, 0.016, 28)
    chrome = surfaces.brushed_metal(look.rng, (206, 210, 214))
    net = surfaces.grid(tint_color(color, 0.8), tint_color(color, 1.15), 22, 22, width=1)
    return shape(
        [(body, net), (join([head, spout, lever, foot]), chrome)],
        [hull_of(body, foot), hull_of(head), hull_of(spout), hull_of(lever)],
    ).scale(k)


STEEL: RGB = (188, 191, 196)
GLASS: RGB = (212, 224, 226)


@category("drink_dispenser", size=(0.166, 0.185, 0.271), mass=2.5, material="metal", assembled=True,
          aliases=("beverage dispenser", "juice dispenser", "drinks dispenser",
          "lemonade dispenser", "water dispenser"), themes=("dining",), roles=("tall", "big"),
          colors=("orange",))  # fmt: skip
def drink_dispenser(look: Look) -> Shape:
    """A drinks dispenser: a lidded glass jar of juice on a stand, with a tap in front."""
    k = look.between(0.92, 1.06)
    color = look.color("orange", "pink", "yellow", "red", "clear")
    stand = [torus(0.07, 0.004, 30, 6).move(z=0.06), torus(0.08, 0.004, 30, 6).move(z=0.004)]
    stand += [straight((0.08 * np.cos(a), 0.08 * np.sin(a), 0.004),
                       (0.07 * np.cos(a), 0.07 * np.sin(a), 0.06), 0.0035, 6)
              for a in (0.785, 2.356, 3.927, 5.498)]  # fmt: skip
    jar = lathe([(0, 0.062), (0.068, 0.062), (0.075, 0.075), (0.075, 0.22), (0.055, 0.245), (0,
                 0.245)], 32, v=[0, 0.02, 0.06, 0.86, 0.98, 1])  # fmt: skip
    lid = cylinder(0.06, 0.014, 30, bevel=0.002).move(z=0.244)
    knob = ball(0.02, 0.02, 0.018, (0, 0, 0.264), 12)
    tap = [straight((0, -0.07, 0.09), (0, -0.1, 0.09), 0.006), straight((0, -0.097, 0.096),
                                                                        (0, -0.097, 0.07), 0.005),
           box(0.03, 0.006, 0.008).move(0, -0.094, 0.096)]  # fmt: skip
    fruit = scatter(look, 0.05, 6, (0.024, 0.03), 0.16)
    drink = surfaces.stack(
        (surfaces.speckles(look.rng, color, 5), 0.72), (surfaces.plain(GLASS), 0.28)
    )
    steel = surfaces.brushed_metal(look.rng, STEEL)
    return shape([(join(stand), surfaces.plain((44, 44, 48))), (jar, drink),
                  (join([lid, knob, *tap]), steel), (fruit, surfaces.plain((246, 220, 90)))],
                 [cylinder_part(0.083, 0.066), hull_of(jar), hull_of(lid, knob), hull_of(*tap)]
                 ).scale(k)  # fmt: skip


@category("straw", size=(0.196, 0.0433, 0.00538), mass=0.002, material="plastic", assembled=True,
          aliases=("drinking straw", "paper straw", "plastic straw", "striped straw", "bendy straw",
          "paper straw bundle"), themes=("dining",), colors=("red",),
          state="lying flat")  # fmt: skip
def straw(look: Look) -> Shape:
    """A striped drinking straw, bent or straight, lying flat."""
    long, r = look.between(0.19, 0.22), look.between(0.0028, 0.0036)
    color = look.color("red", "blue", "green", "pink", "black", "yellow", "teal")
    path = [(-0.5 * long, 0, 0), (0.2 * long, 0, 0), (0.5 * long, 0, 0)]
    if look.chance(0.5):
        path = [(-0.5 * long, 0, 0), (0.22 * long, 0, 0), (0.28 * long, 0.008, 0),
                (0.4 * long, 0.06, 0)]  # fmt: skip
    body = tube(smooth(path, 4), r, 10)
    y, x = np.mgrid[0:160, 0:32]
    band = ((x / 32 + 10 * y / 160) % 1) < 0.45
    tile = np.where(band[..., None], np.array(color), np.array((250, 248, 244))).astype(np.uint8)
    dark = [cylinder(0.72 * r, 0.0004, 10).turn(1, np.pi / 2).move(x=-0.5 * long - 0.0003)]
    return settle([(body, tile), (join(dark), surfaces.plain((60, 56, 56)))], 0.14)


@category("ice_cube", size=(0.0231, 0.0231, 0.0217), mass=0.011, material="glass",
          aliases=("ice", "cube of ice", "block of ice", "lump of ice"), themes=("dining",),
          colors=("clear",))  # fmt: skip
def ice_cube(look: Look) -> Shape:
    """A clear ice cube with a milky centre."""
    x = look.between(0.021, 0.0255)
    color = look.color("clear", "sky", "clear", "white")
    tile = surfaces.gradient(tint_color(color, 1.05), tint_color(color, 1.5), look.rng, 10)
    body = block(x, x, 0.94 * x, 0.18 * x, 0.12 * x)
    core = ellipsoid(0.4 * x, 0.4 * x, 0.36 * x, 12, 8).move(z=0.47 * x)
    return shape([(body, tile), (core, surfaces.plain((250, 252, 253)))], [hull_of(body)],
                 opacity=0.72)  # fmt: skip


def _spout(kind: str) -> Callable[[Look], Shape]:
    """Return the shape function of a bottle pourer or aerator, lying flat."""

    def make(look: Look) -> Shape:
        k, color = (look.between(0.9, 1.12), look.color("silver", "silver", "gold", "black")
                    if kind == "pourer" else look.color("black", "silver", "gray"))  # fmt: skip
        stopper = lathe([(0, 0), (0.007, 0.002), (0.0085, 0.01), (0.0075, 0.014), (0.0095, 0.018),
                         (0.0085, 0.023), (0.0105, 0.028), (0, 0.03)], 20)  # fmt: skip
        if kind == "pourer":
            head = [lathe([(0, 0.029), (0.011, 0.029), (0.009, 0.036), (0.0045, 0.04), (0, 0.04)],
                          18), limb([(0, 0, 0.036), (0.002, 0, 0.06), (0.012, 0, 0.082),
                                     (0.02, 0, 0.092)], [0.0045, 0.0042, 0.0036, 0.0036], 10),
                    tube([(-0.006, 0, 0.03), (-0.009, 0, 0.055)], 0.0015, 6)]  # fmt: skip
        else:
            head = [lathe([(0, 0.029), (0.012, 0.029), (0.018, 0.05), (0.019, 0.08), (0.014, 0.1),
                           (0.01, 0.104), (0, 0.104)], 24),
                    torus(0.019, 0.0014, 26, 5).move(z=0.07)]  # fmt: skip
        laid = [(s.turn(1, np.pi / 2).move(-0.05, 0, 0), t) for s,
                t in ((stopper, surfaces.plain((34, 34, 36))),
                      (join(head), look.surface(color, "steel" if sum(color) > 300
                                                else "plastic")))]  # fmt: skip
        return settle(laid, 0.1, hulls=[[0], [1]]).scale(k)

    return make


@category("optic_measure", size=(0.0695, 0.059, 0.116), mass=0.12, material="plastic",
          aliases=("optic", "bar optic", "spirit optic"), themes=("dining",), roles=("tall",),
          colors=("silver",))  # fmt: skip
def optic_measure(look: Look) -> Shape:
    """A spirit measure: a clear chamber below a stopper, standing on its mouth."""
    k, color = look.between(0.9, 1.1), look.color("silver", "black", "white", "red")
    base = lathe(
        [(0, 0), (0.024, 0), (0.026, 0.01), (0.012, 0.016), (0.012, 0.026), (0, 0.026)], 22
    )
    glass = lathe(
        [(0, 0.024), (0.02, 0.024), (0.022, 0.03), (0.022, 0.07), (0.012, 0.078), (0, 0.078)], 24
    )
    top = lathe(
        [(0, 0.076), (0.014, 0.076), (0.014, 0.09), (0.009, 0.094), (0.0085, 0.115), (0, 0.116)], 18
    )
    arm = [
        tube([(s * 0.024, -0.002, 0.012), (s * 0.032, -0.03, 0.012)], 0.003, 7) for s in (-1, 1)
    ] + [tube([(-0.032, -0.03, 0.012), (0.032, -0.03, 0.012)], 0.003, 7)]
    badge = box(0.018, 0.001, 0.012).move(0, -0.0222, 0.045)
    image = prints.canvas(48, 32, (250, 250, 248))
    prints.write(image, "25ml", 0.5, 0.5, 0.5, (40, 50, 90), bold=True)
    made = [
        (join([base, top, *arm]), look.surface(color, "steel" if sum(color) > 300 else "plastic")),
        (glass, surfaces.gradient((206, 160, 84), (226, 236, 240), look.rng)),
        (badge, image),
    ]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(base.scale(k, k, k)), hull_of(made[1][0], top.scale(k, k, k))])


@category("tap_handle", size=(0.0641, 0.0641, 0.245), mass=0.3, material="metal", assembled=True,
          aliases=("keg tap handle", "beer tap handle", "beer tap", "beer pump handle",
          "pump clip"), themes=("dining",), roles=("tall",), colors=("wooden",))  # fmt: skip
def tap_handle(look: Look) -> Shape:
    """A beer tap handle on a base: a tall painted paddle with a badge."""
    k, color = (look.between(0.9, 1.08), look.color("wooden", "red", "green", "navy", "black",
                                                    "gold"))  # fmt: skip
    foot = lathe([(0, 0), (0.032, 0), (0.032, 0.01), (0.012, 0.016), (0.01, 0.04), (0.014, 0.046),
                  (0, 0.046)], 24)  # fmt: skip
    side = smooth([(-0.016, 0.0), (0.016, 0.0), (0.024, 0.09), (0.03, 0.16), (0.02, 0.195),
                   (0, 0.2), (-0.02, 0.195), (-0.03, 0.16), (-0.024, 0.09), (-0.016, 0)],
                  3)[:-1]  # fmt: skip
    paddle = facing(prism(side, -0.011, 0.011, 0.0)).move(z=0.044)
    badge = facing(cylinder(0.021, 0.003, 26)).move(0, -0.011, 0.195)
    image = prints.canvas(96, 96, (244, 236, 214))
    prints.disc(image, 0.5, 0.5, 0.46, color, 0.4)
    prints.write(image, look.pick(["ALE", "IPA", "BEER", "LAGER"]), 0.5, 0.5, 0.24,
                 tint_color(color, 0.6) if sum(color) > 200 else (40, 36, 30),
                 bold=True)  # fmt: skip
    made = [(foot, surfaces.brushed_metal(look.rng, (206, 172, 96))),
            (paddle, look.surface(color, "wood" if color[0] > 1.3 * color[2] else "plastic")),
            (badge, image)]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0])])


@category("bombilla", size=(0.201, 0.0151, 0.0153), mass=0.03, material="metal",
          aliases=("mate straw", "yerba mate straw", "metal straw", "steel straw"),
          themes=("dining",), colors=("silver",), state="lying")  # fmt: skip
@keep_still
def bombilla(look: Look) -> Shape:
    """A bombilla: a metal straw with a bulb-shaped filter at one end, lying flat."""
    k, color = look.between(0.88, 1.1), look.color("silver", "silver", "gold", "black")
    straw = tube(smooth([(-0.08, 0, 0.008), (0.03, 0, 0.006), (0.075, 0, 0.007), (0.095, 0, 0.011)],
                        4), [0.0032] * 13, 10)  # fmt: skip
    bulb = ellipsoid(0.032, 0.015, 0.015, 18, 10).move(-0.088, 0, 0.008)
    holes = [ellipsoid(0.0026, 0.0026, 0.0016, 6, 4).move(-0.097 + 0.006 * (n % 4), 0.004
                                                          * (n // 4 - 1), 0.0155 - 0.0004
                                                          * abs(n // 4 - 1))
             for n in range(12)]  # fmt: skip
    ring = [torus(0.0042, 0.0012, 14, 6).turn(1, np.pi / 2).move(x, 0, 0.0068)
            for x in (-0.02, -0.014, 0.04)]  # fmt: skip
    return settle([(join([straw, bulb]), look.surface(color, "steel")),
                   (join(holes), surfaces.plain((50, 50, 54))),
                   (join(ring), surfaces.plain((206, 172, 96)))], 0.04,
                  hulls=[[0]]).scale(k)  # fmt: skip


@category("cocktail_shaker", size=(0.0897, 0.0897, 0.218), mass=0.35, material="metal", hollow=True,
          aliases=("drink shaker", "martini shaker", "bar shaker"), themes=("dining",),
          roles=("tall", "round"), colors=("silver",))  # fmt: skip
def cocktail_shaker(look: Look) -> Shape:
    """A three-piece steel cocktail shaker."""
    r, h = look.between(0.04, 0.046), look.between(0.2, 0.24)
    skin = metal(look)
    body = lathe([(0, 0), (0.72 * r, 0), (0.76 * r, 0.02 * h), (r, 0.62 * h), (0, 0.62 * h)], 36)
    cap = lathe([(0, 0.62 * h), (1.03 * r, 0.62 * h), (1.02 * r, 0.68 * h), (0.7 * r, 0.8 * h),
                 (0.5 * r, 0.85 * h), (0, 0.85 * h)], 36)  # fmt: skip
    top = lathe([(0, 0.84 * h), (0.48 * r, 0.84 * h), (0.5 * r, 0.87 * h), (0.44 * r, 0.98 * h),
                 (0.3 * r, h), (0, h)], 30)  # fmt: skip
    return shape([(body, skin), (cap, skin), (top, skin)],
                 [hull_of(body), hull_of(cap), hull_of(top)])  # fmt: skip


CATEGORIES = (
    Category("pourer", at_rest(_spout("pourer")), size=(0.0942, 0.022, 0.0301), mass=0.03,
             material="metal", aliases=("pourer spout", "bottle pourer", "speed pourer",
             "pour spout", "liquor pourer"), themes=("dining",), colors=("silver",), state="lying"),
    Category("wine_aerator", _spout("aerator"), size=(0.109, 0.0426, 0.0381), mass=0.08,
             material="plastic", aliases=("aerator", "wine pourer"), themes=("dining",),
             colors=("black",), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
