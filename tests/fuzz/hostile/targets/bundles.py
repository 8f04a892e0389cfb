"""Bundles that are consistent but hostile, and their certificates."""

import functools
import hashlib
import json
import os
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from toy import toy_object, toy_scene

from generator.bundle import load, load_picture, load_pictures, load_segments, save, verify
from generator.bundle.decoder import decode_scene
from generator.bundle.encoder import dumps
from generator.bundle.segments import Segments
from generator.errors import BundleError
from generator.physics.gate import judge
from generator.physics.mjcf import document
from generator.physics.spec import compile_spec, scene_spec
from generator.scene import Edit, PlannedObject, PlannedTable, Provenance, Relation, ScenePlan

from ..judging import accepts, command
from ..streams import bomb, hostile_png, png, spoiled
from ..values import mutate, number, text, written
from . import Run

Payload = dict[str, Any]
Files = dict[str, bytes]

_SIMULATED = 0.05  # share of the valid bundles that are also simulated and reset
_NAMES = ("table", "cube_1", "mug_1", "mesh", "0-cube", "scene.json", "scene.xml", "hull", "box")


@functools.cache
def base() -> tuple[bytes, Files]:
    """Return scene.json and the other files of a small, valid bundle with all features."""
    import tempfile

    cube = toy_object("cube_1", (0.05, 0.05, 0.05), (-0.1, -0.1))
    mug = toy_object("mug_1", (0.08, 0.08, 0.09), (0.1, 0.1), wall=0.006)
    planned = PlannedObject("mug_1", "mug", "mug", {"color": "red"}, (Relation("center"),))
    plan = ScenePlan("a mug", PlannedTable(), (planned,), warnings=("a warning",))
    scene = toy_scene((cube, mug))
    told = Provenance("text", 3, "a mug", edits=(Edit("0" * 64, "move", ("cube_1",), "there"),))
    scene = scene.replace(plan=plan, provenance=told)
    scene = scene.replace(report=judge(scene))
    index = np.zeros((64, 64), np.uint8)
    index[8:60, 4:60], index[20:30, 20:30] = 1, 2
    segments = Segments(("table", "mug_1"), ("table", "mug"), index)
    picture = np.full((64, 64, 3), 200, np.uint8)
    with tempfile.TemporaryDirectory() as place:
        path = save(
            scene, place, images={"preview": picture, "reference": picture}, segments=segments
        )
        found = {
            p.relative_to(path).as_posix(): p.read_bytes() for p in path.rglob("*") if p.is_file()
        }
    return found.pop("scene.json"), found


def values(rng: random.Random, folder: Path) -> Run:
    """Bundles with mutated fields, and recomputed digests and XML."""
    raw, files = base()
    files = dict(files)
    payload = json.loads(raw)
    if rng.random() < 0.5:
        payload = mutate(payload, rng, _NAMES)
    else:
        _aim(payload, rng)
    if not isinstance(payload, dict):
        payload = {"scene": payload}
    return _run(_put(payload, files, rng, folder), rng)


def _aim(payload: Payload, rng: random.Random) -> None:
    """Insert hostile numbers and texts at fields used by physics, pictures and people."""
    for _ in range(rng.choice((1, 1, 2))):
        holder: Any = rng.choice((
            payload["table"], payload["report"], payload["view"], *payload["objects"],
            *payload["objects"], *payload["models"].values(),
        ))  # fmt: skip
        key: Any = rng.choice(list(holder))
        while isinstance(holder[key], dict | list) and holder[key]:
            holder = holder[key]
            key = rng.choice(list(holder) if isinstance(holder, dict) else range(len(holder)))
        here = holder[key]
        if isinstance(here, str):
            holder[key] = text(rng, _NAMES)
        elif isinstance(here, bool) or not isinstance(here, int | float):
            holder[key] = rng.choice((number(rng), text(rng, _NAMES), [], None))
        else:
            factor = rng.choice((1e-300, 1e-12, 1e-6, 1e-3, 0.5, 2.0, 1e3, 1e6, 1e12, 1e300))
            holder[key] = rng.choice((number(rng), here * factor, -here))


