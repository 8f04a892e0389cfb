"""Paper and what one does with it: books, pens, small desk things, boxes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, frame_parts, hull_of
from ...build.shape import Shape, shape
from ...build.solids import block, box, open_box, torus
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

INKS = ("red", "navy", "teal", "mustard", "crimson", "green", "blue", "charcoal", "purple")


def book(look: Look) -> Shape:
    """A hardback lying flat, title up, spine to the left."""
    x, y = look.between(0.12, 0.175), look.between(0.185, 0.24)
    h, board = look.between(0.016, 0.042), look.pick([0.0008, 0.0028])
    color, accent = look.color(*INKS), look.own_color("cream", "gold", "coral", "sky", "white")
    title = look.pick(
        [
            "ATLAS",
            "POEMS",
            "GARDEN",
            "MINDS",
            "THE SEA",
            "COOKING",
            "ORBIT",
            "EMMA",
            "DESIGN",
            "1984",
        ]
    )
    front = prints.cover(look.rng, title, color, accent)
    cloth = textures.speckles(look.rng, color, 4, 32)
    top = box(x, y, board).move(z=h - board)
    back = box(x, y, board)
    spine = box(board, y, h).move(x=-(x - board) / 2)
    stack = box(x - 0.005, y - 0.007, h - 2 * board).move(x=-0.0015, z=board)
    return shape(
        [(top, front), (back, cloth), (spine, cloth), (stack, prints.pages(look.rng))],
        [box_part(x, y, h)],
    )


def notebook(look: Look) -> Shape:
    """A closed notebook: ring-bound with a plain cover, or bound with an elastic band."""
    x, y, h = look.between(0.13, 0.155), look.between(0.19, 0.215), look.between(0.012, 0.016)
    color = look.color("black", "teal", "coral", "mustard", "navy", "sage", "pink", "tan")
    band = look.own_color("red", "black", "gold", "cream")
    rings = look.chance(0.5)
    image = prints.canvas(128, 176, color)
    kind = int(look.rng.integers(4))
    if kind == 0:
        image = glaze_tile(look, color)
    elif kind == 1:
        image = prints.artwork(look.rng, 128, 176)
    image = textures.fit(image, 176, 128).copy()
    if rings:
        prints.fill(image, 0.25, 0.2, 0.5, 0.2, (246, 244, 236))
        prints.write(image, "NOTES", 0.5, 0.3, 0.08, (60, 60, 66))
    else:
        prints.fill(image, 0.86, 0, 0.05, 1, band)
    cover = block(x, y, 0.0016, 0.006).move(z=h - 0.0016)
    pieces = [
        (cover, image),
        (block(x, y, 0.0016, 0.006), textures.plain(color)),
        (box(x - 0.004, y - 0.004, h - 0.0032).move(z=0.0016), prints.pages(look.rng)),
    ]
    if rings:
        wire = torus(h / 2, 0.0011, 14, 5).turn(0, np.pi / 2)
        steel = textures.plain((150, 152, 158))
        count = 11
        pieces += [
            (wire.move(-x / 2 + 0.002, (k / (count - 1) - 0.5) * 0.88 * y, h / 2 + 0.0011), steel)
            for k in range(count)
        ]
    return shape(pieces, [box_part(x, y, h)])


def cardboard_box(look: Look) -> Shape:
    """A closed parcel with tape, or a gift box with ribbon when a colour is asked for."""
    x, y, h = look.between(0.14, 0.2), look.between(0.1, 0.15), look.between(0.08, 0.12)
    asked = look.attributes.get("color", "")
    gift = look.chance(0.34) if not asked else asked not in ("brown", "tan", "beige")
    color = look.color("red", "teal", "navy", "pink", "white", "lavender", "black", "sage")
    ribbon = look.own_color("gold", "white", "red", "green", "pink")
    board = textures.cardboard(look.rng)
    if not gift:
        label = prints.canvas(96, 64, (246, 246, 242))
        prints.lines(label, look.rng, (0.08, 0.12, 0.5, 0.5), 4, (80, 80, 84))
        prints.barcode(label, look.rng, 0.5, 0.6, 0.42)
        note = box(0.07, 0.045, 0.0006).move(x=0.1 * x, y=-0.18 * y, z=h - 0.0001)
        return shape([(box(x, y, h), board), (note, label)], [box_part(x, y, h)])
    paper, band = textures.fit(glaze_tile(look, color), 128, 128), textures.plain(ribbon)
    bow = [torus(0.016, 0.004, 16, 6).scale(1, 0.55, 1).turn(0, 0.9) for _ in range(2)]
    return shape(
        [
            (box(x, y, h), paper),
            (box(0.022, y + 0.002, h + 0.001), band),
            (box(x + 0.002, 0.022, h + 0.001), band),
            (bow[0].turn(2, 0.5).move(x=-0.016, z=h + 0.011), band),
            (bow[1].turn(2, -0.5).move(x=0.016, z=h + 0.011), band),
        ],
        [box_part(x, y, h), box_part(0.05, 0.02, 0.018, (0, 0, h))],
    )


def sticky_notes(look: Look) -> Shape:
    """A square pad of notes, the top sheet lifting at its front edge."""
    side, h = 0.076, look.between(0.012, 0.022)
    color = look.color("yellow", "pink", "lime", "sky", "orange", "lavender", "mint", spread=4)
    image = prints.canvas(96, 96, color)
    if look.chance(0.6):
        prints.lines(image, look.rng, (0.14, 0.2, 0.6, 0.5), 4, (70, 74, 110), 0.18)
    sheet = box(side, side, 0.0008).bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] + np.where(p[:, 1] < 0, 0.005, 0)])
    )
    return shape(
        [
            (box(side, side, h), textures.stripes([color, tint_color(color, 0.88)], 8, side=32)),
            (sheet.move(z=h), image),
        ],
        [box_part(side, side, h)],
    )


def paper_stack(look: Look) -> Shape:
    """A few printed sheets lying on each other, a little askew."""
    x, y, t = 0.21, 0.297, 0.0012
    pieces = []
    count = int(look.rng.integers(3, 6))
    for k in range(count):
        tile = prints.sheet(look.rng, picture=look.chance(0.4))
        turn = look.between(-0.05, 0.05) if k else 0.0
        pieces.append((box(x, y, t).turn(2, turn).move(z=k * t), tile))
    return shape(pieces, [box_part(x, y, t * count)])


def stapler(look: Look) -> Shape:
    """A desk stapler, jaws slightly open towards the left."""
    color = look.color("black", "red", "blue", "teal", "gray", "white", "pink", "yellow", "mint")
    shell, dark = textures.speckles(look.rng, color, 4, 32), textures.plain((52, 52, 56))
    steel = textures.brushed_metal(look.rng, (182, 184, 190))
    length, width = look.between(0.115, 0.155), look.between(0.029, 0.038)
    base = block(length, width, 0.009, 0.012, 0.002)
    rail = block(length * 0.9, width * 0.42, 0.008, 0.004).turn(1, np.deg2rad(3.5))
    arm = block(length * 0.95, width * 0.78, 0.019, 0.012, 0.006).turn(1, np.deg2rad(6))
    hinge = block(0.03, width * 0.86, 0.03, 0.006, 0.003).move(x=length / 2 - 0.016, z=0.006)
    rail, arm = rail.move(x=0.002, z=0.019), arm.move(x=0.004, z=0.033)
    return shape(
        [(base, dark), (rail, steel), (arm, shell), (hinge, shell)],
        [hull_of(base), hull_of(arm), hull_of(hinge), hull_of(rail)],
    )


def ruler(look: Look) -> Shape:
    """A flat ruler with its scale up."""
    wooden = look.material in ("wood", "wooden") or (not look.material and look.chance(0.4))
    color = look.color("wooden") if wooden else look.color("sky", "clear", "yellow", "silver")
    long = look.pick([20, 30])
    x, y, h = long / 100 + 0.012, 0.032, 0.0032
    face = prints.rule(long, color, readable_on(color))
    return shape(
        [(box(x, y, h), textures.plain(color)), (box(x, y, 0.0004).move(z=h), face)],
        [box_part(x, y, h + 0.0004)],
    )


def calculator(look: Look) -> Shape:
    """A pocket calculator lying flat, display at the far end."""
    x, y, h = look.between(0.078, 0.09), look.between(0.13, 0.15), 0.013
    color = look.color("charcoal", "white", "navy", "gray", "pink", "teal", "yellow", "black")
    cap, mark = (
        look.pick([(232, 232, 230), (60, 62, 68), (250, 236, 200)]),
        look.own_color("orange", "red", "teal", "blue", "yellow"),
    )
    face = prints.canvas(96, 160, color)
    prints.fill(face, 0.1, 0.06, 0.8, 0.17, (178, 196, 170))
    prints.write(face, str(int(look.rng.integers(100, 99999))), 0.62, 0.15, 0.1, (40, 46, 40))
    pad = prints.keys(
        [(1,) * 4] * 5,
        cap,
        tint_color(color, 0.9),
        accent=mark,
        width=80,
        height=100,
    )
    face[52:152, 8:88] = pad
    body = block(x, y, h, 0.008, 0.002)
    return shape(
        [(body, textures.plain(color)), (box(x * 0.92, y * 0.94, 0.0008).move(z=h), face)],
        [box_part(x, y, h)],
    )


def desk_tray(look: Look) -> Shape:
    """A letter tray or drawer organiser: a low open box."""
    x, y, h, wall = look.between(0.24, 0.28), look.between(0.17, 0.2), 0.045, 0.005
    tile = look.surface(look.color("wooden", "white", "black", "gray"), "wood")
    walls = open_box(x, y, h, wall, wall)
    return shape([(solid, tile) for solid in walls], frame_parts(x, y, h, wall, wall))


CATEGORIES = (
    Category("book", book, (0.15, 0.215, 0.028), 0.45, ("novel", "hardback", "hymnal", "songbook",
             "hymn book", "almanac", "manga", "guide", "guidebook", "manual", "bible commentary",
             "script", "screenplay", "audiobook", "leather-bound book", "illuminated manuscript",
             "dress pattern", "libretto", "dust jacket", "volume"), ("office", "living",
             "coffee"), ("support", "flat"), INKS, state="lying flat"),
    Category("notebook", notebook, (0.145, 0.2, 0.014), 0.22, ("journal", "diary", "sketchbook",
             "notepad", "planner", "order pad", "legal pad", "score pad", "writing pad",
             "betting book", "workbook", "exercise book", "address book", "sketch pad",
             "graph paper pad", "flip chart pad", "steno pad", "drawing pad", "sketch book",
             "pad of paper", "paper pad", "jotter", "logbook", "bullet journal", "ledger"),
             ("office", "craft", "coffee"), ("support", "flat"), ("black", "teal", "coral"),
             state="lying flat"),
    Category("box", cardboard_box, (0.17, 0.125, 0.1), 0.35, ("cardboard box", "parcel", "package",
             "shoebox", "shoe box",
             "blade dispenser", "shot dispenser", "bit holder", "bug hotel", "chemistry set"),
             ("office", "living", "workbench"), ("support",), ()),
    Category("sticky_notes", sticky_notes, (0.076, 0.076, 0.022), 0.06, ("sticky note", "post-it",
             "post it note", "note pad", "bookplate", "post it pad", "post-it pad",
             "sticky note pad", "page flag"), ("office",), ("flat",), ("yellow", "pink"),
             state="lying flat"),
    Category("paper_stack", paper_stack, (0.215, 0.3, 0.005), 0.05, ("paper", "document", "papers",
             "sheet of paper", "scrap of paper", "newspaper page", "construction paper sheet",
             "origami paper pack", "tissue paper sheet", "tracing paper pad", "scrapbook page",
             "fishing licence", "card blank", "sheet of cardstock", "sheet of card",
             "traveller's cheque", "swimming certificate", "times table poster", "reward chart",
             "kirigami card", "paper ream", "ream of paper", "agenda", "application form",
             "leaflet", "flyer"), ("office",), ("support", "flat"), (), state="lying flat"),
    Category("stapler", stapler, (0.138, 0.034, 0.055), 0.2, ("electric stapler",), ("office",), (),
             ("black", "red")),
    Category("ruler", ruler, (0.26, 0.032, 0.0036), 0.03, ("metre rule", "metre stick", "yardstick",
             "set square ruler", "scale rule"), ("office", "craft"), ("flat",), (),
             state="lying flat"),
    Category("calculator", calculator, (0.084, 0.14, 0.014), 0.11, ("pocket calculator",
             "numeric keypad", "number pad"), ("office",), ("flat",), ("charcoal", "white"),
             state="lying flat"),
    Category("desk_tray", desk_tray, (0.26, 0.185, 0.045), 0.5, ("letter tray", "paper tray",
             "document tray",
             "organizer", "desk organizer", "writing slope", "drawer", "in tray", "in-tray",
             "out tray"), ("office",), ("container",), ("wooden", "white", "black")),
)  # fmt: skip
