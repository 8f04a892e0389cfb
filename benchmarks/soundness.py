"""Collisions and stability of many scenes by the full criteria, measured on their saved bundles.

    python benchmarks/soundness.py --route generate --seeds 3 --workers 2
    python benchmarks/soundness.py --route compose --texts benchmarks/table78.json --limit 20

A scene is made of every text with seeds 0..n-1, saved, read back, and evaluated by
``generator.evaluation``: Col_O and Col_S on the drawn meshes (Sec. 4.1), and the stability of every
object for 5 s under each of ``VARIANTS``: default, with time steps from 1 to 4 ms, and with gravity
leaning by 2 degrees to four sides. Rows are written to ``soundness_<route>.csv`` as they finish (a
second run resumes), the summary to the corresponding ``.md``.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from posing import tables
from posing.figures import column
from posing.tables import Row

from generator.bundle import load, save
from generator.composition import compose
from generator.evaluation import collisions
from generator.evaluation.soundness import VARIANTS, soundness
from generator.pipeline import generate

HERE = Path(__file__).parent
KEY = ("text", "seed")
LEAST = 5e-5
"""Overlaps up to this depth, metres, are ignored."""
FIELDS = (
    "text", "seed", "published", "planned", "objects", "pairs", "colliding", "sunk", "overlap_mm",
    "floating", "off_table", *(rule.replace(" ", "_") for rule in VARIANTS), "unstable", "seconds",
    "error",
)  # fmt: skip


def work(job: tuple[str, int], route: str) -> list[Row]:
    """Make one scene and measure it; a failure is also a row."""
    text, seed = job
    row: Row = dict.fromkeys(FIELDS, "") | {"text": text, "seed": seed, "published": 0}
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        try:
            if route == "compose":
                path = save(compose(text, seed), folder)
            else:
                path = generate(text, seed=seed).save(folder)
            row["seconds"] = round(time.perf_counter() - start, 2)
            return [row | measure(path)]
        except Exception as error:  # one text must not abort the run
            return [row | {"error": tables.failure(error)}]


def measure(bundle: Path) -> Row:
    """Return the measurements of a saved bundle; for each variant, the number of moving objects."""
    scene = load(bundle)
    hit, touching = collisions(scene), collisions(scene, LEAST)
    depths = [o.depth for o in (*touching.overlaps, *touching.sunk)]
    behaviour = {name: soundness(scene, rule) for name, rule in VARIANTS.items()}
    plain = next(iter(behaviour.values()))
    moving = {n: found.unstable for n, found in behaviour.items() if found.unstable}
    row: Row = {
        "published": 1,
        "planned": len(scene.plan.objects) if scene.plan else "",
        "objects": len(scene.objects),
        "pairs": hit.pairs,
        "colliding": len(hit.overlaps),
        "sunk": len(hit.sunk),
        "overlap_mm": round(1e3 * max(depths, default=0.0), 3),
        "floating": len(plain.floating),
        "off_table": len(plain.off_table),
        "unstable": "; ".join(f"{n}: {', '.join(names)}" for n, names in moving.items()),
    }
    row |= {n.replace(" ", "_"): len(found.unstable) for n, found in behaviour.items()}
    overlaps = [f"{o.a} in {o.b}" for o in (*hit.overlaps, *hit.sunk)]
    floats = [f"{n} floats" for n in plain.floating]
    return row | {"error": "; ".join(overlaps + floats)[:300]}


def say(rows: list[Row]) -> str:
    (row,) = rows
    message = "; ".join(str(row[f]) for f in ("unstable", "error") if row[f])
    return f"{row['text'][:50]!r} seed {row['seed']}: {message or 'sound'}"


def summary(rows: Sequence[Row], route: str, command: str) -> str:
    """Return the table as Markdown."""
    done = [r for r in rows if int(r["published"])]
    objects, pairs = (column(done, f).sum() for f in ("objects", "pairs"))
    colliding, sunk = column(done, "colliding"), column(done, "sunk")
    floating, off = column(done, "floating"), column(done, "off_table")
    deepest = max(column(done, "overlap_mm"), default=0.0)
    rules = {name: column(done, name.replace(" ", "_")) for name in VARIANTS}
    lines = [
        f"# Soundness of {len(rows)} scenes: {route}",
        f"`{command}`, {tables.where()}",
        "",
        "| figure | value |",
        "|---|---|",
        f"| published | {len(done)} / {len(rows)} |",
        f"| objects, pairs | {objects:.0f}, {pairs:.0f} |",
        f"| Col_O, pairs that overlap by more than 0.5 mm | {_share(colliding.sum(), pairs)} |",
        f"| Col_S, scenes with an overlap, the table included | "
        f"{_share(((colliding + sunk) > 0).sum(), len(done))} |",
        f"| deepest overlap, with the table too | {deepest:.2f} mm |",
        f"| objects that float by more than 1 mm | {_share(floating.sum(), objects)} |",
        f"| objects whose centre of mass is beyond the edge | {_share(off.sum(), objects)} |",
        *(f"| stable for 5 s, {name} | {_share(objects - moving.sum(), objects)} |"
          for name, moving in rules.items()),
        f"| scenes without any of these faults | {sum(map(_clean, done))} / {len(rows)} |",
        "",
    ]  # fmt: skip
    faults = [r for r in rows if not int(r["published"]) or not _clean(r)]
    lines += [f"- {say([r])}" for r in faults]
    return "\n".join([*lines, ""])


def _clean(row: Row) -> bool:
    return not row["unstable"] and not row["error"] and not int(row["off_table"] or 0)


def _share(part: float, total: float) -> str:
    return f"{100 * part / max(total, 1):.2f} % ({part:.0f} of {total:.0f})"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--route", choices=("generate", "compose"), default="compose")
    parser.add_argument("--texts", type=Path, default=HERE / "table78.json")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--limit", type=int, default=None, help="only the first N texts")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    tables.alone()
    texts = tables.texts_in(args.texts)[: args.limit]
    args.out.mkdir(parents=True, exist_ok=True)
    path = args.out / f"soundness_{args.route}.csv"
    asked = {(text, str(seed)): (text, seed) for seed in range(args.seeds) for text in texts}
    job = partial(work, route=args.route)
    rows = tables.complete(path, FIELDS, KEY, asked, job, args.workers, say)
    text = summary(rows, args.route, tables.command_line("--workers", "--out"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