def files(rng: random.Random, folder: Path) -> Run:
    """Bundles with mutated meshes, pictures, XML and file lists, and recomputed digests."""
    raw, kept = base()
    payload, kept = json.loads(raw), dict(kept)
    change = rng.choice(_CHANGES)
    change(payload, kept, rng)
    place = _put(payload, kept, rng, folder, anew=change not in (_xml, _many, _parts))
    if rng.random() < 0.15:
        _disturbed(place, rng)
    return _run(place, rng)


def certificates(rng: random.Random, folder: Path) -> Run:
    """Certificates beside a valid bundle."""
    from tabletopgen_env.certificates.certificate import SCHEMA, read_certificate
    from tabletopgen_env.env import make_env

    raw, kept = base()
    payload = json.loads(raw)
    place = _put(payload, dict(kept), random.Random(0), folder)
    entry = {"task": "Lift", "target": "cube_1", "goal": None, "preset": None,
             "successes": 20, "episodes": 20}  # fmt: skip
    told: Any = {
        "schema": SCHEMA,
        "scene": hashlib.sha256((place / "scene.json").read_bytes()).hexdigest(),
        "terms": {"tasks": ["Lift", "PickPlace", "Reach"], "episodes": 20, "most": 8, "seed": 0},
        "versions": {"mujoco": "3"},
        "instances": [entry, {**entry, "task": "PickPlace", "goal": "mug_1"},
                      {**entry, "task": "Reach", "target": None}],
    }  # fmt: skip
    told = mutate(told, rng, ("Lift", "Stack", "Sequence", *_NAMES), raw=True)
    content = written(told, rng)
    if rng.random() < 0.1:
        content = spoiled(content, rng)
    _write(place / "certificate.json", content)
    simulate = rng.random() < _SIMULATED

    def played() -> None:
        env = make_env(place, task="Lift", certified=True)
        env.reset(seed=0)

    def run() -> bool:
        calls: list[Callable[[], Any]] = [
            lambda: read_certificate(place), lambda: verify(place),
        ]  # fmt: skip
        return accepts(*calls, *([played] if simulate else []))

    return run


# ----------------------------------------------------------------------------------------- writing
def _put(
    payload: Payload, files: Files, rng: random.Random, folder: Path, anew: bool = True
) -> Path:
    """Write a bundle with matching digests and, if possible, XML."""
    if anew:
        xml = _xml_of(payload, files)
        if xml is not None and rng.random() < 0.97:
            files["scene.xml"] = xml
    for name, content in files.items():
        listed = payload.get("files")
        if isinstance(listed, dict) and name in listed and rng.random() < 0.995:
            listed[name] = _entry(content)
    content = _dumped(payload, rng)
    named = f"toy-{hashlib.sha256(content).hexdigest()[:12]}"
    place = folder / "store" / (named if rng.random() < 0.9 else "forged")
    for name, inner in files.items():
        _write(place / name, inner)
    _write(place / "scene.json", content)
    return place


def _xml_of(payload: Payload, files: Files) -> bytes | None:
    """Return the XML of the values, as a forger could generate it with this package."""
    try:
        decoded = decode_scene(payload, files.__getitem__)
        return document(decoded.scene, paths=decoded.paths).xml.encode()
    except Exception:  # not the values of a scene, so the XML does not matter
        return None


def _dumped(payload: Payload, rng: random.Random) -> bytes:
    if rng.random() < 0.03:
        return written(mutate(payload, rng, raw=True), rng)
    try:
        return dumps(payload)
    except (ValueError, UnicodeError, RecursionError):
        return written(payload, rng)


def _entry(content: bytes) -> Payload:
    return {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()}


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)


