"""Objects of the ``medical`` theme: medicines."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of
from ...kit.primitives import lay_down
from ...kit.prints import wrap
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism
from ...kit.surfaces import RGB, Look, tint_color


@category("pill_bottle", size=(0.055, 0.065, 0.094), mass=0.06, material="plastic", assembled=True,
          aliases=("pill container", "vitamins", "medicine", "bottle of pills",
          "prescription bottle", "tablets", "bottle of ibuprofen", "box of aspirin", "medicine tub",
          "bottle of supplements"), themes=("medical", "vanity"), colors=("orange", "white"),
          common=True)  # fmt: skip
def pill_bottle(look: Look) -> Shape:
    """A bottle of pills with a white cap and some tablets beside it."""
    r, h = look.between(0.019, 0.028), look.between(0.06, 0.085)
    color = look.color("orange", "amber", "white", "orange", "green")
    label = wrap(look, look.pick(["RX", "PILLS", "VITA C", "ZINC", "MEDS"]),
                 look.own_color("blue", "teal", "red", "green"), (248, 248, 246))  # fmt: skip
    skin = surfaces.speckles(look.rng, color, 4, 32)
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.003), (r, h), (0.8 * r, 1.06 * h),
                  (0, 1.06 * h)], 26, v=[0, 0, 0.03, 0.94, 0.99, 1])  # fmt: skip
    ribs = surfaces.stripes([(242, 242, 240), (214, 214, 212)], 24, upright=True)
    cap = cylinder(0.98 * r, 0.26 * h, 28, bevel=0.0015).move(z=1.04 * h)
    pieces = [(body, surfaces.stack((skin, 0.14), (label, 0.66), (skin, 0.2), side=160)),
              (cap, ribs)]  # fmt: skip
    parts = [cylinder_part(r, h), cylinder_part(0.97 * r, 0.25 * h, (0, 0, 1.04 * h))]
    if look.chance(0.6):
        pill = look.own_color("white", "sky", "pink", "yellow", "red")
        for k in range(int(look.rng.integers(2, 5))):
            a = -np.pi / 2 + 0.5 * (k - 1.5) + look.between(-0.1, 0.1)
            tablet = ellipsoid(0.013, 0.0075, 0.0055, 12, 6).turn(2, look.between(0, 3))
            tablet = tablet.move(1.7 * r * np.cos(a), 1.7 * r * np.sin(a), 0.00275)
            pieces.append((tablet, surfaces.plain(pill)))
            parts.append(hull_of(tablet))
    return shape(pieces, parts)


@category("pill", size=(0.0185, 0.0105, 0.0078), mass=0.001, material="food", aliases=("capsule",
          "tablet pill", "medicine pill", "vitamin", "vitamin pill", "painkiller", "aspirin",
          "medicine capsule", "suppository", "pessary", "cough sweet", "throat lozenge",
          "cough drop"), themes=("medical",), colors=("white", "red"))  # fmt: skip
def pill(look: Look) -> Shape:
    """One capsule or tablet, slightly larger than life-size."""
    k = look.between(1.0, 1.3)
    color = look.color("white", "red", "yellow", "blue", "orange", "green", "pink")
    if look.chance(0.6):
        a = np.linspace(-np.pi / 2, np.pi / 2, 11)
        r, long = 0.004 * k, 0.02 * k
        z = np.where(a < 0, r, long - r) + r * np.sin(a)
        profile = np.column_stack([r * np.cos(a), z])
        profile[[0, -1], 0] = 0
        body = lay_down(lathe(profile, 20, v=list(z / long)), -long / 2, r)
        tile = surfaces.stack((surfaces.plain(color), 1), (surfaces.plain(look.own_color(
            "white", "cream", "yellow", "sky")), 1))  # fmt: skip
        return shape([(body, tile)], [flat_foot(body.vertices, 0.2)])
    body = ellipsoid(0.0115 * k, 0.0115 * k, 0.0058 * k, 24, 10).move(z=0.0029 * k)
    body = body.bend(lambda p: np.column_stack([p[:, :2], np.clip(p[:, 2], 0.0004 * k, 0.0054 * k)
                                                - 0.0004 * k]))  # fmt: skip
    line = box(0.009 * k, 0.0006, 0.0004).move(z=0.005 * k - 0.0002)
    return shape([(body, surfaces.speckles(look.rng, color, 3, 32)),
                  (line, surfaces.plain(tint_color(color, 0.7)))],
                 [cylinder_part(0.0055 * k, 0.0045 * k)])  # fmt: skip


@category("blister_pack", size=(0.095, 0.042, 0.0057), mass=0.012, material="plastic",
          aliases=("pill blister", "tablet strip", "blister pack of pills", "strip of tablets",
          "pill packet", "pill strip", "blister", "packet of paracetamol", "paracetamol",
          "ibuprofen", "aspirin pack", "packet of aspirin", "nicotine gum"), themes=("medical",),
          roles=("flat",), colors=("silver",))  # fmt: skip
def blister_pack(look: Look) -> Shape:
    """A blister pack of tablets lying with its blisters up."""
    k = look.between(0.92, 1.1)
    color = look.color("silver", "silver", "white", "gold")
    pill_tone = look.own_color("white", "pink", "yellow", "sky", "orange", "red")
    x, y = 0.095 * k, 0.042 * k
    pieces = [(block(x, y, 0.0012, 0.004), surfaces.brushed_metal(look.rng, color))]
    domes = []
    for n in range(10):
        at = ((n % 5 - 2) * 0.0178 * k, (n // 5 - 0.5) * 0.019 * k)
        dome = ellipsoid(0.0125 * k, 0.0125 * k, 0.009 * k, 16, 8).move(*at, 0.0012)
        domes.append(dome.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.0006)])))
    gone = int(look.rng.integers(0, 5))
    full, empty = domes[gone:], domes[:gone]
    pieces.append((join(full), surfaces.plain(pill_tone)))
    if empty:
        flat = [d.scale(1, 1, 0.35).move(z=0.0006) for d in empty]
        pieces.append((join(flat), surfaces.plain((120, 122, 126))))
    return shape(pieces, [box_part(x, y, 0.0012),
                          box_part(0.084 * k, 0.032 * k, 0.0042 * k, (0, 0, 0.0012))])  # fmt: skip


@category("pill_organizer", size=(0.168, 0.034, 0.0237), mass=0.07, material="plastic",
          aliases=("pill box", "pillbox", "pill organiser", "weekly pill box", "tablet box",
          "medicine organizer"), themes=("medical",), colors=("blue",))  # fmt: skip
def pill_organizer(look: Look) -> Shape:
    """A row of seven boxes with lids, marked with the initials of the weekdays."""
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
    """Return the shape function of a medicine bottle; ``cap`` is "screw", "drop" or "swab"."""

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
                      (join(lid), surfaces.plain(lid_tone))], hulls)  # fmt: skip

    return make


STEEL: RGB = (186, 189, 194)


@category("inhaler", size=(0.0736, 0.0911, 0.0243), mass=0.04, material="plastic", assembled=True,
          aliases=("asthma inhaler", "puffer", "asthma spray"), themes=("medical",),
          colors=("blue",))  # fmt: skip
def inhaler(look: Look) -> Shape:
    """An asthma inhaler lying on its side: a canister in a bent holder."""
    k = look.between(0.92, 1.08)
    color = look.color("blue", "blue", "purple", "orange", "teal", "brown")
    h = 0.024 * k
    boot = prism(np.array([(-0.016, 0.03), (-0.016, -0.026), (-0.008, -0.03), (0.014, -0.03),
                           (0.045, -0.036), (0.05, -0.018), (0.016, -0.006), (0.016, 0.03)]) * k,
                 0, h)  # fmt: skip
    can = cylinder(0.0105 * k, 0.042 * k, 22, bevel=0.002).turn(0, -np.pi / 2)
    can = can.move(y=0.012 * k, z=h / 2)
    cap = (
        block(0.01 * k, 0.02 * k, 0.9 * h, 0.002)
        .turn(2, -0.25)
        .move(0.051 * k, -0.027 * k, 0.05 * h)
    )
    label = box(0.02 * k, 0.03 * k, 0.0006).move(y=0.004 * k, z=h - 0.0002)
    sign = prints.canvas(40, 60, (244, 244, 240))
    prints.lines(sign, look.rng, (0.1, 0.2, 0.8, 0.6), 5, tint_color(color, 0.7))
    return shape([(boot, look.surface(color, "plastic")), (can, surfaces.brushed_metal(
                  look.rng, STEEL)), (cap, surfaces.plain(tint_color(color, 0.6))), (label, sign)],
                 [box_part(0.032 * k, 0.06 * k, h, (0, 0, 0)),
                  hull_of(prism(np.array([(0.0, -0.03), (0.045, -0.036), (0.05, -0.018),
                                          (0.0, -0.004)]) * k, 0, h)), hull_of(can)])  # fmt: skip


CATEGORIES = (
    Category("medicine_bottle", _bottle(("SYRUP", "COUGH", "TONIC", "MEDICINE"), ("amber", "brown",
             "amber"), 0.029, 0.125, "screw"), size=(0.0594, 0.0594, 0.122), mass=0.22,
             material="glass", aliases=("cough syrup", "bottle of medicine", "cough medicine",
             "bottle of cough syrup", "cough syrup bottle", "iodine bottle", "tincture"),
             themes=("medical",), roles=("round", "tall"), colors=("amber", "brown")),
    Category("eye_drops", _bottle(("DROPS", "EYE", "SERUM"), ("white", "white", "amber", "sky"),
             0.013, 0.05, "drop"), size=(0.0267, 0.0267, 0.0645), mass=0.02, material="plastic",
             aliases=("eye drop bottle", "dropper bottle", "drop bottle", "nose drops",
             "serum bottle", "serum", "ear drops", "contact lens solution", "correction fluid",
             "tipp-ex bottle", "tipp ex bottle", "tippex", "liquid paper"), themes=("medical",),
             roles=("round",), colors=("white",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
