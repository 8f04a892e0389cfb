"""Turn a sentence into a simulated table.

python examples/text_to_scene.py "a craft desk with two paint bottles and a toy car" --out out/text
"""

from __future__ import annotations

import argparse
from pathlib import Path

from generator.pipeline import generate


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("text", nargs="?", default="a desk with a laptop, a mug and two pens")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("out/text"))
    args = parser.parse_args()

    generation = generate(args.text, seed=args.seed, progress=lambda s, i, n: print(f"{i}/{n} {s}"))
    generation.save_figures(args.out / "figures")
    print("bundle:", generation.save(args.out))
    for thing in generation.scene.objects:
        x, y, z = thing.pose.position
        print(f"{thing.name:<20} {thing.mass:6.3f} kg at ({x:+.2f}, {y:+.2f}, {z:.2f}) m")


if __name__ == "__main__":
    main()
