"""The environment page: its table of ``info`` matches the code."""

import re
from collections.abc import Mapping
from typing import Any

import pytest
from blocks import ROOT
from toy import toy_scene

from tabletopgen_env.env import make_env
from tabletopgen_env.tasks.names import NAMES

TEXT = (ROOT / "docs/reference/environment.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| `(\w+)` \| (reset(?:, step)?|step) \| ([^|]+) \|", TEXT, re.M)
MODES = (
    "state", "goal", "pixels", "pixels+proprio", "pixels+state", "point_cloud", "point_cloud+state",
)  # fmt: skip


def fits(value: Any, kind: str) -> bool:
    """Return whether a value has a type as named on the page."""
    known = {
        "bool": lambda: isinstance(value, bool),
        "str": lambda: isinstance(value, str),
        "str or None": lambda: value is None or isinstance(value, str),
        "(int, int)": lambda: isinstance(value, tuple) and [type(v) for v in value] == [int, int],
        "tuple of str": lambda: isinstance(value, tuple) and all(isinstance(v, str) for v in value),
        "dict of str to float": lambda: (
            isinstance(value, Mapping)
            and all(isinstance(k, str) and isinstance(v, float) for k, v in value.items())
        ),
        "dict": lambda: isinstance(value, dict),
    }
    return known[kind.strip()]()


def check(info: dict[str, Any], when: str, cameras: bool) -> None:
    told = {key: kind for key, times, kind in ROWS if when in times}
    if not cameras:
        del told["cameras"]
    assert set(info) == set(told)
    for key, kind in told.items():
        assert fits(info[key], kind), (key, info[key])
    assert all(0 <= term <= 1 for term in info["reward_terms"].values())


def check_episode(env: Any, cameras: bool = False) -> None:
    _, info = env.reset(seed=0)
    check(info, "reset", cameras)
    check(env.step(env.action_space.sample())[4], "step", cameras)
    env.close()


@pytest.mark.slow
@pytest.mark.parametrize("task", NAMES)
def test_the_table_has_every_key_of_info_at_every_task(task) -> None:
    tidy = task == "Tidy"
    check_episode(make_env("tidy-task-1" if tidy else toy_scene(), task=task))


@pytest.mark.slow
@pytest.mark.parametrize("mode", MODES)
def test_the_table_has_every_key_of_info_in_every_mode(mode) -> None:
    pictures = {} if mode in ("state", "goal") else {"renderer": "software", "image_size": 8}
    env = make_env(toy_scene(), observation=mode, randomization="light", **pictures)
    check_episode(env, bool(pictures))