# ----------------------------------------------------------------------------------- other files
def _named(files: Files, start: str, rng: random.Random) -> str:
    return rng.choice(sorted(name for name in files if name.startswith(start)))


def _texture(payload: Payload, files: Files, rng: random.Random) -> None:
    name = _named(files, "textures/", rng)
    files[name] = hostile_png(rng, files[name])


def _picture(payload: Payload, files: Files, rng: random.Random) -> None:
    name = rng.choice(("preview.png", "reference.png", "stages/instances.png"))
    files[name] = hostile_png(rng, files[name])


def _mesh(payload: Payload, files: Files, rng: random.Random) -> None:
    name = _named(files, "meshes/", rng)
    lines = files[name].decode().splitlines()
    at = rng.randrange(len(lines) + 1)
    hostile = rng.choice((
        "f 1/1 2/2 999999999/1", "f -1/1 -2/2 -3/3", "f 1 2 3 4 5", "v nan 0 0", "v 1e308 0 0",
        "v inf 0 0", "v 1 2", "vt 9 9 9", "vn 0 0 1", "o x", "mtllib ../../outside.xml", "#" * 99,
        "v " + "1" * 5000 + " 0 0", "v 1e-320 0 0", "f 0/0 1/1 2/2", "\x00", "\u00a0v 0 0 0",
        "f 99999999999999999999999/1 1/1 2/2", "f 1.5/1 2/2 3/3", "f nan/1 1/1 2/2", "v 0 0 0 1",
    ))  # fmt: skip
    lines.insert(at, hostile)
    content = "\n".join(lines).encode()
    if rng.random() < 0.3:
        content = spoiled(files[name], rng)
    if rng.random() < 0.1:
        count = rng.choice((10_000, 10_000, 200_000))
        content = files[name] + b"v 0 0 0\nvt 0 0\n" * count + b"f 1/1 2/2 3/3\n" * count
    if rng.random() < 0.05:
        content = b"v " + b"0 " * 3_000_000
    files[name] = content


