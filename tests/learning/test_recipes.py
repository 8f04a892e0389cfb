"""Recipes: shipped ones are valid, invalid ones are rejected with the valid values."""

import dataclasses
import shutil
import tomllib
import warnings
from pathlib import Path

import numpy as np
import pytest

from generator.bundle import load
from generator.errors import InputError
from tabletopgen_env.learning import commands, training
from tabletopgen_env.learning.networks.actor import inputs_of
from tabletopgen_env.learning.ppo.training import new_ppo
from tabletopgen_env.learning.recipes import FILE, recipe, recipe_of
from tabletopgen_env.learning.setup import (  # fmt: skip
    blank_model,
    count_shared,
    many_envs,
    new_model,
    single_env,
    source_of,
    spec_of,
    vector_env,
    worlds_kept,
)
from tabletopgen_env.learning.training import cloning_config
from tabletopgen_env.randomization import Randomization, Randomizer
from tabletopgen_env.scenes import FixedScenes, RefreshingScenes
from tabletopgen_env.scenes.source import HeldRef

NAMES = tuple(tomllib.loads(FILE.read_text(encoding="utf-8")))
"""The recipes that are shipped."""

GOOD = {"name": "mine", "task": "Lift", "algorithm": "sac"}


def test_the_baselines_are_there() -> None:
    wanted = {
        "reach-sac", "reach-ppo", "reach-clone", "lift-clone", "lift-sac-demos", "lift-ppo",
        "pickplace-clone", "pickplace-sac-her", "push-sac-her",
    }  # fmt: skip
    assert wanted <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_every_shipped_recipe_makes_its_environment_and_model(name: str, table: str) -> None:
    found = recipe(name)
    assert (
        count_shared(source_of(found.scenes, "train"), source_of(found.held_out, "held_out")) == 0
    )
    source = source_of(table, "train")
    few = dataclasses.replace(found, envs=1, options={**found.options, **_less(found.options)})
    single_env(found.task, found.env, source).close()
    if found.algorithm == "ppo-batch":
        envs = vector_env(few, source)
        learner = new_ppo(few, envs, 0)
        envs.close()
        assert learner.export()[0].inputs == inputs_of(envs.single_observation_space)
    else:
        envs = many_envs(few, source, 0)
        model = new_model(few, envs, 0)
        envs.close()
        assert inputs_of(model.observation_space) == inputs_of(envs.observation_space)
    cloning_config(found)
    limit = spec_of(found.task).max_episode_steps
    assert limit and found.options.get("buffer_size", 10**9) > found.demonstrations * limit


@pytest.mark.parametrize("name", NAMES)
def test_every_shipped_recipe_learns_at_fresh_tables_that_stay_in_memory(name: str) -> None:
    found = recipe(name)
    assert found.scenes == found.held_out == "fresh"
    training, validation = (
        source_of("fresh", side, found.variants) for side in ("train", "held_out")
    )
    assert worlds_kept(training) == worlds_kept(validation) == found.variants
    copies = found.envs if found.batch is None else 1  # a batch keeps its worlds on the GPU
    assert found.variants * (14 + 4 * copies) < 8000, "MB"


def _less(options) -> dict:
    return {
        key: least for key, least in (("buffer_size", 1000), ("batch_size", 64)) if key in options
    }


def test_the_help_of_train_names_every_shipped_recipe() -> None:
    words = {word.strip(",.") for word in (commands.train.__doc__ or "").split()}
    assert {*NAMES} <= words


def test_a_recipe_comes_back_from_its_facts() -> None:
    for name in NAMES:
        assert recipe_of(recipe(name).facts()) == recipe(name)


def test_an_unknown_recipe_has_a_near_match() -> None:
    with pytest.raises(InputError, match="Did you mean 'lift-clone'"):
        recipe("lift-clon")


@pytest.mark.parametrize("name", NAMES)
def test_training_starts_are_a_little_off_unless_something_else_is_asked_for(name: str) -> None:
    assert recipe(name).env["randomization"] == "starts"
    assert recipe(name, ['env.randomization="light"']).env["randomization"] == "light"
    plain = recipe(name, ['env.randomization="none"'])
    assert Randomizer(plain.env["randomization"]).settings == Randomization()


def test_a_run_begun_without_randomization_goes_on_without() -> None:
    facts = recipe("reach-sac").facts()
    del facts["env"]["randomization"]
    assert "randomization" not in recipe_of(facts).env


