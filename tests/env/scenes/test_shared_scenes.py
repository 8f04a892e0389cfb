"""One source for the slots of a vector environment, with concurrent changes."""

import pickle
import shutil
import threading
from collections.abc import Iterator
from pathlib import Path

import gymnasium as gym
import numpy as np
import pytest
from bounded import until
from toy import toy_scene

from generator.bundle import save
from generator.errors import BundleError
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.scenes import (
    FixedScenes,
    FreshScenes,
    RefreshingScenes,
    SceneRef,
    SharedScenes,
)
from tabletopgen_env.scenes.fixed import bundle_ref, folder
from tabletopgen_env.scenes.lookup import fixed_scenes


class Slow:
    """Records the number of threads that draw at the same time."""

    def __init__(self) -> None:
        self.refs = fixed_scenes(toy_scene()).refs
        self.inside = self.most = 0

    def draw(self, rng: np.random.Generator) -> SceneRef:
        self.inside += 1
        self.most = max(self.most, self.inside)
        threading.Event().wait(0.02)
        self.inside -= 1
        return self.refs[0]


class Losing:
    """Draws its bundles in order; the first is deleted after it is drawn."""

    def __init__(self, *refs: SceneRef) -> None:
        self.refs, self.draws = refs, 0

    def draw(self, rng: np.random.Generator) -> SceneRef:
        ref = self.refs[self.draws % len(self.refs)]
        if not self.draws:
            place = folder(ref)
            assert place is not None
            shutil.rmtree(place)
        self.draws += 1
        return ref


@pytest.fixture
def temporary(tmp_path, monkeypatch) -> Iterator[Path]:
    """The folder for files of pools, which must be empty afterwards."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    yield tmp_path
    assert not list(tmp_path.iterdir()), "something was left behind"


def pool(**settings) -> RefreshingScenes:
    first = [toy_scene(name=f"first_{k}") for k in range(2)]
    fresh = FreshScenes("x", making="makers:toy")
    given = {"size": 2, "every_resets": 1, "initial": first, "seed": 0, **settings}
    return RefreshingScenes(fresh, **given)


def test_the_slots_of_a_vector_environment_draw_one_at_a_time() -> None:
    source = Slow()
    envs = TabletopVectorEnv(4, threads=4, task="Reach", scenes=source)
    envs.reset(seed=0)
    envs.close()
    assert source.most == 1


def test_a_copy_has_a_source_and_a_lock_of_its_own() -> None:
    shared = SharedScenes(fixed_scenes([toy_scene(name="a"), toy_scene(name="b")]))
    other = pickle.loads(pickle.dumps(shared))
    names = [s.draw(np.random.default_rng(1)).load().name for s in (shared, other)]
    assert names[0] == names[1]


def test_a_scene_that_is_gone_once_it_is_drawn_is_passed_over(tmp_path) -> None:
    first, second = (
        bundle_ref(save(toy_scene(name=n), tmp_path, allow_failed=True)) for n in ("a", "b")
    )
    source = Losing(first, second)
    env = make_env(source, task="Reach")
    assert env.reset(seed=0)[1]["scene"] == "b" and source.draws == 2
    env.close()


def test_a_damaged_scene_is_an_error_still(tmp_path) -> None:
    place = save(toy_scene(), tmp_path, allow_failed=True)
    (place / "scene.json").write_text("{}")
    env = make_env(FixedScenes((bundle_ref(place),)), task="Reach")
    with pytest.raises(BundleError):
        env.reset(seed=0)


@pytest.mark.slow
def test_a_pool_that_is_renewed_at_every_draw_serves_all_slots(temporary) -> None:
    source = pool(workers=2)
    envs = TabletopVectorEnv(4, threads=4, task="Reach", scenes=source, cache=1)
    held = []
    try:

        def renewed() -> bool:
            envs.reset()
            held.append([ref.key for ref in source.refs])
            return source.renewals >= 12

        until(renewed)
    finally:
        envs.close()
        assert source.pids, "it was passed in"
        source.close()
    assert all(len(set(keys)) == 2 for keys in held) and source.failures == 0


def test_slots_renew_a_pool_together_in_step_with_their_draws() -> None:
    source = pool(synchronous=True, every_resets=4)
    envs = TabletopVectorEnv(4, threads=1, task="Reach", scenes=source)
    for _ in range(3):
        envs.reset()
    envs.close()
    assert source.renewals == 2, "12 draws, of which the 5th and the 9th were due"


@pytest.mark.slow
def test_a_named_source_is_made_once_for_all_slots_and_closed_with_them(temporary) -> None:
    envs = gym.make_vec(
        "tabletopgen_env:TabletopGen/Reach-v0", num_envs=3, threads=1, scenes="refreshing"
    )
    assert isinstance(envs, TabletopVectorEnv)
    envs.reset(seed=0)
    assert len(list(temporary.glob("tabletopgen-*"))) == 1, "one pool, one process"
    envs.close()
    envs.close()
