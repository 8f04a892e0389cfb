"""Study pages, and raters' answers."""

from __future__ import annotations

import asyncio

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from ...study.answers import MAX_ANSWER_BYTES
from ..refusals import RefusedError
from ..server.bodies import read_json
from ..server.services import services_of
from .responses import answer


async def show_study(request: Request) -> Response:
    """Return the page of a study, with a security policy that allows only the page's code."""
    page = services_of(request).studies.get(request.path_params["study"])
    if page is None:
        raise RefusedError(404, "This study is not served; pass its file with --study.")
    return Response(
        page.content,
        media_type="text/html; charset=utf-8",
        headers={"content-security-policy": page.policy},
    )


async def add_answer(request: Request) -> Response:
    """Store a rater's answer: an object with the rater's id in ``rater``.

    Answers to a served study must be complete, and lower limits apply to them.
    """
    services, payload = services_of(request), await read_json(request, MAX_ANSWER_BYTES)
    study = request.path_params["study"]
    page = services.studies.get(study)
    if page is not None:
        await asyncio.to_thread(page.check, payload)
    async with services.writing:
        count = await asyncio.to_thread(
            services.answers.add, study, payload.get("rater", ""), payload, shared=page is not None
        )
    return answer({"answers": count}, 201)


async def list_answers(request: Request) -> Response:
    """Return the answers to a study, grouped by rater."""
    study = request.path_params["study"]
    return answer({"study": study, "answers": await asyncio.to_thread(
        services_of(request).answers.read, study)})  # fmt: skip


ROUTES = (
    Route("/study/{study}", show_study, methods=["GET"]),
    Route("/api/studies/{study}/answers", add_answer, methods=["POST"]),
    Route("/api/studies/{study}/answers", list_answers, methods=["GET"]),
)
