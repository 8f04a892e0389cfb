"""By default, environments draw certified instances."""

import pickle
import shutil
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from assets_cache import find
from generator.bundle import load
from generator.errors import BundleError, InputError, SceneError
from tabletopgen_env.certificates import certificate
from tabletopgen_env.certificates import certify as certify_module
from tabletopgen_env.certificates.certificate import (
    FILE,
    Certificate,
    TaskInstance,
    Terms,
    scene_digest,
)
from tabletopgen_env.certificates.certify import find_instances, instance_of
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.randomization import Randomization
from tabletopgen_env.tasks.lift import Lift
from tabletopgen_env.tasks.names import NAMES, TaskName
from tabletopgen_env.tasks.push import Push
from tabletopgen_env.tasks.sequence import PRESETS, Sequence
from tabletopgen_env.tasks.task import Episode
from tabletopgen_env.world.world import World

Certify = Callable[..., Path]


@pytest.fixture
def bundle(tmp_path: Path) -> Path:
    [starter] = find("office-desk-*")
    return shutil.copytree(starter, tmp_path / starter.name)


@pytest.fixture
def kitchen(tmp_path: Path) -> Path:
    [path] = find("kitchen-task-1")
    return shutil.copytree(path, tmp_path / path.name)


@pytest.fixture
def certify(bundle: Path) -> Certify:
    """Return a function that writes instances into the bundle's certificate."""

    def write(
        *instances: TaskInstance, tasks: Iterable[str] = (), into: Path = bundle, **terms: int
    ) -> None:
        made = Terms((*tasks, *(i.task for i in instances)), **terms)
        certificate.write_certificate(into, Certificate(scene_digest(into), made, {}, instances))

    return write


def solved(task: str, target: str | None, goal: str | None = None, *rest: Any) -> TaskInstance:
    """Return an instance that was solved from all of enough starts."""
    return TaskInstance(task, target, goal, 30, 30, *rest)


def seen(env: Any, key: str, count: int = 8) -> set[Any]:
    """Return the values of an info entry over several resets."""
    return {env.reset(seed=k)[1][key] for k in range(count)}


def world_of(bundle: Path) -> World:
    env = make_env(bundle, task="Lift", certified=False)
    env.reset(seed=0)
    return env.world


@pytest.fixture(scope="module")
def names() -> list[str]:
    """Return the liftable objects."""
    return sorted(seen(make_env("office-desk-*", task="Lift", certified=False), "target", 20))


