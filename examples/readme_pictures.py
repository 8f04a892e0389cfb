"""Make all pictures of the README, or selected ones.

python examples/readme_pictures.py [NAME ...] --out docs/images
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

import cv2
import numpy as np
from demo import TEXT
from expert import film_strip, play_until_solved
from PIL import Image

from assets_cache import store
from generator import editing
from generator.backends import Backends
from generator.bundle import load
from generator.composition import compose
from generator.method.figures import preview
from generator.pipeline import generate
from generator.render.sheet import grid

WIDTH = 1260
TRIES = 8

SWAPS = (
    ("office-desk", "mug_1", "a potted plant"),
    ("dining-fruit", "vase_1", "a teapot"),
    ("workbench", "hammer_1", "a cordless drill"),
    ("coffee-square", "candle_1", "a cake"),
    ("vanity", "hand_mirror_1", "a hairbrush"),
)
"""For the picture of edits: starter, removed object, new object."""


TABLES = (
    "a kitchen counter with a cutting board with vegetables, a chef's knife, a stand mixer, a bowl "
    "of eggs, a rolling pin, spice jars and a kettle",
    "a crowded workbench with a drill, a hammer, pliers, screwdrivers, a tape measure, a toolbox, "
    "a paint can, a vise and a box of screws",
    "a messy office desk with a laptop, a desk lamp, a mug with pencils, a stack of books, "
    "headphones, a potted plant, sticky notes and a camera",
)
"""For the picture of composed tables."""


def across(images: list[np.ndarray], width: int = WIDTH) -> np.ndarray:
    """Arrange pictures side by side at one height, ``width`` pixels in total."""
    shares = np.array([image.shape[1] / image.shape[0] for image in images])
    height = round(width / float(shares.sum()))
    ends = np.round(np.cumsum(shares) / shares.sum() * width).astype(int)
    cells = [
        cv2.resize(image, (int(side), height), interpolation=cv2.INTER_AREA)
        for image, side in zip(images, np.diff(ends, prepend=0), strict=True)
    ]
    return np.concatenate(cells, axis=1)


def at_work(scenes: str, size: tuple[int, int]) -> list[np.ndarray]:
    """Return frames of the first episode that the expert solves."""
    success, _, frames = play_until_solved(scenes, TRIES, size)
    if not success:
        raise SystemExit(f"The expert solved none of {TRIES} episodes on {scenes}.")
    return frames


def read(path: Path) -> np.ndarray:
    """Return a picture as RGB pixels."""
    return np.asarray(Image.open(path).convert("RGB"))


def generate_pictures(text: str, out: Path) -> dict[str, np.ndarray]:
    """Return pictures of a text's drawing, scene, expert episode, and stages of the method."""
    made = generate(text, seed=0, name="hero")
    bundle = made.save(out / "scenes")
    frames = at_work(str(bundle), (720, 960))
    drawn = np.asarray(made.reference.image)
    figures = {path.stem: path for path in made.save_figures(out / "stages")}
    stages = ("fig09_completion", "fig10_canonical_models", "fig11_rotation", "fig13_top_view")
    parts = [read(figures[stem]) for stem in stages]
    return {
        "hero": across([drawn, preview(made.scene), frames[len(frames) // 3]]),
        "stages": np.concatenate([across(parts[:2]), across(parts[2:])]),
    }


def starters(text: str, out: Path) -> dict[str, np.ndarray]:
    """Return the previews of the starters, each with its name."""
    bundles = store.find("starter")
    names = [path.name.rpartition("-")[0] for path in bundles]
    shown = [read(path / "preview.png") for path in bundles]
    return {"starters": grid(shown, names, columns=5, cell=240)}


def tables(text: str, out: Path) -> dict[str, np.ndarray]:
    """Return three composed tables side by side."""
    scenes = [compose(each, seed=3, density="dense") for each in TABLES]
    return {"tables": across([preview(scene) for scene in scenes])}


def expert(text: str, out: Path) -> dict[str, np.ndarray]:
    """Return a film strip of the expert at a starter."""
    return {"expert": film_strip(at_work("starter", (240, 320)))}


def edits(text: str, out: Path) -> dict[str, np.ndarray]:
    """Return starters in a row above the results of their edits by the embedded backend."""
    before, after, captions = [], [], []
    for name, old, new in SWAPS:
        (bundle,) = store.find(name)
        before.append(preview(load(bundle)))
        edited = editing.swap(bundle, old, new, backends=Backends.select("embedded"))
        after.append(preview(edited.scene))
        captions.append(f"{old} -> {new}")
    titles = [*(name for name, _, _ in SWAPS), *captions]
    return {"edits": grid([*before, *after], titles, len(SWAPS), 330)}


PICTURES: Mapping[str, Callable[[str, Path], Mapping[str, np.ndarray]]] = MappingProxyType(
    {
        "tables": tables,
        "generated": generate_pictures,
        "starters": starters,
        "expert": expert,
        "edits": edits,
    }
)
"""Available pictures by name; "generated" makes two, hero and stages."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(PICTURES)}")
    parser.add_argument("--text", default=TEXT, help="what is generated")
    parser.add_argument("--out", type=Path, default=Path("out/readme"))
    args = parser.parse_args()
    if unknown := sorted({*args.names} - {*PICTURES}):
        parser.error(f"There is no picture {unknown[0]!r}; valid names are {', '.join(PICTURES)}.")
    args.out.mkdir(parents=True, exist_ok=True)
    for kind in args.names or PICTURES:
        for name, picture in PICTURES[kind](args.text, args.out).items():
            Image.fromarray(picture).save(args.out / f"{name}.png", optimize=True)
            print(args.out / f"{name}.png")


if __name__ == "__main__":
    main()
