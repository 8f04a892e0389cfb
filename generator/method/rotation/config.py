"""Settings of the rotation optimiser: fast defaults, and the settings of the paper."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from ...errors import InputError, require


@dataclass(frozen=True)
class RotationConfig:
    """Settings of the rotation optimiser.

    The defaults are for a CPU; ``paper()`` gives the values of Sec. 4.1, ``quick()`` a third of the
    work.

    Attributes:
        lambda_s, lambda_e, lambda_a: weights of Eq. 1.
        coarse_step: step of the coarse search over the full circle, radians.
        candidates: number of coarse angles that are refined.
        separation: minimum angle between two candidates, radians; 0 takes the best angles even if
            they are adjacent. A positive value keeps the opposite direction among the candidates.
        coarse_resolution, thinning: side of the crops in the coarse search and its refinement,
            pixels; only every ``thinning``-th point is drawn.
        coarse_steps: Adam's steps at the coarse resolution; 0 refines at full resolution only.
        rivals, rival, rival_steps: maximum number of candidates, within the relative loss ``rival``
            of the best, that are then refined at full resolution, and the number of steps.
        crowded: if the last candidate's loss is within this relative margin of the best, the
            candidates are selected again at full resolution and not refined coarsely; 0 disables
            this.
        doubt, close_steps, close_resolution, close_points: rivals whose losses stay within the
            relative margin ``doubt`` of the best are refined once more, at a higher resolution; 0
            steps disable this.
        finalists, tie: maximum number of candidates, within the relative loss ``tie`` of the best,
            that are then refined by ``steps``.
        resolution: side of the compared crops, pixels.
        points: surface points sampled per object.
        learning_rate: Adam's step, radians.
        steps: Adam's steps at full resolution.
        decay: decrease the step to zero along a cosine, which ends exactly at the minimum.
        patience: stop after this many steps without progress; 0 never stops early.
        suspect, flat: an object whose coarse losses vary by less than the share ``suspect`` of the
            lowest may be rotationally symmetric. Its own renders are then compared with each other;
            if rotation adds less than ``flat`` to Eq. 1 between them, it keeps yaw 0. The same
            comparison finds rotations that leave an ambiguous object unchanged. 0 disables both.
        edge_unit: the distance that counts as 1 in Eq. 3, as a share of the crop's side.
        keep_aspect: pad the tight crop to a square; False stretches it, which drops the aspect.
        perspective: view each object along its own ray; False views all objects as if they stood at
            the image centre.
        refine_camera: also adjust the camera's elevation per candidate, within ``max_tilt``.
        max_tilt: maximum change of elevation, radians; 0 changes none.
        refine_fit: also shift and scale the candidates of partially occluded objects, by at most
            ``max_fit`` of the crop's side, since their completed outlines are guesses. The search
            then also starts with the object extending beyond each side of its box where it may be
            occluded. ``fit_cost`` is the loss added by a change of ``max_fit``.
        relight: apply the picture's light, a linear function of the surface normal, to each render
            before Eq. 4 compares the two.
        unsure: weight of pixels where another instance may occlude this one.
        device: torch device, "cpu" or "cuda". Only the CPU is reproducible bit for bit.
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
            raise InputError("RotationConfig needs one of lambda_s, lambda_e and lambda_a above 0.")
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
                f"RotationConfig needs device 'cpu', 'cuda' or 'cuda:N', got {self.device!r}."
            )

    @classmethod
    def quick(cls) -> RotationConfig:
        """Return settings with fewer candidates and no high-resolution comparison of similar ones.

        Front and back are confused more often if they hardly differ, and rotational symmetry is not
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
        """Return the settings of Secs. 4.1 and 6.1, which take minutes per object on a CPU."""
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
