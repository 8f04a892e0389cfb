"""Training by a recipe on a batch of worlds."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tables import COMPILING, need_warp

from generator.errors import InputError
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.ppo.batches import BatchConfig, batch_config
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.recipes import Recipe, recipe, recipe_of
from tabletopgen_env.learning.runs import LATEST, open_run
from tabletopgen_env.learning.training import train


def tiny(steps: int = 32, **changes: Any) -> Recipe:
    """Two worlds at two tables, validated at a third."""
    return recipe_of({
        "name": "tiny", "task": "Reach", "algorithm": "ppo-batch", "steps": steps, "envs": 2,
        "scenes": ["vanity", "coffee-square"], "held_out": "lab",
        "env": {"randomization": "starts"},
        "options": {"rollout": 8, "epochs": 1, "minibatches": 2},
        "network": {"layers": [8], "width": 4},
        "batch": {"device": "cpu", "episodes": 2},
        **changes,
    })  # fmt: skip


def quiet(line: str) -> None:
    assert line


@pytest.mark.slow
@pytest.mark.usefixtures("kernels")
@pytest.mark.timeout(COMPILING)
def test_a_recipe_trains_on_a_batch_and_resumes(tmp_path: Path) -> None:
    need_warp()
    plan = TrainingPlan(seed=1, evaluate_every=16, episodes=1)
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    assert train(tiny(), whole, plan, say=quiet).steps == 32
    train(tiny(16), parts, plan, say=quiet)
    halfway = load_policy(parts / LATEST).actor.state_dict()
    train(tiny(), parts, plan, resume=True, say=quiet)
    one, other = (load_policy(path / LATEST).actor.state_dict() for path in (whole, parts))
    assert all(np.array_equal(one[k], other[k]) for k in one), "as an uninterrupted run"
    assert not all(np.array_equal(one[k], halfway[k]) for k in one)
    run = open_run(parts)
    assert [row.steps for row in run.rows()] == [16, 32]
    assert run.recipe.batch == {"device": "cpu", "episodes": 2}


def test_settings_of_a_batch_are_checked() -> None:
    assert batch_config(tiny(batch=None)) is None
    assert batch_config(tiny()) == BatchConfig("cpu", episodes=2)
    for wrong, why in (
        ({"devise": "cpu"}, "tiny: a batch has no setting 'devise'.*Did you mean 'device'"),
        ({"device": "cpu", "episodes": 0}, "tiny: batch: .*episodes"),
        ({"device": "cpu", "max_objects": 0}, "tiny: batch: .*max_objects"),
        ({"device": "tpu"}, "tiny: batch: device must be"),
    ):
        with pytest.raises(InputError, match=why):
            batch_config(tiny(batch=wrong))
    for changes, why in (
        ({"algorithm": "ppo", "options": {}}, "only 'ppo-batch' trains on a batch"),
        ({"processes": 2}, "batch and processes cannot be combined"),
        ({"batch": 3}, "batch must be a table of settings"),
    ):
        with pytest.raises(InputError, match=why):
            tiny(**changes)


def test_settings_are_changed_by_name() -> None:
    found = recipe("lift-ppo-batch", ["batch.device=cpu", "envs=2"])
    config = batch_config(found)
    assert config == BatchConfig("cpu", 256, 16)
    assert batch_config(recipe("reach-ppo", ["batch.device=cpu"])) == BatchConfig("cpu")
