"""Small things of medicine: pills, plasters, blades, masks, inhalers, dishes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of
from ...build.forms import lay_down
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    prism,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def pill(look: Look) -> Shape:
    """One capsule or tablet, a little larger than life."""
    k = look.between(1.0, 1.3)
    color = look.color("white", "red", "yellow", "blue", "orange", "green", "pink")
    if look.chance(0.6):
        a = np.linspace(-np.pi / 2, np.pi / 2, 11)
        r, long = 0.004 * k, 0.02 * k
        z = np.where(a < 0, r, long - r) + r * np.sin(a)
        profile = np.column_stack([r * np.cos(a), z])
        profile[[0, -1], 0] = 0
        body = lay_down(lathe(profile, 20, v=list(z / long)), -long / 2, r)
        tile = textures.stack((textures.plain(color), 1), (textures.plain(look.own_color(
            "white", "cream", "yellow", "sky")), 1))  # fmt: skip
        return shape([(body, tile)], [flat_foot(body.vertices, 0.2)])
    body = ellipsoid(0.0115 * k, 0.0115 * k, 0.0058 * k, 24, 10).move(z=0.0029 * k)
    body = body.bend(lambda p: np.column_stack([p[:, :2], np.clip(p[:, 2], 0.0004 * k, 0.0054 * k)
                                                - 0.0004 * k]))  # fmt: skip
    line = box(0.009 * k, 0.0006, 0.0004).move(z=0.005 * k - 0.0002)
    return shape([(body, textures.speckles(look.rng, color, 3, 32)),
                  (line, textures.plain(tint_color(color, 0.7)))],
                 [cylinder_part(0.0055 * k, 0.0045 * k)])  # fmt: skip


def blister_pack(look: Look) -> Shape:
    """A foil of tablets lying, its blisters up."""
    k = look.between(0.92, 1.1)
    color = look.color("silver", "silver", "white", "gold")
    pill_tone = look.own_color("white", "pink", "yellow", "sky", "orange", "red")
    x, y = 0.095 * k, 0.042 * k
    pieces = [(block(x, y, 0.0012, 0.004), textures.brushed_metal(look.rng, color))]
    domes = []
    for n in range(10):
        at = ((n % 5 - 2) * 0.0178 * k, (n // 5 - 0.5) * 0.019 * k)
        dome = ellipsoid(0.0125 * k, 0.0125 * k, 0.009 * k, 16, 8).move(*at, 0.0012)
        domes.append(dome.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.0006)])))
    gone = int(look.rng.integers(0, 5))
    full, empty = domes[gone:], domes[:gone]
    pieces.append((join(full), textures.plain(pill_tone)))
    if empty:
        flat = [d.scale(1, 1, 0.35).move(z=0.0006) for d in empty]
        pieces.append((join(flat), textures.plain((120, 122, 126))))
    return shape(pieces, [box_part(x, y, 0.0012),
                          box_part(0.084 * k, 0.032 * k, 0.0042 * k, (0, 0, 0.0012))])  # fmt: skip


def pill_organizer(look: Look) -> Shape:
    """A row of seven lidded boxes with the letters of the week."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "clear", "purple", "pink", "green", "white")
    wide, y, h = 0.024 * k, 0.034 * k, 0.024 * k
    x = 7 * wide
    lids, body = [], block(x, y, 0.8 * h, 0.003)
    for n, letter in enumerate("SMTWTFS"):
        image = prints.canvas(32, 44, tint_color(color, 1.25))
        prints.write(image, letter, 0.5, 0.5, 0.45, (40, 44, 60), bold=True)
        lid = block(0.92 * wide, 0.94 * y, 0.2 * h, 0.003, 0.0008)
        lids.append((lid.move(x=(n - 3) * wide, z=0.8 * h - 0.0004), image))
    return shape([(body, look.surface(color, "plastic")), *lids], [box_part(x, y, h - 0.0006)])


