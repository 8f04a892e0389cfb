"""Gymnasium environments: a Franka Panda at generated tables.

Importing this package registers the environments and loads nothing heavy::

    gymnasium.make("tabletopgen_env:TabletopGen/PickPlace-v0", scenes="starter")
"""

from __future__ import annotations

import gymnasium

STEPS = {
    "Reach": 60,
    "Lift": 100,
    "Push": 120,
    "PickPlace": 200,
    "Stack": 200,
    "Swap": 500,
    "Sequence": 500,
    "Tidy": 700,
}
"""The time limit of each task, in steps of 50 ms."""

for _task, _steps in STEPS.items():
    gymnasium.register(
        id=f"TabletopGen/{_task}-v0",
        entry_point="tabletopgen_env.env:make_env",
        vector_entry_point="tabletopgen_env.parallel.vector:TabletopVectorEnv",
        kwargs={"task": _task},
        max_episode_steps=_steps,
        # The wrapper checks the first reset and step alone, as the tests of this package do in
        # every mode, and takes a reset that raises for the first: later steps would fail in it.
        disable_env_checker=True,
    )
