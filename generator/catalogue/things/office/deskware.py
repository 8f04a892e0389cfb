"""What else lies on desks and by the door: mouse pad, keys, wallet, envelope, folder, map."""

from __future__ import annotations

import itertools

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import facing, lobe, side_view
from ...build.outlines import arc, rectangle
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..tools.tools import steel


def mousepad(look: Look) -> Shape:
    """A mouse pad: plain, printed or edged."""
    x, y = look.between(0.2, 0.27), look.between(0.17, 0.22)
    color = look.color("black", "charcoal", "blue", "red", "teal", "pink", "purple")
    other = look.own_color("red", "cyan", "lime", "violet", "orange", "white")
    art = [
        textures.fabric(look.rng, color),
        prints.landscape(look.rng, 192, 160),
        textures.gradient(color, other, look.rng),
        textures.marble(look.rng, tint_color(color, 1.3), other),
    ][int(look.rng.integers(4))]
    pad = block(x, y, 0.0032, 0.012)
    top = block(x - 0.006, y - 0.006, 0.0008, 0.01).move(z=0.003)
    edge = textures.plain(other if look.chance(0.5) else tint_color(color, 0.6))
    return shape([(pad, edge), (top, art)], [box_part(x, y, 0.0035)])


def keys(look: Look) -> Shape:
    """A ring of keys with a tag."""
    tones = ((196, 198, 202), (206, 172, 92), (176, 148, 110))
    metals = [textures.brushed_metal(look.rng, tone) for tone in tones]
    ring = torus(0.014, 0.0013, 28, 6).move(z=0.0035)
    pieces = [(ring, metals[0])]
    parts = [cylinder_part(0.0148, 0.0035, (0, 0, 0.0004))]
    count = int(look.rng.integers(2, 5))
    for k in range(count):
        angle = -np.pi / 2 + (k - count / 2) * 0.55 + look.between(-0.1, 0.1)
        bow = lobe(cylinder(0.0115, 0.0022, 24), int(look.pick([3, 4, 8])), 0.25)
        long = look.between(0.028, 0.036)
        teeth = [(0.009 + long * u, -0.0025 - 0.0016 * (n % 2)) for n, u in
                 enumerate(np.linspace(0.35, 0.96, 8))]  # fmt: skip
        shank = prism([(0.006, -0.0028), *teeth, (0.009 + long, 0.002), (0.006, 0.0032)], 0, 0.002)
        z = 0.0002 + 0.0019 * k
        key = join([bow, shank]).move(x=0.022).turn(2, angle).move(z=z)
        pieces.append((key, metals[int(look.rng.integers(3))]))
        parts.append(hull_of(key))
    color = look.color("red", "blue", "brown", "green", "black", "yellow", "pink")
    kind, turn = int(look.rng.integers(3)), np.pi / 2 + look.between(-0.4, 0.4)
    tag = [block(0.046, 0.024, 0.004, 0.007, 0.001), cylinder(0.017, 0.004, 26, bevel=0.001),
           lobe(cylinder(0.018, 0.006, 40, bevel=0.001), 5, 0.5)][kind]  # fmt: skip
    tag = tag.move(x=0.04).turn(2, turn).move(z=0.0003)
    loop = tube([(0.012, 0, 0.0042), (0.018, 0, 0.005), (0.026, 0, 0.003)], 0.0014, 6)
    loop = loop.turn(2, turn)
    pieces += [(tag, textures.speckles(look.rng, color, 8)), (loop, metals[0])]
    return shape(pieces, [*parts, hull_of(tag)])


