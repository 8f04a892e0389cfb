"""Objects of the ``vanity`` theme: gemstones."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.outlines import ellipse, lift
from ...kit.primitives import ball, hull_solid
from ...kit.shapes import Category, Drawing, Pieces, at_rest, category, from_pieces, vary
from ...kit.solids import Solid
from ...kit.surfaces import RGB, Look, tint_color


def _shade(look: Look, body: Solid, color: RGB) -> Pieces:
    """Return a solid whose faces have different shades of ``color``."""
    faces = body.faces
    a, b, c = body.vertices[faces].transpose(1, 0, 2)
    normal = np.cross(b - a, c - a).round(9)
    up = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    group = (np.abs(up @ np.array([3.1, 5.3, 2.2])) * 3.7).astype(int) % 4
    tones = [tint_color(color, f) for f in (0.6, 0.9, 1.15, 1.5)]
    tile = np.zeros((8, 32, 3))
    for k in range(4):
        tile[:, 8 * k : 8 * k + 8] = tones[k]
    uv = np.repeat((group + 0.5) / 4, 3)
    spread = np.column_stack([uv, np.full(len(uv), 0.5)])
    return [(Solid(body.vertices, body.faces, spread), tile.astype(np.uint8))]


def _brilliant() -> np.ndarray:
    r = 0.5
    table = lift(ellipse(1.1 * r, 1.1 * r, 8, np.pi / 8), 0.16)
    crown = lift(ellipse(1.55 * r, 1.55 * r, 8), 0.09)
    girdle = [lift(ellipse(2 * r, 2 * r, 16), z) for z in (0.02, -0.01)]
    lower = lift(ellipse(0.44, 0.44, 8, np.pi / 8), -0.23)
    return np.concatenate([table, crown, *girdle, lower, [(0, 0, -0.43)]])


def _step() -> np.ndarray:
    rows = [(0.6, 0.14), (0.85, 0.08), (1.0, 0.01), (1.0, -0.02), (0.68, -0.13), (0.32, -0.24)]
    made = []
    for s, z in rows:
        x, y, c = 0.5 * s, 0.36 * s, 0.11 * s
        corners = [(x - c, -y), (x, -y + c), (x, y - c), (x - c, y), (-x + c, y), (-x, y - c),
                   (-x, -y + c), (-x + c, -y)]  # fmt: skip
        made.append(lift(np.array(corners), z))
    return np.concatenate(made)


def _oval() -> np.ndarray:
    return _brilliant() * [1.0, 0.76, 0.9]


def _drop() -> np.ndarray:
    p = _brilliant()
    point = np.where(p[:, 0] > 0, 1.35, 1.0)
    return np.column_stack(
        [p[:, 0] * point, p[:, 1] * (1 - 0.35 * np.maximum(p[:, 0], 0)), p[:, 2]]
    )


_CUTS: tuple[Callable[[], np.ndarray], ...] = (_brilliant, _step, _oval, _drop)


def _cut(*cuts: int, colors: tuple[str, ...], size: float = 0.018) -> Drawing:
    """A cut stone lying on one of its lower facets."""

    def draw(look: Look) -> Pieces:
        points = _CUTS[look.pick(cuts)]() * size
        body = hull_solid(points)
        return _shade(look, _tilt(body), look.color(*colors))

    return draw


def _tilt(body: Solid) -> Solid:
    """Return a cut stone at rest, tilted onto a facet of its underside."""
    v, f = body.vertices, body.faces
    cross = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
    size = np.linalg.norm(cross, axis=1)
    normal = cross / size[:, None]
    lower = (normal[:, 2] < -0.3) & (normal[:, 2] > -0.98)
    n = normal[int(np.argmax(np.where(lower, size, 0)))]
    made = body.turn(2, -float(np.arctan2(n[1], n[0])))
    made = made.turn(1, float(np.arctan2(np.hypot(n[0], n[1]), -n[2])))
    return made.move(z=-float(made.bounds[0, 2]))


def _dome(colors: tuple[str, ...], size: float, vein: float = 0.0) -> Drawing:
    """A polished stone with a domed top."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        body = ball(size, 0.75 * size, 0.8 * size, (0, 0, 0.1 * size), 20)
        if vein == 0:
            return [(body, surfaces.gradient(color, tint_color(color, 1.35), look.rng))]
        other = tint_color(color, vein)
        return [(body, surfaces.stripes([color, tint_color(color, 0.8), other, color], 2))]

    return draw


