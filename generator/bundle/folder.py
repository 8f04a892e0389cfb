"""Bundles: scenes stored as folders that anyone can load, and functions to save and load them.

``<name>-<digest12>/`` contains ``scene.json`` (the source of truth: every value, the report, and
the size and sha256 of each file), ``scene.xml`` (derived; loads in plain MuJoCo), ``meshes/``,
``textures/`` and pictures. A bundle is *published or absent* (``publication``). The digest is that
of ``scene.json``, which refers to all other files by content, so the same scene gives the same
folder, byte for byte.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import os
import re
import stat
from collections.abc import Generator, Mapping
from pathlib import Path, PurePosixPath
from typing import Any, Literal

import numpy as np
from jaxtyping import UInt8

from ..errors import BundleError, InputError, SceneError, StorageError, TabletopError
from ..io.pictures import encode_png
from ..physics.mjcf import document
from ..physics.spec import compile_spec, spec_of
from ..scene import Scene
from .bounds import BOUNDS, check_listed
from .contents import decode_png, picture_size
from .decoder import decode_scene, loads
from .derived import check_builds, check_starts, check_xml
from .encoder import dumps, encode_scene
from .publication import publish, steady
from .segments import PATH as SEGMENTS_PATH
from .segments import Segments, decode_segments, encode_segments

SCHEMA = 1
"""Version of ``scene.json``; other versions are rejected."""

BESIDE = frozenset({"certificate.json", "grasps.json", "ledger.json"})
"""Files in a bundle's folder that need not be listed in ``scene.json``."""

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
_FOLDER = re.compile(r".*-([0-9a-f]{12})")
_PICTURE = re.compile(r"[a-z][a-z0-9_]*")


def save(
    scene: Scene,
    folder: str | Path,
    *,
    images: Mapping[str, UInt8[np.ndarray, "h w c"] | bytes] | None = None,
    segments: Segments | None = None,
    allow_failed: bool = False,
) -> Path:
    """Publish ``scene`` as a bundle in ``folder``, which is created if missing; return its path.

    Numbers are rounded (lengths to 0.1 micrometre) when written. ``images`` maps file stems
    ("reference", "preview", ...) to pictures, as pixels or PNG bytes; ``segments`` are the
    detections in the reference picture, if there was one. ``allow_failed`` publishes a scene even
    if its report failed or is missing.

    Raises:
        SceneError: the report failed or is missing, or a picture is not a PNG or is too large to be
            read back.
        StorageError: the folder cannot be written, or the disk is full.
    """
    _check_publishable(scene, allow_failed)
    files = dict(_picture(stem, image) for stem, image in (images or {}).items())
    payload, meshes = encode_scene(scene)
    files |= meshes
    if segments is not None:
        payload["instances"], files[SEGMENTS_PATH] = encode_segments(segments)
    rounded = decode_scene(payload, files.__getitem__)
    files["scene.xml"] = document(rounded.scene, paths=rounded.paths).xml.encode()
    listed = {name: _fingerprint(content) for name, content in sorted(files.items())}
    truth = dumps({"schema": SCHEMA, **payload, "files": listed})
    digest = hashlib.sha256(truth).hexdigest()[:12]
    try:
        files["scene.json"] = truth
        return publish(Path(folder), f"{scene.name}-{digest}", files, beside=BESIDE)
    except OSError as error:
        raise StorageError(
            f"The bundle of {scene.name!r} cannot be written to {folder}: "
            f"{error.strerror or error}. Free disk space, or choose another folder."
        ) from error


@steady
def load(path: str | Path) -> Scene:
    """Read a bundle, and check every file against its recorded size and hash.

    The returned scene can be simulated: MuJoCo has built its bodies, and ``scene.xml`` matches it.

    Raises:
        BundleError: there is no bundle, or it is damaged, unsafe, out of bounds, or from another
            schema.
    """
    folder = Path(path)
    return _read(folder, read_truth(folder))


@steady
def load_segments(path: str | Path) -> Segments | None:
    """Read the detections in a bundle's reference picture; return None if the bundle has none.

    Raises:
        BundleError: there is no bundle, or this part of it is damaged.
    """
    folder = Path(path)
    return _read_segments(folder, read_truth(folder))


@steady
def load_picture(path: str | Path, stem: str) -> UInt8[np.ndarray, "h w 3"] | None:
    """Read and check a bundle's picture ("reference", ...); return None if it is missing.

    Raises:
        BundleError: there is no bundle, or the picture is damaged.
    """
    folder = Path(path)
    listed = read_truth(folder)["files"]
    name = f"{stem}.png"
    if name not in listed:
        return None
    return decode_png(read_listed(folder, name, listed[name]), name)


