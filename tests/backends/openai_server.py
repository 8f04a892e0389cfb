"""A small server with OpenAI's protocol and Ark's variant of it, and their failures."""

import base64
import email.parser
import email.policy
import hashlib
import io
import json
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler
from typing import Any

import numpy as np
from local_server import Server, sent_to
from PIL import Image

from generator.io.pictures import encode_png

KEY = "sk-test-0123456789abcdef"
CHAT, IMAGES = "glimpse-1", "brush-1"
OPTIONS = {
    "openai": {"model", "prompt", "n", "size", "quality", "background", "input_fidelity"},
    "seedream": {"model", "prompt", "size", "image", "response_format", "watermark",
                 "sequential_image_generation"},
}  # fmt: skip


@dataclass
class Request:
    """A received request: path, headers, body (with decoded files), and time."""

    path: str
    headers: dict[str, str]
    body: dict[str, Any]
    came: float = 0.0

    @property
    def text(self) -> str:
        """The text of a chat's last message, or of a prompt."""
        if "prompt" in self.body:
            return self.body["prompt"]
        content = self.body["messages"][-1]["content"]
        return content if isinstance(content, str) else content[0]["text"]


@dataclass
class Script:
    """Behaviour of the server.

    ``urls``: pictures are answered as addresses, all as ``address`` if there is one. ``forms`` are
    the response formats it knows, ``bounds`` the limits of an answer; ``failures`` befall the next
    requests, one each. ``sent`` hears of each answer, once it is on its way. ``key`` is the only
    one it lets in.
    """

    chat: Callable[[Request], Any] = lambda request: "{}"
    paint: Callable[[Request], Any] = lambda request: np.zeros((64, 64, 3), np.uint8)
    forms: tuple[str, ...] = ("json_schema", "json_object")
    knows_seed: bool = True
    bounds: tuple[str, ...] = ("max_completion_tokens", "max_tokens")
    form: str = "openai"
    unknown: set[str] = field(default_factory=set)
    urls: bool = False
    address: str = ""
    failures: deque[str] = field(default_factory=deque)
    requests: list[Request] = field(default_factory=list)
    lost: set[str] = field(default_factory=set)
    hang: float = 3.0
    sent: Callable[[Request, bytes], None] = lambda request, answer: None
    key: str = KEY
    models: tuple[str, ...] = (CHAT, IMAGES)

    def asked(self, path: str) -> list[Request]:
        return [r for r in self.requests if r.path.endswith(path)]


