"""Turn one picture of a tabletop into a simulated table.

python examples/image_to_scene.py desk.png --out out/image
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from PIL import Image

from generator.pipeline import generate
from generator.render.sheet import grid, render_scene


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", type=Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("out/image"))
    args = parser.parse_args()

    generation = generate(args.picture, seed=args.seed)
    bundle = generation.save(args.out)
    rebuilt = render_scene(generation.scene).image
    pair = grid([np.asarray(generation.reference.image), rebuilt], ["picture", "simulated"], 2, 640)
    Image.fromarray(pair).save(args.out / "side_by_side.png")
    print("bundle:", bundle)


if __name__ == "__main__":
    main()
