"""Backends that send requests to a slow local server, for stages with parallel requests."""

import json
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler
from typing import Any

import numpy as np
from local_server import local_server

from generator.calls import Session
from generator.scene import Detection, Instance, Mesh, Model, Reference, SizePrior, View


class SlowServer:
    """A server's address, and its number of concurrent requests."""

    def __init__(self) -> None:
        self.url = ""
        self.peak = 0
        self._busy = 0
        self._lock = threading.Lock()

    @contextmanager
    def answering(self) -> Iterator[None]:
        with self._lock:
            self._busy += 1
            self.peak = max(self.peak, self._busy)
        try:
            yield
        finally:
            with self._lock:
                self._busy -= 1


@contextmanager
def slow_server(delay: float) -> Iterator[SlowServer]:
    """Echo every POST after ``delay`` seconds."""
    server = SlowServer()

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = self.rfile.read(int(self.headers["content-length"]))
            with server.answering():
                time.sleep(delay)
            self.send_response(200)
            self.send_header("content-type", "application/json")
            self.send_header("content-length", str(len(body)))
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *args: Any) -> None:
            pass

    with local_server(Handler) as url:
        server.url = url
        yield server


@dataclass(frozen=True)
class Asking:
    """An imager and a modeler that send a request before they respond."""

    url: str
    session: Session = field(default_factory=Session, repr=False, compare=False)

    def _ask(self, question: str, about: list[int]) -> None:
        with self.session.client("slow", self.url) as client:
            told = {"x-tabletopgen-question": question}
            assert client.post("/", json=about, headers=told).json() == json.loads(str(about))

    def draw(self, plan: Any, seed: int) -> Any:
        raise AssertionError

    def top_view(self, *known: Any) -> Any:
        raise AssertionError

    def complete(
        self, reference: Reference, detection: Detection, others: tuple[Detection, ...]
    ) -> Instance:
        self._ask("complete", detection.box.tolist())
        crop = np.full((8, 8, 4), len(others), np.uint8)
        return Instance(
            detection.label, detection.label, detection.box, detection.mask, crop, detection.box
        )

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        self._ask("model", instance.box.tolist())
        vertices = np.array([[-0.5, -0.5, -0.5], [0.5, -0.5, -0.5], [0, 0.5, -0.5], [0, 0, 0.5]])
        faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
        mesh = Mesh(vertices, faces, np.zeros((4, 2)), np.zeros((2, 2, 3)))
        return Model(instance.name, instance.label, mesh, np.asarray(size.extent))
