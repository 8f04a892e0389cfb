"""Objects of the ``office`` theme: computers."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse, smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part
from ...kit.primitives import facing, lay_down
from ...kit.shapes import Shape, category, shape, vary
from ...kit.solids import Solid, block, box, cylinder, join, lathe, loft, torus, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color

DARK: RGB = (32, 32, 35)
STEEL: RGB = (196, 198, 202)


@category("usb_hub", size=(0.179, 0.0955, 0.012), mass=0.06, material="device",
          aliases=("usb splitter", "usb port hub", "usb multiport", "hub", "splitter",
          "cable splitter"), themes=("office",), roles=("flat",), colors=("black",))  # fmt: skip
def usb_hub(look: Look) -> Shape:
    """A USB hub lying flat: a bar with four sockets and a short cable with a plug."""
    k = look.between(0.9, 1.1)
    x, y, h = 0.1 * k, 0.03 * k, 0.012 * k
    color = look.color("black", "silver", "white", "gray", "blue")
    body = block(x, y, h, 0.005, 0.002)
    ports, tongues = [], []
    for n in range(4):
        u = (n - 1.5) * 0.023 * k
        ports.append(box(0.0145 * k, 0.0022, 0.0065 * k).move(u, -y / 2, 0.25 * h))
        tongues.append(box(0.011 * k, 0.0026, 0.002 * k).move(u, -y / 2, 0.45 * h))
    way = smooth([(x / 2 - 0.002, 0, h / 2), (x / 2 + 0.02, 0.002, h / 2), (x / 2 + 0.045, 0.022,
                  0.0035), (x / 2 + 0.06, 0.045, 0.0035)], 5)  # fmt: skip
    lead = tube(way, 0.0021, 8)
    plug = block(0.014, 0.026, 0.008, 0.002, 0.001).turn(2, -0.5).move(x / 2 + 0.064, 0.056, 0)
    tip = box(0.012, 0.016, 0.0046).turn(2, -0.5).move(x / 2 + 0.0725, 0.0715, 0.0015)
    black = surfaces.plain(DARK)
    return shape([(body, look.surface(color, "plastic")), (join(ports), black),
                  (join(tongues), surfaces.plain((60, 110, 210))), (join([lead, plug]), black),
                  (tip, surfaces.plain(STEEL))],
                 [hull_of(body), hull_of(plug), hull_of(tip)])  # fmt: skip


@category("graphics_tablet", size=(0.28, 0.1835, 0.02), mass=0.5, material="device",
          aliases=("drawing tablet", "pen tablet", "graphic tablet", "digital drawing tablet"),
          themes=("office",), roles=("flat", "big"), colors=("black",))  # fmt: skip
def graphics_tablet(look: Look) -> Shape:
    """A drawing tablet with keys on its side and a pen on top."""
    k = look.between(0.88, 1.05)
    x, y, h = 0.29 * k, 0.19 * k, 0.0085
    color = look.color("black", "charcoal", "black", "white")
    pale = tint_color(color, 1.22) if sum(color) < 400 else tint_color(color, 0.9)
    area = prints.canvas(128, 96, pale)
    for u, v in ((0.05, 0.07), (0.95, 0.07), (0.05, 0.93), (0.95, 0.93)):
        prints.fill(area, u - 0.02, v - 0.004, 0.04, 0.008, (190, 192, 196))
        prints.fill(area, u - 0.003, v - 0.03, 0.006, 0.06, (190, 192, 196))
    keys = [block(0.02 * k, 0.014 * k, 0.0016, 0.003).move(-0.43 * x, (n - 2.5) * 0.02 * k,
        h - 0.0006)
            for n in range(6)]  # fmt: skip
    pen = lay_down(lathe(np.array([(0, 0), (0.0008, 0), (0.0048, 0.018), (0.0058, 0.05),
                               (0.005, 0.15), (0, 0.152)]) * k, 16), -0.07 * k,
                                   h + 0.0058 * k)  # fmt: skip
    pen = pen.turn(2, 0.5).move(x=0.06 * x)
    return shape([(block(x, y, h, 0.01, 0.002), look.surface(color, "plastic")),
                  (box(0.78 * x, 0.86 * y, 0.0005).move(x=0.05 * x, z=h - 0.0002), area),
                  (join(keys), surfaces.plain(tint_color(pale, 0.8))), (pen, surfaces.plain(
                      (70, 70, 76)))], [box_part(x, y, h), hull_of(pen)])  # fmt: skip


@category("router", size=(0.21, 0.15, 0.155), mass=0.4, material="device", aliases=("wifi router",
          "wi-fi router", "modem", "wireless router", "access point", "wi-fi extender",
          "wifi extender"), themes=("office", "gaming"), colors=("black", "white"),
          common=True)  # fmt: skip
def router(look: Look) -> Shape:
    """A wireless router with upright antennas and a row of lights."""
    x, y, h = look.between(0.18, 0.24), look.between(0.12, 0.15), look.between(0.028, 0.036)
    color = look.color("black", "white", "charcoal", "white")
    shell, dark = surfaces.speckles(look.rng, color, 3, 32), tint_color(color, 0.7)
    body = block(x, y, h, 0.02, 0.008)
    face = prints.canvas(160, 16, dark)
    for k in range(7):
        lamp = (90, 220, 120) if look.chance(0.7) else (230, 170, 60)
        prints.disc(face, 0.2 + 0.1 * k, 0.5, 0.2, lamp)
    strip = box(0.8 * x, 0.002, 0.3 * h).move(y=-y / 2 - 0.0004, z=0.34 * h)
    vents = surfaces.grid(tint_color(color, 0.6), color, 0, 12, 96, 3)
    top = block(0.7 * x, 0.5 * y, 0.001, 0.006).move(y=0.1 * y, z=h - 0.0003)
    count = int(look.rng.integers(2, 5))
    masts, parts = [], [box_part(x, y, h)]
    for k in range(count):
        at = (k - (count - 1) / 2) * 0.84 * x / max(count - 1, 1)
        tall, tilt = look.between(0.13, 0.16), 0.22 * at / x
        joint = lay_down(cylinder(0.007, 0.014, 12), at - 0.007, h * 0.6).move(y=y / 2 + 0.002)
        mast = block(0.013, 0.008, tall, 0.003, 0.002).turn(1, tilt)
        mast = mast.move(at, y / 2 + 0.004, 0.45 * h)
        masts += [joint, mast]
        parts.append(hull_of(mast))
    return shape(
        [(body, shell), (strip, face), (top, vents), (join(masts), surfaces.plain(dark))], parts
    )


LAPTOP_DARK = (40, 41, 45)


def key_caps(
    rows: Sequence[Sequence[float]], x: float, y: float, rise: float, gap: float = 0.0022
) -> Solid:
    """Return tapered key caps that cover ``x`` by ``y`` metres on z = 0 and share one texture."""
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


@category("laptop", size=(0.32, 0.26, 0.23), mass=1.5, material="device",
          aliases=("notebook computer", "macbook"), themes=("office", "coffee"),
          roles=("big", "screen"), colors=("silver", "charcoal"), state="open",
          common=True)  # fmt: skip
def laptop(look: Look) -> Shape:
    """A laptop with its keyboard towards the viewer and a tilted screen; one in eight is closed.

    The attribute "state" ("open" or "closed") overrides this choice.
    """
    x, y = look.between(0.29, 0.36), look.between(0.2, 0.24)
    t, thin = look.between(0.011, 0.019), look.between(0.005, 0.008)
    color = look.color("silver", "silver", "charcoal", "gray", "black", "white", "navy", "pink")
    state = look.attributes.get("state", "")
    closed = state == "closed" or (state != "open" and look.chance(0.125))
    case = surfaces.brushed_metal(look.rng, color, 32)
    dark = surfaces.plain(LAPTOP_DARK)
    base = block(x, y, t, look.between(0.004, 0.014), 0.002)
    lid = block(x, y, thin, 0.01, 0.0015)
    top = _lid_print(look, color)
    if closed:
        lid = lid.move(z=t + 0.001)
        cover = block(0.985 * x, 0.985 * y, 0.0004, 0.009).move(z=t + 0.001 + thin)
        hinge = box(0.7 * x, 0.006, 0.004).move(y=0.5 * y - 0.003, z=t - 0.0015)
        return shape([(base, case), (lid, case), (cover, top), (hinge, dark)],
                     [box_part(x, y, t + 0.001 + thin)])  # fmt: skip
    lean = np.deg2rad(look.between(6, 36))
    cap, deck = look.pick(
        [(LAPTOP_DARK, 0.9), ((236, 236, 238), 0.8), (tint_color(color, 0.9), 0.55)]
    )
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
        (base, case), (bed, surfaces.plain(tint_color(color, deck))), (field, keys),
        (pad, surfaces.plain(tint_color(color, 0.82))), (hinge, dark), (tilt(panel), case),
        (tilt(glass), look.pick([dark, dark, case])),
        (tilt(view), prints.desktop(look.rng)), (tilt(back), top),
    ]  # fmt: skip
    if look.chance(0.3):
        note = surfaces.plain(look.own_color("teal", "orange", "yellow", "blue"))
        pieces.append((box(0.018, 0.018, 0.0003).move(0.38 * x, -0.4 * y, t), note))
    return shape(pieces, [box_part(x, y, t), hull_of(tilt(panel), tilt(glass))])


def _lid_print(look: Look, color: RGB) -> surfaces.Tile:
    """Return a brushed texture for a laptop's lid, with a logo, a strip or stickers."""
    image = prints.canvas(192, 128, color)
    image[:] = surfaces.fit(surfaces.brushed_metal(look.rng, color), 128, 192)
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


