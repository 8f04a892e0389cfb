"""A loaded machine changes no byte: one import and one generated scene beside busy processes."""

import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from bounded import LONG

from generator import bundle, generate
from generator.imports import import_scene

BUSY = os.cpu_count() or 2
"""Processes that keep every core busy meanwhile."""

_WORK = "import sys, test_under_load; test_under_load.work(*sys.argv[1:])"
_BURN = "import os\nos.nice(5)\nwhile os.getppid() == PARENT: sum(range(100_000))"

HOOK = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
"""The outline of an L, centimetres: no convex part holds it."""


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a foreign mesh that needs convex decomposition."""
    folder = tmp_path_factory.mktemp("foreign")
    outline = np.array(HOOK, float) * 0.03
    rows = [f"v {x:.4f} {y:.4f} {z:.4f}" for z in (0.0, 0.06) for x, y in outline]
    count = len(HOOK)
    for k in range(count):
        a, b = k + 1, (k + 1) % count + 1
        rows += [f"f {a} {b} {b + count}", f"f {a} {b + count} {a + count}"]
    for a, b, c in ((1, 2, 3), (1, 3, 4), (1, 4, 5), (1, 5, 6)):
        rows += [f"f {a} {c} {b}", f"f {a + count} {b + count} {c + count}"]
    (folder / "hook.obj").write_text("\n".join(rows) + "\n")
    poses = {
        "table": {"size": [1.0, 0.6, 0.7]},
        "objects": [
            {"name": "hook_1", "file": "hook.obj", "position": [0, 0, 0.71], "up": "z", "mass": 0.2}
        ],
    }
    (folder / "poses.json").write_text(json.dumps(poses))
    return folder


def work(source: str, out: str) -> None:
    """Import and generate."""
    bundle.save(import_scene(source), out + "/imported", allow_failed=True)
    bundle.save(generate("a mug", seed=3).scene, out + "/generated", allow_failed=True)


def digests(folder: Path) -> dict[str, str]:
    """Return the digest of each file that was made in a folder."""
    files = sorted(p for kind in ("imported", "generated") for p in (folder / kind).rglob("*"))
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in files
        if path.is_file()
    }


@contextmanager
def busy_machine() -> Iterator[None]:
    """Keep the machine busy with processes that end with this one."""
    code = _BURN.replace("PARENT", str(os.getpid()))
    processes = [subprocess.Popen([sys.executable, "-S", "-c", code]) for _ in range(BUSY)]
    try:
        yield
    finally:
        for process in processes:
            process.kill()
        for process in processes:
            process.wait(LONG)


@pytest.mark.slow
@pytest.mark.timeout(1200)
def test_a_busy_machine_makes_the_same_bytes(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Made here, and by another process on a busy machine, both without caches."""
    here, there = tmp_path / "alone", tmp_path / "beside"
    for folder in (here, there):
        folder.mkdir()
    monkeypatch.setenv("XDG_CACHE_HOME", str(here / "cache"))
    work(str(source), str(here))
    monkeypatch.setenv("XDG_CACHE_HOME", str(there / "cache"))
    path = os.pathsep.join(sys.path)
    with busy_machine():
        done = subprocess.run(
            [sys.executable, "-c", _WORK, str(source), str(there)],
            env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True,
            timeout=4 * LONG,
        )  # fmt: skip
    assert done.returncode == 0, done.stderr
    alone, beside = digests(here), digests(there)
    assert any("imported" in name for name in alone) and any("generated" in n for n in alone)
    assert alone == beside
