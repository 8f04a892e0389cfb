"""A run's folder: its recipe, its evaluations, its policies, and what is needed to go on.

======================  ===========================================================================
``recipe.json``         the recipe, the seed and the format's version
``evaluations.csv``     a row an evaluation: steps, seconds, episodes, solved, reward, length
``policy.safetensors``  the latest policy; ``best.safetensors`` the one that solved the most
                        held-out episodes (a choice, so no test: see ``enjoy``)
``checkpoint-STEPS/``   the newest checkpoint: ``model.zip`` (weights and optimisers; also what
                        Stable-Baselines3 loads), ``replay.npz``, or ``learner.pt`` of
                        ``ppo-batch``; and ``counts.json``
``cloning/``            the rounds of cloning, until it is done; see ``demonstrations.rounds``
``tensorboard/``        curves, where TensorBoard is installed
======================  ===========================================================================

A checkpoint is published by one rename, or absent. Going on reads its weights through torch's
restricted loader (``weights_only``, sound from torch 2.6 on), its counts as JSON and its replay
buffer as arrays; the rest of ``model.zip``, which is pickled, is not read.
"""

from __future__ import annotations

import csv
import io
import json
import math
import re
import shutil
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from generator.errors import InputError, StorageError
from generator.io.bounded import parse_object, read_regular
from generator.io.files import write_whole

from ..files import check_type
from .algorithms.learner import Counts, Learner
from .evaluation import PolicyEvaluation
from .recipes import Recipe, recipe_of

FORMAT = 1
"""Version of a run's folder; others are refused."""

ROUNDS = "cloning"
"""Where a run keeps its rounds of cloning."""

LATEST, BEST = "policy.safetensors", "best.safetensors"
COLUMNS = ("steps", "seconds", "episodes", "solved", "reward", "length")

_RECIPE, _EVALUATIONS, _CHECKPOINT = "recipe.json", "evaluations.csv", "checkpoint-"
_CURVES = "tensorboard"
_STEPS = re.compile(rf"{_CHECKPOINT}([0-9]{{1,15}})")
_MOST_STEPS = 10**15
_MAX_BYTES = 16 * 2**20  # of a run's JSON and table


@dataclass(frozen=True)
class EvaluationRow:
    """One evaluation of a run."""

    steps: int
    seconds: float
    episodes: int
    solved: int
    reward: float
    length: float


@dataclass(frozen=True)
class Run:
    """A run's folder with what it was begun with."""

    path: Path
    recipe: Recipe
    seed: int

    @property
    def checkpoint(self) -> Path | None:
        """The newest checkpoint; None if there is none."""
        found = {
            int(named[1]): path
            for path in self.path.glob(f"{_CHECKPOINT}*")
            if (named := _STEPS.fullmatch(path.name)) and path.is_dir()
        }
        return found[max(found)] if found else None

    @property
    def curves(self) -> Path:
        """The folder of TensorBoard's curves."""
        return self.path / _CURVES

    @property
    def kept(self) -> bool:
        """Whether there is anything that was learned: a policy or a checkpoint."""
        return self.checkpoint is not None or any((self.path / p).exists() for p in (LATEST, BEST))

    def take_back(self, folder_too: bool) -> None:
        """Delete what a run has written before it learned anything, and its folder if asked."""
        shutil.rmtree(self.curves, ignore_errors=True)
        with suppress(OSError):  # it is on its way out by another error
            for name in (_RECIPE, _EVALUATIONS):
                (self.path / name).unlink(missing_ok=True)
            if folder_too:
                self.path.rmdir()

    def rows(self) -> list[EvaluationRow]:
        """Return the run's evaluations; see ``read_rows``."""
        return read_rows(self.path)

    def add(self, steps: int, seconds: float, seen: PolicyEvaluation) -> None:
        """Add an evaluation to the table.

        Raises:
            StorageError: it cannot be written.
        """
        spent = round(seconds, 1)
        row = EvaluationRow(steps, spent, seen.episodes, seen.solved, seen.reward, seen.steps)
        _write_rows(self.path, [*self.rows(), row])

    def save(self, learner: Learner, counts: Counts, replay: bool) -> None:
        """Publish a checkpoint, and delete the older ones.

        Raises:
            StorageError: it cannot be written.
        """
        older = [path for path in self.path.iterdir() if _STEPS.fullmatch(path.name)]
        final = self.path / f"{_CHECKPOINT}{counts.steps}"
        part = self.path / f"{_CHECKPOINT}part"
        try:
            shutil.rmtree(part, ignore_errors=True)
            part.mkdir()
            learner.write(part, replay)
            (part / "counts.json").write_text(json.dumps(asdict(counts)) + "\n")
            shutil.rmtree(final, ignore_errors=True)
            part.rename(final)
            for path in set(older) - {final}:
                shutil.rmtree(path, ignore_errors=True)
        except OSError as error:
            raise StorageError(
                f"The checkpoint cannot be written to {self.path}: {error.strerror or error}."
            ) from error

    def restore_rounds(self, rounds: int) -> Counts:
        """Return how far so many rounds of cloning are; evaluations after them are dropped."""
        rows = self.rows()[:rounds]
        _write_rows(self.path, rows)
        if not rows:
            return Counts()
        best = max(row.solved / row.episodes for row in rows)
        return Counts(steps=rows[-1].steps, seconds=rows[-1].seconds, best=best)

    def restore(self, learner: Learner) -> tuple[Counts, bool]:
        """Put the newest checkpoint into a new learner; return its counts, and if it kept a replay.

        Without a checkpoint nothing changes. Evaluations after it are dropped from the table.

        Raises:
            InputError: the checkpoint is damaged, or not of this recipe.
        """
        found = self.checkpoint
        if found is None:
            _write_rows(self.path, [])
            return Counts(), False
        counts = _counts(found / "counts.json")
        try:
            replayed = learner.read(found, counts)
        except Exception as error:  # whatever a damaged file brings about
            raise InputError(
                f"{found} is no checkpoint of {self.recipe.name} ({error}). Begin a new run."
            ) from error
        _write_rows(self.path, [r for r in self.rows() if r.steps <= counts.steps])
        return counts, replayed


