"""Methods' results: bundles or pictures in folders, matched by their input picture."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from generator.errors import InputError, choices

from .design import MAX_SCENES, Drawing
from .pictures import ENDINGS, decode, digest_of, encode, read_picture

ABOVE = ".above"
"""File suffix of a plain picture's view from above: ``desk.above.png`` beside ``desk.png``."""

_MAX_ENTRIES = 5000  # maximum number of entries of a folder


@dataclass(frozen=True, eq=False)
class FoundResult:
    """A method's result before rendering: a bundle, or a plain picture.

    ``stem`` is the scene's name in the method's folder; ``digest`` is that of the bundle's input
    picture, None if it has none.
    """

    path: Path
    stem: str
    bundle: bool
    digest: str | None = None


@dataclass(frozen=True, eq=False)
class RatedScene:
    """An input picture with the ``digest`` of its pixels, and each method's pictures (all JPEG)."""

    name: str
    digest: str
    picture: bytes
    results: Mapping[str, tuple[bytes, ...]]


@dataclass(frozen=True, eq=False)
class _Input:
    """An input picture, either a file or part of a bundle."""

    stem: str
    digest: str
    path: Path
    bundle: bool

    def read(self) -> UInt8[np.ndarray, "h w 3"]:
        found = _reference(self.path) if self.bundle else read_picture(self.path)
        if found is None or digest_of(found) != self.digest:
            raise InputError(f"{str(self.path)!r} changed during the collection. Try again.")
        return found


def collect(
    folders: Mapping[str, Path], inputs: Path | None, drawing: Drawing
) -> tuple[list[RatedScene], list[str]]:
    """Return the scenes for which all methods have results, and the paths that were ignored.

    A scene is one input picture. A bundle is matched to its input picture by the pixels; a plain
    picture, or a bundle without an input picture, by the stem. The input pictures come from
    ``inputs``, or else from the bundles.

    Raises:
        InputError: a folder or a picture is invalid, a result has no input picture, or a method has
            no result or several results for a scene.
        BundleError: a bundle is damaged.
    """
    ignored: list[str] = []
    found = {method: _find(folder, ignored) for method, folder in folders.items()}
    known = _read_inputs(inputs, ignored) if inputs is not None else _inputs_of(found)
    placed: dict[str, dict[str, FoundResult]] = defaultdict(dict)
    for method, results in found.items():
        for result in results:
            digest = _input_of(method, result, known).digest
            other = placed[digest].setdefault(method, result)
            if other is not result:
                raise InputError(
                    f"{method} has two results for one input picture, {str(other.path)!r} and "
                    f"{str(result.path)!r}. Remove one of them."
                )
    used = [one for one in known if one.digest in placed]
    ignored += [f"{one.stem} (no method has a result)" for one in known if one not in used]
    _check_complete(used, placed, list(folders))
    return [
        _draw(one, placed[one.digest], list(folders), drawing) for one in _rename(used)
    ], ignored


def _rename(inputs: Sequence[_Input]) -> list[_Input]:
    """Return inputs with distinct names, since bundles of different pictures may share a name."""
    stems = [one.stem for one in inputs]
    return [
        one if stems.count(one.stem) == 1 else replace(one, stem=f"{one.stem}-{one.digest[:6]}")
        for one in inputs
    ]


def _find(folder: Path, ignored: list[str]) -> list[FoundResult]:
    """Return the results in a folder, which may be a bundle; add other paths to ``ignored``."""
    if (folder / "scene.json").is_file():
        return [_read_bundle(folder)]
    results = []
    for path in _entries(folder):
        stem, ending = path.stem, path.suffix.lower()
        if path.is_dir() and (path / "scene.json").is_file():
            results.append(_read_bundle(path))
        elif path.is_file() and ending in ENDINGS:
            if not stem.endswith(ABOVE):
                results.append(FoundResult(path, stem, False))
        else:
            ignored.append(str(path))
    if not results:
        raise InputError(
            f"{str(folder)!r} contains no results. Add bundles, or a picture SCENE.png of each "
            f"scene."
        )
    return results


def _entries(folder: Path) -> list[Path]:
    """Return the visible entries of a folder, sorted by name."""
    try:
        found = sorted(p for p in folder.iterdir() if not p.name.startswith("."))
    except OSError as error:
        raise InputError(
            f"{str(folder)!r} cannot be read: {error.strerror or error}. Pass a folder."
        ) from error
    if len(found) > _MAX_ENTRIES:
        raise InputError(f"{str(folder)!r} has more than {_MAX_ENTRIES} entries, the maximum.")
    return found


def _read_bundle(path: Path) -> FoundResult:
    reference = _reference(path)
    digest = None if reference is None else digest_of(reference)
    return FoundResult(path, _bundle_stem(path), True, digest)