@steady
def load_pictures(path: str | Path) -> dict[str, bytes]:
    """Read and check all pictures in a bundle, as PNG bytes by stem.

    Raises:
        BundleError: there is no bundle, or a picture is damaged.
    """
    folder = Path(path)
    listed = read_truth(folder)["files"]
    names = [name for name in listed if "/" not in name and name.endswith(".png")]
    return {n.removesuffix(".png"): read_listed(folder, n, listed[n]) for n in names}


@steady
def load_verified(path: str | Path) -> Scene:
    """Read a bundle as ``load`` does, build its visual geoms in MuJoCo, and read its segments.

    Raises:
        BundleError: there is no bundle, or it is invalid.
    """
    return _read_all(Path(path))[0]


def verify(path: str | Path) -> list[str]:
    """Return the problems of a bundle on disk, or an empty list; see :func:`check`."""
    try:
        return check(path)
    except BundleError as error:
        return [str(error)]
    except OSError as error:
        return [f"{path} cannot be read: {error.strerror or error}."]


@steady
def check(path: str | Path) -> list[str]:
    """Check a bundle as ``load_verified`` does; return its files that ``scene.json`` does not list.

    Raises:
        MissingError: there is no bundle.
        BundleError: it is damaged.
    """
    folder = Path(path)
    listed = {*_read_all(folder)[1]["files"], "scene.json"}
    found = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if not p.is_dir()}
    return [
        f"{folder} contains {name}, which scene.json does not list"
        for name in sorted(found - listed - BESIDE)
    ]


def check_name(name: str) -> None:
    """Check that ``name`` is a valid name for a scene and its folder.

    Raises:
        SceneError: it is not a valid folder name.
    """
    if not _NAME.fullmatch(name) or len(name) > 80:
        raise SceneError(
            f"The scene name {name!r} is not a valid folder name; use at most 80 letters, digits, "
            "'.', '_' and '-'."
        )


# ----------------------------------------------------------------------------------------- writing


def _check_publishable(scene: Scene, allow_failed: bool) -> None:
    check_name(scene.name)
    if allow_failed:
        return
    if scene.report is None:
        raise SceneError(
            f"Scene {scene.name!r} has no report. Create one with generator.physics.gate.judge."
        )
    if not scene.report.passed:
        raise SceneError(
            f"Scene {scene.name!r} failed its physical gate: {scene.report.failure_text}. Pass "
            "allow_failed=True to publish it anyway."
        )


def _picture(stem: str, image: UInt8[np.ndarray, "h w c"] | bytes) -> tuple[str, bytes]:
    """Return the name and content of a picture's file after checking that it can be read back."""
    if not _PICTURE.fullmatch(stem):
        raise SceneError(
            f"The picture name {stem!r} is invalid; use lower-case letters, digits and '_'."
        )
    name, content = f"{stem}.png", image if isinstance(image, bytes) else encode_png(image)
    try:
        picture_size(content, name)
    except BundleError as error:
        raise SceneError(f"{error} Pass a smaller picture, or a PNG.") from error
    return name, content


def _fingerprint(content: bytes) -> dict[str, Any]:
    return {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()}


# ----------------------------------------------------------------------------------------- reading


def read_truth(folder: Path) -> dict[str, Any]:
    """Return the content of ``scene.json`` after checking it."""
    try:
        there = folder.is_dir()
    except OSError as error:
        raise BundleError(f"{folder} cannot be read: {error.strerror}.") from error
    if not there:
        raise BundleError(f"There is no bundle at {folder}.")
    raw = read_inside(folder, "scene.json", BOUNDS.truth_bytes)
    payload = loads(raw, str(folder))
    schema = payload.get("schema")
    if schema != SCHEMA or type(schema) is not int:
        raise BundleError(
            f"{folder} has schema {schema!r}; this version reads schema {SCHEMA}. "
            "Install a matching tabletopgen, or make the bundle again."
        )
    if dumps(payload) != raw:
        raise BundleError(f"{folder}: scene.json was changed after it was written.")
    named = _FOLDER.fullmatch(folder.resolve().name)
    if named and named[1] != hashlib.sha256(raw).hexdigest()[:12]:
        raise BundleError(
            f"{folder}: the digest of scene.json is not the one in the folder's name."
        )
    try:
        check_listed(payload.get("files"))
    except BundleError as error:
        raise BundleError(f"{folder}: {error}") from error
    return payload


def _read_all(folder: Path) -> tuple[Scene, dict[str, Any]]:
    """Read and check everything in a bundle; return the scene and the content of ``scene.json``."""
    payload = read_truth(folder)
    scene = _read(folder, payload, visuals=True)
    _read_segments(folder, payload)
    return scene, payload