@category("monitor", size=(0.54, 0.19, 0.42), mass=4.0, material="device",
          aliases=("computer monitor", "display", "screen", "computer"), themes=("office",),
          roles=("big", "tall", "screen"), colors=("black", "silver"), common=True)  # fmt: skip
def monitor(look: Look) -> Shape:
    """A thin or chunky flat screen facing the viewer, on a disc, a slab or legs."""
    x = look.between(0.46, 0.62)
    y, z, lift = look.between(0.17, 0.21), look.between(0.5, 0.62) * x, look.between(0.07, 0.13)
    color = look.color("black", "black", "charcoal", "silver", "white", "navy", "cream")
    case = surfaces.speckles(look.rng, color, 3, 32)
    thick, rim = look.between(0.014, 0.045), look.between(0.005, 0.022)
    chin = look.between(0.012, 0.05)
    panel = block(x, thick, z, 0.4 * thick, 0.003).move(z=lift)
    bezel = box(x - 0.004, 0.001, z - 0.004).move(y=-thick / 2 - 0.0003, z=lift + 0.002)
    view = box(x - 2 * rim, 0.001, z - rim - chin).move(y=-thick / 2 - 0.0008, z=lift + chin)
    light = box(0.01, 0.001, 0.003).move(0.42 * x, -thick / 2 - 0.0008, lift + 0.004)
    edge = look.pick([surfaces.plain(LAPTOP_DARK), case])
    neck = block(look.between(0.035, 0.08), 0.02, lift + 0.5 * z, 0.006)
    neck = neck.move(y=0.01 + thick / 2)
    metal = look.pick(
        [case, surfaces.brushed_metal(look.rng, look.own_color("silver", "charcoal"))]
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
         (light, surfaces.plain((120, 210, 160))), (neck, metal), *((f, metal) for f in feet)],
        [*[hull_of(foot) for foot in feet],
         box_part(0.04, low, lift + 0.5 * z, (0, low / 2, 0)), box_part(x, thick, z, (0, 0, lift))],
    )  # fmt: skip


