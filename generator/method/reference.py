"""Reference images (Sec. 3, Fig. 8): a text is planned and drawn; a picture is used directly."""

from __future__ import annotations

import hashlib
import os
import threading
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, UInt8

from ..backends.protocols import Imager, Reasoner
from ..errors import InputError
from ..io.bounded import read_regular
from ..pictures import DecodedPicture, PictureLimits, decode
from ..scene import Intrinsics, Reference, ScenePlan

Source = str | Path | bytes | ScenePlan | np.ndarray
"""A prompt, a plan, or a picture: a path, encoded bytes or an (h, w, 3 or 4) uint8 array."""

DepthSource = str | Path | bytes | np.ndarray
"""A depth map of the same size as the picture: an array in metres (float) or millimetres (uint16),
or a 16-bit PNG in millimetres (a path or bytes). 0, NaN and infinity mean unknown."""


@dataclass(frozen=True)
class ReferenceConfig:
    """Limits for pictures: sides in pixels, file size in bytes and longest side after resizing.

    ``max_ratio`` is the maximum ratio of the longer side to the shorter one, ``max_depth`` is the
    maximum median of a depth map, metres, and ``min_known`` is the minimum fraction of its pixels
    with a known depth.
    """

    min_side: int = 64
    max_ratio: float = 8.0
    max_pixels: int = 25_000_000
    max_bytes: int = 50_000_000
    work_side: int = 1280
    max_depth: float = 30.0
    min_known: float = 0.1

    @property
    def picture_limits(self) -> PictureLimits:
        """The limits against which a picture's header is checked."""
        return PictureLimits(
            max_bytes=self.max_bytes, max_pixels=self.max_pixels, min_side=self.min_side,
            max_ratio=self.max_ratio,
        )  # fmt: skip


def refer(
    source: Source,
    reasoner: Reasoner,
    imager: Imager,
    seed: int,
    config: ReferenceConfig | None = None,
    *,
    depth: DepthSource | None = None,
    intrinsics: Intrinsics | None = None,
) -> Reference:
    """Return the reference image I_ref of ``source``, with its prompt and plan if it was a text.

    A string is a text unless it names an existing file or ends with the suffix of a picture file.
    Pictures are rotated by their EXIF orientation, flattened onto white, and shrunk to
    ``work_side``; a ``depth`` map and the ``intrinsics`` of the original picture are shrunk with
    it.

    Raises:
        InputError: the text is empty; the picture is missing, broken, too small or too large; the
            depth map has no intrinsics, another size, or no known values.
    """
    config = config or ReferenceConfig()
    if depth is not None or intrinsics is not None:
        return _refer_depth(source, depth, intrinsics, config)
    if isinstance(source, str) and not is_picture_name(source):
        plan = reasoner.plan_scene(source, seed)
        return Reference(imager.draw(plan, seed), source, plan)
    if isinstance(source, ScenePlan):
        if not source.objects:
            raise InputError("The plan contains no objects; a scene must have at least one.")
        return Reference(imager.draw(source, seed), source.prompt, source)
    return Reference(read_image(source, config))


def is_picture_name(text: str) -> bool:
    """Return whether a string is the name of a picture file and not a description."""
    if "\n" in text or len(text) > 1024 or not text.strip():
        return False
    suffixes = {
        ".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif", ".tiff", ".gif",
        ".heic", ".heif", ".avif",
    }  # fmt: skip
    path = Path(text)
    try:
        if path.suffix.lower() in suffixes:
            return True
        return " " not in text.strip() and (path.is_file() or ("/" in text and path.is_dir()))
    except OSError:
        return False


def read_image(
    source: str | Path | bytes | np.ndarray,
    config: ReferenceConfig | None = None,
    cancelled: threading.Event | None = None,
) -> UInt8[np.ndarray, "h w 3"]:
    """Decode a picture into upright sRGB on white, at most ``config.work_side`` pixels long.

    A file is decoded in a child process (see ``generator.pictures``). Another thread can terminate
    this process by setting ``cancelled``.

    Raises:
        InputError: the picture is missing, broken, or exceeds a limit of ``config``.
    """
    return _decode(source, config or ReferenceConfig(), cancelled).pixels


