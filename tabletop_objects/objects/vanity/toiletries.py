"""Objects of the ``vanity`` theme: toiletries."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, hull_part
from ...kit.primitives import ball, pad, rod, straight
from ...kit.prints import canvas, disc, fill, write
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    sweep,
    torus,
)
from ...kit.surfaces import RGB, Look, Tile, readable_on, tint_color


@category("toilet_roll", size=(0.106, 0.106, 0.099), mass=0.12, material="paper",
          aliases=("roll of toilet paper", "toilet paper roll", "loo roll"), themes=("vanity",),
          roles=("round",), colors=("white",))  # fmt: skip
def toilet_roll(look: Look) -> Shape:
    """An upright roll of toilet paper with its last sheet hanging down."""
    r, h = look.between(0.048, 0.058), look.between(0.092, 0.105)
    color = look.color("white", "white", "cream", "pink", "sky")
    roll = lathe([(0.02, 0), (r, 0), (r, h), (0.02, h)], 30, loop=True)
    core = lathe(
        [(0.0185, 0), (0.021, 0), (0.021, h + 0.0006), (0.0185, h + 0.0006)], 24, loop=True
    )
    sheet = box(0.05, 0.0012, h - 0.002).turn(2, -0.25).move(0.03, -r * 0.9, 0.001)
    paper = surfaces.spots(look.rng, color, tint_color(color, 0.95), 0.15)
    rings = surfaces.stripes([color, tint_color(color, 0.93)], 16, side=64)
    lid = lathe([(0.021, h - 0.0005), (r - 0.001, h - 0.0005), (r - 0.001, h + 0.0004),
                 (0.021, h + 0.0004)], 30, loop=True)  # fmt: skip
    return shape([(roll, paper), (core, surfaces.plain((190, 160, 120))), (sheet, paper),
                  (lid, rings)], [cylinder_part(r, h)])  # fmt: skip


@category("loofah", size=(0.12, 0.1, 0.1), mass=0.04, material="fabric", assembled=True,
          aliases=("bath puff", "shower puff", "bath sponge", "bath pouf", "shower sponge", "loofa",
          "luffa"), themes=("vanity",), colors=("pink", "teal"))  # fmt: skip
def loofah(look: Look) -> Shape:
    """A loofah: a ruffled bath puff with a cord."""
    color = look.color("pink", "teal", "purple", "white", "green", "blue", "orange")
    d = look.between(0.09, 0.12)
    ruffles: list[Solid] = []
    for k in range(26):
        z = -0.92 + 1.84 * k / 25
        a = 2.4 * k
        leaf = torus(0.15 * d, 0.028 * d, 12, 5).scale(1, 1, 0.8).turn(0, 0.9 * k).turn(1, 0.7 * k)
        out = 0.33 * d * np.sqrt(1 - z * z)
        ruffles.append(leaf.move(out * np.cos(a), out * np.sin(a), 0.34 * d * z))
    core = ball(0.78 * d, 0.78 * d, 0.76 * d, (0, 0, 0), 14)
    cord = rod([(0.3 * d, 0, -0.3 * d), (0.6 * d, 0.05 * d, -0.45 * d), (0.75 * d, 0, -0.455 * d),
                (0.62 * d, -0.08 * d, -0.45 * d), (0.32 * d, -0.02 * d, -0.32 * d)], 0.0018,
               6)  # fmt: skip
    net = prints.mesh_holes(color, tint_color(color, 0.75), 16, 16)
    body = join([*ruffles, core])
    body = body.move(z=-float(body.bounds[0, 2]) - 0.004)
    return put_down([(body, net), (cord.move(z=0.46 * d), surfaces.plain((246, 246, 244)))], body)


@category("tissue_pack", size=(0.107, 0.0565, 0.045), mass=0.03, material="paper",
          aliases=("pack of tissues", "pocket tissues", "tissue packet", "packet of tissues",
          "packet tissues", "pack of wipes", "packet of wipes"), themes=("vanity",),
          colors=("sky", "blue"), state="lying flat")  # fmt: skip
def tissue_pack(look: Look) -> Shape:
    """A pocket pack of tissues with one tissue sticking out of its slit."""
    x, y, h = look.between(0.1, 0.115), look.between(0.053, 0.06), look.between(0.022, 0.028)
    color = look.color("sky", "blue", "green", "pink", "lavender", "white", "teal")
    body = pad(x, y, h, 0.006, soft=0.35, steps=3)
    image = prints.canvas(112, 60, color)
    prints.fill(image, 0, 0.42, 1, 0.14, (246, 246, 244))
    prints.write(image, look.pick(["TISSUES", "SOFT"]), 0.27, 0.22, 0.24, readable_on(color), True)
    top = box(0.94 * x, 0.88 * y, 0.0008).move(z=h - 0.0004)
    tip = ellipsoid(0.05, 0.012, 0.03, 8, 5).move(0.008, 0, h + 0.006)
    return put_down([(body, surfaces.plain(tint_color(color, 0.92))), (top, image),
                    (tip, surfaces.plain((250, 250, 248)))], body, tip)  # fmt: skip


@category("dental_floss", size=(0.06, 0.019, 0.064), mass=0.03, material="plastic",
          aliases=("floss", "floss box", "box of dental floss"), themes=("vanity",),
          colors=("white", "mint"))  # fmt: skip
def dental_floss(look: Look) -> Shape:
    """A box of dental floss with an open lid and some thread pulled out."""
    color = look.color("white", "mint", "blue", "teal", "pink", "green")
    k = look.between(0.9, 1.15)
    body = block(0.042, 0.018, 0.05, 0.008, 0.002)
    lid = block(0.03, 0.018, 0.01, 0.004, 0.002).move(0.004, 0, 0.049)
    label = box(0.032, 0.0008, 0.022).move(0, -0.009, 0.012)
    image = prints.canvas(64, 44, tint_color(color, 0.6))
    prints.write(image, "FLOSS", 0.5, 0.5, 0.4, (250, 250, 248), bold=True)
    thread = rod([(-0.014, 0, 0.05), (-0.02, 0, 0.062), (-0.034, -0.002, 0.058),
                  (-0.038, -0.002, 0.04)], 0.0008, 5)  # fmt: skip
    return put_down([(body, look.surface(color, "plastic")),
                     (lid, surfaces.plain(tint_color(color, 0.8))), (label, image),
                     (thread, surfaces.plain((244, 246, 246)))], body, lid, factor=k)  # fmt: skip


STEEL = (196, 200, 206)


@category("tweezers", size=(0.095, 0.013, 0.009), mass=0.015, material="metal", assembled=True,
          aliases=("pair of tweezers", "tweezer", "eyebrow tweezers", "forceps", "epilator",
          "spudger", "haemostat", "hemostat", "tick remover", "needle holder", "tweezer set"),
          themes=("vanity",), colors=("silver",), state="lying")  # fmt: skip
def tweezers(look: Look) -> Shape:
    """A pair of tweezers, lying on its side."""
    color = look.color("silver", "pink", "black", "gold", "teal", "red")
    long = look.between(0.085, 0.105)
    h = long / 2
    arms = []
    for s in (-1, 1):
        path = smooth([(h, 0, 0.0045), (0.2 * h, s * 0.0058, 0.0045), (-0.6 * h, s * 0.005, 0.0045),
                       (-h, s * 0.0016, 0.0045)], 4)  # fmt: skip
        wide = np.interp(np.linspace(0, 1, len(path)), [0, 0.5, 0.85, 1], [1.0, 1.0, 0.7, 0.35])
        arms.append(_strip(path, wide))
    return put_down([(join(arms), look.surface(color, "metal"))], *arms)


def _strip(path: np.ndarray, wide: np.ndarray) -> Solid:
    """Return an upright strip, 9 mm tall, along a level path."""
    return sweep(path, rectangle(0.0014, 0.009), wide)


@category("nail_clippers", size=(0.063, 0.0126, 0.0168), mass=0.03, material="metal",
          aliases=("nail clipper", "nail cutter", "toenail clippers", "fingernail clippers"),
          themes=("vanity",), colors=("silver",), state="lying")  # fmt: skip
def nail_clippers(look: Look) -> Shape:
    """Closed nail clippers lying flat with the lever on top."""
    color = look.color("silver", "gold", "black", "pink", "blue")
    k = look.between(0.9, 1.2)
    steel = surfaces.brushed_metal(look.rng, STEEL)
    low = block(0.06, 0.012, 0.003, 0.003)
    jaws = block(0.014, 0.012, 0.009, 0.002, 0.001).move(-0.023)
    mid = block(0.055, 0.011, 0.002, 0.003).turn(1, 0.08).move(-0.002, 0, 0.006)
    lever = block(0.05, 0.01, 0.0026, 0.004).turn(1, -0.06).move(0.004, 0, 0.0112)
    post = cylinder(0.003, 0.016, 12).move(-0.017)
    return put_down([(join([low, jaws, mid, post]), steel), (lever, look.surface(color, "metal"))],
                   join([low, jaws]), join([mid, lever, post]), factor=k)  # fmt: skip


@category("bath_bomb", size=(0.063, 0.063, 0.062), mass=0.12, material="wax",
          aliases=("bath fizzer", "bath ball"), themes=("vanity",),
          colors=("pink", "lavender"))  # fmt: skip
def bath_bomb(look: Look) -> Shape:
    """A bath bomb: a rough ball with a seam and petals."""
    color = look.color("pink", "lavender", "yellow", "sky", "mint", "orange")
    d = look.between(0.055, 0.07)
    body = ellipsoid(d, d, d, 24, 14).move(z=0.475 * d)
    seam = cylinder(0.512 * d, 0.003, 28).move(z=0.474 * d)
    skin = surfaces.spots(
        look.rng, color, look.own_color("white", "purple", "yellow", "pink"), 0.14
    )
    return put_down([(body, skin), (seam, surfaces.plain(tint_color(color, 0.9)))], body)


@category("cotton_ball", size=(0.036, 0.036, 0.031), mass=0.001, material="fabric", assembled=True,
          aliases=("cotton wool", "cotton wool ball", "ball of cotton"), themes=("vanity",),
          roles=("round",), colors=("white",))  # fmt: skip
def cotton_ball(look: Look) -> Shape:
    """A cotton ball."""
    color = look.color("white", "white", "white", "pink", "sky", "cream")
    d = look.between(0.028, 0.045)
    puffs = [ball(0.5 * d, 0.5 * d, 0.45 * d, (0.27 * d * np.cos(2.4 * k) * np.sqrt(1 - z * z),
             0.27 * d * np.sin(2.4 * k) * np.sqrt(1 - z * z), 0.22 * d * z), 8)
             for k, z in enumerate(np.linspace(-0.9, 0.9, 14))]  # fmt: skip
    body = join(puffs).move(z=0.36 * d)
    return put_down([(body, surfaces.spots(look.rng, color, tint_color(color, 0.93), 0.3))], body)


@category("cotton_swab", size=(0.081, 0.006, 0.0057), mass=0.0005, material="fabric",
          assembled=True,
          aliases=("cotton bud", "q-tip", "q tip", "ear bud", "swab", "ear swab", "swab tube"),
          themes=("vanity",), colors=("white",), state="lying")  # fmt: skip
def cotton_swab(look: Look) -> Shape:
    """A cotton bud, lying flat."""
    color = look.color("white", "blue", "pink", "wooden", "green", "yellow")
    long = look.between(0.066, 0.085)
    r = 0.0012
    stick = straight((-long / 2, 0, 0.0026), (long / 2, 0, 0.0026), r, 8)
    buds = [ball(0.0135, 0.006, 0.006, (s * (long / 2 - 0.004), 0, 0.0027), 12) for s in (-1, 1)]
    return put_down([(stick, surfaces.plain(color)), (join(buds), surfaces.plain((250, 250, 248)))],
                   stick, *buds)  # fmt: skip


@category("cotton_pad", size=(0.058, 0.058, 0.006), mass=0.001, material="fabric",
          aliases=("cotton round", "makeup pad", "makeup remover pad", "cotton disc", "hand warmer",
          "cotton wool pad", "makeup wipe"), themes=("vanity",), roles=("round", "flat"),
          colors=("white",), state="lying flat")  # fmt: skip
def cotton_pad(look: Look) -> Shape:
    """A round cotton pad with a pressed edge."""
    color = look.color("white", "white", "cream", "pink", "mint")
    r = look.between(0.024, 0.034)
    body = lathe(
        [(0, 0), (r, 0.0005), (r, 0.002), (0.88 * r, 0.0035), (0.8 * r, 0.0055), (0, 0.006)], 30
    )
    return put_down([(body, surfaces.basketwork(look.rng, tint_color(color, 1.0), 30)
                      if look.chance(0.3) else surfaces.fabric(look.rng, color))],
                    body)  # fmt: skip


@category("shaving_brush", size=(0.044, 0.044, 0.112), mass=0.07, material="wood",
          aliases=("shave brush", "badger brush", "shaving kit"), themes=("vanity",),
          roles=("tall", "round"), colors=("black", "wooden"))  # fmt: skip
def shaving_brush(look: Look) -> Shape:
    """A shaving brush standing on its handle with its bristles up."""
    color = look.color("black", "wooden", "white", "brown", "silver", "red")
    handle = lathe([(0, 0), (0.018, 0), (0.019, 0.006), (0.011, 0.024), (0.015, 0.042),
                    (0.013, 0.052), (0, 0.052)], 24)  # fmt: skip
    collar = cylinder(0.0135, 0.006, 24).move(z=0.05)
    hair = lathe([(0, 0.055), (0.0125, 0.055), (0.022, 0.092), (0.016, 0.106), (0, 0.11)], 22)
    bristle = surfaces.stack(
        (surfaces.plain((60, 52, 48)), 0.5), (surfaces.plain((226, 212, 190)), 0.5)
    )
    return put_down([(handle, look.surface(color, "wood")), (collar, surfaces.plain((206, 172,
        96))),
                    (hair, bristle)], handle, hair, factor=look.between(0.9, 1.15))  # fmt: skip


@category("electric_shaver", size=(0.145, 0.062, 0.045), mass=0.16, material="device",
          aliases=("shaver", "electric razor", "beard trimmer", "hair trimmer", "trimmer",
          "hair clippers", "hair clipper", "nose hair trimmer", "bikini trimmer", "epilator device",
          "fabric shaver", "bobble remover"), themes=("vanity",), colors=("black", "navy"),
          state="lying")  # fmt: skip
def electric_shaver(look: Look) -> Shape:
    """An electric shaver lying on its back, with three round cutters in its head."""
    color = look.color("black", "navy", "silver", "gray", "red", "white")
    body = rod([(-0.03, 0, 0.02), (0.02, 0, 0.021), (0.075, 0, 0.018)], [0.021, 0.02, 0.0165], 18)
    body = body.scale(1, 1.15, 0.92)
    head = ball(0.05, 0.062, 0.034, (-0.045, 0, 0.021), 18)
    cutters = [cylinder(0.0125, 0.008, 18, bevel=0.001).turn(1, -0.9).move(-0.058 + 0.01 * (n == 1),
                                                                           0.017 * (n - 1) * 1.05,
                                                                           0.026 + 0.008 * (n == 1))
               for n in range(3)]  # fmt: skip
    switch = block(0.02, 0.012, 0.004, 0.005).move(0.012, 0, 0.0375)
    stripe = block(0.05, 0.008, 0.002, 0.003).move(0.05, 0, 0.0345)
    grip = surfaces.plain((52, 54, 60))
    return put_down([(body, look.surface(color, "plastic")), (head, grip),
                     (join(cutters), surfaces.brushed_metal(look.rng, (206, 208, 214))),
                     (join([switch, stripe]), surfaces.plain(look.own_color("silver", "blue",
                                                                            "orange")))], body,
                    head, factor=look.between(0.9, 1.1))  # fmt: skip


def _front(look: Look, words: tuple[str, ...], color: RGB) -> Tile:
    """Return a front label with a title on a background that suits ``color``."""
    pale = sum(color) > 480
    ground = tint_color(color, 0.92) if pale else color
    ink = tint_color(color, 0.35) if pale else (250, 250, 246)
    image = canvas(72, 112, ground)
    kind = int(look.rng.integers(3))
    other = look.own_color("teal", "gold", "pink", "navy", "green", "orange")
    if kind == 0:
        disc(image, 0.5, 0.68, 0.14, other)
        disc(image, 0.5, 0.68, 0.08, tint_color(other, 1.5))
    elif kind == 1:
        fill(image, 0, 0.58, 1, 0.05, other)
        fill(image, 0, 0.66, 1, 0.02, other)
    else:
        fill(image, 0.1, 0.52, 0.8, 0.34, other)
    write(image, look.pick(words), 0.5, 0.3, 0.14, ink, bold=True)
    fill(image, 0.25, 0.41, 0.5, 0.015, ink)
    return image


def _bottle(
    look: Look, words: tuple[str, ...], colors: tuple[str, ...], h: float, *, cap: str = "flip"
) -> Shape:
    """An oval plastic bottle with a "flip", "pump" or "screw" ``cap``."""
    color = look.color(*colors)
    x, y, h = look.between(0.056, 0.07), look.between(0.034, 0.042), h * look.between(0.9, 1.1)
    outline = rectangle(1, 1, 0.48, 6)
    waist = look.pick([1.0, 1.0, 0.93])
    levels = [(0.93, 0.0), (1.0, 0.03), (waist, 0.5), (1.0, 0.85), (0.8, 0.95), (0.42, 1.0)]
    body = loft(np.stack([np.column_stack([outline * [x * f, y * f], np.full(len(outline), h * z)])
                          for f, z in levels]), outline)  # fmt: skip
    label = box(0.72 * x, 0.0012, 0.56 * h).move(0, -0.5 * y * waist - 0.0002, 0.18 * h)
    lid = tint_color(color, 0.6) if look.chance(0.5) else (246, 246, 244)
    pieces: Pieces = [(body, look.surface(color, "plastic")), (label, _front(look, words, color))]
    if cap == "pump":
        neck = cylinder(0.4 * y, 0.016, 18, bevel=0.002).move(z=h - 0.002)
        stem = cylinder(0.004, 0.024, 10).move(z=h + 0.012)
        head = join([block(0.02, 0.016, 0.01, 0.005, 0.002),
                     straight((0, 0, 0.006), (0, -0.032, 0.003), 0.004)]).move(z=h
                                                                               + 0.034)  # fmt: skip
        top = join([neck, stem, head])
    elif cap == "screw":
        top = cylinder(0.38 * y, 0.02, 20, bevel=0.0015).move(z=h - 0.002)
    else:
        top = block(0.6 * x, 0.7 * y, 0.022, 0.45 * y, 0.002).move(z=h - 0.004)
    pieces.append((top, surfaces.plain(lid)))
    return put_down(pieces, body, top)


def _tube(look: Look, words: tuple[str, ...], colors: tuple[str, ...], h: float) -> Shape:
    """A squeeze tube with a flat upper end, standing on its cap."""
    color = look.color(*colors)
    r, h = look.between(0.02, 0.026), h * look.between(0.88, 1.12)
    outline = rectangle(2, 2, 0.98, 7)
    levels = [(r, r, 0.022), (r, r, 0.045), (1.05 * r, 0.8 * r, 0.5 * h),
              (1.2 * r, 0.35 * r, 0.9 * h), (1.22 * r, 0.0016, 0.96 * h),
              (1.22 * r, 0.0016, h)]  # fmt: skip
    body = loft(np.stack([np.column_stack([outline * [a, b], np.full(len(outline), z)])
                          for a, b, z in levels]), outline)  # fmt: skip
    cap = cylinder(0.92 * r, 0.024, 26, bevel=0.0015)
    label = loft(np.stack([np.array([(-a, -b - 0.0004, z), (a, -b - 0.0004, z), (a, -b + 0.002, z),
                                     (-a, -b + 0.002, z)]) for a, b, z in (
                 (0.55 * r, 1.01 * r, 0.04), (0.6 * r, 0.83 * r, 0.5 * h),
                 (0.66 * r, 0.45 * r, 0.86 * h))]),
                 np.array([(-r, -1.0), (r, -1.0), (r, 1.0), (-r, 1.0)]))  # fmt: skip
    low = label.vertices[:, 2].min()
    uv = np.column_stack([(label.vertices[:, 0] / (1.32 * r)) + 0.5,
                          (label.vertices[:, 2] - low) / np.ptp(label.vertices[:, 2])])  # fmt: skip
    label = Solid(label.vertices, label.faces, np.clip(uv, 0, 1))
    lid = look.pick([(246, 246, 244), tint_color(color, 0.55), (206, 172, 96)])
    return put_down([(body, look.surface(color, "plastic")), (cap, surfaces.plain(lid)),
                    (label, _front(look, words, color))], cap, body)  # fmt: skip


def _aerosol(
    look: Look, words: tuple[str, ...], colors: tuple[str, ...], r: float, h: float
) -> Shape:
    """A spray can with a domed shoulder and a cap."""
    color = look.color(*colors)
    k = look.between(0.9, 1.1)
    print_ = prints.label(look.rng, look.pick(words), look.own_color("blue", "red", "green",
                                                                     "black", "teal", "purple"),
                          color)  # fmt: skip
    body = lathe([(0, 0), (r, 0), (r, h), (0, h)], 30, v=[0, 0, 1, 1])
    dome = lathe([(0, h - 0.001), (r, h - 0.001), (0.8 * r, h + 0.01), (0, h + 0.012)], 28)
    cap = cylinder(0.78 * r, 0.032, 26, bevel=0.003).move(z=h + 0.006)
    lid = look.pick([(244, 244, 242), (60, 62, 68), tint_color(color, 0.6)])
    made = shape([(body, print_), (dome, surfaces.brushed_metal(look.rng, (204, 206, 210))),
                  (cap, surfaces.plain(lid))], [cylinder_part(r, h), hull_of(cap)])  # fmt: skip
    return made.scale(k)


@category("shampoo", size=(0.063, 0.0385, 0.193), mass=0.3, material="plastic",
          aliases=("shampoo bottle", "bottle of shampoo", "shower gel", "body wash",
          "shower gel bottle", "bubble bath", "bath gel", "mini shampoo bottle"),
          themes=("vanity",), roles=("tall",), colors=("green", "pink"))  # fmt: skip
def shampoo(look: Look) -> Shape:
    """A shampoo bottle with a flip cap."""
    return _bottle(look, ("SHAMPOO",), ("green", "pink", "orange", "sky", "white", "purple"), 0.175)


@category("conditioner", size=(0.063, 0.0385, 0.183), mass=0.3, material="plastic",
          aliases=("hair conditioner", "conditioner bottle", "bottle of conditioner"),
          themes=("vanity",), roles=("tall",), colors=("white",))  # fmt: skip
def conditioner(look: Look) -> Shape:
    """A bottle of hair conditioner."""
    return _bottle(
        look, ("CONDITION",), ("white", "cream", "teal", "gold", "pink", "lavender"), 0.165
    )


@category("body_lotion", size=(0.063, 0.05, 0.195), mass=0.3, material="plastic", aliases=("lotion",
          "lotion bottle", "body cream", "bottle of lotion", "pump bottle", "body milk",
          "balm lotion", "hand sanitizer", "hand sanitiser", "hand gel", "micellar water",
          "hand sanitizer bottle"), themes=("vanity",), roles=("tall",),
          colors=("white", "pink"))  # fmt: skip
def body_lotion(look: Look) -> Shape:
    """A bottle of body lotion with a pump."""
    return _bottle(look, ("LOTION", "BODY MILK"), ("white", "cream", "pink", "sky", "sage",
                                                   "yellow"), 0.15, cap="pump")  # fmt: skip


@category("sunscreen", size=(0.063, 0.0385, 0.163), mass=0.22, material="plastic",
          aliases=("sun cream", "sunblock", "sun lotion", "bottle of sunscreen", "suntan lotion",
          "sunscreen bottle", "sunscreen tube", "sun cream bottle", "tube of sunscreen"),
          themes=("vanity",), roles=("tall",), colors=("orange", "yellow"))  # fmt: skip
def sunscreen(look: Look) -> Shape:
    """A bottle of sunscreen."""
    return _bottle(look, ("SPF 50", "SUN 30"), ("orange", "yellow", "amber", "sky", "white"), 0.145)


@category("mouthwash", size=(0.063, 0.0385, 0.183), mass=0.5, material="plastic",
          aliases=("mouth wash", "bottle of mouthwash", "mouthwash bottle"), themes=("vanity",),
          roles=("tall",), colors=("teal", "blue"))  # fmt: skip
def mouthwash(look: Look) -> Shape:
    """A bottle of coloured mouthwash."""
    return _bottle(look, ("FRESH", "MOUTH"), ("teal", "blue", "green", "purple", "sky"), 0.165,
                   cap="screw")  # fmt: skip


@category("aftershave", size=(0.053, 0.03, 0.112), mass=0.2, material="glass", aliases=("cologne",
          "after shave", "aftershave bottle", "cologne bottle", "eau de cologne"),
          themes=("vanity",), roles=("tall",), colors=("navy", "amber"))  # fmt: skip
def aftershave(look: Look) -> Shape:
    """A square glass bottle of aftershave with a heavy cap."""
    color = look.color("navy", "amber", "black", "green", "sky", "gray", "silver")
    x, y, h = look.between(0.046, 0.06), look.between(0.026, 0.034), look.between(0.07, 0.09)
    body = block(x, y, h, 0.005, 0.003)
    neck = cylinder(0.009, 0.01, 16).move(z=h - 0.001)
    cap = block(0.03, 0.024, 0.026, 0.004, 0.002).move(z=h + 0.006)
    label = box(0.66 * x, 0.001, 0.46 * h).move(0, -y / 2, 0.22 * h)
    image = canvas(64, 48, (236, 236, 232))
    write(image, look.pick(["HOMME", "SPORT", "WOOD", "NO. 5"]), 0.5, 0.5, 0.3, (40, 40, 46), True)
    metal = surfaces.brushed_metal(
        look.rng, look.pick([(200, 202, 206), (70, 70, 76), (206, 172, 96)])
    )
    return put_down([(body, surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.3),
                                              look.rng)), (join([neck, cap]), metal),
                     (label, image)], body, cap)  # fmt: skip


@category("hand_cream", size=(0.056, 0.046, 0.12), mass=0.07, material="plastic",
          aliases=("hand cream tube", "tube of hand cream", "tube of cream", "hand lotion",
          "ointment", "tube of ointment", "cream tube", "moisturiser tube", "primer tube",
          "ointment tube", "tube of antiseptic cream", "burn gel tube", "arnica tube",
          "antiseptic cream", "contact lens solution tube", "sun cream tube"), themes=("vanity",),
          roles=("tall",), colors=("pink", "white"))  # fmt: skip
def hand_cream(look: Look) -> Shape:
    """A tube of hand cream, standing on its cap."""
    return _tube(
        look, ("HAND", "CREAM"), ("pink", "white", "sage", "lavender", "yellow", "sky"), 0.12
    )


@category("face_wash", size=(0.056, 0.046, 0.16), mass=0.15, material="plastic",
          aliases=("facial cleanser", "hair gel", "face wash tube", "facewash", "tube of gel"),
          themes=("vanity",), roles=("tall",), colors=("teal", "blue"))  # fmt: skip
def face_wash(look: Look) -> Shape:
    """A tube of face wash or gel, standing on its cap."""
    return _tube(look, ("FACE", "GEL", "WASH"), ("teal", "blue", "green", "white", "orange"), 0.16)


@category("shaving_foam", size=(0.052, 0.052, 0.163), mass=0.25, material="metal",
          aliases=("shaving cream", "can of shaving foam", "shaving gel", "can of shaving cream"),
          themes=("vanity",), roles=("tall", "round"), colors=("white", "blue"))  # fmt: skip
def shaving_foam(look: Look) -> Shape:
    """A can of shaving foam."""
    return _aerosol(look, ("SHAVE", "FOAM"), ("white", "blue", "silver", "green"), 0.026, 0.125)


@category("hairspray", size=(0.048, 0.048, 0.223), mass=0.25, material="metal",
          aliases=("hair spray", "can of hairspray", "dry shampoo", "can of hair spray"),
          themes=("vanity",), roles=("tall", "round"), colors=("purple",))  # fmt: skip
def hairspray(look: Look) -> Shape:
    """A tall can of hair spray."""
    return _aerosol(
        look, ("HAIR", "STYLE"), ("purple", "black", "gold", "pink", "white"), 0.024, 0.185
    )


@category("deodorant", size=(0.058, 0.034, 0.108), mass=0.1, material="plastic",
          aliases=("deodorant stick", "deo", "antiperspirant", "roll on", "roll-on",
          "roll-on deodorant", "roll on deodorant"), themes=("vanity",), roles=("tall",),
          colors=("white", "blue"))  # fmt: skip
def deodorant(look: Look) -> Shape:
    """A capped deodorant stick with an oval body."""
    color = look.color("white", "blue", "black", "green", "pink", "teal", "gray")
    h = look.between(0.095, 0.12)
    lower = block(0.056, 0.032, 0.58 * h, 0.0155, 0.002)
    upper = block(0.058, 0.034, 0.44 * h, 0.0165, 0.004).move(z=0.56 * h)
    foot = block(0.05, 0.027, 0.008, 0.013)
    label = box(0.034, 0.001, 0.4 * h).move(0, -0.0162, 0.1 * h)
    lid = look.pick([tint_color(color, 0.5), (246, 246, 244), tint_color(color, 1.4)])
    return put_down([(join([lower, foot]), look.surface(color, "plastic")),
                     (upper, surfaces.plain(lid)), (label, _front(look, ("DEO", "48H", "FRESH"),
                                                                  color))], lower,
                    upper)  # fmt: skip


PASTELS = ("pink", "lavender", "cream", "mint", "coral", "white", "gold", "navy")


@category("perfume_bottle", size=(0.058, 0.032, 0.1), mass=0.2, material="glass",
          aliases=("perfume", "fragrance", "perfume sample", "scent atomiser", "perfume miniature",
          "atomizer", "scent bottle", "room spray"), themes=("vanity",), colors=("pink", "amber"),
          common=True)  # fmt: skip
def perfume_bottle(look: Look) -> Shape:
    """A cut-glass perfume bottle with a collar and a cap."""
    x, y, h = look.between(0.05, 0.065), look.between(0.026, 0.034), look.between(0.06, 0.075)
    liquid = look.color("pink", "amber", "lavender", "sky", "mint")
    metal = surfaces.brushed_metal(look.rng, look.own_color("gold", "silver", "black", "copper"))
    face = prints.canvas(96, 96, tint_color(liquid, 1.25))
    prints.fill(face, 0, 0.0, 1, 0.14, tint_color(liquid, 1.5))
    prints.fill(face, 0.25, 0.42, 0.5, 0.24, (248, 246, 240))
    prints.write(face, look.pick(["FLEUR", "NOIR", "ROSE", "AQUA"]), 0.5, 0.54, 0.11, (60, 50, 50))
    round_one = look.chance(0.35)
    body = (
        prism(ellipse(x, y * 1.25, 24), 0, h, 0.004) if round_one else block(x, y, h, 0.006, 0.004)
    )
    front = box(x * 0.8, y * 1.02, h * 0.86).move(z=h * 0.07) if not round_one else body
    collar = cylinder(0.009, 0.008, 16).move(z=h)
    cap = cylinder(0.0135, 0.026, 20, bevel=0.003).move(z=h + 0.008)
    return shape([(body, surfaces.plain(tint_color(liquid, 1.15))), (front, face), (collar, metal),
                  (cap, metal)], [hull_of(body), cylinder_part(0.0135, 0.034,
                                                               (0, 0, h))])  # fmt: skip


@category("cream_jar", size=(0.064, 0.064, 0.05), mass=0.12, material="glass",
          aliases=("face cream", "cream", "moisturizer", "jar of cream", "metal polish tin",
          "shoe polish tin", "wax polish tin", "shoe polish", "moustache wax tin",
          "aftershave balm", "silver polish jar", "hair gel tub", "hair mask tub", "body scrub tub",
          "nappy cream tub", "boot polish", "polish tin", "cold cream jar", "face cream jar",
          "lip balm pot", "petroleum jelly tub", "vaseline"), themes=("vanity",), roles=("round",),
          colors=("white", "pink"), common=True)  # fmt: skip
def cream_jar(look: Look) -> Shape:
    """A squat jar with a wide lid."""
    r, h = look.between(0.028, 0.034), look.between(0.028, 0.034)
    color = look.color(*PASTELS)
    word = look.pick(["CREAM", "BALM", "GLOW", "CARE"])
    print_ = prints.label(look.rng, word, tint_color(color, 0.6), tint_color(color, 1.2))
    lid = surfaces.speckles(look.rng, look.own_color("white", "gold", "black", "silver"), 3)
    top = cylinder(r * 1.04, 0.019, 28, bevel=0.003).move(z=h)
    return shape([(cylinder(r, h, 28, bevel=0.003), print_), (top, lid)],
                 [cylinder_part(r, h), cylinder_part(r * 1.04, 0.019, (0, 0, h))])  # fmt: skip


TINTS = ("blue", "red", "green", "pink", "purple", "teal", "white", "orange", "black")


@category("toothbrush", size=(0.182, 0.0125, 0.017), mass=0.018, material="plastic",
          aliases=("tooth brush", "manual toothbrush", "electric toothbrush", "interdental brush",
          "toothbrush head", "water flosser"), themes=("vanity",), roles=("flat",),
          colors=("blue", "red"), state="lying flat")  # fmt: skip
def toothbrush(look: Look) -> Shape:
    """A toothbrush lying on its back with its bristles up and its head on the left."""
    long = look.between(0.17, 0.195)
    color = look.color(*TINTS)
    path = smooth([(-0.5 * long, 0, 0.0047), (-0.3 * long, 0, 0.0048), (-0.1 * long, 0, 0.0054),
                   (0.15 * long, 0, 0.0066), (0.5 * long, 0, 0.0055)], 4)  # fmt: skip
    t = np.linspace(0, 1, len(path))
    wide = np.interp(t, [0, 0.03, 0.14, 0.2, 0.3, 0.45, 0.7, 0.96, 1],
                     [0.7, 1.05, 1.1, 0.55, 0.5, 0.95, 1.15, 1.0, 0.6])  # fmt: skip
    rod = sweep(path, rectangle(0.0105, 0.0078, 0.003, 3), wide)
    skin = look.surface(color, "plastic")
    grip = block(0.3 * long, 0.0075, 0.003, 0.0035).move(x=0.22 * long, z=0.0085)
    tufts: dict[bool, list[Solid]] = {True: [], False: []}
    for i in range(7):
        for j in range(3):
            tuft = cylinder(0.0015, 0.011, 6).move(
                -0.48 * long + 0.0038 * i, (j - 1) * 0.0034, 0.006
            )
            tufts[i in (0, 3, 6)].append(tuft)
    pieces = [
        (rod, skin),
        (grip, surfaces.plain(tint_color(color, 0.6) if sum(color) > 250 else (220, 60, 60))),
        (join(tufts[False]), surfaces.plain((246, 246, 244))),
        (join(tufts[True]), surfaces.plain(look.own_color("sky", "blue", "green", "pink"))),
    ]
    x = rod.vertices[:, 0]
    return shape(pieces, [hull_part(rod.vertices[x < -0.2 * long]), hull_part(rod.vertices[x > -0.25
                                                                                           * long]),
                          hull_of(*tufts[True])])  # fmt: skip


@category("toothpaste", size=(0.15, 0.045, 0.034), mass=0.11, material="plastic",
          aliases=("tube of toothpaste", "toothpaste tube", "tooth paste"), themes=("vanity",),
          colors=("white", "red"), state="lying flat")  # fmt: skip
def toothpaste(look: Look) -> Shape:
    """A tube of toothpaste lying flat, with its cap on the left and its seam on the right."""
    x, y, h = look.between(0.13, 0.165), look.between(0.04, 0.05), look.between(0.028, 0.036)
    color = look.color("white", "white", "blue", "red", "green", "sky", "mint")
    other = look.own_color("red", "blue", "green", "teal", "navy")
    image = prints.canvas(192, 128, color)
    for k in (0, 1):
        part = image[64 * k : 64 * k + 64]
        prints.polygon(part, [(0, 0.9), (0.5, 0.62), (1, 0.9), (1, 1), (0, 1)], other)
        prints.polygon(part, [(0, 0), (0.6, 0), (0.25, 0.24), (0, 0.2)], tint_color(other, 1.4))
        prints.write(part, look.pick(["FRESH MINT", "DENTAL", "WHITE+", "TOOTHPASTE"]), 0.52, 0.45,
                     0.3, tint_color(other, 0.7) if sum(color) > 420 else (250, 250, 250),
                     bold=True)  # fmt: skip
    n = 28
    a = 2 * np.pi * np.arange(n) / n
    rings = []
    for u in np.linspace(0, 1, 9):
        wide = y / 2 * (0.78 + 0.22 * u)
        tall = h / 2 * (1 - u**1.6) + 0.0012
        rings.append(np.column_stack([np.full(n, -x / 2 + 0.02 + (x - 0.02) * u), wide * np.cos(a),
                                      tall * np.sin(a) + 0.42 * h * (1 - u**1.4)
                                      + 0.004]))  # fmt: skip
    circle = np.column_stack([np.cos(a), np.sin(a)])
    body = loft(np.stack(rings), circle)
    # around the tube, u runs from the right over the top; align the picture with x instead
    v = body.vertices
    uv = np.column_stack([(v[:, 0] + x / 2) / x, (v[:, 1] + y / 2) / y])
    body = Solid(v, body.faces, np.clip(uv, 0, 1))
    low = -float(body.bounds[0, 2])
    body = body.move(z=low)
    seam = box(0.012, y, 0.0024).move(
        x=x / 2 - 0.004, z=float(body.vertices[v[:, 0] > 0.45 * x][:, 2].min())
    )
    cap = cylinder(0.011, 0.024, 20, top=0.0125, bevel=0.001).turn(1, np.pi / 2)
    cap = cap.move(x=-x / 2, z=max(0.42 * h + 0.004 + low, 0.0125))
    face = image[:64]
    x_ = body.vertices[:, 0]
    cap_part = hull_of(cap)
    return shape([(body, face), (seam, surfaces.plain(tint_color(color, 0.9))),
                  (cap, surfaces.plain(look.own_color("white", "red", "blue", "green")))],
                 [flat_foot(body.vertices[x_ < 0.1 * x], 0.12), flat_foot(body.vertices[x_ > 0.0],
                                                                          0.12),
                  cap_part])  # fmt: skip


@category("soap_bar", size=(0.0877, 0.054, 0.0261), mass=0.1, material="wax", assembled=True,
          aliases=("bar of soap", "soap", "bar soap", "piece of soap", "surf wax", "soap on a rope",
          "bar of laundry soap", "laundry soap"), themes=("vanity",), colors=("white", "pink"),
          state="lying flat")  # fmt: skip
def soap_bar(look: Look) -> Shape:
    """A bar of soap with an embossed word, alone or on a dish."""
    x, y, h = look.between(0.075, 0.095), look.between(0.05, 0.06), look.between(0.022, 0.03)
    color = look.color("white", "cream", "pink", "mint", "lavender", "yellow", "sage", "sky", "tan")
    outline = rectangle(x, y, look.pick([0.012, 0.024]), 6)
    bar = loft(np.stack([np.column_stack([outline * s, np.full(len(outline), z)]) for s,
                         z in ((0.86, 0), (0.98, 0.25 * h), (1.0, 0.5 * h), (0.98, 0.75 * h),
                               (0.84, h))]), outline)  # fmt: skip
    sign = prints.canvas(96, 64, color)
    prints.write(sign, look.pick(["SOAP", "PURE", "DOVE", "LAVA", "OLIVE"]), 0.5, 0.5, 0.32,
                 tint_color(color, 0.72), True)  # fmt: skip
    plate = block(0.66 * x, 0.6 * y, 0.0006, 0.008).move(z=h - 0.0002)
    skin = (surfaces.marble(look.rng, color, tint_color(color, 0.88)) if look.chance(0.3)
            else surfaces.speckles(look.rng, color, 4, 32))  # fmt: skip
    pieces, parts = [(bar, skin), (plate, sign)], [hull_of(bar)]
    if look.chance(0.45):
        up = 0.011
        dish = loft(np.stack([np.column_stack([rectangle(1, 1, 0.3, 5) * [a, b], np.full(24, z)])
                              for a, b, z in ((0.8 * x, 0.7 * y, 0), (1.3 * x, 1.34 * y, 0.016),
                                              (1.25 * x, 1.27 * y, 0.016),
                                              (0.95 * x, 0.9 * y, 0.0095))]),
                    rectangle(1, 1, 0.3, 5))  # fmt: skip
        pieces = [(s.move(z=up), t) for s, t in pieces]
        pieces.append(
            (dish, look.surface(look.own_color("white", "sky", "gray", "tan", "teal"), "ceramic"))
        )
        parts = [hull_of(pieces[0][0]), hull_of(dish)]
    return shape(pieces, parts)


@category("razor", size=(0.125, 0.041, 0.024), mass=0.035, material="metal",
          aliases=("safety razor", "shaving razor", "disposable razor", "razor blade",
          "cut-throat razor", "straight razor", "dermaplaning blade", "clipper guard",
          "shaver head"), themes=("vanity",), colors=("silver", "blue"),
          state="lying flat")  # fmt: skip
def razor(look: Look) -> Shape:
    """A safety or disposable razor lying flat with its head on the left."""
    long = look.between(0.125, 0.145)
    color = look.color("silver", "blue", "pink", "black", "green", "orange", "white", "gold")
    skin = look.surface(color, look.pick(["metal", "plastic"]))
    wide = look.between(0.038, 0.043)
    path = smooth([(-0.36 * long, 0, 0.016), (-0.1 * long, 0, 0.0095), (0.2 * long, 0, 0.006),
                   (0.5 * long, 0, 0.0055)], 4)  # fmt: skip
    grip = sweep(
        path,
        rectangle(0.0115, 0.0105, 0.004, 3),
        np.interp(np.linspace(0, 1, len(path)), [0, 0.3, 0.8, 1], [0.6, 0.9, 1.0, 0.75]),
    )
    ribs = [
        torus(0.0064, 0.0009, 14, 5).turn(1, np.pi / 2).move(x=(0.12 + 0.05 * n) * long, z=0.0062)
        for n in range(6)
    ]
    head = block(0.016, wide, 0.011, 0.004, 0.002).turn(1, 0.25).move(x=-0.4 * long, z=0.0105)
    blades = [box(0.0012, 0.9 * wide, 0.0012).turn(1, 0.25).move(x=-0.4 * long + 0.003 * n, z=0.0212
                                                                 - 0.0008 * n)
              for n in (-1, 0, 1)]  # fmt: skip
    guard = box(0.005, wide, 0.004).turn(1, 0.25).move(x=-0.4 * long - 0.008, z=0.012)
    foot = box(0.012, 0.02, 0.011).move(x=-0.4 * long + 0.001)
    dark = surfaces.plain((50, 51, 56))
    return shape([(join([grip, *ribs]), skin), (join([head, foot]), dark),
                  (join(blades), surfaces.plain((206, 208, 214))),
                  (guard, surfaces.plain(look.own_color("mint", "white", "sky", "green")))],
                 [hull_of(head), hull_of(foot), hull_of(grip)])  # fmt: skip


@category("nail_file", size=(0.153, 0.0148, 0.00436), mass=0.008, material="plastic",
          aliases=("emery board", "nail buffer"), themes=("vanity",), roles=("flat",),
          colors=("pink", "silver"), state="lying flat")  # fmt: skip
def nail_file(look: Look) -> Shape:
    """A nail file lying flat: an emery board, or a steel file with a handle."""
    long = look.between(0.13, 0.18)
    color = look.color("pink", "coral", "gray", "black", "teal", "violet", "red", "white")
    if look.chance(0.6):
        wide = look.between(0.014, 0.02)
        board = block(long, wide, 0.003, wide / 2 - 0.0005)
        grit = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.35)
        top = block(0.985 * long, 0.92 * wide, 0.0006, wide / 2 - 0.0016).move(z=0.0029)
        return shape(
            [(board, surfaces.plain((240, 236, 228))), (top, grit)], [box_part(long, wide, 0.0034)]
        )
    blade = prism(np.array([(-0.5 * long, -0.0005), (-0.4 * long, -0.0042), (0.16 * long, -0.0055),
                            (0.16 * long, 0.0055), (-0.4 * long, 0.0042), (-0.5 * long, 0.0005)]),
                  0.002, 0.0034)  # fmt: skip
    hatch = surfaces.grid((120, 124, 130), (196, 199, 204), 40, 10, 128)
    grip = block(0.36 * long, 0.012, 0.0058, 0.0055, 0.002).move(x=0.32 * long)
    return shape([(blade, hatch), (grip, look.surface(color, "plastic"))],
                 [hull_of(blade), hull_of(grip)])  # fmt: skip
