"""Foreign scenes with valid parts in invalid combinations: MJCF, GLB scenes and folders."""

import os
import random
import resource
import struct
import subprocess
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from generator.errors import TabletopError
from generator.imports.mjcf_files import gather
from generator.imports.reader import SourceKind, read_scene
from generator.meshes.reading.inspection import inspect_glb

from ..forking import Forked, forked_children, preload
from ..judging import Unfit, accepts, check_printable
from ..values import mutate, written
from . import Run
from .mjcf_parts import obj, write_mjcf


def mjcf(rng: random.Random, folder: Path) -> Run:
    """MJCF files: sizes, sensors, textures, replicates, meshes, numbers."""
    path, children = write_mjcf(rng, folder), _children(rng)

    def run() -> bool:
        with children:
            return accepts(lambda: gather(path)) and accepts(lambda: read_scene("mjcf", path))

    return run


# --------------------------------------------------------------------------------------------- GLB
def glb_scenes(rng: random.Random, folder: Path) -> Run:
    """GLB files of several scenes, with shared nodes and meshes, and collision shapes."""
    path, children = _write_glb(rng, folder), _children(rng)

    def run() -> bool:
        raw = path.read_bytes()
        with children:
            sound = accepts(lambda: inspect_glb(raw, "it"))
            return sound and accepts(lambda: read_scene("glb", path))

    return run


def _write_glb(rng: random.Random, folder: Path) -> Path:
    faces = rng.choice((4, 100, 5000, 82_000))
    ring = np.linspace(0, 2 * np.pi, 200)
    points = np.stack([np.cos(ring), np.sin(ring), np.cos(5 * ring)], 1) * 0.1
    if rng.random() < 0.1:
        points[rng.randrange(200), 0] = rng.choice((np.nan, np.inf, 3e38))
    index = np.random.default_rng(rng.randrange(2**31)).integers(0, 200, 3 * faces)
    data = points.astype("<f4").tobytes() + index.astype("<u2").tobytes()
    header: dict[str, Any] = {
        "asset": {"version": "2.0"}, "scene": rng.choice((0, 0, 1, 5, -1)),
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 2400},
            {"buffer": 0, "byteOffset": 2400, "byteLength": len(data) - 2400},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 200, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3 * faces, "type": "SCALAR"},
        ],
    }  # fmt: skip
    header |= _forest(rng)
    if rng.random() < 0.2:
        header = mutate(header, rng, ("collision", "body", "fixed", "table", "a"))
    content = written(header, rng)
    content += b" " * (-len(content) % 4)
    data += bytes(-len(data) % 4)
    whole = 28 + len(content) + len(data)
    head = struct.pack("<4sIII4s", b"glTF", 2, whole, len(content), b"JSON")
    path = folder / "scene.glb"
    path.write_bytes(head + content + struct.pack("<I4s", len(data), b"BIN\0") + data)
    return path