def _xml(payload: Payload, files: Files, rng: random.Random) -> None:
    good = files["scene.xml"]
    files["scene.xml"] = rng.choice((
        b"", b"garbage", b'<mujoco><include file="../../../outside.xml"/></mujoco>', good + b" ",
        good.replace(b"<worldbody>", b'<include file="../../../outside.xml"/><worldbody>', 1),
        b"<mujoco>" + b"<body>" * 100_000, b"\xff\xfe", good[: len(good) // 2],
        b'<!DOCTYPE x [<!ENTITY a "x">]><mujoco/>', b"<mujoco/>",
    ))  # fmt: skip


def _many(payload: Payload, files: Files, rng: random.Random) -> None:
    """Many models from few files: small on disk, expensive to decode."""
    models = payload["models"]
    one = next(iter(models.values()))
    count = rng.choice((50, 50, 50, 300, 300, 3000))
    if rng.random() < 0.5:
        side = rng.choice((256, 1024, 1024, 4096))
        files[one["texture"]] = png(side, side, color=0, data=bomb(side * (side + 1)))
    else:
        count *= 3
    for k in range(count):
        models[f"{100 + k}-x"] = dict(one)
    if rng.random() < 0.3:
        thing = payload["objects"][0]
        for k in range(count):
            named = {**thing["placement"], "name": f"cube_{k + 2}"}
            payload["objects"].append({**thing, "name": f"cube_{k + 2}", "placement": named})


def _crowd(payload: Payload, files: Files, rng: random.Random) -> None:
    """Copies of an object at or near one place: more contacts than fit."""
    thing = rng.choice(payload["objects"])
    reach = rng.choice((0.0, 0.0, 0.01, 0.3))
    for k in range(rng.choice((2, 8, 20, 60))):
        name = f"copy_{k}"
        place = {**thing["placement"], "name": name}
        at = [value + rng.uniform(-reach, reach) for value in thing["pose"]["position"]]
        pose = {**thing["pose"], "position": at}
        payload["objects"].append({**thing, "name": name, "placement": place, "pose": pose})


def _parts(payload: Payload, files: Files, rng: random.Random) -> None:
    """Parts with many vertices, or very many parts."""
    holder = rng.choice((payload["table"], payload["objects"][0], next(iter(
        payload["models"].values()))))  # fmt: skip
    part = holder["parts"][0] if holder["parts"] else payload["table"]["parts"][0]
    if rng.random() < 0.5:
        holder["parts"] = [part] * rng.choice((100, 100, 1000, 1000, 20_000))
    else:
        count = rng.choice((1000, 1000, 1000, 100_000))
        points = [[rng.uniform(-0.1, 0.1) for _ in range(3)] for _ in range(count)]
        holder["parts"] = [{**part, "vertices": points, "kind": "hull"}]


def _listed(payload: Payload, files: Files, rng: random.Random) -> None:
    """File lists with other names or false data."""
    listed = payload["files"]
    name = rng.choice(sorted(listed))
    kind = rng.randrange(5)
    if kind == 0:
        listed[text(rng, ("../../../precious/file.txt", "meshes", "certificate.json"))] = {
            **listed[name]
        }
    elif kind == 1:
        listed[name] = {**listed[name], "bytes": number(rng)}
        files.pop(name)
    elif kind == 2:
        files.pop(name)
    elif kind == 3:
        for k in range(rng.choice((10, 5000))):
            listed[f"textures/{k}.png"] = listed[name]
    else:
        other = text(rng, ("scene.json", "ledger.json", "a/b/c/d.png"))
        models = payload["models"]
        models[next(iter(models))][rng.choice(("mesh", "texture"))] = other


_CHANGES = (
    _texture, _texture, _picture, _mesh, _mesh, _xml, _many, _crowd, _parts, _listed, _listed,
)  # fmt: skip


def _disturbed(place: Path, rng: random.Random) -> None:
    """Replace a file by an unusual entry, or add one beside it."""
    names = sorted(p for p in place.rglob("*") if p.is_file())
    path = rng.choice(names)
    kind = rng.randrange(5)
    if kind < 4:
        path.unlink()
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.symlink_to(rng.choice(("/dev/zero", "../../precious/file.txt", path.name)))
    elif kind == 2:
        path.mkdir()
    elif kind == 4:
        (place / rng.choice(("extra", "ledger.json", ".hidden", "\x1b[2J"))).symlink_to("/dev/zero")


# ----------------------------------------------------------------------------------------- running
def _run(place: Path, rng: random.Random) -> Run:
    """Return a function that reads a bundle in every way, and may simulate valid ones."""
    simulate, show, stored = rng.random() < _SIMULATED, rng.random() < 0.15, rng.random() < 0.05
    store = str(place.parent)

    def run() -> bool:
        import assets_cache

        if show:
            accepts(lambda: load(place), lambda: load_segments(place))
            command("inspect", str(place), *(["--json"] if simulate else []))
        if stored:
            with mock.patch.object(assets_cache.store, "_SHIPPED", ()):  # which are sound
                assets_cache.verify(store)
                accepts(lambda: assets_cache.find("toy", store))
        good = accepts(lambda: load_pictures(place), lambda: load_picture(place, "reference"))
        if verify(place) or not good:
            return False
        return _simulated(place) if simulate else True

    return run


def _simulated(place: Path) -> bool:
    from tabletopgen_env.env import make_env

    def play() -> None:
        env = make_env(place, task="Reach")
        env.reset(seed=0)
        env.step(env.action_space.sample())
        env.close()

    def preview() -> None:
        from generator.method.figures import preview as drawn

        drawn(load(place))

    def compile_again() -> None:  # loading compiles
        scene = load(place)
        compile_spec(scene_spec(scene), scene.name)

    return accepts(compile_again, lambda: _judged(place), play, preview)


def _judged(place: Path) -> None:
    if not judge(load(place)).passed:
        raise BundleError("its gate fails")
