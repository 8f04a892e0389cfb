"""Objects of the ``living`` theme: paper goods."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from types import MappingProxyType

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile, leather
from ...kit.outlines import rectangle
from ...kit.parts import above, box_part, flat_foot, hull_part
from ...kit.primitives import at_box, ball, drum, rod, spread
from ...kit.prints import Canvas, landscape
from ...kit.shapes import Category, Shape, category, put_down, shape
from ...kit.solids import Solid, block, box, cylinder, join, loft, prism, torus
from ...kit.surfaces import RGB, Look, Tile, readable_on, tint_color
from .signs import sheet_of, sign


@category("wrapping_paper", size=(0.3, 0.06, 0.046), mass=0.12, material="paper",
          aliases=("gift wrap", "roll of wrapping paper", "wrapping paper roll", "gift paper",
          "roll of gift wrap", "gift wrap roll"), themes=("living",), colors=("red", "gold"),
          state="lying")  # fmt: skip
def wrapping_paper(look: Look) -> Shape:
    """A roll of wrapping paper lying flat, with its loose end on the table."""
    long, r = look.between(0.26, 0.34), look.between(0.02, 0.026)
    color = look.color("red", "green", "blue", "gold", "pink", "teal", "white")
    paper = surfaces.fit(glaze_tile(look, color), 128, 128)
    roll = cylinder(r, long, 26).move(z=-long / 2).turn(1, np.pi / 2).move(z=0.985 * r)
    hole = cylinder(0.6 * r, long + 0.001, 20).move(z=-long / 2 - 0.0005).turn(1, np.pi / 2)
    end = box(long, 1.6 * r, 0.0015).move(0, -0.8 * r, 0)
    return shape(
        [(join([roll, end]), paper), (hole.move(z=0.985 * r), surfaces.plain((190, 160, 120)))],
        [flat_foot(above(roll.vertices), 0.06), box_part(long, 1.6 * r, 0.0015, (0, -0.8 * r, 0))],
    )


@category("gift_tag", size=(0.1, 0.042, 0.0035), mass=0.003, material="paper", aliases=("name tag",
          "label tag", "present tag", "paper tag", "do not disturb sign", "museum label"),
          themes=("living",), roles=("flat",), colors=("tan",), state="lying flat")  # fmt: skip
def gift_tag(look: Look) -> Shape:
    """A gift tag with a hole and a string, lying flat."""
    color = look.color("tan", "red", "white", "green", "gold", "pink")
    outline = [(-0.036, -0.008), (-0.024, -0.02), (0.036, -0.02), (0.036, 0.02), (-0.024, 0.02),
               (-0.036, 0.008)]  # fmt: skip
    card = prism(outline, 0, 0.0018)
    image = prints.canvas(96, 56, color)
    ink = readable_on(color)
    prints.write(image, look.pick(["FOR YOU", "TO:", "WITH LOVE"]), 0.55, 0.4, 0.26, ink)
    prints.fill(image, 0.3, 0.68, 0.5, 0.04, ink)
    face = box(0.056, 0.036, 0.0004).move(0.006, 0, 0.0017)
    eye = torus(0.0035, 0.0012, 14, 6).move(-0.027, 0, 0.0016)
    string = rod([(-0.027, 0, 0.002), (-0.045, 0.008, 0.0018), (-0.06, -0.004, 0.0012),
                  (-0.044, -0.01, 0.0014), (-0.028, -0.001, 0.0022)], 0.0008, 5)  # fmt: skip
    return put_down([(card, surfaces.plain(color)), (face, image),
                     (eye, surfaces.plain((206, 172, 96))),
                     (string, surfaces.plain((226, 200, 150)))], card, string,
                    factor=look.between(0.9, 1.25))  # fmt: skip


WIDE, TALL = 336, 232
"""Pixels of a map's print."""


@category("map", size=(0.49, 0.35, 0.0065), mass=0.06, material="paper", assembled=True,
          aliases=("road map", "paper map", "city map", "treasure map", "unfolded map", "open map",
          "world map", "street map", "tourist map", "trail map", "hiking map", "metro map",
          "subway map", "spread map"), themes=("living", "toys"), roles=("flat", "big"),
          colors=("cream",), state="lying flat", common=True)  # fmt: skip