def _tumbled_stone(colors: tuple[str, ...], vein: float | None, size: float = 0.028) -> Drawing:
    """A small polished stone, rounded all over."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        swell = look.rng.uniform(0, 6.28, 2)

        def warp(p: np.ndarray) -> np.ndarray:
            a = np.arctan2(p[:, 1], p[:, 0])
            f = 1 + 0.1 * np.sin(2 * a + swell[0]) + 0.07 * np.sin(3 * a + swell[1])
            return p * np.column_stack([f, f, np.ones(len(p))])

        body = ball(size, 0.78 * size, 0.6 * size, (0, 0, 0), 18).bend(warp).move(z=0.26 * size)
        skin = (surfaces.speckles(look.rng, color, 9) if vein is None else
                surfaces.marble(look.rng, color, tint_color(color, vein)))  # fmt: skip
        return [(body, skin)]

    return draw


@category("pearl", size=(0.012, 0.012, 0.0115), mass=0.002, material="stone",
          aliases=("single pearl", "loose pearl"), themes=("vanity",), colors=("ivory",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.05)
def pearl(look: Look) -> Pieces:
    """A single round pearl, paler towards its top."""
    color = look.color("ivory", "white", "cream", "pink")
    return [(ball(0.012, 0.012, 0.012, (0, 0, 0.0057), 20),
             surfaces.gradient(tint_color(color, 0.9), tint_color(color, 1.3),
             look.rng))]  # fmt: skip


CATEGORIES = (
    Category("gemstone", from_pieces()(_cut(0, 1, 2, 3, colors=("red", "green", "blue", "purple",
             "clear", "amber", "pink"))), size=(0.0108, 0.018, 0.0103), mass=0.004,
             material="stone", aliases=("gem", "cut gem", "cut gemstone", "precious stone", "jewel",
             "faceted gem", "cut stone", "cut crystal"), themes=("vanity",),
             colors=("red", "green"), state="lying"),
    Category("diamond", vary()(from_pieces()(_cut(0, colors=("clear",)))),
             size=(0.0108, 0.018, 0.0103), mass=0.004, material="stone",
             aliases=("cut diamond", "brilliant", "rhinestone", "zircon"), themes=("vanity",),
             colors=("clear",), state="lying"),
    Category("ruby", vary()(from_pieces()(_cut(2, 1, colors=("crimson",)))),
             size=(0.0108, 0.018, 0.0103), mass=0.004, material="stone",
             aliases=("cut ruby", "spinel"), themes=("vanity",), colors=("crimson",),
             state="lying"),
    Category("emerald", at_rest(from_pieces()(_cut(1, colors=("green",)))),
             size=(0.0126, 0.0182, 0.0073), mass=0.004, material="stone",
             aliases=("cut emerald", "beryl", "peridot", "tourmaline"), themes=("vanity",),
             colors=("green",), state="lying"),
    Category("sapphire", from_pieces()(_cut(2, 0, colors=("blue",))), size=(0.0108, 0.018, 0.0103),
             mass=0.004, material="stone", aliases=("cut sapphire", "tanzanite"),
             themes=("vanity",), colors=("blue",), state="lying"),
    Category("topaz", at_rest(from_pieces()(_cut(1, 3, colors=("amber", "yellow")))),
             size=(0.0108, 0.018, 0.0103), mass=0.004, material="stone",
             aliases=("cut topaz", "citrine", "yellow topaz"), themes=("vanity",),
             colors=("amber", "yellow"), state="lying"),
    Category("garnet", from_pieces()(_cut(0, 2, colors=("maroon",))), size=(0.0108, 0.018, 0.0103),
             mass=0.004, material="stone", aliases=("cut garnet",), themes=("vanity",),
             colors=("maroon",), state="lying"),
    Category("aquamarine", at_rest(from_pieces()(_cut(1, 3, colors=("sky",)))),
             size=(0.0108, 0.018, 0.0103), mass=0.004, material="stone",
             aliases=("cut aquamarine", "blue topaz"), themes=("vanity",), colors=("sky",),
             state="lying"),
    Category("opal", from_pieces()(_dome(("white", "mint"), 0.018)), size=(0.0185, 0.0139, 0.00924),
             mass=0.004, material="stone", aliases=("moonstone", "cabochon"), themes=("vanity",),
             colors=("white",), state="lying"),
    Category("tigers_eye", from_pieces()(_dome(("amber", "bronze"), 0.026, 1.5)),
             size=(0.026, 0.0195, 0.013), mass=0.012, material="stone",
             aliases=("tiger eye", "tiger eye stone", "cat eye stone"), themes=("vanity",),
             colors=("amber",), state="lying"),
    Category("jade", from_pieces(foot=0.06)(_tumbled_stone(("green", "sage"), 1.5)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("jade stone", "piece of jade", "aventurine", "green stone"),
             themes=("vanity",), colors=("green", "sage"), state="lying"),
    Category("turquoise_stone", from_pieces(foot=0.06)(_tumbled_stone(("turquoise",), 0.35)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("turquoise nugget", "piece of turquoise"), themes=("vanity",),
             colors=("turquoise",), state="lying"),
    Category("onyx", from_pieces(foot=0.06)(_tumbled_stone(("black",), 1.6)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("onyx stone", "black stone", "agate"), themes=("vanity",), colors=("black",),
             state="lying"),
    Category("jasper", from_pieces(foot=0.06)(_tumbled_stone(("terracotta", "crimson"), 0.5)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("jasper stone", "carnelian", "tumbled stone", "red stone", "polished stone"),
             themes=("vanity",), colors=("terracotta", "crimson"), state="lying"),
    Category("labradorite", from_pieces(foot=0.06)(_tumbled_stone(("charcoal",), 1.3)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("haematite stone", "labradorite stone"), themes=("vanity",),
             colors=("charcoal",), state="lying"),
    Category("rhodochrosite", from_pieces(foot=0.06)(_tumbled_stone(("pink",), 1.8)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("rhodonite", "pink stone"), themes=("vanity",), colors=("pink",),
             state="lying"),
    Category("amber", from_pieces(foot=0.06)(_tumbled_stone(("amber",), None)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone", aliases=("amber piece",
             "piece of amber", "amber stone", "insect in amber", "lump of amber"),
             themes=("vanity",), colors=("amber",), state="lying"),
    Category("lapis_lazuli", from_pieces(foot=0.06)(_tumbled_stone(("blue", "navy"), 1.5)),
             size=(0.029, 0.022, 0.016), mass=0.015, material="stone",
             aliases=("lapis", "lapis stone", "sodalite", "azurite"), themes=("vanity",),
             colors=("blue", "navy"), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