def _forest(rng: random.Random) -> dict[str, Any]:
    """Return nodes and scenes: bodies, collision shapes, and scenes that share them."""
    shapes = rng.choice((0, 3, 40, 3000, 19_000))
    bodies = rng.choice((1, 3, 30, 100, 250))
    nodes: list[dict[str, Any]] = [{"name": "table", "mesh": 0, "extras": {"fixed": True}}]
    nodes += [
        {"name": f"a{k}", "mesh": 0, "extras": {"body": f"a{k}"}, "translation": [0.1 * k, 1, 0]}
        for k in range(bodies)
    ]
    first = len(nodes)
    kinds = ("hull", "box", "cylinder", "ellipsoid", "sphere", "x")
    nodes += [
        {
            "name": f"c{k}",
            "mesh": 0,
            "extras": {"body": f"a{k % bodies}", "kind": rng.choice(kinds)},
        }
        for k in range(shapes)
    ]
    for _ in range(rng.choice((0, 0, 1, 3))):
        node = rng.choice(nodes)
        node |= rng.choice((
            {"scale": [0, 1, 1]}, {"scale": [-1, 1, 1]}, {"scale": [1e30, 1, 1]}, {"mesh": 7},
            {"matrix": [1] * 16}, {"rotation": [0, 0, 0, 0]}, {"rotation": [1e300, 0, 0, 1]},
            {"translation": [10**40, 0, 0]}, {"name": "x" * 100_000}, {"name": "\x1b[2J"},
            {"extras": {"body": "a0", "mass": rng.choice((0, -1, 1e300, "1")), "inertia": [0] * 9}},
            {"children": [rng.randrange(len(nodes))]}, {"extras": {"body": ["a"], "fixed": 1}},
        ))  # fmt: skip
    shown = [*range(first)]
    collision = {"name": "collision", "nodes": [*range(first, len(nodes))]}
    listed: Any = rng.choice((shown, collision["nodes"], []))
    copies = min(rng.choice((0, 0, 1, 30, 4000)), 2_000_000 // (len(listed) + 1))
    more = [{"nodes": listed}] * copies
    scenes = rng.choice(([{"nodes": shown}, collision], [collision, {"nodes": shown}]))
    return {"nodes": nodes, "scenes": [*scenes, *more]}


# ------------------------------------------------------------------------------------------ folder
def folders(rng: random.Random, folder: Path) -> Run:
    """Folders with ``poses.json``: files named repeatedly, and their contents."""
    _write_folder(rng, folder)
    children = _children(rng)

    def run() -> bool:
        with children:
            return accepts(lambda: read_scene("folder", folder))

    return run


def _write_folder(rng: random.Random, folder: Path) -> Path:
    kind = rng.randrange(3)
    count = rng.choice((4, 300, 20_000))
    if kind == 0:
        (folder / "a.obj").write_bytes(obj(rng, count))
    else:
        _write_glb(rng, folder).rename(folder / "a.glb")
    name = "a.obj" if kind == 0 else "a.glb"
    thing = {"name": "a", "file": name, "position": [0, 0, 0.8], "scale": 0.05}
    told: Any = {
        "table": {"size": [1.2, 0.7, 0.74]},
        "objects": [thing | {"up": rng.choice("yz")}] * rng.choice((1, 3, 100, 200, 1000)),
    }
    if rng.random() < 0.5:
        told = mutate(told, rng, ("a.obj", "a.glb", "../a.obj", "z", "y", "table"), raw=True)
    (folder / "poses.json").write_bytes(written(told, rng))
    return folder


# ------------------------------------------------------------------------------------------ limits
_MEMORIES = (2 * 2**30, 3 * 2**30, 5_500_000 * 2**10, 8 * 2**30)
_TIMES = (5, 10, 30)  # seconds
_FORKED = 0.96  # share of cases that fork the children


def limited(rng: random.Random, folder: Path) -> Run:
    """Foreign scenes read by a process under resource limits, as set by ``ulimit``."""
    writers: tuple[tuple[SourceKind, Callable[[random.Random, Path], Path]], ...] = (
        ("mjcf", write_mjcf), ("glb", _write_glb), ("folder", _write_folder),
    )  # fmt: skip
    kind, write = rng.choice(writers)
    path = write(rng, folder)
    memory = rng.choice(_MEMORIES) if rng.random() < 0.7 else resource.RLIM_INFINITY
    seconds = rng.choice(_TIMES) if rng.random() < 0.5 else resource.RLIM_INFINITY
    return partial(_alone, kind, path, memory, seconds, forked=_forks(rng))


def _alone(kind: SourceKind, path: Path, memory: int, seconds: int, forked: bool) -> bool:
    """Read a scene in a process with limits; return whether it was accepted.

    Raises:
        Unfit: the process ends otherwise than by a result or an error of the package.
    """
    if forked:
        preload()
        reader = partial(_read_limited, kind, path, memory, seconds, forked_children())
        code, out, err = Forked(reader, {}).communicate(100)
    else:
        given = kind, str(path), str(memory), str(seconds)
        program = f"from {__name__} import main; main()"
        done = subprocess.run(
            [sys.executable, "-c", program, *given], capture_output=True, timeout=100, check=False
        )
        code, out, err = done.returncode, done.stdout, done.stderr
    if code not in (0, 2):
        raise Unfit(f"exit code {code}: {err.decode(errors='replace')[-2000:]}")
    check_printable(out.decode(), "what is printed")
    return not code


def main() -> None:
    """Read the scene that the arguments name, under their limits."""
    kind, path, memory, seconds = sys.argv[1:]
    _read_limited(kind, Path(path), int(memory), int(seconds), nullcontext())  # type: ignore[arg-type]


def _read_limited(
    kind: SourceKind, path: Path, memory: int, seconds: int, children: AbstractContextManager[None]
) -> None:
    """Read a scene under limits of this process; exit with code 2 if it is rejected."""
    for limit, value in ((resource.RLIMIT_AS, memory), (resource.RLIMIT_CPU, seconds)):
        known = [value, *resource.getrlimit(limit)]
        most = min((v for v in known if v != resource.RLIM_INFINITY), default=-1)
        resource.setrlimit(limit, (most, most))
    with children:
        try:
            read_scene(kind, path)
        except TabletopError as error:
            print(error, flush=True)
            os._exit(2)


def _children(rng: random.Random) -> AbstractContextManager[None]:
    """Return how the sandbox starts children: most are forked."""
    return forked_children() if _forks(rng) else nullcontext()


def _forks(rng: random.Random) -> bool:
    return rng.random() < _FORKED
