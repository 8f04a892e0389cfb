"""Sheets of the same pictures from several versions, side by side.

    tabletopgen compare out/old/scene --out sheets/before/scene.png
    tabletopgen compare out/new/scene --out sheets/after/scene.png
    python benchmarks/side_by_side.py sheets/before sheets/after --out benchmarks/results/sheets

Every PNG that exists in all folders becomes a JPEG with the first folder's picture on the left.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from generator.errors import InputError

_LINE = 26


def join(paths: list[Path], width: int) -> Image.Image:
    """Return pictures side by side, each ``width`` pixels wide, under its folder's name."""
    pictures = []
    for path in paths:
        with Image.open(path) as opened:
            picture = opened.convert("RGB")
        pictures.append(picture.resize((width, round(picture.height * width / picture.width))))
    height = max(picture.height for picture in pictures)
    sheet = Image.new("RGB", (len(paths) * width, height + _LINE), "white")
    draw = ImageDraw.Draw(sheet)
    for k, (path, picture) in enumerate(zip(paths, pictures, strict=True)):
        draw.text((k * width + 6, 3), path.parent.name, "black", ImageFont.load_default(18))
        sheet.paste(picture, (k * width, _LINE))
    return sheet


def main() -> None:
    """Parse the command line and write the sheets."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("folders", type=Path, nargs="+", help="of sheets with the same names")
    parser.add_argument("--out", type=Path, required=True, help="folder of the JPEGs")
    parser.add_argument("--width", type=int, default=800, help="width of each picture, pixels")
    args = parser.parse_args()
    first, *others = args.folders
    names = sorted(
        p.name for p in first.glob("*.png") if all((other / p.name).is_file() for other in others)
    )
    if not names:
        raise InputError(f"No PNG is in all of {', '.join(map(str, args.folders))}.")
    args.out.mkdir(parents=True, exist_ok=True)
    for name in names:
        sheet = join([folder / name for folder in args.folders], args.width)
        sheet.save(args.out / Path(name).with_suffix(".jpg"), quality=80)
    print(f"{len(names)} sheets in {args.out}")


if __name__ == "__main__":
    main()