def map_(look: Look) -> Shape:
    """A large unfolded map with panels that rise and fall at the creases."""
    x, y = look.between(0.42, 0.56), look.between(0.3, 0.4)
    columns, rows = int(look.pick([4, 6, 8])), int(look.pick([2, 3, 4]))
    lift = look.between(0.002, 0.006)
    land = look.color("cream", "beige", "sage", "mint", "white", "tan", "ivory")
    image = prints.canvas(WIDE, TALL, land)
    DRAWN[look.pick(sorted(DRAWN))](image, look, land)
    _trim(image, look, land)
    _crease(image, columns, rows)
    u = np.linspace(-x / 2, x / 2, columns + 1)
    v = np.linspace(-y / 2, y / 2, rows + 1)
    ridge = np.arange(columns + 1)[None] % 2 + 0.6 * (np.arange(rows + 1)[:, None] % 2)
    height = lift * ridge * look.rng.uniform(0.7, 1, ridge.shape)
    grid = np.stack([*np.meshgrid(u, v), height], -1)
    sheet = spread(grid, 4e-4)
    strips = []
    for k in range(columns):
        low = grid[:, k : k + 2].reshape(-1, 3)
        strips.append(hull_part(np.concatenate([low, low + np.array([0, 0, 4e-4])])))
    return shape([(sheet, image)], strips)


def _trim(image: Canvas, look: Look, land: RGB) -> None:
    """Add a margin, a title and a legend to a map."""
    ink = look.own_color("crimson", "navy", "green", "charcoal", "orange")
    margin = tint_color(land, 1.6)
    for edge in ((0, 0, 1, 0.025), (0, 0.975, 1, 0.025), (0, 0, 0.018, 1), (0.982, 0, 0.018, 1)):
        prints.fill(image, *edge, margin)
    x, y = look.pick([(0.03, 0.04), (0.72, 0.04), (0.03, 0.7), (0.72, 0.7)])
    prints.fill(image, x, y, 0.25, 0.26, margin)
    prints.fill(image, x, y, 0.25, 0.09, ink)
    panel = image[int(y * TALL) : int((y + 0.09) * TALL), int(x * WIDE) : int((x + 0.25) * WIDE)]
    prints.write(panel, look.pick(["ROADS", "CITY", "ISLES", "ALPS", "PARK"]), 0.5, 0.5, 0.62,
                 (248, 246, 240))  # fmt: skip
    for k, color in enumerate(((200, 70, 60), (226, 170, 70), (90, 140, 200))):
        prints.fill(image, x + 0.02, y + 0.12 + 0.045 * k, 0.04, 0.022, color)
        prints.fill(image, x + 0.08, y + 0.126 + 0.045 * k, 0.12, 0.01, (110, 110, 112))


def _crease(image: Canvas, columns: int, rows: int) -> None:
    """Draw the creases of a folded map: pale lines with a shadow along one side."""
    for k in range(1, columns):
        at = k * WIDE // columns
        image[:, at] = image[:, at] * 0.35 + 0.65 * 252
        image[:, at + 1 : at + 3] = image[:, at + 1 : at + 3] * 0.84
    for k in range(1, rows):
        at = k * TALL // rows
        image[at] = image[at] * 0.35 + 0.65 * 252
        image[at + 1 : at + 3] = image[at + 1 : at + 3] * 0.84


def _wander(look: Look, across: bool, rough: float = 0.16) -> list[tuple[float, float]]:
    """Return the points of a line that winds from one edge of a map to the opposite edge."""
    t = np.linspace(0, 1, 60)
    away = look.between(0.2, 0.8) + rough * surfaces.noise(look.rng, 2, 60, (1, 4), 3)[0]
    pair = (t, away) if across else (away, t)
    return list(zip(*pair, strict=True))


def _city(image: Canvas, look: Look, land: RGB) -> None:
    """Draw a city map with blocks and streets, a river and parks."""
    angle = look.between(-0.5, 0.5)
    c, s = np.cos(angle), np.sin(angle)
    for _ in range(4):
        u, v, r = look.between(0.05, 0.95), look.between(0.05, 0.95), look.between(0.05, 0.11)
        spots = [(u + r * np.cos(a), v + 1.3 * r * np.sin(a)) for a in np.arange(6) + angle]
        prints.polygon(image, spots, (164, 204, 144))
    prints.stroke(image, _wander(look, look.chance(0.5)), 0.06, (140, 186, 222))
    for k in np.linspace(-1, 1, 30):
        for way, side in (((c, s), (-s, c)), ((-s, c), (c, s))):
            at = 0.5 + k * np.array(side)
            ends = [(at[0] - way[0], at[1] - way[1]), (at[0] + way[0], at[1] + way[1])]
            prints.stroke(image, ends, 0.006, tint_color(land, 0.8))
    for color, wide in (((236, 160, 70), 0.028), ((246, 214, 100), 0.018), ((236, 160, 70), 0.02)):
        line = _wander(look, look.chance(0.5), 0.08)
        prints.stroke(image, line, wide + 0.01, (150, 120, 80))
        prints.stroke(image, line, wide, color)


