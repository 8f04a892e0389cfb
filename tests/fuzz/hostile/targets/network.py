"""Server responses: cloud chat and image models, modelers, and no server at all."""

import base64
import functools
import os
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from backends.cloud import desk
from backends.modelers.foreign import instance, prior

from generator.backends.cloud.imager import CloudImager
from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.modelers.hunyuan3d import Hunyuan3D
from generator.backends.modelers.tencent import Tencent
from generator.calls.http.retries import RetryPolicy
from generator.calls.session import Session
from generator.calls.store import CallStore
from generator.errors import BackendError
from generator.io.pictures import encode_png
from generator.scene import USUAL_VIEW, PlannedObject, PlannedTable, ScenePlan

from ..judging import accepts
from ..servers import Behaviour, Talk, encoded, hostile, serving, telling, whole
from ..streams import hostile_png, spoiled
from ..values import TEXTS, mutate, written
from . import Run
from .meshes import good_glb, hostile_glb

TIMEOUT = 0.3
"""Seconds that a call of these targets may take."""

_ADDRESSES = (
    "http://[::1", "https://a℀b/x", "http://a:99999/x", "http://a:x/", "file:///etc/passwd",
    "data:image/png;base64,!!!", "data:", "http://", "//x", "http://127.0.0.1:1/x", "\x00",
    "http://user:pw@127.0.0.1/x", "http://127.0.0.1:" + "9" * 5000, "http://xn--a/", "http://a b/",
    "http://[fe80::1%25eth0]/", "https://" + "a" * 70 + ".com/", "http://127.0.0.1:0x1/x",
)  # fmt: skip


def session(folder: Path, rng: random.Random) -> Session:
    """Return a session with short timeouts, sometimes with its own store."""
    store = CallStore(folder / "calls") if rng.random() < 0.3 else None
    policy = RetryPolicy(first=0.001, longest=0.002, obeyed=0.05, rest=0.05)
    return Session(store=store, attempts=rng.choice((1, 1, 2)), retry_policy=policy, grace=0.2)


def _named(url: str) -> None:
    """Set the addresses and keys that the backends read from the environment."""
    os.environ["TABLETOPGEN_CLOUD_BASE_URL"] = f"{url}/v1"
    os.environ["TABLETOPGEN_CLOUD_KEY"] = "sk-of-the-fuzzer"
    for name in ("CHAT", "IMAGE"):
        os.environ[f"TABLETOPGEN_CLOUD_{name}_MODEL"] = "m"
    os.environ["TENCENTCLOUD_SECRET_ID"], os.environ["TENCENTCLOUD_SECRET_KEY"] = "AKID", "secret"


def _asking(behaviour: Behaviour, ask: Callable[[str], Any]) -> Run:
    def run() -> bool:
        with serving(behaviour) as url:
            _named(url)
            return accepts(lambda: ask(url))

    return run


# ------------------------------------------------------------------------------------------- HTTP
def http(rng: random.Random, folder: Path) -> Run:
    """Server behaviours, for a session's client and a modeler."""
    shared = session(folder, rng)
    mesh = rng.random() < 0.3
    good = good_glb() if mesh else encoded({"choices": [], "usage": {"prompt_tokens": 5}})
    kind = "model/gltf-binary" if mesh else "application/json"
    behaviour = hostile(rng, good, kind)
    method = rng.choice(("POST", "GET"))

    def post(url: str) -> None:
        headers = {"x-tabletopgen-question": "plan_scene", "x-tabletopgen-model": "m"}
        with shared.client("cloud", url, timeout=TIMEOUT, most_bytes=2**22) as client:
            client.request(method, "/v1/x", json={"a": 1}, headers=headers)

    def model(url: str) -> None:
        made = Hunyuan3D(url, timeout=TIMEOUT, session=shared)
        made.model(instance("mug"), prior("mug"), USUAL_VIEW)

    return _asking(behaviour, model if mesh else post)


# ------------------------------------------------------------------------------------------ cloud
def _things(**fields: Any) -> list[dict[str, Any]]:
    return [{"id": k, **fields} for k in range(4)]


_ANSWERS: dict[str, Any] = {
    "plan_scene": {
        "table": {"outline": "rectangle", "material": "oak", "color": "brown", "legs": "straight",
                  "length_cm": 120, "width_cm": 70, "height_cm": 74},
        "style": "plain",
        "things": [
            {"id": 1, "noun": "mug", "color": "red", "material": None, "size_word": "small",
             "state": None, "size_cm": [8, 8, 9], "relations": [{"kind": "on", "target": 2}]},
            {"id": 2, "noun": "book", "color": None, "material": None, "size_word": None,
             "state": None, "size_cm": None, "relations": [{"kind": "center", "target": 0}]},
        ],
    },
    "list_objects": {"kinds": [{"noun": "table", "count": 1}, {"noun": "mug", "count": 2}]},
    "estimate_view": {"elevation": 50, "azimuth": 0, "vertical_fov": 40},
    "estimate_sizes": {"sizes": _things(
        placement="upright", length=10, width=8, height=9, length_is="x", width_is="y",
        height_is="z")},
    "stacking_order": {"things": _things(how="on", support=0, leans_at=None)},
    "guess_rotations": {"turns": _things(yaw=30)},
    "guess_layout": {"places": _things(x=1, y=2, length=10, width=8, height=9)},
    "review_orientation": {"up": "+z", "along": "+x"},
    "rate": {"marks": [{"criterion": c, "why": "so", "mark": 5} for c in ("VF", "IA")]},
}  # fmt: skip