NUMPAD: tuple[tuple[float, ...], ...] = tuple((*row, 0.6, 1, 1, 1, 1) for row in prints.QWERTY)
SMALL = prints.QWERTY[1:]


@category("keyboard", size=(0.4, 0.132, 0.024), mass=0.6, material="device",
          aliases=("computer keyboard",), themes=("office",), roles=("big", "flat"),
          colors=("black", "white"), state="lying flat", common=True)  # fmt: skip
def keyboard(look: Look) -> Shape:
    """A computer keyboard, slightly higher at the back: full-size, without a keypad, or small."""
    rows, x = look.pick(
        [(prints.QWERTY, 0.37), (prints.QWERTY, 0.37), (NUMPAD, 0.44), (SMALL, 0.34)]
    )
    x, y = (x * look.between(0.97, 1.04), look.between(0.122, 0.14) * (5.4 if rows is SMALL else 6)
            / 6)  # fmt: skip
    color = look.color(
        "black", "black", "white", "charcoal", "silver", "cream", "navy", "pink", "sage"
    )
    cap = look.pick(
        [color, tint_color(color, 1.14), tint_color(color, 0.8), LAPTOP_DARK, (236, 234, 228)]
    )
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
        [(body, surfaces.speckles(look.rng, color, 3, 32)), (bed, surfaces.plain(ground)),
         (caps, field)],
        [hull_of(body), hull_of(caps)],
    )  # fmt: skip


