"""Shared parts of the randomisation tests: single switches, and a started environment."""

from dataclasses import replace
from typing import Any

from toy import toy_scene

from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.randomization import PRESETS, SWITCHES, Randomization

STRONG = replace(PRESETS["strong"], start_joints=0.08, start_move=0.01, start_turn=0.1)
OPTIONS = {"target": "cube_1", "goal": "bowl_1"}


def only(switch: str) -> Randomization:
    """Return the strong settings of a single switch."""
    return Randomization(**{name: getattr(STRONG, name) for name in SWITCHES[switch]})


def started(
    randomization: Any, seed: int = 0, **settings: Any
) -> tuple[TabletopEnv, Any, dict[str, Any]]:
    """Return an environment at the cube and the bowl, its first observation and the draws."""
    env = make_env(settings.pop("scene", toy_scene()), randomization=randomization, **settings)
    seen, info = env.reset(seed=seed, options=OPTIONS)
    return env, seen, info["randomization"]
