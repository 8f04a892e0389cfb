"""Make the README's pictures anew: ``python docs/make_pictures.py``, after ``make demo``.

``--only edits`` makes the one of edited scenes alone, which needs no demo.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from PIL import Image

import assets_cache
from generator import editing
from generator.backends import Backends
from generator.bundle import load
from generator.figures import preview
from generator.render.sheet import grid

HERE = Path(__file__).parent

SWAPS = (
    ("office-desk", "mug_1", "a potted plant"),
    ("dining-fruit", "vase_1", "a teapot"),
    ("workbench", "hammer_1", "a cordless drill"),
    ("coffee-square", "candle_1", "a cake"),
    ("vanity", "hand_mirror_1", "a hairbrush"),
)
"""Starter, what goes, what comes."""


def read(path: Path) -> np.ndarray:
    """Return a PNG as RGB pixels."""
    return np.asarray(Image.open(path).convert("RGB"))


def write(picture: np.ndarray, name: str) -> None:
    """Write a picture as small as PNG makes it."""
    target = HERE / "images" / f"{name}.png"
    target.parent.mkdir(exist_ok=True)
    Image.fromarray(picture).save(target, optimize=True)
    print(target)


def edits() -> np.ndarray:
    """Return starters above, and below them what the embedded backend makes of their edits."""
    before, after, captions = [], [], []
    for name, old, text in SWAPS:
        (bundle,) = assets_cache.find(name)
        before.append(preview(load(bundle)))
        edited = editing.swap(bundle, old, text, backends=Backends.select("embedded"))
        after.append(preview(edited.scene))
        captions.append(f"{old} -> {text}")
    return grid([*before, *after], [*(name for name, _, _ in SWAPS), *captions], len(SWAPS), 330)


def main() -> None:
    """Write the pictures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demo", type=Path, default=Path("out"), help="what make demo left")
    parser.add_argument("--only", choices=("edits",), help="this picture alone")
    args = parser.parse_args()

    write(edits(), "edits")
    if args.only:
        return
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