@category("computer_mouse", size=(0.062, 0.108, 0.037), mass=0.09, material="device",
          aliases=("mouse", "wireless mouse", "trackball"), themes=("office",),
          colors=("black", "white"), common=True)  # fmt: skip
def computer_mouse(look: Look) -> Shape:
    """A plain, flat, two-tone or gaming mouse with its buttons away from the viewer."""
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
    rings = [np.column_stack([outline * w, np.full(28, h * z)]) for w,
             h in zip(widths, heights, strict=True)]  # fmt: skip
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
    rim = surfaces.plain(look.pick([dark, dark, (170, 172, 176)]))
    return shape(
        [(body, skin)] if kind == "flat" and look.chance(0.5) else [(body, skin), (wheel, rim)],
        [hull_part(np.concatenate([ring[::2] for ring in low])), hull_part(np.concatenate(high))],
    )


def _slab(look: Look, x: float, y: float, h: float, rim: float, screen: surfaces.Tile) -> Shape:
    """Return a thin slab with a screen, face up or face down, sometimes in a coloured cover."""
    color = look.color(
        *("black", "silver", "white", "navy", "gold", "mint", "red", "pink", "lavender", "teal")
    )
    case = surfaces.brushed_metal(look.rng, color, 32)
    radius = look.between(0.06, 0.13) * x
    kind = look.pick(["up", "up", "up", "cover", "down"])
    body = block(x, y, h, radius, 0.001)
    if kind == "down":
        bump = block(0.3 * x, 0.32 * x, 0.0018, 0.08 * x, 0.0004)
        bump = bump.move(-0.26 * x, y / 2 - 0.24 * x, h)
        lens = cylinder(0.055 * x, 0.001, 18)
        lenses = [lens.move(-0.26 * x, y / 2 - (0.17 + 0.14 * k) * x, h + 0.0018) for k in (0, 1)]
        logo = cylinder(0.06 * x, 0.0003, 20).move(y=0.05 * y, z=h)
        shine = surfaces.plain((24, 26, 36))
        return shape(
            [(body, case), (bump, surfaces.plain(tint_color(color, 0.8))),
             *((one, shine) for one in lenses), (logo, surfaces.plain(tint_color(color, 1.4)))],
            [box_part(x, y, h), hull_of(bump)],
        )  # fmt: skip
    glass = block(x * 0.97, y * 0.985, 0.0005, radius * 0.9).move(z=h)
    view = block(x - 2 * rim, y - 2.4 * rim, 0.0003, radius * 0.7).move(z=h + 0.0005)
    pieces = [(body, case), (glass, surfaces.plain((18, 18, 21))), (view, screen)]
    if kind == "cover":
        shell = block(x + 0.004, y + 0.004, 0.9 * h, radius + 0.002, 0.001)
        soft = look.own_color("red", "teal", "yellow", "pink", "black", "sky", "orange")
        pieces.append((shell, surfaces.speckles(look.rng, soft, 3, 32)))
    return shape(pieces, [box_part(x, y, h + 0.0008)])


@category("tablet", size=(0.15, 0.21, 0.0083), mass=0.4, material="device",
          aliases=("ipad", "tablet computer"), themes=("office", "coffee", "living"),
          roles=("flat", "screen"), colors=("black", "silver"), state="lying flat",
          common=True)  # fmt: skip
def tablet(look: Look) -> Shape:
    """A tablet or e-reader, lying flat."""
    reader = look.chance(0.4)
    x, y = (0.118, 0.165) if reader else (look.between(0.165, 0.18), look.between(0.235, 0.25))
    page = prints.sheet(look.rng, picture=look.chance(0.3))
    tile = page if reader else prints.apps(look.rng, 128, 176)
    return _slab(look, x, y, 0.0075, 0.011 if reader else look.between(0.005, 0.012), tile)


