"""What to record."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, get_args

from generator.errors import InputError, choices, require, require_seed

from ..rendering.config import CameraName
from ..rendering.kinds import Kind
from ..tasks.names import NAMES

if TYPE_CHECKING:
    import gymnasium as gym

Format = Literal["minari", "hdf5", "npz"]
FORMATS: tuple[Format, ...] = get_args(Format)


@dataclass(frozen=True)
class RecordConfig:
    """What to record; equal settings give equal arrays.

    Attributes:
        task: A task's name or id: "PickPlace" or "TabletopGen/PickPlace-v0".
        preset: With the task Sequence: "kitchen" or "coffee_table".
        scenes: Where tables come from: bundles by name, digest, path or glob, "starter",
            "starter:train", "fresh", "fresh:PROMPT" ...; left out, the task's own.
        episodes: How many to keep.
        seed: Of all episodes.
        cameras: What pictures are taken with: some of "front", "wrist" and "top"; none for the
            state alone.
        kinds: What each camera takes: some of "rgb", "depth" and "segmentation".
        image_size: Height and width of the pictures, pixels.
        noise: Standard deviation of what is added to the expert's motion, as a share of its
            greatest speed, so that it shows how to come back.
        randomization: "starts" puts the arm a little off and the things some centimetres, as
            certify does; "light" and "strong" vary more. With None nothing is
            randomised, and episodes of the same scene, target and goal are all the same.
        keep_failures: Keep episodes too that the expert does not solve.
    """

    task: str = "PickPlace"
    preset: str | None = None
    scenes: tuple[str, ...] = ()
    episodes: int = 10
    seed: int = 0
    cameras: tuple[CameraName, ...] = ()
    kinds: tuple[Kind, ...] = ("rgb",)
    image_size: int = 128
    noise: float = 0.0
    randomization: str | None = "starts"
    keep_failures: bool = False

    @property
    def name(self) -> str:
        """The task's name, without what else an id has."""
        return self.task.rpartition("/")[2].removesuffix("-v0")

    def check(self) -> None:
        """Check what can be checked without a scene.

        Raises:
            InputError: an unknown task, or a number out of range.
        """
        if self.name not in NAMES:
            raise InputError(f"Unknown task {self.task!r}." + choices(self.name, NAMES))
        require(self, "episodes", minimum=1, integer=True)
        require_seed(self.seed, 2**31 - 1)
        require(self, "noise", minimum=0)

    def environment(self) -> gym.Env[Any, Any]:
        """Return the environment to record in; its spec makes the same one again.

        Raises:
            InputError: a setting is wrong.
            BundleError: no bundle fits the scenes.
        """
        import gymnasium as gym

        scenes = self.scenes[0] if len(self.scenes) == 1 else list(self.scenes)
        given = {"scenes": scenes or None, "preset": self.preset,
                 "randomization": self.randomization}  # fmt: skip
        settings: dict[str, Any] = {name: v for name, v in given.items() if v is not None}
        if self.cameras:
            settings |= {"observation": "pixels+state", "cameras": list(self.cameras),
                         "kinds": list(self.kinds), "image_size": self.image_size}  # fmt: skip
        return gym.make(f"tabletopgen_env:TabletopGen/{self.name}-v0", **settings)
