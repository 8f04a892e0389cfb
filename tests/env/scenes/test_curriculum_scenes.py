"""Scenes that become harder as the policy succeeds."""

import pickle

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene

from generator.errors import InputError
from generator.scene import Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.scenes import (
    CurriculumScenes,
    FixedScenes,
    FreshScenes,
    RefreshingScenes,
    SceneRef,
    difficulty,
)


def unread() -> Scene:
    raise AssertionError("a scene was loaded whose difficulty is known")


def graded(count: int = 10) -> FixedScenes:
    """Scenes whose difficulty is known, given in no order: number k has difficulty k / count."""
    order = np.random.default_rng(0).permutation(count)
    return FixedScenes(tuple(SceneRef(str(k), unread, k / count) for k in order))


def seen(source: CurriculumScenes, draws: int = 200) -> list[int]:
    rng = np.random.default_rng(0)
    return sorted({int(source.draw(rng).key) for _ in range(draws)})


def tell(source: CurriculumScenes, results: str) -> None:
    for result in results:
        source.record(result == "+")


@pytest.mark.parametrize(
    ("level", "expected"),
    [(0.0, [0, 1, 2]), (0.5, [3, 4, 5, 6]), (1.0, [7, 8, 9]), (2 / 7, [2, 3, 4])],
)
def test_scenes_are_drawn_from_the_window_and_all_of_it(level, expected) -> None:
    assert seen(CurriculumScenes(graded(), width=0.3, level=level)) == expected


def test_the_window_slides_from_the_easiest_to_the_hardest() -> None:
    source = CurriculumScenes(graded(), width=0.4)
    assert source.window == (0.0, 0.4)
    source.level = 1.0
    assert source.window == pytest.approx((0.6, 1.0))
    assert seen(CurriculumScenes(graded(), width=1.0, level=0.3)) == list(range(10))
    assert seen(CurriculumScenes(graded(1), level=1.0)) == [0]


def test_success_raises_the_level_and_failure_lowers_it() -> None:
    source = CurriculumScenes(graded(), level=0.5, step=0.1, episodes=4)
    tell(source, "+++")
    assert source.level == 0.5  # too few to say
    tell(source, "-")
    assert source.level == pytest.approx(0.6)  # three of four
    tell(source, "+-+")
    assert source.level == pytest.approx(0.6)  # what came before the change does not count
    tell(source, "-")
    assert source.level == pytest.approx(0.6)  # half: neither
    tell(source, "--")
    assert source.level == pytest.approx(0.5)  # of the last four, one
    tell(source, "-" * 100)
    assert source.level == 0.0
    tell(source, "+" * 100)
    assert source.level == 1.0


def test_drawing_follows_the_generator() -> None:
    def drawn(seed: int) -> list[str]:
        source, rng = CurriculumScenes(graded(), width=0.6), np.random.default_rng(seed)
        return [source.draw(rng).key for _ in range(20)]

    assert drawn(0) == drawn(0) != drawn(1)


def test_a_difficulty_that_is_not_known_is_found_once() -> None:
    easy = toy_scene(toy_objects()[:1], name="easy")
    hard = toy_scene(tuple(
        toy_object(f"box_{k}", (0.07, 0.07, 0.02), (0.073 * k - 0.3, 0.25)) for k in range(9)
    ), name="hard")  # fmt: skip
    assert difficulty(easy) < difficulty(hard)
    loads: list[str] = []

    def ref(scene: Scene) -> SceneRef:
        def load() -> Scene:
            loads.append(scene.name)
            return scene

        return SceneRef(scene.name, load)

    source = CurriculumScenes(FixedScenes((ref(hard), ref(easy))), width=0.5)
    rng = np.random.default_rng(0)
    assert {source.draw(rng).key for _ in range(10)} == {"easy"}
    source.level = 1.0
    assert {source.draw(rng).key for _ in range(10)} == {"hard"}
    assert sorted(loads) == ["easy", "hard"]


