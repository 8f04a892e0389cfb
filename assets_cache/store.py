"""Search, addition and removal of bundles."""

from __future__ import annotations

import fnmatch
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import platformdirs

from generator.errors import BundleError, InputError, MissingError, StorageError, choices

if TYPE_CHECKING:
    from generator.scene import Scene

STARTER = "starter"
"""The argument of :func:`find` that selects the shipped bundles for any task."""

_VARIABLE = "TABLETOPGEN_CACHE"  # names a folder of bundles
_STARTERS = Path(__file__).parent / "starter"
_SHIPPED = (_STARTERS, Path(__file__).parent / "tasks")
_DIGEST = re.compile(r"[0-9a-f]{6,12}")
_BUNDLE = re.compile(r"(?P<name>.+)-(?P<digest>[0-9a-f]{12})")


def user_root(cache: str | Path | None = None) -> Path:
    """Return the folder for new bundles: ``cache``, TABLETOPGEN_CACHE, or the user's cache."""
    chosen = cache or os.environ.get(_VARIABLE)
    return Path(chosen) if chosen else Path(platformdirs.user_cache_dir("tabletopgen")) / "scenes"


def roots(cache: str | Path | None = None) -> tuple[Path, ...]:
    """Return the existing folders to search, in order of precedence."""
    wanted = [cache, os.environ.get(_VARIABLE), *_SHIPPED, user_root(cache)]
    paths = dict.fromkeys(Path(p) for p in wanted if p)
    return tuple(p for p in paths if p.is_dir())


def entries(cache: str | Path | None = None) -> list[Path]:
    """Return the store's bundles by name; for equal names, the first folder takes precedence."""
    found = {path.name: path for root in reversed(roots(cache)) for path in _bundles(root)}
    return [found[name] for name in sorted(found)]


def find(wanted: str | Path, cache: str | Path | None = None) -> list[Path]:
    """Return the bundles that match ``wanted``, sorted by folder name.

    Args:
        wanted: a scene's name, a folder's name, a digest or its first 6 digits, a glob on folder
            names ("office*"), the path of a bundle or of a folder of bundles (a single word such as
            "tables" is looked up as a name first), a glob of bundles' paths, or "starter" for the
            shipped tables for any task; those for one task have names ("kitchen-task-*").
        cache: a folder of bundles to search first.

    Raises:
        MissingError: no bundle matches; the message gives the nearest match and the existing names.
    """
    text = str(wanted)
    if text == STARTER:
        found = list(_bundles(_STARTERS))
    elif not text.strip():  # such as an unset variable; must not mean the current folder
        found = []
    else:
        found = _bundles_of(text, cache) or _in_folder(text)
    if not found:
        places = ", ".join(str(p) for p in roots(cache)) or "any folder"
        names = {_stem(path) for path in entries(cache)}
        raise MissingError(f"No bundle matches {text!r} in {places}." + choices(text, names))
    return sorted(found, key=lambda p: p.name)


def add(scene: Scene, cache: str | Path | None = None, **options: Any) -> Path:
    """Add a scene to the store; ``options`` are those of ``generator.bundle.save``."""
    from generator.bundle import save

    return save(scene, user_root(cache), **options)


def remove(wanted: str | Path, cache: str | Path | None = None) -> Path:
    """Remove one bundle; return its path.

    Raises:
        MissingError: ``wanted`` matches no bundle, or another process removed it.
        BundleError: ``wanted`` matches several bundles.
        StorageError: the bundle is not in the user's store, or cannot be removed.
    """
    text = str(wanted)
    found = find(wanted, cache)
    if text != STARTER and not _bundles_of(text, cache):
        raise BundleError(f"{text!r} is a folder of bundles. Specify one bundle.")
    if len(found) > 1:
        names = ", ".join(p.name for p in found[:8])
        raise BundleError(f"{wanted!r} matches {len(found)} bundles: {names}. Specify one of them.")
    path, root = found[0], user_root(cache)
    check_removable(path, root)
    if not _discard(path):
        raise MissingError(f"There is no bundle at {path}: another process removed it.")
    return path


