"""Videos have the same bytes whatever their memory held before, and wherever their pictures lie."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tabletopgen_env.recording.lerobot.videos import CODECS, DEPTH_CODEC, encode, join

RGB = np.random.default_rng(0).integers(0, 255, (8, 16, 16, 3)).astype(np.uint8)
DEPTH = np.random.default_rng(1).integers(0, 4095, (8, 16, 16)).astype(np.uint16)

_ENCODE_ALL = """
import sys
from pathlib import Path
from test_videos import CODECS, written
print(*[written(name, Path(sys.argv[1])) for name in (*CODECS, "depth")])
"""


def written(name: str, folder: Path) -> str:
    """Encode two episodes and join them; return a digest of the three files."""
    rows, codec = (DEPTH, DEPTH_CODEC) if name == "depth" else (RGB, CODECS[name])
    parts = [folder / f"{name}-{count}.mp4" for count in (8, 3)]
    for path, count in zip(parts, (8, 3), strict=True):
        encode(rows[:count], path, 20, codec)
    join(parts, folder / f"{name}.mp4", 20)
    files = [path.read_bytes() for path in (*parts, folder / f"{name}.mp4")]
    return hashlib.sha256(b"".join(files)).hexdigest()


@pytest.mark.slow
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="glibc fills what it allocates")
def test_videos_do_not_depend_on_memory_that_was_never_written(tmp_path: Path) -> None:
    found = set[str]()
    for filling in ("0", "85", "255"):
        folder = tmp_path / filling
        folder.mkdir()
        path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
        done = subprocess.run(
            [sys.executable, "-c", _ENCODE_ALL, str(folder)],
            env={**os.environ, "MALLOC_PERTURB_": filling, "PYTHONPATH": path},
            capture_output=True, text=True, timeout=240, check=True,
        )  # fmt: skip
        found.add(done.stdout)
    assert len(found) == 1 and len(found.pop().split()) == len(CODECS) + 1


@pytest.mark.slow
def test_videos_do_not_depend_on_where_their_pictures_lie(tmp_path: Path) -> None:
    digests = set[str]()
    for offset in range(0, 64, 7):
        memory = np.zeros(RGB.nbytes + 128, np.uint8)
        start = -memory.ctypes.data % 64 + offset
        rows = memory[start : start + RGB.nbytes].reshape(RGB.shape)
        rows[:] = RGB
        encode(rows, tmp_path / "a.mp4", 20, CODECS["h264"])
        digests.add(hashlib.sha256((tmp_path / "a.mp4").read_bytes()).hexdigest())
    assert len(digests) == 1
