"""Computers, phones, sound and cameras."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, loft, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK = (40, 41, 45)


def key_caps(
    rows: Sequence[Sequence[float]], x: float, y: float, rise: float, gap: float = 0.0022
) -> Solid:
    """Return a field of tapered caps, x by y on z = 0; together they show one whole texture."""
    caps, deep = [], y / len(rows)
    for j, row in enumerate(rows):
        edges = x * np.cumsum([0.0, *row]) / sum(row) - x / 2
        for a, b in itertools.pairwise(edges):
            cap = box(b - a - gap, deep - gap, rise).move((a + b) / 2, y / 2 - deep * (j + 0.5))
            middle = np.array([(a + b) / 2, y / 2 - deep * (j + 0.5)])
            high = cap.vertices[:, 2] > 0.5 * rise
            flat = np.where(high[:, None], 0.84, 1.0) * (cap.vertices[:, :2] - middle) + middle
            uv = np.clip(flat / [x, y] + 0.5, 0, 1)
            caps.append(Solid(np.column_stack([flat, cap.vertices[:, 2]]), cap.faces, uv))
    return join(caps)


def laptop(look: Look) -> Shape:
    """A laptop, keyboard towards the viewer, screen leaning back; one in eight is closed.

    The attribute "state" ("open", "closed") decides where it is given.
    """
    x, y = look.between(0.29, 0.36), look.between(0.2, 0.24)
    t, thin = look.between(0.011, 0.019), look.between(0.005, 0.008)
    color = look.color("silver", "silver", "charcoal", "gray", "black", "white", "navy", "pink")
    state = look.attributes.get("state", "")
    closed = state == "closed" or (state != "open" and look.chance(0.125))
    case = textures.brushed_metal(look.rng, color, 32)
    dark = textures.plain(DARK)
    base = block(x, y, t, look.between(0.004, 0.014), 0.002)
    lid = block(x, y, thin, 0.01, 0.0015)
    top = _lid_print(look, color)
    if closed:
        lid = lid.move(z=t + 0.001)
        cover = block(0.985 * x, 0.985 * y, 0.0004, 0.009).move(z=t + 0.001 + thin)
        hinge = box(0.7 * x, 0.006, 0.004).move(y=0.5 * y - 0.003, z=t - 0.0015)
        return shape(
            [(base, case), (lid, case), (cover, top), (hinge, dark)],
            [box_part(x, y, t + 0.001 + thin)],
        )
    lean = np.deg2rad(look.between(6, 36))
    cap, deck = look.pick([(DARK, 0.9), ((236, 236, 238), 0.8), (tint_color(color, 0.9), 0.55)])
    keys = prints.keys(prints.QWERTY, cap, tint_color(color, deck), width=320, height=120)
    field = key_caps(prints.QWERTY, 0.9 * x, 0.5 * y, 0.0016).move(y=0.12 * y, z=t)
    bed = box(0.92 * x, 0.52 * y, 0.0004).move(y=0.12 * y, z=t)
    pad = box(look.between(0.26, 0.4) * x, 0.29 * y, 0.0004).move(y=-0.32 * y, z=t)
    rim, chin = look.between(0.01, 0.03), look.between(0.03, 0.1)
    panel = lid.turn(0, np.pi / 2).move(y=thin / 2, z=y / 2)
    glass = box(0.985 * x, 0.001, 0.97 * y).move(y=-thin / 2 - 0.0002, z=0.015 * y)
    view = box((1 - 2 * rim) * x, 0.001, (1 - chin - rim) * y)
    view = view.move(y=-thin / 2 - 0.0007, z=chin * y)
    back = box(0.97 * x, 0.0004, 0.97 * y).move(y=thin / 2 + 0.0003, z=0.015 * y)
    hinge = cylinder(0.006, 0.6 * x, 12).turn(1, np.pi / 2).move(x=-0.3 * x, y=0.46 * y, z=t)

    def tilt(solid: Solid) -> Solid:
        return solid.turn(0, -lean).move(y=0.46 * y, z=t)

    pieces = [
        (base, case), (bed, textures.plain(tint_color(color, deck))), (field, keys),
        (pad, textures.plain(tint_color(color, 0.82))), (hinge, dark), (tilt(panel), case),
        (tilt(glass), look.pick([dark, dark, case])),
        (tilt(view), prints.desktop(look.rng)), (tilt(back), top),
    ]  # fmt: skip
    if look.chance(0.3):
        note = textures.plain(look.own_color("teal", "orange", "yellow", "blue"))
        pieces.append((box(0.018, 0.018, 0.0003).move(0.38 * x, -0.4 * y, t), note))
    return shape(pieces, [box_part(x, y, t), hull_of(tilt(panel), tilt(glass))])


def _lid_print(look: Look, color: RGB) -> textures.Tile:
    """Return a lid's outside: brushed, with a logo, a strip, or stickers."""
    image = prints.canvas(192, 128, color)
    image[:] = textures.fit(textures.brushed_metal(look.rng, color), 128, 192)
    shade = tint_color(color, 1.6 if sum(color) < 500 else 0.6)
    kind = int(look.rng.integers(4))
    if kind == 0:
        prints.disc(image, 0.5, 0.5, 0.08, shade)
    elif kind == 1:
        prints.write(image, look.pick(["NOVA", "ARC", "VOLT", "AERO"]), 0.5, 0.5, 0.11, shade)
    elif kind == 2:
        prints.fill(image, 0.46, 0.44, 0.08, 0.12, shade)
        prints.fill(image, 0.475, 0.465, 0.05, 0.07, color)
    else:
        for _ in range(5):
            x, y = look.between(0.15, 0.85), look.between(0.2, 0.8)
            paint = look.own_color("red", "yellow", "teal", "white", "violet", "orange", "lime")
            prints.disc(image, x, y, 0.1, (246, 246, 244))
            prints.disc(image, x, y, 0.085, paint)
            prints.disc(image, x, y, 0.04, tint_color(paint, 0.5))
    return image[::-1].copy() if kind == 3 else image


