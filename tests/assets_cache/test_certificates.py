"""The certificates of the shipped bundles; CONTRIBUTING.md has the command to regenerate them."""

from pathlib import Path

import pytest
from extent import part_of

import assets_cache
from assets_cache.make_starter import PROMPTS, TASKS
from generator.errors import SceneError
from tabletopgen_env.certificates.certificate import (
    FILE,
    Certificate,
    TaskInstance,
    read_certificate,
)
from tabletopgen_env.certificates.certify import DEFAULT, find_instances, instance_of, names
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes.fixed import bundle_ref
from tabletopgen_env.tasks.names import NAMES, TaskName
from tabletopgen_env.tasks.registry import task_named
from tabletopgen_env.world.worlds import Masters

PART = ("coffee-square", "dining-fruit", "workbench", "kitchen-task-2", "tidy-task-3")
"""Two starters with vessels and one without, and a table of each of two kinds of tasks."""

ALL = [name for task in NAMES for name in names(task)]

Asked = tuple[str | None, object]
"""A target and a goal."""


def shipped(name: str) -> Path:
    folder = Path(assets_cache.__file__).parent / ("tasks" if name in TASKS else "starter")
    [path] = folder.glob(f"{name}-????????????")
    return path


def certificate(path: Path) -> Certificate:
    found = read_certificate(path)  # refuses that of another scene
    assert found is not None, f"{path.name} has none: certify it as CONTRIBUTING.md says"
    return found


def solved(path: Path, name: TaskName) -> set[Asked]:
    """Return the instances of a task that the expert solves according to the certificate."""
    listed = certificate(path).instances
    return {asked(i) for i in listed if i.name == name and i.certified}


def asked(instance: TaskInstance) -> Asked:
    return instance.target, instance.goal


def played(env: TabletopEnv, seed: int) -> Asked:
    """Return the episode of a reset, which must be certified."""
    assert env.reset(seed=seed)[1]["certified"] is True
    return asked(instance_of(env.task, env.episode))


@pytest.mark.slow
@pytest.mark.parametrize("name", part_of(sorted([*PROMPTS, *TASKS]), *PART))
def test_it_lists_what_the_bundle_offers_and_environments_keep_to_it(name: str) -> None:
    path = shipped(name)
    found = certificate(path)
    assert found.terms == DEFAULT
    masters = Masters(Panda(), 1)
    world = masters.twin(bundle_ref(path))
    for kind in ALL:
        listed = [i for i in found.instances if i.name == kind]
        if find_instances(world, task_named(*kind), DEFAULT.seed, 1):
            assert listed, f"{kind} is offered, but not listed"
        assert all(i.episodes == DEFAULT.episodes for i in listed if i.successes == i.episodes)
        env = make_env(path, task=kind.task, preset=kind.preset, masters=masters)
        if known := solved(path, kind):
            assert {played(env, seed) for seed in range(3)} <= known
        else:
            said = "no certified task" if listed else "no valid task"
            with pytest.raises(SceneError, match=said):
                env.reset(seed=0)


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_tables_that_are_not_asked_for_are_certified(name: TaskName) -> None:
    env = make_env(task=name.task, preset=name.preset)
    what = played(env, 0)
    assert what in solved(shipped(env.world.scene.name), name)


def test_they_are_light() -> None:
    for name in (*PROMPTS, *TASKS):
        assert len((shipped(name) / FILE).read_bytes()) < 40_000
