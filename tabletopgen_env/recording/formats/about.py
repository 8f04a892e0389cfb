"""The metadata of a dataset."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

import gymnasium as gym

from generator.scene.provenance import versions

from ..config import EXPERT, RecordConfig

_VERSIONS = ("tabletopgen", "mujoco", "gymnasium", "numpy")
_OF_EXPERT = ("episodes", "noise", "keep_failures")  # settings ignored by other players


def describe_dataset(config: RecordConfig, env: gym.Env[Any, Any]) -> dict[str, Any]:
    """Return the environment, player, settings, control rate and versions as JSON values.

    Only the settings that had an effect are included; settings in ``env`` override those in
    ``config``.
    """
    assert env.spec is not None
    meaningless = {"player"} if config.player == EXPERT else {"player", *_OF_EXPERT}
    settings = {name: v for name, v in asdict(config).items() if name not in meaningless}
    asked, made = config.keywords, env.spec.kwargs
    settings |= {name: made.get(name) for name in settings if made.get(name) != asked.get(name)}
    return {
        "environment": json.loads(env.spec.to_json()),
        "player": config.player,
        "fps": env.metadata["render_fps"],
        "settings": settings,
        "versions": versions(_VERSIONS),
    }
