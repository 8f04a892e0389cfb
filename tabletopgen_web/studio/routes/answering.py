"""Answers of the endpoints."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from starlette.responses import FileResponse, JSONResponse, Response

from ..contracts import encode

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
"""Types of files by the end of their names; of others the browser is told nothing."""


def answer(value: Any, status: int = 200, headers: Mapping[str, str] | None = None) -> Response:
    """Return a value as JSON."""
    return JSONResponse(encode(value), status_code=status, headers=headers)


def answer_file(path: Path, *, attach: bool = False) -> Response:
    """Return a file, as an attachment that is saved if ``attach``."""
    kind = _TYPES.get(path.suffix.lower(), "application/octet-stream")
    return FileResponse(path, media_type=kind, filename=path.name if attach else None)


def answer_picture(png: bytes) -> Response:
    """Return a picture."""
    return Response(png, media_type="image/png")
