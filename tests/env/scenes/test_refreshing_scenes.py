"""A pool of scenes renewed during training, including failures of the producers."""

import itertools
import multiprocessing
import os
import pickle
import shutil
import signal
import subprocess
import sys
import textwrap
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bounded import LONG, line_of, until
from extent import part_of
from toy import toy_scene

import assets_cache
from generator.errors import BundleError, InputError, SceneError
from tabletopgen_env.env import make_env
from tabletopgen_env.scenes import (
    FixedScenes,
    FreshScenes,
    RefreshingScenes,
    SceneDistribution,
    SceneRef,
    SplitRule,
)
from tabletopgen_env.scenes.lookup import fixed_scenes
from tabletopgen_env.scenes.production.background import Background
from tabletopgen_env.scenes.production.pool import RenewalPace


def initial(count: int = 3) -> FixedScenes:
    return fixed_scenes([toy_scene(name=f"first_{k}") for k in range(count)])


def alive(pid: int) -> bool:
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
    except OSError:
        return False
    return state != "Z"


def draw_until(
    source: RefreshingScenes, rng: np.random.Generator, happened: Callable[[SceneRef], object]
) -> None:
    """Draw until a condition on the drawn scene holds."""
    until(lambda: happened(source.draw(rng)))


@pytest.fixture
def pool(tmp_path, monkeypatch) -> Iterator[Callable[..., RefreshingScenes]]:
    """Return a function that makes pools of toy scenes in ``tmp_path``, closed at the end."""
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    made: list[RefreshingScenes] = []

    def make(making: str = "toy", **settings: Any) -> RefreshingScenes:
        given = {"size": 4, "initial": initial(), "per_minute": 6000.0, "seed": 0, **settings}
        made.append(RefreshingScenes(FreshScenes("x", making=f"makers:{making}"), **given))
        return made[-1]

    yield make
    for source in made:
        source.close()
    assert not list(tmp_path.iterdir()), "something was left behind"


# ------------------------------------------------------------------------- in step with the draws
def stepped(**settings: Any) -> RefreshingScenes:
    fresh = FreshScenes("x", making="makers:toy")
    given = {"size": 4, "every_resets": 3, "synchronous": True, **settings}
    return RefreshingScenes(fresh, **given)


def drawn(source: RefreshingScenes, seed: int = 0, count: int = 20) -> list[str]:
    rng = np.random.default_rng(seed)
    return [source.draw(rng).key for _ in range(count)]


def test_synchronous_renewals_repeat_themselves() -> None:
    assert drawn(stepped()) == drawn(stepped()) != drawn(stepped(), seed=1)
    assert drawn(stepped(seed=7)) == drawn(stepped(seed=7)) != drawn(stepped(seed=8))


def test_without_a_seed_each_generator_gets_scenes_of_its_own() -> None:
    assert set(drawn(stepped())).isdisjoint(drawn(stepped(), seed=1))


def test_a_scene_is_renewed_every_so_many_draws_the_oldest_first() -> None:
    source, rng = stepped(seed=0), np.random.default_rng(0)
    pools = []
    for _ in range(10):
        source.draw(rng)
        pools.append([ref.key for ref in source.refs])
    assert pools[0] == pools[1] == pools[2]
    assert pools[3] == pools[4] == pools[5] and pools[3][:3] == pools[2][1:]
    assert pools[9][0] == pools[0][3]
    assert source.renewals == 3 and not source.pids


def test_the_first_pool_is_given_or_made() -> None:
    source = stepped(initial=initial(9), size=5, seed=0)
    source.draw(np.random.default_rng(0))
    given = {ref.key for ref in source.initial.refs}  # type: ignore[union-attr]
    first = {ref.key for ref in source.refs}
    assert len(first) == 5 and first < given
    source = stepped(seed=0)
    assert source.refs == ()
    source.draw(np.random.default_rng(0))
    assert len({ref.key for ref in source.refs}) == 4


@pytest.mark.slow
def test_scenes_are_made_of_what_is_asked_for() -> None:
    source = RefreshingScenes(
        SceneDistribution(themes=("tea",), objects=(1, 1)), size=2, every_resets=9, synchronous=True
    )
    source.draw(np.random.default_rng(0))
    assert [o.model.category for ref in source.refs for o in ref.load().objects] == ["teapot"] * 2