def _decode(
    source: str | Path | bytes | np.ndarray,
    config: ReferenceConfig,
    cancelled: threading.Event | None = None,
) -> DecodedPicture:
    """Return an upright picture in sRGB on white, at most ``config.work_side`` pixels long."""
    limits, what = config.picture_limits, "The picture"
    if not isinstance(source, np.ndarray):
        raw = _read_bytes(source, config)
        return decode(raw, what, InputError, limits, "upright", config.work_side, cancelled)
    from PIL import Image

    from ..pictures.pixels import upright

    picture = Image.fromarray(_as_uint8(source))
    limits.check_size(*picture.size, what, InputError)
    return DecodedPicture(upright(picture, config.work_side), picture.mode, *picture.size)


# ----------------------------------------------------------------------------------------- RGB-D


def _refer_depth(
    source: Source,
    depth: DepthSource | None,
    intrinsics: Intrinsics | None,
    config: ReferenceConfig,
) -> Reference:
    if isinstance(source, ScenePlan) or (isinstance(source, str) and not is_picture_name(source)):
        raise InputError(
            "Depth and intrinsics can only be given with a picture, not with a prompt or a plan."
        )
    if depth is None or intrinsics is None:
        missing = "depth map" if depth is None else "intrinsics (fx, fy, cx, cy in pixels)"
        raise InputError(
            f"An RGB-D picture also needs its {missing}. Pass both depth and intrinsics, or "
            "neither."
        )
    picture = _decode(source, config)
    if picture.orientation != 1:
        raise InputError(
            "The picture is stored rotated (EXIF orientation), so depth and intrinsics may not "
            "match it. Save the picture upright first."
        )
    size = picture.width, picture.height
    _check_intrinsics(intrinsics, *size)
    metres = read_depth(depth, size, config)
    image = picture.pixels
    height, width = image.shape[:2]
    lines = (height, size[1]), (width, size[0])
    places: list[np.ndarray] = [(np.arange(new) + 0.5) * old / new for new, old in lines]
    nearest = np.ix_(*(p.astype(int) for p in places))  # interpolation would create false surfaces
    scaled = intrinsics.scale(width / size[0], height / size[1])
    return Reference(image, depth=metres[nearest], intrinsics=scaled)


def read_depth(
    source: DepthSource, size: tuple[int, int], config: ReferenceConfig
) -> Float[np.ndarray, "h w"]:
    """Return a depth map of ``size`` (width, height) in metres, with 0 where it is unknown.

    Raises:
        InputError: the map is not a depth map, has another size, has negative or too few known
            values, or is not in the units of ``DepthSource``.
    """
    raw = source if isinstance(source, np.ndarray) else _decode_depth(source, config)
    if raw.shape != (size[1], size[0]):
        raise InputError(
            f"The depth map has shape {raw.shape}, but the picture is {size[0]}x{size[1]}. Pass a "
            f"map of shape {(size[1], size[0])}, aligned with the picture."
        )
    if raw.dtype != np.uint16 and not np.issubdtype(raw.dtype, np.floating):
        raise InputError(
            f"A depth array must be float (metres) or uint16 (millimetres), got {raw.dtype}."
        )
    metres = raw.astype(np.float32) * (1e-3 if raw.dtype == np.uint16 else 1.0)
    metres = np.where(np.isfinite(metres), metres, 0).astype(np.float32)
    if metres.min() < 0:
        raise InputError("The depth map must not contain negative distances; 0 means unknown.")
    known = metres > 0
    if known.mean() < config.min_known:
        raise InputError(
            f"Only {known.mean():.0%} of the depth map is known (not 0); the minimum is "
            f"{config.min_known:.0%}."
        )
    middle = float(np.median(metres[known]))
    if not 0.05 < middle < config.max_depth:
        raise InputError(
            f"The depth map's median is {middle:g} m; a tabletop is between 0.05 and "
            f"{config.max_depth:g} m away. Float arrays are in metres, 16-bit PNGs in millimetres."
        )
    return metres


