"""Objects of the ``living`` theme: optical instruments."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import GLASS_TONE, steel
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import at_box, drum, plate
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, plain, tint_color

DARK: RGB = (38, 36, 38)


@category("binoculars", size=(0.118, 0.0571, 0.127), mass=0.6, material="plastic",
          aliases=("binocular", "field glasses", "pair of binoculars", "opera glasses"),
          themes=("living",), roles=("tall",), colors=("black", "olive"))  # fmt: skip
def binoculars(look: Look) -> Shape:
    """Binoculars standing on their objective lenses with the eyepieces up, or lying flat."""
    k = look.between(0.85, 1.08)
    color = look.color("black", "olive", "charcoal", "green", "navy", "black")
    rubber = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.2)
    dark = surfaces.speckles(look.rng, DARK, 4)
    barrels, rims, lenses, parts = [], [], [], []
    for s in (-1, 1):
        barrel = lathe([(0, 0), (0.029, 0), (0.03, 0.03), (0.03, 0.055), (0.024, 0.075),
                        (0.023, 0.1), (0.016, 0.112), (0, 0.112)], 24).scale(k, k, k)  # fmt: skip
        eye = lathe([(0, 0.108), (0.0175, 0.108), (0.02, 0.14), (0.014, 0.14), (0.012, 0.134),
                     (0, 0.134)], 22).scale(k, k, k)  # fmt: skip
        glass = lathe([(0, 0.1345), (0.0118, 0.1345), (0.011, 0.136), (0, 0.137)], 18).scale(
            k, k, k
        )
        x = s * 0.034 * k
        barrels.append(barrel.move(x=x))
        rims.append(eye.move(x=x * 0.94))
        lenses.append(glass.move(x=x * 0.94))
        parts += [hull_of(barrels[-1]), hull_of(rims[-1])]
    bridge = [block(0.05 * k, 0.034 * k, 0.06 * k, 0.012, 0.004).move(z=0.035 * k),
              cylinder(0.011 * k, 0.03 * k, 18, bevel=0.001).move(z=0.094 * k)]  # fmt: skip
    rings = [
        torus(0.0295 * k, 0.002 * k, 26, 6).move(x=s * 0.034 * k, z=0.003 * k) for s in (-1, 1)
    ]
    return shape(
        [(join(barrels), rubber), (join([*rims, *bridge, *rings]), dark),
         (join(lenses), surfaces.plain((96, 70, 120)))],
        [*parts, hull_of(*bridge)],
    )  # fmt: skip


@category("telescope", size=(0.294, 0.144, 0.257), mass=0.9, material="plastic", assembled=True,
          aliases=("spyglass", "toy telescope", "desktop telescope", "telescope eyepiece",
          "finderscope", "monocular", "teleconverter", "spotting scope", "kaleidoscope"),
          themes=("living", "office"), roles=("tall", "big"),
          colors=("white", "brass"))  # fmt: skip
def telescope(look: Look) -> Shape:
    """A small telescope on a tripod, pointing up and to the left."""
    k = look.between(0.9, 1.1)
    color = look.color("white", "brass", "black", "navy", "red", "silver", "blue")
    tube_tile = look.surface(color, "metal")
    dark = surfaces.speckles(look.rng, look.own_color("black", "brown", "charcoal"), 4)
    brass = surfaces.brushed_metal(look.rng, look.own_color("brass", "silver", "gold"))
    profile = [(0, 0), (0.022, 0), (0.022, 0.2), (0.026, 0.2), (0.026, 0.26), (0.022, 0.26),
               (0.022, 0.25), (0, 0.25)]  # fmt: skip
    main = lathe(profile, 26).move(z=-0.1)
    eye = lathe([(0, -0.15), (0.011, -0.15), (0.013, -0.14), (0.013, -0.1), (0, -0.1)], 20)
    bands = [torus(0.0225, 0.0025, 26, 6).move(z=z) for z in (-0.095, -0.02, 0.09)]
    finder = join([cylinder(0.006, 0.07, 12).move(0, 0.036, -0.09),
                     box(0.004, 0.02, 0.008).move(0, 0.028, -0.07)])  # fmt: skip
    rise = look.between(0.35, 0.6)
    high = 0.155

    def up(solid: Solid) -> Solid:
        return solid.turn(1, -(np.pi / 2 - rise)).move(z=high).scale(k, k, k)

    feet, parts = [], []
    for n in range(3):
        a = np.pi / 2 + 2 * np.pi * n / 3
        leg = tube([(0.008 * k * np.cos(a), 0.008 * k * np.sin(a), (high - 0.02) * k),
                    (0.09 * k * np.cos(a), 0.09 * k * np.sin(a), 0.004 * k)],
                   [0.0055 * k, 0.004 * k], 8)  # fmt: skip
        feet.append(leg)
        parts.append(hull_of(leg))
    head = join([cylinder(0.013 * k, 0.022 * k, 16).move(z=(high - 0.035) * k),
                   box(0.016 * k, 0.03 * k, 0.03 * k).move(z=(high - 0.022) * k)])  # fmt: skip
    spread = [tube([_half_leg(n, k, high), (0, 0, 0.06 * k)], 0.0022 * k, 6) for n in range(3)]
    return shape(
        [(up(main), tube_tile), (join([up(eye), up(finder), head]), dark),
         (join([up(b) for b in bands]), brass), (join([*feet, *spread]), dark)],
        [*parts, hull_of(up(main)), hull_of(up(eye)), hull_of(head)],
    )  # fmt: skip


def _half_leg(n: int, k: float, high: float) -> tuple[float, float, float]:
    """Return the midpoint of leg ``n`` of a telescope's tripod."""
    a = np.pi / 2 + 2 * np.pi * n / 3
    return 0.05 * k * float(np.cos(a)), 0.05 * k * float(np.sin(a)), 0.5 * (high - 0.02) * k


