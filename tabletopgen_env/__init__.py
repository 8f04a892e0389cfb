"""Gymnasium environments: a Franka Panda at generated tables.

Importing this package registers the environments and loads nothing heavy::

    gymnasium.make("tabletopgen_env:TabletopGen/PickPlace-v0", scenes="starter")
"""

from __future__ import annotations

import gymnasium

gymnasium.register(
    id="TabletopGen/PickPlace-v0",
    entry_point="tabletopgen_env.env:make_env",
    max_episode_steps=200,
)