def _reference(path: Path) -> UInt8[np.ndarray, "h w 3"] | None:
    """Return a bundle's input picture, or None if it has none."""
    from generator.bundle import load_pictures

    raw = load_pictures(path).get("reference")
    return None if raw is None else decode(raw, f"{path}: reference.png")


def _bundle_stem(path: Path) -> str:
    """Return a bundle's name without its digest."""
    name, dash, digest = path.resolve().name.rpartition("-")
    return name if dash and len(digest) == 12 else path.resolve().name


def _read_inputs(folder: Path, ignored: list[str]) -> list[_Input]:
    known: dict[str, _Input] = {}
    for path in _entries(folder):
        if not (path.is_file() and path.suffix.lower() in ENDINGS):
            ignored.append(str(path))
            continue
        one = _Input(path.stem, digest_of(read_picture(path)), path, False)
        if (other := known.setdefault(one.digest, one)) is not one:
            raise InputError(
                f"{str(path)!r} is the same picture as {other.stem!r}; remove one of them."
            )
    stems = [one.stem for one in known.values()]
    if twice := next((s for s in stems if stems.count(s) > 1), None):
        raise InputError(f"{str(folder)!r} has two pictures named {twice!r}; rename one of them.")
    if not known:
        raise InputError(f"--inputs {str(folder)!r} contains no pictures. Add SCENE.png files.")
    return list(known.values())


def _inputs_of(found: Mapping[str, Sequence[FoundResult]]) -> list[_Input]:
    """Return the distinct input pictures of bundles, each named after its first bundle."""
    known: dict[str, _Input] = {}
    for result in (result for results in found.values() for result in results):
        if (digest := result.digest) is not None:
            known.setdefault(digest, _Input(result.stem, digest, result.path, True))
    if not known:
        raise InputError(
            "None of the results includes its input picture. Pass a folder of input pictures that "
            "have the names of the results, with --inputs."
        )
    return list(known.values())


def _input_of(method: str, result: FoundResult, known: Sequence[_Input]) -> _Input:
    same = [one for one in known if one.digest == result.digest]
    same = same or [one for one in known if one.stem == result.stem]
    if len(same) != 1:
        several = "several input pictures have this name" if same else "no input picture fits"
        raise InputError(
            f"{str(result.path)!r} of {method} matches no scene: {several}."
            + choices(result.stem, {one.stem for one in known})
            + " Rename it, or pass a folder of input pictures as --inputs."
        )
    return same[0]


def _check_complete(
    used: Sequence[_Input], placed: Mapping[str, Mapping[str, FoundResult]], methods: Sequence[str]
) -> None:
    missing = [f"{m} lacks {one.stem}" for one in used for m in methods
               if m not in placed[one.digest]]  # fmt: skip
    if missing:
        more = f", and {len(missing) - 10} more" if len(missing) > 10 else ""
        raise InputError(
            f"Every method needs a result for every scene: {', '.join(missing[:10])}{more}. Add "
            "the missing results, or remove the other methods' results for those scenes. Bundles "
            "of one scene with different input pictures are matched by name if --inputs gives the "
            "pictures."
        )
    if len(used) > MAX_SCENES:
        raise InputError(f"There are {len(used)} scenes; the maximum is {MAX_SCENES}.")


def _draw(
    one: _Input, results: Mapping[str, FoundResult], methods: Sequence[str], drawing: Drawing
) -> RatedScene:
    shown = {m: tuple(encode(p, drawing.side) for p in _views(results[m], drawing))
             for m in methods}  # fmt: skip
    return RatedScene(one.stem, one.digest, encode(one.read(), drawing.side), shown)


def _views(result: FoundResult, drawing: Drawing) -> Iterator[UInt8[np.ndarray, "h w 3"]]:
    """Yield a result's picture from the input picture's camera and, optionally, one from above."""
    if not result.bundle:
        yield read_picture(result.path)
        if drawing.above:
            yield read_picture(_above(result.path))
        return
    from generator.bundle import load
    from generator.render.sheet import TOP_DOWN, render_scene

    scene, side = load(result.path), max(drawing.side, 128)
    width, height = side, side * 3 // 4
    yield render_scene(scene, None, width, height).image
    if drawing.above:
        yield render_scene(scene, TOP_DOWN, width, height).image


def _above(path: Path) -> Path:
    names = [f"{path.stem}{ABOVE}{ending}" for ending in ENDINGS]
    there = [path.with_name(n) for n in names if path.with_name(n).is_file()]
    if not there:
        raise InputError(
            f"{str(path)!r} has no picture from above. Add {names[0]!r} beside it, or omit --above."
        )
    return there[0]