def test_a_renewal_that_fails_leaves_the_pool_and_warns_once() -> None:
    source = RefreshingScenes(
        FreshScenes("x", making="makers:failing"), size=3, every_resets=1, synchronous=True,
        initial=initial(), seed=0,
    )  # fmt: skip
    with pytest.warns(
        RuntimeWarning, match="not be renewed: .*nothing stands.*only counted"
    ) as said:
        seen = drawn(source)
    assert len(said) == 1 and source.failures == 19 and source.renewals == 0
    assert set(seen) == {ref.key for ref in source.refs} and len(source.refs) == 3


def test_a_first_pool_that_cannot_be_made_is_an_error() -> None:
    for synchronous in (True, False):
        source = RefreshingScenes(
            FreshScenes("x", making="makers:failing"), every_resets=1, synchronous=synchronous
        )
        with pytest.raises(
            SceneError,
            match=r"The first pool could not be generated: 5 consecutive scenes.*nothing stands",
        ):
            source.draw(np.random.default_rng(0))
        assert not source.pids


def test_a_text_that_cannot_be_planned_is_an_error_at_the_first_draw() -> None:
    source = RefreshingScenes("ein Tisch mit einer Tasse und einem Buch", initial=initial())
    with pytest.raises(InputError, match="English"):
        source.draw(np.random.default_rng(0))
    assert not source.pids


def test_what_is_due() -> None:
    assert [RenewalPace(None, 3).due(k, 99.0) for k in range(7)] == [0, 0, 0, 1, 0, 0, 1]
    assert RenewalPace(6.0, None).due(5, 20.0) == 2.0


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"size": 0}, "size must be a whole number >= 1"),
        ({"workers": 0}, "workers must be a whole number >= 1"),
        ({"seed": -1}, "A seed must be a whole number from 0"),
        ({"per_minute": 0.0}, "positive number"),
        ({"per_minute": float("nan")}, "positive number"),
        ({"every_resets": 0}, "must be at least 1"),
        ({"per_minute": 1.0, "every_resets": 1}, "exactly one of per_minute and every_resets"),
        ({"synchronous": True}, "exactly one of per_minute and every_resets.*synchronous"),
        ({"synchronous": True, "per_minute": 1.0}, "requires every_resets"),
        ({"initial": 5}, "scenes has type int"),
        ({"initial": "fresh:a desk"}, "'fresh:a desk' is not a fixed scene"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        RefreshingScenes("a desk", **settings)


# ---------------------------------------------------------------------------- in the background
@pytest.mark.slow
def test_new_scenes_come_while_old_ones_are_drawn(pool, tmp_path) -> None:
    source, rng = pool(workers=1), np.random.default_rng(0)
    given = {ref.key for ref in source.initial.refs}
    assert source.draw(rng).key in given  # it does not wait for the first new one
    assert len(source.pids) == 1
    draw_until(source, rng, lambda _: source.renewals >= 8)
    assert len(source.refs) == 4 and given.isdisjoint({ref.key for ref in source.refs})
    for ref in source.refs:
        assert ref.load().name.startswith("toy_")
        assert ref.difficulty is not None and 0 <= ref.difficulty <= 1
    kept = {ref.load.path for ref in source.refs}
    finished = [p.parent.parent for p in tmp_path.glob("*/*/toy_*/scene.json")]
    assert {p.parent for p in kept} <= set(finished)
    assert len(finished) <= len(kept) + 1  # what was dropped is deleted
    assert source.failures == 0


@pytest.mark.slow
def test_a_dropped_scene_says_that_it_is_gone(pool) -> None:
    source, rng = pool(size=1, initial=initial(1)), np.random.default_rng(0)
    draw_until(source, rng, lambda ref: ref.key.startswith("fresh"))
    old = source.refs[0]
    draw_until(source, rng, lambda _: source.refs[0].key != old.key)
    with pytest.raises(BundleError, match="no bundle at"):
        old.load()


@pytest.mark.slow
def test_pools_of_one_seed_get_the_same_scenes_whoever_makes_them(pool) -> None:
    def renewals(source: RefreshingScenes) -> list[str]:
        seen = {}

        def enough(_: SceneRef) -> bool:
            seen.update((r.key, r) for r in source.refs if r.key.startswith("fresh"))
            return len(seen) >= 3

        draw_until(source, np.random.default_rng(0), enough)
        return [f"{key} {ref.load().name}" for key, ref in list(seen.items())[:3]]

    often = {"every_resets": 1, "per_minute": None, "size": 6}
    assert renewals(pool(**often)) == renewals(pool(**often, synchronous=True))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("making", "workers"),
    part_of(itertools.product(["toy", "unhurried"], [1, 2]), ("toy", 1), ("unhurried", 2)),
)
def test_scenes_in_step_do_not_depend_on_how_fast_they_are_made(
    pool, making: str, workers: int
) -> None:
    """Draws do not depend on whether the processes have finished."""
    first = initial()

    def seen(pause: float, **more: Any) -> list[tuple[str, tuple[str, ...]]]:
        given = {"initial": first, "every_resets": 2, "per_minute": None, "workers": workers}
        source = pool(making, **given, **more)
        rng, out = np.random.default_rng(0), []
        for _ in range(7):
            time.sleep(pause)
            key = source.draw(rng).key
            out.append((key, tuple(ref.key for ref in source.refs)))
        assert source.renewals == 3 and source.failures == 0
        source.close()
        return out

    assert seen(0.0) == seen(0.15) == seen(0.0, synchronous=True)


