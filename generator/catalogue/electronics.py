"""Computers, phones, sound and cameras."""

from __future__ import annotations

import numpy as np

from . import prints, textures
from .category import Category
from .collision import box_part, hull_of, hull_part
from .colors import tinted
from .look import Look
from .outlines import ellipse
from .shape import Shape, shape
from .solids import block, box, cylinder, loft, torus

DARK = (40, 41, 45)


def laptop(look: Look) -> Shape:
    """An open laptop, keyboard towards the viewer, screen leaning back."""
    x, y, t = look.between(0.3, 0.34), look.between(0.205, 0.23), 0.015
    color = look.color("silver", "charcoal", "gray", "black", "gold")
    case = textures.brushed(look.rng, color, 32)
    keys = prints.keys(prints.QWERTY, DARK, tinted(color, 0.9))
    lean = np.deg2rad(look.between(14, 24))
    base = block(x, y, t, 0.01, 0.002)
    pad = box(0.3 * x, 0.27 * y, 0.0004).moved(y=-0.31 * y, z=t)
    field = box(0.9 * x, 0.5 * y, 0.0008).moved(y=0.12 * y, z=t)
    lid = block(x, 0.007, 0.94 * y, 0.002)
    glass = box(0.97 * x, 0.001, 0.88 * y).moved(y=-0.0036, z=0.04 * y)
    view = box(0.92 * x, 0.001, 0.79 * y).moved(y=-0.0041, z=0.09 * y)
    logo = cylinder(0.012, 0.001, 20).turned(0, np.pi / 2).moved(y=0.0045, z=0.5 * y)
    hinge = cylinder(0.006, 0.6 * x, 12).turned(1, np.pi / 2).moved(x=-0.3 * x, y=0.46 * y, z=t)

    def opened(solid):
        return solid.turned(0, -lean).moved(y=0.46 * y, z=t)

    return shape(
        [
            (base, case),
            (field, keys),
            (pad, textures.plain(tinted(color, 0.82))),
            (hinge, textures.plain(DARK)),
            (opened(lid), case),
            (opened(glass), textures.plain(DARK)),
            (opened(view), prints.desktop(look.rng)),
            (opened(logo), textures.plain((236, 238, 240))),
        ],
        [box_part(x, y, t), hull_of(opened(lid), opened(glass))],
    )


def monitor(look: Look) -> Shape:
    """A flat screen on a foot, facing the viewer."""
    x = look.between(0.5, 0.58)
    y, z, lift = 0.19, 0.58 * x, look.between(0.09, 0.12)
    color = look.color("black", "charcoal", "silver", "white")
    case = textures.speckled(look.rng, color, 3, 32)
    panel = block(x, 0.026, z, 0.006, 0.003).moved(z=lift)
    bezel = box(x - 0.004, 0.001, z - 0.004).moved(y=-0.0133, z=lift + 0.002)
    view = box(x - 0.022, 0.001, z - 0.034).moved(y=-0.0138, z=lift + 0.022)
    neck = block(0.06, 0.02, lift + 0.5 * z, 0.006).moved(y=0.022)
    foot = (
        cylinder(0.5 * y, 0.012, 32, bevel=0.003).scaled(1.3, 1, 1)
        if look.chance(0.5)
        else block(0.24, y, 0.012, 0.02, 0.003)
    )
    return shape(
        [
            (panel, case),
            (bezel, textures.plain(DARK)),
            (view, prints.desktop(look.rng)),
            (neck, case),
            (foot, case),
        ],
        [
            hull_of(foot),
            box_part(0.06, 0.02, lift + 0.5 * z, (0, 0.022, 0)),
            box_part(x, 0.026, z, (0, 0, lift)),
        ],
    )


def keyboard(look: Look) -> Shape:
    """A computer keyboard, a little higher at the back."""
    x, y = look.between(0.36, 0.44), look.between(0.125, 0.14)
    color = look.color("black", "white", "charcoal", "silver", "cream")
    cap = look.pick([color, tinted(color, 1.12), tinted(color, 0.85)])
    accent = look.fixed("orange", "teal", "red", "sky") if look.chance(0.4) else None
    field = prints.keys(prints.QWERTY, cap, tinted(color, 0.62), accent=accent)

    def raised(p):
        return np.column_stack([p[:, :2], p[:, 2] + np.where(p[:, 2] > 0.004, 0.07, 0) * p[:, 1]])

    body = block(x, y, 0.017, 0.008, 0.002).bent(raised)
    deck = block(x * 0.965, y * 0.88, 0.006, 0.003, 0.001).moved(z=0.0165).bent(raised)
    return shape(
        [(body, textures.speckled(look.rng, color, 3, 32)), (deck, field)],
        [hull_of(body), hull_of(deck)],
    )