def _decode_depth(source: str | Path | bytes, config: ReferenceConfig) -> np.ndarray:
    raw = _read_bytes(source, config, "depth map")
    picture = decode(raw, "The depth map", InputError, config.picture_limits, "stored")
    if not picture.mode.startswith("I"):
        raise InputError(
            "A depth file must be a 16-bit grey PNG in millimetres; this picture has mode "
            f"{picture.mode!r}."
        )
    return picture.pixels.clip(0, 65535).astype(np.uint16)


def _check_intrinsics(intrinsics: Intrinsics, width: int, height: int) -> None:
    i = intrinsics
    if not (0 <= i.cx < width and 0 <= i.cy < height):
        raise InputError(
            f"The principal point ({i.cx:g}, {i.cy:g}) is outside the {width}x{height} picture. "
            "Intrinsics are fx, fy, cx, cy in the picture's own pixels."
        )
    if abs(np.log(i.fx / i.fy)) > _SQUARE:
        raise InputError(
            f"Pixels must be square: fx {i.fx:g} and fy {i.fy:g} differ by more than "
            f"{_SQUARE:.0%}. Resample the picture and the depth map first."
        )
    if not width / 20 < i.fx < width * 20:
        raise InputError(
            f"A focal length of {i.fx:g} pixels cannot belong to a {width}x{height} picture."
        )


_SQUARE = 0.03  # maximum relative difference between fx and fy


# ----------------------------------------------------------------------------------------- files


def fetch(source: Source, config: ReferenceConfig | None = None) -> Source:
    """Return the bytes of a picture file, read once; any other source is returned unchanged.

    Raises:
        InputError: the file does not exist, is too large or is unreadable.
    """
    if isinstance(source, Path) or (isinstance(source, str) and is_picture_name(source)):
        return _read_bytes(source, config or ReferenceConfig())
    return source


def source_digest(source: Source) -> str | None:
    """Return the sha256 of the bytes of a picture or depth map, or None for a text or a plan."""
    if isinstance(source, np.ndarray):
        return hashlib.sha256(np.ascontiguousarray(source).tobytes()).hexdigest()
    return hashlib.sha256(source).hexdigest() if isinstance(source, bytes) else None


def fetch_depth(
    source: DepthSource | None, config: ReferenceConfig | None = None
) -> np.ndarray | bytes | None:
    """Return the bytes of a depth file, read once; an array or None is returned unchanged.

    Raises:
        InputError: the file does not exist, is too large or is unreadable.
    """
    if source is None or isinstance(source, np.ndarray):
        return source
    return _read_bytes(source, config or ReferenceConfig(), "depth map")


def _read_bytes(source: object, config: ReferenceConfig, what: str = "picture") -> bytes:
    data = source
    if isinstance(source, str | Path):
        if not os.path.lexists(source):
            hint = " Pass a prompt, or the path of a file." if what == "picture" else ""
            raise InputError(f"No {what} at {str(source)!r}.{hint}")
        if Path(source).is_dir():
            raise InputError(f"{str(source)!r} is a directory. Pass the path of a {what}.")
        data = read_regular(source, f"The {what}", InputError, max_bytes=config.max_bytes)
    if not isinstance(data, bytes):
        raise InputError(
            "Expected a prompt, a plan or a picture (path, bytes or array), got "
            f"{type(source).__name__}."
        )
    if not data or len(data) > config.max_bytes:
        raise InputError(f"A {what} must have 1 to {config.max_bytes:,} bytes, got {len(data):,}.")
    return data


def _as_uint8(image: np.ndarray) -> np.ndarray:
    if image.dtype != np.uint8 or image.ndim not in (2, 3):
        raise InputError(
            f"An image array must be uint8 of shape (h, w), (h, w, 3) or (h, w, 4), "
            f"got {image.dtype} {image.shape}."
        )
    if image.ndim == 3 and image.shape[2] not in (3, 4):
        raise InputError(f"An image array must have 3 or 4 channels, got {image.shape[2]}.")
    return np.ascontiguousarray(image)
