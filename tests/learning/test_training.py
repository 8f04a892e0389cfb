"""Training: every algorithm runs, is reproducible, resumes, and writes its files."""

import json
import os
import shutil
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from gymnasium.spaces import Box
from stable_baselines3 import PPO, SAC
from stable_baselines3.common.vec_env import VecMonitor

from generator.errors import InputError, SceneError, TabletopError
from tabletopgen_env.env import TabletopEnv
from tabletopgen_env.learning import extra, progress, training
from tabletopgen_env.learning.algorithms.sb3 import Sb3Learner
from tabletopgen_env.learning.demonstrations import replay
from tabletopgen_env.learning.demonstrations.recorded import demonstrate
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.runs import BEST, LATEST, open_run
from tabletopgen_env.learning.setup import load_zip
from tabletopgen_env.learning.training import train

QUICK = TrainingPlan(evaluate_every=60, episodes=2)
GOAL = {"observation": "goal", "reward": "sparse"}
CLONING = {"rounds": 2, "episodes": 2, "steps": 20, "last_steps": 20, "batch": 32}
FAMILIES = {
    "sac": ("sac", {}),
    "sac with demonstrations": ("sac", {"demonstrations": 2}),
    "sac from a clone": ("sac", {"cloning": {**CLONING, "rounds": 1}}),
    "sac in hindsight": ("sac", {"env": GOAL, "hindsight": 4, "demonstrations": 2,
                                 "network": {"extractor": "goal", "layers": [8]}}),
    "td3": ("td3", {}),
    "ppo": ("ppo", {"network": {"layers": [8], "activation": "tanh"}}),
    "ppo-batch": ("ppo-batch", {"network": {"layers": [8], "activation": "tanh"}}),
    "clone": ("clone", {"cloning": CLONING}),
}  # fmt: skip


def quiet(line: str) -> None:
    assert line


@pytest.mark.slow
@pytest.mark.parametrize("family", FAMILIES)
def test_every_family_trains(small, folder: Path, family: str) -> None:
    algorithm, changes = FAMILIES[family]
    recipe = small(algorithm, **changes)
    done = train(recipe, folder, QUICK, say=quiet)
    assert not done.interrupted
    run = open_run(folder)
    assert run.recipe == recipe and run.seed == 0
    rows = run.rows()
    assert rows and rows[-1].steps == done.steps and all(r.episodes == 2 for r in rows)
    if algorithm != "clone":
        assert recipe.steps <= done.steps < recipe.steps + 40
        assert rows[0].steps in range(60, 100)
    policy = load_policy(folder / LATEST)
    assert policy.card.steps == done.steps
    told = {"solved": rows[-1].solved, "episodes": 2, "tables": 1, "scenes": recipe.held_out}
    assert policy.card.validation == told and policy.card.scenes == (recipe.scenes,)
    best = load_policy(folder / BEST).card.validation["solved"]
    assert best == max(r.solved for r in rows)
    assert list((folder / "tensorboard").iterdir())


@pytest.mark.slow
@pytest.mark.parametrize(
    ("family", "wanted"),
    [
        ("sac with demonstrations", {"fill", "learn", "evaluate"}),
        ("sac from a clone", {"clone", "learn", "evaluate"}),
        ("clone", {"clone", "evaluate"}),
    ],
)
def test_only_evaluations_are_at_held_out_tables(
    small, folder: Path, monkeypatch, family: str, wanted: set[str]
) -> None:
    met: dict[str, set[str]] = {}
    doing = ["checking"]

    def noting(what: str, call: Any) -> Any:
        def noted(*args: Any, **kwargs: Any) -> Any:
            doing.append(what)
            try:
                return call(*args, **kwargs)
            finally:
                doing.pop()

        return noted

    def reset(self: TabletopEnv, **kwargs: Any) -> Any:
        seen, info = begun(self, **kwargs)
        met.setdefault(doing[-1], set()).add(info["scene"])
        return seen, info

    begun = TabletopEnv.reset
    monkeypatch.setattr(TabletopEnv, "reset", reset)
    for place, name in ((training, "fill"), (training, "clone"), (progress, "evaluate")):
        monkeypatch.setattr(place, name, noting(name, getattr(place, name)))
    monkeypatch.setattr(SAC, "learn", noting("learn", SAC.learn))
    algorithm, changes = FAMILIES[family]
    train(small(algorithm, **changes), folder, QUICK, say=quiet)
    assert met.pop("evaluate") == {"other"}
    met.pop("checking")
    assert met == {name: {"table"} for name in wanted - {"evaluate"}}


