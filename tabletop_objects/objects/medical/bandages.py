"""Objects of the ``medical`` theme: bandages."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.shapes import Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, loft, prism, sweep, tube
from ...kit.surfaces import Look, readable_on, tint_color


@category("first_aid_kit", size=(0.235, 0.13, 0.185), mass=0.9, material="plastic",
          aliases=("first aid box", "first-aid kit", "first-aid box", "medical kit", "medicine box",
          "medkit", "puncture repair kit", "repair kit", "suture kit", "snake bite kit"),
          themes=("medical",), roles=("big",), colors=("red", "white"), common=True)  # fmt: skip
def first_aid_kit(look: Look) -> Shape:
    """A first-aid case with a cross on its front and lid."""
    x, y, h = look.between(0.2, 0.27), look.between(0.1, 0.15), look.between(0.13, 0.18)
    color = look.color("red", "white", "green", "red", "orange")
    ink = (250, 250, 248) if sum(color) < 520 else look.own_color("red", "green")
    shell = surfaces.speckles(look.rng, color, 3, 32)
    cross = prints.canvas(96, 96, color)
    prints.disc(cross, 0.5, 0.5, 0.47, ink)
    inner = color if sum(color) < 520 else (250, 250, 248)
    prints.fill(cross, 0.42, 0.2, 0.16, 0.6, inner)
    prints.fill(cross, 0.2, 0.42, 0.6, 0.16, inner)
    body = block(x, y, 0.62 * h, 0.02, 0.008)
    lid = block(x, y, 0.4 * h, 0.02, 0.008).move(z=0.6 * h)
    side = 0.62 * h
    front = box(side, 0.0014, side).move(y=-y / 2 - 0.0005, z=0.2 * h)
    top = box(0.6 * y, 0.6 * y, 0.001).move(z=h - 0.0004)
    bow = tube([(-0.04, 0, h - 0.002), (-0.036, 0, h + 0.024), (0.036, 0, h + 0.024),
                (0.04, 0, h - 0.002)], 0.0065, 10)  # fmt: skip
    clips = [box(0.022, 0.006, 0.03).move(s * 0.4 * x, -y / 2 - 0.001, 0.52 * h) for s in (-1, 1)]
    return shape(
        [(join([body, lid]), shell), (front, cross), (top, cross),
         (join([bow, *clips]), surfaces.plain((168, 170, 172)))],
        [box_part(x, y, h), box_part(0.08, 0.013, 0.03, (0, 0, h))],
    )  # fmt: skip


@category("bandage_roll", size=(0.063, 0.055, 0.07), mass=0.03, material="fabric", assembled=True,
          aliases=("bandage", "roll of bandage", "gauze roll", "roll of gauze", "elastic bandage",
          "medical bandage", "triangular bandage", "cotton wool roll", "cotton roll", "arm sling",
          "knee brace", "neck brace", "wrist splint", "finger splint", "compression bandage",
          "sam splint", "sling"), themes=("medical",), roles=("round",), colors=("white", "tan"),
          common=True)  # fmt: skip
def bandage_roll(look: Look) -> Shape:
    """An upright roll of gauze or elastic bandage, loose or held by clips or tape."""
    r, h = look.between(0.02, 0.032), look.between(0.05, 0.09)
    color = look.color("white", "white", "cream", "tan", "beige", "blue", "pink", "green", "red")
    ridged = look.chance(0.5)
    cloth = surfaces.fabric(look.rng, color, threads=40)
    if ridged:
        cloth = np.clip(cloth * (1 - 0.14 * (np.arange(128) % 6 < 2))[None, :, None], 0, 255)
    edge = look.own_color("blue", "red", "navy") if look.chance(0.3) else None
    image = cloth.astype(np.uint8)
    if edge is not None:
        for at in (0.06, 0.9):
            prints.fill(image, 0, at, 1, 0.04, edge)
    side = 128
    v, u = (np.mgrid[0:side, 0:side] + 0.5) / side - 0.5
    away, around = np.hypot(u, v), np.arctan2(v, u)
    shade = 0.8 + 0.2 * np.sin(2 * np.pi * (9 * 2 * away) + around)
    shade[away < 0.08] = 0.35
    spiral = np.clip(np.array(color) * shade[..., None], 0, 255).astype(np.uint8)
    body = cylinder(r, h, 32, bevel=0.0008)
    cap = cylinder(0.97 * r, 0.0008, 32).move(z=h - 2e-4)
    pieces = [(body, image), (cap, spiral)]
    parts = [cylinder_part(r, h)]
    kind = look.pick(["tail", "tail", "clips", "tape", "label"])
    if kind == "tail":
        out = look.between(0.02, 0.045)
        path = smooth([(-0.3 * r, -0.97 * r, h / 2), (0.4 * r, -1.0 * r, h / 2),
                       (r + 0.4 * out, -1.0 * r, h / 2), (r + out, -1.0 * r - 0.3 * out, h / 2)],
                      4)  # fmt: skip
        tail = sweep(path, rectangle(0.0014, 0.995 * h))
        pieces.append((tail, surfaces.plain(tint_color(color, 0.95))))
        parts.append(hull_of(sweep(path[-6:], rectangle(0.0014, 0.995 * h)).move(z=-0.0025 * h)))
    elif kind == "clips":
        for z in (0.3, 0.62):
            clip = block(0.016, 0.002, 0.007, 0.0008).move(0, -r, z * h)
            pieces.append((clip, surfaces.plain((206, 172, 96))))
    else:
        tall = 0.24 if kind == "tape" else 0.5
        band = prints.canvas(160, 64, look.own_color("white", "blue", "green", "red"))
        ink = (246, 246, 242) if band[0, 0].sum() < 600 else (206, 44, 44)
        if kind == "label":
            prints.fill(band, 0.44, 0.43, 0.12, 0.14, ink)
            prints.fill(band, 0.475, 0.29, 0.05, 0.42, ink)
        ring = cylinder(r + 6e-4, tall * h, 32).move(z=(0.5 - tall / 2) * h)
        pieces.append((ring, band))
    return shape(pieces, parts)


@category("band_aid", size=(0.077, 0.0203, 0.002), mass=0.001, material="fabric", friction=0.6,
          aliases=("plaster", "bandaid", "band-aid", "sticking plaster", "adhesive bandage",
          "adhesive plaster", "butterfly stitch", "steri-strip packet", "steri strip packet",
          "nicotine patch", "heat patch", "plaster strip", "whitening strip", "ecg electrode"),
          themes=("medical",), roles=("flat",), colors=("tan",))  # fmt: skip
def band_aid(look: Look) -> Shape:
    """A sticking plaster lying with its pad up."""
    k = look.between(0.95, 1.2)
    color = look.color("tan", "beige", "coral", "blue", "pink", "tan")
    strip = prism(rectangle(0.072 * k, 0.019 * k, 0.0094 * k, 6), 0, 0.0012)
    dots = surfaces.fit(prints.mesh_holes(color, tint_color(color, 0.8), 5, 18), 64, 192)
    pad = block(0.024 * k, 0.0165 * k, 0.0009, 0.001).move(z=0.0011)
    return shape([(strip, dots), (pad, surfaces.fabric(look.rng, (244, 238, 226)))],
                 [hull_of(strip), hull_of(pad)])  # fmt: skip


@category("gauze_pad", size=(0.0745, 0.0743, 0.0125), mass=0.012, material="fabric",
          aliases=("gauze", "gauze swab", "gauze square", "sterile gauze", "wound dressing"),
          themes=("medical",), roles=("flat",), colors=("white",))  # fmt: skip
def gauze_pad(look: Look) -> Shape:
    """A stack of folded gauze squares."""
    k = look.between(0.9, 1.15)
    color = look.color("white", "white", "cream")
    cloth = surfaces.fabric(look.rng, color, threads=16)
    side, layers = 0.075 * k, int(look.rng.integers(3, 6))
    solids = [block(side - look.between(0, 0.003), side - look.between(0, 0.003), 0.0035, 0.006,
                    0.001).turn(2, look.between(-0.05, 0.05)).move(z=0.0036 * n)
              for n in range(layers)]  # fmt: skip
    return shape([(join(solids), cloth)], [hull_of(*solids)])


@category("face_mask", size=(0.228, 0.093, 0.011), mass=0.005, material="fabric", assembled=True,
          friction=0.6, aliases=("surgical mask", "medical mask", "dust mask", "facemask",
          "disposable mask", "cpr mask"), themes=("medical",), roles=("flat",),
          colors=("blue", "white"))  # fmt: skip
def face_mask(look: Look) -> Shape:
    """A pleated face mask lying flat, with ear loops at its sides."""
    k = look.between(0.92, 1.05)
    color = look.color("blue", "sky", "white", "black", "mint", "pink")
    tone = tint_color(color, 1.3) if sum(color) < 380 and color[2] > 90 else color
    x, y = 0.17 * k, 0.095 * k
    image = surfaces.fit(surfaces.fabric(look.rng, tone), 96, 128).copy()
    for v in (0.22, 0.42, 0.62, 0.8):
        prints.fill(image, 0, v, 1, 0.03, tint_color(tone, 0.75))
    for v in (0.0, 0.95):
        prints.fill(image, 0, v, 1, 0.05, tint_color(tone, 0.85))
    levels = [(-0.5, 0.003), (-0.28, 0.008), (0.0, 0.011), (0.28, 0.008), (0.5, 0.003)]
    rings = [np.array([(-x / 2, v * y, 0), (x / 2, v * y, 0), (0.34 * x, v * y, z),
                       (-0.34 * x, v * y, z)]) for v, z in levels]  # fmt: skip
    body = loft(np.stack(rings)[::-1], rectangle(1, 1),
                profile=np.array([(v, 0) for v, _ in levels[::-1]]))  # fmt: skip
    top = body.vertices
    uv = np.column_stack([top[:, 0] / x + 0.5, top[:, 1] / y + 0.5])
    body = Solid(body.vertices, body.faces, np.clip(uv, 0, 1))
    loops = [tube(smooth([(s * 0.49 * x, 0.42 * y, 0.002), (s * 0.66 * x, 0.3 * y, 0.002),
                          (s * 0.69 * x, -0.1 * y, 0.002), (s * 0.49 * x, -0.42 * y, 0.002)], 5),
                  0.0013, 6) for s in (-1, 1)]  # fmt: skip
    return shape([(body, image), (join(loops), surfaces.plain((244, 244, 242)))],
                 [hull_of(body)])  # fmt: skip


@category("glove_box", size=(0.215, 0.117, 0.099), mass=0.3, material="paper",
          aliases=("box of gloves", "box of disposable gloves", "box of latex gloves",
          "glove dispenser"), themes=("medical",), roles=("big",), colors=("blue",))  # fmt: skip
def glove_box(look: Look) -> Shape:
    """A box of disposable gloves with one glove sticking out."""
    k = look.between(0.9, 1.05)
    color = look.color("blue", "purple", "white", "green", "teal")
    x, y, h = 0.22 * k, 0.12 * k, 0.07 * k
    image = prints.canvas(176, 96, (244, 244, 242))
    prints.fill(image, 0, 0, 1, 0.34, color)
    prints.write(image, "GLOVES", 0.3, 0.18, 0.22, readable_on(color), bold=True)
    prints.disc(image, 0.62, 0.56, 0.27, (120, 124, 130))
    prints.disc(image, 0.62, 0.56, 0.24, (40, 44, 52))
    side = prints.canvas(176, 56, color)
    prints.write(side, look.pick(["NITRILE GLOVES", "100 GLOVES", "EXAM GLOVES"]), 0.5, 0.5, 0.3,
                 readable_on(color), bold=True)  # fmt: skip
    glove = look.own_color("sky", "white", "violet", "mint")
    at = np.array([0.12 * x, -0.06 * y, h])
    fingers = [tube(np.array([np.add(at, (0.004 * n, 0, -0.004)),
        np.add(at, (0.006 * n, 0.004, 0.016)),
                              np.add(at, (0.011 * n, 0.006, 0.03))]) ,
                                  np.array([0.0075, 0.007, 0.0045]), 8)
               for n in (-2, -0.6, 0.7, 2)]  # fmt: skip
    return shape([(box(x, y, h), side), (box(x, y, 0.0006).move(z=h - 0.0003), image),
                  (join(fingers), surfaces.plain(glove))],
                 [box_part(x, y, h), hull_of(*fingers)])  # fmt: skip
