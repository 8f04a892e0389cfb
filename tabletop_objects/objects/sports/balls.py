"""Objects of the ``sports`` theme: balls."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse
from ...kit.parts import flat_foot, hull_of, resting_ball, ring_parts
from ...kit.primitives import at_box, pad, press_flat
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import Solid, box, cylinder, ellipsoid, join, lathe, tube
from ...kit.surfaces import RGB, Look, Tile, plain, tint_color


def seam(radius: float, wave: float) -> Solid:
    """Return the seam of a tennis ball or baseball as a thin tube on a sphere."""
    t = np.linspace(0, 2 * np.pi, 49)[:-1]
    lift = wave * np.sin(2 * t)
    path = radius * np.column_stack(
        [np.cos(t) * np.cos(lift), np.sin(t) * np.cos(lift), np.sin(lift)]
    )
    return tube(path, 0.035 * radius, 5, loop=True).turn(0, 0.7)


def football_skin(color: RGB, ink: RGB = (30, 32, 36)) -> Tile:
    """Return a football's texture: pentagons in ``ink``, and thin seams on ``color``."""
    golden = (1 + 5**0.5) / 2
    corners = np.array([p for a in (-1, 1) for b in (-golden, golden)
                        for p in ((0, a, b), (a, b, 0), (b, 0, a))], float)  # fmt: skip
    corners /= np.linalg.norm(corners, axis=1, keepdims=True)
    v, u = np.mgrid[0:96, 0:192]
    lat, lon = np.pi * (0.5 - (v + 0.5) / 96), 2 * np.pi * u / 192
    ways = np.stack([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)], -1)
    near = np.sort(ways @ corners.T, axis=-1)
    image = np.broadcast_to(np.array(color), (96, 192, 3)).copy()
    image[(near[..., -1] - near[..., -2]) < 0.025] = tint_color(color, 0.6)
    image[near[..., -1] > np.cos(0.36)] = ink
    return image.round().astype(np.uint8)


@category("shuttlecock", size=(0.067, 0.067, 0.0875), mass=0.005, material="plastic",
          assembled=True, aliases=("badminton birdie", "badminton shuttlecock", "birdie",
          "badminton ball", "shuttle"), themes=("sports",), roles=("round",),
          colors=("white",))  # fmt: skip
def shuttlecock(look: Look) -> Shape:
    """A shuttlecock standing on the rim of its feathers with its cork up."""
    k = look.between(0.95, 1.08)
    color = look.color("white", "white", "white", "yellow")
    image = prints.canvas(160, 64, color)
    for n in range(16):
        prints.stroke(image, [(n / 16, 0), (n / 16, 1)], 0.03, tint_color(color, 0.72))
    prints.fill(image, 0, 0.3, 1, 0.04, tint_color(color, 0.6))
    prints.fill(image, 0, 0.6, 1, 0.04, tint_color(color, 0.6))
    skirt = lathe(np.array([(0.0315, 0), (0.033, 0), (0.0125, 0.062), (0.011, 0.062)]) * k, 16,
                  v=[0, 0.02, 0.98, 1], loop=True)  # fmt: skip
    cork = lathe(np.array([(0, 0.06), (0.0125, 0.06), (0.0135, 0.068), (0.0125, 0.078),
                           (0.008, 0.0845), (0, 0.0865)]) * k, 22)  # fmt: skip
    band = cylinder(0.0139 * k, 0.004 * k, 22).move(z=0.062 * k)
    return shape([(skirt, image), (cork, surfaces.speckles(look.rng, (238, 230, 210), 5, 32)),
                  (band, surfaces.plain(look.own_color("red", "green", "blue")))],
                 [*ring_parts([(0.0325 * k, 0), (0.0123 * k, 0.062 * k)],
                              [(0.011 * k, 0.062 * k), (0.031 * k, 0)], 8),
                                  hull_of(cork)])  # fmt: skip


@category("ping_pong_ball", size=(0.04, 0.04, 0.04), mass=0.0027, material="plastic", hollow=True,
          aliases=("table tennis ball", "pingpong ball", "ping-pong ball"), themes=("sports",),
          roles=("round",), colors=("white", "orange"))  # fmt: skip
def ping_pong_ball(look: Look) -> Shape:
    """A smooth table tennis ball."""
    d = look.between(0.039, 0.041)
    color = look.color("white", "orange", "white", "yellow")
    skin = surfaces.fit(surfaces.speckles(look.rng, color, 2, 32), 64, 64).copy()
    prints.fill(skin, 0, 0.49, 1, 0.02, tint_color(color, 0.93))
    return shape([(ellipsoid(d, d, d, 28, 18).move(z=d / 2), skin)], [resting_ball(d, d, d)])


