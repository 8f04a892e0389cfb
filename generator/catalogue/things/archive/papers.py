"""Sheets of paper with something printed on them, and the inks."""

from __future__ import annotations

from collections.abc import Callable

from ...build.making import Drawing, at_box
from ...build.recipes import Pieces
from ...surfaces import prints, textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look

INK: RGB = (62, 62, 70)
GRAY: RGB = (140, 140, 146)

Print = Callable[[Look, prints.Canvas, RGB], None]
"""What prints one paper, in its accent colour."""


def paper(
    x: float, y: float, mark: Print, *grounds: str, sheets: int = 1, accents: tuple[str, ...] = ()
) -> Drawing:
    """A sheet, or a few askew, of ``x`` by ``y`` metres, printed by ``mark``."""

    def draw(look: Look) -> Pieces:
        ground = look.color(*grounds)
        accent = look.own_color(*(accents or ("navy", "crimson", "green", "teal", "maroon")))
        wide = 128 if y >= x else 176
        image = prints.canvas(wide, round(min(max(wide * y / x, 32), 250)), ground)
        mark(look, image, accent)
        h = 0.0011
        pieces: Pieces = []
        for k in range(sheets - 1):
            turn = look.between(-0.06, 0.06)
            pieces.append(
                (
                    at_box(x, y, h).turn(2, turn).move(0.004 * k, -0.003 * k, h * k),
                    textures.plain(ground),
                )
            )
        return [*pieces, (at_box(x, y, h, (0, 0, h * (sheets - 1))), image)]

    return draw
