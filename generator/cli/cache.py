"""The ``cache`` commands: list, check and remove bundles of the store."""

from __future__ import annotations

import fnmatch
from typing import Annotated

import tyro
from tyro.conf import Positional, arg

from ..errors import escape
from . import inspection
from .output import emit, some

app = tyro.extras.SubcommandApp()


@app.command(name="list")
def list_bundles(
    pattern: Annotated[Positional[str], arg(metavar="[PATTERN]")] = "*",
    /,
    *,
    json: bool = False,
) -> int:
    """List the bundles that can be loaded by name.

    These are the shipped bundles, those in TABLETOPGEN_CACHE and those in the user cache.

    Args:
        pattern: Glob pattern for the names.
        json: Print a JSON array instead of lines.
    """
    import assets_cache

    entries = [p for p in assets_cache.entries() if fnmatch.fnmatchcase(p.name, pattern)]
    emit([str(p) for p in entries], json, lambda: [p.name for p in entries] or ["no bundles"])
    return 0


@app.command(name="rm")
def remove(
    bundles: Annotated[Positional[tuple[str, ...]], arg(metavar="BUNDLE [BUNDLE ...]")], /
) -> int:
    """Remove bundles from the user cache.

    Args:
        bundles: Names, digests or glob patterns.
    """
    import assets_cache

    for path in [p for wanted in some(bundles) for p in assets_cache.find(wanted)]:
        assets_cache.remove(path)
        print(escape(f"removed {path.name}"))
    return 0


@app.command(name="verify")
def verify_all(*, json: bool = False) -> int:
    """Check every bundle in the store.

    Args:
        json: Print a JSON object instead of lines.
    """
    import assets_cache

    return inspection.verify_all(assets_cache.entries(), json, may_vanish=True)
