"""Agreement of tables with their texts: 264 texts, evaluated on the saved bundles.

    python benchmarks/understanding.py --half dev --route compose
    python benchmarks/understanding.py --half test --route compose --sheet 24

A scene is made of each text of ``wording/dev.json`` and ``wording/test.json`` by the command. The
required content - counts, relations, and nothing else - is measured in a plain MuJoCo simulation of
its bundle (``wording/seen.py``); labels, stand-ins and warnings are those of the command's
``--json``. Rows are written to ``understanding_<route>_<half>.csv`` as they finish (a second run
resumes), the summary to the corresponding ``.md``. The test half is held back: its rows and its
summary contain only numbers. ``--half more`` uses ``wording/more.json``, 440 texts for development,
written after the two halves. ``--bundles`` stores the scenes, and evaluates existing ones;
``--sheet N`` draws N scenes of the test half with their texts, for ratings from 1 to 5.
"""

from __future__ import annotations

import argparse
import random
import tempfile
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from posing import tables
from posing.figures import column
from posing.tables import Row
from wording.cases import Case, cases_of
from wording.judging import judge
from wording.making import make
from wording.seen import look
from wording.sheet import SheetEntry, contact_sheet

HERE = Path(__file__).parent
KEY = ("id", "seed")
FIGURES = (
    "made", "right", "strict", "asked", "counts_ok", "relations", "relations_ok", "phantoms",
    "stand_ins", "silent", "other", "changed", "forbidden", "excused", "warnings", "foreign",
    "objects", "seconds",
)  # fmt: skip
WORDS = (
    "text",
    "wrong_counts",
    "wrong_relations",
    "strays",
    "plain_shapes",
    "unnamed",
    "kinds",
    "changes",
    "said",
)
FIELDS = ("id", "theme", "level", "seed", *FIGURES, *WORDS)
SHEET_SEED = 7


def work(case: Case, route: str, seed: int, bundles: Path | None, shown: bool) -> list[Row]:
    """Make a case's scene and evaluate it; a case that is not ``shown`` has no words in its row."""
    if bundles is None:
        with tempfile.TemporaryDirectory() as folder:
            return work(case, route, seed, Path(folder), shown)
    made = make(case.text, case.id, route, seed, bundles)
    row: Row = dict.fromkeys(FIELDS, "")
    row |= {"id": case.id, "theme": case.theme, "level": case.level, "seed": seed}
    row |= dict.fromkeys(FIGURES, 0)
    row |= {"asked": len(case.objects), "relations": len(case.relations)}
    row |= {"seconds": made.seconds, "foreign": int(made.foreign), "warnings": len(made.warnings)}
    words: Row = {"text": case.text, "said": "; ".join(made.warnings) or made.errors[-300:]}
    if made.bundle:
        seen = look(bundles / made.bundle, made.said.get("objects", ()))
        found = judge(case, seen, made.warnings)
        row |= {
            "made": 1,
            "right": int(found.right and made.code == 0),
            "strict": int(found.strict and made.code == 0),
            "asked": found.asked,
            "counts_ok": found.asked - len(found.counts),
            "relations": found.relations_asked,
            "relations_ok": found.relations_asked - len(found.relations),
            "phantoms": len(found.phantoms),
            "stand_ins": len(found.stand_ins),
            "silent": len(found.silent),
            "other": len(found.other),
            "changed": len(found.changed),
            "forbidden": len(found.forbidden),
            "excused": found.excused,
            "objects": len(seen.things),
        }
        words |= {
            "wrong_counts": "; ".join(found.counts),
            "wrong_relations": "; ".join(found.relations),
            "strays": "; ".join((*found.phantoms, *(f"forbidden {n}" for n in found.forbidden))),
            "plain_shapes": "; ".join(found.stand_ins),
            "unnamed": "; ".join(found.silent),
            "kinds": "; ".join(found.other),
            "changes": "; ".join(found.changed),
        }
    return [row | words if shown else row]


def say(rows: list[Row]) -> str:
    (row,) = rows
    if not row["text"]:
        return str(row["id"])
    return f"{row['id']}: {'right' if int(row['right']) else faults(row)}"


def faults(row: Row) -> str:
    """Describe the errors in a row's table."""
    if not int(row["made"]):
        return f"no scene: {row['said']}"
    heads = {
        "wrong_counts": "counts", "wrong_relations": "relations", "strays": "not requested",
        "plain_shapes": "plain shapes", "unnamed": "without a warning",
        "changes": "shown as something else without a warning", "said": "it said",
    }  # fmt: skip
    return " | ".join(f"{head}: {row[f]}" for f, head in heads.items() if row[f])


