"""Kitchen hand tools that lie: one handle, many heads."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.outlines import rectangle
from ...build.recipes import Pieces
from ...build.settled import limb, settle
from ...build.shape import Shape
from ...build.solids import box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

STEEL: RGB = (188, 192, 198)


HUES = ("black", "red", "wooden", "gray", "teal", "blue", "green", "white", "wooden")


Head = Callable[[Look, RGB, float], Pieces]
"""Makes the head that starts at x = 0 and reaches to the left, at height z."""


def with_handle(
    head: Head,
    grip: tuple[float, float],
    neck: float,
    palette: tuple[str, ...] = HUES,
    r: float = 0.009,
) -> Callable[[Look], Shape]:
    """Return the shape function of a tool that lies: a head, a neck, a grip of ``grip`` length."""

    def make(look: Look) -> Shape:
        long, color = look.between(*grip), look.color(*palette)
        size = look.between(0.92, 1.08)
        kind = look.pick(["straight", "waisted", "swelling"])
        radii = {
            "straight": [0.9, 1, 1, 1, 0.8],
            "waisted": [1, 0.75, 0.9, 1.15, 0.7],
            "swelling": [0.7, 0.9, 1.1, 1.2, 0.8],
        }[kind]
        x = np.linspace(neck, neck + long, 5)
        z = r * 1.2
        handle = limb(np.column_stack([x, 0 * x, 0 * x + z]), [r * k for k in radii], 12)
        pieces: Pieces = [
            (
                handle,
                look.surface(
                    color, "wood" if color[0] > 1.25 * color[2] and look.chance(0.6) else "plastic"
                ),
            )
        ]
        if neck > 0:
            pieces.append(
                (tube([(-0.004, 0, z), (neck + 0.01, 0, z)], 0.32 * r, 8), textures.plain(STEEL))
            )
        pieces += head(look, color, z)
        return settle(pieces, 0.02, hulls=[[0], list(range(1, len(pieces)))]).scale(size)

    return make


def steel(look: Look) -> textures.Tile:
    """Return brushed steel."""
    return textures.brushed_metal(look.rng, STEEL)


def _scoop(look: Look, color: RGB, z: float) -> Pieces:
    bowl = lathe(
        [(0, -0.012), (0.009, -0.009), (0.0135, 0), (0.0125, 0), (0.008, -0.008), (0, -0.0108)], 20
    )
    return [(bowl.move(-0.014, 0, z + 0.002), steel(look))]


def _tube_head(look: Look, color: RGB, z: float) -> Pieces:
    pipe = (
        lathe([(0.0095, 0), (0.0108, 0), (0.0108, 0.09), (0.0095, 0.09)], 18, loop=True)
        .turn(1, -np.pi / 2)
        .move(0, 0, z)
    )
    teeth = [
        box(0.006, 0.003, 0.004).move(-0.092, 0, 0.0085).turn(0, a).move(z=z)
        for a in 2 * np.pi * np.arange(8) / 8
    ]
    return [(join([pipe, *teeth]), steel(look))]


def _rasp(long: float, wide: float) -> Head:
    def make(look: Look, color: RGB, z: float) -> Pieces:
        plate = prism(rectangle(long, wide, 0.004), 0, 0.0022).move(-long / 2, 0, z)
        image = textures.fit(steel(look), 64, 192).copy()
        for i in range(26):
            for j in range(5):
                at = ((i + 0.5 + 0.5 * (j % 2)) / 27, (j + 0.7) / 5.4)
                prints.disc(image, *at, 0.055, (60, 62, 68))
                prints.disc(image, at[0] - 0.006, at[1], 0.03, (230, 232, 236))
        rails = [box(long, 0.003, 0.006).move(-long / 2, s * wide / 2, z - 0.003) for s in (-1, 1)]
        face = box(0.96 * long, 0.9 * wide, 0.0004).move(-long / 2, 0, z + 0.0021)
        return [(join([plate, *rails]), steel(look)), (face, image)]

    return make


def _holes_tip(look: Look, color: RGB, z: float) -> Pieces:
    head = prism(rectangle(0.018, 0.02, 0.006), 0, 0.006).move(-0.009, 0, z - 0.003)
    rings = [
        torus(0.0022, 0.0009, 10, 5).turn(1, np.pi / 2).move(-0.019, y, z)
        for y in (-0.007, -0.0023, 0.0023, 0.007)
    ]
    return [(head, steel(look)), (join(rings), textures.plain((60, 62, 68)))]


def _long_rod(look: Look, color: RGB, z: float) -> Pieces:
    rod = (
        lathe([(0, 0), (0.006, 0), (0.006, 0.2), (0.002, 0.215), (0, 0.215)], 16)
        .turn(1, -np.pi / 2)
        .move(0, 0, z)
    )
    guard = cylinder(0.013, 0.005, 16).turn(1, -np.pi / 2).move(0.004, 0, z)
    return [
        (rod, textures.stripes([STEEL, tint_color(STEEL, 0.7)], 10, upright=True)),
        (guard, steel(look)),
    ]


def _mallet(look: Look, color: RGB, z: float) -> Pieces:
    head = box(0.05, 0.055, 0.05).move(-0.02, 0, -0.0145 + z - 0.0105)
    spikes = [cylinder(0.006, 0.006, 4, top=0.0005).turn(2, np.pi / 4).turn(0,
        s * -np.pi / 2).move(-0.02 + 0.0115 * i, s * 0.0275 * -1, z + 0.0115 * j)
              for s in (-1, 1) for i in range(-1, 2) for j in range(-1, 2)]  # fmt: skip
    return [
        (head.move(z=0.0), steel(look)),
        (join(spikes), textures.plain(tint_color(STEEL, 0.8))),
    ]


def _fork_head(look: Look, color: RGB, z: float) -> Pieces:
    bowl = ellipsoid(0.085, 0.06, 0.026, 22, 10).bend(
        lambda p: np.column_stack([p[:, :2], np.where(p[:, 2] > 0, -0.55 * p[:, 2], p[:, 2])])
    )
    teeth = [limb([(-0.05 + 0.03 * np.cos(a) * 1.1, 0.03 * np.sin(a), z - 0.002),
                   (-0.05 + 0.045 * np.cos(a), 0.034 * np.sin(a), z + 0.02)],
                  [0.0042, 0.0032], 7) for a in np.linspace(0.7, 2 * np.pi - 0.7, 9)]  # fmt: skip
    hole = ellipsoid(0.022, 0.022, 0.002, 14, 5).move(-0.046, 0, z - 0.0075)
    tile = textures.speckles(look.rng, tint_color(color, 0.85), 4)
    return [
        (join([bowl.move(-0.045, 0, z + 0.002), *teeth]), tile),
        (hole, textures.plain((30, 30, 32))),
    ]


def _mesh_disc(r: float) -> Head:
    def make(look: Look, color: RGB, z: float) -> Pieces:
        mesh = cylinder(r, 0.0012, 36).move(-r, 0, z)
        rim = torus(r, 0.0028, 40, 6).move(-r, 0, z + 0.0006)
        return [
            (mesh, prints.mesh_holes((206, 208, 212), (120, 124, 130), 26, 26)),
            (rim, steel(look)),
        ]

    return make


_K = ("kitchen",)


_LIE = "lying flat"


def row(
    key: str,
    make: Callable[[Look], Shape],
    mass: float,
    size: tuple[float, float, float],
    *aliases: str,
) -> Category:
    """Return a category of a tool that keeps still."""
    return Category(
        key, keep_still(make), size, mass, aliases, _K, (), ("black", "red"), state=_LIE
    )


CATEGORIES = (
    row("melon_baller", with_handle(_scoop, (0.08, 0.1), 0.045), 0.04, (0.164, 0.0273, 0.0203),
         "melon scoop", "fruit baller", "parisienne scoop"),
    row("apple_corer", with_handle(_tube_head, (0.08, 0.1), 0.012, r=0.011), 0.06,
         (0.199, 0.0253, 0.0248), "corer", "pineapple corer"),
    row("zester", with_handle(_rasp(0.17, 0.03), (0.1, 0.12), 0.01), 0.09, (0.292, 0.0332, 0.0208),
         "microplane", "lemon zester", "rasp grater", "hand grater", "nutmeg grater",
         "fine grater"),
    row("citrus_zester", with_handle(_holes_tip, (0.08, 0.1), 0.03), 0.05, (0.142, 0.0212, 0.0203),
         "channel knife", "five hole zester"),
    row("sharpening_steel", with_handle(_long_rod, (0.1, 0.12), 0.0, r=0.011), 0.2,
         (0.322, 0.0262, 0.0256), "honing steel", "knife steel", "sharpening rod", "honing rod"),
    row("meat_tenderiser", with_handle(_mallet, (0.13, 0.16), 0.01, r=0.01), 0.35,
         (0.203, 0.0562, 0.0501), "meat tenderizer", "meat mallet", "meat hammer", "steak hammer"),
    row("pasta_server", with_handle(_fork_head, (0.15, 0.18), 0.05), 0.08, (0.307, 0.0713, 0.0316),
         "spaghetti server", "pasta fork", "pasta spoon", "spaghetti spoon"),
    row("splatter_guard", with_handle(_mesh_disc(0.13), (0.1, 0.13), 0.02), 0.2,
         (0.396, 0.263, 0.0209), "splatter screen", "frying pan guard"),
)  # fmt: skip
"""The module's categories."""