@category("astrolabe", size=(0.124, 0.148, 0.0103), mass=0.4, material="metal",
          aliases=("astrolabe replica", "brass astrolabe"), themes=("living",), roles=("flat",),
          colors=("gold",))  # fmt: skip
def astrolabe(look: Look) -> Shape:
    """An astrolabe lying flat: a brass disc with rings, a pointer and a hanging ring."""
    k = look.between(0.85, 1.2)
    color = look.color("gold", "bronze", "copper", "brass")
    disk = drum(0.06, 0.005, sides=36, bevel=0.001)
    rim = torus(0.056, 0.003, 36, 8).move(z=0.005)
    inner = torus(0.032, 0.0016, 28, 6).move(0.008, 0.01, 0.0064)
    pointer = [plate([(-0.054, -0.003), (0.054, -0.0045), (0.054, 0.0045), (-0.054, 0.003)], 0.0015,
                     at=(0, 0, 0.0075)).turn(2, look.between(0.2, 2.8)),
               drum(0.005, 0.005, (0, 0, 0.005))]  # fmt: skip
    loop = torus(0.009, 0.002, 18, 6).move(0, 0.072, 0.0022)
    neck = plate([(-0.014, 0.054), (0.014, 0.054), (0.006, 0.068), (-0.006, 0.068)], 0.005)
    face = prints.canvas(128, 128, color)
    for r in (0.46, 0.36, 0.24):
        prints.disc(face, 0.5, 0.5, r, tint_color(color, 0.6), r - 0.012)
    for a in np.arange(24) * np.pi / 12:
        tip = [(0.5 + r * np.cos(a), 0.5 + r * np.sin(a)) for r in (0.37, 0.44)]
        prints.stroke(face, tip, 0.012, tint_color(color, 0.5))
    return put_down([(disk, face), (join([rim, inner, *pointer, loop, neck]), steel(look, color))],
                    disk, neck, factor=k)  # fmt: skip


@category("stereoscope", size=(0.165, 0.273, 0.127), mass=0.4, material="wood", assembled=True,
          aliases=("stereo viewer", "stereoscopic viewer"), themes=("living",),
          colors=("brown",))  # fmt: skip
def stereoscope(look: Look) -> Shape:
    """A stereoscope: a hooded lens board, a bar and a card with two photographs."""
    color = look.color("brown", "wooden", "maroon")
    k = look.between(0.85, 1.15)
    rail = at_box(0.03, 0.26, 0.014, (0, 0.05, 0.03))
    foot = [at_box(0.1, 0.17, 0.006, (0, 0.05, 0)), at_box(0.02, 0.03, 0.03, (0, 0.05, 0.004))]
    rim = [(-0.075, 0), (0.075, 0), (0.07, 0.062), (0.025, 0.062), (0, 0.048), (-0.025, 0.062),
           (-0.07, 0.062)]  # fmt: skip
    hood = plate(rim, 0.055).turn(0, np.pi / 2).move(0, -0.035, 0.036)
    eyes = [drum(0.019, 0.003, (s * 0.034, -0.0925, 0.068), 1) for s in (-1, 1)]
    card = at_box(0.165, 0.003, 0.085, (0, 0.15, 0.042))
    holder = at_box(0.12, 0.02, 0.01, (0, 0.15, 0.04))
    image = prints.canvas(160, 84, (206, 180, 140))
    for x in (0.06, 0.52):
        prints.fill(image, x, 0.1, 0.42, 0.8, (160, 130, 96))
        prints.disc(image, x + 0.21, 0.42, 0.2, (100, 78, 58))
        prints.fill(image, x, 0.66, 0.42, 0.24, (86, 66, 48))
    wood = look.surface(color, "wood")
    return put_down(
        [(join([rail, *foot, holder]), wood), (hood, steel(look, (150, 110, 72))),
         (join(eyes), plain(GLASS_TONE)), (card, image)],
        *foot, rail, hood, card, factor=k)  # fmt: skip


