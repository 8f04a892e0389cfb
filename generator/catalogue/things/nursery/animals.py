"""Toy animals on four legs, and dinosaurs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part
from ...build.forms import above
from ...build.recipes import ball, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import Tile


@dataclass(frozen=True)
class Beast:
    """A four-legged animal that looks to the left, in units of its body's length.

    ``body`` is length, width, height; ``legs`` their length and radius; ``neck`` where the head's
    middle is before the body's front (x) and above the body's middle (z), and the neck's radius;
    ``head`` length, width, height; ``snout`` length and height.
    """

    colors: tuple[str, ...]
    body: tuple[float, float, float] = (1.0, 0.42, 0.46)
    legs: tuple[float, float] = (0.42, 0.085)
    neck: tuple[float, float, float] = (0.2, 0.34, 0.13)
    head: tuple[float, float, float] = (0.3, 0.26, 0.27)
    snout: tuple[float, float] = (0.2, 0.17)
    ears: tuple[float, float] = (0.1, 0.13)
    tail: tuple[tuple[float, float], ...] = ((0.52, 0.08), (0.66, -0.05), (0.68, -0.25))
    skin: str = "plain"
    extras: tuple[str, ...] = ()
    long: float = 0.09


BEASTS: Mapping[str, Beast] = MappingProxyType(
    {
        "horse": Beast(("brown", "tan", "black", "white"), (1.0, 0.34, 0.38), (0.55, 0.07),
                       (0.16, 0.5, 0.12), (0.34, 0.2, 0.24), (0.3, 0.18), (0.07, 0.13),
                       extras=("mane", "hooves", "brush")),
        "unicorn": Beast(("white", "pink", "lavender"), (1.0, 0.36, 0.4), (0.5, 0.08),
                         (0.16, 0.48, 0.13), (0.34, 0.22, 0.26), (0.28, 0.18), (0.07, 0.13),
                         extras=("rainbow", "hooves", "horn", "brush")),
        "zebra": Beast(("white",), (1.0, 0.36, 0.4), (0.5, 0.075), (0.16, 0.46, 0.13),
                       (0.34, 0.2, 0.24), (0.28, 0.18), (0.08, 0.13), skin="bands",
                       extras=("mane", "hooves", "brush")),
        "cow": Beast(("white", "white", "brown"), (1.0, 0.44, 0.48), (0.4, 0.085),
                     (0.2, 0.26, 0.14), (0.34, 0.26, 0.28), (0.2, 0.2), (0.13, 0.08),
                     skin="patches", extras=("horns", "muzzle", "hooves")),
        "pig": Beast(("pink",), (1.0, 0.56, 0.58), (0.26, 0.1), (0.1, 0.1, 0.2),
                     (0.42, 0.42, 0.42), (0.14, 0.18), (0.15, 0.14),
                     ((0.5, 0.12), (0.58, 0.18), (0.56, 0.24)), extras=("muzzle",), long=0.08),
        "sheep": Beast(("white", "cream"), (1.0, 0.62, 0.62), (0.32, 0.075), (0.14, 0.22, 0.14),
                       (0.3, 0.24, 0.28), (0.14, 0.16), (0.16, 0.07), ((0.5, 0.1), (0.58, 0.06)),
                       skin="wool", extras=("dark head",), long=0.08),
        "elephant": Beast(("gray", "gray", "sky"), (1.0, 0.62, 0.64), (0.42, 0.13),
                          (0.16, 0.22, 0.2), (0.44, 0.4, 0.46), (0.0, 0.0), (0.0, 0.0),
                          ((0.5, 0.14), (0.58, 0.0), (0.58, -0.2)), extras=("trunk",), long=0.1),
        "giraffe": Beast(("amber", "gold"), (1.0, 0.4, 0.44), (0.8, 0.075), (0.2, 1.25, 0.11),
                         (0.34, 0.2, 0.22), (0.26, 0.15), (0.13, 0.07), skin="patches",
                         extras=("horns", "hooves"), long=0.075),
        "lion": Beast(("amber", "tan"), (1.0, 0.38, 0.4), (0.4, 0.085), (0.16, 0.28, 0.15),
                      (0.36, 0.3, 0.32), (0.16, 0.17), (0.08, 0.08),
                      ((0.48, 0.08), (0.64, 0.14), (0.7, 0.34)), extras=("ruff",)),
        "tiger": Beast(("orange",), (1.0, 0.38, 0.4), (0.38, 0.085), (0.16, 0.26, 0.15),
                       (0.36, 0.32, 0.32), (0.15, 0.17), (0.09, 0.1),
                       ((0.48, 0.08), (0.66, 0.1), (0.74, 0.3)), skin="bands"),
        "dog": Beast(("brown", "tan", "black", "white", "gray"), (1.0, 0.4, 0.42), (0.42, 0.085),
                     (0.16, 0.36, 0.14), (0.38, 0.32, 0.34), (0.22, 0.18), (0.15, 0.1),
                     ((0.46, 0.12), (0.6, 0.26), (0.64, 0.44)), extras=("muzzle",), long=0.08),
        "cat": Beast(("gray", "orange", "black", "white", "tan"), (1.0, 0.38, 0.4), (0.38, 0.075),
                     (0.14, 0.34, 0.13), (0.36, 0.36, 0.34), (0.1, 0.13), (0.15, 0.12),
                     ((0.46, 0.1), (0.62, 0.22), (0.6, 0.5), (0.66, 0.6)), long=0.075),
        "rabbit": Beast(("white", "brown", "gray", "tan"), (1.0, 0.62, 0.66), (0.16, 0.13),
                        (0.06, 0.46, 0.2), (0.48, 0.42, 0.44), (0.12, 0.16), (0.17, 0.34),
                        ((0.5, 0.1), (0.56, 0.12)), extras=("puff",), long=0.065),
        "fox": Beast(("orange",), (1.0, 0.36, 0.38), (0.4, 0.07), (0.16, 0.34, 0.13),
                     (0.38, 0.34, 0.3), (0.26, 0.12), (0.13, 0.18),
                     ((0.46, 0.08), (0.72, 0.1), (1.0, 0.22)), extras=("bushy", "hooves")),
    }
)  # fmt: skip
"""The animals by key."""

_RAINBOW = ((236, 96, 130), (250, 196, 90), (110, 190, 150), (120, 150, 220), (170, 120, 210))


def _coat(look: Look, beast: Beast, color: tuple[float, float, float]) -> Tile:
    """Return the animal's skin."""
    dark = tint_color(color, 0.45)
    if beast.skin == "bands":
        return textures.stripes([color, color, (40, 38, 40)], 7, side=96)
    if beast.skin == "patches":
        patch = dark if sum(color) < 600 else look.pick([(44, 42, 44), (110, 74, 50)])
        mask = textures.noise(look.rng, 64, 64, (6, 6), 1)
        image = np.broadcast_to(np.array(color), (64, 64, 3)).copy()
        image[mask > 0.12] = patch
        return np.clip(image, 0, 255).astype(np.uint8)
    if beast.skin == "wool":
        return textures.spots(look.rng, color, tint_color(color, 0.82), 0.3)
    return textures.speckles(look.rng, color, 6)