def begin(path: Path, recipe: Recipe, seed: int) -> Run:
    """Make a run's folder.

    Raises:
        InputError: there is a run, or something else, already.
        StorageError: it cannot be written.
    """
    if (path / _RECIPE).exists():
        raise InputError(
            f"{path} holds a run already: continue with --resume, or choose another --out."
        )
    if path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise InputError(f"{path} holds something else already; choose another --out.")
    there = path.exists()
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{path} cannot be made: {error.strerror or error}.") from error
    facts = {"format": FORMAT, "seed": seed, "recipe": recipe.facts()}
    run = Run(path, recipe, seed)
    try:
        _write_rows(path, [])
        text = json.dumps(facts, indent=1) + "\n"
        write_whole(path / _RECIPE, text, "The recipe", "Choose another --out.")
    except StorageError:
        run.take_back(folder_too=not there)
        raise
    return run


def open_run(path: Path) -> Run:
    """Return the run of a folder.

    Raises:
        InputError: it holds none, or its recipe is damaged.
    """
    if not (path / _RECIPE).exists():
        raise InputError(f"{path} holds no run: {_RECIPE} is missing.")
    try:
        payload = _object(path / _RECIPE)
        if check_type(payload.get("format"), int) != FORMAT:
            raise ValueError(f"it is not of format {FORMAT}")
        recipe = recipe_of(check_type(payload["recipe"], dict))
        return Run(path, recipe, check_type(payload["seed"], int))
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise InputError(f"{path / _RECIPE} is damaged ({str(error)!r}).") from error


def kept_policy(path: Path) -> Path:
    """Return the file of a run's best policy, or of its latest while there is no best.

    Raises:
        InputError: there is neither.
    """
    for file in (BEST, LATEST):
        if (path / file).is_file():
            return path / file
    raise InputError(
        f"There is no policy {str(path)!r}: the folder holds no policy yet, neither {BEST} nor "
        f"{LATEST}."
    )


def read_rows(path: Path) -> list[EvaluationRow]:
    """Return the evaluations in a run's folder.

    Raises:
        InputError: the table is missing or damaged.
    """
    table = path / _EVALUATIONS
    raw = read_regular(table, "The table of evaluations", InputError, max_bytes=_MAX_BYTES)
    try:
        return [_row(row) for row in csv.DictReader(io.StringIO(raw.decode(), newline=""))]
    except (ValueError, TypeError, KeyError, csv.Error) as error:
        raise InputError(f"{table} is no table of evaluations ({str(error)!r}).") from error


def _row(cells: Mapping[str, str]) -> EvaluationRow:
    """Return a row of the table (ValueError: its numbers are none that an evaluation can have)."""
    row = EvaluationRow(
        int(cells["steps"]), float(cells["seconds"]), int(cells["episodes"]),
        int(cells["solved"]), float(cells["reward"]), float(cells["length"]),
    )  # fmt: skip
    if not all(math.isfinite(v) for v in (row.seconds, row.reward, row.length)):
        raise ValueError("a number that is not finite")
    if not (0 <= row.steps < _MOST_STEPS and 0 <= row.solved <= row.episodes and row.episodes):
        raise ValueError(f"{row.solved} of {row.episodes} episodes after {row.steps} steps")
    return row


def _counts(path: Path) -> Counts:
    """Return how far a checkpoint is (InputError: the file is damaged)."""
    try:
        payload = _object(path)
        own = Counts(**payload)
        for name in ("steps", "updates", "episodes"):
            if not 0 <= check_type(getattr(own, name), int) < _MOST_STEPS:
                raise ValueError(f"{name} {getattr(own, name)}")
        check_type(own.cloned, bool)
        seconds, best = (float(v) for v in (own.seconds, own.best))
        return replace(own, seconds=seconds, best=best)
    except (ValueError, TypeError, OverflowError) as error:
        raise InputError(f"{path} is damaged ({str(error)!r}). Begin a new run.") from error


def _object(path: Path) -> dict[str, Any]:
    """Return the JSON object of a file (InputError: it is none)."""
    raw = read_regular(path, "The run's", InputError, max_bytes=_MAX_BYTES)
    return parse_object(raw, f"{path}", InputError)


def _write_rows(path: Path, rows: list[EvaluationRow]) -> None:
    lines = [",".join(COLUMNS), *(",".join(f"{getattr(r, c)}" for c in COLUMNS) for r in rows), ""]
    table = path / _EVALUATIONS
    write_whole(table, "\n".join(lines), "The table of evaluations", "Make room for it.")


def differences(one: Recipe, other: Recipe) -> list[str]:
    """Return what two recipes say differently, but for how many steps they take."""
    a, b = one.facts(), other.facts()
    return [key for key in a if key != "steps" and a[key] != b[key]]