@pytest.mark.slow
def test_scenes_in_step_that_fail_leave_the_pool_as_it_is(pool) -> None:
    first = initial()
    source = pool("failing", initial=first, every_resets=1, per_minute=None)
    rng = np.random.default_rng(0)
    with pytest.warns(RuntimeWarning, match="could not be renewed"):
        keys = [source.draw(rng).key for _ in range(4)]
    assert {*keys} <= {ref.key for ref in first.refs}
    assert (source.failures, source.renewals) == (3, 0)


def test_a_process_says_nothing_of_its_own_so_that_last_words_are_the_cause(tmp_path) -> None:
    given = [sys.executable, "-m", "generator.jobs.worker", str(tmp_path / "scenes")]
    done = subprocess.run(given, stdin=subprocess.DEVNULL, capture_output=True, timeout=LONG)
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")


@pytest.mark.slow
def test_a_killed_process_is_replaced(pool) -> None:
    source, rng = pool("slow"), np.random.default_rng(0)
    source.draw(rng)
    (first,) = source.pids
    os.kill(first, signal.SIGKILL)

    def replaced(ref: SceneRef) -> bool:
        assert ref.key.startswith("scene:")
        return bool(source.pids) and source.pids != (first,)

    with pytest.warns(RuntimeWarning, match=r"was killed \(SIGKILL\)\. "):
        draw_until(source, rng, replaced)
    assert source.failures == 1 and not alive(first)
    assert len(source.refs) == 3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("making", "reason"),
    [
        ("crashing", "exited with code 7: memory was lost"),
        ("broken", "ZeroDivisionError: a bug"),
        ("failing", "SceneError: 3 attempts .* nothing stands"),
    ],
)
def test_whatever_goes_wrong_is_told_once_and_counted(pool, making, reason) -> None:
    source = pool(making)
    with pytest.warns(RuntimeWarning, match=f"not be renewed: .*{reason}") as said:
        draw_until(source, np.random.default_rng(0), lambda _: source.failures >= 2)
    assert len(said) == 1 and source.renewals == 0
    assert {ref.key for ref in source.refs} == {ref.key for ref in source.initial.refs}


def test_pauses_grow_with_failures_in_a_row_and_a_job_has_its_time(tmp_path, monkeypatch) -> None:
    now = [0.0]
    monkeypatch.setattr(
        "tabletopgen_env.scenes.production.background.time.monotonic", lambda: now[0]
    )
    background = Background(1, rest=1.0, timeout=0.2)
    ends, starts, start = [], [], background._start
    monkeypatch.setattr(background, "_start", lambda job: starts.append(now[0]) or start(job))

    def given_up() -> bool:
        ends.extend(background.collect())
        return len(ends) == len(starts)

    try:
        recipe = FreshScenes("x", making="makers:slow").recipe(np.random.default_rng(0))
        for _ in range(4):
            background.order(recipe)
        for _ in range(80):
            ends += background.collect()
            until(given_up)
            now[0] += 0.5
    finally:
        background.close()
    assert all("exceeded its limit of 0.2 s" in end.reason for end in ends) and len(ends) == 4
    assert list(np.diff(starts)) == [1.0, 2.0, 4.0]