@category("floppy_disk", size=(0.09, 0.094, 0.0037), mass=0.02, material="plastic",
          aliases=("floppy", "diskette", "floppy disc"), themes=("office",), roles=("flat",),
          colors=("black", "blue"))  # fmt: skip
@vary()
def floppy_disk(look: Look) -> Shape:
    """A 3.5 inch floppy disk, lying flat."""
    k = look.between(0.98, 1.02)
    color = look.color("black", "blue", "navy", "red", "yellow", "gray", "green")
    x, y, h = 0.09 * k, 0.094 * k, 0.0035
    image = prints.canvas(128, 134, color)
    prints.fill(image, 0.12, 0.42, 0.76, 0.58, (246, 244, 238))
    prints.fill(image, 0.12, 0.42, 0.76, 0.08, look.own_color("red", "orange", "teal", "blue"))
    prints.lines(image, look.rng, (0.2, 0.56, 0.6, 0.36), 4, (150, 150, 160), 0.15)
    prints.fill(image, 0.24, 0, 0.54, 0.34, (186, 190, 196))
    prints.fill(image, 0.58, 0.04, 0.12, 0.26, tint_color(color, 0.6))
    return shape([(box(x, y, h), surfaces.plain(tint_color(color, 0.9))),
                  (box(0.99 * x, 0.99 * y, 0.0004).move(z=h - 0.0001), image)],
                 [box_part(x, y, h)])  # fmt: skip


USB_STICK_DARK: RGB = (36, 37, 41)


@category("usb_stick", size=(0.055, 0.017, 0.008), mass=0.01, material="metal",
          aliases=("flash drive", "usb flash drive", "memory stick", "thumb drive", "pen drive",
          "usb", "usb key", "usb drive", "usb plug", "dongle", "wifi dongle"),
          themes=("office", "gaming"), roles=("flat",), colors=("black", "red"),
          state="lying flat")  # fmt: skip
def usb_stick(look: Look) -> Shape:
    """A USB stick: plain, with a swivelling metal cover or with a printed label."""
    x, y, h = look.between(0.038, 0.046), look.between(0.015, 0.019), look.between(0.007, 0.009)
    color = look.color("black", "red", "blue", "silver", "white", "green", "orange", "purple")
    steel = surfaces.plain((198, 200, 206))
    body = block(x, y, h, 0.003, 0.001)
    plug = box(0.0125, 0.012, 0.0045).move(x=-x / 2 - 0.006, z=0.5 * h - 0.00225)
    dots = box(0.002, 0.007, 0.0003).move(x=-x / 2 - 0.007, z=0.5 * h + 0.0021)
    skin = look.surface(color, look.pick(["plastic", "metal"]))
    pieces = [(body, skin), (plug, steel), (dots, surfaces.plain(USB_STICK_DARK))]
    parts = [box_part(x, y, h), hull_of(plug)]
    kind = look.pick(["plain", "swivel", "label"])
    if kind == "swivel":
        bow = [block(0.8 * x, y + 0.0004, 0.0012, 0.003).move(x=0.12 * x, z=z)
               for z in (-0.0004, h - 0.0006)]  # fmt: skip
        pin = cylinder(0.0032, h + 0.0014, 14).move(x=0.36 * x)
        pieces += [(join(bow), steel), (pin, surfaces.plain((150, 152, 158)))]
    elif kind == "label":
        sign = prints.canvas(64, 32, tint_color(color, 1.4))
        prints.write(sign, look.pick(["16 GB", "32GB", "64GB", "USB"]), 0.5, 0.5, 0.5, (30, 30, 34))
        pieces.append((box(0.6 * x, 0.7 * y, 0.0003).move(z=h - 0.0001), sign))
    return shape(pieces, parts)


@category("webcam", size=(0.0764, 0.0475, 0.0827), mass=0.13, material="device",
          aliases=("web camera", "web cam", "usb camera", "pc camera", "gimbal camera"),
          themes=("office", "gaming"), roles=("tall",), colors=("black",))  # fmt: skip