def weights(folder: Path) -> dict[str, np.ndarray]:
    state = load_policy(folder / LATEST).actor.state_dict()
    return {name: value.numpy() for name, value in state.items()}


def alike(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> bool:
    return all(np.array_equal(one[k], other[k]) for k in one)


@pytest.mark.slow
@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize("algorithm", ["sac", "ppo", "ppo-batch"])
def test_the_same_seed_trains_the_same_weights(small, tmp_path: Path, algorithm: str) -> None:
    made = []
    for number, (seed, processes) in enumerate(((0, None), (0, None), (0, 2), (1, None))):
        folder, small_one = tmp_path / str(number), small(algorithm, steps=64, processes=processes)
        train(small_one, folder, TrainingPlan(seed, episodes=1), say=quiet)
        made.append(weights(folder))
    assert alike(made[0], made[1]) and alike(made[0], made[2]) and not alike(made[0], made[3])


@pytest.mark.slow
@pytest.mark.parametrize("algorithm", ["sac", "ppo", "ppo-batch"])
def test_resuming_goes_on_with_the_counts(small, folder: Path, algorithm: str) -> None:
    network = {"layers": [8]}
    train(small(algorithm, steps=60, network=network), folder, QUICK, say=quiet)
    before, kept = open_run(folder).rows(), open_run(folder).checkpoint
    counts = json.loads((kept / "counts.json").read_text())
    assert counts["steps"] == before[-1].steps >= 60 and counts["updates"] > 0
    told: list[str] = []
    done = train(small(algorithm, steps=180, network=network), folder, QUICK, True, told.append)
    rows = open_run(folder).rows()
    assert rows[: len(before)] == before and len(rows) > len(before)
    assert [r.steps for r in rows] == sorted({r.steps for r in rows})
    assert done.steps == rows[-1].steps >= 180
    after = open_run(folder).checkpoint
    assert [p.name for p in folder.glob("checkpoint-*")] == [after.name] != [kept.name]
    more = json.loads((after / "counts.json").read_text())
    steps, updates = (more[k] - counts[k] for k in ("steps", "updates"))
    epochs = pytest.approx(steps / 32, abs=1)
    assert updates == {"sac": steps // 2, "ppo": epochs, "ppo-batch": steps // 16}[algorithm]
    assert more["seconds"] > counts["seconds"]
    if algorithm == "sac":
        with np.load(after / "replay.npz") as file:
            assert int(file["position"][0]) == done.steps // 2, "it went on filling the same buffer"


@pytest.mark.slow
def test_a_checkpoint_restores_weights_optimisers_and_temperature(small, folder: Path) -> None:
    from tabletopgen_env.learning.setup import many_envs, new_model, source_of

    recipe = small(steps=60)
    train(recipe, folder, QUICK, say=quiet)
    run = open_run(folder)
    model = new_model(recipe, many_envs(recipe, source_of(recipe.scenes, "train"), 0), 5)
    assert isinstance(model, SAC)
    fresh = model.log_ent_coef.item()
    run.restore(Sb3Learner(model, recipe.network))
    loaded = load_zip(run.checkpoint / "model.zip", recipe)
    assert isinstance(loaded, SAC)
    assert model.log_ent_coef.item() == loaded.log_ent_coef.item() != fresh
    for mine, other in zip(model.policy.parameters(), loaded.policy.parameters(), strict=True):
        assert bool((mine == other).all())
    state = model.actor.optimizer.state_dict()["state"]
    assert state and state.keys() == loaded.actor.optimizer.state_dict()["state"].keys()


@pytest.mark.slow
def test_without_its_replay_buffer_a_run_fills_it_anew(small, folder: Path, monkeypatch) -> None:
    plan = TrainingPlan(episodes=1, keep_replay=False)
    train(small(steps=40, demonstrations=2), folder, plan, say=quiet)
    told: list[str] = []
    before = json.loads((open_run(folder).checkpoint / "counts.json").read_text())

    def random(self: Box, *args: Any, **kwargs: Any) -> None:
        raise AssertionError("what has been learned acts, not chance")

    monkeypatch.setattr(Box, "sample", random)
    done = train(small(steps=80, demonstrations=2), folder, plan, True, told.append)
    assert any("policy refills it" in line for line in told)
    assert any("2 demonstrations" in line for line in told)
    after = json.loads((open_run(folder).checkpoint / "counts.json").read_text())
    steps = done.steps - before["steps"] - 20  # learning_starts
    assert after["updates"] - before["updates"] == steps // 2 > 0


@pytest.mark.slow
def test_what_goes_on_does_not_repeat_itself(small, tmp_path: Path, monkeypatch) -> None:
    drawn: list[tuple[int, tuple[int | None, ...]]] = []
    learn = PPO.learn

    def noting(self: PPO, *args: Any, **kwargs: Any) -> Any:
        assert isinstance(self.env, VecMonitor)
        drawn.append((torch.initial_seed(), tuple(self.env.venv._seeds)))
        return learn(self, *args, **kwargs)

    monkeypatch.setattr(PPO, "learn", noting)
    plan = TrainingPlan(episodes=1)
    train(small("ppo", steps=32), tmp_path / "a", plan, say=quiet)
    for name in "bc":
        shutil.copytree(tmp_path / "a", tmp_path / name)
        train(small("ppo", steps=64), tmp_path / name, plan, True, quiet)
    train(small("ppo", steps=96), tmp_path / "c", plan, True, quiet)
    begun, first, second, third = drawn
    assert first == second and len({begun, first, third}) == 3
    assert len({seed for _, slots in (begun, first, third) for seed in slots}) == 6


@pytest.mark.slow
def test_a_finished_run_says_so(small, folder: Path) -> None:
    train(small("ppo", steps=32), str(folder), TrainingPlan(episodes=1), say=quiet)
    told: list[str] = []
    assert (
        train(small("ppo", steps=32), folder, TrainingPlan(episodes=1), True, told.append).steps
        == 32
    )
    assert any("has completed its 32 steps" in line for line in told)


@pytest.mark.slow
def test_what_cannot_be_resumed_or_begun_is_refused(small, folder: Path) -> None:
    with pytest.raises(InputError, match="not the folder of a run"):
        train(small(), folder, QUICK, resume=True, say=quiet)
    train(small("ppo", steps=32), folder, TrainingPlan(episodes=1), say=quiet)
    with pytest.raises(InputError, match="already contains a run"):
        train(small("ppo"), folder, QUICK, say=quiet)
    with pytest.raises(InputError, match="differs in task"):
        train(small("ppo", task="Lift"), folder, QUICK, resume=True, say=quiet)
    with pytest.raises(InputError, match="differs in the seed"):
        train(small("ppo"), folder, TrainingPlan(seed=4), resume=True, say=quiet)
    (folder / "recipe.json").write_text("{")
    with pytest.raises(InputError, match="damaged"):
        open_run(folder)
    with pytest.raises(InputError, match="other files"):
        train(small(), folder.parent, QUICK, say=quiet)


def test_a_wrong_recipe_leaves_nothing_behind(small, folder: Path) -> None:
    for wrong, why in (
        ({"options": {"nothing": 1}}, "nothing"),
        ({"cloning": {"nothing": 1}}, "nothing"),
        ({"network": {"layers": [1200, 1200]}}, "exceeds the maximum of"),
        ({"task": "Stack"}, "no valid task"),
    ):
        with pytest.raises(TabletopError, match=why):
            train(small(**wrong), folder, QUICK, say=quiet)
    assert not folder.exists()


def test_a_run_that_never_began_leaves_nothing_behind(small, folder: Path, monkeypatch) -> None:
    monkeypatch.setattr(
        "tabletopgen_env.learning.demonstrations.replay.demonstrate", lambda *a, **k: None
    )
    with pytest.raises(SceneError, match="solves none"):
        train(small(demonstrations=2), folder, QUICK, say=quiet)
    assert not folder.exists()
    folder.mkdir()
    with pytest.raises(SceneError, match="solves none"):
        train(small(demonstrations=2), folder, QUICK, say=quiet)
    assert list(folder.iterdir()) == [], "the folder was there before"


@pytest.mark.slow
def test_a_late_error_deletes_nothing(small, folder: Path, monkeypatch) -> None:
    def broken(*args) -> None:
        raise SceneError("the table fell over")

    with monkeypatch.context() as changed, pytest.raises(SceneError, match="fell over"):
        changed.setattr(progress, "evaluate", broken)
        train(small(), folder, QUICK, say=quiet)
    assert open_run(folder).recipe == small() and open_run(folder).rows() == []
    assert list((folder / "tensorboard").iterdir())
    assert train(small(), folder, QUICK, True, quiet).steps >= 120, "it can be begun again"


@pytest.mark.slow
def test_a_damaged_checkpoint_is_refused_and_kept(small, folder: Path) -> None:
    train(small("ppo", steps=32), folder, TrainingPlan(episodes=1), say=quiet)
    zipped = open_run(folder).checkpoint / "model.zip"
    zipped.write_bytes(zipped.read_bytes()[:900])
    with pytest.raises(InputError, match="not a valid checkpoint of small-ppo"):
        train(small("ppo", steps=64), folder, TrainingPlan(episodes=1), True, quiet)
    assert len(open_run(folder).rows()) == 1 and zipped.exists()


@pytest.mark.slow
def test_the_first_interrupt_ends_with_a_checkpoint(small, folder: Path) -> None:
    told: list[str] = []

    def say(line: str) -> None:
        told.append(line)
        if line.startswith("60 steps"):
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.getsignal(signal.SIGINT)
    done = train(small(steps=10_000), folder, QUICK, say=say)
    assert done.interrupted and 60 <= done.steps < 10_000
    assert signal.getsignal(signal.SIGINT) is before
    assert open_run(folder).checkpoint.name == f"checkpoint-{done.steps}"
    assert any("Ctrl-C again" in line for line in told)
    again = train(small(steps=done.steps + 20), folder, QUICK, True, quiet)
    assert again.steps == done.steps + 20


@pytest.mark.slow
def test_demonstrations_can_be_interrupted(small, folder: Path, monkeypatch) -> None:
    begun = []

    def interrupting(*args: Any, **kwargs: Any) -> Any:
        begun.append(1)
        os.kill(os.getpid(), signal.SIGINT)
        return demonstrate(*args, **kwargs)

    recipe = small(demonstrations=8)
    with monkeypatch.context() as changed:
        changed.setattr(replay, "demonstrate", interrupting)
        done = train(recipe, folder, QUICK, say=quiet)
    assert done.interrupted and done.steps == 0 and len(begun) == 1
    assert not open_run(folder).kept, "half of them are no start"
    assert train(recipe, folder, QUICK, True, quiet).steps >= 120


@pytest.mark.slow
def test_what_comes_before_the_first_step_is_kept(small, folder: Path, monkeypatch) -> None:
    def say(line: str) -> None:
        if line.startswith("2 demonstrations"):
            os.kill(os.getpid(), signal.SIGINT)

    recipe = small(demonstrations=2, cloning={**CLONING, "rounds": 1})
    done = train(recipe, folder, QUICK, say=say)
    assert done.interrupted and done.steps == 0
    kept = open_run(folder).checkpoint
    assert kept.name == "checkpoint-0" and (kept / "replay.npz").is_file()
    assert load_policy(folder / LATEST).card.steps == 0
    for name in ("fill", "clone"):
        monkeypatch.setattr(training, name, None)  # neither is done again
    assert train(recipe, folder, QUICK, True, quiet).steps >= 120


@pytest.mark.slow
def test_cloning_can_be_interrupted_too(small, folder: Path) -> None:
    def say(line: str) -> None:
        if "held-out" in line:
            os.kill(os.getpid(), signal.SIGINT)

    done = train(small("clone", cloning={**CLONING, "rounds": 9}), folder, QUICK, say=say)
    assert done.interrupted and len(open_run(folder).rows()) == 1
    assert load_policy(folder / LATEST).card.steps == done.steps


def test_tensorboard_is_not_needed(small, folder: Path, monkeypatch) -> None:
    monkeypatch.setattr(progress, "tensorboard_there", lambda: False)
    told: list[str] = []
    train(small("ppo", steps=32), folder, TrainingPlan(episodes=1, bar=True), say=told.append)
    assert sum("TensorBoard is not installed" in line for line in told) == 1
    assert not list(folder.glob("tensorboard/*")) and extra.PIP in "".join(told)


def test_training_on_held_out_scenes_is_said(small, folder: Path, table: str) -> None:
    told: list[str] = []
    train(small("ppo", steps=32, held_out=table), folder, TrainingPlan(episodes=1), say=told.append)
    assert any("1 of the held-out scenes are also training scenes" in line for line in told)


@pytest.mark.parametrize("wrong", [{"seed": -1}, {"episodes": 0}, {"evaluate_every": 0}])
def test_plans_out_of_range_are_refused(wrong) -> None:
    with pytest.raises(InputError, match=r"Plan\.|A seed must be"):
        TrainingPlan(**wrong)
