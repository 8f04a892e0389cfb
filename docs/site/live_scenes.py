"""A Sphinx extension: scenes that run in the reader's browser, in frames of the pages.

A comment ``<!-- live: SCENE -->`` becomes the scene's frame, ``<!-- live: SCENE TASK -->`` a frame
that plays an episode of the task once it is opened. Elsewhere, as on a code host, nothing shows.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from html import escape
from pathlib import Path
from typing import Any

SCENES = ("dining-family", "kitchen-cutting", "tidy-task-1")
"""Shipped tables that the pages show."""

FOLDER = "live"
"""Where they are in the built site."""

_COMMENT = re.compile(r"^<!-- live: ([a-z0-9-]+)(?: (\w+))? -->$", re.MULTILINE)
_STYLE = "width:100%;aspect-ratio:4/3;border:0;border-radius:.5rem"


def frame(scene: str, task: str | None, up: str) -> str:
    """Return the Markdown of a frame; ``up`` leads from the page to the site's first folder."""
    assert scene in SCENES, f"add {scene!r} to SCENES of docs/site/live_scenes.py"
    shown = "/".join([scene, task] if task else [scene])
    what = f"The expert at {task}, live" if task else f"The table {scene}, live"
    made = (
        f'<iframe title="{escape(what)}" loading="lazy" style="{_STYLE}" '
        f'src="{up}{FOLDER}/index.html#/embed/{shown}"></iframe>'
    )
    if task:
        made = f"<details><summary>Watch an episode live</summary>\n{made}\n</details>"
    return f"```{{raw}} html\n{made}\n```"


def replace_comments(app: Any, name: str, source: list[str]) -> None:
    """Put frames in place of the comments of a page."""
    up = "../" * name.count("/")
    source[0] = _COMMENT.sub(lambda found: frame(found[1], found[2], up), source[0])


def write_scenes(app: Any, exception: Exception | None) -> None:
    """Put the viewer and its scenes into the built site."""
    if exception is not None or app.builder.format != "html":
        return
    import assets_cache
    from tabletopgen_web.page.options import FolderOptions
    from tabletopgen_web.page.site import write_site

    bundles = [path for scene in SCENES for path in assets_cache.find(scene)]
    options = FolderOptions(formats=(), episodes=8)
    write_site(bundles, Path(app.outdir) / FOLDER, "Live tables", options)


def setup(app: Any) -> Mapping[str, bool]:
    """Connect to Sphinx, after the pages are generated."""
    app.connect("source-read", replace_comments, priority=900)
    app.connect("build-finished", write_scenes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
