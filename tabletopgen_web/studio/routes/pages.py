"""The page itself: files that were listed once, when the studio began."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from starlette.requests import Request
from starlette.types import Receive, Scope, Send

from ..refusals import RefusedError
from ..server.services import services_of
from .answering import answer_file

_PAGE = "studio.html"


def list_files(static: Path) -> Mapping[str, Path]:
    """Return the built files by the paths of their URLs: "/" is the page.

    The page names its scripts relative to itself, others may name them below "/static/".
    """
    found = {"/": static / _PAGE}
    for path in sorted(static.rglob("*")):
        if path.is_file() and not path.is_symlink():
            name = path.relative_to(static).as_posix()
            found[f"/static/{name}"] = path
            if path.suffix != ".html":
                found[f"/{name}"] = path
    return found


async def show(scope: Scope, receive: Receive, send: Send) -> None:
    """Answer with a file of the page; what is asked for besides, and is no endpoint, is nowhere."""
    request = Request(scope, receive)
    path = services_of(request).files.get(scope["path"])
    if path is None or request.method not in ("GET", "HEAD"):
        raise RefusedError(404, "There is nothing at this path.")
    await answer_file(path)(scope, receive, send)