@pytest.mark.slow
def test_a_lost_temporary_folder_is_made_good(pool, tmp_path) -> None:
    source, rng = pool(size=2, initial=initial(1)), np.random.default_rng(0)
    draw_until(source, rng, lambda _: source.renewals >= 3)
    for folder in tmp_path.iterdir():
        for job in folder.glob("0*"):
            if job.is_dir():
                job.rename(tmp_path / f"{job.name}-gone")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        for _ in range(10):
            assert source.draw(rng).load().name.startswith("toy_")
    assert source.failures >= 1
    for lost in tmp_path.glob("*-gone"):
        shutil.rmtree(lost)


def test_a_process_that_cannot_start_is_a_failure_like_any_other(pool, monkeypatch) -> None:
    monkeypatch.setattr("generator.jobs.workers.sys.executable", "/no/python")
    source, rng = pool(), np.random.default_rng(0)
    with pytest.warns(RuntimeWarning, match="process could not be started"):
        draw_until(source, rng, lambda r: r.key.startswith("scene:") and source.failures > 0)


def test_what_cannot_be_ordered_is_not_looked_for_at_every_draw(pool) -> None:
    neither = (SplitRule("train"), SplitRule("held_out"))
    fresh = FreshScenes("x", making="makers:toy", rules=neither)
    source, rng = RefreshingScenes(fresh, size=9, initial=initial()), np.random.default_rng(0)
    with pytest.warns(
        RuntimeWarning, match="None of 1000 drawn scenes belongs to 'train'.*'held_out'"
    ):
        for _ in range(20):
            source.draw(rng)
    assert source.failures == 1 and not source.pids
    source.close()


# ------------------------------------------------------------------------------- how it ends
def test_closing_ends_everything_and_may_be_done_twice(pool, tmp_path) -> None:
    source, rng = pool(workers=2, size=5), np.random.default_rng(0)
    source.close()  # before anything began
    source.draw(rng)
    pids = source.pids
    assert len(pids) == 2
    source.close()
    source.close()
    assert not any(map(alive, pids)) and not list(tmp_path.iterdir())
    assert source.draw(rng).key  # it begins anew
    assert set(source.pids).isdisjoint(pids)


@pytest.mark.slow
def test_what_a_process_has_started_ends_with_it_and_ctrl_c_reaches_neither(pool, tmp_path) -> None:
    note = tmp_path / "pid"
    fresh = FreshScenes(str(note), making="makers:nested")
    source = RefreshingScenes(fresh, initial=initial())
    source.draw(np.random.default_rng(0))
    until(note.is_file)
    inner, (outer,) = int(note.read_text()), source.pids
    assert os.getsid(inner) == os.getsid(outer) == outer
    source.close()
    until(lambda: not alive(inner))
    note.unlink()


def test_a_forgotten_pool_ends_by_itself(pool, tmp_path) -> None:
    source = RefreshingScenes(FreshScenes("x", making="makers:slow"), initial=initial())
    source.draw(np.random.default_rng(0))
    pids = source.pids
    assert all(map(alive, pids))
    del source
    assert not any(map(alive, pids)) and not list(tmp_path.iterdir())


@pytest.mark.slow
def test_an_environment_closes_only_what_it_made(pool, tmp_path) -> None:
    source = pool()
    mine, yours = make_env(source), make_env("refreshing")
    for env in (mine, yours):
        env.reset(seed=0)
    theirs = yours.source
    assert isinstance(theirs, RefreshingScenes) and theirs.pids
    for env in (mine, yours):
        env.close()
        env.close()
    assert source.pids and not theirs.pids


