"""Where tables come from, drawing them, and keeping compiled worlds."""

from __future__ import annotations

import sys
import types

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene

import assets_cache
from generator.errors import BundleError, InputError
from generator.scene import Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import FixedScenes, FreshScenes, SceneRef, resolve
from tabletopgen_env.worlds import WorldCache


@pytest.fixture
def store(tmp_path, monkeypatch):
    """A store of three bundles."""
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path))
    for k in range(3):
        scene = toy_scene(toy_objects()[: 4 + k], name=f"desk_{k}")
        assets_cache.add(scene, allow_failed=True)
    return tmp_path


def names(source: FixedScenes) -> list[str]:
    return [ref.load().name for ref in source.refs]


def test_bundles_by_path_name_glob_and_list(store) -> None:
    first = assets_cache.find("desk_0")[0]
    assert names(resolve(first)) == names(resolve(str(first))) == names(resolve("desk_0"))
    assert names(resolve("desk_*")) == ["desk_0", "desk_1", "desk_2"]
    assert names(resolve(str(store / "desk_*"))) == ["desk_0", "desk_1", "desk_2"]
    assert names(resolve(["desk_2", toy_scene(), first])) == ["desk_2", "toy", "desk_0"]


def test_nothing_found_says_what_there_is(store) -> None:
    with pytest.raises(BundleError, match="desk_0"):
        resolve("desk_o")
    with pytest.raises(BundleError, match="No bundle fits"):
        resolve(str(store / "kitchen_*"))


@pytest.mark.parametrize("wrong", [[], 5, [5], ["fresh:a desk"], None])
def test_wrong_kinds_are_explained(wrong) -> None:
    with pytest.raises(InputError, match=r"scene|Scene"):
        resolve(wrong)


def test_drawing_follows_the_seed_alone() -> None:
    source = resolve([toy_scene(name=f"s{k}") for k in range(5)])

    def draws(seed: int) -> list[str]:
        rng = np.random.default_rng(seed)
        return [source.draw(rng).load().name for _ in range(12)]

    assert draws(0) == draws(0) != draws(1)
    assert len(set(draws(0))) > 2


def test_an_environment_plays_bundles(store) -> None:
    env = make_env("desk_*")
    seen = {env.reset(seed=seed)[1]["scene"] for seed in range(12)}
    assert seen == {"desk_0", "desk_1", "desk_2"}
    assert np.isfinite(env.step(env.action_space.sample())[1])


def test_fresh_scenes_are_composed_when_loaded(monkeypatch) -> None:
    asked: list[tuple[str, int]] = []

    def compose(text: str, seed: int) -> Scene:
        asked.append((text, seed))
        return toy_scene(name=f"fresh_{seed}")

    module = types.ModuleType("generator.compose")
    module.compose = compose  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "generator.compose", module)
    source = resolve("fresh: an office desk")
    assert source == FreshScenes(("an office desk",))
    refs = [source.draw(np.random.default_rng(seed)) for seed in (0, 0, 1)]
    assert refs[0].key == refs[1].key != refs[2].key and not asked
    assert make_env(source).reset(seed=3)[1]["scene"].startswith("fresh_")
    assert asked and asked[0][0] == "an office desk"


def test_few_variants_come_again() -> None:
    source, rng = FreshScenes(("a desk", "a kitchen"), variants=2), np.random.default_rng(0)
    assert len({source.draw(rng).key for _ in range(60)}) == 4


def test_an_own_source_is_taken_as_it_is() -> None:
    class Growing:
        """Draws tables with one cube more each time."""

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
