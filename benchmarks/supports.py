"""Validity of recorded supports: a bundle's "on" and "in" relations in plain MuJoCo.

    python benchmarks/supports.py --scenes 300

Texts of the dev half of ``wording/`` and of ``table78.json`` that mention objects on or in others
are composed and saved, all with seed 0 first, then with seed 1, and so on; scenes stored by
``understanding.py --bundles`` are reused with the same option. A bundle is simulated for 0.3 s
(``wording/seen.py``). On: load-bearing contacts lead from the object down to the other, and it
starts above the other's lowest point. In: additionally, the object's centre or foot is within the
other's outline, and it starts below the rim plus 1 cm. The ``on`` and ``inside`` of each object of
``scene.json`` are checked, and each relation "on" and "in" that its report marks as true. Rows are
written to ``supports.csv`` as they finish (a second run resumes), the summary to the corresponding
``.md``.
"""

from __future__ import annotations

import argparse
import itertools
import json
import re
import tempfile
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from posing import tables
from posing.figures import column
from posing.tables import Row
from wording.cases import cases_of
from wording.making import Made
from wording.seen import TABLE, Seen, look

from generator.bundle import load, save
from generator.composition import compose
from generator.scene import Scene

HERE = Path(__file__).parent
KEY = ("text", "seed")
SHARES = ("table", "on", "inside", "relation_on", "relation_in")
FIELDS = (
    "text", "seed", "made", "objects", *(f"{s}{end}" for s in SHARES for end in ("", "_true")),
    "false_relations", "seconds", "violations", "error",
)  # fmt: skip
SPEAKS = re.compile(r"\b(on|in|inside|into|stack\w*|pile\w*|hold\w*|contain\w*|full of)\b", re.I)
MEANING = {
    "table": "stands on the table", "on": "`on` another object", "inside": "`inside` it",
    "relation_on": "relation on, marked true", "relation_in": "relation in, marked true",
}  # fmt: skip


def work(job: tuple[str, int], kept: Path | None = None) -> list[Row]:
    """Compose a text and check its supports; a failure is also a row."""
    text, seed = job
    row: Row = dict.fromkeys(FIELDS, 0) | {
        "text": text,
        "seed": seed,
        "violations": "",
        "error": "",
    }
    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        try:
            bundle = _find_kept(text, seed, kept) or save(compose(text, seed), folder)
            row["seconds"] = round(time.perf_counter() - start, 2)
            return [row | check(load(bundle), look(bundle))]
        except Exception as error:  # one text must not abort the run
            return [row | {"error": tables.failure(error)}]


def _find_kept(text: str, seed: int, folder: Path | None) -> Path | None:
    """Return the bundle that ``understanding.py`` made of a text, if it exists."""
    if folder is None:
        return None
    for case in cases_of("dev"):
        record = folder / f"{case.id}-{seed}.json"
        if case.text == text and record.exists():
            made = Made(**json.loads(record.read_text(encoding="utf-8")))
            return folder / made.bundle if made.bundle else None
    return None


def check(scene: Scene, seen: Seen) -> Row:
    """Return the numbers of a scene's recorded and valid supports, and the invalid ones."""
    things = {t.name: t for t in seen.things}
    found: list[tuple[str, bool, str]] = []
    for thing in scene.objects:
        name, place = thing.name, thing.placement
        if place.on == TABLE:
            found.append(("table", TABLE in seen.below(name), f"{name} on {TABLE}"))
            continue
        a, b = things[name], things[place.on]
        found.append(("on", seen.on(a, b), f"{name} on {place.on}"))
        if place.inside:
            found.append(("inside", seen.inside(a, b), f"{name} inside {place.on}"))
    relations = scene.report.relations if scene.report else ()
    false = 0
    for told in relations:
        if told.kind not in ("on", "in") or told.target not in things or told.name not in things:
            continue
        if not told.holds:
            false += 1
            continue
        a, b = things[told.name], things[told.target]
        true = seen.on(a, b) if told.kind == "on" else seen.inside(a, b)
        found.append((f"relation_{told.kind}", true, f"relation {told.name} {told.kind} {b.name}"))
    row: Row = {"made": 1, "objects": len(scene.objects), "false_relations": false}
    for share in SHARES:
        of = [true for kind, true, _ in found if kind == share]
        row |= {share: len(of), f"{share}_true": sum(of)}
    return row | {"violations": "; ".join(words for _, true, words in found if not true)}


def texts(path: Path) -> list[str]:
    """Return the distinct texts that mention objects on or in others."""
    all_of_them = [*(c.text for c in cases_of("dev")), *tables.texts_in(path)]
    return [t for t in dict.fromkeys(all_of_them) if SPEAKS.search(t)]


def say(rows: list[Row]) -> str:
    (row,) = rows
    message = row["violations"] or row["error"] or "all hold"
    return f"{' '.join(str(row['text']).split())[:60]!r} seed {row['seed']}: {message}"


def summary(rows: Sequence[Row], command: str) -> str:
    """Return shares and violations as Markdown."""
    done = [r for r in rows if int(r["made"])]
    whole = sum(not r["violations"] for r in done)
    lines = [
        f"# Supports of {len(rows)} composed scenes",
        f"`{command}`, {tables.where()}",
        "",
        "| recorded | holds in plain MuJoCo |",
        "|---|---|",
        *(f"| {MEANING[s]} | {_share(column(done, f'{s}_true').sum(), column(done, s).sum())} |"
          for s in SHARES),
        f"| scenes in which all hold | {_share(whole, len(done))} |",
        f"| relations on and in that the report marks false | "
        f"{column(done, 'false_relations').sum():.0f} |",
        f"| texts without a scene | {len(rows) - len(done)} |",
        "",
    ]  # fmt: skip
    lines += [f"- {say([r])}" for r in rows if r["violations"] or not int(r["made"])]
    return "\n".join([*lines, ""])


def _share(part: float, total: float) -> str:
    return f"{100 * part / max(total, 1):.2f} % ({part:.0f} of {total:.0f})"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--scenes", type=int, default=300)
    parser.add_argument("--texts", type=Path, default=HERE / "table78.json")
    parser.add_argument("--bundles", type=Path, default=None, help="folder of stored scenes")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    tables.alone()
    args.out.mkdir(parents=True, exist_ok=True)
    jobs = ((t, seed) for seed in itertools.count() for t in texts(args.texts))
    asked = {(t, str(seed)): (t, seed) for t, seed in itertools.islice(jobs, args.scenes)}
    path = args.out / "supports.csv"
    job = partial(work, kept=args.bundles)
    rows = tables.complete(path, FIELDS, KEY, asked, job, args.workers, say)
    text = summary(rows, tables.command_line("--workers", "--out", "--bundles"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
