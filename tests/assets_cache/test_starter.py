"""The bundles shipped with the package (made by ``python -m assets_cache.make_starter``)."""

from pathlib import Path

import numpy as np
import pytest

import assets_cache
from assets_cache.make_starter import MOST_BYTES, PROMPTS, TASKS
from generator.bundle import load, verify

THEMES = ("office", "dining", "kitchen", "coffee", "workbench", "craft", "vanity", "lab")


def starters() -> list[Path]:
    return assets_cache.find(assets_cache.STARTER)


def shipped() -> list[Path]:
    return [*starters(), *(path for name in TASKS for path in assets_cache.find(name))]


def test_every_theme_is_there_and_nothing_else() -> None:
    names = {path.name[:-13] for path in starters()}
    assert names == set(PROMPTS)
    folder = Path(assets_cache.__file__).parent / "tasks"
    assert {path.name[:-13] for path in folder.iterdir()} == set(TASKS)
    assert len(names) >= 12
    assert all(any(name.startswith(theme) for name in names) for theme in THEMES)


@pytest.mark.slow
def test_they_are_sound_and_their_tables_differ() -> None:
    outlines = set()
    for path in shipped():
        assert verify(path) == []
        scene = load(path)
        assert scene.report is not None
        assert scene.report.passed
        assert len(scene.objects) >= 3
        assert scene.plan is not None
        outlines.add(scene.plan.table.outline)
    assert len(outlines) >= 3


def test_they_are_light() -> None:
    weight = sum(p.stat().st_size for b in shipped() for p in b.rglob("*") if p.is_file())
    assert weight <= MOST_BYTES


@pytest.mark.parametrize("name", sorted([*PROMPTS, *TASKS]))
def test_each_loads_in_plain_mujoco(name: str) -> None:
    import mujoco

    (path,) = assets_cache.find(name)
    model = mujoco.MjModel.from_xml_path(str(path / "scene.xml"))
    assert model.key("settled").qpos.shape == (model.nq,)


def started(name: str, lift: float = 0.0) -> tuple[float, float, float]:
    """Return the hardest push on anything at t = 0 (m/s^2), and how fast anything is at most
    (m/s) and how far it gets (m) in the first 50 ms, in plain MuJoCo with nothing asleep.
    """
    import mujoco

    (path,) = assets_cache.find(name)
    model = mujoco.MjModel.from_xml_path(str(path / "scene.xml"))
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    assert not data.qvel.any()
    data.qpos.reshape(-1, 7)[:, 2] += lift
    start = data.qpos.reshape(-1, 7)[:, :3].copy()
    mujoco.mj_forward(model, data)
    push = np.linalg.norm(data.qacc.reshape(-1, 6)[:, :3], axis=1).max()
    fastest = farthest = 0.0
    for _ in range(round(0.05 / model.opt.timestep)):
        mujoco.mj_step(model, data)
        speeds = np.linalg.norm(data.qvel.reshape(-1, 6)[:, :3], axis=1)
        moves = np.linalg.norm(data.qpos.reshape(-1, 7)[:, :3] - start, axis=1)
        fastest, farthest = max(fastest, speeds.max()), max(farthest, moves.max())
    return float(push), float(fastest), float(farthest)


@pytest.mark.parametrize("name", ["dining-two", "kitchen-baking", "workbench-toys"])
def test_nothing_bounces_at_the_start(name: str) -> None:
    push, fastest, farthest = started(name)
    assert push < 0.3
    assert fastest < 1e-3
    assert farthest < 2e-5


def test_what_starts_in_the_air_would_be_noticed() -> None:
    push, fastest, farthest = started("workbench-toys", lift=2e-4)
    assert push > 5
    assert fastest > 1e-2
    assert farthest > 1e-4
