"""Gymnasium environments with a Franka Panda at generated tables.

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
        # The passive checker checks only the first reset and step, which the tests of this package
        # do in every mode. It also counts a reset that raises as the first, so later steps would
        # fail.
        disable_env_checker=True,
    )