@pytest.mark.slow
def test_only_certified_instances_are_drawn(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    first, second, *_ = names
    certify(
        TaskInstance("Lift", first, None, 29, 30), solved("Lift", second), solved("Push", first)
    )
    env = make_env(bundle, task="Lift")
    assert seen(env, "target") == {second} and seen(env, "certified") == {True}
    still = np.zeros(5, np.float32)
    assert env.step(still)[4]["certified"] is True
    free = make_env(bundle, task="Lift", certified=False)
    assert len(seen(free, "target")) > 1 and seen(free, "certified") == {False}


@pytest.mark.slow
def test_all_certified_instances_are_drawn_by_the_seed(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    certify(*(solved("Lift", name) for name in names[:3]))
    one, other = make_env(bundle, task="Lift"), make_env(bundle, task="Lift")
    assert seen(one, "target", 20) == set(names[:3])
    for k in range(5):
        assert one.reset(seed=k)[1]["target"] == other.reset(seed=k)[1]["target"]


@pytest.mark.slow
def test_spots_are_drawn_anew(bundle: Path, certify: Certify) -> None:
    pushed = find_instances(world_of(bundle), Push(), 0, 1)[0]
    certify(solved("Reach", None), replace(pushed, successes=30, episodes=30))
    for task in ("Reach", "Push"):
        env = make_env(bundle, task=task)
        spots = set()
        for seed in range(4):
            assert env.reset(seed=seed)[1]["certified"] is True
            spots.add(tuple(env.goal.spot))
        assert len(spots) == 4


@pytest.mark.slow
@pytest.mark.parametrize("task", [name for name in NAMES if name != "Tidy"])  # has no tray
def test_what_certify_lists_of_a_task_is_drawn(task: str, bundle: Path, certify: Certify) -> None:
    free = make_env(bundle, task=task, certified=False)
    free.reset(seed=4)
    listed = replace(instance_of(free.task, free.episode), successes=30, episodes=30)
    certify(listed)
    env = make_env(bundle, task=task)
    assert env.reset(seed=0)[1]["certified"]
    again = instance_of(env.task, env.episode)
    assert (again.target, again.goal) == (listed.target, listed.goal)


def test_what_options_ask_for_wins(bundle: Path, certify: Certify, names: list[str]) -> None:
    first, second, *_ = names
    certify(solved("Lift", second))
    info = make_env(bundle, task="Lift").reset(seed=0, options={"target": first})[1]
    assert info["target"] == first and info["certified"] is False
    info = make_env("kitchen-cutting-*", task="Lift").reset(seed=0, options={"scene": bundle})[1]
    assert info["target"] == second and info["certified"] is True


@pytest.mark.slow
def test_without_a_word_on_the_task_it_is_sampled_freely(bundle: Path, certify: Certify) -> None:
    certify(TaskInstance("Push", "mug_1", "spot", 10, 10))
    assert seen(make_env(bundle, task="Lift"), "certified", 2) == {False}
    (bundle / FILE).unlink()
    assert seen(make_env(bundle, task="Lift"), "certified", 1) == {False}
    assert seen(make_env(load(bundle), task="Lift"), "certified", 1) == {False}


@pytest.mark.slow
def test_a_scene_without_a_solved_instance_is_passed_over(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    certify(TaskInstance("Lift", names[0], None, 1, 10))
    env = make_env([bundle, "kitchen-cutting-*"], task="Lift")
    assert seen(env, "scene") == {"kitchen-cutting"}


@pytest.mark.parametrize(
    ("instances", "terms", "told"),
    [
        ([TaskInstance("Lift", "", None, 1, 10)], {},
         r"no certified task: of 1 instances of Lift, .*=False"),
        ([TaskInstance("Lift", "", None, 20, 20)], {"episodes": 20},
         r"made with 20 episodes .* fewer than 30 certify nothing"),
        ([TaskInstance("Push", "mug_1", "spot", 10, 10)], {"tasks": ["Lift"]},
         r"the certificate has no instance of Lift\. .*=False"),
    ],
    ids=["never solved", "too few episodes", "nothing listed"],
)  # fmt: skip
def test_where_nothing_is_certified_the_reason_is_told(
    instances, terms, told, bundle: Path, certify: Certify, names: list[str]
) -> None:
    certify(*(replace(i, target=i.target or names[0]) for i in instances), **terms)
    with pytest.raises(SceneError, match=told):
        make_env(bundle, task="Lift").reset(seed=0)


@pytest.mark.slow
def test_where_there_is_nothing_to_certify_the_reasons_are_told(
    bundle: Path, certify: Certify
) -> None:
    certify(tasks=["Tidy"])
    with pytest.raises(SceneError) as free:
        make_env(bundle, task="Tidy", certified=False).reset(seed=0)
    with pytest.raises(SceneError) as certified:
        make_env(bundle, task="Tidy").reset(seed=0)
    assert str(certified.value) == str(free.value)


@pytest.mark.slow
def test_the_reasons_of_a_scene_passed_over_take_nothing_from_the_seed(
    bundle: Path, certify: Certify
) -> None:
    """The next episode must not depend on draws for an error message."""

    class Thorough(Lift):
        @property
        def listed_as(self) -> TaskName:
            return TaskName("Lift")

        def sample(self, world: World, rng: np.random.Generator, *given: Any) -> Episode:
            if world.bundle == bundle:
                rng.random(1000)
                raise SceneError("nothing")
            return super().sample(world, rng, *given)

    certify(tasks=["Lift"])
    thorough, plain = (
        make_env([bundle, "kitchen-cutting-*"], task=task) for task in (Thorough(), "Lift")
    )
    for seed in range(6):  # one of them draws the bundle first
        assert thorough.reset(seed=seed)[1]["scene"] == plain.reset(seed=seed)[1]["scene"]
        states = [env.np_random.bit_generator.state for env in (thorough, plain)]
        assert states[0] == states[1]


@pytest.mark.slow
def test_presets_are_certified_by_themselves(kitchen: Path, certify: Callable[..., Path]) -> None:
    wanted = solved("Sequence", None, None, "kitchen")
    certify(wanted, into=kitchen)
    env = make_env(kitchen, task="Sequence", preset="kitchen")
    info = env.reset(seed=0)[1]
    assert info["certified"] is True and info["instruction"] == PRESETS["kitchen"].instruction
    with pytest.raises(SceneError, match="has no instance of Sequence"):
        make_env(kitchen, task="Sequence").reset(seed=0)
    certify(solved("Sequence", None), replace(wanted, successes=3), into=kitchen)
    assert make_env(kitchen, task="Sequence").reset(seed=0)[1]["certified"] is True
    with pytest.raises(SceneError, match=r"of 1 instances of Sequence .*'kitchen'"):
        make_env(kitchen, task="Sequence", preset="kitchen").reset(seed=0)


@pytest.mark.slow
def test_certifying_sequence_tries_the_presets_that_fit(
    kitchen: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def solved(env: Any, instance: TaskInstance, rng: np.random.Generator) -> bool:
        asked.append(env.task.instruction(*_begun(env)))
        return True

    monkeypatch.setattr(certify_module, "has_solved", solved)
    made = certify_module.certify(kitchen, Terms(("Sequence",), episodes=2))
    drawn = TaskInstance("Sequence", None, None, 2, 2)
    assert made.instances == (drawn, replace(drawn, preset="kitchen"))
    assert asked[2:] == [PRESETS["kitchen"].instruction] * 2 and asked[0] != asked[2]


def _begun(env: Any) -> tuple[Any, Any]:
    env.reset(seed=0)
    return env.world, env.episode.goals


def test_certificates_tell_presets_apart_and_say_nothing_of_tasks_of_ones_own() -> None:
    class Mine(Lift):
        """A custom task."""

    assert Sequence().listed_as == ("Sequence", None)
    assert Sequence("kitchen").listed_as == ("Sequence", "kitchen")
    assert Lift().listed_as == ("Lift", None) and Mine().listed_as is None


@pytest.mark.slow
def test_where_things_are_moved_nothing_is_certified(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    certify(solved("Lift", names[0]))
    moved = make_env(bundle, task="Lift", randomization=Randomization(move=0.01))
    assert moved.reset(seed=0)[1]["certified"] is False
    heavier = make_env(bundle, task="Lift", randomization=Randomization(mass=(0.9, 1.1)))
    assert heavier.reset(seed=0)[1]["certified"] is True


@pytest.mark.slow
@pytest.mark.parametrize("listed", [solved("Lift", "unicorn_1"), solved("Lift", None, "spot")])
def test_a_damaged_certificate_is_refused_unless_it_is_ignored(
    listed: TaskInstance, bundle: Path, certify: Certify
) -> None:
    certify(listed)
    with pytest.raises(BundleError, match=f"{FILE} lists an impossible instance"):
        make_env(bundle, task="Lift").reset(seed=0)
    (bundle / FILE).write_text("{")
    with pytest.raises(BundleError, match="not a valid certificate"):
        make_env(bundle, task="Lift").reset(seed=0)
    make_env(bundle, task="Lift", certified=False).reset(seed=0)


def test_it_is_read_once(
    bundle: Path, certify: Certify, names: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    certify(solved("Lift", names[0]))
    env = make_env(bundle, task="Lift")
    env.reset(seed=0)
    shutil.move(bundle / FILE, bundle.parent / FILE)
    assert env.reset(seed=1)[1]["certified"] is True


@pytest.mark.slow
def test_every_kind_of_environment_heeds_it(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    _, second, *_ = names
    certify(solved("Lift", second))
    goals = make_env(bundle, task="Lift", observation="goal")
    assert seen(goals, "target", 3) == {second}
    again = pickle.loads(pickle.dumps(goals))
    assert seen(again, "target", 3) == {second} and seen(again, "certified", 1) == {True}
    many = TabletopVectorEnv(3, scenes=bundle, task="Lift")
    info = many.reset(seed=0)[1]
    assert set(info["target"]) == {second} and info["certified"].all()
    many.close()


@pytest.mark.slow
def test_certifying_again_looks_at_everything(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    before = find_instances(world_of(bundle), Lift(), 0, 4)
    certify(solved("Lift", names[0]))
    assert find_instances(world_of(bundle), Lift(), 0, 4) == before and len(before) > 1


class Counted(Lift):
    """Lift that counts its samples, at first without a valid target."""

    def __init__(self, idle: int) -> None:
        self.idle, self.asked = idle, 0

    @property
    def listed_as(self) -> TaskName:
        return TaskName("Lift")

    def sample(self, *args: Any, **more: Any) -> Episode:
        self.asked += 1
        if self.asked <= self.idle:
            raise SceneError("nothing")
        return super().sample(*args, **more)


@pytest.mark.slow
def test_no_more_is_drawn_than_is_looked_for(bundle: Path) -> None:
    world = world_of(bundle)
    one, late, never = Counted(0), Counted(3), Counted(1000)
    assert len(find_instances(world, one, 0, 1)) == 1 and one.asked == 1
    assert len(find_instances(world, late, 0, 1)) == 1 and late.asked == 4
    assert find_instances(world, never, 0, 1) == () and never.asked < 10


@pytest.mark.slow
def test_options_that_are_wrong_are_still_the_callers(
    bundle: Path, certify: Certify, names: list[str]
) -> None:
    certify(solved("Lift", names[0]))
    with pytest.raises(InputError, match="No object 'unicorn_1'"):
        make_env(bundle, task="Lift").reset(options={"target": "unicorn_1"})
