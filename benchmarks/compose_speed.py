"""CPU seconds of ``compose`` for texts with about 8, 25 and 40 objects, in consecutive calls.

    python benchmarks/compose_speed.py
    python benchmarks/compose_speed.py --beside ../older-checkout --rounds 3

A process imports the package, composes one small table that is not measured, and then composes the
texts of ``TEXTS`` (or of ``--texts``). ``--beside`` is another checkout, with a process of its own;
for each text and round the two take turns, so that a busy machine slows both equally. The
measurement is the minimum CPU time of the process and its children over the rounds. The table is
written to ``compose_speed.md``; "import" is the CPU time until the package is imported.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from posing import tables

HERE = Path(__file__).parent
TEXTS: Mapping[str, Sequence[str]] = MappingProxyType({
    "8": (
        "A desk with a laptop, a mug, two books, a pen, a notebook and a lamp",
        "A breakfast table with a plate, a fork, a knife, a cup of coffee, a jar of jam, a butter "
        "dish, a toast and a glass of juice",
        "A pen holder with four pencils and a pair of scissors, a stapler, a tape dispenser and a "
        "notepad",
        "A stack of five books beside a lamp and a pair of glasses on the books",
        "A coffee table with a tray holding a teapot and four cups, a vase with flowers and a "
        "magazine",
    ),
    "heaps": (
        "a fruit bowl with three apples, two bananas and an orange",
        "a fruit bowl with five lemons and five limes",
        "a dozen eggs in an egg carton next to a bowl of flour and a whisk",
        "a crate with nine tomatoes, and a plate with four cookies",
    ),
    "25": (
        "Set the table for four: plate, fork on the left, knife and spoon on the right, water "
        "glass above the knife",
        "A kitchen counter with four plates, four bowls, four mugs, four glasses, three jars, two "
        "bottles, a kettle, a toaster, a cutting board and a knife",
        "a desk with a monitor, a keyboard, a mouse, two speakers, a phone, a notebook, three "
        "pens in a cup, a lamp, a plant, a water bottle, a stapler, a calculator, sticky notes, a "
        "tape dispenser, a coffee mug, a pair of headphones, an eraser, a ruler, two books and a "
        "clock",
    ),
    "40": (
        "A long banquet table with eight place settings",
        "A workshop bench with twelve screws, eight bolts, six nuts, five screwdrivers, four "
        "wrenches, two hammers, two pliers and a toolbox",
        "ten pens, ten pencils, ten dice and ten coins on a desk",
    ),
})  # fmt: skip
"""Texts by group: approximate number of objects, or objects stacked on one another."""

_SMALL = "a desk with a mug"
_WORKER = """
import json, resource, sys
def spent():
    usages = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in usages)
from generator.composition import compose
print(json.dumps({"import": spent()}), flush=True)
for line in sys.stdin:
    start = spent()
    try:
        made = {"objects": len(compose(json.loads(line), 0).objects)}
    except Exception as error:
        made = {"objects": 0, "error": str(error)[:200]}
    print(json.dumps(made | {"cpu": spent() - start}), flush=True)
"""


class Composer:
    """A process that composes with the package of one checkout, until ``stack`` is closed."""

    def __init__(self, tree: Path, stack: contextlib.ExitStack) -> None:
        environment = {**os.environ, "PYTHONPATH": str(tree), "OMP_NUM_THREADS": "1"}
        self._process = subprocess.Popen(
            [sys.executable, "-c", _WORKER], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            text=True, env=environment, cwd=tree,
        )  # fmt: skip
        stack.callback(self._end)
        self.importing = float(self._answer()["import"])
        self.compose(_SMALL)

    def compose(self, text: str) -> dict[str, Any]:
        """Compose a text; return its objects, CPU seconds and error, if any."""
        assert self._process.stdin is not None
        self._process.stdin.write(json.dumps(text) + "\n")
        self._process.stdin.flush()
        return self._answer()

    def _end(self) -> None:
        self._process.kill()
        self._process.wait(timeout=60)

    def _answer(self) -> dict[str, Any]:
        assert self._process.stdout is not None
        line = self._process.stdout.readline()
        if not line:
            raise SystemExit("A composing process has exited; its error is printed above.")
        return json.loads(line)


def measure(
    texts: Sequence[tuple[str, str]], composers: Sequence[Composer], rounds: int
) -> list[list[dict[str, Any]]]:
    """Return each composer's answer for each text, with the minimum CPU time over the rounds."""
    found: list[list[dict[str, Any]]] = []
    for _, text in texts:
        answers = [[each.compose(text) for each in composers] for _ in range(rounds)]
        found.append([min(own, key=lambda a: a["cpu"]) for own in zip(*answers, strict=True)])
        seconds = ", ".join(f"{answer['cpu']:.2f} s" for answer in found[-1])
        print(f"{text[:60]!r}: {seconds}", flush=True)
    return found


def summary(
    texts: Sequence[tuple[str, str]],
    found: Sequence[Sequence[dict[str, Any]]],
    importing: Sequence[float],
    command: str,
) -> str:
    """Return the table as Markdown; the other checkout has a second column of seconds."""
    beside = len(importing) > 1
    head = "| group | text | objects | CPU s |" + (" beside, CPU s | ratio |" if beside else "")
    lines = [
        "# CPU seconds of compose", f"`{command}`, {tables.where()}", "", head,
        "|---" * (6 if beside else 4) + "|",
    ]  # fmt: skip
    cells = [(group, text[:60], str(own[0]["objects"]), [a["cpu"] for a in own])
             for (group, text), own in zip(texts, found, strict=True)]  # fmt: skip
    for group in dict.fromkeys(group for group, _ in texts):
        of = [seconds for name, _, objects, seconds in cells if name == group and objects != "0"]
        if of:
            cells.append((group, "**median**", "", np.median(of, axis=0).tolist()))
    cells.append(("", "import", "", [*importing]))
    for group, text, objects, seconds in cells:
        figures = [f"{s:.2f}" for s in seconds]
        if beside:
            figures.append(f"{seconds[0] / max(seconds[1], 1e-9):.2f}")
        lines.append("| " + " | ".join([group, text, objects, *figures]) + " |")
    for (_, text), own in zip(texts, found, strict=True):
        lines += [f"- {text!r} failed: {a['error']}" for a in own if "error" in a]
    return "\n".join([*lines, ""])


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument(
        "--texts", type=Path, help="a JSON list of texts that replaces the built-in ones"
    )
    p.add_argument("--beside", type=Path, help="another checkout to compare with")
    p.add_argument("--rounds", type=int, default=1)
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    if args.rounds < 1:
        raise SystemExit("--rounds must be at least 1.")
    given = {"texts": tables.texts_in(args.texts)} if args.texts else TEXTS
    texts = [(group, text) for group, members in given.items() for text in members]
    trees = [HERE.parent, *([args.beside.resolve()] if args.beside else [])]
    with contextlib.ExitStack() as stack:
        composers = [Composer(tree, stack) for tree in trees]
        found = measure(texts, composers, args.rounds)
    importing = [each.importing for each in composers]
    text = summary(texts, found, importing, tables.command_line("--out"))
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "compose_speed.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
