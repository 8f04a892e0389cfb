"""The folder of a run: recipe, evaluations, policies and checkpoint.

======================  ===========================================================================
``recipe.json``         the recipe, the seed and the format's version
``evaluations.csv``     a row per evaluation: steps, seconds, episodes, solved, reward, length
``policy.safetensors``  the latest policy; ``best.safetensors``: the one that solved the most
                        held-out episodes (used for selection, so not a test: see ``enjoy``)
``checkpoint-STEPS/``   the newest checkpoint: ``model.zip`` (weights and optimisers, loadable by
                        Stable-Baselines3) and ``replay.npz``, or ``learner.pt`` of
                        ``ppo-batch``; and ``counts.json``
``cloning/``            the rounds of cloning until it is done; see ``demonstrations.rounds``
``tensorboard/``        curves, if TensorBoard is installed
======================  ===========================================================================

A checkpoint is published by a single rename, so it is either complete or absent. Resuming reads its
weights with torch's restricted loader (``weights_only``, safe from torch 2.6 on), its counts as
JSON and its replay buffer as arrays; the pickled rest of ``model.zip`` is not read.
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
"""Version of the layout of a run's folder; other versions are rejected."""

ROUNDS = "cloning"
"""Subfolder of a run's cloning rounds."""

LATEST, BEST = "policy.safetensors", "best.safetensors"
COLUMNS = ("steps", "seconds", "episodes", "solved", "reward", "length")

