"""Sport, pets, games and things to look at: balls, dumbbell, bowl, chess, hourglass, trophy."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, resting_ball, ring_parts
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile
from ..food.food import press_flat
from ..tools.tools import lying


def seam(radius: float, wave: float) -> Solid:
    """Return the seam of a tennis ball or baseball as a thin tube on a sphere."""
    t = np.linspace(0, 2 * np.pi, 49)[:-1]
    lift = wave * np.sin(2 * t)
    path = radius * np.column_stack(
        [np.cos(t) * np.cos(lift), np.sin(t) * np.cos(lift), np.sin(lift)]
    )
    return tube(path, 0.035 * radius, 5, loop=True).turn(0, 0.7)


def ball(look: Look) -> Shape:
    """A ball for tennis, baseball or play, a basketball, or a football."""
    kind = int(look.rng.integers(5))
    seams: list[Solid] = []
    ink = (240, 240, 236)
    if kind == 0:
        d, color = look.between(0.064, 0.068), look.color("lime", "lime", "yellow")
        cover = textures.scratches(look.rng, color, tint_color(color, 1.3), 220)
        seams = [seam(0.495 * d, 0.75)]
    elif kind == 1:
        d, color = look.between(0.072, 0.076), look.color("white", "cream", "ivory")
        cover, ink = textures.speckles(look.rng, color, 6), (190, 40, 44)
        seams = [seam(0.495 * d, 0.75)]
    elif kind == 2:
        d, color = look.between(0.09, 0.14), look.color("orange", "copper", "terracotta")
        cover, ink = textures.spots(look.rng, color, tint_color(color, 0.7), 0.2), (40, 34, 32)
        circle = np.column_stack([0.496 * d * ellipse(2, 2, 40), np.zeros(40)])
        ring = tube(circle, 0.014 * d, 5, loop=True)
        seams = [ring, ring.turn(0, np.pi / 2), ring.turn(1, np.pi / 2), seam(0.496 * d, 0.6)]
    elif kind == 3:
        d, color = look.between(0.08, 0.14), look.color("white", "white", "yellow", "sky")
        cover = football_skin(color)
    else:
        d, color = look.between(0.06, 0.12), look.color("red", "blue", "green", "purple", "pink")
        other = look.own_color("white", "yellow", "cyan", "orange")
        cover = textures.stripes([color, other], int(look.pick([2, 3, 5])), upright=True)
    core = ellipsoid(d, d, d, 26, 16)
    pieces: list[tuple[Solid, Tile]] = [(press_flat(core, 0.488 * d), cover)]
    if seams:
        pieces.append((press_flat(join(seams), 0.488 * d), textures.plain(ink)))
    return shape(pieces, [resting_ball(d, d, 0.985 * d)])


def football_skin(color: RGB, ink: RGB = (30, 32, 36)) -> Tile:
    """A ball's skin of pentagons of ``ink`` among pale faces, thin seams between."""
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


def dumbbell(look: Look) -> Shape:
    """A dumbbell with six-sided or round heads."""
    length, r = look.between(0.18, 0.26), look.between(0.038, 0.055)
    color = look.color("black", "charcoal", "pink", "teal", "purple", "blue", "red")
    head = look.between(0.055, 0.075)
    hexed = look.chance(0.6)
    end = cylinder(r, head, 6 if hexed else 28, bevel=0.006)
    low = float(lying(end).vertices[:, 2].min())
    heads = [lying(end, s, -low) for s in (-length / 2, length / 2 - head)]
    grip = lying(lathe([(0, 0), (0.013, 0), (0.0165, 0.5 * (length - head)), (0.013, length - head),
                        (0, length - head)], 16), -(length - head) / 2, -low)  # fmt: skip
    face = prints.canvas(64, 64, color)
    weight = look.pick(["2", "3", "5", "8"])
    prints.write(face, weight, 0.5, 0.5, 0.5, readable_on(color), bold=True)
    disc = box(0.8 * r, 0.8 * r, 0.001)
    plates = [disc.turn(1, s * np.pi / 2).turn(0, np.pi / 2 * s)
              .move(s * length / 2, 0, -low) for s in (-1, 1)]  # fmt: skip
    steel = textures.grid((120, 122, 126), (186, 188, 192), 24, 24, 96)
    rubber = textures.spots(look.rng, color, tint_color(color, 0.75), 0.15)
    return shape(
        [(join(heads), rubber), (grip, steel), (join(plates), face)],
        [*(hull_of(h) for h in heads), box_part(length - head, 0.024, 0.024, (0, 0, -low - 0.012))],
    )


