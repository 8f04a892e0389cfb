"""Make the README's pictures anew: ``python docs/make_pictures.py``, after ``make demo``."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from PIL import Image

import assets_cache
from generator.render.sheet import grid

HERE = Path(__file__).parent


def read(path: Path) -> np.ndarray:
    """Return a PNG as RGB pixels."""
    return np.asarray(Image.open(path).convert("RGB"))


def write(picture: np.ndarray, name: str) -> None:
    """Write a picture as small as PNG makes it."""
    target = HERE / "images" / f"{name}.png"
    target.parent.mkdir(exist_ok=True)
    Image.fromarray(picture).save(target, optimize=True)
    print(target)


def main() -> None:
    """Write the four pictures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, default=Path("out"), help="what make demo left")
    args = parser.parse_args()

    figures = args.demo / "text"
    strip = read(args.demo / "text_panda.png")
    panda = strip[:, strip.shape[1] // 3 : strip.shape[1] // 2]
    shown = [read(figures / "fig08_reference.png"), read(figures / "scene_front.png"), panda]
    write(grid(shown, ["drawn from the text", "rebuilt in simulation", "at work"], 3, 420), "hero")
    names = ("fig09_completion", "fig10_canonical_models", "fig11_rotation", "fig13_top_view")
    captions = ["instances (Sec. 3.1)", "models (3.2)", "rotations (3.3, DRO)", "top view (TSA)"]
    write(grid([read(figures / f"{n}.png") for n in names], captions, 2, 560), "stages")
    bundles = assets_cache.find(assets_cache.STARTER)
    previews = [read(path / "preview.png") for path in bundles]
    write(grid(previews, [p.name.rsplit("-", 1)[0] for p in bundles], 5, 240), "starters")
    write(strip, "expert")


if __name__ == "__main__":
    main()
