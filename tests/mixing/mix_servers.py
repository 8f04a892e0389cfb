"""The servers of the mix, which inspect and record each request.

One plays the chat model and the image model of ``cloud``, one Hunyuan3D. Their answers are those of
the laid table. ``Watch`` knows what was asked and answered when, and may kill who asks.
"""

import base64
import contextlib
import hashlib
import json
import threading
import time
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import laid_table
import numpy as np
from backends import openai_server
from backends.cloud.desk import listed
from backends.modelers.server import Answer, Call, serving
from backends.openai_server import CHAT, IMAGES, Request
from laid_table import BARE, THINGS, VIEW, Thing

from generator.scene import TABLE

KEY = "marker-key-71c0ffee5d"
"""The key that the servers ask for: of no shape that gives it away."""


@dataclass
class Asked:
    """One request: its kind, its subject, its arrival (seconds), and the response."""

    question: str
    key: str
    began: float
    ended: float | None = None
    answer: bytes = b""


@dataclass
class Watch:
    """All requests in order of arrival.

    ``came`` is called with each new request before it is answered, ``gone`` when its answer has
    been sent; ``delay`` is how long an answer takes, from when its request came (seconds).
    """

    delay: float = 0.0
    asked: list[Asked] = field(default_factory=list)
    came: Callable[[Asked], None] = lambda asked: None
    gone: Callable[[Asked], None] = lambda asked: None
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _open: dict[int, Asked] = field(default_factory=dict)

    def note(self, question: str, content: bytes, began: float | None = None) -> None:
        """Record a request of the calling thread, which responds; it came now or at ``began``."""
        came = time.monotonic() if began is None else began
        made = Asked(question, hashlib.sha256(content).hexdigest(), came)
        with self._lock:
            self.asked.append(made)
            self._open[threading.get_ident()] = made
        self.came(made)
        time.sleep(max(0.0, made.began + self.delay - time.monotonic()))

    def peak(self, question: str) -> int:
        """Return the maximum number of concurrent requests of a kind."""
        edges = [(e, step) for a in self.asked if a.question == question
                 for e, step in ((a.began, 1), (a.ended or time.monotonic(), -1))]  # fmt: skip
        return int(np.cumsum([step for _, step in sorted(edges)]).max(initial=0))

    def done(self, answer: bytes) -> None:
        made = self._open.pop(threading.get_ident())
        made.ended, made.answer = time.monotonic(), answer
        self.gone(made)


@dataclass(frozen=True)
class Servers:
    """The addresses of both servers, and their request record."""

    cloud: str
    hunyuan3d: str
    watch: Watch

    def environment(self, models: Path, key: str = KEY) -> dict[str, str]:
        """Return the environment variables with which the mix finds servers and models."""
        return {
            "TABLETOPGEN_CLOUD_BASE_URL": self.cloud,
            "TABLETOPGEN_CLOUD_KEY": key,
            "TABLETOPGEN_CLOUD_CHAT_MODEL": CHAT,
            "TABLETOPGEN_CLOUD_IMAGE_MODEL": IMAGES,
            "TABLETOPGEN_HUNYUAN3D_URL": self.hunyuan3d,
            "TABLETOPGEN_MODELS": str(models),
        }


@contextlib.contextmanager
def running(watch: Watch) -> Iterator[Servers]:
    pictures = {"draw": laid_table.drawn().image, "top_view": laid_table.from_above().image}
    cloud = openai_server.start()

    def chat(request: Request) -> str:
        name = request.body["response_format"]["json_schema"]["name"]
        question = "check_top_view" if name == "top_view" else name
        watch.note(question, json.dumps(request.body, sort_keys=True).encode(), request.came)
        return json.dumps(_said(name, request))

    def paint(request: Request) -> np.ndarray:
        given = request.body.get("images", [])
        question = "draw" if not given else "complete" if "mask" in request.body else "top_view"
        content = b"".join(picture.tobytes() for picture in given)
        watch.note(question, request.text.encode() + content, request.came)
        return given[0] if question == "complete" else pictures[question]

    def model(call: Call) -> Answer:
        watch.note("model", call.body)
        shown = openai_server.pixels(base64.b64decode(call.json["image"]))
        return Answer(body=laid_table.shown_in(shown).glb)

    cloud.script.key = KEY
    cloud.script.chat, cloud.script.paint = chat, paint
    cloud.script.sent = lambda request, answer: watch.done(answer)
    try:
        with serving(model, lambda call, answer: watch.done(answer)) as hunyuan3d:
            yield Servers(cloud.url, hunyuan3d.url, watch)
    finally:
        cloud.stop()


def drain(before: Collection[threading.Thread]) -> None:
    """Wait until the servers have handled everything from disconnected clients.

    Not for threads of ``before``: connections of this process may be open for long.
    """
    time.sleep(0.1)  # not yet accepted
    while any(
        "process_request_thread" in thread.name and thread not in before
        for thread in threading.enumerate()
    ):
        time.sleep(0.02)


def _said(question: str, request: Request) -> dict[str, Any]:
    """Return the correct answer to a question for the reasoner."""
    labels = listed(request.body["messages"][0]["content"][0]["text"])
    known = {number: {TABLE: BARE, **THINGS}[label] for number, label in labels.items()}
    elevation, fov = np.rad2deg([VIEW.elevation, VIEW.fov])
    words = {"placement": "standing", "length_is": "l", "width_is": "w", "height_is": "h"}
    boxes = laid_table.boxes_from_above()
    answers: dict[str, Callable[[], dict[str, Any]]] = {
        "plan_scene": _plan,
        "list_objects": lambda: {"kinds": [{"noun": noun, "count": 1} for noun in THINGS]},
        "estimate_view": lambda: {"elevation": elevation, "azimuth": 0, "vertical_fov": fov},
        "estimate_sizes": lambda: {"sizes": [
            {"id": k, **words, **_sides(t, "")} for k, t in known.items()]},
        "review_orientation": lambda: {"up": "+z", "along": "+x"},
        "stacking_order": lambda: {"things": [
            {"id": k, "how": "on", "support": 0, "leans_at": None} for k in known if k]},
        "top_view": lambda: {"from_above": True, "extra": [], "things": [
            {"id": k, "boxes": [boxes[t.noun]], "covered": False} for k, t in known.items()]},
    }  # fmt: skip
    return answers[question]()


def _plan() -> dict[str, Any]:
    table = {"outline": "rectangle", "material": "oak", "color": None, "legs": "straight"}
    blank = dict.fromkeys(("color", "material", "size_word", "state"))
    things = [
        {"id": k, "noun": t.noun, "size_cm": [100 * s for s in t.size], "relations": [], **blank}
        for k, t in enumerate(THINGS.values(), start=1)
    ]
    return {"table": table | _sides(BARE, "_cm"), "style": "plain", "things": things}


def _sides(thing: Thing, unit: str) -> dict[str, float]:
    """Return length, width and height in centimetres."""
    names = (f"{side}{unit}" for side in ("length", "width", "height"))
    return {name: 100 * size for name, size in zip(names, thing.size, strict=True)}
