"""Suites: their names, their episodes, and validation of their untrusted files."""

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from generator.errors import InputError
from tabletopgen_env.bench import suites as files
from tabletopgen_env.bench.instances import LISTED, TaskSuites
from tabletopgen_env.bench.training_tables import training_tables
from tabletopgen_env.certificates.certificate import STARTS
from tabletopgen_env.episodes import HOLD
from tabletopgen_env.tasks.names import NAMES


def test_a_file_says_what_was_written(reach: TaskSuites, suite_file: Path) -> None:
    assert files.read_suites(suite_file) == reach
    assert files.digest_of(files.read_suites(suite_file)) == files.digest_of(reach)
    other = dataclasses.replace(reach, time_limit=13)
    assert files.digest_of(other) != files.digest_of(reach)


def test_episodes_are_the_instances_that_were_solved(reach: TaskSuites, suite_file: Path) -> None:
    plain = files.find_suite(f"{suite_file}:test")
    random = files.find_suite(f"{suite_file}:test-random")
    assert (plain.name, random.name) == ("reach-test", "reach-test-random")
    assert [(e.table.seed, e.level, e.number) for e in plain.episodes()] == [
        (0, "easy", 0), (0, "easy", 1), (1, "hard", 0), (1, "hard", 1),
    ]  # fmt: skip
    assert all(e.instance == reach.tables[0].instances[0] for e in plain.episodes())
    seeds = [e.seed for e in (*plain.episodes(), *random.episodes())]
    assert len(set(seeds)) == len(seeds) == 4 + 6
    assert plain.episodes() == files.find_suite(f"{suite_file}:test").episodes()
    assert random.settings["randomization"] == reach.randomization
    assert plain.settings["randomization"] is None


@pytest.mark.parametrize("name", [
    "lift-tset", "juggle-test", "test", "", "lift-test-randm", "reach",
])  # fmt: skip
def test_an_unknown_suite_is_refused(name: str) -> None:
    with pytest.raises(InputError, match="Unknown s"):
        files.find_suite(name)


def test_tables_to_train_at_are_not_played() -> None:
    with pytest.raises(InputError, match="is for training"):
        files.find_suite(f"{files.tasks()[0].lower()}-train")


@pytest.mark.parametrize(("change", "why"), [
    ({"schema": 2}, "Install a newer version"),
    ({"schema": 0}, "schema is 0"),
    ({"schema": True}, "True"),
    ({"task": "Juggle"}, "Juggle"),
    ({"more": 1}, "keys"),
    ({"time_limit": 0}, "time|0"),
    ({"control_hz": 20.0}, "int"),
    ({"episodes": {"plain": 1}}, "keys"),
    ({"levels": []}, "levels"),
    ({"levels": [["easy", 0.5, 0.2]]}, "ranges"),
    ({"share": 2}, "2"),
    ({"version": "v\u001b[2J"}, "printed"),
    ({"randomization": {"massive": 1}}, "massive"),
    ({"distribution": {"themes": []}}, "keys"),
    ({"tables": [{}]}, "keys"),
    ({"tables": [0] * 1025}, "1024"),
])  # fmt: skip
def test_a_file_that_is_not_sound_is_refused(
    suite_file: Path, tmp_path: Path, change: dict[str, Any], why: str
) -> None:
    path = tmp_path / "suites.json"
    path.write_text(json.dumps(json.loads(suite_file.read_text()) | change))
    with pytest.raises(InputError, match=why):
        files.read_suites(path)


@pytest.mark.parametrize(("change", "why"), [
    ({"split": "train"}, "split"),
    ({"digest": "../../etc"}, "digest"),
    ({"seed": -1}, "seed"),
    ({"difficulty": "hard"}, "number"),
    ({"instances": [{"successes": 3, "episodes": 2}]}, "3 of 2"),
    ({"instances": [{"successes": 3, "episodes": 3, "shell": "ls"}]}, "shell"),
    ({"instances": [{"successes": 3, "episodes": 3, "target": "a\nb"}]}, "printed"),
])  # fmt: skip
def test_a_table_that_is_not_sound_is_refused(
    suite_file: Path, tmp_path: Path, change: dict[str, Any], why: str
) -> None:
    payload = json.loads(suite_file.read_text())
    payload["tables"][0] |= change
    path = tmp_path / "suites.json"
    path.write_text(json.dumps(payload))
    with pytest.raises(InputError, match=why):
        files.read_suites(path)


def test_a_table_listed_twice_is_refused(suite_file: Path, tmp_path: Path) -> None:
    payload = json.loads(suite_file.read_text())
    payload["tables"].append(payload["tables"][0])
    path = tmp_path / "suites.json"
    path.write_text(json.dumps(payload))
    with pytest.raises(InputError, match="twice"):
        files.read_suites(path)


def test_there_are_suites_of_all_tasks() -> None:
    assert sorted(files.tasks()) == sorted(NAMES)


@pytest.mark.parametrize("task", files.tasks())
def test_the_shipped_suites_are_complete(task: str) -> None:
    shipped = files.shipped_suites(task)
    assert (shipped.version, shipped.task, shipped.hold) == (files.VERSION, task, HOLD)
    for split in LISTED:
        tables = [t for t in shipped.tables if t.split == split]
        counts = {level.name: 0 for level in shipped.levels}
        for table in tables:
            counts[shipped.level(table.difficulty)] += 1
        assert len(counts) == 3 and len(set(counts.values())) == 1, (split, counts)
    for table in shipped.tables:
        recipe = shipped.recipe(table.seed)
        assert table.solvable and table.seed >= shipped.training
        assert shipped.rule(table.split).admits(lambda r=recipe: r.identity, frozenset)
        assert all(i.successes >= STARTS for i in table.solvable)


def test_tables_to_train_at_are_on_the_other_side() -> None:
    task = files.tasks()[0]
    shipped, source = files.shipped_suites(task), training_tables(task)
    rng = np.random.default_rng(0)
    keys = {source.draw(rng).key for _ in range(20)}
    listed = {shipped.recipe(table.seed).key for table in shipped.tables}
    assert len(keys) == 20 and not keys & listed
    assert not any(shipped.rule("train").admits(lambda key=key: key, frozenset) for key in listed)


def test_levels_and_tasks_to_train_at_are_known() -> None:
    with pytest.raises(InputError, match="Unknown level 'brutal'"):
        training_tables(files.tasks()[0], "brutal")
    with pytest.raises(InputError, match="No suites of 'Juggle'"):
        training_tables("Juggle")


@pytest.mark.slow
def test_a_level_is_drawn() -> None:
    from tabletopgen_env.scenes import difficulty

    task = files.tasks()[0]
    level = next(own for own in files.shipped_suites(task).levels if own.name == "hard")
    ref = training_tables(task, "hard").draw(np.random.default_rng(1))
    assert level.holds(difficulty(ref.load()))