def wallet(look: Look) -> Shape:
    """A folded leather wallet, cards or notes showing at its edge."""
    x, y, h = look.between(0.1, 0.118), look.between(0.082, 0.095), look.between(0.016, 0.024)
    color = look.color("brown", "black", "tan", "navy", "maroon", "red", "olive")
    leather = textures.spots(look.rng, color, tint_color(color, 0.78), 0.2)
    stitched = leather.copy()
    thread = np.array(tint_color(color, 1.4), np.uint8)
    for at in (5, 122):
        stitched[at, ::3], stitched[::3, at] = thread, thread
    bow = arc((-x / 2 + 0.5 * h, 0.5 * h), 0.5 * h, np.pi / 2, 1.5 * np.pi, 6)
    spine = side_view([*bow, (-x / 2 + h, 0), (-x / 2 + h, h)], y)
    flaps = [block(x, y, 0.36 * h, 0.005, 0.002).move(z=z) for z in (0, 0.64 * h)]
    inner = box(0.93 * x, 0.94 * y, 0.3 * h).move(x=0.01 * x, z=0.35 * h)
    paper = textures.stripes([tint_color(color, 0.5), (188, 200, 160), (226, 226, 220)], 3)
    pieces = [(join([*flaps[:1], spine]), leather), (flaps[1], stitched), (inner, paper)]
    if look.chance(0.5):
        card = block(0.085, 0.05, 0.0012, 0.003).move(0.02, -0.45 * y, 0.5 * h)
        ink = look.own_color("blue", "gold", "teal", "red")
        pieces.append((card, textures.stripes([ink, tint_color(ink, 1.3)], 2)))
    return shape(pieces, [box_part(x, y, h)])


def tape_dispenser(look: Look) -> Shape:
    """A desk dispenser with a roll of sticky tape."""
    k = look.between(0.92, 1.12)
    color = look.color("black", "teal", "red", "white", "blue", "gray", "pink")
    shell = textures.speckles(look.rng, color, 4)
    side = [(-0.075, 0), (0.066, 0), (0.072, 0.018), (0.066, 0.05), (0.052, 0.052), (0.03, 0.026),
            (-0.004, 0.02), (-0.03, 0.03), (-0.056, 0.05), (-0.07, 0.042)]  # fmt: skip
    outline = np.array(side) * k
    walls = [side_view(outline, 0.012 * k).move(y=s * 0.018 * k) for s in (-1, 1)]
    low = np.array([(-0.072, 0), (0.064, 0), (0.064, 0.014), (-0.072, 0.016)])
    base = side_view(low * k, 0.04 * k)
    nose = side_view(np.array([(0.048, 0.012), (0.068, 0.012), (0.064, 0.046), (0.05, 0.044)]) * k,
                     0.03 * k)  # fmt: skip
    roll = lathe([(0.016 * k, -0.0095 * k), (0.034 * k, -0.0095 * k), (0.034 * k, 0.0095 * k),
                  (0.016 * k, 0.0095 * k)], 30, loop=True)  # fmt: skip
    core = cylinder(0.0165 * k, 0.022 * k, 22, bevel=0.001).move(z=-0.011 * k)
    at = (-0.022 * k, 0, 0.05 * k)
    strip = box(0.07 * k, 0.019 * k, 0.0006).turn(1, 0.42).move(0.034 * k, 0, 0.062 * k)
    blade = box(0.002, 0.024 * k, 0.008 * k).move(0.069 * k, 0, 0.044 * k)
    film = textures.stripes([(222, 208, 168), (206, 190, 148)], 20)
    hub = textures.plain(look.own_color("white", "charcoal", "red"))
    return shape(
        [(join([*walls, base, nose]), shell), (facing(roll).move(*at), film),
         (facing(core).move(*at), hub), (strip, textures.plain((216, 204, 170))),
         (blade, steel(look))],
        [hull_of(base), hull_of(nose), hull_of(facing(roll).move(*at)),
         box_part(0.04 * k, 0.04 * k, 0.03 * k, (-0.05 * k, 0, 0.012 * k))],
    )  # fmt: skip


