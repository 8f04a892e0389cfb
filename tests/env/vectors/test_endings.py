"""Ends of worker processes and their parent: no remains, and a single error.

Scripts run without a main guard, in processes of their own, each with a limit of time.
"""

import gc
import os
import pickle
import signal
import subprocess
import sys
import time
import weakref
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shard_tasks
from bounded import LONG, line_of, running, until
from toy import toy_scene

from generator.errors import InputError, SceneError
from generator.jobs.workers import WorkerDied
from tabletopgen_env.parallel.vector import TabletopVectorEnv

SOON = 10.0
"""Seconds in which processes are to be gone."""

STILL = np.zeros((3, 5))
HEAD = (
    "import sys; sys.path[:0] = ['tests', 'tests/env/vectors']\n"
    "import numpy as np\n"
    "from shard_tasks import nap\n"
    "from toy import toy_scene\n"
    "from tabletopgen_env.parallel.vector import TabletopVectorEnv\n"
    "envs = TabletopVectorEnv(3, processes=2, task='Reach', scenes=toy_scene())\n"
    "envs.reset(seed=0)\n"
    "print(*envs.pids, flush=True)\n"
)
"""A script begins so; it is run from the repository's root."""


def alive(pid: int) -> bool:
    """Return whether a process runs; False for zombies."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return False
    return state not in "ZX"


def gone(pids: Any) -> bool:
    return not any(map(alive, pids))


def shared_files() -> set[str]:
    """Return the named segments of shared memory, except process locks.

    Such a lock loses its name as soon as it is made; other tests make some at the same time.
    """
    place = Path("/dev/shm")
    names = {path.name for path in place.iterdir()} if place.is_dir() else set()
    return {name for name in names if not name.startswith("sem.mp-")}


def nothing_is_left(before: set[str]) -> None:
    """Wait until only earlier segments exist, some of which others may have removed."""
    until(lambda: shared_files() <= before, SOON)


def made(**settings: Any) -> TabletopVectorEnv:
    envs = TabletopVectorEnv(3, processes=2, task="Reach", scenes=toy_scene(), **settings)
    envs.reset(seed=0)
    return envs


def script(rest: str, **settings: Any) -> Any:
    """Run a script in the context."""
    pipe = subprocess.PIPE
    command = (sys.executable, "-c", HEAD + rest)
    return running(*command, stdout=pipe, stderr=pipe, text=True, **settings)


@pytest.mark.parametrize(
    "when", ["between steps", pytest.param("within a step", marks=pytest.mark.slow)]
)
def test_a_shard_that_is_killed_ends_all_with_one_error(when: str) -> None:
    envs = made()
    pids = envs.pids
    if when == "between steps":
        os.kill(pids[1], signal.SIGKILL)
        until(lambda: not alive(pids[1]), SOON)
        with pytest.raises(WorkerDied) as caught:
            envs.step(STILL)
    else:
        with pytest.raises(WorkerDied) as caught:
            envs.visit(lambda env: os.kill(os.getpid(), signal.SIGKILL), [2])
    told = str(caught.value)
    assert isinstance(caught.value, SceneError)
    assert "shard 1 of 2 (slots 2 to 2 of the vector environment) was killed (SIGKILL)." in told
    assert "create a new vector environment, with fewer processes" in told
    assert gone(pids) and envs.closed
    for call in (lambda: envs.step(STILL), envs.reset, envs.render):
        with pytest.raises(InputError, match="closed"):
            call()
    envs.close()
    assert pickle.loads(pickle.dumps(envs)).closed


@pytest.mark.slow
def test_a_shard_that_exits_is_named_with_its_code() -> None:
    envs = made()
    with pytest.raises(WorkerDied, match=r"shard 0 of 2 \(slots 0 to 1 .* exited with code 3\."):
        envs.visit(shard_tasks.vanish, [0])
    assert envs.closed and gone(envs.pids)


def test_what_cannot_be_unpacked_there_is_an_error_at_once() -> None:
    class Odd(shard_tasks.Reach):
        def __reduce__(self) -> Any:
            return int, ("no number",)

    with pytest.raises(ValueError, match="invalid literal for int"):
        TabletopVectorEnv(1, processes=1, task=Odd(), scenes=toy_scene())


@pytest.mark.slow
def test_closing_ends_the_processes_and_may_be_done_twice() -> None:
    before = shared_files()
    envs = made()
    nothing_is_left(before)
    envs.close()
    assert gone(envs.pids)
    nothing_is_left(before)
    envs.close()
    with pytest.raises(InputError, match="closed"):
        envs.step(STILL)


@pytest.mark.slow
def test_one_that_is_forgotten_takes_its_processes_along() -> None:
    envs = made()
    pids, seen = envs.pids, weakref.ref(envs)
    del envs
    gc.collect()
    assert seen() is None
    until(lambda: gone(pids), SOON)


@pytest.mark.slow
def test_after_an_interrupted_call_it_goes_on_and_is_closed() -> None:
    envs = made()

    def interrupt(*_: Any) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with pytest.raises(KeyboardInterrupt):
            envs.visit(shard_tasks.nap)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert envs.visit(shard_tasks.pid) == [envs.pids[0], envs.pids[0], envs.pids[1]]
    assert envs.step(STILL)[1].shape == (3,)
    envs.close()
    assert gone(envs.pids)


@pytest.mark.slow
def test_an_interrupt_while_a_scene_is_drawn_closes_it() -> None:
    class Interrupted:
        def draw(self, rng: np.random.Generator) -> Any:
            raise KeyboardInterrupt

    envs = TabletopVectorEnv(2, processes=2, task="Reach", scenes=Interrupted())
    with pytest.raises(KeyboardInterrupt):
        envs.reset()
    assert envs.closed and gone(envs.pids)


@pytest.mark.slow
def test_all_end_with_a_process_that_is_killed() -> None:
    before = shared_files()
    with script("while True: envs.step(np.zeros((3, 5)))") as process:
        pids = [int(pid) for pid in line_of(process).split()]
        time.sleep(0.3)
        assert all(map(alive, pids))
        nothing_is_left(before)
        process.kill()
        process.wait(LONG)
        until(lambda: gone(pids), SOON)
    nothing_is_left(before)


@pytest.mark.slow
def test_busy_shards_end_with_a_process_that_is_killed() -> None:
    with script("envs.visit(lambda env: nap(env, 100.0))") as process:
        pids = [int(pid) for pid in line_of(process).split()]
        time.sleep(0.3)
        process.kill()
        process.wait(LONG)
        until(lambda: gone(pids), SOON)


@pytest.mark.slow
def test_ctrl_c_ends_a_script_and_its_shards() -> None:
    with script("while True: envs.step(np.zeros((3, 5)))") as process:
        pids = [int(pid) for pid in line_of(process).split()]
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=LONG)
        assert process.returncode == -signal.SIGINT and "resource_tracker" not in errors
        assert errors.count("Traceback") == 1 and errors.rstrip().endswith("KeyboardInterrupt")
        until(lambda: gone(pids), SOON)


@pytest.mark.slow
@pytest.mark.parametrize("rest", ["", "envs.step(np.zeros((3, 5)))\n", "envs.close()\n"])
def test_a_script_that_ends_has_nothing_to_complain_of(rest: str) -> None:
    with script(rest) as process:
        said, errors = process.communicate(timeout=LONG)
    assert (process.returncode, errors) == (0, "")
    until(lambda: gone(int(pid) for pid in said.split()), SOON)