def _asks(reasoner: CloudReasoner) -> dict[str, Callable[[], Any]]:
    """Return a call for each question about a painted desk."""
    picture, things = desk.reference(), desk.instances()
    return {
        "plan_scene": lambda: reasoner.plan_scene("a mug on a book", 0),
        "list_objects": lambda: reasoner.list_objects(picture),
        "estimate_view": lambda: reasoner.estimate_view(picture, things[0]),
        "estimate_sizes": lambda: reasoner.estimate_sizes(picture, things, desk.VIEW),
        "stacking_order": lambda: reasoner.stacking_order(picture, things, desk.VIEW),
        "guess_rotations": lambda: reasoner.guess_rotations(picture, things, desk.SIZES, desk.VIEW),
        "guess_layout": lambda: reasoner.guess_layout(picture, things, desk.SIZES, desk.VIEW),
        "rate": lambda: reasoner.rate(
            picture.image, (picture.image,), {"VF": "fidelity", "IA": "appeal"}
        ),
    }


def chat(rng: random.Random, folder: Path) -> Run:
    """Chat-model responses: the content, and the JSON around it."""
    question = rng.choice([q for q in _ANSWERS if q != "review_orientation"])
    said = _said(rng, _ANSWERS[question])
    told: Any = {
        "id": "chatcmpl-1", "object": "chat.completion", "model": "m",
        "choices": [{"index": 0, "finish_reason": "stop",
                     "message": {"role": "assistant", "content": said, "refusal": None}}],
        "usage": {"prompt_tokens": 100, "completion_tokens": 20},
    }  # fmt: skip
    content = encoded(told)
    if rng.random() < 0.4:
        content = written(mutate(told, rng, ("length", "content_filter", "stop"), raw=True), rng)
    if rng.random() < 0.05:
        content = spoiled(content, rng)
    status = rng.choice(("200 OK",) * 8 + ("400 x", "404 x", "422 x", "401 x"))
    kind = rng.choice(("application/json",) * 8 + ("text/plain", "application/json; charset=x"))
    shared = session(folder, rng)

    def ask(url: str) -> Any:
        return _asks(CloudReasoner(session=shared))[question]()

    return _asking(telling(content, status, kind), ask)