def webcam(look: Look) -> Shape:
    """A webcam on a small stand or clip with its lens towards the viewer."""
    color = look.color("black", "black", "charcoal", "white", "silver")
    shell = surfaces.speckles(look.rng, color, 3, 32)
    h = look.between(0.055, 0.075)
    if look.chance(0.5):
        body = facing(cylinder(0.024, 0.03, 28, bevel=0.004)).move(y=0.012, z=h)
        wide = 0.024
    else:
        wide = look.between(0.04, 0.05)
        body = facing(block(2 * wide, 0.03, 0.026, 0.0149, 0.003)).move(y=0.01, z=h)
    rim = facing(torus(0.0115, 0.0018, 26, 8)).move(y=-0.0175, z=h)
    lens = facing(lathe([(0, 0), (0.011, 0), (0.011, 0.002), (0.008, 0.003), (0, 0.0034)], 24))
    lens = lens.move(y=-0.015, z=h)
    glass = prints.canvas(48, 48, (22, 24, 30))
    prints.disc(glass, 0.5, 0.5, 0.3, (44, 56, 84))
    prints.disc(glass, 0.4, 0.38, 0.08, (150, 170, 200))
    lamp = facing(cylinder(0.0016, 0.001, 8)).move(x=min(0.018, 0.7 * wide), y=-0.0178, z=h)
    neck = cylinder(0.006, h - 0.02, 14).move(z=0.008)
    foot = block(0.05, 0.045, 0.01, 0.012, 0.003)
    flap = block(0.046, 0.01, 0.03, 0.004, 0.002).move(y=0.02, z=0.002)
    return shape([(body, shell), (join([rim]), surfaces.plain(tint_color(color, 0.7))),
                  (lens, glass), (lamp, surfaces.plain((90, 220, 120))),
                  (join([neck, foot, flap]), surfaces.speckles(look.rng, USB_STICK_DARK, 4))],
                 [hull_of(foot), hull_of(flap), cylinder_part(0.006, h - 0.02, (0, 0, 0.008)),
                  hull_of(body)])  # fmt: skip


@category("trackpad", size=(0.141, 0.116, 0.012), mass=0.2, material="device",
          aliases=("touchpad", "magic trackpad", "touch pad"), themes=("office",), roles=("flat",),
          colors=("white", "silver"), state="lying flat")  # fmt: skip
def trackpad(look: Look) -> Shape:
    """A flat glass touchpad on a slanted metal wedge, sometimes with two keys."""
    x, y = look.between(0.13, 0.16), look.between(0.11, 0.12)
    color = look.color("white", "silver", "gray", "charcoal", "black")
    low, high = 0.0045, look.between(0.009, 0.013)
    wedge = block(x, y, high, 0.01).bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] * (low + (high - low)
                                                        * (p[:, 1] / y + 0.5)) / high])
    )  # fmt: skip
    keys = look.chance(0.45)
    image = prints.canvas(128, 96, color)
    if keys:
        prints.fill(image, 0, 0.8, 1, 0.012, tint_color(color, 0.6))
        prints.fill(image, 0.494, 0.8, 0.012, 0.2, tint_color(color, 0.6))
    prints.fill(image, 0, 0.0, 1, 0.01, tint_color(color, 0.8))
    lean = np.arctan2(high - low, y)
    pad = block(x - 0.004, y - 0.004, 0.0008, 0.009).turn(0, lean).move(z=(low + high) / 2 - 0.0003)
    return shape([(wedge, surfaces.brushed_metal(look.rng, tint_color(color, 0.85))), (pad, image)],
                 [hull_of(wedge)])  # fmt: skip


@category("mini_pc", size=(0.103, 0.144, 0.0999), mass=1.2, material="device",
          aliases=("mini computer", "server", "desktop computer", "pc", "computer tower",
          "pc tower", "mini server", "computer case", "set top box", "tv box", "nas",
          "blu-ray player", "dvd player", "set-top box", "network switch", "dvd drive", "nas box",
          "desktop pc", "vcr"), themes=("office", "gaming"), roles=("big",),
          colors=("black", "silver"))  # fmt: skip