def _bottle(
    titles: tuple[str, ...], glass: tuple[str, ...], radius: float, height: float, cap: str
) -> Callable[[Look], Shape]:
    """A medicine bottle with a label; its cap is a "screw" one, or a "drop"per or "swab" lid."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.1)
        color = look.color(*glass)
        r, h = radius * k, height * k
        body = lathe([(0, 0), (0.94 * r, 0), (r, 0.03 * h), (r, 0.62 * h), (0.86 * r, 0.7 * h),
                      (0.46 * r, 0.77 * h), (0.46 * r, 0.84 * h), (0, 0.84 * h)], 30)  # fmt: skip
        tone = look.own_color("red", "teal", "blue", "green", "orange", "purple")
        label = prints.label(look.rng, look.pick(titles), tone, (246, 245, 240), width=192)
        band = lathe([(0.9 * r, 0.14 * h), (1.015 * r, 0.14 * h), (1.015 * r, 0.54 * h),
                      (0.9 * r, 0.54 * h)], 30, v=[0, 0, 1, 1], loop=True)  # fmt: skip
        lid_tone = look.own_color("white", "white", "black", "red")
        lid = [cylinder(0.56 * r, 0.16 * h, 24, bevel=0.001).move(z=0.8 * h)]
        if cap == "drop":
            lid.append(lathe(np.array([(0, 0.95), (0.3, 0.95), (0.34, 1.06), (0.24, 1.24),
                                       (0, 1.28)]) * [r, h], 20))  # fmt: skip
        hulls = [cylinder_part(r, 0.66 * h), *(hull_of(s) for s in lid)]
        return shape([(body, look.surface(color, "plastic")), (band, label),
                      (join(lid), textures.plain(lid_tone))], hulls)  # fmt: skip

    return make


def band_aid(look: Look) -> Shape:
    """A sticking plaster lying, its pad up."""
    k = look.between(0.95, 1.2)
    color = look.color("tan", "beige", "coral", "blue", "pink", "tan")
    strip = prism(rectangle(0.072 * k, 0.019 * k, 0.0094 * k, 6), 0, 0.0012)
    dots = textures.fit(prints.mesh_holes(color, tint_color(color, 0.8), 5, 18), 64, 192)
    pad = block(0.024 * k, 0.0165 * k, 0.0009, 0.001).move(z=0.0011)
    return shape([(strip, dots), (pad, textures.fabric(look.rng, (244, 238, 226)))],
                 [hull_of(strip), hull_of(pad)])  # fmt: skip


def gauze_pad(look: Look) -> Shape:
    """A stack of folded gauze squares."""
    k = look.between(0.9, 1.15)
    color = look.color("white", "white", "cream")
    cloth = textures.fabric(look.rng, color, threads=16)
    side, layers = 0.075 * k, int(look.rng.integers(3, 6))
    solids = [block(side - look.between(0, 0.003), side - look.between(0, 0.003), 0.0035, 0.006,
                    0.001).turn(2, look.between(-0.05, 0.05)).move(z=0.0036 * n)
              for n in range(layers)]  # fmt: skip
    return shape([(join(solids), cloth)], [hull_of(*solids)])


CATEGORIES = (
    Category("pill", pill, (0.0185, 0.0105, 0.0078), 0.001, ("capsule", "tablet pill",
             "medicine pill", "vitamin", "vitamin pill", "painkiller", "aspirin",
                 "medicine capsule",
             "suppository", "pessary", "cough sweet", "throat lozenge", "cough drop"),
             ("medical",), (), ("white", "red")),
    Category("blister_pack", blister_pack, (0.095, 0.042, 0.0057), 0.012, ("pill blister",
             "tablet strip", "blister pack of pills", "strip of tablets", "pill packet",
             "pill strip", "blister",
             "packet of paracetamol", "paracetamol", "ibuprofen", "aspirin pack",
             "packet of aspirin", "nicotine gum"), ("medical",), ("flat",), ("silver",)),
    Category("pill_organizer", pill_organizer, (0.168, 0.034, 0.0237), 0.07, ("pill box",
             "pillbox", "pill organiser", "weekly pill box", "tablet box", "medicine organizer"),
             ("medical",), (), ("blue",)),
    Category("medicine_bottle", _bottle(("SYRUP", "COUGH", "TONIC", "MEDICINE"), ("amber", "brown",
             "amber"), 0.029, 0.125, "screw"), (0.0594, 0.0594, 0.122), 0.22, ("cough syrup",
             "bottle of medicine", "cough medicine", "bottle of cough syrup",
             "cough syrup bottle", "iodine bottle", "tincture"), ("medical",), ("round", "tall"),
             ("amber", "brown")),
    Category("eye_drops", _bottle(("DROPS", "EYE", "SERUM"), ("white", "white", "amber", "sky"),
             0.013, 0.05, "drop"), (0.0267, 0.0267, 0.0645), 0.02, ("eye drop bottle",
             "dropper bottle", "drop bottle", "nose drops", "serum bottle", "serum",
             "ear drops", "contact lens solution", "correction fluid", "tipp-ex bottle",
             "tipp ex bottle", "tippex", "liquid paper"),
             ("medical",), ("round",), ("white",)),
    Category("band_aid", band_aid, (0.077, 0.0203, 0.002), 0.001, ("plaster", "bandaid",
             "band-aid", "sticking plaster", "adhesive bandage", "adhesive plaster",
             "butterfly stitch", "steri-strip packet", "steri strip packet", "nicotine patch",
             "heat patch", "plaster strip", "whitening strip", "ecg electrode"),
             ("medical",), ("flat",), ("tan",), 0.6),
    Category("gauze_pad", gauze_pad, (0.0745, 0.0743, 0.0125), 0.012, ("gauze", "gauze swab",
             "gauze square", "sterile gauze", "wound dressing"), ("medical",),
             ("flat",), ("white",)),
)  # fmt: skip
"""The module's categories."""