def _relief(image: Canvas, look: Look, land: RGB) -> None:
    """Draw a relief map with hills, contour lines, lakes and a trail."""
    height = surfaces.noise(look.rng, TALL, WIDE, (3, 4), 3)
    green = np.array(look.pick([(150, 186, 120), (190, 200, 140), (214, 178, 126)]), float)
    mix = np.clip(0.5 + height, 0, 1)[..., None]
    image[:] = np.clip(green * (1 - mix) + np.array(land) * mix, 0, 255)
    image[(height * 9) % 1 < 0.16] = np.array(tint_color((170, 120, 80), 0.9), np.uint8)
    image[height < -0.42] = (130, 178, 216)
    for ink in ((200, 60, 50), (90, 90, 96)):
        prints.stroke(image, _wander(look, True), 0.012, ink)


def _roads(image: Canvas, look: Look, land: RGB) -> None:
    """Draw a road map of a country between seas, with forests, towns and three kinds of roads."""
    ground = surfaces.noise(look.rng, TALL, WIDE, (3, 4), 4)
    image[ground > 0.3] = (182, 210, 150)
    sea = ground < -0.28
    image[sea] = (146, 192, 224)
    image[sea & (ground > -0.31)] = (84, 130, 170)
    inks = ((206, 60, 50), (206, 60, 50), (240, 180, 60), (240, 180, 60), (240, 240, 236))
    for k, ink in enumerate(inks):
        line = _wander(look, k % 2 == 0)
        prints.stroke(image, line, 0.022, (100, 90, 84))
        prints.stroke(image, line, 0.013, ink)
    for _ in range(16):
        prints.disc(image, look.between(0, 1), look.between(0, 1), 0.014, (50, 48, 52))


def _world(image: Canvas, look: Look, land: RGB) -> None:
    """Draw a world map with continents in many colours on a sea with meridians."""
    sea = look.pick([(120, 176, 214), (176, 208, 226), (40, 84, 130)])
    image[:] = np.array(sea, np.uint8)
    ground = surfaces.noise(look.rng, TALL, WIDE, (3, 5), 4)
    states = surfaces.noise(look.rng, TALL, WIDE, (7, 9), 2)
    colors = ((232, 196, 110), (150, 186, 120), (220, 140, 110), (190, 160, 200), land)
    rank = np.digitize(states, [-0.35, -0.12, 0.1, 0.35])
    for k, color in enumerate(colors):
        image[(ground > 0.08) & (rank == k)] = np.array(color, np.uint8)
    for k in range(1, 12):
        prints.fill(image, k / 12, 0, 0.004, 1, tint_color(sea, 0.8))
        if k % 2:
            prints.fill(image, 0, k / 12, 1, 0.005, tint_color(sea, 0.8))


def _old(image: Canvas, look: Look, land: RGB) -> None:
    """Draw an old parchment chart with an island, a compass and a dashed course to a cross."""
    stain = surfaces.noise(look.rng, TALL, WIDE, (4, 5), 4)[..., None]
    parchment = np.array(look.pick([(222, 192, 140), (206, 170, 116), (232, 210, 164)]), float)
    image[:] = np.clip(parchment + 22 * stain, 0, 255)
    v, u = np.mgrid[0:TALL, 0:WIDE] / [[[TALL]], [[WIDE]]]
    shore = np.hypot(u - 0.5, 0.9 * (v - 0.5)) + 0.14 * surfaces.noise(
        look.rng, TALL, WIDE, (4, 5), 3
    )
    image[shore < 0.36] = np.clip(parchment * (0.82, 0.9, 0.72), 0, 255)
    image[np.abs(shore - 0.36) < 0.008] = (96, 66, 40)
    image[np.abs(shore - 0.4) < 0.003] = (130, 96, 60)
    points = _wander(look, True, 0.2)[12:48]
    for k in range(0, len(points) - 2, 3):
        prints.stroke(image, points[k : k + 2], 0.014, (120, 40, 30))
    (x, y) = points[-1]
    for s in (-1, 1):
        ends = [(x - 0.028, y - s * 0.04), (x + 0.028, y + s * 0.04)]
        prints.stroke(image, ends, 0.022, (180, 30, 26))
    for a in np.arange(8) * np.pi / 4:
        long = 0.1 if round(a / (np.pi / 4)) % 2 == 0 else 0.05
        tip = (0.86 + 0.7 * long * np.cos(a), 0.5 + long * np.sin(a))
        prints.stroke(image, [(0.86, 0.5), tip], 0.01, (96, 66, 40))


