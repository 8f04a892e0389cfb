"""The learning commands: output, files, and exit codes."""

import ast
import dataclasses
import runpy
import shutil
import sys
from pathlib import Path

import gymnasium as gym
import numpy as np
import pytest
import torch
from command import command
from PIL import Image
from stable_baselines3 import SAC

from tabletopgen_env.episodes import HOLD
from tabletopgen_env.learning.evaluation import evaluate, play, seeds
from tabletopgen_env.learning.policies import load_policy, save_policy
from tabletopgen_env.learning.runs import LATEST
from tabletopgen_env.learning.setup import single_env, source_of

LIFT = "tabletopgen_env:TabletopGen/Lift-v0"
EXAMPLE = Path(__file__).parents[2] / "examples" / "train_lift.py"

RECIPE = """
task = "Reach"
algorithm = "ppo"
steps = 32
network = {layers = [8]}
options = {n_steps = 16, batch_size = 16, n_epochs = 1}
"""


@pytest.fixture(scope="session")
def trained(tmp_path_factory: pytest.TempPathFactory, table: str, other: str) -> Path:
    folder = tmp_path_factory.mktemp("runs")
    (folder / "tiny.toml").write_text(RECIPE)
    code = command(
        "train", str(folder / "tiny.toml"), "--scenes", table, "--held-out", other,
        "--out", str(folder / "one"), "--episodes", "2", "--seed", "3", "--set", "envs=2",
    )  # fmt: skip
    assert code == 0
    return folder / "one"


@pytest.mark.slow
def test_training_leaves_a_policy(trained: Path) -> None:
    card = load_policy(trained / LATEST).card
    assert (card.recipe, card.seed, card.steps) == ("tiny", 3, 32)


def test_resuming_by_the_command(trained: Path, table: str, other: str, shell) -> None:
    same = ("train", str(trained.parent / "tiny.toml"), "--scenes", table, "--held-out", other,
            "--out", str(trained), "--seed", "3", "--set", "envs=2")  # fmt: skip
    assert "continue with --resume" in shell(*same, code=2).err
    assert "32 steps of tiny" in shell(*same, "--resume").out


@pytest.mark.slow
def test_enjoying_reports_success_with_its_interval(trained: Path, other: str, shell) -> None:
    told = [
        shell("enjoy", str(name), "--scenes", other, "--episodes", "2").out
        for name in (trained, trained / LATEST, trained)
    ]
    rest = [lines.partition("\n")[2] for lines in told]
    assert rest[0] == rest[1] == rest[2]
    first = f"best.safetensors: tiny, seed 3, 32 steps; validation: 0 of 2 on {other} (tables: 1)"
    assert told[0].startswith(first + "\n")
    assert told[0].count("failed in  60 steps: ") == 2
    assert f"Reach on {other}: 0 of 2 solved on 1 table, 0 % (0 to 66 %)" in told[0]


@pytest.mark.slow
def test_enjoying_where_it_was_trained_is_said(
    trained: Path, table: str, other: str, tmp_path: Path, shell
) -> None:
    copied = str(shutil.copytree(table, tmp_path / "copied"))
    for scenes, said in ((copied, "1 of these tables was used in training"), (other, "")):
        err = shell("enjoy", str(trained), "--scenes", scenes, "--episodes", "1").err
        assert said in err and bool(said) == bool(err)
    policy = load_policy(trained / LATEST)
    gone = dataclasses.replace(policy.card, scenes=("/none",))
    path = save_policy(dataclasses.replace(policy, card=gone), tmp_path / "p.safetensors")
    told = shell("enjoy", str(path), "--scenes", other, "--episodes", "1").err
    assert "trained on these tables: No bundle" in told


@pytest.mark.slow
def test_a_film_strip_is_written(trained: Path, table: str, tmp_path: Path) -> None:
    strip = tmp_path / "new" / "strip.png"
    args = ("--scenes", table, "--episodes", "1", "--video-strip", str(strip))
    assert command("enjoy", str(trained), *args) == 0
    with Image.open(strip) as picture:
        assert picture.size == (6 * 320, 320)
        cells = [picture.crop((320 * k, 0, 320 * k + 320, 320)).tobytes() for k in range(6)]
        assert len(set(cells)) > 1, "the arm moves"


def test_zips_are_loaded_only_if_trusted(trained: Path, table: str, shell) -> None:
    (zipped,) = trained.glob("checkpoint-*/model.zip")
    assert "--trust" in shell("enjoy", str(zipped), "--scenes", table, code=2).err
    args = ("--scenes", table, "--episodes", "1", "--trust")
    own = shell("enjoy", str(zipped), *args).out
    assert shell("enjoy", str(trained / LATEST), *args[:-1]).out.endswith(own), (
        "the zip plays as the policy file does"
    )
    wrong = trained.parent / "wrong.zip"
    wrong.write_bytes(b"no zip")
    told = shell("enjoy", str(wrong), "--trust", "--recipe", "reach-td3", code=2).err
    assert "cannot be loaded as TD3" in told


