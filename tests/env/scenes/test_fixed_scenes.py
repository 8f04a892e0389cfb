"""Existing scenes: search, draws, removed bundles, and the cache of compiled worlds."""

import pickle
import shutil
import warnings

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene
from worlds import names

import assets_cache
from generator.errors import BundleError
from generator.scene import Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import SceneRef, SceneSource, resolve
from tabletopgen_env.scenes.lookup import fixed_scenes
from tabletopgen_env.world.worlds import WorldCache


@pytest.fixture
def store(tmp_path, monkeypatch):
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path))
    for k in range(3):
        scene = toy_scene(toy_objects()[: 4 + k], name=f"desk_{k}")
        assets_cache.add(scene, allow_failed=True)
    return tmp_path


def test_bundles_by_path_name_glob_and_list(store) -> None:
    first = assets_cache.find("desk_0")[0]
    assert names(resolve(first)) == names(resolve(str(first))) == names(resolve("desk_0"))
    assert names(resolve("desk_*")) == ["desk_0", "desk_1", "desk_2"]
    assert names(resolve(str(store / "desk_*"))) == ["desk_0", "desk_1", "desk_2"]
    assert names(resolve(["desk_2", toy_scene(), first])) == ["desk_2", "toy", "desk_0"]


def test_nothing_found_says_what_there_is(store) -> None:
    with pytest.raises(BundleError, match="desk_0"):
        resolve("desk_o")
    with pytest.raises(BundleError, match="No bundle matches"):
        resolve(str(store / "kitchen_*"))


def test_drawing_follows_the_seed_alone() -> None:
    source = resolve([toy_scene(name=f"s{k}") for k in range(5)])

    def draws(seed: int) -> list[str]:
        rng = np.random.default_rng(seed)
        return [source.draw(rng).load().name for _ in range(12)]

    assert draws(0) == draws(0) != draws(1)
    assert len(set(draws(0))) > 2


@pytest.mark.slow
def test_an_environment_plays_bundles(store) -> None:
    env = make_env("desk_*")
    seen = {env.reset(seed=seed)[1]["scene"] for seed in range(12)}
    assert seen == {"desk_0", "desk_1", "desk_2"}
    assert np.isfinite(env.step(env.action_space.sample())[1])


def test_an_own_source_is_taken_as_it_is() -> None:
    class Growing:
        """Draws tables with an additional cube each time."""

        count = 0

        def draw(self, rng: np.random.Generator) -> SceneRef:
            self.count += 1
            cubes = tuple(
                toy_object(f"cube_{k}", (0.04, 0.04, 0.04), (0.1 * k - 0.3, 0.0))
                for k in range(self.count)
            )
            return SceneRef(f"grown:{self.count}", lambda: toy_scene(cubes))

    env = make_env(Growing())
    counts = []
    for seed in range(3):
        env.reset(seed=seed)
        counts.append(len(env.world.names))
    assert counts == [1, 2, 3]


def test_worlds_are_reused_and_the_oldest_dropped() -> None:
    loaded: list[str] = []
    dropped: list[str] = []

    def ref(name: str) -> SceneRef:
        def load() -> Scene:
            loaded.append(name)
            return toy_scene(toy_objects()[:1], name=name)

        return SceneRef(name, load)

    cache = WorldCache(Panda(), size=2)
    for name in ("a", "b", "a", "c", "a", "b"):
        cache.get(ref(name), lambda world: dropped.append(world.scene.name))
    assert loaded == ["a", "b", "c", "b"]
    assert dropped == ["b", "c"]


def test_a_reset_writes_the_start_state_whatever_happened_before() -> None:
    env = make_env(toy_scene())
    env.reset(seed=0)
    start = env.world.data.qpos.copy()
    for _ in range(20):
        env.step(env.action_space.sample())
    env.reset(seed=0)
    assert np.array_equal(env.world.data.qpos, start)
    assert not env.world.data.qvel.any()


# ------------------------------------------------------------------------------- what is gone
def draws(source: SceneSource, count: int = 12) -> list[str]:
    rng = np.random.default_rng(0)
    return [source.draw(rng).load().name for _ in range(count)]


@pytest.mark.slow
def test_a_vanished_bundle_is_passed_over_with_one_warning(store) -> None:
    source = resolve("desk_*")
    gone = assets_cache.find("desk_1")[0]
    kept = gone.rename(store / ".elsewhere")
    with pytest.warns(
        RuntimeWarning, match="desk_1-.* no longer exists.*remaining 2 of 3 scenes"
    ) as said:
        assert set(draws(source, 30)) == {"desk_0", "desk_2"}
    assert len(said) == 1
    kept.rename(gone)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert set(draws(source, 30)) == {"desk_0", "desk_1", "desk_2"}


def test_drawing_is_the_same_as_before_while_nothing_is_gone(store) -> None:
    source, rng = fixed_scenes("desk_*"), np.random.default_rng(3)
    expected = [source.refs[int(rng.integers(3))].key for _ in range(9)]
    rng = np.random.default_rng(3)
    assert [source.draw(rng).key for _ in range(9)] == expected


@pytest.mark.slow
def test_an_emptied_store_is_an_error_that_names_a_bundle(store) -> None:
    one, three = make_env("desk_0"), make_env("desk_*")
    assert one.reset(seed=0)[1]["scene"] == "desk_0"
    three.reset(seed=0)
    assert assets_cache.clear() == 3
    with pytest.raises(BundleError, match=r"desk_0-[0-9a-f]{12} no longer exists.*Restore it"):
        one.reset()
    with pytest.raises(BundleError, match=r"desk_.* no longer exists.*nor do the other 2"):
        three.reset()
    assets_cache.add(toy_scene(toy_objects()[:4], name="desk_0"), allow_failed=True)
    assert one.reset()[1]["scene"] == "desk_0"


@pytest.mark.slow
def test_an_environment_goes_on_with_what_is_left(store) -> None:
    env = make_env("desk_*")
    env.reset(seed=0)
    shutil.rmtree(assets_cache.find("desk_2")[0])
    with pytest.warns(RuntimeWarning, match="desk_2"):
        seen = {env.reset(seed=seed)[1]["scene"] for seed in range(8)}
    assert seen == {"desk_0", "desk_1"}


def test_a_damaged_bundle_is_an_error_though_others_are_left(store) -> None:
    source = resolve("desk_*")
    for path in assets_cache.find("desk_1"):
        (path / "scene.xml").write_text("<mujoco/>")
    with pytest.raises(BundleError, match=r"desk_1-.*was changed"):
        draws(source, 30)


# -------------------------------------------------------------------------------- other processes
def test_sources_can_be_pickled_and_refer_to_the_same_bundles(store, monkeypatch) -> None:
    monkeypatch.chdir(store.parent)
    source = fixed_scenes(["desk_0", toy_scene(name="held"), f"{store.name}/desk_2*"])
    again = pickle.loads(pickle.dumps(source))
    monkeypatch.chdir("/")
    assert names(again) == names(source) == ["desk_0", "held", "desk_2"]
    keys = [[ref.key for ref in s.refs] for s in (source, again)]
    assert keys[0][::2] == keys[1][::2]
    assert keys[0][1] != keys[1][1]  # a copy in memory is another scene, as long as both live


@pytest.mark.slow
def test_an_environment_can_be_pickled(store) -> None:
    env = pickle.loads(pickle.dumps(make_env("desk_*")))
    assert env.reset(seed=0)[1]["scene"] == make_env("desk_*").reset(seed=0)[1]["scene"]