def _lines(image: Canvas, look: Look, land: RGB) -> None:
    """Draw the map of an underground railway with its lines and stations."""
    image[:] = np.array(tint_color(land, 1.5), np.uint8)
    prints.stroke(image, _wander(look, True), 0.05, (180, 212, 236))
    inks = ((206, 44, 50), (40, 98, 180), (50, 150, 80), (240, 180, 40), (130, 70, 150))
    for k, ink in enumerate(inks):
        u = np.sort(look.rng.uniform(0.05, 0.95, 4))
        v = look.rng.uniform(0.08, 0.92, 2)
        line = [(0.02, v[0]), (u[1], v[0]), (u[2], v[1]), (0.98, v[1])]
        if k % 2:
            line = [(b, a) for a, b in line]
        prints.stroke(image, line, 0.026, ink)
        for a, b in itertools.pairwise(line):
            for t in (0.25, 0.6, 0.95):
                spot = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
                prints.disc(image, *spot, 0.019, (40, 40, 44))
                prints.disc(image, *spot, 0.012, (250, 250, 248))


DRAWN: MappingProxyType[str, Callable[[Canvas, Look, RGB], None]] = MappingProxyType(
    {"city": _city, "lines": _lines, "old": _old, "relief": _relief, "roads": _roads,
     "world": _world}
)  # fmt: skip
"""Kinds of maps."""


@category("scroll", size=(0.176, 0.153, 0.0259), mass=0.08, material="paper",
          aliases=("papyrus scroll", "parchment scroll", "papyrus", "paper scroll",
          "ancient scroll"), themes=("living", "office"), colors=("cream",))  # fmt: skip
def scroll(look: Look) -> Shape:
    """A half-unrolled parchment scroll with writing."""
    color = look.color("cream", "beige", "tan", "ivory")
    k, w = look.between(0.85, 1.15), look.between(0.1, 0.14)
    long = look.between(0.11, 0.17)
    sheet = at_box(long, w, 0.0016, (0, 0, 0.0005))
    image = prints.canvas(176, 128, color)
    ink = look.own_color("brown", "black", "maroon")
    prints.lines(image, look.rng, (0.1, 0.14, 0.8, 0.72), 9, ink, 0.5)
    rolls, rods, knobs = [], [], []
    for s, r in ((-1, 0.013), (1, look.between(0.009, 0.015))):
        x = s * (long / 2 + 0.4 * r)
        rolls.append(drum(r, w, (x, -w / 2, 0.96 * r), 1, sides=18))
        rods.append(drum(0.36 * r, w + 0.024, (x, -w / 2 - 0.012, 0.96 * r), 1, sides=12))
        knobs += [ball(0.8 * r, 0.8 * r, 0.8 * r, (x, t * (w / 2 + 0.013), 0.96 * r), 10)
                  for t in (-1, 1)]  # fmt: skip
    paper = surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.1, 64)
    return put_down(
        [(sheet, image), (join(rolls), paper), (join([*rods, *knobs]), surfaces.wood(look.rng,
         (120, 78, 48)))], sheet, *rolls, factor=k, foot=0.12)  # fmt: skip


@category("folded_map", size=(0.36, 0.26, 0.011), mass=0.05, material="paper", assembled=True,
          aliases=("folded road map", "folded paper map", "folded city map", "pocket map",
          "knitting pattern", "sewing pattern"), themes=("living", "toys"), roles=("flat", "big"),
          colors=("cream",), state="lying flat", common=True)  # fmt: skip
