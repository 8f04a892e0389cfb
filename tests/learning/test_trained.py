"""The shipped policies: safe to read, small, and successful at their task."""

import pytest

from tabletopgen_env.learning.commands import enjoy
from tabletopgen_env.learning.evaluation import play, seeds
from tabletopgen_env.learning.policies import load_policy, shipped_policies
from tabletopgen_env.learning.setup import single_env, source_of

SHIPPED = shipped_policies()


def test_there_are_some_and_they_are_small() -> None:
    named = {"reach-clone", "reach-sight", "lift-clone", "lift-sight", "pickplace-clone"}
    assert named <= set(SHIPPED)
    assert all(path.stat().st_size < 2_000_000 for path in SHIPPED.values())


def test_the_help_of_enjoy_names_every_shipped_policy() -> None:
    words = {word.strip("(),.") for word in (enjoy.__doc__ or "").split()}
    assert {*SHIPPED} <= words


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(SHIPPED))
def test_a_shipped_policy_does_its_task_at_tables_it_never_saw(name: str) -> None:
    policy = load_policy(SHIPPED[name])
    assert "starter" not in str(policy.card.scenes)
    env = single_env(policy.card.task, policy.card.env, source_of("starter", "held_out"))
    solved = 0
    for seed in seeds(0, 8):
        solved += play(env, policy, seed).solved
        if solved == 5:  # the other episodes cannot change the answer
            break
    env.close()
    assert solved >= 5
