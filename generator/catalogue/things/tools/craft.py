"""Things of a handicraft table."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, resting_ball
from ...build.outlines import ellipse, rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "black")


def yarn_ball(look: Look) -> Shape:
    """A ball of yarn with loose windings."""
    d = look.between(0.07, 0.09)
    color = look.color("red", "teal", "mustard", "pink", "violet", "cream", "blue")
    wool = textures.knitting(look.rng, color)
    ball = ellipsoid(d, d, 0.96 * d, 24, 14).bend(
        lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], -0.45 * d)])
    )
    pieces = [(ball.move(z=0.45 * d), wool)]
    for k in range(4):
        loop = torus(0.488 * d, 0.0028, 28, 6).turn(0, 0.6 + 0.55 * k).turn(2, 0.8 * k)
        pieces.append(
            (
                loop.move(z=0.455 * d + 0.0045),
                textures.plain(tint_color(color, 0.82 + 0.1 * (k % 3))),
            )
        )
    return shape(pieces, [resting_ball(d, d, 0.93 * d)])


def thread_spool(look: Look) -> Shape:
    """A wooden spool of thread, standing."""
    r, h = look.between(0.014, 0.018), look.between(0.045, 0.055)
    thread = textures.stripes([c := look.color(*BRIGHT, "pink", "teal"), tint_color(c, 0.8)], 14)
    wood = textures.wood(look.rng, (214, 176, 124))
    end = cylinder(r, 0.006, 20, bevel=0.0015)
    return shape(
        [
            (end, wood),
            (end.move(z=h - 0.006), wood),
            (cylinder(0.86 * r, h - 0.01, 20).move(z=0.005), thread),
        ],
        [cylinder_part(r, h)],
    )


def pencil_case(look: Look) -> Shape:
    """A soft zipped pencil case, lying."""
    x, y, h = look.between(0.19, 0.21), look.between(0.065, 0.08), look.between(0.045, 0.055)
    cloth = textures.fabric(look.rng, look.color("navy", "teal", "red", "gray", "pink", "mustard"))
    body = prism(rectangle(x, y, 0.03), 0, h, 0.012)
    zipper = box(0.8 * x, 0.007, 0.0015).move(z=h - 0.0005)
    teeth = textures.stripes([(60, 60, 64), (190, 190, 194)], 24, upright=True)
    pull = prism(ellipse(0.016, 0.008, 12), 0, 0.002).move(x=0.36 * x, z=h)
    return shape(
        [(body, cloth), (zipper, teeth), (pull, textures.plain((196, 170, 90)))],
        [hull_of(body)],
    )


def paint_palette(look: Look) -> Shape:
    """A painter's palette with dabs of paint, lying flat."""
    wood = textures.wood(look.rng, look.pick([(206, 164, 112), (150, 100, 62), (226, 200, 160)]))
    if look.chance(0.4):
        wood = textures.plain(look.color("white", "cream", "black"))
    board = prism(ellipse(look.between(0.24, 0.28), look.between(0.175, 0.205), 28), 0, 0.006)
    pieces = [(board, wood)]
    for k, name in enumerate(
        look.rng.permutation(
            ["red", "blue", "yellow", "green", "white", "orange", "violet", "pink", "brown", "teal"]
        )[: look.rng.integers(4, 8)]
    ):
        a = 0.55 + 0.48 * k
        dab = ellipsoid(look.between(0.022, 0.038), look.between(0.02, 0.032), 0.009, 14, 6).move(
            0.095 * np.cos(a), 0.065 * np.sin(a), 0.0065
        )
        pieces.append((dab, textures.plain(look.own_color(name))))
    hole = cylinder(0.014, 0.0005, 18).move(0.05, -0.045, 0.0058)
    pieces.append((hole, textures.plain((120, 92, 62))))
    return shape(pieces, [hull_of(board)])