def folded_map(look: Look) -> Shape:
    """An unfolded map with slightly raised creases."""
    x, y = look.between(0.3, 0.42), look.between(0.22, 0.3)
    land = look.color("cream", "sage", "beige", "mint", "tan")
    relief = surfaces.noise(look.rng, 160, 224, (4, 5), 4)[..., None]
    image = np.where(relief > -0.05, np.array(land) + 12 * relief, (126, 178, 214))
    image = np.where(relief > 0.42, (134, 172, 112), image)
    image = np.where(np.abs(relief + 0.05) < 0.018, (90, 120, 140), image)
    image = np.clip(image, 0, 255).astype(np.uint8)
    for ink in ((206, 70, 54), (226, 150, 50), (120, 116, 120)):
        v = 80 + 60 * surfaces.noise(look.rng, 2, 224, (1, 4), 2)[0]
        columns = np.arange(224)
        for thick in range(3):
            image[np.clip(v.astype(int) + thick, 0, 159), columns] = ink
    for _ in range(5):
        u, v = look.rng.uniform(0.1, 0.9, 2)
        prints.disc(image, u, v, 0.016, (40, 40, 44))
    prints.fill(image, 0, 0, 1, 0.02, (245, 243, 236))
    prints.fill(image, 0, 0.98, 1, 0.02, (245, 243, 236))
    folds, lift = int(look.pick([4, 6])), look.between(0.006, 0.012)
    u = np.linspace(-x / 2, x / 2, folds + 1)
    v = 0.0008 + lift * (np.arange(folds + 1) % 2)
    rings = [
        np.array([(a, s * y / 2, b + dz) for s, dz in ((-1, 0), (-1, 8e-4), (1, 8e-4), (1, 0))])
        for a, b in zip(u, v, strict=True)
    ]
    pieces, parts = [], []
    for k, (near, far) in enumerate(itertools.pairwise(rings)):
        leaf = loft(np.stack([near, far])[:, ::-1], rectangle(y, 0.001))
        strip = np.ascontiguousarray(image[:, int(224 * k / folds) : int(224 * (k + 1) / folds)])
        top = _sheet(near[1], far[1], far[2], near[2])
        pieces += [(leaf, surfaces.plain((244, 241, 232))), (top, strip)]
        parts.append(hull_part(np.concatenate([near, far])))
    return shape(pieces, parts)


def _sheet(a: np.ndarray, b: np.ndarray, c: np.ndarray, d: np.ndarray) -> Solid:
    """Return a 0.2 mm thick sheet; its picture's lower edge runs from corner ``a`` to ``b``."""
    low = np.stack([a, b, c, d])
    faces = [(4, 5, 6), (4, 6, 7), (0, 2, 1), (0, 3, 2), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5),
             (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]  # fmt: skip
    uv = np.tile([(0.0, 0.0), (1, 0), (1, 1), (0, 1)], (2, 1))
    return Solid(np.concatenate([low, low + np.array([0, 0, 2e-4])]), np.array(faces), uv)


@category("photo_print", size=(0.135, 0.125, 0.0045), mass=0.006, material="paper", assembled=True,
          aliases=("polaroid", "polaroid photo", "snapshot", "instant photo", "printed photo",
          "printed photograph", "loose photo", "old photo", "old photograph", "daguerreotype",
          "tintype", "silhouette portrait", "miniature portrait", "carte de visite", "slide",
          "slide transparency"), themes=("living", "office", "craft"), roles=("flat",),
          colors=("white",), state="lying flat", common=True)  # fmt: skip
def photo_print(look: Look) -> Shape:
    """Loose, slightly curled photographs: glossy prints with a margin, or instant photographs."""
    instant = look.chance(0.4)
    x, y = (0.088, 0.107) if instant else look.pick([(0.15, 0.1), (0.1, 0.15), (0.13, 0.13)])
    frame = look.color("white", "white", "white", "cream", "black")
    count, curl = int(look.pick([1, 1, 2, 3])), look.between(0.002, 0.005)
    tone = look.pick(["color", "color", "color", "grey", "sepia"])
    pieces, parts = [], []
    u, v = np.meshgrid(np.linspace(-1, 1, 7), np.linspace(-1, 1, 5))
    for k in range(count):
        lift = 4e-4 * k + curl * (1 - 0.2 * k) * u**2
        grid = np.stack([u * x / 2, v * y / 2, lift], -1)
        turn, at = 0.55 * (k - (count - 1) / 2) + look.between(-0.12, 0.12), 0.016 * k
        leaf = spread(grid, 4e-4).turn(2, turn).move(at, 0.5 * at)
        pieces.append((leaf, _photo(look, x, y, frame, instant, tone)))
        parts.append(hull_part(leaf.vertices))
    return shape(pieces, parts)


