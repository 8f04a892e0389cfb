"""What a dataset says of itself."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

import gymnasium as gym

from generator.scene.provenance import versions

from ..config import RecordConfig

_VERSIONS = ("tabletopgen", "mujoco", "gymnasium", "numpy")


def describe_dataset(config: RecordConfig, env: gym.Env[Any, Any]) -> dict[str, Any]:
    """Return environment, player, settings, control rate and versions, as JSON values."""
    assert env.spec is not None
    return {
        "environment": json.loads(env.spec.to_json()),
        "player": config.player,
        "fps": env.metadata["render_fps"],
        "settings": {name: v for name, v in asdict(config).items() if name != "player"},
        "versions": versions(_VERSIONS),
    }