def computer_mouse(look: Look) -> Shape:
    """A computer mouse with two buttons and a wheel, buttons away from the viewer."""
    x, y, z = look.between(0.058, 0.066), look.between(0.1, 0.115), look.between(0.034, 0.04)
    color = look.color("black", "white", "gray", "red", "charcoal", "sky")
    outline = ellipse(2, 2, 28)
    outline = np.sign(outline) * np.abs(outline) ** 0.8 * [x / 2, y / 2]
    angles = np.linspace(0, np.pi / 2, 8)
    widths = [0.0, 0.94, 1.0, *np.cos(angles[:-1]), 0.0]
    heights = [0.0, 0.0, 0.08, *(0.3 + 0.7 * np.sin(angles))]
    rings = [
        np.column_stack([outline * w, np.full(28, h * z)])
        for w, h in zip(widths, heights, strict=True)
    ]
    body = loft(np.stack(rings), profile=np.column_stack([widths, heights]) * [y / 2, z])
    skin = prints.canvas(128, 128, color)
    dark = tinted(color, 0.4)
    prints.fill(skin, 0.242, 0.0, 0.016, 0.5, dark)
    prints.fill(skin, 0.0, 0.25, 0.5, 0.02, dark)
    prints.fill(skin, 0.0, 0.52, 1.0, 0.02, tinted(color, 0.7))
    wheel = torus(0.0075, 0.0035, 16, 8).turned(1, np.pi / 2).moved(y=0.2 * y, z=0.76 * z)
    low = [ring for ring, h in zip(rings, heights, strict=True) if h <= 0.3]
    high = [ring for ring, h in zip(rings, heights, strict=True) if h >= 0.3]
    return shape(
        [(body, skin), (wheel, textures.plain(dark))],
        [hull_part(np.concatenate([ring[::2] for ring in low])), hull_part(np.concatenate(high))],
    )


def _slab(look: Look, x: float, y: float, h: float, rim: float, screen: textures.Tile) -> Shape:
    """A thin slab with a screen on top, lying flat."""
    color = look.color("black", "silver", "white", "navy", "gold", "mint")
    case = textures.brushed(look.rng, color, 32)
    radius = 0.11 * x
    body = block(x, y, h, radius, 0.001)
    glass = block(x * 0.97, y * 0.985, 0.0005, radius * 0.9).moved(z=h)
    view = block(x - 2 * rim, y - 2.4 * rim, 0.0003, radius * 0.7).moved(z=h + 0.0005)
    return shape(
        [(body, case), (glass, textures.plain((18, 18, 21))), (view, screen)],
        [box_part(x, y, h + 0.0008)],
    )


def smartphone(look: Look) -> Shape:
    """A phone lying on its back, screen on."""
    return _slab(
        look,
        look.between(0.07, 0.077),
        look.between(0.146, 0.16),
        0.0078,
        0.003,
        prints.apps(look.rng),
    )


def tablet(look: Look) -> Shape:
    """A tablet or e-reader lying flat."""
    reader = look.chance(0.4)
    x, y = (0.118, 0.165) if reader else (look.between(0.165, 0.18), look.between(0.235, 0.25))
    tile = prints.sheet(look.rng) if reader else prints.apps(look.rng, 128, 176)
    return _slab(look, x, y, 0.0075, 0.011 if reader else 0.008, tile)


CATEGORIES = (
    Category(
        "laptop",
        laptop,
        (0.32, 0.26, 0.23),
        1.5,
        ("notebook computer", "macbook"),
        ("office", "coffee"),
        ("big", "screen"),
        ("silver", "charcoal"),
        state="open",
    ),
    Category(
        "monitor",
        monitor,
        (0.54, 0.19, 0.42),
        4.0,
        ("computer monitor", "display", "screen", "computer", "tv", "television"),
        ("office",),
        ("big", "tall", "screen"),
        ("black", "silver"),
    ),
    Category(
        "keyboard",
        keyboard,
        (0.4, 0.132, 0.024),
        0.6,
        ("computer keyboard",),
        ("office",),
        ("big", "flat"),
        ("black", "white"),
        state="lying flat",
    ),
    Category(
        "computer_mouse",
        computer_mouse,
        (0.062, 0.108, 0.037),
        0.09,
        ("mouse", "wireless mouse"),
        ("office",),
        (),
        ("black", "white"),
    ),
    Category(
        "smartphone",
        smartphone,
        (0.074, 0.153, 0.0086),
        0.18,
        ("phone", "mobile phone", "cell phone", "cellphone", "mobile"),
        ("office", "coffee", "living", "vanity"),
        ("flat", "screen"),
        ("black", "silver"),
        state="lying flat",
    ),
    Category(
        "tablet",
        tablet,
        (0.15, 0.21, 0.0083),
        0.4,
        ("e-reader", "ereader", "ipad", "kindle", "tablet computer"),
        ("office", "coffee", "living"),
        ("flat", "screen"),
        ("black", "silver"),
        state="lying flat",
    ),
)