def monitor(look: Look) -> Shape:
    """A flat screen on a foot, facing the viewer: thin or chunky, on a disc, a slab or legs."""
    x = look.between(0.46, 0.62)
    y, z, lift = look.between(0.17, 0.21), look.between(0.5, 0.62) * x, look.between(0.07, 0.13)
    color = look.color("black", "black", "charcoal", "silver", "white", "navy", "cream")
    case = textures.speckles(look.rng, color, 3, 32)
    thick, rim = look.between(0.014, 0.045), look.between(0.005, 0.022)
    chin = look.between(0.012, 0.05)
    panel = block(x, thick, z, 0.4 * thick, 0.003).move(z=lift)
    bezel = box(x - 0.004, 0.001, z - 0.004).move(y=-thick / 2 - 0.0003, z=lift + 0.002)
    view = box(x - 2 * rim, 0.001, z - rim - chin).move(y=-thick / 2 - 0.0008, z=lift + chin)
    light = box(0.01, 0.001, 0.003).move(0.42 * x, -thick / 2 - 0.0008, lift + 0.004)
    edge = look.pick([textures.plain(DARK), case])
    neck = block(look.between(0.035, 0.08), 0.02, lift + 0.5 * z, 0.006)
    neck = neck.move(y=0.01 + thick / 2)
    metal = look.pick(
        [case, textures.brushed_metal(look.rng, look.own_color("silver", "charcoal"))]
    )
    kind = look.pick(["disc", "slab", "legs"])
    if kind == "disc":
        feet = [cylinder(0.5 * y, 0.012, 32, bevel=0.003).scale(1.3, 1, 1)]
    elif kind == "slab":
        feet = [block(look.between(0.2, 0.28), y, 0.01, 0.02, 0.003)]
    else:
        leg = block(0.26, 0.022, 0.014, 0.008, 0.003)
        feet = [leg.turn(2, -s * 0.45).move(x=s * 0.11, y=-0.3 * y + 0.02) for s in (-1, 1)]
        feet.append(block(0.06, 0.5 * y, 0.014, 0.01, 0.003).move(y=0.25 * y))
    low = 0.02 + thick / 2
    return shape(
        [(panel, case), (bezel, edge), (view, prints.desktop(look.rng, 320, 180)),
         (light, textures.plain((120, 210, 160))), (neck, metal), *((f, metal) for f in feet)],
        [*[hull_of(foot) for foot in feet],
         box_part(0.04, low, lift + 0.5 * z, (0, low / 2, 0)), box_part(x, thick, z, (0, 0, lift))],
    )  # fmt: skip


NUMPAD: tuple[tuple[float, ...], ...] = tuple((*row, 0.6, 1, 1, 1, 1) for row in prints.QWERTY)
SMALL = prints.QWERTY[1:]