BRIGHT = ("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")


@category("beanbag", size=(0.0997, 0.0997, 0.0351), mass=0.12, material="fabric",
          aliases=("bean bag", "hacky sack", "juggling beanbag", "juggling bag", "cornhole bag",
          "sandbag", "small sandbag"), themes=("sports", "toys"),
          colors=("red", "blue"))  # fmt: skip
def beanbag(look: Look) -> Shape:
    """A small, plump, square beanbag for throwing."""
    color = look.color(*BRIGHT)
    k = look.between(0.8, 1.2)
    body = pad(0.1, 0.1, 0.034, 0.022, soft=0.95)
    seam = [at_box(0.098, 0.0015, 0.002, (0, 0, 0.0332)), at_box(0.0015, 0.098, 0.002,
                                                                 (0, 0, 0.0332))]  # fmt: skip
    quarter = at_box(0.03, 0.03, 0.001, (0.02, 0.02, 0.0333))
    return put_down([(body, surfaces.fabric(look.rng, color)),
                     (join(seam), plain(tint_color(color, 0.6))),
                     (quarter, plain(look.own_color("white", "yellow", "teal")))], body,
                    factor=k)  # fmt: skip


def _sphere_print(look: Look, d: float, image: surfaces.Tile) -> Shape:
    return shape([(ellipsoid(d, d, d, 32, 20).move(z=d / 2), image)], [resting_ball(d, d, d)])


@category("volleyball", size=(0.17, 0.17, 0.17), mass=0.2, material="leather", hollow=True,
          aliases=("beach volleyball", "mini volleyball"), themes=("sports",),
          roles=("round", "big"))  # fmt: skip
