"""Settings of a recording."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, get_args

from tyro.conf import Suppress

from generator.errors import (
    InputError,
    choices,
    require,
    require_known,
    require_number,
    require_seed,
)

from ..rendering.config import PRESETS, CameraName, CameraPreset
from ..rendering.kinds import Kind
from ..tasks.names import NAMES

if TYPE_CHECKING:
    import gymnasium as gym

Format = Literal["minari", "hdf5", "npz", "robomimic", "lerobot"]
FORMATS: tuple[Format, ...] = get_args(Format)

EXPERT = "tabletopgen_env.expert.run.TaskExpert"
"""The player that ``record`` uses."""

PictureMode = Literal["pixels+state", "pixels+proprio"]

VideoCodec = Literal["h264", "hevc", "av1", "none"]
VIDEO_CODECS: tuple[VideoCodec, ...] = get_args(VideoCodec)


@dataclass(frozen=True)
class LeRobotConfig:
    """Settings of a LeRobot dataset.

    Attributes:
        video: Codec of the colour pictures, which must have even sizes; "none" stores every picture
            lossless, as PNG in the tables (depth as TIFF).
        quality: Constant rate factor of the codec: lower is better and larger. None uses 18 (h264,
            hevc) or 25 (av1).
        privileged: Store the entries of the flat state that no robot measures, as
            ``observation.environment_state``, which LeRobot's policies use as an input if it
            exists. None stores them only without pictures.
    """

    video: VideoCodec = "h264"
    quality: int | None = None
    privileged: bool | None = None

    def check(self) -> None:
        """Check the settings.

        Raises:
            InputError: the codec is unknown, or the quality is out of range.
        """
        require_known(self.video, VIDEO_CODECS, "Unknown video codec")
        if self.quality is not None:
            require_number("quality", self.quality, minimum=0, maximum=51, integer=True)


@dataclass(frozen=True)
class RecordConfig:
    """Settings of a recording; equal settings give equal arrays.

    Attributes:
        task: A task's name or id: "PickPlace" or "TabletopGen/PickPlace-v0".
        preset: For the task Sequence: "kitchen" or "coffee_table".
        scenes: Source of the tables: bundles by name, digest, path or glob, "starter",
            "starter:train", "fresh", "fresh:PROMPT" ...; by default the task's own.
        episodes: Number of episodes to keep.
        seed: Seed of all episodes.
        cameras: Cameras of the pictures: some of "front", "wrist", "top" and "side", or a preset
            ("maniskill", "droid"); none for the state only.
        kinds: Pictures of each camera: some of "rgb", "depth" and "segmentation".
        image_size: Height and width of the pictures, pixels; None is the preset's size, or 128.
        observation: Observations besides pictures: the flat state ("pixels+state"), or only what a
            real robot has, its own joints and the instruction ("pixels+proprio").
        noise: Standard deviation of the noise added to the expert's motion, relative to its maximum
            speed, so that the data covers recovery.
        randomization: "starts" perturbs the arm slightly and the objects by some centimetres, as
            certify does; "light" and "strong" vary more. With None nothing is randomised, and all
            episodes with the same scene, target and goal are identical.
        keep_failures: Also keep episodes that the expert does not solve.
        player: Name of the player in the dataset; not an option of the command.
    """

    task: str = "PickPlace"
    preset: str | None = None
    scenes: tuple[str, ...] = ()
    episodes: int = 10
    seed: int = 0
    cameras: tuple[CameraName | CameraPreset, ...] = ()
    kinds: tuple[Kind, ...] = ("rgb",)
    image_size: int | None = None
    observation: PictureMode = "pixels+state"
    noise: float = 0.0
    randomization: str | None = "starts"
    keep_failures: bool = False
    player: Suppress[str] = EXPERT

    @property
    def name(self) -> str:
        """The name of the task, without the other parts of its id."""
        return self.task.rpartition("/")[2].removesuffix("-v0")

    def check(self) -> None:
        """Check the settings that can be checked without a scene.

        Raises:
            InputError: the task is unknown, or a number is out of range.
        """
        if self.name not in NAMES:
            raise InputError(f"Unknown task {self.task!r}." + choices(self.name, NAMES))
        require(self, "episodes", minimum=1, integer=True)
        require_seed(self.seed, 2**31 - 1)
        require_known(self.observation, get_args(PictureMode), "Unknown observation")
        require(self, "noise", minimum=0)

    @property
    def keywords(self) -> dict[str, Any]:
        """The keyword arguments of the recorded environment."""
        scenes = self.scenes[0] if len(self.scenes) == 1 else list(self.scenes)
        given = {"scenes": scenes or None, "preset": self.preset,
                 "randomization": self.randomization}  # fmt: skip
        settings: dict[str, Any] = {name: v for name, v in given.items() if v is not None}
        if self.cameras:
            preset = len(self.cameras) == 1 and self.cameras[0] in PRESETS
            settings |= {"observation": self.observation, "kinds": list(self.kinds),
                         "cameras": self.cameras[0] if preset else list(self.cameras),
                         "image_size": self.image_size}  # fmt: skip
        return settings

    def environment(self) -> gym.Env[Any, Any]:
        """Create the environment for the recording; its spec can recreate an equal environment.

        Raises:
            InputError: a setting is invalid.
            BundleError: no bundle matches the scenes.
        """
        import gymnasium as gym

        return gym.make(f"tabletopgen_env:TabletopGen/{self.name}-v0", **self.keywords)
