"""Folded and crumpled paper: cranes, planes, boats, pinwheels, swans, rosettes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import drum, plate, standing
from ...build.recipes import ball, put_down, rod, standing_plate, straight
from ...build.shape import Shape
from ...build.solids import Solid, cylinder, join, loft
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile, plain

PAPERS = ("red", "blue", "yellow", "pink", "teal", "orange", "purple", "white", "mint")


def _paper(look: Look, color: RGB) -> Tile:
    """Return coloured paper, plain or patterned."""
    if look.chance(0.5):
        return textures.speckles(look.rng, color, 4, 32)
    image = prints.canvas(64, 64, color)
    for n in range(16):
        x, y = (n % 4 + 0.5 * (n // 4 % 2)) / 4 + 0.06, (n // 4 + 0.5) / 4
        prints.disc(
            image, x, y, 0.05, tint_color(color, 1.6) if sum(color) < 560 else (200, 90, 90)
        )
    return image


def _sheet(*corners: tuple[float, float, float], thick: float = 0.0012) -> Solid:
    """Return a thin flat piece of paper through corners in space."""
    p = np.array(corners, float)
    way = np.cross(p[1] - p[0], p[2] - p[0])
    way = way / np.linalg.norm(way) * thick / 2
    rows = np.stack([p - way, p + way])
    flat = np.column_stack([np.zeros(len(p)), np.zeros(len(p))])
    u = (p[1] - p[0]) / np.linalg.norm(p[1] - p[0])
    v = np.cross(way / np.linalg.norm(way), u)
    flat = np.column_stack([(p - p[0]) @ u, (p - p[0]) @ v])
    return loft(rows, flat)


def origami_crane(look: Look) -> Shape:
    """A folded paper crane with raised wings, a neck and a tail."""
    color = look.color(*PAPERS)
    k = look.between(0.8, 1.25)
    body = [_sheet((0.026, s * 0.001, 0.032), (-0.026, s * 0.001, 0.032), (0, s * 0.017, 0.0))
            for s in (1, -1)]  # fmt: skip
    front = [_sheet((0.026, 0.001, 0.032), (0, s * 0.017, 0.0), (0, 0, 0.04)) for s in (1, -1)]
    wings = [_sheet((0.02, s * 0.002, 0.03), (-0.02, s * 0.002, 0.03), (-0.006, s * 0.062, 0.052))
             for s in (1, -1)]  # fmt: skip
    neck = standing_plate([(0.006, 0.012), (0.02, 0.012), (0.058, 0.062), (0.052, 0.066)], 0.004)
    beak = standing_plate([(0.052, 0.065), (0.058, 0.061), (0.076, 0.05), (0.058, 0.066)], 0.0035)
    tail = standing_plate([(-0.02, 0.012), (-0.006, 0.012), (-0.068, 0.06)], 0.004)
    keel = standing((0.015, 0), (0.012, 0.012), (0.002, 0.034), sides=4).scale(1.4, 1, 1)
    inner = textures.plain(tint_color(color, 1.35))
    paper = _paper(look, color)
    return put_down([(join([*body, *front, keel, neck, tail]), paper), (join(wings), paper),
                     (beak, inner)], keel, *wings, neck, tail, factor=k)  # fmt: skip


def paper_plane(look: Look) -> Shape:
    """A folded paper dart."""
    color = look.color("white", "cream", "sky", "yellow", "red", "mint")
    k, w = look.between(0.75, 1.15), look.between(0.85, 1.2)
    wings = [
        _sheet((0.11, s * 0.001, 0.026), (-0.11, s * 0.004, 0.026), (-0.11, s * 0.065 * w, 0.034))
        for s in (1, -1)
    ]
    keel = [_sheet((0.11, s * 0.0008, 0.026), (-0.11, s * 0.004, 0.026), (-0.11, s * 0.0008, 0.0),
                   (-0.02, s * 0.0008, 0.0)) for s in (1, -1)]  # fmt: skip
    foot = plate([(-0.1, -0.012), (0.02, -0.004), (0.02, 0.004), (-0.1, 0.012)], 0.002)
    image = prints.canvas(64, 64, color)
    if look.chance(0.5):
        for n in range(1, 8):
            prints.fill(image, 0, n / 8, 1, 0.015, (130, 160, 210))
    return put_down([(join(wings), image), (join([*keel, foot]), plain(tint_color(color, 0.9)))],
                    foot, *wings, factor=k)  # fmt: skip


def paper_boat(look: Look) -> Shape:
    """A boat folded of paper, its middle fold standing up."""
    color = look.color("white", "blue", "red", "yellow", "mint", "cream")
    k = look.between(0.75, 1.25)
    hull = [_sheet((-0.075, s * 0.001, 0.05), (-0.03, s * 0.014, 0.0), (0.03, s * 0.014, 0.0),
                   (0.075, s * 0.001, 0.05), (0.0, s * 0.03, 0.036)) for s in (1, -1)]  # fmt: skip
    bottom = plate(
        [(-0.04, 0), (-0.03, -0.014), (0.03, -0.014), (0.04, 0), (0.03, 0.014), (-0.03, 0.014)],
        0.0015,
    )
    sail = standing_plate([(-0.032, 0.004), (0.032, 0.004), (0.0, 0.072)], 0.008)
    ends = [
        _sheet((s * 0.075, 0.001, 0.05), (s * 0.03, 0.014, 0), (s * 0.03, -0.014, 0))
        for s in (1, -1)
    ]
    paper = _paper(look, color)
    return put_down(
        [(join([*hull, bottom, *ends]), paper), (sail, textures.plain(tint_color(color, 1.2)))],
        join([*hull, bottom]),
        sail,
        factor=k,
    )


def pinwheel(look: Look) -> Shape:
    """A paper windmill on a stick, lying."""
    color = look.color("red", "blue", "yellow", "green", "pink")
    other = look.own_color("yellow", "white", "teal", "orange", "coral")
    k = look.between(0.8, 1.2)
    stick = straight((0, -0.2, 0.0028), (0, 0.0, 0.0028), 0.003, 8)
    vanes: list[list[Solid]] = [[], []]
    for n in range(4):
        leaf = _sheet(
            (0, 0, 0.008), (0.055, 0.002, 0.008), (0.05, 0.036, 0.024), (0.01, 0.012, 0.014)
        )
        vanes[n % 2].append(leaf.turn(2, n * np.pi / 2))
    hub = drum(0.008, 0.008, (0, 0, 0.008), bevel=0.002)
    foot = drum(0.05, 0.002, sides=4).move(0, 0, 0)
    return put_down(
        [
            (stick, textures.wood(look.rng, (214, 180, 130))),
            (join(vanes[0]), _paper(look, color)),
            (join(vanes[1]), _paper(look, other)),
            (hub, plain(tint_color(other, 0.7))),
            (foot.turn(2, 0.78), plain(tint_color(color, 0.8))),
        ],
        foot,
        stick,
        hub,
        factor=k,
        foot=0.3,
    )


def napkin_swan(look: Look) -> Shape:
    """A napkin folded into a swan."""
    color = look.color("white", "cream", "pink", "sky", "mint")
    k = look.between(0.85, 1.15)
    body = standing((0.045, 0), (0.052, 0.008), (0.046, 0.022), (0.016, 0.032), sides=20).scale(
        1.3, 1, 1
    )
    neck = rod([(0.045, 0, 0.018), (0.07, 0, 0.05), (0.05, 0, 0.095), (0.062, 0, 0.115),
                (0.08, 0, 0.108)], [0.016, 0.011, 0.009, 0.009, 0.005], 10)  # fmt: skip
    beak = cylinder(0.005, 0.016, 8, top=0.0008).turn(1, 1.9).move(0.079, 0, 0.109)
    wings = [_sheet((0.03, s * 0.03, 0.02), (-0.05, s * 0.046, 0.02), (-0.088, s * 0.034, 0.075),
                    (-0.03, s * 0.046, 0.062), thick=0.004) for s in (1, -1)]  # fmt: skip
    tail = [standing_plate([(-0.09 - 0.01 * n, 0.02), (-0.03, 0.012), (-0.05, 0.05)], 0.005).turn(
        2, 0.25 * (n - 1)) for n in range(3)]  # fmt: skip
    cloth = textures.fabric(look.rng, color)
    eyes = [ball(0.004, 0.004, 0.004, (0.066, s * 0.008, 0.116), 6) for s in (-1, 1)]
    return put_down([(join([body, neck, *wings, *tail]), cloth), (beak, plain((230, 140, 50))),
                     (join(eyes), plain((40, 36, 36)))], body, neck, *wings, factor=k)  # fmt: skip


def rosette(look: Look) -> Shape:
    """A pleated ribbon rosette with two tails, lying."""
    color = look.color("red", "blue", "green", "yellow", "purple", "pink")
    k = look.between(0.8, 1.2)
    a = np.linspace(0, 2 * np.pi, 49)[:-1]
    r = 0.04 + 0.0025 * np.cos(24 * a)
    ruff = plate(np.column_stack([r * np.cos(a), r * np.sin(a)]), 0.006, at=(0, 0, 0.003))
    r = 0.03 + 0.002 * np.cos(24 * a)
    inner = plate(np.column_stack([r * np.cos(a), r * np.sin(a)]), 0.004, at=(0, 0, 0.0085))
    badge = drum(0.021, 0.004, (0, 0, 0.0115), sides=28, bevel=0.001)
    face = prints.canvas(96, 96, (250, 240, 206))
    prints.disc(face, 0.5, 0.5, 0.44, color, 0.4)
    prints.write(
        face,
        look.pick(["1st", "2nd", "WIN", "BEST", "VOTE"]),
        0.5,
        0.5,
        0.3,
        (90, 60, 40),
        bold=True,
    )
    tails = [plate([(-0.012, -0.085), (0, -0.076), (0.012, -0.085), (0.012, 0), (-0.012, 0)], 0.003)
             .turn(2, s * 0.24) for s in (-1, 1)]  # fmt: skip
    rays = textures.stripes([color, tint_color(color, 0.8)], 4, upright=True)
    return put_down(
        [(join([ruff, *tails]), rays), (inner, plain(tint_color(color, 1.5))), (badge, face)],
        join([ruff, badge]),
        *tails,
        factor=k,
    )


def crumpled_paper(look: Look) -> Shape:
    """A sheet crumpled into a ball."""
    color = look.color("white", "cream", "yellow", "sky", "white")
    d = look.between(0.045, 0.075)
    lump = ball(d, d, 0.86 * d, (0, 0, 0.41 * d), 30)
    knots = look.rng.normal(size=(26, 3))
    knots /= np.linalg.norm(knots, axis=1, keepdims=True)

    def warp(p: np.ndarray) -> np.ndarray:
        way = p - [0, 0, 0.41 * d]
        unit = way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-9)
        near = np.sort(unit @ knots.T, axis=1)[:, -2:]
        dent = 1 - 0.24 * np.clip((near[:, 1] - near[:, 0]) / 0.13, 0, 1)
        return way * dent[:, None] + [0, 0, 0.41 * d]

    made = lump.bend(warp)
    made = made.move(z=-float(made.bounds[0, 2]) - 0.06 * d)
    image = textures.scratches(look.rng, color, tint_color(color, 0.8), 120)
    return put_down([(made, image)], made)


CATEGORIES = (
    Category("origami_crane", origami_crane, (0.147, 0.127, 0.0672), 0.004,
             ("origami", "paper crane", "origami bird", "folded crane", "paper bird",
             "origami figure",
              "origami swan"), ("craft", "toys"), (), ("red", "blue")),
    Category("paper_plane", paper_plane, (0.226, 0.147, 0.0356), 0.005,
             ("paper airplane", "paper aeroplane", "paper dart", "folded plane"),
             ("toys", "craft"), (), ("white",)),
    Category("paper_boat", paper_boat, (0.144, 0.0584, 0.0688), 0.005,
             ("origami boat", "folded boat", "paper ship"), ("toys", "craft"), (), ("white",)),
    Category("pinwheel", pinwheel, (0.111, 0.258, 0.0248), 0.015,
             ("paper pinwheel", "paper windmill", "toy windmill", "windmill toy", "whirligig"),
             ("toys", "craft"), (), ("red", "blue")),
    Category("napkin_swan", napkin_swan, (0.204, 0.105, 0.125), 0.04,
             ("folded napkin swan", "towel swan", "swan napkin", "swan"), ("dining",), (),
             ("white",)),
    Category("rosette", rosette, (0.086, 0.129, 0.0157), 0.02,
             ("paper rosette", "award ribbon", "prize ribbon", "ribbon rosette",
             "winner's rosette"),
             ("living",), ("flat",), ("red", "blue")),
    Category("crumpled_paper", crumpled_paper, (0.0613, 0.0595, 0.0481), 0.005,
             ("crumpled paper ball", "paper ball", "balled-up paper", "scrunched paper",
              "crumpled sheet", "crumpled note", "ball of paper", "scrunched-up paper",
              "crumpled newspaper", "wad of paper"), ("office",), (), ("white",)),
)  # fmt: skip
"""The module's categories."""
