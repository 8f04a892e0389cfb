"""All settings of an environment but its scenes and its task."""

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
    """How a task is played.

    Args:
        observation: what a policy sees.
        action: how it moves the robot.
        render: what ``render`` returns, and what draws.
        worlds: the robot, and how many compiled worlds are kept.
        reward: "dense" (named terms, in [0, 1], 1 exactly on success) or "sparse" (0 on success,
            -1 otherwise).
        randomization: what differs between episodes of the same scene, target and goal, which
            without it all start alike: a ``Randomization``, "starts" for the arm a little off and
            the things some centimetres, within free space, "light" or "strong" for everything
            else, or None for nothing; see ``randomization``.
        certified: at a bundle with a certificate (see ``certificates.certify``), draw targets and
            goals only among the instances of the task that the expert solved; False ignores
            certificates.
        infos: what ``info`` holds: "all", or "numbers", which leaves only the entries that are
            numbers, for libraries that read infos as arrays.

    Raises:
        InputError: an unknown reward or kind of infos, or ``certified`` is no bool.
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