def mini_pc(look: Look) -> Shape:
    """A small desktop computer: a flat or upright square case with sockets and a power button."""
    s = look.between(0.115, 0.15)
    h = look.pick([look.between(0.036, 0.052), look.between(0.19, 0.24)])
    color = look.color("black", "silver", "charcoal", "white", "gray")
    shell = look.surface(color, look.pick(["metal", "plastic"]))
    tower = h > 0.1
    x, y = (0.42 * s, 1.2 * s) if tower else (s, s)
    body = block(x, y, h, 0.02 if not tower else 0.006, 0.003)
    face = prints.canvas(
        96, 32 if not tower else 160, tint_color(color, 0.7 if sum(color) > 250 else 1.3)
    )
    if tower:
        prints.disc(face, 0.5, 0.1, 0.04, (90, 200, 250))
        for k in range(8):
            prints.fill(face, 0.2, 0.5 + 0.05 * k, 0.6, 0.02, USB_STICK_DARK)
        for k in (0, 1):
            prints.fill(face, 0.36, 0.22 + 0.08 * k, 0.28, 0.04, (30, 60, 120))
    else:
        prints.disc(face, 0.12, 0.5, 0.2, (90, 200, 250))
        for k in range(2):
            prints.fill(face, 0.32 + 0.18 * k, 0.34, 0.13, 0.32, (30, 60, 120))
        prints.fill(face, 0.7, 0.38, 0.08, 0.24, USB_STICK_DARK)
        prints.disc(face, 0.88, 0.5, 0.13, USB_STICK_DARK)
    front = box(0.9 * x, 0.002, 0.8 * h).move(y=-y / 2 - 0.0006, z=0.1 * h)
    pieces = [(body, shell), (front, face)]
    if not tower:
        mark = cylinder(0.16 * s, 0.0004, 24).move(z=h - 0.0001)
        pieces.append((mark, surfaces.plain(tint_color(color, 1.3 if sum(color) < 400 else 0.8))))
    return shape(pieces, [box_part(x, y, h)])


@category("wrist_rest", size=(0.4, 0.078, 0.02), mass=0.18, material="rubber", friction=0.8,
          aliases=("wrist pad", "palm rest", "keyboard rest", "wrist support"), themes=("office",),
          roles=("flat",), colors=("black", "gray"), state="lying flat")  # fmt: skip
def wrist_rest(look: Look) -> Shape:
    """A soft wrist rest with a rounded top."""
    x, y, h = look.between(0.36, 0.44), look.between(0.07, 0.085), look.between(0.018, 0.022)
    bar = block(x, y, h, 0.45 * y, 0.4 * h, 8)
    base = block(x * 0.985, y * 0.94, 0.004, 0.42 * y)
    color = look.color("black", "charcoal", "navy", "gray", "purple", "brown")
    return shape([(bar, look.surface(color, "fabric")), (base, surfaces.plain((40, 40, 44)))],
                 [box_part(x, 0.8 * y, h)])  # fmt: skip


HARD_DRIVE_DARK = (40, 42, 46)


@category("hard_drive", size=(0.11, 0.16, 0.017), mass=0.2, material="device",
          aliases=("external hard drive", "hard disk", "external drive", "ssd", "portable drive",
          "hdd", "server blade"), themes=("office", "gaming"), roles=("flat",),
          colors=("black", "silver"), state="lying flat", common=True)  # fmt: skip
def hard_drive(look: Look) -> Shape:
    """A portable hard drive with its short cable, lying flat."""
    x, y, h = look.between(0.075, 0.085), look.between(0.11, 0.125), look.between(0.012, 0.02)
    color = look.color("black", "silver", "red", "blue", "charcoal", "orange")
    face = prints.canvas(96, 144, color)
    style = int(look.rng.integers(3))
    if style == 0:
        for k in range(6):
            prints.fill(face, 0, 0.1 + 0.14 * k, 1, 0.03, tint_color(color, 0.75))
    elif style == 1:
        prints.fill(face, 0.58, 0, 0.42, 1, tint_color(color, 0.7))
    prints.write(face, look.pick(["1 TB", "2 TB", "SSD", "4 TB"]), 0.5, 0.2, 0.14,
                 readable_on(color), bold=True)  # fmt: skip
    prints.disc(face, 0.86, 0.93, 0.02, (110, 190, 250))
    body = block(x, y, h, 0.008, 0.003)
    top = block(0.94 * x, 0.95 * y, 0.0008, 0.006).move(z=h - 0.0002)
    z = 0.5 * h
    cable = smooth(
        [(0, y / 2, z), (0, y / 2 + 0.018, z), (0.02, y / 2 + 0.042, 0.004),
         (0.058, y / 2 + 0.03, 0.0026), (0.066, y / 2 - 0.02, 0.0026),
         (0.062, y / 2 - 0.062, 0.0032)], 4,
    )  # fmt: skip
    plugs = [box(0.014, 0.022, 0.007).move(0, y / 2 + 0.01, max(z - 0.0035, 0)),
             box(0.014, 0.026, 0.007).move(0.062, y / 2 - 0.07, 0)]  # fmt: skip
    tip = box(0.012, 0.014, 0.0045).move(0.062, y / 2 - 0.088, 0.001)
    return shape(
        [(body, surfaces.speckles(look.rng, color, 3, 32)), (top, face),
         (join([tube(cable, 0.0024, 6), *plugs]), surfaces.plain(HARD_DRIVE_DARK)),
         (tip, surfaces.plain((186, 188, 192)))],
        [box_part(x, y, h), hull_of(*plugs[1:], tip)],
    )  # fmt: skip


