"""An importable scene maker that sends a request to a server for each scene."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from calls.paid_server import ask, session
from toy import toy_scene

from generator import bundle
from generator import jobs as batch
from generator.calls.store import CallStore
from generator.scene import Report


@dataclass(frozen=True)
class AskingMaker:
    """Requests a text from the server at ``url``, caches it in ``calls``, and makes a cube."""

    url: str
    calls: str

    def identity(self) -> dict[str, Any]:
        return {"route": "asking"}

    def __call__(self, job: batch.Job, folder: Path) -> Path:
        shared = session(store=CallStore(self.calls))
        ask(shared, self.url, job.text, timeout=60.0)
        ask(shared, self.url, f"more of {job.text}", timeout=60.0)
        return bundle.save(toy_scene().replace(report=Report(1e-4, 0.0, 0.0)), folder)
