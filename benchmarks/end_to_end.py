"""Texts to published scenes, by both routes: physical validity, counts, names, seconds.

    python benchmarks/end_to_end.py --route generate --seeds 3 --out benchmarks/results
    python benchmarks/end_to_end.py --texts benchmarks/table78.json --seeds 1

Reads a list of texts (``benchmarks/texts.json``), or of objects with a "text", runs each with seeds
0..n-1 and writes one row per scene to ``<route>.csv`` (a second run resumes), then a summary table
to ``<route>.md``; for other texts the file's name is appended: ``<route>_table78``. "named" counts
the planned objects whose category matches a rebuilt object's word; "unseen" counts the objects that
were not visible in the drawing and that the plan supplied. All figures are measured on the *saved
bundle*, simulated in plain MuJoCo from its ``scene.xml``: nothing is taken from the pipeline's
report.
"""

from __future__ import annotations

import argparse
import csv
import datetime
import os
import platform
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from posing.tables import texts_in

if TYPE_CHECKING:
    from generator.scene import Scene

HERE = Path(__file__).parent
FIELDS = (
    "text", "seed", "published", "planned", "built", "penetration_mm", "drift_mm", "tilt_deg",
    "floating", "fallen", "seconds", "error", "named",
    "unseen",
)  # fmt: skip