def envelope(look: Look) -> Shape:
    """An envelope, its face with stamp and address or its flap up."""
    x, y = look.between(0.16, 0.225), look.between(0.11, 0.125)
    color = look.color("white", "cream", "tan", "sky", "pink", "sage")
    image = prints.canvas(224, 128, color)
    if look.chance(0.5):
        prints.lines(image, look.rng, (0.42, 0.5, 0.4, 0.3), 4, (60, 62, 80), 0.3)
        prints.lines(image, look.rng, (0.05, 0.08, 0.22, 0.16), 3, (90, 92, 100), 0.3)
        stamp = prints.landscape(look.rng, 30, 36)
        prints.fill(image, 0.83, 0.07, 0.145, 0.3, (250, 250, 246))
        image[11:47, 188:218] = stamp
        prints.disc(image, 0.76, 0.24, 0.13, tint_color(color, 0.6), 0.115)
    else:
        u, v = np.linspace(-1, 1, 224)[None], np.linspace(0, 1, 128)[:, None]
        edge = np.abs(v - 0.62 * (1 - np.abs(u))) < 0.012
        image[edge] = np.array(tint_color(color, 0.7), np.uint8)
        image[(v < 0.62 * (1 - np.abs(u))).astype(bool)] = np.array(
            tint_color(color, 0.9), np.uint8
        )
        if look.chance(0.6):
            wax = look.own_color("red", "crimson", "navy", "gold")
            prints.disc(image, 0.5, 0.58, 0.1, wax)
            prints.disc(image, 0.5, 0.58, 0.06, tint_color(wax, 0.8))
    if look.chance(0.3):
        for k in range(18):
            ink = ((190, 50, 50), (50, 80, 160), (245, 245, 240))[k % 3]
            for v in (0, 0.95):
                prints.fill(image, k / 18, v, 1 / 18, 0.05, ink)
    body = box(x, y, 0.003)
    return shape([(body, image)], [box_part(x, y, 0.003)])


def clipboard(look: Look) -> Shape:
    """A clipboard holding sheets under its steel clip."""
    x, y = look.between(0.215, 0.235), look.between(0.3, 0.325)
    color = look.color("brown", "wooden", "black", "blue", "pink", "teal")
    word = "oak" if color[0] > color[2] + 40 else "plastic"
    board = block(x, y, 0.004, 0.014)
    sheet = prints.sheet(look.rng, picture=look.chance(0.3))
    if look.chance(0.5):
        sheet = prints.canvas(128, 176, (248, 247, 242))
        for k in range(9):
            prints.fill(sheet, 0.12, 0.18 + 0.085 * k, 0.06, 0.045, (70, 72, 80))
            prints.fill(sheet, 0.135, 0.189 + 0.085 * k, 0.03, 0.026, (248, 247, 242))
            long = look.between(0.3, 0.62)
            prints.fill(sheet, 0.24, 0.194 + 0.085 * k, long, 0.014, (120, 122, 130))
    paper = box(0.21, 0.285, 0.002).move(y=-0.006, z=0.0039)
    plate = block(0.12, 0.03, 0.009, 0.006, 0.002).move(y=y / 2 - 0.02, z=0.004)
    lip = block(0.1, 0.012, 0.012, 0.004, 0.002).move(y=y / 2 - 0.035, z=0.0035)
    bow = tube([(-0.02, y / 2 - 0.01, 0.012), (-0.016, y / 2 + 0.008, 0.014),
                (0.016, y / 2 + 0.008, 0.014), (0.02, y / 2 - 0.01, 0.012)], 0.003, 8)  # fmt: skip
    return shape(
        [(board, look.surface(color, word)), (paper, sheet),
         (join([plate, lip, bow]), steel(look))],
        [box_part(x, y, 0.0058), hull_of(plate), hull_of(lip)],
    )  # fmt: skip


def binder(look: Look) -> Shape:
    """A ring binder standing upright, its labelled spine to the viewer."""
    x, y, z = look.between(0.05, 0.08), look.between(0.26, 0.29), look.between(0.3, 0.32)
    color = look.color("blue", "black", "red", "green", "gray", "yellow", "white")
    spine = prints.canvas(48, 200, color)
    prints.fill(spine, 0.14, 0.14, 0.72, 0.4, (246, 245, 240))
    prints.lines(spine, look.rng, (0.24, 0.2, 0.52, 0.2), 4, (70, 72, 90))
    year = str(look.rng.integers(2015, 2027))
    prints.write(spine[82:104, 8:40], year, 0.5, 0.5, 0.6, (60, 60, 70))
    prints.disc(spine, 0.5, 0.84, 0.055, (176, 180, 186))
    prints.disc(spine, 0.5, 0.84, 0.036, tint_color(color, 0.4))
    cover = textures.speckles(look.rng, color, 5)
    sides = [box(0.0035, y, z).move(x=s * (x / 2 - 0.00175)) for s in (-1, 1)]
    back = box(x, 0.004, z).move(y=-y / 2 + 0.002)
    front = box(0.96 * x, 0.001, 0.98 * z).move(y=-y / 2 - 0.0004, z=0.01 * z)
    leaves = box(x * look.between(0.5, 0.9), 0.86 * y, 0.94 * z).move(y=-0.05 * y, z=0.004)
    return shape(
        [(join([*sides, back]), cover), (front, spine),
         (leaves, np.rot90(prints.pages(look.rng)).copy())],
        [box_part(x, y, z)],
    )  # fmt: skip


