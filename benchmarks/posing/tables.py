"""Tables written row by row as cases finish, so that an interrupted run can resume."""

from __future__ import annotations

import csv
import datetime
import json
import os
import platform
import shlex
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any

from generator.errors import InputError, TabletopError

Row = dict[str, Any]


def resume(
    path: Path, fields: Sequence[str], key: Sequence[str], of: str | None = None
) -> list[Row]:
    """Return the rows of the complete cases of a table, and remove all others from the file.

    The file is created if missing. The columns ``key`` identify cases; the column ``of`` holds the
    number of rows of a case; None means one. A table with other columns belongs to another
    benchmark or version.

    Raises:
        InputError: the file contains another table.
    """
    rows: list[Row] = []
    if path.exists():
        try:
            with path.open(newline="", encoding="utf-8") as file:
                reader = csv.DictReader(file)
                rows = list(reader)
                head = reader.fieldnames
        except (UnicodeDecodeError, csv.Error) as error:
            raise InputError(f"{path} is not a CSV table ({error}). Move it away.") from error
        if rows and list(head or ()) != list(fields):
            raise InputError(f"{path} has other columns than this benchmark. Move it away first.")
    whole = [r for r in rows if all(r.get(f) is not None for f in fields)]
    counts: dict[tuple[str, ...], int] = {}
    for row in whole:
        counts[_key(row, key)] = counts.get(_key(row, key), 0) + 1
    kept = [r for r in whole if of is None or counts[_key(r, key)] == int(r[of])]
    write(path, fields, kept)
    return kept


def write(path: Path, fields: Sequence[str], rows: Sequence[Row]) -> None:
    """Write a table completely or not at all."""
    part = path.with_name(path.name + ".part")
    with part.open("w", newline="", encoding="utf-8") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, fields)
        writer.writeheader()
        writer.writerows(rows)
    part.replace(path)


def run(
    path: Path,
    fields: Sequence[str],
    key: Sequence[str],
    rows: Sequence[Row],
    jobs: Sequence[Any],
    work: Callable[[Any], list[Row]],
    workers: int,
    say: Callable[[list[Row]], str],
) -> list[Row]:
    """Run the jobs, append each one's rows to the table as it finishes, return all rows sorted.

    ``say`` formats the progress line for a job's rows.
    """
    out = [*rows]
    with path.open("a", newline="", encoding="utf-8") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, fields)

        def record(number: int, new: list[Row]) -> None:
            out.extend(new)
            writer.writerows(new)
            file.flush()
            print(f"[{number}/{len(jobs)}] {say(new)}", flush=True)

        if workers <= 1:
            for number, job in enumerate(jobs, start=1):
                record(number, work(job))
        else:
            with ProcessPoolExecutor(workers, initializer=alone) as pool:
                futures = [pool.submit(work, job) for job in jobs]
                for number, future in enumerate(as_completed(futures), start=1):
                    record(number, future.result())
    return sorted(out, key=lambda r: [_sortable(r[k]) for k in key])


def complete(
    path: Path,
    fields: Sequence[str],
    key: Sequence[str],
    asked: Mapping[tuple[str, ...], Any],
    work: Callable[[Any], list[Row]],
    workers: int,
    say: Callable[[list[Row]], str],
    of: str | None = None,
    again: bool = False,
) -> list[Row]:
    """Run those of the requested jobs that a table lacks; return the rows of all.

    Jobs are identified by the first columns of their rows' ``key``; see also ``resume`` and
    ``run``. ``again`` runs all of them, regardless of the table.
    """
    if again:
        write(path, fields, ())
    case = key[: len(next(iter(asked), key))]
    rows = [r for r in resume(path, fields, case, of) if _key(r, case) in asked]
    done = {_key(r, case) for r in rows}
    left = [job for name, job in asked.items() if name not in done]
    return run(path, fields, key, rows, left, work, workers, say)


def where() -> str:
    """Return machine, date and commit, for the head of a summary."""
    day = datetime.date.today().isoformat()
    return f"{platform.machine()}, {os.cpu_count()} cores, {day}{_commit()}"


def _commit() -> str:
    """Return the commit of the working tree; empty outside a repository."""
    command = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=10, check=True)
    except (OSError, subprocess.SubprocessError):
        return ""
    return f", commit {done.stdout.strip()}"


def command_line(*without: str) -> str:
    """Return the command line of this process; absolute paths are reduced to their last part.

    Options listed in ``without`` are omitted with the word after each.
    """
    words = [w for w, before in zip(sys.argv[1:], sys.argv, strict=False)
             if w not in without and before not in without]  # fmt: skip
    given = (Path(word).name if Path(word).is_absolute() else word for word in words)
    return shlex.join(["python", f"benchmarks/{Path(sys.argv[0]).name}", *given])


def alone() -> None:
    """Restrict this process to one thread: times are comparable and workers do not compete."""
    os.environ["OMP_NUM_THREADS"] = "1"
    import torch

    torch.set_num_threads(1)


def texts_in(path: Path) -> list[str]:
    """Return the texts of a JSON list of texts, or of objects with a "text"."""
    entries = json.loads(path.read_text(encoding="utf-8"))
    return [entry if isinstance(entry, str) else entry["text"] for entry in entries]


def failure(error: Exception) -> str:
    """Return the text that a row records for a failed case; foreign errors include their type."""
    known = isinstance(error, TabletopError)
    return (f"{error}" if known else f"{type(error).__name__}: {error}")[:300]


def _key(row: Row, key: Sequence[str]) -> tuple[str, ...]:
    return tuple(str(row[k]) for k in key)


def _sortable(value: Any) -> tuple[int, str]:
    text = str(value)
    return (int(text), "") if text.isdigit() else (0, text)
