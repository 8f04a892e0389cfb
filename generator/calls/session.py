"""State and settings that all calls of one generation share."""

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
    """A thread-safe session that caches, records, limits and retries the calls of one generation.

    ``store``: the cache of answers; None disables caching.
    ``account``: the ledger of the calls; ``resume`` adds earlier runs.
    ``prices``: prices of models.
    ``budget``: maximum total cost, in the currency of ``prices``. A call that might exceed it is
    not sent; estimates are conservative. None means no limit.
    ``workers``: maximum number of concurrent work items.
    ``attempts``: maximum number of attempts per call.
    ``dry``: send nothing; the first call that the store cannot answer raises DryRunError.
    ``stop``: once set, waiting and unsent calls raise StoppedError, and so do calls in flight that
    do not end within ``grace``.
    ``retry_policy``: waits between attempts.
    ``grace``: seconds after ``stop`` or Ctrl-C in which calls in flight may finish, so that their
    answers are stored. A second Ctrl-C ends them immediately.

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
        """Return an HTTP client whose calls this session caches, records, limits and retries.

        The client calls the origin of ``base_url`` only. Internal headers, which are not sent,
        describe a request: ``x-tabletopgen-question`` (a protocol's method),
        ``x-tabletopgen-model``, and ``x-tabletopgen-memo``, which is "no" for an answer that
        changes (such as the state of a job) and "renew" if the stored answer is no longer of use.
        ``x-tabletopgen-meant`` replaces the body in the key of the call store, for different bodies
        that ask the same question or equal bodies that do not. ``x-tabletopgen-free`` is "yes" for
        requests without cost (such as the state of a job), regardless of the price table. Only
        standard HTTP headers and ``headers`` are sent. Responses with status 2xx, or with a 4xx
        that no retry can fix, are returned with their key (``store.KEY``); all other outcomes raise
        BackendError.

        Args:
            server: name of the server in messages and in the ledger.
            base_url: the common http or https prefix of all paths.
            timeout: maximum duration of one attempt in seconds.
            most_bytes: maximum size of a response.
            secrets: strings that messages must not contain. Keys belong in headers, never in a URL;
                if secrets are given, headers with other keys are not sent.
            headers: additional headers that may be sent, in lower case.
            sign: returns the headers that sign a request, computed for each attempt.

        Raises:
            BackendError: the extra is not installed, or the URL is invalid or contains a password.
            UnusableError: raised by calls if the response is a web page or too large.
        """
        try:
            import httpx2

            from .transport import PaidTransport
        except ImportError as error:
            raise BackendError(
                f"{server} is called over HTTP, which needs {error.name}. Run: {EXTRA}"
            ) from error
        checked_address(base_url, f"{server}: its address")
        transport = PaidTransport(
            self, server, base_url, timeout, most_bytes, secrets, headers, sign,
            # loaded now, because loading takes longer than the timeout of some calls
            trust=self.trust,
        )  # fmt: skip
        return httpx2.Client(
            base_url=base_url, transport=transport, timeout=timeout, trust_env=False
        )

    def resume(self, scene: str, keeper: Keeper = LOCAL) -> Spending | None:
        """Load the spending of a scene's earlier runs, and add this run's calls to the record.

        Call this before any other call. Returns the record, which ``keeper`` accesses in the
        database next to the stored answers, or None if the session has no store.

        Raises:
            StorageError: the recorded spending cannot be read.
            InputError: earlier spending is in a currency other than that of ``prices``.
        """
        if self.store is None:
            return None
        spending = Spending(self.store.folder, scene, self.prices.currency, keeper)
        self.account.resume(spending, self.prices)
        return spending

    @functools.cached_property
    def trust(self) -> ssl.SSLContext:
        """The certificates that verify servers, cached because reading them is slow."""
        import httpx2

        return httpx2.create_ssl_context()

    def each(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Return the result of ``work`` for each item, in order, with up to ``workers`` at a time.

        The first error stops items that wait or have not started, and is raised once the others
        have ended; answers received until then are in the store. Ctrl-C gives running items
        ``grace`` seconds; a second Ctrl-C gives them none. A dry run tries all items and reports
        all calls in one error.
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
            except BaseException:  # an interrupt, or the end of the enclosing work
                halted.set()
                deadline.bring_forward(self._announce_grace())
                try:
                    wait(futures)
                finally:  # also after a second interrupt
                    deadline.bring_forward(time.monotonic())
                raise
        return _results(futures)


def _results(futures: Sequence[Future[R]]) -> list[R]:
    """Return the results, or raise the first error, preferably one other than StoppedError."""
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
