"""The ``studio`` command."""

from __future__ import annotations

import os
import secrets
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from generator.errors import BackendError, InputError, escape, require_number

if TYPE_CHECKING:
    from ..study.page_data import StudyPage

_MAX_STUDIES = 16
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
    """Serve a local web page to create, edit and view tables.

    The page is accessible only from this machine and only with the token in the printed address.
    Jobs wait in a queue that persists when the studio stops.

    Args:
        port: Port of the server; 0 for any free port.
        host: Address of the server. Addresses other than the default let other machines connect.
        folder: Folder for jobs, pictures and new scenes; by default the user state folder.
        workers: Number of jobs that run at a time.
        study: Pages from `study new` with --post '/api/studies/{study}/answers', at most 16. The
            studio prints an address for the raters of each, which gives access to nothing else.
        browser: Open the address in a browser, besides printing it.
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

    require_number("--port", port, minimum=0, maximum=65535, integer=True)
    require_number("--workers", workers, minimum=1, maximum=64, integer=True)
    if not host.strip():
        raise InputError("--host must be an address of this machine.")
    studies = _read_studies(study)
    place = StudioFolder.usual() if folder is None else StudioFolder(folder.absolute())
    static = static_folder()
    with place.locking(), bind(host, port) as listening:
        open_database(place.database).close()  # report errors in the studies first
        tokens = {name: place.make_token(name) for name in studies}
        number, ticket = listening.getsockname()[1], secrets.token_urlsafe(24)
        access = Access(
            host, number, secrets.token_urlsafe(24), tokens, ticket if browser else None
        )
        if not access.is_local:
            print(escape(
                f"warning: {host} accepts unencrypted connections from other machines; anyone "
                f"with the token can use this studio and its paid services."
            ), file=sys.stderr)  # fmt: skip
        place.announce(access.address)
        changes = Changes()
        app = make_application(place, access, static, workers, changes, studies)
        busy = serve(app, listening, access, browser, changes.close)
    if busy:  # a thread would keep the process alive; the work writes files atomically
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)
    return 0


def _read_studies(paths: tuple[Path, ...]) -> dict[str, StudyPage]:
    """Return the pages of studies by study id."""
    from ..study.page_data import read_page, read_template

    if len(paths) > _MAX_STUDIES:
        raise InputError(f"--study got {len(paths)} files; the maximum is {_MAX_STUDIES}.")
    template = read_template() if paths else ""
    found: dict[str, StudyPage] = {}
    for path in paths:
        page = read_page(path, template, _POST)
        if page.study in found:
            raise InputError(f"{str(path)!r} belongs to study {page.study}, which was already "
            f"given. Pass each study once.")  # fmt: skip
        found[page.study] = page
    return found
