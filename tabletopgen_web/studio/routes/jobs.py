"""Jobs: add, list, cancel, resume, and remove."""

from __future__ import annotations

import asyncio
import re

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from generator.io.files import remove_tree

from ..refusals import RefusedError
from ..server.bodies import read_json
from ..server.services import services_of
from ..specs import read_spec
from .responses import answer, answer_file

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,199}")


async def list_jobs(request: Request) -> Response:
    """Return all jobs, newest first."""
    return answer({"jobs": services_of(request).store.list_jobs()})


async def add_job(request: Request) -> Response:
    """Queue a job."""
    services, asked = services_of(request), await read_json(request)
    spec = await asyncio.to_thread(read_spec, asked)
    await asyncio.to_thread(services.check_begins, spec)
    return answer(services.store.add(asked), 201)


async def get_job(request: Request) -> Response:
    """Return one job with its log."""
    return answer(services_of(request).store.get(request.path_params["job"]))


async def cancel_job(request: Request) -> Response:
    """Cancel a job; a running job ends soon after."""
    return answer(services_of(request).runner.cancel(request.path_params["job"]), 202)


async def resume_job(request: Request) -> Response:
    """Requeue a job that ended without a result."""
    return answer(services_of(request).store.resume(request.path_params["job"]), 202)


async def delete_job(request: Request) -> Response:
    """Remove a finished job with its events, figures and files; its scene is kept."""
    services, job = services_of(request), request.path_params["job"]
    services.store.delete(job)
    for folder in (services.folder.figures, services.folder.files):
        await asyncio.to_thread(remove_tree, folder, job)
    return Response(status_code=204)


async def get_figure(request: Request) -> Response:
    """Return a picture of a stage's result."""
    return _file(request, "figures", attach=False)


async def get_file(request: Request) -> Response:
    """Return an export or an episode."""
    return _file(request, "files", attach=True)


def _file(request: Request, kind: str, attach: bool) -> Response:
    services, name = services_of(request), request.path_params["name"]
    job = services.store.get(request.path_params["job"]).id
    folder = (services.folder.figures if kind == "figures" else services.folder.files) / job
    known = {p.name: p for p in folder.iterdir()} if folder.is_dir() else {}
    path = known.get(name) if _NAME.fullmatch(name) else None
    if path is None or not path.is_file():
        raise RefusedError(404, f"The job has no file {name[:120]!r}.")
    return answer_file(path, attach=attach)


ROUTES = (
    Route("/api/jobs", list_jobs, methods=["GET"]),
    Route("/api/jobs", add_job, methods=["POST"]),
    Route("/api/jobs/{job}", get_job, methods=["GET"]),
    Route("/api/jobs/{job}", delete_job, methods=["DELETE"]),
    Route("/api/jobs/{job}/cancel", cancel_job, methods=["POST"]),
    Route("/api/jobs/{job}/resume", resume_job, methods=["POST"]),
    Route("/api/jobs/{job}/figures/{name}", get_figure, methods=["GET"]),
    Route("/api/jobs/{job}/files/{name}", get_file, methods=["GET"]),
)