def check_removable(path: Path, root: Path) -> None:
    """Check that a bundle may be removed from the store folder ``root``.

    Raises:
        StorageError: the bundle is not in ``root``, or ships with the package.
    """
    if path.resolve().parent != root.resolve() or _ships(root):
        raise StorageError(
            f"{path} is not in the store {root}; only bundles in the store can be removed."
        )


def check_own(path: Path) -> None:
    """Check that a bundle is writable.

    Raises:
        InputError: the bundle ships with the package.
    """
    if _ships(path.resolve().parent):
        raise InputError(
            f"{path} ships with the package and is read-only. Copy its folder elsewhere, and pass "
            f"the path of the copy."
        )


def clear(cache: str | Path | None = None) -> int:
    """Remove every bundle of the user's store (see :func:`user_root`); return their number.

    Raises:
        StorageError: the folder contains something other than bundles; nothing is removed.
    """
    from generator.bundle import sweep

    root = user_root(cache)
    if not root.is_dir():
        return 0
    found = list(_bundles(root))
    foreign = sorted({p.name for p in root.iterdir() if not p.name.startswith(".staging-")}
                     - {p.name for p in found})  # fmt: skip
    if foreign or _ships(root):
        raise StorageError(
            f"{root} must contain only your own bundles, but contains "
            f"{foreign[:5] or 'the shipped bundles'}. Nothing was removed. Remove bundles "
            "individually, or choose another folder."
        )
    sweep(root)
    return sum(_discard(path) for path in found)


def verify(cache: str | Path | None = None) -> dict[str, list[str]]:
    """Return the defects of each bundle in the store, by folder name; an empty list means none.

    Bundles that are removed in the meantime are omitted.
    """
    from generator.bundle import check

    reasons: dict[str, list[str]] = {}
    for path in entries(cache):
        try:
            reasons[path.name] = check(path)
        except MissingError:
            continue
        except (BundleError, OSError) as error:
            reasons[path.name] = [str(error)]
    return reasons


def _ships(root: Path) -> bool:
    """Return whether a folder holds the bundles of the package."""
    return root.resolve() in {place.resolve() for place in _SHIPPED}


def _bundles(root: Path) -> Iterator[Path]:
    if root.is_dir():
        for path in sorted(root.iterdir()):
            if _BUNDLE.fullmatch(path.name) and (path / "scene.json").is_file():
                yield path


def _bundles_of(text: str, cache: str | Path | None) -> list[Path]:
    """Return the bundles that match a path, a glob or a name, except those inside a folder."""
    return _by_path(text) or _by_name(text, entries(cache))


def _by_path(text: str) -> list[Path]:
    """Return the bundles at a path, or those that match a glob of paths."""
    try:
        path = Path(text).expanduser()
        if (path / "scene.json").is_file():
            return [path]
        if path.is_dir() or (len(path.parts) < 2 and not text.startswith("./")):  # else a name
            return []
        anchor = Path(path.anchor)
        pattern = str(path.relative_to(anchor))
        return [p for p in sorted(anchor.glob(pattern)) if (p / "scene.json").is_file()]
    except (OSError, ValueError, RuntimeError):  # too long, "a/**b", or the home of an unknown user
        return []


def _in_folder(text: str) -> list[Path]:
    """Return the bundles in a folder, or an empty list if it does not exist."""
    try:
        return list(_bundles(Path(text).expanduser()))
    except (OSError, ValueError, RuntimeError):
        return []


def _by_name(text: str, known: list[Path]) -> list[Path]:
    exact = [p for p in known if text in (p.name, _stem(p))]
    digest = [p for p in known if _DIGEST.fullmatch(text) and p.name[-12:].startswith(text)]
    return exact or digest or [p for p in known if fnmatch.fnmatchcase(p.name, text)]


def _stem(path: Path) -> str:
    named = _BUNDLE.fullmatch(path.name)
    return named["name"] if named else path.name


def _discard(path: Path) -> bool:
    """Remove a bundle; return False if another process has already removed it."""
    from generator.bundle import discard

    try:
        return discard(path)
    except OSError as error:
        raise StorageError(f"{path} cannot be removed: {error.strerror or error}.") from error
