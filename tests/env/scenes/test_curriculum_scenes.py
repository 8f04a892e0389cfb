"""Scenes at the difficulty from which the policy learns most."""

import pickle

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene

from generator.errors import InputError
from generator.scene import Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.scenes import (
    CurriculumScenes,
    DifficultySampler,
    FixedScenes,
    FreshScenes,
    RefreshingScenes,
    SceneRef,
    SharedScenes,
    difficulty,
    resolve,
)


def unread() -> Scene:
    raise AssertionError("a scene was loaded whose difficulty is known")


EDGES = (0.0, 0.25, 0.5, 0.75, 1.0)


def graded(count: int = 8) -> FixedScenes:
    """Scenes of known difficulty in no order: number k has difficulty k / count."""
    order = np.random.default_rng(0).permutation(count)
    return FixedScenes(tuple(SceneRef(str(k), unread, k / count) for k in order))


def quarters(source: CurriculumScenes, draws: int = 2000) -> list[float]:
    """Return how often each bin is drawn, once every scene has been drawn."""
    rng = np.random.default_rng(0)
    drawn = [source.draw(rng).difficulty for _ in range(200 + draws)][200:]
    return (np.bincount(source.sampler.bins(drawn), minlength=4) / draws).tolist()


def of_quarters(explore: float = 0.2, **more) -> CurriculumScenes:
    return CurriculumScenes(graded(), DifficultySampler(EDGES, explore=explore), **more)


# --------------------------------------------------------------------------------- the sampler
def test_what_half_succeeds_at_is_drawn_most_and_nothing_never() -> None:
    sampler = DifficultySampler(EDGES, explore=0.2)
    assert sampler.probabilities() == pytest.approx([0.25] * 4)  # nothing is known
    for _ in range(100):
        sampler.record([0, 1, 3], [True, _ % 2 == 0, False])
    chances = sampler.probabilities()
    assert chances.sum() == pytest.approx(1.0)
    assert chances[1] > 4 * chances[0] and chances[1] > 4 * chances[3]
    assert chances.min() >= 0.05  # a fifth is uniform
    assert chances[2] == pytest.approx(chances[1], rel=0.05)  # not met yet: may be worth it


def test_only_what_is_present_is_drawn() -> None:
    sampler = DifficultySampler(EDGES)
    held = np.array([3, 0, 0, 1])
    assert sampler.probabilities(held) == pytest.approx([0.75, 0, 0, 0.25])
    sampler.record([0, 3] * 50, [True, True, True, False] * 25)
    chances = sampler.probabilities(held)
    assert chances[3] > 0.6 and chances[0] >= 0.2 * 0.75, "a fifth is as there is"
    assert set(sampler.sample(np.random.default_rng(0), 200, held).tolist()) == {0, 3}
    assert set(sampler.sample(np.random.default_rng(0), 200).tolist()) == {0, 1, 2, 3}


def test_episodes_are_forgotten_by_halves() -> None:
    sampler = DifficultySampler(EDGES, halflife=10.0)
    sampler.record(2, True)
    sampler.record([2] * 10, [False] * 10)
    assert sampler.counts[2, 1] == pytest.approx(0.5)
    assert sampler.counts[[0, 1, 3]].sum() == 0.0  # others keep what they know


@pytest.mark.parametrize("halflife", [1e17, float("inf")])
def test_what_is_never_forgotten_counts_whole(halflife: float) -> None:
    sampler = DifficultySampler((0.0, 0.5, 1.0), halflife=halflife)
    for _ in range(3):
        sampler.record([0, 0, 1], [True, False, False])
    assert sampler.counts == pytest.approx(np.array([[6, 3], [3, 0]]))
    assert np.isfinite(sampler.probabilities()).all()


def test_many_episodes_at_once_count_as_one_after_the_other() -> None:
    together, apart = DifficultySampler(EDGES), DifficultySampler(EDGES)
    together.record([1] * 6 + [3], [True] * 6 + [False])
    for _ in range(6):
        apart.record(1, True)
    apart.record(3, False)
    assert together.counts == pytest.approx(apart.counts)
    mixed = DifficultySampler(EDGES)
    mixed.record([3, 1, 1], [False, True, False])
    other = DifficultySampler(EDGES)
    other.record([1, 3, 1], [False, False, True])
    assert mixed.counts == pytest.approx(other.counts)  # their order is no matter