def pet_bowl(look: Look) -> Shape:
    """A pet's bowl, empty or with kibble, a bone or paw print on its side."""
    r, h = look.between(0.075, 0.1), look.between(0.045, 0.06)
    color = look.color("red", "blue", "teal", "silver", "pink", "orange", "green")
    wall = 0.3 * r
    body = lathe(
        [(0, 0), (r, 0), (0.82 * r, h), (0.76 * r, h), (r - 1.3 * wall, 0.22 * h),
         (0, 0.2 * h)], 36,
        v=[0, 0.01, 0.8, 0.84, 0.95, 1],
    )  # fmt: skip
    print_ = prints.canvas(320, 96, color)
    ink = readable_on(color)
    for u in (0.5, 0.0, 0.25, 0.75, 0.999):
        v = 0.58
        prints.disc(print_, u, v + 0.05, 0.1, ink)
        for du, dv in ((-0.045, -0.06), (-0.016, -0.13), (0.016, -0.13), (0.045, -0.06)):
            prints.disc(print_, u + du, v + dv, 0.045, ink)
    pieces = [(body, print_)]
    if look.chance(0.6):
        brown = look.own_color("brown", "copper", "tan")
        food = [
            ellipsoid(0.017, 0.013, 0.011, 8, 5)
            .turn(2, look.between(0, 3))
            .move(a * np.cos(t), a * np.sin(t), 0.34 * h + look.between(0, 0.25) * h)
            for a, t in look.rng.uniform((0.0, 0), (0.52 * r, 6.3), (38, 2))
        ]
        bed = cylinder(0.6 * r, 0.2 * h, 24).move(z=0.18 * h)
        pieces.append((join([bed, *food]), textures.spots(look.rng, brown, tint_color(brown, 0.6))))
    ring = ring_parts(
        [(r, 0), (0.82 * r, h)], [(0.76 * r, h), (0.61 * r, 0.22 * h), (0.6 * r, 0)], 10
    )
    return shape(pieces, [cylinder_part(0.62 * r, 0.2 * h), *ring])


def chess_board(look: Look) -> Shape:
    """A chess board set up with simple men on its first and last ranks."""
    side, h = look.between(0.28, 0.38), look.between(0.012, 0.022)
    dark, light = (
        look.color("brown", "black", "maroon", "green"),
        look.own_color("cream", "beige", "tan"),
    )
    image = prints.canvas(192, 192, tint_color(dark, 0.7))
    for i in range(8):
        for j in range(8):
            ink = dark if (i + j) % 2 else light
            prints.fill(image, 0.06 + 0.11 * i, 0.06 + 0.11 * j, 0.11, 0.11, ink)
    board = block(side, side, h, 0.004, 0.002)
    top = box(0.985 * side, 0.985 * side, 0.001).move(z=h - 0.0004)
    cell = 0.11 * side
    pieces = [(board, textures.wood(look.rng, tint_color(dark, 0.8))), (top, image)]
    parts = [box_part(side, side, h)]
    tall = 0.85 * cell
    if look.chance(0.75):
        pawn = lathe(
            [(0, 0), (0.3 * cell, 0), (0.3 * cell, 0.12 * tall), (0.12 * cell, 0.35 * tall),
             (0.12 * cell, 0.6 * tall), (0.21 * cell, 0.78 * tall), (0, tall)], 7,
        )  # fmt: skip
        king = lathe(
            [(0, 0), (0.34 * cell, 0), (0.15 * cell, 0.5 * tall), (0.15 * cell, 1.2 * tall),
             (0.24 * cell, 1.45 * tall), (0, 1.65 * tall)], 7,
        )  # fmt: skip
        for s, ink in ((-1, tint_color(light, 1.3)), (1, tint_color(dark, 0.55))):
            men = [m.move((k - 3.5) * cell, s * row * cell, h) for k in range(8)
                   for row, m in ((3.5, king), (2.5, pawn)) if look.chance(0.9)]  # fmt: skip
            pieces.append((join(men), textures.plain(ink)))
            parts.append(box_part(7.3 * cell, 1.4 * cell, 0.95 * tall, (0, s * 3.0 * cell, h)))
    return shape(pieces, parts)


