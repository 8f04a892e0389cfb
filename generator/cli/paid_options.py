"""What commands that ask backends share: who answers, which calls are sent, at what price."""

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
"""The type of a command's argument that makes these options."""

USUAL, NOBODY = Mix(), Mix(backend=None)
"""What commands use unless told otherwise: those that generate, and that can do without."""


def lines_of(roles: Mapping[str, Mapping[str, Any]]) -> list[str]:
    """Return ``roles_of`` as a line for each role."""
    lines = []
    for role, facts in roles.items():
        settings = ", ".join(f"{k}={v}" for k, v in facts.items() if k != "name" and v != "")
        lines.append(f"{role:<10} {facts['name']}" + (f" ({settings})" if settings else ""))
    return lines


@dataclass(frozen=True)
class CallOptions:
    """What requests to servers may cost, and where usable responses are cached.

    Attributes:
        budget: The most that the calls may cost; those of earlier runs of the same command
            are counted. A batch counts all runs into its folder, and all its workers.
        dry_run: Send nothing to servers and make nothing; print who answers what, and the first
            calls that would be made.
        calls: Folder of cached responses, so that none is billed twice; TABLETOPGEN_CALLS, else
            the user cache, if left out.
        prices: Price table (TOML); the shipped one if left out.
    """

    budget: float | None = None
    dry_run: bool = False
    calls: Path | None = None
    prices: Path | None = None

    def table(self) -> Prices:
        """Return the price table; InputError if the file cannot be used."""
        return Prices.default() if self.prices is None else Prices.load(self.prices)

    def session(self) -> Session:
        """Return a session with these settings."""
        store = CallStore(paid_run.calls_folder(self.calls))
        return Session(store, prices=self.table(), budget=self.budget, dry=self.dry_run)


Calls = OmitArgPrefixes[CallOptions]
"""The type of a command's argument that makes these options."""

NO_CALLS = CallOptions()


@contextmanager
def answering(session: Session, scene: str) -> Iterator[None]:
    """Do as ``backends.paying.answering``; what a failed command cost goes to standard error."""
    with paid_run.answering(session, scene, lambda text: print(escape(text), file=sys.stderr)):
        yield


def print_dry_run(
    error: DryRunError, as_json: bool, mix: Mix = USUAL, backends: Backends | None = None
) -> int:
    """Print who answers, and what a dry run came to; return the exit code of success."""
    roles = {} if backends is None else paid_run.roles_of(mix, backends)
    calls = str(error).splitlines()
    rest = "Nothing was sent; what comes after depends on the answers."
    if not calls:
        rest = "No server would be asked. Nothing was made; leave out --dry-run for that."
    facts = {"dry_run": calls} | ({"backends": roles} if roles else {})
    emit(facts, as_json, lambda: [*lines_of(roles), *calls, rest])
    return 0
