"""All settings of an environment except scenes and task."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, get_args

import numpy as np

from generator.errors import InputError, require_known

from ..actions import ActionConfig
from ..randomization import Randomization
from ..rendering.config import ObservationConfig, RenderConfig
from ..world.worlds import WorldConfig

RewardMode = Literal["dense", "sparse"]

InfoKind = Literal["all", "numbers"]


@dataclass(frozen=True)
class EnvConfig:
    """Settings of an environment.

    Args:
        observation: the observation.
        action: the action space.
        render: the pictures of ``render``, and the renderer.
        worlds: the robot, and the cache of compiled worlds.
        reward: "dense" (named terms, in [0, 1], 1 exactly on success) or "sparse" (0 on success,
            -1 otherwise).
        randomization: variation between episodes of the same scene, target and goal: a
            ``Randomization``; "starts" for small offsets of the arm's joints and of the objects
            within free space; "light" or "strong" for everything else; or None for identical
            starts; see ``randomization``.
        certified: for bundles with a certificate (see ``certificates.certify``), draw targets and
            goals only from the instances of the task that the expert solved; False ignores
            certificates.
        infos: content of ``info``: "all", or "numbers" for numeric entries only, for libraries that
            read infos as arrays.

    Raises:
        InputError: the reward or infos setting is unknown, or ``certified`` is not a bool.
    """

    observation: ObservationConfig = field(default_factory=ObservationConfig)
    action: ActionConfig = field(default_factory=ActionConfig)
    render: RenderConfig = field(default_factory=RenderConfig)
    worlds: WorldConfig = field(default_factory=WorldConfig)
    reward: RewardMode = "dense"
    randomization: Randomization | str | None = None
    certified: bool = True
    infos: InfoKind = "all"

    def __post_init__(self) -> None:
        require_known(self.reward, get_args(RewardMode), "Unknown reward")
        require_known(self.infos, get_args(InfoKind), "Unknown infos")
        if not isinstance(self.certified, bool | np.bool_):
            raise InputError(f"certified must be True or False, got {self.certified!r}.")