def _photo(look: Look, x: float, y: float, frame: RGB, instant: bool, tone: str) -> Tile:
    """Return the face of a photograph: a picture with a margin."""
    width, height = round(1300 * x), round(1300 * y)
    image = prints.canvas(width, height, frame)
    margin = round(0.055 * width) if instant else look.pick([0, round(0.05 * min(width, height))])
    tall = height - (round(0.24 * height) if instant else 2 * margin)
    wide = width - 2 * margin
    maker = prints.landscape if look.chance(0.6) else prints.artwork
    picture = surfaces.fit(maker(look.rng, wide, tall), tall, wide).astype(float)
    if tone != "color":
        grey = picture.mean(-1, keepdims=True)
        picture = grey * (np.array((1.06, 0.94, 0.76)) if tone == "sepia" else np.ones(3))
    image[margin : margin + tall, margin : margin + wide] = np.clip(picture, 0, 255)
    return image


@category("magazine", size=(0.21, 0.277, 0.01), mass=0.25, material="paper",
          aliases=("fashion magazine", "comic", "comic book", "catalog", "brochure", "magazines",
          "catalogue", "programme", "manga magazine", "teacher's planner", "crossword book",
          "colouring book", "coloring book", "activity book", "football programme",
          "match programme", "theatre programme"), themes=("living", "coffee"),
          roles=("flat", "support"), colors=("red", "white"), state="lying flat")  # fmt: skip
def magazine(look: Look) -> Shape:
    """A magazine lying flat: a full-page picture with a large title and headlines beside it."""
    x, y, h = look.between(0.2, 0.22), look.between(0.265, 0.29), look.between(0.004, 0.009)
    color = look.color("red", "yellow", "white", "teal", "pink", "black", "sky", "orange")
    image = surfaces.fit(prints.artwork(look.rng, 160, 208), 208, 160).copy()
    name = look.pick(
        ["VOGA", "TIME", "STYLE", "FORBIA", "NATURE", "HOME", "TRAVEL", "FOOD", "MODE"]
    )
    if look.chance(0.4):
        prints.fill(image, 0, 0, 1, 0.2, color)
        prints.write(image, name, 0.5, 0.12, 0.15, readable_on(color), bold=True)
    else:
        prints.write(image, name, 0.5, 0.12, 0.16, color, bold=True)
    ink = color if sum(color) > 420 else (250, 250, 246)
    for k in range(3):
        left = look.chance(0.6)
        prints.lines(
            image, look.rng, (0.06 if left else 0.6, 0.32 + 0.18 * k, 0.32, 0.09), 2, ink, 0.55
        )
    prints.barcode(image, look.rng, 0.7, 0.88, 0.24)
    body = box(x, y, h - 0.0008)
    top = (
        box(x, y, 0.0012)
        .bend(
            lambda p: np.column_stack(
                [p[:, :2], p[:, 2] + 0.003 * np.clip(p[:, 0] / (0.5 * x), 0, 1) ** 2]
            )
        )
        .move(z=h - 0.001)
    )
    return shape(
        [(body, prints.pages(look.rng, (244, 242, 236))), (top, image)], [box_part(x, y, h)]
    )


@category("newspaper", size=(0.299, 0.222, 0.0108), mass=0.18, material="paper",
          aliases=("daily newspaper", "folded newspaper", "news paper", "tabloid", "daily paper"),
          themes=("living", "coffee"), roles=("flat", "support", "big"), colors=("white",),
          state="lying flat")  # fmt: skip
def newspaper(look: Look) -> Shape:
    """A folded newspaper lying flat: its title, headlines, columns and a picture."""
    x, y, h = look.between(0.28, 0.32), look.between(0.2, 0.24), look.between(0.007, 0.013)
    color = look.color("white", "cream", "ivory", "beige", "gray", "pink", spread=10)
    paper: RGB = tint_color(color, 0.97)
    image = prints.canvas(256, 176, paper)
    ink = (46, 46, 50)
    prints.write(image, look.pick(["THE DAILY NEWS", "MORNING POST", "THE TIMES", "CITY HERALD"]),
                 0.5, 0.1, 0.13, ink, True)  # fmt: skip
    prints.fill(image, 0.03, 0.19, 0.94, 0.008, ink)
    headline = look.pick(["MARKETS RISE", "ROBOTS AT WORK", "RAIN AGAIN", "TEAM WINS CUP"])
    prints.write(image, headline, 0.5, 0.28, 0.1, ink, bold=True)
    columns = look.pick([4, 5])
    at = int(look.rng.integers(columns - 1))
    for k in range(columns):
        start = 0.62 if k in (at, at + 1) else 0.38
        prints.lines(image, look.rng, (0.04 + 0.93 * k / columns, start, 0.86 / columns, 0.96
                                       - start), int(34 * (0.96 - start)), (120, 120, 124),
                     0.45)  # fmt: skip
    wide = int(1.9 * 0.93 / columns * 256)
    picture = prints.artwork(look.rng, wide, 40).astype(float)
    grey = np.repeat(picture.mean(-1, keepdims=True), 3, -1) if look.chance(0.6) else picture
    left = int((0.04 + 0.93 * at / columns) * 256)
    image[66:106, left : left + wide] = grey.astype(np.uint8)
    t = h / 3
    layers = [box(x - 0.004 * k, y, t).move(x=0.002 * k, z=k * t) for k in range(3)]
    top = box(x - 0.008, y, 0.0006).move(x=0.004, z=h)
    side = prints.pages(look.rng, paper)
    return shape([(join(layers), side), (top, image)], [box_part(x - 0.004, y, h)])