def measure(bundle: Path, seconds: float = 2.0) -> dict[str, Any]:
    """Simulate a bundle's ``scene.xml`` and return its physical measurements."""
    import mujoco

    from generator.bundle import load_verified

    load_verified(bundle)  # the file contains the same values
    model = mujoco.MjModel.from_xml_path(str(bundle / "scene.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    depth = max((-float(c.dist) for c in data.contact), default=0.0)
    free = [b for b in range(1, model.nbody) if model.body_dofnum[b] == 6]
    start, turned = data.xpos[free].copy(), data.xquat[free].copy()
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
    touching = {int(model.geom_bodyid[g]) for c in data.contact for g in c.geom}
    awake = getattr(data, "body_awake", None)  # sleeping bodies have no contacts
    floating = [b for b in free if b not in touching and (awake is None or awake[b] != 0)]
    moved = np.linalg.norm(data.xpos[free] - start, axis=1)
    dots = np.clip(np.abs((data.xquat[free] * turned).sum(1)), 0, 1)
    return {
        "penetration_mm": 1e3 * depth,
        "drift_mm": 1e3 * float(moved.max(initial=0)),
        "tilt_deg": float(np.rad2deg(2 * np.arccos(dots)).max(initial=0)),
        "floating": len(floating),
        "fallen": int((data.xpos[free, 2] < 0.3 * start[:, 2]).sum()),
        "built": len(free),
    }


def count_named(scene: Scene) -> int:
    """Return the number of planned objects present by name, regardless of position.

    Words are compared by their category; words without one are compared literally.
    """
    from generator.language.lexicon import category_of

    planned = scene.plan.objects if scene.plan else ()
    asked = Counter(p.noun if p.category == "generic" else p.category for p in planned)
    words = [thing.label for thing in scene.objects]
    there = Counter(category_of(tuple(word.split())) or word for word in words)
    return (asked & there).total()


def count_unseen(bundle: Path, scene: Scene) -> int:
    """Return the number of a bundle's objects without an instance in its picture."""
    from generator.bundle import load_segments

    segments = load_segments(bundle)
    return sum(thing.name not in segments.names for thing in scene.objects) if segments else 0


def run(text: str, seed: int, route: str) -> dict[str, Any]:
    """Make one scene and measure it."""
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    import torch

    torch.set_num_threads(1)
    from generator.bundle import load, save

    row: dict[str, Any] = {"text": text, "seed": seed, "published": 0, "error": ""}
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        try:
            if route == "compose":
                from generator.composition import compose

                scene = compose(text, seed)
                path = save(scene, folder)
            else:
                from generator.pipeline import generate

                generation = generate(text, seed=seed)
                scene, path = generation.scene, generation.save(folder)
                row["unseen"] = count_unseen(path, scene)
            row["planned"] = len(scene.plan.objects) if scene.plan else ""
            row["seconds"] = round(time.perf_counter() - start, 2)
            row |= measure(path) | {"named": count_named(load(path)), "published": 1}
        except Exception as error:  # recorded as a failure; one scene must not abort the run
            row["error"] = f"{type(error).__name__}: {error}"[:300]
    return row


def summary(rows: list[dict[str, Any]], route: str, command: str) -> str:
    """Return the results table with the criteria of a valid scene."""
    done = [r for r in rows if int(r["published"])]

    def worst(field: str) -> float:
        return max((float(r[field]) for r in done), default=float("nan"))

    same = sum(int(r["planned"]) == int(r["built"]) for r in done)
    wanted = sum(int(r["planned"]) for r in done)
    seen = [int(r["built"]) - int(r.get("unseen") or 0) for r in done]
    by_eye = sum(int(r["planned"]) == n for r, n in zip(done, seen, strict=True))
    total = max(len(rows), 1)
    scored = [r for r in done if r.get("named") not in (None, "")]
    right = sum(int(r["named"]) == int(r["planned"]) == int(r["built"]) for r in scored)
    asked = sum(int(r["planned"]) for r in scored)
    sound = sum(
        float(r["penetration_mm"]) <= 1
        and float(r["drift_mm"]) <= 10
        and float(r["tilt_deg"]) <= 5
        and not int(r["floating"])
        and not int(r["fallen"])
        for r in done
    )
    seconds = [float(r["seconds"]) for r in done]
    return "\n".join(
        [
            f"# {route}: {len(rows)} scenes",
            f"`{command}`, {platform.machine()}, {os.cpu_count()} cores, "
            f"{datetime.date.today().isoformat()}",
            "",
            "| figure | value |",
            "|---|---|",
            f"| published | {len(done)} / {len(rows)} |",
            f"| valid (≤ 1 mm overlap; after 2 s ≤ 10 mm, ≤ 5°, none floats or fell) | {sound} / "
            f"{len(rows)} |",
            f"| deepest overlap at the start | {worst('penetration_mm'):.3f} mm |",
            f"| largest drift, tilt after 2 s | {worst('drift_mm'):.2f} mm, "
            f"{worst('tilt_deg'):.2f}° |",
            f"| planned count = built count | {100 * same / total:.1f} % |",
            "| planned count = count visible in the drawing, without the plan's additions | "
            f"{100 * by_eye / total:.1f} % of scenes, {100 * sum(seen) / max(wanted, 1):.1f} % of "
            "objects |",
            f"| planned names = built names | {100 * right / len(scored):.1f} % of scenes, "
            f"{100 * sum(int(r['named']) for r in scored) / max(asked, 1):.1f} % of objects |"
            if scored
            else "| planned names = built names | - |",
            f"| seconds per scene, median / worst | {np.median(seconds):.1f} / {max(seconds):.1f} |"
            if seconds
            else "| seconds | - |",
            "",
        ]
    )


def resume(table: Path) -> list[dict[str, Any]]:
    """Return the rows written so far, after updating the file's columns to this version's."""
    rows: list[dict[str, Any]] = []
    if table.exists():
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
    with table.open("w", newline="") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, FIELDS, restval="")
        writer.writeheader()
        writer.writerows(rows)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--route", choices=("generate", "compose"), default="generate")
    parser.add_argument("--texts", type=Path, default=HERE / "texts.json")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--limit", type=int, default=None, help="only the first N texts")
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    texts = texts_in(args.texts)[: args.limit]
    args.out.mkdir(parents=True, exist_ok=True)
    stem = args.route + ("" if args.texts.stem == "texts" else f"_{args.texts.stem}")
    table = args.out / f"{stem}.csv"
    rows = resume(table)
    done = {(r["text"], int(r["seed"])) for r in rows}
    jobs = [(t, s) for s in range(args.seeds) for t in texts if (t, s) not in done]
    with ProcessPoolExecutor(args.workers) as pool, table.open("a", newline="") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, FIELDS, restval="")
        futures = [pool.submit(run, text, seed, args.route) for text, seed in jobs]
        for number, future in enumerate(as_completed(futures), start=1):
            row = future.result()
            rows.append(row)
            writer.writerow(row)
            file.flush()
            state = "ok" if row["published"] else row["error"]
            scene = f"{row['text'][:50]!r} seed {row['seed']}"
            print(f"[{number}/{len(jobs)}] {scene}: {state}", flush=True)
    command = "python " + " ".join([Path(sys.argv[0]).name, *sys.argv[1:]])
    text = summary(rows, stem, command)
    (args.out / f"{stem}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
