"""End-to-end demo: a text and a picture become bundles, and the Panda moves an object on each.

``make demo`` runs it. It writes the bundles, the pictures and ``report.md`` to ``out/``.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np
from expert import film_strip, play_until_solved
from PIL import Image

from generator.errors import TabletopError
from generator.generation import Generation
from generator.method.figures import preview
from generator.pipeline import generate
from generator.render.sheet import grid

HERE = Path(__file__).parent
TEXT = "a craft desk with a toy car, a red mug, two paint bottles, a bowl and an orange"
PICTURE = HERE / "pictures" / "coffee_table.png"
TRIES = 5


def build(name: str, source: str | Path, out: Path) -> tuple[Generation, Path, float]:
    """Generate one scene, publish it and write its pictures."""
    start = time.perf_counter()
    generation = generate(
        source, seed=0, name=name, progress=lambda stage, k, n: print(f"  [{k}/{n}] {stage}")
    )
    bundle = generation.save(out / "scenes")
    generation.save_figures(out / name)
    pair = [np.asarray(generation.reference.image), preview(generation.scene)]
    Image.fromarray(grid(pair, ["reference", "simulated"], 2, 640)).save(out / f"{name}.png")
    return generation, bundle, time.perf_counter() - start


def move_something(bundle: Path, strip: Path) -> str:
    """Run the expert on a few targets of one bundle; return a line for the report."""
    success, instruction, frames = play_until_solved(str(bundle), TRIES)
    Image.fromarray(film_strip(frames)).save(strip)
    if success:
        return f'the Panda did "{instruction}" in {(len(frames) - 1) / 20:.1f} s'
    return f"the Panda did not succeed in {TRIES} tries"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out"))
    parser.add_argument("--only", choices=("text", "picture"), help="one of the two")
    parser.add_argument("--text", default=TEXT)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)

    lines = ["# Demo", ""]
    sources = {"text": args.text, "picture": PICTURE}
    for name in (args.only,) if args.only else sources:
        source = sources[name]
        print(f"{name}: {source}")
        try:
            generation, bundle, seconds = build(name, source, args.out)
            report = generation.scene.report
            assert report is not None
            moved = move_something(bundle, args.out / f"{name}_panda.png")
        except TabletopError as error:
            raise SystemExit(f"error: {error}") from error
        shown = source if isinstance(source, str) else source.name
        lines += [
            f"## {name}: {shown}",
            f"- {len(generation.scene.objects)} objects in {seconds:.0f} s: "
            + ", ".join(o.name for o in generation.scene.objects),
            f"- gate: deepest overlap {1e3 * report.penetration:.2f} mm, drift in "
            f"{report.seconds:.0f} s {1e3 * report.drift:.2f} mm, "
            + ("passed" if report.passed else f"failed: {report.failure_text}"),
            f"- {moved}",
            f"- bundle `{bundle.name}`; pictures `{name}.png`, `{name}_panda.png`, `{name}/`",
            "",
        ]
        print("  " + moved)
    (args.out / "report.md").write_text("\n".join(lines))
    print(f"report: {args.out / 'report.md'}")


if __name__ == "__main__":
    main()