BRASS = (206, 172, 96)


@category("photo_album", size=(0.24, 0.21, 0.035), mass=0.8, material="paper", aliases=("album",
          "picture album", "scrapbook", "wedding album", "scrap book", "stamp collection",
          "stamp album", "coin album", "sticker album"), themes=("living",),
          roles=("support", "big"), colors=("brown", "red"), state="lying flat")  # fmt: skip
def photo_album(look: Look) -> Shape:
    """A photo album lying flat: a cover with a framed picture and a ribbon at its spine."""
    x, y, h = look.between(0.22, 0.26), look.between(0.19, 0.23), look.between(0.028, 0.04)
    color = look.color("brown", "red", "navy", "black", "teal", "cream", "pink")
    pages = box(x - 0.014, y - 0.012, h - 0.006).move(0.004, 0, 0.003)
    covers = [block(x, y, 0.0035, 0.004).move(z=z) for z in (0, h - 0.0035)]
    spine = box(0.005, y, h).move(-x / 2 + 0.0025)
    frame = box(0.5 * x, 0.42 * y, 0.0012).move(0.01, 0.0, h - 0.0004)
    photo = box(0.45 * x, 0.36 * y, 0.0008).move(0.01, 0.0, h + 0.0003)
    band = box(0.012, y + 0.001, h + 0.0008).move(-0.36 * x)
    hide = leather(look.rng, color)
    return put_down([(pages, prints.pages(look.rng)), (join([*covers, spine]), hide),
                     (frame, surfaces.plain(BRASS)),
                     (photo, surfaces.fit(landscape(look.rng, 96, 64), 64, 96)),
                     (band, surfaces.plain(tint_color(color, 0.65) if sum(color) > 200
                                           else BRASS))], join(covers))  # fmt: skip


@category("passport", size=(0.091, 0.13, 0.0061), mass=0.035, material="paper",
          aliases=("travel passport", "visa", "passport cover", "travel document"),
          themes=("living", "office"), roles=("flat",), colors=("maroon", "navy"),
          state="lying flat")  # fmt: skip
def passport(look: Look) -> Shape:
    """A passport lying flat with a gold coat of arms and a gold word on its cover."""
    color = look.color("maroon", "navy", "green", "crimson", "black", "teal")
    k = look.between(0.92, 1.15)
    image = prints.canvas(88, 125, color)
    gold = (222, 190, 110)
    prints.disc(image, 0.5, 0.5, 0.17, gold, 0.15)
    prints.polygon(
        image, [(0.38, 0.42), (0.62, 0.42), (0.62, 0.52), (0.5, 0.61), (0.38, 0.52)], gold
    )
    prints.write(image, "PASSPORT", 0.5, 0.16, 0.09, gold, bold=True)
    prints.fill(image, 0.44, 0.84, 0.12, 0.05, gold)
    pages = box(0.085, 0.121, 0.0044).move(z=0.0006)
    covers = [block(0.088, 0.125, 0.0008, 0.003).move(z=z) for z in (0, 0.0049)]
    face = box(0.0875, 0.1245, 0.0004).move(z=0.0055)
    return shape([(pages, prints.pages(look.rng)), (join(covers), surfaces.plain(color)),
                  (face, image)], [box_part(0.088, 0.125, 0.0059)]).scale(k)  # fmt: skip


def _slip(
    look: Look, x: float, y: float, image: surfaces.Tile, color: tuple[float, float, float]
) -> Shape:
    """Return a thin card with a picture on its face and a body in ``color``."""
    k = look.between(0.9, 1.15)
    card = box(x, y, 0.0012)
    face = box(x - 0.0006, y - 0.0006, 0.0003).move(z=0.0011)
    return shape([(card, surfaces.plain(color)), (face, image)], [box_part(x, y, 0.0014)]).scale(k)


