"""Dry run of a job: nothing is sent or created."""

from __future__ import annotations

from typing import Any

from generator.errors import DryRunError

from ..specs import EditSpec, GenerateSpec, read_spec
from .order import JobOrder, Telling
from .scenes import open_session, run_edit, run_generate


def estimate(order: JobOrder, telling: Telling) -> dict[str, Any]:
    """Return the backend of each role, and a line for each of the first calls to servers."""
    spec = read_spec(order.request)
    if not isinstance(spec, GenerateSpec | EditSpec) or not spec.paid.mix.given:
        return {"roles": [], "calls": [], "asks_servers": False}
    from generator.backends.paid_run import roles_of

    session = open_session(spec.paid, dry=True)
    chosen = spec.paid.mix.select(session)
    roles = [
        {"role": role, "backend": facts.pop("name"), "settings": facts}
        for role, facts in roles_of(spec.paid.mix, chosen).items()
    ]
    calls: list[str] = []
    if chosen.asks_servers():
        try:
            if isinstance(spec, GenerateSpec):
                run_generate(spec, order, None, session, chosen)
            else:
                run_edit(spec, order, session, chosen)
        except DryRunError as error:
            calls = str(error).splitlines()
    return {"roles": roles, "calls": calls, "asks_servers": chosen.asks_servers()}
