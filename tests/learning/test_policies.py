"""Policy files: exact round trips, and rejection of invalid files."""

import dataclasses
import json
import warnings
from pathlib import Path

import numpy as np
import pytest
import torch
from safetensors.torch import load_file, save_file
from toy import toy_scene

from generator.errors import InputError, StorageError
from tabletopgen_env.env import make_env
from tabletopgen_env.learning import commands, policies
from tabletopgen_env.learning.algorithms.sb3 import Sb3Learner
from tabletopgen_env.learning.networks.actor import inputs_of, tensors_of
from tabletopgen_env.learning.policies import (
    FORMAT,
    KEY,
    TrainedPolicy,
    find_policy,
    load_policy,
    policy_from,
    save_policy,
)  # fmt: skip
from tabletopgen_env.learning.runs import BEST, LATEST
from tabletopgen_env.learning.setup import new_model, single_env, source_of
from tabletopgen_env.observations.modes import observation_space
from tabletopgen_env.rendering.config import ObservationConfig

GOAL = {"observation": "goal"}
KINDS = [
    ("sac", {}),
    ("sac", {"env": GOAL, "network": {"extractor": "goal", "layers": [8, 8]}}),
    ("td3", {"env": GOAL, "network": {"extractor": "flat", "layers": [8]}}),
    ("td3", {}),
    ("ppo", {"network": {"layers": [16], "activation": "tanh"}}),
    ("clone", {"cloning": {}, "network": {"extractor": "flat", "layers": [8]}}),
]


def trained(small, algorithm: str = "sac", seed: int = 0, **changes):
    """A model, some observations, and its policy."""
    recipe = small(algorithm, **changes)
    env = single_env(recipe.task, recipe.env, source_of(recipe.scenes, "train"))
    model = new_model(recipe, env, seed)
    env.action_space.seed(0)
    seen = [env.reset(seed=1)[0]]
    seen += [env.step(env.action_space.sample())[0] for _ in range(5)]
    return model, seen, policy_from(Sb3Learner(model, recipe.network), recipe, seed)


@pytest.fixture
def policy(small) -> TrainedPolicy:
    return trained(small)[2]


@pytest.mark.slow
@pytest.mark.parametrize(("algorithm", "changes"), KINDS)
def test_a_file_predicts_what_the_model_does(small, tmp_path: Path, algorithm, changes) -> None:
    model, seen, policy = trained(small, algorithm, **changes)
    read = load_policy(str(save_policy(policy, f"{tmp_path}/p.safetensors")))
    assert read.card == policy.card
    moved = set()
    for one in seen:
        wanted = model.predict(one, deterministic=True)[0]
        got, state = read.predict(one, deterministic=True)
        assert np.array_equal(got, wanted) and got.dtype == wanted.dtype and state is None
        moved.add(got.tobytes())
    assert len(moved) > 1, "predictions that are all alike show nothing"
    stack = (lambda p: np.stack([s[p] for s in seen])) if isinstance(seen[0], dict) else None
    batch = {k: stack(k) for k in seen[0]} if stack else np.stack(seen)
    wanted = model.predict(batch, deterministic=True)[0]
    assert np.array_equal(read.predict(batch)[0], wanted)


def test_half_precision_is_half_the_size_and_nearly_the_same(small, tmp_path: Path) -> None:
    _, seen, policy = trained(small, network={"layers": [256, 256]})
    full = save_policy(policy, tmp_path / "full.safetensors")
    half = save_policy(policy, tmp_path / "half.safetensors", half=True)
    assert half.stat().st_size < 0.52 * full.stat().st_size
    one, other = (load_policy(p).predict(seen[2])[0] for p in (full, half))
    assert 0 < np.abs(one - other).max() < 1e-2
    again = save_policy(load_policy(half), tmp_path / "again.safetensors", half=True)
    assert again.read_bytes() == half.read_bytes()


def test_the_same_policy_gives_the_same_bytes(small, tmp_path: Path) -> None:
    one, other, third = (trained(small, seed=s)[2] for s in (0, 0, 1))
    files = [save_policy(p, tmp_path / f"{k}").read_bytes() for k, p in
             enumerate((one, other, third))]  # fmt: skip
    assert files[0] == files[1] != files[2]


def test_the_card_says_where_it_is_from(small, policy: TrainedPolicy, table: str) -> None:
    card = policy.card
    assert card.scenes == (table,) and card.validation == {}
    assert (card.task, card.recipe, card.seed, card.actions) == ("Reach", "small-sac", 0, 5)
    assert card.inputs == {"": 279} and {"mujoco", "torch"} <= set(card.versions)