def _said(rng: random.Random, answer: Any) -> str:
    """Return a model's content: its answer mutated, wrapped, broken or endless."""
    kind = rng.randrange(8)
    if kind < 5:
        answer = mutate(answer, rng, ("on", "in", "+x", "table", "round"), raw=True)
    content = written(answer, rng).decode("utf-8", "replace")
    if kind == 5:
        size = rng.choice((100, 5000, 100_000, 1_000_000))
        return rng.choice((
            "{" * size, "[" * size, '{"a":' * size, "```json\n" * (size // 8), '"' * size,
            "<think>" * (size // 7), "{}" * size, "{'a':" * size, "{\"a\"" * size, "/*" * size,
            "{" + "'" * size, "\\" * size, "{" + "(" * size, "{" + "-" * size + "1}", "," * size,
            "{" + '"a" ' * size, " " * size, "{ " * size + "} " * size, "true" * size,
        ))  # fmt: skip
    if kind == 6:
        return rng.choice((
            f"```json\n{content}\n```", f"Sure! {content} Anything else?", content[:-3],
            f"<think>{content}</think>{content}", content.replace('"', "'"), content + content,
            f"I'm sorry. {rng.choice(TEXTS)}", content.replace(",", ",,"), f"// x\n{content}",
        ))  # fmt: skip
    return content


def images(rng: random.Random, folder: Path) -> Run:
    """Image-model responses: pictures in base64 and at addresses."""
    picture = encode_png(np.full((64, 64, 3), 200, np.uint8))
    drawn = hostile_png(rng, picture) if rng.random() < 0.5 else picture
    coded = base64.b64encode(drawn).decode()
    by_address = rng.random() < 0.5
    first: dict[str, Any] = {"b64_json": coded}
    if by_address:
        first = {"url": rng.choice((*_ADDRESSES, *[""] * 10))}
    told: Any = {"created": 1, "data": [first]}
    if rng.random() < 0.4:
        told = mutate(told, rng, _ADDRESSES, raw=True)
    content = written(told, rng)
    shared = session(folder, rng)

    def answer(talk: Talk) -> None:
        if talk.method == "GET":
            talk.send(whole(drawn, kind="image/png"))
            return
        place = f'"http://{talk.headers.get("host", "")}/x.png"'.encode()
        talk.send(whole(content.replace(b'"url": ""', b'"url": ' + place)))

    def draw(url: str) -> None:
        mug = PlannedObject("mug_1", "mug", "mug")
        CloudImager(session=shared).draw(ScenePlan("a mug", PlannedTable(), (mug,)), 0)

    return _asking(answer, draw)


# --------------------------------------------------------------------------------------- modelers
def hunyuan3d(rng: random.Random, folder: Path) -> Run:
    """Responses of a local mesh server, including its health check."""
    raw, kind, status = good_glb(), "application/octet-stream", "200 OK"
    if rng.random() < 0.4:
        raw = hostile_glb(rng)
    elif rng.random() < 0.9:
        told: Any = {"text": "**NETWORK ERROR**", "error_code": 1, "status": "healthy",
                     "worker_id": "w"}  # fmt: skip
        raw = written(mutate(told, rng, raw=True), rng)
        kind = rng.choice(("application/json", "application/json", "text/plain"))
        status = rng.choice(("404 x", "404 x", "422 x", "200 OK", "500 x"))
    shared = session(folder, rng)
    healthy = rng.random() < 0.3

    def ask(url: str) -> Any:
        made = Hunyuan3D(url, timeout=5.0, session=shared)
        return made.health() if healthy else made.model(instance("mug"), prior("mug"), USUAL_VIEW)

    return _asking(telling(raw, status, kind), ask)


def tencent(rng: random.Random, folder: Path) -> Run:
    """Responses of the cloud job service: submissions, states, results and downloads."""
    action = rng.choice(("Submit", "Query", "Query", "GET"))
    mesh = hostile_glb(rng) if action == "GET" else good_glb()
    seeds = random.Random(rng.random())
    shared = session(folder, rng)

    @functools.cache
    def content(asked: str, host: str) -> bytes:
        told: Any = {"Response": {"JobId": "job-1", "RequestId": "r"}}
        if asked == "Query":
            files = [{"Type": "OBJ", "Url": "x"}, {"Type": "GLB", "Url": f"http://{host}/x.glb"}]
            told = {"Response": {"Status": "DONE", "ErrorCode": "", "ErrorMessage": "",
                                 "ResultFile3Ds": files, "RequestId": "r"}}  # fmt: skip
        if asked != action:
            return encoded(told)
        extra = (*_ADDRESSES, "WAIT", "FAIL", "DONE", "RequestLimitExceeded", "NotFound")
        error = {"Code": seeds.choice(extra), "Message": seeds.choice(TEXTS)}
        if seeds.random() < 0.2:
            told["Response"]["Error"] = error
        return written(mutate(told, seeds, extra, raw=True), seeds)

    def answer(talk: Talk) -> None:
        if talk.method == "GET":
            talk.send(whole(mesh, kind="model/gltf-binary"))
            return
        asked = "Submit" if talk.headers.get("x-tc-action", "").startswith("Submit") else "Query"
        talk.send(whole(content(asked, talk.headers.get("host", ""))))

    def ask(url: str) -> Any:
        made = Tencent(endpoint=url, hosts=("127.0.0.1",), interval=0.01, timeout=0.2,
                       session=shared)  # fmt: skip
        return made.model(instance("mug"), prior("mug"), USUAL_VIEW)

    return _asking(answer, ask)


def addresses(rng: random.Random, folder: Path) -> Run:
    """Server addresses from users and environments."""
    address = rng.choice((*_ADDRESSES, *TEXTS, "http://127.0.0.1:1", "https://127.0.0.1:1/v1"))
    if rng.random() < 0.3:
        address = str(mutate("http://127.0.0.1:1/v1", rng))
    shared = session(folder, rng)

    def cloud() -> None:
        if isinstance(address, str) and "\x00" not in address:
            _named("http://127.0.0.1:1")
            try:
                os.environ["TABLETOPGEN_CLOUD_BASE_URL"] = address
            except (UnicodeEncodeError, ValueError) as error:  # environments cannot hold it
                raise BackendError("no address") from error
        CloudReasoner(session=shared).plan_scene("a mug", 0)

    def local() -> None:
        Hunyuan3D(address, timeout=TIMEOUT, session=shared).model(
            instance("mug"), prior("mug"), USUAL_VIEW
        )

    def service() -> None:
        Tencent(endpoint=address, timeout=TIMEOUT, interval=0.01, session=shared).model(
            instance("mug"), prior("mug"), USUAL_VIEW
        )

    _named("http://127.0.0.1:1")
    return lambda: accepts(cloud, local, service)
