"""Properties of the studio, interpretation of a prompt, and cost of a job."""

from __future__ import annotations

import asyncio

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from generator.scene.provenance import versions

from ..contracts import BackendRow, EstimateRow, ExplainedRow, Explanation, RoleRow, StudioState
from ..fields import Fields
from ..queue.jobs import QUEUE_LIMIT
from ..server.bodies import read_json
from ..server.services import StudioServices, services_of
from ..specs import FORMATS, MOST_TEXT, read_spec
from .responses import answer


async def get_state(request: Request) -> Response:
    """Return the properties and capabilities of this studio."""
    services = services_of(request)
    last = services.store.last_event
    return answer(await asyncio.to_thread(_describe, services, last))


async def explain_text(request: Request) -> Response:
    """Return the interpretation of a prompt, phrase by phrase."""
    fields = Fields(await read_json(request), "The body")
    text, seed = fields.text("text", MOST_TEXT, multiline=True), fields.seed()
    fields.end()
    return answer(await asyncio.to_thread(_explain, text, seed))


async def estimate_job(request: Request) -> Response:
    """Return the first requests that a job would send to servers, and their cost; send nothing."""
    services, asked = services_of(request), await read_json(request)
    spec = await asyncio.to_thread(read_spec, asked)
    await asyncio.to_thread(services.check_begins, spec)
    found = await services.estimate(asked)
    roles = tuple(RoleRow(**role) for role in found["roles"])
    return answer(EstimateRow(roles, tuple(found["calls"]), found["asks_servers"]))


def _describe(services: StudioServices, last_event: int) -> StudioState:
    import assets_cache
    from generator.backends.availability import list_backends
    from generator.backends.select import PROTOCOLS
    from tabletopgen_env.tasks.names import NAMES

    backends = tuple(
        BackendRow(b.name, b.roles, b.needs, b.lacks, b.charges, not b.lacks)
        for b in list_backends()
    )
    return StudioState(
        versions(("tabletopgen",))["tabletopgen"], tuple(PROTOCOLS), backends, FORMATS, NAMES,
        str(assets_cache.user_root()), str(services.folder.root), services.workers, QUEUE_LIMIT,
        last_event,
    )  # fmt: skip


def _explain(text: str, seed: int) -> Explanation:
    from generator.language.explanation import explain, summarize

    rows = tuple(ExplainedRow(r.role, r.phrase, r.meaning) for r in explain(text, seed))
    return Explanation(summarize(text, seed), rows)


ROUTES = (
    Route("/api/state", get_state, methods=["GET"]),
    Route("/api/explain", explain_text, methods=["POST"]),
    Route("/api/estimate", estimate_job, methods=["POST"]),
)
