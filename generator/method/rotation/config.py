"""Settings of the rotation optimiser: the fast defaults and the settings of the paper."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from ...errors import InputError, require


@dataclass(frozen=True)
class RotationConfig:
    """Settings of the rotation optimiser.

    The defaults are for a CPU. ``paper()`` returns the values of Sec. 4.1; ``quick()`` returns
    settings that need a third of the work.

    Attributes:
        lambda_s, lambda_e, lambda_a: weights of Eq. 1.
        coarse_step: step of the coarse search over the full circle, radians.
        candidates: number of coarse angles that are refined.
        separation: minimum angle between two candidates, radians. If 0, the best angles are taken
            even if they are adjacent; a positive value keeps the opposite direction among the
            candidates.
        coarse_resolution, thinning: side of the crops, in pixels, in the coarse search and its
            refinement, in which only every ``thinning``-th point is drawn.
        coarse_steps: number of Adam steps at the coarse resolution; if 0, candidates are refined
            only at full resolution.
        rivals, rival, rival_steps: maximum number of candidates that are then refined at full
            resolution, their maximum relative loss above the best, and the number of steps.
        crowded: if the last candidate's loss is within this relative margin of the best, the
            candidates are selected again at full resolution instead of being refined coarsely; 0
            disables this.
        doubt, close_steps, close_resolution, close_points: rivals whose losses stay within the
            relative margin ``doubt`` of the best are refined once more, at a higher resolution; 0
            steps disable this.
        finalists, tie: maximum number of candidates that are finally refined by ``steps``, and
            their maximum relative loss above the best.
        resolution: side of the compared crops, pixels.
        points: number of surface points sampled per object.
        learning_rate: the step size of Adam, radians.
        steps: number of Adam steps at full resolution.
        decay: whether to decrease the step size to zero along a cosine, so that the descent ends
            exactly at the minimum.
        patience: number of steps without progress after which the descent stops; if 0, it never
            stops early.
        suspect, flat: an object whose coarse losses vary by less than the fraction ``suspect`` of
            the lowest may be rotationally symmetric. Its own renders are then compared with each
            other. If rotation adds less than ``flat`` to Eq. 1 between them, it keeps yaw 0. The
            same comparison finds rotations that leave an ambiguous object unchanged. 0 disables
            both.
        edge_unit: the distance that counts as 1 in Eq. 3, as a fraction of the crop's side.
        keep_aspect: whether to pad the tight crop to a square; if False, it is stretched, and its
            aspect ratio is lost.
        perspective: whether to view each object along its own ray; if False, all objects are viewed
            as if they were at the centre of the image.
        refine_camera: whether to adjust the camera's elevation, too, for each candidate, within
            ``max_tilt``.
        max_tilt: maximum change of the elevation, radians; if 0, it is not changed.
        refine_fit: whether to shift and scale the candidates of partially occluded objects as well,
            by at most ``max_fit`` of the crop's side, since their completed outlines are guesses.
            The search is then also started with the object extending beyond its box, at each side
            where it may be occluded. ``fit_cost`` is the loss added by a change of ``max_fit``.
        relight: whether to apply the picture's light, a linear function of the surface normal, to
            each render before Eq. 4 compares the two.
        unsure: weight of the pixels where another instance may occlude this one.
        device: torch device, "cpu" or "cuda". Only the CPU's results are reproducible bit for bit.
    """

    lambda_s: float = 0.5
    lambda_e: float = 0.5
    lambda_a: float = 2.0
    coarse_step: float = float(np.deg2rad(5.0))
    candidates: int = 8
    separation: float = float(np.deg2rad(15.0))
    coarse_resolution: int = 48
    thinning: int = 3
    coarse_steps: int = 12
    rivals: int = 8
    rival: float = 0.4
    rival_steps: int = 10
    crowded: float = 0.25
    doubt: float = 0.3
    close_steps: int = 6
    close_resolution: int = 112
    close_points: int = 20_000
    finalists: int = 3
    tie: float = 0.06
    resolution: int = 96
    points: int = 6000
    learning_rate: float = 3e-2
    steps: int = 16
    decay: bool = True
    patience: int = 12
    suspect: float = 0.4
    flat: float = 0.027
    edge_unit: float = 0.1
    keep_aspect: bool = True
    perspective: bool = True
    refine_camera: bool = True
    max_tilt: float = float(np.deg2rad(6.0))
    refine_fit: bool = True
    max_fit: float = 0.06
    fit_cost: float = 0.03
    relight: bool = True
    unsure: float = 0.2
    device: str = "cpu"

    def __post_init__(self) -> None:
        require(self, "lambda_s", "lambda_e", "lambda_a", "fit_cost", minimum=0)
        if not self.lambda_s + self.lambda_e + self.lambda_a > 0:
            raise InputError(
                "At least one of RotationConfig.lambda_s, lambda_e and lambda_a must be above 0."
            )
        require(self, "coarse_step", above=0, maximum=np.pi)
        require(self, "separation", minimum=0, maximum=np.pi)
        require(self, "candidates", "rivals", "finalists", "thinning", minimum=1, integer=True)
        require(self, "coarse_steps", "rival_steps", "close_steps", "steps", "patience",
                minimum=0, integer=True)  # fmt: skip
        require(
            self, "coarse_resolution", "resolution", "close_resolution", minimum=16, integer=True
        )
        require(self, "points", "close_points", minimum=100, integer=True)
        shares = ("rival", "crowded", "doubt", "tie", "suspect", "flat")
        require(self, *shares, minimum=0, allow_inf=True)
        require(self, "learning_rate", "edge_unit", above=0)
        require(self, "max_tilt", minimum=0, maximum=np.pi / 2)
        require(self, "max_fit", "unsure", minimum=0, maximum=1)
        if not re.fullmatch(r"cpu|cuda(:\d+)?", str(self.device)):
            raise InputError(
                f"RotationConfig.device must be 'cpu', 'cuda' or 'cuda:N', got {self.device!r}."
            )

    @classmethod
    def quick(cls) -> RotationConfig:
        """Return faster settings, with fewer candidates and no comparison at high resolution.

        If front and back hardly differ, they are confused more often; rotational symmetry is not
        detected.
        """
        return cls(
            coarse_step=float(np.deg2rad(10.0)),
            candidates=3,
            coarse_steps=10,
            thinning=4,
            rivals=2,
            rival_steps=0,
            close_steps=0,
            finalists=1,
            resolution=64,
            points=2500,
            steps=8,
            suspect=0.0,
            flat=0.0,
        )

    @classmethod
    def paper(cls) -> RotationConfig:
        """Return the paper's settings (Secs. 4.1, 6.1), which take minutes per object on a CPU."""
        return cls(
            separation=0.0,
            coarse_resolution=256,
            thinning=1,
            coarse_steps=0,
            rival_steps=0,
            crowded=0.0,
            finalists=8,
            tie=float("inf"),
            close_steps=0,
            resolution=256,
            points=40_000,
            steps=140,
            decay=False,
            patience=0,
            suspect=0.0,
            flat=0.0,
            keep_aspect=False,
            perspective=False,
            refine_camera=False,
            refine_fit=False,
            relight=False,
            unsure=1.0,
        )
