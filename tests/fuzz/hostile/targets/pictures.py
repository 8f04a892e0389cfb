"""Pictures and depth maps from users, and their camera parameters."""

import functools
import io
import os
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from generator.backends.cloud.drawing.pictures import decode_answer
from generator.bundle.contents import decode_png
from generator.bundle.segments import decode_segments
from generator.errors import InputError
from generator.meshes.reading.inspection import check_pictures
from generator.meshes.reading.textures import Pictures
from generator.method.reference import read_image, refer
from generator.scene import Intrinsics

from ..judging import accepts, accepts_any, command, reading
from ..streams import hostile_png, spoiled
from ..values import number, text, value
from . import Run

_APART = 0.1  # share of cases decoded in children
_FORMATS = ("PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF", "PPM", "ICO", "TGA")


@functools.cache
def _good(kind: str = "PNG", depth: bool = False) -> bytes:
    rng = np.random.default_rng(0)
    pixels: Any = rng.integers(0, 255, (96, 128, 3), np.uint8)
    if depth:
        pixels = rng.integers(700, 1300, (96, 128)).astype(np.uint16)
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, kind)
    return file.getvalue()


def pictures(rng: random.Random, folder: Path) -> Run:
    """Pictures in all supported formats, as files and as bytes."""
    raw = hostile_png(rng, _good())
    if rng.random() < 0.5:
        raw = spoiled(_good(rng.choice(_FORMATS)), rng)
    if rng.random() < 0.1:
        raw = _odd(rng)
    path = folder / rng.choice(("x.png", "x.jpg", "x.gif", "x.tiff"))
    _put(path, raw, rng)
    names = [{"name": "table", "label": "table"}, {"name": "mug_1", "label": value(rng)}]
    apart = rng.random() < _APART
    return lambda: accepts_any(
        *readers(raw, apart), lambda: read_image(path), lambda: decode_segments(names, raw)
    )


def readers(raw: bytes, apart: bool) -> tuple[Callable[[], Any], ...]:
    """Return all readers of pictures: photos, server responses, bundles, mesh textures.

    ``apart`` decodes in a child for each, as users do; else in this process, as within the child
    in which a mesh is read.
    """
    return tuple(
        functools.partial(_reading, read, raw, apart)
        for read in (read_image, decode_answer, _bundled, _textured)
    )


def _reading(read: Callable[[bytes], Any], raw: bytes, apart: bool) -> None:
    with reading(apart):
        read(raw)


def _bundled(raw: bytes) -> None:
    decode_png(raw, "x.png")


def _textured(raw: bytes) -> None:
    if reason := check_pictures([raw]):
        raise InputError(reason)
    try:
        image = Image.open(io.BytesIO(raw))  # trimesh treats any exception as a missing picture
    except Exception as error:
        raise InputError("no picture") from error
    Pictures("the mesh").place(image, np.ones(3))


def depths(rng: random.Random, folder: Path) -> Run:
    """Depth maps with the intrinsics of their cameras."""
    raw = _good("PNG", depth=True)
    kind = rng.randrange(4)
    if kind == 0:
        raw = hostile_png(rng, raw)
    elif kind == 1:
        raw = spoiled(raw, rng)
    path = folder / "depth.png"
    _put(path, raw, rng)
    depth: Any = rng.choice((path, raw, _array(rng)))
    camera = (120.0, 120.0, 63.5, 47.5)
    given = [number(rng) if rng.random() < 0.3 else c for c in camera]
    if rng.random() < 0.2:
        given[rng.randrange(4)] = value(rng)
    picture = _good()

    def run() -> bool:
        found: list[Intrinsics] = []
        good = accepts(lambda: found.append(Intrinsics(*given)))
        asks: Any = None  # no backend is called
        usual = found[0] if found else Intrinsics(*camera)
        return good and accepts_any(
            lambda: refer(picture, asks, asks, 0, depth=depth, intrinsics=usual),
            lambda: refer(depth, asks, asks, 0),
        )

    return run


def cameras(rng: random.Random, folder: Path) -> Run:
    """Arguments of ``generate``: camera, name, seed and output path."""
    (folder / "picture.png").write_bytes(_good())
    (folder / "depth.png").write_bytes(_good("PNG", depth=True))
    (folder / "file").write_text("x")
    camera = ",".join(rng.choice((str(number(rng)), text(rng)[:200], "120")) for _ in range(4))
    arguments = {
        "--intrinsics": camera,
        "--depth": rng.choice(("depth.png", "file", "picture.png", ".", "none.png")),
        "--out": rng.choice(("file", "out", "file/x", "\x00", "x" * 300)),
        "--name": text(rng)[:300],
        "--seed": rng.choice(("-1", "1e3", "nan", str(2**70), "0", "")),
        "--budget": rng.choice(("-1", "nan", "inf", "1e308")),
        "--prices": rng.choice(("file", "/dev/zero", ".", "none.toml")),
    }
    chosen = rng.sample(sorted(arguments), rng.randrange(1, 4))
    source = rng.choice((".", "file", "none.png", "/dev/zero", "", "../beside.txt", "picture.png"))
    pairs = [part for name in chosen for part in (name, arguments[name])]
    return lambda: command("generate", source, *pairs)


def _odd(rng: random.Random) -> bytes:
    """A picture of many frames, or with a broken orientation."""
    kind, count = rng.choice(("GIF", "TIFF", "WEBP", "PNG")), rng.choice((2, 200))
    sizes = (64,) if kind == "WEBP" else (64, 300)
    frames = [Image.new("P", (rng.choice(sizes), 64), k) for k in range(count)]
    file = io.BytesIO()
    frames = [f.convert("RGB") for f in frames] if kind != "GIF" else frames
    frames[0].save(file, kind, save_all=True, append_images=frames[1:])
    return file.getvalue()


def _put(path: Path, raw: bytes, rng: random.Random) -> None:
    kind = rng.random()
    if kind < 0.02:
        path.symlink_to("/dev/zero")
    elif kind < 0.04:
        os.mkfifo(path)
    elif kind < 0.06:
        path.mkdir()
    else:
        path.write_bytes(raw)


def _array(rng: random.Random) -> Any:
    shape: Any = rng.choice(((96, 128), (128, 96), (96, 128, 1), (0, 0), (3,), (96, 128, 3)))
    kind = rng.choice((np.float64, np.float32, np.uint16, np.int64, np.uint8, object, "U4", bool))
    filled = np.full(shape, 1, kind)
    if filled.size and filled.dtype.kind == "f":
        filled.flat[rng.randrange(filled.size)] = float(
            rng.choice((np.nan, np.inf, -1.0, 1e30, 0.0, -0.0))
        )
        filled *= rng.choice((1.0, 1e-3, 1e6, 0.0))
    return filled