@category("boarding_pass", size=(0.195, 0.078, 0.00145), mass=0.005, material="paper",
          aliases=("plane ticket", "flight ticket", "airline ticket", "boarding card"),
          themes=("living", "office"), roles=("flat",), colors=("blue",),
          state="lying flat")  # fmt: skip
def boarding_pass(look: Look) -> Shape:
    """A boarding pass with a coloured band, a flight route, a barcode and a stub."""
    color = look.color("blue", "red", "teal", "orange", "purple", "green")
    image = prints.canvas(200, 80, (246, 246, 244))
    prints.fill(image, 0, 0, 1, 0.24, color)
    prints.write(image[:20, 6:120], "BOARDING PASS", 0.5, 0.5, 0.62, readable_on(color), bold=True)
    prints.write(
        image[24:52, 6:60], look.pick(["LHR", "JFK", "CDG"]), 0.5, 0.5, 0.75, (40, 44, 60), True
    )
    prints.write(
        image[24:52, 84:138], look.pick(["NRT", "SFO", "FCO"]), 0.5, 0.5, 0.75, (40, 44, 60), True
    )
    prints.polygon(image, [(0.32, 0.46), (0.4, 0.48), (0.32, 0.5)], color)
    prints.fill(image, 0.3, 0.47, 0.04, 0.02, color)
    prints.lines(image, look.rng, (0.04, 0.72, 0.5, 0.2), 3, (120, 120, 126))
    prints.barcode(image, look.rng, 0.76, 0.4, 0.2)
    prints.fill(image, 0.715, 0, 0.005, 1, (150, 150, 156))
    return _slip(look, 0.19, 0.076, image, (236, 236, 234))


@category("ticket", size=(0.103, 0.045, 0.0016), mass=0.002, material="paper",
          aliases=("cinema ticket", "movie ticket", "train ticket", "concert ticket",
          "raffle ticket", "theatre ticket", "bus ticket", "betting slip", "lottery ticket"),
          themes=("living",), roles=("flat",), colors=("red", "yellow"),
          state="lying flat")  # fmt: skip
def ticket(look: Look) -> Shape:
    """An admission ticket with notched ends and a star."""
    color = look.color("red", "yellow", "blue", "green", "orange", "pink", "purple")
    image = prints.canvas(128, 60, color)
    ink = readable_on(color)
    prints.fill(image, 0.1, 0.12, 0.8, 0.05, ink)
    prints.fill(image, 0.1, 0.83, 0.8, 0.05, ink)
    prints.write(
        image[:, 20:108], look.pick(["ADMIT ONE", "TICKET", "CINEMA"]), 0.5, 0.5, 0.36, ink, True
    )
    for x in (0.1, 0.9):
        prints.disc(image, x, 0.5, 0.09, ink)
    w, h, r = 0.048, 0.021, 0.007
    a = np.linspace(np.pi / 2, -np.pi / 2, 6)
    left = np.column_stack([-w + r * np.cos(a), r * np.sin(a)])
    outline = np.concatenate([[(-w, -h), (w, -h)], -left, [(w, h), (-w, h)], left])
    card = prism(outline, 0, 0.0012)
    face = prism(outline * 0.99, 0.0011, 0.0015)
    made = shape([(card, surfaces.plain(tint_color(color, 0.9))), (face, image)],
                 [box_part(2 * w, 2 * h, 0.0015)])  # fmt: skip
    return made.scale(look.between(0.9, 1.25))


CATEGORIES = (
    Category("table_plan", sign(("TABLE PLAN|A  B  C|1 . . . 2|3 . . . 4|5 . . . 6",
             "SEATING|1 . . . 2|3 . . . 4|5 . . . 6"), 0.2, 0.27, "easel", ("white", "cream",
             "sage", "black")), size=(0.192, 0.08, 0.272), mass=0.4, material="paper",
             aliases=("seating plan", "seating chart", "wedding table plan"), themes=("living",),
             roles=("tall",), colors=("white",)),
    Category("order_of_service",
             sheet_of(("ORDER OF SERVICE", "PROGRAMME", "CEREMONY"), 0.13, 0.19, "booklet"),
             size=(0.133, 0.193, 0.008), mass=0.03, material="paper",
             aliases=("order of service booklet", "wedding programme", "wedding program",
             "ceremony programme", "hymn sheet"), themes=("living",), roles=("flat",),
             colors=("cream",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