def beast_shape(key: str) -> Callable[[Look], Shape]:
    """Return the shape function of an animal."""

    def make(look: Look) -> Shape:
        return _beast(look, BEASTS[key])

    return make


def _beast(look: Look, b: Beast) -> Shape:
    color = look.color(*b.colors)
    coat, dark = _coat(look, b, color), textures.plain((34, 32, 34))
    pale = textures.plain(tint_color(color, 1.6) if sum(color) < 640 else (246, 206, 200))
    plain = textures.plain((60, 56, 56) if "dark head" in b.extras else color)
    (long, wide, tall), (leg, thick) = b.body, b.legs
    mid = leg + 0.42 * tall
    body = ellipsoid(tall, wide, long, 20, 12).turn(1, np.pi / 2).move(z=mid)
    hx, hz = -long / 2 - b.neck[0] + 0.12, mid + b.neck[1]
    head = ball(*b.head, (hx, 0, hz))
    neck = straight((-0.3 * long, 0, mid + 0.05), (hx + 0.04, 0, hz - 0.02),
                    [b.neck[2] * 1.25, b.neck[2]], 10)  # fmt: skip
    sx, sy = 0.32 * long, 0.5 * wide - 0.9 * thick
    feet = [(x, y) for x in (-sx, sx) for y in (-sy, sy)]
    legs = [cylinder(thick, mid, 12, top=1.15 * thick).move(x, y) for x, y in feet]
    skin = dark if "dark head" in b.extras else coat
    pieces = [(body, coat), (neck, coat), (head, plain), (join(legs), skin)]
    tail = rod([(x, 0, mid + z) for x, z in b.tail],
               0.1 if "bushy" in b.extras else 0.03, 8)  # fmt: skip
    pieces.append((tail, coat if b.skin != "wool" else plain))
    front = hx - 0.5 * b.head[0]
    if b.snout[0]:
        at = (front + 0.1 * b.head[0], 0, hz - 0.12 * b.head[2])
        pieces.append((ball(1.5 * b.snout[0], 0.75 * b.head[1], b.snout[1], at),
                       pale if "muzzle" in b.extras else plain))  # fmt: skip
        tip = at[0] - 0.74 * b.snout[0]
        pieces.append((ball(0.05, 0.08, 0.05, (tip, 0, at[2] + 0.04), 8), dark))
    eyes = [ball(0.05, 0.05, 0.06, (hx - 0.36 * b.head[0], s * 0.33 * b.head[1],
                                    hz + 0.16 * b.head[2]), 8) for s in (-1, 1)]  # fmt: skip
    pieces.append((join(eyes), dark))
    if b.ears[0]:
        ears = [ball(0.07, b.ears[0], 2 * b.ears[1], (0, 0, 0), 10).turn(0, -0.45 * s)
                .move(hx + 0.2 * b.head[0], s * 0.36 * b.head[1],
                      hz + 0.4 * b.head[2] + 0.4 * b.ears[1]) for s in (-1, 1)]  # fmt: skip
        pieces.append((join(ears), plain))
    pieces += _extras(look, b, (hx, hz, mid), feet)
    low = join(legs)
    hulls = [body, head, join([low.scale(1, 1, 0.6)]), neck]
    return shape(pieces, [hull_part(above(s.vertices)) for s in hulls]).scale(
        b.long * look.between(0.86, 1.16)
    )