def test_wrong_observations_are_refused(policy: TrainedPolicy) -> None:
    for wrong in (np.zeros(7), np.zeros((1, 1, 279)), {"observation": np.zeros(279)}, 3.0):
        with pytest.raises(InputError, match="The policy requires"):
            policy.predict(wrong)
    with pytest.raises(InputError, match="deterministic=True"):
        policy.predict(np.zeros(279), deterministic=False)


def respelt(path: Path, **changes) -> Path:
    """Write a policy file again with another card."""
    with policies.safe_open(path, framework="pt") as file:
        notes = file.metadata()
    card = json.loads(notes[KEY]) | changes
    save_file(load_file(path), path, {KEY: json.dumps(card)})
    return path


@pytest.mark.slow
@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"task": "Juggle"}, "unknown task 'Juggle'"),
        ({"env": {"scenes": "/etc"}}, "has no setting 'scenes'"),
        ({"env": {"observation": "point_cloud", "points": 10**12}}, "observation='state'"),
        ({"inputs": {"": 10**9}}, "invalid sizes"),
        ({"inputs": {}}, "invalid observation parts"),
        ({"inputs": {"": True}}, "type int"),
        ({"inputs": {"": 278}}, "279"),
        ({"actions": -1}, "invalid sizes"),
        ({"actions": 4}, r"not \(4, 16\)|not \(4,\)"),
        ({"network": {"layers": [4096] * 8}}, "invalid layer widths"),
        ({"network": {"layers": [16, 17], "width": 8}}, "is torch.float32"),
        ({"network": {"layers": [16], "width": 8}}, "do not match the network"),
        ({"squash": "sigmoid"}, "unknown squash function 'sigmoid'"),
        ({"seed": "0"}, "type int"),
        ({"validation": {"solved": 9, "episodes": 4, "tables": 1, "scenes": "x"}}, "9 of 4"),
        ({"validation": {"solved": 2, "episodes": 4, "tables": 5, "scenes": "x"}}, "5 tables"),
        ({"scenes": "starter"}, "type list"),
        ({"scenes": [3]}, "type str"),
        ({"versions": {"mujoco": 3}}, "type str"),
        ({"more": 1}, "has unexpected keys"),
        ({"recipe": "reach\x1b[2J"}, "must be printable"),
        ({"env": {"randomization": "\u202elight"}}, "must be printable"),
        ({"versions": {"mujoco\n": "3"}}, "must be printable"),
        ({"scenes": ["starter\x07"]}, "must be printable"),
    ],
)
def test_a_card_that_is_not_sound_is_refused(policy, tmp_path: Path, changes, why) -> None:
    path = respelt(save_policy(policy, tmp_path / "p.safetensors"), **changes)
    with pytest.raises(InputError, match=why):
        load_policy(path)


@pytest.mark.parametrize(
    ("notes", "why"),
    [
        (None, "has no 'tabletopgen_policy'"),
        ({"format": "pt"}, "has no 'tabletopgen_policy'"),
        (
            {KEY: json.dumps({"format": FORMAT + 1})},
            "version is 2, but this package reads version 1",
        ),
        ({KEY: json.dumps({"format": True})}, "version is True, but this package reads version 1"),
        ({KEY: json.dumps({"format": FORMAT})}, "has unexpected keys"),
        ({KEY: "[" * 5000}, "not a valid policy"),
        ({KEY: "[NaN]"}, "NaN"),
        ({KEY: "[1]"}, "must be a JSON object"),
        ({KEY: " " * 10**5}, "more than"),
    ],
)
def test_a_foreign_file_is_refused(tmp_path: Path, notes, why) -> None:
    path = tmp_path / "p.safetensors"
    save_file({"weight": torch.zeros(3)}, path, notes)
    with pytest.raises(InputError, match=why):
        load_policy(path)


