"""What to record."""

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
"""The player of ``record``."""

PictureMode = Literal["pixels+state", "pixels+proprio"]

VideoCodec = Literal["h264", "hevc", "av1", "none"]
VIDEO_CODECS: tuple[VideoCodec, ...] = get_args(VideoCodec)


@dataclass(frozen=True)
class LeRobotConfig:
    """How a LeRobot dataset holds what was recorded.

    Attributes:
        video: Codec of the colour pictures, whose sides must be even then; "none" keeps every
            picture to the bit, as PNG in the tables (depth as TIFF).
        quality: Constant rate factor of the codec: lower is better and larger. None takes 18
            (h264, hevc) or 25 (av1).
        privileged: Keep the entries of the flat state that no robot measures, as
            ``observation.environment_state``, which policies of LeRobot read where it is. None
            keeps them where there are no pictures.
    """

    video: VideoCodec = "h264"
    quality: int | None = None
    privileged: bool | None = None

    def check(self) -> None:
        """Check the settings.

        Raises:
            InputError: an unknown codec, or a quality out of range.
        """
        require_known(self.video, VIDEO_CODECS, "Unknown video codec")
        if self.quality is not None:
            require_number("quality", self.quality, minimum=0, maximum=51, integer=True)


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
        cameras: What pictures are taken with: some of "front", "wrist", "top" and "side", or a
            preset ("maniskill", "droid"); none for the state alone.
        kinds: What each camera takes: some of "rgb", "depth" and "segmentation".
        image_size: Height and width of the pictures, pixels; None is the preset's, else 128.
        observation: What there is beside pictures: the flat state ("pixels+state"), or only what a
            real robot has, its own joints and the instruction ("pixels+proprio").
        noise: Standard deviation of what is added to the expert's motion, as a share of its
            greatest speed, so that it shows how to come back.
        randomization: "starts" puts the arm a little off and the things some centimetres, as
            certify does; "light" and "strong" vary more. With None nothing is
            randomised, and episodes of the same scene, target and goal are all the same.
        keep_failures: Keep episodes too that the expert does not solve.
        player: Who plays, as the dataset names it; no setting of the command.
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
        require_known(self.observation, get_args(PictureMode), "Unknown observation")
        require(self, "noise", minimum=0)

    @property
    def keywords(self) -> dict[str, Any]:
        """The keywords of the environment to record in."""
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
        """Return the environment to record in; its spec makes the same one again.

        Raises:
            InputError: a setting is wrong.
            BundleError: no bundle fits the scenes.
        """
        import gymnasium as gym

        return gym.make(f"tabletopgen_env:TabletopGen/{self.name}-v0", **self.keywords)