def _extras(
    look: Look, b: Beast, at: tuple[float, float, float], feet: list[tuple[float, float]]
) -> list[tuple[Solid, Tile]]:
    """Return manes, horns, trunks and the like."""
    hx, hz, mid = at
    dark, pale = textures.plain((44, 38, 36)), textures.plain((242, 234, 214))
    made: list[tuple[Solid, Tile]] = []
    back = [(hx + 0.2 * b.head[0], 0, hz + 0.5 * b.head[2]), (hx + 0.3, 0, hz - 0.02),
            (-0.26, 0, mid + 0.3 * b.body[2])]  # fmt: skip
    if "mane" in b.extras or "rainbow" in b.extras:
        tile = textures.stripes(_RAINBOW, 1) if "rainbow" in b.extras else dark
        made.append((rod(back, [0.05, 0.075, 0.04], 8), tile))
    if "brush" in b.extras:
        tile = textures.stripes(_RAINBOW, 1) if "rainbow" in b.extras else dark
        made.append((rod([(x + 0.01, 0, mid + z) for x, z in b.tail], [0.04, 0.07, 0.02], 8), tile))
    if "hooves" in b.extras:
        hooves = [cylinder(1.2 * b.legs[1], 0.09, 12).move(x, y) for x, y in feet]
        made.append((join(hooves), dark))
    if "horn" in b.extras:
        horn = cylinder(0.045, 0.3, 10, top=0.004).turn(1, -0.5)
        made.append((horn.move(hx - 0.12, 0, hz + 0.4 * b.head[2]), textures.plain((236, 190, 80))))
    if "horns" in b.extras:
        horns = [cylinder(0.035, 0.15, 8, top=0.02).turn(0, -0.35 * s)
                 .move(hx + 0.06, s * 0.07, hz + 0.4 * b.head[2]) for s in (-1, 1)]  # fmt: skip
        made.append((join(horns), pale))
    if "ruff" in b.extras:
        ruff = ball(0.24, 0.56, 0.58, (hx + 0.14, 0, hz), 16)
        made.append((ruff, textures.scratches(look.rng, (126, 76, 40), (90, 52, 28), 60)))
        made.append((ball(0.13, 0.11, 0.13, (b.tail[-1][0], 0, mid + b.tail[-1][1]), 8), dark))
    if "puff" in b.extras:
        made.append((ball(0.2, 0.2, 0.2, (0.52, 0, mid), 10), textures.plain((246, 244, 240))))
    if "bushy" in b.extras:
        made.append((ball(0.26, 0.17, 0.17, (1.02, 0, mid + 0.23), 10), pale))
    if "trunk" in b.extras:
        x = hx - 0.2
        nose = rod([(x, 0, hz), (x - 0.16, 0, hz - 0.22), (x - 0.16, 0, hz - 0.5),
                    (x - 0.26, 0, hz - 0.56)], [0.12, 0.09, 0.065, 0.05], 10)  # fmt: skip
        grey = textures.plain(look.own_color("gray"))
        ears = [ball(0.1, 0.09, 0.5, (hx + 0.16, s * 0.26, hz), 12).scale(1, 1, 1)
                for s in (-1, 1)]  # fmt: skip
        flaps = [ball(0.08, 0.36, 0.46, (0, 0, 0), 14).turn(2, s * 0.5)
                 .move(hx + 0.12, s * 0.34, hz) for s in (-1, 1)]  # fmt: skip
        tusks = [rod([(x, s * 0.12, hz - 0.16), (x - 0.14, s * 0.13, hz - 0.24),
                      (x - 0.24, s * 0.13, hz - 0.18)], [0.035, 0.028, 0.01], 6)
                 for s in (-1, 1)]  # fmt: skip
        made += [(join([nose, *ears]), grey), (join(flaps), grey), (join(tusks), pale)]
    return made


