"""Every script of the repository runs; of long benchmarks, `make test` only prints the help."""

import csv
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from extent import EXHAUSTIVE
from smokes import ROOT, SMOKES

FOLDERS = ("benchmarks", "docs", "examples")
LONG = 540.0
"""Seconds after which a run is taken to hang; on an idle machine each takes a few, 40 at most."""


def scripts() -> list[str]:
    """Return the executable files by their paths from the root."""
    files = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.py"))]
    guarded = [p for p in files if "__main__" in p.read_text(encoding="utf-8")]
    return [path.relative_to(ROOT).as_posix() for path in guarded]


def state() -> dict[str, tuple[int, int]]:
    """Return the time and the size of each file that a script might change by mistake."""
    places = (ROOT / folder for folder in (*FOLDERS, "out"))
    found = (path for place in places for path in place.rglob("*") if path.is_file())
    told = ((p, p.stat()) for p in found if "__pycache__" not in p.parts)
    return {str(path): (stat.st_mtime_ns, stat.st_size) for path, stat in told}


def errors_in(table: Path) -> list[str]:
    """Return the errors in a table's rows, which do not end a benchmark."""
    with table.open(newline="", encoding="utf-8") as file:
        return [row["error"] for row in csv.DictReader(file) if row.get("error")]


def test_every_script_has_a_smoke_run() -> None:
    without, gone = sorted({*scripts()} - {*SMOKES}), sorted({*SMOKES} - {*scripts()})
    assert not without, f"Add an entry to tests/scripts/smokes.py for {without}."
    assert not gone, f"Remove the entries of {gone} from tests/scripts/smokes.py."


def test_modules_beside_the_scripts_are_no_scripts() -> None:
    beside = [p for f in FOLDERS for p in (ROOT / f).glob("*.py")]
    assert {p.relative_to(ROOT).as_posix() for p in beside} <= {*scripts()}


@pytest.mark.slow
@pytest.mark.timeout(LONG + 60)
@pytest.mark.parametrize("script", sorted(SMOKES))
def test_a_script_runs(script: str, tmp_path: Path) -> None:
    smoke, before = SMOKES[script], state()
    if smoke.needs:
        pytest.importorskip(smoke.needs)
    if smoke.program and shutil.which(smoke.program) is None:
        pytest.skip(f"{smoke.program} is not installed: {script} is NOT TRIED")
    if smoke.prepare is not None:
        smoke.prepare(tmp_path)
    whole = EXHAUSTIVE or not smoke.long
    arguments = smoke.arguments if whole else "--help"
    words = [w.format(out=tmp_path, root=ROOT) for w in shlex.split(arguments)]
    own = {"PYTHONPATH": str(ROOT), "TABLETOPGEN_CACHE": str(tmp_path / "store"),
           "PYTHONDONTWRITEBYTECODE": "1", "TMPDIR": str(tmp_path)}  # fmt: skip
    done = subprocess.run(
        [sys.executable, str(ROOT / script), *words], cwd=tmp_path, env={**os.environ, **own},
        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=LONG,
    )  # fmt: skip
    assert "Traceback" not in done.stderr, done.stderr[-3000:]
    assert done.returncode in smoke.codes, done.stdout[-1000:] + done.stderr[-3000:]
    assert (smoke.prints if whole else "usage: ") in done.stdout
    for glob in smoke.leaves if whole else ():
        found = [path for path in tmp_path.glob(glob) if path.stat().st_size]
        assert found, f"no {glob}"
        assert [e for path in found if path.suffix == ".csv" for e in errors_in(path)] == []
    assert state() == before
