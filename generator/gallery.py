"""Draw the catalogue: ``python -m generator.gallery OUT.png [category ...]``.

``docs/images/catalogue.png`` is made with ``--page``.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from jaxtyping import UInt8
from PIL import Image, ImageDraw, ImageFont

from tabletop_objects import CATEGORIES, build

from .geometry import Camera
from .render.raster import place, render
from .render.sheet import grid
from .scene import Model, PlannedTable, View
from .tables import LEGS, OUTLINES, build_table

VIEW = View(azimuth=np.deg2rad(-20.0), elevation=np.deg2rad(35.0), fov=np.deg2rad(22.0))


def portrait(model: Model, view: View = VIEW, side: int = 160) -> UInt8[np.ndarray, "h w 3"]:
    """Return a picture of one model on a white floor."""
    reach = float(np.linalg.norm(model.size)) / 2
    target = np.array([0.0, 0.0, model.size[2] / 2])
    camera = Camera.looking_at(target, view, 1.08 * reach / np.sin(view.fov / 2), side, side)
    item = place(model.mesh, model.size, target, np.array([1.0, 0.0, 0.0, 0.0]))
    return render([item], camera, ground_shadow=0.35).image


def draw(keys: Sequence[str], variants: int = 3, side: int = 160) -> UInt8[np.ndarray, "h w 3"]:
    """Return a contact sheet of categories, ``variants`` of each beside each other."""
    cells = [portrait(build(key, seed), side=side) for key in keys for seed in range(variants)]
    names = [CATEGORIES[key].noun if seed == 0 else "" for key in keys for seed in range(variants)]
    return grid(cells, names, columns=4 * variants, cell=side)


def draw_page(
    keys: Sequence[str], looks: int = 4, side: int = 56, columns: int = 5
) -> UInt8[np.ndarray, "h w 3"]:
    """Return a page of the catalogue: each category a strip of ``looks`` over its name."""
    wide, tall = looks * side + 12, side + 18
    rows = -(-len(keys) // columns)
    page = Image.new("RGB", (columns * wide, rows * tall), "white")
    pen, font = ImageDraw.Draw(page), ImageFont.load_default(11)
    for index, key in enumerate(keys):
        x, y = index % columns * wide + 6, index // columns * tall
        for seed in range(looks):
            page.paste(Image.fromarray(portrait(build(key, seed), side=side)), (x + seed * side, y))
        middle = x + looks * side / 2
        pen.text((middle, y + side + 1), CATEGORIES[key].noun, (40, 44, 52), font, anchor="mt")
    return np.asarray(page, np.uint8)


def draw_tables(side: int = 240) -> UInt8[np.ndarray, "h w 3"]:
    """Return a contact sheet of every outline with every leg style, materials in turn."""
    materials = ("oak", "walnut", "pine", "white", "black", "marble", "glass", "metal", "teal")
    cells, names = [], []
    for i, outline in enumerate(OUTLINES):
        size = (0.9, 0.9, 0.74) if outline in ("round", "square") else (1.2, 0.8, 0.74)
        for j, legs in enumerate(LEGS):
            material = materials[(i * len(LEGS) + j) % len(materials)]
            plan = PlannedTable(outline, material, legs, size)  # type: ignore[arg-type]
            cells.append(portrait(build_table(plan, i + j), side=side))
            names.append(f"{outline}, {legs}, {material}")
    return grid(cells, names, columns=len(LEGS), cell=side)


def main() -> None:
    """Write the contact sheet of categories, of all tables, or the page the docs show."""
    parser = argparse.ArgumentParser(description="Draw a contact sheet of the catalogue.")
    parser.add_argument("out", type=Path, help="PNG to write")
    parser.add_argument("keys", nargs="*", help='categories, or "tables"; default: everything')
    parser.add_argument("--page", action="store_true", help="four small looks each, few colours")
    chosen = parser.parse_args()
    if chosen.page:
        page = Image.fromarray(draw_page(chosen.keys or sorted(CATEGORIES)))
        few = page.quantize(160, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
        few.save(chosen.out, optimize=True)
        return
    only_tables = chosen.keys == ["tables"]
    picture = draw_tables() if only_tables else draw(chosen.keys or list(CATEGORIES))
    if not chosen.keys:
        tables = draw_tables()
        wide = max(picture.shape[1], tables.shape[1])
        picture = np.concatenate(
            [
                np.pad(p, ((0, 0), (0, wide - p.shape[1]), (0, 0)), constant_values=255)
                for p in (picture, tables)
            ]
        )
    Image.fromarray(picture).save(chosen.out)


if __name__ == "__main__":
    main()
