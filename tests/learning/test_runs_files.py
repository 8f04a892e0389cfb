"""Run folders modified by others: rejected with a message, without waiting."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

from generator.errors import InputError
from tabletopgen_env.learning.algorithms.learner import Counts
from tabletopgen_env.learning.recipes import recipe
from tabletopgen_env.learning.runs import COLUMNS, Run, begin, open_run, read_rows


@pytest.fixture
def run(small, tmp_path: Path) -> Run:
    return begin(tmp_path / "run", small(), 0)


@pytest.mark.parametrize(
    "change",
    [{"seed": "0"}, {"seed": True}, {"format": True}, {"recipe": []}, {"recipe": {"task": 5}}],
)
def test_a_recipe_of_wrong_types_is_refused(run: Run, change: dict[str, Any]) -> None:
    payload = json.loads((run.path / "recipe.json").read_text())
    (run.path / "recipe.json").write_text(json.dumps(payload | change))
    with pytest.raises(InputError):
        open_run(run.path)


@pytest.mark.parametrize("row", ["1,2,0,0,1,1", "1,2,2,3,1,1", "-1,2,2,1,1,1", "1,nan,2,1,1,1",
                                 "1,2,2,1,inf,1", "x,2,2,1,1,1", "1"])  # fmt: skip
def test_evaluations_that_cannot_be_are_refused(run: Run, row: str) -> None:
    (run.path / "evaluations.csv").write_text(",".join(COLUMNS) + f"\n{row}\n")
    with pytest.raises(InputError, match="not a valid table of evaluations"):
        read_rows(run.path)


@pytest.mark.parametrize("name", ["checkpoint-²", "checkpoint-" + "9" * 200, "checkpoint--1"])
def test_checkpoints_have_plain_numbers(run: Run, name: str) -> None:
    (run.path / name).mkdir()
    (run.path / "checkpoint-7").write_text("no folder")
    assert run.checkpoint is None
    (run.path / "checkpoint-5").mkdir()
    assert run.checkpoint == run.path / "checkpoint-5"


@pytest.mark.parametrize("counts", ["[" * 100_000, '{"steps": "5"}', '{"steps": -1}', "{", "5",
                                    '{"cloned": 1}', '{"best": null}'])  # fmt: skip
def test_counts_of_wrong_types_are_refused(run: Run, counts: str) -> None:
    (run.path / "checkpoint-5").mkdir()
    (run.path / "checkpoint-5" / "counts.json").write_text(counts)
    model: Any = None  # it is not reached
    with pytest.raises(InputError, match="counts"):
        run.restore(model)


def test_only_checkpoints_of_the_run_are_deleted(run: Run) -> None:
    class Model:
        def write(self, folder: Path, replay: bool) -> None:
            (folder / "model.zip").write_bytes(b"x")

    model: Any = Model()
    (run.path / "checkpoint-best-backup").mkdir()
    for steps in (1, 2):
        run.save(model, Counts(steps), replay=False)
    left = sorted(path.name for path in run.path.glob("checkpoint*"))
    assert left == ["checkpoint-2", "checkpoint-best-backup"]


def test_pipes_are_not_waited_for(run: Run) -> None:
    for name in ("recipe.json", "evaluations.csv"):
        (run.path / name).unlink()
        os.mkfifo(run.path / name)
    for read in (open_run, read_rows):
        with pytest.raises(InputError, match="not a regular file"):
            read(run.path)
    os.mkfifo(run.path / "mine.toml")
    with pytest.raises(InputError, match="not a regular file"):
        recipe(str(run.path / "mine.toml"))
