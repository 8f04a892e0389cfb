"""A contact sheet of numbered scenes with their texts, for blind ratings from 1 to 5."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

WIDTH, GAP, LINE, COLUMNS = 480, 16, 18, 3
"""Pixels of a picture, between pictures and of a line of text; scenes per row."""
SIGNS = 62
"""Characters of a line below a picture."""


@dataclass(frozen=True)
class SheetEntry:
    """A scene of the sheet; its bundle is None if none was made."""

    text: str
    bundle: Path | None


def contact_sheet(entries: Sequence[SheetEntry]) -> Image.Image:
    """Return the previews, with top views below them if available, and the texts."""
    cells = [_cell(number, entry) for number, entry in enumerate(entries, start=1)]
    rows = [cells[k : k + COLUMNS] for k in range(0, len(cells), COLUMNS)]
    heights = [max(c.height for c in line) for line in rows]
    wide = COLUMNS * (WIDTH + GAP) + GAP
    sheet = Image.new("RGB", (wide, sum(heights) + GAP * (len(rows) + 1)), "white")
    down = GAP
    for line, height in zip(rows, heights, strict=True):
        for k, cell in enumerate(line):
            sheet.paste(cell, (GAP + k * (WIDTH + GAP), down))
        down += height + GAP
    return sheet


def _cell(number: int, entry: SheetEntry) -> Image.Image:
    pictures = [_fit(p) for name in ("preview.png", "top_view.png") if (p := _of(entry, name))]
    paragraphs = f"{number}. {entry.text}".splitlines()
    lines = [line for p in paragraphs for line in textwrap.wrap(p, SIGNS) or [""]]
    if not pictures:
        lines.append("(no scene)")
    tall = sum(p.height for p in pictures)
    cell = Image.new("RGB", (WIDTH, tall + LINE * (len(lines) + 1)), "white")
    down = 0
    for picture in pictures:
        cell.paste(picture, (0, down))
        down += picture.height
    pen, font = ImageDraw.Draw(cell), ImageFont.load_default(14)
    for k, line in enumerate(lines):
        pen.text((2, down + 4 + k * LINE), line, fill="black", font=font)
    return cell


def _of(entry: SheetEntry, name: str) -> Path | None:
    path = entry.bundle / name if entry.bundle else None
    return path if path and path.exists() else None


def _fit(path: Path) -> Image.Image:
    with Image.open(path) as picture:
        height = round(picture.height * WIDTH / picture.width)
        return picture.convert("RGB").resize((WIDTH, height), Image.Resampling.LANCZOS)
