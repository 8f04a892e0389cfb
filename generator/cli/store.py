"""Which bundle a user means, and where new ones go."""

from __future__ import annotations

from pathlib import Path

from ..errors import InputError
from ..io.files import check_folder


def store(out: Path | None) -> Path:
    """Return the folder that new bundles go into, checked: ``out``, else the user cache."""
    import assets_cache

    if out is None:
        return assets_cache.user_root()
    check_folder(out)
    return out


def find(wanted: str) -> list[Path]:
    """Return the bundles that a name, digest, glob or path means; at least one."""
    import assets_cache

    return list(assets_cache.find(wanted))


def some(bundles: tuple[str, ...]) -> tuple[str, ...]:
    """Return the names a user gave, refusing none at all."""
    if not bundles:
        raise InputError("Name at least one bundle; `tabletopgen cache list` shows what there is.")
    return bundles


def one(wanted: str) -> Path:
    """Return the only bundle that ``wanted`` means."""
    found = find(wanted)
    if len(found) > 1:
        names = ", ".join(p.name for p in found[:8])
        raise InputError(f"{wanted!r} fits {len(found)} bundles: {names}. Name one.")
    return found[0]