def tube_of_paint(look: Look) -> Shape:
    """A tube of paint lying on its flat side."""
    color = look.color(*BRIGHT, "crimson", "teal")
    body = prism(
        [(-0.06, -0.021), (0.035, -0.017), (0.048, -0.009), (0.048, 0.009), (0.035, 0.017),
         (-0.06, 0.021)],
        0, 0.02, 0.004,
    )  # fmt: skip
    image = prints.canvas(96, 48, (238, 238, 236))
    prints.fill(image, 0.3, 0, 0.4, 1, color)
    prints.write(image, "OIL", 0.5, 0.5, 0.3, (250, 250, 250))
    flat = box(0.08, 0.024, 0.0008).move(x=-0.01, z=0.0198)
    cap = cylinder(0.008, 0.016, 14, bevel=0.001).turn(1, np.pi / 2).move(0.047, 0, 0.0095)
    return shape(
        [
            (body, textures.brushed_metal(look.rng, (206, 208, 212))),
            (flat, image),
            (cap, textures.plain(tint_color(color, 0.7))),
        ],
        [hull_of(body), hull_of(cap)],
    )


def button_tin(look: Look) -> Shape:
    """A round tin of buttons or beads, open."""
    r, h = look.between(0.036, 0.044), look.between(0.028, 0.036)
    metal = textures.brushed_metal(look.rng, look.color("silver", "gold", "teal", "copper"))
    body = cylinder(r, h, 28, bevel=0.002)
    well = cylinder(0.88 * r, 0.001, 28).move(z=h - 0.0004)
    pieces = [(body, metal), (well, textures.plain((74, 70, 68)))]
    for k in range(11):
        a, away = 2.4 * k, 0.72 * r * np.sqrt((k + 0.3) / 11)
        bead = cylinder(0.0055, 0.003, 10, bevel=0.001)
        spot = bead.move(away * np.cos(a), away * np.sin(a), h)
        pieces.append((spot, textures.plain(look.own_color(*BRIGHT, "pink", "white"))))
    rod = tube([(r + 0.001, 0, h - 0.006), (r + 0.001, 0, 0.004)], 0.0012, 6)
    return shape([*pieces, (rod, metal)], [cylinder_part(r, h + 0.0015)])


def scissors(look: Look) -> Shape:
    """Scissors lying flat and closed, two finger loops to the right."""
    long = look.between(0.17, 0.2)
    color = look.color("red", "black", "orange", "blue", "teal", "pink", "lime", "violet", "gray")
    fat, wide = look.between(0.2, 0.3), look.between(0.014, 0.019)
    steel = textures.brushed_metal(look.rng, (190, 193, 198))
    grip = textures.speckles(look.rng, color, 4, 32)
    pieces = []
    for side, low in ((-1, 0.0), (1, 0.0024)):
        outline = np.array(
            [(-0.5 * long, 0), (0.02, -0.011), (0.045, -0.006), (0.045, 0.004), (0.0, 0.004)]
        )
        if side > 0:
            outline = outline[::-1] * [1, -1]
        blade = prism(outline, low, low + 0.0024)
        loop = torus(1.0, fat, 24, 8).scale(look.between(0.021, 0.027), wide, 0.005 / fat)
        loop = loop.turn(2, side * 0.3).move(0.5 * long - 0.022, side * 0.021, 0.0052)
        pieces += [(blade, steel), (loop, grip)]
    screw = cylinder(0.0045, 0.002, 14).move(x=0.012, z=0.0046)
    low = min(solid.bounds[0, 2] for solid, _ in pieces)
    pieces.append((screw, textures.plain((120, 122, 128))))
    pieces = [(solid.move(z=-low), tile) for solid, tile in pieces]
    return shape(pieces, [hull_of(solid) for solid, _ in pieces[:4]])


