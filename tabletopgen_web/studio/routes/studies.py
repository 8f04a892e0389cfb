"""Answers of studies."""

from __future__ import annotations

import asyncio

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from ..library.answers import MOST_BYTES
from ..server.bodies import read_json
from ..server.services import services_of
from .answering import answer


async def add_answer(request: Request) -> Response:
    """Keep a rater's answer: an object with the id of who gave it in ``rater``."""
    services, said = services_of(request), await read_json(request, MOST_BYTES)
    async with services.writing:
        count = await asyncio.to_thread(
            services.answers.add, request.path_params["study"], said.get("rater", ""), said
        )
    return answer({"answers": count}, 201)


async def list_answers(request: Request) -> Response:
    """The answers of a study, by rater."""
    study = request.path_params["study"]
    return answer({"study": study, "answers": await asyncio.to_thread(
        services_of(request).answers.read, study)})  # fmt: skip


ROUTES = (
    Route("/api/studies/{study}/answers", add_answer, methods=["POST"]),
    Route("/api/studies/{study}/answers", list_answers, methods=["GET"]),
)