def volleyball(look: Look) -> Shape:
    """A mini volleyball with panels in two or three colours."""
    d = look.between(0.14, 0.2)
    tones = [look.color("white", "yellow", "cream"), look.own_color("blue", "navy", "red"),
             look.own_color("yellow", "white", "green")]  # fmt: skip
    image = prints.canvas(192, 96, tones[0])
    for n in range(6):
        x = n / 6
        for m in range(3):
            if n % 2:
                prints.fill(image, x + m / 18, 0.18, 1 / 18, 0.64, tones[(m + n // 2) % 3])
            else:
                prints.fill(image, x, 0.18 + 0.213 * m, 1 / 6, 0.213, tones[(m + n // 2) % 3])
        prints.fill(image, x, 0, 0.008, 1, (90, 90, 90))
    for y in (0.18, 0.393, 0.606, 0.82):
        for n in range(0, 6, 2):
            prints.fill(image, n / 6, y, 1 / 6, 0.012, (90, 90, 90))
    prints.fill(image, 0, 0, 1, 0.18, tones[0])
    prints.fill(image, 0, 0.82, 1, 0.18, tones[1])
    return _sphere_print(look, d, image)


@category("cricket_ball", size=(0.0715, 0.0715, 0.0715), mass=0.16, material="leather",
          aliases=("leather ball", "shot put", "cannonball"), themes=("sports",), roles=("round",),
          colors=("crimson",))  # fmt: skip
def cricket_ball(look: Look) -> Shape:
    """A leather cricket ball with a stitched seam."""
    d = look.between(0.07, 0.073)
    color = look.color("crimson", "maroon", "red", "white", "pink")
    image = surfaces.fit(surfaces.speckles(look.rng, color, 5, 64), 128, 128).copy()
    thread = (236, 228, 210) if sum(color) < 560 else (40, 110, 70)
    for y in (0.455, 0.48, 0.52, 0.545):
        for n in range(48):
            prints.fill(image, n / 48, y - 0.006, 0.012, 0.012, thread)
    prints.fill(image, 0, 0.496, 1, 0.008, tint_color(color, 0.6))
    body = ellipsoid(d, d, d, 32, 20).turn(1, 0.6).move(z=d / 2)
    return shape([(body, image)], [resting_ball(d, d, d)])


@category("bowling_ball", size=(0.115, 0.115, 0.115), mass=1.2, material="plastic",
          aliases=("mini bowling ball",), themes=("sports",), roles=("round",),
          colors=("navy", "black"))  # fmt: skip
def bowling_ball(look: Look) -> Shape:
    """A small marbled bowling ball with three finger holes."""
    d = look.between(0.1, 0.13)
    color = look.color("navy", "black", "crimson", "purple", "teal", "green")
    skin = surfaces.marble(look.rng, color, tint_color(color, 1.5))
    holes = []
    for n, (a, b) in enumerate(((0.0, 0.2), (-0.28, -0.15), (0.28, -0.15))):
        hole = cylinder((0.0095 if n else 0.011) * d / 0.12, 0.004, 16).move(z=d / 2 - 0.0034)
        holes.append(hole.turn(1, a).turn(0, b + 0.5).move(z=d / 2))
    return shape([(ellipsoid(d, d, d, 32, 20).move(z=d / 2), skin),
                  (join(holes), surfaces.plain((14, 14, 16)))],
                      [resting_ball(d, d, d)])  # fmt: skip


@category("rugby_ball", size=(0.2, 0.135, 0.135), mass=0.24, material="leather",
          aliases=("rugby", "mini rugby ball"), themes=("sports",), roles=("big",),
          colors=("white",))  # fmt: skip
def rugby_ball(look: Look) -> Shape:
    """A rugby ball with coloured panels at its ends, lying flat."""
    k = look.between(0.62, 0.8)
    color = look.color("white", "white", "cream", "orange")
    other = look.own_color("red", "blue", "green", "navy", "black")
    image = prints.canvas(128, 128, color)
    for n in range(4):
        prints.polygon(image, [(n / 4, 0), (n / 4 + 0.25, 0), (n / 4 + 0.125, 0.38)], other)
        prints.polygon(image, [(n / 4, 1), (n / 4 + 0.25, 1), (n / 4 + 0.125, 0.62)], other)
        prints.fill(image, n / 4, 0, 0.012, 1, tint_color(color, 0.6))
    prints.fill(image, 0, 0.49, 1, 0.02, other)
    a = np.linspace(-np.pi / 2, np.pi / 2, 21)
    profile = np.column_stack([0.095 * np.cos(a) ** 0.85, 0.14 * np.sin(a)]) * k
    profile[[0, -1], 0] = 0
    body = lathe(profile, 28).turn(1, np.pi / 2).move(z=0.095 * k)
    return shape([(body, image)], [flat_foot(body.vertices, 0.06)])


def _ball(d: float, cover: surfaces.Tile, seams: list[Solid], ink: RGB, *, fine: int = 28) -> Shape:
    """Return a ball of diameter ``d`` with raised or printed seams and a small flat spot."""
    core = ellipsoid(d, d, d, fine, 18)
    pieces = [(press_flat(core, 0.488 * d), cover)]
    if seams:
        pieces.append((press_flat(join(seams), 0.488 * d), surfaces.plain(ink)))
    return shape(pieces, [resting_ball(d, d, 0.985 * d)])


@category("tennis_ball", size=(0.066, 0.066, 0.065), mass=0.058, material="fabric", hollow=True,
          aliases=("racquetball", "padel ball", "squash ball"), themes=("sports",),
          roles=("round",), colors=("lime",))  # fmt: skip
def tennis_ball(look: Look) -> Shape:
    """A yellow-green felt ball with a white seam."""
    d, color = look.between(0.064, 0.068), look.color("lime", "lime", "yellow", "lime", spread=16)
    cover = surfaces.scratches(look.rng, color, tint_color(color, 1.3), int(look.between(120, 320)))
    turn = look.between(-1, 1)
    return _ball(d, cover, [seam(0.495 * d, 0.75).turn(0, turn).turn(2, 2 * turn)],
                 (240, 240, 236))  # fmt: skip


@category("baseball", size=(0.074, 0.074, 0.073), mass=0.145, material="leather",
          aliases=("softball",), themes=("sports",), roles=("round",),
          colors=("white",))  # fmt: skip
def baseball(look: Look) -> Shape:
    """A white leather ball with red stitches along its seam."""
    d, color = look.between(0.071, 0.076), look.color("white", "white", "cream", "ivory", spread=14)
    cover = surfaces.speckles(look.rng, color, 6)
    turn = look.between(-1, 1)
    line = seam(0.495 * d, 0.75)
    stitches = []
    path = line.vertices
    for k in range(0, len(path), max(len(path) // 46, 1)):
        at = path[k] * 0.5 * d / np.linalg.norm(path[k])
        stitches.append(ellipsoid(0.0045, 0.002, 0.0026, 6, 4).turn(2, k).move(*at))
    both = join([line, *stitches]).turn(0, turn).turn(2, 2 * turn)
    return _ball(d, cover, [both], look.own_color("red", "crimson", "red", spread=20))


@category("basketball", size=(0.152, 0.15, 0.149), mass=0.35, material="rubber", hollow=True,
          assembled=True, aliases=("mini basketball", "basket ball"), themes=("sports",),
          roles=("round", "big"), colors=("orange",))  # fmt: skip
def basketball(look: Look) -> Shape:
    """An orange pebbled ball with black seams, miniature or full size."""
    d = look.pick([look.between(0.1, 0.15), look.between(0.2, 0.24)])
    color = look.color("orange", "orange", "copper", "terracotta", spread=16)
    cover = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.2)
    circle = np.column_stack([0.496 * d * ellipse(2, 2, 40), np.zeros(40)])
    ring = tube(circle, 0.011 * d, 5, loop=True)
    bows = [ring.turn(0, np.pi / 2), ring.turn(1, np.pi / 2)]
    lines = join([ring, *bows, seam(0.496 * d, 0.6)])
    turn = look.between(-0.6, 0.6)
    return _ball(d, cover, [lines.turn(0, 0.5 + turn).turn(2, turn)], (40, 34, 32))


@category("soccer_ball", size=(0.16, 0.16, 0.158), mass=0.28, material="rubber", hollow=True,
          assembled=True, aliases=("football", "mini soccer ball", "soccerball", "foot ball"),
          themes=("sports",), roles=("round", "big"), colors=("white",))  # fmt: skip
def soccer_ball(look: Look) -> Shape:
    """A football of dark pentagons and pale hexagons, miniature or full size."""
    d = look.pick([look.between(0.09, 0.14), look.between(0.19, 0.22)])
    color = look.color("white", "white", "white", "white", "yellow", "sky", spread=14)
    ink = look.pick([(30, 32, 36), (30, 32, 36), (30, 60, 140), (180, 30, 40)])
    return _ball(d, football_skin(color, ink), [], (0, 0, 0), fine=32)


@category("golf_ball", size=(0.0427, 0.0427, 0.0422), mass=0.046, material="plastic",
          aliases=("golfball",), themes=("sports",), roles=("round",),
          colors=("white",))  # fmt: skip
def golf_ball(look: Look) -> Shape:
    """A dimpled golf ball, white or coloured, with a mark on it."""
    d = 0.0427
    color = look.color("white", "white", "white", "yellow", "orange", "pink", "lime", spread=12)
    image = prints.canvas(192, 96, color)
    v, u = np.mgrid[0:96, 0:192]
    rows = 9
    lat = np.floor(v / 96 * rows)
    around = np.round(22 * np.sin(np.pi * (lat + 0.5) / rows)).clip(3)
    x = (u / 192 * around + 0.5 * (lat % 2)) % 1 - 0.5
    y = (v / 96 * rows) % 1 - 0.5
    dots = np.hypot(x, y) < 0.3
    image[dots] = np.array(tint_color(color, 0.86)).astype(np.uint8)
    part = image[36:60, 80:112]
    word = look.pick(["1", "2", "3", "PRO", "GOLF", "4"])
    prints.write(
        part, word, 0.5, 0.5, 0.6, look.own_color("red", "blue", "black", "green"), bold=True
    )
    return _ball(d, image, [], (0, 0, 0))


@category("american_football", size=(0.197, 0.121, 0.124), mass=0.28, material="leather",
          hollow=True, assembled=True, aliases=("nfl football", "nfl ball"), themes=("sports",),
          roles=("big",), colors=("brown",), state="lying down")  # fmt: skip
def american_football(look: Look) -> Shape:
    """A pointed leather ball with white stripes and laces, lying flat."""
    k = look.pick([look.between(0.55, 0.7), look.between(0.9, 1.0)])
    color = look.color("brown", "brown", "bronze", "maroon", "terracotta")
    t = np.linspace(-1, 1, 19)
    wide = 0.086 * k * np.sqrt(np.clip(1 - np.abs(t) ** 1.7, 0, 1))
    body = lathe(np.column_stack([wide, 0.14 * k * t]), 26)
    leather = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.2)
    band = surfaces.plain((238, 236, 230))
    striped = look.chance(0.6)
    tile = surfaces.stack((leather, 17), (band if striped else leather, 5), (leather, 56),
                            (band if striped else leather, 5), (leather, 17), side=128)  # fmt: skip
    body = body.turn(1, np.pi / 2).move(z=0.086 * k)
    lace = [box(0.07 * k, 0.006 * k, 0.004).move(z=0.171 * k)]
    lace += [box(0.004 * k, 0.03 * k, 0.004).move(x=(n - 3) * 0.0105 * k, z=0.1715 * k)
             for n in range(7)]  # fmt: skip
    tilt = look.between(0.1, 0.5)
    core = body.move(z=-0.086 * k).turn(0, tilt).move(z=0.085 * k)
    laces = join(lace).move(z=-0.086 * k).turn(0, tilt).move(z=0.085 * k)
    return shape([(core.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])), tile),
                  (laces, surfaces.plain((240, 238, 232)))],
                 [flat_foot(core.vertices, 0.06)])  # fmt: skip
