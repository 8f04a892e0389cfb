"""Make the README's pictures anew.

python examples/readme_pictures.py --out docs/images
"""

from __future__ import annotations

import argparse
from pathlib import Path

import cv2
import numpy as np
from demo import TEXT
from expert import film_strip, play_until_solved
from PIL import Image

from assets_cache import store
from generator.figures import preview
from generator.pipeline import generate
from generator.render.sheet import grid

WIDTH = 1260
TRIES = 8


def across(images: list[np.ndarray], width: int = WIDTH) -> np.ndarray:
    """Lay pictures side by side at one height, ``width`` pixels in all."""
    shares = np.array([image.shape[1] / image.shape[0] for image in images])
    height = round(width / float(shares.sum()))
    ends = np.round(np.cumsum(shares) / shares.sum() * width).astype(int)
    cells = [
        cv2.resize(image, (int(side), height), interpolation=cv2.INTER_AREA)
        for image, side in zip(images, np.diff(ends, prepend=0), strict=True)
    ]
    return np.concatenate(cells, axis=1)


def at_work(scenes: str, size: tuple[int, int]) -> list[np.ndarray]:
    """Return pictures of the first episode that the expert solves."""
    success, _, frames = play_until_solved(scenes, TRIES, size)
    if not success:
        raise SystemExit(f"The expert solved none of {TRIES} episodes on {scenes}.")
    return frames


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out/readme"))
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)

    made = generate(TEXT, seed=0, name="hero")
    bundle = made.save(args.out / "scenes")
    frames = at_work(str(bundle), (720, 960))
    drawn = np.asarray(made.reference.image)
    pictures = {"hero": across([drawn, preview(made.scene), frames[len(frames) // 3]])}

    figures = {path.stem: path for path in made.save_figures(args.out / "stages")}
    stages = ("fig09_completion", "fig10_canonical_models", "fig11_rotation", "fig13_top_view")
    parts = [np.asarray(Image.open(figures[stem]).convert("RGB")) for stem in stages]
    pictures["stages"] = np.concatenate([across(parts[:2]), across(parts[2:])])

    starters = store.find("starter")
    shown = [np.asarray(Image.open(path / "preview.png").convert("RGB")) for path in starters]
    names = [path.name.rpartition("-")[0] for path in starters]
    pictures["starters"] = grid(shown, names, columns=5, cell=240)
    pictures["expert"] = film_strip(at_work("starter", (240, 320)))

    for name, picture in pictures.items():
        Image.fromarray(picture).save(args.out / f"{name}.png", optimize=True)
        print(args.out / f"{name}.png")


if __name__ == "__main__":
    main()
