import dataclasses
from pathlib import Path

import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv

from generator.errors import InputError
from tabletopgen_env.learning.policies import load_policy, policy_from, save_policy
from tabletopgen_env.learning.ppo.training import new_ppo, ppo_config
from tabletopgen_env.learning.ppo.worlds import TensorWorlds
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.recipes import Recipe
from tabletopgen_env.learning.runs import LATEST, open_run
from tabletopgen_env.learning.setup import load_zip, single_env, source_of
from tabletopgen_env.learning.training import train

GOAL = {"env": {"observation": "goal"}, "network": {"extractor": "goal", "layers": [8]}}


def quiet(line: str) -> None:
    assert line


def worlds_of(recipe: Recipe) -> TensorWorlds:
    def env():
        return single_env(recipe.task, recipe.env, source_of(recipe.scenes, "train"))

    return TensorWorlds(SyncVectorEnv([env] * 2, autoreset_mode=AutoresetMode.SAME_STEP))


@pytest.mark.slow
@pytest.mark.parametrize("changes", [{}, GOAL])
def test_a_policy_file_acts_as_the_learner_does(small, tmp_path: Path, changes: dict) -> None:
    recipe = small("ppo-batch", **changes)
    worlds = worlds_of(recipe)
    ppo = new_ppo(recipe, worlds.env, 3, worlds)
    seen, rollout = ppo.collect(worlds, worlds.reset([1, 2]))
    ppo.update(rollout)
    path = save_policy(policy_from(ppo, recipe, 3, steps=32), tmp_path / "p.safetensors")
    read = load_policy(path)
    assert read.card.squash == "clip" and read.card.steps == 32 and read.card.seed == 3
    observation = {name: part.numpy() for name, part in seen.items()}
    got = read.predict(observation.get("", observation))[0]
    wanted = ppo.nets.means(seen).clamp(-1, 1).detach().numpy()
    assert np.array_equal(got, wanted) and got.shape == (2, 5) and np.abs(got).max() > 0
    worlds.close()


@pytest.mark.slow
def test_resuming_learns_what_an_uninterrupted_run_does(small, tmp_path: Path) -> None:
    """Also at the same tables: each evaluation is followed by episodes that its steps decide."""
    plan = TrainingPlan(evaluate_every=64, episodes=1)
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    train(small("ppo-batch", steps=160), whole, plan, say=quiet)
    train(small("ppo-batch", steps=64), parts, plan, say=quiet)
    halfway = load_policy(parts / LATEST).actor.state_dict()
    train(small("ppo-batch", steps=160), parts, plan, resume=True, say=quiet)
    one, other = (load_policy(path / LATEST).actor.state_dict() for path in (whole, parts))
    assert all(np.array_equal(one[k], other[k]) for k in one)
    assert not all(np.array_equal(one[k], halfway[k]) for k in one)
    rows = [
        [dataclasses.replace(r, seconds=0) for r in open_run(path).rows()]
        for path in (whole, parts)
    ]
    assert rows[0] == rows[1] and [r.steps for r in rows[0]] == [64, 128, 160]


def test_options_are_those_of_ppo(small) -> None:
    assert ppo_config(small("ppo-batch", options={"rollout": 5, "gamma": 0.5})).gamma == 0.5
    for wrong, why in (
        ({"n_steps": 5}, "ppo-batch has no option 'n_steps'"),
        ({"gama": 0.5}, "Did you mean 'gamma'"),
        ({"clip": "wide"}, "clip must be a number > 0"),
        ({"rollout": 1, "minibatches": 64}, "cannot be split into 64 minibatches"),
    ):
        with pytest.raises(InputError, match=why):
            ppo_config(small("ppo-batch", options=wrong))


def test_it_writes_no_zips(small, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="ppo-batch does not write zip files"):
        load_zip(tmp_path / "model.zip", small("ppo-batch"))


@pytest.mark.slow
def test_a_damaged_checkpoint_is_refused(small, folder: Path) -> None:
    plan = TrainingPlan(episodes=1)
    train(small("ppo-batch", steps=32), folder, plan, say=quiet)
    kept = open_run(folder).checkpoint
    assert kept is not None and {p.name for p in kept.iterdir()} == {"learner.pt", "counts.json"}
    content = (kept / "learner.pt").read_bytes()
    (kept / "learner.pt").write_bytes(content[:900])
    with pytest.raises(InputError, match="not a valid checkpoint of small-ppo-batch"):
        train(small("ppo-batch", steps=64), folder, plan, True, quiet)
