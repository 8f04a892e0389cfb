"""The ``page`` command, which creates a static page of bundles."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

from tyro import conf
from tyro.conf import OmitArgPrefixes, Positional

from generator.errors import InputError, escape
from generator.io.files import check_folder

from .options import FolderOptions

_CONTENTS = FolderOptions()


def page(
    bundles: Annotated[Positional[tuple[str, ...]], conf.arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    out: Path,
    title: str = "Tables",
    contents: OmitArgPrefixes[FolderOptions] = _CONTENTS,
) -> int:
    """Create a static page of bundles: a gallery, and an interactive view of every scene.

    The page simulates with MuJoCo's WebAssembly and works on any static host: upload the folder, or
    run `python -m http.server` in it. It loads no external resources.

    Args:
        bundles: Names, digests, globs or paths; "starter" for the shipped tables.
        out: The page's folder. An existing page is replaced.
        title: Title of the gallery.
        contents: Content per scene.
    """
    import assets_cache

    from .site import write_site

    if not bundles:
        raise InputError("Specify at least one bundle; `tabletopgen cache list` lists them.")
    if contents.episodes < 0:
        raise InputError(f"--episodes must be at least 0, got {contents.episodes}.")
    check_folder(out.absolute().parent)
    found = list(dict.fromkeys(p for wanted in bundles for p in assets_cache.find(wanted)))
    with _progress(len(found)) as report:
        site = write_site(found, out, title, contents, report)
    print(escape(str(site.path)))
    for row in site.scenes:
        if row.error is not None:
            print(escape(f"  {row.id} is listed, but cannot be shown: {row.error}"))
    shown = sum(row.error is None for row in site.scenes)
    print(
        f"  {shown} scene{'s' * (shown != 1)}, {site.bytes / 1e6:.1f} MB; to view them: python -m "
        f"http.server --directory {escape(str(out))}"
    )
    return 0 if shown else 1


@contextmanager
def _progress(scenes: int) -> Iterator[Callable[[str, str], None]]:
    """Show the number of finished scenes on standard error."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("starting", total=scenes)
        seen: list[str] = []

        def report(scene: str, what: str) -> None:
            if scene not in seen:
                seen.append(scene)
            bar.update(task, completed=len(seen) - 1, description=escape(f"{scene}: {what}"))

        yield report
