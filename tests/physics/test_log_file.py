"""MuJoCo's log file: simulations never write one into the working directory."""

import contextlib
import re
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import mujoco
import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.bundle.derived import check_starts
from generator.errors import SceneError
from generator.imports.mjcf import compile_foreign
from generator.imports.mjcf_files import GatheredModel
from generator.physics.simulation import Simulation
from generator.physics.spec import compile_spec, list_warnings, new_data, scene_spec
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.world import World

ROOT = Path(__file__).parent.parent.parent
SCENE = toy_scene((toy_object("cube", (0.03, 0.03, 0.03), (0.0, 0.0)),))


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty working directory, with MuJoCo's log in its initial state."""
    monkeypatch.chdir(tmp_path)
    before = mujoco.MjLogConfig.get()
    log(True, "MUJOCO_LOG.TXT")
    yield tmp_path
    before.set()


def log(to_file: bool, name: str) -> None:
    config = mujoco.MjLogConfig.get()
    config.logto_file, config.logfile = to_file, name
    config.set()


def simulate() -> None:
    simulation = Simulation(SCENE)
    simulation.data.qvel[0] = np.inf
    simulation.run(0.01)
    assert simulation.diverged == (0,)


def step() -> None:
    world = World(SCENE, Panda())
    for each in (world, world.twin()):
        log(True, "MUJOCO_LOG.TXT")  # as in a process that got the world from another
        each = each.twin()
        each.data.qvel[-1] = np.nan
        each.step(2)
        assert any("QVEL" in text for text in list_warnings(each.data))


def compile_nan() -> None:
    xml = '<mujoco><worldbody><geom size="nan"/></worldbody></mujoco>'
    compile_foreign(GatheredModel(xml, {}), "it")


def start() -> None:
    model = compile_spec(scene_spec(SCENE, visuals=False), "toy")
    model.key_qpos[0, 0] = np.nan
    with pytest.raises(SceneError, match="cannot simulate the scene 'toy' from its start"):
        check_starts(model, "toy")
    assert mujoco.MjLogConfig.get().logto_console


@pytest.mark.parametrize("run", [simulate, step, start])
def test_a_diverging_simulation_writes_no_file(run: Callable[[], None], folder: Path) -> None:
    run()
    assert not [*folder.iterdir()]


def test_a_warning_of_the_compiler_writes_no_file(folder: Path) -> None:
    with contextlib.suppress(ValueError):
        compile_nan()
    assert not [*folder.iterdir()]


def test_threads_that_diverge_write_no_file_and_know_of_their_own(folder: Path) -> None:
    errors: list[BaseException] = []

    def run(odd: bool) -> None:
        try:
            for _ in range(5):
                simulation = Simulation(SCENE)
                if odd:
                    simulation.data.qvel[0] = np.inf
                simulation.run(0.02)
                assert bool(simulation.diverged) == odd
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=run, args=(bool(k % 2),)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=120)
    assert not errors and not any(thread.is_alive() for thread in threads)
    assert not [*folder.iterdir()]


def test_a_log_file_and_a_handler_of_the_caller_stay(folder: Path) -> None:
    log(True, str(folder / "mine.log"))
    simulate()
    assert [path.name for path in folder.iterdir()] == ["mine.log"]
    said: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(said.append)
    try:
        simulate()
    finally:
        mujoco.set_mju_user_warning(before)
    assert any("QVEL" in text for text in said)


def test_contacts_beyond_memory_are_an_error_of_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    def overflow(*args: object) -> None:
        raise mujoco.FatalError("mj_stackAlloc: out of memory, stack overflow")

    simulation = Simulation(SCENE)
    monkeypatch.setattr(mujoco, "mj_step", overflow)
    with pytest.raises(SceneError, match="cannot simulate the scene"):
        simulation.run(0.1)
    monkeypatch.setattr(mujoco, "mj_collision", overflow)
    with pytest.raises(SceneError, match="out of memory"):
        simulation.contacts()


def test_every_state_is_made_without_a_log_file() -> None:
    apart = {"generator/physics/spec.py", "generator/exports/loaders/load_mujoco.py",
             "generator/cli/machine_facts.py"}  # fmt: skip
    made = {
        path.relative_to(ROOT).as_posix()
        for package in ("tabletop_objects", "generator", "tabletopgen_env", "tabletopgen_web")
        for path in (ROOT / package).rglob("*.py")
        if re.search(r"\bMjData\(", path.read_text())
    }
    assert made == apart
    assert new_data(compile_spec(scene_spec(SCENE, visuals=False), "toy")).time == 0
