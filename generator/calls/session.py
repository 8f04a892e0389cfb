"""What the calls of one generation share."""

from __future__ import annotations

import functools
import ssl
import threading
import time
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_EXCEPTION, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

from ..errors import BackendError, DryRunError, StoppedError
from .http.address import checked_address
from .http.pending import Deadline
from .money.database import LOCAL, Keeper
from .money.scene_cost import Spending
from .state import SessionState

if TYPE_CHECKING:
    import httpx2

    from .paid_call import Sign

T = TypeVar("T")
R = TypeVar("R")

EXTRA = "pip install 'tabletopgen[cloud]'"


@dataclass(frozen=True, eq=False)
class Session(SessionState):
    """Keeps, counts, bounds and repeats the calls of one generation; safe for threads.

    ``store``: where answers are kept; None keeps nothing.
    ``account``: the ledger they are entered in; ``resume`` has it know of earlier runs.
    ``prices``: what they cost.
    ``budget``: what they may cost together, in the currency of ``prices``; a call that might exceed
    it is not sent; what that may be is estimated on the high side. None for no limit.
    ``workers``: how many things are asked for at once.
    ``attempts``: how often a call is sent at most.
    ``dry``: nothing is sent: the first call that the store cannot answer raises DryRunError.
    ``stop``: once set, calls that wait or are still to be sent raise StoppedError. So do those
    under way that do not end within ``grace``.
    ``retry_policy``: how long to wait between attempts.
    ``grace``: seconds that a call under way has after ``stop``, or Ctrl-C, to be answered, so that
    the answer is kept. A second Ctrl-C ends it at once.

    Raises:
        InputError: a number is out of range.
    """

    def client(
        self,
        server: str,
        base_url: str,
        *,
        timeout: float = 120.0,
        most_bytes: int = 64 * 2**20,
        secrets: tuple[str, ...] = (),
        headers: tuple[str, ...] = (),
        sign: Sign | None = None,
    ) -> httpx2.Client:
        """Return an HTTP client whose calls this session keeps, counts, bounds and repeats.

        It speaks to the origin of ``base_url`` alone. A request says what it is for by headers that
        are not sent: ``x-tabletopgen-question`` (a protocol's method), ``x-tabletopgen-model``, and
        ``x-tabletopgen-memo``: "no" for an answer that changes (the state of a job), "renew" where
        the kept answer is of no use any more. ``x-tabletopgen-meant`` stands for the body where
        requests that differ ask the same, or that are alike do not. ``x-tabletopgen-free`` is "yes"
        for what costs nothing (a look at a job), whatever the price table has. Other headers than
        those of HTTP itself are not sent either. Answers of status 2xx, and 4xx that no wait would
        mend, are returned, with the key that they are kept under (``store.KEY``); everything else
        raises BackendError.

        Args:
            server: names the server in messages and in the ledger.
            base_url: http or https, as far as all paths have it in common.
            timeout: seconds that one attempt may take.
            most_bytes: what an answer may have at most.
            secrets: what no message may hold. Keys go into headers, never into a URL, and where
                some are given no others are sent.
            headers: more that may be sent, in lower case.
            sign: gives the headers that sign a request, for each attempt anew.

        Raises:
            BackendError: the extra is not installed, or the URL is invalid, or holds a password.
            UnusableError: by a call, of an answer that is a web page or too large.
        """
        try:
            import httpx2

            from .transport import PaidTransport
        except ImportError as error:
            raise BackendError(
                f"{server} is asked over HTTP, and {error.name} is not installed. Run: {EXTRA}"
            ) from error
        checked_address(base_url, f"{server}: its address")
        transport = PaidTransport(
            self, server, base_url, timeout, most_bytes, secrets, headers, sign,
            trust=self.trust,  # read now: it takes longer than some calls may
        )  # fmt: skip
        return httpx2.Client(
            base_url=base_url, transport=transport, timeout=timeout, trust_env=False
        )

    def resume(self, scene: str, keeper: Keeper = LOCAL) -> Spending | None:
        """Know what earlier runs of a scene spent, and write this one's calls down with theirs.

        To be called before any call. Returns where that is: in the database, on which ``keeper``
        works, beside the answers; None if none are kept.

        Raises:
            StorageError: what was spent cannot be read.
            InputError: it was in another currency than that of ``prices``.
        """
        if self.store is None:
            return None
        spending = Spending(self.store.folder, scene, self.prices.currency, keeper)
        self.account.resume(spending, self.prices)
        return spending

    @functools.cached_property
    def trust(self) -> ssl.SSLContext:
        """The certificates that servers are held against: reading them takes long, so once."""
        import httpx2

        return httpx2.create_ssl_context()

    def each(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Return ``work`` of every item, in their order, ``workers`` at a time.

        The first error stops what waits or has not begun, and is raised when the rest has ended;
        what was answered by then is in the store. Ctrl-C leaves the rest ``grace``, a second one
        nothing. In a dry run all items are tried, and one error names all calls.
        """
        if min(self.workers, len(items)) <= 1 and not self.dry:
            return [work(item) for item in items]
        halted, deadline = threading.Event(), Deadline()
        scope = (*self._halts(), halted), (*self._deadlines(), deadline)

        def one(item: T) -> R:
            self._scope.halts, self._scope.deadlines = scope
            try:
                self.check()
                return work(item)
            finally:
                self._scope.halts, self._scope.deadlines = (), ()

        with ThreadPoolExecutor(min(self.workers, len(items)) or 1) as pool:
            futures = [pool.submit(one, item) for item in items]
            try:
                if not self.dry:
                    wait(futures, return_when=FIRST_EXCEPTION)
                    if any(f.done() and f.exception() for f in futures):
                        halted.set()
                wait(futures)
            except BaseException:  # an interrupt, or the end of what this is part of
                halted.set()
                deadline.bring_forward(self._announce_grace())
                try:
                    wait(futures)
                finally:  # also of a second interrupt
                    deadline.bring_forward(time.monotonic())
                raise
        return _results(futures)


def _results(futures: Sequence[Future[R]]) -> list[R]:
    """Return the results, or raise the first item's error that is more than "stopped"."""
    errors = [error for f in futures if (error := f.exception()) is not None]
    dry = [str(error) for error in errors if isinstance(error, DryRunError)]
    if len(dry) > 1 and len(dry) == len(errors):
        raise DryRunError("\n".join(dict.fromkeys(dry)))
    for error in errors:
        if not isinstance(error, StoppedError):
            raise error
    if errors:
        raise errors[0]
    return [f.result() for f in futures]