@category("camera", size=(0.125, 0.085, 0.093), mass=0.45, material="device",
          aliases=("photo camera", "digital camera", "dslr", "leica", "polaroid camera",
          "film camera", "slr camera", "mirrorless camera"), themes=("living", "craft", "office"),
          colors=("black", "silver"), common=True)  # fmt: skip
def camera(look: Look) -> Shape:
    """A photo camera with its lens towards the viewer."""
    x, y, z = look.between(0.118, 0.132), look.between(0.042, 0.05), look.between(0.072, 0.082)
    color = look.color("black", "black", "silver", "brown", "navy", "red", "teal", "cream", "pink")
    leather = surfaces.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.6), 0.2)
    metal = surfaces.speckles(look.rng, look.own_color("black", "silver", "charcoal"), 3, 32)
    r, reach = look.between(0.3, 0.43) * z, look.between(0.02, 0.055)
    body = block(x, y, z * 0.76, 0.012)
    top = block(x, y, z * 0.24, 0.012, 0.002).move(z=z * 0.76)
    tall, aside = look.between(0.006, 0.022), look.pick([0.0, 0.0, -0.25 * x])
    hump = block(0.042, y * 0.9, tall, 0.4 * tall, 0.2 * tall).move(x=aside, z=z - 0.002)
    lens = cylinder(r, reach, 28, bevel=0.002).turn(0, np.pi / 2).move(y=-y / 2 + 0.001, z=0.46 * z)
    ring = torus(r - 0.003, 0.003, 28, 6).turn(0, np.pi / 2).move(y=-y / 2 - reach, z=0.46 * z)
    glass = (
        cylinder(r - 0.006, 0.001, 24).turn(0, np.pi / 2).move(y=-y / 2 - reach + 0.001, z=0.46 * z)
    )
    dial = cylinder(0.009, 0.007, 16).move(x=0.35 * x, z=z - 0.001)
    button = cylinder(0.005, 0.006, 14).move(x=-0.37 * x, z=z - 0.001)
    shine = prints.canvas(32, 32, (28, 34, 62))
    prints.disc(shine, 0.35, 0.35, 0.15, (120, 140, 190))
    low = 0.46 * z - r
    pieces = [(body, leather), (top, metal), (hump, metal), (lens, metal),
              (ring, surfaces.plain((70, 72, 78))), (glass, shine),
              (dial, surfaces.plain((170, 172, 176))),
              (button, surfaces.plain((190, 60, 50)))]  # fmt: skip
    return shape(pieces, [box_part(x, y, z), box_part(0.042, y * 0.9, tall - 0.003, (aside, 0, z)),
                          cylinder_part(r, reach, (0, -y / 2 - reach, low + r), 1)])  # fmt: skip


@category("film_roll", size=(0.0576, 0.0284, 0.0505), mass=0.03, material="plastic", assembled=True,
          aliases=("roll of film", "film canister", "camera film", "photo film", "35mm film",
          "film", "microfilm reel", "negative strip", "film reel", "reel of film", "music roll"),
          themes=("living",), roles=("round",), colors=("yellow",))  # fmt: skip
def film_roll(look: Look) -> Shape:
    """An upright 35 mm film canister with a strip of film sticking out."""
    k = look.between(0.95, 1.1)
    color = look.color("yellow", "green", "red", "blue", "black", "orange")
    r, h = 0.0125 * k, 0.047 * k
    body = cylinder(r, 0.9 * h, 26).move(z=0.03 * h)
    image = prints.label(look.rng, look.pick(["FILM 400", "ISO 200", "35 mm"]), color,
                         (246, 244, 236), width=192)  # fmt: skip
    caps = [cylinder(1.06 * r, 0.05 * h, 26).move(z=z) for z in (0, 0.9 * h)]
    caps.append(cylinder(0.45 * r, 0.08 * h, 14).move(z=0.92 * h))
    tongue = box(0.03 * k, 0.001, 0.74 * h).move(r + 0.013 * k, 0.3 * r, 0.1 * h)
    strip = prints.canvas(64, 64, (96, 66, 44))
    for n in range(8):
        for v in (0.05, 0.87):
            prints.fill(strip, n / 8 + 0.03, v, 0.06, 0.08, (236, 230, 220))
    return shape([(body, image), (join(caps), surfaces.plain((36, 36, 38))), (tongue, strip)],
                 [cylinder_part(1.06 * r, 0.95 * h), hull_of(tongue)])  # fmt: skip