def test_what_lies_outside_the_edges_is_in_the_outer_bins() -> None:
    sampler = DifficultySampler((0.2, 0.4, 0.6))
    assert sampler.bins([0.0, 0.2, 0.399, 0.4, 0.9]).tolist() == [0, 0, 0, 1, 1]


@pytest.mark.parametrize(
    "settings",
    [{"edges": (0.5,)}, {"edges": (0.5, 0.2)}, {"explore": 0.0}, {"explore": 1.1},
     {"halflife": 0.0}],
)  # fmt: skip
def test_wrong_settings_of_a_sampler_are_explained(settings) -> None:
    with pytest.raises(InputError, match="A curriculum must have"):
        DifficultySampler(**settings)


# ---------------------------------------------------------------------------------- the scenes
def test_scenes_follow_how_episodes_at_their_difficulty_end() -> None:
    source = of_quarters()
    assert quarters(source) == pytest.approx([0.25] * 4, abs=0.05)
    ends = {0: (True, True), 1: (True, False), 2: (False, False), 3: (False, False)}
    refs = [source.draw(np.random.default_rng(k)) for k in range(200)]
    for ref in refs:
        for success in ends[int(source.sampler.bins(ref.difficulty))]:
            source.record(ref, success)
    shares = quarters(source)
    assert shares[1] > 0.5 and min(shares) > 0.03


def test_an_episode_counts_where_it_was_played_though_another_has_begun_since() -> None:
    source = SharedScenes(of_quarters())
    rng = np.random.default_rng(1)
    refs = {float(ref.difficulty or 0): ref for ref in (source.draw(rng) for _ in range(100))}
    hard, easy = refs[max(refs)], refs[min(refs)]
    source.record(hard, False)
    source.record(easy, True)
    counts = source._source.sampler.counts  # type: ignore[attr-defined]
    assert counts[[0, 3]].tolist() == [[1.0, 1.0], [1.0, 0.0]]


def test_drawing_follows_the_generator() -> None:
    def drawn(seed: int) -> list[str]:
        source, rng = of_quarters(), np.random.default_rng(seed)
        return [source.draw(rng).key for _ in range(20)]

    assert drawn(0) == drawn(0) != drawn(1)


def test_so_many_scenes_are_held_those_met_last() -> None:
    source, rng = of_quarters(size=3), np.random.default_rng(0)
    for _ in range(50):
        source.draw(rng)
    assert len({ref.key for ref in source._held}) == len(source._held) == 3
    assert len(of_quarters(size=1).draw(rng).key) == 1


def test_new_scenes_are_preferred() -> None:
    class Endless:
        number = 0

        def draw(self, rng: np.random.Generator) -> SceneRef:
            self.number += 1
            return SceneRef(str(self.number), unread, float(rng.random()))

    source, rng = CurriculumScenes(Endless(), DifficultySampler(EDGES)), np.random.default_rng(0)
    drawn = [source.draw(rng).key for _ in range(200)]
    assert len({*drawn[:10]}) >= 7 and len({*drawn}) > 150
    assert len(source._drawn) <= source.size


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

    source = CurriculumScenes(FixedScenes((ref(hard), ref(easy))))
    rng = np.random.default_rng(0)
    found = {ref.key: ref.difficulty for ref in (source.draw(rng) for _ in range(20))}
    assert found == {"easy": difficulty(easy), "hard": difficulty(hard)}
    assert sorted(loads) == ["easy", "hard"]


def test_a_draw_makes_one_scene_at_most_and_each_once() -> None:
    made: list[int] = []

    class Own:
        """Makes scenes of random difficulty, without stored ones."""

        def draw(self, rng: np.random.Generator) -> SceneRef:
            number = int(rng.integers(1000))

            def load() -> Scene:
                made.append(number)
                cube = toy_object("cube_1", (0.04, 0.04, 0.04), (number / 5000, 0.0))
                return toy_scene((cube,), name=str(number))

            return SceneRef(str(number), load)

    source, rng = CurriculumScenes(Own()), np.random.default_rng(0)
    drawn = []
    for k in range(5):
        drawn.append(source.draw(rng))
        assert len(made) == k + 1
    assert [ref.load().name for ref in drawn] == [ref.key for ref in drawn]
    assert len(made) == 5


def test_a_pool_is_drawn_from_once_for_each_scene() -> None:
    pool = RefreshingScenes(
        FreshScenes("x", making="makers:toy"), size=4, every_resets=2, synchronous=True, seed=0
    )
    source, rng = CurriculumScenes(pool), np.random.default_rng(0)
    for _ in range(7):
        source.draw(rng)
    assert pool.renewals == 3
    source.close()
    assert pool.refs == ()