@pytest.mark.slow
def test_scenes_made_on_demand_are_made_once_and_compared() -> None:
    made: list[int] = []

    class Own:
        """Makes scenes of random difficulty; has none at hand."""

        def draw(self, rng: np.random.Generator) -> SceneRef:
            number = int(rng.integers(1000))

            def load() -> Scene:
                made.append(number)
                cube = toy_object("cube_1", (0.04, 0.04, 0.04), (number / 5000, 0.0))
                return toy_scene((cube,), name=str(number))

            return SceneRef(str(number), load)

    source = CurriculumScenes(Own(), width=0.25)
    rng = np.random.default_rng(0)
    drawn = [source.draw(rng) for _ in range(5)]
    assert len(made) == 20
    assert [ref.load().name for ref in drawn] == [ref.key for ref in drawn]
    assert len(made) == 20


def test_a_pool_is_drawn_from_once_for_each_scene() -> None:
    pool = RefreshingScenes(
        FreshScenes("x", making="makers:toy"), size=4, every_resets=2, synchronous=True, seed=0
    )
    source, rng = CurriculumScenes(pool), np.random.default_rng(0)
    for _ in range(7):
        assert source.draw(rng).key in {ref.key for ref in pool.refs}
    assert pool.renewals == 3
    source.close()
    assert pool.refs == ()


@pytest.mark.slow
def test_a_bundle_that_is_gone_is_not_drawn(tmp_path, monkeypatch) -> None:
    import assets_cache

    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path))
    for k in range(3):
        assets_cache.add(toy_scene(toy_objects()[: k + 1], name=f"desk_{k}"), allow_failed=True)
    source, rng = CurriculumScenes("desk_*", width=1.0), np.random.default_rng(0)
    source.draw(rng)
    assets_cache.remove("desk_1")
    with pytest.warns(RuntimeWarning, match="desk_1"):
        assert {source.draw(rng).load().name for _ in range(30)} == {"desk_0", "desk_2"}


def test_it_can_be_pickled_where_it_is() -> None:
    source = CurriculumScenes(toy_scene(), level=0.3)
    again = pickle.loads(pickle.dumps(source))
    assert again.level == 0.3 and again.draw(np.random.default_rng(0)).load().name == "toy"


@pytest.mark.parametrize(
    "settings",
    [{"width": 0.0}, {"width": 1.1}, {"level": -0.1}, {"step": 0.0}, {"episodes": 0},
     {"lower_at": 0.7}, {"raise_at": 1.2}],
)  # fmt: skip
def test_wrong_settings_are_explained(settings) -> None:
    with pytest.raises(InputError, match="A curriculum needs"):
        CurriculumScenes(graded(), **settings)


# ------------------------------------------------------------------------------ the environment
class Told:
    """A source that keeps what it is told."""

    def __init__(self) -> None:
        self.results: list[bool] = []

    def draw(self, rng: np.random.Generator) -> SceneRef:
        return SceneRef("toy", toy_scene)

    def record(self, success: bool) -> None:
        self.results.append(success)


def finish(env) -> None:
    """Put the target where it is to go, and let it rest."""
    spot, target = env.goal.spot, env.world.scene.object(env.goal.target)
    env.world.teleport(target.name, np.array([*spot[:2], spot[2] + target.scale[2] / 2]))
    for _ in range(8):
        env.step(np.zeros(env.action_space.shape))


def test_the_environment_tells_how_each_episode_ended() -> None:
    source = Told()
    env = make_env(source)
    env.reset(seed=0, options={"goal": (0.0, -0.2), "target": "cube_1"})
    env.reset()
    assert source.results == []  # nothing was done
    env.step(env.action_space.sample())
    env.reset(options={"goal": (0.0, -0.2), "target": "cube_1"})
    assert source.results == [False]
    finish(env)
    env.reset()
    assert source.results == [False, True]
    env.reset(options={"scene": toy_scene()})
    env.step(env.action_space.sample())
    env.reset()
    assert source.results == [False, True]  # that scene was not the source's


def test_a_curriculum_follows_an_environment() -> None:
    source = CurriculumScenes([toy_scene()], level=0.5, episodes=2)
    env = make_env(source)
    for seed in range(3):
        env.reset(seed=seed)
        env.step(env.action_space.sample())
    assert source.level == pytest.approx(0.45)