@category("docking_station", size=(0.196, 0.0795, 0.0278), mass=0.35, material="device",
          aliases=("dock", "laptop dock", "usb dock", "usb c dock", "port replicator"),
          themes=("office",), colors=("black", "silver"))  # fmt: skip
def docking_station(look: Look) -> Shape:
    """A docking station: a low wedge with rows of sockets."""
    k = look.between(0.9, 1.06)
    x, y, h = 0.2 * k, 0.08 * k, 0.028 * k
    color = look.color("black", "silver", "charcoal", "gray", "white")
    image = prints.canvas(176, 28, tint_color(color, 0.85))
    for n, (u, wide, tall) in enumerate(((0.08, 0.08, 0.3), (0.2, 0.08, 0.3), (0.32, 0.05, 0.22),
                                         (0.42, 0.05, 0.22), (0.54, 0.09, 0.34), (0.67, 0.09, 0.34),
                                         (0.8, 0.08, 0.5))):  # fmt: skip
        prints.fill(image, u, 0.5 - tall / 2, wide, tall, (20, 20, 24))
        if n < 2:
            prints.fill(image, u + 0.01, 0.48, wide - 0.02, 0.1, (60, 110, 210))
    prints.disc(image, 0.93, 0.5, 0.16, (20, 20, 24))
    front = box(0.97 * x, 0.0012, 0.9 * h).move(y=-y / 2, z=0.05 * h)
    lamp = cylinder(0.0022, 0.001, 10).move(0.44 * x, -0.35 * y, h - 0.0003)
    line = box(0.9 * x, 0.001, 0.0006).move(y=-0.25 * y, z=h - 0.0003)
    return shape([(block(x, y, h, 0.006, 0.003), look.surface(color, "metal")), (front, image),
                  (lamp, surfaces.plain((90, 220, 255))), (line, surfaces.plain(
                      tint_color(color, 0.6)))], [box_part(x, y, h)])  # fmt: skip


@category("mousepad", size=(0.235, 0.195, 0.0038), mass=0.11, material="rubber",
          aliases=("mouse pad", "mouse mat", "desk mat", "desk pad"), themes=("office", "gaming"),
          roles=("flat", "support", "big"), colors=("black", "blue"), state="lying flat",
          common=True)  # fmt: skip
def mousepad(look: Look) -> Shape:
    """A plain or printed mouse pad with an edge in another colour."""
    x, y = look.between(0.2, 0.27), look.between(0.17, 0.22)
    color = look.color("black", "charcoal", "blue", "red", "teal", "pink", "purple")
    other = look.own_color("red", "cyan", "lime", "violet", "orange", "white")
    art = [surfaces.fabric(look.rng, color), prints.landscape(look.rng, 192, 160),
           surfaces.gradient(color, other, look.rng),
           surfaces.marble(look.rng, tint_color(color, 1.3),
                           other)][int(look.rng.integers(4))]  # fmt: skip
    pad = block(x, y, 0.0032, 0.012)
    top = block(x - 0.006, y - 0.006, 0.0008, 0.01).move(z=0.003)
    edge = surfaces.plain(other if look.chance(0.5) else tint_color(color, 0.6))
    return shape([(pad, edge), (top, art)], [box_part(x, y, 0.0035)])
