"""The command ``studio``."""

from __future__ import annotations

import os
import secrets
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from generator.errors import BackendError, InputError, escape, require_number

if TYPE_CHECKING:
    from ..study.page_data import StudyPage

_MOST_STUDIES = 16
_POST = "/api/studies/{study}/answers"


def studio(
    *,
    port: int = 0,
    host: str = "127.0.0.1",
    folder: Path | None = None,
    workers: int = 1,
    study: tuple[Path, ...] = (),
    browser: bool = True,
) -> int:
    """Open a page of this machine to make, change and look at tables.

    The page is served to this machine alone, and to those that know the token in the printed
    address. Jobs wait in a queue that outlives the studio.

    Args:
        port: Where it listens; 0 for any port that is free.
        host: Another address than this machine's own lets other machines in.
        folder: Where jobs, pictures and new scenes are kept; the user state folder if left out.
        workers: How many jobs run at a time.
        study: Pages that `study new` wrote with --post '/api/studies/{study}/answers'; for each an
            address for raters is printed, which opens nothing else. At most 16.
        browser: Open the address in a browser; it is printed, too.
    """
    try:
        import starlette  # noqa: F401
        import uvicorn  # noqa: F401
    except ImportError as error:
        raise BackendError(
            f"The studio needs the package {error.name}: pip install 'tabletopgen[studio]'."
        ) from error
    from ..frontend import static_folder
    from .folder import StudioFolder
    from .queue.database import open_database
    from .server.application import make_application
    from .server.changes import Changes
    from .server.guard import Access
    from .server.listener import bind, serve

    require_number("studio needs --port", port, minimum=0, maximum=65535, integer=True)
    require_number("studio needs --workers", workers, minimum=1, maximum=64, integer=True)
    if not host.strip():
        raise InputError("studio needs --host, an address of this machine.")
    studies = _read_studies(study)
    place = StudioFolder.usual() if folder is None else StudioFolder(folder.absolute())
    static = static_folder()
    with place.locking(), bind(host, port) as listening:
        open_database(place.database).close()  # what is wrong with it is said before all else
        tokens = {name: place.make_token(name) for name in studies}
        number, ticket = listening.getsockname()[1], secrets.token_urlsafe(24)
        access = Access(
            host, number, secrets.token_urlsafe(24), tokens, ticket if browser else None
        )
        if not access.is_local:
            print(escape(
                f"warning: {host} lets other machines in, unencrypted; whoever knows the token can "
                "use this studio and what it may pay for."
            ), file=sys.stderr)  # fmt: skip
        place.announce(access.address)
        changes = Changes()
        app = make_application(place, access, static, workers, changes, studies)
        busy = serve(app, listening, access, browser, changes.close)
    if busy:  # a thread would keep the process; it puts files in place whole, or not at all
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)
    return 0


def _read_studies(paths: tuple[Path, ...]) -> dict[str, StudyPage]:
    """Return the pages of studies, by study."""
    from ..study.page_data import read_page, read_template

    if len(paths) > _MOST_STUDIES:
        raise InputError(f"--study names {len(paths)} files; at most {_MOST_STUDIES} are served.")
    template = read_template() if paths else ""
    found: dict[str, StudyPage] = {}
    for path in paths:
        page = read_page(path, template, _POST)
        if page.study in found:
            raise InputError(f"{str(path)!r} is of study {page.study}, which is there already. "
                             "Name each study once.")  # fmt: skip
        found[page.study] = page
    return found