def test_damaged_files_are_refused(policy: TrainedPolicy, tmp_path: Path) -> None:
    path = save_policy(policy, tmp_path / "p.safetensors")
    whole = path.read_bytes()
    for content in (
        b"",
        b"PK\x03\x04" + whole[:99],
        whole[: len(whole) // 2],
        whole[:40],
        b"\xff" * 64,
    ):
        path.write_bytes(content)
        with pytest.raises(InputError, match="not a valid policy file"):
            load_policy(path)
    with pytest.raises(InputError, match="contains no policy yet"):
        load_policy(tmp_path)


def test_huge_files_are_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "p.safetensors"
    with path.open("wb") as file:
        file.truncate(policies.MOST_BYTES + 1)
    with pytest.raises(InputError, match="exceeds the"):
        load_policy(path)


def test_weights_that_are_not_finite_are_refused(policy: TrainedPolicy, tmp_path: Path) -> None:
    path = save_policy(policy, tmp_path / "p.safetensors")
    with policies.safe_open(path, framework="pt") as file:
        notes = file.metadata()
    weights = load_file(path)
    weights["last.bias"][0] = float("nan")
    save_file(weights, path, notes)
    with pytest.raises(InputError, match="bias is not finite"):
        load_policy(path)
    weights["last.bias"] = torch.zeros(5, dtype=torch.int32)
    save_file(weights, path, notes)
    with pytest.raises(InputError, match="int32"):
        load_policy(path)


def test_a_network_that_computes_otherwise_is_refused(small, tmp_path: Path, monkeypatch) -> None:
    _, _, policy = trained(small)
    for half in (False, True):
        path = save_policy(policy, tmp_path / "p.safetensors", half)
        load_policy(path)
        with monkeypatch.context() as changed:
            changed.setattr(
                "tabletopgen_env.learning.networks.network._ROBOT_SCALE", np.full(40, 0.7)
            )
            with pytest.raises(InputError, match="outputs differ"):
                load_policy(path)


@pytest.mark.slow
def test_goals_are_looked_at_as_the_state_is() -> None:
    from tabletopgen_env.learning.networks.goal_extractor import GoalExtractor
    from tabletopgen_env.learning.networks.network import TableExtractor

    for hint in (False, True):
        features = []
        for mode, kind in (("state", TableExtractor), ("goal", GoalExtractor)):
            env = make_env(toy_scene(), task="Lift", observation=mode, grasp_hint=hint)
            seen = env.reset(seed=4)[0]
            torch.manual_seed(0)
            network = kind(env.observation_space)
            inputs = inputs_of(env.observation_space)
            features.append(network(tensors_of(inputs, seen)[0]))
        assert torch.allclose(*features, atol=1e-6)
        seen["desired_goal"] = seen["desired_goal"] + np.float32(0.1)
        assert not torch.allclose(network(tensors_of(inputs, seen)[0]), features[1])


def test_what_is_too_large_is_not_written(small, tmp_path: Path) -> None:
    policy = trained(small, network={"layers": [1200, 1200]})[2]
    with pytest.raises(InputError, match="half=True"):
        save_policy(policy, tmp_path / "p.safetensors")
    with pytest.raises(StorageError, match="another folder"):
        save_policy(trained(small)[2], tmp_path / "none" / "p.safetensors")
    assert list(tmp_path.iterdir()) == []


def test_a_card_that_cannot_be_shown_is_not_written(policy, tmp_path: Path) -> None:
    card = dataclasses.replace(policy.card, recipe="mine\x1b[2J")
    with pytest.raises(InputError, match="must be printable"):
        save_policy(dataclasses.replace(policy, card=card), tmp_path / "p.safetensors")
    assert list(tmp_path.iterdir()) == []


def test_policies_are_found_by_name_or_path(policy, tmp_path: Path, monkeypatch) -> None:
    path = save_policy(policy, tmp_path / "reach-one.safetensors")
    monkeypatch.setattr(policies, "SHIPPED", tmp_path)
    assert find_policy("reach-one") == find_policy(str(path)) == path
    run = tmp_path / "run"
    run.mkdir()
    with pytest.raises(InputError, match="contains no policy yet"):
        find_policy(run)
    latest = save_policy(policy, run / LATEST)
    assert find_policy(run) == latest
    best = save_policy(policy, run / BEST)
    assert find_policy(str(run)) == best and load_policy(run).card == policy.card
    with pytest.raises(InputError, match="Did you mean 'reach-one'"):
        find_policy("reach-on")
    one, other = load_policy("reach-one"), load_policy(path)
    assert one.card == other.card == policy.card
    with pytest.raises(InputError, match="Did you mean 'reach-one'"):
        load_policy("reach-on")


def test_pictures_have_no_policy_files(small) -> None:
    space = observation_space(ObservationConfig("pixels", ("front",), ("rgb",), 64, 64))
    with pytest.raises(InputError, match="height maps and pictures with calibrations"):
        inputs_of(space)


def test_a_policy_says_which_detector_it_learned_with(small, tmp_path: Path, monkeypatch) -> None:
    _, _, made = trained(small, env={"grasp_hint": "detected"})
    digest = made.card.versions["grasp-detector"]
    path = save_policy(made, tmp_path / "p.safetensors")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        load_policy(path)
    monkeypatch.setattr("tabletopgen_env.detection.detector.shipped_digest", lambda: digest[::-1])
    with pytest.warns(UserWarning, match="another version of the grasp detector"):
        load_policy(path)
    assert "grasp-detector" not in trained(small)[2].card.versions


def test_what_is_said_of_a_policy_suits_a_terminal(policy, tmp_path: Path, capsys) -> None:
    path = save_policy(policy, tmp_path / "p\x1b[2J.safetensors")
    commands._load(str(path), trust=False, recipe=None)
    assert capsys.readouterr().out.startswith(r"p\x1b[2J.safetensors: ")