@pytest.mark.slow
def test_a_bundle_that_is_gone_is_not_drawn(tmp_path, monkeypatch) -> None:
    import assets_cache

    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path))
    for k in range(3):
        assets_cache.add(toy_scene(toy_objects()[: k + 1], name=f"desk_{k}"), allow_failed=True)
    source, rng = CurriculumScenes("desk_*"), np.random.default_rng(0)
    for _ in range(30):
        source.draw(rng)
    assets_cache.remove("desk_1")
    with pytest.warns(RuntimeWarning, match="desk_1"):
        assert {source.draw(rng).load().name for _ in range(30)} == {"desk_0", "desk_2"}


def test_a_copy_draws_and_learns_alike() -> None:
    source = CurriculumScenes([toy_scene(), toy_scene(toy_objects()[:1], name="one")])
    rng = np.random.default_rng(0)
    for _ in range(4):
        source.record(source.draw(rng), True)
    again = pickle.loads(pickle.dumps(source))
    assert again.sampler.counts.tolist() == source.sampler.counts.tolist() != 0
    assert again.draw(np.random.default_rng(5)).load().name in {"toy", "one"}
    made = CurriculumScenes(FreshScenes("x", making="makers:toy"))
    made.draw(rng)
    copies = made, pickle.loads(pickle.dumps(made))
    names = [
        [each.draw(r).load().name for _ in range(5)]
        for each, r in zip(
            copies, (np.random.default_rng(1), np.random.default_rng(1)), strict=True
        )
    ]
    assert names[0] == names[1]


def test_wrong_settings_are_explained() -> None:
    with pytest.raises(InputError, match="size"):
        CurriculumScenes(graded(), size=0)
    with pytest.raises(InputError, match="scenes='curriculum:fresh:a desk'"):
        CurriculumScenes("fresh:a desk")


def test_scenes_can_be_a_curriculum_of_any_others() -> None:
    assert resolve("curriculum").source == FreshScenes()  # type: ignore[attr-defined]
    prompted = resolve("curriculum: fresh:a desk")
    assert isinstance(prompted, CurriculumScenes) and prompted.source == FreshScenes("a desk")
    starters = resolve("curriculum:starter:train")
    assert isinstance(starters, CurriculumScenes) and isinstance(starters.source, FixedScenes)
    assert make_env("curriculum", task="Tidy").source.source.prompts.needs  # type: ignore
    for wrong in ("curriculum:", "curriculum: ", "curriculum:curriculum:fresh"):
        with pytest.raises(InputError, match="does not specify the curriculum's scenes"):
            resolve(wrong)
    with pytest.raises(InputError, match="not a fixed scene"):
        resolve(["curriculum:starter"])


# ------------------------------------------------------------------------------ the environment
class Told:
    """A source that records the reported outcomes."""

    def __init__(self) -> None:
        self.results: list[bool] = []

    def draw(self, rng: np.random.Generator) -> SceneRef:
        return SceneRef("toy", toy_scene)

    def record(self, ref: SceneRef, success: bool) -> None:
        assert ref.key == "toy"
        self.results.append(success)


def finish(env) -> None:
    """Put the target into the goal region, at rest."""
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
    source = CurriculumScenes([toy_scene()])
    env = make_env(source)
    for seed in range(3):
        env.reset(seed=seed)
        env.step(env.action_space.sample())
    assert source.sampler.counts.sum(0) == pytest.approx([1 + 0.5 ** (1 / 30), 0.0])


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_every_slot_of_a_vector_environment_is_heard(mode: str) -> None:
    sampler = DifficultySampler(halflife=float("inf"))
    source = CurriculumScenes([toy_scene(), toy_scene(toy_objects()[:1], name="one")], sampler)
    envs = TabletopVectorEnv(
        3, scenes=source, task="Reach", max_episode_steps=2, autoreset_mode=mode
    )
    envs.reset(seed=0)
    for _ in range(6 if mode == "NextStep" else 4):
        envs.step(envs.action_space.sample())
    assert source.sampler.counts[:, 0].sum() == 6  # two of each slot have ended
    envs.step(envs.action_space.sample())
    envs.reset()
    assert source.sampler.counts[:, 0].sum() == 6, "those that were given up do not count"
    envs.close()