def test_a_copy_begins_anew(pool) -> None:
    source, rng = pool(), np.random.default_rng(0)
    source.draw(rng)
    again = pickle.loads(pickle.dumps(source))
    assert again.refs == () and not again.pids and source.pids
    assert again.draw(rng).key.startswith("scene:")
    assert set(again.pids).isdisjoint(source.pids)
    again.close()
    assert source.pids


@pytest.mark.slow
def test_an_environment_with_a_running_pool_can_be_pickled(pool) -> None:
    env = make_env(pool())
    blank = pickle.dumps(env)
    env.source.draw(np.random.default_rng(0))
    for copy in (pickle.loads(blank), pickle.loads(pickle.dumps(env))):
        assert copy.source.refs == () and copy.source.size == 4
        assert copy.reset(seed=0)[1]["scene"].startswith("first_")
        copy.source.close()


SCRIPT = """
import os, sys, time
import numpy as np
from toy import toy_scene
from tabletopgen_env.scenes import FreshScenes, RefreshingScenes

source = RefreshingScenes(
    FreshScenes("x", making="makers:{making}"), initial=toy_scene(), workers=2
)
rng = np.random.default_rng(0)
source.draw(rng)
folder = source._pool.background.folder
print(*source.pids, folder, flush=True)
{end}
"""


def run(tmp_path: Path, end: str, making: str = "slow") -> tuple[subprocess.Popen, list[int], Path]:
    """Run a script without a main guard; return it, its pool's processes and folder."""
    here = Path(__file__).parent
    path = os.pathsep.join([str(here), str(here.parent.parent), *sys.path])
    script = tmp_path / "train.py"
    script.write_text(textwrap.dedent(SCRIPT).format(end=end, making=making))
    process = subprocess.Popen(
        [sys.executable, str(script)], stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": path},
    )  # fmt: skip
    *pids, folder = line_of(process).split()
    return process, [int(pid) for pid in pids], Path(folder)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("end", "code"),
    [
        ("", 0),  # the end of the script
        ("raise SystemExit(3)", 3),
        ("os._exit(4)", 4),  # no handler runs
        ("os.kill(os.getpid(), 9)", -9),
        ("if os.fork() == 0: sys.exit()\nos.wait(); source.draw(rng); "
         "print(folder.is_dir(), *source.pids)", 0),  # nor does a fork end it
    ],
)  # fmt: skip
def test_nothing_outlives_the_process_however_it_ends(tmp_path, end, code) -> None:
    process, pids, folder = run(tmp_path, end)
    assert len(pids) == 2
    rest, _ = process.communicate(timeout=LONG)
    assert process.returncode == code
    until(lambda: not any(map(alive, pids)) and not folder.exists())
    if "fork" in end:
        assert rest.split() == ["True", *map(str, pids)]


def _child(source: RefreshingScenes, before: tuple[int, ...], told: Any) -> None:
    """Draw in another process from a source that was pickled or forked."""
    source.draw(np.random.default_rng(1))
    told.send((source.pids, bool(set(source.pids) & set(before))))
    told.poll(LONG)


@pytest.mark.slow
@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_another_process_has_a_pool_of_its_own_even_a_daemon(pool, start) -> None:
    """Vector environments use daemonic processes, which cannot have multiprocessing children."""
    source = pool("slow")
    source.draw(np.random.default_rng(0))
    mine = source.pids
    context = multiprocessing.get_context(start)
    here, there = context.Pipe()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # forking beside threads
        child = context.Process(target=_child, args=(source, mine, there), daemon=True)
        child.start()
    assert here.poll(LONG)
    theirs, shared = here.recv()
    assert len(theirs) == 1 and not shared and all(map(alive, (*mine, *theirs)))
    here.send(None)
    child.join(LONG)
    assert child.exitcode == 0
    until(lambda: not any(map(alive, theirs)))
    assert all(map(alive, mine))


@pytest.mark.slow
def test_bundles_that_were_there_at_first_are_never_deleted(pool, tmp_path, monkeypatch) -> None:
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path / "store"))
    path = assets_cache.add(toy_scene(name="kept"), allow_failed=True)
    source, rng = pool(size=1, initial="kept"), np.random.default_rng(0)
    draw_until(source, rng, lambda ref: ref.key.startswith("fresh"))
    assert (path / "scene.json").is_file()
    shutil.rmtree(tmp_path / "store")
