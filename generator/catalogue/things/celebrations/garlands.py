"""Garlands and strings: tinsel, lights, bunting, streamers, sashes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.forms import spread
from ...build.outlines import smooth
from ...build.recipes import put_down
from ...build.settled import hull_above, limb, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, prism, tube
from ...build.variants import at_rest
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

GAY: tuple[RGB, ...] = (
    (226, 52, 60),
    (250, 200, 50),
    (60, 160, 84),
    (50, 120, 210),
    (240, 120, 40),
    (220, 80, 160),
)


def _winding(long: float, wide: float, turns: float, count: int) -> np.ndarray:
    """Return a path that winds over the table in loops."""
    t = np.linspace(0, 1, count)
    return np.column_stack([long * (t - 0.5), wide * np.sin(2 * np.pi * turns * t), 0 * t])


def tinsel(look: Look) -> Shape:
    """A length of glittering tinsel winding over the table."""
    k = look.between(0.9, 1.1)
    color = look.color("silver", "gold", "red", "green", "blue", "purple")
    path = _winding(0.3, 0.045, 1.6, 60)
    core = tube(path + np.array([0, 0, 0.012]), 0.004, 5)
    spikes = []
    for n in range(170):
        at = path[int(n * 59 / 169)] + [0, 0, 0.012]
        a, b = look.rng.uniform(0, 6.28), look.rng.uniform(-0.5, 1)
        way = 0.017 * np.array([np.cos(a) * np.sqrt(1 - b * b), np.sin(a) * np.sqrt(1 - b * b), b])
        tip = at + way
        spikes.append(tube([at, [tip[0], tip[1], max(tip[2], 0.0005)]], [0.0022, 0.0009], 3))
    shine = textures.stripes([tint_color(color, 1.4), color, tint_color(color, 0.65)], 8)
    body = join([core, *spikes])
    return shape([(body, shine)], [hull_above(*spikes[n : n + 34]) for n in range(0, 170, 34)]
                 ).scale(k)  # fmt: skip


def string_lights(look: Look) -> Shape:
    """A string of small coloured lights on a green wire, in loops."""
    k = look.between(0.9, 1.1)
    color = look.color("green", "green", "black", "white")
    warm = look.chance(0.35)
    t = np.linspace(0, 1, 80)
    path = np.column_stack([0.3 * (t - 0.5) + 0.045 * np.sin(6 * np.pi * t), 0.06 * np.cos(
                            6 * np.pi * t), 0.0023 + 0 * t])  # fmt: skip
    wire = tube(path, 0.0022, 6)
    groups: dict[RGB, list[Solid]] = {}
    sockets = []
    for n in range(15):
        at = path[3 + n * 5]
        way = path[4 + n * 5] - at
        a = np.arctan2(way[1], way[0]) + np.pi / 2 * (-1) ** n
        out = np.array([np.cos(a), np.sin(a), 0])
        sockets.append(tube([at, at + 0.012 * out + [0, 0, 0.002]], 0.0045, 8))
        bulb = ellipsoid(0.021, 0.0125, 0.0125, 10, 7).turn(2, a).move(*(at + 0.021 * out + [0, 0,
                                                                         0.004]))  # fmt: skip
        tone: RGB = (255, 226, 150) if warm else GAY[n % 4]
        groups.setdefault(tone, []).append(bulb)
    dark = textures.plain(tint_color(color, 0.7))
    pieces = [(join([wire, *sockets]), dark)]
    pieces += [(join(bulbs), textures.plain(tone)) for tone, bulbs in groups.items()]
    thirds = [wire.vertices[(wire.vertices[:, 0] >= a) & (wire.vertices[:, 0] < b)]
              for a, b in ((-1, -0.06), (-0.06, 0.06), (0.06, 1))]  # fmt: skip
    return shape(pieces, [hull_part(np.maximum(p, [-9, -9, 0])) for p in thirds]
                 + [hull_above(join([b for g in groups.values() for b in g]))]
                 ).scale(k)  # fmt: skip


def _flag(look: Look, tone: RGB, letter: str) -> textures.Tile:
    image = prints.canvas(48, 56, tone)
    if letter:
        prints.disc(image, 0.5, 0.38, 0.26, (250, 248, 240))
        prints.write(image, letter, 0.5, 0.38, 0.34, tint_color(tone, 0.7), bold=True)
    else:
        prints.disc(image, 0.35, 0.25, 0.06, tint_color(tone, 1.6))
        prints.disc(image, 0.65, 0.25, 0.06, tint_color(tone, 1.6))
        prints.disc(image, 0.5, 0.5, 0.06, tint_color(tone, 1.6))
    return image


def bunting(word: str, cut: bool) -> Callable[[Look], Shape]:
    """Return a string of flags lying in an arc: triangles, or letters on squares."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.08)
        color = look.color("white", "cream", "red", "blue", "pink")
        own = "color" in look.attributes
        count = len(word) if word else 7
        pieces: list[tuple[Solid, textures.Tile]] = []
        cord = []
        for n in range(count):
            a = (n - (count - 1) / 2) * 0.34
            at = np.array([0.3 * np.sin(a), 0.3 * np.cos(a) - 0.26])
            outline = [(-0.024, 0), (0, -0.058), (0.024, 0)] if cut else [(-0.022, 0),
                       (-0.022, -0.046), (0.0, -0.056), (0.022, -0.046), (0.022, 0)]  # fmt: skip
            flag = prism(1.35 * np.array(outline), 0, 0.0014)
            face = prism(1.35 * (np.array(outline) * 0.98 - [0, 0.0005]), 0.0012, 0.0018)
            tone = tint_color(color, 1 - 0.09 * (n % 3)) if own else GAY[n % 6]
            turned = [s.turn(2, -a).move(at[0], at[1], 0) for s in (flag, face)]
            face_tile = _flag(look, tone, word[n] if word else "")
            pieces += [(turned[0], textures.plain(tone)), (turned[1], face_tile)]
            cord.append((at[0], at[1], 0.0022))
        ends = [(cord[0][0] - 0.03, cord[0][1] - 0.02, 0.0018), *cord,
                (cord[-1][0] + 0.03, cord[-1][1] - 0.02, 0.0018)]  # fmt: skip
        string = tube(smooth(ends, 4), 0.0018, 6)
        pieces.append((string, textures.plain(color)))
        flags = [s for s, _ in pieces[:-1]]
        half = len(flags) // 2 // 2 * 2
        return shape(
            pieces, [hull_of(*flags[: half // 2 * 2]), hull_of(*flags[half // 2 * 2 :])]
        ).scale(k)

    return make


def streamer(look: Look) -> Shape:
    """A paper streamer, its coil sprung open in curls."""
    k = look.between(0.9, 1.1)
    color = look.color("pink", "yellow", "sky", "red", "lime", "purple", "orange")
    t = np.linspace(0, 1, 110)
    r = 0.026 + 0.004 * np.sin(9 * t)
    turn = 2 * np.pi * 6.5 * t
    path = np.column_stack([0.24 * (t - 0.5) + r * np.cos(turn), 0.02 * np.sin(5 * t),
                            0.0305 + r * np.sin(turn) * 0.95])  # fmt: skip
    ribbon = tube(path, 0.0065, 6, squash=0.18)
    roll = cylinder(0.024, 0.014, 26).turn(0, np.pi / 2).move(0.16, 0.006, 0.024)
    spun = textures.stripes([color, tint_color(color, 0.85)], 6)
    return settle([(ribbon, spun), (roll, spun)], 0.01, hulls=[[0], [1]]).scale(k)


def sash(look: Look) -> Shape:
    """A satin sash lying in a loop, lettered."""
    k = look.between(0.94, 1.06)
    color = look.color("pink", "white", "red", "purple", "gold", "sky")
    u = np.linspace(0, 1, 26)
    turn = np.pi * (0.12 + 0.76 * u)
    image = prints.canvas(320, 48, color)
    ink = readable_on(color) if sum(color) > 380 else (246, 220, 140)
    prints.write(image, look.pick(["BIRTHDAY GIRL", "BIRTHDAY BOY", "WINNER", "BRIDE TO BE"]), 0.5,
                 0.5, 0.6, ink, bold=True)  # fmt: skip
    grid = np.stack([np.stack([(0.13 + s * 0.022) * -np.cos(turn), (0.11 + s * 0.022) * -np.sin(
        turn) + 0.06, 0.0006 + 0.0012 * np.sin(9 * u) ** 2], -1) for s in (1, -1)])  # fmt: skip
    front = spread(grid, 0.0016)
    uv = np.column_stack(
        [np.tile(np.concatenate([u, u]), 2), np.tile(np.repeat([0.0, 1.0], 26), 2)]
    )
    front = Solid(front.vertices, front.faces, uv)
    back = limb([(-0.118, 0.02, 0.004), (-0.06, 0.075, 0.006), (0.05, 0.078, 0.006),
                 (0.118, 0.02, 0.004)], [0.02] * 4, 8, squash=0.14)  # fmt: skip
    return put_down([(front, image), (back, textures.plain(tint_color(color, 0.88)))], front, back,
                    factor=k)  # fmt: skip


_L = ("living",)
_D = "lying flat"


CATEGORIES = (
    Category("tinsel", tinsel, (0.319, 0.121, 0.026), 0.03, ("string of tinsel", "tinsel garland",
             "piece of tinsel", "length of tinsel", "christmas garland"), _L, (),
             ("silver", "gold"), state=_D),
    Category("string_lights", string_lights, (0.288, 0.173, 0.0127), 0.08, ("fairy lights",
             "string of lights", "christmas lights", "string of fairy lights",
             "tree lights", "light string",
             "string of christmas lights", "led string lights"), _L, (), ("green",), state=_D),
    Category("bunting", bunting("", True), (0.551, 0.168, 0.00364), 0.03, ("string of bunting",
             "pennant banner", "flag garland", "string of flags", "paper garland", "pennant"), _L,
             ("big",), ("white",), state=_D),
    Category("party_banner", bunting("PARTY!", False), (0.516, 0.152, 0.00381), 0.03,
             ("birthday banner", "banner", "happy birthday banner", "letter banner"), _L,
             ("big",), ("white",), state=_D),
    at_rest(Category("streamer", streamer, (0.324, 0.0443, 0.0688), 0.01, ("paper streamer",
             "party streamer", "roll of streamers", "crepe streamer", "serpentine streamer"), _L,
             (), ("pink",), state=_D)),
    Category("sash", sash, (0.289, 0.18, 0.00865), 0.03, ("birthday sash", "satin sash",
             "pageant sash", "winner's sash"), _L, (), ("pink",), state=_D),
)  # fmt: skip
"""The module's categories."""