def _row(key: str, size: tuple[float, float, float], mass: float, *aliases: str) -> Category:
    """Return the row of one animal; the bare word means the toy."""
    names = (key, f"{key} figure", f"plastic {key}", f"wooden {key}", f"{key} statue")
    return Category(f"toy_{key}", beast_shape(key), size, mass, (*names, *aliases), ("toys",),
                    (), BEASTS[key].colors[:2])  # fmt: skip


CATEGORIES = (
    _row("horse", (0.15, 0.035, 0.115), 0.06, "pony", "toy pony"),
    _row("unicorn", (0.15, 0.035, 0.12), 0.06),
    _row("zebra", (0.15, 0.035, 0.11), 0.06),
    _row("cow", (0.15, 0.04, 0.095), 0.06, "bull"),
    _row("pig", (0.113, 0.0496, 0.0776), 0.05, "piglet", "toy piglet"),
    _row("sheep", (0.11, 0.05, 0.07), 0.05, "lamb", "toy lamb"),
    _row("elephant", (0.17, 0.085, 0.095), 0.09),
    _row("giraffe", (0.125, 0.03, 0.17), 0.06),
    _row("lion", (0.165, 0.05, 0.085), 0.06),
    _row("tiger", (0.17, 0.035, 0.085), 0.06),
    _row("dog", (0.14, 0.035, 0.09), 0.05, "puppy", "toy puppy", "pull along dog"),
    _row("cat", (0.115, 0.03, 0.09), 0.04, "kitten", "toy kitten", "ceramic cat"),
    _row("rabbit", (0.0868, 0.0506, 0.1), 0.04, "bunny", "bunny figure", "toy bunny"),
    _row("fox", (0.192, 0.0413, 0.118), 0.05),
)
"""The module's categories."""