@pytest.mark.parametrize(
    ("args", "code", "why"),
    [
        (("enjoy", "nothing"), 2, "Unknown policy 'nothing'"),
        (("enjoy", "{}", "--episodes", "0"), 2, "whole number >= 1"),
        (("enjoy", "{}", "--seed", "-1"), 2, "A seed must be a whole number from 0"),
        (("train", "reach-sac", "--seed", "-1"), 2, "A seed must be a whole number from 0"),
        (("train", "reach-sac", "--out", "/dev/null"), 5, "cannot be written"),
        (("plot", "{}", "--out", "/"), 5, "cannot be written"),
        (("enjoy", "{}", "--scenes", "/none"), 4, "No bundle"),
        (("enjoy", "{}", "--render", "--video-strip", "x.png"), 2, "not both"),
        (("enjoy", "{}", "--workers", "2", "--video-strip", "x.png"), 2, "remove --workers"),
        (("enjoy", "{}", "--ray", "auto", "--render"), 2, "remove --workers and --ray"),
        (("enjoy", "{}", "--workers", "0"), 2, "--workers must be"),
        (("enjoy", "{}/.."), 2, "no policy yet"),
        (("train", "reach-sacc"), 2, "Did you mean 'reach-sac'"),
        (("train", "reach-clone", "--steps", "9"), 2, "cloning.rounds"),
        (("train", "reach-sac", "--steps", "0"), 2, "steps"),
        (("train", "reach-sac", "--set", "gamma"), 2, "key=value"),
        (("plot",), 2, "at least one"),
        (("plot", "/none"), 2, "not the folder of a run"),
        (("train",), 2, "required"),
    ],
)
def test_wrong_requests_are_explained(
    trained: Path, args, code, why, shell, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert why in shell(*(a.format(trained) for a in args), code=code).err
    assert not Path("runs").exists()


def test_sb3_missing_is_said_with_the_pip_line(monkeypatch, shell) -> None:
    monkeypatch.setitem(sys.modules, "stable_baselines3", None)
    for args in (("train", "reach-sac"), ("enjoy", "x"), ("plot", "x")):
        assert "pip install 'tabletopgen[train]'" in shell(*args, code=2).err


def test_success_has_to_be_held(table: str) -> None:
    class Idle:
        def predict(self, observation, *, deterministic):
            return np.zeros(5, np.float32), None

    class Held:
        """Fake of an environment that has succeeded for some steps."""

        digest = "a table"

        def __init__(self, steps: int) -> None:
            self.steps = steps

        def get_wrapper_attr(self, name):
            return self

        def reset(self, seed):
            self.at = 0
            return np.zeros(1), {}

        def step(self, action):
            self.at += 1
            info = {"success": 3 <= self.at < 3 + self.steps, "instruction": "wait"}
            return np.zeros(1), 0.5, False, self.at == 20, info

    assert not play(Held(HOLD - 1), Idle(), 0).solved  # type: ignore[arg-type]
    played = play(Held(HOLD), Idle(), 0)  # type: ignore[arg-type]
    assert played.solved and played.steps == HOLD + 2 and played.reward == 0.5
    assert list(seeds(1, 5))[:3] == list(seeds(1, 3)) != list(seeds(2, 3))
    env = single_env("Reach", {}, source_of(table, "held_out"))
    assert evaluate(env, Idle(), 2) == evaluate(env, Idle(), 2) != evaluate(env, Idle(), 2, seed=1)


@pytest.mark.slow
def test_the_newcomers_script_is_short_and_trains(
    table: str, tmp_path: Path, monkeypatch, capsys
) -> None:
    tree = ast.parse(EXAMPLE.read_text())
    (docstring, *_) = tree.body
    lines = [line for line in EXAMPLE.read_text().splitlines() if line.strip()]
    assert len(lines) - (docstring.end_lineno or 0) <= 15
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(EXAMPLE))["main"](2, 2, 20)
    rounds = [line for line in capsys.readouterr().out.splitlines() if line.startswith("Round(")]
    assert len(rounds) == 2
    trained = SAC.load(tmp_path / "out" / "lift.zip", device="cpu")
    assert trained.observation_space.shape == (287,)
    env = gym.make(LIFT, scenes=table, grasp_hint="detected")
    fresh = SAC(
        "MlpPolicy", env, policy_kwargs=trained.policy_kwargs, seed=0, buffer_size=1, device="cpu"
    )
    before, after = (m.actor.state_dict() for m in (fresh, trained))
    fitted = [k for k in before if not k.startswith("log_std")]
    assert all(not torch.equal(before[k], after[k]) for k in fitted), "all weights move"
    assert trained.predict(env.reset(seed=0)[0], deterministic=True)[0].shape == (5,)
