"""Scene makers for batches; they run in worker processes, so all of them can be pickled."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..backends import Backends, Mix
from ..calls import Session
from ..calls.money.budget import SharedBudget
from ..calls.money.database import LOCAL, Keeper
from ..calls.money.ledger import Account
from ..calls.money.prices import Prices
from ..calls.store import CallStore
from ..errors import BackendError, InputError, StorageError, require
from ..scene.provenance import plain
from ..threads import threads
from .prompts import Job
from .records import key_of, place_of

if TYPE_CHECKING:
    from ..generation import Config


@dataclass(frozen=True)
class Composing:
    """Composes scenes from texts (``generator.composition``)."""

    def identity(self) -> dict[str, Any]:
        """Return the settings that determine the scenes."""
        return {"route": "compose"}

    def __call__(self, job: Job, folder: Path) -> Path:
        """Compose the scene of a job's text."""
        from ..bundle import save
        from ..composition import compose
        from ..method.figures import preview

        scene = compose(job.text, job.seed)
        return save(scene, folder, images={"preview": preview(scene)})


@dataclass(frozen=True)
class Generating:
    """Generates scenes from texts or pictures with all stages (``generator.pipeline``).

    Attributes:
        mix: backends of the roles.
        config: settings of the stages; None for the defaults.
        calls: folder of stored answers, so that nothing is paid for twice; None stores nothing.
        prices: prices of models; None for the shipped table.
        shared_budget: record of the spending of all scenes, see ``shared_budget``; None keeps no
            record.
        budget: maximum total cost of all scenes, including earlier runs, in the currency of
            ``prices``; requires ``shared_budget``. A call that might exceed it is not sent.
        dry: send nothing; the first call whose answer is not stored raises DryRunError.
        keeper: access to the spending databases; in a cluster, through the process that owns them.

    Raises:
        BackendError: the backends are not available on this machine.
        InputError: the budget is negative or has no ``shared_budget``.
    """

    mix: Mix = field(default_factory=Mix)
    config: Config | None = None
    calls: str | None = None
    prices: Prices | None = None
    shared_budget: SharedBudget | None = None
    budget: float | None = None
    dry: bool = False
    keeper: Keeper = field(default=LOCAL, repr=False, compare=False)
    # the backends on this machine; a process elsewhere must have the same ones
    _answering: dict[str, Any] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        told = self.mix.identity()
        if set(self.mix.roles().values()) != {"embedded"}:  # such as models and addresses
            told["answering"] = plain(self.mix.select().identity())
        object.__setattr__(self, "_answering", told)
        if self.budget is not None:
            require(self, "budget", minimum=0)
            if self.shared_budget is None:
                raise InputError(
                    "The processes of a batch must share one budget. Pass "
                    "shared_budget=shared_budget(FOLDER) with the batch's folder."
                )

    def kept_by(self, keeper: Keeper) -> Generating:
        """Return a copy of this maker that accesses its databases through ``keeper``."""
        shared = self.shared_budget and replace(self.shared_budget, keeper=keeper)
        return replace(self, shared_budget=shared, keeper=keeper)

    def identity(self) -> dict[str, Any]:
        """Return the backends, their settings unless all are embedded, and the stages' settings."""
        from ..generation import Config

        config = plain(self.config or Config())
        return {"route": "generate", **self._answering, "config": config}

    def __call__(self, job: Job, folder: Path) -> Path:
        """Generate a job's scene.

        Raises:
            BudgetError: a call exceeds the budget; DryRunError: a dry run needs a call.
            BackendError: the backends on this machine differ from those where the batch was
                started.
        """
        from ..pipeline import generate

        _share()
        with self._session(job) as session:
            backends = self.mix.select(session)
            self._check_answering(backends)
            generation = generate(job.text, backends, self.config, job.seed)
            path = generation.save(folder)
            if any(entry.outcome != "cached" for entry in session.account.entries):
                session.account.save(path, session.prices)
        return path

    def _check_answering(self, backends: Backends) -> None:
        expected = self._answering.get("answering")
        if expected is None:
            return
        here = plain(backends.identity())
        roles = [role for role in expected if here.get(role) != expected[role]]
        if roles:
            raise BackendError(
                "This machine would use other backends than the machine where the batch was "
                "started: "
                f"{', '.join(f'{r} {here.get(r)} instead of {expected[r]}' for r in roles)}. Set "
                "the same environment variables on all machines."
            )

    @contextlib.contextmanager
    def _session(self, job: Job) -> Iterator[Session]:
        """Yield the call session of one scene, whose spending includes that of earlier runs."""
        with contextlib.ExitStack() as open_:
            shared = self.shared_budget
            spending = None if shared is None else open_.enter_context(shared.spending())
            session = Session(
                store=None if self.calls is None else CallStore(self.calls),
                account=Account(spending),
                prices=self.prices or Prices.default(),
                budget=self.budget,
                dry=self.dry,
            )
            try:
                session.resume(key_of(job, self), self.keeper)
            except InputError as error:  # another currency is not a failure of the scene
                raise StorageError(str(error)) from error
            yield session


def shared_budget(folder: str | Path, prices: Prices | None = None) -> SharedBudget:
    """Return the budget shared by all batches in a folder, creating it if necessary.

    Raises:
        InputError: the recorded spending is in a currency other than that of ``prices``.
        StorageError: the record cannot be read, or the folder is not writable.
    """
    return SharedBudget.open(place_of(Path(folder)), (prices or Prices.default()).currency)


def _share() -> None:
    """Limit the threads of libraries that ignore ``threads``, since other workers are running."""
    import cv2
    import torch

    torch.set_num_threads(threads())
    cv2.setNumThreads(threads())
