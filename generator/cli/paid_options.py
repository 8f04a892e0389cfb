"""Options shared by commands that use backends: roles, calls and prices."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from tyro.conf import OmitArgPrefixes, arg

from ..backends import Backends, Mix, paid_run
from ..calls import Session
from ..calls.money.prices import Prices
from ..calls.store import CallStore
from ..errors import DryRunError, escape
from .output import emit

Chosen = OmitArgPrefixes[Annotated[Mix, arg(name="backend")]]
"""Type of a command's argument with these options."""

USUAL, NOBODY = Mix(), Mix(backend=None)
"""Defaults of commands that always generate, and of commands that can work without backends."""


def lines_of(roles: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """Return the lines of text for ``roles_of``, one per role."""
    lines = []
    for role, facts in roles.items():
        settings = ", ".join(f"{k}={v}" for k, v in facts.items() if k != "name" and v != "")
        lines.append(f"{role:<10} {facts['name']}" + (f" ({settings})" if settings else ""))
    return lines


@dataclass(frozen=True)
class CallOptions:
    """Cost limit of server requests, and the cache of their responses.

    Attributes:
        budget: Maximum total cost of the calls, including earlier runs of the same command. For a
            batch it covers all workers and all runs in its folder.
        dry_run: Send nothing to servers and make nothing; print the backend of each role and the
            first calls that would be made.
        calls: Folder of cached responses, so that none is billed twice; defaults to
            TABLETOPGEN_CALLS or the user cache.
        prices: Price table (TOML); defaults to the shipped one.
    """

    budget: float | None = None
    dry_run: bool = False
    calls: Path | None = None
    prices: Path | None = None

    def table(self) -> Prices:
        """Return the price table; raise InputError if the file is unusable."""
        return Prices.default() if self.prices is None else Prices.load(self.prices)

    def session(self) -> Session:
        """Return a session with these settings."""
        store = CallStore(paid_run.calls_folder(self.calls))
        return Session(store, prices=self.table(), budget=self.budget, dry=self.dry_run)


Calls = OmitArgPrefixes[CallOptions]
"""Type of a command's argument with these options."""

NO_CALLS = CallOptions()


@contextmanager
def answering(session: Session, scene: str) -> Iterator[None]:
    """Wrap ``paid_run.answering``; print the costs of a failed command on standard error."""
    with paid_run.answering(session, scene, lambda text: print(escape(text), file=sys.stderr)):
        yield


def print_dry_run(
    error: DryRunError, as_json: bool, mix: Mix = USUAL, backends: Backends | None = None
) -> int:
    """Print the backends and the result of a dry run; return exit code 0."""
    roles = {} if backends is None else paid_run.roles_of(mix, backends)
    calls = str(error).splitlines()
    rest = "Nothing was sent; later calls depend on the answers."
    if not calls:
        rest = (
            "No server would be called. Nothing was made; run without --dry-run to make the scene."
        )
    facts = {"dry_run": calls} | ({"backends": roles} if roles else {})
    emit(facts, as_json, lambda: [*lines_of(roles), *calls, rest])
    return 0