_RECIPE, _EVALUATIONS, _CHECKPOINT = "recipe.json", "evaluations.csv", "checkpoint-"
_CURVES = "tensorboard"
_STEPS = re.compile(rf"{_CHECKPOINT}([0-9]{{1,15}})")
_MOST_STEPS = 10**15
_MAX_BYTES = 16 * 2**20  # maximum size of a run's JSON files and table, bytes


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
    """A run's folder with its recipe and seed."""

    path: Path
    recipe: Recipe
    seed: int

    @property
    def checkpoint(self) -> Path | None:
        """The newest checkpoint, or None if there is none."""
        found = {
            int(named[1]): path
            for path in self.path.glob(f"{_CHECKPOINT}*")
            if (named := _STEPS.fullmatch(path.name)) and path.is_dir()
        }
        return found[max(found)] if found else None

    @property
    def curves(self) -> Path:
        """The folder of the TensorBoard curves."""
        return self.path / _CURVES

    @property
    def kept(self) -> bool:
        """Whether the run has a policy or a checkpoint."""
        return self.checkpoint is not None or any((self.path / p).exists() for p in (LATEST, BEST))

    def take_back(self, folder_too: bool) -> None:
        """Delete the files of an untrained run and, if ``folder_too`` is true, its folder."""
        shutil.rmtree(self.curves, ignore_errors=True)
        with suppress(OSError):  # another error is already being raised
            for name in (_RECIPE, _EVALUATIONS):
                (self.path / name).unlink(missing_ok=True)
            if folder_too:
                self.path.rmdir()

    def rows(self) -> list[EvaluationRow]:
        """Return the run's evaluations; see ``read_rows``."""
        return read_rows(self.path)

    def add(self, steps: int, seconds: float, seen: PolicyEvaluation) -> None:
        """Append an evaluation to the table.

        Raises:
            StorageError: the table cannot be written.
        """
        spent = round(seconds, 1)
        row = EvaluationRow(steps, spent, seen.episodes, seen.solved, seen.reward, seen.steps)
        _write_rows(self.path, [*self.rows(), row])

    def save(self, learner: Learner, counts: Counts, replay: bool) -> None:
        """Save a checkpoint and delete the older ones.

        Raises:
            StorageError: the checkpoint cannot be written.
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
        """Return the counts after ``rounds`` rounds of cloning, and drop later evaluations."""
        rows = self.rows()[:rounds]
        _write_rows(self.path, rows)
        if not rows:
            return Counts()
        best = max(row.solved / row.episodes for row in rows)
        return Counts(steps=rows[-1].steps, seconds=rows[-1].seconds, best=best)

    def restore(self, learner: Learner) -> tuple[Counts, bool]:
        """Load the newest checkpoint; return its counts and whether it contains a replay buffer.

        Without a checkpoint the learner is unchanged. Later evaluations are dropped from the table.

        Raises:
            InputError: the checkpoint is damaged, or belongs to a different recipe.
        """
        found = self.checkpoint
        if found is None:
            _write_rows(self.path, [])
            return Counts(), False
        counts = _counts(found / "counts.json")
        try:
            replayed = learner.read(found, counts)
        except Exception as error:  # damaged files can raise any exception
            raise InputError(
                f"{found} is not a valid checkpoint of {self.recipe.name} ({error}). Start a "
                "new run."
            ) from error
        _write_rows(self.path, [r for r in self.rows() if r.steps <= counts.steps])
        return counts, replayed


def begin(path: Path, recipe: Recipe, seed: int) -> Run:
    """Create a run's folder.

    Raises:
        InputError: the folder holds a run or other files already.
        StorageError: the folder cannot be written.
    """
    if (path / _RECIPE).exists():
        raise InputError(
            f"{path} already contains a run: continue with --resume, or choose another --out."
        )
    if path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise InputError(f"{path} already contains other files; choose another --out.")
    there = path.exists()
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{path} cannot be created: {error.strerror or error}.") from error
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
    """Open the run in a folder.

    Raises:
        InputError: the folder holds no run, or its recipe is damaged.
    """
    if not (path / _RECIPE).exists():
        raise InputError(f"{path} is not the folder of a run: {_RECIPE} is missing.")
    try:
        payload = _object(path / _RECIPE)
        if check_type(payload.get("format"), int) != FORMAT:
            raise ValueError(f"the format is not {FORMAT}")
        recipe = recipe_of(check_type(payload["recipe"], dict))
        return Run(path, recipe, check_type(payload["seed"], int))
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise InputError(f"{path / _RECIPE} is damaged ({str(error)!r}).") from error


def kept_policy(path: Path) -> Path:
    """Return the file of a run's best policy, or of its latest policy if there is no best one.

    Raises:
        InputError: there is neither.
    """
    for file in (BEST, LATEST):
        if (path / file).is_file():
            return path / file
    raise InputError(
        f"The folder {str(path)!r} contains no policy yet: neither {BEST} nor {LATEST} exists."
    )


def read_rows(path: Path) -> list[EvaluationRow]:
    """Read the evaluations in a run's folder.

    Raises:
        InputError: the table is missing or damaged.
    """
    table = path / _EVALUATIONS
    raw = read_regular(table, "The table of evaluations", InputError, max_bytes=_MAX_BYTES)
    try:
        return [_row(row) for row in csv.DictReader(io.StringIO(raw.decode(), newline=""))]
    except (ValueError, TypeError, KeyError, csv.Error) as error:
        raise InputError(
            f"{table} is not a valid table of evaluations ({str(error)!r})."
        ) from error


def _row(cells: Mapping[str, str]) -> EvaluationRow:
    """Parse a row of the evaluation table; raise ValueError if its numbers are impossible."""
    row = EvaluationRow(
        int(cells["steps"]), float(cells["seconds"]), int(cells["episodes"]),
        int(cells["solved"]), float(cells["reward"]), float(cells["length"]),
    )  # fmt: skip
    if not all(math.isfinite(v) for v in (row.seconds, row.reward, row.length)):
        raise ValueError("the numbers must be finite")
    if not (0 <= row.steps < _MOST_STEPS and 0 <= row.solved <= row.episodes and row.episodes):
        raise ValueError(
            f"invalid counts: {row.solved} of {row.episodes} episodes after {row.steps} steps"
        )
    return row


def _counts(path: Path) -> Counts:
    """Read the counts of a checkpoint; raise InputError if the file is damaged."""
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
        raise InputError(f"{path} is damaged ({str(error)!r}). Start a new run.") from error


def _object(path: Path) -> dict[str, Any]:
    """Read the JSON object in a file; raise InputError if there is none."""
    raw = read_regular(path, "The run's", InputError, max_bytes=_MAX_BYTES)
    return parse_object(raw, f"{path}", InputError)


def _write_rows(path: Path, rows: list[EvaluationRow]) -> None:
    lines = [",".join(COLUMNS), *(",".join(f"{getattr(r, c)}" for c in COLUMNS) for r in rows), ""]
    table = path / _EVALUATIONS
    write_whole(table, "\n".join(lines), "The table of evaluations", "Free some disk space.")


def differences(one: Recipe, other: Recipe) -> list[str]:
    """Return the keys in which two recipes differ, ignoring the number of steps."""
    a, b = one.facts(), other.facts()
    return [key for key in a if key != "steps" and a[key] != b[key]]