class Fault(Exception):
    def __init__(self, status: int, message: str, code: str | None = None) -> None:
        self.status = status
        self.body = {"error": {"message": message, "type": "invalid_request_error", "code": code}}


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    script: Script
    files: dict[str, bytes]

    def log_message(self, *args: object) -> None:
        pass

    def do_GET(self) -> None:
        with_key = "authorization" in self.headers
        self.script.requests.append(Request(self.path, {**self.headers}, {"key": with_key}))
        data = self.files.get(self.path)
        if data is None or self.path in self.script.lost:
            self.send(404, b"<Error>expired</Error>", "application/xml")
        else:
            self.send(200, data, "image/png")

    def do_POST(self) -> None:
        came = time.monotonic()
        raw = sent_to(self)
        try:
            if self.headers.get("authorization") != f"Bearer {self.script.key}":
                sent = self.headers.get("authorization", "")
                raise Fault(401, f"Incorrect API key provided: {sent}", "invalid_api_key")
            request = Request(self.path, {**self.headers}, self.parsed(raw), came)
            self.script.requests.append(request)
            if self.script.failures and self.failed(self.script.failures.popleft()):
                return
            answer = json.dumps(self.answered(request)).encode()
            self.send(200, answer)
            self.script.sent(request, answer)
        except Fault as fault:
            self.send(fault.status, json.dumps(fault.body).encode())

    def send(self, status: int, data: bytes, kind: str = "application/json", **more: str) -> None:
        self.send_response(status)
        self.send_header("content-type", kind)
        self.send_header("content-length", str(len(data)))
        for name, value in more.items():
            self.send_header(name.replace("_", "-"), value)
        self.end_headers()
        self.wfile.write(data)

    def failed(self, mode: str) -> bool:
        body = json.dumps({"error": {"message": mode}}).encode()
        if mode == "429":
            self.send(429, body, retry_after="0")
        elif mode == "500":
            self.send(500, body)
        elif mode == "hang":
            time.sleep(self.script.hang)
            self.close_connection = True
        elif mode == "truncated":
            self.send_response(200)
            self.send_header("content-type", "application/json")
            self.send_header("content-length", "5000")
            self.end_headers()
            self.wfile.write(b'{"choices": [')
            self.close_connection = True
        elif mode == "wrong json":
            self.send(200, b'{"choices": [')
        elif mode == "empty":
            self.send(200, b"{}")
        elif mode == "error in 200":
            self.send(200, b'{"error": {"message": "upstream is busy", "code": 502}}')
        elif mode == "words":
            self.send(200, b"All is well.", "text/plain")
        elif mode == "list":
            self.send(200, b"[1, 2]")
        elif mode == "html":
            self.send(200, b"<!doctype html><html><body>Welcome</body></html>", "text/html")
        elif mode == "moderation":
            told = {"error": {"message": "Rejected by the safety system", "code": "moderation"}}
            self.send(400, json.dumps(told).encode())
        elif mode == "case":
            told = {"error": {"message": "Unknown options; names are case-insensitive"}}
            self.send(400, json.dumps(told).encode())
        else:
            raise AssertionError(mode)
        return True

    def parsed(self, raw: bytes) -> dict[str, Any]:
        kind = self.headers["content-type"]
        if kind.startswith("application/json"):
            return json.loads(raw)
        head = f"content-type: {kind}\r\n\r\n".encode()
        form = email.parser.BytesParser(policy=email.policy.HTTP).parsebytes(head + raw)
        body: dict[str, Any] = {"images": []}
        for part in form.iter_parts():
            name = part.get_param("name", header="content-disposition")
            content = part.get_payload(decode=True)
            if name in ("image", "image[]"):
                body["images"].append(pixels(content))
            elif name == "mask":
                body["mask"] = pixels(content)
            else:
                body[str(name)] = content.decode()
        return body

    def answered(self, request: Request) -> dict[str, Any]:
        model = request.body.get("model")
        if model not in self.script.models:
            raise Fault(404, f"The model `{model}` does not exist", "model_not_found")
        if request.path == "/v1/chat/completions":
            return self.chat(request)
        if request.path == "/v1/images/generations":
            return self.painted(request, OPTIONS[self.script.form])
        if request.path == "/v1/images/edits" and self.script.form == "openai":
            images, mask = request.body["images"], request.body.get("mask")
            if not images:
                raise Fault(400, "An image is required.")
            if mask is not None and (mask.shape != (*images[0].shape[:2], 4)):
                raise Fault(400, "mask must be RGBA and as large as the image")
            return self.painted(request, OPTIONS["openai"] | {"images", "mask"})
        raise Fault(404, f"Invalid URL (POST {request.path})")

    def chat(self, request: Request) -> dict[str, Any]:
        body, script = request.body, self.script
        if "seed" in body and not script.knows_seed:
            raise Fault(400, "Unsupported parameter: 'seed'")
        for name in ("max_completion_tokens", "max_tokens"):
            if name in body and name not in script.bounds:
                raise Fault(400, f"Unsupported parameter: '{name}'")
        form = body.get("response_format")
        if form is not None:
            if form["type"] not in script.forms:
                raise Fault(400, f"response_format type {form['type']} is not supported")
            if form["type"] == "json_schema":
                assert len(form["json_schema"]["name"]) <= 64
                check_strict(form["json_schema"]["schema"])
        for message in body["messages"]:
            for part in message["content"] if isinstance(message["content"], list) else ():
                if part["type"] == "image_url":
                    pixels(from_uri(part["image_url"]["url"]))
        said = script.chat(request)
        message = {"role": "assistant", "content": said, "refusal": None}
        end = "stop"
        if isinstance(said, dict):
            message, end = said["message"], said["finish_reason"]
        return {
            "id": f"chatcmpl-{hashlib.sha256(json.dumps(body).encode()).hexdigest()[:24]}",
            "object": "chat.completion",
            "choices": [{"index": 0, "message": message, "finish_reason": end}],
            "usage": {"prompt_tokens": 100, "completion_tokens": 20},
        }

    def painted(self, request: Request, known: set[str]) -> dict[str, Any]:
        for name in request.body:
            if name not in known or name in self.script.unknown:
                raise Fault(400, f"Unknown parameter: '{name}'.")
        given = request.body.get("image", [])
        for uri in [given] if isinstance(given, str) else given:
            request.body.setdefault("images", []).append(pixels(from_uri(uri)))
        drawn = self.script.paint(request)
        data = drawn if isinstance(drawn, bytes) else encode_png(drawn)
        if not self.script.urls:
            return {"created": 1, "data": [{"b64_json": base64.b64encode(data).decode()}]}
        path = self.script.address or f"/files/{len(self.script.requests)}.png"
        self.files[path] = data
        return {"created": 1, "data": [{"url": f"http://{self.headers['host']}{path}"}]}


def check_strict(schema: Any) -> None:
    if isinstance(schema, list):
        for part in schema:
            check_strict(part)
    elif isinstance(schema, dict):
        if schema.get("type") == "object":
            if schema.get("additionalProperties") is not False:
                raise Fault(400, "response_format: 'additionalProperties' must be false")
            if sorted(schema["required"]) != sorted(schema["properties"]):
                raise Fault(400, "response_format: 'required' must name every property")
        for part in schema.values():
            check_strict(part)


def from_uri(uri: str) -> bytes:
    head, _, data = uri.partition(",")
    assert head == "data:image/png;base64", head
    return base64.b64decode(data, validate=True)


def pixels(data: bytes) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(data)))


@dataclass
class Running:
    """A running server: its address and its script."""

    url: str
    script: Script
    http: Server

    def stop(self) -> None:
        self.http.shutdown()
        self.http.server_close()


def start() -> Running:
    script = Script()
    handler = type("Scripted", (Handler,), {"script": script, "files": {}})
    http = Server(("127.0.0.1", 0), handler)
    threading.Thread(target=http.serve_forever, args=(0.02,), daemon=True).start()
    return Running(f"http://127.0.0.1:{http.server_port}/v1", script, http)