def summary(rows: Sequence[Row], route: str, half: str, command: str) -> str:
    """Return totals and themes as Markdown, and each failure if the rows have words."""
    seconds = column(rows, "seconds")
    total = {f: int(column(rows, f).sum()) for f in FIGURES if f != "seconds"}
    levels = [(w, [r for r in rows if r["level"] == w]) for w in ("easy", "middling", "hard")]
    lines = [
        f"# Understanding of {len(rows)} texts, {half} half: {route}",
        f"`{command}`, {tables.where()}",
        "",
        "| figure | value |",
        "|---|---|",
        f"| fully correct | {_share(total['right'], len(rows))} |",
        "| fully correct, no plain shapes, and each object of its named kind | "
        f"{_share(total['strict'], len(rows))} |",
        *(f"| fully right, {w} | {_share(column(some, 'right').sum(), len(some))} |"
          for w, some in levels),
        f"| counts correct | {_share(total['counts_ok'], total['asked'])} |",
        f"| relations correct | {_share(total['relations_ok'], total['relations'])} |",
        f"| objects not requested | {total['phantoms']} of {total['objects']} |",
        f"| excluded objects present | {total['forbidden']} |",
        f"| plain shapes as stand-ins | {total['stand_ins']} |",
        f"| requested, missing, and not named in a warning | {total['silent']} |",
        f"| of another kind than their name | {total['other']} |",
        f"| replaced by another object without a warning | {total['changed']} |",
        f"| texts with a warning | {sum(int(r['warnings']) > 0 for r in rows)} |",
        f"| no scene; of these by a foreign exception | {len(rows) - total['made']}; "
        f"{total['foreign']} |",
        f"| processor seconds per text, mean and maximum | {seconds.mean():.1f}, "
        f"{seconds.max():.1f} |",
        "",
        "| theme | texts | fully correct | counts | relations | not requested |",
        "|---|---|---|---|---|---|",
        *(_theme(name, [r for r in rows if r["theme"] == name])
          for name in dict.fromkeys(str(r["theme"]) for r in rows)),
        "",
    ]  # fmt: skip
    wrong = [r for r in rows if r["text"] and not int(r["right"])]
    lines += [
        f"- {r['id']} {' / '.join(str(r['text']).splitlines())!r}: {faults(r)}" for r in wrong
    ]
    return "\n".join([*lines, ""])


def _theme(name: str, rows: Sequence[Row]) -> str:
    total = {f: int(column(rows, f).sum()) for f in FIGURES if f != "seconds"}
    return (
        f"| {name} | {len(rows)} | {total['right']} | {total['counts_ok']} / {total['asked']} | "
        f"{total['relations_ok']} / {total['relations']} | {total['phantoms']} |"
    )


def _share(part: float, total: float) -> str:
    return f"{100 * part / max(total, 1):.1f} % ({part:.0f} of {total:.0f})"


def draw(count: int, route: str, seed: int, bundles: Path | None, out: Path) -> None:
    """Draw ``count`` scenes of the test half, selected by a fixed seed, on a contact sheet."""
    if bundles is None:
        with tempfile.TemporaryDirectory() as folder:
            return draw(count, route, seed, Path(folder), out)
    cases = cases_of("test")
    chosen = random.Random(SHEET_SEED).sample(cases, min(count, len(cases)))
    made = [(c, make(c.text, c.id, route, seed, bundles)) for c in chosen]
    entries = [SheetEntry(c.text, bundles / m.bundle if m.bundle else None) for c, m in made]
    contact_sheet(entries).save(out / f"understanding_{route}.png")
    return None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--half", choices=("dev", "test", "both", "more"), default="dev")
    parser.add_argument("--route", choices=("generate", "compose"), default="compose")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--limit", type=int, default=None, help="only the first N texts")
    parser.add_argument("--theme", default=None, help="only texts of this theme")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--bundles", type=Path, default=None, help="folder for the scenes")
    parser.add_argument(
        "--sheet", type=int, default=0, help="scenes on a contact sheet; 0 for none"
    )
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    tables.alone()
    for folder in (args.out, args.bundles or args.out):
        folder.mkdir(parents=True, exist_ok=True)
    shown = {c.id for half in ("dev", "more") for c in cases_of(half)}
    cases = [c for c in cases_of(args.half) if args.theme in (None, c.theme)][: args.limit]
    asked = {(c.id, str(args.seed)): c for c in cases}
    if args.sheet:
        draw(args.sheet, args.route, args.seed, args.bundles, args.out)
    job = partial(_job, route=args.route, seed=args.seed, bundles=args.bundles, shown=shown)
    stem = "_".join(w for w in ("understanding", args.route, args.half, args.theme) if w)
    path = args.out / f"{stem}.csv"
    rows = tables.complete(path, FIELDS, KEY, asked, job, args.workers, say)
    given = tables.command_line("--workers", "--out", "--bundles")
    text = summary(rows, args.route, args.half, given)
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)


def _job(case: Case, route: str, seed: int, bundles: Path | None, shown: set[str]) -> list[Row]:
    return work(case, route, seed, bundles, case.id in shown)


if __name__ == "__main__":
    main()