def keyboard(look: Look) -> Shape:
    """A computer keyboard, a little higher at the back: full size, without number pad, or small."""
    rows, x = look.pick(
        [(prints.QWERTY, 0.37), (prints.QWERTY, 0.37), (NUMPAD, 0.44), (SMALL, 0.34)]
    )
    x, y = (
        x * look.between(0.97, 1.04),
        look.between(0.122, 0.14) * (5.4 if rows is SMALL else 6) / 6,
    )
    color = look.color(
        "black", "black", "white", "charcoal", "silver", "cream", "navy", "pink", "sage"
    )
    cap = look.pick([color, tint_color(color, 1.14), tint_color(color, 0.8), DARK, (236, 234, 228)])
    glow = look.pick([None, None, (90, 220, 230), (230, 90, 200)])
    accent = look.own_color("orange", "teal", "red", "sky", "yellow", "lime")
    ground = glow if glow and sum(cap) < 260 else tint_color(color, 0.62)
    field = prints.keys(
        rows, cap, ground, accent=accent if look.chance(0.5) else None, width=384, height=128
    )
    thick, rise = look.between(0.01, 0.016), look.between(0.003, 0.008)

    def lift(p: np.ndarray) -> np.ndarray:
        return np.column_stack([p[:, :2], p[:, 2] + np.where(p[:, 2] > 0.004, 0.07, 0) * p[:, 1]])

    body = block(x, y, thick, look.between(0.003, 0.014), 0.002).bend(lift)
    wide, deep = x - look.between(0.012, 0.02), y - look.between(0.012, 0.026)
    bed = box(wide, deep, 0.001).move(z=thick - 0.0004).bend(lift)
    caps = key_caps(rows, wide, deep, rise).move(z=thick + 0.0002).bend(lift)
    return shape(
        [(body, textures.speckles(look.rng, color, 3, 32)), (bed, textures.plain(ground)),
         (caps, field)],
        [hull_of(body), hull_of(caps)],
    )  # fmt: skip


def computer_mouse(look: Look) -> Shape:
    """A computer mouse, buttons away from the viewer: plain, flat, two-tone or for games."""
    x, y, z = look.between(0.056, 0.068), look.between(0.098, 0.12), look.between(0.03, 0.042)
    color = look.color(
        "black", "black", "white", "gray", "red", "charcoal", "sky", "pink", "navy", "lime"
    )
    kind = look.pick(["plain", "flat", "two-tone", "game"])
    square = {"flat": 0.62, "game": 0.7}.get(kind, 0.8)
    outline = ellipse(2, 2, 28)
    outline = np.sign(outline) * np.abs(outline) ** square * [x / 2, y / 2]
    if kind == "game":
        outline[:, 0] *= 1 - 0.16 * np.exp(-((outline[:, 1] / (0.2 * y)) ** 2))
    z = 0.7 * z + 0.003 if kind == "flat" else z
    angles = np.linspace(0, np.pi / 2, 8)
    widths = [0.0, 0.94, 1.0, *np.cos(angles[:-1]), 0.0]
    heights = [0.0, 0.0, 0.08, *(0.3 + 0.7 * np.sin(angles))]
    rings = [
        np.column_stack([outline * w, np.full(28, h * z)])
        for w, h in zip(widths, heights, strict=True)
    ]
    body = loft(np.stack(rings), profile=np.column_stack([widths, heights]) * [y / 2, z])
    skin, dark = prints.canvas(128, 128, color), tint_color(color, 0.4)
    if kind == "two-tone":
        other = look.own_color("white", "charcoal", "silver", "teal")
        prints.fill(skin, 0, 0.62, 1, 0.38, other)
        prints.fill(skin, 0.5, 0, 0.5, 0.5, tint_color(color, 1.2))
    if kind == "game":
        stripe = look.own_color("lime", "red", "cyan", "violet")
        prints.fill(skin, 0, 0.56, 1, 0.03, stripe)
        prints.disc(skin, 0.75, 0.3, 0.06, stripe, 0.035)
    if kind != "flat":
        prints.fill(skin, 0.242, 0.0, 0.016, 0.5, dark)
        prints.fill(skin, 0.0, 0.25, 0.5, 0.02, dark)
        prints.fill(skin, 0.0, 0.52, 1.0, 0.02, tint_color(color, 0.7))
    wheel = torus(0.0075, 0.0035, 16, 8).turn(1, np.pi / 2).move(y=0.2 * y, z=0.76 * z)
    low = [ring for ring, h in zip(rings, heights, strict=True) if h <= 0.3]
    high = [ring for ring, h in zip(rings, heights, strict=True) if h >= 0.3]
    rim = textures.plain(look.pick([dark, dark, (170, 172, 176)]))
    return shape(
        [(body, skin)] if kind == "flat" and look.chance(0.5) else [(body, skin), (wheel, rim)],
        [hull_part(np.concatenate([ring[::2] for ring in low])), hull_part(np.concatenate(high))],
    )


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
        ("computer monitor", "display", "screen", "computer"),
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
        ("mouse", "wireless mouse", "trackball"),
        ("office",),
        (),
        ("black", "white"),
    ),
)