def _read_segments(folder: Path, payload: dict[str, Any]) -> Segments | None:
    if "instances" not in payload:
        return None
    if SEGMENTS_PATH not in payload["files"]:
        raise BundleError(f"{folder}: scene.json has instances, but does not list {SEGMENTS_PATH}.")
    raw = read_listed(folder, SEGMENTS_PATH, payload["files"][SEGMENTS_PATH])
    return decode_segments(payload["instances"], raw)


def _read(folder: Path, payload: dict[str, Any], visuals: bool = False) -> Scene:
    """Read and check all files of a bundle; ``visuals`` also builds the visual geoms in MuJoCo."""
    contents = _contents(folder, payload["files"])

    def file(name: str) -> bytes:
        if name not in contents:
            raise BundleError(f"scene.json refers to {name[:200]!r}, which it does not list.")
        return contents[name]

    try:
        decoded = decode_scene(payload, file)
        scene = decoded.scene
        check_name(scene.name)
        xml = check_xml(decoded, file("scene.xml"))
        if visuals:
            model = check_builds(decoded, xml, contents)
        else:
            model = compile_spec(spec_of(document(scene, visuals=False), scene.name), scene.name)
        check_starts(model, scene.name)
    except (BundleError, InputError, SceneError) as error:
        raise BundleError(f"{folder}: {error}") from error
    return scene


def _contents(folder: Path, listed: Mapping[str, Any]) -> dict[str, bytes]:
    """Check every listed file; return the contents of those that make up the scene."""
    contents: dict[str, bytes] = {}
    for name, entry in listed.items():
        content = read_listed(folder, name, entry)
        if name.startswith(("meshes/", "textures/")) or name == "scene.xml":
            contents[name] = content
        elif name.endswith(".png"):
            picture_size(content, f"{folder}: {name}")
    return contents


def read_listed(folder: Path, name: str, entry: Any) -> bytes:
    """Read one listed file and compare it with its entry in ``scene.json``.

    Raises:
        BundleError: the file is missing, or differs from its entry.
    """
    content = read_inside(folder, name, entry["bytes"])
    if _fingerprint(content) != entry:
        raise BundleError(f"{folder}: {name} was changed after it was written.")
    return content


def read_inside(
    folder: Path,
    name: str,
    limit: int,
    error: type[TabletopError] = BundleError,
    kind: Literal["bundle", "folder"] = "bundle",
) -> bytes:
    """Read a regular file of at most ``limit`` bytes in ``folder``; reject links and ``..``.

    ``kind`` is what messages call the folder.

    Raises:
        TabletopError: ``error``, if the file is missing, too large, or not inside the folder.
    """
    path, hint = (
        PurePosixPath(name),
        " Create or copy the bundle again." if kind == "bundle" else "",
    )
    if not name.isprintable():
        raise error(f"{folder}: {name!r} is not a valid file name.")
    if path.is_absolute() or ".." in path.parts or "\\" in name or ":" in name or not path.parts:
        raise error(f"{folder}: the path {name!r} leaves the {kind}; it was not opened.")
    try:
        with _opened_inside(folder, path) as descriptor:
            status = os.fstat(descriptor)
            if not stat.S_ISREG(status.st_mode):
                raise error(f"{folder}: {name} is not a regular file.")
            if status.st_size > limit:
                wanted = f", not {limit}" if kind == "bundle" else f"; at most {limit} are allowed"
                raise error(f"{folder}: {name} has {status.st_size} bytes{wanted}.")
            with open(descriptor, "rb", closefd=False) as file:
                return file.read(limit + 1)
    except FileNotFoundError as failure:
        raise error(f"{folder}: {name} is missing.{hint}") from failure
    except OSError as failure:
        if failure.errno == errno.ELOOP or (failure.errno == errno.ENOTDIR and folder.is_dir()):
            raise error(
                f"{folder}: {name} is a link, or lies in a linked folder; only regular files are "
                "read."
            ) from failure
        raise error(f"{folder}: {name} cannot be read: {failure.strerror}.") from failure


@contextlib.contextmanager
def _opened_inside(folder: Path, path: PurePosixPath) -> Generator[int, None, None]:
    """Open a file in ``folder`` step by step, so that no part of its path can become a link."""
    flags = os.O_RDONLY | os.O_CLOEXEC
    with contextlib.ExitStack() as opened:
        place = os.open(folder, flags | os.O_DIRECTORY)
        opened.callback(os.close, place)
        for step, part in enumerate(path.parts, 1):
            kind = os.O_DIRECTORY if step < len(path.parts) else os.O_NONBLOCK
            place = os.open(part, flags | os.O_NOFOLLOW | kind, dir_fd=place)
            opened.callback(os.close, place)
        yield place
