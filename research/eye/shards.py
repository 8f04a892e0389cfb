"""Shards: compact files of about a hundred samples with random access, without pickles.

A shard is an uncompressed zip archive. ``shard.json`` has the format, the number of samples and the
category keys. Sample ``k`` has five members: ``k.jpg`` is the picture; ``k.map.png`` has one byte
per pixel (0 background, 1 top, 2 rest of the table, 2 + i instance i); ``k.depth.png`` has half the
size and 16 bits of inverse depth (0 is infinitely far); ``k.masks`` are the whole masks, each
cropped to its box, as deflated bits; ``k.json`` has everything else. The top's mask is its outline,
filled.
"""

from __future__ import annotations

import json
import zipfile
import zlib
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8, UInt16

from generator.errors import InputError, StorageError
from generator.scene import View

from .sample import BACKGROUND, OBJECT, TABLE_REST, TOP, Sample, fill

FORMAT = 1
_NEAREST = 0.1  # metres; inverse depth is _NEAREST / depth in units of 2^-16


class ShardWriter:
    """Writes a shard; the file appears under its name once it is complete."""

    def __init__(self, path: Path, keys: Sequence[str], quality: int = 94) -> None:
        self._path, self._keys, self._quality = Path(path), tuple(keys), quality
        self._part = self._path.with_name(self._path.name + ".part")
        self._count = 0
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._zip = zipfile.ZipFile(self._part, "w", zipfile.ZIP_STORED)
        except OSError as error:
            raise StorageError(f"Cannot write the shard {path}: {error}.") from error

    def __enter__(self) -> ShardWriter:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if kind is None:
            head = {"format": FORMAT, "count": self._count, "keys": self._keys}
            self._put("shard.json", json.dumps(head).encode())
        self._zip.close()
        if kind is None:
            self._part.replace(self._path)
        else:
            self._part.unlink(missing_ok=True)

    def add(self, sample: Sample) -> None:
        """Append a sample. Raises InputError for more than 252 instances."""
        if len(sample.full) > 252:
            raise InputError(f"A sample may have at most 252 instances, got {len(sample.full)}.")
        stem = f"{self._count:05d}"
        quality = [cv2.IMWRITE_JPEG_QUALITY, self._quality]
        self._put(f"{stem}.jpg", _encode(".jpg", sample.image[..., ::-1], quality))
        code = np.where(sample.visible > 0, sample.visible + np.uint8(2), sample.region)
        self._put(f"{stem}.map.png", _encode(".png", code.astype(np.uint8)))
        self._put(f"{stem}.depth.png", _encode(".png", _nearness(sample.depth)))
        boxes, packed = _pack(sample.full)
        self._put(f"{stem}.masks", packed)
        self._put(f"{stem}.json", json.dumps(_facts(sample, boxes)).encode())
        self._count += 1

    def _put(self, name: str, content: bytes) -> None:
        self._zip.writestr(zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0)), content)


class ShardReader:
    """Reads samples of a shard by index. Raises StorageError for a damaged or foreign file."""

    def __init__(self, path: Path) -> None:
        self.path = Path(path)
        try:
            self._zip = zipfile.ZipFile(self.path)
            head = json.loads(self._zip.read("shard.json"))
            self._count, self.keys = int(head["count"]), tuple(map(str, head["keys"]))
            known = type(head["format"]) is int and head["format"] == FORMAT
        except (OSError, KeyError, ValueError, zipfile.BadZipFile, zlib.error) as error:
            raise self._damage(error) from error
        if not known:
            raise StorageError(
                f"{self.path} has shard format {head['format']}; this version reads {FORMAT}. "
                "Render it again."
            )

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: int) -> Sample:
        return self.read(index)

    def read(self, index: int, depth: bool = True) -> Sample:
        """Return a sample; without ``depth`` (faster) its depth has shape 0 x 0."""
        if not 0 <= index < self._count:
            raise IndexError(f"{self.path} has {self._count} samples; there is no sample {index}.")
        stem = f"{index:05d}"
        try:
            image = _decode(self._zip.read(f"{stem}.jpg"), cv2.IMREAD_COLOR)[..., ::-1]
            code = _decode(self._zip.read(f"{stem}.map.png"), cv2.IMREAD_UNCHANGED)
            facts = json.loads(self._zip.read(f"{stem}.json"))
            full = _unpack(facts["boxes"], self._zip.read(f"{stem}.masks"), code.shape)
            far = np.zeros((0, 0), np.float16)
            if depth:
                near = _decode(self._zip.read(f"{stem}.depth.png"), cv2.IMREAD_UNCHANGED)
                far = _distance(near, code.shape)
            return _sample(np.ascontiguousarray(image), code, full, far, facts)
        except (OSError, KeyError, ValueError, zipfile.BadZipFile, zlib.error) as error:
            raise self._damage(error) from error

    def close(self) -> None:
        """Close the file."""
        self._zip.close()

    def _damage(self, error: Exception) -> StorageError:
        return StorageError(
            f"{self.path} is missing, damaged or not a shard ({type(error).__name__}: {error}). "
            "Delete it and render again: finished shards are kept."
        )


