"""The application: endpoints, error responses, and background tasks."""

from __future__ import annotations

import asyncio
import contextlib
import logging
from collections.abc import AsyncIterator, Mapping
from pathlib import Path

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response
from starlette.routing import Route
from starlette.types import ASGIApp

from generator.errors import TabletopError

from ...study.page_data import StudyPage
from ..folder import StudioFolder
from ..queue.jobs import JobStore
from ..refusals import status_of
from ..routes import events, info, jobs, pictures, responses, scenes, studies
from ..routes.responses import answer
from .cancellation import EndingRequests
from .changes import Changes
from .guard import Access, StudioGuard
from .services import StudioServices

_LOG = logging.getLogger(__name__)

ROUTES: tuple[Route, ...] = (
    *info.ROUTES, *jobs.ROUTES, *events.ROUTES, *pictures.ROUTES, *scenes.ROUTES,
    *studies.ROUTES,
)  # fmt: skip
"""The endpoints; all other paths are files of the page."""


def make_application(
    folder: StudioFolder,
    access: Access,
    static: Path,
    workers: int = 1,
    changes: Changes | None = None,
    studies: Mapping[str, StudyPage] | None = None,
) -> ASGIApp:
    """Return the studio's application. The caller must hold the lock of the folder.

    Args:
        folder: the data folder.
        access: the access control.
        static: the folder of the built page.
        workers: number of jobs that run at a time.
        changes: notifier, closed when the studio ends so that pages stop waiting for events.
        studies: pages for raters by study; ``access`` has their tokens.
    """
    files, changes = responses.list_files(static), changes or Changes()

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        folder.make()
        store = JobStore(folder.database)
        with contextlib.closing(store):
            services = StudioServices(folder, workers, files, store, changes, studies or {})
            app.state.services = services
            store.recover()
            services.sweep()
            running = asyncio.create_task(services.runner.run())
            try:
                yield
            finally:
                running.cancel()
                with contextlib.suppress(asyncio.CancelledError):
                    await running

    app = Starlette(
        routes=list(ROUTES),
        lifespan=lifespan,
        middleware=[Middleware(EndingRequests, changes=changes)],
        exception_handlers={
            TabletopError: _refuse, HTTPException: _refuse_route, OSError: _refuse_disk,
            ClientDisconnect: _give_up, Exception: _fail,
        },
    )  # fmt: skip
    app.router.redirect_slashes = False
    app.router.default = responses.show
    return StudioGuard(app, access)


async def _refuse(request: Request, error: Exception) -> Response:
    assert isinstance(error, TabletopError)
    status = status_of(error)
    if status == 500:
        return await _fail(request, error)
    refused = answer({"error": str(error)}, status)
    if status in (408, 413):
        refused.headers["connection"] = "close"  # the rest of the body is not read
    return refused


async def _refuse_route(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    if error.status_code == 405:
        return answer({"error": f"Method {request.method} not allowed."}, 405, error.headers)
    return answer({"error": str(error.detail)}, error.status_code, error.headers)


async def _refuse_disk(request: Request, error: Exception) -> Response:
    assert isinstance(error, OSError)
    _LOG.warning("Disk error: %s", error)
    return answer({"error": f"Disk error: {error.strerror or error}."}, 507)


async def _give_up(request: Request, error: Exception) -> Response:
    return answer({"error": "The request was cut off."}, 400)


async def _fail(request: Request, error: Exception) -> Response:
    _LOG.error("%s %s failed", request.method, request.url.path, exc_info=error)
    return answer({"error": "Internal error of the studio; see its terminal."}, 500)
