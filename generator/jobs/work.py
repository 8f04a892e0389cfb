"""How the scenes of a batch are made: what runs in its processes. All of it can be pickled."""

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
    """Composes texts (``generator.composition``)."""

    def identity(self) -> dict[str, Any]:
        """Return that it composes."""
        return {"route": "compose"}

    def __call__(self, job: Job, folder: Path) -> Path:
        """Compose a job's text."""
        from ..bundle import save
        from ..composition import compose
        from ..method.figures import preview

        scene = compose(job.text, job.seed)
        return save(scene, folder, images={"preview": preview(scene)})


@dataclass(frozen=True)
class Generating:
    """Generates scenes from texts or pictures by all stages (``generator.pipeline``).

    Attributes:
        mix: who answers the stages' questions.
        config: settings of the stages; None for the usual ones.
        calls: folder where answers are kept, so that nothing is paid for twice; None keeps nothing.
        prices: what calls of servers cost; None: the table that comes with the package.
        shared_budget: what all scenes are paid from, see ``shared_budget``; None adds up nothing.
        budget: what all scenes may cost together, those of earlier runs too, in the currency of
            ``prices``; needs ``shared_budget``. A call that might exceed it is not sent.
        dry: nothing is sent: the first call that is not kept raises DryRunError.
        keeper: who works on the databases of money: over several machines, a process owning them.

    Raises:
        BackendError: the backends cannot be selected here.
        InputError: a budget that is not shared, or negative.
    """

    mix: Mix = field(default_factory=Mix)
    config: Config | None = None
    calls: str | None = None
    prices: Prices | None = None
    shared_budget: SharedBudget | None = None
    budget: float | None = None
    dry: bool = False
    keeper: Keeper = field(default=LOCAL, repr=False, compare=False)
    # who answers as of where this was made; a process elsewhere has to agree
    _answering: dict[str, Any] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        told = self.mix.identity()
        if set(self.mix.roles().values()) != {"embedded"}:  # models and addresses, say
            told["answering"] = plain(self.mix.select().identity())
        object.__setattr__(self, "_answering", told)
        if self.budget is not None:
            require(self, "budget", minimum=0)
            if self.shared_budget is None:
                raise InputError(
                    "Generating needs a shared budget, which processes spend together. Give "
                    "shared_budget=shared_budget(FOLDER) of the batch's folder."
                )

    def kept_by(self, keeper: Keeper) -> Generating:
        """Return this maker, its databases of money worked on by ``keeper``."""
        shared = self.shared_budget and replace(self.shared_budget, keeper=keeper)
        return replace(self, shared_budget=shared, keeper=keeper)

    def identity(self) -> dict[str, Any]:
        """Return backends, their settings unless all are embedded, and the stages' settings."""
        from ..generation import Config

        config = plain(self.config or Config())
        return {"route": "generate", **self._answering, "config": config}

    def __call__(self, job: Job, folder: Path) -> Path:
        """Generate a job's scene.

        Raises:
            BudgetError: it cannot be afforded; DryRunError: it would have asked a server.
            BackendError: here others would answer than where the batch was started.
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
                f"{' and '.join(roles)} would be another here than where the batch was started: "
                f"{', '.join(f'{here.get(r)} instead of {expected[r]}' for r in roles)}. Set the "
                "same environment variables on all machines."
            )

    @contextlib.contextmanager
    def _session(self, job: Job) -> Iterator[Session]:
        """Yield the session of one scene, which knows what earlier runs spent on it."""
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
            except InputError as error:  # of another currency: no fault of the scene's
                raise StorageError(str(error)) from error
            yield session


def shared_budget(folder: str | Path, prices: Prices | None = None) -> SharedBudget:
    """Return the budget that all batches in a folder spend from, begun if there is none.

    Raises:
        InputError: what was spent there is in another currency than ``prices``.
        StorageError: it cannot be read, or the folder not be written.
    """
    return SharedBudget.open(place_of(Path(folder)), (prices or Prices.default()).currency)


def _share() -> None:
    """Have libraries that do not heed it themselves keep to ``threads``: others work beside it."""
    import cv2
    import torch

    torch.set_num_threads(threads())
    cv2.setNumThreads(threads())
