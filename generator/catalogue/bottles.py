"""Bottles and jars with printed labels."""

from __future__ import annotations

import numpy as np

from ..scene import ConvexPart
from . import prints, textures
from .category import Category
from .collision import box_part, cylinder_part, hull_of, hull_part
from .colors import RGB, tinted
from .look import Look
from .shape import Shape, shape
from .solids import Solid, box, cylinder, lathe

PRINTS = ("red", "navy", "teal", "green", "mustard", "crimson", "orange", "purple", "blue")


def _ribbed(color: RGB) -> textures.Tile:
    """A screw cap's side."""
    return textures.stripes([color, tinted(color, 0.75)], 16, upright=True, side=64)


def _labelled(
    look: Look, base: RGB, word: str, low: float, high: float, ground: RGB = (244, 242, 234)
) -> textures.Tile:
    """A bottle's skin: plain, a label between the heights v ``low`` and ``high``, plain."""
    print_ = prints.label(look.rng, word, look.fixed(*PRINTS), ground)
    skin = textures.speckled(look.rng, base, 3, 32)
    return textures.stacked((skin, low), (print_, high - low), (skin, 1 - high), side=192)


def _vessel(r: float, h: float, neck: float, shoulder: float, rise: float) -> Solid:
    """Return a bottle's body up to its mouth at ``h``.

    It is straight up to z ``shoulder`` and has its ``neck`` radius from z ``rise`` on. v runs
    with z along the outside, so that labels sit where they are meant to.
    """
    t = np.linspace(0, 1, 6)[1:-1]
    bow = [
        (neck + (r - neck) * (0.5 + 0.5 * np.cos(np.pi * k)), shoulder + (rise - shoulder) * k)
        for k in t
    ]
    profile = [(0, 0), (0.92 * r, 0), (r, 0.005), (r, shoulder), *bow, (neck, rise), (neck, h),
               (0, h)]  # fmt: skip
    return lathe(profile, v=[0, *(z / h for _, z in profile[1:-1]), 1])


def _vessel_parts(
    body: Solid, r: float, shoulder: float, neck: float, h: float, rise: float
) -> list[ConvexPart]:
    """Return a vessel's body, shoulder and neck."""
    upper = body.vertices[(body.vertices[:, 2] >= shoulder) & (body.vertices[:, 2] <= rise + 1e-6)]
    return [
        cylinder_part(0.99 * r, shoulder),
        hull_part(upper),
        cylinder_part(neck, h - rise, (0, 0, rise)),
    ]


def bottle(look: Look) -> Shape:
    """A bottle of water, juice or soda with a label and a screw cap."""
    r, h = look.between(0.031, 0.036), look.between(0.2, 0.235)
    color = look.color("green", "sky", "amber", "clear", "orange", "red", "brown", "teal")
    word = look.pick(["WATER", "JUICE", "SODA", "TEA", "FRESH", "LEMON"])
    body = _vessel(r, h, 0.0125, 0.62 * h, 0.84 * h)
    cap = cylinder(0.0142, 0.016, 20, bevel=0.001).moved(z=h - 0.004)
    lid = _ribbed(look.fixed("white", "red", "blue", "green", "black"))
    return shape(
        [(body, _labelled(look, color, word, 0.22, 0.56)), (cap, lid)],
        [*_vessel_parts(body, r, 0.62 * h, 0.0125, h, 0.84 * h),
         cylinder_part(0.0142, 0.016, (0, 0, h - 0.004))],
    )  # fmt: skip


def wine_bottle(look: Look) -> Shape:
    """A tall wine bottle with a paper label and a foil."""
    r, h = look.between(0.036, 0.039), look.between(0.29, 0.315)
    color = look.color("green", "olive", "maroon", "black", "amber")
    word = look.pick(["ROSSO", "1998", "VALLEY", "BRUT", "OLIVE"])
    body = _vessel(r, h, 0.0135, 0.58 * h, 0.76 * h)
    foil = cylinder(0.0148, 0.16 * h, 20, bevel=0.001).moved(z=0.85 * h)
    return shape(
        [(body, _labelled(look, tinted(color, 0.55), word, 0.14, 0.46)),
         (foil, textures.speckled(look.rng, look.fixed("crimson", "gold", "black"), 3, 32))],
        [*_vessel_parts(body, r, 0.58 * h, 0.0135, h, 0.76 * h),
         cylinder_part(0.0148, 0.16 * h, (0, 0, 0.85 * h))],
    )  # fmt: skip