def _sample(
    image: UInt8[np.ndarray, "h w 3"],
    code: UInt8[np.ndarray, "h w"],
    full: Bool[np.ndarray, "n h w"],
    depth: Float[np.ndarray, "h w"],
    facts: dict,
) -> Sample:
    n = len(full)
    outline = np.array(facts["outline"], np.float32).reshape(-1, 2)
    return Sample(
        image=image,
        visible=np.where(code > 2, code - 2, 0).astype(np.uint8),
        full=full,
        category=np.array(facts["category"], np.int16),
        region=np.array([BACKGROUND, TOP, TABLE_REST, OBJECT], np.uint8)[np.minimum(code, 3)],
        top=fill(outline, *code.shape),
        outline=outline,
        view=View(*facts["view"]),
        focal=float(facts["focal"]),
        yaw=np.array(facts["yaw"], np.float32),
        upright=np.array(facts["upright"], bool),
        size=np.array(facts["size"], np.float32).reshape(n, 3),
        position=np.array(facts["position"], np.float32).reshape(n, 3),
        support=np.array(facts["support"], np.int16),
        depth=depth,
    )


def _facts(sample: Sample, boxes: list[list[int]]) -> dict:
    view = sample.view
    return {
        "boxes": boxes,
        "category": sample.category.tolist(),
        "outline": np.round(sample.outline.astype(float), 2).tolist(),
        "view": [view.azimuth, view.elevation, view.fov],
        "focal": sample.focal,
        "yaw": np.round(sample.yaw.astype(float), 4).tolist(),
        "upright": sample.upright.tolist(),
        "size": np.round(sample.size.astype(float), 5).tolist(),
        "position": np.round(sample.position.astype(float), 5).tolist(),
        "support": sample.support.tolist(),
    }


def _encode(kind: str, picture: np.ndarray, options: Sequence[int] = ()) -> bytes:
    return cv2.imencode(kind, np.ascontiguousarray(picture), list(options))[1].tobytes()


def _decode(content: bytes, flag: int) -> np.ndarray:
    picture = cv2.imdecode(np.frombuffer(content, np.uint8), flag)
    if picture is None:
        raise ValueError("a picture in it cannot be decoded")
    return picture


def _nearness(depth: Float[np.ndarray, "h w"]) -> UInt16[np.ndarray, "h2 w2"]:
    """Return half-size 16-bit inverse depth; zeros in the lowest 4 bits compress well."""
    near = np.clip(_NEAREST / depth[::2, ::2].astype(np.float32), 0, 1) * 4095
    return np.round(near).astype(np.uint16) << 4


def _distance(
    near: UInt16[np.ndarray, "h2 w2"], shape: tuple[int, ...]
) -> Float[np.ndarray, "h w"]:
    value = (near >> 4).astype(np.float32)
    far = np.where(value > 0, _NEAREST * 4095 / np.maximum(value, 1), np.inf).astype(np.float16)
    return far.repeat(2, 0).repeat(2, 1)[: shape[0], : shape[1]]


def _pack(full: Bool[np.ndarray, "n h w"]) -> tuple[list[list[int]], bytes]:
    boxes, bits = [], []
    for mask in full:
        ys, xs = np.flatnonzero(mask.any(1)), np.flatnonzero(mask.any(0))
        box = [int(xs[0]), int(ys[0]), int(xs[-1]) + 1, int(ys[-1]) + 1] if len(ys) else [0] * 4
        boxes.append(box)
        bits.append(np.packbits(mask[box[1] : box[3], box[0] : box[2]]).tobytes())
    return boxes, zlib.compress(b"".join(bits), 6)


def _unpack(
    boxes: list[list[int]], packed: bytes, shape: tuple[int, ...]
) -> Bool[np.ndarray, "n h w"]:
    content, at = np.frombuffer(zlib.decompress(packed), np.uint8), 0
    full = np.zeros((len(boxes), *shape), bool)
    for mask, (x0, y0, x1, y1) in zip(full, boxes, strict=True):
        size = (x1 - x0) * (y1 - y0)
        bits = np.unpackbits(content[at : at + (size + 7) // 8], count=size)
        mask[y0:y1, x0:x1] = bits.reshape(y1 - y0, x1 - x0)
        at += (size + 7) // 8
    return full
