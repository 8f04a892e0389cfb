"""Videos: encoding of an episode's pictures, and concatenation without re-encoding."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import UInt8, UInt16

from generator.errors import InputError

from ..config import VideoCodec

if TYPE_CHECKING:
    import av

GOP = 2
"""Interval between key frames, in frames: as in LeRobot, for fast seeking."""
_NONE: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class Codec:
    """Settings of an encoder that is deterministic for any number of cores.

    Attributes:
        name: name of the format, as reported by decoders.
        encoder: name of the encoder in the library.
        pixels: pixel format.
        quality: default constant rate factor; None for a lossless codec.
        options: options of the encoder.
    """

    name: str
    encoder: str
    pixels: str
    quality: int | None
    options: Mapping[str, str] = field(default_factory=lambda: _NONE)


# With open GOPs, seeking would lose the first pictures after a joint.
_X265 = "pools=none:frame-threads=1:bframes=0:open-gop=0:log-level=error"
CODECS: Mapping[str, Codec] = MappingProxyType(
    {
        "h264": Codec("h264", "libx264", "yuv420p", 18, {"preset": "veryfast", "bf": "0"}),
        "hevc": Codec(
            "hevc", "libx265", "yuv420p", 18, {"preset": "ultrafast", "x265-params": _X265}
        ),
        "av1": Codec(
            "av1",
            "libsvtav1",
            "yuv420p",
            25,
            {"preset": "10", "svtav1-params": "lp=1:pred-struct=1"},
        ),
    }
)
"""The codecs of colour pictures, by their name in ``LeRobotConfig``."""

DEPTH_CODEC = Codec(
    "hevc", "libx265", "gray12le", None,
    {"preset": "superfast", "x265-params": _X265 + ":lossless=1"},
)  # fmt: skip
"""The codec of 12-bit depth pictures."""


def check_codec(video: VideoCodec) -> None:
    """Check that the installed PyAV supports a codec.

    Raises:
        InputError: it does not.
    """
    import av.codec

    wanted = CODECS[video]
    available = {name for name, codec in CODECS.items() if codec.encoder in _encoders()}
    if video not in available:
        there = ", ".join(sorted(available)) or "none of the codecs"
        raise InputError(
            f"The installed av {av.__version__} has no {wanted.encoder}, which video={video!r} "
            f"needs; available: {there}. Choose one with --video, or --video none for PNG."
        )


def _encoders() -> set[str]:
    import av.codec

    return {*av.codec.codecs_available}


def encode(
    pictures: Iterable[UInt8[np.ndarray, "h w 3"] | UInt16[np.ndarray, "h w"]],
    path: Path,
    fps: int,
    codec: Codec,
    quality: int | None = None,
) -> None:
    """Write pictures of equal size, with even height and width, as an MP4 file.

    Raises:
        OSError: the file cannot be written.
    """
    import av

    options = {"g": str(GOP), **codec.options}
    if codec.quality is not None:
        options["crf"] = str(codec.quality if quality is None else quality)
    schedule = _schedule()
    with _quiet(), av.open(str(path), "w", format="mp4") as file:
        stream: Any = None
        for number, picture in enumerate(pictures):
            if stream is None:
                stream = file.add_stream(codec.encoder, fps, options=options)
                stream.height, stream.width = picture.shape[:2]
                stream.pix_fmt, stream.time_base = codec.pixels, Fraction(1, fps)
                stream.codec_context.thread_count = 1
            frame = _frame(picture, codec)
            frame.pts, frame.time_base = number, Fraction(1, fps)
            _mux(file, stream.encode(frame), fps)
            if number == 0:  # the first frame opens the encoder
                _keep_schedule(schedule)
        _mux(file, stream.encode(), fps)


@contextmanager
def _quiet() -> Iterator[None]:
    """Make the AV1 encoder print only errors, by setting an environment variable."""
    before = os.environ.get("SVT_LOG")
    os.environ["SVT_LOG"] = before or "1"
    try:
        yield
    finally:
        if before is None:
            del os.environ["SVT_LOG"]


def _schedule() -> Any:
    """Return the scheduling policy of this thread, if the system provides it."""
    if not hasattr(os, "sched_getscheduler"):
        return None
    return os.sched_getscheduler(0), os.sched_getparam(0)


def _keep_schedule(schedule: Any) -> None:
    """Restore this thread's scheduling, which the AV1 encoder makes real-time where permitted."""
    if schedule is not None and schedule != _schedule():
        os.sched_setscheduler(0, *schedule)


def _frame(picture: np.ndarray, codec: Codec) -> av.VideoFrame:
    import av

    plain = np.ascontiguousarray(picture)
    return av.VideoFrame.from_ndarray(plain, format="rgb24" if plain.ndim == 3 else codec.pixels)


def _mux(file: Any, packets: Sequence[Any], fps: int) -> None:
    """Write packets with a duration of one frame each, including the last packet of a file."""
    for packet in packets:
        packet.duration = round(1 / (fps * packet.time_base))
        file.mux(packet)


def join(parts: Sequence[Path], path: Path, fps: int) -> None:
    """Concatenate videos with equal settings.

    Raises:
        OSError: a file cannot be read or written.
    """
    import av

    with av.open(str(path), "w", format="mp4", options={"movflags": "faststart"}) as file:
        stream: Any = None
        shown = 0  # frames
        for part in parts:
            with av.open(str(part)) as source:
                video = source.streams.video[0]
                if stream is None:
                    stream = file.add_stream_from_template(video, opaque=True)
                    stream.time_base = video.time_base
                for packet in source.demux(video):
                    if packet.dts is None:  # the end
                        continue
                    lasts = round(1 / (fps * packet.time_base))
                    # decoding and display order are the same
                    packet.pts = packet.dts = shown * lasts
                    packet.stream = stream
                    file.mux(packet)
                    shown += 1


def decode(path: Path, pixels: str = "rgb24") -> Iterator[np.ndarray]:
    """Yield the pictures of a video.

    Raises:
        OSError: the file cannot be read.
    """
    import av

    with av.open(str(path)) as file:
        for frame in file.decode(video=0):
            yield frame.to_ndarray(format=pixels)