def test_changes_are_merged_into_the_recipe() -> None:
    found = recipe("reach-sac", ["options.gamma=0.5", "steps=7", "env.action=joint_delta"])
    assert (found.options["gamma"], found.steps, found.env["action"]) == (0.5, 7, "joint_delta")
    assert found.options["tau"] == recipe("reach-sac").options["tau"]
    for wrong in ("steps", "steps=x", "=1", "stepz=1", "env=3", "options.x=nan"):
        with pytest.raises(InputError):
            recipe("reach-sac", [wrong])


def test_one_of_your_own_is_a_file(tmp_path: Path) -> None:
    path = tmp_path / "mine.toml"
    path.write_text("task = 'Push'\nalgorithm = 'ppo'\nnetwork = {layers = [8]}\n")
    assert (recipe(str(path)).name, recipe(str(path)).network.layers) == ("mine", (8,))
    for text, why in (
        ("task = ", "not valid TOML"), ("steps = inf", "not a finite number"),
        ("", "setting 'task' is missing"),
        ("options = {a = [2026-01-01]}", "2026-01-01 is a date"),
        ("env = {a = 07:32:00}", "a time"),
    ):  # fmt: skip
        path.write_text(text)
        with pytest.raises(InputError, match=why):
            recipe(str(path))
    with pytest.raises(InputError, match="cannot be read"):
        recipe(str(tmp_path / "other.toml"))


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"task": "Lif"}, "Did you mean 'Lift'"),
        ({"algorithm": "sacc"}, "Did you mean 'sac'"),
        ({"stepz": 1}, "Did you mean 'steps'"),
        ({"steps": 0}, "steps"),
        ({"steps": 1.5}, "whole number"),
        ({"envs": True}, "envs"),
        ({"processes": 0}, "processes"),
        ({"env": {"scenes": "/etc"}}, "has no setting 'scenes'"),
        ({"env": {"actoin": "x"}}, "Did you mean 'action'"),
        ({"network": {"layer": [1]}}, "Did you mean 'layers'"),
        ({"network": {"layers": [10**9]}}, "layers"),
        ({"network": {"layers": []}}, "layers"),
        ({"network": {"activation": "gelu"}}, "activation"),
        ({"network": [1]}, "table of settings"),
        ({"scenes": []}, "scenes must be a string"),
        ({"held_out": 3}, "held_out must be a string"),
        ({"variants": 0}, "variants"),
        ({"variants": 1.5}, "variants"),
        ({"hindsight": 4}, "observation='goal'"),
        ({"hindsight": 4, "env": {"observation": "goal", "grasp_hint": True},
          "network": {"extractor": "goal"}}, "cannot be combined with grasp_hint"),
        ({"algorithm": "ppo", "demonstrations": 3}, "replay buffer"),
        ({"algorithm": "clone"}, r"needs a \[cloning\] table"),
        ({"algorithm": "td3", "cloning": {}}, "only SAC"),
        ({"demonstrations": 3, "env": {"action": "joint_delta"}}, "ee_delta"),
        ({"env": {"observation": "goal"}}, "extractor 'table'"),
        ({"env": {"observation": "pixels"}, "network": {"extractor": "flat"}}, "pictures"),
    ],
)  # fmt: skip
def test_what_does_not_fit_is_refused(changes: dict, why: str) -> None:
    with pytest.raises(InputError, match=why):
        recipe_of({**GOOD, **changes})


def test_options_are_those_of_the_algorithm(small, table: str) -> None:
    env = single_env("Reach", {}, source_of(table, "train"))
    with pytest.raises(InputError, match="Did you mean 'learning_rate'"):
        new_model(small(options={"learning_rat": 1}), env, 0)
    with pytest.raises(InputError, match="no option 'policy'"):
        new_model(small(options={"policy": "x"}), env, 0)
    with pytest.raises(InputError, match="rejects"):
        new_model(small(options={"buffer_size": "many"}), env, 0)
    with pytest.raises(InputError, match="action_noise must be a number >= 0, got 'much'"):
        new_model(small("td3", options={"action_noise": "much"}), env, 0)
    hindsight = {"env": {"observation": "goal"}, "hindsight": 4, "network": {"extractor": "goal"}}
    with pytest.raises(InputError, match="learning_starts must be a whole number"):
        new_model(small(options={"learning_starts": "soon"}, **hindsight), env, 0)
    with pytest.raises(InputError, match="learning_starts must exceed 120"):
        goal = {"observation": "goal"}
        new_model(
            small(hindsight=4, env=goal, network={"extractor": "goal"}),
            single_env("Reach", goal, source_of(table, "train")), 0,
        )  # fmt: skip


