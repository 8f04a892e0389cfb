"""Uploaded pictures."""

from __future__ import annotations

import asyncio

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from ..library.pictures import MAX_BYTES
from ..server.bodies import read_body
from ..server.cancellation import run_while_wanted
from ..server.services import services_of
from .responses import answer, answer_picture


async def add_picture(request: Request) -> Response:
    """Store the picture from the request's body."""
    services = services_of(request)
    async with services.uploads:
        data = await read_body(request, MAX_BYTES)
        row = await run_while_wanted(
            request, services.changes, lambda cancelled: services.pictures.add(data, cancelled)
        )
        return answer(row, 201)


async def get_picture(request: Request) -> Response:
    """Return a picture as PNG, upright and reduced to the size used for processing."""
    shelf = services_of(request).pictures
    return answer_picture(await asyncio.to_thread(shelf.read_shown, request.path_params["picture"]))


ROUTES = (
    Route("/api/pictures", add_picture, methods=["POST"]),
    Route("/api/pictures/{picture}", get_picture, methods=["GET"]),
)
