"""A local web page for teleoperation: it shows pictures and reads the keyboard and gamepad.

The server listens only on the loopback interface. A client needs the token in the page's address,
and its Origin header must be the page itself, so that no other site in the same browser can drive
the arm. One page at a time has control: the last one that connected. Messages have bounded size and
must be JSON with known keys; others are rejected with one line of text.
"""

from __future__ import annotations

import json
import secrets
import threading
from collections.abc import Sequence
from dataclasses import asdict
from http import HTTPStatus
from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qs, urlsplit

import numpy as np
from jaxtyping import UInt8

from generator.errors import BackendError, InputError

from .inputs import HumanInput, known_keys
from .session import TeleopStatus

if TYPE_CHECKING:
    from websockets.http11 import Request, Response
    from websockets.sync.server import Server, ServerConnection

HOST = "127.0.0.1"
"""Host of the page: this machine only."""

MOST_BYTES = 4096
"""Maximum size of an input message, in bytes."""

_PAGE = Path(__file__).with_name("page.html")
_QUALITY = 80  # quality of the JPEG pictures
_MAX_HELD, _MAX_BUTTONS = 16, 32


class TeleopPage:
    """A server of the page, which holds the latest input. Close it after use.

    Args:
        port: port of the server; 0 for any free port.

    Raises:
        BackendError: the package websockets is missing, or the port is taken.
    """

    def __init__(self, port: int = 0) -> None:
        try:
            from websockets.sync.server import serve
        except ImportError as error:
            raise BackendError(
                "Teleoperation through a page needs the package websockets: pip install "
                "'tabletopgen[teleop]'. --device window does not need it."
            ) from error
        self._token = secrets.token_urlsafe(16)
        self._lock = threading.Lock()
        self._given: HumanInput | None = None
        self._keys, self._buttons = frozenset[str](), frozenset[int]()  # input since the last read
        self._driver: ServerConnection | None = None
        try:
            self._server: Server = serve(
                self._listen, HOST, port, process_request=self._answer, max_size=MOST_BYTES,
            )  # fmt: skip
        except OSError as error:
            raise BackendError(
                f"Port {port} of {HOST} cannot be used ({error.strerror or error}). Choose "
                f"another port, or 0 for any free one."
            ) from error
        self.port: int = self._server.socket.getsockname()[1]
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()

    @property
    def address(self) -> str:
        """The URL of the page on this machine, including the token."""
        return f"http://{HOST}:{self.port}/?token={self._token}"

    def read(self) -> HumanInput | None:
        """Return the inputs active now or since the last call, or None while no page is open."""
        with self._lock:
            given, keys, buttons = self._given, self._keys, self._buttons
            self._keys, self._buttons = frozenset[str](), frozenset[int]()
        if given is None:
            return None
        return HumanInput(given.keys | keys, given.axes, given.buttons | buttons)

    def show(self, picture: UInt8[np.ndarray, "h w 3"], status: TeleopStatus) -> None:
        """Send a picture and the status of the episode to the page, if one is open."""
        import cv2
        from websockets.exceptions import ConnectionClosed

        with self._lock:
            driver = self._driver
        if driver is None:
            return
        bgr = np.ascontiguousarray(picture[..., ::-1])
        done, packed = cv2.imencode(".jpg", bgr, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
        if not done:
            return
        try:
            driver.send(json.dumps(asdict(status)))
            driver.send(packed.tobytes())
        except ConnectionClosed:
            self._leave(driver)

    def close(self) -> None:
        """Stop listening."""
        self._server.shutdown()
        self._thread.join(5)

    # ------------------------------------------------------------------------------------ serving

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """Answer a request: serve the page, accept its own connection, or reject the request."""
        own = {f"{HOST}:{self.port}", f"localhost:{self.port}"}
        asked = urlsplit(request.path)
        token = parse_qs(asked.query).get("token", [""])[0]
        if request.headers.get("Host") not in own or not secrets.compare_digest(
            token.encode(), self._token.encode()
        ):
            return connection.respond(
                HTTPStatus.FORBIDDEN, "Open the address printed in the terminal.\n"
            )
        if asked.path == "/drive":
            if request.headers.get("Origin") not in {f"http://{host}" for host in own}:
                return connection.respond(
                    HTTPStatus.FORBIDDEN, "Only the page itself may connect.\n"
                )
            return None
        if asked.path != "/":
            return connection.respond(HTTPStatus.NOT_FOUND, "This server has only the page /.\n")
        answer = connection.respond(HTTPStatus.OK, _PAGE.read_text(encoding="utf-8"))
        del answer.headers["Content-Type"]
        answer.headers["Content-Type"] = "text/html; charset=utf-8"
        answer.headers["Cache-Control"] = "no-store"
        answer.headers["Referrer-Policy"] = "no-referrer"
        return answer

    def _listen(self, connection: ServerConnection) -> None:
        """Read the input of a page until it disconnects or another page connects."""
        with self._lock:
            before, self._driver, self._given = self._driver, connection, HumanInput()
        if before is not None:
            before.close(reason="another page has taken control")
        try:
            for message in connection:
                try:
                    given = read_input(message)
                except InputError as error:
                    connection.send(json.dumps({"error": str(error)}))
                    continue
                with self._lock:
                    if self._driver is connection:
                        self._given = given
                        self._keys |= given.keys
                        self._buttons |= given.buttons
        finally:
            self._leave(connection)

    def _leave(self, connection: ServerConnection) -> None:
        with self._lock:
            if self._driver is connection:
                self._driver = self._given = None


def read_input(message: str | bytes) -> HumanInput:
    """Return the input in a page's message.

    Raises:
        InputError: the message is not of the form ``{"keys": [...], "axes": [...], "buttons":
            [...]}``, is too long, or has numbers out of range.
    """
    try:
        payload = json.loads(message)
        keys, axes, buttons = (_list_of(payload, name) for name in ("keys", "axes", "buttons"))
        if not all(isinstance(key, str) for key in keys):
            raise ValueError("the keys must be strings")
        if not all(type(b) is int and 0 <= b < _MAX_BUTTONS for b in buttons):
            raise ValueError("the buttons must be small integers")
        given = tuple(float(axis) if type(axis) in (int, float) else np.nan for axis in axes)
        if not all(-1.0 <= axis <= 1.0 for axis in given):
            raise ValueError("the axes must be in [-1, 1]")
    except (ValueError, TypeError, KeyError, RecursionError, OverflowError) as error:
        raise InputError(
            f"An input message must have the lists keys, axes and buttons: {error}."
        ) from error
    return HumanInput(known_keys(keys), given, frozenset(buttons))


def _list_of(payload: Any, name: str) -> Sequence[Any]:
    found = payload[name] if isinstance(payload, dict) and name in payload else None
    if not isinstance(found, list) or len(found) > _MAX_HELD:
        raise ValueError(f"{name} must be a list of at most {_MAX_HELD} items")
    return found
