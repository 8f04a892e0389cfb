"""Rendering in forked processes, which cannot use OpenGL: in software, or with an error."""

import multiprocessing
import os
import warnings
from collections.abc import Callable, Iterator
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from toy import toy_scene

from generator.errors import BackendError
from tabletopgen_env.env import make_env
from tabletopgen_env.rendering.drawer import drawer
from tabletopgen_env.rendering.software import SoftwareDrawer
from tabletopgen_env.world.composition import FRONT_CAMERA

ID = "tabletopgen_env:TabletopGen/PickPlace-v0"
PIXELS: dict[str, Any] = {"observation": "pixels", "image_size": 16}
LIMIT = 60.0
"""Seconds after which a forked process is taken to hang."""

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")


@pytest.fixture(scope="module")
def drawn() -> Iterator[gym.Env]:
    """An environment that has drawn in this process, with OpenGL if available."""
    env = make_env(toy_scene(), **PIXELS)
    env.reset(seed=0)
    yield env
    env.close()


@pytest.fixture(scope="module")
def gl(drawn: gym.Env) -> bool:
    """Return whether it has drawn with OpenGL."""
    return not isinstance(drawn.unwrapped._drawer((16, 16)), SoftwareDrawer)  # type: ignore


def in_fork(work: Callable[[], Any]) -> Any:
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=lambda: sender.send(work()), daemon=True)
    process.start()
    sender.close()
    try:
        assert receiver.poll(LIMIT), "it hangs"
        return receiver.recv()
    finally:
        process.kill()
        process.join(LIMIT)


def told(work: Callable[[], Any]) -> tuple[list[str], list[str]]:
    """Return the result of ``work``, and its warnings under Python's default filters."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        done = work()
    return done, [str(w.message) for w in caught if "software" in str(w.message)]


@pytest.mark.slow
def test_vectors_of_forked_processes_draw(drawn) -> None:
    envs = gym.make_vec(
        ID, num_envs=2, vectorization_mode="async", scenes=toy_scene(),
        vector_kwargs={"context": "fork"}, **PIXELS,
    )  # fmt: skip
    assert isinstance(envs, gym.vector.AsyncVectorEnv)
    hangs = True
    try:
        envs.reset_async(seed=0)
        seen, _ = envs.reset_wait(timeout=LIMIT)
        hangs = False
    finally:
        envs.close(terminate=hangs)
    assert seen["front"].shape == (2, 16, 16, 3) and seen["front"].std() > 10


@pytest.mark.slow
def test_a_fork_of_what_drew_draws_in_software_and_says_so_once(gl) -> None:
    def work() -> list[str]:
        first, second = drawer("auto", 8, 8), drawer("auto", 16, 16)
        return [type(first).__name__, type(second).__name__]

    kinds, said = in_fork(lambda: told(work))
    assert kinds == ["SoftwareDrawer"] * 2
    assert len(said) == gl and all("spawn" in message for message in said)


def test_a_used_environment_goes_on_in_a_fork_and_here(drawn, gl) -> None:
    def work() -> np.ndarray:
        seen = drawn.reset(seed=0)[0]["front"]
        drawn.close()
        return seen

    before = drawn.reset(seed=0)[0]["front"]
    seen, said = in_fork(lambda: told(work))
    assert seen.shape == before.shape and seen.std() > 10
    assert len(said) == gl
    assert np.array_equal(drawn.reset(seed=0)[0]["front"], before)


def test_gl_asked_for_by_name_is_refused_in_a_fork(drawn, gl) -> None:
    def work() -> str:
        try:
            drawer("gl", 8, 8)
        except BackendError as error:
            return str(error)
        return ""

    says = in_fork(work)
    assert all(word in says for word in ("spawn", "forkserver")) == gl
    assert "renderer='software'" in says


def test_a_drawer_made_before_the_fork_is_refused_in_it(drawn, gl) -> None:
    if not gl:
        pytest.skip("no OpenGL here")
    eyes, world = drawn._drawer((16, 16)), drawn.world

    def work() -> str:
        try:
            eyes.rgb(world, FRONT_CAMERA)
        except BackendError as error:
            return str(error)
        return ""

    assert "forkserver" in in_fork(work)


@pytest.mark.slow
def test_a_forked_copy_detects_grasps(monkeypatch) -> None:
    """The network wakes no library threads, which do not exist in a fork."""
    env = make_env(toy_scene(), task="Lift", grasp_hint="detected")
    monkeypatch.setattr(env.unwrapped._worlds, "get", anew(env.unwrapped._worlds.get))
    seen = env.reset(seed=0)[0]
    assert np.array_equal(in_fork(lambda: env.reset(seed=0)[0]), seen)
    env.close()


def anew(get: Callable[..., Any]) -> Callable[..., Any]:
    """``get``, with worlds without cached grasps."""

    def got(*args: Any) -> Any:
        world = get(*args)
        world._known.clear()
        return world

    return got