def sauce_bottle(look: Look) -> Shape:
    """A squeeze bottle of ketchup or mustard with a pointed nozzle."""
    r, h = look.between(0.029, 0.033), look.between(0.145, 0.165)
    color = look.color("red", "yellow", "red", "brown", "green")
    word = "MUSTARD" if color[1] > 150 else "KETCHUP" if color[0] > 150 else "SAUCE"
    body = _vessel(r, h, 0.016, 0.72 * h, 0.94 * h)
    nozzle = cylinder(0.015, 0.034, 18, top=0.0032).moved(z=h + 0.006)
    collar = cylinder(0.0175, 0.009, 20, bevel=0.001).moved(z=h - 0.002)
    cap = textures.plain(look.fixed("white", "white", "green", "red"))
    return shape(
        [(body, _labelled(look, color, word, 0.25, 0.62, tinted(color, 0.8))), (nozzle, cap),
         (collar, cap)],
        [*_vessel_parts(body, r, 0.72 * h, 0.016, h, 0.94 * h), hull_of(nozzle, collar)],
    )  # fmt: skip


def paint_bottle(look: Look) -> Shape:
    """A bottle of paint with a pump; the label shows its colour."""
    r, h = look.between(0.034, 0.039), look.between(0.13, 0.15)
    color = look.color("red", "blue", "yellow", "green", "purple", "orange", "teal", "pink")
    body = _vessel(r, h, 0.014, 0.8 * h, 0.95 * h)
    white = textures.plain((238, 238, 236))
    collar = cylinder(0.0165, 0.014, 20, bevel=0.001).moved(z=h - 0.002)
    stem = cylinder(0.005, 0.026, 12).moved(z=h + 0.01)
    head = box(0.016, 0.045, 0.012).moved(y=-0.012, z=h + 0.034)
    return shape(
        [(body, _labelled(look, color, "PAINT", 0.2, 0.6)), (collar, white), (stem, white),
         (head, white)],
        [*_vessel_parts(body, r, 0.8 * h, 0.014, h, 0.95 * h),
         cylinder_part(0.0165, 0.014, (0, 0, h - 0.002)),
         cylinder_part(0.005, 0.026, (0, 0, h + 0.01)),
         box_part(0.016, 0.045, 0.012, (0, -0.012, h + 0.034))],
    )  # fmt: skip


def jar(look: Look) -> Shape:
    """A jar of jam, honey or pickles with a lid."""
    r, h = look.between(0.034, 0.042), look.between(0.085, 0.115)
    color = look.color("crimson", "amber", "purple", "orange", "olive", "brown")
    word = look.pick(["JAM", "HONEY", "PICKLES", "BERRY", "CURRY"])
    body = _vessel(r, h, 0.82 * r, 0.84 * h, 0.94 * h)
    lid = cylinder(0.88 * r, 0.017, 28, bevel=0.002).moved(z=h - 0.003)
    other = look.fixed("white", "red", "gold", "navy")
    cloth = textures.fabric(look.rng, other, (246, 244, 238), 16)
    return shape(
        [(body, _labelled(look, color, word, 0.25, 0.7)),
         (lid, cloth if look.chance(0.5) else textures.plain(other))],
        [*_vessel_parts(body, r, 0.84 * h, 0.82 * r, h, 0.94 * h),
         cylinder_part(0.88 * r, 0.017, (0, 0, h - 0.003))],
    )  # fmt: skip


CATEGORIES = (
    Category(
        "bottle",
        bottle,
        (0.067, 0.067, 0.23),
        0.5,
        (
            "water bottle",
            "juice bottle",
            "soda bottle",
            "plastic bottle",
            "drink",
            "juice",
            "water",
            "beer",
            "beer bottle",
            "milk bottle",
        ),
        ("dining", "kitchen", "office"),
        ("tall", "round"),
        ("green", "sky", "amber"),
    ),
    Category(
        "wine_bottle",
        wine_bottle,
        (0.075, 0.075, 0.31),
        1.2,
        (
            "wine",
            "bottle of wine",
            "champagne",
            "champagne bottle",
            "olive oil",
            "oil bottle",
            "bottle of olive oil",
        ),
        ("dining",),
        ("tall", "round"),
        ("green", "maroon"),
    ),
    Category(
        "sauce_bottle",
        sauce_bottle,
        (0.062, 0.062, 0.195),
        0.4,
        (
            "ketchup bottle",
            "ketchup",
            "mustard bottle",
            "squeeze bottle",
            "sauce",
            "mayonnaise",
            "hot sauce",
        ),
        ("dining", "kitchen"),
        ("tall", "round"),
        ("red", "yellow"),
    ),
    Category(
        "paint_bottle",
        paint_bottle,
        (0.073, 0.073, 0.185),
        0.45,
        ("bottle of paint", "paint", "paint pot"),
        ("craft",),
        ("tall", "round"),
        ("red", "blue", "yellow"),
    ),
    Category(
        "jar",
        jar,
        (0.076, 0.076, 0.115),
        0.4,
        (
            "jam jar",
            "honey jar",
            "jar of jam",
            "jar of honey",
            "pickle jar",
            "jam",
            "honey",
            "spice jar",
            "cookie jar",
        ),
        ("kitchen", "dining"),
        ("round",),
        ("crimson", "amber"),
    ),
)