@pytest.mark.parametrize("algorithm", ["sac", "td3", "ppo", "clone"])
def test_a_model_is_tried_without_its_environments_or_its_memory(small, algorithm: str) -> None:
    recipe = small(algorithm, envs=16, cloning={} if algorithm == "clone" else None)
    options = (
        {"n_steps": 256, "batch_size": 1024} if algorithm == "ppo" else {"buffer_size": 10**12}
    )
    env = single_env("Reach", {}, source_of(recipe.scenes, "train"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = blank_model(dataclasses.replace(recipe, options=options), env)
    assert model.n_envs == (1 if algorithm == "clone" else 16)
    for wrong in ({"learning_rate": "fast"}, {"buffer_size": 1.5}, {"action_noise": "much"}):
        if algorithm == "td3":
            with pytest.raises(InputError):
                blank_model(dataclasses.replace(recipe, options=wrong), env)


def test_scenes_made_on_demand_are_kept_to_a_side() -> None:
    source = source_of("refreshing", "train")
    assert isinstance(source, RefreshingScenes) and [r.side for r in source._parts()[0].rules] == [
        "train"
    ]


def test_fresh_tables_can_be_few_and_are_then_kept(table: str) -> None:
    rng = np.random.default_rng(0)
    sides = [source_of("fresh", side, 20) for side in ("train", "held_out")]
    keys = [{source.draw(rng).key for _ in range(300)} for source in sides]
    assert len(keys[0] | keys[1]) == 20 and not keys[0] & keys[1] and len(keys[1]) > 1
    assert [worlds_kept(source) for source in sides] == [20, 20]
    endless = source_of("fresh", "train", 10**6)
    assert worlds_kept(endless) == worlds_kept(source_of(table, "train", 20)) == 16
    few = recipe_of({**GOOD, "scenes": "fresh", "variants": 20})
    envs = many_envs(few, sides[0], 0)
    single = single_env("Lift", {}, sides[0])
    caches = [e.unwrapped._worlds._size for e in (envs.venv.slots.envs[0], single)]
    assert caches == [20, 20]
    envs.close()


def test_clones_learn_at_a_few_fresh_tables() -> None:
    variants = {"reach-clone": 150, "lift-clone": 300, "pickplace-clone": 300}
    for name, count in variants.items():
        found = recipe(name)
        assert (found.scenes, found.held_out, found.variants) == ("fresh", "fresh", count)


def test_training_draws_from_as_many_tables_as_the_recipe_says(
    small, folder: Path, monkeypatch
) -> None:
    class Enough(Exception):
        pass

    def begin(*args) -> None:
        raise Enough

    seen = []
    monkeypatch.setattr(training, "_check", lambda recipe, env: seen.append(env))
    monkeypatch.setattr(training, "begin", begin)
    monkeypatch.setattr(training, "count_shared", lambda *both: seen.extend(both))
    with pytest.raises(Enough):
        training.train(small(scenes="fresh", held_out="fresh", variants=7), folder)
    assert [source.variants for source in seen[:2]] == [7, 7]
    assert [source.rules[0].side for source in seen[:2]] == ["train", "held_out"]
    assert seen[2].unwrapped.source is seen[1]


@pytest.mark.slow
def test_tables_in_common_are_told_by_what_they_are(table: str, other: str, tmp_path: Path) -> None:
    copied = str(shutil.copytree(table, tmp_path / "copied"))
    one, two = source_of(table, "train"), source_of((copied, other), "held_out")
    assert count_shared(one, two) == count_shared(two, one) == 1
    assert count_shared(one, source_of(other, "held_out")) == 0
    assert count_shared(one, FixedScenes((HeldRef(load(Path(copied))),))) == 1
    pool, starters = source_of("refreshing", "train"), source_of("starter:train", "train")
    assert count_shared(pool, starters) > 1, "what a pool begins with"
    assert count_shared(pool, source_of("starter:held_out", "held_out")) == 0


def test_a_name_is_printable() -> None:
    for name in ("\x1b[2J", 5, "x" * 300):
        with pytest.raises(InputError, match="A recipe's name"):
            recipe_of({"name": name, "task": "Reach", "algorithm": "sac"})
