"""A maker of tiny scenes that logs its work, and fails as its texts demand."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from bounded import until
from calls.paid_server import ask, session
from toy import toy_object, toy_scene

from generator import bundle
from generator import jobs as batch
from generator.calls.money.budget import SharedBudget
from generator.calls.money.database import Keeper
from generator.calls.money.ledger import Account
from generator.errors import InputError
from generator.scene import Provenance, Report
from generator.threads import threads


@dataclass(frozen=True)
class ToyMaker:
    """Makes a cube for any text; ``log`` gets a line for each scene that is begun.

    "bad ..." cannot be read, "broken ..." is a fault of the code, "deadly ..." ends the process,
    "half ..." leaves something unfinished and waits for the file ``log``.go, "paid ..." asks the
    server at ``url``, which costs 0.021 and at most 0.04, of the ``shared`` budget of ``budget``,
    "wide ..." notes in the file ``log``.threads on how many threads it may compute.
    """

    log: str
    url: str = ""
    shared: SharedBudget | None = None
    budget: float | None = None

    def identity(self) -> dict[str, Any]:
        return {"route": "toy"}

    def kept_by(self, keeper: Keeper) -> ToyMaker:
        return replace(self, shared=self.shared and replace(self.shared, keeper=keeper))

    def __call__(self, job: batch.Job, folder: Path) -> Path:
        with Path(self.log).open("a") as log:
            log.write(f"{job.text} {job.seed}\n")
        word = job.text.split()[0]
        if word == "bad":
            raise InputError(f"{job.text!r} cannot be read.")
        if word == "broken":
            raise RuntimeError("a fault")
        if word == "deadly":
            os._exit(9)
        if word == "half":
            (folder / "toy-half").mkdir(parents=True)
            until(Path(f"{self.log}.go").exists)
        if word == "paid" and self.shared is not None:
            with self.shared.spending() as spender:
                ask(session(account=Account(spender), budget=self.budget), self.url, job.text)
        if word == "wide":
            Path(f"{self.log}.threads").write_text(str(threads()))
        cube = toy_object("cube_1", (0.05, 0.05, 0.05), (0.01 * job.seed, 0.0))
        told = Provenance("text", job.seed, job.text)
        scene = toy_scene((cube,)).replace(provenance=told, report=Report(1e-4, 0.0, 0.0))
        return bundle.save(scene, folder)


def made(log: Path) -> list[str]:
    """Return the logged scenes in alphabetical order."""
    return sorted(log.read_text().splitlines()) if log.exists() else []


if __name__ == "__main__":
    batch.run(sys.argv[3:], sys.argv[1], ToyMaker(sys.argv[2]), workers=2)
