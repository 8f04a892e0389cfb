"""The tasks page matches the code."""

import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

import gymnasium
import numpy as np
import pytest
import tasks_page

from tabletopgen_env.actions import ACTIONS
from tabletopgen_env.env import make_env
from tabletopgen_env.tasks.names import NAMES
from tabletopgen_env.tasks.registry import task_named

DOCS = Path(__file__).parents[2] / "docs"


@pytest.fixture(scope="module")
def text() -> str:
    return tasks_page.page()


def script(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"docs_{name}", DOCS / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where dataclasses look for their module
    spec.loader.exec_module(module)
    return module


def rows(text: str, first: str) -> list[list[str]]:
    """Return the cells of the rows whose first cell fits a pattern."""
    lines = (line for line in text.splitlines() if line.startswith("|"))
    found = [[cell.strip() for cell in line.split("|")[1:-1]] for line in lines]
    return [row for row in found if re.fullmatch(first, row[0])]


def state_rows(text: str) -> list[list[str]]:
    """Return the rows of the table of the flat state: index, meaning, range, unit."""
    return [row for row in rows(text, r"\d+(-\d+)?") if len(row) == 4]


def test_weights_and_time_limits_are_those_of_the_tasks(text: str) -> None:
    (head,) = rows(text, "task")
    for name in NAMES:
        (row,) = (r for r in rows(text, name))
        shown = {t: float(w) for t, w in zip(head[1:], row[1:], strict=True) if w}
        assert shown == task_named(name).weights
        limits = {row[2] for row in rows(text, rf"\[`TabletopGen/{name}-v0`\].*")}
        steps = gymnasium.spec(f"TabletopGen/{name}-v0").max_episode_steps
        assert limits == {f"{steps} steps, {(steps or 0) / 20:g} s"}


def test_the_table_of_the_state_covers_its_entries_with_their_ranges(text: str) -> None:
    plain, space = (make_env("lab", grasp_hint=hint).observation_space for hint in (False, True))
    assert isinstance(space, gymnasium.spaces.Box) and plain.shape is not None
    end = 0
    for index, _, limits, _ in state_rows(text):
        first, _, last = index.partition("-")
        assert int(first) == end
        end = int(last or first) + 1
        if limits:
            high = float(limits.strip("[]{}").split(",")[1])
            np.testing.assert_allclose(space.high[int(first) : end], high)
    assert space.shape == (end,)
    assert f"the flat state ({plain.shape[0]} entries; {end} with the hint)" in text


def test_the_table_of_actions_has_every_mode_and_its_size(text: str) -> None:
    sizes = {}
    for mode, *_ in rows(text, r"`\w+` \(\d\)"):
        name, _, size = mode.partition(" ")
        sizes[name.strip("`")] = (int(size.strip("()")),)
    assert sizes == {mode: make_env("lab", action=mode).action_space.shape for mode in ACTIONS}


def test_every_strip_is_shown_and_small(text: str) -> None:
    pictures = script("make_task_pictures")
    shown = re.findall(r"\]\(\.\./(images/tasks/(\w+)\.png)\)", text)
    assert sorted(name for _, name in shown) == sorted(pictures.STRIPS)
    assert {strip.task for strip in pictures.STRIPS.values()} == set(NAMES)
    assert all((DOCS / path).stat().st_size <= pictures.MOST_BYTES for path, _ in shown)
