"""Settings of the joint refinement."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...errors import require


@dataclass(frozen=True)
class RefinementConfig:
    """Settings of the joint refinement.

    Attributes:
        steps: Adam's steps; 0 leaves everything as it is.
        learning_rate: Adam's first step, in units of the scales below; it falls to zero.
        turn, move, grow: how far yaw (radians), place (metres) and size (logarithm) usually are
            wrong; 0 leaves it as it is.
        resolution: side of the compared crops, pixels.
        points: surface points drawn per object.
        unsure: weight of pixels where another instance may hide this one.
    """

    steps: int = 40
    learning_rate: float = 0.15
    turn: float = float(np.deg2rad(3.0))
    move: float = 0.015
    grow: float = 0.04
    resolution: int = 64
    points: int = 2500
    unsure: float = 0.2

    def __post_init__(self) -> None:
        require(self, "steps", minimum=0, integer=True)
        require(self, "learning_rate", above=0)
        require(self, "turn", "move", "grow", minimum=0)
        require(self, "resolution", minimum=16, integer=True)
        require(self, "points", minimum=100, integer=True)
        require(self, "unsure", minimum=0, maximum=1)
