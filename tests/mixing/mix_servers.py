"""The servers of the mix, who look at what they are asked and note each request.

One plays the chat model and the image model of ``cloud``, one Hunyuan3D. Their answers are those of
the laid table. ``Watch`` knows what was asked and answered when, and may kill who asks.
"""

from __future__ import annotations

import base64
import contextlib
import hashlib
import json
import re
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import laid_table
import numpy as np
from backends import openai_server
from backends.modelers.server import Answer, Call, serving
from backends.openai_server import CHAT, IMAGES, Request
from laid_table import BARE, THINGS, VIEW

from generator.scene import TABLE

KEY = "marker-key-71c0ffee5d"
"""The key that the servers ask for: of no shape that gives it away."""


@dataclass
class Asked:
    """One request: of what kind, about what, when it came (seconds), and how it was answered."""

    question: str
    key: str
    began: float
    ended: float | None = None
    answer: bytes = b""


@dataclass
class Watch:
    """All requests, in the order they came.

    ``came`` is called with each new request before it is answered, ``gone`` when its answer has
    been sent; ``delay`` is how long each answer takes (seconds).
    """

    delay: float = 0.0
    asked: list[Asked] = field(default_factory=list)
    came: Callable[[Asked], None] = lambda asked: None
    gone: Callable[[Asked], None] = lambda asked: None
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _open: dict[int, Asked] = field(default_factory=dict)

    def note(self, question: str, content: bytes) -> None:
        """Enter a request of the calling thread, which answers it."""
        made = Asked(question, hashlib.sha256(content).hexdigest(), time.monotonic())
        with self._lock:
            self.asked.append(made)
            self._open[threading.get_ident()] = made
        self.came(made)
        time.sleep(self.delay)

    def peak(self, question: str) -> int:
        """Return how many requests of a kind were under way at once, at most."""
        edges = [(e, step) for a in self.asked if a.question == question
                 for e, step in ((a.began, 1), (a.ended or time.monotonic(), -1))]  # fmt: skip
        return int(np.cumsum([step for _, step in sorted(edges)]).max(initial=0))

    def done(self, answer: bytes) -> None:
        """Enter the answer to the calling thread's request."""
        made = self._open.pop(threading.get_ident())
        made.ended, made.answer = time.monotonic(), answer
        self.gone(made)


@dataclass(frozen=True)
class Servers:
    """The addresses of both servers, and the watch over them."""

    cloud: str
    hunyuan3d: str
    watch: Watch

    def environment(self, models: Path, key: str = KEY) -> dict[str, str]:
        """Return the variables by which the mix finds servers and models."""
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
    """Run both servers."""
    pictures = {"draw": laid_table.drawn().image, "top_view": laid_table.from_above().image}
    cloud = openai_server.start()

    def chat(request: Request) -> str:
        name = request.body["response_format"]["json_schema"]["name"]
        question = "check_top_view" if name == "top_view" else name
        watch.note(question, json.dumps(request.body, sort_keys=True).encode())
        return json.dumps(_said(name, request))

    def paint(request: Request) -> np.ndarray:
        given = request.body.get("images", [])
        question = "draw" if not given else "complete" if "mask" in request.body else "top_view"
        content = b"".join(picture.tobytes() for picture in given)
        watch.note(question, request.text.encode() + content)
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


def _said(question: str, request: Request) -> dict[str, Any]:
    """Return the right answer to a question of the reasoner."""
    labels = listed(question_text(request))
    known = {number: {TABLE: BARE, **THINGS}[label] for number, label in labels.items()}
    if question == "plan_scene":
        sizes = [round(100 * side) for side in BARE.size]
        size = dict(zip(("length_cm", "width_cm", "height_cm"), sizes, strict=True))
        table = {
            "outline": "rectangle", "material": "oak", "color": None, "legs": "straight", **size
        }  # fmt: skip
        blank = dict.fromkeys(("color", "material", "size_word", "state"))
        things = [
            {"id": k, "noun": t.noun, "size_cm": [100 * side for side in t.size],
             "relations": [], **blank}
            for k, t in enumerate(THINGS.values(), start=1)
        ]  # fmt: skip
        return {"table": table, "style": "plain", "things": things}
    if question == "list_objects":
        return {"kinds": [{"noun": noun, "count": 1} for noun in THINGS]}
    if question == "estimate_view":
        elevation, fov = np.rad2deg([VIEW.elevation, VIEW.fov])
        return {"elevation": elevation, "azimuth": 0, "vertical_fov": fov}
    if question == "estimate_sizes":
        words = {"placement": "standing", "length_is": "l", "width_is": "w", "height_is": "h"}
        return {"sizes": [
            {"id": k, **words, "length": 100 * t.size[0], "width": 100 * t.size[1],
             "height": 100 * t.size[2]}
            for k, t in known.items()
        ]}  # fmt: skip
    if question == "review_orientation":
        return {"up": "+z", "along": "+x"}
    if question == "stacking_order":
        return {"things": [
            {"id": k, "how": "on", "support": 0, "leans_at": None} for k in known if k
        ]}  # fmt: skip
    assert question == "top_view", question
    boxes = laid_table.boxes_from_above()
    return {"from_above": True, "extra": [], "things": [
        {"id": k, "boxes": [boxes[t.noun]], "covered": False} for k, t in known.items()
    ]}  # fmt: skip


def listed(text: str) -> dict[int, str]:
    """Return the numbered lines of a prompt: number to label."""
    return {int(n): label for n, label in re.findall(r"^(\d+): ([^;\n]+)", text, re.MULTILINE)}


def question_text(request: Request) -> str:
    """Return the words of a chat's first message."""
    return request.body["messages"][0]["content"][0]["text"]
