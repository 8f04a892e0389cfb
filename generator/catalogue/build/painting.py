"""The colour that a text asks for, on things that are drawn in colours of their own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...scene.triangles import areas
from ..surfaces.colors import RGB, rgb
from ..surfaces.textures import Tile
from .shape import Piece, Shape

_LEAST = 0.25
"""Share of the surface that shows the colour asked for."""

_GREY = 20.0
"""How far a colour of no hue is from grey, RGB from 0 to 255."""

_CLOSE = 60.0
"""How much lighter or darker a grey is that is called alike."""

_ALIKE = 0.85
"""Cosine of the angle between the hues of colours that are called alike."""

_STRONG = 0.35
"""Least strength of a colour, in those of the one that it is called like."""

_CONTRAST = 0.6
"""How much of a tile's light and dark is kept where it is painted over."""


def show_color(made: Shape, word: str) -> Shape:
    """Return a shape that shows a colour: where too little of it does, the largest tile is painted.

    A word that is no colour changes nothing.
    """
    asked = rgb(word)
    if asked is None:
        return made
    tiles = {piece.tile.tobytes(): piece.tile for piece in made.pieces}
    shown = dict.fromkeys(tiles, 0.0)
    for piece in made.pieces:
        solid = piece.solid
        shown[piece.tile.tobytes()] += float(areas(solid.vertices, solid.faces).sum())
    seen = sum(area * _share(tiles[key], asked) for key, area in shown.items())
    if seen >= _LEAST * sum(shown.values()):
        return made
    largest = max(shown, key=lambda key: shown[key])
    paint = _paint(tiles[largest], asked)
    return replace(
        made,
        pieces=tuple(
            Piece(p.solid, paint) if p.tile.tobytes() == largest else p for p in made.pieces
        ),
    )


def _share(tile: Tile, color: RGB) -> float:
    """Return the share of a tile that is about of a colour, lighter and darker ones included."""
    pixels, asked = tile.reshape(-1, 3).astype(float), np.array(color)
    tones, tone = pixels - pixels.mean(1, keepdims=True), asked - asked.mean()
    strength, wanted = np.linalg.norm(tones, axis=1), float(np.linalg.norm(tone))
    if wanted < _GREY:
        near = np.abs(pixels.mean(1) - asked.mean()) < _CLOSE
        return float((near & (strength < 2 * _GREY)).mean())
    alike = tones @ tone > _ALIKE * strength * wanted
    return float((alike & (strength > _STRONG * wanted)).mean())


def _paint(tile: Tile, color: RGB) -> Tile:
    light = tile.astype(float).mean(-1, keepdims=True)
    shade = 1 + _CONTRAST * (light / max(float(light.mean()), 1.0) - 1)
    return np.clip(np.array(color) * shade, 0, 255).round().astype(np.uint8)