def folded_map(look: Look) -> Shape:
    """A map, unfolded, its creases standing up a little."""
    x, y = look.between(0.3, 0.42), look.between(0.22, 0.3)
    land = look.color("cream", "sage", "beige", "mint", "tan")
    relief = textures.noise(look.rng, 160, 224, (4, 5), 4)[..., None]
    image = np.where(relief > -0.05, np.array(land) + 12 * relief, (126, 178, 214))
    image = np.where(relief > 0.42, (134, 172, 112), image)
    image = np.where(np.abs(relief + 0.05) < 0.018, (90, 120, 140), image)
    image = np.clip(image, 0, 255).astype(np.uint8)
    for ink in ((206, 70, 54), (226, 150, 50), (120, 116, 120)):
        v = 80 + 60 * textures.noise(look.rng, 2, 224, (1, 4), 2)[0]
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
        pieces += [(leaf, textures.plain((244, 241, 232))), (top, strip)]
        parts.append(hull_part(np.concatenate([near, far])))
    return shape(pieces, parts)


def _sheet(a: np.ndarray, b: np.ndarray, c: np.ndarray, d: np.ndarray) -> Solid:
    """Return a sheet 0.2 mm thick over four corners, the picture upright from edge a-b."""
    low = np.stack([a, b, c, d])
    faces = [(4, 5, 6), (4, 6, 7), (0, 2, 1), (0, 3, 2), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5),
             (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]  # fmt: skip
    uv = np.tile([(0.0, 0.0), (1, 0), (1, 1), (0, 1)], (2, 1))
    return Solid(np.concatenate([low, low + np.array([0, 0, 2e-4])]), np.array(faces), uv)


CATEGORIES = (
    Category("mousepad", mousepad, (0.235, 0.195, 0.0038), 0.11,
             ("mouse pad", "mouse mat", "desk mat", "desk pad"), ("office", "gaming"),
             ("flat", "support", "big"), ("black", "blue"), state="lying flat"),
    Category("keys", keys, (0.07, 0.12, 0.0065), 0.06,
             ("key", "key ring", "keyring",
             "bunch of keys", "key chain", "keychain", "set of keys", "car key", "house key",
             "chatelaine", "iron key"), ("living", "office"), ("flat",), ("red",
             "blue"),
             state="lying flat"),
    Category("wallet", wallet, (0.109, 0.09, 0.02), 0.12,
             ("billfold", "leather wallet"), ("living", "office"), ("flat",),
             ("brown", "black"), state="lying flat"),
    Category("tape_dispenser", tape_dispenser, (0.15, 0.05, 0.085), 0.4,
             ("sticky tape dispenser", "scotch tape dispenser", "adhesive tape dispenser",
             "tape gun"),
             ("office", "craft"), (), ("black", "teal")),
    Category("envelope", envelope, (0.193, 0.117, 0.003), 0.02,
             ("mail",), ("office",), ("flat",),
             ("white", "cream"), state="lying flat"),
    Category("clipboard", clipboard, (0.225, 0.32, 0.0165), 0.28, ("clip board", "checklist"),
             ("office", "medical"), ("flat", "big"), ("brown",), state="lying flat"),
    Category("binder", binder, (0.065, 0.275, 0.31), 0.7,
             ("ring binder", "lever arch file",
             "box file", "file divider"), ("office",),
             ("tall",), ("blue", "black")),
    Category("folded_map", folded_map, (0.36, 0.26, 0.011), 0.05,
             ("folded road map", "folded paper map", "folded city map", "pocket map",
             "knitting pattern", "sewing pattern"),
             ("living", "toys"),
             ("flat", "big"), ("cream",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
