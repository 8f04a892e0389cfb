"""Request bodies, read up to a size limit."""

from __future__ import annotations

import asyncio
from typing import Any

from starlette.requests import Request

from generator.errors import InputError
from generator.io.bounded import parse_object

from ..refusals import RefusedError

MOST_JSON = 64 * 2**10
"""Default size limit of a JSON object, in bytes."""

_MAX_DEPTH = 16
_SECONDS = 60.0  # time limit of a body


async def read_body(request: Request, most: int) -> bytes:
    """Return the body of a request.

    Raises:
        RefusedError: the body exceeds ``most`` bytes, after which reading stops, or arrives too
            slowly.
    """
    declared = request.headers.get("content-length", "0")
    if not declared.isdecimal() or len(declared) > 18 or int(declared) > most:
        raise _excess(most)
    body = bytearray()
    try:
        async with asyncio.timeout(_SECONDS):
            async for piece in request.stream():
                if len(body) + len(piece) > most:
                    raise _excess(most)
                body += piece
    except TimeoutError as error:
        raise RefusedError(408, f"The body did not arrive within {_SECONDS:g} s.") from error
    return bytes(body)


async def read_json(request: Request, most: int = MOST_JSON) -> dict[str, Any]:
    """Return the JSON object in a request's body.

    Raises:
        RefusedError: the body is too long, or its content type is not JSON.
        InputError: the body is not a JSON object.
    """
    kind = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if kind != "application/json":
        raise RefusedError(415, "The body must be JSON, with content-type application/json.")
    raw = await read_body(request, most)
    return parse_object(raw, "The body", InputError, max_bytes=most, max_depth=_MAX_DEPTH)


def _excess(most: int) -> RefusedError:
    size = f"{most // 2**20} MiB" if most >= 2**20 else f"{most // 2**10} KiB"
    return RefusedError(413, f"The body exceeds the limit of {size}.")