def glue_stick(look: Look) -> Shape:
    """A glue stick standing on its foot, with its cap on."""
    r, h = look.between(0.0125, 0.0145), look.between(0.085, 0.1)
    color = look.color("yellow", "red", "blue", "green", "violet")
    print_ = prints.label(look.rng, "GLUE", color, (246, 246, 242))
    foot = cylinder(r * 1.05, 0.012, 20, bevel=0.001)
    body = cylinder(r, 0.62 * h, 24).move(z=0.01)
    cap = cylinder(r * 1.08, 0.36 * h, 24, top=r, bevel=0.0015).move(z=0.01 + 0.62 * h)
    tint = textures.plain(color)
    return shape(
        [(foot, tint), (body, print_), (cap, tint)],
        [cylinder_part(r, 0.01 + 0.62 * h), hull_of(foot), hull_of(cap)],
    )


def canvas(look: Look) -> Shape:
    """A blank canvas on its stretcher, lying."""
    x, y, h = look.between(0.27, 0.33), look.between(0.21, 0.26), look.between(0.016, 0.02)
    cloth = textures.speckles(look.rng, look.color("white", "cream"), 5, 64)
    return shape([(block(x, y, h, 0.004, 0.002), cloth)], [box_part(x, y, h)])


CATEGORIES = (
    Category(
        "canvas",
        canvas,
        (0.3, 0.235, 0.018),
        0.35,
        ("blank canvas", "painting canvas", "stretched canvas", "artist canvas"),
        ("craft",),
        ("flat",),
        ("white",),
        state="lying flat",
    ),
    Category(
        "scissors",
        scissors,
        (0.19, 0.08, 0.011),
        0.07,
        (
            "pair of scissors",
            "shears",
            "scissor",
            "wick trimmer",
            "wick trimmers",
            "pinking shears",
            "sewing kit",
            "thread snips",
            "trauma shears",
        ),
        ("craft", "office"),
        ("flat",),
        ("red", "black"),
        state="lying flat, closed",
    ),
    Category(
        "glue_stick",
        glue_stick,
        (0.028, 0.028, 0.1),
        0.035,
        ("glue", "glue tube", "wood glue bottle"),
        ("craft", "office"),
        ("round",),
        ("yellow", "red"),
    ),
    Category(
        "yarn_ball",
        yarn_ball,
        (0.082, 0.082, 0.079),
        0.06,
        ("ball of yarn", "yarn", "wool ball", "ball of wool", "string of beads", "garden twine"),
        ("craft",),
        ("round",),
        ("red", "teal", "pink"),
        friction=0.9,
    ),
    Category(
        "thread_spool",
        thread_spool,
        (0.032, 0.032, 0.05),
        0.03,
        (
            "spool of thread",
            "spool",
            "thread",
            "sewing thread",
            "crab line",
            "cotton reel",
            "wool cone",
            "reel of cotton",
            "fishing line",
            "spool of fishing line",
        ),
        ("craft",),
        ("round",),
        BRIGHT,
    ),
    Category(
        "pencil_case",
        pencil_case,
        (0.2, 0.072, 0.052),
        0.15,
        (
            "pencil pouch",
            "pouch",
            "razor case",
            "crayon roll",
            "recorder case",
            "tool roll",
            "baby pouch",
        ),
        ("office", "craft"),
        (),
        ("navy", "teal"),
        state="lying flat",
    ),
    Category(
        "paint_palette",
        paint_palette,
        (0.26, 0.19, 0.011),
        0.16,
        ("palette", "artist palette", "painter's palette"),
        ("craft",),
        ("flat",),
        state="lying flat",
    ),
    Category(
        "paint_tube",
        tube_of_paint,
        (0.123, 0.042, 0.02),
        0.06,
        (
            "tube of paint",
            "oil paint",
            "acrylic paint",
            "acrylic tube",
            "gouache tube",
            "watercolour tube",
            "oil paint tube",
        ),
        ("craft",),
        (),
        BRIGHT,
        state="lying flat",
    ),
    Category(
        "button_tin",
        button_tin,
        (0.08, 0.08, 0.036),
        0.12,
        ("tin of buttons", "beads", "button box", "tin", "sewing tin"),
        ("craft",),
        ("round",),
        ("silver", "gold"),
    ),
)
