"""Responses of the endpoints, and the files of the front end."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.types import Receive, Scope, Send

from ..contracts import encode
from ..refusals import RefusedError
from ..server.services import services_of

_TYPES: Mapping[str, str] = MappingProxyType(
    {
        ".css": "text/css; charset=utf-8",
        ".glb": "model/gltf-binary",
        ".html": "text/html; charset=utf-8",
        ".js": "text/javascript; charset=utf-8",
        ".json": "application/json",
        ".md": "text/plain; charset=utf-8",
        ".obj": "text/plain; charset=utf-8",
        ".png": "image/png",
        ".svg": "image/svg+xml",
        ".wasm": "application/wasm",
        ".woff2": "font/woff2",
        ".xml": "text/plain; charset=utf-8",
    }
)
"""Content types by file suffix; other files have none."""


def answer(value: Any, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """Return a value as a JSON response."""
    return JSONResponse(encode(value), status_code=status, headers=headers)


def answer_file(path: Path, *, attach: bool = False) -> Response:
    """Return a file response, as a download if ``attach`` is true."""
    kind = _TYPES.get(path.suffix.lower(), "application/octet-stream")
    return FileResponse(path, media_type=kind, filename=path.name if attach else None)


def answer_picture(png: bytes) -> Response:
    """Return a picture response."""
    return Response(png, media_type="image/png")


_PAGE = "studio.html"


def list_files(static: Path) -> Mapping[str, Path]:
    """Return the built files by URL path: "/" is the page.

    The page uses paths relative to itself; other clients may use paths below "/static/".
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
    """Return a file of the page, or a 404 error for any other path that is not an endpoint."""
    request = Request(scope, receive)
    path = services_of(request).files.get(scope["path"])
    if path is None or request.method not in ("GET", "HEAD"):
        raise RefusedError(404, "This path does not exist.")
    await answer_file(path)(scope, receive, send)