def cap(look: Look) -> Shape:
    """A baseball cap, its visor towards the viewer."""
    r, h = look.between(0.085, 0.095), look.between(0.105, 0.125)
    color = look.color("navy", "red", "black", "tan", "green", "white", "pink")
    cloth = textures.fabric(look.rng, color)
    a = np.linspace(0, np.pi / 2, 9)
    bow = np.column_stack([r * np.cos(a) ** 0.75, h * np.sin(a)])[:-1]
    crown = lathe([(0, 0), *bow, (0, h)], 32).scale(1, 1.12, 1)
    t = np.linspace(-1, 1, 15)
    front = np.column_stack([0.86 * r * t, -1.0 * r - 0.075 * (1 - t**4) ** 0.8 + 0.4 * r * t**2])
    inner = np.column_stack([0.86 * r * t, -0.95 * r * np.sqrt(1 - (0.82 * t) ** 2)])[::-1]
    visor = prism(np.concatenate([front, inner[1:-1]]), 0, 0.0035)
    visor = visor.bend(lambda p: p + np.column_stack(
        [np.zeros((len(p), 2)), 0.014 * (1 - (p[:, 0] / (0.86 * r)) ** 2)]))  # fmt: skip
    button = ellipsoid(0.013, 0.013, 0.008, 12, 6).move(z=h)
    seams = [tube(np.column_stack([1.005 * r * np.cos(a) ** 0.75 * np.cos(w),
                                   1.125 * r * np.cos(a) ** 0.75 * np.sin(w),
                                   1.005 * h * np.sin(a)])[:-1], 0.001, 4)
             for w in np.pi * np.arange(6) / 3 + np.pi / 2]  # fmt: skip
    badge = look.own_color("white", "yellow", "red", "navy")
    patch = prints.canvas(64, 48, badge)
    letter = look.pick(["A", "NY", "LA", "7", "K"])
    prints.write(patch, letter, 0.5, 0.5, 0.62, readable_on(badge), bold=True)
    front_patch = box(0.05, 0.004, 0.036).turn(0, -0.3).move(y=-1.115 * r, z=0.36 * h)
    peak = look.own_color("navy", "red", "black", "tan") if look.chance(0.4) else color
    return shape(
        [(crown, cloth), (visor, textures.fabric(look.rng, peak)),
         (join([button, *seams]), textures.plain(tint_color(color, 0.8))), (front_patch, patch)],
        [hull_of(crown), hull_of(visor)],
    )  # fmt: skip


CATEGORIES = (
    Category("cap", cap, (0.18, 0.275, 0.12), 0.09,
             ("baseball cap", "ball cap", "baseball hat", "green visor", "visor", "beret",
             "peaked cap", "shower cap", "swimming cap"),
             ("living",), ("big",),
             ("navy", "red")),
    Category("ball", ball, (0.09, 0.09, 0.088), 0.09,
             ("toy ball", "rubber ball", "bouncy ball", "sphero ball", "eight ball",
             "bath toy ball", "bowls jack", "petanque jack", "boilie"), ("toys", "sports",
             "pets"), ("round",),
             ("red", "blue"), 0.8),
    Category("dumbbell", dumbbell, (0.22, 0.085, 0.087), 3.0,
             ("hand weight", "weight", "barbell", "free weight"), ("sports",), (),
             ("black", "pink"), state="lying flat"),
    Category("pet_bowl", pet_bowl, (0.175, 0.175, 0.053), 0.35,
             ("dog bowl", "cat bowl", "dog dish", "pet dish", "food bowl", "dog food", "cat food"),
             ("pets",), ("round", "container", "big"), ("red", "blue")),
    Category("chess_board", chess_board, (0.33, 0.33, 0.06), 1.2,
             ("chess", "chess set", "chess game"), ("games",), ("big",), ("brown", "black")),
)  # fmt: skip
"""The module's categories."""
